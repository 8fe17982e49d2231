// SPDX-License-Identifier: Apache-2.0
// Thesis 11.2.2, Fig. 11.8: an object across the axis of symmetry before a skin that slopes: what of it is detected.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "cli/progress.hpp"
#include "conditions.hpp"
#include "horopter/plan/plan.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using study::Feature;
using study::Plane;
using study::Setting;

// Table 11.1; pixels are those of the sub-sampled field.
constexpr double kDistance_mm = 800;
constexpr double kBaseline_mm = 152;
constexpr double kF_px = 10 / 0.017;
/// Of the object, a pixel's width.
constexpr double kPixel_mm = kDistance_mm / kF_px;

constexpr std::array kThresholdsPercent{11.3, 15.0, 18.4, 21.9, 25.1};  ///< of Fig. 11.8
constexpr std::array kSlopes_deg{20.0, 30.0, 40.0, 50.0, 60.0};
constexpr double kFarthest_px = 6;  ///< of disparity: what is farther away is not looked at

double tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

/// Change of the disparity from pixel to pixel where the skin rises by `rise` mm along the axis for each mm across it.
double gradient_px(double rise) {
  return rise * kPixel_mm / (coplanar_thickness_mm(1, kDistance_mm, kBaseline_mm, kF_px) / 2);
}

/// Directions in which the skin may slope: along the image's rows (the baseline's direction), or down its columns.
enum class Along { rows, columns };

/// What is detected of an object where the disparity rises evenly.
class SlopedObject {
 public:
  SlopedObject(const study::Simulation& simulation, const Image& left, double gradient, Along along,
               std::uint64_t number)
      : gradient_(gradient), along_(along) {
    study::Raster<float> shifts(left.width, left.height);
    for (int y = 0; y < left.height; ++y)
      for (int x = 0; x < left.width; ++x)
        shifts.at(x, y) =
            static_cast<float>(std::clamp(disparity_px(x, y, left), -kFarthest_px, kFarthest_px) - kInterpolated_px);
    const Image right =
        interpolated(simulation.expose(simulation.exact(shifts), simulation.conditions().electronics, number));
    const Setting setting{&study::criterion("DSAD"), {Feature::direction, true}, 9};
    const Plane r = prepare(left, setting.preparation);
    const Plane s = prepare(right, setting.preparation);
    study::Pair pair(r, s);
    pair.set_kernel(setting.kernel);
    values_ = setting.criterion->compare(pair);
    margin_ = reach_of(setting);
  }

  /// Width of the zone in which a share of the pixels is detected, px across the slope; and the largest share.
  struct Zone {
    double width_px = 0, peak = 0;
  };
  Zone zone(double threshold, double share) const {
    Zone result;
    const int length = along_ == Along::rows ? values_.width : values_.height;
    for (int t = margin_; t < length - margin_; ++t) {
      if (std::abs(gradient_ * (t - (length - 1) / 2.0)) >= kFarthest_px) continue;
      const double here = detected(t, threshold);
      result.peak = std::max(result.peak, here);
      result.width_px += here >= share ? 1 : 0;
    }
    return result;
  }

 private:
  double disparity_px(int x, int y, const Image& image) const {
    return gradient_ * (along_ == Along::rows ? x - (image.width - 1) / 2.0 : y - (image.height - 1) / 2.0);
  }
  /// Share of the pixels with one disparity.
  double detected(int t, double threshold) const {
    const int across = along_ == Along::rows ? values_.height : values_.width;
    int count = 0;
    for (int i = margin_; i < across - margin_; ++i)
      count += (along_ == Along::rows ? values_.at(t, i) : values_.at(i, t)) <= threshold ? 1 : 0;
    return static_cast<double>(count) / (across - 2 * margin_);
  }

  double gradient_;
  Along along_;
  Plane values_;
  int margin_ = 0;
};

/// Widths against those of 11.3.
struct Found {
  double furthest_percent = 0;                    ///< up to 50°
  double peak_at_50 = 1;                          ///< with the highest threshold, of both directions the smaller
  double width_at_20_mm = 0, width_at_50_mm = 0;  ///< with it
  double peak_at_15 = 1, peak_at_30 = 0;          ///< between object and a skin of 70°
};

double full() { return study::criterion("DSAD").worst(9); }

