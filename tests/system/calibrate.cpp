// SPDX-License-Identifier: Apache-2.0
// horopter calibrate, pattern and study from outside: what they promise on good input, and that bad input never makes
// a rig.
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <sstream>

#include "rig_text.hpp"
#include "sandbox.hpp"
#include "shared_data.hpp"

using namespace horopter::test;
using Arguments = std::vector<std::string>;
using nlohmann::json;

namespace {

constexpr double kFocalPx = 600;  // of the drawn camera, without distortion
constexpr int kWidth = 640, kHeight = 480;
constexpr double kBaselineMm = 80;

/// Standard output is one JSON document and nothing else; standard error is empty but for one line when it failed.
json report(const Sandbox& box, Arguments arguments, int status = 0) {
  arguments.emplace_back("--json");
  const auto result = box.run(arguments);
  CAPTURE(arguments, result.out, result.err);
  REQUIRE(result.status == status);
  if (status == 0) {
    CHECK(result.err.empty());
  } else {
    CHECK_THAT(result.err, Catch::StartsWith("horopter: ") && Catch::EndsWith("\n"));
    CHECK(std::ranges::count(result.err, '\n') == 1);
  }
  json parsed;
  REQUIRE_NOTHROW(parsed = json::parse(result.out));
  return parsed;
}

bool names(const json& list, const std::string& what) {
  return std::ranges::any_of(list, [&](const json& entry) { return entry.get<std::string>().starts_with(what); });
}

/// Refused: the status, one line that says why, nothing written.
void check_refused(const Sandbox& box, const Arguments& arguments, int status, const std::string& why) {
  const auto before = box.files();
  const auto result = box.run(arguments);
  CAPTURE(arguments, result.out, result.err);
  CHECK(result.status == status);
  CHECK_THAT(result.err, Catch::StartsWith("horopter: ") && Catch::Contains(why));
  CHECK(std::ranges::count(result.err, '\n') == 1);
  CHECK(box.files() == before);
}

// ---------------------------------------------------------------- points

struct Point {
  double x, y, z;
};

/// Points on planes at these heights, 30 mm apart.
std::vector<Point> points_at(const std::vector<double>& heights_mm) {
  std::vector<Point> points;
  for (const double z : heights_mm)
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < 8; ++column) points.push_back({30.0 * column - 105, 30.0 * row - 75, z});
  return points;
}

/// Lines of a file, seen by a camera 600 mm above that looks down on them, tilted about its x axis and moved along it.
std::string seen(const std::vector<Point>& points, double tilt_rad = 0.4, double shift_mm = 0, double noise_px = 0.02) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, noise_px);
  std::ostringstream text;
  text.precision(12);
  for (const Point& p : points) {
    const double y = -p.y, z = -p.z;  // the world's z points at the camera
    const double xc = p.x - shift_mm, yc = std::cos(tilt_rad) * y - std::sin(tilt_rad) * z,
                 zc = std::sin(tilt_rad) * y + std::cos(tilt_rad) * z + 600;
    text << p.x << ' ' << p.y << ' ' << p.z << ' ' << 321 + kFocalPx * xc / zc + noise(random) << ' '
         << 238 + kFocalPx * yc / zc + noise(random) << '\n';
  }
  return text.str();
}

Sandbox& with_points(Sandbox& box) {
  box.write("low.txt", seen(points_at({0})));
  box.write("high.txt", seen(points_at({80})));
  box.write("middle.txt", seen(points_at({40})));
  box.write("sensor.yaml", "width_px: 640\nheight_px: 480\ndx_mm: 0.01\ndy_mm: 0.01\ncx_px: 319.5\ncy_px: 239.5\n");
  return box;
}

Arguments from_points(const Arguments& files, const std::string& method = "full") {
  return Arguments{"calibrate", "--points"} + files +
         Arguments{"--sensor", "sensor.yaml", "--method", method, "-o", "rig.yaml"};
}

// ---------------------------------------------------------------- images

/// A photograph of a chessboard of 10x7 squares of 30 mm, turned about its middle by small angles, 700 mm away, then lifted
/// from where it lies.
cv::Mat photographed(double turn_x, double turn_y, double shift_mm, double x_mm = 0, double y_mm = 0,
                     double lift_mm = 0) {
  constexpr double kDotMm = 0.5;  // of the drawing
  constexpr int kSquare = static_cast<int>(30 / kDotMm);
  cv::Mat board(9 * kSquare, 12 * kSquare, CV_8UC1, cv::Scalar(220));
  for (int row = 0; row < 7; ++row)
    for (int column = 0; column < 10; ++column)
      if ((row + column) % 2 == 0)
        board(cv::Rect((column + 1) * kSquare, (row + 1) * kSquare, kSquare, kSquare)).setTo(30);
  const double cx = std::cos(turn_x), sx = std::sin(turn_x), cy = std::cos(turn_y), sy = std::sin(turn_y);
  // From the drawing's dots over the board (mm about its middle) to the camera and the image, twice as large.
  const cv::Matx33d drawing(kDotMm, 0, (0.5 - 6 * kSquare) * kDotMm, 0, kDotMm, (0.5 - 4.5 * kSquare) * kDotMm, 0, 0,
                            1);
  const cv::Matx33d pose(cy, sx * sy, x_mm - shift_mm - lift_mm * sy * cx, 0, cx, y_mm + lift_mm * sx, -sy, sx * cy,
                         700 - lift_mm * cy * cx);
  constexpr int kOver = 2;
  const cv::Matx33d camera(kOver * kFocalPx, 0, kOver * 319.5 + 0.5, 0, kOver * kFocalPx, kOver * 239.5 + 0.5, 0, 0, 1);
  cv::Mat large, small;
  cv::warpPerspective(board, large, camera * pose * drawing, {kOver * kWidth, kOver * kHeight}, cv::INTER_LINEAR,
                      cv::BORDER_CONSTANT, cv::Scalar(220));
  cv::resize(large, small, {kWidth, kHeight}, 0, 0, cv::INTER_AREA);
  cv::GaussianBlur(small, small, {3, 3}, 0.6);
  return small;
}

