// SPDX-License-Identifier: Apache-2.0
// Small pairs with a block on a skin, and cameras, for tests of the program from outside.
#pragma once

#include <catch2/catch.hpp>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "rig_text.hpp"
#include "sandbox.hpp"

namespace horopter::test {

/// Smoothed noise, so that directions mean something.
inline cv::Mat textured(int width, int height, std::uint64_t seed) {
  cv::Mat image(height, width, CV_8UC1);
  cv::RNG random(seed);
  random.fill(image, cv::RNG::UNIFORM, 20, 236);
  cv::GaussianBlur(image, image, {5, 5}, 1.0);
  return image;
}

inline void save(const std::string& file, const cv::Mat& image) {
  CAPTURE(file);
  REQUIRE(cv::imwrite(file, image));
}

/// The right image in which a block of the left one appears on the skin, displaced by (dx, dy); the rest lies
/// elsewhere.
inline cv::Mat right_of(const cv::Mat& left, cv::Rect block, int dx, int dy) {
  cv::Mat right = textured(left.cols, left.rows, 4711);
  left(block).copyTo(right(block + cv::Point(dx, dy)));
  return right;
}

inline constexpr const char* kSkin =
    "surface:\n  type: homography\n  matrix:\n    - [1, 0, -10]\n    - [0, 1, 4]\n    - [0, 0, 1]\n";
inline const cv::Rect kBlock(60, 30, 70, 50);

/// Pairs left0.png, right0.png, … of 200x120 pixels with a block on the skin, and the skin.
inline Sandbox& with_pairs(Sandbox& box, int pairs = 1) {
  box.write("skin.yaml", kSkin);
  for (int i = 0; i < pairs; ++i) {
    const cv::Mat left = textured(200, 120, static_cast<std::uint64_t>(i) + 1);
    save((box / ("left" + std::to_string(i) + ".png")).string(), left);
    save((box / ("right" + std::to_string(i) + ".png")).string(), right_of(left, kBlock, -10, 4));
  }
  return box;
}

inline std::vector<std::string> run_arguments(const std::string& left = "left0.png",
                                              const std::string& right = "right0.png",
                                              const std::string& skin = "skin.yaml") {
  return {"run", "--left", left, "--right", right, "--skin", skin, "--out", "out"};
}

/// Two cameras for pairs of 200x120 pixels, the right one 50 mm to the right and some lower.
inline std::string rig_text(const std::string& lower_mm = "0", const std::string& distortion = "{}") {
  return two_cameras(200, 120, 200, "-50, -" + lower_mm + ", 0", {distortion, distortion});
}

}  // namespace horopter::test
