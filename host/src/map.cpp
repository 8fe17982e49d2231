// SPDX-License-Identifier: Apache-2.0
#include "horopter/map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "horopter/crc32.hpp"
#include "horopter/error.hpp"
#include "horopter/map_json.hpp"
#include "horopter/output.hpp"

namespace horopter {
namespace {

constexpr std::uint32_t kHeader = 0x484D0100;  // "HM", version 1
constexpr int kLargestSpacingLog2 = 6;
constexpr int kControlOffset_px = 64;  // control points are unsigned: 0 means -64 px
constexpr int kControlScale = 32;      // steps per pixel
constexpr int kSmallestLookahead = 8;  // more than the filters' reach in rows; nothing is won below

int control_count(int size, int spacing_log2) { return (size + (1 << spacing_log2) - 1) / (1 << spacing_log2) + 1; }

/// Why a pixel is not supervised, or that it is.
enum class Reason : std::uint8_t { none, outside, scale, no_source };

/// The skin's own mapping of every pixel of a scan, in scan coordinates.
struct ExactMap {
  std::vector<float> x;
  std::vector<float> y;
  std::vector<Reason> reason;
};

ExactMap evaluate(const Skin& skin, const ScanGeometry& geometry, double smallest_scale) {
  const std::size_t pixels = static_cast<std::size_t>(geometry.width) * geometry.height;
  ExactMap map{std::vector<float>(pixels), std::vector<float>(pixels), std::vector<Reason>(pixels, Reason::none)};
  const double step = geometry.row_step();
  std::size_t i = 0;
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x, ++i) {
      const Point left = geometry.to_frame({static_cast<double>(x), static_cast<double>(y)});
      const auto frame_source = skin.source(left);
      if (!frame_source) {
        map.reason[i] = Reason::no_source;
        continue;
      }
      const Point source = geometry.from_frame(*frame_source);
      map.x[i] = static_cast<float>(source.x);
      map.y[i] = static_cast<float>(source.y);
      // Largest singular value of the derivatives in scan coordinates: source pixels per left pixel.
      const auto [a, b_frame, c_frame, d] = skin.derivatives(left);
      const double b = b_frame * step;
      const double c = c_frame / step;
      const double sum = a * a + b * b + c * c + d * d;
      const double determinant = a * d - b * c;
      const double largest =
          std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4 * determinant * determinant))));
      if (!(largest * smallest_scale <= 1.0 + 1e-9)) {
        map.reason[i] = Reason::scale;
      } else if (source.x < 0 || source.y < 0 || source.x > geometry.width - 1 || source.y > geometry.height - 1) {
        map.reason[i] = Reason::outside;
      }
    }
  }
  return map;
}

MapTable control_grid(const Skin& skin, const ScanGeometry& geometry, int nx, int ny) {
  MapTable table(geometry, nx, ny);
  for (int row = 0; row < table.rows(); ++row) {
    for (int column = 0; column < table.columns(); ++column) {
      const Point left = geometry.to_frame({std::ldexp(column, nx), std::ldexp(row, ny)});
      auto source = skin.source(left);
      if (source) source = geometry.from_frame(*source);
      table.set_control(column, row, MapTable::encode(source));
    }
  }
  return table;
}

double distance(double x, double y) { return std::sqrt(x * x + y * y); }

constexpr double kFraction = 1.0 / (1 << MapTable::kFractionBits);

/// Unmaps a control point of each cell with a pixel that must not be supervised although its corners are mapped.
void exclude(MapTable& table, const ExactMap& exact, int weight_bits) {
  const auto& [width, height, scan] = table.geometry();
  std::size_t i = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x, ++i) {
      if (exact.reason[i] != Reason::scale && exact.reason[i] != Reason::no_source) continue;
      if (table.source(x, y, weight_bits)) {
        table.set_control(x >> table.spacing_x_log2(), y >> table.spacing_y_log2(), MapTable::kUnmapped);
      }
    }
  }
}

