// SPDX-License-Identifier: Apache-2.0
// What the hardware computes: its own stages from the low-pass to the sum, compiled for the CPU. 8-bit directions,
// 4-bit differences.
#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <stdexcept>

#include "hardware_directions.hpp"
#include "horopter/study/criteria.hpp"
#include "stages/difference.hpp"
#include "stages/dsad.hpp"

namespace horopter::study {
namespace {

/// The differences of 0 … 15, moved back to the pixels they belong to.
Plane differences(const Plane& left, const Plane& right) {
  stages::DirectionDifference<1> difference;
  Plane result(left.width, left.height);
  for_hardware_directions(left, right, [&](int x, int y, const auto&, const auto& direction) {
    const auto out = difference.step(direction);
    if (x >= 0 && y >= 0) result.at(x, y) = static_cast<double>(out.difference[0].value());
  });
  return result;
}

template <int K>
Plane sums(const Plane& difference) {
  using namespace stages;
  using Sum = DsadSum<kHardwareColumns, 1, K>;
  constexpr int kOffset = K / 2;
  const auto dsad = std::make_unique<Sum>();
  Plane result(difference.width, difference.height);
  for (int y = 0; y < difference.height; ++y) {
    for (int x = 0; x < difference.width; ++x) {
      typename Sum::In in;
      in.difference[0] = u<4>(static_cast<std::uint32_t>(difference.at(x, y)));
      in.mask = true;
      in.marks = {x == 0 && y == 0, x == difference.width - 1};
      const auto out = dsad->step(in);
      if (x >= kOffset && y >= kOffset) result.at(x - kOffset, y - kOffset) = static_cast<double>(out.sum[0].value());
    }
  }
  return result;
}

class Hardware final : public Criterion {
 public:
  std::string name() const override { return "hardware"; }
  Feature feature() const override { return Feature::camera; }
  bool similarity() const override { return false; }
  double worst(int kernel) const override { return 15.0 * kernel * kernel; }
  Plane compare(Pair& pair) const override {
    if (pair.r().width > kHardwareColumns || pair.r().width < 16)
      throw std::invalid_argument(
          fmt::format("the hardware's stages take images of 16 to {} px width here", kHardwareColumns));
    const Plane& difference = pair.shared("hardware difference", [&] { return differences(pair.r(), pair.s()); });
    switch (pair.kernel()) {
      case 5:
        return sums<5>(difference);
      case 7:
        return sums<7>(difference);
      case 9:
        return sums<9>(difference);
      case 11:
        return sums<11>(difference);
      case 13:
        return sums<13>(difference);
      default:
        throw std::invalid_argument("the hardware's windows are 5×5 to 13×13");
    }
  }
};

}  // namespace

std::vector<std::unique_ptr<Criterion>> hardware_criteria() {
  std::vector<std::unique_ptr<Criterion>> result;
  result.push_back(std::make_unique<Hardware>());
  return result;
}

}  // namespace horopter::study
