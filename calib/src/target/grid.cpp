// SPDX-License-Identifier: Apache-2.0
// Quads sorted into a grid, from neighbour to neighbour.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <queue>

#include "target/steps.hpp"

namespace horopter::calib::detail {
namespace {

using Eigen::Vector2d;

struct Axes {
  Vector2d x, y;  ///< one pitch, px
};

/// With corner `first` the first of the spec's fiducial.
Axes axes(const Quad& quad, int first, TargetKind kind, double pitch_over_side) {
  const auto corner = [&](int i) { return quad.corners[(first + i) % 4]; };
  if (kind == TargetKind::diamonds) {
    // top, right, bottom, left; the diagonal is √2 sides
    const double scale = pitch_over_side / std::numbers::sqrt2;
    return {(corner(1) - corner(3)) * scale, (corner(2) - corner(0)) * scale};
  }
  return {(corner(1) - corner(0) + corner(2) - corner(3)) / 2 * pitch_over_side,
          (corner(3) - corner(0) + corner(2) - corner(1)) / 2 * pitch_over_side};
}

}  // namespace

std::vector<GridCell> link_grid(const std::vector<Quad>& quads, TargetKind kind, double pitch_over_side) {
  std::vector<int> done(quads.size(), 0);
  std::vector<GridCell> largest;
  for (std::size_t seed = 0; seed < quads.size(); ++seed) {
    if (done[seed] || quads[seed].touches_border) continue;
    std::map<std::pair<int, int>, GridCell> cells;
    std::queue<GridCell> queue;
    const GridCell start{static_cast<int>(seed), 0, 0, 0};
    cells[{0, 0}] = start;
    done[seed] = 1;
    queue.push(start);
    while (!queue.empty()) {
      const GridCell cell = queue.front();
      queue.pop();
      const Quad& quad = quads[cell.quad];
      const Axes here = axes(quad, cell.first, kind, pitch_over_side);
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        if (cells.count({cell.x + dx, cell.y + dy})) continue;
        Vector2d step = here.x * dx + here.y * dy;
        // The step to a neighbour on the other side is a better guess of the next step than the size of the fiducial.
        if (const auto back = cells.find({cell.x - dx, cell.y - dy}); back != cells.end()) {
          const Vector2d known = quad.centre - quads[back->second.quad].centre;
          if ((known - step).norm() < 0.3 * step.norm()) step = (known + step) / 2;
        }
        const Vector2d expected = quad.centre + step;
        int best = -1;
        double best_distance = 0.25 * step.norm();
        for (std::size_t i = 0; i < quads.size(); ++i) {
          if (done[i] || quads[i].touches_border || (quads[i].contrast > 0) != (quad.contrast > 0)) continue;
          if (quads[i].side_px > 1.6 * quad.side_px || quad.side_px > 1.6 * quads[i].side_px) continue;
          if (const double distance = (quads[i].centre - expected).norm(); distance < best_distance) {
            best_distance = distance;
            best = static_cast<int>(i);
          }
        }
        if (best < 0) continue;
        GridCell next{best, cell.x + dx, cell.y + dy, 0};
        double closest = -1e9;
        for (int first = 0; first < 4; ++first) {
          const Axes there = axes(quads[best], first, kind, pitch_over_side);
          const double agreement = there.x.dot(here.x) + there.y.dot(here.y);
          if (agreement > closest) {
            closest = agreement;
            next.first = first;
          }
        }
        // Seen from the neighbour, the step back must lead here.
        const Axes there = axes(quads[best], next.first, kind, pitch_over_side);
        const Vector2d back = there.x * dx + there.y * dy;
        if ((quads[best].centre - back - quad.centre).norm() > 0.3 * back.norm()) continue;
        done[best] = 1;
        cells[{next.x, next.y}] = next;
        queue.push(next);
      }
    }
    if (cells.size() > largest.size()) {
      largest.clear();
      for (const auto& entry : cells) largest.push_back(entry.second);
    }
  }
  return largest;
}

}  // namespace horopter::calib::detail
