// SPDX-License-Identifier: Apache-2.0
// Clear is earned: the stage `agreement` on scenes of known depth, on what is no scene, and with each check taken away.
#include <catch2/catch.hpp>
#include <numeric>

#include "agreement_scenes.hpp"

using namespace horopter::agreement_scenes;

TEST_CASE("a scene behind the skin is seen from the second frame on, and proven with the first round of places") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  const Picture right = seen(world, shifted(-GENERATE(0, 20, 45), 0), 3);
  auto config = defaults(320, 240);
  const auto stage = std::make_unique<Small>();
  const Answer first = frame(*stage, config, left, right);
  CHECK(first.verdicts == 1);
  CHECK(first.verdict.unproven_yet);
  CHECK(first.seen_share == 0);
  const Answer second = frame(*stage, config, left, right);
  CHECK(second.seen_share > 0.7);  // the right camera does not see all
  CHECK(second.nearer_share < 0.05);
  CHECK(10 * second.explained > 7 * second.textured);
  // Nothing is proven before a round at full resolution is complete.
  Answer answer = second;
  int frames = 2;
  for (; answer.verdict.unproven_yet && frames < kRound; ++frames) {
    CHECK(answer.places == 0);
    answer = frame(*stage, config, left, right);
  }
  CHECK(frames > 4);
  CHECK(faultless(answer.verdict));
  CHECK(answer.places >= 24);
  config.prove = 0;
  const Answer off = last_of(1, config, left, seen(scene(320, 240, 9), shifted(0, 0), 4));
  CHECK(off.seen_share == 1);
  CHECK(!off.verdict.disagree);
  CHECK(!off.verdict.unproven_yet);
}

TEST_CASE("cells that lie on the skin are said of the frame that shows them, if they are many") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  auto config = defaults(320, 240);
  const auto says = [&](const Picture& right, const Box& skin = {}) {
    return last_of(1, config, left, right, skin).verdict.overlooked;
  };
  const Picture on = seen(world, shifted(GENERATE(-0.5, 0.0, 0.5), 0), 3);
  const Picture half = seen(world, [](double x, double y) { return std::pair{x - (y < 120 ? 0 : 20), y}; }, 4);
  CHECK(says(on));
  CHECK(says(half));
  for (const double away_px : {-20.0, -3.0, 3.0}) CHECK_FALSE(says(seen(world, shifted(away_px, 0), 5)));
  const Box small{120, 100, 200, 180};  // 10×10 cells
  CHECK_FALSE(says(on, small));
  config.on_skin_cells = 0;
  CHECK(says(on, small));
  config.on_skin_limit = 20;  // of 32: half of the image is less
  CHECK(says(on));
  CHECK_FALSE(says(half));
  config.on_skin_limit = on_skin_limit_never;
  CHECK_FALSE(says(on));
  // The next frame ends it.
  config = defaults(320, 240);
  const auto stage = std::make_unique<Small>();
  CHECK(frame(*stage, config, left, on).verdict.overlooked);
  CHECK_FALSE(frame(*stage, config, left, seen(world, shifted(-20, 0), 6)).verdict.overlooked);
}

TEST_CASE("what stands in narrow strips of different depth is seen, too") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  const int far_px = GENERATE(24, 40, 72);
  constexpr int kStrip_px = 24;  // 3 cells: the large window, of 7, shows 0.63 to 0.72
  const Place place = [=](double x, double y) {
    return std::pair{x - (static_cast<int>(x) / kStrip_px % 2 == 0 ? 8 : far_px), y};
  };
  const Answer answer = last_of(2, defaults(320, 240), left, seen(world, place, 3));
  CHECK(answer.seen_share > 0.8);
  CHECK(answer.nearer_share < 0.05);
}

