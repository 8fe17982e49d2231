// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "horopter/calib/edge.hpp"
#include "horopter/calib/edge_profile.hpp"

using namespace horopter::calib;
using Eigen::Vector2d;

namespace {

Vector2d direction(double degrees) {
  return {std::cos(degrees * std::numbers::pi / 180), std::sin(degrees * std::numbers::pi / 180)};
}

/// Largest error over positions within a pixel, across the edge.
double worst_error(EdgeMethod method, double blur_px, double degrees, bool two_windows = false) {
  EdgeOptions options;
  options.two_windows = two_windows;
  options.blur_px = std::max(blur_px, 0.05);
  const auto estimator = make_edge_estimator(method, options);
  const Vector2d normal = direction(degrees);
  double worst = 0;
  for (int i = -24; i <= 24; ++i) {
    const double position = i / 48.0;
    Imaging imaging;
    imaging.blur_px = blur_px;
    const GreyImage image = simulate_edge(25, 25, Vector2d(12, 12) + position * normal, normal, imaging);
    const auto found = estimator->estimate(image, Vector2d(12, 12), normal);
    REQUIRE(found);
    worst = std::max(worst, std::abs(normal.dot(found->position_px - Vector2d(12, 12)) - position));
  }
  return worst;
}

struct CornerErrors {
  double rms_px;
  int squares;
};
/// RMS, per coordinate, of the corners of a 64 px square, 16 points an edge, noise of 1 grey level.
CornerErrors corner_errors(EdgeMethod method, double degrees) {
  const auto estimator = make_edge_estimator(method);
  double sum = 0;
  int squares = 0;
  for (int i = 0; i < 24; ++i) {
    Imaging imaging;
    imaging.blur_px = 0.6;
    imaging.noise = 1;
    imaging.quantise = true;
    const Vector2d centre(60 + (i % 6) / 6.0, 60 + (i % 4) / 4.0);
    const GreyImage image = simulate_square(121, 121, centre, 64, degrees, imaging, 1000 + i);
    const auto corners = square_corners(centre, 64, degrees);
    std::vector<Line> lines;
    for (int k = 0; k < 4; ++k) {
      const Vector2d a = corners.col(k);
      const Vector2d b = corners.col((k + 1) % 4);
      const Vector2d inward = (centre - (a + b) / 2).normalized();
      // The guess is off by some tenths of a pixel, as a first localisation is.
      std::vector<Vector2d> points;
      for (const EdgePoint& point :
           edge_points(image, *estimator, a + Vector2d(0.3, -0.2), b + Vector2d(0.3, -0.2), inward, 16, 9))
        points.push_back(point.position_px);
      REQUIRE(points.size() == 16);
      lines.push_back(*fit_line(points));
    }
    for (int k = 0; k < 4; ++k)
      sum += (*intersect(lines[(k + 3) % 4], lines[k]) - Vector2d(corners.col(k))).squaredNorm() / 8;
    ++squares;
  }
  return {std::sqrt(sum / squares), squares};
}

}  // namespace

TEST_CASE("edge_profile integrates the pixel area") {
  // Against a fine sum over the square, for directions where the closed form takes each of its branches.
  for (const double degrees : {0.0, 0.001, 7.0, 30.0, 45.0, 90.0, 200.0})
    for (const double blur : {0.05, 0.5, 2.0})
      for (const double t : {-1.0, -0.3, 0.0, 0.2, 0.7}) {
        const Vector2d normal = direction(degrees);
        const int n = 200;
        double sum = 0;
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j) {
            const Vector2d p((i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5);
            sum += 0.5 * std::erfc(-(t + 0.85 * normal.dot(p)) / (blur * std::numbers::sqrt2));
          }
        CHECK(edge_profile(t, normal, blur, 0.85) == Approx(sum / n / n).margin(2e-4));
      }
}

