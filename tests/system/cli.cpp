// SPDX-License-Identifier: Apache-2.0
// The program from outside: exit status, messages, files, and nothing left behind after an error.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <regex>
#include <string>
#include <vector>

#include "../unit/video_hole.hpp"
#include "pairs.hpp"
#include "rig_text.hpp"
#include "sandbox.hpp"

using namespace horopter::test;

TEST_CASE("run writes states, overlays and summary") {
  Sandbox box;
  with_pairs(box, 2);
  const auto result =
      box.run({"run", "--left", "left*.png", "--right", "right*.png", "--skin", "skin.yaml", "--out", "out"});
  CAPTURE(result.err);
  REQUIRE(result.status == 0);
  CHECK(result.err.empty());
  CHECK(box.files().contains("out/frame-0001-overlay.png"));
  CHECK(box.files().size() == 5 + 1 + 5);

  const auto summary = nlohmann::json::parse(box.read("out/summary.json"));
  CHECK(summary["engine"] == "native");
  CHECK(summary["profile"] == "vga");
  REQUIRE(summary["frames"].size() == 2);
  for (int i = 0; i < 2; ++i) {
    const auto& frame = summary["frames"][static_cast<std::size_t>(i)];
    const std::string number = std::to_string(i);
    CHECK(frame["frame"] == i);
    CHECK(frame["left"] == "left" + number + ".png");
    CHECK(frame["right"] == "right" + number + ".png");
    CHECK(frame["table"] == 0);
    CHECK(frame["table_crc"].get<std::string>().size() == 8);
    CHECK(frame["alarm"] == true);
    CHECK(frame["safe"] == false);
    CHECK(frame["faults"].empty());
    CHECK(!frame.contains("cycles"));

    // The picture agrees with the numbers.
    const cv::Mat state = cv::imread((box / ("out/frame-000" + number + "-state.png")).string(), cv::IMREAD_UNCHANGED);
    REQUIRE(state.type() == CV_8UC1);
    REQUIRE(state.size() == cv::Size(200, 120));
    CHECK(cv::countNonZero(state == 255) == frame["skin_pixels"].get<int>());
    CHECK(cv::countNonZero(state == 128) == frame["undecidable_pixels"].get<int>());
    CHECK(cv::countNonZero(state == 64) == frame["unsupervised_pixels"].get<int>());
    int pixels = 0;
    for (const auto& region : frame["regions"]) pixels += region["pixels"].get<int>();
    CHECK(pixels == frame["skin_pixels"].get<int>());
    const auto& region = frame["regions"][0];
    const cv::Rect found(region["x"], region["y"], region["width"], region["height"]);
    CHECK((found & kBlock).area() * 10 > 8 * (found | kBlock).area());

    const cv::Mat overlay = cv::imread((box / ("out/frame-000" + number + "-overlay.png")).string());
    CHECK(overlay.cols == 600);
  }
}

TEST_CASE("run --json prints the summary and nothing else") {
  Sandbox box;
  with_pairs(box);
  const auto result = box.run(run_arguments() + std::vector<std::string>{"--json", "--no-overlay"});
  CHECK(result.status == 0);
  CHECK(nlohmann::json::parse(result.out) == nlohmann::json::parse(box.read("out/summary.json")));
  CHECK(!fs::exists(box / "out/frame-0000-overlay.png"));
}

TEST_CASE("Thresholds and limits change what they name") {
  Sandbox box;
  with_pairs(box);
  const auto frame = [&](const std::vector<std::string>& more) {
    const auto result = box.run(run_arguments() + more + std::vector<std::string>{"--json"});
    CAPTURE(result.err);
    CHECK((result.status == 0 || result.status == 4));
    return nlohmann::json::parse(result.out)["frames"][0];
  };
  const auto normal = frame({});
  CHECK(frame({"--threshold", "0.1"})["skin_pixels"].get<int>() < normal["skin_pixels"].get<int>());
  CHECK(frame({"--threshold", "60"})["skin_pixels"].get<int>() > normal["skin_pixels"].get<int>());
  CHECK(frame({"--tolerance", "0.3"})["skin_pixels"].get<int>() < normal["skin_pixels"].get<int>());
  CHECK(frame({"--tolerance", "2.4"})["skin_pixels"].get<int>() > normal["skin_pixels"].get<int>());
  CHECK(frame({"--texture", "200"})["undecidable_pixels"].get<int>() > normal["undecidable_pixels"].get<int>());
  const auto high = frame({"--alarm-limit", "60", "--object", "0"});
  CHECK(high["alarm"] == false);
  CHECK(high["safe"] == true);
  CHECK(high["objects"].empty());
  const auto large = frame({"--alarm-limit", "60", "--object", "40px"});
  CHECK(large["alarm"] == true);
  REQUIRE(large["objects"].size() >= 1);
  CHECK(large["objects"][0]["area_px"].get<int>() >= 628);  // half of that disc
  for (const char* wrong : {"5", "40cm", "-1", "3mm", "px", "nan"}) {
    CAPTURE(wrong);
    CHECK(box.run(run_arguments() + std::vector<std::string>{"--object", wrong}).status == 2);
  }
  const auto huge = box.run(run_arguments() + std::vector<std::string>{"--object", "900px"});
  CHECK(huge.status == 2);
  CHECK(huge.err.find("does not fit into an image") != std::string::npos);
  check_bad_file(box, run_arguments() + std::vector<std::string>{"--object", "40mm"}, "skin.yaml",
                 "a homography knows no mm");
  const auto blind = frame({"--unsupervised-limit", "1"});
  CHECK(blind["faults"] == nlohmann::json{"too_unsupervised"});
  CHECK(blind["safe"] == false);
}

TEST_CASE("Objects have a place and size in mm with a rig, and are followed from frame to frame") {
  const std::string profile = GENERATE("vga", "field");
  const std::size_t fields = profile == "field" ? 2 : 1;
  CAPTURE(profile);
  Sandbox box;
  constexpr int kPairs = 4, kStep_px = 12;  // of 5 mm on the skin
  for (int i = 0; i < kPairs; ++i) {
    const cv::Mat left = textured(200, 120, static_cast<std::uint64_t>(i) + 1);
    const std::string number = std::to_string(i);
    save((box / ("left" + number + ".png")).string(), left);
    save((box / ("right" + number + ".png")).string(), right_of(left, kBlock + cv::Point(i * kStep_px, 0), -10, 0));
  }
  box.write("rig.yaml", rig_text());
  box.write("wall.yaml", "surface: {type: plane, point_mm: [0, 0, 1000], normal: [0, 0, -1]}\n");
  const std::vector<std::string> rated{"--frame-rate", profile == "field" ? "50" : "25"};
  const auto supervise = [&](const std::string& skin, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"run",       "--left", "left*.png", "--right", "right*.png", "--skin", skin,
                                       "--profile", profile,  "--object",  "40px",    "--out",      "out",    "--json"};
    const auto result = box.run(arguments + more);
    CAPTURE(result.err);
    REQUIRE((result.status == 0 || result.status == 4));
    return nlohmann::json::parse(result.out);
  };
  const std::vector<std::string> with_rig{"--rig", "rig.yaml"};
  const auto summary = supervise("wall.yaml", with_rig + rated);
  CHECK(summary["object"]["in_mm"] == true);
  CHECK(summary["frame_rate_per_s"] == 25 * fields);
  REQUIRE(summary["frames"].size() == kPairs * fields);
  for (std::size_t i = 0; i < summary["frames"].size(); ++i) {
    const auto& objects = summary["frames"][i]["objects"];
    CAPTURE(i, objects.dump());
    REQUIRE(objects.size() == 1);
    const auto& object = objects[0];
    CHECK(object["id"] == 1);
    CHECK(object["age_frames"] == i + 1);
    // A pixel of the result is 5 mm wide and high, or in fields 10.
    const double pixel_mm = 5.0 * static_cast<double>(fields);
    CHECK(object["area_mm2"].get<double>() ==
          Approx(object["area_px"].get<double>() * pixel_mm * pixel_mm).epsilon(0.01));
    const std::size_t pair = i / fields;
    const double x_mm = 5 * (60 + 35 + kStep_px * static_cast<double>(pair) - 100);
    CHECK(object["centroid_mm"][0].get<double>() == Approx(x_mm).margin(25));
    CHECK(object["centroid_mm"][1].get<double>() == Approx(5 * (30 + 25 - 60)).margin(25));
    CHECK(object["centroid_mm"][2].get<double>() == Approx(1000).margin(5));
    CHECK(object["size_mm"][0].get<double>() == Approx(350).margin(60));
    CHECK(object["size_mm"][1].get<double>() == Approx(250).margin(60));
    REQUIRE(object.contains("velocity_mm_s") == (i >= fields));
    if (i < 3 * fields) continue;
    CHECK(object["velocity_mm_s"][0].get<double>() == Approx(1500).margin(200));
    CHECK(object["velocity_mm_s"][1].get<double>() == Approx(0).margin(200));
    CHECK(object["velocity_mm_s"][2].get<double>() == Approx(0).margin(20));
  }
  // The same of a table that was made before: its rig is in it.
  REQUIRE(
      box.run({"map", "--skin", "wall.yaml", "--rig", "rig.yaml", "--profile", profile, "-o", "wall.hmap"}).status ==
      0);
  const auto by_table = supervise("wall.hmap", rated);
  for (std::size_t i = 0; i < summary["frames"].size(); ++i) {
    CHECK(by_table["frames"][i]["objects"] == summary["frames"][i]["objects"]);
  }
  // Without a rate by the frame, without a rig in px.
  const auto unrated = supervise("wall.yaml", with_rig);
  CHECK_FALSE(unrated.contains("frame_rate_per_s"));
  const auto& last = unrated["frames"].back()["objects"][0];
  CHECK(last["velocity_mm_frame"][0].get<double>() == Approx(60.0 / static_cast<double>(fields)).margin(8));
  CHECK_FALSE(last.contains("velocity_mm_s"));
  box.write("no_rig.yaml", "surface: {type: homography, matrix: [[1, 0, -10], [0, 1, 0], [0, 0, 1]]}\n");
  const auto without = supervise("no_rig.yaml", rated);
  CHECK(without["object"]["in_mm"] == false);
  const auto& in_px = without["frames"].back()["objects"][0];
  for (const char* mm : {"area_mm2", "size_mm", "centroid_mm", "velocity_mm_s", "velocity_mm_frame"}) {
    CHECK_FALSE(in_px.contains(mm));
  }
  CHECK(in_px["velocity_px_s"][0].get<double>() == Approx(25.0 * kStep_px / static_cast<double>(fields)).margin(30));
  CHECK(in_px["id"] == 1);
}

