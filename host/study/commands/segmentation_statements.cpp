// SPDX-License-Identifier: Apache-2.0
// What 8.4 and 11.2 say about segmentation, each against our figures by a rule.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "segmentation.hpp"
#include "statements.hpp"

namespace horopter::cli {
namespace {

using study::Detection;
using study::ResultFilter;

constexpr double kGood = 0.2;  ///< 8.4.2: a segmentation error below shows a good segmentation capability
constexpr double kBad = 0.3;   ///< and one above a bad one

/// Eq. 8.9 with the detection rates of normal distributions (8.8) of the measured means and deviations.
double gaussian_error(const Detection& detection, double d50_px) {
  const auto& places = detection.disparities_px();
  double threshold = detection.histograms().front().mean();
  for (std::size_t i = 1; i < places.size(); ++i)
    if (places[i] <= d50_px + 1e-9) threshold = detection.histograms()[i].mean();
  const auto rate = [&](std::size_t i) {
    const auto& histogram = detection.histograms()[i];
    const double deviation = std::max(1e-12, histogram.deviation());
    return 0.5 * std::erfc((histogram.mean() - threshold) / (deviation * std::numbers::sqrt2));
  };
  double error = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double mean = (rate(i - 1) + rate(i)) / 2;
    error += (places[i] - places[i - 1]) * (places[i] <= d50_px + 1e-9 ? 1 - mean : mean);
  }
  return error;
}

double mean_at(const Detection& detection, double disparity_px) {
  const auto& places = detection.disparities_px();
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i] < disparity_px - 1e-9) continue;
    const double part = (disparity_px - places[i - 1]) / (places[i] - places[i - 1]);
    return detection.histograms()[i - 1].mean() * (1 - part) + detection.histograms()[i].mean() * part;
  }
  return detection.histograms().back().mean();
}

/// Judges what was found.
class Judge {
 public:
  Judge(const Segmentation& found, const std::vector<int>& kernels, const std::vector<double>& log_w_px,
        Statements& statements)
      : found_(found), kernels_(kernels), log_w_px_(log_w_px), out_(statements) {}

  void all() {
    measures();
    prefilters();
    binary();
    criteria_on_grey();
    criteria_on_highpass();
    kernels();
    result_filters();
    thickness();
  }

 private:
  using Names = std::vector<std::string>;

  double error(const std::string& name, Prefilter prefilter, double d50, int kernel = 9,
               ResultFilter filter = ResultFilter::none) const {
    return found_.of(name, prefilter, kernel, filter).segmentation_error(d50);
  }
  double group(const Names& names, Prefilter prefilter, double d50, int kernel = 9,
               ResultFilter filter = ResultFilter::none) const {
    double sum = 0;
    for (const std::string& name : names) sum += error(name, prefilter, d50, kernel, filter);
    return sum / static_cast<double>(names.size());
  }
  double spread(const Names& names, Prefilter prefilter, double d50, int kernel = 9) const {
    double low = 1e9;
    double high = 0;
    for (const std::string& name : names) {
      low = std::min(low, error(name, prefilter, d50, kernel));
      high = std::max(high, error(name, prefilter, d50, kernel));
    }
    return high - low;
  }
  /// Largest D50 up to which the group's mean error stays within a limit.
  double good_up_to(const Names& names, Prefilter prefilter, double limit) const {
    double last = 0;
    for (int i = 2; i <= 40; ++i) {
      const double d50 = i * 0.05;
      if (group(names, prefilter, d50) > limit) break;
      last = d50;
    }
    return last;
  }

