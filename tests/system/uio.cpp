// SPDX-License-Identifier: Apache-2.0
// The program with a machine whose registers are in this computer's memory and whose streams are files.
#include <sys/file.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
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
