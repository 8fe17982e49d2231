// SPDX-License-Identifier: Apache-2.0
// Mapping tables: a grid of control points that the hardware expands to the source of every left pixel (T7, T10;
// thesis 10.4.2). Dense tables are those of spacing 1.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "horopter/image.hpp"
#include "horopter/profile.hpp"
#include "horopter/skin.hpp"

namespace horopter {

/// Which rows of the full frame a table is for.
enum class Scan { progressive = 0, even_field = 1, odd_field = 2 };

/// Size of what the hardware is fed with (a frame, or a field), and where it lies in the full frame:
/// y = 2·y_f + parity for fields. Left and right fields of a pair have the same parity.
struct ScanGeometry {
  int width = 0;
  int height = 0;
  Scan scan = Scan::progressive;

  int row_step() const { return scan == Scan::progressive ? 1 : 2; }
  int first_row() const { return scan == Scan::odd_field ? 1 : 0; }
  Point to_frame(Point scanned) const { return {scanned.x, row_step() * scanned.y + first_row()}; }
  Point from_frame(Point frame) const { return {frame.x, (frame.y - first_row()) / row_step()}; }
  friend bool operator==(const ScanGeometry&, const ScanGeometry&) = default;
};

/// What a profile makes of an image: one geometry, or two for profiles that take fields.
std::vector<ScanGeometry> scans_of(const MachineProfile& profile, int image_width, int image_height);

/// A table in upload format: three header words, control points, CRC-32.
class MapTable {
 public:
  static constexpr std::uint32_t kUnmapped = 0xFFFFFFFFU;
  /// Fraction bits of an expanded coordinate before it is rounded to the weights: 5 of the control point, 6 + 6 of the
  /// position in the cell.
  static constexpr int kFractionBits = 17;

  MapTable(ScanGeometry geometry, int spacing_x_log2, int spacing_y_log2);
  /// Checks header, length, control points and CRC. Throws std::invalid_argument. Upload words know no scan.
  MapTable(std::vector<std::uint32_t> words, Scan scan);

  const ScanGeometry& geometry() const { return geometry_; }
  int spacing_x_log2() const { return spacing_x_log2_; }
  int spacing_y_log2() const { return spacing_y_log2_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }  ///< an even number: control rows are stored in pairs
  const std::vector<std::uint32_t>& words() const { return words_; }
  std::uint32_t crc() const { return words_.back(); }
  /// Control points only: what the pool must hold.
  std::size_t pool_bytes() const { return (words_.size() - 4) * sizeof(std::uint32_t); }

  std::uint32_t control(int column, int row) const { return words_[index(column, row)]; }
  void set_control(int column, int row, std::uint32_t value) { words_[index(column, row)] = value; }
  /// To be called when the last control point is set.
  void seal();

  /// Nearest control point to a source, or kUnmapped when it is out of the range of -64 … 1983.97 px.
  static std::uint32_t encode(std::optional<Point> source);

  struct Expanded {
    std::int64_t x = 0;  ///< in 2^-kFractionBits pixels
    std::int64_t y = 0;
  };
  /// As the hardware does it, before rounding to the weights. Nothing when a control point with a weight is unmapped.
  std::optional<Expanded> expand(int x, int y) const;

  struct Source {
    int x = 0;  ///< in 2^-weight_bits pixels
    int y = 0;
  };
  /// The source that the hardware reads, rounded half up to the weights; nothing when unmapped or outside the image.
  std::optional<Source> source(int x, int y, int weight_bits) const;

 private:
  std::size_t index(int column, int row) const {
    return 3 + 2 * (static_cast<std::size_t>(row / 2) * columns_ + column) + row % 2;
  }

  ScanGeometry geometry_;
  int spacing_x_log2_ = 0;
  int spacing_y_log2_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint32_t> words_;
};

/// Right rows that the pixels of left row y read: y - behind … y + ahead.
struct RowReach {
  int behind = 0;
  int ahead = 0;
};

/// The setting of LOOKAHEAD for which the store holds these rows, y - (ROWS/2 - 2) … y + LOOKAHEAD; nothing when none
/// does.
std::optional<int> lookahead_for(const MachineProfile& profile, RowReach reach);

struct MapReport {
  int spacing_x = 0;
  int spacing_y = 0;
  std::size_t pool_bytes = 0;
  std::uint32_t crc = 0;
  RowReach reach;
  int lookahead = 0;
  std::int64_t pixels = 0;
  std::int64_t supervised = 0;
  // Unsupervised pixels, by reason (T9). The borders that the filters' windows take are not counted here.
  std::int64_t outside = 0;    ///< the source lies outside the right image
  std::int64_t scale = 0;      ///< reduced to less than 1/2: source pixels would be skipped (thesis 7.5)
  std::int64_t no_source = 0;  ///< beyond the horizon
  std::int64_t grid = 0;       ///< lost because a control point of the cell is unmapped
  // Distance of the hardware's expansion, before rounding to the weights, from the skin's own mapping.
  double error_99_px = 0;
  double error_largest_px = 0;
  double rounded_largest_px = 0;  ///< the same after rounding: up to 0.71/2^weight_bits more
};

struct CompiledMap {
  MapTable table;
  MapReport report;
};

struct MapLimits {
  double share = 0.99;             ///< of the pixels …
  double error_px = 1.0 / 16;      ///< … stay within this distance of the skin
  double largest_error_px = 0.25;  ///< all do
  double smallest_scale = 0.5;
};

/// The table of the fewest bytes within the limits. Throws std::runtime_error when the skin needs more rows than the
/// store holds, or no table within the limits fits the pool.
CompiledMap compile_map(const Skin& skin, const MachineProfile& profile, const ScanGeometry& geometry,
                        const MapLimits& limits = {});

/// Tables of one skin for one profile and image size: as many as the profile makes scans of an image.
struct MapSet {
  std::string profile;
  int image_width = 0;
  int image_height = 0;
  std::string skin;  ///< description, for people
  std::vector<CompiledMap> maps;

  /// The LOOKAHEAD that serves all tables.
  int lookahead() const;
};

/// Throws FileError naming the skin's file.
MapSet compile_maps(const SkinFile& skin, const MachineProfile& profile, int image_width, int image_height);

/// `.hmap`: versioned header, tables, reports, CRC-32. Throws FileError.
void save_maps(const MapSet& maps, const std::filesystem::path& path);
MapSet load_maps(const std::filesystem::path& path);

/// Picture of where each left pixel's source lies: hue by direction and strength by length of the displacement,
/// unsupervised pixels dark, control points as dots. Interleaved blue, green, red.
std::vector<std::uint8_t> draw_map(const MapTable& table, int weight_bits);

}  // namespace horopter
