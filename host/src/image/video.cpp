// SPDX-License-Identifier: Apache-2.0
#include "video.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/display.h>
#include <libswscale/swscale.h>
}

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <opencv2/core.hpp>
#include <span>
#include <string_view>
#include <utility>

#include "horopter/base/error.hpp"
#include "horopter/image/mat.hpp"

namespace horopter {
namespace {

template <auto kFree>
struct Free {
  template <typename T>
  void operator()(T* object) const {
    kFree(&object);
  }
};
using FormatPtr = std::unique_ptr<AVFormatContext, Free<avformat_close_input>>;
using CodecPtr = std::unique_ptr<AVCodecContext, Free<avcodec_free_context>>;
using PacketPtr = std::unique_ptr<AVPacket, Free<av_packet_free>>;
using FramePtr = std::unique_ptr<AVFrame, Free<av_frame_free>>;

constexpr std::int64_t kMostPixels = std::int64_t{1} << 26;

std::string words(int error) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(error, text.data(), text.size());
  return text.data();
}

/// Hears what FFmpeg says of errors where it calls none: of a slice whose checksum is wrong, for instance, it shows the one
/// before.
class Listening {
 public:
  /// Keeps the first words. What `not_from` says does not count.
  Listening(std::string& words, const void* not_from) : words_(words), not_from_(not_from) { now = this; }
  ~Listening() { now = nullptr; }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;

  static void on_message(void* from, int level, const char* format, std::va_list arguments) {
    if (level > AV_LOG_ERROR || !now || !now->words_.empty() || from == now->not_from_) return;
    std::array<char, 200> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    std::string_view words = text.data();
    while (!words.empty() && std::isspace(static_cast<unsigned char>(words.back())) != 0) words.remove_suffix(1);
    now->words_ = words;
  }

 private:
  static thread_local Listening* now;
  std::string& words_;
  const void* not_from_;
};
thread_local Listening* Listening::now = nullptr;

/// As viewers show it: quarter turns, clockwise.
std::optional<cv::RotateFlags> turn_of(const AVStream& stream) {
  const auto* matrix =
      reinterpret_cast<const std::int32_t*>(av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, nullptr));
  if (!matrix) return std::nullopt;
  switch ((360 - static_cast<int>(std::lround(av_display_rotation_get(matrix)))) % 360) {
    case 90:
      return cv::ROTATE_90_CLOCKWISE;
    case 180:
      return cv::ROTATE_180;
    case 270:
      return cv::ROTATE_90_COUNTERCLOCKWISE;
    default:
      return std::nullopt;
  }
}

}  // namespace

