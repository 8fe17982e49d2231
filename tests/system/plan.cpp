// SPDX-License-Identifier: Apache-2.0
// horopter plan from outside.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "sandbox.hpp"

using namespace horopter::test;
using nlohmann::json;

namespace {

const std::string kTable = std::string(HOROPTER_SOURCE_DIR) + "/host/examples/table_11_1.yaml";

}  // namespace

TEST_CASE("plan thickness: Table 11.1, with pictures") {
  Sandbox box;
  const std::vector<std::string> table{"plan",  "thickness", "--rig",  kTable,        "--profile", "field",
                                       "--out", "thickness", "--json", "--tolerance", "D95"};
  const auto result = box.run(table + std::vector<std::string>{"--distance", "700", "800", "900"});
  CAPTURE(result.err);
  REQUIRE(result.status == 0);
  const json report = json::parse(result.out);
  CHECK(json::parse(box.read("thickness/thickness.json")) == report);
  REQUIRE(report["skins"].size() == 3);
  const double formula_mm[] = {7.67, 10.02, 12.68};
  const double model_mm[] = {7.75, 10.11, 12.77};
  for (std::size_t i = 0; i < 3; ++i) {
    const json& mm = report["skins"][i]["thickness_mm"];
    CHECK(mm["on_axis_formula"].get<double>() == Approx(formula_mm[i]).margin(0.01));
    CHECK(mm["on_axis"].get<double>() == Approx(model_mm[i]).margin(0.01));
  }
  CHECK(report["skins"][1]["largest_speed_m_s"].get<double>() == Approx(0.484).margin(0.001));
  for (const char* picture : {"700", "800", "900"}) {
    CHECK_THAT(box.read("thickness/thickness-" + std::string(picture) + "-mm.png"), Catch::Contains("PNG"));
  }
}

TEST_CASE("map takes the size of the images from the rig, and refuses a profile that does not hold it") {
  Sandbox box;
  box.write("skin.yaml", "surface:\n  type: plane\n  point_mm: [0, 0, 800]\n  normal: [0, 0, -1]\n");
  const auto arguments = [](const char* profile) {
    return std::vector<std::string>{"map", "--rig", kTable, "--skin", "skin.yaml", "--profile", profile, "--json"};
  };
  const auto result = box.run(arguments("hd"));
  CAPTURE(result.err);
  REQUIRE(result.status == 0);
  CHECK(json::parse(result.out)["width"] == 756);
  check_bad_file(box, arguments("vga"), "table_11_1.yaml", "756x572");
}

TEST_CASE("plan thickness: a user's skin, and what is refused") {
  Sandbox box;
  const std::vector<std::string> plan{"plan", "thickness", "--rig", kTable};
  const std::string skin = box.write(
      "skin.yaml", "surface:\n  type: ellipsoid\n  centre_mm: [0, 0, 1000]\n  half_axes_mm: [250, 200, 200]\n");
  const auto result = box.run(plan + std::vector<std::string>{"--skin", skin, "--profile", "field", "--frame-rate",
                                                              "50", "--stopping-ms", "157"});
  CAPTURE(result.out, result.err);
  CHECK(result.status == 0);
  CHECK_THAT(result.out, Catch::Contains("exploitation") && Catch::Contains("camera model") &&
                             Catch::Contains("11.1 and 11.2") && Catch::Contains("largest speed") &&
                             Catch::Contains("320 mm at a hand's 1.6 m/s") && Catch::Contains("400 mm by ISO 13855"));
  CHECK(box.run(plan).status == 2);
  CHECK(box.run(plan + std::vector<std::string>{"--distance", "800", "--skin", skin}).status == 2);
  CHECK(box.run(plan + std::vector<std::string>{"--distance", "-1"}).status == 2);
  CHECK(box.run(plan + std::vector<std::string>{"--distance", "800", "--tolerance", "D99"}).status == 2);
  check_bad_file(box, {"plan", "thickness", "--rig", "none.yaml", "--distance", "800"}, "none.yaml", "");
  check_bad_file(box,
                 plan + std::vector<std::string>{"--skin", box.write("flat.yaml",
                                                                     "surface:\n  type: homography\n  matrix: [[1, 0, "
                                                                     "0], [0, 1, 0], [0, 0, 1]]\n")},
                 "flat.yaml", "no place in space");
  // So near that the cameras see different parts of it.
  CHECK(box.run(plan + std::vector<std::string>{"--distance", "60"}).status == 1);
  CHECK_THAT(box.run({"plan", "thickness", "--help"}).out,
             Catch::Contains("--tolerance") && Catch::Contains("D95") && Catch::Contains("Example"));
}
