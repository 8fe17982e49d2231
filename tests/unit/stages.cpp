// SPDX-License-Identifier: Apache-2.0
// Every stage against the reference or against plain counting, with its stated error bound.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <vector>

#include "raster.hpp"
#include "reference/reference.hpp"
#include "stages/alarm.hpp"
#include "stages/cells.hpp"
#include "stages/coarse.hpp"
#include "stages/dsad.hpp"
#include "stages/health.hpp"
#include "stages/interpolate.hpp"
#include "stages/lowpass.hpp"
#include "stages/map_expand.hpp"
#include "stages/runs.hpp"
#include "stages/still.hpp"
#include "stages/subsample.hpp"

using namespace horopter::stages;
using namespace horopter::tests;
namespace reference = horopter::tb::reference;

namespace {

Frame<GreyPair> random_greys(std::mt19937& random, int width, int height, unsigned holes) {
  Frame<GreyPair> frame(width, height);
  for (GreyPair& beat : frame.beats) {
    beat.pixel = {u<8>(random()), u<8>(random())};
    beat.saturated = !one_in(random, 6);
    beat.mask = !one_in(random, holes);
    beat.present = beat.mask || one_in(random, 2);
  }
  return frame;
}

template <int W, bool COMPACT>
void check_map_expand(std::mt19937& random, int spacing_x_log2, int spacing_y_log2) {
  const int width = 61;
  const int height = 9;
  const int sx = 1 << spacing_x_log2;
  const int sy = 1 << spacing_y_log2;
  std::map<std::pair<int, int>, ControlPoint> points;
  const auto control = [&](int column, int row) {
    auto& point = points[{column, row}];
    if (point.x == 0 && point.y == 0) {
      point = {u<16>(random() | 1U), u<16>(random() | 1U), !one_in(random, 6), one_in(random, 2)};
      point.of_skin = point.of_skin && point.exists;
      if (one_in(random, 4)) point.x = u<16>(64 * 32 - 20 + random() % 40);  // around 0 px
    }
    return point;
  };
  const auto grid = [&](int column, int row) -> std::optional<reference::Point> {
    const ControlPoint p = control(column, row);
    if (!p.exists) return std::nullopt;
    return reference::Point{p.x.value() / 32.0 - 64, p.y.value() / 32.0 - 64};
  };
  const auto of_skin = [&](int column, int row) {
    return control(column, row).of_skin ? grid(column, row) : std::nullopt;
  };

  MapExpander<W, COMPACT> stage;
  typename MapExpander<W, COMPACT>::Config config;
  config.spacing_x_log2 = spacing_x_log2;
  const double scale = 1 << W;
  for (int y = 0; y < height; ++y) {
    typename MapExpander<W, COMPACT>::In in;
    in.row_fraction = (y % sy) * 64 / sy;
    const bool swapped = one_in(random, 2);
    const auto column = [&](int j) {
      const ControlPoint above = control(j, y / sy);
      const ControlPoint below = control(j, y / sy + 1);
      return swapped ? ControlPair{below, above, true} : ControlPair{above, below, false};
    };
    in.prime = true;
    in.column = column(0);
    REQUIRE(!stage.step(in, config).valid);
    in.prime = false;
    for (int x = 0; x < width; ++x) {
      in.load = x % sx == 0;
      if (in.load) in.column = column(x / sx + 1);
      in.marks.first = one_in(random, 2);
      in.marks.live = one_in(random, 2);
      in.outside = one_in(random, 4);
      const auto out = stage.step(in, config);
      CAPTURE(x, y, sx, sy);
      REQUIRE(out.valid);
      REQUIRE(out.marks.first == in.marks.first);
      REQUIRE(out.marks.live == in.marks.live);
      const auto exact = reference::expand(grid, sx, sy, x, y);
      const double ex = exact ? std::floor(exact->x * scale + 0.5) / scale : -1;  // half up, exact in a double
      const double ey = exact ? std::floor(exact->y * scale + 0.5) / scale : -1;
      REQUIRE(out.present == (exact && ex >= 0 && ey >= 0));
      REQUIRE(out.mapped == (out.present && !in.outside && reference::expand(of_skin, sx, sy, x, y)));
      if (!out.present) continue;
      REQUIRE(out.x.value() + out.wx.value() / scale == ex);
      REQUIRE(out.y.value() + out.wy.value() / scale == ey);
    }
  }
}

}  // namespace

TEST_CASE("map_expand is the exact bilinear interpolation, rounded half up once", "[stages]") {
  std::mt19937 random(11);
  for (int sx = 0; sx <= 6; ++sx) {
    for (int sy = 0; sy <= 6; sy += 2) {
      check_map_expand<3, false>(random, sx, sy);
      check_map_expand<5, false>(random, sx, sy);
      check_map_expand<3, true>(random, sx, sy);
    }
  }
}

TEST_CASE("interpolate: at most half a grey level from eq. 10.1", "[stages]") {
  std::mt19937 random(12);
  Interpolator<3> stage;
  Interpolator<4> finer;
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    reference::Image image(2, 2);
    for (double& v : image.values) v = one_in(random, 8) ? (one_in(random, 2) ? 0 : 255) : random() % 256;
    const auto check = [&](auto& under_test, int weights) {
      typename std::remove_reference_t<decltype(under_test)>::In in;
      in.swapped_x = one_in(random, 2);
      in.swapped_y = one_in(random, 2);
      const std::size_t first = (in.swapped_x ? 1 : 0) + (in.swapped_y ? 2 : 0);
      in.p00 = static_cast<int>(image.values[first]);
      in.p01 = static_cast<int>(image.values[first ^ 1]);
      in.p10 = static_cast<int>(image.values[first ^ 2]);
      in.p11 = static_cast<int>(image.values[first ^ 3]);
      in.wx = random();
      in.wy = random();
      in.left = random();
      in.mask = one_in(random, 2);
      in.present = one_in(random, 2);
      const GreyPair out = under_test.step(in);
      const reference::Point p{in.wx.value() / double(weights), in.wy.value() / double(weights)};
      worst = std::max(worst, std::fabs(out.pixel[1].value() - reference::bilinear(image, p)));
      REQUIRE(out.pixel[0] == in.left);
      REQUIRE(out.mask == in.mask);
      REQUIRE(out.present == in.present);
      bool saturated = in.left == 0 || in.left == 255;
      for (int j = 0; j < 2; ++j) {
        for (int k = 0; k < 2; ++k) {
          const bool used = (k == 0 || in.wx != 0) && (j == 0 || in.wy != 0);
          const double v = image.at(k, j);
          saturated = saturated || (used && (v == 0 || v == 255));
        }
      }
      REQUIRE(out.saturated == saturated);
    };
    check(stage, 8);
    check(finer, 16);
  }
  REQUIRE(worst <= 0.5);
}

