// SPDX-License-Identifier: Apache-2.0
// What 8.4.5 says about filters of the result.
#include <fmt/format.h>

#include "segmentation_measures.hpp"

namespace horopter::cli {
namespace {

using namespace measured;
using study::ResultFilter;
using enum Prefilter;

constexpr int kLargestSmall = 7;  ///< 8.4.5: small kernels are those up to 7×7

Table result_filters_on_grey(const Measures& of) {
  const double by_lowpass = of.filter_gain_percent(kGreyCriteria, none, of.small, ResultFilter::lowpass, 0.6);
  int small_kernels = 0;
  int lowpass_better = 0;
  int after_better = 0;
  std::string gains;
  std::string errors;
  for (const int kernel : of.kernels) {
    if (kernel > kLargestSmall) continue;
    ++small_kernels;
    const double lower = of.filter_gain_percent(kGreyCriteria, none, kernel, ResultFilter::lowpass, 0.6);
    const double by_median = of.filter_gain_percent(kGreyCriteria, none, kernel, ResultFilter::median, 0.6);
    lowpass_better += lower > by_median ? 1 : 0;
    gains += fmt::format("{0}{1}×{1} {2:.1f} and {3:.1f} %", gains.empty() ? "" : ", ", kernel, lower, by_median);
    const double after = of.error(kGreyCriteria, none, 0.6, kernel, ResultFilter::lowpass);
    const double before = of.error(kGreyCriteria, lowpass, 0.6, kernel);
    after_better += after < before ? 1 : 0;
    errors +=
        fmt::format("{0}{1}×{1} {2:.3f} px after, {3:.3f} before", errors.empty() ? "" : "; ", kernel, after, before);
  }
  return {
      {"Filtering the result on grey values improves small kernels and has no effect on large ones (> 11×11).",
       {by_lowpass, of.filter_gain_percent(kGreyCriteria, none, of.large, ResultFilter::lowpass, 0.6), of.small,
        of.large},
       "Error at 0.6 px lower by {0:.1f} % with {2}×{2}, {1:.1f} % with {3}×{3}",
       "At least 3 % and below 2 %; partly: more with the small kernel",
       {first >= 3 && second > -2 && 2 > second, first > second},
       "a low-pass over the values of a criterion lowers the error of small windows, and hardly that of large ones"},
      {"Grey values: the low-pass on the result improves more than the median.",
       {lowpass_better, small_kernels, gains},
       "Error at 0.6 px lower by: {2}",
       "More with every small kernel (up to 7×7); partly: with one",
       {first >= second, first > 0}},
      {"For small kernels at small disparities filtering the result is better than a low-pass before.",
       {after_better, small_kernels, errors},
       "At 0.6 px: {2}",
       "A smaller mean error at 0.6 px, up to which the text says it for all methods, with every small kernel (up to "
       "7×7); partly: with one",
       {first >= second, first > 0}},
  };
}

Table result_filters_on_highpass(const Measures& of) {
  return {
      {"High-pass, SAD, SSD, ZSAD, ZSSD: filtering the result helps up to 9×9 only.",
       {of.filter_gain_percent(kZeroMeanGroup, highpass, 9, ResultFilter::lowpass, 0.6),
        of.filter_gain_percent(kZeroMeanGroup, highpass, of.large, ResultFilter::lowpass, 0.6), of.large},
       "Error at 0.6 px lower by {0:.1f} % with 9×9, {1:.1f} % with {2}×{2}",
       "At least 2 % and below 2 %; partly: more with 9×9",
       {first >= 2 && 2 > second, first > second}},
      {"High-pass, LSAD, LSSD, NSAD: the median on the result is much better than the low-pass.",
       {of.filter_gain_percent(kLocalGroup, highpass, 9, ResultFilter::median, 0.8),
        of.filter_gain_percent(kLocalGroup, highpass, 9, ResultFilter::lowpass, 0.8)},
       "9×9, error at 0.8 px lower by {:.1f} % and {:.1f} %",
       "By 2 points at least; partly: better",
       {first > second + 2, first > second}},
      {"High-pass, LSAD, LSSD, NSAD: the low-pass on the result makes large kernels worse.",
       {of.filter_gain_percent(kLocalGroup, highpass, of.large, ResultFilter::lowpass, 0.8), of.large},
       "{1}×{1}, error at 0.8 px lower by {0:.1f} %",
       "A larger mean error",
       {first < 0}},
  };
}

}  // namespace

Tables result_filter_statements(const Measures& of) {
  return {result_filters_on_grey(of), result_filters_on_highpass(of)};
}

}  // namespace horopter::cli
