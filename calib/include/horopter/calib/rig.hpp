// SPDX-License-Identifier: Apache-2.0
// A rig: cameras with names and where they stand. Its own file, and the files of other programs.
//
// rig.yaml, version 1 (mm, pixels; lens terms in powers of mm for `tsai`, of the focal length for `brown_conrady`):
//
//   horopter_rig: 1
//   world: left camera                     # what world coordinates mean; free text
//   cameras:                               # in the order left, right, …
//     - name: left
//       image_size: [640, 480]             # left out where it is not known
//       model: brown_conrady               # OpenCV's: fx_px fy_px cx_px cy_px, k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4
//       fx_px: 533.5
//       …
//       distortion: {k1: -0.28, k2: 0.09}  # terms left out are 0
//       rotation: [[…], […], […]]          # x_camera = rotation · x_world + translation_mm; camera x right, y down
//       translation_mm: [0, 0, 0]
//     - name: right
//       model: tsai                        # the thesis's: f_mm dx_mm dy_mm sx cx_px cy_px,
//       …                                  #   kappa1 kappa2 kappa3 p1 p2 s1 s2
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "horopter/calib/camera.hpp"

namespace horopter::calib {

struct Rig {
  std::string world;
  std::vector<Camera> cameras;

  /// Distance between the first two cameras; NaN with fewer.
  double baseline_mm() const;
  /// From the first camera's coordinates to another's.
  Pose between(std::size_t from, std::size_t to) const {
    return cameras[to].world_to_camera * cameras[from].world_to_camera.inverse();
  }
};

/// How far apart two cameras that watch a skin may stand; beyond, the unit of their file is wrong.
constexpr double kSmallestBaseline_mm = 5, kLargestBaseline_mm = 2e4;
/// What is wrong with how far apart the first two cameras stand; empty where nothing is, or with one camera.
std::string baseline_problem(const Rig& rig);
/// The second camera stands to the left of the first, as images show left and right: the cameras are exchanged, or
/// their translation has the wrong sign.
bool are_exchanged(const Camera& first, const Camera& second);

struct RigFile {
  Rig rig;
  std::string format;  ///< "rig.yaml", "OpenCV", "ROS camera_info" or "Kalibr camchain"
  std::vector<std::string> warnings;
};

struct ImportOptions {
  std::optional<double> opencv_unit_mm;  ///< the unit of T in OpenCV's files, which do not say; 1000 for metres
  int width_px = 0, height_px = 0;       ///< where the files do not say
};

/// Reads a rig: rig.yaml, Kalibr's camchain, one or two files of OpenCV's FileStorage (YAML, XML, JSON), or the two
/// camera_info files of a ROS stereo pair, left first. The format is recognised by the content. Throws FileError, also
/// for OpenCV's T in a unit that neither the options nor `length_unit`, which to_opencv writes, tell.
RigFile load_rig(std::span<const std::filesystem::path> files, const ImportOptions& options = {});
RigFile load_rig(const std::filesystem::path& file, const ImportOptions& options = {});

/// Reads the text of a rig.yaml; `name` stands for the file in errors. Throws FileError.
Rig rig_from_yaml(const std::string& text, const std::string& name);

/// The text of rig.yaml. All digits of a double survive.
std::string to_yaml(const Rig& rig);

struct ExportedFile {
  std::string name;
  std::string text;
};
struct Exported {
  std::vector<ExportedFile> files;
  std::vector<std::string> warnings;  ///< conversions of a lens model, with their residual
};
/// OpenCV: one file of FileStorage YAML with image_width, image_height, M1 D1 M2 D2 R T, length_unit (mm) and R1 R2 P1 P2 Q; for one
/// camera camera_matrix, distortion_coefficients. ROS: camera_info of every camera (m). Lens models are converted to
/// Brown-Conrady. Throws CalibrationError where a rig cannot be expressed so.
Exported to_opencv(const Rig& rig);
Exported to_ros(const Rig& rig);

}  // namespace horopter::calib