TEST_CASE("subsample: the mean of pairs, at most half a grey level up; the left image's as it comes", "[stages]") {
  std::mt19937 random(13);
  const Frame<GreyPair> frame = random_greys(random, 40, 6, 5);
  Subsampler<2> stage;
  std::size_t i = 0;
  for (const GreyPair& beat : frame.beats) {
    const auto out = stage.step(beat);
    REQUIRE(out.valid == (i % 2 == 1));
    if (out.valid) {
      const GreyPair& even = frame.beats[i - 1];
      const double mean = (even.pixel[1].value() + beat.pixel[1].value()) / 2.0;
      REQUIRE(out.pixel[1].value() >= mean);
      REQUIRE(out.pixel[1].value() <= mean + 0.5);
      REQUIRE(out.pixel[0] == beat.pixel[0]);
      REQUIRE(out.mask == (even.mask && beat.mask));
      REQUIRE(out.present == (even.present && beat.present));
      REQUIRE(out.saturated == (even.saturated || beat.saturated));
      REQUIRE(out.marks.first == (i == 1));
      REQUIRE(out.marks.last == ((i + 1) % 40 == 0));
    }
    ++i;
  }

  Subsampler<1> through;
  for (const GreyPair& beat : frame.beats) {
    const auto out = through.step(beat);
    REQUIRE((out.valid && out.pixel[1] == beat.pixel[1] && out.mask == beat.mask && out.present == beat.present &&
             out.marks.last == beat.marks.last));
  }
}

TEST_CASE("subsample packs the same means into one stream, the left image's first", "[stages]") {
  std::mt19937 random(14);
  const Frame<GreyPair> frame = random_greys(random, 20, 6, 30);
  Subsampler<2> plain;
  PackingSubsampler packing;
  std::vector<Subsampler<2>::Out> pairs;
  std::vector<PackingSubsampler::Out> packed;
  for (const auto& beat : frame.beats) {
    if (const auto out = plain.step(beat); out.valid) pairs.push_back(out);
    if (const auto out = packing.step(beat); out.valid) packed.push_back(out);
  }
  REQUIRE(packed.size() == 2 * pairs.size() - 1);  // the last one comes with the next beat
  for (std::size_t i = 0; i < packed.size(); ++i) {
    const auto& pair = pairs[i / 2];
    CAPTURE(i);
    REQUIRE(packed[i].pixel[0] == pair.pixel[i % 2]);
    REQUIRE(packed[i].mask == pair.mask);
    REQUIRE(packed[i].present == pair.present);
    REQUIRE(packed[i].saturated == pair.saturated);
    REQUIRE(packed[i].marks.first == (i % 2 == 0 && pair.marks.first));
    REQUIRE(packed[i].marks.last == (i % 2 == 1 && pair.marks.last));
  }

  // A frame that starts in the middle of a pair drops the pair; a row with an odd number of beats its last pixel.
  PackingSubsampler stage;
  const auto step = [&](int grey, bool first, bool last) {
    return stage.step({{u<8>(grey), u<8>(grey + 100)}, false, true, true, {first, last}});
  };
  CHECK_FALSE(step(10, true, false).valid);
  CHECK_FALSE(step(20, true, false).valid);
  CHECK(step(22, false, false).pixel[0] == 22);
  const auto right = step(30, false, true);
  CHECK((right.valid && right.pixel[0] == 121 && right.marks.last));
  CHECK_FALSE(step(40, false, false).valid);
  CHECK(step(42, false, false).pixel[0] == 42);
}

/// As `agreement` hands them on.
Frame<Grey<2>> marked(const Frame<GreyPair>& frame) {
  Frame<Grey<2>> result(frame.width, frame.height);
  for (std::size_t i = 0; i < frame.beats.size(); ++i) {
    result.beats[i].pixel = frame.beats[i].pixel;
    result.beats[i].saturated = frame.beats[i].saturated;
    result.beats[i].mask = frame.beats[i].mask;
  }
  return result;
}

TEST_CASE("lowpass and sobel against the reference, mask and saturation over their windows", "[stages]") {
  std::mt19937 random(14);
  LowpassFilter<48> lowpass;
  SobelFilter<48> sobel;
  SobelFilter<48, 2, 1, Scalar, true> slopes;
  for (int repetition = 0; repetition < 4; ++repetition) {
    const Frame<GreyPair> frame = random_greys(random, repetition % 2 == 0 ? 48 : 37, 14, 40);
    const auto smooth = pass(lowpass, marked(frame));
    const auto gradients = pass(sobel, marked(frame));
    const auto with_grey = pass(slopes, marked(frame));
    for (std::size_t lane = 0; lane < 2; ++lane) {
      reference::Image image(frame.width, frame.height);
      for (std::size_t i = 0; i < frame.beats.size(); ++i) {
        image.values[i] = frame.beats[i].mask ? frame.beats[i].pixel[lane].value() : reference::kMissing;
      }
      const reference::Image exact = reference::lowpass(image);
      const reference::Gradient gradient = reference::sobel(image);
      for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
          CAPTURE(x, y, lane);
          const double value = exact.at(x - 1, y - 1);
          REQUIRE(smooth.at(x, y).mask == !std::isnan(value));
          REQUIRE(gradients.at(x, y).mask == smooth.at(x, y).mask);
          const bool saturated = window_all(frame, x, y, 3, [](const GreyPair& beat) { return beat.saturated; });
          REQUIRE(smooth.at(x, y).saturated == saturated);
          REQUIRE(gradients.at(x, y).saturated == saturated);
          REQUIRE(with_grey.at(x, y).mask == smooth.at(x, y).mask);
          REQUIRE(with_grey.at(x, y).saturated == saturated);
          if (std::isnan(value)) continue;
          REQUIRE(std::fabs(smooth.at(x, y).pixel[lane].value() - value) <= 0.5);
          REQUIRE(gradients.at(x, y).gx[lane].value() == gradient.x.at(x - 1, y - 1));
          REQUIRE(gradients.at(x, y).gy[lane].value() == gradient.y.at(x - 1, y - 1));
          REQUIRE(with_grey.at(x, y).gx[lane] == gradients.at(x, y).gx[lane]);
          REQUIRE(with_grey.at(x, y).gy[lane] == gradients.at(x, y).gy[lane]);
          REQUIRE(with_grey.at(x, y).grey == smooth.at(x, y).pixel[0]);
        }
      }
    }
  }
}

TEST_CASE("two images packed into one stream give what two streams give", "[stages]") {
  std::mt19937 random(15);
  const Frame<GreyPair> frame = random_greys(random, 24, 12, 30);
  Frame<Grey<1>> packed(48, 12);
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 48; ++x) {
      const GreyPair& pair = frame.at(x / 2, y);
      packed.at(x, y).pixel[0] = pair.pixel[static_cast<std::size_t>(x % 2)];
      packed.at(x, y).mask = pair.mask;
      packed.at(x, y).saturated = pair.saturated;
    }
  }
  LowpassFilter<24> lowpass;
  LowpassFilter<48, 1, 2> packed_lowpass;
  SobelFilter<24> sobel;
  SobelFilter<48, 1, 2> packed_sobel;
  const auto smooth = pass(lowpass, marked(frame));
  const auto packed_smooth = pass(packed_lowpass, packed);
  const auto gradients = pass(sobel, smooth);
  const auto packed_gradients = pass(packed_sobel, packed_smooth);
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 48; ++x) {
      const auto lane = static_cast<std::size_t>(x % 2);
      const auto& one = gradients.at(x / 2, y);
      const auto& other = packed_gradients.at(x, y);
      REQUIRE(one.mask == other.mask);
      REQUIRE(smooth.at(x / 2, y).saturated == packed_smooth.at(x, y).saturated);
      if (!one.mask) continue;
      REQUIRE(one.gx[lane] == other.gx[0]);
      REQUIRE(one.gy[lane] == other.gy[0]);
    }
  }
}

