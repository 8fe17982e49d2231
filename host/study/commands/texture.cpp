// SPDX-License-Identifier: Apache-2.0
// Thesis 9.1: measures of texture (Tables 9.1, 9.2); study_texture_noise.cpp is 9.2.
#include "texture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "horopter/base/csv.hpp"
#include "horopter/calib/random.hpp"
#include "horopter/image/image.hpp"
#include "horopter/study/filters.hpp"
#include "horopter/study/simulation.hpp"
#include "horopter/study/texture_measures.hpp"
#include "statements.hpp"
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

/// Random noise of Table 9.1, blurred, rounded to grey values, with a given mean deviation in 7×7 pixels.
Plane noise_pattern(int size, double deviation, double blur_px, std::uint64_t seed, std::uint64_t number) {
  calib::Random random(seed, number);
  Plane white(size, size);
  for (double& value : white.values) value = random.gaussian();
  std::vector<double> weights;
  for (int i = -3; i <= 3; ++i) weights.push_back(std::exp(-0.5 * i * i / (blur_px * blur_px)));
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
constexpr std::array printed{
    Printed{"Std dev 7×7", 1.0, 0.125, 0.003, 0},     Printed{"Std dev 3×3", 0.9, 0.275, 0.19, 0.044},
    Printed{"Kirsch compass", 17, 0.42, 0.44, 0.216}, Printed{"Sobel", 6.8, 0.525, 0.53, 0.32},
    Printed{"Prewitt", 4.7, 0.525, 0.53, 0.32},       Printed{"Roberts", 2.3, 0.56, 0.54, 0.36},
    Printed{"Prewitt compass", 4.2, 0.6, 0.55, 0.35}, Printed{"Laplace", 2.6, 0.72, 0.65, 0.5}};

constexpr double kPatternBlur_px = 0.53;

void measures(OutputDirectory& directory, const StudyScope& scope, nlohmann::json& result,
              std::vector<std::string>& findings, Statements& statements) {
  const int size = scope.quick ? 256 : 512;
  const Plane weak = noise_pattern(size, 6.2, kPatternBlur_px, scope.seed, 1);
  const Plane twice = noise_pattern(size, 12.2, kPatternBlur_px, scope.seed, 2);
  const Plane thrice = noise_pattern(size, 18.5, kPatternBlur_px, scope.seed, 3);
  Csv table({"measure", "lowpass", "scale_factor", "relative_std_dev", "error_6.2_12.2", "error_6.2_18.5",
             "printed_scale_factor", "printed_relative_std_dev", "printed_error_6.2_12.2", "printed_error_6.2_18.5"});
  double unit = 0;
  double furthest_scale = 0;
  double furthest_deviation = 0;
  double furthest_error = 0;
  double least_gain = 1;  // of the low-pass, gradient operators
  double steadiest = 1;   // relative deviation of a gradient operator
  for (const study::TextureMeasure& measure : study::texture_measures()) {
    const auto of_thesis = std::ranges::find(printed, measure.name, &Printed::name);
    double plain_deviation = 0;
    for (const bool lowpass : {false, true}) {
      const auto values = [&](const Plane& pattern) {
        const Plane plane = measure.of(pattern);
        return inner(lowpass ? study::lowpass(plane) : plane);
      };
      const auto of_weak = values(weak);
      const auto of_twice = values(twice);
      const auto [mean, deviation] = statistics(of_twice);
      if (unit == 0) unit = mean;
      const double scale = mean / unit;
      const double relative = deviation / mean;
      const double error_2 = discrimination_error(of_weak, of_twice);
      const double error_3 = discrimination_error(of_weak, values(thrice));
      table << measure.name << std::string(lowpass ? "3x3" : "none") << scale << relative << error_2 << error_3;
      if (lowpass) {
        for (int i = 0; i < 4; ++i) table << std::string();
        if (!measure.name.starts_with("Std")) least_gain = std::min(least_gain, 1 - relative / plain_deviation);
      } else {
        plain_deviation = relative;
        if (!measure.name.starts_with("Std")) steadiest = std::min(steadiest, relative);
        furthest_error =
            std::max({furthest_error, std::abs(error_2 - of_thesis->error_2), std::abs(error_3 - of_thesis->error_3)});
        table << of_thesis->scale << of_thesis->deviation << of_thesis->error_2 << of_thesis->error_3;
        furthest_scale = std::max(furthest_scale, std::abs(scale / of_thesis->scale - 1));
        furthest_deviation = std::max(furthest_deviation, std::abs(relative / of_thesis->deviation - 1));
      }
      table.end_row();
      result["measures"][measure.name][lowpass ? "lowpass" : "plain"] = {{"scale_factor", scale},
                                                                         {"relative_std_dev", relative},
                                                                         {"error_6.2_12.2", error_2},
                                                                         {"error_6.2_18.5", error_3}};
    }
  }
  directory.write("table-9-1.csv", table.text());
  result["pattern_blur_px"] = kPatternBlur_px;
  findings.push_back(
      fmt::format("Table 9.1: scale factors within {:.1f} %, relative deviations within {:.1f} % of the "
                  "thesis's",
                  100 * furthest_scale, 100 * furthest_deviation));
  const double window = result["measures"]["Std dev 7×7"]["plain"]["relative_std_dev"];
  statements.add(
      "9.1", "Means, relative deviations and errors of the texture measures are those of Table 9.1.",
      fmt::format("Scale factors within {:.1f} %, relative deviations within {:.1f} %, errors within {:.3f}",
                  100 * furthest_scale, 100 * furthest_deviation, furthest_error),
      verdict(furthest_scale <= 0.1 && furthest_deviation <= 0.1 && furthest_error <= 0.05, furthest_scale <= 0.1),
      "Within 10 %, 10 % and 0.05; partly: scale factors are");
  statements.add(
      "9.1", "The local standard deviation varies less than the gradient operators.",
      fmt::format("Relative deviation {:.3f} in 7×7; of gradient operators {:.3f} at least", window, steadiest),
      verdict(window < steadiest), "The smaller relative deviation");
  statements.add("9.1", "A low-pass after them reduces the deviation of gradient operators.",
                 fmt::format("3×3: by {:.0f} % at least", 100 * least_gain), verdict(least_gain > 0.1, least_gain > 0),
                 "By more than 10 % for each; partly: for each at all");
}

/// Table 9.2 of what we have: simulated textures, and photographs.
void surfaces(OutputDirectory& directory, const StudyScope& scope, nlohmann::json& result) {
  Csv table({"surface", "local_deviation_mean", "relative_std_dev"});
  const auto add = [&](const std::string& name, const Plane& image) {
    const auto [mean, deviation] = statistics(inner(study::deviation_in_window(image, 7)));
    table << name << mean << deviation / mean;
    table.end_row();
    result["surfaces"][name] = {{"local_deviation_mean", mean}, {"relative_std_dev", deviation / mean}};
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
  directory.write("table-9-2.csv", table.text());
}

}  // namespace

nlohmann::json study_texture(OutputDirectory& directory, const StudyScope& scope) {
  nlohmann::json result;
  std::vector<std::string> findings;
  Statements statements;
  measures(directory, scope, result, findings, statements);
  surfaces(directory, scope, result);
  texture_against_noise(directory, scope, result, findings, statements);
  result["statements"] = statements.json();
  result["findings"] = findings;
  return result;
}

}  // namespace horopter::cli
