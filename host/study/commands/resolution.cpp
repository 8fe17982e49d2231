// SPDX-License-Identifier: Apache-2.0
// Thesis 10.4.5, Fig. 10.4: how many bits the direction and its difference need.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
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

constexpr std::array kKernels{5, 9, 13};

/// Footnote 33: the image material of chapter 8; with another contrast.
study::Conditions conditions_of(const StudyScope& scope, double texture_grey) {
  study::Conditions conditions = chapter8_conditions(scope);
  conditions.lighting.deviation_grey = texture_grey;
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
      "5x5 to 13x13, D50 0.3 to 2 px: the 8-bit direction costs at most {:.2f} % against floating point from the same "
      "gradients; with the low-pass rounded to 8 bits against all in floating point, at a texture of {}",
      result.direction_percent, result.by_contrast);
  return result;
}

/// What a resolution costs at D50 from 0.3 to 2 px.
struct Loss {
  double largest = -1;  ///< against 7 bits
  double largest_px = 0;
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
        loss.largest_px = std::max(loss.largest_px, error - error_of(1, d50));
        if (against_7_bit > loss.largest) {
          loss.largest = against_7_bit;
          loss.at_px = d50;
        }
        loss.against_floating_point = std::max(loss.against_floating_point, std::abs(against_float));
      }
      report.result["losses"][kernel][all[i].name] = {{"largest_from_0.3_px", loss.largest},
                                                      {"largest_px", loss.largest_px},
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

/// How far directions of two photographs of the same place are apart.
struct Noise {
  double below_45_percent = 0, below_22_percent = 0;  ///< shares of differences below π/4 and π/8
  double mean_deg = 0;
};

Noise direction_noise(const Image& left, const Image& right) {
  const study::Plane a = study::prepare(left, {study::Feature::direction, true});
  const study::Plane b = study::prepare(right, {study::Feature::direction, true});
  Noise result;
  double count = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double turn = std::abs(std::remainder(a.values[i] - b.values[i], 1.0));
    if (std::isnan(turn)) continue;
    result.below_45_percent += 8 * turn < 1 ? 100 : 0;
    result.below_22_percent += 16 * turn < 1 ? 100 : 0;
    result.mean_deg += 360 * turn;
    ++count;
  }
  result.below_45_percent /= count;
  result.below_22_percent /= count;
  result.mean_deg /= count;
  return result;
}

/// Largest error, degrees, over all gradients, of directions from gradients reduced as for the table.
double table_error_deg() {
  // 10 bits and a sign: the common largest value loses its two upper bits by a shift of 0, 1 or 2.
  constexpr int kLargest = 1020;
  constexpr int kKept = 256;
  double largest = 0;
  for (int y = 0; y <= kLargest; ++y)
    for (int x = std::max(1, y); x <= kLargest; ++x) {  // the other octants mirror this one
      int shift = 0;
      while (x >> shift >= kKept) ++shift;
      if (shift == 0) continue;
      const double error = std::atan2(y, x) - std::atan2(y >> shift, x >> shift);
      largest = std::max(largest, std::abs(error) * 180 / std::numbers::pi);
    }
  return largest;
}

