// SPDX-License-Identifier: Apache-2.0
// Which images of two cameras belong together, by time stamp and frame number, and what is wrong with how they come. Only
// arithmetic: the times are told, so that a simulated clock will do.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "horopter/image/image.hpp"
#include "horopter/monitor/monitor_faults.hpp"
#include "horopter/monitor/state.hpp"

namespace horopter::monitor {

using Duration = Clock::duration;

/// An image as a camera gave it.
struct CameraFrame {
  Image image;  ///< empty: parts of it were lost on the way
  /// Of the camera, one more with each; nothing where the source does not count.
  std::optional<std::uint64_t> number;
  /// When it was taken. Of both cameras by one clock, which need not be ours.
  std::chrono::nanoseconds taken{};
  Clock::time_point arrived{};  ///< its last pixel
  /// `taken` by this computer's clock, where the source can tell: however long it was on its way.
  std::optional<Clock::time_point> taken_here;
  std::uint64_t lost_packets = 0;  ///< of the transport, since the camera was opened
  std::optional<double> exposure_us;
  std::string serial;  ///< of the camera; empty where it has none
};

/// From one image of a camera to the next there are at most so many periods; more are the fault `gap`.
inline constexpr double kLongestPeriods = 1.5;

struct PairingRules {
  Duration period{};        ///< from image to image
  Duration largest_skew{};  ///< between the two images of a pair
  Duration lost_after{};    ///< without an image a camera is lost
  int width = 0;            ///< px; 0 = those of the first image
  int height = 0;
  std::array<bool, 2> exposure_may_change{};
  std::array<std::string, 2> serials;  ///< that the cameras must have; empty = the first that is told
};

/// Two images of one moment, as far as they can be told to be. What is wrong with them, or went wrong since the pair
/// before, is in `faults`.
struct ImagePair {
  CameraFrame left;
  CameraFrame right;
  Duration skew{};  ///< right minus left
  MonitorFaults faults;
  [[nodiscard]] Clock::time_point arrived() const { return std::max(left.arrived, right.arrived); }
  /// The pair shows nothing that came later: the older image, when it was taken, or else when it arrived.
  [[nodiscard]] Clock::time_point seen() const {
    const auto of = [](const CameraFrame& frame) {
      return std::min(frame.taken_here.value_or(frame.arrived), frame.arrived);
    };
    return std::min(of(left), of(right));
  }
  /// False: the machine cannot take images of this size.
  bool judgeable = true;
};

struct SideCounts {
  std::uint64_t frames = 0;
  std::uint64_t dropped = 0;  ///< came, also with holes, and are in no pair that was taken
  std::uint64_t lost = 0;     ///< never came, by their numbers
  std::uint64_t repeated = 0;
  std::uint64_t lost_packets = 0;
};

/// Not for several threads at once.
class Pairing {
 public:
  explicit Pairing(const PairingRules& rules) : rules_(rules) {}

  /// The next image of a camera.
  void add(Side side, CameraFrame frame);
  /// The connection of a camera is gone.
  void lost(Side side) { faults_ |= of(side, MonitorFault::left_camera_lost); }
  /// It was made anew: its numbers and times begin anew.
  void reconnected(Side side);
  /// The oldest pair that waits. Two may wait; where nobody took one older than these, it was dropped, and this one says so.
  std::optional<ImagePair> take();
  /// Forgets pairs and images that wait, and says that so many pairs were taken and not judged. They count as dropped, but
  /// that is no fault: for the time before the machine runs, in which it is not safe.
  void clear(std::uint64_t taken);
  /// What is wrong now, without a pair: faults since the last pair or check, and cameras from which nothing comes. Until
  /// the first image of a camera `since` counts.
  MonitorFaults check(Clock::time_point now, Clock::time_point since);

  [[nodiscard]] bool has_pair() const { return !pairs_.empty(); }
  [[nodiscard]] const SideCounts& counts(Side side) const { return sides_[index(side)].counts; }
  /// Images a second by their arrival, over the last second or so; 0 without two images.
  [[nodiscard]] double rate(Side side) const;
  void set_largest_skew(Duration skew) { rules_.largest_skew = skew; }
  void set_size(int width, int height) {
    rules_.width = width;
    rules_.height = height;
  }

 private:
  struct Last {
    std::optional<std::uint64_t> number;
    std::chrono::nanoseconds taken{};
    Clock::time_point arrived{};
  };
  struct OneSide {
    std::deque<CameraFrame> waiting;
    std::optional<Last> last;
    std::optional<double> exposure_us;  ///< of the first image that told it
    std::string serial;                 ///< the first one that it told
    std::optional<Clock::time_point> last_arrived;
    std::uint64_t lost_packets = 0;  ///< of the transport, told with the last image
    SideCounts counts;
    double mean_period_s = 0;
  };
  static std::size_t index(Side side) { return static_cast<std::size_t>(side); }
  OneSide& side_of(Side side) { return sides_[index(side)]; }
  bool check_order(Side side, const CameraFrame& frame, const Last& last);
  void check_facts(Side side, const CameraFrame& frame);
  void check_packets(Side side, const CameraFrame& frame);
  void add_broken(Side side, const CameraFrame& frame);
  /// That the camera must have; empty: none was told yet.
  [[nodiscard]] const std::string& serial_of(Side side) const;
  void check_serial(Side side, const std::string& serial);
  void match();
  void drop_unpaired(Side side);
  void pair_up(Duration skew);

  PairingRules rules_;
  std::array<OneSide, 2> sides_;
  std::deque<ImagePair> pairs_;
  MonitorFaults faults_;                       ///< since the last pair was made or checked
  std::optional<std::int64_t> number_offset_;  ///< right minus left, of the first pair
};

}  // namespace horopter::monitor
