// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/proof.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "horopter/calib/rig.hpp"
#include "stages/agreement.hpp"
#include "stages/patches.hpp"

namespace horopter {
namespace {

constexpr int kReach = stages::Agreement<hls::profiles::vga>::reach;
constexpr int kStep_px = 16;

/// Cells from px, and one more for what lies between two.
int cells_beyond(int px, int cell) {
  const int cells = static_cast<int>(std::ceil(std::abs(px) / static_cast<double>(cell))) + 1;
  return std::clamp(px < 0 ? -cells : cells, -kReach, kReach);
}

Eigen::Vector3d right_camera_from_left(const calib::Rig& rig) {
  const calib::Pose& left = rig.cameras.at(0).world_to_camera;
  return left.rotation * (rig.cameras.at(1).world_to_camera.centre() - left.centre());
}

/// A place of the left image, in cells, and the slope of the epipolar line there, rows for a column.
struct LineSlope {
  double column, row;
  double rise;
};

std::vector<LineSlope> slopes_over_image(const MachineProfile& profile, const ScanGeometry& geometry,
                                         const calib::Rig& rig) {
  const calib::Camera& left = rig.cameras.at(0);
  const Eigen::Vector3d to_right = right_camera_from_left(rig);
  const int cell = profile.cell();
  std::vector<LineSlope> slopes;
  for (int y = 0; y < geometry.height; y += kStep_px) {
    for (int x = 0; x < geometry.width / profile.subsample; x += kStep_px) {
      const Point pixel =
          geometry.to_frame({profile.subsample * x + 0.5 * (profile.subsample - 1), static_cast<double>(y)});
      Eigen::Matrix2d lens;
      const auto seen = left.model.undistort({pixel.x, pixel.y}, &lens);
      if (!seen) continue;
      const Eigen::Vector2d along = lens.inverse() * (to_right.head<2>() - *seen * to_right.z());
      const double run = along.x() / profile.subsample;
      const double rise = along.y() / geometry.row_step();
      if (!(std::abs(rise) <= std::abs(run))) continue;  // steeper than the comparison can follow
      // A code stands two cells right of and below the cell it is of.
      slopes.push_back({static_cast<double>(x) / cell + 2, static_cast<double>(y) / cell + 2, rise / run});
    }
  }
  return slopes;
}

/// Least squares of the slope of the left camera's epipolar lines over the image, by column and row of cells. What
/// another depth of a pixel's line of sight shows lies on the line through it, whatever the skin (CameraPair).
std::array<double, 4> fit_of(const std::vector<LineSlope>& slopes) {
  if (slopes.size() < 4) return {};
  Eigen::MatrixX4d a(static_cast<Eigen::Index>(slopes.size()), 4);
  Eigen::VectorXd rises(static_cast<Eigen::Index>(slopes.size()));
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    const auto& [column, row, rise] = slopes[i];
    a.row(static_cast<Eigen::Index>(i)) << 1, column, row, column * row;
    rises[static_cast<Eigen::Index>(i)] = rise;
  }
  const Eigen::Vector4d fit = a.colPivHouseholderQr().solve(rises);
  return {fit[0], fit[1], fit[2], fit[3]};
}

/// Whether at half of the places or more a line, followed so far, stays where the comparison at full resolution finds it.
bool mostly_within_reach(const std::vector<LineSlope>& slopes, double shift_px) {
  const auto within = std::ranges::count_if(
      slopes, [&](const LineSlope& place) { return std::abs(place.rise * shift_px) <= stages::patch_reach_across_px; });
  return 2 * within >= static_cast<std::ptrdiff_t>(slopes.size());
}

}  // namespace

Proof with_knowledge(Proof proof, const MachineProfile& profile, const std::vector<const MapTable*>& tables,
                     const std::string& rig, const std::string& file) {
  const int cell = profile.cell();
  int lowest = 0;
  int highest = 0;
  bool known = !tables.empty();
  for (const MapTable* table : tables) {
    const auto& shifts = table->facts().shifts;
    known = known && shifts.has_value();
    if (!shifts) continue;
    lowest = std::min(lowest, shifts->lowest_px);
    highest = std::max(highest, shifts->highest_px);
  }
  if (known) {
    proof.shift_lowest = cells_beyond(lowest, cell);
    proof.shift_highest = cells_beyond(highest, cell);
  }
  if (rig.empty() || tables.empty()) return proof;
  if (const calib::Rig cameras = calib::rig_from_yaml(rig, file); cameras.cameras.size() >= 2) {
    proof.registered = true;
    // The nearer a place, the further towards the left camera's side the right one sees it.
    proof.nearer_below = right_camera_from_left(cameras).x() > 0;
    proof.nearer_above = !proof.nearer_below;
    const auto slopes = slopes_over_image(profile, tables.front()->geometry(), cameras);
    proof.epipolar = fit_of(slopes);
    const int behind_px = std::abs(cell * (proof.nearer_below ? proof.shift_highest : proof.shift_lowest));
    proof.at_full_resolution = mostly_within_reach(slopes, behind_px);
  }
  return proof;
}

}  // namespace horopter
