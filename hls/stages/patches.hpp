// SPDX-License-Identifier: Apache-2.0
// patches: a part of `agreement`. Is the right image displaced across the rows, to a part of a pixel? `registration` says
// it of cells, coarsely and at once; this says it at full resolution, of a few places of each frame.
//
// A place is a cell that the frame before has explained by some depth. In bands of rows, one in each half of the image:
// the left camera's window of 12×12 px around it is compared with the right one's, ±8 px along the row and across. Pixels
// become four bits: whether the gradient (thesis eq. 10.2, 10.3: low-passed, then Sobel) goes up or down by more than
// gradient_limit, in x and in y. Neither offset nor a moderate gain changes them. A place counts where it has texture,
// where it fits, and where it fits nowhere else across the rows. The fraction of a row is where two lines of equal and
// opposite slope meet (Shimizu and Okutomi, ICCV 2001). From it goes what the slope of the epipolar line makes of the shift.
//
// Of a round of at least least_places places: more than half of them are displaced by patch_limit or more, all up or all
// down; or the left ones up and the right ones down, or the upper and the lower ones, or the other way round. Where two rounds
// one after the other say so, a camera has moved. One is not enough: patterns that repeat give places a wrong depth, and the
// same ones again. The bands are other rows in the next frame, the places of a band others by chance.
//
// That less than half are displaced shows nothing: of a camera that is rolled, places near the middle of the image are not.
// A round is *clear* where in each of these ways no more than 5/16 are. The first round, if it is clear, or two clear ones one
// after the other say that no camera has moved. Before that nothing is known, and a camera that has moved has, until they do.
// What is known grows old: it is forgotten where rounds have said neither for patch_known_frames.
//
// A place that is displaced by no more than a pixel along the row lies on the skin. Where more than on_skin_limit of a round's
// places do, something large does, whatever the rule says of its pixels: *overlooked*, until a round shows fewer. This is told by
// other means than the rule's, so that what blinds the rule (haze or a drop on a lens, coarse pictures) does not blind both.
// A frame whose alarm says so already, alarm_before, begins anew: none of its round's places count for this.
//
// Memory: both cameras' windows; the right one's bits by row; places; a score a row.
// Time: patch_beats for a place. A band for which there is no time, in narrow images, is left out.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "horopter/hls/window.hpp"
#include "stages/count_bits.hpp"
#include "stages/stream.hpp"

namespace horopter::stages {

/// So far up or down, at most, an epipolar line may lead a place that is compared.
inline constexpr int patch_reach_across_px = 5;
/// The limit with which nothing is said, or waited for.
inline constexpr int patch_limit_never = 63;
inline constexpr int on_skin_limit_never = 31;

/// Frames for which it stays known whether a camera has moved. Of real pairs in simulation, at rest, with noise or half the gain
/// in one camera, rounds that say so were up to 354 frames apart.
inline constexpr int patch_known_frames = 512;

/// Of the last complete round.
struct PatchRound {
  u<8> places;
  s<12> across;  // sum of their displacements, each of at most ±2 px: 1/8 px
  u<3> moved;    // bit 0: one way; left and right opposite ways; upper and lower
  u<8> on_skin;  // places
};

/// AT_ONCE: on the CPU a band is compared at once; what it shows counts in the same beat as in the hardware.
template <Profile P, int CELL, std::size_t DISTANCE, bool AT_ONCE>
class Patches {
 public:
  using Shift = s<6>;   // along the row, cells
  using Column = u<8>;  // of cells, and beyond
  using Slope = s<8>;   // rows down a column to the right, 1/256
  static constexpr int least_places = 24;
  static constexpr int least_on_skin = 4;
  static constexpr int decide_steps = 24;

  void begin_step() {
    right_0_.begin_step();
    right_1_.begin_step();
    left_.begin_step();
    columns_above_.begin_step();
    right_codes_.begin_step();
    left_codes_.begin_step();
    rows_.begin_step();
    choices_.begin_step();
  }

  // Places ------------------------------------------------------------------------------------------------------------

  /// A row of cells is going to be looked through: one before the image's, its first, or the next one.
  void start_row(bool of_image, bool first) {
    const Band here = first ? Band{next_phase(), u<5>(0)} : choosing_;
    chooses_ = of_image && here.rows_to_next == 0;
    choosing_band_ = here.number;
    choosing_ = here.next();
    const bool next = (chance_.bit(15) != chance_.bit(13)) != (chance_.bit(12) != chance_.bit(10));
    chance_ = u<16>(cat(chance_.template bits<14, 0>(), next));
  }

  /// Where the epipolar line leads so many rows down, 1/32 cell, a place that was not moved is found.
  static constexpr bool in_reach(s<11> expected) {
    constexpr int limit = patch_reach_across_px * 32 / CELL;
    return expected <= limit && expected >= -limit;
  }
  /// A cell of that row, from left to right. `last`: the row's last column.
  void step_cell(Column x, Column last, bool explained, Shift shift, Slope slope) {
    const s<10> other(s<10>(x) + shift);
    const bool right = shl<1>(x) > last;
    const bool beside_middle = !right && shl<1>(x) + lit<2>() > last;  // windows of both halves do not meet
    const bool fits =
        x >= 1 && x < last && !beside_middle && other >= margin_cells && other + lit<margin_cells>() <= s<10>(last);
    // The first one from a column of chance on, or the last one before it.
    const u<5> of_32 = right ? chance_.template bits<4, 0>() : chance_.template bits<9, 5>();
    const Column further(last >= 64 ? u<6>(shl<1>(of_32)) : u<6>(of_32));
    const Column from(further + (right ? Column(shr<1>(last)) : Column(0)));
    offer_.place = {explained && fits, x, shift, slope};
    offer_.far_enough = x >= from;
    offer_.ends_half = x == last || (!right && shl<1>(x) + lit<2>() > last);
    offer_.right = right;
  }

