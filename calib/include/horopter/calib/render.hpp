// SPDX-License-Identifier: Apache-2.0
// Images of a flat target as a camera with finite pixels, blur, noise and a distorting lens would take them: the rig of
// thesis 6.8 without a laboratory. Independent of the camera models that are calibrated with its images.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "horopter/calib/edge_profile.hpp"
#include "horopter/calib/target.hpp"

namespace horopter::calib {

/// Camera of 6.2 and 6.3, written down once more.
struct RenderCamera {
  int width_px = 756, height_px = 581;
  double f_mm = 10;
  double dx_mm = 0.0086, dy_mm = 0.0083;  ///< a 1/2" sensor of 756x581 pixels
  double sx = 1;
  double cx_px = 377.5, cy_px = 290;
  double kappa1 = 0;                                       ///< 1/mm², distorted to undistorted; > 0: barrel
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< world to camera
  Eigen::Vector3d translation_mm{0, 0, 1000};

  /// The pixel that sees a world point (Newton's method on 6.10; in front of the camera, inside the limit of κ1).
  Eigen::Vector2d project(const Eigen::Vector3d& world_mm) const;
  /// World direction that a pixel sees (not normalised).
  Eigen::Vector3d direction(const Eigen::Vector2d& pixel) const;
  Eigen::Vector3d centre_mm() const { return -(rotation.transpose() * translation_mm); }
};

struct RenderTarget {
  TargetSpec spec;
  /// Bright fiducials on dark ground, or the reverse. Chessboards: black squares outermost at the first corner.
  bool bright = false;
  /// The plane of the print in the world: target (x, y) is at (x, y, z_mm). Above a table, z is negative (towards the
  /// camera; TargetSpec has z into the print).
  double z_mm = 0;
  double turn_deg = 0;  ///< within its plane, about the origin, x towards y
  Eigen::Vector2d shift_mm{0, 0};
  /// Where the print has its corners instead, relative to spec.points_mm(); empty: a perfect print.
  std::vector<Eigen::Vector2d> print_error_mm;
  bool hole = false;       ///< the hole in the first fiducial
  double margin_mm = 1e9;  ///< of background around the outermost corners; beyond it everything is `outside`
  double outside = 110;    ///< grey level

  /// World coordinates of the corners as they should be, in the order of the spec.
  std::vector<Eigen::Vector3d> world_mm() const;
};

/// Diameter of the hole in the first fiducial, as part of its side.
inline constexpr double kHoleOverSide = 0.3;

/// `supersampling` places a pixel and direction; the blur and the pixel's area are integrated over them.
GreyImage render_target(const RenderCamera& camera, const RenderTarget& target, const Imaging& imaging,
                        std::uint64_t seed = 0, int supersampling = 5);

cv::Mat to_mat(const GreyImage& image);

/// The rig of 6.8: camera 1 m above a pattern of 8x6 white fiducials of 33 mm, turned a little out of the plane's
/// normal so that the plane is not parallel to the image.
TargetSpec thesis_target(TargetKind kind);
RenderCamera thesis_camera(double kappa1 = 0.0008);

}  // namespace horopter::calib
