// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/lens.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <vector>

#include "camera/lens_evaluate.hpp"

namespace horopter::calib {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// Polynomials in r, lowest power first.
using Polynomial = std::vector<double>;

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.size() + b.size() - 1, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}

Polynomial sum(Polynomial a, const Polynomial& b, double factor) {
  a.resize(std::max(a.size(), b.size()), 0.0);
  for (std::size_t i = 0; i < b.size(); ++i) a[i] += factor * b[i];
  return a;
}

double evaluate(const Polynomial& p, double r) {
  double value = 0;
  for (const double coefficient : std::views::reverse(p)) value = value * r + coefficient;
  return value;
}

/// Smallest r > 0 with p(r) = 0, for p(0) > 0. A root that is real but for rounding counts too: a limit that is too
/// small is safe, one that is too large is not.
double first_positive_root(Polynomial p) {
  // r = scale·t makes the largest coefficient ratio 1, so that the companion matrix is well balanced.
  double scale = kNoLimit;
  for (std::size_t i = 1; i < p.size(); ++i) {
    if (p[i] != 0) scale = std::min(scale, std::pow(p[0] / std::abs(p[i]), 1.0 / static_cast<double>(i)));
  }
  if (!std::isfinite(scale)) return kNoLimit;
  double power = 1;
  for (double& coefficient : p) {
    coefficient *= power;
    power *= scale;
  }
  while (p.size() > 1 && std::abs(p.back()) < 1e-15 * p[0]) p.pop_back();
  const auto degree = static_cast<Eigen::Index>(p.size()) - 1;
  if (degree < 1) return kNoLimit;
  // The companion matrix of the reversed polynomial has the eigenvalues 1/t: the small roots come out best.
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(degree, degree);
  for (Eigen::Index i = 0; i < degree; ++i) companion(0, i) = -p[static_cast<std::size_t>(i) + 1] / p[0];
  for (Eigen::Index i = 1; i < degree; ++i) companion(i, i - 1) = 1;
  const Eigen::VectorXcd inverse_roots = Eigen::EigenSolver<Eigen::MatrixXd>(companion, false).eigenvalues();
  double first = kNoLimit;
  for (const std::complex<double>& inverse_root : inverse_roots) {
    if (std::abs(inverse_root) < 1e-12) continue;
    const std::complex<double> root = 1.0 / inverse_root;
    if (root.real() > 0 && std::abs(root.imag()) < 1e-7 * root.real()) first = std::min(first, root.real());
  }
  if (!std::isfinite(first)) return kNoLimit;
  // The simple root between two points of different sign, to the last bit, from below.
  double low = first * (1 - 1e-6);
  double high = first * (1 + 1e-6);
  if (evaluate(p, low) > 0 && evaluate(p, high) < 0) {
    while (true) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      (evaluate(p, middle) > 0 ? low : high) = middle;
    }
    return low * scale;
  }
  return first * scale;
}

/// Bounds c1, c3 such that the smallest eigenvalue of the symmetric part of the Jacobian of all terms but L is never
/// below −c1 r − c3 r³.
std::array<double, 2> tangential_bound(const LensCoefficients& c) {
  const double half_trace = std::hypot(4 * c.p2 + c.s1, 4 * c.p1 + c.s3);
  Matrix2d deviator;  // (cos, sin) → ((Jxx − Jyy)/2, (Jxy + Jyx)/2)
  deviator << 2 * c.p2 + c.s1, -2 * c.p1 - c.s3, 2 * c.p1 + c.s3, 2 * c.p2 + c.s1;
  const double norm = std::hypot(2 * c.p2 + c.s1, 2 * c.p1 + c.s3);  // it is a scaled rotation
  return {half_trace + norm, 4 * std::hypot(c.s2, c.s4)};
}

double limit_of(const LensCoefficients& c) {
  const Polynomial a{1, 0, c.k1, 0, c.k2, 0, c.k3};
  const Polynomial b{1, 0, c.k4, 0, c.k5, 0, c.k6};
  const Polynomial r_da{0, 0, 2 * c.k1, 0, 4 * c.k2, 0, 6 * c.k3};  // r dA/dr
  const Polynomial r_db{0, 0, 2 * c.k4, 0, 4 * c.k5, 0, 6 * c.k6};
  const auto [c1, c3] = tangential_bound(c);
  const Polynomial bound = product({0, c1, 0, c3}, product(b, b));
  // B² times the radial and the tangential eigenvalue of the Jacobian of r·L, less the bound.
  const Polynomial radial_part = sum(sum(product(sum(a, r_da, 1), b), product(a, r_db), -1), bound, -1);
  const Polynomial tangential_part = sum(product(a, b), bound, -1);
  return std::min({first_positive_root(radial_part), first_positive_root(tangential_part), first_positive_root(b)});
}

}  // namespace

