// SPDX-License-Identifier: Apache-2.0
// Thesis 11.2: what the hardware's stage detects at which displacement, and the threshold for a wanted tolerance.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "cli/progress.hpp"
#include "conditions.hpp"
#include "horopter/base/csv.hpp"
#include "horopter/draw/plot.hpp"
#include "horopter/machine/engines.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/study/measures.hpp"
#include "horopter/study/parallel.hpp"
#include "statements.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using study::Detection;
using study::Feature;
using study::Setting;

constexpr double kInterpolated = 0.375;  ///< px of each displacement that bilinear interpolation makes, weights of 1/8

std::vector<Detection> measure(const study::ImageSeries& series, const std::vector<Setting>& settings) {
  Progress progress("image");
  return study::detect(series, settings, [&](std::size_t done) { progress.show(done, series.disparities_px.size()); });
}

/// Share of the pixels of one image that `compete` takes for the skin, where its windows lie in the image.
double skin_share(Supervisor& supervisor, const Image& left, const Image& right) {
  constexpr int margin = 32;
  const FrameResult frame = std::move(supervisor.process(left, right).front());
  std::int64_t skin = 0;
  for (int y = margin; y < left.height - margin; ++y) {
    for (int x = margin; x < left.width - margin; ++x) {
      skin += static_cast<State>(frame.states.at(x, y)) == State::skin ? 1 : 0;
    }
  }
  return static_cast<double>(skin) / ((left.width - 2 * margin) * (left.height - 2 * margin));
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
  SkinFile skin;
  skin.skin =
      std::make_unique<HomographySkin>(Matrix3{1, 0, 0, 0, 1, 0, 0, 0, 1}, Point{left.width / 2.0, left.height / 2.0});
  const MapSet maps = compile_maps(skin, profile, left.width, left.height);
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
        Supervisor supervisor(make_device("native", profile), profile, maps, machine);
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

/// The same displacements when the right image comes through the transformation, as in the system.
study::ImageSeries transformed(const study::Simulation& simulation, const std::vector<double>& disparities_px) {
  study::ImageSeries series = photographs(simulation, disparities_px);
  series.image = [&simulation, disparities_px](std::size_t i) {
    const Image source = simulation.photograph(disparities_px[i] - kInterpolated, i + 1);
    Image result(source.width, source.height);
    constexpr int weight = static_cast<int>(8 * kInterpolated);
    for (int y = 0; y < source.height; ++y)
      for (int x = 0; x < source.width; ++x) {
        const int next = x + 1 < source.width ? x + 1 : x;
        result.at(x, y) =
            static_cast<std::uint8_t>(((8 - weight) * source.at(x, y) + weight * source.at(next, y) + 4) / 8);
      }
    return result;
  };
  return series;
}

}  // namespace

