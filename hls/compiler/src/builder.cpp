// SPDX-License-Identifier: Apache-2.0
#include "hlsc/builder.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <map>

namespace hlsc {

namespace {

std::size_t hash_of(const Node& node) {
  std::size_t hash = 1469598103934665603ULL;
  const auto mix = [&](std::size_t value) { hash = (hash ^ value) * 1099511628211ULL; };
  mix(static_cast<std::size_t>(node.op));
  mix(node.width);
  mix(node.port);
  for (const Bits& operand : node.operands) {
    mix(operand.size());
    for (const Bit bit : operand) mix((static_cast<std::size_t>(bit.node) << 16) + bit.index);
  }
  return hash;
}

/// Bits that remain when constant zeros at the top are dropped.
std::size_t unsigned_length(const Bits& a) {
  std::size_t n = a.size();
  while (n > 0 && a[n - 1] == kZero) --n;
  return n;
}

/// Bits that remain when copies of the sign are dropped; at least one.
std::size_t signed_length(const Bits& a) {
  std::size_t n = a.size();
  while (n > 1 && a[n - 1] == a[n - 2]) --n;
  return n;
}

constexpr std::uint64_t kUnbounded = ~std::uint64_t{0};
constexpr std::uint64_t kLargestBound = (std::uint64_t{1} << 62) - 1;

std::uint64_t mask_of(std::size_t width) { return width > 62 ? kUnbounded : (std::uint64_t{1} << width) - 1; }

std::uint64_t bounded_sum(std::uint64_t a, std::uint64_t b) {
  return a <= kLargestBound && b <= kLargestBound && a + b <= kLargestBound ? a + b : kUnbounded;
}

std::uint64_t bounded_product(std::uint64_t a, std::uint64_t b) {
  if (a == 0 || b == 0) return 0;
  return a <= kLargestBound && b <= kLargestBound / a ? a * b : kUnbounded;
}

bool top_is_zero(const Bits& a) { return a.back() == kZero; }

Bit constant_bit(bool value) { return value ? kOne : kZero; }

Bits add_constants(const Bits& a, const Bits& b, bool carry) {
  Bits sum(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int total = (a[i] == kOne) + (b[i] == kOne) + carry;
    sum[i] = constant_bit((total & 1) != 0);
    carry = total > 1;
  }
  return sum;
}

Bits invert_constant(Bits a) {
  for (Bit& bit : a) bit = constant_bit(bit != kOne);
  return a;
}

void append(Bits& to, const Bits& from) { to.insert(to.end(), from.begin(), from.end()); }

}  // namespace

Builder::Builder() {
  Node constant;
  constant.op = Op::kConstant;
  constant.width = 2;
  nodes_.push_back(constant);
  bounds_.push_back(kUnbounded);
}

bool Builder::is_constant(const Bits& bits) {
  return std::all_of(bits.begin(), bits.end(), [](Bit bit) { return bit.node == 0; });
}

std::uint64_t Builder::value_of(const Bits& bits) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bits.size() && i < 64; ++i) value |= std::uint64_t{bits[i] == kOne} << i;
  return value;
}

bool Builder::is_undefined(Bit bit) const {
  const Node& node = nodes_[bit.node];
  return node.op == Op::kInput && node.port == kUndefinedPort;
}

Bits Builder::zero_extend(Bits a, std::size_t width) {
  a.resize(width, kZero);
  return a;
}

Bits Builder::sign_extend(Bits a, std::size_t width) {
  const Bit sign = a.back();
  a.resize(width, sign);
  return a;
}

Bits Builder::slice(const Bits& a, std::size_t low, std::size_t width) {
  return {a.begin() + static_cast<std::ptrdiff_t>(low), a.begin() + static_cast<std::ptrdiff_t>(low + width)};
}

Bits Builder::constant(std::uint64_t value, std::size_t width) {
  Bits bits(width);
  for (std::size_t i = 0; i < width; ++i) bits[i] = constant_bit(i < 64 && ((value >> i) & 1) != 0);
  return bits;
}

