// SPDX-License-Identifier: Apache-2.0
// The rule `compete`: the native engine against the same stages beat by beat, and on images made for a purpose.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "stages/pipeline.hpp"

using namespace horopter;
using namespace horopter::stages;

namespace {

constexpr hls::Profile kPlain{149, 90, 1, 9, 7, 3, 32, 0, 1, 1};

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;

  Picture(int w, int h, const std::function<int(int, int)>& value) : width(w), height(h) {
    for (int y = 0; y < h; ++y) {
      for (int x = 0; x < w; ++x) pixels.push_back(static_cast<std::uint8_t>(value(x, y)));
    }
  }
  [[nodiscard]] int at(int x, int y) const { return pixels[static_cast<std::size_t>(y * width + x)]; }
  [[nodiscard]] native::ImageView view() const { return {pixels.data(), width, height, width}; }
};

/// A table of control points every 8 px: the right pixel `shift` px to the left.
std::vector<std::uint32_t> table_of(int width, int height, int shift) {
  return hls::table::write({width, height, 3, 3}, {}, [&](int column, int row) {
    return hls::table::encode_control(column * 8 - shift, row * 8);
  });
}

template <hls::Profile P>
std::vector<std::uint8_t> engine_states(native::Pipeline<P>& engine, const Picture& left, const Picture& right,
                                        int shift, const native::CompeteSettings& competition = {}) {
  auto settings = native::Settings::defaults(P, left.width, left.height);
  settings.compete = true;
  settings.prove = 0;
  static_cast<native::CompeteSettings&>(settings) = competition;
  const auto words = table_of(left.width, left.height, shift);
  return engine.process(left.view(), right.view(), native::TableView(words), settings).states;
}

/// The same stages, each called once per beat of the whole stream; garbage where there is no pixel.
class BeatByBeat {
 public:
  std::vector<std::uint8_t> frame(const Picture& left, const Picture& right, int shift,
                                  const native::CompeteSettings& competition, std::mt19937& random) {
    native::Settings settings;
    settings.compete = true;
    static_cast<native::CompeteSettings&>(settings) = competition;
    chain_.configure(native::FrameSettings(settings, left.width, left.height));
    std::vector<std::uint8_t> states;
    for (int y = 0; y < left.height + kPlain.flush_rows(true); ++y) {
      for (int x = 0; x < left.width; ++x) {
        Grey<2> pair;
        pair.pixel = {u<8>(random()), u<8>(random())};
        pair.mask = y < left.height && x >= shift && x - shift < right.width;
        if (pair.mask) {
          pair.pixel = {u<8>(left.at(x, y)), u<8>(right.at(x - shift, y))};
          pair.saturated = left.at(x, y) == 0 || left.at(x, y) == 255 || right.at(x - shift, y) == 0 ||
                           right.at(x - shift, y) == 255;
        }
        pair.marks = {x == 0 && y == 0, x + 1 == left.width, true, false};
        chain_.step(pair, [&]<Stage STAGE>(At<STAGE>, const auto& out) {
          if constexpr (STAGE == Stage::align) {
            if (!out.idle) states.push_back(out.state.value());
          }
        });
      }
    }
    return states;
  }

 private:
  Chain<kPlain, Rule::compete, Stage::slopes> chain_;
};

/// Smoothed noise; beyond the image too, so that shifted pictures agree.
int texture(int x, int y, unsigned seed) {
  const auto noise = [seed](int u, int v) {
    auto h = static_cast<std::uint32_t>(u) * 73856093U ^ static_cast<std::uint32_t>(v) * 19349663U ^ seed * 83492791U;
    h = (h ^ h >> 13) * 0x5BD1E995U;
    return static_cast<int>((h ^ h >> 15) & 255U);
  };
  int sum = 0;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) sum += noise(x + i, y + j) * (2 - std::abs(i)) * (2 - std::abs(j));
  }
  return 20 + sum * 200 / (16 * 255);
}

