// SPDX-License-Identifier: Apache-2.0
// horopter plan from outside.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "rig_text.hpp"
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
                             Catch::Contains("353 mm at a hand's 1.6 m/s") && Catch::Contains("441 mm by ISO 13855"));
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

TEST_CASE("plan capability: the smallest body, the response time and the distance for it") {
  Sandbox box;
  box.write("skin.yaml", "surface: {type: plane, point_mm: [0, 0, 500], normal: [0, 0, -1]}\n");
  const std::vector<std::string> plan{"plan", "capability", "--rig", kTable, "--skin", "skin.yaml", "--profile", "hd"};
  const auto of = [&](const std::vector<std::string>& more) {
    const auto result = box.run(plan + more + std::vector<std::string>{"--json"});
    CAPTURE(result.err);
    REQUIRE(result.status == 0);
    return json::parse(result.out);
  };
  const json slow = of({"--speed", "100", "--object", "40mm", "--draw", "body.png"});
  const json& mm = slow["detection_capability_mm"];
  CHECK(mm["smallest"].get<double>() > 10);
  CHECK(mm["smallest"].get<double>() <= mm["median"].get<double>());
  CHECK(mm["median"].get<double>() <= mm["largest"].get<double>());
  CHECK_THAT(box.read("body.png"), Catch::Contains("PNG"));
  // The items are all there is.
  double sum_ms = slow["response"]["stopping_ms"];
  for (const json& item : slow["response"]["items"]) {
    CHECK_FALSE(item["source"].get<std::string>().empty());
    sum_ms += item["ms"].get<double>();
  }
  CHECK(slow["response"]["total_ms"].get<double>() == Approx(sum_ms));
  // A live monitor takes the place of the hardware.
  const json live =
      of({"--speed", "100", "--object", "40mm", "--fps", "25", "--exposure-ms", "4", "--monitor-ms", "60"});
  REQUIRE(live["response"]["items"].size() == 4);
  CHECK(live["response"]["items"][3]["item"] == "live monitor, to its client");
  CHECK(live["response"]["total_ms"].get<double>() == Approx(60 + 4 + 40 + 60));  // images 1.5 periods apart
  CHECK(live["detection_capability_mm"]["largest"].get<double>() >
        of({"--speed", "100", "--object", "40mm", "--fps", "25"})["detection_capability_mm"]["largest"].get<double>());
  // A rod shows more than a ball; a larger limit and a faster body need larger ones; so does a thinner skin.
  const auto median = [](const json& report) { return report["detection_capability_mm"]["median"].get<double>(); };
  CHECK(median(of({"--speed", "100", "--object", "40mm", "--body", "rod"})) < median(slow));
  CHECK(median(of({"--speed", "100", "--object", "70mm"})) > median(slow));
  CHECK(median(of({"--speed", "1000", "--object", "40mm"})) > median(slow));
  CHECK(median(of({"--speed", "100", "--object", "40mm", "--tolerance", "1"})) > median(slow));
  // Two of three frames: each is to show enough, and it takes two images more.
  const std::vector<std::string> often{"--speed", "1600", "--object", "40mm", "--fps", "1500"};
  const json one = of(often);
  const json two = of(often + std::vector<std::string>{"--alarm-frames", "2/3"});
  CHECK(median(two) > median(one));
  CHECK(two["response"]["total_ms"].get<double>() == Approx(one["response"]["total_ms"].get<double>() + 2e3 / 1500));
  // More images a second: a body moves less between two.
  CHECK(median(of({"--speed", "1000", "--object", "40mm", "--fps", "200"})) <
        median(of({"--speed", "1000", "--object", "40mm"})));
  // A rod of an arm, still: the standard has a distance.
  const auto arm_at = [&](const char* speed) {
    return of({"--speed", speed, "--body", "rod", "--object", "40mm", "--stopping-ms", "100", "--fps", "1500"});
  };
  const json arm = arm_at("0");
  REQUIRE(arm["detection_capability_mm"]["largest"].get<double>() <= 40);
  // d is that of what moves at K, however slow a body is asked for.
  const double d_mm = arm["safety_distance_mm"]["d"];
  CHECK(d_mm > arm["detection_capability_mm"]["largest"].get<double>());
  CHECK(arm["safety_distance_mm"]["c"].get<double>() == Approx(std::max(0.0, 8 * (d_mm - 14))));
  const json hand = arm_at(arm["safety_distance_mm"]["k_m_s"] == 2.0 ? "2000" : "1600");
  CHECK(d_mm == Approx(hand["detection_capability_mm"]["largest"].get<double>()).margin(0.06));
  CHECK(hand["safety_distance_mm"] == arm["safety_distance_mm"]);
  // At 60 images a second through this skin no body is certain at a hand's speed: there is no distance, however slow.
  CHECK(of({"--speed", "0", "--body", "rod", "--object", "40mm"})["safety_distance_mm"].is_null());
  // What was measured stands beside it: four coats, taught and not; and in the warnings, what was missed, and
  // of what too few were walked: of none enough for 99.9 %.
  CHECK(arm["walked"]["found"].size() == 8);
  CHECK(arm["walked"]["false_alarms"].size() == 14);
  int missed = 0;
  int too_few = 0;
  for (const json& row : arm["walked"]["found"]) {
    CHECK(row["crossings"].get<int>() > 0);
    CHECK(row["found"].get<int>() <= row["crossings"].get<int>());
    REQUIRE(row["crossings"].get<int>() < 3838);
    ++(row["found"].get<int>() < 0.999 * row["crossings"].get<int>() ? missed : too_few);
  }
  const auto warns = [&](const char* of) {
    return arm.contains("warnings") && arm["warnings"].dump().find(of) != std::string::npos;
  };
  CHECK((missed > 0) == warns("missed rods"));
  CHECK((too_few > 0) == warns("too few crossings"));
  // With an object of 40 mm on the rig that was walked, machines that were taught have been walked many times.
  box.write("walked.yaml", "surface: {type: plane, point_mm: [0, 0, 800], normal: [0, 0, -1]}\n");
  const auto field = box.run({"plan", "capability", "--rig", kTable, "--skin", "walked.yaml", "--profile", "field",
                              "--object", "40mm", "--json"});
  CAPTURE(field.err);
  REQUIRE(field.status == 0);
  const json walked = json::parse(field.out)["walked"]["found"];
  REQUIRE(walked.size() == 8);
  for (const json& row : walked) CHECK((row["crossings"].get<int>() >= 2500) == row["taught"].get<bool>());
  // So fast that no body is certain: neither figures nor a distance, and it is said.
  const auto fast = box.run(plan + std::vector<std::string>{"--speed", "90000"});
  CHECK(fast.status == 0);
  CHECK_THAT(fast.out, Catch::Contains("smallest   none") && Catch::Contains("at 100.0 % of it") &&
                           Catch::Contains("none by ISO 13855:2010"));
  CHECK_THAT(fast.err, Catch::Contains("not found at 100.0 % of this skin"));
}

