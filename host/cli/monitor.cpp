// SPDX-License-Identifier: Apache-2.0
// horopter monitor: live cameras in, a latched decision out, until it is asked to stop.
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "alarm_frames.hpp"
#include "commands.hpp"
#include "horopter/base/ending.hpp"
#include "horopter/base/error.hpp"
#include "horopter/image/frames.hpp"
#include "horopter/machine/native_device.hpp"
#include "horopter/monitor/cell.hpp"
#include "horopter/monitor/part.hpp"
#include "horopter/monitor/service.hpp"
#include "horopter/monitor/systemd.hpp"
#include "horopter/plan/plan.hpp"
#include "horopter/plan/tolerance.hpp"
#include "horopter/skin/rig_skin.hpp"
#include "horopter/skin/skin_file.hpp"
#include "inputs.hpp"
#include "numbers.hpp"
#include "object.hpp"
#include "settings.hpp"
#include "thickness.hpp"
#include "warnings.hpp"

namespace horopter::cli {
namespace {

/// Images of files begin so long after the cameras were told to start.
constexpr auto kBegin = std::chrono::milliseconds(300);
/// A thread of an output looks at what it may say that often, at least.
constexpr auto kOutputsTold = std::chrono::milliseconds(100);

struct MonitorOptions {
  std::string cell;
  std::uint64_t frames = 0;
  bool json = false;
};

/// A skin's place in the rig's world, for distances.
struct SkinInSpace {
  SkinFile file;
  const RigSkin* skin = nullptr;
};

std::shared_ptr<SkinInSpace> in_space(const monitor::Cell& cell, const std::optional<calib::Rig>& rig, int width,
                                      int height) {
  if (is_table(cell.skin.string())) return nullptr;
  auto place = std::make_shared<SkinInSpace>();
  place->file = load_skin_for(cell.skin.string(), rig, width, height);
  place->skin = dynamic_cast<const RigSkin*>(place->file.skin.get());
  return place->skin != nullptr ? place : nullptr;
}

/// How far apart two images may be, where cell.yaml does not say.
double skew_ms(const monitor::Cell& cell, const SkinInSpace* place, const MachineProfile& profile,
               const ScanGeometry& geometry, const Settings& settings) {
  if (cell.largest_skew_ms) return *cell.largest_skew_ms;
  const auto fail = [&](const std::string& why) {
    throw FileError(cell.path.string(), "cameras.largest_skew_ms", "missing; " + why, "it in ms");
  };
  if (place == nullptr) fail("without a skin in the rig's world nobody can work it out");
  double tolerance_px = 0;
  try {
    tolerance_px = d95_px(settings);
  } catch (const UsageError& error) {
    fail(error.what());
  }
  const ThicknessPlan plan =
      plan_thickness(place->skin->cameras(), *place->skin->surface(), profile, geometry, tolerance_px);
  const double mm_per_px = plan.least_way_mm * profile.subsample;
  const double most_ms = monitor::largest_skew_ms(tolerance_px, mm_per_px, cell.object_speed_m_s);
  if (!std::isfinite(most_ms)) fail("nothing of the skin is supervised");
  return std::min(most_ms, cell.period_ms() / 2);
}

monitor::Machine make_machine(const monitor::Cell& cell, const std::optional<calib::Rig>& rig, int width, int height) {
  const std::string skin = cell.skin.string();
  const MachineProfile& profile = choose_profile(cell.profile, cell.path.string(), "cameras", width, height);
  Settings settings = cell.settings;
  set_thickness({.tolerance_px = cell.tolerance_px, .thickness_mm = cell.thickness_mm}, skin, rig, profile, width,
                height, settings);
  ObjectOption object;
  object.given = cell.object_px || cell.object_mm;
  object.px = cell.object_px.value_or(object.px);
  object.mm = cell.object_mm;
  object = set_object(object, skin, rig, profile, width, height, settings);
  check_alarm_frames(skin, rig, profile, width, height, cell.frames_per_s * profile.fields_per_image(), settings,
                     monitor::kLongestPeriods);
  auto compiled =
      std::make_shared<const MapSet>(load_or_compile_maps(skin, rig, profile, width, height, settings.decision));
  const MapSet& maps = *compiled;
  const auto tables = maps.tables();
  check_alarm_limit(skin, tables, profile, settings.decision, settings.alarm_percent);
  check_object_limit(object, skin, tables, profile, settings);
  warn_of_designed_rig(skin, maps.rig);
  warn_of_proof(skin, tables, profile, maps.lookahead(), settings, maps.rig);
  const auto place = in_space(cell, rig, width, height);
  const ScanGeometry geometry = scans_of(profile, width, height).front();
  monitor::Machine machine;
  machine.largest_skew_ms = skew_ms(cell, place.get(), profile, geometry, settings);
  machine.objects = std::make_unique<ObjectFollower>(profile, tables, maps.rig);
  if (!maps.rig.empty()) {
    machine.camera_mm = first_pair(calib::rig_from_yaml(maps.rig, skin), skin).left().world_to_camera.centre();
  }
  auto device = cell.engine == "native" ? make_live_native_device(profile) : make_picture_device(cell.engine, profile);
  machine.supervisor = std::make_unique<Supervisor>(std::move(device), profile, maps, settings);
  machine.maps = std::move(compiled);
  // All files have been read: those that run must be those of which every event has the checksum.
  if (monitor::checksum(cell) != cell.crc) {
    throw FileError(cell.path.string(), "", "it, its rig or its skin was changed while the monitor began",
                    "files that stay as they are until it has begun; begin it again");
  }
  return machine;
}

std::vector<std::unique_ptr<monitor::Camera>> start_cameras(const monitor::Cell& cell, monitor::CameraSink& sink) {
  std::vector<std::unique_ptr<monitor::Camera>> cameras;
  const auto begin = monitor::Clock::now() + kBegin;
  const std::size_t sources = cell.layout == monitor::Layout::single ? 2 : 1;
  for (std::size_t i = 0; i < sources; ++i) {
    cameras.push_back(monitor::start_camera(static_cast<monitor::Side>(i), cell.layout,
                                            {.camera = cell.cameras.at(i),
                                             .frames_per_s = cell.frames_per_s,
                                             .stamps = cell.stamps,
                                             .directory = cell.path.parent_path().string(),
                                             .begin = begin},
                                            sink));
  }
  return cameras;
}

/// Says where something waits for somebody who cannot come: only the page takes a restart, or teaches.
void warn_of_nobody(const monitor::Cell& cell) {
  const bool log_in = cell.web && !cell.web->users_file.empty();
  if (cell.settings.interlock.by_register && !(log_in && cell.web->restart)) {
    warn(
        "nobody can restart this cell, so it is never safe: expected `web: {users_file: …, restart: true}`, or "
        "`restart: by_itself` where nobody can be inside");
  }
  if (cell.teach.needed && !log_in) {
    warn(
        "nobody can teach this cell, so everything that cannot be decided counts as an object: expected "
        "`web: {users_file: …}`");
  }
}

/// Two lines say nothing of who sets them.
void warn_of_lines(const monitor::Cell& cell) {
  if (!cell.outputs.gpio || cell.outputs.gpio->pulse_line >= 0) return;
  warn(
      "outputs.gpio has no pulse_line: a monitor that is stopped or killed may leave safe_line at 1, and nothing shows it; "
      "expected `pulse_line: …`, and on it a relay that falls off when it stands still");
}

/// What could only be said with the first image, if at all. Throws FileError.
void check_files(const monitor::Cell& cell, bool has_rig) {
  const std::string scheme = "files:";
  std::vector<std::string> patterns;
  for (const monitor::CameraCell& camera : cell.cameras) {
    if (!camera.source.starts_with(scheme)) continue;
    patterns.push_back((cell.path.parent_path() / camera.source.substr(scheme.size())).string());
    for (const std::string& text : open_frames({patterns.back()})->warnings()) warn(text);
  }
  if (cell.layout == monitor::Layout::single && patterns.size() == 2) PairSource({patterns[0]}, {patterns[1]});
  const std::string skin = cell.skin.string();
  if (has_rig || is_table(skin)) return;
  try {
    load_skin(skin, {}, nullptr);
  } catch (const UsageError&) {
    throw FileError(cell.path.string(), "rig", "missing: this skin is seen through cameras", "the cameras (rig.yaml)");
  }
}

ExitStatus run_monitor(const MonitorOptions& options) {
  const monitor::Cell cell = monitor::load_cell(options.cell);
  warn_of_lines(cell);
  monitor::set_outputs_not_safe(cell);
  const auto rig = read_rig_option(cell.rig.string());
  check_skin_file(cell.skin.string());
  check_files(cell, rig.has_value());
  if (is_moving_skin(cell.skin.string())) {
    throw FileError(cell.skin.string(), "motion", "a skin that moves", "one that does not: only `run` moves skins");
  }
  const int width = rig && !rig->cameras.empty() ? rig->cameras.front().width_px : 0;
  const int height = width != 0 ? rig->cameras.front().height_px : 0;
  const auto machine = [&](int columns, int rows) {
    try {
      return make_machine(cell, rig, columns, rows);
    } catch (const UsageError& error) {  // what an option would say, of a key
      throw FileError(cell.path.string(), "limits", error.what(), "limits that this skin and profile can have");
    }
  };
  monitor::Service service(cell, machine, width, height);
  if (cell.settings.interlock.by_itself)
    warn("restart: by itself; after an alarm or a fault nobody has to say that all is well");
  warn_of_nobody(cell);
  const auto parts = monitor::make_parts(cell, service.safe_state(), service,
                                         options.json ? monitor::Lines::json : monitor::Lines::text);
  for (const auto& part : parts) service.add(part.get());
  const BeforeEnding before_ending([&] {
    service.end_unsafe();
    std::this_thread::sleep_for(kOutputsTold);
  });
  monitor::SystemdNotice systemd;
  service.on_turn([&] { systemd.turn(monitor::Clock::now()); });
  {
    const auto cameras = start_cameras(cell, service);
    service.run(asked_to_stop, options.frames);
    monitor::SystemdNotice::stopping();
  }
  if (service.status().frame == 0 && !asked_to_stop()) {
    throw FileError(cell.path.string(), "cameras", "all images were over before the first pair was judged",
                    "a longer recording, or `repeat: true`");
  }
  return ExitStatus::done;
}

}  // namespace

void add_monitor(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<MonitorOptions>();
  CLI::App* command =
      app.add_subcommand("monitor", "Supervise live cameras: outputs, restart and teaching, until it is stopped");
  command->add_option("cell", options->cell, "cell.yaml: cameras, skin, limits, outputs")
      ->required()
      ->type_name("FILE");
  command->add_option("--frames", options->frames, "Stop after this many pairs (default: run until stopped)")
      ->check(at_least_one())
      ->type_name("N");
  command->add_flag("--json", options->json, "Print each event as a line of JSON on standard output, and nothing else");
  command->footer(
      monitor::cell_help() +
      "\nSIGINT or SIGTERM ends it: the outputs go unsafe first, and the exit status is 0. It is 3 for a bad\n"
      "file and where the files end before a pair was judged, and 4 where the machine has failed.\n\n"
      "Example: horopter monitor cell.yaml");
  command->callback([options, &outcome] { outcome.status = run_monitor(*options); });
}

}  // namespace horopter::cli
