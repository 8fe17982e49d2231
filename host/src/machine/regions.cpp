// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/regions.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <tuple>
#include <utility>

#include "horopter/hls/area.hpp"
#include "horopter/hls/table_format.hpp"
#include "horopter/image/mat.hpp"

namespace horopter {
namespace {

struct Labelled {
  cv::Mat labels;
  std::vector<std::pair<Region, int>> regions;  ///< with their labels, the largest first
};

/// Of each label, by the areas of the frame's table.
std::vector<std::uint32_t> areas_of(const cv::Mat& labels, int count, const std::vector<std::uint8_t>& codes) {
  constexpr int kBlockLog2 = hls::table::area_block_log2;
  const auto columns = static_cast<std::size_t>(hls::table::Facts::blocks(labels.cols));
  std::vector<std::uint64_t> sums(static_cast<std::size_t>(count));
  for (int y = 0; y < labels.rows; ++y) {
    const int* row = labels.ptr<int>(y);
    const std::size_t first = static_cast<std::size_t>(y >> kBlockLog2) * columns;
    for (int x = 0; x < labels.cols;) {
      const std::size_t block = first + static_cast<std::size_t>(x >> kBlockLog2);
      const std::uint64_t area = hls::area_of(codes.empty() ? hls::table::unknown_area : codes[block]).value();
      for (const int end = std::min(labels.cols, (x | ((1 << kBlockLog2) - 1)) + 1); x < end; ++x) {
        if (row[x] != 0) sums[static_cast<std::size_t>(row[x])] += area;
      }
    }
  }
  std::vector<std::uint32_t> areas;
  areas.reserve(sums.size());
  for (const std::uint64_t sum : sums) {
    areas.push_back(static_cast<std::uint32_t>(std::min<std::uint64_t>(sum, hls::ObjectArea::max().value())));
  }
  return areas;
}

/// Pixels of `mask`, of which those of `blind`, if that is not empty, are counted. `codes`: of the table, where areas are wanted.
Labelled connected(const cv::Mat& mask, const cv::Mat& blind, const std::vector<std::uint8_t>* codes = nullptr) {
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
  std::vector<std::uint32_t> areas(static_cast<std::size_t>(count));
  if (codes != nullptr) areas = areas_of(found.labels, count, *codes);
  for (int i = 1; i < count; ++i) {
    const int* row = stats.ptr<int>(i);
    const Region region{row[cv::CC_STAT_LEFT],
                        row[cv::CC_STAT_TOP],
                        row[cv::CC_STAT_WIDTH],
                        row[cv::CC_STAT_HEIGHT],
                        row[cv::CC_STAT_AREA],
                        centroids.at<double>(i, 0),
                        centroids.at<double>(i, 1),
                        blind_pixels[static_cast<std::size_t>(i)],
                        areas[static_cast<std::size_t>(i)]};
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

cv::Mat in_skin(const Image& states) { return mat_of(states) == static_cast<int>(State::skin); }

Labelled occupied(const FrameResult& result) {
  const std::vector<std::uint8_t>* codes = result.object_area_limit != 0 ? &result.areas : nullptr;
  if (result.blind.empty()) return connected(in_skin(result.states), {}, codes);
  const cv::Mat blind(result.states.height, result.states.width, CV_8UC1,
                      const_cast<std::uint8_t*>(result.blind.data()));
  return connected(in_skin(result.states) | (blind != 0), blind, codes);
}

}  // namespace

std::vector<Region> regions_of(const Image& states) { return without_labels(connected(in_skin(states), {})); }

std::vector<Region> objects_of(const FrameResult& result) { return without_labels(occupied(result)); }

bool is_alarm(const Region& object, const FrameResult& result) {
  if (result.object_area_limit != 0) return object.area >= result.object_area_limit;
  return result.object_limit_pixels > 0 && object.pixels >= result.object_limit_pixels;
}

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
