// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/pattern.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "horopter/calib/render.hpp"

namespace horopter::calib {
namespace {

using Eigen::Vector2d;

struct Sheet {
  const char* name;
  double width_mm, height_mm;
};
constexpr std::array kSheets{
    Sheet{"a5", 148, 210},        Sheet{"a4", 210, 297},          Sheet{"letter", 215.9, 279.4},
    Sheet{"legal", 215.9, 355.6}, Sheet{"tabloid", 279.4, 431.8}, Sheet{"a3", 297, 420},
    Sheet{"a2", 420, 594},        Sheet{"a1", 594, 841},          Sheet{"a0", 841, 1189}};

/// The border of the paper that printers cannot print on.
constexpr double kBorder_mm = 5;
/// Beside the target: a bar, its figures, and some white between bar and target.
constexpr double kBarRoom_mm = 9;
constexpr double kTextRoom_mm = 5;
constexpr double kTextSize_mm = 2.6;

std::string text_of(double value, int digits = 5) {
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, digits);
  std::string text(buffer.data(), end.ptr);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

/// The target's outline in its own coordinates, with the ground that belongs to it.
struct Box {
  Vector2d low, high;
  Vector2d size() const { return high - low; }
};
Box outline(const TargetSpec& spec, bool inverse) {
  Box box;
  if (spec.kind == TargetKind::chessboard) {
    box.low = Vector2d(-spec.pitch_mm, -spec.pitch_mm);
    box.high = Vector2d(spec.columns * spec.pitch_mm, spec.rows * spec.pitch_mm);
    return box;
  }
  box.low = Vector2d(0, -(spec.rows - 1) * spec.pitch_mm - spec.box_mm());
  box.high = Vector2d((spec.columns - 1) * spec.pitch_mm + spec.box_mm(), 0);
  if (inverse) {
    const double gap = (spec.pitch_mm - spec.box_mm()) / 2;
    box.low.array() -= gap;
    box.high.array() += gap;
  }
  return box;
}

void add_rectangle(Pattern& pattern, double x, double y, double width, double height, bool black) {
  pattern.polygons.push_back({{{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, black});
}

/// A bar with a tick every 10 mm; its length is from the outside of the first tick to the outside of the last.
void add_bar(Pattern& pattern, const Vector2d& start, double length, bool upright) {
  const auto rectangle = [&](double along, double across, double along_size, double across_size) {
    if (upright)
      add_rectangle(pattern, start.x() + across, start.y() - along - along_size, across_size, along_size, true);
    else
      add_rectangle(pattern, start.x() + along, start.y() + across, along_size, across_size, true);
  };
  rectangle(0, 1.4, length, 0.2);
  for (int i = 0; i * 10 <= length + 1e-9; ++i) {
    // The first tick begins at 0, the last ends at the length: outside to outside is exact.
    const bool last = (i + 1) * 10 > length + 1e-9;
    const double at = i == 0 ? 0 : last ? length - 0.2 : i * 10 - 0.1;
    rectangle(at, i == 0 || last ? 0 : 0.8, 0.2, i == 0 || last ? 3 : 1.4);
  }
}

/// Room that the sheet has beside and below the target, in all.
const Vector2d kRoom_mm(2 * kBorder_mm + kBarRoom_mm, 2 * kBorder_mm + kBarRoom_mm + kTextRoom_mm);

[[noreturn]] void does_not_fit(const PatternOptions& options, const Vector2d& needed) {
  std::string message = options.spec.text() + " needs " + text_of(needed.x(), 1) + " x " + text_of(needed.y(), 1) +
                        " mm with its bars and borders; " + options.paper.name + " has " +
                        text_of(options.paper.width_mm, 1) + " x " + text_of(options.paper.height_mm, 1) + " mm";
  const auto larger = std::ranges::find_if(kSheets, [&](const Sheet& sheet) {
    return (needed.x() <= sheet.width_mm && needed.y() <= sheet.height_mm) ||
           (needed.x() <= sheet.height_mm && needed.y() <= sheet.width_mm);
  });
  if (larger != kSheets.end()) message += "; it fits on " + std::string(larger->name);
  throw std::invalid_argument(message);
}

/// A sheet of the paper, turned so that the target fits.
Pattern empty_sheet(const PatternOptions& options, const Box& box) {
  const Vector2d needed = box.size() + kRoom_mm;
  const auto fits = [&](double width, double height) { return needed.x() <= width && needed.y() <= height; };
  Pattern pattern;
  pattern.width_mm = options.paper.width_mm;
  pattern.height_mm = options.paper.height_mm;
  if (!fits(pattern.width_mm, pattern.height_mm)) std::swap(pattern.width_mm, pattern.height_mm);
  if (!fits(pattern.width_mm, pattern.height_mm)) does_not_fit(options, needed);
  pattern.title = options.spec.text() + (options.inverse ? " (inverse)" : "");
  return pattern;
}

void add_chessboard(Pattern& pattern, const PatternOptions& options, const Vector2d& corner) {
  const double side = options.spec.side_mm;
  for (int y = 0; y <= options.spec.rows; ++y)
    for (int x = 0; x <= options.spec.columns; ++x)
      if ((x + y) % 2 == (options.inverse ? 1 : 0))
        add_rectangle(pattern, corner.x() + x * side, corner.y() + y * side, side, side, true);
}

void add_fiducials(Pattern& pattern, const PatternOptions& options, const Vector2d& corner, const Vector2d& size) {
  const TargetSpec& spec = options.spec;
  if (options.inverse) add_rectangle(pattern, corner.x(), corner.y(), size.x(), size.y(), true);
  const std::vector<Vector2d> points = spec.points_mm();
  for (std::size_t i = 0; i < points.size(); i += 4) {
    Pattern::Polygon fiducial;
    fiducial.black = !options.inverse;
    for (std::size_t k = 0; k < 4; ++k) fiducial.points_mm.push_back(pattern.origin_mm + points[i + k]);
    pattern.polygons.push_back(std::move(fiducial));
  }
  if (!options.hole) return;
  const Vector2d middle = pattern.origin_mm + Vector2d(spec.box_mm() / 2, -spec.box_mm() / 2);
  pattern.discs.push_back({middle, kHoleOverSide * spec.side_mm / 2, options.inverse});
}

/// The longest bar for the room, in whole steps that a ruler shows.
double bar_length(double available_mm) {
  double length = 10;
  for (const double l : {20.0, 50.0, 100.0, 150.0, 200.0, 250.0, 300.0, 500.0})
    if (l <= available_mm) length = l;
  return length;
}

/// Bars below the target and at its left, and what they say.
void add_bars(Pattern& pattern, const Vector2d& corner, const Vector2d& size) {
  const double bottom = corner.y() + size.y();
  const double below = bottom + 4;
  const double beside = corner.x() - kBarRoom_mm + 2;
  pattern.bar_x_mm = bar_length(pattern.width_mm - corner.x() - kBorder_mm);
  pattern.bar_y_mm = bar_length(bottom - kBorder_mm);
  add_bar(pattern, {corner.x(), below}, pattern.bar_x_mm, false);
  add_bar(pattern, {beside, bottom}, pattern.bar_y_mm, true);
  const std::string words = text_of(pattern.bar_x_mm) + " mm. " + pattern.title +
                            ". Print at actual size (100 %) and check both bars with a ruler.";
  pattern.texts.push_back({{corner.x() + 1, below + 5.5}, kTextSize_mm, false, words});
  pattern.texts.push_back({{beside - 0.7, bottom - 1}, kTextSize_mm, true, text_of(pattern.bar_y_mm) + " mm"});
}

}  // namespace

Paper paper_size(std::string_view name) {
  std::string known;
  for (const Sheet& sheet : kSheets) {
    if (sheet.name == name) return {sheet.name, sheet.width_mm, sheet.height_mm};
    known += std::string(known.empty() ? "" : ", ") + sheet.name;
  }
  const std::size_t times = name.find('x');
  if (times != std::string_view::npos) {
    std::string_view height = name.substr(times + 1);
    if (height.size() > 2 && height.substr(height.size() - 2) == "mm") height.remove_suffix(2);
    double w = 0;
    double h = 0;
    const std::string_view width = name.substr(0, times);
    const auto one = std::from_chars(width.data(), width.data() + width.size(), w);
    const auto two = std::from_chars(height.data(), height.data() + height.size(), h);
    // The pages of PDF 1.4 end at 14400 points.
    if (one.ec == std::errc() && two.ec == std::errc() && one.ptr == width.data() + width.size() &&
        two.ptr == height.data() + height.size() && w >= 20 && h >= 20 && w <= 5000 && h <= 5000)
      return {std::string(name), w, h};
  }
  throw std::invalid_argument("paper '" + std::string(name) + "' is not one of " + known +
                              ", or WIDTHxHEIGHT in mm (20 to 5000)");
}

Pattern make_pattern(const PatternOptions& options) {
  const Box box = outline(options.spec, options.inverse);
  Pattern pattern = empty_sheet(options, box);
  // The target in the middle of what the bars leave: one at its left, one and the text below.
  const Vector2d room = Vector2d(pattern.width_mm, pattern.height_mm) - kRoom_mm;
  const Vector2d corner = Vector2d(kBorder_mm + kBarRoom_mm, kBorder_mm) + (room - box.size()) / 2;
  pattern.origin_mm = corner - box.low;
  if (options.spec.kind == TargetKind::chessboard) {
    add_chessboard(pattern, options, corner);
  } else {
    add_fiducials(pattern, options, corner, box.size());
  }
  add_bars(pattern, corner, box.size());
  return pattern;
}

}  // namespace horopter::calib
