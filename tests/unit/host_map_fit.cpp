// SPDX-License-Identifier: Apache-2.0
// Tables of skins that move against brute force: the same control points, bit by bit, from lines of sight that are looked
// at one by one and cells that are tried pixel by pixel; and what they say of themselves against every pixel.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "horopter/map/map_compiler.hpp"
#include "horopter/map/outline_fit.hpp"
#include "table_11_1.hpp"

namespace {

using namespace horopter;
using Eigen::Vector3d;

/// What every 2^x_log2-th pixel of every 2^y_log2-th row sees, and as far beyond the image as control points lie.
struct Samples {
  int x_log2, y_log2, columns, rows;
  std::vector<Look> looks;
  const Look& at(int x, int y) const {
    return looks[static_cast<std::size_t>((y >> y_log2) * columns + (x >> x_log2))];
  }
};

bool excluded(const Look& look) { return look.reason != Reason::none && look.reason != Reason::outside; }

Samples look_one_by_one(const CameraPair& cameras, const Surface& surface, const ScanGeometry& scan, int x_log2,
                        int y_log2, int nx, int ny) {
  const auto count = [](int size, int log2, int n) { return ((((size - 1) >> n) + 1) << (n - log2)) + 1; };
  Samples samples{x_log2, y_log2, count(scan.width, x_log2, nx), count(scan.height, y_log2, ny), {}};
  for (int row = 0; row < samples.rows; ++row) {
    for (int column = 0; column < samples.columns; ++column) {
      const std::vector<Point> pixel{scan.to_frame({std::ldexp(column, x_log2), std::ldexp(row, y_log2)})};
      std::vector<Look> look(1);
      cameras.look(surface, cameras.rays(pixel), scan.row_step(), {}, look);
      look[0].source = scan.from_frame(look[0].source);
      if (look[0].reason == Reason::none && !scan.holds(look[0].source)) look[0].reason = Reason::outside;
      samples.looks.push_back(look[0]);
    }
  }
  return samples;
}

/// Near the limits of angle and scale: where what lies between two samples may cross them.
void keep_clear(Samples& samples) {
  const Samples before = samples;
  const auto margin = [&](int column, int row) {
    return before.looks[static_cast<std::size_t>(row * before.columns + column)].margin;
  };
  for (int row = 0; row < samples.rows; ++row) {
    for (int column = 0; column < samples.columns; ++column) {
      Look& look = samples.looks[static_cast<std::size_t>(row * samples.columns + column)];
      if (excluded(look)) continue;
      const int x = std::clamp(column, 1, samples.columns - 2);
      const int y = std::clamp(row, 1, samples.rows - 2);
      float across = std::abs(margin(x - 1, row) - 2 * margin(x, row) + margin(x + 1, row));
      float along = std::abs(margin(column, y - 1) - 2 * margin(column, y) + margin(column, y + 1));
      if (std::isnan(across)) across = 0;
      if (std::isnan(along)) along = 0;
      if (look.margin < 0.25F * (across + along)) look.reason = Reason::grid;
    }
  }
}

constexpr double kShareError_px = 1.0 / 16;
constexpr double kLargestError_px = 0.25;

Point error_of(const MapTable::Expanded& expanded, const Look& look) {
  return {std::ldexp(static_cast<double>(expanded.x), -MapTable::kFractionBits) - look.source.x,
          std::ldexp(static_cast<double>(expanded.y), -MapTable::kFractionBits) - look.source.y};
}

double length(Point p) { return std::sqrt(p.x * p.x + p.y * p.y); }

/// Control points of a spacing, exact where the samples see the skin, and each moved by half of what the cells around it
/// err by in the middle, if they agree on the side; by more, where half is beyond 1/16 px.
MapTable centred(const Samples& samples, const ScanGeometry& scan, int nx, int ny) {
  MapTable exact(scan, nx, ny);
  const int columns = ((scan.width - 1) >> nx) + 1;
  const int rows = ((scan.height - 1) >> ny) + 1;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      exact.set_control(column, row, MapTable::encode(samples.at(column << nx, row << ny).source));
    }
  }
  if (nx == 0 && ny == 0) return exact;
  MapTable table = exact;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      if (!exact.is_of_skin(column, row)) continue;
      std::vector<double> x, y;
      for (int r = row - 1; r <= row; ++r) {
        for (int c = column - 1; c <= column; ++c) {
          if (r < 0 || c < 0 || r >= rows || c >= columns) continue;
          if (!exact.is_of_skin(c, r) || !exact.is_of_skin(c + 1, r) || !exact.is_of_skin(c, r + 1) ||
              !exact.is_of_skin(c + 1, r + 1)) {
            continue;
          }
          const int middle_x = (c << nx) + (1 << nx) / 2;
          const int middle_y = (r << ny) + (1 << ny) / 2;
          const Look& look = samples.at(middle_x, middle_y);
          if (excluded(look)) continue;
          const Point error = error_of(*exact.expand(middle_x, middle_y), look);
          const bool smooth = length(error) <= 2 * kLargestError_px;
          x.push_back(smooth ? error.x : 0);
          y.push_back(smooth ? error.y : 0);
        }
      }
      if (x.empty()) continue;
      const auto agreed = [](const std::vector<double>& errors) {
        const auto [least, most] = std::ranges::minmax(errors);
        return least > 0 || most < 0 ? 0.5 * (least + most) : 0;
      };
      const Point source = samples.at(column << nx, row << ny).source;
      const Point error{agreed(x), agreed(y)};
      if (error.x == 0 && error.y == 0) continue;
      const double wanted = std::min(length(error) - kShareError_px, 0.8 * kLargestError_px);
      const double part = std::max(0.5, wanted / length(error));
      const auto moved = MapTable::encode({source.x - part * error.x, source.y - part * error.y});
      if (moved != MapTable::kUnmapped) table.set_control(column, row, moved);
    }
  }
  return table;
}

