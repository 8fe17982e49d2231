// SPDX-License-Identifier: Apache-2.0
// horopter status: what a machine is, does and sees.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "commands.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/image/output.hpp"
#include "horopter/machine/engines.hpp"
#include "horopter/machine/inspection.hpp"
#include "horopter/machine/report.hpp"
#include "inputs.hpp"
#include "settings.hpp"

namespace horopter::cli {
namespace {

constexpr auto kWatchPeriod = std::chrono::seconds(1);
constexpr auto kWatchStep = std::chrono::milliseconds(50);  // how soon it ends when it is asked to

struct StatusOptions {
  std::string engine;
  std::string profile = "vga";
  std::string states;
  std::string runs;
  bool watch = false;
  bool json = false;
};

std::string rules_text(const Build& build) {
  if (build.thesis && build.compete) return "rules thesis and compete";
  return build.thesis ? "rule thesis" : "rule compete";
}

std::string state_text(const MachineStatus& status) {
  if (!status.running()) return "stopped, not safe";
  if (status.safe()) return "running, SAFE";
  const bool waiting = registers::status::kWaiting.get(status.word(registers::status::kAddress)) != 0;
  return waiting ? "running, not safe, waiting for a restart" : "running, not safe";
}

std::string cameras_text(const MachineStatus& status) {
  const char* wait = status.live() ? "live: they cannot wait" : "they wait until their pixels are taken";
  return status.test_input() ? fmt::format("none, but the test input ({}); never safe", wait) : wait;
}

std::string table_text(const MachineStatus& status) {
  const auto slot = status.active_slot();
  if (!slot) return "none is active";
  const auto active = status.active_table();
  const auto contents = [](const StoredTable& table) {
    return fmt::format("CRC {:08x}, {} bytes", table.crc, table.bytes);
  };
  std::string text = fmt::format("slot {} is active, {}, for images of {}x{} px", *slot,
                                 active ? contents(*active) : std::string("but no longer complete"),
                                 status.word(registers::width::kAddress), status.word(registers::height::kAddress));
  for (const StoredTable& table : status.tables) {
    if (table.slot != *slot)
      text += fmt::format("; slot {} holds CRC {:08x}, {} bytes", table.slot, table.crc, table.bytes);
  }
  if (registers::map_status::kBusy.get(status.word(registers::map_status::kAddress)) != 0) {
    text += "; an upload has begun, and is not complete";
  }
  return text;
}

std::string frame_text(const MachineStatus& status) {
  const auto sequence = status.word(registers::frame_sequence::kAddress);
  if (sequence == 0) return "none yet";
  const auto frame = status.word(registers::frame_status::kAddress);
  std::string text =
      fmt::format("{}: {}, {} px in the skin, {} undecidable, {} unsupervised", sequence,
                  registers::frame_status::kAlarm.get(frame) != 0  ? "ALARM"
                  : registers::frame_status::kSafe.get(frame) != 0 ? "safe"
                                                                   : "not safe",
                  status.word(registers::frame_skin::kAddress), status.word(registers::frame_undecidable::kAddress),
                  status.word(registers::frame_unsupervised::kAddress));
  if (!status.one_frame) text += " (of two frames: they come faster than the line reads)";
  return text;
}

void print_faults(const char* head, const Faults& faults) {
  if (!faults.any()) {
    fmt::print("{:9} none\n", head);
    return;
  }
  for (const std::string& name : faults.names()) {
    fmt::print("{:9} {}: {}\n", head, name, fault_text(name));
    head = "";
  }
}

void print_status(const std::string& engine, const MachineStatus& status) {
  const Build& build = status.build;
  fmt::print("machine   {}: profile {}, {}x{} px at most, {}, {} KiB of tables, for a clock of {} kHz\n", engine,
             build.profile->name, build.profile->width, build.profile->height, rules_text(build),
             build.pool_bytes / 1024, status.word(registers::build_clock::kAddress));
  fmt::print("state     {}\n", state_text(status));
  fmt::print("cameras   {}\n", cameras_text(status));
  fmt::print("table     {}\n", table_text(status));
  fmt::print("frame     {}\n", frame_text(status));
  print_faults("its faults", status.frame_faults());
  print_faults("faults", status.faults());
  fmt::print("registers\n");
  for (const std::string& line : register_lines(status)) fmt::print("  {}\n", line);
}

void print_line(const MachineStatus& status) {
  std::string line = fmt::format("{}  table: {}  frame {}", state_text(status), table_text(status), frame_text(status));
  for (const std::string& name : status.frame_faults().names()) line += "  " + name;
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

/// One frame as the machine gives it.
void write_frame(Device& device, const StatusOptions& options) {
  const FrameStreams frame = device.receive();
  if (!options.states.empty()) write_file(options.states, encode_png(state_picture(frame.states)));
  if (options.runs.empty()) return;
  std::string text = "row,start,end,state\n";
  for (const Run& run : frame.runs) {
    text += fmt::format("{},{},{},{}\n", run.row, run.start, run.end, static_cast<int>(run.state));
  }
  write_file(options.runs, text);
}

ExitStatus status(const StatusOptions& options) {
  check_outputs({{"--states", options.states}, {"--runs", options.runs}}, {});
  const bool wants_frame = !options.states.empty() || !options.runs.empty();
  if (wants_frame && !is_somewhere(options.engine)) {
    throw UsageError(fmt::format(
        "engine {} has no frame to show; expected serial:PORT with --states and --runs, or `run`", options.engine));
  }
  const auto device = make_device(options.engine, find_profile(options.profile));
  const auto read = [&] {
    const MachineStatus now = read_status(*device);
    if (options.json) {
      std::puts(options.watch ? json_line(status_json(now)).c_str() : json_text(status_json(now)).c_str());
      std::fflush(stdout);
    } else if (options.watch) {
      print_line(now);
    } else {
      print_status(options.engine, now);
    }
  };
  read();
  if (wants_frame) write_frame(*device, options);
  while (options.watch && !asked_to_stop() && std::ferror(stdout) == 0) {  // where nobody reads, it would keep the port
    const auto next = std::chrono::steady_clock::now() + kWatchPeriod;
    while (std::chrono::steady_clock::now() < next && !asked_to_stop()) std::this_thread::sleep_for(kWatchStep);
    if (!asked_to_stop()) read();
  }
  return ExitStatus::done;
}

}  // namespace

void add_status(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<StatusOptions>();
  CLI::App* command =
      app.add_subcommand("status", "What a machine is, does and sees: its registers and faults in words");
  add_engine(*command, options->engine)->required();
  command->add_option("--profile", options->profile, "Of the engines native and rtl: " + profile_sizes())
      ->type_name("P")
      ->capture_default_str();
  command
      ->add_option("--states", options->states,
                   "A picture (PNG) of the states of one frame, from a machine that gives them")
      ->type_name("FILE");
  command
      ->add_option("--runs", options->runs,
                   "The same as runs, row,start,end,state (0 clear, 1 skin, 2 undecidable, 3 unsupervised)")
      ->type_name("FILE");
  command->add_flag("--watch", options->watch, "A line each second, until stopped, or until nobody reads it");
  command->add_flag("--json", options->json,
                    "Print JSON on standard output, and nothing else; with --watch a line each second");
  command->footer("Example: horopter status --engine serial:/dev/ttyUSB0");
  command->callback([options, &outcome] { outcome.status = status(*options); });
}

}  // namespace horopter::cli
