// SPDX-License-Identifier: Apache-2.0
// What a mapping table lets the machine see: the facts in its header (horopter/hls/table_format.hpp).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "horopter/base/profile.hpp"
#include "horopter/hls/table_format.hpp"
#include "horopter/map/map.hpp"
#include "horopter/skin/rig_skin.hpp"
#include "horopter/skin/surface.hpp"

namespace horopter {

/// How many pixels the profile's rules can judge, by the table's control points; areas and shifts are not known.
hls::table::Facts facts_of(const MapTable& table, const MachineProfile& profile);

/// What one pixel sees of a skin before two cameras. What does not depend on the skin is computed once.
class SkinScale {
 public:
  SkinScale(CameraPair cameras, const MachineProfile& profile, const ScanGeometry& geometry);
  /// Sets areas and shifts; they stay unknown where no sample (one in 16 px, either way) meets the surface. Throws
  /// nothing.
  void measure(const Surface& surface, hls::table::Facts& facts) const;

 private:
  /// A pixel of the result.
  struct Sample {
    int x = 0, y = 0;
    Eigen::Matrix2d slope;  ///< of the line of sight by the pixel of the frame, camera z = 1
    /// What the right camera sees at infinity and at the nearest place, px of the frame; nothing beyond its lens model.
    std::optional<Eigen::Vector2d> farthest, nearest;
  };
  std::optional<hls::table::ShiftRange> shift_at(const Sample& sample, const Eigen::Vector3d& direction,
                                                 const Hit& hit) const;

  CameraPair cameras_;
  int width_, height_;  ///< of the result
  int subsample_, row_step_;
  std::vector<Sample> samples_;
  std::vector<Eigen::Vector3d> directions_;  ///< of the samples, world
};

}  // namespace horopter
