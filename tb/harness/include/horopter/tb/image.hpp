// SPDX-License-Identifier: Apache-2.0
// Grey images for stimuli.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "horopter/tb/random.hpp"

namespace horopter::tb {

struct Image {
  unsigned width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  ///< row by row

  Image() = default;
  Image(unsigned w, unsigned h, std::uint8_t value = 0) : width{w}, height{h}, pixels(std::size_t{w} * h, value) {}
  std::uint8_t& at(unsigned x, unsigned y) { return pixels[std::size_t{y} * width + x]; }
  std::uint8_t at(unsigned x, unsigned y) const { return pixels[std::size_t{y} * width + x]; }
  friend bool operator==(const Image&, const Image&) = default;
};

/// Every pixel independent, 0 … 255.
Image noise_image(unsigned width, unsigned height, Rng& rng);

/// A textured surface: blobs and edges of several sizes with little noise, without saturated pixels.
Image textured_image(unsigned width, unsigned height, Rng& rng);

/// `image` moved right by `shift_px` (left when negative), its border repeated.
Image shifted(const Image& image, int shift_px);

}  // namespace horopter::tb
