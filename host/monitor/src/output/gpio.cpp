// SPDX-License-Identifier: Apache-2.0
#include "output/gpio.hpp"

#include <fmt/format.h>
#include <gpiod.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "horopter/base/error.hpp"

namespace horopter::monitor {
namespace {

struct CloseChip {
  void operator()(gpiod_chip* chip) const {
    if (chip != nullptr) gpiod_chip_close(chip);  // and its lines
  }
};

}  // namespace

LinesFollower::LinesFollower(SetLines set, const SafeState& state)
    : set_(std::move(set)), ticker_(state, [this](const Signal& signal) { put(signal.safe); }) {}

LinesFollower::~LinesFollower() {
  ticker_.stop();
  said_.reset();
  put(false);
}

/// What was said is said again only where it changes, or failed: lines that chatter help nobody.
void LinesFollower::put(bool safe) {
  if (said_ == safe && !failed_) return;
  said_ = safe;
  failed_ = !set_(safe, !safe);
}

std::string LinesFollower::trouble() const { return failed_ ? "the GPIO lines cannot be set" : ""; }

std::unique_ptr<Part> make_gpio(const GpioCell& gpio, const Cell& cell, const SafeState& state) {
  const auto fail = [&](const std::string& what) {
    throw FileError(cell.path.string(), "outputs.gpio", fmt::format("{} ({})", what, std::strerror(errno)),
                    "a chip of this computer and two of its lines that nobody uses");
  };
  const std::shared_ptr<gpiod_chip> chip(gpiod_chip_open_lookup(gpio.chip.c_str()), CloseChip());
  if (chip == nullptr) fail(fmt::format("no chip {}", gpio.chip));
  std::array<gpiod_line*, 2> lines{};
  const std::array offsets{gpio.safe_line, gpio.unsafe_line};
  for (std::size_t i = 0; i < 2; ++i) {
    lines.at(i) = gpiod_chip_get_line(chip.get(), static_cast<unsigned>(offsets.at(i)));
    const int at_first = i == 0 ? 0 : 1;  // not safe
    if (lines.at(i) == nullptr || gpiod_line_request_output(lines.at(i), "horopter", at_first) != 0) {
      fail(fmt::format("line {} of {}", offsets.at(i), gpio.chip));
    }
  }
  return std::make_unique<LinesFollower>(
      [chip, lines](bool safe, bool not_safe) {
        // The one that is to fall first.
        const auto set = [&](std::size_t i, bool value) {
          return gpiod_line_set_value(lines.at(i), value ? 1 : 0) == 0;
        };
        const bool first = safe ? set(1, not_safe) : set(0, safe);
        const bool second = safe ? set(0, safe) : set(1, not_safe);
        return first && second;
      },
      state);
}

}  // namespace horopter::monitor
