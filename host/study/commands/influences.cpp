// SPDX-License-Identifier: Apache-2.0
// Table 8.4: noise, differing scale and differing blur between the two images, at the same place: what is still
// detected with the threshold of 1 px.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "conditions.hpp"
#include "horopter/study/filters.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using study::Feature;
using study::Plane;
using study::Setting;

struct Member {
  std::string group;
  Setting setting;
};

std::vector<Member> members() {
  std::vector<Member> result;
  const auto grey = [&](const char* group, const char* name, bool lowpass, bool highpass) {
    result.push_back({group, {&study::criterion(name), {Feature::grey, lowpass, highpass}, 9}});
  };
  for (const char* name : {"NCC", "SAD", "SSD"}) grey("grey", name, true, false);
  for (const char* name : {"ZNCC", "ZSAD", "LSAD", "LSSD"}) grey("zero-mean, scaled", name, true, false);
  for (const char* name : {"NCC", "ZNCC", "SAD", "SSD"}) grey("high-pass", name, false, true);
  for (const double w : {2.5, 5.0, 9.0})
    result.push_back(
        {fmt::format("NISH w={:g}", w), {&study::criterion("NISH"), {Feature::log_sign, false, false, w}, 9}});
  result.push_back({"DSAD", {&study::criterion("DSAD"), {Feature::direction, true}, 9}});
  return result;
}

/// The image enlarged along the lines about its middle column.
Plane stretched(const Plane& image, double scale) {
  Plane result(image.width, image.height);
  const double middle = (image.width - 1) / 2.0;
  for (int x = 0; x < image.width; ++x) {
    const double place = std::clamp(middle + (x - middle) / scale, 1.0, image.width - 3.0);
    const int first = static_cast<int>(place);
    const double u = place - first;
    for (int y = 0; y < image.height; ++y) {
      const double* p = image.row(y) + first;
      result.at(x, y) =
          p[0] +
          0.5 * u *
              (p[1] - p[-1] + u * (2 * p[-1] - 5 * p[0] + 4 * p[1] - p[2] + u * (3 * (p[0] - p[1]) + p[2] - p[-1])));
    }
  }
  return result;
}

Image middle_columns(const Image& image, int count) {
  Image result(count, image.height);
  const int first = (image.width - count) / 2;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < count; ++x) result.at(x, y) = image.at(first + x, y);
  return result;
}

struct Influence {
  const char* name;
  const char* unit;
  std::vector<double> levels;
};

