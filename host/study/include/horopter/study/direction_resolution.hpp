// SPDX-License-Identifier: Apache-2.0
// DSAD with directions of few bits (thesis 10.4.5, Fig. 10.4).
#pragma once

#include <memory>

#include "horopter/study/criteria.hpp"

namespace horopter::study {

/// The hardware's low-pass, Sobel and 8-bit direction; the direction reduced to `direction_bits` (2 … 8) before the
/// difference is taken, and the cyclic difference, of one bit less, to `difference_bits` (1 … direction_bits − 1) after
/// it. Dissimilarity, in steps of the difference; worst: all bits set. Gradients of 0 as in hls/stages/difference.hpp,
/// in its shares of the worst. 8 and 4 bits are the hardware's. Throws std::invalid_argument for other bits.
std::unique_ptr<Criterion> direction_resolution(int direction_bits, int difference_bits);

/// The same gradients with direction and difference in floating point, in 1/256 turn, at most 127.
std::unique_ptr<Criterion> direction_in_floating_point();

}  // namespace horopter::study
