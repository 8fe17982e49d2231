// SPDX-License-Identifier: Apache-2.0
// Edges by moments of the grey levels (thesis 6.6; Eq. 6.26, 6.28, 6.30).
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "edge/estimators.hpp"

namespace horopter::calib::detail {
namespace {

using Eigen::Vector2d;

/// Share of the darker level, and both levels, from the first three moments of the grey levels [48].
struct TwoLevels {
  double dark_share, dark, bright;
};
std::optional<TwoLevels> two_levels(double m1, double m2, double m3) {
  const double variance = m2 - m1 * m1;
  if (variance <= 1e-9) return std::nullopt;
  const double deviation = std::sqrt(variance);
  const double skew = (m3 + 2 * m1 * m1 * m1 - 3 * m1 * m2) / (variance * deviation);
  const double share = 0.5 * (1 + skew / std::sqrt(4 + skew * skew));
  if (share <= 0 || share >= 1) return std::nullopt;
  return TwoLevels{share, m1 - deviation * std::sqrt((1 - share) / share),
                   m1 + deviation * std::sqrt(share / (1 - share))};
}

class Tabatabai1d final : public AxisEstimator {
 public:
  Tabatabai1d(int window, bool two) : AxisEstimator(EdgeMethod::tabatabai_1d, window, two) {}

 private:
  std::optional<double> position(std::span<const double> profile, double& contrast) const override {
    const double n = static_cast<double>(profile.size());
    const double origin = profile[profile.size() / 2];  // keeps the third moment free of cancellation
    double m1 = 0;
    double m2 = 0;
    double m3 = 0;
    for (const double value : profile) {
      const double v = value - origin;
      m1 += v / n;
      m2 += v * v / n;
      m3 += v * v * v / n;
    }
    const auto levels = two_levels(m1, m2, m3);
    if (!levels || profile.back() <= profile.front()) return std::nullopt;
    contrast = levels->bright - levels->dark;
    if (contrast < kLeastContrast) return std::nullopt;
    return n * levels->dark_share - n / 2;
  }
};

/// Integrals over the part of each pixel that lies in the circle inscribed in the window, which is the unit circle.
struct CirclePixel {
  int x, y;
  double area;    ///< ∫ dx dy
  double mx, my;  ///< ∫ x, ∫ y: first moments, and the real and imaginary part of the mask of A11*
  double m20;     ///< ∫ (2x² + 2y² − 1): the mask of A20
};

std::vector<CirclePixel> circle_pixels(int window) {
  // Strips across x, within each of which the y limits are exact; enough strips make the rest of the error vanish.
  constexpr int kStrips = 200;
  const double radius = window / 2.0;
  const int half = window / 2;
  std::vector<CirclePixel> result;
  for (int y = -half; y <= half; ++y)
    for (int x = -half; x <= half; ++x) {
      CirclePixel pixel{x, y, 0, 0, 0, 0};
      const double width = 1 / (radius * kStrips);
      for (int i = 0; i < kStrips; ++i) {
        const double u = (x - 0.5 + (i + 0.5) / kStrips) / radius;
        if (std::abs(u) >= 1) continue;
        const double limit = std::sqrt(1 - u * u);
        const double low = std::max((y - 0.5) / radius, -limit);
        const double high = std::min((y + 0.5) / radius, limit);
        if (high <= low) continue;
        const double length = high - low;
        const double square = (high * high * high - low * low * low) / 3;
        pixel.area += width * length;
        pixel.mx += width * length * u;
        pixel.my += width * (high * high - low * low) / 2;
        pixel.m20 += width * ((2 * u * u - 1) * length + 2 * square);
      }
      if (pixel.area > 0) result.push_back(pixel);
    }
  return result;
}

class Tabatabai2d final : public EdgeEstimator {
 public:
  explicit Tabatabai2d(bool two) : EdgeEstimator(EdgeMethod::tabatabai_2d, 9, two) {
    double sum = 0;
    for (CirclePixel pixel : circle_pixels(9)) {
      // Rows of 5, 7, 9, 9, 9, 9, 9, 7, 5: the 69 pixels of [48]; the slivers of eight more are left out.
      if (std::abs(pixel.x) + std::abs(pixel.y) > 6) continue;
      pixels_.push_back(pixel);
      sum += pixel.area;
    }
    for (CirclePixel& pixel : pixels_) pixel.area /= sum;
  }

