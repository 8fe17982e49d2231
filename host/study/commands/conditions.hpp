// SPDX-License-Identifier: Apache-2.0
// The photographs that the studies of chapters 8 and 11.2 are made on.
#pragma once

#include <string>
#include <vector>

#include "horopter/study/series.hpp"
#include "study.hpp"

namespace horopter::cli {

/// Images as in 8.4.1. The blur was chosen so that the row "D50 = 1.0 px: 18.4 %" of Table 11.2 is met, on no other
/// figure of the thesis; the texture's kind and structures are those that a trial found closest. A scope that is quick
/// has images of 240×180 pixels.
study::Conditions chapter8_conditions(const StudyScope& scope);

/// 0 … 2.8 px in steps of 0.04 px as in 8.4.1, of 0.2 px when quick.
std::vector<double> chapter8_disparities(const StudyScope& scope);

/// study::detect with a line of progress that counts `what`.
std::vector<study::Detection> detect(const char* what, const study::ImageSeries& series,
                                     const std::vector<study::Setting>& settings);

/// A user's own images: a CSV file with the header `file,disparity_px`, files relative to it. The first row is the
/// reference, its disparity 0; the others ascend from 0 or more. Throws FileError.
study::ImageSeries load_series(const std::string& path);

}  // namespace horopter::cli
