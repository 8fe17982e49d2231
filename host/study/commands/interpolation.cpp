// SPDX-License-Identifier: Apache-2.0
// Thesis 7.5: what bilinear interpolation with weights of few bits costs, for scaling and for translation, as the
// translation that makes two images as different (Fig. 7.7, 7.8). Instead of photographs, scenes of which the image is
// known at any place: waves with a spectrum like that of photographs, through the blur of a lens and square pixels.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cli/progress.hpp"
#include "horopter/calib/random.hpp"
#include "horopter/study/filters.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using study::Plane;

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
constexpr std::array kMethods{0, 1, 2, 3, 4, 5, kContinuous, kCubic};

std::string method_name(int method) {
  if (method == kContinuous) return "bilinear";
  if (method == kCubic) return "cubic";
  return method == 0 ? "nearest" : fmt::format("step 1/{}", 1 << method);
}

double sinc(double x) { return x == 0 ? 1 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x); }

class Scene {
 public:
  Scene(calib::Random& random, int waves) {
    constexpr double kPi = std::numbers::pi;
    double power = 0;
    for (int i = 0; i < waves; ++i) {
      // 0.01 … 1 cycle a pixel; amplitudes that fall with the frequency are even ones, evenly spread over its
      // logarithm.
      const double frequency = 0.01 * std::pow(100.0, random.uniform());
      const double direction = 2 * kPi * random.uniform();
      Wave wave{frequency * std::cos(direction), frequency * std::sin(direction), 2 * kPi * random.uniform(), 1};
      wave.amplitude =
          sinc(wave.x) * sinc(wave.y) * std::exp(-2 * kPi * kPi * kBlur_px * kBlur_px * frequency * frequency);
      power += wave.amplitude * wave.amplitude / 2;
      waves_.push_back(wave);
    }
    for (Wave& wave : waves_) wave.amplitude *= kContrast / std::sqrt(power);
  }

  /// A photograph with the camera shifted along x: noise, 8 bits.
  Plane photograph(double shift_px, calib::Random& random) const {
    const double noise = kNoise / std::sqrt(kAveraged);
    Plane image = without_noise(shift_px);
    for (double& grey : image.values) grey = std::clamp(std::round(grey + noise * random.gaussian()), 0.0, 255.0);
    return image;
  }

