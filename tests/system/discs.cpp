// SPDX-License-Identifier: Apache-2.0
// Bodies of a known size on the skin, textured and plain: what of them is one object, for both rules (docs/use.md, "The
// limits").
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <random>
#include <vector>

#include "horopter/hls/table_format.hpp"
#include "stages/engine.hpp"

using namespace horopter;

namespace {

constexpr int kWidth = 320, kHeight = 240;
constexpr int kDiscs = 25;  // of each size

/// What `horopter plan capability` takes for granted.
struct DiscShare {
  int diameter_px;
  double thesis, compete;
};
constexpr auto kTable = std::to_array<DiscShare>({
#define DISC(diameter_px, thesis, compete) {diameter_px, thesis, compete},
#include "../../host/include/horopter/machine/disc_table.def"
#undef DISC
});

struct Picture {
  std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(std::size_t{kWidth} * kHeight);
  std::uint8_t& at(int x, int y) { return pixels[static_cast<std::size_t>(y * kWidth + x)]; }
  [[nodiscard]] native::ImageView view() const { return {pixels.data(), kWidth, kHeight, kWidth}; }
};

/// Squares of three sizes on top of each other, and noise of a camera.
Picture textured(std::mt19937& random) {
  Picture picture;
  std::vector<int> sum(picture.pixels.size());
  std::uniform_int_distribution<int> grey(-38, 38), noise(-2, 2);
  for (const int size : {3, 7, 16}) {
    std::vector<int> squares(static_cast<std::size_t>((kWidth / size + 1) * (kHeight / size + 1)));
    for (int& square : squares) square = grey(random);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        sum[static_cast<std::size_t>(y * kWidth + x)] +=
            squares[static_cast<std::size_t>(y / size * (kWidth / size + 1) + x / size)];
      }
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    picture.pixels[i] = static_cast<std::uint8_t>(std::clamp(128 + sum[i] + noise(random), 1, 254));
  }
  return picture;
}

}  // namespace

TEST_CASE("a textured disc on the skin is an object of at least half its area") {
  const auto engine = native::make_engine("vga");
  const auto table = hls::table::write({kWidth, kHeight, 4, 4}, {}, [](int column, int row) {
    return hls::table::encode_control(column * 16, row * 16);
  });
  std::mt19937 random(5);
  std::vector<std::array<double, 2>> measured(kTable.size());
  for (const bool compete : {false, true}) {
    for (std::size_t row = 1; row < kTable.size(); ++row) {
      const int diameter_px = kTable[row].diameter_px;
      auto settings = native::Settings::defaults(engine->profile(), kWidth, kHeight).without_proof();
      settings.compete = compete ? 1 : 0;
      const double half = std::numbers::pi / 8 * diameter_px * diameter_px;
      settings.object_limit = static_cast<int>(half);
      double least = 2, most_elsewhere = 0;
      for (int n = 0; n < kDiscs; ++n) {
        Picture left = textured(random);
        const Picture right = textured(random);
        const auto free = [&](int size) {
          return std::uniform_int_distribution<int>(diameter_px / 2 + 24, size - diameter_px / 2 - 24)(random);
        };
        const int centre_x = free(kWidth), centre_y = free(kHeight);
        const auto empty = engine->process(left.view(), right.view(), native::TableView(table), settings);
        most_elsewhere = std::max(most_elsewhere, empty.largest_object().pixels / half);
        for (int y = 0; y < kHeight; ++y) {
          for (int x = 0; x < kWidth; ++x) {
            if (std::hypot(x - centre_x, y - centre_y) <= diameter_px / 2.0) {
              const int noisy =
                  right.pixels[static_cast<std::size_t>(y * kWidth + x)] + static_cast<int>(random() % 5) - 2;
              left.at(x, y) = static_cast<std::uint8_t>(std::clamp(noisy, 1, 254));
            }
          }
        }
        const auto result = engine->process(left.view(), right.view(), native::TableView(table), settings);
        const int largest = result.largest_object().pixels;
        least = std::min(least, largest / (2 * half));
        CAPTURE(compete, diameter_px, n, largest);
        CHECK(result.alarm);
      }
      std::printf("%s, %3d px: at least %.2f of the disc; without it at most %.2f of the limit\n",
                  compete ? "compete" : "thesis", diameter_px, least, most_elsewhere);
      measured[row][compete ? 1 : 0] = std::min(least, 1.0);  // a rule may add to its edge
      CHECK(least >= (compete ? kTable[row].compete : kTable[row].thesis));
      CHECK(least > 0.5);
    }
  }
  std::printf("host/include/horopter/machine/disc_table.def:\n");
  CHECK(kTable[0].thesis + kTable[0].compete == 0);  // as large as the windows
  for (std::size_t row = 0; row < kTable.size(); ++row) {
    const auto [thesis, compete] = measured[row];
    std::printf("DISC(%d, %.2f, %.2f)\n", kTable[row].diameter_px, std::floor(100 * thesis) / 100,
                std::floor(100 * compete) / 100);
  }
}

