// SPDX-License-Identifier: Apache-2.0
// What 8.4.3 says about filters before the criteria.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "segmentation_measures.hpp"

namespace horopter::cli {
namespace {

using namespace measured;
using study::Detection;
using enum Prefilter;

/// For how many of some criteria `holds`.
template <class Holds>
int count(const Names& names, Holds holds) {
  return static_cast<int>(std::ranges::count_if(names, holds));
}
template <class Holds>
int count(Holds holds) {
  return count(kGreyCriteria, holds);
}

Table lowpass_before(const Measures& of) {
  const auto effect_percent = [&](Prefilter with, Prefilter without) {
    double sum = 0;
    for (const std::string& name : kGreyCriteria) sum += std::abs(of.ratio(name, with, without, 1) - 1);
    return 100 * sum / static_cast<double>(kGreyCriteria.size());
  };
  return {
      {"A lowpass decreases the curvature and gradient of the segmentation-error function, similarly for all methods on "
       "intensity images.",
       {count(
            [&](const std::string& name) { return of.error_gradient(name, lowpass) < of.error_gradient(name, none); }),
        count([&](const std::string& name) {
          return of.error_curvature(name, lowpass) < of.error_curvature(name, none);
        }),
        kGreyCriteria.size()},
       "Smaller for {0} (gradient) and {1} (curvature) of {2}, where the error is up to 0.3, as far as 8.4.4 calls it relevant",
       "Largest gradient and largest second derivative there, both smaller for all; partly: each for half of them",
       {first >= third && second >= third, 2 * first >= third && 2 * second >= third}},
      {"Lowpass before SAD: for small segmentation-disparities the error is slightly higher, for larger ones "
       "significantly lower.",
       {of.ratio("SAD", lowpass, none, 0.3), of.ratio("SAD", lowpass, none, 1.2)},
       "{:.2f} times at 0.3 px, {:.2f} times at 1.2 px",
       "Above 1, at most 1.25, at 0.3 px and at most 0.95 at 1.2 px; partly: one of them",
       {first > 1 && first <= 1.25 && second <= 0.95, (first > 1 && first <= 1.25) || second <= 0.95}},
      {"DSAD: the improvement of a lowpass filter is significantly above a segmentation-disparity of 1 pixel.",
       {of.ratio("DSAD", lowpass, none, 1), of.ratio("DSAD", lowpass, none, 1.4)},
       "{:.2f} times the error at 1.0 px, {:.2f} times at 1.4 px",
       "At most 0.9 times at 1.4 px; partly: below 1",
       {second <= 0.9, second < 1},
       "a low-pass improves DSAD above 1 px"},
      {"The effect of a lowpass with DSAD is greater than on intensity images, but smaller than on highpass filtered "
       "ones.",
       {effect_percent(lowpass, none), 100 * std::abs(of.ratio("DSAD", lowpass, none, 1) - 1),
        effect_percent(lowpass_highpass, highpass)},
       "Change of the error at 1 px: grey {:.0f} %, DSAD {:.0f} %, high-passed {:.0f} %",
       "In this order; partly: the latter",
       {first < second && second < third, second < third}},
  };
}

Table highpass_before(const Measures& of) {
  constexpr double kSmall_px = 0.5;
  std::string who;
  for (const std::string& name : kLikedByHighpass)
    if (of.ratio(name, highpass, none, kSmall_px) < 1) who += (who.empty() ? "" : ", ") + name;
  if (who.empty()) who = "none";
  return {
      {"All methods on highpass filtered intensity images show an increase of the curvature and gradient of the "
       "segmentation-error function.",
       {count(
            [&](const std::string& name) { return of.error_gradient(name, highpass) > of.error_gradient(name, none); }),
        count([&](const std::string& name) {
          return of.error_curvature(name, highpass) > of.error_curvature(name, none);
        }),
        kGreyCriteria.size()},
       "Greater for {0} (gradient) and {1} (curvature) of {2}, where the error is up to 0.3, as far as 8.4.4 calls it relevant",
       "Largest gradient and largest second derivative there, both greater for all; partly: each for half of them",
       {first >= third && second >= third, 2 * first >= third && 2 * second >= third}},
      {"All methods on highpass filtered intensity images show some decrease of the error for small disparities (Fig. "
       "8.7).",
       {count(kLikedByHighpass, [&](const std::string& name) { return of.ratio(name, highpass, none, kSmall_px) < 1; }),
        kLikedByHighpass.size(), of.ratio("NCC", highpass, none, kSmall_px),
        of.ratio("ZSSD", highpass, none, kSmall_px), kSmall_px, who},
       "At {4} px lower for {0} of {1} ({5}); NCC's error is {2:.2f} times that without the high-pass, ZSSD's {3:.2f} times",
       "At 0.5 px, where small disparities end in 8.4.4 (0.55 px with a low-pass, 0.85 px without), for all eight: LSAD, "
       "LSSD, NSAD are left out, of which the text says otherwise; partly: for half of the eight, as in one of the two "
       "groups that the text makes of them",
       {first >= second, 2 * first >= second}},
      {"LSAD, LSSD and NSAD show a worsening of the behaviour with highpass filtering.",
       {of.ratio("LSAD", highpass, none, 0.8), of.ratio("LSSD", highpass, none, 0.8),
        of.ratio("NSAD", highpass, none, 0.8)},
       "Error at 0.8 px: LSAD {:.1f} times, LSSD {:.1f} times, NSAD {:.1f} times",
       "All three; partly: two",
       {first > 1 && second > 1 && third > 1,
        (first > 1 && second > 1) || (first > 1 && third > 1) || (second > 1 && third > 1)},
       "a high-pass makes LSAD, LSSD, NSAD worse"},
  };
}

Table both_before(const Measures& of) {
  int better = 0;
  double before = 0;
  double after = 0;
  for (const std::string& name : kGreyCriteria) {
    const auto left_percent = [&](Prefilter prefilter) {
      const Detection& one = of.found.of(name, prefilter);
      return 100 * one.rate(one.threshold(1), Detection::kLargest_px);
    };
    better += left_percent(lowpass_highpass) < left_percent(highpass) ? 1 : 0;
    before += left_percent(highpass) / static_cast<double>(kGreyCriteria.size());
    after += left_percent(lowpass_highpass) / static_cast<double>(kGreyCriteria.size());
  }
  const Names cross = and_znssd(kCrossGroup);
  const auto gain = [&](const Names& names) { return of.gain_percent(names, lowpass_highpass, highpass); };
  const auto farther_px = [&](const Names& names) {
    constexpr double kStep_px = 0.02;
    return of.good_up_to(names, kBad, lowpass_highpass, kStep_px) - of.good_up_to(names, kBad, highpass, kStep_px);
  };
  const Rule most_by_error = first > 0 && first > second && first > third;
  const Rule most_by_reach = fourth > 0 && fourth > fifth && fourth > Term(5, 1, 0);
  const auto flat = [&](Prefilter prefilter, double limit) {
    return of.width_where([&](double d50) { return of.error(cross, prefilter, d50) <= limit; });
  };
  const auto mean = [&](Prefilter prefilter, auto measure) {
    double sum = 0;
    for (const std::string& name : cross) sum += (of.*measure)(name, prefilter) / static_cast<double>(cross.size());
    return sum;
  };
  const double gradient = mean(highpass, &Measures::error_gradient);
  const double low_gradient = mean(lowpass_highpass, &Measures::error_gradient);
  const double curvature = mean(highpass, &Measures::error_curvature);
  const double low_curvature = mean(lowpass_highpass, &Measures::error_curvature);
  constexpr double kVeryGood = 0.1;  // 8.4.2
  const double zone_px = flat(highpass, kVeryGood);
  const double low_zone_px = flat(lowpass_highpass, kVeryGood);
  const int as_said =
      (low_gradient < gradient ? 1 : 0) + (low_curvature < curvature ? 1 : 0) + (low_zone_px > zone_px ? 1 : 0);
  return {
      {"With a lowpass before the highpass the detection-rate converges to 0 % while the method without does not.",
       {before, after, better, kGreyCriteria.size()},
       "Left at 2.8 px with D50 = 1 px: {:.1f} % without, {:.1f} % with; lower for {} of {} criteria",
       "Lower for all and halved on average; partly: lower on average",
       {third >= fourth && second <= 0.5 * first, second < first}},
      {"Lowpass before highpass: NCC, ZNCC, MOR, ZNSSD show the highest improvement.",
       {gain(cross), gain(kZeroMeanGroup), gain(kLocalGroup), farther_px(cross), farther_px(kZeroMeanGroup),
        farther_px(kLocalGroup)},
       "Error up to 0.3, tolerable, up to a D50 that is farther by {3:.2f} px; SAD, SSD and zero-mean ones {4:.2f} px, LSAD, "
       "LSSD, NSAD {5:.2f} px. Mean error for D50 = 0.4 … 1.4 px lower by {0:.1f} %; {1:.1f} %; {2:.1f} %",
       "Improved most of the three by both measures: by how far the error is tolerable, as 8.4.4 compares criteria, and by "
       "the mean error; partly: by one of them",
       {most_by_error && most_by_reach, most_by_error || most_by_reach},
       "a low-pass before the high-pass improves NCC, ZNCC, MOR, ZNSSD most"},
      {"Lowpass before highpass: for NCC, ZNCC, MOR, ZNSSD it decreases gradient and curvature of the "
       "segmentation-error function and increases the flat zone (zone of very low error, Fig. 8.8).",
       {as_said, gradient, low_gradient, curvature, low_curvature, zone_px, low_zone_px, flat(highpass, kGood),
        flat(lowpass_highpass, kGood)},
       "{0} of the three. Without the low-pass and with it: largest gradient {1:.2f} and {2:.2f}, largest second derivative "
       "{3:.2f} and {4:.2f}/px; error up to 0.1 over {5:.2f} and {6:.2f} px of D50, up to 0.2 over {7:.2f} and {8:.2f} px. The "
       "error with the low-pass rises earlier, but less steeply",
       "Where the error is up to 0.3, a smaller gradient and second derivative; and a wider flat zone: a very low error is "
       "one up to 0.1, which 8.4.2 calls very good, while 0.2 is the limit of good; partly: two of the three",
       {first >= 3, first >= 2}},
      {"Lowpass before highpass: SAD, SSD and their zero-mean versions show a slight improvement.",
       {gain(kZeroMeanGroup)},
       "Mean error for D50 = 0.4 … 1.4 px lower by {:.1f} %",
       "By 2 to 30 %; partly: by more",
       {first >= 2 && first <= 30, first > 30}},
      {"Lowpass before highpass: LSAD, LSSD, NSAD show a slight improvement, but the minimal error is still very high.",
       {gain(kLocalGroup), of.smallest_error_of_local(lowpass_highpass)},
       "Mean error for D50 = 0.4 … 1.4 px lower by {:.1f} %; smallest error {:.3f} px",
       "By 2 % or more, and above 0.15 px for every D50 from 0.2 px on; partly: one of them",
       {first >= 2 && second > 0.15, first >= 2 || second > 0.15}},
  };
}

/// Linear between disparities.
double mean_at(const Detection& detection, double disparity_px) {
  const auto& places = detection.disparities_px();
  const auto above = std::ranges::lower_bound(places, disparity_px - 1e-9);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, above - places.begin()));
  const double part = (disparity_px - places[i - 1]) / (places[i] - places[i - 1]);
  return std::lerp(detection.histograms()[i - 1].mean(), detection.histograms()[i].mean(), part);
}

