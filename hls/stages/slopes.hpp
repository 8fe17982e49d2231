// SPDX-License-Identifier: Apache-2.0
// slopes: the gradients that `compete` takes, Sobel's on the images themselves, and the left image's grey value. Without
// the low-pass of `thesis`: what tells planes apart is the detail along the row, which it would take.
//
// In    grey values.   Out  as of `sobel`.
#pragma once

#include "stages/sobel.hpp"

namespace horopter::stages {

template <Profile P, class V = Scalar>
using Slopes = SobelFilter<P.result_width(), 2, 1, V, true>;

}  // namespace horopter::stages