/// Fills the report of a finished table. False as soon as an error beyond `largest_error_px` is seen.
bool measure(const MapTable& table, const ExactMap& exact, int weight_bits, double largest_error_px,
             MapReport& report) {
  const int width = table.geometry().width;
  const int height = table.geometry().height;
  report = {};
  report.spacing_x = 1 << table.spacing_x_log2();
  report.spacing_y = 1 << table.spacing_y_log2();
  report.pool_bytes = table.pool_bytes();
  report.pixels = static_cast<std::int64_t>(width) * height;
  std::vector<float> errors;
  errors.reserve(exact.reason.size());
  report.reach = {-height, -height};
  const int fraction_mask = (1 << weight_bits) - 1;
  std::size_t i = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x, ++i) {
      const auto source = table.source(x, y, weight_bits);
      if (!source) {
        switch (exact.reason[i]) {
          case Reason::none:
            ++report.grid;
            break;
          case Reason::outside:
            ++report.outside;
            break;
          case Reason::scale:
            ++report.scale;
            break;
          case Reason::no_source:
            ++report.no_source;
            break;
        }
        continue;
      }
      ++report.supervised;
      const auto expanded = *table.expand(x, y);
      const double error = distance(static_cast<double>(expanded.x) * kFraction - exact.x[i],
                                    static_cast<double>(expanded.y) * kFraction - exact.y[i]);
      if (error > largest_error_px) return false;
      errors.push_back(static_cast<float>(error));
      const double rounded =
          distance(std::ldexp(source->x, -weight_bits) - exact.x[i], std::ldexp(source->y, -weight_bits) - exact.y[i]);
      report.rounded_largest_px = std::max(report.rounded_largest_px, rounded);
      const int first = source->y >> weight_bits;
      const int last = first + ((source->y & fraction_mask) != 0 ? 1 : 0);
      report.reach.behind = std::max(report.reach.behind, y - first);
      report.reach.ahead = std::max(report.reach.ahead, last - y);
    }
  }
  if (report.supervised == 0) report.reach = {};
  if (!errors.empty()) {
    const auto at = errors.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(errors.size() - 1));
    std::ranges::nth_element(errors, at);
    report.error_99_px = *at;
    report.error_largest_px = *std::max_element(at, errors.end());
  }
  return true;
}

/// Share of the pixels that the skin supervises for which the table is within `error_px`; lost ones are not.
bool share_within(const MapReport& report, const MapLimits& limits) {
  return report.error_99_px <= limits.error_px &&
         static_cast<double>(report.grid) <= (1 - limits.share) * static_cast<double>(report.supervised + report.grid);
}

std::string rows_text(RowReach reach) {
  return fmt::format("y{:+d} to y{:+d} ({} rows)", -reach.behind, reach.ahead, reach.ahead + reach.behind + 1);
}

}  // namespace

std::vector<ScanGeometry> scans_of(const MachineProfile& profile, int image_width, int image_height) {
  if (!profile.takes_fields()) return {{image_width, image_height, Scan::progressive}};
  return {{image_width, (image_height + 1) / 2, Scan::even_field}, {image_width, image_height / 2, Scan::odd_field}};
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
  seal();
}

