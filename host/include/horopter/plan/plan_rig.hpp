// SPDX-License-Identifier: Apache-2.0
// Choosing a rig: baseline and tilt, and what two cameras see in common (E2; thesis 5.2, 11.1, Figures 5.6, 11.2).
#pragma once

#include <optional>

#include "horopter/calib/rig.hpp"
#include "horopter/image/scan.hpp"
#include "horopter/plan/plan.hpp"
#include "horopter/skin/rig_skin.hpp"
#include "horopter/skin/surface.hpp"

namespace horopter {

/// Two like cameras, turned towards each other by one angle, without distortion.
struct RigDesign {
  double f_mm = 0;
  double pitch_um = 0;  ///< of the square pixels of the camera
  int width_px = 0;
  int height_px = 0;
  double baseline_mm = 0;
  double tilt_deg = 0;  ///< of each optical axis against the axis of symmetry; positive: they meet before the cameras

  double f_px() const { return f_mm / (pitch_um * 1e-3); }
};

/// What the rig.yaml of a designed rig says of its world, and no calibration.
inline constexpr const char* kDesignedWorld = "between the cameras, z along the axis of symmetry";
/// In that world, x from left to right. Throws std::invalid_argument unless
/// lengths and sizes are positive and the tilt is less than 90°.
calib::Rig make_rig(const RigDesign& design);

/// The tilt at which the optical axes meet at a distance: there both cameras see the most in common (Fig. 5.6).
double converging_tilt_deg(double baseline_mm, double distance_mm);
/// 11.1 for its baseline: that which gives a thickness at a distance.
double baseline_for_mm(double thickness_mm, double tolerance_px, double distance_mm, double f_px);

/// Where on the axis of symmetry both cameras see, up to 1000 baselines away.
struct DepthRange {
  double nearest_mm = 0;
  double farthest_mm = 0;  ///< infinite where it has no end
};
/// Nothing where they see the axis nowhere.
std::optional<DepthRange> depth_range(const CameraPair& cameras);

/// What two cameras see of a skin in common; areas are those of the skin.
struct CommonField {
  double left_m2 = 0;        ///< A_L: what the left camera sees
  double common_m2 = 0;      ///< A_c: what both see
  double supervised_m2 = 0;  ///< within the limits of the view
  /// Of A_c, in the directions of the baseline and across it and the axis of symmetry; NaN without one.
  double width_mm = 0, height_mm = 0;
  Summary left_angle_deg, right_angle_deg;  ///< over A_c, between line of sight and the skin's normal

  /// A_c/A_L of Fig. 11.2; NaN where the left camera sees nothing of the skin.
  double exploitation() const { return common_m2 / left_m2; }
};
CommonField common_field(const CameraPair& cameras, const Surface& surface, const ScanGeometry& geometry,
                         const ViewLimits& limits = {});

}  // namespace horopter
