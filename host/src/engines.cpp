// SPDX-License-Identifier: Apache-2.0
#include "horopter/engines.hpp"

#include <fmt/format.h>

#include "horopter/error.hpp"
#include "horopter/native_device.hpp"

namespace horopter {
namespace {

struct Engine {
  std::string_view name;
  DeviceFactory make;
};

std::vector<Engine>& engines() {
  static std::vector<Engine> list{{"native", make_native_device}};
  return list;
}

}  // namespace

void register_engine(std::string_view name, DeviceFactory factory) { engines().push_back({name, factory}); }

std::unique_ptr<Device> make_device(std::string_view engine, const MachineProfile& profile) {
  std::string names;
  for (const Engine& candidate : engines()) {
    if (candidate.name == engine) return candidate.make(profile);
    names += (names.empty() ? "" : ", ") + std::string(candidate.name);
  }
  if (engine == "rtl") {
    throw UsageError("this build has no engine 'rtl': it was configured with HOROPTER_COSIM=OFF; there is: " + names);
  }
  throw UsageError(fmt::format("unknown engine '{}'; expected one of: {}", engine, names));
}

}  // namespace horopter
