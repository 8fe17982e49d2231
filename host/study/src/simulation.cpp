// SPDX-License-Identifier: Apache-2.0
#include "horopter/study/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "horopter/calib/random.hpp"
#include "horopter/study/parallel.hpp"

namespace horopter::study {
namespace {

constexpr int kOversampling = 8;
constexpr double kBlurReach = 4;  ///< standard deviations
constexpr double kJitterReach = 5;

void check(const Conditions& conditions) {
  const auto& [texture, camera, lighting, electronics, seed] = conditions;
  const auto require = [](bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(fmt::format("simulation: {}", what));
  };
  require(camera.width >= 16 && camera.height >= 16, "an image of 16×16 pixels at least is needed");
  require(camera.blur_px >= 0 && camera.blur_px <= 20, "blur_px is 0 to 20");
  require(camera.fill_factor > 0 && camera.fill_factor <= 1, "fill_factor is above 0, at most 1");
  require(lighting.deviation_grey >= 0 && std::isfinite(lighting.mean_grey), "deviation_grey is at least 0");
  require(1 - std::abs(lighting.slope_x) - std::abs(lighting.slope_y) - std::abs(lighting.falloff) > 0,
          "the light must be above 0 all over the image");
  require(electronics.noise_grey >= 0 && electronics.jitter_px >= 0 && electronics.jitter_px <= 2,
          "noise_grey is at least 0, jitter_px 0 to 2");
  require(electronics.bits >= 1 && electronics.bits <= 8, "bits is 1 to 8");
  require(electronics.averaged >= 1 && electronics.averaged <= 1000, "averaged is 1 to 1000");
}

/// What the lens and the pixel make of a line: weights of the samples at (first + i) · 1/oversampling px from `centre`.
struct LineWeights {
  int first = 0;
  std::vector<float> weights;
};

/// `fraction`: of a sample, place of the pixel's centre after the sample it is counted from.
LineWeights line_weights(const Camera& camera, double fraction) {
  const double half = std::sqrt(camera.fill_factor) / 2;
  const double reach = half + kBlurReach * camera.blur_px;
  LineWeights result;
  result.first = static_cast<int>(std::floor(-reach * kOversampling + fraction)) - 1;
  const int last = static_cast<int>(std::ceil(reach * kOversampling + fraction)) + 1;
  // Of a Gaussian along the line, integrated over the pixel; without blur, of the pixel alone. A sample is as wide as
  // its distance from the next, so the pixel's ends may lie within one.
  const auto integral = [&](double t) {  // ∫ of the pixel's share below t
    if (camera.blur_px <= 0) return std::clamp((t + half) / (2 * half), 0.0, 1.0);
    const double s = camera.blur_px;
    const auto ramp = [&](double v) {  // ∫ Φ
      return v * 0.5 * std::erfc(-v / (s * std::numbers::sqrt2)) +
             s / std::sqrt(2 * std::numbers::pi) * std::exp(-v * v / (2 * s * s));
    };
    return (ramp(t + half) - ramp(t - half)) / (2 * half);
  };
  double sum = 0;
  for (int i = result.first; i <= last; ++i) {
    const double t = (i - fraction) / kOversampling;
    const double weight = integral(t + 0.5 / kOversampling) - integral(t - 0.5 / kOversampling);
    result.weights.push_back(static_cast<float>(weight));
    sum += weight;
  }
  for (float& weight : result.weights) weight = static_cast<float>(weight / sum);
  return result;
}

int clamped(int value, int size) { return std::clamp(value, 0, size - 1); }

}  // namespace

nlohmann::json to_json(const Conditions& conditions) {
  const auto& [texture, camera, lighting, electronics, seed] = conditions;
  nlohmann::json result;
  result["texture"] = {{"kind", name_of(texture.kind)}};
  if (texture.kind == TextureKind::picture) {
    result["texture"]["picture_scale"] = texture.picture_scale;
  } else {
    result["texture"]["smallest_px"] = texture.smallest_px;
    result["texture"]["largest_px"] = texture.largest_px;
  }
  result["camera"] = {{"width", camera.width},
                      {"height", camera.height},
                      {"blur_px", camera.blur_px},
                      {"fill_factor", camera.fill_factor}};
  result["lighting"] = {{"mean_grey", lighting.mean_grey},
                        {"deviation_grey", lighting.deviation_grey},
                        {"slope_x", lighting.slope_x},
                        {"slope_y", lighting.slope_y},
                        {"falloff", lighting.falloff}};
  result["electronics"] = {{"noise_grey", electronics.noise_grey},
                           {"jitter_px", electronics.jitter_px},
                           {"bits", electronics.bits},
                           {"averaged", electronics.averaged}};
  result["seed"] = seed;
  return result;
}

Simulation::Simulation(const Conditions& conditions, double largest_shift_px)
    : conditions_(conditions), largest_shift_px_(largest_shift_px) {
  check(conditions);
  if (!(largest_shift_px >= 0 && largest_shift_px < 1000))
    throw std::invalid_argument("simulation: shifts are below 1000 px");
  const Camera& camera = conditions_.camera;
  const double jitter = kJitterReach * conditions_.electronics.jitter_px;
  const int reach = static_cast<int>(std::ceil(1 + kBlurReach * camera.blur_px)) + 1;
  margin_px_ = static_cast<int>(std::ceil(largest_shift_px + jitter)) + reach;
  const int margin_y = reach;
  const Raster<float> drawn = draw_texture(conditions_.texture, camera.width + 2 * margin_px_,
                                           camera.height + 2 * margin_y, kOversampling, conditions_.seed);

  // Along y: rows of the camera. Pixel y's centre lies at sample (y + 0.5)·oversampling − 0.5.
  Raster<float> rows(drawn.width, camera.height);
  const double start = (margin_y + 0.5) * kOversampling - 0.5;
  const LineWeights down = line_weights(camera, start - std::floor(start));
  parallel_for(static_cast<std::size_t>(camera.height), [&](std::size_t index) {
    const int y = static_cast<int>(index);
    float* row = rows.row(y);
    for (std::size_t i = 0; i < down.weights.size(); ++i) {
      const float* source = drawn.row(clamped(
          static_cast<int>(std::floor(start)) + y * kOversampling + down.first + static_cast<int>(i), drawn.height));
      for (int x = 0; x < drawn.width; ++x) row[x] += down.weights[i] * source[x];
    }
  });
  // Along x at every sample.
  const LineWeights across = line_weights(camera, 0);
  fine_ = Raster<float>(drawn.width, camera.height);
  parallel_for(static_cast<std::size_t>(camera.height), [&](std::size_t index) {
    const float* source = rows.row(static_cast<int>(index));
    float* row = fine_.row(static_cast<int>(index));
    for (std::size_t i = 0; i < across.weights.size(); ++i) {
      const int offset = across.first + static_cast<int>(i);
      for (int x = 0; x < drawn.width; ++x) row[x] += across.weights[i] * source[clamped(x + offset, drawn.width)];
    }
  });

  // Contrast and brightness in light 1.
  const Lighting& lighting = conditions_.lighting;
  light_ = Raster<float>(camera.width, camera.height, 1);
  const Plane plain = exact(0);
  double mean = 0;
  for (const double value : plain.values) mean += value;
  mean /= static_cast<double>(plain.values.size());
  const double deviation = local_deviation(plain);
  if (deviation <= 0 && lighting.deviation_grey > 0)
    throw std::invalid_argument("simulation: the texture has no contrast");
  const double gain = deviation > 0 ? lighting.deviation_grey / deviation : 0;
  for (float& value : fine_.values) value = static_cast<float>(lighting.mean_grey + (value - mean) * gain);
  for (int y = 0; y < camera.height; ++y) {
    const double v = (2.0 * y + 1) / camera.height - 1;
    for (int x = 0; x < camera.width; ++x) {
      const double u = (2.0 * x + 1) / camera.width - 1;
      light_.at(x, y) =
          static_cast<float>(1 + lighting.slope_x * u + lighting.slope_y * v - lighting.falloff * (u * u + v * v) / 2);
    }
  }
}

double Simulation::sample(const float* row, int x, double shift_px) const {
  const double place = (x + margin_px_ + shift_px + 0.5) * kOversampling - 0.5;
  const double whole = std::floor(place);
  const double u = place - whole;
  const float* p = row + static_cast<std::ptrdiff_t>(whole);
  // Catmull-Rom; what is sampled is smooth at this spacing.
  return p[0] +
         0.5 * u *
             (p[1] - p[-1] + u * (2 * p[-1] - 5 * p[0] + 4 * p[1] - p[2] + u * (3 * (p[0] - p[1]) + p[2] - p[-1])));
}

void Simulation::check_shift(double shift_px) const {
  if (!(std::abs(shift_px) <= largest_shift_px_))
    throw std::invalid_argument(fmt::format("simulation: shift {} px, made for ± {} px", shift_px, largest_shift_px_));
}

Plane Simulation::exact(const Raster<float>& shifts_px) const {
  Plane image(conditions_.camera.width, conditions_.camera.height);
  if (shifts_px.width != image.width || shifts_px.height != image.height)
    throw std::invalid_argument("simulation: shifts for another size than the camera's");
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double shift_px = shifts_px.at(x, y);
      check_shift(shift_px);
      image.at(x, y) = sample(fine_.row(y), x, shift_px) * light_.at(x, y);
    }
  return image;
}

