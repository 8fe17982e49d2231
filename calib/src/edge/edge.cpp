// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/edge.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "horopter/calib/edge_profile.hpp"

namespace horopter::calib {
namespace {

using Eigen::Vector2d;

constexpr double pi = std::numbers::pi;

struct Named {
  EdgeMethod method;
  std::string_view name;
};
constexpr std::array names{
    Named{EdgeMethod::linear, "linear"},
    Named{EdgeMethod::tabatabai_1d, "tabatabai-1d"},
    Named{EdgeMethod::tabatabai_2d, "tabatabai-2d"},
    Named{EdgeMethod::zernike_9, "zernike-9"},
    Named{EdgeMethod::zernike_13, "zernike-13"},
    Named{EdgeMethod::gaussian, "gaussian"},
    Named{EdgeMethod::polynomial, "polynomial"},
    Named{EdgeMethod::sigmoid, "sigmoid"},
    Named{EdgeMethod::arctangent, "arctangent"},
    Named{EdgeMethod::spline, "spline"},
    Named{EdgeMethod::maximum_likelihood, "maximum-likelihood"},
};

// Less contrast than this is no edge: a window of camera noise (1 to 2 grey levels) must not look like one.
constexpr double least_contrast = 4;

// ---------------------------------------------------------------- profiles along x or y

class AxisEstimator : public EdgeEstimator {
 protected:
  using EdgeEstimator::EdgeEstimator;
  /// Position of the edge of a profile, dark to bright, in pixels from its middle sample.
  virtual std::optional<double> position(std::span<const double> profile, double& contrast) const = 0;

 private:
  std::optional<Local> local(const GreyImage& image, Centre centre, const Vector2d& normal) const override {
    const bool along_x = std::abs(normal.x()) >= std::abs(normal.y());
    const int sign = (along_x ? normal.x() : normal.y()) < 0 ? -1 : 1;
    const int half = window_px() / 2;
    std::vector<double> profile;
    for (int i = -half; i <= half; ++i)
      profile.push_back(along_x ? image(centre.x + sign * i, centre.y) : image(centre.x, centre.y + sign * i));
    double contrast = 0;
    const auto offset = position(profile, contrast);
    if (!offset) return std::nullopt;
    return Local{along_x ? Vector2d(sign * *offset, 0) : Vector2d(0, sign * *offset), normal, contrast};
  }
};

class Linear final : public AxisEstimator {
 public:
  explicit Linear(int window) : AxisEstimator(EdgeMethod::linear, window, false) {}

 private:
  std::optional<double> position(std::span<const double> profile, double& contrast) const override {
    const int n = static_cast<int>(profile.size());
    const int side = std::max(1, n / 4);
    double low = 0;
    double high = 0;
    for (int i = 0; i < side; ++i) {
      low += profile[i] / side;
      high += profile[n - 1 - i] / side;
    }
    contrast = high - low;
    if (contrast < least_contrast) return std::nullopt;
    const double middle = (low + high) / 2;
    // Of several crossings (noise) the one nearest to the middle.
    std::optional<double> best;
    for (int i = 0; i + 1 < n; ++i) {
      if (!(profile[i] <= middle && profile[i + 1] > middle)) continue;
      const double at = i + (middle - profile[i]) / (profile[i + 1] - profile[i]) - n / 2;  // NOLINT: whole pixels
      if (!best || std::abs(at) < std::abs(*best)) best = at;
    }
    return best;
  }
};

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
    if (contrast < least_contrast) return std::nullopt;
    return n * levels->dark_share - n / 2;
  }
};

// ---------------------------------------------------------------- moments over a circle

/// Integrals over the part of each pixel that lies in the circle inscribed in the window, which is the unit circle.
struct CirclePixel {
  int x, y;
  double area;    ///< ∫ dx dy
  double mx, my;  ///< ∫ x, ∫ y: first moments, and the real and imaginary part of the mask of A11*
  double m20;     ///< ∫ (2x² + 2y² − 1): the mask of A20
};

