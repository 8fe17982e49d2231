// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

#include "horopter/calib/render.hpp"
#include "horopter/calib/target.hpp"
#include "shared_data.hpp"

using namespace horopter::calib;
using Catch::Contains;
using Eigen::Vector2d;
using Reason = TargetError::Reason;

namespace {

struct Difference {
  double rms, max;
};
Difference difference(const std::vector<Vector2d>& a, const std::vector<Vector2d>& b) {
  REQUIRE(a.size() == b.size());
  Difference d{0, 0};
  for (std::size_t i = 0; i < a.size(); ++i) {
    d.rms += (a[i] - b[i]).squaredNorm() / a.size();
    d.max = std::max(d.max, (a[i] - b[i]).norm());
  }
  d.rms = std::sqrt(d.rms);
  return d;
}

std::vector<Vector2d> projected(const RenderCamera& camera, const RenderTarget& target) {
  std::vector<Vector2d> result;
  for (const auto& point : target.world_mm()) result.push_back(camera.project(point));
  return result;
}

Imaging camera_like() {
  Imaging imaging;
  imaging.blur_px = 0.8;
  imaging.noise = 1;
  imaging.quantise = true;
  return imaging;
}

/// How a target is printed and laid down.
struct Scene {
  bool hole = false;
  bool bright = false;
  double turn_deg = 0;
  double kappa1_per_mm2 = 0.003;
  double ink_gain_mm = 0;  ///< of each edge of a square, outward
};

/// An image of a target in the middle of it, as by the thesis's camera, but smaller. `corners` are those of a perfect
/// print.
cv::Mat small_image(const TargetSpec& spec, const Scene& scene = {}, std::vector<Vector2d>* corners = nullptr) {
  RenderCamera camera;
  camera.width_px = 400;
  camera.height_px = 300;
  camera.cx_px = 199.5;
  camera.cy_px = 149.5;
  camera.kappa1 = scene.kappa1_per_mm2;
  const std::vector<Vector2d> points = spec.points_mm();
  Vector2d middle(0, 0);
  for (const Vector2d& p : points) middle += p / points.size();
  const double angle = scene.turn_deg * 3.14159265358979 / 180;
  const Vector2d turned(std::cos(angle) * middle.x() - std::sin(angle) * middle.y(),
                        std::sin(angle) * middle.x() + std::cos(angle) * middle.y());
  RenderTarget target;
  target.spec = spec;
  target.hole = scene.hole;
  target.bright = scene.bright;
  target.turn_deg = scene.turn_deg;
  target.shift_mm = -turned;
  target.margin_mm = 25;
  camera.rotation = Eigen::Quaterniond(0.99, 0.08, -0.06, 0.01).normalized().toRotationMatrix();
  camera.translation_mm = {3, -2, 1000};
  if (corners) *corners = projected(camera, target);
  for (std::size_t i = 0; scene.ink_gain_mm != 0 && i < points.size(); ++i)
    target.print_error_mm.emplace_back(scene.ink_gain_mm *
                                       Vector2d(i % 4 == 0 || i % 4 == 3 ? -1 : 1, i % 4 < 2 ? -1 : 1));
  return to_mat(render_target(camera, target, camera_like(), 11, 2));
}

Reason reason_of(const cv::Mat& image, const std::string& spec, const std::string& words) {
  try {
    detect_target(image, TargetSpec::parse(spec));
  } catch (const TargetError& error) {
    INFO(error.what());
    CHECK_THAT(error.what(), Contains(words));
    return error.reason();
  }
  FAIL("found a " << spec << " where none is");
  return Reason::no_target;
}

}  // namespace

TEST_CASE("a target is described in one word") {
  const TargetSpec squares = TargetSpec::parse("squares:8x8:12.7mm:22.57779mm");
  CHECK(squares.kind == TargetKind::squares);
  CHECK(squares.points_mm().size() == 256);
  CHECK(squares.text() == "squares:8x8:12.7mm:22.57779mm");
  CHECK((squares.points_mm()[0] - Vector2d(0, -12.7)).norm() < 1e-12);
  CHECK((squares.points_mm()[255] - Vector2d(7 * 22.57779, -7 * 22.57779)).norm() < 1e-9);
  const TargetSpec chessboard = TargetSpec::parse("chessboard:9x6:30");
  CHECK(chessboard.points_mm().size() == 54);
  CHECK((chessboard.points_mm()[10] - Vector2d(30, 30)).norm() < 1e-12);
  for (const char* bad :
       {"", "circles:3x3:1mm:2mm", "squares:8x8:12.7mm", "squares:8:1mm:2mm", "squares:0x8:1mm:2mm",
        "squares:8x8:-1mm:2mm", "squares:8x8:2mm:1mm", "diamonds:8x8:10mm:12mm", "squares:8x8:1in:2in",
        "squares:8x8:nan:2mm", "chessboard:9x6:30mm:30mm", "chessboard:9x6x2:30mm", "squares:8x8:1mm:2mm:3mm"}) {
    INFO(bad);
    CHECK_THROWS_WITH(TargetSpec::parse(bad), Contains("expected squares:COLUMNSxROWS"));
  }
}

