// SPDX-License-Identifier: Apache-2.0
#include "disturbances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace horopter::cli {

using cv::Mat;

Mat flat(const Mat& like, double grey) { return {like.size(), CV_8UC1, cv::Scalar(grey)}; }

Mat blurred(const Mat& image, double sigma_px) {
  Mat result;
  cv::GaussianBlur(image, result, {}, sigma_px);
  return result;
}

Mat compressed(const Mat& image, int quality) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, quality});
  return cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
}

namespace {

Mat with_noise(const Mat& image, double sd, cv::RNG& random) {
  if (sd == 0) return image;
  Mat noise(image.size(), CV_32FC1);
  random.fill(noise, cv::RNG::NORMAL, 0, sd);
  Mat result;
  cv::add(image, noise, result, cv::noArray(), CV_8UC1);
  return result;
}

Mat scaled(const Mat& image, double gain, double offset) {
  Mat result;
  image.convertTo(result, CV_8UC1, gain, offset);
  return result;
}

Mat turned(const Mat& image, double degrees, double scale, double down_px) {
  Mat turn = cv::getRotationMatrix2D({0.5F * static_cast<float>(image.cols), 0.5F * static_cast<float>(image.rows)},
                                     degrees, scale);
  turn.at<double>(1, 2) += down_px;
  Mat result;
  cv::warpAffine(image, result, turn, image.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return result;
}

/// 0: top to bottom; 1: left to right; -1: both.
Mat flipped(const Mat& image, int code) {
  Mat result;
  cv::flip(image, result, code);
  return result;
}

Mat taped(const Mat& image, double share) {
  Mat result = image.clone();
  result.colRange(0, cvRound(share * image.cols)).setTo(100);
  return result;
}

Mat ramp(const Mat& like) {
  Mat result(like.size(), CV_8UC1);
  for (int x = 0; x < like.cols; ++x) {
    const int grey = 40 + 180 * x / like.cols;
    result.col(x).setTo(grey);
  }
  return result;
}

/// Blotches of some 5 px.
Mat sheet_texture(const cv::Size& size) {
  Mat texture(size, CV_32FC1);
  cv::RNG(7).fill(texture, cv::RNG::NORMAL, 0, 1);
  cv::GaussianBlur(texture, texture, {}, 2);
  cv::normalize(texture, texture, 10, 245, cv::NORM_MINMAX);
  Mat result;
  texture.convertTo(result, CV_8UC1);
  return result;
}

/// A sheet nearer than the skin, over the left `share` of the left image.
CameraImages behind_sheet(const Sight& sight, double share) {
  CameraImages images{sight.scene[kLeft].clone(), sight.scene[kRight].clone()};
  const Mat right = sheet_texture(images[kRight].size());
  Mat left;
  cv::remap(right, left, sight.sheet, Mat(), cv::INTER_LINEAR, cv::BORDER_REFLECT);
  const int columns = cvRound(share * left.cols);
  const auto edge = sight.sheet.at<cv::Vec2f>(left.rows / 2, columns - 1)[0];
  const int right_columns = share >= 1 ? right.cols : std::clamp(cvRound(edge), 0, right.cols);
  left.colRange(0, columns).copyTo(images[kLeft].colRange(0, columns));
  // So near that the right camera may not see it at all.
  if (right_columns > 0) right.colRange(0, right_columns).copyTo(images[kRight].colRange(0, right_columns));
  return images;
}

std::vector<Change> changes() {
  std::vector<Change> all{
      {"covered", [](const Mat& image, const Mat&) { return blurred(image, 60); }, 2},
      {"white", [](const Mat& image, const Mat&) { return flat(image, 250); }, 2},
      {"ramp", [](const Mat& image, const Mat&) { return ramp(image); }},
      {"ramp without noise", [](const Mat& image, const Mat&) { return ramp(image); }, 0},
      {"fog", [](const Mat& image, const Mat&) { return scaled(image, 1.0 / 16, 150); }, Disturbed::kSensorNoise, true},
      {"another scene", [](const Mat&, const Mat& other) { return other; }},
      {"turned by 180 deg", [](const Mat& image, const Mat&) { return flipped(image, -1); }},
      {"upside down", [](const Mat& image, const Mat&) { return flipped(image, 0); }},
      {"mirrored", [](const Mat& image, const Mat&) { return flipped(image, 1); }},
      {"enlarged by 1.03", [](const Mat& image, const Mat&) { return turned(image, 0, 1.03, 0); }},
  };
  for (const int level : {4, 12, 60}) {
    for (const int noise : {0, 3, 20}) {
      all.push_back({fmt::format("dark: level {} noise {}", level, noise),
                     [level](const Mat& image, const Mat&) { return flat(image, level); }, 1.0 * noise, true});
    }
  }
  for (const int percent : {30, 60, 90}) {
    all.push_back({fmt::format("tape over {} %", percent),
                   [percent](const Mat& image, const Mat&) { return taped(image, percent / 100.0); },
                   Disturbed::kSensorNoise, true});
  }
  for (const int px : {2, 5, 10}) {
    all.push_back(
        {fmt::format("knocked by {} px", px), [px](const Mat& image, const Mat&) { return turned(image, 0, 1, px); }});
  }
  for (const int degrees : {1, 2}) {
    all.push_back({fmt::format("rolled by {} deg", degrees),
                   [degrees](const Mat& image, const Mat&) { return turned(image, degrees, 1, 0); }});
  }
  for (const int px : {3, 6}) {
    all.push_back(
        {fmt::format("defocused by {} px", px), [px](const Mat& image, const Mat&) { return blurred(image, px); }});
  }
  return all;
}

Disturbed change(const Sight& sight, const Change& what, std::initializer_list<std::size_t> cameras) {
  Disturbed result{.light = sight.scene, .copy = {}};
  for (const std::size_t camera : cameras) {
    result.light[camera] = what.light(sight.scene[camera], sight.other[camera]);
    result.noise[camera] = what.noise;
  }
  return result;
}

using Copy = std::function<Mat(const Mat& frame, cv::RNG& random)>;

void add_one_camera_twice(std::vector<Disturbance>& all, const std::string& how, const Copy& copy) {
  for (const std::size_t camera : {kRight, kLeft}) {
    all.push_back(
        {"other camera's image " + how, camera == kLeft ? "left" : "right", false, [copy, camera](const Sight& sight) {
           return Disturbed{.light = sight.scene, .copy = copy, .copied = camera};
         }});
  }
}

std::vector<Disturbance> harmless() {
  std::vector<Change> all;
  for (const double gain : {0.5, 1.5, 2.0}) {
    all.push_back(
        {fmt::format("gain {}", gain), [gain](const Mat& image, const Mat&) { return scaled(image, gain, 0); }});
  }
  for (const int offset : {-40, 40}) {
    all.push_back({fmt::format("offset {:+}", offset),
                   [offset](const Mat& image, const Mat&) { return scaled(image, 1, offset); }});
  }
  all.push_back({"noise 5", [](const Mat& image, const Mat&) { return image; }, 5});
  std::vector<Disturbance> result{
      {kAsItIs, "both", true, [](const Sight& sight) { return Disturbed{.light = sight.scene, .copy = {}}; }}};
  for (const Change& what : all) {
    result.push_back({what.name, "right", true, [what](const Sight& sight) { return change(sight, what, {kRight}); }});
  }
  return result;
}

}  // namespace

std::array<Image, 2> Disturbed::frames(cv::RNG& random) const {
  CameraImages seen{with_noise(light[kLeft], noise[kLeft], random), with_noise(light[kRight], noise[kRight], random)};
  if (copy) seen[copied] = copy(seen[1 - copied], random);
  std::array<Image, 2> result;
  for (const std::size_t camera : {kLeft, kRight}) {
    result[camera] = Image(seen[camera].cols, seen[camera].rows);
    seen[camera].copyTo(Mat(seen[camera].size(), CV_8UC1, result[camera].pixels.data()));
  }
  return result;
}

std::vector<Disturbance> disturbances(bool harder) {
  std::vector<Disturbance> all = harmless();
  for (const Change& what : harder ? harder_changes() : changes()) {
    all.push_back({what.name, "right", false, [what](const Sight& s) { return change(s, what, {kRight}); }});
    all.push_back({what.name, "left", false, [what](const Sight& s) { return change(s, what, {kLeft}); }});
    if (!what.of_both) continue;
    all.push_back({what.name, "both", false, [what](const Sight& s) { return change(s, what, {kLeft, kRight}); }});
  }
  if (harder) return all;
  all.push_back({"swapped", "both", false, [](const Sight& sight) {
                   return Disturbed{.light = {sight.scene[kRight], sight.scene[kLeft]}, .copy = {}};
                 }});
  for (const int noise : {0, 1, 5}) {
    add_one_camera_twice(all, fmt::format("noise {}", noise),
                         [noise](const Mat& frame, cv::RNG& random) { return with_noise(frame, noise, random); });
  }
  for (const int quality : {60, 95}) {
    add_one_camera_twice(all, fmt::format("JPEG {}", quality),
                         [quality](const Mat& frame, cv::RNG&) { return compressed(frame, quality); });
  }
  for (const int percent : {30, 60, 100}) {
    all.push_back({fmt::format("sheet over {} %", percent), "both", false, [percent](const Sight& sight) {
                     return Disturbed{.light = behind_sheet(sight, percent / 100.0), .copy = {}};
                   }});
  }
  return all;
}

}  // namespace horopter::cli
