// SPDX-License-Identifier: Apache-2.0
// Lens maps: inverse of the map, Jacobians against differences, limits of the domain, conversions.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <random>

#include "horopter/calib/camera.hpp"
#include "horopter/calib/error.hpp"
#include "horopter/calib/joint.hpp"

using namespace horopter::calib;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kWidth = 756, kHeight = 581;

TsaiIntrinsics tsai_camera() {
  return {.f_mm = 10, .dx_mm = 0.0113, .dy_mm = 0.011, .sx = 1.02, .cx_px = 380.3, .cy_px = 287.9};
}

/// Cameras of both models, with terms of both signs, whose domain covers the sensor.
std::vector<std::pair<std::string, Intrinsics>> cameras() {
  std::vector<std::pair<std::string, Intrinsics>> list;
  TsaiIntrinsics t = tsai_camera();
  list.emplace_back("pinhole", t);
  for (const double kappa1 : {3e-3, -3e-3, 1e-9, -1e-9, 1e-13, -1e-13, 1e-300}) {
    t = tsai_camera();
    t.kappa1 = kappa1;
    list.emplace_back("kappa1 " + std::to_string(kappa1), t);
  }
  t = tsai_camera();
  t.kappa1 = 2e-3;
  t.kappa2 = -3e-5;
  t.kappa3 = 2e-7;
  list.emplace_back("radial", t);
  for (const double sign : {1.0, -1.0}) {
    t.kappa1 = 2e-3 * sign;
    t.p1 = 3e-4;
    t.p2 = -2e-4 * sign;
    t.s1 = 1e-4;
    t.s2 = -3e-4;
    list.emplace_back("all terms", t);
  }
  BrownConradyIntrinsics b{.fx_px = 900, .fy_px = 910, .cx_px = 380.3, .cy_px = 287.9, .lens = {}};
  for (const double k1 : {-0.28, 0.25}) {
    b.lens = {.k1 = k1};
    list.emplace_back("k1", b);
    b.lens = {.k1 = k1, .k2 = 0.1, .p1 = 1.2e-3, .p2 = -1e-3, .k3 = -0.02};
    list.emplace_back("k1 k2 p1 p2 k3", b);
    b.lens = {.k1 = k1,
              .k2 = 0.1,
              .p1 = 1.2e-3,
              .p2 = -1e-3,
              .k3 = -0.02,
              .k4 = 0.05,
              .k5 = -0.03,
              .k6 = 0.01,
              .s1 = 1e-3,
              .s2 = -2e-3,
              .s3 = 2e-3,
              .s4 = 1e-3};
    list.emplace_back("OpenCV's twelve", b);
  }
  return list;
}

}  // namespace

TEST_CASE("distort after undistort is the identity over the sensor") {
  for (const auto& [name, intrinsics] : cameras()) {
    INFO(name);
    const CameraModel camera(intrinsics);
    double worst = 0, worst_back = 0;
    for (int v = 0; v < kHeight; v += 7) {
      for (int u = 0; u < kWidth; u += 5) {
        const Vector2d pixel(u, v);
        const auto direction = camera.undistort(pixel);
        REQUIRE(direction);
        const auto back = camera.distort(*direction);
        REQUIRE(back);
        worst = std::max(worst, (*back - pixel).norm());
        const auto again = camera.undistort(*back);
        REQUIRE(again);
        worst_back = std::max(worst_back, (*again - *direction).norm() * camera.fx_px());
      }
    }
    CHECK(worst <= 1e-9);
    CHECK(worst_back <= 1e-9);
  }
}

