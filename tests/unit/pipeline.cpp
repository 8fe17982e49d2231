// SPDX-License-Identifier: Apache-2.0
// All stages together: against the same stages beat by beat, against the reference, and on images made for a purpose.
#include "stages/pipeline.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "raster.hpp"
#include "reference/reference.hpp"

using namespace horopter;
using namespace horopter::stages;
namespace reference = horopter::tb::reference;

namespace {

constexpr hls::Profile kPlain{96, 64, 1, 9, 7, 3, 32, 0, 1, 1, hls::Decisions::thesis};
constexpr hls::Profile kHalving{128, 48, 2, 7, 5, 3, 32, 0, 2, 1, hls::Decisions::thesis};
constexpr hls::Profile kWide{160, 120, 1, 9, 7, 3, 64, 0, 1, 1, hls::Decisions::thesis};

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;

  Picture(int w, int h, const std::function<double(int, int)>& value)
      : width(w), height(h), pixels(static_cast<std::size_t>(w * h)) {
    for (int y = 0; y < h; ++y) {
      for (int x = 0; x < w; ++x) {
        pixels[static_cast<std::size_t>(y * w + x)] =
            static_cast<std::uint8_t>(std::clamp(std::lround(value(x, y)), 0L, 255L));
      }
    }
  }
  [[nodiscard]] native::ImageView view() const { return {pixels.data(), width, height, width}; }
  [[nodiscard]] reference::Image exact() const {
    reference::Image image(width, height);
    std::copy(pixels.begin(), pixels.end(), image.values.begin());
    return image;
  }
};

using Map = std::function<std::optional<reference::Point>(int, int)>;

std::vector<std::uint32_t> table_of(int width, int height, int nx, int ny, const Map& source,
                                    const std::vector<hls::table::Span>& spans = {}) {
  return hls::table::write(
      {width, height, nx, ny, !spans.empty()}, {},
      [&](int column, int row) {
        const auto p = source(column << nx, row << ny);
        return p ? hls::table::encode_control(p->x, p->y) : hls::table::unmapped;
      },
      spans);
}

/// An ellipse that the image cuts, with a rough outline and some rows that have nothing.
std::vector<hls::table::Span> spans_of(int width, int height, std::mt19937& random) {
  std::vector<hls::table::Span> spans;
  for (int y = 0; y < height; ++y) {
    const double v = (y - 0.45 * height) / (0.5 * height);
    const auto reach = static_cast<int>(0.6 * width * std::sqrt(std::max(0.0, 1 - v * v))) + int(random() % 3);
    const hls::table::Span span{std::max(0, width / 2 - reach), std::min(width, width / 2 + reach)};
    spans.push_back(span.first < span.end && y % 61 != 7 ? span : hls::table::Span{});
  }
  return spans;
}

Map shifted(double dx, double dy) {
  return [=](int x, int y) { return reference::Point{x + dx, y + dy}; };
}

/// The same stages, each called once per beat, nothing cached, garbage where the hardware may have some.
template <hls::Profile P>
class BeatByBeat {
 public:
  void frame(const native::ImageView& left, const native::ImageView& right, const native::TableView& table,
             const native::Settings& settings, std::vector<std::uint8_t>& states, std::vector<native::Run>& found,
             std::mt19937& random) {
    chain.configure(native::FrameSettings(settings, left.width / P.subsample, left.height));
    const int sx = table.spacing_x_log2();
    const int sy = table.spacing_y_log2();
    typename MapExpand<P>::Config map_config;
    map_config.spacing_x_log2 = sx;
    for (int y = 0; y < left.height + P.flush_rows(); ++y) {
      const int cell = std::min(y, left.height - 1) >> sy;
      typename MapExpand<P>::In in;
      in.prime = true;
      in.row_fraction = (y & ((1 << sy) - 1)) << (6 - sy);
      in.column = {table.control(0, cell), table.control(0, cell + 1)};
      map_expand.step(in, map_config);
      in.prime = false;
      for (int x = 0; x < left.width; ++x) {
        in.load = (x & ((1 << sx) - 1)) == 0;
        if (in.load) in.column = {table.control((x >> sx) + 1, cell), table.control((x >> sx) + 1, cell + 1)};
        in.marks = {x == 0 && y == 0, x + 1 == left.width, y < left.height};
        in.outside = y >= left.height || !table.span(y).holds(x);
        const auto s = map_expand.step(in, map_config);
        typename Interpolate<P>::In taps;
        taps.p00 = taps.p01 = taps.p10 = taps.p11 = u<8>(random());
        taps.left = u<8>(random());
        taps.wx = s.wx;
        taps.wy = s.wy;
        taps.marks = {s.marks.first, s.marks.last};
        const int rx = s.x.value();
        const int ry = s.y.value();
        const int bx = rx + (s.wx != 0);
        const int by = ry + (s.wy != 0);
        taps.present = s.present && s.marks.live && bx < right.width && by < right.height &&
                       ry >= y - (P.store_rows / 2 - 2) && by <= y + settings.lookahead;
        taps.mask = taps.present && s.mapped;
        const auto pixel = [&](int px, int py) { return u<8>(right.pixels[py * right.stride + px]); };
        if (taps.present) {
          taps.p00 = pixel(rx, ry);
          if (s.wx != 0) taps.p01 = pixel(bx, ry);
          if (s.wy != 0) taps.p10 = pixel(rx, by);
          if (s.wx != 0 && s.wy != 0) taps.p11 = pixel(bx, by);
          const int pair = x - x % P.subsample;  // their mean comes for both
          int sum = 0;
          for (int i = 0; i < P.subsample; ++i) sum += left.pixels[y * left.stride + pair + i];
          taps.left = u<8>((sum + P.subsample / 2) / P.subsample);
        }
        beat(taps, states, found);
      }
    }
  }

