// SPDX-License-Identifier: Apache-2.0
// Thesis 6.7: what the estimators of sub-pixel edge positions are worth. Fig. 6.7 (position and blur), Table 6.1
// (noise), Fig. 6.8 (a moved target, several blurs), Fig. 6.9 (points per edge).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cli/progress.hpp"
#include "horopter/calib/edge.hpp"
#include "horopter/calib/edge_profile.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using namespace horopter::calib;
using Eigen::Vector2d;

const double kFillFactor = Imaging{}.fill_factor;  ///< of the simulated pixels

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

constexpr double kSide_px = 64;

/// As a camera makes it: noise of 1 grey level, 8 bits.
Imaging noisy(double blur_px) {
  Imaging imaging;
  imaging.blur_px = blur_px;
  imaging.noise = 1;
  imaging.quantise = true;
  return imaging;
}

/// RMS over the coordinates of the corners of squares at `places`; NaN where no square is found.
double corner_rms_px(const EdgeEstimator& estimator, const std::vector<Vector2d>& places, double angle_deg,
                     double blur_px, int points_per_edge, std::uint64_t seed) {
  double squares = 0;
  int n = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const GreyImage image = simulate_square(121, 121, places[i], kSide_px, angle_deg, noisy(blur_px), seed + i);
    const Corners corners = measure(image, estimator, places[i], kSide_px, angle_deg, points_per_edge);
    if (!corners.found) continue;
    const auto truth = square_corners(places[i], kSide_px, angle_deg);
    for (int k = 0; k < 4; ++k) squares += (corners.at[k] - Vector2d(truth.col(k))).squaredNorm() / 2;
    n += 4;
  }
  return n > 0 ? std::sqrt(squares / n) : NAN;
}

/// An edge moved across a pixel along its normal, without noise.
struct Sweep {
  std::vector<std::pair<double, double>> errors;  ///< over the position, px
  double largest = 0;
  double rms = 0;
};

Sweep sweep(const EdgeEstimator& estimator, double blur_px, double angle_deg, int half_steps) {
  const Vector2d centre(12, 12);
  const Vector2d normal(std::cos(angle_deg * std::numbers::pi / 180), std::sin(angle_deg * std::numbers::pi / 180));
  Imaging imaging;
  imaging.blur_px = blur_px;
  Sweep result;
  double squares = 0;
  int n = 0;
  for (int i = -half_steps; i <= half_steps; ++i) {
    const double position = 0.5 * i / half_steps;
    const GreyImage image = simulate_edge(25, 25, centre + position * normal, normal, imaging);
    const auto found = estimator.estimate(image, centre, normal);
    const double error = found ? normal.dot(found->position_px - centre) - position : NAN;
    result.errors.emplace_back(position, error);
    if (!found) continue;
    result.largest = std::max(result.largest, std::abs(error));
    squares += error * error;
    ++n;
  }
  result.rms = std::sqrt(squares / std::max(1, n));
  return result;
}

/// The measurements, each of all contenders.
class EdgeStudy {
 public:
  EdgeStudy(StudyReport& report, const StudyScope& scope) : report_(report), scope_(scope) {}

  /// Fig. 6.7: noise-free; the error against the position, for each blur.
  void position() {
    constexpr std::array kBlurs_px{0.01, 0.4, 0.8, 1.2, 1.8, 2.2};  // Fig. 6.6
    constexpr std::array kAngles_deg{0.0, 20.0, 45.0};
    Csv csv({"method", "blur_px", "position_px", "error_px"});
    Csv worst_csv({"method", "blur_px", "angle_deg", "max_error_px", "rms_error_px"});
    std::vector<Panel> panels;
    std::vector<Panel> worst;
    for (const char* title : {"axis-parallel edge", "edge at 20 degrees", "edge at 45 degrees"})
      worst.push_back({title, "blur (standard deviation), px", "largest error, px", {}, true});
    for (const Contender& contender : all_) {
      step();
      Panel& panel = panels.emplace_back(Panel{contender.name, "true position, px", "error, px", {}});
      for (Panel& one : worst) one.curves.push_back({contender.name, {}});
      for (const double blur : kBlurs_px) {
        const auto estimator = make(contender, blur);
        for (std::size_t k = 0; k < kAngles_deg.size(); ++k) {
          const Sweep found = sweep(*estimator, blur, kAngles_deg[k], scope_.quick ? 5 : 25);
          worst_csv.row(contender.name, blur, kAngles_deg[k], found.largest, found.rms);
          worst[k].curves.back().points.emplace_back(blur, found.largest);
          if (k > 0) continue;
          panel.curves.push_back({fmt::format("blur {:g} px", blur), found.errors});
          for (const auto& [position, error] : found.errors) csv.row(contender.name, blur, position, error);
          if (blur == kBlurs_px.front()) report_.result["steepest_edge_max_error_px"][contender.name] = found.largest;
        }
      }
    }
    report_.table("position.csv", csv);
    report_.plot("position.svg", "Fig. 6.7: error of the estimators against the position of an axis-parallel edge",
                 panels, 4);
    report_.table("blur.csv", worst_csv);
    report_.plot("blur.svg", "Largest error of the estimators against blur", worst, 3);
  }

