// SPDX-License-Identifier: Apache-2.0
#include "horopter/draw/map_draw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "horopter/draw/plot.hpp"

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
      const bool mapped = table.is_of_skin(column, row);
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

const cv::Scalar kInk(0, 0, 0);
constexpr int kLeft = 56;  ///< px about the picture, for its axes
constexpr int kTop = 34;
constexpr int kRight = 24;
constexpr int kBelow = 40;
constexpr int kNarrowest = 420;  ///< of the page: what the text needs

enum class Side { left, middle, right };

/// Text with its base line at y; smaller where it would leave `width`.
void write(cv::Mat& page, const std::string& text, cv::Point at, Side side, double size = 0.42, int width = 0) {
  const auto extent = [&] { return cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, size, 1, nullptr).width; };
  if (width > 0 && extent() > width) size *= static_cast<double>(width) / extent();
  if (side == Side::middle) at.x -= extent() / 2;
  if (side == Side::right) at.x -= extent();
  cv::putText(page, text, at, cv::FONT_HERSHEY_SIMPLEX, size, kInk, 1, cv::LINE_AA);
}

/// A page with a title, a picture with axes in its pixels, and `legend` px of room below.
cv::Mat framed(const cv::Mat& picture, const std::string& title, int legend) {
  const int width = std::max(kNarrowest, kLeft + picture.cols + kRight);
  cv::Mat page(kTop + picture.rows + kBelow + legend, width, CV_8UC3, cv::Scalar(255, 255, 255));
  const cv::Rect place(kLeft, kTop, picture.cols, picture.rows);
  picture.copyTo(page(place));
  cv::rectangle(page, {place.x - 1, place.y - 1, place.width + 2, place.height + 2}, kInk);
  write(page, title, {width / 2, 20}, Side::middle, 0.5, width - 16);
  const int bottom = place.y + place.height;
  for (const double x : ticks(0, picture.cols - 1, std::clamp(picture.cols / 80, 2, 8))) {
    const int at = kLeft + static_cast<int>(x);
    cv::line(page, {at, bottom}, {at, bottom + 4}, kInk);
    write(page, fmt::format("{:g}", x), {at, bottom + 17}, Side::middle, 0.38);
  }
  for (const double y : ticks(0, picture.rows - 1, std::clamp(picture.rows / 60, 2, 8))) {
    const int at = kTop + static_cast<int>(y);
    cv::line(page, {kLeft - 5, at}, {kLeft - 1, at}, kInk);
    write(page, fmt::format("{:g}", y), {kLeft - 8, at + 4}, Side::right, 0.38);
  }
  write(page, "x, px", {kLeft + picture.cols / 2, bottom + 33}, Side::middle);
  write(page, "y, px", {6, kTop - 8}, Side::left);
  return page;
}

Picture picture_of(const cv::Mat& page) { return {page.cols, page.rows, {page.datastart, page.dataend}}; }

/// Hue by the logarithm of the thickness, with lines at round values.
class ThicknessColours {
 public:
  explicit ThicknessColours(const ThicknessPicture& range)
      : thinnest_mm_(range.thinnest_mm),
        octaves_(std::max(std::log2(range.thickest_mm / range.thinnest_mm), 1e-9)),
        width_mm_(0.003 * (range.thickest_mm - range.thinnest_mm)),
        lines_mm_(ticks(range.thinnest_mm, range.thickest_mm, 6)) {}

  /// Where on the scale, 0 … 1.
  double place(double mm) const { return std::log2(mm / thinnest_mm_) / octaves_; }
  double mm_at(double place) const { return thinnest_mm_ * std::exp2(place * octaves_); }
  const std::vector<double>& lines_mm() const { return lines_mm_; }
  cv::Vec3b colour(double mm) const {
    const bool line = std::ranges::any_of(lines_mm_, [&](double at) { return std::abs(mm - at) < width_mm_; });
    return hsv(240 * place(mm), 1, line);
  }

 private:
  double thinnest_mm_;
  double octaves_;
  double width_mm_;  ///< half of a line's
  std::vector<double> lines_mm_;
};

const cv::Vec3b kInfiniteHsv(0, 0, 150);  ///< grey

cv::Mat thickness_hsv(int width, int height, std::span<const double> thickness_mm, ThicknessPicture& range) {
  range.thinnest_mm = INFINITY;
  for (const double mm : thickness_mm) {
    if (!std::isfinite(mm)) continue;
    range.thinnest_mm = std::min(range.thinnest_mm, mm);
    range.thickest_mm = std::max(range.thickest_mm, mm);
  }
  cv::Mat picture = dark(width, height);
  for (std::size_t i = 0; i < thickness_mm.size(); ++i) {
    if (std::isinf(thickness_mm[i])) picture.at<cv::Vec3b>(static_cast<int>(i)) = kInfiniteHsv;
  }
  if (range.thickest_mm == 0) {
    range.thinnest_mm = range.thickest_mm = NAN;
    return picture;
  }
  const ThicknessColours colours(range);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double mm = thickness_mm[static_cast<std::size_t>(y) * width + x];
      if (std::isfinite(mm)) picture.at<cv::Vec3b>(y, x) = colours.colour(mm);
    }
  }
  return picture;
}

constexpr int kThicknessLegend = 60;

/// What the colours mean.
struct Legend {
  const char* text;
  const char* nothing;  ///< where no pixel has a colour of the scale
};
constexpr Legend kThickness{"thickness of the skin; dark in the picture: unsupervised",
                            "dark: unsupervised; no pixel is supervised"};
constexpr Legend kBodies{"diameter of the smallest body that is found; grey: none is; dark: unsupervised",
                         "grey: no body is found; dark: unsupervised"};

