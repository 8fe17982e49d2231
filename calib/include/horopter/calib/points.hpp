// SPDX-License-Identifier: Apache-2.0
// One camera from points with known world coordinates (thesis 6.4.1, 6.5): linear (DLT), Tsai's two steps, and the
// modified method that optimises everything.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "horopter/calib/camera.hpp"
#include "horopter/calib/joint.hpp"

namespace horopter::calib {

struct PointPair {
  Eigen::Vector3d world_mm;
  Eigen::Vector2d pixel;
};

/// What is known about a sensor beforehand.
struct Sensor {
  int width_px = 0, height_px = 0;
  double dx_mm = 0, dy_mm = 0;  ///< pitch of frame grabber pixels
  double cx_px = 0, cy_px = 0;  ///< first guess of the image centre
  std::optional<double> sx;     ///< 1 where a method cannot find it and it is not given
};

/// Lines of `x_mm y_mm z_mm u_px v_px`; empty lines and what follows a # are skipped. Throws FileError with the line.
std::vector<PointPair> read_points(const std::filesystem::path& file);
/// YAML map `width_px height_px dx_mm dy_mm cx_px cy_px [sx]`. Throws FileError with the place.
Sensor read_sensor(const std::filesystem::path& file);

enum class PointMethod { dlt, tsai, full };
std::string_view point_method_name(PointMethod method);
/// Throws std::invalid_argument that lists the names.
PointMethod point_method(std::string_view name);

/// Where the image centre of `tsai` comes from, and of `full` before everything is optimised.
enum class CentreSearch {
  given,     ///< the sensor's guess
  searched,  ///< minimum of the residual of the radial alignment constraint (6.17)
  /// One plane: given, because its residual hardly depends on the centre. Otherwise whichever of the two predicts the
  /// points better.
  automatic
};

struct PointOptions {
  CentreSearch centre = CentreSearch::automatic;
  /// Lens terms that `full` optimises beside κ1.
  bool kappa2 = false, kappa3 = false, decentring = false, thin_prism = false;
  /// Points nearer to the image centre than this part of the farthest point's distance are left out of the first of
  /// the two passes of 6.5.
  double near_centre = 0.25;
};

/// Error of a camera on points (6.9).
struct PointErrors {
  std::size_t count = 0;
  double mean_px = 0, sd_px = 0, max_px = 0, rms_px = 0;  ///< distance in the distorted image
  double nce = 0;                                         ///< (6.35) with r_sp = 1
  double nce_thesis = 0;                                  ///< with r_sp = 0.2, as in Tables 6.3 and 6.4
  std::vector<Eigen::Vector2d> residuals_px;              ///< measured minus predicted
};
/// Throws CalibrationError when the camera cannot see a point.
PointErrors evaluate(const Camera& camera, std::span<const PointPair> points);

/// A number of a camera, as reports show it.
struct Parameter {
  std::string name;  ///< with its unit
  double value = 0;
  double sd = 0;  ///< 0: not estimated; infinite: not determined
  bool free = false;
};

struct PointCalibration {
  PointMethod method = PointMethod::full;
  Camera camera;
  bool coplanar = false;
  std::vector<Parameter> parameters;
  /// Of a small rotation about the camera's axes (radians) and of the translation (mm); infinite: not determined.
  Eigen::Matrix<double, 6, 6> pose_covariance = Eigen::Matrix<double, 6, 6>::Zero();
  double tz_over_f = 0;
  double tz_over_f_sd = 0;
  PointErrors errors;
  std::vector<Eigen::Vector2d> pixels;  ///< where the points were measured
  std::optional<double> matrix_rms_px;  ///< dlt: of the matrix M itself, with its 11 numbers
  int iterations = 0;
  std::vector<std::string> warnings;
};

/// Throws CalibrationError when the points do not determine a camera: too few, not finite, on a line, a plane parallel
/// to the image, a mirrored order; and for `dlt` when they lie in a plane.
PointCalibration calibrate_points(std::span<const PointPair> points, const Sensor& sensor, PointMethod method,
                                  const PointOptions& options = {});

/// Steps of the methods, for those who need one alone.

/// M of (6.6), scaled so that its third row is a unit vector and points lie in front; by SVD in normalised coordinates.
Eigen::Matrix<double, 3, 4> direct_linear_transform(std::span<const PointPair> points);

struct PhysicalCamera {
  double fx_px = 0, fy_px = 0, skew_px = 0, cx_px = 0, cy_px = 0;
  Pose world_to_camera;
};
/// Throws CalibrationError for a matrix whose rotation would be a mirror.
PhysicalCamera physical_camera(const Eigen::Matrix<double, 3, 4>& m);

struct RadialAlignment {
  Pose world_to_camera;  ///< without tz, which is 0
  double sx = 1;
};
/// The linear step of Tsai's method: 5 unknown ratios for coplanar points (sx is taken from the sensor), 7 otherwise.
/// The system is solved as a homogeneous one: t_y may be 0. For coplanar points two poses fit; both are given, and f
/// tells which is right.
std::vector<RadialAlignment> radial_alignment(std::span<const PointPair> points, const Sensor& sensor, bool coplanar);

/// The image centre that minimises the residual of the radial alignment constraint. Nothing when the search leaves the
/// sensor or does not converge.
std::optional<Eigen::Vector2d> search_centre(std::span<const PointPair> points, const Sensor& sensor, bool coplanar);

}  // namespace horopter::calib
