// SPDX-License-Identifier: Apache-2.0
// Binary correlations (thesis 8.1.4, Table 8.1): Nishihara's; NISD of Table 8.5, which the thesis does not define, read as
// the same with a difference of two Gaussians (its count of operations is that of four separable filters of 7 pixels); and
// Nack's, read as the high-pass of Roberts against its mean nearby.
#include "horopter/study/filters.hpp"
#include "window_sums.hpp"

namespace horopter::study {
namespace {

class BinaryCriterion final : public Criterion {
 public:
  BinaryCriterion(const char* name, Feature feature) : name_(name), feature_(feature) {}
  std::string name() const override { return name_; }
  Feature feature() const override { return feature_; }
  bool similarity() const override { return true; }
  double best(int kernel) const override { return static_cast<double>(kernel) * kernel; }
  Plane compare(Pair& pair) const override { return pair.sum(Pair::Sum::rs); }

 private:
  const char* name_;
  Feature feature_;
};

}  // namespace

std::vector<std::unique_ptr<Criterion>> binary_criteria() {
  std::vector<std::unique_ptr<Criterion>> result;
  result.push_back(std::make_unique<BinaryCriterion>("NISH", Feature::log_sign));
  result.push_back(std::make_unique<BinaryCriterion>("NISD", Feature::dog_sign));
  result.push_back(std::make_unique<BinaryCriterion>("NACK", Feature::roberts_sign));
  return result;
}

}  // namespace horopter::study
