// SPDX-License-Identifier: Apache-2.0
// "Which pixels lie within ±t px of disparity d0?" against ground truth: which pixels count, and how answers score.
#pragma once

#include <cstdint>
#include <vector>

#include "horopter/image/disparity.hpp"

namespace horopter {

/// What a method says about a pixel.
enum class Answer : std::uint8_t { clear, skin, undecidable };

/// Ground truth and the pixels of it that count: known, x ≥ largest disparity + `kMargin_px`, and visible in the right
/// image: no pixel of the same row nearer by more than 1 px lands on the same right column, and the mask says so, too.
class GroundTruth {
 public:
  static constexpr int kMargin_px = 8;

  /// `seen`: not 0 for pixels that both cameras see, row by row; empty: nothing is known of that.
  explicit GroundTruth(DisparityMap map, const std::vector<std::uint8_t>& seen = {});
  int width() const { return map_.width; }
  int height() const { return map_.height; }
  const DisparityMap& disparities() const { return map_; }
  double largest_px() const { return largest_px_; }
  bool counts(std::size_t pixel) const { return counts_[pixel] != 0; }
  std::int64_t counted() const { return counted_; }

  /// Up to `count` of the most frequent disparities of pixels that count, in whole px, at least `apart_px` apart; the
  /// most frequent first.
  std::vector<double> frequent(int count = 6, double apart_px = 3) const;

 private:
  DisparityMap map_;
  double largest_px_ = 0;
  std::vector<char> counts_;
  std::int64_t counted_ = 0;
};

/// Counts over one frame. An object is an 8-connected region of pixels that count and lie in the
/// skin, of at least 0.2 % of the image; it is found where at least 30 % of it is answered `skin`. A false object is a
/// region of such answers, of that size, less than 10 % of which is within tolerance + 1 px.
struct Score {
  std::int64_t hits = 0;          ///< answered skin and within the tolerance
  std::int64_t wrong = 0;         ///< answered skin, elsewhere
  std::int64_t missed = 0;        ///< not answered skin though within the tolerance
  std::int64_t called_clear = 0;  ///< of the missed, those answered clear: the dangerous ones
  std::int64_t undecidable = 0;
  std::int64_t counted = 0;
  int objects = 0;
  int found = 0;
  int false_objects = 0;

  // 1 where there is nothing to be wrong about.
  double precision() const;
  double recall() const;
  double iou() const;
  // 0 where there is nothing.
  double undecidable_share() const;
  double called_clear_share() const;  ///< of the pixels within the tolerance
};

/// `answers`: one for each pixel of the truth.
Score score(const GroundTruth& truth, double disparity_px, double tolerance_px, const std::vector<Answer>& answers);

}  // namespace horopter
