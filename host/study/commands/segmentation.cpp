// SPDX-License-Identifier: Apache-2.0
// Thesis 8.4 and 11.2.1: how well each criterion tells small disparities from large ones.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "conditions.hpp"
#include "horopter/study/filters.hpp"
#include "segmentation_measures.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using study::Detection;
using study::Feature;
using study::Preparation;
using study::ResultFilter;
using study::Setting;

constexpr double kDog_w_px = 5;
constexpr double kFarthest_px = 14;  ///< of the 700 images of 8.4.1

const std::vector<Prefilter> kPrefilters{Prefilter::none, Prefilter::lowpass, Prefilter::highpass,
                                         Prefilter::lowpass_highpass};

Preparation preparation(const std::string& criterion, Prefilter prefilter) {
  Preparation result;
  result.feature = study::criterion(criterion).feature();
  result.lowpass = prefilter == Prefilter::lowpass || prefilter == Prefilter::lowpass_highpass;
  result.highpass = prefilter == Prefilter::highpass || prefilter == Prefilter::lowpass_highpass;
  if (result.feature == Feature::camera || result.feature == Feature::roberts_sign) result = {result.feature};
  return result;
}

const char* label(Prefilter prefilter) {
  switch (prefilter) {
    case Prefilter::lowpass:
      return "LP";
    case Prefilter::highpass:
      return "HP";
    case Prefilter::lowpass_highpass:
      return "LP+HP";
    default:
      return "no prefilter";
  }
}

std::vector<Setting> settings_of(const std::vector<int>& kernels, const std::vector<double>& log_w_px,
                                 const std::vector<ResultFilter>& filters) {
  std::vector<Setting> result;
  for (const auto& one : study::criteria()) {
    std::set<Preparation> preparations;
    if (one->feature() == Feature::log_sign) {
      for (const double w : log_w_px) preparations.insert({Feature::log_sign, false, false, w});
    } else if (one->feature() == Feature::dog_sign) {
      preparations.insert({Feature::dog_sign, false, false, kDog_w_px});
    } else {
      for (const Prefilter prefilter : kPrefilters) {
        if (one->feature() == Feature::direction && prefilter != Prefilter::none && prefilter != Prefilter::lowpass)
          continue;
        preparations.insert(preparation(one->name(), prefilter));
      }
    }
    for (const Preparation& prepared : preparations)
      for (const int kernel : kernels)
        for (const ResultFilter filter : filters) result.push_back({one.get(), prepared, kernel, filter});
  }
  return result;
}

using NamedDetections = std::vector<std::pair<std::string, const Detection*>>;

/// Up to an error of 1 px; what is worse is cut off.
Curve error_curve(const std::string& name, const Detection& detection) {
  Curve curve{name, {}};
  for (const double d : detection.disparities_px()) {
    if (d <= 0 || d > 2.01) continue;
    const double error = detection.segmentation_error(d);
    curve.points.emplace_back(d, error <= 1 ? error : std::nan(""));
  }
  return curve;
}

Curve rate_curve(const std::string& name, const Detection& detection, double d50_px) {
  Curve curve{name, {}};
  const std::vector<double> rates = detection.rates(detection.threshold(d50_px));
  for (std::size_t i = 0; i < rates.size(); ++i)
    curve.points.emplace_back(detection.disparities_px()[i], 100 * rates[i]);
  return curve;
}

Panel error_panel(const std::string& title, const NamedDetections& of) {
  Panel panel{title, "segmentation disparity D50, px", "segmentation error, px", {}};
  for (const auto& [name, detection] : of) panel.curves.push_back(error_curve(name, *detection));
  return panel;
}

Panel rate_panel(const std::string& title, const NamedDetections& of, double d50_px) {
  Panel panel{title, "disparity, px", "detection rate, %", {}};
  for (const auto& [name, detection] : of) panel.curves.push_back(rate_curve(name, *detection, d50_px));
  return panel;
}

