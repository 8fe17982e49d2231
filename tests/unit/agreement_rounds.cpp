// SPDX-License-Identifier: Apache-2.0
// Rounds of places at full resolution, many frames of the stage `agreement`: as the native engine compares, a row at once.
#include <catch2/catch.hpp>

#include "agreement_scenes.hpp"

static_assert(horopter::stages::agreement_at_once);
using namespace horopter::agreement_scenes;

TEST_CASE("places that lie on the skin are said of each round in which no frame has shown an alarm") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  const Picture on = seen(world, shifted(GENERATE(-1, 1), 0), 3);
  const Picture behind = seen(world, shifted(-20, 0), 4);
  const Place half_place = [](double x, double y) { return std::pair{x - (y < 120 ? 0 : 20), y}; };
  const Picture half = seen(world, half_place, 5);
  auto config = defaults(320, 240);
  config.on_skin_cells = 255;  // more than there are
  const auto stage = std::make_unique<Small>();
  const auto says = [&](const Picture& right) { return frame(*stage, config, left, right).verdict.overlooked; };
  constexpr int kLong = 60;  // frames of two rounds
  const auto frames_until = [&](bool so, const Picture& right) {
    int frames = 1;
    while (says(right) != so && frames < kLong) ++frames;
    return frames;
  };
  CHECK(frames_until(true, on) < kRound);
  CHECK(frames_until(false, behind) < kLong);
  CHECK(frames_until(true, behind) == kLong);
  CHECK(frames_until(true, half) < kLong);
  // A frame with an alarm, and the rest of its round.
  config.alarm_before = 1;
  CHECK_FALSE(says(on));
  config.alarm_before = 0;
  CHECK_FALSE(says(on));
  CHECK(frames_until(true, on) < kLong);
  config.alarm_before = 1;
  CHECK(frames_until(true, on) == kLong);
  config.alarm_before = 0;
  config.on_skin_limit = on_skin_limit_never;
  CHECK(frames_until(true, on) == kLong);
  config.on_skin_limit = 24;                    // of 32: half of the image is less
  for (int i = 0; i < kRound; ++i) says(half);  // the round that was begun before
  CHECK(frames_until(false, half) < kLong);
  CHECK(frames_until(true, half) == kLong);
  CHECK(frames_until(true, on) < kLong);
}

TEST_CASE("at full resolution a camera that was moved by little is found, and one that was not is none") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  const auto turned = [](double along, double across) {
    return [=](double x, double y) {
      return std::pair{x - 19.3 - across * (y - 120) + along * (x - 160), y + across * (x - 160) + along * (y - 120)};
    };
  };
  struct Case {
    const char* what;
    bool moved;
    double across_px;
    Place place;
  };
  const std::vector<Case> cases{{"nothing", false, 0, shifted(-19.3, 0)},
                                {"half a pixel", false, 0.5, shifted(-19.3, -0.5)},
                                {"knocked down", true, 1.5, shifted(-19.3, -1.5)},
                                {"knocked up", true, -1.5, shifted(-19.3, 1.5)},
                                {"rolled", true, 0, turned(0, 0.0262)},
                                {"enlarged", true, 0, turned(0.0385, 0)},
                                {"reduced", true, 0, turned(-0.0385, 0)}};
  auto config = defaults(320, 240);
  config.moved_limit = config.moved_half_limit = 63;  // of cells, at once
  for (const double gain : {1.0, 0.6}) {
    for (const Case& of : cases) {
      CAPTURE(of.what, gain);
      Picture right = seen(world, of.place, 3);
      for (double& grey : right.grey) grey = gain * grey + 20;
      const Answer answer = last_of(2 * kRound, config, left, right);
      CHECK(answer.verdict.moved == of.moved);
      CHECK(answer.places >= 24);
      if (of.across_px != 0 || !of.moved) CHECK(answer.across_px == Approx(of.across_px).margin(0.15));
    }
  }
  // The left half alone: a pattern that repeats can do that, no camera. All of it in one round: not yet, and not proven.
  const Place left_half = [](double x, double y) { return std::pair{x - 19.3, x < 160 ? y + 2 : y}; };
  CHECK_FALSE(last_of(2 * kRound, config, left, seen(world, left_half, 3)).verdict.moved);
  {
    const auto stage = std::make_unique<Small>();
    const Picture knocked = seen(world, shifted(-19.3, -1.5), 3);
    Answer answer;
    while (answer.places == 0) answer = frame(*stage, config, left, knocked);
    CHECK_FALSE(answer.verdict.moved);
    CHECK(answer.verdict.unproven_yet);
  }
  // What is said stays until the next round: here none is complete, as nothing is explained.
  const auto stage = std::make_unique<Small>();
  const Picture knocked = seen(world, shifted(-19.3, -1.5), 3);
  Answer answer;
  for (int i = 0; i < 2 * kRound; ++i) answer = frame(*stage, config, left, knocked);
  CHECK(answer.verdict.moved);
  const Picture other = scene(320, 240, 77);
  for (int i = 0; i < 3; ++i) answer = frame(*stage, config, left, other);
  CHECK(answer.verdict.moved);
  const Picture back = seen(world, shifted(-19.3, 0), 3);
  for (int i = 0; i < 20; ++i) answer = frame(*stage, config, left, back);
  CHECK_FALSE(answer.verdict.moved);
}

