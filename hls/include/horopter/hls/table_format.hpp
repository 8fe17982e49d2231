// SPDX-License-Identifier: Apache-2.0
// The format of mapping tables, version 3: what is uploaded into the machine, in words of 32 bits.
//
//   word  bits
//   0     31..8 "HM" and the version, 7 the table has spans, 6..4 and 2..0: control points every 2^n px in x and in y; 3
//         is 0
//   1     26..16 pairs of control rows, 11..0 control columns
//   2     27..16 height, 11..0 width of the incoming images (frames or fields), px
//   3     11..0 words of facts that follow, 15..12 sub-sampling (pixels of a row that are one pixel of the result),
//         16 areas are known, 17 shifts are known
//   Facts about what the table lets the machine see. Pixels are those of the result, after sub-sampling:
//   4, 5  pixels that the rule `thesis`, `compete` can judge: all of their support has a source. 0: no such rule
//   6, 7  all other pixels, which the machine calls unsupervised whatever the images show: more in a frame are a fault
//   8     shifts along the row, px, that mean a place in front of both cameras: 15..0 lowest, 31..16 highest, two's
//         complement. The hypothesis pixel that shows what left pixel x sees is at x + shift: 0 is the skin. From a
//         point at infinity to one as near as the cameras are apart, over the whole skin, to first order in the shift:
//         large ones are within 5 %. 0 where it is not known
//   9 …   areas, where they are known: for each block of 32×32 px, row by row, the area of the skin that one pixel
//         sees, mm², as a byte of five bits e and three bits m: (1 + m/8) · 2^(e-12), from 0.00024 to 983,040. Four to
//         a word, the first lowest; the last word is filled with 0. The largest of the block, rounded up, so that no
//         object is taken for a smaller one; of a block that does not meet the skin, that of the nearest one which does
//   Spans, where the table has them, of each row of the incoming image from 0 on: 11..0 the first column, 27..16 the
//   column after the last between which pixels are on the skin; 0 of a row without any. The others are 0, and so is a last
//   word where the height is odd. A pixel outside of its row's span is not supervised, whatever the control points say;
//   they still show what both cameras see there. So a cell that the outline of a skin cuts is supervised up to it
//   Control points, pair by pair of rows, column by column, even row first: 31..16 y, 15..0 x of the source in the
//   right image, (px + 64) · 32; y is below 0xA000. Points around the skin, which show the machine what both cameras see
//   there, but are not supervised: y is 0xA000 + ⌊(px + 64) · 16⌋. All ones: no source
//   CRC-32 (IEEE 802.3) of all words before it as little-endian bytes
//
// The machine stores areas, spans and control points, and of the facts words 6 and 7. It reads over the others, which the
// CRC protects: they cost no memory. In its pool, of two words each, areas and spans begin with a new pair.
// A table made without a rig knows no areas and no shifts.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace horopter::hls::table {

// scripts/generate-profiles makes rtl/store/horopter_table_pkg.sv of these, by their names.
inline constexpr std::uint32_t magic = 0x484D;    // "HM"
inline constexpr std::uint32_t version = 3;       // of the format
inline constexpr int slots = 15;                  // tables that a machine holds, from 0; the next number means none
inline constexpr int smallest_result_width = 32;  // px of a frame's result that a machine takes
inline constexpr int smallest_height = 16;        // rows of it
inline constexpr int header_words = 4;            // before the facts
inline constexpr int fact_words = 5;              // before the areas
inline constexpr int largest_spacing_log2 = 6;    // of control points
inline constexpr int area_block_log2 = 5;         // side of a block that has one area
inline constexpr int unknown_area = 0xFF;         // code of a pixel's, where a table knows none: the largest
inline constexpr int control_offset_px = 64;      // control points are unsigned: 0 means -64 px
inline constexpr int control_scale = 32;          // steps per pixel
inline constexpr int around_skin = 0xA000;        // y of points around the skin, from here on
inline constexpr std::uint32_t unmapped = 0xFFFFFFFF;  // a control point without a source

constexpr int control_points(int size, int spacing_log2) {
  return ((size + (1 << spacing_log2) - 1) >> spacing_log2) + 1;
}

/// Words 0 to 2.
struct Geometry {
  int width = 0;  // of the incoming images, px
  int height = 0;
  int spacing_x_log2 = 0;
  int spacing_y_log2 = 0;
  bool spans = false;  // a row has one

