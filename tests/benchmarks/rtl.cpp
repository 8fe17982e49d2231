// SPDX-License-Identifier: Apache-2.0
// Clocks per second of the Verilated top, one frame of noise after another.
#include <benchmark/benchmark.h>

#include <memory>
#include <random>
#include <string>

#include "horopter/machine/monitor.hpp"
#include "horopter/machine/rtl_device.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/skin/skin.hpp"

namespace {

using namespace horopter;

Image noise(int width, int height, std::mt19937& random) {
  Image image(width, height);
  for (auto& pixel : image.pixels) pixel = static_cast<std::uint8_t>(random());
  return image;
}

void process(benchmark::State& state, const MachineProfile& profile) {
  ScanGeometry geometry;
  geometry.width = profile.width;
  geometry.height = profile.height;
  // The right camera sees the skin half a pixel further right.
  const auto map = compile_map(HomographySkin({1, 0, 0.5, 0, 1, 0, 0, 0, 1}), profile, geometry);
  auto device = make_rtl_device(profile);
  const auto& clocks = dynamic_cast<const RtlDevice&>(*device);
  Monitor monitor(std::move(device), profile);
  monitor.start(profile.width, profile.height, map.report.lookahead);
  monitor.upload(0, map.table);
  monitor.select(0);
  std::mt19937 random(7);
  std::uint64_t passed = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Image left = noise(profile.width, profile.height, random);
    const Image right = noise(profile.width, profile.height, random);
    const auto before = clocks.clocks();
    benchmark::DoNotOptimize(monitor.process(left, right));
    passed += clocks.clocks() - before;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(passed));
  state.SetLabel("items = clocks");
}

}  // namespace

int main(int argc, char** argv) {
  for (const MachineProfile& profile : profiles()) {
    benchmark::RegisterBenchmark(("rtl/" + std::string(profile.name)).c_str(), [&profile](benchmark::State& state) {
      process(state, profile);
    })->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
