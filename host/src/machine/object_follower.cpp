// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/object_follower.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "horopter/calib/rig.hpp"

namespace horopter {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// More in a frame are noise; it must not take the time of those that matter.
constexpr std::size_t kMostObjects = 100;
/// An object grows into the skin: it is followed from this part of the limit on.
constexpr std::int64_t kFollowedPart = 4;
/// Whose places are kept: both fields', and of a moving skin some steps.
constexpr std::size_t kKnownTables = 4;

/// Nothing where the place of one of the pixels is not known: half an object would read as a small one.
std::optional<ObjectInSpace> measure(const ObjectPixels& object, SkinPlaces& places) {
  double area_mm2 = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  std::vector<Vector3d> corners;
  std::optional<Vector3d> origin;  // near, so that squares lose no digits
  const auto add_end = [&](const SkinPlace& end, double side) {
    for (const double below : {-0.5, 0.5}) {
      corners.emplace_back(end.at_mm - *origin + side * end.along_mm + below * end.down_mm);
    }
  };
  for (const PixelRun& run : object.runs) {
    for (int x = run.first; x <= run.last;) {
      const auto place = places.at(x, run.row);
      if (!place) return {};
      if (!origin) origin = place->at_mm;
      // Up to the end of the block pixels are alike.
      const int last = std::min(run.last, x | (SkinPlaces::kBlock - 1));
      const int pixels = last - x + 1;
      const Vector3d middle = place->at_mm - *origin + 0.5 * (pixels - 1) * place->along_mm;
      const double area = pixels * place->area_mm2();
      area_mm2 += area;
      first += area * middle;
      second += area * middle * middle.transpose();
      second += area * (pixels * pixels - 1) / 12.0 * place->along_mm * place->along_mm.transpose();
      x = last + 1;
    }
    add_end(*places.at(run.first, run.row), -0.5);
    add_end(*places.at(run.last, run.row), 0.5);
  }
  if (!(area_mm2 > 0)) return {};
  const Vector3d centre = first / area_mm2;
  // Its plane has the directions of the largest spread.
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(second / area_mm2 - centre * centre.transpose());
  std::vector<cv::Point2f> flat;
  flat.reserve(corners.size());
  for (const Vector3d& corner : corners) {
    const Vector3d p = axes.eigenvectors().transpose() * (corner - centre);
    flat.emplace_back(static_cast<float>(p[2]), static_cast<float>(p[1]));
  }
  const cv::Size2f size = cv::minAreaRect(flat).size;
  return ObjectInSpace{area_mm2, std::max(size.width, size.height), std::min(size.width, size.height),
                       *origin + centre};
}

std::optional<CameraPair> cameras_of(const std::string& rig) {
  if (rig.empty()) return {};
  const calib::Rig cameras = calib::rig_from_yaml(rig, "the rig of the table");
  if (cameras.cameras.size() < 2) return {};
  return CameraPair(cameras.cameras[0], cameras.cameras[1]);
}

}  // namespace

std::vector<SkinObject> measured_objects(const FrameResult& result, SkinPlaces* places, std::int64_t smallest_pixels,
                                         std::size_t most) {
  std::vector<SkinObject> objects;
  for (const ObjectPixels& object : object_pixels(result, smallest_pixels, most)) {
    objects.push_back({object.region, places != nullptr ? measure(object, *places) : std::nullopt});
  }
  return objects;
}

ObjectFollower::ObjectFollower(const MachineProfile& profile, const std::vector<const MapTable*>& tables,
                               const std::string& rig)
    : tables_(tables), cameras_(cameras_of(rig)), tracker_(profile.fields_per_image()) {}

SkinPlaces* ObjectFollower::places_of(const FrameResult& result) {
  if (!cameras_) return nullptr;
  // Fields may have equal words, which know no scan.
  const auto made = [&](const MapTable* table) {
    return table->crc() == result.table_crc && table->geometry().scan == result.scan;
  };
  if (const auto known = std::ranges::find_if(known_, [&](const Known& k) { return made(k.table); });
      known != known_.end()) {
    return &known->places;
  }
  const auto table = std::ranges::find_if(tables_, made);
  if (table == tables_.end()) return nullptr;
  if (known_.size() == kKnownTables) known_.pop_front();
  known_.push_back({*table, SkinPlaces(**table, *cameras_)});
  return &known_.back().places;
}

std::vector<TrackedObject> ObjectFollower::follow(const FrameResult& result, std::optional<double> time_s) {
  std::vector<SkinObject> objects;
  if (result.object_limit_pixels > 0) {
    const std::int64_t smallest = std::max<std::int64_t>(1, result.object_limit_pixels / kFollowedPart);
    objects = measured_objects(result, places_of(result), smallest, kMostObjects);
  }
  std::vector<TrackedObject> followed = tracker_.follow(objects, result.scan, time_s);
  std::erase_if(followed, [&](const TrackedObject& o) { return !is_alarm(o.region, result); });
  return followed;
}

}  // namespace horopter
