// SPDX-License-Identifier: Apache-2.0
// Frames of beats for the tests of window stages.
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "stages/stream.hpp"

namespace horopter::tests {

template <class Beat>
struct Frame {
  int width = 0;
  int height = 0;
  std::vector<Beat> beats;

  Frame(int w, int h) : width(w), height(h), beats(static_cast<std::size_t>(w * h)) {
    for (int y = 0; y < h; ++y) {
      for (int x = 0; x < w; ++x) {
        at(x, y).marks.first = x == 0 && y == 0;
        at(x, y).marks.last = x + 1 == w;
      }
    }
  }
  Beat& at(int x, int y) { return beats[static_cast<std::size_t>(y * width + x)]; }
  const Beat& at(int x, int y) const { return beats[static_cast<std::size_t>(y * width + x)]; }
};

/// All beats of a frame through a stage that has one result a beat.
template <class Stage, class... Config>
Frame<typename Stage::Out> pass(Stage& stage, const Frame<typename Stage::In>& frame, const Config&... config) {
  Frame<typename Stage::Out> out(frame.width, frame.height);
  for (std::size_t i = 0; i < frame.beats.size(); ++i) out.beats[i] = stage.step(frame.beats[i], config...);
  return out;
}

/// True for a k×k window that ends at (x, y), lies in the frame and has the bit everywhere.
template <class Beat, class Bit>
bool window_all(const Frame<Beat>& frame, int x, int y, int k, const Bit& bit) {
  for (int j = 0; j < k; ++j) {
    for (int i = 0; i < k; ++i) {
      if (x - i < 0 || y - j < 0 || !bit(frame.at(x - i, y - j))) return false;
    }
  }
  return true;
}

inline bool one_in(std::mt19937& random, unsigned n) { return random() % n == 0; }

}  // namespace horopter::tests
