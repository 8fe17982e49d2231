// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/pairing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace horopter::monitor {
namespace {

using std::chrono::nanoseconds;

/// Images of one camera that wait for the other one's.
constexpr std::size_t kMostWaiting = 8;
/// Pairs that wait for the decision; where one more comes the oldest is dropped. So one decision may take as long as two.
constexpr std::size_t kMostPairs = 2;
/// The camera's clock and ours may differ by so many periods from one image to the next: computers are late at times.
constexpr int kJumpPeriods = 5;
constexpr double kExposureStep = 0.01;  // cameras round what they were set to

}  // namespace

void Pairing::add(Side side, CameraFrame frame) {
  OneSide& here = side_of(side);
  ++here.counts.frames;
  if (here.last_arrived) {
    const double period_s = std::chrono::duration<double>(frame.arrived - *here.last_arrived).count();
    const double share = here.mean_period_s == 0 ? 1 : std::min(1.0, period_s / 1.0 + 0.02);
    here.mean_period_s += share * (period_s - here.mean_period_s);
  }
  here.last_arrived = frame.arrived;
  if (frame.image.empty()) {
    add_broken(side, frame);
    return;
  }
  check_facts(side, frame);
  const bool usable = !here.last || check_order(side, frame, *here.last);
  here.last = {frame.number, frame.taken, frame.arrived};
  if (!usable) {
    ++here.counts.dropped;
    return;
  }
  here.waiting.push_back(std::move(frame));
  match();
}

/// False: not an image of its own.
bool Pairing::check_order(Side side, const CameraFrame& frame, const Last& last) {
  OneSide& here = side_of(side);
  const nanoseconds step = frame.taken - last.taken;
  const bool counted = frame.number && last.number;
  if (step == nanoseconds(0) || (counted && *frame.number == *last.number)) {
    faults_ |= of(side, MonitorFault::left_repeated);
    ++here.counts.repeated;
    return false;
  }
  const bool anew = counted && *frame.number < *last.number;
  if (step < nanoseconds(0) || anew) {
    faults_ |= of(side, MonitorFault::left_time_back);
    // What waits is of the time before.
    here.counts.dropped += here.waiting.size();
    here.waiting.clear();
    if (anew) number_offset_.reset();  // a clock that was set says nothing of the numbers
    return true;
  }
  const auto arrival_step = frame.arrived - last.arrived;
  if (std::chrono::abs(step - arrival_step) > kJumpPeriods * rules_.period) {
    faults_ |= of(side, MonitorFault::left_time_jump);
  }
  if (counted && *frame.number > *last.number + 1) {
    faults_ |= of(side, MonitorFault::left_gap);
    here.counts.lost += *frame.number - *last.number - 1;
  } else if (step > kLongestPeriods * rules_.period) {
    faults_ |= of(side, MonitorFault::left_gap);
  }
  return true;
}

void Pairing::check_facts(Side side, const CameraFrame& frame) {
  OneSide& here = side_of(side);
  if (rules_.width == 0) set_size(frame.image.width, frame.image.height);
  if (frame.image.width != rules_.width || frame.image.height != rules_.height) {
    faults_ |= of(side, MonitorFault::left_size);
  }
  if (!rules_.exposure_may_change.at(index(side))) {
    if (!here.exposure_us) here.exposure_us = frame.exposure_us;
    const auto &first_us = here.exposure_us, &now_us = frame.exposure_us;
    // One that the camera does not tell any more may have changed.
    if (first_us && (!now_us || std::abs(*now_us - *first_us) > kExposureStep * *first_us)) {
      faults_ |= of(side, MonitorFault::left_exposure);
    }
  }
  check_packets(side, frame);
  check_serial(side, frame.serial);
}

void Pairing::check_packets(Side side, const CameraFrame& frame) {
  OneSide& here = side_of(side);
  const std::uint64_t before = std::exchange(here.lost_packets, frame.lost_packets);
  if (frame.lost_packets <= before) return;
  faults_ |= of(side, MonitorFault::left_lost_packets);
  here.counts.lost_packets += frame.lost_packets - before;
}

/// An image with holes. Nothing but its number is certain.
void Pairing::add_broken(Side side, const CameraFrame& frame) {
  OneSide& here = side_of(side);
  faults_ |= of(side, MonitorFault::left_lost_packets);
  ++here.counts.dropped;
  check_packets(side, frame);
  if (here.last && frame.number && here.last->number) {
    here.last->number = std::max(*here.last->number, *frame.number);
  }
}