TEST_CASE("Zhang's squares: all 256 corners of all five images, and good enough to calibrate with") {
  const auto folder = horopter::test::shared_data("zhang");
  if (!folder) return;
  const TargetSpec spec = TargetSpec::parse("squares:8x8:12.7mm:22.57779mm");
  {
    std::ifstream file(*folder / "model.txt");
    double x = 0;
    double y = 0;
    for (const Vector2d& point : spec.points_mm()) {
      REQUIRE(file >> x >> y);
      CHECK((Vector2d(x, y) * 25.4 - point).norm() < 0.001);
    }
  }
  std::vector<std::vector<cv::Point3f>> object;
  std::vector<std::vector<cv::Point2f>> pixels;
  for (int i = 1; i <= 5; ++i) {
    const cv::Mat image = cv::imread(*folder / ("CalibIm" + std::to_string(i) + ".pgm"), cv::IMREAD_GRAYSCALE);
    const TargetView view = detect_target(image, spec);
    std::vector<Vector2d> published;
    std::ifstream file(*folder / ("data" + std::to_string(i) + ".txt"));
    for (double x = 0, y = 0; file >> x >> y;) published.emplace_back(x, y);
    const Difference d = difference(view.image_px, published);
    CHECK(d.max < 1.5);
    CHECK_FALSE(view.oriented);
    object.emplace_back();
    pixels.emplace_back();
    for (std::size_t k = 0; k < 256; ++k) {
      object.back().emplace_back(view.target_mm[k].x(), view.target_mm[k].y(), 0);
      pixels.back().emplace_back(view.image_px[k].x(), view.image_px[k].y());
    }
  }
  cv::Mat matrix;
  cv::Mat lens;
  std::vector<cv::Mat> rotations;
  std::vector<cv::Mat> translations;
  const double rms = cv::calibrateCamera(object, pixels, {640, 480}, matrix, lens, rotations, translations,
                                         cv::CALIB_ZERO_TANGENT_DIST | cv::CALIB_FIX_K3);
  CHECK(rms < 0.25);  // with the published corners 0.337
  CHECK(matrix.at<double>(0, 0) == Approx(832.5).epsilon(0.003));
}

TEST_CASE("a rendered pattern: corners where they were rendered") {
  for (const char* const name : {"squares:5x4:33mm:60mm", "diamonds:5x4:33mm:60mm"}) {
    const TargetSpec spec = TargetSpec::parse(name);
    const Scene scene{.hole = spec.kind == TargetKind::diamonds, .bright = true, .kappa1_per_mm2 = 0.0008};
    std::vector<Vector2d> corners;
    const TargetView view = detect_target(small_image(spec, scene, &corners), spec);
    const Difference d = difference(view.image_px, corners);
    // Twenty fiducials know how far their edges are displaced, here 0, to some hundredths of a pixel.
    CHECK(view.edge_shift_px.norm() < 0.06);
    CHECK(d.rms < 0.04);
    CHECK(d.max < 0.1);
    CHECK(view.oriented == scene.hole);
  }
}

TEST_CASE("edges that moved outward do not move the corners") {
  const TargetSpec spec = TargetSpec::parse("squares:5x4:33mm:60mm");
  std::vector<Vector2d> corners;
  // 0.25 mm on each side, about 0.3 px.
  const cv::Mat image = small_image(spec, {.bright = true, .ink_gain_mm = 0.25}, &corners);
  const TargetView view = detect_target(image, spec);
  CHECK(difference(view.image_px, corners).rms < 0.03);
  CHECK(view.edge_shift_px.x() == Approx(0.29).margin(0.05));
  TargetOptions as_seen;
  as_seen.settle = false;
  CHECK(difference(detect_target(image, spec, as_seen).image_px, corners).rms > 0.3);
}

TEST_CASE("the first fiducial is found by its hole, however the target is turned") {
  const std::vector<double> all{0.0, 90.0, 180.0, -100.0}, some{135.0, 30.0};
  for (const auto& [name, turns] :
       {std::pair{"squares:5x4:20mm:40mm", all}, {"squares:4x4:20mm:40mm", some}, {"diamonds:5x4:18mm:40mm", some}})
    for (const double turn : turns) {
      INFO(name << " turned by " << turn);
      const TargetSpec spec = TargetSpec::parse(name);
      std::vector<Vector2d> corners;
      const TargetView view = detect_target(small_image(spec, {.hole = true, .turn_deg = turn}, &corners), spec);
      CHECK(view.oriented);
      CHECK(difference(view.image_px, corners).max < 0.15);
    }
}

TEST_CASE("chessboards: orientation by colour, corners by their edges") {
  const TargetSpec spec = TargetSpec::parse("chessboard:7x4:28mm");
  for (const double turn : {0.0, 60.0, 260.0}) {
    INFO("turned by " << turn);
    std::vector<Vector2d> corners;
    const TargetView view = detect_target(small_image(spec, {.turn_deg = turn}, &corners), spec);
    CHECK(view.oriented);
    CHECK(difference(view.image_px, corners).rms < 0.03);
  }
}

