// SPDX-License-Identifier: Apache-2.0
// Thesis 9.2: how much texture the correlation needs against the noise (Fig. 9.1, 9.2), and for which measure of the
// two the error is a function of their ratio alone.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/progress.hpp"
#include "horopter/calib/random.hpp"
#include "horopter/study/filters.hpp"
#include "horopter/study/series.hpp"
#include "horopter/study/simulation.hpp"
#include "texture.hpp"

namespace horopter::cli {
namespace {

using study::Plane;

study::Setting dsad() {
  study::Setting setting;
  setting.criterion = &study::criterion("DSAD");
  setting.preparation = {study::Feature::direction, true};
  setting.kernel = 9;
  return setting;
}

study::Conditions conditions_of(const StudyScope& scope, double texture_grey, double noise_grey) {
  study::Conditions conditions;
  conditions.camera.width = scope.quick ? 320 : 630;
  conditions.camera.height = scope.quick ? 240 : 470;
  conditions.lighting.mean_grey = 128;
  conditions.lighting.deviation_grey = texture_grey;
  conditions.electronics = {.noise_grey = noise_grey, .averaged = 1};
  conditions.seed = scope.seed;
  return conditions;
}

double mean_square(const Plane& plane) {
  constexpr int kBorder = 3;  ///< px that the filters reach beyond the image
  double sum = 0;
  for (int y = kBorder; y < plane.height - kBorder; ++y) {
    for (int x = kBorder; x < plane.width - kBorder; ++x) sum += plane.at(x, y) * plane.at(x, y);
  }
  return sum / ((plane.width - 2.0 * kBorder) * (plane.height - 2.0 * kBorder));
}

/// How much there is of a pattern, of texture without noise or of noise without texture.
struct Amount {
  const char* name;
  double (*of)(const Plane& pattern);
};
/// The thesis's first; the others are of what the criterion works on.
constexpr std::array kAmounts{
    Amount{"deviation in 7x7", [](const Plane& pattern) { return study::local_deviation(pattern, 7); }},
    Amount{"deviation in 7x7 after the low-pass",
           [](const Plane& pattern) { return study::local_deviation(study::lowpass(pattern), 7); }},
    Amount{"RMS gradient after the low-pass",
           [](const Plane& pattern) {
             const study::Gradient gradient = study::sobel(study::lowpass(pattern));
             return std::sqrt(mean_square(gradient.x) + mean_square(gradient.y));
           }},
    Amount{"RMS gradient along the disparity after the low-pass",
           [](const Plane& pattern) { return std::sqrt(mean_square(study::sobel(study::lowpass(pattern)).x)); }}};

/// Deviation of the converter's rounding.
const double kRounding = 1 / std::sqrt(12.0);
/// Less noise than this does not spread the rounding evenly.
constexpr double kLeastNoise = 0.5;
/// Curves are compared from here on.
constexpr double kSmallestRatio = 2;

study::Texture of_kind(study::TextureKind kind, double largest_px = 3) {
  study::Texture result;
  result.kind = kind;
  result.largest_px = largest_px;
  return result;
}

constexpr std::array kD50s_px{0.4, 0.7, 1.0, 1.4};

/// The errors of a pattern over the ratio of texture to noise in the thesis's measure, and what it is in others.
struct Pattern {
  std::string name;
  std::array<std::vector<std::pair<double, double>>, kD50s_px.size()> errors;  ///< ratio, px
  std::array<double, kD50s_px.size()> least{};   ///< px, without noise but the converter's rounding
  std::array<double, kAmounts.size()> factor{};  ///< ratio in this measure over that in the thesis's
  double passes_lowpass = 0;                     ///< share of the deviation
};

/// On straight lines between the logarithms; none beyond the curve's ends.
std::optional<double> at(const std::vector<std::pair<double, double>>& curve, double ratio) {
  constexpr double kTolerance = 1e-9;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const auto& [low, before] = curve[i - 1];
    const auto& [high, after] = curve[i];
    if (ratio < low * (1 - kTolerance) || ratio > high * (1 + kTolerance)) continue;
    const double part = std::clamp(std::log(ratio / low) / std::log(high / low), 0.0, 1.0);
    return std::exp(std::lerp(std::log(before), std::log(after), part));
  }
  return std::nullopt;
}

/// How far errors are apart at most: half of the difference over the mean, of the furthest two at one ratio.
struct Apart {
  double share = 0, ratio = 0, d50_px = 0;
};

class NoiseStudy {
 public:
  explicit NoiseStudy(const StudyScope& scope)
      : scope_(scope),
        ratios_(scope.quick ? std::vector<double>{1, 2, 5, 10}
                            : std::vector<double>{1, 1.25, 1.6, 2, 2.5, 3, 4, 5, 7, 10, 14, 20}) {
    const double step_px = scope.quick ? 0.2 : 0.1;
    for (int i = 0; i * step_px <= study::Detection::kLargest_px + 1e-9; ++i) disparities_.push_back(i * step_px);
    Plane white(512, 512);
    calib::Random random(scope.seed, 1);
    for (double& value : white.values) value = random.gaussian();
    for (std::size_t m = 0; m < kAmounts.size(); ++m) of_noise_[m] = kAmounts[m].of(white);
  }

