// SPDX-License-Identifier: Apache-2.0
// Calibrates a camera from points it has itself projected, with the installed library.
#include <cmath>
#include <cstdio>
#include <horopter/calib/points.hpp>

int main() {
  using namespace horopter::calib;
  const Sensor sensor{640, 480, 0.01, 0.01, 319.5, 239.5, std::nullopt};
  const CameraModel truth(
      TsaiIntrinsics{.f_mm = 8, .dx_mm = 0.01, .dy_mm = 0.01, .cx_px = 322, .cy_px = 236, .kappa1 = 2e-3});
  const Pose pose{rotation_from_vector({2.8, 0.2, 0.1}), {-80, 90, 600}};
  std::vector<PointPair> points;
  for (int i = 0; i < 75; ++i) {
    const Eigen::Vector3d world(40.0 * (i % 5), 40.0 * (i / 5 % 5), 50.0 * (i / 25));
    if (const auto pixel = truth.project(pose * world)) points.push_back({world, *pixel});
  }
  const PointCalibration result = calibrate_points(points, sensor, PointMethod::full);
  const double f_mm = std::get<TsaiIntrinsics>(result.camera.model.intrinsics()).f_mm;
  std::printf("f = %.6f mm, error %.2g px\n", f_mm, result.errors.max_px);
  return std::abs(f_mm - 8) < 1e-4 ? 0 : 1;
}
