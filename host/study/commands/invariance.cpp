// SPDX-License-Identifier: Apache-2.0
// Table 8.3: what changes of brightness do to each criterion.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "cli/progress.hpp"
#include "conditions.hpp"
#include "horopter/study/filters.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using study::Feature;
using study::Plane;
using study::Preparation;

constexpr double kOffset = 20;
constexpr double kScale = 1.25;      ///< exact in floating point, so that equal grey values stay equal
constexpr double kTolerance = 1e-4;  ///< of the criterion's mean

constexpr double kLargestFootnote = 1.2;  ///< scaling that a footnote says to be tolerable

enum class Effect { yes, scaled, no };  ///< as in the table: invariant, scaled, neither

const char* name_of(Effect effect) {
  return effect == Effect::yes ? "yes" : effect == Effect::scaled ? "scaled" : "no";
}

/// A row of the table; effects of a common offset, a common scaling, a different offset, a different scaling.
struct InvarianceRow {
  std::vector<std::string> criteria;
  std::vector<bool> highpass;
  std::array<Effect, 4> effects;
};

std::vector<InvarianceRow> table() {
  using enum Effect;
  return {{{"NCC"}, {false}, {no, yes, no, yes}},
          {{"NCC"}, {true}, {yes, yes, yes, yes}},
          {{"ZNCC"}, {false, true}, {yes, yes, yes, yes}},
          {{"MOR"}, {false, true}, {yes, yes, yes, no}},
          {{"NISH"}, {false}, {yes, yes, yes, yes}},
          {{"SAD", "SSD"}, {false}, {yes, scaled, no, no}},
          {{"SAD", "SSD"}, {true}, {yes, scaled, yes, no}},
          {{"DSAD", "DSSD"}, {false}, {yes, yes, yes, yes}},
          {{"ZSAD", "ZSSD"}, {false, true}, {yes, scaled, yes, no}},
          {{"LSAD", "LSSD"}, {false}, {no, scaled, no, scaled}},
          {{"LSAD", "LSSD"}, {true}, {yes, scaled, yes, scaled}},
          {{"NSAD"}, {false}, {no, yes, no, no}},
          {{"NSAD"}, {true}, {yes, yes, yes, no}},
          {{"ZNSSD"}, {false}, {yes, yes, yes, no}},
          {{"ZNSSD"}, {true}, {yes, yes, yes, no}}};
}

Plane changed(const Plane& image, double scale, double offset) {
  Plane result = image;
  for (double& value : result.values) value = scale * value + offset;
  return result;
}

Plane compare(const study::Criterion& criterion, const Preparation& preparation, const Plane& left,
              const Plane& right) {
  const Plane r = prepare(left, preparation);
  const Plane s = prepare(right, preparation);
  study::Pair pair(r, s);
  return criterion.compare(pair);
}

/// Largest departure of `values` from `factor` times `from`, relative to the mean of the latter. Only where both are
/// finite, and where one is not, both must not be.
double departure(const Plane& values, const Plane& from, double factor, int margin) {
  double largest = 0;
  double sum = 0;
  double count = 0;
  for (int y = margin; y < values.height - margin; ++y)
    for (int x = margin; x < values.width - margin; ++x) {
      const double a = values.at(x, y);
      const double b = factor * from.at(x, y);
      if (std::isinf(a) && std::isinf(b)) continue;
      largest = std::max(largest, std::abs(a - b));
      sum += std::abs(b);
      ++count;
    }
  return largest / (sum / count);
}

struct Found {
  Effect effect;
  double change;      ///< departure from the criterion's value before
  double factor = 1;  ///< of the criterion's mean
};

bool squared(const study::Criterion& criterion) { return criterion.name().find("SSD") != std::string::npos; }

double mean(const Plane& values, int margin) {
  double sum = 0;
  double count = 0;
  for (int y = margin; y < values.height - margin; ++y)
    for (int x = margin; x < values.width - margin; ++x) {
      if (!std::isfinite(values.at(x, y))) continue;
      sum += values.at(x, y);
      ++count;
    }
  return sum / count;
}

Found judge(const study::Criterion& criterion, const Plane& before, const Plane& after, double scale, int margin) {
  const double change = departure(after, before, 1, margin);
  if (change <= kTolerance) return {Effect::yes, change};
  if (scale != 1 && departure(after, before, squared(criterion) ? scale * scale : scale, margin) <= kTolerance)
    return {Effect::scaled, change, mean(after, margin) / mean(before, margin)};
  return {Effect::no, change};
}

/// The camera of the footnotes: exposed so that no image is clipped, even one that is brighter by kLargestFootnote.
study::Conditions darker(study::Conditions conditions) {
  conditions.lighting.mean_grey /= kLargestFootnote;
  conditions.lighting.deviation_grey /= kLargestFootnote;
  return conditions;
}