  const Pattern& add(const std::string& name, const study::Texture& texture, double texture_grey, std::uint64_t seed) {
    study::Conditions conditions = conditions_of(scope_, texture_grey, 0);
    conditions.texture = texture;
    conditions.seed = seed;
    const study::Simulation simulation(conditions, disparities_.back());
    Pattern pattern;
    pattern.name = name;
    const Plane still = simulation.exact(0);
    std::array<double, kAmounts.size()> of_texture{};
    for (std::size_t m = 0; m < kAmounts.size(); ++m) of_texture[m] = kAmounts[m].of(still);
    for (std::size_t m = 0; m < kAmounts.size(); ++m)
      pattern.factor[m] = of_texture[m] / of_noise_[m] / (of_texture[0] / of_noise_[0]);
    pattern.passes_lowpass = of_texture[1] / of_texture[0];
    for (const double ratio : ratios_) {
      progress_.show(done_++, {});
      // The rounding is a part of the noise.
      const double total = of_texture[0] / of_noise_[0] / ratio;
      const double analogue = std::sqrt(std::max(0.0, total * total - kRounding * kRounding));
      if (analogue < kLeastNoise) continue;
      const auto detection = detect(simulation, analogue);
      for (std::size_t d = 0; d < kD50s_px.size(); ++d) {
        const double error = detection.segmentation_error(kD50s_px[d]);
        table_.row(name, texture_grey, total * of_noise_[0], ratio, kD50s_px[d], error);
        pattern.errors[d].emplace_back(ratio, error);
      }
    }
    const auto detection = detect(simulation, 0);
    for (std::size_t d = 0; d < kD50s_px.size(); ++d) pattern.least[d] = detection.segmentation_error(kD50s_px[d]);
    return patterns_.emplace_back(std::move(pattern));
  }

  using Choice = std::vector<std::string>;
  /// Of patterns by their names, with `measure` of texture and noise; `relative`: to each one's error without noise.
  Apart apart(const Choice& names, std::size_t measure = 0, bool relative = false) const {
    Apart furthest;
    for (std::size_t d = 0; d < kD50s_px.size(); ++d) {
      for (const double ratio : ratios_) {
        if (ratio < kSmallestRatio) continue;
        std::vector<double> errors;
        for (const std::string& name : names) {
          const Pattern& pattern = of(name);
          const auto error = at(pattern.errors[d], ratio / pattern.factor[measure]);
          if (error) errors.push_back(relative ? *error / pattern.least[d] : *error);
        }
        widen(furthest, errors, ratio, kD50s_px[d]);
      }
    }
    return furthest;
  }
  Apart apart_without_noise(const Choice& names) const {
    Apart furthest;
    for (std::size_t d = 0; d < kD50s_px.size(); ++d) {
      std::vector<double> errors;
      for (const std::string& name : names) errors.push_back(of(name).least[d]);
      widen(furthest, errors, INFINITY, kD50s_px[d]);
    }
    return furthest;
  }
  /// The smallest ratio with which an error is reached, of one pattern, in the thesis's measure; none up to the largest.
  std::optional<double> needed(const std::string& name, std::size_t d50, double error_px) const {
    const auto& curve = of(name).errors[d50];
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const auto& [ratio, error] = curve[i];
      if (error > error_px) continue;
      if (i == 0) return ratio;
      const auto& [below, larger] = curve[i - 1];
      const double part = std::log(larger / error_px) / std::log(larger / error);
      return std::exp(std::lerp(std::log(below), std::log(ratio), part));
    }
    return std::nullopt;
  }
  const Csv& table() const { return table_; }
  std::vector<Panel> panels() const {
    std::vector<Panel> result;
    for (std::size_t d = 0; d < kD50s_px.size(); ++d) {
      Panel panel{fmt::format("D50 = {:g} px", kD50s_px[d]),
                  "texture / noise (deviations in 7×7 px)",
                  "segmentation error, px",
                  {}};
      for (const Pattern& pattern : patterns_) panel.curves.push_back({pattern.name, pattern.errors[d]});
      result.push_back(std::move(panel));
    }
    return result;
  }

