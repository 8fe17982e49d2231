// SPDX-License-Identifier: Apache-2.0
// blind: which pixels that cannot be decided stand for something that is there. What could be decided while the zone was
// known to be empty, and cannot be decided now, has become blind: a plain glove before a textured wall, say. The thesis
// calls a place without texture undecidable and leaves it at that (11.2.2).
//
// The result is divided into blocks of SIDE×SIDE pixels; what remains at the right edge belongs to the last block of its row.
// While `teach` is set, the largest number of undecidable pixels is kept for each block, over all frames. Afterwards, with
// `watch`, a block that has more than that and a margin is blind, and so are its undecidable pixels. A block is known with
// its last row. So pixels leave SIDE + 1 rows after they came, and after a frame they have to be fetched.
//
// In      the pixels of the result in raster order: first, last of a row. After the frame: beats with `idle`, not pixels,
//         until `done`. A frame in which no idle beat follows has taught nothing for good.
// Config  width, height: of the frame; they, teach, watch: taken with its first pixel. The first frame with `teach` after one
//         without it forgets what was taught. blind_margin: in 1/64 of a block's pixels. Never taught is taught that
//         everything can be decided, and so is a block of which the number kept is damaged. forget: with the first pixel,
//         too; the frame before this one taught, but had a fault or an alarm: what was taught is not true.
// Out     there: a pixel leaves, with its state and its marks; blind: it is in a blind block, and undecidable.
//         done: none is left. taught: at least one frame was.
// Memory: SIDE + 1 rows of states, and two numbers a block. Reset forgets that anything was taught.
#pragma once

#include "horopter/hls/sliced_memory.hpp"
#include "stages/stream.hpp"

namespace horopter::stages {

template <int WIDTH, int HEIGHT, int SIDE>
class BlindBlocks {
  static constexpr int inner_bits = bits_for(SIDE - 1);
  static_assert(SIDE == 1 << inner_bits, "the side of a block is a power of two");
  static constexpr int rows_kept = SIDE + 1;
  static constexpr int blocks_across = WIDTH / SIDE;
  static constexpr int blocks_down = (HEIGHT + SIDE - 1) / SIDE;

 public:
  struct In {
    u<2> state;
    bool first = false;
    bool last = false;
    bool idle = false;
  };
  struct Config {
    u<bits_for(WIDTH)> width;
    u<bits_for(HEIGHT)> height;
    bool watch = false;
    bool teach = false;
    bool forget = false;
    u<8> blind_margin;
  };
  struct Out {
    bool there = false;
    u<2> state;
    bool blind = false;
    bool first = false;
    bool last = false;
    bool done = false;
    bool taught = false;
  };

  Out step(const In& in, const Config& config) {
    counts_.begin_step();
    taught_.begin_step();
    blind_.begin_step();
    states_.begin_step();
    const bool pixel = !in.idle, first = pixel & in.first, fetches = !pixel & more_;
    const bool last = pixel ? in.last : at_end_;
    const Column x = (first | row_ended_) ? Column(0) : x_;
    if (first) begin(config);
    if (!pixel & !ended_) {
      ended_ = true;
      if (teaches_) session_ = has_taught_ = true;
    }
    Out out;
    out.done = !pixel & !more_;
    const u<bits_for(WIDTH - 1) - inner_bits> at = x.template bits<bits_for(WIDTH - 1) - 1, inner_bits>();
    // Of a frame's first pixel 0, whatever the last block of the frame before.
    const Block block(at < last_block_ ? Block(at) : last_block_);
    if (pixel | fetches) pass(in.state, x, block, out);
    if (pixel) learn(in, x, block, block == last_block_, config);
    if (first) last_block_ = last_block_of(config.width);
    out.last = last;
    const Row fewer(rows_expected_ - lit<1>());
    const bool ends = (pixel | fetches) & last;
    if (ends) end_row();
    // Not from the height that has just come, which takes long: a frame's first pixel ends no row.
    if (first | ends) rows_expected_ = first ? Row(config.height) : fewer;
    if (pixel & last) before_end_ = before_;
    at_end_ = !last & (x >= before_end_);
    row_ended_ = last;
    before_ = x;
    x_ = Column(x + lit<1>());
    const RowsKept left = rows_left_;
    if (first | (fetches & last)) {
      rows_left_ = first ? RowsKept(rows_kept) : RowsKept(left - lit<1>());
      more_ = first | (left != 1);
    }
    out.taught = has_taught_;
    return out;
  }

#ifndef __HLSC__
  /// For an engine that leaves out frames of which nothing can be blind. Whether something is taught.
  bool leave_out(const Config& config) {
    begin(config);
    return has_taught_;
  }
#endif

 private:
  using Column = u<bits_for(WIDTH - 1)>;
  using Row = u<bits_for(HEIGHT)>;
  using Block = u<bits_for(blocks_across - 1)>;
  using RowCount = u<inner_bits + 1>;
  static constexpr int count_bits = bits_for(SIDE * (2 * SIDE - 1));
  using Count = u<count_bits>;
  // What is kept of a block stays for as long as the machine runs: in steps of 2^coarse, 1/64 of a block's pixels, rounded
  // up, with a parity bit.
  static constexpr int coarse = 2 * inner_bits - 6;
  static constexpr int word_bits = count_bits - coarse + 1;
  using Word = u<word_bits>;
  static constexpr std::size_t all_blocks = std::size_t{blocks_across} * blocks_down;
  using Place = u<bits_for(all_blocks - 1)>;
  // So deep that slices of 2 bits take no more block memories than whole words do.
  using TaughtMemory = std::conditional_t<(all_blocks > 6144), SlicedMemory<word_bits, all_blocks, min_row_beats>,
                                          RAM<Word, all_blocks, min_row_beats>>;
  using States = u<2 * rows_kept>;
  using RowsKept = u<bits_for(rows_kept)>;