TEST_CASE("a roll of which less than half of the places show it is never taken for good cameras") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  const double across = GENERATE(0.0113, -0.0113);  // beyond the limit: 72 of 160 columns to each side
  CAPTURE(across);
  const Place rolled = [=](double x, double y) {
    return std::pair{x - 19.3 - across * (y - 120), y + across * (x - 160)};
  };
  auto config = defaults(320, 240);
  config.moved_limit = config.moved_half_limit = 63;  // of cells, at once
  const Picture right = seen(world, rolled, 3);
  const auto stage = std::make_unique<Small>();
  int undecided = 0;
  for (int i = 0; i < 6 * kRound; ++i) {
    const Answer answer = frame(*stage, config, left, right);
    CHECK((answer.verdict.moved || answer.verdict.unproven_yet));
    undecided += answer.places > 0 && answer.displaced == 0;
  }
  CHECK(undecided > 0);
}

TEST_CASE("a machine that starts again votes with no place of the run before") {
  // A memory outlives the reset. The image before was wider, and its cameras had been moved.
  const Picture before = scene(320, 240, 5);
  const Picture world = scene(256, 200, 1);
  const auto stage = std::make_unique<Small>(), fresh = std::make_unique<Small>();
  for (int i = 0; i < kRound; ++i) {
    frame(*stage, defaults(320, 240), seen(before, shifted(0, 0), 2), seen(before, shifted(-19.3, -1.5), 3));
  }
  hls::reset(*stage);
  const Picture left = seen(world, shifted(0, 0), 2), right = seen(world, shifted(-19.3, 0), 3);
  for (int i = 0; i < kRound; ++i) {
    CAPTURE(i);
    const Answer again = frame(*stage, defaults(256, 200), left, right);
    const Answer first = frame(*fresh, defaults(256, 200), left, right);
    CHECK(again.places == first.places);
    CHECK(again.across_px == first.across_px);
    CHECK(again.verdict.unproven_yet == first.verdict.unproven_yet);
  }
}

TEST_CASE("after a round that is not clear it takes two clear ones") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  const Picture good = seen(world, shifted(-19.3, 0), 3);
  const Picture knocked = seen(world, shifted(-19.3, -1.5), 3);
  auto config = defaults(320, 240);
  config.moved_limit = config.moved_half_limit = 63;  // of cells, at once
  const bool moved = GENERATE(false, true);           // else only one round says so
  CAPTURE(moved);
  const auto stage = std::make_unique<Small>();
  Answer answer;
  while (answer.displaced == 0 || answer.verdict.moved != moved) answer = frame(*stage, config, left, knocked);
  CHECK(answer.verdict.unproven_yet != moved);
  const auto said = [&] { return moved ? answer.verdict.moved : answer.verdict.unproven_yet; };
  int frames = 0;
  for (; answer.displaced != 0; ++frames) answer = frame(*stage, config, left, good);
  CHECK(said());
  CHECK(frames < kRound);
  for (frames = 0; said() && frames < 2 * kRound; ++frames) answer = frame(*stage, config, left, good);
  CHECK(frames > 2);
  CHECK(faultless(answer.verdict));
}

TEST_CASE("what is known of moved cameras is forgotten when no round comes any more") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  const Picture right = seen(world, shifted(-19.3, 0), 3);
  const Picture covered{320, 240, std::vector<double>(320 * 240, 90)};  // no place is compared
  const auto config = defaults(320, 240);
  const auto stage = std::make_unique<Small>();
  Answer answer;
  do {
    answer = frame(*stage, config, left, right);
  } while (answer.verdict.unproven_yet);
  CHECK(answer.places > 0);
  for (int i = 1; i < patch_known_frames; ++i) {
    answer = frame(*stage, config, left, covered);
    CHECK_FALSE(answer.verdict.unproven_yet);
  }
  CHECK(frame(*stage, config, left, covered).verdict.unproven_yet);
  for (int i = 0; i < kRound; ++i) answer = frame(*stage, config, left, right);
  CHECK(faultless(answer.verdict));
}
