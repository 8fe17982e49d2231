// SPDX-License-Identifier: Apache-2.0
// Makes nodes of a graph: equal nodes are made once, and everything that can be simplified locally never becomes a
// node. Every function works on bits, so constant, repeated and unchanged bits drop out of an operation: what remains
// of it has the width that the arithmetic needs, whatever the width of the C++ type.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "hlsc/graph.hpp"

namespace hlsc {

/// `port` of the kInput nodes that stand for values nobody has set. None is left in a finished graph.
inline constexpr std::uint32_t kUndefinedPort = 0xFFFFFFFF, kUnsetPort = 0xFFFFFFFE;

class Builder {
 public:
  Builder();

  /// Place given to the nodes made from now on.
  SourceLocation where;

  // Sources: kInput, kConfig, kStateRead, kRamRead.
  Bits source(Op op, std::uint32_t port, std::uint32_t width, const std::string& name);
  /// An undefined value; `what` tells whose, for the error if it turns out to matter.
  Bits undefined(std::uint32_t width, const std::string& what) { return nothing(kUndefinedPort, width, what); }
  /// The same, but a multiplexer does not take its other side for it: it matters if it is left on any path.
  Bits unset(std::uint32_t width, const std::string& what) { return nothing(kUnsetPort, width, what); }
  Bits rom(std::uint32_t port, const Bits& address, std::uint32_t width);

  static Bits constant(std::uint64_t value, std::size_t width);
  static Bits constant(const std::vector<bool>& value);

  Bits bit_and(const Bits& a, const Bits& b) { return bitwise(Op::kAnd, a, b); }
  Bits bit_or(const Bits& a, const Bits& b) { return bitwise(Op::kOr, a, b); }
  Bits bit_xor(const Bits& a, const Bits& b) { return bitwise(Op::kXor, a, b); }
  Bits bit_not(const Bits& a);
  Bit bit_and(Bit a, Bit b) { return bit_and(Bits{a}, Bits{b})[0]; }
  Bit bit_or(Bit a, Bit b) { return bit_or(Bits{a}, Bits{b})[0]; }
  Bit bit_xor(Bit a, Bit b) { return bit_xor(Bits{a}, Bits{b})[0]; }
  Bit bit_not(Bit a) { return bit_not(Bits{a})[0]; }

  // Modulo 2^size, operands of equal size.
  Bits add(const Bits& a, const Bits& b);
  Bits sub(const Bits& a, const Bits& b);
  Bits mul(const Bits& a, const Bits& b);

  // The amount is below the size of `a` (anything else is undefined in C++): higher bits of it are not looked at.
  Bits shl(const Bits& a, const Bits& amount);
  Bits lshr(const Bits& a, const Bits& amount);
  Bits ashr(const Bits& a, const Bits& amount);

  Bit eq(const Bits& a, const Bits& b);
  Bit ult(const Bits& a, const Bits& b);
  Bit slt(const Bits& a, const Bits& b);

  /// `condition ? a : b`. An undefined bit of one side becomes the other side's.
  Bits mux(Bit condition, const Bits& a, const Bits& b);
  Bit mux(Bit condition, Bit a, Bit b) { return mux(condition, Bits{a}, Bits{b})[0]; }

  Bit reduce_or(const Bits& a);
  Bit reduce_and(const Bits& a);
  Bit reduce_xor(const Bits& a);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] std::vector<Node>& nodes() { return nodes_; }

  [[nodiscard]] bool is_undefined(Bit bit) const;
  static bool is_constant(Bit bit) { return bit.node == 0; }
  static bool is_constant(const Bits& bits);
  static std::uint64_t value_of(const Bits& bits);  ///< of constant bits, the low 64

  static Bits zero_extend(Bits a, std::size_t width);
  static Bits sign_extend(Bits a, std::size_t width);
  static Bits slice(const Bits& a, std::size_t low, std::size_t width);

  /// Gives the node behind `bits` a C++ name, if it is one node and has none yet.
  void name(const Bits& bits, const std::string& name);

 private:
  Bits nothing(std::uint32_t port, std::uint32_t width, const std::string& what);
  Bits bitwise(Op op, const Bits& a, const Bits& b);
  Bits make(Op op, std::uint32_t width, std::vector<Bits> operands, std::uint32_t port = 0);
  [[nodiscard]] bool complementary(Bit a, Bit b) const;
  [[nodiscard]] bool simplify_bit(Op op, Bit a, Bit b, Bit& result) const;
  /// Largest unsigned value; UINT64_MAX where it is not known to fit 62 bits.
  [[nodiscard]] std::uint64_t bound(const Bits& a) const;
  [[nodiscard]] std::uint64_t bound_of(const Node& node) const;
  Bits multiply_by_constant(const Bits& a, const Bits& constant);
  template <typename Stage>
  Bits barrel(Bits a, const Bits& amount, Stage stage);

  std::vector<Node> nodes_;
  std::vector<std::uint64_t> bounds_;                           ///< by node: largest unsigned value
  std::unordered_map<std::size_t, std::vector<NodeId>> table_;  ///< by hash
};

}  // namespace hlsc
