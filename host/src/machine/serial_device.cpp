// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/serial_device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>

#include "horopter/base/error.hpp"
#include "horopter/machine/machine_build.hpp"

namespace horopter {
namespace {

// The board's own registers, see docs/boards.md.
constexpr std::uint16_t kBoardId = 0x8000;
constexpr std::uint32_t kBoardIdValue = 0x48425244;  // "HBRD"
constexpr std::uint16_t kKeepRuns = 0x8008;
constexpr std::uint32_t kKeepRunsBusy = 1U << 31;
constexpr std::uint16_t kMostRuns = 0x800C;
constexpr std::uint16_t kKeptRuns = 0xC000;

constexpr auto kFrameTimeout = std::chrono::seconds(20);

/// A run as the board keeps it: without its start.
struct KeptRun {
  State state;
  int row;
  int end;
};

KeptRun kept_run(std::uint32_t word) {
  return {static_cast<State>(word >> 30), static_cast<int>(word >> 12 & 0xFFFU), static_cast<int>(word & 0xFFFU)};
}

}  // namespace

std::uint32_t SerialDevice::read(std::uint32_t address) { return read_all(address, 1).front(); }

void SerialDevice::write(std::uint32_t address, std::uint32_t value) { write_all(address, std::array{value}); }

void SerialDevice::write_all(std::uint32_t address, std::span<const std::uint32_t> values) {
  link_.write(static_cast<std::uint16_t>(address), values);
}

std::vector<std::uint32_t> SerialDevice::read_all(std::uint32_t address, std::size_t registers) {
  return link_.read(static_cast<std::uint16_t>(address), registers);
}

void SerialDevice::send(const Image& /*left*/, const Image& /*right*/) {
  throw UsageError(
      fmt::format("{}: a board on a serial line takes no pictures, it has cameras of its own", link_.name()));
}

FrameStreams SerialDevice::receive() {
  if (link_.read(kBoardId, 1).front() != kBoardIdValue) {
    throw DeviceError(fmt::format("{}: this board keeps no runs; expected one that does", link_.name()));
  }
  link_.write(kKeepRuns, std::array{1U});
  std::uint32_t kept = kKeepRunsBusy;
  for (const auto end = std::chrono::steady_clock::now() + kFrameTimeout; (kept & kKeepRunsBusy) != 0;) {
    if (std::chrono::steady_clock::now() > end) {
      throw DeviceError(
          fmt::format("{}: no frame is finished within {} s; expected a machine that is enabled, and its "
                      "cameras to run",
                      link_.name(), kFrameTimeout.count()));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    kept = link_.read(kKeepRuns, 1).front();
  }
  const std::uint32_t most = link_.read(kMostRuns, 1).front();
  if (kept > most) {
    throw DeviceError(fmt::format("{}: the frame has {} runs; expected at most the {} that this board keeps",
                                  link_.name(), kept, most));
  }

  const auto words = link_.read(kKeptRuns, kept);
  FrameStreams streams{result_image(*this), {}};
  const int width = streams.states.width;
  const int height = streams.states.height;
  int row = 0;
  int column = 0;
  for (const std::uint32_t word : words) {
    const KeptRun run = kept_run(word);
    if (run.row != row || run.end < column || run.end >= width || row >= height) break;
    streams.runs.push_back({row, column, run.end, run.state});
    for (int x = column; x <= run.end; ++x) streams.states.at(x, row) = static_cast<std::uint8_t>(run.state);
    column = run.end + 1 == width ? 0 : run.end + 1;
    if (column == 0) ++row;
  }
  if (row != height || column != 0 || streams.runs.size() != words.size()) {
    throw DeviceError(
        fmt::format("{}: the runs end in row {} of {}; expected those of a whole frame", link_.name(), row, height));
  }
  return streams;
}

}  // namespace horopter
