// SPDX-License-Identifier: Apache-2.0
// The studies behind `horopter study`: each writes tables and plots into a directory and returns its figures as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "horopter/output.hpp"

namespace horopter::cli {

/// Sub-pixel edge estimators on simulated edges (thesis 6.7).
nlohmann::json study_edges(OutputDirectory& directory, std::uint64_t seed);
/// Calibration with a rendered rig (thesis 6.8, 6.9).
nlohmann::json study_calibration(OutputDirectory& directory, std::uint64_t seed);

}  // namespace horopter::cli
