// SPDX-License-Identifier: Apache-2.0
// STUDY.md: all statements in groups, and a summary of one screen before them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace horopter::cli {

/// What was found of the statements of some sections of the thesis.
struct StatementGroup {
  std::string name;
  std::vector<std::string> sections;  ///< "8.4.2": this section and those below it
  int confirmed = 0, partly = 0, not_confirmed = 0;
  std::vector<nlohmann::json> rows = {};  ///< of evaluate(), with "study", its name; by section
  int all() const { return confirmed + partly + not_confirmed; }
};

/// Every statement in the results of studies, {name: result}, in its group. Throws std::logic_error for a section of no
/// group.
std::vector<StatementGroup> statement_groups(const nlohmann::ordered_json& results);

/// The page. A result's "fitted" are lines that say what of its conditions was chosen by the thesis's figures.
std::string study_markdown(const nlohmann::ordered_json& results);

}  // namespace horopter::cli
