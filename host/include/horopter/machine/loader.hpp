// SPDX-License-Identifier: Apache-2.0
// Tables, settings and limits into a machine that may be watching people meanwhile.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "horopter/machine/machine_build.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/map/map.hpp"

namespace horopter {

struct LoadReport {
  struct Table {
    int slot = 0;
    std::uint32_t crc = 0;
    std::size_t bytes = 0;  ///< of the pool
  };
  std::vector<Table> tables;         ///< the first one is selected
  std::vector<std::string> changed;  ///< registers that had another value
  bool stopped = false;              ///< the machine was stopped between the old settings and the new ones
  bool active = false;               ///< a frame has begun with the first table
};

/// First the tables, beside the one in use, which stays in use. Only when they are there, complete, by their CRCs, the
/// settings, and the selection of the first table. Where a setting changes, or a bit of a register fell over (fault
/// `settings`), the machine is stopped in between (it says not safe): no frame is made by old settings and a new table, or
/// the other way round. Into a machine that is stopped all settings are written. All is read back.
/// The limit on undecidable pixels belongs to its table: it is a setting where frames are made with the same one. Where it
/// changes, the machine is stopped before the tables.
///
/// A machine for fields that holds more than one table is stopped before the tables, and they are taken out of it: who
/// gives the fields selects two of them in turn.
///
/// `stop_first`: the machine is stopped before the tables, which may then take the place of the one in use.
/// `frame_timeout`: so long it waits for a frame with the new table (LoadReport::active).
///
/// Throws DeviceError: it tells whether the table that was in use still is, or the machine is stopped. UsageError where
/// the build does not have the settings' rule. The maps must be of the build's profile.
LoadReport load(Device& device, const Build& build, const MapSet& maps, const Settings& settings, bool stop_first,
                std::chrono::milliseconds frame_timeout = std::chrono::seconds(5));

/// `settings` with what the tables and their rig say of the proof.
Settings settings_for(Settings settings, const MachineProfile& profile, const MapSet& maps);

}  // namespace horopter
