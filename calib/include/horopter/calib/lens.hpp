// SPDX-License-Identifier: Apache-2.0
// The map of a lens in its plane, its inverse, and where that inverse exists.
//
// One family of maps serves both models. With (x, y) relative to the centre of distortion and r² = x² + y²:
//
//   X = x·L(r²) + 2 p1 x y + p2 (r² + 2 x²) + s1 r² + s2 r⁴      L = (1 + k1 r² + k2 r⁴ + k3 r⁶)
//   Y = y·L(r²) + p1 (r² + 2 y²) + 2 p2 x y + s3 r² + s4 r⁴          / (1 + k4 r² + k5 r⁴ + k6 r⁶)
//
// Brown-Conrady (OpenCV) uses it from undistorted to distorted coordinates in units of the focal length. The thesis
// (6.9 to 6.15) uses it from distorted to undistorted coordinates in mm, with κ1..κ3 = k1..k3, its p1, p2 in the place
// of OpenCV's p2, p1, and its thin prism s1, s2 in the place of s1, s3.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

namespace horopter::calib {

/// In the order of OpenCV's distortion vector. Units: 1/length to the power that makes the term a length.
struct LensCoefficients {
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0, k4 = 0, k5 = 0, k6 = 0, s1 = 0, s2 = 0, s3 = 0, s4 = 0;

  static constexpr int kCount = 12;
  static LensCoefficients from(const std::array<double, kCount>& values);
  std::array<double, kCount> array() const { return {k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4}; }
  friend bool operator==(const LensCoefficients&, const LensCoefficients&) = default;
};

/// The map without any check of its domain. Jacobians are optional: ∂(X, Y)/∂(x, y), and by the coefficients in the
/// order above.
Eigen::Vector2d lens_forward(const LensCoefficients& lens, const Eigen::Vector2d& point,
                             Eigen::Matrix2d* by_point = nullptr,
                             Eigen::Matrix<double, 2, LensCoefficients::kCount>* by_coefficients = nullptr);

/// Newton's method for the inverse from a start that is near, without any check of the domain. Nothing when it does
/// not converge.
std::optional<Eigen::Vector2d> lens_inverse_near(const LensCoefficients& lens, const Eigen::Vector2d& value,
                                                 const Eigen::Vector2d& start);

/// The map on the disc around its centre where it is known to be one to one.
///
/// On that disc the symmetric part of the Jacobian is positive definite, so the map is strictly monotone and has at
/// most one inverse. With k1 alone the radius is exactly 1/√(−3 k1), where the map turns back; with purely radial
/// terms it is the first radius where r·L(r²) turns back; decentring and prism terms enter with a bound on their
/// Jacobian, so that the disc may be a little smaller than possible, never larger.
class LensMap {
 public:
  explicit LensMap(const LensCoefficients& coefficients = {});

  const LensCoefficients& coefficients() const { return coefficients_; }
  /// Radius of the disc, before the map; infinite when nothing turns back.
  double limit_radius() const { return limit_; }
  /// Every point nearer to the centre than this, after the map, has an inverse; infinite likewise. With radial terms
  /// only, no point beyond has one.
  double limit_radius_mapped() const { return limit_mapped_; }

  /// Nothing outside the disc.
  std::optional<Eigen::Vector2d> forward(const Eigen::Vector2d& point, Eigen::Matrix2d* jacobian = nullptr) const;
  /// Nothing where the disc holds no inverse. `jacobian` is that of the inverse.
  ///
  /// k1 alone: closed form (ERRATA of 7.4: sinh and asinh for k1 > 0, sin and asin for k1 < 0). Otherwise Newton with
  /// step control from the radial inverse, which is bracketed. |F(x) − u|² has no stationary point inside the disc
  /// but the solution; should the steps run into the border, the projected iteration x ← P(x − τ(F(x) − u)), which
  /// converges for a strictly monotone map, decides whether there is one.
  std::optional<Eigen::Vector2d> inverse(const Eigen::Vector2d& value, Eigen::Matrix2d* jacobian = nullptr) const;

 private:
  enum class Kind { identity, k1, radial, general };

  std::optional<double> inverse_radius(double mapped) const;
  std::optional<Eigen::Vector2d> inverse_general(const Eigen::Vector2d& value) const;

  LensCoefficients coefficients_;
  Kind kind_ = Kind::identity;
  double limit_ = 0;
  double limit_mapped_ = 0;
};

}  // namespace horopter::calib
