// SPDX-License-Identifier: Apache-2.0
// Thesis 7.3 to 7.5, Table 7.1: ways to sample an image that is scaled (inverse mapping), against exact areas.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "horopter/study/simulation.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using study::Plane;

// ---------------------------------------------------------------- One pixel of the result

double clamped(const Plane& image, int x, int y) {
  return image.at(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
}

double nearest(const Plane& image, double x, double y) {
  return clamped(image, static_cast<int>(std::floor(x + 0.5)), static_cast<int>(std::floor(y + 0.5)));
}

/// Eq. 7.17.
double bilinear(const Plane& image, double x, double y) {
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  const double u = x - x0;
  const double v = y - y0;
  return (1 - v) * ((1 - u) * clamped(image, x0, y0) + u * clamped(image, x0 + 1, y0)) +
         v * ((1 - u) * clamped(image, x0, y0 + 1) + u * clamped(image, x0 + 1, y0 + 1));
}

/// The mean over a square of a side about a place, pixels being squares.
double area(const Plane& image, double x, double y, double side) {
  const auto share = [side](double centre, int pixel) {
    return std::max(0.0, std::min(centre + side / 2, pixel + 0.5) - std::max(centre - side / 2, pixel - 0.5)) / side;
  };
  double sum = 0;
  const int reach = static_cast<int>(std::ceil(side / 2 + 1));
  const int middle_x = static_cast<int>(std::floor(x));
  const int middle_y = static_cast<int>(std::floor(y));
  for (int j = middle_y - reach; j <= middle_y + reach + 1; ++j) {
    const double down = share(y, j);
    if (down == 0) continue;
    for (int i = middle_x - reach; i <= middle_x + reach + 1; ++i) sum += down * share(x, i) * clamped(image, i, j);
  }
  return sum;
}

/// The mean of samples × samples places in that square.
template <class Sample>
double supersampled(const Plane& image, double x, double y, double side, int samples, Sample sample) {
  double sum = 0;
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i)
      sum += sample(image, x + side * ((i + 0.5) / samples - 0.5), y + side * ((j + 0.5) / samples - 0.5));
  return sum / (samples * samples);
}

constexpr int kSamples = 4;  ///< a direction

struct Method {
  const char* name;
  bool blocks, aliases;  ///< by Table 7.1, in inverse mapping
  double (*of)(const Plane& image, double x, double y, double side);
};
constexpr std::array kMethods{
    Method{"point", true, true, [](const Plane& image, double x, double y, double) { return nearest(image, x, y); }},
    Method{"point, interpolated", false, true,
           [](const Plane& image, double x, double y, double) { return bilinear(image, x, y); }},
    Method{"area", true, false, area},
    Method{"supersampling, interpolated", false, false, [](const Plane& image, double x, double y, double side) {
             return supersampled(image, x, y, side, kSamples, bilinear);
           }}};

// ---------------------------------------------------------------- Images

/// The image larger by a scale, `of` of each place; moved by a part of a pixel.
template <class Of>
Plane scaled(const Plane& image, double scale, Of of) {
  constexpr double kOffset_px = 0.37;
  constexpr int kBorder = 4;
  Plane result(static_cast<int>((image.width - 2 * kBorder) * std::min(1.0, scale)),
               static_cast<int>((image.height - 2 * kBorder) * std::min(1.0, scale)));
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x)
      result.at(x, y) = of(kBorder + kOffset_px + x / scale, kBorder + kOffset_px + y / scale);
  return result;
}

double deviation(const Plane& image) {
  double sum = 0;
  double squares = 0;
  for (const double value : image.values) {
    sum += value;
    squares += value * value;
  }
  const auto n = static_cast<double>(image.values.size());
  return std::sqrt(squares / n - sum * sum / (n * n));
}

/// Deviation of the difference, of that of `from`.
double departure(const Plane& image, const Plane& from) {
  Plane difference = image;
  for (std::size_t i = 0; i < difference.values.size(); ++i) difference.values[i] -= from.values[i];
  return deviation(difference) / deviation(from);
}

