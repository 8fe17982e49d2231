// SPDX-License-Identifier: Apache-2.0
// cells: one camera's image reduced to the means of its cells, squares of CELL × CELL px. One instance per camera, on the
// pixels as they arrive, for the check of both images (stages/coarse.hpp).
//
// In      pixel; first: of the frame; last: of a row.
// Out     valid: a cell is complete, with its last pixel. mean: of the cell, rounded down; start: the row's first cell.
//         Cells come in raster order. Columns and rows that do not fill a cell are left out.
// Memory: the sums of a row of cells. Rows of at least hls::min_row_beats.
// Illegal use: a row of another length than those before it in the same row of cells gives wrong means, until `first`.
#pragma once

#include "horopter/hls/line_buffer.hpp"
#include "stages/stream.hpp"

namespace horopter::stages {

template <int WIDTH, int CELL>
class CellMeans {
  static constexpr int inner_bits = bits_for(CELL - 1);
  static constexpr int column_bits = bits_for(WIDTH / CELL);
  static_assert(CELL == 1 << inner_bits, "the side of a cell is a power of two");

 public:
  struct In {
    u<8> pixel;
    bool first = false;
    bool last = false;
  };
  struct Out {
    bool valid = false;
    u<8> mean;
    bool start = false;
  };

  Out step(const In& in) {
    if (in.first) [[unlikely]] {
      x_ = u<inner_bits>(0);
      y_ = u<inner_bits>(0);
      column_ = u<column_bits>(0);
    }
    const bool right_edge = x_ == CELL - 1;
    const bool lower_edge = y_ == CELL - 1;
    row_sum_ = u<8 + inner_bits>((x_ == 0 ? u<8 + inner_bits>(0) : row_sum_) + in.pixel);
    Sum sum(0);
    sums_.begin_step();
    if (right_edge) {
      const Sum stored = sums_.read(column_);
      sum = Sum((y_ == 0 ? Sum(0) : stored) + row_sum_);
      sums_.write(column_, sum);
    }
    Out out;
    out.valid = right_edge && lower_edge;
    out.mean = u<8>(shr<2 * inner_bits>(sum));
    out.start = column_ == 0;

    x_ += lit<1>();
    if (right_edge) column_ += lit<1>();
    if (in.last) {
      x_ = u<inner_bits>(0);
      column_ = u<column_bits>(0);
      y_ += lit<1>();
    }
    return out;
  }

 private:
  using Sum = u<8 + 2 * inner_bits>;

  ColumnMemory<Sum, 1 << column_bits> sums_;
  u<inner_bits> x_{0};  // in its cell
  u<inner_bits> y_{0};
  u<column_bits> column_{0};
  u<8 + inner_bits> row_sum_{0};
};

template <Profile P>
using Cells = CellMeans<P.width, P.cell()>;

}  // namespace horopter::stages
