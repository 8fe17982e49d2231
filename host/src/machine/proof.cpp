// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/proof.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "horopter/calib/rig.hpp"
#include "stages/agreement.hpp"

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

/// Least squares of the slope of the left camera's epipolar lines over the image, by column and row of cells. What
/// another depth of a pixel's line of sight shows lies on the line through it, whatever the skin (CameraPair).
std::array<double, 4> epipolar_slopes(const MachineProfile& profile, const ScanGeometry& geometry,
                                      const calib::Rig& rig) {
  const calib::Camera& left = rig.cameras.at(0);
  const Eigen::Vector3d to_right = right_camera_from_left(rig);
  const int cell = profile.cell();
  std::vector<Eigen::Vector4d> places;
  std::vector<double> slopes;
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
      const double column = static_cast<double>(x) / cell + 2;
      const double row = static_cast<double>(y) / cell + 2;
      places.emplace_back(1, column, row, column * row);
      slopes.push_back(rise / run);
    }
  }
  if (places.size() < 4) return {};
  Eigen::MatrixX4d a(static_cast<Eigen::Index>(places.size()), 4);
  for (std::size_t i = 0; i < places.size(); ++i) a.row(static_cast<Eigen::Index>(i)) = places[i];
  const Eigen::Vector4d fit = a.colPivHouseholderQr().solve(
      Eigen::Map<const Eigen::VectorXd>(slopes.data(), static_cast<Eigen::Index>(slopes.size())));
  return {fit[0], fit[1], fit[2], fit[3]};
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
    proof.epipolar = epipolar_slopes(profile, tables.front()->geometry(), cameras);
  }
  return proof;
}

}  // namespace horopter
