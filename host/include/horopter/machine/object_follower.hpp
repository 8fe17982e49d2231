// SPDX-License-Identifier: Apache-2.0
// The objects of a machine's frames, measured in mm where a rig is known, and followed from frame to frame.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "horopter/base/profile.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/machine/object_tracker.hpp"
#include "horopter/map/map.hpp"
#include "horopter/map/skin_places.hpp"

namespace horopter {

/// The objects of a frame of at least so many pixels, the `most` largest, the largest first. In mm where `places`, those of
/// the frame's table, are given, and know all of the object's pixels.
std::vector<SkinObject> measured_objects(const FrameResult& result, SkinPlaces* places, std::int64_t smallest_pixels,
                                         std::size_t most);

/// For one machine, frame after frame. Not for several threads at once.
class ObjectFollower {
 public:
  /// Tables that make the frames; they must live as long. `rig` is MapSet::rig: without one nothing is known in mm.
  /// Throws FileError for a rig that is none.
  ObjectFollower(const MachineProfile& profile, const std::vector<const MapTable*>& tables, const std::string& rig);

  bool in_mm() const { return cameras_.has_value(); }
  /// The next frame's objects that are an alarm, the largest first. Smaller ones are followed, too, from a quarter of that
  /// size on: an object is as old as it was seen then. `time_s`: when the frame was taken, on any clock; without it
  /// motion is known from frame to frame only. Every frame, also one with a fault, in order.
  std::vector<TrackedObject> follow(const FrameResult& result, std::optional<double> time_s = {});

 private:
  /// Of the table that made a result; null where it is not one of those given, or has no rig.
  SkinPlaces* places_of(const FrameResult& result);
  struct Known {
    const MapTable* table;
    SkinPlaces places;
  };

  std::vector<const MapTable*> tables_;
  std::optional<CameraPair> cameras_;
  std::deque<Known> known_;  ///< of the last tables, the newest last
  ObjectTracker tracker_;
};

}  // namespace horopter
