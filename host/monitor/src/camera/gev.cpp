// SPDX-License-Identifier: Apache-2.0
// gev: GigE Vision and USB3 Vision cameras, by Aravis.
#include <arv.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "camera/grabbers.hpp"

namespace horopter::monitor {
namespace {

/// Buffers that a camera may fill while the computer is busy.
constexpr unsigned kBuffers = 8;
constexpr double kSilentPeriods = 10;
/// The exposure is asked for that often: each time costs an answer of the camera.
constexpr auto kBetweenExposures = std::chrono::milliseconds(500);

template <class Object>
struct Unref {
  void operator()(Object* object) const { g_object_unref(object); }
};

/// Throws CameraError where a call has left an error behind.
class Check {
 public:
  explicit Check(std::string what) : what_(std::move(what)) {}
  ~Check() { g_clear_error(&error_); }
  Check(const Check&) = delete;
  Check& operator=(const Check&) = delete;
  GError** operator*() { return &error_; }
  void done() const {
    if (error_ != nullptr) throw CameraError(fmt::format("{}: {}", what_, error_->message));
  }

 private:
  std::string what_;
  GError* error_ = nullptr;
};

/// The id of the camera with this serial number or address; the text itself where none is found, which may be an address
/// that does not answer to everybody.
std::string id_of(const std::string& place) {
  static std::mutex one_list;  // of Aravis: to update it frees the texts that another thread reads
  const std::lock_guard lock(one_list);
  arv_update_device_list();
  const auto is = [&](const char* text) { return text != nullptr && place == text; };
  for (unsigned i = 0; i < arv_get_n_devices(); ++i) {
    const char* id = arv_get_device_id(i);
    if (id != nullptr && (is(arv_get_device_serial_nbr(i)) || is(arv_get_device_address(i)) || is(id))) return id;
  }
  return place;
}

class GevGrabber : public Grabber {
 public:
  GevGrabber(const std::string& place, const CameraSettings& settings)
      : stamps_(settings.stamps), silence_(longest_silence(settings)) {
    {
      Check check(fmt::format("no camera '{}'", place));
      camera_.reset(arv_camera_new(id_of(place).c_str(), *check));
      check.done();
      if (camera_ == nullptr) throw CameraError(fmt::format("there is no camera '{}'", place));
    }
    set_up(settings);
    open_stream();
    start();
  }
  ~GevGrabber() override {
    if (camera_ != nullptr && !gone_) arv_camera_stop_acquisition(camera_.get(), nullptr);
    stream_.reset();
  }
  GevGrabber(const GevGrabber&) = delete;
  GevGrabber& operator=(const GevGrabber&) = delete;

  std::optional<CameraFrame> next(std::chrono::milliseconds patience) override {
    const auto give_back = [this](ArvBuffer* used) { arv_stream_push_buffer(stream_.get(), used); };
    const std::unique_ptr<ArvBuffer, decltype(give_back)> buffer(
        arv_stream_timeout_pop_buffer(stream_.get(), static_cast<guint64>(std::chrono::microseconds(patience).count())),
        give_back);
    const auto arrived = Clock::now();
    // A camera that is somebody else's may stream on, and nobody knows what is set in it.
    const bool silent = buffer == nullptr && arrived - heard_ > silence_;
    gone_ = lost_ || silent;
    if (lost_) throw CameraError("the camera is not ours any more: it does not answer, or another program controls it");
    if (silent) throw CameraError("the camera sends no images any more");
    if (buffer == nullptr) return std::nullopt;
    heard_ = arrived;
    return frame_of(buffer.get(), arrived);
  }

 private:
  /// A camera that runs by itself and gives nothing for so long is opened anew; one that waits for a trigger may wait.
  static Duration longest_silence(const CameraSettings& settings) {
    if (!settings.camera.trigger.empty()) return Duration::max();
    return std::max<Duration>(
        std::chrono::seconds(2),
        std::chrono::duration_cast<Duration>(std::chrono::duration<double>(kSilentPeriods / settings.frames_per_s)));
  }

  void set_up(const CameraSettings& settings) {
    ArvCamera* camera = camera_.get();
    {
      Check check("PixelFormat Mono8");
      arv_camera_set_pixel_format(camera, ARV_PIXEL_FORMAT_MONO_8, *check);
      check.done();
    }
    // Before the features: it chooses an edge, which may not be theirs.
    if (!settings.camera.trigger.empty()) {
      Check check(fmt::format("trigger {}", settings.camera.trigger));
      arv_camera_set_trigger(camera, settings.camera.trigger.c_str(), *check);
      check.done();
    }
    for (const auto& [name, value] : settings.camera.features) {
      Check check(fmt::format("feature {} = {}", name, value));
      arv_device_set_features_from_string(arv_camera_get_device(camera), fmt::format("{}={}", name, value).c_str(),
                                          *check);
      check.done();
    }
    if (const char* serial = arv_camera_get_device_serial_number(camera, nullptr)) serial_ = serial;
    if (arv_camera_is_gv_device(camera)) {
      arv_camera_gv_set_stream_options(camera, ARV_GV_STREAM_OPTION_PACKET_SOCKET_DISABLED);
    }
    Check check("size of the images");
    payload_ = arv_camera_get_payload(camera, *check);
    check.done();
  }