TEST_CASE("An alarm by two of three frames: where a hand is seen so often, and with what the frames show") {
  Sandbox box;
  const std::string shown = "0000101101000";
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const cv::Mat left = textured(200, 120, i + 1);
    const std::string number = (i < 10 ? "0" : "") + std::to_string(i);
    save((box / ("left" + number + ".png")).string(), left);
    save((box / ("right" + number + ".png")).string(),
         shown[i] == '1' ? right_of(left, kBlock, -10, 0) : textured(200, 120, 4711 + i));
  }
  box.write("rig.yaml", rig_text());
  box.write("wall.yaml", "surface: {type: plane, point_mm: [0, 0, 1000], normal: [0, 0, -1]}\n");
  const std::vector<std::string> run{"run",    "--left",     "left*.png", "--right",  "right*.png",
                                     "--skin", "wall.yaml",  "--rig",     "rig.yaml", "--object",
                                     "40px",   "--unproven", "--out",     "out",      "--json"};
  const auto asked = [&](const std::string& frames, const std::string& rate) {
    return std::vector<std::string>{"--alarm-frames", frames, "--frame-rate", rate};
  };
  const auto result = box.run(run + asked("2/3", "25"));
  CAPTURE(result.err);
  REQUIRE((result.status == 0 || result.status == 4));
  const auto summary = nlohmann::json::parse(result.out);
  std::string seen, alarms;
  for (const auto& frame : summary["frames"]) {
    CAPTURE(frame.dump());
    CHECK(frame["faults"].empty());
    seen += frame["alarm_seen"] == true ? '1' : '0';
    alarms += frame["alarm"] == true ? '1' : '0';
    CHECK(frame["objects"].size() == (frame["alarm_seen"] == true ? 1 : 0));
  }
  CHECK(seen == shown);
  CHECK(alarms == "0000001101000");
  const auto refused = [&](const std::vector<std::string>& more, const std::string& message) {
    const auto wrong = box.run(run + more);
    CAPTURE(more, wrong.err);
    CHECK((wrong.status == 2 || wrong.status == 3));
    CHECK(wrong.err.find(message) != std::string::npos);
  };
  refused(asked("7/7", "25"), "it may be seen in ");
  refused(asked("2/3", "10"), "frames a second, or 1/1");
  refused({"--alarm-frames", "2/3"}, "Expected --frame-rate");
  for (const char* wrong : {"3/2", "0/1", "2", "2/8", "2/3x", "", "-1/2"}) refused(asked(wrong, "25"), "expected N/M");
  CHECK(box.run(run + asked("1/1", "1")).status != 2);  // by one frame it is as it always was
  REQUIRE(box.run({"map", "--skin", "wall.yaml", "--rig", "rig.yaml", "--profile", "vga", "-o", "wall.hmap"}).status ==
          0);
  check_bad_file(box,
                 std::vector<std::string>{"run", "--left", "left*.png", "--right", "right*.png", "--skin", "wall.hmap",
                                          "--out", "out"} +
                     asked("2/3", "25"),
                 "wall.hmap", "how thick its skin is");
}

TEST_CASE("An alarm by two of three frames takes no images with a hole in their numbers") {
  Sandbox box;
  with_pairs(box, 4);
  box.write("rig.yaml", rig_text());
  box.write("wall.yaml", "surface: {type: plane, point_mm: [0, 0, 1000], normal: [0, 0, -1]}\n");
  const auto run = [](const std::string& left, const std::string& right, const std::string& frames) {
    return run_arguments(left, right, "wall.yaml") +
           std::vector<std::string>{"--rig", "rig.yaml", "--alarm-frames", frames, "--frame-rate", "1000"};
  };
  const auto done = [&](const std::vector<std::string>& arguments) {
    const auto result = box.run(arguments);
    CAPTURE(arguments, result.err);
    CHECK((result.status == 0 || result.status == 4));
    fs::remove_all(box / "out");
  };
  done(run("left*.png", "right*.png", "2/3"));
  for (const char* lost : {"left2.png", "right2.png"}) fs::remove(box / lost);
  check_bad_file(box, run("left*.png", "right*.png", "2/3"), "left3.png", "expected number 2");
  done(run("left*.png", "right*.png", "1/3"));
  done(run("left[01].png", "right[01].png", "2/3"));
}

TEST_CASE("--object in mm is that of the skin's file by its table alone; a table without a rig is refused") {
  Sandbox box;
  with_pairs(box);
  box.write("rig.yaml", rig_text());
  box.write("wall.yaml", "surface: {type: plane, point_mm: [0, 0, 1000], normal: [0.3, 0, -1]}\n");
  const auto object_px = [&](const std::string& skin, const std::vector<std::string>& more) {
    const auto result = box.run(run_arguments("left0.png", "right0.png", skin) + more +
                                std::vector<std::string>{"--object", "260mm", "--json"});
    CAPTURE(skin, result.err);
    REQUIRE((result.status == 0 || result.status == 4));
    return nlohmann::json::parse(result.out)["object"]["px"].get<double>();
  };
  const std::vector<std::string> rig{"--rig", "rig.yaml"};
  const std::string profile = GENERATE("vga", "field");
  const std::vector<std::string> build{"--profile", profile};
  REQUIRE(box.run(std::vector<std::string>{"map", "--skin", "wall.yaml", "-o", "wall.hmap"} + rig + build).status == 0);
  const double by_skin = object_px("wall.yaml", rig + build);
  // It is judged by its area, half the disc's, less what a code can be too small; px are judged by their number.
  const auto limit_of = [&](const std::string& size) {
    const auto result = box.run(run_arguments("left0.png", "right0.png", "wall.hmap") + build +
                                std::vector<std::string>{"--object", size, "--json"});
    return nlohmann::json::parse(result.out)["object"];
  };
  CHECK(limit_of("260mm")["limit"] == "area");
  CHECK(limit_of("260mm")["area_mm2"].get<double>() == Approx(M_PI / 8 * 260 * 260).margin(0.001));
  CHECK(limit_of("60px")["limit"] == "pixels");
  CHECK_FALSE(limit_of("60px").contains("area_mm2"));
  CHECK(by_skin < 52);   // 260 mm at 1 m
  CHECK(by_skin >= 40);  // the smallest in `field`
  CHECK(object_px("wall.hmap", build) == Approx(by_skin).epsilon(0.02));
  REQUIRE(
      box.run(std::vector<std::string>{"map", "--skin", "skin.yaml", "-o", "none.hmap", "--size", "200x120"} + build)
          .status == 0);
  fs::remove_all(box / "out");
  check_bad_file(
      box, run_arguments("left0.png", "right0.png", "none.hmap") + build + std::vector<std::string>{"--object", "40mm"},
      "none.hmap", "without a rig knows no mm");
  // At 1 m 5 mm are 1 px.
  CHECK(box.run(run_arguments("left0.png", "right0.png", "wall.hmap") + build +
                std::vector<std::string>{"--object", "5mm"})
            .status == 2);
}

TEST_CASE("Where nothing is asked for, a body of 40 mm is an alarm, or the smallest that can be found; px without mm") {
  Sandbox box;
  with_pairs(box);
  box.write("rig.yaml", rig_text());
  const auto usual = [&](const std::string& skin, const std::vector<std::string>& more = {"--rig", "rig.yaml"}) {
    const auto result =
        box.run(run_arguments("left0.png", "right0.png", skin) + more + std::vector<std::string>{"--json"});
    CAPTURE(skin, result.err);
    REQUIRE((result.status == 0 || result.status == 4));
    return nlohmann::json::parse(result.out)["object"];
  };
  const auto plane = [&](const std::string& name, int mm) {
    box.write(name + ".yaml",
              "surface: {type: plane, point_mm: [0, 0, " + std::to_string(mm) + "], normal: [0, 0, -1]}\n");
    REQUIRE(box.run({"map", "--skin", name + ".yaml", "--rig", "rig.yaml", "--profile", "vga", "-o", name + ".hmap"})
                .status == 0);
  };
  plane("near", 300);
  CHECK(usual("near.yaml")["mm"] == 40);
  CHECK(usual("near.hmap", {})["mm"] == 40);
  CHECK(usual("near.yaml")["area_mm2"].get<double>() == Approx(M_PI / 8 * 40 * 40).margin(0.001));
  // 20 px are the smallest of which more than half is certain to be one object.
  plane("far", 1000);
  const auto far = usual("far.yaml");
  CHECK(far["px"].get<double>() == Approx(20).margin(0.2));
  CHECK(far["mm"] == 100);
  CHECK(usual("far.hmap", {})["mm"].get<double>() == Approx(100).margin(1));
  // At 0.4 m and at 8 m: what is 20 px there is more than 100 px here.
  box.write(
      "deep.yaml",
      "surface: {type: planes, polygons_mm: [[[-150, -80, 400], [-20, -80, 400], [-20, 80, 400], [-150, 80, 400]], "
      "[[0, -2000, 8000], [3000, -2000, 8000], [3000, 2000, 8000], [0, 2000, 8000]]]}\n");
  const auto deep = usual("deep.yaml");
  CHECK(deep["px"] == 100);
  CHECK(deep["limit"] == "pixels");
  CHECK(usual("skin.yaml", {})["px"] == 100);
  // The machine's limits are the same, whoever writes them.
  const auto uploaded = box.run({"upload", "--engine", "native", "--map", "near.hmap", "--json"});
  CAPTURE(uploaded.err);
  REQUIRE(uploaded.status == 0);
  const auto report = nlohmann::json::parse(uploaded.out);
  const auto& names = report["changed"];
  CHECK(std::ranges::find(names, "OBJECT_AREA_LIMIT") != names.end());
  CHECK(report["object"]["limit"] == "area");
  CHECK(report["object"]["mm"] == 40);
  CHECK_THAT(box.run({"upload", "--engine", "native", "--map", "near.hmap"}).out,
             Catch::Contains("\nobject    40 mm, an area of "));
}

