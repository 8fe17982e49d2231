// SPDX-License-Identifier: Apache-2.0
// skin.yaml: what a user writes down about a skin.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "horopter/calib/rig.hpp"
#include "horopter/skin/moving_surface.hpp"
#include "horopter/skin/skin.hpp"
#include "horopter/skin/surface.hpp"

namespace horopter {

/// A skin as read from skin.yaml.
struct SkinFile {
  std::unique_ptr<Skin> skin;
  std::string path;
  std::vector<Correspondence> correspondences;  ///< those given in the file, if any
  std::optional<HomographyFit> fit;
  MovingSurfacePtr motion;  ///< of a skin that moves; `skin` is then where its motion begins
  MotionLimits motion_limits;
  std::string rig;  ///< text of rig.yaml of the two cameras; empty for a skin that needs none
};

/// Reads skin.yaml; `skin_file_help()` says what may stand in it. `centre` is the centre of the left image: a
/// homography is used on that side of its horizon. `rig` is needed by surfaces, and not used by homographies and
/// correspondences. Throws FileError with the line, UsageError where a rig is needed.
SkinFile load_skin(const std::filesystem::path& path, Point centre, const calib::Rig* rig = nullptr);

/// The surface of a file like skin.yaml: a protected zone, an obstacle. Of a skin that moves, where it begins. Throws
/// FileError.
SurfacePtr load_surface(const std::filesystem::path& path);

/// The files that a skin.yaml names: meshes. Throws FileError.
std::vector<std::filesystem::path> files_named_in(const std::filesystem::path& path);

/// Whether a skin.yaml has `motion`. Throws FileError.
bool has_motion(const std::filesystem::path& path);

/// The types of surfaces and their keys, for --help.
std::string skin_file_help();

}  // namespace horopter
