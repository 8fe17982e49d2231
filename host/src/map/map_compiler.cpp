// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/map_compiler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <ranges>
#include <stdexcept>
#include <utility>

#include "horopter/base/error.hpp"
#include "stages/planes.hpp"

namespace horopter {

struct LookLattice {
  LatticeShape shape;
  std::vector<Look> looks;  ///< with sources in the scan's coordinates

  /// At a pixel of the lattice.
  const Look& at(int x, int y) const {
    return looks[static_cast<std::size_t>(y >> shape.y_log2) * static_cast<std::size_t>(shape.columns) +
                 static_cast<std::size_t>(x >> shape.x_log2)];
  }
};

namespace {

constexpr int kForecastLog2 = 4;
/// Coarsest steps between samples: enough for second differences of what is smooth; 4 pixels where it may not be.
constexpr int kSmoothLog2 = 5;
constexpr int kFeatureLog2 = 2;
/// Grids tried where none loses little enough.
constexpr int kLastTries = 3;

constexpr double kFraction = 1.0 / (1 << MapTable::kFractionBits);

double distance(double x, double y) { return std::sqrt(x * x + y * y); }
double distance(Point p) { return distance(p.x, p.y); }

/// Never supervised, wherever the source lies.
bool is_excluded(Reason reason) { return reason != Reason::none && reason != Reason::outside; }

/// As far beyond the image as the control points of a spacing lie.
int lattice_count(int size, int log2, int spacing_log2) {
  return ((((size - 1) >> spacing_log2) + 1) << (spacing_log2 - log2)) + 1;
}

LatticeShape shape_of(const ScanGeometry& geometry, int x_log2, int y_log2, int nx, int ny) {
  return {x_log2, y_log2, lattice_count(geometry.width, x_log2, nx), lattice_count(geometry.height, y_log2, ny)};
}

std::vector<Point> lattice_points(const ScanGeometry& geometry, const LatticeShape& shape) {
  std::vector<Point> points;
  const auto [x_log2, y_log2, columns, rows] = shape;
  points.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      points.push_back(geometry.to_frame({std::ldexp(column, x_log2), std::ldexp(row, y_log2)}));
    }
  }
  return points;
}

/// Sources to the scan's coordinates, and those outside the image by name.
void settle(const ScanGeometry& geometry, LookLattice& lattice) {
  for (Look& look : lattice.looks) {
    look.source = geometry.from_frame(look.source);
    if (look.reason == Reason::none && !geometry.holds(look.source)) look.reason = Reason::outside;
  }
}

/// Reach of the planes that compete, px of the frame.
int largest_shift_px(const MachineProfile& profile) {
  constexpr auto kReaches = []<std::size_t... I>(std::index_sequence<I...>) {
    return std::array{stages::planes_of<hls::named_profiles[I].profile.planes>.reach()...};
  }(std::make_index_sequence<hls::named_profiles.size()>());
  const auto built = std::ranges::find(hls::named_profiles, profile.planes,
                                       [](const hls::NamedProfile& named) { return named.profile.planes; });
  return profile.subsample * kReaches.at(static_cast<std::size_t>(built - hls::named_profiles.begin()));
}

/// Throws RowError.
void check_lattice_rows(const LookLattice& lattice, const ScanGeometry& geometry, const ViewLimits& view) {
  RowCount rows;
  for (int y = 0; y < geometry.height; y += 1 << lattice.shape.y_log2) {
    for (int x = 0; x < geometry.width; x += 1 << lattice.shape.x_log2) {
      const Look& look = lattice.at(x, y);
      if (geometry.holds(look.source)) rows.add(look.reason);
    }
  }
  check_rows(rows, view);
}

