// SPDX-License-Identifier: Apache-2.0
// One camera from points: the published data with its reference results, exact synthetic points, noise against the
// covariance, and bad input.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "horopter/calib/error.hpp"
#include "horopter/calib/points.hpp"
#include "horopter/calib/report.hpp"
#include "host_temporary.hpp"
#include "shared_data.hpp"

using namespace horopter::calib;
using Catch::Contains;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

const Sensor kSensor{756, 581, 0.0113, 0.011, 378, 290, std::nullopt};

Camera camera_at(const Pose& pose, double kappa1 = 1e-3) {
  Camera camera;
  camera.width_px = kSensor.width_px;
  camera.height_px = kSensor.height_px;
  camera.model = CameraModel(TsaiIntrinsics{.f_mm = 10,
                                            .dx_mm = kSensor.dx_mm,
                                            .dy_mm = kSensor.dy_mm,
                                            .sx = 1.01,
                                            .cx_px = 381.5,
                                            .cy_px = 286.2,
                                            .kappa1 = kappa1});
  camera.world_to_camera = pose;
  return camera;
}

/// From above, tilted, z of the world up.
Pose tilted() {
  Eigen::Matrix3d down;
  down << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  return {rotation_from_vector({0.45, 0.1, 0.03}) * down, {-180, 120, 1000}};
}

std::vector<PointPair> seen(const Camera& camera, const std::vector<double>& heights, double noise_px = 0,
                            unsigned seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, noise_px > 0 ? noise_px : 1);
  std::vector<PointPair> points;
  for (const double z : heights) {
    for (int row = 0; row < 7; ++row) {
      for (int column = 0; column < 9; ++column) {
        const Vector3d world(45.0 * column, 45.0 * row, z);
        const auto pixel = camera.project(world);
        REQUIRE(pixel);
        points.push_back({world, *pixel});
        if (noise_px > 0) points.back().pixel += Vector2d(noise(random), noise(random));
      }
    }
  }
  return points;
}

double value(const PointCalibration& result, const std::string& name) {
  for (const Parameter& parameter : result.parameters) {
    if (parameter.name == name) return parameter.value;
  }
  FAIL("no parameter " << name);
  return 0;
}

