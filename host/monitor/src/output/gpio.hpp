// SPDX-License-Identifier: Apache-2.0
// Two lines of the computer: safe and its complement; and a third, whose pulses say that somebody still sets them.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "horopter/monitor/part.hpp"
#include "output/ticker.hpp"

namespace horopter::monitor {

/// Sets both lines; false where that failed.
using SetLines = std::function<bool(bool safe, bool not_safe)>;
/// Sets the third; false where that failed.
using SetPulse = std::function<bool(bool level)>;

/// Lines that follow what may be said, and are not safe at the end.
class LinesFollower : public Part {
 public:
  /// `pulse` is called with another level at each look while it is safe, and not otherwise.
  LinesFollower(SetLines set, const SafeState& state, SetPulse pulse = {});
  ~LinesFollower() override;
  LinesFollower(const LinesFollower&) = delete;
  LinesFollower& operator=(const LinesFollower&) = delete;
  [[nodiscard]] std::string trouble() const override;

 private:
  void put(bool safe);

  SetLines set_;
  SetPulse pulse_;
  bool level_ = false;
  std::atomic<bool> failed_ = false;
  std::optional<bool> said_;
  Ticker ticker_;  // the last: its thread uses the others
};

/// Once: a monitor that was killed may have left them safe, and a driver that keeps what was released keeps this, too.
/// Throws as make_gpio() does.
void set_gpio_not_safe(const GpioCell& gpio, const Cell& cell);
/// Throws FileError for a chip or lines that cannot be had.
std::unique_ptr<Part> make_gpio(const GpioCell& gpio, const Cell& cell, const SafeState& state);

}  // namespace horopter::monitor
