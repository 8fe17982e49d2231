// SPDX-License-Identifier: Apache-2.0
#include <zlib.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "horopter/calib/pattern.hpp"

using namespace horopter::calib;
using Catch::Contains;
using Eigen::Vector2d;

namespace {

/// The sheet as a scanner would see it, from the shapes; `scale` pixels per mm.
cv::Mat scanned(const Pattern& pattern, double scale) {
  constexpr int kBits = 8;
  cv::Mat image(static_cast<int>(pattern.height_mm * scale), static_cast<int>(pattern.width_mm * scale), CV_8U,
                cv::Scalar(230));
  // Pixel centres are at whole numbers: the corner of the sheet is at (−½, −½).
  const auto fixed = [&](double mm) { return static_cast<int>(std::lround((mm * scale - 0.5) * (1 << kBits))); };
  for (const auto& polygon : pattern.polygons) {
    std::vector<cv::Point> points;
    for (const Vector2d& p : polygon.points_mm) points.emplace_back(fixed(p.x()), fixed(p.y()));
    cv::fillConvexPoly(image, points, polygon.black ? 20 : 230, cv::LINE_AA, kBits);
  }
  for (const auto& disc : pattern.discs)
    cv::circle(image, {fixed(disc.centre_mm.x()), fixed(disc.centre_mm.y())},
               static_cast<int>(disc.radius_mm * scale * (1 << kBits)), disc.black ? 20 : 230, cv::FILLED, cv::LINE_AA,
               kBits);
  cv::GaussianBlur(image, image, {5, 5}, 0.9);
  return image;
}

using Corners = std::vector<Vector2d>;

/// A stream of the file, inflated.
std::string inflated(const std::string& deflated) {
  std::string text(1 << 22, '\0');
  z_stream stream{};
  inflateInit(&stream);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(deflated.data()));
  stream.avail_in = static_cast<uInt>(deflated.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(text.size());
  inflate(&stream, Z_FINISH);
  text.resize(stream.total_out);
  inflateEnd(&stream);
  return text;
}

/// What the PDF paints without a curve after the white page, in the order in which it does; in mm.
std::vector<Corners> painted(const std::string& pdf) {
  std::string content;
  for (std::size_t at = pdf.find("stream\n"); at != std::string::npos; at = pdf.find("stream\n", at + 1)) {
    const std::string text = inflated(pdf.substr(at + 7));
    if (Contains(" re f").match(text)) content = text;
  }
  std::vector<Corners> result;
  std::vector<double> numbers;
  Corners path;
  bool straight = true;
  // The unit of the sheet is 1/256 pt.
  const auto mm = [&](std::size_t from_end) { return numbers[numbers.size() - from_end] / 256 / 72 * 25.4; };
  std::istringstream words(content);
  for (std::string word; words >> word;) {
    if (word == "m") path = {{mm(2), mm(1)}};
    if (word == "m") straight = true;
    if (word == "l") path.emplace_back(mm(2), mm(1));
    if (word == "c") straight = false;
    if (word == "re") {
      const Vector2d low(mm(4), mm(3)), size(mm(2), mm(1));
      path = {low, {low.x() + size.x(), low.y()}, low + size, {low.x(), low.y() + size.y()}};
    }
    if (word == "f" && straight && path.size() > 2) result.push_back(path);
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (*end == 0) numbers.push_back(value);
  }
  if (!result.empty()) result.erase(result.begin());
  return result;
}

/// What the SVG paints without a curve, likewise.
std::vector<Corners> drawn(const std::string& svg) {
  std::vector<Corners> result;
  for (std::size_t at = svg.find("</symbol>\n</g>"); at != std::string::npos; at = svg.find(" d=\"M ", at + 1)) {
    const std::string path = svg.substr(at, svg.find('Z', at) - at);
    if (!path.starts_with(" d=") || Contains(" C ").match(path)) continue;
    std::istringstream words(path.substr(4));
    Corners corners;
    double x = 0;
    double y = 0;
    // The unit of the sheet is 1/256 mm.
    for (std::string word; words >> word >> x >> y;) corners.emplace_back(x / 256, y / 256);
    result.push_back(corners);
  }
  return result;
}

/// The same corners, wherever the first one is.
bool same(const Corners& one, const Corners& other, double tolerance_mm) {
  return one.size() == other.size() && std::ranges::all_of(one, [&](const Vector2d& p) {
           return std::ranges::any_of(other, [&](const Vector2d& q) { return (p - q).norm() < tolerance_mm; });
         });
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t result = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++result;
  return result;
}

}  // namespace

TEST_CASE("paper by name or size") {
  CHECK(paper_size("a4").height_mm == 297);
  CHECK(paper_size("360x500mm").width_mm == 360);
  CHECK_THROWS_WITH(paper_size("a9"), Contains("a4"));
  CHECK_THROWS_AS(paper_size("0x0"), std::invalid_argument);
  CHECK_THROWS_AS(paper_size("100x"), std::invalid_argument);
}

