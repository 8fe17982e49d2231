// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/map_compiler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <ranges>
#include <stdexcept>
#include <utility>

#include "horopter/base/error.hpp"
#include "horopter/calib/vectorised.hpp"
#include "horopter/map/row_check.hpp"

namespace horopter {

namespace {

constexpr int kForecastLog2 = 4;
/// Coarsest steps between samples: enough for second differences of what is smooth; 4 pixels where it may not be.
constexpr int kSmoothLog2 = 5;
constexpr int kFeatureLog2 = 2;
/// Grids tried where none loses little enough, and how much more than with the first of them may be expected to be lost.
constexpr int kLastTries = 3;
constexpr double kWorthATry = 1.05;
/// The precision of cells that an outline cuts is left out where the limit is kept then, or nearly, and much less is lost.
constexpr double kMuchLess = 0.75;
constexpr double kNearly = 1.25;

constexpr double kFraction = 1.0 / (1 << MapTable::kFractionBits);

double distance(double x, double y) { return std::sqrt(x * x + y * y); }
double distance(Point p) { return distance(p.x, p.y); }

/// What second differences on a lattice of 16 pixels say about the error and the loss of other spacings.
class Forecast {
 public:
  Forecast(const LookLattice& lattice, const ScanGeometry& geometry) {
    constexpr int kStep = 1 << kForecastLog2;
    const auto good = [&](int x, int y) { return lattice.reasons[lattice.index(x, y)] == Reason::none; };
    for (int y = 0; y < geometry.height; y += kStep) {
      for (int x = 0; x < geometry.width; x += kStep) {
        if (!good(x, y)) continue;
        ++good_;
        const Point here = lattice.sources[lattice.index(x, y)];
        const auto bend = [&](int dx, int dy) -> Point {
          if (x < dx || y < dy || x + dx >= geometry.width || y + dy >= geometry.height) return {};
          const Point a = lattice.sources[lattice.index(x - dx, y - dy)];
          const Point b = lattice.sources[lattice.index(x + dx, y + dy)];
          const Point bend{a.x - 2 * here.x + b.x, a.y - 2 * here.y + b.y};
          return std::isfinite(bend.x + bend.y) ? bend : Point{};
        };
        bends_.push_back({bend(kStep, 0), bend(0, kStep)});
        for (const auto& [dx, dy] : {std::pair{kStep, 0}, {-kStep, 0}, {0, kStep}, {0, -kStep}}) {
          if (x + dx < 0 || y + dy < 0 || x + dx >= geometry.width || y + dy >= geometry.height) continue;
          if (is_excluded(lattice.reasons[lattice.index(x + dx, y + dy)])) ++(dx != 0 ? across_ : along_);
        }
      }
    }
  }

  /// Share of the pixels, roughly, whose interpolation (the quadratic's, in the middle of a cell, 0.6 of it left by
  /// the control points) is further off.
  double share_beyond(int nx, int ny, double error_px) const {
    constexpr double kLeft = 0.6;
    const double across = std::ldexp(kLeft / 8, 2 * (nx - kForecastLog2));
    const double along = std::ldexp(kLeft / 8, 2 * (ny - kForecastLog2));
    const auto beyond = std::ranges::count_if(bends_, [&](const Bend& bend) {
      return distance(bend.x.x * across + bend.y.x * along, bend.x.y * across + bend.y.y * along) > error_px;
    });
    return bends_.empty() ? 0 : static_cast<double>(beyond) / static_cast<double>(bends_.size());
  }

  /// Cells that the border of what is seen within the limits cuts: along an ellipse 0.35 of what it is long across and
  /// along the rows, times their width and height.
  double lost_share(int nx, int ny) const {
    constexpr double kCut = 0.35;
    const double cells = std::ldexp(static_cast<double>(across_), nx - kForecastLog2) +
                         std::ldexp(static_cast<double>(along_), ny - kForecastLog2);
    return good_ == 0 ? 0 : kCut * cells / static_cast<double>(good_);
  }

 private:
  struct Bend {
    Point x, y;
  };
  std::vector<Bend> bends_;
  std::int64_t good_ = 0;
  std::int64_t across_ = 0;  ///< pixels of the lattice's rows beyond which the border crosses the row
  std::int64_t along_ = 0;
};

/// Between two rows of control points, 1/64 of the way down.
[[gnu::always_inline]] inline void between(const std::int32_t* above, const std::int32_t* below, std::int32_t part,
                                           std::size_t count, std::int32_t* at) {
  for (std::size_t i = 0; i < count; ++i) at[i] = above[i] * 64 + (below[i] - above[i]) * part;
}

constexpr std::int32_t kOffset = hls::table::control_offset_px << MapTable::kFractionBits;

[[gnu::always_inline]] inline Point error_of(std::int32_t x, std::int32_t y, const Point& source) {
  return {static_cast<double>(x - kOffset) * kFraction - source.x,
          static_cast<double>(y - kOffset) * kFraction - source.y};
}

/// Expanded places that are read inside the image.
struct ReadPlaces {
  std::int32_t low, high_x, high_y;
};
/// Between the columns of a row, what is there at `right`/64 of the way to the next.
struct Between {
  const std::int32_t* x_at;
  const std::int32_t* y_at;
  std::int32_t right;
};
/// The errors of samples that are `kStride` apart, `stride` where it is 0; -1 where nothing is read.
template <std::size_t kStride>
[[gnu::always_inline]] inline void sample_errors(const Between& between, const Point* sources, std::size_t stride,
                                                 std::size_t count, const ReadPlaces& inside, double* errors) {
  const std::size_t apart = kStride == 0 ? stride : kStride;
  const std::int32_t left = 64 - between.right;
  for (std::size_t c = 0; c < count; ++c) {
    const std::int32_t x = between.x_at[c] * left + between.x_at[c + 1] * between.right;
    const std::int32_t y = between.y_at[c] * left + between.y_at[c + 1] * between.right;
    const bool read =
        static_cast<bool>((x >= inside.low) & (y >= inside.low) & (x < inside.high_x) & (y < inside.high_y));
    const Point error = error_of(x, y, sources[c * apart]);
    const double distance = std::sqrt(error.x * error.x + error.y * error.y);
    errors[c] = read ? distance : -1;
  }
}

/// Of the cells at both sides of each column, in the rows above and below, the mean of the least and the largest error; 0
/// of none, or of different signs.
[[gnu::always_inline]] inline void agree(const double* low, const double* low_above, const double* high,
                                         const double* high_above, std::size_t columns, double* errors) {
  for (std::size_t c = 0; c < columns; ++c) {
    const double least = std::min(std::min(low[c], low[c + 1]), std::min(low_above[c], low_above[c + 1]));
    const double most = std::max(std::max(high[c], high[c + 1]), std::max(high_above[c], high_above[c + 1]));
    const double mean = 0.5 * (least + most);
    errors[c] = static_cast<bool>((least <= most) & ((least > 0) | (most < 0))) ? mean : 0;
  }
}

/// Errors of a cell at 8 × 8 places, from its corner on, row by row.
constexpr std::size_t kCellErrors = 64;
using CellErrors = std::array<float, kCellErrors>;
/// At 3 × 3 places, from corner to corner.
using CellNodes = std::array<Point, 9>;

/// What a biquadratic through the nodes is at the places.
[[gnu::always_inline]] inline void biquadratic(const CellNodes& nodes, CellErrors& errors) {
  static constexpr auto kWeights = [] {
    constexpr auto kOf = [](std::size_t i) -> std::array<double, 3> {
      const double u = static_cast<double>(i) / 8;
      return {(1 - 2 * u) * (1 - u), 4 * u * (1 - u), u * (2 * u - 1)};
    };
    std::array<std::array<double, kCellErrors>, 9> weights{};
    for (std::size_t k = 0; k < 9; ++k) {
      for (std::size_t i = 0; i < kCellErrors; ++i) weights[k][i] = kOf(i % 8)[k % 3] * kOf(i / 8)[k / 3];
    }
    return weights;
  }();
  for (std::size_t i = 0; i < kCellErrors; ++i) {
    double x = 0;
    double y = 0;
    for (std::size_t k = 0; k < 9; ++k) {
      x += kWeights[k][i] * nodes[k].x;
      y += kWeights[k][i] * nodes[k].y;
    }
    errors[i] = static_cast<float>(std::sqrt(x * x + y * y));
  }
}

/// One grid: its control points, the cells that must be given up, and what is left.
///
/// A cell has four kinds of pixels, by the control points that have a weight there: its corner needs one, the rest of
/// its upper and of its left edge two, all others four. Errors of all samples are measured once, at grids of all cells;
/// what is given up is decided by cells then, for one bound of the error after another.
class GridFit {
 public:
  /// The lattice holds every pixel, or at least the four samples of each cell. `smooth`: what lies between them follows
  /// from them. With an outline, the table has its spans.
  GridFit(const LookLattice& lattice, const ScanGeometry& geometry, int nx, int ny, int weight_bits,
          const MapLimits& limits, bool smooth, const Outline* outline)
      : lattice_(lattice),
        geometry_(geometry),
        limits_(limits),
        smooth_(smooth),
        nx_(nx),
        ny_(ny),
        weight_bits_(weight_bits),
        every_pixel_(lattice.shape.x_log2 == 0 && lattice.shape.y_log2 == 0),
        outline_(outline),
        cell_columns_(((geometry.width - 1) >> nx) + 1),
        cell_rows_(((geometry.height - 1) >> ny) + 1),
        controls_(static_cast<std::size_t>(cell_columns_ + 1) * static_cast<std::size_t>(cell_rows_ + 1)) {
    weights_ = {weights(false, false), weights(true, false), weights(false, true), weights(true, true)};
    fit();
  }