/// Share of a state in a rectangle.
double share(const std::vector<std::uint8_t>& states, int width, int state, int x0, int y0, int x1, int y1) {
  int found = 0;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) found += states[static_cast<std::size_t>(y * width + x)] == state ? 1 : 0;
  }
  return static_cast<double>(found) / ((x1 - x0) * (y1 - y0));
}

}  // namespace

TEST_CASE("compete: the engine equals its stages beat by beat") {
  const int width = GENERATE(149, 96, 33);
  const int height = GENERATE(90, 16);
  const auto engine = std::make_unique<native::Pipeline<kPlain>>();
  const auto stages = std::make_unique<BeatByBeat>();
  std::mt19937 random(static_cast<unsigned>(width * 1000 + height));
  // Frames after each other: what a frame leaves behind must not show in the next.
  for (int frame = 0; frame < 3; ++frame) {
    CAPTURE(width, height, frame);
    const int shift = 3 * frame;
    native::CompeteSettings competition;
    competition.bias = frame;
    competition.smooth = 1 + frame;
    competition.quorum = 1 + 20 * frame;
    competition.clear_quorum = 1 + 25 * frame;
    competition.boundary = 15 - 7 * frame;
    const Picture left(width, height, [&](int x, int y) {
      if (y < height / 3) return static_cast<int>(random() & 255U);
      return y < 2 * height / 3 ? texture(x, y, 1) : texture(x, y, 1) / 16 + (x > 50 ? 120 : 60);
    });
    const Picture right(width, height, [&](int x, int y) {
      const int from = x + shift + (y % 20 < 10 ? 0 : 1) + (x > width / 2 ? 5 : 0);
      return from < width ? left.at(from, y) : texture(x, y, 2);
    });
    const auto found = engine_states(*engine, left, right, shift, competition);
    const auto expected = stages->frame(left, right, shift, competition, random);
    REQUIRE(found.size() == static_cast<std::size_t>(width * height));
    REQUIRE(expected.size() == found.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < found.size(); ++i) different += found[i] != expected[i] ? 1 : 0;
    CHECK(different == 0);
  }
}

TEST_CASE("compete: an object in the skin is found among others, to the image's border") {
  const auto engine = std::make_unique<native::Pipeline<kPlain>>();
  constexpr int kShift = 6;
  // Background 4 px behind the skin; in it a block on the skin that reaches the lower border, and one 3 px before it.
  const auto depth = [](int x, int y) {
    if (x >= 40 && x < 75 && y >= 45) return 0;
    if (x >= 95 && x < 130 && y >= 20 && y < 60) return 3;
    return -4;
  };
  const Picture left(149, 90, [](int x, int y) { return texture(x, y, 5); });
  Picture right = left;
  for (const int d : {-4, 0, 3}) {
    for (int y = 0; y < 90; ++y) {
      for (int x = 0; x < 149; ++x) {
        const int to = x - kShift - d;
        if (depth(x, y) == d && to >= 0 && to < 149) {
          right.pixels[static_cast<std::size_t>(y * 149 + to)] = static_cast<std::uint8_t>(left.at(x, y));
        }
      }
    }
  }
  const auto states = engine_states(*engine, left, right, kShift);
  CHECK(share(states, 149, state::skin, 44, 50, 71, 89) > 0.95);
  CHECK(share(states, 149, state::clear, 99, 24, 126, 56) > 0.95);
  CHECK(share(states, 149, state::clear, 10, 5, 148, 15) > 0.95);
  // No pixel of the right image, or none for the low-pass: never guessed.
  CHECK(share(states, 149, state::unsupervised, 0, 0, kShift + 1, 90) == 1);
  CHECK(share(states, 149, state::unsupervised, 0, 0, 149, 1) == 1);
  CHECK(share(states, 149, state::unsupervised, 0, 89, 149, 90) == 1);
  CHECK(share(states, 149, state::unsupervised, 148, 0, 149, 90) == 1);
  CHECK(share(states, 149, state::unsupervised, kShift + 1, 1, 148, 89) == 0);
}