TEST_CASE("direction: less than 0.5° beyond rounding for every gradient, magnitude within its bounds", "[stages]") {
  DirectionFinder<1> stage;
  Gradients<1> in;
  in.mask = true;
  double worst = 0;  // 1/256 turn
  double over = 0;   // relative, beyond the rounding
  double under = 0;
  bool zero_only_for_zero = true;
  for (int gy = -1020; gy <= 1020; ++gy) {
    for (int gx = -1020; gx <= 1020; ++gx) {
      in.gx[0] = gx;
      in.gy[0] = gy;
      const auto out = stage.step(in);
      const double magnitude = std::hypot(gx, gy);
      zero_only_for_zero = zero_only_for_zero && (out.magnitude[0] == 0) == (magnitude == 0);
      if (out.magnitude[0] < 255) {
        over = std::max(over, (out.magnitude[0].value() - 0.5 - magnitude) / std::max(magnitude, 1.0));
        under = std::max(under, (magnitude - out.magnitude[0].value() - 0.5) / std::max(magnitude, 1.0));
      } else if (magnitude < 255) {
        over = std::max(over, (255 - 0.5 - magnitude) / magnitude);
      }
      if (gx == 0 && gy == 0) {
        REQUIRE(out.direction[0] == 0);
        continue;
      }
      const double error = reference::cyclic_difference(out.direction[0].value(), reference::direction(gx, gy));
      worst = std::max(worst, error);
    }
  }
  const double beyond_rounding_deg = (worst - 0.5) * 360 / 256;
  CAPTURE(beyond_rounding_deg, over, under);
  REQUIRE(beyond_rounding_deg < 0.46);  // required: 0.5
  REQUIRE(over <= 0.069);
  REQUIRE(under <= 0.028);
  REQUIRE(zero_only_for_zero);
}

TEST_CASE("what the CPU computes differently is the same", "[stages]") {
  for (int larger = 0; larger < 1024; ++larger) {
    for (int smaller = 0; smaller <= larger; ++smaller) {
      const u<10> a(smaller);
      const u<10> b(larger);
      if (detail::ratio_by_subtraction<6>(a, b) != detail::ratio_by_division<6>(a, b)) FAIL(smaller << "/" << larger);
    }
  }
  std::mt19937 random(16);
  for (int i = 0; i < 1000; ++i) {
    const u<9> bits(random());
    int ones = 0;
    for (int b = 0; b < 9; ++b) ones += bits.bit(b);
    REQUIRE(popcount(bits) == ones);
  }
}

TEST_CASE("difference: eq. 10.4 in 4 bits for all directions, and what has no direction", "[stages]") {
  DirectionDifference<3> stage;
  for (int a = 0; a < 256; ++a) {
    for (int b = 0; b < 256; ++b) {
      Directions<2> in;
      in.marks.first = true;  // forgets what was before
      in.mask = true;
      in.direction = {u<8>(a), u<8>(b)};
      in.magnitude = {u<8>(1), u<8>(1)};
      const auto out = stage.step(in);
      REQUIRE(out.difference[0].value() == reference::level(reference::cyclic_difference(a, b)));
      REQUIRE(out.difference[1] == 15);  // before the row
      REQUIRE(out.difference[3] == 0);
    }
  }

  std::mt19937 random(17);
  Frame<Directions<2>> frame(40, 4);
  for (auto& beat : frame.beats) {
    beat.direction = {u<8>(random()), u<8>(random())};
    beat.magnitude = {u<8>(one_in(random, 4) ? 0 : 9), u<8>(one_in(random, 4) ? 0 : 9)};
    beat.mask = !one_in(random, 9);
    beat.saturated = one_in(random, 3);
  }
  const auto out = pass(stage, frame);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 40; ++x) {
      const auto& here = frame.at(x, y);
      const auto expected = [&](int shift, std::size_t lane, int outside) {
        if (x < shift || (shift > 0 && !frame.at(x - shift, y).mask)) return outside;
        const auto& there = frame.at(x - shift, y);
        if ((here.magnitude[0] == 0) != (there.magnitude[lane] == 0)) return 8;
        if (here.magnitude[0] == 0) return lane == 1 ? 4 : 0;
        return static_cast<int>(
            reference::level(reference::cyclic_difference(here.direction[0].value(), there.direction[lane].value())));
      };
      CAPTURE(x, y);
      for (int n = 0; n < 3; ++n) REQUIRE(out.at(x, y).difference[static_cast<std::size_t>(n)] == expected(n, 1, 15));
      REQUIRE(out.at(x, y).difference[3] == expected(self_shift, 0, 0));
      REQUIRE(out.at(x, y).magnitude == (here.saturated ? u<8>(0) : here.magnitude[0]));
      REQUIRE(out.at(x, y).mask == here.mask);
    }
  }
}

namespace {

template <int HYPOTHESES, int K>
void check_sums(std::mt19937& random) {
  constexpr int kDelay = (K - 1) / 2;
  constexpr int kTextureLimit = texture_window * texture_window * 128;
  constexpr int kReach = (texture_window - 1) / 2;
  using Texture = TextureDetector<48, HYPOTHESES, kDelay>;
  using Dsad = DsadSum<48, HYPOTHESES, K>;
  auto texture = std::make_unique<Texture>();
  auto dsad = std::make_unique<Dsad>();
  typename Texture::Config config;
  config.texture_limit = kTextureLimit;
  for (const int width : {48, 33}) {
    Frame<typename Texture::In> frame(width, 2 * K + 5);
    for (auto& beat : frame.beats) {
      for (auto& d : beat.difference) d = random();
      beat.magnitude = random();
      beat.mask = !one_in(random, 100);
    }
    const auto textured = pass(*texture, frame, config);
    Frame<typename Dsad::In> passed(frame.width, frame.height);
    for (std::size_t i = 0; i < passed.beats.size(); ++i) {
      passed.beats[i] = {textured.beats[i].difference, textured.beats[i].textured, textured.beats[i].mask,
                         textured.beats[i].marks};
    }
    const auto out = pass(*dsad, passed);
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        CAPTURE(K, HYPOTHESES, x, y);
        const auto& beat = out.at(x, y);
        REQUIRE(beat.mask == window_all(frame, x, y, K, [](const auto& b) { return b.mask; }));
        if (x < K - 1 || y < K - 1) continue;
        for (std::size_t n = 0; n <= HYPOTHESES; ++n) {
          int sum = 0;
          for (int j = 0; j < K; ++j) {
            for (int i = 0; i < K; ++i) sum += frame.at(x - i, y - j).difference[n].value();
          }
          REQUIRE(beat.sum[n] == sum);
        }
        int magnitude = 0;
        for (int j = -kReach; j <= kReach; ++j) {
          for (int i = -kReach; i <= kReach; ++i)
            magnitude += frame.at(x - kDelay + i, y - kDelay + j).magnitude.value();
        }
        REQUIRE(beat.textured == (magnitude >= kTextureLimit));
      }
    }
  }
}

