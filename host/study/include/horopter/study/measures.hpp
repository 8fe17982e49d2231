// SPDX-License-Identifier: Apache-2.0
// Measures of how well a criterion tells small disparities from large ones (thesis 8.4.2). All of them are of
// dissimilarities: a similarity is taken as its distance from the best value.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "horopter/study/raster.hpp"

namespace horopter::study {

/// Histogram of values ≥ 0 in 128 classes an octave, 2⁻²⁴ to 2⁴⁰; smaller ones in one class, larger and undefined ones
/// in another. Within a class values are taken as evenly spread, so few discrete values are decided as by lot.
class Histogram {
 public:
  Histogram() = default;
  /// Of |values − best| where `margin` px or more from the border.
  Histogram(const Plane& values, double best, int margin);

  /// Share of values ≤ threshold.
  double share(double threshold) const;
  /// The threshold that `share` of the values do not exceed.
  double quantile(double share) const;
  /// Of the finite values.
  double mean() const { return mean_; }
  double deviation() const { return deviation_; }
  /// Edges of classes, and the share of values in each per unit of its width: the density.
  struct Bar {
    double from, to, density;
  };
  /// `classes` of equal width between the quantiles 0.1 % and 99.9 %, at most 8 deviations above the mean.
  std::vector<Bar> density(int classes) const;

 private:
  double cumulative(std::size_t end) const;

  std::size_t first_ = 0;             ///< class of counts_[0]
  std::vector<std::uint32_t> below_;  ///< values in all classes up to and with this one
  double mean_ = 0;
  double deviation_ = 0;
};

/// Histograms over disparities.
class Detection {
 public:
  static constexpr double kLargest_px = 2.8;  ///< up to here wrongly segmented pixels count (8.9)

  /// Ascending disparities, one histogram for each. Throws std::invalid_argument when they are not.
  Detection(std::vector<double> disparities_px, std::vector<Histogram> histograms);

  const std::vector<double>& disparities_px() const { return disparities_px_; }
  const std::vector<Histogram>& histograms() const { return histograms_; }

  /// The threshold at which half of the pixels with this disparity are detected: their median, linear between
  /// disparities.
  double threshold(double d50_px) const;
  /// Share detected with a threshold, for each disparity (8.8).
  std::vector<double> rates(double threshold) const;
  double rate(double threshold, double disparity_px) const;
  /// The disparity at which the rate falls to `share` for the first time from 0 on; none when it never does, or is
  /// below it at 0.
  std::optional<double> disparity_at(double threshold, double share) const;
  /// Eq. 8.9 as the integral that the sum approaches, over 0 … kLargest_px, in px.
  double segmentation_error(double d50_px) const;
  /// Disparity between the rates 90 % and 10 %; none when they are not reached.
  std::optional<double> ten_ninety_px(double d50_px) const;
  /// Eq. 8.10 at a disparity: slope of the mean over the deviation, 1/px.
  double slope_over_deviation(double disparity_px) const;
  /// Smallest segmentation error for D50 from `from_px` to `to_px`, over the disparities there are.
  double smallest_error(double from_px, double to_px = kLargest_px) const;

 private:
  double between(const std::vector<double>& values, double disparity_px) const;

  std::vector<double> disparities_px_;
  std::vector<Histogram> histograms_;
};

}  // namespace horopter::study