  void beat(const typename Interpolate<P>::In& taps, std::vector<std::uint8_t>& states,
            std::vector<native::Run>& found) {
    chain.step(taps, [&]<Stage STAGE>(At<STAGE>, const auto& out) {
      if constexpr (STAGE == Stage::align) {
        if (!out.idle) states.push_back(out.state.value());
      } else if constexpr (STAGE == Stage::runs) {
        found.push_back({static_cast<std::uint16_t>(out.row.value()), static_cast<std::uint16_t>(out.start.value()),
                         static_cast<std::uint16_t>(out.end.value()), out.state.value()});
      }
    });
  }

  MapExpand<P> map_expand;
  Chain<P, Rule::thesis> chain;
};

/// Random blobs: texture in some places, none in others, and everything in between.
Picture blobs(std::mt19937& random, int width, int height) {
  std::vector<double> noise(static_cast<std::size_t>(width * height));
  for (double& n : noise) n = static_cast<double>(random() % 1000) / 1000 - 0.5;
  return {width, height, [&](int x, int y) {
            const double strength = 60 * (1 + std::sin(x / 17.0) * std::cos(y / 13.0));
            return 128 + strength * noise[static_cast<std::size_t>(y * width + x)];
          }};
}

Picture moved(const Picture& p, int dx) {
  return {p.width, p.height, [&](int x, int y) {
            return static_cast<double>(
                p.pixels[static_cast<std::size_t>(y * p.width + std::clamp(x - dx, 0, p.width - 1))]);
          }};
}

template <hls::Profile P>
void check_against_beats(unsigned seed) {
  std::mt19937 random(seed);
  const auto pipeline = std::make_unique<native::Pipeline<P>>();
  const auto beats = std::make_unique<BeatByBeat<P>>();
  int seen[4] = {};
  for (int repetition = 0; repetition < 6; ++repetition) {
    const int width = repetition % 2 == 0 ? P.width : P.width - 16;
    const int height = repetition % 3 == 0 ? P.height : P.height - 7;
    const Picture left = blobs(random, width, height);
    const Picture right = moved(left, repetition % 3);
    auto settings = native::Settings::defaults(P, width, height).without_proof();
    settings.lookahead = static_cast<int>(random() % (P.store_rows / 2 + 1));
    const int nx = static_cast<int>(random() % 5);
    const int ny = static_cast<int>(random() % 5);
    const auto spans = repetition % 3 == 1 ? spans_of(width, height, random) : std::vector<hls::table::Span>();
    const auto words = table_of(
        width, height, nx, ny,
        [&](int x, int y) -> std::optional<reference::Point> {
          if (repetition == 5 && (x / 32 + y / 16) % 5 == 0) return std::nullopt;
          return reference::Point{x + 1.2 + 0.02 * y, y * 0.97 + 1 - 0.01 * x};
        },
        spans);
    const native::TableView table(words);
    for (int y = 0; y < height; ++y) {
      REQUIRE(table.span(y) == (spans.empty() ? hls::table::Span{0, width} : spans[static_cast<std::size_t>(y)]));
    }
    const auto result = pipeline->process(left.view(), right.view(), table, settings);
    std::vector<std::uint8_t> states;
    std::vector<native::Run> runs;
    if (repetition == 3) {  // what was in the pipeline before must not matter: half a frame of rubbish, then a reset
      for (int i = 0; i < 20 * width + 13; ++i) {
        typename Interpolate<P>::In in;
        in.p00 = in.left = u<8>(random());
        in.mask = true;
        in.marks = {i == 0, i % width == width - 1};
        std::vector<std::uint8_t> ignored;
        std::vector<native::Run> ignored_runs;
        beats->beat(in, ignored, ignored_runs);
      }
      hls::reset(*beats);
    }
    beats->frame(left.view(), right.view(), table, settings, states, runs, random);
    REQUIRE(result.states == states);
    REQUIRE(result.runs == runs);
    for (const std::uint8_t s : states) ++seen[s];
    REQUIRE(result.skin_pixels == std::count(states.begin(), states.end(), state::skin));
  }
  for (const int count : seen) CHECK(count > 0);
}

