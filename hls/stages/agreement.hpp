// SPDX-License-Identifier: Apache-2.0
// agreement: do both cameras see the same world, and is it behind the skin? *Clear* is earned: it needs a place that both
// cameras are shown to see (thesis 2.3, 9; nothing there says how: this is a coarse stereo of our own).
//
// Around the skin, where the mapping table says what is compared there, cells count like those of the skin, but for what
// is hidden: a small skin in a large image does not make a blind camera look like a small one.
//
// Both images are taken in cells of `cell` px (census.hpp). When a row of cells is complete, every cell of the row three
// above is compared with the right one's at all shifts of ±reach cells along the row and ±2 across: census codes, summed
// over 7×3 cells. A textured cell is *explained* where its best shift fits well, and the right cell chooses it back (±1).
// Shift 0 is the skin; which side of it is nearer to the cameras, and which shifts mean a place in front of both, come
// with the skin (Config). Where a row of cells lasts long enough, two beats share the sums that five displacements across
// need. A row is done before the next one is complete, the last one before the next frame. The two rows above the lowest three
// are compared with the first rows of the next frame, for the map of their own; they count nowhere.
//
// Of a frame it says (Verdict, once, in the rows behind the frame): how much is textured, explained, nearer than the skin;
// whether too little is explained in all (disagree), in too many regions of 8×6, or around too many cells, of all or of
// the skin alone (also disagree); whether the right image is displaced across the rows against what the cameras' geometry
// says (moved: in the median of the image, or of a half, so that a camera that is displaced, rolled or enlarged is found;
// of cells at once, of a round of patches at full resolution);
// whether one camera is less sharp, or has less contrast (unsharp); whether too much is hidden behind what is nearer
// (hidden, after hidden_frames frames in a row);
// whether much lies on the skin (overlooked: cells of this frame, of which the best shift is 0, and that within 1/8 cell; or
// places of a round of patches). The rule judges pixels by other means, and must have seen it.
// Of a pixel of the result it says in the marks what the frame before showed of its cell: `seen`, in 5×5 cells around there
// are a third as many *shown* ones as textured ones (where there is no texture, explained ones of its region); `nearer`,
// most of these are nearer. A cell is shown where the left camera's cell is explained by windows of 3×3 cells, or the right
// camera's that is compared with it at shift 0: what one camera sees there, the other sees elsewhere. So nothing is on the
// skin. Near the image's edges and beside near things only one of the two may be. Faults take the windows of 7×3 alone.
//
// In, Out  pixels pass. Marks: seen and nearer belong to the pixel of the result that leaves `align` with this beat.
// Config   prove = 0: everything counts as seen, and nothing is said. Illegal use: another size without a reset between.
// What a frame showed comes as words (FrameWord), one a beat; the verdict is the last.
// Memory: see census.hpp, registration.hpp, patches.hpp; codes of 5 and 7 rows; best of a row; regions; the map of the image, twice.
#pragma once

#include <algorithm>
#include <limits>

#include "stages/align.hpp"
#include "stages/census.hpp"
#include "stages/count_bits.hpp"
#ifndef __HLSC__
#include "stages/compared_row.hpp"
#endif
#include "stages/division.hpp"
#include "stages/patches.hpp"
#include "stages/registration.hpp"
#include "stages/subsample.hpp"

namespace horopter::stages {

/// What a frame showed; once a frame, behind its words.
struct Verdict {
  bool valid = false;
  bool unproven_yet = false;  // no frame before this one, or no rounds of places say whether a camera moved
  bool untextured = false;    // too little to tell
  bool disagree = false;
  bool moved = false;
  bool unsharp_left = false;
  bool unsharp_right = false;
  bool hidden = false;
  bool overlooked = false;  // too much lies on the skin; a fault where there is no alarm
  bool out_of_step = false;
};

/// The figures behind it, as registers have them (rtl/csr/registers.yaml): FRAME_REGION of the regions, 8 in a row; then
/// FRAME_AGREEMENT … FRAME_PATCHES.
struct FrameWord {
  static constexpr int regions = 48;
  static constexpr int first_of_frame = 52;
  static constexpr int count_of_frame = 12;
  bool valid = false;
  u<6> index;
  u<32> word;
};

/// On the CPU a row is compared at once, and beats in which the sweep has nothing else to do are left out. Where memories
/// are checked everything takes the hardware's beats. The results are the same.
#if defined(__HLSC__) || !defined(HOROPTER_HLS_UNCHECKED)
inline constexpr bool agreement_at_once = false;
#else
inline constexpr bool agreement_at_once = true;
#endif

template <Profile P, bool AT_ONCE = agreement_at_once>
class Agreement {
 public:
  static constexpr int cell = P.cell();  // px
  static constexpr int columns = P.result_width() / cell;
  static constexpr int rows = P.height / cell;
  static constexpr int reach = 29;  // cells; what there is time for in vga
  static constexpr int region_columns = 8;
  static constexpr int region_rows = 6;
  static constexpr int regions = region_columns * region_rows;
  static_assert(regions == FrameWord::regions);

  using Pixels = std::array<u<8>, static_cast<std::size_t>(P.stream_lanes())>;
  struct In {
    Pixels pixel{};
    bool saturated = false;
    bool mask = false;
    bool present = false;
    FrameMarks marks;
  };
  struct Config {
    u<bits_for(P.result_width())> width;
    u<bits_for(P.height)> height;
    u<1> compete;
    u<1> prove;
    s<6> shift_lowest;  // cells: shifts that mean a place in front of both cameras
    s<6> shift_highest;
    u<1> nearer_below;         // shifts below 0 are nearer than the skin
    u<1> nearer_above;         // shifts above 0 are
    u<8> explained_limit;      // smallest share of the textured cells that is explained, in 1/256
    u<8> regions_limit;        // largest share of the textured cells that may lie in bad regions, in 1/256
    u<8> unproven_limit;       // largest share of the textured cells that may not be seen, in 1/256
    u<8> unproven_skin_limit;  // the same of the textured cells of the skin alone
    u<8> hidden_limit;         // largest share of the cells that may be nearer, in 1/256
    u<8> hidden_frames;        // for so many frames in a row, 1 to 255; 0 = never by this
    // 1/32 cell: a median of the displacement across the rows that is too large, of the image or, in opposite
    // directions (one that is rolled or enlarged), of two halves of it.
    u<6> moved_limit;
    u<6> moved_half_limit;  // the same of one half
    u<6> patch_limit;       // 1/8 px: the same at full resolution (patches.hpp)
    u<5> on_skin_limit;     // largest share of places, or of cells, on the skin, in 1/32; 31 = never
    u<8> on_skin_cells;     // so many cells on the skin are never too many: 4
    u<1> alarm_before;      // the frame before showed an alarm, and that counted
    u<1> same_table;        // the frame before of this field had the same mapping table
    s<16> epipolar_slope;   // displacement across the rows of a shift along them, at the first cell: 2^-15
    s<16> epipolar_column;  // its change from column to column: 2^-20
    s<16> epipolar_row;     // and from row to row: 2^-20
    s<16> epipolar_both;    // change of the one with the other: 2^-24
  };
  struct Out {
    Pixels pixel{};
    bool saturated = false;
    bool mask = false;
    Marks marks;
    Verdict verdict;
    FrameWord frame;
  };

