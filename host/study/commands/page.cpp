// SPDX-License-Identifier: Apache-2.0
#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace horopter::cli {
namespace {

std::vector<StatementGroup> empty_groups() {
  return {{"Edges and calibration", {"6"}},
          {"Transformation", {"7"}},
          {"Brightness, noise, scale, blur", {"8.3"}},
          {"Criteria", {"8.1", "8.4.2", "8.4.4"}},
          {"Filters before and after", {"8.4.3", "8.4.5"}},
          {"Small objects", {"5.2", "8.5"}},
          {"Operations", {"8.6", "10.1"}},
          {"Texture", {"9"}},
          {"Bits of the direction", {"10.4"}},
          {"Thickness and slope of the skin", {"11"}}};
}

/// "8.4.2, Table 8.5" is of 8.4 and of 8, not of 8.4.21.
bool belongs(const std::string& section, const std::string& to) {
  return section.starts_with(to) &&
         (section.size() == to.size() || std::string_view(".,").find(section[to.size()]) != std::string_view::npos);
}

/// A cell of a table in Markdown.
std::string cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, 1, '\\');
  return text;
}

constexpr const char* kIntroduction = R"(# What of the thesis holds

Written by `horopter study all{}`: do not edit. The thesis is *Real Time Inverse Stereo System for Surveillance of Dynamic Safety
Envelopes*. Each statement is *confirmed*, *partly* confirmed or *not confirmed*: a verdict that is computed from the figures by the rule
beside it, the same for every run. A rule says when a statement is confirmed and, after *partly:*, when it is so in part.
Where the text has a number, the rule takes it; where it has words alone (slightly, much, almost), the number in the rule is ours.
If a statement is about several methods, windows or entries of a table, it is as a rule partly confirmed when it holds for half of them.
{} statements: {} confirmed, {} partly, {} not confirmed.
{}The last column is a selection: some statements in a few words, under their verdicts. All of them are in the tables below.

)";

/// Of the statements that are ours.
constexpr const char* kOurs =
    "{} of them ({}) begin with *Ours*: the thesis does not say them. They count all the same, because figures\nof "
    "the thesis rest on them: a row of Table 8.5 that the text does not define, directions of 8 bits.\n";

constexpr const char* kGlossary = R"(
| word | meaning |
| --- | --- |
| § | a section of the thesis |
| fiducial | a square or diamond of the calibration target |
| NCE | normalised calibration error: the error of a calibration divided by the one that the size of a pixel alone would make (6.35); small is good |
| jitter | lines of an image that begin too early or too late, each by another amount (6.7.2) |
| Zernike, Tabatabai, Gaussian reconstruction | ways to find an edge to a part of a pixel (6.6), in a window of 13×13 pixels for instance |
| criterion | a measure of how alike two windows of an image are (Tables 8.1 and 8.2) |
| CCF, NCC, MOR, SAD, SSD | cross correlation, the same normalised, Moravec's, sum of absolute and of squared differences |
| NISH, NISD, NACK | binary ones: Nishihara's (sign of the Laplacian of Gaussian), the same with a difference of Gaussians, Nack's |
| Z…, L…, N… before them | of zero mean, locally scaled, normalised: ZNCC is NCC of zero mean, ZNSSD is SSD of zero mean and normalised |
| DSAD, DSSD | sum of absolute, or squared, differences of the directions of the gradient. DSAD is the thesis's criterion. |
| LP, HP, LP+HP | a low-pass filter, a high-pass filter, or both, before the criterion |
| dead leaves | a simulated texture: discs of random grey and of random sizes that lie on each other like fallen leaves |
| slope of the light | how much brighter one side of an image is lit than the other |
| majority | each pixel of a binary image becomes what most pixels of the window around it are (5.4) |
| clusterlet | a spot of few pixels: where all pixels on the border of a window have one value, those inside get it (5.3) |
| opening, closing | the smallest value of each window, then the largest: removes small spots; the other way round: fills small holes |
| disparity | the displacement between both images, px |
| detection rate | share of the pixels with a disparity that the threshold takes for undisplaced |
| D50, D95 | the disparity at which 50 % or 95 % are detected |
| segmentation error | eq. 8.9: how many pixels the threshold puts on the wrong side, as a width in px; below 0.2 good, above 0.3 bad |
| 10/90 disparity | from 90 % detected to 10 % detected, px |
| T_max | the largest possible value of a sum |
)";