LensCoefficients LensCoefficients::from(const std::array<double, kCount>& v) {
  return {v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9], v[10], v[11]};
}

Vector2d lens_forward(const LensCoefficients& c, const Vector2d& point, Matrix2d* by_point,
                      Eigen::Matrix<double, 2, LensCoefficients::kCount>* by_coefficients) {
  const double x = point.x(), y = point.y();
  const LensValue value = lens_value(c, x, y);
  if (by_point != nullptr) *by_point << value.xx, value.xy, value.yx, value.yy;
  if (by_coefficients != nullptr) {
    const double r2 = x * x + y * y, r4 = r2 * r2;
    const double l = radial(c, r2).value;
    const double b = 1 + r2 * (c.k4 + r2 * (c.k5 + r2 * c.k6));
    const double over = 1 / b, under = -l / b;
    const double powers[3] = {r2, r4, r4 * r2};
    *by_coefficients << x * powers[0] * over, x * powers[1] * over, 2 * x * y, r2 + 2 * x * x, x * powers[2] * over,
        x * powers[0] * under, x * powers[1] * under, x * powers[2] * under, r2, r4, 0, 0,  //
        y * powers[0] * over, y * powers[1] * over, r2 + 2 * y * y, 2 * x * y, y * powers[2] * over,
        y * powers[0] * under, y * powers[1] * under, y * powers[2] * under, 0, 0, r2, r4;
  }
  return {value.x, value.y};
}

std::optional<Vector2d> lens_inverse_near(const LensCoefficients& c, const Vector2d& value, const Vector2d& start) {
  Vector2d point = start;
  for (int iteration = 0; iteration < 30; ++iteration) {
    Matrix2d jacobian;
    const Vector2d error = lens_forward(c, point, &jacobian) - value;
    const double determinant = jacobian.determinant();
    if (!(determinant > 0)) return std::nullopt;
    const Vector2d step = jacobian.inverse() * error;
    point -= step;
    if (step.norm() <= 8 * kEpsilon * point.norm()) return point;
    if (!point.allFinite()) return std::nullopt;
  }
  // Steps that only rounding keeps alive are as good.
  const double error = (lens_forward(c, point) - value).norm();
  if (error <= 1e-13 * (value.norm() + point.norm())) return point;
  return std::nullopt;
}

LensMap::LensMap(const LensCoefficients& coefficients) : coefficients_(coefficients) {
  const LensCoefficients& c = coefficients_;
  const bool tangential = c.p1 != 0 || c.p2 != 0 || c.s1 != 0 || c.s2 != 0 || c.s3 != 0 || c.s4 != 0;
  const bool higher = c.k2 != 0 || c.k3 != 0 || c.k4 != 0 || c.k5 != 0 || c.k6 != 0;
  kind_ = tangential ? Kind::general : higher ? Kind::radial : c.k1 != 0 ? Kind::k1 : Kind::identity;
  switch (kind_) {
    case Kind::identity:
      limit_ = kNoLimit;
      break;
    case Kind::k1:
      limit_ = c.k1 > 0 ? kNoLimit : 1 / std::sqrt(-3 * c.k1);
      break;
    default:
      limit_ = limit_of(c);
  }
  if (!std::isfinite(limit_)) {
    limit_mapped_ = kNoLimit;
  } else if (kind_ == Kind::k1) {
    limit_mapped_ = 2 * limit_ / 3;
  } else if (kind_ == Kind::radial) {
    limit_mapped_ = limit_ * radial(c, limit_ * limit_).value;
  } else {
    // The border of the disc, sampled; between two samples the map moves by at most half a step times its slope.
    constexpr int kSamples = 720;
    double nearest = kNoLimit, longest = 0;
    Vector2d previous;
    for (int i = 0; i <= kSamples; ++i) {
      const double angle = 2 * M_PI * i / kSamples;
      const Vector2d mapped = lens_forward(c, limit_ * Vector2d(std::cos(angle), std::sin(angle)));
      nearest = std::min(nearest, mapped.norm());
      if (i > 0) longest = std::max(longest, (mapped - previous).norm());
      previous = mapped;
    }
    limit_mapped_ = std::max(0.0, nearest - longest);
  }
}

std::optional<Vector2d> LensMap::forward(const Vector2d& point, Matrix2d* jacobian) const {
  if (!(point.norm() <= limit_)) return std::nullopt;  // NaN is outside as well
  return lens_forward(coefficients_, point, jacobian);
}

