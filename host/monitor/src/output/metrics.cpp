// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/metrics.hpp"

#include <fmt/format.h>

#include <string_view>

namespace horopter::monitor {
namespace {

class Text {
 public:
  void begin(std::string_view name, std::string_view type, std::string_view help) {
    name_ = name;
    text_ += fmt::format("# HELP horopter_{} {}\n# TYPE horopter_{} {}\n", name, help, name, type);
  }
  void value(double number, const std::string& labels = "") {
    text_ += fmt::format("horopter_{}{} {:.12g}\n", name_, labels, number);
  }
  std::string take() { return std::move(text_); }

 private:
  std::string name_;
  std::string text_;
};

/// A value of a label: backslashes, quotes and ends of lines are escaped.
std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '\\' || c == '"') result += '\\';
    if (c == '\n') {
      result += "\\n";
    } else {
      result += c;
    }
  }
  return result + '"';
}

template <class Value>
void add_cameras(Text& text, const Status& status, const Value& value) {
  for (std::size_t i = 0; i < status.cameras.size(); ++i) {
    const std::string labels =
        fmt::format("{{side=\"{}\",camera={}}}", i == 0 ? "left" : "right", in_quotes(status.cameras[i].name));
    text.value(static_cast<double>(value(status.cameras[i])), labels);
  }
}

}  // namespace

std::string metrics(const Status& status) {
  Text text;
  text.begin("safe", "gauge", "1 while the outputs say safe.");
  text.value(status.safe ? 1 : 0);
  text.begin("alarm", "gauge", "1 while something is in the skin.");
  text.value(status.alarm ? 1 : 0);
  text.begin("restart_possible", "gauge", "1 while a restart would make it safe.");
  text.value(status.restart == Restart::possible ? 1 : 0);
  text.begin("pairs_total", "counter", "Pairs of images judged since the start.");
  text.value(static_cast<double>(status.frame));
  text.begin("objects", "gauge", "Objects in the skin.");
  text.value(static_cast<double>(status.objects.size()));
  text.begin("decision_seconds", "gauge", "From the arrival of the later image to the decision.");
  text.value(status.decision_ms / 1000);
  if (status.skew_ms) {
    text.begin("skew_seconds", "gauge", "Between the two images of the last pair, right minus left.");
    text.value(*status.skew_ms / 1000);
  }
  if (status.explained) {
    text.begin("explained_ratio", "gauge", "Share of what has texture that both cameras are shown to see.");
    text.value(*status.explained);
  }
  text.begin("cause", "gauge", "1 for each reason why it is not safe now.");
  for (const Cause& cause : status.causes) text.value(1, fmt::format("{{name={}}}", in_quotes(cause.name)));
  text.begin("camera_connected", "gauge", "1 while the camera is open.");
  add_cameras(text, status, [](const CameraState& camera) { return camera.connected ? 1 : 0; });
  text.begin("camera_frames_total", "counter", "Images that came.");
  add_cameras(text, status, [](const CameraState& camera) { return camera.frames; });
  text.begin("camera_dropped_total", "counter", "Of these, never judged.");
  add_cameras(text, status, [](const CameraState& camera) { return camera.dropped; });
  text.begin("camera_lost_packets_total", "counter", "Packets that the transport lost.");
  add_cameras(text, status, [](const CameraState& camera) { return camera.lost_packets; });
  text.begin("camera_repeated_total", "counter", "Images that came twice.");
  add_cameras(text, status, [](const CameraState& camera) { return camera.repeated; });
  text.begin("camera_frames_per_second", "gauge", "Images a second.");
  add_cameras(text, status, [](const CameraState& camera) { return camera.frames_per_s; });
  text.begin("camera_sharpness", "gauge", "Fine detail in proportion to contrast.");
  add_cameras(text, status, [](const CameraState& camera) { return camera.sharpness; });
  return text.take();
}

}  // namespace horopter::monitor