TEST_CASE("steepest edge: what the thesis found (6.7.1)") {
  // Fill factor 0.85, the blur of 0.01 px of Fig. 6.6. A pixel's dead border alone hides 0.075 px.
  for (const EdgeMethod method : {EdgeMethod::zernike_9, EdgeMethod::zernike_13, EdgeMethod::gaussian})
    for (const double degrees : {0.0, 90.0, 180.0, 10.0, 20.0, 45.0}) {
      INFO(edge_method_name(method) << " at " << degrees << " degrees");
      CHECK(worst_error(method, 0.01, degrees) < 0.08);
    }
  const double one = worst_error(EdgeMethod::tabatabai_1d, 0.01, 0);
  const double two = worst_error(EdgeMethod::tabatabai_2d, 0.01, 0);
  CHECK(one > 0.14);
  CHECK(one < 0.25);
  CHECK(two > 0.15);
  CHECK(two < 0.25);
  const double linear = worst_error(EdgeMethod::linear, 0.01, 0);
  CHECK(linear > 0.08);
  CHECK(linear < one);
}

TEST_CASE("smooth ramps: pulled to the centre of the window, less by a larger one") {
  CHECK(worst_error(EdgeMethod::zernike_13, 1.8, 0) < 0.6 * worst_error(EdgeMethod::zernike_9, 1.8, 0));
  CHECK(worst_error(EdgeMethod::gaussian, 1.8, 0) < 0.01);
  CHECK(worst_error(EdgeMethod::linear, 1.2, 0) < 0.02);
}

TEST_CASE("two windows have no pull, whatever the blur and direction") {
  for (const EdgeMethod method : {EdgeMethod::zernike_9, EdgeMethod::zernike_13})
    for (const double blur : {0.6, 1.0, 1.6, 2.2})
      for (const double degrees : {0.0, 20.0, 45.0, 110.0, 250.0}) {
        INFO(edge_method_name(method) << ", blur " << blur << ", " << degrees << " degrees");
        CHECK(worst_error(method, blur, degrees, true) < 0.003);
      }
}

TEST_CASE("fits for comparison find a symmetric ramp") {
  CHECK(worst_error(EdgeMethod::sigmoid, 1.0, 20) < 0.01);
  CHECK(worst_error(EdgeMethod::arctangent, 1.2, 20) < 0.03);
  CHECK(worst_error(EdgeMethod::spline, 1.0, 20) < 0.03);
  CHECK(worst_error(EdgeMethod::polynomial, 1.8, 20) < 0.2);
  CHECK(worst_error(EdgeMethod::maximum_likelihood, 1.0, 20) < 0.001);
}

TEST_CASE("maximum likelihood pays for a wrong edge shape (6.6.5)") {
  EdgeOptions step;
  step.blur_px = 0.05;
  const auto estimator = make_edge_estimator(EdgeMethod::maximum_likelihood, step);
  Imaging imaging;
  imaging.blur_px = 1.2;
  double worst = 0;
  for (int i = -10; i <= 10; ++i) {
    const Vector2d normal(1, 0);
    const GreyImage image = simulate_edge(25, 25, Vector2d(12 + i / 20.0, 12), normal, imaging);
    const auto found = estimator->estimate(image, Vector2d(12, 12), normal);
    REQUIRE(found);
    worst = std::max(worst, std::abs(found->position_px.x() - 12 - i / 20.0));
  }
  CHECK(worst > 0.05);
}

TEST_CASE("offset and contrast do not move an edge") {
  for (const EdgeMethod method : all_edge_methods()) {
    const auto estimator = make_edge_estimator(method);
    const Vector2d normal = direction(25);
    Imaging dim;
    dim.dark = 20;
    dim.bright = 40;
    Imaging strong;
    strong.dark = 5;
    strong.bright = 250;
    const Vector2d point(12.3, 11.9);
    const auto a = estimator->estimate(simulate_edge(25, 25, point, normal, dim), Vector2d(12, 12), normal);
    const auto b = estimator->estimate(simulate_edge(25, 25, point, normal, strong), Vector2d(12, 12), normal);
    INFO(edge_method_name(method));
    REQUIRE(a);
    REQUIRE(b);
    CHECK((a->position_px - b->position_px).norm() < 1e-3);
    CHECK(b->contrast == Approx(245).epsilon(0.15));
  }
}

