// SPDX-License-Identifier: Apache-2.0
// Makes a draft again, node by node, under assumptions about its state and memory bits; everything simplifies anew.
#pragma once

#include <vector>

#include "hlsc/builder.hpp"
#include "hlsc/draft.hpp"

namespace hlsc {

/// Per node and bit: does any output depend on it?
using Liveness = std::vector<std::vector<bool>>;
Liveness liveness(const Draft& draft);

/// What a state or memory bit is taken for.
struct Substitute {
  enum class Kind { kItself, kZero, kOne, kSame } kind = Kind::kItself;
  std::uint32_t state = 0, bit = 0;  ///< kSame: as this bit (of another state, or of the same memory)
};
struct Assumptions {
  std::vector<std::vector<Substitute>> states, rams;  ///< by bit
  explicit Assumptions(const Draft& draft);           ///< everything is itself
};

class Rebuild {
 public:
  /// A trial only tells what becomes of each bit: the assumptions may change, and `again` takes them.
  enum class Purpose { kResult, kTrial };

  /// Live bits only; the others are undefined in the result. The arguments must live as long as this.
  Rebuild(const Draft& from, const Liveness& live, const Assumptions& assumptions, Purpose purpose = Purpose::kResult);

  [[nodiscard]] Bit map(Bit old) const { return old.node == 0 ? old : bits_[old.node][old.index]; }
  [[nodiscard]] Bits map(const Bits& old) const;
  /// Of a trial: makes what depends on assumptions that have changed anew.
  void again();
  /// The new draft: states and memories without the bits that are dead or substituted. Not of a trial.
  Draft take();

 private:
  void make_sources();
  void substitute();
  void make(NodeId id);
  Bits make_rom(const Node& node, const std::vector<std::size_t>& columns);

  const Draft& from_;
  const Liveness& live_;
  const Assumptions& assumptions_;
  Purpose purpose_;
  Builder builder_;
  std::vector<Bits> bits_;     ///< by old node
  std::vector<Bits> sources_;  ///< of states and memories: before they are taken for something else
  std::vector<Rom> roms_;
  std::vector<std::vector<std::uint32_t>> kept_states_, kept_rams_;  ///< old bit numbers
  Bit dead_;
};

}  // namespace hlsc
