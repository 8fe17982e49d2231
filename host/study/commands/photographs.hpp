// SPDX-License-Identifier: Apache-2.0
// What the studies with bodies before photographs have in common: the rig, the skin, the photographs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "horopter/image/image.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/plan/plan_rig.hpp"
#include "study.hpp"

namespace horopter::cli {

/// Table 11.1, its sensor in 640 columns.
inline constexpr RigDesign kRig{10, 8.5 * 756 / 640, 640, 480, 152, 4};
inline constexpr double kSkin_mm = 800;  ///< distance of the skin, a plane across the axis of symmetry
inline constexpr double kNoise_grey = 1.5;

/// Tables of that skin for images of the rig kRig.
MapSet plane_maps(const calib::Rig& rig, const MachineProfile& profile, Decision decision);

/// Names and images of opencv-doc's photographs that fill an image, darker than they are: white is not at the limit, and
/// may become brighter. `scope.quick`: one of them. Throws FileError.
std::vector<std::pair<std::string, Image>> load_photographs(const StudyScope& scope);

}  // namespace horopter::cli
