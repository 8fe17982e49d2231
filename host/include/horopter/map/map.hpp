// SPDX-License-Identifier: Apache-2.0
// Mapping tables: a grid of control points that the hardware expands to the source of every left pixel (T7, T10;
// thesis 10.4.2). Dense tables are those of spacing 1.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "horopter/base/crc32.hpp"
#include "horopter/base/profile.hpp"
#include "horopter/hls/table_format.hpp"
#include "horopter/image/image.hpp"
#include "horopter/image/scan.hpp"
#include "horopter/skin/rig_skin.hpp"
#include "horopter/skin/skin.hpp"

namespace horopter {

/// What a profile makes of an image: one geometry, or two for profiles that take fields.
std::vector<ScanGeometry> scans_of(const MachineProfile& profile, int image_width, int image_height);

/// A table in upload format (horopter/hls/table_format.hpp).
class MapTable {
 public:
  static constexpr std::uint32_t kUnmapped = hls::table::unmapped;
  /// Fraction bits of an expanded coordinate before it is rounded to the weights: 5 of the control point, 6 + 6 of the
  /// position in the cell.
  static constexpr int kFractionBits = 17;
  static constexpr int kLargestSpacingLog2 = hls::table::largest_spacing_log2;

  /// All control points unmapped, and facts that say so; to be sealed.
  MapTable(ScanGeometry geometry, int spacing_x_log2, int spacing_y_log2);
  /// Checks header, facts, length and CRC. Throws std::invalid_argument. Upload words know no scan.
  MapTable(std::vector<std::uint32_t> words, Scan scan);

  const ScanGeometry& geometry() const { return geometry_; }
  int spacing_x_log2() const { return header_.geometry.spacing_x_log2; }
  int spacing_y_log2() const { return header_.geometry.spacing_y_log2; }
  int columns() const { return header_.geometry.columns(); }
  int rows() const { return 2 * header_.geometry.row_pairs(); }  ///< control rows are stored in pairs
  const hls::table::Facts& facts() const { return header_.facts; }
  std::int64_t result_pixels() const { return header_.facts.result_pixels(header_.geometry); }
  const std::vector<std::uint32_t>& words() const { return words_; }
  std::uint32_t crc() const { return words_.back(); }
  /// Areas, spans and control points: what the pool must hold.
  std::size_t pool_bytes() const { return header_.pool_words() * sizeof(std::uint32_t); }
  static std::size_t pool_bytes(const ScanGeometry& geometry, int spacing_x_log2, int spacing_y_log2,
                                bool spans = false, std::size_t areas = 0);

  std::uint32_t control(int column, int row) const { return words_[index(column, row)]; }
  void set_control(int column, int row, std::uint32_t value) { words_[index(column, row)] = value; }
  bool has_spans() const { return header_.geometry.spans; }
  /// The columns of a row that may be supervised: all, of a table without spans.
  hls::table::Span span(int row) const {
    return has_spans() ? hls::table::Span::of(words_[header_.first_span + static_cast<std::size_t>(row)])
                       : hls::table::Span{0, geometry_.width};
  }
  /// One of each row; of no pixel {0, 0}. Throws std::invalid_argument for others, or such as leave the row.
  void set_spans(std::span<const hls::table::Span> spans);
  /// To be called when the last control point, and the spans are set. `facts` must be true of the control points (facts_of in
  /// table_facts.hpp): the machine's limits depend on them.
  void seal(const hls::table::Facts& facts);

  /// Whether the control point's source is one of the skin: not around it, and not missing.
  bool is_of_skin(int column, int row) const { return hls::table::is_of_skin(control(column, row)); }
  /// Nearest control point to a source, or kUnmapped when it is out of range (table_format.hpp).
  static std::uint32_t encode(Point source);

  struct Expanded {
    std::int64_t x = 0;  ///< in 2^-kFractionBits pixels
    std::int64_t y = 0;
  };
  /// As the hardware does it, before rounding to the weights. Nothing when a control point with a weight is not one of the skin, or the pixel is outside of its row's span.
  std::optional<Expanded> expand(int x, int y) const;
  /// The same of the skin and of what is around it.
  std::optional<Expanded> expand_around(int x, int y) const;

