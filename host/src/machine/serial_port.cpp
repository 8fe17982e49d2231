// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/serial_port.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "horopter/base/error.hpp"

namespace horopter {
namespace {

constexpr std::array kRates = {115'200,   230'400,   460'800,   500'000,   576'000,   921'600,
                               1'000'000, 1'152'000, 1'500'000, 2'000'000, 2'500'000, 3'000'000};
constexpr std::array<speed_t, kRates.size()> kSpeeds = {B115200,  B230400,  B460800,  B500000,  B576000,  B921600,
                                                        B1000000, B1152000, B1500000, B2000000, B2500000, B3000000};
constexpr int kWriteTimeout_ms = 10'000;

}  // namespace

std::span<const int> SerialPort::rates() { return kRates; }

void SerialPort::fail(const std::string& what) const { throw DeviceError(fmt::format("{}: {}", path_, what)); }

SerialPort::SerialPort(const std::filesystem::path& path, int baud) : path_(path.string()), baud_(baud) {
  if (std::ranges::find(kRates, baud) == kRates.end()) {
    throw UsageError(fmt::format("{} baud; expected one of: {}", baud, fmt::join(kRates, ", ")));
  }
  file_ = ::open(path_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file_ < 0) {
    const int error = errno;
    if (error == ENOENT) fail("there is no such port; expected one as /dev/ttyUSB0: is the board plugged in?");
    if (error == EACCES) {
      fail("this user may not open it; expected permission: become a member of its group (see ls -l), often dialout");
    }
    if (error == EBUSY) fail("another program has it open; expected a free port: close that program");
    fail(fmt::format("cannot be opened ({})", std::strerror(error)));
  }
  try {
    configure();
  } catch (...) {
    ::close(file_);
    throw;
  }
}

void SerialPort::configure() {
  if (::isatty(file_) == 0) fail("is no serial port; expected one as /dev/ttyUSB0");
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    fail("another program has it open; expected a free port: close that program");
  }
  ::ioctl(file_, TIOCEXCL);  // for programs that do not ask for locks
  termios settings{};
  if (::tcgetattr(file_, &settings) != 0) fail(fmt::format("tells no settings ({})", std::strerror(errno)));
  ::cfmakeraw(&settings);
  settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS | PARENB);
  settings.c_cflag |= CLOCAL | CREAD | CS8;
  settings.c_cc[VMIN] = 0;
  settings.c_cc[VTIME] = 0;
  const speed_t speed = kSpeeds.at(static_cast<std::size_t>(std::ranges::find(kRates, baud_) - kRates.begin()));
  ::cfsetispeed(&settings, speed);
  ::cfsetospeed(&settings, speed);
  termios set{};
  if (::tcsetattr(file_, TCSANOW, &settings) != 0 || ::tcgetattr(file_, &set) != 0 || ::cfgetospeed(&set) != speed) {
    fail(fmt::format("does not take {} baud; expected a port that does, or --engine serial:{}@BAUD", baud_, path_));
  }
  ::tcflush(file_, TCIOFLUSH);
}

SerialPort::~SerialPort() {
  ::ioctl(file_, TIOCNXCL);
  ::close(file_);
}

BytePort::Time SerialPort::now() {
  return std::chrono::duration_cast<Time>(std::chrono::steady_clock::now().time_since_epoch());
}

BytePort::Time SerialPort::time_of(std::size_t bytes) const {
  return Time(bytes * 10 * 1'000'000 / static_cast<std::size_t>(baud_));
}

void SerialPort::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
      continue;
    }
    if (written < 0 && errno != EAGAIN && errno != EINTR) {
      fail(fmt::format("the port has gone ({}); expected it to stay: is the cable in?", std::strerror(errno)));
    }
    pollfd poll{file_, POLLOUT, 0};
    const int ready = ::poll(&poll, 1, kWriteTimeout_ms);
    if (ready == 0) {
      fail(
          "the board has stopped answering, and its port takes no more bytes; expected it to: look at cable and power");
    }
    if (ready > 0 && (poll.revents & (POLLERR | POLLHUP | POLLNVAL)) != 0) {
      fail("the port has gone; expected it to stay: is the cable in?");
    }
  }
}

std::size_t SerialPort::read(std::span<std::uint8_t> bytes, Time end) {
  bool hung_up = false;  // what had come before is read all the same
  while (true) {
    const ssize_t length = ::read(file_, bytes.data(), bytes.size());
    if (length > 0) return static_cast<std::size_t>(length);
    if (length < 0 && errno != EAGAIN && errno != EINTR) {
      fail(fmt::format("the port has gone ({}); expected it to stay: is the cable in?", std::strerror(errno)));
    }
    if (hung_up) fail("the port has gone; expected it to stay: is the cable in?");
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - now()).count();
    if (left <= 0) return 0;
    pollfd poll{file_, POLLIN, 0};
    const int ready = ::poll(&poll, 1, static_cast<int>(left) + 1);
    hung_up = ready > 0 && (poll.revents & (POLLERR | POLLHUP | POLLNVAL)) != 0;
  }
}

}  // namespace horopter
