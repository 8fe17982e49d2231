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

struct Requested {
  std::shared_ptr<gpiod_chip> chip;
  std::array<gpiod_line*, 3> lines{};  ///< safe, not safe, pulse
};

/// All are not safe then.
Requested request(const GpioCell& gpio, const Cell& cell) {
  const auto fail = [&](const std::string& what) {
    throw FileError(cell.path.string(), "outputs.gpio", fmt::format("{} ({})", what, std::strerror(errno)),
                    "a chip of this computer and two of its lines that nobody uses");
  };
  Requested requested{.chip = {gpiod_chip_open_lookup(gpio.chip.c_str()), CloseChip()}};
  if (requested.chip == nullptr) fail(fmt::format("no chip {}", gpio.chip));
  const std::array offsets{gpio.safe_line, gpio.unsafe_line, gpio.pulse_line};
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    if (offsets.at(i) < 0) continue;
    gpiod_line* const line = gpiod_chip_get_line(requested.chip.get(), static_cast<unsigned>(offsets.at(i)));
    const int at_first = i == 1 ? 1 : 0;  // not safe
    if (line == nullptr || gpiod_line_request_output(line, "horopter", at_first) != 0) {
      fail(fmt::format("line {} of {}", offsets.at(i), gpio.chip));
    }
    requested.lines.at(i) = line;
  }
  return requested;
}

}  // namespace

LinesFollower::LinesFollower(SetLines set, const SafeState& state, SetPulse pulse)
    : set_(std::move(set)), pulse_(std::move(pulse)), ticker_(state, [this](const Signal& signal) {
        put(signal.safe);
        if (!signal.safe || !pulse_) return;
        level_ = !level_;
        if (!pulse_(level_)) failed_ = true;
      }) {}

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

void set_gpio_not_safe(const GpioCell& gpio, const Cell& cell) { request(gpio, cell); }

std::unique_ptr<Part> make_gpio(const GpioCell& gpio, const Cell& cell, const SafeState& state) {
  const auto set = [requested = request(gpio, cell)](std::size_t i, bool value) {
    return gpiod_line_set_value(requested.lines.at(i), value ? 1 : 0) == 0;
  };
  SetPulse pulse;
  if (gpio.pulse_line >= 0) pulse = [set](bool level) { return set(2, level); };
  return std::make_unique<LinesFollower>(
      [set](bool safe, bool not_safe) {
        // The one that is to fall first.
        const bool first = safe ? set(1, not_safe) : set(0, safe);
        const bool second = safe ? set(0, safe) : set(1, not_safe);
        return first && second;
      },
      state, std::move(pulse));
}

}  // namespace horopter::monitor