/// Share of neighbours along the row that have one value.
double equal_neighbours(const Plane& image) {
  double equal = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 1; x < image.width; ++x) equal += std::abs(image.at(x, y) - image.at(x - 1, y)) < 1e-9 ? 1 : 0;
  return equal / (static_cast<double>(image.height) * (image.width - 1));
}

std::vector<Statement> table_7_1(StudyReport& report, const Plane& source) {
  using namespace measured;
  constexpr double kReduced = 0.35;
  constexpr double kEnlarged = 3;
  constexpr double kAliased = 0.1;  // of the image's deviation
  Csv table({"method", "equal_neighbours_at_3", "departure_from_areas_at_0.35"});
  std::string blocking;
  std::string aliasing;
  int blocks = 0;
  int aliases = 0;
  const auto at_scale = [&](const Method& method, double scale) {
    return scaled(source, scale, [&](double x, double y) { return method.of(source, x, y, 1 / scale); });
  };
  const Plane areas = scaled(source, kReduced, [&](double x, double y) { return area(source, x, y, 1 / kReduced); });
  for (const Method& method : kMethods) {
    const double equal = equal_neighbours(at_scale(method, kEnlarged));
    const double off = departure(at_scale(method, kReduced), areas);
    table.row(method.name, equal, off);
    blocks += (equal > 0.1) == method.blocks ? 1 : 0;
    aliases += (off > kAliased) == method.aliases ? 1 : 0;
    blocking += fmt::format("{}{} {:.0f} %", blocking.empty() ? "" : ", ", method.name, 100 * equal);
    aliasing += fmt::format("{}{} {:.0f} %", aliasing.empty() ? "" : ", ", method.name, 100 * off);
  }
  report.table("table-7-1.csv", table);
  return {
      {"Table 7.1, inverse mapping, scaling > 1: blocking by point and area sampling, none with interpolation.",
       {blocks, kMethods.size(), blocking},
       "Neighbours with one value at a scale of 3: {2}",
       "More than a tenth of the neighbours where the table says blocking, fewer where it says none, for all; partly: "
       "for all but one",
       {first >= second, first >= second + -1},
       "interpolation avoids blocks, supersampling avoids aliasing"},
      {"Table 7.1, inverse mapping, scaling < 1: aliasing by point sampling with and without interpolation, none by area "
       "and supersampling.",
       {aliases, kMethods.size(), aliasing},
       "Off from exact areas at a scale of 0.35, of the image's deviation: {2}",
       "More than 10 % where the table says aliasing, less where it says none, for all; partly: for all but one",
       {first >= second, first >= second + -1}}};
}

/// 7.5: samples in a pixel's square, moved by a part of a pixel, against the bilinear weights.
Statement supersampling_is_bilinear(const Plane& source) {
  using namespace measured;
  constexpr int kMany = 16;
  const Plane interpolated = scaled(source, 1, [&](double x, double y) { return bilinear(source, x, y); });
  const auto off = [&](int samples) {
    return 100 * departure(scaled(source, 1,
                                  [&](double x, double y) { return supersampled(source, x, y, 1, samples, nearest); }),
                           interpolated);
  };
  return {"At a scaling of ≈ 1 supersampling is analogous to bilinear interpolation.",
          {off(kMany), off(2)},
          "Off by {1:.1f} % of the image's deviation with 2×2 samples, by {0:.1f} % with 16×16",
          "At most 2 % with 16×16; partly: 5 %",
          {first <= 2, first <= 5},
          "bilinear interpolation is supersampling where the scale is 1"};
}

// ---------------------------------------------------------------- Weights along a row

/// What all pixels of a result take of each source pixel, by bilinear weights, with the scale as 1.
struct Weights {
  double discarded_percent = 0;  ///< source pixels that nobody takes anything of
  double furthest_percent = 0;   ///< from what each should give
};