struct Flags {
  bool corner = false, left = false, top = false, rest = false;
  bool any() const { return corner || left || top || rest; }
};

/// The table without the control points that would let a sample be off by more than `bound`, or something be supervised
/// that must not be.
MapTable within(const MapTable& whole, const Samples& samples, const ScanGeometry& scan, int weight_bits,
                double bound) {
  const int nx = whole.spacing_x_log2();
  const int ny = whole.spacing_y_log2();
  const int columns = ((scan.width - 1) >> nx) + 1;
  const int rows = ((scan.height - 1) >> ny) + 1;
  std::vector<Flags> cells(static_cast<std::size_t>(columns * rows));
  const auto cell = [&](int column, int row) -> Flags& {
    return cells[static_cast<std::size_t>(row * columns + column)];
  };
  const auto ceiling = [](int size, int log2) { return ((size - 1 + (1 << log2) - 1) >> log2) << log2; };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      Flags& flags = cell(column, row);
      const int x0 = column << nx;
      const int y0 = row << ny;
      const int x1 = samples.x_log2 == nx ? x0 : std::min(x0 + (1 << nx), ceiling(scan.width, samples.x_log2));
      const int y1 = samples.y_log2 == ny ? y0 : std::min(y0 + (1 << ny), ceiling(scan.height, samples.y_log2));
      for (int y = y0; y <= y1; y += 1 << samples.y_log2) {
        for (int x = x0; x <= x1; x += 1 << samples.x_log2) {
          const Look& look = samples.at(x, y);
          if (excluded(look)) {  // what lies between samples is taken for what the worst of them is
            flags.rest |= x1 > x0 || y1 > y0;
            flags.left |= x == x0 && y1 > y0;
            flags.top |= y == y0 && x1 > x0;
          }
          if (x >= std::min(x0 + (1 << nx), scan.width) || y >= std::min(y0 + (1 << ny), scan.height)) continue;
          const auto expanded = whole.expand(x, y);
          if (!expanded || !whole.round(*expanded, weight_bits)) continue;
          const auto error = static_cast<float>(length(error_of(*expanded, look)));
          if (!excluded(look) && error <= bound) continue;
          (x == x0 ? (y == y0 ? flags.corner : flags.left) : y == y0 ? flags.top : flags.rest) = true;
        }
      }
    }
  }
  MapTable table = whole;
  const auto mapped = [&](int column, int row) { return table.is_of_skin(column, row); };
  const auto carried = [&](int column, int row) {
    int count = 0;
    for (int r = std::max(0, row - 1); r <= std::min(row, rows - 1); ++r) {
      for (int c = std::max(0, column - 1); c <= std::min(column, columns - 1); ++c) {
        const bool carries = !(whole.is_of_skin(c, r) && cell(c, r).any());
        if (carries && mapped(c, r) && mapped(c + 1, r) && mapped(c, r + 1) && mapped(c + 1, r + 1)) ++count;
      }
    }
    return count;
  };
  const auto break_up = [&](const std::vector<std::pair<int, int>>& points) {
    if (!std::ranges::all_of(points, [&](const auto& p) { return mapped(p.first, p.second); })) return;
    const auto least = std::ranges::min_element(points, {}, [&](const auto& p) { return carried(p.first, p.second); });
    table.set_control(least->first, least->second, MapTable::kUnmapped);
  };
  const auto for_cells = [&](auto visit) {
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) visit(column, row, cell(column, row));
    }
  };
  for_cells([&](int column, int row, const Flags& flags) {
    if (flags.corner) table.set_control(column, row, MapTable::kUnmapped);
  });
  for_cells([&](int column, int row, const Flags& flags) {
    if (flags.left) break_up({{column, row}, {column, row + 1}});
    if (flags.top) break_up({{column, row}, {column + 1, row}});
  });
  for_cells([&](int column, int row, const Flags& flags) {
    if (flags.any()) break_up({{column, row}, {column + 1, row}, {column, row + 1}, {column + 1, row + 1}});
  });
  return table;
}

