// SPDX-License-Identifier: Apache-2.0
// What may blind a part of an image, or coarsen or bend it, so that one camera or both still look like cameras that see.
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "disturbances.hpp"

namespace horopter::cli {
namespace {

using cv::Mat;

/// `image`, and `other` in a part of it; the part's borders are shares of width and height.
Mat in_part(const Mat& image, const Mat& other, double left, double top, double right, double bottom) {
  const cv::Point from(cvRound(left * image.cols), cvRound(top * image.rows));
  const cv::Rect part(from, cv::Point(cvRound(right * image.cols), cvRound(bottom * image.rows)));
  Mat result = image.clone();
  other(part).copyTo(result(part));
  return result;
}

/// `image`, and `other` in the columns that `is_there` takes.
Mat in_columns(const Mat& image, const Mat& other, const std::function<bool(int)>& is_there) {
  Mat result = image.clone();
  for (int x = 0; x < image.cols; ++x) {
    if (is_there(x)) other.col(x).copyTo(result.col(x));
  }
  return result;
}

/// Each row as if the camera had looked so far to the right, in px.
Mat rows_aside(const Mat& image, const std::function<int(int y)>& aside_px) {
  Mat result = image.clone();
  for (int y = 0; y < image.rows; ++y) {
    const int shift = aside_px(y);
    const int width = image.cols - std::abs(shift);
    const cv::Rect from(std::max(shift, 0), y, width, 1), to(std::max(-shift, 0), y, width, 1);
    image(from).copyTo(result(to));
  }
  return result;
}

Mat moving(const Mat& image, const cv::Size& way_px) {
  Mat result;
  cv::blur(image, result, way_px);
  return result;
}

Mat drop(const Mat& image) {
  Mat mask = Mat::zeros(image.size(), CV_8UC1);
  cv::circle(mask, {image.cols / 2, image.rows / 2}, image.rows * 3 / 10, cv::Scalar(255), cv::FILLED);
  Mat result = image.clone();
  blurred(image, 8).copyTo(result, mask);
  return result;
}

Mat in_blocks(const Mat& image, int side_px) {
  Mat small, result;
  cv::resize(image, small, {image.cols / side_px, image.rows / side_px}, 0, 0, cv::INTER_AREA);
  cv::resize(small, result, image.size(), 0, 0, cv::INTER_NEAREST);
  return result;
}

/// What comes from which place, in shares of half the width from the middle.
Mat bent(const Mat& image, const std::function<cv::Point2d(cv::Point2d at)>& from) {
  Mat places(image.size(), CV_32FC2);
  const double half_px = image.cols / 2.0;
  const cv::Point2d middle(half_px, image.rows / 2.0);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const cv::Point2d place = middle + half_px * from((cv::Point2d(x, y) - middle) / half_px);
      places.at<cv::Vec2f>(y, x) = {static_cast<float>(place.x), static_cast<float>(place.y)};
    }
  }
  Mat result;
  cv::remap(image, result, places, Mat(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return result;
}

Mat peppered(const Mat& image) {
  Mat chance(image.size(), CV_8UC1);
  cv::RNG(5).fill(chance, cv::RNG::UNIFORM, 0, 256);
  Mat result = image.clone();
  result.setTo(0, chance < 26);
  result.setTo(255, chance >= 230);
  return result;
}

Mat with_gamma(const Mat& image, double gamma) {
  Mat power, result;
  image.convertTo(power, CV_32FC1, 1.0 / 255);
  cv::pow(power, gamma, power);
  power.convertTo(result, CV_8UC1, 255);
  return result;
}

}  // namespace

std::vector<Change> harder_changes() {
  constexpr double kTape = 100, kNoise = Disturbed::kSensorNoise;
  using Images = const Mat&;
  return {
      {"tape over the right 30 %", [](Images i, Images) { return in_part(i, flat(i, kTape), 0.7, 0, 1, 1); }},
      {"tape over the middle", [](Images i, Images) { return in_part(i, flat(i, kTape), 0.3, 0, 0.7, 1); }, kNoise,
       true},
      {"fence of 8 in 24 px",
       [](Images i, Images) { return in_columns(i, flat(i, kTape), [](int x) { return x % 24 < 8; }); }},
      {"drop on the lens", [](Images i, Images) { return drop(i); }, kNoise, true},
      {"grease over the left half", [](Images i, Images) { return in_part(i, blurred(i, 4), 0, 0, 0.5, 1); }, kNoise,
       true},
      {"upper half of another scene", [](Images i, Images o) { return in_part(i, o, 0, 0, 1, 0.5); }},
      {"middle of another scene", [](Images i, Images o) { return in_part(i, o, 0.25, 0.25, 0.75, 0.75); }},
      {"another scene reflected", [](Images i, Images o) { return Mat(0.5 * i + 0.5 * o); }},
      {"every 8th column black",
       [](Images i, Images) { return in_columns(i, flat(i, 0), [](int x) { return x % 8 == 0; }); }, kNoise, true},
      {"every 2nd row 8 px aside", [](Images i, Images) { return rows_aside(i, [](int y) { return y % 2 * 8; }); }},
      {"every 2nd row 3 px aside", [](Images i, Images) { return rows_aside(i, [](int y) { return y % 2 * 3; }); }},
      {"every 2nd pair of rows 8 px aside",
       [](Images i, Images) { return rows_aside(i, [](int y) { return y / 2 % 2 * 8; }); }},
      {"each row up to 8 px aside",
       [](Images i, Images) {
         cv::RNG random(7);
         return rows_aside(i, [&](int) { return random.uniform(-8, 9); });
       }},
      {"lower half 8 px aside",
       [](Images i, Images) { return rows_aside(i, [&](int y) { return y < i.rows / 2 ? 0 : 8; }); }},
      {"every 2nd row of another scene",
       [](Images i, Images o) {
         Mat result = i.clone();
         for (int y = 1; y < i.rows; y += 2) o.row(y).copyTo(result.row(y));
         return result;
       }},
      {"every 2nd row twice",
       [](Images i, Images) {
         Mat result = i.clone();
         for (int y = 1; y < i.rows; y += 2) i.row(y - 1).copyTo(result.row(y));
         return result;
       },
       kNoise, true},
      {"moving by 21 px along the row", [](Images i, Images) { return moving(i, {21, 1}); }, kNoise, true},
      {"moving by 21 px down", [](Images i, Images) { return moving(i, {1, 21}); }, kNoise, true},
      {"blocks of 8 px", [](Images i, Images) { return in_blocks(i, 8); }, kNoise, true},
      {"blocks of 4 px", [](Images i, Images) { return in_blocks(i, 4); }, kNoise, true},
      {"JPEG of quality 5", [](Images i, Images) { return compressed(i, 5); }, kNoise, true},
      {"3 bits a pixel", [](Images i, Images) { return Mat(i & 0xE0); }, kNoise, true},
      {"bit 7 stuck at 0", [](Images i, Images) { return Mat(i & 0x7F); }},
      {"negative", [](Images i, Images) { return Mat(255 - i); }},
      {"gamma 3", [](Images i, Images) { return with_gamma(i, 3); }},
      {"salt and pepper over 20 %", [](Images i, Images) { return peppered(i); }},
      {"waves of 4 px down",
       [](Images i, Images) {
         return bent(i, [](cv::Point2d at) { return cv::Point2d(at.x, at.y + 0.0125 * std::sin(5 * at.x)); });
       }},
      {"waves of 6 px along the row",
       [](Images i, Images) {
         return bent(i, [](cv::Point2d at) { return cv::Point2d(at.x + 0.01875 * std::sin(8 * at.y), at.y); });
       }},
      {"keystone of 7 px",
       [](Images i, Images) {
         return bent(i, [](cv::Point2d at) { return cv::Point2d(at.x, at.y + 0.03 * at.x * at.y); });
       }},
      {"lens bent by 8 px",
       [](Images i, Images) { return bent(i, [](cv::Point2d at) { return at * (1 + 0.025 * at.dot(at)); }); }},
  };
}

}  // namespace horopter::cli
