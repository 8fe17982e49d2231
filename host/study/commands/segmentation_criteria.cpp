// SPDX-License-Identifier: Apache-2.0
// What 8.1 and 8.4.4 say about the criteria, and about their kernels.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "segmentation_measures.hpp"

namespace horopter::cli {
namespace {

using namespace measured;
using enum Prefilter;

Table criteria_on_grey(const Measures& of) {
  Table table;
  // Errors at 1 px of DSAD, of the cross correlations and of the differences.
  const auto groups = [&](const Segmentation& found, Prefilter prefilter) {
    const Measures in(found, found, of.kernels, {of.small_w, of.large_w});
    return std::array{in.error("DSAD", prefilter, 1), in.error(kNormalisedGroup, prefilter, 1),
                      in.error(kDifferenceGroup, prefilter, 1)};
  };
  const auto ordered = [](const std::array<double, 3>& errors) {
    return errors[0] < errors[1] && errors[1] < errors[2];
  };
  for (const auto& [prefilter, images, headline] :
       {std::tuple{none, "intensity images (Fig. 8.12)", "DSAD is best on grey values"},
        std::tuple{lowpass, "low-pass filtered intensity images (Fig. 8.13)", ""}}) {
    const auto sloped = groups(of.found, prefilter);
    const auto even = groups(of.even, prefilter);
    table.push_back(
        {fmt::format("9×9, {}: DSAD is best, then NCC, ZNCC, MOR, ZNSSD, NSAD, then the differences without "
                     "normalization terms.",
                     images),
         {ordered(sloped), ordered(even), sloped[0], sloped[1], sloped[2], even[0], even[1], even[2],
          sloped[0] < std::min(sloped[1], sloped[2]) && even[0] < std::min(even[1], even[2])},
         "Error at 1 px: {2:.3f}, {3:.3f}, {4:.3f} px in light that falls across the image; {5:.3f}, {6:.3f}, "
         "{7:.3f} px in even light",
         "In this order in both; partly: DSAD best in both",
         {first >= 1 && second >= 1, Term(8, 1, 0) >= 1},
         headline});
  }
  table.push_back(
      {"NCC, ZNCC, MOR, ZNSSD, NSAD: tolerable segmentation-error up to a segmentation-disparity of 0.9 – 1.0 "
       "pixel.",
       {of.good_up_to(kNormalisedGroup, kBad), of.good_up_to(kNormalisedGroup, kGood)},
       "Mean error up to 0.3 until {:.2f} px; up to 0.2 until {:.2f} px",
       "Error 0.3 (the text's relevant range ends there) reached within 0.15 px of 0.95 px; partly: not before",
       {near(first, 0.95, 0.15), first >= 0.9}});
  table.push_back(
      {"SAD, ZSAD, LSAD, SSD, ZSSD, LSSD: tolerable performance up to a segmentation-disparity of 0.7 pixel.",
       {of.good_up_to(kDifferenceGroup, kBad), of.good_up_to(kDifferenceGroup, kGood)},
       "Mean error up to 0.3 until {:.2f} px; up to 0.2 until {:.2f} px",
       "Error 0.3 reached within 0.15 px of 0.7 px; partly: not before",
       {near(first, 0.7, 0.15), first >= 0.7}});
  table.push_back({"Except for DSAD an additional lowpass filter decreases the difference in performance.",
                   {of.spread(none), of.spread(lowpass)},
                   "Best to worst at 0.8 px: {:.3f} px without, {:.3f} with",
                   "Smaller by 5 % at least; partly: smaller",
                   {second < 0.95 * first, second < first}});
  return table;
}

/// High-pass: up to which D50 NCC, ZNCC, MOR and ZNSSD surpass DSAD.
Statement surpassing(const Measures& of, const char* images, Prefilter prefilter, Prefilter of_direction,
                     double expected) {
  const Names cross = and_znssd(kCrossGroup);
  return {
      fmt::format("{}: DSAD is best, and only surpassed by NCC, ZNCC, MOR, ZNSSD at small disparities (up to {} pxl).",
                  images, expected),
      {of.last_of(1, [&](double d50) { return of.error(cross, prefilter, d50) < of.error("DSAD", of_direction, d50); }),
       of.error(cross, prefilter, 1.5) / of.error("DSAD", of_direction, 1.5)},
      "Surpassed up to {:.2f} px; at 1.5 px their error is {:.1f} times DSAD's",
      "Limit within 0.15 px; partly: DSAD better at 1.5 px",
      {near(first, expected, 0.15) && second > 1, second > 1},
      prefilter == highpass ? "after a high-pass NCC and its like surpass DSAD at small disparities alone" : ""};
}

Table criteria_on_highpass(const Measures& of) {
  const double of_zero = of.error(kZeroMeanGroup, highpass, 0.5);
  const double of_local = of.error(kLocalGroup, highpass, 0.5);
  const auto over_cross = [&](Prefilter prefilter) {
    return of.error("NSAD", prefilter, 0.8) / of.error(kCrossGroup, prefilter, 0.8);
  };
  return {
      {"The methods differ much more on high-pass filtered images than on grey values.",
       {of.spread(highpass), of.spread(none)},
       "Best to worst at 0.8 px: {:.3f} px against {:.3f}",
       "1.5 times at least; partly: more",
       {first > 1.5 * second, first > second}},
      surpassing(of, "High-pass without lowpass prefiltering", highpass, none, 0.85),
      surpassing(of, "High-pass with lowpass prefiltering", lowpass_highpass, lowpass, 0.55),
      {"High-pass: NCC, ZNCC, MOR, ZNSSD good at small disparities; SAD, SSD, ZSAD, ZSSD medium.",
       {of.error(and_znssd(kCrossGroup), highpass, 0.5), of_zero, of_local},
       "Error at 0.5 px: {:.3f}, {:.3f}, of LSAD, LSSD, NSAD {:.3f}",
       "In this order; partly: the former",
       {first < second && second < third, first < second}},
      {"High-pass: LSAD, LSSD, NSAD are very bad and should not be used.",
       {of.smallest_error_of_local(highpass), of_local, of_zero},
       "Smallest error of all three {:.3f} px",
       "Above 0.15 px for every D50 from 0.2 px on, worse than the others; partly: the latter",
       {first > 0.15 && second > third, second > third}},
      {"NSAD performs well on grey values, very poorly on high-pass filtered images.",
       {over_cross(none), over_cross(highpass)},
       "Error at 0.8 px over that of NCC, ZNCC, MOR: {:.2f} and {:.2f}",
       "Below 1.25 and above 1.5; partly: worse after the high-pass",
       {first < 1.25 && second > 1.5, second > first},
       "NSAD is good on grey values and useless after a high-pass"},
  };
}

Table kernels_of_grey(const Measures& of) {
  const auto order = [&](Prefilter a, int kernel_a, Prefilter b, int kernel_b, const Names& names) {
    return rank_correlation(of.errors_of_all(a, kernel_a, names), of.errors_of_all(b, kernel_b, names));
  };
  Names but_nsad = kGreyCriteria;
  std::erase(but_nsad, "NSAD");
  return {
      {"With a kernel of 13×13 the ordering of the correlation methods remains the same.",
       {order(none, of.large, none, 9, kGreyCriteria), order(highpass, of.large, highpass, 9, kGreyCriteria)},
       "Rank correlation with 9×9, errors at 1 px of all methods: {:.2f} on grey values, {:.2f} on high-pass filtered "
       "images",
       "Both at least 0.9; partly: 0.7",
       {first >= 0.9 && second >= 0.9, first >= 0.7 && second >= 0.7},
       "larger windows keep the order of the criteria"},
      {"The order of the methods is the same for all prefilters with one exception (NSAD).",
       {order(lowpass, 9, none, 9, but_nsad), order(highpass, 9, none, 9, but_nsad),
        order(lowpass_highpass, 9, none, 9, but_nsad)},
       "Rank correlation with that on grey values, without NSAD: low-pass {:.2f}, high-pass {:.2f}, both {:.2f}",
       "All at least 0.9; partly: all at least 0.5",
       {first >= 0.9 && second >= 0.9 && third >= 0.9, first >= 0.5 && second >= 0.5 && third >= 0.5},
       "the order of the criteria is the same for all prefilters"},
      {"The methods on grey values are more alike with larger kernels.",
       {of.spread(none), of.spread(none, of.large)},
       "Best to worst at 0.8 px: {:.3f} px with 9×9, {:.3f} with 13×13",
       "Smaller by 5 % at least; partly: smaller",
       {second < 0.95 * first, second < first}},
      {"Low-pass with small kernels helps only bad methods; good ones (DSAD) get slightly worse.",
       {of.ratio("DSAD", lowpass, none, 0.6, of.small), of.ratio(kDifferenceGroup, lowpass, none, 0.8, of.small),
        of.small},
       "{2}×{2}: DSAD {0:.2f} times at 0.6 px, differences {1:.2f} times at 0.8 px",
       "Above 1 and below 1; partly: one of them",
       {first > 1 && second < 1, first > 1 || second < 1}},
      {"DSAD 9×9: a low-pass is of advantage above 1 px.",
       {of.ratio("DSAD", lowpass, none, 1.4)},
       "{:.2f} times the error at 1.4 px",
       "At most 0.95 times; partly: below 1",
       {first <= 0.95, first < 1}},
  };
}

Table kernels_of_highpass(const Measures& of) {
  const auto flat = [&](int kernel) {
    return of.last_of(4, [&](double d50) { return of.error("NCC", highpass, d50, kernel) <= 0.1; });
  };
  int better = 0;
  std::string ratios;
  for (const int kernel : of.kernels) {
    const double one = of.ratio(kGreyCriteria, lowpass_highpass, highpass, 0.8, kernel);
    better += one < 1 ? 1 : 0;
    ratios += fmt::format("{}{:.2f}", ratios.empty() ? "" : ", ", one);
  }
  const int next = of.kernels[1];
  const int before_last = of.kernels[of.kernels.size() - 2];
  const auto cross = [&](Prefilter prefilter, int kernel) { return of.error(kCrossGroup, prefilter, 0.8, kernel); };
  return {
      {"High-pass: large kernels widen the flat zone and lower the smallest error.",
       {flat(of.small), flat(of.large), of.found.of("NCC", highpass, of.small).smallest_error(0.2),
        of.found.of("NCC", highpass, of.large).smallest_error(0.2), of.small, of.large},
       "NCC, {4}×{4} to {5}×{5}: error below 0.1 up to {0:.2f}, {1:.2f} px; smallest {2:.3f}, {3:.3f} px",
       "Both; partly: a lower smallest error",
       {second > first && fourth < third, fourth < third}},
      {"High-pass: a low-pass before it improves with every kernel.",
       {better, of.kernels.size(), ratios},
       "Mean error at 0.8 px, smallest to largest kernel: {2} times",
       "All; partly: half of them",
       {first >= second, 2 * first >= second}},
      {"High-pass: the next larger kernel is worth more than a low-pass for small kernels, less for large ones.",
       {cross(highpass, next), cross(lowpass_highpass, of.small), cross(highpass, of.large),
        cross(lowpass_highpass, before_last), of.small, next, before_last, of.large},
       "Cross correlation at 0.8 px: {4}→{5} {0:.3f}, {4} with low-pass {1:.3f}; {6}→{7} {2:.3f}, {6} with low-pass "
       "{3:.3f} px",
       "Both; partly: one of them",
       {first < second && fourth < third, first < second || fourth < third}},
  };
}

}  // namespace

Table family_statements(const Measures& of) {
  // Nishihara's has a parameter to choose.
  const auto best_nish = [&](double d50) {
    double least = study::Detection::kLargest_px;
    for (const auto& [setting, detection] : of.found.all())
      if (setting.criterion->name() == "NISH" && setting.kernel == 9 && setting.filter == study::ResultFilter::none)
        least = std::min(least, detection.segmentation_error(d50));
    return least;
  };
  const auto smallest = [&](const char* name, Prefilter prefilter) {
    return of.found.of(name, prefilter).smallest_error(0.2);
  };
  const auto nish = [&](double d50) { return of.found.nish(5).segmentation_error(d50); };
  const auto nisd = [&](double d50) { return of.found.nisd(5).segmentation_error(d50); };
  return {
      {"CCF is not useful with real non-preprocessed images because it very much depends on the brightness (8.1.1).",
       {smallest("CCF", none), smallest("NCC", none), of.good_up_to({"NCC"}, kBad)},
       "Smallest error {:.2f} px; NCC, which is CCF with the brightness divided out, {:.2f} px, and up to 0.3 until a D50 of "
       "{:.2f} px",
       "For every D50 from 0.2 px on above 0.3 px, bad, and NCC's smallest below 0.2 px, good; partly: twice NCC's",
       {first > kBad && second < kGood, first > 2 * second}},
      {"Highpass filters make the use of simpler functions possible, but should be combined with criteria invariant to "
       "brightness scaling (8.1.2).",
       {smallest("CCF", none), smallest("CCF", highpass), smallest("NCC", highpass)},
       "Smallest error: CCF {:.2f} px on grey values, {:.2f} px after the high-pass, NCC {:.2f} px after it",
       "CCF bad (above 0.3 px for every D50 from 0.2 px on) on grey values, tolerable for some after the high-pass, and NCC "
       "better still; partly: CCF better after the high-pass, NCC better still",
       {first > kBad && second <= kBad && third < second, second < first && third < second}},
      {"Nack's correlation is outperformed by Nishihara's (8.1.4).",
       {of.found.nack().segmentation_error(0.5), best_nish(0.5), of.found.nack().segmentation_error(1), best_nish(1)},
       "Error {:.3f} px against {:.3f} px (NISH with the best w) at 0.5 px; {:.3f} against {:.3f} px at 1 px",
       "NISH's lower at both; partly: at one",
       {second < first && fourth < third, second < first || fourth < third}},
      {"Ours, for the thesis defines neither NIS nor NISD of Table 8.5: NISD as the sign of a difference of Gaussians is "
       "NISH (8.1.4).",
       {nisd(0.5) / nish(0.5), nisd(1) / nish(1)},
       "Error {:.2f} times NISH's at 0.5 px, {:.2f} times at 1 px (w = 5)",
       "Within 10 %; partly: 30 %",
       {near(first, 1, 0.1) && near(second, 1, 0.1), near(first, 1, 0.3) && near(second, 1, 0.3)}},
  };
}

Tables criteria_statements(const Measures& of) {
  return {criteria_on_grey(of), criteria_on_highpass(of), kernels_of_grey(of), kernels_of_highpass(of)};
}

}  // namespace horopter::cli