  // Pixels ------------------------------------------------------------------------------------------------------------

  /// A pixel of both images in raster order, also in the rows behind the frame. Position: see CellPosition.
  template <class Position, class Config>
  void take(const Position& at, const std::array<u<8>, 2>& pixel, bool present, const Config& config) {
    const bool row_starts = at.row_starts;
    // Of the beat before, as rows are long: the next band, and the first one of the next frame.
    const Band next = band_rows_.next(), first = first_band();
    if (row_starts) start_pixels(at, config);
    if (fetch_ != 0) fetch_place();
    const u<x_bits> x(cat(at.column, at.x));
    const u<x_bits + 1> behind(x + lit<right_window / 2>());  // the right window's middle, if it begins here
    std::array<u<6>, 2> right_at{};
    std::array<u<5>, 2> left_at{};
    for (std::size_t h = 0; h < 2; ++h) {
      const bool right_begins = place_[h].valid && behind == right_middle(place_[h]);
      const bool left_begins = place_[h].valid && x == left_from(place_[h]);
      right_at[h] = row_starts ? u<6>(right_window) : (right_begins ? u<6>(0) : right_next_[h]);
      left_at[h] = row_starts ? u<5>(left_window) : (left_begins ? u<5>(0) : left_next_[h]);
      right_next_[h] = right_at[h].bit(5) ? right_at[h] : u<6>(right_at[h] + lit<1>());
      left_next_[h] = left_at[h].bit(4) ? left_at[h] : u<5>(left_at[h] + lit<1>());
      if (capturing_ && !right_at[h].bit(5)) valid_[h] = valid_[h] && present;
    }
    if (capturing_ && !right_at[0].bit(5)) right_0_.write(cat(row_, right_at[0].template bits<4, 0>()), pixel[1]);
    if (capturing_ && !right_at[1].bit(5)) right_1_.write(cat(row_, right_at[1].template bits<4, 0>()), pixel[1]);
    const bool of_left = row_.bit(4) != row_.bit(3);  // 8 to 23
    if (capturing_ && of_left && (!left_at[0].bit(4) || !left_at[1].bit(4))) {
      const bool second = left_at[0].bit(4);
      const auto column = second ? left_at[1].template bits<3, 0>() : left_at[0].template bits<3, 0>();
      left_.write(cat(u<1>(second), u<1>(row_.bit(4)), row_.template bits<2, 0>(), column), pixel[0]);
    }
    next_band_ = next;
    first_band_ = first;
  }

  // Comparison --------------------------------------------------------------------------------------------------------

  /// In every beat, before take().
  template <class Config>
  void work(const Config& config) {
    consider();
#ifndef __HLSC__
    if constexpr (AT_ONCE) {
      if (beats_left_ > 0) count_down(1, config);
      tally(config);
      return;
    }
#endif
    const Summed summed = summed_;
    summed_.last = false;
    const Word word = word_of_right();
    size_ = Bits((work_ == Work::code_right ? Bits(0) : size_) + set_);
    set_ = 0;
    bool weighed = false;
    switch (work_) {
      case Work::code_right:
      case Work::code_left:
        code(word);
        break;
      case Work::match:
        match(word);
        break;
      case Work::weigh:
        weighed = weigh();
        break;
      case Work::idle:
        break;
    }
    // What the beat before has found, flat.
    const bool better = summed.first || summed.row.differing < best_.differing;
    best_ = better ? summed.row : best_;
    if (summed.last) rows_.write(summed.down_by, best_);
    vote_ = vote_of(peak_, second_, config);  // in every beat: nothing waits for whether it is one
    vote_.counts = vote_.counts && weighed;
    advance();
    tally(config);
  }