std::vector<CirclePixel> circle_pixels(int window) {
  // Strips across x, within each of which the y limits are exact; enough strips make the rest of the error vanish.
  constexpr int strips = 200;
  const double radius = window / 2.0;
  const int half = window / 2;
  std::vector<CirclePixel> result;
  for (int y = -half; y <= half; ++y)
    for (int x = -half; x <= half; ++x) {
      CirclePixel pixel{x, y, 0, 0, 0, 0};
      const double width = 1 / (radius * strips);
      for (int i = 0; i < strips; ++i) {
        const double u = (x - 0.5 + (i + 0.5) / strips) / radius;
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
    if (contrast < least_contrast || direction.dot(normal) < 0.5) return std::nullopt;
    // Area of the segment beyond distance ρ: acos ρ − ρ √(1 − ρ²) = π · share of the brighter level. Monotonous.
    const double area = pi * (1 - levels->dark_share);
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
    a11 *= 2 / pi;
    a20 *= 3 / pi;
    const double magnitude = a11.norm();
    if (magnitude <= 1e-9) return std::nullopt;
    const Vector2d direction = a11 / magnitude;
    const double l = 2.0 / 3.0 * a20 / magnitude;
    if (std::abs(l) >= 0.9 || direction.dot(normal) < 0.5) return std::nullopt;
    // |A11| of a step of height k at distance l is (2/π) · k · ⅔ (1 − l²)^(3/2).
    const double contrast = magnitude * 0.75 * pi / std::pow(1 - l * l, 1.5);
    if (contrast < least_contrast) return std::nullopt;
    return Local{direction * (l * window_px() / 2), direction, contrast};
  }

  std::vector<CirclePixel> pixels_;
};

// ---------------------------------------------------------------- profiles across the edge, from all pixels near it

struct Sample {
  double t;  ///< pixels from the centre of the window, towards the brighter side
  double value;
};

class ProfileEstimator : public EdgeEstimator {
 protected:
  using EdgeEstimator::EdgeEstimator;
  /// Position along the normal, from the pixels of the disc inscribed in the window.
  virtual std::optional<double> position(const std::vector<Sample>& samples, const Vector2d& normal,
                                         double& contrast) const = 0;

 private:
  std::optional<Local> local(const GreyImage& image, Centre centre, const Vector2d& normal) const override {
    const int half = window_px() / 2;
    const double radius = window_px() / 2.0;
    std::vector<Sample> samples;
    for (int y = -half; y <= half; ++y)
      for (int x = -half; x <= half; ++x)
        if (x * x + y * y <= radius * radius)
          samples.push_back({normal.dot(Vector2d(x, y)), image(centre.x + x, centre.y + y)});
    double contrast = 0;
    const auto t = position(samples, normal, contrast);
    if (!t || !(std::abs(*t) <= radius / 2) || contrast < least_contrast) return std::nullopt;
    return Local{normal * *t, normal, contrast};
  }
};

struct Levels {
  double dark, bright;
  double contrast() const { return bright - dark; }
};
/// Means of the outer thirds of the window on either side.
Levels outer_levels(const std::vector<Sample>& samples, int window) {
  double sum[2] = {0, 0};
  int count[2] = {0, 0};
  for (const Sample& sample : samples) {
    if (std::abs(sample.t) < window / 3.0) continue;
    sum[sample.t > 0] += sample.value;
    ++count[sample.t > 0];
  }
  return {sum[0] / std::max(1, count[0]), sum[1] / std::max(1, count[1])};
}

/// Inflexion of the polynomial of degree 3.
class Polynomial final : public ProfileEstimator {
 public:
  explicit Polynomial(int window) : ProfileEstimator(EdgeMethod::polynomial, window, false) {}

 private:
  std::optional<double> position(const std::vector<Sample>& samples, const Vector2d& /*normal*/,
                                 double& contrast) const override {
    Eigen::Matrix4d normal_matrix = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    const double scale = window_px() / 2.0;
    for (const Sample& sample : samples) {
      const double t = sample.t / scale;
      const Eigen::Vector4d row(1, t, t * t, t * t * t);
      normal_matrix += row * row.transpose();
      right += row * sample.value;
    }
    const Eigen::Vector4d a = normal_matrix.ldlt().solve(right);
    contrast = outer_levels(samples, window_px()).contrast();
    if (!(a[3] < 0)) return std::nullopt;  // the slope of a rising edge is steepest at its inflexion
    return -a[2] / (3 * a[3]) * scale;
  }
};

/// a · shape(α (t − c)) + b by Levenberg-Marquardt in a, b, c and log α. `shape` runs from −1 to 1 and gives its
/// derivative too.
template <class Shape>
std::optional<double> fit_shape(const std::vector<Sample>& samples, int window, double slope, const Shape& shape,
                                double& contrast) {
  const Levels levels = outer_levels(samples, window);
  if (levels.contrast() < least_contrast) return std::nullopt;
  Eigen::Vector4d p(levels.contrast() / 2, (levels.bright + levels.dark) / 2, 0, std::log(slope));
  // Start where the profile sums to what it sums to.
  double low = 0;
  double high = 0;
  for (const Sample& sample : samples) (sample.value < p[1] ? low : high) += 1;
  p[2] = (low - high) / (low + high) * window * 0.39;
  const auto normal_equations = [&](const Eigen::Vector4d& at, Eigen::Matrix4d* matrix, Eigen::Vector4d* gradient) {
    double cost = 0;
    const double alpha = std::exp(at[3]);
    for (const Sample& sample : samples) {
      const double u = alpha * (sample.t - at[2]);
      const auto [value, derivative] = shape(u);
      const double residual = at[0] * value + at[1] - sample.value;
      cost += residual * residual;
      if (!matrix) continue;
      const Eigen::Vector4d row(value, 1, -at[0] * derivative * alpha, at[0] * derivative * u);
      *matrix += row * row.transpose();
      *gradient += row * residual;
    }
    return cost;
  };
  double lambda = 1e-3;
  double cost = normal_equations(p, nullptr, nullptr);
  for (int iteration = 0; iteration < 60; ++iteration) {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
    normal_equations(p, &matrix, &gradient);
    bool better = false;
    double step = 0;
    for (int attempt = 0; attempt < 8 && !better; ++attempt) {
      Eigen::Matrix4d damped = matrix;
      // The slope of a step edge is not bounded by the samples: the prior keeps it from running away.
      for (int i = 0; i < 4; ++i) damped(i, i) += lambda * matrix(i, i) + 1e-9;
      const Eigen::Vector4d delta = damped.ldlt().solve(-gradient);
      Eigen::Vector4d next = p + delta;
      next[3] = std::clamp(next[3], std::log(0.05), std::log(20.0));
      next[2] = std::clamp(next[2], -window / 2.0, window / 2.0);
      const double next_cost = normal_equations(next, nullptr, nullptr);
      if (next_cost <= cost) {
        better = true;
        step = std::abs(next[2] - p[2]);
        p = next;
        cost = next_cost;
        lambda = std::max(lambda / 5, 1e-9);
      } else {
        lambda *= 5;
      }
    }
    if (!better || (step < 1e-7 && iteration > 3)) break;
  }
  contrast = 2 * p[0];
  return p[2];
}

struct ShapeValue {
  double value, derivative;
};

class Sigmoid final : public ProfileEstimator {
 public:
  explicit Sigmoid(int window) : ProfileEstimator(EdgeMethod::sigmoid, window, false) {}

 private:
  std::optional<double> position(const std::vector<Sample>& samples, const Vector2d& /*normal*/,
                                 double& contrast) const override {
    // (eˣ − 1) / (eˣ + 1) = tanh(x / 2)
    return fit_shape(
        samples, window_px(), 2.0,
        [](double x) {
          const double value = std::tanh(x / 2);
          return ShapeValue{value, (1 - value * value) / 2};
        },
        contrast);
  }
};

class Arctangent final : public ProfileEstimator {
 public:
  explicit Arctangent(int window) : ProfileEstimator(EdgeMethod::arctangent, window, false) {}

 private:
  std::optional<double> position(const std::vector<Sample>& samples, const Vector2d& /*normal*/,
                                 double& contrast) const override {
    return fit_shape(
        samples, window_px(), 2.0, [](double x) { return ShapeValue{2 / pi * std::atan(x), 2 / pi / (1 + x * x)}; },
        contrast);
  }
};

/// Least-squares cubic B-spline, knots 1.25 px apart with a weak penalty on its third differences; the edge is where
/// its slope is greatest.
class Spline final : public ProfileEstimator {
 public:
  explicit Spline(int window) : ProfileEstimator(EdgeMethod::spline, window, false) {}

 private:
  static constexpr double knot_px = 1.25;
  static std::array<double, 4> basis(double u) {
    const double v = 1 - u;
    return {v * v * v / 6, (3 * u * u * u - 6 * u * u + 4) / 6, (3 * v * v * v - 6 * v * v + 4) / 6, u * u * u / 6};
  }

  std::optional<double> position(const std::vector<Sample>& samples, const Vector2d& /*normal*/,
                                 double& contrast) const override {
    contrast = outer_levels(samples, window_px()).contrast();
    // Knots that lie askew of the edge would pull it: they are centred on what was found, until it stays.
    double middle = 0;
    for (int i = 0; i < 10; ++i) {
      const auto found = steepest(samples, middle);
      if (!found || std::abs(*found) > window_px() / 2.0) return std::nullopt;
      const double step = *found - middle;
      middle = *found;
      if (std::abs(step) < 1e-5) break;
    }
    return middle;
  }

  std::optional<double> steepest(const std::vector<Sample>& samples, double middle) const {
    const int half_pieces = static_cast<int>(std::ceil((window_px() / 2.0 + std::abs(middle)) / knot_px));
    const int pieces = 2 * half_pieces;
    const double start = middle - half_pieces * knot_px;
    const int n = pieces + 3;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    for (const Sample& sample : samples) {
      const double at = (sample.t - start) / knot_px;
      const int piece = std::clamp(static_cast<int>(at), 0, pieces - 1);
      const auto b = basis(at - piece);
      for (int i = 0; i < 4; ++i) {
        right[piece + i] += b[i] * sample.value;
        for (int j = 0; j < 4; ++j) matrix(piece + i, piece + j) += b[i] * b[j];
      }
    }
    const double penalty = 0.01 * static_cast<double>(samples.size()) / n;
    for (int i = 0; i + 3 < n; ++i) {
      const Eigen::Vector4d third(-1, 3, -3, 1);
      matrix.block<4, 4>(i, i) += penalty * third * third.transpose();
    }
    const Eigen::VectorXd c = matrix.ldlt().solve(right);
    // The second derivative is linear between knots: its zero from + to -, where the slope is greatest.
    double best_slope = 0;
    std::optional<double> best;
    for (int piece = 0; piece < pieces; ++piece) {
      const double left = c[piece] - 2 * c[piece + 1] + c[piece + 2];
      const double next = c[piece + 1] - 2 * c[piece + 2] + c[piece + 3];
      if (!(left >= 0 && next < 0)) continue;
      const double u = left / (left - next);
      const double v = 1 - u;
      const double slope = -v * v / 2 * c[piece] + (1.5 * u * u - 2 * u) * c[piece + 1] +
                           (-1.5 * v * v + 2 * v) * c[piece + 2] + u * u / 2 * c[piece + 3];
      if (slope > best_slope) {
        best_slope = slope;
        best = start + (piece + u) * knot_px;
      }
    }
    return best;
  }
};

/// The position whose pattern, of known blur and pixel area, leaves the least squares; levels are eliminated.
class MaximumLikelihood final : public ProfileEstimator {
 public:
  MaximumLikelihood(int window, double blur, double fill)
      : ProfileEstimator(EdgeMethod::maximum_likelihood, window, false), blur_(blur), fill_(fill) {}

 private:
  std::optional<double> position(const std::vector<Sample>& samples, const Vector2d& normal,
                                 double& contrast) const override {
    const auto cost = [&](double at) {
      double n = 0;
      double sp = 0;
      double sv = 0;
      double spp = 0;
      double spv = 0;
      double svv = 0;
      for (const Sample& sample : samples) {
        const double p = edge_profile(sample.t - at, normal, blur_, fill_);
        n += 1;
        sp += p;
        sv += sample.value;
        spp += p * p;
        spv += p * sample.value;
        svv += sample.value * sample.value;
      }
      const double variance = spp - sp * sp / n;
      const double covariance = spv - sp * sv / n;
      contrast = variance > 0 ? covariance / variance : 0;
      return svv - sv * sv / n - (variance > 0 ? covariance * covariance / variance : 0);
    };
    const double limit = window_px() / 3.0;
    double best = 0;
    double best_cost = cost(0);
    for (double at = -limit; at <= limit; at += 0.25)
      if (const double c = cost(at); c < best_cost) {
        best_cost = c;
        best = at;
      }
    double low = best - 0.25;
    double high = best + 0.25;
    constexpr double golden = 0.6180339887498949;
    double a = high - golden * (high - low);
    double b = low + golden * (high - low);
    double cost_a = cost(a);
    double cost_b = cost(b);
    while (high - low > 1e-5) {
      if (cost_a < cost_b) {
        high = b;
        b = a;
        cost_b = cost_a;
        a = high - golden * (high - low);
        cost_a = cost(a);
      } else {
        low = a;
        a = b;
        cost_a = cost_b;
        b = low + golden * (high - low);
        cost_b = cost(b);
      }
    }
    best = (low + high) / 2;
    cost(best);
    return best;
  }

  double blur_;
  double fill_;
};

/// Centre of mass of the derivative of the profile reconstructed by Gaussians (6.25). A two-dimensional part of the
/// image is reconstructed, five lines across the edge one pixel apart, and their mean taken. The profile ends
/// 3 σ before the window does, where the sum of Gaussians would decay.
class Gaussian final : public EdgeEstimator {
 public:
  Gaussian(int window, double sigma) : EdgeEstimator(EdgeMethod::gaussian, window, false), sigma_(sigma) {
    if (window / 2.0 - 3 * sigma < 1.5)
      throw std::invalid_argument("Gaussian reconstruction: window of " + std::to_string(window) + " px is too small");
  }

 private:
  std::optional<Local> local(const GreyImage& image, Centre centre, const Vector2d& normal) const override {
    const double extent = window_px() / 2.0 - 3 * sigma_;
    const int half = window_px() / 2;
    const Vector2d along(-normal.y(), normal.x());
    struct Term {
      double t, weight;
    };
    std::vector<Term> terms;
    // Relative to the mean, which makes the result independent of the offset, wherever the strip leaves the window.
    double mean = 0;
    for (int y = -half; y <= half; ++y)
      for (int x = -half; x <= half; ++x) mean += image(centre.x + x, centre.y + y);
    mean /= window_px() * window_px();
    const auto gauss = [&](double x) {
      return std::exp(-x * x / (2 * sigma_ * sigma_)) / (sigma_ * std::sqrt(2 * pi));
    };
    for (int y = -half; y <= half; ++y)
      for (int x = -half; x <= half; ++x) {
        const Vector2d p(x, y);
        const double s = along.dot(p);
        if (std::abs(s) > 2 + 4 * sigma_) continue;
        double weight = 0;
        for (int line = -2; line <= 2; ++line) weight += gauss(s - line) / 5;
        terms.push_back({normal.dot(p), weight * (image(centre.x + x, centre.y + y) - mean)});
      }
    // Of the Gaussian-reconstructed signal the integral is known: no discrete derivative is needed.
    const auto value = [&](double t) {
      double sum = 0;
      for (const Term& term : terms) sum += term.weight * gauss(t - term.t);
      return sum;
    };
    const auto integral = [&](double from, double to) {
      double sum = 0;
      for (const Term& term : terms)
        sum += term.weight * 0.5 *
               (std::erf((to - term.t) / (sigma_ * std::numbers::sqrt2)) -
                std::erf((from - term.t) / (sigma_ * std::numbers::sqrt2)));
      return sum;
    };
    // ∫ (t − c) f' dt over [c − w, c + w] is w (f(c + w) + f(c − w)) − ∫ f. The window is centred on the edge found, so
    // that cutting the tails of a smooth ramp does not pull it.
    double c = 0;
    double contrast = 0;
    for (int i = 0; i < 12; ++i) {
      const double w = extent - std::abs(c);
      if (w < 1) return std::nullopt;
      const double right = value(c + w);
      const double left = value(c - w);
      contrast = right - left;
      if (contrast < least_contrast) return std::nullopt;
      const double step = (w * (right + left) - integral(c - w, c + w)) / contrast;
      c += step;
      if (std::abs(c) > extent / 2) return std::nullopt;
      if (std::abs(step) < 1e-6) break;
    }
    return Local{normal * c, normal, contrast};
  }

  double sigma_;
};

}  // namespace