template <int M>
void check_majority(std::mt19937& random) {
  auto stage = std::make_unique<MajorityVote<48, M>>();
  int seen[4] = {};
  for (const unsigned rarity : {2U, 3U, 5U}) {
    Frame<typename MajorityVote<48, M>::In> frame(48, 2 * M + 20);
    for (auto& beat : frame.beats) {
      beat.decidable = one_in(random, 2) || one_in(random, rarity);
      beat.skin = one_in(random, 2);
      beat.mask = !one_in(random, 300);
    }
    const auto out = pass(*stage, frame);
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        int expected = state::unsupervised;
        if (window_all(frame, x, y, M, [](const auto& b) { return b.mask; })) {
          int decidable = 0;
          int skin = 0;
          for (int j = 0; j < M; ++j) {
            for (int i = 0; i < M; ++i) {
              const auto& b = frame.at(x - i, y - j);
              decidable += b.decidable;
              skin += b.decidable && b.skin;
            }
          }
          expected = 2 * decidable <= M * M ? state::undecidable : 2 * skin > decidable ? state::skin : state::clear;
        }
        CAPTURE(M, x, y);
        REQUIRE(out.at(x, y).state == expected);
        ++seen[expected];
      }
    }
  }
  for (const int count : seen) REQUIRE(count > 0);
}

}  // namespace

TEST_CASE("texture and dsad count exactly, in step with each other", "[stages]") {
  std::mt19937 random(18);
  check_sums<1, 5>(random);
  check_sums<1, 7>(random);
  check_sums<1, 9>(random);
  check_sums<2, 9>(random);
  check_sums<4, 9>(random);
  check_sums<1, 11>(random);
  check_sums<3, 13>(random);
}

TEST_CASE("majority counts exactly", "[stages]") {
  std::mt19937 random(19);
  check_majority<3>(random);
  check_majority<5>(random);
  check_majority<7>(random);
  check_majority<9>(random);
}

TEST_CASE("align, runs and alarm: every pixel once, in its place", "[stages]") {
  std::mt19937 random(20);
  constexpr int kOffset = 9;
  constexpr int kWidth = 48;
  constexpr int kHeight = 30;
  Aligner<64, 40, {kOffset, kOffset}> align;
  RunEncoder<64, 40> runs;
  AlarmCounter<64, 40> alarm;
  decltype(align)::Config size;
  size.width = kWidth;
  size.height = kHeight;
  for (int repetition = 0; repetition < 3; ++repetition) {
    if (repetition == 2) {  // a frame that breaks off
      Frame<Aligner<64, 40, {kOffset, kOffset}>::In> cut(kWidth, 17);
      for (const auto& beat : cut.beats) {
        const auto p = align.step(beat, size);
        if (p.valid) runs.step({p.state, p.first, p.last, p.idle});
      }
    }
    Frame<Aligner<64, 40, {kOffset, kOffset}>::In> frame(kWidth, kHeight + kOffset + 1);
    for (auto& beat : frame.beats) {
      beat.state = one_in(random, 4) ? static_cast<int>(random() % 4) : repetition;
      beat.marks.seen = true;
    }
    std::vector<int> pixels;
    std::vector<int> from_runs(kWidth * kHeight, -1);
    int counts[4] = {};
    decltype(alarm)::Config limits;
    limits.alarm_limit = 300;
    limits.undecidable_limit = 300;
    limits.unsupervised_limit = 300;
    int ends = 0;
    int last_runs = 0;
    for (const auto& beat : frame.beats) {
      const auto pixel = align.step(beat, size);
      if (!pixel.valid) continue;
      if (!pixel.idle) {
        const int i = static_cast<int>(pixels.size());
        REQUIRE(pixel.first == (i == 0));
        REQUIRE(pixel.last == (i % kWidth == kWidth - 1));
        REQUIRE(pixel.end == (i == kWidth * kHeight - 1));
        pixels.push_back(pixel.state.value());
        ++counts[pixel.state.value()];
      }
      const auto run = runs.step({pixel.state, pixel.first, pixel.last, pixel.idle});
      if (run.valid) {
        for (int x = run.start.value(); x <= run.end.value(); ++x) {
          int& p = from_runs[static_cast<std::size_t>(run.row.value() * kWidth + x)];
          REQUIRE(p == -1);
          p = run.state.value();
        }
        last_runs += run.last;
      }
      const auto total = alarm.step({pixel.state, pixel.first, pixel.end, pixel.idle}, limits);
      if (total.valid) {
        ++ends;
        REQUIRE(total.skin_pixels == counts[state::skin]);
        REQUIRE(total.unsupervised_pixels == counts[state::unsupervised]);
        REQUIRE(total.alarm == (counts[state::skin] > 300));
        REQUIRE(total.too_undecidable == (counts[state::undecidable] > 300));
        REQUIRE(total.too_unsupervised == (counts[state::unsupervised] > 300));
      }
    }
    REQUIRE(pixels.size() == kWidth * kHeight);
    REQUIRE(pixels == from_runs);
    REQUIRE(ends == 1);
    REQUIRE(last_runs == 1);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const std::size_t beat =
            static_cast<std::size_t>((y + kOffset) * kWidth + x + kOffset);  // raster shifted as a whole
        REQUIRE(pixels[static_cast<std::size_t>(y * kWidth + x)] == frame.beats[beat].state.value());
      }
    }
  }
}