  const MapReport& report() const { return report_; }
  /// The share that is wanted leaves out cells that the outline cuts, where the skin bends most. Whether there are any.
  bool leave_out_cut() {
    if (outline_ == nullptr) return false;
    leaves_out_cut_ = true;
    report_ = {};
    keep_within(limits_.largest_error_px);
    keep_precise();
    return true;
  }
  CompiledMap take() const {
    MapTable table(geometry_, nx_, ny_);
    for (int row = 0; row <= cell_rows_; ++row) {
      for (int column = 0; column <= cell_columns_; ++column) {
        const std::size_t at = point(column, row);
        if (kept_[at] != 0) table.set_control(column, row, controls_.word[at]);
      }
    }
    if (outline_ != nullptr) table.set_spans(spans_);
    return {std::move(table), report_};
  }

 private:
  void fit() {
    cells_.resize(static_cast<std::size_t>(cell_columns_) * static_cast<std::size_t>(cell_rows_));
    errors_.resize(lattice_.sources.size(), std::numeric_limits<float>::quiet_NaN());
    set_controls();
    centre_errors();
    in_spans_.assign(static_cast<std::size_t>(cell_rows_), {0, cell_columns_});
    if (outline_ != nullptr) {
      spans_ = outline_->spans;
      find_cells_in_spans();
      follow_outline();
    }
    find_all_errors();
    if (outline_ != nullptr && trim()) find_all_errors();
    keep_precise();
  }
  /// The largest bound by which the share that is wanted stays within its own.
  void keep_precise() {
    double bound = limits_.largest_error_px;
    if (!precise()) {
      double low = std::min(limits_.error_px, bound);
      double high = bound;
      for (int step = 0; step < kBoundSteps; ++step) {
        bound = std::sqrt(low * high);
        keep_within(bound);
        (precise() ? low : high) = bound;
      }
      if (bound != low) keep_within(low);
    }
    measure();
  }
  /// With all control points that no error beyond the largest forbids.
  void find_all_errors() {
    for (Cell& cell : cells_) cell = {.cut = cell.cut, .pixels = cell.pixels};
    std::ranges::fill(errors_, std::numeric_limits<float>::quiet_NaN());
    find_errors();
    if (!every_pixel_) look_between_samples();
    if (outline_ != nullptr) find_errors_in_cut_cells();
    keep_within(limits_.largest_error_px);
    if ((!precise() || outline_ != nullptr) && interpolate_errors()) count_kept();
  }

  static constexpr int kBoundSteps = 6;
  static constexpr float kNever = std::numeric_limits<float>::infinity();  ///< error of what must not be supervised
  static constexpr int kKinds = 4;  ///< of pixels: bit 0 right of the cell's left edge, bit 1 below its upper edge

  struct Controls {
    explicit Controls(std::size_t count) : word(count, MapTable::kUnmapped), x(count), y(count), mapped(count) {}
    std::vector<std::uint32_t> word;
    std::vector<std::int32_t> x, y;
    std::vector<std::uint8_t> mapped;

    void set(std::size_t at, std::uint32_t value) {
      word[at] = value;
      x[at] = static_cast<std::int32_t>(value & 0xFFFFU);
      y[at] = static_cast<std::int32_t>(value >> 16);
      mapped[at] = value != MapTable::kUnmapped ? 1 : 0;
    }
  };

  /// By kind of pixel: the samples whose source would be read inside the image, were all control points there.
  struct Cell {
    std::array<float, kKinds> worst{-1, -1, -1, -1};  ///< largest error
    std::array<std::uint16_t, kKinds> inside{};
    std::array<std::uint16_t, kKinds> beyond{};   ///< of them further off than the share that is wanted may be
    std::array<std::uint16_t, kKinds> outside{};  ///< of them just outside without the grid
    float beyond_share = -1;                      ///< of all pixels, where it is known better than by counting samples
    bool cut = false;                             ///< by the outline
    int errors = 0;                               ///< of such a cell: its pixels that have one
    std::int32_t pixels = -1;                     ///< where those of such a cell begin in pixels_ and cut_errors_
  };