TEST_CASE("many pixels at a time are those of one at a time, to 1e-6 px") {
  for (const auto& [name, intrinsics] : cameras()) {
    CAPTURE(name);
    const CameraModel model(intrinsics);
    for (int y = -60; y < kHeight + 60; y += 20) {
      std::vector<double> xs, ys;
      for (int x = -60; x < kWidth + 60; x += 16) {
        xs.push_back((x - model.cx_px()) / model.fx_px());
        ys.push_back((y - model.cy_px()) / model.fy_px());
      }
      xs.push_back(std::nan(""));
      ys.push_back(0);
      PixelBatch batch;
      model.distort(xs, ys, batch);
      for (std::size_t i = 0; i < xs.size(); ++i) {
        CAPTURE(y, i);
        Matrix2d slope;
        const auto exact = model.distort({xs[i], ys[i]}, &slope);
        REQUIRE(exact.has_value() == !std::isnan(batch.x[i]));
        if (!exact) continue;
        REQUIRE((*exact - Vector2d(batch.x[i], batch.y[i])).norm() < 1e-6);
        Matrix2d found;
        found << batch.xx[i], batch.xy[i], batch.yx[i], batch.yy[i];
        REQUIRE((slope - found).norm() < 1e-4 * slope.norm());
      }
    }
  }
}

TEST_CASE("runs of pixels are those of calls of their own, to the last bit") {
  constexpr std::size_t kRuns = 6;
  for (const auto& [name, intrinsics] : cameras()) {
    const CameraModel model(intrinsics);
    for (int y = -60; y < kHeight + 60; y += 20) {
      std::vector<double> xs, ys;
      // From the middle, where few steps settle, to beyond the border.
      for (std::size_t i = 0; i < kRuns * PixelBatch::kRun; ++i) {
        xs.push_back((9.0 * static_cast<double>(i)) / model.fx_px());
        ys.push_back((y - model.cy_px()) / model.fy_px());
      }
      xs[3] = std::nan("");
      PixelBatch batch;
      model.distort_runs(xs, ys, batch);
      for (std::size_t run = 0; run < xs.size(); run += PixelBatch::kRun) {
        CAPTURE(name, y, run);
        PixelBatch alone;
        model.distort(std::span(xs).subspan(run, PixelBatch::kRun), std::span(ys).subspan(run, PixelBatch::kRun),
                      alone);
        const auto same = [&](const auto& some, const auto& own) {
          return std::memcmp(&some[run], own.data(), PixelBatch::kRun * sizeof(double)) == 0;
        };
        REQUIRE(same(batch.x, alone.x));
        REQUIRE(same(batch.y, alone.y));
        REQUIRE(same(batch.xx, alone.xx));
        REQUIRE(same(batch.xy, alone.xy));
        REQUIRE(same(batch.yx, alone.yx));
        REQUIRE(same(batch.yy, alone.yy));
      }
      PixelBatch none;
      CHECK_THROWS_AS(model.distort_runs(std::span(xs).first(9), std::span(ys).first(9), none), std::invalid_argument);
    }
  }
}

TEST_CASE("Jacobians of undistort and distort agree with differences") {
  for (const auto& [name, intrinsics] : cameras()) {
    INFO(name);
    const CameraModel camera(intrinsics);
    for (const Vector2d& pixel : {Vector2d(20, 30), Vector2d(700, 50), Vector2d(381, 288), Vector2d(100, 550)}) {
      Matrix2d undistort, distort;
      const Vector2d direction = *camera.undistort(pixel, &undistort);
      camera.distort(direction, &distort);
      for (int i = 0; i < 2; ++i) {
        const Vector2d step = Vector2d::Unit(i) * 1e-3;
        const Vector2d by_pixel = (*camera.undistort(pixel + step) - *camera.undistort(pixel - step)) / 2e-3;
        CHECK((by_pixel - undistort.col(i)).norm() * camera.fx_px() < 1e-6);
        const Vector2d small = Vector2d::Unit(i) * 1e-6;
        const Vector2d by_direction = (*camera.distort(direction + small) - *camera.distort(direction - small)) / 2e-6;
        CHECK((by_direction - distort.col(i)).norm() / camera.fx_px() < 1e-6);
      }
      CHECK((distort * undistort - Matrix2d::Identity()).norm() < 1e-11);
    }
  }
}

