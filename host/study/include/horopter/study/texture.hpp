// SPDX-License-Identifier: Apache-2.0
// What lies before the camera: flat textures, drawn much finer than the pixels.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "horopter/image/image.hpp"
#include "horopter/study/raster.hpp"

namespace horopter::study {

enum class TextureKind {
  dead_leaves,   ///< discs of random grey that cover each other, diameters with density ~ d⁻³
  band_noise,    ///< Gaussian noise between two structure sizes
  printed_dots,  ///< black discs at random places on paper, 40 % of it covered on average
  picture        ///< a user's image, mirrored where it ends
};

struct Texture {
  TextureKind kind = TextureKind::dead_leaves;
  double smallest_px = 1;  ///< structures, in camera pixels: diameters, or half-widths of the noise's blobs
  double largest_px = 3;
  std::shared_ptr<const Image> picture;  ///< of TextureKind::picture
  double picture_scale = 1;              ///< camera pixels for a pixel of the picture
};

std::string name_of(TextureKind kind);
/// Throws std::invalid_argument, naming the kinds there are.
TextureKind texture_kind(const std::string& name);

/// width_px × height_px camera pixels with `oversampling`² samples each; any scale and offset. Throws
/// std::invalid_argument for sizes that are none.
Raster<float> draw_texture(const Texture& texture, int width_px, int height_px, int oversampling, std::uint64_t seed);

}  // namespace horopter::study
