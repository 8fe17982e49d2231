// SPDX-License-Identifier: Apache-2.0
// The settings of the rule `compete` and the register COMPETE, whose fields they are.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "horopter/hls/compete_settings.hpp"
#include "horopter/machine/registers.hpp"

namespace horopter {

using hls::CompeteSettings;

struct CompeteField {
  std::string_view name;
  registers::Field field;
  int CompeteSettings::* setting;

  [[nodiscard]] constexpr int largest() const { return (1 << field.bits) - 1; }
};

inline constexpr auto kCompeteFields =
    std::to_array<CompeteField>({{"bias", registers::compete::kBias, &CompeteSettings::bias},
                                 {"smooth", registers::compete::kSmooth, &CompeteSettings::smooth},
                                 {"similar", registers::compete::kSimilar, &CompeteSettings::similar},
                                 {"quorum", registers::compete::kQuorum, &CompeteSettings::quorum},
                                 {"clear_quorum", registers::compete::kClearQuorum, &CompeteSettings::clear_quorum},
                                 {"boundary", registers::compete::kBoundary, &CompeteSettings::boundary}});

/// Values cut to the widths of their fields.
constexpr std::uint32_t compete_word(const CompeteSettings& settings) {
  std::uint32_t word = 0;
  for (const CompeteField& f : kCompeteFields) word |= f.field.put(static_cast<std::uint32_t>(settings.*f.setting));
  return word;
}

constexpr CompeteSettings compete_settings(std::uint32_t word) {
  CompeteSettings settings;
  for (const CompeteField& f : kCompeteFields) settings.*f.setting = static_cast<int>(f.field.get(word));
  return settings;
}

static_assert(registers::compete::kReset == compete_word({}), "registers.yaml has other defaults");

}  // namespace horopter
