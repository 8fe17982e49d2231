// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/object_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace horopter {
namespace {

using Eigen::Vector2d;

/// Images back by which a velocity is measured: few enough to follow a hand, enough to be calm.
constexpr int kMeasured_images = 4;
/// A part that comes or goes and is more than this share of the pixels makes the centroid jump.
constexpr double kPart = 0.1;

struct Box {
  double left, top, right, bottom;
  double area() const { return std::max(0.0, right - left) * std::max(0.0, bottom - top); }
};

Box box_of(const Region& r) {
  return {static_cast<double>(r.x), static_cast<double>(r.y), static_cast<double>(r.x + r.width),
          static_cast<double>(r.y + r.height)};
}
Box box_about(const Vector2d& centre, double width, double height) {
  return {centre.x() - width / 2, centre.y() - height / 2, centre.x() + width / 2, centre.y() + height / 2};
}
Box common(const Box& a, const Box& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}
double overlap(const Box& a, const Box& b) {
  const double both = common(a, b).area();
  return both > 0 ? both / (a.area() + b.area() - both) : 0;
}
bool holds(const Box& box, const Vector2d& p) {
  return p.x() >= box.left && p.x() <= box.right && p.y() >= box.top && p.y() <= box.bottom;
}
Vector2d clamped(const Vector2d& p, const Box& box) {
  return {std::clamp(p.x(), box.left, box.right), std::clamp(p.y(), box.top, box.bottom)};
}
Vector2d centroid(const Region& r) { return {r.centroid_x, r.centroid_y}; }

}  // namespace

std::optional<Eigen::Vector3d> ObjectMotion::mm_s() const {
  if (!mm_frame || !frame_s) return {};
  return *mm_frame / *frame_s;
}

std::optional<Vector2d> ObjectMotion::px_s() const {
  if (!frame_s) return {};
  return px_frame / *frame_s;
}

std::vector<int> ObjectTracker::assign(std::span<const SkinObject> objects) const {
  struct Candidate {
    int missed;
    double cost;
    std::size_t track, object;
  };
  std::vector<Candidate> candidates;
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    const Track& track = tracks_[t];
    const Box expected = box_about(track.centre_px, track.width_px, track.height_px);
    for (std::size_t o = 0; o < objects.size(); ++o) {
      const Region& region = objects[o].region;
      const double reach =
          0.5 * (std::hypot(track.width_px, track.height_px) + std::hypot(region.width, region.height));
      const double distance = (centroid(region) - track.centre_px).norm();
      if (!(distance <= reach)) continue;
      candidates.push_back({track.missed, distance / reach + 1 - overlap(expected, box_of(region)), t, o});
    }
  }
  std::ranges::sort(candidates, {}, [](const Candidate& c) { return std::tuple(c.missed, c.cost, c.track, c.object); });
  std::vector<int> object_of(tracks_.size(), -1);
  std::vector<bool> taken(objects.size());
  for (const Candidate& c : candidates) {
    if (object_of[c.track] >= 0 || taken[c.object]) continue;
    object_of[c.track] = static_cast<int>(c.object);
    taken[c.object] = true;
  }
  return object_of;
}

std::optional<ObjectMotion> ObjectTracker::motion_of(const Track& track) const {
  if (track.history.empty()) return {};
  // From a field to the one of the same rows: whether the two of an image were taken together is not known.
  const Seen& now = track.history.back();
  const auto then = std::ranges::find_if(track.history, [&](const Seen& seen) {
    return seen.scan == now.scan && seen.frame < now.frame &&
           now.frame - seen.frame <= kMeasured_images * results_per_image_;
  });
  if (then == track.history.end()) return {};
  const double frames = now.frame - then->frame;
  ObjectMotion motion;
  motion.px_frame = (now.px - then->px) / frames;
  if (now.mm && then->mm) motion.mm_frame = (*now.mm - *then->mm) / frames;
  if (now.time_s && then->time_s && *now.time_s > *then->time_s)
    motion.frame_s = (*now.time_s - *then->time_s) / frames;
  return motion;
}

