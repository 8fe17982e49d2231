// SPDX-License-Identifier: Apache-2.0
#include "horopter/study/operators.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace horopter::study {
namespace {

void check(int size) {
  if (size < 1) throw std::invalid_argument("an operator's window reaches 1 pixel at least");
}

/// Combines each pixel with its `reach` neighbours either way, along the rows or down the columns.
template <class F>
Image along(const Image& image, int reach, bool down, F combine) {
  Image result(image.width, image.height);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      std::uint8_t value = image.at(x, y);
      for (int i = -reach; i <= reach; ++i) {
        const int u = std::clamp(x + (down ? 0 : i), 0, image.width - 1);
        const int v = std::clamp(y + (down ? i : 0), 0, image.height - 1);
        value = combine(value, image.at(u, v));
      }
      result.at(x, y) = value;
    }
  }
  return result;
}

std::uint8_t larger(std::uint8_t a, std::uint8_t b) { return std::max(a, b); }
std::uint8_t smaller(std::uint8_t a, std::uint8_t b) { return std::min(a, b); }

/// Objects first, then the holes.
Image eliminate_both(const Image& image, int e) {
  return eliminate_clusterlets(eliminate_clusterlets(image, e, 0), e, 1);
}

}  // namespace

Image dilation(const Image& image, int k) {
  check(k);
  return along(along(image, k, false, larger), k, true, larger);
}

Image erosion(const Image& image, int k) {
  check(k);
  return along(along(image, k, false, smaller), k, true, smaller);
}

Image opening(const Image& image, int k) { return dilation(erosion(image, k), k); }
Image closing(const Image& image, int k) { return erosion(dilation(image, k), k); }

Image eliminate_clusterlets(const Image& image, int e, int value) {
  check(e);
  const auto pixel = [&](int x, int y) {
    return image.at(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
  };
  Image result = image;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      bool alike = true;
      for (int i = -e; i <= e && alike; ++i) {
        alike = pixel(x - e, y + i) == value && pixel(x + e, y + i) == value && pixel(x + i, y - e) == value &&
                pixel(x + i, y + e) == value;
      }
      if (!alike) continue;
      for (int v = std::max(0, y - e + 1); v < std::min(image.height, y + e); ++v) {
        for (int u = std::max(0, x - e + 1); u < std::min(image.width, x + e); ++u) {
          result.at(u, v) = static_cast<std::uint8_t>(value);
        }
      }
    }
  }
  return result;
}

Image majority(const Image& image, int k) {
  check(k);
  Image result(image.width, image.height);
  const int half = (2 * k + 1) * (2 * k + 1) / 2;
  // Sums of columns run down, those of windows along the row.
  std::vector<int> columns(static_cast<std::size_t>(image.width));
  const auto row = [&](int y) { return image.row(std::clamp(y, 0, image.height - 1)); };
  for (int y = -k; y < k; ++y) {
    for (std::size_t x = 0; x < columns.size(); ++x) columns[x] += row(y)[x];
  }
  for (int y = 0; y < image.height; ++y) {
    for (std::size_t x = 0; x < columns.size(); ++x) columns[x] += row(y + k)[x];
    const auto column = [&](int x) { return columns[static_cast<std::size_t>(std::clamp(x, 0, image.width - 1))]; };
    int sum = 0;
    for (int x = -k; x < k; ++x) sum += column(x);
    for (int x = 0; x < image.width; ++x) {
      sum += column(x + k);
      result.at(x, y) = sum > half ? 1 : 0;
      sum -= column(x - k);
    }
    for (std::size_t x = 0; x < columns.size(); ++x) columns[x] -= row(y - k)[x];
  }
  return result;
}

Image hysteresis(const Plane& values, double low, double high) {
  if (!(low <= high)) throw std::invalid_argument("the lower threshold of a hysteresis is not above the upper one");
  Image result(values.width, values.height);
  std::vector<std::pair<int, int>> open;
  const auto take = [&](int x, int y) {
    result.at(x, y) = 1;
    open.emplace_back(x, y);
  };
  for (int y = 0; y < values.height; ++y) {
    for (int x = 0; x < values.width; ++x) {
      if (values.at(x, y) >= high) take(x, y);
    }
  }
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    for (int v = std::max(0, y - 1); v <= std::min(values.height - 1, y + 1); ++v) {
      for (int u = std::max(0, x - 1); u <= std::min(values.width - 1, x + 1); ++u) {
        if (result.at(u, v) == 0 && values.at(u, v) >= low) take(u, v);
      }
    }
  }
  return result;
}

const std::vector<Operator>& binary_operators() {
  static const std::vector<Operator> all{
      {"dilation 3x3", dilation, 1},
      {"erosion 3x3", erosion, 1},
      {"opening 3x3", opening, 1},
      {"opening 5x5", opening, 2},
      {"closing 3x3", closing, 1},
      {"closing 5x5", closing, 2},
      {"clusterlets 3x3", eliminate_both, 2},
      {"clusterlets 5x5", eliminate_both, 3},
      {"clusterlets 7x7", eliminate_both, 4},
      {"majority 3x3", majority, 1},
      {"majority 5x5", majority, 2},
      {"majority 7x7", majority, 3},
      {"majority 9x9", majority, 4},
  };
  return all;
}

}  // namespace horopter::study