  [[nodiscard]] constexpr int columns() const { return control_points(width, spacing_x_log2); }
  [[nodiscard]] constexpr int row_pairs() const { return (control_points(height, spacing_y_log2) + 1) / 2; }
  [[nodiscard]] constexpr std::size_t control_words() const {
    return std::size_t{2} * static_cast<std::size_t>(columns()) * static_cast<std::size_t>(row_pairs());
  }
  [[nodiscard]] constexpr std::size_t span_words() const {
    return spans ? 2 * static_cast<std::size_t>((height + 1) / 2) : 0;
  }
  /// What the machine's pool holds. `area_words`: of the facts.
  [[nodiscard]] constexpr std::size_t pool_words(std::size_t area_words) const {
    return (area_words + 1) / 2 * 2 + span_words() + control_words();
  }
  /// Of a control point among the control words.
  [[nodiscard]] constexpr std::size_t control_index(int column, int row) const {
    return 2 * (static_cast<std::size_t>(row / 2) * static_cast<std::size_t>(columns()) +
                static_cast<std::size_t>(column)) +
           static_cast<std::size_t>(row % 2);
  }
  [[nodiscard]] constexpr std::uint32_t size_word() const {
    return static_cast<std::uint32_t>(height) << 16 | static_cast<std::uint32_t>(width);
  }
};

inline constexpr std::uint32_t has_spans = 1U << 7;  // of word 0

/// Whether word 0 is one of this version.
constexpr bool is_first_word(std::uint32_t word) {
  constexpr int largest = largest_spacing_log2;
  return word >> 8 == (magic << 8 | version) && static_cast<int>(word >> 4 & 7U) <= largest &&
         static_cast<int>(word & 15U) <= largest;
}

/// Pixels of a row that are on the skin: first … end - 1; none where both are 0.
struct Span {
  int first = 0;
  int end = 0;
  friend constexpr bool operator==(const Span&, const Span&) = default;

  [[nodiscard]] constexpr bool holds(int x) const { return first <= x && x < end; }
  [[nodiscard]] constexpr std::uint32_t word() const {
    return static_cast<std::uint32_t>(end) << 16 | static_cast<std::uint32_t>(first);
  }
  static constexpr Span of(std::uint32_t word) {
    return {static_cast<int>(word & 0xFFFU), static_cast<int>(word >> 16 & 0xFFFU)};
  }
};

/// Of words 0 to 2; nothing where they contradict each other. The machine judges them likewise.
constexpr std::optional<Geometry> read_geometry(std::span<const std::uint32_t> words) {
  constexpr std::uint32_t largest_size = 0xFFF;
  const std::uint32_t width = words[2] & 0xFFFFU;
  const std::uint32_t height = words[2] >> 16;
  if (!is_first_word(words[0]) || width == 0 || width > largest_size || height == 0 || height > largest_size) return {};
  const Geometry geometry{static_cast<int>(width), static_cast<int>(height), static_cast<int>(words[0] >> 4 & 7U),
                          static_cast<int>(words[0] & 15U), (words[0] & has_spans) != 0};
  const auto columns = static_cast<std::uint32_t>(geometry.columns());
  const auto pairs = static_cast<std::uint32_t>(geometry.row_pairs());
  if (words[1] != (pairs << 16 | columns)) return {};
  return geometry;
}

inline constexpr std::uint32_t areas_known = 1U << 16;   // of word 3
inline constexpr std::uint32_t shifts_known = 1U << 17;  // the same

/// Word 3: words between it and the first span, or control point; nothing where there are too few, or areas that are not
/// known, or none that are. The machine judges it likewise.
constexpr std::optional<std::size_t> read_fact_words(std::uint32_t word) {
  const std::uint32_t count = word & 0xFFFU;
  if (count < fact_words || (count > fact_words) != ((word & areas_known) != 0)) return {};
  return count;
}

/// Words 6 and 7. The machine takes more of them in a frame as a fault.
constexpr std::uint32_t unsupervised_pixels(std::span<const std::uint32_t> words, bool compete) {
  return words[header_words + (compete ? 3 : 2)] & 0xFFFFFFU;
}

/// Code of an area, mm², the next larger one where there is none of it; at the ends of the range for what lies beyond.
inline std::uint8_t encode_area(double area_mm2) {
  int exponent = 0;
  const double mantissa = std::frexp(std::clamp(area_mm2, 0x1p-12, 0x1.Ep19), &exponent);  // 0.5 … 1
  const long steps = static_cast<long>(std::ceil(mantissa * 16)) - 8;                      // 8 is the next octave's 0
  return static_cast<std::uint8_t>(8 * (exponent - 1 + 12) + steps);
}
inline double decode_area(std::uint8_t code) { return std::ldexp(8 + (code & 7), (code >> 3) - 12 - 3); }