  struct Source {
    int x = 0;  ///< in 2^-weight_bits pixels
    int y = 0;
  };
  /// Rounded half up to the weights; nothing outside the image.
  std::optional<Source> round(const Expanded& expanded, int weight_bits) const;
  /// The source that the hardware reads: expanded and rounded; nothing when unmapped or outside the image.
  std::optional<Source> source(int x, int y, int weight_bits) const;
  /// Which pixels have a source: 1, or 0.
  Image supervised(int weight_bits) const;

 private:
  void write(const hls::table::Facts& facts, std::span<const hls::table::Span> spans);
  template <class Counts>
  std::optional<Expanded> expand_if(int x, int y, Counts counts) const;
  std::size_t index(int column, int row) const {
    return header_.first_control + header_.geometry.control_index(column, row);
  }

  ScanGeometry geometry_;
  hls::table::Header header_;
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
/// The end of a message that they do not fit: "; profile … holds them", if one with the same stages does, or nothing.
std::string store_that_holds(const MachineProfile& profile, RowReach reach);
/// By how many degrees the cameras may be rolled against each other, about the middle of the largest image of square
/// pixels, that the store holds the rows which that alone needs.
double largest_roll_deg(const MachineProfile& profile);

struct MapReport {
  int spacing_x = 0;
  int spacing_y = 0;
  std::size_t pool_bytes = 0;
  std::uint32_t crc = 0;
  RowReach reach;
  int lookahead = 0;
  std::int64_t pixels = 0;
  std::int64_t checked = 0;  ///< pixels compared with the skin: all, or a sample; the shares below follow from them
  /// Pixels by reason (T9), supervised ones at Reason::none. The borders that the filters' windows take are not
  /// counted.
  std::array<std::int64_t, kReasonCount> by_reason{};
  // Distance of the hardware's expansion, before rounding to the weights, from the skin's own mapping.
  double error_99_px = 0;
  double error_largest_px = 0;
  double rounded_largest_px = 0;  ///< the same after rounding: up to 0.71/2^weight_bits more; of all pixels only

  std::int64_t count(Reason reason) const { return by_reason[static_cast<std::size_t>(reason)]; }
  std::int64_t supervised() const { return count(Reason::none); }
  /// Share of the pixels that could be supervised which the grid loses.
  double lost_share() const {
    const auto lost = static_cast<double>(count(Reason::grid));
    return lost > 0 ? lost / (lost + static_cast<double>(supervised())) : 0;
  }
};

struct CompiledMap {
  MapTable table;
  MapReport report;
};

/// Tables of one skin for one profile and image size: as many as the profile makes scans of an image.
struct MapSet {
  std::string profile;
  int image_width = 0;
  int image_height = 0;
  std::string skin;  ///< description, for people
  std::string rig;   ///< the two cameras, as text of rig.yaml; empty for a skin that needs none
  std::vector<CompiledMap> maps;

  /// All tables; they live as long as the set.
  std::vector<const MapTable*> tables() const;
  /// The LOOKAHEAD that serves all tables.
  int lookahead() const;
  /// CRC-32 of the rig's text, by which a rig is told from another; 0 without.
  std::uint32_t rig_crc() const;
};

/// `.hmap`: versioned header, tables, reports, CRC-32. Throws FileError.
void save_maps(const MapSet& maps, const std::filesystem::path& path);
MapSet load_maps(const std::filesystem::path& path);
/// Whether a file with these bytes means to be one.
bool is_table(std::span<const std::uint8_t> file);
/// Adds the bytes of a table, or of a skin.yaml and the meshes that it names. Throws FileError, which says `expected`.
void add_skin_files(const std::filesystem::path& skin, const std::string& expected, Crc32& crc);

/// Thickness of the skin along the left line of sight, of each pixel of the table's scan, row by row; NaN where it is
/// not supervised, or no neighbour is. `tolerance_px`: disparity tolerance D of 11.1, in pixels of the frame.
std::vector<double> thickness_mm(const MapTable& table, int weight_bits, const CameraPair& cameras,
                                 double tolerance_px);

}  // namespace horopter