/// Gives to the grid what lies so near the limits of angle and scale that the space between the samples may cross them:
/// between two samples a smooth margin falls below both by at most an eighth of its second difference.
void keep_clear_of_limits(LookLattice& lattice) {
  const auto bend = [&](std::ptrdiff_t at, std::ptrdiff_t step) {
    const auto margin = [&](std::ptrdiff_t i) { return lattice.looks[static_cast<std::size_t>(i)].margin; };
    const float value = std::abs(margin(at - step) - 2 * margin(at) + margin(at + step));
    return std::isnan(value) ? 0.0F : value;  // the border of what is seen: the margin is negative there
  };
  for (int row = 0; row < lattice.shape.rows; ++row) {
    for (int column = 0; column < lattice.shape.columns; ++column) {
      const std::ptrdiff_t columns = lattice.shape.columns;
      const std::ptrdiff_t at = row * columns + column;
      Look& look = lattice.looks[static_cast<std::size_t>(at)];
      if (is_excluded(look.reason)) continue;
      // At the lattice's own border the neighbour's; twice what a quadratic needs.
      const std::ptrdiff_t here_x = at + (column == 0 ? 1 : 0) - (column == columns - 1 ? 1 : 0);
      const std::ptrdiff_t here_y = at + (row == 0 ? columns : 0) - (row == lattice.shape.rows - 1 ? columns : 0);
      if (look.margin < 0.25F * (bend(here_x, 1) + bend(here_y, columns))) look.reason = Reason::grid;
    }
  }
}

/// What second differences on a lattice of 16 pixels say about the error and the loss of other spacings.
class Forecast {
 public:
  Forecast(const LookLattice& lattice, const ScanGeometry& geometry) {
    constexpr int kStep = 1 << kForecastLog2;
    const auto good = [&](int x, int y) { return lattice.at(x, y).reason == Reason::none; };
    for (int y = 0; y < geometry.height; y += kStep) {
      for (int x = 0; x < geometry.width; x += kStep) {
        if (!good(x, y)) continue;
        ++good_;
        const Point here = lattice.at(x, y).source;
        const auto bend = [&](int dx, int dy) -> Point {
          if (x < dx || y < dy || x + dx >= geometry.width || y + dy >= geometry.height) return {};
          const Point a = lattice.at(x - dx, y - dy).source;
          const Point b = lattice.at(x + dx, y + dy).source;
          const Point bend{a.x - 2 * here.x + b.x, a.y - 2 * here.y + b.y};
          return std::isfinite(bend.x + bend.y) ? bend : Point{};
        };
        bends_.push_back({bend(kStep, 0), bend(0, kStep)});
        for (const auto& [dx, dy] : {std::pair{kStep, 0}, {-kStep, 0}, {0, kStep}, {0, -kStep}}) {
          if (x + dx < 0 || y + dy < 0 || x + dx >= geometry.width || y + dy >= geometry.height) continue;
          if (is_excluded(lattice.at(x + dx, y + dy).reason)) ++border_;
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

  /// Half a cell along the border of what is seen within the limits.
  double lost_share(int nx, int ny) const {
    const double cell = std::ldexp(1.0, nx - kForecastLog2) + std::ldexp(1.0, ny - kForecastLog2);
    return good_ == 0 ? 0 : 0.25 * cell * static_cast<double>(border_) / static_cast<double>(good_);
  }

 private:
  struct Bend {
    Point x, y;
  };
  std::vector<Bend> bends_;
  std::int64_t good_ = 0;
  std::int64_t border_ = 0;
};

/// One grid: its control points, the cells that must be given up, and what is left.
class GridFit {
 public:
  /// The lattice holds every pixel, or at least the four samples of each cell.
  GridFit(const LookLattice& lattice, const ScanGeometry& geometry, int nx, int ny, int weight_bits,
          const MapLimits& limits, double largest_error_px)
      : lattice_(lattice),
        geometry_(geometry),
        limits_(limits),
        largest_error_px_(largest_error_px),
        nx_(nx),
        ny_(ny),
        weight_bits_(weight_bits),
        every_pixel_(lattice.shape.x_log2 == 0 && lattice.shape.y_log2 == 0),
        table_(geometry, nx, ny),
        cell_columns_(table_.columns() - 1),
        cell_rows_(((geometry.height - 1) >> ny) + 1),
        cells_(static_cast<std::size_t>(cell_columns_) * static_cast<std::size_t>(cell_rows_)) {
    set_controls();
    centre_errors();
    find_bad();
    give_up_bad();
    measure();
  }

  const MapReport& report() const { return report_; }
  CompiledMap take() { return {std::move(table_), report_}; }

 private:
  /// Where in a cell something must not be supervised: its own control point, the edges that need two control points
  /// only, the rest.
  struct Cell {
    bool corner = false, left = false, top = false, rest = false;
    bool any_bad() const { return corner || left || top || rest; }
    float error = 0;  ///< largest of its samples
  };

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cell_columns_) + static_cast<std::size_t>(column);
  }
  Cell& cell(int column, int row) { return cells_[index(column, row)]; }
  bool mapped(int column, int row) const { return table_.control(column, row) != MapTable::kUnmapped; }
  bool mapped_cell(int column, int row) const {
    return mapped(column, row) && mapped(column + 1, row) && mapped(column, row + 1) && mapped(column + 1, row + 1);
  }

  void set_controls() {
    // The last row of a pair may have no pixels above it, and then no look.
    const int rows = std::min(table_.rows(), ((lattice_.shape.rows - 1) << lattice_.shape.y_log2 >> ny_) + 1);
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < table_.columns(); ++column) {
        table_.set_control(column, row, MapTable::encode(lattice_.at(column << nx_, row << ny_).source));
      }
    }
  }

