// SPDX-License-Identifier: Apache-2.0
// Eq. 8.1 and Table 8.1: criteria based on cross correlation.
#include <cmath>

#include "window_sums.hpp"

namespace horopter::study {

std::vector<std::unique_ptr<Criterion>> cross_correlation_criteria() {
  std::vector<std::unique_ptr<Criterion>> result;
  result.push_back(of_window("NCC", true, [](const WindowSums& w) {
    const double energy = w.rr * w.ss;
    return energy > 0 ? w.rs / std::sqrt(energy) : 0;
  }));
  result.push_back(of_window("ZNCC", true, [](const WindowSums& w) {
    const double energy = w.var_r() * w.var_s();
    return energy > 0 ? w.cov() / std::sqrt(energy) : 0;
  }));
  result.push_back(of_window("MOR", true, [](const WindowSums& w) {
    const double energy = w.var_r() + w.var_s();
    return energy > 0 ? 2 * w.cov() / energy : 0;
  }));
  // It has no best value, so its reciprocal stands for it: thresholds divide windows as those of 8.1 do.
  result.push_back(of_window("CCF", false, [](const WindowSums& w) { return w.rs > 0 ? w.n / w.rs : kUndefined; }));
  return result;
}

}  // namespace horopter::study
