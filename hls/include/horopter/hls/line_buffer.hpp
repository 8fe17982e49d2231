// SPDX-License-Identifier: Apache-2.0
// Where a beat stands in its frame, counted from the marks of a stream, and what window stages keep per column.
//
// A window stage reads the word of its column (what it needs of the rows above), computes, and writes the word back.
// The column restarts with each row, so a lost mark cannot shift the picture for longer than to the next row, and
// everything that a stage accumulates starts anew with each row or frame.
#pragma once

#include "horopter/hls/int.hpp"
#include "horopter/hls/ram.hpp"

namespace horopter::hls {

/// Shortest row of a stream, in beats: the time a memory word has from its read to the next read. See RAM.
inline constexpr int min_row_beats = 16;

/// One word per column of a stream with at most BEATS beats a row.
template <class Word, int BEATS>
using ColumnMemory = RAM<Word, static_cast<std::size_t>(BEATS), min_row_beats>;

/// Position of a beat.
template <int BEATS, int ROWS>
struct RasterPosition {
  u<bits_for(BEATS - 1)> column;  // 0 … BEATS − 1
  bool row_start = false;         // column 0
  bool frame_start_row = false;   // the frame's first row
  u<bits_for(ROWS)> rows;         // rows of this frame above this one, at most ROWS
};

/// Counts columns, and rows up to ROWS, by `first` (first beat of a frame) and `last` (last beat of a row).
template <int BEATS, int ROWS>
class Raster {
 public:
  RasterPosition<BEATS, ROWS> step(bool first, bool last) {
    RasterPosition<BEATS, ROWS> position;
    position.row_start = first || row_ended_;
    if constexpr (count_ahead) {
      if (position.row_start) [[unlikely]] {
        column_ = Column(0);
      }
      position.column = column_;
      column_ += lit<1>();
    } else {
      column_ = position.row_start ? Column(0) : Column(column_ + lit<1>());
      position.column = column_;
    }
    if (first) [[unlikely]] {
      rows_ = u<bits_for(ROWS)>(0);
    }
    position.rows = rows_;
    position.frame_start_row = rows_ == 0;
    if (last) [[unlikely]] {
      rows_ += u<1>(rows_ != ROWS);
    }
    row_ended_ = last;
    return position;
  }

#ifndef __HLSC__
  /// Beats that neither begin nor end a row.
  void skip(int beats) { column_ = Column(column_.value() + beats); }
#endif

 private:
  using Column = u<bits_for(BEATS - 1)>;

  // Long rows come at fast clocks: the register holds the next beat's column, for nothing but a multiplexer to come
  // before a memory's address. Otherwise it holds this beat's, and serves as the address to write as well.
  static constexpr bool count_ahead = BEATS > 1024;

  Column column_{0};
  u<bits_for(ROWS)> rows_{0};
  bool row_ended_ = true;
};

}  // namespace horopter::hls
