// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/objects.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace horopter::monitor {
namespace {

/// A thing that is nowhere near where one was is another.
constexpr double kFarthestStep = 1.0;  // of the larger side of its box

bool meets(const ObjectState& a, double ax, double ay, double bx, double by) {
  return std::hypot(ax - bx, ay - by) <= kFarthestStep * std::max(a.width, a.height);
}

}  // namespace

std::vector<ObjectState> ObjectTracker::next(const FrameResult& result, const ObjectScale& scale,
                                             Clock::time_point at) {
  const double passed_s = std::chrono::duration<double>(at - at_).count();
  at_ = at;
  std::vector<Known> before = std::exchange(known_, {});
  std::vector<ObjectState> objects;
  for (const Region& region : objects_of(result)) {
    if (region.pixels < result.object_limit_pixels) break;  // the largest come first
    Known now{.object = {}, .x = region.centroid_x, .y = region.centroid_y, .distance_mm = {}};
    ObjectState& object = now.object;
    object.pixels = region.pixels;
    object.blind_pixels = region.blind_pixels;
    object.x = region.x;
    object.y = region.y;
    object.width = region.width;
    object.height = region.height;
    if (scale.distance_mm) now.distance_mm = scale.distance_mm(now.x, now.y);
    object.distance_mm = now.distance_mm;
    if (now.distance_mm && scale.f_px > 0) {
      object.size_mm = std::max(region.width, region.height) * *now.distance_mm / scale.f_px;
    }
    const auto nearest = std::ranges::min_element(
        before, {}, [&](const Known& other) { return std::hypot(other.x - now.x, other.y - now.y); });
    if (nearest != before.end() && meets(object, now.x, now.y, nearest->x, nearest->y)) {
      object.id = nearest->object.id;
      object.age_frames = nearest->object.age_frames + 1;
      if (now.distance_mm && nearest->distance_mm && scale.f_px > 0 && passed_s > 0) {
        const double mm_per_px = *now.distance_mm / scale.f_px;
        const double across_mm = mm_per_px * std::hypot(now.x - nearest->x, now.y - nearest->y);
        object.speed_mm_s = std::hypot(across_mm, *now.distance_mm - *nearest->distance_mm) / passed_s;
      }
      before.erase(nearest);
    } else {
      object.id = next_id_++;
      object.age_frames = 1;
    }
    objects.push_back(object);
    known_.push_back(now);
  }
  return objects;
}

}  // namespace horopter::monitor
