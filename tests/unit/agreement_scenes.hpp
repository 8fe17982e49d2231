// SPDX-License-Identifier: Apache-2.0
// Scenes of known depth for tests of the stage `agreement`, and what it says of them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "horopter/hls/settings.hpp"
#include "stages/agreement.hpp"

namespace horopter::agreement_scenes {

using namespace horopter;
using namespace horopter::stages;

inline constexpr hls::Profile kSmall = [] {
  hls::Profile profile = hls::profiles::vga;
  profile.width = 320;
  profile.height = 240;
  return profile;
}();
using Small = Agreement<kSmall>;

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<double> grey;
  double at(double x, double y) const {
    const double cx = std::clamp(x, 0.0, width - 1.001);
    const double cy = std::clamp(y, 0.0, height - 1.001);
    const auto ix = static_cast<std::size_t>(cx);
    const auto iy = static_cast<std::size_t>(cy);
    const double fx = cx - static_cast<double>(ix);
    const double fy = cy - static_cast<double>(iy);
    const auto w = static_cast<std::size_t>(width);
    const double* p = grey.data() + iy * w + ix;
    return (1 - fy) * ((1 - fx) * p[0] + fx * p[1]) + fy * ((1 - fx) * p[w] + fx * p[w + 1]);
  }
};

/// Smooth patches of random grey, some px wide.
inline Picture scene(int width, int height, unsigned seed) {
  constexpr int kPatch = 11;
  std::mt19937 random(seed);
  Picture picture{width, height, {}};
  const int columns = width / kPatch + 2;
  std::vector<double> patches(static_cast<std::size_t>(columns * (height / kPatch + 2)));
  for (double& patch : patches) patch = static_cast<double>(random() % 200);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture.grey.push_back(20 + patches[static_cast<std::size_t>(y / kPatch * columns + x / kPatch)]);
    }
  }
  return picture;
}

using Place = std::function<std::pair<double, double>(double, double)>;

/// What stands at place(x, y) of the scene, with noise.
inline Picture seen(const Picture& of, const Place& place, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 1.5);
  Picture picture{of.width, of.height, {}};
  for (int y = 0; y < of.height; ++y) {
    for (int x = 0; x < of.width; ++x) {
      const auto [sx, sy] = place(x, y);
      picture.grey.push_back(std::clamp(of.at(sx, sy) + noise(random), 0.0, 255.0));
    }
  }
  return picture;
}

inline Place shifted(double dx, double dy) {
  return [=](double x, double y) { return std::pair{x + dx, y + dy}; };
}

inline Picture blurred(const Picture& of, int reach) {
  Picture picture{of.width, of.height, {}};
  for (int y = 0; y < of.height; ++y) {
    for (int x = 0; x < of.width; ++x) {
      double sum = 0;
      for (int dx = -reach; dx <= reach; ++dx) sum += of.at(x + dx, y);
      picture.grey.push_back(sum / (2 * reach + 1));
    }
  }
  return picture;
}

inline Small::Config defaults(int width, int height) {
  Small::Config config{};
  config.width = width;
  config.height = height;
  config.prove = 1;
  config.same_table = 1;
  config.shift_lowest = -30;
  config.shift_highest = 30;
  config.nearer_below = 1;
  config.explained_limit = 107;
  config.regions_limit = 64;
  config.unproven_limit = 115;
  config.unproven_skin_limit = hls::StageSettings{}.unproven_skin_limit;
  config.hidden_limit = 26;
  config.hidden_frames = 3;
  config.moved_limit = 3;
  config.moved_half_limit = 5;
  config.patch_limit = hls::StageSettings{}.patch_limit;
  config.on_skin_limit = hls::StageSettings{}.on_skin_limit;
  config.on_skin_cells = hls::StageSettings{}.on_skin_cells;
  return config;
}

struct Answer {
  Verdict verdict;
  int textured = 0;
  int explained = 0;
  int nearer = 0;
  int verdicts = 0;
  double seen_share = 0;
  double nearer_share = 0;
  std::array<double, kSmall.height> seen_of_row{};  ///< share of the pixels of a row of the image
  int places = 0;                                   // of a round at full resolution
  double across_px = 0;
  int displaced = 0;  // more than half of them, by one of three ways
};

/// Pixels of the skin; around it both images are there, too.
struct Box {
  int left = 0, top = 0, right = 320, bottom = 240;
  bool holds(int x, int y) const { return x >= left && x < right && y >= top && y < bottom; }
};

inline Answer frame(Small& stage, const Small::Config& config, const Picture& left, const Picture& right,
                    const Box& skin = {}) {
  Answer answer;
  int seen = 0;
  int nearer = 0;
  const int later = config.compete != 0 ? compete_offset<kSmall>.rows : thesis_offset<kSmall>.rows;
  for (int y = 0; y < left.height + kSmall.flush_rows(); ++y) {
    for (int x = 0; x < left.width; ++x) {
      Small::In in;
      in.present = y < left.height;
      in.mask = in.present && skin.holds(x, y);
      if (in.present) {
        const auto i = static_cast<std::size_t>(y * left.width + x);
        in.pixel = {u<8>(static_cast<int>(left.grey[i])), u<8>(static_cast<int>(right.grey[i]))};
      }
      in.marks = {x == 0 && y == 0, x + 1 == left.width};
      const auto out = stage.step(in, config);
      const auto word = static_cast<int>(out.frame.word.value());
      if (out.frame.valid && out.frame.index == FrameWord::first_of_frame) {
        answer.textured = word & 0xFFFF;
        answer.explained = word >> 16;
      }
      if (out.frame.valid && out.frame.index == FrameWord::first_of_frame + 1) answer.nearer = word >> 16;
      if (out.frame.valid && out.frame.index == 63) {
        answer.places = word & 0xFF;
        answer.across_px = answer.places > 0 ? s<12>(word >> 8).value() / 8.0 / answer.places : 0;
        answer.displaced = word >> 20 & 7;
      }
      if (out.verdict.valid) {
        answer.verdict = out.verdict;
        ++answer.verdicts;
      }
      // The border that the filters take is not counted.
      if (y >= 24 && y < left.height && x >= 24) {
        seen += out.marks.seen;
        nearer += out.marks.nearer;
      }
      const int row = y - later;
      if (row >= 0 && row < left.height && x >= 24) {
        answer.seen_of_row[static_cast<std::size_t>(row)] += out.marks.seen / (left.width - 24.0);
      }
    }
  }
  const double pixels = (left.height - 24.0) * (left.width - 24);
  answer.seen_share = seen / pixels;
  answer.nearer_share = nearer / pixels;
  return answer;
}

/// The answer to the last of some frames of the same pair.
inline Answer last_of(int frames, const Small::Config& config, const Picture& left, const Picture& right,
                      const Box& skin = {}) {
  const auto stage = std::make_unique<Small>();
  Answer answer;
  for (int i = 0; i < frames; ++i) answer = frame(*stage, config, left, right, skin);
  return answer;
}

/// Frames of 320×240 with which a round of places at full resolution is complete.
inline constexpr int kRound = 24;

inline bool faultless(const Verdict& v) {
  return v.valid && !v.unproven_yet && !v.untextured && !v.disagree && !v.moved && !v.unsharp_left &&
         !v.unsharp_right && !v.hidden && !v.out_of_step;
}

}  // namespace horopter::agreement_scenes