constexpr std::array<std::array<double, 4>, 5> kPoses{
    {{0.4, 0.1, 60, 20}, {-0.4, 0.2, 0, -30}, {0.1, 0.45, 40, 10}, {-0.1, -0.4, 30, 0}, {0.3, -0.3, 50, 40}}};

/// left0.png, right0.png, … of a rig of two such cameras side by side.
Sandbox& with_images(Sandbox& box) {
  for (std::size_t i = 0; i < kPoses.size(); ++i) {
    const auto& [turn_x, turn_y, x, y] = kPoses[i];
    cv::imwrite((box / ("left" + std::to_string(i) + ".png")).string(), photographed(turn_x, turn_y, 0, x, y));
    cv::imwrite((box / ("right" + std::to_string(i) + ".png")).string(),
                photographed(turn_x, turn_y, kBaselineMm, x, y));
  }
  return box;
}

Arguments from_pairs(const std::string& left = "left?.png", const std::string& right = "right?.png") {
  return {"calibrate",           "--left",       left, "--right", right,     "--target",
          "chessboard:9x6:30mm", "--distortion", "k1", "-o",      "rig.yaml"};
}

}  // namespace

TEST_CASE("points: every method, with all that the report promises") {
  Sandbox box;
  with_points(box);
  for (const std::string method : {"dlt", "tsai", "full"}) {
    CAPTURE(method);
    const json result =
        report(box, from_points({"low.txt", "high.txt"}, method) + Arguments{"--withhold", "middle.txt"});
    CHECK(result["method"] == method);
    CHECK(result["usable"] == true);
    CHECK(result["image_error_px"]["points"] == 96);
    const double mean = result["image_error_px"]["mean"], max = result["image_error_px"]["max"];
    CHECK(mean > 0);
    CHECK(mean < 0.05);
    CHECK(result["image_error_px"]["sd"].get<double>() < max);
    CHECK(max < 0.15);
    CHECK(result["rms_px"]["left"].get<double>() > 0);
    CHECK(result["rms_px"]["right"].is_null());
    CHECK(result["nce_thesis"].get<double>() == Approx(5 * result["nce"].get<double>()));
    CHECK(result["baseline_mm"].is_null());
    CHECK(result["parameters"]["f_mm"].get<double>() == Approx(6).epsilon(0.02));
    CHECK(result["parameters"]["fx_px"].get<double>() == Approx(600).epsilon(0.02));
    CHECK(result["parameters"]["tz_mm"].get<double>() == Approx(600).epsilon(0.02));
    CHECK(result["standard_deviations"]["f_mm"].get<double>() > 0);
    CHECK(result["withheld"]["image_error_px"]["points"] == 48);
    CHECK(result["withheld"]["nce"].get<double>() < 0.3);
    CHECK(result["views"].empty());
    CHECK(result["warnings"].is_array());
    CHECK_THAT(box.read("rig.yaml"), Catch::Contains("\nhoropter_rig: 1\n"));
  }
  const auto text = box.run(from_points({"low.txt", "high.txt"}));
  CHECK(text.status == 0);
  CHECK_THAT(text.out, Catch::Contains("method         full") && Catch::Contains("f_mm") && Catch::Contains("NCE"));
}

TEST_CASE("points: two cameras are a rig, with its picture and exports") {
  Sandbox box;
  with_points(box);
  box.write("right.txt", seen(points_at({0, 80}), 0.4, kBaselineMm));
  const json result = report(
      box, from_points({"low.txt", "high.txt"}) + Arguments{"--right-points", "right.txt", "--picture", "residuals.png",
                                                            "--export-opencv", "rig.yml", "--export-ros", "ros"});
  CHECK(result["baseline_mm"].get<double>() == Approx(kBaselineMm).epsilon(0.01));
  CHECK(result["rms_px"]["stereo"].get<double>() < 0.05);
  CHECK(result["baseline_sd_mm"].get<double>() > 0);
  CHECK(result["standard_deviations"]["relative"]["ry_deg"].get<double>() > 0);
  CHECK(result["parameters"]["right"]["f_mm"].get<double>() == Approx(6).epsilon(0.02));
  const cv::Mat picture = cv::imread((box / "residuals.png").string());
  CHECK(picture.cols >= 2 * kWidth);
  CHECK(picture.rows > kHeight);
  for (const Arguments& files :
       {Arguments{"rig.yaml"}, Arguments{"rig.yml"}, Arguments{"ros/left.yaml", "ros/right.yaml"}}) {
    const json back = report(box, Arguments{"calibrate", "--import"} + files);
    CHECK(back["baseline_mm"].get<double>() == Approx(result["baseline_mm"].get<double>()).epsilon(1e-9));
    CHECK(back["cameras"].size() == 2);
  }
}

