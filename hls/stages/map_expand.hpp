// SPDX-License-Identifier: Apache-2.0
// map_expand: control grid → source address and weights of each output pixel (thesis 10.4.2; spacing 1 is its table).
//
// In    a row is one `prime` beat, which brings column 0 of the grid, then one beat per pixel; a pixel with
//       x mod 2^spacing = 0 has `load` set and brings column x / 2^spacing + 1. `column` holds the control points above
//       and below the row, `row_fraction` the row's place between them in 1/64 of a cell.
//       Control points are (coordinate in px + 64) · 32, both parts all ones: no source.
// Out   none for prime beats; else the top left of the 2×2 source pixels in px, weights of the right and lower ones in
//       1/2^W, `mapped` if all control points of non-zero weight have a source and the address is not negative.
//       Whether the source lies inside the image and in the store is for the store to say.
// Exact bilinear interpolation: vertical, (64 − f)·top + f·bottom, then along the row by adding the 1/64 part of the
// difference of two columns per pixel; rounded half up to 1/2^W px at the end only. Error against real arithmetic:
// 1/2^(W+1) px. Offset: none.
// Illegal use: a row without prime beat takes its first column from the row before; load in the wrong place gives wrong
// addresses until the next row; spacing_x_log2 above 6 counts as 6.
#pragma once

#include "stages/stream.hpp"

namespace horopter::stages {

struct ControlPoint {
  u<16> x;  // (px + 64) · 32
  u<16> y;

  [[nodiscard]] bool has_source() const { return !(x == 0xFFFF && y == 0xFFFF); }
};

struct ControlPair {
  ControlPoint top;
  ControlPoint bottom;
};

template <int WEIGHT_BITS>
class MapExpander {
  static_assert(WEIGHT_BITS >= 1 && WEIGHT_BITS <= 8);

 public:
  struct In {
    bool prime = false;
    bool load = false;
    ControlPair column;
    u<6> row_fraction;
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
    RasterMarks marks;
  };

  Out step(const In& in, const Config& config) {
    Out out;
    const bool load = in.load && !in.prime;
    const bool right_valid = load || right_.valid;  // has no weight at the column itself
    if (in.prime || load) {
      const Node arriving = node(in.column, in.row_fraction);
      if (load) {
        // One pixel further is 2^(6 − spacing) of the 64 parts of the cell.
        const u<3> up = config.spacing_x_log2 >= 6 ? u<3>(0) : u<3>(lit<6>() - config.spacing_x_log2);
        x_.load(right_.x, arriving.x, up);
        y_.load(right_.y, arriving.y, up);
        left_valid_ = right_.valid;
      }
      right_ = arriving;
    }
    out.valid = !in.prime;
    const bool x_inside = place(x_.step(), out.x, out.wx);
    const bool y_inside = place(y_.step(), out.y, out.wy);
    out.mapped = left_valid_ && right_valid && x_inside && y_inside;
    out.marks = in.marks;
    return out;
  }

 private:
  static constexpr int fraction_bits = 5 + 6 + 6;  // of a coordinate after both interpolations

  struct Node {
    u<22> x;  // (px + 64) · 32 · 64
    u<22> y;
    bool valid = false;
  };

  using Place = u<28>;  // (px + 64) · 2^17

  /// One coordinate along the row.
  class Axis {
   public:
    void load(u<22> left, u<22> right, u<3> up) {
      place_ = shl<6>(left);
      increment_ = scaled(right - left, up);
    }

    Place step() {
      const Place place = place_;
      place_ = Place(place + increment_);
      return place;
    }

   private:
    static s<29> scaled(s<23> difference, u<3> up) {
      s<29> value(difference);
      if (up.bit(0)) value = s<29>(shl<1>(value));
      if (up.bit(1)) value = s<29>(shl<2>(value));
      if (up.bit(2)) value = s<29>(shl<4>(value));
      return value;
    }

    Place place_{0};  // of the next pixel, unless that loads
    s<29> increment_{0};
  };

  /// (64 − f)·a + f·b as a + Σ 2^i (f_i ? b : a): adders and multiplexers, no multiplier.
  static u<22> between(u<16> a, u<16> b, u<6> f) {
    const auto pick = [&](int i) { return f.bit(i) ? b : a; };
    const u<18> low = u<18>(shl<1>(pick(1)) + (pick(0) + a));
    const u<18> middle = u<18>(shl<1>(pick(3)) + pick(2));
    const u<18> high = u<18>(shl<1>(pick(5)) + pick(4));
    return u<22>(low + shl<2>(middle + shl<2>(high)));
  }

  static Node node(const ControlPair& column, u<6> fraction) {
    Node result;
    result.x = between(column.top.x, column.bottom.x, fraction);
    result.y = between(column.top.y, column.bottom.y, fraction);
    result.valid = column.top.has_source() && (fraction == 0 || column.bottom.has_source());
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

  Node right_;  // vertical interpolation of the cell's right column
  bool left_valid_ = false;
  Axis x_;
  Axis y_;
};

template <Profile P>
using MapExpand = MapExpander<P.weight_bits>;

}  // namespace horopter::stages
