// SPDX-License-Identifier: Apache-2.0
// Texture measures against OpenCV's filters, and directions of few bits against the hardware's and plain arithmetic.
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "horopter/calib/random.hpp"
#include "horopter/study/direction_resolution.hpp"
#include "horopter/study/texture_measures.hpp"

using namespace horopter;
using namespace horopter::study;

namespace {

Plane noise(int width, int height, std::uint64_t seed) {
  Plane plane(width, height);
  horopter::calib::Random random(seed);
  for (double& value : plane.values) value = std::floor(256 * random.uniform());
  return plane;
}

double largest_difference(const Plane& ours, const cv::Mat& theirs) {
  double largest = 0;
  for (int y = 0; y < ours.height; ++y) {
    for (int x = 0; x < ours.width; ++x) largest = std::max(largest, std::abs(ours.at(x, y) - theirs.at<double>(y, x)));
  }
  return largest;
}

Plane measured(const char* name, const Plane& image) {
  for (const TextureMeasure& measure : texture_measures()) {
    if (measure.name == name) return measure.of(image);
  }
  throw std::invalid_argument(name);
}

}  // namespace

TEST_CASE("texture measures are OpenCV's filters, combined as the thesis says") {
  Plane plane = noise(53, 37, 3);
  const cv::Mat image(plane.height, plane.width, CV_64F, plane.values.data());
  const auto filtered = [&](const cv::Mat& kernel) {
    cv::Mat result;
    cv::filter2D(image, result, CV_64F, kernel, {-1, -1}, 0, cv::BORDER_REPLICATE);
    return result;
  };
  const auto kernel = [](std::initializer_list<double> values) {
    return cv::Mat(std::vector<double>(values), true).reshape(1, 3);
  };
  const auto deviation = [&](int size) {
    cv::Mat mean;
    cv::Mat squares;
    cv::boxFilter(image, mean, CV_64F, {size, size}, {-1, -1}, true, cv::BORDER_REPLICATE);
    cv::boxFilter(image.mul(image), squares, CV_64F, {size, size}, {-1, -1}, true, cv::BORDER_REPLICATE);
    cv::Mat result;
    cv::sqrt(cv::max(squares - mean.mul(mean), 0.0), result);
    return result;
  };
  CHECK(largest_difference(measured("Std dev 7×7", plane), deviation(7)) < 1e-6);
  CHECK(largest_difference(measured("Std dev 3×3", plane), deviation(3)) < 1e-5);
  cv::Mat x;
  cv::Mat y;
  cv::Sobel(image, x, CV_64F, 1, 0, 3, 1, 0, cv::BORDER_REPLICATE);
  cv::Sobel(image, y, CV_64F, 0, 1, 3, 1, 0, cv::BORDER_REPLICATE);
  CHECK(largest_difference(measured("Sobel", plane), cv::abs(x) + cv::abs(y)) < 1e-9);
  const cv::Mat prewitt = kernel({1, 0, -1, 1, 0, -1, 1, 0, -1});
  CHECK(largest_difference(measured("Prewitt", plane), cv::abs(filtered(prewitt)) + cv::abs(filtered(prewitt.t()))) <
        1e-9);
  // The diagonals of the 2×2 pixels up and left of the middle.
  CHECK(largest_difference(measured("Roberts", plane), cv::abs(filtered(kernel({1, 0, 0, 0, -1, 0, 0, 0, 0}))) +
                                                           cv::abs(filtered(kernel({0, 1, 0, -1, 0, 0, 0, 0, 0})))) <
        1e-9);
  cv::Mat laplace;
  cv::Laplacian(image, laplace, CV_64F, 1, 1, 0, cv::BORDER_REPLICATE);
  CHECK(largest_difference(measured("Laplace", plane), cv::abs(laplace)) < 1e-9);
  const auto largest_of = [&](std::initializer_list<std::initializer_list<double>> kernels) {
    cv::Mat result;
    for (const auto& values : kernels) {
      for (int turns = 0; turns < 4; ++turns) {
        cv::Mat turned = kernel(values);
        for (int i = 0; i < turns; ++i) cv::rotate(turned, turned, cv::ROTATE_90_CLOCKWISE);
        result = result.empty() ? filtered(turned) : cv::Mat(cv::max(result, filtered(turned)));
      }
    }
    return result;
  };
  CHECK(largest_difference(measured("Kirsch compass", plane),
                           largest_of({{5, 5, 5, -3, 0, -3, -3, -3, -3}, {5, 5, -3, 5, 0, -3, -3, -3, -3}})) < 1e-9);
  CHECK(largest_difference(measured("Prewitt compass", plane),
                           largest_of({{1, 1, 1, 1, -2, 1, -1, -1, -1}, {1, 1, 1, 1, -2, -1, 1, -1, -1}})) < 1e-9);
}