 private:
  study::Detection detect(const study::Simulation& simulation, double noise_grey) const {
    study::Electronics electronics = simulation.conditions().electronics;
    electronics.noise_grey = noise_grey;
    study::ImageSeries series;
    series.reference = simulation.expose(simulation.exact(0), electronics, 0);
    series.disparities_px = disparities_;
    series.image = [&](std::size_t i) {
      return simulation.expose(simulation.exact(disparities_[i]), electronics, i + 1);
    };
    return study::detect(series, {dsad()}).front();
  }
  const Pattern& of(const std::string& name) const { return *std::ranges::find(patterns_, name, &Pattern::name); }
  static void widen(Apart& furthest, const std::vector<double>& errors, double ratio, double d50_px) {
    if (errors.size() < 2) return;
    const auto [least, most] = std::ranges::minmax(errors);
    const double share = (most - least) / (most + least);
    if (share > furthest.share) furthest = {share, ratio, d50_px};
  }

  const StudyScope& scope_;
  std::vector<double> ratios_;
  std::vector<double> disparities_;
  std::array<double, kAmounts.size()> of_noise_{};  ///< of white noise of deviation 1
  std::vector<Pattern> patterns_;
  Csv table_{{"pattern", "texture_grey", "noise_grey", "ratio", "d50_px", "segmentation_error_px"}};
  Progress progress_{"pattern"};
  std::size_t done_ = 0;
};

nlohmann::json to_json(const Apart& apart) {
  nlohmann::json result{{"within", apart.share}, {"d50_px", apart.d50_px}};
  if (std::isfinite(apart.ratio)) result["ratio"] = apart.ratio;
  return result;
}

constexpr double kKindsGrey = 20;  ///< texture of patterns that differ in kind

/// Names of the patterns that are compared.
struct Choices {
  NoiseStudy::Choice strengths, kinds, alike;
};

Choices add_patterns(NoiseStudy& noise, const StudyScope& scope, nlohmann::json& result) {
  const auto add = [&](const std::string& name, const study::Texture& texture, double grey, std::uint64_t seed) {
    const Pattern& pattern = noise.add(name, texture, grey, seed);
    result["patterns"][name] = {{"passes_lowpass", pattern.passes_lowpass}};
    return name;
  };
  Choices choices;
  // Another pattern for each: with one pattern all strengths would be the same but for the converter.
  for (const double grey : scope.quick ? std::vector<double>{8, 20, 32} : std::vector<double>{5, 10, 20, 40})
    choices.strengths.push_back(
        add(fmt::format("texture {:g}", grey), {}, grey, scope.seed + static_cast<std::uint64_t>(grey)));
  const std::string leaves = fmt::format("texture {:g}", kKindsGrey);
  const std::string dots = add("printed-dots", of_kind(study::TextureKind::printed_dots), kKindsGrey, scope.seed);
  const std::string band = add("band-noise", of_kind(study::TextureKind::band_noise), kKindsGrey, scope.seed);
  // Structures larger than the 9×9 window, too, as leaves and dots have them by chance: nearly their spectrum.
  const std::string broad =
      add("band-noise to 12 px", of_kind(study::TextureKind::band_noise, 12), kKindsGrey, scope.seed);
  choices.kinds = {leaves, dots, band};
  choices.alike = {leaves, dots, broad};
  return choices;
}