/// At 8 × 8 places of a cell, the share that is further off than 1/16 px: the errors are those of the biquadratic through
/// the nine samples in the cell and on its border.
double share_beyond(const MapTable& whole, const Samples& samples, int column, int row) {
  const int hx = 1 << whole.spacing_x_log2();
  const int hy = 1 << whole.spacing_y_log2();
  const auto source = [&](double u, double v, auto of) {
    const double top = (1 - u) * of(whole.control(column, row)) + u * of(whole.control(column + 1, row));
    const double bottom = (1 - u) * of(whole.control(column, row + 1)) + u * of(whole.control(column + 1, row + 1));
    return ((1 - v) * top + v * bottom) / hls::table::control_scale - hls::table::control_offset_px;
  };
  const auto at_node = [&](int i, int j) -> Point {
    const Look& look = samples.at(column * hx + i * hx / 2, row * hy + j * hy / 2);
    return {source(i / 2.0, j / 2.0, [](std::uint32_t c) { return double(c & 0xFFFFU); }) - look.source.x,
            source(i / 2.0, j / 2.0, [](std::uint32_t c) { return double(c >> 16); }) - look.source.y};
  };
  const auto through = [](double a, double b, double c, double u) {
    return a * (1 - 2 * u) * (1 - u) + b * 4 * u * (1 - u) + c * u * (2 * u - 1);
  };
  int beyond = 0;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      std::vector<Point> rows;
      for (int j = 0; j < 3; ++j) {
        const Point a = at_node(0, j), b = at_node(1, j), c = at_node(2, j);
        rows.push_back({through(a.x, b.x, c.x, x / 8.0), through(a.y, b.y, c.y, x / 8.0)});
      }
      const Point error{through(rows[0].x, rows[1].x, rows[2].x, y / 8.0),
                        through(rows[0].y, rows[1].y, rows[2].y, y / 8.0)};
      beyond += !(static_cast<float>(length(error)) <= static_cast<float>(kShareError_px)) ? 1 : 0;
    }
  }
  return beyond / 64.0;
}

