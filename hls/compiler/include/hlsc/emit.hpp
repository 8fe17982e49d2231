// SPDX-License-Identifier: Apache-2.0
// SystemVerilog of a scheduled graph: one module per stage class. Ports: clk_i, rst_ni (synchronous), en_i (0: nothing
// changes), valid_i, the leaves of In, of Config (cfg_…), valid_o, with ram_parity parity_error_o (for a clock, two clocks
// after a word was read that is not as it was written; also if en_i = 0), the leaves of Out. The same graph and schedule
// always give the same text.
#pragma once

#include <string>
#include <vector>

#include "hlsc/graph.hpp"
#include "hlsc/schedule.hpp"

namespace hlsc {

struct EmitOptions {
  std::string source_class;  ///< named in the header comment and the sidecar
  std::string source_root;   ///< prefix taken off file names, so that the text does not depend on the machine
  bool ram_parity = false;   ///< even parity beside each word of a RAM; a port parity_error_o, if there is a RAM
};

struct EmittedMemory {
  std::string name;
  std::uint32_t depth = 0, width = 0, distance = 0;  ///< width with parity; distance 0: read only
  int read_stage = 0, write_stage = -1;
};

struct EmittedModule {
  std::string text;
  unsigned long state_bits = 0;     ///< flip-flops of C++ state
  unsigned long pipeline_bits = 0;  ///< further flip-flops, valid bits included, outputs of memories not
  std::vector<EmittedMemory> memories;
  bool parity_error = false;                                         ///< has the port parity_error_o
  std::vector<std::string> input_names, config_names, output_names;  ///< of the ports, in order
};

EmittedModule emit(const Graph& graph, const Schedule& schedule, const EmitOptions& options);

}  // namespace hlsc
