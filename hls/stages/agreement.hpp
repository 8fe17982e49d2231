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
// with the skin (Config). One comparison of five sums a beat; a row is done before the next one is complete.
//
// Of a frame it says (Verdict, once, in the rows behind the frame): how much is textured, explained, nearer than the skin;
// whether too little is explained in all (disagree), in too many regions of 8×6, or around too many cells, of all or of
// the skin alone (also disagree); whether the right image is displaced across the rows against what the cameras' geometry
// says (moved: in the median of the image, or of a half, so that a camera that is displaced, rolled or enlarged is found);
// whether one camera is less sharp, or has less contrast (unsharp); whether too much is hidden behind what is nearer
// (hidden, after hidden_frames frames in a row).
// Of a pixel of the result it says in the marks what the frame before showed of its cell: `seen`, in 5×5 cells around there
// are a third as many *shown* ones as textured ones (where there is no texture, explained ones of its region); `nearer`,
// most of these are nearer. A cell is shown where the left camera's cell is explained by windows of 3×3 cells, or the right
// camera's that is compared with it at shift 0: what one camera sees there, the other sees elsewhere. So nothing is on the
// skin. Near the image's edges and beside near things only one of the two may be. Faults take the windows of 7×3 alone.
//
// In, Out  pixels pass. Marks: seen and nearer belong to the pixel of the result that leaves `align` with this beat.
// Config   prove = 0: everything counts as seen, and nothing is said. Illegal use: another size without a reset between.
// Memory: see census.hpp; ring_left, ring_right: codes of 5 and 7 rows; best of a row; the map of the image, twice.
#pragma once

#include <algorithm>

#include "stages/align.hpp"
#include "stages/census.hpp"
#include "stages/division.hpp"
#include "stages/registration.hpp"
#include "stages/subsample.hpp"

namespace horopter::stages {

/// What a frame showed; once a frame.
struct Verdict {
  bool valid = false;
  u<16> supervised;           // cells that exist in both images
  u<16> textured;             // of these
  u<16> explained;            // of these
  u<16> nearer;               // of these, where there is a skin
  u<16> unproven;             // textured, and not seen
  u<16> regions_bad;          // textured cells in regions where hardly any is explained
  bool unproven_yet = false;  // no frame before this one
  bool untextured = false;    // too little to tell
  bool disagree = false;
  bool moved = false;
  bool unsharp_left = false;
  bool unsharp_right = false;
  bool hidden = false;
  std::array<s<20>, 4>
      across{};  // sum of what the right image is displaced across the rows, in 1/32 cell, by quarters of
                 // the image: top left, top right, bottom left, bottom right
  std::array<u<12>, 4> measured{};  // cells it is the sum of
  std::array<u<24>, 2> detail{};    // Sharpness
  std::array<u<24>, 2> contrast{};
};

/// Counts of a region, 8 in a row; the 48 of a frame come before its verdict.
struct RegionCounts {
  bool valid = false;
  u<6> region;
  u<12> textured;
  u<12> explained;
  u<12> nearer;
};

template <Profile P>
class Agreement {
 public:
  static constexpr int cell = P.cell();  // px
  static constexpr int columns = P.result_width() / cell;
  static constexpr int rows = P.height / cell;
  static constexpr int reach = 29;  // cells; what there is time for in vga
  static constexpr int region_columns = 8;
  static constexpr int region_rows = 6;
  static constexpr int regions = region_columns * region_rows;

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
    u<8> hidden_frames;        // for so many frames in a row, 1 to 128; 0 = never
    // 1/32 cell: a median of the displacement across the rows that is too large, of the image or, in opposite
    // directions (one that is rolled or enlarged), of two halves of it.
    u<6> moved_limit;
    u<6> moved_half_limit;  // the same of one half
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
    RegionCounts region;
  };