TEST_CASE("points: one plane says what it cannot know") {
  Sandbox box;
  with_points(box);
  const json flat = report(box, from_points({"low.txt"}));
  CHECK(names(flat["warnings"], "one_plane: "));
  // A mirrored order of one plane is a camera on its other side: the warning says where it stands.
  CHECK_THAT(flat["warnings"].dump(), Catch::Contains("on the +z side"));
}

TEST_CASE("points: bad input never makes a rig") {
  Sandbox box;
  with_points(box);
  box.write("noisy.txt", seen(points_at({0, 80}), 0.4, 0, 10));
  for (const std::string method : {"dlt", "tsai", "full"}) {
    check_refused(box, from_points({"noisy.txt"}, method), 1, "camera: the points do not fit: RMS");
  }
  const std::string good = seen(points_at({0, 80}));
  const auto lines = [&](int from, int count) {
    std::istringstream stream(good);
    std::string line, text;
    for (int i = 0; std::getline(stream, line); ++i)
      if (i >= from && i < from + count) text += line + "\n";
    return text;
  };
  // The measurements are well formed, but no camera fits them, whatever the method.
  const auto undetermined = [&](const std::string& text, const std::string& why, const Arguments& methods) {
    box.write("bad.txt", text);
    for (const std::string& method : methods) {
      check_refused(box, from_points({"bad.txt"}, method), 3, why);
      const json result = report(box, from_points({"bad.txt"}, method), 3);
      CHECK(result["usable"] == false);
      CHECK(result["problems"].size() == 1);
      CHECK(result["nce"].is_null());
      CHECK(result["image_error_px"]["mean"].is_null());
    }
  };
  const Arguments all{"dlt", "tsai", "full"};
  undetermined(lines(0, 5), "too few points: 5", all);
  undetermined(lines(0, 8), "on one line", all);
  undetermined(seen(points_at({0}), 0), "cannot be told apart", {"tsai", "full"});
  undetermined(seen(points_at({0})), "lie in a plane", {"dlt"});
  std::istringstream stream(good);
  std::ostringstream mirrored_world, mirrored_image;
  mirrored_world.precision(12);
  mirrored_image.precision(12);
  for (double x = 0, y = 0, z = 0, u = 0, v = 0; stream >> x >> y >> z >> u >> v;) {
    mirrored_world << -x << ' ' << y << ' ' << z << ' ' << u << ' ' << v << '\n';
    mirrored_image << x << ' ' << y << ' ' << z << ' ' << kWidth - 1 - u << ' ' << v << '\n';
  }
  undetermined(mirrored_world.str(), "mirrored", all);
  undetermined(mirrored_image.str(), "mirrored", all);

  // The file itself is bad: file, line, and what was expected.
  const auto bad = [&](const std::string& text, const std::string& message) {
    box.write("bad.txt", text);
    check_bad_file(box, from_points({"low.txt", "bad.txt"}), "bad.txt", message);
    check_bad_file(box, from_points({"low.txt", "high.txt"}) + Arguments{"--withhold", "bad.txt"}, "bad.txt", message);
  };
  bad(lines(0, 3) + "1 2 3 nan 5\n", "line 4: 'nan' is not finite");
  bad(lines(0, 3) + "1 2 3 4\n", "line 4: 4 numbers");
  bad(lines(0, 3) + "1 2 3 4 5 6\n", "line 4: 6 numbers");
  bad("# nothing\n1 2 three 4 5\n", "line 2: 'three' is not a number");
  bad("", "no points");
  check_bad_file(box, from_points({"none.txt"}), "none.txt", "there is no such file");
  // Measured once, given twice: whole, as a part, or to judge itself.
  box.write("part.txt", "# in other words\n" + lines(40, 8) + lines(0, 20));
  box.write("all.txt", good);
  check_bad_file(box, from_points({"low.txt", "high.txt", "low.txt"}), "low.txt", "all its points are in low.txt, too");
  check_bad_file(box, from_points({"part.txt", "all.txt"}), "part.txt", "all its points are in all.txt, too");
  check_bad_file(box, from_points({"all.txt"}) + Arguments{"--withhold", "part.txt"}, "part.txt",
                 "all its points are in all.txt, too");
  const auto bad_sensor = [&](const std::string& text, const std::string& message) {
    box.write("bad.yaml", text);
    check_bad_file(box, {"calibrate", "--points", "low.txt", "high.txt", "--sensor", "bad.yaml", "-o", "rig.yaml"},
                   "bad.yaml", message);
  };
  const std::string sensor = box.read("sensor.yaml");
  bad_sensor("", "neither a map");
  bad_sensor("width_px: [", "line");
  bad_sensor("width_px: 640\n", "height_px: missing");
  bad_sensor(sensor + "Sx: 1.01\n", "line 7, column 1: 'Sx' is not known");
  bad_sensor(sensor + "sx: -1\n", "sx: '-1'");
}

