// SPDX-License-Identifier: Apache-2.0
// Where a skin ends in the image: the spans of a table's rows (hls/table_format.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "horopter/hls/table_format.hpp"
#include "horopter/image/scan.hpp"
#include "horopter/skin/rig_skin.hpp"
#include "horopter/skin/skin.hpp"

namespace horopter {

struct LookLattice;

/// Of each row of a scan the pixels that are on the skin and within the limits of the view: of several runs the longest, or
/// the one that goes on from row to row.
struct Outline {
  std::vector<hls::table::Span> spans;
  /// Of pixels x, x + 1, … of a row in the scan's coordinates; NaN where they must not be supervised. As long as what the
  /// outline was made of lives.
  std::function<void(int x, int y, std::span<Point> sources)> see;

  const hls::table::Span& span(int row) const { return spans[static_cast<std::size_t>(row)]; }
  Point source(int x, int y) const {
    Point point;
    see(x, y, {&point, 1});
    return point;
  }
};

/// From a lattice of all pixels; nothing where no row has an end in the image, or no pixel is on the skin.
std::optional<Outline> outline_of(const LookLattice& lattice, const ScanGeometry& geometry);

/// Follows the outlines of surfaces that move while the cameras stand, pixel by pixel from row to row. It looks at blocks
/// of pixels, once at each of those that it needs. Lines of sight are kept.
class OutlineTracer {
 public:
  OutlineTracer(const CameraPair& cameras, const ScanGeometry& geometry, const ViewLimits& view);
  /// `coarse`, what every 2^n-th pixel sees, says where to begin; nothing where all or none of that is on the skin. Pixels
  /// between both ends of a span are not looked at.
  /// The outline lives as long as the tracer, the cameras and the surface, and until the next one is traced.
  std::optional<Outline> trace(const CameraPair& cameras, const Surface& surface, const LookLattice& coarse);

 private:
  static constexpr int kWidth = calib::PixelBatch::kRun;  ///< of a block, px
  static constexpr int kHeight = 4;
  static constexpr std::size_t kMostRays = std::size_t{1} << 19;  ///< kept: 60 MB
  using Sources = std::array<Point, kWidth * kHeight>;            ///< NaN where a pixel must not be supervised
  struct Block {
    std::int32_t first_ray = -1;  ///< -1 where there are none yet
    std::int32_t seen = -1;       ///< where it is in seen_; -1 where it was not looked at
  };
  /// Of the pixel's block, from the pixel on those of its row.
  std::span<const Point> look(const CameraPair& cameras, const Surface& surface, int x, int y);
  std::size_t rays_of(const CameraPair& cameras, int column, int row);

  ScanGeometry geometry_;
  ViewLimits view_;
  int columns_;                ///< blocks in a row
  std::vector<Block> blocks_;  ///< row by row
  std::vector<Sources> seen_;  ///< of the surface at hand
  Rays rays_;
};

}  // namespace horopter
