// SPDX-License-Identifier: Apache-2.0
// Thesis 8.4 and 11.2.1: how well each criterion tells small disparities from large ones.
#include "segmentation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "cli/progress.hpp"
#include "conditions.hpp"
#include "horopter/base/csv.hpp"
#include "horopter/draw/plot.hpp"
#include "horopter/study/filters.hpp"
#include "statements.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using study::Detection;
using study::Feature;
using study::Preparation;
using study::ResultFilter;
using study::Setting;

constexpr double kFarthest_px = 14;  ///< of the 700 images of 8.4.1

const std::vector<Prefilter> prefilters{Prefilter::none, Prefilter::lowpass, Prefilter::highpass,
                                        Prefilter::lowpass_highpass};

Preparation preparation(const std::string& criterion, Prefilter prefilter) {
  Preparation result;
  result.feature = study::criterion(criterion).feature();
  result.lowpass = prefilter == Prefilter::lowpass || prefilter == Prefilter::lowpass_highpass;
  result.highpass = prefilter == Prefilter::highpass || prefilter == Prefilter::lowpass_highpass;
  if (result.feature == Feature::camera) result = {Feature::camera};
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
    } else {
      for (const Prefilter prefilter : prefilters) {
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

/// Plots of one experiment.
class Figures {
 public:
  Figures(OutputDirectory& directory, const Segmentation& found, nlohmann::json& list)
      : directory_(directory), found_(found), list_(list) {}

  static Panel error_panel(const std::string& title) {
    return {title, "segmentation disparity D50 [px]", "segmentation error [px]", {}, false};
  }
  static Panel rate_panel(const std::string& title) {
    return {title, "disparity [px]", "detection rate [%]", {}, false};
  }

  /// Up to an error of 1 px, what is worse is cut off.
  static Curve error_curve(const std::string& name, const Detection& detection) {
    Curve curve{name, {}};
    for (const double d : detection.disparities_px()) {
      if (d <= 0 || d > 2.01) continue;
      const double error = detection.segmentation_error(d);
      curve.points.emplace_back(d, error <= 1 ? error : std::nan(""));
    }
    return curve;
  }
  static Curve rate_curve(const std::string& name, const Detection& detection, double d50_px) {
    Curve curve{name, {}};
    const std::vector<double> rates = detection.rates(detection.threshold(d50_px));
    for (std::size_t i = 0; i < rates.size(); ++i)
      curve.points.emplace_back(detection.disparities_px()[i], 100 * rates[i]);
    return curve;
  }
  static Curve threshold_curve(const std::string& name, const Detection& detection, double largest) {
    Curve curve{name, {}};
    for (const double d : detection.disparities_px())
      if (d > 0 && d < 2.01) curve.points.emplace_back(d, 100 * detection.threshold(d) / largest);
    return curve;
  }
  /// Mean and deviation over disparity, of the criterion's own values.
  static std::vector<Panel> statistics(const std::vector<std::pair<std::string, const Detection*>>& of, double best) {
    Panel mean{"Mean", "disparity [px]", "mean", {}, false};
    Panel deviation{"Standard deviation", "disparity [px]", "deviation", {}, false};
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

  void write(const std::string& name, const std::string& title, const std::vector<Panel>& panels, int columns) {
    directory_.write(name + ".svg", plot_svg(title, panels, columns));
    list_.push_back({{"file", name + ".svg"}, {"title", title}});
  }

  /// Fig. 8.4, 8.5: all about one setting.
  void portrait(const std::string& name, const std::string& title, const Detection& detection) {
    Panel histograms{"Histograms", "criterion", "density", {}, false};
    Panel rates = rate_panel("Detection rates");
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
    std::vector<Panel> panels{histograms};
    for (const Panel& panel : statistics({{"all", &detection}}, 0)) panels.push_back(panel);
    Panel error = error_panel("Segmentation error");
    error.curves = {error_curve("all", detection)};
    panels.push_back(rates);
    panels.push_back(error);
    write(name, title, panels, 3);
  }

  void all_methods(const std::string& name, const std::string& title, Prefilter prefilter, int kernel) {
    write(name, title, {all_methods_panel(label(prefilter), prefilter, kernel)}, 2);
  }
  Panel all_methods_panel(const std::string& title, Prefilter prefilter, int kernel) const {
    Panel panel = error_panel(title);
    const bool low = prefilter == Prefilter::lowpass || prefilter == Prefilter::lowpass_highpass;
    panel.curves.push_back(error_curve("DSAD", found_.of("DSAD", low ? Prefilter::lowpass : Prefilter::none, kernel)));
    for (const std::string& criterion : grey_criteria)
      panel.curves.push_back(error_curve(criterion, found_.of(criterion, prefilter, kernel)));
    return panel;
  }

 private:
  OutputDirectory& directory_;
  const Segmentation& found_;
  nlohmann::json& list_;
};

void draw(OutputDirectory& directory, const Segmentation& found, const std::vector<int>& kernels,
          const std::vector<double>& log_w_px, nlohmann::json& list) {
  Figures figures(directory, found, list);
  const std::vector<double> places{0.4, 0.8, 1.2, 1.6};
  figures.portrait("fig-8-4", "Fig. 8.4: NSAD on high-pass filtered images, 9×9",
                   found.of("NSAD", Prefilter::highpass));
  figures.portrait("fig-8-5", "Fig. 8.5: DSAD with low-pass, 9×9", found.of("DSAD", Prefilter::lowpass));

  /// Detection rates and errors of some settings.
  const auto compare = [&](const std::string& name, const std::string& title,
                           const std::vector<std::pair<std::string, const Detection*>>& of) {
    std::vector<Panel> panels;
    for (const double d50 : places) {
      Panel rates = Figures::rate_panel(fmt::format("Detection rate, D50 = {:.1f} px", d50));
      for (const auto& [one, detection] : of) rates.curves.push_back(Figures::rate_curve(one, *detection, d50));
      panels.push_back(rates);
    }
    Panel error = Figures::error_panel("Segmentation error");
    for (const auto& [one, detection] : of) error.curves.push_back(Figures::error_curve(one, *detection));
    panels.push_back(error);
    figures.write(name, title, panels, 3);
  };
  compare("fig-8-6", "Fig. 8.6: the low-pass on grey values and on directions, 9×9",
          {{"SAD", &found.of("SAD", Prefilter::none)},
           {"SAD LP", &found.of("SAD", Prefilter::lowpass)},
           {"DSAD", &found.of("DSAD", Prefilter::none)},
           {"DSAD LP", &found.of("DSAD", Prefilter::lowpass)}});
  {
    std::vector<Panel> panels;
    for (const char* criterion : {"NCC", "ZSSD"}) {
      Panel panel = Figures::error_panel(criterion);
      for (const int kernel : kernels)
        for (const Prefilter prefilter : {Prefilter::none, Prefilter::highpass})
          panel.curves.push_back(
              Figures::error_curve(fmt::format("{0}×{0}{1}", kernel, prefilter == Prefilter::none ? "" : " HP"),
                                   found.of(criterion, prefilter, kernel)));
      panels.push_back(panel);
    }
    figures.write("fig-8-7", "Fig. 8.7: the high-pass with NCC and ZSSD", panels, 2);
  }
  compare("fig-8-8", "Fig. 8.8: the low-pass before the high-pass, 9×9",
          {{"NCC HP", &found.of("NCC", Prefilter::highpass)},
           {"NCC LP+HP", &found.of("NCC", Prefilter::lowpass_highpass)},
           {"SAD HP", &found.of("SAD", Prefilter::highpass)},
           {"SAD LP+HP", &found.of("SAD", Prefilter::lowpass_highpass)},
           {"NSAD HP", &found.of("NSAD", Prefilter::highpass)},
           {"NSAD LP+HP", &found.of("NSAD", Prefilter::lowpass_highpass)}});
  std::vector<std::pair<std::string, const Detection*>> nish;
  for (const double w : log_w_px) nish.emplace_back(fmt::format("w = {:g}", w), &found.nish(w));
  figures.write("fig-8-9", "Fig. 8.9: NISH 9×9", Figures::statistics(nish, study::criterion("NISH").best(9)), 2);
  compare("fig-8-11", "Fig. 8.11: NISH 9×9", nish);
  figures.all_methods("fig-8-12", "Fig. 8.12: grey values, 9×9", Prefilter::none, 9);
  figures.all_methods("fig-8-13", "Fig. 8.13: low-pass filtered grey values, 9×9", Prefilter::lowpass, 9);
  figures.all_methods("fig-8-14", "Fig. 8.14: high-pass filtered, 9×9", Prefilter::highpass, 9);
  figures.all_methods("fig-8-15", "Fig. 8.15: low-pass, then high-pass filtered, 9×9", Prefilter::lowpass_highpass, 9);
  {
    std::vector<Panel> panels;
    for (const Prefilter prefilter : prefilters)
      panels.push_back(figures.all_methods_panel(label(prefilter), prefilter, 13));
    figures.write("fig-8-16", "Fig. 8.16: 13×13", panels, 2);
  }
  {
    std::vector<Panel> panels{Figures::error_panel("DSAD"), Figures::error_panel("DSAD LP")};
    Panel rates = Figures::rate_panel("DSAD, D50 = 1 px");
    Panel rates_low = Figures::rate_panel("DSAD LP, D50 = 1 px");
    for (const int kernel : kernels) {
      const std::string name = fmt::format("{0}×{0}", kernel);
      panels[0].curves.push_back(Figures::error_curve(name, found.of("DSAD", Prefilter::none, kernel)));
      panels[1].curves.push_back(Figures::error_curve(name, found.of("DSAD", Prefilter::lowpass, kernel)));
      rates.curves.push_back(Figures::rate_curve(name, found.of("DSAD", Prefilter::none, kernel), 1));
      rates_low.curves.push_back(Figures::rate_curve(name, found.of("DSAD", Prefilter::lowpass, kernel), 1));
    }
    panels.push_back(rates);
    panels.push_back(rates_low);
    figures.write("fig-8-17", "Fig. 8.17: DSAD", panels, 2);
  }
  {
    std::vector<Panel> panels;
    for (const auto& [criterion, prefilter] : {std::pair{"NCC", Prefilter::none},
                                               {"SAD", Prefilter::none},
                                               {"DSAD", Prefilter::lowpass},
                                               {"NCC", Prefilter::highpass},
                                               {"SAD", Prefilter::highpass},
                                               {"NSAD", Prefilter::highpass}}) {
      Panel panel = Figures::error_panel(fmt::format("{} {}", criterion, label(prefilter)));
      for (const int kernel : kernels)
        for (const ResultFilter filter : {ResultFilter::none, ResultFilter::lowpass, ResultFilter::median})
          panel.curves.push_back(Figures::error_curve(
              fmt::format("{0}×{0}{1}", kernel, filter == ResultFilter::none ? "" : " " + name_of(filter)),
              found.of(criterion, prefilter, kernel, filter)));
      panels.push_back(panel);
    }
    figures.write("result-filters", "8.4.5: filters of the result", panels, 3);
  }
  {
    Panel error = Figures::error_panel("Segmentation error");
    Panel threshold{"Threshold", "segmentation disparity D50 [px]", "% of T_max", {}, false};
    for (const int kernel : kernels) {
      const Detection& detection = found.of("DSAD", Prefilter::lowpass, kernel);
      const std::string name = fmt::format("{0}×{0}", kernel);
      error.curves.push_back(Figures::error_curve(name, detection));
      threshold.curves.push_back(Figures::threshold_curve(name, detection, study::criterion("DSAD").worst(kernel)));
    }
    figures.write("fig-11-6", "Fig. 11.6: DSAD with low-pass, error and threshold", {error, threshold}, 2);
  }
  {
    Panel rates = Figures::rate_panel("DSAD LP 9×9");
    const Detection& detection = found.of("DSAD", Prefilter::lowpass);
    for (const double d50 : {0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4, 1.6})
      rates.curves.push_back(Figures::rate_curve(
          fmt::format("{:.1f} %", 100 * detection.threshold(d50) / study::criterion("DSAD").worst(9)), detection, d50));
    figures.write("fig-11-7", "Fig. 11.7: detection rates at thresholds in % of T_max", {rates}, 2);
  }
}

void tabulate(OutputDirectory& directory, const Segmentation& found) {
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
      head(errors) << name_of(setting.filter) << d50 << threshold
                   << (std::isfinite(criterion.worst(setting.kernel))
                           ? fmt::format("{:.6g}", 100 * threshold / criterion.worst(setting.kernel))
                           : "")
                   << detection.segmentation_error(d50)
                   << (ten_ninety ? fmt::format("{:.6g}", *ten_ninety) : std::string());
      errors.end_row();
    }
    if (setting.filter != ResultFilter::none) continue;
    for (std::size_t i = 0; i < detection.disparities_px().size(); ++i) {
      const auto& histogram = detection.histograms()[i];
      const double d = detection.disparities_px()[i];
      head(means) << d << (criterion.similarity() ? best - histogram.mean() : histogram.mean()) << histogram.deviation()
                  << detection.slope_over_deviation(d);
      means.end_row();
    }
  }
  directory.write("errors.csv", errors.text());
  directory.write("means.csv", means.text());
}

/// Fig. 8.2 and 8.10.
void draw_images(OutputDirectory& directory, const Image& reference, const std::vector<double>& log_w_px,
                 nlohmann::json& list) {
  const auto show = [&](const std::string& name, const std::string& title, const Image& image) {
    directory.write(name + ".png", encode_png(image));
    list.push_back({{"file", name + ".png"}, {"title", title}});
  };
  show("fig-8-2", "Fig. 8.2: the textured pattern, as photographed", reference);
  const int size = std::min({160, reference.width, reference.height});
  const int gap = 4;
  Image signs(static_cast<int>(log_w_px.size()) * (size + gap) - gap, size, 128);
  std::string title = "Fig. 8.10: sign of LoG, from left w =";
  for (std::size_t i = 0; i < log_w_px.size(); ++i) {
    const study::Plane plane = study::log_sign(study::to_plane(reference), log_w_px[i]);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) signs.at(static_cast<int>(i) * (size + gap) + x, y) = plane.at(x, y) > 0 ? 255 : 0;
    title += fmt::format("{} {:g}", i == 0 ? "" : ",", log_w_px[i]);
  }
  show("fig-8-10", title, signs);
}