  void measures() {
    const Detection& dsad = found_.of("DSAD", Prefilter::lowpass);
    const Detection& nsad = found_.of("NSAD", Prefilter::highpass);
    {
      int linear = 0;
      int count = 0;
      std::string curved;
      const auto judge = [&](const std::string& name, Prefilter prefilter, const char* label) {
        const Detection& one = found_.of(name, prefilter);
        const double first = mean_at(one, 0.4) - mean_at(one, 0.2);
        const double second = mean_at(one, 0.8) - mean_at(one, 0.6);
        ++count;
        if (std::abs(second / first - 1) <= 0.25) {
          ++linear;
        } else if (curved.size() < 60) {
          curved += (curved.empty() ? "" : ", ") + name + label;
        }
      };
      for (const std::string& name : grey_criteria) {
        judge(name, Prefilter::none, "");
        judge(name, Prefilter::highpass, " HP");
      }
      judge("DSAD", Prefilter::lowpass, "");
      out_.add("8.4.2", "For all methods the mean correlation value rises linearly with disparity near 0.",
               fmt::format("Linear in {} of {}; not: {}, … (a square or a product is parabolic near 0)", linear, count,
                           curved),
               verdict(linear == count, 2 * linear >= count),
               "Slope of the mean from 0.6 to 0.8 px within 25 % of that from 0.2 to 0.4 px; partly: in half of them");
    }
    {
      const double smallest = nsad.smallest_error(0.2);
      out_.add("8.4.2", "NSAD on high-pass filtered images: the smallest segmentation error is above 0.15.",
               fmt::format("{:.3f} px", smallest), verdict(smallest > 0.15, smallest > 0.1),
               "Above 0.15 px for every D50 from 0.2 px on; partly: above 0.1");
      int sharp = 0;
      for (int i = 2; i <= 20; ++i) {
        const double threshold = nsad.threshold(i / 10.0);
        if (nsad.rate(threshold, 0) >= 0.99 && nsad.rate(threshold, study::Detection::kLargest_px) <= 0.01) ++sharp;
      }
      out_.add("8.4.2", "NSAD on high-pass filtered images: no threshold takes the detection rate from 100 % to 0 %.",
               fmt::format("{} of 19 thresholds (D50 = 0.2 … 2.0 px) do", sharp), verdict(sharp == 0, sharp < 5),
               "None has 99 % at 0 px and 1 % at 2.8 px; partly: fewer than 5");
    }
    {
      const double first = (mean_at(dsad, 0.8) - mean_at(dsad, 0.4)) / 0.4;
      const double last = (mean_at(dsad, 2.8) - mean_at(dsad, 2.4)) / 0.4;
      out_.add("8.4.2", "DSAD: the gradient of the mean is almost constant up to 3 px.",
               fmt::format("At 2.6 px {:.0f} % of that at 0.6 px: the mean bends as directions become independent",
                           100 * last / first),
               verdict(last / first >= 0.75, last / first >= 0.5),
               "At least 75 % of the slope at 0.6 px left at 2.6 px; partly: 50 %");
      double sx = 0;
      double sy = 0;
      double sxx = 0;
      double syy = 0;
      double sxy = 0;
      double n = 0;
      for (std::size_t i = 0; i < dsad.disparities_px().size(); ++i) {
        const double x = dsad.disparities_px()[i];
        if (x < 0.2) continue;
        const double y = dsad.histograms()[i].deviation();
        sx += x;
        sy += y;
        sxx += x * x;
        syy += y * y;
        sxy += x * y;
        ++n;
      }
      const double r = (n * sxy - sx * sy) / std::sqrt((n * sxx - sx * sx) * (n * syy - sy * sy));
      out_.add("8.4.2", "DSAD: the standard deviation increases linearly in the same range.",
               fmt::format("Correlation of deviation and disparity {:.3f}", r), verdict(r >= 0.98, r >= 0.8),
               "Correlation coefficient from 0.2 to 2.8 px at least 0.98; partly: 0.8");
    }
    {
      const double at_one = dsad.segmentation_error(1);
      out_.add("8.4.2", "DSAD at D50 = 1 px: errors up to about 0.1, a very good segmentation.",
               fmt::format("{:.3f} px", at_one), verdict(at_one <= 0.12, at_one < kGood),
               "At most 0.12 px; partly: below 0.2, still good by the thesis's measure");
      const double at_more = dsad.segmentation_error(1.5);
      out_.add("8.4.2", "DSAD: segmentation above 1.5 px (error > 0.3) gives intolerable results.",
               fmt::format("At 1.5 px {:.3f} px", at_more), verdict(at_more > kBad, at_more > kGood),
               "Above 0.3 px; partly: above 0.2, no longer good");
    }
    {
      double low = 10;
      double high = 0;
      for (const double d50 : {0.6, 0.8, 1.0, 1.2}) {
        const double ratio = dsad.ten_ninety_px(d50).value_or(0) / dsad.segmentation_error(d50);
        low = std::min(low, ratio);
        high = std::max(high, ratio);
      }
      out_.add("8.4.2", "The 10/90 disparity is 16/5 of the segmentation error for a linear detection rate.",
               fmt::format("DSAD, D50 = 0.6 … 1.2 px: {:.2f} … {:.2f}", low, high),
               verdict(low >= 3.0 && high <= 3.4, low >= 2.7 && high <= 3.7),
               "Between 3.0 and 3.4; partly: 2.7 to 3.7");
      double least = 1e9;
      double most = 0;
      for (const double d50 : {0.4, 0.6, 0.8, 1.0, 1.2, 1.4}) {
        const double threshold = dsad.threshold(d50);
        const double gradient = (dsad.rate(threshold, d50 - 0.1) - dsad.rate(threshold, d50 + 0.1)) / 0.2;
        const double product = gradient * dsad.segmentation_error(d50);
        least = std::min(least, product);
        most = std::max(most, product);
      }
      out_.add("8.4.2", "The segmentation error is about in inverse proportion to the gradient of the detection rate.",
               fmt::format("DSAD, D50 = 0.4 … 1.4 px: their product {:.3f} … {:.3f}", least, most),
               verdict(most / least <= 1.3, most / least <= 1.6),
               "Largest product at most 1.3 times the smallest; partly: 1.6 times");
    }
    {
      const auto departure = [&](const std::string& name, Prefilter prefilter) {
        const Detection& one = found_.of(name, prefilter);
        return std::abs(gaussian_error(one, 1) / one.segmentation_error(1) - 1);
      };
      const std::array near{departure("DSAD", Prefilter::lowpass), departure("ZNSSD", Prefilter::none),
                            departure("NCC", Prefilter::highpass), departure("ZNCC", Prefilter::highpass),
                            departure("SAD", Prefilter::highpass)};
      const double worst = *std::max_element(near.begin(), near.end());
      out_.add(
          "8.4.2", "DSAD, ZNSSD and criteria on high-pass filtered images have almost Gaussian histograms.",
          fmt::format("Error from mean and deviation off by: DSAD {:.0f} %, ZNSSD {:.0f} %, high-passed NCC {:.0f} "
                      "%, ZNCC {:.0f} %, SAD {:.0f} %",
                      100 * near[0], 100 * near[1], 100 * near[2], 100 * near[3], 100 * near[4]),
          verdict(worst <= 0.15, near[0] <= 0.15),
          "Segmentation error at 1 px by normal distributions within 15 % for all; partly: for DSAD");
      const double lssd = departure("LSSD", Prefilter::highpass);
      const double lsad = departure("LSAD", Prefilter::highpass);
      const double local = departure("NSAD", Prefilter::highpass);
      const double least = std::min({lssd, lsad, local});
      const double most = std::max({lssd, lsad, local});
      out_.add("8.4.2", "LSSD, LSAD and NSAD on high-pass filtered images: mean and deviation give wrong results.",
               fmt::format("Off by {:.0f} %, {:.0f} %, {:.0f} %", 100 * lssd, 100 * lsad, 100 * local),
               verdict(least > 0.15, most > 0.15), "All off by more than 15 % at D50 = 1 px; partly: one is");
    }
  }

