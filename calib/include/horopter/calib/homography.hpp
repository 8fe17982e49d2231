// SPDX-License-Identifier: Apache-2.0
// Homographies: maps of one plane onto another that keep lines straight, as between a flat target and its image.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace horopter::calib {

/// The similarity that moves the points' mean to the origin and their mean distance from it to √2. Nothing when all
/// points are the same point.
std::optional<Eigen::Matrix3d> normalisation(std::span<const Eigen::Vector2d> points);

struct Homography {
  /// (x', y', 1) ~ matrix · (x, y, 1), of norm 1 in normalised coordinates; the sign is arbitrary.
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  /// How well the points determine it: the second smallest singular value of the equations over the largest. 0 when
  /// all but one of the points lie on a line.
  double determined = 0;
};

/// The least squares of the linear equations x' × (matrix · x) = 0 in normalised coordinates (Hartley and Zisserman,
/// Multiple View Geometry, algorithm 4.2). Nothing for fewer than 4 pairs, or when all points of one side are the same.
std::optional<Homography> solve_homography(std::span<const Eigen::Vector2d> from, std::span<const Eigen::Vector2d> to);

}  // namespace horopter::calib