template <hls::Profile P>
int count_in_middle(const native::FrameResult& result, int which) {
  int count = 0;
  for (int y = 2 * P.offset(); y < result.height - 2 * P.offset(); ++y) {
    for (int x = 2 * P.offset(); x < result.width - 2 * P.offset(); ++x) {
      count += result.states[static_cast<std::size_t>(y * result.width + x)] == which;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("the engine, row by row, does what the stages do beat by beat", "[pipeline]") {
  check_against_beats<kPlain>(31);
  check_against_beats<kHalving>(32);
}

TEST_CASE("states against the double-precision reference", "[pipeline]") {
  std::mt19937 random(33);
  const auto pipeline = std::make_unique<native::Pipeline<kWide>>();
  const auto settings = [] {
    auto s = native::Settings::defaults(kWide, 160, 120).without_proof();
    s.lookahead = 32;
    return s;
  }();
  int pixels = 0;
  int different = 0;
  int border_different = 0;
  int seen[4] = {};
  for (int repetition = 0; repetition < 6; ++repetition) {
    const Picture left = blobs(random, 160, 120);
    const Picture right = moved(left, 2 + repetition % 3);
    const Map map = [&](int x, int y) { return reference::Point{x + 2 + (x - 80) / 60.0, y + (x - y) / 200.0}; };
    const auto words = table_of(160, 120, 3, 3, map);
    const auto result = pipeline->process(left.view(), right.view(), native::TableView(words), settings);
    reference::Decision decision;
    const auto exact = reference::decide(
        left.exact(), reference::warp(right.exact(), 160, 120, [&](int x, int y) { return map(x, y); }), decision);
    for (std::size_t i = 0; i < result.states.size(); ++i) {
      ++seen[exact.states[i]];
      ++pixels;
      different += result.states[i] != exact.states[i];
      border_different += (result.states[i] == state::unsupervised) != (exact.states[i] == reference::unsupervised);
    }
  }
  CAPTURE(pixels, different, border_different);
  for (const int count : seen) REQUIRE(count > pixels / 50);
  REQUIRE(different <= pixels * 3 / 100);
  REQUIRE(border_different <= pixels / 200);  // a coordinate on the image's edge, rounded to 1/8 px
}

TEST_CASE("a ramp of brightness is undecidable, edges of a chessboard are not", "[pipeline]") {
  const auto pipeline = std::make_unique<native::Pipeline<kWide>>();
  auto settings = native::Settings::defaults(kWide, 160, 120).without_proof();
  settings.lookahead = 32;
  const auto words = table_of(160, 120, 4, 4, shifted(0, 0));
  const auto run = [&](const Picture& left, const Picture& right) {
    return pipeline->process(left.view(), right.view(), native::TableView(words), settings);
  };
  std::mt19937 random(34);
  // On a ramp of 4.4 grey levels per pixel, above the texture threshold of 4, every hypothesis fits.
  for (const double noise_level : {0.0, 1.0}) {
    for (const double angle : {0.0, 0.4, 1.2, 1.5707963}) {
      std::normal_distribution<double> noise(0, 1);
      const auto along = [angle](int x, int y) { return (x - 80) * std::cos(angle) + (y - 60) * std::sin(angle); };
      const Picture image(160, 120, [&](int x, int y) {
        return 127 + 4.4 * std::clamp(along(x, y), -28.0, 28.0) + noise_level * noise(random);
      });
      const auto result = run(image, image);
      int on_ramp = 0;
      int undecidable = 0;
      for (int y = 18; y < 120 - 18; ++y) {
        for (int x = 18; x < 160 - 18; ++x) {
          if (std::fabs(along(x, y)) > 14) continue;  // whose windows see nothing but the ramp
          ++on_ramp;
          undecidable += result.states[static_cast<std::size_t>(y * 160 + x)] == state::undecidable;
        }
      }
      CAPTURE(angle, noise_level);
      CHECK(on_ramp > 1000);
      CHECK(undecidable == on_ramp);
    }
  }
  for (const int size : {12, 20, 31}) {
    const Picture board(160, 120, [=](int x, int y) { return (x / size + y / size) % 2 == 0 ? 60.0 : 190.0; });
    const auto result = run(board, board);
    CAPTURE(size);
    // Upright edges decide; along level ones no displacement in x could be noticed, and squares are flat.
    CHECK(count_in_middle<kWide>(result, state::skin) > 160 * 120 / size);
    CHECK(count_in_middle<kWide>(result, state::clear) == 0);
    const auto off = run(board, moved(board, size / 2));
    CHECK(count_in_middle<kWide>(off, state::skin) < count_in_middle<kWide>(result, state::skin) / 5);
  }
}

TEST_CASE("a clipped image is undecidable, in whichever camera", "[pipeline]") {
  std::mt19937 random(35);
  const auto pipeline = std::make_unique<native::Pipeline<kPlain>>();
  const auto settings = native::Settings::defaults(kPlain, 96, 64).without_proof();
  const auto words = table_of(96, 64, 3, 3, shifted(0, 0));
  const Picture good(96, 64, [&](int, int) { return 40 + static_cast<double>(random() % 170); });
  const Picture white(96, 64, [](int, int) { return 255.0; });
  const auto run = [&](const Picture& left, const Picture& right) {
    return pipeline->process(left.view(), right.view(), native::TableView(words), settings);
  };
  CHECK(count_in_middle<kPlain>(run(good, good), state::skin) == (96 - 36) * (64 - 36));
  CHECK(count_in_middle<kPlain>(run(good, white), state::undecidable) == (96 - 36) * (64 - 36));
  CHECK(count_in_middle<kPlain>(run(white, good), state::undecidable) == (96 - 36) * (64 - 36));
}

TEST_CASE("what the table, the image or the ring does not hold is unsupervised", "[pipeline]") {
  std::mt19937 random(36);
  const auto pipeline = std::make_unique<native::Pipeline<kPlain>>();
  auto settings = native::Settings::defaults(kPlain, 96, 64).without_proof();
  const Picture image(96, 64, [&](int, int) { return 40 + static_cast<double>(random() % 170); });
  const auto run = [&](const Map& map) {
    const auto words = table_of(96, 64, 2, 2, map);
    return pipeline->process(image.view(), image.view(), native::TableView(words), settings);
  };
  const auto identity = run(shifted(0, 0));
  // The border of 9 px belongs to no window.
  CHECK(identity.unsupervised_pixels == 96 * 64 - (96 - 18) * (64 - 18));
  CHECK(identity.store_misses == 0);
  CHECK(identity.states[9 * 96 + 9] == state::skin);
  CHECK(identity.states[9 * 96 + 8] == state::unsupervised);
  CHECK(run(shifted(-8, 0)).unsupervised_pixels == 96 * 64 - (96 - 18 - 8) * (64 - 18));
  CHECK(run(shifted(0.5, 0)).unsupervised_pixels == 96 * 64 - (96 - 18 - 1) * (64 - 18));
  CHECK(run([](int, int) { return std::nullopt; }).unsupervised_pixels == 96 * 64);
  settings.lookahead = 4;
  CHECK(run(shifted(0, 4)).store_misses == 0);
  CHECK(run(shifted(0, 4.5)).store_misses == 96 * (64 - 5));
  CHECK(run(shifted(0, -14)).store_misses == 0);
  CHECK(run(shifted(0, -15)).store_misses == 96 * (64 - 15));
  CHECK_THROWS_AS(pipeline->process(Picture(100, 64, [](int, int) { return 0.0; }).view(), image.view(),
                                    native::TableView(table_of(96, 64, 2, 2, shifted(0, 0))), settings),
                  std::invalid_argument);
}
