// SPDX-License-Identifier: Apache-2.0
#include "statements.hpp"

#include <fmt/format.h>

#include <map>

namespace horopter::cli {
namespace {

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::confirmed:
      return "confirmed";
    case Verdict::partly:
      return "partly";
    default:
      return "not confirmed";
  }
}

/// A cell of a table in Markdown.
std::string cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, 1, '\\');
  return text;
}

}  // namespace

void Statements::add(const std::string& section, const std::string& statement, const std::string& figure,
                     Verdict verdict, const std::string& rule) {
  rows_.push_back({{"section", section},
                   {"statement", statement},
                   {"figure", figure},
                   {"verdict", name_of(verdict)},
                   {"rule", rule}});
}

std::string study_markdown(const nlohmann::ordered_json& results) {
  std::map<std::string, int> counts;
  std::string table;
  std::string conditions;
  int number = 0;
  bool quick = false;
  for (const auto& [study, result] : results.items()) {
    quick = quick || result.value("quick", false);
    if (result.contains("conditions"))
      conditions += fmt::format("- **{}**: `{}`\n", study, result["conditions"].dump());
    if (!result.contains("statements")) continue;
    for (const auto& row : result["statements"]) {
      const auto text = [&](const char* key) { return cell(row.at(key).get<std::string>()); };
      ++counts[text("verdict")];
      table += fmt::format("| {} | {} | {} | {} | **{}** | {} | {} |\n", ++number, text("section"), text("statement"),
                           text("figure"), text("verdict"), text("rule"), study);
    }
  }
  return fmt::format(
             "# What of the thesis holds\n\nWritten by `horopter study all{}`: do not edit. A verdict follows from the "
             "figures by the rule beside it, the same for every run; nothing was tuned for a statement. {} statements: "
             "{} confirmed, {} partly, {} not confirmed.\n\n"
             "| # | § | The thesis says | We found | Verdict | Rule and reason | Study "
             "|\n|---|---|---|---|---|---|---|\n",
             quick ? " --quick" : "", number, counts["confirmed"], counts["partly"], counts["not confirmed"]) +
         table + "\n## Conditions\n\nEvery study's conditions, beside which its figures hold:\n\n" + conditions;
}

}  // namespace horopter::cli
