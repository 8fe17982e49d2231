// SPDX-License-Identifier: Apache-2.0
// Where a skin ends in the image: the spans of a table's rows (hls/table_format.hpp), and control points beyond that end.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "horopter/hls/table_format.hpp"
#include "horopter/image/scan.hpp"
#include "horopter/skin/rig_skin.hpp"
#include "horopter/skin/skin.hpp"

namespace horopter {

struct LookLattice;

/// Never supervised, wherever the source lies.
constexpr bool is_excluded(Reason reason) { return reason != Reason::none && reason != Reason::outside; }

/// Of each row of a scan the pixels that are on the skin and within the limits of the view: of several runs the longest, or
/// the one that goes on from row to row.
struct Outline {
  std::vector<hls::table::Span> spans;
  /// Sources of the first and the last pixel of each span, in the scan's coordinates; NaN of an empty one.
  std::vector<std::pair<Point, Point>> ends;

  const hls::table::Span& span(int row) const { return spans[static_cast<std::size_t>(row)]; }
};

/// From a lattice of all pixels; nothing where no row has an end in the image, or no pixel is on the skin.
std::optional<Outline> outline_of(const LookLattice& lattice, const ScanGeometry& geometry);

/// Follows the outlines of surfaces that move while the cameras stand, pixel by pixel from row to row. Lines of sight are
/// kept.
class OutlineTracer {
 public:
  OutlineTracer(const CameraPair& cameras, const ScanGeometry& geometry, const ViewLimits& view);
  /// `coarse`, what every 2^n-th pixel sees, says where to begin; nothing where all or none of that is on the skin. Pixels
  /// between both ends of a span are not looked at.
  std::optional<Outline> trace(const CameraPair& cameras, const Surface& surface, const LookLattice& coarse);

 private:
  static constexpr int kSide = 8;                            ///< pixels of a row that are looked at together
  static constexpr std::size_t kMostRays = std::size_t{1} << 19;  ///< kept: 60 MB
  struct Seen;
  std::size_t rays_of(const CameraPair& cameras, int part, int y);

  ScanGeometry geometry_;
  ViewLimits view_;
  int parts_;                          ///< of a row
  std::vector<std::int32_t> first_ray_;  ///< of each part of each row; -1 where there are none yet
  Rays rays_;
};

/// Least squares of control points that are on no skin from what is seen beside them.
class ControlFit {
 public:
  /// Four control points, how much each counts, and the source that they must make together.
  struct Equation {
    std::array<std::size_t, 4> at;
    std::array<double, 4> weight;
    Point source;
  };
  void add(const Equation& equation) { equations_.push_back(equation); }
  /// `free`: the control points that may move, from where they are. `points` has the sources of all, NaN where one is
  /// missing: equations that need it do not count.
  void solve(std::span<const std::size_t> free, std::span<Point> points) const;

 private:
  std::vector<Equation> equations_;
};

}  // namespace horopter
