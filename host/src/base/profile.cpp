// SPDX-License-Identifier: Apache-2.0
#include "horopter/base/profile.hpp"

#include <fmt/format.h>

#include <array>

#include "horopter/base/error.hpp"

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

std::string_view name_of(Decision decision) { return decision == Decision::compete ? "compete" : "thesis"; }

void check_decision(const MachineProfile& profile, Decision decision) {
  if (profile.has(decision == Decision::compete ? hls::Rule::compete : hls::Rule::thesis)) return;
  throw UsageError(fmt::format("profile {} does not have the decision '{}'", profile.name, name_of(decision)));
}

}  // namespace horopter
