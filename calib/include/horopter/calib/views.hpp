// SPDX-License-Identifier: Apache-2.0
// Any number of cameras from views of a flat target moved by hand, or lifted to known heights (thesis 6.8): started
// from Tsai's method on every view, finished by one optimisation of all cameras, their relative pose and all views.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "horopter/calib/joint.hpp"
#include "horopter/calib/report.hpp"

namespace horopter::calib {

/// What one camera saw of one pose of the target.
struct SeenTarget {
  std::string file;
  std::vector<Eigen::Vector2d> pixels;  ///< in the order of the target's points; empty: not found
  bool oriented = true;                 ///< false: the order may be turned, as far as the target is symmetric
  std::string problem;                  ///< why it was not found
};

struct ViewCamera {
  std::string name;
  int width_px = 0, height_px = 0;
  std::vector<SeenTarget> views;  ///< the same number for every camera; view i is one pose of the target
};

struct ViewOptions {
  /// Terms of the lens map that are optimised (Brown-Conrady).
  std::array<bool, LensCoefficients::kCount> distortion{true, true, true, true};
  /// Height of the target in each view, mm, towards the cameras; empty: the target is moved freely. All views share
  /// one pose then, and the world is that of the target: x right, y up the print, z out of it.
  std::vector<double> heights_mm;
  double pitch_mm = 0;  ///< of pixels, to report f in mm; 0: not known
};

/// "k1", "k1k2", "k1k2p1p2", … "none". Throws std::invalid_argument that says what is possible.
std::array<bool, LensCoefficients::kCount> distortion_terms(std::string_view text);

/// `points_mm` are the target's, in its plane, x right, y down. Throws CalibrationError when no camera can be found,
/// or when a camera has one image twice; a result that is no good has `usable` false and says why.
Report calibrate_views(const std::vector<ViewCamera>& cameras, const std::vector<Eigen::Vector2d>& points_mm,
                       const ViewOptions& options = {});

}  // namespace horopter::calib
