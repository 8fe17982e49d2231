// SPDX-License-Identifier: Apache-2.0
// The program with a machine whose registers are in this computer's memory and whose streams are files.
#include <sys/file.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "horopter/base/profile.hpp"
#include "horopter/machine/native_device.hpp"
#include "sandbox.hpp"
#include "shared_data.hpp"
#include "uio_machine.hpp"

using namespace horopter::test;
using Arguments = std::vector<std::string>;
using nlohmann::json;

namespace {

/// Files of a run's results.
std::set<std::string> results_of(const Sandbox& box, const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(box / folder)) names.insert(entry.path().filename().string());
  return names;
}

}  // namespace

TEST_CASE("uio: live cameras, judged by a machine that is somewhere") {
  const auto folder = opencv_images();
  if (!folder) return;
  const Sandbox box;
  const auto calibrated =
      box.run({"calibrate", "--left", (*folder / "left??.jpg").string(), "--right", (*folder / "right??.jpg").string(),
               "--target", "chessboard:9x6:30mm", "-o", "rig.yaml"});
  REQUIRE(calibrated.status == 0);
  box.write("skin.yaml", "surface: {type: plane, point_mm: [0, 0, 300], normal: [0, 0, -1]}\n");
  UioMachine machine(box, horopter::make_native_device(horopter::find_profile("vga")));
  const auto source = [&](const std::string& side) {  // of these four the third is an alarm of 100 px
    return "  " + side + ": {source: 'files:" + (*folder / (side + "0[1-4].jpg")).string() + "', repeat: true}\n";
  };
  box.write("cell.yaml", "name: somewhere\nengine: '" + machine.engine() + "'\ncameras:\n" + source("left") +
                             source("right") + "  frames_per_s: 2\nrig: rig.yaml\nskin: skin.yaml\n" +
                             "restart: by_itself\nlimits: {object: 100px, decision_ms: 30000}\n");
  const int pairs = 14;
  const auto run = machine.run({"monitor", "cell.yaml", "--json", "--frames", std::to_string(pairs)});
  INFO(run.out << run.err);
  CHECK(run.status == 0);
  CHECK(machine.frames() == pairs);
  std::vector<json> events;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) events.push_back(json::parse(line));
  const auto has = [&](const std::string& name, const auto& condition) {
    return std::ranges::any_of(events, [&](const json& event) { return event["event"] == name && condition(event); });
  };
  CHECK(has("released", [](const json& event) { return event["safe"] == true; }));
  CHECK(has("stopped", [](const json& event) {
    return event["safe"] == false && event["alarm"] == true && event["objects"].size() == 1 &&
           event["causes"][0]["name"] == "alarm";
  }));
}

namespace {

/// A machine beside which somebody saves the skin as soon as it is asked for something.
class SavedBeside : public horopter::Device {
 public:
  explicit SavedBeside(const Sandbox& box)
      : box_(box), device_(horopter::make_native_device(horopter::find_profile("vga"))) {}
  std::uint32_t read(std::uint32_t address) override {
    if (!std::exchange(saved_, true)) box_.write("skin.yaml", box_.read("skin.yaml") + "# changed\n");
    return device_->read(address);
  }
  void write(std::uint32_t address, std::uint32_t value) override { device_->write(address, value); }
  void send(const horopter::Image& left, const horopter::Image& right) override { device_->send(left, right); }
  horopter::FrameStreams receive() override { return device_->receive(); }
  std::string_view engine() const override { return "saved beside"; }
  bool counts_cycles() const override { return false; }

 private:
  const Sandbox& box_;
  std::unique_ptr<horopter::Device> device_;
  bool saved_ = false;
};

}  // namespace

TEST_CASE("uio: a skin that is changed while it is read is not used") {
  const auto folder = opencv_images();
  if (!folder) return;
  const Sandbox box;
  box.write("skin.yaml", "surface:\n  type: homography\n  matrix: [[1, 0, -10], [0, 1, 0], [0, 0, 1]]\n");
  const std::string command = GENERATE("upload", "run");
  CAPTURE(command);
  UioMachine machine(box, std::make_unique<SavedBeside>(box));
  Arguments arguments{command, "--engine", machine.engine(), "--skin", "skin.yaml"};
  if (command == "run") {
    arguments = arguments + Arguments{"--left",    (*folder / "left01.jpg").string(),
                                      "--right",   (*folder / "right01.jpg").string(),
                                      "--out",     "out",
                                      "--unproven"};
  }
  const auto result = machine.run(arguments);
  INFO(result.err);
  CHECK(result.status == 3);
  CHECK_THAT(result.err, Catch::Contains("skin.yaml: it, or a mesh that it names, was changed"));
  CHECK(machine.frames() == 0);
}

TEST_CASE("uio: the pictures of the chessboards are those of the native engine") {
  const auto folder = opencv_images();
  if (!folder) return;
  const bool is_long = std::getenv("HOROPTER_LONG") != nullptr;
  const Sandbox box;
  const Arguments images{"--left", (*folder / (is_long ? "left??.jpg" : "left0[12].jpg")).string(), "--right",
                         (*folder / (is_long ? "right??.jpg" : "right0[12].jpg")).string()};
  const auto calibrated =
      box.run({"calibrate", "--left", (*folder / "left??.jpg").string(), "--right", (*folder / "right??.jpg").string(),
               "--target", "chessboard:9x6:30mm", "-o", "rig.yaml"});
  INFO(calibrated.err);
  REQUIRE(calibrated.status == 0);
  box.write("skin.yaml", "surface: {type: plane, point_mm: [26, -52, 458], normal: [-0.268, 0.156, -0.951]}\n");
  for (const std::string profile : {"vga", "field"}) {
    CAPTURE(profile);
    const auto run = [&](const std::string& engine, const std::string& kind) {
      return Arguments{"run",   "--skin",   "skin.yaml", "--rig", "rig.yaml",           "--profile",
                       profile, "--engine", engine,      "--out", profile + "-" + kind, "--json"} +
             images;
    };
    const auto native = box.run_proven(run("native", "native"));
    CAPTURE(native.err);
    REQUIRE((native.status == 0 || native.status == 4));  // some photographs have faults
    UioMachine machine(box, horopter::make_native_device(horopter::find_profile(profile)));
    const auto uio = machine.run(run(machine.engine(), "uio"));
    CAPTURE(uio.err);
    REQUIRE(uio.status == native.status);

    const std::size_t frames = (is_long ? 13U : 2U) * (profile == "field" ? 2 : 1);
    const auto names = results_of(box, profile + "-native");
    CHECK(names.size() == 2 * frames + 1);
    CHECK(results_of(box, profile + "-uio") == names);
    for (const std::string& name : names) {
      CAPTURE(name);
      if (name != "summary.json") CHECK((box.read(profile + "-uio/" + name) == box.read(profile + "-native/" + name)));
    }
    const json expected = json::parse(native.out);
    const json found = json::parse(uio.out);
    CHECK(found["engine"] == "uio");
    REQUIRE(found["frames"].size() == frames);
    for (std::size_t i = 0; i < frames; ++i) {
      for (const auto& [key, value] : expected["frames"][i].items()) {
        CAPTURE(i, key);
        CHECK(found["frames"][i][key] == value);
      }
    }
    CHECK(machine.frames() >= static_cast<int>(frames));
    std::printf("uio: %zu frames of profile %s as native, %d accesses to registers\n", frames, profile.c_str(),
                machine.accesses());
  }
}
