// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "horopter/calib/target.hpp"

namespace horopter::calib {
namespace {

constexpr const char* kTargetForm =
    "expected squares:COLUMNSxROWS:SIDEmm:PITCHmm, diamonds:COLUMNSxROWS:SIDEmm:PITCHmm or "
    "chessboard:COLUMNSxROWS:SQUAREmm (chessboard: inner corners)";

[[noreturn]] void bad(std::string_view text, const std::string& what) {
  throw std::invalid_argument("target '" + std::string(text) + "': " + what + "; " + kTargetForm);
}

std::string shortest(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

}  // namespace

TargetSpec TargetSpec::parse(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t start = 0;;) {
    const std::size_t colon = text.find(':', start);
    parts.push_back(text.substr(start, colon == std::string_view::npos ? colon : colon - start));
    if (colon == std::string_view::npos) break;
    start = colon + 1;
  }
  TargetSpec spec;
  if (parts[0] == "squares")
    spec.kind = TargetKind::squares;
  else if (parts[0] == "diamonds")
    spec.kind = TargetKind::diamonds;
  else if (parts[0] == "chessboard")
    spec.kind = TargetKind::chessboard;
  else
    bad(text, "'" + std::string(parts[0]) + "' is no kind of target");
  const std::size_t fields = spec.kind == TargetKind::chessboard ? 3 : 4;
  if (parts.size() != fields)
    bad(text, std::to_string(parts.size()) + " fields where " + std::to_string(fields) + " belong");

  const auto count = [&](std::string_view digits) {
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size())
      bad(text, "'" + std::string(digits) + "' is no number of columns or rows");
    if (value < 2 || value > 200) bad(text, std::to_string(value) + " columns or rows are not within 2 to 200");
    return value;
  };
  const std::size_t times = parts[1].find('x');
  if (times == std::string_view::npos) bad(text, "'" + std::string(parts[1]) + "' is no size");
  spec.columns = count(parts[1].substr(0, times));
  spec.rows = count(parts[1].substr(times + 1));

  const auto length = [&](std::string_view field) {
    std::string_view digits = field;
    if (digits.size() > 2 && digits.substr(digits.size() - 2) == "mm") digits.remove_suffix(2);
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size())
      bad(text, "'" + std::string(field) + "' is no length in mm");
    if (!(value > 0.01 && value < 1e5)) bad(text, "'" + std::string(field) + "' is not within 0.01 mm to 100 m");
    return value;
  };
  spec.side_mm = length(parts[2]);
  spec.pitch_mm = spec.kind == TargetKind::chessboard ? spec.side_mm : length(parts[3]);
  if (spec.kind != TargetKind::chessboard && spec.pitch_mm <= spec.box_mm() * 1.02)
    bad(text, "fiducials " + shortest(spec.box_mm()) + " mm wide touch each other at a pitch of " +
                  shortest(spec.pitch_mm) + " mm");
  return spec;
}

std::string TargetSpec::text() const {
  const std::string size = std::to_string(columns) + "x" + std::to_string(rows) + ":" + shortest(side_mm) + "mm";
  if (kind == TargetKind::chessboard) return "chessboard:" + size;
  return (kind == TargetKind::squares ? "squares:" : "diamonds:") + size + ":" + shortest(pitch_mm) + "mm";
}

double TargetSpec::box_mm() const { return kind == TargetKind::diamonds ? side_mm * std::numbers::sqrt2 : side_mm; }

std::vector<Eigen::Vector2d> TargetSpec::points_mm() const {
  std::vector<Eigen::Vector2d> points;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      if (kind == TargetKind::chessboard) {
        points.emplace_back(column * pitch_mm, row * pitch_mm);
        continue;
      }
      const double box = box_mm();
      const double x = column * pitch_mm;
      const double y = -row * pitch_mm;
      if (kind == TargetKind::squares) {
        points.emplace_back(x, y - box);
        points.emplace_back(x + box, y - box);
        points.emplace_back(x + box, y);
        points.emplace_back(x, y);
      } else {
        points.emplace_back(x + box / 2, y - box);
        points.emplace_back(x + box, y - box / 2);
        points.emplace_back(x + box / 2, y);
        points.emplace_back(x, y - box / 2);
      }
    }
  return points;
}

}  // namespace horopter::calib