  /// Behind the frame, steps 0 … decide_steps - 1, then end_frame(). Eight steps for each way to be moved: the quarters of the
  /// image one by one, then what they say. Where left and right, or upper and lower, go opposite ways, up and down are exchanged
  /// in one of them.
  void step_decide(u<6> step) {
    const u<3> quarter = step.template bits<2, 0>();
    const u<3> way = step.template bits<5, 3>();
    decision_.is = true;
    for (int q = 0; q < 4; ++q) decision_.takes[static_cast<std::size_t>(q)] = quarter == q;
    decision_.exchanges = (way == 1 && quarter.bit(0)) || (way == 2 && quarter.bit(1));
    decision_.all = way == 0;
    decision_.begins = quarter == 1;
    decision_.adds = quarter >= 1 && quarter <= 4;
    decision_.ends = quarter == 7;
  }
  void end_frame() {
    frame_ends_ = true;
    bands_chosen_ = choosing_.number;
  }
  [[nodiscard]] bool moved() const { return moved_; }
  [[nodiscard]] bool overlooked() const { return overlooked_; }
  /// It is known whether a camera was moved: nothing is safe before.
  [[nodiscard]] bool settled() const { return !age_.bit(known_bits); }
  [[nodiscard]] const PatchRound& round() const { return round_; }

#ifndef __HLSC__
  /// Beats in which nothing but work() happens.
  template <class Config>
  void skip(int beats, const Config& config) {
    consider();
    if (beats_left_ > 0) count_down(beats, config);
    tally(config);
  }
  /// take() for pixels of a row, none of them its first.
  template <class Position>
  void take_row(const Position& at, int count, const u<8>* left, const u<8>* right, const bool* present) {
    const int begin = CELL * static_cast<int>(at.column.value()) + static_cast<int>(at.x.value());
    if (!capturing_) return;
    while (fetch_ != 0) fetch_place();
    const int row = static_cast<int>(row_.value());
    const auto overlap = [&](int from, int size, const auto& act) {
      for (int x = std::max(begin, from); x < std::min(begin + count, from + size); ++x) act(x - from, x - begin);
      const int next = begin + count - from;  // for take()
      return next >= 0 && next < size ? next : size;
    };
    for (std::size_t h = 0; h < 2; ++h) {
      right_next_[h] = right_window;
      left_next_[h] = left_window;
      if (!place_[h].valid) continue;
      auto& window = h == 0 ? right_0_ : right_1_;
      const int right_begins = static_cast<int>(right_middle(place_[h]).value()) - right_window / 2;
      const int left_begins = static_cast<int>(left_from(place_[h]).value());
      right_next_[h] = overlap(right_begins, right_window, [&](int column, int i) {
        window.write(static_cast<std::size_t>(right_window * row + column), right[i]);
        valid_[h] = valid_[h] && present[i];
      });
      left_next_[h] = overlap(left_begins, left_window, [&](int column, int i) {
        if (row < reach || row >= reach + left_window) return;
        left_.write(
            left_window * (left_window * h + static_cast<std::size_t>(row - reach)) + static_cast<std::size_t>(column),
            left[i]);
      });
    }
  }
#endif

 private:
  static constexpr int side = 12;  // px, of what is compared
  static constexpr int reach = 8;  // px to each side
  static_assert(patch_reach_across_px + 3 <= reach);
  static constexpr int border = 2;                       // px that a gradient needs around it
  static constexpr int left_window = side + 2 * border;  // px
  static constexpr int right_window = left_window + 2 * reach;
  static constexpr int displacements = 2 * reach + 1;
  static constexpr int right_codes = side + 2 * reach;
  static constexpr int gradient_limit = 256;               // 128 are a grey level a pixel
  static constexpr int least_bits = 4 * side * side / 10;  // that are set, of a place with texture
  static constexpr int margin_cells = 16 / CELL;           // of the right window's place to the image's border
  static constexpr int x_bits = bits_for(P.result_width() - 1) + 1;
  static_assert(CELL == 8 || CELL == 16);
  static_assert(left_window == 16 && right_window == 32 && displacements <= 17);

  enum class Work : std::uint8_t { idle, code_right, code_left, match, weigh };
  static constexpr int beats_of(Work work) {
    switch (work) {
      case Work::code_right:
        return right_window * right_window;
      case Work::code_left:
        return right_window * left_window;  // its rows take as long
      case Work::match:
        return displacements * displacements * side;
      case Work::weigh:
        return 97;
      case Work::idle:
        break;
    }
    return 0;
  }

  static constexpr int patch_beats =
      beats_of(Work::code_right) + beats_of(Work::code_left) + beats_of(Work::match) + beats_of(Work::weigh);
  /// Rows of cells from a band to the next: until both places are compared.
  static constexpr int stride = [] {
    constexpr int row_beats = P.result_width() * (P.packed() ? 2 : 1);
    constexpr int rows = right_window + 3 + (2 * patch_beats + row_beats - 1) / row_beats;
    return std::min(15, (rows + CELL - 1) / CELL);  // so narrow an image leaves bands out
  }();

  struct Choice {
    bool valid = false;
    Column column;
    Shift shift;
    Slope slope;
  };
  /// A cell for its half of the band.
  struct Offer {
    Choice place;
    bool far_enough = false, ends_half = false, right = false;
  };
  /// Rows of cells until the next band, and its number.
  struct Band {
    u<4> rows_to_next;
    u<5> number;
    [[nodiscard]] Band next() const {
      const bool is = rows_to_next == 0;
      return {is ? u<4>(stride - 1) : u<4>(rows_to_next - lit<1>()), u<5>(number + u<1>(is))};
    }
  };
  static_assert(P.height / CELL / stride + 2 < 32);

  [[nodiscard]] u<4> next_phase() const { return phase_ == stride - 1 ? u<4>(0) : u<4>(phase_ + lit<1>()); }
  static u<x_bits> left_from(const Choice& choice) {
    return u<x_bits>(s<x_bits + 2>(u<x_bits>(shl<bits_for(CELL - 1)>(choice.column))) +
                     s<5>(CELL / 2 - left_window / 2));
  }
  static u<x_bits + 1> right_middle(const Choice& choice) {
    const s<10> column(s<10>(choice.column) + choice.shift);
    return u<x_bits + 1>(cat(u<x_bits + 1 - bits_for(CELL - 1)>(column), u<bits_for(CELL - 1)>(CELL / 2)));
  }

  /// The first bands of a frame would begin above it.
  [[nodiscard]] Band first_band() const {
    const u<4> phase = next_phase();
    const bool above = phase < margin_cells;
    return {u<4>(phase + (above ? u<4>(stride - margin_cells) : u<4>(16 - margin_cells))), u<5>(u<1>(above))};
  }

