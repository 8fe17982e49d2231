// SPDX-License-Identifier: Apache-2.0
// The stage `objects` against OpenCV's connectedComponentsWithStats, and against sums over its labels.
#include "stages/objects.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>
#include <utility>
#include <vector>

#include "horopter/hls/table_format.hpp"

namespace {

using namespace horopter;

constexpr int kWidth = 640, kHeight = 480;
constexpr std::size_t kLabels = 32;
using Finder = stages::ObjectFinder<kWidth, kHeight, kLabels, 2>;

/// pixels, left, top, right, bottom, sum of columns, sum of rows, area in 1/1024 mm², blind pixels
using Object = std::array<std::int64_t, 9>;

constexpr std::uint32_t kNever = 0xFFFFFFFF;

/// A frame as the stage gets it.
struct Picture {
  cv::Mat occupied;  // 0, or it is
  cv::Mat areas;     // codes, by blocks of 32×32; empty: not known
  cv::Mat blind;     // 0, or it is; empty: none is
  [[nodiscard]] std::uint8_t area_code(int x, int y) const {
    return areas.empty() ? std::uint8_t{hls::table::unknown_area} : areas.at<std::uint8_t>(y / 32, x / 32);
  }
  [[nodiscard]] bool is_blind(int x, int y) const { return !blind.empty() && blind.at<std::uint8_t>(y, x) != 0; }
};

struct Found {
  std::vector<Object> objects;  // sorted
  bool alarm = false;
  bool overflow = false;
  int alarm_row = -1;
  int idle_beats = 0;
};

Found find(Finder& finder, const Picture& whole, int limit, std::uint32_t area_limit = kNever) {
  Found found;
  const cv::Mat& picture = whole.occupied;
  const Finder::Config config{limit, area_limit};
  const auto take = [&](const Finder::Out& out) {
    if (!out.ended) return;
    const Finder::Object& o = out.object;
    found.objects.push_back({static_cast<std::int64_t>(o.pixels.value()), o.left.value(), o.top.value(),
                             o.right.value(), o.bottom.value(), static_cast<std::int64_t>(o.columns.value()),
                             static_cast<std::int64_t>(o.rows.value()), o.area.value(), o.blind.value()});
  };
  Finder::Out out;
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      Finder::In in;
      in.occupied = picture.at<std::uint8_t>(y, x) != 0;
      in.first = x == 0 && y == 0;
      in.last = x + 1 == picture.cols;
      in.area = whole.area_code(x, y);
      in.blind = in.occupied && whole.is_blind(x, y);
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

std::vector<Object> expected(const Picture& whole) {
  const cv::Mat& picture = whole.occupied;
  cv::Mat labels, stats, centroids;
  const int n = cv::connectedComponentsWithStats(picture, labels, stats, centroids, 8, CV_32S);
  std::vector<Object> objects(static_cast<std::size_t>(n - 1));
  std::vector<std::int64_t> areas(static_cast<std::size_t>(n)), blind(areas.size());
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      const auto label = static_cast<std::size_t>(labels.at<int>(y, x));
      const double mm2 = hls::table::decode_area(whole.area_code(x, y));
      areas[label] += std::min<std::int64_t>((1 << 20) - 1, static_cast<std::int64_t>(std::ceil(mm2 * 1024)));
      blind[label] += whole.is_blind(x, y) ? 1 : 0;
    }
  }
  for (int i = 1; i < n; ++i) {
    const auto of = [&](int what) { return stats.at<int>(i, what); };
    objects[static_cast<std::size_t>(i - 1)] = {of(cv::CC_STAT_AREA),
                                                of(cv::CC_STAT_LEFT),
                                                of(cv::CC_STAT_TOP),
                                                of(cv::CC_STAT_LEFT) + of(cv::CC_STAT_WIDTH) - 1,
                                                of(cv::CC_STAT_TOP) + of(cv::CC_STAT_HEIGHT) - 1,
                                                std::llround(centroids.at<double>(i, 0) * of(cv::CC_STAT_AREA)),
                                                std::llround(centroids.at<double>(i, 1) * of(cv::CC_STAT_AREA)),
                                                std::min<std::int64_t>(kNever, areas[static_cast<std::size_t>(i)]),
                                                blind[static_cast<std::size_t>(i)]};
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

/// Codes of some place of the range, and of all of it.
Picture with_areas(std::mt19937& random, const cv::Mat& occupied) {
  const auto uniform = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
  Picture picture{occupied, cv::Mat((occupied.rows + 31) / 32, (occupied.cols + 31) / 32, CV_8U),
                  cv::Mat(occupied.size(), CV_8U)};
  const int lowest = uniform(0, 240), highest = uniform(0, 2) == 0 ? 255 : lowest + 15;
  for (auto it = picture.areas.begin<std::uint8_t>(); it != picture.areas.end<std::uint8_t>(); ++it) {
    *it = static_cast<std::uint8_t>(uniform(lowest, highest));
  }
  for (auto it = picture.blind.begin<std::uint8_t>(); it != picture.blind.end<std::uint8_t>(); ++it) {
    *it = uniform(0, 3) == 0 ? 1 : 0;
  }
  return picture;
}

void check(Finder& finder, const Picture& picture) {
  const std::vector<Object> right = expected(picture);
  std::int64_t largest = 0;
  for (const Object& object : right) largest = std::max(largest, object[0]);
  const int limit = static_cast<int>(std::max<std::int64_t>(1, largest));
  const Found found = find(finder, picture, limit);
  REQUIRE(!found.overflow);
  REQUIRE(found.objects == right);
  CHECK(found.alarm == !right.empty());
  CHECK(!find(finder, picture, limit + 1).alarm);

  constexpr int kNoPixels = kWidth * kHeight + 1;
  std::int64_t largest_area = 0;
  for (const Object& object : right) largest_area = std::max(largest_area, object[7]);
  const auto by_area = [&](std::int64_t area) {
    return find(finder, picture, kNoPixels, static_cast<std::uint32_t>(area)).alarm;
  };
  if (largest_area < kNever) {
    CHECK(by_area(std::max<std::int64_t>(1, largest_area)) == !right.empty());
    CHECK(!by_area(largest_area + 1));
  } else {
    CHECK(by_area(kNever - 1));
    CHECK(!by_area(kNever));
  }
}
void check(Finder& finder, const cv::Mat& occupied) { check(finder, Picture{occupied, {}, {}}); }

TEST_CASE("objects: the area of every code, rounded up", "[objects]") {
  for (int code = 0; code < 256; ++code) {
    CAPTURE(code);
    const double steps = std::ceil(hls::table::decode_area(static_cast<std::uint8_t>(code)) * hls::area_steps_per_mm2);
    CHECK(hls::area_of(code).value() == std::min(steps, 1048575.0));
  }
}

TEST_CASE("objects: a sum of areas that is too large is the largest, in any order", "[objects]") {
  constexpr std::uint32_t kHalf = 0x80000000;
  const auto sum = [](std::uint32_t a, std::uint32_t b) { return hls::area_sum(a, b).value(); };
  CHECK(sum(kNever - 1, 1) == kNever);
  CHECK(sum(kNever - 2, 1) == kNever - 1);
  CHECK(sum(0xFFFF, 1) == 0x10000);
  CHECK(sum(kHalf, kHalf) == kNever);
  CHECK(sum(sum(kHalf, kHalf), 5) == kNever);
  CHECK(sum(kHalf, sum(kHalf, 5)) == kNever);
  CHECK(sum(kNever, kNever) == kNever);
}

TEST_CASE("objects: as OpenCV finds them, in random pictures", "[objects]") {
  std::mt19937 random(1);
  Finder finder;
  int fitting = 0, overflowing = 0, saturated = 0;
  for (int n = 0; n < 150; ++n) {
    CAPTURE(n);
    const int width = std::uniform_int_distribution(64, kWidth)(random);
    const cv::Mat picture = blobs(random, width, std::uniform_int_distribution(16, 200)(random));
    const int runs = most_runs(picture);
    const Found found = find(finder, {picture, {}, {}}, 1);
    // A run is three events of 4 beats each, at most; a queue of 128 waits.
    if (runs <= static_cast<int>(kLabels) && runs * 12 <= width) CHECK(!found.overflow);
    if (runs > 2 * static_cast<int>(kLabels)) CHECK(found.overflow);
    if (found.overflow) {
      ++overflowing;
      continue;
    }
    ++fitting;
    const Picture whole = with_areas(random, picture);
    for (const Object& object : expected(whole)) saturated += object[7] == kNever ? 1 : 0;
    check(finder, whole);
  }
  CHECK(fitting >= 60);
  CHECK(saturated >= 5);
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
  const cv::Mat areas(7, 20, CV_8U, cv::Scalar(8 * 13));  // 2 mm²
  const std::vector<Found> alarms{find(finder, {picture, areas, {}}, 40 * 60),
                                  find(finder, {picture, areas, {}}, 40 * 200, 40 * 60 * 2 * 1024)};
  for (const Found& found : alarms) {
    CHECK(found.alarm);
    CHECK(found.alarm_row >= 20 + 59);
    CHECK(found.alarm_row <= 20 + 60);
  }
}

TEST_CASE("objects: what does not fit is said, and forgotten with the next frame", "[objects]") {
  Finder finder;
  cv::Mat comb(40, kWidth, CV_8U, cv::Scalar(0));
  for (int x = 0; x < kWidth; x += 8) comb(cv::Rect(x, 0, 4, 40)) = 255;
  CHECK(find(finder, {comb, {}, {}}, 1).overflow);
  cv::Mat one(40, kWidth, CV_8U, cv::Scalar(0));
  one(cv::Rect(30, 10, 20, 20)) = 255;
  check(finder, one);
}

}  // namespace