  /// Table 6.1: 64 px squares and diamonds at the same place again and again.
  void noise() {
    constexpr double kBlur_px = 0.8;
    Csv csv({"target", "method", "sd_x_px", "sd_y_px", "sd_cx_px", "sd_cy_px", "rms_corner_px", "images"});
    for (const auto& [target, angle] : {std::pair{"square", 0.0}, {"diamond", 45.0}}) {
      const int size = angle == 0 ? 96 : 120;
      const Vector2d middle = Vector2d(47.31, 47.67) + (angle == 0 ? Vector2d(0, 0) : Vector2d(12, 12));
      std::vector<GreyImage> series;
      for (std::uint64_t i = 0; i < (scope_.quick ? 4 : 40); ++i)
        series.push_back(simulate_square(size, size, middle, kSide_px, angle, noisy(kBlur_px), scope_.seed * 1000 + i));
      for (const Contender& contender : all_) {
        step();
        const auto estimator = make(contender, kBlur_px);
        std::vector<Corners> found;
        for (const GreyImage& image : series) {
          const Corners corners = measure(image, *estimator, middle, kSide_px, angle, 16);
          if (corners.found) found.push_back(corners);
        }
        const Scatter scatter = scatter_of(found, square_corners(middle, kSide_px, angle));
        csv.row(target, contender.name, std::sqrt(scatter.corner.x()), std::sqrt(scatter.corner.y()),
                std::sqrt(scatter.centre.x()), std::sqrt(scatter.centre.y()), scatter.rms, found.size());
        if (found.size() >= 2)
          report_.result["noise_sd_px"][target][contender.name] = std::sqrt(scatter.corner.sum() / 2);
      }
    }
    report_.table("noise.csv", csv);
  }

  /// Fig. 6.8: a target moved by a part of a pixel a step along y, for several blurs: what the shape of the edge costs.
  void moved() {
    Csv csv({"target", "method", "blur_px", "steepness_per_px", "rms_px"});
    std::vector<Panel> panels;
    std::vector<Vector2d> places;
    const int images = scope_.quick ? 1 : 10;
    for (int i = 0; i < images; ++i) places.emplace_back(60.27, 60 + static_cast<double>(i) / images);
    for (const auto& [target, angle] : {std::pair{"square", 3.0}, {"diamond", 45.0}}) {
      Panel panel{target, "steepness of the ramp, grey levels per px", "RMS of the corners, px", {}, true};
      for (const Contender& contender : all_) {
        step();
        Curve& curve = panel.curves.emplace_back(Curve{contender.name, {}});
        for (const double blur : {2.2, 1.8, 1.2, 0.8, 0.6, 0.4}) {
          const double rms = corner_rms_px(*make(contender, blur), places, angle, blur, 16, scope_.seed * 2000);
          const double width = std::sqrt(blur * blur + kFillFactor * kFillFactor / 12);
          const double steepness = 160 / (std::sqrt(2 * std::numbers::pi) * width);
          csv.row(target, contender.name, blur, steepness, rms);
          curve.points.emplace_back(steepness, rms);
        }
      }
      panels.push_back(std::move(panel));
    }
    report_.table("series.csv", csv);
    report_.plot("series.svg", "Fig. 6.8: a moved target, noise 1 grey level", panels, 2);
  }

