// SPDX-License-Identifier: Apache-2.0
// All registers of a machine that can be read, in words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "horopter/machine/faults.hpp"
#include "horopter/machine/machine_build.hpp"

namespace horopter {

/// A table of which the machine says that it is complete.
struct StoredTable {
  int slot = 0;
  std::uint32_t crc = 0;
  std::size_t bytes = 0;  ///< of the pool
};

/// Of the pool, that a table takes by MAP_EXTENT.
std::size_t extent_bytes(std::uint32_t extent);

/// Both pins, as STATUS has them, say safe. Equal ones do not.
bool says_safe(std::uint32_t status);

struct MachineStatus {
  Build build;
  std::map<std::uint32_t, std::uint32_t> words;  ///< by address
  std::vector<StoredTable> tables;               ///< none while an upload is under way
  bool one_frame = true;  ///< the FRAME registers are of one frame, not of two that came while they were read

  [[nodiscard]] std::uint32_t word(std::uint32_t address) const { return words.at(address); }
  [[nodiscard]] bool running() const;
  [[nodiscard]] bool safe() const;
  [[nodiscard]] bool live() const;        ///< its cameras cannot wait
  [[nodiscard]] bool test_input() const;  ///< instead of the cameras; never safe
  /// Table of the frame that is being made; nothing without one.
  [[nodiscard]] std::optional<int> active_slot() const;
  /// Nothing while an upload is under way, too.
  [[nodiscard]] std::optional<StoredTable> active_table() const;
  [[nodiscard]] Faults faults() const;        ///< since they were cleared
  [[nodiscard]] Faults frame_faults() const;  ///< of the last frame
};

/// Throws DeviceError. MAP_SLOT is changed while no upload is under way, and put back.
MachineStatus read_status(Device& device);

/// {"build", "running", "safe", "live", "test_input", "table", "tables", "frame", "faults", "frame_faults", "registers": {name: {field: value}}}
nlohmann::ordered_json status_json(const MachineStatus& status);
/// A line for each register: name, address, and its fields with their units.
std::vector<std::string> register_lines(const MachineStatus& status);
/// What a fault means, a sentence.
std::string fault_text(std::string_view name);

}  // namespace horopter
