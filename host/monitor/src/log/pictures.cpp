// SPDX-License-Identifier: Apache-2.0
#include "pictures.hpp"

#include <fmt/format.h>

#include <opencv2/imgcodecs.hpp>

#include "horopter/base/error.hpp"
#include "horopter/draw/overlay.hpp"
#include "horopter/image/output.hpp"

namespace horopter::monitor {
namespace {

constexpr int kJpegQuality = 85;

}  // namespace

std::vector<PictureFile> encode_moment(const Moment& moment) {
  const std::string stem = fmt::format("frame-{:08}", moment.status.frame);
  std::vector<PictureFile> files;
  if (!moment.left.empty()) files.push_back({stem + "-left.png", encode_png(moment.left)});
  if (!moment.right.empty()) files.push_back({stem + "-right.png", encode_png(moment.right)});
  if (moment.left.empty() || moment.result.states.empty()) return files;
  Picture overlay = draw_overlay(moment.left, moment.result);
  std::vector<std::uint8_t> bytes;
  if (!cv::imencode(".jpg", cv::Mat(overlay.height, overlay.width, CV_8UC3, overlay.bgr.data()), bytes,
                    {cv::IMWRITE_JPEG_QUALITY, kJpegQuality})) {
    throw Error(ExitStatus::fault, "a picture cannot be encoded as JPEG");
  }
  files.push_back({stem + "-overlay.jpg", std::move(bytes)});
  return files;
}

std::size_t bytes_of(const Moment& moment) {
  return sizeof(Moment) + moment.left.pixels.size() + moment.right.pixels.size() + moment.result.states.pixels.size() +
         moment.result.blind.size() + moment.result.runs.size() * sizeof(Run);
}

}  // namespace horopter::monitor
