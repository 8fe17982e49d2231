// SPDX-License-Identifier: Apache-2.0
// The ULX3S without cameras (constraints/ulx3s): it boots, its serial line reads, writes and uploads, the test pattern
// alarms, and does not with the button held.
#include <Vboard_ulx3s.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "horopter/base/crc32.hpp"
#include "horopter/hls/table_format.hpp"
#include "horopter/machine/registers.hpp"

namespace {

using horopter::crc32_words;
namespace reg = horopter::registers;

constexpr unsigned kClocksPerBit = 25;
constexpr unsigned kGapClocks = 1'000'000;
constexpr unsigned kFrameClocks = (756 + 64) * 286;

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

  void run(unsigned clocks) {
    for (unsigned i = 0; i < clocks; ++i) {
      model_.clk_25mhz = 0;
      model_.eval();
      model_.clk_25mhz = 1;
      model_.eval();
    }
  }
  [[nodiscard]] bool led(int i) const { return (model_.led >> i & 1) != 0; }
  void press(bool held) { model_.btn = held ? 1 : 0; }

  void send(unsigned byte, bool stop = true) {
    const auto bit = [&](bool value) {
      model_.ftdi_txd = value ? 1 : 0;
      run(kClocksPerBit);
    };
    bit(false);
    for (int i = 0; i < 8; ++i) bit((byte >> i & 1) != 0);
    // The answer may begin right after the middle of the stop bit.
    model_.ftdi_txd = stop ? 1 : 0;
    run(kClocksPerBit / 2 + 4);
    model_.ftdi_txd = 1;
  }
  /// Nothing if no byte begins within `wait` clocks.
  std::optional<unsigned> receive(unsigned wait = 2'000) {
    for (unsigned i = 0; model_.ftdi_rxd != 0; ++i) {
      if (i == wait) return std::nullopt;
      run(1);
    }
    run(kClocksPerBit / 2);
    unsigned byte = 0;
    for (unsigned i = 0; i < 8; ++i) {
      run(kClocksPerBit);
      byte |= static_cast<unsigned>(model_.ftdi_rxd) << i;
    }
    run(kClocksPerBit);
    REQUIRE(model_.ftdi_rxd == 1);  // stop bit
    return byte;
  }
  std::optional<unsigned> write(std::uint32_t address, std::uint32_t data) {
    send('W');
    send(address & 0xFF);
    send(address >> 8);
    for (int i = 0; i < 4; ++i) send(data >> (8 * i) & 0xFF);
    return receive();
  }
  struct Answer {
    unsigned status = 0xFFFF;
    std::uint32_t data = 0;
  };
  Answer read(std::uint32_t address) {
    send('R');
    send(address & 0xFF);
    send(address >> 8);
    Answer answer;
    answer.status = receive().value_or(0xFFFF);
    for (int i = 0; i < 4; ++i) answer.data |= receive().value_or(0) << (8 * i);
    return answer;
  }

 private:
  VerilatedContext context_;
  Vboard_ulx3s model_{&context_};
};

}  // namespace

TEST_CASE("board: boot, registers over the serial line, test pattern", "[board]") {
  Board board;
  board.run(20'000);
  REQUIRE(board.led(5));        // boot is done
  REQUIRE_FALSE(board.led(6));  // and nothing was refused
  REQUIRE_FALSE(board.led(0));  // no frame yet: not safe
  REQUIRE(board.led(1));

  const auto size = board.read(reg::build_size::kAddress);
  CHECK(size.status == 0);
  CHECK(size.data == (286U << 16 | 756U));
  CHECK(board.write(reg::sum_limit::kAddress, 321) == 0U);
  CHECK(board.read(reg::sum_limit::kAddress).data == 321);
  CHECK(board.write(reg::sum_limit::kAddress, 303) == 0U);

  // What must be refused, and that the line works after it.
  CHECK(board.write(reg::width::kAddress, 100).value_or(0) == 2U);  // locked while the machine runs
  CHECK(board.write(0x1000 + reg::sum_limit::kAddress, 5).value_or(0) == 3U);
  CHECK(board.read(0x1000).status == 3);
  CHECK(board.read(reg::sum_limit::kAddress).data == 303);
  board.send('X');
  CHECK(board.receive() == 0xFFU);
  board.send('W', false);
  CHECK(board.receive() == 0xFFU);
  CHECK(board.read(reg::id::kAddress).data == 0x484F524F);

  // A mapping table: spacing 64, one source for all pixels.
  auto words = horopter::hls::table::write({756, 286, 6, 6}, {},
                                           [](int, int) { return horopter::hls::table::encode_control(32, 32); });
  words.back() = crc32_words(std::span(words).first(words.size() - 1));
  CHECK(board.write(reg::map_slot::kAddress, 1) == 0U);
  CHECK(board.write(reg::map_base::kAddress, 1000) == 0U);
  CHECK(board.write(reg::map_control::kAddress, 1) == 0U);
  for (const std::uint32_t word : words) REQUIRE(board.write(reg::map_data::kAddress, word) == 0U);
  CHECK(board.read(reg::map_valid::kAddress).data == 0b11);
  CHECK(board.read(reg::map_crc::kAddress).data == words.back());

  // A command that is never finished is forgotten, without an answer. Meanwhile frames: all of the pattern is in the
  // skin.
  board.send('W');
  board.send(0x80);
  CHECK_FALSE(board.receive(kGapClocks + 100).has_value());
  CHECK(board.read(reg::frame_sequence::kAddress).data >= 3);
  const auto status = board.read(reg::frame_status::kAddress);
  CHECK(reg::frame_status::kAlarm.get(status.data) == 1);
  CHECK(reg::frame_status::kSlot.get(status.data) == 0);
  CHECK(board.read(reg::frame_faults_cameras::kAddress).data == 0);
  CHECK(board.read(reg::frame_faults_machine::kAddress).data == 0);
  CHECK(board.led(3));
  CHECK_FALSE(board.led(0));
  CHECK(board.led(1));

  board.press(true);
  board.run(4 * kFrameClocks);
  CHECK(board.read(reg::frame_faults_cameras::kAddress).data == 0);
  CHECK(board.read(reg::frame_faults_machine::kAddress).data == 0);
  CHECK(reg::frame_status::kAlarm.get(board.read(reg::frame_status::kAddress).data) == 0);
  CHECK(board.led(0));
  CHECK_FALSE(board.led(1));
}
