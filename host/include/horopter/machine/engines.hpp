// SPDX-License-Identifier: Apache-2.0
// The engines that this build has, by name.
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
/// Throws UsageError for an engine that this build does not have.
/// What this build has, `native` first.
std::vector<std::string> engine_names();
std::unique_ptr<Device> make_device(std::string_view engine, const MachineProfile& profile);

}  // namespace horopter
