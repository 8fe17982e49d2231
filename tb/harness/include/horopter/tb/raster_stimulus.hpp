// SPDX-License-Identifier: Apache-2.0
// Stimulus of pixel streams: data at random, frame marks as the raster generator makes them, or damaged, or (where no
// memory depends on them) at random too. Marks are found by the names of the ports, whatever stage it is.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "horopter/tb/stage_bench.hpp"

namespace horopter::tb {

class RasterStimulus : public Stimulus {
 public:
  /// Rows of min_row … max_row beats.
  RasterStimulus(Rng rng, const Dut& dut, unsigned min_row, unsigned max_row);
  void restart() override;
  void next(Beat& in) override;
  void config(Beat& config) override;

 private:
  static constexpr unsigned kFlushRows = 10;  ///< more or fewer do not matter to a bench
  enum class Kind { frames, ragged, any };
  using Index = std::optional<std::size_t>;
  static Index find(const std::vector<DutPort>& ports, std::string_view name);
  void choose();
  void start_frame();
  unsigned ragged_row();
  void mark(Beat& in);
  void advance();

  Rng rng_;
  RandomLeaves in_, config_;
  unsigned min_row_, max_row_;
  bool any_marks_;  ///< the stage keeps no memory, so marks may come in any order
  Index first_, start_, last_, live_, end_, idle_, prime_, load_;
  Index width_port_, height_port_, spacing_port_;
  Kind kind_ = Kind::frames, next_kind_ = Kind::frames;
  unsigned width_ = 0, height_ = 0, row_ = 0, x_ = 0, y_ = 0, any_beats_ = 0, spacing_x_log2_ = 0, idle_beats_ = 0;
  unsigned marked_row_ = 0;  ///< beats since the last mark of a row's end
  bool fixed_geometry_ = false, primed_ = false, cut_off_ = false;
};

}  // namespace horopter::tb
