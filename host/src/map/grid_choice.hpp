// SPDX-License-Identifier: Apache-2.0
// Which of the grids of all spacings becomes the table.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

#include "forecast.hpp"
#include "grid_fit.hpp"
#include "horopter/base/profile.hpp"
#include "horopter/image/scan.hpp"
#include "horopter/map/map.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/map/outline_fit.hpp"

namespace horopter {

/// Nothing of a skin is supervised.
class UnseenError : public std::runtime_error {
 public:
  explicit UnseenError(const MapReport& report);
};

/// As messages say it.
std::string rows_text(RowReach reach);

/// What there is to choose among.
struct Grids {
  const MachineProfile& profile;
  const ScanGeometry& geometry;
  const MapLimits& limits;
  const Forecast& forecast;
  double margin;           ///< what the forecast says to be beyond so many times the limits is not tried
  std::size_t areas;       ///< how many of them the table will hold
  const Outline* outline;  ///< or none
  /// Tries a spacing: with an outline's spans if there is one, and without where that is not enough.
  std::function<GridFit(int nx, int ny, const Outline* outline)> fit;
};

/// The coarsest grid within the limits; where none loses little enough, of those that the forecast says to lose least
/// the one that does. To be sealed. Throws UnseenError, and std::runtime_error where none fits the pool or the store.
CompiledMap choose(const Grids& grids);

}  // namespace horopter
