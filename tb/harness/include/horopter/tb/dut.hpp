// SPDX-License-Identifier: Apache-2.0
// Emitted modules as a bench sees them: the same few pointers for each, whatever its ports. generate_dut_model writes
// the SystemVerilog wrapper and the C++ that fills these in, from the sidecars alone.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace horopter::tb {

struct DutPort {
  std::string name;
  unsigned width = 0;
  bool is_signed = false;
};

/// A memory of the emitted module, or registers that reset does not clear, and the pipeline stage (0 = the clock in
/// which the beat is taken) that writes it.
struct DutMemory {
  std::string name;
  unsigned write_stage = 0;
};

/// One emitted module inside a Verilated model. It has a clock of its own, so modules of one model do not disturb each
/// other. Leaves are packed least significant first, in port order, into `in`, `config` and `out`.
struct Dut {
  std::string name;
  unsigned latency = 0;
  std::uint8_t* clock = nullptr;
  std::uint8_t* reset_n = nullptr;
  std::uint8_t* enable = nullptr;
  std::uint8_t* valid_in = nullptr;
  const std::uint8_t* valid_out = nullptr;
  const std::uint8_t* parity_error = nullptr;  ///< only where memories have parity
  std::uint32_t* in = nullptr;
  std::uint32_t* config = nullptr;
  const std::uint32_t* out = nullptr;
  std::vector<DutPort> in_ports, config_ports, out_ports;
  std::vector<DutMemory> memories;
};

/// A Verilated model that holds several emitted modules.
class DutModel {
 public:
  virtual ~DutModel() = default;
  virtual void eval() = 0;
  Dut& dut(const std::string& name);

 protected:
  std::vector<Dut> duts_;
};

}  // namespace horopter::tb