  /// What step_cell() has offered in the beat before. Flat, as advance() is.
  void consider() {
#ifndef __HLSC__
    if (!offer_.place.valid && !offer_.ends_half) return;  // nothing changes
#endif
    const Offer offer = offer_;
    offer_ = Offer{};
    const bool takes = offer.place.valid && !fixed_;
    Choice now = choice_;
    if (takes) now = offer.place;
    if (offer.ends_half && chooses_) choices_.write(cat(choosing_band_, offer.right), now);
    choice_ = now;
    choice_.valid = now.valid && !offer.ends_half;
    fixed_ = !offer.ends_half && (fixed_ || (takes && offer.far_enough));
  }

  /// One of the band's two places.
  void fetch_place() {
    const bool second = fetch_.bit(1);
    const Choice place = choices_.read(cat(band_, second));
    const bool is_chosen = place.valid && band_ < bands_chosen_;
    place_[second ? 1 : 0] = place;
    place_[second ? 1 : 0].valid = is_chosen;
    valid_[second ? 1 : 0] = is_chosen;
    fetch_ = second ? u<2>(0) : u<2>(2);
  }

  /// A band's window begins so many rows above its cells' middle; its first rows of cells have none.
  template <class Position, class Config>
  void start_pixels(const Position& at, const Config& config) {
    const bool goes_on = capturing_ && !at.first;
    const bool ends = goes_on && row_ == right_window - 1;
    const bool at_middle = at.y == CELL / 2 && at.live;  // not in the image's first row
    const bool begins = at_middle && band_rows_.rows_to_next == 0 && !goes_on && idle();
    row_ = begins ? u<5>(0) : u<5>(row_ + lit<1>());
    if (begins) {
      band_ = band_rows_.number;
      fetch_ = 1;
      const auto y = cat(at.row, at.y);
      lower_ = shl<1>(y) + lit<right_window>() >= config.height;
    }
    band_rows_ = at.first ? first_band_ : (at_middle ? next_band_ : band_rows_);
    phase_ = at.first ? next_phase() : phase_;
    capturing_ = begins || (goes_on && !ends);
    if (ends) {
      begins_ = true;
#ifndef __HLSC__
      if constexpr (AT_ONCE) compare_at_once();
#endif
    }
  }
  [[nodiscard]] bool idle() const {
#ifndef __HLSC__
    if constexpr (AT_ONCE) return beats_left_ == 0;
#endif
    return idle_;
  }

  /// To the next beat of the comparison. Flat, so that the way from register to register is short.
  void advance() {
    const bool next = begins_ || ends_;
    const Work now = work_;
    const u<12> beats = begins_ ? u<12>(beats_of(Work::code_right) - 1) : following_beats_;
    const Work following = begins_ ? Work::code_right : following_;
    idle_ = now == Work::idle && !begins_;
    following_beats_ = u<12>(beats_of(following_) - 1);
    // What follows is known long before.
    following_ = now == Work::code_right            ? Work::code_left
                 : now == Work::code_left           ? Work::match
                 : now == Work::match               ? Work::weigh
                 : (now == Work::weigh && !second_) ? Work::code_right
                                                    : Work::idle;
    second_ = !begins_ && (second_ || (ends_ && now == Work::weigh));
    ends_ = !next && remaining_ == 1;
    remaining_ = next ? beats : u<12>(remaining_ - lit<1>());
    work_ = next ? following : now;
    code_row_ = next ? u<5>(0) : u<5>(code_row_ + u<1>(column_ends_));
    column_ends_ = !next && column_ == right_window - 2;
    column_ = next ? u<5>(0) : u<5>(column_ + lit<1>());
    const bool row_ends = along_ends_, last_row = row_ends && match_row_ends_;
    along_ends_ = !next && along_ == displacements - 2;
    along_ = next || row_ends ? u<5>(0) : u<5>(along_ + lit<1>());
    match_row_ends_ = !next && (row_ends ? match_row_ == side - 2 : match_row_ends_);
    match_row_ = next || last_row ? u<4>(0) : u<4>(match_row_ + u<1>(row_ends));
    down_by_ = next ? u<5>(0) : u<5>(down_by_ + u<1>(last_row));
    step_ = next ? u<7>(0) : u<7>(step_ + lit<1>());
    begins_ = false;
  }

  struct Above {
    std::array<u<8>, 4> pixel{};  // the row above first
  };
  // Rows of codes are kept in words, so that a memory as narrow as those of FPGAs holds them.
  static constexpr int codes_a_word = 7;
  static constexpr int words_a_row = right_codes / codes_a_word;
  using Word = u<4 * codes_a_word>;
  static_assert(words_a_row * codes_a_word == right_codes && words_a_row == 4 && displacements >= 2 * codes_a_word + 2);
  /// Of a row, from the column that is compared on; the first column lowest.
  struct RowCodes {
    u<56> at;
    Word further;
  };
  using Bits = u<10>;
  // A round has fewer places than least_places and those of one frame.
  using Places = u<8>;
  struct Quarter {
    Places places, up, down;
  };
  static_assert(least_places + 2 * (P.height / CELL / stride + 2) < 256);
  struct Row {
    Bits differing;
    u<5> column;
  };

