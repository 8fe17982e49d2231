// SPDX-License-Identifier: Apache-2.0
#include "statements.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

#include <map>

namespace horopter::cli {
namespace {

/// A cell of a table in Markdown.
std::string cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, 1, '\\');
  return text;
}

/// STUDY.md up to the rows of its table.
constexpr const char* kIntroduction = R"(# What of the thesis holds

Written by `horopter study all{}`: do not edit. The thesis is *Real Time Inverse Stereo System for Surveillance of Dynamic Safety
Envelopes*. Each verdict is computed from the figures by the rule beside it, the same for every run. Nothing was tuned for a statement,
but for one: the blur of the simulated lens was chosen by the row of 1.0 px of Table 11.2.
{} statements, {} of them not the thesis's but ours: {} confirmed, {} partly, {} not confirmed.

| word | meaning |
| --- | --- |
| criterion | a measure of how alike two windows of an image are (Tables 8.1 and 8.2) |
| NCC, MOR, SAD, SSD, NISH | normalised cross correlation, Moravec's, sum of absolute and of squared differences, Nishihara's binary one |
| Z…, L…, N… before them | of zero mean, locally scaled, normalised: ZNCC is NCC of zero mean, ZNSSD is SSD of zero mean and normalised |
| DSAD, DSSD | sum of absolute, or squared, differences of the directions of the gradient. DSAD is the thesis's criterion. |
| LP, HP, LP+HP | a low-pass filter, a high-pass filter, or both, before the criterion |
| disparity | the displacement between both images, px |
| detection rate | share of the pixels with a disparity that the threshold takes for undisplaced |
| D50, D95 | the disparity at which 50 % or 95 % are detected |
| segmentation error | eq. 8.9: how many pixels the threshold puts on the wrong side, as a width in px |
| 10/90 disparity | from 90 % detected to 10 % detected, px |
| T_max | the largest possible value of a sum |

| # | § | The thesis says | We found | Verdict | Rule and reason | Study |
|---|---|---|---|---|---|---|
)";

}  // namespace

nlohmann::json evaluate(const std::string& section, const Statement& statement) {
  fmt::dynamic_format_arg_store<fmt::format_context> arguments;
  for (const Measured& one : statement.measured) {
    if (one.is_number) {
      arguments.push_back(one.number);
    } else {
      arguments.push_back(one.words);
    }
  }
  return {{"section", section},
          {"statement", statement.quote},
          {"figure", fmt::vformat(statement.figure, arguments)},
          {"verdict", statement.limits.confirmed.holds(statement.measured) ? "confirmed"
                      : statement.limits.partly.holds(statement.measured)  ? "partly"
                                                                           : "not confirmed"},
          {"rule", statement.rule}};
}

std::string study_markdown(const nlohmann::ordered_json& results) {
  std::map<std::string, int> counts;
  std::string table;
  std::string conditions;
  int number = 0;
  int ours = 0;
  bool quick = false;
  for (const auto& [study, result] : results.items()) {
    quick = quick || result.value("quick", false);
    if (result.contains("conditions"))
      conditions += fmt::format("- **{}**: `{}`\n", study, result["conditions"].dump());
    if (!result.contains("statements")) continue;
    for (const auto& row : result["statements"]) {
      const auto text = [&](const char* key) { return cell(row.at(key).get<std::string>()); };
      ++counts[text("verdict")];
      if (text("statement").starts_with("Ours,")) ++ours;
      table += fmt::format("| {} | {} | {} | {} | **{}** | {} | {} |\n", ++number, text("section"), text("statement"),
                           text("figure"), text("verdict"), text("rule"), study);
    }
  }
  return fmt::format(kIntroduction, quick ? " --quick" : "", number, ours, counts["confirmed"], counts["partly"],
                     counts["not confirmed"]) +
         table + "\n## Conditions\n\nEvery study's conditions, beside which its figures hold:\n\n" + conditions;
}

}  // namespace horopter::cli
