// SPDX-License-Identifier: Apache-2.0
// Thesis 7.5: what bilinear interpolation with weights of few bits costs, for scaling and for translation, as the
// translation that makes two images as different (Fig. 7.7, 7.8). Instead of photographs, scenes of which the image is
// known at any place: waves with a spectrum like that of photographs, through the blur of a lens and square pixels.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "cli/progress.hpp"
#include "horopter/base/csv.hpp"
#include "horopter/calib/random.hpp"
#include "horopter/draw/plot.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

constexpr int kWidth = 128;
constexpr int kHeight = 96;
constexpr int kBorder = 6;        ///< what filters and interpolation reach beyond the image
constexpr double kBlur_px = 0.5;  ///< of the lens
constexpr double kNoise = 1.2;    ///< of the camera, grey levels; the thesis averaged
constexpr int kAveraged = 5;      ///< so many images (11.2.1)
constexpr double kContrast = 40;  ///< standard deviation of a scene, grey levels
constexpr int kShiftsPerPixel = 32;

/// Interpolation by continuous weights, of two pixels or of four a direction.
constexpr int kContinuous = -1;
constexpr int kCubic = -2;
constexpr std::array methods{0, 1, 2, 3, 4, 5, kContinuous, kCubic};

std::string method_name(int method) {
  if (method == kContinuous) return "bilinear";
  if (method == kCubic) return "cubic";
  return method == 0 ? "nearest" : fmt::format("step 1/{}", 1 << method);
}

using Grey = std::vector<double>;  ///< kWidth × kHeight, row by row

double& at(Grey& image, int x, int y) {
  return image[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)];
}
double at(const Grey& image, int x, int y) {
  return image[static_cast<std::size_t>(std::clamp(y, 0, kHeight - 1)) * kWidth +
               static_cast<std::size_t>(std::clamp(x, 0, kWidth - 1))];
}

double sinc(double x) { return x == 0 ? 1 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x); }

class Scene {
 public:
  Scene(calib::Random& random, int waves) {
    constexpr double pi = std::numbers::pi;
    double power = 0;
    for (int i = 0; i < waves; ++i) {
      // 0.01 … 1 cycle a pixel; amplitudes that fall with the frequency are even ones, evenly spread over its
      // logarithm.
      const double frequency = 0.01 * std::pow(100.0, random.uniform());
      const double direction = 2 * pi * random.uniform();
      Wave wave{frequency * std::cos(direction), frequency * std::sin(direction), 2 * pi * random.uniform(), 1};
      wave.amplitude =
          sinc(wave.x) * sinc(wave.y) * std::exp(-2 * pi * pi * kBlur_px * kBlur_px * frequency * frequency);
      power += wave.amplitude * wave.amplitude / 2;
      waves_.push_back(wave);
    }
    for (Wave& wave : waves_) wave.amplitude *= kContrast / std::sqrt(power);
  }

  /// A photograph with the camera shifted along x: noise, 8 bits.
  Grey photograph(double shift_px, calib::Random& random) const {
    const double noise = kNoise / std::sqrt(kAveraged);
    Grey image = without_noise(shift_px);
    for (double& grey : image) grey = std::clamp(std::round(grey + noise * random.gaussian()), 0.0, 255.0);
    return image;
  }

  Grey without_noise(double shift_px) const {
    Grey image(static_cast<std::size_t>(kWidth) * kHeight, 128);
    for (const Wave& wave : waves_) {
      const double step = 2 * std::numbers::pi * wave.x;
      for (int y = 0; y < kHeight; ++y) {
        // Angle sums instead of a cosine a pixel.
        const double start = 2 * std::numbers::pi * (wave.x * shift_px + wave.y * y) + wave.phase;
        double before = std::cos(start - step);
        double now = std::cos(start);
        for (int x = 0; x < kWidth; ++x) {
          at(image, x, y) += wave.amplitude * now;
          before = std::exchange(now, 2 * std::cos(step) * now - before);
        }
      }
    }
    return image;
  }

