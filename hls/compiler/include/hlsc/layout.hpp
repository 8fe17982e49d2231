// SPDX-License-Identifier: Apache-2.0
// Where the values of a C++ class lie in memory, from its debug information: the leaves (u<N>, s<N>, built-in integers)
// with their names by path, the memories (RAM<>) and the arrays.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hlsc/graph.hpp"

namespace llvm {
class DIType;
}

namespace hlsc {

struct Leaf {
  std::string name;                ///< path joined by `_`
  std::uint64_t offset_bits = 0;   ///< from the start of the object
  std::uint32_t storage_bits = 0;  ///< of which the low `width` count, zero- or sign-extended
  std::uint32_t width = 0;
  bool is_signed = false;
  bool is_pointer = false;  ///< allowed in stages only
  SourceLocation where;
  bool kept = false;  ///< within a Kept<>: reset leaves it as it is
};

struct RamMember;

struct ArrayMember {
  std::string name;
  std::uint64_t offset_bits = 0, stride_bits = 0, count = 0;
};

struct Layout {
  std::uint64_t size_bits = 0;
  std::string type_name;
  std::vector<Leaf> leaves;
  std::vector<RamMember> rams;
  std::vector<ArrayMember> arrays;
};

struct RamMember {
  std::string name;
  std::uint64_t offset_bits = 0, depth = 0, distance = 0;
  Layout word;
  SourceLocation where;
};

/// Throws CompileError for what has no hardware: floating point, unions, virtual functions, volatile members.
/// `role` names the class in messages: "In", "Out", "Config", "the stage".
Layout layout_of(const llvm::DIType* type, const std::string& role);

/// As a path relative to nothing: the file as the compiler was given it.
SourceLocation location_of(const llvm::DIType* type);

}  // namespace hlsc
