// SPDX-License-Identifier: Apache-2.0
// cell.yaml: what it says is what is read, and what it should not say is refused by name.
#include <catch2/catch.hpp>
#include <fstream>
#include <string>
#include <vector>

#include "horopter/base/error.hpp"
#include "horopter/monitor/cell.hpp"
#include "host_temporary.hpp"

using namespace horopter::monitor;

namespace {

const std::string kCameras =
    "cameras:\n  left: {source: 'files:l*.png'}\n  right: {source: 'files:r*.png'}\n  frames_per_s: 25\n";
const std::string kSkin = "skin: skin.yaml\n";

struct Files {
  Files() {
    write("skin.yaml", "surface:\n");
    write("rig.yaml", "cameras:\n");
    write("empty", "x");
  }
  void write(const std::string& name, const std::string& text) const { std::ofstream(directory / name) << text; }
  Cell load(const std::string& text) const {
    write("cell.yaml", text);
    return load_cell(directory / "cell.yaml");
  }
  std::string refused(const std::string& text) const {
    CAPTURE(text);
    try {
      load(text);
    } catch (const horopter::FileError& error) {
      return error.what();
    }
    return "";
  }
  horopter::TemporaryDirectory directory;
};

}  // namespace

TEST_CASE("the least that a cell says, and what it then is") {
  const Files files;
  const Cell cell = files.load(kCameras + kSkin);
  CHECK(cell.name == "cell");
  CHECK(cell.cameras[0].source == "files:l*.png");
  CHECK(cell.cameras[1].name == "right");
  CHECK(cell.engine == "native");
  CHECK(cell.settings.live);
  CHECK(cell.settings.interlock.by_register);
  CHECK_FALSE(cell.settings.interlock.by_itself);
  CHECK_FALSE(cell.settings.interlock.by_pin);
  CHECK(cell.settings.proof.needed);
  CHECK(cell.decision_limit_ms == 100);
  CHECK_FALSE(cell.largest_skew_ms);
  CHECK_FALSE(cell.outputs.modbus);
  CHECK_FALSE(cell.log);
  CHECK_FALSE(cell.web);
}

TEST_CASE("all that a cell can say") {
  const Files files;
  const Cell cell = files.load(
      "name: press 3\n"
      "cameras: {left: {source: 'gst:videotestsrc', name: a, exposure_may_change: true}, right: {source: 'files:x', "
      "repeat: true}, frames_per_s: 50, largest_skew_ms: 0.6}\n"
      "rig: rig.yaml\nskin: skin.yaml\nprofile: vga\nengine: native\ndecision: compete\n"
      "limits: {tolerance_px: 1.5, object: 40mm, alarm_percent: 2, undecidable_percent: 70, unsupervised_percent: 60, "
      "frozen_frames: 3, hidden_frames: 10, still_scene: true, unproven: true, object_speed_m_s: 2, decision_ms: 45, "
      "texture: 16, alarm_frames: 2/5}\n"
      "teach: {needed: true, frames: 20, margin: 4, less_light: true}\nrestart: by_itself\nrestart_after: 5\n"
      "outputs: {modbus: {address: 0.0.0.0, port: 1502}}\n"
      "log: {directory: events, size_mb: 50}\n"
      "web: {listen: '0.0.0.0:80', users_file: empty, tls: {certificate_file: empty, key_file: empty}, names: "
      "[press3.example.com, P-4], restart: true}\n");
  CHECK(cell.name == "press 3");
  CHECK(cell.cameras[0].name == "a");
  CHECK(cell.cameras[0].exposure_may_change);
  CHECK(cell.cameras[1].repeat);
  CHECK(cell.largest_skew_ms == 0.6);
  CHECK(cell.stamps == Stamps::arrival);
  CHECK(cell.settings.decision == horopter::Decision::compete);
  CHECK(cell.tolerance_px == 1.5);
  CHECK(cell.object_mm == 40);
  CHECK(cell.settings.still_limit == 0);
  CHECK(cell.settings.alarm_frames.needed == 2);
  CHECK(cell.settings.alarm_frames.of == 5);
  CHECK_FALSE(cell.settings.proof.needed);
  CHECK(cell.settings.blind.watch);
  CHECK(cell.settings.blind.margin == 4);
  CHECK(cell.settings.blind.dim);
  CHECK(cell.settings.interlock.by_itself);
  CHECK_FALSE(cell.settings.interlock.by_register);
  CHECK(cell.settings.interlock.frames == 5);
  CHECK(cell.decision_limit_ms == 45);
  CHECK(cell.outputs.modbus->port == 1502);
  CHECK(cell.log->size_mb == 50);
  CHECK(cell.log->directory == files.directory / "events");
  CHECK(cell.web->listen == "0.0.0.0:80");
  CHECK(cell.web->tls);
  CHECK(cell.web->names == std::vector<std::string>{"press3.example.com", "P-4"});
  CHECK(cell.web->restart);
}