std::vector<Statement> resolutions(const nlohmann::json& losses) {
  using namespace measured;
  const auto percent = [&](const std::string& kernel, int bits, const char* order) {
    return 100 *
           losses[kernel][fmt::format("{} bit {} differencing", bits, order)]["largest_from_0.3_px"].get<double>();
  };
  const auto px = [&](const std::string& kernel, int bits, const char* order) {
    return losses[kernel][fmt::format("{} bit {} differencing", bits, order)]["largest_px"].get<double>();
  };
  const char* const rule = "At most 7 % more error than 7 bits, for D50 of 0.3 to 2 px; partly: 15 %";
  const auto enough = [&](const char* quote, int bits, const char* order) -> Statement {
    return {quote,
            {percent("5x5", bits, order), bits, order},
            "5×5, {1} bit {2} differencing: costs at most {0:.1f} %",
            rule,
            {first <= 7, first <= 15}};
  };
  int close = 0;
  std::string pairs;
  for (int bits = 2; bits <= 5; ++bits) {
    const double after = percent("5x5", bits, "after");
    const double before = percent("5x5", bits + 1, "before");
    close += std::abs(after - before) <= 5 ? 1 : 0;
    pairs += fmt::format("{}{} bit after {:.1f} %, {} bit before {:.1f} %", pairs.empty() ? "" : "; ", bits, after,
                         bits + 1, before);
  }
  Statement four = enough(
      "Fig. 10.4: there is no significant improvement for resolutions ≥ 4 bit when reducing after "
      "differencing.",
      4, "after");
  four.headline = "4 bits of the difference are enough";
  return {
      std::move(four),
      enough("Fig. 10.4: nor for resolutions ≥ 5 bit when reducing before differencing.", 5, "before"),
      {"The required resolution is even lower for larger kernels: 3 bit and 4 bit, respectively, is sufficient.",
       {percent("9x9", 3, "after"), percent("9x9", 4, "before"), percent("13x13", 3, "after"),
        percent("13x13", 4, "before")},
       "9×9: 3 bit after differencing cost {:.1f} %, 4 bit before {:.1f} %; 13×13: {:.1f} % and {:.1f} %",
       "At most 7 % more error than 7 bits with both kernels, for D50 of 0.3 to 2 px; partly: one of 3 bit after and 4 "
       "bit before, or 15 %",
       {first <= 7 && second <= 7 && third <= 7 && fourth <= 7,
        (first <= 7 && third <= 7) || (second <= 7 && fourth <= 7) ||
            (first <= 15 && second <= 15 && third <= 15 && fourth <= 15)},
       "3 bits are enough for larger windows"},
      {"The required resolution is even lower for larger correlation kernels.",
       {percent("5x5", 3, "after"), percent("9x9", 3, "after"), percent("13x13", 3, "after"),
        percent("5x5", 4, "before"), percent("9x9", 4, "before"), percent("13x13", 4, "before"), px("5x5", 3, "after"),
        px("9x9", 3, "after"), px("13x13", 3, "after")},
       "5×5, 9×9, 13×13: 3 bit after differencing cost {:.1f}, {:.1f}, {:.1f} % of the error, 4 bit before it {:.1f}, {:.1f}, "
       "{:.1f} %. In pixels the former cost {:.3f}, {:.3f}, {:.3f}: the error itself is smaller with a larger kernel",
       "Both less of the error with every larger kernel; partly: one of them",
       {third < second && second < first && Term(5, 1, 0) < fifth && fifth < fourth,
        (third < second && second < first) || (Term(5, 1, 0) < fifth && fifth < fourth)}},
      {"A direction resolution of 8 and 7 bit (reduction before differencing) produces the same result.",
       {percent("5x5", 7, "before")},
       "5×5, 7 bit before differencing: {:.2f} % more error",
       "At most 1 %; partly: 3 %",
       {first <= 1, first <= 3}},
      {"The difference is only noticeable at a direction resolution of less than 6 bit.",
       {percent("5x5", 6, "before"), percent("5x5", 5, "before")},
       "5×5: 6 bit cost {:.1f} %, 5 bit {:.1f} %",
       "At most 1 % with 6 bit, more with 5; partly: at most 3 % with 6 bit",
       {first <= 1 && second > 1, first <= 3}},
      {"Reducing after differencing is almost as good as before it with a resolution increased by 1 bit.",
       {close, pairs},
       "5×5: {1}",
       "Costs within 5 points for all of 2 to 5 bit; partly: for half of them",
       {first >= 4, first >= 2}}};
}

/// `single`: the same of single images, one of them through the transformation.
std::vector<Statement> noise_of_directions(const Noise& noise, const Noise& single) {
  using namespace measured;
  return {
      {"In corresponding pictures 95 % of the direction differences are smaller than π/4.",
       {noise.below_45_percent, single.below_45_percent},
       "{:.1f} %; of single images through the transformation {:.1f} %",
       "Within 3 points of 95 %; partly: at least 90 %",
       {near(first, 95, 3), first >= 90},
       "95 % of the directions of corresponding pixels agree to π/4"},
      {"In corresponding pictures 85 % of the direction differences are smaller than π/8.",
       {noise.below_22_percent, single.below_22_percent},
       "{:.1f} %; of single images through the transformation {:.1f} %",
       "Within 3 points of 85 %; partly: within 10",
       {near(first, 85, 3), near(first, 85, 10)}},
      {"The direction difference is superimposed with noise having a mean value of approximately π/16.",
       {noise.mean_deg, single.mean_deg},
       "{:.1f}°; of single images through the transformation {:.1f}°; π/16 is 11.25°",
       "Within 25 %; partly: within a factor of 2",
       {near(first, 11.25, 0.25 * 11.25), first >= 0.5 * 11.25 && first <= 2 * 11.25}},
      {"The error introduced by this scaling and reduction of resolution (table of directions) is smaller than 0.5°.",
       {table_error_deg()},
       "{:.2f}° at most, of all gradients of ±1020",
       "Below 0.5°; partly: 1°",
       {first < 0.5, first < 1}}};
}

Statement rounding_statement(const Rounding& rounding) {
  using namespace measured;
  return {"Ours, not the thesis's: 8-bit directions are within 2 % of floating point.",
          {rounding.direction_percent, rounding.lowpass_percent, rounding.by_contrast},
          "5×5 to 13×13, D50 0.3 to 2 px: {0:.2f} % from the same gradients. With the rounding of the low-pass, which "
          "comes before, too: at a texture of {2}",
          "Error within 2 % for every contrast, the low-pass included; partly: directions of the same gradients",
          {first <= 2 && second <= 2, first <= 2}};
}

}  // namespace

void study_resolution(StudyReport& report, const StudyScope& scope) {
  const study::Conditions conditions = chapter8_conditions(scope);
  report.result["conditions"] = study::to_json(conditions);
  const std::vector<double> disparities = chapter8_disparities(scope);
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
  report.state("10.4.5", resolutions(report.result["losses"]));
  study::Conditions once = conditions;
  once.electronics.averaged = 1;
  const study::Simulation single(once, 1);
  report.state("10.4.5",
               noise_of_directions(direction_noise(simulation.photograph(0, 0), simulation.photograph(0, 1)),
                                   direction_noise(single.photograph(0, 0), transformed(single, {0, 1}).image(0))));
  report.state("10.4.5", {rounding_statement(rounded)});
}

}  // namespace horopter::cli
