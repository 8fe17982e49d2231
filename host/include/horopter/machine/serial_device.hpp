// SPDX-License-Identifier: Apache-2.0
// A board on a serial line (docs/boards.md): its registers, and where the board keeps them the runs of a frame. It has
// cameras of its own, or a test pattern: it takes no pictures.
#pragma once

#include <memory>
#include <string>

#include "horopter/machine/device.hpp"
#include "horopter/machine/serial_link.hpp"

namespace horopter {

class SerialDevice : public Device {
 public:
  /// Throws DeviceError when no Horopter board answers. `name`: of the port, for messages.
  SerialDevice(std::unique_ptr<BytePort> port, std::string name) : link_(std::move(port), std::move(name)) {}

  std::uint32_t read(std::uint32_t address) override;
  void write(std::uint32_t address, std::uint32_t value) override;
  void write_all(std::uint32_t address, std::span<const std::uint32_t> values) override;
  std::vector<std::uint32_t> read_all(std::uint32_t address, std::size_t registers) override;
  bool takes_pictures() const override { return false; }
  void send(const Image& left, const Image& right) override;
  /// One frame of those that the board makes, whichever comes next: it keeps the runs, the states follow from them.
  FrameStreams receive() override;
  std::string_view engine() const override { return "serial"; }
  bool counts_cycles() const override { return true; }

  SerialLink& link() { return link_; }

 private:
  SerialLink link_;
};

}  // namespace horopter