  Out step(const In& in, const Config& config) {
#ifndef __HLSC__
    if constexpr (at_once) {
      if (quiet_beats_ > 0) return quiet_beat(in, config);
    }
#endif
    return beat(in, config);
  }

#ifndef __HLSC__
  /// Beats of a row that follow each other in memory, and what step() would say of them in the marks.
  struct Beats {
    const u<8>*left, *right;
    const bool *mask, *present;
    bool *seen, *nearer;
  };
  /// Takes beats in which nothing happens but that pixels are summed to cells, several at once, none of them the first or
  /// last of a row. Before `beats` stands the row's beat before. Returns how many, at most `count`; after 0 of them step()
  /// must take the next one.
  int pass_beats(const Beats& beats, int count, const Config& config) {
    if constexpr (!at_once || P.packed()) {
      return 0;
    } else {
      const bool may = !said_ && !drew_ && !sample_.pair.first && !sample_.last && !raster_.begins_row() &&
                       columns_passed_ == 0 && !was_next_row_ && !line_ended_;
      if (!may) return 0;
      const auto at = raster_.next();
      const int passed = pass_cells(beats, std::min(count, quiet_beats_), config);
      if (passed == 0) return 0;
      patches_.skip(passed, config);
      patches_.take_row(at, passed, beats.left - 1, beats.right - 1, beats.present - 1);
      quiet_beats_ -= passed;
      in_row_ = row_starts_ = false;
      const int last = passed - 1;
      sample_ = {{{beats.left[last], beats.right[last]}, false, true}, false, beats.present[last], beats.mask[last]};
      pass_map(beats, passed, config);
      return passed;
    }
  }
#endif

 private:
  static constexpr bool at_once = AT_ONCE;
  Out beat(const In& in, const Config& config) {
    begin_step();
    change_ = Change{};
    new_frame_ = row_starts_ = first_rows_ = false;
    const Pair pair = take(in);
    Out out = passed(in);
    early_region_row_ = next_region_row_;
    next_region_row_ = u<3>(region_row_ + lit<1>());
    region_down_.look();
    region_across_.look();
    in_row_ = run_.phase == Phase::conclude;
    next_cell_ = in_row_ && ends_cell_;
    const bool next_region = region_across_.at_end();
    if (next_cell_) region_across_.take();
    if (!in_row_) {
      region_across_.restart(columns_begin_);
      region_columns_ = 1;
      segment_starts_ = true;
    }
    const bool said = said_;
    said_ = false;
    const Run following = next_run();
#ifndef __HLSC__
    run_was_ = run_.phase;
#endif
    if (in_row_ && x_ < 8) sharpness_.compare(cat(x_.template bits<2, 0>(), slot_));
    // Flat between the switches is what must be short from register to register.
    ColumnsAlike columns_alike{};
    LeftCell here;
    RightCell there;
    switch (run_.phase) {
      case Phase::merge:
        merge();
        break;
      case Phase::compare:
        if constexpr (!at_once) columns_alike = compare();
        break;
      case Phase::match:
      case Phase::conclude:
        if (inside()) {
          here = left_.read(x_).age[middle];
          there = right_codes_.read(x_).age[middle];
        }
        break;
      case Phase::idle:
      case Phase::wait:
      case Phase::settle:
      case Phase::finish:
        break;
    }
#ifndef __HLSC__
    if (!at_once && run_.phase == Phase::compare)  // otherwise it does not matter: windows begin with a run
#endif
      add_columns(columns_alike);
    Looked looked;
    switch (run_.phase) {
      case Phase::compare:
        if constexpr (!at_once) choose();
        break;
      case Phase::match:
      case Phase::conclude:
        looked = look(here, config);
        break;
      case Phase::idle:
      case Phase::wait:
      case Phase::merge:
      case Phase::settle:
      case Phase::finish:
        break;
    }
    if (in_row_) registration_.step_peak(slot_, looked.best.peak);
    switch (run_.phase) {
      case Phase::match:
        match(looked, here.step, there.step);
        break;
      case Phase::conclude:
        conclude(looked, config, next_region);
        break;
      case Phase::finish:
        finish(out, config);
        break;
      case Phase::idle:
      case Phase::wait:
      case Phase::merge:
      case Phase::compare:
      case Phase::settle:
        break;
    }
    if constexpr (!at_once) look_at_shift(config);
    patches_.work(config);
    take_sample(config);
    advance(following, config);
    pass(in, pair, said, config);
    change_counts(config);
    mark(config, out);
    return out;
  }

#ifndef __HLSC__
  /// A beat in which the sweep has nothing to do, unless it completes a row of cells.
  [[gnu::always_inline]] Out quiet_beat(const In& in, const Config& config) {
    --quiet_beats_;
    const Pair pair = take(in);
    Out out = passed(in);
    const bool said = said_;
    said_ = in_row_ = row_starts_ = false;
    patches_.work(config);
    take_sample(config);
    if (row_starts_) end_wait(config);
    pass(in, pair, said, config);
    mark(config, out);
    return out;
  }

  /// Quarters of cells, of which the first pixel is that of the beat before. How many beats they are.
  int pass_cells(const Beats& beats, int count, const Config& config) {
    using Averager = decltype(averager_);
    constexpr int quarter = Averager::quarter;
    if (raster_.next().x.value() % quarter != 0) return 0;
    typename Averager::Pixels pixels{beats.left - 1, beats.right - 1, beats.present - 1, beats.mask - 1};
    const int quarters = std::max(0, count) / quarter;
    if (raster_.next().y != cell - 1) {
      if (quarters == 0) return 0;
      averager_.pass_quarters(raster_.next(), quarters, pixels);
      raster_.skip(quarters * quarter);
      return quarters * quarter;
    }
    // With the last cell a row of them is complete.
    const Index last(cells_of(config.width) - lit<1>());
    int passed = 0;
    for (; passed < quarters * quarter && raster_.next().column < last; passed += quarter, pixels += quarter) {
      const auto at = raster_.next();
      const CellGrey means = averager_.pass_quarter(at, pixels);
      raster_.skip(quarter);
      if (means.valid) take_cell(at, means, config);
    }
    return passed;
  }

  /// read_map() for beats within a row of the result.
  void pass_map(const Beats& beats, int count, const Config& config) {
    for (int i = 0; i < count;) {
      seen_column_ = Index(seen_column_ + u<1>(seen_x_ == cell - 1));
      seen_x_ = u<bits_for(cell - 1)>(seen_x_ + lit<1>());
      read_map_cell(cells_of(config.width), Index(shr<bits_for(cell - 1)>(config.height)));
      const int alike = std::min(count - i, cell - static_cast<int>(seen_x_.value()));
      std::fill_n(beats.seen + i, alike, config.prove == 0 || seen_);
      std::fill_n(beats.nearer + i, alike, config.prove != 0 && nearer_);
      seen_x_ = u<bits_for(cell - 1)>(static_cast<int>(seen_x_.value()) + alike - 1);
      i += alike;
    }
  }
#endif

  static constexpr int half_window = 3;               // columns
  static constexpr int window = 2 * half_window + 1;  // columns
  static constexpr bool fast = P.clock_khz > 50'000;
  static constexpr int gap = fast ? 24 : 12;  // beats from a memory word's use to the next
  static constexpr int across_reach = 2;      // rows
  static constexpr std::size_t across_count = 2 * across_reach + 1;
  static constexpr int best_score = window * 3 * census_bits;
  static constexpr int score_limit = best_score - 70;  // explained: more. 0.28 of all bits may differ
  static constexpr int best_near_score = 3 * 3 * census_bits;
  static constexpr int near_score_limit =
      best_near_score - 23;                        // by the small window: more. 0.2 of all bits may differ
  static constexpr int middle = across_reach + 1;  // age of the row that is compared
  static constexpr int first_row = 8;         // row of cells with which the first one that can be explained is done
  static constexpr int box = 5;               // cells around a place that must be seen
  static constexpr int lag = middle + 2 + 2;  // rows from a cell to its place in the map
  // In the first rows of the next frame the sweep has nothing else to do: then so many more of the lowest rows are
  // compared, and drawn. Those below them have no whole window.
  static constexpr int late_rows = middle - 1;
  static constexpr int late_drawn = late_rows + 2;
  static constexpr int least_textured = 40;
  static constexpr std::size_t column_count = static_cast<std::size_t>(columns);
  static constexpr std::size_t map_cells = static_cast<std::size_t>(columns * rows);