/// Whether 99 % of the samples of whole cells are within 1/16 px, or of their pixels, if `interpolated`.
bool precise(const MapTable& table, const MapTable& before, const Samples& samples, const ScanGeometry& scan,
             int weight_bits, bool interpolated) {
  const int nx = table.spacing_x_log2();
  const int ny = table.spacing_y_log2();
  double all = 0;
  double beyond = 0;
  for (int row = 0; row <= (scan.height - 1) >> ny; ++row) {
    for (int column = 0; column <= (scan.width - 1) >> nx; ++column) {
      const auto whole = [&](const MapTable& of) {
        return of.is_of_skin(column, row) && (nx == 0 || of.is_of_skin(column + 1, row)) &&
               (ny == 0 || of.is_of_skin(column, row + 1)) &&
               (nx == 0 || ny == 0 || of.is_of_skin(column + 1, row + 1));
      };
      if (!whole(table)) continue;
      int count = 0;
      int count_beyond = 0;
      for (int y = row << ny; y < std::min((row + 1) << ny, scan.height); y += 1 << samples.y_log2) {
        for (int x = column << nx; x < std::min((column + 1) << nx, scan.width); x += 1 << samples.x_log2) {
          const auto expanded = table.expand(x, y);
          if (!expanded || !table.round(*expanded, weight_bits)) continue;
          ++count;
          count_beyond += length(error_of(*expanded, samples.at(x, y))) > kShareError_px ? 1 : 0;
        }
      }
      all += count;
      beyond +=
          interpolated && count_beyond > 0 && nx > 0 && ny > 0 && samples.x_log2 == nx - 1 && samples.y_log2 == ny - 1
              ? count * share_beyond(before, samples, column, row)
              : count_beyond;
    }
  }
  return beyond <= (1 - 0.99) * all;
}

MapTable by_brute_force(const Samples& samples, const ScanGeometry& scan, int weight_bits, int nx, int ny) {
  const MapTable whole = centred(samples, scan, nx, ny);
  const auto good = [&](double bound, bool interpolated) {
    return precise(within(whole, samples, scan, weight_bits, bound), whole, samples, scan, weight_bits, interpolated);
  };
  double low = kLargestError_px;
  if (!good(low, false) && !good(low, true)) {
    low = kShareError_px;
    double high = kLargestError_px;
    for (int step = 0; step < 6; ++step) {
      const double bound = std::sqrt(low * high);
      (good(bound, true) ? low : high) = bound;
    }
  }
  return within(whole, samples, scan, weight_bits, low);
}

/// Whether a cell has pixels outside of their rows' spans.
bool is_cut(const MapTable& table, int x, int y) {
  const int nx = table.spacing_x_log2();
  const int ny = table.spacing_y_log2();
  const int left = x >> nx << nx;
  const int right = std::min(left + (1 << nx), table.geometry().width) - 1;
  for (int row = y >> ny << ny; row < std::min(((y >> ny) + 1) << ny, table.geometry().height); ++row) {
    if (!table.span(row).holds(left) || !table.span(row).holds(right)) return true;
  }
  return false;
}

/// Every pixel of a table, looked at.
struct Truth {
  std::int64_t supervised = 0, lost = 0, wrong = 0;
  std::int64_t in_whole_cells = 0, beyond = 0;  ///< of these
  double largest = 0;
};
Truth look_at_all(const MapTable& table, const CameraPair& cameras, const SurfacePtr& surface, int weight_bits) {
  const ScanGeometry& scan = table.geometry();
  const RigSkin skin(cameras, surface, "");
  Truth truth;
  for (int y = 0; y < scan.height; ++y) {
    std::vector<Point> pixels;
    for (int x = 0; x < scan.width; ++x) pixels.push_back(scan.to_frame({double(x), double(y)}));
    std::vector<Look> looks(pixels.size());
    skin.look(pixels, scan.row_step(), {}, looks);
    for (int x = 0; x < scan.width; ++x) {
      Look look = looks[static_cast<std::size_t>(x)];
      look.source = scan.from_frame(look.source);
      const bool good = look.reason == Reason::none && scan.holds(look.source);
      const auto expanded = table.expand(x, y);
      if (!expanded || !table.round(*expanded, weight_bits)) {
        truth.lost += good ? 1 : 0;
        continue;
      }
      const double error = length(error_of(*expanded, look));
      ++truth.supervised;
      truth.wrong += look.reason != Reason::none || !(error < 2 * kLargestError_px) ? 1 : 0;
      if (!is_cut(table, x, y)) {
        ++truth.in_whole_cells;
        truth.beyond += error > kShareError_px ? 1 : 0;
      }
      truth.largest = std::max(truth.largest, error);
    }
  }
  return truth;
}