Weights weights_of(double scale) {
  constexpr int kSource = 4000;
  std::vector<double> taken(kSource);
  for (int x = 0; x / scale < kSource - 2; ++x) {
    const double place = x / scale;
    const int first = static_cast<int>(place);
    taken[static_cast<std::size_t>(first)] += 1 - (place - first);
    taken[static_cast<std::size_t>(first) + 1] += place - first;
  }
  Weights result;
  for (int i = 10; i < kSource - 10; ++i) {
    const double of_one = taken[static_cast<std::size_t>(i)];
    result.discarded_percent += of_one < 1e-9 ? 100.0 / (kSource - 20) : 0;
    result.furthest_percent = std::max(result.furthest_percent, 100 * std::abs(of_one / scale - 1));
  }
  return result;
}

std::vector<Statement> weights(StudyReport& report) {
  using namespace measured;
  Csv table({"scale", "discarded_percent", "weight_off_by_percent"});
  double most_above = 0;
  double least_below = 100;
  for (const double scale : {0.3, 0.4, 0.45, 0.5, 0.55, 0.6, 0.7, 0.8, 0.9, 0.95}) {
    const Weights found = weights_of(scale);
    table.row(scale, found.discarded_percent, found.furthest_percent);
    (scale > 0.5 ? most_above : least_below) =
        scale > 0.5 ? std::max(most_above, found.discarded_percent) : std::min(least_below, found.discarded_percent);
  }
  report.table("weights.csv", table);
  return {{"For scalings ≤ 1/2 some pixels are likely to be completely discarded, for scalings > 1/2 all source pixels "
           "contribute.",
           {least_below, most_above},
           "From 0.3 to 0.5 at least {:.0f} % of a row's pixels are discarded, from 0.55 to 0.95 {:.0f} %",
           "Some and none",
           {first > 0 && second <= 0}},
          {"The errors of the weights are small for scalings only slightly smaller than one.",
           {weights_of(0.95).furthest_percent, weights_of(0.6).furthest_percent},
           "Up to {:.0f} % at 0.95, up to {:.0f} % at 0.6",
           "At most 10 % at 0.95, more at 0.6; partly: 20 %",
           {first <= 10 && second > 10, first <= 20}}};
}

/// 7.19: neighbours in the result that weights of a step take from one place.
Statement quantised_places(StudyReport& report) {
  using namespace measured;
  Csv table({"step", "scale", "equal_places"});
  int wrong = 0;
  int all = 0;
  for (const double step : {1.0, 0.5, 0.25, 0.125}) {
    for (const double scale : {0.5, 0.9, 1.0, 1.3, 1.9, 2.0, 2.1, 3.0, 3.9, 4.0, 4.3, 7.7, 8.0, 8.5, 11.0}) {
      int equal = 0;
      double last = NAN;
      for (int x = 0; x < 2000; ++x) {
        const double place = std::floor(x / scale / step + 0.5) * step;
        equal += place == last ? 1 : 0;
        last = place;
      }
      table.row(step, scale, equal / 1999.0);
      wrong += (equal == 0) == (step <= 1 / scale) ? 0 : 1;
      ++all;
    }
  }
  report.table("blocking.csv", table);
  return {"Visible blocking disappears when the quantization of the weights is q_b ≤ 1/scaling (7.19).",
          {wrong, all},
          "Two neighbours from one place: {} of {} pairs of q_b and scaling are on the wrong side",
          "None; partly: up to a tenth",
          {first <= 0, first <= 0.1 * second}};
}

}  // namespace

void study_sampling(StudyReport& report, const StudyScope& scope) {
  study::Conditions conditions;
  conditions.camera.width = scope.quick ? 240 : 480;
  conditions.camera.height = scope.quick ? 180 : 360;
  conditions.seed = scope.seed;
  report.result["conditions"] = to_json(conditions);
  const Plane source = study::Simulation(conditions, 0).exact(0);
  report.state("7.3", table_7_1(report, source));
  report.state("7.5", {supersampling_is_bilinear(source)});
  report.state("7.5", weights(report));
  report.state("7.5", {quantised_places(report)});
  for (const auto& row : report.result["statements"]) report.finding("{}", row["figure"].get<std::string>());
}

}  // namespace horopter::cli
