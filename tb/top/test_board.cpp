// SPDX-License-Identifier: Apache-2.0
// The ULX3S without cameras (constraints/ulx3s): it boots, the host's driver reads, writes and uploads over its serial
// line, whatever happens to bytes on the line; the test pattern alarms, and does not with the button held.
#include <Vboard_line.h>
#include <Vboard_ulx3s.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "board_bench.hpp"
#include "horopter/base/error.hpp"
#include "horopter/machine/configuration.hpp"
#include "horopter/machine/inspection.hpp"
#include "horopter/machine/registers.hpp"
#include "horopter/machine/serial_device.hpp"
#include "horopter/map/table_facts.hpp"

namespace horopter::tb {
namespace {

namespace reg = registers;

/// A mapping table of one displacement.
MapTable displaced(int x_px, ScanGeometry geometry = {756, 286, Scan::even_field}, int nx = 6, int ny = 6) {
  MapTable table(geometry, nx, ny);
  for (int row = 0; row < table.rows(); ++row) {
    for (int column = 0; column < table.columns(); ++column) {
      const Point source{static_cast<double>((column << nx) + x_px), static_cast<double>(row << ny)};
      table.set_control(column, row, MapTable::encode(source));
    }
  }
  table.seal(facts_of(table, find_profile("field")));
  return table;
}

std::uint32_t active_crc(SerialDevice& device) {
  const auto active = reg::map_status::kActiveSlot.get(device.read(reg::map_status::kAddress));
  device.write(reg::map_slot::kAddress, active);
  return device.read(reg::map_crc::kAddress);
}

}  // namespace

TEST_CASE("board: boot, registers over the serial line, test pattern", "[board]") {
  Board<Vboard_ulx3s> board;
  board.run(20'000);
  REQUIRE(board.led(5));        // boot is done
  REQUIRE_FALSE(board.led(6));  // and nothing was refused
  REQUIRE_FALSE(board.led(0));  // no frame yet: not safe
  REQUIRE(board.led(1));

  SerialDevice device(std::make_unique<BoardPort<Vboard_ulx3s>>(board), "board");
  CHECK(device.read(reg::build_size::kAddress) == (286U << 16 | 756U));
  CHECK(find_build(device).profile->name == "field");
  device.write(reg::sum_limit::kAddress, 321);
  CHECK(device.read(reg::sum_limit::kAddress) == 321);
  device.write(reg::sum_limit::kAddress, 303);

  // What must be refused, and that the line works after it.
  CHECK_THROWS_WITH(device.write(reg::width::kAddress, 100), Catch::Contains("refuses to write register 004c"));
  CHECK_THROWS_WITH(device.write(0x1080, 5), Catch::Contains("no such address"));
  CHECK_THROWS_WITH(device.read(0x1000), Catch::Contains("no such address"));
  CHECK_THROWS_WITH(device.read_all(reg::version::kAddress, 10), Catch::Contains("refuses to read register 001c"));
  CHECK(device.read(reg::sum_limit::kAddress) == 303);

  board.run(3 * kFrameClocks);
  const MachineStatus status = read_status(device);
  CHECK(status.active_slot() == 0);
  CHECK(reg::frame_status::kAlarm.get(status.word(reg::frame_status::kAddress)) == 1);
  CHECK_FALSE(status.frame_faults().any());
  CHECK_FALSE(status.safe());
  CHECK(board.led(3));
  CHECK_FALSE(board.led(0));

  board.press(true);
  board.run(4 * kFrameClocks);
  CHECK_FALSE(read_status(device).frame_faults().any());
  CHECK_FALSE(read_status(device).safe());  // until somebody restarts it
  CHECK_FALSE(board.led(0));
  board.press_restart(true);
  board.run(2 * kFrameClocks);
  board.press_restart(false);
  board.run(2 * kFrameClocks);
  CHECK(read_status(device).safe());
  CHECK(board.led(0));
  CHECK_FALSE(board.led(1));
}

TEST_CASE("board: a table takes close to the line's time", "[board]") {
  Board<Vboard_ulx3s> board;
  board.run(20'000);
  SerialDevice device(std::make_unique<BoardPort<Vboard_ulx3s>>(board), "board");
  const MapTable table = displaced(3, {252, 254, Scan::even_field}, 2, 1);
  REQUIRE(table.pool_bytes() == 32 * 1024);
  const auto before = board.clocks();
  REQUIRE(upload_table(device, 1, 100, table, 0) == 0);
  const auto bytes = 4.0 * static_cast<double>(table.words().size());
  const double line_s = bytes * 10 / kBoardBaud;
  const double taken_s = static_cast<double>(board.clocks() - before) / kBoardClock_hz;
  std::printf("board: a table of %.1f KiB at %.1f Mbaud in %.1f ms, %.3f times what the line needs\n", bytes / 1024,
              1e-6 * kBoardBaud, 1e3 * taken_s, taken_s / line_s);
  CHECK(taken_s < 1.2 * line_s);
  CHECK(device.link().repeated() == 0);
}

TEST_CASE("board: uploads over a line that loses, changes and doubles bytes are complete or refused", "[board]") {
  const bool is_long = std::getenv("HOROPTER_LONG") != nullptr;
  const int uploads = is_long ? 10'000 : 100;
  Board<Vboard_line> board;
  board.run(1'000);
  SerialDevice device(std::make_unique<BoardPort<Vboard_line>>(board, true), "board");
  const auto configured = [&] {
    return std::array{device.read(reg::sum_limit::kAddress), device.read(reg::width::kAddress),
                      device.read(reg::control::kAddress)};
  };
  device.write(reg::width::kAddress, 756);
  device.write(reg::height::kAddress, 286);
  device.write(reg::sum_limit::kAddress, 303);
  REQUIRE(upload_table(device, 0, 0, displaced(0), 0) == 0);
  device.write(reg::table_select::kAddress, 0);
  device.write(reg::control::kAddress, 1);
  board.run(10'000);
  const auto settings = configured();
  std::uint32_t active = active_crc(device);
  REQUIRE(active == displaced(0).crc());
  std::mt19937 random(20261122);
  const auto spoil = [&](double share) {
    return [&random, share](std::uint8_t byte) -> std::vector<std::uint8_t> {
      if (std::uniform_real_distribution<>(0, 1)(random) >= share) return {byte};
      switch (random() % 3) {
        case 0:
          return {};
        case 1:
          return {byte, byte};
        default:
          return {static_cast<std::uint8_t>(byte ^ 1U << random() % 8)};
      }
    };
  };
  int complete = 0;
  int given_up = 0;
  std::uint32_t slot = 0;
  for (int i = 0; i < uploads; ++i) {
    // From a line with an error now and then to one that carries hardly a frame.
    const double share = std::pow(10, std::uniform_real_distribution<>(-4, -0.7)(random));
    const std::uint32_t next = (slot + 1) % 3;
    const MapTable table = displaced(i % 40);
    board.to_board = spoil(share);
    board.from_board = spoil(share);
    std::uint32_t refused = 0;
    bool loaded = false;
    try {
      refused = upload_table(device, static_cast<int>(next), 1000 * next, table, 0);
      device.write(reg::table_select::kAddress, refused == 0 ? next : slot);
      loaded = true;
      ++complete;
    } catch (const DeviceError&) {
      ++given_up;
    }
    board.to_board = clean;
    board.from_board = clean;
    const auto selected = device.read(reg::table_select::kAddress);
    CAPTURE(i, share, next, selected);
    REQUIRE(refused == 0);  // what the line has acknowledged is right, and comes once
    if (selected == next) {
      // Selected: then it is complete, also where the host did not hear of it.
      board.run(10'000);
      slot = next;
      active = table.crc();
    } else {
      REQUIRE(selected == slot);
      REQUIRE_FALSE(loaded);
    }
    REQUIRE(reg::map_status::kActiveSlot.get(device.read(reg::map_status::kAddress)) == slot);
    REQUIRE(active_crc(device) == active);
    REQUIRE(configured() == settings);
  }
  std::printf("board: %d uploads over a bad line: %d complete, %d given up, none mixed; %zu frames repeated\n", uploads,
              complete, given_up, device.link().repeated());
  CHECK(complete > uploads / 3);
  CHECK(given_up > 0);
}

}  // namespace horopter::tb
