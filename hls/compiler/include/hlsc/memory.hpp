// SPDX-License-Identifier: Apache-2.0
// Byte memory of bit vectors: what the symbolic execution loads from and stores to.
//
// A pointer is 64 bits: the object in the upper 16, the offset in bytes in the lower 48. A pointer chosen by a
// condition is then an ordinary multiplexer, and pointers can be stored, compared and subtracted like integers.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "hlsc/builder.hpp"
#include "hlsc/layout.hpp"
#include "hlsc/options.hpp"

namespace hlsc {

using ObjectId = std::uint32_t;
inline constexpr unsigned kOffsetBits = 48, kPointerBits = 64;

/// What all versions of an object have in common.
struct Object {
  std::string name;
  std::uint64_t size_bits = 0;
  bool constant = false;            ///< a table: writing is refused, variable reads become a Rom
  std::vector<ArrayMember> arrays;  ///< to bound variable offsets
  std::set<std::uint64_t> cuts;     ///< offsets where values begin: merged values are not glued together
};

/// The contents of all objects at one point of the program; copies share what they have in common.
class Contents {
 public:
  [[nodiscard]] const Bits& of(ObjectId object) const { return *versions_.at(object); }
  void set(ObjectId object, Bits bits);
  [[nodiscard]] bool has(ObjectId object) const { return versions_.contains(object); }
  [[nodiscard]] const std::map<ObjectId, std::shared_ptr<const Bits>>& versions() const { return versions_; }

 private:
  std::map<ObjectId, std::shared_ptr<const Bits>> versions_;
};

/// base + Σ index · scale, in bytes: how a variable offset came about.
struct AddressForm {
  struct Term {
    Bits index;  ///< 64 bits, signed
    std::int64_t scale = 1;
    std::optional<std::pair<std::int64_t, std::int64_t>> bounds;  ///< of the index, both included
  };
  std::int64_t base = 0;
  /// What `base` was when the first term was added. It tells the array; `base` may be outside of it. None: two ways to
  /// the same address began at different places. LLVM must add constants before variable indices, as it does; where
  /// it no longer did, the kernels LoadsAroundBegin and StoresAroundBegin would tell.
  std::optional<std::int64_t> start = 0;
  bool base_known = true;  ///< false: where the pointer started is part of the terms
  std::vector<Term> terms;
};

class Memory {
 public:
  Memory(Builder& builder, const Options& options, std::vector<Rom>& roms)
      : builder_(builder), options_(options), roms_(roms), objects_(1) {}

  ObjectId add_object(Object object);
  [[nodiscard]] Object& object(ObjectId id) { return objects_[id]; }
  [[nodiscard]] std::size_t size() const { return objects_.size(); }

  static Bits pointer(ObjectId object, std::uint64_t offset = 0);
  /// `pointer` moved by `form` (whose base and terms are relative to it).
  Bits move(const Bits& pointer, const AddressForm& form);
  /// The object and byte offset, if both are known.
  static std::optional<std::pair<ObjectId, std::uint64_t>> known(const Bits& pointer);

  Bits load(const Contents& contents, const Bits& pointer, std::uint64_t bits);
  void store(Contents& contents, const Bits& pointer, const Bits& value);
  /// For a copy of `bytes`: the values begin at the same places in the copy.
  void copy_cuts(const Bits& to, const Bits& from, std::uint64_t bytes);

 private:
  struct Target {
    ObjectId object = 0;
    Bit selected = kOne;
  };
  std::vector<Target> targets(const Bits& pointer);
  AddressForm form_of(const Bits& pointer, const Object& object);
  /// Values a term's index can have; `inside`: if the access stays inside the object.
  std::vector<std::int64_t> choices(const AddressForm& form, std::size_t term, std::int64_t base, const Object& object,
                                    std::uint64_t bytes, bool inside = true);
  Bits load_term(const Bits& contents, const AddressForm& form, std::size_t term, std::int64_t base,
                 const Object& object, std::uint64_t bits);
  void store_term(Bits& contents, const AddressForm& form, std::size_t term, std::int64_t base, Object& object,
                  const Bits& value, Bit selected);
  Bits load_object(const Contents& contents, ObjectId id, const Bits& pointer, std::uint64_t bits);
  std::optional<Bits> load_rom(const Bits& contents, const AddressForm& form, ObjectId id, std::uint64_t bits);
  Bits select(const Bits& index, std::vector<std::pair<std::int64_t, Bits>> values, int bit);
  void limit(const Object& object, std::size_t places, std::uint64_t bits) const;

  Builder& builder_;
  const Options& options_;
  std::vector<Rom>& roms_;
  std::vector<Object> objects_;
  std::map<Bits, AddressForm> forms_;  ///< by pointer
  std::map<std::pair<ObjectId, std::vector<std::uint64_t>>, std::uint32_t> rom_of_;
};

}  // namespace hlsc
