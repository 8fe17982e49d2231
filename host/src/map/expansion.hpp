// SPDX-License-Identifier: Apache-2.0
// What the hardware makes of control points between them, and how far that is from the skin. In loops over many numbers:
// always inlined.
#pragma once

#include <cmath>
#include <cstdint>

#include "horopter/hls/table_format.hpp"
#include "horopter/image/scan.hpp"
#include "horopter/map/map.hpp"

namespace horopter {

/// In 2^-kFractionBits px from -control_offset_px. Control points themselves, and what lies between two of them, are in
/// units of 2^12 or 2^6 of that.
struct Expansion {
  std::int32_t x, y;
};
/// Where control points put the scan's origin.
inline constexpr std::int32_t kExpandedOrigin = hls::table::control_offset_px << MapTable::kFractionBits;

[[gnu::always_inline]] inline double length(Point p) { return std::sqrt(p.x * p.x + p.y * p.y); }

/// 1/64 `part` of the way from one to the other.
[[gnu::always_inline]] inline Expansion between(const Expansion& from, const Expansion& to, std::int32_t part) {
  return {from.x * (64 - part) + to.x * part, from.y * (64 - part) + to.y * part};
}

[[gnu::always_inline]] inline Point error_of(const Expansion& expansion, const Point& source) {
  constexpr double kFraction = 1.0 / (1 << MapTable::kFractionBits);
  return {static_cast<double>(expansion.x - kExpandedOrigin) * kFraction - source.x,
          static_cast<double>(expansion.y - kExpandedOrigin) * kFraction - source.y};
}

/// Expansions that are read inside the image once they are rounded to the weights.
struct ReadPlaces {
  std::int32_t low, high_x, high_y;

  static ReadPlaces of(const ScanGeometry& scan, int weight_bits) {
    const std::int32_t half = std::int32_t{1} << (MapTable::kFractionBits - weight_bits - 1);
    const auto beyond = [half](int size) { return kExpandedOrigin + ((size - 1) << MapTable::kFractionBits) + half; };
    return {kExpandedOrigin - half, beyond(scan.width), beyond(scan.height)};
  }
  [[gnu::always_inline]] bool hold(const Expansion& at) const {
    return static_cast<bool>((at.x >= low) & (at.y >= low) & (at.x < high_x) & (at.y < high_y));
  }
};

}  // namespace horopter
