// SPDX-License-Identifier: Apache-2.0
// Many criteria over many disparities: the experiment of chapter 8.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "horopter/study/criteria.hpp"
#include "horopter/study/measures.hpp"
#include "horopter/study/simulation.hpp"

namespace horopter::study {

enum class ResultFilter { none, lowpass, median };
std::string name_of(ResultFilter filter);

/// One way to compare two images.
struct Setting {
  const Criterion* criterion = nullptr;
  Preparation preparation;
  int kernel = 9;
  ResultFilter filter = ResultFilter::none;
};
/// "DSAD LP 9×9", "NCC LP+HP 13×13 median": another name for each setting.
std::string name_of(const Setting& setting);

/// Pixels from the border in which some filter or window of a setting misses pixels.
int reach_of(const Setting& setting);

/// A reference and images whose contents are displaced against it by known disparities.
struct ImageSeries {
  Image reference;
  std::vector<double> disparities_px;       ///< ascending
  std::function<Image(std::size_t)> image;  ///< of disparities_px[i]; called from several threads
};

/// Photographs of a simulation; the reference has noise of its own. Keep the simulation.
ImageSeries photographs(const Simulation& simulation, std::vector<double> disparities_px);

/// Compares the reference with every image in every setting. `done(n)` tells of images as they are done. All settings
/// are measured on the same pixels: those that all of them reach.
std::vector<Detection> detect(
    const ImageSeries& series, const std::vector<Setting>& settings,
    const std::function<void(std::size_t)>& done = [](std::size_t) {});

}  // namespace horopter::study