  Out step(const In& in, const Config& config) {
    begin_step();
    change_ = Change{};
    new_frame_ = false;
    const Pair pair = take(in);
    Out out;
    out.pixel = in.pixel;
    out.saturated = in.saturated;
    out.mask = in.mask;
    out.marks.first = in.marks.first;
    out.marks.last = in.marks.last;
    multiply();
    region_down_.look();
    const bool next_region = region_across_.at_end();
    if (run_.phase == Phase::conclude) {
      region_across_.step();
    } else {
      region_across_.restart(columns_begin_);
      region_columns_ = 1;
      segment_starts_ = true;
    }
    registration_.begin_beat(run_.phase == Phase::conclude, config);
    early_ = next_;
    next_.hidden_for = u<8>(hidden_for_ + u<1>(!hidden_for_.bit(7)));
    next_.region_row = u<3>(region_row_ + lit<1>());
    next_.lowest = Index(run_.lowest - lit<1>());
    next_.highest = Index(run_.highest - lit<1>());
    next_.beats = Index(run_.beats + (run_.shift.negative() ? s<2>(1) : s<2>(-1)));
    next_.shift = Shift(run_.shift + lit<1>());
    next_.last_shift = s<9>(run_.shift) == s<9>(least_ - lit<1>());
    const bool said = said_;
    said_ = false;
    const bool drew = run_.phase == Phase::conclude;
    const Run following = following_;
    following_ = next_run();
#ifndef __HLSC__
    run_was_ = run_.phase;
#endif
    Looked looked;
    switch (run_.phase) {
      case Phase::merge:
        merge();
        break;
      case Phase::compare:
        compare(config);
        break;
      case Phase::match:
      case Phase::conclude:
        looked = look(config);
        break;
      case Phase::idle:
      case Phase::wait:
      case Phase::finish:
        break;
    }
    switch (run_.phase) {
      case Phase::match:
        match(looked);
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
        break;
    }
    advance(following);
    typename Raster::Position at;
    CellGrey means;
    if (sample_.pair.whole) {
      at = raster_.step(sample_.pair.first, sample_.last, config.height);
      means = averager_.step(at, sample_.pair.pixel, sample_.present, sample_.of_skin);
    }
    if (means.valid) take_cell(at, means, config);
    sample_ = {pair, in.marks.last, in.present, in.mask};
    if (pair.whole) read_map(pair.first, in.marks.last, config);
    // Rows beyond the height that was said: what they write to the map is not read.
    done_ = !(pair.whole && pair.first) && !drew_ && (done_ || said);
    drew_ = drew;
    change_counts();
    out.marks.seen = config.prove == 0 || seen_;
    out.marks.nearer = config.prove != 0 && nearer_;
    return out;
  }

 private:
  static constexpr int half_window = 3;                       // columns
  static constexpr int window = 2 * half_window + 1;          // columns
  static constexpr int gap = P.clock_khz > 50'000 ? 32 : 12;  // beats from a memory word's use to the next
  static constexpr int across_reach = 2;                      // rows
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
  static constexpr int least_textured = 40;
  static constexpr std::size_t column_count = static_cast<std::size_t>(columns);
  static constexpr std::size_t map_cells = static_cast<std::size_t>(columns * rows);

  using Index = u<8>;  // of a column or row of cells, and beyond
  using Age = u<std::max(window, box) + 1>;
  static_assert(columns + half_window + gap < 256 && rows < 128);
  using Shift = Registration::Shift;
  using Score = u<8>;
  using NearScore = u<7>;
  static_assert(best_score < 256 && best_near_score < 128);

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

  // Cells -------------------------------------------------------------------------------------------------------------

  static constexpr Index cells_of(u<bits_for(P.result_width())> pixels) {
    return Index(shr<bits_for(cell - 1)>(pixels));
  }

  template <class Position>
  void take_cell(const Position& at, const CellGrey& means, const Config& config) {
    const Index last(cells_of(config.width) - lit<1>());
    if (at.column == 0) rows_passed_above_ = at.row == 0 ? u<5>(1) : u<5>(cat(rows_passed_above_, true));
    const CellCodes codes = census_.step(at.column, at.row == 0 && at.column == 0, rows_passed_above_.bit(4), means);
    sharpness_.step(at.row == 0 && at.column == 0, at.column < 2, means);
    fresh_.write(at.column, codes);
    if (at.column == last) start_row(Index(at.row), last, config);
  }