/// Footnotes of the table: how far from 1 px the half is detected that a threshold of 1 px was chosen for, when the
/// right image is brighter by a factor.
double moved_px(const study::Simulation& simulation, const StudyScope& scope, const study::Setting& setting,
                double scale) {
  const std::vector<double> disparities = chapter8_disparities(scope);
  study::ImageSeries series = photographs(simulation, disparities);
  const double threshold = study::detect(series, {setting})[0].threshold(1);
  series.image = [&](std::size_t i) {
    return simulation.expose(changed(simulation.exact(disparities[i]), scale, 0), simulation.conditions().electronics,
                             i + 1);
  };
  const auto place = study::detect(series, {setting})[0].disparity_at(threshold, 0.5);
  return place ? std::abs(*place - 1) : 1;
}

constexpr std::array kLabels{"common offset", "common scaling", "different offset", "different scaling"};

/// Entries of the table, measured.
struct Entries {
  Csv csv{{"criterion", "preprocessing", "change", "thesis", "found", "relative_change", "relative_change_right"}};
  int cells = 0;
  int agreeing = 0;
  double worst_yes = 0;
  double least_no = 1e9;
};

/// One row of the table, measured.
struct RowFound {
  int different = 0;
  std::string differing;  ///< the first of them, in words
  double worst_yes = 0;
  double least_no = 1e9;
  std::string scaled;  ///< "SAD ×1.25": by how much each criterion scales
};

/// With every filter before that the row stands for.
std::vector<Preparation> preparations(const study::Criterion& criterion, const InvarianceRow& row) {
  std::vector<Preparation> result;
  for (const bool highpass : row.highpass)
    for (const bool lowpass : {false, true}) {
      if (criterion.feature() == Feature::log_sign) {
        result.push_back({Feature::log_sign, false, false, lowpass ? 3.0 : 5.0});
      } else {
        result.push_back({criterion.feature(), lowpass, highpass});
      }
    }
  return result;
}

void measure(const std::string& name, const Preparation& preparation, const InvarianceRow& row, const Plane& left,
             const Plane& right, RowFound& of_row, Entries& entries) {
  const study::Criterion& criterion = study::criterion(name);
  const int margin = study::reach_of({&criterion, preparation, 9}) + 1;
  const Plane before = compare(criterion, preparation, left, right);
  for (std::size_t i = 0; i < kLabels.size(); ++i) {
    const bool common = i < 2;
    const double scale = i % 2 == 1 ? kScale : 1;
    const double offset = i % 2 == 0 ? kOffset : 0;
    const Plane brighter_left = changed(left, scale, offset);
    const Plane brighter_right = changed(right, scale, offset);
    const auto judged = [&](const Plane& l, const Plane& r) {
      return judge(criterion, before, compare(criterion, preparation, l, r), scale, margin);
    };
    const Found found = judged(brighter_left, common ? brighter_right : right);
    const Found of_right = common ? found : judged(left, brighter_right);
    entries.csv.row(name, name_of(preparation), kLabels[i], name_of(row.effects[i]), name_of(found.effect),
                    found.change, of_right.change);
    ++entries.cells;
    // LSAD and LSSD scale with r alone (footnotes to Table 8.2): what is said of a difference holds for r.
    if (found.effect == row.effects[i]) {
      ++entries.agreeing;
    } else {
      ++of_row.different;
      if (of_row.differing.size() < 80)
        of_row.differing +=
            fmt::format("; {} {} {}: {}", name, name_of(preparation), kLabels[i], name_of(found.effect));
    }
    if (found.effect == Effect::scaled && row.effects[i] == Effect::scaled &&
        of_row.scaled.find(name + " ×") == std::string::npos)
      of_row.scaled += fmt::format("{}{} ×{:.5g}{}", of_row.scaled.empty() ? "" : ", ", name, found.factor,
                                   squared(criterion) ? " = k²" : " = k");
    if (row.effects[i] == Effect::yes) of_row.worst_yes = std::max({of_row.worst_yes, found.change, of_right.change});
    if (row.effects[i] == Effect::no) of_row.least_no = std::min({of_row.least_no, found.change, of_right.change});
  }
}