constexpr const char* kTableHead = R"(
| # | § | The thesis says | We found | Verdict | Rule and reason | Study |
|---|---|---|---|---|---|---|
)";

std::string headlines(const StatementGroup& group, const char* verdict, const char* word) {
  std::string text;
  for (const auto& row : group.rows) {
    const auto headline = row.at("headline").get<std::string>();
    if (headline.empty() || row.at("verdict") != verdict) continue;
    text += (text.empty() ? std::string(word) + ": " : "; ") + headline;
  }
  return text.empty() ? text : text + ". ";
}

std::string summary_line(const StatementGroup& group) {
  std::string said = headlines(group, "confirmed", "Confirmed") + headlines(group, "partly", "Partly") +
                     headlines(group, "not confirmed", "**Not confirmed**");
  if (!said.empty()) said.pop_back();
  return fmt::format("| {} ({}) | {} | {} | {} | {} |\n", group.name, fmt::join(group.sections, ", "), group.confirmed,
                     group.partly, group.not_confirmed, cell(said));
}

}  // namespace

std::vector<StatementGroup> statement_groups(const nlohmann::ordered_json& results) {
  std::vector<StatementGroup> groups = empty_groups();
  for (const auto& [study, result] : results.items()) {
    if (!result.contains("statements")) continue;
    for (nlohmann::json row : result["statements"]) {
      const auto section = row.at("section").get<std::string>();
      const auto group = std::ranges::find_if(groups, [&](const StatementGroup& one) {
        return std::ranges::any_of(one.sections, [&](const std::string& of) { return belongs(section, of); });
      });
      if (group == groups.end()) throw std::logic_error("statements: section " + section + " is of no group");
      const auto verdict = row.at("verdict").get<std::string>();
      ++(verdict == "confirmed" ? group->confirmed : verdict == "partly" ? group->partly : group->not_confirmed);
      row["study"] = study;
      const auto of = [](const nlohmann::json& one) { return one.at("section").get<std::string>(); };
      group->rows.insert(std::ranges::upper_bound(group->rows, section, {}, of), std::move(row));
    }
  }
  return groups;
}

std::string study_markdown(const nlohmann::ordered_json& results) {
  std::string conditions;
  std::string fitted;
  bool quick = false;
  for (const auto& [study, result] : results.items()) {
    quick = quick || result.value("quick", false);
    if (result.contains("conditions"))
      conditions += fmt::format("- **{}**: `{}`\n", study, result["conditions"].dump());
    for (const auto& line : result.value("fitted", nlohmann::json::array()))
      fitted += fmt::format("- **{}**: {}\n", study, line.get<std::string>());
  }
  StatementGroup total;
  std::string summary =
      "| what (§) | confirmed | partly | not confirmed | for instance |\n| --- | --- | --- | --- | --- |\n";
  std::string tables;
  std::vector<int> ours;
  int number = 0;
  for (const StatementGroup& group : statement_groups(results)) {
    if (group.all() == 0) continue;
    total.confirmed += group.confirmed;
    total.partly += group.partly;
    total.not_confirmed += group.not_confirmed;
    summary += summary_line(group);
    tables += fmt::format("\n## {}\n{}", group.name, kTableHead);
    for (const auto& row : group.rows) {
      const auto text = [&](const char* key) { return cell(row.at(key).get<std::string>()); };
      ++number;
      if (row.at("statement").get<std::string>().starts_with("Ours,")) ours.push_back(number);
      tables += fmt::format("| {} | {} | {} | {} | **{}** | {} | {} |\n", number, text("section"), text("statement"),
                            text("figure"), text("verdict"), text("rule"), text("study"));
    }
  }
  const std::string of_ours = ours.empty() ? "" : fmt::format(kOurs, ours.size(), fmt::join(ours, " and "));
  return fmt::format(kIntroduction, quick ? " --quick" : "", total.all(), total.confirmed, total.partly,
                     total.not_confirmed, of_ours) +
         summary +
         "\nConditions that the thesis does not give: what was fitted to which of its figures, and what was "
         "chosen:\n\n" +
         fitted + kGlossary + tables +
         "\n## Conditions\n\nEvery study's conditions, beside which its figures hold:\n\n" + conditions;
}

}  // namespace horopter::cli
