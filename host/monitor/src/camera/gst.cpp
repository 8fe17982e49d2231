// SPDX-License-Identifier: Apache-2.0
// gst: any pipeline of GStreamer that ends in raw video. What comes is made grey.
#include <fmt/format.h>
#include <gst/app/gstappsink.h>
#include <gst/gst.h>
#include <gst/video/video.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "camera/grabbers.hpp"

namespace horopter::monitor {
namespace {

constexpr auto kOpening = std::chrono::seconds(10);
constexpr const char* kSink =
    " ! videoconvert ! video/x-raw,format=GRAY8 ! appsink name=horopter max-buffers=4 enable-last-sample=false";

struct UnrefElement {
  void operator()(GstElement* element) const { gst_object_unref(element); }
};
using ElementPtr = std::unique_ptr<GstElement, UnrefElement>;
/// A pipeline must stand still before it goes, also where it could not be started.
struct StopAndUnref {
  void operator()(GstElement* pipeline) const {
    gst_element_set_state(pipeline, GST_STATE_NULL);
    gst_object_unref(pipeline);
  }
};
using PipelinePtr = std::unique_ptr<GstElement, StopAndUnref>;
struct UnrefSample {
  void operator()(GstSample* sample) const { gst_sample_unref(sample); }
};
using SamplePtr = std::unique_ptr<GstSample, UnrefSample>;

std::string take_text(GError* error) {
  std::string text = error != nullptr ? error->message : "for a reason that it does not tell";
  g_clear_error(&error);
  return text;
}

/// Running times of all pipelines begin here, so that times of two cameras can be compared.
GstClockTime common_base() {
  static const GstClockTime base = [] {
    GstClock* clock = gst_system_clock_obtain();
    const GstClockTime now = gst_clock_get_time(clock);
    gst_object_unref(clock);
    return now;
  }();
  return base;
}

/// The system's monotonic clock is that of Clock.
std::chrono::nanoseconds nanoseconds_of(GstClockTime time) {
  return std::chrono::nanoseconds(static_cast<std::int64_t>(time));
}

class GstGrabber : public Grabber {
 public:
  GstGrabber(const std::string& description, bool counts) : counts_(counts) {
    GError* error = nullptr;
    pipeline_.reset(gst_parse_launch((description + kSink).c_str(), &error));
    if (pipeline_ == nullptr || error != nullptr) throw CameraError("GStreamer: " + take_text(error));
    if (!GST_IS_PIPELINE(pipeline_.get())) throw CameraError("GStreamer: this is no pipeline");
    sink_.reset(gst_bin_get_by_name(GST_BIN(pipeline_.get()), "horopter"));
    if (sink_ == nullptr) throw CameraError("GStreamer: the pipeline has a sink of its own");
    start();
  }
  std::optional<CameraFrame> next(std::chrono::milliseconds patience) override {
    const auto wait = static_cast<GstClockTime>(std::chrono::nanoseconds(patience).count());
    const SamplePtr sample(gst_app_sink_try_pull_sample(GST_APP_SINK(sink_.get()), wait));
    const auto arrived = Clock::now();
    if (sample == nullptr) {
      check_bus();
      return std::nullopt;
    }
    return frame_of(*sample, arrived);
  }

 private:
  void start() {
    GstClock* clock = gst_system_clock_obtain();
    gst_pipeline_use_clock(GST_PIPELINE(pipeline_.get()), clock);
    gst_object_unref(clock);
    gst_element_set_start_time(pipeline_.get(), GST_CLOCK_TIME_NONE);
    base_ = common_base();
    gst_element_set_base_time(pipeline_.get(), base_);
    GstStateChangeReturn state = gst_element_set_state(pipeline_.get(), GST_STATE_PAUSED);
    if (state == GST_STATE_CHANGE_ASYNC) {
      state = gst_element_get_state(pipeline_.get(), nullptr, nullptr,
                                    static_cast<GstClockTime>(std::chrono::nanoseconds(kOpening).count()));
    }
    if (state == GST_STATE_CHANGE_FAILURE) fail_by_bus("it cannot be started");
    if (state == GST_STATE_CHANGE_ASYNC) fail_by_bus("it gives no image");
    // What is live comes when it comes; what is a file must wait for its time.
    const bool live = state == GST_STATE_CHANGE_NO_PREROLL;
    g_object_set(sink_.get(), "sync", live ? FALSE : TRUE, nullptr);
    if (gst_element_set_state(pipeline_.get(), GST_STATE_PLAYING) == GST_STATE_CHANGE_FAILURE) {
      fail_by_bus("it cannot be started");
    }
  }