 private:
  struct Wave {
    double x, y;  ///< cycles a pixel
    double phase;
    double amplitude;
  };
  std::vector<Wave> waves_;
};

/// Weights of the pixels around a place: first pixel, and up to four weights.
struct Taps {
  int first = 0;
  std::array<double, 4> weights{};
};

Taps taps(double place, int method) {
  const double whole = std::floor(place);
  const double u = place - whole;
  const int first = static_cast<int>(whole);
  if (method == kContinuous) return {first, {1 - u, u}};
  if (method == kCubic) {  // Catmull-Rom: through the pixels
    return {first - 1,
            {u * (-0.5 + u * (1 - 0.5 * u)), 1 + u * u * (1.5 * u - 2.5), u * (0.5 + u * (2 - 1.5 * u)),
             u * u * (0.5 * u - 0.5)}};
  }
  // As the hardware rounds: half a step up.
  const double stepped = std::ldexp(std::floor(std::ldexp(place, method) + 0.5), -method);
  const double lower = std::floor(stepped);
  return {static_cast<int>(lower), {1 - (stepped - lower), stepped - lower}};
}

/// Image of places (x0 + x·step_x, y0 + y·step_y) of another one.
Grey transformed(const Grey& image, double x0, double step_x, double y0, double step_y, int method) {
  Grey result(image.size());
  for (int y = 0; y < kHeight; ++y) {
    const Taps rows = taps(y0 + y * step_y, method);
    for (int x = 0; x < kWidth; ++x) {
      const Taps columns = taps(x0 + x * step_x, method);
      double sum = 0;
      for (int j = 0; j < 4; ++j) {
        if (rows.weights[static_cast<std::size_t>(j)] == 0) continue;
        for (int i = 0; i < 4; ++i) {
          sum += rows.weights[static_cast<std::size_t>(j)] * columns.weights[static_cast<std::size_t>(i)] *
                 at(image, columns.first + i, rows.first + j);
        }
      }
      at(result, x, y) = std::clamp(std::floor(sum + 0.5), 0.0, 255.0);
    }
  }
  return result;
}

/// Gradient's direction in 1/256 turn, after the 3×3 low-pass, of every pixel.
std::vector<int> directions(const Grey& image) {
  Grey smooth(image.size());
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      double sum = 0;
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) sum += (2 - std::abs(i)) * (2 - std::abs(j)) * at(image, x + i, y + j);
      }
      at(smooth, x, y) = sum / 16;
    }
  }
  std::vector<int> result(image.size());
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      double sx = 0;
      double sy = 0;
      for (int k = -1; k <= 1; ++k) {
        sx += (2 - std::abs(k)) * (at(smooth, x + 1, y + k) - at(smooth, x - 1, y + k));
        sy += (2 - std::abs(k)) * (at(smooth, x + k, y + 1) - at(smooth, x + k, y - 1));
      }
      result[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)] =
          static_cast<int>(std::lround(std::atan2(sy, sx) * 128 / std::numbers::pi)) & 255;
    }
  }
  return result;
}

struct Difference {
  double direction = 0;  ///< mean of DSAD's 4-bit differences
  double variance = 0;   ///< of grey levels
};

Difference difference(const Grey& a, const Grey& b) {
  const std::vector<int> da = directions(a);
  const std::vector<int> db = directions(b);
  Difference result;
  int count = 0;
  for (int y = kBorder; y < kHeight - kBorder; ++y) {
    for (int x = kBorder; x < kWidth - kBorder; ++x, ++count) {
      const auto i = static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
      const int turn = std::abs(da[i] - db[i]);
      result.direction += std::min({turn, 256 - turn, 127}) >> 3;
      result.variance += (a[i] - b[i]) * (a[i] - b[i]);
    }
  }
  result.direction /= count;
  result.variance /= count;
  return result;
}