  /// A row of cells is complete: its codes join those above, and the row `middle` above is compared.
  void start_row(Index row, Index last, const Config& config) {
    const Index count(shr<bits_for(cell - 1)>(config.height));
    begin({Phase::wait, Index(0), Index(0), Index(gap), Shift(0), false});  // until the last codes can be read
    const bool wide = last >= reach;
    least_ = wide ? Index(reach) : last;
    first_beats_ = wide ? Index((last - lit<reach>()) + lit<tail>()) : Index(tail);
    whole_beats_ = Index(last + lit<tail>());
    map_row_ = row <= lag ? MapIndex(0) : MapIndex(map_row_ + map_width_);
    map_width_ = cells_of(config.width);
    registration_.start_row(row <= middle, config);
    columns_begin_.begin(map_width_, u<2>(2));
    last_ = last;
    row_ = row;
    final_row_ = row + lit<1>() == count;
    lower_half_ = shl<1>(row) >= count + lit<2 * (lag - 2)>();
    if (row == 0) {
      new_frame_ = true;
      region_row_ = 0;
      region_down_.begin(count, u<2>(0));
      region_fresh_ = true;
    } else if (row > lag - 2) {  // the region of the row that is compared
      const bool next = region_down_.at_end();
      region_fresh_ = next;
      if (next) region_row_ = early_.region_row;
      region_down_.take();
    }
  }

  // The sweep ---------------------------------------------------------------------------------------------------------

  enum class Phase : std::uint8_t { idle, wait, merge, compare, match, conclude, finish };

  /// A pass over columns of cells: x_ goes from `lowest` to `highest` and then on, until the memories are ready again.
  struct Run {
    Phase phase = Phase::idle;
    Index lowest, highest;
    Index beats;  // after the first
    Shift shift;
    bool last_shift = false;
  };
  static constexpr int tail = half_window + gap;  // beats behind `highest`

  void begin(const Run& run) {
    run_ = run;
    x_ = run.lowest;
    beats_left_ = run.beats;
    age_ = Age(1);
    ends_ = false;
  }
  void advance(const Run& following) {
    if (ends_) {
      begin(following);
    } else {
      x_ += lit<1>();
      ends_ = beats_left_ == 1;
      beats_left_ -= lit<1>();
      age_ = Age(cat(age_, true));
    }
  }
  /// At least so many beats of the run lie before this one.
  template <int BEATS>
  [[nodiscard]] bool after() const {
    static_assert(BEATS < Age::width);
    return age_.bit(BEATS);
  }

  /// What comes after a run. Taken when it ends, from a register: all of its beats are time to find out.
  [[nodiscard]] Run next_run() const {
    Run next;
    switch (run_.phase) {
      case Phase::wait:
        return {Phase::merge, Index(0), last_, whole_beats_, Shift(0), false};
      case Phase::merge:
        return {Phase::compare, least_, last_, first_beats_, Shift(-s<9>(least_)), least_ == 0};
      case Phase::compare: {
        if (run_.last_shift) return {Phase::match, Index(0), last_, whole_beats_, Shift(0), false};
        const bool below = run_.shift.negative();
        next.phase = Phase::compare;
        next.lowest = below ? early_.lowest : Index(0);
        next.highest = below ? last_ : early_.highest;
        next.beats = early_.beats;
        next.shift = early_.shift;
        next.last_shift = early_.last_shift;
        return next;
      }
      case Phase::match:
        return {Phase::conclude, Index(0), last_, whole_beats_, Shift(0), false};
      case Phase::conclude:
        next.phase = final_row_ ? Phase::finish : Phase::idle;
        next.beats = Index(finish_steps - 1);
        return next;
      case Phase::finish:
      case Phase::idle:
        return next;
    }
    return next;
  }

  struct LeftCell {
    u<census_bits> code;
    bool valid = false;
    bool supervised = false;
    bool textured = false;
    bool of_skin = false;
  };
  struct RightCell {
    u<census_bits> code;
    bool valid = false;
  };
  struct LeftColumn {
    std::array<LeftCell, middle + 2> age{};  // the newest row first
  };
  struct RightColumn {
    std::array<RightCell, 2 * middle + 1> age{};
  };

  void merge() {
    if (x_ <= run_.highest) {
      const CellCodes codes = fresh_.read(x_);
      LeftColumn left = left_.read(x_);
      RightColumn right = right_codes_.read(x_);
      for (std::size_t a = left.age.size() - 1; a > 0; --a) left.age[a] = row_ < a ? LeftCell{} : left.age[a - 1];
      for (std::size_t a = right.age.size() - 1; a > 0; --a) right.age[a] = row_ < a ? RightCell{} : right.age[a - 1];
      left.age[0] = {codes.left, codes.left_valid, codes.supervised, codes.textured, codes.of_skin};
      right.age[0] = {codes.right, codes.right_valid};
      left_.write(x_, left);
      right_codes_.write(x_, right);
    }
  }

