// SPDX-License-Identifier: Apache-2.0
// Rigs as OpenCV and ROS write them.
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

#include "horopter/calib/error.hpp"
#include "horopter/calib/rig.hpp"

namespace horopter::calib {
namespace {

struct Exportable {
  cv::Mat k, d;
  int width, height;
  std::string name;
  const Camera* camera;
};

Exportable prepare(const Camera& camera, std::vector<std::string>& warnings) {
  const Conversion conversion = to_brown_conrady(camera.model, camera.width_px, camera.height_px);
  if (std::holds_alternative<TsaiIntrinsics>(camera.model.intrinsics())) {
    warnings.push_back(fmt::format("lens_converted: {}: fitted to k1 k2 p1 p2 k3 with {:.4f} px RMS, at most {:.4f} px",
                                   camera.name, conversion.rms_px, conversion.largest_px));
  }
  const auto& brown = std::get<BrownConradyIntrinsics>(conversion.intrinsics);
  const auto values = brown.lens.array();
  int count = 5;
  for (int i = 5; i < LensCoefficients::kCount; ++i) {
    if (values[static_cast<std::size_t>(i)] != 0) count = i < 8 ? 8 : 12;
  }
  Exportable result;
  result.k = (cv::Mat_<double>(3, 3) << brown.fx_px, 0, brown.cx_px, 0, brown.fy_px, brown.cy_px, 0, 0, 1);
  result.d = cv::Mat(1, count, CV_64F);
  for (int i = 0; i < count; ++i) result.d.at<double>(i) = values[static_cast<std::size_t>(i)];
  result.width = camera.width_px;
  result.height = camera.height_px;
  result.name = camera.name;
  result.camera = &camera;
  return result;
}

struct Rectification {
  cv::Mat r, t_mm, r1, r2, p1, p2, q;
};

cv::Mat to_cv(const Eigen::MatrixXd& matrix) {
  cv::Mat result(static_cast<int>(matrix.rows()), static_cast<int>(matrix.cols()), CV_64F);
  for (int row = 0; row < result.rows; ++row) {
    for (int column = 0; column < result.cols; ++column) result.at<double>(row, column) = matrix(row, column);
  }
  return result;
}

Rectification rectify(const Rig& rig, const Exportable& left, const Exportable& right) {
  if (left.width < 1 || left.width != right.width || left.height != right.height) {
    throw CalibrationError("rectification needs images of one known size");
  }
  Rectification result;
  const Pose pose = rig.between(0, 1);
  result.r = to_cv(pose.rotation);
  result.t_mm = to_cv(pose.translation_mm);
  cv::stereoRectify(left.k, left.d, right.k, right.d, {left.width, left.height}, result.r, result.t_mm, result.r1,
                    result.r2, result.p1, result.p2, result.q, cv::CALIB_ZERO_DISPARITY, 0);
  return result;
}

void check_count(const Rig& rig, std::vector<std::string>& warnings) {
  if (rig.cameras.empty() || rig.cameras.size() > 2) {
    throw CalibrationError(fmt::format("{} cameras: this format holds one or two", rig.cameras.size()));
  }
  const Pose& first = rig.cameras.front().world_to_camera;
  if (!first.rotation.isIdentity(1e-12) || !first.translation_mm.isZero(1e-9)) {
    warnings.push_back(
        fmt::format("world_lost: this format has no world; camera {} becomes the origin", rig.cameras.front().name));
  }
}

std::string list(const cv::Mat& matrix, int indent, double last_column_factor = 1) {
  std::string text =
      fmt::format("{0:{1}}rows: {2}\n{0:{1}}cols: {3}\n{0:{1}}data: [", "", indent, matrix.rows, matrix.cols);
  for (int row = 0; row < matrix.rows; ++row) {
    for (int column = 0; column < matrix.cols; ++column) {
      const double value = matrix.at<double>(row, column) * (column == 3 ? last_column_factor : 1);
      text += fmt::format("{}{}", row + column > 0 ? ", " : "", value);
    }
  }
  return text + "]\n";
}

std::string camera_info(const Exportable& camera, const cv::Mat& r, const cv::Mat& p_mm) {
  if (camera.d.cols > 8) throw CalibrationError(camera.name + ": ROS has no model with thin prism terms");
  return fmt::format(
      "image_width: {}\nimage_height: {}\ncamera_name: {}\ncamera_matrix:\n{}distortion_model: {}\n"
      "distortion_coefficients:\n{}rectification_matrix:\n{}projection_matrix:\n{}",
      camera.width, camera.height, camera.name, list(camera.k, 2),
      camera.d.cols > 5 ? "rational_polynomial" : "plumb_bob", list(camera.d, 2), list(r, 2), list(p_mm, 2, 1e-3));
}

/// Throws CalibrationError for a name that would lead to another directory, or hide the file.
std::string file_name(const Camera& camera) {
  const std::string& name = camera.name;
  const auto bad = [](char c) { return c == '/' || static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  if (name.starts_with('.') || std::ranges::any_of(name, bad)) {
    throw CalibrationError("camera '" + name +
                           "': ROS's file would have this name; expected one without '/', control characters or a dot "
                           "at its begin");
  }
  return name + ".yaml";
}

}  // namespace

Exported to_opencv(const Rig& rig) {
  Exported result;
  check_count(rig, result.warnings);
  cv::FileStorage file("rig.yml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY | cv::FileStorage::FORMAT_YAML);
  const Exportable left = prepare(rig.cameras[0], result.warnings);
  if (left.width > 0) file << "image_width" << left.width << "image_height" << left.height;
  if (rig.cameras.size() == 1) {
    file << "camera_matrix" << left.k << "distortion_coefficients" << left.d;
  } else {
    const Exportable right = prepare(rig.cameras[1], result.warnings);
    file << "M1" << left.k << "D1" << left.d << "M2" << right.k << "D2" << right.d;
    const Pose pose = rig.between(0, 1);
    file << "R" << to_cv(pose.rotation) << "T" << to_cv(pose.translation_mm) << "length_unit"
         << "mm";
    if (left.width > 0 && left.width == right.width && left.height == right.height) {
      const Rectification rectified = rectify(rig, left, right);
      file << "R1" << rectified.r1 << "R2" << rectified.r2 << "P1" << rectified.p1 << "P2" << rectified.p2 << "Q"
           << rectified.q;
    } else {
      result.warnings.push_back("no_rectification: the images have no common size; R1 R2 P1 P2 Q are left out");
    }
  }
  result.files.push_back({"stereo.yml", file.releaseAndGetString()});
  if (rig.cameras.size() == 1) result.files.back().name = "camera.yml";
  return result;
}

Exported to_ros(const Rig& rig) {
  Exported result;
  check_count(rig, result.warnings);
  const Exportable left = prepare(rig.cameras[0], result.warnings);
  if (left.width < 1) throw CalibrationError("ROS needs the image size");
  if (rig.cameras.size() == 1) {
    cv::Mat p = cv::Mat::zeros(3, 4, CV_64F);
    left.k.copyTo(p.colRange(0, 3));
    result.files.push_back({file_name(rig.cameras[0]), camera_info(left, cv::Mat::eye(3, 3, CV_64F), p)});
    return result;
  }
  const Exportable right = prepare(rig.cameras[1], result.warnings);
  const Rectification rectified = rectify(rig, left, right);
  result.files.push_back({file_name(rig.cameras[0]), camera_info(left, rectified.r1, rectified.p1)});
  result.files.push_back({file_name(rig.cameras[1]), camera_info(right, rectified.r2, rectified.p2)});
  return result;
}

}  // namespace horopter::calib
