// SPDX-License-Identifier: Apache-2.0
// The simulated photographs: what each condition does to them, and that a seed repeats them.
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "horopter/calib/random.hpp"
#include "horopter/study/simulation.hpp"

using namespace horopter;
using namespace horopter::study;

namespace {

Conditions small() {
  Conditions conditions;
  conditions.camera.width = 96;
  conditions.camera.height = 64;
  return conditions;
}

double mean_of(const Plane& plane) {
  return std::accumulate(plane.values.begin(), plane.values.end(), 0.0) / static_cast<double>(plane.values.size());
}

double rms_difference(const Plane& a, const Plane& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) sum += std::pow(a.values[i] - b.values[i], 2);
  return std::sqrt(sum / static_cast<double>(a.values.size()));
}

}  // namespace

TEST_CASE("gaussian numbers have mean 0 and deviation 1") {
  horopter::calib::Random random(3);
  double sum = 0;
  double square = 0;
  constexpr int kCount = 400000;
  for (int i = 0; i < kCount; ++i) {
    const double value = random.gaussian();
    sum += value;
    square += value * value;
  }
  CHECK(std::abs(sum / kCount) < 0.01);
  CHECK(square / kCount == Approx(1).epsilon(0.01));
}

TEST_CASE("every texture has the contrast and brightness asked for, and comes again with its seed") {
  Conditions conditions = small();
  conditions.texture.kind =
      GENERATE(TextureKind::dead_leaves, TextureKind::band_noise, TextureKind::printed_dots, TextureKind::picture);
  auto picture = std::make_shared<Image>(40, 30);
  horopter::calib::Random random(7);
  for (auto& pixel : picture->pixels) pixel = static_cast<std::uint8_t>(random.next());
  conditions.texture.picture = picture;
  conditions.texture.picture_scale = 1.7;
  const Simulation simulation(conditions, 3);
  const Plane exact = simulation.exact(0);
  CAPTURE(name_of(conditions.texture.kind));
  CHECK(texture_kind(name_of(conditions.texture.kind)) == conditions.texture.kind);
  CHECK(local_deviation(exact) == Approx(conditions.lighting.deviation_grey).epsilon(1e-4));
  CHECK(mean_of(exact) == Approx(conditions.lighting.mean_grey).epsilon(1e-4));
  CHECK(simulation.photograph(1.3, 4) == Simulation(conditions, 3).photograph(1.3, 4));
  CHECK_FALSE(simulation.photograph(1.3, 4) == simulation.photograph(1.3, 5));
  if (conditions.texture.kind != TextureKind::picture) {
    conditions.seed = 2;
    CHECK_FALSE(Simulation(conditions, 3).exact(0) == exact);
  }
}

TEST_CASE("textures have the structures asked for") {
  // Correlation of a texture with itself at a distance along x, over its theory.
  constexpr int kOversampling = 4;
  const auto correlation = [](const Raster<float>& image, int distance) {
    const double n = static_cast<double>(image.values.size());
    const double mean = std::accumulate(image.values.begin(), image.values.end(), 0.0) / n;
    double variance = 0;
    for (const float value : image.values) variance += (value - mean) * (value - mean) / n;
    double product = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = distance; x < image.width; ++x)
        product += (image.at(x, y) - mean) * (image.at(x - distance, y) - mean);
    return product / (static_cast<double>(image.width - distance) * image.height) / variance;
  };
  Texture texture;
  texture.smallest_px = 2;
  texture.largest_px = 6;

  texture.kind = TextureKind::dead_leaves;
  const Raster<float> leaves = draw_texture(texture, 250, 250, kOversampling, 3);
  // Mean area that a disc shares with itself displaced, over diameters with density d⁻³.
  const auto shared_area = [&](double h) {
    double sum = 0;
    constexpr int kSteps = 1000;
    for (int i = 0; i < kSteps; ++i) {
      const double d =
          texture.smallest_px + (texture.largest_px - texture.smallest_px) * (i + 0.5) / static_cast<double>(kSteps);
      if (h < d) sum += (d * d * std::acos(h / d) - h * std::sqrt(d * d - h * h)) / 2 / (d * d * d);
    }
    return sum;
  };
  for (const double h : {0.5, 1.0, 2.0, 3.0, 6.0}) {
    // Of leaves that cover either of two places, those that cover both.
    const double expected = shared_area(h) / (2 * shared_area(0) - shared_area(h));
    CAPTURE(h);
    CHECK(correlation(leaves, static_cast<int>(h * kOversampling)) == Approx(expected).margin(0.03));
  }

  texture.kind = TextureKind::band_noise;
  const Raster<float> band = draw_texture(texture, 250, 250, kOversampling, 3);
  // A Gaussian of the smallest half-width less one of the largest; both are means of whole samples, within 6 %.
  const double narrow = std::pow(texture.smallest_px / 2.3548, 2);
  const double wide = std::pow(texture.largest_px / 2.3548, 2);
  const auto covariance = [&](double h) {
    const auto bell = [h](double v) { return std::exp(-h * h / (2 * v)) / v; };
    return bell(2 * narrow) + bell(2 * wide) - 2 * bell(narrow + wide);
  };
  for (const double h : {0.5, 1.0, 2.0, 3.0, 6.0}) {
    CAPTURE(h);
    CHECK(correlation(band, static_cast<int>(h * kOversampling)) == Approx(covariance(h) / covariance(0)).margin(0.07));
  }

  texture.kind = TextureKind::printed_dots;
  const Raster<float> dots = draw_texture(texture, 250, 250, kOversampling, 3);
  double paper = 0;
  for (const float value : dots.values) {
    REQUIRE((value == 0 || value == 1));
    paper += value;
  }
  CHECK(paper / static_cast<double>(dots.values.size()) == Approx(0.6).margin(0.02));
}

