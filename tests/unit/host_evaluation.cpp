// SPDX-License-Identifier: Apache-2.0
// Ground truth: what is read, which pixels count, how answers score.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "horopter/base/error.hpp"
#include "horopter/image/disparity.hpp"
#include "horopter/image/evaluation.hpp"
#include "host_temporary.hpp"

namespace horopter {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// Disparity 2 everywhere, a block of `near_px` in it.
DisparityMap scene(int width, int height, int x0, int y0, int x1, int y1, float near_px) {
  DisparityMap map{width, height, std::vector<float>(static_cast<std::size_t>(width) * height, 2)};
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) map.px[static_cast<std::size_t>(y) * width + x] = near_px;
  }
  return map;
}

std::string pfm(int width, int height, const char* scale, const std::vector<float>& rows_from_below) {
  std::string text = "Pf\n" + std::to_string(width) + " " + std::to_string(height) + "\n" + scale + "\n";
  const bool little = scale[0] == '-';
  for (const float value : rows_from_below) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int i = 0; i < 4; ++i) text += static_cast<char>(bits >> 8 * (little ? i : 3 - i));
  }
  return text;
}

}  // namespace

TEST_CASE("Disparities are read from PFM of both byte orders, rows from below") {
  const TemporaryDirectory directory;
  const float infinite = std::numeric_limits<float>::infinity();
  for (const char* scale : {"-1", "1.0"}) {
    const auto map = load_disparity(directory.write("d.pfm", pfm(2, 2, scale, {1.5F, infinite, 0, 3})), 1);
    CHECK(std::isnan(map.at(0, 0)));
    CHECK(map.at(1, 0) == 3);
    CHECK(map.at(0, 1) == 1.5F);
    CHECK(std::isnan(map.at(1, 1)));
  }
}

TEST_CASE("Disparities are read from PNG and PGM of 8 and 16 bits, 0 is unknown") {
  const TemporaryDirectory directory;
  for (const std::string name : {"d.png", "d.pgm"}) {
    cv::imwrite((directory / name).string(), cv::Mat((cv::Mat_<std::uint8_t>(1, 2) << 0, 40)));
    const auto narrow = load_disparity(directory / name, 16);
    CHECK(std::isnan(narrow.at(0, 0)));
    CHECK(narrow.at(1, 0) == 2.5F);
    cv::imwrite((directory / name).string(), cv::Mat((cv::Mat_<std::uint16_t>(1, 2) << 0, 25600)));
    const auto wide = load_disparity(directory / name, 256);
    CHECK(std::isnan(wide.at(0, 0)));
    CHECK(wide.at(1, 0) == 100);
  }
}

TEST_CASE("Bad disparity files are refused") {
  const TemporaryDirectory directory;
  const std::string good = pfm(2, 2, "-1", {1, 2, 3, 4});
  cv::imwrite((directory / "wide.pgm").string(), cv::Mat_<std::uint16_t>(4, 4, 300));
  cv::imwrite((directory / "colour.png").string(), cv::Mat(4, 4, CV_8UC3, cv::Scalar(1, 2, 3)));
  const std::string wide = [&] {
    const auto bytes = bytes_of(directory / "wide.pgm");
    return std::string(bytes.begin(), bytes.end());
  }();
  const auto error_of = [&](const std::filesystem::path& path) {
    try {
      load_disparity(path, 1);
    } catch (const FileError& error) {
      CHECK_THAT(error.what(), Catch::StartsWith(path.string() + ": ") && Catch::Contains("expected"));
      return std::string(error.what());
    }
    return std::string("no error");
  };
  CHECK_THAT(error_of(directory.write("cut.pfm", good.substr(0, good.size() - 1))), Catch::Contains("truncated"));
  CHECK_THAT(error_of(directory.write("cut.pgm", wide.substr(0, wide.size() - 1))), Catch::Contains("truncated"));
  CHECK_THAT(error_of(directory.write("header.pfm", "Pf\n2 x\n-1\n")), Catch::Contains("'x'"));
  const std::string zeros("Pf\n2 2\0\n-1\n", 11);  // a number that ends in a byte 0
  CHECK_THAT(error_of(directory.write("zeros.pfm", zeros + std::string(16, 'a'))),
             Catch::Contains("in the PFM header"));
  CHECK_THAT(error_of(directory.write("size.pfm", "Pf\n2 -2\n-1\n")), Catch::Contains("-2"));
  CHECK_THAT(error_of(directory.write("none.pfm", pfm(1, 1, "-1", {-3}))), Catch::Contains("no pixel"));
  CHECK_THAT(error_of(directory / "colour.png"), Catch::Contains("3 samples"));
  CHECK_THAT(error_of(directory.write("text.png", "not a picture at all")), Catch::Contains("not a disparity map"));
  CHECK_THAT(error_of(directory / "absent.png"), Catch::Contains("no such file"));
}

