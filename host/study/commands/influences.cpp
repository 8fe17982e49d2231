// SPDX-License-Identifier: Apache-2.0
// Table 8.4: noise, differing scale and differing blur between the two images: what is still detected with the threshold
// of 1 px where nothing is displaced.
#include "influences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "conditions.hpp"
#include "horopter/study/filters.hpp"
#include "horopter/study/parallel.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using study::Feature;
using study::Plane;
using study::Setting;

/// A setting of a group, with one kernel.
struct Member {
  std::string group;
  Setting setting;
};

std::vector<Member> members() {
  std::vector<Member> result;
  const auto add = [&](const std::string& group, const char* name, const study::Preparation& preparation) {
    for (const int kernel : kInfluencedKernels)
      result.push_back({group, {&study::criterion(name), preparation, kernel}});
  };
  for (const char* name : {"NCC", "SAD", "SSD"}) {
    add(kGreyRaw, name, {Feature::grey, false, false});
    add(kGreyLow, name, {Feature::grey, true, false});
  }
  for (const char* name : {"ZNCC", "ZSAD", "LSAD", "LSSD"}) add(kZeroLow, name, {Feature::grey, true, false});
  for (const char* name : {"NCC", "ZNCC", "SAD", "SSD"}) add(kHigh, name, {Feature::grey, false, true});
  for (const double w : {2.5, 5.0, 7.0, 9.0})
    add(fmt::format("NISH w={:g}", w), "NISH", {Feature::log_sign, false, false, w});
  add(kDirections, "DSAD", {Feature::direction, true});
  return result;
}

double cubic(double before, double first, double second, double after, double u) {
  return first + 0.5 * u *
                     (second - before +
                      u * (2 * before - 5 * first + 4 * second - after + u * (3 * (first - second) + after - before)));
}

/// Catmull-Rom, between the image's second and last but one pixels.
double sample(const Plane& image, double x, double y) {
  x = std::clamp(x, 1.0, image.width - 3.0);
  y = std::clamp(y, 1.0, image.height - 3.0);
  const int i = static_cast<int>(x);
  const int j = static_cast<int>(y);
  const auto along = [&](int row) {
    const double* p = image.row(row) + i;
    return cubic(p[-1], p[0], p[1], p[2], x - i);
  };
  return cubic(along(j - 1), along(j), along(j + 1), along(j + 2), y - j);
}

/// Square tiles, and the 3×3 pixels in the middle of each: there an image that is enlarged about each tile's middle is not
/// displaced.
struct Tiles {
  int width, height, side;
  /// f(x, y) for the middle of each.
  template <class F>
  void each(F f) const {
    for (int y = side / 2; y + side / 2 < height; y += side)
      for (int x = side / 2; x + side / 2 < width; x += side) f(x, y);
  }
  Plane enlarged(const Plane& image, double scale) const {
    Plane result = image;
    each([&](int middle_x, int middle_y) {
      for (int y = middle_y - side / 2; y <= middle_y + side / 2; ++y)
        for (int x = middle_x - side / 2; x <= middle_x + side / 2; ++x)
          result.at(x, y) = sample(image, middle_x + (x - middle_x) / scale, middle_y + (y - middle_y) / scale);
    });
    return result;
  }
  /// The values of the middles, in a row.
  Plane middles(const Plane& values) const {
    Plane result;
    each([&](int middle_x, int middle_y) {
      for (int y = middle_y - 1; y <= middle_y + 1; ++y)
        for (int x = middle_x - 1; x <= middle_x + 1; ++x) result.values.push_back(values.at(x, y));
    });
    result.width = static_cast<int>(result.values.size());
    result.height = 1;
    return result;
  }
};

struct Influence {
  const char* name;
  const char* unit;
  std::vector<double> levels;
};

std::vector<Influence> influences() {
  // Noise from a twelfth of the texture's contrast to all of it: with less everything is detected, and nothing ranked.
  return {{"noise", "standard deviation of both images, grey levels", {2.5, 5, 10, 15, 20, 30}},
          {"scaling", "one image larger by, %", {5, 10, 15, 20, 30, 40}},
          {"blurring", "one image blurred by a Gaussian of, px", {0.3, 0.6, 0.9, 1.2, 1.6, 2}}};
}

/// The images at zero disparity, and what an influence makes of them.
class Influenced {
 public:
  Influenced(const study::Simulation& simulation, const std::vector<Setting>& settings)
      : simulation_(simulation),
        settings_(settings),
        still_(simulation.exact(0)),
        reference_(simulation.photograph(0, 0)) {
    for (const Setting& setting : settings) reach_ = std::max(reach_, reach_of(setting));
    StudyScope quick;
    quick.quick = true;
    for (const auto& normal : study::detect(photographs(simulation, chapter8_disparities(quick)), settings))
      thresholds_.push_back(normal.threshold(1));
  }

  /// By setting, the rate at each level.
  std::vector<std::vector<double>> rates(const Influence& influence) const {
    const std::string name = influence.name;
    return name == "noise"     ? with_noise(influence.levels)
           : name == "scaling" ? scaled(influence.levels)
                               : blurred(influence.levels);
  }

 private:
  using Rates = std::vector<std::vector<double>>;

  Rates rates(const study::ImageSeries& series) const {
    const auto found = study::detect(series, settings_);
    Rates result;
    for (std::size_t i = 0; i < settings_.size(); ++i) result.push_back(found[i].rates(thresholds_[i]));
    return result;
  }

