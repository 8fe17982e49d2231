// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/objects.hpp"

namespace horopter::monitor {

ObjectState state_of(const TrackedObject& object, const std::optional<Eigen::Vector3d>& camera_mm) {
  ObjectState state;
  state.id = object.id;
  state.age_frames = object.age_frames;
  state.pixels = object.region.pixels;
  state.blind_pixels = object.region.blind_pixels;
  state.x = object.region.x;
  state.y = object.region.y;
  state.width = object.region.width;
  state.height = object.region.height;
  if (object.in_space) {
    state.size_mm = object.in_space->length_mm;
    if (camera_mm) state.distance_mm = (object.in_space->centroid_mm - *camera_mm).norm();
  }
  if (object.motion) {
    if (const auto mm_s = object.motion->mm_s()) state.speed_mm_s = mm_s->norm();
  }
  return state;
}

}  // namespace horopter::monitor
