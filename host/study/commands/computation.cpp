// SPDX-License-Identifier: Apache-2.0
// Thesis 10.1, Table 10.1: the computing power that each step takes, counted operation by operation.
#include <fmt/format.h>

#include <vector>

#include "study.hpp"

namespace horopter::cli {
namespace {

constexpr double kX = 756;  // px
constexpr double kY = 286;
constexpr double kK = 4;  // of the 9×9 window
constexpr double kE = 2;  // of clusterlet elimination
constexpr double kImagesPerSecond = 50;

/// Counts of one step as its section lists them; memory accesses, and everything else.
struct Step {
  const char* name;
  const char* section;
  std::vector<double> memory;
  std::vector<double> operations;
  double printed_mmas;        ///< Table 10.1, million memory accesses a second
  double printed_operations;  ///< the table's formula for arithmetic operations, an image
};

std::vector<Step> steps() {
  const double rows = kY - 2;
  const double columns = kX / 2 - 2;  // of the sub-sampled images that a 3×3 window fills
  return {
      {"Transformation", "10.1.1", {5 * kX * kY}, {6 * kX * kY, 5 * kX * kY, 3 * kX * kY}, 55, 16 * kX * kY},
      {"Subsampling", "10.1.2", {kX * kY, 2 * kX * kY / 2}, {2 * kX * kY / 2, 2 * kX * kY / 2}, 22, 2 * kX * kY},
      {"Lowpass",
       "10.1.3",
       {2 * 3 * rows * kX / 2},
       {2 * 2 * rows * kX / 2, 2 * rows * kX / 2, 2 * 2 * rows * columns, 2 * 2 * rows * columns},
       33,
       2 * (7 * kX / 2 - 8) * rows},
      {"Sobel filtering",
       "10.1.4",
       {2 * 3 * rows * kX / 2, 2 * columns * rows, kX * kY / 2},
       {2 * 3 * rows * kX / 2, 2 * rows * kX / 2, 2 * 3 * columns * rows, 2 * columns * rows, 2 * 2 * columns * rows,
        2 * 3 * columns * rows, 2 * 2 * columns * rows, 2 * columns * rows, 2 * columns * rows, columns * rows},
       49,
       (35.0 / 2 * kX - 54) * rows},
      {"Correlation",
       "10.1.5",
       {2 * kK * kX / 2, (2 * (kX / 2 - 2 * kK) + 4 * kK) * (kY - 2 * kK)},
       {(2 * kK - 1) * kX / 2, (4 * (kX / 2 - 2 * kK) + 6 * kK - 1) * (kY - 2 * kK)},
       11,
       (2 * kK - 1) * kX / 2 + (kY - 2 * kK) * (2 * kX - 2 * kK - 1)},
      {"Texture analysis",
       "10.1.6",
       {(3 * rows + 1) * kX / 2},
       {kY * kX / 2, 2 * rows * (kX - 2), rows * (3 * kX / 2 - 4)},
       16,
       kY * kX / 2 + rows * (7.0 / 2 * kX - 8)},
      {"Segmentation and clusterlet elimination",
       "10.1.7",
       {kY * kX / 2, kY * kX / 32, 2.0 / 16 * (2 * kE + 1) * (kX / 2 - kE) * (kY - kE)},
       {kY * kX / 2, kY * kX / 2, 3 * (2 * kE + 1) * (kX / 2 - kE) * (kY - kE),
        (3 + 2 * kE) * (kX / 2 - kE) * (kY - kE), (kX / 2 - kE) * (kY - kE)},
       9,
       kX * kY + (7 + 8 * kE) * (kX / 2 - kE) * (kY - kE)},
  };
}

double millions(const std::vector<double>& counts) {
  double sum = 0;
  for (const double count : counts) sum += count;
  return sum * kImagesPerSecond * 1e-6;
}

/// Millions a second.
struct Total {
  double memory = 0, printed_memory = 0, operations = 0, printed_operations = 0;
};

Total of(const Step& step) {
  return {millions(step.memory), step.printed_mmas, millions(step.operations), millions({step.printed_operations})};
}

}  // namespace

void study_computation(StudyReport& report, const StudyScope& /*scope*/) {
  Csv table({"step", "section", "memory_accesses_million_per_s", "printed_memory_accesses", "operations_million_per_s",
             "operations_by_the_printed_formula"});
  const auto row = [&](const char* name, const char* section, const Total& one) {
    table.row(name, section, one.memory, one.printed_memory, one.operations, one.printed_operations);
    report.result["steps"][name] = {{"memory_accesses_million_per_s", one.memory},
                                    {"printed_memory_accesses", one.printed_memory},
                                    {"operations_million_per_s", one.operations},
                                    {"operations_by_the_printed_formula", one.printed_operations}};
  };
  Total total;
  for (const Step& step : steps()) {
    const Total one = of(step);
    row(step.name, step.section, one);
    total.memory += one.memory;
    total.printed_memory += one.printed_memory;
    total.operations += one.operations;
    total.printed_operations += one.printed_operations;
  }
  row("Total", "10.1", total);
  report.table("table-10-1.csv", table);
  using namespace measured;
  report.state("10.1", {{"The algorithm takes 195 million memory accesses a second at 756×286 and 50 images.",
                         {total.memory},
                         "{:.0f} million, counted as the sections list them",
                         "Within 2 %; partly: 10 %",
                         {near(first, 195, 0.02 * 195), near(first, 195, 0.1 * 195)},
                         "the whole method takes 195 M memory accesses a second"}});
  report.finding(
      "Counted as 10.1 lists them: {:.0f} million memory accesses a second (Table 10.1: {:.0f}) and {:.0f} million "
      "operations; by the formulas of the table, which has 16xy instead of 14xy for the transformation, {:.0f}",
      total.memory, total.printed_memory, total.operations, total.printed_operations);
}

}  // namespace horopter::cli