TEST_CASE("health: black, white, constant and frozen images", "[stages]") {
  CameraHealth<32, 16> stage;
  decltype(stage)::Config config;
  config.dark_level = 4;
  config.bright_level = 251;
  config.dark_limit = 486;  // of 512
  config.bright_limit = 486;
  config.contrast_limit = 8;
  config.frozen_limit = 2;
  std::mt19937 random(21);
  const auto frame = [&](auto&& pixel) {
    decltype(stage)::Out result;
    for (int i = 0; i < 512; ++i) {
      decltype(stage)::In in;
      in.pixel = pixel(i);
      in.first = i == 0;
      in.end = i == 511;
      result = stage.step(in, config);
      REQUIRE(result.valid == in.end);
    }
    return result;
  };
  const auto noise = [&](int) { return 100 + static_cast<int>(random() % 40); };
  const auto none = [](const auto& r) { return !r.black && !r.white && !r.constant && !r.frozen; };
  REQUIRE(none(frame(noise)));
  REQUIRE(frame([&](int) { return random() % 5; }).black);
  REQUIRE(!frame([&](int) { return random() % 6; }).black);
  REQUIRE(frame([&](int) { return 251 + random() % 5; }).white);
  REQUIRE(none(frame([](int i) { return i < 26 ? 100 : 3; })));
  REQUIRE(frame([](int i) { return i < 25 ? 100 : 3; }).black);
  const auto flat = frame([&](int) { return 100 + random() % 9; });
  REQUIRE((flat.constant && !flat.black && !flat.white));
  REQUIRE(none(frame(noise)));
  std::vector<int> picture(512);
  for (int& p : picture) p = noise(0);
  const auto same = [&](int i) { return picture[static_cast<std::size_t>(i)]; };
  REQUIRE(none(frame(same)));
  REQUIRE(none(frame(same)));  // the first repetition
  REQUIRE(frame(same).frozen);
  picture[100] += 1;
  REQUIRE(none(frame(same)));
  REQUIRE(none(frame(same)));
  REQUIRE(frame(same).frozen);
  config.frozen_limit = 0;
  REQUIRE(none(frame(same)));
  horopter::hls::reset(stage);
  config.frozen_limit = 1;
  const auto first = frame(same);
  REQUIRE(none(first));  // nothing before it
  const auto second = frame(same);
  REQUIRE(second.frozen);
  // Two in turn, as the fields of an image that repeats.
  std::vector<int> other(512);
  for (int& p : other) p = noise(0);
  const auto second_field = [&](int i) { return other[static_cast<std::size_t>(i)]; };
  REQUIRE(none(frame(second_field)));
  REQUIRE(frame(same).frozen);
  REQUIRE(frame(second_field).frozen);
  REQUIRE(none(frame(noise)));
  REQUIRE(frame(second_field).frozen);
  REQUIRE(none(frame(noise)));
  REQUIRE(none(frame(noise)));
  REQUIRE(none(frame(same)));
  // The signature tells frames apart, whichever camera they are of.
  REQUIRE(second.signature == first.signature);
  picture[511] ^= 1;
  REQUIRE(frame(same).signature != first.signature);
}

TEST_CASE("health and still: two old images of two fields in turn repeat the fields of the one before the last",
          "[stages]") {
  constexpr int kCells = 300, kFields = 2, kImages = 8;
  CameraHealth<64, 16, 2, 2 * kFields> health;
  decltype(health)::Config config;
  config.dark_limit = config.bright_limit = 64 * 16;
  config.frozen_limit = 1;
  StillCheck<kCells, kFields> still;
  decltype(still)::Config still_config;
  still_config.still_limit = 1;
  std::mt19937 random(31);
  std::vector<std::vector<int>> field(2 * kFields, std::vector<int>(1024));
  const auto renew = [&](std::vector<int>& values) {
    for (int& value : values) value = 20 + static_cast<int>(random() % 200);
  };
  for (auto& values : field) renew(values);
  for (const bool repeats : {false, true}) {
    horopter::hls::reset(health);
    horopter::hls::reset(still);
    for (int image = 0; image < kImages; ++image) {
      for (std::size_t parity = 0; parity < kFields; ++parity) {
        auto& values = field[static_cast<std::size_t>(image % 2 * kFields) + parity];
        if (!repeats) renew(values);
        CAPTURE(repeats, image, parity);
        decltype(health)::Out seen;
        for (int i = 0; i < 1024; ++i) {
          decltype(health)::In in;
          in.pixel = values[static_cast<std::size_t>(i)];
          in.first = i == 0;
          in.last = i % 64 == 63;
          in.end = i == 1023;
          seen = health.step(in, config);
        }
        CHECK(seen.frozen == (repeats && image >= 2));
        decltype(still)::Out same;
        for (int i = 0; i < kCells; ++i) {
          const u<8> mean(values[static_cast<std::size_t>(i)]);
          same = still.step({mean, u<8>(static_cast<int>(random() % 256)), i == 0}, still_config);
        }
        CHECK(same.left_still == (repeats && image >= 2));
        CHECK_FALSE(same.right_still);
      }
    }
  }
}

TEST_CASE("health: rows of two moments in turn are torn, whatever their contrast; scenes and noise are not",
          "[stages]") {
  using Stage = CameraHealth<256, 96>;
  Stage stage;
  Stage::Config config;
  config.dark_limit = config.bright_limit = 256 * 96;
  std::mt19937 random(23);
  const auto frame = [&](int width, int height, auto&& pixel) {
    Stage::Out result;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        Stage::In in;
        in.pixel = pixel(x, y);
        in.first = x == 0 && y == 0;
        in.last = x == width - 1;
        in.end = in.last && y == height - 1;
        result = stage.step(in, config);
      }
    REQUIRE(result.valid);
    return result.torn;
  };
  const auto scene = [](int x, int y) {
    return 128 + 100 * std::sin(0.13 * x + 0.05 * y) * std::cos(0.02 * x - 0.11 * y);
  };
  const auto noise = [&](int sigma) { return std::normal_distribution<>(0, sigma)(random); };
  for (const int contrast : {1, 4, 16}) {
    CAPTURE(contrast);
    const auto seen = [&](int x, int y) { return static_cast<int>(128 + (scene(x, y) - 128) / contrast); };
    CHECK(!frame(256, 96, seen));
    for (const int shift : {4, -8, 20}) CHECK(frame(256, 96, [&](int x, int y) { return seen(x + y % 2 * shift, y); }));
  }
  for (const int sigma : {1, 5, 20}) {
    CAPTURE(sigma);
    const auto noisy = [&](double grey) { return std::clamp(static_cast<int>(grey + noise(sigma)), 0, 255); };
    for (int repeat = 0; repeat < 10; ++repeat) {
      CHECK(!frame(256, 96, [&](int, int) { return noisy(128); }));
      CHECK(!frame(64, 32, [&](int, int) { return noisy(128); }));
      CHECK(!frame(256, 96, [&](int x, int y) { return noisy(scene(x, y)); }));
      CHECK(frame(256, 96, [&](int x, int y) { return noisy(scene(x + y % 2 * 20, y)); }));
    }
  }
  // Rows that alternate in a third of the image; below it and beside it nothing.
  CHECK(frame(256, 96, [](int, int y) { return y < 32 && y % 2 == 1 ? 200 : 100; }));
  CHECK(!frame(256, 96, [](int, int) { return 100; }));
}

namespace {

/// Grey values of a scene: waves of all directions, as fine as `finest_px`.
class Waves {
 public:
  Waves(unsigned seed, double finest_px, double coarsest_px) {
    std::mt19937 random(seed);
    const auto from_to = [&](double low, double high) { return low + (high - low) * random() / 4294967296.0; };
    for (Wave& wave : waves_) {
      const double turns = 2 * std::numbers::pi / (finest_px * std::pow(coarsest_px / finest_px, from_to(0, 1)));
      const double direction = from_to(0, std::numbers::pi);
      wave = {turns * std::cos(direction), turns * std::sin(direction), from_to(0, 6)};
    }
  }
  double operator()(double x, double y) const {
    double sum = 0;
    for (const Wave& wave : waves_) sum += std::sin(wave.x * x + wave.y * y + wave.start);
    return sum / waves_.size();
  }

