// SPDX-License-Identifier: Apache-2.0
// Table 8.2: criteria based on squared differences.
#include <cmath>

#include "window_sums.hpp"

namespace horopter::study {

std::vector<std::unique_ptr<Criterion>> squared_criteria() {
  std::vector<std::unique_ptr<Criterion>> result;
  result.push_back(of_window("SSD", false, [](const WindowSums& w) { return w.rr + w.ss - 2 * w.rs; }));
  result.push_back(of_window("ZSSD", false, [](const WindowSums& w) {
    const double difference = w.r - w.s;
    return (w.n * (w.rr + w.ss - 2 * w.rs) - difference * difference) / w.n;
  }));
  result.push_back(of_window("LSSD", false, [](const WindowSums& w) {
    const double scale = local_scale(w.r, w.s);
    return std::max(0.0, w.rr - 2 * scale * w.rs + scale * scale * w.ss);
  }));
  result.push_back(of_window("ZNSSD", false, [](const WindowSums& w) {
    const double energy = w.var_r() * w.var_s();
    return energy > 0 ? (w.var_r() + w.var_s() - 2 * w.cov()) / std::sqrt(energy) : kUndefined;
  }));
  return result;
}

}  // namespace horopter::study