  /// Below -gradient_limit, above it; in look-up tables, as a comparison behind a sum is a second carry chain.
  static u<2> beyond(s<15> g) {
    static_assert(gradient_limit == 1 << 8);
    const bool below = g.negative() && g.template bits<13, 8>() != 63;
    const bool above = !g.negative() && (g.template bits<13, 9>() != 0 || (g.bit(8) && g.template bits<7, 0>() != 0));
    return cat(u<1>(below), u<1>(above));
  }
  static u<4> code_of(s<15> gx, s<15> gy) { return cat(beyond(gx), beyond(gy)); }

  /// Pixels of the right window, then of the left one, become bits. Both have rows of right_window beats.
  void code(Word word) {
    const bool of_right = work_ == Work::code_right;
    const auto in_right = cat(code_row_, column_);
    u<8> pixel(0);
    if (of_right && !second_) pixel = right_0_.read(in_right);
    if (of_right && second_) pixel = right_1_.read(in_right);
    if (!of_right) {
      pixel = left_.read(cat(u<1>(second_), code_row_.template bits<3, 0>(), column_.template bits<3, 0>()));
    }
    const Above above = columns_above_.read(column_);
    columns_above_.write(column_, Above{{pixel, above.pixel[0], above.pixel[1], above.pixel[2]}});
    const u<12> smooth(above.pixel[3] + shl<2>(above.pixel[2]) + shl<2>(above.pixel[1]) + shl<1>(above.pixel[1]) +
                       shl<2>(above.pixel[0]) + pixel);
    const s<11> down(pixel + shl<1>(above.pixel[0]) - shl<1>(above.pixel[2]) - above.pixel[3]);
    const s<15> gx(smooth + shl<1>(smooth_.tap(0)) - shl<1>(smooth_.tap(2)) - smooth_.tap(3));
    const s<15> gy(down + shl<2>(down_.tap(0)) + shl<2>(down_.tap(1)) + shl<1>(down_.tap(1)) + shl<2>(down_.tap(2)) +
                   down_.tap(3));
    smooth_.push(smooth);
    down_.push(down);
    const u<4> bits = code_of(gx, gy);
    codes_.at = cat(bits, codes_.at.template bits<55, 4>());
    const bool inside = code_row_ >= 2 * border && column_ >= 2 * border;
    bool word_ends = false;
    u<2> of_row(0);
    for (int w = 0; w < words_a_row; ++w) {
      const bool here = column_ == 2 * border - 1 + codes_a_word * (w + 1);
      word_ends = word_ends || here;
      of_row = here ? u<2>(w) : of_row;
    }
    if (of_right && inside && word_ends) {
      right_codes_.write(cat(u<5>(code_row_ - lit<2 * border>()), of_row), codes_.at.template bits<55, 28>());
    }
    const bool of_left = !of_right && inside && column_ < left_window;
    if (of_left && column_ == left_window - 1) {
      left_codes_.write(u<4>(code_row_ - lit<2 * border>()), codes_.at.template bits<55, 8>());
    }
    if (!of_right && column_ >= right_window - 2) fetch_next(word);
    set_ = of_left ? count_bits(bits) : u<3>(0);
  }

  /// The word that code() or match() takes in this beat: the third one of a row with its first displacement, the fourth
  /// when that is used up; with the last two the first two of the row that is next.
  Word word_of_right() {
    const bool coding = work_ == Work::code_left;
    const bool next = coding || along_ >= displacements - 2;
    const u<5> row(down_by_ + match_row_);
    const u<5> row_next = match_row_ends_ ? u<5>(down_by_ + lit<1>()) : u<5>(row + lit<1>());
    const u<5> of = coding ? u<5>(0) : (next ? row_next : row);
    const bool odd = coding ? column_.bit(0) : (next ? along_ == displacements - 1 : along_ != 0);
    return coding || work_ == Work::match ? right_codes_.read(cat(of, u<1>(!next), u<1>(odd))) : Word(0);
  }
  void fetch_next(Word word) { next_codes_ = cat(word, next_codes_.template bits<55, 28>()); }

  /// Row by row of the left window against that of the right one, at all displacements along it; then the next displacement
  /// across the rows.
  void match(Word word) {
    const bool new_row = along_ == 0;
    const RowCodes moved{u<56>(cat(codes_.further.template bits<3, 0>(), codes_.at.template bits<55, 4>())),
                         Word(codes_.further.template bits<27, 4>())};
    if (new_row) {
      codes_.at = next_codes_;
      left_row_ = left_codes_.read(match_row_);
    } else {
      codes_.at = moved.at;
    }
    codes_.further = new_row || along_ == codes_a_word ? word : moved.further;
    if (along_ >= displacements - 2) fetch_next(word);
    const u<48> other = codes_.at.template bits<47, 0>();
    const u<6> differing = count_bits(u<48>(left_row_ ^ other));
    const Bits sum((match_row_ == 0 ? Bits(0) : sums_.tap(displacements - 1)) + differing);
    sums_.push(sum);
    summed_ = {{sum, along_}, new_row, along_ends_ && match_row_ends_, down_by_};
  }

