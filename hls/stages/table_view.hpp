// SPDX-License-Identifier: Apache-2.0
// A mapping table of somebody else's, as the native engine reads it.
#pragma once

#include <cstdint>
#include <span>

#include "horopter/hls/table_format.hpp"
#include "stages/map_expand.hpp"

namespace horopter::native {

class TableView {
 public:
  /// Throws std::invalid_argument where the words contradict each other. Whoever brings them has checked the CRC.
  explicit TableView(std::span<const std::uint32_t> words) : words_(words), header_(hls::table::read(words)) {}

  [[nodiscard]] int spacing_x_log2() const { return header_.geometry.spacing_x_log2; }
  [[nodiscard]] int spacing_y_log2() const { return header_.geometry.spacing_y_log2; }
  [[nodiscard]] int width() const { return header_.geometry.width; }
  [[nodiscard]] int height() const { return header_.geometry.height; }
  [[nodiscard]] std::span<const std::uint32_t> words() const { return words_; }
  /// Codes, row by row of blocks of the result; empty: not known.
  [[nodiscard]] std::span<const std::uint8_t> areas() const { return header_.facts.areas; }

  [[nodiscard]] hls::table::Span span(int row) const {
    return header_.geometry.spans ? hls::table::Span::of(words_[header_.first_span + static_cast<std::size_t>(row)])
                                  : hls::table::Span{0, header_.geometry.width};
  }
  [[nodiscard]] stages::ControlPoint control(int column, int row) const {
    const std::uint32_t word = words_[header_.first_control + header_.geometry.control_index(column, row)];
    using namespace hls::table;
    return {hls::u<16>(word), hls::u<16>(control_y(word)), word != unmapped, is_of_skin(word)};
  }

 private:
  std::span<const std::uint32_t> words_;
  hls::table::Header header_;
};

}  // namespace horopter::native
