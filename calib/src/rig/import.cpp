// SPDX-License-Identifier: Apache-2.0
// Rigs as other programs write them: OpenCV, ROS, Kalibr.
#include "rig/import.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <fstream>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <optional>
#include <sstream>

#include "horopter/calib/error.hpp"

namespace horopter::calib::import {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Names by place, whatever the file calls them: what reads a rig looks for left and right.
std::string camera_name(std::size_t index, std::size_t count) {
  if (count == 1) return "camera";
  return index == 0 ? "left" : index == 1 ? "right" : fmt::format("camera{}", index);
}

void check_size(const Source& source, const std::string& where, double width, double height) {
  const auto good = [](double value) { return value >= 1 && value <= 1e6 && value == std::floor(value); };
  if (!good(width) || !good(height)) {
    throw FileError(source.file, where, fmt::format("{:g} x {:g}", width, height), "the image size in pixels");
  }
}

// --- OpenCV ---

struct Storage {
  const Source* source;
  cv::FileStorage storage;
};

struct Entry {
  const Source* source;
  std::string key;
  cv::FileNode node;
};

/// The first of the keys that is there, in any of the files.
std::optional<Entry> find(const std::vector<Storage>& files, const std::vector<std::string>& keys) {
  for (const std::string& key : keys) {
    for (const Storage& file : files) {
      const cv::FileNode node = file.storage[key];
      if (!node.empty()) return Entry{file.source, key, node};
    }
  }
  return std::nullopt;
}

std::vector<double> values_of(const Entry& entry) {
  try {
    cv::Mat matrix;
    if (entry.node.isSeq()) {
      std::vector<double> list;
      for (const auto& item : entry.node) {
        if (!item.isInt() && !item.isReal()) throw FileError(entry.source->file, entry.key, "not numbers", "numbers");
        list.push_back(static_cast<double>(item));
      }
      return list;
    }
    entry.node >> matrix;
    matrix.convertTo(matrix, CV_64F);
    if (matrix.channels() != 1) throw FileError(entry.source->file, entry.key, "several channels", "a matrix");
    if (!matrix.isContinuous()) matrix = matrix.clone();
    const auto* const data = matrix.ptr<double>();
    return {data, data + matrix.total()};
  } catch (const cv::Exception&) {
    throw FileError(entry.source->file, entry.key, "not a matrix", "a matrix of numbers");
  }
}

Matrix3d matrix_of(const Entry& entry) {
  const auto values = values_of(entry);
  if (values.size() != 9) {
    throw FileError(entry.source->file, entry.key, fmt::format("{} numbers", values.size()), "a 3x3 matrix");
  }
  for (const double value : values) {
    if (!std::isfinite(value)) throw FileError(entry.source->file, entry.key, "not finite", "numbers");
  }
  return matrix3(values);
}

/// Keys of the second or first of two cameras, or of a single one (index 0).
std::vector<std::string> keys_of(const std::vector<std::string>& stems, int index) {
  std::vector<std::string> keys;
  for (const std::string& stem : stems) {
    if (index == 0) {
      keys.push_back(stem);
    } else {
      keys.push_back(stem + std::to_string(index));
      keys.push_back(stem + "_" + std::to_string(index));
      keys.push_back(stem + (index == 1 ? "_left" : "_right"));
      keys.push_back((index == 1 ? "left_" : "right_") + stem);
    }
  }
  return keys;
}

const std::vector<std::string> kMatrixKeys{"M", "K", "camera_matrix", "cameraMatrix", "CameraMatrix", "CM"};
const std::vector<std::string> kDistortionKeys{
    "D", "distortion_coefficients", "distCoeffs", "dist_coeffs", "DistCoeffs", "distortion"};

Camera opencv_camera(const std::vector<Storage>& files, int index, std::vector<std::string>& warnings) {
  const auto matrix = find(files, keys_of(kMatrixKeys, index));
  const auto distortion = find(files, keys_of(kDistortionKeys, index));
  Camera camera;
  if (!matrix) {
    throw FileError(files.front().source->file, "", fmt::format("no camera matrix M{0} (K{0}, cameraMatrix{0})", index),
                    "the matrices of both cameras");
  }
  LensCoefficients lens;
  if (distortion) {
    lens = opencv_distortion(*distortion->source, distortion->key, values_of(*distortion));
  } else {
    warnings.push_back(
        fmt::format("no_distortion: {}: no distortion coefficients beside {}", matrix->source->file, matrix->key));
  }
  camera.model = opencv_model(*matrix->source, matrix->key, matrix_of(*matrix), lens, warnings);
  return camera;
}

}  // namespace

