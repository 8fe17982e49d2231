// SPDX-License-Identifier: Apache-2.0
#include "horopter/draw/map_draw.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace horopter {

namespace {

/// Control points as dots, where there is room between them.
void draw_grid(const MapTable& table, cv::Mat& picture) {
  if (table.spacing_x_log2() < 2 || table.spacing_y_log2() < 2) return;
  for (int row = 0; row < table.rows(); ++row) {
    for (int column = 0; column < table.columns(); ++column) {
      const int x = column << table.spacing_x_log2();
      const int y = row << table.spacing_y_log2();
      if (x >= picture.cols || y >= picture.rows) continue;
      const bool mapped = table.control(column, row) != MapTable::kUnmapped;
      picture.at<cv::Vec3b>(y, x) = mapped ? cv::Vec3b(0, 0, 0) : cv::Vec3b(160, 160, 160);
    }
  }
}

/// Hue in degrees, strength 0 … 1; a contour line is darker.
cv::Vec3b hsv(double hue_deg, double strength, bool contour) {
  return {static_cast<std::uint8_t>(std::fmod(hue_deg / 2, 180)), static_cast<std::uint8_t>(60 + 180 * strength),
          static_cast<std::uint8_t>(contour ? 150 : 235)};
}

cv::Mat dark(int width, int height) { return {height, width, CV_8UC3, cv::Scalar(0, 0, 40)}; }

cv::Mat in_bgr(const cv::Mat& in_hsv) {
  cv::Mat picture;
  cv::cvtColor(in_hsv, picture, cv::COLOR_HSV2BGR);
  return picture;
}

std::vector<std::uint8_t> bytes_of(const cv::Mat& picture) { return {picture.datastart, picture.dataend}; }

cv::Mat thickness_hsv(int width, int height, std::span<const double> thickness_mm, ThicknessPicture& range) {
  range.thinnest_mm = INFINITY;
  for (const double mm : thickness_mm) {
    if (!std::isfinite(mm)) continue;
    range.thinnest_mm = std::min(range.thinnest_mm, mm);
    range.thickest_mm = std::max(range.thickest_mm, mm);
  }
  if (range.thickest_mm == 0) range.thinnest_mm = range.thickest_mm = NAN;
  cv::Mat picture = dark(width, height);
  const double all_octaves = std::max(std::log2(range.thickest_mm / range.thinnest_mm), 1e-9);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double mm = thickness_mm[static_cast<std::size_t>(y) * width + x];
      if (!std::isfinite(mm)) continue;
      const double octaves = std::log2(mm / range.thinnest_mm);
      picture.at<cv::Vec3b>(y, x) = hsv(240 * octaves / all_octaves, 1, std::fmod(octaves * 4, 1.0) < 0.06);
    }
  }
  return picture;
}

}  // namespace

std::vector<std::uint8_t> draw_map(const MapTable& table, int weight_bits) {
  const auto& [width, height, scan] = table.geometry();
  cv::Mat picture = dark(width, height);
  double largest = 1;
  cv::Mat displacement(height, width, CV_64FC2, cv::Scalar(NAN, NAN));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto source = table.source(x, y, weight_bits);
      if (!source) continue;
      const cv::Vec2d d(std::ldexp(source->x, -weight_bits) - x, std::ldexp(source->y, -weight_bits) - y);
      displacement.at<cv::Vec2d>(y, x) = d;
      largest = std::max(largest, cv::norm(d));
    }
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto d = displacement.at<cv::Vec2d>(y, x);
      if (std::isnan(d[0])) continue;
      picture.at<cv::Vec3b>(y, x) =
          hsv((std::atan2(d[1], d[0]) / CV_PI + 1) * 180, cv::norm(d) / largest, std::fmod(cv::norm(d), 8.0) < 0.5);
    }
  }
  picture = in_bgr(picture);
  draw_grid(table, picture);
  return bytes_of(picture);
}

ThicknessPicture draw_thickness(int width, int height, std::span<const double> thickness_mm) {
  ThicknessPicture result;
  result.bgr = bytes_of(in_bgr(thickness_hsv(width, height, thickness_mm, result)));
  return result;
}

ThicknessPicture draw_thickness(const MapTable& table, std::span<const double> thickness_mm) {
  const ScanGeometry& scan = table.geometry();
  ThicknessPicture result;
  cv::Mat picture = in_bgr(thickness_hsv(scan.width, scan.height, thickness_mm, result));
  draw_grid(table, picture);
  result.bgr = bytes_of(picture);
  return result;
}

}  // namespace horopter
