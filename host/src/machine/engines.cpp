// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/engines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "horopter/base/error.hpp"
#include "horopter/machine/native_device.hpp"

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

std::vector<std::string> engine_names() {
  std::vector<std::string> names;
  for (const Engine& engine : engines()) names.emplace_back(engine.name);
  return names;
}

std::unique_ptr<Device> make_device(std::string_view engine, const MachineProfile& profile) {
  const auto found = std::ranges::find(engines(), engine, &Engine::name);
  if (found != engines().end()) return found->make(profile);
  const std::string names = fmt::format("{}", fmt::join(engine_names(), ", "));
  if (engine == "rtl") {
    throw UsageError("this build has no engine 'rtl': it was configured with HOROPTER_COSIM=OFF; there is: " + names);
  }
  throw UsageError(fmt::format("unknown engine '{}'; expected one of: {}", engine, names));
}

}  // namespace horopter
