// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/support.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "horopter/image/mat.hpp"

namespace horopter {

std::int64_t supported_pixels(const MapTable& table, Decision decision) {
  const hls::table::Facts& facts = table.facts();
  return decision == Decision::compete ? facts.judgeable_by_compete : facts.judgeable_by_thesis;
}

double compared_share(const MapTable& table, const MachineProfile& profile, int lookahead) {
  constexpr int kStep_px = 4;
  std::int64_t compared = 0;
  std::int64_t pixels = 0;
  for (int y = 0; y < table.geometry().height; y += kStep_px) {
    for (int x = 0; x < table.geometry().width; x += kStep_px) {
      ++pixels;
      const auto expanded = table.expand_around(x, y);
      if (!expanded || !table.round(*expanded, profile.weight_bits)) continue;
      const auto row = static_cast<int>(expanded->y >> MapTable::kFractionBits);
      compared += row >= y - profile.rows_behind() && row < y + lookahead ? 1 : 0;
    }
  }
  return static_cast<double>(compared) / static_cast<double>(pixels);
}

std::uint32_t limit_of(double percent, double of) {
  return static_cast<std::uint32_t>(std::max(0.0, std::floor(percent * of / 100 + 1e-9)));
}

double share_beyond_limit(const MapTable& table, const MachineProfile& profile, Decision decision,
                          std::int64_t limit_px) {
  const Image mask = table.supervised(profile.weight_bits);
  cv::Mat supervised = mat_of(mask).clone();
  if (profile.subsample == 2) {  // a pixel of the result has both
    cv::Mat both;
    cv::resize(supervised, both, {mask.width / 2, mask.height}, 0, 0, cv::INTER_AREA);
    supervised = both == 1;
    supervised &= 1;
  }
  if (limit_px <= 0) return 0;
  const int reach = decision == Decision::compete ? 1 : profile.offset();
  const auto radius = static_cast<int>(std::ceil(std::sqrt(2.0 * static_cast<double>(limit_px) / std::numbers::pi)));
  const int border = radius + reach;
  const cv::Rect inner = cv::Rect(border, border, supervised.cols - 2 * border, supervised.rows - 2 * border);
  if (inner.width <= 0 || inner.height <= 0) return 0;
  const int all = cv::countNonZero(supervised(inner));
  if (all == 0) return 0;
  cv::Mat judgeable;
  cv::erode(supervised, judgeable, cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U), {-1, -1}, 1, cv::BORDER_CONSTANT,
            cv::Scalar(0));
  cv::Mat disc = cv::Mat::zeros(2 * radius + 1, 2 * radius + 1, CV_32F);
  cv::circle(disc, {radius, radius}, radius, cv::Scalar(1), cv::FILLED);

  cv::Mat labels, boxes, centres;
  const int pieces = cv::connectedComponentsWithStats(judgeable, labels, boxes, centres, 8, CV_32S);
  cv::Mat seen = cv::Mat::zeros(supervised.size(), CV_8U);
  for (int piece = 1; piece < pieces; ++piece) {
    const int* box = boxes.ptr<int>(piece);
    if (box[cv::CC_STAT_AREA] < limit_px) continue;
    const cv::Rect around = cv::Rect(box[cv::CC_STAT_LEFT] - radius, box[cv::CC_STAT_TOP] - radius,
                                     box[cv::CC_STAT_WIDTH] + 2 * radius, box[cv::CC_STAT_HEIGHT] + 2 * radius) &
                            cv::Rect({0, 0}, supervised.size());
    cv::Mat shown;
    cv::Mat own = labels(around) == piece;
    cv::filter2D(own / 255, shown, CV_32F, disc, {-1, -1}, 0, cv::BORDER_CONSTANT | cv::BORDER_ISOLATED);
    cv::Mat enough = shown > static_cast<double>(limit_px) - 0.5;
    seen(around) |= enough;
  }
  const cv::Mat both = seen(inner) & (supervised(inner) * 255);
  return 1 - static_cast<double>(cv::countNonZero(both)) / all;
}

}  // namespace horopter