MapTable::MapTable(std::vector<std::uint32_t> words, Scan scan) : words_(std::move(words)) {
  if (words_.size() < 4) throw std::invalid_argument(fmt::format("a table of {} words", words_.size()));
  if ((words_[0] & 0xFFFFFF00U) != kHeader) throw std::invalid_argument("no table header of version 1");
  spacing_x_log2_ = static_cast<int>(words_[0] >> 4 & 0xFU);
  spacing_y_log2_ = static_cast<int>(words_[0] & 0xFU);
  geometry_ = {static_cast<int>(words_[2] & 0xFFFFU), static_cast<int>(words_[2] >> 16), scan};
  columns_ = static_cast<int>(words_[1] & 0xFFFFU);
  rows_ = static_cast<int>(words_[1] >> 16) * 2;
  if (spacing_x_log2_ > kLargestSpacingLog2 || spacing_y_log2_ > kLargestSpacingLog2) {
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

std::uint32_t MapTable::encode(std::optional<Point> source) {
  if (!source) return kUnmapped;
  const double x = std::floor((source->x + kControlOffset_px) * kControlScale + 0.5);
  const double y = std::floor((source->y + kControlOffset_px) * kControlScale + 0.5);
  // 0xFFFF is left out, so that no control point looks like kUnmapped.
  if (!(x >= 0 && x < 0xFFFF && y >= 0 && y < 0xFFFF)) return kUnmapped;
  return static_cast<std::uint32_t>(y) << 16 | static_cast<std::uint32_t>(x);
}

std::optional<MapTable::Expanded> MapTable::expand(int x, int y) const {
  const int column = x >> spacing_x_log2_;
  const int row = y >> spacing_y_log2_;
  const int fx = (x & ((1 << spacing_x_log2_) - 1)) << (6 - spacing_x_log2_);
  const int fy = (y & ((1 << spacing_y_log2_) - 1)) << (6 - spacing_y_log2_);
  Expanded sum;
  for (int right = 0; right < 2; ++right) {
    const int weight_x = right != 0 ? fx : 64 - fx;
    if (weight_x == 0) continue;
    Expanded vertical;
    for (int bottom = 0; bottom < 2; ++bottom) {
      const int weight_y = bottom != 0 ? fy : 64 - fy;
      if (weight_y == 0) continue;
      const std::uint32_t point = control(column + right, row + bottom);
      if (point == kUnmapped) return std::nullopt;
      vertical.x += std::int64_t{point & 0xFFFFU} * weight_y;
      vertical.y += std::int64_t{point >> 16} * weight_y;
    }
    sum.x += vertical.x * weight_x;
    sum.y += vertical.y * weight_x;
  }
  constexpr std::int64_t kOffset = std::int64_t{kControlOffset_px} << kFractionBits;
  return Expanded{sum.x - kOffset, sum.y - kOffset};
}

std::optional<MapTable::Source> MapTable::source(int x, int y, int weight_bits) const {
  const auto expanded = expand(x, y);
  if (!expanded) return std::nullopt;
  const int drop = kFractionBits - weight_bits;
  const std::int64_t half = std::int64_t{1} << (drop - 1);
  const std::int64_t source_x = (expanded->x + half) >> drop;
  const std::int64_t source_y = (expanded->y + half) >> drop;
  if (source_x < 0 || source_y < 0 || source_x > std::int64_t{geometry_.width - 1} << weight_bits ||
      source_y > std::int64_t{geometry_.height - 1} << weight_bits) {
    return std::nullopt;
  }
  return Source{static_cast<int>(source_x), static_cast<int>(source_y)};
}

std::optional<int> lookahead_for(const MachineProfile& profile, RowReach reach) {
  const int lookahead = std::max(reach.ahead, kSmallestLookahead);
  if (lookahead > profile.largest_lookahead() || reach.behind > profile.rows_behind()) return std::nullopt;
  return lookahead;
}

CompiledMap compile_map(const Skin& skin, const MachineProfile& profile, const ScanGeometry& geometry,
                        const MapLimits& limits) {
  const ExactMap exact = evaluate(skin, geometry, limits.smallest_scale);

  struct Spacing {
    int nx, ny;
    std::size_t bytes;
  };
  std::vector<Spacing> spacings;
  for (int nx = 0; nx <= kLargestSpacingLog2; ++nx) {
    for (int ny = 0; ny <= kLargestSpacingLog2; ++ny) {
      const std::size_t rows = (control_count(geometry.height, ny) + 1) / 2 * 2;
      spacings.push_back({nx, ny, control_count(geometry.width, nx) * rows * sizeof(std::uint32_t)});
    }
  }
  std::ranges::sort(spacings, {}, &Spacing::bytes);

  // Fewest bytes first. A skin with a ragged border may lose more than its share in every grid that fits: then the
  // grid that loses least.
  std::optional<CompiledMap> best;
  for (const Spacing& spacing : spacings) {
    if (spacing.bytes > static_cast<std::size_t>(profile.pool_bytes)) break;
    MapTable table = control_grid(skin, geometry, spacing.nx, spacing.ny);
    exclude(table, exact, profile.weight_bits);
    MapReport report;
    if (!measure(table, exact, profile.weight_bits, limits.largest_error_px, report)) continue;
    if (report.error_99_px > limits.error_px) continue;
    const bool good = share_within(report, limits);
    if (!good && best && best->report.grid <= report.grid) continue;
    table.seal();
    report.crc = table.crc();
    best = CompiledMap{std::move(table), report};
    if (good) break;
  }
  if (!best) {
    throw std::runtime_error(
        fmt::format("no table of at most {} bytes (the pool of profile {}) stays within {} px of it",
                    profile.pool_bytes, profile.name, limits.largest_error_px));
  }
  const auto lookahead = lookahead_for(profile, best->report.reach);
  if (!lookahead) {
    throw std::runtime_error(
        fmt::format("left row y needs the right rows {}; the store of profile {} holds {} rows, of "
                    "which it gives {}",
                    rows_text(best->report.reach), profile.name, profile.store_rows,
                    rows_text({profile.rows_behind(), profile.largest_lookahead()})));
  }
  best->report.lookahead = *lookahead;
  return *std::move(best);
}

int MapSet::lookahead() const {
  int largest = 0;
  for (const CompiledMap& map : maps) largest = std::max(largest, map.report.lookahead);
  return largest;
}

MapSet compile_maps(const SkinFile& skin, const MachineProfile& profile, int image_width, int image_height) {
  MapSet set{std::string(profile.name), image_width, image_height, skin.skin->description(), {}};
  RowReach reach;
  for (const ScanGeometry& geometry : scans_of(profile, image_width, image_height)) {
    try {
      set.maps.push_back(compile_map(*skin.skin, profile, geometry));
    } catch (const std::runtime_error& error) {
      throw FileError(skin.path, "surface",
                      fmt::format("this skin does not fit profile {}: {}", profile.name, error.what()),
                      "a skin that needs less");
    }
    reach.ahead = std::max(reach.ahead, set.maps.back().report.reach.ahead);
    reach.behind = std::max(reach.behind, set.maps.back().report.reach.behind);
  }
  const auto lookahead = lookahead_for(profile, reach);
  if (!lookahead) {
    throw FileError(skin.path, "surface", fmt::format("both fields together need the right rows {}", rows_text(reach)),
                    fmt::format("what {} rows of profile {} hold", profile.store_rows, profile.name));
  }
  for (CompiledMap& map : set.maps) map.report.lookahead = *lookahead;
  return set;
}

// The file ------------------------------------------------------------------------------------------------------------
namespace {

constexpr std::uint32_t kMagic = 0x50414D48;  // "HMAP", least significant byte first
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kNameWords = 4;
constexpr std::size_t kHeaderWords = 3 + kNameWords + 3;  // magic, version, words in all, name, width, height, tables

void append_text(std::vector<std::uint32_t>& words, const std::string& text) {
  words.push_back(static_cast<std::uint32_t>(text.size()));
  for (std::size_t i = 0; i < text.size(); i += 4) {
    std::uint32_t word = 0;
    for (std::size_t j = 0; j < 4 && i + j < text.size(); ++j) {
      word |= std::uint32_t{static_cast<std::uint8_t>(text[i + j])} << (8 * j);
    }
    words.push_back(word);
  }
}

}  // namespace

void save_maps(const MapSet& maps, const std::filesystem::path& path) {
  std::vector<std::uint32_t> words{kMagic, kVersion, 0};
  std::array<char, kNameWords * 4> name{};
  std::copy_n(maps.profile.begin(), std::min(maps.profile.size(), name.size()), name.begin());
  for (std::size_t i = 0; i < name.size(); i += 4) {
    std::uint32_t word = 0;
    for (std::size_t j = 0; j < 4; ++j) word |= std::uint32_t{static_cast<std::uint8_t>(name[i + j])} << (8 * j);
    words.push_back(word);
  }
  words.push_back(static_cast<std::uint32_t>(maps.image_width));
  words.push_back(static_cast<std::uint32_t>(maps.image_height));
  words.push_back(static_cast<std::uint32_t>(maps.maps.size()));
  append_text(words, maps.skin);
  for (const CompiledMap& map : maps.maps) {
    words.push_back(static_cast<std::uint32_t>(map.table.geometry().scan));
    append_text(words, to_json(map.report).dump());
    words.push_back(static_cast<std::uint32_t>(map.table.words().size()));
    words.insert(words.end(), map.table.words().begin(), map.table.words().end());
  }
  words[2] = static_cast<std::uint32_t>(words.size() + 1);
  words.push_back(crc32_words(words));
  std::vector<std::uint8_t> bytes;
  bytes.reserve(words.size() * 4);
  for (const std::uint32_t word : words) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(word >> shift));
  }
  write_file(path, bytes);
}