TEST_CASE("every corner of the target is on the sheet where the target has it, to a micrometre") {
  for (const bool inverse : {false, true}) {
    const TargetSpec spec = TargetSpec::parse("squares:6x8:12.7mm:22.57779mm");
    const Pattern pattern = make_pattern({spec, paper_size("a4"), inverse, true});
    std::size_t fiducials = 0;
    const std::vector<Vector2d> points = spec.points_mm();
    for (const auto& polygon : pattern.polygons) {
      for (std::size_t i = 0; i < points.size(); i += 4)
        if ((polygon.points_mm[0] - pattern.origin_mm - points[i]).norm() < 1e-9) ++fiducials;
      for (const Vector2d& p : polygon.points_mm) {
        CHECK(p.x() >= 4.99);
        CHECK(p.y() >= 4.99);
        CHECK(p.x() <= pattern.width_mm - 4.99);
        CHECK(p.y() <= pattern.height_mm - 4.99);
      }
    }
    CHECK(fiducials == 48);
    CHECK(pattern.bar_x_mm == 150);
    CHECK(pattern.bar_y_mm == 200);

    // What the files paint, back in mm.
    const std::string pdf = pattern_pdf(pattern), svg = pattern_svg(pattern);
    for (const std::vector<Corners>& shapes : {painted(pdf), drawn(svg)}) {
      REQUIRE(shapes.size() == pattern.polygons.size());
      for (std::size_t i = 0; i < pattern.polygons.size(); ++i) {
        CHECK(same(shapes[i], pattern.polygons[i].points_mm, 0.001));
      }
    }
    CHECK(pdf.find("/MediaBox [ 0 0 595.275591 841.889764 ]") != std::string::npos);
    CHECK(pdf.find("/PrintScaling /None") != std::string::npos);
    CHECK(svg.find("width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\"") != std::string::npos);
    // Words are outlines: one for each letter.
    REQUIRE(pattern.texts.size() == 2);
    CHECK_THAT(pattern.texts[0].words, Catch::StartsWith("150 mm. " + spec.text()));
    CHECK(pattern.texts[1].words == "200 mm");
    CHECK(count(svg, "<use xlink:href=\"#glyph") == pattern.texts[0].words.size() + pattern.texts[1].words.size());
  }
}

TEST_CASE("the same sheet is the same PDF") {
  const Pattern pattern = make_pattern({TargetSpec::parse("chessboard:9x6:20mm"), paper_size("a4"), false, true});
  CHECK(pattern_pdf(pattern) == pattern_pdf(pattern));
}

TEST_CASE("the cross-reference tables of the PDF point at its objects") {
  const std::string pdf =
      pattern_pdf(make_pattern({TargetSpec::parse("diamonds:4x3:20mm:40mm"), paper_size("a4"), true, true}));
  // The last table is that of the catalogue alone; it leads to the one of all objects.
  int tables = 0;
  std::size_t objects = 0;
  for (std::size_t at = pdf.rfind("startxref\n") + 10; at < pdf.size(); ++tables) {
    const std::size_t table = std::strtoul(pdf.c_str() + at, nullptr, 10);
    REQUIRE(pdf.compare(table, 5, "xref\n") == 0);
    std::istringstream rows(pdf.substr(table + 5));
    std::size_t first = 0;
    std::size_t size = 0;
    rows >> first >> size;
    for (std::size_t i = first; i < first + size; ++i) {
      std::size_t offset = 0;
      std::string generation;
      char kind = 0;
      rows >> offset >> generation >> kind;
      if (kind != 'n') continue;
      CHECK(pdf.compare(offset, std::to_string(i).size() + 6, std::to_string(i) + " 0 obj") == 0);
      ++objects;
    }
    const std::size_t trailer = pdf.find("trailer", table);
    const std::size_t before = pdf.find("/Prev ", trailer);
    at = before < pdf.find("startxref", trailer) ? before + 6 : pdf.size();
  }
  CHECK(tables == 2);
  CHECK(objects > 6);
}

TEST_CASE("what is printed is found") {
  for (const char* name : {"squares:8x6:15mm:25mm", "diamonds:8x6:12mm:25mm", "chessboard:9x6:20mm"})
    for (const bool inverse : {false, true}) {
      const TargetSpec spec = TargetSpec::parse(name);
      // An inverse chessboard is another one: its outermost squares are white.
      if (spec.kind == TargetKind::chessboard && inverse) continue;
      INFO(name << (inverse ? " inverse" : ""));
      const Pattern pattern = make_pattern({spec, paper_size("a4"), inverse, true});
      const double scale = 3.1;
      const TargetView view = detect_target(scanned(pattern, scale), spec);
      CHECK(view.oriented);
      double worst = 0;
      for (std::size_t i = 0; i < view.image_px.size(); ++i)
        worst = std::max(
            worst, ((view.image_px[i] + Vector2d(0.5, 0.5)) / scale - pattern.origin_mm - view.target_mm[i]).norm());
      CHECK(worst < 0.05);  // mm
    }
}

TEST_CASE("a target that does not fit says where it would") {
  CHECK_THROWS_WITH(make_pattern({TargetSpec::parse("squares:8x6:33mm:60mm"), paper_size("a4"), true, true}),
                    Contains("needs 499 x 384 mm") && Contains("fits on a2"));
  CHECK_THROWS_WITH(make_pattern({TargetSpec::parse("squares:80x60:33mm:60mm"), paper_size("a4"), true, true}),
                    !Contains("fits on"));
}
