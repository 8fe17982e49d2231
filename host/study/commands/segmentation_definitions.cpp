// SPDX-License-Identifier: Apache-2.0
// What 8.4.2 says about means, deviations and histograms of the criteria, and about the measures made of them.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "segmentation_measures.hpp"

namespace horopter::cli {
namespace {

using namespace measured;
using study::Detection;
using study::Histogram;
using enum Prefilter;

/// Of a normal distribution with the histogram's mean and deviation: the share of values up to one.
double normal_share(const Histogram& histogram, double value) {
  const double deviation = std::max(1e-12, histogram.deviation());
  return 0.5 * std::erfc((histogram.mean() - value) / (deviation * std::numbers::sqrt2));
}

/// Eq. 8.9 with the detection rates of normal distributions (8.8) of the measured means and deviations.
double gaussian_error(const Detection& detection, double d50_px) {
  const auto& places = detection.disparities_px();
  double threshold = detection.histograms().front().mean();
  for (std::size_t i = 1; i < places.size(); ++i)
    if (places[i] <= d50_px + 1e-9) threshold = detection.histograms()[i].mean();
  double error = 0;
  for (std::size_t i = 1; i < places.size() && places[i] <= Detection::kLargest_px + 1e-9; ++i) {
    const double mean =
        (normal_share(detection.histograms()[i - 1], threshold) + normal_share(detection.histograms()[i], threshold)) /
        2;
    error += (places[i] - places[i - 1]) * (places[i] <= d50_px + 1e-9 ? 1 - mean : mean);
  }
  return error;
}

/// Largest difference of two cumulative distributions, the histogram's and the normal one; the mean over disparities
/// from 0.4 to 2 px.
double from_normal(const Detection& detection) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < detection.disparities_px().size(); ++i) {
    if (detection.disparities_px()[i] < 0.4 - 1e-9 || detection.disparities_px()[i] > 2 + 1e-9) continue;
    const Histogram& histogram = detection.histograms()[i];
    double furthest = 0;
    for (int z = -30; z <= 30; ++z) {
      const double value = histogram.mean() + 0.1 * z * histogram.deviation();
      furthest = std::max(furthest, std::abs(histogram.share(value) - normal_share(histogram, value)));
    }
    sum += furthest;
    ++count;
  }
  return sum / count;
}

/// Means, or deviations, over the disparity from one place to another.
Points curve(const Detection& detection, double from_px, double to_px, double (Histogram::*value)() const) {
  Points points;
  for (std::size_t i = 0; i < detection.disparities_px().size(); ++i) {
    const double d = detection.disparities_px()[i];
    if (d >= from_px - 1e-9 && d <= to_px + 1e-9) points.emplace_back(d, (detection.histograms()[i].*value)());
  }
  return points;
}

/// Whether the mean rises in a straight line over half a pixel that begins at `latest_px` or before.
bool rises_straight(const Detection& detection, double latest_px) {
  constexpr double kLength_px = 0.6;
  constexpr double kStraight = 0.03;
  for (const double from : detection.disparities_px()) {
    if (from < 0 || from > latest_px + 1e-9) continue;
    if (departure_from_line(curve(detection, from, from + kLength_px, &Histogram::mean)) <= kStraight) return true;
  }
  return false;
}

/// Slopes of the mean over 0.4 px, from 0.2 px on: the least in percent of the steepest.
double least_slope_percent(const Detection& detection) {
  double least = INFINITY;
  double steepest = 0;
  for (const double from : detection.disparities_px()) {
    const Points part = curve(detection, from, from + 0.4, &Histogram::mean);
    if (from < 0.2 - 1e-9 || part.back().first - from < 0.4 - 1e-9) continue;
    const double slope = (part.back().second - part.front().second) / 0.4;
    least = std::min(least, slope);
    steepest = std::max(steepest, slope);
  }
  return 100 * least / steepest;
}

/// Change of the rate about D50, per px.
double rate_gradient(const Detection& detection, double d50_px) {
  const double threshold = detection.threshold(d50_px);
  return (detection.rate(threshold, d50_px - 0.1) - detection.rate(threshold, d50_px + 0.1)) / 0.2;
}

/// Thresholds with D50 = 0.2 … 2.0 px that take the detection rate from all to nothing.
int sharp_thresholds(const Detection& detection) {
  int sharp = 0;
  for (int i = 2; i <= 20; ++i) {
    const double threshold = detection.threshold(i / 10.0);
    if (detection.rate(threshold, 0) >= 0.99 && detection.rate(threshold, Detection::kLargest_px) <= 0.01) ++sharp;
  }
  return sharp;
}

/// How far the detection rate from 98 to 2 % is from a straight line, as a share of its fall.
double from_straight(const Detection& detection, double threshold) {
  Points part;
  const std::vector<double> rates = detection.rates(threshold);
  for (std::size_t i = 0; i < rates.size(); ++i)
    if (detection.disparities_px()[i] >= 0 && rates[i] <= 0.98 && rates[i] >= 0.02)
      part.emplace_back(detection.disparities_px()[i], rates[i]);
  return part.size() >= 3 ? departure_from_line(part) : INFINITY;
}