/// How far the kinds are apart with each measure of texture and noise; in words those that are not the thesis's.
std::string compare_measures(StudyReport& report, const NoiseStudy& noise, const NoiseStudy::Choice& kinds) {
  Csv table({"measure_of_texture_and_noise", "kinds_within", "ratio", "d50_px"});
  std::string others;
  for (std::size_t m = 0; m < kAmounts.size(); ++m) {
    const Apart apart = noise.apart(kinds, m);
    table.row(kAmounts[m].name, apart.share, apart.ratio, apart.d50_px);
    report.result["measures_of_ratio"][kAmounts[m].name] = to_json(apart);
    if (m > 0) others += fmt::format("{}{} ±{:.1f} %", m > 1 ? ", " : "", kAmounts[m].name, 100 * apart.share);
  }
  report.table("fig-9-2-measures.csv", table);
  report.finding("Fig. 9.2: the kinds with other measures of texture and noise: {}", others);
  return others;
}

/// 9: what texture is needed at least.
Statement needed_texture(StudyReport& report, const NoiseStudy& noise) {
  using namespace measured;
  const std::string pattern = fmt::format("texture {:g}", kKindsGrey);
  Csv table({"error_px", "d50_px", "texture_to_noise"});
  std::string needed;
  int reached = 0;
  int reached_to_1 = 0;
  for (const double error : {0.1, 0.15, 0.2, 0.3}) {
    std::string ratios;
    for (std::size_t d = 0; d < kD50s_px.size(); ++d) {
      const auto ratio = noise.needed(pattern, d, error);
      table.row(error, kD50s_px[d], ratio ? fmt::format("{:.2f}", *ratio) : "");
      report.result["texture_to_noise_needed"][fmt::format("{:g}", error)][fmt::format("{:g}", kD50s_px[d])] =
          ratio ? nlohmann::json(*ratio) : nlohmann::json();
      ratios += ratio ? fmt::format(" {:.1f}", *ratio) : " –";
      if (error == 0.3 && ratio) {
        ++reached;
        reached_to_1 += kD50s_px[d] <= 1 ? 1 : 0;
      }
    }
    needed += fmt::format("{}error {:g} px:{}", needed.empty() ? "" : "; ", error, ratios);
  }
  report.table("texture-needed.csv", table);
  report.finding("Ratio of texture to noise that is needed at D50 = {:g} px: {}", fmt::join(kD50s_px, ", "), needed);
  return {"The minimally tolerable texture must be known: what is needed against the noise.",
          {reached, kD50s_px.size(), reached_to_1, needed, fmt::format("{:g}", fmt::join(kD50s_px, ", "))},
          "Ratio of the deviations in 7×7 px at D50 = {4} px (–: not at a ratio of 20): {3}",
          "An error of 0.3 px, the largest tolerable one, is reached for every D50; partly: up to 1 px",
          {first >= second, third >= 3},
          "it can be said how strong a texture must be against the noise"};
}

