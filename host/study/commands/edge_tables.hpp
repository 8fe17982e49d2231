// SPDX-License-Identifier: Apache-2.0
// Parts of the study of edges.
#pragma once

#include "study.hpp"

namespace horopter::cli {

/// Thesis 6.7.2 and 6.7.3, Tables 6.1 and 6.2: the same target again and again, with noise and line jitter.
void edge_tables(StudyReport& report, const StudyScope& scope);

}  // namespace horopter::cli