MapSet load_maps(const std::filesystem::path& path) {
  const std::string file = path.string();
  const std::string expected = "a mapping table made by `horopter map` (.hmap, version 1)";
  const auto bytes = read_file(path, expected);
  std::vector<std::uint32_t> words(bytes.size() / 4);
  for (std::size_t i = 0; i < words.size() * 4; ++i) words[i / 4] |= std::uint32_t{bytes[i]} << (i % 4 * 8);
  if (words.empty() || words[0] != kMagic) throw FileError(file, "byte 0", "not a mapping table", expected);
  if (words.size() > 1 && words[1] != kVersion) {
    throw FileError(file, "byte 4", fmt::format("version {}", words[1]), expected);
  }
  if (words.size() < kHeaderWords + 1 || bytes.size() < std::size_t{words[2]} * 4) {
    throw FileError(file, fmt::format("byte {}", bytes.size()), "the file is truncated",
                    words.size() > 2 ? fmt::format("{} bytes", std::size_t{words[2]} * 4) : expected);
  }
  if (bytes.size() != std::size_t{words[2]} * 4) {
    throw FileError(file, fmt::format("byte {}", std::size_t{words[2]} * 4), "more data than the header tells",
                    expected);
  }
  if (crc32_words(std::span(words).first(words.size() - 1)) != words.back()) {
    throw FileError(file, fmt::format("byte {}", bytes.size() - 4), "wrong CRC: the file was altered", expected);
  }
  // The CRC holds: what follows can only fail for a file that was made wrongly.
  std::size_t at = 3;
  const auto take = [&](std::size_t count) {
    if (count > words.size() - 1 - at) throw FileError(file, fmt::format("byte {}", at * 4), "bad lengths", expected);
    at += count;
    return std::span(words).subspan(at - count, count);
  };
  const auto text = [&](std::size_t length) {
    std::string result;
    for (const std::uint32_t word : take((length + 3) / 4)) {
      for (int shift = 0; shift < 32; shift += 8) result += static_cast<char>(word >> shift);
    }
    result.resize(length);
    return result;
  };
  MapSet set;
  set.profile = text(kNameWords * 4);
  set.profile.resize(std::strlen(set.profile.c_str()));
  set.image_width = static_cast<int>(take(1)[0]);
  set.image_height = static_cast<int>(take(1)[0]);
  const std::uint32_t tables = take(1)[0];
  set.skin = text(take(1)[0]);
  for (std::uint32_t i = 0; i < tables; ++i) {
    const std::size_t place = at * 4;
    try {
      const std::uint32_t scan = take(1)[0];
      if (scan > 2) throw std::invalid_argument(fmt::format("scan {}", scan));
      MapReport report = map_report_from_json(nlohmann::json::parse(text(take(1)[0])));
      const auto table_words = take(take(1)[0]);
      MapTable table({table_words.begin(), table_words.end()}, static_cast<Scan>(scan));
      set.maps.push_back({std::move(table), report});
    } catch (const std::invalid_argument& error) {
      throw FileError(file, fmt::format("byte {}, table {}", place, i), error.what(), expected);
    } catch (const nlohmann::json::exception& error) {
      throw FileError(file, fmt::format("byte {}, table {}", place, i), error.what(), expected);
    }
  }
  return set;
}