  using Index = u<8>;  // of a column or row of cells, and beyond
  using Age = u<std::max(window, box) + 1>;
  static_assert(columns + half_window + gap < 256 && rows < 128);
  using OfImage = Registration<columns, rows, gap, !fast>;
  using OfMoments = Moments<columns * rows, P.fields_per_image()>;
  using OfPatches = Patches<P, cell, gap, AT_ONCE>;
  using Shift = typename OfImage::Shift;
  static constexpr int slots = OfImage::slots;  // beats of a cell where a row concludes
  using Score = u<8>;
  using NearScore = u<7>;
  static_assert(best_score < 256 && best_near_score < 128);

  /// Beats that a column of a shift takes: two where a row of cells lasts long enough, and the rows behind the frame do.
  static constexpr int turns = [] {
    constexpr int row_beats = P.result_width() * (P.packed() ? 2 : 1);
    constexpr int compared_columns =
        columns + 2 * reach * columns - reach * (reach + 1) + (2 * reach + 1) * half_window;
    constexpr int other_beats = (slots + 3) * columns + 4 * gap + 128;
    return 2 * compared_columns + other_beats < std::min(cell, P.flush_rows()) * row_beats ? 2 : 1;
  }();

  // Pixels ------------------------------------------------------------------------------------------------------------

  struct Pair {
    std::array<u<8>, 2> pixel{};
    bool first = false;
    bool whole = false;  // both pixels are there
  };

  using Raster = CellRaster<cell, columns, rows, P.result_width(), P.height>;

  /// What is summed to cells, a beat later than it comes: the way from the stage before is short.
  struct Sample {
    Pair pair;
    bool last = false;
    bool present = false;
    bool of_skin = false;
  };

  Pair take(const In& in) {
    if constexpr (P.packed()) {
      const bool right = right_ && !in.marks.first;
      const Pair pair{{*left_pixel_, in.pixel[0]}, left_first_, right};
      if (!right) {
        *left_pixel_ = in.pixel[0];
        left_first_ = in.marks.first;
      }
      right_ = !right && !in.marks.last;
      return pair;
    } else {
      return {in.pixel, in.marks.first, true};
    }
  }

  void take_sample(const Config& config) {
    typename Raster::Position at;
    CellGrey means;
    if (sample_.pair.whole) {
      at = raster_.step(sample_.pair.first, sample_.last, config.height);
      means = averager_.step(at, sample_.pair.pixel, sample_.present, sample_.of_skin);
      patches_.take(at, sample_.pair.pixel, sample_.present, config);
    }
    if (means.valid) take_cell(at, means, config);
  }

  static Out passed(const In& in) {
    Out out;
    out.pixel = in.pixel;
    out.saturated = in.saturated;
    out.mask = in.mask;
    out.marks.first = in.marks.first;
    out.marks.last = in.marks.last;
    return out;
  }

  void pass(const In& in, const Pair& pair, bool said, const Config& config) {
    sample_ = {pair, in.marks.last, in.present, in.mask};
    if (pair.whole) read_map(pair.first, in.marks.last, config);
    // Rows beyond the height that was said: what they write to the map is not read.
    done_ = !(pair.whole && pair.first) && !drew_ && (done_ || said);
    drew_ = in_row_;
  }

  void mark(const Config& config, Out& out) const {
    out.marks.seen = config.prove == 0 || seen_;
    out.marks.nearer = config.prove != 0 && nearer_;
  }

  // Cells -------------------------------------------------------------------------------------------------------------

  static constexpr Index cells_of(u<bits_for(P.result_width())> pixels) {
    return Index(shr<bits_for(cell - 1)>(pixels));
  }

  template <class Position>
  void take_cell(const Position& at, const CellGrey& means, const Config& config) {
    if (at.column == 0) rows_passed_above_ = at.row == 0 ? u<5>(1) : u<5>(cat(rows_passed_above_, true));
    const CellCodes codes = census_.step(at.column, at.row == 0 && at.column == 0, rows_passed_above_.bit(4), means);
    sharpness_.step(at.row == 0 && at.column == 0, at.column < 2, means);
    fresh_.write(at.column, codes);
    if (at.column + lit<1>() == cells_of(config.width)) start_row(Index(at.row), Index(at.column), config);
  }

  /// A row of cells is complete: its codes join those above, and the row `middle` above is compared.
  void start_row(Index row, Index last, const Config& config) {
    const Index count(shr<bits_for(cell - 1)>(config.height));
    row_starts_ = true;
    least_ = last >= reach ? Index(reach) : last;
    const bool follows = proven_ && count > first_row;
    late_ = follows && row < late_rows;
    draws_late_ = follows && row < late_drawn;
    map_row_ = row <= lag && !draws_late_ ? MapIndex(0) : MapIndex(map_row_ + map_width_);
    map_width_ = cells_of(config.width);
    first_rows_ = row <= middle;
    patches_.start_row(row >= middle + 2, row == middle + 2);
    columns_begin_.begin(map_width_, u<2>(2));
    last_ = last;
    whole_ = Index(last + lit<gap>());
    drawn_ = Index(last + lit<tail>());
    row_ = row;
    final_row_ = row + lit<1>() == count;
    lower_half_ = shl<1>(row) >= count + lit<2 * (lag - 2)>();
#ifndef __HLSC__
    if (at_once) {
      // As of the beats before, which may have been left out.
      early_region_row_ = u<3>(region_row_ + lit<1>());
      region_down_.look();
      region_down_.look();
    }
#endif
    if (row == 0) new_frame_ = true;
    static_assert(lag > 2);
    if (row > lag - 2) {  // the region of the row that is compared
      const bool next = region_down_.at_end();
      region_fresh_ = next;
      if (next) region_row_ = early_region_row_;
      region_down_.take();
    } else {
      if (!draws_late_) region_row_ = 0;  // the last region that was judged is theirs, too
      if (row == 0) {
        region_down_.begin(count, u<2>(0));
        region_fresh_ = true;
      }
    }
  }

  // The sweep ---------------------------------------------------------------------------------------------------------

  enum class Phase : std::uint8_t { idle, wait, merge, compare, settle, match, conclude, finish };

  /// A pass over columns of cells: x_ goes from `lowest` on, `columns` further ones: those that are there, and then until
  /// the memories are ready again. A column takes `turns` beats where shifts are compared, `slots` where a row concludes.
  struct Run {
    Phase phase = Phase::idle;
    Shift shift;
    bool last_shift = false;
    Index span;  // columns compared, less one
    Index lowest, columns;
  };
  static constexpr int tail = 4;  // columns behind the last one, until the map of that is drawn
  static constexpr int least_columns = (gap + turns - 1) / turns;

  /// To the next beat. Flat, so that the way from register to register is short.
  void advance(const Run& following, [[maybe_unused]] const Config& config) {
    Run wait;  // until the last codes can be read
    wait.phase = Phase::wait;
    wait.columns = gap;
    const bool next_column = ends_cell_;
    const bool last_slot = run_.phase == Phase::compare || slot_ == slots - 2;  // comes next
    const bool begins = row_starts_ || (next_column && ends_);
    const Run next = row_starts_ ? wait : following;
    x_ = begins ? next.lowest : Index(x_ + u<1>(next_column));
    ends_ = !begins && (next_column ? columns_left_ == 1 : ends_);
    columns_left_ = begins ? next.columns : Index(columns_left_ - u<1>(next_column));
    age_ = begins ? Age(1) : (next_column ? Age(cat(age_, true)) : age_);
    slot_ = begins || next_column ? u<3>(0) : u<3>(slot_ + lit<1>());
    const Phase now = begins ? next.phase : run_.phase;
    const bool lasts = now == Phase::conclude || (turns > 1 && now == Phase::compare);
    ends_cell_ = begins || next_column ? !lasts : last_slot;
    run_.phase = now;
    run_.shift = begins ? next.shift : run_.shift;
    run_.last_shift = begins ? next.last_shift : run_.last_shift;
    run_.span = begins ? next.span : run_.span;
#ifndef __HLSC__
    if constexpr (at_once) {
      if (begins) skip_quiet_beats(config);
    }
#endif
  }

#ifndef __HLSC__
  /// A row of cells is complete in a quick beat.
  void end_wait(const Config& config) {
    registration_.begin_step();
    change_ = Change{};
    next_cell_ = false;
    run_was_ = Phase::idle;
    advance({}, config);
    change_counts(config);
    new_frame_ = first_rows_ = false;
  }

