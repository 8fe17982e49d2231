// SPDX-License-Identifier: Apache-2.0
// horopter restart: somebody has looked, and the machine may say safe again.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "commands.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/machine/device.hpp"
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

struct RestartOptions {
  std::string engine;
  bool json = false;
};

struct RestartAnswer {
  bool restarted = false;
  bool safe = false;
  std::string reason;  ///< why it was not restarted
};

RestartAnswer restart(Device& device) {
  const auto before = device.read(reg::status::kAddress);
  if (says_safe(before)) return {.restarted = false, .safe = true, .reason = {}};
  const auto refused = [](const std::string& why) {
    return RestartAnswer{.restarted = false, .safe = false, .reason = why};
  };
  const auto interlock = device.read(reg::interlock::kAddress);
  if (reg::interlock::kByRegister.get(interlock) == 0) {
    return refused("its settings do not allow a restart from here; `horopter upload --restart register` does");
  }
  if (reg::status::kWaiting.get(before) == 0) {
    return refused(fmt::format("its last {} frames were not all without fault and alarm; `horopter status` says why",
                               reg::interlock::kFrames.get(interlock)));
  }
  device.write(reg::restart::kAddress, reg::kRestartKey);
  for (auto waited = std::chrono::milliseconds(0); waited < kPatience; waited += kStep) {
    if (says_safe(device.read(reg::status::kAddress))) return {.restarted = true, .safe = true, .reason = {}};
    std::this_thread::sleep_for(kStep);
  }
  return refused("a frame with a fault or an alarm came in between, or none");
}

void print_answer(const RestartOptions& options, const RestartAnswer& answer) {
  if (options.json) {
    nlohmann::ordered_json json{
        {"engine", options.engine}, {"restarted", answer.restarted}, {"safe", answer.safe}, {"reason", nullptr}};
    if (!answer.safe) json["reason"] = answer.reason;
    std::puts(json_text(json).c_str());
  } else if (!answer.safe) {
    fmt::print("{}: not restarted: {}\n", options.engine, answer.reason);
  } else {
    fmt::print("{}: {}\n", options.engine, answer.restarted ? "restarted, SAFE" : "SAFE already");
  }
}

ExitStatus restart(const RestartOptions& options) {
  const auto device = make_device(options.engine, profiles().front());
  find_build(*device);  // or it is no Horopter
  const RestartAnswer answer = restart(*device);
  print_answer(options, answer);
  return answer.safe ? ExitStatus::done : ExitStatus::fault;
}

}  // namespace

void add_restart(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<RestartOptions>();
  CLI::App* command = app.add_subcommand("restart", "Say that a machine may be safe again after an alarm or a fault");
  add_engine(*command, options->engine)->required();
  command->add_flag("--json", options->json, "Print the answer as JSON on standard output, and nothing else");
  command->footer(
      "Look first whether somebody is inside: what has crossed the skin is no longer seen. The machine takes a restart\n"
      "only after good frames, and only where `horopter upload --restart register` has allowed it.\n\n"
      "Example: horopter restart --engine serial:/dev/ttyUSB0");
  command->callback([options, &outcome] { outcome.status = restart(*options); });
}

}  // namespace horopter::cli