TEST_CASE("images: a rig, its report and its picture") {
  Sandbox box;
  with_images(box);
  const json result = report(box, from_pairs() + Arguments{"--picture", "residuals.png"});
  CHECK(result["method"] == "joint");
  CHECK(result["usable"] == true);
  CHECK(result["views"].size() == 10);
  for (const json& view : result["views"]) {
    CHECK(view["found"] == true);
    CHECK(view["rms_px"].get<double>() < 0.1);
    CHECK(fs::exists(box / view["file"].get<std::string>()));
  }
  CHECK(result["rms_px"]["stereo"].get<double>() < 0.06);
  CHECK(result["baseline_mm"].get<double>() == Approx(kBaselineMm).epsilon(0.005));
  CHECK(result["parameters"]["left"]["fx_px"].get<double>() == Approx(kFocalPx).epsilon(0.005));
  CHECK(result["parameters"]["right"]["tx_mm"].get<double>() == Approx(-kBaselineMm).epsilon(0.005));
  CHECK(cv::imread((box / "residuals.png").string()).cols >= 2 * kWidth);
  const json back = report(box, {"calibrate", "--import", "rig.yaml"});
  CHECK(back["baseline_mm"].get<double>() == Approx(result["baseline_mm"].get<double>()).epsilon(1e-12));
  // One camera alone; f in mm where the pitch is known.
  box.write("sensor.yaml", "640 480 0.01 0.01 319.5 239.5");
  const json one = report(box, {"calibrate", "--images", "left?.png", "--target", "chessboard:9x6:30mm", "--sensor",
                                "sensor.yaml", "--distortion", "none"});
  CHECK(one["parameters"]["f_mm"].get<double>() == Approx(6).epsilon(0.005));
  CHECK(one["rms_px"]["right"].is_null());
}

TEST_CASE("images: one target at known heights (6.8.1), its plane tilted or parallel to the image") {
  const double turn = GENERATE(0.0, 0.3);
  CAPTURE(turn);
  Sandbox box;
  const std::vector<double> lifts_mm{0, 50, 100, 150};
  for (std::size_t i = 0; i < lifts_mm.size(); ++i) {
    for (const auto& [camera, shift_mm] : {std::pair{"left", 0.0}, {"right", kBaselineMm}}) {
      cv::imwrite((box / (camera + std::to_string(i) + ".png")).string(),
                  photographed(turn, 0.2 * turn, shift_mm, 20, 0, lifts_mm[i]));
    }
  }
  const auto at = [](const Arguments& heights) { return from_pairs() + Arguments{"--heights"} + heights; };
  const json result = report(box, at({"0,50,100,150"}));
  CHECK(result["usable"] == true);
  CHECK(result["rms_px"]["stereo"].get<double>() < 0.1);
  CHECK(result["baseline_mm"].get<double>() == Approx(kBaselineMm).epsilon(0.01));
  for (const char* camera : {"left", "right"}) {
    CHECK(result["parameters"][camera]["fx_px"].get<double>() == Approx(kFocalPx).epsilon(0.01));
  }
  // Heights that are not those of the images: the rig is not usable, or the images are named that do not fit.
  const json wrong = report(box, at({"0,100,50,150"}));
  CAPTURE(wrong.dump());
  CHECK((wrong["usable"] == false || names(wrong["warnings"], "outlier_view: ")));
  check_refused(box, at({"0,50"}), 3, "2 heights for 4 images");
}

TEST_CASE("images: what is wrong with one of them is named, and the rig made from the others") {
  Sandbox box;
  with_images(box);
  cv::imwrite((box / "right1.png").string(), cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(128)));
  cv::imwrite((box / "left2.png").string(), photographed(0.1, 0.3, 0, 370));  // half outside
  const json result = report(box, from_pairs());
  CHECK(result["usable"] == true);
  CHECK(names(result["warnings"], "target_not_found: right1.png: "));
  CHECK(names(result["warnings"], "target_not_found: left2.png: the chessboard is partly outside the image"));
  CHECK(result["baseline_mm"].get<double>() == Approx(kBaselineMm).epsilon(0.01));
  // A pair that was not taken at one time.
  Sandbox other;
  with_images(other);
  const auto& [turn_x, turn_y, x, y] = kPoses[3];
  cv::imwrite((other / "right4.png").string(), photographed(turn_x, turn_y, kBaselineMm, x + 1, y));
  const json moved = report(other, from_pairs());
  CHECK(names(moved["warnings"], "outlier_view: left4.png"));
  CHECK(names(moved["warnings"], "outlier_view: right4.png"));
  CHECK(moved["baseline_mm"].get<double>() == Approx(kBaselineMm).epsilon(0.01));
}

TEST_CASE("images: one pose is one in however many views, and no image counts twice") {
  Sandbox box;
  const auto& [turn_x, turn_y, x, y] = kPoses[0];
  cv::RNG random(1);
  for (int i = 0; i < 4; ++i) {
    for (const auto& [camera, shift_mm] : {std::pair{"left", 0.0}, {"right", kBaselineMm}}) {
      cv::Mat noise(kHeight, kWidth, CV_16SC1), noisy;
      random.fill(noise, cv::RNG::NORMAL, 0, 2);
      cv::add(photographed(turn_x, turn_y, shift_mm, x, y), noise, noisy, cv::noArray(), CV_8U);
      cv::imwrite((box / (camera + std::to_string(i) + ".png")).string(), noisy);
    }
  }
  const auto result = box.run(from_pairs());
  CAPTURE(result.out, result.err);
  CHECK(result.status == 0);
  for (const char* const warning : {"one_view: left: ", "one_view: right: ", "one_pair: "}) {
    CHECK_THAT(result.err, Catch::Contains(std::string("horopter: warning: ") + warning));
  }
  CHECK_THAT(result.out, !Catch::Contains("few_views"));
  CHECK(report(box, from_pairs())["baseline_mm"].get<double>() == Approx(kBaselineMm).epsilon(0.02));
  fs::remove(box / "rig.yaml");
  for (const std::string camera : {"left", "right"}) {
    fs::copy_file(box / (camera + "0.png"), box / (camera + "4.png"));
  }
  check_refused(box, from_pairs(), 3, "left0.png and left4.png are one image");
}

