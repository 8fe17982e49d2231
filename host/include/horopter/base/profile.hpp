// SPDX-License-Identifier: Apache-2.0
// The profiles at run time: one record per line of profiles.def.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "horopter/hls/profiles.hpp"

namespace horopter {

struct MachineProfile : hls::Profile {
  std::string_view name;

  /// Right rows that the store still holds above the output row, and the most it may wait for below.
  constexpr int rows_behind() const { return store_rows / 2 - 2; }
  constexpr int largest_lookahead() const { return store_rows / 2; }
  constexpr int largest_image_width() const { return width; }
  constexpr int largest_image_height() const { return height * fields_per_image(); }
};

std::span<const MachineProfile> profiles();
/// Throws UsageError naming the profiles that there are.
const MachineProfile& find_profile(std::string_view name);
/// The smallest profile (in pixels) that takes the image as it is, one frame an image. Profiles that split an image
/// into fields change what comes out, so they are used on request only. Null when none is large enough.
const MachineProfile* smallest_profile(int image_width, int image_height);
std::string profile_names();

/// The rule that decides a pixel: one threshold for one skin, or parallel skins that compete.
enum class Decision { thesis, compete };
std::string_view name_of(Decision decision);
/// Throws UsageError where the profile does not have the rule.
void check_decision(const MachineProfile& profile, Decision decision);

}  // namespace horopter