Bits Builder::constant(const std::vector<bool>& value) {
  Bits bits(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) bits[i] = constant_bit(value[i]);
  return bits;
}

void Builder::name(const Bits& bits, const std::string& name) {
  NodeId node = 0;
  for (const Bit bit : bits) {
    if (bit.node == 0) continue;
    if (node != 0 && bit.node != node) return;
    node = bit.node;
  }
  if (node == 0 || !nodes_[node].name.empty()) return;
  nodes_[node].name = name;
}

Bits Builder::make(Op op, std::uint32_t width, std::vector<Bits> operands, std::uint32_t port) {
  Node node;
  node.op = op;
  node.width = width;
  node.operands = std::move(operands);
  node.port = port;
  std::vector<NodeId>& bucket = table_[hash_of(node)];
  NodeId id = 0;
  for (const NodeId candidate : bucket) {
    const Node& other = nodes_[candidate];
    if (other.op == op && other.width == width && other.port == port && other.operands == node.operands) {
      id = candidate;
      break;
    }
  }
  if (id == 0) {
    id = static_cast<NodeId>(nodes_.size());
    node.where = where;
    bounds_.push_back(bound_of(node));
    nodes_.push_back(std::move(node));
    bucket.push_back(id);
  }
  Bits bits(width);
  const std::uint64_t most = bounds_[id];
  for (std::uint32_t i = 0; i < width; ++i) bits[i] = most != kUnbounded && (most >> i) == 0 ? kZero : Bit{id, i};
  return bits;
}

std::uint64_t Builder::bound(const Bits& a) const {
  if (unsigned_length(a) > 62) return kUnbounded;
  std::uint64_t total = 0;
  for (std::size_t low = 0; low < a.size();) {
    if (a[low].node == 0) {
      if (a[low] == kOne) total += std::uint64_t{1} << low;
      ++low;
      continue;
    }
    std::size_t high = low + 1;
    while (high < a.size() && a[high].node == a[low].node && a[high].index == a[high - 1].index + 1) ++high;
    std::uint64_t most = mask_of(high - low);
    const Node& node = nodes_[a[low].node];
    // A run up to the top of a node inherits its bound.
    if (a[high - 1].index + 1 == node.width && bounds_[a[low].node] != kUnbounded) {
      most = std::min(most, bounds_[a[low].node] >> a[low].index);
    }
    total += most << low;
    low = high;
  }
  return total;
}

std::uint64_t Builder::bound_of(const Node& node) const {
  const std::uint64_t mask = mask_of(node.width);
  const auto operand = [&](std::size_t i) { return bound(node.operands[i]); };
  switch (node.op) {
    case Op::kAdd: {
      const std::uint64_t sum = bounded_sum(operand(0), operand(1));
      return sum <= mask ? sum : mask;
    }
    case Op::kMul: {
      const std::uint64_t product = bounded_product(operand(0), operand(1));
      return product <= mask ? product : mask;
    }
    case Op::kMux:
      return std::min(mask, std::max(operand(1), operand(2)));
    case Op::kAnd:
      return std::min({mask, operand(0), operand(1)});
    default:
      return mask;
  }
}

Bits Builder::source(Op op, std::uint32_t port, std::uint32_t width, const std::string& name) {
  Bits bits = make(op, width, {}, port);
  if (!bits.empty()) nodes_[bits[0].node].name = name;
  return bits;
}

Bits Builder::nothing(std::uint32_t port, std::uint32_t width, const std::string& what) {
  Node node;
  node.op = Op::kInput;
  node.port = port;
  node.width = width;
  node.name = what;
  node.where = where;
  const auto id = static_cast<NodeId>(nodes_.size());
  nodes_.push_back(std::move(node));
  bounds_.push_back(kUnbounded);
  Bits bits(width);
  for (std::uint32_t i = 0; i < width; ++i) bits[i] = {id, i};
  return bits;
}

Bits Builder::rom(std::uint32_t port, const Bits& address, std::uint32_t width) {
  return make(Op::kRom, width, {address}, port);
}