struct Case {
  const char* profile;
  int width, height;
  SurfacePtr surface;
};

std::vector<Case> cases() {
  const auto small = [](double z) { return make_ellipsoid(at({0, 0, z}), {250, 200, 200}); };
  calib::Pose tilted = at({-120, 60, 900});
  tilted.rotation = calib::rotation_from_vector({0.3, -0.4, 0.5});
  return {{"field", 756, 572, small(1000.7)},
          {"field", 756, 572, small(1013.3)},
          {"hd", 1920, 1080, small(1000.7)},
          {"vga", 640, 480, make_ellipsoid(tilted, {180, 90, 120})},
          {"vga", 640, 480, make_ellipsoid(at({0, 0, 1200}), {600, 500, 400})},
          {"vga", 640, 480, make_plane({0, 0, 800}, {0.1, 0.9, -1})}};
}

}  // namespace

TEST_CASE("The control points of skins that move are those of brute force") {
  const Case c = cases()[static_cast<std::size_t>(GENERATE(range(0, 6)))];
  const MachineProfile& profile = find_profile(c.profile);
  const CameraPair cameras = table_11_1(c.width, c.height);
  const ScanGeometry scan = scans_of(profile, c.width, c.height).front();
  MapLimits limits;
  limits.spans = false;
  MapCompiler compiler(cameras, profile, scan, limits);
  // Not the first of its compiler: what one skin leaves must not change the next.
  if (c.surface->simple()) (void)compiler.compile(*make_ellipsoid(at({30, -20, 1100}), {200, 200, 200}));
  const CompiledMap fast = compiler.compile(*c.surface);
  const int nx = fast.table.spacing_x_log2();
  const int ny = fast.table.spacing_y_log2();
  CAPTURE(c.profile, c.surface->description(), nx, ny);
  const auto sample_log2 = [](int n) { return std::min(std::max(n - 1, 0), 5); };
  Samples samples = look_one_by_one(cameras, *c.surface, scan, sample_log2(nx), sample_log2(ny), nx, ny);
  keep_clear(samples);
  const MapTable brute = by_brute_force(samples, scan, profile.weight_bits, nx, ny);
  int of_skin = 0;
  int different = 0;
  for (int row = 0; row < fast.table.rows(); ++row) {
    for (int column = 0; column < fast.table.columns(); ++column) {
      const bool there = brute.is_of_skin(column, row);
      of_skin += there ? 1 : 0;
      const bool same =
          there ? fast.table.control(column, row) == brute.control(column, row) : !fast.table.is_of_skin(column, row);
      different += same ? 0 : 1;
    }
  }
  CHECK(of_skin > 0);
  CHECK(different == 0);
}

TEST_CASE("What tables of skins that move say of themselves holds at every pixel") {
  const Case c = cases()[static_cast<std::size_t>(GENERATE(range(0, 6)))];
  const MachineProfile& profile = find_profile(c.profile);
  const CameraPair cameras = table_11_1(c.width, c.height);
  const ScanGeometry scan = scans_of(profile, c.width, c.height).front();
  const CompiledMap fast = MapCompiler(cameras, profile, scan).compile(*c.surface);
  CAPTURE(c.profile, c.surface->description(), fast.report.spacing_x, fast.report.spacing_y);
  const Truth truth = look_at_all(fast.table, cameras, c.surface, profile.weight_bits);
  CHECK(truth.wrong == 0);
  CHECK(truth.largest <= 0.26);  // between the samples
  CHECK(static_cast<double>(truth.beyond) <= 0.01 * static_cast<double>(truth.in_whole_cells));
  const double lost = static_cast<double>(truth.lost) / static_cast<double>(truth.lost + truth.supervised);
  CHECK(fast.report.lost_share() == Approx(lost).margin(0.002));
  CHECK(lost <= 0.02);  // outlines in view or not
  CHECK(static_cast<double>(fast.report.supervised()) ==
        Approx(static_cast<double>(truth.supervised)).epsilon(0.02));  // cells that the image cuts are sampled
}

