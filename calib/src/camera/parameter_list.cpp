// SPDX-License-Identifier: Apache-2.0
#include "camera/parameter_list.hpp"

#include <algorithm>
#include <cmath>

namespace horopter::calib::detail {

void append_pose(std::vector<Parameter>& list, const Pose& pose, const Eigen::Matrix<double, 6, 6>& covariance,
                 bool free) {
  static const char* const kAngles[] = {"rx_deg", "ry_deg", "rz_deg"};
  static const char* const kLengths[] = {"tx_mm", "ty_mm", "tz_mm"};
  const Eigen::Vector3d euler_deg = euler_from_rotation_deg(pose.rotation);
  for (int i = 0; i < 3; ++i) {
    list.push_back({kAngles[i], euler_deg[i], std::sqrt(covariance(i, i)) * 180 / M_PI, free});
  }
  for (int i = 0; i < 3; ++i) {
    list.push_back({kLengths[i], pose.translation_mm[i], std::sqrt(covariance(3 + i, 3 + i)), free});
  }
}

double fx_deviation(double f, double scale,
                    const Eigen::Matrix<double, CameraParameters::kCount, CameraParameters::kCount>& covariance) {
  using P = CameraParameters;
  return std::sqrt(std::max(0.0, covariance(P::f, P::f) * scale * scale + covariance(P::scale, P::scale) * f * f +
                                     2 * covariance(P::f, P::scale) * f * scale));
}

}  // namespace horopter::calib::detail