/// Mean and deviation over disparity, of the criterion's own values.
std::vector<Panel> statistics(const NamedDetections& of, double best) {
  Panel mean{"Mean", "disparity, px", "mean of the criterion", {}};
  Panel deviation{"Standard deviation", "disparity, px", "deviation of the criterion", {}};
  for (const auto& [name, detection] : of) {
    Curve means{name, {}};
    Curve deviations{name, {}};
    for (std::size_t i = 0; i < detection->disparities_px().size(); ++i) {
      const auto& histogram = detection->histograms()[i];
      const double d = detection->disparities_px()[i];
      means.points.emplace_back(d, best > 0 ? best - histogram.mean() : histogram.mean());
      deviations.points.emplace_back(d, histogram.deviation());
    }
    mean.curves.push_back(means);
    deviation.curves.push_back(deviations);
  }
  return {mean, deviation};
}

std::string square(int kernel) { return fmt::format("{0}×{0}", kernel); }

/// The plots of one experiment.
class Figures {
 public:
  Figures(StudyReport& report, const Segmentation& found, const std::vector<int>& kernels,
          const std::vector<double>& log_w_px)
      : report_(report), found_(found), kernels_(kernels), log_w_px_(log_w_px) {}

  void all() {
    portrait("fig-8-4.svg", "Fig. 8.4: NSAD on high-pass filtered images, 9×9", found_.of("NSAD", Prefilter::highpass));
    portrait("fig-8-5.svg", "Fig. 8.5: DSAD with low-pass, 9×9", found_.of("DSAD", Prefilter::lowpass));
    lowpass_compared();
    highpass_by_kernel();
    both_compared();
    signs();
    all_methods();
    direction_by_kernel();
    result_filters();
    thresholds();
  }

 private:
  /// Fig. 8.4, 8.5: all about one setting.
  void portrait(const std::string& file, const std::string& title, const Detection& detection) {
    Panel histograms{"Histograms", "value of the criterion", "density", {}};
    Panel rates{"Detection rates, by D50", "disparity, px", "detection rate, %", {}};
    for (const double d : {0.4, 0.8, 1.2, 1.6, 2.0, 2.8}) {
      Curve curve{fmt::format("{:.1f} px", d), {}};
      const auto place = static_cast<std::size_t>(
          std::lower_bound(detection.disparities_px().begin(), detection.disparities_px().end() - 1, d - 1e-6) -
          detection.disparities_px().begin());
      for (const auto& bar : detection.histograms()[place].density(40))
        curve.points.emplace_back((bar.from + bar.to) / 2, bar.density);
      histograms.curves.push_back(curve);
      if (d < 2.1) rates.curves.push_back(rate_curve(curve.name, detection, d));
    }
    std::vector<Panel> panels = statistics({{"all", &detection}}, 0);
    panels.insert(panels.begin(), histograms);
    panels.push_back(rates);
    panels.push_back(error_panel("Segmentation error", {{"all", &detection}}));
    report_.plot(file, title, panels, 3);
  }

  /// Detection rates and errors of some settings.
  void compare(const std::string& file, const std::string& title, const NamedDetections& of) {
    std::vector<Panel> panels;
    for (const double d50 : {0.4, 0.8, 1.2, 1.6})
      panels.push_back(rate_panel(fmt::format("Detection rate, D50 = {:.1f} px", d50), of, d50));
    panels.push_back(error_panel("Segmentation error", of));
    report_.plot(file, title, panels, 3);
  }

  /// Panels with a curve for each kernel and each of `kinds`, a name behind the kernel's and what is drawn.
  template <class Kind, class Of>
  Panel by_kernel(const std::string& title, const std::vector<std::pair<std::string, Kind>>& kinds, Of of) const {
    NamedDetections curves;
    for (const int kernel : kernels_)
      for (const auto& [name, kind] : kinds) curves.emplace_back(square(kernel) + name, &of(kernel, kind));
    return error_panel(title, curves);
  }

  void lowpass_compared() {
    compare("fig-8-6.svg", "Fig. 8.6: the low-pass on grey values and on directions, 9×9",
            {{"SAD", &found_.of("SAD", Prefilter::none)},
             {"SAD LP", &found_.of("SAD", Prefilter::lowpass)},
             {"DSAD", &found_.of("DSAD", Prefilter::none)},
             {"DSAD LP", &found_.of("DSAD", Prefilter::lowpass)}});
  }