  /// Fig. 6.9: points per edge.
  void points() {
    constexpr double kBlur_px = 0.8;
    Csv csv({"method", "points", "rms_px"});
    Panel panel{"noise 1 grey level, blur 0.8 px", "points per edge", "RMS of the corners, px", {}, true};
    std::vector<Vector2d> places;
    for (int i = 0; i < (scope_.quick ? 4 : 20); ++i) places.emplace_back(60 + (i % 5) / 5.0, 60 + (i % 4) / 4.0);
    for (const Contender& contender : all_) {
      if (contender.method == EdgeMethod::sigmoid || contender.method == EdgeMethod::arctangent ||
          contender.method == EdgeMethod::polynomial || contender.method == EdgeMethod::maximum_likelihood ||
          contender.method == EdgeMethod::spline)
        continue;
      step();
      const auto estimator = make(contender, kBlur_px);
      Curve& curve = panel.curves.emplace_back(Curve{contender.name, {}});
      for (const int points : {2, 4, 8, 16, 32, 46}) {
        const double rms = corner_rms_px(*estimator, places, 45, kBlur_px, points, scope_.seed * 3000);
        csv.row(contender.name, points, rms);
        curve.points.emplace_back(points, rms);
        if (contender.method == EdgeMethod::zernike_13 && points == 16)
          report_.result["zernike_13_diamond_16_points_rms_px"] = rms;
      }
    }
    report_.table("points.csv", csv);
    report_.plot("points.svg", "Fig. 6.9: 64 px diamond, points per edge", {panel}, 1);
  }

 private:
  /// Variances in x and y of the corners and of the centre, and the corners' RMS distance from the truth; NaN of fewer
  /// than two squares.
  struct Scatter {
    Vector2d corner{NAN, NAN}, centre{NAN, NAN};
    double rms = NAN;
  };
  static Scatter scatter_of(const std::vector<Corners>& found, const Eigen::Matrix<double, 2, 4>& truth) {
    if (found.size() < 2) return {};
    const double n = static_cast<double>(found.size());
    std::array<Vector2d, 4> mean;
    mean.fill(Vector2d(0, 0));
    Vector2d mean_centre(0, 0);
    for (const Corners& c : found) {
      for (int k = 0; k < 4; ++k) mean[k] += c.at[k] / n;
      mean_centre += c.centre() / n;
    }
    Vector2d corner(0, 0);
    Vector2d centre(0, 0);
    double rms = 0;
    for (const Corners& c : found) {
      for (int k = 0; k < 4; ++k) {
        corner += (c.at[k] - mean[k]).cwiseAbs2() / (4 * (n - 1));
        rms += (c.at[k] - Vector2d(truth.col(k))).squaredNorm() / (8 * n);
      }
      centre += (c.centre() - mean_centre).cwiseAbs2() / (n - 1);
    }
    return {corner, centre, std::sqrt(rms)};
  }

  void step() { progress_.show(++step_, all_.size() * 5); }

  StudyReport& report_;
  const StudyScope& scope_;
  const std::vector<Contender> all_ = contenders();
  Progress progress_{"edge study: step"};
  std::size_t step_ = 0;
};

}  // namespace

void study_edges(StudyReport& report, const StudyScope& scope) {
  nlohmann::json& result = report.result;
  result["study"] = "edges";
  result["fill_factor"] = kFillFactor;
  EdgeStudy study(report, scope);
  study.position();
  study.noise();
  study.moved();
  study.points();
  const auto steepest = [&](const char* method) { return result["steepest_edge_max_error_px"][method].get<double>(); };
  report.finding(
      "Steepest edge, largest error: Zernike 9x9 {:.3f} px, 13x13 {:.3f} px, Gaussian reconstruction {:.3f} px",
      steepest("zernike-9"), steepest("zernike-13"), steepest("gaussian"));
  report.finding("  (thesis: less than 0.08); Tabatabai-Mitchell 1-D {:.3f} px, 2-D {:.3f} px (thesis: more than 0.15)",
                 steepest("tabatabai-1d"), steepest("tabatabai-2d"));
  report.finding(
      "Noise of 1 grey level, 64 px diamond, 16 points an edge, Zernike 13x13: {:.4f} px RMS (thesis: 0.026, 0.015)",
      result["zernike_13_diamond_16_points_rms_px"].get<double>());
}

}  // namespace horopter::cli