  /// How many pixels a sample stands for, in cells that the image's right and lower borders cut or not.
  struct Weights {
    std::array<double, kKinds> kind{};
  };
  const Weights& weights_of(int column, int row) const {
    return weights_[(column == cell_columns_ - 1 ? 1 : 0) + (row == cell_rows_ - 1 ? 2 : 0)];
  }
  Weights weights(bool last_column, bool last_row) const {
    const auto part = [](int size, int n, bool last) { return last ? ((size - 1) & ((1 << n) - 1)) + 1 : 1 << n; };
    const int width = part(geometry_.width, nx_, last_column);
    const int height = part(geometry_.height, ny_, last_row);
    const int across = (width + (1 << lattice_.shape.x_log2) - 1) >> lattice_.shape.x_log2;
    const int down = (height + (1 << lattice_.shape.y_log2) - 1) >> lattice_.shape.y_log2;
    const std::array<int, kKinds> pixels{1, width - 1, height - 1, (width - 1) * (height - 1)};
    const std::array<int, kKinds> samples{1, across - 1, down - 1, (across - 1) * (down - 1)};
    Weights weights;
    for (int kind = 0; kind < kKinds; ++kind) {
      // Pixels of a kind without a sample go with those of the edge, or of the corner.
      int at = kind;
      if (samples[at] == 0 && at == 3) at = samples[2] != 0 ? 2 : 1;
      if (samples[at] == 0) at = 0;
      weights.kind[at] += static_cast<double>(pixels[kind]) / samples[at];
    }
    return weights;
  }

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cell_columns_) + static_cast<std::size_t>(column);
  }
  std::size_t point(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cell_columns_ + 1) +
           static_cast<std::size_t>(column);
  }
  /// A row of pixels between two rows of control points: how far it is down, and what is there at each column, in
  /// 2^-(kFractionBits - 6) px from -control_offset_px.
  void cross(int row, int y, std::vector<std::int32_t>& x_at, std::vector<std::int32_t>& y_at,
             std::vector<std::uint8_t>& there, const std::vector<std::uint8_t>& mapped) const {
    const std::int32_t below = (y & ((1 << ny_) - 1)) << (6 - ny_);
    const std::size_t top = point(0, row);
    const std::size_t bottom = below != 0 ? point(0, row + 1) : top;
    const auto columns = static_cast<std::size_t>(cell_columns_ + 1);
    calib::vectorised<between>(&controls_.x[top], &controls_.x[bottom], below, columns, x_at.data());
    calib::vectorised<between>(&controls_.y[top], &controls_.y[bottom], below, columns, y_at.data());
    for (std::size_t c = 0; c < columns; ++c) there[c] = mapped[top + c] & mapped[bottom + c];
  }

  /// A pixel, or for one beyond the image the last of its row and column: whether it is in its row's span.
  bool in_span(int x, int y) const {
    return outline_ == nullptr || span(std::min(y, geometry_.height - 1)).holds(std::min(x, geometry_.width - 1));
  }
  /// A sample on the skin beside the outline, which is followed there: nothing between the two can be missed.
  bool beside_outline(int x, int y) const {
    const int across = 1 << lattice_.shape.x_log2;
    const int down = 1 << lattice_.shape.y_log2;
    for (const int row : {y - down, y, y + down}) {
      if (row < 0 || row >= geometry_.height) continue;
      const hls::table::Span& span = spans_[static_cast<std::size_t>(row)];
      const bool left = span.first == 0 || x - across >= span.first;
      const bool right = span.end == geometry_.width || x + across < span.end;
      if (span.end == 0 || !left || !right) return true;
    }
    return false;
  }
  /// A sample in its row's span that must not be supervised.
  bool is_excluded_at(std::size_t sample, int x, int y) const {
    const Reason reason = lattice_.reasons[sample];
    return is_excluded(reason) && !(reason == Reason::grid && outline_ != nullptr && beside_outline(x, y));
  }

  const hls::table::Span& span(int row) const { return spans_[static_cast<std::size_t>(row)]; }

  /// Control points beyond the outline get places that continue the skin inside, so that the cells that the outline cuts
  /// are right up to it.
  void follow_outline() {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    std::vector<Point> points(controls_.word.size());
    std::vector<std::uint8_t> is_free(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool mapped = controls_.mapped[i] != 0;
      points[i] = {mapped ? place_of(controls_.x[i]) : kNan, mapped ? place_of(controls_.y[i]) : kNan};
    }
    mark_cut();
    std::vector<std::size_t> free;
    for_cut_cells([&](int column, int row) {
      for (const auto& [c, r] : {std::pair{column, row}, {column + 1, row}, {column, row + 1}, {column + 1, row + 1}}) {
        const std::size_t at = point(c, r);
        if (is_free[at] != 0 || is_fixed(c, r)) continue;
        is_free[at] = 1;
        free.push_back(at);
      }
    });
    continue_inside(free, is_free, points);
    std::erase_if(free, [&](std::size_t at) { return is_free[at] == 0; });
    ControlFit fit(std::move(free), points);
    for_cut_cells([&](int column, int row) { add_equations(column, row, fit); });
    fit.solve();
    for (const std::size_t at : fit.free()) controls_.set(at, MapTable::encode(points[at]));
  }
  template <class Visit>
  void for_cut_cells(Visit visit) const {
    for (int row = 0; row < cell_rows_; ++row) {
      for (int column = 0; column < cell_columns_; ++column) {
        if (cells_[index(column, row)].cut) visit(column, row);
      }
    }
  }
  static double place_of(std::int32_t control) {
    return static_cast<double>(control) / hls::table::control_scale - hls::table::control_offset_px;
  }

  /// Of each row of cells those that may hold pixels of spans, or have some on their borders: nothing is supervised in
  /// others.
  void find_cells_in_spans() {
    for (int row = 0; row < cell_rows_; ++row) {
      int first = geometry_.width;
      int end = 0;
      for (int y = row << ny_; y <= std::min((row + 1) << ny_, geometry_.height - 1); ++y) {
        if (span(y).first == span(y).end) continue;
        first = std::min(first, span(y).first);
        end = std::max(end, span(y).end);
      }
      const int begin = std::max(0, (first >> nx_) - 1);
      in_spans_[static_cast<std::size_t>(row)] = {begin, std::max(begin, (end + (1 << nx_) - 1) >> nx_)};
    }
  }
  /// Visits them.
  template <class Visit>
  void for_cells_in_spans(Visit visit) const {
    for (int row = 0; row < cell_rows_; ++row) {
      const auto [begin, end] = in_spans_[static_cast<std::size_t>(row)];
      for (int column = begin; column < end; ++column) visit(column, row);
    }
  }
  /// Which cells hold pixels of spans and others.
  void mark_cut() {
    for (Cell& cell : cells_) cell.cut = false;
    for (int row = 0; row < cell_rows_; ++row) {
      int least_first = geometry_.width;
      int largest_first = 0;
      int least_end = geometry_.width;
      int largest_end = 0;
      for (int y = row << ny_; y < std::min((row + 1) << ny_, geometry_.height); ++y) {
        const int first = span(y).end == 0 ? geometry_.width : span(y).first;
        least_first = std::min(least_first, first);
        largest_first = std::max(largest_first, first);
        least_end = std::min(least_end, span(y).end);
        largest_end = std::max(largest_end, span(y).end);
      }
      for (int column = least_first >> nx_; column << nx_ < largest_end; ++column) {
        const bool whole =
            column << nx_ >= largest_first && std::min((column + 1) << nx_, geometry_.width) <= least_end;
        cells_[index(column, row)].cut = !whole;
      }
    }
  }
  /// Whether a control point is on the skin by itself.
  bool is_fixed(int column, int row) const {
    const int x = column << nx_;
    const int y = row << ny_;
    const Reason reason = lattice_.reasons[lattice_.index(x, y)];
    return controls_.mapped[point(column, row)] != 0 && (reason == Reason::grid || !is_excluded(reason)) &&
           in_span(x, y);
  }
  /// Of a cell that the outline cuts, what its pixels see, row by row as if it was whole; NaN outside of the outline.
  std::size_t pixels_of(int column, int row) {
    Cell& cell = cells_[index(column, row)];
    if (cell.pixels < 0) {
      cell.pixels = static_cast<std::int32_t>(pixels_.size());
      constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
      pixels_.resize(pixels_.size() + (std::size_t{1} << (nx_ + ny_)), {kNan, kNan});
      for (int y = row << ny_; y < std::min((row + 1) << ny_, geometry_.height); ++y) {
        const hls::table::Span& whole = outline_->span(y);
        const int first = std::max(column << nx_, whole.first);
        const int end = std::min((column + 1) << nx_, whole.end);
        if (first >= end) continue;
        outline_->see(first, y,
                      std::span(pixels_).subspan(pixel(cell, first, y), static_cast<std::size_t>(end - first)));
      }
    }
    return static_cast<std::size_t>(cell.pixels);
  }
  std::size_t pixel(const Cell& cell, int x, int y) const {
    const int in_cell_y = y & ((1 << ny_) - 1);
    return static_cast<std::size_t>(cell.pixels) +
           static_cast<std::size_t>((in_cell_y << nx_) + (x & ((1 << nx_) - 1)));
  }
  /// Pixels of a cell that the outline cuts, eight at most either way.
  void add_equations(int column, int row, ControlFit& fit) {
    const std::size_t top = point(column, row);
    const std::size_t bottom = point(column, row + 1);
    const std::array<std::size_t, 4> at{top, top + 1, bottom, bottom + 1};
    const std::size_t pixels = pixels_of(column, row);
    if (!fit.moves(at)) return;
    const int across_log2 = std::max(0, nx_ - 3);
    const int down_log2 = std::max(0, ny_ - 3);
    const double counts = std::ldexp(1.0, across_log2 + down_log2 - nx_ - ny_);
    const double of_width = std::ldexp(1.0, -nx_);
    const double of_height = std::ldexp(1.0, -ny_);
    for (int y = 0; y < 1 << ny_; y += 1 << down_log2) {
      for (int x = 0; x < 1 << nx_; x += 1 << across_log2) {
        const Point& source = pixels_[pixels + static_cast<std::size_t>((y << nx_) + x)];
        if (std::isnan(source.x)) continue;
        fit.add(at, x * of_width, y * of_height, source, counts);
      }
    }
  }
  /// The columns of a cell that are in a row's span.
  std::pair<int, int> in_cell(int column, int y) const {
    return {std::max(column << nx_, span(y).first), std::min((column + 1) << nx_, span(y).end)};
  }
  /// Where a free control point would be if the skin went on straight from the two beside it on one side: the mean of all
  /// sides. Those that have none take it from others; what stays without one is no longer free.
  void continue_inside(const std::vector<std::size_t>& free, std::vector<std::uint8_t>& is_free,
                       std::vector<Point>& points) const {
    constexpr int kRounds = 3;
    const auto columns = static_cast<std::size_t>(cell_columns_ + 1);
    enum class Known : std::uint8_t { not_asked, no, yes };
    std::vector<Known> known(points.size(), Known::not_asked);
    const auto is_known = [&](std::size_t at, int column, int row) {
      if (known[at] == Known::not_asked) known[at] = is_fixed(column, row) ? Known::yes : Known::no;
      return known[at] == Known::yes;
    };
    std::vector<std::pair<std::size_t, Point>> found;
    for (int round = 0; round < kRounds; ++round) {
      found.clear();
      for (const std::size_t at : free) {
        if (known[at] == Known::yes) continue;
        const auto column = static_cast<int>(at % columns);
        const auto row = static_cast<int>(at / columns);
        Point sum{0, 0};
        int count = 0;
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}) {
          if (dx != 0 && dy != 0 && count > 0) break;  // across corners only where there is nothing else
          if (column + 2 * dx < 0 || column + 2 * dx > cell_columns_ || row + 2 * dy < 0 || row + 2 * dy > cell_rows_)
            continue;
          const std::size_t near = point(column + dx, row + dy);
          const std::size_t far = point(column + 2 * dx, row + 2 * dy);
          if (!is_known(near, column + dx, row + dy) || !is_known(far, column + 2 * dx, row + 2 * dy)) continue;
          sum.x += 2 * points[near].x - points[far].x;
          sum.y += 2 * points[near].y - points[far].y;
          ++count;
        }
        if (count > 0) found.push_back({at, {sum.x / count, sum.y / count}});
      }
      for (const auto& [at, place] : found) {
        points[at] = place;
        known[at] = Known::yes;
      }
    }
    for (const std::size_t at : free) is_free[at] = known[at] == Known::yes ? 1 : 0;
  }

  /// At every pixel of the cells that the outline cuts: near it the skin may bend more than samples show.
  void find_errors_in_cut_cells() {
    const std::int32_t half = std::int32_t{1} << (MapTable::kFractionBits - weight_bits_ - 1);
    const std::int32_t low = kOffset - half;
    const std::int32_t high_x = kOffset + ((geometry_.width - 1) << MapTable::kFractionBits) + half;
    const std::int32_t high_y = kOffset + ((geometry_.height - 1) << MapTable::kFractionBits) + half;
    cut_errors_.assign(pixels_.size(), -1);
    for_cut_cells([&](int column, int row) {
      Cell& cell = cells_[index(column, row)];
      const std::size_t top = point(column, row);
      const std::size_t bottom = point(column, row + 1);
      const auto there = [&](std::size_t a, std::size_t b) { return (controls_.mapped[a] & controls_.mapped[b]) != 0; };
      int beyond = 0;
      for (int y = row << ny_; y < std::min((row + 1) << ny_, geometry_.height); ++y) {
        const std::int32_t below = (y & ((1 << ny_) - 1)) << (6 - ny_);
        const std::size_t lower = below != 0 ? bottom : top;
        if (!there(top, lower)) continue;
        const auto down = [&](const std::vector<std::int32_t>& c, std::size_t side) {
          return c[top + side] * (64 - below) + c[lower + side] * below;
        };
        const std::int32_t left_x = down(controls_.x, 0);
        const std::int32_t left_y = down(controls_.y, 0);
        const std::int32_t right_x = down(controls_.x, 1);
        const std::int32_t right_y = down(controls_.y, 1);
        const bool whole = there(top + 1, lower + 1);
        const auto [begin, end] = in_cell(column, y);
        for (int x = begin; x < end; ++x) {
          const std::int32_t right = (x & ((1 << nx_) - 1)) << (6 - nx_);
          if (right != 0 && !whole) break;
          const std::int32_t ex = left_x * (64 - right) + right_x * right;
          const std::int32_t ey = left_y * (64 - right) + right_y * right;
          if (ex < low || ey < low || ex >= high_x || ey >= high_y) continue;
          const std::size_t at = pixel(cell, x, y);
          const double exactly = distance(error_of(ex, ey, pixels_[at]));
          const float error = std::isnan(exactly) ? kNever : static_cast<float>(exactly);
          float& worst = cell.worst[(right != 0 ? 1U : 0U) + (below != 0 ? 2U : 0U)];
          worst = std::max(worst, error);
          cut_errors_[at] = error;
          ++cell.errors;
          beyond += error > limits_.error_px ? 1 : 0;
        }
      }
      // They are all known.
      if (!every_pixel_ && cell.errors > 0) {
        cell.beyond_share = static_cast<float>(beyond) / static_cast<float>(cell.errors);
      }
    });
  }

  /// Takes from the ends of spans, in the cells that the outline cuts, what is off by more than the largest error: a few
  /// pixels in place of the whole cell. Whether there was such a thing.
  bool trim() {
    bool trimmed = false;
    for (int y = 0; y < geometry_.height; ++y) {
      hls::table::Span& here = spans_[static_cast<std::size_t>(y)];
      // How many pixels to take from x on, in a direction.
      const auto taken = [&](int x, int direction) {
        int last = 0;
        for (int count = 1; here.holds(x); ++count, x += direction) {
          const Cell& cell = cells_[index(x >> nx_, y >> ny_)];
          if (!cell.cut) break;
          if (cut_errors_[pixel(cell, x, y)] > limits_.largest_error_px) last = count;
        }
        return last;
      };
      const int left = taken(here.first, 1);
      const int right = taken(here.end - 1, -1);
      if (left + right == 0) continue;
      trimmed = true;
      here = left + right < here.end - here.first ? hls::table::Span{here.first + left, here.end - right}
                                                  : hls::table::Span{};
    }
    return trimmed;
  }

  void set_controls() {
    for (int row = 0; row <= cell_rows_; ++row) {
      const Point* sources = lattice_.sources_of_row(row << ny_);
      for (int column = 0; column <= cell_columns_; ++column) {
        const Point source = sources[(column << nx_) >> lattice_.shape.x_log2];
        if (!std::isnan(source.x)) controls_.set(point(column, row), MapTable::encode(source));
      }
    }
  }

  /// Between exact control points a smooth map errs to one side, most in the middle of the cell; half of that error
  /// given to the control points leaves half of it. Where all cells around a control point agree on the side: the mean
  /// of the largest and the smallest. Cells whose middle is not supervised have no say. Where half is more than the share
  /// that is wanted may err, more is given: the middle, where the error changes least, comes back within that.
  void centre_errors() {
    if (nx_ == 0 && ny_ == 0) return;
    // Of a row of cells, with nothing at both ends: the errors of those that have one, for a minimum and a maximum.
    struct Middles {
      explicit Middles(std::size_t cells) : low_x(cells + 2), high_x(cells + 2), low_y(cells + 2), high_y(cells + 2) {
        clear();
      }
      std::vector<double> low_x, high_x, low_y, high_y;

      void clear() {
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        for (auto* low : {&low_x, &low_y}) std::ranges::fill(*low, kInfinity);
        for (auto* high : {&high_x, &high_y}) std::ranges::fill(*high, -kInfinity);
      }
      void set(std::size_t cell, Point error) {
        low_x[cell + 1] = high_x[cell + 1] = error.x;
        low_y[cell + 1] = high_y[cell + 1] = error.y;
      }
    };
    const std::int32_t half_x = nx_ == 0 ? 0 : 32;
    const std::size_t middle_x = std::size_t{1} << nx_ >> 1;
    const int middle_y = 1 << ny_ >> 1;
    const auto columns = static_cast<std::size_t>(cell_columns_ + 1);
    std::vector<std::int32_t> x_at(columns);
    std::vector<std::int32_t> y_at(columns);
    std::vector<std::uint8_t> there(columns);
    Middles above(columns - 1);
    Middles here(columns - 1);
    std::vector<double> errors_x(columns);
    std::vector<double> errors_y(columns);
    for (int row = 0; row <= cell_rows_; ++row) {
      here.clear();
      if (row < cell_rows_) {
        const int y = (row << ny_) + middle_y;
        cross(row, y, x_at, y_at, there, controls_.mapped);
        const Point* sources = lattice_.sources_of_row(y);
        const Reason* reasons = lattice_.reasons_of_row(y);
        const std::uint8_t* top = &controls_.mapped[point(0, row)];
        const std::uint8_t* bottom = &controls_.mapped[point(0, row + 1)];
        for (std::size_t c = 0; c + 1 < columns; ++c) {
          if ((top[c] & top[c + 1] & bottom[c] & bottom[c + 1]) == 0) continue;
          const std::size_t middle = ((c << nx_) + middle_x) >> lattice_.shape.x_log2;
          const Point error = error_of(x_at[c] * (64 - half_x) + x_at[c + 1] * half_x,
                                       y_at[c] * (64 - half_x) + y_at[c + 1] * half_x, sources[middle]);
          // What is too far off to be mended by half is a crease, or no part of the skin.
          if (is_excluded(reasons[middle])) continue;  // it will not be supervised
          const bool smooth = distance(error) <= 2 * limits_.largest_error_px;
          here.set(c, smooth ? error : Point{0, 0});
        }
      }
      calib::vectorised<agree>(here.low_x.data(), above.low_x.data(), here.high_x.data(), above.high_x.data(), columns,
                               errors_x.data());
      calib::vectorised<agree>(here.low_y.data(), above.low_y.data(), here.high_y.data(), above.high_y.data(), columns,
                               errors_y.data());
      const Point* sources = lattice_.sources_of_row(row << ny_);
      for (std::size_t c = 0; c < columns; ++c) {
        const std::size_t at = point(0, row) + c;
        if (controls_.mapped[at] == 0 || (errors_x[c] == 0 && errors_y[c] == 0)) continue;
        const Point exact = sources[(c << nx_) >> lattice_.shape.x_log2];
        const double part = part_given(distance(errors_x[c], errors_y[c]));
        const auto word = MapTable::encode({exact.x - part * errors_x[c], exact.y - part * errors_y[c]});
        if (word != MapTable::kUnmapped) controls_.set(at, word);
      }
      std::swap(above, here);
    }
  }

  /// Of the error in the middle, to the control points; never so much that these come near the largest error.
  double part_given(double error_px) const {
    constexpr double kMost = 0.8;
    const double wanted = std::min(error_px - limits_.error_px, kMost * limits_.largest_error_px);
    return std::max(0.5, wanted / error_px);
  }

  /// Visits the samples whose control points are all there: `visit(sample, x, y, expanded x, y)`.
  template <class Visit>
  void for_expanded(const std::vector<std::uint8_t>& mapped, Visit visit) const {
    const auto columns = static_cast<std::size_t>(cell_columns_ + 1);
    std::vector<std::int32_t> x_at(columns);
    std::vector<std::int32_t> y_at(columns);
    std::vector<std::uint8_t> there(columns);
    const int step = nx_ - lattice_.shape.x_log2;
    const std::size_t across = std::size_t{1} << step;
    const auto samples = static_cast<std::size_t>(((geometry_.width - 1) >> lattice_.shape.x_log2) + 1);  // of a row
    for (int y = 0; y < geometry_.height; y += 1 << lattice_.shape.y_log2) {
      const int row = y >> ny_;
      cross(row, y, x_at, y_at, there, mapped);
      const std::size_t first_sample = sample(0, y);
      for (std::size_t c = 0; c + 1 < columns; ++c) {
        if (there[c] == 0) continue;
        const std::size_t first = c * across;
        const int x = static_cast<int>(first) << lattice_.shape.x_log2;
        visit(first_sample + first, x, y, x_at[c] * 64, y_at[c] * 64);
        if (there[c + 1] == 0) continue;
        const std::size_t count = std::min(across, samples - first);
        for (std::size_t i = 1; i < count; ++i) {
          const auto right = static_cast<std::int32_t>(i << (6 - step));
          visit(first_sample + first + i, x + (static_cast<int>(i) << lattice_.shape.x_log2), y,
                x_at[c] * (64 - right) + x_at[c + 1] * right, y_at[c] * (64 - right) + y_at[c + 1] * right);
        }
      }
    }
  }

  void find_errors() {
    const std::int32_t half = std::int32_t{1} << (MapTable::kFractionBits - weight_bits_ - 1);
    const ReadPlaces inside{kOffset - half, kOffset + ((geometry_.width - 1) << MapTable::kFractionBits) + half,
                            kOffset + ((geometry_.height - 1) << MapTable::kFractionBits) + half};
    const double share_error = limits_.error_px;
    const auto columns = static_cast<std::size_t>(cell_columns_ + 1);
    std::vector<std::int32_t> x_at(columns);
    std::vector<std::int32_t> y_at(columns);
    std::vector<std::uint8_t> there(columns);
    const int step = nx_ - lattice_.shape.x_log2;
    const std::size_t across = std::size_t{1} << step;
    const auto samples = static_cast<std::size_t>(((geometry_.width - 1) >> lattice_.shape.x_log2) + 1);  // of a row
    std::vector<double> errors(columns - 1);
    for (int y = 0; y < geometry_.height; y += 1 << lattice_.shape.y_log2) {
      // Samples in the row's span.
      const hls::table::Span held = outline_ != nullptr ? span(y) : hls::table::Span{0, geometry_.width};
      if (held.first == held.end) continue;
      const std::size_t first_held = samples_before(held.first);
      const std::size_t end_held = std::min(samples, samples_before(held.end));
      const int row = y >> ny_;
      cross(row, y, x_at, y_at, there, controls_.mapped);
      const std::size_t kind_y = (y & ((1 << ny_) - 1)) != 0 ? 2 : 0;
      Cell* const cells = &cells_[index(0, row)];
      const std::size_t first_sample = sample(0, y);
      for (std::size_t i = 0; i < across; ++i) {
        if (end_held <= i) break;
        // Cells whose sample i is one of those.
        const std::size_t begin = first_held > i ? (first_held - i + across - 1) >> step : 0;
        const std::size_t end = (end_held - i + across - 1) >> step;
        if (begin >= end) continue;
        const std::size_t first = first_sample + (begin << step) + i;
        const Between places{&x_at[begin], &y_at[begin], static_cast<std::int32_t>(i << (6 - step))};
        const Point* const sources = &lattice_.sources[first];
        if (across == 2) {
          calib::vectorised<sample_errors<2>>(places, sources, across, end - begin, inside, errors.data());
        } else {
          calib::vectorised<sample_errors<0>>(places, sources, across, end - begin, inside, errors.data());
        }
        const std::size_t kind = kind_y + (i != 0 ? 1 : 0);
        for (std::size_t c = begin; c < end; ++c) {
          const double error = errors[c - begin];
          if (error < 0 || there[c] == 0 || (i != 0 && there[c + 1] == 0)) continue;
          const std::size_t at = first + ((c - begin) << step);
          const Reason reason = lattice_.reasons[at];
          Cell& cell = cells[c];
          const auto rounded = static_cast<float>(error);
          // A source just outside may be expanded to one just inside; one without a place has no error that is small.
          const bool never = (is_excluded(reason) &&
                              is_excluded_at(at, static_cast<int>((c << step) + i) << lattice_.shape.x_log2, y)) ||
                             std::isnan(error);
          cell.worst[kind] = std::max(cell.worst[kind], never ? kNever : rounded);
          errors_[at] = rounded;
          ++cell.inside[kind];
          cell.beyond[kind] = static_cast<std::uint16_t>(cell.beyond[kind] + (error > share_error ? 1 : 0));
          cell.outside[kind] = static_cast<std::uint16_t>(cell.outside[kind] + (reason == Reason::outside ? 1 : 0));
        }
      }
    }
  }
  /// Samples of a row that lie before a pixel of it.
  std::size_t samples_before(int x) const {
    return static_cast<std::size_t>((x + (1 << lattice_.shape.x_log2) - 1) >> lattice_.shape.x_log2);
  }

  /// Between samples a cell has what the ones around it say, of which the last may lie beyond the cell and the image.
  void look_between_samples() {
    const int across = 1 << (nx_ - lattice_.shape.x_log2);
    const int down = 1 << (ny_ - lattice_.shape.y_log2);
    const auto last = [](int size, int log2, int at, int count) {
      return std::min(at + count, (size - 1 + (1 << log2) - 1) >> log2);
    };
    const auto samples = static_cast<std::size_t>(lattice_.shape.columns);
    std::vector<std::uint8_t> above(samples);  // excluded in the first row of the cells
    std::vector<std::uint8_t> all(samples);    // in any row
    for (int row = 0; row < cell_rows_; ++row) {
      const int top = row * down;
      const int bottom = ny_ == lattice_.shape.y_log2 ? top : last(geometry_.height, lattice_.shape.y_log2, top, down);
      bool none = true;
      std::ranges::fill(above, std::uint8_t{0});
      std::ranges::fill(all, std::uint8_t{0});
      for (int y = top; y <= bottom; ++y) {
        const int pixel_y = y << lattice_.shape.y_log2;
        const hls::table::Span held =
            outline_ != nullptr ? span(std::min(pixel_y, geometry_.height - 1)) : hls::table::Span{0, geometry_.width};
        if (held.first == held.end) continue;
        const std::size_t first = static_cast<std::size_t>(y) * samples;
        // Beyond the image as the row's last pixel.
        const std::size_t end = held.end == geometry_.width ? samples : samples_before(held.end);
        for (std::size_t x = samples_before(held.first); x < end; ++x) {
          if (!is_excluded(lattice_.reasons[first + x]) ||
              !is_excluded_at(first + x, static_cast<int>(x) << lattice_.shape.x_log2, pixel_y)) {
            continue;
          }
          none = false;
          all[x] = 1;
          if (y == top) above[x] = 1;
        }
      }
      if (none) continue;
      for (int column = 0; column < cell_columns_; ++column) {
        if (controls_.mapped[point(column, row)] == 0) continue;  // nothing in it is supervised
        const int left = column * across;
        const int right =
            nx_ == lattice_.shape.x_log2 ? left : last(geometry_.width, lattice_.shape.x_log2, left, across);
        bool upper = false;
        for (int x = left; x <= right; ++x) upper |= above[x] != 0;
        bool any = false;
        for (int x = left; x <= right; ++x) any |= all[x] != 0;
        if (!any) continue;
        Cell& cell = cells_[index(column, row)];
        if (right > left || bottom > top) cell.worst[3] = kNever;
        if (all[left] != 0 && bottom > top) cell.worst[2] = kNever;
        if (upper && right > left) cell.worst[1] = kNever;
      }
    }
  }

  bool mapped_cell(int column, int row) const {
    const std::size_t top = point(column, row);
    const std::size_t bottom = point(column, row + 1);
    return (kept_[top] & kept_[top + 1] & kept_[bottom] & kept_[bottom + 1]) != 0;
  }

  /// Cells without anything bad that a control point carries.
  int carried(int column, int row) const {
    int count = 0;
    for (int r = std::max(0, row - 1); r <= std::min(row, cell_rows_ - 1); ++r) {
      for (int c = std::max(0, column - 1); c <= std::min(column, cell_columns_ - 1); ++c) {
        if (bad_[index(c, r)] == 0 && mapped_cell(c, r)) ++count;
      }
    }
    return count;
  }

  /// Unmaps, of control points that are all mapped, the one that carries least.
  void break_up(std::initializer_list<std::pair<int, int>> points) {
    if (!std::ranges::all_of(points, [&](const auto& p) { return kept_[point(p.first, p.second)] != 0; })) return;
    const auto least = std::ranges::min_element(points, {}, [&](const auto& p) { return carried(p.first, p.second); });
    kept_[point(least->first, least->second)] = 0;
  }

  /// Keeps the control points without which nothing is off by more than `bound`.
  void keep_within(double bound) {
    kept_ = controls_.mapped;
    bad_.assign(cells_.size(), 0);
    std::vector<std::pair<int, int>> bad;
    for_cells_in_spans([&](int column, int row) {
      const auto& worst = cells_[index(column, row)].worst;
      if (!(std::max(std::max(worst[0], worst[1]), std::max(worst[2], worst[3])) > bound)) return;
      bad.emplace_back(column, row);
      bad_[index(column, row)] = 1;
    });
    const auto is_bad = [&](int column, int row, int kind) { return cells_[index(column, row)].worst[kind] > bound; };
    // What leaves least choice first.
    for (const auto& [column, row] : bad) {
      if (is_bad(column, row, 0)) kept_[point(column, row)] = 0;
    }
    for (const auto& [column, row] : bad) {
      if (is_bad(column, row, 2)) break_up({{column, row}, {column, row + 1}});
      if (is_bad(column, row, 1)) break_up({{column, row}, {column + 1, row}});
    }
    for (const auto& [column, row] : bad) {
      break_up({{column, row}, {column + 1, row}, {column, row + 1}, {column + 1, row + 1}});
    }
    count_kept();
  }

  /// Which kinds of a cell's pixels have all their control points.
  std::array<bool, kKinds> kept_kinds(int column, int row) const {
    const std::size_t top = point(column, row);
    const std::size_t bottom = point(column, row + 1);
    const bool corner = kept_[top] != 0;
    const bool upper = corner && kept_[top + 1] != 0;
    const bool left = corner && kept_[bottom] != 0;
    return {corner, upper, left, upper && left && kept_[bottom + 1] != 0};
  }

  /// Samples that stand for pixels when errors are ranked: all of them, or those of cells that are whole. The others
  /// stand for parts of edges. Those of cells that the outline cuts may be left out.
  bool ranked(const Cell& cell, const std::array<bool, kKinds>& kept) const {
    if (cell.cut && leaves_out_cut_) return false;
    return every_pixel_ ? kept[0] : kept[(nx_ > 0 ? 1 : 0) + (ny_ > 0 ? 2 : 0)];
  }

  /// Errors of a cell at 8 × 8 places: the biquadratic through its four samples and those of the cells around that lie on
  /// its border.
  CellErrors errors_within(int column, int row) const {
    const std::size_t top = point(column, row);
    const std::size_t bottom = point(column, row + 1);
    CellNodes nodes;
    for (std::int32_t j = 0; j < 3; ++j) {
      for (std::int32_t i = 0; i < 3; ++i) {
        const auto at = [&](const std::vector<std::int32_t>& c) {
          return (c[top] * (64 - 32 * j) + c[bottom] * 32 * j) * (64 - 32 * i) +
                 (c[top + 1] * (64 - 32 * j) + c[bottom + 1] * 32 * j) * 32 * i;
        };
        const int x = (column << nx_) + (i << nx_ >> 1);
        const int y = (row << ny_) + (j << ny_ >> 1);
        nodes[static_cast<std::size_t>(3 * j + i)] =
            error_of(at(controls_.x), at(controls_.y), lattice_.sources[lattice_.index(x, y)]);
      }
    }
    CellErrors errors;
    calib::vectorised<biquadratic>(nodes, errors);
    return errors;
  }

  /// Of cells with samples further off than the share that is wanted may be: the share of their pixels that are. The
  /// samples are the extremes of a cell, so to count them would be to count too many. Whether there are such cells.
  bool interpolate_errors() {
    if (!smooth_ || nx_ - lattice_.shape.x_log2 != 1 || ny_ - lattice_.shape.y_log2 != 1) return false;
    // Where an outline lets cells be large, more than the samples may be beyond.
    constexpr int kLargeLog2 = 8;
    const bool large = outline_ != nullptr && nx_ + ny_ >= kLargeLog2;
    const auto least = static_cast<float>(large ? 0.5 * limits_.error_px : limits_.error_px);
    bool any = false;
    for (int row = 0; row < cell_rows_; ++row) {
      const auto [begin, end] = in_spans_[static_cast<std::size_t>(row)];
      for (int column = begin; column < end; ++column) {
        Cell& cell = cells_[index(column, row)];
        if (cell.beyond_share >= 0) continue;
        const float worst = std::max(std::max(cell.worst[0], cell.worst[1]), std::max(cell.worst[2], cell.worst[3]));
        if (worst <= least) continue;
        const std::size_t top = point(column, row);
        const std::size_t bottom = point(column, row + 1);
        if ((controls_.mapped[top] & controls_.mapped[top + 1] & controls_.mapped[bottom] &
             controls_.mapped[bottom + 1]) == 0) {
          continue;
        }
        std::size_t beyond = 0;
        for (const float error : errors_within(column, row)) {
          beyond += !(error <= static_cast<float>(limits_.error_px)) ? 1 : 0;
        }
        cell.beyond_share = static_cast<float>(beyond) / kCellErrors;
        any = true;
      }
    }
    return any;
  }

  /// In a whole cell, or, of one that the outline cuts, as many as its pixels would be.
  double samples_in(const Cell& cell) const {
    if (cell.cut) return std::ldexp(cell.errors, -lattice_.shape.x_log2 - lattice_.shape.y_log2);
    return cell.inside[0] + cell.inside[1] + cell.inside[2] + cell.inside[3];
  }

  /// What is kept.
  struct Tally {
    double supervised = 0;  ///< pixels, samples standing for those around them
    double outside = 0;     ///< of them just outside without the grid
    double ranked = 0;      ///< samples
    double beyond = 0;      ///< of them further off than the share that is wanted may be
  };
  void count_kept() {
    tally_ = {};
    for_cells_in_spans([&](int column, int row) {
      if (kept_[point(column, row)] == 0) return;
      const auto kept = kept_kinds(column, row);
      const Cell& cell = cells_[index(column, row)];
      const Weights& weight = weights_of(column, row);
      const bool counts = ranked(cell, kept);
      for (int kind = 0; kind < kKinds; ++kind) {
        if (!kept[kind]) continue;
        tally_.supervised += weight.kind[kind] * cell.inside[kind];
        tally_.outside += weight.kind[kind] * cell.outside[kind];
        if (!counts || cell.beyond_share >= 0) continue;
        tally_.ranked += cell.inside[kind];
        tally_.beyond += cell.beyond[kind];
      }
      if (!counts || cell.beyond_share < 0) return;
      tally_.ranked += samples_in(cell);
      tally_.beyond += cell.beyond_share * samples_in(cell);
    });
  }

  /// Whether the share that is wanted lies within its bound.
  bool precise() const { return tally_.beyond <= (1 - limits_.share) * tally_.ranked; }

  /// Pixels by reason, samples standing for those around them.
  void count_pixels() {
    std::array<double, kReasonCount> pixels{};
    // By reason without the grid: runs of samples of one reason, of which those on the left edges of cells stand for
    // less.
    const int step = nx_ - lattice_.shape.x_log2;
    const int across = 1 << step;
    const int last = (geometry_.width - 1) >> lattice_.shape.x_log2;
    for (int y = 0; y < geometry_.height; y += 1 << lattice_.shape.y_log2) {
      const int kind_y = (y & ((1 << ny_) - 1)) != 0 ? 2 : 0;
      const Reason* reasons = lattice_.reasons_of_row(y);
      const int cut = (cell_columns_ - 1) * across;  // the last cell may be
      for (int x = 0; x <= last;) {
        const int begin = x;
        const int limit = x < cut ? cut : last + 1;
        const Reason reason = reasons[begin];
        while (x < limit && reasons[x] == reason) ++x;
        const int edges = ((x + across - 1) >> step) - ((begin + across - 1) >> step);
        const Weights& weight = weights_of(begin < cut ? 0 : cell_columns_ - 1, y >> ny_);
        pixels[static_cast<std::size_t>(reason)] +=
            weight.kind[kind_y] * edges + weight.kind[kind_y + 1] * (x - begin - edges);
      }
      report_.checked += last + 1;
    }
    // What would be supervised, or was given to the grid before, and is not.
    const auto of = [&](Reason reason) -> double& { return pixels[static_cast<std::size_t>(reason)]; };
    of(Reason::outside) -= tally_.outside;
    of(Reason::grid) += of(Reason::none) - (tally_.supervised - tally_.outside);
    of(Reason::none) = tally_.supervised;
    for (std::size_t i = 0; i < kReasonCount; ++i) report_.by_reason[i] = std::llround(pixels[i]);
  }

  void measure() {
    report_.spacing_x = 1 << nx_;
    report_.spacing_y = 1 << ny_;
    report_.pool_bytes = MapTable::pool_bytes(geometry_, nx_, ny_, outline_ != nullptr);
    report_.pixels = std::int64_t{geometry_.width} * geometry_.height;
    count_pixels();
    if (report_.supervised() == 0) return;
    rank_errors();
    if (every_pixel_) {
      measure_rounded();
    } else {
      measure_reach();
    }
  }

  struct Ranked {
    float error;
    float samples;  ///< for which it stands
  };
  /// Ranked errors above a bound.
  std::vector<Ranked> errors_above(float bound) const {
    std::vector<Ranked> errors;
    const int step_x = nx_ - lattice_.shape.x_log2;
    const int step_y = ny_ - lattice_.shape.y_log2;
    const int last_x = (geometry_.width - 1) >> lattice_.shape.x_log2;
    const int last_y = (geometry_.height - 1) >> lattice_.shape.y_log2;
    for (int row = 0; row < cell_rows_; ++row) {
      const auto [begin, end] = in_spans_[static_cast<std::size_t>(row)];
      for (int column = begin; column < end; ++column) {
        if (kept_[point(column, row)] == 0) continue;
        const Cell& cell = cells_[index(column, row)];
        const auto& worst = cell.worst;
        if (!(std::max(std::max(worst[0], worst[1]), std::max(worst[2], worst[3])) > bound)) continue;
        const auto kept = kept_kinds(column, row);
        if (!ranked(cell, kept)) continue;
        if (cell.beyond_share >= 0) {
          const auto samples = static_cast<float>(samples_in(cell));
          const auto add = [&](std::span<const float> all, int count) {
            for (const float error : all) {
              if (error > bound && error >= 0) errors.push_back({error, samples / static_cast<float>(count)});
            }
          };
          if (cell.cut) {
            add(std::span(cut_errors_).subspan(static_cast<std::size_t>(cell.pixels), std::size_t{1} << (nx_ + ny_)),
                cell.errors);
          } else {
            add(errors_within(column, row), kCellErrors);
          }
          continue;
        }
        for (int y = row << step_y; y < (row + 1) << step_y && y <= last_y; ++y) {
          for (int x = column << step_x; x < (column + 1) << step_x && x <= last_x; ++x) {
            const int kind = (x != column << step_x ? 1 : 0) + (y != row << step_y ? 2 : 0);
            const float error = errors_[sample(x, y << lattice_.shape.y_log2)];
            if (kept[kind] && error > bound) errors.push_back({error, 1});
          }
        }
      }
    }
    return errors;
  }

  /// Of errors that stand for more than `beyond` samples the largest such that it and those above do. Sorts some of them.
  static float ranked_error(std::span<Ranked> errors, double beyond) {
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

  void rank_errors() {
    if (tally_.ranked == 0) return;
    // From the largest on; most are small.
    const double beyond = (1 - limits_.share) * tally_.ranked;
    for (const double bound : {0.45 * limits_.error_px, 0.25 * limits_.error_px, -1.0}) {
      std::vector<Ranked> errors = errors_above(static_cast<float>(bound));
      double samples = 0;
      for (const Ranked& error : errors) samples += error.samples;
      if (!(samples > beyond)) continue;
      report_.error_largest_px = std::ranges::max(errors, {}, &Ranked::error).error;
      report_.error_99_px = ranked_error(errors, beyond);
      return;
    }
  }

  /// The source row that pixels of row y read lowest or highest, in 2^-weight_bits px, and whether they read the next.
  void reach(int y, std::int64_t source) {
    const auto first = static_cast<int>(source >> weight_bits_);
    const int last = first + ((source & ((1 << weight_bits_) - 1)) != 0 ? 1 : 0);
    report_.reach.behind = std::max(report_.reach.behind, y - first);
    report_.reach.ahead = std::max(report_.reach.ahead, last - y);
  }

  std::int64_t rounded(std::int32_t expanded) const {
    const int drop = MapTable::kFractionBits - weight_bits_;
    return (expanded - kOffset + (std::int32_t{1} << (drop - 1))) >> drop;
  }

  /// Bilinear in the cell, so the extremes lie at its corners.
  void measure_reach() {
    report_.reach = {-geometry_.height, -geometry_.height};
    const auto columns = static_cast<std::size_t>(cell_columns_ + 1);
    std::vector<std::int32_t> x_at(columns);
    std::vector<std::int32_t> y_at(columns);
    std::vector<std::uint8_t> there(columns);
    const std::int32_t highest = kOffset + ((geometry_.height - 1) << MapTable::kFractionBits);
    for (int row = 0; row < cell_rows_; ++row) {
      const int bottom = std::min((row + 1) << ny_, geometry_.height) - 1;
      for (const int y : {row << ny_, bottom}) {
        cross(row, y, x_at, y_at, there, kept_);
        std::int32_t lowest_y = std::numeric_limits<std::int32_t>::max();
        std::int32_t highest_y = std::numeric_limits<std::int32_t>::min();
        const auto add = [&](std::int32_t source) {
          lowest_y = std::min(lowest_y, source);
          highest_y = std::max(highest_y, source);
        };
        const auto [begin, end] = in_spans_[static_cast<std::size_t>(row)];
        for (int column = begin; column < end; ++column) {
          const auto c = static_cast<std::size_t>(column);
          if (there[c] == 0) continue;
          const auto kept = kept_kinds(column, row);
          const Cell& cell = cells_[index(column, row)];
          bool supervised = false;
          for (int kind = 0; kind < kKinds; ++kind) supervised |= kept[kind] && (cell.inside[kind] > 0 || cell.cut);
          if (!supervised) continue;
          add(y_at[c] * 64);
          const int right = (std::min((column + 1) << nx_, geometry_.width) - 1 - (column << nx_)) << (6 - nx_);
          if (right != 0 && there[c + 1] != 0) add(y_at[c] * (64 - right) + y_at[c + 1] * right);
        }
        if (lowest_y > highest_y) continue;
        for (const std::int32_t source : {lowest_y, highest_y}) reach(y, rounded(std::clamp(source, kOffset, highest)));
      }
    }
  }

  void measure_rounded() {
    report_.reach = {-geometry_.height, -geometry_.height};
    const std::int64_t last_x = std::int64_t{geometry_.width - 1} << weight_bits_;
    const std::int64_t last_y = std::int64_t{geometry_.height - 1} << weight_bits_;
    for_expanded(kept_, [&](std::size_t sample, int x, int y, std::int32_t ex, std::int32_t ey) {
      if (!in_span(x, y)) return;
      const std::int64_t source_x = rounded(ex);
      const std::int64_t source_y = rounded(ey);
      if (source_x < 0 || source_y < 0 || source_x > last_x || source_y > last_y) return;
      const Point exact = lattice_.sources[sample];
      const double off = distance(std::ldexp(static_cast<double>(source_x), -weight_bits_) - exact.x,
                                  std::ldexp(static_cast<double>(source_y), -weight_bits_) - exact.y);
      report_.rounded_largest_px = std::max(report_.rounded_largest_px, off);
      reach(y, source_y);
    });
  }

  std::size_t sample(int x, int y) const { return lattice_.index(0, y) + static_cast<std::size_t>(x); }

  const LookLattice& lattice_;
  const ScanGeometry& geometry_;
  const MapLimits& limits_;
  bool smooth_;
  int nx_, ny_, weight_bits_;
  bool every_pixel_;
  const Outline* outline_;  ///< or none
  bool leaves_out_cut_ = false;
  int cell_columns_, cell_rows_;
  Controls controls_;               ///< before any is given up
  std::vector<std::uint8_t> kept_;  ///< that are not
  std::vector<Cell> cells_;
  std::array<Weights, 4> weights_;
  Tally tally_;
  std::vector<std::uint8_t> bad_;  ///< cells with something that must not be supervised
  std::vector<hls::table::Span> spans_;
  std::vector<std::pair<int, int>> in_spans_;  ///< of each row of cells: all without an outline
  std::vector<Point> pixels_;      ///< sources of all pixels of cells that the outline cuts, cell by cell; NaN without
  std::vector<float> cut_errors_;  ///< of the same; -1 outside of spans, or without all control points
  std::vector<float> errors_;      ///< of the lattice's samples; NaN where none would be read inside the image
  MapReport report_;
};

