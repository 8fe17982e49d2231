// SPDX-License-Identifier: Apache-2.0
// Rectified pairs with ground truth, from options or a list, what may happen to the right camera's image, and what the
// machine is asked about them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "horopter/image/disparity.hpp"
#include "horopter/image/evaluation.hpp"
#include "horopter/image/image.hpp"
#include "horopter/skin/skin_file.hpp"

namespace horopter::cli {

struct StereoPairFiles {
  std::string name;
  std::string left;
  std::string right;
  std::string disparity;
  double scale = 1;    ///< of the disparity file: its value for 1 px
  double resize = 1;   ///< factor by which images and disparities are made smaller or larger
  std::string mask{};  ///< image: 255 where both cameras see; empty: none
};

struct StereoPair {
  std::string name;
  Image left;
  Image right;
  DisparityMap truth;
  std::string file{};                ///< of the left image, for messages
  std::vector<std::uint8_t> seen{};  ///< not 0 where both cameras see, by the mask; empty: there is none

  [[nodiscard]] GroundTruth ground_truth() const { return GroundTruth(truth, seen); }
};

/// One pair a line: `name left right disparity scale resize mask`, separated by blanks; the last three may be left out
/// (1, 1, none).
/// Paths are relative to the list; `#` begins a comment. Throws FileError with the line.
std::vector<StereoPairFiles> read_pair_list(const std::string& path);

/// Throws FileError for files that are bad or do not fit each other.
StereoPair load_pair(const StereoPairFiles& files);

/// A skin parallel to the images of a rectified pair: a whole disparity is a shift, and that a homography.
SkinFile skin_at(double disparity_px, const Image& image);
/// What the machine's states answer about each pixel.
std::vector<Answer> answers_of(const Image& states);

/// Names of the changes, `none` first.
const std::vector<std::string>& change_names();
/// What the change does, for people.
std::string describe_change(const std::string& name);
/// The right image, changed: `gain` 0.5·g + 40, `noise` of σ = 5 grey levels, `vertical` half a pixel up.
Image changed(const Image& right, const std::string& name);

}  // namespace horopter::cli