  /// Between exact control points a smooth map errs to one side, most in the middle of the cell; half of that error
  /// given to the control points leaves half of it. Only as far as all cells around a control point agree.
  void centre_errors() {
    if (nx_ == 0 && ny_ == 0) return;
    const Point none{0, 0};
    std::vector<Point> middles(cells_.size(), Point{std::nan(""), std::nan("")});  // NaN: no cell
    for (int row = 0; row < cell_rows_; ++row) {
      for (int column = 0; column < cell_columns_; ++column) {
        const int x = (column << nx_) + (1 << nx_ >> 1);
        const int y = (row << ny_) + (1 << ny_ >> 1);
        const auto expanded = mapped_cell(column, row) ? table_.expand(x, y) : std::nullopt;
        if (!expanded) continue;
        const Look& look = lattice_.at(x, y);
        const Point error = error_of(*expanded, look);
        // What is too far off to be mended by half is a crease, or no part of the skin.
        const bool smooth = !is_excluded(look.reason) && distance(error) <= 2 * limits_.largest_error_px;
        middles[index(column, row)] = smooth ? error : none;
      }
    }
    const auto agreed = [](double a, double b) {
      if (std::isnan(a) || std::isnan(b)) return std::isnan(a) ? b : a;
      if (std::signbit(a) != std::signbit(b)) return 0.0;
      return std::abs(a) < std::abs(b) ? a : b;
    };
    for (int row = 0; row <= cell_rows_; ++row) {
      for (int column = 0; column < table_.columns(); ++column) {
        if (!mapped(column, row)) continue;
        Point error{std::nan(""), std::nan("")};
        for (int r = std::max(0, row - 1); r <= std::min(row, cell_rows_ - 1); ++r) {
          for (int c = std::max(0, column - 1); c <= std::min(column, cell_columns_ - 1); ++c) {
            const Point& middle = middles[index(c, r)];
            error = {agreed(error.x, middle.x), agreed(error.y, middle.y)};
          }
        }
        if (std::isnan(error.x)) continue;
        const Point exact = lattice_.at(column << nx_, row << ny_).source;
        const auto centred = MapTable::encode({exact.x - 0.5 * error.x, exact.y - 0.5 * error.y});
        if (centred != MapTable::kUnmapped) table_.set_control(column, row, centred);
      }
    }
  }

  /// The pixels of a cell that the lattice holds; `visit(x, y, look)`.
  template <class Visit>
  void for_samples(int column, int row, Visit visit) const {
    const int right = std::min((column + 1) << nx_, geometry_.width);
    const int bottom = std::min((row + 1) << ny_, geometry_.height);
    for (int y = row << ny_; y < bottom; y += 1 << lattice_.shape.y_log2) {
      for (int x = column << nx_; x < right; x += 1 << lattice_.shape.x_log2) visit(x, y, lattice_.at(x, y));
    }
  }

  bool reads_inside(const MapTable::Expanded& e) const {
    const std::int64_t half = std::int64_t{1} << (MapTable::kFractionBits - weight_bits_ - 1);
    return e.x >= -half && e.y >= -half &&
           e.x < (std::int64_t{geometry_.width - 1} << MapTable::kFractionBits) + half &&
           e.y < (std::int64_t{geometry_.height - 1} << MapTable::kFractionBits) + half;
  }

