// SPDX-License-Identifier: Apache-2.0
// horopter upload: tables, settings and limits into a machine.
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "alarm_frames.hpp"
#include "commands.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/machine/engines.hpp"
#include "horopter/machine/loader.hpp"
#include "horopter/map/map_json.hpp"
#include "inputs.hpp"
#include "numbers.hpp"
#include "object.hpp"
#include "settings.hpp"
#include "thickness.hpp"
#include "warnings.hpp"
#include "words.hpp"

namespace horopter::cli {
namespace {

struct UploadOptions {
  std::string engine;
  std::string map;
  std::string skin;
  std::string rig;
  std::string profile;
  Settings settings;
  ThicknessOption thickness;
  ObjectOption object;
  std::optional<double> results_per_s;
  bool stop_first = false;
  bool json = false;

  [[nodiscard]] const std::string& file() const { return map.empty() ? skin : map; }
};

/// What the user's files want, before any machine is touched.
struct Wanted {
  std::optional<MapSet> table;  ///< a file of its own
  std::optional<calib::Rig> rig;
  std::optional<SkinFiles> files;
};

Wanted read_files(const UploadOptions& options) {
  if (options.map.empty() == options.skin.empty()) throw UsageError("--skin or --map is required, one of both");
  Wanted wanted;
  wanted.rig = read_rig_option(options.rig);
  check_skin_file(options.file());
  wanted.files.emplace(options.file());
  if (is_table(options.file())) wanted.table = load_maps(options.file());
  if (!options.map.empty() && !wanted.table) {
    throw FileError(options.map, "", "this is no table", "a table made by `horopter map`, or --skin for a skin.yaml");
  }
  return wanted;
}

const MachineProfile& first_profile(const UploadOptions& options, const Wanted& wanted) {
  if (wanted.table) return find_profile(wanted.table->profile);
  if (!options.profile.empty()) return find_profile(options.profile);
  if (is_somewhere(options.engine)) return profiles().front();  // the machine says what it is
  throw UsageError(fmt::format("--profile is required with --skin and engine {}", options.engine));
}

MapSet maps_for(const UploadOptions& options, const Wanted& wanted, const Build& build) {
  const MachineProfile& profile = *build.profile;
  const auto belongs = [&](std::string_view name, const std::string& what) {
    if (name == profile.name) return;
    throw FileError(options.file(), "", fmt::format("{} for profile {}", what, name),
                    fmt::format("one for profile {}, as which {} is built", profile.name, options.engine));
  };
  if (wanted.table) belongs(wanted.table->profile, "a table");
  if (!options.profile.empty()) belongs(find_profile(options.profile).name, "--profile, and so a table");
  int width = profile.largest_image_width();
  int height = profile.largest_image_height();
  if (wanted.table) {
    width = wanted.table->image_width;
    height = wanted.table->image_height;
  } else if (wanted.rig && wanted.rig->cameras.front().width_px != 0) {
    width = wanted.rig->cameras.front().width_px;
    height = wanted.rig->cameras.front().height_px;
    check_image_size(options.rig, width, height, profile);
  }
  MapSet maps = load_or_compile_maps(options.file(), wanted.rig, profile, width, height, options.settings.decision);
  const auto tables = maps.tables();
  check_alarm_limit(options.file(), tables, profile, options.settings.decision, options.settings.alarm_percent);
  warn_of_designed_rig(options.file(), maps.rig);
  warn_of_proof(options.file(), tables, profile, maps.lookahead(), options.settings, maps.rig);
  return maps;
}

nlohmann::ordered_json report_json(const UploadOptions& options, const Build& build, const LoadReport& report) {
  nlohmann::ordered_json json;
  json["engine"] = options.engine;
  json["profile"] = build.profile->name;
  json["tables"] = nlohmann::ordered_json::array();
  for (const auto& table : report.tables) {
    json["tables"].push_back({{"slot", table.slot}, {"crc", crc_text(table.crc)}, {"bytes", table.bytes}});
  }
  json["selected"] = report.tables.front().slot;
  json["active"] = report.active;
  json["stopped"] = report.stopped;
  json["changed"] = report.changed;
  add_warnings(json);
  return json;
}

void print_report(const UploadOptions& options, const Build& build, const LoadReport& report) {
  fmt::print("{}: profile {}\n", options.engine, build.profile->name);
  for (const auto& table : report.tables) {
    fmt::print("table     slot {}, CRC {}, {} bytes of the pool's {}: complete, read back\n", table.slot,
               crc_text(table.crc), table.bytes, build.pool_bytes);
  }
  fmt::print("settings  {}\n", report.changed.empty()
                                   ? "as they were"
                                   : fmt::format("changed, and read back: {}", fmt::join(report.changed, ", ")));
  if (report.stopped) fmt::print("          the machine was stopped meanwhile, and said not safe\n");
  if (report.active) {
    fmt::print("active    slot {}: frames are made with it\n", report.tables.front().slot);
  } else {
    fmt::print("selected  slot {}: active with the next frame, none has come yet\n", report.tables.front().slot);
  }
  if (report.tables.size() > 1) {
    fmt::print(
        "          an image is two fields, each with its table: who gives the fields selects, by TABLE_SELECT\n");
  }
}

ExitStatus upload(const UploadOptions& options) {
  const Wanted wanted = read_files(options);
  const auto device = make_device(options.engine, first_profile(options, wanted));
  const Build build = find_build(*device);
  check_rule(build, options.settings.decision);
  const MapSet maps = maps_for(options, wanted, build);
  Settings settings = options.settings;
  settings.results_per_s = options.results_per_s;
  const auto thickness = set_thickness(options.thickness, options.file(), wanted.rig, *build.profile, maps.image_width,
                                       maps.image_height, settings);
  const ObjectOption object = set_object(options.object, options.file(), wanted.rig, *build.profile, maps.image_width,
                                         maps.image_height, settings);
  check_alarm_frames(options.file(), wanted.rig, *build.profile, maps.image_width, maps.image_height,
                     options.results_per_s, settings);
  const Judgeable judgeable = check_object_limit(object, options.file(), maps.tables(), *build.profile, settings);
  wanted.files->check_unchanged();
  const LoadReport report = load(*device, build, maps, settings, options.stop_first);
  if (options.json) {
    auto json = report_json(options, build, report);
    json["object"] = object_json(settings, *build.profile, judgeable);
    if (thickness) json.update(thickness->json());
    report_rows(settings.decision, !maps.rig.empty(), json, true);
    std::puts(json_text(json).c_str());
  } else {
    print_report(options, build, report);
    fmt::print("object    {}\n", object_text(object, settings, *build.profile, judgeable));
    if (thickness) fmt::print("skin      {}\n", thickness->text(settings));
    nlohmann::ordered_json unused;
    report_rows(settings.decision, !maps.rig.empty(), unused, false);
  }
  return ExitStatus::done;
}

}  // namespace

void add_upload(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<UploadOptions>();
  CLI::App* command = app.add_subcommand("upload", "Put a mapping table, settings and limits into a machine");
  add_engine(*command, options->engine)->required();
  command->add_option("--map", options->map, "A table made by `horopter map`")->type_name("FILE");
  command->add_option("--skin", options->skin, "Instead: the skin (skin.yaml), for the profile that the machine has")
      ->type_name("FILE");
  command
      ->add_option("--rig", options->rig,
                   "The cameras (rig.yaml); homographies and correspondences use only the image size")
      ->type_name("FILE");
  command->add_option("--profile", options->profile, "What the machine must be: " + profile_sizes())->type_name("P");
  add_decision(*command, options->settings.decision);
  add_settings(*command, options->settings);
  add_thickness(*command, options->thickness);
  command->get_option("--threshold")->excludes("--tolerance")->excludes("--thickness");
  add_object(*command, options->object);
  add_alarm_frames(*command, options->settings.alarm_frames);
  command
      ->add_option(
          "--frame-rate", options->results_per_s,
          "Results a second, frames or fields of profile field: for --alarm-frames, and for the machine's TIMEOUT, after "
          "which cameras are silent or results late. It is the time of two results (default: of the two largest "
          "frames of the profile, without a pause)")
      ->check(within(0.1, 10'000, "a second"))
      ->type_name("HZ");
  command
      ->add_option_function<std::string>(
          "--restart",
          [options](const std::string& how) {
            auto& interlock = options->settings.interlock;
            interlock.by_itself = how == "none";
            interlock.by_pin = how == "pin";
            interlock.by_register = how == "register";
          },
          "What must happen at start, and after an alarm or a fault, that safe_o rises again: pin, a press of restart_i; "
          "register, `horopter restart`; none, nothing, for what nobody can be inside of")
      ->check(CLI::IsMember({"pin", "register", "none"}))
      ->default_str("pin");
  command
      ->add_option("--restart-after", options->settings.interlock.frames,
                   "Frames without fault and alarm that must lie before a restart")
      ->check(CLI::Range(1, 15))
      ->capture_default_str();
  command
      ->add_option(
          "--feedback", options->settings.interlock.feedback_ms,
          "Contactors hang at safe_o, and their mirror contacts at feedback_i: they must follow within this time, ms, "
          "of the clock that the profile is meant for; 0 = there are none")
      ->check(within(0, 10'000, "ms"))
      ->capture_default_str();
  command->add_flag(
      "--live", options->settings.live,
      "The cameras cannot wait: pixels that cannot be stored are a fault. Without it they are told to wait");
  command->add_flag("--stop-first", options->stop_first,
                    "Stop the machine before the table, which may then take the place of the one in use");
  command->add_flag("--json", options->json, "Print the report as JSON on standard output, and nothing else");
  command->footer(
      "The table goes beside the one in use, which stays in use until the new one is there, complete, by its CRC. Where\n"
      "a setting changes, or the machine was taught with another table, it is stopped for the change: it says not safe,\n"
      "and forgets what it was taught. All is read back. A machine for fields that holds more than one table is stopped\n"
      "first, and they are taken out of it: only who gives the fields knows which two he selects in turn. After an error\n"
      "the table that was in use still is, or the machine is stopped: the message says which. See docs/boards.md.\n\n"
      "Example: horopter upload --engine serial:/dev/ttyUSB0 --map skin.hmap");
  command->callback([options, &outcome] { outcome.status = upload(*options); });
}

}  // namespace horopter::cli
