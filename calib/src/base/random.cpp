// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/random.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace horopter::calib {
namespace {

/// Quantiles of the normal distribution, by Newton's method from the one before.
std::vector<float> make_quantiles() {
  constexpr std::size_t kCount = 65536;
  std::vector<float> table(kCount);
  double z = 0;
  for (std::size_t i = kCount / 2; i < kCount; ++i) {
    const double upper = (static_cast<double>(kCount - i) - 0.5) / kCount;
    for (int iteration = 0; iteration < 8; ++iteration) {
      const double error = 0.5 * std::erfc(z / std::numbers::sqrt2) - upper;
      z += error * std::sqrt(2 * std::numbers::pi) * std::exp(z * z / 2);
    }
    table[i] = static_cast<float>(z);
    table[kCount - 1 - i] = static_cast<float>(-z);
  }
  return table;
}

}  // namespace

float Random::gaussian() {
  static const std::vector<float> quantiles = make_quantiles();
  if (left_ == 0) {
    reserve_ = next();
    left_ = 4;
  }
  const std::size_t index = reserve_ & 0xFFFFU;
  reserve_ >>= 16;
  --left_;
  return quantiles[index];
}

}  // namespace horopter::calib
