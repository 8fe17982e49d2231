// SPDX-License-Identifier: Apache-2.0
// What the machine shows of a chessboard: the hull of its inner corners.
#pragma once

#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "horopter/image/image.hpp"
#include "horopter/machine/device.hpp"

namespace horopter::cli {

struct BoardPixels {
  std::int64_t board = 0;  ///< pixels
  std::int64_t decidable = 0;
  std::int64_t in_skin = 0;
  double decidable_share() const {
    return board == 0 ? 0 : static_cast<double>(decidable) / static_cast<double>(board);
  }
  /// Of the decidable ones.
  double skin_share() const {
    return decidable == 0 ? 0 : static_cast<double>(in_skin) / static_cast<double>(decidable);
  }
  /// Of all of the board's.
  double skin_of_all() const { return board == 0 ? 0 : static_cast<double>(in_skin) / static_cast<double>(board); }
};

/// Of a board with these corners, in any order, in pixels of the states.
inline BoardPixels count_board(const std::vector<cv::Point2d>& corners, const Image& states) {
  std::vector<cv::Point> rounded;
  for (const auto& corner : corners) rounded.emplace_back(cvRound(corner.x), cvRound(corner.y));
  std::vector<cv::Point> hull;
  cv::convexHull(rounded, hull);
  cv::Mat mask = cv::Mat::zeros(states.height, states.width, CV_8UC1);
  cv::fillConvexPoly(mask, hull, 255);
  BoardPixels pixels;
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if (mask.at<std::uint8_t>(y, x) == 0) continue;
      const auto state = static_cast<State>(states.at(x, y));
      ++pixels.board;
      pixels.decidable += state == State::skin || state == State::clear ? 1 : 0;
      pixels.in_skin += state == State::skin ? 1 : 0;
    }
  }
  return pixels;
}

}  // namespace horopter::cli