Statement statement(const InvarianceRow& row, const RowFound& found) {
  using namespace measured;
  const std::string who = fmt::format("{}", fmt::join(row.criteria, ", "));
  const char* images = who == "NISH"              ? "sign of LoG"
                       : who.starts_with("DSAD")  ? "directions"
                       : row.highpass.size() == 2 ? "with and without high-pass"
                       : row.highpass.front()     ? "high-pass"
                                                  : "no high-pass";
  std::string effects;
  for (std::size_t i = 0; i < kLabels.size(); ++i)
    effects += fmt::format("{}{} {}", i == 0 ? "" : ", ", kLabels[i], name_of(row.effects[i]));
  std::string more = found.least_no < 1e9 ? fmt::format(", of a no at least {:.1e}", found.least_no) : "";
  if (!found.scaled.empty()) {
    more += fmt::format("; with k = {} scaled: {}", kScale, found.scaled);
    if (found.scaled.find("k²") != std::string::npos)
      more += " (by 8.3.1's words, “by the same amount as the brightness”, squares are not scaled literally)";
  }
  more += found.differing;
  if (found.different > 0 && who.starts_with("LS"))
    more += " (where the means differ in sign the factor is 1, footnote 4: nothing scales)";
  return {
      fmt::format("Table 8.3, {} ({}): {}.", who, images, effects),
      {found.different, found.worst_yes, more},
      "Change, times the criterion's mean: of a yes at most {1:.1e}{2}",
      "yes (invariant): changed by at most 1e-4 times the criterion's mean; scaled: multiplied by k, sums of squares by "
      "k², to 1e-4; no: neither; each with every prefilter. Partly: up to two differ",
      {first <= 0 && second <= kTolerance, first <= 2},
      who == "NCC" && row.highpass.front() ? "NCC after a high-pass stays the same under all changes of brightness"
      : who.starts_with("DSAD")            ? "so do the criteria of directions"
      : who.starts_with("LSAD") && row.highpass.front()
          ? "after a high-pass LSAD and LSSD scale with the brightness of one image"
          : ""};
}

/// What a footnote of the table says to be tolerable.
struct Footnote {
  const char* criterion;
  bool highpass;
  double scale;
  int number;
};
constexpr std::array kFootnotes{Footnote{"MOR", false, 1.1, 1}, Footnote{"MOR", true, 1.2, 1},
                                Footnote{"SSD", true, 1.1, 2},  Footnote{"ZSSD", false, 1.1, 3},
                                Footnote{"ZSSD", true, 1.2, 3}, Footnote{"ZNSSD", false, 1.1, 4},
                                Footnote{"ZNSSD", true, 1.2, 4}};

void state_footnotes(StudyReport& report, const StudyScope& scope, const study::Simulation& simulation) {
  using namespace measured;
  StudyScope quick;
  quick.seed = scope.seed;
  quick.quick = true;
  Progress progress("footnote");
  std::size_t done = 0;
  for (const Footnote& note : kFootnotes) {
    progress.show(done++, kFootnotes.size());
    const auto moved = [&](bool lowpass) {
      return moved_px(simulation, quick,
                      {&study::criterion(note.criterion), {Feature::grey, lowpass, note.highpass}, 9}, note.scale);
    };
    report.state("8.3.1",
                 {{fmt::format("Table 8.3, footnote {}: for {} ({}) a different scaling of {:.0f} % is tolerable.",
                               note.number, note.criterion,
                               note.highpass ? "high-pass" : "no pre-processing or low-pass", 100 * (note.scale - 1)),
                   {moved(false), moved(true)},
                   "The disparity detected by half moves from 1 px by {:.2f} px, with a low-pass by {:.2f} px",
                   "By at most 0.1 px in both, a tenth of what is tolerated (the text has no number); partly: 0.25 px",
                   {first <= 0.1 && second <= 0.1, first <= 0.25 && second <= 0.25}}});
  }
}

}  // namespace

void study_invariance(StudyReport& report, const StudyScope& scope) {
  study::Conditions conditions = chapter8_conditions(scope);
  conditions.camera.width = 240;
  conditions.camera.height = 180;
  const study::Simulation simulation(conditions, 3);
  const Plane left = study::to_plane(simulation.photograph(0, 0));
  const Plane right = study::to_plane(simulation.photograph(0.5, 1));
  report.result["conditions"] = to_json(conditions);
  report.result["conditions"]["offset_grey"] = kOffset;
  report.result["conditions"]["scale"] = kScale;
  Entries entries;
  for (const InvarianceRow& row : table()) {
    RowFound found;
    for (const std::string& name : row.criteria)
      for (const Preparation& preparation : preparations(study::criterion(name), row))
        measure(name, preparation, row, left, right, found, entries);
    entries.worst_yes = std::max(entries.worst_yes, found.worst_yes);
    entries.least_no = std::min(entries.least_no, found.least_no);
    report.state("8.3.1", {statement(row, found)});
  }
  state_footnotes(report, scope, study::Simulation(darker(conditions), 3));
  report.table("table-8-3.csv", entries.csv);
  report.result["cells"] = entries.cells;
  report.result["cells_as_in_the_thesis"] = entries.agreeing;
  report.result["largest_change_of_invariant"] = entries.worst_yes;
  report.result["smallest_change_of_variant"] = entries.least_no;
  report.finding(
      "Table 8.3: {} of {} entries as in the thesis; a yes changes by {:.1e} at most, a no by {:.1e} at least",
      entries.agreeing, entries.cells, entries.worst_yes, entries.least_no);
}

}  // namespace horopter::cli
