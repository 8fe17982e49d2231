// SPDX-License-Identifier: Apache-2.0
// Shared by the sources of the calibration library.
#pragma once

#include <optional>
#include <string>

#include "horopter/calib/camera.hpp"

namespace horopter::calib {

/// "lens_limit_inside_image: …" where the lens model ends before the image does.
std::optional<std::string> lens_limit_warning(const Camera& camera);

}  // namespace horopter::calib
