// SPDX-License-Identifier: Apache-2.0
// The warning that a lens model does not cover its image.
#pragma once

#include <optional>
#include <string>

#include "horopter/calib/camera.hpp"

namespace horopter::calib {

/// "lens_limit_inside_image: …" where the lens model ends before the image does.
std::optional<std::string> lens_limit_warning(const Camera& camera);

}  // namespace horopter::calib
