// SPDX-License-Identifier: Apache-2.0
// Mapping tables per second, for skins that move: choice of spacing and check of 4 samples a cell included. On one core, and
// as those of a motion are made, on all (`threads`).
// Rig of Table 11.1 with κ1 = 1e-3/mm² (2 % at the corners). The thesis (10.4.1) estimated almost 10 planes and fewer
// than 2 ellipsoids a second for a signal processor.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <thread>

#include "../unit/table_11_1.hpp"
#include "horopter/map/map_compiler.hpp"

namespace {

using namespace horopter;
using Eigen::Vector3d;
using MakeSurface = std::function<SurfacePtr(double shift_mm)>;

void compile(benchmark::State& state, const std::string& profile_name, const MakeSurface& make, int pool_part) {
  const MachineProfile& profile = find_profile(profile_name);
  const CameraPair cameras = table_11_1(profile.largest_image_width(), profile.largest_image_height());
  const ScanGeometry geometry =
      scans_of(profile, profile.largest_image_width(), profile.largest_image_height()).front();
  MapLimits limits;
  limits.largest_bytes = static_cast<std::size_t>(profile.pool_bytes / pool_part);
  MapCompiler compiler(cameras, profile, geometry, limits);
  double shift_mm = 0;
  MapReport report;
  double lost = 0;
  for ([[maybe_unused]] auto _ : state) {
    shift_mm = std::fmod(shift_mm + 0.7, 20);
    report = compiler.compile(*make(shift_mm)).report;
    lost += report.lost_share();
  }
  state.SetItemsProcessed(state.iterations());
  const auto mean = benchmark::Counter::kAvgThreads;
  state.counters["bytes"] = {static_cast<double>(report.pool_bytes), mean};
  state.counters["lost_%"] = {100 * lost / static_cast<double>(state.iterations()), mean};  // of all of them
  state.SetLabel("items = tables; every " + std::to_string(report.spacing_x) + "x" + std::to_string(report.spacing_y));
}

SurfacePtr plane(double shift_mm) { return make_plane({0, 0, 800 + shift_mm}, {0.1, 0.2, -1}); }

/// Seen within 70° all over the image.
SurfacePtr ellipsoid(double shift_mm) { return make_ellipsoid(at({0, 0, 1200 + shift_mm}), {600, 500, 400}); }

/// Its outline is in the image.
SurfacePtr small_ellipsoid(double shift_mm) { return make_ellipsoid(at({0, 0, 1000 + shift_mm}), {250, 200, 200}); }

/// A dome of 10,082 triangles; moving it needs no new search tree.
SurfacePtr mesh(double shift_mm) {
  static const SurfacePtr dome = [] {
    std::vector<std::vector<double>> heights(72, std::vector<double>(72));
    for (std::size_t row = 0; row < 72; ++row) {
      for (std::size_t column = 0; column < 72; ++column) {
        const double x = (static_cast<double>(column) - 35.5) * 12;
        const double y = (static_cast<double>(row) - 35.5) * 12;
        heights[row][column] = (x * x + y * y) / 1200;
      }
    }
    return make_mesh(height_field({-426, -426, 0}, {12, 12}, heights));
  }();
  return make_moved(dome, at({0, 0, 800 + shift_mm}));
}

}  // namespace

int main(int argc, char** argv) {
  for (const char* profile : {"field", "hd"}) {
    const auto add = [&](const char* name, const MakeSurface& make, int pool_part = 1) {
      return benchmark::RegisterBenchmark((std::string(profile) + "/" + name).c_str(),
                                          [=](benchmark::State& state) { compile(state, profile, make, pool_part); })
          ->Unit(benchmark::kMillisecond);
    };
    add("plane", plane);
    add("ellipsoid", ellipsoid);
    add("ellipsoid_with_outline", small_ellipsoid);
    add("ellipsoid_with_outline_in_half_of_the_pool", small_ellipsoid, 2);
    const int cores = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 8U));
    add("ellipsoid_with_outline_on_all_cores", small_ellipsoid)->Threads(cores)->UseRealTime();
    add("ellipsoid_with_outline_in_half_of_the_pool_on_all_cores", small_ellipsoid, 2)->Threads(cores)->UseRealTime();
    add("mesh", mesh);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
