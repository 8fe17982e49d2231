// SPDX-License-Identifier: Apache-2.0
// The native engine for each set of instructions that this processor has, and with several threads: the same results.
#include "stages/engine.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <thread>
#include <vector>

using namespace horopter;
using native::Instructions;

namespace {

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
  [[nodiscard]] native::ImageView view() const { return {pixels.data(), width, height, width}; }
};

template <class Value>
Picture picture(int width, int height, const Value& value) {
  Picture result{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width * height))};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      result.pixels[static_cast<std::size_t>(y * width + x)] =
          static_cast<std::uint8_t>(std::clamp(std::lround(value(x, y)), 0L, 255L));
    }
  }
  return result;
}

struct Pair {
  Picture left, right;
};

Pair noise(int width, int height, std::mt19937& random) {
  const auto grey = [&](int, int) { return static_cast<double>(random() & 255U); };
  return {picture(width, height, grey), picture(width, height, grey)};
}

/// Textured and plain places, and boxes that stand `shift` columns, or twice as many, off the skin.
Pair scene(int width, int height, int shift, std::mt19937& random) {
  const Pair grain = noise(width, height, random);
  const auto left = [&](int x, int y) {
    const double strength = std::max(0.0, std::sin(x / 31.0) + std::cos(y / 23.0)) / 4;
    const double pattern = 40 * std::sin(x / 6.0 + y / 19.0) * std::cos(y / 8.0) + (x / 24 + y / 16) % 2 * 30;
    return 110 + strength * pattern +
           strength * (grain.left.pixels[static_cast<std::size_t>(y * width + x)] - 128.0) / 2;
  };
  const auto right = [&](int x, int y) {
    const int off = (x / 70 + y / 50) % 3 * shift;
    const double fine = (grain.right.pixels[static_cast<std::size_t>(y * width + x)] % 5) - 2.0;
    return left(std::clamp(x + off, 0, width - 1), y) + fine;
  };
  return {picture(width, height, left), picture(width, height, right)};
}

struct Frame {
  Pair images;
  std::vector<std::uint32_t> table;
  native::Settings settings;
};

/// Several frames, of two sizes; the rule and what has to be proved change too.
std::vector<Frame> frames_of(const hls::Profile& profile, std::mt19937& random) {
  std::vector<Frame> frames;
  const int largest_width = std::min(profile.width, 756);
  const int largest_height = std::min(profile.height, 290);
  for (const bool small : {false, true}) {
    const int width = small ? 322 : largest_width;
    const int height = small ? 163 : largest_height;
    for (const bool compete : {false, true}) {
      if (!profile.has(compete ? hls::Rule::compete : hls::Rule::thesis)) continue;
      for (int n = 0; n < 4; ++n) {
        Frame frame;
        frame.images = n == 2 ? noise(width, height, random) : scene(width, height, n == 0 ? 4 : 11, random);
        if (n == 3) frame.images = frames.back().images;  // frozen
        const double dx = n == 1 ? 3.4 : -0.625;
        const hls::table::Geometry geometry{width, height, 3, 3};
        hls::table::Facts facts;
        facts.subsample = profile.subsample;
        if (n != 2) facts.areas.resize(facts.area_count(geometry));
        for (std::uint8_t& code : facts.areas) code = static_cast<std::uint8_t>(random() & 0xFFU);
        frame.table = hls::table::write(geometry, facts, [&](int column, int row) {
          if (n == 1 && column + row < 9) return hls::table::unmapped;
          return hls::table::encode_control(column * 8 + dx + row * 0.05, row * 8 + 0.375);
        });
        frame.settings = native::Settings::defaults(profile, width, height);
        frame.settings.compete = compete ? 1 : 0;
        frame.settings.frozen_limit = 1;
        if (small && n == 0) frame.settings = frame.settings.without_proof();
        if (small) {
          frame.settings.teach = n == 0 ? 1 : 0;
          frame.settings.dim = n == 1 ? 1 : 0;
          frame.settings.watch = 1;
        }
        frames.push_back(std::move(frame));
      }
    }
  }
  return frames;
}

}  // namespace

