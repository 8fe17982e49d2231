// SPDX-License-Identifier: Apache-2.0
// What is written into a machine before it runs: settings and limits as words of its registers, and mapping tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "horopter/machine/device.hpp"
#include "horopter/machine/monitor.hpp"

namespace horopter {

struct RegisterWord {
  std::uint32_t address = 0;
  std::uint32_t value = 0;
};

/// Of the incoming images, px and rows.
struct FrameGeometry {
  int width = 0;
  int height = 0;
  int lookahead = 0;
};

/// The registers that geometry and settings decide, and those that no setting does, but for IRQ_ENABLE, which is a driver's,
/// and those of the tables; some are locked while the machine runs. Of AGREEMENT_LIMITS, which is read, only a part is
/// decided. Throws UsageError where a setting has no such value.
std::vector<RegisterWord> configuration(Device& device, const MachineProfile& profile, const Settings& settings,
                                        FrameGeometry geometry);

/// TIMEOUT after reset: the time of two of the largest frames without a pause.
std::uint32_t usual_timeout_clocks(const MachineProfile& profile);

/// As registers.md has it: SUM_LIMIT. The address must be that of a register.
std::string register_name(std::uint32_t address);

/// Reads back what it has written. Throws DeviceError where that is another value.
void write_checked(Device& device, const RegisterWord& word);

/// The register BLOCKS, which is not locked.
RegisterWord blocks_word(const BlindSettings& blind);

/// MAP_UNDECIDABLE_LIMIT of a table, pixels.
std::uint32_t undecidable_limit(const MapTable& table, const Settings& settings);

/// Uploads a table into slot 0 … 14, at a place in the pool in 8 bytes, and reads back that it is there. Gives 0, or the
/// error that MAP_STATUS tells: the machine refused the table. Throws DeviceError where the machine contradicts itself.
std::uint32_t upload_table(Device& device, int slot, std::size_t base_word64, const MapTable& table,
                           std::uint32_t undecidable_limit);
constexpr std::uint32_t kUploadInUse = 1;  ///< the slot or the region is that of a table in use; nothing has changed
std::string_view upload_error_text(std::uint32_t error);

}  // namespace horopter
