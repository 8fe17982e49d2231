// SPDX-License-Identifier: Apache-2.0
// Errors of the host library, by what a caller can do about them. The program's exit status follows from the type.
#pragma once

#include <stdexcept>
#include <string>

namespace horopter {

enum class ExitStatus { done = 0, check_failed = 1, usage = 2, bad_file = 3, fault = 4 };

class Error : public std::runtime_error {
 public:
  Error(ExitStatus status, const std::string& message) : std::runtime_error(message), status_(status) {}
  ExitStatus status() const { return status_; }

 private:
  ExitStatus status_;
};

/// Arguments that make no sense, whatever the files say.
class UsageError : public Error {
 public:
  explicit UsageError(const std::string& message) : Error(ExitStatus::usage, message) {}
};

/// An input file is missing or bad. The message names the file, the place in it (may be empty), what stands there and
/// what was expected.
class FileError : public Error {
 public:
  FileError(const std::string& file, const std::string& place, const std::string& found, const std::string& expected)
      : Error(ExitStatus::bad_file, file + ": " + (place.empty() ? "" : place + ": ") + found +
                                        (expected.empty() ? "" : "; expected " + expected)),
        file_(file) {}
  const std::string& file() const { return file_; }

 private:
  std::string file_;
};

/// The device or engine does not answer as it must.
class DeviceError : public Error {
 public:
  explicit DeviceError(const std::string& message) : Error(ExitStatus::fault, message) {}
};

}  // namespace horopter
