// SPDX-License-Identifier: Apache-2.0
// Thesis 8.5: small objects in front of a background with a disparity of 2 px (Fig. 8.18).
#include <fmt/format.h>

#include <string>
#include <vector>

#include "conditions.hpp"
#include "horopter/study/parallel.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using study::Feature;
using study::Plane;
using study::Setting;

constexpr double kBackground_px = 2;
constexpr double kThreshold_px = 0.8;  ///< half of the pixels with this disparity are detected

/// Places of square objects that no window of one reaches another's.
struct Places {
  int size, pitch, first;
  template <class F>
  void each(int width, int height, F f) const {
    for (int y = first; y + size + first <= height; y += pitch)
      for (int x = first; x + size + first <= width; x += pitch) f(x, y);
  }
};

/// Share of the objects' pixels that are detected.
double detected(const Image& left, const Image& background, const Image& object, const Setting& setting,
                double threshold, int size) {
  const int reach = reach_of(setting);
  const Places places{size, size + 2 * reach + 2, reach + 1};
  Image right = background;
  places.each(left.width, left.height, [&](int x0, int y0) {
    for (int y = y0; y < y0 + size; ++y)
      for (int x = x0; x < x0 + size; ++x) right.at(x, y) = object.at(x, y);
  });
  const Plane r = prepare(left, setting.preparation);
  const Plane s = prepare(right, setting.preparation);
  study::Pair pair(r, s);
  pair.set_kernel(setting.kernel);
  const Plane values = setting.criterion->compare(pair);
  double inside = 0;
  double all = 0;
  places.each(left.width, left.height, [&](int x0, int y0) {
    for (int y = y0; y < y0 + size; ++y)
      for (int x = x0; x < x0 + size; ++x) {
        inside += values.at(x, y) <= threshold ? 1 : 0;
        ++all;
      }
  });
  return all > 0 ? inside / all : 0;
}

std::vector<Setting> settings_of_objects() {
  std::vector<Setting> settings;
  for (const bool lowpass : {false, true})
    for (const int kernel : {5, 7, 9, 11, 13})
      settings.push_back({&study::criterion("DSAD"), {Feature::direction, lowpass}, kernel});
  for (const int kernel : {5, 9, 13}) settings.push_back({&study::criterion("hardware"), {Feature::camera}, kernel});
  return settings;
}

/// Side from which half of the pixels are detected; the largest where that is at none.
double half_detected(const std::vector<int>& sizes, const std::vector<double>& shares) {
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    if (shares[k] < 0.5) continue;
    if (k == 0) return sizes[0];
    return sizes[k - 1] + (sizes[k] - sizes[k - 1]) * (0.5 - shares[k - 1]) / (shares[k] - shares[k - 1]);
  }
  return sizes.back();
}

/// `smallest`: by setting, five kernels without and five with the low-pass first.
void state_objects(StudyReport& report, const std::vector<double>& smallest) {
  const auto list = [&](std::size_t begin) {
    std::string text;
    for (std::size_t i = begin; i < begin + 5; ++i) text += fmt::format(" {:.1f}", smallest[i]);
    return text;
  };
  int rising = 0;
  int larger = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    if (i > 0) rising += (smallest[i] > smallest[i - 1] ? 1 : 0) + (smallest[i + 5] > smallest[i + 4] ? 1 : 0);
    larger += smallest[i + 5] > smallest[i] ? 1 : 0;
  }
  using namespace measured;
  report.state("8.5", {{"Large kernels suppress small objects more.",
                        {rising, smallest[0], smallest[4], list(0)},
                        "Half of the pixels are detected from sides of{3} px on (5×5 … 13×13)",
                        "The side rises with every kernel, with and without low-pass; partly: from 5×5 to 13×13",
                        {first >= 8, third > second},
                        "large windows suppress small objects"},
                       {"A low-pass before suppresses small objects more.",
                        {larger, list(5)},
                        "With it from{1} px on",
                        "A larger side for every kernel; partly: for half of them",
                        {first >= 5, 2 * first >= 5},
                        "a low-pass suppresses small objects"}});
  report.finding(
      "Half of an object's pixels are detected from a side of{} px on with DSAD LP 5×5 … 13×13, {:.1f} px "
      "with the hardware's 9×9",
      list(5), smallest[11]);
}

}  // namespace

void study_objects(StudyReport& report, const StudyScope& scope) {
  study::Conditions conditions = chapter8_conditions(scope);
  conditions.electronics.averaged = 1;  // real camera noise
  report.result["conditions"] = to_json(conditions);
  const study::Simulation simulation(conditions, 3);
  const Image left = simulation.photograph(0, 0);
  const Image background = simulation.photograph(kBackground_px, 1);
  const Image object = simulation.photograph(0, 2);
  std::vector<int> sizes;
  for (int size = 1; size <= 31; size += scope.quick ? 3 : 1) sizes.push_back(size);
  const std::vector<Setting> settings = settings_of_objects();
  const auto detections = study::detect(photographs(simulation, {0.4, kThreshold_px, 1.2}), settings);

  std::vector<std::vector<double>> shares(settings.size(), std::vector<double>(sizes.size()));
  study::parallel_for(settings.size() * sizes.size(), [&](std::size_t index) {
    const std::size_t i = index / sizes.size();
    const std::size_t k = index % sizes.size();
    shares[i][k] = detected(left, background, object, settings[i], detections[i].threshold(kThreshold_px), sizes[k]);
  });

  Csv csv({"setting", "size_px", "detected"});
  std::vector<Panel> panels;
  for (const char* title : {"DSAD", "DSAD LP", "hardware"})
    panels.push_back({title, "side of the object, px", "its pixels detected, %", {}});
  std::vector<double> smallest;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const study::Preparation& preparation = settings[i].preparation;
    Panel& panel = panels[preparation.feature == Feature::camera ? 2 : preparation.lowpass ? 1 : 0];
    Curve& curve = panel.curves.emplace_back(Curve{fmt::format("{0}×{0}", settings[i].kernel), {}});
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      csv.row(name_of(settings[i]), sizes[k], shares[i][k]);
      curve.points.emplace_back(sizes[k], 100 * shares[i][k]);
    }
    smallest.push_back(half_detected(sizes, shares[i]));
    report.result["half_detected_px"][name_of(settings[i])] = smallest.back();
  }
  report.table("objects.csv", csv);
  report.plot("fig-8-18.svg",
              "Fig. 8.18: detected part of square objects before a background displaced by 2 px, over "
              "their size",
              panels, 3);
  state_objects(report, smallest);
}

}  // namespace horopter::cli
