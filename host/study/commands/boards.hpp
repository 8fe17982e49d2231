// SPDX-License-Identifier: Apache-2.0
// Photographs of a chessboard by two cameras, what calibration makes of them, and skins on the board.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "horopter/calib/rig.hpp"
#include "horopter/calib/target.hpp"
#include "horopter/image/image.hpp"
#include "horopter/skin/rig_skin.hpp"

namespace horopter::cli {

struct Board {
  std::string name;
  Image left, right;
  std::array<std::vector<Eigen::Vector2d>, 2> corners;  ///< px, of both images, in the order of the target's points
};

/// The pairs left01.jpg, right01.jpg to 14 of a directory, as opencv-doc has them. Throws FileError for fewer than 4.
std::vector<Board> load_boards(const std::string& directory, const calib::TargetSpec& spec);

/// The rig, from all boards, or all but one. `terms` of distortion: calib::distortion_terms.
calib::Rig calibrate_boards(const std::vector<Board>& boards, const calib::TargetSpec& spec, const char* terms,
                            std::optional<std::size_t> left_out = {});

/// A plane that two cameras watch, to be moved along its normal, which points away from them.
struct SkinPlane {
  CameraPair cameras;
  Eigen::Vector3d point_mm, normal;
  RigSkin moved(double shift_mm) const { return {cameras, make_plane(point_mm + shift_mm * normal, normal), "plane"}; }
};

/// The plane of a board, found in the left image alone.
SkinPlane plane_of(const calib::Rig& rig, const Board& board, const calib::TargetSpec& spec);

}  // namespace horopter::cli
