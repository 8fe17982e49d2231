// SPDX-License-Identifier: Apache-2.0
// The stage `objects` against OpenCV's connectedComponentsWithStats.
#include "stages/objects.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace horopter;

constexpr int kWidth = 640, kHeight = 480;
constexpr std::size_t kLabels = 32;
using Finder = stages::ObjectFinder<kWidth, kHeight, kLabels, 2>;

/// pixels, left, top, right, bottom, sum of columns, sum of rows
using Object = std::array<std::int64_t, 7>;

struct Found {
  std::vector<Object> objects;  // sorted
  bool alarm = false;
  bool overflow = false;
  int alarm_row = -1;
  int idle_beats = 0;
};

/// `picture`: 0, or occupied.
Found find(Finder& finder, const cv::Mat& picture, int limit) {
  Found found;
  const Finder::Config config{limit};
  const auto take = [&](const Finder::Out& out) {
    if (!out.ended) return;
    const Finder::Object& o = out.object;
    found.objects.push_back({static_cast<std::int64_t>(o.pixels.value()), o.left.value(), o.top.value(),
                             o.right.value(), o.bottom.value(), static_cast<std::int64_t>(o.columns.value()),
                             static_cast<std::int64_t>(o.rows.value())});
  };
  Finder::Out out;
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      Finder::In in;
      in.occupied = picture.at<std::uint8_t>(y, x) != 0;
      in.first = x == 0 && y == 0;
      in.last = x + 1 == picture.cols;
      out = finder.step(in, config);
      take(out);
      if (out.done) FAIL("done before the frame's end");
      if (out.alarm && found.alarm_row < 0) found.alarm_row = y;
    }
  }
  Finder::In idle;
  idle.idle = true;
  while (!out.done) {
    REQUIRE(++found.idle_beats < 10'000);
    out = finder.step(idle, config);
    take(out);
  }
  found.alarm = out.alarm;
  found.overflow = out.overflow;
  std::sort(found.objects.begin(), found.objects.end());
  return found;
}

std::vector<Object> expected(const cv::Mat& picture) {
  cv::Mat labels, stats, centroids;
  const int n = cv::connectedComponentsWithStats(picture, labels, stats, centroids, 8, CV_32S);
  std::vector<Object> objects(static_cast<std::size_t>(n - 1));
  for (int i = 1; i < n; ++i) {
    const auto of = [&](int what) { return stats.at<int>(i, what); };
    objects[static_cast<std::size_t>(i - 1)] = {of(cv::CC_STAT_AREA),
                                                of(cv::CC_STAT_LEFT),
                                                of(cv::CC_STAT_TOP),
                                                of(cv::CC_STAT_LEFT) + of(cv::CC_STAT_WIDTH) - 1,
                                                of(cv::CC_STAT_TOP) + of(cv::CC_STAT_HEIGHT) - 1,
                                                std::llround(centroids.at<double>(i, 0) * of(cv::CC_STAT_AREA)),
                                                std::llround(centroids.at<double>(i, 1) * of(cv::CC_STAT_AREA))};
  }
  std::sort(objects.begin(), objects.end());
  return objects;
}

/// Most runs in two rows that follow each other.
int most_runs(const cv::Mat& picture) {
  int most = 0, above = 0;
  for (int y = 0; y < picture.rows; ++y) {
    int runs = 0;
    for (int x = 0; x < picture.cols; ++x) {
      runs += picture.at<std::uint8_t>(y, x) != 0 && (x == 0 || picture.at<std::uint8_t>(y, x - 1) == 0) ? 1 : 0;
    }
    most = std::max(most, above + runs);
    above = runs;
  }
  return most;
}

cv::Mat blobs(std::mt19937& random, int width, int height) {
  const auto uniform = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
  cv::Mat noise(height, width, CV_8U), smooth;
  for (auto it = noise.begin<std::uint8_t>(); it != noise.end<std::uint8_t>(); ++it) {
    *it = static_cast<std::uint8_t>(uniform(0, 255));
  }
  const double sigma = uniform(4, 60) / 4.0;
  cv::GaussianBlur(noise, smooth, {}, sigma, sigma * uniform(1, 4) / 2.0);
  cv::normalize(smooth, smooth, 0, 255, cv::NORM_MINMAX);
  cv::Mat picture;
  cv::threshold(smooth, picture, uniform(80, 180), 255, cv::THRESH_BINARY);
  return picture;
}

