// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "horopter/base/angle.hpp"
#include "horopter/base/crc32.hpp"
#include "horopter/calib/vectorised.hpp"

namespace horopter {
namespace {

constexpr int kSmallestLookahead = 8;  // more than the filters' reach in rows; nothing is won below

hls::table::Geometry table_geometry(const ScanGeometry& geometry, int spacing_x_log2, int spacing_y_log2,
                                    bool spans = false) {
  return {geometry.width, geometry.height, spacing_x_log2, spacing_y_log2, spans};
}

/// Where a row of a cell begins and ends, expanded downwards only, and how far its pixels are apart in 2^n/64 of it.
struct CellRow {
  int left_x, right_x, left_y, right_y;
  int apart_log2;
};
/// Rounded places that are read inside the image: 0 … last.
struct ReadImage {
  int drop;  ///< bits that rounding leaves out
  int last_x, last_y;
};

/// Which pixels of the row read inside the image, as MapTable::source says it of one.
[[gnu::always_inline]] inline void find_read(const CellRow& row, const ReadImage& image, std::size_t count,
                                             std::uint8_t* pixels) {
  constexpr int kOffset = hls::table::control_offset_px << MapTable::kFractionBits;
  const int half = 1 << (image.drop - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const int part = static_cast<int>(i) << row.apart_log2;
    const int x = (row.left_x * (64 - part) + row.right_x * part - kOffset + half) >> image.drop;
    const int y = (row.left_y * (64 - part) + row.right_y * part - kOffset + half) >> image.drop;
    pixels[i] = static_cast<std::uint8_t>((x >= 0) & (y >= 0) & (x <= image.last_x) & (y <= image.last_y));
  }
}

}  // namespace

std::vector<ScanGeometry> scans_of(const MachineProfile& profile, int image_width, int image_height) {
  if (!profile.takes_fields()) return {{image_width, image_height, Scan::progressive}};
  return {{image_width, (image_height + 1) / 2, Scan::even_field}, {image_width, image_height / 2, Scan::odd_field}};
}

std::size_t MapTable::pool_bytes(const ScanGeometry& geometry, int spacing_x_log2, int spacing_y_log2, bool spans,
                                 std::size_t areas) {
  return table_geometry(geometry, spacing_x_log2, spacing_y_log2, spans)
             .pool_words(hls::table::Facts::words_of(areas)) *
         sizeof(std::uint32_t);
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

void MapTable::set_spans(std::span<const hls::table::Span> spans) { write(facts(), spans); }

void MapTable::write(const hls::table::Facts& facts, std::span<const hls::table::Span> spans) {
  hls::table::Geometry geometry = header_.geometry;
  geometry.spans = !spans.empty();
  // As they come: even and odd row in turn.
  const std::uint32_t* next = &words_[header_.first_control];
  std::vector<std::uint32_t> words = hls::table::write(geometry, facts, [&](int, int) { return *next++; }, spans);
  header_ = hls::table::read(words);
  words_ = std::move(words);
}

void MapTable::seal(const hls::table::Facts& facts) {
  std::vector<hls::table::Span> spans;
  for (int row = 0; has_spans() && row < geometry_.height; ++row) spans.push_back(span(row));
  write(facts, spans);
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
  if (!span(y).holds(x)) return std::nullopt;
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
  // Bilinear, and the image is convex: what holds at the corners of a cell holds in it.
  enum : std::uint8_t { of_skin = 1, inside = 3 };
  const ReadImage read{kFractionBits - weight_bits, (geometry_.width - 1) << weight_bits,
                       (geometry_.height - 1) << weight_bits};
  const auto kind_of = [&](std::uint32_t point) -> std::uint8_t {
    const auto x = static_cast<int>(point & 0xFFFFU) - hls::table::control_offset_px * hls::table::control_scale;
    const auto y = static_cast<int>(point >> 16) - hls::table::control_offset_px * hls::table::control_scale;
    const bool holds =
        static_cast<bool>((x >= 0) & (y >= 0) & (x <= (geometry_.width - 1) * hls::table::control_scale) &
                          (y <= (geometry_.height - 1) * hls::table::control_scale));
    return hls::table::is_of_skin(point) ? (holds ? inside : of_skin) : 0;
  };
  const int cells = ((geometry_.width - 1) >> spacing_x_log2()) + 1;
  std::vector<std::uint8_t> upper(static_cast<std::size_t>(cells) + 1);
  std::vector<std::uint8_t> lower(upper.size());
  const auto look = [&](int row, std::vector<std::uint8_t>& kinds) {
    for (int column = 0; column <= cells; ++column) {
      kinds[static_cast<std::size_t>(column)] = kind_of(control(column, row));
    }
  };
  look(0, lower);
  for (int y0 = 0; y0 < geometry_.height; y0 += 1 << spacing_y_log2()) {
    const int y1 = std::min(y0 + (1 << spacing_y_log2()), geometry_.height);
    std::swap(upper, lower);
    look((y0 >> spacing_y_log2()) + 1, lower);
    const auto is_whole = [&](int column) {
      const auto c = static_cast<std::size_t>(column);
      return (upper[c] & upper[c + 1] & lower[c] & lower[c + 1]) == inside;
    };
    for (int column = 0; column < cells; ++column) {
      if (upper[static_cast<std::size_t>(column)] == 0) continue;  // it takes part everywhere
      const int x0 = column << spacing_x_log2();
      const bool whole = is_whole(column);
      while (whole && column + 1 < cells && is_whole(column + 1)) ++column;
      const int x1 = std::min((column + 1) << spacing_x_log2(), geometry_.width);
      for (int y = y0; y < y1; ++y) {
        std::uint8_t* const pixels = &result.at(x0, y);
        if (whole) {
          std::fill_n(pixels, x1 - x0, std::uint8_t{1});
          continue;
        }
        const auto c = static_cast<std::size_t>(column);
        const int fy = (y - y0) << (6 - spacing_y_log2());
        if (fy != 0 && lower[c] == 0) break;
        // A control point without a weight need not exist.
        const bool edge = upper[c + 1] == 0 || (fy != 0 && lower[c + 1] == 0);
        const auto down = [&](int at, auto coordinate) {
          const int row = y0 >> spacing_y_log2();
          const int top = coordinate(control(at, row)) * (64 - fy);
          return fy != 0 ? top + coordinate(control(at, row + 1)) * fy : top;
        };
        const auto x_of = [](std::uint32_t point) { return static_cast<int>(point & 0xFFFFU); };
        const int right = edge ? column : column + 1;
        const CellRow cell_row{down(column, x_of), down(right, x_of), down(column, hls::table::control_y),
                               down(right, hls::table::control_y), 6 - spacing_x_log2()};
        calib::vectorised<find_read>(cell_row, read, static_cast<std::size_t>(edge ? 1 : x1 - x0), pixels);
      }
    }
  }
  for (int y = 0; has_spans() && y < geometry_.height; ++y) {
    const hls::table::Span held = span(y);
    std::uint8_t* const pixels = &result.at(0, y);
    std::fill(pixels, pixels + held.first, std::uint8_t{0});
    std::fill(pixels + held.end, pixels + geometry_.width, std::uint8_t{0});
  }
  return result;
}

std::optional<int> lookahead_for(const MachineProfile& profile, RowReach reach) {
  const int lookahead = std::max(reach.ahead, kSmallestLookahead);
  if (lookahead > profile.largest_lookahead() || reach.behind > profile.rows_behind()) return std::nullopt;
  return lookahead;
}

std::string store_that_holds(const MachineProfile& profile, RowReach reach) {
  const auto other = std::ranges::find_if(profiles(), [&](const MachineProfile& p) {
    return p.of_stages() == profile.of_stages() && lookahead_for(p, reach);
  });
  return other == profiles().end() ? "" : fmt::format("; profile {} holds them", other->name);
}

double largest_roll_deg(const MachineProfile& profile) {
  const double half_width = profile.largest_image_width() / 2.0;
  const double half_height = profile.largest_image_height() / 2.0;
  const double largest_px = profile.fields_per_image() * std::min(profile.rows_behind(), profile.largest_lookahead());
  constexpr double kStep_deg = 0.1;
  constexpr int kPoints = 400;  // of an edge
  const auto fits = [&](double angle_deg) {
    const double sine = std::sin(angle_deg * kDegree);
    const double cosine = std::cos(angle_deg * kDegree);
    // Where both images hold a point, its row changes most on the border of one of them; by symmetry, of either.
    const auto change = [&](double x, double y) {
      const double to_x = cosine * x - sine * y;
      const double to_y = sine * x + cosine * y;
      return std::abs(to_x) <= half_width && std::abs(to_y) <= half_height ? std::abs(to_y - y) : 0;
    };
    for (int i = 0; i <= kPoints; ++i) {
      const double along = 2.0 * i / kPoints - 1;
      if (change(half_width, along * half_height) > largest_px || change(along * half_width, half_height) > largest_px)
        return false;
    }
    return true;
  };
  double angle_deg = 0;
  while (angle_deg + kStep_deg < 90 && fits(angle_deg + kStep_deg)) angle_deg += kStep_deg;
  return angle_deg;
}

std::vector<const MapTable*> MapSet::tables() const {
  std::vector<const MapTable*> all;
  for (const CompiledMap& map : maps) all.push_back(&map.table);
  return all;
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
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y) * scan.width + x; };
  std::vector<Eigen::Vector3d> places(static_cast<std::size_t>(scan.width) * scan.height,
                                      Eigen::Vector3d::Constant(std::nan("")));
  for (int y = 0; y < scan.height; ++y) {
    for (int x = 0; x < scan.width; ++x) {
      // Without the rounding to the weights, which would hide the shape.
      if (!table.source(x, y, weight_bits)) continue;
      const auto source = *table.expand(x, y);
      const Point right{std::ldexp(static_cast<double>(source.x), -MapTable::kFractionBits),
                        std::ldexp(static_cast<double>(source.y), -MapTable::kFractionBits)};
      if (const auto place =
              cameras.place_mm(scan.to_frame({static_cast<double>(x), static_cast<double>(y)}), scan.to_frame(right))) {
        places[at(x, y)] = *place;
      }
    }
  }
  // From one neighbour to the other, or from the place itself to the only one.
  const auto step = [&](int x, int y, int dx, int dy) -> Eigen::Vector3d {
    const auto place = [&](int sign) {
      const int to_x = x + sign * dx;
      const int to_y = y + sign * dy;
      const bool inside = to_x >= 0 && to_x < scan.width && to_y >= 0 && to_y < scan.height;
      return inside && places[at(to_x, to_y)].allFinite() ? places[at(to_x, to_y)] : places[at(x, y)];
    };
    return place(1) - place(-1);
  };
  std::vector<double> thickness(places.size(), std::nan(""));
  for (int y = 0; y < scan.height; ++y) {
    for (int x = 0; x < scan.width; ++x) {
      if (!places[at(x, y)].allFinite()) continue;
      const Eigen::Vector3d normal = step(x, y, 1, 0).cross(step(x, y, 0, 1));
      thickness[at(x, y)] = cameras.thickness_mm(places[at(x, y)], normal, tolerance_px);
    }
  }
  return thickness;
}

}  // namespace horopter