/// The scale of colours, with mm at its ends and at the lines.
void draw_scale(cv::Mat& page, const ThicknessPicture& range, const Legend& legend) {
  const int top = page.rows - kThicknessLegend;
  const int width = std::min(page.cols - kLeft - kRight, 500);
  if (std::isnan(range.thinnest_mm)) {
    write(page, legend.nothing, {kLeft, top + 14}, Side::left);
    return;
  }
  const ThicknessColours colours(range);
  cv::Mat scale(14, width, CV_8UC3);
  for (int x = 0; x < width; ++x) scale.col(x).setTo(colours.colour(colours.mm_at(x / (width - 1.0))));
  in_bgr(scale).copyTo(page({kLeft, top, width, scale.rows}));
  cv::rectangle(page, {kLeft - 1, top - 1, width + 2, scale.rows + 2}, kInk);
  constexpr int kRoom = 66;  // px for a label
  const auto label = [&](double mm) {
    const int x = kLeft + static_cast<int>(colours.place(mm) * (width - 1));
    cv::line(page, {x, top + 14}, {x, top + 18}, kInk);
    write(page, fmt::format("{:.3g} mm", mm), {x, top + 31}, Side::middle, 0.38);
    return x;
  };
  int last = label(range.thinnest_mm);
  const int end = label(range.thickest_mm);
  for (const double mm : colours.lines_mm()) {
    const int x = kLeft + static_cast<int>(colours.place(mm) * (width - 1));
    if (x - last >= kRoom && end - x >= kRoom) last = label(mm);
  }
  write(page, legend.text, {kLeft, top + 51}, Side::left, 0.42, page.cols - kLeft - 8);
}

ThicknessPicture finished(const cv::Mat& picture, const std::string& title, ThicknessPicture range,
                          const Legend& legend = kThickness) {
  cv::Mat page = framed(picture, title, kThicknessLegend);
  draw_scale(page, range, legend);
  range.picture = picture_of(page);
  return range;
}

constexpr int kMapLegend = 84;

/// Colour of a displacement; `largest` px is the strongest.
cv::Vec3b displacement_colour(const cv::Vec2d& px, double largest) {
  return hsv((std::atan2(px[1], px[0]) / CV_PI + 1) * 180, std::min(1.0, cv::norm(px) / largest),
             std::fmod(cv::norm(px), 8.0) < 0.5);
}

/// A disc with the colour of each displacement up to the largest one.
void draw_wheel(cv::Mat& page, double largest) {
  constexpr int kRadius = 34;
  const cv::Point middle(kLeft + kRadius, page.rows - kMapLegend + kRadius + 4);
  cv::Mat disc(2 * kRadius + 1, 2 * kRadius + 1, CV_8UC3, cv::Scalar(0, 0, 255));
  for (int y = -kRadius; y <= kRadius; ++y)
    for (int x = -kRadius; x <= kRadius; ++x) {
      const cv::Vec2d px(x * largest / kRadius, y * largest / kRadius);
      if (cv::norm(px) <= largest) disc.at<cv::Vec3b>(y + kRadius, x + kRadius) = displacement_colour(px, largest);
    }
  in_bgr(disc).copyTo(page({middle.x - kRadius, middle.y - kRadius, disc.cols, disc.rows}));
  const int x = middle.x + kRadius + 14;
  const int width = page.cols - x - 8;
  write(page, fmt::format("from the left to the right pixel: as on the disc, rim {:.3g} px", largest),
        {x, middle.y - 14}, Side::left, 0.42, width);
  write(page, "a line every 8 px; dots: control points", {x, middle.y + 5}, Side::left, 0.42, width);
  write(page, "dark: unsupervised", {x, middle.y + 24}, Side::left, 0.42, width);
}

}  // namespace

Picture draw_map(const MapTable& table, int weight_bits, const std::string& title) {
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
      if (!std::isnan(d[0])) picture.at<cv::Vec3b>(y, x) = displacement_colour(d, largest);
    }
  }
  picture = in_bgr(picture);
  draw_grid(table, picture);
  cv::Mat page = framed(picture, title, kMapLegend);
  draw_wheel(page, largest);
  return picture_of(page);
}

ThicknessPicture draw_thickness(int width, int height, std::span<const double> thickness_mm, const std::string& title) {
  ThicknessPicture range;
  const cv::Mat picture = in_bgr(thickness_hsv(width, height, thickness_mm, range));
  return finished(picture, title, std::move(range));
}

ThicknessPicture draw_thickness(const MapTable& table, std::span<const double> thickness_mm, const std::string& title) {
  const ScanGeometry& scan = table.geometry();
  ThicknessPicture range;
  cv::Mat picture = in_bgr(thickness_hsv(scan.width, scan.height, thickness_mm, range));
  draw_grid(table, picture);
  return finished(picture, title, std::move(range));
}

ThicknessPicture draw_bodies(int width, int height, std::span<const double> body_mm, const std::string& title) {
  ThicknessPicture range;
  const cv::Mat picture = in_bgr(thickness_hsv(width, height, body_mm, range));
  return finished(picture, title, std::move(range), kBodies);
}

Picture one_below_other(const std::vector<Picture>& pictures) {
  Picture result;
  for (const Picture& picture : pictures) {
    if (result.width == 0) result.width = picture.width;
    if (picture.width != result.width) throw std::invalid_argument("pictures of one width are expected");
    result.height += picture.height;
    result.bgr.insert(result.bgr.end(), picture.bgr.begin(), picture.bgr.end());
  }
  return result;
}

}  // namespace horopter