void errors_over_noise(StudyReport& report, const StudyScope& scope) {
  NoiseStudy noise(scope);
  const Choices choices = add_patterns(noise, scope, report.result);
  report.table("fig-9-2.csv", noise.table());
  report.plot("fig-9-2.svg", "Fig. 9.2: segmentation error of DSAD 9×9 over texture to noise", noise.panels(), 2);
  const auto found = [&](const char* key, const Apart& apart, const std::string& what) {
    report.result[key] = to_json(apart);
    report.finding("Fig. 9.2: {} lie within ±{:.1f} % (furthest at {}D50 {:g} px)", what, 100 * apart.share,
                   std::isfinite(apart.ratio) ? fmt::format("ratio {:g}, ", apart.ratio) : "", apart.d50_px);
    return 100 * apart.share;
  };
  const double strengths = found("strengths", noise.apart(choices.strengths),
                                 "the errors of all strengths of texture at one ratio of texture to noise");
  const double kinds =
      found("kinds", noise.apart(choices.kinds), "with other kinds of texture (band noise, dots), the errors");
  const double least = found("kinds_without_noise", noise.apart_without_noise(choices.kinds),
                             "the same kinds without noise, where no ratio can bring them together,");
  found("kinds_relative", noise.apart(choices.kinds, 0, true), "errors as multiples of the kind's own without noise");
  const double alike = found("kinds_of_like_spectrum", noise.apart(choices.alike),
                             "kinds of like spectra (leaves, dots, band noise up to 12 px)");
  const std::string others = compare_measures(report, noise, choices.kinds);
  using namespace measured;
  report.state(
      "9.2",
      {{"Fig. 9.2: the segmentation error is only a function of the texture to noise ratio, independent of texture or noise "
        "alone.",
        {strengths, kinds, least, alike, others, scope.quick ? 8 : 5, scope.quick ? 32 : 40},
        "Strengths of {5} to {6} grey levels, another pattern each: within ±{0:.1f} %. Dead leaves, dots and band "
        "noise: ±{1:.1f} %; ±{2:.1f} % without any noise, where no measure of the ratio helps ({4}). Their spectra "
        "differ: with a band up to 12 px ±{3:.1f} %",
        "Within ±3 % at ratios from 2 to 20; partly: for all strengths of one kind of texture",
        {first <= 3 && second <= 3, first <= 3},
        "the error depends on the ratio of texture to noise alone"},
       needed_texture(report, noise)});
}

/// Fig. 9.1; the mean of DSAD, in % of its largest value, by ratio, then disparity (0, 0.5, 1 px, …).
std::vector<std::vector<double>> histograms(StudyReport& report, const StudyScope& scope) {
  std::vector<std::vector<double>> means;
  Csv table({"texture_to_noise", "disparity_px", "from", "to", "density"});
  std::vector<Panel> panels;
  const double largest = dsad().criterion->worst(9);
  for (const double ratio : {3.0, 20.0}) {
    Panel panel{fmt::format("texture / noise {:g}", ratio), "DSAD, share of its largest value", "density", {}};
    const std::vector<double> disparities{0, 0.5, 1, 1.5, 2, 3};
    const study::Simulation simulation(conditions_of(scope, 20, 20 / ratio), disparities.back());
    const auto detection = study::detect(study::photographs(simulation, disparities), {dsad()}).front();
    means.emplace_back();
    for (std::size_t i = 0; i < disparities.size(); ++i) {
      means.back().push_back(100 * detection.histograms()[i].mean() / largest);
      Curve curve{fmt::format("{:g} px", disparities[i]), {}};
      for (const auto& bar : detection.histograms()[i].density(60)) {
        table.row(ratio, disparities[i], bar.from / largest, bar.to / largest, bar.density * largest);
        curve.points.emplace_back(0.5 * (bar.from + bar.to) / largest, bar.density * largest);
      }
      panel.curves.push_back(std::move(curve));
    }
    panels.push_back(std::move(panel));
  }
  report.table("fig-9-1.csv", table);
  report.plot("fig-9-1.svg", "Fig. 9.1: histograms of DSAD 9×9 at several disparities, weak and strong texture", panels,
              2);
  return means;
}

Statement weak_and_strong(const std::vector<std::vector<double>>& means) {
  using namespace measured;
  const std::vector<double>& weak = means[0];
  const std::vector<double>& strong = means[1];
  return {"Fig. 9.1: weak texture produces higher dissimilarity values than strong texture.",
          {weak[0], strong[0], weak[2], strong[2]},
          "Mean DSAD at ratios of 3 and 20: {:.1f} and {:.1f} % of T_max at 0 px, {:.1f} and {:.1f} % at 1 px",
          "Higher at 0 and at 1 px; partly: at 0 px",
          {first > second && third > fourth, first > second},
          "a weak texture looks as if it were displaced"};
}

}  // namespace

void texture_against_noise(StudyReport& report, const StudyScope& scope) {
  report.result["conditions"] = study::to_json(conditions_of(scope, 20, 2));
  report.state("9.2", {weak_and_strong(histograms(report, scope))});
  errors_over_noise(report, scope);
}

}  // namespace horopter::cli
