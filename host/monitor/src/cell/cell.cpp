// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "cell/keys.hpp"
#include "horopter/base/crc32.hpp"
#include "horopter/base/error.hpp"
#include "horopter/base/file.hpp"
#include "horopter/machine/engines.hpp"
#include "horopter/machine/registers.hpp"
#include "horopter/map/map.hpp"
#include "horopter/monitor/camera.hpp"
#include "horopter/skin/skin_file.hpp"

namespace horopter::monitor {
namespace {

const char* const kExpected = "a cell: `cameras`, `skin` and more";

/// Periods after which a decision says nothing any more: the next one may be as late as one image and its own time.
constexpr double kDecisionPeriods = 2.5;
/// Below it, a computer without real time misses the limit now and then.
constexpr double kShortestUsual_ms = 60;
/// As DNS has it.
constexpr std::size_t kLongestHostName = 253;

CameraCell read_camera(Keys keys, const std::string& name) {
  CameraCell camera;
  const std::string expected = source_help();
  camera.source = keys.text("source", expected);
  if (const std::string problem = source_problem(camera.source); !problem.empty()) {
    keys.fail("source", problem, expected);
  }
  camera.name = keys.text_or("name", name, "the camera's name in the rig");
  const bool has_features = is_genicam(camera.source);
  if (keys.has("features")) {
    if (!has_features) keys.fail("features", "this source has none", "them with gev: only");
    Keys features = keys.map("features");
    for (const auto& item : features.node()) {
      const std::string feature = item.first.Scalar();
      camera.features[feature] = features.text(feature, "a value");
    }
  }
  if (keys.has("trigger")) {
    if (!has_features) keys.fail("trigger", "this source has none", "it with gev: only");
    camera.trigger = keys.text("trigger", "a TriggerSource of the camera, as Line1");
  }
  if (keys.has("serial")) {
    if (!has_features) keys.fail("serial", "this source has none", "it with gev: only");
    camera.serial = keys.text("serial", "the camera's serial number");
  }
  if (keys.has("repeat") && !camera.source.starts_with("files:")) {
    keys.fail("repeat", "this source cannot begin again", "it with files: only");
  }
  camera.repeat = keys.flag("repeat");
  camera.exposure_may_change = keys.flag("exposure_may_change");
  keys.finish();
  return camera;
}

void read_cameras(Keys keys, Cell& cell) {
  cell.frames_per_s = keys.number("frames_per_s", 0.1, 1000, "a second");
  if (keys.has("largest_skew_ms")) cell.largest_skew_ms = keys.number("largest_skew_ms", 0.001, 1000, "ms");
  if (cell.largest_skew_ms && 2 * *cell.largest_skew_ms > cell.period_ms()) {
    keys.fail("largest_skew_ms", "",
              fmt::format("at most half of the time between images, {:g} ms", cell.period_ms() / 2));
  }
  cell.stamps = keys.word("stamps", "arrival", {"arrival", "camera"}) == "camera" ? Stamps::camera : Stamps::arrival;
  if (keys.has("both")) {
    keys.exclude("both", "left");
    keys.exclude("both", "right");
    cell.layout = Layout::side_by_side;
    cell.cameras = {read_camera(keys.map("both"), "left"), CameraCell{}};
    cell.cameras[1].name = "right";
    cell.cameras[1].source = cell.cameras[0].source;
    cell.cameras[1].serial = cell.cameras[0].serial;
    cell.cameras[1].exposure_may_change = cell.cameras[0].exposure_may_change;
  } else {
    cell.cameras = {read_camera(keys.map("left"), "left"), read_camera(keys.map("right"), "right")};
    if (cell.cameras[0].source == cell.cameras[1].source) {
      keys.fail("right", "its source is that of the left camera", "the other camera");
    }
    if (!cell.cameras[0].serial.empty() && cell.cameras[0].serial == cell.cameras[1].serial) {
      keys.fail("right", "its serial number is that of the left camera", "the other camera's");
    }
  }
  if (cell.stamps == Stamps::camera && !std::ranges::all_of(cell.cameras, is_genicam, &CameraCell::source)) {
    keys.fail("stamps", "these sources have no clock of a camera", "it with gev: only");
  }
  keys.finish();
}

void read_size(Keys& keys, Cell& cell) {
  if (!keys.has("object")) return;
  const double smallest_px = smallest_object_px();
  const std::string expected = fmt::format("{:g}px to 1000px, 5mm to 2000mm, or 0", smallest_px);
  const std::string text = keys.text("object", expected);
  const bool in_mm = text.ends_with("mm");
  const bool in_px = text.ends_with("px");
  double value = 0;
  const YAML::Node number(text.substr(0, text.size() - (in_mm || in_px ? 2 : 0)));
  if (!YAML::convert<double>::decode(number, value)) keys.fail("object", "", expected);
  const bool good =
      in_mm ? value >= 5 && value <= 2000 : value == 0 || (in_px && value >= smallest_px && value <= 1000);
  if (!good) keys.fail("object", "", expected);
  (in_mm ? cell.object_mm : cell.object_px) = value;
}

void read_limits(Keys keys, Cell& cell) {
  Settings& settings = cell.settings;
  const auto percent = [&](const std::string& key, double smallest, double& value) {
    if (keys.has(key)) value = keys.number(key, smallest, 100, "%");
  };
  percent("threshold_percent", 0.1, settings.threshold_percent);
  keys.exclude("tolerance_px", "thickness_mm");
  keys.exclude("threshold_percent", "tolerance_px");
  keys.exclude("threshold_percent", "thickness_mm");
  if (keys.has("tolerance_px")) cell.tolerance_px = keys.number("tolerance_px", 0.01, 100, "px");
  if (keys.has("thickness_mm")) cell.thickness_mm = keys.number("thickness_mm", 0.01, 1e4, "mm");
  if (keys.has("texture")) settings.texture = keys.whole("texture", 0, 255, "");
  percent("alarm_percent", 0, settings.alarm_percent);
  percent("undecidable_percent", 0, settings.undecidable_percent);
  percent("unsupervised_percent", 0, settings.unsupervised_percent);
  if (keys.has("frozen_frames")) settings.frozen_limit = keys.whole("frozen_frames", 0, 255, "frames");
  if (keys.has("hidden_frames")) settings.proof.hidden_frames = keys.whole("hidden_frames", 0, 128, "frames");
  if (keys.flag("still_scene")) settings.still_limit = 0;
  if (keys.flag("unproven")) settings.proof.needed = false;
  read_size(keys, cell);
  if (keys.has("alarm_frames")) {
    const std::string expected = "N/M, N of the last M frames, as in 2/3";
    try {
      settings.alarm_frames = AlarmFrames::parse(keys.text("alarm_frames", expected));
    } catch (const UsageError&) {
      keys.fail("alarm_frames", "", expected);
    }
  }
  if (keys.has("object_speed_m_s")) cell.object_speed_m_s = keys.number("object_speed_m_s", 0.001, 100, "m/s");
  if (keys.has("decision_ms")) cell.decision_limit_ms = keys.number("decision_ms", 1, 60'000, "ms");
  keys.finish();
}

void read_teach(Keys keys, TeachCell& teach) {
  teach.needed = keys.flag("needed");
  constexpr int kMostFrames = registers::taught::kFrames.mask();
  if (keys.has("frames")) teach.frames = keys.whole("frames", 1, kMostFrames, "frames");
  if (keys.has("margin")) teach.margin = keys.whole("margin", 0, BlindSettings::kLargestMargin, "");
  teach.less_light = keys.flag("less_light");
  keys.finish();
}

ModbusCell read_modbus(Keys keys) {
  ModbusCell modbus;
  modbus.address = keys.text_or("address", modbus.address, "the address to listen at");
  if (keys.has("port")) modbus.port = keys.whole("port", 0, 65'535, "");
  keys.finish();
  return modbus;
}

/// `name`: that cell.yaml gives; empty where it gives none.
MqttCell read_mqtt(Keys keys, const std::string& name) {
  MqttCell mqtt;
  mqtt.host = keys.text("host", "the broker's name or address");
  const bool tls = keys.has("ca_file");
  mqtt.port = keys.has("port") ? keys.whole("port", 1, 65'535, "") : tls ? 8883 : 1883;
  // Of two cells by one topic, one that lives would hide that the other one is gone; and the file's name is often the same.
  if (!keys.has("topic") && name.empty()) {
    keys.fail("topic", "missing", "it, or a `name` of the cell for horopter/NAME");
  }
  mqtt.topic = keys.text_or("topic", "horopter/" + name, "the topic before /state and /event");
  if (mqtt.topic.find_first_of("#+") != std::string::npos) {
    keys.fail("topic", fmt::format("'{}'", mqtt.topic), "a topic without # and +");
  }
  mqtt.client_id = keys.text_or("client_id", "", "the name by which the broker knows this client");
  if (tls) mqtt.ca_file = keys.existing("ca_file", "the certificate of who signed the broker's");
  for (const char* key : {"certificate_file", "key_file"}) {
    if (keys.has(key) && !tls) keys.fail(key, "without ca_file", "ca_file beside it");
  }
  if (keys.has("certificate_file") != keys.has("key_file")) {
    keys.fail("certificate_file", "one of certificate_file and key_file", "both or none");
  }
  if (keys.has("certificate_file")) {
    mqtt.certificate_file = keys.existing("certificate_file", "this client's certificate");
    mqtt.key_file = keys.existing("key_file", "its key");
  }
  if (keys.has("user") != keys.has("password_file")) {
    keys.fail("user", "one of user and password_file", "both or none");
  }
  if (keys.has("user")) {
    mqtt.user = keys.text("user", "a name");
    mqtt.password_file = keys.existing("password_file", "a file with the password in its first line");
  }
  keys.finish();
  return mqtt;
}

GpioCell read_gpio(Keys keys) {
  GpioCell gpio;
  gpio.chip = keys.text("chip", "a chip, as /dev/gpiochip0");
  gpio.safe_line = keys.whole("safe_line", 0, 10'000, "");
  gpio.unsafe_line = keys.whole("unsafe_line", 0, 10'000, "");
  if (gpio.safe_line == gpio.unsafe_line) keys.fail("unsafe_line", "", "another line than safe_line");
  if (keys.has("pulse_line")) gpio.pulse_line = keys.whole("pulse_line", 0, 10'000, "");
  if (gpio.pulse_line == gpio.safe_line || gpio.pulse_line == gpio.unsafe_line) {
    keys.fail("pulse_line", "", "another line than safe_line and unsafe_line");
  }
  keys.finish();
  return gpio;
}

void read_outputs(Keys keys, const std::string& name, OutputsCell& outputs) {
  if (keys.has("modbus")) outputs.modbus = read_modbus(keys.map("modbus"));
  if (keys.has("mqtt")) outputs.mqtt = read_mqtt(keys.map("mqtt"), name);
  if (keys.has("gpio")) outputs.gpio = read_gpio(keys.map("gpio"));
  keys.finish();
}

LogCell read_log(Keys keys) {
  LogCell log;
  log.directory = keys.beside(keys.text("directory", "a directory for events and pictures"));
  if (keys.has("size_mb")) log.size_mb = keys.number("size_mb", 10, 1e7, "MB");
  keys.finish();
  return log;
}

bool is_host_name(const std::string& name) {
  return !name.empty() && name.size() <= kLongestHostName && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '.';
  });
}

WebCell read_web(Keys keys) {
  WebCell web;
  web.listen = keys.text_or("listen", web.listen, "an address and a port, as 127.0.0.1:8080");
  const auto colon = web.listen.rfind(':');
  int port = 0;
  const bool is_port = colon != std::string::npos && colon != 0 &&
                       YAML::convert<int>::decode(YAML::Node(web.listen.substr(colon + 1)), port) && port >= 0 &&
                       port <= 65'535;
  if (!is_port) keys.fail("listen", "", "an address and a port, as 127.0.0.1:8080");
  if (keys.has("users_file")) web.users_file = keys.existing("users_file", "a file of users");
  if (keys.has("tls")) {
    Keys tls = keys.map("tls");
    web.tls = TlsCell{tls.existing("certificate_file", "a certificate"), tls.existing("key_file", "its key")};
    tls.finish();
  }
  if (keys.has("names")) {
    web.names = keys.texts("names", is_host_name, "a list of host names without ports, as [press3.example.com]");
  }
  web.restart = keys.flag("restart");
  keys.finish();
  return web;
}

/// `own`: the bytes of the cell's file.
std::uint32_t checksum_of(const Cell& cell, std::span<const std::uint8_t> own) {
  Crc32 crc;
  const auto add = [&](std::span<const std::uint8_t> bytes) {
    crc.add_word(static_cast<std::uint32_t>(bytes.size()));
    crc.add(bytes);
  };
  const std::string expected = "a file of the cell";
  add(own);
  if (!cell.rig.empty()) add(read_file(cell.rig, expected));
  add_skin_files(cell.skin, expected, crc);
  return crc.value();
}

}  // namespace

std::uint32_t checksum(const Cell& cell) { return checksum_of(cell, read_file(cell.path, kExpected)); }

Cell load_cell(const std::filesystem::path& path) {
  const std::string file = path.string();
  const auto bytes = read_file(path, kExpected);
  Keys keys(file, calib::yaml::parse(file, {bytes.begin(), bytes.end()}, kExpected), "");
  Cell cell;
  cell.path = path;
  cell.name = keys.text_or("name", path.stem().string(), "a name for people");
  read_cameras(keys.map("cameras"), cell);
  if (keys.has("rig")) cell.rig = keys.existing("rig", "the cameras (rig.yaml)");
  cell.skin = keys.existing("skin", "the skin: skin.yaml, or a table made by `horopter map`");
  cell.profile = keys.text_or("profile", "", profile_names());
  if (!cell.profile.empty()) {
    try {
      find_profile(cell.profile);
    } catch (const UsageError& error) {
      keys.fail("profile", error.what(), profile_names());
    }
  }
  cell.engine = keys.text_or("engine", cell.engine, engine_help());
  try {
    check_engine(cell.engine);
  } catch (const UsageError& error) {
    keys.fail("engine", error.what(), engine_help());
  }
  const std::string thesis(name_of(Decision::thesis)), compete(name_of(Decision::compete));
  cell.settings.decision =
      keys.word("decision", thesis, {thesis, compete}) == compete ? Decision::compete : Decision::thesis;
  if (keys.has("limits")) read_limits(keys.map("limits"), cell);
  if (cell.decision_limit_ms == 0) {
    cell.decision_limit_ms = std::max(kShortestUsual_ms, kDecisionPeriods * cell.period_ms());
  }
  if (cell.decision_limit_ms < cell.period_ms()) {
    keys.fail("limits", fmt::format("decision_ms {:g}", cell.decision_limit_ms),
              fmt::format("at least the time between images, {:g} ms", cell.period_ms()));
  }
  if (cell.settings.decision == Decision::compete && cell.settings.threshold_percent != Settings{}.threshold_percent) {
    keys.fail("limits", "threshold_percent with the rule compete", "tolerance_px or thickness_mm");
  }
  if (keys.has("teach")) read_teach(keys.map("teach"), cell.teach);
  cell.settings.blind = {
      .watch = cell.teach.needed, .teach = false, .margin = cell.teach.margin, .dim = cell.teach.less_light};
  cell.settings.live = true;
  const bool by_itself = keys.word("restart", "register", {"register", "by_itself"}) == "by_itself";
  cell.settings.interlock.by_itself = by_itself;
  cell.settings.interlock.by_pin = false;
  cell.settings.interlock.by_register = !by_itself;
  if (keys.has("restart_after")) cell.settings.interlock.frames = keys.whole("restart_after", 1, 15, "frames");
  const bool has_name = keys.has("name");
  if (keys.has("outputs")) read_outputs(keys.map("outputs"), has_name ? cell.name : "", cell.outputs);
  if (keys.has("log")) cell.log = read_log(keys.map("log"));
  if (keys.has("web")) cell.web = read_web(keys.map("web"));
  keys.finish();
  cell.crc = checksum_of(cell, bytes);
  return cell;
}

double largest_skew_ms(double tolerance_px, double mm_per_px, double object_speed_m_s) {
  return tolerance_px * mm_per_px / object_speed_m_s;  // mm / (m/s) = ms
}

std::string without_secrets(const std::string& source) {
  std::string text = source;
  for (std::size_t at = 0; (at = text.find("://", at)) != std::string::npos; at += 3) {
    const auto begin = at + 3;
    const auto end = text.find_first_of("/ \"'", begin);
    const auto mark = text.rfind('@', end == std::string::npos ? text.size() : end);
    if (mark != std::string::npos && mark > begin) text.replace(begin, mark - begin, "…");
  }
  for (const std::string key : {"user-pw=", "password=", "user-id=", "passphrase="}) {
    for (std::size_t at = 0; (at = text.find(key, at)) != std::string::npos; at += key.size()) {
      const auto begin = at + key.size();
      text.replace(begin, std::min(text.find_first_of(" !", begin), text.size()) - begin, "…");
    }
  }
  return text;
}

std::string cell_help() {
  return "cell.yaml, of which docs/monitor.md has every key:\n"
         "  cameras: {left: {source: …}, right: {source: …}, frames_per_s: 25}\n"
         "  rig: rig.yaml\n"
         "  skin: skin.yaml\n"
         "  restart: register       # on the page; or by_itself, where nobody can be inside\n"
         "  web: {users_file: users, restart: true}      # the page; `horopter monitor-user` makes the users\n"
         "  outputs: {modbus: {port: 502}}\n"
         "A source is one of these:\n  " +
         source_help() + "\n";
}

}  // namespace horopter::monitor
