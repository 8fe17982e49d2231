// SPDX-License-Identifier: Apache-2.0
// A Horopter machine as software sees it: registers and stream endpoints, whatever is behind them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "horopter/image/image.hpp"

namespace horopter {

/// Codes of the state stream, the strongest has the largest.
enum class State : std::uint8_t { clear = 0, skin = 1, undecidable = 2, unsupervised = 3 };

/// Pixels start … end (included) of a row have one state.
struct Run {
  int row = 0;
  int start = 0;
  int end = 0;
  State state = State::unsupervised;
  friend bool operator==(const Run&, const Run&) = default;
};

/// One beat of m_axis_runs.
std::uint64_t encode_run(const Run& run);
Run decode_run(std::uint64_t beat);

/// What left the machine for one frame.
struct FrameStreams {
  Image states;  ///< codes of State
  std::vector<Run> runs;
};

class Device {
 public:
  virtual ~Device() = default;

  /// Addresses are bytes (see registers.hpp). Throw DeviceError when the machine refuses the access.
  virtual std::uint32_t read(std::uint32_t address) = 0;
  virtual void write(std::uint32_t address, std::uint32_t value) = 0;
  /// Many words to one register, one after the other, and many registers from one on: faster where each access waits for
  /// an answer.
  virtual void write_all(std::uint32_t address, std::span<const std::uint32_t> values);
  virtual std::vector<std::uint32_t> read_all(std::uint32_t address, std::size_t registers);

  /// False: it has cameras of its own, or nobody said where its streams are.
  virtual bool takes_pictures() const { return true; }
  /// Gives the cameras' inputs one frame (or field) each, of the size in WIDTH and HEIGHT. Does not wait for results.
  /// Throws UsageError where the machine takes no pictures.
  virtual void send(const Image& left, const Image& right) = 0;
  /// Waits for the next whole frame of states and runs. Throws DeviceError when none comes.
  virtual FrameStreams receive() = 0;

  /// `native`, `rtl`, …
  virtual std::string_view engine() const = 0;
  /// Whether the FRAME registers that count clocks mean something.
  virtual bool counts_cycles() const = 0;
};

}  // namespace horopter
