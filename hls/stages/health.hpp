// SPDX-License-Identifier: Apache-2.0
// health: can this camera's image be an image (thesis 2.3)? One instance per camera, on the pixels as they arrive.
//
// In      pixel; first, end: the frame's first and last pixel; last: a row's last pixel.
// Config  dark_level, bright_level: grey levels at or below (at or above) which a pixel is black (white);
//         dark_limit, bright_limit: pixels; contrast_limit: grey levels; frozen_limit: repetitions, 0 switches it off.
// Out     one beat per frame, with its last pixel:
//         black, white: more than the limit of pixels are; constant: the frame's grey levels span at most
//         contrast_limit, and it is neither black nor white; frozen: its signature has equalled that of the frame
//         before, for at least frozen_limit frames in a row; signature: the frame's. The signature is that of a
//         multiple-input shift register (MISR; Williams, Daehn, Gruetzner, Starke, IEEE Trans. CAD 7(2), 1988) with the
//         polynomial of CRC-32: equal frames have equal ones, and two noisy frames by chance once in 2^32.
//         torn: its rows are of two moments in turn, as of an interlaced image of what moves. A pixel of a scene is more
//         like the one above it than like the one above that. Here it is the other way round, in some columns of the
//         frame, more than 17/15 times as often, and by more than 48 pixels. The count asks only which of the two is
//         nearer, by 2 grey levels or more, so contrast hardly matters, and noise alone makes both alike.
// Memory: the two rows above, in these columns. Rows of at least hls::min_row_beats.
// Illegal use: a frame without `end` is not judged; the next `first` starts anew.
#pragma once

#include "horopter/hls/line_buffer.hpp"
#include "stages/stream.hpp"

namespace horopter::stages {

template <int WIDTH, int HEIGHT>
class CameraHealth {
  static constexpr int step_log2 = WIDTH <= 64 ? 0 : bits_for((WIDTH - 1) / 64);  // between columns, at most 64 of them
  static constexpr int column_bits = bits_for((WIDTH - 1) >> step_log2);
  static constexpr int torn_share = 16;  // so many times what is torn less what is not, above all of it
  static constexpr int torn_pixels = 48;

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

  Out step(const In& in, const Config& config) {
    if (in.first) [[unlikely]]
      signature_ = u<32>(0);
    signature_ = shr<1>(signature_) ^ (signature_.bit(0) ? u<32>(0xEDB88320U) : u<32>(0)) ^ in.pixel;
    if (in.first || in.pixel < darkest_) darkest_ = in.pixel;
    if (in.first || in.pixel > brightest_) brightest_ = in.pixel;
    count(dark_, in.first, in.pixel <= config.dark_level);
    count(bright_, in.first, in.pixel >= config.bright_level);
    compare_rows(in);

    Out out;
    out.valid = in.end;
    if (in.end) [[unlikely]] {
      const bool same = has_previous_ && signature_ == previous_signature_;
      repeats_ = !same ? u<8>(0) : repeats_ == 255 ? repeats_ : u<8>(repeats_ + lit<1>());
      previous_signature_ = signature_;
      has_previous_ = true;
      out.black = dark_ > config.dark_limit;
      out.white = bright_ > config.bright_limit;
      out.constant = u<8>(brightest_ - darkest_) <= config.contrast_limit && !out.black && !out.white;
      out.frozen = config.frozen_limit != 0 && repeats_ >= config.frozen_limit;
      out.torn = torn_ > lit<torn_pixels * torn_share>();
    }
    out.signature = previous_signature_;
    return out;
  }

 private:
  using X = u<bits_for(WIDTH - 1)>;
  using Balance = s<bits_for((torn_share + 1) * HEIGHT << column_bits) + 1>;

  struct Above {
    u<8> one;
    u<8> two;  // rows above
  };

  void compare_rows(const In& in) {
    const X x = in.first ? X(0) : x_;
    const u<2> rows = in.first ? u<2>(0) : rows_;
    const u<column_bits> column(shr<step_log2>(x));
    s<6> change(0);
    above_.begin_step();
    if (compares(x)) {
      const Above above = above_.read(column);
      above_.write(column, {in.pixel, above.one});
      const u<9> to_one = abs(s<9>(in.pixel - above.one));
      const u<9> to_two = abs(s<9>(in.pixel - above.two));
      if (rows.bit(1) && to_one > to_two + lit<1>()) change = s<6>(torn_share - 1);
      if (rows.bit(1) && to_two > to_one + lit<1>()) change = s<6>(-torn_share - 1);
    }
    torn_ = Balance((in.first ? Balance(0) : torn_) + change);
    x_ = in.last ? X(0) : X(x + lit<1>());
    rows_ = in.last && !rows.bit(1) ? u<2>(rows + lit<1>()) : rows;
  }

  static constexpr bool compares(X x) {
    if constexpr (step_log2 == 0) {
      return true;
    } else {
      return x.template bits<step_log2 - 1, 0>() == (1 << step_log2) - 1;
    }
  }

  u<32> signature_{0};
  u<32> previous_signature_{0};
  bool has_previous_ = false;
  u<8> repeats_{0};
  u<8> darkest_{0};
  u<8> brightest_{0};
  Count dark_{0};
  Count bright_{0};
  ColumnMemory<Above, 1 << column_bits> above_;
  X x_{0};
  u<2> rows_{0};  // above this one, at most 2
  Balance torn_{0};
};

template <Profile P>
using Health = CameraHealth<P.width, P.height>;

}  // namespace horopter::stages