TEST_CASE("An object that is larger than the skin is refused where it was asked for, and said where it was not") {
  Sandbox box;
  with_pairs(box);
  box.write("rig.yaml", rig_text());
  // 60 × 60 px of the left image: less than half of a disc of 100 px, and than one of 80 px.
  box.write("small.yaml",
            "surface: {type: planes, polygons_mm: [[[-100, -150, 1000], [200, -150, 1000], [200, 150, 1000], "
            "[-100, 150, 1000]]]}\n");
  const std::vector<std::string> small = run_arguments("left0.png", "right0.png", "small.yaml") +
                                         std::vector<std::string>{"--rig", "rig.yaml", "--alarm-limit", "1"};
  check_bad_file(box, small + std::vector<std::string>{"--object", "80px"}, "small.yaml", "no object can be an alarm");
  // The right image is moved so far that only 40 px of the left one's width have a partner. Nothing is known in mm.
  box.write("moved.yaml", "surface:\n  type: homography\n  matrix: [[1, 0, -160], [0, 1, 0], [0, 0, 1]]\n");
  const auto told = box.run(run_arguments("left0.png", "right0.png", "moved.yaml"));
  CAPTURE(told.err);
  CHECK((told.status == 0 || told.status == 4));
  CHECK_THAT(told.out, Catch::Contains("so only --alarm-limit counts"));
  const auto object = nlohmann::json::parse(box.read("out/summary.json"))["object"];
  CHECK(object["judgeable_pixels"].get<int>() > 1000);
  CHECK(object["judgeable_pixels"].get<int>() < object["pixels"].get<int>());
  const auto fits = box.run(small + std::vector<std::string>{"--object", "30px"});
  CHECK((fits.status == 0 || fits.status == 4));
  CHECK_THAT(fits.out, !Catch::Contains("only --alarm-limit counts"));
  const auto none = box.run(small + std::vector<std::string>{"--object", "0"});
  CHECK_THAT(none.out, Catch::Contains("none is an alarm by itself"));
}

TEST_CASE("A skin that is parted by gaps, or too narrow for the usual object, is a warning") {
  const Sandbox box;
  box.write("rig.yaml", two_cameras(640, 480, 535, "-100, 0, 0"));
  const auto warns = [&](double side_mm, double gap_mm, int rows) {
    std::string text;
    for (int i = -6; i < 6; ++i) {
      for (int j = -rows; j < rows; ++j) {
        const double left = side_mm * i + gap_mm / 2, right = side_mm * (i + 1) - gap_mm / 2;
        const double top = side_mm * j + gap_mm / 2, bottom = side_mm * (j + 1) - gap_mm / 2;
        const auto corner = [](double x, double y) {
          return "[" + std::to_string(x) + ", " + std::to_string(y) + ", 500]";
        };
        text += (text.empty() ? "[" : ", [") + corner(left, top) + ", " + corner(right, top) + ", " +
                corner(right, bottom) + ", " + corner(left, bottom) + "]";
      }
    }
    box.write("skin.yaml", "surface: {type: planes, polygons_mm: [" + text + "]}\n");
    const auto result = box.run({"upload", "--engine", "native", "--profile", "vga", "--skin", "skin.yaml", "--rig",
                                 "rig.yaml", "--alarm-limit", "0.3", "--json"});
    INFO(result.err);
    REQUIRE(result.status == 0);
    return nlohmann::json::parse(result.out).value("warnings", nlohmann::json()).dump().find("parted by gaps") !=
           std::string::npos;
  };
  CHECK_FALSE(warns(50, 0, 5));
  CHECK(warns(50, 1, 5));
  CHECK(warns(14, 0, 1));
}

TEST_CASE("What a skin can show of an object is its area, also where another part of the skin is far away") {
  const Sandbox box;
  box.write("rig.yaml", two_cameras(640, 480, 800, "-200, 0, 0"));
  const auto patch = [](int left_mm, int top_mm, int width_mm, int height_mm, int z_mm) {
    const auto corner = [&](int x, int y) {
      return "[" + std::to_string(x) + ", " + std::to_string(y) + ", " + std::to_string(z_mm) + "]";
    };
    const int right_mm = left_mm + width_mm, bottom_mm = top_mm + height_mm;
    return "[" + corner(left_mm, top_mm) + ", " + corner(right_mm, top_mm) + ", " + corner(right_mm, bottom_mm) + ", " +
           corner(left_mm, bottom_mm) + "]";
  };
  const auto upload = [&](const std::string& patches) {
    box.write("skin.yaml", "surface: {type: planes, polygons_mm: [" + patches + "]}\n");
    return std::vector<std::string>{"upload", "--engine",      "native", "--profile", "vga",
                                    "--skin", "skin.yaml",     "--rig",  "rig.yaml",  "--object",
                                    "40mm",   "--alarm-limit", "0.1"};
  };
  const auto warned = [&](const std::string& patches) {
    const auto result = box.run(upload(patches));
    CAPTURE(patches, result.err);
    REQUIRE(result.status == 0);
    return result.err;
  };
  const auto strips = [&](int width_mm, int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
      text += (i == 0 ? "" : ", ") + patch(-40 + i * (width_mm + 10), -150, width_mm, 250, 600);
    return text;
  };
  // At 1550 mm 40 mm have 1/7 of the pixels that they have at 600 mm.
  const std::string far = ", " + patch(0, 350, 200, 100, 1550);
  const auto says = Catch::Contains("of this skin an object of 40 mm shows less than it takes for an alarm");
  CHECK_THAT(warned(strips(30, 7)), says);
  CHECK_THAT(warned(strips(30, 7) + far), says);
  CHECK_THAT(warned(strips(90, 2)), !Catch::Contains("parted by gaps"));
  CHECK_THAT(warned(strips(90, 2) + far), !Catch::Contains("parted by gaps"));
  // 40 × 40 px, of which about 500 are judged, and a strip that is narrower than the windows.
  check_bad_file(box, upload(patch(60, -15, 30, 30, 600) + ", " + patch(0, 350, 200, 30, 1550)), "skin.yaml",
                 "one of 40 mm across takes 628 mm2");
}

TEST_CASE("A skin that moves is said to be too narrow for an object where it is narrowest") {
  const Sandbox box;
  box.write("rig.yaml", two_cameras(320, 240, 535, "-50, 0, 0"));
  save((box / "left0.png").string(), textured(320, 240, 1));
  save((box / "right0.png").string(), textured(320, 240, 2));
  // A strip that is 50 px wide at 400 mm, and 38 px at 526 mm; the windows take 18 px of it.
  const auto warned = [&](int from_mm, int to_mm) {
    const std::string z = std::to_string(from_mm);
    box.write("skin.yaml", "surface: {type: planes, polygons_mm: [[[-18.7, -200, " + z + "], [18.7, -200, " + z +
                               "], [18.7, 200, " + z + "], [-18.7, 200, " + z +
                               "]]]}\nmotion: {frame_rate_per_s: 50, object_speed_m_s: 0.01, poses: [{time_s: 0.1, "
                               "shift_mm: [0, 0, " +
                               std::to_string(to_mm - from_mm) + "]}]}\n");
    const auto result = box.run(run_arguments() + std::vector<std::string>{"--rig", "rig.yaml", "--object", "60px",
                                                                           "--alarm-limit", "1", "--json"});
    CAPTURE(from_mm, to_mm, result.err);
    REQUIRE((result.status == 0 || result.status == 4));
    return nlohmann::json::parse(result.out).value("warnings", nlohmann::json()).dump();
  };
  CHECK_THAT(warned(400, 402), !Catch::Contains("parted by gaps"));
  CHECK_THAT(warned(526, 400), Catch::Contains("table 1 of ") && Catch::Contains("parted by gaps"));
  CHECK_THAT(warned(400, 526), Catch::Contains("parted by gaps"));
}

TEST_CASE("A machine's commands answer in JSON, and upload writes the mode that it is given") {
  Sandbox box;
  box.write("skin.yaml", "surface:\n  type: homography\n  matrix: [[1, 0, -3], [0, 1, 0], [0, 0, 1]]\n");
  REQUIRE(box.run({"map", "--skin", "skin.yaml", "--profile", "vga", "-o", "skin.hmap"}).status == 0);
  const std::vector<std::string> upload{"upload", "--engine", "native", "--map", "skin.hmap", "--json"};
  const auto report = [&](const std::vector<std::string>& more) {
    const auto result = box.run(upload + more);
    CAPTURE(result.err);
    REQUIRE(result.status == 0);
    return nlohmann::json::parse(result.out);
  };
  const auto changes = [&](const nlohmann::json& uploaded, const char* name) {
    return std::ranges::find(uploaded["changed"], name) != uploaded["changed"].end();
  };
  CHECK(changes(report({"--live"}), "MODE"));
  const auto plain = report({});
  CHECK_FALSE(changes(plain, "MODE"));  // it was 0
  CHECK_FALSE(changes(plain, "SUM_LIMIT"));
  CHECK_FALSE(plain.contains("tolerance_px"));
  // The skin's thickness, as of `run`.
  const auto thin = report({"--tolerance", "0.5"});
  CHECK(thin["tolerance_px"] == 0.5);
  CHECK(changes(thin, "SUM_LIMIT"));
  CHECK_THAT(box.run(upload + std::vector<std::string>{"--thickness", "20"}).err, Catch::Contains("--thickness"));
  CHECK(box.run(upload + std::vector<std::string>{"--tolerance", "0.5", "--threshold", "20"}).status == 2);
  const auto status = box.run({"status", "--engine", "native"});
  CHECK_THAT(status.out, Catch::Contains("cameras   they wait until their pixels are taken"));
  const auto restart = box.run({"restart", "--engine", "native", "--json"});
  CHECK(restart.status == 4);
  const auto answer = nlohmann::json::parse(restart.out);
  CHECK(answer["engine"] == "native");
  CHECK(answer["restarted"] == false);
  CHECK(answer["safe"] == false);
  CHECK_THAT(answer["reason"].get<std::string>(), Catch::Contains("`horopter upload --restart register`"));
}

