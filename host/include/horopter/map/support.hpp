// SPDX-License-Identifier: Apache-2.0
// How much of an image a table lets a rule judge, and what limits in percent are in pixels.
#pragma once

#include <cstdint>

#include "horopter/base/profile.hpp"
#include "horopter/map/map.hpp"

namespace horopter {

/// Pixels of the result (after sub-sampling) all of whose support has a source, so that the rule can judge them. The
/// machine calls the others unsupervised, whatever the images show; fewer only where the store misses rows, a fault.
std::int64_t supported_pixels(const MapTable& table, const MachineProfile& profile, Decision decision);

/// ⌊percent · of / 100⌋, as the machine's registers take their limits: more than this many are too many.
std::uint32_t limit_of(double percent, double of);

}  // namespace horopter
