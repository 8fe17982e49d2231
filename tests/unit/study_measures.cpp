// SPDX-License-Identifier: Apache-2.0
// The measures of 8.4.2 on distributions whose measures are known, and the run over a series.
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "horopter/calib/random.hpp"
#include "horopter/study/filters.hpp"
#include "horopter/study/measures.hpp"
#include "horopter/study/series.hpp"

using namespace horopter;
using namespace horopter::study;

namespace {

/// Values a·d + b·u with u evenly spread over 0 … 1.
Histogram even(double from, double width) {
  Plane plane(400, 250);
  const auto count = static_cast<double>(plane.values.size());
  for (std::size_t i = 0; i < plane.values.size(); ++i)
    plane.values[i] = from + width * (static_cast<double>(i) + 0.5) / count;
  return Histogram(plane, 0, 0);
}

}  // namespace

TEST_CASE("a histogram knows shares, quantiles, mean and deviation") {
  const Histogram histogram = even(3, 10);
  CHECK(histogram.mean() == Approx(8));
  CHECK(histogram.deviation() == Approx(10 / std::sqrt(12)).epsilon(1e-4));
  for (const double share : {0.03, 0.25, 0.5, 0.9}) {
    CHECK(histogram.quantile(share) == Approx(3 + 10 * share).epsilon(1e-3));
    CHECK(histogram.share(3 + 10 * share) == Approx(share).margin(1e-3));
    CHECK(histogram.share(histogram.quantile(share)) == Approx(share).margin(1e-9));
  }
  CHECK(histogram.share(2.9) == 0);
  CHECK(histogram.share(13.1) == 1);
  CHECK(even(1e-9, 1e-9).share(1) == 1);

  Plane undefined(10, 10, std::numeric_limits<double>::infinity());
  undefined.at(2, 3) = 5;
  const Histogram mostly(undefined, 0, 0);
  CHECK(mostly.share(1e9) == Approx(0.01));
  CHECK(mostly.mean() == 5);
  CHECK_THROWS_AS(Histogram(undefined, 0, 5), std::invalid_argument);

  // From the best value on, borders left out.
  Plane similar(30, 30, 0.75);
  for (const auto& [x, y] : {std::pair{1, 1}, {15, 1}, {1, 15}, {28, 15}, {15, 28}}) similar.at(x, y) = 0;
  CHECK(Histogram(similar, 1, 2).mean() == Approx(0.25));
}

TEST_CASE("a detection rate that falls linearly has the error of 8.9 and 16/5 of it as 10/90 disparity") {
  // Values d + u: with the threshold of D50 the rate at d is 1.0 + D50 − 0.5 − d within 0 … 1, 1 px wide.
  std::vector<double> disparities;
  std::vector<Histogram> histograms;
  for (int i = -5; i <= 80; ++i) {
    disparities.push_back(0.05 * i);
    histograms.push_back(even(0.05 * std::abs(i), 1));
  }
  const Detection detection(disparities, histograms);
  CHECK(detection.threshold(1.2) == Approx(1.7).epsilon(1e-3));
  CHECK(detection.rate(1.7, 1.2) == Approx(0.5).margin(2e-3));
  CHECK(detection.rate(1.7, 0.9) == Approx(0.8).margin(2e-3));
  CHECK(detection.segmentation_error(1.2) == Approx(0.25).margin(2e-3));
  REQUIRE(detection.ten_ninety_px(1.2));
  CHECK(*detection.ten_ninety_px(1.2) == Approx(0.8).margin(3e-3));
  CHECK(*detection.ten_ninety_px(1.2) / detection.segmentation_error(1.2) == Approx(16 / 5.0).epsilon(0.01));
  CHECK(*detection.disparity_at(1.7, 0.95) == Approx(0.75).margin(3e-3));
  CHECK(detection.slope_over_deviation(1) == Approx(std::sqrt(12)).epsilon(0.01));
  // Cut off at the largest disparity.
  CHECK(detection.segmentation_error(2.8) == Approx(0.125).margin(2e-3));
  CHECK(detection.smallest_error(1, 2) == Approx(0.25).margin(3e-3));
  // 0.3 px: at 0 only 80 % are found.
  CHECK_FALSE(detection.ten_ninety_px(0.3));
  CHECK(detection.segmentation_error(0.3) == Approx(0.125 + 0.3 * 0.35).margin(3e-3));
  CHECK_THROWS_AS(Detection({1, 1}, {even(0, 1), even(0, 1)}), std::invalid_argument);
}

