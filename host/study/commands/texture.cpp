// SPDX-License-Identifier: Apache-2.0
// Thesis 9.1: measures of texture (Tables 9.1, 9.2); study_texture_noise.cpp is 9.2.
#include "texture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "horopter/calib/random.hpp"
#include "horopter/image/image.hpp"
#include "horopter/study/filters.hpp"
#include "horopter/study/simulation.hpp"
#include "horopter/study/texture_measures.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using study::Plane;

constexpr int kBorder = 4;  ///< px that measures reach beyond the image

struct MeanAndDeviation {
  double mean = 0, deviation = 0;
};

std::vector<double> inner(const Plane& plane) {
  std::vector<double> values;
  for (int y = kBorder; y < plane.height - kBorder; ++y) {
    values.insert(values.end(), plane.row(y) + kBorder, plane.row(y) + plane.width - kBorder);
  }
  return values;
}

MeanAndDeviation statistics(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / static_cast<double>(values.size()))};
}

/// Smallest sum, over all thresholds, of the weak pattern's share above and the strong one's share below.
double discrimination_error(std::vector<double> weak, std::vector<double> strong) {
  std::ranges::sort(weak);
  std::ranges::sort(strong);
  const auto n = static_cast<double>(weak.size());
  const auto m = static_cast<double>(strong.size());
  double least = 1;
  std::size_t below = 0;
  for (std::size_t i = 0; i < weak.size(); ++i) {
    while (below < strong.size() && strong[below] <= weak[i]) ++below;
    least = std::min(least, (n - static_cast<double>(i) - 1) / n + static_cast<double>(below) / m);
  }
  return least;
}

/// Random noise of Table 9.1, blurred (0: white), rounded to grey values, with a given mean deviation in 7×7 pixels.
Plane noise_pattern(int size, double deviation, double blur_px, std::uint64_t seed, std::uint64_t number) {
  calib::Random random(seed, number);
  Plane white(size, size);
  for (double& value : white.values) value = random.gaussian();
  std::vector<double> weights;
  for (int i = -3; i <= 3; ++i)
    weights.push_back(blur_px > 0 ? std::exp(-0.5 * i * i / (blur_px * blur_px)) : i == 0 ? 1 : 0);
  const auto blurred = [&](const Plane& from, bool down) {
    Plane to(size, size);
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        for (int i = -3; i <= 3; ++i) {
          const int u = std::clamp(x + (down ? 0 : i), 0, size - 1);
          const int v = std::clamp(y + (down ? i : 0), 0, size - 1);
          to.at(x, y) += weights[static_cast<std::size_t>(i + 3)] * from.at(u, v);
        }
      }
    }
    return to;
  };
  Plane pattern = blurred(blurred(white, false), true);
  const double scale = deviation / statistics(inner(study::deviation_in_window(pattern, 7))).mean;
  for (double& value : pattern.values) value = std::clamp(std::round(128 + scale * value), 0.0, 255.0);
  return pattern;
}

struct Printed {
  const char* name;
  double scale, deviation, error_2, error_3;
};
/// Table 9.1.
constexpr std::array kPrinted{
    Printed{"Std dev 7×7", 1.0, 0.125, 0.003, 0},     Printed{"Std dev 3×3", 0.9, 0.275, 0.19, 0.044},
    Printed{"Kirsch compass", 17, 0.42, 0.44, 0.216}, Printed{"Sobel", 6.8, 0.525, 0.53, 0.32},
    Printed{"Prewitt", 4.7, 0.525, 0.53, 0.32},       Printed{"Roberts", 2.3, 0.56, 0.54, 0.36},
    Printed{"Prewitt compass", 4.2, 0.6, 0.55, 0.35}, Printed{"Laplace", 2.6, 0.72, 0.65, 0.5}};

constexpr double kPatternBlur_px = 0.53;
constexpr const char* kPatternFitted = "the blur of the random noise of Table 9.1 (0.53 px), so that the table is met.";