  void open_stream() {
    Check check("the stream cannot be opened");
    stream_.reset(arv_camera_create_stream(camera_.get(), nullptr, nullptr, *check));
    check.done();
    if (stream_ == nullptr) throw CameraError("the stream cannot be opened");
    if (ARV_IS_GV_STREAM(stream_.get())) {
      g_object_set(stream_.get(), "socket-buffer", ARV_GV_STREAM_SOCKET_BUFFER_AUTO, "socket-buffer-size", 0, nullptr);
    }
    for (unsigned i = 0; i < kBuffers; ++i) {
      arv_stream_push_buffer(stream_.get(), arv_buffer_new(payload_, nullptr));
    }
    g_signal_connect(arv_camera_get_device(camera_.get()), "control-lost", G_CALLBACK(&GevGrabber::on_lost), this);
  }

  static void on_lost(ArvDevice* /*device*/, GevGrabber* self) { self->lost_ = true; }

  void start() {
    Check check("it cannot be started");
    arv_camera_set_acquisition_mode(camera_.get(), ARV_ACQUISITION_MODE_CONTINUOUS, *check);
    check.done();
    arv_camera_start_acquisition(camera_.get(), *check);
    check.done();
    heard_ = Clock::now();  // to find it took its time
  }

  static std::chrono::nanoseconds nanoseconds_of(guint64 time) {
    return std::chrono::nanoseconds(static_cast<std::int64_t>(time));
  }

  CameraFrame frame_of(ArvBuffer* buffer, Clock::time_point arrived) {
    std::uint64_t missing = 0;
    if (ARV_IS_GV_STREAM(stream_.get())) {
      guint64 resent = 0;
      arv_gv_stream_get_statistics(ARV_GV_STREAM(stream_.get()), &resent, &missing);
    }
    CameraFrame frame;
    frame.number = numbered(arv_buffer_get_frame_id(buffer));
    frame.arrived = arrived;
    // Of its first packet, by the clock that somebody may set.
    const auto first_packet = nanoseconds_of(arv_buffer_get_system_timestamp(buffer));
    const std::chrono::nanoseconds now = std::chrono::system_clock::now().time_since_epoch();
    frame.taken_here = arrived - std::chrono::duration_cast<Duration>(now - first_packet);
    frame.taken = stamps_ == Stamps::camera ? nanoseconds_of(arv_buffer_get_timestamp(buffer)) : first_packet;
    frame.serial = serial_;
    // An image with holes is none.
    if (arv_buffer_get_status(buffer) != ARV_BUFFER_STATUS_SUCCESS) {
      frame.lost_packets = missing + ++broken_;
      return frame;
    }
    std::size_t bytes = 0;
    const auto* pixels = static_cast<const std::uint8_t*>(arv_buffer_get_data(buffer, &bytes));
    const int width = arv_buffer_get_image_width(buffer), height = arv_buffer_get_image_height(buffer);
    const bool mono8 = arv_buffer_get_image_pixel_format(buffer) == ARV_PIXEL_FORMAT_MONO_8;
    if (!mono8 || width <= 0 || height <= 0 || bytes < static_cast<std::size_t>(width) * height) {
      throw CameraError("an image that is not Mono8, or shorter than its size");
    }
    frame.image = Image(width, height);
    std::copy_n(pixels, frame.image.pixels.size(), frame.image.pixels.begin());
    frame.lost_packets = missing + broken_;
    frame.exposure_us = exposure(arrived);
    return frame;
  }

  /// GigE Vision counts from 1 to 65535 and then begins again with 1; some cameras, with 0. Images may be lost there.
  std::uint64_t numbered(std::uint64_t id) {
    constexpr std::uint64_t kLast = 65'535, kFar = kLast / 2;
    if (last_id_ <= kLast && id + kFar < last_id_) rounds_ += id == 0 ? kLast + 1 : kLast;
    last_id_ = id;
    return rounds_ + id;
  }

  std::optional<double> exposure(Clock::time_point now) {
    if (now - exposure_asked_ < kBetweenExposures) return exposure_us_;
    exposure_asked_ = now;
    GError* error = nullptr;
    const double us = arv_camera_get_exposure_time(camera_.get(), &error);
    exposure_us_.reset();
    if (error == nullptr) exposure_us_ = us;
    g_clear_error(&error);
    return exposure_us_;
  }

  Stamps stamps_;
  Duration silence_;
  Clock::time_point heard_{};
  std::unique_ptr<ArvCamera, Unref<ArvCamera>> camera_;
  std::unique_ptr<ArvStream, Unref<ArvStream>> stream_;
  std::string serial_;
  unsigned payload_ = 0;
  std::uint64_t broken_ = 0;  ///< images that came with holes
  std::uint64_t last_id_ = 0, rounds_ = 0;
  std::optional<double> exposure_us_;
  Clock::time_point exposure_asked_{};
  std::atomic<bool> lost_ = false;
  bool gone_ = false;  ///< who asks it waits in vain
};

}  // namespace

std::unique_ptr<Grabber> open_gev(const std::string& place, const CameraSettings& settings) {
  return std::make_unique<GevGrabber>(place, settings);
}

}  // namespace horopter::monitor
