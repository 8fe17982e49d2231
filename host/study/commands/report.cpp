// SPDX-License-Identifier: Apache-2.0
#include "report.hpp"

namespace horopter::cli {

void StudyReport::picture(const std::string& file, const std::string& title, const std::vector<std::uint8_t>& png) {
  directory_.write(file, png);
  result["figures"].push_back({{"file", file}, {"title", title}});
}

void StudyReport::plot(const std::string& file, const std::string& title, const std::vector<Panel>& panels,
                       int columns) {
  directory_.write(file, plot_svg(title, panels, columns));
  result["figures"].push_back({{"file", file}, {"title", title}});
}

void StudyReport::state(const std::string& section, const std::vector<Statement>& statements) {
  for (const Statement& statement : statements) result["statements"].push_back(evaluate(section, statement));
}

}  // namespace horopter::cli