bool Builder::complementary(Bit a, Bit b) const {
  if (a.node == 0 && b.node == 0) return a != b;
  const Node& na = nodes_[a.node];
  if (na.op == Op::kNot && na.operands[0][a.index] == b) return true;
  const Node& nb = nodes_[b.node];
  return nb.op == Op::kNot && nb.operands[0][b.index] == a;
}

Bits Builder::bit_not(const Bits& a) {
  Bits result(a.size());
  Bits operand;
  std::vector<std::size_t> place(a.size(), 0);
  std::map<Bit, std::size_t> known;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Node& node = nodes_[a[i].node];
    if (a[i].node == 0) {
      result[i] = constant_bit(a[i] != kOne);
    } else if (node.op == Op::kNot) {
      result[i] = node.operands[0][a[i].index];
    } else {
      const auto [found, added] = known.try_emplace(a[i], operand.size());
      if (added) operand.push_back(a[i]);
      place[i] = found->second + 1;
    }
  }
  if (operand.empty()) return result;
  const Bits made = make(Op::kNot, static_cast<std::uint32_t>(operand.size()), {operand});
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (place[i] != 0) result[i] = made[place[i] - 1];
  }
  return result;
}

bool Builder::simplify_bit(Op op, Bit a, Bit b, Bit& result) const {
  if (a.node != 0 && b.node == 0) std::swap(a, b);
  // Now a is constant if any is.
  switch (op) {
    case Op::kAnd:
      if (a == kZero || complementary(a, b)) return result = kZero, true;
      if (a == kOne || a == b) return result = b, true;
      return false;
    case Op::kOr:
      if (a == kOne || complementary(a, b)) return result = kOne, true;
      if (a == kZero || a == b) return result = b, true;
      return false;
    case Op::kXor:
      if (a == b) return result = kZero, true;
      if (complementary(a, b)) return result = kOne, true;
      if (a == kZero) return result = b, true;
      return false;
    default:
      return false;
  }
}

Bits Builder::bitwise(Op op, const Bits& a, const Bits& b) {
  assert(a.size() == b.size());
  Bits result(a.size());
  std::vector<std::size_t> place(a.size(), 0), inverted;
  Bits left, right;
  std::map<std::pair<Bit, Bit>, std::size_t> known;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (simplify_bit(op, a[i], b[i], result[i])) continue;
    if (op == Op::kXor && (a[i] == kOne || b[i] == kOne)) {
      result[i] = a[i] == kOne ? b[i] : a[i];
      inverted.push_back(i);
      continue;
    }
    const std::pair<Bit, Bit> pair = std::minmax(a[i], b[i]);
    const auto [found, added] = known.try_emplace(pair, left.size());
    if (added) {
      left.push_back(pair.first);
      right.push_back(pair.second);
    }
    place[i] = found->second + 1;
  }
  if (!inverted.empty()) {
    Bits plain;
    for (const std::size_t i : inverted) plain.push_back(result[i]);
    const Bits made = bit_not(plain);
    for (std::size_t i = 0; i < inverted.size(); ++i) result[inverted[i]] = made[i];
  }
  if (left.empty()) return result;
  const Bits made = make(op, static_cast<std::uint32_t>(left.size()), {left, right});
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (place[i] != 0) result[i] = made[place[i] - 1];
  }
  return result;
}