TEST_CASE("derivatives of a prediction by every parameter agree with differences") {
  for (const auto& [name, intrinsics] : cameras()) {
    INFO(name);
    Eigen::Matrix<double, 6, 1> rig, view;
    rig << 0.02, -0.1, 0.05, -120, 3, 8;
    view << 0.3, -0.2, 1.4, 30, -20, 1000;
    const Vector3d point(120, -80, 30);
    const auto camera = CameraParameters::from(intrinsics);
    Prediction at;
    REQUIRE(predict(intrinsics, camera, rig, view, point, {300, 300}, at));
    const auto difference = [&](auto& vector, int index, double step) {
      Prediction plus, minus;
      const double keep = vector[index];
      vector[index] = keep + step;
      // NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): the analyzer does not see Eigen's << fill a matrix.
      const bool first = predict(intrinsics, camera, rig, view, point, at.pixel, plus);
      vector[index] = keep - step;
      const bool second = predict(intrinsics, camera, rig, view, point, at.pixel, minus);
      vector[index] = keep;
      REQUIRE((first && second));
      return Vector2d((plus.pixel - minus.pixel) / (2 * step));
    };
    for (int i = 0; i < 6; ++i) {
      const double step = i < 3 ? 1e-6 : 1e-3;
      const Vector2d by_rig = difference(rig, i, step), by_view = difference(view, i, step);
      CHECK((by_rig - at.by_rig_to_camera.col(i)).norm() < 1e-5 * (1 + by_rig.norm()));
      CHECK((by_view - at.by_view.col(i)).norm() < 1e-5 * (1 + by_view.norm()));
    }
    auto& free = const_cast<CameraParameters::Vector&>(camera);
    for (int i = 0; i < CameraParameters::kCount; ++i) {
      const Vector2d numeric = difference(free, i, i < 4 ? 1e-4 : 1e-8);
      CHECK((numeric - at.by_camera.col(i)).norm() < 1e-5 * (1 + numeric.norm()));
    }
  }
}

TEST_CASE("kappa1 < 0 has no inverse beyond its limit radius, and says so") {
  TsaiIntrinsics t = tsai_camera();
  t.kappa1 = -3e-3;
  const CameraModel camera(t);
  const double limit_mm = 2 / (3 * std::sqrt(9e-3));  // of the undistorted radius
  CHECK(camera.lens().limit_radius() == Approx(1 / std::sqrt(9e-3)).epsilon(1e-15));
  CHECK(camera.lens().limit_radius_mapped() == Approx(limit_mm).epsilon(1e-15));
  CHECK(camera.limit_radius_px() == Approx(limit_mm / t.dy_mm));
  const Vector2d along(std::cos(0.7), std::sin(0.7));
  CHECK(camera.distort(along * limit_mm * (1 - 1e-9) / t.f_mm));
  CHECK_FALSE(camera.distort(along * limit_mm * (1 + 1e-9) / t.f_mm));
  CHECK_FALSE(camera.project({1e6, 0, 1}));
  CHECK_FALSE(camera.project({0, 0, -1}));
  CHECK_FALSE(camera.undistort({1e5, 0}));
  CHECK_FALSE(camera.undistort({NAN, 0}));
  CHECK_FALSE(camera.distort({NAN, 0}));
  t.kappa1 = 3e-3;
  CHECK(std::isinf(CameraModel(t).limit_radius_px()));
  CHECK(CameraModel(t).distort({1e6, 1e6}));
}

