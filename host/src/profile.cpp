// SPDX-License-Identifier: Apache-2.0
#include "horopter/profile.hpp"

#include <fmt/format.h>

#include <array>

#include "horopter/error.hpp"

namespace horopter {
namespace {

constexpr auto kProfiles = [] {
  std::array<MachineProfile, hls::named_profiles.size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = {hls::named_profiles[i].profile, hls::named_profiles[i].name};
  return all;
}();

}  // namespace

std::span<const MachineProfile> profiles() { return kProfiles; }

std::string profile_names() {
  std::string names;
  for (const MachineProfile& profile : kProfiles) {
    names += (names.empty() ? "" : ", ") + std::string(profile.name);
  }
  return names;
}

const MachineProfile& find_profile(std::string_view name) {
  for (const MachineProfile& profile : kProfiles) {
    if (profile.name == name) return profile;
  }
  throw UsageError(fmt::format("unknown profile '{}'; expected one of: {}", name, profile_names()));
}

const MachineProfile* smallest_profile(int image_width, int image_height) {
  const MachineProfile* best = nullptr;
  for (const MachineProfile& profile : kProfiles) {
    if (profile.takes_fields() || image_width > profile.width || image_height > profile.height) continue;
    if (best == nullptr || profile.width * profile.height < best->width * best->height) best = &profile;
  }
  return best;
}

}  // namespace horopter