struct Spacing {
  int nx, ny;
  std::size_t bytes;
};

/// That fit, fewest bytes first.
std::vector<Spacing> spacings_of(const ScanGeometry& geometry, int largest_log2, std::size_t largest_bytes, bool spans,
                                 std::size_t areas) {
  std::vector<Spacing> spacings;
  for (int nx = 0; nx <= largest_log2; ++nx) {
    for (int ny = 0; ny <= largest_log2; ++ny) {
      const std::size_t bytes = MapTable::pool_bytes(geometry, nx, ny, spans, areas);
      if (bytes <= largest_bytes) spacings.push_back({nx, ny, bytes});
    }
  }
  std::ranges::sort(spacings, {}, &Spacing::bytes);
  return spacings;
}

/// Of a table that knows them.
std::size_t areas_of(const MachineProfile& profile, const ScanGeometry& geometry) {
  hls::table::Facts facts;
  facts.subsample = profile.subsample;
  return facts.area_count({.width = geometry.width, .height = geometry.height});
}

std::string rows_text(RowReach reach) {
  return fmt::format("y{:+d} to y{:+d} ({} rows)", -reach.behind, reach.ahead, reach.ahead + reach.behind + 1);
}

/// Nothing of a skin is supervised.
class UnseenError : public std::runtime_error {
 public:
  explicit UnseenError(const MapReport& report) : std::runtime_error(text(report)) {}