TEST_CASE("compete: where nothing can be seen nothing is decided") {
  const auto engine = std::make_unique<native::Pipeline<kPlain>>();
  const Picture flat(149, 90, [](int, int) { return 100; });
  const auto states = engine_states(*engine, flat, flat, 6);
  CHECK(share(states, 149, state::undecidable, 7, 1, 148, 89) == 1);
  // Nor far from the only thing that can be seen.
  const Picture block(149, 90, [](int x, int y) { return x >= 100 && y < 20 ? texture(x, y, 3) : 20; });
  const auto around = engine_states(*engine, block, block, 0);
  CHECK(share(around, 149, state::skin, 104, 3, 148, 16) > 0.95);
  CHECK(share(around, 149, state::undecidable, 1, 65, 148, 89) == 1);
}

TEST_CASE("compete: plain squares of a board in the skin are never called clear for their noise") {
  const auto engine = std::make_unique<native::Pipeline<kPlain>>();
  std::mt19937 random(7);
  const auto board = [&](int shift, int noise) {
    return Picture(149, 90, [&](int x, int y) {
      const bool white = ((x + shift) / 24 + y / 22) % 2 == 0;
      return (white ? 180 : 50) + static_cast<int>(random() % static_cast<unsigned>(2 * noise + 1)) - noise;
    });
  };
  const int noise = GENERATE(1, 4, 8);
  CAPTURE(noise);
  const Picture left = board(0, noise);
  const auto in_skin = engine_states(*engine, left, board(0, noise), 0);
  CHECK(share(in_skin, 149, state::skin, 8, 8, 140, 82) > 0.6);
  CHECK(share(in_skin, 149, state::clear, 8, 8, 140, 82) < 0.01);
  const auto before = engine_states(*engine, left, board(8, noise), 0);
  CHECK(share(before, 149, state::skin, 20, 8, 125, 82) < 0.05);
}

template <hls::Profile P>
double undecidable_of_noise(double noise_grey) {
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0, noise_grey);
  const auto seen = [&] {
    return Picture(149, 90, [&](int, int) { return static_cast<int>(std::lround(120 + noise(random))); });
  };
  const Picture left = seen();
  const Picture right = seen();
  const auto states = engine_states(*std::make_unique<native::Pipeline<P>>(), left, right, 0);
  return share(states, 149, state::undecidable, 8, 8, 140, 82);
}

TEST_CASE("compete: noise of both cameras decides nothing, with many rows in the ballot or few") {
  constexpr auto kFewRows = [] {  // as in hd
    hls::Profile few = kPlain;
    few.ballot_reach = 5;
    few.paths = false;
    return few;
  }();
  for (const double noise_grey : {0.5, 1.0, 2.0, 3.0, 4.0}) {
    CAPTURE(noise_grey);
    CHECK(undecidable_of_noise<kPlain>(noise_grey) > 0.93);
    CHECK(undecidable_of_noise<kFewRows>(noise_grey) > 0.93);
  }
}

TEST_CASE("compete: what clear takes is in proportion to the rows that vote, and less without paths") {
  constexpr int kBeats = 16;
  const auto least_vote_of = [](auto ballot, int rows, int clear_quorum = 19) {
    typename decltype(ballot)::Config config;
    config.quorum = 10;
    config.clear_quorum = clear_quorum;
    for (int vote = 0; vote < 32; ++vote) {
      bool clear = false;
      for (int beat = 0; beat < kBeats * 2 * rows; ++beat) {
        typename decltype(ballot)::In in;
        in.vote = -vote;
        in.exists = true;
        in.marks = {beat == 0, beat % kBeats == kBeats - 1, true, false};
        clear = static_cast<bool>(ballot.step(in, config).clear);
      }
      if (clear) return vote;
    }
    return -1;
  };
  CHECK(least_vote_of(ColumnBallot<kBeats, 9, true>(), 19, 0) == 1);  // where nobody votes nothing is clear
  CHECK(least_vote_of(ColumnBallot<kBeats, 9, true>(), 19) == 8);     // 19 · 8 ≥ 8 · 19
  CHECK(least_vote_of(ColumnBallot<kBeats, 5, true>(), 11) == 8);     // 11 · 8 ≥ 4.5 · 19
  CHECK(least_vote_of(ColumnBallot<kBeats, 5, false>(), 11) == 6);    // 11 · 6 ≥ 3 · 19
  CHECK(least_vote_of(ColumnBallot<kBeats, 9, false>(), 19) == 6);    // 19 · 6 ≥ 5.5 · 19
}

