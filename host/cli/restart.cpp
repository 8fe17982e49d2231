// SPDX-License-Identifier: Apache-2.0
// horopter restart: somebody has looked, and the machine may say safe again.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "commands.hpp"
#include "horopter/machine/engines.hpp"
#include "horopter/machine/inspection.hpp"
#include "horopter/machine/machine_build.hpp"
#include "horopter/machine/registers.hpp"
#include "inputs.hpp"
#include "settings.hpp"

namespace horopter::cli {
namespace {

namespace reg = registers;

/// safe_o rises with the next good frame.
constexpr auto kPatience = std::chrono::seconds(2);
constexpr auto kStep = std::chrono::milliseconds(20);

ExitStatus restart(const std::string& engine) {
  const auto device = make_device(engine, profiles().front());
  find_build(*device);  // or it is no Horopter
  const auto refuse = [&](const std::string& why) {
    fmt::print("{}: not restarted: {}\n", engine, why);
    return ExitStatus::fault;
  };
  const auto before = device->read(reg::status::kAddress);
  if (says_safe(before)) {
    fmt::print("{}: SAFE already\n", engine);
    return ExitStatus::done;
  }
  const auto interlock = device->read(reg::interlock::kAddress);
  if (reg::interlock::kByRegister.get(interlock) == 0) {
    return refuse("its settings do not allow a restart from here; `horopter upload --restart register` does");
  }
  if (reg::status::kWaiting.get(before) == 0) {
    return refuse(fmt::format("its last {} frames were not all without fault and alarm; `horopter status` says why",
                              reg::interlock::kFrames.get(interlock)));
  }
  device->write(reg::restart::kAddress, reg::kRestartKey);
  for (auto waited = std::chrono::milliseconds(0); waited < kPatience; waited += kStep) {
    if (says_safe(device->read(reg::status::kAddress))) {
      fmt::print("{}: restarted, SAFE\n", engine);
      return ExitStatus::done;
    }
    std::this_thread::sleep_for(kStep);
  }
  return refuse("a frame with a fault or an alarm came in between, or none");
}

}  // namespace

void add_restart(CLI::App& app, Outcome& outcome) {
  auto engine = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("restart", "Say that a machine may be safe again after an alarm or a fault");
  add_engine(*command, *engine)->required();
  command->footer(
      "Look first whether somebody is inside: what has crossed the skin is no longer seen. The machine takes a restart\n"
      "only after good frames, and only where `horopter upload --restart register` has allowed it.\n\n"
      "Example: horopter restart --engine serial:/dev/ttyUSB0");
  command->callback([engine, &outcome] { outcome.status = restart(*engine); });
}

}  // namespace horopter::cli
