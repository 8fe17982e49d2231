// SPDX-License-Identifier: Apache-2.0
// From a skin to its mapping table: the coarsest grid whose expansion stays within a bound (T10).
#pragma once

#include <cstddef>
#include <map>

#include "horopter/map/look_lattice.hpp"
#include "horopter/map/map.hpp"
#include "horopter/map/outline_fit.hpp"
#include "horopter/map/table_facts.hpp"
#include "horopter/skin/rig_skin.hpp"
#include "horopter/skin/skin_file.hpp"

namespace horopter {

struct MapLimits {
  double share = 0.99;               ///< of the supervised pixels (of whole cells, where none fits the pool else) …
  double error_px = 1.0 / 16;        ///< … stay within this distance of the skin
  double largest_error_px = 0.25;    ///< all do: the grid loses those that would not
  double largest_lost_share = 0.02;  ///< of the pixels that could be supervised; else the table that loses least
  std::size_t largest_bytes = 0;     ///< of a table; 0: the profile's pool. Half of it where two must fit
  int largest_spacing_log2 = MapTable::kLargestSpacingLog2;  ///< 0: the thesis's dense table
  bool spans = true;  ///< a table may have them, where less is lost with them than without
  ViewLimits view;
};

/// The table of the fewest bytes within the limits, every pixel checked. Throws std::runtime_error when no pixel is
/// supervised, the skin needs more rows than the store holds, or no table within the limits fits the pool; RowError.
CompiledMap compile_map(const Skin& skin, const MachineProfile& profile, const ScanGeometry& geometry,
                        const MapLimits& limits = {});

/// Throws FileError naming the skin's file.
MapSet compile_maps(const SkinFile& skin, const MachineProfile& profile, int image_width, int image_height,
                    const ViewLimits& view = {});

/// The same for skins that move while the cameras stand, a thousand tables a second. The lines of sight are computed
/// once. Errors and reasons are checked at 4 pixels of each cell: its corner, its middle and the middles between.
/// Limits of the view are met between the samples of a `simple` surface, by their second differences; on other
/// surfaces samples are 4 pixels apart or less, and parts smaller than that may be missed. Outlines are followed pixel by
/// pixel. Results do not depend on the skins before.
class MapCompiler {
 public:
  MapCompiler(CameraPair cameras, const MachineProfile& profile, const ScanGeometry& geometry,
              const MapLimits& limits = {});
  /// Throws like compile_map, and std::invalid_argument where the cameras cannot watch the surface. Not for several
  /// threads at once.
  CompiledMap compile(const Surface& surface);

 private:
  const Rays& rays(const LatticeShape& shape);
  void look(const Surface& surface, const LatticeShape& shape, LookLattice& lattice);

  CameraPair cameras_;
  const MachineProfile& profile_;
  ScanGeometry geometry_;
  MapLimits limits_;
  std::map<LatticeShape, Rays> rays_;
  LookLattice lattice_;  ///< of the skin at hand; kept for its memory
  SkinScale scale_;
  OutlineTracer outlines_;
};

}  // namespace horopter
