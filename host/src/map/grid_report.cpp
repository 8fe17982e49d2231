// SPDX-License-Identifier: Apache-2.0
#include "grid_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "expansion.hpp"
#include "pixel_kinds.hpp"

namespace horopter {
namespace {

/// Pixels by reason, samples standing for those around them.
void count_pixels(const KnownGrid& known, MapReport& report) {
  const CellGrid& grid = known.grid;
  std::array<double, kReasonCount> pixels{};
  // By reason without the grid: runs of samples of one reason, of which those on the left edges of cells stand for
  // less.
  const int step = grid.across_log2();
  const int across = 1 << step;
  const int samples = grid.sample_columns();
  const int cut = (grid.columns - 1) * across;  // the last cell may be
  for (int y = 0; y < grid.scan.height; y += 1 << grid.sample_y_log2) {
    const int kind_y = grid.part_below(y) != 0 ? 2 : 0;
    const Reason* reasons = known.lattice.reasons_of_row(y);
    for (int x = 0; x < samples;) {
      const int begin = x;
      const int limit = x < cut ? cut : samples;
      const Reason reason = reasons[begin];
      while (x < limit && reasons[x] == reason) ++x;
      const int edges = ((x + across - 1) >> step) - ((begin + across - 1) >> step);
      const auto& weight = known.kept.weights().of_cell(begin < cut ? 0 : grid.columns - 1, y >> grid.ny);
      pixels[static_cast<std::size_t>(reason)] += weight[kind_y] * edges + weight[kind_y + 1] * (x - begin - edges);
    }
    report.checked += samples;
  }
  // What would be supervised, or was given to the grid before, and is not.
  const auto of = [&](Reason reason) -> double& { return pixels[static_cast<std::size_t>(reason)]; };
  const KeptPoints::Tally& tally = known.kept.tally();
  of(Reason::outside) -= tally.outside;
  of(Reason::grid) += of(Reason::none) - (tally.supervised - tally.outside);
  of(Reason::none) = tally.supervised;
  for (std::size_t i = 0; i < kReasonCount; ++i) report.by_reason[i] = std::llround(pixels[i]);
}

struct Ranked {
  float error;
  float samples;  ///< for which it stands
};

/// Ranked errors above a bound.
std::vector<Ranked> errors_above(const KnownGrid& known, float bound) {
  const CellGrid& grid = known.grid;
  std::vector<Ranked> errors;
  known.spans.for_cells([&](int column, int row) {
    if (!known.kept.is_kept(grid.point(column, row))) return;
    const CellErrors& cell = known.errors.of_cell(column, row);
    if (!(cell.largest() > bound)) return;
    const auto kept = known.kept.kinds(column, row);
    if (!known.kept.ranked(cell, kept)) return;
    if (cell.beyond_share >= 0) {
      const auto samples = static_cast<float>(known.errors.samples_in(cell));
      const auto add = [&](std::span<const float> all, int count) {
        for (const float error : all) {
          if (error > bound && error >= 0) errors.push_back({error, samples / static_cast<float>(count)});
        }
      };
      if (cell.is_cut()) {
        add(known.cut->errors({column, row}), cell.cut_pixels);
      } else {
        add(known.errors.within(known.controls, column, row), kPlacesWithin);
      }
      return;
    }
    const int left = grid.left_of(column);
    const int top = grid.top_of(row);
    for (int y = top; y < grid.below(row); y += 1 << grid.sample_y_log2) {
      for (int x = left; x < grid.right_of(column); x += 1 << grid.sample_x_log2) {
        const int kind = (x != left ? 1 : 0) + (y != top ? 2 : 0);
        const float error = known.errors.of_sample(x, y);
        if (kept[kind] && error > bound) errors.push_back({error, 1});
      }
    }
  });
  return errors;
}

/// Of errors that stand for more than `beyond` samples the largest such that it and those above do. Sorts some of them.
float ranked_error(std::span<Ranked> errors, double beyond) {
  while (errors.size() > 1) {
    const auto middle = errors.begin() + std::ssize(errors) / 2;
    std::ranges::nth_element(errors, middle, std::ranges::greater{}, &Ranked::error);
    double samples = 0;
    for (auto error = errors.begin(); error != middle; ++error) samples += error->samples;
    if (samples > beyond) {
      errors = {errors.begin(), middle};
    } else {
      errors = {middle, errors.end()};
      beyond -= samples;
    }
  }
  return errors.front().error;
}

void rank_errors(const KnownGrid& known, MapReport& report) {
  const double ranked = known.kept.tally().ranked;
  if (ranked == 0) return;
  // From the largest on; most are small.
  const double beyond = (1 - known.limits.share) * ranked;
  for (const double bound : {0.45 * known.limits.error_px, 0.25 * known.limits.error_px, -1.0}) {
    std::vector<Ranked> errors = errors_above(known, static_cast<float>(bound));
    double samples = 0;
    for (const Ranked& error : errors) samples += error.samples;
    if (!(samples > beyond)) continue;
    report.error_largest_px = std::ranges::max(errors, {}, &Ranked::error).error;
    report.error_99_px = ranked_error(errors, beyond);
    return;
  }
}

/// Of source rows.
struct Extremes {
  std::int64_t lowest = std::numeric_limits<std::int64_t>::max();
  std::int64_t highest = std::numeric_limits<std::int64_t>::min();
  void add(std::int64_t row) {
    lowest = std::min(lowest, row);
    highest = std::max(highest, row);
  }
  bool empty() const { return lowest > highest; }
};

/// What is read once expansions are rounded to the weights.
class Reading {
 public:
  explicit Reading(const KnownGrid& known) : known_(known), grid_(known.grid), weight_bits_(known.weight_bits) {}
  /// Bilinear in the cell, so the extremes lie at its corners.
  RowReach reach_of_cells();
  /// Of every pixel; with the largest error.
  RowReach reach_of_pixels(double& largest_error_px);