/// Its detection rate with D50 = 1 px falls in a straight line from 0.5 to 1.5 px.
Detection straight_detection() {
  constexpr int kValues = 4000;
  std::vector<double> disparities;
  std::vector<Histogram> histograms;
  for (int i = 0; i <= 70; ++i) {
    disparities.push_back(0.04 * i);
    study::Plane values(kValues, 1);
    for (int k = 0; k < kValues; ++k) values.at(k, 0) = disparities.back() + (k + 0.5) / kValues;
    histograms.emplace_back(values, 0.0, 0);
  }
  return {std::move(disparities), std::move(histograms)};
}

Table means(const Measures& of) {
  int near = 0;
  int nearest = 0;
  int count = 0;
  std::string curved;
  const auto judge = [&](const std::string& name, const Detection& one) {
    ++count;
    nearest += rises_straight(one, 0.1) ? 1 : 0;
    if (rises_straight(one, 0.5)) {
      ++near;
    } else if (curved.size() < 60) {
      curved += (curved.empty() ? "" : ", ") + name;
    }
  };
  for (const std::string& name : kGreyCriteria) {
    judge(name, of.found.of(name, none));
    judge(name + " HP", of.found.of(name, highpass));
  }
  judge("DSAD", of.dsad());
  judge("NISH", of.found.nish(5));
  return {
      {"For all methods the mean correlation value linearly increases with disparity in a range near zero disparity. "
       "The size of this range depends on the method and prefiltering.",
       {near, count, nearest, curved.empty() ? "none" : curved},
       "In {} of {} methods; in {} the range begins at 0.1 px or before. Not in: {}",
       "A range of 0.6 px that begins at 0.5 px or before, in which the mean is within 3 % of its rise of a line; "
       "partly: in half of them",
       {first >= second, 2 * first >= second},
       "the means of all criteria rise linearly with small disparities"}};
}

Table errors(const Measures& of) {
  const double curvature = 100 * departure_from_line(curve(of.dsad(), 0.2, 3, &Histogram::deviation));
  const auto products = range_of({0.4, 0.6, 0.8, 1.0, 1.2, 1.4}, [&](double d50) {
    return rate_gradient(of.dsad(), d50) * of.dsad().segmentation_error(d50);
  });
  const Detection straight = straight_detection();
  double departure = INFINITY;
  double measured_ratio = 0;
  std::vector<double> capability;
  std::vector<double> error;
  for (const auto& [setting, detection] : of.found.all()) {
    if (setting.kernel != 9 || setting.filter != study::ResultFilter::none) continue;
    capability.push_back(detection.slope_over_deviation(1));
    error.push_back(detection.segmentation_error(1));
    for (const double d50 : {0.6, 0.8, 1.0, 1.2, 1.4}) {
      const auto ten_ninety = detection.ten_ninety_px(d50);
      if (!ten_ninety || from_straight(detection, detection.threshold(d50)) >= departure) continue;
      departure = from_straight(detection, detection.threshold(d50));
      measured_ratio = *ten_ninety / detection.segmentation_error(d50);
    }
  }
  return {
      {"NSAD on high-pass filtered images: the minimal segmentation-error is very high (> 0.15).",
       {of.nsad().smallest_error(0.2)},
       "{:.3f} px",
       "Above 0.15 px for every D50 from 0.2 px on; partly: above 0.1",
       {first > 0.15, first > 0.1}},
      {"NSAD on high-pass filtered images: there is no threshold where the detection-rate goes from 100 % to 0 %.",
       {sharp_thresholds(of.nsad())},
       "{} of 19 thresholds (D50 = 0.2 … 2.0 px) do",
       "None has 99 % at 0 px and 1 % at 2.8 px; partly: fewer than 5",
       {first <= 0, first < 5}},
      {"DSAD: the gradient of the mean is almost constant up to 3 px.",
       {least_slope_percent(of.dsad())},
       "Over 0.4 px, from 0.2 to 3 px: the least gradient is {:.0f} % of the steepest; the mean bends as directions "
       "become independent",
       "At least 75 %; partly: 50 %",
       {first >= 75, first >= 50}},
      {"DSAD: the standard deviation linearly increases in this range (up to 3 px).",
       {curvature},
       "From 0.2 to 3 px up to {:.1f} % of its rise off the best line",
       "Within 5 % of its rise of a straight line; partly: within 10 %",
       {first <= 5, first <= 10}},
      {"DSAD: segmentation-errors up to ≈ 0.1 show a very good capability (see the detection-rate for D50 = 1 px).",
       {of.dsad().segmentation_error(1)},
       "{:.3f} px at D50 = 1 px",
       "At most 0.12 px; partly: below 0.2, still good by the thesis's measure",
       {first <= 0.12, first < kGood}},
      {"DSAD: a segmentation above 1.5 px (segmentation-error > 0.3) gives intolerable results.",
       {of.dsad().segmentation_error(1.5)},
       "At 1.5 px {:.3f} px",
       "Above 0.3 px; partly: above 0.2, no longer good",
       {first > kBad, first > kGood}},
      {"A high ratio of the mean's derivative to the standard deviation (8.10) is important for a good capability.",
       {rank_correlation(capability, error), capability.size()},
       "Rank correlation of 8.10 and of the error, at 1 px, over {1} settings of 9×9: {0:.2f}",
       "At most −0.9; partly: −0.7",
       {first <= -0.9, first <= -0.7}},
      {"The 10/90 disparity is for a linear detection-rate just 16/5 of the segmentation-error.",
       {straight.ten_ninety_px(1).value_or(0) / straight.segmentation_error(1), 100 * departure, measured_ratio},
       "{0:.2f} times for a rate that falls from 100 to 0 % in a straight line. The measured one that is nearest to a line (9×9, "
       "D50 = 0.6 … 1.4 px) is off it by up to {1:.0f} % of its fall; its ratio is {2:.2f}",
       "For the straight line, of which alone the text speaks, within 1 % of 3.2; partly: 5 %",
       {near(first, 3.2, 0.032), near(first, 3.2, 0.16)}},
      {"The segmentation-error is approximately in inverse proportion to the gradient of the detection-rate.",
       {products.min, products.max},
       "DSAD, D50 = 0.4 … 1.4 px: their product {:.3f} … {:.3f}",
       "Largest product at most 1.3 times the smallest; partly: 1.6 times",
       {second <= 1.3 * first, second <= 1.6 * first}},
  };
}

