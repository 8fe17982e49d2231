// SPDX-License-Identifier: Apache-2.0
// Table 8.5: operations of each criterion for an image of 378×286 pixels, by counting what its formula needs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "cost_times.hpp"
#include "curves.hpp"

namespace horopter::cli {
namespace {

constexpr double kPixels = 378.0 * 286;
constexpr int kKernel = 9;
constexpr double kWindow = kKernel * kKernel;
constexpr double kRunningSum = 4;  ///< 10.1.5: a column's and a window's sum gain one value and lose one
constexpr double kDivision = 6;    ///< as the thesis counts it

/// What one pixel needs. An operation is an addition, a multiplication, or both in one (MAC), as in 8.6.
struct Count {
  std::string_view name;
  double thesis_mega;  ///< of Table 8.5, 0: not there
  int sums;            ///< windows summed up
  double per_pixel;    ///< products, differences, and what follows the sums
  double per_window;   ///< for each pixel of the window: what no running sum can give
};

/// Means, variances and their differences follow from the sums of r, s, r², s², rs: Σ(r − r̄)(s − s̄) = Σrs − ΣrΣs/n.
/// Roots and quotients are avoided by squaring and multiplying the threshold (footnote 21).
constexpr std::array kCounts{
    Count{"CCF", 10.4, 1, 1, 0},
    Count{"SSD", 10.5, 1, 2, 0},
    Count{"SAD", 10.6, 1, 2, 0},
    Count{"CCFH", 10.9, 1, 1 + 2 * (kRunningSum + 1), 0},  // CCF, and two Laplacians: 9 times a pixel less its 3×3
    Count{"NCC", 11.6, 3, 3 + 3, 0},
    Count{"DSAD", 13.0, 1, 2 + 14 + 8 + kDivision + 3,
          0},                                        // two Sobels and low-passes (10.1), a quotient, a difference
    Count{"NISD", 16.5, 1, 1 + 2 * 2 * (7 + 7), 0},  // two separable Gaussians of 7 pixels for each image
    Count{"LSSD", 19.2, 5, 3 + kDivision + 5, 0},
    Count{"ZSSD", 26.9, 2, 2 + 2, 0},
    Count{"LSAD", 27.4, 2, kDivision, 3},
    Count{"ZSAD", 35.1, 1, 2, 3},
    Count{"NIS", 44.5, 1, 1 + 2 * 2 * (17 + 17), 0},  // two separable parts of 17 pixels (w = 5) for each image
    Count{"NSAD", 0, 3, 2 + 3, 0},
    Count{"MOR", 59.9, 5, 3 + 7, 0},
    Count{"ZNCC", 60.1, 5, 3 + 8, 0},
    Count{"ZNSSD", 60.2, 5, 3 + 9, 0},
};

double operations(const Count& count) {
  return count.sums * kRunningSum + count.per_pixel + count.per_window * kWindow;
}

/// Every window summed up anew.
double direct(const Count& count) { return (count.sums + count.per_window) * kWindow + count.per_pixel; }

double mega(std::string_view name) {
  return operations(*std::ranges::find(kCounts, name, &Count::name)) * kPixels / 1e6;
}
double direct_mega(std::string_view name) {
  return direct(*std::ranges::find(kCounts, name, &Count::name)) * kPixels / 1e6;
}

/// How alike the orders of Table 8.5 and of a count are.
double order(double (*count)(const Count&)) {
  std::vector<double> ours;
  std::vector<double> printed;
  for (const Count& one : kCounts) {
    if (one.thesis_mega == 0) continue;
    ours.push_back(count(one));
    printed.push_back(one.thesis_mega);
  }
  return rank_correlation(ours, printed);
}

std::vector<Statement> statements() {
  using namespace measured;
  return {{"Table 8.5: SAD needs 10.6 M operations for 378×286 pixels, partial sums being temporarily stored.",
           {mega("SAD"), direct_mega("SAD")},
           "{:.2f} M with running sums in both directions (10.1.5), {:.1f} M without",
           "Within 15 %; partly: every window summed up anew. The thesis's 98 a pixel are 81 and overhead",
           {near(first, 10.6, 0.15 * 10.6), near(second, 10.6, 0.15 * 10.6)},
           "SAD takes 10.6 M operations an image"},
          {"Table 8.5: the order of 15 criteria by their operations.",
           {order(operations), order(direct)},
           "Rank correlation {:.2f} with running sums, {:.2f} with every window summed up anew",
           "At least 0.9 with running sums; partly: 0.7 with either",
           {first >= 0.9, first >= 0.7 || second >= 0.7}},
          {"The zero-mean and mean scaled criteria need much higher computational resources, because the sum cannot be "
           "optimized by calculating partial sums.",
           {std::min(mega("ZSAD"), mega("LSAD")), std::min(mega("ZNCC"), mega("ZSSD")),
            std::max({mega("ZNCC"), mega("MOR"), mega("ZNSSD"), mega("ZSSD"), mega("LSSD")}), mega("DSAD"),
            mega("ZSAD"), mega("LSAD"), mega("ZNCC"), mega("ZNSSD"), mega("ZSSD"), mega("LSSD")},
           "ZSAD {4:.1f} M and LSAD {5:.1f} M do; ZNCC {6:.1f} M, ZNSSD {7:.1f} M, ZSSD {8:.1f} M and LSSD {9:.1f} M "
           "follow from the sums of r, s, r², s², rs",
           "All dearer than twice DSAD; partly: ZSAD and LSAD alone",
           {first > 2 * fourth && second > 2 * fourth, first > 2 * third},
           "criteria of zero mean need the sum of each window anew"},
          {"DSAD has low computational requirements: 13.0 M to SAD's 10.6 M (Table 8.5).",
           {mega("DSAD") / mega("SAD"), mega("DSAD") - mega("SAD"), mega("DSAD"), mega("SAD")},
           "{2:.1f} M to {3:.2f} M: with sums this cheap the gradients dominate",
           "At most 1.23 times, as in the table; partly: at most 1.5 times the table's 2.4 M more",
           {first <= 1.23, second <= 1.5 * 2.4},
           "DSAD costs little more than SAD"}};
}

}  // namespace

void study_cost(StudyReport& report, const StudyScope& scope) {
  Csv csv({"criterion", "operations_per_pixel", "without_running_sums", "mega_operations_per_image",
           "thesis_mega_operations"});
  report.result["conditions"] = {{"image", "378×286"}, {"kernel", kKernel}, {"division", kDivision}};
  for (const Count& count : kCounts) {
    csv.row(std::string(count.name), operations(count), direct(count), mega(count.name),
            count.thesis_mega > 0 ? fmt::format("{:.1f}", count.thesis_mega) : "");
    report.result["mega_operations"][std::string(count.name)] = mega(count.name);
  }
  report.table("table-8-5.csv", csv);
  if (scope.times) measure_times(report, scope);
  report.state("8.6", statements());
  report.finding("M operations for 378×286 pixels, 9×9: SAD {:.2f}, DSAD {:.2f}, ZNCC {:.2f}, ZSAD {:.1f}", mega("SAD"),
                 mega("DSAD"), mega("ZNCC"), mega("ZSAD"));
}

}  // namespace horopter::cli