#ifdef HOROPTER_TEST_RTL
TEST_CASE("The hardware and the native engine write the same pictures") {
  Sandbox box;
  with_pairs(box, 2);
  const std::vector<std::string> profile =
      GENERATE(std::vector<std::string>{}, std::vector<std::string>{"--profile", "field"},
               std::vector<std::string>{"--profile", "vga", "--decision", "compete"});
  const auto images =
      std::vector<std::string>{"run",        "--left",     "left0.png",  "left1.png", "left1.png", "--right",
                               "right0.png", "right1.png", "right1.png", "--skin",    "skin.yaml"};
  const auto native = box.run(images + profile + std::vector<std::string>{"--out", "native"});
  const auto rtl = box.run(images + profile + std::vector<std::string>{"--out", "rtl", "--engine", "rtl"});
  CAPTURE(rtl.err);
  CHECK(native.status == 4);  // the last pair is frozen
  CHECK(rtl.status == native.status);
  auto expected = nlohmann::json::parse(box.read("native/summary.json"));
  auto found = nlohmann::json::parse(box.read("rtl/summary.json"));
  CHECK(found["engine"] == "rtl");
  REQUIRE(found["frames"].size() == expected["frames"].size());
  for (std::size_t i = 0; i < found["frames"].size(); ++i) {
    auto& frame = found["frames"][i];
    CHECK(frame["cycles"].get<int>() > 100 * 60);
    frame.erase("cycles");
    CHECK(frame == expected["frames"][i]);
    const std::string name = "/frame-000" + std::to_string(i) + "-state.png";
    CHECK(box.read("rtl" + name) == box.read("native" + name));
  }
}
#endif

const char* const kMoving =
    "surface: {type: plane, point_mm: [0, 0, 800], normal: [0, 0, 1]}\n"
    "motion: {frame_rate_per_s: 50, object_speed_m_s: 1.6, poses: [{time_s: 0.06, shift_mm: [0, 0, 100]}]}\n";
constexpr int kRecorded = 5;

/// left.mkv and right.mkv of with_pairs(box, kRecorded).
void record(const Sandbox& box, double images_per_s) {
  for (const std::string side : {"left", "right"}) {
    cv::VideoWriter video((box / (side + ".mkv")).string(), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), images_per_s,
                          {200, 120});
    REQUIRE(video.isOpened());
    for (int i = 0; i < kRecorded; ++i) video.write(cv::imread((box / (side + std::to_string(i) + ".png")).string()));
  }
}
/// Both, from image `first` on.
void delay(const Sandbox& box, int first, int by_ms) {
  for (const std::string name : {"left.mkv", "right.mkv"}) {
    std::string bytes = box.read(name);
    horopter::delay_images(bytes, first, kRecorded, by_ms);
    box.write(name, bytes);
  }
}

TEST_CASE("A skin that moves takes no videos with a hole in time, though both have it") {
  Sandbox box;
  with_pairs(box, kRecorded);
  box.write("rig.yaml", rig_text());
  box.write("moving.yaml", kMoving);
  record(box, 50);
  std::vector<std::string> arguments = run_arguments("left.mkv", "right.mkv", "moving.yaml");
  for (const char* more : {"--rig", "rig.yaml", "--still-scene"}) arguments.emplace_back(more);
  const auto whole = box.run(arguments);
  CAPTURE(whole.err);
  CHECK(whole.status == 0);
  delay(box, 3, 20);
  const auto holed = box.run(arguments);
  CHECK(holed.status == 3);
  CHECK_THAT(holed.err, Catch::Contains("left.mkv#3: images are missing before it: 1"));
}

TEST_CASE("A video that comes at another rate than it is told is refused where time is reckoned by it") {
  Sandbox box;
  with_pairs(box, 5);
  box.write("rig.yaml", rig_text());
  box.write("wall.yaml", "surface: {type: plane, point_mm: [0, 0, 1000], normal: [0, 0, -1]}\n");
  box.write("moving.yaml", kMoving);
  const auto run = [&](const std::string& skin, const std::vector<std::string>& more) {
    const auto result = box.run(
        run_arguments("left.mkv", "right.mkv", skin) +
        std::vector<std::string>{"--rig", "rig.yaml", "--still-scene", "--unproven", "--object", "40px"} + more);
    CAPTURE(result.err);
    CHECK((result.status == 3 || result.err.empty()));
    return result;
  };
  const auto refused = [&](const auto& result, const std::string& message) {
    CAPTURE(result.err);
    CHECK(result.status == 3);
    CHECK_THAT(result.err, Catch::Contains(message));
  };
  record(box, 25);
  CHECK(run("wall.yaml", {"--frame-rate", "25"}).status != 3);
  refused(run("wall.yaml", {"--frame-rate", "50"}), "left.mkv#0: the video has 25 results a second; expected 50");
  refused(run("moving.yaml", {}), "left.mkv#0: the video has 25 results a second; expected 50");
  CHECK(run("moving.yaml", {"--profile", "field"}).status != 3);  // two results of each image
  // None is missing, but an object goes farther in this time than the skin's steps are planned for.
  record(box, 50);
  CHECK(run("moving.yaml", {}).status != 3);
  delay(box, 2, 8);
  refused(run("moving.yaml", {}),
          "left.mkv#2: it comes 0.028 s after the image before it, by the video's times; expected "
          "0.021 s at most");
  // Nor is it known how much later a second video begins.
  record(box, 50);
  const auto again = box.run({"run", "--left", "left.mkv", "left.mkv", "--right", "right.mkv", "right.mkv", "--skin",
                              "moving.yaml", "--rig", "rig.yaml", "--still-scene", "--out", "out"});
  refused(again, "left.mkv#0: this video begins after another one");
  // Images that come a little earlier, time and again: the skin would be ever later than its robot.
  for (int i = 1; i < kRecorded; ++i) delay(box, i, -8);
  refused(run("moving.yaml", {}), "left.mkv#2: it is of 0.024 s by the video's times; expected 0.040 s");
  // And such as come a little later.
  record(box, 50);
  for (int i = 1; i < kRecorded; ++i) delay(box, i, 8);
  refused(run("moving.yaml", {}), "left.mkv#1: it comes 0.028 s after the image before it");
  // An alarm by more than one frame: a hand is seen once less for each image that is missing.
  const std::vector<std::string> two{"--alarm-frames", "2/3", "--frame-rate", "50"};
  CHECK(run("wall.yaml", two).status != 3);
  delay(box, 3, 12);
  refused(run("wall.yaml", two), "left.mkv#3: images are missing before it: 1");
}

TEST_CASE("A rig that was designed and not measured is a warning wherever real images are judged") {
  Sandbox box;
  with_pairs(box);
  box.write("measured.yaml", rig_text());
  box.write("wall.yaml", "surface: {type: plane, point_mm: [0, 0, 1000], normal: [0, 0, -1]}\n");
  box.write("moving.yaml", kMoving);
  REQUIRE(box.run({"plan", "rig", "--focal", "4", "--pixel", "20", "--image-size", "200x120", "--baseline", "50",
                   "--distance", "1000", "--out", "plan"})
              .status == 0);
  REQUIRE(
      box.run({"map", "--rig", "plan/rig.yaml", "--skin", "wall.yaml", "--profile", "vga", "-o", "wall.hmap"}).status ==
      0);
  const auto warns = [&](const std::vector<std::string>& arguments) {
    const auto result = box.run(arguments + std::vector<std::string>{"--object", "40px", "--json"});
    CAPTURE(result.err);
    REQUIRE((result.status == 0 || result.status == 4));
    return nlohmann::json::parse(result.out).value("warnings", nlohmann::json()).dump().find("was designed") !=
           std::string::npos;
  };
  const auto run = [&](const std::string& skin, const std::vector<std::string>& more) {
    return warns(run_arguments("left0.png", "right0.png", skin) + more);
  };
  CHECK(run("wall.yaml", {"--rig", "plan/rig.yaml"}));
  // 100 mm are 20 px there, but for the last bit: the usual body is one that is not refused.
  const auto usual = box.run(run_arguments("left0.png", "right0.png", "wall.yaml") +
                             std::vector<std::string>{"--rig", "plan/rig.yaml"});
  CAPTURE(usual.err);
  CHECK(usual.status != 2);
  CHECK(run("moving.yaml", {"--rig", "plan/rig.yaml"}));
  CHECK(run("wall.hmap", {}));
  CHECK_FALSE(run("wall.yaml", {"--rig", "measured.yaml"}));
  CHECK(warns({"upload", "--engine", "native", "--map", "wall.hmap"}));
  box.write("cell.yaml",
            "name: designed\ncameras:\n  left: {source: \"files:left0.png\", repeat: true}\n"
            "  right: {source: \"files:right0.png\", repeat: true}\n  frames_per_s: 5\n  largest_skew_ms: 5\n"
            "rig: plan/rig.yaml\nskin: wall.yaml\nrestart: by_itself\nlimits: {decision_ms: 2000, object: 40px}\n");
  const auto monitor = box.run({"monitor", "cell.yaml", "--frames", "1"});
  CHECK(monitor.status == 0);
  CHECK_THAT(monitor.err, Catch::Contains("wall.yaml: the rig of this skin was designed"));
}

