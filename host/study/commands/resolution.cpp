// SPDX-License-Identifier: Apache-2.0
// Thesis 10.4.5, Fig. 10.4: how many bits the direction and its difference need.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "conditions.hpp"
#include "horopter/study/direction_resolution.hpp"
#include "horopter/study/series.hpp"
#include "horopter/study/simulation.hpp"
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

constexpr std::array kKernels{5, 9};

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

constexpr int kFrom = 3;  ///< tenths of a px: losses are judged at D50 from here
constexpr int kTo = 20;   ///< to here

/// What 8 bits cost against floating point: of the direction alone, and of the low-pass, which the stages round to
/// whole grey levels, as well.
struct Rounding {
  double direction_percent = 0;
  double lowpass_percent = 0;
  std::string by_contrast;
};

Rounding rounding(StudyReport& report, const StudyScope& scope) {
  constexpr double kLimitPercent = 2;
  const auto same_gradients = study::direction_in_floating_point();
  const auto rounded = study::direction_resolution(8, 7);
  std::vector<double> disparities;
  for (int i = 0; i <= 28; ++i) disparities.push_back(0.1 * i);
  Csv table({"texture_grey", "kernel", "d50_px", "loss_of_8_bit_direction", "loss_with_8_bit_lowpass"});
  Rounding result;
  for (const double grey : {6.0, 12.0, 24.0, 40.0}) {
    const study::Simulation simulation(conditions_of(scope, grey), disparities.back());
    std::vector<study::Setting> settings;
    for (const int kernel : kKernels) {
      settings.push_back({rounded.get(), {study::Feature::camera}, kernel});
      settings.push_back({same_gradients.get(), {study::Feature::camera}, kernel});
      settings.push_back({&study::criterion("DSAD"), {study::Feature::direction, true}, kernel});
    }
    const auto detections = study::detect(study::photographs(simulation, disparities), settings);
    double most = 0;
    int within_from = kFrom;
    for (std::size_t n = 0; n < kKernels.size(); ++n) {
      for (int d = kFrom; d <= kTo; ++d) {
        const double d50 = 0.1 * d;
        const double error = detections[3 * n].segmentation_error(d50);
        const double direction = error / detections[3 * n + 1].segmentation_error(d50) - 1;
        const double lowpass = error / detections[3 * n + 2].segmentation_error(d50) - 1;
        table.row(grey, kKernels[n], d50, direction, lowpass);
        result.direction_percent = std::max(result.direction_percent, 100 * std::abs(direction));
        most = std::max(most, std::abs(lowpass));
        if (100 * std::abs(lowpass) > kLimitPercent) within_from = std::max(within_from, d + 1);
      }
    }
    result.lowpass_percent = std::max(result.lowpass_percent, 100 * most);
    result.by_contrast +=
        fmt::format("{}{:g} grey levels {:.1f} %", result.by_contrast.empty() ? "" : ", ", grey, 100 * most);
    if (within_from > kFrom) result.by_contrast += fmt::format(" (2 % from {:.1f} px on)", 0.1 * within_from);
    report.result["rounding"][fmt::format("{:g}", grey)] = {{"largest", most},
                                                            {"within_2_percent_from_px", 0.1 * within_from}};
  }
  report.table("rounding.csv", table);
  report.finding(
      "5x5 and 9x9, D50 0.3 to 2 px: the 8-bit direction costs at most {:.2f} % against floating point from the same "
      "gradients; with the low-pass rounded to 8 bits against all in floating point, at a texture of {}",
      result.direction_percent, result.by_contrast);
  return result;
}

/// What a resolution costs at D50 from 0.3 to 2 px.
struct Loss {
  double largest = -1;  ///< against 7 bits
  double at_px = 0;
  double against_floating_point = 0;
};