  static Point error_of(const MapTable::Expanded& e, const Look& look) {
    return {static_cast<double>(e.x) * kFraction - look.source.x, static_cast<double>(e.y) * kFraction - look.source.y};
  }

  void find_bad() {
    for (int row = 0; row < cell_rows_; ++row) {
      for (int column = 0; column < cell_columns_; ++column) {
        Cell& c = cell(column, row);
        const int x0 = column << nx_;
        const int y0 = row << ny_;
        for_samples(column, row, [&](int x, int y, const Look& look) {
          const auto expanded = table_.expand(x, y);
          if (!expanded || !reads_inside(*expanded)) return;
          const double error = distance(error_of(*expanded, look));
          // A source just outside may be expanded to one just inside; one without a place has no error that is small.
          const bool bad = is_excluded(look.reason) || !(error <= largest_error_px_);
          if (!bad) {
            c.error = std::max(c.error, static_cast<float>(error));
          } else if (x == x0) {
            (y == y0 ? c.corner : c.left) = true;
          } else {
            (y == y0 ? c.top : c.rest) = true;
          }
        });
        if (every_pixel_) continue;
        // Between samples: what the ones around say, of which the last may lie beyond the cell and the image.
        const auto last = [](int first, int end, int log2) {
          return ((end - 1 - first + (1 << log2) - 1) >> log2 << log2) + first;
        };
        const int right = last(x0, std::min((column + 1) << nx_, geometry_.width), lattice_.shape.x_log2);
        const int bottom = last(y0, std::min((row + 1) << ny_, geometry_.height), lattice_.shape.y_log2);
        for (int y = y0; y <= bottom; y += 1 << lattice_.shape.y_log2) {
          for (int x = x0; x <= right; x += 1 << lattice_.shape.x_log2) {
            if (!is_excluded(lattice_.at(x, y).reason)) continue;
            c.rest = c.rest || right > x0 || bottom > y0;
            c.left = c.left || (x == x0 && bottom > y0);
            c.top = c.top || (y == y0 && right > x0);
          }
        }
        if (c.corner) c.left = c.top = c.rest = true;
        if (c.left || c.top) c.rest = true;
      }
    }
  }

  /// Cells without anything bad that a control point carries.
  int carried(int column, int row) {
    int count = 0;
    for (int r = std::max(0, row - 1); r <= std::min(row, cell_rows_ - 1); ++r) {
      for (int c = std::max(0, column - 1); c <= std::min(column, cell_columns_ - 1); ++c) {
        if (!cell(c, r).any_bad() && mapped_cell(c, r)) ++count;
      }
    }
    return count;
  }

  /// Unmaps, of control points that are all mapped, the one that carries least.
  void break_up(std::initializer_list<std::pair<int, int>> points) {
    if (!std::ranges::all_of(points, [&](const auto& p) { return mapped(p.first, p.second); })) return;
    const auto least = std::ranges::min_element(points, {}, [&](const auto& p) { return carried(p.first, p.second); });
    table_.set_control(least->first, least->second, MapTable::kUnmapped);
  }

  void give_up_bad() {
    const auto for_cells = [&](auto visit) {
      for (int row = 0; row < cell_rows_; ++row) {
        for (int column = 0; column < cell_columns_; ++column) visit(column, row, cell(column, row));
      }
    };
    // What leaves least choice first.
    for_cells([&](int column, int row, const Cell& c) {
      if (c.corner) table_.set_control(column, row, MapTable::kUnmapped);
    });
    for_cells([&](int column, int row, const Cell& c) {
      if (c.left) break_up({{column, row}, {column, row + 1}});
      if (c.top) break_up({{column, row}, {column + 1, row}});
    });
    for_cells([&](int column, int row, const Cell& c) {
      if (c.rest) break_up({{column, row}, {column + 1, row}, {column, row + 1}, {column + 1, row + 1}});
    });
  }