std::string read_text(const std::filesystem::path& file, const std::string& expected) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) throw FileError(file.string(), "", "this is a directory", expected);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileError(file.string(), "", "the file is missing or cannot be read", expected);
  std::ostringstream text;
  text << stream.rdbuf();
  if (text.str().empty()) throw FileError(file.string(), "", "the file is empty", expected);
  return text.str();
}

RigFile read_opencv(const std::vector<Source>& sources, const ImportOptions& options) {
  std::vector<Storage> files;
  for (const Source& source : sources) {
    std::string text = source.text;
    if (text.find("!!opencv-matrix") != std::string::npos && text.compare(0, 5, "%YAML") != 0) {
      text.insert(0, "%YAML:1.0\n---\n");
    }
    try {
      files.push_back({&source, cv::FileStorage(text, cv::FileStorage::READ | cv::FileStorage::MEMORY)});
    } catch (const cv::Exception& error) {
      throw FileError(source.file, "", "OpenCV cannot read it (" + std::string(error.err) + ")",
                      "a complete file of OpenCV's FileStorage");
    }
    if (!files.back().storage.isOpened()) {
      throw FileError(source.file, "", "OpenCV cannot read it", "a complete file of OpenCV's FileStorage");
    }
  }
  if (const auto fisheye = find(files, {"fisheye_model"}); fisheye && static_cast<int>(fisheye->node) != 0) {
    throw FileError(fisheye->source->file, "fisheye_model", "a fisheye lens", "OpenCV's usual lens model");
  }
  RigFile result;
  result.format = "OpenCV";
  const bool pair =
      find(files, keys_of(kMatrixKeys, 1)).has_value() || find(files, keys_of(kMatrixKeys, 2)).has_value();
  if (pair) {
    result.rig.cameras = {opencv_camera(files, 1, result.warnings), opencv_camera(files, 2, result.warnings)};
    const auto r = find(files, {"R", "Rotation", "rotation", "rotation_matrix"});
    const auto t = find(files, {"T", "Translation", "translation", "translation_vector"});
    if (!r || !t) {
      throw FileError(sources.front().file, "", r ? "no T" : "no R",
                      "R and T from the first camera to the second (often in a second file, extrinsics.yml)");
    }
    const auto values = values_of(*r);
    Pose& pose = result.rig.cameras[1].world_to_camera;
    pose.rotation = values.size() == 3 ? rotation_from_vector({values[0], values[1], values[2]})
                                       : rotation(*r->source, r->key, matrix_of(*r));
    const auto translation = values_of(*t);
    if (translation.size() != 3) {
      throw FileError(t->source->file, t->key, fmt::format("{} numbers", translation.size()), "three numbers");
    }
    pose.translation_mm = options.opencv_unit_mm * Vector3d(translation[0], translation[1], translation[2]);
    if (!pose.translation_mm.allFinite() || !pose.rotation.allFinite()) {
      throw FileError(t->source->file, t->key, "not finite", "numbers");
    }
  } else {
    if (sources.size() > 1) {
      throw FileError(sources[1].file, "", "no camera matrices M1, M2", "the files of one stereo calibration");
    }
    result.rig.cameras = {opencv_camera(files, 0, result.warnings)};
  }
  double width = 0, height = 0;
  const auto w = find(files, {"image_width", "image_Width", "imageWidth", "width"});
  const auto h = find(files, {"image_height", "image_Height", "imageHeight", "height"});
  if (w && h) {
    width = static_cast<double>(w->node);
    height = static_cast<double>(h->node);
    check_size(*w->source, w->key, width, height);
  } else if (const auto size = find(files, {"image_size", "imageSize", "size"})) {
    const auto values = values_of(*size);
    if (values.size() != 2) throw FileError(size->source->file, size->key, "not two numbers", "width, height");
    width = values[0];
    height = values[1];
    check_size(*size->source, size->key, width, height);
  }
  for (std::size_t i = 0; i < result.rig.cameras.size(); ++i) {
    result.rig.cameras[i].name = camera_name(i, result.rig.cameras.size());
    result.rig.cameras[i].width_px = static_cast<int>(width);
    result.rig.cameras[i].height_px = static_cast<int>(height);
  }
  result.rig.world = "camera " + result.rig.cameras.front().name;
  return result;
}