  void prefilters() {
    using enum Prefilter;
    {
      const double near = error("SAD", lowpass, 0.3) / error("SAD", none, 0.3);
      const double far = error("SAD", lowpass, 1.2) / error("SAD", none, 1.2);
      out_.add("8.4.3", "Low-pass before SAD: slightly higher error for small D50, significantly lower for large ones.",
               fmt::format("{:.2f} times at 0.3 px, {:.2f} times at 1.2 px", near, far),
               verdict(near >= 1 && far <= 0.95, near >= 1 || far <= 0.95),
               "At least 1 at 0.3 px and at most 0.95 at 1.2 px; partly: one of them");
    }
    {
      const double at_one = error("DSAD", lowpass, 1) / error("DSAD", none, 1);
      const double far = error("DSAD", lowpass, 1.4) / error("DSAD", none, 1.4);
      out_.add("8.4.3", "DSAD: the low-pass improves significantly above a segmentation disparity of 1 px.",
               fmt::format("{:.2f} times the error at 1.0 px, {:.2f} times at 1.4 px", at_one, far),
               verdict(far <= 0.9, far < 1), "At most 0.9 times at 1.4 px; partly: below 1");
      const auto effect = [&](const Names& names, Prefilter with, Prefilter without) {
        double sum = 0;
        for (const std::string& name : names) sum += std::abs(error(name, with, 1) / error(name, without, 1) - 1);
        return sum / static_cast<double>(names.size());
      };
      const double grey = effect(grey_criteria, lowpass, none);
      const double direction = std::abs(at_one - 1);
      const double high = effect(grey_criteria, lowpass_highpass, highpass);
      out_.add("8.4.3",
               "The low-pass's effect on DSAD is greater than on grey values, smaller than on high-passed ones.",
               fmt::format("Change of the error at 1 px: grey {:.0f} %, DSAD {:.0f} %, high-passed {:.0f} %",
                           100 * grey, 100 * direction, 100 * high),
               verdict(grey < direction && direction < high, direction < high), "In this order; partly: the latter");
    }
    {
      bool small = true;
      bool large = true;
      std::string figure;
      for (const char* name : {"NCC", "ZSSD"}) {
        const double near = error(name, highpass, 0.3) / error(name, none, 0.3);
        const double far = error(name, highpass, 1.2) / error(name, none, 1.2);
        small = small && near < 1;
        large = large && far > 1;
        figure += fmt::format("{}{}: {:.2f} times at 0.3 px, {:.2f} times at 1.2 px", figure.empty() ? "" : "; ", name,
                              near, far);
      }
      out_.add("8.4.3", "The high-pass (NCC, ZSSD): a smaller error for small D50, steeper and more curved after.",
               figure, verdict(small && large, small || large),
               "Below 1 at 0.3 px and above 1 at 1.2 px, both; partly: one");
    }
    {
      int worse = 0;
      std::string figure;
      for (const std::string& name : local_group) {
        const double ratio = error(name, highpass, 0.8) / error(name, none, 0.8);
        worse += ratio > 1 ? 1 : 0;
        figure += fmt::format("{}{} {:.1f} times", figure.empty() ? "" : ", ", name, ratio);
      }
      out_.add("8.4.3", "LSAD, LSSD and NSAD get worse by high-pass filtering.", "Error at 0.8 px: " + figure,
               verdict(worse == 3, worse > 0), "All three; partly: one or two");
    }
    {
      int better = 0;
      double before = 0;
      double after = 0;
      for (const std::string& name : grey_criteria) {
        const auto left = [&](Prefilter prefilter) {
          const Detection& one = found_.of(name, prefilter);
          return one.rate(one.threshold(1), Detection::kLargest_px);
        };
        better += left(lowpass_highpass) < left(highpass) ? 1 : 0;
        before += left(highpass) / static_cast<double>(grey_criteria.size());
        after += left(lowpass_highpass) / static_cast<double>(grey_criteria.size());
      }
      out_.add(
          "8.4.3", "With a low-pass before the high-pass the detection rate converges to 0 %; without, it does not.",
          fmt::format("Left at 2.8 px with D50 = 1 px: {:.1f} % without, {:.1f} % with; lower for {} of {} criteria",
                      100 * before, 100 * after, better, grey_criteria.size()),
          verdict(better == static_cast<int>(grey_criteria.size()) && after <= before / 2, after < before),
          "Lower for all and halved on average; partly: lower on average");
    }
    {
      Names cross = cross_group;
      cross.push_back("ZNSSD");
      const auto gain = [&](const Names& names) {
        return 1 - group(names, lowpass_highpass, 0.8) / group(names, highpass, 0.8);
      };
      const double of_cross = gain(cross);
      const double of_zero = gain(zero_mean_group);
      const double of_local = gain(local_group);
      out_.add("8.4.3", "Low-pass before high-pass: NCC, ZNCC, MOR, ZNSSD improve most.",
               fmt::format(
                   "Error at 0.8 px lower by {:.0f} %; SAD, SSD and zero-mean ones {:.0f} %, LSAD, LSSD, NSAD {:.0f} %",
                   100 * of_cross, 100 * of_zero, 100 * of_local),
               verdict(of_cross > of_zero && of_cross > of_local, of_cross > of_zero || of_cross > of_local),
               "More than both other groups; partly: than one");
      out_.add("8.4.3", "Low-pass before high-pass: SAD, SSD, ZSAD, ZSSD improve slightly.",
               fmt::format("Error at 0.8 px lower by {:.0f} %", 100 * of_zero),
               verdict(of_zero > 0 && of_zero <= 0.3, of_zero > 0), "By up to 30 %; partly: by more");
      double smallest = 10;
      for (const std::string& name : local_group)
        smallest = std::min(smallest, found_.of(name, lowpass_highpass).smallest_error(0.2));
      out_.add("8.4.3",
               "Low-pass before high-pass: LSAD, LSSD, NSAD improve slightly, their smallest error stays very high.",
               fmt::format("Lower by {:.0f} % at 0.8 px; smallest error {:.3f} px", 100 * of_local, smallest),
               verdict(of_local > 0 && smallest > 0.15, of_local > 0 || smallest > 0.15),
               "Lower, and above 0.15 px for every D50 from 0.2 px on; partly: one of them");
    }
  }

