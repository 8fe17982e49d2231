// SPDX-License-Identifier: Apache-2.0
// Results for programs: regions, state pictures, summary.json.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
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
  friend bool operator==(const Region&, const Region&) = default;
};

/// Of pixels in the skin, the largest first. The pixels of all regions together are the skin pixels.
std::vector<Region> regions_of(const Image& states);
/// The same of pixels in the skin and blind ones: the machine's objects (hls/stages/objects.hpp).
std::vector<Region> objects_of(const FrameResult& result);

/// Grey levels of the written state pictures: 0 clear, 255 skin, 128 undecidable, 64 unsupervised.
Image state_picture(const Image& states);

/// One element of `frames` in summary.json. `cycles` only if the engine counts them.
nlohmann::ordered_json frame_json(int frame, const std::string& left, const std::string& right,
                                  const FrameResult& result, bool with_cycles);
nlohmann::ordered_json summary_json(std::string_view engine, std::string_view profile);

}  // namespace horopter
