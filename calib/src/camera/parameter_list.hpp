// SPDX-License-Identifier: Apache-2.0
// Parameters with their names and deviations, as reports list them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "horopter/calib/points.hpp"

namespace horopter::calib::detail {

/// The names of the terms of the lens map, in the order of LensCoefficients.
inline constexpr std::array<const char*, LensCoefficients::kCount> kLensTermNames{"k1", "k2", "p1", "p2", "k3", "k4",
                                                                                  "k5", "k6", "s1", "s2", "s3", "s4"};

/// Adds rx_deg, ry_deg, rz_deg, tx_mm, ty_mm, tz_mm. `covariance` is that of a small rotation (radians) and of the
/// translation (mm).
void append_pose(std::vector<Parameter>& list, const Pose& pose, const Eigen::Matrix<double, 6, 6>& covariance,
                 bool free);

/// The standard deviation of fx = f · scale, in the unit of f.
double fx_deviation(double f, double scale,
                    const Eigen::Matrix<double, CameraParameters::kCount, CameraParameters::kCount>& covariance);

}  // namespace horopter::calib::detail