TEST_CASE("plan capability: a live monitor in profile field gets images, of two fields each") {
  Sandbox box;
  box.write("skin.yaml", "surface: {type: plane, point_mm: [0, 0, 800], normal: [0, 0, -1]}\n");
  const auto of = [&](const std::vector<std::string>& more) {
    return box.run(std::vector<std::string>{"plan", "capability", "--rig", kTable, "--skin", "skin.yaml", "--profile",
                                            "field", "--object", "40mm"} +
                   more);
  };
  const std::vector<std::string> monitor{"--monitor-ms", "60"};
  CHECK_THAT(of(monitor).out, Catch::Contains("it moves 64.0 mm from image to image") &&
                                  Catch::Contains("response   160.0 ms") &&
                                  Catch::Contains("images of 2 fields may be 1.5 periods apart"));
  // Three fields: of an image that is late, and the first of the next one, which is late, too.
  const std::vector<std::string> three{"--alarm-frames", "3/3"};
  CHECK_THAT(of(three).err, Catch::Contains("expected a skin of 96.0 mm"));
  const auto late = of(monitor + three);
  CHECK(late.status == 2);
  CHECK_THAT(late.err, Catch::Contains("moves 64.0 mm from one frame to the next, which may take 2 periods") &&
                           Catch::Contains("expected a skin of 160.0 mm"));
}