TEST_CASE("what both cameras cannot see together is not seen") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  const auto config = defaults(320, 240);
  Picture right{320, 240, std::vector<double>(320 * 240, 90)};
  const std::string what = GENERATE("covered", "another scene", "upside down", "half covered");
  CAPTURE(what);
  if (what == "covered") right = seen(right, shifted(0, 0), 3);
  if (what == "another scene") right = seen(scene(320, 240, 7), shifted(0, 0), 3);
  if (what == "upside down") right = seen(world, [](double x, double y) { return std::pair{x, 239 - y}; }, 3);
  if (what == "half covered") {
    const Picture good = seen(world, shifted(0, 0), 3);
    for (std::size_t i = 0; i < right.grey.size(); ++i) {
      if (i % 320 < 160) right.grey[i] = good.grey[i];
    }
  }
  const Answer answer = last_of(2, config, left, right);
  CHECK(answer.verdict.disagree);
  CHECK(answer.seen_share < (what == "half covered" ? 0.6 : 0.3));
}

namespace {

/// Of the lowest rows that have a result: the filters and their windows take those below.
double seen_of_lowest(int rows, const Answer& answer, const Small::Config& config) {
  const auto end = answer.seen_of_row.begin() + (config.compete != 0 ? 240 - 12 : 240 - 9);
  return std::accumulate(end - rows, end, 0.0) / rows;
}

}  // namespace

TEST_CASE("what is seen of the lowest rows is what both cameras see there") {
  Small::Config config = defaults(320, 240);
  config.compete = GENERATE(0, 1);
  const bool left_covered = GENERATE(false, true);
  const int covered_px = GENERATE(40, 48, 56, 80);
  CAPTURE(config.compete, left_covered, covered_px);
  const Picture world = scene(320, 240, 1);
  const Picture other = scene(320, 240, 9);
  const Picture left = seen(world, shifted(0, 0), 2);
  const Picture right = seen(world, shifted(-20, 0), 3);
  const auto covered = [&](Picture picture) {
    const auto from = static_cast<std::ptrdiff_t>((240 - covered_px) * 320);
    std::copy(other.grey.begin() + from, other.grey.end(), picture.grey.begin() + from);
    return picture;
  };
  const auto stage = std::make_unique<Small>();
  const auto mean_seen = [&](bool covers) {
    Answer answer;
    for (int i = 0; i < 3; ++i) {
      answer = frame(*stage, config, covers && left_covered ? covered(left) : left,
                     covers && !left_covered ? covered(right) : right);
    }
    return seen_of_lowest(24, answer, config);
  };
  CHECK(mean_seen(false) > 0.8);
  CHECK(mean_seen(true) < 0.5);
  CHECK(mean_seen(false) > 0.8);
}

TEST_CASE("where the lowest rows have nothing to tell by, the region above them decides") {
  Small::Config config = defaults(320, 240);
  config.compete = GENERATE(0, 1);
  const bool covers = GENERATE(false, true);
  CAPTURE(config.compete, covers);
  config.regions_limit = 255;  // what is looked at is no fault of the frame
  const Picture world = scene(320, 240, 1);
  const Picture other = scene(320, 240, 9);
  Picture left = seen(world, shifted(0, 0), 2);
  Picture right = seen(world, shifted(-20, 0), 3);
  constexpr int kCovered = 144, kFine = 176;  // rows, from there on
  if (covers) std::copy(other.grey.begin() + kCovered * 320, other.grey.end(), right.grey.begin() + kCovered * 320);
  std::mt19937 random(4);
  for (Picture* picture : {&left, &right}) {
    for (int y = kFine; y < 240; y += 8) {
      for (int x = 0; x < 320; x += 8) {
        const double mean = 100 + static_cast<double>(random() % 5) / 2;
        for (int i = 0; i < 64; ++i) {
          picture->grey[static_cast<std::size_t>((y + i / 8) * 320 + x + i % 8)] =
              mean + ((i / 8 + i) % 2 == 0 ? 6 : -6);
        }
      }
    }
  }
  const Answer answer = last_of(3, config, left, right);
  CHECK_FALSE(answer.verdict.disagree);
  CHECK((seen_of_lowest(12, answer, config) > 0.5) != covers);
}

