// SPDX-License-Identifier: Apache-2.0
// From a wanted tolerance to the hardware's threshold (thesis 11.2.1).
#pragma once

namespace horopter::study {

/// The threshold in % of T_max = 15·9² at which the hardware's 9×9 stage takes half of the pixels displaced by
/// tolerance_px for the skin: linear between the rows of threshold_table.def, which `horopter study detection` writes.
/// Throws std::out_of_range beyond the table.
double threshold_percent_for(double tolerance_px);

/// The table's ends.
double smallest_tolerance_px();
double largest_tolerance_px();

}  // namespace horopter::study
