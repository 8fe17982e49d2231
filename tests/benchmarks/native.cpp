// SPDX-License-Identifier: Apache-2.0
// Frames per second of the native engine, for frames of noise (every branch is unpredictable): for each profile and rule,
// with all instructions that this processor has, and one or two threads. `horopter evaluate` compares it with OpenCV.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "stages/engine.hpp"

namespace {

using namespace horopter;

/// Identity shifted by half a pixel, control points every 8 px; the CRC is not checked by the engine.
std::vector<std::uint32_t> shifted_table(int width, int height) {
  return hls::table::write({width, height, 3, 3}, {}, [](int column, int row) {
    return hls::table::encode_control(column * 8 - 20 / 32.0, row * 8 + 12 / 32.0);
  });
}

void process(benchmark::State& state, const std::string& name, hls::Rule rule, native::Instructions instructions,
             int threads) {
  const auto engine = native::make_engine(name, threads, instructions);
  const hls::Profile& profile = engine->profile();
  std::mt19937 random(7);
  const std::size_t pixels = static_cast<std::size_t>(profile.width) * static_cast<std::size_t>(profile.height);
  std::vector<std::uint8_t> left(pixels);
  std::vector<std::uint8_t> right(pixels);
  for (auto& pixel : left) pixel = static_cast<std::uint8_t>(random());
  for (auto& pixel : right) pixel = static_cast<std::uint8_t>(random());
  const auto words = shifted_table(profile.width, profile.height);
  const native::TableView table(words);
  auto settings = native::Settings::defaults(profile, profile.width, profile.height);
  settings.compete = rule == hls::Rule::compete ? 1 : 0;
  const auto view = [&](const std::vector<std::uint8_t>& image) {
    return native::ImageView{image.data(), profile.width, profile.height, profile.width};
  };
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(engine->process(view(left), view(right), table, settings));
  }
  state.SetItemsProcessed(state.iterations());
  state.SetLabel("items = frames (fields)");
}

}  // namespace

int main(int argc, char** argv) {
  for (const auto& named : hls::named_profiles) {
    const std::string name(named.name);
    for (const hls::Rule rule : {hls::Rule::thesis, hls::Rule::compete}) {
      if (!named.profile.has(rule)) continue;
      for (const native::Instructions instructions : native::available_instructions()) {
        for (const int threads : {1, 2}) {
          const std::string title = "native/" + name + (rule == hls::Rule::compete ? "/compete/" : "/thesis/") +
                                    std::string(native::name_of(instructions)) + "/threads:" + std::to_string(threads);
          benchmark::RegisterBenchmark(
              title.c_str(), [=](benchmark::State& state) { process(state, name, rule, instructions, threads); })
              ->Unit(benchmark::kMillisecond)
              ->UseRealTime();
        }
      }
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