TEST_CASE("--teach with no pair behind those that teach supervises nothing, and is an error") {
  Sandbox box;
  with_pairs(box, kRecorded);
  const std::vector<std::string> teach{"--teach", "20"};
  check_bad_file(box, run_arguments("left*.png", "right*.png") + teach, "left*.png",
                 "more than the 20 pairs of --teach");
  check_bad_file(box, run_arguments() + std::vector<std::string>{"--teach", "1"}, "left0.png", "end after 1 pairs");
  CHECK(box.run(run_arguments("left*.png", "right*.png") + std::vector<std::string>{"--teach", "2", "--frames", "2"})
            .status == 2);
  // This video does not say how many images it has. Nothing lies on this skin, and the right images are nearly alike.
  box.write("empty.yaml", "surface:\n  type: homography\n  matrix: [[1, 0, -40], [0, 1, 0], [0, 0, 1]]\n");
  record(box, 50);
  const auto video =
      box.run(run_arguments("left.mkv", "right.mkv", "empty.yaml") + teach + std::vector<std::string>{"--still-scene"});
  CHECK(video.status == 3);
  CHECK_THAT(video.err, Catch::Contains("left.mkv: the images end after 5 pairs"));
  const auto summary = nlohmann::json::parse(box.read("out/incomplete/summary.json"));
  CHECK(summary["taught"]["pairs"] == kRecorded);
  CHECK(summary["frames"].size() == kRecorded);
}

TEST_CASE("--teach with an alarm or a fault in the pairs that teach: nothing is taught, and it is an error") {
  Sandbox box;
  with_pairs(box, kRecorded);
  for (const int i : {0, 1, 3, 4}) {  // nothing is in the skin
    save((box / ("right" + std::to_string(i) + ".png")).string(),
         textured(200, 120, static_cast<std::uint64_t>(100 + i)));
  }
  int status = 3;
  std::string message = "left2.png: pair 3 of --teach 4 has an alarm: nothing is taught";
  SECTION("somebody comes") {}
  SECTION("a camera is covered") {
    status = 4;
    message = "left2.png: pair 3 of --teach 4 has right_black";
    save((box / "right2.png").string(), cv::Mat::zeros(120, 200, CV_8UC1));
  }
  const auto result = box.run(run_arguments("left*.png", "right*.png") + std::vector<std::string>{"--teach", "4"});
  CAPTURE(result.err);
  CHECK(result.status == status);
  CHECK_THAT(result.err, Catch::Contains(message) && Catch::Contains("expected pairs of the empty zone"));
  CHECK_FALSE(fs::exists(box / "out/summary.json"));
  const auto summary = nlohmann::json::parse(box.read("out/incomplete/summary.json"));
  CHECK(summary["frames"].size() == 3);
  CHECK_FALSE(summary.contains("taught"));
}

TEST_CASE("--teach with a skin that moves: all of its way") {
  Sandbox box;
  with_pairs(box, kRecorded + 1);
  box.write("rig.yaml", rig_text());
  box.write("moving.yaml", kMoving);
  const auto run = [&](const char* pairs) {
    return box.run({"run", "--left", "left*.png", "--right", "right*.png", "--skin", "moving.yaml", "--rig", "rig.yaml",
                    "--still-scene", "--out", "out", "--teach", pairs});
  };
  const auto some = run("4");
  CHECK(some.status == 2);
  CHECK_THAT(some.err, Catch::Contains("--teach 4: the skin moves in 5 images"));
  const int all = run("5").status;
  CHECK((all == 0 || all == 4));
}

TEST_CASE("A skin that moves: every frame names its table and time") {
  Sandbox box;
  with_pairs(box, 5);
  box.write("rig.yaml", rig_text());
  const std::string motion = kMoving;
  box.write("moving.yaml", motion);
  const std::vector<std::string> arguments{
      "run",         "--left", "left*.png", "--right", "right*.png",   "--skin",
      "moving.yaml", "--out",  "out",       "--json",  "--still-scene"};  // only a block of it changes
  const std::vector<std::string> rig{"--rig", "rig.yaml"};
#ifdef HOROPTER_TEST_RTL
  const std::string engine = GENERATE("native", "rtl");
#else
  const std::string engine = "native";
#endif
  const auto result = box.run(arguments + rig + std::vector<std::string>{"--engine", engine});
  CAPTURE(result.err, result.out);
  REQUIRE(result.status == 0);
  const auto summary = nlohmann::json::parse(result.out);
  CHECK(summary["motion"]["tables"] == 4);
  CHECK(summary["motion"]["inserted"] == 0);
  CHECK(summary["motion"]["d95_px"] == 0.7);
  CHECK(summary["frame_rate_per_s"] == 50);
  const auto& frames = summary["frames"];
  REQUIRE(frames.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(frames[i]["skin_time_s"].get<double>() == Approx(0.02 * static_cast<double>(std::min<std::size_t>(i, 3))));
    CHECK(frames[i]["table"] == (std::min<std::size_t>(i, 3)) % 2);
  }
  CHECK(frames[0]["table_crc"] != frames[1]["table_crc"]);
  CHECK(frames[1]["table_crc"] != frames[3]["table_crc"]);
  CHECK(frames[3]["table_crc"] == frames[4]["table_crc"]);

  CHECK(box.run(arguments).status == 2);  // no rig
  fs::remove_all(box / "out");
  check_bad_file(box, arguments + rig + std::vector<std::string>{"--frame-rate", "25"}, "moving.yaml",
                 "frame_rate_per_s is 50");

  // The settings in force plan the steps, whichever option gives them; what they cannot serve is refused.
  for (const std::vector<std::string>& thin : {std::vector<std::string>{"--threshold", "3"},
                                               {"--tolerance", "0.3"},
                                               {"--profile", "vga", "--decision", "compete", "--tolerance", "0.7"}}) {
    CAPTURE(thin);
    const auto refused = box.run(arguments + rig + thin);
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, Catch::Contains("D95"));
  }
  CHECK_FALSE(fs::exists(box / "out"));
  const auto strict = box.run(arguments + rig + std::vector<std::string>{"--threshold", "12"});
  REQUIRE(strict.status == 0);
  const auto strict_motion = nlohmann::json::parse(strict.out)["motion"];
  CHECK(strict_motion["d95_px"].get<double>() == Approx(0.4 + 0.2 * 0.7 / 3.7));
  CHECK(strict_motion["inserted"].get<int>() > 0);
  fs::remove_all(box / "out");
  check_bad_file(
      box,
      {"map", "--skin", "moving.yaml", "--rig", "rig.yaml", "--profile", "vga", "--size", "200x120", "-o", "m.hmap"},
      "moving.yaml", "a table for each frame");
  std::string fast = motion;
  fast.replace(fast.find("1.6"), 3, "16");
  box.write("moving.yaml", fast);
  check_bad_file(box, arguments + rig, "moving.yaml", "must be below");
}

TEST_CASE("Files that would never end or fill the memory are refused at once") {
  Sandbox box;
  with_pairs(box);
  box.write("rig.yaml", rig_text());
  const auto run = [](const std::string& left, const std::string& skin) {
    return run_arguments(left, "right0.png", skin) + std::vector<std::string>{"--rig", "rig.yaml", "--json"};
  };
  const std::string plane = "surface: {type: plane, point_mm: [0, 0, 800], normal: [0, 0, 1]}\n";
  std::string bomb = plane + "x0: &x0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 10; ++i) {
    const std::string one = "*x" + std::to_string(i - 1), two = one + ", " + one, five = two + ", " + two + ", " + one;
    bomb += "x" + std::to_string(i) + ": &x" + std::to_string(i) + " [" + five + ", " + five + "]\n";
  }
  const std::string deep(1000, '[');
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {"surface: &a {type: union, surfaces: [*a]}\n", "line 1, column 38: an alias of what it stands in"},
           {bomb, "aliases that stand for too much"},
           {"surface: " + deep, "lists and maps in each other"},
           {plane + plane, "line 2, column 1: the key 'surface' a second time"},
           {"surface: {type: plane, normal: [0, 0, 1], point_mm: [0, 0, 1], normal: [0, 1, 1]}\n", "key 'normal'"},
           {plane +
                "motion: {frame_rate_per_s: 50, object_speed_m_s: 1, poses: [{time_s: 65535, shift_mm: [0, 0, 1]}]}\n",
            "at most 20000"}}) {
    box.write("skin.yaml", text);
    check_bad_file(box, run("left0.png", "skin.yaml"), "skin.yaml", message);
  }
  box.write("skin.yaml", plane);
  check_bad_file(box, run("/dev/zero", "skin.yaml"), "/dev/zero", "a device");
  check_bad_file(box, run("left0.png", "/dev/zero"), "/dev/zero", "a device");
  auto no_rig = run("left0.png", "skin.yaml");
  std::ranges::replace(no_rig, std::string("rig.yaml"), std::string("/dev/zero"));
  check_bad_file(box, no_rig, "/dev/zero", "a device");
  // Metres.
  const std::string metres = rig_text();
  box.write("rig.yaml", std::regex_replace(metres, std::regex("-50"), "-0.05"));
  check_bad_file(box, run("left0.png", "skin.yaml"), "rig.yaml", "mm apart");
  check_bad_file(box, {"map", "--skin", "skin.yaml", "--rig", "rig.yaml", "--profile", "vga", "-o", "m.hmap"},
                 "rig.yaml", "mm apart");
  CHECK(box.run(run_arguments() + std::vector<std::string>{"--threshold", "0"}).status == 2);
  const auto thinner = Catch::Contains("thinner than any that was measured");
  CHECK_THAT(box.run(run_arguments() + std::vector<std::string>{"--threshold", "2.2"}).err, thinner);
  CHECK_THAT(box.run(run_arguments() + std::vector<std::string>{"--threshold", "2.4"}).err, !thinner);
}

