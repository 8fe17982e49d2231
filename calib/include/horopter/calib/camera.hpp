// SPDX-License-Identifier: Apache-2.0
// Cameras: where they stand, and which pixel sees which direction.
//
// Pixels: (0, 0) is the centre of the first pixel, x along the row. Camera axes: x along the rows, y down the columns,
// z out of the camera (thesis 6.1). Lengths are in mm.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "horopter/calib/lens.hpp"

namespace horopter::calib {

/// x_to = rotation · x_from + translation (6.1).
struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation_mm = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return rotation * point + translation_mm; }
  Pose operator*(const Pose& first) const {
    return {rotation * first.rotation, rotation * first.translation_mm + translation_mm};
  }
  Pose inverse() const { return {rotation.transpose(), -(rotation.transpose() * translation_mm)}; }
  /// Where the camera stands, for a pose from world to camera.
  Eigen::Vector3d centre() const { return -(rotation.transpose() * translation_mm); }
};

/// Rotation about an axis by an angle, as axis times angle in radians, both ways; the angle is at most π.
Eigen::Matrix3d rotation_from_vector(const Eigen::Vector3d& vector);
Eigen::Vector3d rotation_to_vector(const Eigen::Matrix3d& rotation);
/// Angles about x, y, z in degrees, R = Rz · Ry · Rx; |ry| ≤ 90.
Eigen::Vector3d euler_from_rotation_deg(const Eigen::Matrix3d& rotation);
/// The rotation nearest to a matrix.
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix);

/// The thesis's camera (6.2, 6.3, 6.20): the lens maps distorted to undistorted coordinates on the sensor, in mm.
struct TsaiIntrinsics {
  double f_mm = 0;
  double dx_mm = 0;  ///< d'x: sensor pitch per frame grabber pixel along the row
  double dy_mm = 0;
  double sx = 1;  ///< uncertainty of the scale along the row: X_f = sx/d'x · x + Cx
  double cx_px = 0, cy_px = 0;
  double kappa1 = 0, kappa2 = 0, kappa3 = 0;  ///< 1/mm², 1/mm⁴, 1/mm⁶; κ1 > 0: barrel
  double p1 = 0, p2 = 0;                      ///< 6.13, 1/mm
  double s1 = 0, s2 = 0;                      ///< 6.15, 1/mm

  double fx_px() const { return f_mm * sx / dx_mm; }
  double fy_px() const { return f_mm / dy_mm; }
  LensCoefficients lens() const {
    return {.k1 = kappa1, .k2 = kappa2, .p1 = p2, .p2 = p1, .k3 = kappa3, .s1 = s1, .s3 = s2};
  }
};

/// OpenCV's camera: the lens maps undistorted to distorted coordinates, in units of the focal length.
struct BrownConradyIntrinsics {
  double fx_px = 0, fy_px = 0;
  double cx_px = 0, cy_px = 0;
  LensCoefficients lens;
};

using Intrinsics = std::variant<TsaiIntrinsics, BrownConradyIntrinsics>;

/// Pixels and their derivatives by normalised coordinates, side by side. NaN: no pixel.
struct PixelBatch {
  static constexpr std::size_t kSize = 128;
  static constexpr std::size_t kRun = 8;
  std::array<double, kSize> x, y;
  std::array<double, kSize> xx, xy, yx, yy;  ///< ∂x/∂X, ∂x/∂Y, ∂y/∂X, ∂y/∂Y
};

class CameraModel {
 public:
  CameraModel() : CameraModel(BrownConradyIntrinsics{.fx_px = 1, .fy_px = 1, .lens = {}}) {}
  /// Throws std::invalid_argument unless all numbers are finite and focal lengths and pitches positive.
  explicit CameraModel(const Intrinsics& intrinsics);

  const Intrinsics& intrinsics() const { return intrinsics_; }
  double fx_px() const { return fx_; }
  double fy_px() const { return fy_; }
  double cx_px() const { return cx_; }
  double cy_px() const { return cy_; }
  const LensMap& lens() const { return lens_; }
  /// K of the undistorted camera.
  Eigen::Matrix3d matrix() const;

  /// Undistorted (x/z, y/z) of what a pixel sees. Nothing beyond the limit of the lens model.
  std::optional<Eigen::Vector2d> undistort(const Eigen::Vector2d& pixel, Eigen::Matrix2d* jacobian = nullptr) const;
  /// The pixel that sees undistorted (x/z, y/z). Nothing where no pixel does: the limit of the lens model.
  std::optional<Eigen::Vector2d> distort(const Eigen::Vector2d& normalised, Eigen::Matrix2d* jacobian = nullptr) const;
  /// The same of many, to 1e-6 px and ten times faster.
  void distort(std::span<const double> normalised_x, std::span<const double> normalised_y, PixelBatch& pixels) const;
  /// The same of a whole number of runs of PixelBatch::kRun, each as in a call of its own: what is beside a run does not
  /// change the last bits.
  void distort_runs(std::span<const double> normalised_x, std::span<const double> normalised_y,
                    PixelBatch& pixels) const;
  /// The pixel that sees a point in camera coordinates. Nothing behind the camera and beyond the limit.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point_mm) const;

  /// Distance from the centre, in pixels of the undistorted image along y, up to which every direction has a pixel.
  double limit_radius_px() const;

 private:
  template <std::size_t kRun>
  void distort_by(std::span<const double> x, std::span<const double> y, PixelBatch& pixels) const;

  Intrinsics intrinsics_;
  bool tsai_;
  double fx_, fy_, cx_, cy_;
  double unit_x_, unit_y_;  ///< pixels per unit of the lens map's plane
  double unit_;             ///< units of the lens map's plane per unit of x/z
  LensMap lens_;
};

struct Camera {
  std::string name;
  int width_px = 0, height_px = 0;  ///< 0: not known
  CameraModel model;
  Pose world_to_camera;

  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& world_mm) const {
    return model.project(world_to_camera * world_mm);
  }
};

/// One model fitted to another over the sensor.
struct Conversion {
  Intrinsics intrinsics;
  double rms_px = 0;  ///< over a grid on the sensor, of the pixel that sees the same direction
  double largest_px = 0;
};

/// By refitting all of k1 k2 p1 p2 k3 (Brown-Conrady) or κ1 κ2 κ3 p1 p2 s1 s2 (Tsai); focal lengths and centre stay.
/// An identity where the model is the same already. Throws CalibrationError when the sensor is larger than the domain
/// of the model.
Conversion to_brown_conrady(const CameraModel& model, int width_px, int height_px);
Conversion to_tsai(const CameraModel& model, int width_px, int height_px, double dx_mm, double dy_mm);

}  // namespace horopter::calib
