// SPDX-License-Identifier: Apache-2.0
// Where a skin ends in the image: the spans of a table's rows (hls/table_format.hpp), and control points beyond that end.
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

/// Never supervised, wherever the source lies.
constexpr bool is_excluded(Reason reason) { return reason != Reason::none && reason != Reason::outside; }

/// Of each row of a scan the pixels that are on the skin and within the limits of the view: of several runs the longest, or
/// the one that goes on from row to row.
struct Outline {
  std::vector<hls::table::Span> spans;
  /// Of a pixel in the scan's coordinates; NaN where it must not be supervised. Neighbours of a row are quick. As long as
  /// what the outline was made of lives.
  std::function<Point(int x, int y)> source;

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
  /// The outline lives as long as the tracer, the cameras and the surface.
  std::optional<Outline> trace(const CameraPair& cameras, const Surface& surface, const LookLattice& coarse);

 private:
  static constexpr int kSide = 8;                                 ///< pixels of a row that are looked at together
  static constexpr std::size_t kMostRays = std::size_t{1} << 19;  ///< kept: 60 MB
  /// The part of a row that was looked at last.
  struct Seen {
    std::array<Look, kSide> looks;
    int part = -1, y = -1;
  };
  const Look& look(const CameraPair& cameras, const Surface& surface, int x, int y, Seen& seen);
  std::size_t rays_of(const CameraPair& cameras, int part, int y);

  ScanGeometry geometry_;
  ViewLimits view_;
  int parts_;                            ///< of a row
  std::vector<std::int32_t> first_ray_;  ///< of each part of each row; -1 where there are none yet
  Rays rays_;
};

/// Control points from what is seen between them: least squares.
class ControlFit {
 public:
  /// The control points that may move, of all `points`; those without a place are NaN, and what needs one of them does not
  /// count. `points` must live as long.
  ControlFit(std::vector<std::size_t> free, std::vector<Point>& points);
  /// Of four control points, the upper two first, what must be seen between them, in parts of a cell right of and below
  /// the first; it counts as so many.
  void add(const std::array<std::size_t, 4>& at, double right, double below, Point source, double counts);
  /// Moves the points.
  void solve();
  const std::vector<std::size_t>& free() const { return free_; }

 private:
  struct Use {
    std::size_t equation;
    double weight, counts;
  };
  std::vector<std::size_t> free_;
  std::vector<Point>& points_;
  std::vector<Point> from_;
  std::vector<std::int32_t> place_;     ///< of a point among the free ones, or -1
  std::vector<std::vector<Use>> uses_;  ///< of each free point
  std::vector<Point> rest_;             ///< what each equation lacks
};

}  // namespace horopter
