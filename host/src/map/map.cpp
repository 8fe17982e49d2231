// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "horopter/base/crc32.hpp"

namespace horopter {
namespace {

constexpr std::uint32_t kHeader = 0x484D0100;  // "HM", version 1
constexpr int kControlOffset_px = 64;          // control points are unsigned: 0 means -64 px
constexpr int kControlScale = 32;              // steps per pixel
constexpr int kSmallestLookahead = 8;          // more than the filters' reach in rows; nothing is won below

int control_count(int size, int spacing_log2) { return (size + (1 << spacing_log2) - 1) / (1 << spacing_log2) + 1; }

}  // namespace

std::vector<ScanGeometry> scans_of(const MachineProfile& profile, int image_width, int image_height) {
  if (!profile.takes_fields()) return {{image_width, image_height, Scan::progressive}};
  return {{image_width, (image_height + 1) / 2, Scan::even_field}, {image_width, image_height / 2, Scan::odd_field}};
}

std::size_t MapTable::pool_bytes(const ScanGeometry& geometry, int spacing_x_log2, int spacing_y_log2) {
  const int rows = (control_count(geometry.height, spacing_y_log2) + 1) / 2 * 2;
  return sizeof(std::uint32_t) * static_cast<std::size_t>(control_count(geometry.width, spacing_x_log2)) *
         static_cast<std::size_t>(rows);
}

MapTable::MapTable(ScanGeometry geometry, int spacing_x_log2, int spacing_y_log2)
    : geometry_(geometry),
      spacing_x_log2_(spacing_x_log2),
      spacing_y_log2_(spacing_y_log2),
      columns_(control_count(geometry.width, spacing_x_log2)),
      rows_((control_count(geometry.height, spacing_y_log2) + 1) / 2 * 2),
      words_(static_cast<std::size_t>(columns_) * rows_ + 4, kUnmapped) {
  words_[0] = kHeader | static_cast<std::uint32_t>(spacing_x_log2) << 4 | static_cast<std::uint32_t>(spacing_y_log2);
  words_[1] = static_cast<std::uint32_t>(rows_ / 2) << 16 | static_cast<std::uint32_t>(columns_);
  words_[2] = static_cast<std::uint32_t>(geometry.height) << 16 | static_cast<std::uint32_t>(geometry.width);
}

MapTable::MapTable(std::vector<std::uint32_t> words, Scan scan) : words_(std::move(words)) {
  if (words_.size() < 4) throw std::invalid_argument(fmt::format("a table of {} words", words_.size()));
  if ((words_[0] & 0xFFFFFF00U) != kHeader) throw std::invalid_argument("no table header of version 1");
  spacing_x_log2_ = static_cast<int>(words_[0] >> 4 & 0xFU);
  spacing_y_log2_ = static_cast<int>(words_[0] & 0xFU);
  geometry_ = {static_cast<int>(words_[2] & 0xFFFFU), static_cast<int>(words_[2] >> 16), scan};
  columns_ = static_cast<int>(words_[1] & 0xFFFFU);
  rows_ = static_cast<int>(words_[1] >> 16) * 2;
  if (spacing_x_log2_ > MapTable::kLargestSpacingLog2 || spacing_y_log2_ > MapTable::kLargestSpacingLog2) {
    throw std::invalid_argument("a spacing of more than 64 pixels");
  }
  if (columns_ != control_count(geometry_.width, spacing_x_log2_) ||
      rows_ != (control_count(geometry_.height, spacing_y_log2_) + 1) / 2 * 2) {
    throw std::invalid_argument(
        fmt::format("{} x {} control points for {}x{} pixels", columns_, rows_, geometry_.width, geometry_.height));
  }
  if (words_.size() != static_cast<std::size_t>(columns_) * rows_ + 4) {
    throw std::invalid_argument(fmt::format("{} words for {} x {} control points", words_.size(), columns_, rows_));
  }
  if (crc32_words(std::span(words_).first(words_.size() - 1)) != words_.back()) {
    throw std::invalid_argument("a wrong CRC");
  }
}

void MapTable::seal() { words_.back() = crc32_words(std::span(words_).first(words_.size() - 1)); }

std::uint32_t MapTable::encode(Point source) {
  const double x = std::floor((source.x + kControlOffset_px) * kControlScale + 0.5);
  const double y = std::floor((source.y + kControlOffset_px) * kControlScale + 0.5);
  // 0xFFFF is left out, so that no control point looks like kUnmapped.
  if (!(x >= 0 && x < 0xFFFF && y >= 0 && y < 0xFFFF)) return kUnmapped;
  return static_cast<std::uint32_t>(y) << 16 | static_cast<std::uint32_t>(x);
}

std::optional<MapTable::Expanded> MapTable::expand(int x, int y) const {
  const int column = x >> spacing_x_log2_;
  const int row = y >> spacing_y_log2_;
  const int fx = (x & ((1 << spacing_x_log2_) - 1)) << (6 - spacing_x_log2_);
  const int fy = (y & ((1 << spacing_y_log2_) - 1)) << (6 - spacing_y_log2_);
  // A control point without a weight need not exist.
  const std::uint32_t top = control(column, row);
  const std::uint32_t bottom = fy != 0 ? control(column, row + 1) : top;
  const std::uint32_t top_right = fx != 0 ? control(column + 1, row) : top;
  const std::uint32_t bottom_right = fx == 0 ? bottom : fy == 0 ? top_right : control(column + 1, row + 1);
  if (top == kUnmapped || bottom == kUnmapped || top_right == kUnmapped || bottom_right == kUnmapped) {
    return std::nullopt;
  }
  const auto weigh = [&](auto coordinate) {
    const int left = coordinate(top) * (64 - fy) + coordinate(bottom) * fy;
    const int right = coordinate(top_right) * (64 - fy) + coordinate(bottom_right) * fy;
    return left * (64 - fx) + right * fx - (kControlOffset_px << kFractionBits);
  };
  return Expanded{weigh([](std::uint32_t point) { return static_cast<int>(point & 0xFFFFU); }),
                  weigh([](std::uint32_t point) { return static_cast<int>(point >> 16); })};
}

std::optional<MapTable::Source> MapTable::round(const Expanded& expanded, int weight_bits) const {
  const int drop = kFractionBits - weight_bits;
  const std::int64_t half = std::int64_t{1} << (drop - 1);
  const std::int64_t x = (expanded.x + half) >> drop;
  const std::int64_t y = (expanded.y + half) >> drop;
  if (x < 0 || y < 0 || x > std::int64_t{geometry_.width - 1} << weight_bits ||
      y > std::int64_t{geometry_.height - 1} << weight_bits) {
    return std::nullopt;
  }
  return Source{static_cast<int>(x), static_cast<int>(y)};
}

std::optional<MapTable::Source> MapTable::source(int x, int y, int weight_bits) const {
  const auto expanded = expand(x, y);
  return expanded ? round(*expanded, weight_bits) : std::nullopt;
}

Image MapTable::supervised(int weight_bits) const {
  Image result(geometry_.width, geometry_.height);
  for (int y0 = 0; y0 < geometry_.height; y0 += 1 << spacing_y_log2_) {
    const int y1 = std::min(y0 + (1 << spacing_y_log2_), geometry_.height);
    for (int x0 = 0; x0 < geometry_.width; x0 += 1 << spacing_x_log2_) {
      const int x1 = std::min(x0 + (1 << spacing_x_log2_), geometry_.width);
      // Bilinear, and the image is convex: what holds at the corners of a cell holds in it, where all of its control
      // points take part.
      const bool one_piece = x1 - x0 > 1 && y1 - y0 > 1;
      if (one_piece && source(x0, y0, weight_bits) && source(x1 - 1, y0, weight_bits) &&
          source(x0, y1 - 1, weight_bits) && source(x1 - 1, y1 - 1, weight_bits)) {
        for (int y = y0; y < y1; ++y) std::fill_n(&result.at(x0, y), x1 - x0, std::uint8_t{1});
        continue;
      }
      for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) result.at(x, y) = source(x, y, weight_bits) ? 1 : 0;
      }
    }
  }
  return result;
}

