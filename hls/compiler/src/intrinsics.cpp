// SPDX-License-Identifier: Apache-2.0
#include "hlsc/intrinsics.hpp"

#include <algorithm>

namespace hlsc {

namespace {

using llvm::Intrinsic::ID;

Bits concatenate(Bits low, const Bits& high) {
  low.insert(low.end(), high.begin(), high.end());
  return low;
}

Bits reversed(Bits a) {
  std::reverse(a.begin(), a.end());
  return a;
}

Bits population(Builder& builder, const Bits& a) {
  if (a.size() == 1) return a;
  const std::size_t half = a.size() / 2;
  Bits low = population(builder, Builder::slice(a, 0, half)),
       high = population(builder, Builder::slice(a, half, a.size() - half));
  const std::size_t width = std::max(low.size(), high.size()) + 1;
  return builder.add(Builder::zero_extend(low, width), Builder::zero_extend(high, width));
}

/// Leading zeros of 2^k bits, in k + 1 bits.
Bits leading_zeros_of_power(Builder& builder, const Bits& a) {
  if (a.size() == 1) return builder.bit_not(a);
  const std::size_t half = a.size() / 2;
  const Bits low = leading_zeros_of_power(builder, Builder::slice(a, 0, half)),
             high = leading_zeros_of_power(builder, Builder::slice(a, half, half));
  const std::size_t k = low.size() - 1;
  const Bit high_empty = high[k], low_empty = low[k];
  Bits result = builder.mux(high_empty, Builder::slice(low, 0, k), Builder::slice(high, 0, k));
  result.push_back(builder.bit_and(high_empty, builder.bit_not(low_empty)));
  result.push_back(builder.bit_and(high_empty, low_empty));
  return result;
}

Bits leading_zeros(Builder& builder, const Bits& a) {
  std::size_t length = 1;
  while (length < a.size()) length *= 2;
  // Ones below fill up to a power of two: they stop the count at the right place.
  Bits padded(length - a.size(), kOne);
  padded = concatenate(padded, a);
  const Bits count = leading_zeros_of_power(builder, padded);
  return count.size() >= a.size() ? Builder::slice(count, 0, a.size()) : Builder::zero_extend(count, a.size());
}

Bits largest_signed(std::size_t n) {
  Bits bits(n, kOne);
  bits.back() = kZero;
  return bits;
}

Bits smallest_signed(std::size_t n) {
  Bits bits(n, kZero);
  bits.back() = kOne;
  return bits;
}

struct Overflowing {
  Bits value;
  Bit overflow;
  Bit negative;  ///< sign of the exact result
};

/// a ± b or a · b exactly, and whether the exact result fits `a`'s size.
Overflowing exact(Builder& builder, char operation, bool is_signed, const Bits& a, const Bits& b) {
  const std::size_t n = a.size(), wide = operation == '*' ? 2 * n : n + 1;
  const auto extend = [&](const Bits& x) {
    return is_signed ? Builder::sign_extend(x, wide) : Builder::zero_extend(x, wide);
  };
  const Bits x = extend(a), y = extend(b);
  const Bits result = operation == '+' ? builder.add(x, y) : operation == '-' ? builder.sub(x, y) : builder.mul(x, y);
  const Bits low = Builder::slice(result, 0, n), back = extend(low);
  return {low, builder.bit_not(builder.eq(back, result)), result.back()};
}

Bits saturating(Builder& builder, char operation, bool is_signed, const Bits& a, const Bits& b) {
  const Overflowing result = exact(builder, operation, is_signed, a, b);
  const std::size_t n = a.size();
  if (is_signed) {
    return builder.mux(result.overflow, builder.mux(result.negative, smallest_signed(n), largest_signed(n)),
                       result.value);
  }
  return builder.mux(result.overflow, operation == '-' ? Bits(n, kZero) : Bits(n, kOne), result.value);
}

Bits overflowing(Builder& builder, char operation, bool is_signed, const Bits& a, const Bits& b) {
  const Overflowing result = exact(builder, operation, is_signed, a, b);
  return concatenate(result.value, {result.overflow});
}

std::optional<Bits> funnel(Builder& builder, bool left, const Bits& high, const Bits& low, const Bits& amount) {
  const std::size_t n = high.size();
  if ((n & (n - 1)) != 0 && !Builder::is_constant(amount)) return std::nullopt;  // the amount is taken modulo n
  Bits small = amount;
  if (Builder::is_constant(amount)) {
    small = Builder::constant(Builder::value_of(amount) % n, n);
  } else {
    for (std::size_t i = 0; i < small.size(); ++i) {
      if ((std::size_t{1} << std::min<std::size_t>(i, 63)) >= n) small[i] = kZero;
    }
  }
  const Bits both = concatenate(low, high);
  const Bits wide_amount = Builder::zero_extend(small, both.size());
  if (left) return Builder::slice(builder.shl(both, wide_amount), n, n);
  return Builder::slice(builder.lshr(both, wide_amount), 0, n);
}

}  // namespace

bool is_ignored_intrinsic(ID id) {
  switch (id) {
    case llvm::Intrinsic::dbg_assign:
    case llvm::Intrinsic::dbg_declare:
    case llvm::Intrinsic::dbg_label:
    case llvm::Intrinsic::dbg_value:
    case llvm::Intrinsic::lifetime_start:
    case llvm::Intrinsic::lifetime_end:
    case llvm::Intrinsic::invariant_start:
    case llvm::Intrinsic::invariant_end:
    case llvm::Intrinsic::assume:
    case llvm::Intrinsic::donothing:
    case llvm::Intrinsic::sideeffect:
    case llvm::Intrinsic::experimental_noalias_scope_decl:
    case llvm::Intrinsic::var_annotation:
    case llvm::Intrinsic::prefetch:
      return true;
    default:
      return false;
  }
}

Bit comparison(Builder& builder, llvm::CmpInst::Predicate predicate, const Bits& a, const Bits& b) {
  switch (predicate) {
    case llvm::CmpInst::ICMP_EQ:
      return builder.eq(a, b);
    case llvm::CmpInst::ICMP_NE:
      return builder.bit_not(builder.eq(a, b));
    case llvm::CmpInst::ICMP_ULT:
      return builder.ult(a, b);
    case llvm::CmpInst::ICMP_UGT:
      return builder.ult(b, a);
    case llvm::CmpInst::ICMP_ULE:
      return builder.bit_not(builder.ult(b, a));
    case llvm::CmpInst::ICMP_UGE:
      return builder.bit_not(builder.ult(a, b));
    case llvm::CmpInst::ICMP_SLT:
      return builder.slt(a, b);
    case llvm::CmpInst::ICMP_SGT:
      return builder.slt(b, a);
    case llvm::CmpInst::ICMP_SLE:
      return builder.bit_not(builder.slt(b, a));
    default:
      return builder.bit_not(builder.slt(a, b));  // ICMP_SGE, the last one of integers
  }
}

std::optional<Bits> evaluate_intrinsic(Builder& builder, ID id, const std::vector<Bits>& arguments,
                                       std::uint64_t width) {
  const auto& a = arguments[0];
  const auto b = [&]() -> const Bits& { return arguments[1]; };
  const auto three_way = [&](Bit less, Bit greater) {
    Bits result(width, less);  // -1, 0, 1
    result[0] = builder.bit_or(less, greater);
    return result;
  };
  switch (id) {
    case llvm::Intrinsic::umin:
      return builder.mux(builder.ult(b(), a), b(), a);
    case llvm::Intrinsic::umax:
      return builder.mux(builder.ult(a, b()), b(), a);
    case llvm::Intrinsic::smin:
      return builder.mux(builder.slt(b(), a), b(), a);
    case llvm::Intrinsic::smax:
      return builder.mux(builder.slt(a, b()), b(), a);
    case llvm::Intrinsic::ucmp:
      return three_way(builder.ult(a, b()), builder.ult(b(), a));
    case llvm::Intrinsic::scmp:
      return three_way(builder.slt(a, b()), builder.slt(b(), a));
    case llvm::Intrinsic::abs:
      return builder.mux(a.back(), builder.sub(Builder::constant(0, a.size()), a), a);
    case llvm::Intrinsic::ctpop: {
      const Bits count = population(builder, a);
      return count.size() >= width ? Builder::slice(count, 0, width) : Builder::zero_extend(count, width);
    }
    case llvm::Intrinsic::ctlz:
      return leading_zeros(builder, a);
    case llvm::Intrinsic::cttz:
      return leading_zeros(builder, reversed(a));
    case llvm::Intrinsic::bitreverse:
      return reversed(a);
    case llvm::Intrinsic::bswap: {
      Bits swapped;
      for (std::size_t byte = a.size() / 8; byte-- > 0;) swapped = concatenate(swapped, Builder::slice(a, byte * 8, 8));
      return swapped;
    }
    case llvm::Intrinsic::fshl:
      return funnel(builder, true, a, b(), arguments[2]);
    case llvm::Intrinsic::fshr:
      return funnel(builder, false, a, b(), arguments[2]);
    case llvm::Intrinsic::uadd_sat:
      return saturating(builder, '+', false, a, b());
    case llvm::Intrinsic::sadd_sat:
      return saturating(builder, '+', true, a, b());
    case llvm::Intrinsic::usub_sat:
      return saturating(builder, '-', false, a, b());
    case llvm::Intrinsic::ssub_sat:
      return saturating(builder, '-', true, a, b());
    case llvm::Intrinsic::uadd_with_overflow:
      return overflowing(builder, '+', false, a, b());
    case llvm::Intrinsic::sadd_with_overflow:
      return overflowing(builder, '+', true, a, b());
    case llvm::Intrinsic::usub_with_overflow:
      return overflowing(builder, '-', false, a, b());
    case llvm::Intrinsic::ssub_with_overflow:
      return overflowing(builder, '-', true, a, b());
    case llvm::Intrinsic::umul_with_overflow:
      return overflowing(builder, '*', false, a, b());
    case llvm::Intrinsic::smul_with_overflow:
      return overflowing(builder, '*', true, a, b());
    case llvm::Intrinsic::expect:
    case llvm::Intrinsic::expect_with_probability:
    case llvm::Intrinsic::launder_invariant_group:
    case llvm::Intrinsic::strip_invariant_group:
    case llvm::Intrinsic::ssa_copy:
    case llvm::Intrinsic::annotation:
    case llvm::Intrinsic::ptr_annotation:
      return a;
    default:
      return std::nullopt;
  }
}

}  // namespace hlsc