Bits Builder::add(const Bits& a, const Bits& b) {
  assert(a.size() == b.size());
  const std::size_t n = a.size();
  if (n == 0) return {};
  if (is_constant(a) && is_constant(b)) return add_constants(a, b, false);
  if (a == b) {
    Bits doubled{kZero};
    append(doubled, slice(a, 0, n - 1));
    return doubled;
  }
  std::size_t low = 0;  // bits below the lowest that both have
  Bits result;
  while (low < n && (a[low] == kZero || b[low] == kZero)) {
    result.push_back(a[low] == kZero ? b[low] : a[low]);
    ++low;
  }
  if (low == n) return result;
  Bits x = slice(a, low, n - low), y = slice(b, low, n - low);
  if (is_constant(y) && unsigned_length(y) == 0) return append(result, x), result;
  if (is_constant(x) && unsigned_length(x) == 0) return append(result, y), result;
  if (is_constant(x)) std::swap(x, y);
  // A bit less one is its complement in every place: how optimisers write "mask unless".
  if (y == Bits(y.size(), kOne) && unsigned_length(x) == 1) {
    append(result, sign_extend(bit_not(slice(x, 0, 1)), n - low));
    return result;
  }
  const bool zero = top_is_zero(x) && top_is_zero(y);
  std::size_t length =
      zero ? std::max(unsigned_length(x), unsigned_length(y)) + 1 : std::max(signed_length(x), signed_length(y)) + 1;
  if (zero) {
    const std::uint64_t most = bounded_sum(bound(x), bound(y));
    if (most == 0) return append(result, constant(0, n - low)), result;
    if (most != kUnbounded) length = std::min<std::size_t>(length, static_cast<std::size_t>(std::bit_width(most)));
  }
  const std::size_t width = std::min(n - low, length);
  x.resize(width);
  y.resize(width);
  Bits sum;
  if (width == 1) {
    sum = bit_xor(x, y);
  } else {
    if (!is_constant(y) && y < x) std::swap(x, y);
    sum = make(Op::kAdd, static_cast<std::uint32_t>(width), {x, y});
  }
  append(result, zero ? zero_extend(sum, n - low) : sign_extend(sum, n - low));
  return result;
}

Bits Builder::sub(const Bits& a, const Bits& b) {
  assert(a.size() == b.size());
  const std::size_t n = a.size();
  if (n == 0) return {};
  if (a == b) return constant(0, n);
  if (is_constant(b)) {
    if (unsigned_length(b) == 0) return a;
    return add(a, add_constants(invert_constant(b), constant(0, n), true));
  }
  std::size_t low = 0;
  Bits result;
  while (low < n && b[low] == kZero) result.push_back(a[low++]);
  Bits x = slice(a, low, n - low), y = slice(b, low, n - low);
  const bool zero = top_is_zero(x) && top_is_zero(y);
  const std::size_t length =
      zero ? std::max(unsigned_length(x), unsigned_length(y)) + 1 : std::max(signed_length(x), signed_length(y)) + 1;
  const std::size_t width = std::min(n - low, length);
  x.resize(width);
  y.resize(width);
  const Bits difference = width == 1 ? bit_xor(x, y) : make(Op::kSub, static_cast<std::uint32_t>(width), {x, y});
  append(result, sign_extend(difference, n - low));
  return result;
}

Bits Builder::multiply_by_constant(const Bits& a, const Bits& factor) {
  // Canonical signed digits: the fewest additions and subtractions of shifted copies.
  const std::size_t n = a.size();
  std::vector<int> digits(n + 1, 0);
  for (std::size_t i = 0; i < n; ++i) digits[i] = factor[i] == kOne ? 1 : 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (digits[i] == 2) {
      digits[i] = 0;
      ++digits[i + 1];
    } else if (digits[i] == 1 && i + 2 < n && digits[i + 1] == 1 && digits[i + 2] == 1) {
      digits[i] = -1;
      digits[i + 1] = 2;
    }
  }
  const auto shifted = [&](std::size_t by) {
    Bits bits = constant(0, by);
    append(bits, slice(a, 0, n - by));
    return bits;
  };
  Bits product = constant(0, n);
  bool first = true;
  // A positive digit first, so that nothing is negated alone.
  std::size_t start = n;
  for (std::size_t i = 0; i < n && start == n; ++i) {
    if (digits[i] > 0) start = i;
  }
  if (start < n) {
    product = shifted(start);
    first = false;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (digits[i] == 0 || i == start) continue;
    product = digits[i] > 0 ? (first ? shifted(i) : add(product, shifted(i))) : sub(product, shifted(i));
    first = false;
  }
  std::size_t length = unsigned_length(a) + unsigned_length(factor);
  const std::uint64_t most = bounded_product(bound(a), bound(factor));
  if (most != kUnbounded) length = std::min<std::size_t>(length, static_cast<std::size_t>(std::bit_width(most)));
  return length < n ? zero_extend(slice(product, 0, length), n) : product;
}

