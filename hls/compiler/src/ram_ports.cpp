// SPDX-License-Identifier: Apache-2.0
#include "hlsc/ram_ports.hpp"

#include <algorithm>

#include "hlsc/diagnostics.hpp"

namespace hlsc {

StagePorts::StagePorts(Builder& builder, Memory& memory, ObjectId stage, const Layout& layout)
    : builder_(builder), memory_(memory), stage_(stage), layout_(layout) {}

std::size_t StagePorts::index_of(const Bits& pointer) const {
  const auto place = Memory::known(pointer);
  if (!place) throw CompileError(builder_.where, "the memory is chosen by a variable: each access must name one RAM");
  if (place->first != stage_) throw CompileError(builder_.where, "a RAM must be a member of the stage");
  for (std::size_t i = 0; i < layout_.rams.size(); ++i) {
    if (layout_.rams[i].offset_bits == place->second * 8) return i;
  }
  throw CompileError(builder_.where, "access to a RAM that is no member of the stage");
}

StagePorts::State StagePorts::unpack(const Port& port, const Bits& bits) {
  State state;
  state.active = bits[0];
  state.address = Builder::slice(bits, 1, port.address_bits);
  state.data = Builder::slice(bits, 1 + port.address_bits, bits.size() - 1 - port.address_bits);
  return state;
}

Bits StagePorts::pack(const State& state) {
  Bits bits{state.active};
  bits.insert(bits.end(), state.address.begin(), state.address.end());
  bits.insert(bits.end(), state.data.begin(), state.data.end());
  return bits;
}

void StagePorts::start(Contents& contents, Graph& graph) {
  for (const RamMember& ram : layout_.rams) {
    Port port;
    while ((std::uint64_t{1} << port.address_bits) < ram.depth) ++port.address_bits;
    for (const Leaf& leaf : ram.word.leaves) port.data_bits += leaf.width;
    for (const bool write : {false, true}) {
      Object object;
      object.name = ram.name;
      object.size_bits = 1 + port.address_bits + (write ? port.data_bits : 0);
      object.cuts = {1, 1 + port.address_bits};
      if (write) {
        std::uint64_t cut = 1 + port.address_bits;
        for (const Leaf& leaf : ram.word.leaves) object.cuts.insert(cut += leaf.width);
      }
      Bits bits{kZero};
      const Bits rest = builder_.undefined(static_cast<std::uint32_t>(object.size_bits - 1), ram.name);
      bits.insert(bits.end(), rest.begin(), rest.end());
      const ObjectId id = memory_.add_object(std::move(object));
      contents.set(id, std::move(bits));
      (write ? port.write : port.read) = id;
    }
    builder_.where = ram.where;
    port.data = builder_.source(Op::kRamRead, static_cast<std::uint32_t>(ports_.size()), port.data_bits, ram.name);
    ports_.push_back(std::move(port));
    Ram made;
    made.name = ram.name;
    made.depth = static_cast<std::uint32_t>(ram.depth);
    made.width = ports_.back().data_bits;
    made.distance = static_cast<std::uint32_t>(ram.distance);
    made.where = ram.where;
    graph.rams.push_back(std::move(made));
  }
}

void StagePorts::init(Contents&, const Bits& pointer, const Bits& initial) {
  const std::size_t i = index_of(pointer);
  for (const Bit bit : pack_word(layout_.rams[i], initial)) {
    if (bit == kZero) continue;
    throw CompileError(layout_.rams[i].where,
                       "the words of memory `" + layout_.rams[i].name +
                           "` are not zero when made without arguments: a RAM is zero at power-up");
  }
}

Bits StagePorts::pack_word(const RamMember& ram, const Bits& storage) const {
  Bits word;
  for (const Leaf& leaf : ram.word.leaves) {
    const Bits part = Builder::slice(storage, leaf.offset_bits, leaf.width);
    word.insert(word.end(), part.begin(), part.end());
  }
  return word;
}

Bits StagePorts::unpack_word(const RamMember& ram, const Bits& word, std::uint64_t bytes) const {
  Bits storage = builder_.undefined(static_cast<std::uint32_t>(bytes * 8), "padding in a word of " + ram.name);
  std::size_t low = 0;
  for (const Leaf& leaf : ram.word.leaves) {
    const Bits part = Builder::slice(word, low, leaf.width);
    const Bits wide =
        leaf.is_signed ? Builder::sign_extend(part, leaf.storage_bits) : Builder::zero_extend(part, leaf.storage_bits);
    std::copy(wide.begin(), wide.end(), storage.begin() + static_cast<std::ptrdiff_t>(leaf.offset_bits));
    low += leaf.width;
  }
  return storage;
}

Bits StagePorts::read(Contents& contents, const Bits& pointer, const Bits& address, std::uint64_t bytes, Bit active) {
  const std::size_t i = index_of(pointer);
  const RamMember& ram = layout_.rams[i];
  Port& port = ports_[i];
  const Bits short_address = Builder::slice(address, 0, port.address_bits);
  State reading = unpack(port, contents.of(port.read));
  if (reading.address != short_address && builder_.bit_and(reading.active, active) != kZero) {
    throw CompileError(builder_.where,
                       "memory `" + ram.name + "` is read at two addresses in one step: it has one read port");
  }
  reading.active = kOne;
  reading.address = short_address;
  contents.set(port.read, pack(reading));
  const State writing = unpack(port, contents.of(port.write));
  const Bit hit = builder_.bit_and(writing.active, builder_.eq(writing.address, short_address));
  return unpack_word(ram, builder_.mux(hit, writing.data, port.data), bytes);
}

void StagePorts::write(Contents& contents, const Bits& pointer, const Bits& address, const Bits& data, Bit active) {
  const std::size_t i = index_of(pointer);
  const RamMember& ram = layout_.rams[i];
  Port& port = ports_[i];
  const Bits short_address = Builder::slice(address, 0, port.address_bits);
  State writing = unpack(port, contents.of(port.write));
  if (writing.address != short_address && builder_.bit_and(writing.active, active) != kZero) {
    throw CompileError(builder_.where,
                       "memory `" + ram.name + "` is written at two addresses in one step: it has one write port");
  }
  writing.active = kOne;
  writing.address = short_address;
  writing.data = pack_word(ram, data);
  contents.set(port.write, pack(writing));
}

void StagePorts::finish(const Contents& contents, Graph& graph) const {
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    const State reading = unpack(ports_[i], contents.of(ports_[i].read)),
                writing = unpack(ports_[i], contents.of(ports_[i].write));
    Ram& ram = graph.rams[i];
    ram.read = ports_[i].data.empty() ? 0 : ports_[i].data[0].node;
    ram.read_enable = reading.active;
    ram.read_address = reading.address;
    ram.write_enable = writing.active;
    ram.write_address = writing.address;
    ram.write_data = writing.data;
  }
}

}  // namespace hlsc
