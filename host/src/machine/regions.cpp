// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/regions.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <tuple>
#include <utility>

namespace horopter {
namespace {

struct Labelled {
  cv::Mat labels;
  std::vector<std::pair<Region, int>> regions;  ///< with their labels, the largest first
};

/// Pixels of `mask`, of which those of `blind`, if that is not empty, are counted.
Labelled connected(const cv::Mat& mask, const cv::Mat& blind) {
  Labelled found;
  cv::Mat stats;
  cv::Mat centroids;
  const int count = cv::connectedComponentsWithStats(mask, found.labels, stats, centroids, 8);
  std::vector<std::int64_t> blind_pixels(static_cast<std::size_t>(count));
  if (!blind.empty()) {
    for (int y = 0; y < mask.rows; ++y) {
      for (int x = 0; x < mask.cols; ++x) {
        if (blind.at<std::uint8_t>(y, x) != 0) ++blind_pixels[static_cast<std::size_t>(found.labels.at<int>(y, x))];
      }
    }
  }
  for (int i = 1; i < count; ++i) {
    const int* row = stats.ptr<int>(i);
    const Region region{row[cv::CC_STAT_LEFT],      row[cv::CC_STAT_TOP],
                        row[cv::CC_STAT_WIDTH],     row[cv::CC_STAT_HEIGHT],
                        row[cv::CC_STAT_AREA],      centroids.at<double>(i, 0),
                        centroids.at<double>(i, 1), blind_pixels[static_cast<std::size_t>(i)]};
    found.regions.emplace_back(region, i);
  }
  std::ranges::sort(found.regions, {}, [](const auto& r) { return std::tuple(-r.first.pixels, r.first.y, r.first.x); });
  return found;
}

std::vector<Region> without_labels(const Labelled& found) {
  std::vector<Region> regions;
  regions.reserve(found.regions.size());
  for (const auto& [region, label] : found.regions) regions.push_back(region);
  return regions;
}

cv::Mat in_skin(const Image& states) {
  const cv::Mat codes(states.height, states.width, CV_8UC1, const_cast<std::uint8_t*>(states.pixels.data()));
  return codes == static_cast<int>(State::skin);
}

Labelled occupied(const FrameResult& result) {
  if (result.blind.empty()) return connected(in_skin(result.states), {});
  const cv::Mat blind(result.states.height, result.states.width, CV_8UC1,
                      const_cast<std::uint8_t*>(result.blind.data()));
  return connected(in_skin(result.states) | (blind != 0), blind);
}

}  // namespace

std::vector<Region> regions_of(const Image& states) { return without_labels(connected(in_skin(states), {})); }

std::vector<Region> objects_of(const FrameResult& result) { return without_labels(occupied(result)); }

std::vector<ObjectPixels> object_pixels(const FrameResult& result, std::int64_t smallest_pixels, std::size_t most) {
  const Labelled found = occupied(result);
  std::vector<ObjectPixels> objects;
  for (const auto& [region, label] : found.regions) {
    if (region.pixels < smallest_pixels || objects.size() == most) break;
    ObjectPixels object{region, {}};
    for (int y = region.y; y < region.y + region.height; ++y) {
      const int* labels = found.labels.ptr<int>(y);
      const int end = region.x + region.width;
      for (int x = region.x; x < end; ++x) {
        if (labels[x] != label) continue;
        const int first = x;
        while (x + 1 < end && labels[x + 1] == label) ++x;
        object.runs.push_back({y, first, x});
      }
    }
    objects.push_back(std::move(object));
  }
  return objects;
}

}  // namespace horopter
