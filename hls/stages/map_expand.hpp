// SPDX-License-Identifier: Apache-2.0
// map_expand: control grid → source address and weights of each output pixel (thesis 10.4.2; spacing 1 is its table).
//
// In    a row is one `prime` beat, which brings column 0 of the grid, then one beat per pixel; a pixel with
//       x mod 2^spacing = 0 has `load` set and brings column x / 2^spacing + 1. `column` holds the control points above
//       and below the row (swapped: below and above), `row_fraction` the row's place between them in 1/64 of a cell.
//       `outside`: the pixel is outside of its row's span, so not on the skin, whatever its control points are.
// Out   none for prime beats; else the top left of the 2×2 source pixels in px, weights of the right and lower ones in
//       1/2^W. `present` if all control points of non-zero weight have a source and the address is not negative,
//       `mapped` if they also belong to the skin and the pixel is not outside: others only show what is around it, for
//       `agreement`.
//       Whether the source lies inside the image and in the store is for the store to say.
// Exact bilinear interpolation: vertical, (64 − f)·top + f·bottom, then along the row by adding the 1/64 part of the
// difference of two columns per pixel; rounded half up to 1/2^W px at the end only. Error against real arithmetic:
// 1/2^(W+1) px. Offset: none.
// COMPACT trades the speed of the clock for gates: a row's place is the only register of coordinates, as a cell ends
// where the next one begins, and the factor f is recoded to half as many digits. Illegal use: a row without prime beat
// takes its first column from the row before; load in the wrong place gives wrong addresses until the next row;
// spacing_x_log2 above 6 counts as 6.
#pragma once

#include <type_traits>

#include "stages/stream.hpp"

namespace horopter::stages {

/// As horopter/hls/table_format.hpp has it; in the hardware by horopter_control_point.sv.
struct ControlPoint {
  u<16> x;  // (px + 64) · 32
  u<16> y;
  bool exists = false;   // there is a source
  bool of_skin = false;  // and it is one of the skin, not around it
};

struct ControlPair {
  ControlPoint top;
  ControlPoint bottom;
  bool swapped = false;  // top is the bottom one
};

template <int WEIGHT_BITS, bool COMPACT = false>
class MapExpander {
  static_assert(WEIGHT_BITS >= 1 && WEIGHT_BITS <= 8);

 public:
  struct In {
    bool prime = false;
    bool load = false;
    ControlPair column;
    u<6> row_fraction;
    bool outside = false;
    RasterMarks marks;
  };
  struct Config {
    u<3> spacing_x_log2;  // pixels per cell
  };
  struct Out {
    bool valid = false;
    u<11> x;
    u<11> y;
    u<WEIGHT_BITS> wx;
    u<WEIGHT_BITS> wy;
    bool mapped = false;
    bool present = false;
    RasterMarks marks;
  };

  Out step(const In& in, const Config& config) {
    Out out;
    const bool load = in.load && !in.prime;
    const bool right_valid = load || right_valid_;  // has no weight at the column itself
    const bool right_of_skin = load || right_of_skin_;
    // One pixel further is 2^(6 − spacing) of the 64 parts of the cell.
    const u<3> up = config.spacing_x_log2 >= 6 ? u<3>(0) : u<3>(lit<6>() - config.spacing_x_log2);
    const Node arriving = node(in.column, in.row_fraction);
    const Place x = x_.step(in.prime, load, arriving.x, up);
    const Place y = y_.step(in.prime, load, arriving.y, up);
    if (load) {
      left_valid_ = right_valid_;
      left_of_skin_ = right_of_skin_;
    }
    if (in.prime || load) {
      right_valid_ = arriving.valid;
      right_of_skin_ = arriving.of_skin;
    }
    out.valid = !in.prime;
    const bool x_inside = place(x, out.x, out.wx);
    const bool y_inside = place(y, out.y, out.wy);
    const bool inside = x_inside && y_inside;
    out.present = left_valid_ && right_valid && inside;
    out.mapped = left_of_skin_ && right_of_skin && inside && !in.outside;
    out.marks = in.marks;
    return out;
  }

 private:
  static constexpr int fraction_bits = 5 + 6 + 6;  // of a coordinate after both interpolations

  struct Node {
    u<22> x;  // (px + 64) · 32 · 64
    u<22> y;
    bool valid = false;
    bool of_skin = false;  // then it is valid, too
  };

  using Place = u<28>;  // (px + 64) · 2^17

  static s<29> scaled(s<23> difference, u<3> up) {
    s<29> value(difference);
    if (up.bit(0)) value = s<29>(shl<1>(value));
    if (up.bit(1)) value = s<29>(shl<2>(value));
    if (up.bit(2)) value = s<29>(shl<4>(value));
    return value;
  }

