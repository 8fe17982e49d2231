// SPDX-License-Identifier: Apache-2.0
// The dataflow graph between frontend and backend: one `step` of a stage, without control flow.
//
// A value is a vector of single bits, least significant first, each naming a bit of a node. Extensions, constant
// shifts, slices, struct padding and packed words are rearrangements of bits and cost no nodes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hlsc {

using NodeId = std::uint32_t;

/// One bit of a node's result. Node 0 is the constant: bit 0 of it is `0`, bit 1 is `1`.
struct Bit {
  NodeId node = 0;
  std::uint32_t index = 0;
  friend auto operator<=>(const Bit&, const Bit&) = default;
};
using Bits = std::vector<Bit>;

inline constexpr Bit kZero{0, 0};
inline constexpr Bit kOne{0, 1};

enum class Op {
  kConstant,   ///< node 0 only
  kInput,      ///< a leaf of In: `port` indexes Graph::inputs
  kConfig,     ///< a leaf of Config: quasi-static, available in every pipeline stage without registers
  kStateRead,  ///< value of a state register before the step: `port` indexes Graph::states
  kRamRead,    ///< data of a synchronous read: `port` indexes Graph::rams (address and enable stand there)
  kRom,        ///< constant table: operand 0 = address, `port` indexes Graph::roms
  kAnd,
  kOr,
  kXor,  ///< bitwise, operands of equal width
  kNot,  ///< bitwise
  kAdd,
  kSub,
  kMul,        ///< modulo 2^width, operands of the node's width (kMul: operands may be narrower, unsigned)
  kMulSigned,  ///< operands sign-extended to the node's width
  kShl,
  kLshr,
  kAshr,  ///< variable shift: operand 1 unsigned; amounts ≥ width give zero (kAshr: sign)
  kEq,
  kUlt,
  kSlt,  ///< 1 bit; operands of equal width
  kMux,  ///< operand 0 (1 bit) ? operand 1 : operand 2
  kReduceOr,
  kReduceAnd,
  kReduceXor,  ///< 1 bit
};

struct SourceLocation {
  std::string file;
  unsigned line = 0;
};

struct Node {
  Op op = Op::kConstant;
  std::uint32_t width = 1;
  std::vector<Bits> operands;
  std::uint32_t port = 0;
  std::string name;  ///< of a C++ variable, if it had one
  SourceLocation where;
};

struct Port {
  std::string name;  ///< leaf path joined by `_`, without the direction suffix
  std::uint32_t width = 1;
  bool is_signed = false;
  NodeId node = 0;  ///< kInput or kConfig (inputs only)
  Bits value;       ///< outputs only
};

struct State {
  std::string name;
  std::uint32_t width = 1;
  std::vector<bool> initial;  ///< reset value, least significant bit first
  NodeId read = 0;            ///< its kStateRead node
  Bits next;                  ///< value after the step
  bool kept = false;          ///< not reset: `initial` at power-up only
};

/// One synchronous memory: at most one read and one write a step. The read returns the contents before the step; what
/// an earlier write of the same step gives has been forwarded by the frontend already.
struct Ram {
  std::string name;
  std::uint32_t depth = 0, width = 0;
  std::uint32_t distance = 0;  ///< any two accesses of one address are at least so many steps apart
  NodeId read = 0;             ///< its kRamRead node; 0: never read
  Bits read_address, write_address, write_data;
  Bit read_enable = kZero, write_enable = kZero;
  SourceLocation where;
};

struct Rom {
  std::string name;
  std::uint32_t width = 0;
  std::vector<std::vector<bool>> words;  ///< addresses beyond the end read as zero
};

struct Graph {
  std::string top_name;     ///< module name
  std::vector<Node> nodes;  ///< in topological order; states are sources, a RAM read follows its address and enable
  std::vector<Port> inputs, configs, outputs;
  std::vector<State> states;
  std::vector<Ram> rams;
  std::vector<Rom> roms;
  Bit output_valid = kOne;  ///< leaf `valid` of Out, if it has one
  std::string source_file;
};

}  // namespace hlsc