  /// A run begins. If it only waits for memories, or if all that it compares is compared at once, its last beat is the
  /// next one in which the sweep does something.
  void skip_quiet_beats(const Config& config) {
    quiet_beats_ = 0;
    switch (run_.phase) {
      case Phase::idle:
        quiet_beats_ = std::numeric_limits<int>::max();
        return;
      case Phase::compare:
        if (s<9>(run_.shift) == -s<9>(least_)) compare_row(config);
        break;
      case Phase::wait:
      case Phase::settle:
        break;
      case Phase::merge:
      case Phase::match:
      case Phase::conclude:
      case Phase::finish:
        return;
    }
    const int columns_further = static_cast<int>(columns_left_.value());
    const int beats_of_column = run_.phase == Phase::compare ? turns : 1;
    quiet_beats_ = beats_of_column * (columns_further + 1) - 1;
    x_ = Index(x_ + columns_left_);
    columns_left_ = 0;
    age_ = Age::max();
    slot_ = beats_of_column - 1;
    ends_ = ends_cell_ = true;
  }
#endif
  /// At least so many columns of the run lie before this one.
  template <int COLUMNS>
  [[nodiscard]] bool after() const {
    static_assert(COLUMNS < Age::width);
    return age_.bit(COLUMNS);
  }
  /// The column that is compared with x_; the same where none is.
  [[nodiscard]] Index partner() const { return Index(s<10>(x_) + run_.shift); }
  /// The image has both.
  [[nodiscard]] bool inside() const { return (run_.shift.negative() ? x_ : partner()) <= last_; }

  /// What comes after this run, where it ends with this beat.
  Run next_run() {
#ifndef __HLSC__
    if constexpr (at_once) {
      if (!ends_ || !ends_cell_) return {};
      look_ahead();
      look_ahead();
      return following_;
    }
#endif
    const Run following = following_;
    look_ahead();
    return following;
  }
  /// What comes after a run: the next shift and its span first, then all of it, each from registers of the beat before. A
  /// run takes longer than that.
  void look_ahead() {
    const Phase now = run_.phase;
    const bool compares = now == Phase::compare;
    const bool shifts_follow = now == Phase::merge || (compares && !run_.last_shift);
    const bool settles = compares && run_.last_shift;
    const bool finishes = now == Phase::conclude && final_row_;
    const auto only = [](bool so, Index value) { return so ? value : Index(0); };
    Run next;
    next.phase = now == Phase::wait     ? Phase::merge
                 : shifts_follow        ? Phase::compare
                 : settles              ? Phase::settle
                 : now == Phase::settle ? Phase::match
                 : now == Phase::match  ? Phase::conclude
                 : finishes             ? Phase::finish
                                        : Phase::idle;
    next.shift = shifts_follow ? plan_.shift : Shift(0);
    next.last_shift = shifts_follow && plan_.shift == least_;
    next.span = plan_.span;
    next.lowest = only(shifts_follow && plan_.shift.negative(), Index(-plan_.shift)) |
                  only(now == Phase::conclude, Index(finish_begins));
    // Behind the columns that there are, memories get ready, and the map is drawn.
    next.columns = only(shifts_follow, plan_.columns) | only(now == Phase::wait || now == Phase::settle, whole_) |
                   only(settles, Index(gap)) | only(now == Phase::match, drawn_) |
                   only(now == Phase::conclude, Index(finish_ends - finish_begins));
    following_ = next;
    plan_.columns =
        plan_.span < least_columns - half_window ? Index(least_columns) : Index(plan_.span + lit<half_window>());
    plan_.shift = compares ? Shift(run_.shift + lit<1>()) : Shift(-s<9>(least_));
    plan_.span = compares ? Index(run_.span + (run_.shift.negative() ? s<2>(1) : s<2>(-1))) : Index(last_ - least_);
  }

  struct LeftCell {
    u<census_bits> code;
    bool valid = false;
    bool supervised = false;
    bool textured = false;
    bool of_skin = false;
    Step step;
  };
  struct RightCell {
    u<census_bits> code;
    bool valid = false;
    Step step;
  };
  struct LeftColumn {
    std::array<LeftCell, middle + 2> age{};  // the newest row first
  };
  struct RightColumn {
    std::array<RightCell, 2 * middle + 1> age{};
  };

  void merge() {
    if (!inside()) return;
    const CellCodes codes = fresh_.read(x_);
    LeftColumn left = left_.read(x_);
    RightColumn right = right_codes_.read(x_);
    const bool rows_above = row_ != 0 || late_;
    for (std::size_t a = left.age.size() - 1; a > 0; --a) left.age[a] = left.age[a - 1];
    for (std::size_t a = right.age.size() - 1; a > 0; --a) right.age[a] = right.age[a - 1];
    for (std::size_t a = 1; a < left.age.size(); ++a) left.age[a].valid = left.age[a].valid && rows_above;
    for (std::size_t a = 1; a < right.age.size(); ++a) right.age[a].valid = right.age[a].valid && rows_above;
    left.age[0] = {codes.left, codes.left_valid, codes.supervised, codes.textured, codes.of_skin, codes.left_step};
    right.age[0] = {codes.right, codes.right_valid, codes.right_step};
    left_.write(x_, left);
    right_codes_.write(x_, right);
  }

  static constexpr int column_bits = 3 * census_bits;
  using ColumnBits = u<column_bits>;
  using ColumnCount = u<bits_for(column_bits)>;

  static u<census_bits> alike(const LeftCell& l, const RightCell& r) {
    return l.valid && r.valid ? u<census_bits>(~(l.code ^ r.code)) : u<census_bits>(0);
  }

  using Peak = Displacement::Peak;
  struct BestLeft {
    Shift shift;
    Peak peak;
    NearScore near_score;
    Shift near_shift;
    Score before, behind;  // at shifts -1 and 1
  };
  struct BestRight {
    Score score;
    u<7> x;
    NearScore near_score;
    u<7> near_x;
  };
  using Scores = std::array<Score, across_count>;

  // Displacements across the rows, first those that count where scores are equal. With two turns, the middle one has its
  // sum for itself, and two sums serve two of the others each.
  static constexpr std::size_t units = turns == 1 ? across_count : (across_count + 1) / 2;
  static constexpr std::array<std::size_t, across_count> places{2, 1, 3, 0, 4};
  static constexpr std::size_t place_of(std::size_t unit, bool second) {
    return places[second && unit > 0 ? unit + 2 : unit];
  }
  struct Choice {
    Score score;
    NearScore near;
    u<3> place;
  };

  using ColumnsAlike = std::array<ColumnCount, units>;

  /// Bits that agree, of a column of three cells, for each displacement across the rows.
  ColumnsAlike compare() {
    const bool second = turns == 2 && slot_.bit(0);
    LeftColumn left;
    RightColumn right;
    if (inside()) {
      left = left_.read(x_);
      right = right_codes_.read(partner());
    }
    ColumnsAlike columns_alike{};
    for (std::size_t n = 0; n < units; ++n) {
      std::array<u<census_bits>, 3> rows_alike{};
      for (std::size_t i = 0; i < 3; ++i) {
        const LeftCell& l = left.age[i + across_reach];
        const RightCell& one = right.age[i + 2 * across_reach - place_of(n, false)];
        const RightCell& other = right.age[i + 2 * across_reach - place_of(n, turns == 2)];
        const RightCell r = second ? other : one;
        rows_alike[i] = alike(l, r);
      }
      columns_alike[n] = count_bits(cat(rows_alike[0], rows_alike[1], rows_alike[2]));
    }
    return columns_alike;
  }

