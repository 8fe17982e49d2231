// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/support.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "horopter/hls/area.hpp"
#include "horopter/image/mat.hpp"

namespace horopter {
namespace {

/// 1, or 0.
cv::Mat supervised_in_result(const MapTable& table, const MachineProfile& profile) {
  const Image mask = table.supervised(profile.weight_bits);
  cv::Mat supervised = mat_of(mask).clone();
  if (profile.subsample == 2) {  // a pixel of the result has both
    cv::Mat both;
    cv::resize(supervised, both, {mask.width / 2, mask.height}, 0, 0, cv::INTER_AREA);
    supervised = both == 1;
    supervised &= 1;
  }
  return supervised;
}

/// To both sides of a pixel that the rule judges.
int windows_reach(const MachineProfile& profile, Decision decision) {
  return decision == Decision::compete ? 1 : profile.offset();
}

cv::Mat with_whole_windows(const cv::Mat& supervised, int reach) {
  cv::Mat judgeable;
  cv::erode(supervised, judgeable, cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U), {-1, -1}, 1, cv::BORDER_CONSTANT,
            cv::Scalar(0));
  return judgeable;
}

/// What a pixel of the result counts: 1, or its area in mm² as the machine adds it up.
cv::Mat_<double> pixel_weights(const MapTable& table, cv::Size size, bool in_mm2) {
  constexpr int kSide = 1 << hls::table::area_block_log2;
  cv::Mat_<double> weights(size, 1.0);
  if (!in_mm2) return weights;
  auto code = table.facts().areas.begin();
  for (int y = 0; y < size.height; y += kSide) {
    for (int x = 0; x < size.width; x += kSide) {
      const double steps = hls::area_of(*code++).value();
      weights(cv::Rect(x, y, kSide, kSide) & cv::Rect({0, 0}, size)).setTo(steps / hls::area_steps_per_mm2);
    }
  }
  return weights;
}

/// 0 outside of the mask.
cv::Mat_<double> weighed(const cv::Mat& mask, const cv::Mat_<double>& weights) {
  cv::Mat_<double> counted(weights.size(), 0.0);
  weights.copyTo(counted, mask);
  return counted;
}

/// What an object on the skin is taken for, px of the result.
struct DiscOnSkin {
  cv::Point middle;
  int radius = 0;
  bool is_enough = false;  ///< what it shows

  [[nodiscard]] cv::Rect box(int more = 0) const {
    const int side = 2 * (radius + more) + 1;
    return {middle.x - radius - more, middle.y - radius - more, side, side};
  }
  /// Of a piece. `sums`: integral of what its pixels count.
  [[nodiscard]] double shows(const cv::Mat_<double>& sums, const cv::Rect& piece) const {
    const cv::Rect common = box() & piece;
    double sum = 0;
    for (int y = common.y; y < common.br().y; ++y) {
      const int down = y - middle.y;
      const auto half = static_cast<int>(std::sqrt(radius * radius - down * down));
      const int first = std::max(middle.x - half, piece.x) - piece.x;
      const int end = std::min(middle.x + half + 1, piece.br().x) - piece.x;
      if (first >= end) continue;
      const int row = y - piece.y;
      sum += sums(row + 1, end) - sums(row, end) - sums(row + 1, first) + sums(row, first);
    }
    return sum;
  }
};

}  // namespace

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

double supported_mm2(const MapTable& table, const MachineProfile& profile, Decision decision) {
  const cv::Mat supervised = supervised_in_result(table, profile);
  const cv::Mat judgeable = with_whole_windows(supervised, windows_reach(profile, decision));
  return cv::sum(weighed(judgeable, pixel_weights(table, supervised.size(), true)))[0];
}

double share_beyond_limit(const MapTable& table, const MachineProfile& profile, Decision decision,
                          const ShownLimit& limit) {
  constexpr int kStep_px = 4;
  if (!(limit.least > 0)) return 0;
  const cv::Mat supervised = supervised_in_result(table, profile);
  const cv::Mat_<double> weights = pixel_weights(table, supervised.size(), limit.in_mm2);
  const int reach = windows_reach(profile, decision);
  const cv::Rect image({0, 0}, supervised.size());
  std::vector<DiscOnSkin> discs;
  for (int y = 0; y < supervised.rows; y += kStep_px) {
    for (int x = 0; x < supervised.cols; x += kStep_px) {
      if (supervised.at<std::uint8_t>(y, x) == 0) continue;
      const DiscOnSkin disc{{x, y},
                            static_cast<int>(std::ceil(std::sqrt(2 * limit.least / weights(y, x) / std::numbers::pi)))};
      if (const cv::Rect around = disc.box(reach); (around & image) == around) discs.push_back(disc);
    }
  }
  if (discs.empty()) return 0;

  cv::Mat labels, boxes, centres;
  const int pieces =
      cv::connectedComponentsWithStats(with_whole_windows(supervised, reach), labels, boxes, centres, 8, CV_32S);
  for (int piece = 1; piece < pieces; ++piece) {
    const int* box = boxes.ptr<int>(piece);
    const cv::Rect own(box[cv::CC_STAT_LEFT], box[cv::CC_STAT_TOP], box[cv::CC_STAT_WIDTH], box[cv::CC_STAT_HEIGHT]);
    const cv::Mat mask = labels(own) == piece;
    cv::Mat_<double> sums;
    cv::integral(weighed(mask, weights(own)), sums, CV_64F);
    if (sums(own.height, own.width) < limit.least) continue;
    for (DiscOnSkin& disc : discs) disc.is_enough = disc.is_enough || disc.shows(sums, own) >= limit.least;
  }
  const auto beyond = std::ranges::count(discs, false, &DiscOnSkin::is_enough);
  return static_cast<double>(beyond) / static_cast<double>(discs.size());
}

}  // namespace horopter
