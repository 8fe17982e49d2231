// SPDX-License-Identifier: Apache-2.0
#include "horopter/tb/leaves.hpp"

#include <bit>
#include <cstring>

namespace horopter::tb {

static_assert(std::endian::native == std::endian::little, "leaves are copied low byte first");

void get_leaves(const void* object, const std::vector<Leaf>& leaves, std::vector<std::uint64_t>& values) {
  values.clear();
  for (const Leaf& leaf : leaves) {
    if (!leaf.has_port) continue;
    std::uint64_t value = 0;
    std::memcpy(&value, static_cast<const char*>(object) + leaf.offset, leaf.bytes);
    values.push_back(value & (~std::uint64_t{0} >> (64 - leaf.width)));
  }
}

void set_leaves(void* object, const std::vector<Leaf>& leaves, const std::vector<std::uint64_t>& values) {
  auto next = values.begin();
  for (const Leaf& leaf : leaves) {
    if (!leaf.has_port) continue;
    const unsigned unused = 64 - leaf.width;
    const std::uint64_t high = *next++ << unused;
    const std::uint64_t value =
        leaf.is_signed ? static_cast<std::uint64_t>(static_cast<std::int64_t>(high) >> unused) : high >> unused;
    std::memcpy(static_cast<char*>(object) + leaf.offset, &value, leaf.bytes);
  }
}

}  // namespace horopter::tb
