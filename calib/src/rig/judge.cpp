// SPDX-License-Identifier: Apache-2.0
#include "rig/judge.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace horopter::calib::detail {
namespace {

/// The largest residual of a usable rig: px, or a share of the width of the image, whichever is more.
constexpr double kLargestRmsPx = 1.5;
constexpr double kLargestRmsShare = 0.002;
/// From here on a rig is usable, and said to fit poorly: of the disparity of 0.7 px that a skin tolerates (D95), the rig
/// alone takes most.
constexpr double kPoorRmsPx = 0.5;
/// Share of f, and of the width for the image centre, to which they must be known.
constexpr double kFocalShare = 0.05;
constexpr double kCentreShare = 0.05;

}  // namespace

// Conditions are written so that a NaN is a problem.

std::string focal_problem(const std::string& name, double f_px, double f_sd_px) {
  if (f_sd_px < kFocalShare * f_px) return "";
  return fmt::format(
      "{}: f and the distance of the target cannot be told apart (f = {:.0f} ± {:.0f} px): its plane is too nearly "
      "parallel to the image in all views, or its points too near to one such plane; tilt it by 30 degrees or so, in "
      "different directions",
      name, f_px, f_sd_px);
}

void judge_intrinsics(const Camera& camera, double f_sd_px, double centre_sd_px, Report& report) {
  const std::string focal = focal_problem(camera.name, camera.model.fy_px(), f_sd_px);
  if (!focal.empty()) {
    report.problems.push_back(focal);
  } else if (!(centre_sd_px < kCentreShare * camera.width_px)) {
    report.problems.push_back(
        fmt::format("{}: the image centre is known to {:.0f} px only: more views, tilted in different directions, or "
                    "more points",
                    camera.name, centre_sd_px));
  }
}

void judge_fit(const std::string& what, double rms_px, int width_px, const std::string& advice, Report& report) {
  if (rms_px < kPoorRmsPx) return;
  const std::string found = fmt::format("RMS {:.2f} px; {}", rms_px, advice);
  if (rms_px < std::max(kLargestRmsPx, kLargestRmsShare * width_px)) {
    report.warnings.push_back(fmt::format("poor_fit: {} fit poorly: {}", what, found));
  } else {
    report.problems.push_back(fmt::format("{} do not fit: {}", what, found));
  }
}

}  // namespace horopter::calib::detail