Bits Builder::mul(const Bits& a, const Bits& b) {
  assert(a.size() == b.size());
  const std::size_t n = a.size();
  if (is_constant(a)) return multiply_by_constant(b, a);
  if (is_constant(b)) return multiply_by_constant(a, b);
  std::size_t low_a = 0, low_b = 0;  // factors of two
  while (low_a < n && a[low_a] == kZero) ++low_a;
  while (low_b < n && b[low_b] == kZero) ++low_b;
  const std::size_t low = low_a + low_b;
  if (low >= n) return constant(0, n);
  Bits x = slice(a, low_a, n - low_a), y = slice(b, low_b, n - low_b);
  const std::size_t rest = n - low;
  Bits result = constant(0, low);
  if (top_is_zero(x) && top_is_zero(y)) {
    x.resize(unsigned_length(x));
    y.resize(unsigned_length(y));
    if (x.size() > y.size() || (x.size() == y.size() && y < x)) std::swap(x, y);
    if (x.size() == 1) {
      append(result, slice(zero_extend(bit_and(y, Bits(y.size(), x[0])), std::max(rest, y.size())), 0, rest));
      return result;
    }
    std::size_t width = std::min(rest, x.size() + y.size());
    const std::uint64_t most = bounded_product(bound(x), bound(y));
    if (most == 0) return constant(0, n);
    if (most != kUnbounded) width = std::min<std::size_t>(width, static_cast<std::size_t>(std::bit_width(most)));
    if (x.size() > width) x.resize(width);
    if (y.size() > width) y.resize(width);
    append(result, zero_extend(make(Op::kMul, static_cast<std::uint32_t>(width), {x, y}), rest));
    return result;
  }
  x.resize(std::min(rest, signed_length(x)));
  y.resize(std::min(rest, signed_length(y)));
  if (x.size() > y.size() || (x.size() == y.size() && y < x)) std::swap(x, y);
  const std::size_t width = std::min(rest, x.size() + y.size());
  append(result, sign_extend(make(Op::kMulSigned, static_cast<std::uint32_t>(width), {x, y}), rest));
  return result;
}

template <typename Stage>
Bits Builder::barrel(Bits a, const Bits& amount, Stage stage) {
  std::size_t stages = 0;
  while ((std::size_t{1} << stages) < a.size()) ++stages;
  // The largest shift first: its results are constant or sign bits, which keep the later multiplexers narrow.
  for (std::size_t i = std::min(stages, amount.size()); i-- > 0;) {
    if (amount[i] == kZero) continue;
    a = mux(amount[i], stage(a, std::size_t{1} << i), a);
  }
  return a;
}

Bits Builder::shl(const Bits& a, const Bits& amount) {
  return barrel(a, amount, [](const Bits& x, std::size_t by) {
    Bits y = constant(0, std::min(by, x.size()));
    append(y, slice(x, 0, x.size() - y.size()));
    return y;
  });
}

Bits Builder::lshr(const Bits& a, const Bits& amount) {
  return barrel(a, amount, [](const Bits& x, std::size_t by) {
    by = std::min(by, x.size());
    return zero_extend(slice(x, by, x.size() - by), x.size());
  });
}

Bits Builder::ashr(const Bits& a, const Bits& amount) {
  return barrel(a, amount, [](const Bits& x, std::size_t by) {
    by = std::min(by, x.size() - 1);
    return sign_extend(slice(x, by, x.size() - by), x.size());
  });
}

