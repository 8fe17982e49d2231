// SPDX-License-Identifier: Apache-2.0
// Thesis 5.2, Fig. 5.7: the morphological operators side by side, on the binarised sums of two simulated photographs
// with objects in the skin, and on pixels turned over at random.
#include "horopter/study/operators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "horopter/calib/random.hpp"
#include "horopter/study/criteria.hpp"
#include "horopter/study/simulation.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

constexpr int kWidth_px = 320;
constexpr int kHeight_px = 240;
constexpr int kMargin = 12;       ///< what windows and operators reach beyond the image
constexpr double kBehind_px = 3;  ///< disparity of what is not in the skin
constexpr double kNoise_grey = 5;
constexpr int kKernel = 5;
constexpr double kThreshold = 0.25;  ///< of the largest sum
constexpr double kSurely = 0.20;     ///< the strict threshold of the hysteresis
constexpr double kStep = 0.05;       ///< of the share of pixels turned over; the first of them are isolated pixels

/// What is in the skin: a body, bars of 2 to 24 px, and dots.
Image objects() {
  Image truth(kWidth_px, kHeight_px);
  const auto fill = [&](int x0, int y0, int width, int height) {
    for (int y = y0; y < y0 + height; ++y) {
      for (int x = x0; x < x0 + width; ++x) truth.at(x, y) = 1;
    }
  };
  for (int y = 0; y < kHeight_px; ++y) {
    for (int x = 0; x < kWidth_px; ++x) {
      const double u = (x - 90) / 55.0;
      const double v = (y - 120) / 80.0;
      if (u * u + v * v < 1) truth.at(x, y) = 1;
    }
  }
  int left = 165;
  for (const int width : {24, 16, 12, 8, 4, 2}) {
    fill(left, 30, width, 110);
    left += width + 12;
  }
  left = 170;
  for (const int size : {24, 16, 12, 8, 4, 2}) {
    fill(left, 175, size, size);
    left += size + 12;
  }
  return truth;
}

/// The hardware's sums of a pair whose objects are in the skin.
study::Plane sums(const Image& truth, std::uint64_t seed) {
  study::Conditions conditions;
  conditions.camera.width = kWidth_px;
  conditions.camera.height = kHeight_px;
  conditions.electronics = {.noise_grey = kNoise_grey, .averaged = 1};
  conditions.seed = seed;
  const study::Simulation simulation(conditions, kBehind_px);
  const Image left = simulation.photograph(0, 0);
  Image right = simulation.photograph(kBehind_px, 1);
  const Image in_skin = simulation.photograph(0, 2);
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    if (truth.pixels[i] == 1) right.pixels[i] = in_skin.pixels[i];
  }
  const study::Preparation camera{study::Feature::camera};
  const study::Plane r = study::prepare(left, camera);
  const study::Plane s = study::prepare(right, camera);
  study::Pair pair(r, s);
  pair.set_kernel(kKernel);
  return study::criterion("hardware").compare(pair);
}

struct Score {
  double wrong = 0, missed = 0, false_alarms = 0;  ///< shares: of all pixels, of objects, of the rest
  int clusters = 0, holes = 0;                     ///< connected pixels in the skin, and within it
};

int components(const Image& image, int value) {
  cv::Mat binary(image.height, image.width, CV_8U);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) binary.at<std::uint8_t>(y, x) = image.at(x, y) == value ? 1 : 0;
  }
  cv::Mat labels;
  return cv::connectedComponents(binary, labels, value == 1 ? 8 : 4) - 1;
}

Score score(const Image& result, const Image& truth) {
  std::array<double, 4> counts{};  // [truth][result]
  Image inner(kWidth_px - 2 * kMargin, kHeight_px - 2 * kMargin);
  for (int y = kMargin; y < kHeight_px - kMargin; ++y) {
    for (int x = kMargin; x < kWidth_px - kMargin; ++x) {
      counts[static_cast<std::size_t>(2 * truth.at(x, y) + result.at(x, y))] += 1;
      inner.at(x - kMargin, y - kMargin) = result.at(x, y);
    }
  }
  const auto [clear, alarmed, missed, found] = counts;
  return {(alarmed + missed) / (clear + alarmed + missed + found), missed / (missed + found),
          alarmed / (clear + alarmed), components(inner, 1), components(inner, 0) - 1};
}

