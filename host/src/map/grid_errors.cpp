// SPDX-License-Identifier: Apache-2.0
#include "grid_errors.hpp"

#include <cmath>

#include "horopter/calib/vectorised.hpp"

namespace horopter {
namespace {

using hls::table::Span;

/// Between the columns of a row, what is there at `right`/64 of the way to the next.
struct Between {
  const std::int32_t* x_at;
  const std::int32_t* y_at;
  std::int32_t right;
};
/// The errors of samples that are `kStride` apart, `stride` where it is 0; -1 where nothing is read.
template <std::size_t kStride>
[[gnu::always_inline]] inline void sample_errors(const Between& row, const Point* sources, std::size_t stride,
                                                 std::size_t count, const ReadPlaces& inside, double* errors) {
  const std::size_t apart = kStride == 0 ? stride : kStride;
  const auto [x_at, y_at, right] = row;
  const ReadPlaces read = inside;
  for (std::size_t c = 0; c < count; ++c) {
    const Expansion here = between({x_at[c], y_at[c]}, {x_at[c + 1], y_at[c + 1]}, right);
    const double off = length(error_of(here, sources[c * apart]));
    errors[c] = read.hold(here) ? off : -1;
  }
}

/// Errors at 3 × 3 places, from corner to corner.
using CellNodes = std::array<Point, 9>;

/// What a biquadratic through the nodes is at the places.
[[gnu::always_inline]] inline void biquadratic(const CellNodes& nodes, ErrorsWithin& errors) {
  static constexpr auto kWeights = [] {
    constexpr auto kOf = [](std::size_t i) -> std::array<double, 3> {
      const double u = static_cast<double>(i) / 8;
      return {(1 - 2 * u) * (1 - u), 4 * u * (1 - u), u * (2 * u - 1)};
    };
    std::array<std::array<double, kPlacesWithin>, 9> weights{};
    for (std::size_t k = 0; k < 9; ++k) {
      for (std::size_t i = 0; i < kPlacesWithin; ++i) weights[k][i] = kOf(i % 8)[k % 3] * kOf(i / 8)[k / 3];
    }
    return weights;
  }();
  for (std::size_t i = 0; i < kPlacesWithin; ++i) {
    double x = 0;
    double y = 0;
    for (std::size_t k = 0; k < 9; ++k) {
      x += kWeights[k][i] * nodes[k].x;
      y += kWeights[k][i] * nodes[k].y;
    }
    errors[i] = static_cast<float>(std::sqrt(x * x + y * y));
  }
}

}  // namespace

GridErrors::GridErrors(const CellGrid& grid, const LookLattice& lattice, const MapLimits& limits, bool smooth)
    : grid_(grid),
      lattice_(lattice),
      limits_(limits),
      smooth_(smooth),
      cells_(grid.cells()),
      samples_(lattice.sources.size()) {}

void GridErrors::find(const ControlPoints& controls, const RowSpans& spans, const ReadPlaces& inside) {
  std::ranges::fill(cells_, CellErrors{});
  std::ranges::fill(samples_, std::numeric_limits<float>::quiet_NaN());
  find_at_samples(controls, spans, inside);
  if (!grid_.every_pixel()) look_between_samples(controls, spans);
}

void GridErrors::find_at_samples(const ControlPoints& controls, const RowSpans& spans, const ReadPlaces& inside) {
  const double share_error = limits_.error_px;
  Crossing crossing(grid_);
  const int step = grid_.across_log2();
  const std::size_t across = std::size_t{1} << step;
  const auto samples = static_cast<std::size_t>(grid_.sample_columns());
  std::vector<double> errors(grid_.point_columns() - 1);
  for (int y = 0; y < grid_.scan.height; y += 1 << grid_.sample_y_log2) {
    // Samples in the row's span.
    const Span held = spans.of_row(y);
    if (held.first == held.end) continue;
    const std::size_t first_held = grid_.samples_before(held.first);
    const std::size_t end_held = std::min(samples, grid_.samples_before(held.end));
    const int row = y >> grid_.ny;
    controls.cross(row, y, controls.mapped(), crossing);
    const std::size_t kind_y = grid_.part_below(y) != 0 ? 2 : 0;
    CellErrors* const cells = &cells_[grid_.cell(0, row)];
    const std::size_t first_sample = lattice_.index(0, y);
    for (std::size_t i = 0; i < across; ++i) {
      if (end_held <= i) break;
      // Cells whose sample i is one of those.
      const std::size_t begin = first_held > i ? (first_held - i + across - 1) >> step : 0;
      const std::size_t end = (end_held - i + across - 1) >> step;
      if (begin >= end) continue;
      const std::size_t first = first_sample + (begin << step) + i;
      const Between places{&crossing.x[begin], &crossing.y[begin], static_cast<std::int32_t>(i << (6 - step))};
      const Point* const sources = &lattice_.sources[first];
      if (across == 2) {
        calib::vectorised<sample_errors<2>>(places, sources, across, end - begin, inside, errors.data());
      } else {
        calib::vectorised<sample_errors<0>>(places, sources, across, end - begin, inside, errors.data());
      }
      const std::size_t kind = kind_y + (i != 0 ? 1 : 0);
      for (std::size_t c = begin; c < end; ++c) {
        const double error = errors[c - begin];
        if (error < 0 || crossing.there[c] == 0 || (i != 0 && crossing.there[c + 1] == 0)) continue;
        const std::size_t at = first + ((c - begin) << step);
        const Reason reason = lattice_.reasons[at];
        CellErrors& cell = cells[c];
        const auto rounded = static_cast<float>(error);
        // A source just outside may be expanded to one just inside; one without a place has no error that is small.
        const bool never = (is_excluded(reason) &&
                            is_excluded_at(at, static_cast<int>((c << step) + i) << grid_.sample_x_log2, y, spans)) ||
                           std::isnan(error);
        cell.worst[kind] = std::max(cell.worst[kind], never ? kNever : rounded);
        samples_[at] = rounded;
        ++cell.inside[kind];
        cell.beyond[kind] = static_cast<std::uint16_t>(cell.beyond[kind] + (error > share_error ? 1 : 0));
        cell.outside[kind] = static_cast<std::uint16_t>(cell.outside[kind] + (reason == Reason::outside ? 1 : 0));
      }
    }
  }
}

void GridErrors::look_between_samples(const ControlPoints& controls, const RowSpans& spans) {
  const int across = 1 << grid_.across_log2();
  const int down = 1 << grid_.down_log2();
  const auto last = [](int size, int log2, int at, int count) {
    return std::min(at + count, (size - 1 + (1 << log2) - 1) >> log2);
  };
  const auto samples = static_cast<std::size_t>(lattice_.shape.columns);
  std::vector<std::uint8_t> above(samples);  // excluded in the first row of the cells
  std::vector<std::uint8_t> all(samples);    // in any row
  for (int row = 0; row < grid_.rows; ++row) {
    const int top = row * down;
    const int bottom = down == 1 ? top : last(grid_.scan.height, grid_.sample_y_log2, top, down);
    bool none = true;
    std::ranges::fill(above, std::uint8_t{0});
    std::ranges::fill(all, std::uint8_t{0});
    for (int y = top; y <= bottom; ++y) {
      const int pixel_y = y << grid_.sample_y_log2;
      const Span held = spans.of_row_or_last(pixel_y);
      if (held.first == held.end) continue;
      const std::size_t first = static_cast<std::size_t>(y) * samples;
      // Beyond the image as the row's last pixel.
      const std::size_t end = held.end == grid_.scan.width ? samples : grid_.samples_before(held.end);
      for (std::size_t x = grid_.samples_before(held.first); x < end; ++x) {
        if (!is_excluded(lattice_.reasons[first + x]) ||
            !is_excluded_at(first + x, static_cast<int>(x) << grid_.sample_x_log2, pixel_y, spans)) {
          continue;
        }
        none = false;
        all[x] = 1;
        if (y == top) above[x] = 1;
      }
    }
    if (none) continue;
    for (int column = 0; column < grid_.columns; ++column) {
      if (!controls.is_mapped(grid_.point(column, row))) continue;  // nothing in it is supervised
      const int left = column * across;
      const int right = across == 1 ? left : last(grid_.scan.width, grid_.sample_x_log2, left, across);
      bool upper = false;
      for (int x = left; x <= right; ++x) upper |= above[x] != 0;
      bool any = false;
      for (int x = left; x <= right; ++x) any |= all[x] != 0;
      if (!any) continue;
      CellErrors& cell = cells_[grid_.cell(column, row)];
      if (right > left || bottom > top) cell.worst[3] = kNever;
      if (all[left] != 0 && bottom > top) cell.worst[2] = kNever;
      if (upper && right > left) cell.worst[1] = kNever;
    }
  }
}

void GridErrors::add_cut(int column, int row, const CutErrors& found) {
  CellErrors& cell = cells_[grid_.cell(column, row)];
  for (int kind = 0; kind < kKinds; ++kind) cell.worst[kind] = std::max(cell.worst[kind], found.worst[kind]);
  cell.cut_pixels = found.pixels;
  // They are all known.
  if (!grid_.every_pixel() && found.pixels > 0) {
    cell.beyond_share = static_cast<float>(found.beyond) / static_cast<float>(found.pixels);
  }
}

bool GridErrors::interpolate(const ControlPoints& controls, const RowSpans& spans) {
  if (!smooth_ || grid_.across_log2() != 1 || grid_.down_log2() != 1) return false;
  // Where an outline lets cells be large, more than the samples may be beyond.
  constexpr int kLargeLog2 = 8;
  const bool large = spans.are_of_an_outline() && grid_.nx + grid_.ny >= kLargeLog2;
  const auto least = static_cast<float>(large ? 0.5 * limits_.error_px : limits_.error_px);
  bool any = false;
  spans.for_cells([&](int column, int row) {
    CellErrors& cell = cells_[grid_.cell(column, row)];
    if (cell.beyond_share >= 0 || cell.largest() <= least) return;
    const auto is_mapped = [&](std::size_t at) { return controls.is_mapped(at); };
    if (!std::ranges::all_of(grid_.corners(column, row), is_mapped)) return;
    std::size_t beyond = 0;
    for (const float error : within(controls, column, row)) {
      beyond += !(error <= static_cast<float>(limits_.error_px)) ? 1 : 0;
    }
    cell.beyond_share = static_cast<float>(beyond) / kPlacesWithin;
    any = true;
  });
  return any;
}

ErrorsWithin GridErrors::within(const ControlPoints& controls, int column, int row) const {
  const auto at = grid_.corners(column, row);
  CellNodes nodes;
  for (std::int32_t j = 0; j < 3; ++j) {
    const Expansion left = between(controls.at(at[0]), controls.at(at[2]), 32 * j);
    const Expansion right = between(controls.at(at[1]), controls.at(at[3]), 32 * j);
    const int y = grid_.top_of(row) + (j << grid_.ny >> 1);
    for (std::int32_t i = 0; i < 3; ++i) {
      const int x = grid_.left_of(column) + (i << grid_.nx >> 1);
      nodes[static_cast<std::size_t>(3 * j + i)] =
          error_of(between(left, right, 32 * i), lattice_.sources[lattice_.index(x, y)]);
    }
  }
  ErrorsWithin errors;
  calib::vectorised<biquadratic>(nodes, errors);
  return errors;
}

double GridErrors::samples_in(const CellErrors& cell) const {
  if (cell.is_cut()) return std::ldexp(cell.cut_pixels, -grid_.sample_x_log2 - grid_.sample_y_log2);
  return cell.inside[0] + cell.inside[1] + cell.inside[2] + cell.inside[3];
}

}  // namespace horopter