  void measure() {
    report_.spacing_x = 1 << nx_;
    report_.spacing_y = 1 << ny_;
    report_.pool_bytes = table_.pool_bytes();
    report_.pixels = std::int64_t{geometry_.width} * geometry_.height;
    report_.reach = {-geometry_.height, -geometry_.height};
    std::vector<float> errors;
    errors.reserve(every_pixel_ ? lattice_.looks.size() : cells_.size());
    for (int row = 0; row < cell_rows_; ++row) {
      for (int column = 0; column < cell_columns_; ++column) {
        bool supervised = false;
        for_samples(column, row, [&](int x, int y, const Look& look) {
          ++report_.checked;
          const auto expanded = table_.expand(x, y);
          const auto source = expanded ? table_.round(*expanded, weight_bits_) : std::nullopt;
          if (!source) {
            const Reason reason = look.reason == Reason::none ? Reason::grid : look.reason;
            ++report_.by_reason[static_cast<std::size_t>(reason)];
            return;
          }
          supervised = true;
          ++report_.by_reason[static_cast<std::size_t>(Reason::none)];
          if (!every_pixel_) return;
          errors.push_back(static_cast<float>(distance(error_of(*expanded, look))));
          const double rounded = distance(std::ldexp(source->x, -weight_bits_) - look.source.x,
                                          std::ldexp(source->y, -weight_bits_) - look.source.y);
          report_.rounded_largest_px = std::max(report_.rounded_largest_px, rounded);
          reach(y, *source);
        });
        if (every_pixel_ || !supervised) continue;
        errors.push_back(cell(column, row).error);
        // Bilinear in the cell, so the extremes lie at its corners.
        const int right = std::min((column + 1) << nx_, geometry_.width) - 1;
        const int bottom = std::min((row + 1) << ny_, geometry_.height) - 1;
        for (const int y : {row << ny_, bottom}) {
          for (const int x : {column << nx_, right}) {
            const auto expanded = table_.expand(x, y);
            if (!expanded) continue;
            const auto clamped =
                std::clamp<std::int64_t>(expanded->y, 0, std::int64_t{geometry_.height - 1} << MapTable::kFractionBits);
            const int drop = MapTable::kFractionBits - weight_bits_;
            reach(y, {0, static_cast<int>((clamped + (std::int64_t{1} << (drop - 1))) >> drop)});
          }
        }
      }
    }
    // Samples stand for all pixels.
    if (!every_pixel_ && report_.checked > 0) {
      const double each = static_cast<double>(report_.pixels) / static_cast<double>(report_.checked);
      for (auto& count : report_.by_reason) count = std::llround(static_cast<double>(count) * each);
    }
    if (errors.empty()) {
      report_.reach = {};
      return;
    }
    const auto at =
        errors.begin() + static_cast<std::ptrdiff_t>(limits_.share * static_cast<double>(errors.size() - 1));
    std::ranges::nth_element(errors, at);
    report_.error_99_px = *at;
    report_.error_largest_px = *std::max_element(at, errors.end());
  }

  void reach(int y, const MapTable::Source& source) {
    const int first = source.y >> weight_bits_;
    const int last = first + ((source.y & ((1 << weight_bits_) - 1)) != 0 ? 1 : 0);
    report_.reach.behind = std::max(report_.reach.behind, y - first);
    report_.reach.ahead = std::max(report_.reach.ahead, last - y);
  }

  const LookLattice& lattice_;
  const ScanGeometry& geometry_;
  const MapLimits& limits_;
  double largest_error_px_;  ///< beyond it a cell is given up
  int nx_, ny_, weight_bits_;
  bool every_pixel_;
  MapTable table_;
  int cell_columns_, cell_rows_;
  std::vector<Cell> cells_;
  MapReport report_;
};

struct Spacing {
  int nx, ny;
  std::size_t bytes;
};

/// That fit, fewest bytes first.
std::vector<Spacing> spacings_of(const ScanGeometry& geometry, int largest_log2, std::size_t largest_bytes) {
  std::vector<Spacing> spacings;
  for (int nx = 0; nx <= largest_log2; ++nx) {
    for (int ny = 0; ny <= largest_log2; ++ny) {
      const std::size_t bytes = MapTable::pool_bytes(geometry, nx, ny);
      if (bytes <= largest_bytes) spacings.push_back({nx, ny, bytes});
    }
  }
  std::ranges::sort(spacings, {}, &Spacing::bytes);
  return spacings;
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
  return shape_of(table.geometry(), table.spacing_x_log2(), table.spacing_y_log2(), table.spacing_x_log2(),
                  table.spacing_y_log2());
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
}

