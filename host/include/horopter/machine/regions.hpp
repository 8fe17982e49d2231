// SPDX-License-Identifier: Apache-2.0
// Connected groups of pixels in a frame's result.
#pragma once

#include <cstdint>
#include <vector>

#include "horopter/image/image.hpp"
#include "horopter/machine/monitor.hpp"

namespace horopter {

/// A connected group of pixels (also diagonally connected).
struct Region {
  int x = 0;  ///< of the box around it: left column, upper row
  int y = 0;
  int width = 0;
  int height = 0;
  std::int64_t pixels = 0;
  double centroid_x = 0;
  double centroid_y = 0;
  std::int64_t blind_pixels = 0;  ///< of `pixels`
  /// That they cover of the skin as the machine says it, 1/1024 mm² (horopter/hls/area.hpp); 0 where the frame has no limit of
  /// areas.
  std::uint32_t area = 0;
  friend bool operator==(const Region&, const Region&) = default;
};

/// Of pixels in the skin, the largest first. The pixels of all regions together are the skin pixels.
std::vector<Region> regions_of(const Image& states);
/// The same of pixels in the skin and blind ones: the machine's objects (hls/stages/objects.hpp).
std::vector<Region> objects_of(const FrameResult& result);
/// Whether one of these is an alarm.
bool is_alarm(const Region& object, const FrameResult& result);

/// Pixels of a row that belong together, ends included.
struct PixelRun {
  int row = 0;
  int first = 0;
  int last = 0;
};
/// As objects_of, the `most` largest of at least so many pixels, each with all of its pixels.
struct ObjectPixels {
  Region region;
  std::vector<PixelRun> runs;
};
std::vector<ObjectPixels> object_pixels(const FrameResult& result, std::int64_t smallest_pixels, std::size_t most);

}  // namespace horopter
