// SPDX-License-Identifier: Apache-2.0
// Tables as CSV and line plots as SVG, for the studies.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace horopter::cli {

/// As text of an SVG.
std::string svg_text(const std::string& words);

struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points;
};

struct Panel {
  std::string title, x_label, y_label;
  std::vector<Curve> curves;
  bool log_y = false;
};

/// Panels side by side, `columns` in a row, with one legend: curves of one name have one colour.
std::string plot_svg(const std::string& title, const std::vector<Panel>& panels, int columns = 3);

/// Rows of a table; numbers are written so that they read back the same to 6 digits.
class Csv {
 public:
  explicit Csv(const std::vector<std::string>& header);
  Csv& operator<<(const std::string& field);
  Csv& operator<<(double field);
  void end_row();
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  bool first_ = true;
};

}  // namespace horopter::cli
