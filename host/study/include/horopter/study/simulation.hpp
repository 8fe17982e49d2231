// SPDX-License-Identifier: Apache-2.0
// Photographs of a texture that is moved before a camera by fractions of a pixel, as on the thesis's linear robot
// (8.4.1), with every condition known.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>

#include "horopter/image/image.hpp"
#include "horopter/study/raster.hpp"
#include "horopter/study/texture.hpp"

namespace horopter::study {

struct Camera {
  int width = 630;
  int height = 470;
  double blur_px = 0.4;       ///< standard deviation of the lens's point spread, a Gaussian
  double fill_factor = 0.85;  ///< sensitive share of a pixel's area, a square in its middle
};

/// Light that stays with the camera when the texture moves: 1 + slope_x·u + slope_y·v − falloff·(u² + v²) / 2, where
/// u and v run from −1 to 1 across the image. Grey values are those of the texture in light 1, times it.
struct Lighting {
  double mean_grey = 110;
  /// Mean over the image of the standard deviation in 7×7 pixels, without noise. A moderate contrast, not a measured one.
  double deviation_grey = 12;
  double slope_x = 0;
  double slope_y = 0;
  double falloff = 0;
};

struct Electronics {
  double noise_grey = 1.2;  ///< standard deviation in one image (thesis 8.2), independent in each pixel
  double jitter_px = 0;     ///< standard deviation of a line's start, independent in each line
  int bits = 8;             ///< of the converter, 1 … 8, over 0 … 255
  int averaged = 5;         ///< images, converted first; their mean is rounded to 8 bits
};

struct Conditions {
  Texture texture;
  Camera camera;
  Lighting lighting;
  Electronics electronics;
  std::uint64_t seed = 1;
};

/// All of it, for a page or a table.
nlohmann::json to_json(const Conditions& conditions);

class Simulation {
 public:
  /// Photographs may be shifted by ± largest_shift_px along x, the camera's lines. Throws std::invalid_argument for
  /// conditions that cannot be.
  explicit Simulation(const Conditions& conditions, double largest_shift_px);

  /// Pixel (x, y) shows what lies at (x + shift_px, y). `number` chooses the noise: photographs of one
  /// number and shift are identical. May be called from several threads.
  Image photograph(double shift_px, std::uint64_t number) const;
  /// The same before noise, jitter and conversion.
  Plane exact(double shift_px) const;
  /// With a shift for each pixel.
  Plane exact(const Raster<float>& shifts_px) const;

  /// What the electronics make of `still` (jitter moves what the simulation shows at shift_px 0, so there is none
  /// here).
  Image expose(const Plane& still, const Electronics& electronics, std::uint64_t number) const;

  const Conditions& conditions() const { return conditions_; }

 private:
  void check_shift(double shift_px) const;
  double sample(const float* row, int x, double shift_px) const;
  template <class Line>
  Image convert(const Electronics& electronics, std::uint64_t number, Line line) const;

  Conditions conditions_;
  int margin_px_;
  double largest_shift_px_;
  Raster<float> fine_;  ///< rows of the camera, columns oversampled; reflectance in grey values of light 1
  Raster<float> light_;
};

/// Mean over the image of the standard deviation in size × size pixels (size odd).
double local_deviation(const Plane& image, int size = 7);

}  // namespace horopter::study
