// SPDX-License-Identifier: Apache-2.0
#include "horopter/tb/dut.hpp"

#include <stdexcept>

namespace horopter::tb {

Dut& DutModel::dut(const std::string& name) {
  for (Dut& dut : duts_) {
    if (dut.name == name) return dut;
  }
  throw std::out_of_range{"no module " + name + " in this model"};
}

}  // namespace horopter::tb