void ObjectTracker::see(Track& track, const SkinObject& object, const Seen& seen, bool jumps) {
  const Region& region = object.region;
  track.missed = 0;
  track.joined = false;
  track.centre_px = seen.px;
  track.width_px = region.width;
  track.height_px = region.height;
  track.pixels = region.pixels;
  if (jumps) track.history.clear();
  track.history.push_back(seen);
  while (track.history.front().frame < frame_ - kMeasured_images * results_per_image_) track.history.pop_front();
  if (const auto motion = motion_of(track)) track.velocity_px = motion->px_frame;
}

std::vector<TrackedObject> ObjectTracker::follow(std::span<const SkinObject> objects, Scan scan,
                                                 std::optional<double> time_s) {
  ++frame_;
  for (Track& track : tracks_) track.centre_px += track.velocity_px;
  const std::vector<int> object_of = assign(objects);
  std::vector<int> track_of(objects.size(), -1);
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    if (object_of[t] >= 0) track_of[static_cast<std::size_t>(object_of[t])] = static_cast<int>(t);
  }

  // Those that went into another one's object: that one is not where its pixels are, either.
  std::vector<bool> holds_two(objects.size());
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    Track& track = tracks_[t];
    if (object_of[t] >= 0) continue;
    const bool may_join = track.joined || track.missed == 0;
    ++track.missed;
    track.joined = false;
    for (std::size_t o = 0; may_join && o < objects.size(); ++o) {
      const Box box = box_of(objects[o].region);
      if (track_of[o] < 0 || !holds(box, track.centre_px)) continue;
      track.joined = true;
      track.centre_px = clamped(track.centre_px, box);
      track.history.clear();
      // What is small beside the rest hardly moves its centroid.
      holds_two[o] =
          holds_two[o] || static_cast<double>(track.pixels) > kPart * static_cast<double>(objects[o].region.pixels);
      break;
    }
  }

  std::vector<TrackedObject> result;
  for (std::size_t o = 0; o < objects.size(); ++o) {
    const SkinObject& object = objects[o];
    const Vector2d centre = centroid(object.region);
    Seen seen{frame_, scan, time_s, centre, {}};
    if (object.in_space) seen.mm = object.in_space->centroid_mm;
    if (track_of[o] < 0) {
      track_of[o] = static_cast<int>(tracks_.size());
      Track track;
      track.id = ++last_id_;
      track.first_frame = frame_;
      track.velocity_px = Vector2d::Zero();
      see(track, object, seen, false);
      tracks_.push_back(std::move(track));
    } else {
      Track& track = tracks_[static_cast<std::size_t>(track_of[o])];
      if (holds_two[o]) {
        track.missed = 0;
        track.joined = true;
        track.centre_px = clamped(track.centre_px, box_of(object.region));
        track.history.clear();
      } else {
        // A new object within its box, and fewer pixels: a part of it.
        const Box before = box_about(track.centre_px, track.width_px, track.height_px);
        const bool parted = static_cast<double>(object.region.pixels) < (1 - kPart) * static_cast<double>(track.pixels);
        bool jumps = track.joined;
        for (std::size_t n = 0; parted && !jumps && n < objects.size(); ++n) {
          const bool is_new = track_of[n] < 0 || tracks_[static_cast<std::size_t>(track_of[n])].first_frame == frame_;
          jumps = is_new && n != o && common(before, box_of(objects[n].region)).area() > 0;
        }
        see(track, object, seen, jumps);
      }
    }
    const Track& track = tracks_[static_cast<std::size_t>(track_of[o])];
    TrackedObject tracked;
    static_cast<SkinObject&>(tracked) = object;
    tracked.id = track.id;
    tracked.age_frames = frame_ - track.first_frame + 1;
    tracked.motion = motion_of(track);
    result.push_back(tracked);
  }
  std::erase_if(tracks_, [&](const Track& track) {
    return track.missed > (track.joined ? kJoined_images : kLost_images) * results_per_image_;
  });
  return result;
}

}  // namespace horopter
