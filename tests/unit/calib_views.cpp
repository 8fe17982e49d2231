// SPDX-License-Identifier: Apache-2.0
// Cameras from views of a flat target: synthetic views with known truth, views that are wrong. Real images:
// tests/system.
#include <catch2/catch.hpp>
#include <random>

#include "horopter/calib/error.hpp"
#include "horopter/calib/views.hpp"

using namespace horopter::calib;
using Catch::Contains;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kWidth = 640, kHeight = 480;

std::vector<Vector2d> board(int columns = 9, int rows = 6) {
  std::vector<Vector2d> points;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) points.emplace_back(30.0 * column, 30.0 * row);
  }
  return points;
}

struct Truth {
  CameraModel left{BrownConradyIntrinsics{533, 534, 342, 235, {.k1 = -0.28, .k2 = 0.09, .p1 = 1e-3, .p2 = -5e-4}}};
  CameraModel right{BrownConradyIntrinsics{537, 536, 327, 250, {.k1 = -0.29, .k2 = 0.1, .p1 = -5e-4, .p2 = 2e-4}}};
  Pose left_to_right{rotation_from_vector({0.006, 0.004, -0.003}), {-99.8, 1.1, -0.2}};
};

/// Views of a board turned this way and that about its middle.
std::vector<ViewCamera> synthetic(const Truth& truth, int views, double noise_px, unsigned seed,
                                  const std::vector<Vector2d>& points = board()) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, 1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<ViewCamera> cameras{{"left", kWidth, kHeight, {}}, {"right", kWidth, kHeight, {}}};
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& point : points) middle += point / static_cast<double>(points.size());
  for (int view = 0; view < views; ++view) {
    Pose pose;
    pose.rotation = rotation_from_vector({0.6 * uniform(random), 0.6 * uniform(random), 0.3 * uniform(random)});
    pose.translation_mm = Vector3d(50 + 60 * uniform(random), 50 * uniform(random), 420 + 60 * uniform(random)) -
                          pose.rotation * Vector3d(middle.x(), middle.y(), 0);
    for (std::size_t c = 0; c < 2; ++c) {
      SeenTarget seen{.file = cameras[c].name + std::to_string(view), .pixels = {}, .problem = {}};
      for (const Vector2d& point : points) {
        const Vector3d in_left = pose * Vector3d(point.x(), point.y(), 0);
        const auto pixel = c == 0 ? truth.left.project(in_left) : truth.right.project(truth.left_to_right * in_left);
        REQUIRE(pixel);
        seen.pixels.push_back(*pixel + noise_px * Vector2d(noise(random), noise(random)));
      }
      cameras[c].views.push_back(std::move(seen));
    }
  }
  return cameras;
}

ViewOptions with_terms(const char* terms) {
  ViewOptions options;
  options.distortion = distortion_terms(terms);
  return options;
}

double value(const std::vector<Parameter>& list, const std::string& name) {
  for (const Parameter& parameter : list) {
    if (parameter.name == name) return parameter.value;
  }
  FAIL("no parameter " << name);
  return 0;
}

bool warned(const Report& report, const std::string& what) {
  for (const std::string& warning : report.warnings) {
    if (warning.find(what) != std::string::npos) return true;
  }
  return false;
}