 private:
  std::int64_t rounded(std::int64_t expanded) const {
    const int drop = MapTable::kFractionBits - weight_bits_;
    return (expanded - kExpandedOrigin + (std::int64_t{1} << (drop - 1))) >> drop;
  }
  void add_row(int y, const Extremes& sources);
  bool is_supervised(int column, int row) const;

  const KnownGrid& known_;
  const CellGrid& grid_;
  int weight_bits_;
  RowReach reach_{-known_.grid.scan.height, -known_.grid.scan.height};
};

/// The source rows that pixels of row y read, in 2^-weight_bits px: between two of them both.
void Reading::add_row(int y, const Extremes& sources) {
  const auto before = [&](std::int64_t source) { return static_cast<int>(source >> weight_bits_); };
  const int last = before(sources.highest + (1 << weight_bits_) - 1);
  reach_.behind = std::max(reach_.behind, y - before(sources.lowest));
  reach_.ahead = std::max(reach_.ahead, last - y);
}

/// Any pixel of a cell.
bool Reading::is_supervised(int column, int row) const {
  const auto kept = known_.kept.kinds(column, row);
  const CellErrors& cell = known_.errors.of_cell(column, row);
  bool supervised = false;
  for (int kind = 0; kind < kKinds; ++kind) supervised |= kept[kind] && (cell.inside[kind] > 0 || cell.is_cut());
  return supervised;
}

RowReach Reading::reach_of_cells() {
  Crossing crossing(grid_);
  const std::int64_t last = kExpandedOrigin + ((grid_.scan.height - 1) << MapTable::kFractionBits);
  const auto source = [&](std::int64_t expanded) {
    return rounded(std::clamp<std::int64_t>(expanded, kExpandedOrigin, last));
  };
  for (int row = 0; row < grid_.rows; ++row) {
    for (const int y : {grid_.top_of(row), grid_.below(row) - 1}) {
      known_.controls.cross(row, y, known_.kept.points(), crossing);
      Extremes expanded;
      const auto [begin, end] = known_.spans.cells_of_row(row);
      for (int column = begin; column < end; ++column) {
        const auto c = static_cast<std::size_t>(column);
        if (crossing.there[c] == 0 || !is_supervised(column, row)) continue;
        expanded.add(crossing.at(c, 0).y);
        const int right = grid_.part_right(grid_.right_of(column) - 1);
        if (right != 0 && crossing.there[c + 1] != 0) expanded.add(crossing.at(c, right).y);
      }
      if (!expanded.empty()) add_row(y, {source(expanded.lowest), source(expanded.highest)});
    }
  }
  return reach_;
}

RowReach Reading::reach_of_pixels(double& largest_error_px) {
  const double unit = std::ldexp(1.0, -weight_bits_);
  const std::int64_t last_x = std::int64_t{grid_.scan.width - 1} << weight_bits_;
  const std::int64_t last_y = std::int64_t{grid_.scan.height - 1} << weight_bits_;
  Crossing crossing(grid_);
  for (int y = 0; y < grid_.scan.height; ++y) {
    const hls::table::Span& span = known_.spans.of_row(y);
    known_.controls.cross(y >> grid_.ny, y, known_.kept.points(), crossing);
    const Point* const exact = known_.lattice.sources_of_row(y);
    double largest = largest_error_px;
    Extremes sources;
    for (int x = span.first; x < span.end; ++x) {
      const auto c = static_cast<std::size_t>(x >> grid_.nx);
      const std::int32_t right = grid_.part_right(x);
      if (crossing.there[c] == 0 || (right != 0 && crossing.there[c + 1] == 0)) continue;
      const Expansion expansion = crossing.at(c, right);
      const std::int64_t source_x = rounded(expansion.x);
      const std::int64_t source_y = rounded(expansion.y);
      if (source_x < 0 || source_y < 0 || source_x > last_x || source_y > last_y) continue;
      const double off = length(
          {static_cast<double>(source_x) * unit - exact[x].x, static_cast<double>(source_y) * unit - exact[x].y});
      largest = std::max(largest, off);
      sources.add(source_y);
    }
    largest_error_px = largest;
    if (!sources.empty()) add_row(y, sources);
  }
  return reach_;
}

}  // namespace

MapReport report_of(const KnownGrid& known) {
  const CellGrid& grid = known.grid;
  MapReport report;
  report.spacing_x = 1 << grid.nx;
  report.spacing_y = 1 << grid.ny;
  report.pool_bytes = MapTable::pool_bytes(grid.scan, grid.nx, grid.ny, known.spans.are_of_an_outline());
  report.pixels = std::int64_t{grid.scan.width} * grid.scan.height;
  count_pixels(known, report);
  if (report.supervised() == 0) return report;
  rank_errors(known, report);
  Reading reading(known);
  report.reach = grid.every_pixel() ? reading.reach_of_pixels(report.rounded_largest_px) : reading.reach_of_cells();
  return report;
}

}  // namespace horopter
