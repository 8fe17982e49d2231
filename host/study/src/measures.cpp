// SPDX-License-Identifier: Apache-2.0
#include "horopter/study/measures.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace horopter::study {
namespace {

constexpr int kClassBits = 7;  ///< of a float's 23 bits after the point
constexpr int kLowestOctave = -24;
constexpr int kOctaves = 64;
constexpr std::size_t kClasses = (std::size_t{kOctaves} << kClassBits) + 2;

/// Floats in their order are their bits in their order.
std::size_t class_of(double value) {
  constexpr std::uint32_t kLowest = static_cast<std::uint32_t>(127 + kLowestOctave) << kClassBits;
  const auto number = std::bit_cast<std::uint32_t>(static_cast<float>(value)) >> (23 - kClassBits);
  if (number < kLowest) return 0;
  return std::min<std::size_t>(number - kLowest + 1, kClasses - 1);
}

double lower_edge(std::size_t index) {
  if (index == 0) return 0;
  const auto above = static_cast<int>(index - 1);
  const double mantissa = 1 + static_cast<double>(above & ((1 << kClassBits) - 1)) / (1 << kClassBits);
  return std::ldexp(mantissa, (above >> kClassBits) + kLowestOctave);
}

}  // namespace

Histogram::Histogram(const Plane& values, double best, int margin) {
  if (values.width <= 2 * margin || values.height <= 2 * margin)
    throw std::invalid_argument("an image too small for what windows and filters reach");
  std::vector<std::uint32_t> counts(kClasses);
  double sum = 0;
  double finite = 0;
  double origin = 0;
  double squares = 0;
  bool first = true;
  for (int y = margin; y < values.height - margin; ++y) {
    const double* row = values.row(y);
    for (int x = margin; x < values.width - margin; ++x) {
      const double value = std::abs(row[x] - best);
      if (!std::isfinite(value)) {
        ++counts[kClasses - 1];
        continue;
      }
      ++counts[class_of(value)];
      if (first) origin = value;
      first = false;
      sum += value - origin;
      squares += (value - origin) * (value - origin);
      ++finite;
    }
  }
  if (finite > 0) {
    mean_ = origin + sum / finite;
    deviation_ = std::sqrt(std::max(0.0, squares / finite - (sum / finite) * (sum / finite)));
  }
  first_ = 0;
  while (first_ + 1 < kClasses && counts[first_] == 0) ++first_;
  std::size_t last = kClasses - 1;
  while (last > first_ && counts[last] == 0) --last;
  std::uint32_t below = 0;
  for (std::size_t i = first_; i <= last; ++i) below_.push_back(below += counts[i]);
}

/// Values in classes before `end`.
double Histogram::cumulative(std::size_t end) const {
  if (end <= first_ || below_.empty()) return 0;
  return static_cast<double>(below_[std::min(end - first_, below_.size()) - 1]);
}

double Histogram::share(double threshold) const {
  if (below_.empty() || threshold < 0) return 0;
  const std::size_t index = class_of(threshold);
  const double low = lower_edge(index);
  const double width = lower_edge(index + 1) - low;
  const double within = index == kClasses - 1 ? 0 : std::clamp((threshold - low) / width, 0.0, 1.0);
  const double before = cumulative(index);
  return (before + within * (cumulative(index + 1) - before)) / static_cast<double>(below_.back());
}

double Histogram::quantile(double share) const {
  if (below_.empty()) throw std::invalid_argument("the quantile of nothing");
  const double wanted = share * static_cast<double>(below_.back());
  const auto found = std::lower_bound(below_.begin(), below_.end(), wanted, [](std::uint32_t count, double value) {
    return static_cast<double>(count) < value;
  });
  const std::size_t index = first_ + static_cast<std::size_t>(std::min(found, below_.end() - 1) - below_.begin());
  const double before = cumulative(index);
  const double inside = cumulative(index + 1) - before;
  const double low = lower_edge(index);
  return low + (inside > 0 ? (wanted - before) / inside : 0) * (lower_edge(index + 1) - low);
}

