// SPDX-License-Identifier: Apache-2.0
// Thesis 10.4.5, Fig. 10.4: how many bits the direction and its difference need.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "cli/progress.hpp"
#include "horopter/base/csv.hpp"
#include "horopter/draw/plot.hpp"
#include "horopter/study/direction_resolution.hpp"
#include "horopter/study/series.hpp"
#include "horopter/study/simulation.hpp"
#include "statements.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

struct Variant {
  std::string name;
  int direction_bits = 0;  ///< 0: floating point, of the hardware's gradients
  int difference_bits = 0;
  std::string group;
};

std::vector<Variant> variants() {
  std::vector<Variant> result{{"floating point", 0, 0, ""}};
  for (const int bits : {7, 5, 4, 3, 2, 1}) {
    result.push_back({fmt::format("{} bit after differencing", bits), 8, bits, "after"});
  }
  // A direction of n bits has a difference of n − 1.
  for (const int bits : {7, 6, 5, 4, 3, 2}) {
    result.push_back({fmt::format("{} bit before differencing", bits), bits, bits - 1, "before"});
  }
  return result;
}

constexpr std::array kernels{5, 9};

study::Conditions conditions_of(const StudyScope& scope, double texture_grey) {
  study::Conditions conditions;
  conditions.seed = scope.seed;
  conditions.lighting.deviation_grey = texture_grey;
  if (scope.quick) {
    conditions.camera.width = 320;
    conditions.camera.height = 240;
  }
  return conditions;
}

/// What 8 bits cost against floating point, at D50 from 0.3 to 2 px: of the direction alone, and of the low-pass, which
/// the stages round to whole grey levels, as well.
void rounding(OutputDirectory& directory, const StudyScope& scope, nlohmann::json& result,
              std::vector<std::string>& findings, Statements& statements) {
  constexpr double limit = 0.02;
  constexpr int from = 3;  // tenths of a px
  constexpr int to = 20;
  const auto same_gradients = study::direction_in_floating_point();
  const auto rounded = study::direction_resolution(8, 7);
  std::vector<double> disparities;
  for (int i = 0; i <= 28; ++i) disparities.push_back(0.1 * i);
  Csv table({"texture_grey", "kernel", "d50_px", "loss_of_8_bit_direction", "loss_with_8_bit_lowpass"});
  double direction_most = 0;
  double lowpass_most = 0;
  std::string by_contrast;
  for (const double grey : {6.0, 12.0, 24.0, 40.0}) {
    const study::Simulation simulation(conditions_of(scope, grey), disparities.back());
    std::vector<study::Setting> settings;
    for (const int kernel : kernels) {
      settings.push_back({rounded.get(), {study::Feature::camera}, kernel});
      settings.push_back({same_gradients.get(), {study::Feature::camera}, kernel});
      settings.push_back({&study::criterion("DSAD"), {study::Feature::direction, true}, kernel});
    }
    const auto detections = study::detect(study::photographs(simulation, disparities), settings);
    double most = 0;
    int within_from = from;
    for (std::size_t n = 0; n < kernels.size(); ++n) {
      for (int d = from; d <= to; ++d) {
        const double d50 = 0.1 * d;
        const double error = detections[3 * n].segmentation_error(d50);
        const double direction = error / detections[3 * n + 1].segmentation_error(d50) - 1;
        const double lowpass = error / detections[3 * n + 2].segmentation_error(d50) - 1;
        table << grey << static_cast<double>(kernels[n]) << d50 << direction << lowpass;
        table.end_row();
        direction_most = std::max(direction_most, std::abs(direction));
        most = std::max(most, std::abs(lowpass));
        if (std::abs(lowpass) > limit) within_from = std::max(within_from, d + 1);
      }
    }
    lowpass_most = std::max(lowpass_most, most);
    by_contrast += fmt::format("{}{:g} grey levels {:.1f} %", by_contrast.empty() ? "" : ", ", grey, 100 * most);
    if (within_from > from) by_contrast += fmt::format(" (2 % from {:.1f} px on)", 0.1 * within_from);
    result["rounding"][fmt::format("{:g}", grey)] = {{"largest", most},
                                                     {"within_2_percent_from_px", 0.1 * within_from}};
  }
  directory.write("rounding.csv", table.text());
  findings.push_back(
      fmt::format("5x5 and 9x9, D50 0.3 to 2 px: the 8-bit direction costs at most {:.2f} % against "
                  "floating point from the same gradients; with the low-pass rounded to 8 bits against "
                  "all in floating point, at a texture of {}",
                  100 * direction_most, by_contrast));
  statements.add(
      "10.4.5", "Ours, not the thesis's: 8-bit directions are within 2 % of floating point.",
      fmt::format("5×5 and 9×9, D50 0.3 to 2 px: {:.2f} % from the same gradients. With the rounding of the "
                  "low-pass, which comes before, too: at a texture of {}",
                  100 * direction_most, by_contrast),
      verdict(direction_most <= limit && lowpass_most <= limit, direction_most <= limit),
      "Error within 2 % for every contrast, the low-pass included; partly: directions of the same gradients");
}

}  // namespace

