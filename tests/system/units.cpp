// SPDX-License-Identifier: Apache-2.0
// Numbers in a wrong unit, cameras that are not those of the skin, files that are not of this rig: refused, or said.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <regex>
#include <string>
#include <vector>

#include "pairs.hpp"
#include "sandbox.hpp"

using namespace horopter::test;
using nlohmann::json;

namespace {

using Arguments = std::vector<std::string>;

const std::string kPlane = "surface: {type: plane, point_mm: [0, 0, 800], normal: [0, 0, 1]}\n";
const Arguments kMap{"map", "--skin", "skin.yaml", "--rig", "rig.yaml", "--profile", "vga", "--json"};
const Arguments kThickness{"plan", "thickness", "--rig", "rig.yaml", "--skin", "skin.yaml", "--json"};
const Arguments kDistance{"plan", "thickness", "--rig", "rig.yaml", "--distance", "800", "--json"};
const Arguments kPlanRig{"plan", "rig", "--rig", "rig.yaml", "--distance", "800", "--json"};

Arguments run() { return run_arguments() + Arguments{"--rig", "rig.yaml", "--json"}; }

std::string replaced(const std::string& text, const std::string& what, const std::string& by) {
  return std::regex_replace(text, std::regex(what), by);
}

/// Images, a rig that fits them, and a skin before it.
struct Watched : Sandbox {
  Watched() {
    with_pairs(*this);
    write("rig.yaml", rig_text());
    write("skin.yaml", kPlane);
  }
};

/// Done all the same, and said: on standard error, and in the result.
void check_warned(const Sandbox& box, const Arguments& arguments, const std::string& message) {
  const auto result = box.run(arguments);
  CAPTURE(arguments, result.err);
  CHECK((result.status == 0 || result.status == 4));
  CHECK_THAT(result.err, Catch::Contains("horopter: warning: ") && Catch::Contains(message));
  const auto warnings = json::parse(result.out)["warnings"];
  REQUIRE_FALSE(warnings.empty());
  CHECK_THAT(warnings[0].get<std::string>(), Catch::Contains(message));
}

}  // namespace

TEST_CASE("Cameras in the wrong order, and a translation of the wrong sign, are refused by every command") {
  const Watched box;
  for (const Arguments& arguments : {run(), kMap, kThickness, kDistance, kPlanRig}) {
    CHECK(box.run(arguments).err.empty());
    fs::remove_all(box / "out");
  }
  box.write("skin.yaml", "cameras: [right, left]\n" + kPlane);
  for (const Arguments& arguments : {run(), kMap, kThickness}) {
    check_bad_file(box, arguments, "skin.yaml", "line 1, column 10: skin.cameras: the right camera, left, stands to");
  }
  box.write("skin.yaml", kPlane);
  box.write("rig.yaml", replaced(rig_text(), "-50", "50"));
  for (const Arguments& arguments : {run(), kMap, kThickness}) {
    check_bad_file(box, arguments, "skin.yaml", "the right camera, right, stands to the left of the left one, left");
  }
  for (const Arguments& arguments : {kDistance, kPlanRig}) {
    check_bad_file(box, arguments, "rig.yaml", "the second camera, right, stands to the left of the first");
  }
  CHECK_THAT(box.run({"calibrate", "--import", "rig.yaml"}).out, Catch::Contains("warning: left_right_exchanged"));
  // One above the other is neither.
  box.write("rig.yaml", replaced(rig_text(), "-50, -0, 0", "20, -100, 0"));
  CHECK(box.run(kDistance).status == 0);
}

TEST_CASE("The two cameras that a skin names are as far apart as cameras are") {
  Sandbox box;
  with_pairs(box);
  const std::string rig = rig_text();
  const std::string third = rig.substr(rig.find("  - name: right"));
  box.write("rig.yaml", rig + replaced(replaced(third, "name: right", "name: third"), "-50", "-0.05"));
  box.write("skin.yaml", "cameras: [left, third]\n" + kPlane);
  for (const Arguments& arguments : {run(), kMap, kThickness}) {
    check_bad_file(box, arguments, "skin.yaml", "the cameras are 0.05 mm apart");
  }
}

TEST_CASE("A skin in metres is refused, one in centimetres is said to be hardly seen") {
  Sandbox box;
  with_pairs(box);
  box.write("rig.yaml", rig_text());
  box.write("skin.yaml", replaced(kPlane, "800", "0.8"));
  for (const Arguments& arguments : {run(), kMap, kThickness}) {
    check_bad_file(box, arguments, "skin.yaml", "surface: the cameras do not see this skin so: it is 0.8");
  }
  box.write("skin.yaml", replaced(kPlane, "800", "80"));
  for (const Arguments& arguments : {run(), kMap}) check_warned(box, arguments, "% is supervised; most of the rest is");
}

