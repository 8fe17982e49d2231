// SPDX-License-Identifier: Apache-2.0
// gst: any pipeline of GStreamer that ends in raw video. What comes is made grey.
#include <fmt/format.h>
#include <gst/app/gstappsink.h>
#include <gst/gst.h>
#include <gst/video/video.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <span>
#include <string>
#include <utility>

#include "camera/grabbers.hpp"
#include "camera/succession.hpp"
#include "horopter/base/error.hpp"
#include "horopter/image/image.hpp"

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

struct UnrefCaps {
  void operator()(GstCaps* caps) const { gst_caps_unref(caps); }
};
using CapsPtr = std::unique_ptr<GstCaps, UnrefCaps>;

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

/// Looks at what comes before decoders see it: they make up what is missing. What is not whole they do not get, nor what
/// tells only the difference to something that is missing.
class PacketWatch {
 public:
  PacketWatch() = default;
  PacketWatch(const PacketWatch&) = delete;
  PacketWatch& operator=(const PacketWatch&) = delete;
  /// From now on, and until the pipeline stands still. Also decoders that are made later.
  void watch(GstElement* pipeline) {
    g_signal_connect(pipeline, "deep-element-added", G_CALLBACK(&PacketWatch::on_added), this);
    GstIterator* elements = gst_bin_iterate_recurse(GST_BIN(pipeline));
    gst_iterator_foreach(elements, &PacketWatch::on_found, this);
    gst_iterator_free(elements);
  }
  std::uint64_t lost() const { return lost_; }

 private:
  /// What one decoder gets, or what comes from parts without one.
  struct Stream {
    PacketWatch* watch;
    bool takes_jpeg;
    Succession succession;

    bool counts(GstBuffer* buffer) {
      const auto has = [&](GstBufferFlags flag) { return GST_BUFFER_FLAG_IS_SET(buffer, flag); };
      return succession.counts({.gap = has(GST_BUFFER_FLAG_DISCONT),
                                .difference = has(GST_BUFFER_FLAG_DELTA_UNIT),
                                .damaged = has(GST_BUFFER_FLAG_CORRUPTED),
                                .head = has(GST_BUFFER_FLAG_HEADER)});
    }
  };

  static void on_added(GstBin* /*pipeline*/, GstBin* /*bin*/, GstElement* element, PacketWatch* self) {
    self->watch_element(element);
  }
  static void on_found(const GValue* element, void* self) {
    static_cast<PacketWatch*>(self)->watch_element(GST_ELEMENT(g_value_get_object(element)));
  }
  void watch_element(GstElement* element) {
    GstElementFactory* factory = gst_element_get_factory(element);
    if (GST_IS_BIN(element) || factory == nullptr) return;
    const auto is = [&](GstElementFactoryListType type) {
      return gst_element_factory_list_is_type(factory, type) == TRUE;
    };
    if (is(GST_ELEMENT_FACTORY_TYPE_DECODER)) gst_element_foreach_sink_pad(element, &PacketWatch::watch_taken, this);
    if (is(GST_ELEMENT_FACTORY_TYPE_DEPAYLOADER)) {
      gst_element_foreach_src_pad(element, &PacketWatch::watch_joined, this);
    }
  }
  static void watch_pad(GstPad* pad, GstPadProbeCallback on, Stream stream) {
    gst_pad_add_probe(pad, GST_PAD_PROBE_TYPE_BUFFER, on, new Stream(stream),
                      [](void* of_pad) { delete static_cast<Stream*>(of_pad); });
  }
  static gboolean watch_joined(GstElement* /*element*/, GstPad* pad, void* self) {
    watch_pad(pad, &PacketWatch::on_joined,
              {.watch = static_cast<PacketWatch*>(self), .takes_jpeg = false, .succession = {}});
    return TRUE;
  }
  static gboolean watch_taken(GstElement* /*element*/, GstPad* pad, void* self) {
    const CapsPtr takes(gst_pad_get_pad_template_caps(pad)), jpeg(gst_caps_new_empty_simple("image/jpeg"));
    watch_pad(pad, &PacketWatch::on_buffer,
              {.watch = static_cast<PacketWatch*>(self),
               .takes_jpeg = gst_caps_can_intersect(takes.get(), jpeg.get()) == TRUE,
               .succession = {}});
    return TRUE;
  }

