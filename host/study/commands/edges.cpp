// SPDX-License-Identifier: Apache-2.0
// Thesis 6.7: what the estimators of sub-pixel edge positions are worth. Fig. 6.7 (position and blur), Fig. 6.8 (a moved
// target, several blurs), Fig. 6.9 (points per edge); Tables 6.1 and 6.2 are in edge_tables.cpp.
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
#include "edge_tables.hpp"
#include "edge_targets.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using namespace horopter::calib;
using Eigen::Vector2d;

const double kFillFactor = Imaging{}.fill_factor;  ///< of the simulated pixels

/// RMS over the coordinates of the corners of squares at `places`; NaN where no square is found.
double corner_rms_px(const EdgeEstimator& estimator, const std::vector<Vector2d>& places, double angle_deg,
                     double blur_px, int points_per_edge, std::uint64_t seed) {
  double squares = 0;
  int n = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const GreyImage image = simulate_square(121, 121, places[i], kSide_px, angle_deg, noisy(blur_px), seed + i);
    const Corners corners = measure_corners(image, estimator, places[i], kSide_px, angle_deg, points_per_edge);
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
  /// Slope of the error over the position: negative where estimates are drawn to the middle of the window.
  double pull() const {
    double products = 0;
    double squares = 0;
    for (const auto& [position, error] : errors) {
      products += position * error;
      squares += position * position;
    }
    return products / squares;
  }
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
          nlohmann::json& largest = report_.result["largest_error_px"][fmt::format("{:g}", blur)][contender.name];
          largest = std::max(largest.is_null() ? 0 : largest.get<double>(), found.largest);
          if (k == 0) report_.result["pull"][fmt::format("{:g}", blur)][contender.name] = found.pull();
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
          report_.result["moved_rms_px"][target][fmt::format("{:g}", blur)][contender.name] = rms;
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
        report_.result["points_rms_px"][contender.name][std::to_string(points)] = rms;
        curve.points.emplace_back(points, rms);
        if (contender.method == EdgeMethod::zernike_13 && points == 16)
          report_.result["zernike_13_diamond_16_points_rms_px"] = rms;
      }
    }
    report_.table("points.csv", csv);
    report_.plot("points.svg", "Fig. 6.9: 64 px diamond, points per edge", {panel}, 1);
  }

 private:
  void step() { progress_.show(++step_, all_.size() * 4); }

  StudyReport& report_;
  const StudyScope& scope_;
  const std::vector<Contender> all_ = contenders();
  Progress progress_{"edge study: step"};
  std::size_t step_ = 0;
};

std::vector<Statement> of_ideal_edges(const nlohmann::json& result) {
  using namespace measured;
  const auto steepest = [&](const char* method) { return result["steepest_edge_max_error_px"][method].get<double>(); };
  const auto largest = [&](const char* method, const char* blur) {
    return result["largest_error_px"][blur][method].get<double>();
  };
  const auto pull = [&](const char* method) { return result["pull"]["2.2"][method].get<double>(); };
  int gaussian_best = 0;
  constexpr std::array kBlurs{"0.01", "0.4", "0.8", "1.2", "1.8", "2.2"};
  for (const char* blur : kBlurs) {
    double others = INFINITY;
    for (const Contender& other : contenders_of_the_tables())
      others = std::min(others, largest(other.name.c_str(), blur));
    gaussian_best += largest("gaussian", blur) <= others ? 1 : 0;
  }
  return {
      {"Steep edges: Gaussian reconstruction and the Zernike methods have a maximum error of less than 0.08 pxl.",
       {steepest("gaussian"), steepest("zernike-9"), steepest("zernike-13"), kFillFactor, (1 - kFillFactor) / 2},
       "{0:.3f}, {1:.3f} (9×9) and {2:.3f} px (13×13). The simulated pixels see {3:.2f} of their width (blur 0.01 px): "
       "where an edge lies between two of them no method can know, so the limit of any is (1 − {3:.2f})/2 = {4:.3f} px",
       "All below 0.08 px; partly: Gaussian reconstruction or both of Zernike's",
       {first < 0.08 && second < 0.08 && third < 0.08, first < 0.08 || (second < 0.08 && third < 0.08)},
       "Zernike's methods find the place of a steep edge to 0.08 px"},
      {"Steep edges: linear interpolation yields moderate error, Tabatabai's methods the worst, more than 0.15 pxl.",
       {steepest("linear-13"), steepest("tabatabai-1d"), steepest("tabatabai-2d"),
        std::max(steepest("zernike-9"), steepest("zernike-13"))},
       "Linear {:.3f} px, Tabatabai 1 D {:.3f} px, 2 D {:.3f} px",
       "Both of Tabatabai's above 0.15 px, linear below them; partly: one of them above",
       {second > 0.15 && third > 0.15 && first < second && first < third,
        (second > 0.15 || third > 0.15) && first < second && first < third}},
      {"Smooth ramps: the estimated position is shifted towards the center of the support region for Zernike's and "
       "Tabatabai's methods.",
       {pull("zernike-9"), pull("zernike-13"), pull("tabatabai-1d"), pull("tabatabai-2d")},
       "Blur 2.2 px, change of the error by px of position: Zernike {:.3f} and {:.3f}, Tabatabai {:.3f} and {:.3f}",
       "Negative for all; partly: for Zernike's",
       {first < 0 && second < 0 && third < 0 && fourth < 0, first < 0 && second < 0}},
      {"Enlarging the support region also improves the result for smooth ramp edges (Zernike 9 × 9 and 13 × 13).",
       {largest("zernike-9", "1.8"), largest("zernike-13", "1.8")},
       "Blur 1.8 px, largest error of all directions: {:.3f} px and {:.3f} px",
       "At most half of it; partly: smaller",
       {second <= 0.5 * first, second < first},
       "a larger window finds blurred edges better"},
      {"Both linear interpolation and Gaussian reconstruction with large support regions produce very good results for "
       "smooth ramps; linear with 9 pixels does not.",
       {largest("linear-13", "1.8"), largest("gaussian", "1.8"), largest("linear-9", "1.8")},
       "Blur 1.8 px: {:.3f}, {:.3f}, {:.3f} px",
       "Both below 0.05 px and linear with 9 px above both; partly: one of them below",
       {first < 0.05 && second < 0.05 && third > first && third > second, first < 0.05 || second < 0.05}},
      {"The results of the Gaussian reconstruction are better than those obtained by other methods.",
       {gaussian_best, kBlurs.size()},
       "A smaller largest error than the five of Table 6.1 with {} of {} blurs",
       "With all; partly: with half of them",
       {first >= second, 2 * first >= second}}};
}

