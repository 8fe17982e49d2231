// SPDX-License-Identifier: Apache-2.0
#include "horopter/image/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace horopter {
namespace {

constexpr double kSmallestObject = 0.002;
constexpr double kFoundShare = 0.3;
constexpr double kTrueShare = 0.1;

double ratio_of(std::int64_t part, std::int64_t all) {
  return all == 0 ? 1 : static_cast<double>(part) / static_cast<double>(all);
}

/// For each large region of `mask`: its pixels, and how many of them are in `covered`.
std::vector<std::pair<int, int>> large_regions(const cv::Mat& mask, const cv::Mat& covered) {
  cv::Mat labels;
  cv::Mat stats;
  cv::Mat centroids;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centroids, 8);
  std::vector<int> in(static_cast<std::size_t>(count));
  for (int y = 0; y < mask.rows; ++y) {
    const int* label = labels.ptr<int>(y);
    const std::uint8_t* other = covered.ptr<std::uint8_t>(y);
    for (int x = 0; x < mask.cols; ++x) in[static_cast<std::size_t>(label[x])] += other[x] != 0 ? 1 : 0;
  }
  std::vector<std::pair<int, int>> regions;
  const double smallest = kSmallestObject * static_cast<double>(mask.total());
  for (int i = 1; i < count; ++i) {
    const int pixels = stats.at<int>(i, cv::CC_STAT_AREA);
    if (pixels >= smallest) regions.emplace_back(pixels, in[static_cast<std::size_t>(i)]);
  }
  return regions;
}

}  // namespace

GroundTruth::GroundTruth(DisparityMap map, const std::vector<std::uint8_t>& seen)
    : map_(std::move(map)), counts_(map_.px.size()) {
  for (const float d : map_.px) {
    if (!std::isnan(d)) largest_px_ = std::max(largest_px_, static_cast<double>(d));
  }
  const int reach = static_cast<int>(std::ceil(largest_px_)) + 1;
  for (int y = 0; y < map_.height; ++y) {
    // The nearest disparity that lands on each right column; columns left of the image too.
    std::vector<float> nearest(static_cast<std::size_t>(map_.width + reach), -1);
    const auto landing = [&](int x, float d) -> float& {
      return nearest[static_cast<std::size_t>(std::lround(static_cast<float>(x) - d) + reach)];
    };
    for (int x = 0; x < map_.width; ++x) {
      const float d = map_.at(x, y);
      if (!std::isnan(d)) landing(x, d) = std::max(landing(x, d), d);
    }
    for (int x = 0; x < map_.width; ++x) {
      const float d = map_.at(x, y);
      const auto pixel = static_cast<std::size_t>(y) * map_.width + x;
      if (std::isnan(d) || x < largest_px_ + kMargin_px || landing(x, d) > d + 1) continue;
      if (!seen.empty() && seen[pixel] == 0) continue;
      counts_[pixel] = 1;
      ++counted_;
    }
  }
}

std::vector<double> GroundTruth::frequent(int count, double apart_px) const {
  std::map<long, std::int64_t> histogram;
  for (std::size_t i = 0; i < map_.px.size(); ++i) {
    if (counts(i)) ++histogram[std::lround(map_.px[i])];
  }
  std::vector<std::pair<long, std::int64_t>> by_frequency(histogram.begin(), histogram.end());
  std::ranges::sort(by_frequency, {}, [](const auto& entry) { return std::pair(-entry.second, entry.first); });
  std::vector<double> chosen;
  for (const auto& [d, pixels] : by_frequency) {
    const auto candidate = static_cast<double>(d);
    if (std::ranges::all_of(chosen, [&](double c) { return std::abs(c - candidate) >= apart_px; })) {
      chosen.push_back(candidate);
    }
    if (std::cmp_equal(chosen.size(), count)) break;
  }
  return chosen;
}

double Score::precision() const { return ratio_of(hits, hits + wrong); }
double Score::recall() const { return ratio_of(hits, hits + missed); }
double Score::iou() const { return ratio_of(hits, hits + wrong + missed); }
double Score::undecidable_share() const { return counted == 0 ? 0 : ratio_of(undecidable, counted); }
double Score::called_clear_share() const {
  const std::int64_t inside = hits + missed;
  return inside == 0 ? 0 : ratio_of(called_clear, inside);
}

Score score(const GroundTruth& truth, double disparity_px, double tolerance_px, const std::vector<Answer>& answers) {
  Score result;
  cv::Mat in_skin = cv::Mat::zeros(truth.height(), truth.width(), CV_8UC1);
  cv::Mat near_skin = in_skin.clone();
  cv::Mat answered = in_skin.clone();
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (!truth.counts(i)) continue;
    const double distance = std::abs(static_cast<double>(truth.disparities().px[i]) - disparity_px);
    const bool inside = distance <= tolerance_px;
    const bool skin = answers[i] == Answer::skin;
    in_skin.data[i] = inside ? 1 : 0;
    near_skin.data[i] = distance <= tolerance_px + 1 ? 1 : 0;
    answered.data[i] = skin ? 1 : 0;
    ++result.counted;
    result.hits += skin && inside ? 1 : 0;
    result.wrong += skin && !inside ? 1 : 0;
    result.missed += !skin && inside ? 1 : 0;
    result.called_clear += inside && answers[i] == Answer::clear ? 1 : 0;
    result.undecidable += answers[i] == Answer::undecidable ? 1 : 0;
  }
  for (const auto& [pixels, covered] : large_regions(in_skin, answered)) {
    ++result.objects;
    result.found += covered >= kFoundShare * pixels ? 1 : 0;
  }
  for (const auto& [pixels, correct] : large_regions(answered, near_skin)) {
    result.false_objects += correct < kTrueShare * pixels ? 1 : 0;
  }
  return result;
}

}  // namespace horopter
