// SPDX-License-Identifier: Apache-2.0
// The areas of a table (table_format.hpp) as the machine adds them up.
#pragma once

#include "horopter/hls/int.hpp"

namespace horopter::hls {

inline constexpr int area_steps_per_mm2 = 1024;
using PixelArea = u<20>;
/// Of an object. A sum that would be more is the largest: so it does not depend on the order of its parts.
using ObjectArea = u<32>;

/// In 1/1024 mm², rounded up: exact from 1/128 mm² on. From 1024 mm² on the largest value.
constexpr PixelArea area_of(u<8> code) {
  const auto exponent = code.bits<7, 3>();
  // (8 + m) · 2^e are steps of 2^-5, as the code's areas begin at 2^-12 mm².
  u<25> fine(cat(u<1>(1), code.bits<2, 0>()));
  if (exponent.bit(0)) fine = u<25>(shl<1>(fine));
  if (exponent.bit(1)) fine = u<25>(shl<2>(fine));
  if (exponent.bit(2)) fine = u<25>(shl<4>(fine));
  if (exponent.bit(3)) fine = u<25>(shl<8>(fine));
  if (exponent.bit(4)) fine = u<25>(shl<16>(fine));
  // Only areas below 2^4 steps have a remainder, so what is added stays in these bits.
  const u<4> low(fine.bits<8, 5>() + u<1>(fine.bits<4, 0>() != 0));
  const PixelArea area(cat(fine.bits<24, 9>(), low));
  return exponent > 21 ? PixelArea::max() : area;
}

/// a + b. By halves: a fast clock does not add all of it at once.
constexpr ObjectArea area_sum(ObjectArea a, ObjectArea b) {
  const auto low = a.bits<15, 0>() + b.bits<15, 0>();
  const auto high = a.bits<31, 16>() + b.bits<31, 16>() + low.bits<16, 16>();
  return high.bits<17, 16>() != 0 ? ObjectArea::max() : ObjectArea(cat(high.bits<15, 0>(), low.bits<15, 0>()));
}

}  // namespace horopter::hls
