// SPDX-License-Identifier: Apache-2.0
#include "forecast.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "expansion.hpp"

namespace horopter {

Forecast::Forecast(const LookLattice& lattice, const ScanGeometry& geometry) {
  constexpr int kStep = 1 << kLog2;
  const auto good = [&](int x, int y) { return lattice.reasons[lattice.index(x, y)] == Reason::none; };
  for (int y = 0; y < geometry.height; y += kStep) {
    for (int x = 0; x < geometry.width; x += kStep) {
      if (!good(x, y)) continue;
      ++good_;
      const Point here = lattice.sources[lattice.index(x, y)];
      const auto bend = [&](int dx, int dy) -> Point {
        if (x < dx || y < dy || x + dx >= geometry.width || y + dy >= geometry.height) return {};
        const Point a = lattice.sources[lattice.index(x - dx, y - dy)];
        const Point b = lattice.sources[lattice.index(x + dx, y + dy)];
        const Point bend{a.x - 2 * here.x + b.x, a.y - 2 * here.y + b.y};
        return std::isfinite(bend.x + bend.y) ? bend : Point{};
      };
      bends_.push_back({bend(kStep, 0), bend(0, kStep)});
      for (const auto& [dx, dy] : {std::pair{kStep, 0}, {-kStep, 0}, {0, kStep}, {0, -kStep}}) {
        if (x + dx < 0 || y + dy < 0 || x + dx >= geometry.width || y + dy >= geometry.height) continue;
        if (is_excluded(lattice.reasons[lattice.index(x + dx, y + dy)])) ++(dx != 0 ? across_ : along_);
      }
    }
  }
}

double Forecast::share_beyond(int nx, int ny, double error_px) const {
  constexpr double kLeft = 0.6;
  const double across = std::ldexp(kLeft / 8, 2 * (nx - kLog2));
  const double along = std::ldexp(kLeft / 8, 2 * (ny - kLog2));
  const auto beyond = std::ranges::count_if(bends_, [&](const Bend& bend) {
    return length({bend.x.x * across + bend.y.x * along, bend.x.y * across + bend.y.y * along}) > error_px;
  });
  return bends_.empty() ? 0 : static_cast<double>(beyond) / static_cast<double>(bends_.size());
}

double Forecast::lost_share(int nx, int ny) const {
  constexpr double kCut = 0.35;
  const double cells =
      std::ldexp(static_cast<double>(across_), nx - kLog2) + std::ldexp(static_cast<double>(along_), ny - kLog2);
  return good_ == 0 ? 0 : kCut * cells / static_cast<double>(good_);
}

}  // namespace horopter
