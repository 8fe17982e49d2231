// SPDX-License-Identifier: Apache-2.0
// What the thesis says, beside what a study found: rows of STUDY.md. Verdicts come from figures by a stated rule.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace horopter::cli {

enum class Verdict { confirmed, partly, not_confirmed };

/// Confirmed when `whole` holds, else partly when `part` does.
constexpr Verdict verdict(bool whole, bool part = false) {
  if (whole) return Verdict::confirmed;
  return part ? Verdict::partly : Verdict::not_confirmed;
}

/// A study puts statements into its result's "statements"; `study all` collects them.
class Statements {
 public:
  /// `section` of the thesis, what it says, our figure in words and numbers, the rule of the verdict ("confirmed when
  /// …"). A word why, where it is not confirmed, belongs to the figure.
  void add(const std::string& section, const std::string& statement, const std::string& figure, Verdict verdict,
           const std::string& rule);
  const nlohmann::json& json() const { return rows_; }

 private:
  nlohmann::json rows_ = nlohmann::json::array();
};

/// STUDY.md from the results of studies, {name: result}: a table of all statements, and each study's conditions.
std::string study_markdown(const nlohmann::ordered_json& results);

}  // namespace horopter::cli
