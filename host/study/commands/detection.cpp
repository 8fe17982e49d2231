// SPDX-License-Identifier: Apache-2.0
// Thesis 11.2: what the hardware's stage detects at which displacement, and the threshold for a wanted tolerance.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "cli/progress.hpp"
#include "cli/stereo_pairs.hpp"
#include "conditions.hpp"
#include "horopter/machine/engines.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/study/measures.hpp"
#include "horopter/study/parallel.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using study::Detection;
using study::Feature;
using study::Setting;

constexpr double kFarthest_px = 14;

/// Share of the pixels of one image that `compete` takes for the skin, where its windows lie in the image.
double skin_share(Supervisor& supervisor, const Image& left, const Image& right) {
  constexpr int kMargin = 32;
  const FrameResult frame = std::move(supervisor.process(left, right).front());
  std::int64_t skin = 0;
  for (int y = kMargin; y < left.height - kMargin; ++y) {
    for (int x = kMargin; x < left.width - kMargin; ++x) {
      skin += static_cast<State>(frame.states.at(x, y)) == State::skin ? 1 : 0;
    }
  }
  return static_cast<double>(skin) / ((left.width - 2 * kMargin) * (left.height - 2 * kMargin));
}

/// Where a curve falls to 1/2, walked outwards.
double half_of(const std::vector<std::pair<double, double>>& curve) {
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const auto& [x0, y0] = curve[i - 1];
    const auto& [x1, y1] = curve[i];
    if (y0 > 0.5 && y1 <= 0.5) return x0 + (x1 - x0) * (y0 - 0.5) / (y0 - y1);
  }
  throw Error(ExitStatus::check_failed, "half of the pixels are taken for the skin at no displacement");
}

/// What `compete` detects with a setting of its boundary, over the displacement.
struct BoundaryDetection {
  int setting = 0;
  std::vector<std::pair<double, double>> rates;  ///< mean of before and behind the skin
  double tolerance_px = 0;
};

std::vector<BoundaryDetection> detect_boundaries(const study::ImageSeries& series, const std::vector<int>& settings,
                                                 const char* profile_name) {
  const MachineProfile& profile = find_profile(profile_name);
  const Image& left = series.reference;
  const MapSet maps = compile_maps(skin_at(0, left), profile, left.width, left.height);
  std::vector<Image> images;
  for (std::size_t i = 0; i < series.disparities_px.size(); ++i) images.push_back(series.image(i));
  std::vector<BoundaryDetection> result(settings.size());
  Progress progress("boundary");
  study::parallel_for(
      settings.size(),
      [&](std::size_t n) {
        Settings machine;
        machine.decision = Decision::compete;
        machine.competition.boundary = settings[n];
        Supervisor supervisor(make_device("native", profile), profile, maps, machine.without_proof());
        result[n].setting = settings[n];
        const std::size_t half = images.size() / 2;  // displacements: −far … −near, near … far
        for (std::size_t i = 0; i < half; ++i) {
          const double before = skin_share(supervisor, left, images[half - 1 - i]);
          const double behind = skin_share(supervisor, left, images[half + i]);
          result[n].rates.emplace_back(series.disparities_px[half + i], (before + behind) / 2);
        }
        result[n].tolerance_px = half_of(result[n].rates);
      },
      [&](std::size_t done) { progress.show(done, settings.size()); });
  return result;
}

/// What is detected of photographs with and without the transformation, and far from the skin.
struct Measurements {
  Setting dsad{&study::criterion("DSAD"), {Feature::direction, true}, 9};
  Setting hardware{&study::criterion("hardware"), {Feature::camera}, 9};
  std::vector<double> disparities_px;
  std::vector<Detection> averaged;  ///< of DSAD, on averaged images
  std::vector<Detection> single;    ///< of both, on single images through the transformation
  std::vector<Detection> far;       ///< of both, at 4 to 14 px

  double full() const { return dsad.criterion->worst(9); }
  double full_hardware() const { return hardware.criterion->worst(9); }
  const Detection& of_hardware() const { return single[1]; }
  double hardware_percent(double tolerance_px) const {
    return 100 * of_hardware().threshold(tolerance_px) / full_hardware();
  }
  /// Percent detected far from the skin.
  static double far_percent(const Detection& detection, double threshold) {
    const std::vector<double> rates = detection.rates(threshold);
    double sum = 0;
    for (const double rate : rates) sum += rate / static_cast<double>(rates.size());
    return 100 * sum;
  }
};

