// SPDX-License-Identifier: Apache-2.0
// Kept<T>: a member of a stage whose registers reset leaves as they are, for what a stage writes anew before it counts:
// windows that begin again with each row. A flip-flop without reset is smaller.
//
// Zero at power-up in simulation and in FPGAs; T{} must be all zeros.
#pragma once

namespace horopter::hls {

namespace detail {

/// While true, assigning to a Kept or a RAM keeps its contents: see reset().
inline bool& keep_contents() {
  thread_local bool keep = false;
  return keep;
}

}  // namespace detail

template <typename T>
class Kept {
 public:
#ifndef __HLSC__
  Kept() = default;
  ~Kept() = default;
  Kept(const Kept&) = default;
  Kept(Kept&&) = default;
  Kept& operator=(const Kept& other) {
    if (this != &other && !detail::keep_contents()) value_ = other.value_;
    return *this;
  }
  Kept& operator=(Kept&& other) {  // NOLINT(performance-noexcept-move-constructor): T decides
    return *this = other;
  }
#endif
  T& operator*() { return value_; }
  T* operator->() { return &value_; }

 private:
  T value_{};
};

#ifndef __HLSC__
/// What rst_ni does: registers to their initial values, but those of Kept; RAM contents kept.
template <typename Stage>
void reset(Stage& stage) {
  struct Keep {
    Keep() { detail::keep_contents() = true; }
    ~Keep() { detail::keep_contents() = false; }
  } keep;
  stage = Stage{};
}
#endif

}  // namespace horopter::hls
