// SPDX-License-Identifier: Apache-2.0
#include "horopter/map/map_compiler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cell_grid.hpp"
#include "forecast.hpp"
#include "grid_choice.hpp"
#include "grid_fit.hpp"
#include "horopter/base/error.hpp"
#include "horopter/map/row_check.hpp"

namespace horopter {
namespace {

/// Coarsest steps between samples: enough for second differences of what is smooth; 4 pixels where it may not be.
constexpr int kSmoothLog2 = 5;
constexpr int kFeatureLog2 = 2;

/// Of a table that knows them.
std::size_t areas_of(const MachineProfile& profile, const ScanGeometry& geometry) {
  hls::table::Facts facts;
  facts.subsample = profile.subsample;
  return facts.area_count({.width = geometry.width, .height = geometry.height});
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
  const Forecast forecast(lattice, geometry);
  CompiledMap map = choose({
      .profile = profile,
      .geometry = geometry,
      .limits = limits,
      .forecast = forecast,
      .margin = 4,  // the forecast only sorts out what is far off
      .areas = rig_skin != nullptr ? areas_of(profile, geometry) : 0,
      .outline = outline ? &*outline : nullptr,
      .fit =
          [&](int nx, int ny, const Outline* spans) {
            return GridFit({geometry, nx, ny, lattice.shape}, lattice, profile.weight_bits, limits, simple, spans);
          },
  });
  const LatticeShape shape = control_shape(map.table);
  const std::vector<Point> controls = shape.points(geometry);
  std::vector<Point> sources(controls.size());
  skin.look_around(controls, sources);
  show_around(shape, sources, map.table);
  hls::table::Facts facts = facts_of(map.table, profile);
  if (rig_skin != nullptr) {
    SkinScale(rig_skin->cameras(), profile, geometry, limits.view).measure(*rig_skin->surface(), facts);
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
      scale_(cameras_, profile, geometry, limits.view),
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
  constexpr int kCoarseLog2 = Forecast::kLog2;
  look(surface, LatticeShape::of(geometry_, kCoarseLog2, kCoarseLog2, kCoarseLog2, kCoarseLog2), coarse);
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
  CompiledMap map = choose({
      .profile = profile_,
      .geometry = geometry_,
      .limits = limits_,
      .forecast = forecast,
      .margin = 1.1,
      .areas = areas_of(profile_, geometry_),
      .outline = outline ? &*outline : nullptr,
      .fit = fit,
  });
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
