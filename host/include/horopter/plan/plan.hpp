// SPDX-License-Identifier: Apache-2.0
// Planning an installation: how thick a skin is, how fast an object may be, how far away the danger must be (E1, E10;
// thesis 2.3, 11.1, 11.2.2).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "horopter/base/profile.hpp"
#include "horopter/map/map.hpp"
#include "horopter/skin/moving_surface.hpp"
#include "horopter/skin/rig_skin.hpp"
#include "horopter/skin/surface.hpp"

namespace horopter {

/// Speed of a hand (2.3). ISO 13855:2010 has it for a walking body, and for what is more than 500 mm away.
inline constexpr double kHandSpeed_m_s = 1.6;
/// Of a hand up to 500 mm away, ISO 13855:2010.
inline constexpr double kIsoHandSpeed_m_s = 2.0;

// By the thesis's formulas.

/// 2 D z² d_x/(b f), first form of 11.1 (the others put A_c = z s/f into it): parallel cameras and a skin parallel to
/// their baseline. f in pixels is f/d_x; tolerance D and f in the same pixels.
double coplanar_thickness_mm(double tolerance_px, double distance_mm, double baseline_mm, double f_px);
/// 11.2: across a skin whose normal is off the axis of symmetry by an angle, from the thickness along that axis.
double sloped_thickness_mm(double thickness_mm, double slope_deg);
/// 11.3: width of the part of a face across the axis of symmetry that is in a sloped skin. Infinite without a slope.
double face_width_mm(double thickness_mm, double slope_deg);
/// 11.2.2: detectable share of a face that is tilted against the skin by an angle, 1/tan ω, at most 1.
double face_share(double tilt_deg);

/// What a machine and its cameras are set to, as far as it takes time.
struct Timing {
  const MachineProfile& profile;
  Decision decision = Decision::thesis;
  int rows = 0;                      ///< of an image, or field
  double images_per_s = 0;           ///< frames: images, or fields
  std::optional<double> exposure_s;  ///< nothing: the longest that there is, from image to image
  std::optional<double> monitor_s;   ///< from an image's arrival to the client of a live monitor; nothing: hardware
  int alarm_frames = 1;              ///< over so many a body may be seen until it is an alarm
  double longest_periods = 1;        ///< that two images may be apart without a fault, in periods from image to image

  /// From a frame until so many more have been taken, at most. The fields of an image are always one period apart.
  double longest_s(int frames = 1) const;
};
/// A part of the response time.
struct ResponseItem {
  std::string name;
  double seconds = 0;
  std::string source;  ///< where that is said, or measured, or proved
};
/// Longest times from an object's entry to the alarm, in their order. An object that comes while an image is exposed may
/// not be seen in it.
std::vector<ResponseItem> detection_items(const Timing& timing);
/// All of them.
double detection_time_s(const Timing& timing);
/// Response time (detection and stopping) times speed (2.3).
double safety_distance_mm(double response_s, double speed_m_s);
/// K·T of ISO 13855:2010: with 2.0 m/s; where that gives more than 500 mm with 1.6 m/s, but 500 mm at least. Its
/// supplement C for what reaches through before it is detected is not in it.
double iso_13855_distance_mm(double response_s);

/// S = K·T + C of ISO 13855:2010 for approach at right angles to the skin, with what it is made of.
struct IsoDistance {
  double k_m_s = 0;
  double c_mm = 0;
  double distance_mm = 0;
  double capability_mm = 0;  ///< d, of what moves at K
};
inline constexpr double kIsoHand_mm = 40;  ///< up to this detection capability C = 8 (d - 14) mm, 0 at least
inline constexpr double kIsoArm_mm = 70;   ///< and up to this 850 mm; beyond it the standard has no C
/// d, the smallest body that is found, depends on its speed: `fast_mm` of kIsoHandSpeed_m_s, `slow_mm` of kHandSpeed_m_s. Up
/// to 40 mm K is 2.0 m/s and S 100 mm at least; where that gives more than 500 mm, K is 1.6 m/s and S 500 mm at least. Up to
/// 70 mm K is 1.6 m/s. Nothing where the standard has none.
std::optional<IsoDistance> iso_13855_distance(double response_s, double fast_mm, double slow_mm);

// By the camera model.

/// Of many figures.
struct Summary {
  double smallest = 0;  ///< NaN, all three, of nothing
  double mean = 0;
  double largest = 0;
};

/// Two cameras as 11.1 sees them.
struct StereoAxis {
  Eigen::Vector3d middle_mm;  ///< between the cameras
  Eigen::Vector3d direction;  ///< axis of symmetry: the mean of both optical axes, length 1
  double baseline_mm = 0;
  double tilt_deg = 0;  ///< β of Table 11.1: of an optical axis against the axis of symmetry
  double f_px = 0;      ///< right camera, along x

  explicit StereoAxis(const CameraPair& cameras);
  /// Across the axis.
  SurfacePtr plane_at(double distance_mm) const { return make_plane(middle_mm + distance_mm * direction, direction); }
};

/// A skin's thickness; mm, over the supervised pixels of a frame, or of an even field.
struct ThicknessPlan {
  std::int64_t pixels = 0;
  std::int64_t left_sees = 0;   ///< of the skin
  std::int64_t shared = 0;      ///< the skin where they look is in the right image too, and not hidden
  std::int64_t supervised = 0;  ///< of these, within the limits of the view
  RowCount rows;                ///< as a table for these limits has it
  Summary distance;             ///< z of 11.1, along the axis of symmetry
  Summary slope_deg;            ///< γ of 11.2, between the skin's normal and the axis
  Summary sight;                ///< thickness along the left line of sight, by the camera model
  Summary across;               ///< along the skin's normal, by the camera model
  Summary formula;              ///< the same by 11.1 and 11.2
  double on_axis = 0;           ///< `across` where the axis of symmetry meets the skin; NaN where it does not
  double on_axis_formula = 0;
  double face_width = 0;          ///< smallest width of 11.3
  double least_way_mm = 0;        ///< smallest of CameraPair::least_way_mm
  std::vector<double> across_mm;  ///< of each pixel, row by row; NaN where it is not supervised
  /// Of each of these pixels: mm of the skin for a pixel of the left image, in the direction in which they are most.
  std::vector<double> mm_per_px;

  /// "Exploitation" of the left image (Fig. 11.2).
  double exploitation() const { return static_cast<double>(shared) / static_cast<double>(pixels); }
};

/// `tolerance_px`: disparity D in pixels of the result. Throws std::invalid_argument where the cameras cannot watch it.
ThicknessPlan plan_thickness(const CameraPair& cameras, const Surface& surface, const MachineProfile& profile,
                             const ScanGeometry& geometry, double tolerance_px, const ViewLimits& limits = {});

}  // namespace horopter