/// How far the measures are from Table 9.1, and from each other.
struct Departures {
  double scale = 0, deviation = 0, error = 0;  ///< furthest from the table
  double least_gain = 1;                       ///< of the low-pass, gradient operators
  double steadiest = 1;                        ///< relative deviation of a gradient operator
  double bent = 0;                             ///< of a gradient operator's mean, from proportion to the deviation
};

constexpr std::array kStrengths{6.2, 12.2, 18.5};  ///< mean deviations in 7×7 pixels
/// Noise of these strengths.
struct Patterns {
  Plane weak, twice, thrice;
};

/// One measure on one pattern, as Table 9.1 lists it.
struct Entry {
  double mean, relative, error_2, error_3;
  double bent;  ///< how far the mean is from being in proportion to the pattern's strength
};

Entry entry(const study::TextureMeasure& measure, const Patterns& patterns, bool lowpass) {
  const auto values = [&](const Plane& pattern) {
    const Plane plane = measure.of(pattern);
    return inner(lowpass ? study::lowpass(plane) : plane);
  };
  const auto weak = values(patterns.weak);
  const auto twice = values(patterns.twice);
  const auto thrice = values(patterns.thrice);
  const auto [mean, deviation] = statistics(twice);
  const double per_grey = mean / kStrengths[1];
  const double bent = std::max(std::abs(statistics(weak).mean / kStrengths[0] / per_grey - 1),
                               std::abs(statistics(thrice).mean / kStrengths[2] / per_grey - 1));
  return {mean, deviation / mean, discrimination_error(weak, twice), discrimination_error(weak, thrice), bent};
}

/// The table, of noise with a blur; figures for programs go into `result`.
Departures measures(const StudyScope& scope, double blur_px, Csv& table, nlohmann::json& result) {
  const int size = scope.quick ? 256 : 512;
  const auto pattern = [&](std::size_t i) { return noise_pattern(size, kStrengths[i], blur_px, scope.seed, i + 1); };
  const Patterns patterns{pattern(0), pattern(1), pattern(2)};
  Departures departures;
  const auto widen = [](double& furthest, double departure) { furthest = std::max(furthest, std::abs(departure)); };
  double unit = 0;
  for (const study::TextureMeasure& measure : study::texture_measures()) {
    const bool gradient = !measure.name.starts_with("Std");
    const Entry plain = entry(measure, patterns, false);
    const Entry smooth = entry(measure, patterns, true);
    if (unit == 0) unit = plain.mean;
    const Printed& of_thesis = *std::ranges::find(kPrinted, measure.name, &Printed::name);
    table.row(blur_px, measure.name, "none", plain.mean / unit, plain.relative, plain.error_2, plain.error_3,
              of_thesis.scale, of_thesis.deviation, of_thesis.error_2, of_thesis.error_3);
    table.row(blur_px, measure.name, "3x3", smooth.mean / unit, smooth.relative, smooth.error_2, smooth.error_3, "", "",
              "", "");
    for (const auto& [key, one] : {std::pair{"plain", plain}, {"lowpass", smooth}})
      result[measure.name][key] = {{"scale_factor", one.mean / unit},
                                   {"relative_std_dev", one.relative},
                                   {"error_6.2_12.2", one.error_2},
                                   {"error_6.2_18.5", one.error_3}};
    widen(departures.scale, plain.mean / unit / of_thesis.scale - 1);
    widen(departures.deviation, plain.relative / of_thesis.deviation - 1);
    widen(departures.error, plain.error_2 - of_thesis.error_2);
    widen(departures.error, plain.error_3 - of_thesis.error_3);
    if (!gradient) continue;
    departures.least_gain = std::min(departures.least_gain, 1 - smooth.relative / plain.relative);
    departures.steadiest = std::min(departures.steadiest, plain.relative);
    departures.bent = std::max(departures.bent, plain.bent);
  }
  return departures;
}

