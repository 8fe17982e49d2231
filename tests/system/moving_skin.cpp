// SPDX-License-Identifier: Apache-2.0
// A skin that moves with every frame, its tables uploaded while the co-simulated hardware runs: every frame is that of
// its own table.
#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "../unit/host_temporary.hpp"
#include "../unit/table_11_1.hpp"
#include "horopter/machine/moving_supervisor.hpp"
#include "horopter/machine/native_device.hpp"
#include "horopter/machine/registers.hpp"
#include "horopter/machine/rtl_device.hpp"

namespace horopter {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 48;
constexpr std::size_t kFrames = 100;

/// Smooth enough to have texture, and different in every frame.
Image textured(unsigned seed) {
  std::mt19937 random(seed);
  Image image(kWidth, kHeight);
  int value = 128;
  for (auto& pixel : image.pixels) {
    value = std::clamp(value + static_cast<int>(random() % 81) - 40, 5, 250);
    pixel = static_cast<std::uint8_t>(value);
  }
  return image;
}

/// What the right camera sees of a left image that lies on the skin.
Image right_of(const Image& left, const MapTable& table) {
  Image right = textured(4711);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (const auto source = table.source(x, y, 0)) right.at(source->x, source->y) = left.at(x, y);
    }
  }
  return right;
}

MovingMaps moving_plane(const MachineProfile& profile) {
  const CameraPair cameras = table_11_1(kWidth, kHeight);
  const TemporaryDirectory directory;
  const std::filesystem::path skin =
      directory.write("skin.yaml",
                      "surface: {type: plane, point_mm: [0, 0, 800], normal: [0, 0, 1]}\n"
                      "motion:\n"
                      "  frame_rate_per_s: 60\n"
                      "  object_speed_m_s: 1.6\n"
                      "  about_mm: [0, 0, 800]\n"
                      "  poses:\n"
                      "    - {time_s: 0.8, shift_mm: [0, 0, 120], rotation_deg: [10, 0, 0]}\n"
                      "    - {time_s: 1.65, shift_mm: [0, 0, -50], rotation_deg: [0, 20, 0]}\n");
  const calib::Rig rig{"", {cameras.left(), cameras.right()}};
  return compile_motion(load_skin(skin, {}, &rig), profile, kWidth, kHeight);
}

}  // namespace

TEST_CASE("A skin that moves every frame for 100 frames, uploaded while the hardware runs") {
  const MachineProfile& profile = find_profile("vga");
  const MovingMaps maps = moving_plane(profile);
  REQUIRE(maps.steps.size() == kFrames);
  std::set<std::uint32_t> tables;
  for (const MovingStep& step : maps.steps) tables.insert(step.map.table.crc());
  REQUIRE(tables.size() == kFrames);

  const bool back_to_back = GENERATE(true, false);
  CAPTURE(back_to_back);
  auto device = make_rtl_device(profile);
  auto& rtl = dynamic_cast<RtlDevice&>(*device);
  MovingSupervisor hardware(std::move(device), profile, maps, Settings{}.without_proof());
  std::int64_t skin_pixels = 0;
  std::size_t before = 0;  // frames whose neighbour's table would have given something else
  const auto check = [&](std::size_t k, const Image& left, const Image& right, const FrameResult& result) {
    CAPTURE(k);
    const CompiledMap& own = maps.steps[k].map;
    CHECK(result.sequence == k + 1);
    CHECK(result.table_crc == own.table.crc());
    CHECK(result.skin_time_s == maps.steps[k].time_s);
    CHECK(!result.faults.any());
    // A machine that knows this table alone.
    const auto alone = [&](const CompiledMap& map) {
      MapSet set{"vga", kWidth, kHeight, "", "", {map}};
      set.maps[0].report.lookahead = maps.lookahead;
      return Supervisor(make_native_device(profile), profile, set, Settings{}.without_proof())
          .process(left, right)
          .at(0);
    };
    const FrameResult expected = alone(own);
    CHECK(result.states == expected.states);
    CHECK(result.runs == expected.runs);
    CHECK(result.skin_pixels == expected.skin_pixels);
    CHECK(result.undecidable_pixels == expected.undecidable_pixels);
    CHECK(result.alarm == expected.alarm);
    CHECK(result.safe == expected.safe);
    skin_pixels += result.skin_pixels;
    if (k > 0) before += alone(maps.steps[k - 1].map).states != expected.states ? 1 : 0;
  };
  std::vector<Image> left;
  std::vector<Image> right;
  for (std::size_t k = 0; k < kFrames; ++k) {
    left.push_back(textured(static_cast<unsigned>(k) + 1));
    right.push_back(right_of(left[k], maps.steps[k].map.table));
  }
  const std::uint64_t start = rtl.clocks();
  if (back_to_back) {
    // The cameras send the next pair while the one before is in the machine.
    hardware.begin(left[0], right[0]);
    for (std::size_t k = 0; k < kFrames; ++k) {
      if (k + 1 < kFrames) hardware.begin(left[k + 1], right[k + 1]);
      check(k, left[k], right[k], hardware.finish());
    }
    // No more than the frames and the start of the first and the end of the last one take.
    CHECK(rtl.clocks() - start < kFrames * (kWidth + 8) * (kHeight + 14) + 20'000);
  } else {
    for (std::size_t k = 0; k < kFrames; ++k) check(k, left[k], right[k], hardware.process(left[k], right[k]).at(0));
  }
  CHECK(skin_pixels > 0);
  CHECK(before > kFrames / 2);
  CHECK(rtl.safe_pin() != rtl.unsafe_pin());
}

}  // namespace horopter