  void binary() {
    const double small = log_w_px_.front();
    const double large = log_w_px_.back();
    const auto ratio = [&](double d50, int kernel) {
      return found_.nish(large, kernel).segmentation_error(d50) / found_.nish(small, kernel).segmentation_error(d50);
    };
    const double near = ratio(0.4, 9);
    const double far = ratio(1.2, 9);
    out_.add("8.4.3", "NISH: small w behaves like a high-pass (small errors at small D50), large w tolerates more.",
             fmt::format("Error with w = {:g} over that with w = {:g}: {:.2f} at 0.4 px, {:.2f} at 1.2 px", large,
                         small, near, far),
             verdict(near > 1 && far<1, near> far), "Above 1 at 0.4 px and below 1 at 1.2 px; partly: falling");
    const double steeper = ratio(1.2, kernels_.front());
    const double flatter = ratio(1.2, kernels_.back());
    out_.add("8.4.3", "NISH: this holds for all kernels, and more so for small ones.",
             fmt::format("At 1.2 px: {:.2f} with {}×{}, {:.2f} with {}×{}", steeper, kernels_.front(), kernels_.front(),
                         flatter, kernels_.back(), kernels_.back()),
             verdict(steeper < flatter && flatter < 1, steeper < flatter),
             "Below 1 for both, smaller for the small kernel; partly: smaller");
    const auto slope = [&](double w) {
      const Detection& one = found_.nish(w);
      return mean_at(one, 0.6) - mean_at(one, 0.2);
    };
    out_.add("8.4.3", "NISH: a large w makes the correlation more tolerant to translation (Fig. 8.9).",
             fmt::format("The mean falls {:.1f} times as fast with w = {:g} as with {:g}", slope(small) / slope(large),
                         small, large),
             verdict(slope(small) > 1.2 * slope(large), slope(small) > slope(large)),
             "At least 1.2 times; partly: faster");
  }