  Plane without_noise(double shift_px) const {
    Plane image(kWidth, kHeight, 128);
    for (const Wave& wave : waves_) {
      const double step = 2 * std::numbers::pi * wave.x;
      for (int y = 0; y < kHeight; ++y) {
        // Angle sums instead of a cosine a pixel.
        const double start = 2 * std::numbers::pi * (wave.x * shift_px + wave.y * y) + wave.phase;
        double before = std::cos(start - step);
        double now = std::cos(start);
        for (int x = 0; x < kWidth; ++x) {
          image.at(x, y) += wave.amplitude * now;
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
Plane transformed(const Plane& image, double x0, double step_x, double y0, double step_y, int method) {
  Plane result(kWidth, kHeight);
  const auto at = [&](int x, int y) { return image.at(std::clamp(x, 0, kWidth - 1), std::clamp(y, 0, kHeight - 1)); };
  for (int y = 0; y < kHeight; ++y) {
    const Taps rows = taps(y0 + y * step_y, method);
    for (int x = 0; x < kWidth; ++x) {
      const Taps columns = taps(x0 + x * step_x, method);
      double sum = 0;
      for (int j = 0; j < 4; ++j) {
        if (rows.weights[static_cast<std::size_t>(j)] == 0) continue;
        for (int i = 0; i < 4; ++i) {
          sum += rows.weights[static_cast<std::size_t>(j)] * columns.weights[static_cast<std::size_t>(i)] *
                 at(columns.first + i, rows.first + j);
        }
      }
      result.at(x, y) = std::clamp(std::floor(sum + 0.5), 0.0, 255.0);
    }
  }
  return result;
}

/// Gradient's direction in 1/256 turn, after the 3×3 low-pass, of every pixel.
study::Raster<int> directions(const Plane& image) {
  const study::Gradient gradient = study::sobel(study::lowpass(image));
  study::Raster<int> result(kWidth, kHeight);
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    const double turns = std::atan2(gradient.y.values[i], gradient.x.values[i]) * 128 / std::numbers::pi;
    result.values[i] = static_cast<int>(std::lround(turns)) & 255;
  }
  return result;
}

struct Difference {
  double direction = 0;  ///< mean of DSAD's 4-bit differences
  double variance = 0;   ///< of grey levels
};

Difference difference(const Plane& a, const Plane& b) {
  const study::Raster<int> of_a = directions(a);
  const study::Raster<int> of_b = directions(b);
  Difference result;
  int count = 0;
  for (int y = kBorder; y < kHeight - kBorder; ++y) {
    for (int x = kBorder; x < kWidth - kBorder; ++x, ++count) {
      const int turn = std::abs(of_a.at(x, y) - of_b.at(x, y));
      result.direction += std::min({turn, 256 - turn, 127}) >> 3;
      result.variance += (a.at(x, y) - b.at(x, y)) * (a.at(x, y) - b.at(x, y));
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

/// Mean differences of one method at one place, over the scenes.
struct Sample {
  double direction = 0;
  double variance = 0;
  void add(const Difference& one, int scenes) {
    direction += one.direction / scenes;
    variance += one.variance / scenes;
  }
};

std::vector<double> scales() {
  std::vector<double> result;
  for (int i = 0; i <= 20; ++i) result.push_back(0.5 * std::pow(2.0, i / 10.0));
  return result;
}

/// Up to half a pixel: the other half is its mirror.
std::vector<double> translations_px() {
  std::vector<double> result;
  for (int i = 0; i <= kShiftsPerPixel / 2; ++i) result.push_back(static_cast<double>(i) / kShiftsPerPixel);
  return result;
}

/// Samples of every method at every place.
using Samples = std::vector<std::vector<Sample>>;

struct Measurements {
  std::vector<double> translated = std::vector<double>(kShiftsPerPixel + 1);  ///< differences of photographs
  /// The same without noise: a scaled photograph has that of the exact one.
  std::vector<double> clean = std::vector<double>(kShiftsPerPixel + 1);
  Samples scaling = Samples(kMethods.size(), std::vector<Sample>(scales().size()));
  Samples translation = Samples(kMethods.size(), std::vector<Sample>(translations_px().size()));
  /// Largest difference to continuous weights, grey levels, where the weights are exact.
  double off_translated = 0;
  double off_scaled = 0;

  /// One of so many scenes.
  void add(const Scene& shown, int scenes, calib::Random& random) {
    const Plane still = shown.photograph(0, random);
    const Plane still_clean = shown.without_noise(0);
    std::vector<Plane> shifted;
    for (std::size_t i = 0; i < translated.size(); ++i) {
      const double shift_px = static_cast<double>(i) / kShiftsPerPixel;
      shifted.push_back(shown.photograph(shift_px, random));
      translated[i] += difference(still, shifted.back()).direction / scenes;
      clean[i] += difference(still_clean, shown.without_noise(shift_px)).direction / scenes;
    }
    add_translations(still, shifted, scenes);
    add_scalings(still, scenes);
    add_multiples(still);
  }

 private:
  void add_translations(const Plane& still, const std::vector<Plane>& shifted, int scenes) {
    const std::vector<double> shifts_px = translations_px();
    for (std::size_t m = 0; m < kMethods.size(); ++m)
      for (std::size_t i = 0; i < shifts_px.size(); ++i)
        translation[m][i].add(difference(transformed(still, shifts_px[i], 1, 0, 1, kMethods[m]), shifted[i]), scenes);
  }

  /// Translations and reciprocal scales, 1/2 to 2, that are multiples of a step of the weights: these about a pixel.
  void add_multiples(const Plane& still) {
    const auto off = [&](double shift_px, double step, int method) {
      const Plane rounded = transformed(still, shift_px, step, 0, step, method);
      const Plane exact = transformed(still, shift_px, step, 0, step, kContinuous);
      double largest = 0;
      for (std::size_t i = 0; i < exact.values.size(); ++i)
        largest = std::max(largest, std::abs(rounded.values[i] - exact.values[i]));
      return largest;
    };
    for (const int method : {1, 2, 3, 4}) {
      const int steps = 1 << method;
      for (int i = 0; i <= steps; ++i)
        off_translated = std::max(off_translated, off(std::ldexp(i, -method), 1, method));
      for (int i = steps / 2; i <= 2 * steps; ++i)
        off_scaled = std::max(off_scaled, off(0, std::ldexp(i, -method), method));
    }
  }

  /// About the middle of the image.
  void add_scalings(const Plane& still, int scenes) {
    const std::vector<double> all = scales();
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double step = 1 / all[i];
      const auto scaled = [&](int method) {
        return transformed(still, (kWidth - 1) / 2.0 * (1 - step), step, (kHeight - 1) / 2.0 * (1 - step), step,
                           method);
      };
      const Plane exact = scaled(kContinuous);
      for (std::size_t m = 0; m < kMethods.size(); ++m) {
        if (kMethods[m] >= 0) scaling[m][i].add(difference(scaled(kMethods[m]), exact), scenes);
      }
    }
  }
};

double sigma(const std::vector<Sample>& samples) {
  double variance = 0;
  for (const Sample& sample : samples) variance += sample.variance / static_cast<double>(samples.size());
  return std::sqrt(variance);
}

/// What methods cost at some places, `kind` of places; `curve` as of equivalent().
void tabulate(StudyReport& report, const std::string& kind, const char* column, const std::vector<double>& places,
              const Samples& all, const std::vector<double>& curve, std::vector<Panel>& panels) {
  Csv table({"method", "bits", column, "sigma_grey", "mean_difference", "equivalent_translation_px"});
  const std::string x_label = kind == "scaling" ? "scale" : "translation, px";
  Panel equivalents{kind, x_label, "equivalent translation, px", {}};
  Panel sigmas{kind, x_label, "sigma of the difference, grey levels", {}};
  for (std::size_t m = 0; m < kMethods.size(); ++m) {
    if (kind == "scaling" && kMethods[m] < 0) continue;  // what scaling is compared with
    const std::string name = method_name(kMethods[m]);
    Curve& equivalents_of = equivalents.curves.emplace_back(Curve{name, {}});
    Curve& sigmas_of = sigmas.curves.emplace_back(Curve{name, {}});
    double largest = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Sample& sample = all[m][i];
      const double px = equivalent(curve, sample.direction);
      table.row(name, kMethods[m] < 0 ? std::string() : std::to_string(kMethods[m]), places[i],
                std::sqrt(sample.variance), sample.direction, px);
      equivalents_of.points.emplace_back(places[i], px);
      sigmas_of.points.emplace_back(places[i], std::sqrt(sample.variance));
      largest = std::max(largest, px);
    }
    report.result[kind][name] = {{"largest_equivalent_px", largest}, {"sigma_grey", sigma(all[m])}};
  }
  report.table(kind + ".csv", table);
  panels.push_back(equivalents);
  panels.push_back(sigmas);
}

std::vector<Statement> statements(const nlohmann::json& result, const Measurements& found) {
  using namespace measured;
  const auto largest = [&](const char* name) {
    return result.at("translation").at(name).at("largest_equivalent_px").get<double>();
  };
  const auto sigma_of = [&](const char* name) { return result.at("scaling").at(name).at("sigma_grey").get<double>(); };
  double least = INFINITY;
  double most = 0;
  const std::array names{"nearest", "step 1/2", "step 1/4", "step 1/8"};
  for (std::size_t i = 1; i < names.size(); ++i) {
    const double ratio = sigma_of(names[i - 1]) / sigma_of(names[i]);
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  return {
      {"Fig. 7.7, 7.8: the standard deviation of the intensity-difference introduced by weight quantization is "
       "proportional to the quantization step.",
       {least, most},
       "Half the step divides it by {:.2f} to {:.2f} (scaling, steps of 1 to 1/8)",
       "By 1.8 to 2.2; partly: 1.6 to 2.4",
       {first >= 1.8 && second <= 2.2, first >= 1.6 && second <= 2.4},
       "the error of the interpolation is proportional to the step of its weights"},
      {"The measured standard deviation was σ ≈ 7 for nearest neighbor and σ ≈ 1.5 for a quantization step of 1/4; it is "
       "a function of the high frequencies in the image.",
       {sigma_of("nearest") / sigma_of("step 1/4"), sigma_of("nearest"), sigma_of("step 1/4")},
       "Scaling: {1:.1f} and {2:.1f} grey levels, {0:.2f} to 1",
       "Their ratio within 20 % of 7 to 1.5, images being others; partly: 35 %",
       {near(first, 7 / 1.5, 0.2 * 7 / 1.5), near(first, 7 / 1.5, 0.35 * 7 / 1.5)}},
      {"For translations and reciprocal scaling factors that are a multiple of the quantization step, bilinear "
       "interpolation with discrete weights produces the same result as true bilinear interpolation.",
       {found.off_translated, found.off_scaled},
       "Largest difference of a pixel, steps of 1/2 to 1/16: translation {:g}, scaling (1/2 to 2, about a pixel) {:g} grey "
       "levels",
       "None of both; partly: none of one",
       {first <= 0 && second <= 0, first <= 0 || second <= 0}},
      {"A quantization step of 1/8 introduces only a small additional error compared to true bilinear interpolation.",
       {largest("step 1/8"), largest("bilinear"), largest("nearest")},
       "Translation, equivalent to at most {:.3f} px; continuous weights {:.3f} px, nearest {:.3f} px",
       "At most 10 % more than continuous weights; partly: 30 %",
       {first <= 1.1 * second, first <= 1.3 * second},
       "weights of 3 bits (steps of 1/8) are enough"}};
}

}  // namespace

void study_interpolation(StudyReport& report, const StudyScope& scope) {
  const int scenes = scope.quick ? 1 : 12;
  calib::Random random(scope.seed);
  Measurements found;
  Progress progress("scene");
  for (int scene = 0; scene < scenes; ++scene) {
    progress.show(static_cast<std::size_t>(scene), static_cast<std::size_t>(scenes));
    found.add(Scene(random, 200), scenes, random);
  }
  progress.clear();

  std::vector<Panel> panels;
  tabulate(report, "scaling", "scale", scales(), found.scaling, found.clean, panels);
  tabulate(report, "translation", "translation_px", translations_px(), found.translation, found.translated, panels);
  report.plot("interpolation.svg", "Fig. 7.7, 7.8: interpolation with weights of few bits", panels, 2);
  Csv table({"translation_px", "mean_difference", "mean_difference_without_noise"});
  for (std::size_t i = 0; i < found.translated.size(); ++i)
    table.row(static_cast<double>(i) / kShiftsPerPixel, found.translated[i], found.clean[i]);
  report.table("translated-photographs.csv", table);

  report.state("7.5", statements(report.result, found));
  const auto largest = [&](const char* kind, const char* name) {
    return report.result[kind][name]["largest_equivalent_px"].get<double>();
  };
  const auto sigma_of = [&](const char* name) { return report.result["scaling"][name]["sigma_grey"].get<double>(); };
  report.finding(
      "Scaling, against continuous weights: sigma {:.2f} grey levels for nearest, {:.2f} for steps of 1/4, {:.2f} for "
      "1/8 (thesis: 7, 1.5)",
      sigma_of("nearest"), sigma_of("step 1/4"), sigma_of("step 1/8"));
  report.finding("Scaling, equivalent translation at most {:.3f} px for nearest, {:.3f} for 1/4, {:.3f} for 1/8",
                 largest("scaling", "nearest"), largest("scaling", "step 1/4"), largest("scaling", "step 1/8"));
  report.finding(
      "Translation, against photographs: at most {:.3f} px for nearest, {:.3f} for 1/4, {:.3f} for 1/8, {:.3f} for "
      "continuous weights, {:.3f} for cubic ones",
      largest("translation", "nearest"), largest("translation", "step 1/4"), largest("translation", "step 1/8"),
      largest("translation", "bilinear"), largest("translation", "cubic"));
}

}  // namespace horopter::cli