  /// The same of windows of columns, and the best of them.
  void add_columns(const ColumnsAlike& columns_alike) {
    const bool second = turns == 2 && slot_.bit(0);
    std::array<Score, units> score{};
    std::array<NearScore, units> near{};
    if (!second) sum(middle_sum_, !after<1>(), columns_alike[0], score[0], near[0]);
    for (std::size_t n = 1; n < units; ++n)
      sum(sums_[n - 1], !after<1>() && !second, columns_alike[n], score[n], near[n]);
    const auto better = [](const Choice& a, const Choice& b) {
      return Choice{b.score > a.score ? b.score : a.score, b.near > a.near ? b.near : a.near,
                    b.score > a.score ? b.place : a.place};
    };
    Choice first{score[0], near[0], u<3>(across_reach)};
    Choice best = second ? chosen_ : first;
    for (std::size_t n = 1; n < units; n += 2) {
      const auto choice = [&](std::size_t unit) {
        return Choice{score[unit], near[unit], second ? u<3>(place_of(unit, turns == 2)) : u<3>(place_of(unit, false))};
      };
      const Choice two = better(choice(n), choice(n + 1));
      first = better(first, two);
      best = better(best, two);
    }
    for (std::size_t n = 0; n < across_count; ++n) {
      if (turns == 1) {
        scores_[places[n]] = score[n % units];
      } else {
        scores_[places[n]] = n < units ? before_[n % units] : score[(n - units + 1) % units];
      }
    }
    best_ = best;
    chosen_ = first;
    before_ = score;
  }

  template <class Sums>
  void sum(Sums& sums, bool starts, ColumnCount column, Score& score, NearScore& near) {
    score = sums.step(starts, after<window>(), column);
    const u<6> before = after<half_window + 1>() ? sums.column(half_window + 1) : ColumnCount(0);
    near = NearScore((sums.column(half_window - 1) + sums.column(half_window)) + before);
  }

  /// Of the run's shift, a beat late, as a shift lasts longer: the way to choose() is short.
  struct OfShift {
    bool allowed = false, first = false, not_right = false;
  };
  void look_at_shift(const Config& config) {
    shift_.allowed = run_.shift >= config.shift_lowest && run_.shift <= config.shift_highest;
    shift_.first = s<9>(run_.shift) == -s<9>(least_);
    shift_.not_right = run_.shift.negative() || run_.shift == 0;
  }

  /// The best of five scores joins the best of the left cell, and of the right one; the same of the small windows.
  void choose() {
    const bool centred =
        after<half_window>() && ends_cell_ && (run_.shift.negative() ? x_ : partner()) <= last_ + lit<half_window>();
    if (!centred) return;
    const Index x(x_ - lit<half_window>());
    const Choice& best = best_;
    const Scores& all = scores_;
    const Score of_best = shift_.allowed ? best.score : Score(0);
    const NearScore of_near = shift_.allowed ? best.near : NearScore(0);
    const bool all_new = shift_.first;
    const bool not_right = shift_.not_right;

    BestLeft of_left = best_left_.read(x);
    const bool left_new = all_new || (not_right && !after<half_window + 1>());
    if (left_new || of_best > of_left.peak.score) {
      of_left.shift = run_.shift;
      of_left.peak = {best.place, of_best, best.place == 1 ? all[0] : (best.place == 2 ? all[1] : all[2]),
                      best.place == 1 ? all[2] : (best.place == 2 ? all[3] : all[4])};
    }
    if (left_new || of_near > of_left.near_score) {
      of_left.near_score = of_near;
      of_left.near_shift = run_.shift;
    }
    of_left.before = run_.shift == lit<-1>() ? of_best : (left_new ? Score(0) : of_left.before);
    of_left.behind = run_.shift == lit<1>() ? of_best : (left_new ? Score(0) : of_left.behind);
    best_left_.write(x, of_left);

    const Index right(partner() - lit<half_window>());
    const bool right_new = all_new || (not_right && x == last_);
    BestRight of_right = best_right_.read(right);
    if (right_new || of_best > of_right.score) {
      of_right.score = of_best;
      of_right.x = u<7>(x);
    }
    if (right_new || of_near > of_right.near_score) {
      of_right.near_score = of_near;
      of_right.near_x = u<7>(x);
    }
    best_right_.write(right, of_right);
  }

#ifndef __HLSC__
  /// What compare(), add_columns() and choose() come to in all of a row's beats.
  void compare_row(const Config& config) {
    using Compared = decltype(compared_);
    const auto count = static_cast<std::size_t>(last_.value()) + 1;
    for (std::size_t x = 0; x < count; ++x) {
      const LeftColumn& left = left_.read(x);
      for (std::size_t i = 0; i < 3; ++i) {
        const LeftCell& cell_here = left.age[i + across_reach];
        compared_.left.code[i][x] = static_cast<std::uint16_t>(cell_here.code.value());
        compared_.left.there[i][x] = cell_here.valid ? Compared::code_mask : std::uint16_t{0};
      }
      const RightColumn& right = right_codes_.read(x);
      for (std::size_t i = 0; i < right.age.size(); ++i) {
        compared_.right.code[i][x] = static_cast<std::uint16_t>(right.age[i].code.value());
        compared_.right.there[i][x] = right.age[i].valid ? Compared::code_mask : std::uint16_t{0};
      }
    }
    const auto least = static_cast<int>(least_.value());
    compared_.compare(static_cast<int>(count), std::max(-least, static_cast<int>(config.shift_lowest.value())),
                      std::min(least, static_cast<int>(config.shift_highest.value())));
    const auto& l = compared_.best_left;
    const auto& r = compared_.best_right;
    for (std::size_t x = 0; x < count; ++x) {
      best_left_.write(x, BestLeft{l.shift[x],
                                   {l.place[x], l.score[x], l.above[x], l.below[x]},
                                   l.near_score[x],
                                   l.near_shift[x],
                                   l.before[x],
                                   l.behind[x]});
      best_right_.write(x, BestRight{r.score[x], r.x[x], r.near_score[x], r.near_x[x]});
    }
  }
#endif

  // What the row showed -----------------------------------------------------------------------------------------------

  struct RegionSums {
    u<10> textured;
    u<10> explained;
    u<10> nearer;
  };
  static_assert((columns / region_columns + 1) * (rows / region_rows + 1) < 1024);
  using SegmentCount = u<bits_for(columns)>;
  struct Segment {  // of a row of cells, in one region
    SegmentCount textured, explained, nearer;
  };
  using Count = u<14>;
  static_assert(map_cells < (1U << Count::width));
  struct Counts {
    Count supervised, textured, explained, nearer, unproven, regions_bad;
    Count skin_supervised;  // of the skin alone; these count for `hidden`
    Count skin_textured, skin_unproven;
    Count on_skin;
    Count turned_left, turned_right;  // of explained cells and their partners (moments.hpp)
  };
  /// What a beat adds to them; one addition each, whatever the phase.
  struct Change {
    u<1> supervised, textured, explained, nearer, unproven;
    u<10> regions_bad;
    u<1> skin_supervised, skin_textured, skin_unproven, on_skin;
    u<1> turned_left, turned_right;
  };
  /// Of the region's part of this row of cells, with this beat.
  [[nodiscard]] Segment segment() const {
    const Segment before = segment_started_ ? segment_ : Segment{};
    return {SegmentCount(before.textured + change_.textured), SegmentCount(before.explained + change_.explained),
            SegmentCount(before.nearer + change_.nearer)};
  }

  void change_counts(const Config& config) {
    const Change& by = change_;
    segment_ = segment();
    segment_started_ = !segment_starts_;
    registration_.end_beat(new_frame_, row_starts_, first_rows_, in_row_, next_cell_, config);
#ifndef __HLSC__
    if (run_was_ != Phase::conclude && run_was_ != Phase::finish && !new_frame_) return;
#endif
    Counts c = counts_;
    c.supervised += by.supervised;
    c.textured += by.textured;
    c.explained += by.explained;
    c.nearer += by.nearer;
    c.unproven += by.unproven;
    c.regions_bad += by.regions_bad;
    c.skin_supervised += by.skin_supervised;
    c.skin_textured += by.skin_textured;
    c.skin_unproven += by.skin_unproven;
    c.on_skin += by.on_skin;
    c.turned_left += by.turned_left;
    c.turned_right += by.turned_right;
    counts_ = new_frame_ ? Counts{} : c;
  }

