// SPDX-License-Identifier: Apache-2.0
// The mathematics in double precision, written from the formulas of the thesis (with its errata) and of hls/stages'
// contracts, and from nothing else: it shares no code with hls/. Not causal: results stand at the pixel they belong to.
// A missing value is NaN and makes everything missing that is computed from it.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace horopter::tb::reference {

inline constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

struct Image {
  int width = 0;
  int height = 0;
  std::vector<double> values;

  Image() = default;
  Image(int w, int h, double value = 0) : width(w), height(h), values(static_cast<std::size_t>(w * h), value) {}

  [[nodiscard]] bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  [[nodiscard]] double at(int x, int y) const {
    return contains(x, y) ? values[static_cast<std::size_t>(y * width + x)] : kMissing;
  }
  double& operator()(int x, int y) { return values[static_cast<std::size_t>(y * width + x)]; }
};

/// Σ weight(i, j) · image(x + i, y + j) over a (2r+1)² window.
inline Image filter(const Image& image, int r, const std::function<double(int, int)>& weight) {
  Image out(image.width, image.height, kMissing);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      double sum = 0;
      for (int j = -r; j <= r; ++j) {
        for (int i = -r; i <= r; ++i) sum += weight(i, j) * image.at(x + i, y + j);
      }
      out(x, y) = sum;
    }
  }
  return out;
}

inline Image box_sum(const Image& image, int k) {
  return filter(image, (k - 1) / 2, [](int, int) { return 1.0; });
}

/// Eq. 10.2.
inline Image lowpass(const Image& image) {
  return filter(image, 1, [](int i, int j) { return (2 - std::abs(i)) * (2 - std::abs(j)) / 16.0; });
}

struct Gradient {
  Image x;
  Image y;
};

/// Eq. 10.3, as convolution.
inline Gradient sobel(const Image& image) {
  return {filter(image, 1, [](int i, int j) { return i * (2.0 - std::abs(j)); }),
          filter(image, 1, [](int i, int j) { return j * (2.0 - std::abs(i)); })};
}

/// Eq. 10.9 in 1/256 turn, 0 … 256.
inline double direction(double gx, double gy) {
  const double turns = std::atan2(gy, gx) / (2 * std::numbers::pi);
  return 256 * (turns < 0 ? turns + 1 : turns);
}

/// Eq. 10.4, in 1/256 turn, 0 … 128.
inline double cyclic_difference(double a, double b) {
  const double d = std::fabs(a - b);
  return std::min(d, 256 - d);
}

/// 10.4.5: 4 bit.
inline double level(double difference) { return std::floor(std::min(difference, 127.0) / 8); }

/// Source of pixel (x, y) between four control points; all coordinates in px.
struct Point {
  double x = 0;
  double y = 0;
};
using ControlGrid = std::function<std::optional<Point>(int column, int row)>;

inline std::optional<Point> expand(const ControlGrid& grid, int spacing_x, int spacing_y, int x, int y) {
  const double u = static_cast<double>(x % spacing_x) / spacing_x;
  const double v = static_cast<double>(y % spacing_y) / spacing_y;
  Point sum;
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) {
      const double weight = (i == 1 ? u : 1 - u) * (j == 1 ? v : 1 - v);
      if (weight == 0) continue;
      const auto point = grid(x / spacing_x + i, y / spacing_y + j);
      if (!point) return std::nullopt;
      sum.x += weight * point->x;
      sum.y += weight * point->y;
    }
  }
  return sum;
}

/// Eq. 10.1 with real weights; missing outside the image.
inline double bilinear(const Image& image, Point p) {
  const int x = static_cast<int>(std::floor(p.x));
  const int y = static_cast<int>(std::floor(p.y));
  double sum = 0;
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) {
      const double weight = (1 - std::fabs(p.x - (x + i))) * (1 - std::fabs(p.y - (y + j)));
      if (weight > 0) sum += weight * image.at(x + i, y + j);
    }
  }
  return sum;
}

inline Image warp(const Image& right, int width, int height, const std::function<std::optional<Point>(int, int)>& map) {
  Image out(width, height, kMissing);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (const auto p = map(x, y)) out(x, y) = bilinear(right, *p);
    }
  }
  return out;
}

struct Decision {
  int dsad_window = 9;
  int majority_window = 7;
  int texture_window = 3;
  int self_shift = 4;
  double threshold_percent = 25;
  double texture = 32;     // unscaled Sobel magnitude
  double self_levels = 1;  // mean self difference, in levels, that a window must exceed
};

enum State { clear = 0, skin = 1, undecidable = 2, unsupervised = 3 };

struct Result {
  Image sum;       // DSAD
  Image self_sum;  // of the left image against itself
  Image texture;   // mean magnitude
  std::vector<State> states;
};

/// States of a left image and the right one as seen through the map. Saturation aside: give it unsaturated images.
inline Result decide(const Image& left, const Image& right, const Decision& d) {
  const Gradient l = sobel(lowpass(left));
  const Gradient r = sobel(lowpass(right));
  const int w = left.width;
  const int h = left.height;
  Image difference(w, h, kMissing);
  Image self(w, h, kMissing);
  Image magnitude(w, h, kMissing);
  const auto compare = [](double ax, double ay, double bx, double by, double neither) {
    const bool a = std::hypot(ax, ay) > 0;
    const bool b = std::hypot(bx, by) > 0;
    if (a != b) return 8.0;  // no direction against one
    if (!a) return neither;
    return level(cyclic_difference(direction(ax, ay), direction(bx, by)));
  };
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const double lx = l.x.at(x, y);
      const double ly = l.y.at(x, y);
      const double rx = r.x.at(x, y);
      const double ry = r.y.at(x, y);
      if (std::isnan(lx + ly + rx + ry)) continue;
      difference(x, y) = compare(lx, ly, rx, ry, 4);
      magnitude(x, y) = std::min(std::hypot(lx, ly), 255.0);
      const int before = x - d.self_shift;
      const bool exists = !std::isnan(l.x.at(before, y) + l.y.at(before, y) + r.x.at(before, y) + r.y.at(before, y));
      self(x, y) = exists ? compare(lx, ly, l.x.at(before, y), l.y.at(before, y), 0) : 0;
    }
  }
  Result result{
      box_sum(difference, d.dsad_window), box_sum(self, d.dsad_window), box_sum(magnitude, d.texture_window), {}};
  for (double& v : result.texture.values) v /= d.texture_window * d.texture_window;

  const double cells = d.dsad_window * d.dsad_window;
  const double limit = std::floor(d.threshold_percent * 15 * cells / 100);
  Image decidable(w, h, kMissing);
  Image in_skin(w, h, kMissing);
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      if (std::isnan(result.sum.at(x, y))) continue;
      const bool can = result.texture.at(x, y) >= d.texture && result.self_sum.at(x, y) > d.self_levels * cells;
      decidable(x, y) = can ? 1 : 0;
      in_skin(x, y) = can && result.sum.at(x, y) <= limit ? 1 : 0;
    }
  }
  const Image votes = box_sum(decidable, d.majority_window);
  const Image skin_votes = box_sum(in_skin, d.majority_window);
  result.states.resize(static_cast<std::size_t>(w * h), unsupervised);
  for (std::size_t i = 0; i < result.states.size(); ++i) {
    if (std::isnan(votes.values[i])) continue;
    if (2 * votes.values[i] < d.majority_window * d.majority_window) {
      result.states[i] = undecidable;
    } else {
      result.states[i] = 2 * skin_votes.values[i] > votes.values[i] ? skin : clear;
    }
  }
  return result;
}

}  // namespace horopter::tb::reference
