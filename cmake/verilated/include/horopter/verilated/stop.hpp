// SPDX-License-Identifier: Apache-2.0
// What a $stop, $finish, $fatal or failed assertion of a Verilated model becomes in C++.
#pragma once

#include <stdexcept>
#include <string>

namespace horopter::verilated {

/// Thrown out of the model's eval(). The message of the assertion itself has been printed by the model.
class Stopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// For models that are disturbed on purpose: whether a $error stops, as it does by default.
void stop_at_errors(bool stops);

}  // namespace horopter::verilated