  void highpass_by_kernel() {
    std::vector<Panel> panels;
    for (const char* criterion : {"NCC", "ZSSD"})
      panels.push_back(by_kernel<Prefilter>(criterion, {{"", Prefilter::none}, {" HP", Prefilter::highpass}},
                                            [&](int kernel, Prefilter prefilter) -> const Detection& {
                                              return found_.of(criterion, prefilter, kernel);
                                            }));
    report_.plot("fig-8-7.svg", "Fig. 8.7: the high-pass with NCC and ZSSD", panels, 2);
  }

  void both_compared() {
    compare("fig-8-8.svg", "Fig. 8.8: the low-pass before the high-pass, 9×9",
            {{"NCC HP", &found_.of("NCC", Prefilter::highpass)},
             {"NCC LP+HP", &found_.of("NCC", Prefilter::lowpass_highpass)},
             {"SAD HP", &found_.of("SAD", Prefilter::highpass)},
             {"SAD LP+HP", &found_.of("SAD", Prefilter::lowpass_highpass)},
             {"NSAD HP", &found_.of("NSAD", Prefilter::highpass)},
             {"NSAD LP+HP", &found_.of("NSAD", Prefilter::lowpass_highpass)}});
  }

  void signs() {
    NamedDetections nish;
    for (const double w : log_w_px_) nish.emplace_back(fmt::format("w = {:g} px", w), &found_.nish(w));
    report_.plot("fig-8-9.svg", "Fig. 8.9: NISH 9×9", statistics(nish, study::criterion("NISH").best(9)), 2);
    compare("fig-8-11.svg", "Fig. 8.11: NISH 9×9", nish);
  }

  Panel all_methods(Prefilter prefilter, int kernel) const {
    const bool low = prefilter == Prefilter::lowpass || prefilter == Prefilter::lowpass_highpass;
    NamedDetections of{{"DSAD", &found_.of("DSAD", low ? Prefilter::lowpass : Prefilter::none, kernel)}};
    for (const std::string& criterion : kGreyCriteria)
      of.emplace_back(criterion, &found_.of(criterion, prefilter, kernel));
    return error_panel(label(prefilter), of);
  }
  void all_methods() {
    const auto plot = [&](const char* file, const char* title, Prefilter prefilter) {
      report_.plot(file, title, {all_methods(prefilter, 9)}, 2);
    };
    plot("fig-8-12.svg", "Fig. 8.12: grey values, 9×9", Prefilter::none);
    plot("fig-8-13.svg", "Fig. 8.13: low-pass filtered grey values, 9×9", Prefilter::lowpass);
    plot("fig-8-14.svg", "Fig. 8.14: high-pass filtered, 9×9", Prefilter::highpass);
    plot("fig-8-15.svg", "Fig. 8.15: low-pass, then high-pass filtered, 9×9", Prefilter::lowpass_highpass);
    std::vector<Panel> panels;
    for (const Prefilter prefilter : kPrefilters) panels.push_back(all_methods(prefilter, 13));
    report_.plot("fig-8-16.svg", "Fig. 8.16: 13×13", panels, 2);
  }

  NamedDetections direction(Prefilter prefilter) const {
    NamedDetections result;
    for (const int kernel : kernels_) result.emplace_back(square(kernel), &found_.of("DSAD", prefilter, kernel));
    return result;
  }
  void direction_by_kernel() {
    const NamedDetections plain = direction(Prefilter::none);
    const NamedDetections low = direction(Prefilter::lowpass);
    report_.plot("fig-8-17.svg", "Fig. 8.17: DSAD",
                 {error_panel("DSAD", plain), error_panel("DSAD LP", low), rate_panel("DSAD, D50 = 1 px", plain, 1),
                  rate_panel("DSAD LP, D50 = 1 px", low, 1)},
                 2);
  }