TEST_CASE("A skin of which little is supervised is said to be so, whether it stands still or moves") {
  Sandbox box;
  with_pairs(box);
  box.write("rig.yaml", rig_text());
  // At 100 mm the right image shows the half of it.
  box.write("skin.yaml", replaced(kPlane, "800", "90"));
  for (const Arguments& arguments : {run(), kMap}) check_warned(box, arguments, "% is supervised; most of the rest is");
  const auto moving = [&](int from_mm, int by_mm) {
    box.write("skin.yaml", replaced(kPlane, "800", std::to_string(from_mm)) +
                               "motion: {frame_rate_per_s: 50, object_speed_m_s: 0.01, poses: [{time_s: 0.1, shift_mm: "
                               "[0, 0, " +
                               std::to_string(by_mm) + "]}]}\n");
    fs::remove_all(box / "out");
  };
  moving(90, 1);
  check_warned(box, run(), "% is supervised; most of the rest is");
  // The worst step counts, wherever it is.
  moving(110, -20);
  check_warned(box, run(), "% is supervised; most of the rest is");
  const double percent = json::parse(box.read("out/summary.json"))["motion"]["supervised_percent"];
  CHECK(percent > 30);
  CHECK(percent < 50);
  moving(110, 1);
  CHECK_THAT(box.run(run()).err, !Catch::Contains("is supervised"));
}

TEST_CASE("A surface of a union that others hide, or that is not in view, is said to be watched by nothing") {
  Sandbox box;
  with_pairs(box);
  box.write("rig.yaml", rig_text());
  const auto of = [](const std::string& second) {
    return "surface:\n  type: union\n  surfaces:\n  - {type: plane, point_mm: [0, 0, 800], normal: [0, 0, 1]}\n  - " +
           second + "\n";
  };
  const auto check_unwatched = [&](const Arguments& arguments, const std::string& what, const std::string& why) {
    check_warned(box, arguments, "nothing watches surface 2 of the union (" + what);
    CHECK_THAT(box.run(arguments).err, Catch::Contains(why));
  };
  box.write("skin.yaml", of("{type: plane, point_mm: [0, 0, 900], normal: [0, 0, 1]}"));
  for (const Arguments& arguments : {run(), kMap}) check_unwatched(arguments, "plane", "hidden behind the others");
  box.write("skin.yaml",
            of("{type: union, surfaces: [{type: box, centre_mm: [5000, 0, 800], size_mm: [99, 99, 99]}]}"));
  check_unwatched(kMap, "box", "does not see it");
  box.write("skin.yaml", of("{type: box, centre_mm: [0, 0, 800], size_mm: [99, 99, 99]}"));
  CHECK_THAT(box.run(kMap).err, !Catch::Contains("nothing watches"));
  // The left image shows it at its border, in column 25; the right one does not, it would be at -40.
  box.write("rig.yaml", two_cameras(640, 480, 500, "-100, 0, 0"));
  box.write("skin.yaml", of("{type: ellipsoid, centre_mm: [-460, 0, 780], half_axes_mm: [20, 20, 20]}"));
  check_unwatched(kMap, "ellipsoid", "most of it is outside the right image");
  box.write("skin.yaml", of("{type: ellipsoid, centre_mm: [-300, 0, 780], half_axes_mm: [20, 20, 20]}"));
  CHECK_THAT(box.run(kMap).err, !Catch::Contains("nothing watches"));
}

TEST_CASE("Points close together are said to leave the rest of the image to chance") {
  Sandbox box;
  const auto skin_of = [&](int x, int y, int width, int height) {
    std::string text = "surface:\n  type: correspondences\n  points:\n";
    for (const auto& [dx, dy] : {std::pair{0, 0}, {width, 0}, {width, height}, {0, height}}) {
      const std::string row = std::to_string(y + dy);
      text += "  - {left: [" + std::to_string(x + dx) + ", " + row + "], right: [" + std::to_string(x + dx - 20) +
              ", " + row + "]}\n";
    }
    box.write("skin.yaml", text);
  };
  const Arguments map{"map", "--skin", "skin.yaml", "--profile", "vga", "--json"};
  skin_of(300, 200, 30, 30);
  check_warned(box, map, "the points lie too close together");
  skin_of(60, 50, 520, 380);
  const auto spread = box.run(map);
  CHECK(spread.status == 0);
  CHECK_THAT(spread.err, !Catch::Contains("too close together"));
}

