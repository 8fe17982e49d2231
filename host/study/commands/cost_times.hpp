// SPDX-License-Identifier: Apache-2.0
// A part of the study of cost that is not the same twice.
#pragma once

#include "study.hpp"

namespace horopter::cli {

/// Table 8.5 by the clock: ms of each criterion on this machine, for images of 378×286 pixels, 9×9.
void measure_times(StudyReport& report, const StudyScope& scope);

}  // namespace horopter::cli