TEST_CASE("plan capability: a skin of which little is supervised is said to be one") {
  Sandbox box;
  const auto of = [&](const std::string& skin) {
    box.write("skin.yaml", "surface: " + skin + "\n");
    return box.run(
        {"plan", "capability", "--rig", kTable, "--skin", "skin.yaml", "--profile", "field", "--object", "40mm"});
  };
  const auto whole = of("{type: plane, point_mm: [0, 0, 800], normal: [0, 0, -1]}");
  CHECK(whole.status == 0);
  CHECK_THAT(whole.out, Catch::Contains("% of what the left camera sees of it is supervised"));
  CHECK_THAT(whole.err, !Catch::Contains("the figures are of that alone"));
  // So near that both cameras see another part of it.
  const auto near = of("{type: plane, point_mm: [0, 0, 250], normal: [0, 0, -1]}");
  CAPTURE(near.out);
  CHECK(near.status == 0);
  CHECK_THAT(near.err, Catch::Contains("the figures are of that alone"));
}

TEST_CASE("plan capability: what is refused") {
  Sandbox box;
  box.write("skin.yaml", "surface: {type: plane, point_mm: [0, 0, 800], normal: [0, 0, -1]}\n");
  const std::vector<std::string> plan{"plan", "capability", "--rig", kTable};
  const std::vector<std::string> skin{"--skin", "skin.yaml"};
  const auto refused = [&](const std::vector<std::string>& more, const std::string& message) {
    const auto result = box.run(plan + skin + more);
    CAPTURE(more, result.err);
    CHECK(result.status == 2);
    CHECK_THAT(result.err, Catch::Contains(message));
  };
  refused({"--object", "12px"}, "expected 20 to 1000 px");
  refused({"--object", "39px", "--profile", "field"}, "the smallest is 40 px");
  refused({"--object", "6mm"}, "the smallest that is found for certain is");
  refused({"--object", "0"}, "no body is an alarm by itself");
  refused({"--object", "900px"}, "does not fit into an image");
  refused({"--speed", "-1"}, "expected");
  refused({"--body", "cube"}, "ball, rod");
  refused({"--alarm-frames", "2/2"}, "a hand at 1.6 m/s moves 26.7 mm from one frame to the next");
  refused({"--exposure-ms", "50"}, "an exposure of 50 ms");
  refused({"--tolerance", "0.3"}, "it is not known up to which disparity");
  refused({"--thickness", "500"}, "the rule thesis can be set to");
  CHECK(box.run({"plan", "capability", "--skin", "skin.yaml"}).status == 2);
  CHECK(box.run(plan + skin + std::vector<std::string>{"--profile", "field", "--decision", "compete"}).status == 2);
  const auto bad = [&](const std::string& file, const std::string& text, const std::string& message) {
    box.write(file, text);
    check_bad_file(box, plan + std::vector<std::string>{"--skin", file}, file, message);
  };
  bad("flat.yaml", "surface: {type: homography, matrix: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}\n", "no place in space");
  bad("moving.yaml",
      "surface: {type: plane, point_mm: [0, 0, 800], normal: [0, 0, -1]}\nmotion:\n  frame_rate_per_s: 50\n"
      "  object_speed_m_s: 0.1\n  poses:\n    - {time_s: 1, shift_mm: [0, 0, -1]}\n",
      "motion");
  REQUIRE(box.run({"map", "--rig", kTable, "--skin", "skin.yaml", "--profile", "hd", "-o", "skin.hmap"}).status == 0);
  check_bad_file(box, plan + std::vector<std::string>{"--skin", "skin.hmap"}, "skin.hmap",
                 "does not say where its skin is");
  check_bad_file(box, plan + std::vector<std::string>{"--skin", "none.yaml"}, "none.yaml", "");
  // Behind the cameras.
  box.write("behind.yaml", "surface: {type: plane, point_mm: [0, 0, -800], normal: [0, 0, 1]}\n");
  const auto behind = box.run(plan + std::vector<std::string>{"--skin", "behind.yaml"});
  CHECK(behind.status == 1);
  CHECK_THAT(behind.err, Catch::Contains("nothing of the skin is supervised"));
  CHECK_THAT(behind.out, !Catch::Contains("distance"));
}