/// The coarsest grid within the limits; where none loses little enough, the one that loses least. `fit` tries a
/// spacing; those that the forecast says to be beyond `margin` times the limits are not tried. To be sealed.
CompiledMap choose(const MachineProfile& profile, const ScanGeometry& geometry, const MapLimits& limits,
                   const Forecast& forecast, const std::function<GridFit(int, int, double)>& fit, double margin) {
  const std::size_t largest = limits.largest_bytes != 0 ? limits.largest_bytes : profile.pool_bytes;
  const std::vector<Spacing> spacings = spacings_of(geometry, limits.largest_spacing_log2, largest);
  std::optional<CompiledMap> best;
  std::optional<UnseenError> nothing;
  const auto attempt = [&](const Spacing& spacing, double largest_error_px) {
    GridFit tried = fit(spacing.nx, spacing.ny, largest_error_px);
    const MapReport& report = tried.report();
    if (report.supervised() == 0) nothing = UnseenError(report);
    if (report.supervised() == 0 || report.error_99_px > limits.error_px) return false;
    const double lost = report.lost_share();
    const bool good = lost <= limits.largest_lost_share;
    if (good || !best || lost < best->report.lost_share()) best = tried.take();
    return good;
  };
  const auto precise = [&](const Spacing& s) {
    return forecast.share_beyond(s.nx, s.ny, limits.error_px * margin) <= (1 - limits.share) * margin;
  };
  const auto likely = [&](const Spacing& s) {
    return forecast.lost_share(s.nx, s.ny) <= limits.largest_lost_share * 2 * margin && precise(s);
  };
  const bool good =
      std::ranges::any_of(spacings, [&](const Spacing& s) { return likely(s) && attempt(s, limits.largest_error_px); });
  if (!good) {
    std::multimap<double, Spacing> last;  // equal ones in the order of `spacings`
    for (const Spacing& s : spacings) last.emplace(forecast.lost_share(s.nx, s.ny) + (precise(s) ? 0 : 1), s);
    // Where creases, or the border of what is seen, keep too many pixels off, the grid loses them all.
    std::ranges::any_of(last | std::views::values | std::views::take(kLastTries), [&](const Spacing& s) {
      return (!likely(s) && attempt(s, limits.largest_error_px)) || attempt(s, limits.error_px);
    });
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

ViewLimits view_limits(const MachineProfile& profile, Decision decision) {
  check_decision(profile, decision);
  ViewLimits limits;
  if (decision == Decision::thesis) return limits;
  limits.largest_shift_px = largest_shift_px(profile);
  return limits;
}

std::string RowError::expected() {
  return fmt::format("cameras side by side and parallel, their images rectified, or --decision {}",
                     name_of(Decision::thesis));
}

void check_rows(const RowCount& rows, const ViewLimits& view) {
  if (rows.share() <= RowError::kLargestShare) return;
  throw RowError(fmt::format(
      "at {:.1f} % of the pixels that could be supervised the epipolar line leaves the row by more than {} px within "
      "the {} px by which neighbours that compete are shifted",
      100 * rows.share(), kLargestRowError, view.largest_shift_px));
}

CompiledMap compile_map(const Skin& skin, const MachineProfile& profile, const ScanGeometry& geometry,
                        const MapLimits& limits) {
  LookLattice lattice{shape_of(geometry, 0, 0, MapTable::kLargestSpacingLog2, MapTable::kLargestSpacingLog2), {}};
  const std::vector<Point> points = lattice_points(geometry, lattice.shape);
  lattice.looks.resize(points.size());
  // Row by row: lines of sight of a whole frame would take more memory than the looks.
  const auto row = static_cast<std::size_t>(lattice.shape.columns);
  for (std::size_t first = 0; first < points.size(); first += row) {
    skin.look(std::span(points).subspan(first, row), geometry.row_step(), limits.view,
              std::span(lattice.looks).subspan(first, row));
  }
  settle(geometry, lattice);
  check_lattice_rows(lattice, geometry, limits.view);
  // The forecast only sorts out what is far off.
  CompiledMap map = choose(
      profile, geometry, limits, Forecast(lattice, geometry),
      [&](int nx, int ny, double largest_error_px) {
        return GridFit(lattice, geometry, nx, ny, profile.weight_bits, limits, largest_error_px);
      },
      4);
  const LatticeShape shape = control_shape(map.table);
  const std::vector<Point> controls = lattice_points(geometry, shape);
  std::vector<Point> sources(controls.size());
  skin.look_around(controls, sources);
  show_around(shape, sources, map.table);
  hls::table::Facts facts = facts_of(map.table, profile);
  if (const auto* rig_skin = dynamic_cast<const RigSkin*>(&skin)) {
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

double share_beyond_rows(const MapSet& maps, const MachineProfile& profile, const ViewLimits& view) {
  const calib::Rig rig = calib::rig_from_yaml(maps.rig, maps.skin);
  const CameraPair cameras(rig.cameras.at(0), rig.cameras.at(1));
  std::int64_t supervised = 0;
  std::int64_t beyond = 0;
  for (const CompiledMap& map : maps.maps) {
    const ScanGeometry& geometry = map.table.geometry();
    std::vector<Point> points;
    for (int y = 0; y < geometry.height; ++y) {
      for (int x = 0; x < geometry.width; ++x) {
        if (!map.table.source(x, y, profile.weight_bits)) continue;
        points.push_back(geometry.to_frame({static_cast<double>(x), static_cast<double>(y)}));
      }
    }
    const Rays rays = cameras.rays(points, view);
    const double largest = kLargestRowError * geometry.row_step();
    supervised += std::ssize(points);
    beyond += std::ranges::count_if(rays.row_error, [&](double error) { return !(error <= largest); });
  }
  return supervised == 0 ? 0 : static_cast<double>(beyond) / static_cast<double>(supervised);
}

MapCompiler::MapCompiler(CameraPair cameras, const MachineProfile& profile, const ScanGeometry& geometry,
                         const MapLimits& limits)
    : cameras_(std::move(cameras)),
      profile_(profile),
      geometry_(geometry),
      limits_(limits),
      scale_(cameras_, profile, geometry) {}

const Rays& MapCompiler::rays(const LatticeShape& shape) {
  auto rays = rays_.find(shape);
  if (rays == rays_.end())
    rays = rays_.emplace(shape, cameras_.rays(lattice_points(geometry_, shape), limits_.view)).first;
  return rays->second;
}

void MapCompiler::look(const Surface& surface, const LatticeShape& shape, LookLattice& lattice) {
  const Rays& sights = rays(shape);
  lattice.shape = shape;
  lattice.looks.resize(sights.size());
  cameras_.look(surface, sights, geometry_.row_step(), limits_.view, lattice.looks);
  settle(geometry_, lattice);
  check_lattice_rows(lattice, geometry_, limits_.view);
}

CompiledMap MapCompiler::compile(const Surface& surface) {
  surface.check_cameras(cameras_.left().world_to_camera.centre(), cameras_.right().world_to_camera.centre());
  LookLattice lattice;
  look(surface, shape_of(geometry_, kForecastLog2, kForecastLog2, kForecastLog2, kForecastLog2), lattice);
  const Forecast forecast(lattice, geometry_);
  const int coarsest = surface.simple() ? kSmoothLog2 : kFeatureLog2;
  const auto fit = [&](int nx, int ny, double largest_error_px) {
    const int x_log2 = std::min(std::max(nx - 1, 0), coarsest);
    const int y_log2 = std::min(std::max(ny - 1, 0), coarsest);
    const LatticeShape shape = shape_of(geometry_, x_log2, y_log2, nx, ny);
    if (shape != lattice.shape) {
      look(surface, shape, lattice);
      if (surface.simple()) keep_clear_of_limits(lattice);
    }
    return GridFit(lattice, geometry_, nx, ny, profile_.weight_bits, limits_, largest_error_px);
  };
  CompiledMap map = choose(profile_, geometry_, limits_, forecast, fit, 1);
  const LatticeShape controls = control_shape(map.table);
  std::vector<Point> sources(rays(controls).size());
  cameras_.look_around(surface, rays(controls), sources);
  show_around(controls, sources, map.table);
  hls::table::Facts facts = facts_of(map.table, profile_);
  scale_.measure(surface, facts);
  seal(map, facts);
  return map;
}

}  // namespace horopter
