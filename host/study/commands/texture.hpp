// SPDX-License-Identifier: Apache-2.0
// Parts of the study of texture.
#pragma once

#include "study.hpp"

namespace horopter::cli {

/// Thesis 9.2, Fig. 9.1, 9.2: how much texture the correlation needs against the noise.
void texture_against_noise(StudyReport& report, const StudyScope& scope);

}  // namespace horopter::cli
