// SPDX-License-Identifier: Apache-2.0
// The smallest, mean and largest of many figures.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "horopter/plan/plan.hpp"

namespace horopter {

class Statistics {
 public:
  void add(double value) {
    smallest_ = std::min(smallest_, value);
    largest_ = std::max(largest_, value);
    sum_ += value;
    ++count_;
  }
  Summary summary() const {
    if (count_ == 0) return {std::nan(""), std::nan(""), std::nan("")};
    return {smallest_, sum_ / static_cast<double>(count_), largest_};
  }

 private:
  double smallest_ = std::numeric_limits<double>::infinity();
  double largest_ = -std::numeric_limits<double>::infinity();
  double sum_ = 0;
  std::int64_t count_ = 0;
};

}  // namespace horopter
