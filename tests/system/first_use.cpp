// SPDX-License-Identifier: Apache-2.0
// Mistakes of a first use: what is said names the mistake and what to do.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "sandbox.hpp"

using namespace horopter::test;

namespace {

const std::vector<std::string> kDesign{"plan",       "rig",          "--focal",   "10",          "--pixel",
                                       "8.5",        "--image-size", "756x572",   "--thickness", "10",
                                       "--distance", "800",          "--profile", "field"};

/// The design with another value of an option.
std::vector<std::string> design(const std::string& option = "", const std::string& value = "") {
  std::vector<std::string> arguments = kDesign;
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
    if (arguments[i] == option) arguments[i + 1] = value;
  }
  return arguments;
}

struct Mistake {
  std::vector<std::string> arguments;
  int status;
  std::string said;
};

}  // namespace

TEST_CASE("What is mistyped is named") {
  const auto mistake = GENERATE(values<Mistake>({
      {{"runn"}, 2, "unknown 'runn'"},
      {{"run", "--left", "a", "--right", "b", "--out", "c", "--skinn", "s.yaml"}, 2, "unknown '--skinn'"},
      {{"run", "--left", "a", "--right", "b", "--out", "c", "--skin", "s", "--frames", "0"},
       2,
       "'0'; expected a whole"},
      {{"run", "--left", "a", "--right", "b", "--out", "c", "--skin", "s", "--frames", "-3"},
       2,
       "'-3'; expected a whole"},
      {{"run", "--left", "a", "--right", "b", "--out", "c", "--skin", "s", "--tolerance", "-1"},
       2,
       "--tolerance: '-1'; expected a number above 0"},
      {{"plan", "thickness", "--rig", "r", "--distance", "-800"}, 2, "--distance: '-800'; expected a number above 0"},
      {{"plan", "thickness", "--rig", "r", "--distance", "800", "--stopping-ms", "abc"},
       2,
       "--stopping-ms: 'abc'; expected a number of 0 or more"},
      {{"map", "--alarm-limit", "nan"}, 2, "--alarm-limit: 'nan'; expected a number of 0 or more"},
      {{"evaluate", "--threshold", "nan"}, 2, "--threshold: 'nan'; expected a number above 0"},
      {{"evaluate", "--self", "nan"}, 2, "--self: 'nan'; expected a number of 0 or more"},
      {{"upload", "--engine", "native", "--feedback", "nan"}, 2, "--feedback: 'nan'; expected a number of 0 or more"},
      {{"plan", "thickness", "--rig", "r", "--tolerance", "nan"},
       2,
       "--tolerance: 'nan'; expected a number above 0, or D95"},
      {{"plan", "rig", "--tilt", "nan"}, 2, "--tilt: 'nan'; expected a number"},
      {{"plan", "rig", "--tilt", "-81"}, 2, "--tilt: '-81'; expected -80 to 80 degrees"},
      {{"plan", "rig", "--from", "0", "nan", "0"}, 2, "--from: 'nan'; expected a number"},
      {{"calibrate", "--heights", "0,nan"}, 2, "--heights: 'nan'; expected a number"},
      {design("--image-size", "756"), 2, "--image-size '756'; expected WIDTHxHEIGHT"},
      {design("--image-size", "4294968052x572"), 2, "--image-size '4294968052x572'; expected WIDTHxHEIGHT"},
      {design("--image-size", "756x572 px"), 2, "--image-size '756x572 px'; expected WIDTHxHEIGHT"},
      {design("--pixel", "0.0085"), 1, "--pixel in um"},
      {design("--thickness", "0.1"), 1, "turned by 84 degrees"},
  }));
  CAPTURE(mistake.arguments);
  const Sandbox box;
  const auto result = box.run(mistake.arguments);
  CHECK(result.status == mistake.status);
  CHECK_THAT(result.err, Catch::Contains(mistake.said));
  CHECK(result.err.size() < 500);
}

TEST_CASE("An image size is WIDTHxHEIGHT or WIDTH HEIGHT") {
  const Sandbox box;
  auto apart = design("--image-size", "756");
  apart.insert(std::ranges::find(apart, "756") + 1, "572");
  const auto result = box.run(design());
  CAPTURE(result.err);
  CHECK(result.status == 0);
  CHECK(box.run(apart).out == result.out);
}

TEST_CASE("A safety distance comes with the speed that it holds for") {
  const Sandbox box;
  REQUIRE(box.run(design() + std::vector<std::string>{"--out", "thin"}).status == 0);
  const auto plan = [&](const std::string& tolerance) {
    return box.run({"plan", "thickness", "--rig", "thin/rig.yaml", "--profile", "field", "--distance", "800",
                    "--tolerance", tolerance});
  };
  const auto thin = plan("0.7");
  CHECK(thin.status == 0);
  CHECK_THAT(thin.err, Catch::Contains("a hand may cross this skin between two images unseen"));
  const auto speed = thin.err.substr(thin.err.find("up to ") + 6, 5);
  CHECK_THAT(thin.out, Catch::Contains(speed + " m/s through the thinnest place"));
  const auto thick = plan("4");
  CHECK(thick.status == 0);
  CHECK(thick.err.empty());
}

TEST_CASE("A skin that no camera sees, and an axis that does not meet one") {
  const Sandbox box;
  REQUIRE(box.run(design() + std::vector<std::string>{"--out", "rig"}).status == 0);
  const auto map = [](const std::string& skin) {
    return std::vector<std::string>{"map",       "--rig", "rig/rig.yaml", "--skin",  skin,
                                    "--profile", "field", "-o",           "out.hmap"};
  };
  for (const std::string z_mm : {"-800", "0.8"}) {
    CAPTURE(z_mm);
    box.write("skin.yaml", "surface: {type: plane, point_mm: [0, 0, " + z_mm + "], normal: [0, 0, 1]}\n");
    check_bad_file(box, map("skin.yaml"), "skin.yaml", "the cameras do not see this skin");
    CHECK_THAT(box.run(map("skin.yaml")).err, Catch::Contains("in mm of the rig's world"));
  }
  box.write("off.yaml", "surface: {type: box, centre_mm: [100, 0, 800], size_mm: [60, 200, 60]}\n");
  const auto off = box.run({"plan", "thickness", "--rig", "rig/rig.yaml", "--profile", "field", "--skin", "off.yaml"});
  CHECK(off.status == 0);
  CHECK_THAT(off.out, Catch::Contains("the axis does not meet it") && !Catch::Contains("nan"));
}

TEST_CASE("Images too large for the machine: the file, and the option that helps") {
  const Sandbox box;
  const cv::Mat large(600, 2000, CV_8UC1, cv::Scalar(100));
  for (const char* name : {"l.png", "r.png", "d.png"}) cv::imwrite((box / name).string(), large);
  const auto result = box.run({"evaluate", "--left", "l.png", "--right", "r.png", "--disparity", "d.png"});
  CHECK(result.status == 3);
  CHECK_THAT(result.err, Catch::Contains("l.png: ") && Catch::Contains("--resize 0.5"));
}