TEST_CASE("a series: every setting on every image, the same on every run") {
  Conditions conditions;
  conditions.camera.width = 96;
  conditions.camera.height = 80;
  const Simulation simulation(conditions, 3);
  const std::vector<Setting> settings{{&criterion("DSAD"), {Feature::direction, true}, 9},
                                      {&criterion("DSAD"), {Feature::direction, true}, 9, ResultFilter::median},
                                      {&criterion("hardware"), {Feature::camera}, 9},
                                      {&criterion("NISH"), {Feature::log_sign, false, false, 4}, 5},
                                      {&criterion("ZNCC"), {Feature::grey, true, true}, 7}};
  CHECK(name_of(settings[1]) == "DSAD LP 9×9 median");
  CHECK(name_of(settings[2]) == "hardware 9×9");
  CHECK(name_of(settings[4]) == "ZNCC LP+HP 7×7");
  const std::vector<double> disparities{0, 0.5, 1, 2, 2.8};
  const auto once = detect(photographs(simulation, disparities), settings);
  const auto again = detect(photographs(simulation, disparities), settings);
  REQUIRE(once.size() == settings.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    CAPTURE(name_of(settings[i]));
    for (std::size_t d = 1; d < disparities.size(); ++d)
      CHECK(once[i].histograms()[d].mean() > once[i].histograms()[d - 1].mean());
    for (const double d50 : {0.5, 1.5}) CHECK(once[i].segmentation_error(d50) == again[i].segmentation_error(d50));
    CHECK(once[i].rate(once[i].threshold(1), 1) == Approx(0.5).margin(1e-6));
  }
  // The hardware's sum of 15 steps is the floating one's degrees, cut down to steps of 11.25°.
  const double degrees = once[0].threshold(1) / 180;
  const double steps = once[2].threshold(1) / 16;
  CHECK(steps < degrees);
  CHECK(steps > degrees - 0.06 * 81);

  // Each image has noise of its own, and shows what lies its disparity further along the lines.
  const ImageSeries series = photographs(simulation, disparities);
  CHECK_FALSE(series.image(0) == series.reference);
  const Plane moved = simulation.exact(2);
  double off = 0;
  const Image image = series.image(3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) off += std::abs(image.pixels[i] - moved.values[i]);
  CHECK(off / static_cast<double>(image.pixels.size()) < 1);

  // The filter of a result is the one asked for, and what it reaches beyond the image does not count.
  const auto plane_of = [&](const Image& one) { return prepare(one, settings[0].preparation); };
  const Plane r = plane_of(series.reference);
  const Plane s = plane_of(image);
  Pair pair(r, s);
  const Plane plain = settings[0].criterion->compare(pair);
  constexpr int kMargin = 4 + 2 + 1;  // window, Sobel and low-pass, filter
  for (const auto& [filter, filtered] : {std::pair{ResultFilter::none, plain},
                                         {ResultFilter::lowpass, lowpass(plain)},
                                         {ResultFilter::median, median(plain)}}) {
    Setting setting = settings[0];
    setting.filter = filter;
    CAPTURE(name_of(filter));
    CHECK(reach_of(setting) == kMargin - (filter == ResultFilter::none ? 1 : 0));
    CHECK(detect(series, {setting}).front().histograms()[3].mean() == Histogram(filtered, 0, reach_of(setting)).mean());
  }
  CHECK(reach_of({&criterion("hardware"), {Feature::camera}, 9}) == 4 + 2);
  CHECK(reach_of({&criterion("NISH"), {Feature::log_sign, false, false, 4}, 5}) == 2 + 6);
  CHECK(reach_of({&criterion("ZNCC"), {Feature::grey, true, true}, 7}) == 3 + 2);

  ImageSeries other = photographs(simulation, disparities);
  other.image = [](std::size_t) { return Image(5, 5); };
  CHECK_THROWS_WITH(detect(other, settings), Catch::Contains("5×5"));
}