TEST_CASE("noise of 1 grey level on a 64 px diamond, 16 points an edge (6.7.2)") {
  const CornerErrors diamond = corner_errors(EdgeMethod::zernike_13, 45);
  CHECK(diamond.rms_px > 0.003);
  CHECK(diamond.rms_px < 0.03);
  CHECK(corner_errors(EdgeMethod::gaussian, 45).rms_px < 0.03);
}

TEST_CASE("line jitter moves lines along themselves: across an upright edge, not across a level one (6.7.2)") {
  Imaging imaging;
  imaging.blur_px = 1.2;  // a ramp on which a displacement is found as large as it is
  imaging.jitter_px = 0.1;
  const auto estimator = make_edge_estimator(EdgeMethod::linear, {});
  const auto deviation = [&](const Eigen::Vector2d& normal) {
    double squares = 0;
    constexpr int kImages = 200;
    for (int seed = 0; seed < kImages; ++seed) {
      const auto image = simulate_edge(25, 25, {12, 12}, normal, imaging, static_cast<std::uint64_t>(seed));
      const auto found = estimator->estimate(image, {12, 12}, normal);
      REQUIRE(found);
      squares += std::pow(normal.dot(found->position_px - Eigen::Vector2d(12, 12)), 2) / kImages;
    }
    return std::sqrt(squares);
  };
  CHECK(deviation({1, 0}) == Approx(0.1).epsilon(0.2));
  CHECK(deviation({0, 1}) < 1e-6);
  imaging.jitter_px = 0;
  CHECK(deviation({1, 0}) < 1e-6);
}

TEST_CASE("no edge is no point") {
  GreyImage flat(30, 30, 100);
  GreyImage noisy(30, 30, 100);
  Imaging noise;
  noise.noise = 1;
  add_noise(noisy, noise, 7);
  const GreyImage edge = simulate_edge(30, 30, Vector2d(15, 15), Vector2d(1, 0), {});
  for (const EdgeMethod method : all_edge_methods()) {
    INFO(edge_method_name(method));
    const auto estimator = make_edge_estimator(method);
    CHECK_FALSE(estimator->estimate(flat, Vector2d(15, 15), Vector2d(1, 0)));
    CHECK_FALSE(estimator->estimate(noisy, Vector2d(15, 15), Vector2d(1, 0)));
    CHECK_FALSE(estimator->estimate(edge, Vector2d(2, 15), Vector2d(1, 0)));    // window leaves the image
    CHECK_FALSE(estimator->estimate(edge, Vector2d(15, 15), Vector2d(-1, 0)));  // dark to bright the other way
    CHECK_FALSE(estimator->estimate(edge, Vector2d(NAN, 15), Vector2d(1, 0)));
  }
}

TEST_CASE("windows and names") {
  EdgeOptions even;
  even.window_px = 8;
  CHECK_THROWS_AS(make_edge_estimator(EdgeMethod::zernike_9, even), std::invalid_argument);
  EdgeOptions thirteen;
  thirteen.window_px = 13;
  CHECK_THROWS_AS(make_edge_estimator(EdgeMethod::tabatabai_2d, thirteen), std::invalid_argument);
}

TEST_CASE("lines and corners") {
  std::vector<Vector2d> points;
  for (int i = 0; i < 16; ++i) points.emplace_back(i, 2 * i + 1 + ((i % 2) ? 0.01 : -0.01));
  points.emplace_back(5, 40);  // far off
  const auto line = fit_line(points);
  REQUIRE(line);
  CHECK(line->points == 16);
  CHECK(std::abs(line->normal.dot(Vector2d(1, 2))) < 1e-3);
  CHECK_FALSE(fit_line(std::vector<Vector2d>{{1, 1}}));
  CHECK_FALSE(fit_line(std::vector<Vector2d>{{1, 1}, {1, 1}, {1, 1}}));
  const Line horizontal{Vector2d(0, 1), 4, 0, 2};
  const auto corner = intersect(*line, horizontal);
  REQUIRE(corner);
  CHECK(corner->x() == Approx(1.5).margin(0.02));
  CHECK(corner->y() == Approx(4));
  CHECK_FALSE(intersect(horizontal, horizontal));
}