TEST_CASE("images: bad input never makes a rig") {
  Sandbox box;
  with_images(box);
  cv::imwrite((box / "flat.png").string(), cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(128)));
  cv::imwrite((box / "small.png").string(), cv::Mat(240, 320, CV_8UC1, cv::Scalar(128)));
  const auto images = [&](const Arguments& files, const std::string& target) {
    return Arguments{"calibrate", "--images"} + files + Arguments{"--target", target, "-o", "rig.yaml"};
  };
  check_refused(box, images({"flat.png"}, "chessboard:9x6:30mm"), 3, "the target is in none of the 1 images");
  check_refused(box, images({"left?.png"}, "chessboard:8x6:30mm"), 3, "wrong pattern size");
  check_refused(box, images({"left?.png"}, "chessboard:10x6:30mm"), 3, "wrong pattern size");
  check_refused(box, images({"left?.png"}, "squares:8x6:15mm:30mm"), 3, "the target is in none");
  check_bad_file(box, images({"left0.png", "small.png"}, "chessboard:9x6:30mm"), "small.png", "320x240");
  check_bad_file(box, from_pairs("left?.png", "right0.png"), "right0.png", "5 left images but 1 right");
  check_bad_file(box, from_pairs("none*.png"), "none*.png", "no file matches");
  const std::string png = box.read("left0.png");
  box.write("cut.png", png.substr(0, png.size() / 2));
  check_bad_file(box, images({"cut.png"}, "chessboard:9x6:30mm"), "cut.png", "truncated");
  // The board parallel to the image in every view.
  for (int i = 0; i < 3; ++i)
    cv::imwrite((box / ("parallel" + std::to_string(i) + ".png")).string(), photographed(0, 0, 0, 20 * i, 10 * i));
  check_refused(box, images({"parallel?.png"}, "chessboard:9x6:30mm"), 1, "cannot be told apart");
  // One camera taken for two; cameras exchanged.
  check_bad_file(box, from_pairs("left?.png", "left?.png"), "left0.png", "this is the left image, too");
  for (int i = 0; i < 5; ++i) {
    const std::string number = std::to_string(i) + ".png";
    fs::copy_file(box / ("left" + number), box / ("again" + number));
  }
  check_refused(box, from_pairs("left?.png", "again?.png"), 1, "stand at one place");
  CHECK(names(report(box, from_pairs("right?.png", "left?.png"))["warnings"], "left_right_exchanged: "));
  fs::remove(box / "rig.yaml");
  // The target in metres.
  check_refused(box,
                {"calibrate", "--left", "left?.png", "--right", "right?.png", "--target", "chessboard:9x6:0.03mm", "-o",
                 "rig.yaml"},
                1, "mm apart; expected 5 to 20000 mm");
  // Images as JSON, too, when no rig is made.
  const json none = report(box, images({"flat.png"}, "chessboard:9x6:30mm"), 3);
  CHECK(none["usable"] == false);
  CHECK(none["views"][0]["found"] == false);
  CHECK(none["rms_px"]["left"].is_null());
  // What cannot be written leaves nothing else.
  check_bad_file(box, from_pairs() + Arguments{"--picture", "nowhere/residuals.png"}, "nowhere/residuals.png",
                 "written");
  check_bad_file(box,
                 {"calibrate", "--images", "left?.png", "--target", "chessboard:9x6:30mm", "-o", "nowhere/rig.yaml"},
                 "nowhere/rig.yaml", "written");
}