TEST_CASE("plan rig: from lenses and a wanted thickness to a rig, which is planned again as it was written") {
  Sandbox box;
  const std::vector<std::string> cameras{"plan", "rig",          "--focal", "10", "--pixel",
                                         "8.5",  "--image-size", "756",     "572"};
  const std::vector<std::string> distance{"--profile", "field", "--distance", "800", "--json"};
  const auto result = box.run(cameras + std::vector<std::string>{"--thickness", "10", "--out", "designed"} + distance);
  CAPTURE(result.err);
  REQUIRE(result.status == 0);
  const json report = json::parse(result.out);
  CHECK(json::parse(box.read("designed/rig.json")) == report);
  // 11.1 backwards: 2 D z^2 d_x / (t f), and axes that meet.
  const double baseline_mm = 2 * 0.7 * 800 * 800 * 0.017 / (10 * 10);
  CHECK(report["rig"]["baseline_mm"].get<double>() == Approx(baseline_mm));
  CHECK(report["rig"]["tilt_deg"].get<double>() == Approx(std::atan(baseline_mm / 1600) * 180 / M_PI));
  const json& skin = report["skins"][0];
  CHECK(skin["thickness_mm"]["on_axis_formula"].get<double>() == Approx(10));
  CHECK(skin["common_field"]["exploitation"].get<double>() > 0.9);
  CHECK(skin["viewing_angle_deg"]["left"]["largest"].get<double>() < 45);
  CHECK_THAT(box.read("designed/rig.svg"), Catch::StartsWith("<?xml") && Catch::Contains("baseline into the page") &&
                                               Catch::Contains("plane at 800 mm") && Catch::EndsWith("</svg>\n"));
  CHECK_THAT(box.read("designed/distance.svg"), Catch::Contains("Thickness of the skin"));
  CHECK_THAT(box.read("designed/distance.csv"), Catch::StartsWith("distance_mm,thickness_smallest_mm"));
  const auto again = box.run(std::vector<std::string>{"plan", "rig", "--rig", "designed/rig.yaml"} + distance);
  REQUIRE(again.status == 0);
  const json second = json::parse(again.out);
  CHECK(second["skins"][0]["common_field"]["common_m2"].get<double>() ==
        Approx(skin["common_field"]["common_m2"].get<double>()));
  // More tilt than that: less in common.
  const auto parallel = box.run(cameras + std::vector<std::string>{"--baseline", "152", "--tilt", "0"} + distance);
  REQUIRE(parallel.status == 0);
  CHECK(json::parse(parallel.out)["skins"][0]["common_field"]["exploitation"].get<double>() <
        skin["common_field"]["exploitation"].get<double>() - 0.05);
}

TEST_CASE("plan rig replaces its own rig.yaml, and no other") {
  Sandbox box;
  const std::vector<std::string> design{"plan",      "rig",          "--focal", "10",         "--pixel",
                                        "8.5",       "--image-size", "756x572", "--distance", "800",
                                        "--profile", "field",        "--out",   "plan"};
  REQUIRE(box.run(design + std::vector<std::string>{"--baseline", "152"}).status == 0);
  const auto designed = box.read("plan/rig.yaml");
  REQUIRE(box.run(design + std::vector<std::string>{"--baseline", "140"}).status == 0);
  CHECK(box.read("plan/rig.yaml") != designed);
  const auto measured = two_cameras(756, 572, 1176, "-152, 0, 0");
  for (const std::string& other : {measured, std::string("no rig")}) {
    box.write("plan/rig.yaml", other);
    check_bad_file(box, design + std::vector<std::string>{"--baseline", "152"}, "plan/rig.yaml", "would replace it");
    CHECK(box.read("plan/rig.yaml") == other);
  }
  box.write("plan/rig.yaml", measured);
  CHECK(box.run({"plan", "rig", "--rig", "plan/rig.yaml", "--distance", "800", "--profile", "field", "--out", "plan"})
            .status == 0);
  CHECK(box.read("plan/rig.yaml") == measured);
}