 private:
  struct Wave {
    double x, y, start;
  };
  std::array<Wave, 12> waves_{};
};

template <class Stage>
bool is_torn(int width, int height, auto&& pixel) {
  Stage stage;
  typename Stage::Config config;
  config.dark_limit = config.bright_limit = width * height;
  typename Stage::Out result;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      typename Stage::In in;
      in.pixel = std::clamp(static_cast<int>(std::lround(pixel(x, y))), 0, 255);
      in.first = x == 0 && y == 0;
      in.last = x == width - 1;
      in.end = in.last && y == height - 1;
      result = stage.step(in, config);
    }
  }
  REQUIRE(result.valid);
  return result.torn;
}

}  // namespace

TEST_CASE("health: rows that each lie aside are torn; scenes, noise, blocks and the rows of a field are not",
          "[stages]") {
  using Whole = CameraHealth<256, 192>;
  using Field = CameraHealth<256, 128, 2>;
  std::mt19937 random(24);
  std::normal_distribution<> normal;
  std::vector<int> aside_px(192);
  for (int& px : aside_px) px = static_cast<int>(random() % 17) - 8;
  const auto aside = [&](int y) { return aside_px[static_cast<std::size_t>(y)]; };
  for (const unsigned seed : {1U, 2U}) {
    const Waves scene(seed, 6, 60);
    for (const int grey_levels : {300, 60, 30}) {
      CAPTURE(seed, grey_levels);
      const auto seen = [&](double x, double y) { return 128 + grey_levels * scene(x, y); };
      CHECK(!is_torn<Whole>(256, 192, seen));
      CHECK(!is_torn<Field>(256, 128, [&](int x, int y) { return seen(x, 2 * y); }));
      CHECK(is_torn<Whole>(256, 192, [&](int x, int y) { return seen(x + aside(y), y); }));
    }
    for (const int sigma : {2, 10}) {
      CAPTURE(seed, sigma);
      CHECK(!is_torn<Whole>(256, 192, [&](int x, int y) { return 128 + 300 * scene(x, y) + sigma * normal(random); }));
    }
    CHECK(is_torn<Whole>(256, 192,
                         [&](int x, int y) { return 128 + 300 * scene(x + aside(y), y) + 2 * normal(random); }));
    // What stands upright is the same in all rows, but for noise.
    for (const int sigma : {0, 2, 10}) {
      CAPTURE(seed, sigma);
      CHECK(!is_torn<Whole>(256, 192, [&](int x, int) { return 128 + 300 * scene(x, 0) + sigma * normal(random); }));
    }
    // As fine as a field can show it: it changes more from row to row than from pixel to pixel.
    const Waves fine(seed, 6, 7);
    CHECK(!is_torn<Field>(256, 128, [&](int x, int y) { return 128 + 300 * fine(0.8 * x, 2 * y); }));
  }
  for (int repeat = 0; repeat < 10; ++repeat)
    for (const int sigma : {1, 3, 20})
      CHECK(!is_torn<Whole>(256, 192, [&](int, int) { return 128 + sigma * normal(random); }));
  // Blocks of one grey value each, wherever they begin.
  std::vector<int> greys(std::size_t{256} * 256);
  for (int& grey : greys) grey = static_cast<int>(random() % 256);
  for (const int side : {2, 4, 8}) {
    for (int begin = 0; begin < 16; ++begin) {
      CAPTURE(side, begin);
      const auto block = [&](int x, int y) {
        return greys[static_cast<std::size_t>((y + begin / 4) / side * 256 + (x + begin % 4) / side)];
      };
      CHECK(!is_torn<Whole>(256, 192, block));
      CHECK(!is_torn<Field>(256, 128, block));
    }
  }
}

TEST_CASE("health: pairs of rows aside are torn; scenes, noise, blocks, doubled rows and most stripes are not",
          "[stages]") {
  using Whole = CameraHealth<256, 192>;
  std::mt19937 random(25);
  std::normal_distribution<> normal;
  for (const unsigned seed : {3U, 4U}) {
    const Waves scene(seed, 6, 60);
    for (const int grey_levels : {300, 60, 30}) {
      CAPTURE(seed, grey_levels);
      const auto seen = [&](int x, int y) { return 128 + grey_levels * scene(x, y); };
      CHECK(!is_torn<Whole>(256, 192, seen));
      CHECK(!is_torn<Whole>(256, 192, [&](int x, int y) { return seen(x, y / 2); }));
      CHECK(!is_torn<Whole>(256, 192, [&](int x, int y) { return seen(x + y / 4 % 2 * 8, y); }));  // only four by four
      for (int begin = 0; begin < 4; ++begin)
        for (const int shift : {8, -20})
          CHECK(is_torn<Whole>(256, 192, [&](int x, int y) { return seen(x + (y + begin) / 2 % 2 * shift, y); }));
    }
    for (const int sigma : {2, 5, 10}) {
      CAPTURE(seed, sigma);
      const auto noisy = [&](int x, int y) { return 128 + 300 * scene(x, y) + sigma * normal(random); };
      CHECK(!is_torn<Whole>(256, 192, noisy));
      CHECK(is_torn<Whole>(256, 192, [&](int x, int y) { return noisy(x + y / 2 % 2 * 8, y); }));
    }
    // Stripes: they are like what is one period above, but so in even and odd rows.
    for (const double period : {3.9, 4.1, 4.5, 5.0, 6.0}) {
      CAPTURE(seed, period);
      const auto stripes = [&](int x, int y) {
        return 128 + 100 * scene(x, y) + 60 * std::sin(2 * std::numbers::pi / period * y);
      };
      CHECK(!is_torn<Whole>(256, 192, stripes));
    }
  }
}

