// SPDX-License-Identifier: Apache-2.0
// Candidates for fiducials: quadrilaterals of any size, dark or bright, in binary images at several scales.
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "target/steps.hpp"

namespace horopter::calib::detail {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Corners of a contour: where the lines through the middle parts of its four sides meet.
std::optional<std::array<Vector2d, 4>> sharpen(const std::vector<cv::Point>& contour,
                                               const std::vector<cv::Point>& polygon) {
  std::array<Vector2d, 4> rough;
  for (int i = 0; i < 4; ++i) rough[i] = Vector2d(polygon[i].x, polygon[i].y);
  if (cross(rough[1] - rough[0], rough[2] - rough[1]) < 0) std::swap(rough[1], rough[3]);
  std::array<std::vector<Vector2d>, 4> sides;
  for (const cv::Point& point : contour) {
    const Vector2d p(point.x, point.y);
    int best = 0;
    double best_distance = 1e9;
    double best_along = 0;
    for (int i = 0; i < 4; ++i) {
      const Vector2d& a = rough[i];
      const Vector2d side = rough[(i + 1) % 4] - a;
      const double length = side.norm();
      const double along = side.dot(p - a) / (length * length);
      const double distance = std::abs(cross(side, p - a)) / length + std::max({0.0, -along, along - 1}) * length;
      if (distance < best_distance) {
        best_distance = distance;
        best = i;
        best_along = along;
      }
    }
    if (best_along > 0.15 && best_along < 0.85) sides[best].push_back(p);
  }
  std::array<Line, 4> lines;
  for (int i = 0; i < 4; ++i) {
    const auto line = fit_line(sides[i]);
    if (!line) return std::nullopt;
    lines[i] = *line;
    if (line->rms_px > 0.6 + 0.03 * (rough[(i + 1) % 4] - rough[i]).norm()) return std::nullopt;
  }
  std::array<Vector2d, 4> corners;
  for (int i = 0; i < 4; ++i) {
    const auto corner = intersect(lines[(i + 3) % 4], lines[i]);
    if (!corner || (*corner - rough[i]).norm() > 3 + 0.25 * (rough[(i + 1) % 4] - rough[i]).norm()) return std::nullopt;
    corners[i] = *corner;
  }
  return corners;
}

double sample(const cv::Mat& grey, const Vector2d& p) {
  const int x = std::clamp(static_cast<int>(std::lround(p.x())), 0, grey.cols - 1);
  const int y = std::clamp(static_cast<int>(std::lround(p.y())), 0, grey.rows - 1);
  return grey.at<std::uint8_t>(y, x);
}

std::optional<Quad> make_quad(const cv::Mat& grey, const std::vector<cv::Point>& contour) {
  if (contour.size() < 16) return std::nullopt;
  const double area = cv::contourArea(contour);
  if (area < 30 || area > 0.5 * grey.cols * grey.rows) return std::nullopt;
  std::vector<cv::Point> polygon;
  const double perimeter = cv::arcLength(contour, true);
  bool four = false;
  for (const double tolerance : {0.03, 0.06, 0.1}) {
    cv::approxPolyDP(contour, polygon, tolerance * perimeter, true);
    if (polygon.size() == 4) {
      four = true;
      break;
    }
  }
  if (!four || !cv::isContourConvex(polygon)) return std::nullopt;
  const auto corners = sharpen(contour, polygon);
  if (!corners) return std::nullopt;

  Quad quad;
  quad.corners = *corners;
  quad.centre = Vector2d(0, 0);
  double shortest = 1e9;
  double longest = 0;
  double quad_area = 0;
  for (int i = 0; i < 4; ++i) {
    const Vector2d& a = quad.corners[i];
    const Vector2d& b = quad.corners[(i + 1) % 4];
    quad.centre += a / 4;
    const double length = (b - a).norm();
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
    quad.side_px += length / 4;
    quad_area += cross(a, b) / 2;
    if (cross(b - a, quad.corners[(i + 2) % 4] - b) <= 0) return std::nullopt;
  }
  if (shortest < 4 || longest > 6 * shortest) return std::nullopt;
  // The contour runs through the centres of the outermost pixels. It is half a pixel too small on each side.
  if (std::abs(quad_area - area) > 0.12 * area + perimeter) return std::nullopt;
  for (const cv::Point& p : contour)
    if (p.x <= 0 || p.y <= 0 || p.x >= grey.cols - 1 || p.y >= grey.rows - 1) quad.touches_border = true;

  // From outside to inside, all four sides must get brighter, or all darker.
  const double reach = std::clamp(0.15 * shortest, 1.5, 4.0);
  double least = 1e9;
  double greatest = -1e9;
  for (int i = 0; i < 4; ++i) {
    const Vector2d a = quad.corners[i];
    const Vector2d side = quad.corners[(i + 1) % 4] - a;
    const Vector2d inward = Vector2d(-side.y(), side.x()).normalized();
    double step = 0;
    for (const double at : {0.3, 0.4, 0.5, 0.6, 0.7}) {
      const Vector2d p = a + at * side;
      step += (sample(grey, p + reach * inward) - sample(grey, p - (reach + 0.5) * inward)) / 5;
    }
    least = std::min(least, step);
    greatest = std::max(greatest, step);
    quad.contrast += step / 4;
  }
  if (least < 0 && greatest > 0 && !quad.touches_border) return std::nullopt;
  if (std::abs(quad.contrast) < 12 || std::min(std::abs(least), std::abs(greatest)) < 0.25 * std::abs(quad.contrast))
    if (!quad.touches_border) return std::nullopt;
  return quad;
}

}  // namespace

std::vector<Quad> find_quads(const cv::Mat& grey) {
  std::vector<Quad> quads;
  const int shorter = std::min(grey.cols, grey.rows);
  const auto collect = [&](const cv::Mat& binary) {
    std::vector<std::vector<cv::Point>> contours;
    cv::findContours(binary, contours, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
    for (const auto& contour : contours) {
      auto quad = make_quad(grey, contour);
      if (!quad) continue;
      // A quad may be found at several scales. The one with the most contrast stays.
      bool known = false;
      for (Quad& other : quads) {
        if ((other.centre - quad->centre).norm() > 0.25 * std::min(other.side_px, quad->side_px)) continue;
        if ((other.contrast > 0) != (quad->contrast > 0) || other.side_px > 1.5 * quad->side_px ||
            quad->side_px > 1.5 * other.side_px)
          continue;
        known = true;
        if (std::abs(quad->contrast) > 1.02 * std::abs(other.contrast)) other = *quad;
        break;
      }
      if (!known) quads.push_back(*quad);
    }
  };
  cv::Mat smooth;
  cv::GaussianBlur(grey, smooth, cv::Size(3, 3), 0.8);
  cv::Mat binary;
  for (const double share : {0.05, 0.12, 0.3}) {
    const int block = std::max(11, static_cast<int>(share * shorter)) | 1;
    for (const bool dark : {true, false}) {
      cv::adaptiveThreshold(smooth, binary, 255, cv::ADAPTIVE_THRESH_MEAN_C,
                            dark ? cv::THRESH_BINARY_INV : cv::THRESH_BINARY, block, dark ? 8 : -8);
      collect(binary);
    }
  }
  for (const bool dark : {true, false}) {
    cv::threshold(smooth, binary, 0, 255, cv::THRESH_OTSU | (dark ? cv::THRESH_BINARY_INV : cv::THRESH_BINARY));
    collect(binary);
  }
  return quads;
}

}  // namespace horopter::calib::detail