nlohmann::json study_detection(OutputDirectory& directory, const StudyScope& scope) {
  study::Conditions conditions = chapter8_conditions(scope);
  const std::vector<double> disparities = chapter8_disparities(scope);
  const Setting dsad{&study::criterion("DSAD"), {Feature::direction, true}, 9};
  const Setting hardware{&study::criterion("hardware"), {Feature::camera}, 9};
  const double full = dsad.criterion->worst(9);
  const double full_hardware = hardware.criterion->worst(9);

  constexpr double farthest_px = 14;
  const study::Simulation averaged(conditions, farthest_px + 1);
  const auto ideal = measure(photographs(averaged, disparities), {dsad});
  conditions.electronics.averaged = 1;
  const study::Simulation single(conditions, farthest_px + 1);
  const auto real = measure(transformed(single, disparities), {dsad, hardware});
  std::vector<double> far_places;
  for (int i = 4; i <= static_cast<int>(farthest_px); ++i) far_places.push_back(i);
  const auto far = measure(photographs(single, far_places), {dsad, hardware});

  nlohmann::json result{{"conditions", to_json(conditions)}, {"findings", nlohmann::json::array()}};
  result["conditions"]["interpolated_px"] = kInterpolated;

  // Thresholds for tolerances, as C++ that threshold_percent_for() is made of.
  std::string table =
      "// Tolerance in px, threshold in % of T_max of the hardware's 9×9 stage: written by `horopter study "
      "detection`.\n";
  Csv thresholds({"tolerance_px", "threshold_percent", "d95_px", "detected_4_to_14_px"});
  Panel threshold_panel{
      "Threshold for half of the pixels", "displacement [px]", "% of T_max", {{"hardware", {}}}, false};
  const auto far_share = [&](const Detection& detection, double threshold) {
    double sum = 0;
    for (const double rate : detection.rates(threshold)) sum += rate / static_cast<double>(far_places.size());
    return sum;
  };
  for (int i = 2; i <= 25; ++i) {
    const double tolerance = i / 10.0;
    const double threshold = real[1].threshold(tolerance);
    const double percent = 100 * threshold / full_hardware;
    table += fmt::format("THRESHOLD({:.1f}, {:.2f})\n", tolerance, percent);
    thresholds << tolerance << percent << real[1].disparity_at(threshold, 0.95).value_or(0)
               << far_share(far[1], threshold);
    thresholds.end_row();
    threshold_panel.curves[0].points.emplace_back(tolerance, percent);
    result["threshold_percent"][fmt::format("{:.1f}", tolerance)] = percent;
  }
  directory.write("threshold_table.def", table);
  directory.write("thresholds.csv", thresholds.text());
  Csv rates({"threshold_percent", "displacement_px", "detection_rate"});
  Panel rate_panel{"Hardware 9×9, thresholds in % of T_max", "displacement [px]", "detection rate [%]", {}, false};
  for (int percent = 2; percent <= 50; ++percent) {
    Curve curve{fmt::format("{} %", percent), {}};
    const auto all = real[1].rates(std::floor(percent * full_hardware / 100));
    for (std::size_t i = 0; i < all.size(); ++i) {
      rates << static_cast<double>(percent) << disparities[i] << all[i];
      rates.end_row();
      curve.points.emplace_back(disparities[i], 100 * all[i]);
    }
    if (percent % 5 == 0) rate_panel.curves.push_back(curve);
  }
  directory.write("rates.csv", rates.text());
  directory.write("detection.svg",
                  plot_svg("What the hardware's stage detects, single images with interpolation (Fig. 11.7)",
                           {rate_panel, threshold_panel}, 2));
  result["figures"] = {
      {{"file", "detection.svg"},
       {"title", "Detection by the hardware's stage over displacement (Fig. 11.7), and the threshold for a tolerance"}},
      {{"file", "boundaries.svg"}, {"title", "Detection by the rule compete over displacement"}}};

  // The same of `compete`: its boundary has few settings, each with the tolerance that it has.
  std::vector<double> places;
  for (int i = -20; i <= 20; ++i) {
    if (std::abs(i) >= 2) places.push_back(i / 10.0);
  }
  std::vector<int> settings;
  for (int n = 0; n <= 14; n += scope.quick ? 7 : 1) settings.push_back(n);
  const study::ImageSeries both_sides = transformed(single, places);
  const auto boundaries = detect_boundaries(both_sides, settings, "vga");
  table = "// Setting `boundary` of compete, its tolerance in px: written by `horopter study detection`.\n";
  Csv boundary_rates({"boundary", "displacement_px", "detection_rate"});
  Panel boundary_panel{"compete, settings of its boundary", "displacement [px]", "detection rate [%]", {}, false};
  for (const BoundaryDetection& boundary : boundaries) {
    table += fmt::format("BOUNDARY({}, {:.3f})\n", boundary.setting, boundary.tolerance_px);
    result["boundary_px"][fmt::format("{}", boundary.setting)] = boundary.tolerance_px;
    Curve curve{fmt::format("{}", boundary.setting), {}};
    for (const auto& [displacement_px, rate] : boundary.rates) {
      boundary_rates << static_cast<double>(boundary.setting) << displacement_px << rate;
      boundary_rates.end_row();
      curve.points.emplace_back(displacement_px, 100 * rate);
    }
    if (boundary.setting % 2 == 0) boundary_panel.curves.push_back(curve);
  }
  directory.write("boundary_table.def", table);
  directory.write("boundaries.csv", boundary_rates.text());
  directory.write("boundaries.svg", plot_svg("What `compete` detects", {boundary_panel}, 1));
  const auto of_hd = detect_boundaries(both_sides, {settings.front(), settings.back()}, "hd");
  result["findings"].push_back(
      fmt::format("compete: half of the pixels displaced by {:.2f} to {:.2f} px are detected with its boundary at {} "
                  "to {}; by {:.2f} to {:.2f} px with the planes of hd",
                  boundaries.front().tolerance_px, boundaries.back().tolerance_px, settings.front(), settings.back(),
                  of_hd.front().tolerance_px, of_hd.back().tolerance_px));

  Statements statements;
  std::string deviations;
  double worst = 0;
  double smallest = 0;
  for (const double percent : {11.3, 15.0, 18.4, 21.9, 25.1, 28.4}) {
    const double threshold = percent / 100 * full;
    const double expected = ideal[0].disparity_at(threshold, 0.95).value_or(0);
    const double measured = real[0].disparity_at(threshold, 0.95).value_or(0);
    const double deviation = measured > 0 ? expected / measured - 1 : 1;
    deviations += fmt::format(" {:+.1f}", 100 * deviation);
    if (percent < 12) {
      smallest = std::abs(deviation);
    } else {
      worst = std::max(worst, std::abs(deviation));
    }
  }
  statements.add(
      "11.2.1",
      "Table 11.2: thickness expected from averaged images agrees with the system's, except for the smallest "
      "threshold (noise of the transformation).",
      "Expected over measured D95 on single, interpolated images:" + deviations + " %",
      verdict(worst <= 0.08 && smallest > worst, worst <= 0.15),
      "Within 8 %, the smallest threshold off by more; partly: within 15 %");
  const double at_25 = far_share(far[0], 0.251 * full);
  const double at_28 = far_share(far[0], 0.284 * full);
  statements.add(
      "11.2.2", "A threshold above 25 % results in wrongly segmented pixels.",
      fmt::format("Detected at 4 to 14 px: {:.2f} % with 25.1 %, {:.2f} % with 28.4 %", 100 * at_25, 100 * at_28),
      verdict(at_28 >= 0.01 && at_25<at_28 / 1.5, at_28> at_25),
      "At least 1 % with 28.4 %, 1.5 times what 25.1 % gives; partly: more");
  result["statements"] = statements.json();
  result["findings"].push_back(
      fmt::format("The hardware's 9×9 stage detects half of the pixels displaced by 0.5, 1.0, 1.5, 2.0 px at {:.1f}, "
                  "{:.1f}, {:.1f}, "
                  "{:.1f} % of T_max",
                  100 * real[1].threshold(0.5) / full_hardware, 100 * real[1].threshold(1) / full_hardware,
                  100 * real[1].threshold(1.5) / full_hardware, 100 * real[1].threshold(2) / full_hardware));
  const double normal = 0.25 * full_hardware;
  result["findings"].push_back(
      fmt::format("With the threshold of 25 %: 95 % detected at {:.2f} px, half at {:.2f} px, {:.2f} % at 4 to 14 px",
                  real[1].disparity_at(normal, 0.95).value_or(0), real[1].disparity_at(normal, 0.5).value_or(0),
                  100 * far_share(far[1], normal)));
  return result;
}

}  // namespace horopter::cli