namespace {

/// Frames of which more and more rows lie aside, by step() alone and by rows: the results are the same. How many are torn.
template <class Stage>
int torn_by_rows_as_by_pixels(int width, int height, int frames) {
  Stage by_pixels, by_rows;
  std::mt19937 random(26);
  int torn = 0;
  for (int k = 0; k < frames; ++k) {
    const Waves scene(static_cast<unsigned>(k), 6, 60);
    std::vector<std::uint8_t> image(static_cast<std::size_t>(width * height));
    const auto row_of = [&](int y) {
      return std::span(image).subspan(static_cast<std::size_t>(y * width)).first(static_cast<std::size_t>(width));
    };
    constexpr int kAcross = Stage::pixels_before / 2;
    for (int y = 0; y < height; ++y) {
      const int shift_px =
          static_cast<int>(random() % 100) * frames < 250 * k ? static_cast<int>(random() % 17) - 8 : 0;
      for (int x = 0; x < width; ++x)
        row_of(y)[static_cast<std::size_t>(x)] = static_cast<std::uint8_t>(
            std::clamp(128 + 300 * scene(x + shift_px, kAcross * y) + static_cast<int>(random() % 5), 0.0, 255.0));
    }
    typename Stage::Config config;
    config.dark_level = static_cast<int>(random() % 128);
    config.bright_level = 128 + static_cast<int>(random() % 128);
    // One in two is black, one in two white.
    config.dark_limit = std::ranges::count_if(image, [&](int grey) { return grey <= config.dark_level.value(); }) -
                        static_cast<int>(random() % 2);
    config.bright_limit = std::ranges::count_if(image, [&](int grey) { return grey >= config.bright_level.value(); }) -
                          static_cast<int>(random() % 2);
    const auto [darkest, brightest] = std::ranges::minmax(image);
    config.contrast_limit = brightest - darkest - static_cast<int>(random() % 2);
    typename Stage::Out expected, result;
    for (int y = 0; y < height; ++y) {
      const auto row = row_of(y);
      const auto in = [&](int x) -> typename Stage::In {
        return {row[static_cast<std::size_t>(x)], x == 0 && y == 0, x == width - 1 && y == height - 1, x == width - 1};
      };
      for (int x = 0; x < width; ++x) expected = by_pixels.step(in(x), config);
      const int most = width - Stage::pixels_before - 1;
      const int passed = k % 3 == 0 ? most : static_cast<int>(random() % static_cast<unsigned>(most + 1));
      for (int x = 0; x < width; ++x) {
        result = by_rows.step(in(x), config);
        if (x + 1 != Stage::pixels_before) continue;
        by_rows.pass(row.subspan(Stage::pixels_before).first(static_cast<std::size_t>(passed)), config);
        x += passed;
      }
    }
    CAPTURE(k, width, height);
    REQUIRE(result.valid);
    CHECK(result.signature == expected.signature);
    CHECK(result.black == expected.black);
    CHECK(result.white == expected.white);
    CHECK(result.constant == expected.constant);
    CHECK(result.torn == expected.torn);
    torn += expected.torn ? 1 : 0;
  }
  return torn;
}

}  // namespace

TEST_CASE("health: many pixels of a row at once change nothing", "[stages]") {
  const auto some = [](int torn) {
    CAPTURE(torn);
    CHECK(torn > 2);
    CHECK(torn < 38);
  };
  some(torn_by_rows_as_by_pixels<CameraHealth<256, 192>>(256, 192, 40));
  some(torn_by_rows_as_by_pixels<CameraHealth<256, 192>>(203, 190, 40));
  some(torn_by_rows_as_by_pixels<CameraHealth<256, 192, 2>>(256, 192, 40));
  torn_by_rows_as_by_pixels<CameraHealth<32, 16>>(32, 16, 40);
}

TEST_CASE("cells: the means of squares, of what fills one", "[stages]") {
  std::mt19937 random(22);
  CellMeans<64, 8> stage;
  for (const auto& [width, height] : {std::pair{64, 24}, std::pair{45, 23}, std::pair{33, 16}}) {
    std::vector<int> pixels(static_cast<std::size_t>(width * height));
    for (int& p : pixels) p = static_cast<int>(random() % 256);
    const auto pixel = [&, columns = width](int x, int y) { return pixels[static_cast<std::size_t>(y * columns + x)]; };
    std::vector<int> means;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const auto out = stage.step({pixel(x, y), x == 0 && y == 0, x == width - 1});
        if (!out.valid) continue;
        REQUIRE(out.start == (x == 7));
        REQUIRE((x % 8 == 7 && y % 8 == 7));
        means.push_back(out.mean.value());
      }
    }
    std::vector<int> expected;
    for (int y = 0; y + 8 <= height; y += 8) {
      for (int x = 0; x + 8 <= width; x += 8) {
        int sum = 0;
        for (int i = 0; i < 64; ++i) sum += pixel(x + i % 8, y + i / 8);
        expected.push_back(sum / 64);
      }
    }
    REQUIRE(means == expected);
  }
}

namespace {

constexpr int kCellColumns = 40;
constexpr int kCellRows = 30;
using SmallCoarse = CoarseCheck<kCellColumns * kCellRows>;

/// The check of two pictures, functions of the place in cells; each cell's mean has noise.
template <class Left, class Right>
SmallCoarse::Out coarse_of(const SmallCoarse::Config& config, double noise_level, const Left& left,
                           const Right& right) {
  static std::mt19937 random(23);
  std::normal_distribution<double> noise(0, 1);
  SmallCoarse stage;
  SmallCoarse::Out out;
  for (int y = 0; y < kCellRows; ++y) {
    for (int x = 0; x < kCellColumns; ++x) {
      const auto mean = [&](double grey) {
        return u<8>(static_cast<int>(std::clamp(grey + noise_level * noise(random), 0.0, 255.0)));
      };
      out = stage.step({mean(left(x, y)), mean(right(x, y)), x == 0 && y == 0, x == 0}, config);
    }
  }
  return out;
}

/// A scene without a repetition, with edges of different contrast.
double scene(double x, double y) {
  return 120 + 40 * std::sin(1.3 * x + 0.7 * y) + 30 * std::sin(0.61 * x - 1.1 * y + 1) +
         20 * std::sin(2.1 * x + 0.3 * y + 2);
}

}  // namespace

TEST_CASE("coarse: one camera twice is the same everywhere, a wall before two cameras is not", "[stages]") {
  SmallCoarse::Config config;
  config.one_camera_segments = 12;
  const auto one_camera = [&](double noise, const auto& right) {
    return coarse_of(config, noise, scene, right).one_camera;
  };
  for (const double noise : {0.0, 0.1, 0.6}) {  // 8×8 px of sigma 5
    constexpr std::array<std::pair<double, double>, 4> kLights{{{1.0, 0.0}, {0.5, 20.0}, {1.0, 20.0}, {0.8, -10.0}}};
    for (const auto& light : kLights) {
      const double gain = light.first;
      const double offset = light.second;
      CAPTURE(noise, gain, offset);
      CHECK(one_camera(noise, [=](int x, int y) { return gain * scene(x, y) + offset; }));
      // 2 px of 8.
      CHECK(!one_camera(noise, [=](int x, int y) { return gain * scene(x + 0.25, y) + offset; }));
    }
    // Toed-in cameras before a wall where their axes cross: nothing in the middle, 2 px at the edge.
    CHECK(!one_camera(noise, [](int x, int y) {
      const double from_middle = (x - 0.5 * kCellColumns) / (0.5 * kCellColumns);
      return scene(x + 0.25 * from_middle * from_middle, y);
    }));
    CHECK(!one_camera(noise, [](int x, int y) { return scene(x + 90, y); }));
    CHECK(!one_camera(noise, [](int, int) { return 120.0; }));
  }
  // Where too little has texture nothing is said.
  const auto window = [](int x, int y) { return y < 2 ? scene(x, y) : 100.0; };
  CHECK(!coarse_of(config, 0.1, window, window).one_camera);
  config.one_camera_segments = 10;
  CHECK(coarse_of(config, 0.1, window, window).one_camera);
  config.one_camera_segments = 0;
  CHECK(!coarse_of(config, 0.1, scene, scene).one_camera);
}

