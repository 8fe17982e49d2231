// SPDX-License-Identifier: Apache-2.0
// horopter teach: the zone is empty, and a running machine learns where nothing can be decided.
#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>

#include "commands.hpp"
#include "horopter/base/error.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/machine/configuration.hpp"
#include "horopter/machine/device.hpp"
#include "horopter/machine/engines.hpp"
#include "horopter/machine/faults.hpp"
#include "horopter/machine/machine_build.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/machine/registers.hpp"
#include "inputs.hpp"
#include "progress.hpp"
#include "settings.hpp"

namespace horopter::cli {
namespace {

namespace reg = registers;

constexpr auto kFrameTimeout = std::chrono::seconds(5);
constexpr auto kPause = std::chrono::milliseconds(20);
constexpr std::uint32_t kUsualFrames = 500;
constexpr std::uint32_t kPatienceFactor = 4;  // times the frames that are asked for
constexpr std::uint32_t kHeard = 3;           // after so many a whole one has begun with what was written before
constexpr const char* kTeaching = "the machine is still teaching, and not safe";

struct TeachOptions {
  std::string engine;
  std::uint32_t frames = kUsualFrames;
  BlindSettings blind;
  bool off = false;
  bool json = false;
};

/// Until `done`, which is told the number of frames since the call. `state` says what the machine does where none come.
template <class Done>
void wait_for_frames(Device& device, const char* state, Done done) {
  const std::uint32_t first = device.read(reg::frame_sequence::kAddress);
  std::uint32_t frames = 0;
  auto last_change = std::chrono::steady_clock::now();
  while (!done(frames)) {
    const std::uint32_t now = device.read(reg::frame_sequence::kAddress) - first;
    if (now != frames) last_change = std::chrono::steady_clock::now();
    if (std::chrono::steady_clock::now() - last_change > kFrameTimeout) {
      throw DeviceError(fmt::format("no frame was finished in {} s; {}", kFrameTimeout.count(), state));
    }
    frames = now;
    std::this_thread::sleep_for(kPause);
  }
}

std::uint32_t taught_frames(Device& device) { return device.read(reg::taught::kAddress); }

void write_blocks(Device& device, BlindSettings blind, bool teach) {
  blind.teach = teach;
  write_checked(device, blocks_word(blind));
}

/// Of the last frame, if it teaches. One that does not may be an alarm because nothing is taught yet.
bool shows_alarm(Device& device) {
  const Faults faults{device.read(reg::frame_faults_cameras::kAddress),
                      device.read(reg::frame_faults_machine::kAddress)};
  return faults.has(Fault::teaching) && reg::frame_status::kSeen.get(device.read(reg::frame_status::kAddress)) != 0;
}

/// A frame with a fault or an alarm makes the machine forget: so many in a row. Where something comes in between, whoever it
/// was may stay, and would be learned with the frames after it. What ends early leaves the machine teaching.
void learn(Device& device, const BlindSettings& blind, std::uint32_t frames) {
  // What was taught before is no part of it. A teaching that is done is forgotten when another one begins; one that is under
  // way, by a fault: a frame in between that does not teach would be judged by it, and could be safe.
  const bool under_way = reg::blocks::kTeach.get(device.read(reg::blocks::kAddress)) != 0;
  write_blocks(device, blind, true);
  if (under_way) take_safe_away(device);
  wait_for_frames(device, kTeaching, [](std::uint32_t passed) { return passed >= kHeard; });
  Progress progress("teaching, frame");
  device.write(reg::faults_cameras::kAddress, 0xFFFFFFFFU);
  device.write(reg::faults_machine::kAddress, 0xFFFFFFFFU);
  const auto fault_names = [&] {
    const Faults faults{device.read(reg::faults_cameras::kAddress), device.read(reg::faults_machine::kAddress)};
    std::string names;
    for (const std::string& name : faults.without(Fault::teaching).names()) names += " " + name;
    return names;
  };
  std::uint32_t taught_before = 0;
  wait_for_frames(device, kTeaching, [&](std::uint32_t passed) {
    const bool alarm = shows_alarm(device);
    const std::uint32_t taught = taught_frames(device);
    progress.show(taught, frames);
    const bool forgot = taught < std::exchange(taught_before, taught);
    if (alarm || forgot) {
      const std::string names = fault_names();
      throw DeviceError(fmt::format(
          "while it learned there was{}{}: somebody may have come, and nothing counts as taught; {}; clear the zone and "
          "teach again",
          alarm || names.empty() ? " an alarm" : "", names, kTeaching));
    }
    if (taught >= frames) return true;
    if (passed <= kPatienceFactor * frames + 20) return false;
    const std::string names = fault_names();
    throw DeviceError(
        fmt::format("{} frames have passed, and {} in a row have not been without fault and alarm;{}{}; {}", passed,
                    frames, names.empty() ? " there was an alarm" : " faults:", names, kTeaching));
  });
}

ExitStatus teach(TeachOptions options) {
  const auto device = make_device(options.engine, profiles().front());
  check_blind(find_build(*device));
  if (!options.off) {
    if (reg::status::kRunning.get(device->read(reg::status::kAddress)) == 0) {
      throw DeviceError("the machine is not running; `horopter upload` starts it");
    }
    options.blind.watch = true;
    learn(*device, options.blind, options.frames);
    write_blocks(*device, options.blind, false);
    // The frame in progress still teaches, and may make it forget.
    wait_for_frames(*device, kTeaching, [](std::uint32_t passed) { return passed >= kHeard; });
    if (taught_frames(*device) < options.frames) {
      throw DeviceError("the last frame that taught had a fault or an alarm, and all is forgotten; teach again");
    }
  } else {
    write_checked(*device, blocks_word(options.blind));
  }
  if (options.json) {
    const nlohmann::ordered_json json{
        {"engine", options.engine}, {"watches", options.blind.watch}, {"frames", options.off ? 0 : options.frames}};
    std::puts(json_text(json).c_str());
  } else if (options.off) {
    fmt::print("{}: does not watch for what goes blind\n", options.engine);
  } else {
    fmt::print("{}: taught by {} frames; what could be decided in them and cannot be any more counts as an object\n",
               options.engine, options.frames);
  }
  return ExitStatus::done;
}

}  // namespace

void add_teach(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<TeachOptions>();
  CLI::App* command =
      app.add_subcommand("teach", "Let a running machine learn where nothing can be decided; the zone is empty");
  add_engine(*command, options->engine)->required();
  command->add_option("--frames", options->frames, "Learn from this many frames: at least a whole cycle of the robot")
      ->check(CLI::Range(1, static_cast<int>(reg::taught::kFrames.mask())))
      ->capture_default_str();
  command
      ->add_option(
          "--margin", options->blind.margin,
          "A block (8x8 px, in hd 16x16) is blind with this many undecidable pixels more than it was taught, in 1/64 "
          "of it")
      ->check(CLI::Range(0, BlindSettings::kLargestMargin))
      ->capture_default_str();
  add_less_light(*command, options->blind);
  command->add_flag("--off", options->off, "Do not watch for what goes blind")->excludes("--frames");
  command->add_flag("--json", options->json, "Print the answer as JSON on standard output, and nothing else");
  command->footer(
      "Where nothing has texture the machine cannot say what is in the skin. So it learns where that is while nobody is in\n"
      "the zone and the robot moves as it will. Afterwards a place that could be decided and cannot be any more is blind, and\n"
      "counts as an object. While it learns, the machine is not safe. An alarm, or a fault after it has begun to learn, is an\n"
      "error: nothing is taught, and the machine goes on teaching. It forgets when it is stopped, by an `upload` of another\n"
      "table or of other settings, too: then everything that cannot be decided counts, until it is taught again.\n\n"
      "Example: horopter teach --engine serial:/dev/ttyUSB0 --frames 3000");
  command->callback([options, &outcome] { outcome.status = teach(*options); });
}

}  // namespace horopter::cli
