// SPDX-License-Identifier: Apache-2.0
#include "edge_targets.hpp"

#include <algorithm>
#include <string_view>

namespace horopter::cli {

using namespace calib;
using Eigen::Vector2d;

namespace {

constexpr std::array<std::string_view, 5> kOfTheTables{"linear-13", "tabatabai-1d", "tabatabai-2d", "zernike-9",
                                                       "zernike-13"};

}  // namespace

std::vector<Contender> contenders() {
  std::vector<Contender> result;
  for (const EdgeMethod method : all_edge_methods()) {
    // The thesis compares a small and a large support for the interpolation, too.
    if (method == EdgeMethod::linear) {
      EdgeOptions small;
      small.window_px = 9;
      result.push_back({"linear-9", method, small});
      result.push_back({"linear-13", method, {}});
    } else {
      result.push_back({std::string(edge_method_name(method)), method, {}});
    }
  }
  EdgeOptions two;
  two.two_windows = true;
  result.push_back({"zernike-9-two-windows", EdgeMethod::zernike_9, two});
  return result;
}

std::vector<Contender> contenders_of_the_tables() {
  std::vector<Contender> result;
  for (const Contender& one : contenders())
    if (std::ranges::find(kOfTheTables, one.name) != kOfTheTables.end()) result.push_back(one);
  return result;
}

std::unique_ptr<EdgeEstimator> make(const Contender& contender, double blur_px) {
  EdgeOptions options = contender.options;
  options.blur_px = std::max(blur_px, 0.02);
  return make_edge_estimator(contender.method, options);
}

Corners measure_corners(const GreyImage& image, const EdgeEstimator& estimator, const Vector2d& centre, double side,
                        double angle_deg, int points_per_edge) {
  const auto truth = square_corners(centre, side, angle_deg);
  std::array<calib::Line, 4> lines;
  Corners result;
  for (int k = 0; k < 4; ++k) {
    const Vector2d a = truth.col(k);
    const Vector2d b = truth.col((k + 1) % 4);
    const Vector2d inward = (centre - (a + b) / 2).normalized();
    std::vector<Vector2d> points;
    for (const EdgePoint& point : edge_points(image, estimator, a, b, inward, points_per_edge, 9))
      points.push_back(point.position_px);
    const auto line = fit_line(points);
    if (!line || points.size() * 2 < static_cast<std::size_t>(points_per_edge)) return result;
    lines[k] = *line;
  }
  for (int k = 0; k < 4; ++k) {
    const auto corner = intersect(lines[(k + 3) % 4], lines[k]);
    if (!corner) return result;
    result.at[k] = *corner;
  }
  result.found = true;
  return result;
}

Imaging noisy(double blur_px) {
  Imaging imaging;
  imaging.blur_px = blur_px;
  imaging.noise = 1;
  imaging.quantise = true;
  return imaging;
}

}  // namespace horopter::cli
