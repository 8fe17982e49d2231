// SPDX-License-Identifier: Apache-2.0
// The hardware's stages from the low-pass to the direction, compiled for the CPU.
#pragma once

#include <cstdint>
#include <memory>

#include "horopter/study/raster.hpp"
#include "stages/direction.hpp"
#include "stages/lowpass.hpp"
#include "stages/sobel.hpp"

namespace horopter::study {

inline constexpr int kHardwareColumns = 2048;  ///< widest image

/// Calls visit(x, y, gradient, direction) for every beat of a pair of 8-bit images, at the pixel that its result
/// belongs to; the first two rows and columns belong to none, and x or y is negative.
template <class Visit>
void for_hardware_directions(const Plane& left, const Plane& right, Visit visit) {
  using namespace stages;
  constexpr int kOffset = 2;  // low-pass and Sobel, a pixel each
  const auto lowpass = std::make_unique<LowpassFilter<kHardwareColumns>>();
  const auto sobel = std::make_unique<SobelFilter<kHardwareColumns>>();
  const auto direction = std::make_unique<DirectionFinder<>>();
  for (int y = 0; y < left.height; ++y) {
    for (int x = 0; x < left.width; ++x) {
      Grey<2> in;
      in.pixel = {u<8>(static_cast<std::uint32_t>(left.at(x, y))), u<8>(static_cast<std::uint32_t>(right.at(x, y)))};
      in.mask = true;
      in.marks = {x == 0 && y == 0, x == left.width - 1, false, false};
      const auto gradient = sobel->step(lowpass->step(in));
      visit(x - kOffset, y - kOffset, gradient, direction->step(gradient));
    }
  }
}

}  // namespace horopter::study
