// SPDX-License-Identifier: Apache-2.0
// Where a study puts what it found: tables and pictures into its directory, everything else into its result.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "horopter/base/csv.hpp"
#include "horopter/draw/plot.hpp"
#include "horopter/image/output.hpp"
#include "statements.hpp"

namespace horopter::cli {

class StudyReport {
 public:
  /// Keep the directory. It gets nothing before its commit().
  explicit StudyReport(OutputDirectory& directory) : directory_(directory) {}

  /// Figures for programs. "conditions" stand on the page and in STUDY.md, too; the keys that the functions below fill
  /// are "findings", "figures" ([{"file", "title"}], the pictures of the page), "fitted" and "statements" (evaluate()).
  nlohmann::json result{{"findings", nlohmann::json::array()}, {"figures", nlohmann::json::array()}};

  void table(const std::string& file, const Csv& csv) { directory_.write(file, csv.text()); }
  /// A file that is no picture of the page: text or bytes.
  template <class Content>
  void file(const std::string& file, const Content& content) {
    directory_.write(file, content);
  }
  void picture(const std::string& file, const std::string& title, const std::vector<std::uint8_t>& png);
  /// Panels, `columns` in a row.
  void plot(const std::string& file, const std::string& title, const std::vector<Panel>& panels, int columns);

  /// A line for the terminal and the page.
  template <class... Values>
  void finding(fmt::format_string<Values...> text, Values&&... values) {
    result["findings"].push_back(fmt::format(text, std::forward<Values>(values)...));
  }
  /// A condition that was chosen by a figure of the thesis: a line of the page.
  void fitted(const std::string& line) { result["fitted"].push_back(line); }
  /// Of a section of the thesis.
  void state(const std::string& section, const std::vector<Statement>& statements);

 private:
  OutputDirectory& directory_;
};

}  // namespace horopter::cli
