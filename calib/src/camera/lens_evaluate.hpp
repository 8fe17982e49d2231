// SPDX-License-Identifier: Apache-2.0
// The lens map (lens.hpp) and its derivatives as plain arithmetic, for one point and for many.
#pragma once

#include "horopter/calib/lens.hpp"

namespace horopter::calib {

/// L(r²) and its derivative by r².
struct Radial {
  double value, derivative;
};

template <bool kRational = true>
[[gnu::always_inline]] inline Radial radial(const LensCoefficients& c, double r2) {
  const double a = 1 + r2 * (c.k1 + r2 * (c.k2 + r2 * c.k3));
  const double da = c.k1 + r2 * (2 * c.k2 + r2 * 3 * c.k3);
  if constexpr (!kRational) return {a, da};
  const double b = 1 + r2 * (c.k4 + r2 * (c.k5 + r2 * c.k6));
  const double db = c.k4 + r2 * (2 * c.k5 + r2 * 3 * c.k6);
  return {a / b, (da * b - a * db) / (b * b)};
}

/// (X, Y) and their derivatives by x and y.
struct LensValue {
  double x, y;
  double xx, xy, yx, yy;
};

/// Without `kBent` none of p1, p2, s1 … s4 is anything but 0.
template <bool kRational = true, bool kBent = true>
[[gnu::always_inline]] inline LensValue lens_value(const LensCoefficients& c, double x, double y) {
  const double r2 = x * x + y * y, r4 = r2 * r2;
  const auto [l, dl] = radial<kRational>(c, r2);
  if constexpr (!kBent) {
    const double cross = 2 * x * y * dl;
    return {.x = x * l, .y = y * l, .xx = l + 2 * x * x * dl, .xy = cross, .yx = cross, .yy = l + 2 * y * y * dl};
  }
  const double cross = 2 * x * y * dl + 2 * c.p1 * x + 2 * c.p2 * y;
  const double gx = 2 * c.s1 + 4 * r2 * c.s2, gy = 2 * c.s3 + 4 * r2 * c.s4;
  return {.x = x * l + 2 * c.p1 * x * y + c.p2 * (r2 + 2 * x * x) + c.s1 * r2 + c.s2 * r4,
          .y = y * l + c.p1 * (r2 + 2 * y * y) + 2 * c.p2 * x * y + c.s3 * r2 + c.s4 * r4,
          .xx = l + 2 * x * x * dl + 2 * c.p1 * y + 6 * c.p2 * x + gx * x,
          .xy = cross + gx * y,
          .yx = cross + gy * x,
          .yy = l + 2 * y * y * dl + 6 * c.p1 * y + 2 * c.p2 * x + gy * y};
}

}  // namespace horopter::calib
