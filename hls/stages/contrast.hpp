// SPDX-License-Identifier: Apache-2.0
// contrast: what the planes of `compete` are compared by: the gradients of both images, the right ones scaled to the left
// camera's gain, clipped to ±31 along the row (4 grey levels per pixel) and to ±15 across it.
//
// What lies across counts half: along a row an edge that runs with it looks the same at every shift. Clipped before they
// are compared: two edges agree however strong or blurred they are.
//
// Gain: 1/64, 16 … 255, the ratio of the sums of |gx| (each at most 255) of both images where both exist: sums in which
// a row counts 7/8 of the next one, from 1 at the start of each frame, so that a frame does not depend on those before
// it. What the rows up to y − 2 say holds for row y: the quotient is formed, a bit in two
// beats, while row y − 1 passes.
//
// In    gradients. The left grey level and the mask pass through.
// Out   left, right: 0 where saturated. Offset: none. No memory. Rows of at least 19 beats.
#pragma once

#include "stages/slopes.hpp"

namespace horopter::stages {

/// The arithmetic of a pixel.
template <class V = Scalar>
struct Contrast {
  template <int N>
  using U = typename V::template u<N>;
  template <int N>
  using S = typename V::template s<N>;
  using Bit = typename V::bit;
  /// 4 grey levels per pixel.
  static constexpr int least_edge = 32;

  S<6> left;
  S<6> right;
  S<5> left_y;
  S<5> right_y;
  Bit edge = false;  // of the left image: what it shows along the row is more than noise
  Bit mask = false;
  U<8> grey;
  Marks marks;

  static U<8> magnitude(S<11> gx) { return sat<8>(abs(gx)); }

  template <int N>
  static S<N + 1> clipped(S<11> gradient, U<8> magnitude, Bit saturated) {
    const U<N> size = select(saturated, U<N>(0), sat<N>(magnitude));
    return select(gradient.negative(), S<N + 1>(S<N + 1>(0) - size), S<N + 1>(size));
  }
  static U<8> scaled(U<8> magnitude, u<8> gain) { return sat<8>(shr<6>(U<16>(magnitude * gain))); }

  void set(const GradientsAndGrey<V>& in, u<8> gain) {
    left = clipped<5>(in.gx[0], magnitude(in.gx[0]), in.saturated);
    right = clipped<5>(in.gx[1], scaled(magnitude(in.gx[1]), gain), in.saturated);
    left_y = clipped<4>(in.gy[0], magnitude(in.gy[0]), in.saturated);
    right_y = clipped<4>(in.gy[1], scaled(magnitude(in.gy[1]), gain), in.saturated);
    edge = magnitude(in.gx[0]) >= lit<least_edge>() && !in.saturated;
    mask = in.mask;
    grey = in.grey;
    marks = in.marks;
  }
};

inline constexpr int gain_1 = 64;
inline constexpr int least_gain = 16;

/// Sums of |gx| over a frame's rows so far.
template <int BEATS>
struct GradientSums {
  static constexpr int row_bits = bits_for(255 * BEATS);
  static constexpr int bits = row_bits + 3;
  using Row = u<row_bits>;
  using Sum = u<bits>;

  /// A row of a tenth of a grey level per pixel and of gain 1 lies above the frame.
  Sum left = Sum(BEATS);
  Sum right = Sum(BEATS);

  void fade() {
    left = Sum(left - shr<3>(left));
    right = Sum(right - shr<3>(right));
  }
  void add(Row row_left, Row row_right) {
    left = Sum(left + row_left);
    right = Sum(right + row_right);
  }

  [[nodiscard]] u<8> gain() const {
    const std::uint64_t quotient = 64U * std::uint64_t{left.value()} / right.value();
    return u<8>(std::clamp<std::uint64_t>(quotient, least_gain, 255));
  }
};

template <int BEATS>
class ContrastFinder {
 public:
  using In = GradientsAndGrey<>;
  using Out = Contrast<>;

  Out step(const In& in) {
    const Marks& marks = in.marks;
    if (marks.first) [[unlikely]] {
      left_ = right_ = Row(0);
      gain_ = next_gain_ = u<8>(gain_1);
      beats_left_ = u<5>(0);
    }
    Out out;
    out.set(in, gain_);
    if (in.mask) {
      left_ = Row(left_ + Out::magnitude(in.gx[0]));
      right_ = Row(right_ + Out::magnitude(in.gx[1]));
    }
    // After a row: its sums, then the division. One addition a beat, so that the loop fits the clock.
    if (marks.first) {
      sums_ = Sums{};
    } else if (marks.last) {
      sums_.fade();
    } else if (beats_left_ == lit<division_beats + 2>()) {
      sums_.add(row_left_, row_right_);
    }
    // A bit of 256 · left / (4 · right): the difference in one beat, the choice in the next.
    const Dividend doubled(shl<1>(remainder_));
    const bool bit = !difference_.negative();
    if (beats_left_ == lit<division_beats + 1>()) {
      divisor_ = Dividend(shl<2>(sums_.right));
      remainder_ = min(Dividend(sums_.left), divisor_);  // 4 and more stay 255 / 64
    } else if (beats_left_.bit(0)) {
      remainder_ = bit ? Dividend(difference_) : doubled;
      next_gain_ = u<8>(cat(next_gain_, bit));
    } else {
      difference_ = doubled - divisor_;
    }
    beats_left_ -= u<1>(beats_left_ != lit<0>());
    if (marks.last) [[unlikely]] {
      gain_ = next_gain_ > lit<least_gain>() ? next_gain_ : u<8>(least_gain);
      row_left_ = left_;
      row_right_ = right_;
      left_ = right_ = Row(0);
      beats_left_ = u<5>(division_beats + 2);
    }
    return out;
  }

 private:
  using Sums = GradientSums<BEATS>;
  using Row = typename Sums::Row;
  static constexpr int division_beats = 16;
  using Dividend = u<Sums::bits + 3>;

  Sums sums_;
  Row left_, right_;          // of this row so far
  Row row_left_, row_right_;  // of the row before
  u<8> gain_{gain_1};
  u<8> next_gain_{gain_1};
  Dividend divisor_;
  Dividend remainder_;
  s<Sums::bits + 4> difference_;
  u<5> beats_left_;
};

/// In strips of a row: StripContrast of stages/strips.hpp.
template <Profile P, class V = Scalar>
using Contrasts = ContrastFinder<P.result_width()>;

}  // namespace horopter::stages