 private:
  static std::string text(const MapReport& report);
};

std::string UnseenError::text(const MapReport& report) {
  std::string text = "no pixel is supervised";
  for (int i = 1; i < kReasonCount; ++i) {
    if (report.by_reason[i] == 0) continue;
    text += fmt::format(", {:.1f} % {}",
                        100.0 * static_cast<double>(report.by_reason[i]) / static_cast<double>(report.pixels),
                        reason_text(static_cast<Reason>(i)));
  }
  return text;
}

/// Control points, as many of them as there are rows of pixels for.
LatticeShape control_shape(const MapTable& table) {
  return LatticeShape::of(table.geometry(), table.spacing_x_log2(), table.spacing_y_log2(), table.spacing_x_log2(),
                          table.spacing_y_log2());
}

/// The control points that show nothing yet.
std::vector<std::uint8_t> without_source(const LatticeShape& shape, const MapTable& table) {
  std::vector<std::uint8_t> without;
  without.reserve(shape.count());
  for (int row = 0; row < shape.rows; ++row) {
    for (int column = 0; column < shape.columns; ++column) {
      without.push_back(table.control(column, row) == MapTable::kUnmapped ? 1 : 0);
    }
  }
  return without;
}

/// What is around the skin gets sources, in frame coordinates: for every control point.
void show_around(const LatticeShape& shape, const std::vector<Point>& sources, MapTable& table) {
  for (int row = 0; row < std::min(shape.rows, table.rows()); ++row) {
    for (int column = 0; column < std::min(shape.columns, table.columns()); ++column) {
      if (table.control(column, row) != MapTable::kUnmapped) continue;
      const auto at =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(shape.columns) + static_cast<std::size_t>(column);
      const Point source = table.geometry().from_frame(sources[at]);
      table.set_control(column, row, hls::table::around_skin_instead(MapTable::encode(source)));
    }
  }
}

