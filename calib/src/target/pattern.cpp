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
constexpr std::array sheets{Sheet{"a5", 148, 210},        Sheet{"a4", 210, 297},          Sheet{"letter", 215.9, 279.4},
                            Sheet{"legal", 215.9, 355.6}, Sheet{"tabloid", 279.4, 431.8}, Sheet{"a3", 297, 420},
                            Sheet{"a2", 420, 594},        Sheet{"a1", 594, 841},          Sheet{"a0", 841, 1189}};

/// What printers cannot reach.
constexpr double border_mm = 5;
/// Beside the target: a bar, its figures, and white to set the target off.
constexpr double bar_room_mm = 9;
constexpr double text_room_mm = 5;

std::string number(double value, int digits = 5) {
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

std::string escaped(const std::string& words) {
  std::string result;
  for (const char c : words) result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return result;
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

}  // namespace

Paper paper_size(std::string_view name) {
  std::string known;
  for (const Sheet& sheet : sheets) {
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
    // PDF 1.4 pages end at 14400 points.
    if (one.ec == std::errc() && two.ec == std::errc() && one.ptr == width.data() + width.size() &&
        two.ptr == height.data() + height.size() && w >= 20 && h >= 20 && w <= 5000 && h <= 5000)
      return {std::string(name), w, h};
  }
  throw std::invalid_argument("paper '" + std::string(name) + "' is not one of " + known +
                              ", or WIDTHxHEIGHT in mm (20 to 5000)");
}

Pattern make_pattern(const PatternOptions& options) {
  const TargetSpec& spec = options.spec;
  const Box box = outline(spec, options.inverse);
  const Vector2d needed =
      box.size() + Vector2d(2 * border_mm + bar_room_mm, 2 * border_mm + bar_room_mm + text_room_mm);
  const auto fits = [&](double width, double height) { return needed.x() <= width && needed.y() <= height; };
  Pattern pattern;
  pattern.width_mm = options.paper.width_mm;
  pattern.height_mm = options.paper.height_mm;
  if (!fits(pattern.width_mm, pattern.height_mm)) std::swap(pattern.width_mm, pattern.height_mm);
  if (!fits(pattern.width_mm, pattern.height_mm)) {
    std::string message = spec.text() + " needs " + number(needed.x(), 1) + " x " + number(needed.y(), 1) +
                          " mm with its bars and borders; " + options.paper.name + " has " +
                          number(options.paper.width_mm, 1) + " x " + number(options.paper.height_mm, 1) + " mm";
    for (const Sheet& sheet : sheets)
      if (fits(sheet.width_mm, sheet.height_mm) || fits(sheet.height_mm, sheet.width_mm)) {
        message += "; it fits on " + std::string(sheet.name);
        break;
      }
    throw std::invalid_argument(message);
  }
  pattern.title = spec.text() + (options.inverse ? " (inverse)" : "");

  // The target in the middle of what the bars leave: one at its left, one and the text below.
  const Vector2d room(pattern.width_mm - 2 * border_mm - bar_room_mm,
                      pattern.height_mm - 2 * border_mm - bar_room_mm - text_room_mm);
  const Vector2d corner = Vector2d(border_mm + bar_room_mm, border_mm) + (room - box.size()) / 2;
  pattern.origin_mm = corner - box.low;

  if (spec.kind == TargetKind::chessboard) {
    const double side = spec.side_mm;
    for (int y = 0; y <= spec.rows; ++y)
      for (int x = 0; x <= spec.columns; ++x)
        if ((x + y) % 2 == (options.inverse ? 1 : 0))
          add_rectangle(pattern, corner.x() + x * side, corner.y() + y * side, side, side, true);
  } else {
    if (options.inverse) add_rectangle(pattern, corner.x(), corner.y(), box.size().x(), box.size().y(), true);
    const std::vector<Vector2d> points = spec.points_mm();
    for (std::size_t i = 0; i < points.size(); i += 4) {
      Pattern::Polygon fiducial;
      fiducial.black = !options.inverse;
      for (std::size_t k = 0; k < 4; ++k) fiducial.points_mm.push_back(pattern.origin_mm + points[i + k]);
      pattern.polygons.push_back(std::move(fiducial));
    }
    if (options.hole)
      pattern.discs.push_back({pattern.origin_mm + Vector2d(spec.box_mm() / 2, -spec.box_mm() / 2),
                               hole_over_side * spec.side_mm / 2, options.inverse});
  }

  // Bars as long as there is room, in whole steps that a ruler shows.
  const auto bar_length = [](double available) {
    double length = 10;
    for (const double l : {20.0, 50.0, 100.0, 150.0, 200.0, 250.0, 300.0, 500.0})
      if (l <= available) length = l;
    return length;
  };
  const double below = corner.y() + box.size().y() + 4;
  pattern.bar_x_mm = bar_length(pattern.width_mm - corner.x() - border_mm);
  pattern.bar_y_mm = bar_length(corner.y() + box.size().y() - border_mm);
  add_bar(pattern, {corner.x(), below}, pattern.bar_x_mm, false);
  const double beside = corner.x() - bar_room_mm + 2;
  add_bar(pattern, {beside, corner.y() + box.size().y()}, pattern.bar_y_mm, true);
  pattern.texts.push_back({{corner.x() + 1, below + 5.5},
                           2.6,
                           false,
                           number(pattern.bar_x_mm) + " mm. " + pattern.title +
                               ". Print at actual size (100 %) and check both bars with a ruler."});
  pattern.texts.push_back(
      {{beside - 0.7, corner.y() + box.size().y() - 1}, 2.6, true, number(pattern.bar_y_mm) + " mm"});
  return pattern;
}

std::string pattern_svg(const Pattern& pattern) {
  std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
                    number(pattern.width_mm) + "mm\" height=\"" + number(pattern.height_mm) + "mm\" viewBox=\"0 0 " +
                    number(pattern.width_mm) + " " + number(pattern.height_mm) + "\">\n<title>" +
                    escaped(pattern.title) + "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  for (const auto& polygon : pattern.polygons) {
    svg += "<path d=\"M";
    for (const Vector2d& p : polygon.points_mm) svg += number(p.x()) + " " + number(p.y()) + " ";
    svg += std::string("Z\" fill=\"") + (polygon.black ? "black" : "white") + "\"/>\n";
  }
  for (const auto& disc : pattern.discs)
    svg += "<circle cx=\"" + number(disc.centre_mm.x()) + "\" cy=\"" + number(disc.centre_mm.y()) + "\" r=\"" +
           number(disc.radius_mm) + "\" fill=\"" + (disc.black ? "black" : "white") + "\"/>\n";
  for (const auto& text : pattern.texts) {
    svg += "<text font-family=\"Helvetica, Arial, sans-serif\" font-size=\"" + number(text.size_mm) + "\" ";
    if (text.upright)
      svg += "transform=\"translate(" + number(text.start_mm.x()) + " " + number(text.start_mm.y()) + ") rotate(-90)\"";
    else
      svg += "x=\"" + number(text.start_mm.x()) + "\" y=\"" + number(text.start_mm.y()) + "\"";
    svg += ">" + escaped(text.words) + "</text>\n";
  }
  return svg + "</svg>\n";
}