Table binary(const Measures& of) {
  const auto wide_over_narrow = [&](double d50, int kernel) {
    return of.found.nish(of.large_w, kernel).segmentation_error(d50) /
           of.found.nish(of.small_w, kernel).segmentation_error(d50);
  };
  int as_with_9 = 0;
  int small_w_better = 0;
  int growing = 0;
  std::string ratios;
  for (std::size_t i = 0; i < of.kernels.size(); ++i) {
    const int kernel = of.kernels[i];
    const double near = wide_over_narrow(0.4, kernel);
    const double far = wide_over_narrow(1.2, kernel);
    as_with_9 += near > 1 && far < 1 ? 1 : 0;
    small_w_better += near > 1 ? 1 : 0;
    growing += i > 0 && near < wide_over_narrow(0.4, of.kernels[i - 1]) ? 1 : 0;
    ratios += fmt::format("{0}{1:.2f} and {2:.2f} with {3}×{3}", i == 0 ? "" : ", ", near, far, kernel);
  }
  const auto slope = [&](double w) { return mean_at(of.found.nish(w), 0.6) - mean_at(of.found.nish(w), 0.2); };
  return {
      {"NISH: small w behaves like a high-pass (small errors at small D50), large w tolerates more.",
       {wide_over_narrow(0.4, 9), wide_over_narrow(1.2, 9), of.large_w, of.small_w},
       "Error with w = {2:g} over that with w = {3:g}: {0:.2f} at 0.4 px, {1:.2f} at 1.2 px",
       "Above 1 at 0.4 px and below 1 at 1.2 px; partly: falling",
       {first > 1 && 1 > second, first > second}},
      {"NISH: this phenomenon holds for all kernel sizes, but the degree increases with smaller kernel size.",
       {as_with_9, small_w_better, growing, of.kernels.size(), ratios},
       "At 0.4 and 1.2 px: {4}",
       "With every kernel above 1 at 0.4 px and below 1 at 1.2 px, and the more above 1 at 0.4 px the smaller the kernel; "
       "partly: all but the below 1",
       {first >= fourth && third >= fourth + -1, second >= fourth && third >= fourth + -1}},
      {"NISH: a large w makes the correlation more tolerant to translation (Fig. 8.9).",
       {slope(of.small_w) / slope(of.large_w), of.small_w, of.large_w},
       "The mean falls {:.1f} times as fast with w = {:g} as with {:g}",
       "At least 1.2 times; partly: faster",
       {first > 1.2, first > 1}},
  };
}

}  // namespace

Tables prefilter_statements(const Measures& of) {
  return {lowpass_before(of), highpass_before(of), both_before(of), binary(of)};
}

}  // namespace horopter::cli