TEST_CASE("too little in all, in too many regions, or around too many places: each says that the cameras disagree") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  Picture right = seen(world, shifted(0, 0), 3);
  for (std::size_t i = 0; i < right.grey.size(); ++i) {
    if (i % 320 < 192) right.grey[i] = 90;  // tape over 60 %
  }
  auto config = defaults(320, 240);
  const int explained = GENERATE(0, 107);
  const int regions = GENERATE(64, 255);
  const int unproven = GENERATE(115, 255);
  CAPTURE(explained, regions, unproven);
  config.explained_limit = explained;
  config.regions_limit = regions;
  config.unproven_limit = unproven;
  config.unproven_skin_limit = 255;
  CHECK(last_of(2, config, left, right).verdict.disagree == (explained > 0 || regions < 255 || unproven < 255));
}

TEST_CASE("a small skin that one camera does not see is no small fault") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  const Box skin{112, 64, 208, 160};  // an eighth of the image
  Picture right = seen(world, shifted(0, 0), 3);
  auto config = defaults(320, 240);
  CHECK(faultless(last_of(kRound, config, left, right, skin).verdict));
  constexpr int kMargin = 8;  // px around the skin: a cell is compared with its neighbours
  for (int y = skin.top - kMargin; y < skin.bottom + kMargin; ++y) {
    for (int x = skin.left - kMargin; x < skin.right + kMargin; ++x)
      right.grey[static_cast<std::size_t>(y * 320 + x)] = 90;
  }
  CHECK(last_of(2, config, left, right, skin).verdict.disagree);
  config.unproven_skin_limit = 255;
  CHECK(!last_of(2, config, left, right, skin).verdict.disagree);
}

TEST_CASE("noise without a scene is nothing to tell by") {
  const Picture grey{320, 240, std::vector<double>(320 * 240, 90)};
  const Answer answer = last_of(2, defaults(320, 240), seen(grey, shifted(0, 0), 2), seen(grey, shifted(0, 0), 3));
  CHECK(answer.verdict.untextured);
  CHECK(!answer.verdict.disagree);
  CHECK(answer.seen_share == 0);
}

TEST_CASE("a camera that is knocked, rolled or enlarged has moved") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  const std::string what = GENERATE("nothing", "knocked", "rolled", "enlarged");
  CAPTURE(what);
  Place place = shifted(-12, 0);
  if (what == "knocked") place = shifted(-12, 3);
  if (what == "rolled") {
    place = [](double x, double y) { return std::pair{x - 12 - 0.03 * (y - 120), y + 0.03 * (x - 160)}; };
  }
  if (what == "enlarged") {
    place = [](double x, double y) { return std::pair{x - 12 + 0.04 * (x - 160), y + 0.04 * (y - 120)}; };
  }
  auto config = defaults(320, 240);
  const Picture right = seen(world, place, 3);
  CHECK(last_of(2, config, left, right).verdict.moved == (what != "nothing"));
  config.moved_limit = config.moved_half_limit = config.patch_limit = 63;
  CHECK(!last_of(2, config, left, right).verdict.moved);
}

TEST_CASE("displacement along an epipolar line that is not a row is none") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  // 5 cells along the row, one down.
  const Picture right = seen(world, shifted(-40, -8), 3);
  auto config = defaults(320, 240);
  config.patch_limit = 63;
  CHECK(last_of(2, config, left, right).verdict.moved);
  config.patch_limit = hls::StageSettings{}.patch_limit;
  config.epipolar_slope = static_cast<int>(0.2 * 32768);
  CHECK(!last_of(2, config, left, right).verdict.moved);
  // At full resolution, too: also where the shift is no whole number of cells.
  config.moved_limit = config.moved_half_limit = 63;
  config.epipolar_slope = static_cast<int>(0.1 * 32768);
  for (const double shift_px : {-40.0, -43.0, 29.0}) {
    CAPTURE(shift_px);
    const Answer answer = last_of(20, config, left, seen(world, shifted(shift_px, 0.1 * shift_px), 3));
    CHECK(!answer.verdict.moved);
    CHECK(answer.places >= 24);
  }
  config.epipolar_slope = 0;
  CHECK(last_of(20, config, left, seen(world, shifted(-29, -2.9), 3)).verdict.moved);
}