TEST_CASE("Of a skin whose outline is in view no other spacing loses much less") {
  const Case c = cases()[static_cast<std::size_t>(GENERATE(0, 2, 3))];
  const MachineProfile& profile = find_profile(c.profile);
  const CameraPair cameras = table_11_1(c.width, c.height);
  const ScanGeometry scan = scans_of(profile, c.width, c.height).front();
  const CompiledMap fast = MapCompiler(cameras, profile, scan).compile(*c.surface);
  CAPTURE(c.profile, fast.report.spacing_x, fast.report.spacing_y, fast.report.lost_share());
  double least = 1;
  const std::size_t areas = fast.table.facts().areas.size();
  REQUIRE(areas > 0);
  for (int nx = 0; nx <= MapTable::kLargestSpacingLog2; ++nx) {
    for (int ny = 0; ny <= MapTable::kLargestSpacingLog2; ++ny) {
      const std::size_t bytes = MapTable::pool_bytes(scan, nx, ny, false, areas);
      if (bytes > static_cast<std::size_t>(profile.pool_bytes) || bytes < 8192) continue;
      // One spacing alone: the table that leaves no room for others is searched among coarser ones only.
      MapLimits limits;
      limits.largest_bytes = bytes;
      limits.largest_spacing_log2 = std::max(nx, ny);
      try {
        least = std::min(least, MapCompiler(cameras, profile, scan, limits).compile(*c.surface).report.lost_share());
      } catch (const std::runtime_error&) {
        continue;  // nothing of it is supervised at such a spacing
      }
    }
  }
  if (fast.report.lost_share() > 0.02) CHECK(fast.report.lost_share() <= 1.05 * least);
}

TEST_CASE("What runs of pixels see is what each sees in a call of its own, to the last bit") {
  constexpr std::size_t kRun = calib::PixelBatch::kRun;
  const CameraPair cameras = table_11_1(640, 480);
  const std::vector<SurfacePtr> surfaces{
      make_ellipsoid(at({0, 0, 1000}), {250, 200, 200}), make_box(at({-80, 40, 1000}), {300, 200, 200}),
      make_capsules({{{-200, 0, 900}, {50, 40, 1000}, 60}, {{50, 40, 1000}, {150, -120, 950}, 50}})};
  for (const SurfacePtr& surface : surfaces) {
    int met = 0;
    for (int y = 0; y < 480; y += 24) {
      std::vector<Point> row;
      for (int x = 0; x < 640; ++x) row.push_back({static_cast<double>(x), static_cast<double>(y)});
      const Rays rays = cameras.rays(row);
      std::vector<Look> looks(row.size());
      cameras.look_at_runs(*surface, rays, 1, {}, looks, 0);
      for (std::size_t run = 0; run < row.size(); run += kRun) {
        CAPTURE(surface->description(), y, run);
        std::array<Look, kRun> alone;
        cameras.look(*surface, rays, 1, {}, alone, run);
        for (std::size_t i = 0; i < kRun; ++i) {
          const Look& look = looks[run + i];
          REQUIRE(std::memcmp(&look.source, &alone[i].source, sizeof(Point)) == 0);
          REQUIRE(std::memcmp(&look.margin, &alone[i].margin, sizeof(float)) == 0);
          REQUIRE(look.reason == alone[i].reason);
          met += look.reason == Reason::none ? 1 : 0;
        }
      }
    }
    CHECK(met > 100);
  }
}

