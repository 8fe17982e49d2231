// SPDX-License-Identifier: Apache-2.0
// Loops over many numbers, compiled for the vectors of the processor at hand as well. Without fused multiplication: the
// same results everywhere.
#pragma once

namespace horopter::calib {

#if defined(__x86_64__)
template <auto kLoop, class... Arguments>
[[gnu::target("avx2")]] void with_avx2(Arguments&... arguments) {
  kLoop(arguments...);
}
#endif

/// Runs `kLoop`, a function that is always inlined and does not depend on what the processor is.
template <auto kLoop, class... Arguments>
void vectorised(Arguments&&... arguments) {
#if defined(__x86_64__)
  static const bool avx2 = __builtin_cpu_supports("avx2") != 0;
  if (avx2) {
    with_avx2<kLoop>(arguments...);
    return;
  }
#endif
  kLoop(arguments...);
}

}  // namespace horopter::calib