TEST_CASE("Resizing takes the nearest disparity, times the factor") {
  DisparityMap map{4, 2, {1, 2, 3, 4, 5, 6, 7, kUnknown}};
  const auto half = resized(map, 0.5, 2, 1);
  CHECK(half.px[0] == 3);
  CHECK(std::isnan(half.px[1]));
}

TEST_CASE("Pixels count where known, right of the margin and not hidden") {
  DisparityMap map = scene(60, 1, 40, 0, 50, 1, 12);
  map.px[55] = kUnknown;
  const GroundTruth truth(map);
  CHECK(truth.largest_px() == 12);
  CHECK(!truth.counts(19));
  CHECK(truth.counts(20));
  CHECK(!truth.counts(55));
  // The block's columns 40 to 49 land on 28 to 37, as columns 30 to 39 of the background do.
  CHECK(truth.counts(29));
  for (std::size_t x = 30; x < 40; ++x) CHECK(!truth.counts(x));
  for (std::size_t x = 40; x < 50; ++x) CHECK(truth.counts(x));
  CHECK(truth.counts(50));
  CHECK(truth.counted() == 40 - 10 - 1);
  // Nearer by no more than 1 px hides nothing.
  const GroundTruth flat(scene(60, 1, 40, 0, 50, 1, 3));
  CHECK(flat.counted() == 60 - 11);
}

TEST_CASE("Pixels outside the mask do not count, but hide others all the same") {
  const DisparityMap map = scene(60, 1, 40, 0, 50, 1, 12);
  std::vector<std::uint8_t> seen(60, 1);
  for (std::size_t x = 40; x < 45; ++x) seen[x] = 0;
  const GroundTruth truth(map, seen);
  for (std::size_t x = 40; x < 45; ++x) CHECK(!truth.counts(x));
  for (std::size_t x = 30; x < 40; ++x) CHECK(!truth.counts(x));
  CHECK(truth.counts(45));
  CHECK(truth.largest_px() == 12);
  CHECK(truth.counted() == 40 - 10 - 5);
  for (std::size_t x = 40; x < 50; ++x) seen[x] = 0;
  CHECK(GroundTruth(map, seen).frequent() == std::vector<double>{2});
}

TEST_CASE("The most frequent disparities, apart from each other") {
  DisparityMap map{100, 10, std::vector<float>(1000, 20)};
  const auto put = [&](int row, float d) { std::fill_n(map.px.begin() + row * 100 + 40, 60, d); };
  for (const int row : {0, 1, 2}) put(row, 10.4F);
  for (const int row : {3, 4}) put(row, 12);  // too near to 10
  put(5, 7);
  const GroundTruth truth(map);
  CHECK(truth.frequent() == std::vector<double>{20, 10, 7});
  CHECK(truth.frequent(2) == std::vector<double>{20, 10});
}

TEST_CASE("Answers are scored by pixel and by object") {
  // A block of 20x20 at 12 px in 100x100: 4 % of the image. Largest disparity 12: columns from 20 on count.
  const GroundTruth truth(scene(100, 100, 60, 10, 80, 30, 12));
  std::vector<Answer> answers(10'000, Answer::clear);
  const auto fill = [&](int x0, int y0, int x1, int y1, Answer answer) {
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) answers[static_cast<std::size_t>(y) * 100 + x] = answer;
    }
  };
  const Score nothing = score(truth, 12, 1, answers);
  CHECK(nothing.objects == 1);
  CHECK(nothing.found == 0);
  CHECK(nothing.iou() == 0);
  CHECK(nothing.recall() == 0);
  CHECK(nothing.called_clear_share() == 1);
  CHECK(score(truth, 20, 1, answers).called_clear_share() == 0);

  fill(60, 10, 70, 30, Answer::skin);         // half of the block
  fill(70, 10, 80, 20, Answer::undecidable);  // a quarter of it
  fill(30, 60, 40, 70, Answer::skin);         // 1 % of the image, elsewhere
  fill(90, 90, 93, 93, Answer::skin);         // too small to be an object
  const Score s = score(truth, 12, 1, answers);
  CHECK(s.hits == 200);
  CHECK(s.missed == 200);
  CHECK(s.wrong == 109);
  CHECK(s.undecidable == 100);
  CHECK(s.called_clear == 100);
  CHECK(s.called_clear_share() == Approx(0.25));
  CHECK(s.precision() == Approx(200.0 / 309));
  CHECK(s.recall() == Approx(0.5));
  CHECK(s.iou() == Approx(200.0 / 509));
  CHECK(s.objects == 1);
  CHECK(s.found == 1);
  CHECK(s.false_objects == 1);
  // Within tolerance + 1 px an answer is no false object.
  CHECK(score(truth, 4, 1, answers).false_objects == 1);
  CHECK(score(truth, 13.5, 1, answers).false_objects == 1);
  CHECK(score(truth, 3.5, 1, answers).wrong == 309);
}

}  // namespace horopter
