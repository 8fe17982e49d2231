// SPDX-License-Identifier: Apache-2.0
#include "horopter/draw/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "horopter/image/mat.hpp"
#include "horopter/machine/regions.hpp"

namespace horopter {
namespace {

/// The left image at the result's resolution: pairs of a row averaged for profiles that sub-sample.
cv::Mat left_at_result_size(const Image& left, int width, int height) {
  const cv::Mat grey = mat_of(left);
  if (left.width == width && left.height == height) return grey.clone();
  cv::Mat small;
  cv::resize(grey, small, {width, height}, 0, 0, cv::INTER_AREA);
  return small;
}

constexpr int kArrow_frames = 5;
const cv::Scalar kRed(40, 40, 230), kWhite(255, 255, 255), kYellow(0, 220, 255);

/// Both colours, so that it is seen on everything.
void write(cv::Mat& picture, const std::string& text, cv::Point at) {
  constexpr double kScale = 0.45;
  const int width = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, kScale, 1, nullptr).width;
  at.x = std::max(0, std::min(at.x, picture.cols - width - 2));
  for (const auto& [colour, thickness] : {std::pair{kRed, 4}, {kWhite, 1}}) {
    cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, kScale, colour, thickness, cv::LINE_AA);
  }
}

/// `factor`: pixels of the picture for one of the result.
void draw_alarm(cv::Mat& picture, const TrackedObject& object, int factor) {
  const Region& r = object.region;
  const cv::Point corner(r.x * factor, r.y * factor);
  cv::rectangle(picture, corner, {(r.x + r.width) * factor - 1, (r.y + r.height) * factor - 1}, kRed, 3);
  if (object.motion) {
    const auto place = [&](double x, double y) {
      return cv::Point(cvRound((x + 0.5) * factor), cvRound((y + 0.5) * factor));
    };
    const Eigen::Vector2d way = kArrow_frames * object.motion->px_frame;
    const cv::Point from = place(r.centroid_x, r.centroid_y);
    const cv::Point to = place(r.centroid_x + way.x(), r.centroid_y + way.y());
    constexpr double kShortest_px = 6;  // less is noise
    if (cv::norm(to - from) >= kShortest_px) {
      for (const auto& [colour, thickness] : {std::pair{kRed, 5}, {kWhite, 2}}) {
        cv::arrowedLine(picture, from, to, colour, thickness, cv::LINE_AA, 0, 0.25);
      }
    }
  }
  const std::string size =
      object.in_space ? fmt::format("{:.0f} x {:.0f} mm", object.in_space->length_mm, object.in_space->width_mm)
                      : fmt::format("{} px", r.pixels);
  write(picture, fmt::format("{}: {}", object.id, size), corner + cv::Point(5, 17));
}

}  // namespace

Picture draw_states(const Image& left, const FrameResult& result) {
  const Image& states = result.states;
  const cv::Mat grey = left_at_result_size(left, states.width, states.height);
  cv::Mat small(states.height, states.width, CV_8UC3);
  for (int y = 0; y < states.height; ++y) {
    for (int x = 0; x < states.width; ++x) {
      const int g = grey.at<std::uint8_t>(y, x);
      cv::Vec3b& pixel = small.at<cv::Vec3b>(y, x);
      const auto mix = [&](int blue, int green, int red, int percent) {
        const auto part = [&](int colour) {
          return static_cast<std::uint8_t>((g * (100 - percent) + colour * percent) / 100);
        };
        pixel = {part(blue), part(green), part(red)};
      };
      switch (static_cast<State>(states.at(x, y))) {
        case State::clear:
          mix(g, std::min(255, g + 30), g, 100);
          break;
        case State::skin:
          mix(30, 40, 255, 55);
          break;
        case State::undecidable:
          result.blind.empty() || result.blind[static_cast<std::size_t>(y * states.width + x)] == 0
              ? mix(60, 30, 20, 30)
              : mix(0, 150, 255, 55);
          break;
        case State::unsupervised:
          (x + y) % 8 == 0 ? mix(20, 20, 20, 85) : mix(20, 20, 20, 65);
          break;
      }
    }
  }
  return {small.cols, small.rows, {small.datastart, small.dataend}};
}

Picture draw_overlay(const Image& left, const FrameResult& result, const std::vector<TrackedObject>& objects) {
  const Image& states = result.states;
  Picture drawn = draw_states(left, result);
  const cv::Mat small(drawn.height, drawn.width, CV_8UC3, drawn.bgr.data());
  const int factor = std::max(1, (599 + states.width) / states.width);
  cv::Mat picture;
  cv::resize(small, picture, {}, factor, factor, cv::INTER_NEAREST);

  const auto smallest = std::max<std::int64_t>(16, static_cast<std::int64_t>(states.pixels.size()) / 2000);
  int number = 0;  // of the objects that are an alarm, the largest first
  for (const Region& region : objects_of(result)) {
    const bool alarm = is_alarm(region, result);
    if (alarm) {
      const auto followed = std::ranges::find(objects, region, [](const TrackedObject& o) { return o.region; });
      TrackedObject unknown;
      unknown.region = region;
      unknown.id = ++number;
      draw_alarm(picture, followed != objects.end() ? *followed : unknown, factor);
      continue;
    }
    if (region.pixels < smallest) continue;
    cv::rectangle(picture, {region.x * factor, region.y * factor},
                  {(region.x + region.width) * factor - 1, (region.y + region.height) * factor - 1}, kYellow, 2);
  }

  std::string text = result.alarm ? "ALARM" : result.safe ? "safe" : "not safe";
  const double percent = 100.0 * static_cast<double>(result.skin_pixels) / static_cast<double>(states.pixels.size());
  text += fmt::format("   {:.1f} % in the skin", percent);
  if (result.blind_pixels > 0) {
    text += fmt::format("   {:.1f} % blind",
                        100.0 * static_cast<double>(result.blind_pixels) / static_cast<double>(states.pixels.size()));
  }
  for (const std::string& fault : result.faults.names()) text += "   " + fault;
  const cv::Scalar colour = result.faults.any() ? cv::Scalar(0, 140, 255)
                            : result.alarm      ? cv::Scalar(40, 40, 230)
                                                : cv::Scalar(80, 170, 60);
  constexpr int kBar = 26;
  cv::copyMakeBorder(picture, picture, kBar, 0, 0, 0, cv::BORDER_CONSTANT, colour);
  cv::putText(picture, text, {8, 18}, cv::FONT_HERSHEY_SIMPLEX, 0.5, {255, 255, 255}, 1, cv::LINE_AA);
  return {picture.cols, picture.rows, {picture.datastart, picture.dataend}};
}

}  // namespace horopter
