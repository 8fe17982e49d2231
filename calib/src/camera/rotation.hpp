// SPDX-License-Identifier: Apache-2.0
// Derivatives of rotations.
#pragma once

#include <Eigen/Core>

namespace horopter::calib::detail {

/// v × x as a matrix times x.
Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v);
/// J with exp(ω + δ) ≈ exp(ω) · exp(J δ).
Eigen::Matrix3d right_jacobian(const Eigen::Vector3d& omega);

}  // namespace horopter::calib::detail
