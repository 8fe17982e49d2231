// SPDX-License-Identifier: Apache-2.0
// Table 8.4: noise, differing scale and differing blur between the two images, at the same place: what is still
// detected with the threshold of 1 px.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "conditions.hpp"
#include "horopter/base/csv.hpp"
#include "horopter/draw/plot.hpp"
#include "horopter/study/filters.hpp"
#include "statements.hpp"
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

}  // namespace

nlohmann::json study_influences(OutputDirectory& directory, const StudyScope& scope) {
  const study::Conditions conditions = chapter8_conditions(scope);
  const study::Simulation simulation(conditions, 3);
  const std::vector<Member> all = members();
  std::vector<Setting> settings;
  int reach = 0;
  for (const Member& member : all) {
    settings.push_back(member.setting);
    reach = std::max(reach, reach_of(member.setting));
  }
  StudyScope quick;
  quick.quick = true;
  const auto normal = study::detect(photographs(simulation, chapter8_disparities(quick)), settings);
  const Plane still = simulation.exact(0);
  const Image reference = simulation.photograph(0, 0);

  struct Influence {
    const char* name;
    const char* unit;
    std::vector<double> levels;
  };
  const std::vector<Influence> influences{
      {"noise", "standard deviation of both images [grey levels]", {1, 2, 4, 6, 8, 12}},
      {"scaling", "one image larger by [%]", {5, 10, 15, 20, 30, 40}},
      {"blurring", "one image blurred by a Gaussian of [px]", {0.3, 0.6, 0.9, 1.2, 1.6, 2}}};
  Csv csv({"influence", "level", "group", "setting", "detected"});
  std::vector<Panel> panels;
  std::map<std::string, std::map<std::string, double>> scores;  // mean rate over levels, by influence and group
  std::map<std::string, int> sizes;
  for (const Member& member : all) ++sizes[member.group];
  for (const Influence& influence : influences) {
    study::Electronics electronics = conditions.electronics;
    study::ImageSeries series;
    series.reference = reference;
    series.disparities_px = influence.levels;
    const std::string name = influence.name;
    if (name == "noise") {
      // The reference's noise grows as well: each level has its own.
      electronics.averaged = 1;
    } else if (name == "scaling") {
      // Only near the middle column is there no displacement as well: three columns are measured.
      series.reference = middle_columns(reference, 2 * reach + 3);
      series.image = [&](std::size_t i) {
        return middle_columns(simulation.expose(stretched(still, 1 + influence.levels[i] / 100), electronics, 100 + i),
                              2 * reach + 3);
      };
    } else {
      series.image = [&](std::size_t i) {
        return simulation.expose(study::gaussian(still, influence.levels[i]), electronics, 200 + i);
      };
    }
    std::vector<std::vector<double>> rates(all.size(), std::vector<double>(influence.levels.size()));
    if (name == "noise") {
      for (std::size_t level = 0; level < influence.levels.size(); ++level) {
        study::Electronics noisy = electronics;
        noisy.noise_grey = influence.levels[level];
        study::ImageSeries pair;
        pair.reference = simulation.expose(still, noisy, 300 + 2 * level);
        pair.disparities_px = {0, 1};
        pair.image = [&](std::size_t) { return simulation.expose(still, noisy, 301 + 2 * level); };
        const auto found = study::detect(pair, settings);
        for (std::size_t i = 0; i < all.size(); ++i) rates[i][level] = found[i].rates(normal[i].threshold(1))[0];
      }
    } else {
      const auto found = study::detect(series, settings);
      for (std::size_t i = 0; i < all.size(); ++i) rates[i] = found[i].rates(normal[i].threshold(1));
    }
    Panel panel{name, influence.unit, "detected with the threshold of 1 px [%]", {}, false};
    std::map<std::string, Curve> curves;
    for (std::size_t i = 0; i < all.size(); ++i) {
      Curve& curve = curves[all[i].group];
      curve.name = all[i].group;
      curve.points.resize(influence.levels.size());
      for (std::size_t level = 0; level < influence.levels.size(); ++level) {
        csv << name << influence.levels[level] << all[i].group << name_of(all[i].setting) << rates[i][level];
        csv.end_row();
        const double share = rates[i][level] / sizes[all[i].group];
        curve.points[level].first = influence.levels[level];
        curve.points[level].second += 100 * share;
        scores[name][all[i].group] += share / static_cast<double>(influence.levels.size());
      }
    }
    for (const auto& [group, curve] : curves) panel.curves.push_back(curve);
    panels.push_back(panel);
  }
  directory.write("table-8-4.csv", csv.text());
  directory.write("table-8-4.svg", plot_svg("Table 8.4: noise, scaling and blurring, 9×9", panels, 3));

  nlohmann::json result{{"conditions", to_json(conditions)}, {"scores", scores}};
  result["figures"] = {
      {{"file", "table-8-4.svg"},
       {"title",
        "Table 8.4: what is still detected with the threshold of 1 px under noise, differing scale, differing blur"}}};
  Statements statements;
  /// Groups from best to worst.
  const auto ranked = [&](const std::string& influence) {
    std::vector<std::pair<double, std::string>> list;
    for (const auto& [group, score] : scores.at(influence)) list.emplace_back(-score, group);
    std::sort(list.begin(), list.end());
    return list;
  };
  const auto place = [&](const std::string& influence, const std::string& group) {
    const auto list = ranked(influence);
    for (std::size_t i = 0; i < list.size(); ++i)
      if (list[i].second == group) return static_cast<int>(i) + 1;
    return 0;
  };
  const auto figure = [&](const std::string& influence) {
    std::string text;
    for (const auto& [score, group] : ranked(influence))
      text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", group, -100 * score);
    return text;
  };
  const int last = static_cast<int>(scores.at("noise").size());
  const auto score = [&](const std::string& influence, const std::string& group) {
    return scores.at(influence).at(group);
  };
  const auto add = [&](const char* influence, const char* statement, Verdict found, const char* rule) {
    statements.add("8.3, Table 8.4", statement, "Detected on average over the levels: " + figure(influence), found,
                   rule);
  };
  add("noise", "Noise: criteria on grey values perform best.",
      verdict(place("noise", "grey") == 1, place("noise", "grey") <= 2), "First of the groups; partly: second");
  add("noise", "Noise: criteria on high-pass filtered images are worst (up to 17×17).",
      verdict(place("noise", "high-pass") == last, place("noise", "high-pass") == last - 1),
      "Last; partly: last but one");
  add("noise", "Noise: DSAD is slightly worse than criteria on low-pass filtered grey values.",
      verdict(score("noise", "DSAD") < score("noise", "grey") && score("noise", "DSAD") > score("noise", "high-pass"),
              score("noise", "DSAD") < score("noise", "grey")),
      "Below them, above the high-pass; partly: below them");
  add("noise", "Noise: NISH is medium for w = 5, else worse.",
      verdict(score("noise", "NISH w=5") > score("noise", "NISH w=2.5") &&
                  score("noise", "NISH w=5") > score("noise", "NISH w=9"),
              score("noise", "NISH w=5") > score("noise", "NISH w=2.5")),
      "w = 5 above 2.5 and 9; partly: above 2.5");
  add("scaling", "Scaling: criteria on grey values perform well.",
      verdict(place("scaling", "grey") <= 2, place("scaling", "grey") <= 3), "First or second; partly: third");
  add("scaling", "Scaling: criteria on high-pass filtered images are the worst of all.",
      verdict(place("scaling", "high-pass") == last, place("scaling", "high-pass") >= last - 1),
      "Last; partly: last but one");
  add("scaling", "Scaling: NISH performs badly, especially for small and large w.",
      verdict(score("scaling", "NISH w=5") > score("scaling", "NISH w=2.5") &&
                  score("scaling", "NISH w=5") > score("scaling", "NISH w=9") && place("scaling", "NISH w=5") > 2,
              place("scaling", "NISH w=5") > 2),
      "w = 5 above 2.5 and 9, not among the first two; partly: the latter");
  add("scaling", "Scaling: DSAD performs well with medium kernels.",
      verdict(place("scaling", "DSAD") <= 2, place("scaling", "DSAD") <= 4), "First or second; partly: up to fourth");
  add("blurring", "Blurring: grey values well, zero-mean and scaled criteria slightly worse.",
      verdict(score("blurring", "grey") > score("blurring", "zero-mean, scaled") && place("blurring", "grey") <= 2,
              score("blurring", "grey") > score("blurring", "zero-mean, scaled")),
      "In this order, the former first or second; partly: in this order");
  add("blurring", "Blurring: criteria on high-pass filtered images are worst.",
      verdict(place("blurring", "high-pass") == last, place("blurring", "high-pass") == last - 1),
      "Last; partly: last but one");
  add("blurring", "Blurring: NISH is worst for w > 6, medium for less.",
      verdict(score("blurring", "NISH w=9") < score("blurring", "NISH w=5"), false), "w = 9 below w = 5");
  add("blurring", "Blurring: DSAD is medium.",
      verdict(place("blurring", "DSAD") > 1 && place("blurring", "DSAD") < last, false), "Neither first nor last");
  result["statements"] = statements.json();
  result["findings"] = {"Noise: " + figure("noise"), "Scaling: " + figure("scaling"),
                        "Blurring: " + figure("blurring")};
  return result;
}

}  // namespace horopter::cli
