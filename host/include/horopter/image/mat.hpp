// SPDX-License-Identifier: Apache-2.0
// Images for OpenCV. Not included by other headers: who uses the library needs no OpenCV for them.
#pragma once

#include <opencv2/core/mat.hpp>

#include "horopter/image/image.hpp"

namespace horopter {

/// The image's own pixels, as long as it lives. Those of a constant image must not be changed.
inline cv::Mat mat_of(const Image& image) {
  return {image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.pixels.data())};
}

/// Grey, of 8 bits of grey, BGR or BGRA.
Image grey_image(const cv::Mat& pixels);

}  // namespace horopter