/// `single` simulates the images that the machine gets.
Measurements measure(const study::Conditions& conditions, const study::Simulation& single,
                     const std::vector<double>& disparities_px) {
  Measurements result;
  result.disparities_px = disparities_px;
  const study::Simulation averaged(conditions, kFarthest_px + 1);
  result.averaged = detect("image", photographs(averaged, disparities_px), {result.dsad});
  result.single = detect("image", transformed(single, disparities_px), {result.dsad, result.hardware});
  std::vector<double> far_places;
  for (int i = 4; i <= static_cast<int>(kFarthest_px); ++i) far_places.push_back(i);
  result.far = detect("image", photographs(single, far_places), {result.dsad, result.hardware});
  return result;
}

/// Thresholds for tolerances, also as C++ that threshold_percent_for() is made of.
Panel tabulate_thresholds(StudyReport& report, const Measurements& found) {
  std::string table =
      "// Tolerance in px, threshold in % of T_max of the hardware's 9×9 stage: written by `horopter study "
      "detection`.\n";
  Csv csv({"tolerance_px", "threshold_percent", "d95_px", "detected_4_to_14_px"});
  Panel panel{"Threshold for half of the pixels", "displacement, px", "threshold, % of T_max", {{"hardware", {}}}};
  for (int i = 2; i <= 25; ++i) {
    const double tolerance = i / 10.0;
    const double threshold = found.of_hardware().threshold(tolerance);
    const double percent = found.hardware_percent(tolerance);
    table += fmt::format("THRESHOLD({:.1f}, {:.2f})\n", tolerance, percent);
    csv.row(tolerance, percent, found.of_hardware().disparity_at(threshold, 0.95).value_or(0),
            Measurements::far_percent(found.far[1], threshold) / 100);
    panel.curves[0].points.emplace_back(tolerance, percent);
    report.result["threshold_percent"][fmt::format("{:.1f}", tolerance)] = percent;
  }
  report.file("threshold_table.def", table);
  report.table("thresholds.csv", csv);
  return panel;
}

Panel tabulate_rates(StudyReport& report, const Measurements& found) {
  Csv csv({"threshold_percent", "displacement_px", "detection_rate"});
  Panel panel{"Hardware 9×9, thresholds in % of T_max", "displacement, px", "detection rate, %", {}};
  for (int percent = 2; percent <= 50; ++percent) {
    Curve curve{fmt::format("{} %", percent), {}};
    const auto all = found.of_hardware().rates(std::floor(percent * found.full_hardware() / 100));
    for (std::size_t i = 0; i < all.size(); ++i) {
      csv.row(percent, found.disparities_px[i], all[i]);
      curve.points.emplace_back(found.disparities_px[i], 100 * all[i]);
    }
    if (percent % 5 == 0) panel.curves.push_back(curve);
  }
  report.table("rates.csv", csv);
  return panel;
}

/// The same of `compete`: its boundary has few settings, each with the tolerance that it has.
void boundaries(StudyReport& report, const StudyScope& scope, const study::Simulation& simulation) {
  std::vector<double> places;
  for (int i = -20; i <= 20; ++i) {
    if (std::abs(i) >= 2) places.push_back(i / 10.0);
  }
  std::vector<int> settings;
  for (int n = 0; n <= 14; n += scope.quick ? 7 : 1) settings.push_back(n);
  const study::ImageSeries both_sides = transformed(simulation, places);
  const auto of_vga = detect_boundaries(both_sides, settings, "vga");
  std::string table = "// Setting `boundary` of compete, its tolerance in px: written by `horopter study detection`.\n";
  Csv csv({"boundary", "displacement_px", "detection_rate"});
  Panel panel{"compete, settings of its boundary", "displacement, px", "detection rate, %", {}};
  for (const BoundaryDetection& boundary : of_vga) {
    table += fmt::format("BOUNDARY({}, {:.3f})\n", boundary.setting, boundary.tolerance_px);
    report.result["boundary_px"][fmt::format("{}", boundary.setting)] = boundary.tolerance_px;
    Curve curve{fmt::format("boundary {}", boundary.setting), {}};
    for (const auto& [displacement_px, rate] : boundary.rates) {
      csv.row(boundary.setting, displacement_px, rate);
      curve.points.emplace_back(displacement_px, 100 * rate);
    }
    if (boundary.setting % 2 == 0) panel.curves.push_back(curve);
  }
  report.file("boundary_table.def", table);
  report.table("boundaries.csv", csv);
  report.plot("boundaries.svg", "Detection by the rule compete over displacement", {panel}, 1);
  const auto of_hd = detect_boundaries(both_sides, {settings.front(), settings.back()}, "hd");
  report.finding(
      "compete: half of the pixels displaced by {:.2f} to {:.2f} px are detected with its boundary at {} to {}; by "
      "{:.2f} to {:.2f} px with the planes of hd",
      of_vga.front().tolerance_px, of_vga.back().tolerance_px, settings.front(), settings.back(),
      of_hd.front().tolerance_px, of_hd.back().tolerance_px);
}

