// SPDX-License-Identifier: Apache-2.0
// What the machine must know to let clear be earned (hls/stages/agreement.hpp): where other depths are to be looked for,
// and for how long something may stand before the skin.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "horopter/base/profile.hpp"
#include "horopter/map/map.hpp"

namespace horopter {

struct Proof {
  bool needed = true;  ///< false: a pixel is clear where the images do not agree, and nothing else is checked
  /// Shifts along the row, cells, that mean a place in front of both cameras; all where it is not known.
  int shift_lowest = -30;
  int shift_highest = 30;
  bool nearer_below = false;  ///< shifts below 0 are nearer than the skin; none is known to be without a rig
  bool nearer_above = false;
  /// Slope of the epipolar lines, rows for a column: of the first cell, its change from column to column, from row to
  /// row, and of the one with the other. 0 without a rig.
  std::array<double, 4> epipolar{};
  bool registered = false;  ///< these are known: what is displaced across them is a fault
  /// Also at full resolution (stages/patches.hpp), and nothing is safe before that: where most lines to what is behind
  /// the skin stay within its reach.
  bool at_full_resolution = false;
  double hidden_percent = 10;  ///< of the cells: more behind something nearer are a fault,
  int hidden_frames = 50;      ///< after so many frames in a row, 1 to 128; 0 = never
};

/// `proof` with what tables and cameras say: shifts that serve all tables, and the left camera's epipolar lines. `rig`:
/// text of a rig, of `file` in errors; empty = a skin without a rig, of which nothing is known.
Proof with_knowledge(Proof proof, const MachineProfile& profile, const std::vector<const MapTable*>& tables,
                     const std::string& rig, const std::string& file);

}  // namespace horopter
