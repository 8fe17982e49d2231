// SPDX-License-Identifier: Apache-2.0
// Line plots as SVG.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace horopter {

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

}  // namespace horopter