TEST_CASE("plan rig: where a zone is entered unseen, and what is refused") {
  Sandbox box;
  const std::vector<std::string> rig{"plan", "rig", "--rig", kTable};
  const std::vector<std::string> profile{"--profile", "field"};
  const std::string zone =
      box.write("box.yaml", "surface:\n  type: box\n  centre_mm: [0, 0, 800]\n  size_mm: [160, 120, 200]\n");
  const std::string table =
      box.write("table.yaml", "surface:\n  type: plane\n  point_mm: [0, 0, 900]\n  normal: [0, 0, -1]\n");
  const auto open = box.run(
      rig + profile +
      std::vector<std::string>{"--skin", zone, "--zone", zone, "--obstacle", table, "--step", "15", "--out", "open"});
  CAPTURE(open.out, open.err);
  CHECK(open.status == 1);  // past the upright sides, which the top hides
  CHECK_THAT(open.out, Catch::Contains("can be entered unseen") && Catch::Contains("hidden by another part of it"));
  CHECK_THAT(box.read("open/rig.svg"), Catch::Contains("entered unseen, a way in"));
  const json report = json::parse(box.read("open/rig.json"));
  CHECK(report["entry"]["unseen"].get<int>() > 0);
  CHECK(report["entry"]["path_mm"].size() > 1);
  // A low hood with slanting sides and a brim along the table closes it.
  const std::string hood =
      box.write("hood.yaml",
                "surface:\n  type: planes\n  polygons_mm:\n"
                "    - [[-120, -100, 900], [120, -100, 900], [50, -40, 830], [-50, -40, 830]]\n"
                "    - [[120, -100, 900], [120, 100, 900], [50, 40, 830], [50, -40, 830]]\n"
                "    - [[120, 100, 900], [-120, 100, 900], [-50, 40, 830], [50, 40, 830]]\n"
                "    - [[-120, 100, 900], [-120, -100, 900], [-50, -40, 830], [-50, 40, 830]]\n"
                "    - [[-170, -150, 900], [170, -150, 900], [120, -100, 900], [-120, -100, 900]]\n"
                "    - [[170, -150, 900], [170, 150, 900], [120, 100, 900], [120, -100, 900]]\n"
                "    - [[170, 150, 900], [-170, 150, 900], [-120, 100, 900], [120, 100, 900]]\n"
                "    - [[-170, 150, 900], [-170, -150, 900], [-120, -100, 900], [-120, 100, 900]]\n"
                "    - [[-50, -40, 830], [50, -40, 830], [50, 40, 830], [-50, 40, 830]]\n");
  const std::string low =
      box.write("low.yaml", "surface:\n  type: box\n  centre_mm: [0, 0, 880]\n  size_mm: [60, 50, 38]\n");
  const auto closed = box.run(rig + profile +
                              std::vector<std::string>{"--skin", hood, "--zone", low, "--obstacle", table, "--from",
                                                       "0", "0", "600", "--step", "8"});
  CAPTURE(closed.out);
  CHECK(closed.status == 0);
  CHECK_THAT(closed.out, Catch::Contains("nowhere entered unseen, by openings of 14 mm and more"));

  const std::vector<std::string> distance{"--distance", "800"};
  CHECK(box.run(rig).status == 2);
  CHECK(box.run(rig + distance + std::vector<std::string>{"--baseline", "100"}).status == 2);
  CHECK(box.run(rig + distance + std::vector<std::string>{"--step", "5"}).status == 2);
  CHECK(box.run({"plan", "rig", "--distance", "800"}).status == 2);
  const auto no_baseline =
      box.run({"plan", "rig", "--focal", "10", "--pixel", "8", "--image-size", "640", "480", "--distance", "800"});
  CHECK(no_baseline.status == 2);
  CHECK_THAT(no_baseline.err, Catch::Contains("--baseline") && Catch::Contains("--thickness"));
  check_bad_file(box, rig + distance + std::vector<std::string>{"--zone", table}, "table.yaml", "the zone has no ends");
  check_bad_file(box, rig + distance + std::vector<std::string>{"--zone", zone, "--step", "0.1"}, "box.yaml",
                 "too fine");
  check_bad_file(box, rig + distance + std::vector<std::string>{"--zone", "none.yaml"}, "none.yaml", "");
  // Cameras turned away from each other.
  CHECK(box.run({"plan", "rig", "--focal", "10", "--pixel", "8", "--image-size", "640", "480", "--distance", "800",
                 "--baseline", "100", "--tilt", "-40"})
            .status == 1);
  CHECK_THAT(box.run({"plan", "rig", "--help"}).out,
             Catch::Contains("--zone") && Catch::Contains("exploitation") && Catch::Contains("Example"));
}