void check(Finder& finder, const cv::Mat& picture) {
  const std::vector<Object> right = expected(picture);
  std::int64_t largest = 0;
  for (const Object& object : right) largest = std::max(largest, object[0]);
  const int limit = static_cast<int>(std::max<std::int64_t>(1, largest));
  const Found found = find(finder, picture, limit);
  REQUIRE(!found.overflow);
  REQUIRE(found.objects == right);
  CHECK(found.alarm == !right.empty());
  CHECK(!find(finder, picture, limit + 1).alarm);
}

TEST_CASE("objects: as OpenCV finds them, in random pictures", "[objects]") {
  std::mt19937 random(1);
  Finder finder;
  int fitting = 0, overflowing = 0;
  for (int n = 0; n < 150; ++n) {
    CAPTURE(n);
    const int width = std::uniform_int_distribution(64, kWidth)(random);
    const cv::Mat picture = blobs(random, width, std::uniform_int_distribution(16, 200)(random));
    const int runs = most_runs(picture);
    const Found found = find(finder, picture, 1);
    // A run is three events of 4 beats each, at most; a queue of 128 waits.
    if (runs <= static_cast<int>(kLabels) && runs * 12 <= width) CHECK(!found.overflow);
    if (runs > 2 * static_cast<int>(kLabels)) CHECK(found.overflow);
    if (found.overflow) {
      ++overflowing;
      continue;
    }
    ++fitting;
    check(finder, picture);
  }
  CHECK(fitting >= 60);
  CHECK(overflowing >= 10);
}

TEST_CASE("objects: as OpenCV finds them, in pictures made to be difficult", "[objects]") {
  Finder finder;
  const auto draw = [](int width, int height, auto&& inside) {
    cv::Mat picture(height, width, CV_8U);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) picture.at<std::uint8_t>(y, x) = inside(x, y) ? 255 : 0;
    }
    return picture;
  };
  const auto spiral = [](int x, int y) {
    const double dx = x - 320, dy = y - 240, turns = std::hypot(dx, dy) / 40 - std::atan2(dy, dx) / (2 * CV_PI);
    return turns - std::floor(turns) < 0.5;
  };
  check(finder, draw(kWidth, kHeight, [](int, int) { return false; }));
  check(finder, draw(kWidth, kHeight, [](int, int) { return true; }));
  check(finder, draw(kWidth, kHeight, [](int x, int y) { return x == 639 && y == 479; }));
  check(finder, draw(kWidth, kHeight, spiral));
  check(finder, draw(kWidth, kHeight, [&](int x, int y) { return !spiral(x, y); }));
  // Combs: teeth that join at the end, and that come apart; both, nested.
  check(finder, draw(kWidth, 60, [](int x, int y) { return x % 45 < 20 || y > 50; }));
  check(finder, draw(kWidth, 60, [](int x, int y) { return x % 45 < 20 || y < 5; }));
  check(finder, draw(kWidth, 200, [](int x, int y) { return std::max(std::abs(x - 320), y) / 20 % 2 == 0; }));
  check(finder, draw(kWidth, 200, [](int x, int y) { return std::max(std::abs(x - 320), 199 - y) / 20 % 2 == 0; }));
  // Corner to corner, and one pixel apart.
  check(finder, draw(kWidth, 200, [](int x, int y) { return (x / 50 + y / 50) % 2 == 0; }));
  check(finder, draw(kWidth, 200, [](int x, int y) { return x % 50 == 0 && y % 50 == 0; }));
  check(finder, draw(kWidth, 50, [](int x, int y) { return (x + y) % 50 == 0; }));
  check(finder, draw(kWidth, 50, [](int x, int y) { return (x - y + 50) % 50 == 0; }));
  check(finder, draw(kWidth, 50, [](int x, int y) { return x == 0 || x == 639 || y % 10 == 5; }));
}

TEST_CASE("objects: the alarm comes while the object is still in sight", "[objects]") {
  Finder finder;
  cv::Mat picture(200, kWidth, CV_8U, cv::Scalar(0));
  picture(cv::Rect(100, 20, 40, 150)) = 255;
  const Found found = find(finder, picture, 40 * 60);
  CHECK(found.alarm);
  CHECK(found.alarm_row >= 20 + 59);
  CHECK(found.alarm_row <= 20 + 60);
}

TEST_CASE("objects: what does not fit is said, and forgotten with the next frame", "[objects]") {
  Finder finder;
  cv::Mat comb(40, kWidth, CV_8U, cv::Scalar(0));
  for (int x = 0; x < kWidth; x += 8) comb(cv::Rect(x, 0, 4, 40)) = 255;
  CHECK(find(finder, comb, 1).overflow);
  cv::Mat one(40, kWidth, CV_8U, cv::Scalar(0));
  one(cv::Rect(30, 10, 20, 20)) = 255;
  check(finder, one);
}

}  // namespace
