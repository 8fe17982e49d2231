// SPDX-License-Identifier: Apache-2.0
#include "segmentation_measures.hpp"

#include <algorithm>
#include <cmath>

namespace horopter::cli {

using study::ResultFilter;

double Measures::error(const Names& names, Prefilter prefilter, double d50, int kernel, ResultFilter filter) const {
  double sum = 0;
  for (const std::string& name : names) sum += error(name, prefilter, d50, kernel, filter);
  return sum / static_cast<double>(names.size());
}

double Measures::gain_percent(const Names& names, Prefilter with, Prefilter without) const {
  double before = 0;
  double after = 0;
  for (const double d50 : {0.4, 0.6, 0.8, 1.0, 1.2, 1.4}) {
    before += error(names, without, d50);
    after += error(names, with, d50);
  }
  return 100 * (1 - after / before);
}

double Measures::filter_gain_percent(const Names& names, Prefilter prefilter, int kernel, ResultFilter filter,
                                     double d50) const {
  return 100 * (1 - error(names, prefilter, d50, kernel, filter) / error(names, prefilter, d50, kernel));
}

namespace {

constexpr double kAbout_px = 0.2;

/// Largest of `of(before, at, after)`: errors at D50 − kAbout_px, at D50 and at D50 + kAbout_px, the middle one up to
/// kBad.
template <class Of>
double largest_of(const study::Detection& detection, Of of) {
  double largest = std::nan("");
  for (int i = 6; i <= 40; ++i) {
    const double d50 = 0.05 * i;
    const double at = detection.segmentation_error(d50);
    if (at > kBad) continue;
    largest = std::fmax(
        largest, of(detection.segmentation_error(d50 - kAbout_px), at, detection.segmentation_error(d50 + kAbout_px)));
  }
  return largest;
}

}  // namespace

double Measures::error_gradient(const std::string& name, Prefilter prefilter) const {
  return largest_of(found.of(name, prefilter),
                    [](double before, double, double after) { return (after - before) / (2 * kAbout_px); });
}

double Measures::error_curvature(const std::string& name, Prefilter prefilter) const {
  return largest_of(found.of(name, prefilter), [](double before, double at, double after) {
    return (before - 2 * at + after) / (kAbout_px * kAbout_px);
  });
}

std::vector<double> Measures::errors_of_all(Prefilter prefilter, int kernel, const Names& names) const {
  const bool low = prefilter == Prefilter::lowpass || prefilter == Prefilter::lowpass_highpass;
  std::vector<double> result{error("DSAD", low ? Prefilter::lowpass : Prefilter::none, 1, kernel)};
  for (const std::string& name : names) result.push_back(error(name, prefilter, 1, kernel));
  return result;
}

double Measures::spread(Prefilter prefilter, int kernel) const {
  double low = 1e9;
  double high = 0;
  for (const std::string& name : kGreyCriteria) {
    low = std::min(low, error(name, prefilter, 0.8, kernel));
    high = std::max(high, error(name, prefilter, 0.8, kernel));
  }
  return high - low;
}

double Measures::smallest_error_of_local(Prefilter prefilter) const {
  double smallest = 10;
  for (const std::string& name : kLocalGroup)
    smallest = std::min(smallest, found.of(name, prefilter).smallest_error(0.2));
  return smallest;
}

double Measures::good_up_to(const Names& names, double limit, Prefilter prefilter, double step_px) const {
  double last = 0;
  for (int i = 2; i * step_px < 2 + 1e-9; ++i) {
    const double d50 = i * step_px;
    if (error(names, prefilter, d50) > limit) break;
    last = d50;
  }
  return last;
}

}  // namespace horopter::cli