Statement of_points(const nlohmann::json& result) {
  using namespace measured;
  const auto rms = [&](const char* points) {
    double sum = 0;
    for (const char* method : {"tabatabai-2d", "zernike-9", "zernike-13"})
      sum += result["points_rms_px"][method][points].get<double>() / 3;
    return sum;
  };
  const Term& gained_first = fourth;
  const Term& gained_later = fifth;
  return {"Fig. 6.9: more than 16 subpixel estimations per edge produce only minor improvements of accuracy.",
          {rms("4"), rms("16"), rms("46"), rms("4") - rms("16"), rms("16") - rms("46")},
          "Two-dimensional methods, RMS of the corners: {:.4f} px with 4 points, {:.4f} px with 16, {:.4f} px with 46",
          "At most a fifth better with 46 than with 16 (the text has no number), a third at least with 16 than with 4; "
          "partly: from 16 to 46 a quarter at most of the pixels gained from 4 to 16",
          {third >= 0.8 * second && second <= 0.67 * first, gained_later <= 0.25 * gained_first},
          "more than 16 points an edge hardly improve it"};
}

Statement of_all_methods(const nlohmann::json& result) {
  using namespace measured;
  std::vector<std::string> winners;
  double widest = 0;
  for (const char* target : {"square", "diamond"})
    for (const auto& [blur, of_blur] : result["moved_rms_px"][target].items()) {
      std::string winner;
      double least = INFINITY;
      double most = 0;
      for (const Contender& one : contenders_of_the_tables()) {
        // Profiles along an axis are not for diamonds (6.7.2).
        if (target == std::string("diamond") && (one.name.starts_with("linear") || one.name == "tabatabai-1d"))
          continue;
        if (of_blur[one.name].is_null()) continue;
        const double rms = of_blur[one.name].get<double>();
        if (rms < least) winner = one.name;
        least = std::min(least, rms);
        most = std::max(most, rms);
      }
      widest = std::max(widest, most / least);
      if (std::ranges::find(winners, winner) == winners.end()) winners.push_back(winner);
    }
  return {
      "The discussed subpixel estimation methods do not perform very differently and there is no method that is the "
      "best for all applications.",
      {winners.size(), widest, fmt::format("{}", fmt::join(winners, ", "))},
      "Squares and diamonds at six blurs (Fig. 6.8): best are {2}; the worst has {1:.1f} times the RMS of the best",
      "More than one is best, and none has more than 3 times the RMS of the best; partly: more than one is best",
      {first > 1 && second <= 3, first > 1}};
}

}  // namespace

void study_edges(StudyReport& report, const StudyScope& scope) {
  nlohmann::json& result = report.result;
  result["study"] = "edges";
  result["fill_factor"] = kFillFactor;
  EdgeStudy study(report, scope);
  study.position();
  study.moved();
  study.points();
  report.state("6.7.1", of_ideal_edges(result));
  edge_tables(report, scope);
  report.state("6.7.3", {of_points(result)});
  report.state("6.7.4", {of_all_methods(result)});
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