  void criteria_on_grey() {
    using enum Prefilter;
    for (const Prefilter prefilter : {none, lowpass}) {
      const double dsad = error("DSAD", prefilter, 1);
      const double cross = group(cross_group, prefilter, 1);
      const double plain = group(difference_group, prefilter, 1);
      out_.add("8.4.4",
               fmt::format("{}, 9×9: DSAD is best, then the normalised cross correlation, then the differences without "
                           "normalisation.",
                           prefilter == none ? "Grey values" : "Low-pass filtered grey values"),
               fmt::format("Error at 1 px: {:.3f}, {:.3f}, {:.3f} px", dsad, cross, plain),
               verdict(dsad < cross && cross < plain, dsad < cross && dsad < plain),
               "In this order; partly: DSAD best. Holds with uneven illumination only");
    }
    const double normalised = good_up_to(normalised_group, none, kGood);
    const double plain = good_up_to(difference_group, none, kGood);
    out_.add("8.4.4", "NCC, ZNCC, MOR, ZNSSD, NSAD: tolerable up to 0.9 to 1.0 px.",
             fmt::format("Mean error up to 0.2 until {:.2f} px, up to 0.3 until {:.2f} px", normalised,
                         good_up_to(normalised_group, none, kBad)),
             verdict(std::abs(normalised - 0.95) <= 0.15, normalised >= 0.6),
             "Error 0.2 (8.4.2: good) reached within 0.15 px of 0.95 px; partly: beyond 0.6 px");
    out_.add("8.4.4", "SAD, ZSAD, LSAD, SSD, ZSSD, LSSD: tolerable up to 0.7 px.",
             fmt::format("Mean error up to 0.2 until {:.2f} px, up to 0.3 until {:.2f} px", plain,
                         good_up_to(difference_group, none, kBad)),
             verdict(std::abs(plain - 0.7) <= 0.15, std::abs(plain - 0.7) <= 0.3),
             "Error 0.2 reached within 0.15 px of 0.7 px; partly: 0.3 px");
    const double before = spread(grey_criteria, none, 0.8);
    const double after = spread(grey_criteria, lowpass, 0.8);
    out_.add("8.4.4", "An additional low-pass makes the methods on grey values more alike.",
             fmt::format("Best to worst at 0.8 px: {:.3f} px without, {:.3f} with", before, after),
             verdict(after < 0.95 * before, after < before), "Smaller by 5 % at least; partly: smaller");
  }

