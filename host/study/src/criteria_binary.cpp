// SPDX-License-Identifier: Apache-2.0
// Binary correlation according to Nishihara (thesis 8.1.4, Table 8.1).
#include "horopter/study/filters.hpp"
#include "window_sums.hpp"

namespace horopter::study {
namespace {

class Nish final : public Criterion {
 public:
  std::string name() const override { return "NISH"; }
  Feature feature() const override { return Feature::log_sign; }
  bool similarity() const override { return true; }
  double best(int kernel) const override { return static_cast<double>(kernel) * kernel; }
  Plane compare(Pair& pair) const override { return pair.sum(Pair::Sum::rs); }
};

}  // namespace

std::vector<std::unique_ptr<Criterion>> binary_criteria() {
  std::vector<std::unique_ptr<Criterion>> result;
  result.push_back(std::make_unique<Nish>());
  return result;
}

}  // namespace horopter::study
