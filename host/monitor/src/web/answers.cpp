// SPDX-License-Identifier: Apache-2.0
#include "answers.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "horopter/base/error.hpp"
#include "horopter/draw/overlay.hpp"
#include "horopter/image/mat.hpp"
#include "horopter/map/map_json.hpp"

namespace horopter::monitor {
namespace {

constexpr int kJpegQuality = 80;
constexpr int kNarrowest = 640;  // small images are enlarged, that numbers can be read
constexpr int kWidest = 1280;

void draw_object(cv::Mat& picture, const ObjectState& object, double factor, bool alarm) {
  const auto place = [&](int value) { return static_cast<int>(std::lround(value * factor)); };
  const cv::Rect box(place(object.x), place(object.y), std::max(2, place(object.width)),
                     std::max(2, place(object.height)));
  const cv::Scalar colour = alarm ? cv::Scalar(40, 40, 230) : cv::Scalar(0, 220, 255);
  cv::rectangle(picture, box, {0, 0, 0}, 5);
  cv::rectangle(picture, box, colour, 3);
  const std::string label = std::to_string(object.id);
  int base = 0;
  constexpr double kSize = 0.8;
  const cv::Size size = cv::getTextSize(label, cv::FONT_HERSHEY_SIMPLEX, kSize, 2, &base);
  const cv::Point corner(std::clamp(box.x, 0, std::max(0, picture.cols - size.width - 12)),
                         std::max(0, box.y - size.height - 12));
  cv::rectangle(picture, corner, corner + cv::Point(size.width + 12, size.height + 12), colour, cv::FILLED);
  cv::putText(picture, label, corner + cv::Point(6, size.height + 5), cv::FONT_HERSHEY_SIMPLEX, kSize,
              alarm ? cv::Scalar(255, 255, 255) : cv::Scalar(0, 0, 0), 2, cv::LINE_AA);
}

std::string jpeg_of(const Moment& moment) {
  if (moment.left.empty()) return {};
  cv::Mat picture;
  if (moment.result.states.empty()) {
    cv::cvtColor(mat_of(moment.left), picture, cv::COLOR_GRAY2BGR);
  } else {
    Picture states = draw_states(moment.left, moment.result);
    picture = cv::Mat(states.height, states.width, CV_8UC3, states.bgr.data()).clone();
  }
  double factor = 1;
  if (picture.cols < kNarrowest) factor = std::ceil(static_cast<double>(kNarrowest) / picture.cols);
  if (picture.cols > kWidest) factor = static_cast<double>(kWidest) / picture.cols;
  if (factor != 1) {
    cv::Mat scaled;
    cv::resize(picture, scaled, {}, factor, factor, factor > 1 ? cv::INTER_NEAREST : cv::INTER_AREA);
    picture = scaled;
  }
  for (const ObjectState& object : moment.status.objects) {
    const auto limit = moment.result.object_limit_pixels;
    draw_object(picture, object, factor, limit > 0 && object.pixels >= limit);
  }
  std::vector<std::uint8_t> bytes;
  if (!cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality})) {
    throw Error(ExitStatus::fault, "a picture cannot be encoded as JPEG");
  }
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::string shown_state(const Status& status, std::optional<double> age_ms, double limit_ms) {
  if (status.alarm) return "alarm";
  const bool fresh = age_ms && *age_ms >= 0 && *age_ms <= limit_ms;
  if (!fresh) return "old";
  return status.safe && status.causes.empty() ? "safe" : "not_safe";
}

Json status_json(const Status& status, std::optional<double> age_ms, double limit_ms) {
  return {{"state", shown_state(status, age_ms, limit_ms)},
          {"age_ms", optional_json(age_ms)},
          {"limit_ms", limit_ms},
          {"frame", status.frame},
          {"restart", restart_text(status.restart)},
          {"restart_by_itself", status.restart_by_itself},
          {"causes", causes_json(status.causes)},
          {"latched", causes_json(status.latched)},
          {"objects", objects_json(status.objects)},
          {"cameras", cameras_json(status.cameras)},
          {"skew_ms", optional_json(status.skew_ms)},
          {"explained", optional_json(status.explained)},
          {"teaching", status.teaching},
          {"taught", status.taught},
          {"table", status.table},
          {"table_crc", crc_text(status.table_crc)},
          {"decision_ms", status.decision_ms}};
}

Json entry_json(const LogEntry& entry) {
  std::string by;
  if (const auto actor = entry.json.find("by"); actor != entry.json.end() && actor->is_object()) {
    by = text_in(*actor, "name");
  }
  return {{"number", entry.number},
          {"time", text_in(entry.json, "time")},
          {"kind", text_in(entry.json, "kind")},
          {"text", text_in(entry.json, "text")},
          {"by", by},
          {"pictures", entry.pictures.size()}};
}

std::shared_ptr<const LivePicture::Made> LivePicture::get(const MomentPtr& latest) {
  const std::lock_guard lock(mutex_);
  if (!latest) return nullptr;
  const auto now = Clock::now();
  const bool fresh = made_ && (made_->arrived == latest->arrived || now - made_at_ < period_);
  if (fresh) return made_;
  auto made = std::make_shared<Made>();
  made->frame = latest->status.frame;
  made->arrived = latest->arrived;
  made->jpeg = jpeg_of(*latest);
  made_at_ = now;
  made_ = made;
  return made_;
}

}  // namespace horopter::monitor