  void result_filters() {
    std::vector<Panel> panels;
    for (const auto& [name, before] : {std::pair{"NCC", Prefilter::none},
                                       {"SAD", Prefilter::none},
                                       {"DSAD", Prefilter::lowpass},
                                       {"NCC", Prefilter::highpass},
                                       {"SAD", Prefilter::highpass},
                                       {"NSAD", Prefilter::highpass}})
      panels.push_back(by_kernel<ResultFilter>(
          fmt::format("{} {}", name, label(before)),
          {{"", ResultFilter::none}, {" low-pass", ResultFilter::lowpass}, {" median", ResultFilter::median}},
          [&, criterion = name, prefilter = before](int kernel, ResultFilter filter) -> const Detection& {
            return found_.of(criterion, prefilter, kernel, filter);
          }));
    report_.plot("result-filters.svg", "8.4.5: filters of the result", panels, 3);
  }

  void thresholds() {
    const NamedDetections low = direction(Prefilter::lowpass);
    Panel threshold{"Threshold", "segmentation disparity D50, px", "threshold, % of T_max", {}};
    for (std::size_t i = 0; i < kernels_.size(); ++i) {
      Curve& curve = threshold.curves.emplace_back(Curve{low[i].first, {}});
      for (const double d : low[i].second->disparities_px())
        if (d > 0 && d < 2.01) curve.points.emplace_back(d, percent_of_worst(*low[i].second, d, kernels_[i]));
    }
    report_.plot("fig-11-6.svg", "Fig. 11.6: DSAD with low-pass, error and threshold",
                 {error_panel("Segmentation error", low), threshold}, 2);

    Panel rates = rate_panel("DSAD LP 9×9", {}, 1);
    const Detection& detection = found_.of("DSAD", Prefilter::lowpass);
    for (const double d50 : {0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4, 1.6})
      rates.curves.push_back(rate_curve(fmt::format("{:.1f} %", percent_of_worst(detection, d50, 9)), detection, d50));
    report_.plot("fig-11-7.svg", "Fig. 11.7: detection rates at thresholds in % of T_max", {rates}, 2);
  }
  static double percent_of_worst(const Detection& detection, double d50_px, int kernel) {
    return 100 * detection.threshold(d50_px) / study::criterion("DSAD").worst(kernel);
  }

  StudyReport& report_;
  const Segmentation& found_;
  const std::vector<int>& kernels_;
  const std::vector<double>& log_w_px_;
};

void tabulate(StudyReport& report, const Segmentation& found) {
  Csv errors({"criterion", "prefilter", "kernel", "result_filter", "d50_px", "threshold", "threshold_percent",
              "segmentation_error_px", "ten_ninety_px"});
  Csv means({"criterion", "prefilter", "kernel", "disparity_px", "mean", "deviation", "slope_over_deviation_per_px"});
  for (const auto& [setting, detection] : found.all()) {
    const study::Criterion& criterion = *setting.criterion;
    const double best = criterion.best(setting.kernel);
    const auto head = [&](Csv& csv) -> Csv& {
      return csv << criterion.name() << name_of(setting.preparation) << static_cast<double>(setting.kernel);
    };
    for (int i = 1; i <= 20; ++i) {
      const double d50 = i / 10.0;
      const double distance = detection.threshold(d50);
      const double threshold = criterion.similarity() ? best - distance : distance;
      const auto ten_ninety = detection.ten_ninety_px(d50);
      head(errors).row(name_of(setting.filter), d50, threshold,
                       std::isfinite(criterion.worst(setting.kernel))
                           ? fmt::format("{:.6g}", 100 * threshold / criterion.worst(setting.kernel))
                           : "",
                       detection.segmentation_error(d50), ten_ninety ? fmt::format("{:.6g}", *ten_ninety) : "");
    }
    if (setting.filter != ResultFilter::none) continue;
    for (std::size_t i = 0; i < detection.disparities_px().size(); ++i) {
      const auto& histogram = detection.histograms()[i];
      const double d = detection.disparities_px()[i];
      head(means).row(d, criterion.similarity() ? best - histogram.mean() : histogram.mean(), histogram.deviation(),
                      detection.slope_over_deviation(d));
    }
  }
  report.table("errors.csv", errors);
  report.table("means.csv", means);
}

