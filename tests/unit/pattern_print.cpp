// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <string>

#include "horopter/calib/pattern.hpp"

using namespace horopter::calib;
using Catch::Contains;
using Eigen::Vector2d;

namespace {

/// The sheet as a scanner would see it, from the shapes; `scale` pixels per mm.
cv::Mat scanned(const Pattern& pattern, double scale) {
  constexpr int bits = 8;
  cv::Mat image(static_cast<int>(pattern.height_mm * scale), static_cast<int>(pattern.width_mm * scale), CV_8U,
                cv::Scalar(230));
  // Pixel centres are at whole numbers: the corner of the sheet is at (−½, −½).
  const auto fixed = [&](double mm) { return static_cast<int>(std::lround((mm * scale - 0.5) * (1 << bits))); };
  for (const auto& polygon : pattern.polygons) {
    std::vector<cv::Point> points;
    for (const Vector2d& p : polygon.points_mm) points.emplace_back(fixed(p.x()), fixed(p.y()));
    cv::fillConvexPoly(image, points, polygon.black ? 20 : 230, cv::LINE_AA, bits);
  }
  for (const auto& disc : pattern.discs)
    cv::circle(image, {fixed(disc.centre_mm.x()), fixed(disc.centre_mm.y())},
               static_cast<int>(disc.radius_mm * scale * (1 << bits)), disc.black ? 20 : 230, cv::FILLED, cv::LINE_AA,
               bits);
  cv::GaussianBlur(image, image, {5, 5}, 0.9);
  return image;
}

/// Numbers before an operator of the page's content.
std::vector<std::array<double, 2>> pdf_operands(const std::string& pdf, const std::string& operation) {
  std::vector<std::array<double, 2>> result;
  const std::size_t start = pdf.find("stream\n") + 7;
  const std::string page = pdf.substr(start, pdf.find("endstream") - start);
  std::vector<std::string> words;
  std::string word;
  for (const char c : page)
    if (c == ' ' || c == '\n') {
      if (word == operation && words.size() >= 2)
        result.push_back({std::atof(words[words.size() - 2].c_str()), std::atof(words.back().c_str())});
      if (!word.empty()) words.push_back(word);
      word.clear();
    } else {
      word += c;
    }
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

    // What the PDF paints, back in mm.
    const std::string pdf = pattern_pdf(pattern);
    const auto starts = pdf_operands(pdf, "m");
    std::size_t found = 0;
    for (const auto& start : starts)
      for (std::size_t i = 0; i < points.size(); i += 4)
        if ((Vector2d(start[0], start[1]) - pattern.origin_mm - points[i]).norm() < 0.001) ++found;
    CHECK(found == 48);
    CHECK(pdf.find("2.834645669291 0 0 -2.834645669291 0 841.88976378 cm") != std::string::npos);
    CHECK(pdf.find("/MediaBox [0 0 595.275590551 841.88976378]") != std::string::npos);
    CHECK(pdf.find("/PrintScaling /None") != std::string::npos);
    const std::string svg = pattern_svg(pattern);
    CHECK(svg.find("width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\"") != std::string::npos);
    CHECK(svg.find("150 mm") != std::string::npos);
  }
}

TEST_CASE("the cross-reference table of the PDF points at its objects") {
  const std::string pdf =
      pattern_pdf(make_pattern({TargetSpec::parse("diamonds:4x3:20mm:40mm"), paper_size("a4"), true, true}));
  const std::size_t table = std::strtoul(pdf.c_str() + pdf.find("startxref\n") + 10, nullptr, 10);
  REQUIRE(pdf.compare(table, 5, "xref\n") == 0);
  std::size_t entry = pdf.find("0000000000 65535 f \n", table) + 20;
  for (int i = 1; i <= 6; ++i, entry += 20) {
    const std::size_t offset = std::strtoul(pdf.substr(entry, 10).c_str(), nullptr, 10);
    CHECK(pdf.compare(offset, 7, std::to_string(i) + " 0 obj") == 0);
  }
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
