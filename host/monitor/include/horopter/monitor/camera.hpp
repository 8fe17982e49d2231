// SPDX-License-Identifier: Apache-2.0
// Cameras by the name of their source. Each has a thread of its own, which opens it, and opens it again when it is lost.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "horopter/monitor/cell.hpp"
#include "horopter/monitor/pairing.hpp"

namespace horopter::monitor {

/// A camera cannot be opened, or gives nothing any more.
class CameraError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An open source of images. Used by one thread.
class Grabber {
 public:
  virtual ~Grabber() = default;
  /// The next image; nothing where none came within `patience`. Throws CameraError.
  virtual std::optional<CameraFrame> next(std::chrono::milliseconds patience) = 0;
  /// There will be no more images, and that is in order: the last file was shown.
  [[nodiscard]] virtual bool ended() const { return false; }
};

struct CameraSettings {
  CameraCell camera;
  double frames_per_s = 25;
  Stamps stamps = Stamps::arrival;
  std::string directory;      ///< of cell.yaml: what files: names is beside it
  Clock::time_point begin{};  ///< files: of the first image, for both cameras
};

/// Throws CameraError, and FileError for a file that is missing or bad.
std::unique_ptr<Grabber> open_grabber(const CameraSettings& settings);

/// What a source may be, for help and errors.
std::string source_help();
/// Empty for a source that can be tried.
std::string source_problem(const std::string& source);
/// A camera with GenICam features, a trigger and a serial number.
bool is_genicam(const std::string& source);

/// Told of what the cameras do, by their threads.
class CameraSink {
 public:
  virtual ~CameraSink() = default;
  virtual void frame(Side side, CameraFrame frame) = 0;
  virtual void connected(Side side) = 0;
  /// Not open, for this reason; it is tried again.
  virtual void lost(Side side, const std::string& why) = 0;
  virtual void ended(Side side) = 0;
};

/// One source with its thread, until it is destroyed.
class Camera {
 public:
  virtual ~Camera() = default;
};
/// `layout` side_by_side: both sides, the left source's image in two.
std::unique_ptr<Camera> start_camera(Side side, Layout layout, CameraSettings settings, CameraSink& sink);

}  // namespace horopter::monitor