TEST_CASE("directions of 8 bits and differences of 4 are the hardware's") {
  Plane left = noise(64, 40, 1);
  Plane right = noise(64, 40, 2);
  // Flat areas in either, and in both.
  for (int y = 0; y < 20; ++y) {
    for (int x = 10; x < 30; ++x) left.at(x, y) = 100;
    for (int x = 20; x < 40; ++x) right.at(x, y) = 90;
  }
  Pair pair(left, right);
  pair.set_kernel(5);
  const Plane ours = direction_resolution(8, 4)->compare(pair);
  const Plane theirs = criterion("hardware").compare(pair);
  int wrong = 0;
  for (int y = 4; y < 36; ++y) {
    for (int x = 4; x < 60; ++x) wrong += ours.at(x, y) != theirs.at(x, y) ? 1 : 0;
  }
  CHECK(wrong == 0);
}

TEST_CASE("a ramp's direction differs from a turned one's by what the bits can tell") {
  // Ramps of brightness in directions of 10° and 10° + turn.
  const auto ramp = [](double degrees) {
    Plane plane(24, 24);
    for (int y = 0; y < 24; ++y) {
      for (int x = 0; x < 24; ++x) {
        plane.at(x, y) = std::round(
            128 + 5 * ((x - 12) * std::cos(degrees * M_PI / 180) + (y - 12) * std::sin(degrees * M_PI / 180)));
      }
    }
    return plane;
  };
  const auto steps = [&](double turn, int before, int after) {
    const Plane left = ramp(10);
    const Plane right = ramp(10 + turn);
    Pair pair(left, right);
    pair.set_kernel(9);
    return direction_resolution(before, after)->compare(pair).at(12, 12) / 81;
  };
  CHECK(steps(60, 8, 7) == Approx(60 / 180.0 * 128).margin(2));
  CHECK(steps(-60, 8, 7) == Approx(60 / 180.0 * 128).margin(2));
  CHECK(steps(180, 8, 7) == Approx(127).margin(1));
  CHECK(steps(60, 8, 4) == Approx(5).margin(0.3));
  CHECK(steps(60, 8, 1) == 0);
  CHECK(steps(130, 8, 1) == 1);
  // Before differencing: 45° classes, so 60° is one or two of them.
  CHECK(steps(60, 3, 2) >= 1);
  CHECK(steps(60, 3, 2) <= 2);
  // In floating point as far as the ramps are straight in whole grey levels, across the turn's end too.
  const auto exact = [&](double from, double to) {
    const Plane left = ramp(from);
    const Plane right = ramp(to);
    Pair pair(left, right);
    pair.set_kernel(9);
    return direction_in_floating_point()->compare(pair).at(12, 12) / 81;
  };
  CHECK(exact(10, 70) == Approx(60 / 360.0 * 256).margin(0.7));
  CHECK(exact(-20, 40) == Approx(60 / 360.0 * 256).margin(0.7));
  CHECK(exact(0, 26) == Approx(26 / 360.0 * 256).margin(0.7));
  CHECK(exact(20, 200) == Approx(127).margin(0.7));
  CHECK(direction_resolution(5, 4)->worst(5) == 15 * 25);
  CHECK_THROWS_AS(direction_resolution(8, 8), std::invalid_argument);
  CHECK_THROWS_AS(direction_resolution(9, 4), std::invalid_argument);
}