  /// Steps 32 on: the row that fits best. 64 on: those beside it, and the best of those that lie further away. 96: true,
  /// it is known.
  [[nodiscard]] bool weigh() {
    const u<5> at = step_.template bits<4, 0>();
    const auto pass = step_.template bits<6, 5>();
    // What the beat before has read, flat, so that the way from register to register is short.
    const Read read = read_;
    const bool better = read.searches && (read.first || read.row.differing < peak_.best.differing);
    peak_.best = better ? read.row : peak_.best;
    peak_.row = better ? read.at : peak_.row;
    peak_.above = read.above ? read.row.differing : peak_.above;
    peak_.below = read.below ? read.row.differing : peak_.below;
    peak_.far = read.first || read.far < peak_.far ? read.far : peak_.far;

    read_ = Read{};
    if (at < displacements && (pass == 1 || pass == 2)) {
      const s<6> away(at - peak_.row);
      read_.row = rows_.read(at);
      read_.at = at;
      read_.first = at == 0;
      read_.searches = pass == 1;
      read_.above = pass == 2 && away == -1;
      read_.below = pass == 2 && away == 1;
      read_.far = pass == 2 && (away > 2 || away < -2) ? read_.row.differing : Bits::max();
    }
    if (pass == 3) peak_.size = size_;
    return pass == 3;
  }

  /// Of a beat of weigh().
  struct Read {
    Row row;
    u<5> at;
    bool first = false, searches = false, above = false, below = false;
    Bits far = Bits::max();  // bits that differ, of a row that is more than two away from the best one
  };

  struct Peak {
    Row best;
    u<5> row;
    Bits above, below, far;  // bits that differ: one row up, one down, in the best of those more than two away
    Bits size;               // bits that are set
  };

  /// 1/8 px down.
  static s<8> across(const Peak& peak) {
    const bool up = peak.above < peak.below;
    const Bits high = up ? peak.below : peak.above, low = up ? peak.above : peak.below;
    const Bits fall(high - peak.best.differing), rise(high - low);
    const auto eight = shl<3>(rise);
    const u<3> fraction(u<2>(u<1>(eight >= fall) + u<1>(eight >= shl<1>(fall) + fall)) +
                        u<2>(u<1>(eight >= shl<2>(fall) + fall) + u<1>(eight >= shl<3>(fall) - fall)));
    const auto whole = shl<3>(s<6>(peak.row - lit<reach>()));
    return up ? s<8>(whole - fraction) : s<8>(whole + fraction);
  }

  /// What a place says, if it counts.
  struct Vote {
    bool counts = false, right = false, up = false, down = false, on_skin = false;
    s<6> across;
  };

  template <class Config>
  [[nodiscard]] Vote vote_of(const Peak& peak, bool second, const Config& config) const {
    const Choice& choice = place_[second ? 1 : 0];
    const bool textured = peak.size >= least_bits;
    const bool fits = shl<1>(peak.best.differing) <= peak.size;
    const bool alone = peak.far >= peak.best.differing && shl<3>(Bits(peak.far - peak.best.differing)) >= peak.size;
    const bool between = peak.row != 0 && peak.row != displacements - 1;
    const s<11> along(s<10>(shl<bits_for(CELL - 1)>(choice.shift)) + s<6>(peak.best.column - lit<reach>()));
    const s<14> expected(s<14>(shr<5>(s<19>(along * choice.slope))));
    const s<15> residual(across(peak) - expected);
    const s<7> limit(u<6>(config.patch_limit));
    Vote vote;
    vote.counts = valid_[second ? 1 : 0] && textured && fits && alone && between;
    vote.right = second;
    vote.down = residual >= limit;
    vote.up = residual <= -limit;
    vote.on_skin = along >= lit<-1>() && along <= lit<1>();
    vote.across = residual > 16 ? s<6>(16) : (residual < -16 ? s<6>(-16) : s<6>(residual));
    return vote;
  }