TEST_CASE("real chessboards (all of them: tests/system)") {
  const auto folder = horopter::test::opencv_images();
  if (!folder) return;
  const TargetSpec spec = TargetSpec::parse("chessboard:9x6:30mm");
  for (const char* const name : {"left01.jpg", "left02.jpg", "left08.jpg", "right03.jpg", "right12.jpg"}) {
    const TargetView view = detect_target(cv::imread(*folder / name, cv::IMREAD_GRAYSCALE), spec);
    CHECK(view.plane_rms_px < 0.45);
  }
}

TEST_CASE("what is wrong with an image is named") {
  const TargetSpec spec = TargetSpec::parse("squares:5x4:20mm:40mm");
  const cv::Mat image = small_image(spec);
  CHECK(detect_target(image, spec).image_px.size() == 80);

  CHECK(reason_of(image, "squares:6x4:20mm:40mm", "wrong pattern size: found 5x4 squares, expected 6x4") ==
        Reason::wrong_size);
  CHECK(reason_of(image, "squares:4x4:20mm:40mm", "found 5x4 squares, expected 4x4") == Reason::wrong_size);
  CHECK(reason_of(image, "diamonds:5x4:20mm:40mm", "are squares") == Reason::no_target);
  CHECK(reason_of(image, "chessboard:5x4:20mm", "no chessboard of 5x4") == Reason::no_target);

  // Half outside.
  const cv::Mat left_half = image(cv::Rect(0, 0, 215, 300)).clone();
  CHECK(reason_of(left_half, "squares:5x4:20mm:40mm", "right border") == Reason::partly_outside);
  const cv::Mat lower_half = image(cv::Rect(0, 140, 400, 160)).clone();
  CHECK(reason_of(lower_half, "squares:5x4:20mm:40mm", "upper border") == Reason::partly_outside);

  // A finger on it.
  cv::Mat finger = image.clone();
  cv::circle(finger, {200, 150}, 22, 150, cv::FILLED);
  CHECK(reason_of(finger, "squares:5x4:20mm:40mm", "hidden") == Reason::hidden);

  // Nothing.
  cv::Mat noise(300, 400, CV_8U);
  std::mt19937 random(5);
  for (int y = 0; y < noise.rows; ++y)
    for (int x = 0; x < noise.cols; ++x) noise.at<std::uint8_t>(y, x) = random() & 255;
  for (const char* name : {"squares:5x4:20mm:40mm", "diamonds:5x4:20mm:40mm"}) {
    CHECK(reason_of(noise, name, "no grid of 5x4") == Reason::no_target);
    CHECK(reason_of(cv::Mat(300, 400, CV_8U, cv::Scalar(128)), name, "nothing in the image") == Reason::no_target);
  }
  CHECK(reason_of(noise(cv::Rect(0, 0, 160, 120)), "chessboard:9x6:30mm", "no chessboard") == Reason::no_target);
  CHECK(reason_of(cv::Mat(), "squares:5x4:20mm:40mm", "empty") == Reason::bad_image);
  CHECK(reason_of(cv::Mat(300, 400, CV_16U, cv::Scalar(0)), "squares:5x4:20mm:40mm", "8 bits") == Reason::bad_image);

  // A mirror, where the print can tell.
  cv::Mat mirrored;
  cv::flip(small_image(spec, {.hole = true}), mirrored, 1);
  CHECK(reason_of(mirrored, "squares:5x4:20mm:40mm", "mirrored") == Reason::mirrored);
}

TEST_CASE("chessboards of another size") {
  const cv::Mat image = small_image(TargetSpec::parse("chessboard:7x4:28mm"));
  CHECK(reason_of(image, "chessboard:8x4:28mm", "7x4 inner corners found, expected 8x4") == Reason::wrong_size);
  CHECK(reason_of(image, "chessboard:6x4:28mm", "6x4") == Reason::wrong_size);
  const cv::Mat half = image(cv::Rect(60, 50, 170, 200)).clone();
  CHECK(reason_of(half, "chessboard:7x4:28mm", "of 7x4") != Reason::no_target);
}

TEST_CASE("corners measured by others: a mirrored order is refused") {
  const TargetSpec spec = TargetSpec::parse("chessboard:4x3:10mm");
  std::vector<Vector2d> corners;
  for (const Vector2d& p : spec.points_mm()) corners.emplace_back(100 + 5 * p.x() + p.y(), 80 + 4 * p.y());
  CHECK_NOTHROW(check_order(spec, corners));
  std::vector<Vector2d> turned(corners.rbegin(), corners.rend());
  CHECK_NOTHROW(check_order(spec, turned));
  std::vector<Vector2d> mirrored = corners;
  for (Vector2d& p : mirrored) p.x() = 640 - p.x();
  CHECK_THROWS_WITH(check_order(spec, mirrored), Contains("mirrored"));
  std::vector<Vector2d> few(corners.begin(), corners.end() - 1);
  CHECK_THROWS_WITH(check_order(spec, few), Contains("11 corners"));
  corners[3].x() = NAN;
  CHECK_THROWS_AS(check_order(spec, corners), TargetError);
}
