// SPDX-License-Identifier: Apache-2.0
// Rendered scenes: both cameras see one wall and one body, where the camera model says; and the limits of a share.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "horopter/base/interval.hpp"
#include "horopter/study/scene.hpp"
#include "table_11_1.hpp"

using namespace horopter;
using namespace horopter::study;
using Eigen::Vector3d;

namespace {

/// Waves that no sampling spoils.
Image photograph() {
  Image image(640, 480);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      image.at(x, y) = static_cast<std::uint8_t>(128 + 60 * std::sin(x / 9.0) + 50 * std::cos(y / 7.0 + x / 31.0));
    }
  }
  return image;
}

double at(const Raster<float>& view, Point place) {
  const int x = static_cast<int>(std::floor(place.x)), y = static_cast<int>(std::floor(place.y));
  const double a = place.x - x, b = place.y - y;
  return (1 - b) * ((1 - a) * view.at(x, y) + a * view.at(x + 1, y)) +
         b * ((1 - a) * view.at(x, y + 1) + a * view.at(x + 1, y + 1));
}

/// Largest difference of what a left pixel and its place on a surface in the right image show; how many were compared.
std::pair<double, int> largest_difference(const CameraPair& cameras, const Surface& surface,
                                          const WallScene::Views& views, int left, int top, int right, int bottom) {
  double largest = 0;
  int compared = 0;
  for (int y = top; y < bottom; y += 3) {
    for (int x = left; x < right; x += 3) {
      const Rays rays = cameras.rays(std::array{Point{1.0 * x, 1.0 * y}});
      Look look;
      cameras.look(surface, rays, 1, {}, std::span(&look, 1));
      if (!(look.source.x >= 1 && look.source.x < 638 && look.source.y >= 1 && look.source.y < 478)) continue;
      largest = std::max(largest, std::abs(views[0].at(x, y) - at(views[1], look.source)));
      ++compared;
    }
  }
  return {largest, compared};
}

}  // namespace

TEST_CASE("Both cameras see the wall where the camera model says") {
  const CameraPair cameras = table_11_1(640, 480, 1e-3);
  const Vector3d place(0, 0, 900), normal = Vector3d(0.1, -0.05, -1).normalized();
  const WallScene scene(cameras, photograph(), place, normal);
  const auto [there, compared] =
      largest_difference(cameras, *make_plane(place, normal), scene.empty(), 10, 10, 630, 470);
  CHECK(compared > 10'000);
  CHECK(there < 4);
  const auto elsewhere =
      largest_difference(cameras, *make_plane(place * 0.97, normal), scene.empty(), 10, 10, 630, 470);
  CHECK(elsewhere.first > 40);
  // Light goes with the wall.
  const auto lit = scene.lit([](double u, double) { return u < 0 ? 0.5 : 1; });
  const double share = lit[0].at(100, 240) / scene.empty()[0].at(100, 240);
  CHECK((share == Approx(0.5) || share == Approx(1)));
  CHECK(lit[0].at(100, 240) / scene.empty()[0].at(100, 240) !=
        Approx(lit[0].at(540, 240) / scene.empty()[0].at(540, 240)));
}

TEST_CASE("Both cameras see a body where it is, and nothing else changes") {
  const CameraPair cameras = table_11_1(640, 480, 0);
  const WallScene scene(cameras, photograph(), {0, 0, 1200}, {0, 0, -1});
  Eigen::Matrix3d axes;
  axes << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  // So large a rod that its front is nearly flat.
  const PlacedBody body = place(rod_segments(400, 500), {0, 0, 800}, axes);
  for (const Coat coat : kCoats) {
    const auto views = scene.with_body(body, coat, 3);
    CAPTURE(name_of(coat));
    const auto [there, compared] =
        largest_difference(cameras, *make_capsules(body.segments), views, 270, 210, 370, 270);
    CHECK(compared > 500);
    CHECK(there < 25);  // between pixels of a pattern
    double changed = 0;
    for (int x = 0; x < 640; ++x) changed += std::abs(views[0].at(x, 2) - scene.empty()[0].at(x, 2));
    CHECK(changed == 0);
    CHECK(views[0].at(320, 240) != scene.empty()[0].at(320, 240));
  }
  // The texture is there, a glove is nearly black, and a seed paints the same again.
  const auto textured = scene.with_body(body, Coat::textured, 3);
  const auto deviation = [](const Raster<float>& view) {
    double sum = 0, square = 0;
    for (int x = 270; x < 370; ++x) {
      sum += view.at(x, 240) / 100;
      square += view.at(x, 240) * view.at(x, 240) / 100;
    }
    return std::sqrt(std::max(0.0, square - sum * sum));
  };
  CHECK(deviation(textured[0]) > 15);
  CHECK(deviation(scene.with_body(body, Coat::plain, 3)[0]) < 8);
  CHECK(scene.with_body(body, Coat::glove, 3)[0].at(320, 240) < 25);
  CHECK(scene.with_body(body, Coat::textured, 3)[0] == textured[0]);
  CHECK_FALSE(scene.with_body(body, Coat::textured, 4)[0] == textured[0]);
  // The front of each body is at z = 0.
  for (const auto& segments : {rod_segments(40, 150), hand_segments()}) {
    double front = -1e9;
    for (const Capsule& one : segments)
      front = std::max({front, one.from_mm.z() + one.radius_mm, one.to_mm.z() + one.radius_mm});
    CHECK(front == Approx(0).margin(1e-9));
  }
  CHECK_THROWS_AS(scene.with_body(place(rod_segments(40, 150), {0, 0, -100}, axes), Coat::plain, 1),
                  std::invalid_argument);
}

TEST_CASE("Noise is that which was asked for, and the same for the same number") {
  const Raster<float> grey(320, 240, 100);
  const Image image = expose(grey, 3, 1, 7);
  double sum = 0, square = 0;
  for (const std::uint8_t pixel : image.pixels) {
    sum += pixel;
    square += (pixel - 100.0) * (pixel - 100.0);
  }
  CHECK(sum / 76'800 == Approx(100).margin(0.05));
  CHECK(std::sqrt(square / 76'800) == Approx(3.01).margin(0.05));
  CHECK(expose(grey, 3, 1, 7) == image);
  CHECK_FALSE(expose(grey, 3, 1, 8) == image);
  CHECK_FALSE(expose(grey, 3, 2, 7) == image);
}

TEST_CASE("Wilson's interval") {
  const auto check = [](int hits, int of, double low, double high) {
    const Interval found = wilson(hits, of);
    CHECK(found.low == Approx(low).margin(5e-5));
    CHECK(found.high == Approx(high).margin(5e-5));
  };
  check(0, 10, 0, 0.2775);
  check(5, 10, 0.2366, 0.7634);
  check(10, 10, 0.7225, 1);
  check(0, 0, 0, 1);
  check(999, 1000, 0.99436, 0.99982);
}

TEST_CASE("A goal is reached where the lower limit reaches it, and not by few of few") {
  constexpr double kGoal = 0.999;
  CHECK(goal_of(16, 16, kGoal) == Goal::too_few);
  CHECK(goal_of(2499, 2500, kGoal) == Goal::too_few);
  CHECK(goal_of(3837, 3837, kGoal) == Goal::too_few);
  CHECK(goal_of(3838, 3838, kGoal) == Goal::reached);
  CHECK(goal_of(15, 16, kGoal) == Goal::missed);
  CHECK(goal_of(2497, 2500, kGoal) == Goal::missed);
  CHECK(goal_of(0, 0, kGoal) == Goal::too_few);
}
