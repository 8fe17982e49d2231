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
/// What of them the thesis does not give: how it was fitted, and what was chosen.
inline constexpr const char* kChapter8Fitted =
    "fitted by section 7.5: the contrast (a standard deviation of 31 grey levels in 7×7 pixels), between the 34 and the 29 "
    "that a translation by parts of a pixel takes to be off by σ = 7 grey levels with the nearest neighbour, and by 1.5 with "
    "steps of 1/4; footnote 8 says that these images were translated. Fitted by Table 11.2: the blur of the lens (0.68 px), "
    "so that D50 = 1.0 px has its threshold, 18.4 % of T_max; the sizes of the dead leaves (1.5 to 24 px), which come close "
    "to its six D95 (0.04 px RMS), as do 1 to 48 px and 2 to 12 px with blurs of their own; leaves of 1 to 3 px and other "
    "kinds, band noise and printed dots, are further off. Chosen, by no figure of the thesis: the mean (110 grey levels), "
    "and light that rises from 0.6 to 1.4 of it across the image. All studies of chapters 8, 10.4.5 and 11.2 are made on "
    "these images.";

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