void seal(CompiledMap& map, const hls::table::Facts& facts) {
  map.table.seal(facts);
  map.report.crc = map.table.crc();
  map.report.pool_bytes = map.table.pool_bytes();
}

/// The coarsest grid within the limits; where none loses little enough, of those that the forecast says to lose least
/// the one that does. `fit` tries a spacing, with an outline's spans if there is one, and without where that is not enough; those that the forecast says to be beyond `margin` times the limits are not
/// tried. `areas`: how many of them the table will hold. To be sealed.
CompiledMap choose(const MachineProfile& profile, const ScanGeometry& geometry, const MapLimits& limits,
                   const Forecast& forecast, std::size_t areas, const Outline* outline,
                   const std::function<GridFit(int, int, const Outline*)>& fit, double margin) {
  const std::size_t largest = limits.largest_bytes != 0 ? limits.largest_bytes : profile.pool_bytes;
  const std::vector<Spacing> spacings =
      spacings_of(geometry, limits.largest_spacing_log2, largest, outline != nullptr, areas);
  std::optional<CompiledMap> best;
  std::optional<CompiledMap> best_of_whole_cells;  // within the limits, but for cells that the outline cuts
  std::optional<UnseenError> nothing;
  std::vector<const Spacing*> tried;
  const auto consider = [&](const GridFit& grid) {
    const MapReport& report = grid.report();
    if (report.supervised() == 0) {
      nothing = UnseenError(report);
      return false;
    }
    const double lost = report.lost_share();
    const bool good = lost <= limits.largest_lost_share;
    if (good || !best || lost < best->report.lost_share()) best = grid.take();
    return good;
  };
  const auto attempt = [&](const Spacing& spacing) {
    if (std::ranges::find(tried, &spacing) != tried.end()) return false;
    tried.push_back(&spacing);
    GridFit grid = fit(spacing.nx, spacing.ny, outline);
    if (consider(grid)) return true;
    const double much_less = std::min(kMuchLess * grid.report().lost_share(), kNearly * limits.largest_lost_share);
    if (!best_of_whole_cells && grid.leave_out_cut() &&
        grid.report().lost_share() <= std::max(limits.largest_lost_share, much_less)) {
      best_of_whole_cells = grid.take();
    }
    if (best_of_whole_cells) return false;
    return outline != nullptr && consider(fit(spacing.nx, spacing.ny, nullptr));
  };
  const auto beyond = [&](const Spacing& s, double error_px) { return forecast.share_beyond(s.nx, s.ny, error_px); };
  const auto likely = [&](const Spacing& s) {
    return (outline != nullptr || forecast.lost_share(s.nx, s.ny) <= limits.largest_lost_share * margin) &&
           beyond(s, limits.error_px * margin) <= (1 - limits.share) * margin;
  };
  const bool found = std::ranges::any_of(spacings, [&](const Spacing& s) { return likely(s) && attempt(s); });
  if (!found && !best_of_whole_cells) {
    // Where creases, or the border of what is seen, keep too many pixels off, the grid loses them all.
    std::multimap<double, const Spacing*> last;  // equal ones in the order of `spacings`
    for (const Spacing& s : spacings) {
      const double too_many = std::max(0.0, beyond(s, limits.error_px) - (1 - limits.share));
      last.emplace(forecast.lost_share(s.nx, s.ny) + too_many, &s);
    }
    std::ranges::any_of(last | std::views::take(kLastTries), [&](const auto& s) {
      return s.first <= kWorthATry * last.begin()->first && (attempt(*s.second) || best_of_whole_cells);
    });
  }
  if (best_of_whole_cells && !(best && best->report.lost_share() <= limits.largest_lost_share)) {
    best = std::move(best_of_whole_cells);
  }
  if (!best && nothing) throw UnseenError(*nothing);
  if (!best) {
    throw std::runtime_error(
        fmt::format("no table of at most {} bytes (the pool of profile {} holds {}) stays within {} "
                    "px of it for {} % of the pixels",
                    largest, profile.name, profile.pool_bytes, limits.error_px, 100 * limits.share));
  }
  const auto lookahead = lookahead_for(profile, best->report.reach);
  if (!lookahead) {
    throw std::runtime_error(
        fmt::format("left row y needs the right rows {}; the store of profile {} holds {} rows, of "
                    "which it gives {}{}",
                    rows_text(best->report.reach), profile.name, profile.store_rows,
                    rows_text({profile.rows_behind(), profile.largest_lookahead()}),
                    store_that_holds(profile, best->report.reach)));
  }
  best->report.lookahead = *lookahead;
  return *std::move(best);
}

}  // namespace