/// Fig. 8.2 and 8.10.
void draw_images(StudyReport& report, const Image& reference, const std::vector<double>& log_w_px) {
  report.picture("fig-8-2.png", "Fig. 8.2: the textured pattern, as photographed", encode_png(reference));
  const int size = std::min({160, reference.width, reference.height});
  const int gap = 4;
  Image signs(static_cast<int>(log_w_px.size()) * (size + gap) - gap, size, 128);
  for (std::size_t i = 0; i < log_w_px.size(); ++i) {
    const study::Plane plane = study::log_sign(study::to_plane(reference), log_w_px[i]);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) signs.at(static_cast<int>(i) * (size + gap) + x, y) = plane.at(x, y) > 0 ? 255 : 0;
  }
  report.picture("fig-8-10.png", fmt::format("Fig. 8.10: sign of LoG, from left w = {:g}", fmt::join(log_w_px, ", ")),
                 encode_png(signs));
}

/// 8.4.1's whole series: means up to 14 px to either side, and what is still detected there.
void measure_far(StudyReport& report, const study::Simulation& simulation, const Segmentation& found, double step_px) {
  std::vector<Setting> settings;
  for (const auto& [setting, detection] : found.all())
    if (setting.kernel == 9 && setting.filter == ResultFilter::none) settings.push_back(setting);
  std::vector<double> disparities;
  const int steps = static_cast<int>(std::lround(kFarthest_px / step_px));
  for (int i = -steps; i <= steps; ++i) disparities.push_back(i * kFarthest_px / steps);
  const auto far = detect("image of the far series", photographs(simulation, disparities), settings);
  Csv table({"criterion", "prefilter", "disparity_px", "mean", "deviation", "detected_with_threshold_of_1_px"});
  nlohmann::json& detected = report.result["detected_at_4_to_14_px_percent"];
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const study::Criterion& criterion = *settings[i].criterion;
    const double threshold = far[i].threshold(1);
    const std::vector<double> rates = far[i].rates(threshold);
    double sum = 0;
    int count = 0;
    for (std::size_t k = 0; k < disparities.size(); ++k) {
      const auto& histogram = far[i].histograms()[k];
      table.row(criterion.name(), name_of(settings[i].preparation), disparities[k],
                criterion.similarity() ? criterion.best(9) - histogram.mean() : histogram.mean(), histogram.deviation(),
                rates[k]);
      if (std::abs(disparities[k]) < 4) continue;
      sum += rates[k];
      ++count;
    }
    detected[name_of(settings[i])] = 100 * sum / count;
  }
  report.result["far_images"] = disparities.size();
  report.table("far.csv", table);
}

/// DSAD and the criteria on grey values, 9×9, in light that does not fall across the image.
Segmentation in_even_light(const StudyScope& scope) {
  study::Conditions conditions = chapter8_conditions(scope);
  conditions.lighting.slope_x = 0;
  std::vector<Setting> settings;
  for (const Prefilter prefilter : {Prefilter::none, Prefilter::lowpass}) {
    settings.push_back({&study::criterion("DSAD"), preparation("DSAD", prefilter), 9});
    for (const std::string& name : kGreyCriteria)
      settings.push_back({&study::criterion(name), preparation(name, prefilter), 9});
  }
  StudyScope quick;
  quick.quick = true;
  const study::Simulation simulation(conditions, Detection::kLargest_px + 1);
  auto detections = detect("image in even light", photographs(simulation, chapter8_disparities(quick)), settings);
  Segmentation found;
  for (std::size_t i = 0; i < settings.size(); ++i) found.add(settings[i], std::move(detections[i]));
  return found;
}

