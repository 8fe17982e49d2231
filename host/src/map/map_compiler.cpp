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

#include "cell_grid.hpp"
#include "expansion.hpp"
#include "grid_fit.hpp"
#include "horopter/base/error.hpp"
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
      return length({bend.x.x * across + bend.y.x * along, bend.x.y * across + bend.y.y * along}) > error_px;
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
        return GridFit({geometry, nx, ny, lattice.shape}, lattice, profile.weight_bits, limits, simple, spans);
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
    return GridFit({geometry_, nx, ny, shape}, lattice_, profile_.weight_bits, limits_, surface.simple(), spans);
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
