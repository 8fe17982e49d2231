// SPDX-License-Identifier: Apache-2.0
// health: can this camera's image be an image (thesis 2.3)? One instance per camera, on the pixels as they arrive.
//
// In      pixel; first, end: the frame's first and last pixel; last: a row's last pixel.
// Config  dark_level, bright_level: grey levels at or below (at or above) which a pixel is black (white);
//         dark_limit, bright_limit: pixels; contrast_limit: grey levels; frozen_limit: repetitions, 0 switches it off.
// Out     one beat per frame, with its last pixel:
//         black, white: more than the limit of pixels are; constant: the frame's grey levels span at most
//         contrast_limit, and it is neither black nor white; frozen: its signature has equalled that of one of
//         the FRAMES before, for at least frozen_limit frames in a row (two images, as two old ones in turn repeat the
//         one before the last; an image may be two fields, which are frames); signature: the frame's, that of a
//         multiple-input shift register (MISR; Williams, Daehn, Gruetzner, Starke, IEEE Trans. CAD 7(2), 1988) with the
//         polynomial of CRC-32: equal frames have equal ones, and two noisy frames by chance once in 2^32.
//         torn: its rows do not belong together. What is compared is which of two pixels a pixel is more like, by 2 grey
//         levels or more. A difference is how often it is the one, less how often it is the other; "all" is how often it
//         is one of them. So contrast hardly matters, and noise alone makes both alike.
//         down: like the pixel one row above, less like that two rows above. second: two rows above, four rows above.
//         along: one pixel to the left, two to the left. level: two pixels to the left, one row above. (To the left it is
//         ACROSS times as far: the rows of a field are two rows of the camera apart.) In a scene down, second and along
//         are above 0, and level is below. Torn is
//         - rows of two moments in turn, as of an interlaced image of what moves: -down > all/16 + 48;
//         - rows that each lie aside: 2 along - 5 down > all/16 + 500, because a scene changes as much along as down; and
//           level > all/16 + 100, because what stands upright is the same down, but for noise;
//         - pairs of rows that lie aside: -second > all/16 + 100, and down differs between even and odd rows, by more
//           than 3/8 of -second: the lower row of a pair is like the upper one, the upper one is like none above.
//         What else is torn: stripes along the row that repeat every 2 to 3 rows, over a large part of the image; stripes
//         that repeat after 4 rows (3.99 to 4.01), all over it and not aslant. Other stripes of 3 to 6 rows make second
//         less than 0, too, but even and odd rows alike. And images that are much finer down than along: stripes that
//         are nearly level and repeat every 3 to 4 rows; without ACROSS, a single field of a fine scene.
//         All are taken in the same columns, at most 64. But along is taken in columns that move on by 5 with each row:
//         so an image that is enlarged, each pixel to a block, shows all phases of its blocks.
// Memory: the four rows above, in these columns. Rows of at least hls::min_row_beats.
// Illegal use: a frame without `end` is not judged; the next `first` starts anew.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#ifndef __HLSC__
#include <span>
#endif

#include "horopter/hls/line_buffer.hpp"
#include "stages/stream.hpp"

namespace horopter::stages {

template <int WIDTH, int HEIGHT, int ACROSS = 1, int FRAMES = 2>
class CameraHealth {
  static constexpr int step_log2 = WIDTH <= 64 ? 0 : bits_for((WIDTH - 1) / 64);  // between columns, at most 64 of them
  static constexpr int column_bits = bits_for((WIDTH - 1) >> step_log2);
  static constexpr int torn_share = 16;  // so many times what is torn less what is not, above all of it
  static constexpr int turn_pixels = 48;
  static constexpr int aside_pixels = 500;
  static constexpr int level_pixels = 100;
  static constexpr int pair_pixels = 100;
  static constexpr int along_weight = 2;
  static constexpr int down_weight = 5;
  static constexpr std::uint32_t polynomial = 0xEDB88320U;

 public:
  using Count = u<bits_for(WIDTH* HEIGHT)>;

  struct In {
    u<8> pixel;
    bool first = false;
    bool end = false;
    bool last = false;
  };
  struct Config {
    u<8> dark_level;
    u<8> bright_level;
    Count dark_limit;
    Count bright_limit;
    u<8> contrast_limit;
    u<8> frozen_limit;
  };
  struct Out {
    bool valid = false;
    bool black = false;
    bool white = false;
    bool constant = false;
    bool frozen = false;
    bool torn = false;
    u<32> signature;
  };

#ifndef __HLSC__
  static constexpr int pixels_before = 2 * ACROSS;  // of a row: pass() needs them
  /// Takes pixels of a row that follow each other, neither the first ones (pixels_before) nor the last, several at once:
  /// like step() with each. Those of the row before `pixels` stand in memory before them.
  void pass(std::span<const std::uint8_t> pixels, const Config& config) {
    sign(pixels);
    measure_levels(pixels, config);
    constexpr int step = 1 << step_log2;
    const auto x = static_cast<int>(x_.value());
    const auto count = static_cast<int>(pixels.size());
    const auto place = [&](int offset) { return pixels.data() + offset; };
    // The first of the columns of a phase, from here on.
    const auto first_of = [&](int wanted) { return (wanted - x) & (step - 1); };
    for (int i = first_of(step - 1); i < count; i += step) {
      Alike like{};
      for (int k = 0; k < step; ++k) above_.begin_step();  // as many as pixels, for its checks
      compare_down(u<8>(*place(i)), u<8>(*place(i - 2 * ACROSS)), u<column_bits>((x + i) >> step_log2), rows_, like);
      add(like, false, y_);
    }
    for (int i = first_of(static_cast<int>(phase(y_ * lit<5>()).value())); i < count; i += step) {
      Alike like{};
      like.along = likeness(u<8>(*place(i)), u<8>(*place(i - ACROSS)), u<8>(*place(i - 2 * ACROSS)));
      add(like, false, y_);
    }
    for (int k = 0; k < 2 * ACROSS; ++k) left_[static_cast<std::size_t>(k)] = u<8>(*place(count - 1 - k));
    x_ = X(x + count);
  }
#endif