/// Control point of a source, px; `unmapped` when it is not finite or out of the range of x -64 … 1983.9 px,
/// y -64 … 1215.9 px.
inline std::uint32_t encode_control(double x_px, double y_px) {
  // Cut off where they are converted: floor, as they are not negative then.
  const double x = (x_px + control_offset_px) * control_scale + 0.5;
  const double y = (y_px + control_offset_px) * control_scale + 0.5;
  // 0xFFFF is left out, so that no control point looks like `unmapped`.
  if (!(x >= 0 && x < 0xFFFF && y >= 0 && y < around_skin)) return unmapped;
  return static_cast<std::uint32_t>(y) << 16 | static_cast<std::uint32_t>(x);
}
inline bool is_of_skin(std::uint32_t control) { return control >> 16 < around_skin; }
/// A control point of the skin as one around it; others as they are.
inline std::uint32_t around_skin_instead(std::uint32_t control) {
  return is_of_skin(control) ? (around_skin + (control >> 17)) << 16 | (control & 0xFFFFU) : control;
}
/// (px + 64) · 32, of either kind.
inline int control_y(std::uint32_t control) {
  const int y = static_cast<int>(control >> 16);
  return y < around_skin ? y : 2 * (y - around_skin);
}

struct ShiftRange {
  int lowest_px = 0;
  int highest_px = 0;
  friend constexpr bool operator==(const ShiftRange&, const ShiftRange&) = default;
};

/// Word 3 and what follows up to spans and control points.
struct Facts {
  int subsample = 1;
  std::uint32_t judgeable_by_thesis = 0;  // pixels of the result
  std::uint32_t judgeable_by_compete = 0;
  std::optional<ShiftRange> shifts;
  std::vector<std::uint8_t> areas;  // codes, row by row of blocks; empty: not known
  friend bool operator==(const Facts&, const Facts&) = default;

  [[nodiscard]] int result_width(const Geometry& geometry) const { return geometry.width / subsample; }
  [[nodiscard]] std::uint32_t result_pixels(const Geometry& geometry) const {
    return static_cast<std::uint32_t>(result_width(geometry)) * static_cast<std::uint32_t>(geometry.height);
  }
  static constexpr int blocks(int size) { return (size + (1 << area_block_log2) - 1) >> area_block_log2; }
  [[nodiscard]] int area_columns(const Geometry& geometry) const { return blocks(result_width(geometry)); }
  [[nodiscard]] int area_rows(const Geometry& geometry) const { return blocks(geometry.height); }
  [[nodiscard]] std::size_t area_count(const Geometry& geometry) const {
    return static_cast<std::size_t>(area_columns(geometry)) * static_cast<std::size_t>(area_rows(geometry));
  }
  static constexpr std::size_t words_of(std::size_t areas) { return (areas + 3) / 4; }
};

/// Words of a table, without CRC: 0 stands for it. `control(column, row)` gives the words of the control points. A
/// geometry with spans needs one of each row.
template <class Control>
std::vector<std::uint32_t> write(const Geometry& geometry, const Facts& facts, Control control,
                                 std::span<const Span> spans = {}) {
  if (spans.size() != (geometry.spans ? static_cast<std::size_t>(geometry.height) : 0)) {
    throw std::invalid_argument("as many spans as the table has rows");
  }
  const std::size_t area_words = Facts::words_of(facts.areas.size());
  const std::uint32_t pixels = facts.result_pixels(geometry);
  const ShiftRange shifts = facts.shifts.value_or(ShiftRange{});
  std::vector<std::uint32_t> words{
      magic << 16 | version << 8 | (geometry.spans ? has_spans : 0U) |
          static_cast<std::uint32_t>(geometry.spacing_x_log2) << 4 |
          static_cast<std::uint32_t>(geometry.spacing_y_log2),
      static_cast<std::uint32_t>(geometry.row_pairs()) << 16 | static_cast<std::uint32_t>(geometry.columns()),
      geometry.size_word(),
      (facts.shifts ? shifts_known : 0U) | (facts.areas.empty() ? 0U : areas_known) |
          static_cast<std::uint32_t>(facts.subsample) << 12 | static_cast<std::uint32_t>(fact_words + area_words),
      facts.judgeable_by_thesis,
      facts.judgeable_by_compete,
      pixels - facts.judgeable_by_thesis,
      pixels - facts.judgeable_by_compete,
      static_cast<std::uint32_t>(shifts.highest_px) << 16 | (static_cast<std::uint32_t>(shifts.lowest_px) & 0xFFFFU)};
  words.resize(words.size() + area_words);
  for (std::size_t i = 0; i < facts.areas.size(); ++i) {
    words[header_words + fact_words + i / 4] |= std::uint32_t{facts.areas[i]} << (8 * (i % 4));
  }
  words.reserve(words.size() + geometry.span_words() + geometry.control_words() + 1);
  for (const Span& span : spans) words.push_back(span.word());
  if (spans.size() % 2 != 0) words.push_back(0);
  for (int pair = 0; pair < geometry.row_pairs(); ++pair) {
    for (int column = 0; column < geometry.columns(); ++column) {
      words.push_back(control(column, 2 * pair));
      words.push_back(control(column, 2 * pair + 1));
    }
  }
  words.push_back(0);
  return words;
}

