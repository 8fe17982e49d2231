// SPDX-License-Identifier: Apache-2.0
// The operators of 5.2: against OpenCV where it has them, against their definition where the thesis has its own.
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "horopter/calib/random.hpp"
#include "horopter/study/operators.hpp"

using namespace horopter;
using namespace horopter::study;

namespace {

Image noise(int width, int height, std::uint64_t seed, double share, int value = 1) {
  Image image(width, height);
  horopter::calib::Random random(seed);
  for (auto& pixel : image.pixels) pixel = static_cast<std::uint8_t>(random.uniform() < share ? value : 0);
  return image;
}

Image grey(int width, int height, std::uint64_t seed) {
  Image image(width, height);
  horopter::calib::Random random(seed);
  for (auto& pixel : image.pixels) pixel = static_cast<std::uint8_t>(random.next() >> 56);
  return image;
}

cv::Mat view(const Image& image) {
  return {image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.pixels.data())};
}

bool equal(const Image& ours, const cv::Mat& theirs) { return cv::countNonZero(view(ours) != theirs) == 0; }

Image scattered(int width, int height, std::uint64_t seed) {
  Image image(width, height);
  horopter::calib::Random random(seed);
  for (int i = 0; i < 40; ++i) {
    const int size = 1 + static_cast<int>(random.uniform() * 6);
    const int x = static_cast<int>(random.uniform() * width);
    const int y = static_cast<int>(random.uniform() * height);
    for (int v = y; v < std::min(height, y + size); ++v) {
      for (int u = x; u < std::min(width, x + size); ++u) image.at(u, v) = random.uniform() < 0.8 ? 1 : 0;
    }
  }
  return image;
}

}  // namespace

TEST_CASE("dilation, erosion, opening and closing are OpenCV's") {
  for (const auto& [width, height] : {std::pair{61, 47}, std::pair{5, 40}, std::pair{3, 2}}) {
    for (int k = 1; k <= 4; ++k) {
      const Image images[] = {grey(width, height, 1), noise(width, height, 2, 0.2)};
      for (const Image& image : images) {
        const cv::Mat window = cv::Mat::ones(2 * k + 1, 2 * k + 1, CV_8U);
        const auto theirs = [&](int operation) {
          cv::Mat result;
          cv::morphologyEx(view(image), result, operation, window);
          return result;
        };
        CAPTURE(width, height, k);
        CHECK(equal(dilation(image, k), theirs(cv::MORPH_DILATE)));
        CHECK(equal(erosion(image, k), theirs(cv::MORPH_ERODE)));
        CHECK(equal(opening(image, k), theirs(cv::MORPH_OPEN)));
        CHECK(equal(closing(image, k), theirs(cv::MORPH_CLOSE)));
      }
    }
  }
  CHECK_THROWS_AS(dilation(grey(4, 4, 1), 0), std::invalid_argument);
}

TEST_CASE("the majority of a binary image is OpenCV's median") {
  for (const double share : {0.1, 0.5, 0.8}) {
    for (int k = 1; k <= 4; ++k) {
      const Image image = noise(73, 41, 5, share);
      cv::Mat theirs;
      // OpenCV's medians above 5×5 are of 8 bits, too.
      cv::medianBlur(view(image), theirs, 2 * k + 1);
      CAPTURE(share, k);
      CHECK(equal(majority(image, k), theirs));
    }
  }
}

TEST_CASE("hysteresis takes OpenCV's components that hold a high value") {
  Plane values(90, 60);
  horopter::calib::Random random(9);
  for (double& value : values.values) value = random.uniform();
  values.at(3, 4) = std::nan("");
  const Image ours = hysteresis(values, 0.55, 0.97);
  cv::Mat weak(60, 90, CV_8U);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 90; ++x) weak.at<std::uint8_t>(y, x) = values.at(x, y) >= 0.55 ? 1 : 0;
  }
  cv::Mat labels;
  const int count = cv::connectedComponents(weak, labels, 8);
  std::vector<bool> strong(static_cast<std::size_t>(count));
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 90; ++x) {
      if (values.at(x, y) >= 0.97) strong[static_cast<std::size_t>(labels.at<int>(y, x))] = true;
    }
  }
  int taken = 0;
  int wrong = 0;
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 90; ++x) {
      const bool theirs = weak.at<std::uint8_t>(y, x) != 0 && strong[static_cast<std::size_t>(labels.at<int>(y, x))];
      wrong += theirs != (ours.at(x, y) == 1) ? 1 : 0;
      taken += theirs ? 1 : 0;
    }
  }
  CHECK(wrong == 0);
  CHECK(taken > 100);
  CHECK(taken < cv::countNonZero(weak));
  Image plain(90, 60);
  for (std::size_t i = 0; i < values.values.size(); ++i) plain.pixels[i] = values.values[i] >= 0.97 ? 1 : 0;
  CHECK(hysteresis(values, 0.97, 0.97) == plain);
  CHECK_THROWS_AS(hysteresis(values, 0.9, 0.8), std::invalid_argument);
}

TEST_CASE("clusterlets are eliminated as 5.3 says, and no others") {
  const int width = 70;
  const int height = 50;
  for (const int value : {0, 1}) {
    for (int e = 1; e <= 4; ++e) {
      Image image = scattered(width, height, 13);
      if (value == 1) {
        for (auto& pixel : image.pixels) pixel = 1 - pixel;
      }
      const Image ours = eliminate_clusterlets(image, e, value);
      // Pixel by pixel: is there a window with a border of this value, and this pixel inside?
      const auto at = [&](int x, int y) {
        return image.at(std::min(std::max(x, 0), width - 1), std::min(std::max(y, 0), height - 1));
      };
      int wrong = 0;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          bool inside = false;
          for (int v = std::max(0, y - e + 1); v <= std::min(height - 1, y + e - 1); ++v) {
            for (int u = std::max(0, x - e + 1); u <= std::min(width - 1, x + e - 1); ++u) {
              bool border = true;
              for (int j = -e; j <= e; ++j) {
                for (int i = -e; i <= e; ++i) {
                  if (std::max(std::abs(i), std::abs(j)) == e) border = border && at(u + i, v + j) == value;
                }
              }
              inside = inside || border;
            }
          }
          wrong += ours.at(x, y) != (inside ? value : image.at(x, y)) ? 1 : 0;
        }
      }
      CAPTURE(value, e);
      CHECK(wrong == 0);
      if (value == 1) continue;
      // Clusters, by OpenCV: one that stands alone goes when it fits into (2e−1)², and what goes fits.
      cv::Mat labels;
      cv::Mat stats;
      cv::Mat centres;
      const int count = cv::connectedComponentsWithStats(view(image), labels, stats, centres, 8);
      std::vector<int> left(static_cast<std::size_t>(count));
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) left[static_cast<std::size_t>(labels.at<int>(y, x))] += ours.at(x, y);
      }
      for (int i = 1; i < count; ++i) {
        const bool fits =
            std::max(stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT)) <= 2 * e - 1;
        if (!fits) CHECK(left[static_cast<std::size_t>(i)] == stats.at<int>(i, cv::CC_STAT_AREA));
      }
    }
  }
  Image lonely(20, 20);
  for (int y = 8; y < 11; ++y) {
    for (int x = 8; x < 11; ++x) lonely.at(x, y) = 1;
  }
  CHECK(eliminate_clusterlets(lonely, 1, 0) == lonely);
  CHECK(eliminate_clusterlets(lonely, 2, 0) == Image(20, 20));
}