  void criteria_on_highpass() {
    using enum Prefilter;
    const double grey = spread(grey_criteria, none, 0.8);
    const double high = spread(grey_criteria, highpass, 0.8);
    out_.add("8.4.4", "The methods differ much more on high-pass filtered images than on grey values.",
             fmt::format("Best to worst at 0.8 px: {:.3f} px against {:.3f}", high, grey),
             verdict(high > 1.5 * grey, high > grey), "1.5 times at least; partly: more");
    Names cross = cross_group;
    cross.push_back("ZNSSD");
    for (const auto& [prefilter, direction, expected] :
         {std::tuple{highpass, none, 0.55}, std::tuple{lowpass_highpass, lowpass, 0.85}}) {
      double last = 0;
      for (int i = 1; i <= 40; ++i) {
        const double d50 = i * 0.05;
        if (group(cross, prefilter, d50) < error("DSAD", direction, d50)) last = d50;
      }
      const double at_end = group(cross, prefilter, 1.5) / error("DSAD", direction, 1.5);
      out_.add("8.4.4",
               fmt::format("{}: DSAD is best, surpassed by NCC, ZNCC, MOR, ZNSSD up to {} px only.",
                           prefilter == highpass ? "High-pass" : "Low-pass, then high-pass", expected),
               fmt::format("Surpassed up to {:.2f} px; at 1.5 px their error is {:.1f} times DSAD's", last, at_end),
               verdict(std::abs(last - expected) <= 0.15 && at_end > 1, at_end > 1),
               "Limit within 0.15 px; partly: DSAD better at 1.5 px");
    }
    const double of_cross = group(cross, highpass, 0.5);
    const double of_zero = group(zero_mean_group, highpass, 0.5);
    const double of_local = group(local_group, highpass, 0.5);
    out_.add("8.4.4", "High-pass: NCC, ZNCC, MOR, ZNSSD good at small disparities; SAD, SSD, ZSAD, ZSSD medium.",
             fmt::format("Error at 0.5 px: {:.3f}, {:.3f}, of LSAD, LSSD, NSAD {:.3f}", of_cross, of_zero, of_local),
             verdict(of_cross < of_zero && of_zero < of_local, of_cross < of_zero),
             "In this order; partly: the former");
    double smallest = 10;
    for (const std::string& name : local_group)
      smallest = std::min(smallest, found_.of(name, highpass).smallest_error(0.2));
    out_.add("8.4.4", "High-pass: LSAD, LSSD, NSAD are very bad and should not be used.",
             fmt::format("Smallest error of all three {:.3f} px", smallest),
             verdict(smallest > 0.15 && of_local > of_zero, of_local > of_zero),
             "Above 0.15 px for every D50 from 0.2 px on, worse than the others; partly: the latter");
    const double on_grey = error("NSAD", none, 0.8) / group(cross_group, none, 0.8);
    const double on_high = error("NSAD", highpass, 0.8) / group(cross_group, highpass, 0.8);
    out_.add("8.4.4", "NSAD performs well on grey values, very poorly on high-pass filtered images.",
             fmt::format("Error at 0.8 px over that of NCC, ZNCC, MOR: {:.2f} and {:.2f}", on_grey, on_high),
             verdict(on_grey < 1.25 && on_high > 1.5, on_high > on_grey),
             "Below 1.25 and above 1.5; partly: worse after the high-pass");
  }

