// SPDX-License-Identifier: Apache-2.0
// Errors of the calibration library, by what a caller can do about them.
#pragma once

#include <stdexcept>
#include <string>

namespace horopter::calib {

/// The measurements are well formed but do not determine a camera: too few points, points on a line, a plane parallel
/// to the image, a mirrored order. No rig is made then.
class CalibrationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file is missing or bad. The message names the file, the place in it (may be empty), what stands there and what
/// was expected.
class FileError : public std::runtime_error {
 public:
  FileError(const std::string& file, const std::string& place, const std::string& found, const std::string& expected)
      : std::runtime_error(file + ": " + (place.empty() ? "" : place + ": ") + found +
                           (expected.empty() ? "" : "; expected " + expected)),
        file_(file) {}
  const std::string& file() const { return file_; }

 private:
  std::string file_;
};

}  // namespace horopter::calib