struct Video::Decoder {
  explicit Decoder(std::string path) : name(std::move(path)), packet(av_packet_alloc()), frame(av_frame_alloc()) {
    av_log_set_callback(&Listening::on_message);  // what is wrong is said here, once
    open_file();
    open_codec();
  }
  ~Decoder() { sws_freeContext(to_bgr); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  void open_file() {
    AVFormatContext* opened = avformat_alloc_context();
    constexpr int kRecognised = AV_EF_CRCCHECK | AV_EF_BITSTREAM | AV_EF_BUFFER | AV_EF_EXPLODE;
    opened->error_recognition = kRecognised;
    int result = avformat_open_input(&opened, ("file:" + name).c_str(), nullptr, nullptr);
    if (result == 0) {
      file.reset(opened);
      result = find_streams();
    }
    if (result < 0) refuse(words(result));
  }

  /// Decodes the first images.
  int find_streams() {
    std::vector<AVDictionary*> options(file->nb_streams, nullptr);
    for (AVDictionary*& of_stream : options) av_dict_set_int(&of_stream, "max_pixels", kMostPixels, 0);
    const int result = avformat_find_stream_info(file.get(), options.data());
    for (AVDictionary*& of_stream : options) av_dict_free(&of_stream);
    return result;
  }

  void open_codec() {
    const AVCodec* type = nullptr;
    const int best = av_find_best_stream(file.get(), AVMEDIA_TYPE_VIDEO, -1, -1, &type, 0);
    if (best < 0) refuse(words(best));
    stream = file->streams[best];
    codec.reset(avcodec_alloc_context3(type));
    codec->max_pixels = kMostPixels;
    codec->pkt_timebase = stream->time_base;
    if (type->id != AV_CODEC_ID_MJPEG) codec->err_recognition = file->error_recognition;
    int result = avcodec_parameters_to_context(codec.get(), stream->codecpar);
    if (result >= 0) result = avcodec_open2(codec.get(), type, nullptr);
    if (result < 0) refuse(words(result));
    turn = turn_of(*stream);
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw FileError(name, "", fmt::format("the video cannot be decoded ({})", why),
                    "a video that this build of FFmpeg reads");
  }
  [[noreturn]] void damaged(const std::string& how) const {
    throw FileError(frame_name(), "", fmt::format("the video is truncated or damaged ({})", how), "whole images");
  }
  std::string frame_name() const { return fmt::format("{}#{}", name, index); }

  /// Whether there is an image in `frame`.
  bool decode() {
    // JPEG images are looked at more closely, and much that the decoder says of them is about what else is in the file.
    const Listening listening(said, codec->codec_id == AV_CODEC_ID_MJPEG ? codec.get() : nullptr);
    int result = avcodec_receive_frame(codec.get(), frame.get());
    for (; result == AVERROR(EAGAIN); result = avcodec_receive_frame(codec.get(), frame.get())) send_packet();
    if (!said.empty()) damaged(said);
    if (result == AVERROR_EOF) return false;
    if (result < 0) damaged(words(result));
    if (frame->decode_error_flags != 0 || (frame->flags & AV_FRAME_FLAG_CORRUPT) != 0)
      damaged("parts of it are made up");
    return true;
  }

  void send_packet() {
    int result = 0;
    do {
      av_packet_unref(packet.get());
      result = av_read_frame(file.get(), packet.get());
    } while (result >= 0 && packet->stream_index != stream->index);
    if (result == AVERROR_EOF && (!file->pb || file->pb->error == 0)) {
      result = avcodec_send_packet(codec.get(), nullptr);
    } else if (result >= 0) {
      if ((packet->flags & AV_PKT_FLAG_CORRUPT) != 0) damaged("a packet is not whole");
      if ((packet->flags & AV_PKT_FLAG_DISCARD) != 0) ++left_out;
      if (codec->codec_id == AV_CODEC_ID_MJPEG) {
        check_jpeg_packet(std::span(packet->data, static_cast<std::size_t>(packet->size)), frame_name());
      }
      result = avcodec_send_packet(codec.get(), packet.get());
    }
    if (result < 0) damaged(words(result));
  }

  Image grey() {
    const int width = frame->width, height = frame->height;
    to_bgr = sws_getCachedContext(to_bgr, width, height, static_cast<AVPixelFormat>(frame->format), width, height,
                                  AV_PIX_FMT_BGR24, SWS_BICUBIC, nullptr, nullptr, nullptr);
    const FramePtr bgr(av_frame_alloc());  // with the padding of rows that swscale may write to
    bgr->width = width;
    bgr->height = height;
    bgr->format = AV_PIX_FMT_BGR24;
    if (!to_bgr || av_frame_get_buffer(bgr.get(), 0) < 0 ||
        sws_scale(to_bgr, frame->data, frame->linesize, 0, height, bgr->data, bgr->linesize) != height) {
      damaged("its pixels cannot be read");
    }
    cv::Mat colour(height, width, CV_8UC3, bgr->data[0], static_cast<std::size_t>(bgr->linesize[0]));
    if (turn) cv::rotate(colour.clone(), colour, *turn);
    return grey_image(colour);
  }

  /// Of the image in `frame`.
  std::optional<VideoTime> time() {
    const AVRational rate = av_guess_frame_rate(file.get(), stream, frame.get());
    if (frame->best_effort_timestamp == AV_NOPTS_VALUE || rate.num <= 0 || rate.den <= 0) return std::nullopt;
    const double time_s = static_cast<double>(frame->best_effort_timestamp) * av_q2d(stream->time_base);
    if (!first_s) first_s = last_s = time_s;
    const double period_s = 1 / av_q2d(rate);
    const double missing = std::clamp(std::round((time_s - *last_s) / period_s) - 1, 0.0, 1e9);
    last_s = time_s;
    return VideoTime{index, time_s - *first_s, period_s, static_cast<std::size_t>(missing)};
  }

  std::string name;
  FormatPtr file;
  AVStream* stream = nullptr;
  CodecPtr codec;
  PacketPtr packet;
  FramePtr frame;
  SwsContext* to_bgr = nullptr;
  std::optional<cv::RotateFlags> turn;
  std::string said;
  std::size_t index = 0;
  std::optional<double> first_s, last_s;
  std::size_t left_out = 0;  ///< images that the file announces and tells viewers not to show
};

Video::Video(std::string path) : decoder_(std::make_unique<Decoder>(std::move(path))) {}
Video::~Video() = default;

std::optional<std::size_t> Video::count() const {
  const auto frames = decoder_->stream->nb_frames;
  return frames > 0 ? std::optional(static_cast<std::size_t>(frames)) : std::nullopt;
}

std::vector<std::string> Video::warnings() const {
  constexpr auto kTellDamage =
      std::to_array<AVCodecID>({AV_CODEC_ID_MJPEG, AV_CODEC_ID_PNG, AV_CODEC_ID_RAWVIDEO, AV_CODEC_ID_H264,
                                AV_CODEC_ID_MPEG4, AV_CODEC_ID_MPEG2VIDEO, AV_CODEC_ID_MPEG1VIDEO});
  const AVCodecID id = decoder_->codec->codec_id;
  if (std::ranges::find(kTellDamage, id) != kTellDamage.end()) return {};
  return {fmt::format(
      "{}: damage in a video of this kind, {}, is hardly ever noticed; its decoder makes up what is missing",
      decoder_->name, avcodec_get_name(id))};
}

std::optional<NamedImage> Video::next() {
  Decoder& d = *decoder_;
  if (!d.decode()) {
    if (d.index == 0) throw FileError(d.name, "", "the video holds no image", "at least one frame");
    if (const auto announced = count(); announced && d.index + d.left_out < *announced) {
      throw FileError(d.name, fmt::format("frame {}", d.index), "the video is truncated or damaged",
                      fmt::format("{} frames", *announced));
    }
    return std::nullopt;
  }
  NamedImage image{d.frame_name(), d.grey(), d.time()};
  ++d.index;
  return image;
}

}  // namespace horopter