/// The translation, px, that makes two photographs as different; `curve` by 1/kShiftsPerPixel px.
double equivalent(const std::vector<double>& curve, double direction) {
  if (direction <= curve.front()) return 0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    if (direction > curve[i]) continue;
    return (static_cast<double>(i - 1) + (direction - curve[i - 1]) / (curve[i] - curve[i - 1])) / kShiftsPerPixel;
  }
  return static_cast<double>(curve.size() - 1) / kShiftsPerPixel;
}

struct Sample {
  double direction = 0;
  double variance = 0;
  void add(const Difference& one, int scenes) {
    direction += one.direction / scenes;
    variance += one.variance / scenes;
  }
};

}  // namespace

nlohmann::json study_interpolation(OutputDirectory& directory, const StudyScope& scope) {
  const int scenes = scope.quick ? 1 : 12;
  std::vector<double> scales;
  for (int i = 0; i <= 20; ++i) scales.push_back(0.5 * std::pow(2.0, i / 10.0));
  constexpr int kTranslations = kShiftsPerPixel / 2 + 1;  // up to half a pixel: the other half is its mirror
  calib::Random random(scope.seed);
  std::vector<double> translated(kShiftsPerPixel + 1);  // differences of photographs
  std::vector<double> clean(kShiftsPerPixel +
                            1);  // the same without noise: a scaled photograph has that of the exact one
  std::vector<std::vector<Sample>> scaling(methods.size(), std::vector<Sample>(scales.size()));
  std::vector<std::vector<Sample>> translation(methods.size(), std::vector<Sample>(kTranslations));
  Progress progress("scene");
  for (int scene = 0; scene < scenes; ++scene) {
    progress.show(static_cast<std::size_t>(scene), static_cast<std::size_t>(scenes));
    const Scene shown(random, 200);
    const Grey still = shown.photograph(0, random);
    const Grey still_clean = shown.without_noise(0);
    std::vector<Grey> shifted;
    for (int i = 0; i <= kShiftsPerPixel; ++i) {
      shifted.push_back(shown.photograph(static_cast<double>(i) / kShiftsPerPixel, random));
      translated[static_cast<std::size_t>(i)] += difference(still, shifted.back()).direction / scenes;
      const Grey other = shown.without_noise(static_cast<double>(i) / kShiftsPerPixel);
      clean[static_cast<std::size_t>(i)] += difference(still_clean, other).direction / scenes;
    }
    for (std::size_t m = 0; m < methods.size(); ++m) {
      for (int i = 0; i < kTranslations; ++i) {
        const Grey moved = transformed(still, static_cast<double>(i) / kShiftsPerPixel, 1, 0, 1, methods[m]);
        translation[m][static_cast<std::size_t>(i)].add(difference(moved, shifted[static_cast<std::size_t>(i)]),
                                                        scenes);
      }
    }
    for (std::size_t i = 0; i < scales.size(); ++i) {
      const double step = 1 / scales[i];
      const auto scaled = [&](int method) {
        return transformed(still, (kWidth - 1) / 2.0 * (1 - step), step, (kHeight - 1) / 2.0 * (1 - step), step,
                           method);
      };
      const Grey exact = scaled(kContinuous);
      for (std::size_t m = 0; m < methods.size(); ++m) {
        if (methods[m] >= 0) scaling[m][i].add(difference(scaled(methods[m]), exact), scenes);
      }
    }
  }
  progress.clear();
  nlohmann::json result;
  Csv scaling_table({"method", "bits", "scale", "sigma_grey", "mean_difference", "equivalent_translation_px"});
  Csv translation_table(
      {"method", "bits", "translation_px", "sigma_grey", "mean_difference", "equivalent_translation_px"});
  Panel scaling_panel{"scaling", "scale", "equivalent translation, px", {}};
  Panel scaling_sigma{"scaling", "scale", "sigma, grey levels", {}};
  Panel translation_panel{"translation", "translation, px", "equivalent translation, px", {}};
  const auto write = [](Csv& table, Panel& panel, int method, const std::vector<double>& places,
                        const std::vector<Sample>& samples, const std::vector<double>& curve) {
    Curve line{method_name(method), {}};
    double largest = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double px = equivalent(curve, samples[i].direction);
      table << method_name(method) << (method < 0 ? std::string() : std::to_string(method)) << places[i]
            << std::sqrt(samples[i].variance) << samples[i].direction << px;
      table.end_row();
      line.points.emplace_back(places[i], px);
      largest = std::max(largest, px);
    }
    panel.curves.push_back(line);
    return largest;
  };
  std::vector<double> shifts;
  for (int i = 0; i < kTranslations; ++i) shifts.push_back(static_cast<double>(i) / kShiftsPerPixel);
  const auto sigma = [](const std::vector<Sample>& samples) {
    double variance = 0;
    for (const Sample& sample : samples) variance += sample.variance / static_cast<double>(samples.size());
    return std::sqrt(variance);
  };
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const std::string name = method_name(methods[m]);
    result["translation"][name] = {{"largest_equivalent_px", write(translation_table, translation_panel, methods[m],
                                                                   shifts, translation[m], translated)},
                                   {"sigma_grey", sigma(translation[m])}};
    if (methods[m] < 0) continue;
    result["scaling"][name] = {
        {"largest_equivalent_px", write(scaling_table, scaling_panel, methods[m], scales, scaling[m], clean)},
        {"sigma_grey", sigma(scaling[m])}};
    Curve line{name, {}};
    for (std::size_t i = 0; i < scales.size(); ++i)
      line.points.emplace_back(scales[i], std::sqrt(scaling[m][i].variance));
    scaling_sigma.curves.push_back(line);
  }
  Csv curve_table({"translation_px", "mean_difference", "mean_difference_without_noise"});
  for (std::size_t i = 0; i < translated.size(); ++i) {
    curve_table << static_cast<double>(i) / kShiftsPerPixel << translated[i] << clean[i];
    curve_table.end_row();
  }
  directory.write("scaling.csv", scaling_table.text());
  directory.write("translation.csv", translation_table.text());
  directory.write("translated-photographs.csv", curve_table.text());
  directory.write("interpolation.svg", plot_svg("Interpolation with weights of few bits (7.5)",
                                                {scaling_panel, scaling_sigma, translation_panel}));
  const auto figure = [&](const char* kind, const char* name, const char* key) {
    return result[kind][name][key].get<double>();
  };
  result["findings"] = {
      fmt::format(
          "Scaling, against continuous weights: sigma {:.2f} grey levels for nearest, {:.2f} for steps of 1/4, {:.2f} "
          "for 1/8 (thesis: 7, 1.5)",
          figure("scaling", "nearest", "sigma_grey"), figure("scaling", "step 1/4", "sigma_grey"),
          figure("scaling", "step 1/8", "sigma_grey")),
      fmt::format("Scaling, equivalent translation at most {:.3f} px for nearest, {:.3f} for 1/4, {:.3f} for 1/8",
                  figure("scaling", "nearest", "largest_equivalent_px"),
                  figure("scaling", "step 1/4", "largest_equivalent_px"),
                  figure("scaling", "step 1/8", "largest_equivalent_px")),
      fmt::format(
          "Translation, against photographs: at most {:.3f} px for nearest, {:.3f} for 1/4, {:.3f} for 1/8, {:.3f} for "
          "continuous weights, {:.3f} for cubic ones",
          figure("translation", "nearest", "largest_equivalent_px"),
          figure("translation", "step 1/4", "largest_equivalent_px"),
          figure("translation", "step 1/8", "largest_equivalent_px"),
          figure("translation", "bilinear", "largest_equivalent_px"),
          figure("translation", "cubic", "largest_equivalent_px"))};
  return result;
}

}  // namespace horopter::cli
