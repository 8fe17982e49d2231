// SPDX-License-Identifier: Apache-2.0
#include "horopter/tb/raster_stimulus.hpp"

#include <algorithm>

namespace horopter::tb {

RasterStimulus::RasterStimulus(Rng rng, const Dut& dut, unsigned min_row, unsigned max_row)
    : rng_{rng},
      in_{Rng{rng_.next()}, dut.in_ports},
      config_{Rng{rng_.next()}, dut.config_ports},
      min_row_{min_row},
      max_row_{max_row},
      any_marks_{dut.memories.empty()} {
  const auto mark_port = [&](std::string_view plain, std::string_view in_marks) {
    const Index index = find(dut.in_ports, in_marks);
    return index ? index : find(dut.in_ports, plain);
  };
  first_ = mark_port("first_i", "marks_first_i");
  last_ = mark_port("last_i", "marks_last_i");
  live_ = mark_port("live_i", "marks_live_i");
  end_ = mark_port("end_i", "end_v_i");  // a reserved word
  start_ = find(dut.in_ports, "start_i");
  idle_ = find(dut.in_ports, "idle_i");
  prime_ = find(dut.in_ports, "prime_i");
  load_ = find(dut.in_ports, "load_i");
  width_port_ = find(dut.config_ports, "cfg_width_i");
  height_port_ = find(dut.config_ports, "cfg_height_i");
  spacing_port_ = find(dut.config_ports, "cfg_spacing_x_log2_i");
  choose();
}

RasterStimulus::Index RasterStimulus::find(const std::vector<DutPort>& ports, std::string_view name) {
  const auto found = std::find_if(ports.begin(), ports.end(), [&](const DutPort& port) { return port.name == name; });
  if (found == ports.end()) return std::nullopt;
  return static_cast<std::size_t>(found - ports.begin());
}

void RasterStimulus::restart() {
  kind_ = next_kind_;
  start_frame();
}

void RasterStimulus::config(Beat& config) {
  config_.next(config);
  choose();
  if (width_port_ && height_port_ && !rng_.chance(4)) {
    // Usually the geometry that comes.
    config[*width_port_] = width_;
    config[*height_port_] = height_ > kFlushRows ? height_ - kFlushRows : height_;
    fixed_geometry_ = true;
  }
  if (spacing_port_) spacing_x_log2_ = static_cast<unsigned>(std::min<std::uint64_t>(6, config[*spacing_port_]));
}

void RasterStimulus::next(Beat& in) {
  in_.next(in);
  if (kind_ == Kind::any) {
    if (--any_beats_ == 0) restart();
  } else {
    mark(in);
  }
}

/// A geometry for the next frames.
void RasterStimulus::choose() {
  width_ = static_cast<unsigned>(rng_.chance(6) ? max_row_ : rng_.between(min_row_, std::min(max_row_, 4 * min_row_)));
  height_ = static_cast<unsigned>(rng_.between(1, 40));
  fixed_geometry_ = false;
  next_kind_ = rng_.chance(4) ? (any_marks_ && rng_.chance(2) ? Kind::any : Kind::ragged) : Kind::frames;
  if (x_ != 0 && kind_ != Kind::any) {
    // Not in the middle of a row: memories have a shortest one.
    row_ = std::max(x_ + 1, min_row_);
    cut_off_ = true;
  } else {
    const unsigned idle = idle_beats_;  // nor in the middle of these
    restart();
    idle_beats_ = idle;
  }
}

void RasterStimulus::start_frame() {
  x_ = y_ = 0;
  cut_off_ = primed_ = false;
  idle_beats_ = marked_row_ = 0;
  row_ = kind_ == Kind::ragged ? ragged_row() : width_;
  any_beats_ = 2'000;
}

unsigned RasterStimulus::ragged_row() {
  return static_cast<unsigned>(rng_.between(min_row_, std::min(max_row_, 3 * min_row_)));
}

void RasterStimulus::mark(Beat& in) {
  const auto set = [&](Index port, bool value) {
    if (port) in[*port] = value;
  };
  const bool live = y_ < height_ - std::min(height_ - 1, kFlushRows);
  const bool row_end = x_ + 1 == row_;
  const bool frame_end = row_end && y_ + 1 == height_;
  const bool lost =
      kind_ == Kind::ragged && row_end && !(idle_ && frame_end) && rng_.chance(8);  // a mark does not come
  if (prime_ && load_) {
    // One beat before the row, then a new column every 2^spacing pixels.
    set(prime_, !primed_);
    set(load_, primed_ && x_ % (1U << spacing_x_log2_) == 0);
    if (!primed_) {
      primed_ = true;
      set(first_, false);
      set(last_, false);
      set(live_, false);
      return;
    }
    if (row_end) primed_ = false;
  }
  set(first_, x_ == 0 && y_ == 0 && idle_beats_ == 0);
  set(start_, x_ == 0);
  set(last_, row_end && !lost && idle_beats_ == 0);
  set(live_, live);
  set(end_, frame_end && idle_beats_ == 0);
  set(idle_, idle_beats_ != 0);
  if (idle_beats_ != 0) {
    --idle_beats_;
    return;
  }
  // Whole rows of idle beats, mostly one; `objects` says in them what it has not said yet, `blind` fetches pixels.
  ++marked_row_;
  if (idle_ && frame_end) idle_beats_ = marked_row_ * (rng_.chance(3) ? static_cast<unsigned>(rng_.between(1, 20)) : 1);
  if (row_end && !lost) marked_row_ = 0;
  advance();
}

void RasterStimulus::advance() {
  if (++x_ < row_) return;
  x_ = 0;
  if (cut_off_) return restart();
  if (kind_ == Kind::ragged) row_ = ragged_row();
  if (++y_ < height_ && !(kind_ == Kind::ragged && rng_.chance(20))) return;
  y_ = 0;
  if (!fixed_geometry_ && rng_.chance(4)) {
    choose();
  }
}

}  // namespace horopter::tb
