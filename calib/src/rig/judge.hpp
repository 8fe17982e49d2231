// SPDX-License-Identifier: Apache-2.0
// Limits beyond which a calibration is not usable, or poor, from images and from points alike: problems and warnings of its
// report.
#pragma once

#include <string>

#include "horopter/calib/report.hpp"

namespace horopter::calib::detail {

/// Says why f and the distance of the targets are known only together. Empty when f is known.
std::string focal_problem(const std::string& name, double f_px, double f_sd_px);
/// Are f and the image centre known well enough?
void judge_intrinsics(const Camera& camera, double f_sd_px, double centre_sd_px, Report& report);
/// Do the residuals say that `what` fits? `advice` says what may be wrong.
void judge_fit(const std::string& what, double rms_px, int width_px, const std::string& advice, Report& report);

}  // namespace horopter::calib::detail
