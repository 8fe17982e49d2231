// SPDX-License-Identifier: Apache-2.0
// What may happen to two cameras: disturbances after which they no longer see the same world, and harmless ones.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "horopter/image/image.hpp"

namespace horopter::cli {

/// 8-bit grey images of the left and the right camera, of one size.
using CameraImages = std::array<cv::Mat, 2>;
constexpr std::size_t kLeft = 0, kRight = 1;

/// What there is to see, and what a disturbance may put in its place.
struct Sight {
  CameraImages scene;
  CameraImages other;  ///< of another scene, of the same size
  /// Places, px (CV_32FC2), in the right image of what each left pixel sees of a sheet before both cameras.
  cv::Mat sheet;
};

/// What falls on the sensors, and what becomes of it on the way to the machine.
struct Disturbed {
  CameraImages light;
  std::array<double, 2> noise{kSensorNoise, kSensorNoise};  ///< sd, grey levels
  /// Makes one camera's frame (`copied`) of the other's.
  std::function<cv::Mat(const cv::Mat& frame, cv::RNG& random)> copy;
  std::size_t copied = kRight;

  static constexpr double kSensorNoise = 1.5;
  /// The next frames, with fresh noise.
  std::array<Image, 2> frames(cv::RNG& random) const;
};

inline const std::string kAsItIs = "as it is";  ///< the first of the harmless ones

struct Disturbance {
  std::string name;
  std::string camera;  ///< left, right or both
  bool harmless;       ///< no fault may come of it
  std::function<Disturbed(const Sight& sight)> disturb;
};

/// Of one grey level; out of focus; as JPEG of this quality leaves it.
cv::Mat flat(const cv::Mat& like, double grey);
cv::Mat blurred(const cv::Mat& image, double sigma_px);
cv::Mat compressed(const cv::Mat& image, int quality);

/// What happens to one camera alone, or to both alike.
struct Change {
  std::string name;
  std::function<cv::Mat(const cv::Mat& image, const cv::Mat& other)> light;
  double noise = Disturbed::kSensorNoise;
  bool of_both = false;  ///< may happen to both cameras at once
};

/// Of a part of an image, or such that both cameras still look like some that see.
std::vector<Change> harder_changes();

/// All of them, the harmless ones first; `harder`: these in place of the usual ones.
std::vector<Disturbance> disturbances(bool harder);

}  // namespace horopter::cli
