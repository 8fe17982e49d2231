// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "target/steps.hpp"

namespace horopter::calib::detail {

using Eigen::Vector2d;

Vector2d PlaneView::undistorted(const Vector2d& plane) const {
  const Eigen::Vector3d p = homography * Eigen::Vector3d(plane.x(), plane.y(), 1);
  return p.head<2>() / p.z();
}

Vector2d PlaneView::distort(const Vector2d& pixel) const {
  const Vector2d d = (pixel - middle) / radius;
  // Beyond the turning point of the model its edge is used: a fit in progress must not meet a NaN.
  return middle + (pixel - middle) * (2 / (1 + std::sqrt(std::max(0.0, 1 - 4 * lambda * d.squaredNorm()))));
}

Vector2d PlaneView::undistort(const Vector2d& pixel) const {
  const Vector2d d = (pixel - middle) / radius;
  return middle + (pixel - middle) / (1 + lambda * d.squaredNorm());
}

Eigen::Matrix2d PlaneView::jacobian(const Vector2d& plane) const {
  const double h = 1e-3 * std::max(1.0, plane.cwiseAbs().maxCoeff());
  Eigen::Matrix2d result;
  result.col(0) = (project(plane + Vector2d(h, 0)) - project(plane - Vector2d(h, 0))) / (2 * h);
  result.col(1) = (project(plane + Vector2d(0, h)) - project(plane - Vector2d(0, h))) / (2 * h);
  return result;
}

namespace {

/// Moves the centroid to 0 and the mean distance to √2.
Eigen::Matrix3d normaliser(std::span<const Vector2d> points) {
  Vector2d mean(0, 0);
  for (const Vector2d& p : points) mean += p / static_cast<double>(points.size());
  double distance = 0;
  for (const Vector2d& p : points) distance += (p - mean).norm() / static_cast<double>(points.size());
  const double s = std::sqrt(2.0) / std::max(distance, 1e-12);
  Eigen::Matrix3d result;
  result << s, 0, -s * mean.x(), 0, s, -s * mean.y(), 0, 0, 1;
  return result;
}

bool on_a_line(std::span<const Vector2d> points) {
  Vector2d mean(0, 0);
  for (const Vector2d& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Vector2d& p : points) scatter += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scatter, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[0] <= 1e-8 * solver.eigenvalues()[1];
}

}  // namespace

std::optional<PlaneFit> fit_plane(std::span<const Vector2d> plane, std::span<const Vector2d> pixels, int width,
                                  int height, std::span<const Spread> spreads) {
  const std::size_t n = plane.size();
  if (n < 4 || pixels.size() != n || on_a_line(plane) || on_a_line(pixels)) return std::nullopt;
  const Eigen::Matrix3d tp = normaliser(plane);
  const Eigen::Matrix3d ti = normaliser(pixels);
  Eigen::MatrixXd rows(2 * n, 9);
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector3d p = tp * plane[i].homogeneous();
    const Eigen::Vector3d q = ti * pixels[i].homogeneous();
    rows.row(2 * i) << p.transpose(), 0, 0, 0, -q.x() * p.transpose();
    rows.row(2 * i + 1) << 0, 0, 0, p.transpose(), -q.y() * p.transpose();
  }
  const Eigen::Matrix<double, 9, 9> gram = rows.transpose() * rows;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>> solver(gram);
  const Eigen::Matrix<double, 9, 1> h = solver.eigenvectors().col(0);
  Eigen::Matrix3d normalised;
  normalised << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], h[8];
  const Eigen::Matrix3d back = ti.inverse();

  PlaneFit fit;
  fit.view.middle = Vector2d((width - 1) / 2.0, (height - 1) / 2.0);
  fit.view.radius = std::hypot(width, height) / 2;
  if (std::abs(normalised(2, 2)) < 1e-12) return std::nullopt;
  normalised /= normalised(2, 2);

  using Parameters = Eigen::Matrix<double, 12, 1>;  // homography, λ, spread
  Parameters p;
  p << normalised(0, 0), normalised(0, 1), normalised(0, 2), normalised(1, 0), normalised(1, 1), normalised(1, 2),
      normalised(2, 0), normalised(2, 1), 0, 0, 0, 0;
  const auto apply = [&](const Parameters& at) {
    Eigen::Matrix3d m;
    m << at[0], at[1], at[2], at[3], at[4], at[5], at[6], at[7], 1;
    PlaneView view = fit.view;
    view.homography = back * m * tp;
    view.lambda = at[8];
    return view;
  };
  // Diamonds tell only the sum of Sxx and Syy: a weak pull to 0 settles what the corners do not.
  const double pull = spreads.empty() ? 0 : 0.02 * std::sqrt(static_cast<double>(n));
  const auto residuals = [&](const Parameters& at) {
    const PlaneView view = apply(at);
    Eigen::VectorXd r(2 * n + 3);
    r.tail<3>() = pull * at.tail<3>();
    for (std::size_t i = 0; i < n; ++i) {
      r.segment<2>(2 * i) = view.project(plane[i]) - pixels[i];
      if (!spreads.empty()) r.segment<2>(2 * i) += spreads[i] * at.tail<3>();
    }
    return r;
  };
  const int free = !spreads.empty() ? 12 : n >= 12 ? 9 : 8;
  Eigen::VectorXd r = residuals(p);
  double lambda = 1e-4;
  for (int iteration = 0; iteration < 40 && r.allFinite(); ++iteration) {
    Eigen::MatrixXd jacobian(r.size(), free);
    for (int k = 0; k < free; ++k) {
      Parameters at = p;
      at[k] += 1e-6;
      jacobian.col(k) = (residuals(at) - r) / 1e-6;
    }
    const Eigen::MatrixXd gram_step = jacobian.transpose() * jacobian;
    const Eigen::VectorXd gradient = jacobian.transpose() * r;
    bool better = false;
    double gain = 0;
    for (int attempt = 0; attempt < 8 && !better; ++attempt) {
      Eigen::MatrixXd damped = gram_step;
      damped.diagonal() *= 1 + lambda;
      damped.diagonal().array() += 1e-15;
      Parameters next = p;
      next.head(free) -= damped.ldlt().solve(gradient);
      next[8] = std::clamp(next[8], -1.0, 0.24);  // the whole image keeps an inverse
      const Eigen::VectorXd next_r = residuals(next);
      if (next_r.allFinite() && next_r.squaredNorm() <= r.squaredNorm()) {
        better = true;
        gain = r.squaredNorm() - next_r.squaredNorm();
        p = next;
        r = next_r;
        lambda = std::max(lambda / 10, 1e-12);
      } else {
        lambda *= 10;
      }
    }
    if (!better || gain < 1e-9 * r.squaredNorm() + 1e-14) break;
  }
  if (!r.allFinite()) return std::nullopt;
  fit.view = apply(p);
  fit.spread = p.tail<3>();
  fit.rms_px = std::sqrt(r.head(2 * n).squaredNorm() / static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i) fit.residual_px.push_back(r.segment<2>(2 * i).norm());
  return fit;
}

}  // namespace horopter::calib::detail
