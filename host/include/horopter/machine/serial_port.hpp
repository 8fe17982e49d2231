// SPDX-License-Identifier: Apache-2.0
// A serial port under Linux, of this program alone while it is open.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "horopter/machine/serial_link.hpp"

namespace horopter {

class SerialPort : public BytePort {
 public:
  /// Baud rates that can be had, slowest first.
  static std::span<const int> rates();

  /// Throws DeviceError when there is no such port, it is in use or not allowed; UsageError for another rate.
  SerialPort(const std::filesystem::path& path, int baud);
  ~SerialPort() override;
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  void write(std::span<const std::uint8_t> bytes) override;
  std::size_t read(std::span<std::uint8_t> bytes, Time end) override;
  Time now() override;
  [[nodiscard]] Time time_of(std::size_t bytes) const override;
  [[nodiscard]] Time latency() const override { return std::chrono::milliseconds(500); }

 private:
  [[noreturn]] void fail(const std::string& what) const;
  void configure();

  std::string path_;
  int baud_;
  int file_ = -1;
};

}  // namespace horopter
