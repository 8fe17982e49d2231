// SPDX-License-Identifier: Apache-2.0
// The estimators by name, and where they put their windows.
#include "horopter/calib/edge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "edge/estimators.hpp"

namespace horopter::calib {
namespace {

using Eigen::Vector2d;

struct Named {
  EdgeMethod method;
  std::string_view name;
};
constexpr std::array kNames{
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

}  // namespace

std::optional<EdgeEstimator::Local> detail::AxisEstimator::local(const GreyImage& image, Centre centre,
                                                                 const Vector2d& normal) const {
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

std::span<const EdgeMethod> all_edge_methods() {
  static const auto methods = [] {
    std::array<EdgeMethod, kNames.size()> result{};
    std::transform(kNames.begin(), kNames.end(), result.begin(), [](const Named& n) { return n.method; });
    return result;
  }();
  return methods;
}

std::string_view edge_method_name(EdgeMethod method) {
  for (const Named& named : kNames)
    if (named.method == method) return named.name;
  throw std::invalid_argument("unknown edge method");
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
      return detail::make_linear(window);
    case EdgeMethod::tabatabai_1d:
      return detail::make_tabatabai_1d(window, two);
    case EdgeMethod::tabatabai_2d:
      return detail::make_tabatabai_2d(two);
    case EdgeMethod::zernike_9:
    case EdgeMethod::zernike_13:
      return detail::make_zernike(method, window, two);
    case EdgeMethod::gaussian:
      return detail::make_gaussian(window, options.sigma_px);
    case EdgeMethod::polynomial:
      return detail::make_polynomial(window);
    case EdgeMethod::sigmoid:
      return detail::make_sigmoid(window);
    case EdgeMethod::arctangent:
      return detail::make_arctangent(window);
    case EdgeMethod::spline:
      return detail::make_spline(window);
    case EdgeMethod::maximum_likelihood:
      return detail::make_maximum_likelihood(window, options.blur_px, options.fill_factor);
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

}  // namespace horopter::calib