bool warned(const PointCalibration& result, const std::string& name) {
  for (const std::string& warning : result.warnings) {
    if (warning.starts_with(name + ":")) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("Willson's points: errors, NCE and Tz/f as the reference program finds") {
  struct Reference {
    const char* file;
    PointMethod method;
    double mean, sd, max, nce, tz_over_f;
  };
  const Reference references[] = {
      {"tsai/cc_cd.dat", PointMethod::tsai, 0.1317, 0.0710, 0.3707, 0.3144, 24.411},
      {"tsai/cc_cd.dat", PointMethod::full, 0.0967, 0.0530, 0.2807, 0.2319, 24.437},
      {"tsai/ncc_cd.dat", PointMethod::tsai, 0.0966, 0.0509, 0.2554, 0.2344, 28.556},
      {"tsai/ncc_cd.dat", PointMethod::full, 0.0797, 0.0408, 0.2519, 0.1936, 28.578},
  };
  for (const Reference& reference : references) {
    const auto file = horopter::test::shared_data(reference.file);
    if (!file) return;
    const auto points = read_points(*file);
    const PointCalibration result = calibrate_points(points, {576, 384, 0.023, 0.023, 258, 204, 1.0}, reference.method);
    INFO(reference.file << " " << point_method_name(reference.method));
    CHECK(result.errors.mean_px <= 1.01 * reference.mean);
    CHECK(result.errors.sd_px <= 1.05 * reference.sd);
    CHECK(result.errors.max_px <= 1.05 * reference.max);
    CHECK(result.errors.nce <= 1.01 * reference.nce);
    CHECK(result.errors.nce_thesis == Approx(5 * result.errors.nce));
    CHECK(result.tz_over_f == Approx(reference.tz_over_f).epsilon(1e-3));
  }
}

TEST_CASE("exact points give the camera back") {
  const double kappa1 = GENERATE(1e-3, -1e-3, 0.0);
  const Camera truth = camera_at(tilted(), kappa1);
  const auto points = seen(truth, {0, 50, 100});
  const PointCalibration result = calibrate_points(points, kSensor, PointMethod::full);
  CHECK_FALSE(result.coplanar);
  CHECK(result.errors.max_px < 1e-7);
  CHECK(value(result, "f_mm") == Approx(10).epsilon(1e-8));
  CHECK(value(result, "sx") == Approx(1.01).epsilon(1e-8));
  CHECK(value(result, "cx_px") == Approx(381.5).epsilon(1e-8));
  CHECK(value(result, "kappa1_per_mm2") == Approx(kappa1).margin(1e-10));
  CHECK(value(result, "tz_mm") == Approx(1000).epsilon(1e-8));
}

TEST_CASE("points near the image centre are left out of the first pass alone") {
  const auto points = seen(camera_at(tilted()), {0, 50, 100}, 0.1);
  const auto with = [&](double near_centre) {
    return calibrate_points(points, kSensor, PointMethod::full, {.near_centre = near_centre});
  };
  const PointCalibration all = with(0), usual = with(PointOptions{}.near_centre), none = with(2);
  for (const PointCalibration* result : {&usual, &none}) {
    CHECK(result->errors.count == points.size());
    CHECK(result->errors.rms_px == Approx(all.errors.rms_px).epsilon(1e-6));
    for (const char* name : {"f_mm", "sx", "cx_px", "cy_px", "kappa1_per_mm2", "tz_mm"}) {
      CAPTURE(name);
      CHECK(value(*result, name) == Approx(value(all, name)).epsilon(1e-4));
    }
  }
  // With no point left there is no first pass, and the second has as far to go as the first had.
  CHECK(none.iterations < all.iterations);
  CHECK(usual.iterations > none.iterations);
}

TEST_CASE("one tilted plane, sx given, any plane of the world") {
  Sensor sensor = kSensor;
  sensor.sx = 1.01;
  const Camera truth = camera_at(tilted());
  auto points = seen(truth, {25});
  const PointCalibration flat = calibrate_points(points, sensor, PointMethod::full);
  CHECK(flat.coplanar);
  CHECK(flat.errors.max_px < 1e-6);
  CHECK(value(flat, "f_mm") == Approx(10).epsilon(1e-5));
  CHECK(warned(flat, "one_plane"));
  // The same camera with the world turned: the plane is no longer z = constant.
  const Pose turn{rotation_from_vector({0.9, -0.4, 0.6}), {100, 200, -300}};
  for (PointPair& point : points) point.world_mm = turn * point.world_mm;
  const PointCalibration turned = calibrate_points(points, sensor, PointMethod::full);
  CHECK(turned.coplanar);
  CHECK(turned.errors.max_px < 1e-6);
  CHECK((turned.camera.world_to_camera.centre() - turn * truth.world_to_camera.centre()).norm() < 0.05);
}

TEST_CASE("t_y = 0 does not break Tsai's method") {
  for (const bool coplanar : {true, false}) {
    Pose pose = tilted();
    // The world's origin on the camera's x axis: t_y = 0 exactly.
    pose.translation_mm.y() = 0;
    Sensor sensor = kSensor;
    sensor.sx = 1.01;
    sensor.cx_px = 381.5;
    sensor.cy_px = 286.2;
    const Camera truth = camera_at(pose, 0);
    std::vector<PointPair> points;
    for (PointPair point :
         seen(camera_at(tilted(), 0), coplanar ? std::vector<double>{0} : std::vector<double>{0, 80})) {
      point.world_mm.y() -= 120;
      point.pixel = *truth.project(point.world_mm);
      points.push_back(point);
    }
    const PointCalibration result =
        calibrate_points(points, sensor, PointMethod::tsai, {.centre = CentreSearch::given});
    CHECK(result.errors.max_px < 1e-6);
    CHECK(std::abs(value(result, "ty_mm")) < 1e-6);
  }
}

TEST_CASE("the image centre is found from the radial alignment constraint") {
  const auto points = seen(camera_at(tilted()), {0, 50, 100});
  Sensor sensor = kSensor;
  sensor.cx_px = 360;
  sensor.cy_px = 310;
  const auto centre = search_centre(points, sensor, false);
  REQUIRE(centre);
  CHECK((*centre - Vector2d(381.5, 286.2)).norm() < 1e-3);
}

TEST_CASE("the linear method and the physical parameters of its matrix") {
  const Camera truth = camera_at(tilted(), 0);
  const auto points = seen(truth, {0, 50, 100});
  const PhysicalCamera physical = physical_camera(direct_linear_transform(points));
  CHECK(physical.fx_px == Approx(truth.model.fx_px()).epsilon(1e-8));
  CHECK(physical.fy_px == Approx(truth.model.fy_px()).epsilon(1e-8));
  CHECK(physical.cx_px == Approx(381.5).epsilon(1e-7));
  CHECK(std::abs(physical.skew_px) < 1e-6);
  CHECK((physical.world_to_camera.translation_mm - truth.world_to_camera.translation_mm).norm() < 1e-5);
  const PointCalibration result = calibrate_points(points, kSensor, PointMethod::dlt);
  CHECK(result.errors.max_px < 1e-7);
  CHECK(*result.matrix_rms_px < 1e-7);
}

TEST_CASE("NCE is 1/0.2 smaller pixels: its definition on a camera that is off by a known amount") {
  Camera camera = camera_at(tilted(), 0);
  auto points = seen(camera, {0, 100});
  // One pixel along y is 1/fy of z; the noise of one pixel has √((1/fx² + 1/fy²)/12) of z.
  for (PointPair& point : points) point.pixel.y() += 1;
  const PointErrors errors = evaluate(camera, points);
  const double fx = camera.model.fx_px(), fy = camera.model.fy_px();
  CHECK(errors.mean_px == Approx(1));
  CHECK(errors.max_px == Approx(1));
  CHECK(errors.nce == Approx(1 / fy / std::sqrt((1 / (fx * fx) + 1 / (fy * fy)) / 12)));
  CHECK(errors.nce_thesis == Approx(errors.nce / 0.2));
}

TEST_CASE("spread of repeated calibrations is what the covariance says, which is the Cramér-Rao bound") {
  const Camera truth = camera_at(tilted());
  constexpr int kTrials = 20;
  constexpr double kNoise = 0.05;
  double f_square = 0, f_sd = 0, cx_square = 0, cx_sd = 0;
  for (unsigned trial = 0; trial < kTrials; ++trial) {
    const PointCalibration result =
        calibrate_points(seen(truth, {0, 50, 100}, kNoise, 100 + trial), kSensor, PointMethod::full);
    for (const Parameter& parameter : result.parameters) {
      if (parameter.name == "f_mm") f_square += std::pow(parameter.value - 10, 2), f_sd += parameter.sd;
      if (parameter.name == "cx_px") cx_square += std::pow(parameter.value - 381.5, 2), cx_sd += parameter.sd;
    }
  }
  // 20 trials know a deviation to 16 %; the bound itself is tested by `horopter study calibration`.
  CHECK(std::sqrt(f_square / kTrials) == Approx(f_sd / kTrials).epsilon(0.5));
  CHECK(std::sqrt(cx_square / kTrials) == Approx(cx_sd / kTrials).epsilon(0.5));
}

TEST_CASE("two cameras from points: the spread of their relative pose is what the report says") {
  const Camera left = camera_at(tilted());
  const Pose relative{rotation_from_vector({0.02, -0.15, 0.01}), {-150, 4, 8}};
  const Camera right = camera_at(relative * tilted());
  constexpr int kTrials = 40;
  double baseline_square = 0, baseline_sd = 0, turn_square = 0, turn_sd = 0;
  for (unsigned trial = 0; trial < kTrials; ++trial) {
    const auto of = [&](const Camera& camera, unsigned seed) {
      return calibrate_points(seen(camera, {0, 50, 100}, 0.05, seed), kSensor, PointMethod::full);
    };
    const Report report = report_of(std::array{of(left, 200 + trial), of(right, 300 + trial)});
    CHECK(report.usable);
    baseline_square += std::pow(*report.baseline_mm - relative.translation_mm.norm(), 2);
    baseline_sd += report.baseline_sd_mm;
    const Parameter& turn = report.relative[1];
    REQUIRE(turn.name == "ry_deg");
    turn_square += std::pow(turn.value - euler_from_rotation_deg(relative.rotation).y(), 2);
    turn_sd += turn.sd;
  }
  // 40 trials know a deviation to 11 %.
  CHECK(std::sqrt(baseline_square / kTrials) == Approx(baseline_sd / kTrials).epsilon(0.35));
  CHECK(std::sqrt(turn_square / kTrials) == Approx(turn_sd / kTrials).epsilon(0.35));
  // Of Tsai's two steps the first does not know how well it knows the pose.
  const auto points = seen(left, {0, 50, 100}, 0.05);
  const auto two_steps = calibrate_points(points, kSensor, PointMethod::tsai);
  CHECK_FALSE(std::isfinite(report_of(std::array{two_steps, two_steps}).baseline_sd_mm));
}

TEST_CASE("points that do not determine a camera are refused by name") {
  const Camera truth = camera_at(tilted());
  const auto good = seen(truth, {0, 100}, 0.05);
  const auto method = GENERATE(PointMethod::tsai, PointMethod::full, PointMethod::dlt);
  const auto refuse = [&](const std::vector<PointPair>& points, const std::string& message) {
    CHECK_THROWS_WITH(calibrate_points(points, kSensor, method), Contains(message));
  };
  refuse({good.begin(), good.begin() + 5}, "too few points");
  refuse({}, "too few points");
  refuse({good.begin(), good.begin() + 9}, "on one line");
  refuse(std::vector<PointPair>(20, good[3]), "same point");
  auto points = good;
  points[17].pixel.x() = NAN;
  refuse(points, "point 18");
  // A mirrored world, and a mirrored image.
  points = good;
  for (PointPair& point : points) point.world_mm.x() = -point.world_mm.x();
  refuse(points, "mirror");
  points = good;
  for (PointPair& point : points) point.pixel.x() = kSensor.width_px - 1 - point.pixel.x();
  refuse(points, "mirror");
  if (method == PointMethod::dlt) {
    refuse(seen(truth, {0}, 0.05), "plane");
    // One of them wrong: the matrix that fits best has no focal length.
    refuse({{{-20, 20, 0}, {300, 220}},
            {{20, 20, 30}, {341.053, 218.947}},
            {{60, 20, 60}, {386.667, 217.778}},
            {{-60, 60, 0}, {260, 180}},
            {{-20, 60, 30}, {298.947, 1876.42}},
            {{20, 60, 60}, {342.222, 173.333}},
            {{60, 60, 0}, {380, 180}}},
           "determine no camera");
  }
}

TEST_CASE("a plane parallel to the image: f and Tz cannot be told apart") {
  Eigen::Matrix3d down;
  down << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  const auto method = GENERATE(PointMethod::tsai, PointMethod::full);
  for (const double tilt_deg : {0.0, 0.05}) {
    for (const double noise : {0.0, 0.05, 0.3}) {
      for (unsigned seed = 1; seed < 6; ++seed) {
        const Pose pose{rotation_from_vector({tilt_deg * M_PI / 180, 0, 0.1}) * down, {-180, 120, 1000}};
        const auto points = seen(camera_at(pose), {0}, noise, seed);
        INFO("tilt " << tilt_deg << " noise " << noise << " seed " << seed);
        CHECK_THROWS_WITH(calibrate_points(points, kSensor, method), Contains("cannot be told apart"));
      }
    }
  }
}

TEST_CASE("a wrong point is named") {
  auto points = seen(camera_at(tilted()), {0, 50, 100}, 0.05);
  points[40].pixel.x() += 4;
  const PointCalibration result = calibrate_points(points, kSensor, PointMethod::full);
  REQUIRE(warned(result, "outlier_points"));
  for (const std::string& warning : result.warnings) {
    if (warning.starts_with("outlier_points")) CHECK_THAT(warning, Contains("number 41 ("));
  }
}

TEST_CASE("files of points and sensors: errors name the line") {
  const horopter::TemporaryDirectory directory;
  const auto file = directory / "points.txt";
  const auto write = [&](const std::string& text) { directory.write("points.txt", text); };
  write("# x y z u v\n1 2 3 4 5\n\n 6,7,8,9,10 # comment\n");
  CHECK(read_points(file).size() == 2);
  write("1 2 3 4 5\n1 2 3 4\n");
  CHECK_THROWS_WITH(read_points(file), Contains("line 2") && Contains("4 numbers"));
  write("1 2 3 4 nan\n");
  CHECK_THROWS_WITH(read_points(file), Contains("line 1") && Contains("not finite"));
  write("1 2 three 4 5\n");
  CHECK_THROWS_WITH(read_points(file), Contains("three"));
  write("");
  CHECK_THROWS_WITH(read_points(file), Contains("no points"));
  CHECK_THROWS_AS(read_points("/nowhere/points.txt"), FileError);
  write("width_px: 756\nheight_px: 581\ndx_mm: 0.0113\ndy_mm: 0.011\ncx_px: 378\ncy_px: 290\n");
  CHECK(read_sensor(file).cy_px == 290);
  CHECK_FALSE(read_sensor(file).sx);
  write("756 581 0.0113 0.011 378 290 1.01\n");
  CHECK(read_sensor(file).sx == 1.01);
  write("width_px: 756\nheight_px: 581\ndx_mm: 0\ndy_mm: 0.011\ncx_px: 378\ncy_px: 290\n");
  CHECK_THROWS_WITH(read_sensor(file), Contains("dx_mm"));
  for (const std::string blank : {"cy_px:", "cy_px: 290\nsx:"}) {
    write("width_px: 756\nheight_px: 581\ndx_mm: 0.0113\ndy_mm: 0.011\ncx_px: 378\n" + blank + "\n");
    CHECK_THROWS_WITH(read_sensor(file), Contains("nothing") && Contains("expected a number"));
  }
  write("width_px: 756\n");
  CHECK_THROWS_WITH(read_sensor(file), Contains("height_px") && Contains("missing"));
}