  static std::string kind_of(GstPad* pad) {
    const CapsPtr caps(gst_pad_get_current_caps(pad));
    return caps ? gst_structure_get_name(gst_caps_get_structure(caps.get(), 0)) : "";
  }
  static GstPadProbeReturn on_buffer(GstPad* pad, GstPadProbeInfo* info, void* of_pad) {
    auto* stream = static_cast<Stream*>(of_pad);
    GstBuffer* buffer = GST_PAD_PROBE_INFO_BUFFER(info);
    const std::string kind = kind_of(pad);
    if (kind.starts_with("audio/")) return GST_PAD_PROBE_OK;
    const bool is_jpeg = stream->takes_jpeg && (kind.empty() || kind == "image/jpeg");
    const bool alone = kind.starts_with("image/");  // whatever its encoder says: that of PNG calls each a difference
    const bool good = is_jpeg ? is_whole(buffer)
                      : alone ? !GST_BUFFER_FLAG_IS_SET(buffer, GST_BUFFER_FLAG_CORRUPTED)
                              : stream->counts(buffer);
    if (good) return GST_PAD_PROBE_OK;
    if (is_jpeg && is_piece(pad, buffer)) {
      GstElement* decoder = gst_pad_get_parent_element(pad);
      GST_ELEMENT_ERROR(decoder, STREAM, FORMAT, ("JPEG comes in pieces, not image by image (jpegparse joins them)"),
                        (nullptr));
      gst_object_unref(decoder);
    }
    ++stream->watch->lost_;
    return GST_PAD_PROBE_DROP;
  }
  /// Raw images that were joined from parts: where one is missing there is what was in the memory before.
  static GstPadProbeReturn on_joined(GstPad* pad, GstPadProbeInfo* info, void* of_pad) {
    auto* stream = static_cast<Stream*>(of_pad);
    if (kind_of(pad) != "video/x-raw" || stream->counts(GST_PAD_PROBE_INFO_BUFFER(info))) return GST_PAD_PROBE_OK;
    ++stream->watch->lost_;
    return GST_PAD_PROBE_DROP;
  }
  static bool is_whole(GstBuffer* buffer) {
    GstMapInfo map;
    if (GST_BUFFER_FLAG_IS_SET(buffer, GST_BUFFER_FLAG_CORRUPTED) ||
        gst_buffer_map(buffer, &map, GST_MAP_READ) == FALSE) {
      return false;
    }
    bool whole = true;
    try {
      check_jpeg_packet(std::span(map.data, map.size), "image");
    } catch (const std::exception&) {
      whole = false;
    }
    gst_buffer_unmap(buffer, &map);
    return whole;
  }
  /// Of a stream that is cut anywhere. What has times comes image by image.
  static bool is_piece(GstPad* pad, GstBuffer* buffer) {
    GstEvent* event = gst_pad_get_sticky_event(pad, GST_EVENT_SEGMENT, 0);
    if (event == nullptr) return false;
    const GstSegment* segment = nullptr;
    gst_event_parse_segment(event, &segment);
    const bool timed = segment->format == GST_FORMAT_TIME;
    gst_event_unref(event);
    constexpr std::array<std::uint8_t, 2> kBegin{0xFF, 0xD8};
    return !timed && gst_buffer_memcmp(buffer, 0, kBegin.data(), kBegin.size()) != 0;
  }

  std::atomic<std::uint64_t> lost_ = 0;
};