  [[noreturn]] void fail_by_bus(const std::string& otherwise) {
    check_bus();
    throw CameraError("GStreamer: " + otherwise);
  }

  void check_bus() {
    GstBus* bus = gst_element_get_bus(pipeline_.get());
    std::string problem;
    while (GstMessage* message = gst_bus_pop(bus)) {
      if (problem.empty()) problem = problem_in(*message);
      gst_message_unref(message);
    }
    gst_object_unref(bus);
    if (!problem.empty()) throw CameraError("GStreamer: " + problem);
  }

  static std::string problem_in(GstMessage& message) {
    if (GST_MESSAGE_TYPE(&message) == GST_MESSAGE_EOS) return "the stream has ended";
    if (GST_MESSAGE_TYPE(&message) != GST_MESSAGE_ERROR) return "";
    GError* error = nullptr;
    gst_message_parse_error(&message, &error, nullptr);
    return take_text(error);
  }

  CameraFrame frame_of(GstSample& sample, Clock::time_point arrived) {
    GstVideoInfo info;
    GstVideoFrame video;
    GstBuffer* buffer = gst_sample_get_buffer(&sample);
    if (buffer == nullptr || gst_video_info_from_caps(&info, gst_sample_get_caps(&sample)) == FALSE ||
        gst_video_frame_map(&video, &info, buffer, GST_MAP_READ) == FALSE) {
      throw CameraError("GStreamer: an image that cannot be read");
    }
    CameraFrame frame;
    frame.image = Image(GST_VIDEO_FRAME_WIDTH(&video), GST_VIDEO_FRAME_HEIGHT(&video));
    const auto* pixels = static_cast<const std::uint8_t*>(GST_VIDEO_FRAME_PLANE_DATA(&video, 0));
    const std::ptrdiff_t stride = GST_VIDEO_FRAME_PLANE_STRIDE(&video, 0);
    for (int y = 0; y < frame.image.height; ++y) {
      std::copy_n(pixels + y * stride, frame.image.width, &frame.image.at(0, y));
    }
    gst_video_frame_unmap(&video);
    frame.arrived = arrived;
    frame.taken = arrived.time_since_epoch();
    const GstClockTime running =
        gst_segment_to_running_time(gst_sample_get_segment(&sample), GST_FORMAT_TIME, GST_BUFFER_PTS(buffer));
    if (GST_CLOCK_TIME_IS_VALID(running)) {
      frame.taken = nanoseconds_of(base_ + running);
      frame.taken_here = Clock::time_point(frame.taken);
    }
    if (counts_ && GST_BUFFER_OFFSET_IS_VALID(buffer)) frame.number = GST_BUFFER_OFFSET(buffer);
    return frame;
  }

  bool counts_;
  GstClockTime base_ = 0;
  PipelinePtr pipeline_;
  ElementPtr sink_;
};

void start_gstreamer() {
  static std::once_flag once;
  std::call_once(once, [] {
    if (gst_init_check(nullptr, nullptr, nullptr) == FALSE) throw CameraError("GStreamer cannot be started");
  });
}

}  // namespace

std::unique_ptr<Grabber> open_gst(const std::string& place, const CameraSettings& /*settings*/) {
  start_gstreamer();
  return std::make_unique<GstGrabber>(place, false);
}

std::unique_ptr<Grabber> open_v4l2(const std::string& place, const CameraSettings& settings) {
  start_gstreamer();
  const auto rate = static_cast<int>(std::lround(settings.frames_per_s));
  // Raw video at this rate if the device has it; else JPEG, as most cameras give their fast rates.
  const std::string source = fmt::format(
      "v4l2src device={} ! capsfilter caps=video/x-raw,framerate={}/1;image/jpeg,framerate={}/1 ! decodebin", place,
      rate, rate);
  return std::make_unique<GstGrabber>(source, true);
}

}  // namespace horopter::monitor
