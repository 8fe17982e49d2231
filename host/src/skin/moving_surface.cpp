// SPDX-License-Identifier: Apache-2.0
#include "horopter/skin/moving_surface.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace horopter {
namespace {

using Eigen::Vector3d;

/// Key times of a motion, 0 before all of them.
template <class Timed>
std::vector<double> times_of(const std::vector<Timed>& later) {
  if (later.empty()) throw std::invalid_argument("a motion without a time");
  std::vector<double> times{0};
  for (const Timed& timed : later) {
    if (!(timed.time_s > times.back()) || !std::isfinite(timed.time_s)) {
      throw std::invalid_argument(
          fmt::format("time {} s after {} s; times rise, from above 0", timed.time_s, times.back()));
    }
    times.push_back(timed.time_s);
  }
  return times;
}

class MovingPose : public MovingSurface {
 public:
  MovingPose(SurfacePtr surface, const Vector3d& about_mm, const std::vector<TimedPose>& later)
      : surface_(std::move(surface)), about_mm_(about_mm), times_s_(times_of(later)), keys_{{}} {
    for (const TimedPose& key : later) {
      if (!key.shift_mm.allFinite() || !key.rotation.isUnitary(1e-6)) {
        throw std::invalid_argument(fmt::format("the pose at {} s is none", key.time_s));
      }
      keys_.push_back(key);
    }
  }
  SurfacePtr at(double time_s) const override { return make_moved(surface_, pose(time_s)); }
  double way_mm(double from_s, double to_s, const Vector3d& point_mm) const override {
    return (pose(from_s) * (pose(to_s).inverse() * point_mm) - point_mm).norm();
  }
  double end_s() const override { return times_s_.back(); }

 private:
  calib::Pose pose(double time_s) const {
    const auto [before, share] = between_times(times_s_, time_s);
    const TimedPose& a = keys_[before];
    const TimedPose& b = keys_[before + 1];
    calib::Pose pose;
    pose.rotation = a.rotation * calib::rotation_from_vector(
                                     Vector3d(share * calib::rotation_to_vector(a.rotation.transpose() * b.rotation)));
    const Vector3d shift = a.shift_mm + share * (b.shift_mm - a.shift_mm);
    pose.translation_mm = about_mm_ + shift - pose.rotation * about_mm_;
    return pose;
  }

  SurfacePtr surface_;
  Vector3d about_mm_;
  std::vector<double> times_s_;
  std::vector<TimedPose> keys_;
};

class MovingCapsules : public MovingSurface {
 public:
  MovingCapsules(std::vector<Capsule> first, const std::vector<TimedCapsules>& later)
      : times_s_(times_of(later)), keys_{std::move(first)} {
    for (const TimedCapsules& key : later) {
      if (!std::ranges::equal(key.capsules, keys_[0], {}, &Capsule::radius_mm, &Capsule::radius_mm)) {
        throw std::invalid_argument(fmt::format("at {} s {} segments; as many as at first, of the same radii",
                                                key.time_s, key.capsules.size()));
      }
      keys_.push_back(key.capsules);
    }
    for (const auto& capsules : keys_) make_capsules(capsules);  // which checks them
  }
  SurfacePtr at(double time_s) const override { return make_capsules(capsules(time_s)); }
  /// Each point of a hull stays within its radius of the segment, which moves least and most at its ends.
  double way_mm(double from_s, double to_s, const Vector3d& /*point_mm*/) const override {
    const std::vector<Capsule> from = capsules(from_s);
    const std::vector<Capsule> to = capsules(to_s);
    double longest = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      longest = std::max({longest, (to[i].from_mm - from[i].from_mm).norm(), (to[i].to_mm - from[i].to_mm).norm()});
    }
    return longest;
  }
  double end_s() const override { return times_s_.back(); }

 private:
  std::vector<Capsule> capsules(double time_s) const {
    const auto [before, share] = between_times(times_s_, time_s);
    std::vector<Capsule> result = keys_[before];
    for (std::size_t i = 0; i < result.size(); ++i) {
      const Capsule& after = keys_[before + 1][i];
      result[i].from_mm += share * (after.from_mm - result[i].from_mm);
      result[i].to_mm += share * (after.to_mm - result[i].to_mm);
    }
    return result;
  }

  std::vector<double> times_s_;
  std::vector<std::vector<Capsule>> keys_;
};

}  // namespace

BetweenTimes between_times(const std::vector<double>& times_s, double time_s) {
  const auto after = std::upper_bound(times_s.begin() + 1, times_s.end() - 1, time_s);
  const auto before = static_cast<std::size_t>(after - times_s.begin()) - 1;
  return {before, std::clamp((time_s - times_s[before]) / (times_s[before + 1] - times_s[before]), 0.0, 1.0)};
}

MovingSurfacePtr make_moving(SurfacePtr surface, const Vector3d& about_mm, std::vector<TimedPose> poses) {
  return std::make_shared<MovingPose>(std::move(surface), about_mm, poses);
}

MovingSurfacePtr make_moving_capsules(std::vector<Capsule> capsules, std::vector<TimedCapsules> later) {
  return std::make_shared<MovingCapsules>(std::move(capsules), later);
}

double largest_speed_m_s(double thickness_mm, double images_per_s) { return thickness_mm * 1e-3 * images_per_s; }

}  // namespace horopter
