// SPDX-License-Identifier: Apache-2.0
// Targets to print: PDF and SVG in exact millimetres, with bars to check the print with a ruler.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "horopter/calib/target.hpp"

namespace horopter::calib {

struct Paper {
  std::string name;
  double width_mm = 0, height_mm = 0;  ///< upright
};
/// a0 … a5, letter, legal, tabloid, or WIDTHxHEIGHT in mm. Throws std::invalid_argument that lists them.
Paper paper_size(std::string_view name);

struct PatternOptions {
  TargetSpec spec;
  Paper paper;
  bool inverse = false;  ///< bright fiducials on black ground, as in the thesis
  /// A hole in the first fiducial, by which an image tells how the target is turned, and whether it is mirrored.
  bool hole = true;
};

/// A sheet as shapes, mm from its upper left corner, y down.
struct Pattern {
  struct Polygon {
    std::vector<Eigen::Vector2d> points_mm;
    bool black = true;
  };
  struct Disc {
    Eigen::Vector2d centre_mm;
    double radius_mm = 0;
    bool black = false;
  };
  struct Text {
    Eigen::Vector2d start_mm;  ///< of the base line
    double size_mm = 3;
    bool upright = false;  ///< runs from below to above
    std::string words;
  };
  std::string title;
  double width_mm = 0, height_mm = 0;  ///< of the sheet, turned so that the target fits
  std::vector<Polygon> polygons;       ///< in the order in which they are painted
  std::vector<Disc> discs;             ///< painted after the polygons
  std::vector<Text> texts;
  /// Where target coordinates (0, 0) are: position on the sheet = origin + coordinates.
  Eigen::Vector2d origin_mm{0, 0};
  double bar_x_mm = 0, bar_y_mm = 0;  ///< lengths of the bars
};

/// Throws std::invalid_argument when the target does not fit: says what it needs and on which paper it would.
Pattern make_pattern(const PatternOptions& options);

/// The sheet as a file: the same bytes for the same pattern, wherever the same fonts are installed. Throws
/// std::runtime_error when it cannot be drawn. SVG is in mm, with the words as outlines. PDF is version 1.4, one page
/// whose size is exact to 1e-6 pt, and asks the viewer not to scale.
std::string pattern_svg(const Pattern& pattern);
std::string pattern_pdf(const Pattern& pattern);

}  // namespace horopter::calib