 private:
  std::optional<Local> local(const GreyImage& image, Centre centre, const Vector2d& normal) const override {
    const double origin = image(centre.x, centre.y);
    double m1 = 0;
    double m2 = 0;
    double m3 = 0;
    Vector2d gravity(0, 0);
    for (const CirclePixel& pixel : pixels_) {
      const double v = image(centre.x + pixel.x, centre.y + pixel.y) - origin;
      m1 += pixel.area * v;
      m2 += pixel.area * v * v;
      m3 += pixel.area * v * v * v;
      gravity += Vector2d(pixel.x, pixel.y) * (pixel.area * v);
    }
    const auto levels = two_levels(m1, m2, m3);
    if (!levels || gravity.norm() <= 0) return std::nullopt;
    const double contrast = levels->bright - levels->dark;
    const Vector2d direction = gravity.normalized();
    if (contrast < kLeastContrast || direction.dot(normal) < 0.5) return std::nullopt;
    // Area of the segment beyond distance ρ: acos ρ − ρ √(1 − ρ²) = π · share of the brighter level. Monotonous.
    const double area = std::numbers::pi * (1 - levels->dark_share);
    double low = -1;
    double high = 1;
    for (int i = 0; i < 50; ++i) {
      const double rho = (low + high) / 2;
      (std::acos(rho) - rho * std::sqrt(1 - rho * rho) > area ? low : high) = rho;
    }
    return Local{direction * ((low + high) / 2 * 4.5), direction, contrast};
  }

  std::vector<CirclePixel> pixels_;
};

class Zernike final : public EdgeEstimator {
 public:
  Zernike(EdgeMethod method, int window, bool two)
      : EdgeEstimator(method, window, two), pixels_(circle_pixels(window)) {
    // A constant image has no edge: what the numeric integrals of the masks leave over is taken out of A20.
    double m20 = 0;
    double area = 0;
    for (const CirclePixel& pixel : pixels_) {
      m20 += pixel.m20;
      area += pixel.area;
    }
    for (CirclePixel& pixel : pixels_) pixel.m20 -= m20 / area * pixel.area;
  }

 private:
  std::optional<Local> local(const GreyImage& image, Centre centre, const Vector2d& normal) const override {
    Vector2d a11(0, 0);  // of the conjugate of A11, which points to the brighter side
    double a20 = 0;
    for (const CirclePixel& pixel : pixels_) {
      const double v = image(centre.x + pixel.x, centre.y + pixel.y);
      a11 += Vector2d(pixel.mx, pixel.my) * v;
      a20 += pixel.m20 * v;
    }
    a11 *= 2 / std::numbers::pi;
    a20 *= 3 / std::numbers::pi;
    const double magnitude = a11.norm();
    if (magnitude <= 1e-9) return std::nullopt;
    const Vector2d direction = a11 / magnitude;
    const double l = 2.0 / 3.0 * a20 / magnitude;
    if (std::abs(l) >= 0.9 || direction.dot(normal) < 0.5) return std::nullopt;
    // |A11| of a step of height k at distance l is (2/π) · k · ⅔ (1 − l²)^(3/2).
    const double contrast = magnitude * 0.75 * std::numbers::pi / std::pow(1 - l * l, 1.5);
    if (contrast < kLeastContrast) return std::nullopt;
    return Local{direction * (l * window_px() / 2), direction, contrast};
  }

  std::vector<CirclePixel> pixels_;
};

}  // namespace

Estimator make_tabatabai_1d(int window_px, bool two_windows) {
  return std::make_unique<Tabatabai1d>(window_px, two_windows);
}
Estimator make_tabatabai_2d(bool two_windows) { return std::make_unique<Tabatabai2d>(two_windows); }
Estimator make_zernike(EdgeMethod method, int window_px, bool two_windows) {
  return std::make_unique<Zernike>(method, window_px, two_windows);
}

}  // namespace horopter::calib::detail
