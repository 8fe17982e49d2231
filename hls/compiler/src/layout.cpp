// SPDX-License-Identifier: Apache-2.0
#include "hlsc/layout.hpp"

#include <llvm/BinaryFormat/Dwarf.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/DebugInfoMetadata.h>

#include <map>

#include "hlsc/diagnostics.hpp"

namespace hlsc {

namespace {

using llvm::DIBasicType;
using llvm::DICompositeType;
using llvm::DIDerivedType;
using llvm::DIType;

bool in_namespace(const llvm::DIScope* scope, llvm::StringRef name) {
  while (scope != nullptr) {
    const auto* space = llvm::dyn_cast<llvm::DINamespace>(scope);
    if (space == nullptr) return false;
    if (space->getName() == name) return true;
    scope = space->getScope();
  }
  return false;
}

std::int64_t template_value(const DICompositeType* type, unsigned index) {
  const auto parameters = type->getTemplateParams();
  if (index >= parameters.size()) return -1;
  const auto* value = llvm::dyn_cast<llvm::DITemplateValueParameter>(parameters[index]);
  if (value == nullptr) return -1;
  const auto* constant = llvm::dyn_cast_or_null<llvm::ConstantAsMetadata>(value->getValue());
  if (constant == nullptr) return -1;
  const auto* integer = llvm::dyn_cast<llvm::ConstantInt>(constant->getValue());
  return integer == nullptr ? -1 : integer->getSExtValue();
}

class Flattener {
 public:
  Flattener(Layout& layout, std::string role) : layout_(layout), role_(std::move(role)) {}

  void flatten(const DIType* type, std::uint64_t offset, const std::string& path, SourceLocation where) {
    type = strip(type, path, where);
    if (const auto* basic = llvm::dyn_cast<DIBasicType>(type)) {
      add_basic(basic, offset, basic->getSizeInBits(), path, where);
    } else if (const auto* composite = llvm::dyn_cast<DICompositeType>(type)) {
      add_composite(composite, offset, path, where);
    } else if (const auto* derived = llvm::dyn_cast<DIDerivedType>(type)) {
      Leaf leaf{path, offset, static_cast<std::uint32_t>(derived->getSizeInBits()), 0, false, true, where};
      if (leaf.storage_bits == 0) leaf.storage_bits = 64;
      leaf.width = leaf.storage_bits;
      add_leaf(leaf);
    } else {
      refuse(where, path, "is of a kind of type that has no hardware");
    }
  }

 private:
  [[noreturn]] void refuse(const SourceLocation& where, const std::string& path, const std::string& why) const {
    throw CompileError(where,
                       (path.empty() ? "an unnamed member" : "member `" + path + "`") + " of " + role_ + " " + why);
  }

  const DIType* strip(const DIType* type, const std::string& path, SourceLocation& where) const {
    for (;;) {
      if (type == nullptr) refuse(where, path, "has no type in the debug information");
      const auto* derived = llvm::dyn_cast<DIDerivedType>(type);
      if (derived == nullptr) return type;
      switch (derived->getTag()) {
        case llvm::dwarf::DW_TAG_typedef:
        case llvm::dwarf::DW_TAG_const_type:
          type = derived->getBaseType();
          break;
        case llvm::dwarf::DW_TAG_volatile_type:
          refuse(where, path, "is volatile");
        case llvm::dwarf::DW_TAG_atomic_type:
          refuse(where, path, "is atomic");
        default:
          return type;
      }
    }
  }

  void add_leaf(Leaf leaf) {
    if (leaf.name.empty()) leaf.name = "value";
    leaf.kept = kept_ > 0;
    int& uses = names_[leaf.name];
    if (uses++ > 0) refuse(leaf.where, leaf.name, "has the same flattened name as another one");
    layout_.leaves.push_back(std::move(leaf));
  }