TEST_CASE("what a cell must not say is refused: the file, the place, and what was expected") {
  const Files files;
  struct Mistake {
    std::string text;
    std::string said;
  };
  const std::string good = kCameras + kSkin;
  const auto mistake = GENERATE_COPY(values<Mistake>({
      {kSkin, "cameras: missing"},
      {kCameras, "skin: missing"},
      {good + "skinn: x\n", "unknown key 'skinn'"},
      {good + "zones: zones.yaml\n", "unknown key 'zones'"},
      {good + good, "a second time"},
      {kCameras + "skin: none.yaml\n", "there is no file"},
      {good + "rig: none.yaml\n", "there is no file"},
      {good + "profile: huge\n", "unknown profile 'huge'"},
      {good + "engine: warp\n", "unknown engine 'warp'"},
      {good + "decision: maybe\n", "expected thesis or compete"},
      {good + "restart: never\n", "expected register or by_itself"},
      {good + "restart_after: 0\n", "expected 1 to 15"},
      {good + "restart_after: 1.5\n", "a whole number"},
      {good + "limits: {decision_ms: 10}\n", "at least the time between images, 40 ms"},
      {good + "limits: {decision_ms: .nan}\n", "limits.decision_ms"},
      {good + "limits: {alarm_percent: 101}\n", "expected 0 to 100 %"},
      {good + "limits: {tolerance_px: 1, thickness_mm: 3}\n", "one of the two"},
      {good + "limits: {object: 40cm}\n", "5mm to 2000mm"},
      {good + "limits: {object: 40}\n", "5mm to 2000mm"},
      {good + "limits: {object: nanpx}\n", "5mm to 2000mm"},
      {good + "limits: {object: 19px}\n", "20px to 1000px"},
      {good + "limits: {speed: 1}\n", "unknown key 'speed'"},
      {good + "limits: {alarm_frames: 3/2}\n", "as in 2/3"},
      {good + "limits: {alarm_frames: 2}\n", "as in 2/3"},
      {good + "limits: 3\n", "expected a map"},
      {good + "teach: {frames: 0}\n", "expected 1 to 65535"},
      {good + "teach: {margin: 64}\n", "expected 0 to 63"},
      {good + "outputs: {modbus: {port: 70000}}\n", "expected 0 to 65535"},
      {good + "outputs: {profinet: {}}\n", "unknown key 'profinet'"},
      {good + "outputs: {mqtt: {host: broker}}\n", "outputs.mqtt.topic: missing"},
      {good + "outputs: {mqtt: {host: broker, topic: cells/#}}\n", "without # and +"},
      {good + "name: 'press #3'\noutputs: {mqtt: {host: broker}}\n", "'horopter/press #3'"},
      {good + "log: {size_mb: 50}\n", "log.directory: missing"},
      {good + "log: {directory: x, size_mb: 1}\n", "expected 10 to 1e+07 MB"},
      {good + "web: {listen: here}\n", "an address and a port"},
      {good + "web: {listen: 'here:99999'}\n", "an address and a port"},
      {good + "web: {names: press3}\n", "web.names: 'press3'"},
      {good + "web: {names: }\n", "web.names: missing"},
      {good + "web: {names: [press3, '']}\n", "line 6, column 23: web.names"},
      {good + "web: {names: ['press3:8443']}\n", "'press3:8443'"},
      {good + "web: {names: [[press3]]}\n", "a list of host names"},
      {good + "web: {names: [" + std::string(254, 'a') + "]}\n", "a list of host names"},
      {good + "web: {tls: {certificate_file: empty}}\n", "web.tls.key_file: missing"},
      {"cameras: {left: {source: 'files:a'}, right: {source: 'files:a'}, frames_per_s: 25}\n" + kSkin,
       "its source is that of the left camera"},
      {"cameras: {left: {source: 'files:a'}, right: {source: 'files:b'}}\n" + kSkin, "cameras.frames_per_s: missing"},
      {"cameras: {left: {source: 'files:a'}, right: {source: 'files:b'}, frames_per_s: 0}\n" + kSkin,
       "expected 0.1 to 1000"},
      {"cameras: {left: {source: 'files:a'}, frames_per_s: 25}\n" + kSkin, "cameras.right: missing"},
      {"cameras: {left: {source: 'http:a'}, right: {source: 'files:b'}, frames_per_s: 25}\n" + kSkin,
       "'http:a' is no source"},
      {"cameras: {left: {source: 'gst:'}, right: {source: 'files:b'}, frames_per_s: 25}\n" + kSkin,
       "nothing stands behind it"},
      {"cameras: {left: {source: 'files:a', trigger: Line1}, right: {source: 'files:b'}, frames_per_s: 25}\n" + kSkin,
       "this source has none"},
      {"cameras: {left: {source: 'gst:a', repeat: true}, right: {source: 'files:b'}, frames_per_s: 25}\n" + kSkin,
       "this source cannot begin again"},
      {"cameras: {left: {source: 'files:a'}, right: {source: 'files:b'}, frames_per_s: 25, largest_skew_ms: 30}\n" +
           kSkin,
       "at most half of the time between images"},
      {"cameras: {left: {source: 'files:a'}, right: {source: 'files:b'}, frames_per_s: 25, stamps: camera}\n" + kSkin,
       "cameras.stamps: these sources have no clock of a camera"},
      {"cameras: {left: {source: 'gev:a'}, right: {source: 'files:b'}, frames_per_s: 25, stamps: camera}\n" + kSkin,
       "it with gev: only"},
      {"cameras: {both: {source: 'files:a'}, left: {source: 'files:b'}, frames_per_s: 25}\n" + kSkin, "one of the two"},
      {"- 1\n", "expected a map"},
      {"", "cell.yaml"},
  }));
  CAPTURE(mistake.text);
  const std::string said = files.refused(mistake.text);
  CHECK_THAT(said, Catch::Contains("cell.yaml") && Catch::Contains(mistake.said) && Catch::Contains("expected"));
}

