// SPDX-License-Identifier: Apache-2.0
// The faults that the monitor itself finds, beside those of the machine (faults.hpp): one word, as outputs say it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace horopter::monitor {

enum class Side { left = 0, right = 1 };
constexpr Side other(Side side) { return side == Side::left ? Side::right : Side::left; }

/// Each one's number is its bit in the word. New ones come at the end: other programs know the numbers.
enum class MonitorFault {
  left_camera_lost,
  left_gap,
  left_repeated,
  left_time_back,
  left_time_jump,
  left_size,
  left_exposure,
  left_lost_packets,
  left_unpaired,
  left_dropped,
  left_wrong_camera,
  right_camera_lost,
  right_gap,
  right_repeated,
  right_time_back,
  right_time_jump,
  right_size,
  right_exposure,
  right_lost_packets,
  right_unpaired,
  right_dropped,
  right_wrong_camera,
  skew,
  numbers,
  swapped,
  decision_late,
  engine,
  output,
  starting,
  ending,
};
inline constexpr int kMonitorFaults = 30;

/// The names, in the order of their bits.
inline constexpr auto kMonitorFaultNames = std::to_array<std::string_view>({"left_camera_lost",
                                                                            "left_gap",
                                                                            "left_repeated",
                                                                            "left_time_back",
                                                                            "left_time_jump",
                                                                            "left_size",
                                                                            "left_exposure",
                                                                            "left_lost_packets",
                                                                            "left_unpaired",
                                                                            "left_dropped",
                                                                            "left_wrong_camera",
                                                                            "right_camera_lost",
                                                                            "right_gap",
                                                                            "right_repeated",
                                                                            "right_time_back",
                                                                            "right_time_jump",
                                                                            "right_size",
                                                                            "right_exposure",
                                                                            "right_lost_packets",
                                                                            "right_unpaired",
                                                                            "right_dropped",
                                                                            "right_wrong_camera",
                                                                            "skew",
                                                                            "numbers",
                                                                            "swapped",
                                                                            "decision_late",
                                                                            "engine",
                                                                            "output",
                                                                            "starting",
                                                                            "ending"});
static_assert(kMonitorFaultNames.size() == kMonitorFaults);

/// A fault of the left camera, or the same of the right one.
constexpr MonitorFault of(Side side, MonitorFault left) {
  constexpr int kEach = static_cast<int>(MonitorFault::right_camera_lost);
  return side == Side::left ? left : static_cast<MonitorFault>(static_cast<int>(left) + kEach);
}

class MonitorFaults {
 public:
  constexpr MonitorFaults() = default;
  constexpr MonitorFaults(MonitorFault fault) : bits_(1U << static_cast<unsigned>(fault)) {}  // NOLINT: one is a set

  [[nodiscard]] constexpr std::uint32_t word() const { return bits_; }
  [[nodiscard]] constexpr bool any() const { return bits_ != 0; }
  [[nodiscard]] constexpr bool has(MonitorFault fault) const { return (bits_ & MonitorFaults(fault).bits_) != 0; }
  constexpr MonitorFaults& operator|=(MonitorFaults others) {
    bits_ |= others.bits_;
    return *this;
  }
  friend constexpr MonitorFaults operator|(MonitorFaults a, MonitorFaults b) { return a |= b; }
  friend constexpr bool operator==(MonitorFaults, MonitorFaults) = default;

  [[nodiscard]] std::vector<std::string_view> names() const {
    std::vector<std::string_view> names;
    for (int i = 0; i < kMonitorFaults; ++i) {
      if (has(static_cast<MonitorFault>(i))) names.push_back(kMonitorFaultNames.at(static_cast<std::size_t>(i)));
    }
    return names;
  }

 private:
  std::uint32_t bits_ = 0;
};

}  // namespace horopter::monitor
