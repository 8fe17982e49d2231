// SPDX-License-Identifier: Apache-2.0
// Skins from a rig and a surface: undistort left, meet the surface, distort right (T1; thesis 7.1, Fig. 7.1).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "horopter/calib/rig.hpp"
#include "horopter/skin/skin.hpp"
#include "horopter/skin/surface.hpp"

namespace horopter {

/// Lines of sight of left pixels, world coordinates, kept for surfaces that move while the cameras stand.
struct Rays {
  std::vector<Eigen::Vector3d> directions;  ///< camera z = 1; NaN where the pixel sees nothing
  /// Row by row a 3×3 matrix for each: the direction and its derivatives by the pixel, right camera.
  std::array<std::vector<double>, 9> right_view;
  std::vector<double> over_length;  ///< 1 / length of the direction
  /// Where the epipolar line leaves the pixel's row, rows of the full frame: the larger of both ends of
  /// ±`largest_shift_px`; NaN where it does not get there, or the lens model ends before. Empty at 0.
  std::vector<double> row_error;
  int largest_shift_px = 0;
  std::size_t size() const { return directions.size(); }
};

/// The two cameras that watch a skin.
class CameraPair {
 public:
  CameraPair(calib::Camera left, calib::Camera right);

  const calib::Camera& left() const { return left_; }
  const calib::Camera& right() const { return right_; }
  /// Epipolar lines are those of the left image, bent as its lens bends them: of two points on the skin in one plane
  /// with both cameras the map makes two in the same plane, so whatever the skin and the right camera, what a neighbour
  /// sees lies on the pixel's left epipolar line.
  Rays rays(std::span<const Point> left, const ViewLimits& limits = {}) const;
  /// What the pixels of the rays, from the `first` on as many as there are looks, see of a surface that check_cameras
  /// accepts. Points of one call are best neighbours. Throws std::invalid_argument for rays of smaller shifts than the limits'.
  void look(const Surface& surface, const Rays& rays, int row_step, const ViewLimits& limits, std::span<Look> looks,
            std::size_t first = 0) const;
  /// The same of a whole number of runs of calib::PixelBatch::kRun, each as in a call of its own, to the last bit.
  void look_at_runs(const Surface& surface, const Rays& rays, int row_step, const ViewLimits& limits,
                    std::span<Look> looks, std::size_t first) const;
  /// As Skin::look_around. A surface is continued by the plane nearest to it, as seen from the left camera, no nearer
  /// and no further than the surface itself. Only where the source is `wanted`, if that is given; elsewhere it is NaN.
  void look_around(const Surface& surface, const Rays& rays, std::span<Point> sources,
                   std::span<const std::uint8_t> wanted = {}) const;
  /// Thickness of the skin along the left line of sight, mm, at a point with this normal (world coordinates): from where
  /// the transformed right image shows a thing `tolerance_px` beside the left one to where it does so on the other side
  /// (2·D in 11.1, without its approximations). Of the frame's pixels, left: what the right camera sees aslant is drawn
  /// out by the transformation, and with it the disparity. NaN where a camera does not see the point.
  double thickness_mm(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& normal, double tolerance_px) const;
  /// How far a thing at such a point moves for the transformed right image to show it a pixel of the frame further on, in
  /// the direction in which that takes the least way. NaN where a camera does not see the point.
  double least_way_mm(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& normal) const;
  /// World coordinates of what both pixels see: on the left line of sight, where the right one comes nearest. Nothing
  /// where the two do not determine a place before both cameras.
  std::optional<Eigen::Vector3d> place_mm(Point left, Point right) const;

 private:
  /// Derivative of the left pixel by the place that it sees; NaN where it does not.
  Eigen::Matrix<double, 2, 3> left_px_per_mm(const Eigen::Vector3d& point_mm) const;

  template <bool kRuns>
  void look_at(const Surface& surface, const Rays& rays, int row_step, const ViewLimits& limits, std::span<Look> looks,
               std::size_t first) const;

  calib::Camera left_;
  calib::Camera right_;
  Eigen::Vector3d left_centre_;
  Eigen::Vector3d right_centre_;
  Eigen::Vector3d between_;  ///< the left camera's centre, in the right camera's coordinates
};

class RigSkin : public Skin {
 public:
  /// Throws std::invalid_argument where the cameras cannot watch the surface.
  RigSkin(CameraPair cameras, SurfacePtr surface, std::string_view type);
  void look(std::span<const Point> left, int row_step, const ViewLimits& limits, std::span<Look> looks) const override;
  void look_around(std::span<const Point> left, std::span<Point> sources) const override;
  std::string_view type() const override { return type_; }
  std::string description() const override { return surface_->description(); }
  const CameraPair& cameras() const { return cameras_; }
  const SurfacePtr& surface() const { return surface_; }

 private:
  CameraPair cameras_;
  SurfacePtr surface_;
  std::string type_;
};

}  // namespace horopter