TEST_CASE("displacement along an epipolar line that is curved is none") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  constexpr double kBend_per_px = 0.0008;
  constexpr double kShift_px = 80;
  const auto line = [](double x) { return kBend_per_px * (x - 160) * (x - 160) / 2; };
  const Picture right =
      seen(world, [&](double x, double y) { return std::pair{x - kShift_px, y - (line(x) - line(x - kShift_px))}; }, 3);
  auto config = defaults(320, 240);
  CHECK(last_of(2, config, left, right).verdict.moved);
  // A code stands two cells right of and below the cell it is of.
  config.epipolar_slope = static_cast<int>(-kBend_per_px * (160 + 1.5 * Small::cell) * 32768);
  config.epipolar_column = static_cast<int>(kBend_per_px * Small::cell * 1048576);
  CHECK(!last_of(2, config, left, right).verdict.moved);
}

TEST_CASE("a camera out of focus, or in fog, is unsharp") {
  const Picture world = scene(320, 240, 1);
  const Picture good = seen(world, shifted(0, 0), 2);
  const Picture blur = blurred(seen(world, shifted(0, 0), 3), 5);
  const auto config = defaults(320, 240);
  CHECK(last_of(2, config, good, blur).verdict.unsharp_right);
  CHECK(!last_of(2, config, good, blur).verdict.unsharp_left);
  CHECK(last_of(2, config, blur, good).verdict.unsharp_left);
  Picture fog = good;
  for (double& grey : fog.grey) grey = 120 + (grey - 120) / 8;
  CHECK(last_of(2, config, good, fog).verdict.unsharp_right);
  // Tape over the larger part of the left camera: what is left agrees, but the right one sees more.
  Picture taped = good;
  for (int y = 0; y < taped.height; ++y) {
    for (int x = 0; x < taped.width * 6 / 10; ++x) taped.grey[static_cast<std::size_t>(y * taped.width + x)] = 100;
  }
  CHECK(last_of(2, config, taped, good).verdict.unsharp_left);
  Picture dim = good;
  for (double& grey : dim.grey) grey /= 2;
  CHECK(faultless(last_of(kRound, config, good, dim).verdict));
}