/// Fig. 10.4. `detections`: of every variant, by kernel.
void draw_losses(StudyReport& report, const std::vector<Variant>& all,
                 const std::vector<study::Detection>& detections) {
  Csv table({"kernel", "resolution", "direction_bits", "difference_bits", "d50_px", "segmentation_error_px",
             "loss_against_7_bit", "loss_against_floating_point"});
  std::vector<Panel> panels;
  for (std::size_t n = 0; n < kKernels.size(); ++n) {
    const auto error_of = [&](std::size_t variant, double d50) {
      return detections[variant * kKernels.size() + n].segmentation_error(d50);
    };
    const std::string kernel = fmt::format("{0}x{0}", kKernels[n]);
    const auto panel = [&](const char* order) {
      return Panel{fmt::format("{}, reduced {} differencing", kernel, order),
                   "segmentation disparity D50, px",
                   "segmentation error, px",
                   {}};
    };
    Panel after = panel("after");
    Panel before = panel("before");
    for (std::size_t i = 0; i < all.size(); ++i) {
      Curve curve{all[i].name, {}};
      Loss loss;
      for (int d = 1; d <= kTo; ++d) {
        const double d50 = 0.1 * d;
        const double error = error_of(i, d50);
        const double against_7_bit = error / error_of(1, d50) - 1;
        const double against_float = error / error_of(0, d50) - 1;
        table.row(kKernels[n], all[i].name, all[i].direction_bits, all[i].difference_bits, d50, error, against_7_bit,
                  against_float);
        curve.points.emplace_back(d50, error);
        if (d < kFrom) continue;
        if (against_7_bit > loss.largest) {
          loss.largest = against_7_bit;
          loss.at_px = d50;
        }
        loss.against_floating_point = std::max(loss.against_floating_point, std::abs(against_float));
      }
      report.result["losses"][kernel][all[i].name] = {{"largest_from_0.3_px", loss.largest},
                                                      {"at_px", loss.at_px},
                                                      {"against_floating_point", loss.against_floating_point}};
      if (all[i].group != "before") after.curves.push_back(curve);
      if (all[i].group != "after") before.curves.push_back(curve);
      if (i > 1)
        report.finding("{}: {} cost at most {:.1f} % against 7 bit, at D50 {:.1f} px", kernel, all[i].name,
                       100 * loss.largest, loss.at_px);
    }
    panels.push_back(std::move(after));
    panels.push_back(std::move(before));
  }
  report.table("fig-10-4.csv", table);
  report.plot("fig-10-4.svg", "Fig. 10.4: segmentation error and the bits of the direction", panels, 2);
}

std::vector<Statement> statements(const nlohmann::json& losses, const Rounding& rounding) {
  using namespace measured;
  const auto percent = [&](const char* kernel, const char* name) {
    return 100 * losses[kernel][name]["largest_from_0.3_px"].get<double>();
  };
  const auto enough = [&](const char* kernel, const char* name, const char* quote) -> Statement {
    return {quote,
            {percent(kernel, name), kernel, name},
            "{1}, {2}: costs at most {0:.1f} % against 7 bit",
            "Below 7 % for D50 of 0.3 to 2 px; partly: below 15 %",
            {first < 7, first < 15}};
  };
  const double after = percent("5x5", "3 bit after differencing");
  const double before = percent("5x5", "4 bit before differencing");
  return {enough("5x5", "4 bit after differencing", "4 bits after differencing are enough."),
          enough("5x5", "5 bit before differencing", "5 bits before differencing are enough."),
          enough("9x9", "3 bit after differencing", "Larger kernels need 3 bits after differencing."),
          enough("5x5", "7 bit before differencing", "Directions of 8 and 7 bits produce the same result."),
          {"Reducing after differencing is almost as good as before it with a bit more.",
           {after, before, std::abs(after - before)},
           "5×5: 3 bit after cost {:.1f} %, 4 bit before {:.1f} %",
           "Losses within 5 points; partly: 10",
           {third < 5, third < 10}},
          {"Ours, not the thesis's: 8-bit directions are within 2 % of floating point.",
           {rounding.direction_percent, rounding.lowpass_percent, rounding.by_contrast},
           "5×5 and 9×9, D50 0.3 to 2 px: {0:.2f} % from the same gradients. With the rounding of the low-pass, which "
           "comes before, too: at a texture of {2}",
           "Error within 2 % for every contrast, the low-pass included; partly: directions of the same gradients",
           {first <= 2 && second <= 2, first <= 2}}};
}

}  // namespace

void study_resolution(StudyReport& report, const StudyScope& scope) {
  const study::Conditions conditions = conditions_of(scope, 12);
  report.result["conditions"] = study::to_json(conditions);
  const double step_px = scope.quick ? 0.1 : 0.04;
  std::vector<double> disparities;
  const int count = static_cast<int>(std::ceil(study::Detection::kLargest_px / step_px));
  for (int i = 0; i <= count; ++i) disparities.push_back(i * step_px);
  const study::Simulation simulation(conditions, disparities.back());

  const std::vector<Variant> all = variants();
  std::vector<std::unique_ptr<study::Criterion>> made;
  std::vector<study::Setting> settings;
  for (const Variant& variant : all) {
    made.push_back(variant.direction_bits == 0
                       ? study::direction_in_floating_point()
                       : study::direction_resolution(variant.direction_bits, variant.difference_bits));
    for (const int kernel : kKernels) settings.push_back({made.back().get(), {study::Feature::camera}, kernel});
  }
  draw_losses(report, all, detect("image", study::photographs(simulation, disparities), settings));
  const Rounding rounded = rounding(report, scope);
  report.state("10.4.5", statements(report.result["losses"], rounded));
}

}  // namespace horopter::cli
