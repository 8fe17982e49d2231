// SPDX-License-Identifier: Apache-2.0
// Thesis 11.2.3: scenes that lead to errors: textures that repeat, even changes of brightness, clipped grey values.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>

#include "conditions.hpp"
#include "horopter/calib/random.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using study::Feature;
using study::Plane;
using study::Setting;

constexpr double kThreshold = 0.184;    ///< of T_max: D50 is 1 px (Table 11.2)
constexpr double kDisplacement_px = 8;  ///< of objects that are not in the skin; the period of what repeats
constexpr int kWidth = 320;
constexpr int kHeight = 240;

/// A photograph of a picture that is drawn pixel by pixel.
study::Conditions conditions_of(const StudyScope& scope, const std::function<int(int x, int y)>& grey) {
  constexpr int kBorder = 2 * static_cast<int>(kDisplacement_px) + 20;
  auto picture = std::make_shared<Image>(kWidth + 2 * kBorder, kHeight + 2 * kBorder);
  for (int y = 0; y < picture->height; ++y)
    for (int x = 0; x < picture->width; ++x) picture->at(x, y) = static_cast<std::uint8_t>(grey(x, y));
  study::Conditions conditions = chapter8_conditions(scope);
  conditions.texture.kind = study::TextureKind::picture;
  conditions.texture.picture = std::move(picture);
  return conditions;
}

study::Conditions with_camera(study::Conditions conditions) {
  conditions.camera.width = kWidth;
  conditions.camera.height = kHeight;
  conditions.electronics.averaged = 1;
  return conditions;
}

/// Percent of the pixels that DSAD LP 9×9 takes for undisplaced.
double detected_percent(const Image& left, const Image& right) {
  const Setting setting{&study::criterion("DSAD"), {Feature::direction, true}, 9};
  const auto found = study::detect({left, {0, 1}, [&](std::size_t) { return right; }}, {setting});
  return 100 * found[0].rates(kThreshold * setting.criterion->worst(9))[0];
}
double displaced_percent(const study::Simulation& simulation) {
  return detected_percent(simulation.photograph(0, 0), simulation.photograph(kDisplacement_px, 1));
}

Statement repetition(const StudyScope& scope, double of_leaves) {
  using namespace measured;
  calib::Random random(scope.seed, 7);
  std::vector<int> tile;
  constexpr int kPeriod = static_cast<int>(kDisplacement_px);
  for (int i = 0; i < kPeriod * 1000; ++i) tile.push_back(static_cast<int>(255 * random.uniform()));
  const study::Simulation repeated(
      with_camera(conditions_of(
          scope, [&](int x, int y) { return tile[static_cast<std::size_t>(x % kPeriod + kPeriod * y)]; })),
      kDisplacement_px);
  return {
      "Not only low texture, but also repetitive texture may lead to errors (Fig. 11.10).",
      {displaced_percent(repeated), of_leaves},
      "Displaced by its period of 8 px a texture is detected with 18.4 % of T_max in {:.0f} % of the pixels; one that "
      "does not repeat in {:.2f} %",
      "In half of them at least, and in below 1 % of the other; partly: ten times as many",
      {first >= 50 && second < 1, first > 10 * second},
      "a texture that repeats itself is detected where nothing is in the skin"};
}

Statement ramp(const StudyScope& scope) {
  using namespace measured;
  study::Conditions conditions = with_camera(conditions_of(scope, [](int x, int) { return std::min(x / 2, 255); }));
  conditions.lighting.slope_x = 0;
  conditions.lighting.deviation_grey = 2;  // about a grey level a pixel
  const study::Simulation simulation(conditions, kDisplacement_px);
  const Image left = simulation.photograph(0, 0);
  const Image right = simulation.photograph(kDisplacement_px, 1);
  double apart = 0;
  for (std::size_t i = 0; i < left.pixels.size(); ++i)
    apart += std::abs(left.pixels[i] - right.pixels[i]) / static_cast<double>(left.pixels.size());
  return {
      "Objects that have a monotone intensity change may result in low dissimilarity values even if the intensity "
      "itself does not correspond.",
      {detected_percent(left, right), apart},
      "A ramp displaced by 8 px, {1:.1f} grey levels apart: {0:.0f} % of the pixels detected with 18.4 % of T_max",
      "Half of them at least; partly: a tenth",
      {first >= 50, first >= 10}};
}

std::vector<Statement> clipped(const study::Simulation& simulation) {
  using namespace measured;
  const auto brighter = [&](double shift_px, double by, std::uint64_t number) {
    Plane still = simulation.exact(shift_px);
    for (double& grey : still.values) grey += by;
    return simulation.expose(still, simulation.conditions().electronics, number);
  };
  constexpr double kOver = 300;  // everything is 255
  const double both = detected_percent(brighter(0, kOver, 0), brighter(kDisplacement_px, kOver, 1));
  const double one = detected_percent(brighter(0, 0, 0), brighter(0, kOver, 1));
  const double none = detected_percent(brighter(0, 0, 0), brighter(0, 0, 1));
  return {
      {"If both images have regions with constant values, these regions erroneously correspond.",
       {both},
       "All 255 in both: {:.0f} % of the pixels detected with 18.4 % of T_max. A pair without gradients counts as 25 % of "
       "T_max here, as in the machine; the thesis's angle of (0, 0) would be 0 in both",
       "Half of them at least",
       {first >= 50}},
      {"If only one image is over-exposed, objects could be missed.",
       {one, none},
       "In the skin, one image all 255: {:.0f} % of the pixels detected; well exposed {:.0f} %",
       "Fewer than a tenth; partly: fewer",
       {first < 10 && second >= 90, first < second}}};
}

}  // namespace

void study_problems(StudyReport& report, const StudyScope& scope) {
  const study::Simulation leaves(with_camera(chapter8_conditions(scope)), kDisplacement_px);
  report.result["conditions"] = to_json(leaves.conditions());
  report.state("11.2.3", {repetition(scope, displaced_percent(leaves)), ramp(scope)});
  report.state("11.2.3", clipped(leaves));
  Csv table({"statement", "found"});
  for (const auto& row : report.result["statements"]) {
    table.row(row["statement"].get<std::string>(), row["figure"].get<std::string>());
    report.finding("{} {}", row["statement"].get<std::string>(), row["figure"].get<std::string>());
  }
  report.table("problems.csv", table);
}

}  // namespace horopter::cli