std::vector<Histogram::Bar> Histogram::density(int classes) const {
  const double from = quantile(0.001);
  // Not as far as values that are as good as infinite.
  const double to = std::min(quantile(0.999), mean_ + 8 * deviation_);
  std::vector<Bar> result;
  for (int i = 0; i < classes; ++i) {
    Bar bar{from + (to - from) * i / classes, from + (to - from) * (i + 1) / classes, 0};
    if (bar.to > bar.from) bar.density = (share(bar.to) - share(bar.from)) / (bar.to - bar.from);
    result.push_back(bar);
  }
  return result;
}

Detection::Detection(std::vector<double> disparities_px, std::vector<Histogram> histograms)
    : disparities_px_(std::move(disparities_px)), histograms_(std::move(histograms)) {
  if (disparities_px_.size() < 2 || disparities_px_.size() != histograms_.size() ||
      std::adjacent_find(disparities_px_.begin(), disparities_px_.end(), std::greater_equal<>()) !=
          disparities_px_.end())
    throw std::invalid_argument("detection: two or more ascending disparities, a histogram for each");
}

double Detection::between(const std::vector<double>& values, double disparity_px) const {
  const auto above = std::upper_bound(disparities_px_.begin(), disparities_px_.end() - 1, disparity_px);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, above - disparities_px_.begin()));
  const double part =
      std::clamp((disparity_px - disparities_px_[i - 1]) / (disparities_px_[i] - disparities_px_[i - 1]), 0.0, 1.0);
  return values[i - 1] + part * (values[i] - values[i - 1]);
}

double Detection::threshold(double d50_px) const {
  std::vector<double> medians;
  for (const Histogram& histogram : histograms_) medians.push_back(histogram.quantile(0.5));
  return between(medians, d50_px);
}

std::vector<double> Detection::rates(double threshold) const {
  std::vector<double> result;
  for (const Histogram& histogram : histograms_) result.push_back(histogram.share(threshold));
  return result;
}

double Detection::rate(double threshold, double disparity_px) const { return between(rates(threshold), disparity_px); }

std::optional<double> Detection::disparity_at(double threshold, double share) const {
  const std::vector<double> all = rates(threshold);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (disparities_px_[i] < 0 || all[i] > share) continue;
    if (i == 0 || disparities_px_[i - 1] < 0) return std::nullopt;
    const double part = (all[i - 1] - share) / (all[i - 1] - all[i]);
    return disparities_px_[i - 1] + part * (disparities_px_[i] - disparities_px_[i - 1]);
  }
  return std::nullopt;
}

double Detection::segmentation_error(double d50_px) const {
  const std::vector<double> all = rates(threshold(d50_px));
  // Wrong pixels over disparity, trapezoid by trapezoid, with a corner at D50.
  std::vector<double> places{0};
  for (const double d : disparities_px_)
    if (d > 0 && d < kLargest_px) places.push_back(d);
  places.push_back(std::min(kLargest_px, disparities_px_.back()));
  if (d50_px > 0 && d50_px < places.back()) places.push_back(d50_px);
  std::sort(places.begin(), places.end());
  double error = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const bool inside = places[i] <= d50_px;
    const double mean = (between(all, places[i - 1]) + between(all, places[i])) / 2;
    error += (places[i] - places[i - 1]) * (inside ? 1 - mean : mean);
  }
  return error;
}

std::optional<double> Detection::ten_ninety_px(double d50_px) const {
  const double limit = threshold(d50_px);
  const auto ninety = disparity_at(limit, 0.9);
  const auto ten = disparity_at(limit, 0.1);
  if (!ninety || !ten) return std::nullopt;
  return *ten - *ninety;
}

double Detection::slope_over_deviation(double disparity_px) const {
  std::vector<double> means;
  std::vector<double> deviations;
  for (const Histogram& histogram : histograms_) {
    means.push_back(histogram.mean());
    deviations.push_back(histogram.deviation());
  }
  constexpr double kStep = 0.1;  // px, each way
  const double deviation = between(deviations, disparity_px);
  return deviation > 0
             ? (between(means, disparity_px + kStep) - between(means, disparity_px - kStep)) / (2 * kStep) / deviation
             : 0;
}

double Detection::smallest_error(double from_px, double to_px) const {
  double smallest = kLargest_px;
  for (const double d : disparities_px_)
    if (d >= from_px - 1e-9 && d <= to_px + 1e-9) smallest = std::min(smallest, segmentation_error(d));
  return smallest;
}

}  // namespace horopter::study