TEST_CASE("A rig without image size is taken for images that it may be of") {
  Sandbox box;
  with_pairs(box);
  box.write("skin.yaml", kPlane);
  const std::string unknown = replaced(rig_text(), "    image_size: .200, 120.\n", "");
  box.write("rig.yaml", unknown);
  check_warned(box, run(), "the rig does not tell the image size of camera left");
  fs::remove_all(box / "out");
  // Of images twice as large.
  box.write("rig.yaml", replaced(replaced(unknown, "99.5", "199.5"), "59.5", "119.5"));
  check_bad_file(box, run(), "skin.yaml", "has its centre at (199.5, 119.5) px");
}

TEST_CASE("What a rig of another program may lack is a warning of whoever uses it") {
  const Watched box;
  const std::string matrix =
      ": !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 200., 0., 99.5, 0., 200., 59.5, 0., 0., 1. ]\n";
  box.write("rig.yaml", "%YAML:1.0\n---\nlength_unit: mm\nimage_width: 200\nimage_height: 120\nM1" + matrix + "M2" +
                            matrix + "R: [ 0., 0., 0. ]\nT: [ -50., 0., 0. ]\n");
  const std::string lacks = "no_distortion: rig.yaml: no distortion coefficients beside M1";
  for (const Arguments& arguments : {run(), kMap, kThickness, kDistance}) check_warned(box, arguments, lacks);
  CHECK_THAT(box.run(kPlanRig).err, Catch::Contains(lacks));
}

TEST_CASE("A table of some rig is said to be unchecked without --rig") {
  const Watched box;
  REQUIRE(box.run(kMap + Arguments{"-o", "skin.hmap"}).status == 0);
  const Arguments by_table = run_arguments("left0.png", "right0.png", "skin.hmap") + Arguments{"--json"};
  check_warned(box, by_table, "whether the cameras still stand so is not known without --rig");
  CHECK(box.run(by_table + Arguments{"--rig", "rig.yaml"}).err.empty());
}

TEST_CASE("A skin in pixels uses of --rig the image size alone, and says so") {
  const Watched box;
  box.write("skin.yaml", kSkin);
  REQUIRE(box.run({"map", "--skin", "skin.yaml", "--profile", "vga", "--size", "200x120", "-o", "skin.hmap"}).status ==
          0);
  for (const std::string skin : {"skin.yaml", "skin.hmap"}) {
    CAPTURE(skin);
    box.write("rig.yaml", rig_text());
    const Arguments with_rig = run_arguments("left0.png", "right0.png", skin) + Arguments{"--rig", "rig.yaml"};
    check_warned(box, with_rig + Arguments{"--json"}, "of the rig only the image size is used");
    const auto proven = box.run_proven(with_rig);
    CHECK_THAT(proven.err, Catch::Contains("knows no rig: cameras that are exchanged or moved are not told"));
    CHECK_THAT(proven.err + proven.out, !Catch::Contains("without a rig"));
    fs::remove_all(box / "out");
    box.write("rig.yaml", two_cameras(756, 572, 700, "-50, 0, 0"));
    check_bad_file(box, with_rig, skin, "camera left of the rig takes images of 756x572 pixels");
  }
}

TEST_CASE("Distances, baselines, thicknesses and speeds that no rig has are refused") {
  const Watched box;
  const Arguments plan{"plan", "thickness", "--rig", "rig.yaml", "--distance"};
  const Arguments design{"plan", "rig", "--focal", "10", "--pixel", "8", "--image-size", "640x480", "--distance"};
  for (const Arguments& wrong :
       {plan + Arguments{"0.8"}, plan + Arguments{"8e5"}, plan + Arguments{"800", "--frame-rate", "1e9"},
        plan + Arguments{"800", "--stopping-ms", "1e9"}, plan + Arguments{"800", "--tolerance", "1e6"},
        design + Arguments{"800", "--baseline", "0.1"}, design + Arguments{"0.8", "--baseline", "100"},
        design + Arguments{"800", "--thickness", "1e-3"}, run() + Arguments{"--thickness", "1e6"}}) {
    const auto result = box.run(wrong);
    CAPTURE(wrong, result.err);
    CHECK(result.status == 2);
    CHECK(result.out.empty());
  }
  for (const auto& [rate, speed] : {std::pair{"50", "1003"}, {"1e9", "1"}}) {
    box.write("skin.yaml", kPlane + "motion: {frame_rate_per_s: " + rate + ", object_speed_m_s: " + speed +
                               ", poses: [{time_s: 0.02, shift_mm: [0, 0, 1]}]}\n");
    check_bad_file(box, run(), "skin.yaml", "line 2");
  }
}

