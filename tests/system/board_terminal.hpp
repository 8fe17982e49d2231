// SPDX-License-Identifier: Apache-2.0
// What stands behind a serial port, as a pseudo-terminal: the Verilated ULX3S, or another device.
#pragma once

#include <Vboard_ulx3s.h>
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "board_bench.hpp"

namespace horopter::test {

/// A pseudo-terminal; `name` is what a program opens.
class Terminal {
 public:
  Terminal() {
    master_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    REQUIRE(master_ >= 0);
    REQUIRE(::grantpt(master_) == 0);
    REQUIRE(::unlockpt(master_) == 0);
    std::array<char, 256> text{};
    REQUIRE(::ptsname_r(master_, text.data(), text.size()) == 0);
    name_ = text.data();
    // As long as this end is open, the port stays when a program closes it.
    slave_ = ::open(name_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    REQUIRE(slave_ >= 0);
    termios settings{};
    ::tcgetattr(slave_, &settings);
    ::cfmakeraw(&settings);
    ::tcsetattr(slave_, TCSANOW, &settings);
  }
  ~Terminal() {
    unplug();
    ::close(slave_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::string engine() const { return "serial:" + name_ + "@3000000"; }
  /// From now on every program that has it open, or opens it, finds it gone.
  void unplug() {
    if (master_ >= 0) ::close(master_);
    master_ = -1;
  }
  /// As when an adapter is pulled out of the computer.
  void hang_up() const { ::ioctl(slave_, TIOCVHANGUP); }
  /// Of a program that was killed: a port of hardware does so by itself, when nobody has it open any more.
  void release() const { ::ioctl(slave_, TIOCNXCL); }
  std::vector<std::uint8_t> read() {
    std::array<std::uint8_t, 64> buffer{};
    const ssize_t length = ::read(master_, buffer.data(), buffer.size());
    return {buffer.begin(), buffer.begin() + std::max<ssize_t>(length, 0)};
  }
  void write(const std::vector<std::uint8_t>& bytes) {
    [[maybe_unused]] const auto written = ::write(master_, bytes.data(), bytes.size());
  }

 private:
  int master_ = -1;
  int slave_ = -1;
  std::string name_;
};

/// Something behind the terminal, in a thread of its own.
class Behind {
 public:
  /// `step` is called again and again.
  Behind(Terminal& terminal, std::function<void(Terminal&)> step)
      : thread_([this, &terminal, step = std::move(step)] {
          while (!stop_) step(terminal);
        }) {}
  ~Behind() {
    stop_ = true;
    thread_.join();
  }
  Behind(const Behind&) = delete;
  Behind& operator=(const Behind&) = delete;

 private:
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

/// The board, from its reset on. `at_byte`: what happens when so many bytes have come from the host since it was set.
class BoardBehind {
 public:
  enum class Event { none, reset, unplug, noise, pause };

  explicit BoardBehind(Terminal& terminal)
      : terminal_(&terminal), behind_(terminal, [this](Terminal&) { step(*terminal_.load()); }) {}
  /// Into another port. The one before may go when this has come back.
  void plug(Terminal& terminal) {
    terminal_ = &terminal;
    for (const std::size_t now = steps_; steps_ < now + 2;) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  /// It has taken what programs have left in the port; a line of hardware does not hold it.
  void drain() {
    for (idle_steps_ = 0; idle_steps_ < 5;) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  /// The noise ends.
  void quiet() {
    is_quiet_ = true;
    while (is_quiet_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  void at_byte(std::size_t count, Event event) {
    bytes_ = 0;
    event_ = event;
    event_at_ = count;
  }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  void step(Terminal& terminal) {
    ++steps_;
    if (!board_) board_ = std::make_unique<tb::Board<Vboard_ulx3s>>();
    if (is_quiet_) board_->to_board = board_->from_board = tb::clean;
    is_quiet_ = false;
    const bool paused = event_ == Event::pause && bytes_ >= event_at_;
    if (!board_->sending() && !paused) {
      const auto bytes = terminal.read();
      idle_steps_ = bytes.empty() ? idle_steps_ + 1 : 0;
      for (const std::uint8_t byte : bytes) {
        if (++bytes_ == event_at_) happen(terminal);
        board_->send(byte);
      }
    }
    board_->run(1000);
    auto& received = board_->received();
    if (received.empty()) return;
    terminal.write({received.begin(), received.end()});
    received.clear();
  }
  void happen(Terminal& terminal) {
    if (event_ == Event::reset) board_ = std::make_unique<tb::Board<Vboard_ulx3s>>();
    if (event_ == Event::unplug) terminal.unplug();
    if (event_ == Event::noise) {
      board_->to_board = [](std::uint8_t byte) { return std::vector{static_cast<std::uint8_t>(byte ^ 0x55U)}; };
      board_->from_board = board_->to_board;
    }
    if (event_ != Event::pause) event_ = Event::none;  // which lasts until another one is set
  }

  std::unique_ptr<tb::Board<Vboard_ulx3s>> board_;
  std::atomic<std::size_t> bytes_ = 0;
  std::atomic<std::size_t> event_at_ = 0;
  std::atomic<Event> event_ = Event::none;
  std::atomic<std::size_t> steps_ = 0;
  std::atomic<int> idle_steps_ = 0;
  std::atomic<bool> is_quiet_ = false;
  std::atomic<Terminal*> terminal_;
  Behind behind_;
};

}  // namespace horopter::test
