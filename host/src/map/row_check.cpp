// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/row_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "horopter/skin/rig_skin.hpp"
#include "stages/planes.hpp"

namespace horopter {
namespace {

/// Reach of the planes that compete, px of the frame.
int largest_shift_px(const MachineProfile& profile) {
  constexpr auto kReaches = []<std::size_t... I>(std::index_sequence<I...>) {
    return std::array{stages::planes_of<hls::named_profiles[I].profile.planes>.reach()...};
  }(std::make_index_sequence<hls::named_profiles.size()>());
  const auto built = std::ranges::find(hls::named_profiles, profile.planes,
                                       [](const hls::NamedProfile& named) { return named.profile.planes; });
  return profile.subsample * kReaches.at(static_cast<std::size_t>(built - hls::named_profiles.begin()));
}

}  // namespace

ViewLimits view_limits(const MachineProfile& profile, Decision decision) {
  check_decision(profile, decision);
  ViewLimits limits;
  if (decision == Decision::thesis) return limits;
  limits.largest_shift_px = largest_shift_px(profile);
  return limits;
}

std::string RowError::expected() {
  return fmt::format("cameras side by side and parallel, their images rectified, or --decision {}",
                     name_of(Decision::thesis));
}

void check_rows(const RowCount& rows, const ViewLimits& view) {
  if (rows.share() <= RowError::kLargestShare) return;
  throw RowError(fmt::format(
      "at {:.1f} % of the pixels that could be supervised the epipolar line leaves the row by more than {} px within "
      "the {} px by which neighbours that compete are shifted",
      100 * rows.share(), kLargestRowError, view.largest_shift_px));
}

void check_rows(const LookLattice& lattice, const ScanGeometry& geometry, const ViewLimits& view) {
  if (view.largest_shift_px == 0) return;
  RowCount rows;
  for (int y = 0; y < geometry.height; y += 1 << lattice.shape.y_log2) {
    for (int x = 0; x < geometry.width; x += 1 << lattice.shape.x_log2) {
      const std::size_t at = lattice.index(x, y);
      if (geometry.holds(lattice.sources[at])) rows.add(lattice.reasons[at]);
    }
  }
  check_rows(rows, view);
}

double share_beyond_rows(const MapSet& maps, const MachineProfile& profile, const ViewLimits& view) {
  const calib::Rig rig = calib::rig_from_yaml(maps.rig, maps.skin);
  const CameraPair cameras(rig.cameras.at(0), rig.cameras.at(1));
  std::int64_t supervised = 0;
  std::int64_t beyond = 0;
  for (const CompiledMap& map : maps.maps) {
    const ScanGeometry& geometry = map.table.geometry();
    std::vector<Point> points;
    for (int y = 0; y < geometry.height; ++y) {
      for (int x = 0; x < geometry.width; ++x) {
        if (!map.table.source(x, y, profile.weight_bits)) continue;
        points.push_back(geometry.to_frame({static_cast<double>(x), static_cast<double>(y)}));
      }
    }
    const Rays rays = cameras.rays(points, view);
    const double largest = kLargestRowError * geometry.row_step();
    supervised += std::ssize(points);
    beyond += std::ranges::count_if(rays.row_error, [&](double error) { return !(error <= largest); });
  }
  return supervised == 0 ? 0 : static_cast<double>(beyond) / static_cast<double>(supervised);
}

}  // namespace horopter
