// SPDX-License-Identifier: Apache-2.0
// Table 8.5: operations of each criterion for an image of 378×286 pixels, by counting what its formula needs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "horopter/base/csv.hpp"
#include "statements.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

constexpr double kPixels = 378.0 * 286;
constexpr int kKernel = 9;
constexpr double kWindow = kKernel * kKernel;
constexpr double kRunningSum = 4;  ///< 10.1.5: a column's and a window's sum gain one value and lose one
constexpr double kDivision = 6;    ///< as the thesis counts it

/// What one pixel needs. An operation is an addition, a multiplication, or both in one (MAC), as in 8.6.
struct Count {
  const char* name;
  double thesis_mega;  ///< of Table 8.5, 0: not there
  int sums;            ///< windows summed up
  double per_pixel;    ///< products, differences, and what follows the sums
  double per_window;   ///< for each pixel of the window: what no running sum can give
};

/// Means, variances and their differences follow from the sums of r, s, r², s², rs: Σ(r − r̄)(s − s̄) = Σrs − ΣrΣs/n.
/// Roots and quotients are avoided by squaring and multiplying the threshold (footnote 21).
constexpr std::array counts{
    Count{"CCF", 10.4, 1, 1, 0},
    Count{"SSD", 10.5, 1, 2, 0},
    Count{"SAD", 10.6, 1, 2, 0},
    Count{"NCC", 11.6, 3, 3 + 3, 0},
    Count{"DSAD", 13.0, 1, 2 + 14 + 8 + kDivision + 3,
          0},  // two Sobels and low-passes (10.1), a quotient, a difference
    Count{"ZSSD", 26.9, 2, 2 + 2, 0},
    Count{"LSSD", 19.2, 5, 3 + kDivision + 5, 0},
    Count{"LSAD", 27.4, 2, kDivision, 3},
    Count{"ZSAD", 35.1, 1, 2, 3},
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

}  // namespace

nlohmann::json study_cost(OutputDirectory& directory, const StudyScope&) {
  Csv csv({"criterion", "operations_per_pixel", "without_running_sums", "mega_operations_per_image",
           "thesis_mega_operations"});
  nlohmann::json result{{"conditions", {{"image", "378×286"}, {"kernel", kKernel}, {"division", kDivision}}}};
  for (const Count& count : counts) {
    csv << count.name << operations(count) << direct(count) << operations(count) * kPixels / 1e6
        << (count.thesis_mega > 0 ? fmt::format("{:.1f}", count.thesis_mega) : "");
    csv.end_row();
    result["mega_operations"][count.name] = operations(count) * kPixels / 1e6;
  }
  directory.write("table-8-5.csv", csv.text());
  const auto of = [&](const std::string& name) -> const Count& {
    for (const Count& count : counts)
      if (name == count.name) return count;
    throw std::out_of_range(name);
  };
  const auto mega = [&](const char* name) { return operations(of(name)) * kPixels / 1e6; };
  Statements statements;
  statements.add(
      "8.6", "Table 8.5: SAD needs 10.6 M operations for 378×286 pixels.",
      fmt::format("{:.2f} M with running sums in both directions (10.1.5), {:.1f} M without", mega("SAD"),
                  direct(of("SAD")) * kPixels / 1e6),
      verdict(mega("SAD") > 9 && mega("SAD") < 12, direct(of("SAD")) * kPixels / 1e6 < 2 * 10.6),
      "Within 15 %; partly: within a factor of 2 without running sums. The thesis's 98 a pixel are 81 and overhead");
  const double dearest = std::max({mega("ZNCC"), mega("MOR"), mega("ZNSSD"), mega("ZSSD"), mega("LSSD")});
  statements.add(
      "8.6", "Zero-mean and mean-scaled criteria need much more, for partial sums are impossible.",
      fmt::format(
          "ZSAD {:.1f} M and LSAD {:.1f} M do; ZNCC {:.1f} M, ZNSSD {:.1f} M, ZSSD {:.1f} M and LSSD {:.1f} M follow "
          "from the sums of r, s, r², s², rs",
          mega("ZSAD"), mega("LSAD"), mega("ZNCC"), mega("ZNSSD"), mega("ZSSD"), mega("LSSD")),
      verdict(std::min({mega("ZSAD"), mega("LSAD"), mega("ZNCC"), mega("ZSSD")}) > 2 * mega("DSAD"),
              std::min(mega("ZSAD"), mega("LSAD")) > 2 * dearest),
      "All dearer than twice DSAD; partly: ZSAD and LSAD alone");
  statements.add(
      "8.6", "DSAD costs little more than SAD or SSD (13.0 M to 10.6 M).",
      fmt::format("{:.1f} M to {:.2f} M: with sums this cheap the gradients dominate", mega("DSAD"), mega("SAD")),
      verdict(mega("DSAD") <= 1.5 * mega("SAD"), mega("DSAD") < mega("ZSAD")),
      "At most 1.5 times; partly: less than ZSAD");
  result["statements"] = statements.json();
  result["findings"] = {
      fmt::format("M operations for 378×286 pixels, 9×9: SAD {:.2f}, DSAD {:.2f}, ZNCC {:.2f}, ZSAD {:.1f}",
                  mega("SAD"), mega("DSAD"), mega("ZNCC"), mega("ZSAD"))};
  result["figures"] = nlohmann::json::array();
  return result;
}

}  // namespace horopter::cli
