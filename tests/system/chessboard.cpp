// SPDX-License-Identifier: Apache-2.0
// Real image pairs of a chessboard (opencv-doc): the skin laid on the board must find it, a displaced one must not.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "stages/engine.hpp"

using namespace horopter;

namespace {

const std::string kFolder = "/usr/share/doc/opencv-doc/examples/data/";

std::vector<cv::Point2f> corners_of(const cv::Mat& image) {
  std::vector<cv::Point2f> corners;
  REQUIRE(cv::findChessboardCorners(image, {9, 6}, corners));
  cv::cornerSubPix(image, corners, {11, 11}, {-1, -1}, {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 30, 0.01});
  return corners;
}

/// Table with a control point for every pixel; the source of (x, y) is H (x, y) + (displacement, 0).
std::vector<std::uint32_t> dense_table(const cv::Matx33d& homography, double displacement, int width, int height) {
  return hls::table::write({width, height, 0, 0}, {}, [&](int column, int row) {
    const cv::Vec3d p = homography * cv::Vec3d(column, row, 1);
    return hls::table::encode_control(p[0] / p[2] + displacement, p[1] / p[2]);
  });
}

struct Shares {
  double decidable = 0;  // of the board's pixels
  double skin = 0;       // of the decidable ones
};

Shares shares_in(const native::FrameResult& result, const cv::Mat& region) {
  double pixels = 0;
  double decidable = 0;
  double skin = 0;
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      if (region.at<std::uint8_t>(y, x) == 0) continue;
      const int state = result.states[static_cast<std::size_t>(y * result.width + x)];
      pixels += 1;
      decidable += state <= stages::state::skin;
      skin += state == stages::state::skin;
    }
  }
  return {decidable / pixels, skin / decidable};
}

}  // namespace

TEST_CASE("the skin on a chessboard finds it, the displaced skin does not", "[system]") {
  if (!std::filesystem::exists(kFolder + "left01.jpg")) {
    WARN("opencv-doc is not installed: nothing tested");
    return;
  }
  const auto engine = native::make_engine("vga");
  auto settings = native::Settings::defaults(engine->profile(), 640, 480).without_proof();
  settings.object_limit = 3'927;  // that of `horopter run`
  const double displacements[] = {0, 16, -16};
  Shares sum[3];
  int alarms[3] = {};
  double least_on = 1;
  double most_off = 0;
  int pairs = 0;
  for (int number = 1; number <= 14; ++number) {
    if (number == 10) continue;  // there is none
    char name[8];
    std::snprintf(name, sizeof name, "%02d.jpg", number);
    const cv::Mat left = cv::imread(kFolder + "left" + name, cv::IMREAD_GRAYSCALE);
    const cv::Mat right = cv::imread(kFolder + "right" + name, cv::IMREAD_GRAYSCALE);
    REQUIRE(left.size() == cv::Size(640, 480));
    const auto left_corners = corners_of(left);
    const cv::Matx33d homography = cv::findHomography(left_corners, corners_of(right));
    std::vector<cv::Point2f> hull;
    cv::convexHull(left_corners, hull);
    std::vector<cv::Point> polygon;
    for (const auto& p : hull) polygon.emplace_back(cvRound(p.x), cvRound(p.y));
    cv::Mat region = cv::Mat::zeros(left.size(), CV_8U);
    cv::fillConvexPoly(region, polygon, 1);

    const auto view = [](const cv::Mat& m) {
      return native::ImageView{m.data, m.cols, m.rows, static_cast<std::ptrdiff_t>(m.step)};
    };
    for (int i = 0; i < 3; ++i) {
      const auto words = dense_table(homography, displacements[i], 640, 480);
      const auto result = engine->process(view(left), view(right), native::TableView(words), settings);
      const Shares shares = shares_in(result, region);
      const double share = result.skin_pixels / (640.0 * 480.0);
      std::printf("pair %2d, %+3.0f px: decidable %.3f, of these skin %.3f, skin in the frame %5.2f %%%s, misses %d\n",
                  number, displacements[i], shares.decidable, shares.skin, 100 * share, result.alarm ? " ALARM" : "",
                  static_cast<int>(result.store_misses));
      sum[i].decidable += shares.decidable;
      sum[i].skin += shares.skin;
      alarms[i] += result.alarm;
      if (i == 0) {
        least_on = std::min(least_on, share);
      } else {
        most_off = std::max(most_off, share);
      }
      CHECK(result.store_misses == 0);
    }
    ++pairs;
  }
  std::printf(
      "mean: decidable %.3f, skin %.3f, displaced %.3f and %.3f; skin in the frame at least %.2f %%, displaced at most "
      "%.2f %%\n",
      sum[0].decidable / pairs, sum[0].skin / pairs, sum[1].skin / pairs, sum[2].skin / pairs, 100 * least_on,
      100 * most_off);
  REQUIRE(pairs == 13);
  CHECK(sum[0].decidable / pairs >= 0.33);
  CHECK(sum[0].skin / pairs >= 0.90);
  CHECK(sum[1].skin / pairs <= 0.12);
  CHECK(sum[2].skin / pairs <= 0.12);
  CHECK(alarms[0] == 13);
  CHECK(alarms[1] + alarms[2] <= 2);
}
