// SPDX-License-Identifier: Apache-2.0
// Objects as the monitor shows them.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "horopter/machine/object_tracker.hpp"
#include "horopter/monitor/state.hpp"

namespace horopter::monitor {

/// `camera_mm`: the left camera's centre, from which distances are; nothing without a rig.
ObjectState state_of(const TrackedObject& object, const std::optional<Eigen::Vector3d>& camera_mm);

}  // namespace horopter::monitor
