// SPDX-License-Identifier: Apache-2.0
#include "horopter/study/texture_measures.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace horopter::study {
namespace {

constexpr Mask kSobel{1, 0, -1, 2, 0, -2, 1, 0, -1};
constexpr Mask kPrewitt{1, 0, -1, 1, 0, -1, 1, 0, -1};
// Roberts's cross: the diagonals of 2×2 pixels.
constexpr Mask kFalling{1, 0, 0, 0, -1, 0, 0, 0, 0};
constexpr Mask kRising{0, 1, 0, -1, 0, 0, 0, 0, 0};
constexpr Mask kKirsch{5, 5, 5, -3, 0, -3, -3, -3, -3};
constexpr Mask kPrewittCompass{1, 1, 1, 1, -2, 1, -1, -1, -1};
constexpr Mask kLaplace{0, 1, 0, 1, -4, 1, 0, 1, 0};

Mask quarter_turn(const Mask& m) { return {m[6], m[3], m[0], m[7], m[4], m[1], m[8], m[5], m[2]}; }

Mask eighth_turn(const Mask& m) {
  // Each of the ring's places takes what was at the one before.
  constexpr std::array<std::size_t, 8> kRing{0, 1, 2, 5, 8, 7, 6, 3};
  Mask result = m;
  for (std::size_t i = 0; i < 8; ++i) result[kRing[(i + 1) % 8]] = m[kRing[i]];
  return result;
}

}  // namespace

Plane deviation_in_window(const Plane& image, int size) {
  if (size < 1 || size % 2 == 0) throw std::invalid_argument("a window has an odd size");
  const int reach = size / 2;
  Plane result(image.width, image.height);
  const double n = static_cast<double>(size) * size;
  // Columns of the window, rows v of the image; beyond it its last pixels go on.
  std::vector<double> sum(static_cast<std::size_t>(image.width));
  std::vector<double> squares(sum.size());
  for (int y = 0; y < image.height; ++y) {
    std::ranges::fill(sum, 0.0);
    std::ranges::fill(squares, 0.0);
    for (int j = -reach; j <= reach; ++j) {
      const double* row = image.row(std::clamp(y + j, 0, image.height - 1));
      for (std::size_t x = 0; x < sum.size(); ++x) {
        sum[x] += row[x];
        squares[x] += row[x] * row[x];
      }
    }
    for (int x = 0; x < image.width; ++x) {
      double s = 0;
      double q = 0;
      for (int i = -reach; i <= reach; ++i) {
        const auto at = static_cast<std::size_t>(std::clamp(x + i, 0, image.width - 1));
        s += sum[at];
        q += squares[at];
      }
      result.at(x, y) = std::sqrt(std::max(0.0, q / n - s / n * (s / n)));
    }
  }
  return result;
}

Plane correlate(const Plane& image, const Mask& mask) {
  Plane result(image.width, image.height);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      double sum = 0;
      for (int j = -1; j <= 1; ++j) {
        const double* row = image.row(std::clamp(y + j, 0, image.height - 1));
        for (int i = -1; i <= 1; ++i) {
          sum += mask[static_cast<std::size_t>(3 * (j + 1) + i + 1)] * row[std::clamp(x + i, 0, image.width - 1)];
        }
      }
      result.at(x, y) = sum;
    }
  }
  return result;
}

Plane sum_of_two(const Plane& image, const Mask& one, const Mask& two) {
  Plane result = correlate(image, one);
  const Plane other = correlate(image, two);
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    result.values[i] = std::abs(result.values[i]) + std::abs(other.values[i]);
  }
  return result;
}

Plane compass(const Plane& image, const Mask& mask) {
  Plane result = correlate(image, mask);
  Mask turned = mask;
  for (int i = 1; i < 8; ++i) {
    turned = eighth_turn(turned);
    const Plane other = correlate(image, turned);
    for (std::size_t k = 0; k < result.values.size(); ++k) {
      result.values[k] = std::max(result.values[k], other.values[k]);
    }
  }
  return result;
}

const std::vector<TextureMeasure>& texture_measures() {
  static const std::vector<TextureMeasure> all{
      {"Std dev 7×7", [](const Plane& image) { return deviation_in_window(image, 7); }},
      {"Std dev 3×3", [](const Plane& image) { return deviation_in_window(image, 3); }},
      {"Kirsch compass", [](const Plane& image) { return compass(image, kKirsch); }},
      {"Sobel", [](const Plane& image) { return sum_of_two(image, kSobel, quarter_turn(kSobel)); }},
      {"Prewitt", [](const Plane& image) { return sum_of_two(image, kPrewitt, quarter_turn(kPrewitt)); }},
      {"Roberts", [](const Plane& image) { return sum_of_two(image, kFalling, kRising); }},
      {"Prewitt compass", [](const Plane& image) { return compass(image, kPrewittCompass); }},
      {"Laplace",
       [](const Plane& image) {
         Plane result = correlate(image, kLaplace);
         for (double& value : result.values) value = std::abs(value);
         return result;
       }},
  };
  return all;
}

}  // namespace horopter::study
