// SPDX-License-Identifier: Apache-2.0
// Pictures: what plots and pictures of thickness say about themselves.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "horopter/draw/map_draw.hpp"
#include "horopter/draw/overlay.hpp"
#include "horopter/draw/plot.hpp"
#include "horopter/machine/regions.hpp"

using namespace horopter;

namespace {

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

struct Colour {
  int blue, green, red;
};
Colour at(const Picture& picture, int x, int y) {
  const std::size_t i =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
  return {picture.bgr[i], picture.bgr[i + 1], picture.bgr[i + 2]};
}

}  // namespace

TEST_CASE("A plot has its title, labels, and one entry of the legend for each name") {
  const Curve rising{"a < b", {{0, 0.1}, {1, 0.2}, {2, 0.4}}};
  const Panel panel{"Error", "disparity, px", "error, px", {rising}};
  Panel logarithmic = panel;
  logarithmic.log_y = true;
  const std::string svg = plot_svg("A title", {panel, logarithmic}, 2);
  CHECK_THAT(svg, Catch::StartsWith("<?xml") && Catch::EndsWith("</svg>\n"));
  CHECK(count(svg, ">A title<") == 1);
  CHECK(count(svg, ">Error<") == 2);
  CHECK(count(svg, ">disparity, px<") == 2);
  CHECK(count(svg, ">error, px<") == 1);
  CHECK(count(svg, ">error, px, log scale<") == 1);
  CHECK(count(svg, "<text") - count(plot_svg("A title", {{"", "", "", {}}}, 1), "<text") > 10);
  // Once in the legend, once for each curve as what is shown when it is pointed at.
  CHECK(count(svg, "a &lt; b</text>") == 1);
  CHECK(count(svg, "<title>a &lt; b</title>") == 2);
}

TEST_CASE("A title longer than its plot goes on in a second line") {
  const Panel panel{"", "x", "y", {{"a", {{0, 0}, {1, 1}}}}};
  const std::string words = "one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen";
  const std::string svg = plot_svg(words, {panel}, 1);
  CHECK(count(svg, words) == 0);
  CHECK(count(svg, "font-size=\"14\"") == 2);
  CHECK_THAT(svg, Catch::Contains(">one two three") && Catch::Contains(" fifteen<"));
}

TEST_CASE("Plots leave out what has no value, and nothing stands where there is none at all") {
  const std::string svg = plot_svg("", {{"", "x", "y", {{"a", {{0, 1}, {1, NAN}, {2, 3}, {3, 4}}}}}}, 1);
  CHECK_THAT(svg, !Catch::Contains("nan") && !Catch::Contains("inf"));
  CHECK(count(svg, "<path d=\"M") > 2);
  CHECK_THAT(plot_svg("", {{"", "only x", "only y", {{"a", {{0, NAN}}}}}}, 1), !Catch::Contains("only x"));
}

TEST_CASE("A picture of thickness is framed, and its scale runs from the thinnest to the thickest") {
  constexpr int kWidth = 500;
  constexpr int kHeight = 120;
  std::vector<double> mm(static_cast<std::size_t>(kWidth) * kHeight, NAN);
  for (int y = 0; y < kHeight; ++y) {
    constexpr int kHalf = kWidth / 2;
    for (int x = 0; x < kHalf; ++x) mm[static_cast<std::size_t>(y * kWidth + x)] = 10.0 + 10.0 * x / (kHalf - 1);
  }
  const ThicknessPicture drawn = draw_thickness(kWidth, kHeight, mm, "Thickness");
  CHECK(drawn.thinnest_mm == 10);
  CHECK(drawn.thickest_mm == Approx(20));
  const Picture& picture = drawn.picture;
  REQUIRE(picture.bgr.size() == 3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  CHECK(picture.width > kWidth + 50);
  CHECK(picture.height > kHeight + 100);
  // Columns of the page that are red to blue from left to right: the picture's own and the scale's.
  int rows = 0;
  for (int y = 0; y < picture.height; ++y) {
    const Colour left = at(picture, 60, y);
    rows += left.red > 2 * left.blue && left.red > 100 && left.green < 100 ? 1 : 0;
  }
  CHECK(rows > kHeight);
  CHECK(rows < kHeight + 20);
  // White about everything.
  for (const auto& [x, y] : {std::pair{0, 0}, {picture.width - 1, 0}, {0, picture.height - 1}})
    CHECK(at(picture, x, y).green == 255);
}

TEST_CASE("A skin that is nowhere supervised has a picture, too") {
  const ThicknessPicture drawn = draw_thickness(40, 30, std::vector<double>(1200, NAN), "Thickness");
  CHECK(std::isnan(drawn.thinnest_mm));
  CHECK(drawn.picture.width >= 300);
}

TEST_CASE("Where no body is found the picture of the smallest bodies is grey, and the scale is without it") {
  constexpr int kWidth = 300, kHeight = 60;
  std::vector<double> mm(static_cast<std::size_t>(kWidth) * kHeight, INFINITY);
  const auto grey_rows = [&](const Picture& picture) {
    int rows = 0;
    for (int y = 0; y < picture.height; ++y) {
      const Colour colour = at(picture, 200, y);
      const int most = std::max({colour.red, colour.green, colour.blue}),
                least = std::min({colour.red, colour.green, colour.blue});
      rows += most - least < 80 && most > 100 && most < 200 ? 1 : 0;
    }
    return rows;
  };
  const ThicknessPicture none = draw_bodies(kWidth, kHeight, mm, "Bodies");
  CHECK(std::isnan(none.thickest_mm));
  CHECK(grey_rows(none.picture) >= kHeight);
  for (std::size_t i = 0; i < mm.size(); ++i) {
    if (i % kWidth < 100) mm[i] = 20 + static_cast<double>(i % kWidth);
  }
  const ThicknessPicture some = draw_bodies(kWidth, kHeight, mm, "Bodies");
  CHECK(some.thinnest_mm == 20);
  CHECK(some.thickest_mm == 119);
  CHECK(grey_rows(some.picture) >= kHeight);
}

TEST_CASE("Pictures one below the other are of one width") {
  const Picture one{2, 1, {1, 2, 3, 4, 5, 6}};
  const Picture both = one_below_other({one, one});
  CHECK(both.width == 2);
  CHECK(both.height == 2);
  CHECK(both.bgr == std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 6});
  CHECK_THROWS_AS(one_below_other({one, {1, 1, {1, 2, 3}}}), std::invalid_argument);
}