  void add_basic(const DIBasicType* type, std::uint64_t offset, std::uint64_t bits, const std::string& path,
                 const SourceLocation& where) {
    Leaf leaf{path, offset, static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits), false, false, where};
    switch (type->getEncoding()) {
      case llvm::dwarf::DW_ATE_boolean:
        leaf.width = 1;
        break;
      case llvm::dwarf::DW_ATE_signed:
      case llvm::dwarf::DW_ATE_signed_char:
        leaf.is_signed = true;
        break;
      case llvm::dwarf::DW_ATE_unsigned:
      case llvm::dwarf::DW_ATE_unsigned_char:
      case llvm::dwarf::DW_ATE_UTF:
        break;
      case llvm::dwarf::DW_ATE_float:
      case llvm::dwarf::DW_ATE_complex_float:
        refuse(where, path, "is floating point (" + type->getName().str() + "): use fixed point");
      default:
        refuse(where, path, "is of type " + type->getName().str() + ", which has no hardware");
    }
    add_leaf(leaf);
  }

  void add_composite(const DICompositeType* type, std::uint64_t offset, const std::string& path,
                     const SourceLocation& where) {
    switch (type->getTag()) {
      case llvm::dwarf::DW_TAG_array_type:
        add_array(type, offset, path, where);
        return;
      case llvm::dwarf::DW_TAG_enumeration_type: {
        SourceLocation place = where;
        const auto* base = llvm::dyn_cast<DIBasicType>(strip(type->getBaseType(), path, place));
        if (base == nullptr) refuse(where, path, "is an enumeration without a plain underlying type");
        add_basic(base, offset, type->getSizeInBits(), path, where);
        return;
      }
      case llvm::dwarf::DW_TAG_union_type:
        refuse(where, path, "is a union");
      case llvm::dwarf::DW_TAG_structure_type:
      case llvm::dwarf::DW_TAG_class_type:
        break;
      default:
        refuse(where, path, "is of a kind of type that has no hardware");
    }
    if (type->isForwardDecl()) refuse(where, path, "is of the incomplete type " + type->getName().str());
    const llvm::StringRef name = type->getName();
    if (in_namespace(type->getScope(), "hls")) {
      if (name.starts_with("u<") || name.starts_with("s<")) {
        const std::int64_t width = template_value(type, 0);
        if (width < 1 || static_cast<std::uint64_t>(width) > type->getSizeInBits()) {
          refuse(where, path, "is of the malformed type " + name.str());
        }
        add_leaf({path, offset, static_cast<std::uint32_t>(type->getSizeInBits()), static_cast<std::uint32_t>(width),
                  name.starts_with("s<"), false, where});
        return;
      }
      if (name.starts_with("RAM<")) {
        add_ram(type, offset, path, where);
        return;
      }
    }
    const bool is_kept = name.starts_with("Kept<") && in_namespace(type->getScope(), "hls");
    kept_ += is_kept ? 1 : 0;
    add_members(type, offset, path, where,
                is_kept || (name.starts_with("array<") && in_namespace(type->getScope(), "std")));
    kept_ -= is_kept ? 1 : 0;
  }

  /// `transparent`: the members' names are not part of the path.
  void add_members(const DICompositeType* type, std::uint64_t offset, const std::string& path,
                   const SourceLocation& where, bool transparent) {
    const llvm::StringRef name = type->getName();
    for (const llvm::DINode* node : type->getElements()) {
      const auto* member = llvm::dyn_cast<DIDerivedType>(node);
      if (member == nullptr || member->isStaticMember()) continue;
      const SourceLocation place = member->getName().empty() || transparent ? where : location_of(member);
      if (member->getTag() == llvm::dwarf::DW_TAG_inheritance) {
        if (member->isVirtual()) refuse(where, path.empty() ? name.str() : path, "has a virtual base class");
        flatten(member->getBaseType(), offset + member->getOffsetInBits(), path, place);
        continue;
      }
      if (member->getTag() != llvm::dwarf::DW_TAG_member) continue;
      std::string member_name = member->getName().str();
      if (llvm::StringRef(member_name).starts_with("_vptr")) {
        throw CompileError(location_of(type),
                           "class " + name.str() + " has virtual functions: calls must be known at compile time");
      }
      while (!member_name.empty() && member_name.back() == '_') member_name.pop_back();
      std::string inner = path;
      if (!transparent && !member_name.empty()) inner = path.empty() ? member_name : path + "_" + member_name;
      if (member->isBitField()) {
        SourceLocation bit_place = place;
        const DIType* base = strip(member->getBaseType(), inner, bit_place);
        if (const auto* composite = llvm::dyn_cast<DICompositeType>(base)) {
          base = strip(composite->getBaseType(), inner, bit_place);
        }
        const auto* basic = llvm::dyn_cast<DIBasicType>(base);
        if (basic == nullptr) refuse(place, inner, "is a bit field of a type that has no hardware");
        add_basic(basic, offset + member->getOffsetInBits(), member->getSizeInBits(), inner, place);
        continue;
      }
      flatten(member->getBaseType(), offset + member->getOffsetInBits(), inner, place);
    }
  }