struct Named {
  std::string name;
  Image image;  ///< 0 and 1
};

/// Pictures with their names, four in a row.
Image gallery(const std::vector<Named>& pictures) {
  constexpr int kColumns = 4;
  constexpr int kGap = 8;
  constexpr int kLabel = 18;
  const int rows = (static_cast<int>(pictures.size()) + kColumns - 1) / kColumns;
  Image page(kColumns * (kWidth_px + kGap) + kGap, rows * (kHeight_px + kLabel + kGap) + kGap, 255);
  const cv::Mat canvas(page.height, page.width, CV_8U, page.pixels.data());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int left = kGap + static_cast<int>(i) % kColumns * (kWidth_px + kGap);
    const int top = kLabel + static_cast<int>(i) / kColumns * (kHeight_px + kLabel + kGap);
    cv::putText(canvas, pictures[i].name, {left, top - 5}, cv::FONT_HERSHEY_SIMPLEX, 0.42, cv::Scalar(0), 1);
    for (int y = 0; y < kHeight_px; ++y) {
      for (int x = 0; x < kWidth_px; ++x) page.at(left + x, top + y) = pictures[i].image.at(x, y) == 1 ? 255 : 0;
    }
  }
  return page;
}

/// Similarity, so that larger is more in the skin, as the hysteresis has it; 0 where windows leave the image.
study::Plane similarity(const study::Plane& sum) {
  const double largest = study::criterion("hardware").worst(kKernel);
  study::Plane result = sum;
  for (int y = 0; y < kHeight_px; ++y)
    for (int x = 0; x < kWidth_px; ++x) {
      const bool inside = std::min({x, y, kWidth_px - 1 - x, kHeight_px - 1 - y}) >= kKernel / 2 + 2;
      result.at(x, y) = inside ? 1 - sum.at(x, y) / largest : 0;
    }
  return result;
}

/// The operators on a noisy pair, Fig. 5.7.
void compare_operators(StudyReport& report, const Image& truth, const study::Plane& alike) {
  Image binary(kWidth_px, kHeight_px);
  for (std::size_t i = 0; i < binary.pixels.size(); ++i) binary.pixels[i] = alike.values[i] >= 1 - kThreshold ? 1 : 0;
  Csv table({"operator", "wrong", "missed", "false_alarms", "clusters", "holes"});
  std::vector<Named> pictures{{"truth", truth}};
  const auto add = [&](const std::string& name, const Image& image) {
    const Score s = score(image, truth);
    table.row(name, s.wrong, s.missed, s.false_alarms, s.clusters, s.holes);
    report.result["operators"][name] = {{"wrong", s.wrong},
                                        {"missed", s.missed},
                                        {"false_alarms", s.false_alarms},
                                        {"clusters", s.clusters},
                                        {"holes", s.holes}};
    pictures.push_back({fmt::format("{}: {:.1f} % wrong, {} clusters", name, 100 * s.wrong, s.clusters), image});
  };
  add("threshold", binary);
  add("hysteresis", study::hysteresis(alike, 1 - kThreshold, 1 - kSurely));
  for (const study::Operator& op : study::binary_operators()) add(op.name, op.apply(binary, op.size));
  report.table("fig-5-7.csv", table);
  report.picture("fig-5-7.png", "Fig. 5.7: operators on binarised sums of 5×5 pixels of a noisy pair",
                 encode_png(gallery(pictures)));
}

