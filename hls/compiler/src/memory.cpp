// SPDX-License-Identifier: Apache-2.0
#include "hlsc/memory.hpp"

#include <algorithm>

#include "hlsc/diagnostics.hpp"

namespace hlsc {

namespace {

constexpr std::size_t kMostChoices = 1U << 16;

Bits offset_of(const Bits& pointer) { return Builder::slice(pointer, 0, kOffsetBits); }

std::int64_t constant_offset(const Bits& offset) {
  const std::uint64_t raw = Builder::value_of(offset) << (64 - kOffsetBits);
  return static_cast<std::int64_t>(raw) >> (64 - kOffsetBits);
}

/// Can `index` have this value, as far as its constant bits tell?
bool possible(const Bits& index, std::int64_t value) {
  for (std::size_t i = 0; i < index.size(); ++i) {
    const bool bit = ((value >> std::min<std::size_t>(i, 63)) & 1) != 0;
    if (index[i].node == 0 && (index[i] == kOne) != bit) return false;
  }
  return true;
}

std::int64_t floor_div(std::int64_t a, std::int64_t b) { return a / b - ((a % b != 0 && (a < 0) != (b < 0)) ? 1 : 0); }

/// Smallest and largest value as a signed number, from constant and repeated upper bits.
std::pair<std::int64_t, std::int64_t> range(const Bits& index) {
  std::size_t n = std::min<std::size_t>(index.size(), 64);
  if (index[n - 1] == kZero) {
    while (n > 0 && index[n - 1] == kZero) --n;
    return {0, static_cast<std::int64_t>((std::uint64_t{1} << n) - 1)};
  }
  while (n > 1 && index[n - 1] == index[n - 2]) --n;
  const std::int64_t half = n >= 64 ? INT64_MAX : (std::int64_t{1} << (n - 1));
  return {-half, half - 1};
}

}  // namespace

void Contents::set(ObjectId object, Bits bits) { versions_[object] = std::make_shared<const Bits>(std::move(bits)); }

ObjectId Memory::add_object(Object object) {
  objects_.push_back(std::move(object));
  if (objects_.size() >= (1U << (kPointerBits - kOffsetBits))) {
    throw CompileError(builder_.where, "more than 65535 objects in memory");
  }
  return static_cast<ObjectId>(objects_.size() - 1);
}

Bits Memory::pointer(ObjectId object, std::uint64_t offset) {
  Bits bits = Builder::constant(offset, kOffsetBits);
  const Bits id = Builder::constant(object, kPointerBits - kOffsetBits);
  bits.insert(bits.end(), id.begin(), id.end());
  return bits;
}

std::optional<std::pair<ObjectId, std::uint64_t>> Memory::known(const Bits& pointer) {
  if (!Builder::is_constant(pointer)) return std::nullopt;
  const std::uint64_t raw = Builder::value_of(pointer);
  return std::pair{static_cast<ObjectId>(raw >> kOffsetBits), raw & ((std::uint64_t{1} << kOffsetBits) - 1)};
}

Bits Memory::move(const Bits& pointer, const AddressForm& form) {
  const Bits start = offset_of(pointer);
  AddressForm total;
  if (Builder::is_constant(start)) {
    total.base = constant_offset(start);
  } else if (const auto found = forms_.find(pointer); found != forms_.end()) {
    total = found->second;
  } else {
    total.base_known = false;
    Bits index = Builder::zero_extend(start, 64);
    total.terms.push_back({index, 1, std::nullopt});
  }
  if (total.terms.empty() && form.start) total.start = total.base + *form.start;
  total.base += form.base;
  total.terms.insert(total.terms.end(), form.terms.begin(), form.terms.end());
  Bits sum = start;
  for (const AddressForm::Term& term : form.terms) {
    const Bits scaled = builder_.mul(Builder::slice(term.index, 0, kOffsetBits),
                                     Builder::constant(static_cast<std::uint64_t>(term.scale), kOffsetBits));
    sum = builder_.add(sum, scaled);
  }
  sum = builder_.add(sum, Builder::constant(static_cast<std::uint64_t>(form.base), kOffsetBits));
  Bits moved = sum;
  moved.insert(moved.end(), pointer.begin() + kOffsetBits, pointer.end());
  if (Builder::is_constant(sum)) return moved;
  const auto [place, added] = forms_.try_emplace(moved, total);
  if (!added) {
    // The same address by another way: what bounds one of them need not bound the other.
    AddressForm& stored = place->second;
    if (stored.start != total.start) stored.start.reset();
    bool same =
        stored.base == total.base && stored.base_known == total.base_known && stored.terms.size() == total.terms.size();
    for (std::size_t i = 0; same && i < stored.terms.size(); ++i) {
      same = stored.terms[i].index == total.terms[i].index && stored.terms[i].scale == total.terms[i].scale;
    }
    for (std::size_t i = 0; i < stored.terms.size(); ++i) {
      auto& bounds = stored.terms[i].bounds;
      if (!same || !bounds || !total.terms[i].bounds) {
        bounds.reset();
      } else {
        bounds = {std::min(bounds->first, total.terms[i].bounds->first),
                  std::max(bounds->second, total.terms[i].bounds->second)};
      }
    }
  }
  return moved;
}

std::vector<Memory::Target> Memory::targets(const Bits& pointer) {
  const Bits id = Builder::slice(pointer, kOffsetBits, kPointerBits - kOffsetBits);
  std::vector<Target> found;
  if (Builder::is_constant(id)) {
    const auto object = static_cast<ObjectId>(Builder::value_of(id));
    if (object == 0 || object >= objects_.size()) throw CompileError(builder_.where, "access through a null pointer");
    return {{object, kOne}};
  }
  for (const Bit bit : id) {
    if (builder_.is_undefined(bit)) throw CompileError(builder_.where, "access through an undefined pointer");
  }
  for (ObjectId object = 1; object < objects_.size(); ++object) {
    if (!possible(id, object)) continue;
    found.push_back({object, builder_.eq(id, Builder::constant(object, id.size()))});
  }
  if (found.empty()) throw CompileError(builder_.where, "access through a null pointer");
  return found;
}

AddressForm Memory::form_of(const Bits& pointer, const Object& object) {
  const Bits offset = offset_of(pointer);
  AddressForm form;
  if (const auto found = forms_.find(pointer); found != forms_.end()) {
    form = found->second;
  } else {
    form.base_known = false;
    // Its low constant zeros are the scale.
    std::size_t zeros = 0;
    while (zeros < offset.size() && offset[zeros] == kZero) ++zeros;
    Bits index = Builder::slice(offset, zeros, offset.size() - zeros);
    form.terms.push_back({Builder::zero_extend(index, 64), std::int64_t{1} << zeros, std::nullopt});
  }
  if (!form.base_known || !form.start) return form;
  const std::int64_t start = *form.start;
  // Pointer arithmetic stays inside the array it starts in: the outermost one, because C++ programs do walk through
  // the rows of a two-dimensional one.
  std::int64_t low = 0, high = 0, ends_here = start;
  for (const ArrayMember& array : object.arrays) {
    const auto first = static_cast<std::int64_t>(array.offset_bits / 8),
               size = static_cast<std::int64_t>(array.count * array.stride_bits / 8);
    if (first <= start && start < first + size && size > high - low) {
      low = first;
      high = first + size;
    }
    if (first + size == start) ends_here = std::min(ends_here, first);
  }
  if (high == low) return form;
  // Where one array ends and another begins, the pointer may be the end of the one.
  if (low == start) low = ends_here;
  for (AddressForm::Term& term : form.terms) {
    if (term.bounds || term.scale <= 0) continue;
    // With other terms beside it, one alone may reach further.
    const std::int64_t slack = form.terms.size() > 1 ? high - low - 1 : 0;
    term.bounds = {-floor_div(form.base - low + slack, term.scale),
                   floor_div(high - 1 - form.base + slack, term.scale)};
  }
  return form;
}

std::vector<std::int64_t> Memory::choices(const AddressForm& form, std::size_t term, std::int64_t base,
                                          const Object& object, std::uint64_t bytes, bool inside) {
  const AddressForm::Term& here = form.terms[term];
  auto [low, high] = range(here.index);
  if (here.bounds) {
    low = std::max(low, here.bounds->first);
    high = std::min(high, here.bounds->second);
  }
  if (inside && (term + 1 == form.terms.size() || !here.bounds)) {
    // The last index, or one without bounds of its own, is bounded by the object.
    const auto size = static_cast<std::int64_t>(object.size_bits / 8), last = size - static_cast<std::int64_t>(bytes);
    const std::int64_t reach = term + 1 == form.terms.size() ? 0 : size;
    std::int64_t first = -floor_div(base + reach, here.scale), final = floor_div(last + reach - base, here.scale);
    if (here.scale < 0) {
      first = -floor_div(last + reach - base, -here.scale);
      final = floor_div(base + reach, -here.scale);
    }
    low = std::max(low, first);
    high = std::min(high, final);
  }
  std::vector<std::int64_t> found;
  for (std::int64_t k = low; k <= high; ++k) {
    if (!possible(here.index, k)) continue;
    found.push_back(k);
    if (found.size() > kMostChoices) {
      throw CompileError(builder_.where, "`" + object.name + "` is indexed by a variable over more than " +
                                             std::to_string(kMostChoices) + " places");
    }
  }
  return found;
}

void Memory::limit(const Object& object, std::size_t places, std::uint64_t bits) const {
  if (object.constant || places * bits <= options_.largest_indexed_array_bits) return;
  throw CompileError(builder_.where,
                     "array of " + std::to_string(places * bits) + " bits in `" + object.name +
                         "` is indexed by a variable: plain arrays become registers and multiplexers, at most " +
                         std::to_string(options_.largest_indexed_array_bits) + " bits; use horopter::hls::RAM");
}

Bits Memory::select(const Bits& index, std::vector<std::pair<std::int64_t, Bits>> values, int bit) {
  // Bits in which all remaining values agree need no multiplexer: another value of the bit would be out of bounds.
  if (values.size() == 1 || bit < 0) return values.front().second;
  std::vector<std::pair<std::int64_t, Bits>> ones, zeros;
  for (auto& value : values) (((value.first >> bit) & 1) != 0 ? ones : zeros).push_back(std::move(value));
  if (ones.empty()) return select(index, std::move(zeros), bit - 1);
  if (zeros.empty()) return select(index, std::move(ones), bit - 1);
  const Bits high = select(index, std::move(ones), bit - 1), low = select(index, std::move(zeros), bit - 1);
  return builder_.mux(index[static_cast<std::size_t>(bit)], high, low);
}

Bits Memory::load_term(const Bits& contents, const AddressForm& form, std::size_t term, std::int64_t base,
                       const Object& object, std::uint64_t bits) {
  const std::uint64_t bytes = (bits + 7) / 8;
  if (term == form.terms.size()) {
    if (base < 0 || static_cast<std::uint64_t>(base) + bytes > object.size_bits / 8) {
      return builder_.undefined(static_cast<std::uint32_t>(bits), "a value outside `" + object.name + "`");
    }
    return Builder::slice(contents, static_cast<std::size_t>(base) * 8, bits);
  }
  const std::vector<std::int64_t> ks = choices(form, term, base, object, bytes);
  limit(object, ks.size(), bits);
  if (ks.empty()) return builder_.undefined(static_cast<std::uint32_t>(bits), "a value outside `" + object.name + "`");
  std::vector<std::pair<std::int64_t, Bits>> values;
  for (const std::int64_t k : ks) {
    values.emplace_back(k, load_term(contents, form, term + 1, base + k * form.terms[term].scale, object, bits));
  }
  return select(form.terms[term].index, std::move(values), 63);
}

std::optional<Bits> Memory::load_rom(const Bits& contents, const AddressForm& form, ObjectId id, std::uint64_t bits) {
  const Object& object = objects_[id];
  const std::uint64_t bytes = (bits + 7) / 8;
  struct Axis {
    std::int64_t first = 0, scale = 1;
    unsigned width = 0;
  };
  std::vector<Axis> axes;
  Bits address;
  unsigned total = 0;
  std::vector<std::uint64_t> key{bits, static_cast<std::uint64_t>(form.base)};
  for (std::size_t i = form.terms.size(); i-- > 0;) {
    const bool single = form.terms.size() == 1;
    if (!single && !form.terms[i].bounds) return std::nullopt;
    const std::vector<std::int64_t> ks = choices(form, i, form.base, object, bytes, single);
    if (ks.empty()) return std::nullopt;
    Axis axis;
    axis.first = std::min<std::int64_t>(0, ks.front());
    axis.scale = form.terms[i].scale;
    while ((std::int64_t{1} << axis.width) <= ks.back() - axis.first) ++axis.width;
    const Bits shifted =
        builder_.sub(form.terms[i].index, Builder::constant(static_cast<std::uint64_t>(axis.first), 64));
    for (unsigned bit = 0; bit < axis.width; ++bit) address.push_back(shifted[bit]);
    total += axis.width;
    key.insert(key.end(), {static_cast<std::uint64_t>(axis.first), static_cast<std::uint64_t>(axis.scale), axis.width});
    axes.push_back(axis);
  }
  if (total < 4 || total > 16) return std::nullopt;  // small ones are better as logic
  auto found = rom_of_.find({id, key});
  if (found == rom_of_.end()) {
    Rom rom;
    rom.name = object.name;
    rom.width = static_cast<std::uint32_t>(bits);
    std::size_t used = 0;
    for (std::size_t word = 0; word < (std::size_t{1} << total); ++word) {
      std::int64_t offset = form.base;
      std::size_t rest = word;
      for (const Axis& axis : axes) {
        offset += (static_cast<std::int64_t>(rest & ((std::size_t{1} << axis.width) - 1)) + axis.first) * axis.scale;
        rest >>= axis.width;
      }
      std::vector<bool> value(bits, false);
      if (offset >= 0 && static_cast<std::uint64_t>(offset) + bytes <= object.size_bits / 8) {
        for (std::uint64_t i = 0; i < bits; ++i) {
          const Bit bit = contents[static_cast<std::size_t>(offset) * 8 + i];
          if (bit.node != 0) return std::nullopt;
          value[i] = bit == kOne;
        }
        used = word + 1;
      }
      rom.words.push_back(std::move(value));
    }
    rom.words.resize(used);
    found = rom_of_.try_emplace({id, key}, static_cast<std::uint32_t>(roms_.size())).first;
    roms_.push_back(std::move(rom));
  }
  return builder_.rom(found->second, address, static_cast<std::uint32_t>(bits));
}

Bits Memory::load_object(const Contents& contents, ObjectId id, const Bits& pointer, std::uint64_t bits) {
  const Bits offset = offset_of(pointer);
  const Object& object = objects_[id];
  if (!contents.has(id)) throw CompileError(builder_.where, "`" + object.name + "` does not exist here");
  AddressForm form;
  if (Builder::is_constant(offset)) {
    form.base = constant_offset(offset);
  } else {
    form = form_of(pointer, object);
    if (object.constant) {
      if (const auto value = load_rom(contents.of(id), form, id, bits)) return *value;
    }
  }
  return load_term(contents.of(id), form, 0, form.base, object, bits);
}

Bits Memory::load(const Contents& contents, const Bits& pointer, std::uint64_t bits) {
  const std::vector<Target> places = targets(pointer);
  Bits value;
  for (const Target& target : places) {
    if (!contents.has(target.object) && places.size() > 1) continue;
    const Bits here = load_object(contents, target.object, pointer, bits);
    value = value.empty() ? here : builder_.mux(target.selected, here, value);
  }
  if (value.empty()) throw CompileError(builder_.where, "access through an undefined pointer");
  return value;
}

void Memory::store_term(Bits& contents, const AddressForm& form, std::size_t term, std::int64_t base, Object& object,
                        const Bits& value, Bit selected) {
  const std::uint64_t bytes = (value.size() + 7) / 8;
  if (term == form.terms.size()) {
    if (base < 0 || static_cast<std::uint64_t>(base) + bytes > object.size_bits / 8) return;
    const std::size_t low = static_cast<std::size_t>(base) * 8;
    object.cuts.insert(low);
    object.cuts.insert(low + bytes * 8);
    const Bits old = Builder::slice(contents, low, value.size());
    const Bits made = builder_.mux(selected, value, old);
    std::copy(made.begin(), made.end(), contents.begin() + static_cast<std::ptrdiff_t>(low));
    return;
  }
  const std::vector<std::int64_t> ks = choices(form, term, base, object, bytes);
  limit(object, ks.size(), value.size());
  // Only the bits in which the choices differ need to be compared.
  const Bits& index = form.terms[term].index;
  std::vector<std::size_t> deciding;
  for (std::size_t bit = 0; bit < 64; ++bit) {
    bool differ = false;
    for (const std::int64_t k : ks) differ |= ((k ^ ks.front()) >> bit & 1) != 0;
    if (differ) deciding.push_back(bit);
  }
  for (const std::int64_t k : ks) {
    Bits left, right;
    for (const std::size_t bit : deciding) {
      left.push_back(index[bit]);
      right.push_back(((k >> bit) & 1) != 0 ? kOne : kZero);
    }
    const Bit here = builder_.bit_and(selected, builder_.eq(left, right));
    store_term(contents, form, term + 1, base + k * form.terms[term].scale, object, value, here);
  }
}

void Memory::store(Contents& contents, const Bits& pointer, const Bits& value) {
  const Bits offset = offset_of(pointer);
  const std::vector<Target> places = targets(pointer);
  for (const Target& target : places) {
    Object& object = objects_[target.object];
    if (!contents.has(target.object)) {
      if (places.size() > 1) continue;
      throw CompileError(builder_.where, "`" + object.name + "` does not exist here");
    }
    if (object.constant) {
      if (places.size() > 1) continue;
      throw CompileError(builder_.where, "write to the constant `" + object.name + "`");
    }
    AddressForm form;
    if (Builder::is_constant(offset)) {
      form.base = constant_offset(offset);
    } else {
      form = form_of(pointer, object);
    }
    Bits bits = contents.of(target.object);
    store_term(bits, form, 0, form.base, object, value, target.selected);
    contents.set(target.object, std::move(bits));
  }
}

void Memory::copy_cuts(const Bits& to, const Bits& from, std::uint64_t bytes) {
  const auto a = known(to), b = known(from);
  if (!a || !b) return;
  const std::set<std::uint64_t>& cuts = objects_[b->first].cuts;
  std::vector<std::uint64_t> copied;
  for (auto cut = cuts.lower_bound(b->second * 8); cut != cuts.end() && *cut <= (b->second + bytes) * 8; ++cut) {
    copied.push_back(*cut - b->second * 8 + a->second * 8);
  }
  objects_[a->first].cuts.insert(copied.begin(), copied.end());
}

}  // namespace hlsc
