// SPDX-License-Identifier: Apache-2.0
#include "horopter/tb/image.hpp"

#include <algorithm>

namespace horopter::tb {

Image noise_image(unsigned width, unsigned height, Rng& rng) {
  Image image{width, height};
  for (auto& pixel : image.pixels) pixel = static_cast<std::uint8_t>(rng.next());
  return image;
}

Image textured_image(unsigned width, unsigned height, Rng& rng) {
  // Value noise: random lattices of spacing 4, 8, 16 and 32 px, bilinear between their points.
  std::vector<int> sum(std::size_t{width} * height, 0);
  for (unsigned spacing = 4; spacing <= 32; spacing *= 2) {
    const unsigned columns = width / spacing + 2, rows = height / spacing + 2;
    std::vector<int> lattice(std::size_t{columns} * rows);
    for (auto& value : lattice) value = static_cast<int>(rng.between(-60, 60));
    for (unsigned y = 0; y < height; ++y) {
      for (unsigned x = 0; x < width; ++x) {
        const unsigned cx = x / spacing, cy = y / spacing;
        const int fx = static_cast<int>(x % spacing), fy = static_cast<int>(y % spacing), s = static_cast<int>(spacing);
        const auto p = [&](unsigned dx, unsigned dy) { return lattice[std::size_t{cy + dy} * columns + cx + dx]; };
        const int top = p(0, 0) * (s - fx) + p(1, 0) * fx, bottom = p(0, 1) * (s - fx) + p(1, 1) * fx;
        sum[std::size_t{y} * width + x] += (top * (s - fy) + bottom * fy) / (s * s);
      }
    }
  }
  Image image{width, height};
  for (std::size_t n = 0; n < sum.size(); ++n) {
    image.pixels[n] =
        static_cast<std::uint8_t>(std::clamp(128 + sum[n] + static_cast<int>(rng.between(-2, 2)), 1, 254));
  }
  return image;
}

Image shifted(const Image& image, int shift_px) {
  Image result{image.width, image.height};
  for (unsigned y = 0; y < image.height; ++y) {
    for (unsigned x = 0; x < image.width; ++x) {
      const int source = std::clamp(static_cast<int>(x) - shift_px, 0, static_cast<int>(image.width) - 1);
      result.at(x, y) = image.at(static_cast<unsigned>(source), y);
    }
  }
  return result;
}

}  // namespace horopter::tb