  static u<4> alike(u<census_bits> a, bool a_valid, u<census_bits> b, bool b_valid) {
    return a_valid && b_valid ? u<4>(popcount(u<census_bits>(~(a ^ b)))) : u<4>(0);
  }

  struct BestLeft {
    Score score;
    Shift shift;
    s<8> across;  // 1/32 cell
    NearScore near_score;
    Shift near_shift;
  };
  struct BestRight {
    Score score;
    u<7> x;
  };
  struct NearRight {
    NearScore score;
    u<7> x;
  };
  using Scores = std::array<Score, across_count>;
  using NearScores = std::array<NearScore, across_count>;

  void compare(const Config& config) {
    // Bits that agree, of a column of three cells and then of the window, for each displacement across the rows.
    const bool inside = x_ <= run_.highest;
    LeftColumn left;
    RightColumn right;
    if (inside) {
      left = left_.read(x_);
      right = right_codes_.read(Index(s<10>(x_) + run_.shift));
    }
    Scores score{};
    NearScores near{};
    for (std::size_t n = 0; n < across_count; ++n) {
      u<6> column(0);
      for (std::size_t i = 0; i < 3; ++i) {
        const LeftCell& l = left.age[i + across_reach];
        const RightCell& r = right.age[i + 2 * across_reach - n];
        column = u<6>(column + alike(l.code, l.valid, r.code, r.valid));
      }
      score[n] = sums_[n].step(x_ == run_.lowest, after<window>(), Score(column));
      const NearScore before(after<half_window + 1>() ? sums_[n].column(half_window + 1) : Score(0));
      near[n] = NearScore((sums_[n].column(half_window - 1) + sums_[n].column(half_window)) + before);
    }
    const bool centred = after<half_window>() && x_ <= run_.highest + lit<half_window>();
    if (centred) {
      const Index x(x_ - lit<half_window>());
      choose(x, score, near, run_.shift >= config.shift_lowest && run_.shift <= config.shift_highest);
    }
  }

  template <class Of>
  static std::size_t best_of(const std::array<Of, across_count>& score) {
    std::size_t best = across_reach;
    for (const std::size_t n : {1U, 3U, 0U, 4U}) {
      if (score[n] > score[best]) best = n;
    }
    return best;
  }

  /// The best of five scores joins the best of the left cell, and of the right one; the same of the small windows.
  void choose(Index x, const Scores& score, const NearScores& near, bool allowed) {
    const std::size_t best = best_of(score);
    const Score of_best = allowed ? score[best] : Score(0);
    const NearScore of_near = allowed ? near[best_of(near)] : NearScore(0);
    const bool all_new = s<9>(run_.shift) == -s<9>(least_);
    const bool not_right = run_.shift.negative() || run_.shift == 0;

    BestLeft of_left = best_left_.read(x);
    const bool left_new = all_new || (not_right && x == run_.lowest);
    if (left_new || of_best > of_left.score) {
      of_left.score = of_best;
      of_left.shift = run_.shift;
      of_left.across = displacement_across(score, best);
    }
    if (left_new || of_near > of_left.near_score) {
      of_left.near_score = of_near;
      of_left.near_shift = run_.shift;
    }
    best_left_.write(x, of_left);

    const Index partner(s<10>(x) + run_.shift);
    const bool right_new = all_new || (not_right && x == run_.highest);
    BestRight of_right = best_right_.read(partner);
    if (right_new || of_best > of_right.score) of_right = {of_best, u<7>(x)};
    best_right_.write(partner, of_right);
    NearRight near_right = near_right_.read(partner);
    if (right_new || of_near > near_right.score) near_right = {of_near, u<7>(x)};
    near_right_.write(partner, near_right);
  }

  // What the row showed -----------------------------------------------------------------------------------------------