TEST_CASE("coarse: an image without contrast is blind, whichever camera's", "[stages]") {
  SmallCoarse::Config config;
  config.blind_step = 14;
  config.blind_share = 2;  // of 1200 cells 9.4
  const auto fog = [](int x, int y) { return 120 + scene(x, y) / 16; };
  const auto ramp = [](int x, int) { return 3.2 * x; };
  const auto half = [](int x, int y) { return scene(x, y) / 2; };
  const auto check = [&](const auto& other, double noise, bool blind) {
    const auto right = coarse_of(config, noise, scene, other);
    const auto left = coarse_of(config, noise, other, scene);
    CHECK((!right.left_blind && right.right_blind == blind));
    CHECK((!left.right_blind && left.left_blind == blind));
  };
  for (const double noise : {0.0, 0.6, 2.5}) {  // 8×8 px of sigma 20
    CAPTURE(noise);
    check(fog, std::min(noise, 0.6), true);
    check(ramp, noise, true);
    check(half, noise, false);
  }
  // Cells are counted exactly. Steps of 8 are in every strip and row.
  const auto steps = [](int n) {
    return [n](int x, int y) { return x % 2 == 0 ? 100.0 : y * kCellColumns / 2 + x / 2 < n / 2 ? 114.0 : 108.0; };
  };
  check(steps(10), 0, false);
  check(steps(8), 0, true);
  config.blind_step = 15;
  check(steps(10), 0, true);
  config.blind_share = 0;
  check(steps(0), 0, false);
}

TEST_CASE("coarse: a camera that is covered in part is blind, whichever it is", "[stages]") {
  SmallCoarse::Config config;
  config.blind_step = 14;
  config.blind_share = 2;
  const auto check = [&](const auto& covered, bool blind) {
    const auto image = [&](int x, int y) { return covered(x, y) ? 100.0 : scene(x, y); };
    const auto right = coarse_of(config, 0.2, scene, image);
    const auto left = coarse_of(config, 0.2, image, scene);
    CHECK((!right.left_blind && right.right_blind == blind));
    CHECK((!left.right_blind && left.left_blind == blind));
  };
  // Of 10 strips of 4 columns, and of 30 rows.
  for (const int first : {0, 16, 24}) {
    CAPTURE(first);
    const int width = first == 0 ? 12 : 16;  // the cover's left edge is a step of the first strip
    check([=](int x, int) { return x >= first && x < first + width; }, true);
    check([=](int x, int) { return x >= first && x < first + width - 4; }, false);
    check([=](int x, int y) { return x >= first && x < first + width && y != 17; }, false);
  }
  for (const int first : {0, 10, 22}) {
    CAPTURE(first);
    check([=](int, int y) { return y >= first && y < first + 8; }, true);
    check([=](int, int y) { return y >= first && y < first + 7; }, false);
    check([=](int x, int y) { return y >= first && y < first + 8 && x != 17; }, false);
  }
  config.blind_share = 0;
  check([](int x, int) { return x < 12; }, false);
}

TEST_CASE("still: a frame that repeats one of the two before, but for noise", "[stages]") {
  constexpr int kCells = 300;
  std::mt19937 random(24);
  std::normal_distribution<double> normal(0, 1);
  using Still = StillCheck<kCells>;
  Still stage;
  Still::Config config;
  config.still_limit = 3;
  using Frames = std::pair<std::vector<int>, std::vector<int>>;
  const auto scene = [&] {
    std::vector<int> means(kCells);
    for (int& mean : means) mean = 20 + static_cast<int>(random() % 200);
    return means;
  };
  const auto see = [&](const Frames& frames, double noise = 1.25) {  // 8×8 px of sigma 10
    Still::Out out;
    for (int i = 0; i < kCells; ++i) {
      const auto mean = [&](const std::vector<int>& means) {
        return u<8>(static_cast<int>(means[static_cast<std::size_t>(i)] + noise * normal(random)));
      };
      out = stage.step({mean(frames.first), mean(frames.second), i == 0}, config);
    }
    return std::pair{out.left_still, out.right_still};
  };
  using Still2 = std::pair<bool, bool>;
  const auto left = scene();
  const auto other = scene();
  // The left camera stands still, the right one does not.
  for (int frame = 0; frame < 3; ++frame) CHECK(see({left, scene()}) == Still2{false, false});
  for (int frame = 0; frame < 3; ++frame) CHECK(see({left, scene()}) == Still2{true, false});
  for (int frame = 0; frame < 300; ++frame) see({left, scene()});
  CHECK(see({left, scene()}) == Still2{true, false});
  CHECK(see({other, scene()}) == Still2{false, false});
  // The right camera gives two old frames in turn; the first that repeats is the third.
  for (int frame = 0; frame < 4; ++frame) {
    CHECK(see({scene(), frame % 2 == 0 ? left : other}) == Still2{false, false});
  }
  CHECK(see({scene(), left}) == Still2{false, true});
  CHECK(see({scene(), other}) == Still2{false, true});
  // Three frames in turn are not told.
  const auto third = scene();
  see({scene(), third});
  for (int frame = 0; frame < 9; ++frame) {
    CHECK(!see({scene(), frame % 3 == 0 ? left : frame % 3 == 1 ? other : third}).second);
  }
  // Two of the cells that are looked at are enough: one of 17.
  auto moved = left;
  for (int frame = 0; frame < 4; ++frame) see({left, scene()}, 0);
  CHECK(see({left, scene()}, 0).first);
  for (int i = 100; i < 117; ++i) moved[static_cast<std::size_t>(i)] += 8;
  CHECK(see({moved, scene()}, 0).first);
  for (int i = 117; i < 134; ++i) moved[static_cast<std::size_t>(i)] += 8;
  for (int i = 100; i < 117; ++i) moved[static_cast<std::size_t>(i)] -= 17;
  CHECK(!see({moved, scene()}, 0).first);
  config.still_limit = 0;
  for (int frame = 0; frame < 8; ++frame) CHECK(!see({left, scene()}).first);
  config.still_limit = 1;
  CHECK(see({left, scene()}).first);
  // Nothing is said of the first frame.
  horopter::hls::reset(stage);
  CHECK(!see({left, scene()}).first);
  CHECK(see({left, scene()}).first);
}

TEST_CASE("a row shorter than the memories' distance is refused", "[stages]") {
  LowpassFilter<48> lowpass;
  const Frame<Grey<2>> frame(min_row_beats - 1, 4);
  REQUIRE_THROWS_AS(pass(lowpass, frame), horopter::hls::hazard_error);
  LowpassFilter<48> narrow;
  const Frame<Grey<2>> wide(49, 2);
  REQUIRE_THROWS_AS(pass(narrow, wide), horopter::hls::hazard_error);
}