// Reports -------------------------------------------------------------------------------------------------------------

std::string crc_text(std::uint32_t crc) { return fmt::format("{:08x}", crc); }

std::string_view scan_name(Scan scan) {
  switch (scan) {
    case Scan::progressive:
      return "progressive";
    case Scan::even_field:
      return "even";
    case Scan::odd_field:
      return "odd";
  }
  return "?";
}

nlohmann::ordered_json to_json(const MapReport& report) {
  return {
      {"spacing_x", report.spacing_x},
      {"spacing_y", report.spacing_y},
      {"bytes", report.pool_bytes},
      {"crc", crc_text(report.crc)},
      {"rows_behind", report.reach.behind},
      {"rows_ahead", report.reach.ahead},
      {"lookahead", report.lookahead},
      {"pixels", report.pixels},
      {"supervised", report.supervised},
      {"unsupervised",
       {{"outside", report.outside}, {"scale", report.scale}, {"no_source", report.no_source}, {"grid", report.grid}}},
      {"error_99_px", report.error_99_px},
      {"error_largest_px", report.error_largest_px},
      {"rounded_largest_px", report.rounded_largest_px}};
}

MapReport map_report_from_json(const nlohmann::json& json) {
  MapReport report;
  report.spacing_x = json.at("spacing_x");
  report.spacing_y = json.at("spacing_y");
  report.pool_bytes = json.at("bytes");
  report.crc = static_cast<std::uint32_t>(std::stoul(json.at("crc").get<std::string>(), nullptr, 16));
  report.reach = {json.at("rows_behind"), json.at("rows_ahead")};
  report.lookahead = json.at("lookahead");
  report.pixels = json.at("pixels");
  report.supervised = json.at("supervised");
  const auto& unsupervised = json.at("unsupervised");
  report.outside = unsupervised.at("outside");
  report.scale = unsupervised.at("scale");
  report.no_source = unsupervised.at("no_source");
  report.grid = unsupervised.at("grid");
  report.error_99_px = json.at("error_99_px");
  report.error_largest_px = json.at("error_largest_px");
  report.rounded_largest_px = json.at("rounded_largest_px");
  return report;
}

