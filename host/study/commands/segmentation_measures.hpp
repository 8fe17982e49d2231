// SPDX-License-Identifier: Apache-2.0
// What the statements about segmentation measure, and who makes them.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include "curves.hpp"
#include "segmentation.hpp"

namespace horopter::cli {

using Names = std::vector<std::string>;
using Table = std::vector<Statement>;
using Tables = std::vector<Table>;

constexpr double kGood = 0.2;  ///< 8.4.2: a segmentation error below shows a good segmentation capability
constexpr double kBad = 0.3;   ///< and one above a bad one; up to here an error is tolerable (8.4.4)

inline Names and_znssd(Names names) {
  names.push_back("ZNSSD");
  return names;
}

/// Smallest and largest of `of` at some places.
template <class Of>
auto range_of(std::initializer_list<double> places, Of of) {
  std::vector<double> values;
  for (const double place : places) values.push_back(of(place));
  return std::ranges::minmax(values);
}

class Measures {
 public:
  /// `even`: some of the settings in even light.
  Measures(const Segmentation& all, const Segmentation& in_even_light, const std::vector<int>& kernel_sizes,
           const std::vector<double>& log_w_px)
      : found(all),
        even(in_even_light),
        small(kernel_sizes.front()),
        large(kernel_sizes.back()),
        kernels(kernel_sizes),
        small_w(log_w_px.front()),
        large_w(log_w_px.back()) {}

  const study::Detection& dsad() const { return found.of("DSAD", Prefilter::lowpass); }
  const study::Detection& nsad() const { return found.of("NSAD", Prefilter::highpass); }

  double error(const std::string& name, Prefilter prefilter, double d50, int kernel = 9,
               study::ResultFilter filter = study::ResultFilter::none) const {
    return found.of(name, prefilter, kernel, filter).segmentation_error(d50);
  }
  /// Mean error of a group.
  double error(const Names& names, Prefilter prefilter, double d50, int kernel = 9,
               study::ResultFilter filter = study::ResultFilter::none) const;
  /// Of a criterion or a group, with one prefilter over that with another.
  template <class Who>
  double ratio(const Who& who, Prefilter with, Prefilter without, double d50, int kernel = 9) const {
    return error(who, with, d50, kernel) / error(who, without, d50, kernel);
  }
  double ratio(const char* name, Prefilter with, Prefilter without, double d50, int kernel = 9) const {
    return ratio(std::string(name), with, without, d50, kernel);
  }
  /// By how many percent a group's error is lower with one prefilter than with another, on average over D50.
  double gain_percent(const Names& names, Prefilter with, Prefilter without) const;
  /// By how many percent a filter of the result lowers the error.
  double filter_gain_percent(const Names& names, Prefilter prefilter, int kernel, study::ResultFilter filter,
                             double d50) const;
  /// Of the segmentation error over D50, where it is up to kBad: its steepest rise, px a px, and the largest second
  /// derivative, 1/px, both over D50 ± 0.2 px. NaN where it is never.
  double error_gradient(const std::string& name, Prefilter prefilter) const;
  double error_curvature(const std::string& name, Prefilter prefilter) const;
  /// Errors at 1 px of DSAD and all criteria on grey values, in one order.
  std::vector<double> errors_of_all(Prefilter prefilter, int kernel, const Names& names) const;
  /// Between the best and the worst at 0.8 px.
  double spread(Prefilter prefilter, int kernel = 9) const;
  double smallest_error_of_local(Prefilter prefilter) const;
  /// Largest D50, in steps of `step_px`, up to which the group's mean error stays within a limit.
  double good_up_to(const Names& names, double limit, Prefilter prefilter = Prefilter::none,
                    double step_px = 0.05) const;
  /// From the first to the last D50 from 0.04 to 2 px, in steps of 0.02 px, at which `holds`.
  template <class Holds>
  double width_where(Holds holds) const {
    constexpr double kStep_px = 0.02;
    int low = 0;
    int high = 0;
    for (int i = 2; i <= 100; ++i) {
      if (!holds(i * kStep_px)) continue;
      if (low == 0) low = i;
      high = i;
    }
    return (high - low) * kStep_px;
  }
  /// Largest D50 in steps of 0.05 px, from the step `from` on, at which `holds`.
  template <class Holds>
  double last_of(int from, Holds holds) const {
    double last = 0;
    for (int i = from; i <= 40; ++i)
      if (holds(i * 0.05)) last = i * 0.05;
    return last;
  }

  const Segmentation& found;
  const Segmentation& even;
  int small, large;  ///< of the kernels
  const std::vector<int>& kernels;
  double small_w, large_w;  ///< of NISH, px
};

Tables definition_statements(const Measures& of);     ///< 8.4.2
Tables prefilter_statements(const Measures& of);      ///< 8.4.3
Tables criteria_statements(const Measures& of);       ///< 8.4.4
Tables result_filter_statements(const Measures& of);  ///< 8.4.5
Tables threshold_statements(const Measures& of);      ///< 11.2.1
Table family_statements(const Measures& of);          ///< 8.1

}  // namespace horopter::cli
