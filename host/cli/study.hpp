// SPDX-License-Identifier: Apache-2.0
// The studies behind `horopter study`: each writes tables and plots into a directory and returns its figures as JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "horopter/output.hpp"

namespace horopter::cli {

struct StudyScope {
  std::uint64_t seed = 1;  ///< of the noise
  bool quick = false;      ///< about a tenth of the images, methods and runs: to see that all is well
};

/// Sub-pixel edge estimators on simulated edges (thesis 6.7).
nlohmann::json study_edges(OutputDirectory& directory, const StudyScope& scope);
/// Calibration with a rendered rig (thesis 6.8, 6.9).
nlohmann::json study_calibration(OutputDirectory& directory, const StudyScope& scope);

}  // namespace horopter::cli