  void kernels() {
    using enum Prefilter;
    const int small = kernels_.front();
    const int large = kernels_.back();
    const auto in_order = [&](int kernel) {
      return error("DSAD", none, 1, kernel) < group(cross_group, none, 1, kernel) &&
             group(cross_group, none, 1, kernel) < group(difference_group, none, 1, kernel);
    };
    const bool same = in_order(9) == in_order(large);
    out_.add("8.4.4", "13×13: the order of the methods remains the same.",
             fmt::format("DSAD {:.3f}, cross correlation {:.3f}, differences {:.3f} px at 1 px",
                         error("DSAD", none, 1, large), group(cross_group, none, 1, large),
                         group(difference_group, none, 1, large)),
             verdict(same && in_order(large), same), "The order of Fig. 8.12's groups; partly: the same as with 9×9");
    const double of_small = spread(grey_criteria, none, 0.8, 9);
    const double of_large = spread(grey_criteria, none, 0.8, large);
    out_.add("8.4.4", "The methods on grey values are more alike with larger kernels.",
             fmt::format("Best to worst at 0.8 px: {:.3f} px with 9×9, {:.3f} with 13×13", of_small, of_large),
             verdict(of_large < 0.95 * of_small, of_large < of_small), "Smaller by 5 % at least; partly: smaller");
    const double dsad = error("DSAD", lowpass, 0.6, small) / error("DSAD", none, 0.6, small);
    const double sad = group(difference_group, lowpass, 0.8, small) / group(difference_group, none, 0.8, small);
    out_.add(
        "8.4.4", "Low-pass with small kernels helps only bad methods; good ones (DSAD) get slightly worse.",
        fmt::format("{0}×{0}: DSAD {1:.2f} times at 0.6 px, differences {2:.2f} times at 0.8 px", small, dsad, sad),
        verdict(dsad > 1 && sad < 1, dsad > 1 || sad < 1), "Above 1 and below 1; partly: one of them");
    const double raw = error("DSAD", lowpass, 1.4, 9) / error("DSAD", none, 1.4, 9);
    out_.add("8.4.4", "DSAD 9×9: a low-pass is of advantage above 1 px.",
             fmt::format("{:.2f} times the error at 1.4 px", raw), verdict(raw <= 0.95, raw < 1),
             "At most 0.95 times; partly: below 1");
    {
      const auto flat = [&](int kernel) {
        double last = 0;
        for (int i = 4; i <= 40; ++i)
          if (error("NCC", highpass, i * 0.05, kernel) <= 0.1) last = i * 0.05;
        return last;
      };
      const double least_small = found_.of("NCC", highpass, small).smallest_error(0.2);
      const double least_large = found_.of("NCC", highpass, large).smallest_error(0.2);
      out_.add("8.4.4", "High-pass: large kernels widen the flat zone and lower the smallest error.",
               fmt::format(
                   "NCC, {0}×{0} to {1}×{1}: error below 0.1 up to {2:.2f}, {3:.2f} px; smallest {4:.3f}, {5:.3f} px",
                   small, large, flat(small), flat(large), least_small, least_large),
               verdict(flat(large) > flat(small) && least_large < least_small, least_large < least_small),
               "Both; partly: a lower smallest error");
    }
    {
      int better = 0;
      std::string figure;
      for (const int kernel : kernels_) {
        const double ratio =
            group(grey_criteria, lowpass_highpass, 0.8, kernel) / group(grey_criteria, highpass, 0.8, kernel);
        better += ratio < 1 ? 1 : 0;
        figure += fmt::format("{}{:.2f}", figure.empty() ? "" : ", ", ratio);
      }
      out_.add("8.4.4", "High-pass: a low-pass before it improves with every kernel.",
               fmt::format("Mean error at 0.8 px, smallest to largest kernel: {} times", figure),
               verdict(better == static_cast<int>(kernels_.size()), better > 0), "All; partly: some");
    }
    const int next = kernels_[1];
    const int before_last = kernels_[kernels_.size() - 2];
    const double by_kernel = group(cross_group, highpass, 0.8, next);
    const double by_lowpass = group(cross_group, lowpass_highpass, 0.8, small);
    const double by_kernel_large = group(cross_group, highpass, 0.8, large);
    const double by_lowpass_large = group(cross_group, lowpass_highpass, 0.8, before_last);
    out_.add("8.4.4",
             "High-pass: the next larger kernel is worth more than a low-pass for small kernels, less for large ones.",
             fmt::format("Cross correlation at 0.8 px: {}→{} {:.3f}, {} with low-pass {:.3f}; {}→{} {:.3f}, {} with "
                         "low-pass {:.3f} px",
                         small, next, by_kernel, small, by_lowpass, before_last, large, by_kernel_large, before_last,
                         by_lowpass_large),
             verdict(by_kernel < by_lowpass && by_lowpass_large < by_kernel_large,
                     by_kernel < by_lowpass || by_lowpass_large < by_kernel_large),
             "Both; partly: one of them");
  }

  void result_filters() {
    using enum Prefilter;
    const auto gain = [&](const Names& names, Prefilter prefilter, int kernel, ResultFilter filter, double d50) {
      return 1 - group(names, prefilter, d50, kernel, filter) / group(names, prefilter, d50, kernel);
    };
    const int small = kernels_.front();
    const int large = kernels_.back();
    const double of_small = gain(grey_criteria, none, small, ResultFilter::lowpass, 0.6);
    const double of_large = gain(grey_criteria, none, large, ResultFilter::lowpass, 0.6);
    out_.add("8.4.5",
             "Filtering the result on grey values improves small kernels and has no effect on large ones (> 11×11).",
             fmt::format("Error at 0.6 px lower by {:.1f} % with {}×{}, {:.1f} % with {}×{}", 100 * of_small, small,
                         small, 100 * of_large, large, large),
             verdict(of_small >= 0.03 && std::abs(of_large) < 0.02, of_small > of_large),
             "At least 3 % and below 2 %; partly: more with the small kernel");
    const double by_median = gain(grey_criteria, none, small, ResultFilter::median, 0.6);
    out_.add("8.4.5", "Grey values: the low-pass on the result improves more than the median.",
             fmt::format("{0}×{0}, error at 0.6 px lower by {1:.1f} % and {2:.1f} %", small, 100 * of_small,
                         100 * by_median),
             verdict(of_small > by_median), "More");
    const double after = group(grey_criteria, none, 0.5, small, ResultFilter::lowpass);
    const double before = group(grey_criteria, lowpass, 0.5, small);
    out_.add("8.4.5", "For small kernels at small disparities filtering the result is better than a low-pass before.",
             fmt::format("{0}×{0} at 0.5 px: {1:.3f} px after, {2:.3f} before", small, after, before),
             verdict(after < before), "A smaller mean error");
    const double zero_nine = gain(zero_mean_group, highpass, 9, ResultFilter::lowpass, 0.6);
    const double zero_large = gain(zero_mean_group, highpass, large, ResultFilter::lowpass, 0.6);
    out_.add("8.4.5", "High-pass, SAD, SSD, ZSAD, ZSSD: filtering the result helps up to 9×9 only.",
             fmt::format("Error at 0.6 px lower by {:.1f} % with 9×9, {:.1f} % with {}×{}", 100 * zero_nine,
                         100 * zero_large, large, large),
             verdict(zero_nine >= 0.02 && zero_large<0.02, zero_nine> zero_large),
             "At least 2 % and below 2 %; partly: more with 9×9");
    const double local_median = gain(local_group, highpass, 9, ResultFilter::median, 0.8);
    const double local_low = gain(local_group, highpass, 9, ResultFilter::lowpass, 0.8);
    const double local_large = gain(local_group, highpass, large, ResultFilter::lowpass, 0.8);
    out_.add("8.4.5", "High-pass, LSAD, LSSD, NSAD: the median on the result is much better than the low-pass.",
             fmt::format("9×9, error at 0.8 px lower by {:.1f} % and {:.1f} %", 100 * local_median, 100 * local_low),
             verdict(local_median > local_low + 0.02, local_median > local_low),
             "By 2 points at least; partly: better");
    out_.add("8.4.5", "High-pass, LSAD, LSSD, NSAD: the low-pass on the result makes large kernels worse.",
             fmt::format("{0}×{0}, error at 0.8 px lower by {1:.1f} %", large, 100 * local_large),
             verdict(local_large < 0), "A larger mean error");
  }