nlohmann::ordered_json to_json(const MapSet& maps) {
  nlohmann::ordered_json json{
      {"profile", maps.profile}, {"width", maps.image_width}, {"height", maps.image_height}, {"skin", maps.skin}};
  for (const CompiledMap& map : maps.maps) {
    nlohmann::ordered_json table{{"scan", scan_name(map.table.geometry().scan)},
                                 {"width", map.table.geometry().width},
                                 {"height", map.table.geometry().height},
                                 {"columns", map.table.columns()},
                                 {"rows", map.table.rows()}};
    table.update(to_json(map.report));
    json["tables"].push_back(std::move(table));
  }
  return json;
}

std::vector<std::uint8_t> draw_map(const MapTable& table, int weight_bits) {
  const auto& [width, height, scan] = table.geometry();
  cv::Mat hsv(height, width, CV_8UC3, cv::Scalar(0, 0, 40));
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
      // Hue in OpenCV's half degrees; contour lines every 8 pixels of displacement.
      const double hue = (std::atan2(d[1], d[0]) / CV_PI + 1) * 90;
      const bool contour = std::fmod(cv::norm(d), 8.0) < 0.5;
      hsv.at<cv::Vec3b>(y, x) =
          cv::Vec3b(static_cast<std::uint8_t>(std::fmod(hue, 180)),
                    static_cast<std::uint8_t>(60 + 180 * cv::norm(d) / largest), contour ? 150 : 235);
    }
  }
  cv::Mat picture;
  cv::cvtColor(hsv, picture, cv::COLOR_HSV2BGR);
  if (table.spacing_x_log2() >= 2 && table.spacing_y_log2() >= 2) {
    for (int row = 0; row < table.rows(); ++row) {
      for (int column = 0; column < table.columns(); ++column) {
        const int x = column << table.spacing_x_log2();
        const int y = row << table.spacing_y_log2();
        if (x >= width || y >= height) continue;
        const bool mapped = table.control(column, row) != MapTable::kUnmapped;
        picture.at<cv::Vec3b>(y, x) = mapped ? cv::Vec3b(0, 0, 0) : cv::Vec3b(160, 160, 160);
      }
    }
  }
  return {picture.datastart, picture.dataend};
}

}  // namespace horopter