std::optional<int> lookahead_for(const MachineProfile& profile, RowReach reach) {
  const int lookahead = std::max(reach.ahead, kSmallestLookahead);
  if (lookahead > profile.largest_lookahead() || reach.behind > profile.rows_behind()) return std::nullopt;
  return lookahead;
}

int MapSet::lookahead() const {
  int largest = 0;
  for (const CompiledMap& map : maps) largest = std::max(largest, map.report.lookahead);
  return largest;
}

std::uint32_t MapSet::rig_crc() const {
  return rig.empty() ? 0 : crc32(std::span(reinterpret_cast<const std::uint8_t*>(rig.data()), rig.size()));
}

std::vector<double> thickness_mm(const MapTable& table, int weight_bits, const CameraPair& cameras,
                                 double tolerance_px) {
  const ScanGeometry& scan = table.geometry();
  std::vector<double> thickness(static_cast<std::size_t>(scan.width) * scan.height, std::nan(""));
  for (int y = 0; y < scan.height; ++y) {
    for (int x = 0; x < scan.width; ++x) {
      // Without the rounding to the weights, which would hide the shape.
      if (!table.source(x, y, weight_bits)) continue;
      const auto source = *table.expand(x, y);
      const Point right{std::ldexp(static_cast<double>(source.x), -MapTable::kFractionBits),
                        std::ldexp(static_cast<double>(source.y), -MapTable::kFractionBits)};
      thickness[static_cast<std::size_t>(y) * scan.width + x] = cameras.thickness_mm(
          scan.to_frame({static_cast<double>(x), static_cast<double>(y)}), scan.to_frame(right), tolerance_px);
    }
  }
  return thickness;
}

}  // namespace horopter
