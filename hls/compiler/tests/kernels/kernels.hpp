// SPDX-License-Identifier: Apache-2.0
// Small stages of the kinds the project is made of, written independently of hls/stages.
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <horopter/hls/int.hpp>
#include <horopter/hls/ram.hpp>

namespace kernels {

using horopter::hls::RAM;
using horopter::hls::s;
using horopter::hls::u;

/// 3×3 [1 2 1] with two rows in one memory; the row is WIDTH long.
template <int WIDTH>
class Lowpass3x3 {
 public:
  struct In {
    u<8> pixel;
  };
  struct Out {
    u<8> pixel;
  };
  Out step(const In& in) {
    const Rows rows = memory_.read(x_);
    memory_.write(x_, Rows{rows.last, in.pixel});
    x_ = x_ == WIDTH - 1 ? 0 : x_ + 1;
    const int sum = rows.before.value() + 2 * rows.last.value() + in.pixel.value();
    const int total = columns_[1] + 2 * columns_[0] + sum;
    columns_[1] = columns_[0];
    columns_[0] = sum;
    return {u<8>((total + 8) >> 4)};
  }

 private:
  struct Rows {
    u<8> before, last;
  };
  RAM<Rows, WIDTH, WIDTH> memory_;
  int x_ = 0;
  std::array<int, 2> columns_{};
};

class CyclicDifference {
 public:
  struct In {
    u<8> a, b;
  };
  struct Out {
    u<4> difference;
  };
  Out step(const In& in) {
    const int d = std::abs(in.a.value() - in.b.value());
    return {u<4>(std::min({d, 256 - d, 127}) >> 3)};
  }
};

/// Sum over K columns of column sums over K rows, both running.
template <int WIDTH, int K>
class BoxSum {
 public:
  struct In {
    u<4> x;
  };
  struct Out {
    u<12> sum;
  };
  Out step(const In& in) {
    Column column = memory_.read(x_);
    const u<4> leaving = column.rows[K - 1];
    for (int i = K - 1; i > 0; --i)
      column.rows[static_cast<std::size_t>(i)] = column.rows[static_cast<std::size_t>(i - 1)];
    column.rows[0] = in.x;
    column.sum = u<8>(column.sum.value() + in.x.value() - leaving.value());
    memory_.write(x_, column);
    x_ = x_.value() == WIDTH - 1 ? u<8>(0) : u<8>(x_.value() + 1);
    total_ = u<12>(total_.value() + column.sum.value() - window_[K - 1].value());
    for (std::size_t i = K - 1; i > 0; --i) window_[i] = window_[i - 1];
    window_[0] = column.sum;
    return {total_};
  }

 private:
  struct Column {
    std::array<u<4>, K> rows{};
    u<8> sum;
  };
  RAM<Column, WIDTH, WIDTH> memory_;
  u<8> x_;
  std::array<u<8>, K> window_{};
  u<12> total_;
};

/// More than half of a 5×5 window, rows held as bits of one word.
template <int WIDTH>
class Majority5x5 {
 public:
  struct In {
    bool x;
  };
  struct Out {
    bool majority;
    u<5> count;
  };
  Out step(const In& in) {
    const u<4> above = memory_.read(x_);
    const u<5> column = u<5>((above.value() << 1) | (in.x ? 1 : 0));
    memory_.write(x_, u<4>(column.value()));
    x_ = u<7>(x_.value() + 1 == WIDTH ? 0 : x_.value() + 1);
    unsigned count = 0;
    for (int i = 0; i < 5; ++i) count += column.bit(i) ? 1 : 0;
    for (std::size_t i = 4; i > 0; --i) counts_[i] = counts_[i - 1];
    counts_[0] = u<3>(count);
    unsigned total = 0;
    for (const u<3> c : counts_) total += c.value();
    return {total > 12, u<5>(total)};
  }

 private:
  RAM<u<4>, WIDTH, WIDTH> memory_;
  u<7> x_;
  std::array<u<3>, 5> counts_{};
};

class Bilinear {
 public:
  struct In {
    std::array<std::array<u<8>, 2>, 2> p;
    u<3> wx, wy;
  };
  struct Out {
    u<8> value;
  };
  Out step(const In& in) {
    const auto mix = [](auto a, auto b, u<3> w) { return a * (horopter::hls::lit<8>() - w) + b * w; };
    const auto top = mix(in.p[0][0], in.p[0][1], in.wx), bottom = mix(in.p[1][0], in.p[1][1], in.wx);
    const auto sum = mix(top, bottom, in.wy);
    return {u<8>((sum.value() + 32) >> 6)};
  }
};

/// Vectoring CORDIC: direction in 1/256 turn.
class Cordic {
 public:
  struct In {
    s<11> x, y;
  };
  struct Out {
    u<8> direction;
  };
  Out step(const In& in) {
    static constexpr std::array<int, 8> kAngles{512, 302, 160, 81, 41, 20, 10, 5};  // atan 2^-i, 4096 to the turn
    int x = in.x.value() * 8, y = in.y.value() * 8, angle = 0;
    if (x < 0) {
      x = -x;
      y = -y;
      angle = 2048;
    }
    for (unsigned i = 0; i < kAngles.size(); ++i) {
      const int dx = x >> i, dy = y >> i;
      if (y > 0) {
        x += dy;
        y -= dx;
        angle += kAngles[i];
      } else {
        x -= dy;
        y += dx;
        angle -= kAngles[i];
      }
    }
    return {u<8>((angle + 8) >> 4)};
  }
};

/// Octant, ratio by reciprocal table, arctangent table.
class TableDirection {
 public:
  struct In {
    s<9> x, y;
  };
  struct Out {
    u<8> direction;
    u<8> shift;
  };
  Out step(const In& in) {
    unsigned ax = static_cast<unsigned>(std::abs(in.x.value())), ay = static_cast<unsigned>(std::abs(in.y.value()));
    const bool swap = ay > ax;
    if (swap) std::swap(ax, ay);
    unsigned shift = 0;
    while (shift < 8 && (ax >> 7) == 0 && ax != 0) {
      ax <<= 1;
      ay <<= 1;
      ++shift;
    }
    const unsigned ratio = ax == 0 ? 0 : std::min(63U, (ay * kReciprocal[(ax >> 2) & 63]) >> 10);
    unsigned angle = kArctangent[ratio];
    if (swap) angle = 64 - angle;
    if (in.x.value() < 0) angle = 128 - angle;
    if (in.y.value() < 0) angle = 256 - angle;
    return {u<8>(angle), u<8>(shift)};
  }

 private:
  static constexpr std::array<unsigned, 64> kReciprocal = [] {
    std::array<unsigned, 64> table{};
    for (unsigned i = 0; i < 64; ++i) table[i] = i < 16 ? 4095 : 65536 / (4 * i + 2) / 2;
    return table;
  }();
  static constexpr std::array<unsigned char, 64> kArctangent = [] {
    std::array<unsigned char, 64> table{};
    for (unsigned i = 0; i < 64; ++i) table[i] = static_cast<unsigned char>((i * (4000 - 14 * i)) / 6250);
    return table;
  }();
};

}  // namespace kernels