Table histograms(const Measures& of) {
  constexpr std::array kD50s{0.6, 1.0, 1.4};
  const auto departure_percent = [&](const std::string& name, Prefilter prefilter) {
    const Detection& one = of.found.of(name, prefilter);
    double furthest = 0;
    for (const double d50 : kD50s)
      furthest = std::max(furthest, 100 * std::abs(gaussian_error(one, d50) / one.segmentation_error(d50) - 1));
    return furthest;
  };
  double furthest = 0;
  double shape = 0;
  int within = 0;
  int count = 0;
  std::string worst;
  std::string least_normal;
  const auto judge = [&](const std::string& name, Prefilter prefilter) {
    const std::string label = name + (prefilter == highpass ? " HP" : "");
    const double departure = departure_percent(name, prefilter);
    if (departure > furthest) worst = label;
    furthest = std::max(furthest, departure);
    within += departure <= 15 ? 1 : 0;
    const double distance = from_normal(of.found.of(name, prefilter));
    if (distance > shape) least_normal = label;
    shape = std::max(shape, distance);
    ++count;
  };
  judge("DSAD", lowpass);
  judge("ZNSSD", none);
  for (const std::string& name : kGreyCriteria)
    if (std::ranges::find(kLocalGroup, name) == kLocalGroup.end()) judge(name, highpass);
  const auto local = [&](const char* name) { return departure_percent(name, highpass); };
  double least_on_grey = INFINITY;
  for (const std::string& name : kLocalGroup) least_on_grey = std::min(least_on_grey, departure_percent(name, none));
  return {
      {"DSAD, ZNSSD and mainly the criteria on highpass filtered images produce a histogram which is almost Gaussian.",
       {shape, from_normal(of.dsad()), least_normal},
       "Cumulative distributions off the normal one by at most {0:.3f} ({2}); DSAD {1:.3f}",
       "Within 0.05 for all of them (not LSAD, LSSD, NSAD), mean over 0.4 to 2 px; partly: for DSAD",
       {first <= 0.05, second <= 0.05}},
      {"For these the measures could be calculated using the statistical values (mean, deviation) or the histograms.",
       {within, count, furthest, worst},
       "Error at D50 = 0.6, 1, 1.4 px within 15 % for {} of {}; furthest {:.0f} % ({})",
       "Within 15 % for all; partly: for half of them",
       {first >= second, 2 * first >= second}},
      {"LSSD, LSAD and NSAD produce, even on highpass filtered images, wrong results when using the statistical values.",
       {local("LSSD"), local("LSAD"), local("NSAD"), least_on_grey},
       "High-pass, D50 = 0.6, 1, 1.4 px: off by up to {:.0f} %, {:.0f} %, {:.0f} %; on grey values, which the text does not "
       "name, by {:.0f} % at least",
       "All off by more than 15 % after the high-pass; partly: two are",
       {first > 15 && second > 15 && third > 15,
        (first > 15 && second > 15) || (first > 15 && third > 15) || (second > 15 && third > 15)}},
  };
}

}  // namespace

Tables definition_statements(const Measures& of) { return {means(of), errors(of), histograms(of)}; }

}  // namespace horopter::cli
