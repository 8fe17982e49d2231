// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace horopter {

/// Radians in a degree: angle_deg * kDegree is the angle in radians.
inline constexpr double kDegree = std::numbers::pi / 180;

}  // namespace horopter
