// SPDX-License-Identifier: Apache-2.0
// Thesis 8.5: small objects in front of a background with a disparity of 2 px (Fig. 8.18).
#include <fmt/format.h>

#include <vector>

#include "conditions.hpp"
#include "horopter/base/csv.hpp"
#include "horopter/draw/plot.hpp"
#include "horopter/study/parallel.hpp"
#include "statements.hpp"
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

}  // namespace

nlohmann::json study_objects(OutputDirectory& directory, const StudyScope& scope) {
  study::Conditions conditions = chapter8_conditions(scope);
  conditions.electronics.averaged = 1;  // real camera noise
  const study::Simulation simulation(conditions, 3);
  const Image left = simulation.photograph(0, 0);
  const Image background = simulation.photograph(kBackground_px, 1);
  const Image object = simulation.photograph(0, 2);
  std::vector<int> sizes;
  for (int size = 1; size <= 31; size += scope.quick ? 3 : 1) sizes.push_back(size);

  std::vector<Setting> settings;
  for (const bool lowpass : {false, true})
    for (const int kernel : {5, 7, 9, 11, 13})
      settings.push_back({&study::criterion("DSAD"), {Feature::direction, lowpass}, kernel});
  for (const int kernel : {5, 9, 13}) settings.push_back({&study::criterion("hardware"), {Feature::camera}, kernel});
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
    panels.push_back({title, "side of the object [px]", "its pixels detected [%]", {}, false});
  std::vector<double> smallest;  ///< side of which half of the pixels are detected
  nlohmann::json result{{"conditions", to_json(conditions)}};
  for (std::size_t i = 0; i < settings.size(); ++i) {
    Curve curve{fmt::format("{0}×{0}", settings[i].kernel), {}};
    double half = 0;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      csv << name_of(settings[i]) << static_cast<double>(sizes[k]) << shares[i][k];
      csv.end_row();
      curve.points.emplace_back(sizes[k], 100 * shares[i][k]);
      if (half == 0 && shares[i][k] >= 0.5) {
        half = k == 0 ? sizes[0]
                      : sizes[k - 1] +
                            (sizes[k] - sizes[k - 1]) * (0.5 - shares[i][k - 1]) / (shares[i][k] - shares[i][k - 1]);
      }
    }
    smallest.push_back(half > 0 ? half : sizes.back());
    result["half_detected_px"][name_of(settings[i])] = smallest.back();
    panels[settings[i].preparation.feature == Feature::camera ? 2
           : settings[i].preparation.lowpass                  ? 1
                                                              : 0]
        .curves.push_back(curve);
  }
  directory.write("objects.csv", csv.text());
  directory.write("fig-8-18.svg", plot_svg("Fig. 8.18: objects of different sizes on a background of 2 px", panels, 3));
  result["figures"] = {
      {{"file", "fig-8-18.svg"}, {"title", "Fig. 8.18: detected part of square objects over their size"}}};

  Statements statements;
  const auto list = [&](std::size_t first) {
    std::string text;
    for (std::size_t i = first; i < first + 5; ++i) text += fmt::format(" {:.1f}", smallest[i]);
    return text;
  };
  bool rising = true;
  for (const std::size_t first : {0, 5})
    for (std::size_t i = first + 1; i < first + 5; ++i) rising = rising && smallest[i] > smallest[i - 1];
  statements.add("8.5", "Large kernels suppress small objects more.",
                 fmt::format("Half of the pixels are detected from sides of{} px on (5×5 … 13×13)", list(0)),
                 verdict(rising, smallest[4] > smallest[0]),
                 "The side rises with every kernel, with and without low-pass; partly: from 5×5 to 13×13");
  int larger = 0;
  for (std::size_t i = 0; i < 5; ++i) larger += smallest[i + 5] > smallest[i] ? 1 : 0;
  statements.add("8.5", "A low-pass before suppresses small objects more.",
                 fmt::format("With it from{} px on", list(5)), verdict(larger == 5, larger > 0),
                 "A larger side for every kernel; partly: for some");
  result["statements"] = statements.json();
  result["findings"] = {
      fmt::format("Half of an object's pixels are detected from a side of{} px on with DSAD LP 5×5 … 13×13, {:.1f} px "
                  "with the hardware's 9×9",
                  list(5), smallest[11])};
  return result;
}

}  // namespace horopter::cli