const std::string& Pairing::serial_of(Side side) const {
  const std::string& given = rules_.serials[index(side)];
  return given.empty() ? sides_[index(side)].serial : given;
}

void Pairing::check_serial(Side side, const std::string& serial) {
  OneSide& here = side_of(side);
  // Cameras that are exchanged from the beginning must not pass for the right ones.
  if (here.serial.empty() && serial != rules_.serials[index(other(side))]) here.serial = serial;
  const std::string &expected = serial_of(side), &of_other = serial_of(other(side));
  if (expected.empty() || serial == expected) return;
  if (!serial.empty() && serial == of_other) {
    faults_ |= MonitorFault::swapped;
  } else {
    faults_ |= of(side, MonitorFault::left_wrong_camera);
  }
}

void Pairing::drop_unpaired(Side side) {
  OneSide& here = side_of(side);
  here.waiting.pop_front();
  ++here.counts.dropped;
  faults_ |= of(side, MonitorFault::left_unpaired);
}

void Pairing::pair_up(Duration skew) {
  ImagePair pair;
  pair.left = std::move(sides_[0].waiting.front());
  pair.right = std::move(sides_[1].waiting.front());
  for (OneSide& side : sides_) side.waiting.pop_front();
  pair.skew = skew;
  if (std::chrono::abs(skew) > rules_.largest_skew) faults_ |= MonitorFault::skew;
  if (pair.left.number && pair.right.number) {
    const auto offset = static_cast<std::int64_t>(*pair.right.number - *pair.left.number);
    if (!number_offset_) number_offset_ = offset;
    if (offset != *number_offset_) faults_ |= MonitorFault::numbers;
  }
  const auto fits = [&](const CameraFrame& frame) {
    return frame.image.width == rules_.width && frame.image.height == rules_.height;
  };
  pair.judgeable = fits(pair.left) && fits(pair.right);
  pair.faults = std::exchange(faults_, {});
  pairs_.push_back(std::move(pair));
  if (pairs_.size() <= kMostPairs) return;
  const MonitorFaults before = pairs_.front().faults;
  pairs_.pop_front();
  for (OneSide& side : sides_) ++side.counts.dropped;
  pairs_.front().faults |= before | MonitorFault::left_dropped | MonitorFault::right_dropped;
}

void Pairing::match() {
  auto& left = sides_[0].waiting;
  auto& right = sides_[1].waiting;
  while (!left.empty() && !right.empty()) {
    const Duration skew = right.front().taken - left.front().taken;
    if (2 * std::chrono::abs(skew) <= rules_.period) {
      pair_up(skew);
    } else {
      drop_unpaired(skew > Duration(0) ? Side::left : Side::right);
    }
  }
  for (const Side side : {Side::left, Side::right}) {
    if (side_of(side).waiting.size() > kMostWaiting) drop_unpaired(side);
  }
}

void Pairing::reconnected(Side side) {
  OneSide& here = side_of(side);
  here.counts.dropped += here.waiting.size();
  here.waiting.clear();
  here.last.reset();
  here.lost_packets = 0;
  number_offset_.reset();
  lost(side);
}

std::optional<ImagePair> Pairing::take() {
  if (pairs_.empty()) return std::nullopt;
  ImagePair pair = std::move(pairs_.front());
  pairs_.pop_front();
  return pair;
}

void Pairing::clear(std::uint64_t taken) {
  for (OneSide& side : sides_) {
    side.counts.dropped += taken + pairs_.size() + side.waiting.size();
    side.waiting.clear();
  }
  pairs_.clear();
  faults_ = {};
}

MonitorFaults Pairing::check(Clock::time_point now, Clock::time_point since) {
  MonitorFaults faults = std::exchange(faults_, {});
  for (const Side side : {Side::left, Side::right}) {
    if (now - side_of(side).last_arrived.value_or(since) > rules_.lost_after) {
      faults |= of(side, MonitorFault::left_camera_lost);
    }
  }
  return faults;
}

double Pairing::rate(Side side) const {
  const double period_s = sides_[index(side)].mean_period_s;
  return period_s > 0 ? 1 / period_s : 0;
}

}  // namespace horopter::monitor