/// 8.4.1's whole series: means up to 14 px to either side, and what is still detected there.
void measure_far(OutputDirectory& directory, const study::Simulation& simulation, const Segmentation& found,
                 double step_px, nlohmann::json& result) {
  std::vector<Setting> settings;
  for (const auto& [setting, detection] : found.all())
    if (setting.kernel == 9 && setting.filter == ResultFilter::none) settings.push_back(setting);
  std::vector<double> disparities;
  const int steps = static_cast<int>(std::lround(kFarthest_px / step_px));
  for (int i = -steps; i <= steps; ++i) disparities.push_back(i * kFarthest_px / steps);
  Progress progress("image of the far series");
  const auto far = study::detect(photographs(simulation, disparities), settings,
                                 [&](std::size_t done) { progress.show(done, disparities.size()); });
  Csv table({"criterion", "prefilter", "disparity_px", "mean", "deviation", "detected_with_threshold_of_1_px"});
  nlohmann::json& detected = result["detected_at_4_to_14_px_percent"];
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const study::Criterion& criterion = *settings[i].criterion;
    const double threshold = far[i].threshold(1);
    const std::vector<double> rates = far[i].rates(threshold);
    double sum = 0;
    int count = 0;
    for (std::size_t k = 0; k < disparities.size(); ++k) {
      const auto& histogram = far[i].histograms()[k];
      table << criterion.name() << name_of(settings[i].preparation) << disparities[k]
            << (criterion.similarity() ? criterion.best(9) - histogram.mean() : histogram.mean())
            << histogram.deviation() << rates[k];
      table.end_row();
      if (std::abs(disparities[k]) < 4) continue;
      sum += rates[k];
      ++count;
    }
    detected[name_of(settings[i])] = 100 * sum / count;
  }
  result["far_images"] = disparities.size();
  directory.write("far.csv", table.text());
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