Bit Builder::eq(const Bits& a, const Bits& b) {
  assert(a.size() == b.size());
  if (is_constant(b) && unsigned_length(b) <= 62 && bound(a) < value_of(b)) return kZero;
  if (is_constant(a) && unsigned_length(a) <= 62 && bound(b) < value_of(a)) return kZero;
  Bits left, right;
  std::map<std::pair<Bit, Bit>, bool> known;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    if (complementary(a[i], b[i])) return kZero;
    const bool swap = a[i].node == 0 || (b[i].node != 0 && b[i] < a[i]);
    std::pair<Bit, Bit> pair = swap ? std::pair{b[i], a[i]} : std::pair{a[i], b[i]};
    if (const Node& node = nodes_[pair.first.node]; node.op == Op::kNot && pair.second.node == 0) {
      pair = {node.operands[0][pair.first.index], constant_bit(pair.second != kOne)};
    }
    if (!known.try_emplace(pair, true).second) continue;
    if (pair.second.node == 0) {
      // The same bit against 0 and 1, or a bit and its complement against the same.
      if (known.contains({pair.first, constant_bit(pair.second != kOne)})) return kZero;
    }
    left.push_back(pair.first);
    right.push_back(pair.second);
  }
  if (left.empty()) return kOne;
  if (left.size() == 1) {
    if (right[0] == kOne) return left[0];
    if (right[0] == kZero) return bit_not(left[0]);
    return bit_not(bit_xor(left[0], right[0]));
  }
  return make(Op::kEq, 1, {left, right})[0];
}

Bit Builder::ult(const Bits& a, const Bits& b) {
  assert(a.size() == b.size());
  if (is_constant(b) && unsigned_length(b) <= 62 && bound(a) < value_of(b)) return kOne;
  if (is_constant(a) && unsigned_length(a) <= 62 && bound(b) <= value_of(a)) return kZero;
  Bits x, y;  // places where both are the same decide nothing
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    x.push_back(a[i]);
    y.push_back(b[i]);
  }
  if (x.empty()) return kZero;
  if (x.back() == kZero && y.back() == kOne) return kOne;
  if (x.back() == kOne && y.back() == kZero) return kZero;
  // Low places where no `less` can arise: they decide only between equal upper parts, and never for `less`.
  std::size_t low = 0;
  while (low < x.size() && (x[low] == kOne || y[low] == kZero)) ++low;
  if (low == x.size()) return kZero;
  x = slice(x, low, x.size() - low);
  y = slice(y, low, y.size() - low);
  if (x.size() == 1) return bit_and(bit_not(x[0]), y[0]);
  if (is_constant(x) && unsigned_length(x) == 0) return bit_not(eq(y, x));
  if (is_constant(y) && unsigned_length(invert_constant(y)) == 0) return bit_not(eq(x, y));
  if (is_constant(y) && unsigned_length(y) == 1) return eq(x, constant(0, x.size()));
  if (is_constant(x) && is_constant(y)) {
    for (std::size_t i = x.size(); i-- > 0;) {
      if (x[i] != y[i]) return y[i];
    }
    return kZero;
  }
  return make(Op::kUlt, 1, {x, y})[0];
}

Bit Builder::slt(const Bits& a, const Bits& b) {
  assert(a.size() == b.size());
  const std::size_t width = std::max(signed_length(a), signed_length(b));
  Bits x = slice(a, 0, width), y = slice(b, 0, width);
  if (x.back() == y.back()) return ult(x, y);
  if (x.back().node == 0 && y.back().node == 0) return constant_bit(x.back() == kOne);
  if (is_constant(y) && unsigned_length(y) == 0) return x.back();
  if (is_constant(x) && unsigned_length(invert_constant(x)) == 0) return bit_not(y.back());
  // Below the sign the comparison is unsigned; bits that are equal decide nothing.
  Bits left, right;
  for (std::size_t i = 0; i + 1 < width; ++i) {
    if (x[i] == y[i]) continue;
    left.push_back(x[i]);
    right.push_back(y[i]);
  }
  std::size_t low = 0;
  while (low < left.size() && (left[low] == kOne || right[low] == kZero)) ++low;
  left = slice(left, low, left.size() - low);
  right = slice(right, low, right.size() - low);
  left.push_back(x.back());
  right.push_back(y.back());
  if (left.size() == 1) return bit_and(left[0], bit_not(right[0]));
  return make(Op::kSlt, 1, {left, right})[0];
}