bool problem(const Report& report, const std::string& what) {
  for (const std::string& text : report.problems) {
    if (text.find(what) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("exact views give both cameras and their pose back") {
  const Truth truth;
  const Report report = calibrate_views(synthetic(truth, 8, 0, 1), board());
  CHECK(report.usable);
  CHECK(report.errors.max_px < 1e-6);
  CHECK(*report.baseline_mm == Approx(truth.left_to_right.translation_mm.norm()).epsilon(1e-7));
  CHECK(value(report.cameras[0].parameters, "fx_px") == Approx(533).epsilon(1e-7));
  CHECK(value(report.cameras[1].parameters, "k2") == Approx(0.1).epsilon(1e-4));
  CHECK(value(report.cameras[1].parameters, "p1") == Approx(-5e-4).epsilon(1e-4));
  CHECK((report.rig.between(0, 1).translation_mm - truth.left_to_right.translation_mm).norm() < 1e-4);
}

TEST_CASE("noise: RMS and errors are what noise and covariance say") {
  const Truth truth;
  const Report report = calibrate_views(synthetic(truth, 10, 0.2, 2), board());
  CHECK(report.usable);
  CHECK(report.errors.rms_px == Approx(0.2 * std::sqrt(2.0)).epsilon(0.08));
  CHECK(std::abs(*report.baseline_mm - truth.left_to_right.translation_mm.norm()) < 4 * report.baseline_sd_mm);
  CHECK(report.baseline_sd_mm < 0.3);
  for (const Parameter& parameter : report.cameras[0].parameters) {
    if (parameter.name == "fx_px") CHECK(std::abs(parameter.value - 533) < 4 * parameter.sd);
  }
}

TEST_CASE("a rig that fits poorly is said to, and one that does not fit is none") {
  const Truth truth;
  const auto with_noise = [&](double rms_px) {
    return calibrate_views(synthetic(truth, 10, rms_px / std::sqrt(2.0), 2), board());
  };
  CHECK_FALSE(warned(with_noise(0.4), "poor_fit"));
  const Report poor = with_noise(0.8);
  CHECK(poor.usable);
  CHECK(warned(poor, "poor_fit: the views fit poorly: RMS 0."));
  const Report none = with_noise(2);
  CHECK_FALSE(none.usable);
  CHECK(problem(none, "the views do not fit: RMS"));
}

TEST_CASE("coverage is of the image's parts: targets in two corners are not in the rest") {
  const Truth truth;
  const auto with_boards = [&](const std::vector<Vector2d>& corners_px) {
    std::vector<ViewCamera> cameras = synthetic(truth, 2 * static_cast<int>(corners_px.size()), 0.1, 4);
    cameras.pop_back();
    // 210 x 130 px each, tilted either way.
    for (std::size_t view = 0; view < cameras[0].views.size(); ++view) {
      const Vector2d corner = corners_px[view % corners_px.size()];
      const double turn = view < corners_px.size() ? 0.5 : -0.5;
      Pose pose;
      pose.rotation = rotation_from_vector({turn, 0.3 * (static_cast<double>(view % 3) - 1), 0.05});
      const Vector2d sight = *truth.left.undistort(corner);
      const Vector3d middle = 600 * Vector3d(sight.x(), sight.y(), 1);
      pose.translation_mm = middle - pose.rotation * Vector3d(120, 75, 0);
      for (std::size_t i = 0; i < board().size(); ++i) {
        const auto pixel = truth.left.project(pose * Vector3d(board()[i].x(), board()[i].y(), 0));
        REQUIRE(pixel);
        cameras[0].views[view].pixels[i] = *pixel;
      }
    }
    return calibrate_views(cameras, board(), with_terms("k1k2"));
  };
  CHECK(warned(with_boards({{120, 90}, {520, 390}}), "coverage: left: the targets were in"));
  CHECK_FALSE(warned(with_boards({{120, 90}, {520, 390}, {120, 390}, {520, 90}, {320, 240}}), "coverage"));
}

TEST_CASE("a pair that was not taken at one time is named and left out") {
  const Truth truth;
  auto cameras = synthetic(truth, 7, 0.1, 3);
  std::swap(cameras[1].views[4].pixels, cameras[1].views[5].pixels);
  const Report report = calibrate_views(cameras, board());
  CHECK(report.usable);
  CHECK(warned(report, "outlier_view: left4"));
  CHECK(warned(report, "outlier_view: right5"));
  CHECK_FALSE(warned(report, "outlier_view: left3"));
  CHECK(std::abs(*report.baseline_mm - truth.left_to_right.translation_mm.norm()) < 4 * report.baseline_sd_mm);
}

TEST_CASE("views of one pose are one view, whatever their noise, and a pair is seen by both cameras") {
  Truth truth;
  truth.left = truth.right = CameraModel(BrownConradyIntrinsics{533, 533, 319.5, 239.5, {.k1 = -0.28}});
  const auto one = synthetic(truth, 1, 0, 1);
  auto cameras = one;
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.1);
  for (ViewCamera& camera : cameras) {
    camera.views.resize(10, camera.views[0]);
    for (SeenTarget& view : camera.views) {
      for (Vector2d& pixel : view.pixels) pixel += Vector2d(noise(random), noise(random));
    }
  }
  const Report alone = calibrate_views(one, board()), often = calibrate_views(cameras, board());
  for (const char* const warning : {"one_view: left", "one_view: right", "one_pair"}) {
    CAPTURE(warning);
    CHECK(warned(alone, warning));
    CHECK(warned(often, warning));
  }
  CHECK(*often.baseline_mm == Approx(truth.left_to_right.translation_mm.norm()).epsilon(0.02));
  // Different poses, but both cameras saw only one of them.
  auto apart = synthetic(truth, 9, 0.1, 1);
  for (std::size_t i = 1; i < 9; ++i) apart[i % 2].views[i].pixels.clear();
  const Report shared = calibrate_views(apart, board());
  CHECK(warned(shared, "one_pair"));
  CHECK_FALSE(warned(shared, "one_view"));
}

TEST_CASE("an image that a camera has twice is refused by both names") {
  auto cameras = synthetic(Truth{}, 6, 0.1, 9);
  cameras[1].views[4].pixels = cameras[1].views[1].pixels;
  CHECK_THROWS_WITH(calibrate_views(cameras, board()), Contains("right1 and right4 are one image"));
}

TEST_CASE("images without the target, in one camera or both") {
  const Truth truth;
  auto cameras = synthetic(truth, 6, 0.1, 4);
  cameras[0].views[1].pixels.clear();
  cameras[0].views[1].problem = "no target";
  cameras[1].views[2].pixels.clear();
  const Report report = calibrate_views(cameras, board());
  CHECK(report.usable);
  CHECK(warned(report, "target_not_found: left1: no target"));
  CHECK(warned(report, "target_not_found: right2"));
  CHECK(std::abs(*report.baseline_mm - truth.left_to_right.translation_mm.norm()) < 4 * report.baseline_sd_mm);
  for (SeenTarget& view : cameras[1].views) view.pixels.clear();
  CHECK_THROWS_WITH(calibrate_views(cameras, board()), Contains("none of the 6 images of right"));
}

TEST_CASE("no pair shows the target to both cameras") {
  const Truth truth;
  auto cameras = synthetic(truth, 8, 0.1, 5);
  for (std::size_t i = 0; i < 8; ++i) cameras[i % 2].views[i].pixels.clear();
  CHECK_THROWS_WITH(calibrate_views(cameras, board()), Contains("no view shows the target to both"));
}

TEST_CASE("a symmetric target that the right camera numbers from another corner") {
  const Truth truth;
  const auto points = board(7, 7);
  auto cameras = synthetic(truth, 8, 0.1, 6, points);
  for (ViewCamera& camera : cameras) {
    for (SeenTarget& view : camera.views) view.oriented = false;
  }
  // A quarter and a half turn.
  auto& quarter = cameras[1].views[2].pixels;
  const auto kept = quarter;
  for (std::size_t row = 0; row < 7; ++row) {
    for (std::size_t column = 0; column < 7; ++column) quarter[row * 7 + column] = kept[column * 7 + (6 - row)];
  }
  std::ranges::reverse(cameras[1].views[5].pixels);
  const Report report = calibrate_views(cameras, points);
  CHECK(report.usable);
  CHECK_FALSE(warned(report, "outlier_view"));
  CHECK(report.errors.rms_px < 0.16);
}

TEST_CASE("left and right exchanged, and one camera given twice") {
  const Truth truth;
  auto cameras = synthetic(truth, 6, 0.1, 7);
  std::swap(cameras[0].views, cameras[1].views);
  const Report exchanged = calibrate_views(cameras, board());
  CHECK(exchanged.usable);
  CHECK(warned(exchanged, "left_right_exchanged"));
  cameras[1].views = cameras[0].views;
  const Report twice = calibrate_views(cameras, board());
  CHECK_FALSE(twice.usable);
  CHECK(problem(twice, "at one place"));
}

TEST_CASE("all views parallel to the image: f is not known") {
  Truth truth;
  truth.left_to_right.rotation.setIdentity();
  std::vector<ViewCamera> cameras = synthetic(truth, 4, 0, 8);
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.1);
  for (int view = 0; view < 4; ++view) {
    for (std::size_t c = 0; c < 2; ++c) {
      auto& pixels = cameras[c].views[static_cast<std::size_t>(view)].pixels;
      pixels.clear();
      for (const Vector2d& point : board()) {
        const Vector3d p(point.x() - 100 + 10 * view, point.y() - 70, 400 + 30 * view);
        pixels.push_back((c == 0 ? *truth.left.project(p) : *truth.right.project(truth.left_to_right * p)) +
                         Vector2d(noise(random), noise(random)));
      }
    }
  }
  try {
    const Report report = calibrate_views(cameras, board(), with_terms("k1"));
    CHECK_FALSE(report.usable);
    CHECK(problem(report, "cannot be told apart"));
  } catch (const CalibrationError& error) {
    CHECK_THAT(error.what(), Contains("no camera explains") || Contains("cannot be told apart"));
  }
}

TEST_CASE("known heights of a plane, also parallel to the image") {
  const double tilt = GENERATE(0.0, 0.3);
  const Truth truth;
  Pose down;
  down.rotation = rotation_from_vector({tilt, 0.05, 0.1});
  down.translation_mm = Vector3d(-60, -70, 500);
  std::vector<ViewCamera> cameras{{"left", kWidth, kHeight, {}}, {"right", kWidth, kHeight, {}}};
  std::mt19937_64 random(9);
  std::normal_distribution<double> noise(0, 0.05);
  ViewOptions options;
  options.distortion = distortion_terms("k1k2");
  options.heights_mm = {0, 50, 100};
  for (const double height : options.heights_mm) {
    for (std::size_t c = 0; c < 2; ++c) {
      SeenTarget seen{.file = cameras[c].name, .pixels = {}, .problem = {}};
      for (const Vector2d& point : board()) {
        const Vector3d in_left = down * Vector3d(point.x(), point.y(), -height);
        seen.pixels.push_back(
            (c == 0 ? *truth.left.project(in_left) : *truth.right.project(truth.left_to_right * in_left)) +
            Vector2d(noise(random), noise(random)));
      }
      cameras[c].views.push_back(std::move(seen));
    }
  }
  const Report report = calibrate_views(cameras, board(), options);
  CHECK(report.usable);
  CHECK(report.errors.rms_px < 0.1);
  // z of the world points out of the print: the cameras stand above it.
  CHECK(report.rig.cameras[0].world_to_camera.centre().z() == Approx(500).epsilon(0.2));
  const auto seen = report.rig.cameras[1].project({60, -90, 50});  // x right, y up
  REQUIRE(seen);
  CHECK((*seen - *truth.right.project(truth.left_to_right * (down * Vector3d(60, 90, -50)))).norm() < 0.1);
  options.heights_mm = {0, 50};
  CHECK_THROWS_WITH(calibrate_views(cameras, board(), options), Contains("2 heights for 3 images"));
}

TEST_CASE("names of distortion terms") {
  CHECK(distortion_terms("k1")[0]);
  CHECK_FALSE(distortion_terms("k1")[1]);
  CHECK(distortion_terms("k1k2p1p2k3")[4]);
  CHECK(distortion_terms("none") == std::array<bool, LensCoefficients::kCount>{});
  for (const char* const bad : {"", "k7", "k1k1", "k", "K1", "k1,k2"}) {
    CHECK_THROWS_AS(distortion_terms(bad), std::invalid_argument);
  }
}