  /// Of a cell, for the map.
  struct Seen {
    bool textured = false;
    bool of_skin = false;
    bool explained = false;
    bool shown = false;
    bool nearer = false;
  };
  struct SeenColumn {
    std::array<Seen, box - 1> above{};
  };

  struct Shown {
    bool shown = false;
    bool nearer = false;
  };

  /// What is known of the cell x_ of the left camera, by the small window in its first slots and by the large one in the
  /// others.
  struct Looked {
    bool inside = false;
    bool supervised = false;
    bool textured = false;
    bool of_skin = false;
    bool explained = false;
    bool nearer = false;
    bool on_skin = false;
    BestLeft best;
    Index partner;  // in the right image
    Turn left_turn, right_turn;
  };
  Looked look(const LeftCell& here, const Config& config) {
    Looked l;
    l.inside = inside();
    if (!l.inside) return l;
    const bool large = slot_.bit(2);
    l.best = best_left_.read(x_);
    const Shift shift = large ? l.best.shift : l.best.near_shift;
    const Index found(s<10>(x_) + shift);
    l.partner = select(found > last_, Index(0), found);  // a spoilt shift makes no address beyond the memory
    const BestRight right = best_right_.read(l.partner);
    if (large) {
      l.left_turn = left_turns_.read(x_);
      l.right_turn = right_turns_.read(l.partner);
    }
    const bool enough_rows = row_ >= first_row || late_;
    l.supervised = here.supervised && enough_rows;
    l.textured = l.supervised && here.textured;
    l.of_skin = here.of_skin;
    const bool fits = large ? l.best.peak.score > score_limit : l.best.near_score > near_score_limit;
    l.explained = l.textured && fits && comes_back(large ? right.x : right.near_x);
    l.nearer = l.explained && is_nearer(shift, config);
    l.on_skin = l.explained && l.of_skin && shift == 0 && is_centred(l.best);
    return l;
  }
  /// Of a best shift of 0: by those beside it, the best one lies within 1/8 cell of it (as of Displacement).
  static bool is_centred(const BestLeft& best) {
    const s<9> rise(best.behind - best.before);
    const Score lower(rise.negative() ? best.behind : best.before);
    return shl<2>(u<8>(abs(rise))) <= u<8>(best.peak.score - lower);
  }
  /// The right cell's own choice is this cell, or one beside it.
  [[nodiscard]] bool comes_back(u<7> chosen) const {
    const auto way = s<9>(chosen - u<8>(x_));
    return way >= -1 && way <= 1;
  }
  static bool is_nearer(Shift shift, const Config& config) {
    return (config.nearer_below != 0 && shift.negative()) || (config.nearer_above != 0 && shift > 0);
  }

  /// A cell that is shown leaves word where the right camera sees it: what that one sees there is not on the skin, either.
  void match(const Looked& looked, const Step& left, const Step& right) {
    if (looked.explained) shown_right_.write(looked.partner, Shown{true, looked.nearer});
    if (!looked.inside) return;
    // The first rows compared are the lowest ones of the frame before: of them no step counts.
    const bool of_frame = row_ >= middle;
    const auto turned = moments_.take(row_ == 0 && x_ == 0, looked.explained, Step{left.strong && of_frame, left.rises},
                                      Step{right.strong && of_frame, right.rises});
    left_turns_.write(x_, turned[0]);
    right_turns_.write(x_, turned[1]);
  }

  void conclude(const Looked& looked, const Config& config, bool next_region) {
    const bool right_half = looked.inside && shl<1>(x_) > last_ + lit<4>();
    registration_.step_cell(slot_, looked.inside, right_half, lower_half_,
                            looked.explained && row_ >= first_row + across_reach, looked.best.shift, looked.best.peak,
                            config);
    if (!slot_.bit(2)) shown_ = {looked.explained, looked.nearer};
    if (!ends_cell_) return;
    Seen seen;
    // A code stands two cells right of and below its own.
    const bool in_reach = OfPatches::in_reach(registration_.expected());
    patches_.step_cell(Index(x_ - lit<2>()), last_, looked.explained && in_reach && row_ >= first_row + across_reach,
                       looked.best.shift, registration_.slope_here());
    if (looked.inside) {
      const Shown right = shown_right_.read(x_);
      shown_right_.write(x_, Shown{});
      seen.textured = looked.textured;
      seen.of_skin = looked.of_skin;
      seen.explained = looked.explained;
      seen.shown = shown_.shown || right.shown;
      seen.nearer = shown_.shown ? shown_.nearer : right.nearer;
      count(looked);
    }
    count_region(looked.inside, next_region);
    draw(seen, looked.inside);
  }

  /// What is nearer is counted where there is a skin; around it, nearer than what it is compared with means nothing.
  void count(const Looked& looked) {
    if (late_) return;
    change_.supervised = u<1>(looked.supervised);
    change_.textured = u<1>(looked.textured);
    change_.explained = u<1>(looked.explained);
    change_.nearer = u<1>(looked.nearer && looked.of_skin);
    change_.on_skin = u<1>(looked.on_skin);
    change_.skin_supervised = u<1>(looked.supervised && looked.of_skin);
    const bool both_strong = looked.explained && looked.left_turn.strong && looked.right_turn.strong;
    change_.turned_left = u<1>(both_strong && looked.left_turn.turned);
    change_.turned_right = u<1>(both_strong && looked.right_turn.turned);
  }

  [[nodiscard]] u<3> region_column() const {
    const auto& bits = region_columns_;
    return cat(bits.bit(4) || bits.bit(5) || bits.bit(6) || bits.bit(7),
               bits.bit(2) || bits.bit(3) || bits.bit(6) || bits.bit(7),
               bits.bit(1) || bits.bit(3) || bits.bit(5) || bits.bit(7));
  }

  void count_region(bool inside, bool next) {
    if (!inside) return;
    const Segment sums_here = segment();
    segment_starts_ = next || x_ == last_;
    if (next || x_ == last_) {
      const auto place = cat(region_row_, region_column());
      RegionSums sums = regions_.read(place);
      if (region_fresh_) sums = RegionSums{};
      sums.textured += sums_here.textured;
      sums.explained += sums_here.explained;
      sums.nearer += sums_here.nearer;
      regions_.write(place, sums);
    }
    if (next) region_columns_ = u<region_columns>(cat(region_columns_, false));
  }

  struct Centre {
    bool textured = false;
    bool of_skin = false;
  };

  /// The map of what is seen, of the cells two rows up and two columns left of this one.
  void draw(const Seen& seen, bool inside) {
    SeenColumn column;
    if (inside) {
      column = seen_columns_.read(x_);
      SeenColumn next;
      next.above[0] = seen;
      for (std::size_t i = 1; i < box - 1; ++i) next.above[i] = column.above[i - 1];
      seen_columns_.write(x_, next);
    }
    u<3> textured(u<1>(seen.textured)), explained(u<1>(seen.explained)), shown(u<1>(seen.shown)),
        near(u<1>(seen.nearer));
    for (const Seen& above : column.above) {
      textured += u<1>(above.textured);
      explained += u<1>(above.explained);
      shown += u<1>(above.shown);
      near += u<1>(above.nearer);
    }
    const bool start = x_ == 0;
    const bool filled = after<box>();
    const u<5> t = box_textured_.step(start, filled, textured);
    const u<5> e = box_explained_.step(start, filled, explained);
    const u<5> around = box_shown_.step(start, filled, shown);
    const u<5> n = box_nearer_.step(start, filled, near);
    const Centre centre = centres_.tap(1);
    centres_.push({inside && column.above[1].textured, column.above[1].of_skin});
    const bool few = t < 2;
    const bool region_seen = good_known_ && good_.bit(static_cast<int>(cat(region_row_, region_column()).value()));
    const bool is_proven = few ? region_seen : u<7>(e + shl<1>(e)) >= t;
    const bool is_seen = few ? region_seen : u<7>(around + shl<1>(around)) >= t;
    const bool is_nearer = shl<1>(n) > around;
    const bool counts = late_ || !draws_late_;  // what is in the middle was counted, too
    if (x_ >= 2 && counts && centre.textured) {
      change_.unproven = u<1>(!is_proven);
      change_.skin_textured = u<1>(centre.of_skin);
      change_.skin_unproven = u<1>(centre.of_skin && !is_proven);
    }
    if ((row_ >= lag || draws_late_) && x_ >= 4 && x_ <= last_ + lit<4>()) {
      map_.write(place_in_map(draws_late_ ? read_half_ : write_half_, MapIndex(map_row_ + (x_ - lit<4>()))),
                 MapCell{is_seen, is_seen && is_nearer});
    }
  }