CompiledMap compile_map(const Skin& skin, const MachineProfile& profile, const ScanGeometry& geometry,
                        const MapLimits& limits) {
  LookLattice lattice;
  lattice.resize(LatticeShape::of(geometry, 0, 0, MapTable::kLargestSpacingLog2, MapTable::kLargestSpacingLog2));
  const std::vector<Point> points = lattice.shape.points(geometry);
  // Row by row: lines of sight of a whole frame would take more memory than what they see.
  std::vector<Look> looks(static_cast<std::size_t>(lattice.shape.columns));
  for (std::size_t first = 0; first < points.size(); first += looks.size()) {
    skin.look(std::span(points).subspan(first, looks.size()), geometry.row_step(), limits.view, looks);
    lattice.take(looks, geometry, first);
  }
  check_rows(lattice, geometry, limits.view);
  const auto* const rig_skin = dynamic_cast<const RigSkin*>(&skin);
  const bool simple = rig_skin != nullptr && rig_skin->surface()->simple();
  const std::optional<Outline> outline = limits.spans ? outline_of(lattice, geometry) : std::nullopt;
  // The forecast only sorts out what is far off.
  CompiledMap map = choose(
      profile, geometry, limits, Forecast(lattice, geometry), rig_skin != nullptr ? areas_of(profile, geometry) : 0,
      outline ? &*outline : nullptr,
      [&](int nx, int ny, const Outline* spans) {
        return GridFit(lattice, geometry, nx, ny, profile.weight_bits, limits, simple, spans);
      },
      4);
  const LatticeShape shape = control_shape(map.table);
  const std::vector<Point> controls = shape.points(geometry);
  std::vector<Point> sources(controls.size());
  skin.look_around(controls, sources);
  show_around(shape, sources, map.table);
  hls::table::Facts facts = facts_of(map.table, profile);
  if (rig_skin != nullptr) {
    SkinScale(rig_skin->cameras(), profile, geometry).measure(*rig_skin->surface(), facts);
  }
  seal(map, facts);
  return map;
}