TEST_CASE("the inverse of all terms exists up to the guaranteed radius, and never lies outside the disc") {
  std::mt19937_64 random(20260101);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    LensCoefficients c;
    c.k1 = 0.5 * uniform(random);
    c.k2 = 0.3 * uniform(random);
    c.k3 = 0.1 * uniform(random);
    c.p1 = 0.02 * uniform(random);
    c.p2 = 0.02 * uniform(random);
    c.s1 = 0.02 * uniform(random);
    c.s3 = 0.02 * uniform(random);
    if (trial % 2 == 0) c.k4 = 0.3 * uniform(random), c.s2 = 0.01 * uniform(random);
    const LensMap map(c);
    INFO("trial " << trial << ", limit " << map.limit_radius() << " -> " << map.limit_radius_mapped());
    REQUIRE(map.limit_radius() > 0.3);
    const double radius = std::min(map.limit_radius_mapped(), 3.0);
    for (int i = 0; i < 50; ++i) {
      const Vector2d value = Vector2d::Random() * radius / std::sqrt(2.0) * 0.999;
      const auto point = map.inverse(value);
      REQUIRE(point);
      CHECK(point->norm() <= map.limit_radius());
      CHECK((lens_forward(c, *point) - value).norm() < 1e-12);
      // Far beyond, either an inverse inside the disc or none; never another branch.
      const Vector2d far = Vector2d::Random() * 10;
      if (const auto inverse = map.inverse(far)) {
        CHECK(inverse->norm() <= map.limit_radius());
        CHECK((lens_forward(c, *inverse) - far).norm() < 1e-10 * (1 + far.norm()));
      }
    }
    // Inside the disc the inverse of the map is the point itself.
    for (int i = 0; i < 50; ++i) {
      const Vector2d point = Vector2d::Random() * std::min(map.limit_radius() * 0.99, 3.0) / std::sqrt(2.0);
      const auto back = map.inverse(*map.forward(point));
      REQUIRE(back);
      CHECK((*back - point).norm() < 1e-9);
    }
  }
}

TEST_CASE("a limit is where the map turns back") {
  // 1 + 3 k1 r² + 5 k2 r⁴ = 0 at r² = 0.5 and r² = 2
  const LensMap map(LensCoefficients{.k1 = -2.5 / 3, .k2 = 1.0 / 5});
  CHECK(map.limit_radius() == Approx(std::sqrt(0.5)).epsilon(1e-14));
  CHECK(std::isinf(LensMap(LensCoefficients{.k1 = -0.2887, .k2 = 0.0936}).limit_radius()));
}

TEST_CASE("lens models convert into each other, and the residual says how well") {
  TsaiIntrinsics t = tsai_camera();
  t.kappa1 = 2e-3;
  const Conversion brown = to_brown_conrady(CameraModel(t), kWidth, kHeight);
  CHECK(brown.rms_px < 0.02);
  CHECK(brown.largest_px < 0.2);
  CHECK(std::get<BrownConradyIntrinsics>(brown.intrinsics).lens.k1 < 0);  // the opposite sign of OpenCV
  const Conversion back = to_tsai(CameraModel(brown.intrinsics), kWidth, kHeight, t.dx_mm, t.dy_mm);
  CHECK(back.rms_px < 0.02);
  CHECK(std::get<TsaiIntrinsics>(back.intrinsics).sx == Approx(t.sx));
  CHECK(std::get<TsaiIntrinsics>(back.intrinsics).kappa1 == Approx(2e-3).epsilon(0.01));
  const CameraModel a(t), b(brown.intrinsics);
  double worst = 0;
  for (int v = 0; v < kHeight; v += 20) {
    for (int u = 0; u < kWidth; u += 20) {
      worst = std::max(worst, (*b.distort(*a.undistort({u, v})) - Vector2d(u, v)).norm());
    }
  }
  CHECK(worst <= brown.largest_px * 1.05);
  t.kappa1 = -0.03;
  CHECK_THROWS_AS(to_brown_conrady(CameraModel(t), kWidth, kHeight), CalibrationError);
}

TEST_CASE("poses and rotation vectors") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 100; ++i) {
    const Vector3d vector = Vector3d::Random() * 1.7;
    CHECK((rotation_to_vector(rotation_from_vector(vector)) - vector).norm() < 1e-12);
  }
  const Pose pose{rotation_from_vector({0.1, 0.2, -0.3}), {1, 2, 3}};
  CHECK(((pose * pose.inverse()).rotation - Eigen::Matrix3d::Identity()).norm() < 1e-15);
  CHECK((pose * pose.centre()).norm() < 1e-14);
}