  void thickness() {
    const Detection& dsad = found_.of("DSAD", Prefilter::lowpass);
    constexpr std::array d50{0.6, 0.8, 1.0, 1.2, 1.4, 1.6};
    constexpr std::array percent{11.3, 15.0, 18.4, 21.9, 25.1, 28.4};
    constexpr std::array d95{0.4, 0.6, 0.7, 0.9, 1.0, 1.1};
    std::string thresholds;
    std::string places;
    double worst = 0;
    double worst_place = 0;
    for (std::size_t i = 0; i < d50.size(); ++i) {
      const double threshold = dsad.threshold(d50[i]);
      const double ours = 100 * threshold / study::criterion("DSAD").worst(9);
      worst = std::max(worst, std::abs(ours - percent[i]));
      thresholds += fmt::format(" {:.1f}", ours);
      const double place = dsad.disparity_at(threshold, 0.95).value_or(0);
      worst_place = std::max(worst_place, std::abs(place - d95[i]));
      places += fmt::format(" {:.2f}", place);
    }
    out_.add("11.2.1", "Table 11.2: 11.3, 15.0, 18.4, 21.9, 25.1, 28.4 % of T_max detect half at 0.6, 0.8, … 1.6 px.",
             "DSAD LP 9×9:" + thresholds + " %", verdict(worst <= 1.5, worst <= 3),
             "Each within 1.5 points; partly: 3. The simulated lens's blur was chosen by the row of 1.0 px");
    out_.add("11.2.1", "Table 11.2: with these thresholds 95 % are detected at 0.4, 0.6, 0.7, 0.9, 1.0, 1.1 px.",
             "At" + places + " px", verdict(worst_place <= 0.1, worst_place <= 0.2), "Each within 0.1 px; partly: 0.2");
    bool rises = true;
    for (std::size_t i = 1; i < kernels_.size(); ++i) {
      const auto share = [&](int kernel) {
        return found_.of("DSAD", Prefilter::lowpass, kernel).threshold(1) / study::criterion("DSAD").worst(kernel);
      };
      rises = rises && std::abs(share(kernels_[i]) / share(kernels_[0]) - 1) < 0.1;
    }
    out_.add("11.2.1", "Fig. 11.6: the threshold follows from the segmentation disparity, for every kernel.",
             rises ? "In % of T_max for 1 px all kernels within 10 %"
                   : "In % of T_max for 1 px kernels differ by more than 10 %",
             verdict(rises, true), "Within 10 % of each other; else a threshold for each kernel: partly");
  }

  const Segmentation& found_;
  const std::vector<int>& kernels_;
  const std::vector<double>& log_w_px_;
  Statements& out_;
};

}  // namespace

void judge_segmentation(const Segmentation& found, const std::vector<int>& kernels, const std::vector<double>& log_w_px,
                        Statements& statements) {
  Judge(found, kernels, log_w_px, statements).all();
}

}  // namespace horopter::cli
