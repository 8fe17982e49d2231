// SPDX-License-Identifier: Apache-2.0
// What a calibration found, how well, and what is wrong with it: as text, as JSON and as a picture.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "horopter/calib/points.hpp"
#include "horopter/calib/rig.hpp"

namespace horopter::calib {

struct ViewReport {
  std::string camera;
  std::string file;
  int view = 0;        ///< index of the pose of the target, as the caller numbered it
  bool found = false;  ///< the target was found
  bool used = false;   ///< its points took part in the last optimisation
  double rms_px = 0;
  std::string problem;  ///< why it was not found or not used
};

struct CameraReport {
  std::string name;
  std::vector<Parameter> parameters;
  double rms_px = 0;
  std::vector<Eigen::Vector2d> pixels;     ///< measured points that were used
  std::vector<Eigen::Vector2d> residuals;  ///< measured minus predicted, px
};

struct Report {
  std::string method;
  bool usable = false;
  std::vector<std::string> problems;  ///< why it is not usable
  std::vector<std::string> warnings;
  Rig rig;
  std::vector<CameraReport> cameras;
  PointErrors errors;                   ///< over the points used, all cameras
  std::optional<PointErrors> withheld;  ///< over points that took no part
  std::vector<Parameter> relative;      ///< pose of the second camera in the first's coordinates
  std::optional<double> baseline_mm;
  double baseline_sd_mm = 0;  ///< not finite: not determined
  std::vector<ViewReport> views;
  int iterations = 0;
  double seconds = 0;
};

/// Report of one or more cameras calibrated from points, each on its own in one world.
Report report_of(std::span<const PointCalibration> cameras);

/// Errors of several cameras as one.
PointErrors merge(std::span<const PointErrors> errors);

nlohmann::json to_json(const Report& report);
std::string to_text(const Report& report);

/// Residuals as vectors over the images, cameras side by side, with a scale. 8-bit BGR.
cv::Mat residual_picture(const Report& report);

}  // namespace horopter::calib
