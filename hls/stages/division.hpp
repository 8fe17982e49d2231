// SPDX-License-Identifier: Apache-2.0
// Divides a row or column of cells into equal parts, cell by cell (Bresenham, IBM Systems Journal 4(1), 1965).
#pragma once

#include "stages/stream.hpp"

namespace horopter::stages {

template <int PARTS>
class Division {
 public:
  /// The first cell of the first part is the one after `before` steps.
  void begin(u<8> cells, u<2> before) {
    rest_ = s<9>(-s<9>(cells) - before * lit<PARTS>());
    back_ = s<9>(lit<PARTS>() - cells);
  }
  /// The next cell begins another part.
  [[nodiscard]] bool at_end() const { return !s<9>(rest_ + lit<PARTS>()).negative(); }
  void step() { rest_ = after(); }
  /// Instead of step() where there are beats between two: look() in every beat, before take().
  void look() {
    looked_ = next_;
    next_ = after();
  }
  void take() { rest_ = looked_; }
  /// A copy of what `of` has begun with.
  void restart(const Division& of) {
    rest_ = of.rest_;
    back_ = of.back_;
  }

 private:
  [[nodiscard]] s<9> after() const {
    const s<9> on(rest_ + lit<PARTS>());
    const s<9> back(rest_ + back_);
    return on.negative() ? on : back;
  }
  s<9> rest_{0}, back_{0}, next_{0}, looked_{0};
};

}  // namespace horopter::stages
