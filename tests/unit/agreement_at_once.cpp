// SPDX-License-Identifier: Apache-2.0
// `agreement` on the CPU: compared a row at once, it says in every beat what it says in the hardware's beats.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "stages/agreement.hpp"

namespace {

using namespace horopter;
using namespace horopter::stages;

constexpr hls::Profile small(hls::Profile profile, int width, int height) {
  profile.width = width;
  profile.height = height;
  return profile;
}

/// Places of one grey value, as large as a cell or a part of it; few values, so that scores are often equal.
struct Places {
  Places(std::mt19937& random, int values) : grey(64 * 64) {
    for (auto& value : grey)
      value =
          static_cast<std::uint8_t>(random() % static_cast<unsigned>(values) * 200U / static_cast<unsigned>(values));
  }
  [[nodiscard]] int at(int x, int y, int size, int rows) const {
    return grey[static_cast<std::size_t>(y / size % rows * 64 + (x / size + 32) % 64)];
  }
  std::vector<std::uint8_t> grey;
};

template <class Stage>
typename Stage::Config config_of(int width, int height, unsigned seed) {
  typename Stage::Config config;
  config.width = width;
  config.height = height;
  config.prove = 1;
  config.shift_lowest = seed % 3 == 0 ? -29 : -5;
  config.shift_highest = seed % 3 == 1 ? 29 : 7;
  config.nearer_above = 1;
  config.explained_limit = 108;
  config.regions_limit = 64;
  config.unproven_limit = 115;
  config.unproven_skin_limit = 154;
  config.hidden_limit = 26;
  config.hidden_frames = 1;
  config.moved_limit = 3;
  config.moved_half_limit = 5;
  config.patch_limit = 8;
  config.on_skin_limit = 4;
  config.on_skin_cells = static_cast<int>(seed % 4) * 8;
  config.epipolar_slope = static_cast<int>(seed * 661 % 2000) - 1000;
  config.epipolar_row = static_cast<int>(seed * 67 % 200) - 100;
  return config;
}

/// `scene`: the same in each frame, so that places are compared at full resolution; else another one.
template <hls::Profile P>
void check_same(int width, int height, unsigned seed, bool scene = false) {
  CAPTURE(width, height, seed);
  std::mt19937 random(seed);
  Agreement<P, true> at_once;
  Agreement<P, false> by_beats;
  Agreement<P, true> by_rows;  // takes several beats of a row at once
  std::size_t words = 0;
  int differences = 0;
  int beats = 0, taken_at_once = 0;
  using Out = typename Agreement<P, true>::Out;
  const auto same = [](const auto& a, const auto& b) {
    return a.marks.first == b.marks.first && a.marks.last == b.marks.last && a.marks.seen == b.marks.seen &&
           a.marks.nearer == b.marks.nearer && a.mask == b.mask && a.saturated == b.saturated && a.pixel == b.pixel &&
           a.frame.valid == b.frame.valid && a.frame.index == b.frame.index && a.frame.word == b.frame.word &&
           a.verdict.valid == b.verdict.valid && a.verdict.disagree == b.verdict.disagree &&
           a.verdict.moved == b.verdict.moved && a.verdict.hidden == b.verdict.hidden &&
           a.verdict.untextured == b.verdict.untextured && a.verdict.unproven_yet == b.verdict.unproven_yet &&
           a.verdict.unsharp_left == b.verdict.unsharp_left && a.verdict.unsharp_right == b.verdict.unsharp_right &&
           a.verdict.overlooked == b.verdict.overlooked && a.verdict.out_of_step == b.verdict.out_of_step;
  };
  const auto columns = static_cast<std::size_t>(width);
  std::vector<hls::u<8>> left_row(columns), right_row(columns);
  const auto mask_row = std::make_unique<bool[]>(columns), present_row = std::make_unique<bool[]>(columns);
  std::vector<Out> said(columns);
  const unsigned frames = scene ? 16 : 4;
  int rounds = 0;
  std::mt19937 of_scene(seed);
  const Places still(of_scene, 250);
  for (unsigned frame = 0; frame < frames; ++frame) {
    const auto config_at_once = config_of<Agreement<P, true>>(width, height, scene ? seed : seed + frame / 2);
    const auto config_by_beats = config_of<Agreement<P, false>>(width, height, scene ? seed : seed + frame / 2);
    const Places places = scene ? still : Places(random, frame % 2 == 0 ? 3 : 250);
    const int size = scene ? 11 : (frame == 3 ? 5 : Agreement<P>::cell);
    const int across = scene ? 13 : static_cast<int>(random() % 160) - 60;
    // Of two rows in turn: displaced by one of them up or down is the same.
    const int rows = scene ? 64 : (frame == 2 ? 2 : 8);
    const int down = scene ? static_cast<int>(seed) - 2 : (frame == 2 ? size : static_cast<int>(random() % 5) - 2);
    for (int y = 0; y < height + P.flush_rows(); ++y) {
      const bool live = y < height;
      for (int x = 0; x < width; ++x) {
        const auto noisy = [&](int grey) { return hls::u<8>(static_cast<unsigned>(grey) + random() % 3); };
        const hls::u<8> left = noisy(places.at(x, y, size, rows));
        const hls::u<8> right = noisy(places.at(x + across + 64 * size, y + down + 8 * size, size, rows));
        typename Agreement<P, true>::In in;
        in.present = live && x >= width / 16;
        in.mask = in.present && x < width - width / 10;
        in.saturated = random() % 16 == 0;
        const auto beat = [&](bool first, bool last) {
          in.marks = {first, last};
          const auto a = at_once.step(in, config_at_once);
          const auto b = by_beats.step({in.pixel, in.saturated, in.mask, in.present, in.marks}, config_by_beats);
          words += b.frame.valid ? 1U : 0U;
          rounds += b.frame.valid && b.frame.index == 63 && b.frame.word.template bits<7, 0>() != 0 ? 1 : 0;
          differences += same(a, b) ? 0 : 1;
          said[static_cast<std::size_t>(x)] = a;
        };
        const bool first = x == 0 && y == 0;
        const bool last = x + 1 == width;
        if constexpr (P.packed()) {
          in.pixel = {left};
          beat(first, false);
          in.pixel = {right};
          beat(false, last);
        } else {
          in.pixel = {left, right};
          beat(first, last);
          const auto at = static_cast<std::size_t>(x);
          left_row[at] = left;
          right_row[at] = right;
          mask_row[at] = in.mask;
          present_row[at] = in.present;
        }
      }
      if constexpr (!P.packed()) {
        for (int x = 0; x < width;) {
          const auto at = static_cast<std::size_t>(x);
          const auto seen = std::make_unique<bool[]>(columns), nearer = std::make_unique<bool[]>(columns);
          const int most = random() % 4 == 0 ? static_cast<int>(random() % 40U) : width;
          const int taken = by_rows.pass_beats(
              {&left_row[at], &right_row[at], &mask_row[at], &present_row[at], seen.get(), nearer.get()},
              std::min(width - x - 1, most), config_at_once);
          for (int i = 0; i < taken; ++i) {
            const Out& expected = said[at + static_cast<std::size_t>(i)];
            const bool right = expected.marks.seen == seen[static_cast<std::size_t>(i)] &&
                               expected.marks.nearer == nearer[static_cast<std::size_t>(i)] && !expected.frame.valid &&
                               !expected.verdict.valid;
            differences += right ? 0 : 1;
          }
          if (taken == 0) {
            const typename Agreement<P, true>::In in{{left_row[at], right_row[at]},
                                                     said[at].saturated,
                                                     mask_row[at],
                                                     present_row[at],
                                                     {x == 0 && y == 0, x + 1 == width}};
            differences += same(by_rows.step(in, config_at_once), said[at]) ? 0 : 1;
          }
          x += std::max(taken, 1);
          taken_at_once += taken;
        }
        beats += width;
      }
    }
  }
  if (width >= 320) CHECK(2 * taken_at_once > beats);
  CHECK(words == frames * (FrameWord::regions + FrameWord::count_of_frame));
  CHECK(differences == 0);
  if (scene && width == 640) CHECK(rounds > 0);
}

}  // namespace

TEST_CASE("agreement: a row compared at once is what the hardware's beats come to") {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    check_same<small(hls::profiles::vga, 320, 240)>(320, 240, seed);
    check_same<small(hls::profiles::vga, 320, 240)>(203, 121, seed);
    check_same<small(hls::profiles::hd, 640, 480)>(640, 480, seed, true);
    check_same<small(hls::profiles::field, 376, 280)>(188, 280, seed, true);
    check_same<small(hls::profiles::hd, 640, 256)>(640, 256, seed);
    check_same<small(hls::profiles::field, 376, 160)>(188, 160, seed);
    // Down to the smallest that the machine takes: a row of cells is done just before the next one is complete.
    check_same<hls::profiles::vga>(32, 16, seed);
    check_same<hls::profiles::vga>(33, 70, seed);
    check_same<hls::profiles::hd>(32, 160, seed);
    check_same<hls::profiles::field>(32, 90, seed);
  }
}