TEST_CASE("An overlay frames objects that are an alarm in red, with their size, and others in yellow") {
  const int width = 320, height = 240;
  FrameResult result;
  result.states = Image(width, height);
  for (int y = 100; y < 160; ++y) {
    for (int x = 50; x < 130; ++x) result.states.at(x, y) = static_cast<std::uint8_t>(State::skin);
    for (int x = 200; x < 230; ++x) result.states.at(x, y) = static_cast<std::uint8_t>(State::skin);
  }
  result.object_limit_pixels = 3000;
  const Picture overlay = draw_overlay(Image(width, height, 90), result);
  const int bar = overlay.height - overlay.width * height / width;  // above the picture
  const int scale = overlay.width / width;
  const auto corner = [&](int x, int y) { return at(overlay, scale * x, bar + scale * y); };
  CHECK(corner(50, 130).red > 200);
  CHECK(corner(50, 130).green < 80);
  CHECK(corner(200, 130).red > 200);
  CHECK(corner(200, 130).green > 200);
  result.object_limit_pixels = 0;  // none is
  const Picture none = draw_overlay(Image(width, height, 90), result);
  CHECK(at(none, scale * 50, bar + scale * 130).green > 200);
}

TEST_CASE("An overlay shows an object's id, size in mm and way") {
  const int width = 320, height = 240;
  FrameResult result;
  result.states = Image(width, height);
  for (int y = 60; y < 160; ++y) {
    for (int x = 200; x < 310; ++x) result.states.at(x, y) = static_cast<std::uint8_t>(State::skin);
  }
  result.object_limit_pixels = 3000;
  const Image left(width, height, 90);
  TrackedObject object;
  object.region = objects_of(result).at(0);
  object.id = 1;
  const Picture numbered = draw_overlay(left, result);
  CHECK(draw_overlay(left, result, {object}).bgr == numbered.bgr);  // nothing more is known of it
  const auto differs = [&](const Picture& other) { return other.bgr != numbered.bgr; };
  object.id = 12;
  CHECK(differs(draw_overlay(left, result, {object})));
  object.id = 1;
  object.in_space = ObjectInSpace{1000, 120, 80, {0, 0, 800}};
  CHECK(differs(draw_overlay(left, result, {object})));
  object.in_space.reset();
  // It goes to the left: white where it will be, and not on the other side.
  object.motion = ObjectMotion{{-24, 0}, {}, {}};
  const Picture moving = draw_overlay(left, result, {object});
  const int scale = moving.width / width;
  const int bar = moving.height - scale * height;
  const auto is_white = [&](int x, int y) {
    const Colour c = at(moving, scale * x, bar + scale * y);
    return c.blue > 220 && c.green > 220 && c.red > 220;
  };
  const int y = static_cast<int>(std::lround(object.region.centroid_y));
  CHECK(is_white(200, y));
  CHECK(is_white(160, y));
  CHECK_FALSE(is_white(120, y));
  CHECK_FALSE(is_white(280, y));
  // One that does not move has no arrow, and one of another frame is not taken for this one.
  object.motion = ObjectMotion{{0.1, 0}, {}, {}};
  CHECK_FALSE(differs(draw_overlay(left, result, {object})));
  object.motion = ObjectMotion{{-24, 0}, {}, {}};
  ++object.region.pixels;
  CHECK_FALSE(differs(draw_overlay(left, result, {object})));
}
