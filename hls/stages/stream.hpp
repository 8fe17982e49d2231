// SPDX-License-Identifier: Apache-2.0
// What the stages' streams have in common.
//
// Stages run in the order of stage_list.def. A frame is height + flush_rows rows of beats, whole rows, no other frame
// between them; flush rows carry no pixels (mask 0). Images lie in arrays: [0] the left image, [1] the right image as
// seen through the mapping table.
#pragma once

#include <array>
#include <type_traits>

#include "horopter/hls/int.hpp"
#include "horopter/hls/line_buffer.hpp"
#include "horopter/hls/profiles.hpp"
#include "horopter/hls/window.hpp"

namespace horopter::stages {

using namespace horopter::hls;  // NOLINT: the vocabulary of every stage

/// Frame marks of a beat.
struct FrameMarks {
  bool first = false;  // first beat of a frame
  bool last = false;   // last beat of a row, of flush rows too
};

/// The same from `agreement` on, and what that knows of the pixel of the result that leaves `align` with this beat.
struct Marks {
  bool first = false;
  bool last = false;
  bool seen = false;    // both cameras have been shown to see its place
  bool nearer = false;  // and what they see there is nearer than the skin
};

/// Frame marks where the store still has to tell pixels from flush rows.
struct RasterMarks {
  bool first = false;
  bool last = false;
  bool live = false;  // a pixel of the frame; false in flush rows
};

/// State of a pixel of the result, the strongest has the largest code.
namespace state {
inline constexpr int clear = 0;         // decidable and not in the skin
inline constexpr int skin = 1;          // in the skin
inline constexpr int undecidable = 2;   // no texture to decide by
inline constexpr int unsupervised = 3;  // a pixel of its support is missing
}  // namespace state

/// One more in `counter` if `one`; `restart` counts from zero on. The choice stands before the adder, whose carry cells
/// can take it in (scripts/ecp5.py).
template <int BITS>
constexpr void count(u<BITS>& counter, bool restart, bool one) {
  counter = u<BITS>((restart ? u<BITS>(0) : counter) + u<1>(one));
}

/// Grey values of LANES images, from `agreement` on. Two images packed into one stream have LANES = 1, STRIDE = 2.
template <int LANES, class V = Scalar>
struct Grey {
  std::array<typename V::template u<8>, LANES> pixel{};
  typename V::bit saturated = false;  // carries no information: black or white to the limit in one of the images
  typename V::bit mask = false;       // both images exist here, and the skin
  Marks marks;
};

/// The same up to `agreement`.
template <int LANES>
struct Transformed {
  std::array<u<8>, static_cast<std::size_t>(LANES)> pixel{};
  bool saturated = false;
  bool mask = false;     // both images exist here, and the skin
  bool present = false;  // both images exist here: around the skin, too
  FrameMarks marks;
};
using GreyPair = Transformed<2>;

}  // namespace horopter::stages