TEST_CASE("OpenCV's T has a unit when somebody says so") {
  const Watched box;
  REQUIRE(box.run({"calibrate", "--import", "rig.yaml", "--export-opencv", "ours.yml"}).status == 0);
  // Ours says it; who takes it out has a file as OpenCV's samples write it.
  CHECK(box.run({"map", "--skin", "skin.yaml", "--rig", "ours.yml", "--profile", "vga", "--json"}).status == 0);
  box.write("theirs.yml", replaced(box.read("ours.yml"), "length_unit: mm\n", ""));
  for (const Arguments& arguments :
       {Arguments{"map", "--skin", "skin.yaml", "--rig", "theirs.yml", "--profile", "vga", "--json"},
        Arguments{"plan", "rig", "--rig", "theirs.yml", "--distance", "800"},
        Arguments{"calibrate", "--import", "theirs.yml"}}) {
    check_bad_file(box, arguments, "theirs.yml", "--unit mm|cm|m");
  }
  const auto baseline = [&](const std::string& unit) {
    const auto result = box.run({"calibrate", "--import", "theirs.yml", "--unit", unit, "--json"});
    CAPTURE(result.err);
    REQUIRE(result.status == 0);
    return json::parse(result.out)["baseline_mm"].get<double>();
  };
  CHECK(baseline("mm") == Approx(50));
  CHECK(baseline("cm") == Approx(500));
  CHECK(box.run({"calibrate", "--import", "theirs.yml", "--unit", "m"}).status == 3);  // 50 m
  // What the file says itself is not overruled.
  CHECK(box.run({"calibrate", "--import", "ours.yml", "--unit", "mm"}).status == 0);
  check_bad_file(box, {"calibrate", "--import", "ours.yml", "--unit", "cm"}, "ours.yml", "the unit that --unit names");
}

TEST_CASE("Numbers beyond what images and sensors have are bad files, with a name") {
  Sandbox box;
  with_pairs(box);
  const cv::Mat truth(120, 200, CV_8UC1, cv::Scalar(40));
  save((box / "truth.png").string(), truth);
  const Arguments evaluate{"evaluate", "--left", "left0.png", "--right", "right0.png", "--disparity", "truth.png"};
  check_bad_file(box, evaluate + Arguments{"--resize", "1000"}, "left0.png", "resized by 1000 it is 2e+05x1.2e+05");
  check_bad_file(box, evaluate + Arguments{"--resize", "1e-9"}, "left0.png", "resized by 1e-09");
  check_bad_file(box, evaluate + Arguments{"--scale", "1e-9"}, "truth.png", "a disparity of 4e+10 px");
  std::string points;
  for (int i = 0; i < 12; ++i) {
    const std::string x = std::to_string(10 * (i % 4)), y = std::to_string(10 * (i / 4)), z = std::to_string(i * i % 7);
    points += x + " " + y + " " + z + " " + x + " " + y + "\n";
  }
  box.write("points.txt", points);
  const std::string sensor =
      "width_px: 640\nheight_px: 480\ndx_mm: 0.01\ndy_mm: 0.01\ncx_px: 319.5\ncy_px: 239.5\nsx: 1\n";
  const Arguments calibrate{"calibrate", "--points", "points.txt", "--sensor", "sensor.yaml"};
  for (const char* key : {"dx_mm", "dy_mm", "cx_px", "cy_px", "sx"}) {
    box.write("sensor.yaml", replaced(sensor, std::string(key) + ": [0-9.]+", std::string(key) + ": 1e308"));
    check_bad_file(box, calibrate, "sensor.yaml", std::string(key) + ": '1e308'");
  }
  box.write("sensor.yaml", sensor);
  box.write("points.txt", points + "1e308 0 0 1 1\n");
  check_bad_file(box, calibrate, "points.txt", "line 13: '1e308'");
}

TEST_CASE("A pattern that also matches images of another size is found before the work") {
  Sandbox box;
  with_pairs(box, 3);
  save((box / "left9.png").string(), textured(100, 120, 6));
  save((box / "right9.png").string(), textured(100, 120, 7));
  check_bad_file(box, run_arguments("left*.png", "right*.png"), "left9.png", "200x120 as in left0.png");
}