TEST_CASE("plan: what moves has no one place to be planned at") {
  Sandbox box;
  const std::string still =
      box.write("still.yaml", "surface: {type: box, centre_mm: [0, 0, 800], size_mm: [99, 99, 99]}\n");
  const std::string moving = box.write(
      "moving.yaml",
      box.read("still.yaml") +
          "motion: {frame_rate_per_s: 50, object_speed_m_s: 0.1, poses: [{time_s: 1, shift_mm: [0, 0, 9]}]}\n");
  const std::vector<std::string> rig{"plan", "rig", "--rig", kTable, "--profile", "field"};
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"plan", "thickness", "--rig", kTable, "--skin", moving},
        rig + std::vector<std::string>{"--skin", moving},
        rig + std::vector<std::string>{"--skin", still, "--zone", moving},
        rig + std::vector<std::string>{"--skin", still, "--zone", still, "--obstacle", still, moving}}) {
    check_bad_file(box, arguments, "moving.yaml", "a surface that moves");
  }
}

TEST_CASE("plan rig: people are on their side of the floor, and outside the zone") {
  Sandbox box;
  box.write("box.yaml", "surface: {type: box, centre_mm: [0, 0, 800], size_mm: [160, 120, 200]}\n");
  box.write("table.yaml", "surface: {type: plane, point_mm: [0, 0, 900], normal: [0, 0, -1]}\n");
  const auto from = [&](const char* x, const char* z) {
    return box.run({"plan", "rig", "--rig", kTable, "--profile", "field", "--skin", "box.yaml", "--zone", "box.yaml",
                    "--obstacle", "table.yaml", "--step", "15", "--from", x, "0", z});
  };
  // Its nearest points of the lattice lie under the table, from where nobody comes.
  for (const char* z : {"890", "895", "899.5"}) {
    const auto above = from("400", z);
    CAPTURE(z, above.out, above.err);
    CHECK(above.status == 1);
    CHECK_THAT(above.out, Catch::Contains("can be entered unseen"));
  }
  for (const auto& [x, z, message] :
       {std::tuple{"400", "900", "--from 400 0 900 lies on an obstacle"},
        std::tuple{"0", "800", "--from 0 0 800 lies in the zone"}, std::tuple{"75", "705", "lies in the zone"}}) {
    const auto refused = from(x, z);
    CAPTURE(refused.out);
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, Catch::Contains(message));
  }
}

