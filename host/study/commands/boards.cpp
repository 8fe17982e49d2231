// SPDX-License-Identifier: Apache-2.0
#include "boards.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <opencv2/calib3d.hpp>
#include <utility>

#include "cli/progress.hpp"
#include "horopter/base/error.hpp"
#include "horopter/calib/joint.hpp"
#include "horopter/calib/views.hpp"
#include "horopter/image/mat.hpp"

namespace horopter::cli {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::vector<Board> load_boards(const std::string& directory, const calib::TargetSpec& spec) {
  std::vector<Board> boards;
  Progress progress("finding the board in pair");
  for (int number = 1; number <= 14; ++number) {
    const std::string name = fmt::format("{:02}", number);
    const std::filesystem::path data(directory);
    if (!std::filesystem::exists(data / ("left" + name + ".jpg"))) continue;
    progress.show(static_cast<std::size_t>(number), 14);
    Board board{name, load_image(data / ("left" + name + ".jpg")), load_image(data / ("right" + name + ".jpg")), {}};
    for (std::size_t side = 0; side < 2; ++side) {
      const Image& image = side == 0 ? board.left : board.right;
      board.corners[side] = calib::detect_target(mat_of(image), spec).image_px;
    }
    boards.push_back(std::move(board));
  }
  if (boards.size() < 4) {
    throw FileError(directory, "", fmt::format("{} pairs left01.jpg, right01.jpg to 14", boards.size()),
                    "4 or more, as in Debian's package opencv-doc");
  }
  return boards;
}

calib::Rig calibrate_boards(const std::vector<Board>& boards, const calib::TargetSpec& spec, const char* terms,
                            std::optional<std::size_t> left_out) {
  std::vector<calib::ViewCamera> cameras(2);
  for (std::size_t side = 0; side < 2; ++side) {
    cameras[side].name = side == 0 ? "left" : "right";
    cameras[side].width_px = boards[0].left.width;
    cameras[side].height_px = boards[0].left.height;
    for (std::size_t i = 0; i < boards.size(); ++i) {
      if (i == left_out) continue;
      cameras[side].views.push_back({.file = boards[i].name, .pixels = boards[i].corners[side], .problem = {}});
    }
  }
  calib::ViewOptions options;
  options.distortion = calib::distortion_terms(terms);
  return calib::calibrate_views(cameras, spec.points_mm(), options).rig;
}

namespace {

/// The board in the left camera's coordinates, from the left image alone.
calib::Pose board_pose(const calib::Camera& left, const std::vector<Vector2d>& corners,
                       const std::vector<Vector2d>& target_mm) {
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> seen;
  calib::JointObservation observation;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto undistorted = left.model.undistort(corners[i]);
    if (!undistorted) throw Error(ExitStatus::check_failed, "a corner is beyond the limit of the lens model");
    points.emplace_back(target_mm[i].x(), target_mm[i].y(), 0);
    seen.emplace_back(undistorted->x(), undistorted->y());
    observation.points_mm.emplace_back(target_mm[i].x(), target_mm[i].y(), 0);
    observation.pixels.push_back(corners[i]);
  }
  cv::Vec3d rotation;
  cv::Vec3d translation;
  cv::solvePnP(points, seen, cv::Matx33d::eye(), cv::noArray(), rotation, translation, false, cv::SOLVEPNP_IPPE);
  calib::JointProblem problem;
  problem.cameras.push_back({.intrinsics = left.model.intrinsics(), .rig_to_camera = {}});
  problem.views.push_back({.target_to_rig = {calib::rotation_from_vector({rotation[0], rotation[1], rotation[2]}),
                                             {translation[0], translation[1], translation[2]}}});
  problem.observations.push_back(observation);
  calib::optimise(problem);
  return problem.views[0].target_to_rig;
}

}  // namespace

SkinPlane plane_of(const calib::Rig& rig, const Board& board, const calib::TargetSpec& spec) {
  const calib::Camera& left = rig.cameras[0];
  const calib::Pose pose = left.world_to_camera.inverse() * board_pose(left, board.corners[0], spec.points_mm());
  Vector3d normal = pose.rotation.col(2);
  if (normal.dot(pose.translation_mm - left.world_to_camera.centre()) < 0) normal = -normal;
  return {CameraPair(rig.cameras[0], rig.cameras[1]), pose.translation_mm, normal};
}

}  // namespace horopter::cli