TEST_CASE("engine: the same results for all instructions and any number of threads") {
  const std::string profile = GENERATE("field", "vga", "hd");
  std::mt19937 random(19);
  const auto reference = native::make_engine(profile, 1, Instructions::baseline);
  const auto frames = frames_of(reference->profile(), random);
  std::vector<native::FrameResult> expected;
  expected.reserve(frames.size());
  for (const Frame& frame : frames) {
    expected.push_back(reference->process(frame.images.left.view(), frame.images.right.view(),
                                          native::TableView(frame.table), frame.settings));
  }

  // Not all of it for nothing: every state, objects, and something explained.
  for (const std::uint8_t state : {0, 1, 2, 3}) {
    CHECK(std::any_of(expected.begin(), expected.end(), [&](const native::FrameResult& result) {
      return std::count(result.states.begin(), result.states.end(), state) > 100;
    }));
  }
  CHECK(std::any_of(expected.begin(), expected.end(), [](const auto& result) { return result.objects.size() > 2; }));
  CHECK(std::any_of(expected.begin(), expected.end(), [](const auto& r) { return r.agreement.explained_cells > 50; }));
  CHECK(std::any_of(expected.begin(), expected.end(), [](const auto& result) { return result.left.frozen; }));
  CHECK(std::any_of(expected.begin(), expected.end(), [](const auto& result) { return result.blind_pixels > 100; }));

  for (const Instructions instructions : native::available_instructions()) {
    for (const int threads : {1, 2, 3, 9}) {
      const auto engine = native::make_engine(profile, threads, instructions);
      for (std::size_t i = 0; i < frames.size(); ++i) {
        INFO(profile << ", " << native::name_of(instructions) << ", " << threads << " threads, frame " << i);
        const auto result = engine->process(frames[i].images.left.view(), frames[i].images.right.view(),
                                            native::TableView(frames[i].table), frames[i].settings);
        REQUIRE(result.states == expected[i].states);
        REQUIRE(result.runs == expected[i].runs);
        REQUIRE(result.objects == expected[i].objects);
        REQUIRE(result.agreement == expected[i].agreement);
        REQUIRE((result == expected[i]));
      }
    }
  }
}

TEST_CASE("engine: a table is expanded once, or before its first frame") {
  std::mt19937 random(29);
  const auto engine = native::make_engine("vga");
  const auto frames = frames_of(engine->profile(), random);
  const auto process = [&](const Frame& frame) {
    return engine->process(frame.images.left.view(), frame.images.right.view(), native::TableView(frame.table),
                           frame.settings);
  };
  Frame frame = frames[0];
  REQUIRE(frames[1].table != frame.table);
  process(frame);
  process(frame);
  CHECK(engine->frames_that_expanded() == 1);
  engine->prepare(native::TableView(frames[1].table), frames[1].settings.lookahead);
  process(frames[1]);
  CHECK(engine->frames_that_expanded() == 1);
  process(frame);
  CHECK(engine->frames_that_expanded() == 1);
  frame.settings.lookahead -= 1;
  process(frame);
  CHECK(engine->frames_that_expanded() == 2);

  const auto large = hls::table::write({1280, 720, 6, 6}, {}, [](int, int) { return hls::table::unmapped; });
  CHECK_THROWS_AS(engine->prepare(native::TableView(large), 8), std::invalid_argument);
}

TEST_CASE("engine: one thread, or two for frames that do not wait, unless the environment says how many") {
  const char* const before = std::getenv("HOROPTER_THREADS");
  const std::string restored = before == nullptr ? "" : before;
  ::unsetenv("HOROPTER_THREADS");
  CHECK(native::make_engine("vga")->threads() == 1);
  CHECK(native::make_engine("vga", native::threads_live)->threads() ==
        std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 2));
  ::setenv("HOROPTER_THREADS", "3", 1);
  CHECK(native::make_engine("vga")->threads() == 3);
  CHECK(native::make_engine("vga", native::threads_live)->threads() == 3);
  CHECK(native::make_engine("vga", 2)->threads() == 2);
  ::setenv("HOROPTER_THREADS", "17", 1);
  CHECK_THROWS_WITH(native::make_engine("vga", native::threads_live), Catch::Contains("17, not 1 to 16"));
  ::setenv("HOROPTER_THREADS", restored.c_str(), 1);
}

