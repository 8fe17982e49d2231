// SPDX-License-Identifier: Apache-2.0
// The stage `blind` against BlindWatch, which works on whole frames.
#include "stages/blind.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "horopter/machine/blind_watch.hpp"

namespace {

using namespace horopter;

constexpr int kWidth = 160, kHeight = 96;

/// A frame through the stage; the flags in the order in which pixels leave.
template <int SIDE>
std::vector<std::uint8_t> pass(stages::BlindBlocks<kWidth, kHeight, SIDE>& stage, const Image& states,
                               const BlindSettings& settings, bool forget = false) {
  using Stage = stages::BlindBlocks<kWidth, kHeight, SIDE>;
  const typename Stage::Config config{states.width,   states.height, settings.watch,
                                      settings.teach, forget,        settings.margin};
  std::vector<std::uint8_t> blind;
  const auto take = [&](const typename Stage::Out& out) {
    if (!out.there) return;
    const std::size_t at = blind.size();
    REQUIRE(at < states.pixels.size());
    CHECK(out.first == (at == 0));
    CHECK(out.last == ((at + 1) % static_cast<std::size_t>(states.width) == 0));
    CHECK(out.state.value() == states.pixels[at]);
    blind.push_back(out.blind ? 1 : 0);
  };
  for (int y = 0; y < states.height; ++y) {
    for (int x = 0; x < states.width; ++x) {
      const auto out = stage.step({states.at(x, y), x == 0 && y == 0, x + 1 == states.width, false}, config);
      CHECK(!out.done);
      take(out);
    }
  }
  for (int beats = 0;; ++beats) {
    const auto out = stage.step({0, false, false, true}, config);
    if (out.done) break;
    take(out);
    REQUIRE(beats < states.width * (SIDE + 2));
  }
  REQUIRE(blind.size() == states.pixels.size());
  return blind;
}

/// Undecidable in patches.
Image some_states(std::mt19937& random, int width, int height) {
  const auto uniform = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
  Image states(width, height);
  for (auto& pixel : states.pixels) {
    pixel = static_cast<std::uint8_t>(uniform(0, 30) == 0 ? uniform(0, 3) : uniform(0, 1));
  }
  for (int patch = uniform(0, 6); patch > 0; --patch) {
    const int left = uniform(0, width - 1), top = uniform(0, height - 1);
    const int right = std::min(width, left + uniform(1, 40)), bottom = std::min(height, top + uniform(1, 30));
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        if (uniform(0, 7) != 0) states.at(x, y) = static_cast<std::uint8_t>(stages::state::undecidable);
      }
    }
  }
  return states;
}

template <int SIDE>
void compare() {
  std::mt19937 random(SIDE);
  const auto uniform = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
  int blind_frames = 0, seeing_frames = 0;
  for (int sequence = 0; sequence < 60; ++sequence) {
    const int width = uniform(2 * 16, kWidth), height = uniform(16, kHeight);
    CAPTURE(sequence, width, height);
    stages::BlindBlocks<kWidth, kHeight, SIDE> stage;
    BlindWatch watch(width, height, SIDE);
    BlindSettings settings;
    bool forget = false;  // the frame before
    int good = 2;         // frames since one that spoils
    for (int frame = 0; frame < 14; ++frame) {
      CAPTURE(frame);
      if (uniform(0, 2) == 0) settings = {uniform(0, 3) != 0, uniform(0, 2) == 0, uniform(0, 20)};
      const Image states = some_states(random, width, height);
      const bool spoils = uniform(0, 8) == 0;
      const bool spoiled = spoils || uniform(0, 8) == 0;
      const std::vector<std::uint8_t> expected = watch.frame(states, settings, spoiled, spoils);
      const std::vector<std::uint8_t> blind = pass(stage, states, settings, forget);
      forget = settings.teach && (spoiled || good < 2);
      good = spoils ? 0 : good + 1;
      const bool any = std::find(expected.begin(), expected.end(), 1) != expected.end();
      (any ? blind_frames : seeing_frames) += 1;
      if (any) {
        REQUIRE(blind == expected);
      } else {
        REQUIRE(std::find(blind.begin(), blind.end(), 1) == blind.end());
      }
    }
  }
  CHECK(blind_frames >= 20);
  CHECK(seeing_frames >= 20);
}

TEST_CASE("blind: blocks of 8 and of 16 px as worked out frame by frame", "[blind]") {
  compare<8>();
  compare<16>();
}

TEST_CASE("blind: a frame that was broken off has taught nothing", "[blind]") {
  using Stage = stages::BlindBlocks<kWidth, kHeight, 8>;
  Stage stage;
  Image states(64, 32);
  pass(stage, states, {});
  Image patch = states;
  for (int y = 8; y < 16; ++y) {
    for (int x = 16; x < 32; ++x) patch.at(x, y) = static_cast<std::uint8_t>(stages::state::undecidable);
  }
  const auto blind_pixels = [&] {
    const std::vector<std::uint8_t> blind = pass(stage, patch, {true, false, 8});
    return std::count(blind.begin(), blind.end(), 1);
  };
  CHECK(blind_pixels() == 128);  // never taught: everything could be decided
  const Stage::Config config{64, 32, false, true, false, 8};
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 64; ++x) stage.step({patch.at(x, y), x == 0 && y == 0, x + 1 == 64, false}, config);
  }
  CHECK(blind_pixels() == 128);
  pass(stage, patch, {false, true, 8});
  CHECK(blind_pixels() == 0);
  pass(stage, states, {false, true, 8});  // taught anew: what was taught before is forgotten
  CHECK(blind_pixels() == 128);
}

}  // namespace