// --- ROS ---

RigFile read_ros(const std::vector<Source>& sources, const std::vector<YAML::Node>& roots) {
  struct Info {
    Camera camera;
    Matrix3d rectification = Matrix3d::Identity();
    std::optional<Vector3d> translation_m;  ///< of the rectified camera
  };
  RigFile result;
  result.format = "ROS camera_info";
  if (sources.size() > 2) throw FileError(sources[2].file, "", "a third camera_info", "the files of one stereo pair");
  std::vector<Info> infos;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const Source& source = sources[i];
    const YAML::Node& root = roots[i];
    Info info;
    // As files of camera_calibration_parsers, or as printed messages of ROS 1 (K) and ROS 2 (k).
    const auto matrix = [&](const char* file_key, const std::string& message_key, std::size_t count,
                            bool required) -> std::vector<double> {
      if (const YAML::Node node = root[file_key]; node.IsDefined()) {
        return numbers(source, member(source, node, "data", "rows, cols, data"), std::string(file_key) + ".data",
                       count);
      }
      for (const std::string& key : {message_key, std::string(1, static_cast<char>(std::tolower(message_key[0])))}) {
        if (const YAML::Node node = root[key]; node.IsDefined()) return numbers(source, node, key, count);
      }
      if (required) throw FileError(source.file, "", fmt::format("no {}", file_key), "a ROS camera_info");
      return {};
    };
    const auto size = [&](const char* file_key, const char* message_key) {
      const YAML::Node node = root[file_key].IsDefined() ? root[file_key] : member(source, root, message_key, "pixels");
      return number(source, node, file_key);
    };
    const double width = size("image_width", "width"), height = size("image_height", "height");
    check_size(source, "image_width", width, height);
    info.camera.width_px = static_cast<int>(width);
    info.camera.height_px = static_cast<int>(height);
    for (const char* const key : {"binning_x", "binning_y"}) {
      if (root[key].IsDefined() && number(source, root[key], key) > 1) {
        fail(source, root[key], key, "a binned image", "a calibration of the full image");
      }
    }
    const YAML::Node kind = root["distortion_model"];
    const std::string name = kind.IsDefined() && kind.IsScalar() ? kind.Scalar() : "plumb_bob";
    std::size_t terms = 5;
    if (name == "rational_polynomial") {
      terms = 8;
    } else if (name != "plumb_bob" && !name.empty()) {
      fail(source, kind, "distortion_model", "'" + name + "'", "plumb_bob or rational_polynomial");
    }
    const auto distortion = matrix("distortion_coefficients", "D", 0, true);
    if (distortion.size() > terms && name == "plumb_bob") {
      throw FileError(source.file, "distortion_coefficients", fmt::format("{} coefficients", distortion.size()),
                      "5 for plumb_bob");
    }
    info.camera.model = opencv_model(source, "camera_matrix", matrix3(matrix("camera_matrix", "K", 9, true)),
                                     opencv_distortion(source, "distortion_coefficients", distortion), result.warnings);
    if (const auto r = matrix("rectification_matrix", "R", 9, false); !r.empty()) {
      info.rectification = rotation(source, "rectification_matrix", matrix3(r));
    }
    if (const auto p = matrix("projection_matrix", "P", 12, false); !p.empty()) {
      if (!(p[0] > 0 && p[5] > 0)) throw FileError(source.file, "projection_matrix", "no focal length", "P of ROS");
      info.translation_m = Vector3d(p[3] / p[0], p[7] / p[5], 0);
    }
    infos.push_back(std::move(info));
  }
  if (infos.size() == 2) {
    const auto &first_m = infos[0].translation_m, &second_m = infos[1].translation_m;
    if (!first_m || !second_m) {
      throw FileError(sources[first_m ? 1 : 0].file, "", "no projection_matrix",
                      "the baseline in P[3] of the right camera");
    }
    const Vector3d between_m = *second_m - *first_m;
    if (!(between_m.norm() > 0)) {
      throw FileError(sources[1].file, "projection_matrix", "P[3] is 0",
                      "the baseline: a stereo calibration, the left camera first");
    }
    const Matrix3d back = infos[1].rectification.transpose();
    infos[1].camera.world_to_camera = {back * infos[0].rectification, 1000 * (back * between_m)};
    if (second_m->norm() < first_m->norm()) {
      result.warnings.push_back(fmt::format(
          "left_right_exchanged: {}: the first file holds the baseline, as right cameras do", sources[0].file));
    }
  }
  for (std::size_t i = 0; i < infos.size(); ++i) {
    infos[i].camera.name = camera_name(i, infos.size());
    result.rig.cameras.push_back(std::move(infos[i].camera));
  }
  result.rig.world = "camera " + result.rig.cameras.front().name;
  return result;
}

