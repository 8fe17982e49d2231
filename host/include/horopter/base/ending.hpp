// SPDX-License-Identifier: Apache-2.0
// What must be put in order when a signal ends the program in the middle of its work.
#pragma once

#include <functional>

namespace horopter {

/// While it lives, `action` is called before a request to stop ends the program: once, in a thread of its own, while
/// the others run on. What the action locks it leaves locked, so that they do not go on with what it has put in order.
class BeforeEnding {
 public:
  explicit BeforeEnding(std::function<void()> action);
  /// Not while holding what the action locks.
  ~BeforeEnding();
  BeforeEnding(const BeforeEnding&) = delete;
  BeforeEnding& operator=(const BeforeEnding&) = delete;

 private:
  std::function<void()> action_;
};

/// Calls the actions, the youngest first. From then on nobody can make or destroy one: the caller ends the program.
void prepare_ending();
/// The program ends by itself: from now on prepare_ending() does not return, and calls nothing.
void ending_by_itself();

}  // namespace horopter
