// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "horopter/base/crc32.hpp"

namespace horopter {
namespace {

constexpr int kSmallestLookahead = 8;  // more than the filters' reach in rows; nothing is won below

hls::table::Geometry table_geometry(const ScanGeometry& geometry, int spacing_x_log2, int spacing_y_log2) {
  return {geometry.width, geometry.height, spacing_x_log2, spacing_y_log2};
}

}  // namespace

std::vector<ScanGeometry> scans_of(const MachineProfile& profile, int image_width, int image_height) {
  if (!profile.takes_fields()) return {{image_width, image_height, Scan::progressive}};
  return {{image_width, (image_height + 1) / 2, Scan::even_field}, {image_width, image_height / 2, Scan::odd_field}};
}

std::size_t MapTable::pool_bytes(const ScanGeometry& geometry, int spacing_x_log2, int spacing_y_log2) {
  return table_geometry(geometry, spacing_x_log2, spacing_y_log2).control_words() * sizeof(std::uint32_t);
}

MapTable::MapTable(ScanGeometry geometry, int spacing_x_log2, int spacing_y_log2)
    : geometry_(geometry),
      words_(hls::table::write(table_geometry(geometry, spacing_x_log2, spacing_y_log2), {},
                               [](int, int) { return kUnmapped; })) {
  header_ = hls::table::read(words_);
}

MapTable::MapTable(std::vector<std::uint32_t> words, Scan scan)
    : header_(hls::table::read(words)), words_(std::move(words)) {
  geometry_ = {header_.geometry.width, header_.geometry.height, scan};
  if (crc32_words(std::span(words_).first(words_.size() - 1)) != words_.back()) {
    throw std::invalid_argument("a wrong CRC");
  }
}

void MapTable::seal(const hls::table::Facts& facts) {
  words_ = hls::table::write(header_.geometry, facts, [&](int column, int row) { return control(column, row); });
  header_ = hls::table::read(words_);
  words_.back() = crc32_words(std::span(words_).first(words_.size() - 1));
}

std::uint32_t MapTable::encode(Point source) { return hls::table::encode_control(source.x, source.y); }

/// Of the control points that have a weight all must count.
template <class Counts>
std::optional<MapTable::Expanded> MapTable::expand_if(int x, int y, Counts counts) const {
  const int column = x >> spacing_x_log2();
  const int row = y >> spacing_y_log2();
  const int fx = (x & ((1 << spacing_x_log2()) - 1)) << (6 - spacing_x_log2());
  const int fy = (y & ((1 << spacing_y_log2()) - 1)) << (6 - spacing_y_log2());
  // A control point without a weight need not exist.
  const std::uint32_t top = control(column, row);
  const std::uint32_t bottom = fy != 0 ? control(column, row + 1) : top;
  const std::uint32_t top_right = fx != 0 ? control(column + 1, row) : top;
  const std::uint32_t bottom_right = fx == 0 ? bottom : fy == 0 ? top_right : control(column + 1, row + 1);
  if (!counts(top) || !counts(bottom) || !counts(top_right) || !counts(bottom_right)) return std::nullopt;
  const auto weigh = [&](auto coordinate) {
    const int left = coordinate(top) * (64 - fy) + coordinate(bottom) * fy;
    const int right = coordinate(top_right) * (64 - fy) + coordinate(bottom_right) * fy;
    return left * (64 - fx) + right * fx - (hls::table::control_offset_px << kFractionBits);
  };
  return Expanded{weigh([](std::uint32_t point) { return static_cast<int>(point & 0xFFFFU); }),
                  weigh([](std::uint32_t point) { return hls::table::control_y(point); })};
}

std::optional<MapTable::Expanded> MapTable::expand(int x, int y) const {
  return expand_if(x, y, hls::table::is_of_skin);
}

std::optional<MapTable::Expanded> MapTable::expand_around(int x, int y) const {
  return expand_if(x, y, [](std::uint32_t point) { return point != kUnmapped; });
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
  for (int y0 = 0; y0 < geometry_.height; y0 += 1 << spacing_y_log2()) {
    const int y1 = std::min(y0 + (1 << spacing_y_log2()), geometry_.height);
    for (int x0 = 0; x0 < geometry_.width; x0 += 1 << spacing_x_log2()) {
      const int x1 = std::min(x0 + (1 << spacing_x_log2()), geometry_.width);
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