/// The operators on pixels turned over at random.
void turn_over(StudyReport& report, const StudyScope& scope, const Image& truth) {
  Csv table({"turned_over", "operator", "wrong"});
  Panel panel{
      "Pixels turned over at random", "share of pixels turned over", "share of pixels wrong afterwards", {}, true};
  panel.curves.push_back({"threshold", {}});
  for (const study::Operator& op : study::binary_operators()) panel.curves.push_back({op.name, {}});
  const int runs = scope.quick ? 1 : 5;
  for (int step = 1; step <= 9; ++step) {
    const double share = kStep * step;
    std::vector<double> wrong(panel.curves.size());
    for (int run = 0; run < runs; ++run) {
      calib::Random random(scope.seed, static_cast<std::uint64_t>(100 * step + run));
      Image noisy = truth;
      for (auto& pixel : noisy.pixels) pixel = static_cast<std::uint8_t>(random.uniform() < share ? 1 - pixel : pixel);
      wrong[0] += score(noisy, truth).wrong / runs;
      for (std::size_t i = 1; i < wrong.size(); ++i) {
        const study::Operator& op = study::binary_operators()[i - 1];
        wrong[i] += score(op.apply(noisy, op.size), truth).wrong / runs;
      }
    }
    for (std::size_t i = 0; i < wrong.size(); ++i) {
      Curve& curve = panel.curves[i];
      table.row(share, curve.name, wrong[i]);
      curve.points.emplace_back(share, wrong[i]);
      report.result["turned_over"][curve.name].push_back(wrong[i]);
    }
  }
  report.table("operators-noise.csv", table);
  report.plot("operators-noise.svg", "Operators of 5.2 on pixels turned over at random", {panel}, 1);
}

}  // namespace

void study_operators(StudyReport& report, const StudyScope& scope) {
  const Image truth = objects();
  const int true_clusters = score(truth, truth).clusters;
  report.result["conditions"] = {{"kernel", kKernel},           {"noise_grey", kNoise_grey},
                                 {"background_px", kBehind_px}, {"threshold", kThreshold},
                                 {"isolated_share", kStep},     {"true_clusters", true_clusters}};
  compare_operators(report, truth, similarity(sums(truth, scope.seed)));
  turn_over(report, scope, truth);

  using namespace measured;
  const nlohmann::json& of = report.result["operators"];
  const auto wrong = [&](const char* name) { return 100 * of.at(name).at("wrong").get<double>(); };
  const auto isolated = [&](const char* name) {
    return 100 * report.result["turned_over"].at(name).at(0).get<double>();
  };
  const auto better = [](const auto& share, const char* name) {
    return std::min(share("opening 3x3"), share("closing 3x3")) / share(name);
  };
  const auto figure = [](const auto& share) {
    return fmt::format("majority {:.2f} %, clusterlets {:.2f} %, opening {:.2f} %, closing {:.2f} %, none {:.2f} %",
                       share("majority 3x3"), share("clusterlets 3x3"), share("opening 3x3"), share("closing 3x3"),
                       share("threshold"));
  };
  const std::string found =
      fmt::format("Wrong pixels, 3×3 (e = 2). Noisy pair of Fig. 5.7: {}. Isolated pixels, {:.0f} % turned over: {}",
                  figure(wrong), 100 * kStep, figure(isolated));
  report.state("5.2",
               {{"The majority decision produces better results than opening and closing.",
                 {better(wrong, "majority 3x3"), better(isolated, "majority 3x3"), found},
                 "{2}",
                 "Fewer wrong pixels than both, on the pair and on isolated pixels; partly: on one of these",
                 {first > 1 && second > 1, first > 1 || second > 1},
                 "the majority decision is better than opening and closing"},
                {"Clusterlet elimination performs much better than opening and closing.",
                 {better(wrong, "clusterlets 3x3"), better(isolated, "clusterlets 3x3"), found},
                 "{2}",
                 "A fifth fewer wrong pixels than both, on the pair and on isolated pixels; partly: on one of these",
                 {first > 1.25 && second > 1.25, first > 1.25 || second > 1.25},
                 "the elimination of clusterlets is much better than opening and closing"}});
  std::string best = "threshold";
  for (const auto& [name, one] : of.items())
    if (wrong(name.c_str()) < wrong(best.c_str())) best = name;
  report.finding(
      "Threshold alone: {:.1f} % of the pixels wrong, {} clusters of {} true ones; least wrong: {}, {:.1f} %",
      wrong("threshold"), of["threshold"]["clusters"].get<int>(), true_clusters, best, wrong(best.c_str()));
  report.finding("3x3: majority {:.1f} %, clusterlets {:.1f} %, opening {:.1f} %, closing {:.1f} % wrong",
                 wrong("majority 3x3"), wrong("clusterlets 3x3"), wrong("opening 3x3"), wrong("closing 3x3"));
}

}  // namespace horopter::cli
