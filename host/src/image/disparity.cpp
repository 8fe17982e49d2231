// SPDX-License-Identifier: Apache-2.0
#include "horopter/image/disparity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <span>
#include <string>

#include "horopter/base/error.hpp"
#include "horopter/base/file.hpp"
#include "horopter/image/image.hpp"
#include "image_check.hpp"

namespace horopter {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
constexpr int kLargestSide = 1 << 15;

/// `Pf`, width, height, scale (negative: little-endian), one white space, rows of floats from the bottom up.
DisparityMap decode_pfm(std::span<const std::uint8_t> bytes, const std::string& name) {
  std::size_t at = 2;
  const auto word = [&] {
    while (at < bytes.size() && std::isspace(bytes[at]) != 0) ++at;
    std::string text;
    while (at < bytes.size() && std::isspace(bytes[at]) == 0 && bytes[at] != 0) text += static_cast<char>(bytes[at++]);
    return text;
  };
  const auto number = [&](const char* what) {
    const std::size_t begin = at;
    const std::string text = word();
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(value) || value == 0) {
      throw FileError(name, fmt::format("byte {}", begin), fmt::format("'{}' in the PFM header", text), what);
    }
    return value;
  };
  const double width = number("the width");
  const double height = number("the height");
  const double order = number("a scale that is not 0");
  if (width < 1 || height < 1 || width > kLargestSide || height > kLargestSide || width != std::floor(width) ||
      height != std::floor(height)) {
    throw FileError(name, "byte 2", fmt::format("a size of {}x{}", width, height), "whole numbers of pixels");
  }
  DisparityMap map{static_cast<int>(width), static_cast<int>(height), {}};
  const std::size_t pixels = static_cast<std::size_t>(map.width) * map.height;
  ++at;
  if (at > bytes.size() || bytes.size() - at < pixels * 4) {
    throw FileError(name, fmt::format("byte {}", bytes.size()), "the file is truncated",
                    fmt::format("{} bytes of pixels from byte {}", pixels * 4, at));
  }
  map.px.resize(pixels);
  for (int y = map.height - 1; y >= 0; --y) {
    for (int x = 0; x < map.width; ++x, at += 4) {
      std::uint32_t bits = 0;
      for (int i = 0; i < 4; ++i) bits = bits << 8 | bytes[at + (order < 0 ? 3 - i : i)];
      map.px[static_cast<std::size_t>(y) * map.width + x] = std::bit_cast<float>(bits);
    }
  }
  return map;
}

DisparityMap decode_picture(std::span<const std::uint8_t> bytes, const std::string& name) {
  const ImageFormat format = sniff_format(bytes);
  if (format != ImageFormat::png && format != ImageFormat::pnm) {
    throw FileError(name, "byte 0", "not a disparity map", "PNG, PGM or PFM");
  }
  check_structure(bytes, format, name, 16);
  cv::Mat decoded;
  try {
    const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8U, const_cast<std::uint8_t*>(bytes.data()));
    decoded = cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception& error) {
    throw FileError(name, "", "the image cannot be decoded (" + error.err + ")", "an undamaged disparity map");
  }
  if (decoded.empty()) throw FileError(name, "", "the image cannot be decoded", "an undamaged disparity map");
  if (decoded.channels() != 1) {
    throw FileError(name, "", fmt::format("{} samples a pixel", decoded.channels()), "1: disparities have no colour");
  }
  cv::Mat values;
  decoded.convertTo(values, CV_32F);
  DisparityMap map{values.cols, values.rows, {}};
  map.px.assign(values.begin<float>(), values.end<float>());
  return map;
}

}  // namespace

DisparityMap load_disparity(const std::filesystem::path& path, double scale) {
  const auto bytes = read_file(path, "a disparity map (PNG, PGM or PFM)");
  const std::string name = path.string();
  const bool pfm = bytes.size() > 2 && bytes[0] == 'P' && bytes[1] == 'f' && std::isspace(bytes[2]) != 0;
  DisparityMap map = pfm ? decode_pfm(bytes, name) : decode_picture(bytes, name);
  for (float& d : map.px) d = std::isfinite(d) && d > 0 ? static_cast<float>(d / scale) : kUnknown;
  if (std::ranges::all_of(map.px, [](float d) { return std::isnan(d); })) {
    throw FileError(name, "", "no pixel has a known disparity", "ground truth");
  }
  return map;
}

DisparityMap resized(const DisparityMap& map, double factor, int width, int height) {
  DisparityMap result{width, height, {}};
  result.px.reserve(static_cast<std::size_t>(width) * height);
  const auto source = [](int i, int from, int to) {
    return std::min(from - 1, static_cast<int>((i + 0.5) * from / to));
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      result.px.push_back(
          static_cast<float>(map.at(source(x, map.width, width), source(y, map.height, height)) * factor));
    }
  }
  return result;
}

}  // namespace horopter