Bits Builder::mux(Bit condition, const Bits& a, const Bits& b) {
  assert(a.size() == b.size());
  if (condition == kOne) return a;
  if (condition == kZero) return b;
  const Node& decided = nodes_[condition.node];
  if (decided.op == Op::kNot) {
    const Bit plain = decided.operands[0][condition.index];
    return mux(plain, b, a);
  }
  Bits result(a.size());
  std::vector<std::size_t> place(a.size(), 0);
  Bits left, right;
  std::map<std::pair<Bit, Bit>, std::size_t> known;
  // What a bit is where the condition is known: through a multiplexer of the same condition, and the condition itself.
  const auto under = [&](Bit bit, bool value) {
    for (;;) {
      if (bit == condition) return constant_bit(value);
      const Node& node = nodes_[bit.node];
      if (node.op == Op::kMux && node.operands[0][0] == condition) {
        bit = node.operands[value ? 1 : 2][bit.index];
      } else if (node.op == Op::kNot && node.operands[0][bit.index] == condition) {
        return constant_bit(!value);
      } else {
        return bit;
      }
    }
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Bit x = under(a[i], true), y = under(b[i], false);
    if (x == y || is_undefined(y)) {
      result[i] = x;
    } else if (is_undefined(x)) {
      result[i] = y;
    } else if (x == kOne && y == kZero) {
      result[i] = condition;
    } else if (x == kZero && y == kOne) {
      result[i] = bit_not(condition);
    } else {
      const auto [found, added] = known.try_emplace({x, y}, left.size());
      if (added) {
        left.push_back(x);
        right.push_back(y);
      }
      place[i] = found->second + 1;
    }
  }
  if (left.empty()) return result;
  Bits made;
  if (left.size() == 1 && left[0] == kOne) {
    made = {bit_or(condition, right[0])};
  } else if (left.size() == 1 && left[0] == kZero) {
    made = {bit_and(bit_not(condition), right[0])};
  } else if (left.size() == 1 && right[0] == kZero) {
    made = {bit_and(condition, left[0])};
  } else if (left.size() == 1 && right[0] == kOne) {
    made = {bit_or(bit_not(condition), left[0])};
  } else if (left.size() == 1 && complementary(left[0], right[0])) {
    made = {bit_xor(condition, right[0])};
  } else {
    made = make(Op::kMux, static_cast<std::uint32_t>(left.size()), {Bits{condition}, left, right});
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (place[i] != 0) result[i] = made[place[i] - 1];
  }
  return result;
}

namespace {
Bits distinct(const Bits& a, Bit neutral) {
  Bits bits;
  for (const Bit bit : a) {
    if (bit != neutral && std::find(bits.begin(), bits.end(), bit) == bits.end()) bits.push_back(bit);
  }
  return bits;
}
}  // namespace

Bit Builder::reduce_or(const Bits& a) {
  const Bits bits = distinct(a, kZero);
  if (bits.empty()) return kZero;
  for (const Bit bit : bits) {
    if (bit == kOne) return kOne;
  }
  if (bits.size() == 1) return bits[0];
  if (bits.size() == 2) return bit_or(bits[0], bits[1]);
  return make(Op::kReduceOr, 1, {bits})[0];
}

Bit Builder::reduce_and(const Bits& a) {
  const Bits bits = distinct(a, kOne);
  if (bits.empty()) return kOne;
  for (const Bit bit : bits) {
    if (bit == kZero) return kZero;
  }
  if (bits.size() == 1) return bits[0];
  if (bits.size() == 2) return bit_and(bits[0], bits[1]);
  return make(Op::kReduceAnd, 1, {bits})[0];
}

Bit Builder::reduce_xor(const Bits& a) {
  Bits bits;  // a pair cancels
  bool inverted = false;
  for (const Bit bit : a) {
    if (bit.node == 0) {
      inverted ^= bit == kOne;
      continue;
    }
    const auto found = std::find(bits.begin(), bits.end(), bit);
    if (found != bits.end()) {
      bits.erase(found);
    } else {
      bits.push_back(bit);
    }
  }
  Bit result = kZero;
  if (bits.size() == 1) {
    result = bits[0];
  } else if (bits.size() == 2) {
    result = bit_xor(bits[0], bits[1]);
  } else if (!bits.empty()) {
    result = make(Op::kReduceXor, 1, {bits})[0];
  }
  return inverted ? bit_not(result) : result;
}

}  // namespace hlsc