nlohmann::json study_resolution(OutputDirectory& directory, const StudyScope& scope) {
  const study::Conditions conditions = conditions_of(scope, 12);
  const double step_px = scope.quick ? 0.1 : 0.04;
  std::vector<double> disparities;
  const int count = static_cast<int>(std::ceil(study::Detection::kLargest_px / step_px));
  for (int i = 0; i <= count; ++i) disparities.push_back(i * step_px);
  const study::Simulation simulation(conditions, disparities.back());
  const study::ImageSeries series = study::photographs(simulation, disparities);

  const std::vector<Variant> all = variants();
  std::vector<std::unique_ptr<study::Criterion>> made;
  std::vector<study::Setting> settings;
  const auto add = [&](study::Setting setting) {
    for (const int kernel : kernels) {
      setting.kernel = kernel;
      settings.push_back(setting);
    }
  };
  for (const Variant& variant : all) {
    made.push_back(variant.direction_bits == 0
                       ? study::direction_in_floating_point()
                       : study::direction_resolution(variant.direction_bits, variant.difference_bits));
    add({made.back().get(), {study::Feature::camera}});
  }
  Progress progress("image");
  const auto detections =
      study::detect(series, settings, [&](std::size_t done) { progress.show(done, disparities.size()); });
  progress.clear();

  nlohmann::json result;
  result["conditions"] = study::to_json(conditions);
  Csv table({"kernel", "resolution", "direction_bits", "difference_bits", "d50_px", "segmentation_error_px",
             "loss_against_7_bit", "loss_against_floating_point"});
  std::vector<Panel> panels;
  std::vector<std::string> findings;
  for (std::size_t n = 0; n < kernels.size(); ++n) {
    const auto detection = [&](std::size_t variant) -> const study::Detection& {
      return detections[variant * kernels.size() + n];
    };
    Panel after{
        fmt::format("{0}x{0}, reduced after differencing", kernels[n]), "D50, px", "segmentation error, px", {}};
    Panel before{
        fmt::format("{0}x{0}, reduced before differencing", kernels[n]), "D50, px", "segmentation error, px", {}};
    for (std::size_t i = 0; i < all.size(); ++i) {
      Curve curve{all[i].name, {}};
      double largest_loss = -1;
      double loss_at = 0;
      double largest_float = 0;
      for (int d = 1; d <= 20; ++d) {
        const double d50 = 0.1 * d;
        const double error = detection(i).segmentation_error(d50);
        const double loss = error / detection(1).segmentation_error(d50) - 1;
        const double against_float = error / detection(0).segmentation_error(d50) - 1;
        table << std::to_string(kernels[n]) << all[i].name << std::to_string(all[i].direction_bits)
              << std::to_string(all[i].difference_bits) << d50 << error << loss << against_float;
        table.end_row();
        curve.points.emplace_back(d50, error);
        if (d < 3) continue;
        if (loss > largest_loss) {
          largest_loss = loss;
          loss_at = d50;
        }
        largest_float = std::max(largest_float, std::abs(against_float));
      }
      result["losses"][fmt::format("{0}x{0}", kernels[n])][all[i].name] = {
          {"largest_from_0.3_px", largest_loss}, {"at_px", loss_at}, {"against_floating_point", largest_float}};
      if (all[i].group != "before") after.curves.push_back(curve);
      if (all[i].group != "after") before.curves.push_back(curve);
      if (i > 1) {
        findings.push_back(fmt::format("{0}x{0}: {1} cost at most {2:.1f} % against 7 bit, at D50 {3:.1f} px",
                                       kernels[n], all[i].name, 100 * largest_loss, loss_at));
      }
    }
    panels.push_back(std::move(after));
    panels.push_back(std::move(before));
  }
  directory.write("fig-10-4.csv", table.text());
  directory.write("fig-10-4.svg", plot_svg("Fig. 10.4: segmentation error and the bits of the direction", panels, 2));
  result["figures"] = {
      {{"file", "fig-10-4.svg"}, {"title", "Fig. 10.4: segmentation error and the bits of the direction"}}};
  const auto loss = [&](const char* kernel, const char* name) {
    return result["losses"][kernel][name]["largest_from_0.3_px"].get<double>();
  };
  Statements statements;
  const auto enough = [&](const char* kernel, const char* name, const char* statement) {
    const double cost = loss(kernel, name);
    statements.add("10.4.5", statement,
                   fmt::format("{}, {}: costs at most {:.1f} % against 7 bit", kernel, name, 100 * cost),
                   verdict(cost < 0.07, cost < 0.15), "Below 7 % for D50 of 0.3 to 2 px; partly: below 15 %");
  };
  enough("5x5", "4 bit after differencing", "4 bits after differencing are enough.");
  enough("5x5", "5 bit before differencing", "5 bits before differencing are enough.");
  enough("9x9", "3 bit after differencing", "Larger kernels need 3 bits after differencing.");
  enough("5x5", "7 bit before differencing", "Directions of 8 and 7 bits produce the same result.");
  const double after = loss("5x5", "3 bit after differencing");
  const double before = loss("5x5", "4 bit before differencing");
  statements.add("10.4.5", "Reducing after differencing is almost as good as before it with a bit more.",
                 fmt::format("5×5: 3 bit after cost {:.1f} %, 4 bit before {:.1f} %", 100 * after, 100 * before),
                 verdict(std::abs(after - before) < 0.05, std::abs(after - before) < 0.1),
                 "Losses within 5 points; partly: 10");
  rounding(directory, scope, result, findings, statements);
  result["statements"] = statements.json();
  result["findings"] = findings;
  return result;
}

}  // namespace horopter::cli
