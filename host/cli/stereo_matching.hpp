// SPDX-License-Identifier: Apache-2.0
// OpenCV's two stereo matchers as a yardstick, one thread each. All columns are answered.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "horopter/image/evaluation.hpp"
#include "horopter/image/image.hpp"

namespace horopter::cli {

struct Matching {
  std::vector<float> disparity_px;  ///< of each left pixel; NaN where the matcher finds none
  double seconds = 0;               ///< the fastest of `runs`
  nlohmann::json parameters;        ///< all of them, by OpenCV's names
};

/// `largest_px`: disparities from 0 to at least this are searched.
Matching match_bm(const Image& left, const Image& right, double largest_px, int runs);
Matching match_sgbm(const Image& left, const Image& right, double largest_px, int runs);

/// Which pixels lie within the tolerance of a disparity.
std::vector<Answer> answers_of(const Matching& matching, double disparity_px, double tolerance_px);

}  // namespace horopter::cli