std::span<const EdgeMethod> all_edge_methods() {
  static const auto methods = [] {
    std::array<EdgeMethod, names.size()> result{};
    std::transform(names.begin(), names.end(), result.begin(), [](const Named& n) { return n.method; });
    return result;
  }();
  return methods;
}

std::string_view edge_method_name(EdgeMethod method) {
  for (const Named& named : names)
    if (named.method == method) return named.name;
  throw std::invalid_argument("unknown edge method");
}

EdgeMethod edge_method(std::string_view name) {
  std::string known;
  for (const Named& named : names) {
    if (named.name == name) return named.method;
    known += (known.empty() ? "" : ", ") + std::string(named.name);
  }
  throw std::invalid_argument("edge method '" + std::string(name) + "' is not one of " + known);
}

std::unique_ptr<EdgeEstimator> make_edge_estimator(EdgeMethod method, const EdgeOptions& options) {
  const bool nine = method == EdgeMethod::tabatabai_2d || method == EdgeMethod::zernike_9;
  const int window = options.window_px ? options.window_px : nine ? 9 : 13;
  if (window < 5 || window % 2 == 0)
    throw std::invalid_argument("edge window of " + std::to_string(window) + " px: an odd number from 5 is needed");
  if (method == EdgeMethod::tabatabai_2d && window != 9)
    throw std::invalid_argument("the two-dimensional Tabatabai-Mitchell operator is defined on 9x9 pixels only");
  const bool two = options.two_windows;
  switch (method) {
    case EdgeMethod::linear:
      return std::make_unique<Linear>(window);
    case EdgeMethod::tabatabai_1d:
      return std::make_unique<Tabatabai1d>(window, two);
    case EdgeMethod::tabatabai_2d:
      return std::make_unique<Tabatabai2d>(two);
    case EdgeMethod::zernike_9:
    case EdgeMethod::zernike_13:
      return std::make_unique<Zernike>(method, window, two);
    case EdgeMethod::gaussian:
      return std::make_unique<Gaussian>(window, options.sigma_px);
    case EdgeMethod::polynomial:
      return std::make_unique<Polynomial>(window);
    case EdgeMethod::sigmoid:
      return std::make_unique<Sigmoid>(window);
    case EdgeMethod::arctangent:
      return std::make_unique<Arctangent>(window);
    case EdgeMethod::spline:
      return std::make_unique<Spline>(window);
    case EdgeMethod::maximum_likelihood:
      return std::make_unique<MaximumLikelihood>(window, options.blur_px, options.fill_factor);
  }
  throw std::invalid_argument("unknown edge method");
}

