// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/camera.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "camera/grabbers.hpp"

namespace horopter::monitor {
namespace {

constexpr auto kPatience = std::chrono::milliseconds(100);
constexpr auto kTryAgain = std::chrono::milliseconds(500);

struct Scheme {
  std::string_view name;
  const char* help;
  std::string (*problem)(const std::string& place);
  std::unique_ptr<Grabber> (*open)(const std::string& place, const CameraSettings& settings);
};

std::string missing_place(const std::string& place) { return place.empty() ? "nothing stands behind it" : ""; }

std::string device_problem(const std::string& place) {
  if (place.starts_with("/dev/") && place.find_first_of(" !\"'") == std::string::npos) return "";
  return fmt::format("'{}' is no device, as /dev/video0", place);
}

constexpr auto kSchemes = std::to_array<Scheme>({
    {"files:", "files:PATTERN (images, a directory or a video, at frames_per_s)", missing_place, open_files},
    {"gst:", "gst:PIPELINE (GStreamer, without its sink)", missing_place, open_gst},
    {"v4l2:", "v4l2:DEVICE (as /dev/video0)", device_problem, open_v4l2},
    {"gev:", "gev:CAMERA (GigE Vision or USB3 Vision: serial number, address or id)", missing_place, open_gev},
});

const Scheme* scheme_of(const std::string& source) {
  const auto found = std::ranges::find_if(kSchemes, [&](const Scheme& s) { return source.starts_with(s.name); });
  return found == kSchemes.end() ? nullptr : &*found;
}

/// The left or the right half.
Image half_of(const Image& image, Side side) {
  Image half(image.width / 2, image.height);
  const std::size_t begin = side == Side::left ? 0 : static_cast<std::size_t>(half.width);
  for (int y = 0; y < half.height; ++y) {
    std::ranges::copy(image.row(y).subspan(begin, static_cast<std::size_t>(half.width)), &half.at(0, y));
  }
  return half;
}

class CameraThread : public Camera {
 public:
  CameraThread(Side side, Layout layout, CameraSettings settings, CameraSink& sink)
      : side_(side), layout_(layout), settings_(std::move(settings)), sink_(sink), thread_([this] { run(); }) {}
  ~CameraThread() override {
    {
      const std::lock_guard lock(mutex_);
      stopped_ = true;
    }
    wake_.notify_all();
    thread_.join();
  }
  CameraThread(const CameraThread&) = delete;
  CameraThread& operator=(const CameraThread&) = delete;

 private:
  bool stopped() {
    const std::lock_guard lock(mutex_);
    return stopped_;
  }

  template <class Tell>
  void tell(const Tell& to) {
    to(side_);
    if (layout_ == Layout::side_by_side) to(other(side_));
  }

  void give(CameraFrame frame) {
    if (layout_ == Layout::single) {
      sink_.frame(side_, std::move(frame));
      return;
    }
    if (frame.image.width % 2 != 0) throw CameraError("an image of odd width does not hold two beside each other");
    CameraFrame right = frame;
    right.image = half_of(frame.image, Side::right);
    frame.image = half_of(frame.image, Side::left);
    sink_.frame(Side::left, std::move(frame));
    sink_.frame(Side::right, std::move(right));
  }

  /// False: there is nothing more to come.
  bool grab() {
    const auto grabber = open_grabber(settings_);
    tell([&](Side side) { sink_.connected(side); });
    while (!stopped()) {
      if (auto frame = grabber->next(kPatience)) give(std::move(*frame));
      if (grabber->ended()) {
        tell([&](Side side) { sink_.ended(side); });
        return false;
      }
    }
    return false;
  }

  void run() {
    while (!stopped()) {
      try {
        if (!grab()) return;
      } catch (const std::exception& error) {  // whatever a library throws: the camera is lost, and no more
        tell([&](Side side) { sink_.lost(side, error.what()); });
      }
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, kTryAgain, [this] { return stopped_; });
    }
  }

  Side side_;
  Layout layout_;
  CameraSettings settings_;
  CameraSink& sink_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stopped_ = false;
  std::thread thread_;  // the last: it uses all of the others
};

}  // namespace

std::string source_help() {
  std::string text;
  for (const Scheme& scheme : kSchemes) text += (text.empty() ? "" : "; ") + std::string(scheme.help);
  return text;
}

std::string source_problem(const std::string& source) {
  const Scheme* scheme = scheme_of(source);
  if (scheme == nullptr) return fmt::format("'{}' is no source that this program knows", without_secrets(source));
  return scheme->problem(source.substr(scheme->name.size()));
}

bool is_genicam(const std::string& source) { return source.starts_with("gev:"); }

std::unique_ptr<Grabber> open_grabber(const CameraSettings& settings) {
  const std::string& source = settings.camera.source;
  const Scheme* scheme = scheme_of(source);
  if (scheme == nullptr) throw CameraError(source_problem(source));
  return scheme->open(source.substr(scheme->name.size()), settings);
}

std::unique_ptr<Camera> start_camera(Side side, Layout layout, CameraSettings settings, CameraSink& sink) {
  return std::make_unique<CameraThread>(side, layout, std::move(settings), sink);
}

}  // namespace horopter::monitor
