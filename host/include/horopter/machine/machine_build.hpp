// SPDX-License-Identifier: Apache-2.0
// What a machine was built as: its registers tell, so that nobody has to say it.
#pragma once

#include <cstddef>

#include "horopter/base/profile.hpp"
#include "horopter/machine/device.hpp"

namespace horopter {

struct Build {
  const MachineProfile* profile = nullptr;
  std::size_t pool_bytes = 0;  ///< of its mapping tables; at most the profile's
  bool thesis = false;         ///< has the rule; at least one
  bool compete = false;
  bool blind = false;  ///< can be taught (BlindSettings)
};

/// The device is a Horopter, of this program's register map and this profile. It may have less than the profile where that
/// only limits what it can be asked for: one of two rules, a smaller pool, without the stage `blind`. Throws DeviceError.
Build check_build(Device& device, const MachineProfile& profile);
/// Which profile it is. Throws DeviceError where it is none of those that this program knows.
Build find_build(Device& device);
/// Throws UsageError where the profile or the build does not have the rule.
void check_rule(const Build& build, Decision decision);
/// Throws UsageError where the build cannot be taught.
void check_blind(const Build& build);
/// An empty result, of the size that the registers tell.
Image result_image(Device& device);

}  // namespace horopter