  void add_array(const DICompositeType* type, std::uint64_t offset, const std::string& path,
                 const SourceLocation& where) {
    SourceLocation place = where;
    std::vector<std::uint64_t> counts;
    for (const llvm::DINode* node : type->getElements()) {
      const auto* range = llvm::dyn_cast<llvm::DISubrange>(node);
      const auto count = range == nullptr ? llvm::DISubrange::BoundType() : range->getCount();
      const auto* integer = count.isNull() ? nullptr : llvm::dyn_cast<llvm::ConstantInt*>(count);
      if (integer == nullptr) refuse(where, path, "is an array of unknown size");
      counts.push_back(integer->getZExtValue());
    }
    const DIType* element = strip(type->getBaseType(), path, place);
    add_dimension(element, counts, 0, type->getSizeInBits(), offset, path, where);
  }

  void add_dimension(const DIType* element, const std::vector<std::uint64_t>& counts, std::size_t dimension,
                     std::uint64_t size, std::uint64_t offset, const std::string& path, const SourceLocation& where) {
    if (dimension == counts.size()) {
      flatten(element, offset, path, where);
      return;
    }
    const std::uint64_t count = counts[dimension];
    if (count == 0) return;
    const std::uint64_t stride = size / count;
    layout_.arrays.push_back({path, offset, stride, count});
    if (layout_.leaves.size() + count > kMostLeaves) {
      refuse(where, path, "is an array of " + std::to_string(count) + " elements: too large for registers, use RAM<>");
    }
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::string inner = path.empty() ? std::to_string(i) : path + "_" + std::to_string(i);
      add_dimension(element, counts, dimension + 1, stride, offset + i * stride, inner, where);
    }
  }

  void add_ram(const DICompositeType* type, std::uint64_t offset, const std::string& path,
               const SourceLocation& where) {
    RamMember ram;
    ram.name = path;
    ram.offset_bits = offset;
    ram.where = where;
    const auto parameters = type->getTemplateParams();
    const auto* word = parameters.size() == 3 ? llvm::dyn_cast<llvm::DITemplateTypeParameter>(parameters[0]) : nullptr;
    const std::int64_t depth = template_value(type, 1), distance = template_value(type, 2);
    if (word == nullptr || depth < 1 || distance < 1) refuse(where, path, "is a RAM<> of a form hlsc does not know");
    ram.depth = static_cast<std::uint64_t>(depth);
    ram.distance = static_cast<std::uint64_t>(distance);
    ram.word = layout_of(word->getType(), "the word of memory `" + path + "`");
    layout_.rams.push_back(std::move(ram));
  }

  static constexpr std::size_t kMostLeaves = 65536;

  Layout& layout_;
  std::string role_;
  std::map<std::string, int> names_;
  int kept_ = 0;  // Kept<> around the current member
};

}  // namespace

SourceLocation location_of(const DIType* type) {
  SourceLocation where;
  if (type != nullptr && type->getFile() != nullptr) where.file = tidy_path(type->getFile()->getFilename().str());
  if (type != nullptr) where.line = type->getLine();
  return where;
}

Layout layout_of(const DIType* type, const std::string& role) {
  Layout layout;
  layout.type_name = type->getName().str();
  layout.size_bits = type->getSizeInBits();
  const DIType* named = type;
  while (const auto* derived = llvm::dyn_cast<DIDerivedType>(named)) {
    if (derived->getBaseType() == nullptr || derived->getTag() == llvm::dwarf::DW_TAG_pointer_type) break;
    named = derived->getBaseType();
  }
  if (layout.size_bits == 0) layout.size_bits = named->getSizeInBits();
  Flattener(layout, role).flatten(type, 0, "", location_of(named));
  for (const Leaf& leaf : layout.leaves) {
    if (leaf.is_pointer && role != "the stage") {
      throw CompileError(leaf.where, "member `" + leaf.name + "` of " + role + " is a pointer or reference");
    }
  }
  return layout;
}

}  // namespace hlsc