  /// What a place says, and a step of the decision. Flat, so that the way from register to register is short.
  template <class Config>
  void tally(const Config& config) {
    const u<5> on_skin_limit = on_skin_limit_;  // beside the multiplier
    on_skin_limit_ = config.on_skin_limit;
#ifndef __HLSC__
    if (!vote_.counts && !decision_.is && !frame_ends_ && !frame_ended_) return;  // nothing changes
#endif
    const Decision& d = decision_;
    const Quarter sum = sum_, word = word_;
    const auto only = [](bool so, Places value) { return so ? value : Places(0); };
    sum_.places = d.adds ? Places(only(!d.begins, sum.places) + word.places) : sum.places;
    sum_.up = d.adds ? Places(only(!d.begins, sum.up) + word.up) : sum.up;
    sum_.down = d.adds ? Places(only(!d.begins, sum.down) + word.down) : sum.down;
    word_ = Quarter{};
    for (std::size_t q = 0; q < 4; ++q) {
      word_.places = word_.places | only(d.takes[q], quarters_[q].places);
      word_.up = word_.up | only(d.takes[q], d.exchanges ? quarters_[q].down : quarters_[q].up);
      word_.down = word_.down | only(d.takes[q], d.exchanges ? quarters_[q].up : quarters_[q].down);
    }
    const bool starts = round_ends_;
    round_ends_ = frame_ends_ && complete_;
    const bool ages = frame_ended_;
    frame_ended_ = frame_ends_;
    frame_ends_ = false;
    if (starts) round_ = {places_, across_, found_, on_skin_};
    overlooked_ = !config.alarm_before && (starts ? large_ && !spoiled_ : overlooked_);
    spoiled_ = config.alarm_before != 0 || (spoiled_ && !starts);
    const bool found = found_ != 0;
    moved_ = starts ? twice_ || (moved_ && !clear_) : moved_;
    age_ = starts && (twice_ || clear_) ? Age(0) : Age(age_ + u<1>(ages && !age_.bit(known_bits)));
    twice_ = found && suspected_;
    clear_ = !doubted_ && !doubted_before_;
    if (starts) {
      suspected_ = found;
      doubted_before_ = doubted_;
    }
    if (d.ends) found_ = u<3>(cat(enough_ && mostly_, found_.template bits<2, 1>()));
    doubted_ = d.ends ? partly_ || (!d.all && doubted_) : doubted_;
    complete_ = d.ends && d.all ? enough_ : complete_;
    places_ = d.ends && d.all ? sum.places : places_;
    enough_ = sum.places >= least_places;
    mostly_ = shl<1>(sum.up) > sum.places || shl<1>(sum.down) > sum.places;
    partly_ = shl<4>(sum.up) > clear_limit_ || shl<4>(sum.down) > clear_limit_;
    clear_limit_ = u<11>(shl<2>(sum.places) + sum.places);
    const bool says = config.on_skin_limit != lit<on_skin_limit_never>();
    const u<13> on_skin_most(places_ * on_skin_limit);  // 1/32 place
    large_ = says && on_skin_ >= lit<least_on_skin>() && shl<5>(on_skin_) > on_skin_most;

    for (std::size_t q = 0; q < 4; ++q) {
      const u<1> here(vote_.counts && (q >= 2) == lower_ && (q % 2 == 1) == vote_.right);
      Quarter& of = quarters_[q];
      of.places = Places(only(!starts, of.places) + here);
      of.up = Places(only(!starts, of.up) + u<1>(here & u<1>(vote_.up)));
      of.down = Places(only(!starts, of.down) + u<1>(here & u<1>(vote_.down)));
    }
    across_ = s<12>((starts ? s<12>(0) : across_) + (vote_.counts ? vote_.across : s<6>(0)));
    on_skin_ = Places((starts ? Places(0) : on_skin_) + u<1>(vote_.counts && vote_.on_skin));
    vote_ = Vote{};
    decision_ = Decision{};
  }

#ifndef __HLSC__
  /// What code(), match() and weigh() come to.
  void compare_at_once() {
    for (std::size_t h = 0; h < 2; ++h) peaks_[h] = peak_at_once(h);
    beats_left_ = 2 * patch_beats + 2;  // it begins with the next beat, and is at rest in the one after its end
  }
  template <class Config>
  void count_down(int beats, const Config& config) {
    const int before = beats_left_;
    beats_left_ = std::max(0, beats_left_ - beats);
    if (before > patch_beats + 1 && beats_left_ <= patch_beats + 1) {
      vote_ = vote_of(peaks_[0], false, config);
      tally(config);
    }
    if (before > 1 && beats_left_ <= 1) vote_ = vote_of(peaks_[1], true, config);
  }