Found measure(StudyReport& report, const study::Simulation& simulation, const study::Detection& flat) {
  const Image left = simulation.photograph(0, 0);
  Csv table({"slope_deg", "along", "threshold_percent", "width_px", "width_by_11_3_px", "largest_share"});
  std::vector<Panel> panels;
  Found found;
  Progress progress("slope");
  std::uint64_t number = 1;
  const auto peak_between = [&](Along direction, double angle_deg) {
    const double gradient = gradient_px(tangent(70) - tangent(70 - angle_deg));
    const SlopedObject object(simulation, left, gradient, direction, number++);
    return object.zone(kThresholdsPercent.back() / 100 * full(), 0.5).peak;
  };
  for (const auto& [along, name] :
       {std::pair{Along::rows, "along the baseline"}, {Along::columns, "across the baseline"}}) {
    Panel& panel = panels.emplace_back(Panel{name, "slope of the skin, degrees", "width of the zone, mm", {}, true});
    for (const double percent : kThresholdsPercent) {
      panel.curves.push_back({fmt::format("{} %", percent), {}});
      panel.curves.push_back({fmt::format("{} %, by 11.3", percent), {}});
    }
    for (const double slope : kSlopes_deg) {
      progress.show(number, {});
      const double gradient = gradient_px(tangent(slope));
      const SlopedObject object(simulation, left, gradient, along, number++);
      for (std::size_t i = 0; i < kThresholdsPercent.size(); ++i) {
        const double threshold = kThresholdsPercent[i] / 100 * full();
        const auto zone = object.zone(threshold, 0.5);
        const double d50_px = flat.disparity_at(threshold, 0.5).value_or(0);
        const double expected_px =
            face_width_mm(coplanar_thickness_mm(d50_px, kDistance_mm, kBaseline_mm, kF_px), slope) / kPixel_mm;
        table.row(slope, name, kThresholdsPercent[i], zone.width_px, expected_px, zone.peak);
        panel.curves[2 * i].points.emplace_back(slope, std::max(zone.width_px, 0.5) * kPixel_mm);
        panel.curves[2 * i + 1].points.emplace_back(slope, expected_px * kPixel_mm);
        // Where the zone is a row or two wide, whole pixels cannot tell.
        if (slope <= 50 && kThresholdsPercent[i] >= 15)
          found.furthest_percent = std::max(
              found.furthest_percent, 100 * std::max(0.0, std::abs(zone.width_px - expected_px) - 1) / expected_px);
        if (i + 1 < kThresholdsPercent.size()) continue;
        if (slope == 20) found.width_at_20_mm = zone.width_px * kPixel_mm;
        if (slope == 50) {
          found.peak_at_50 = std::min(found.peak_at_50, zone.peak);
          found.width_at_50_mm = zone.width_px * kPixel_mm;
        }
      }
    }
    found.peak_at_15 = std::min(found.peak_at_15, peak_between(along, 15));
    found.peak_at_30 = std::max(found.peak_at_30, peak_between(along, 30));
  }
  report.table("fig-11-8.csv", table);
  report.plot("fig-11-8.svg", "Fig. 11.8: zone in which half of an object across the axis is detected", panels, 2);
  return found;
}

}  // namespace

void study_slopes(StudyReport& report, const StudyScope& scope) {
  using namespace measured;
  study::Conditions conditions = chapter8_conditions(scope);
  conditions.electronics.averaged = 1;
  report.result["conditions"] = to_json(conditions);
  report.result["conditions"]["interpolated_px"] = kInterpolated_px;
  const study::Simulation simulation(conditions, kFarthest_px + 1);
  StudyScope quick;
  quick.quick = true;
  const study::Detection flat = study::detect(transformed(simulation, chapter8_disparities(quick)),
                                              {{&study::criterion("DSAD"), {Feature::direction, true}, 9}})[0];
  const Found found = measure(report, simulation, flat);
  report.state(
      "11.2.2",
      {{"Fig. 11.8: the width of the theoretical detectable object area (11.3) corresponds very well with the measured "
        "data.",
        {found.furthest_percent},
        "Slopes of 20° to 50°, thresholds of 15.0 to 25.1 %, along and across the baseline: within {:.0f} % and a pixel",
        "Within 15 % and a pixel; partly: 30 %",
        {first <= 15, first <= 30},
        "the detected zone of a sloped skin is as wide as equation 11.3 says"},
       {"Fig. 11.8: an object is well detectable up to an angle of 50° with highest thresholds, but the detected zone gets "
        "very small.",
        {100 * found.peak_at_50, found.width_at_50_mm, found.width_at_20_mm},
        "25.1 %: {:.0f} % of the pixels in the middle of the zone, which is {:.0f} mm wide (20°: {:.0f} mm)",
        "95 % at least; partly: half",
        {first >= 95, first >= 50}},
       {"A skin may be tilted up to 70°, but then only objects which enclose an angle of less than 15° with it could be "
        "detected.",
        {100 * found.peak_at_15, 100 * found.peak_at_30},
        "25.1 %: {:.0f} % of the pixels in the middle of the zone at 15°, {:.0f} % at 30°",
        "Half at 15°, not half at 30°; partly: half at 15°",
        {first >= 50 && second < 50, first >= 50}}});
  report.finding("25.1 %, 50°: the zone of an object across the axis is {:.0f} mm wide, {:.0f} % of it detected",
                 found.width_at_50_mm, 100 * found.peak_at_50);
}

}  // namespace horopter::cli