TEST_CASE("a plain disc before a textured background is an object where the empty zone was taught") {
  constexpr int kBehind_px = 14;  // shift of the background against the skin
  const auto engine = native::make_engine("vga");
  const auto table = hls::table::write({kWidth, kHeight, 4, 4}, {}, [](int column, int row) {
    return hls::table::encode_control(column * 16, row * 16);
  });
  std::mt19937 random(7);
  const auto noisy = [&](int grey) {
    return static_cast<std::uint8_t>(std::clamp(grey + static_cast<int>(random() % 5) - 2, 1, 254));
  };
  for (const bool compete : {false, true}) {
    for (const int diameter_px : {40, 72, 100}) {
      auto settings = native::Settings::defaults(engine->profile(), kWidth, kHeight).without_proof();
      settings.compete = compete ? 1 : 0;
      const double half = std::numbers::pi / 8 * diameter_px * diameter_px;
      settings.object_limit = static_cast<int>(half);
      double least = 2, most_without = 0, most_empty = 0;
      int alarms_without = 0;
      for (int n = 0; n < 8; ++n) {
        Picture background = textured(random);
        const auto free = [&](int size) {
          return std::uniform_int_distribution<int>(diameter_px / 2 + 24, size - diameter_px / 2 - 24)(random);
        };
        const int centre_x = free(kWidth), centre_y = free(kHeight),
                  grey = std::uniform_int_distribution(20, 235)(random);
        const auto look = [&](bool body) {
          Picture left, right;
          for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
              const bool inside = body && std::hypot(x - centre_x, y - centre_y) <= diameter_px / 2.0;
              left.at(x, y) = noisy(inside ? grey : background.at(x, y));
              right.at(x, y) = noisy(inside ? grey : background.at(std::min(x + kBehind_px, kWidth - 1), y));
            }
          }
          return engine->process(left.view(), right.view(), native::TableView(table), settings);
        };
        settings.watch = settings.teach = 0;
        const auto untaught = look(true);
        most_without = std::max(most_without, untaught.largest_object().pixels / (2 * half));
        alarms_without += untaught.alarm ? 1 : 0;
        settings.teach = 1;
        for (int frame = 0; frame < 5; ++frame) look(false);
        settings.teach = 0;
        settings.watch = 1;
        for (int frame = 0; frame < 5; ++frame) {
          const auto empty = look(false);
          most_empty = std::max(most_empty, empty.largest_object().pixels / half);
          CHECK_FALSE(empty.alarm);
        }
        const auto result = look(true);
        const int largest = result.largest_object().pixels;
        least = std::min(least, largest / (2 * half));
        CAPTURE(compete, diameter_px, n, grey, largest, result.blind_pixels);
        CHECK(result.alarm);
      }
      std::printf(
          "%s, %3d px, plain: at least %.2f of the disc; not taught at most %.2f, an alarm in %d of 8; empty at most %.2f of the "
          "limit\n",
          compete ? "compete" : "thesis", diameter_px, least, most_without, alarms_without, most_empty);
      CHECK(least >= 0.5);
      if (!compete) CHECK(alarms_without < 8);
    }
  }
}