  /// One coordinate along the row.
  class Axis {
   public:
    /// The place of this pixel. `arriving`: the right column of the cell that begins here, or of the row's first one.
    Place step(bool prime, bool load, u<22> arriving, u<3> up) {
      if (load) {
        place_ = shl<6>(right_);
        increment_ = scaled(arriving - right_, up);
      }
      if (prime || load) right_ = arriving;
      const Place place = place_;
      place_ = Place(place + increment_);
      return place;
    }

   private:
    u<22> right_;     // the cell's right column
    Place place_{0};  // of the next pixel, unless that loads
    s<29> increment_{0};
  };

  class CompactAxis {
   public:
    Place step(bool prime, bool load, u<22> arriving, u<3> up) {
      const Place place = *place_;
      // All 64 parts of a cell lead to the row's first column, from wherever the row before has ended.
      if (prime || load) *increment_ = scaled(arriving - place.template bits<27, 6>(), prime ? u<3>(6) : up);
      const Place next(place + *increment_);
      *place_ = Place(cat(next.template bits<27, 6>(), prime ? u<6>(0) : next.template bits<5, 0>()));
      return place;
    }

   private:
    Kept<Place> place_;  // of the next pixel; at the end of a cell, its right column
    Kept<s<29>> increment_;
  };

  /// (64 − f)·a + f·b as 64·a + Σ 2^i f_i (b − a): no multiplier, and an FPGA's carry cells take the bits f_i in.
  static u<22> between(u<16> a, u<16> b, u<6> f, bool swapped) {
    const u<16> from = swapped ? b : a;
    const s<17> difference = (swapped ? a : b) - from;
    const auto part = [&](int i) { return f.bit(i) ? difference : s<17>(0); };
    const auto pair = [&](int i) { return s<19>(shl<1>(part(i + 1)) + part(i)); };
    return u<22>(shl<6>(from) + s<23>(pair(0) + shl<2>(s<21>(pair(2) + shl<2>(pair(4))))));
  }

  /// The same as 64·(f_5 ? b : a) + Σ 4^i d_i (b − a) with Booth's digits of f, d_i = −2 f_2i+1 + f_2i + f_2i−1.
  static u<22> compact_between(u<16> a, u<16> b, u<6> f, bool swapped) {
    const s<17> difference = b - a;
    u<22> sum = u<22>(f.bit(5) != swapped ? b : a);
    for (int i = 2; i >= 0; --i) {
      const bool below = i > 0 && f.bit(2 * i - 1);
      const bool negative = f.bit(2 * i + 1);
      const bool one = f.bit(2 * i) != below;
      const bool two = !one && negative != below;
      const u<22> once = u<22>(s<22>(difference));
      const u<22> twice = u<22>(s<22>(shl<1>(difference)));
      const u<22> size = one ? once : two ? twice : u<22>(0);
      const bool minus = negative != swapped;
      const u<22> digit = minus ? ~size : size;
      // The one that −size = ~size + 1 lacks comes as a carry, from a bit below.
      const u<23> both = u<23>(cat(u<22>(shl<2>(sum)), u<1>(1)) + cat(digit, u<1>(minus)));
      sum = both.template bits<22, 1>();
    }
    return sum;
  }

  static Node node(const ControlPair& column, u<6> fraction) {
    Node result;
    constexpr auto interpolate = COMPACT ? compact_between : between;
    result.x = interpolate(column.top.x, column.bottom.x, fraction, column.swapped);
    result.y = interpolate(column.top.y, column.bottom.y, fraction, column.swapped);
    const bool without_top = fraction == 0 && column.swapped;
    const bool without_bottom = fraction == 0 && !column.swapped;
    result.valid = (column.top.exists || without_top) && (column.bottom.exists || without_bottom);
    result.of_skin = (column.top.of_skin || without_top) && (column.bottom.of_skin || without_bottom);
    return result;
  }

  /// Splits a coordinate into pixel and weight; false if it is negative or beyond 11 bits.
  static bool place(Place value, u<11>& pixel, u<WEIGHT_BITS>& weight) {
    const auto rounded = shr<fraction_bits - WEIGHT_BITS - 1>(value) + lit<1>();
    weight = rounded.template bits<WEIGHT_BITS, 1>();
    const s<13> source = rounded.template bits<12 + WEIGHT_BITS, 1 + WEIGHT_BITS>() - lit<64>();
    pixel = u<11>(source);
    return !source.negative();
  }

  bool right_valid_ = false;  // of the cell's columns
  bool left_valid_ = false;
  bool right_of_skin_ = false;  // all of these belong to the skin
  bool left_of_skin_ = false;
  std::conditional_t<COMPACT, CompactAxis, Axis> x_;
  std::conditional_t<COMPACT, CompactAxis, Axis> y_;
};

template <Profile P>
using MapExpand = MapExpander<P.weight_bits, (P.clock_khz < 40'000)>;

}  // namespace horopter::stages
