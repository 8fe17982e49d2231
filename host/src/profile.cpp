// SPDX-License-Identifier: Apache-2.0
#include "horopter/profile.hpp"

#include <fmt/format.h>

#include <array>

#include "horopter/error.hpp"

namespace horopter {
namespace {

constexpr auto kProfiles = std::to_array<Profile>({
#define HOROPTER_PROFILE(name, width, height, subsample, dsad, majority, weight_bits, store_rows, pool_bytes, \
                         hypotheses, clock_khz)                                                               \
  {#name, width, height, subsample, dsad, majority, weight_bits, store_rows, pool_bytes, hypotheses, clock_khz},
#include "horopter/hls/profiles.def"
#undef HOROPTER_PROFILE
});

}  // namespace

std::span<const Profile> profiles() { return kProfiles; }

std::string profile_names() {
  std::string names;
  for (const Profile& profile : kProfiles) {
    names += (names.empty() ? "" : ", ") + std::string(profile.name);
  }
  return names;
}

const Profile& find_profile(std::string_view name) {
  for (const Profile& profile : kProfiles) {
    if (profile.name == name) return profile;
  }
  throw UsageError(fmt::format("unknown profile '{}'; expected one of: {}", name, profile_names()));
}

const Profile* smallest_profile(int image_width, int image_height) {
  const Profile* best = nullptr;
  for (const Profile& profile : kProfiles) {
    if (profile.takes_fields() || image_width > profile.width || image_height > profile.height) continue;
    if (best == nullptr || profile.width * profile.height < best->width * best->height) best = &profile;
  }
  return best;
}

}  // namespace horopter