  Out step(const In& in, const Config& config) {
    if (in.first) [[unlikely]]
      signature_ = u<32>(0);
    signature_ = shr<1>(signature_) ^ (signature_.bit(0) ? u<32>(polynomial) : u<32>(0)) ^ in.pixel;
    if (in.first || in.pixel < darkest_) darkest_ = in.pixel;
    if (in.first || in.pixel > brightest_) brightest_ = in.pixel;
    count(dark_, in.first, in.pixel <= config.dark_level);
    count(bright_, in.first, in.pixel >= config.bright_level);
    compare_rows(in);

    Out out;
    out.valid = in.end;
    if (in.end) [[unlikely]] {
      // Without branches: the way from repeats_ to itself is short.
      u<1> same(0);
      for (int i = 0; i < FRAMES; ++i)
        same = same | (u<1>(frames_.bit(i)) & u<1>(signature_ == before_[static_cast<std::size_t>(i)]));
      repeats_ = same == 0 ? u<8>(0) : repeats_ == 255 ? repeats_ : u<8>(repeats_ + lit<1>());
      for (std::size_t i = FRAMES - 1; i > 0; --i) before_[i] = before_[i - 1];
      before_[0] = signature_;
      frames_ = u<FRAMES>(cat(frames_, true));
      out.black = dark_ > config.dark_limit;
      out.white = bright_ > config.bright_limit;
      out.constant = u<8>(brightest_ - darkest_) <= config.contrast_limit && !out.black && !out.white;
      out.frozen = config.frozen_limit != 0 && repeats_ >= config.frozen_limit;
      out.torn =
          turn_ > lit<turn_pixels * torn_share>() ||
          (aside_ > lit<aside_pixels * torn_share>() && level_ > lit<level_pixels * torn_share>()) ||
          (pair_ > lit<pair_pixels * torn_share>() && abs(even_less_odd_) * lit<8 * torn_share>() > pair_ * lit<3>());
    }
    out.signature = before_[0];
    return out;
  }

 private:
  using X = u<bits_for(WIDTH - 1)>;
  static constexpr int most = HEIGHT << column_bits;  // comparisons of one kind in a frame
  using Difference = s<bits_for(most) + 1>;
  template <int WEIGHT>
  using Balance = s<bits_for((WEIGHT * torn_share + 2) * most) + 1>;

  using Phase = u<std::max(step_log2, 1)>;  // of a column between two that are compared; of a row

  struct Above {
    u<8> one, two, three, four;  // rows above
  };

  static constexpr Phase phase(auto place) {
    if constexpr (step_log2 == 0) {
      return Phase(0);
    } else {
      return place.template bits<step_log2 - 1, 0>();
    }
  }

  // 1: more like `one` than like `other`; -1: the other way round.
  static s<2> likeness(u<8> pixel, u<8> one, u<8> other) {
    const u<9> to_one = abs(s<9>(pixel - one));
    const u<9> to_other = abs(s<9>(pixel - other));
    return to_other > to_one + lit<1>() ? s<2>(1) : to_one > to_other + lit<1>() ? s<2>(-1) : s<2>(0);
  }
  // What it adds to `torn_share` times WEIGHT such differences, less all.
  template <int WEIGHT>
  static auto change(s<2> like) {
    using Change = s<bits_for((WEIGHT < 0 ? -WEIGHT : WEIGHT) * torn_share + 1) + 1>;
    return like == 1 ? Change(WEIGHT * torn_share - 1) : like == -1 ? Change(-WEIGHT * torn_share - 1) : Change(0);
  }

  // Which of two pixels this one is more like, of each kind; 0: it is not asked.
  struct Alike {
    s<2> down, second, along, level;
  };

  // A pixel in a column that is compared down; `left`: the one in the same row that level asks about.
  void compare_down(u<8> pixel, u<8> left, u<column_bits> column, u<3> rows, Alike& like) {
    const Above above = above_.read(column);
    above_.write(column, {pixel, above.one, above.two, above.three});
    if (rows >= 2) like.down = likeness(pixel, above.one, above.two);
    if (rows >= 2) like.level = likeness(pixel, left, above.one);
    if (rows >= 4) like.second = likeness(pixel, above.two, above.four);
  }