TEST_CASE("Outlines are followed to the pixel") {
  const Case c = cases()[static_cast<std::size_t>(GENERATE(0, 1, 2, 3))];
  const MachineProfile& profile = find_profile(c.profile);
  const CameraPair cameras = table_11_1(c.width, c.height);
  const ScanGeometry scan = scans_of(profile, c.width, c.height).front();
  const auto look_at = [&](int x_log2, int y_log2) {
    const Samples samples = look_one_by_one(cameras, *c.surface, scan, x_log2, y_log2, x_log2, y_log2);
    LookLattice lattice;
    lattice.resize({x_log2, y_log2, samples.columns, samples.rows});
    for (std::size_t i = 0; i < samples.looks.size(); ++i) {
      lattice.sources[i] = samples.looks[i].source;
      lattice.reasons[i] = samples.looks[i].reason;
    }
    return lattice;
  };
  const LookLattice all = look_at(0, 0);
  const auto exact = outline_of(all, scan);
  OutlineTracer tracer(cameras, scan, {});
  const auto traced = tracer.trace(cameras, *c.surface, look_at(4, 4));
  REQUIRE(exact.has_value());
  REQUIRE(traced.has_value());
  int different = 0;
  std::int64_t pixels = 0;
  for (int y = 0; y < scan.height; ++y) {
    const hls::table::Span& span = exact->span(y);
    different += traced->span(y) == span ? 0 : 1;
    pixels += span.end - span.first;
    if (span.first == span.end) continue;
    for (const int x : {span.first, span.end - 1}) {
      const Point source = traced->source(x, y);
      CHECK(source.x == Approx(all.sources[all.index(x, y)].x));
      CHECK(source.y == Approx(all.sources[all.index(x, y)].y));
    }
    if (span.first > 0) CHECK(std::isnan(traced->source(span.first - 1, y).x));
    if (span.end < scan.width) CHECK(std::isnan(traced->source(span.end, y).x));
  }
  CHECK(different == 0);
  CHECK(pixels > 1000);
}

TEST_CASE("Where a skin is in pieces, or has a hole, nothing beside it is supervised") {
  const MachineProfile& profile = find_profile("vga");
  const CameraPair cameras = table_11_1(640, 480);
  const ScanGeometry scan{640, 480, Scan::progressive};
  const auto ball = [](double x, double y) { return make_ellipsoid(at({x, y, 1000}), {70, 90, 60}); };
  const Vector3d a(-200, -150, 1000), b(200, -150, 1000), c(200, 150, 1000), d(-200, 150, 1000);
  const bool pieces = GENERATE(true, false);
  const SurfacePtr surface = pieces ? make_union({ball(-90, 0), ball(90, 30)})
                                    : make_capsules({{a, b, 50}, {b, c, 50}, {c, d, 50}, {d, a, 50}});
  CAPTURE(surface->description());
  const bool every_pixel = GENERATE(true, false);
  const CompiledMap map = every_pixel ? compile_map(RigSkin(cameras, surface, ""), profile, scan)
                                      : MapCompiler(cameras, profile, scan).compile(*surface);
  const Truth truth = look_at_all(map.table, cameras, surface, profile.weight_bits);
  CAPTURE(every_pixel, map.table.has_spans(), map.report.lost_share(), truth.lost, truth.supervised);
  CHECK(truth.wrong == 0);
  // No more than without spans.
  MapLimits without;
  without.spans = false;
  const CompiledMap plain = every_pixel ? compile_map(RigSkin(cameras, surface, ""), profile, scan, without)
                                        : MapCompiler(cameras, profile, scan, without).compile(*surface);
  CHECK_FALSE(plain.table.has_spans());
  CHECK(map.report.lost_share() <= std::max(0.02, plain.report.lost_share()));
  if (every_pixel) CHECK(truth.largest <= kLargestError_px);  // samples may miss what is not smooth
}

TEST_CASE("A table of every pixel of an ellipsoid with its outline in view has spans and loses little") {
  const Case c = cases()[static_cast<std::size_t>(GENERATE(0, 2))];
  const MachineProfile& profile = find_profile(c.profile);
  const CameraPair cameras = table_11_1(c.width, c.height);
  const ScanGeometry scan = scans_of(profile, c.width, c.height).front();
  const CompiledMap map = compile_map(RigSkin(cameras, c.surface, ""), profile, scan);
  CAPTURE(c.profile, map.report.spacing_x, map.report.spacing_y);
  CHECK(map.table.has_spans());
  CHECK(map.report.lost_share() <= 0.02);
  const Truth truth = look_at_all(map.table, cameras, c.surface, profile.weight_bits);
  CHECK(truth.wrong == 0);
  CHECK(truth.largest <= kLargestError_px);
  CHECK(truth.supervised == map.report.supervised());
  CHECK(map.report.rounded_largest_px < kLargestError_px + 0.71 / (1 << profile.weight_bits));
  const Image supervised = map.table.supervised(profile.weight_bits);
  CHECK(std::ranges::count(supervised.pixels, std::uint8_t{1}) == truth.supervised);
}
