// SPDX-License-Identifier: Apache-2.0
// What 8.4.5 says about filters of the result.
#include <fmt/format.h>

#include "segmentation_measures.hpp"

namespace horopter::cli {
namespace {

using namespace measured;
using study::ResultFilter;
using enum Prefilter;

Table result_filters_on_grey(const Measures& of) {
  const double by_lowpass = of.filter_gain_percent(kGreyCriteria, none, of.small, ResultFilter::lowpass, 0.6);
  return {
      {"Filtering the result on grey values improves small kernels and has no effect on large ones (> 11×11).",
       {by_lowpass, of.filter_gain_percent(kGreyCriteria, none, of.large, ResultFilter::lowpass, 0.6), of.small,
        of.large},
       "Error at 0.6 px lower by {0:.1f} % with {2}×{2}, {1:.1f} % with {3}×{3}",
       "At least 3 % and below 2 %; partly: more with the small kernel",
       {first >= 3 && second > -2 && 2 > second, first > second},
       "filtering the result helps small windows only"},
      {"Grey values: the low-pass on the result improves more than the median.",
       {by_lowpass, of.filter_gain_percent(kGreyCriteria, none, of.small, ResultFilter::median, 0.6), of.small},
       "{2}×{2}, error at 0.6 px lower by {0:.1f} % and {1:.1f} %",
       "More",
       {first > second}},
      {"For small kernels at small disparities filtering the result is better than a low-pass before.",
       {of.error(kGreyCriteria, none, 0.5, of.small, ResultFilter::lowpass),
        of.error(kGreyCriteria, lowpass, 0.5, of.small), of.small},
       "{2}×{2} at 0.5 px: {0:.3f} px after, {1:.3f} before",
       "A smaller mean error",
       {first < second}},
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