std::string pattern_pdf(const Pattern& pattern) {
  constexpr double points_per_mm = 72 / 25.4;
  // The page's own unit becomes the millimetre, y down; text is turned back.
  std::string page = number(points_per_mm, 12) + " 0 0 -" + number(points_per_mm, 12) + " 0 " +
                     number(pattern.height_mm * points_per_mm, 9) + " cm\n";
  int colour = -1;
  const auto fill = [&](bool black) {
    if (colour == (black ? 0 : 1)) return;
    colour = black ? 0 : 1;
    page += std::to_string(colour) + " g\n";
  };
  for (const auto& polygon : pattern.polygons) {
    fill(polygon.black);
    const char* operation = " m ";
    for (const Vector2d& p : polygon.points_mm) {
      page += number(p.x()) + " " + number(p.y()) + operation;
      operation = " l ";
    }
    page += "h f\n";
  }
  for (const auto& disc : pattern.discs) {
    fill(disc.black);
    const double r = disc.radius_mm;
    const double k = 0.5522847498 * r;  // four Bézier curves: within 0.03 % of a circle
    const auto at = [&](double x, double y) {
      return number(disc.centre_mm.x() + x) + " " + number(disc.centre_mm.y() + y) + " ";
    };
    page += at(r, 0) + "m " + at(r, k) + at(k, r) + at(0, r) + "c " + at(-k, r) + at(-r, k) + at(-r, 0) + "c " +
            at(-r, -k) + at(-k, -r) + at(0, -r) + "c " + at(k, -r) + at(r, -k) + at(r, 0) + "c h f\n";
  }
  fill(true);
  for (const auto& text : pattern.texts) {
    std::string words;
    for (const char c : text.words) words += (c == '(' || c == ')' || c == '\\' ? "\\" : "") + std::string(1, c);
    page += "BT /F1 " + number(text.size_mm) + " Tf " + (text.upright ? "0 -1 -1 0 " : "1 0 0 -1 ") +
            number(text.start_mm.x()) + " " + number(text.start_mm.y()) + " Tm (" + words + ") Tj ET\n";
  }

  std::string title;
  for (const char c : pattern.title) title += (c == '(' || c == ')' || c == '\\' ? "\\" : "") + std::string(1, c);
  const std::array<std::string, 6> objects{
      "<< /Type /Catalog /Pages 2 0 R /ViewerPreferences << /PrintScaling /None >> >>",
      "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
      "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 " + number(pattern.width_mm * points_per_mm, 9) + " " +
          number(pattern.height_mm * points_per_mm, 9) + "] /Contents 4 0 R /Resources << /Font << /F1 5 0 R >> >> >>",
      "<< /Length " + std::to_string(page.size()) + " >>\nstream\n" + page + "endstream",
      "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>",
      "<< /Title (" + title + ") /Creator (horopter pattern) >>"};
  std::string pdf = "%PDF-1.4\n%\xE2\xE3\xCF\xD3\n";
  std::array<std::size_t, objects.size()> offsets{};
  for (std::size_t i = 0; i < objects.size(); ++i) {
    offsets[i] = pdf.size();
    pdf += std::to_string(i + 1) + " 0 obj\n" + objects[i] + "\nendobj\n";
  }
  const std::size_t table = pdf.size();
  pdf += "xref\n0 " + std::to_string(objects.size() + 1) + "\n0000000000 65535 f \n";
  for (const std::size_t offset : offsets) {
    const std::string digits = std::to_string(offset);
    pdf += std::string(10 - digits.size(), '0') + digits + " 00000 n \n";
  }
  pdf += "trailer\n<< /Size " + std::to_string(objects.size() + 1) + " /Root 1 0 R /Info 6 0 R >>\nstartxref\n" +
         std::to_string(table) + "\n%%EOF\n";
  return pdf;
}

}  // namespace horopter::calib