TEST_CASE("compete: cameras that cannot serve neighbours are refused, pixels that they cannot serve are reported") {
  Sandbox box;
  with_pairs(box);
  box.write("wall.yaml", "surface: {type: plane, point_mm: [0, 0, 800], normal: [0, 0, 1]}\n");
  const std::vector<std::string> compete{"--decision", "compete"};
  const std::vector<std::string> map{"map", "--skin", "wall.yaml", "--rig", "rig.yaml", "--profile", "vga", "--json"};
  const auto run = run_arguments("left0.png", "right0.png", "wall.yaml") +
                   std::vector<std::string>{"--rig", "rig.yaml", "--json", "--unsupervised-limit", "100"};
  const auto by_row = [&](const std::vector<std::string>& arguments) {
    const auto result = box.run(arguments);
    CAPTURE(result.err);
    REQUIRE(result.status == 0);
    return nlohmann::json::parse(result.out)["tables"][0]["unsupervised"]["row"].get<int>();
  };
  const auto unsupervised = [&](const std::vector<std::string>& arguments) {
    const auto result = box.run(arguments);
    CAPTURE(result.err);
    REQUIRE((result.status == 0 || result.status == 4));
    return nlohmann::json::parse(result.out)["frames"][0]["unsupervised_pixels"].get<int>();
  };

  // Over 24 px the line falls by 0.48 px, or by 0.58.
  box.write("rig.yaml", rig_text("1"));
  CHECK(by_row(map + compete) == 0);
  CHECK(nlohmann::json::parse(box.run(map + compete).out)["rows_checked"] == true);
  const int served = unsupervised(run + compete);
  box.write("rig.yaml", rig_text("1.2"));
  check_bad_file(box, map + compete, "wall.yaml",
                 "at 100.0 % of the pixels that could be supervised the epipolar line leaves the row by more than 0.5 "
                 "px within the "
                 "24 px");
  check_bad_file(box, run + compete, "wall.yaml", "images rectified, or --decision thesis");
  CHECK(by_row(map) == 0);
  box.write("moving.yaml",
            "surface: {type: plane, point_mm: [0, 0, 800], normal: [0, 0, 1]}\n"
            "motion: {frame_rate_per_s: 50, object_speed_m_s: 1, poses: [{time_s: 0.02, shift_mm: [0, 0, 10]}]}\n");
  const auto moving =
      run_arguments("left0.png", "right0.png", "moving.yaml") + std::vector<std::string>{"--rig", "rig.yaml", "--json"};
  CHECK(box.run(moving).status == 0);
  check_bad_file(box, moving + compete, "moving.yaml", "leaves the row");

  // A lens bends the lines most in the corners.
  box.write("rig.yaml", rig_text("0", "{k1: -0.2}"));
  const int bent = by_row(map + compete);
  CHECK(bent > 200 * 120 / 10);
  CHECK(bent < 200 * 120 / 2);
  CHECK(unsupervised(run + compete) > served + bent / 2);
  const auto explained = box.run({"map", "--skin", "wall.yaml", "--rig", "rig.yaml", "--profile", "vga", "-o",
                                  "compete.hmap", "--decision", "compete"});
  REQUIRE(explained.status == 0);
  CHECK_THAT(explained.out, Catch::Contains("% with an epipolar line that leaves the row"));
  // Tables know their rig.
  REQUIRE(box.run(map + std::vector<std::string>{"-o", "thesis.hmap"}).status == 0);
  const auto by_table = [](const std::string& table) {
    return run_arguments("left0.png", "right0.png", table) +
           std::vector<std::string>{"--json", "--unsupervised-limit", "100"};
  };
  CHECK(unsupervised(by_table("compete.hmap") + compete) == unsupervised(run + compete));
  CHECK(unsupervised(by_table("thesis.hmap")) == unsupervised(run));
  check_bad_file(box, by_table("thesis.hmap") + compete, "thesis.hmap", "`horopter map --decision compete`");

  // Without a rig it is not known, and said.
  const auto blind = box.run(run_arguments() + compete);
  CAPTURE(blind.err);
  CHECK((blind.status == 0 || blind.status == 4));
  CHECK_THAT(blind.out, Catch::Contains("no rig"));
  CHECK(nlohmann::json::parse(box.read("out/summary.json"))["rows_checked"] == false);
}

TEST_CASE("A fault of a frame is exit status 4, with the results written") {
  Sandbox box;
  with_pairs(box);
  fs::copy_file(box / "left0.png", box / "left1.png");
  fs::copy_file(box / "right0.png", box / "right1.png");
  const auto result = box.run({"run", "--left", "left0.png", "left1.png", "--right", "right0.png", "right1.png",
                               "--skin", "skin.yaml", "--out", "out"});
  CHECK(result.status == 4);
  CHECK_THAT(result.err, Catch::Contains("fault"));
  const auto summary = nlohmann::json::parse(box.read("out/summary.json"));
  CHECK(summary["frames"][0]["faults"].empty());
  CHECK(summary["frames"][1]["faults"] == nlohmann::json({"left_frozen", "right_frozen"}));
  CHECK(summary["frames"][1]["safe"] == false);
  CHECK(fs::exists(box / "out/frame-0001-state.png"));
}

TEST_CASE("A skin that the right camera hardly sees is a fault, not safe; one that it does not see is refused") {
  Sandbox box;
  with_pairs(box);
  box.write("none.yaml", "surface:\n  type: homography\n  matrix: [[1, 0, 0], [0, 1, 400], [0, 0, 1]]\n");
  check_bad_file(box, run_arguments("left0.png", "right0.png", "none.yaml"), "none.yaml", "no pixel is supervised");
  box.write("far.yaml", "surface:\n  type: homography\n  matrix: [[1, 0, 180], [0, 1, 0], [0, 0, 1]]\n");
  const auto result =
      box.run(run_arguments("left0.png", "right0.png", "far.yaml") + std::vector<std::string>{"--alarm-limit", "0"});
  CHECK(result.status == 4);
  CHECK_THAT(box.read("out/summary.json"), Catch::Contains("too_unsupervised"));
}

TEST_CASE("Profile field makes two fields of an image, at half the width") {
  Sandbox box;
  with_pairs(box);
  const auto result = box.run(run_arguments() + std::vector<std::string>{"--profile", "field"});
  CAPTURE(result.err);
  REQUIRE(result.status == 0);
  const auto summary = nlohmann::json::parse(box.read("out/summary.json"));
  CHECK(summary["profile"] == "field");
  REQUIRE(summary["frames"].size() == 2);
  CHECK(summary["frames"][0]["field"] == "even");
  CHECK(summary["frames"][1]["field"] == "odd");
  CHECK(summary["frames"][1]["table"] == 1);
  CHECK(cv::imread((box / "out/frame-0001-state.png").string(), cv::IMREAD_UNCHANGED).size() == cv::Size(100, 60));
}

TEST_CASE("Directories, videos and tables are inputs, too") {
  Sandbox box;
  with_pairs(box, 3);
  fs::create_directory(box / "l");
  fs::create_directory(box / "r");
  for (int i = 0; i < 3; ++i) {
    const std::string number = std::to_string(i);
    fs::copy_file(box / ("left" + number + ".png"), box / ("l/" + number + ".png"));
    fs::copy_file(box / ("right" + number + ".png"), box / ("r/" + number + ".png"));
  }
  auto result = box.run(run_arguments("l", "r"));
  CHECK(result.status == 0);
  const auto summary = nlohmann::json::parse(box.read("out/summary.json"));
  CHECK(summary["frames"].size() == 3);

  REQUIRE(box.run({"map", "--skin", "skin.yaml", "--profile", "vga", "--size", "200x120", "-o", "skin.hmap"}).status ==
          0);
  result = box.run(run_arguments("l", "r", "skin.hmap"));
  CHECK(result.status == 0);
  CHECK(nlohmann::json::parse(box.read("out/summary.json")) == summary);

  cv::VideoWriter left((box / "left.avi").string(), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10, {200, 120});
  cv::VideoWriter right((box / "right.avi").string(), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10, {200, 120});
  REQUIRE(left.isOpened());
  REQUIRE(right.isOpened());
  for (int i = 0; i < 3; ++i) {
    const std::string number = std::to_string(i);
    left.write(cv::imread((box / ("left" + number + ".png")).string()));
    right.write(cv::imread((box / ("right" + number + ".png")).string()));
  }
  left.release();
  right.release();
  result = box.run(run_arguments("left.avi", "right.avi"));
  CAPTURE(result.err);
  CHECK(result.status == 0);
  const auto video = nlohmann::json::parse(box.read("out/summary.json"));
  REQUIRE(video["frames"].size() == 3);
  CHECK(video["frames"][2]["left"] == "left.avi#2");
  CHECK(video["frames"][2]["alarm"] == true);
  CHECK(box.run(run_arguments("left.avi", "right.avi") + std::vector<std::string>{"--frames", "2"}).status == 0);
  CHECK(nlohmann::json::parse(box.read("out/summary.json"))["frames"].size() == 2);
  CHECK(!fs::exists(box / "out/frame-0002-state.png"));  // of the run before
  fs::resize_file(box / "right.avi", fs::file_size(box / "right.avi") / 2);
  check_bad_file(box, run_arguments("left.avi", "right.avi"), "right.avi", "truncated");
}