TEST_CASE("one camera a frame late is out of step from the first motion on, until one begins in both at once") {
  const Picture world = scene(320, 240, 1);
  const Picture plate = scene(320, 240, 7);
  constexpr double kBehind_px = 20;
  unsigned noise = 2;
  double gain = 1;
  // The plate has come to `moved_px`, and is not there where that is not given.
  const auto view = [&](double parallax_px, std::optional<double> moved_px) {
    Picture picture = world;
    for (int y = 0; y < 240; ++y) {
      for (int x = 0; x < 320; ++x) {
        const double at_px = moved_px ? x + parallax_px - *moved_px : -1;
        const bool on_plate = at_px >= 90 && at_px < 190 && y >= 70 && y < 180;
        picture.grey[static_cast<std::size_t>(y * 320 + x)] =
            gain * (on_plate ? plate.at(at_px, y) : world.at(x + parallax_px, y));
      }
    }
    return seen(picture, shifted(0, 0), ++noise);
  };
  const auto config = defaults(320, 240);
  const auto stage = std::make_unique<Small>();
  double right_gain = 1;
  const auto says = [&](std::optional<double> left_px, std::optional<double> right_px) {
    const Picture left = view(0, left_px);
    gain = right_gain;
    const Picture right = view(-kBehind_px, right_px);
    gain = 1;
    return frame(*stage, config, left, right).verdict.out_of_step;
  };
  const double way_px = GENERATE(-9, 6, 14);
  CAPTURE(way_px);
  // In step: still, moving, still.
  for (const int at : {0, 0, 1, 2, 3, 3}) CHECK_FALSE(says(at * way_px, at * way_px));
  // A camera that sets its own gain; what comes into one view first.
  right_gain = 0.5;
  for (int i = 0; i < 2; ++i) CHECK_FALSE(says(0, 0));
  CHECK_FALSE(says(std::nullopt, std::nullopt));
  CHECK_FALSE(says(0, std::nullopt));
  CHECK_FALSE(says(0, 0));
  right_gain = 1;
  for (int i = 0; i < 2; ++i) CHECK_FALSE(says(0, 0));
  SECTION("the right one is late") {
    for (const int at : {1, 2, 3, 3, 3}) CHECK(says(at * way_px, std::max(0, at - 1) * way_px));
    for (int i = 0; i < 3; ++i) CHECK(says(3 * way_px, 3 * way_px));
    CHECK_FALSE(says(4 * way_px, 4 * way_px));
  }
  SECTION("the left one is") {
    for (const int at : {1, 2, 3}) CHECK(says((at - 1) * way_px, at * way_px));
    CHECK(says(3 * way_px, 3 * way_px));
    for (int i = 0; i < 2; ++i) CHECK(says(std::nullopt, std::nullopt));
    CHECK(says(3 * way_px, std::nullopt));  // comes into one view first: no beginning in both
    CHECK(says(4 * way_px, 3 * way_px));
  }
  SECTION("another skin: the right image is another one") {
    auto other = config;
    other.same_table = 0;
    CHECK_FALSE(frame(*stage, other, view(0, 0), view(-kBehind_px, way_px)).verdict.out_of_step);
    CHECK_FALSE(says(0, way_px));
    CHECK(says(0, 2 * way_px));
  }
  SECTION("the right camera is turned about its vertical axis") {
    for (int i = 0; i < 2; ++i)
      CHECK(frame(*stage, config, view(0, 0), view(way_px - kBehind_px, 0)).verdict.out_of_step);
  }
  SECTION("not asked") {
    auto off = config;
    off.prove = 0;
    CHECK(says(way_px, 0));
    CHECK_FALSE(frame(*stage, off, view(0, way_px), view(-kBehind_px, 0)).verdict.out_of_step);
    CHECK_FALSE(says(way_px, 0));
  }
}

TEST_CASE("something nearer than the skin hides it, and for too long is a fault") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  const Picture right = seen(world, shifted(30, 0), 3);
  auto config = defaults(320, 240);
  const auto stage = std::make_unique<Small>();
  CHECK(!frame(*stage, config, left, right).verdict.hidden);
  const Answer second = frame(*stage, config, left, right);
  CHECK(second.nearer_share > 0.7);
  CHECK(!second.verdict.hidden);
  CHECK(frame(*stage, config, left, right).verdict.hidden);
  CHECK(!frame(*stage, config, left, left).verdict.hidden);
  config.nearer_below = 0;
  const Answer unknown = last_of(4, config, left, right);
  CHECK(!unknown.verdict.hidden);
  CHECK(unknown.nearer_share == 0);
  // Where no place is in front of both cameras, nothing is explained: cameras exchanged.
  config.shift_lowest = -1;
  CHECK(last_of(2, config, left, right).verdict.disagree);
}

TEST_CASE("the map of one skin says nothing of another: one that lies behind all is hidden in its first frame") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  const Picture behind = seen(world, shifted(-20, 0), 3);  // behind the one skin, before the other one
  const Picture nearer = seen(world, shifted(20, 0), 3);
  auto config = defaults(320, 240);
  config.hidden_frames = 5;
  const auto stage = std::make_unique<Small>();
  for (int i = 0; i < kRound; ++i) frame(*stage, config, left, behind);
  SECTION("at once") {
    REQUIRE(faultless(frame(*stage, config, left, behind).verdict));
    config.same_table = 0;
    CHECK(frame(*stage, config, left, nearer).verdict.hidden);
    config.same_table = 1;
    CHECK_FALSE(frame(*stage, config, left, nearer).verdict.hidden);  // its own map says it of its pixels
    // Back before all.
    config.same_table = 0;
    CHECK_FALSE(frame(*stage, config, left, behind).verdict.hidden);
  }
  SECTION("half of it, with tables in turn: not at once, but after HIDDEN such frames, or some more") {
    Picture half = behind;
    for (std::size_t i = 0; i < half.grey.size(); ++i) {
      if (i / 320 < 120) half.grey[i] = nearer.grey[i];
    }
    config.same_table = 0;
    int frames = 0;
    bool hidden = false;
    for (; frames < 40 && !hidden; ++frames) {
      CHECK_FALSE(frame(*stage, config, left, behind).verdict.hidden);
      hidden = frame(*stage, config, left, half).verdict.hidden;
    }
    CHECK(frames == 9);  // each pair makes half a frame
    for (int i = 0; i < 2; ++i) CHECK_FALSE(frame(*stage, config, left, behind).verdict.hidden);
  }
  SECTION("the largest number of frames") {
    config.hidden_frames = 255;
    for (int i = 1; i < 300; ++i) CHECK(frame(*stage, config, left, nearer).verdict.hidden == (i >= 255));
  }
}

