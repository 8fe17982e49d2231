// SPDX-License-Identifier: Apache-2.0
#include "cost_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "conditions.hpp"

namespace horopter::cli {
namespace {

using study::Feature;

/// A criterion as Table 8.5 names it.
struct Timed {
  const char* name;
  const char* criterion;
  study::Preparation preparation;
};

std::vector<Timed> all() {
  std::vector<Timed> result;
  for (const char* name : {"CCF", "SSD", "SAD", "NCC", "LSSD", "ZSSD", "LSAD", "ZSAD", "NSAD", "MOR", "ZNCC", "ZNSSD"})
    result.push_back({name, name, {Feature::grey}});
  result.push_back({"CCFH", "CCF", {Feature::grey, false, true}});
  result.push_back({"DSAD", "DSAD", {Feature::direction, true}});
  result.push_back({"NISD", "NISD", {Feature::dog_sign, false, false, 5}});
  result.push_back({"NIS", "NISH", {Feature::log_sign, false, false, 5}});
  return result;
}

double ms_of(const Timed& timed, const Image& left, const Image& right) {
  constexpr int kRuns = 9;
  std::vector<double> ms;
  for (int run = 0; run < kRuns; ++run) {
    const auto start = std::chrono::steady_clock::now();
    const study::Plane r = prepare(left, timed.preparation);
    const study::Plane s = prepare(right, timed.preparation);
    study::Pair pair(r, s);
    pair.set_kernel(9);
    const study::Plane values = study::criterion(timed.criterion).compare(pair);
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    if (!values.values.empty()) ms.push_back(taken.count());
  }
  std::ranges::nth_element(ms, ms.begin() + kRuns / 2);
  return ms[kRuns / 2];
}

}  // namespace

void measure_times(StudyReport& report, const StudyScope& scope) {
  study::Conditions conditions = chapter8_conditions(scope);
  conditions.camera.width = 378;
  conditions.camera.height = 286;
  const study::Simulation simulation(conditions, 1);
  const Image left = simulation.photograph(0, 0);
  const Image right = simulation.photograph(0.5, 1);
  Csv table({"criterion", "ms", "mega_operations_per_image"});
  for (const Timed& timed : all()) {
    const double ms = ms_of(timed, left, right);
    const double mega = report.result["mega_operations"][timed.name].get<double>();
    table.row(timed.name, ms, mega);
    report.finding("{:6} {:6.2f} ms on this machine, {:5.2f} M operations", timed.name, ms, mega);
  }
  report.table("times.csv", table);
}

}  // namespace horopter::cli