std::optional<double> LensMap::inverse_radius(double mapped) const {
  if (mapped == 0) return 0.0;
  const double k = coefficients_.k1;
  if (kind_ == Kind::k1) {
    const double root = std::sqrt(3 * std::abs(k));
    const double argument = 1.5 * mapped * root;
    if (argument < 1e-8) return mapped;  // the cubic term is below rounding
    if (k > 0) return 2 / root * std::sinh(std::asinh(argument) / 3);
    if (argument > 1) return std::nullopt;
    return 2 / root * std::sin(std::asin(argument) / 3);
  }
  // Bracketed Newton on the increasing function r·L(r²).
  double low = 0;
  double high = limit_;
  if (!std::isfinite(high)) {
    high = mapped;
    for (int i = 0; i < 2000 && high * radial(coefficients_, high * high).value < mapped; ++i) high *= 2;
  }
  if (!(mapped <= high * radial(coefficients_, high * high).value)) return std::nullopt;
  double r = std::min(mapped, high);
  for (int i = 0; i < 200; ++i) {
    const auto [l, dl] = radial(coefficients_, r * r);
    const double error = r * l - mapped;
    (error > 0 ? high : low) = r;
    const double slope = l + 2 * r * r * dl;
    double next = r - error / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - r) <= 2 * kEpsilon * r) return next;
    r = next;
  }
  return r;
}

std::optional<Vector2d> LensMap::inverse_general(const Vector2d& value) const {
  const double target = value.norm();
  LensCoefficients radial_only = coefficients_;
  radial_only.p1 = radial_only.p2 = radial_only.s1 = radial_only.s2 = radial_only.s3 = radial_only.s4 = 0;
  const double border = limit_ * (1 - 1e-12);
  const auto clip = [&](const Vector2d& p) -> Vector2d {
    const double r = p.norm();
    return r > border ? Vector2d(p * (border / r)) : p;
  };
  const double start_radius = inverse_radius(target).value_or(border);
  Vector2d point = target > 0 ? clip(value * (start_radius / target)) : Vector2d::Zero();
  Matrix2d jacobian;
  Vector2d error = lens_forward(coefficients_, point, &jacobian) - value;
  const auto tolerance = [&] { return 4 * kEpsilon * (target + point.norm()); };
  for (int iteration = 0; iteration < 100; ++iteration) {
    if (error.norm() <= tolerance()) return point;
    const Vector2d step = jacobian.inverse() * error;
    double factor = 1;
    Vector2d next, next_error;
    Matrix2d next_jacobian;
    for (int halving = 0; halving < 30; ++halving, factor *= 0.5) {
      next = clip(point - factor * step);
      next_error = lens_forward(coefficients_, next, &next_jacobian) - value;
      if (next_error.norm() < error.norm()) break;
    }
    if (!(next_error.norm() < error.norm())) break;
    point = next;
    error = next_error;
    jacobian = next_jacobian;
  }
  // Rounding ends Newton a few bits above the tolerance.
  if (error.norm() <= 1e-13 * (target + point.norm())) return point;
  if (!std::isfinite(border)) return std::nullopt;
  // At the border. Let the projected iteration decide (its limit is the solution if the disc holds one).
  double slope = 1;
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * M_PI * i / 64;
    Matrix2d j;
    lens_forward(coefficients_, border * Vector2d(std::cos(angle), std::sin(angle)), &j);
    slope = std::max(slope, j.norm());
  }
  for (int iteration = 0; iteration < 20000; ++iteration) {
    const Vector2d next = clip(point - error / slope);
    const double moved = (next - point).norm();
    point = next;
    error = lens_forward(coefficients_, point) - value;
    if (moved <= 1e-15 * point.norm()) break;
  }
  if (const auto polished = lens_inverse_near(coefficients_, value, point)) point = *polished;
  if (point.norm() <= limit_ &&
      (lens_forward(coefficients_, point) - value).norm() <= 1e-12 * (target + point.norm())) {
    return point;
  }
  return std::nullopt;
}

std::optional<Vector2d> LensMap::inverse(const Vector2d& value, Matrix2d* jacobian) const {
  if (!value.allFinite()) return std::nullopt;
  std::optional<Vector2d> point;
  switch (kind_) {
    case Kind::identity:
      point = value;
      break;
    case Kind::general:
      point = inverse_general(value);
      break;
    default: {
      const double mapped = value.norm();
      const auto r = inverse_radius(mapped);
      if (r) point = mapped > 0 ? Vector2d(value * (*r / mapped)) : Vector2d::Zero();
    }
  }
  if (point && jacobian != nullptr) {
    Matrix2d forward;
    lens_forward(coefficients_, *point, &forward);
    *jacobian = forward.inverse();
  }
  return point;
}

}  // namespace horopter::calib