nlohmann::json study_segmentation(OutputDirectory& directory, const StudyScope& scope) {
  const std::vector<int> kernels = scope.quick ? std::vector<int>{5, 9, 13} : std::vector<int>{5, 7, 9, 11, 13};
  const std::vector<double> log_w_px =
      scope.quick ? std::vector<double>{3, 5, 9} : std::vector<double>{3, 4, 5, 6, 7, 9};
  const std::vector<ResultFilter> filters{ResultFilter::none, ResultFilter::lowpass, ResultFilter::median};
  const std::vector<Setting> settings = settings_of(kernels, log_w_px, filters);

  std::optional<study::Simulation> simulation;
  study::ImageSeries series;
  nlohmann::json result;
  if (scope.series.empty()) {
    simulation.emplace(chapter8_conditions(scope), kFarthest_px);
    series = photographs(*simulation, chapter8_disparities(scope));
    result["conditions"] = to_json(simulation->conditions());
  } else {
    series = load_series(scope.series);
    result["conditions"] = {{"series", scope.series}, {"images", series.disparities_px.size()}};
  }
  Segmentation found;
  {
    Progress progress("image");
    auto detections =
        study::detect(series, settings, [&](std::size_t done) { progress.show(done, series.disparities_px.size()); });
    for (std::size_t i = 0; i < settings.size(); ++i) found.add(settings[i], std::move(detections[i]));
  }
  result["images"] = series.disparities_px.size();
  result["settings"] = settings.size();
  result["figures"] = nlohmann::json::array();
  draw_images(directory, series.reference, log_w_px, result["figures"]);
  draw(directory, found, kernels, log_w_px, result["figures"]);
  tabulate(directory, found);
  if (simulation) measure_far(directory, *simulation, found, scope.quick ? 1 : 0.04, result);

  Statements statements;
  judge_segmentation(found, kernels, log_w_px, statements);
  result["statements"] = statements.json();
  result["findings"] = nlohmann::json::array();
  const auto error = [&](const std::string& name, Prefilter prefilter, double d50) {
    return found.of(name, prefilter).segmentation_error(d50);
  };
  result["findings"].push_back(fmt::format(
      "Segmentation error at D50 = 1 px, low-pass, 9×9: DSAD {:.3f} px, NCC {:.3f}, ZNCC {:.3f}, SAD {:.3f}, SSD "
      "{:.3f}",
      error("DSAD", Prefilter::lowpass, 1), error("NCC", Prefilter::lowpass, 1), error("ZNCC", Prefilter::lowpass, 1),
      error("SAD", Prefilter::lowpass, 1), error("SSD", Prefilter::lowpass, 1)));
  const Detection& dsad = found.of("DSAD", Prefilter::lowpass);
  std::string thresholds;
  for (const double d50 : {0.6, 0.8, 1.0, 1.2, 1.4, 1.6}) {
    const double percent = 100 * dsad.threshold(d50) / study::criterion("DSAD").worst(9);
    result["threshold_percent"][fmt::format("{:.1f}", d50)] = percent;
    thresholds += fmt::format(" {:.1f}", percent);
  }
  result["findings"].push_back("DSAD thresholds in % of T_max for D50 = 0.6 … 1.6 px:" + thresholds +
                               " (Table 11.2: 11.3 15.0 18.4 21.9 25.1 28.4)");
  result["findings"].push_back(fmt::format(
      "NSAD on high-pass filtered images: smallest error {:.3f} px for D50 from 0.2 px on (8.4.2: above 0.15)",
      found.of("NSAD", Prefilter::highpass).smallest_error(0.2)));
  return result;
}

}  // namespace horopter::cli