MapSet compile_maps(const SkinFile& skin, const MachineProfile& profile, int image_width, int image_height,
                    const ViewLimits& view) {
  MapSet set{std::string(profile.name), image_width, image_height, skin.skin->description(), skin.rig, {}};
  RowReach reach;
  MapLimits limits;
  limits.view = view;
  for (const ScanGeometry& geometry : scans_of(profile, image_width, image_height)) {
    try {
      set.maps.push_back(compile_map(*skin.skin, profile, geometry, limits));
    } catch (const RowError& error) {
      throw FileError(skin.path, "surface", error.what(), RowError::expected());
    } catch (const UnseenError& error) {
      throw FileError(skin.path, "surface", fmt::format("the cameras do not see this skin: {}", error.what()),
                      skin.rig.empty() ? "a skin in both images, in pixels"
                                       : "a skin before both cameras, in mm of the rig's world; z of a world that is "
                                         "the left camera points forward");
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
                    fmt::format("what {} rows of profile {} hold{}", profile.store_rows, profile.name,
                                store_that_holds(profile, reach)));
  }
  for (CompiledMap& map : set.maps) map.report.lookahead = *lookahead;
  return set;
}

MapCompiler::MapCompiler(CameraPair cameras, const MachineProfile& profile, const ScanGeometry& geometry,
                         const MapLimits& limits)
    : cameras_(std::move(cameras)),
      profile_(profile),
      geometry_(geometry),
      limits_(limits),
      scale_(cameras_, profile, geometry),
      outlines_(cameras_, geometry, limits.view) {}

const Rays& MapCompiler::rays(const LatticeShape& shape) {
  auto rays = rays_.find(shape);
  if (rays == rays_.end()) rays = rays_.emplace(shape, cameras_.rays(shape.points(geometry_), limits_.view)).first;
  return rays->second;
}

void MapCompiler::look(const Surface& surface, const LatticeShape& shape, LookLattice& lattice) {
  const Rays& sights = rays(shape);
  lattice.resize(shape);
  constexpr std::size_t kAtATime = 512;  // what stays in a fast cache
  std::array<Look, kAtATime> looks;
  for (std::size_t first = 0; first < sights.size(); first += kAtATime) {
    const auto part = std::span(looks).first(std::min(kAtATime, sights.size() - first));
    cameras_.look(surface, sights, geometry_.row_step(), limits_.view, part, first);
    lattice.take(part, geometry_, first);
  }
  check_rows(lattice, geometry_, limits_.view);
}

CompiledMap MapCompiler::compile(const Surface& surface) {
  surface.check_cameras(cameras_.left().world_to_camera.centre(), cameras_.right().world_to_camera.centre());
  LookLattice coarse;
  look(surface, LatticeShape::of(geometry_, kForecastLog2, kForecastLog2, kForecastLog2, kForecastLog2), coarse);
  const Forecast forecast(coarse, geometry_);
  const std::optional<Outline> outline = limits_.spans ? outlines_.trace(cameras_, surface, coarse) : std::nullopt;
  lattice_.shape = {};
  const int coarsest = surface.simple() ? kSmoothLog2 : kFeatureLog2;
  const auto fit = [&](int nx, int ny, const Outline* spans) {
    const int x_log2 = std::min(std::max(nx - 1, 0), coarsest);
    const int y_log2 = std::min(std::max(ny - 1, 0), coarsest);
    const LatticeShape shape = LatticeShape::of(geometry_, x_log2, y_log2, nx, ny);
    if (shape != lattice_.shape) {
      look(surface, shape, lattice_);
      if (surface.simple()) lattice_.keep_clear_of_limits();
    }
    return GridFit(lattice_, geometry_, nx, ny, profile_.weight_bits, limits_, surface.simple(), spans);
  };
  CompiledMap map = choose(profile_, geometry_, limits_, forecast, areas_of(profile_, geometry_),
                           outline ? &*outline : nullptr, fit, 1.1);
  const LatticeShape controls = control_shape(map.table);
  std::vector<Point> sources(rays(controls).size());
  cameras_.look_around(surface, rays(controls), sources, without_source(controls, map.table));
  show_around(controls, sources, map.table);
  hls::table::Facts facts = facts_of(map.table, profile_);
  scale_.measure(surface, facts);
  seal(map, facts);
  return map;
}

}  // namespace horopter