TEST_CASE("engine: objects are those of one step a pixel") {
  constexpr hls::Profile kProfile = hls::profiles::vga;
  using Finder = stages::Objects<kProfile>;
  std::mt19937 random(23);
  const auto engine = native::make_engine("vga");
  std::size_t objects = 0;
  Finder finder;
  for (Frame frame : frames_of(kProfile, random)) {
    frame.settings.watch = frame.settings.teach = 0;
    const auto result = engine->process(frame.images.left.view(), frame.images.right.view(),
                                        native::TableView(frame.table), frame.settings);
    std::vector<native::Object> found;
    const typename Finder::Config config{typename Finder::Count(frame.settings.object_limit),
                                         frame.settings.object_area_limit};
    const native::TableView table(frame.table);
    const auto code_at = [&](int x, int y) {
      const int columns = (result.width + 31) / 32;
      return table.areas().empty() ? std::uint8_t{hls::table::unknown_area}
                                   : table.areas()[static_cast<std::size_t>(y / 32 * columns + x / 32)];
    };
    typename Finder::Out out;
    const auto step = [&](const typename Finder::In& in) {
      out = finder.step(in, config);
      if (!out.ended) return;
      const auto& o = out.object;
      found.push_back({static_cast<int>(o.pixels.value()), static_cast<int>(o.blind.value()), o.area.value(),
                       o.left.value(), o.top.value(), o.right.value(), o.bottom.value(),
                       static_cast<std::int64_t>(o.columns.value()), static_cast<std::int64_t>(o.rows.value())});
    };
    for (int y = 0; y < result.height; ++y) {
      for (int x = 0; x < result.width; ++x) {
        const bool occupied = result.states[static_cast<std::size_t>(y * result.width + x)] == stages::state::skin;
        step({occupied, x == 0 && y == 0, x + 1 == result.width, false, code_at(x, y), false});
      }
    }
    do {
      step({false, false, false, true, 0, false});
    } while (!out.done);
    REQUIRE(result.objects == found);
    REQUIRE(result.object_overflow == out.overflow);
    objects += found.size();
  }
  CHECK(objects > 100);
}

TEST_CASE(
    "engine: a dim frame is that of both images with half of the contrast, and clear takes half as many votes again") {
  const int width = 320, height = 160;
  const std::string profile = GENERATE("field", "vga", "hd");
  const auto engine = native::make_engine(profile);
  std::mt19937 random(29);
  Pair images = scene(width, height, 7, random);
  for (Picture* one : {&images.left, &images.right}) {
    for (std::uint8_t& pixel : one->pixels) pixel = std::clamp<std::uint8_t>(pixel, 1, 254);  // saturated stays so
  }
  Pair half = images;
  for (Picture* one : {&half.left, &half.right}) {
    for (std::uint8_t& pixel : one->pixels) pixel = static_cast<std::uint8_t>(64 + pixel / 2);
  }
  // Whole columns, so that interpolation rounds nothing.
  hls::table::Facts facts;
  facts.subsample = engine->profile().subsample;
  const auto table = hls::table::write({width, height, 3, 3}, facts, [](int column, int row) {
    return hls::table::encode_control(column * 8 - 3, row * 8);
  });
  for (const bool compete : {false, true}) {
    if (compete && !engine->profile().has_compete()) continue;
    auto settings = native::Settings::defaults(engine->profile(), width, height).without_proof();
    settings.compete = compete ? 1 : 0;
    const auto plain = engine->process(images.left.view(), images.right.view(), native::TableView(table), settings);
    settings.dim = 1;
    const auto dim = engine->process(images.left.view(), images.right.view(), native::TableView(table), settings);
    settings.dim = 0;
    settings.clear_quorum += settings.clear_quorum / 2;
    const auto expected = engine->process(half.left.view(), half.right.view(), native::TableView(table), settings);
    if (engine->profile().subsample == 1) CHECK(dim.states == expected.states);  // a mean of two rounds otherwise
    CHECK(dim.undecidable_pixels > plain.undecidable_pixels + 100);
  }
}

TEST_CASE("engine: instructions are chosen by name, and those that are not there are refused") {
  CHECK(native::available_instructions().front() == Instructions::baseline);
  CHECK(native::make_engine("nothing") == nullptr);
  for (const Instructions instructions : {Instructions::avx2, Instructions::avx512}) {
    const auto available = native::available_instructions();
    const bool there = std::find(available.begin(), available.end(), instructions) != available.end();
    if (there) {
      CHECK(native::make_engine("vga", 1, instructions) != nullptr);
    } else {
      CHECK_THROWS_AS(native::make_engine("vga", 1, instructions), std::invalid_argument);
    }
  }
  const char* const before = std::getenv("HOROPTER_INSTRUCTIONS");
  const std::string restored = before == nullptr ? "" : before;
  ::setenv("HOROPTER_INSTRUCTIONS", "baseline", 1);
  CHECK(native::make_engine("vga") != nullptr);
  ::setenv("HOROPTER_INSTRUCTIONS", "mmx", 1);
  CHECK_THROWS_WITH(native::make_engine("vga"), Catch::Contains("mmx"));
  ::setenv("HOROPTER_INSTRUCTIONS", restored.c_str(), 1);
}
