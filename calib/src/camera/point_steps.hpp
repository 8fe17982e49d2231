// SPDX-License-Identifier: Apache-2.0
// What the methods of calibration from points (points.hpp) share.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>
#include <vector>

#include "horopter/calib/points.hpp"

namespace horopter::calib::detail {

/// Thickness over extent below which points count as lying in a plane.
inline constexpr double kFlat = 0.01;
/// Width over extent below which they count as lying on a line.
inline constexpr double kThin = 1e-3;

inline constexpr const char* kMirrored =
    "the points fit a mirrored camera only: their order is mirrored in the world or in the image (world axes must be "
    "right-handed, u to the right, v down)";
inline constexpr const char* kDegenerate =
    "the points do not determine the camera: too many of them lie on a line, or all on lines through the image centre";
inline constexpr const char* kParallel =
    "the points lie in a plane parallel to the image, or nearly so: f and Tz cannot be told apart; tilt the plane "
    "against the image (30 degrees or so) or add points at other heights";

/// World coordinates in which the points' mean is the origin and their plane of least squares z = 0.
struct Frame {
  Pose world_to_frame;
  Eigen::Vector3d extent_mm;  ///< root mean square along x, y, z
};

Frame frame_of(std::span<const PointPair> points);
std::vector<PointPair> in_frame(std::span<const PointPair> points, const Pose& world_to_frame);

/// These throw CalibrationError.
void check_finite(std::span<const PointPair> points);
void check_count(std::size_t count, std::size_t least, std::string_view why);

/// The vector that the matrix maps nearest to 0, found after scaling the columns. Throws CalibrationError with `why`
/// when another one is as good.
Eigen::VectorXd null_vector(const Eigen::MatrixXd& matrix, const char* why);

/// The camera that Tsai's linear steps give: radial alignment (6.17), then f and tz (6.19). Of the poses that fit, the
/// one that puts the points in front of the camera.
struct LinearCamera {
  TsaiIntrinsics intrinsics;
  Pose world_to_camera;
};
LinearCamera linear_camera(std::span<const PointPair> points, const Sensor& sensor, bool coplanar);

}  // namespace horopter::calib::detail