TEST_CASE("a picture goes on mirrored where it ends") {
  auto picture = std::make_shared<Image>(20, 12);
  horopter::calib::Random random(7);
  for (auto& pixel : picture->pixels) pixel = static_cast<std::uint8_t>(random.next());
  Texture texture;
  texture.kind = TextureKind::picture;
  texture.picture = picture;
  const Raster<float> drawn = draw_texture(texture, 50, 30, 1, 1);
  for (int y = 0; y < drawn.height; ++y)
    for (int x = 0; x < drawn.width; ++x) {
      const int u = x < 20 ? x : x < 40 ? 39 - x : x - 40;
      const int v = y < 12 ? y : y < 24 ? 23 - y : y - 24;
      REQUIRE(drawn.at(x, y) == picture->at(u, v));
    }
}

TEST_CASE("a shift by whole pixels moves the image, halves lie between") {
  const Simulation simulation(small(), 5);
  const Plane still = simulation.exact(0);
  const Plane moved = simulation.exact(3);
  for (int y = 0; y < still.height; ++y)
    for (int x = 3; x < still.width; ++x) REQUIRE(moved.at(x - 3, y) == Approx(still.at(x, y)).epsilon(1e-4));
  double last = 0;
  for (const double shift : {0.1, 0.3, 0.5, 0.8}) {
    const double difference = rms_difference(still, simulation.exact(shift));
    CHECK(difference > last);
    last = difference;
  }
  // Between two samples, an eighth of a pixel apart, as well.
  Plane middle = simulation.exact(0.125);
  for (std::size_t i = 0; i < middle.values.size(); ++i) middle.values[i] = (middle.values[i] + still.values[i]) / 2;
  CHECK(rms_difference(middle, simulation.exact(0.0625)) < 0.2 * rms_difference(still, simulation.exact(0.0625)));
  CHECK_THROWS_AS(simulation.exact(5.5), std::invalid_argument);
}

TEST_CASE("a shift for each pixel shows at each what its shift shows") {
  Conditions conditions;
  conditions.camera.width = 40;
  conditions.camera.height = 30;
  const Simulation simulation(conditions, 2);
  Raster<float> shifts(40, 30);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) shifts.at(x, y) = x < 20 ? -1.25F : 0.5F;
  const Plane found = simulation.exact(shifts);
  const Plane left = simulation.exact(-1.25);
  const Plane right = simulation.exact(0.5);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) REQUIRE(found.at(x, y) == (x < 20 ? left : right).at(x, y));
  CHECK_THROWS_AS(simulation.exact(Raster<float>(39, 30)), std::invalid_argument);
  CHECK_THROWS_AS(simulation.exact(Raster<float>(40, 30, 2.5F)), std::invalid_argument);
}

TEST_CASE("a picture is shown where it is, blurred by lens and pixel as they are said to") {
  // A vertical edge in a picture with steps of a quarter pixel: its image is the integral of pixel and Gaussian.
  Conditions conditions = small();
  auto picture = std::make_shared<Image>(800, 40, 0);
  for (int y = 0; y < 40; ++y)
    for (int x = 240; x < 800; ++x) picture->at(x, y) = 200;
  conditions.texture = {TextureKind::picture, 1, 3, picture, 0.25};
  conditions.camera.fill_factor = GENERATE(0.25, 0.85, 1.0);
  conditions.camera.blur_px = GENERATE(0.0, 0.4, 1.0);
  const Simulation simulation(conditions, 8);
  const Plane image = simulation.exact(0);
  int edge = 0;
  while (image.at(edge, 0) < (image.at(0, 0) + image.at(95, 0)) / 2) ++edge;
  double variance = 0;
  double weight = 0;
  double mean = 0;
  const int row = 30;
  // The derivative over shifts of 1/8 px is the line spread; its variance that of lens, pixel, sample and picture.
  constexpr double kStep = 0.125;
  double before = simulation.exact(-8).at(edge, row);
  for (double shift = -8 + kStep; shift <= 8; shift += kStep) {
    const double now = simulation.exact(shift).at(edge, row);
    const double place = shift - kStep / 2;
    weight += now - before;
    mean += place * (now - before);
    variance += place * place * (now - before);
    before = now;
  }
  mean /= weight;
  variance = variance / weight - mean * mean;
  const double expected = conditions.camera.blur_px * conditions.camera.blur_px + conditions.camera.fill_factor / 12;
  CAPTURE(conditions.camera.fill_factor, conditions.camera.blur_px);
  CHECK(variance == Approx(expected).margin(0.012));
  // The edge lies between two pixels of the camera: column 240 of the picture is 60 px.
  CHECK(std::abs(std::remainder(edge + mean + 0.5, 1.0)) < 0.01);
}

