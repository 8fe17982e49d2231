// SPDX-License-Identifier: Apache-2.0
#include "horopter/study/texture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "horopter/calib/random.hpp"

namespace horopter::study {
namespace {

constexpr std::array kKinds{
    std::pair{TextureKind::dead_leaves, "dead-leaves"}, std::pair{TextureKind::band_noise, "band-noise"},
    std::pair{TextureKind::printed_dots, "printed-dots"}, std::pair{TextureKind::picture, "picture"}};

void fill_disc(Raster<float>& image, double x, double y, double radius, float value) {
  const int top = std::max(0, static_cast<int>(std::ceil(y - radius)));
  const int bottom = std::min(image.height - 1, static_cast<int>(std::floor(y + radius)));
  for (int row = top; row <= bottom; ++row) {
    const double half = std::sqrt(std::max(0.0, radius * radius - (row - y) * (row - y)));
    const int first = std::max(0, static_cast<int>(std::ceil(x - half)));
    const int last = std::min(image.width - 1, static_cast<int>(std::floor(x + half)));
    if (first <= last) std::fill(image.row(row) + first, image.row(row) + last + 1, value);
  }
}

/// Discs `coverage` times as large together as the image.
template <class Diameter, class Value>
void scatter_discs(Raster<float>& image, double coverage, calib::Random& random, Diameter diameter, Value value) {
  const double wanted = coverage * image.width * image.height;
  for (double area = 0; area < wanted;) {
    const double radius = diameter() / 2;
    const double x = random.uniform() * (image.width + 2 * radius) - radius;
    const double y = random.uniform() * (image.height + 2 * radius) - radius;
    fill_disc(image, x, y, radius, value());
    area += std::numbers::pi * radius * radius;
  }
}

Raster<float> dead_leaves(const Texture& texture, int width, int height, int oversampling, calib::Random& random) {
  Raster<float> image(width, height, 0.5F);
  const double low = texture.smallest_px * oversampling;
  const double high = texture.largest_px * oversampling;
  // Density d⁻³: its distribution is linear in d⁻².
  const auto diameter = [&] {
    const double u = random.uniform();
    return 1 / std::sqrt((1 - u) / (low * low) + u / (high * high));
  };
  // e⁻⁸ of the image stays background.
  scatter_discs(image, 8, random, diameter, [&] { return static_cast<float>(random.uniform()); });
  return image;
}

Raster<float> printed_dots(const Texture& texture, int width, int height, int oversampling, calib::Random& random) {
  Raster<float> image(width, height, 1);
  const double low = texture.smallest_px * oversampling;
  const double high = texture.largest_px * oversampling;
  // Discs at random leave e⁻ᶜ of the paper free.
  scatter_discs(
      image, -std::log(1 - 0.4), random, [&] { return low + random.uniform() * (high - low); }, [] { return 0.0F; });
  return image;
}

/// Mean over 2·reach + 1 samples along the rows; the image goes on as it ends.
void box_rows(Raster<float>& image, int reach) {
  std::vector<double> sums(static_cast<std::size_t>(image.width) + 1);
  for (int y = 0; y < image.height; ++y) {
    float* row = image.row(y);
    for (int x = 0; x < image.width; ++x)
      sums[static_cast<std::size_t>(x) + 1] = sums[static_cast<std::size_t>(x)] + row[x];
    for (int x = 0; x < image.width; ++x) {
      const int first = std::max(0, x - reach);
      const int last = std::min(image.width - 1, x + reach);
      row[x] = static_cast<float>((sums[static_cast<std::size_t>(last) + 1] - sums[static_cast<std::size_t>(first)]) /
                                  (last - first + 1));
    }
  }
}

void box_columns(Raster<float>& image, int reach) {
  const Raster<float> source = image;
  std::vector<double> sum(static_cast<std::size_t>(image.width));
  const auto add = [&](int y, double sign) {
    const float* row = source.row(y);
    for (std::size_t x = 0; x < sum.size(); ++x) sum[x] += sign * row[x];
  };
  for (int y = 0; y < std::min(reach, image.height); ++y) add(y, 1);
  for (int y = 0; y < image.height; ++y) {
    if (y + reach < image.height) add(y + reach, 1);
    if (y - reach - 1 >= 0) add(y - reach - 1, -1);
    const int count = std::min(image.height - 1, y + reach) - std::max(0, y - reach) + 1;
    float* row = image.row(y);
    for (std::size_t x = 0; x < sum.size(); ++x) row[x] = static_cast<float>(sum[x] / count);
  }
}

/// Three means of equal length, nearly a Gaussian of that deviation.
void smooth(Raster<float>& image, double deviation) {
  const int reach = static_cast<int>(std::lround((std::sqrt(4 * deviation * deviation + 1) - 1) / 2));
  for (int i = 0; i < 3 && reach > 0; ++i) {
    box_rows(image, reach);
    box_columns(image, reach);
  }
}

Raster<float> band_noise(const Texture& texture, int width, int height, int oversampling, calib::Random& random) {
  constexpr double kDeviationPerHalfWidth = 1 / 2.3548;
  Raster<float> fine(width, height);
  for (float& value : fine.values) value = random.gaussian();
  Raster<float> coarse = fine;
  smooth(fine, texture.smallest_px * oversampling * kDeviationPerHalfWidth);
  smooth(coarse, texture.largest_px * oversampling * kDeviationPerHalfWidth);
  for (std::size_t i = 0; i < fine.values.size(); ++i) fine.values[i] -= coarse.values[i];
  return fine;
}

/// Place of a sample in a row of `size` that is mirrored at both ends again and again.
int mirrored(int place, int size) {
  const int period = 2 * size;
  const int at = ((place % period) + period) % period;
  return at < size ? at : period - 1 - at;
}

/// Catmull-Rom weights of the four samples around a place `u` after the second.
std::array<double, 4> cubic_weights(double u) {
  return {u * (-0.5 + u * (1 - 0.5 * u)), 1 + u * u * (1.5 * u - 2.5), u * (0.5 + u * (2 - 1.5 * u)),
          u * u * (0.5 * u - 0.5)};
}

Raster<float> picture(const Texture& texture, int width, int height, int oversampling) {
  const Image& source = *texture.picture;
  Raster<float> image(width, height);
  const double step = 1 / (oversampling * texture.picture_scale);
  for (int y = 0; y < height; ++y) {
    const double sy = (y + 0.5) * step - 0.5;
    const double floor_y = std::floor(sy);
    const auto wy = cubic_weights(sy - floor_y);
    for (int x = 0; x < width; ++x) {
      const double sx = (x + 0.5) * step - 0.5;
      const double floor_x = std::floor(sx);
      const auto wx = cubic_weights(sx - floor_x);
      double sum = 0;
      for (int j = 0; j < 4; ++j) {
        const int row = mirrored(static_cast<int>(floor_y) + j - 1, source.height);
        for (int i = 0; i < 4; ++i) {
          const int column = mirrored(static_cast<int>(floor_x) + i - 1, source.width);
          sum += wy[static_cast<std::size_t>(j)] * wx[static_cast<std::size_t>(i)] * source.at(column, row);
        }
      }
      image.at(x, y) = static_cast<float>(sum);
    }
  }
  return image;
}

}  // namespace

std::string name_of(TextureKind kind) {
  for (const auto& [value, name] : kKinds)
    if (value == kind) return name;
  throw std::invalid_argument("a kind of texture without a name");
}

TextureKind texture_kind(const std::string& name) {
  std::string known;
  for (const auto& [value, text] : kKinds) {
    if (name == text) return value;
    known += (known.empty() ? "" : ", ") + std::string(text);
  }
  throw std::invalid_argument("texture '" + name + "': expected one of " + known);
}

Raster<float> draw_texture(const Texture& texture, int width_px, int height_px, int oversampling, std::uint64_t seed) {
  if (width_px < 1 || height_px < 1 || oversampling < 1) throw std::invalid_argument("a texture without size");
  const int width = width_px * oversampling;
  const int height = height_px * oversampling;
  if (texture.kind == TextureKind::picture) {
    if (!texture.picture || texture.picture->empty() || !(texture.picture_scale > 0))
      throw std::invalid_argument("a texture from a picture needs one, and a scale above 0");
    return picture(texture, width, height, oversampling);
  }
  if (!(texture.smallest_px > 0) || !(texture.largest_px > texture.smallest_px))
    throw std::invalid_argument("structures of a texture: 0 < smallest_px < largest_px");
  calib::Random random(seed, 0x7E);
  switch (texture.kind) {
    case TextureKind::band_noise:
      return band_noise(texture, width, height, oversampling, random);
    case TextureKind::printed_dots:
      return printed_dots(texture, width, height, oversampling, random);
    default:
      return dead_leaves(texture, width, height, oversampling, random);
  }
}

}  // namespace horopter::study