TEST_CASE("around a small skin cameras are compared, but what is hidden counts where the skin is") {
  const Picture world = scene(320, 240, 1);
  const Picture left = seen(world, shifted(0, 0), 2);
  const Picture nearer = seen(world, shifted(30, 0), 3);
  const auto config = defaults(320, 240);
  const Box skin{120, 64, 200, 112};
  const Answer same = last_of(kRound, config, left, seen(world, shifted(-12, 0), 3), skin);
  CHECK(faultless(same.verdict));
  const Answer near_everywhere = last_of(4, config, left, nearer, skin);
  CHECK(near_everywhere.verdict.hidden);
  CHECK(near_everywhere.nearer > 40);
  CHECK(near_everywhere.nearer <= 60);  // cells of the skin
  Picture beside = seen(world, shifted(0, 0), 3);
  for (std::size_t i = 0; i < beside.grey.size(); ++i) {
    if (i / 320 >= 136) beside.grey[i] = nearer.grey[i];
  }
  const Answer near_beside = last_of(kRound, config, left, beside, skin);
  CHECK(faultless(near_beside.verdict));
  CHECK(near_beside.nearer_share > 0.1);
  CHECK(near_beside.nearer == 0);
  CHECK(last_of(2, config, left, seen({320, 240, std::vector<double>(320 * 240, 90)}, shifted(0, 0), 3), skin)
            .verdict.disagree);
}

TEST_CASE("every size ends with one verdict, before the next frame") {
  std::mt19937 random(5);
  for (int width = 32; width <= 320; width += 2) {
    const int height = 16 + static_cast<int>(random() % 60);
    CAPTURE(width, height);
    const Picture noise = scene(width, height, random());
    const auto stage = std::make_unique<Small>();
    for (int i = 0; i < 2; ++i) REQUIRE(frame(*stage, defaults(width, height), noise, noise).verdicts == 1);
  }
}

namespace {

/// Verdicts of a frame and of the rows behind it.
template <hls::Profile P>
int verdicts(int width, int height) {
  using Stage = Agreement<P>;
  const auto stage = std::make_unique<Stage>();
  typename Stage::Config config{};
  config.width = width;
  config.height = height;
  config.prove = 1;
  constexpr int kBeats = P.packed() ? 2 : 1;  // of a pixel
  int count = 0;
  for (int y = 0; y < height + P.flush_rows(); ++y) {
    for (int x = 0; x < kBeats * width; ++x) {
      typename Stage::In in;
      in.present = in.mask = y < height;
      in.pixel.fill(u<8>(x * 41 + y * 29));
      in.marks = {x == 0 && y == 0, x + 1 == kBeats * width};
      count += stage->step(in, config).verdict.valid;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("so it does where two beats share the sums") {
  const int cells = GENERATE(0, 1, 2, 3, 6, 14, 30);  // beyond the smallest width
  const int height = GENERATE(32, 40);
  CAPTURE(cells, height);
  CHECK(verdicts<hls::profiles::field>(32 + 8 * cells, height) == 1);
  CHECK(verdicts<hls::profiles::hd>(32 + 16 * cells, height) == 1);
}
