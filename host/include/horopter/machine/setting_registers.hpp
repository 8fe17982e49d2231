// SPDX-License-Identifier: Apache-2.0
// The settings of the stages and the registers' fields that hold them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "horopter/hls/settings.hpp"
#include "horopter/machine/registers.hpp"

namespace horopter {

using hls::CompeteSettings;

template <class Settings>
struct SettingField {
  std::string_view name;
  std::uint32_t address;
  registers::Field field;
  int Settings::* setting;

  [[nodiscard]] constexpr int largest() const { return (1 << field.bits) - 1; }
};

/// A register each.
inline constexpr auto kSettingFields = std::to_array<SettingField<hls::StageSettings>>({
#define HOROPTER_SETTING(name, reset, of, field) \
  {#name, registers::of::kAddress, registers::of::field, &hls::StageSettings::name},
#include "horopter/hls/settings.def"
});

/// All in the register COMPETE.
inline constexpr auto kCompeteFields = std::to_array<SettingField<CompeteSettings>>({
#define HOROPTER_COMPETE_SETTING(name, reset, field) \
  {#name, registers::compete::kAddress, registers::compete::field, &CompeteSettings::name},
#include "horopter/hls/settings.def"
});

/// Values cut to the widths of their fields.
constexpr std::uint32_t compete_word(const CompeteSettings& settings) {
  std::uint32_t word = 0;
  for (const auto& f : kCompeteFields) word |= f.field.put(static_cast<std::uint32_t>(settings.*f.setting));
  return word;
}

constexpr CompeteSettings compete_settings(std::uint32_t word) {
  CompeteSettings settings;
  for (const auto& f : kCompeteFields) settings.*f.setting = static_cast<int>(f.field.get(word));
  return settings;
}

static_assert(registers::compete::kReset == compete_word({}), "registers.yaml has other defaults");

/// `read(address)`: a register's word.
template <class Read>
hls::StageSettings stage_settings(const Read& read) {
  hls::StageSettings settings;
  for (const auto& f : kSettingFields) settings.*f.setting = static_cast<int>(f.field.get(read(f.address)));
  static_cast<CompeteSettings&>(settings) = compete_settings(read(registers::compete::kAddress));
  return settings;
}

/// `write(address, word)` for every register that holds settings.
template <class Write>
void write_settings(const hls::StageSettings& settings, const Write& write) {
  for (auto f = kSettingFields.begin(); f != kSettingFields.end(); ++f) {
    const auto same = [&](const auto& other) { return other.address == f->address; };
    if (std::find_if(kSettingFields.begin(), f, same) != f) continue;  // its register is written
    std::uint32_t word = 0;
    for (const auto& other : kSettingFields) {
      if (same(other)) word |= other.field.put(static_cast<std::uint32_t>(settings.*other.setting));
    }
    write(f->address, word);
  }
  write(registers::compete::kAddress, compete_word(settings));
}

}  // namespace horopter