TEST_CASE("plan rig: a way around the rim of what is watched is found also from --from") {
  Sandbox box;
  box.write("skin.yaml", "surface: {type: plane, point_mm: [0, 0, 800], normal: [0, 0, -1]}\n");
  box.write("zone.yaml", "surface: {type: box, centre_mm: [0, 0, 1000], size_mm: [100, 100, 100]}\n");
  const auto open = box.run({"plan", "rig", "--rig", kTable, "--profile", "field", "--skin", "skin.yaml", "--zone",
                             "zone.yaml", "--from", "0", "0", "700", "--out", "open"});
  CAPTURE(open.out, open.err);
  CHECK(open.status == 1);
  // Where the way passes the skin, no image shows it.
  bool around = false;
  const json report = json::parse(box.read("open/rig.json"));
  for (const json& place : report["entry"]["path_mm"]) {
    around |= std::abs(place[0].get<double>()) > 200 || std::abs(place[1].get<double>()) > 150;
  }
  CHECK(around);
}

TEST_CASE("plan --decision compete: what leaves the row is not supervised; cameras are refused as by map") {
  const Sandbox box;
  const auto design = [&](const char* tilt, const char* decision) {
    return box.run({"plan", "rig",        "--focal",    "10",    "--pixel", "17",    "--image-size",
                    "320",  "240",        "--baseline", "300",   "--tilt",  tilt,    "--distance",
                    "800",  "--decision", decision,     "--out", "design",  "--json"});
  };
  box.write("skin.yaml", "surface:\n  type: plane\n  point_mm: [0, 0, 800]\n  normal: [0, 0, -1]\n");
  const std::vector<std::string> skin{"--rig",      "design/rig.yaml", "--skin", "skin.yaml",
                                      "--decision", "compete",         "--json"};
  const std::vector<std::string> map{"map", "--profile", "vga"};
  const std::vector<std::string> thickness{"plan", "thickness"};
  const auto supervised = [](const json& report) {
    const json& field = report.at("skins").at(0).at("common_field");
    return field.at("supervised_m2").get<double>() / field.at("common_m2").get<double>();
  };
  const auto thesis = design("15", "thesis");
  REQUIRE(thesis.status == 0);
  CHECK(supervised(json::parse(thesis.out)) == Approx(1));
  const auto compete = design("15", "compete");
  CAPTURE(compete.err);
  REQUIRE(compete.status == 0);
  const json report = json::parse(compete.out);
  CHECK(report.at("decision") == "compete");
  const auto beyond = report.at("skins").at(0).at("beyond_rows").get<double>();
  CHECK(beyond > 0.3);
  CHECK(supervised(report) == Approx(1 - beyond).margin(0.02));
  // The same cameras and skin by `plan thickness`, and by the table.
  const auto thick = box.run(thickness + skin);
  REQUIRE(thick.status == 0);
  const json planned = json::parse(thick.out).at("skins").at(0);
  CHECK(planned.at("beyond_rows").get<double>() == Approx(beyond));
  const auto table = box.run(map + skin);
  CAPTURE(table.err);
  REQUIRE(table.status == 0);
  CHECK(json::parse(table.out).at("tables").at(0).at("supervised").get<double>() ==
        Approx(planned.at("supervised_pixels").get<double>()).epsilon(0.03));
  CHECK(box.run(thickness + skin + std::vector<std::string>{"--profile", "field"}).status == 2);

  // One camera above the other: all lines leave.
  REQUIRE(design("0", "thesis").status == 0);
  std::string upright = box.read("design/rig.yaml");
  const std::string key = "translation_mm: [";
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"150, ", "0, 150, 0]"}, {"-150, ", "0, -150, 0]"}}) {
    const std::size_t at = upright.find(key + from);
    REQUIRE(at != std::string::npos);
    upright.replace(at + key.size(), upright.find('\n', at) - at - key.size(), to);
  }
  box.write("design/rig.yaml", upright);
  const auto refused = box.run(thickness + skin);
  CHECK(refused.status == 1);
  CHECK_THAT(refused.err, Catch::Contains("at 100.0 % of the pixels") && Catch::Contains("or --decision thesis"));
  check_bad_file(box, map + skin, "skin.yaml", "at 100.0 % of the pixels");
}