TEST_CASE("Bad images are exit status 3, with nothing left behind") {
  Sandbox box;
  with_pairs(box);
  const auto bad = [&](const std::string& file, const std::string& message) {
    check_bad_file(box, run_arguments("left0.png", file), file, message);
    if (message != "200x120") check_bad_file(box, run_arguments(file, "right0.png"), file, message);
  };
  bad("none.png", "no such file");
  bad("none*.png", "no file matches");
  box.write("empty.png", "");
  bad("empty.png", "empty");
  box.write("text.png", "This is not an image, whatever its name says.");
  bad("text.png", "not an image");
  const std::string whole = box.read("right0.png");
  box.write("cut.png", whole.substr(0, whole.size() / 2));
  bad("cut.png", "truncated");
  const cv::Mat image = textured(200, 120, 5);
  for (const std::string extension : {".jpg", ".pgm", ".bmp", ".tiff"}) {
    const std::string name = "cut" + extension;
    save((box / name).string(), image);
    const std::string bytes = box.read(name);
    box.write(name, bytes.substr(0, bytes.size() - bytes.size() / 3));
    bad(name, "truncated");
  }
  save((box / "deep.png").string(), cv::Mat(120, 200, CV_16UC1, cv::Scalar(500)));
  bad("deep.png", "16 bits");
  save((box / "small.png").string(), textured(100, 120, 6));
  bad("small.png", "200x120");
  fs::create_directory(box / "directory");
  bad("directory", "no image in this directory");
  const auto twin = [&](const std::string& name) {
    fs::copy_file(box / name, box / ("right-" + name));
    return "right-" + name;
  };
  save((box / "tiny.png").string(), textured(24, 12, 6));
  check_bad_file(box, run_arguments("tiny.png", twin("tiny.png")), "tiny.png", "at least 32x16");
  save((box / "large.png").string(), textured(1930, 120, 6));
  check_bad_file(box, run_arguments("large.png", twin("large.png")), "large.png", "at most");
  save((box / "wide.png").string(), textured(700, 120, 6));
  check_bad_file(box, run_arguments("wide.png", twin("wide.png")) + std::vector<std::string>{"--profile", "vga"},
                 "wide.png", "at most 640x480 for profile vga");
  save((box / "odd.png").string(), textured(200, 121, 6));
  check_bad_file(box, run_arguments("odd.png", twin("odd.png")) + std::vector<std::string>{"--profile", "field"},
                 "odd.png", "even");
  check_bad_file(
      box, {"run", "--left", "left0.png", "left0.png", "--right", "right0.png", "--skin", "skin.yaml", "--out", "out"},
      "right0.png", "2 left images but 1 right");
  // The place for the results is a file.
  check_bad_file(box,
                 {"run", "--left", "left0.png", "--right", "right0.png", "--skin", "skin.yaml", "--out", "skin.yaml"},
                 "skin.yaml", "this is a file");
}

TEST_CASE("A JPEG that its decoder still shows is refused when it is truncated") {
  Sandbox box;
  with_pairs(box);
  save((box / "whole.jpg").string(), textured(200, 120, 1));
  const std::string bytes = box.read("whole.jpg");
  for (const std::size_t cut : {std::size_t{2}, bytes.size() / 4}) {
    box.write("cut.jpg", bytes.substr(0, bytes.size() - cut));
    CHECK(!cv::imread((box / "cut.jpg").string(), cv::IMREAD_GRAYSCALE).empty());
    check_bad_file(box, run_arguments("cut.jpg", "right0.png"), "cut.jpg", "truncated");
  }
  box.write("cut.jpg", bytes.substr(0, bytes.size() / 2) + "\xFF\xD9");
  check_bad_file(box, run_arguments("cut.jpg", "right0.png"), "cut.jpg", "truncated");
}

TEST_CASE("Bad skins and rigs are exit status 3") {
  Sandbox box;
  with_pairs(box);
  const auto bad = [&](const std::string& yaml, const std::string& message) {
    box.write("bad.yaml", yaml);
    check_bad_file(box, run_arguments("left0.png", "right0.png", "bad.yaml"), "bad.yaml", message);
    check_bad_file(box, {"map", "--skin", "bad.yaml", "--profile", "vga", "-o", "bad.hmap"}, "bad.yaml", message);
  };
  bad("surface: [", "line");
  bad("", "empty");
  bad("surface:\n  type: ellipsoid\n", "centre_mm: missing");
  bad("surface:\n  type: homography\n  matrix: [[1, 0, 0], [2, 0, 0], [0, 0, 1]]\n", "singular");
  bad("surface:\n  type: homography\n  matrix: [[1, 0, 0], [0, .nan, 0], [0, 0, 1]]\n", "finite");
  bad("surface:\n  type: homography\n  matrix: [[1, 0, 0], [0, 1, 0], [0, 0, .inf]]\n", "finite");
  bad("surface:\n  type: homography\n  matrix: [[1, 0], [0, 1]]\n", "3 rows of 3 numbers");
  check_bad_file(box, run_arguments("left0.png", "right0.png", "none.yaml"), "none.yaml", "no such file");
  check_bad_file(box, run_arguments() + std::vector<std::string>{"--rig", "none.yaml"}, "none.yaml",
                 "there is no such file");
  box.write("rig.yaml", "cameras: [");
  check_bad_file(box, run_arguments() + std::vector<std::string>{"--rig", "rig.yaml"}, "rig.yaml", "not YAML");
}

TEST_CASE("run takes the thickness of a surface in mm") {
  Sandbox box;
  with_pairs(box);
  const std::vector<std::string> design{"plan",         "rig",       "--focal", "2",          "--pixel", "10",
                                        "--image-size", "200",       "120",     "--baseline", "100",     "--distance",
                                        "800",          "--profile", "vga",     "--out",      "rig"};
  REQUIRE(box.run(design).status == 0);
  box.write("surface.yaml", "surface:\n  type: plane\n  point_mm: [0, 0, 800]\n  normal: [0.3, 0, -1]\n");
  auto arguments = run_arguments("left0.png", "right0.png", "surface.yaml") +
                   std::vector<std::string>{"--rig", "rig/rig.yaml", "--thickness"};
  for (const char* decision : {"thesis", "compete"}) {
    const auto result = box.run(arguments + std::vector<std::string>{"60", "--decision", decision, "--json"});
    CAPTURE(decision, result.err);
    REQUIRE((result.status == 0 || result.status == 4));
    const auto summary = nlohmann::json::parse(result.out);
    CHECK(summary["thickness_mm"]["smallest"].get<double>() < 60);
    CHECK(summary["thickness_mm"]["largest"].get<double>() > 60);
    // 2 D z^2 / (b f) on the axis of a skin whose normal is 16.7 degrees off it.
    CHECK(summary["tolerance_px"].get<double>() == Approx(60 * 100 * 200 / (2 * 800 * 800.0) * 1.044).epsilon(0.06));
  }
  const auto refused = box.run(arguments + std::vector<std::string>{"400", "--decision", "compete"});
  CHECK(refused.status == 2);
  CHECK_THAT(refused.err, Catch::Contains("a thickness of 400 mm") && Catch::Contains("can be set to"));
}

TEST_CASE("Wrong usage is exit status 2") {
  Sandbox box;
  with_pairs(box);
  const auto before = box.files();
  for (const auto& arguments : std::vector<std::vector<std::string>>{
           {},
           {"fly"},
           {"run"},
           {"run", "--left", "left0.png"},
           run_arguments() + std::vector<std::string>{"--profile", "pal"},
           run_arguments() + std::vector<std::string>{"--engine", "analogue"},
           run_arguments() + std::vector<std::string>{"--decision", "guess"},
           run_arguments() + std::vector<std::string>{"--profile", "field", "--decision", "compete"},
           run_arguments() + std::vector<std::string>{"--threshold", "101"},
           run_arguments() + std::vector<std::string>{"--threshold", "many"},
           run_arguments() + std::vector<std::string>{"--threshold", "20", "--tolerance", "1"},
           run_arguments() + std::vector<std::string>{"--threshold", "20", "--thickness", "20"},
           run_arguments() + std::vector<std::string>{"--thickness", "20", "--tolerance", "1"},
           run_arguments() + std::vector<std::string>{"--thickness", "20"},  // of a homography
           run_arguments() + std::vector<std::string>{"--tolerance", "3"},
           run_arguments() + std::vector<std::string>{"--profile", "vga", "--decision", "compete", "--tolerance", "2"},
           run_arguments() + std::vector<std::string>{"--colour", "red"},
           {"map"},
           {"map", "--skin", "skin.yaml", "-o", "x.hmap"},
           {"map", "--skin", "skin.yaml", "--profile", "pal", "-o", "x.hmap"},
           {"map", "--skin", "skin.yaml", "--profile", "vga"},
           {"map", "--skin", "skin.yaml", "--profile", "vga", "--size", "big", "-o", "x.hmap"},
           {"map", "--skin", "skin.yaml", "--profile", "vga", "--size", "900x900", "-o", "x.hmap"},
           {"map", "--skin", "skin.yaml", "--profile", "field", "--decision", "compete", "-o", "x.hmap"},
           {"map", "--inspect", "x.hmap", "--decision", "compete"},
           {"map", "--inspect", "x.hmap", "--skin", "skin.yaml"}}) {
    CAPTURE(arguments);
    const auto result = box.run(arguments);
    CAPTURE(result.err);
    CHECK(result.status == 2);
    CHECK(!result.err.empty());
    CHECK(box.files() == before);
  }
  CHECK_THAT(box.run(run_arguments() + std::vector<std::string>{"--profile", "pal"}).err,
             Catch::Contains("unknown profile 'pal'") && Catch::Contains("field, field_roll, vga, hd"));
}

TEST_CASE("Help suffices") {
  Sandbox box;
  for (const auto& arguments : std::vector<std::vector<std::string>>{{"--help"}, {"run", "--help"}, {"map", "-h"}}) {
    const auto result = box.run(arguments);
    CHECK(result.status == 0);
    CHECK(result.err.empty());
    CHECK_THAT(result.out, Catch::Contains("Usage: horopter"));
  }
  CHECK_THAT(box.run({"--help"}).out, Catch::Contains("Exit status"));
  CHECK_THAT(box.run({"run", "--help"}).out, Catch::Contains("--alarm-limit") && Catch::Contains("Example"));
  CHECK(box.run({"--version"}).out == HOROPTER_VERSION "\n");
}

