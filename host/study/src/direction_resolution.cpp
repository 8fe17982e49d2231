// SPDX-License-Identifier: Apache-2.0
#include "horopter/study/direction_resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "hardware_directions.hpp"
#include "horopter/study/filters.hpp"

namespace horopter::study {
namespace {

constexpr double kFlat = -1;

/// Directions of both images in 1/256 turn, kFlat where the gradient is 0, at the pixels that they belong to: the
/// hardware's 8 bits, or what the same gradients have in floating point.
std::pair<Plane, Plane> directions(const Plane& left, const Plane& right, bool exact) {
  std::pair<Plane, Plane> result{Plane(left.width, left.height, kFlat), Plane(left.width, left.height, kFlat)};
  for_hardware_directions(left, right, [&](int x, int y, const auto& gradient, const auto& direction) {
    if (x < 0 || y < 0) return;
    const auto value = [&](std::size_t i) {
      if (direction.magnitude[i].value() == 0) return kFlat;
      if (!exact) return static_cast<double>(direction.direction[i].value());
      const double turn = std::atan2(gradient.gy[i].value(), gradient.gx[i].value()) * 128 / std::numbers::pi;
      return turn < 0 ? turn + 256 : turn;
    };
    result.first.at(x, y) = value(0);
    result.second.at(x, y) = value(1);
  });
  return result;
}

class DirectionResolution final : public Criterion {
 public:
  DirectionResolution(int direction_bits, int difference_bits)
      : direction_bits_(direction_bits), difference_bits_(difference_bits) {}
  std::string name() const override {
    if (exact()) return "DSAD of the hardware's gradients, floating point";
    return fmt::format("DSAD {} bit before, {} bit after differencing", direction_bits_, difference_bits_);
  }
  Feature feature() const override { return Feature::camera; }
  bool similarity() const override { return false; }
  double worst(int kernel) const override { return static_cast<double>(largest()) * kernel * kernel; }
  Plane compare(Pair& pair) const override {
    if (pair.r().width > kHardwareColumns || pair.r().width < 16)
      throw std::invalid_argument(
          fmt::format("the hardware's stages take images of 16 to {} px width here", kHardwareColumns));
    // Both are made at once, and kept for the other resolutions.
    const std::string key = exact() ? "direction in floating point" : "8-bit direction";
    const Plane& left = pair.shared(key + ", left", [&] {
      auto both = directions(pair.r(), pair.s(), exact());
      pair.shared(key + ", right", [&] { return std::move(both.second); });
      return std::move(both.first);
    });
    const Plane& right = pair.shared(key + ", right", [] { return Plane(); });
    const Plane& difference = pair.shared(name(), [&] {
      Plane result(left.width, left.height);
      for (std::size_t i = 0; i < result.values.size(); ++i)
        result.values[i] = between(left.values[i], right.values[i]);
      return result;
    });
    return box_sum(difference, pair.kernel());
  }

 private:
  bool exact() const { return direction_bits_ == 0; }
  int largest() const { return (1 << difference_bits_) - 1; }
  double between(double a, double b) const {
    // The hardware's 8 and 4 of 15: the mean over all directions, and the default threshold's share.
    const bool flat_a = a == kFlat;
    const bool flat_b = b == kFlat;
    if (flat_a && flat_b) return 4.0 / 15 * largest();
    if (flat_a || flat_b) return 8.0 / 15 * largest();
    if (exact()) {
      const double turn = std::abs(a - b);
      return std::min({turn, 256 - turn, 127.0});
    }
    const int cycle = 1 << direction_bits_;
    const int drop = 8 - direction_bits_;
    const int turn = ((static_cast<int>(a) >> drop) - (static_cast<int>(b) >> drop)) & (cycle - 1);
    const int shortest = std::min({turn, cycle - turn, cycle / 2 - 1});
    return shortest >> (direction_bits_ - 1 - difference_bits_);
  }

  int direction_bits_, difference_bits_;
};

}  // namespace

std::unique_ptr<Criterion> direction_in_floating_point() { return std::make_unique<DirectionResolution>(0, 7); }

std::unique_ptr<Criterion> direction_resolution(int direction_bits, int difference_bits) {
  if (direction_bits < 2 || direction_bits > 8 || difference_bits < 1 || difference_bits > direction_bits - 1) {
    throw std::invalid_argument("directions of 2 to 8 bits have differences of 1 bit to one less");
  }
  return std::make_unique<DirectionResolution>(direction_bits, difference_bits);
}

}  // namespace horopter::study
