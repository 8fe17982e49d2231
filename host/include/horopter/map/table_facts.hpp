// SPDX-License-Identifier: Apache-2.0
// What a mapping table lets the machine see: the facts in its header (horopter/hls/table_format.hpp).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "horopter/base/profile.hpp"
#include "horopter/hls/table_format.hpp"
#include "horopter/map/map.hpp"
#include "horopter/skin/rig_skin.hpp"
#include "horopter/skin/skin.hpp"
#include "horopter/skin/surface.hpp"

namespace horopter {

/// How many pixels the profile's rules can judge, by the table's control points; areas and shifts are not known.
hls::table::Facts facts_of(const MapTable& table, const MachineProfile& profile);

/// Whether no area is smaller than what a pixel of its block sees of a surface that faces it, by control points and rig. The
/// true one is as large, or larger: how the surface lies, control points do not tell exactly enough. `error_px`: by which
/// the table's sources may be off.
bool areas_may_be_true(const MapTable& table, const CameraPair& cameras, double error_px);

/// What one pixel sees of a skin before two cameras. What does not depend on the skin is computed once.
class SkinScale {
 public:
  SkinScale(CameraPair cameras, const MachineProfile& profile, const ScanGeometry& geometry, const ViewLimits& view);
  /// Sets areas and shifts; they stay unknown where no sample meets the surface. Of a block the area is the largest of its
  /// pixels within the view's angle. Only what is narrower than 4 px may have less, or of a `simple` surface than 16 px.
  /// Throws nothing.
  void measure(const Surface& surface, hls::table::Facts& facts) const;

 private:
  struct Areas;
  /// A pixel of the result, one in 16, either way.
  struct Sample {
    int x = 0, y = 0;
    std::size_t place = 0;  ///< among the fine samples
    Eigen::Matrix2d slope;  ///< of the line of sight by the pixel of the frame, camera z = 1
    /// What the right camera sees at infinity and at the nearest place, px of the frame; nothing beyond its lens model.
    std::optional<Eigen::Vector2d> farthest, nearest;
  };
  std::optional<hls::table::ShiftRange> shift_at(const Sample& sample, const Eigen::Vector3d& direction,
                                                 const Hit& hit) const;
  std::optional<hls::table::ShiftRange> look_at_steps(const Surface& surface, Areas& areas) const;
  /// Of a simple surface about its outline only.
  void look_at_fine(const Surface& surface, Areas& areas) const;
  /// At every pixel between fine samples that differ.
  void look_between(const Surface& surface, Areas& areas) const;

  CameraPair cameras_;
  int width_, height_;  ///< of the result
  int subsample_, row_step_;
  double smallest_cosine_;  ///< between a line of sight and the normal, with which areas are counted
  std::vector<Sample> samples_;
  // Fine samples, one in 4 px either way, row by row.
  std::vector<int> columns_, rows_;
  std::vector<Eigen::Vector3d> directions_;  ///< world; not finite beyond the lens model
  std::vector<double> determinants_;         ///< of their slopes
};

}  // namespace horopter