/// Where everything is before the control points.
struct Header {
  Geometry geometry;
  Facts facts;
  std::size_t first_span = 0;     // word
  std::size_t first_control = 0;  // word

  [[nodiscard]] std::size_t pool_words() const { return geometry.pool_words(first_span - header_words - fact_words); }
};

/// Throws std::invalid_argument that says what is wrong with the words of a table. Does not look at the CRC.
inline Header read(std::span<const std::uint32_t> words) {
  const auto require = [](bool holds, const std::string& otherwise) {
    if (!holds) throw std::invalid_argument(otherwise);
  };
  const auto text = [](auto number) { return std::to_string(number); };
  require(words.size() > header_words, "a table of " + text(words.size()) + " words");
  require(words[0] >> 16 == magic, "no mapping table");
  const std::uint32_t found = words[0] >> 8 & 0xFFU;
  require(found == version, "table format " + text(found) + "; this program reads " + text(version) +
                                ": make the map again with `horopter map`");
  require(is_first_word(words[0]), "control points more than 64 pixels apart");
  const auto geometry = read_geometry(words);
  require(geometry.has_value(), text(words[1] & 0xFFFFU) + " x " + text(2 * (words[1] >> 16)) + " control points for " +
                                    text(words[2] & 0xFFFFU) + "x" + text(words[2] >> 16) + " pixels");
  Header header{*geometry, {}, 0, 0};
  Facts& facts = header.facts;
  const auto count = read_fact_words(words[3]);
  require(count.has_value(), text(words[3] & 0xFFFU) + " words of facts, with areas " +
                                 ((words[3] & areas_known) != 0 ? "known" : "not known"));
  header.first_span = header_words + *count;
  header.first_control = header.first_span + geometry->span_words();
  require(words.size() == header.first_control + geometry->control_words() + 1,
          text(words.size()) + " words for " + text(*count) + " words of facts, " + text(geometry->span_words()) +
              " of spans and " + text(geometry->columns()) + " x " + text(2 * geometry->row_pairs()) +
              " control points");
  const bool knows_areas = (words[3] & areas_known) != 0;
  const bool knows_shifts = (words[3] & shifts_known) != 0;
  facts.subsample = static_cast<int>(words[3] >> 12 & 15U);
  require(words[3] >> 18 == 0 && (facts.subsample == 1 || facts.subsample == 2), "bad flags or sub-sampling");
  const std::size_t areas = knows_areas ? facts.area_count(*geometry) : 0;
  require(*count == fact_words + Facts::words_of(areas),
          text(*count) + " words of facts for " + text(areas) + " areas");
  facts.judgeable_by_thesis = words[4];
  facts.judgeable_by_compete = words[5];
  const std::uint32_t pixels = facts.result_pixels(*geometry);
  require(words[4] <= pixels && words[5] <= pixels && words[6] == pixels - words[4] && words[7] == pixels - words[5],
          "judgeable and unsupervised pixels that are not together those of the result");
  const ShiftRange shifts{static_cast<std::int16_t>(words[8]), static_cast<std::int16_t>(words[8] >> 16)};
  require(knows_shifts ? shifts.lowest_px <= 0 && shifts.highest_px >= 0 : words[8] == 0,
          "shifts that do not hold the skin's, or are there and not known");
  if (knows_shifts) facts.shifts = shifts;
  facts.areas.resize(areas);
  for (std::size_t i = 0; i < (areas + 3) / 4 * 4; ++i) {
    const auto code = static_cast<std::uint8_t>(words[header_words + fact_words + i / 4] >> (8 * (i % 4)));
    if (i < areas) facts.areas[i] = code;
    if (i >= areas && code != 0) throw std::invalid_argument("areas beyond the last block");
  }
  for (std::size_t row = 0; row < geometry->span_words(); ++row) {
    const std::uint32_t word = words[header.first_span + row];
    const Span span = Span::of(word);
    const bool in_image = row < static_cast<std::size_t>(geometry->height);
    if (word == 0 || (in_image && word == span.word() && span.first < span.end && span.end <= geometry->width))
      continue;
    throw std::invalid_argument("a span of row " + text(row) + " from column " + text(word & 0xFFFFU) + " to before " +
                                text(word >> 16) + " of " + text(geometry->width) + "x" + text(geometry->height) +
                                " pixels");
  }
  return header;
}

}  // namespace horopter::hls::table