void state_measures(StudyReport& report, const StudyScope& scope) {
  using namespace measured;
  Csv table({"pattern_blur_px", "measure", "lowpass", "scale_factor", "relative_std_dev", "error_6.2_12.2",
             "error_6.2_18.5", "printed_scale_factor", "printed_relative_std_dev", "printed_error_6.2_12.2",
             "printed_error_6.2_18.5"});
  const Departures white = measures(scope, 0, table, report.result["measures_of_white_noise"]);
  const Departures departures = measures(scope, kPatternBlur_px, table, report.result["measures"]);
  report.table("table-9-1.csv", table);
  report.result["pattern_blur_px"] = kPatternBlur_px;
  report.fitted(kPatternFitted);
  constexpr Term sixth{5, 1, 0};
  const double scale_percent = 100 * departures.scale;
  const double deviation_percent = 100 * departures.deviation;
  report.finding(
      "Table 9.1: scale factors within {:.1f} %, relative deviations within {:.1f} % of the thesis's; of white noise "
      "within {:.0f} % and {:.0f} %",
      scale_percent, deviation_percent, 100 * white.scale, 100 * white.deviation);
  report.state(
      "9.1",
      {{"Table 9.1: scale factor, relative standard deviation and error of eight texture measures on random noise patterns.",
        {100 * white.scale, 100 * white.deviation, white.error, scale_percent, deviation_percent, departures.error,
         kPatternBlur_px},
        "White noise: within {0:.0f} %, {1:.0f} %, {2:.2f}. Noise blurred by {6} px, which was chosen by this table: within "
        "{3:.1f} %, {4:.1f} %, {5:.3f}",
        "White noise within 10 %, 10 % and 0.05; partly: noise with the one fitted number",
        {first <= 10 && second <= 10 && third <= 0.05, fourth <= 10 && fifth <= 10 && sixth <= 0.05}},
       {"The mean of the gradient operators is proportional to the local standard deviation.",
        {100 * departures.bent},
        "Strengths of 6.2, 12.2, 18.5 grey levels: within {:.1f} %",
        "Within 2 % for each; partly: 5 %",
        {first <= 2, first <= 5}},
       {"The variance of the local standard deviation is smaller than that of the gradient operators.",
        {report.result["measures"]["Std dev 7×7"]["plain"]["relative_std_dev"].get<double>(), departures.steadiest},
        "Relative deviation {:.3f} in 7×7; of gradient operators {:.3f} at least",
        "The smaller relative deviation",
        {first < second},
        "the local deviation is the steadiest measure of texture"},
       {"The standard deviation of gradient operators is reduced by subsequent lowpass filtering.",
        {100 * departures.least_gain},
        "3×3: by {:.0f} % at least",
        "By more than 10 % for each; partly: for each at all",
        {first > 10, first > 0}}});
}

/// Table 9.2 of what we have: simulated textures, and photographs.
void surfaces(StudyReport& report, const StudyScope& scope) {
  Csv table({"surface", "local_deviation_mean", "relative_std_dev"});
  const auto add = [&](const std::string& name, const Plane& image) {
    const auto [mean, deviation] = statistics(inner(study::deviation_in_window(image, 7)));
    table.row(name, mean, deviation / mean);
    report.result["surfaces"][name] = {{"local_deviation_mean", mean}, {"relative_std_dev", deviation / mean}};
  };
  for (const auto kind :
       {study::TextureKind::dead_leaves, study::TextureKind::band_noise, study::TextureKind::printed_dots}) {
    study::Conditions conditions;
    conditions.texture.kind = kind;
    conditions.camera.width = 320;
    conditions.camera.height = 240;
    conditions.seed = scope.seed;
    add("simulated " + study::name_of(kind), study::to_plane(study::Simulation(conditions, 0).photograph(0, 0)));
  }
  for (const char* name : {"left01.jpg", "box.png", "fruits.jpg", "baboon.jpg", "building.jpg", "home.jpg"}) {
    const std::filesystem::path path = std::filesystem::path(scope.data) / name;
    if (std::filesystem::exists(path)) add(name, study::to_plane(load_image(path)));
  }
  report.table("table-9-2.csv", table);
}

}  // namespace

void study_texture(StudyReport& report, const StudyScope& scope) {
  state_measures(report, scope);
  surfaces(report, scope);
  texture_against_noise(report, scope);
}

}  // namespace horopter::cli
