// SPDX-License-Identifier: Apache-2.0
// Flat calibration targets found in an image without an initial guess (thesis 6.8.2), their corners at sub-pixel
// precision.
//
// Target coordinates, mm, in the plane z = 0, looking at the print: x to the right, y down (z = x × y points into the
// print, away from the camera).
//   squares, diamonds: fiducials row by row, the first row at the bottom, from left to right. Its four corners: squares
//     top left, top right, bottom right, bottom left; diamonds top, right, bottom, left. The origin is the bottom left
//     corner of the box around the first fiducial: the first square is x 0..side, y −side..0; the next row is at
//     y − pitch. (The coordinates of the published data of Zhang's pattern.)
//   chessboard: inner corners row by row, the first row at the top; the origin is the first corner.
//
// Which corner of the print is the first: on patterns printed by `horopter pattern`, the fiducial with a hole. On a
// chessboard with one even and one odd number of corners, the end whose outermost squares are black. Else the
// orientation that has x point most to the right in the image.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "horopter/calib/edge.hpp"
#include "horopter/calib/error.hpp"
#include "horopter/calib/grey_image.hpp"

namespace horopter::calib {

enum class TargetKind { squares, diamonds, chessboard };

struct TargetSpec {
  TargetKind kind = TargetKind::squares;
  int columns = 0;  ///< fiducials, or inner corners, along x
  int rows = 0;
  double side_mm = 0;   ///< of a square; of a diamond likewise the edge, not the diagonal
  double pitch_mm = 0;  ///< from fiducial to fiducial; chessboard: = side_mm

  /// `squares:8x8:12.7mm:22.57779mm` (side, pitch), `diamonds:…`, `chessboard:9x6:30mm`. Throws std::invalid_argument
  /// that says what is wrong and what was expected.
  static TargetSpec parse(std::string_view text);
  std::string text() const;

  /// Width of the box around a fiducial: side, or diagonal of a diamond.
  double box_mm() const;
  /// All corners in the order above.
  std::vector<Eigen::Vector2d> points_mm() const;
};

/// No target in the image, or not the one that was asked for. The message names what was found instead.
class TargetError : public CalibrationError {
 public:
  enum class Reason { no_target, wrong_size, partly_outside, hidden, mirrored, bad_image };
  TargetError(Reason reason, const std::string& message) : CalibrationError(message), reason_(reason) {}
  Reason reason() const { return reason_; }

 private:
  Reason reason_;
};

struct TargetOptions {
  /// Estimator of the edges of squares and diamonds. Windows narrow where a fiducial is small in the image.
  /// The thesis takes Zernike 13x13, since large windows suffer less from blur; two windows do not suffer from it, and
  /// small ones from less of what lies beside the edge.
  EdgeMethod method = EdgeMethod::zernike_9;
  /// See EdgeOptions: no bias by blur. For the thesis's figures, false.
  bool two_windows = true;
  int points_per_edge = 0;  ///< 0: one per pixel of the edge, at most 48
  /// Blooming, gamma and a print that gains ink make fiducials larger or smaller in an image, by tenths of a pixel
  /// and not the same along x and y. The pitch does not suffer: what makes side and pitch agree is found and removed.
  bool settle = true;
};

struct TargetView {
  std::vector<Eigen::Vector2d> target_mm;  ///< TargetSpec::points_mm()
  std::vector<Eigen::Vector2d> image_px;   ///< in the same order
  bool oriented = false;                   ///< the print itself says which corner is the first
  double plane_rms_px = 0;                 ///< residual of the corners against a plane seen through one radial term
  /// By how much the fiducials were too large on each side, along x and y of the image, before it was removed.
  Eigen::Vector2d edge_shift_px{0, 0};
  double fiducial_px = 0;  ///< median side in the image
};

/// Throws TargetError.
TargetView detect_target(const cv::Mat& image, const TargetSpec& spec, const TargetOptions& options = {});

/// Corners of one spec measured by others: throws TargetError when they are as many as the spec has but in an order
/// that only a mirror could show (or too few, or not finite).
void check_order(const TargetSpec& spec, const std::vector<Eigen::Vector2d>& image_px);

GreyImage grey_image(const cv::Mat& image);

}  // namespace horopter::calib