Plane Simulation::exact(double shift_px) const {
  check_shift(shift_px);
  const Camera& camera = conditions_.camera;
  Plane image(camera.width, camera.height);
  for (int y = 0; y < camera.height; ++y) {
    const float* row = fine_.row(y);
    const float* light = light_.row(y);
    double* out = image.row(y);
    for (int x = 0; x < camera.width; ++x) out[x] = sample(row, x, shift_px) * light[x];
  }
  return image;
}

/// line(y, random) is the row of grey values of one of the images to be averaged.
template <class Line>
Image Simulation::convert(const Electronics& electronics, std::uint64_t number, Line line) const {
  const Camera& camera = conditions_.camera;
  calib::Random random(calib::mix(conditions_.seed + 0x4E01), number);
  std::vector<int> sums(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  const double step = 255.0 / ((1 << electronics.bits) - 1);
  for (int frame = 0; frame < electronics.averaged; ++frame) {
    int* sum = sums.data();
    for (int y = 0; y < camera.height; ++y) {
      const double* row = line(y, random);
      for (int x = 0; x < camera.width; ++x) {
        const double grey = std::clamp(row[x] + electronics.noise_grey * random.gaussian(), 0.0, 255.0);
        const auto code = static_cast<double>(std::lround(grey / step));
        *sum++ += static_cast<int>(std::lround(code * step));
      }
    }
  }
  Image image(camera.width, camera.height);
  for (std::size_t i = 0; i < sums.size(); ++i)
    image.pixels[i] = static_cast<std::uint8_t>((2 * sums[i] + electronics.averaged) / (2 * electronics.averaged));
  return image;
}

Image Simulation::photograph(double shift_px, std::uint64_t number) const {
  const Electronics& electronics = conditions_.electronics;
  const Plane still = exact(shift_px);
  std::vector<double> moved(static_cast<std::size_t>(still.width));
  return convert(electronics, number, [&](int y, calib::Random& random) {
    if (electronics.jitter_px <= 0) return still.row(y);
    const double jitter =
        std::clamp(static_cast<double>(random.gaussian()), -kJitterReach, kJitterReach) * electronics.jitter_px;
    for (int x = 0; x < still.width; ++x)
      moved[static_cast<std::size_t>(x)] = sample(fine_.row(y), x, shift_px + jitter) * light_.at(x, y);
    return static_cast<const double*>(moved.data());
  });
}

Image Simulation::expose(const Plane& still, const Electronics& electronics, std::uint64_t number) const {
  if (still.width != conditions_.camera.width || still.height != conditions_.camera.height)
    throw std::invalid_argument("simulation: a plane of another size than the camera's");
  return convert(electronics, number, [&](int y, calib::Random&) { return still.row(y); });
}

double local_deviation(const Plane& image, int size) {
  const int reach = size / 2;
  if (size < 3 || size % 2 == 0 || image.width < size || image.height < size)
    throw std::invalid_argument("local_deviation: an odd size of 3 at least, within the image");
  double total = 0;
  for (int y = reach; y < image.height - reach; ++y) {
    // Column sums would lose digits; the windows overlap little enough for a study.
    for (int x = reach; x < image.width - reach; ++x) {
      const double origin = image.at(x, y);
      double sum = 0;
      double square = 0;
      for (int j = -reach; j <= reach; ++j) {
        const double* row = image.row(y + j) + x;
        for (int i = -reach; i <= reach; ++i) {
          const double value = row[i] - origin;
          sum += value;
          square += value * value;
        }
      }
      const double count = size * size;
      total += std::sqrt(std::max(0.0, square / count - sum * sum / (count * count)));
    }
  }
  return total / ((image.width - 2.0 * reach) * (image.height - 2.0 * reach));
}

}  // namespace horopter::study