  static bool odd(Word word) {
    bool sum = false;
    for (int i = 0; i < word_bits; ++i) sum = sum != word.bit(i);
    return sum;
  }
  static Word even(u<word_bits - 1> value) { return Word(cat(u<1>(odd(Word(value))), value)); }

  /// Frames have 32 columns at least (horopter/hls/table_format.hpp), and so two blocks.
  static Block last_block_of(u<bits_for(WIDTH)> width) {
    const auto blocks = width.template bits<bits_for(WIDTH) - 1, inner_bits>();
    return Block(blocks < 2 ? 1 : blocks > blocks_across ? blocks_across - 1 : blocks.value() - 1);
  }

  void begin(const Config& config) {
    has_taught_ = has_taught_ && !config.forget && (session_ || !config.teach);
    session_ = session_ && !config.forget && config.teach;
    teaches_ = config.teach;
    watches_ = config.watch && !config.teach;
    ended_ = false;
    last_row_ = false;
    inner_row_ = u<inner_bits>(0);
    odd_ = first_above_ = false;
    new_block_ = true;
    place_ = Place(0);
    above_ = RowsKept(0);
  }

  /// The pixel SIDE + 1 rows above leaves.
  void pass(u<2> state, Column x, Block block, Out& out) {
    const States column = states_.read(x);
    states_.write(x, States(cat(column.template bits<2 * rows_kept - 3, 0>(), state)));
    // It is in the row of blocks before this one; with a row of blocks' first row, in the one before that.
    const bool odd = odd_ == (inner_row_ == 0);
    out.there = above_ == rows_kept;
    out.state = column.template bits<2 * rows_kept - 1, 2 * rows_kept - 2>();
    if (out.there) out.blind = blind_.read(cat(block, u<1>(odd))) == 1 && out.state == state::undecidable;
    out.first = first_above_ && x == 0;
  }

  void learn(const In& in, Column x, Block block, bool last_block, const Config& config) {
    const bool ends = in.last || (x.template bits<inner_bits - 1, 0>() == SIDE - 1 && !last_block);
    in_row_ = RowCount((new_block_ ? RowCount(0) : in_row_) + u<1>(in.state == state::undecidable));
    new_block_ = ends;
    if (!ends) return;
    const Count above = counts_.read(block);
    const Count count((inner_row_ == 0 ? Count(0) : above) + in_row_);
    counts_.write(block, count);
    if (inner_row_ != SIDE - 1 && !last_row_) return;
    const Place place(place_ + block);
    const Word word = taught_.read(place);
    const bool unknown = odd(word) || !has_taught_;
    const auto value = word.template bits<word_bits - 2, 0>();
    const Count known(unknown ? u<count_bits>(0) : shl<coarse>(value));
    const auto stored = shr<coarse>((known < count ? count : known) + lit<(1 << coarse) - 1>());
    if (teaches_) taught_.write(place, even(u<word_bits - 1>(stored)));
    const auto raised = value + config.blind_margin;
    const auto limit = shl<coarse>(unknown ? decltype(raised)(config.blind_margin) : raised);
    blind_.write(cat(block, u<1>(odd_)), u<1>(watches_ && count > limit));
  }

  void end_row() {
    first_above_ = above_ == SIDE;
    if (above_ != rows_kept) above_ += lit<1>();
    if (inner_row_ == SIDE - 1) {
      odd_ = !odd_;
      place_ = Place(place_ + lit<blocks_across>());
    }
    inner_row_ += lit<1>();
    last_row_ = rows_expected_ == 2;
  }

  ColumnMemory<States, WIDTH> states_;
  RAM<Count, blocks_across, min_row_beats> counts_;                   // undecidable in this row of blocks so far
  TaughtMemory taught_;                                               // largest number of a frame
  RAM<u<1>, 2 << bits_for(blocks_across - 1), min_row_beats> blind_;  // of two rows of blocks in turn
  Column x_{0};                                                       // of the next pixel, unless a row begins
  Column before_{0}, before_end_{WIDTH - 2};                          // the last row's last column but one
  Row rows_expected_{0};                                              // this one and those below
  bool last_row_ = false;                                             // of them
  u<inner_bits> inner_row_{0};
  Block last_block_{0};  // of a row
  bool odd_ = false;     // row of blocks
  Place place_{0};       // its first block
  RowCount in_row_{0};   // undecidable, in this row of the block so far
  bool new_block_ = true;
  RowsKept above_{0};      // rows kept
  RowsKept rows_left_{0};  // to fetch after the frame
  bool more_ = false;      // some of them
  bool row_ended_ = true;
  bool at_end_ = false;       // of the row, when these are fetched
  bool first_above_ = false;  // the row that leaves is the frame's first
  bool ended_ = true;
  bool teaches_ = false, watches_ = false;
  bool session_ = false;  // a whole frame has been taught, and none without since
  bool has_taught_ = false;
};

template <Profile P>
using Blind = BlindBlocks<P.result_width(), P.height, P.cell()>;

}  // namespace horopter::stages
