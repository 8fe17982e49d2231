// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/moving_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include "horopter/base/error.hpp"
#include "horopter/map/row_check.hpp"

namespace horopter {
namespace {

using Eigen::Vector3d;

constexpr int kLatticeStep_px = 8;
/// Parts of a step that are tried; a motion that needs more does not come forward.
constexpr int kMostParts = 1024;
constexpr std::size_t kMostSteps = 20'000;  // some minutes; every one is a table

/// What a left pixel sees of a skin.
struct SkinPoint {
  bool supervised = false;
  double distance_mm = 0;  ///< infinite without the skin
  double cosine = 0;       ///< between the line of sight and the skin's normal
  double across_mm = 0;    ///< thickness
  Vector3d at_mm;
};

class Watcher {
 public:
  Watcher(const CameraPair& cameras, const MachineProfile& profile, double tolerance_px, int width, int height)
      : cameras_(cameras),
        row_step_(profile.fields_per_image()),
        tolerance_px_(tolerance_px * profile.subsample),
        frame_{width, height, Scan::progressive} {
    const int step = std::clamp(width / 32, 1, kLatticeStep_px);
    for (int y = 0; y < height; y += step) {
      for (int x = 0; x < width; x += step) points_.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
    rays_ = cameras.rays(points_);
  }

  const Point& pixel(std::size_t i) const { return points_[i]; }

  std::vector<SkinPoint> look(const Surface& surface) const {
    const Vector3d eye = cameras_.left().world_to_camera.centre();
    surface.check_cameras(eye, cameras_.right().world_to_camera.centre());
    std::vector<Hit> hits(points_.size());
    std::vector<Look> looks(points_.size());
    surface.intersect(eye, rays_.directions, hits);
    cameras_.look(surface, rays_, row_step_, {}, looks);
    std::vector<SkinPoint> places(points_.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Vector3d& direction = rays_.directions[i];
      const Point source = looks[i].source;
      SkinPoint& place = places[i];
      place.distance_mm = hits[i].distance * direction.norm();
      if (!std::isfinite(place.distance_mm)) continue;
      place.cosine = std::abs(hits[i].normal.dot(direction)) / direction.norm();
      place.at_mm = eye + hits[i].distance * direction;
      if (looks[i].reason != Reason::none || !frame_.holds(source)) continue;
      place.across_mm = cameras_.thickness_mm(place.at_mm, hits[i].normal, tolerance_px_) * place.cosine;
      place.supervised = std::isfinite(place.across_mm);
    }
    return places;
  }

 private:
  const CameraPair& cameras_;
  int row_step_;
  double tolerance_px_;  ///< in pixels of the frame
  ScanGeometry frame_;
  std::vector<Point> points_;
  Rays rays_;
};

/// Whether no object slips through between two frames.
bool is_small(const MovingSurface& surface, double from_s, const std::vector<SkinPoint>& from, double to_s,
              const std::vector<SkinPoint>& to, double object_mm) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (!to[i].supervised) continue;
    const double thickness_mm = from[i].supervised ? std::min(from[i].across_mm, to[i].across_mm) : to[i].across_mm;
    double way_mm = std::abs(to[i].distance_mm - from[i].distance_mm) * std::max(to[i].cosine, from[i].cosine);
    if (object_mm + way_mm <= thickness_mm) continue;
    way_mm = std::min(way_mm, surface.way_mm(from_s, to_s, to[i].at_mm));
    if (!(object_mm + way_mm <= thickness_mm)) return false;
  }
  return true;
}

/// Throws where an object can pass the skin though it is at rest.
void check_thickness(const Watcher& watcher, const std::vector<SkinPoint>& places, double time_s, double object_mm,
                     const MotionLimits& limits) {
  std::size_t thinnest = places.size();
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i].supervised) continue;
    if (thinnest == places.size() || places[i].across_mm < places[thinnest].across_mm) thinnest = i;
  }
  if (thinnest == places.size() || places[thinnest].across_mm > object_mm) return;
  const double across_mm = places[thinnest].across_mm;
  throw std::runtime_error(
      fmt::format("at {:.3f} s the skin is {:.2f} mm thick at left pixel ({:.0f}, {:.0f}), and an object of {} m/s "
                  "moves by {:.2f} mm between two of {} images a second: no step is small enough (object_speed_m_s "
                  "must be below {:.3f})",
                  time_s, across_mm, watcher.pixel(thinnest).x, watcher.pixel(thinnest).y, limits.object_speed_m_s,
                  object_mm, limits.images_per_s, largest_speed_m_s(across_mm, 1 / limits.longest_s())));
}

/// `make(tools(), i)` for each i below `count`, in several threads that have tools of their own. The results do not depend
/// on their number; what is thrown is what the smallest i throws.
template <class Result, class Tools, class Make>
std::vector<std::optional<Result>> in_threads(int threads, std::size_t count, const Tools& tools, const Make& make) {
  std::vector<std::optional<Result>> results(count);
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::size_t failed = count;
  std::exception_ptr failure;
  const auto work = [&] {
    std::size_t i = 0;
    try {
      auto own = tools();
      while ((i = next++) < count) results[i] = make(own, i);
    } catch (...) {
      next = count;  // those below i have been taken
      const std::lock_guard lock(mutex);
      if (failure && i >= failed) return;
      failed = i;
      failure = std::current_exception();
    }
  };
  if (threads == 0) threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 8U));
  {
    std::vector<std::jthread> others;
    try {
      for (int i = 1; i < threads && std::cmp_less(i, count); ++i) others.emplace_back(work);
    } catch (const std::system_error&) {  // there are no more: fewer do
    }
    work();
  }
  if (failure) std::rethrow_exception(failure);
  return results;
}

}  // namespace

