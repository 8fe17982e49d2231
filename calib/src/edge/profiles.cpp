// SPDX-License-Identifier: Apache-2.0
// Edges by a curve fitted to, or reconstructed from, the pixels near them (thesis 6.6; Eq. 6.22 to 6.25, 6.33).
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/least_squares.hpp"
#include "edge/estimators.hpp"
#include "horopter/calib/edge_profile.hpp"

namespace horopter::calib::detail {
namespace {

using Eigen::Vector2d;

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
    if (contrast < kLeastContrast) return std::nullopt;
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
    if (!t || !(std::abs(*t) <= radius / 2) || contrast < kLeastContrast) return std::nullopt;
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

/// Distances of the samples from a · shape(α (t − c)) + b, for the parameters a, b, c and log α.
template <class Shape>
struct ShapeResiduals {
  static constexpr int kParameters = 4, kPosition = 2, kLogSlope = 3;

  const std::vector<Sample>& samples;

  int NumResiduals() const { return static_cast<int>(samples.size()); }

  template <class T>
  bool operator()(const T* p, T* residuals) const {
    using std::exp;
    const T slope = exp(p[kLogSlope]);
    for (const Sample& sample : samples) {
      *residuals++ = p[0] * Shape::value(T(slope * (sample.t - p[kPosition]))) + p[1] - sample.value;
    }
    return true;
  }
};

/// Fits a · shape(α (t − c)) + b to the pixels. `Shape` runs from −1 to 1.
template <class Shape>
class ShapeFit final : public ProfileEstimator {
 public:
  ShapeFit(EdgeMethod method, int window) : ProfileEstimator(method, window, false) {}

 private:
  std::optional<double> position(const std::vector<Sample>& samples, const Vector2d& /*normal*/,
                                 double& contrast) const override {
    using Residuals = ShapeResiduals<Shape>;
    const Levels levels = outer_levels(samples, window_px());
    if (levels.contrast() < kLeastContrast) return std::nullopt;
    const double middle = (levels.bright + levels.dark) / 2;
    // Starts where the profile sums to what it sums to.
    double low = 0;
    double high = 0;
    for (const Sample& sample : samples) (sample.value < middle ? low : high) += 1;
    Eigen::Matrix<double, Residuals::kParameters, 1> p(levels.contrast() / 2, middle,
                                                       (low - high) / (low + high) * window_px() * 0.39, std::log(2.0));
    // The samples do not limit the slope of a step without blur.
    minimise(Residuals{samples}, {Residuals::kLogSlope, std::log(0.05), std::log(20.0)}, p);
    contrast = 2 * p[0];
    return p[Residuals::kPosition];
  }
};

/// (eˣ − 1) / (eˣ + 1) = tanh(x / 2), see 6.23.
struct SigmoidShape {
  template <class T>
  static T value(const T& x) {
    using std::tanh;
    return tanh(x * 0.5);
  }
};

/// 6.24
struct ArctangentShape {
  template <class T>
  static T value(const T& x) {
    using std::atan;
    return 2 / std::numbers::pi * atan(x);
  }
};

/// Least-squares cubic B-spline, knots 1.25 px apart with a weak penalty on its third differences; the edge is where
/// its slope is greatest.
class Spline final : public ProfileEstimator {
 public:
  explicit Spline(int window) : ProfileEstimator(EdgeMethod::spline, window, false) {}

 private:
  static constexpr double kKnot_px = 1.25;
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
    const int half_pieces = static_cast<int>(std::ceil((window_px() / 2.0 + std::abs(middle)) / kKnot_px));
    const int pieces = 2 * half_pieces;
    const double start = middle - half_pieces * kKnot_px;
    const int n = pieces + 3;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    for (const Sample& sample : samples) {
      const double at = (sample.t - start) / kKnot_px;
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
        best = start + (piece + u) * kKnot_px;
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
    constexpr double kGolden = 0.6180339887498949;
    double a = high - kGolden * (high - low);
    double b = low + kGolden * (high - low);
    double cost_a = cost(a);
    double cost_b = cost(b);
    while (high - low > 1e-5) {
      if (cost_a < cost_b) {
        high = b;
        b = a;
        cost_b = cost_a;
        a = high - kGolden * (high - low);
        cost_a = cost(a);
      } else {
        low = a;
        a = b;
        cost_a = cost_b;
        b = low + kGolden * (high - low);
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
      return std::exp(-x * x / (2 * sigma_ * sigma_)) / (sigma_ * std::sqrt(2 * std::numbers::pi));
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
      if (contrast < kLeastContrast) return std::nullopt;
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

Estimator make_linear(int window_px) { return std::make_unique<Linear>(window_px); }
Estimator make_polynomial(int window_px) { return std::make_unique<Polynomial>(window_px); }
Estimator make_sigmoid(int window_px) {
  return std::make_unique<ShapeFit<SigmoidShape>>(EdgeMethod::sigmoid, window_px);
}
Estimator make_arctangent(int window_px) {
  return std::make_unique<ShapeFit<ArctangentShape>>(EdgeMethod::arctangent, window_px);
}
Estimator make_spline(int window_px) { return std::make_unique<Spline>(window_px); }
Estimator make_maximum_likelihood(int window_px, double blur_px, double fill_factor) {
  return std::make_unique<MaximumLikelihood>(window_px, blur_px, fill_factor);
}
Estimator make_gaussian(int window_px, double sigma_px) { return std::make_unique<Gaussian>(window_px, sigma_px); }

}  // namespace horopter::calib::detail
