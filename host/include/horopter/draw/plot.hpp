// SPDX-License-Identifier: Apache-2.0
// Line plots as SVG.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace horopter {

/// About `count` round values between two, ends included.
std::vector<double> ticks(double low, double high, int count);

struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points;
};

struct Panel {
  std::string title, x_label, y_label;
  std::vector<Curve> curves;
  bool log_y = false;
};

/// Panels with their axes, `columns` in a row, below a title and above one legend: curves of one name have one colour.
/// Labels name the quantity and its unit ("error, px").
std::string plot_svg(const std::string& title, const std::vector<Panel>& panels, int columns = 3);

}  // namespace horopter