TEST_CASE("noise, averaging and conversion are what they say") {
  Conditions conditions = small();
  conditions.lighting.deviation_grey = 0;
  conditions.electronics.noise_grey = 4;
  conditions.electronics.averaged = GENERATE(1, 4);
  const Simulation simulation(conditions, 0);
  const Image image = simulation.photograph(0, 9);
  double square = 0;
  for (const auto pixel : image.pixels) square += std::pow(pixel - conditions.lighting.mean_grey, 2);
  // Conversion adds 1/12 for each image and once more for the mean.
  const int n = conditions.electronics.averaged;
  const double expected = (16 + 1 / 12.0) / n + (n > 1 ? 1 / 12.0 : 0);
  CHECK(square / static_cast<double>(image.pixels.size()) == Approx(expected).epsilon(0.06));

  conditions.electronics.bits = 2;
  conditions.electronics.averaged = 1;
  for (const auto pixel : Simulation(conditions, 0).photograph(0, 1).pixels) REQUIRE(pixel % 85 == 0);
}

TEST_CASE("electronics can be exchanged") {
  const Simulation simulation(small(), 0);
  const Plane still = simulation.exact(0);
  CHECK(simulation.expose(still, small().electronics, 7) == simulation.photograph(0, 7));
  const Image noiseless = simulation.expose(still, {.noise_grey = 0, .averaged = 1}, 7);
  for (std::size_t i = 0; i < still.values.size(); ++i) REQUIRE(noiseless.pixels[i] == std::lround(still.values[i]));
  CHECK_THROWS_AS(simulation.expose(Plane(5, 5), small().electronics, 7), std::invalid_argument);
}

TEST_CASE("the local deviation is of the window's own mean") {
  Plane ramp(20, 15);
  for (int y = 0; y < ramp.height; ++y)
    for (int x = 0; x < ramp.width; ++x) ramp.at(x, y) = 100 + 3 * x;
  CHECK(local_deviation(ramp, 7) == Approx(3 * 2));  // of −3 … 3
  CHECK(local_deviation(ramp, 3) == Approx(3 * std::sqrt(2 / 3.0)));
  CHECK_THROWS_AS(local_deviation(ramp, 4), std::invalid_argument);
}

TEST_CASE("light and jitter") {
  Conditions conditions = small();
  conditions.lighting.deviation_grey = 0;
  conditions.lighting.slope_x = 0.4;
  conditions.lighting.slope_y = -0.3;
  conditions.lighting.falloff = 0.2;
  const Plane lit = Simulation(conditions, 0).exact(0);
  const double u = 95.0 / 96;
  const double v = 1.0 / 64;
  CHECK(lit.at(95, 32) == Approx(110 * (1 + 0.4 * u - 0.3 * v - 0.1 * (u * u + v * v))).epsilon(1e-5));
  CHECK(lit.at(0, 32) == Approx(110 * (1 - 0.4 * u - 0.3 * v - 0.1 * (u * u + v * v))).epsilon(1e-5));

  // A line is displaced as a whole: its difference from the exact one goes with the gradient, and lines differ.
  conditions = small();
  conditions.electronics = {0, 0.3, 8, 1};
  const Simulation jittered(conditions, 0);
  const Image image = jittered.photograph(0, 3);
  const Plane exact = jittered.exact(0);
  double variance_of_slopes = 0;
  for (int y = 0; y < exact.height; ++y) {
    double along = 0;
    double gradients = 0;
    for (int x = 1; x + 1 < exact.width; ++x) {
      const double gradient = (exact.at(x + 1, y) - exact.at(x - 1, y)) / 2;
      along += gradient * (image.at(x, y) - exact.at(x, y));
      gradients += gradient * gradient;
    }
    variance_of_slopes += std::pow(along / gradients, 2);
  }
  CHECK(std::sqrt(variance_of_slopes / exact.height) == Approx(0.3).epsilon(0.35));

  conditions.lighting.slope_x = 0.7;
  conditions.lighting.slope_y = 0.4;
  CHECK_THROWS_AS(Simulation(conditions, 0), std::invalid_argument);
}