TEST_CASE("calibrate, pattern, study: wrong usage is exit status 2, and help suffices") {
  Sandbox box;
  with_points(box);
  const Arguments target{"--target", "chessboard:9x6:30mm"};
  for (const Arguments& arguments : std::vector<Arguments>{
           {"calibrate"},
           {"calibrate", "--points", "low.txt"},
           {"calibrate", "--points", "low.txt", "--images", "x.png"},
           {"calibrate", "--points", "low.txt", "--sensor", "sensor.yaml", "--method", "guess"},
           {"calibrate", "--points", "low.txt", "--sensor", "sensor.yaml", "--distortion", "p1"},
           {"calibrate", "--points", "low.txt", "--sensor", "sensor.yaml", "--target", "chessboard:9x6:30mm"},
           {"calibrate", "--images", "x.png"},
           {"calibrate", "--images", "x.png", "--target", "circles:9x6:30mm"},
           Arguments{"calibrate", "--images", "x.png", "--distortion", "k9"} + target,
           Arguments{"calibrate", "--images", "x.png", "--method", "full"} + target,
           Arguments{"calibrate", "--left", "x.png"} + target,
           {"calibrate", "--import", "rig.yml", "--unit", "inch"},
           {"calibrate", "--import", "rig.yml", "--size", "640"},
           {"pattern"},
           {"pattern", "--target", "squares:8x6:15mm:25mm", "-o", "x.png"},
           {"pattern", "--target", "squares:8x6:15mm", "-o", "x.pdf"},
           {"pattern", "--target", "squares:8x6:15mm:25mm", "-o", "x.pdf", "--paper", "b9"},
           {"pattern", "--target", "squares:8x6:150mm:250mm", "-o", "x.pdf"},
           {"study"},
           {"study", "edges"},
           {"study", "weather", "--out", "x"}}) {
    const auto before = box.files();
    const auto result = box.run(arguments);
    CAPTURE(arguments, result.err);
    CHECK(result.status == 2);
    CHECK(result.out.empty());
    CHECK(!result.err.empty());
    CHECK(box.files() == before);
  }
  const auto help = box.run({"calibrate", "--help"});
  CHECK(help.status == 0);
  for (const char* const word :
       {"--points", "--withhold", "--sensor", "width_px height_px dx_mm dy_mm cx_px cy_px", "dlt", "--left",
        "--heights", "chessboard:9x6:30mm", "squares:", "k1k2p1p2", "--import", "--picture", "exit status", "Example"})
    CHECK_THAT(help.out, Catch::Contains(word));
  CHECK_THAT(box.run({"pattern", "--help"}).out, Catch::Contains("--paper") && Catch::Contains("Example"));
  CHECK_THAT(box.run({"study", "--help"}).out, Catch::Contains("edges") && Catch::Contains("calibration"));
}

TEST_CASE("calibrate writes over none of its inputs, and not two outputs into one file; a rig.yaml may become itself") {
  Sandbox box;
  box.write("rig.yaml", two_cameras(200, 120, 200, "-50, 0, 0"));
  const Arguments import{"calibrate", "--import", "rig.yaml"};
  REQUIRE(box.run(import + Arguments{"-o", "rig.yaml", "--export-opencv", "cv.yml"}).status == 0);
  check_refused(box, import + Arguments{"-o", "same.yml", "--export-opencv", "same.yml"}, 2,
                "--export-opencv and --output");
  check_refused(box, import + Arguments{"--export-opencv", "rig.yaml"}, 2, "--import and --export-opencv");
  check_refused(box, import + Arguments{"--export-ros", ".", "-o", "left.yaml"}, 2, "--export-ros and --output");
  check_refused(box, {"calibrate", "--import", "cv.yml", "-o", "cv.yml"}, 2, "--import and --output");
  box.write("points.txt", "0 0 0 0 0\n");
  check_refused(box, {"calibrate", "--points", "points.txt", "--sensor", "sensor.yaml", "--picture", "./points.txt"}, 2,
                "--points and --picture");
  CHECK(box.run({"calibrate", "--import", "rig.yaml", "--json"}).status == 0);
}

TEST_CASE("formats: one calibration in three formats is one rig; a rig survives export and import") {
  const auto folder = shared_data("formats");
  if (!folder) return;
  Sandbox box;
  const auto path = [&](const char* name) { return (*folder / name).string(); };
  const json first = report(box, {"calibrate", "--import", path("stereo_all.json"), "--unit", "mm", "-o", "rig.yaml",
                                  "--export-opencv", "back.yml", "--export-ros", "back"});
  CHECK(first["format"] == "OpenCV");
  const auto same = [&](const Arguments& files, double tolerance) {
    const json other = report(box, Arguments{"calibrate", "--import"} + files);
    CAPTURE(files, other["format"]);
    CHECK(other["baseline_mm"].get<double>() == Approx(first["baseline_mm"].get<double>()).margin(tolerance));
    REQUIRE(other["cameras"].size() == first["cameras"].size());
    for (std::size_t i = 0; i < first["cameras"].size(); ++i) {
      const json &a = first["cameras"][i], &b = other["cameras"][i];
      CHECK(a["name"] == b["name"]);
      CHECK(a["image_size"] == b["image_size"]);
      for (const char* const key : {"fx_px", "fy_px", "cx_px", "cy_px"})
        CHECK(a[key].get<double>() == Approx(b[key].get<double>()).margin(tolerance));
      for (const char* const key : {"lens", "translation_mm", "rotation"}) {
        const json left = a[key].flatten(), right = b[key].flatten();
        for (const auto& [at, value] : left.items())
          CHECK(value.get<double>() == Approx(right[at].get<double>()).margin(tolerance));
      }
    }
  };
  same({path("intrinsics.yml"), path("extrinsics.yml"), "--size", "640x480", "--unit", "mm"}, 1e-6);
  same({path("ros_left.yaml"), path("ros_right.yaml")}, 1e-6);
  same({path("camchain.yaml")}, 1e-6);
  same({"rig.yaml"}, 1e-12);
  same({"back.yml"}, 1e-9);
  same({"back/left.yaml", "back/right.yaml"}, 1e-9);
}

