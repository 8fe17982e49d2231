// SPDX-License-Identifier: Apache-2.0
// horopter log: what a monitor's event log says, whether it is as it was written, and single events as files.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "commands.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/monitor/log_reader.hpp"

namespace horopter::cli {
namespace {

struct LogOptions {
  std::string directory;
  bool json = false;
  bool check = false;
  std::vector<std::string> to_export;  ///< number, place
};

nlohmann::ordered_json reading_json(const LogOptions& options, const monitor::LogReading& reading) {
  nlohmann::ordered_json json{
      {"log", options.directory},     {"in_use", reading.in_use}, {"pictures_checked", options.check},
      {"problems", reading.problems}, {"notes", reading.notes},   {"events", nlohmann::ordered_json::array()}};
  for (const auto& event : reading.events) {
    nlohmann::ordered_json entry = event.json;
    entry["pictures"] = nlohmann::ordered_json::array();
    for (const auto& picture : event.pictures) {
      entry["pictures"].push_back({{"name", picture.name}, {"bytes", picture.bytes}, {"sha256", picture.sha256}});
    }
    json["events"].push_back(std::move(entry));
  }
  return json;
}

/// No more than a line, whatever somebody gave as his name.
std::string one_line(std::string text) {
  std::ranges::replace_if(text, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, ' ');
  return text;
}

void print_events(const monitor::LogReading& reading) {
  for (const auto& event : reading.events) {
    std::string text = one_line(event.text);
    const auto by = event.json.find("by");
    if (by != event.json.end() && by->is_object()) text += one_line(" By " + by->value("name", "?") + ".");
    if (!event.pictures.empty()) text += fmt::format(" {} pictures.", event.pictures.size());
    fmt::print("{:6}  {}  {:14} {}\n", event.number, one_line(event.time), one_line(event.kind), text);
  }
}

void print_check(const LogOptions& options, const monitor::LogReading& reading) {
  for (const std::string& note : reading.notes) fmt::print("note: {}\n", note);
  for (const std::string& problem : reading.problems) fmt::print("problem: {}\n", problem);
  if (options.check && reading.problems.empty()) {
    std::size_t pictures = 0;
    for (const auto& event : reading.events) pictures += event.pictures.size();
    fmt::print("{} events and {} pictures are as they were written\n", reading.events.size(), pictures);
  }
}

void export_one(const LogOptions& options, const monitor::LogReading& reading) {
  const auto found = std::ranges::find_if(
      reading.events, [&](const auto& event) { return std::to_string(event.number) == options.to_export[0]; });
  if (found == reading.events.end()) {
    throw UsageError(fmt::format("there is no event {} in {}; `horopter log {}` lists them", options.to_export[0],
                                 options.directory, options.directory));
  }
  monitor::export_event(options.directory, *found, options.to_export[1]);
}

ExitStatus log(const LogOptions& options) {
  const monitor::LogReading reading = monitor::read_log(options.directory, options.check);
  if (!options.to_export.empty()) export_one(options, reading);
  if (options.json) {
    std::puts(json_text(reading_json(options, reading)).c_str());
  } else {
    if (!options.check && options.to_export.empty()) print_events(reading);
    print_check(options, reading);
  }
  return reading.problems.empty() ? ExitStatus::done : ExitStatus::check_failed;
}

}  // namespace

void add_log(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<LogOptions>();
  CLI::App* command = app.add_subcommand("log", "What the event log of `monitor` says; checks it, and exports events");
  command->add_option("DIR", options->directory, "The log's directory")->required();
  command->add_flag("--check", options->check,
                    "Also look at each picture; the journal's chain is always checked. Exit status 1 if anything was\n"
                    "changed, removed or damaged");
  command
      ->add_option("--export", options->to_export,
                   "Event N with its pictures into the file OUT.zip, or into the directory OUT, which is new or empty")
      ->type_name("N OUT")
      ->expected(2);
  command->add_flag("--json", options->json, "Print JSON on standard output, and nothing else");
  command->footer("Example: horopter log /var/lib/horopter/log --export 12 event12.zip");
  command->callback([options, &outcome] { outcome.status = log(*options); });
}

}  // namespace horopter::cli