class GstGrabber : public Grabber {
 public:
  GstGrabber(const std::string& description, bool counts) : counts_(counts) {
    GError* error = nullptr;
    pipeline_.reset(gst_parse_launch((description + kSink).c_str(), &error));
    if (pipeline_ == nullptr || error != nullptr) throw CameraError("GStreamer: " + take_text(error));
    if (!GST_IS_PIPELINE(pipeline_.get())) throw CameraError("GStreamer: this is no pipeline");
    sink_.reset(gst_bin_get_by_name(GST_BIN(pipeline_.get()), "horopter"));
    if (sink_ == nullptr) throw CameraError("GStreamer: the pipeline has a sink of its own");
    packets_.watch(pipeline_.get());
    start();
  }
  std::optional<CameraFrame> next(std::chrono::milliseconds patience) override {
    const auto wait = static_cast<GstClockTime>(std::chrono::nanoseconds(patience).count());
    const SamplePtr sample(gst_app_sink_try_pull_sample(GST_APP_SINK(sink_.get()), wait));
    const auto arrived = Clock::now();
    if (sample != nullptr) return frame_of(*sample, arrived);
    if (lost() != told_) return broken(arrived);
    check_bus();
    return std::nullopt;
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
    GstBus* bus = gst_element_get_bus(pipeline_.get());
    // The reason may come a moment behind the state.
    GstMessage* reason = gst_bus_timed_pop_filtered(bus, GST_SECOND, GST_MESSAGE_ERROR);
    gst_object_unref(bus);
    if (reason == nullptr) throw CameraError("GStreamer: " + otherwise);
    const std::string problem = problem_in(*reason);
    gst_message_unref(reason);
    throw CameraError("GStreamer: " + problem);
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

  std::uint64_t lost() const { return packets_.lost() + broken_; }

  /// Parts of an image were lost: it is none.
  CameraFrame broken(Clock::time_point arrived) {
    CameraFrame frame;
    frame.arrived = arrived;
    frame.taken = arrived.time_since_epoch();
    frame.lost_packets = told_ = lost();
    return frame;
  }

  CameraFrame frame_of(GstSample& sample, Clock::time_point arrived) {
    GstVideoInfo info;
    GstVideoFrame video;
    GstBuffer* buffer = gst_sample_get_buffer(&sample);
    if (buffer == nullptr || gst_video_info_from_caps(&info, gst_sample_get_caps(&sample)) == FALSE) {
      throw CameraError("GStreamer: an image that cannot be read");
    }
    if (GST_BUFFER_FLAG_IS_SET(buffer, GST_BUFFER_FLAG_CORRUPTED) ||
        gst_video_frame_map(&video, &info, buffer, GST_MAP_READ) == FALSE) {
      ++broken_;
      return broken(arrived);
    }
    CameraFrame frame;
    frame.lost_packets = told_ = lost();
    frame.image = Image(GST_VIDEO_FRAME_WIDTH(&video), GST_VIDEO_FRAME_HEIGHT(&video));
    const auto* pixels = static_cast<const std::uint8_t*>(GST_VIDEO_FRAME_PLANE_DATA(&video, 0));
    const std::ptrdiff_t stride = GST_VIDEO_FRAME_PLANE_STRIDE(&video, 0);
    for (int y = 0; y < frame.image.height; ++y) {
      std::copy_n(pixels + y * stride, frame.image.width, &frame.image.at(0, y));
    }
    gst_video_frame_unmap(&video);
    frame.arrived = arrived;
    const GstClockTime running =
        gst_segment_to_running_time(gst_sample_get_segment(&sample), GST_FORMAT_TIME, GST_BUFFER_PTS(buffer));
    // When it came is no time at which it was taken: it may have been held back.
    if (!GST_CLOCK_TIME_IS_VALID(running)) {
      throw CameraError(
          "GStreamer: its images have no times; expected a pipeline that gives them, as with do-timestamp=true");
    }
    frame.taken = nanoseconds_of(base_ + running);
    frame.taken_here = Clock::time_point(frame.taken);
    if (counts_ && GST_BUFFER_OFFSET_IS_VALID(buffer)) frame.number = GST_BUFFER_OFFSET(buffer);
    return frame;
  }

  bool counts_;
  GstClockTime base_ = 0;
  PacketWatch packets_;       // before the pipeline, which tells it
  std::uint64_t broken_ = 0;  ///< that came as raw video
  std::uint64_t told_ = 0;
  PipelinePtr pipeline_;
  ElementPtr sink_;
};

void start_gstreamer() {
  static std::once_flag once;
  std::call_once(once, [] {
    if (gst_init_check(nullptr, nullptr, nullptr) == FALSE) throw CameraError("GStreamer cannot be started");
  });
}

/// As devices offer it: 15/2, and 30000/1001 where people say 29.97.
std::string as_fraction(double frames_per_s) {
  constexpr double kClose = 2e-4;
  const double whole = std::round(frames_per_s);
  if (std::abs(frames_per_s * 1.001 - whole) < kClose * whole) {
    return fmt::format("{}/1001", std::lround(whole * 1000));
  }
  int numerator = 0, denominator = 1;
  gst_util_double_to_fraction(frames_per_s, &numerator, &denominator);
  return fmt::format("{}/{}", numerator, denominator);
}

}  // namespace

std::unique_ptr<Grabber> open_gst(const std::string& place, const CameraSettings& /*settings*/) {
  start_gstreamer();
  return std::make_unique<GstGrabber>(place, false);
}

std::string v4l2_pipeline(const std::string& device, double frames_per_s) {
  // Raw video at this rate if the device has it; else JPEG, as most cameras give their fast rates.
  return fmt::format(
      "v4l2src device={0} ! capsfilter caps=video/x-raw,framerate={1};image/jpeg,framerate={1} ! decodebin", device,
      as_fraction(frames_per_s));
}

std::unique_ptr<Grabber> open_v4l2(const std::string& place, const CameraSettings& settings) {
  start_gstreamer();
  return std::make_unique<GstGrabber>(v4l2_pipeline(place, settings.frames_per_s), true);
}

}  // namespace horopter::monitor