std::vector<Statement> thickness_statements(const Measurements& found) {
  using namespace measured;
  std::string deviations;
  double worst = 0;
  double smallest = 0;
  for (const double percent : {11.3, 15.0, 18.4, 21.9, 25.1, 28.4}) {
    const double threshold = percent / 100 * found.full();
    const double expected = found.averaged[0].disparity_at(threshold, 0.95).value_or(0);
    const double seen = found.single[0].disparity_at(threshold, 0.95).value_or(0);
    const double deviation = seen > 0 ? expected / seen - 1 : 1;
    deviations += fmt::format(" {:+.1f}", 100 * deviation);
    if (percent < 12) {
      smallest = deviation;
    } else {
      worst = std::max(worst, std::abs(deviation));
    }
  }
  return {
      {"Table 11.2: thickness expected from averaged images agrees with the system's, except for the smallest "
       "threshold (noise of the transformation).",
       {worst, smallest, deviations},
       "Expected over measured D95 on single, interpolated images:{2} % (the table: −21 to −15 % for the smallest, the others "
       "within 7.3 %)",
       "Within 8 %, the smallest threshold below by more, as in the table; partly: within 15 %",
       {first <= 0.08 && second < -1 * first, first <= 0.15}}};
}

std::vector<Statement> far_statements(const Measurements& found) {
  using namespace measured;
  const auto far = [&](double percent) {
    return Measurements::far_percent(found.far[0], percent / 100 * found.full());
  };
  return {
      {"A threshold above 25 % results in erroneous segmented pixels (25.1 % in Fig. 11.8) and is not applicable.",
       {far(21.9), far(25.1), far(28.4), far(18.4)},
       "Detected of what is 4 to 14 px away: {3:.3f} % with 18.4 %, {0:.3f} % with 21.9 %, {1:.3f} % with 25.1 %, "
       "{2:.3f} % with 28.4 %",
       "With 25.1 % 0.1 % at least (a hundred pixels of a field of 378×256), with 21.9 % fewer; partly: with 28.4 %",
       {second >= 0.1 && first < 0.1, third >= 0.1 && first < 0.1},
       "thresholds above 25 % of T_max detect what is not there"}};
}

}  // namespace

void study_detection(StudyReport& report, const StudyScope& scope) {
  const study::Conditions conditions = chapter8_conditions(scope);
  study::Conditions once = conditions;
  once.electronics.averaged = 1;
  report.result["conditions"] = to_json(once);
  report.result["conditions"]["interpolated_px"] = kInterpolated_px;
  const study::Simulation single(once, kFarthest_px + 1);
  const Measurements found = measure(conditions, single, chapter8_disparities(scope));
  const Panel thresholds = tabulate_thresholds(report, found);
  report.plot("detection.svg",
              "Fig. 11.7: detection by the hardware's stage over displacement (single images with interpolation), and "
              "the threshold for a tolerance",
              {tabulate_rates(report, found), thresholds}, 2);
  boundaries(report, scope, single);
  report.state("11.2.1", thickness_statements(found));
  report.state("11.2.2", far_statements(found));
  report.finding(
      "The hardware's 9×9 stage detects half of the pixels displaced by 0.5, 1.0, 1.5, 2.0 px at {:.1f}, {:.1f}, "
      "{:.1f}, {:.1f} % of T_max",
      found.hardware_percent(0.5), found.hardware_percent(1), found.hardware_percent(1.5), found.hardware_percent(2));
  const double normal = 0.25 * found.full_hardware();
  report.finding("With the threshold of 25 %: 95 % detected at {:.2f} px, half at {:.2f} px, {:.2f} % at 4 to 14 px",
                 found.of_hardware().disparity_at(normal, 0.95).value_or(0),
                 found.of_hardware().disparity_at(normal, 0.5).value_or(0),
                 Measurements::far_percent(found.far[1], normal));
}

}  // namespace horopter::cli
