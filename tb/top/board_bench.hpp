// SPDX-License-Identifier: Apache-2.0
// A Verilated board with its serial line, in simulated time as a BytePort.
#pragma once

#include <verilated.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "horopter/machine/serial_link.hpp"

namespace horopter::tb {

constexpr int kBoardClock_hz = 25'000'000;
constexpr int kBoardBaud = 3'000'000;
constexpr unsigned kFrameClocks = (756 + 64) * 286;

/// What comes out of a line for a byte that goes into it.
using Channel = std::function<std::vector<std::uint8_t>(std::uint8_t)>;
inline std::vector<std::uint8_t> clean(std::uint8_t byte) { return {byte}; }

/// Bytes to the board go through `to_board`, one by one, bytes from it through `from_board`: what they give comes.
template <class Model>
class Board {
 public:
  Board() {
    model_.ftdi_txd = 1;
    model_.btn = 0;
  }
  ~Board() {
    Verilated::threadContextp(&context_);
    model_.final();
  }
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;

  void run(std::uint64_t clocks) {
    for (std::uint64_t i = 0; i < clocks; ++i) clock();
  }
  [[nodiscard]] std::uint64_t clocks() const { return clocks_; }
  /// Nothing has been on the line for longer than the board needs to answer, or to begin a frame.
  [[nodiscard]] bool idle() const { return !sending() && clocks_ > active_ + kAnswerClocks; }
  /// Time goes on, but the board does not.
  void skip(std::uint64_t clocks) { clocks_ += clocks; }
  [[nodiscard]] bool led(int i) const { return (model_.led >> i & 1) != 0; }
  void press(bool held) { model_.btn = held ? 1 : 0; }
  /// The restart button, beside the other one, which is held.
  void press_restart(bool held) { model_.btn = held ? 3 : 1; }

  void send(std::uint8_t byte) {
    for (const std::uint8_t changed : to_board(byte)) outgoing_.push_back(changed);
  }
  std::deque<std::uint8_t>& received() { return incoming_; }
  [[nodiscard]] bool sending() const { return !outgoing_.empty() || to_left_ != 0; }

  Channel to_board = clean;
  Channel from_board = clean;

 private:
  static constexpr std::uint64_t kAnswerClocks = 10'000;

  void clock() {
    drive();
    model_.clk_25mhz = 0;
    model_.eval();
    model_.clk_25mhz = 1;
    model_.eval();
    sample();
    ++clocks_;
    if (to_left_ != 0 || from_left_ != 0) active_ = clocks_;
  }
  /// The board's input, bit by bit.
  void drive() {
    if (to_left_ == 0) {
      if (outgoing_.empty()) return;
      to_bits_ = 1U << 9 | static_cast<unsigned>(outgoing_.front()) << 1;
      outgoing_.pop_front();
      to_left_ = 10;
      to_phase_ = 0;
      model_.ftdi_txd = 0;
    }
    model_.ftdi_txd = static_cast<std::uint8_t>(to_bits_ & 1U);
    to_phase_ += kBoardBaud;
    if (to_phase_ < kBoardClock_hz) return;
    to_phase_ -= kBoardClock_hz;
    to_bits_ >>= 1;
    --to_left_;
  }
  /// The board's output: the middle of each bit.
  void sample() {
    if (from_left_ == 0) {
      if (model_.ftdi_rxd != 0) return;
      from_left_ = 10;
      from_phase_ = kBoardClock_hz / 2;
      from_bits_ = 0;
    }
    from_phase_ += kBoardBaud;
    if (from_phase_ < kBoardClock_hz) return;
    from_phase_ -= kBoardClock_hz;
    from_bits_ = from_bits_ >> 1 | static_cast<unsigned>(model_.ftdi_rxd) << 9;
    if (--from_left_ != 0) return;
    for (const std::uint8_t changed : from_board(static_cast<std::uint8_t>(from_bits_ >> 1)))
      incoming_.push_back(changed);
  }

  VerilatedContext context_;
  Model model_{&context_};
  std::uint64_t clocks_ = 0;
  std::uint64_t active_ = 0;  ///< the last clock with something on the line
  std::deque<std::uint8_t> outgoing_;
  std::deque<std::uint8_t> incoming_;
  unsigned to_bits_ = 0;
  unsigned from_bits_ = 0;
  int to_left_ = 0;
  int from_left_ = 0;
  int to_phase_ = 0;
  int from_phase_ = 0;
};

/// The board's line in simulated time. `skips`: while there is nothing on the line that the board could answer to, it is
/// not simulated.
template <class Model>
class BoardPort : public BytePort {
 public:
  explicit BoardPort(Board<Model>& board, bool skips = false) : board_(board), skips_(skips) {}
  void write(std::span<const std::uint8_t> bytes) override {
    for (const std::uint8_t byte : bytes) board_.send(byte);
  }
  std::size_t read(std::span<std::uint8_t> bytes, Time end) override {
    constexpr unsigned kStep = 20;
    while (board_.received().empty()) {
      if (now() >= end) return 0;
      if (skips_ && board_.idle())
        board_.skip(kStep);
      else
        board_.run(kStep);
    }
    std::size_t count = 0;
    for (; count < bytes.size() && !board_.received().empty(); ++count) {
      bytes[count] = board_.received().front();
      board_.received().pop_front();
    }
    return count;
  }
  Time now() override { return Time(board_.clocks() / (kBoardClock_hz / 1'000'000)); }
  [[nodiscard]] Time time_of(std::size_t bytes) const override { return Time(bytes * 10'000'000 / kBoardBaud); }
  [[nodiscard]] Time latency() const override { return std::chrono::milliseconds(1); }

 private:
  Board<Model>& board_;
  bool skips_;
};

}  // namespace horopter::tb
