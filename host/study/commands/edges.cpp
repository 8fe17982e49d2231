// SPDX-License-Identifier: Apache-2.0
// Thesis 6.7: what the estimators of sub-pixel edge positions are worth. Fig. 6.7 (position and blur), Table 6.1
// (noise), Fig. 6.8 (a moved target, several blurs), Fig. 6.9 (points per edge).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "cli/progress.hpp"
#include "horopter/base/csv.hpp"
#include "horopter/calib/edge.hpp"
#include "horopter/calib/edge_profile.hpp"
#include "horopter/draw/plot.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using namespace horopter::calib;
using Eigen::Vector2d;

/// An estimator as the study names it.
struct Contender {
  std::string name;
  EdgeMethod method;
  EdgeOptions options;
};

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

/// Maximum likelihood knows the blur; nobody else does.
std::unique_ptr<EdgeEstimator> make(const Contender& contender, double blur_px) {
  EdgeOptions options = contender.options;
  options.blur_px = std::max(blur_px, 0.02);
  return make_edge_estimator(contender.method, options);
}

struct Corners {
  std::array<Vector2d, 4> at;
  bool found = false;
  Vector2d centre() const { return (at[0] + at[1] + at[2] + at[3]) / 4; }
};

Corners measure(const GreyImage& image, const EdgeEstimator& estimator, const Vector2d& centre, double side,
                double angle_deg, int points_per_edge) {
  const auto truth = square_corners(centre, side, angle_deg);
  std::array<Line, 4> lines;
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

constexpr std::array blurs_px{0.01, 0.4, 0.8, 1.2, 1.8, 2.2};  // Fig. 6.6
constexpr double side_px = 64;

}  // namespace