std::vector<Influence> influences() {
  return {{"noise", "standard deviation of both images, grey levels", {1, 2, 4, 6, 8, 12}},
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

  /// Only near the middle column is there no displacement as well: three columns are measured.
  Rates scaled(const std::vector<double>& levels) const {
    const int columns = 2 * reach_ + 3;
    return rates({middle_columns(reference_, columns), levels, [&](std::size_t i) {
                    const Plane larger = stretched(still_, 1 + levels[i] / 100);
                    return middle_columns(simulation_.expose(larger, simulation_.conditions().electronics, 100 + i),
                                          columns);
                  }});
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

/// Mean rate over the levels, by influence and group.
class Scores {
 public:
  std::map<std::string, std::map<std::string, double>> of;

  std::string figure(const std::string& influence) const {
    std::string text;
    for (const auto& [score, group] : ranked(influence))
      text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", group, -100 * score);
    return text;
  }
  /// From 1, the best.
  int place(const std::string& influence, const std::string& group) const {
    const auto list = ranked(influence);
    const auto at = std::ranges::find(list, group, [](const auto& entry) { return entry.second; });
    return static_cast<int>(at - list.begin()) + 1;
  }
  double score(const std::string& influence, const std::string& group) const { return of.at(influence).at(group); }
  int last() const { return static_cast<int>(of.at("noise").size()); }

 private:
  /// Groups from best to worst, with −score.
  std::vector<std::pair<double, std::string>> ranked(const std::string& influence) const {
    std::vector<std::pair<double, std::string>> list;
    for (const auto& [group, score] : of.at(influence)) list.emplace_back(-score, group);
    std::sort(list.begin(), list.end());
    return list;
  }
};

std::vector<Statement> statements(const Scores& scores) {
  using namespace measured;
  const double last = scores.last();
  std::vector<Statement> table;
  const auto add = [&](const char* influence, const char* quote, AllMeasured numbers, const char* rule,
                       const Limits& limits) {
    const std::string figure = "Detected on average over the levels: " + scores.figure(influence);
    table.push_back({quote, std::move(numbers), figure, rule, limits});
  };
  const auto place = [&](const char* influence, const char* group) { return scores.place(influence, group); };
  const auto score = [&](const char* influence, const char* group) { return scores.score(influence, group); };
  add("noise", "Noise: criteria on grey values perform best.", {place("noise", "grey")},
      "First of the groups; partly: second", {first <= 1, first <= 2});
  add("noise", "Noise: criteria on high-pass filtered images are worst (up to 17×17).", {place("noise", "high-pass")},
      "Last; partly: last but one", {first >= last, first >= last - 1});
  add("noise", "Noise: DSAD is slightly worse than criteria on low-pass filtered grey values.",
      {score("noise", "DSAD"), score("noise", "grey"), score("noise", "high-pass")},
      "Below them, above the high-pass; partly: below them", {first < second && first > third, first < second});
  add("noise", "Noise: NISH is medium for w = 5, else worse.",
      {score("noise", "NISH w=5"), score("noise", "NISH w=2.5"), score("noise", "NISH w=9")},
      "w = 5 above 2.5 and 9; partly: above 2.5", {first > second && first > third, first > second});
  add("scaling", "Scaling: criteria on grey values perform well.", {place("scaling", "grey")},
      "First or second; partly: third", {first <= 2, first <= 3});
  add("scaling", "Scaling: criteria on high-pass filtered images are the worst of all.",
      {place("scaling", "high-pass")}, "Last; partly: last but one", {first >= last, first >= last - 1});
  add("scaling", "Scaling: NISH performs badly, especially for small and large w.",
      {score("scaling", "NISH w=5"), score("scaling", "NISH w=2.5"), score("scaling", "NISH w=9"),
       place("scaling", "NISH w=5")},
      "w = 5 above 2.5 and 9, not among the first two; partly: the latter",
      {first > second && first > third && fourth > 2, fourth > 2});
  add("scaling", "Scaling: DSAD performs well with medium kernels.", {place("scaling", "DSAD")},
      "First or second; partly: up to fourth", {first <= 2, first <= 4});
  add("blurring", "Blurring: grey values well, zero-mean and scaled criteria slightly worse.",
      {score("blurring", "grey"), score("blurring", "zero-mean, scaled"), place("blurring", "grey")},
      "In this order, the former first or second; partly: in this order",
      {first > second && third <= 2, first > second});
  add("blurring", "Blurring: criteria on high-pass filtered images are worst.", {place("blurring", "high-pass")},
      "Last; partly: last but one", {first >= last, first >= last - 1});
  add("blurring", "Blurring: NISH is worst for w > 6, medium for less.",
      {score("blurring", "NISH w=9"), score("blurring", "NISH w=5")}, "w = 9 below w = 5", {first < second});
  add("blurring", "Blurring: DSAD is medium.", {place("blurring", "DSAD")}, "Neither first nor last",
      {first > 1 && first < last});
  return table;
}

}  // namespace

void study_influences(StudyReport& report, const StudyScope& scope) {
  const study::Conditions conditions = chapter8_conditions(scope);
  report.result["conditions"] = to_json(conditions);
  const study::Simulation simulation(conditions, 3);
  const std::vector<Member> all = members();
  std::vector<Setting> settings;
  std::map<std::string, int> sizes;
  for (const Member& member : all) {
    settings.push_back(member.setting);
    ++sizes[member.group];
  }
  const Influenced influenced(simulation, settings);
  Csv csv({"influence", "level", "group", "setting", "detected"});
  std::vector<Panel> panels;
  Scores scores;
  for (const Influence& influence : influences()) {
    const auto rates = influenced.rates(influence);
    std::map<std::string, Curve> curves;
    for (std::size_t i = 0; i < all.size(); ++i) {
      Curve& curve = curves[all[i].group];
      curve.name = all[i].group;
      curve.points.resize(influence.levels.size());
      for (std::size_t level = 0; level < influence.levels.size(); ++level) {
        csv.row(influence.name, influence.levels[level], all[i].group, name_of(all[i].setting), rates[i][level]);
        const double share = rates[i][level] / sizes[all[i].group];
        curve.points[level].first = influence.levels[level];
        curve.points[level].second += 100 * share;
        scores.of[influence.name][all[i].group] += share / static_cast<double>(influence.levels.size());
      }
    }
    Panel& panel =
        panels.emplace_back(Panel{influence.name, influence.unit, "detected with the threshold of 1 px, %", {}});
    for (const auto& [group, curve] : curves) panel.curves.push_back(curve);
  }
  report.table("table-8-4.csv", csv);
  report.plot(
      "table-8-4.svg",
      "Table 8.4: what is still detected with the threshold of 1 px under noise, differing scale, differing blur",
      panels, 3);
  report.result["scores"] = scores.of;
  report.state("8.3, Table 8.4", statements(scores));
  report.finding("Noise: {}", scores.figure("noise"));
  report.finding("Scaling: {}", scores.figure("scaling"));
  report.finding("Blurring: {}", scores.figure("blurring"));
}

}  // namespace horopter::cli
