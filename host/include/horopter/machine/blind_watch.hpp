// SPDX-License-Identifier: Apache-2.0
// What became blind, worked out from the states: the machine's stage `blind` (hls/stages/blind.hpp) says how many pixels
// those are, and not which.
#pragma once

#include <cstdint>
#include <vector>

#include "horopter/image/image.hpp"

namespace horopter {

/// The register BLOCKS.
struct BlindSettings {
  bool watch = false;  ///< undecidable pixels of blind blocks count as pixels of an object
  bool teach = false;  ///< learn what cannot be decided; every frame has the fault `teaching`
  int margin = 8;      ///< 1/64 of a block's pixels, 0 to kLargestMargin
  bool dim = false;    ///< half of the frames that teach are looked at as half of the light would show them

  /// With more, no block could be blind.
  static constexpr int kLargestMargin = 63;
  /// The margin of a block of this side.
  constexpr int margin_pixels(int side) const { return margin * side * side / 64; }
};

class BlindWatch {
 public:
  struct Block {
    int x = 0, y = 0, width = 0, height = 0;  ///< px of the result
    int most_undecidable = 0;                 ///< of a frame that was taught
  };

  /// `side` of a block: hls::Profile::cell(). What remains at the right edge belongs to the last block of its row.
  BlindWatch(int width, int height, int side);

  /// The next frame's states, in the order in which the machine had them. Of each pixel: 1 = it is blind. Empty where
  /// none can be. A frame that teaches and is `spoiled`, by a fault other than `teaching` or by an alarm, makes forget all that
  /// was taught. So do the two after one that `spoils` them: their pixels are judged by what both cameras saw of it.
  std::vector<std::uint8_t> frame(const Image& states, const BlindSettings& settings, bool spoiled = false,
                                  bool spoils = false);

  int side() const { return side_; }  ///< of a block
  /// Frames that were taught, since it was begun anew or forgotten.
  int taught() const { return taught_; }
  /// Row by row, with what was taught.
  const std::vector<Block>& blocks() const { return blocks_; }

 private:
  int side_;
  std::vector<Block> blocks_;
  int taught_ = 0;
  bool teaching_ = false;
  unsigned spoiled_before_ = 0;  // bit n: by the frame n + 1 before this one
};

}  // namespace horopter
