// SPDX-License-Identifier: Apache-2.0
// The settings of the stages: names and defaults are those of rtl/csr/registers.yaml.
#pragma once

namespace horopter::hls {

/// Of the rule `compete`: the fields of the register COMPETE.
struct CompeteSettings {
#define HOROPTER_COMPETE_SETTING(name, reset, field) int name = reset;
#include "horopter/hls/settings.def"
};

/// All that the registers say to the stages. What depends on the profile is 0.
struct StageSettings : CompeteSettings {
#define HOROPTER_SETTING(name, reset, of, field) int name = reset;
#include "horopter/hls/settings.def"
};

/// Shares in % from which limits come that depend on the profile.
namespace percent {
#define HOROPTER_PERCENT(name, value) inline constexpr int name = value;
#include "horopter/hls/settings.def"
}  // namespace percent

}  // namespace horopter::hls