TEST_CASE("formats: a rig whose camera is named as a place elsewhere is not exported, and nothing is written") {
  Sandbox box;
  with_points(box);
  box.write("right.txt", seen(points_at({0, 80}), 0.4, kBaselineMm));
  report(box, from_points({"low.txt", "high.txt"}) + Arguments{"--right-points", "right.txt"});
  std::string rig = box.read("rig.yaml");
  const auto at = rig.find("\"right\"");
  REQUIRE(at != std::string::npos);
  box.write("evil.yaml", rig.replace(at, 7, "\"../../evil\""));
  check_refused(box,
                {"calibrate", "--import", "evil.yaml", "--export-opencv", "rig.yml", "--export-ros", "deep/ros", "-o",
                 "out.yaml"},
                3, "camera '../../evil'");
}

TEST_CASE("opencv-doc's chessboards: the figures of OpenCV or better, in less than five seconds") {
  const auto folder = opencv_images();
  if (!folder) return;
  Sandbox box;
  const auto pairs = [&](const std::string& target, const std::string& distortion) {
    return Arguments{"calibrate",
                     "--left",
                     (*folder / "left[01][0-9].jpg").string(),
                     "--right",
                     (*folder / "right[01][0-9].jpg").string(),
                     "--target",
                     target,
                     "--distortion",
                     distortion,
                     "-o",
                     "rig.yaml"};
  };
  const auto processor_s = [] {
    rusage usage{};
    ::getrusage(RUSAGE_CHILDREN, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
  };
  // OpenCV, jointly: 0.265 and 0.215 px, baseline 99.81 mm.
  for (const auto& [distortion, rms_px] : {std::pair{"k1", 0.27}, {"k1k2p1p2", 0.22}}) {
    CAPTURE(distortion);
    const double begin = processor_s();
    const json result = report(box, pairs("chessboard:9x6:30mm", distortion));
    CHECK(processor_s() - begin < 5);
    CHECK(result["views"].size() == 26);
    for (const json& view : result["views"]) CHECK(view["used"] == true);
    CHECK(result["rms_px"]["stereo"].get<double>() <= rms_px);
    CHECK(std::abs(result["baseline_mm"].get<double>() - 99.81) < 0.2);
    CHECK_FALSE(names(result["warnings"], "coverage: "));
    CHECK_FALSE(names(result["warnings"], "poor_fit: "));
  }
  // Part of a chessboard is not a smaller chessboard.
  fs::remove(box / "rig.yaml");
  check_refused(box,
                {"calibrate", "--images", (*folder / "left0[24].jpg").string(), "--target", "chessboard:8x6:30mm", "-o",
                 "rig.yaml"},
                3, "wrong pattern size");
}

TEST_CASE("Zhang's images: all corners found without a guess, better than the published ones") {
  const auto folder = shared_data("zhang");
  if (!folder) return;
  Sandbox box;
  const json result = report(box, {"calibrate", "--images", (*folder / "CalibIm*.pgm").string(), "--target",
                                   "squares:8x8:12.7mm:22.57779mm", "--distortion", "k1k2", "-o", "rig.yaml"});
  CHECK(result["image_error_px"]["points"] == 5 * 256);
  CHECK(result["image_error_px"]["rms"].get<double>() < 0.30);  // the published corners: 0.337
  CHECK(result["parameters"]["fx_px"].get<double>() == Approx(832.5).epsilon(0.003));
}

TEST_CASE("Willson's points through the program: the reference's error, NCE and Tz/f") {
  const auto folder = shared_data("tsai");
  if (!folder) return;
  Sandbox box;
  box.write("sensor.yaml",
            "{width_px: 576, height_px: 384, dx_mm: 0.023, dy_mm: 0.023, cx_px: 258, cy_px: 204, sx: 1}");
  const json result = report(box, from_points({(*folder / "ncc_cd.dat").string()}));
  CHECK(result["image_error_px"]["mean"].get<double>() <= 1.01 * 0.0797);
  CHECK(result["nce"].get<double>() <= 1.01 * 0.1936);
  CHECK(result["parameters"]["tz_over_f"].get<double>() == Approx(28.578).epsilon(1e-3));
}

TEST_CASE("pattern writes a sheet in exact millimetres") {
  Sandbox box;
  for (const std::string file : {"target.pdf", "target.svg"}) {
    const json made = report(box, {"pattern", "--target", "squares:6x4:20mm:35mm", "--paper", "a4", "-o", file});
    CHECK(made["target"] == "squares:6x4:20mm:35mm");
    CHECK(made["sheet_mm"] == json({297.0, 210.0}));
    CHECK(fs::exists(box / file));
  }
  CHECK(box.read("target.pdf").starts_with("%PDF-1."));
  CHECK_THAT(box.read("target.pdf"), Catch::Contains("/MediaBox [ 0 0 841.889764 595.275591 ]"));
  CHECK_THAT(box.read("target.svg"), Catch::Contains("width=\"297mm\" height=\"210mm\" viewBox=\"0 0 297 210\""));
  CHECK_THAT(box.run({"pattern", "--target", "chessboard:9x6:20mm", "-o", "board.svg"}).out,
             Catch::Contains("check with a ruler"));
  check_bad_file(box, {"pattern", "--target", "chessboard:9x6:20mm", "-o", "nowhere/board.svg"}, "nowhere/board.svg",
                 "written");
}

TEST_CASE("study edges finds what the thesis found (6.7)") {
  Sandbox box;
  const json result = report(box, {"study", "edges", "--quick", "--out", "study"});
  const json& steepest = result["steepest_edge_max_error_px"];
  for (const char* const method : {"zernike-9", "zernike-13", "gaussian"}) CHECK(steepest[method].get<double>() < 0.08);
  for (const char* const method : {"tabatabai-1d", "tabatabai-2d"}) {
    CHECK(steepest[method].get<double>() > 0.14);
    CHECK(steepest[method].get<double>() < 0.25);
  }
  const double noise = result["zernike_13_diamond_16_points_rms_px"];
  CHECK(noise > 0.003);
  CHECK(noise < 0.03);
  for (const char* const plot : {"position.svg", "blur.svg", "series.svg", "points.svg"}) {
    const std::string svg = box.read(std::string("study/") + plot);
    CHECK_THAT(svg, Catch::StartsWith("<?xml") && Catch::EndsWith("</svg>\n") && !Catch::Contains("nan"));
  }
  CHECK(json::parse(box.read("study/summary.json")) == result);
}

TEST_CASE("study interpolation: weights of three bits are enough (7.5)") {
  Sandbox box;
  const json result = report(box, {"study", "interpolation", "--quick", "--out", "study"});
  const auto figure = [&](const char* kind, const char* method, const char* key) {
    return result[kind][method][key].get<double>();
  };
  // The thesis: sigma 7 for nearest, 1.5 for steps of 1/4, proportional to the step.
  CHECK(figure("scaling", "nearest", "sigma_grey") == Approx(7).margin(1.5));
  CHECK(figure("scaling", "step 1/4", "sigma_grey") == Approx(1.5).margin(0.4));
  CHECK(figure("scaling", "step 1/2", "sigma_grey") / figure("scaling", "step 1/4", "sigma_grey") ==
        Approx(2).margin(0.2));
  // Nearest is half a pixel off at most; steps of 1/8 add little to what bilinear interpolation costs.
  CHECK(figure("translation", "nearest", "largest_equivalent_px") == Approx(0.5).margin(0.05));
  const double bilinear = figure("translation", "bilinear", "largest_equivalent_px");
  CHECK(bilinear > 0.05);
  CHECK(figure("translation", "step 1/8", "largest_equivalent_px") < bilinear + 0.03);
  CHECK(figure("translation", "step 1/2", "largest_equivalent_px") > bilinear + 0.1);
  CHECK(figure("translation", "cubic", "largest_equivalent_px") < bilinear);
  double before = 100;
  for (const char* const step : {"nearest", "step 1/2", "step 1/4", "step 1/8", "step 1/16", "step 1/32"}) {
    CHECK(figure("scaling", step, "sigma_grey") < before);
    before = figure("scaling", step, "sigma_grey");
  }
  // A translation by a multiple of the step is the same as with continuous weights.
  const std::string table = box.read("study/translation.csv");
  const auto row = [&](const std::string& start) {
    const auto at = table.find("\n" + start) + 1;
    REQUIRE(at != 0);
    return table.substr(at + start.size(), table.find('\n', at) - at - start.size());
  };
  CHECK(row("step 1/4,2,0.25,") == row("bilinear,,0.25,"));
  CHECK(row("step 1/4,2,0.375,") != row("bilinear,,0.375,"));
  CHECK_THAT(box.read("study/interpolation.svg"), Catch::EndsWith("</svg>\n") && !Catch::Contains("nan"));
}

TEST_CASE("study board: a skin in mm on photographs finds the board, and does not find it 50 mm away") {
  if (!horopter::test::opencv_images()) return;
  Sandbox box;
  const json result = report(box, {"study", "board", "--quick", "--engines", "native", "--out", "study"});
  CHECK(result["corners_rms_px"]["k1k2p1p2"].get<double>() <= 0.30);
  CHECK(result["corners_rms_px"]["k1"].get<double>() <= 0.42);
  for (const json& share : result["shares"]) {
    CAPTURE(share.dump());
    CHECK(share["decidable"].get<double>() > 0.25);
    if (share["shift_mm"] == 0) {
      CHECK(share["in_skin"].get<double>() >= 0.98);
      CHECK(share["alarms"] == result["pairs"]);
    } else {
      CHECK(share["in_skin"].get<double>() <= 0.10);
      CHECK(share["alarms"] == 0);
    }
  }
  CHECK_THAT(box.read("study/displacement.svg"), Catch::EndsWith("</svg>\n") && !Catch::Contains("nan"));
  box.write("empty.txt", "");
  check_bad_file(box, {"study", "board", "--data", ".", "--out", "none"}, ".", "0 pairs");
}

TEST_CASE("study calibration: the rendered rig of 6.8, and the Cramer-Rao bound") {
  Sandbox box;
  const json result = report(box, {"study", "calibration", "--quick", "--out", "study"});
  for (const char* const target : {"squares", "diamonds"})
    for (const char* const method : {"zernike-13", "horopter"}) {
      CAPTURE(target, method);
      CHECK(result["nce_thesis"]["perfect"][target][method]["all"].get<double>() <= 0.5);
      const double printed = result["nce_thesis"]["errors"][target][method]["all"];
      CHECK(printed > 0.7);
      CHECK(printed < 1.2);
    }
  CHECK(result["cramer_rao"]["ratio"].get<double>() == Approx(1).epsilon(0.1));
  CHECK_THAT(box.read("study/nce.svg"), Catch::EndsWith("</svg>\n") && !Catch::Contains("nan"));
  CHECK(fs::exists(box / "study/cramer-rao.csv"));
}
