// SPDX-License-Identifier: Apache-2.0
// A machine in an FPGA under Linux: registers mapped through UIO (or any file that can be mapped), streams through the
// character devices of a DMA driver (or FIFOs).
//
// Streams carry bytes only. Pixels go and come row by row without marks: the driver knows the size of a frame, and the
// runs of a frame end with its last pixel. A run is 8 bytes, least significant first.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <vector>

#include "horopter/machine/device.hpp"

namespace horopter {

class UioDevice : public Device {
 public:
  struct Paths {
    std::filesystem::path registers;  ///< /dev/uio0
    std::filesystem::path left;    ///< written; without it there are no streams, send() and receive() throw UsageError
    std::filesystem::path right;   ///< written
    std::filesystem::path states;  ///< read
    std::filesystem::path runs;    ///< read
    std::uint64_t register_offset =
        0;  ///< in the mapping; a multiple of the page size (UIO: page size times map number)
  };

  /// Throws DeviceError when something cannot be opened or mapped, or is used by another program.
  explicit UioDevice(const Paths& paths, std::chrono::milliseconds timeout = std::chrono::seconds(2));
  ~UioDevice() override;
  UioDevice(const UioDevice&) = delete;
  UioDevice& operator=(const UioDevice&) = delete;

  std::uint32_t read(std::uint32_t address) override;
  void write(std::uint32_t address, std::uint32_t value) override;
  bool takes_pictures() const override { return files_[kLeft] >= 0; }
  void send(const Image& left, const Image& right) override;
  FrameStreams receive() override;
  std::string_view engine() const override { return "uio"; }
  bool counts_cycles() const override { return true; }

 private:
  static constexpr std::size_t kRegisterBytes = 4096;
  enum Stream : std::size_t { kLeft, kRight, kStates, kRuns, kStreams };

  /// Moves bytes in all directions at once, as none of the streams may wait for another. False: nothing moved in time.
  bool pump(std::size_t states_wanted, bool runs_wanted);
  /// What is on the way, also of a program before this one. A machine that is stopped drops its frame.
  void discard();
  void close_all();
  void check_streams() const;

  std::array<int, kStreams> files_{-1, -1, -1, -1};
  int registers_file_ = -1;  ///< locked: a machine has one master
  volatile std::uint32_t* registers_ = nullptr;
  std::chrono::milliseconds timeout_;
  std::array<std::deque<std::uint8_t>, 2> outgoing_;
  std::array<std::deque<std::uint8_t>, 2> incoming_;  ///< states, runs
};

}  // namespace horopter