  using Codes = std::array<std::array<std::uint64_t, 2>, right_codes>;  // of a row: four bits a pixel
  template <int SIZE, class At>
  static Codes codes_at_once(const At& pixel) {
    Codes codes{};
    std::array<std::array<int, SIZE>, SIZE> smooth{}, down{};
    for (int y = 4; y < SIZE; ++y) {
      for (int x = 0; x < SIZE; ++x) {
        const int a = pixel(y, x), b = pixel(y - 1, x), c = pixel(y - 2, x), d = pixel(y - 3, x), e = pixel(y - 4, x);
        smooth[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = a + 4 * b + 6 * c + 4 * d + e;
        down[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = a + 2 * b - 2 * d - e;
      }
    }
    for (std::size_t y = 4; y < SIZE; ++y) {
      for (std::size_t x = 4; x < SIZE; ++x) {
        const auto& s = smooth[y];
        const auto& d = down[y];
        const int gx = s[x] + 2 * s[x - 1] - 2 * s[x - 3] - s[x - 4];
        const int gy = d[x] + 4 * d[x - 1] + 6 * d[x - 2] + 4 * d[x - 3] + d[x - 4];
        const std::uint64_t bits = code_of(gx, gy).value();
        codes[y - 4][(x - 4) / 14] |= bits << (4 * ((x - 4) % 14));
      }
    }
    return codes;
  }
  Peak peak_at_once(std::size_t half) {
    auto& window = half == 0 ? right_0_ : right_1_;
    const Codes right = codes_at_once<right_window>([&](int y, int x) {
      return static_cast<int>(window.read(static_cast<std::size_t>(right_window * y + x)).value());
    });
    const Codes left = codes_at_once<left_window>([&](int y, int x) {
      return static_cast<int>(
          left_.read(left_window * (left_window * half + static_cast<std::size_t>(y)) + static_cast<std::size_t>(x))
              .value());
    });
    Peak peak;
    int size = 0;
    for (std::size_t r = 0; r < side; ++r) size += std::popcount(left[r][0]);
    peak.size = size;
    std::array<int, displacements> rows{};
    int best_row = 0;
    int best_column = 0;
    for (int i = 0; i < displacements; ++i) {
      std::array<int, displacements> sums{};
      for (int r = 0; r < side; ++r) {
        const auto& word = right[static_cast<std::size_t>(i + r)];
        for (int j = 0; j < displacements; ++j) {
          const std::uint64_t other = j < 14 ? word[0] >> (4 * j) | (j == 0 ? word[1] << 56 : word[1] << (56 - 4 * j))
                                             : word[1] >> (4 * (j - 14));
          constexpr std::uint64_t mask = (std::uint64_t{1} << (4 * side)) - 1;
          sums[static_cast<std::size_t>(j)] += std::popcount((other ^ left[static_cast<std::size_t>(r)][0]) & mask);
        }
      }
      const auto least = std::min_element(sums.begin(), sums.end());
      rows[static_cast<std::size_t>(i)] = *least;
      if (i == 0 || *least < rows[static_cast<std::size_t>(best_row)]) {
        best_row = i;
        best_column = static_cast<int>(least - sums.begin());
      }
    }
    peak.row = best_row;
    peak.best = {rows[static_cast<std::size_t>(best_row)], best_column};
    if (best_row > 0) peak.above = rows[static_cast<std::size_t>(best_row) - 1];
    if (best_row + 1 < displacements) peak.below = rows[static_cast<std::size_t>(best_row) + 1];
    int far = static_cast<int>(Bits::max().value());
    for (int i = 0; i < displacements; ++i) {
      if (std::abs(i - best_row) > 2) far = std::min(far, rows[static_cast<std::size_t>(i)]);
    }
    peak.far = far;
    return peak;
  }
#endif

  // Places: of the frame that passes, and of the next one.
  u<4> phase_{0};
  Band band_rows_, next_band_, first_band_, choosing_;
  bool chooses_ = false;
  u<5> choosing_band_{0};
  u<16> chance_{1};
  bool fixed_ = false;
  Choice choice_;
  Offer offer_;
  RAM<Choice, 64, DISTANCE> choices_;

  // Pixels.
  bool capturing_ = false;
  bool lower_ = false;  // in the lower half of the image
  u<5> band_{0};
  u<5> row_{0};    // of the window
  u<2> fetch_{0};  // one of the two places, one-hot
  std::array<Choice, 2> place_{};
  std::array<bool, 2> valid_{};
  std::array<u<6>, 2> right_next_{};
  std::array<u<5>, 2> left_next_{};
  RAM<u<8>, std::size_t{right_window * right_window}, DISTANCE> right_0_, right_1_;
  RAM<u<8>, std::size_t{2 * left_window * left_window}, DISTANCE> left_;

  // Comparison.
  Work work_ = Work::idle;
  bool second_ = false;  // place
  Work following_ = Work::idle;
  u<12> following_beats_{0};
  bool begins_ = false, ends_ = false, idle_ = true;
  u<12> remaining_{0};  // beats
  u<5> code_row_{0}, column_{0};
  bool column_ends_ = false, along_ends_ = false, match_row_ends_ = false;
  RAM<Above, std::size_t{right_window}, DISTANCE> columns_above_;
  DelayLine<u<12>, 4> smooth_;
  DelayLine<s<11>, 4> down_;
  RowCodes codes_;
  u<56> next_codes_{0};
  RAM<Word, std::size_t{words_a_row * right_codes}, DISTANCE> right_codes_;  // by row and word
  RAM<u<4 * side>, std::size_t{side}, DISTANCE> left_codes_;
  u<3> set_{0};  // of the beat before
  Bits size_{0};
  u<5> down_by_{0}, along_{0};
  u<4> match_row_{0};
  u<4 * side> left_row_{0};
  DelayLine<Bits, displacements> sums_;
  struct Summed {
    Row row;
    bool first = false, last = false;
    u<5> down_by;
  };
  Summed summed_;  // in the beat before
  Row best_;
  RAM<Row, std::size_t{displacements}, DISTANCE> rows_;
  u<7> step_{0};
  Read read_;
  Peak peak_;

  // What is known.
  std::array<Quarter, 4> quarters_{};  // top left, top right, bottom left, bottom right
  struct Decision {
    bool is = false;
    bool all = false;                   // quarters go the same way
    std::array<bool, 4> takes{};        // one of them
    bool exchanges = false;             // up and down, in it
    bool begins = false, adds = false;  // what was taken a beat before
    bool ends = false;
  };
  Vote vote_;  // of this beat
  u<5> on_skin_limit_{0};
  Decision decision_;
  Quarter word_, sum_;
  s<12> across_{0};
  Places places_{0};
  bool enough_ = false, mostly_ = false, partly_ = false;
  u<11> clear_limit_{0};   // 5/16 of the places
  bool complete_ = false;  // the round
  u<5> bands_chosen_{0};   // of the frame before, the first ones; others have what the memory had, also before a reset
  bool frame_ends_ = false, frame_ended_ = false, round_ends_ = false;
  u<3> found_{0};
  bool doubted_ = false, doubted_before_ = false;  // the last round, and the one before
  PatchRound round_;
  Places on_skin_{0};
  bool large_ = false, overlooked_ = false;
  bool spoiled_ = false;  // a frame of the round follows one with an alarm
  bool suspected_ = false, moved_ = false;
  bool twice_ = false, clear_ = false;  // what the round says, of the beat before
  static constexpr int known_bits = bits_for(patch_known_frames - 1);
  static_assert(patch_known_frames == 1 << known_bits);
  using Age = u<known_bits + 1>;
  Age age_{patch_known_frames};  // frames, of what is known; so old is nothing
#ifndef __HLSC__
  std::array<Peak, 2> peaks_{};
  int beats_left_ = 0;
#endif
};

}  // namespace horopter::stages
