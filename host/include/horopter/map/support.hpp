// SPDX-License-Identifier: Apache-2.0
// How much of an image a table lets a rule judge, and what limits in percent are in pixels.
#pragma once

#include <cstdint>

#include "horopter/base/profile.hpp"
#include "horopter/map/map.hpp"

namespace horopter {

/// Pixels of the result (after sub-sampling) that the rule can judge, by the table's header.
std::int64_t supported_pixels(const MapTable& table, Decision decision);

/// What they see of the skin, by the table's areas, which it must know.
double supported_mm2(const MapTable& table, const MachineProfile& profile, Decision decision);

/// Share of the image where both cameras can be shown to see the same world: on the skin and around it, within the rows
/// that the store gives.
double compared_share(const MapTable& table, const MachineProfile& profile, int lookahead);

/// ⌊percent · of / 100⌋, as the machine's registers take their limits: more than this many are too many.
std::uint32_t limit_of(double percent, double of);

/// What an object must show at least.
struct ShownLimit {
  double least = 0;
  bool in_mm2 = false;  ///< by the table's areas, which it must know; else pixels of the result
};

/// Of the skin, 0 to 1: where a disc of twice this limit shows less than it of pixels that can be judged and touch each
/// other. One place in 4×4 pixels of the result is asked. Places near the image's border, where the skin may go on, do not
/// count. So it is near the skin's own border; and where the skin is narrow, or parted by gaps, each as wide as the windows.
double share_beyond_limit(const MapTable& table, const MachineProfile& profile, Decision decision,
                          const ShownLimit& limit);

}  // namespace horopter
