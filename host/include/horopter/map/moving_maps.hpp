// SPDX-License-Identifier: Apache-2.0
// Moving skins: one table a frame, in steps that no object can slip through (E3; thesis 11.1, Fig. 11.5).
#pragma once

#include <cstddef>
#include <vector>

#include "horopter/map/map_compiler.hpp"
#include "horopter/skin/moving_surface.hpp"
#include "horopter/skin/skin_file.hpp"

namespace horopter {

/// The skin of one frame, or field.
struct MovingStep {
  double time_s = 0;  ///< of the motion
  CompiledMap map;
};

/// From the begin to the end of a motion, where the skin then stays.
struct MovingMaps {
  std::vector<MovingStep> steps;  ///< of fields even and odd ones in turn, from even
  int lookahead = 0;              ///< that serves all
  std::string rig;                ///< the two cameras, as text of rig.yaml
  std::size_t inserted = 0;       ///< frames by which the skin comes later than the motion says

  const ScanGeometry& geometry() const { return steps.at(0).map.table.geometry(); }
  /// One of each step; they live as long as the steps.
  std::vector<const MapTable*> tables() const;
  /// The step of a frame; beyond the end the last one of its field.
  std::size_t step_of(std::size_t frame) const;
};

/// Times of the skins of consecutive frames. An object that is outside of the skin at one frame must not be inside of
/// it at the next without having been in it. So, at every supervised pixel (of a lattice of at most 8 px), the way of
/// the skin from one frame to the next and that of an object, its speed times limits.longest_s(), are together at most the
/// thickness across the skin, the smaller of both. The way of the skin is along its normal between both where the line of sight
/// meets both; never more than the way of its matter. Where a step is too long, intermediate skins are inserted: the
/// skin then comes later than the motion says. A robot that does not wait for it touches its own skin: an alarm, not
/// a gap. Throws std::runtime_error where even a skin at rest is too thin for the object, saying where.
std::vector<double> plan_motion(const CameraPair& cameras, const MovingSurface& surface, const MotionLimits& limits,
                                const MachineProfile& profile, int image_width, int image_height);

/// Times and tables of a skin file with `motion`. Tables of two consecutive frames fit the pool. `threads` share them; 0: as
/// many as there are processors, at most 8. Throws FileError.
MovingMaps compile_motion(const SkinFile& skin, const MachineProfile& profile, int image_width, int image_height,
                          const ViewLimits& view = {}, int threads = 0);

}  // namespace horopter