  /// The reference's noise grows as well: each level has its own.
  Rates with_noise(const std::vector<double>& levels) const {
    study::Electronics electronics = simulation_.conditions().electronics;
    electronics.averaged = 1;
    Rates result(settings_.size());
    for (std::size_t level = 0; level < levels.size(); ++level) {
      electronics.noise_grey = levels[level];
      const auto expose = [&](std::size_t number) { return simulation_.expose(still_, electronics, number); };
      const Rates found =
          rates({expose(300 + 2 * level), {0, 1}, [&](std::size_t) { return expose(301 + 2 * level); }});
      for (std::size_t i = 0; i < settings_.size(); ++i) result[i].push_back(found[i][0]);
    }
    return result;
  }

  Rates scaled(const std::vector<double>& levels) const {
    const Tiles tiles{reference_.width, reference_.height, 2 * reach_ + 3};
    Rates result(settings_.size(), std::vector<double>(levels.size()));
    study::parallel_for(levels.size(), [&](std::size_t level) {
      const Plane larger = tiles.enlarged(still_, 1 + levels[level] / 100);
      const Image image = simulation_.expose(larger, simulation_.conditions().electronics, 100 + level);
      Plane r;
      Plane s;
      for (std::size_t i = 0; i < settings_.size(); ++i) {
        const Setting& setting = settings_[i];
        if (i == 0 || setting.preparation != settings_[i - 1].preparation) {
          r = prepare(reference_, setting.preparation);
          s = prepare(image, setting.preparation);
        }
        study::Pair pair(r, s);
        pair.set_kernel(setting.kernel);
        const study::Histogram found(tiles.middles(setting.criterion->compare(pair)),
                                     setting.criterion->best(setting.kernel), 0);
        result[i][level] = found.share(thresholds_[i]);
      }
    });
    return result;
  }

  Rates blurred(const std::vector<double>& levels) const {
    return rates({reference_, levels, [&](std::size_t i) {
                    return simulation_.expose(study::gaussian(still_, levels[i]), simulation_.conditions().electronics,
                                              200 + i);
                  }});
  }

  const study::Simulation& simulation_;
  const std::vector<Setting>& settings_;
  Plane still_;
  Image reference_;
  int reach_ = 0;
  std::vector<double> thresholds_;
};

/// 8.2: both images blurred alike. D50 where it was 1 px, of DSAD and of NCC.
std::array<double, 2> blurred_alike(const study::Simulation& simulation) {
  constexpr double kBlur_px = 1;
  const std::vector<Setting> settings{{&study::criterion("DSAD"), {Feature::direction, true}, 9},
                                      {&study::criterion("NCC"), {Feature::grey, true}, 9}};
  StudyScope quick;
  quick.quick = true;
  study::ImageSeries series = photographs(simulation, chapter8_disparities(quick));
  const auto normal = study::detect(series, settings);
  const auto blurred = [&](double shift_px, std::uint64_t number) {
    return simulation.expose(study::gaussian(simulation.exact(shift_px), kBlur_px), simulation.conditions().electronics,
                             number);
  };
  series.reference = blurred(0, 400);
  series.image = [&](std::size_t i) { return blurred(series.disparities_px[i], 401 + i); };
  const auto found = study::detect(series, settings);
  std::array<double, 2> result{};
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = found[i].disparity_at(normal[i].threshold(1), 0.5).value_or(series.disparities_px.back());
  return result;
}

}  // namespace

void study_influences(StudyReport& report, const StudyScope& scope) {
  using namespace measured;
  const study::Conditions conditions = chapter8_conditions(scope);
  report.result["conditions"] = to_json(conditions);
  const study::Simulation simulation(conditions, 3);
  const std::vector<Member> all = members();
  std::vector<Setting> settings;
  std::map<std::pair<std::string, int>, int> sizes;
  for (const Member& member : all) {
    settings.push_back(member.setting);
    ++sizes[{member.group, member.setting.kernel}];
  }
  const Influenced influenced(simulation, settings);
  Csv csv({"influence", "level", "group", "setting", "detected"});
  std::vector<Panel> panels;
  Scores scores;
  for (const Influence& influence : influences()) {
    const auto rates = influenced.rates(influence);
    std::map<std::string, Curve> curves;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const int kernel = all[i].setting.kernel;
      Curve& curve = curves[all[i].group];
      curve.name = all[i].group;
      curve.points.resize(influence.levels.size());
      for (std::size_t level = 0; level < influence.levels.size(); ++level) {
        csv.row(influence.name, influence.levels[level], all[i].group, name_of(all[i].setting), rates[i][level]);
        const double share = rates[i][level] / sizes[{all[i].group, kernel}];
        curve.points[level].first = influence.levels[level];
        if (kernel == 9) curve.points[level].second += 100 * share;
        scores.add(influence.name, kernel, all[i].group, share / static_cast<double>(influence.levels.size()));
      }
    }
    Panel& panel =
        panels.emplace_back(Panel{influence.name, influence.unit, "detected with the threshold of 1 px, 9×9, %", {}});
    for (const auto& [group, curve] : curves) panel.curves.push_back(curve);
    report.finding("{}: {}", influence.name, scores.figure(influence.name));
  }
  report.table("table-8-4.csv", csv);
  report.plot(
      "table-8-4.svg",
      "Table 8.4: what is still detected with the threshold of 1 px under noise, differing scale, differing blur",
      panels, 3);
  report.state("8.3.2", noise_statements(scores));
  report.state("8.3.3", scaling_and_blurring_statements(scores));
  const auto [dsad, ncc] = blurred_alike(simulation);
  report.state("8.3.3", {{"The same amount of blurring in both pictures increases the tolerable disparity (8.2).",
                          {dsad, ncc},
                          "A Gaussian of 1 px on both moves D50 from 1 px to {:.2f} px (DSAD) and {:.2f} px (NCC)",
                          "Beyond 1.1 px for both; partly: for one",
                          {first > 1.1 && second > 1.1, first > 1.1 || second > 1.1}}});
}

}  // namespace horopter::cli
