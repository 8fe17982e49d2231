// SPDX-License-Identifier: Apache-2.0
// The corner of a chessboard as the crossing of two blurred edges.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/least_squares.hpp"
#include "target/steps.hpp"

namespace horopter::calib::detail {
namespace {

using Eigen::Vector2d;

/// Contrast in the window, and amplitude of the saddle it starts with, below which there is no corner; grey levels.
constexpr double kLeastWindowContrast = 10;
constexpr double kLeastAmplitude = 3;
/// Limits of the blur, px.
constexpr double kLeastSigma_px = 0.25;
constexpr double kGreatestSigma_px = 4;

struct Pixel {
  Vector2d p;  ///< from the middle of the window
  double value, weight;
};

struct Window {
  int x = 0, y = 0;  ///< its middle
  std::vector<Pixel> pixels;
  double low = 1e9, high = -1e9;  ///< grey levels
};

/// The pixels around a guess, with a soft border, so that the result does not jump when the window moves by a pixel.
std::optional<Window> window_around(const GreyImage& image, const Vector2d& guess_px, double half_px) {
  if (!guess_px.allFinite()) return std::nullopt;
  const int half = static_cast<int>(std::floor(half_px));
  Window window{static_cast<int>(std::lround(guess_px.x())), static_cast<int>(std::lround(guess_px.y())), {}};
  if (window.x - half < 0 || window.y - half < 0 || window.x + half >= image.width || window.y + half >= image.height)
    return std::nullopt;
  for (int y = -half; y <= half; ++y)
    for (int x = -half; x <= half; ++x) {
      const double distance = std::hypot(x, y) / (half + 0.5);
      if (distance >= 1) continue;
      const double value = image(window.x + x, window.y + y);
      window.pixels.push_back({Vector2d(x, y), value, std::min(1.0, 3 * (1 - distance))});
      window.low = std::min(window.low, value);
      window.high = std::max(window.high, value);
    }
  return window;
}

/// x, y, angle of edge 1, of edge 2, log σ, a, b, gx, gy.
using Parameters = Eigen::Matrix<double, 9, 1>;
constexpr int kLogSigma = 4, kAmplitude = 5, kLevel = 6, kSlope = 7;

/// Square roots of the weights times the distances of the pixels from
/// I = b + g · p + a · erf(d1 / √2σ) · erf(d2 / √2σ), d1 and d2 the distances from the two edges.
struct SaddleResiduals {
  const std::vector<Pixel>& pixels;

  int NumResiduals() const { return static_cast<int>(pixels.size()); }

  template <class T>
  bool operator()(const T* p, T* residuals) const {
    using std::cos, std::erf, std::exp, std::sin;
    const T k = exp(-p[kLogSigma]) / std::numbers::sqrt2;
    const T s1 = sin(p[2]), c1 = cos(p[2]), s2 = sin(p[3]), c2 = cos(p[3]);
    for (const Pixel& pixel : pixels) {
      const T x = pixel.p.x() - p[0], y = pixel.p.y() - p[1];
      const T d1 = c1 * y - s1 * x;  // positive towards along_y
      const T d2 = s2 * x - c2 * y;  // positive towards along_x
      const T value =
          p[kLevel] + p[kSlope] * pixel.p.x() + p[kSlope + 1] * pixel.p.y() + p[kAmplitude] * erf(k * d1) * erf(k * d2);
      *residuals++ = std::sqrt(pixel.weight) * (value - pixel.value);
    }
    return true;
  }
};

/// The amplitude, with its sign, that fits best when all else is as at the start; by a straight line.
double start_amplitude(const std::vector<Pixel>& pixels, const Parameters& start) {
  Parameters unit = start;
  unit[kAmplitude] = 1;
  unit[kLevel] = 0;
  Eigen::VectorXd shape(static_cast<Eigen::Index>(pixels.size())), value = shape;
  SaddleResiduals{pixels}(unit.data(), shape.data());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    shape[row] = shape[row] / std::sqrt(pixels[i].weight) + pixels[i].value;
    value[row] = pixels[i].value;
  }
  const Eigen::VectorXd centred = shape.array() - shape.mean();
  return centred.dot(value) / std::max(1e-9, centred.squaredNorm());
}

}  // namespace

std::optional<Saddle> fit_saddle(const GreyImage& image, const Vector2d& guess_px, const Vector2d& along_x,
                                 const Vector2d& along_y, double half_px) {
  const auto window = window_around(image, guess_px, half_px);
  if (!window || window->high - window->low < kLeastWindowContrast) return std::nullopt;
  const Vector2d start = guess_px - Vector2d(window->x, window->y);
  Parameters p;
  p << start.x(), start.y(), std::atan2(along_x.y(), along_x.x()), std::atan2(along_y.y(), along_y.x()), std::log(0.8),
      0, (window->low + window->high) / 2, 0, 0;
  p[kAmplitude] = start_amplitude(window->pixels, p);
  if (std::abs(p[kAmplitude]) < kLeastAmplitude) return std::nullopt;
  const SaddleResiduals saddle{window->pixels};
  minimise(saddle, {kLogSigma, std::log(kLeastSigma_px), std::log(kGreatestSigma_px)}, p);
  if (!p.allFinite() || p.head<2>().norm() > half_px) return std::nullopt;
  Eigen::VectorXd residuals(saddle.NumResiduals());
  saddle(p.data(), residuals.data());
  double weights = 0;
  for (const Pixel& pixel : window->pixels) weights += pixel.weight;
  return Saddle{Vector2d(window->x + p[0], window->y + p[1]), p[kAmplitude],
                std::sqrt(residuals.squaredNorm() / weights)};
}

}  // namespace horopter::calib::detail