TEST_CASE("the cameras' clocks say when an image was taken, where both sources have one") {
  const Files files;
  const std::string more = ", frames_per_s: 25, stamps: camera}\n" + kSkin;
  CHECK(files.load("cameras: {left: {source: 'gev:a'}, right: {source: 'gev:b'}" + more).stamps == Stamps::camera);
  CHECK(files.load("cameras: {both: {source: 'gev:a'}" + more).stamps == Stamps::camera);
}

TEST_CASE("two cells never tell their states by one MQTT topic because both said nothing of it") {
  const Files files;
  const std::string cell = kCameras + kSkin + "outputs: {mqtt: {host: broker}}\n";
  const auto topic = [&](const std::string& name) {
    return files.load("name: " + name + "\n" + cell).outputs.mqtt->topic;
  };
  CHECK(topic("press 1") == "horopter/press 1");
  CHECK(topic("press 2") == "horopter/press 2");
  // The unit of systemd has each cell in a directory of its own, by one file name.
  CHECK_THAT(files.refused(cell), Catch::Contains("or a `name` of the cell"));
  CHECK(files.load(kCameras + kSkin + "outputs: {mqtt: {host: broker, topic: cells/3}}\n").outputs.mqtt->topic ==
        "cells/3");
}

TEST_CASE("the checksum is of the cell, the rig and the skin") {
  const Files files;
  const std::string text = kCameras + kSkin + "rig: rig.yaml\n";
  const Cell cell = files.load(text);
  const auto crc = cell.crc;
  CHECK(checksum(cell) == crc);
  CHECK(files.load(text).crc == crc);
  CHECK(files.load(text + "# changed\n").crc != crc);
  files.write("skin.yaml", "surface: {type: mesh, file: skin.ply}\n");
  files.write("skin.ply", "one");
  const auto with_mesh = files.load(text).crc;
  CHECK(with_mesh != crc);
  files.write("skin.ply", "two");
  CHECK(files.load(text).crc != with_mesh);
  files.write("skin.yaml", "surface: 2\n");
  const auto other_skin = files.load(text).crc;
  CHECK(other_skin != crc);
  files.write("rig.yaml", "cameras: 2\n");
  CHECK(checksum(cell) != crc);  // as they are now
  CHECK(files.load(text).crc != other_skin);
}

TEST_CASE("the longest skew: the thesis's 0.6 ms") {
  CHECK(largest_skew_ms(0.7, 1.371, 1.6) == Approx(0.6).epsilon(0.01));
  CHECK(largest_skew_ms(0.7, 1.371, 3.2) == Approx(0.3).epsilon(0.01));
}

TEST_CASE("a source is shown without passwords") {
  CHECK(without_secrets("gst:rtspsrc location=rtsp://me:secret@host/x ! decodebin") ==
        "gst:rtspsrc location=rtsp://…@host/x ! decodebin");
  CHECK(without_secrets("gst:rtspsrc location=rtsp://h user-id=me user-pw=secret ! x") ==
        "gst:rtspsrc location=rtsp://h user-id=… user-pw=… ! x");
  CHECK(without_secrets("files:a*.png") == "files:a*.png");
}
