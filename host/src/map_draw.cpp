// SPDX-License-Identifier: Apache-2.0
// Pictures of mapping tables.
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "horopter/map.hpp"

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

std::vector<std::uint8_t> finished(const cv::Mat& in_hsv, const MapTable& table) {
  cv::Mat picture;
  cv::cvtColor(in_hsv, picture, cv::COLOR_HSV2BGR);
  draw_grid(table, picture);
  return {picture.datastart, picture.dataend};
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
  return finished(picture, table);
}

ThicknessPicture draw_thickness(const MapTable& table, int weight_bits, const CameraPair& cameras,
                                double tolerance_px) {
  const ScanGeometry& scan = table.geometry();
  cv::Mat thickness(scan.height, scan.width, CV_64F, cv::Scalar(NAN));
  ThicknessPicture result{{}, INFINITY, 0};
  for (int y = 0; y < scan.height; ++y) {
    for (int x = 0; x < scan.width; ++x) {
      // Without the rounding to the weights, which would hide the shape.
      if (!table.source(x, y, weight_bits)) continue;
      const auto source = *table.expand(x, y);
      const Point right{std::ldexp(static_cast<double>(source.x), -MapTable::kFractionBits),
                        std::ldexp(static_cast<double>(source.y), -MapTable::kFractionBits)};
      const double mm = cameras.thickness_mm(scan.to_frame({static_cast<double>(x), static_cast<double>(y)}),
                                             scan.to_frame(right), tolerance_px);
      if (!std::isfinite(mm)) continue;
      thickness.at<double>(y, x) = mm;
      result.thinnest_mm = std::min(result.thinnest_mm, mm);
      result.thickest_mm = std::max(result.thickest_mm, mm);
    }
  }
  if (result.thickest_mm == 0) result.thinnest_mm = result.thickest_mm = NAN;
  cv::Mat picture = dark(scan.width, scan.height);
  const double range = std::max(std::log2(result.thickest_mm / result.thinnest_mm), 1e-9);
  for (int y = 0; y < scan.height; ++y) {
    for (int x = 0; x < scan.width; ++x) {
      const double mm = thickness.at<double>(y, x);
      if (std::isnan(mm)) continue;
      const double octaves = std::log2(mm / result.thinnest_mm);
      picture.at<cv::Vec3b>(y, x) = hsv(240 * octaves / range, 1, std::fmod(octaves * 4, 1.0) < 0.06);
    }
  }
  result.bgr = finished(picture, table);
  return result;
}

}  // namespace horopter