TEST_CASE("compete: what repeats within reach is not in the skin; gain and offset do not matter") {
  const auto engine = std::make_unique<native::Pipeline<kPlain>>();
  const Picture stripes(149, 90, [](int x, int) { return x % 8 < 4 ? 60 : 180; });
  const auto repeated = engine_states(*engine, stripes, stripes, 0);
  CHECK(share(repeated, 149, state::skin, 10, 5, 140, 85) < 0.05);

  const Picture left(149, 90, [](int x, int y) { return texture(x, y, 9); });
  const Picture dark(149, 90, [&](int x, int y) { return left.at(x, y) / 2 + 40; });
  CHECK(share(engine_states(*engine, left, dark, 0), 149, state::skin, 10, 5, 140, 85) > 0.98);
  CHECK(share(engine_states(*engine, left, dark, 3), 149, state::clear, 20, 5, 140, 85) > 0.98);
}

TEST_CASE("compete: the boundary says what of a parallel plane 1 px away is in the skin") {
  const auto engine = std::make_unique<native::Pipeline<kPlain>>();
  const Picture left(149, 90, [](int x, int y) { return texture(x, y, 9); });
  const auto displaced = [&](int boundary, int px) {
    native::CompeteSettings competition;
    competition.boundary = boundary;
    return share(engine_states(*engine, left, left, px, competition), 149, state::skin, 20, 8, 130, 82);
  };
  for (const int side : {-1, 1}) {
    CAPTURE(side);
    CHECK(displaced(0, side) < 0.02);
    CHECK(displaced(5, side) < 0.1);
    CHECK(displaced(9, side) > 0.9);
    CHECK(displaced(14, side) > 0.98);
    CHECK(displaced(14, 2 * side) < 0.02);
  }
  CHECK(displaced(0, 0) > 0.98);
  CHECK(displaced(15, 1) == displaced(14, 1));
}

TEST_CASE("compete: what lies across the row costs, too, and edges are counted in the whole window") {
  constexpr int kBeats = 160;
  PlaneSummer<kBeats, planes_19, 7, 9> sums;
  Contrast<> pixel;
  pixel.left = pixel.right = 12;
  pixel.left_y = 10;
  pixel.right_y = -4;
  pixel.mask = true;
  int known = 0;
  for (int row = 0; row < 12; ++row) {
    for (int beat = 0; beat < kBeats; ++beat) {
      pixel.edge = beat % 2 == 0;
      pixel.marks = {row == 0 && beat == 0, beat + 1 == kBeats, true, false};
      const auto out = sums.step(pixel);
      if (row < 8 || beat < 100) continue;  // the window is full, and every plane has its partner
      known += out.known ? 1 : 0;
      for (const auto& sum : out.sum) REQUIRE(sum == 14 * 7 * 9);
      REQUIRE(out.evidence == 22 * 7 * 9);
      REQUIRE((out.edges == 4 * 7 || out.edges == 5 * 7));
    }
  }
  CHECK(known == 4 * 60);

  // 4 grey levels per pixel, 8 a grey level: clipped to ±31 along the row and ±15 across; an edge of the left image.
  GradientsAndGrey<> gradients;
  gradients.gx = {40, -31};
  gradients.gy = {-9, 40};
  pixel.set(gradients, gain_1);
  CHECK((pixel.left == 31 && pixel.right == -31 && pixel.left_y == -9 && pixel.right_y == 15 && pixel.edge));
  gradients.gx = {31, 62};
  pixel.set(gradients, gain_1 / 2);
  CHECK((pixel.left == 31 && pixel.right == 31 && pixel.right_y == 15 && !pixel.edge));
}