// --- Kalibr ---

RigFile read_kalibr(const Source& source, const YAML::Node& root) {
  RigFile result;
  result.format = "Kalibr camchain";
  std::size_t count = 0;
  while (root["cam" + std::to_string(count)].IsDefined()) ++count;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string key = "cam" + std::to_string(i);
    const YAML::Node node = root[key];
    Camera camera;
    camera.name = camera_name(i, count);
    const YAML::Node kind = member(source, node, "camera_model", "pinhole");
    if (!kind.IsScalar() || kind.Scalar() != "pinhole") {
      fail(source, kind, key + ": camera_model", kind.IsScalar() ? "'" + kind.Scalar() + "'" : "not a text", "pinhole");
    }
    const auto k = numbers(source, member(source, node, "intrinsics", "[fu, fv, pu, pv]"), key + ": intrinsics", 4);
    const YAML::Node distortion = member(source, node, "distortion_model", "radtan or none");
    const std::string name = distortion.IsScalar() ? distortion.Scalar() : "";
    LensCoefficients lens;
    if (name == "radtan") {
      const auto d = numbers(source, member(source, node, "distortion_coeffs", "[k1, k2, p1, p2]"),
                             key + ": distortion_coeffs", 4);
      lens = opencv_distortion(source, key + ": distortion_coeffs", d);
    } else if (name != "none") {
      fail(source, distortion, key + ": distortion_model", "'" + name + "'", "radtan or none");
    }
    camera.model = model(source, key + ": intrinsics", BrownConradyIntrinsics{k[0], k[1], k[2], k[3], lens});
    const auto size = numbers(source, member(source, node, "resolution", "[width, height]"), key + ": resolution", 2);
    check_size(source, key + ": resolution", size[0], size[1]);
    camera.width_px = static_cast<int>(size[0]);
    camera.height_px = static_cast<int>(size[1]);
    if (i > 0) {
      const std::string what = key + ": T_cn_cnm1";
      const YAML::Node t = member(source, node, "T_cn_cnm1", "4x4, from the camera before, in m");
      const auto m = numbers(source, t, what, 16);
      if (m[12] != 0 || m[13] != 0 || m[14] != 0 || std::abs(m[15] - 1) > 1e-9) {
        fail(source, t, what, "the last row is not 0 0 0 1", "a rigid transformation");
      }
      const Pose step{rotation(source, what, matrix3({m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]})),
                      1000 * Vector3d(m[3], m[7], m[11])};
      camera.world_to_camera = step * result.rig.cameras.back().world_to_camera;
    }
    result.rig.cameras.push_back(std::move(camera));
  }
  result.rig.world = "camera " + result.rig.cameras.front().name;
  return result;
}

}  // namespace horopter::calib::import

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
    file << "R" << to_cv(pose.rotation) << "T" << to_cv(pose.translation_mm);
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
    result.files.push_back({left.name + ".yaml", camera_info(left, cv::Mat::eye(3, 3, CV_64F), p)});
    return result;
  }
  const Exportable right = prepare(rig.cameras[1], result.warnings);
  const Rectification rectified = rectify(rig, left, right);
  result.files.push_back({left.name + ".yaml", camera_info(left, rectified.r1, rectified.p1)});
  result.files.push_back({right.name + ".yaml", camera_info(right, rectified.r2, rectified.p2)});
  return result;
}

}  // namespace horopter::calib
