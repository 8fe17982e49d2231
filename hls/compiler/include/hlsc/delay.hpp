// SPDX-License-Identifier: Apache-2.0
// Delay estimates, in ns, of the operations of a graph on one FPGA family. They steer the schedule; place and route has
// the last word. Routing to an operation is part of its delay. The delays of logic are typical ones, so the clock given
// to the scheduler should leave a margin of some 20 % for routing detours; those of memories are maxima and are stated
// less that margin.
#pragma once

#include <optional>
#include <string_view>

#include "hlsc/graph.hpp"

namespace hlsc {

enum class Target { kEcp5, kIce40Hx };

std::string_view target_name(Target target);
std::optional<Target> target_from_name(std::string_view name);

struct DelayModel {
  Target target = Target::kIce40Hx;
  double launch_ns = 0;               ///< clock to output of a register; also what an input port is assumed to take
  double config_route_ns = 0;         ///< what the way from configuration is longer: it goes to all of a stage
  double setup_ns = 0;                ///< of a register behind a look-up table
  double level_ns = 0;                ///< one level of LUT4 and the routing to it
  double carry_base_ns = 0;           ///< an adder of no bits: routing, into the carry chain and out of it
  double carry_bit_ns = 0;            ///< each further bit of a carry chain
  double memory_read_ns = 0;          ///< clock to output of a block RAM, routing to the next operation excluded
  double memory_route_ns = 0;         ///< what the way from its output (register) is longer than any other's
  double memory_setup_ns = 0;         ///< routing to and set-up of a block RAM's address, data and enable
  double banks_ns = 0;                ///< of a distributed memory of more than one bank of 16 words
  double bank_ns = 0;                 ///< each doubling of its banks
  double multiplier_ns = 0;           ///< a hard multiplier; 0: there is none, multipliers are made of adders
  double multiplier_route_ns = 0;     ///< what the way from its output register is longer than any other's
  std::uint32_t multiplier_bits = 0;  ///< widest operand of a hard multiplier

  /// A table of at least so many bits is read synchronously from a block RAM where the schedule permits.
  std::uint32_t synchronous_rom_bits = 1024;

  /// From a memory's read address to the register of its data.
  double read_address_ns(const Ram& ram) const;
  /// What the way from the register of a node's result is longer than any other's.
  double route_ns(const Node& node, bool synchronous_rom) const;
  /// From the latest operand to the result; for sources beyond `launch_ns`.
  double node_ns(const Graph& graph, const Node& node) const;

 private:
  bool is_hard_product(const Node& node) const;
};

DelayModel make_delay_model(Target target);

/// Memories of few words or bits are made of look-up tables: a block memory of an FPGA would be nearly empty, and there are
/// few of them.
bool is_distributed(const Ram& ram);

}  // namespace hlsc