  void add(const Alike& like, bool first, Phase y) {
    turn_ = Balance<1>((first ? Balance<1>(0) : turn_) + change<-1>(like.down));
    aside_ = Balance<down_weight + along_weight>((first ? Balance<down_weight + along_weight>(0) : aside_) +
                                                 (change<along_weight>(like.along) + change<-down_weight>(like.down)));
    level_ = Balance<1>((first ? Balance<1>(0) : level_) + change<1>(like.level));
    pair_ = Balance<1>((first ? Balance<1>(0) : pair_) + change<-1>(like.second));
    even_less_odd_ =
        Difference((first ? Difference(0) : even_less_odd_) + (y.bit(0) ? s<3>(-like.down) : s<3>(like.down)));
  }

  void compare_rows(const In& in) {
    const X x = in.first ? X(0) : x_;
    const u<3> rows = in.first ? u<3>(0) : rows_;
    const Phase y = in.first ? Phase(0) : y_;
    Alike like{};
    above_.begin_step();
    if (phase(x) == (1 << step_log2) - 1)
      compare_down(in.pixel, left_[2 * ACROSS - 1], u<column_bits>(shr<step_log2>(x)), rows, like);
    if (phase(x) == phase(y * lit<5>()) && x >= lit<2 * ACROSS>())
      like.along = likeness(in.pixel, left_[ACROSS - 1], left_[2 * ACROSS - 1]);
    add(like, in.first, y);

    for (std::size_t i = 2 * ACROSS - 1; i > 0; --i) left_[i] = left_[i - 1];
    left_[0] = in.pixel;
    x_ = in.last ? X(0) : X(x + lit<1>());
    rows_ = in.last && rows != 4 ? u<3>(rows + lit<1>()) : rows;
    y_ = in.last ? Phase(y + lit<1>()) : y;
  }

#ifndef __HLSC__
  static std::uint32_t shifted(std::uint32_t signature, int pixels) {
    for (int i = 0; i < pixels; ++i) signature = signature >> 1 ^ (signature & 1U ? polynomial : 0U);
    return signature;
  }
  // The signature is linear: of eight pixels it is that of their sum, each shifted to where it will have come to.
  void sign(std::span<const std::uint8_t> pixels) {
    static const auto eight_shifts = [] {
      std::array<std::uint32_t, 256> table{};
      for (std::uint32_t low = 0; low < table.size(); ++low) table[low] = shifted(low, 8);
      return table;
    }();
    std::uint32_t signature = signature_.value();
    std::size_t i = 0;
    for (; i + 8 <= pixels.size(); i += 8) {
      for (std::size_t k = 0; k < 8; ++k) signature ^= std::uint32_t{pixels[i + k]} << (k + 1);
      signature = signature >> 8 ^ eight_shifts[signature & 0xFFU];
    }
    for (; i < pixels.size(); ++i) signature = shifted(signature, 1) ^ pixels[i];
    signature_ = u<32>(signature);
  }
  void measure_levels(std::span<const std::uint8_t> pixels, const Config& config) {
    auto darkest = static_cast<std::uint8_t>(darkest_.value());
    auto brightest = static_cast<std::uint8_t>(brightest_.value());
    const auto dark_level = static_cast<std::uint8_t>(config.dark_level.value());
    const auto bright_level = static_cast<std::uint8_t>(config.bright_level.value());
    std::uint32_t dark = 0;
    std::uint32_t bright = 0;
    for (const std::uint8_t pixel : pixels) {
      darkest = std::min(darkest, pixel);
      brightest = std::max(brightest, pixel);
      dark += pixel <= dark_level ? 1 : 0;
      bright += pixel >= bright_level ? 1 : 0;
    }
    darkest_ = u<8>(darkest);
    brightest_ = u<8>(brightest);
    dark_ = Count(dark_.value() + dark);
    bright_ = Count(bright_.value() + bright);
  }
#endif

  u<32> signature_{0};
  std::array<u<32>, FRAMES> before_{};  // signatures of the frames before, the last one first
  u<FRAMES> frames_{0};                 // bit n: more than n have come
  u<8> repeats_{0};
  u<8> darkest_{0};
  u<8> brightest_{0};
  Count dark_{0};
  Count bright_{0};
  ColumnMemory<Above, 1 << column_bits> above_;
  std::array<u<8>, 2 * ACROSS> left_{};  // pixels to the left, the nearest first
  X x_{0};
  Phase y_{0};
  u<3> rows_{0};  // above this one, at most 4
  Balance<1> turn_{0};
  Balance<down_weight + along_weight> aside_{0};
  Balance<1> level_{0};
  Balance<1> pair_{0};
  Difference even_less_odd_{0};
};

template <Profile P>
using Health = CameraHealth<P.width, P.height, P.subsample, 2 * P.fields_per_image()>;

}  // namespace horopter::stages
