// SPDX-License-Identifier: Apache-2.0
#include "rig/import.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include "horopter/calib/error.hpp"

namespace horopter::calib::import {

using Eigen::Matrix3d;

std::string camera_name(std::size_t index, std::size_t count) {
  if (count == 1) return "camera";
  return index == 0 ? "left" : index == 1 ? "right" : fmt::format("camera{}", index);
}

void set_size(Camera& camera, const std::string& file, const std::string& where, double width, double height) {
  const auto good = [](double value) { return value >= 1 && value <= 1e6 && value == std::floor(value); };
  if (!good(width) || !good(height)) {
    throw FileError(file, where, fmt::format("{:g} x {:g}", width, height), "the image size in pixels");
  }
  camera.width_px = static_cast<int>(width);
  camera.height_px = static_cast<int>(height);
}

Matrix3d matrix3(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values.data());
}

Matrix3d rotation(const std::string& file, const std::string& where, const Matrix3d& matrix) {
  const double error = (matrix.transpose() * matrix - Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error < 1e-4) || !(matrix.determinant() > 0)) {
    throw FileError(file, where,
                    matrix.determinant() < 0 ? "a mirror" : fmt::format("R·Rᵀ differs from 1 by {:.2g}", error),
                    "a rotation matrix");
  }
  return error < 1e-14 ? matrix : nearest_rotation(matrix);
}

CameraModel model(const std::string& file, const std::string& where, const Intrinsics& intrinsics) {
  // Far beyond what cameras have: numbers of another unit, or none.
  constexpr double kSmallestFocal_px = 1, kLargest = 1e6;
  try {
    CameraModel model(intrinsics);
    const auto lens = model.lens().coefficients().array();
    const bool terms = std::ranges::all_of(lens, [](double term) { return std::abs(term) <= kLargest; });
    const bool focal = std::ranges::all_of(std::array{model.fx_px(), model.fy_px()},
                                           [](double f) { return f >= kSmallestFocal_px && f <= kLargest; });
    const bool centre = std::abs(model.cx_px()) <= kLargest && std::abs(model.cy_px()) <= kLargest;
    if (!terms || !focal || !centre) {
      throw FileError(file, where,
                      fmt::format("a focal length of {:g} x {:g} px, a centre at ({:g}, {:g}) px{}", model.fx_px(),
                                  model.fy_px(), model.cx_px(), model.cy_px(), terms ? "" : ", a term of the lens"),
                      fmt::format("{:g} to {:g} px, within {:g}", kSmallestFocal_px, kLargest, kLargest));
    }
    return model;
  } catch (const std::invalid_argument& error) {
    throw FileError(file, where, error.what(), "");
  }
}

LensCoefficients opencv_distortion(const std::string& file, const std::string& where,
                                   const std::vector<double>& values) {
  static const std::set<std::size_t> kLengths{0, 1, 2, 4, 5, 8, 12, 14};
  if (!kLengths.contains(values.size())) {
    throw FileError(file, where, fmt::format("{} coefficients", values.size()), "4, 5, 8, 12 or 14");
  }
  std::array<double, LensCoefficients::kCount> terms{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) throw FileError(file, where, "a coefficient is not finite", "numbers");
    if (i < terms.size()) {
      terms[i] = values[i];
    } else if (values[i] != 0) {
      throw FileError(file, where, "a tilted sensor (tauX, tauY)", "a model without tilt");
    }
  }
  return LensCoefficients::from(terms);
}

CameraModel opencv_model(const std::string& file, const std::string& where, const Matrix3d& k,
                         const LensCoefficients& lens, std::vector<std::string>& warnings) {
  if (std::abs(k(2, 2) - 1) > 1e-9 || k(1, 0) != 0 || k(2, 0) != 0 || k(2, 1) != 0) {
    throw FileError(file, where, "not a camera matrix", "[fx 0 cx; 0 fy cy; 0 0 1]");
  }
  if (k(0, 1) != 0) {
    if (std::abs(k(0, 1)) > 1e-4 * k(0, 0)) {
      throw FileError(file, where, fmt::format("a skew of {:g}", k(0, 1)), "rectangular pixels");
    }
    warnings.push_back(fmt::format("skew_ignored: {}: {}: a skew of {:g}", file, where, k(0, 1)));
  }
  return model(file, where, BrownConradyIntrinsics{k(0, 0), k(1, 1), k(0, 2), k(1, 2), lens});
}

}  // namespace horopter::calib::import
