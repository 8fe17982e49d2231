// SPDX-License-Identifier: Apache-2.0
// Follows what is in the skin from frame to frame: which object is one of those before, how old it is, how it moves.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "horopter/image/scan.hpp"
#include "horopter/machine/regions.hpp"

namespace horopter {

/// What an object covers of the skin, in mm of the rig's world.
struct ObjectInSpace {
  double area_mm2 = 0;
  /// Of the smallest rectangle about it, seen at right angles to the plane that fits it best; length ≥ width.
  double length_mm = 0;
  double width_mm = 0;
  Eigen::Vector3d centroid_mm{0, 0, 0};  ///< of its area
};

/// One object of one frame.
struct SkinObject {
  Region region;
  std::optional<ObjectInSpace> in_space;  ///< where a rig says it
};

/// How an object's centroid moves, over the last frames.
struct ObjectMotion {
  Eigen::Vector2d px_frame{0, 0};           ///< pixels of the result in one frame (or field)
  std::optional<Eigen::Vector3d> mm_frame;  ///< the same in mm
  std::optional<double> frame_s;            ///< time from frame to frame, where times are known
  std::optional<Eigen::Vector3d> mm_s() const;
  std::optional<Eigen::Vector2d> px_s() const;
};

struct TrackedObject : SkinObject {
  int id = 0;          ///< from 1; never given again
  int age_frames = 0;  ///< since it was first seen, that frame counted: 1 is new
  /// Nothing of a new one, and none of one that has just been joined with another, or parted: its centroid jumps.
  std::optional<ObjectMotion> motion;
};

/// Goes by the nearest to where an object is expected (as it moved before) and by the overlap of boxes; one to one, those
/// of the frame before first. Where two objects meet they are one for the machine: the id of one of them stays on it, and
/// when they part each has its own again.
class ObjectTracker {
 public:
  static constexpr int kLost_images = 5;     ///< for which an object that is not seen keeps its id
  static constexpr int kJoined_images = 25;  ///< the same within another one

  /// Results that one pair of images makes: 2 of profiles that take fields.
  explicit ObjectTracker(int results_per_image = 1) : results_per_image_(results_per_image) {}

  /// The objects of the next frame, in their order. `time_s`: when the frame was taken, on any clock.
  std::vector<TrackedObject> follow(std::span<const SkinObject> objects, Scan scan = Scan::progressive,
                                    std::optional<double> time_s = {});

 private:
  struct Seen {
    int frame = 0;
    Scan scan = Scan::progressive;
    std::optional<double> time_s;
    Eigen::Vector2d px;
    std::optional<Eigen::Vector3d> mm;
  };
  struct Track {
    int id = 0;
    int first_frame = 0;
    int missed = 0;             ///< frames since it was seen
    bool joined = false;        ///< with another one, which has its object; or has that of another one besides its own
    Eigen::Vector2d centre_px;  ///< seen, or expected
    Eigen::Vector2d velocity_px;  ///< in one frame
    double width_px = 0;          ///< of its own box
    double height_px = 0;
    std::int64_t pixels = 0;
    std::deque<Seen> history;  ///< since its centroid last jumped
  };
  /// Object of each track, or −1.
  std::vector<int> assign(std::span<const SkinObject> objects) const;
  std::optional<ObjectMotion> motion_of(const Track& track) const;
  void see(Track& track, const SkinObject& object, const Seen& seen, bool jumps);

  int results_per_image_;
  int frame_ = 0;
  int last_id_ = 0;
  std::vector<Track> tracks_;
};

}  // namespace horopter