TEST_CASE("Options of words: help shows them, and whoever writes another is told them") {
  struct Words {
    std::vector<std::string> command;
    std::string option, shown, listed;
  };
  const std::string shown = "thesis|compete";
  const std::string listed = "thesis, compete";
  const auto words = GENERATE_COPY(
      values<Words>({{{"run"}, "--decision", shown, listed},
                     {{"map"}, "--decision", shown, listed},
                     {{"evaluate"}, "--decision", shown, listed},
                     {{"plan", "thickness"}, "--decision", shown, listed},
                     {{"plan", "rig"}, "--decision", shown, listed},
                     {{"study", "board"}, "--decision", shown, listed},
                     {{"study", "earned"}, "--engine", "native|rtl", "native, rtl"},
                     {{"evaluate"}, "--change", "none|gain|noise|vertical,…", "none, gain, noise, vertical"},
                     {{"study", "segmentation"},
                      "--texture",
                      "dead-leaves|band-noise|printed-dots",
                      "dead-leaves, band-noise, printed-dots"}}));
  CAPTURE(words.command, words.option);
  const Sandbox box;
  const std::string help = box.run(words.command + std::vector<std::string>{"--help"}).out;
  CHECK_THAT(help, Catch::Contains(words.option + " " + words.shown));
  for (const char* ugly : {"->", " OR ", ":{", "{false}"}) CHECK_THAT(help, !Catch::Contains(ugly));
  const auto wrong = box.run(words.command + std::vector<std::string>{words.option, "guess"});
  CHECK(wrong.status == 2);
  CHECK_THAT(wrong.err, Catch::Contains(words.option + ": 'guess' is not one of " + words.listed));
  const std::string last = words.listed.substr(words.listed.rfind(' ') + 1);
  CHECK_THAT(box.run(words.command + std::vector<std::string>{words.option, last}).err,
             !Catch::Contains("is not one of"));
}

TEST_CASE("map writes over none of its inputs, and not two outputs into one file") {
  Sandbox box;
  box.write("skin.yaml", kSkin);
  box.write("rig.yaml", rig_text());
  const std::vector<std::string> make{"map", "--skin", "skin.yaml", "--profile", "vga"};
  REQUIRE(box.run(make + std::vector<std::string>{"-o", "p.hmap"}).status == 0);
  fs::create_symlink("p.hmap", box / "link");
  fs::create_symlink("same", box / "same-as-well");
  const auto before = box.files();
  const auto table = box.read("p.hmap");
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& one,
                           const std::string& other) {
    const auto result = box.run(arguments);
    CAPTURE(arguments, result.err);
    CHECK(result.status == 2);
    CHECK_THAT(result.err, Catch::Contains(one + " and " + other));
    CHECK(box.files() == before);
  };
  refused({"map", "--inspect", "p.hmap", "--draw", "p.hmap"}, "--inspect", "--draw");
  refused({"map", "--inspect", "p.hmap", "--draw", "link"}, "--inspect", "--draw");
  refused(make + std::vector<std::string>{"-o", "./skin.yaml"}, "--skin", "--output");
  refused(make + std::vector<std::string>{"--rig", "rig.yaml", "--draw", "rig.yaml"}, "--rig", "--draw");
  refused(make + std::vector<std::string>{"-o", "same", "--draw", "./same"}, "--output", "--draw");
  refused(make + std::vector<std::string>{"-o", "same", "--draw", "same-as-well"}, "--output", "--draw");
  CHECK(box.read("p.hmap") == table);
  CHECK(box.read("skin.yaml") == kSkin);
  CHECK(box.run(make + std::vector<std::string>{"-o", "/dev/null", "--draw", "/dev/null"}).status == 0);
}

TEST_CASE("map makes, explains and draws tables") {
  Sandbox box;
  with_pairs(box);
  auto result = box.run({"map", "--skin", "skin.yaml", "--profile", "field", "-o", "skin.hmap", "--draw", "map.png"});
  CAPTURE(result.err);
  REQUIRE(result.status == 0);
  const cv::Size picture = cv::imread((box / "map.png").string()).size();
  CHECK(picture.width > 756);  // with axes
  CHECK(picture.height > 572);
  result = box.run({"map", "--inspect", "skin.hmap"});
  CHECK(result.status == 0);
  CHECK_THAT(result.out, Catch::Contains("even field") && Catch::Contains("CRC-32") && Catch::Contains("LOOKAHEAD"));
  result = box.run({"map", "--inspect", "skin.hmap", "--json"});
  CHECK(result.status == 0);
  const auto json = nlohmann::json::parse(result.out);
  CHECK(json["profile"] == "field");
  CHECK(json["tables"].size() == 2);
  CHECK(json["tables"][0]["error_largest_px"].get<double>() <= 0.25);

  const std::string bytes = box.read("skin.hmap");
  const auto bad = [&](const std::string& altered, const std::string& message) {
    box.write("bad.hmap", altered);
    check_bad_file(box, {"map", "--inspect", "bad.hmap"}, "bad.hmap", message);
  };
  bad(bytes.substr(0, bytes.size() - 5), "truncated");
  bad(bytes.substr(0, 10), "truncated");
  std::string altered = bytes;
  altered[bytes.size() / 2] ^= 1;
  bad(altered, "CRC");
  altered = bytes;
  altered[4] = 9;
  bad(altered, "version 9");
  bad("not a table", "not a mapping table");
  check_bad_file(box, {"map", "--inspect", "none.hmap"}, "none.hmap", "no such file");
  // For another profile, and for another size.
  check_bad_file(box, run_arguments("left0.png", "right0.png", "skin.hmap"), "skin.hmap", "a table for profile field");
  check_bad_file(box,
                 run_arguments("left0.png", "right0.png", "skin.hmap") + std::vector<std::string>{"--profile", "field"},
                 "skin.hmap", "756x572");
}

TEST_CASE("A skin that needs more rows than the store holds is refused with the number") {
  Sandbox box;
  with_pairs(box);
  box.write("steep.yaml", "surface:\n  type: homography\n  matrix: [[1, 0, 0], [0.3, 1, 0], [0, 0, 1]]\n");
  check_bad_file(box, {"map", "--skin", "steep.yaml", "--profile", "vga", "-o", "x.hmap"}, "steep.yaml",
                 "holds 128 rows");
}

TEST_CASE("Correspondences make a skin") {
  Sandbox box;
  with_pairs(box);
  std::string yaml = "surface:\n  type: correspondences\n  points:\n";
  for (const auto& [x, y] : {std::pair{20, 10}, {180, 12}, {175, 100}, {25, 95}, {100, 50}}) {
    yaml += "    - {left: [" + std::to_string(x) + ", " + std::to_string(y) + "], right: [" + std::to_string(x - 10) +
            ", " + std::to_string(y + 4) + "]}\n";
  }
  box.write("points.yaml", yaml);
  REQUIRE(box.run(run_arguments("left0.png", "right0.png", "points.yaml")).status == 0);
  CHECK(nlohmann::json::parse(box.read("out/summary.json"))["frames"][0]["alarm"] == true);
  CHECK_THAT(box.run(run_arguments() + std::vector<std::string>{"--tolerance", "3"}).err,
             Catch::Contains("tolerance of 3 px") && Catch::Contains("0.2 to 2.5 px"));
  CHECK_THAT(box.run(run_arguments() + std::vector<std::string>{"--thickness", "20"}).err,
             Catch::Contains("needs a surface and cameras"));
}

TEST_CASE("A skin that moves takes no images with a hole in their numbers") {
  Sandbox box;
  with_pairs(box, 6);
  box.write("rig.yaml", rig_text());
  box.write("moving.yaml", kMoving);
  const auto run = [](const std::string& skin) {
    return run_arguments("left*.png", "right*.png", skin) + std::vector<std::string>{"--rig", "rig.yaml"};
  };
  CHECK(box.run(run("moving.yaml")).status != 3);
  fs::remove_all(box / "out");
  for (const char* lost : {"left3.png", "right3.png"}) fs::remove(box / lost);
  check_bad_file(box, run("moving.yaml"), "left4.png", "expected number 3");
  box.write("still.yaml", "surface: {type: plane, point_mm: [0, 0, 800], normal: [0, 0, 1]}\n");
  CHECK(box.run(run("still.yaml")).status != 3);
}

TEST_CASE("plan rig: a lattice that passes beside the zone is refused") {
  Sandbox box;
  box.write("rig.yaml", rig_text());
  box.write("skin.yaml", "surface: {type: box, centre_mm: [0, 0, 1000], size_mm: [400, 400, 400]}\n");
  box.write("zone.yaml", "surface: {type: box, centre_mm: [0, 0, 1000], size_mm: [200, 200, 200]}\n");
  const std::vector<std::string> plan{"plan",   "rig",       "--rig",  "rig.yaml", "--skin", "skin.yaml",
                                      "--zone", "zone.yaml", "--from", "20000",    "0",      "1000"};
  const auto refused = box.run(plan);
  CAPTURE(refused.out);
  CHECK(refused.status == 2);
  CHECK_THAT(refused.err, Catch::Contains("200 x 200 x 200 mm") && Catch::Contains("--step 50 or less"));
  CHECK(box.run(plan + std::vector<std::string>{"--step", "190"}).status != 2);
  // Of a union each part.
  box.write("zone.yaml",
            "surface: {type: union, surfaces: [{type: box, centre_mm: [0, 0, 1000], size_mm: [200, 200, 200]},\n"
            "  {type: box, centre_mm: [150, 0, 1000], size_mm: [10, 10, 10]}]}\n");
  const auto small = box.run(plan + std::vector<std::string>{"--step", "190"});
  CAPTURE(small.out);
  CHECK(small.status == 2);
  CHECK_THAT(small.err, Catch::Contains("a part of it, is 10 x 10 x 10 mm"));
}
