// SPDX-License-Identifier: Apache-2.0
// Which spacings are worth a try.
#pragma once

#include <cstdint>
#include <vector>

#include "horopter/image/scan.hpp"
#include "horopter/map/look_lattice.hpp"

namespace horopter {

/// What second differences on a lattice of 16 pixels say about the error and the loss of other spacings.
class Forecast {
 public:
  static constexpr int kLog2 = 4;  ///< of the lattice's pixels
  /// The lattice may be finer.
  Forecast(const LookLattice& lattice, const ScanGeometry& geometry);

  /// Share of the pixels, roughly, whose interpolation (the quadratic's, in the middle of a cell, 0.6 of it left by
  /// the control points) is further off.
  double share_beyond(int nx, int ny, double error_px) const;
  /// Cells that the border of what is seen within the limits cuts: along an ellipse 0.35 of what it is long across and
  /// along the rows, times their width and height.
  double lost_share(int nx, int ny) const;

 private:
  struct Bend {
    Point x, y;
  };
  std::vector<Bend> bends_;
  std::int64_t good_ = 0;
  std::int64_t across_ = 0;  ///< pixels of the lattice's rows beyond which the border crosses the row
  std::int64_t along_ = 0;
};

}  // namespace horopter
