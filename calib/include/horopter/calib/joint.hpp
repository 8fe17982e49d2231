// SPDX-License-Identifier: Apache-2.0
// The one optimisation behind every method: any number of cameras on one rig, any number of views of known points,
// all of it at once, minimising the distance in the image between measured and predicted points.
//
// The thesis minimises (6.20), (6.21) on the undistorted plane; here the same equations are compared in pixels of the
// distorted image, where the measurements and their noise are.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "horopter/calib/camera.hpp"

namespace horopter::calib {

/// Parameters of a camera as the optimiser sees them: f (mm, or fy in pixels for Brown-Conrady), scale of x against y
/// (sx, or fx/fy), centre, and the coefficients of the lens map.
struct CameraParameters {
  static constexpr int kCount = 4 + LensCoefficients::kCount;
  using Vector = Eigen::Matrix<double, kCount, 1>;
  enum Index { f = 0, scale = 1, cx = 2, cy = 3, lens = 4 };

  static Vector from(const Intrinsics& intrinsics);
  /// `like` gives the model and what is never optimised (pitches).
  static Intrinsics to(const Vector& vector, const Intrinsics& like);
};

using FreeParameters = std::array<bool, CameraParameters::kCount>;

/// Pose parameters: rotation vector, translation.
using FreePose = std::array<bool, 6>;
inline constexpr FreePose kWholePose{true, true, true, true, true, true};

struct JointCamera {
  Intrinsics intrinsics;
  FreeParameters free{};
  Pose rig_to_camera;  ///< of the first camera: not optimised, it is the rig
};

struct JointView {
  Pose target_to_rig;
  FreePose free = kWholePose;
};

/// What one camera saw of one view.
struct JointObservation {
  int camera = 0;
  int view = 0;
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<Eigen::Vector2d> pixels;
  bool used = true;
};

struct JointProblem {
  std::vector<JointCamera> cameras;
  std::vector<JointView> views;
  std::vector<JointObservation> observations;
};

struct JointOptions {
  double huber_px = 0;  ///< residuals beyond it count linearly; 0: plain least squares
  int max_iterations = 200;
};

struct JointReport {
  bool converged = false;
  int iterations = 0;
  double rms_px = 0;  ///< root of the mean squared distance over the observations used
  std::string message;
};

/// Throws CalibrationError when a start puts a point behind its camera or beyond the lens's limit.
JointReport optimise(JointProblem& problem, const JointOptions& options = {});

/// Measured minus predicted, per observation and point; NaN where a camera cannot see the point.
std::vector<std::vector<Eigen::Vector2d>> residuals_px(const JointProblem& problem);
double rms_of(const std::vector<Eigen::Vector2d>& residuals);

/// Standard deviations at a solution, from the Jacobian; infinite for what the measurements do not determine, 0 for
/// what was not free.
struct JointCovariance {
  double sigma_px = 0;  ///< of one coordinate, from the residuals and the degrees of freedom
  int degrees_of_freedom = 0;
  bool determined = true;  ///< false: some combination of parameters is free to move
  std::vector<Eigen::Matrix<double, CameraParameters::kCount, CameraParameters::kCount>> cameras;
  /// Small rotation about the axes of the camera or rig (radians), then translation (mm).
  std::vector<Eigen::Matrix<double, 6, 6>> rig_to_camera;
  std::vector<Eigen::Matrix<double, 6, 6>> views;
  /// Between f of the first camera and the translation along z of the first view.
  double f_tz = 0;
};

/// `sigma_px` > 0 replaces the estimate from the residuals; otherwise at least `least_sigma_px` is taken.
JointCovariance covariance(const JointProblem& problem, double sigma_px = 0, double least_sigma_px = 0);

/// One measured point and its derivatives, for tests and for bounds.
struct Prediction {
  Eigen::Vector2d pixel;
  Eigen::Matrix<double, 2, CameraParameters::kCount> by_camera;
  Eigen::Matrix<double, 2, 6> by_rig_to_camera;
  Eigen::Matrix<double, 2, 6> by_view;
};

/// `near` is a pixel in whose neighbourhood the prediction is expected (it starts the inverse of the lens). False
/// when the point is behind the camera or beyond the lens's limit.
bool predict(const Intrinsics& like, const CameraParameters::Vector& camera, const Eigen::Matrix<double, 6, 1>& rig,
             const Eigen::Matrix<double, 6, 1>& view, const Eigen::Vector3d& point_mm, const Eigen::Vector2d& near,
             Prediction& prediction);

Eigen::Matrix<double, 6, 1> pose_vector(const Pose& pose);
Pose pose_from_vector(const Eigen::Matrix<double, 6, 1>& vector);

}  // namespace horopter::calib
