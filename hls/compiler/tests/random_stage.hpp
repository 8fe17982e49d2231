// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace hlsc::test {

/// A header with a class `random_stage::Stage` that is free of undefined behaviour and uses what hlsc supports:
/// branches, loops, switches, arrays, structures, pointers, memories, tables. The same seed gives the same text.
/// `schedulable`: without the memory that is accessed at will, which no pipeline can follow.
std::string random_stage(std::uint64_t seed, bool schedulable = false);

}  // namespace hlsc::test
