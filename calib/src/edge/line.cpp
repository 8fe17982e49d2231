// SPDX-License-Identifier: Apache-2.0
// Lines through points of an edge, and corners where two of them meet.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "horopter/calib/edge.hpp"

namespace horopter::calib {

using Eigen::Vector2d;

std::optional<Line> fit_line(std::span<const Vector2d> points_px) {
  std::vector<Vector2d> kept(points_px.begin(), points_px.end());
  std::optional<Line> line;
  for (int round = 0; round < 4; ++round) {
    if (kept.size() < 2) return std::nullopt;
    Vector2d mean(0, 0);
    for (const Vector2d& p : kept) mean += p / static_cast<double>(kept.size());
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (const Vector2d& p : kept) scatter += (p - mean) * (p - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scatter);
    if (!(solver.eigenvalues()[1] > 1e-12)) return std::nullopt;
    const Vector2d normal = solver.eigenvectors().col(0);
    line = Line{normal, normal.dot(mean), std::sqrt(std::max(0.0, solver.eigenvalues()[0]) / kept.size()),
                static_cast<int>(kept.size())};
    std::vector<double> distances;
    for (const Vector2d& p : points_px) distances.push_back(std::abs(normal.dot(p) - line->distance_px));
    std::vector<double> sorted = distances;
    std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
    const double limit = std::max(0.1, 3 * 1.4826 * sorted[sorted.size() / 2]);
    std::vector<Vector2d> next;
    for (std::size_t i = 0; i < distances.size(); ++i)
      if (distances[i] <= limit) next.push_back(points_px[i]);
    if (next.size() == kept.size() || next.size() < 4) break;
    kept = std::move(next);
  }
  return line;
}

std::optional<Vector2d> intersect(const Line& a, const Line& b) {
  Eigen::Matrix2d matrix;
  matrix << a.normal.transpose(), b.normal.transpose();
  const double determinant = matrix.determinant();  // sine of the angle between them
  if (std::abs(determinant) < 0.0087) return std::nullopt;
  return Vector2d((a.distance_px * b.normal.y() - b.distance_px * a.normal.y()) / determinant,
                  (b.distance_px * a.normal.x() - a.distance_px * b.normal.x()) / determinant);
}

std::vector<EdgePoint> edge_points(const GreyImage& image, const EdgeEstimator& estimator, const Vector2d& a_px,
                                   const Vector2d& b_px, const Vector2d& normal, int count, double margin_px) {
  std::vector<EdgePoint> result;
  const Vector2d direction = b_px - a_px;
  const double length = direction.norm();
  if (!(length > 2 * margin_px) || count < 1) return result;
  for (int i = 0; i < count; ++i) {
    const double at = count == 1 ? length / 2 : margin_px + (length - 2 * margin_px) * i / (count - 1);
    if (const auto point = estimator.estimate(image, a_px + direction * (at / length), normal))
      result.push_back(*point);
  }
  return result;
}

}  // namespace horopter::calib