  // The frame ---------------------------------------------------------------------------------------------------------

  // Steps of x_: what is asked of all cells before regions are judged by it, regions, the frame's words.
  static constexpr int finish_begins = 48, regions_begin = 64, words_begin = 112, finish_ends = 127;

  void finish(Out& out, const Config& config) {
    const auto k = u<7>(x_);
    const auto place = k.template bits<5, 0>();
    const bool enough = shl<4>(counts_.textured) >= counts_.supervised && counts_.textured >= least_textured;
    weigh(k, config);
    if (k < regions_begin) {
      good_known_ = false;
    } else if (k < words_begin) {
      if (place < OfImage::moved_steps) registration_.step_moved(place);
      if (place < OfPatches::decide_steps) patches_.step_decide(place);
      RegionSums sums = regions_.read(place);
      if (place.template bits<5, 3>() > region_row_) sums = RegionSums{};
      const bool bad = sums.textured >= 16 && u<13>(sums.explained + shl<2>(sums.explained)) < sums.textured;
      const bool good =
          sums.textured < 8 ? enough && !disagree_ : u<12>(sums.explained + shl<1>(sums.explained)) >= sums.textured;
      good_ = cat(u<1>(good), good_.template bits<regions - 1, 1>());
      if (bad) change_.regions_bad = sums.textured;
      out.frame = {true, place, u<32>(cat(sums.nearer, sums.explained, sums.textured))};
    } else {
      out.frame = {place >= FrameWord::first_of_frame, place, word(place)};
    }
    if (k == words_begin) {
      patches_.end_frame();
      moments_.end_frame(config.prove != 0, config.same_table != 0);
    }
    moments_.look({counts_.turned_left, counts_.turned_right});
    const auto hidden_for = hidden_for_;
    if (k == finish_ends) hidden_for_ = hidden_ends_ ? u<9>(0) : u<9>(hidden_for + hidden_more_);
    look_at_hidden(hidden_for, config);
    if (k != finish_ends) return;
    good_known_ = true;
    say(out.verdict, enough, config);
    said_ = true;
  }

  /// In every beat, for the next one. The count is of half frames: with tables in turn, of which one is of
  /// a skin that is hidden, it grows, too. The map that a frame with another table has is of the one before, so its own
  /// cells say whether most of the skin is hidden.
  void look_at_hidden(u<9> hidden_for, const Config& config) {
    const bool same_table = config.same_table != 0;
    const bool most = hidden_for.template bits<8, 1>() == 255;
    hidden_ends_ = !hides_ && (same_table || hidden_for == 0);
    hidden_more_ = !hides_ ? s<3>(-1) : most ? s<3>(0) : s<3>(2);
    buries_ = proven_ && !same_table && shl<2>(counts_.nearer) > counts_.skin_textured * lit<3>();
  }

  [[nodiscard]] u<32> word(u<6> place) {
    const Counts& c = counts_;
    const auto& sums = sharpness_.sums();
    const auto pair = [](Count low, Count high) { return u<32>(cat(u<16>(high), u<16>(low))); };
    switch (place.value()) {
      case 52:
        return pair(c.textured, c.explained);
      case 53:
        return pair(c.supervised, c.nearer);
      case 54:
        return pair(c.unproven, c.regions_bad);
      case 59:
        return u<32>(sums.detail[0]);
      case 60:
        return u<32>(sums.detail[1]);
      case 61:
        return u<32>(sums.contrast[0]);
      case 62:
        return u<32>(sums.contrast[1]);
      case 63: {
        const auto round = patches_.round();
        return u<32>(cat(round.on_skin, round.moved, round.across, round.places));
      }
      default: {
        const auto of = registration_.quarter(u<2>(place.template bits<1, 0>() + lit<1>()));
        return u<32>(cat(of.high, of.low));
      }
    }
  }

  /// Products of a limit, in 1/256, with a count of cells, a bit of the limit a beat; with the first beat of the next eight
  /// each is compared with the cells that it limits.
  void weigh(u<7> k, const Config& config) {
    const Counts& c = counts_;
    const u<3> bit = k.template bits<2, 0>();
    u<8> limit = config.regions_limit;
    Count of = c.textured;
    Count before = c.regions_bad;
    switch (k.template bits<6, 3>().value()) {
      case 6:
        limit = config.explained_limit;
        break;
      case 7:
        limit = config.unproven_limit;
        break;
      case 8:
        limit = config.unproven_skin_limit;
        of = c.skin_textured;
        before = c.unproven;
        break;
      case 9:
        limit = config.hidden_limit;
        of = c.skin_supervised;
        before = c.skin_unproven;
        break;
      case 10:
        before = c.nearer;
        break;
      case 11:
        limit = u<8>(shl<3>(config.on_skin_limit));
        of = c.skin_textured;
        break;
      case 12:
        before = c.on_skin;
        break;
      default:
        break;
    }
    const auto over = product_ - before;
    const bool begins = bit == 0;
    const auto group = k.template bits<6, 3>();
    const bool too_little = product_ > c.explained || (product_ == c.explained && product_rest_);
    if (begins && group == 7) disagree_ = too_little;
    if (begins && group == 8) too_much_ = false;
    if (begins && over.negative() && (group == 8 || group == 9 || group == 15)) too_much_ = true;
    if (begins && group == 10) hides_ = over.negative();
    if (begins && group == 12) overlooks_ = over.negative() && c.on_skin > shl<2>(config.on_skin_cells);
    const auto sum = (begins ? Count(0) : product_) + (limit.bit(static_cast<int>(bit.value())) ? of : Count(0));
    product_ = Count(shr<1>(sum));
    product_rest_ = (!begins && product_rest_) || sum.bit(0);
  }

  void say(Verdict& verdict, bool enough, const Config& config) const {
    verdict.valid = true;
    const bool waits = config.patch_limit != lit<patch_limit_never>() && !patches_.settled();
    verdict.unproven_yet = config.prove != 0 && (!proven_ || waits);
    verdict.untextured = config.prove != 0 && !enough;
    verdict.disagree = config.prove != 0 && enough && (disagree_ || too_much_);
    verdict.moved = config.prove != 0 && (registration_.moved() || patches_.moved());
    const bool overlooks = overlooks_ && config.on_skin_limit != lit<on_skin_limit_never>();
    verdict.overlooked = config.prove != 0 && (overlooks || patches_.overlooked());
    verdict.out_of_step = config.prove != 0 && moments_.out_of_step();
    // Where the left camera sees nothing and the right one does: of the right one agreement says it already.
    verdict.unsharp_left = config.prove != 0 && enough && (sharpness_.less(0) || census_.left_sees_less());
    verdict.unsharp_right = config.prove != 0 && enough && sharpness_.less(1);
    const bool too_long = config.hidden_frames != 0 && hidden_for_ >= shl<1>(config.hidden_frames);
    verdict.hidden = config.prove != 0 && (too_long || buries_);
  }

  // The map -----------------------------------------------------------------------------------------------------------

  using MapIndex = u<bits_for(map_cells)>;
  struct MapCell {
    bool seen = false;
    bool nearer = false;
  };