std::optional<EdgePoint> EdgeEstimator::estimate(const GreyImage& image, const Vector2d& guess_px,
                                                 const Vector2d& normal) const {
  const int half = window_px_ / 2;
  const auto inside = [&](Centre c) {
    return c.x >= half && c.y >= half && c.x + half < image.width && c.y + half < image.height;
  };
  if (!guess_px.allFinite() || guess_px.cwiseAbs().maxCoeff() > 1e6) return std::nullopt;
  Centre centre{static_cast<int>(std::lround(guess_px.x())), static_cast<int>(std::lround(guess_px.y()))};
  if (!inside(centre)) return std::nullopt;
  auto found = local(image, centre, normal);
  for (int i = 0; i < 3 && found; ++i) {
    // Half a pixel plus a margin: an edge midway between two pixels must not make the window jump to and fro.
    const double across = found->offset_px.dot(normal);
    const Vector2d step = normal * across;
    const int dx = std::abs(step.x()) > 0.6 ? static_cast<int>(std::lround(step.x())) : 0;
    const int dy = std::abs(step.y()) > 0.6 ? static_cast<int>(std::lround(step.y())) : 0;
    if (dx == 0 && dy == 0) break;
    const Centre next{centre.x + dx, centre.y + dy};
    if (!inside(next)) return std::nullopt;
    centre = next;
    found = local(image, centre, normal);
  }
  if (!found) return std::nullopt;
  const Vector2d origin(centre.x, centre.y);
  Vector2d position = origin + found->offset_px;
  if (two_windows_) {
    // With a pull ε, windows at distances d and d − D from the edge see (1 − ε) d and (1 − ε)(d − D).
    const bool along_x = std::abs(normal.x()) >= std::abs(normal.y());
    const double across = found->offset_px.dot(normal);
    const int sign = (across < 0 ? -1 : 1) * ((along_x ? normal.x() : normal.y()) < 0 ? -1 : 1);
    const Centre other{centre.x + (along_x ? sign : 0), centre.y + (along_x ? 0 : sign)};
    if (!inside(other)) return std::nullopt;
    const auto second = local(image, other, normal);
    if (!second) return std::nullopt;
    const double apart = normal.dot(Vector2d(other.x - centre.x, other.y - centre.y));
    const double gain = (across - second->offset_px.dot(normal)) / apart;
    if (!(gain > 0.3 && gain < 2)) return std::nullopt;
    position += normal * (across / gain - across);
  }
  return EdgePoint{position, found->normal, found->contrast};
}

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
