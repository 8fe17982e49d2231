// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "horopter/calib/edge_profile.hpp"
#include "horopter/calib/random.hpp"

namespace horopter::calib {
namespace {

using Eigen::Vector2d;

// The Gaussian step Φ(t/σ) and its first two antiderivatives.
double step0(double t, double sigma) { return 0.5 * std::erfc(-t / (sigma * std::numbers::sqrt2)); }
double bell(double t, double sigma) { return std::exp(-t * t / (2 * sigma * sigma)) / std::sqrt(2 * std::numbers::pi); }
double step1(double t, double sigma) { return t * step0(t, sigma) + sigma * bell(t, sigma); }
double step2(double t, double sigma) {
  return 0.5 * ((t * t + sigma * sigma) * step0(t, sigma) + t * sigma * bell(t, sigma));
}

/// Where each line of an image begins, px along it.
class LineStarts {
 public:
  LineStarts(const Imaging& imaging, std::uint64_t seed) : jitter_px_(imaging.jitter_px), random_(seed, kStream) {}
  double next() { return jitter_px_ > 0 ? jitter_px_ * random_.gaussian() : 0; }

 private:
  static constexpr std::uint64_t kStream = 1;  ///< the noise has 0
  double jitter_px_;
  Random random_;
};

}  // namespace

double edge_profile(double t, const Vector2d& normal, double blur, double fill) {
  const double reach = 8 * blur + fill;
  if (t > reach) return 1;
  if (t < -reach) return 0;
  // The pixel's square, seen along the edge, is the convolution of two boxes of half widths a >= b.
  const double a = 0.5 * fill * std::max(std::abs(normal.x()), std::abs(normal.y()));
  const double b = 0.5 * fill * std::min(std::abs(normal.x()), std::abs(normal.y()));
  if (a < 1e-4) return step0(t, blur);
  if (b < 1e-4) return (step1(t + a, blur) - step1(t - a, blur)) / (2 * a);
  return (step2(t + a + b, blur) - step2(t + a - b, blur) - step2(t - a + b, blur) + step2(t - a - b, blur)) /
         (4 * a * b);
}

void add_noise(GreyImage& image, const Imaging& imaging, std::uint64_t seed) {
  Random random(seed);
  for (float& value : image.pixels) {
    double v = value;
    if (imaging.noise > 0) v += imaging.noise * random.gaussian();
    if (imaging.quantise) v = std::clamp(std::round(v), 0.0, 255.0);
    value = static_cast<float>(v);
  }
}

GreyImage simulate_edge(int width, int height, const Vector2d& point, const Vector2d& normal, const Imaging& imaging,
                        std::uint64_t seed) {
  GreyImage image(width, height);
  LineStarts starts(imaging, seed);
  for (int y = 0; y < height; ++y) {
    const double start = starts.next();
    for (int x = 0; x < width; ++x)
      image(x, y) = static_cast<float>(imaging.dark + (imaging.bright - imaging.dark) *
                                                          edge_profile(normal.dot(Vector2d(x + start, y) - point),
                                                                       normal, imaging.blur_px, imaging.fill_factor));
  }
  add_noise(image, imaging, seed);
  return image;
}

GreyImage simulate_square(int width, int height, const Vector2d& centre, double side, double angle_deg,
                          const Imaging& imaging, std::uint64_t seed) {
  const double angle = angle_deg * std::numbers::pi / 180;
  const Vector2d u(std::cos(angle), std::sin(angle));
  const Vector2d v(-u.y(), u.x());
  const auto band = [&](double t, const Vector2d& direction) {
    return edge_profile(t + side / 2, direction, imaging.blur_px, imaging.fill_factor) -
           edge_profile(t - side / 2, direction, imaging.blur_px, imaging.fill_factor);
  };
  GreyImage image(width, height);
  LineStarts starts(imaging, seed);
  for (int y = 0; y < height; ++y) {
    const double start = starts.next();
    for (int x = 0; x < width; ++x) {
      const Vector2d p = Vector2d(x + start, y) - centre;
      image(x, y) =
          static_cast<float>(imaging.dark + (imaging.bright - imaging.dark) * band(u.dot(p), u) * band(v.dot(p), v));
    }
  }
  add_noise(image, imaging, seed);
  return image;
}

Eigen::Matrix<double, 2, 4> square_corners(const Vector2d& centre, double side, double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180;
  const Vector2d u(std::cos(angle) * side / 2, std::sin(angle) * side / 2);
  const Vector2d v(-u.y(), u.x());
  Eigen::Matrix<double, 2, 4> corners;
  corners << centre - u - v, centre + u - v, centre + u + v, centre - u + v;
  return corners;
}

}  // namespace horopter::calib