  static u<bits_for(2 * map_cells)> place_in_map(bool half, MapIndex index) {
    return u<bits_for(2 * map_cells)>(index + (half ? u<bits_for(map_cells)>(map_cells) : u<bits_for(map_cells)>(0)));
  }

  /// Cells near the lower border have no map of their own: the last row that has counts for them.
  void read_map(bool first, bool last, const Config& config) {
    if (first) {
      if (done_) {
        read_half_ = write_half_;
        write_half_ = !write_half_;
      }
      proven_ = done_;
    }
    // A row of the result begins where `align` begins it: so many rows and columns after the image's.
    const bool row_starts = first || line_ended_;
    line_ended_ = last;
    columns_passed_ = row_starts ? Passed(1) : Passed(cat(columns_passed_, false));
    rows_passed_ = first ? Passed(1) : (row_starts ? Passed(cat(rows_passed_, true)) : rows_passed_);
    bool begins = false;
    if constexpr (P.has_thesis()) {
      begins = columns_passed_.bit(thesis_offset<P>.columns) && rows_passed_.bit(thesis_offset<P>.rows);
    }
    if constexpr (P.has_compete()) {
      const bool so = columns_passed_.bit(compete_offset<P>.columns) && rows_passed_.bit(compete_offset<P>.rows);
      if (!P.has_thesis() || config.compete != 0) begins = so;
    }

    const Index count(shr<bits_for(cell - 1)>(config.height));
    const Index width = cells_of(config.width);
    const bool next_row = begins && began_ && at_cell_end_;
    at_cell_end_ = seen_y_ == cell - 1 && seen_rows_left_ != 0;  // a beat early: rows are long
    seen_base_ = first ? MapIndex(0) : MapIndex(seen_base_ + (next_row ? MapIndex(width) : MapIndex(0)));
    constexpr int below = lag - late_drawn;
    seen_rows_left_ = first ? (count > below + 1 ? Index(count - lit<below + 1>()) : Index(0))
                            : Index(seen_rows_left_ - u<1>(was_next_row_));
    was_next_row_ = next_row;
    if (first) {
      seen_y_ = 0;
    } else if (begins && began_) {
      seen_y_ = u<bits_for(cell - 1)>(seen_y_ + lit<1>());
    }
    began_ = !first && (began_ || begins);
    seen_column_ = begins ? Index(0) : Index(seen_column_ + u<1>(seen_x_ == cell - 1));
    seen_x_ = begins ? u<bits_for(cell - 1)>(0) : u<bits_for(cell - 1)>(seen_x_ + lit<1>());
    read_map_cell(width, count);
  }

  void read_map_cell(Index width, Index count) {
    if (began_ && seen_x_ == 0 && seen_column_ < width) {
      const MapCell here = map_.read(place_in_map(read_half_, MapIndex(seen_base_ + seen_column_)));
      const bool known = proven_ && count > first_row;
      seen_ = known && here.seen;
      nearer_ = known && here.nearer;
    }
  }

  void begin_step() {
    averager_.begin_step();
    census_.begin_step();
    moments_.begin_step();
    left_turns_.begin_step();
    right_turns_.begin_step();
    fresh_.begin_step();
    left_.begin_step();
    right_codes_.begin_step();
    best_left_.begin_step();
    best_right_.begin_step();
    shown_right_.begin_step();
    seen_columns_.begin_step();
    regions_.begin_step();
    registration_.begin_step();
    patches_.begin_step();
    map_.begin_step();
  }

  // Pixels and cells.
  Kept<u<8>> left_pixel_;
  bool left_first_ = false;
  bool right_ = false;
  Sample sample_;
  Raster raster_;
  CellAverager<cell, P.result_width()> averager_;
  CellCensus<columns> census_;
  OfMoments moments_;
  Sharpness sharpness_;
  u<5> rows_passed_above_{0};  // bit n: n rows of cells have passed
  // The sweep.
  Run run_, following_;
  struct Plan {
    Shift shift;
    Index span, columns;
  };
  Plan plan_;  // the next run, where that compares
  Index x_{0}, columns_left_{0}, last_{0}, row_{0};
  Index least_{0};             // of the first shift, turned round
  Index whole_{0}, drawn_{0};  // columns of a run over all
  Age age_{1};
  u<3> slot_{0};           // beat of the column
  bool ends_cell_ = true;  // the last one
  bool ends_ = false;      // the last column
  // Of this beat: it belongs to a row that concludes, the next one to the next cell; with it a row starts, of the first.
  bool in_row_ = false, next_cell_ = false, row_starts_ = false, first_rows_ = false;
  bool final_row_ = false;
  bool lower_half_ = false;
  bool late_ = false, draws_late_ = false;  // the row belongs to the frame before
  template <int STRIDE>
  using ColumnSum = HorizontalSum<window, Score::width, STRIDE, Scalar, ColumnCount::width>;
  ColumnSum<1> middle_sum_;
  std::array<ColumnSum<turns>, units - 1> sums_{};
  Choice chosen_;                      // in the first turn
  std::array<Score, units> before_{};  // of that
  Choice best_;                        // of this beat
  OfShift shift_;
  Scores scores_{};
  RAM<CellCodes, column_count, gap> fresh_;
  RAM<LeftColumn, column_count, gap> left_;
  RAM<RightColumn, column_count, gap> right_codes_;
  RAM<BestLeft, column_count, gap> best_left_;
  RAM<BestRight, column_count, gap> best_right_;
  RAM<Shown, column_count, gap> shown_right_;
  RAM<Turn, column_count, gap> left_turns_, right_turns_;
  // The row and the frame.
  Counts counts_;
  OfImage registration_;
  OfPatches patches_;
  Shown shown_;    // the cell, by the small window
  Change change_;  // of this beat
#ifndef __HLSC__
  ComparedRow<column_count, half_window, 3, across_count> compared_{};
  Phase run_was_ = Phase::idle;                        // of this beat: the others change nothing
  int quiet_beats_ = std::numeric_limits<int>::max();  // that are still to come, in which the sweep does nothing
#endif
  bool new_frame_ = false;                                         // begins with this beat
  u<3> region_row_{0}, next_region_row_{0}, early_region_row_{0};  // of a beat before: the way to the register is short
  u<region_columns> region_columns_{1};                            // bit n: in region column n
  Division<region_columns> region_across_, columns_begin_;
  Division<region_rows> region_down_;
  bool region_fresh_ = true;
  Segment segment_;
  bool segment_starts_ = true, segment_started_ = false;
  RAM<RegionSums, 64, gap> regions_;
  u<regions> good_{0};
  bool good_known_ = false;
  u<9> hidden_for_{0};  // half frames
  s<3> hidden_more_{0};
  bool hidden_ends_ = false;
  Count product_{0};
  bool product_rest_ = false;
  bool disagree_ = false, too_much_ = false, hides_ = false, buries_ = false, overlooks_ = false;
  RAM<SeenColumn, column_count, gap> seen_columns_;
  HorizontalSum<box, 5, 1, Scalar, 3> box_textured_, box_explained_, box_shown_, box_nearer_;
  DelayLine<Centre, 2> centres_;
  // The map.
  RAM<MapCell, 2 * map_cells, min_row_beats> map_;
  MapIndex map_row_{0};
  Index map_width_{0};
  bool write_half_ = false, read_half_ = true;
  bool done_ = false, proven_ = false, drew_ = false, said_ = false;
  static constexpr int largest_offset =
      std::max({thesis_offset<P>.rows, thesis_offset<P>.columns, compete_offset<P>.rows});
  using Passed = u<largest_offset + 1>;  // bit n: n rows have passed, or columns
  Passed rows_passed_{0}, columns_passed_{0};
  bool line_ended_ = true, began_ = false;
  u<bits_for(cell - 1)> seen_x_{0}, seen_y_{0};
  Index seen_column_{0}, seen_rows_left_{0};
  bool at_cell_end_ = false, was_next_row_ = false;
  MapIndex seen_base_{0};
  bool seen_ = false, nearer_ = false;
};

}  // namespace horopter::stages
