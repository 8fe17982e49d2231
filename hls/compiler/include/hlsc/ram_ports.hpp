// SPDX-License-Identifier: Apache-2.0
// The calls of RAM<>::read and ::write as the one read and the one write port of each memory.
#pragma once

#include <map>
#include <vector>

#include "hlsc/builder.hpp"
#include "hlsc/layout.hpp"
#include "hlsc/memory.hpp"
#include "hlsc/symbolic.hpp"

namespace hlsc {

/// What a port has done so far in this step is kept as an object in memory, so that it is merged where paths meet, as
/// any other value: exclusive accesses become multiplexers. Layout: bit 0 active, then address, then data.
class StagePorts : public RamPorts {
 public:
  StagePorts(Builder& builder, Memory& memory, ObjectId stage, const Layout& layout);

  /// Ports not used yet; adds the memories to `graph`.
  void start(Contents& contents, Graph& graph);
  void init(Contents& contents, const Bits& pointer, const Bits& initial) override;
  Bits read(Contents& contents, const Bits& pointer, const Bits& address, std::uint64_t bytes, Bit active) override;
  void write(Contents& contents, const Bits& pointer, const Bits& address, const Bits& data, Bit active) override;
  void finish(const Contents& contents, Graph& graph) const;

 private:
  struct Port {
    ObjectId read = 0, write = 0;
    std::uint32_t address_bits = 1, data_bits = 0;
    Bits data;  ///< of the kRamRead node
    bool used = false;
    SourceLocation where;
  };
  struct State {
    Bit active;
    Bits address, data;
  };
  std::size_t index_of(const Bits& pointer) const;
  static State unpack(const Port& port, const Bits& bits);
  static Bits pack(const State& state);
  Bits pack_word(const RamMember& ram, const Bits& storage) const;
  Bits unpack_word(const RamMember& ram, const Bits& word, std::uint64_t bytes) const;

  Builder& builder_;
  Memory& memory_;
  ObjectId stage_;
  const Layout& layout_;
  std::vector<Port> ports_;
};

}  // namespace hlsc
