// SPDX-License-Identifier: Apache-2.0
// The engines that this build has, by name: `native`, `rtl`, and machines that are somewhere, `uio:PLACE`, `serial:PLACE`.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "horopter/base/profile.hpp"
#include "horopter/machine/device.hpp"

namespace horopter {

using DeviceFactory = std::unique_ptr<Device> (*)(const MachineProfile& profile);

/// Adds an engine; the program does so for the co-simulated hardware, which lives in a library of its own.
void register_engine(std::string_view name, DeviceFactory factory);
/// Those that need no place, `native` first.
std::vector<std::string> engine_names();
/// All, and how a place is written: for the help of --engine.
std::string engine_help();
/// Throws UsageError for an engine that this build does not have, or a place that is written wrong.
void check_engine(std::string_view engine);
/// A machine that is somewhere is what it is, whatever the profile (machine_build.hpp), and may have another user's table.
bool is_somewhere(std::string_view engine);
/// UsageError as check_engine; DeviceError where there is no such machine.
std::unique_ptr<Device> make_device(std::string_view engine, const MachineProfile& profile);

}  // namespace horopter
