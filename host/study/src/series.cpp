// SPDX-License-Identifier: Apache-2.0
#include "horopter/study/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>

#include "horopter/study/filters.hpp"
#include "horopter/study/parallel.hpp"

namespace horopter::study {

std::string name_of(ResultFilter filter) {
  switch (filter) {
    case ResultFilter::lowpass:
      return "low-pass";
    case ResultFilter::median:
      return "median";
    default:
      return "none";
  }
}

std::string name_of(const Setting& setting) {
  std::string result = setting.criterion->name();
  const std::string prepared = name_of(setting.preparation);
  if (prepared != "none" && prepared != result) result += " " + prepared;
  result += fmt::format(" {0}×{0}", setting.kernel);
  if (setting.filter != ResultFilter::none) result += " " + name_of(setting.filter);
  return result;
}

int reach_of(const Setting& setting) {
  const Preparation& preparation = setting.preparation;
  int reach = setting.kernel / 2 + (setting.filter == ResultFilter::none ? 0 : 1);
  switch (preparation.feature) {
    case Feature::camera:
      return reach + 2;
    case Feature::direction:
      return reach + 1 + (preparation.lowpass ? 1 : 0);
    case Feature::log_sign:
      return reach + log_reach(preparation.log_w_px);
    case Feature::dog_sign:
      return reach + dog_reach(preparation.log_w_px);
    case Feature::roberts_sign:
      return reach + kRobertsReach;
    default:
      return reach + (preparation.lowpass ? 1 : 0) + (preparation.highpass ? 1 : 0);
  }
}

ImageSeries photographs(const Simulation& simulation, std::vector<double> disparities_px) {
  ImageSeries series;
  series.reference = simulation.photograph(0, 0);
  series.disparities_px = std::move(disparities_px);
  series.image = [&simulation, shifts = series.disparities_px](std::size_t i) {
    return simulation.photograph(shifts[i], i + 1);
  };
  return series;
}

std::vector<Detection> detect(const ImageSeries& series, const std::vector<Setting>& settings,
                              const std::function<void(std::size_t)>& done) {
  // By preparation, then kernel, so that what they share is made once.
  std::map<Preparation, std::map<int, std::vector<std::size_t>>> groups;
  int margin = 0;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    groups[settings[i].preparation][settings[i].kernel].push_back(i);
    margin = std::max(margin, reach_of(settings[i]));
  }
  std::map<Preparation, Plane> reference;
  for (const auto& [preparation, kernels] : groups) reference[preparation] = prepare(series.reference, preparation);

  const std::size_t images = series.disparities_px.size();
  std::vector<std::vector<Histogram>> histograms(settings.size(), std::vector<Histogram>(images));
  const auto compare = [&](std::size_t index) {
    const Image image = series.image(index);
    if (image.width != series.reference.width || image.height != series.reference.height)
      throw std::invalid_argument(fmt::format("image {} of a series is {}×{}, its reference {}×{}", index, image.width,
                                              image.height, series.reference.width, series.reference.height));
    for (const auto& [preparation, kernels] : groups) {
      const Plane prepared = prepare(image, preparation);
      Pair pair(reference.at(preparation), prepared);
      for (const auto& [kernel, members] : kernels) {
        pair.set_kernel(kernel);
        // Settings that differ in the filter of the result alone share the result.
        std::map<const Criterion*, Plane> results;
        for (const std::size_t i : members) {
          const Setting& setting = settings[i];
          const auto found = results.find(setting.criterion);
          const Plane& plain = found != results.end()
                                   ? found->second
                                   : results.emplace(setting.criterion, setting.criterion->compare(pair)).first->second;
          const double best = setting.criterion->best(kernel);
          if (setting.filter == ResultFilter::none) {
            histograms[i][index] = Histogram(plain, best, margin);
          } else {
            histograms[i][index] =
                Histogram(setting.filter == ResultFilter::lowpass ? lowpass(plain) : median(plain), best, margin);
          }
        }
      }
    }
  };
  parallel_for(images, compare, done);
  std::vector<Detection> result;
  for (auto& of_setting : histograms) result.emplace_back(series.disparities_px, std::move(of_setting));
  return result;
}

}  // namespace horopter::study