nlohmann::json study_edges(OutputDirectory& directory, const StudyScope& scope) {
  const std::uint64_t seed = scope.seed;
  const std::vector<Contender> all = contenders();
  nlohmann::json summary;
  summary["study"] = "edges";
  summary["fill_factor"] = 0.85;
  Progress progress("edge study: step");
  std::size_t step = 0;
  const std::size_t steps = all.size() * 5;

  // ---- Fig. 6.7: noise-free, axis-parallel edge; error against position, for each blur.
  {
    Csv csv({"method", "blur_px", "position_px", "error_px"});
    Csv worst_csv({"method", "blur_px", "angle_deg", "max_error_px", "rms_error_px"});
    std::vector<Panel> panels;
    std::vector<Panel> worst(3);
    for (const Contender& contender : all) {
      progress.show(++step, steps);
      Panel panel{contender.name, "true position, px", "error, px", {}, false};
      std::array<Curve, 3> by_blur;
      for (Curve& curve : by_blur) curve.name = contender.name;
      for (const double blur : blurs_px) {
        const auto estimator = make(contender, blur);
        Curve curve{fmt::format("blur {:g} px", blur), {}};
        for (const auto& [index, degrees] : {std::pair{0, 0.0}, {1, 20.0}, {2, 45.0}}) {
          const Vector2d normal(std::cos(degrees * std::numbers::pi / 180), std::sin(degrees * std::numbers::pi / 180));
          double largest = 0;
          double squares = 0;
          int n = 0;
          const int half = scope.quick ? 5 : 25;
          for (int i = -half; i <= half; ++i) {
            const double position = 0.5 * i / half;
            Imaging imaging;
            imaging.blur_px = blur;
            const GreyImage image = simulate_edge(25, 25, Vector2d(12, 12) + position * normal, normal, imaging);
            const auto found = estimator->estimate(image, Vector2d(12, 12), normal);
            const double error = found ? normal.dot(found->position_px - Vector2d(12, 12)) - position : NAN;
            if (index == 0) {
              csv << contender.name << blur << position << error;
              csv.end_row();
              curve.points.emplace_back(position, error);
            }
            if (!found) continue;
            largest = std::max(largest, std::abs(error));
            squares += error * error;
            ++n;
          }
          worst_csv << contender.name << blur << degrees << largest << std::sqrt(squares / std::max(1, n));
          worst_csv.end_row();
          by_blur[index].points.emplace_back(blur, largest);
          if (index == 0 && blur == blurs_px.front()) summary["steepest_edge_max_error_px"][contender.name] = largest;
        }
        panel.curves.push_back(std::move(curve));
      }
      panels.push_back(std::move(panel));
      for (int k = 0; k < 3; ++k) worst[k].curves.push_back(by_blur[k]);
    }
    for (int k = 0; k < 3; ++k) {
      worst[k].title = std::array{"axis-parallel edge", "edge at 20 degrees", "edge at 45 degrees"}[k];
      worst[k].x_label = "blur (standard deviation), px";
      worst[k].y_label = "largest error, px";
      worst[k].log_y = true;
    }
    directory.write("position.csv", csv.text());
    directory.write("position.svg", plot_svg("Error against position (Fig. 6.7)", panels, 4));
    directory.write("blur.csv", worst_csv.text());
    directory.write("blur.svg", plot_svg("Largest error against blur", worst, 3));
  }

  // ---- Table 6.1: 64 px squares and diamonds, noise of 1 grey level, the same place again and again.
  {
    Csv csv({"target", "method", "sd_x_px", "sd_y_px", "sd_cx_px", "sd_cy_px", "rms_corner_px", "images"});
    const int images = scope.quick ? 4 : 40;
    for (const auto& [target, angle] : {std::pair{"square", 0.0}, {"diamond", 45.0}}) {
      std::vector<GreyImage> series;
      const Vector2d centre(47.31, 47.67);
      const int size = angle == 0 ? 96 : 120;
      const Vector2d middle = angle == 0 ? centre : Vector2d(centre + Vector2d(12, 12));
      for (int i = 0; i < images; ++i) {
        Imaging imaging;
        imaging.blur_px = 0.8;
        imaging.noise = 1;
        imaging.quantise = true;
        series.push_back(simulate_square(size, size, middle, side_px, angle, imaging, seed * 1000 + i));
      }
      const auto truth = square_corners(middle, side_px, angle);
      for (const Contender& contender : all) {
        progress.show(++step, steps);
        const auto estimator = make(contender, 0.8);
        std::vector<Corners> found;
        for (const GreyImage& image : series) {
          const Corners corners = measure(image, *estimator, middle, side_px, angle, 16);
          if (corners.found) found.push_back(corners);
        }
        csv << std::string(target) << contender.name;
        if (found.size() < 2) {
          for (int k = 0; k < 5; ++k) csv << NAN;
        } else {
          const double n = static_cast<double>(found.size());
          std::array<Vector2d, 5> mean;
          for (Vector2d& m : mean) m = Vector2d(0, 0);
          for (const Corners& c : found) {
            for (int k = 0; k < 4; ++k) mean[k] += c.at[k] / n;
            mean[4] += c.centre() / n;
          }
          Vector2d corner(0, 0);
          Vector2d middle_variance(0, 0);
          double rms = 0;
          for (const Corners& c : found) {
            for (int k = 0; k < 4; ++k) {
              corner += (c.at[k] - mean[k]).cwiseAbs2() / (4 * (n - 1));
              rms += (c.at[k] - Vector2d(truth.col(k))).squaredNorm() / (8 * n);
            }
            middle_variance += (c.centre() - mean[4]).cwiseAbs2() / (n - 1);
          }
          csv << std::sqrt(corner.x()) << std::sqrt(corner.y()) << std::sqrt(middle_variance.x())
              << std::sqrt(middle_variance.y()) << std::sqrt(rms);
          summary["noise_sd_px"][target][contender.name] = std::sqrt((corner.x() + corner.y()) / 2);
        }
        csv << static_cast<double>(found.size());
        csv.end_row();
      }
    }
    directory.write("noise.csv", csv.text());
  }

  // ---- Fig. 6.8: a target moved by a part of a pixel a step along y, for several blurs: what the shape of the edge
  // costs.
  {
    Csv csv({"target", "method", "blur_px", "steepness_per_px", "rms_px"});
    std::vector<Panel> panels;
    for (const auto& [target, angle] : {std::pair{"square", 3.0}, {"diamond", 45.0}}) {
      Panel panel{target, "steepness of the ramp, grey levels per px", "RMS of the corners, px", {}, true};
      for (const Contender& contender : all) {
        progress.show(++step, steps);
        Curve curve{contender.name, {}};
        for (const double blur : {2.2, 1.8, 1.2, 0.8, 0.6, 0.4}) {
          const auto estimator = make(contender, blur);
          double squares = 0;
          int n = 0;
          const int images = scope.quick ? 1 : 10;
          for (int i = 0; i < images; ++i) {
            Imaging imaging;
            imaging.blur_px = blur;
            imaging.noise = 1;
            imaging.quantise = true;
            const Vector2d centre(60.27, 60 + static_cast<double>(i) / images);
            const GreyImage image = simulate_square(121, 121, centre, side_px, angle, imaging, seed * 2000 + i);
            const Corners corners = measure(image, *estimator, centre, side_px, angle, 16);
            if (!corners.found) continue;
            const auto truth = square_corners(centre, side_px, angle);
            for (int k = 0; k < 4; ++k) squares += (corners.at[k] - Vector2d(truth.col(k))).squaredNorm() / 2;
            n += 4;
          }
          const double rms = n > 0 ? std::sqrt(squares / n) : NAN;
          const double width = std::sqrt(blur * blur + 0.85 * 0.85 / 12);
          const double steepness = 160 / (std::sqrt(2 * std::numbers::pi) * width);
          csv << std::string(target) << contender.name << blur << steepness << rms;
          csv.end_row();
          curve.points.emplace_back(steepness, rms);
        }
        panel.curves.push_back(std::move(curve));
      }
      panels.push_back(std::move(panel));
    }
    directory.write("series.csv", csv.text());
    directory.write("series.svg", plot_svg("A moved target, noise 1 grey level (Fig. 6.8)", panels, 2));
  }

  // ---- Fig. 6.9: points per edge.
  {
    Csv csv({"method", "points", "rms_px"});
    Panel panel{"noise 1 grey level, blur 0.8 px", "points per edge", "RMS of the corners, px", {}, true};
    const auto zernike =
        std::find_if(all.begin(), all.end(), [](const Contender& c) { return c.method == EdgeMethod::zernike_13; });
    for (const Contender& contender : all) {
      if (contender.method == EdgeMethod::sigmoid || contender.method == EdgeMethod::arctangent ||
          contender.method == EdgeMethod::polynomial || contender.method == EdgeMethod::maximum_likelihood ||
          contender.method == EdgeMethod::spline)
        continue;
      progress.show(++step, steps);
      const auto estimator = make(contender, 0.8);
      Curve curve{contender.name, {}};
      for (const int points : {2, 4, 8, 16, 32, 46}) {
        double squares = 0;
        int n = 0;
        const int images = scope.quick ? 4 : 20;
        for (int i = 0; i < images; ++i) {
          Imaging imaging;
          imaging.blur_px = 0.8;
          imaging.noise = 1;
          imaging.quantise = true;
          const Vector2d centre(60 + (i % 5) / 5.0, 60 + (i % 4) / 4.0);
          const GreyImage image = simulate_square(121, 121, centre, side_px, 45, imaging, seed * 3000 + i);
          const Corners corners = measure(image, *estimator, centre, side_px, 45, points);
          if (!corners.found) continue;
          const auto truth = square_corners(centre, side_px, 45);
          for (int k = 0; k < 4; ++k) squares += (corners.at[k] - Vector2d(truth.col(k))).squaredNorm() / 2;
          n += 4;
        }
        const double rms = n > 0 ? std::sqrt(squares / n) : NAN;
        csv << contender.name << static_cast<double>(points) << rms;
        csv.end_row();
        curve.points.emplace_back(points, rms);
        if (&contender == &*zernike && points == 16) summary["zernike_13_diamond_16_points_rms_px"] = rms;
      }
      panel.curves.push_back(std::move(curve));
    }
    directory.write("points.csv", csv.text());
    directory.write("points.svg", plot_svg("64 px diamond (Fig. 6.9)", {panel}, 1));
  }

  const auto& steepest = summary["steepest_edge_max_error_px"];
  summary["findings"] = {
      fmt::format(
          "Steepest edge, largest error: Zernike 9x9 {:.3f} px, 13x13 {:.3f} px, Gaussian reconstruction {:.3f} px",
          steepest["zernike-9"].get<double>(), steepest["zernike-13"].get<double>(),
          steepest["gaussian"].get<double>()),
      fmt::format(
          "  (thesis: less than 0.08); Tabatabai-Mitchell 1-D {:.3f} px, 2-D {:.3f} px (thesis: more than 0.15)",
          steepest["tabatabai-1d"].get<double>(), steepest["tabatabai-2d"].get<double>()),
      fmt::format("Noise of 1 grey level, 64 px diamond, 16 points an edge, Zernike 13x13: {:.4f} px RMS (thesis: "
                  "0.026, 0.015)",
                  summary["zernike_13_diamond_16_points_rms_px"].get<double>()),
  };
  return summary;
}

}  // namespace horopter::cli