  struct RegionSums {
    u<12> textured;
    u<12> explained;
    u<12> nearer;
  };
  using SegmentCount = u<bits_for(columns)>;
  struct Segment {  // of a row of cells, in one region
    SegmentCount textured, explained, nearer;
  };
  struct Counts {
    u<14> supervised, textured, explained, nearer, unproven, regions_bad;
    s<24> too_little_explained, too_many_bad, too_much_unproven, too_much_unseen_skin,
        too_much_hidden;  // above 0: so it is
  };
  /// What a beat adds to them; one addition each, whatever the phase.
  struct Change {
    u<1> supervised, textured, explained, nearer, unproven;
    u<12> regions_bad;
    s<10> too_little_explained;
    s<21> too_many_bad;
    s<11> too_much_unproven;
    s<11> too_much_unseen_skin;
    s<11> too_much_hidden;
  };
  /// Of the region's part of this row of cells, with this beat.
  [[nodiscard]] Segment segment() const {
    const Segment before = segment_started_ ? segment_ : Segment{};
    return {SegmentCount(before.textured + change_.textured), SegmentCount(before.explained + change_.explained),
            SegmentCount(before.nearer + change_.nearer)};
  }

  void change_counts() {
    const Change& by = change_;
    segment_ = segment();
    segment_started_ = !segment_starts_;
#ifndef __HLSC__
    if (run_was_ != Phase::conclude && run_was_ != Phase::finish && !new_frame_) return registration_.end_beat(false);
#endif
    Counts c = counts_;
    c.supervised += by.supervised;
    c.textured += by.textured;
    c.explained += by.explained;
    c.nearer += by.nearer;
    c.unproven += by.unproven;
    c.regions_bad += by.regions_bad;
    c.too_little_explained += by.too_little_explained;
    c.too_many_bad += by.too_many_bad;
    c.too_much_unproven += by.too_much_unproven;
    c.too_much_unseen_skin += by.too_much_unseen_skin;
    c.too_much_hidden += by.too_much_hidden;
    counts_ = new_frame_ ? Counts{} : c;
    registration_.end_beat(new_frame_);
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

  /// What is known of the cell x_ of the left camera.
  struct Looked {
    bool inside = false;
    bool supervised = false;
    bool textured = false;
    bool of_skin = false;
    bool explained = false;
    bool nearer = false;
    BestLeft best;
    Index partner;       // in the right image, by the small window
    bool shown = false;  // by it
    bool shown_nearer = false;
  };
  Looked look(const Config& config) {
    Looked l;
    l.inside = x_ <= run_.highest;
    if (!l.inside) return l;
    const LeftCell here = left_.read(x_).age[middle];
    l.best = best_left_.read(x_);
    l.partner = Index(s<10>(x_) + l.best.near_shift);
    const bool back = comes_back(best_right_.read(Index(s<10>(x_) + l.best.shift)).x);
    const bool near_back = comes_back(near_right_.read(l.partner).x);
    const bool enough_rows = row_ >= first_row;
    l.supervised = here.supervised && enough_rows;
    l.textured = l.supervised && here.textured;
    l.of_skin = here.of_skin;
    l.explained = l.textured && l.best.score > score_limit && back;
    l.nearer = l.explained && is_nearer(l.best.shift, config);
    l.shown = l.textured && l.best.near_score > near_score_limit && near_back;
    l.shown_nearer = l.shown && is_nearer(l.best.near_shift, config);
    return l;
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
  void match(const Looked& looked) {
    if (looked.shown) shown_right_.write(looked.partner, Shown{true, looked.shown_nearer});
  }

  void conclude(const Looked& looked, const Config& config, bool next_region) {
    Seen seen;
    if (looked.inside) {
      const Shown right = shown_right_.read(x_);
      shown_right_.write(x_, Shown{});
      seen.textured = looked.textured;
      seen.of_skin = looked.of_skin;
      seen.explained = looked.explained;
      seen.shown = looked.shown || right.shown;
      seen.nearer = looked.shown ? looked.shown_nearer : right.nearer;
      count(looked, config);
      if (looked.explained && row_ >= first_row + across_reach) {
        registration_.measure(looked.best.shift, looked.best.across, shl<1>(x_) > last_ + lit<4>(), lower_half_,
                              config);
      }
    }
    count_region(looked.inside, next_region);
    draw(seen, looked.inside, config);
  }

  /// What is nearer is counted where there is a skin; around it, nearer than what it is compared with means nothing.
  void count(const Looked& cell, const Config& config) {
    change_.supervised = u<1>(cell.supervised);
    change_.textured = u<1>(cell.textured);
    change_.explained = u<1>(cell.explained);
    change_.nearer = u<1>(cell.nearer && cell.of_skin);
    if (cell.textured) {
      change_.too_little_explained = s<10>(s<9>(config.explained_limit) - s<10>(cell.explained ? 256 : 0));
      change_.too_many_bad = s<21>(-s<9>(config.regions_limit));
      change_.too_much_unproven = s<11>(-s<9>(config.unproven_limit));
    }
    if (cell.supervised && cell.of_skin)
      change_.too_much_hidden = s<11>(s<10>(cell.nearer ? 256 : 0) - s<9>(config.hidden_limit));
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
  void draw(const Seen& seen, bool inside, const Config& config) {
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
    const u<5> t = box_textured_.step(start, filled, u<5>(textured));
    const u<5> e = box_explained_.step(start, filled, u<5>(explained));
    const u<5> around = box_shown_.step(start, filled, u<5>(shown));
    const u<5> n = box_nearer_.step(start, filled, u<5>(near));
    const Centre centre = centres_.tap(1);
    centres_.push({inside && column.above[1].textured, column.above[1].of_skin});
    const bool few = t < 2;
    const bool region_seen = good_.bit(static_cast<int>(cat(region_row_, region_column()).value()));
    const bool is_proven = few ? region_seen : u<7>(e + shl<1>(e)) >= t;
    const bool is_seen = few ? region_seen : u<7>(around + shl<1>(around)) >= t;
    const bool is_nearer = shl<1>(n) > around;
    if (x_ >= 2 && centre.textured) {
      if (!is_proven) {
        change_.unproven = 1;
        change_.too_much_unproven = s<11>(change_.too_much_unproven + lit<256>());
      }
      if (centre.of_skin)
        change_.too_much_unseen_skin = s<11>(s<10>(is_proven ? 0 : 256) - s<9>(config.unproven_skin_limit));
    }
    if (row_ >= lag && x_ >= 4 && x_ <= run_.highest + lit<4>()) {
      map_.write(place_in_map(write_half_, MapIndex(map_row_ + (x_ - lit<4>()))),
                 MapCell{is_seen, is_seen && is_nearer});
    }
  }

  // The frame ---------------------------------------------------------------------------------------------------------

  static constexpr int finish_steps = 64;
  static constexpr int factor_bits = 18;
  using Factor = u<factor_bits>;  // of the products: a sum without its lowest bits
  using Product = u<2 * factor_bits>;
  static Factor factor(u<24> sum) { return shr<24 - factor_bits>(sum); }

  void finish(Out& out, const Config& config) {
    const u<6> k(x_);
    const bool enough = shl<4>(counts_.textured) >= counts_.supervised && counts_.textured >= least_textured;
    const bool disagree = counts_.too_little_explained > 0;
    if (k < regions) {
      RegionSums sums = regions_.read(k);
      if (k.template bits<5, 3>() > region_row_) sums = RegionSums{};
      const bool bad = sums.textured >= 16 && u<15>(sums.explained + shl<2>(sums.explained)) < sums.textured;
      const bool good =
          sums.textured < 8 ? enough && !disagree : u<14>(sums.explained + shl<1>(sums.explained)) >= sums.textured;
      good_next_ = cat(u<1>(good), good_next_.template bits<regions - 1, 1>());
      if (bad) {
        change_.regions_bad = sums.textured;
        change_.too_many_bad = s<21>(shl<8>(sums.textured));
      }
      out.region = {true, k, sums.textured, sums.explained, sums.nearer};
    }
    if (k != finish_steps - 1) return;
    const bool hides = counts_.too_much_hidden > 0;
    hidden_for_ = hides ? early_.hidden_for : u<8>(0);
    good_ = good_next_;
    say(out.verdict, enough, disagree, config);
    said_ = true;
  }

  /// The products of each camera's detail with the other's contrast, a bit a beat, begun with the frame's last run.
  void multiply() {
    for (std::size_t i = 0; i < 2; ++i) {
      if (begins_product_) {
        product_[i] = Product(0);
        addend_[i] = Product(shl<factor_bits - 1>(factor(sharpness_.sums().detail[i])));
        multiplier_[i] = factor(sharpness_.sums().contrast[1 - i]);
      } else {
        if (multiplier_[i].bit(factor_bits - 1)) product_[i] += addend_[i];
        addend_[i] = Product(shr<1>(addend_[i]));
        multiplier_[i] = Factor(shl<1>(multiplier_[i]));
      }
    }
    begins_product_ = run_.phase == Phase::conclude;
  }

  void say(Verdict& verdict, bool enough, bool disagree, const Config& config) const {
    const Counts& c = counts_;
    const auto& sums = sharpness_.sums();
    const auto& of_left = sums.contrast[0];
    const auto& of_right = sums.contrast[1];
    verdict.valid = true;
    verdict.supervised = u<16>(c.supervised);
    verdict.textured = u<16>(c.textured);
    verdict.explained = u<16>(c.explained);
    verdict.nearer = u<16>(c.nearer);
    verdict.unproven = u<16>(c.unproven);
    verdict.regions_bad = u<16>(c.regions_bad);
    verdict.unproven_yet = config.prove != 0 && !proven_;
    verdict.untextured = config.prove != 0 && !enough;
    verdict.disagree = config.prove != 0 && enough &&
                       (disagree || c.too_many_bad > 0 || c.too_much_unproven > 0 || c.too_much_unseen_skin > 0);
    verdict.moved = config.prove != 0 && registration_.moved();
    // A camera's detail in proportion to its contrast is below 5/8 of the other's, or its contrast below a quarter. Or
    // the left one sees nothing where the right one does: of the right one agreement says it already.
    const auto detail_left = product_[0];
    const auto detail_right = product_[1];
    verdict.unsharp_left = config.prove != 0 && enough &&
                           (shl<3>(detail_left) < detail_right + shl<2>(detail_right) || shl<2>(of_left) < of_right ||
                            census_.left_sees_less());
    verdict.unsharp_right = config.prove != 0 && enough &&
                            (shl<3>(detail_right) < detail_left + shl<2>(detail_left) || shl<2>(of_right) < of_left);
    verdict.hidden = config.prove != 0 && config.hidden_frames != 0 && hidden_for_ >= config.hidden_frames;
    verdict.across = registration_.across();
    verdict.measured = registration_.measured();
    verdict.detail = sums.detail;
    verdict.contrast = sums.contrast;
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
    seen_rows_left_ = first ? (count > lag + 1 ? Index(count - lit<lag + 1>()) : Index(0))
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
    fresh_.begin_step();
    left_.begin_step();
    right_codes_.begin_step();
    best_left_.begin_step();
    best_right_.begin_step();
    near_right_.begin_step();
    shown_right_.begin_step();
    seen_columns_.begin_step();
    regions_.begin_step();
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
  Sharpness sharpness_;
  u<5> rows_passed_above_{0};  // bit n: n rows of cells have passed
  // The sweep.
  Run run_, following_;
  Index x_{0}, beats_left_{0}, last_{0}, row_{0};
  Index least_{0}, first_beats_{0}, whole_beats_{0};  // of the first shift; of all columns
  Age age_{1};
  bool ends_ = false;
  bool final_row_ = false;
  bool lower_half_ = false;
  std::array<HorizontalSum<window, 8>, across_count> sums_{};
  RAM<CellCodes, column_count, gap> fresh_;
  RAM<LeftColumn, column_count, gap> left_;
  RAM<RightColumn, column_count, gap> right_codes_;
  RAM<BestLeft, column_count, gap> best_left_;
  RAM<BestRight, column_count, gap> best_right_;
  RAM<NearRight, column_count, gap> near_right_;
  RAM<Shown, column_count, gap> shown_right_;
  // The row and the frame.
  Counts counts_;
  Registration registration_;
  Change change_;  // of this beat
#ifndef __HLSC__
  Phase run_was_ = Phase::idle;  // of this beat: the others change nothing
#endif
  bool new_frame_ = false;  // begins with this beat
  u<3> region_row_{0};
  u<region_columns> region_columns_{1};  // bit n: in region column n
  Division<region_columns> region_across_, columns_begin_;
  Division<region_rows> region_down_;
  bool region_fresh_ = true;
  Segment segment_;
  bool segment_starts_ = true, segment_started_ = false;
  RAM<RegionSums, 64, gap> regions_;
  u<regions> good_{0}, good_next_{0};
  u<8> hidden_for_{0};
  /// What counters will be when they count, of a beat before: the way from register to register is short.
  struct Early {
    u<8> hidden_for;
    u<3> region_row;
    Index lowest, highest, beats;
    Shift shift;
    bool last_shift = false;
  };
  Early next_, early_;
  bool begins_product_ = false;
  std::array<Product, 2> product_{}, addend_{};
  std::array<Factor, 2> multiplier_{};
  RAM<SeenColumn, column_count, gap> seen_columns_;
  HorizontalSum<box, 5> box_textured_, box_explained_, box_shown_, box_nearer_;
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