void add_findings(StudyReport& report, const Segmentation& found) {
  const auto error = [&](const std::string& name) { return found.of(name, Prefilter::lowpass).segmentation_error(1); };
  report.finding(
      "Segmentation error at D50 = 1 px, low-pass, 9×9: DSAD {:.3f} px, NCC {:.3f}, ZNCC {:.3f}, SAD {:.3f}, SSD "
      "{:.3f}",
      error("DSAD"), error("NCC"), error("ZNCC"), error("SAD"), error("SSD"));
  const Detection& dsad = found.of("DSAD", Prefilter::lowpass);
  std::string thresholds;
  for (const double d50 : {0.6, 0.8, 1.0, 1.2, 1.4, 1.6}) {
    const double percent = 100 * dsad.threshold(d50) / study::criterion("DSAD").worst(9);
    report.result["threshold_percent"][fmt::format("{:.1f}", d50)] = percent;
    thresholds += fmt::format(" {:.1f}", percent);
  }
  report.finding("DSAD thresholds in % of T_max for D50 = 0.6 … 1.6 px:{} (Table 11.2: 11.3 15.0 18.4 21.9 25.1 28.4)",
                 thresholds);
  report.finding(
      "NSAD on high-pass filtered images: smallest error {:.3f} px for D50 from 0.2 px on (8.4.2: above 0.15)",
      found.of("NSAD", Prefilter::highpass).smallest_error(0.2));
}

}  // namespace

void Segmentation::add(const Setting& setting, Detection detection) {
  index_[name_of(setting)] = all_.size();
  all_.emplace_back(setting, std::move(detection));
}

const Detection& Segmentation::of(const Setting& setting) const { return all_[index_.at(name_of(setting))].second; }

const Detection& Segmentation::of(const std::string& criterion, Prefilter prefilter, int kernel,
                                  ResultFilter filter) const {
  return of({&study::criterion(criterion), preparation(criterion, prefilter), kernel, filter});
}

const Detection& Segmentation::nish(double log_w_px, int kernel) const {
  return of({&study::criterion("NISH"), {Feature::log_sign, false, false, log_w_px}, kernel});
}

const Detection& Segmentation::nisd(double log_w_px, int kernel) const {
  return of({&study::criterion("NISD"), {Feature::dog_sign, false, false, log_w_px}, kernel});
}

const Detection& Segmentation::nack(int kernel) const {
  return of({&study::criterion("NACK"), {Feature::roberts_sign}, kernel});
}

void study_segmentation(StudyReport& report, const StudyScope& scope) {
  const std::vector<int> kernels = scope.quick ? std::vector<int>{5, 9, 13} : std::vector<int>{5, 7, 9, 11, 13};
  const std::vector<double> log_w_px =
      scope.quick ? std::vector<double>{3, 5, 9} : std::vector<double>{3, 4, 5, 6, 7, 9};
  const std::vector<ResultFilter> filters{ResultFilter::none, ResultFilter::lowpass, ResultFilter::median};
  const std::vector<Setting> settings = settings_of(kernels, log_w_px, filters);

  std::optional<study::Simulation> simulation;
  study::ImageSeries series;
  if (scope.series.empty()) {
    simulation.emplace(chapter8_conditions(scope), kFarthest_px);
    series = photographs(*simulation, chapter8_disparities(scope));
    report.result["conditions"] = to_json(simulation->conditions());
    report.fitted(kChapter8Fitted);
  } else {
    series = load_series(scope.series);
    report.result["conditions"] = {{"series", scope.series}, {"images", series.disparities_px.size()}};
  }
  Segmentation found;
  auto detections = detect("image", series, settings);
  for (std::size_t i = 0; i < settings.size(); ++i) found.add(settings[i], std::move(detections[i]));
  report.result["images"] = series.disparities_px.size();
  report.result["settings"] = settings.size();
  draw_images(report, series.reference, log_w_px);
  Figures(report, found, kernels, log_w_px).all();
  tabulate(report, found);
  if (simulation) measure_far(report, *simulation, found, scope.quick ? 1 : 0.04);
  const Segmentation even = scope.series.empty() ? in_even_light(scope) : found;
  const Measures of(found, even, kernels, log_w_px);
  const auto state = [&](const char* section, const Tables& tables) {
    for (const Table& table : tables) report.state(section, table);
  };
  state("8.1", {family_statements(of)});
  state("8.4.2", definition_statements(of));
  state("8.4.3", prefilter_statements(of));
  state("8.4.4", criteria_statements(of));
  state("8.4.5", result_filter_statements(of));
  state("11.2.1", threshold_statements(of));
  add_findings(report, found);
}

}  // namespace horopter::cli
