// SPDX-License-Identifier: Apache-2.0
// The photographs that the studies of chapters 8 and 11.2 are made on.
#pragma once

#include <string>
#include <vector>

#include "horopter/study/series.hpp"
#include "study.hpp"

namespace horopter::cli {

/// Images as in 8.4.1. A scope that is quick has images of 240×180 pixels.
study::Conditions chapter8_conditions(const StudyScope& scope);
/// What of them the thesis does not give, and how it was chosen.
inline constexpr const char* kChapter8Fitted =
    "the blur of the lens (1.2 px), so that D50 = 1.0 px has the threshold of Table 11.2, 18.4 % of T_max; the texture (dead "
    "leaves of 1 to 3 px), as the kind that came closest to the table's other rows. All studies of chapters 8, 10.4.5 and "
    "11.2 are made on these images.";

/// 0 … 3 px in steps of 0.04 px as in 8.4.1, of 0.2 px when quick.
std::vector<double> chapter8_disparities(const StudyScope& scope);

/// What a displacement takes from the bilinear interpolation of the transformation, px: weights of 3/8 and 5/8.
inline constexpr double kInterpolated_px = 0.375;
/// The image kInterpolated_px to the right, as the transformation makes it of another.
Image interpolated(const Image& source);
/// photographs() of which the right ones come through the transformation, as in the system.
study::ImageSeries transformed(const study::Simulation& simulation, const std::vector<double>& disparities_px);

/// study::detect with a line of progress that counts `what`.
std::vector<study::Detection> detect(const char* what, const study::ImageSeries& series,
                                     const std::vector<study::Setting>& settings);

/// A user's own images: a CSV file with the header `file,disparity_px`, files relative to it. The first row is the
/// reference, its disparity 0; the others ascend from 0 or more. Throws FileError.
study::ImageSeries load_series(const std::string& path);

}  // namespace horopter::cli