std::vector<const MapTable*> MovingMaps::tables() const {
  std::vector<const MapTable*> all;
  for (const MovingStep& step : steps) all.push_back(&step.map.table);
  return all;
}

std::size_t MovingMaps::step_of(std::size_t frame) const {
  if (frame < steps.size()) return frame;
  if (geometry().scan == Scan::progressive) return steps.size() - 1;
  const std::size_t last = steps.size() - 1;
  return last % 2 == frame % 2 ? last : last - 1;
}

std::vector<double> plan_motion(const CameraPair& cameras, const MovingSurface& surface, const MotionLimits& limits,
                                const MachineProfile& profile, int image_width, int image_height) {
  const Watcher watcher(cameras, profile, limits.tolerance_px, image_width, image_height);
  const double object_mm = limits.object_speed_m_s * 1e3 * limits.longest_s();
  if (!(surface.end_s() * limits.images_per_s < kMostSteps)) {
    throw std::runtime_error(fmt::format("{:g} s with {:g} images a second: a table for each, and at most {} of them",
                                         surface.end_s(), limits.images_per_s, kMostSteps));
  }
  std::vector<double> times_s{0};
  std::vector<SkinPoint> places = watcher.look(*surface.at(0));
  check_thickness(watcher, places, 0, object_mm, limits);
  const double shortest_s = 1 / limits.images_per_s / kMostParts;
  double step_s = 1 / limits.images_per_s;
  for (int frame = 1; times_s.back() < surface.end_s(); ++frame) {
    const double due_s = std::min(frame / limits.images_per_s, surface.end_s());
    while (times_s.back() < due_s) {
      const double from_s = times_s.back();
      // What went the last time, and more.
      for (step_s = std::min(2 * step_s, due_s - from_s);; step_s /= 2) {
        const double to_s = step_s < due_s - from_s ? from_s + step_s : due_s;
        std::vector<SkinPoint> next = watcher.look(*surface.at(to_s));
        check_thickness(watcher, next, to_s, object_mm, limits);
        if (is_small(surface, from_s, places, to_s, next, object_mm)) {
          times_s.push_back(to_s);
          places = std::move(next);
          break;
        }
        if (step_s < shortest_s || times_s.size() == kMostSteps) {
          throw std::runtime_error(
              fmt::format("at {:.3f} s the skin's thickness leaves too little for any step, with an object that moves "
                          "by {:.2f} mm between two images (object_speed_m_s must be lower)",
                          from_s, object_mm));
        }
      }
    }
  }
  return times_s;
}

MovingMaps compile_motion(const SkinFile& skin, const MachineProfile& profile, int image_width, int image_height,
                          const ViewLimits& view, int threads) {
  const auto* rig_skin = dynamic_cast<const RigSkin*>(skin.skin.get());
  if (rig_skin == nullptr || !skin.motion) {
    throw FileError(skin.path, "motion", "this skin does not move", "a surface with `motion`");
  }
  const CameraPair& cameras = rig_skin->cameras();
  const auto bad = [&](const std::string& what) {
    return FileError(skin.path, "motion", what, "a motion that the machine can follow");
  };
  MovingMaps maps;
  maps.rig = skin.rig;
  std::vector<double> times_s;
  try {
    times_s = plan_motion(cameras, *skin.motion, skin.motion_limits, profile, image_width, image_height);
  } catch (const std::runtime_error& error) {
    throw bad(error.what());
  } catch (const std::invalid_argument& error) {
    throw bad(error.what());
  }
  const double due = std::ceil(skin.motion->end_s() * skin.motion_limits.images_per_s - 1e-9) + 1;
  maps.inserted = times_s.size() - static_cast<std::size_t>(due);
  // The skin stays at the end, in both fields.
  if (profile.takes_fields()) times_s.push_back(times_s.back());

  MapLimits limits;
  limits.largest_bytes = static_cast<std::size_t>(profile.pool_bytes) / 2;
  limits.view = view;
  const std::vector<ScanGeometry> scans = scans_of(profile, image_width, image_height);
  const auto compilers = [&] {
    std::vector<MapCompiler> made;
    for (const ScanGeometry& scan : scans) made.emplace_back(cameras, profile, scan, limits);
    return made;
  };
  const auto table = [&](std::vector<MapCompiler>& with, std::size_t i) {
    try {
      return with[i % scans.size()].compile(*skin.motion->at(times_s[i]));
    } catch (const RowError& error) {
      throw FileError(skin.path, "motion", fmt::format("at {:.3f} s: {}", times_s[i], error.what()),
                      RowError::expected());
    } catch (const std::exception& error) {
      throw bad(fmt::format("at {:.3f} s: {}", times_s[i], error.what()));
    }
  };
  RowReach reach;
  for (auto& map : in_threads<CompiledMap>(threads, times_s.size(), compilers, table)) {
    reach.ahead = std::max(reach.ahead, map->report.reach.ahead);
    reach.behind = std::max(reach.behind, map->report.reach.behind);
    maps.steps.push_back({times_s[maps.steps.size()], std::move(*map)});
  }
  const auto lookahead = lookahead_for(profile, reach);
  if (!lookahead) {
    throw bad(
        fmt::format("all steps together need {} right rows above and {} below; the store of profile {} gives {} "
                    "and {}{}",
                    reach.behind, reach.ahead, profile.name, profile.rows_behind(), profile.largest_lookahead(),
                    store_that_holds(profile, reach)));
  }
  maps.lookahead = *lookahead;
  for (MovingStep& step : maps.steps) step.map.report.lookahead = *lookahead;
  return maps;
}

}  // namespace horopter
