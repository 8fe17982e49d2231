// SPDX-License-Identifier: Apache-2.0
// Errors of the host library, by what a caller can do about them. The program's exit status follows from the type.
#pragma once

#include <exception>
#include <stdexcept>
#include <string>

#include "horopter/calib/error.hpp"

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

/// An input file is missing or bad.
using calib::FileError;

/// The device or engine does not answer as it must.
class DeviceError : public Error {
 public:
  explicit DeviceError(const std::string& message) : Error(ExitStatus::fault, message) {}
};
/// The device does what it does after a reset, whatever was set before.
class ResetError : public DeviceError {
 public:
  using DeviceError::DeviceError;
};

/// The program's exit status after an error of any type.
inline ExitStatus status_of(const std::exception& error) {
  if (const auto* ours = dynamic_cast<const Error*>(&error)) return ours->status();
  return dynamic_cast<const FileError*>(&error) != nullptr ? ExitStatus::bad_file : ExitStatus::fault;
}

}  // namespace horopter
