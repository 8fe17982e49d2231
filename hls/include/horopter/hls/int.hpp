// SPDX-License-Identifier: Apache-2.0
// Integers of any width from 1 to 64 bits, kept in the smallest standard integer.
//
// u<N> holds 0 … 2^N − 1, s<N> holds −2^(N−1) … 2^(N−1) − 1 (two's complement).
// - Arithmetic widens, so it never loses a bit: u<A> + u<B> is u<max(A,B)+1>, u − u is s<max(A,B)+1>, u * u is u<A+B>;
//   with one signed operand the result is signed. A result of more than 64 bits does not compile.
// - Converting from a built-in integer, and explicitly to a narrower type or between signs, keeps the low bits (wraps).
//   Converting to a type that holds every value of the source is implicit. sat<N>() clamps instead.
// - Comparisons are of the mathematical values, whatever the widths and signs.
// - += and −= wrap to the width of the left side, as a register does.
// Plain standard C++: the same text is the CPU's arithmetic and what hlsc reads.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace horopter::hls {

template <int N>
class u;
template <int N>
class s;

namespace detail {

template <int N>
using unsigned_storage = std::conditional_t<
    (N <= 8), std::uint8_t,
    std::conditional_t<(N <= 16), std::uint16_t, std::conditional_t<(N <= 32), std::uint32_t, std::uint64_t>>>;

template <int N>
using signed_storage = std::make_signed_t<unsigned_storage<N>>;

// The type in which a result of N bits is computed: int or wider, so that nothing is promoted twice.
template <int N>
using unsigned_work = std::conditional_t<(N <= 32), std::uint32_t, std::uint64_t>;
template <int N>
using signed_work = std::conditional_t<(N <= 32), std::int32_t, std::int64_t>;

template <class T>
struct traits {
  static constexpr bool known = false;
};
template <int N>
struct traits<u<N>> {
  static constexpr bool known = true;
  static constexpr bool is_signed = false;
  static constexpr int width = N;
};
template <int N>
struct traits<s<N>> {
  static constexpr bool known = true;
  static constexpr bool is_signed = true;
  static constexpr int width = N;
};

struct exact_t {};  // "this value fits, do not wrap it"

}  // namespace detail

/// u<N> or s<N>.
template <class T>
concept fixed_integer = detail::traits<std::remove_cvref_t<T>>::known;

template <class T>
inline constexpr int width_of = detail::traits<std::remove_cvref_t<T>>::width;
template <class T>
inline constexpr bool is_signed_v = detail::traits<std::remove_cvref_t<T>>::is_signed;

template <int N>
class u {
  static_assert(N >= 1 && N <= 64, "u<N>: 1 to 64 bits");

 public:
  using storage = detail::unsigned_storage<N>;
  static constexpr int width = N;

  constexpr u() = default;

  template <std::integral T>
  constexpr u(T value) : value_(wrap(static_cast<std::uint64_t>(value))) {}  // NOLINT: implicit by design

  template <int M>
  explicit(M > N) constexpr u(u<M> other) : value_(M > N ? wrap(other.value()) : static_cast<storage>(other.value())) {}

  template <int M>
  explicit constexpr u(s<M> other) : value_(wrap(static_cast<std::uint64_t>(other.value()))) {}

  constexpr u(detail::exact_t, std::uint64_t value) : value_(static_cast<storage>(value)) {}

  [[nodiscard]] constexpr storage value() const { return value_; }

  template <std::integral T>
  explicit constexpr operator T() const {
    return static_cast<T>(value_);
  }

  static constexpr u max() { return u(mask()); }

  [[nodiscard]] constexpr bool bit(int index) const { return ((value_ >> index) & 1U) != 0; }

  template <int Hi, int Lo>
  [[nodiscard]] constexpr u<Hi - Lo + 1> bits() const {
    static_assert(N > Hi && Hi >= Lo && Lo >= 0, "bits<Hi, Lo>: outside the value");
    return u<Hi - Lo + 1>(static_cast<std::uint64_t>(value_) >> Lo);
  }

  constexpr u operator~() const { return u(~static_cast<std::uint64_t>(value_)); }

  template <fixed_integer T>
  constexpr u& operator+=(T other) {
    value_ = wrap(static_cast<std::uint64_t>(value_) + static_cast<std::uint64_t>(other.value()));
    return *this;
  }
  template <fixed_integer T>
  constexpr u& operator-=(T other) {
    value_ = wrap(static_cast<std::uint64_t>(value_) - static_cast<std::uint64_t>(other.value()));
    return *this;
  }

 private:
  static constexpr std::uint64_t mask() { return ~std::uint64_t{0} >> (64 - N); }
  static constexpr storage wrap(std::uint64_t value) { return static_cast<storage>(value & mask()); }

  storage value_{};
};

template <int N>
class s {
  static_assert(N >= 1 && N <= 64, "s<N>: 1 to 64 bits");

 public:
  using storage = detail::signed_storage<N>;
  static constexpr int width = N;

  constexpr s() = default;

  template <std::integral T>
  constexpr s(T value) : value_(wrap(static_cast<std::uint64_t>(value))) {}  // NOLINT: implicit by design

  template <int M>
  explicit(M > N) constexpr s(s<M> other)
      : value_(M > N ? wrap(static_cast<std::uint64_t>(other.value())) : static_cast<storage>(other.value())) {}

  template <int M>
  explicit(M >= N) constexpr s(u<M> other)
      : value_(M >= N ? wrap(other.value()) : static_cast<storage>(other.value())) {}

  constexpr s(detail::exact_t, std::int64_t value) : value_(static_cast<storage>(value)) {}

  [[nodiscard]] constexpr storage value() const { return value_; }

  template <std::integral T>
  explicit constexpr operator T() const {
    return static_cast<T>(value_);
  }

  static constexpr s max() { return s(detail::exact_t{}, static_cast<std::int64_t>(~std::uint64_t{0} >> (65 - N))); }
  static constexpr s min() { return s(detail::exact_t{}, -max().value() - std::int64_t{1}); }

  [[nodiscard]] constexpr bool bit(int index) const { return ((value_ >> index) & 1) != 0; }
  [[nodiscard]] constexpr bool negative() const { return value_ < 0; }

  template <int Hi, int Lo>
  [[nodiscard]] constexpr u<Hi - Lo + 1> bits() const {
    static_assert(N > Hi && Hi >= Lo && Lo >= 0, "bits<Hi, Lo>: outside the value");
    return u<Hi - Lo + 1>(static_cast<std::uint64_t>(static_cast<std::int64_t>(value_)) >> Lo);
  }

  constexpr s operator~() const { return s(detail::exact_t{}, ~static_cast<std::int64_t>(value_)); }

  template <fixed_integer T>
  constexpr s& operator+=(T other) {
    value_ = wrap(static_cast<std::uint64_t>(value_) + static_cast<std::uint64_t>(other.value()));
    return *this;
  }
  template <fixed_integer T>
  constexpr s& operator-=(T other) {
    value_ = wrap(static_cast<std::uint64_t>(value_) - static_cast<std::uint64_t>(other.value()));
    return *this;
  }

 private:
  static constexpr storage wrap(std::uint64_t value) {
    constexpr int bits = 8 * static_cast<int>(sizeof(storage));
    if constexpr (bits == N) {
      return static_cast<storage>(value);
    } else {
      using work = detail::unsigned_work<N>;
      constexpr int shift = 8 * static_cast<int>(sizeof(work)) - N;
      return static_cast<storage>(static_cast<std::make_signed_t<work>>(static_cast<work>(value) << shift) >> shift);
    }
  }

  storage value_{};
};

static_assert(std::is_trivially_copyable_v<u<9>> && sizeof(u<9>) == 2 && sizeof(s<33>) == 8);

namespace detail {

// The width that a and b need as signed numbers.
template <class T>
inline constexpr int signed_width = width_of<T> + (is_signed_v<T> ? 0 : 1);

template <class A, class B>
constexpr auto add(A a, B b) {
  if constexpr (!is_signed_v<A> && !is_signed_v<B>) {
    constexpr int width = std::max(width_of<A>, width_of<B>) + 1;
    using work = unsigned_work<width>;
    return u<width>(exact_t{}, static_cast<work>(static_cast<work>(a.value()) + static_cast<work>(b.value())));
  } else {
    constexpr int width = std::max(signed_width<A>, signed_width<B>) + 1;
    using work = signed_work<width>;
    return s<width>(exact_t{}, static_cast<work>(a.value()) + static_cast<work>(b.value()));
  }
}

template <class A, class B>
constexpr auto subtract(A a, B b) {
  constexpr int width = (!is_signed_v<A> && !is_signed_v<B>) ? std::max(width_of<A>, width_of<B>) + 1
                                                             : std::max(signed_width<A>, signed_width<B>) + 1;
  using work = signed_work<width>;
  return s<width>(exact_t{}, static_cast<work>(a.value()) - static_cast<work>(b.value()));
}

template <class A, class B>
constexpr auto multiply(A a, B b) {
  constexpr int width = width_of<A> + width_of<B>;
  if constexpr (!is_signed_v<A> && !is_signed_v<B>) {
    using work = unsigned_work<width>;
    return u<width>(exact_t{}, static_cast<work>(static_cast<work>(a.value()) * static_cast<work>(b.value())));
  } else {
    using work = signed_work<width>;
    return s<width>(exact_t{}, static_cast<work>(a.value()) * static_cast<work>(b.value()));
  }
}

// The mathematical value in a type wide enough for both sides of a comparison; 64-bit unsigned against signed aside.
template <class A, class B>
inline constexpr bool fits_signed64 = std::max(signed_width<A>, signed_width<B>) <= 64;

template <class A, class B>
using compare_work =
    std::conditional_t<!is_signed_v<A> && !is_signed_v<B>, unsigned_work<std::max(width_of<A>, width_of<B>)>,
                       signed_work<std::min(64, std::max(signed_width<A>, signed_width<B>))>>;

template <class A, class B>
constexpr bool equal(A a, B b) {
  if constexpr (is_signed_v<A> == is_signed_v<B> || fits_signed64<A, B>) {
    using work = compare_work<A, B>;
    return static_cast<work>(a.value()) == static_cast<work>(b.value());
  } else {
    return std::cmp_equal(a.value(), b.value());
  }
}

template <class A, class B>
constexpr bool less(A a, B b) {
  if constexpr (is_signed_v<A> == is_signed_v<B> || fits_signed64<A, B>) {
    using work = compare_work<A, B>;
    return static_cast<work>(a.value()) < static_cast<work>(b.value());
  } else {
    return std::cmp_less(a.value(), b.value());
  }
}

// A built-in integer beside a fixed one in a comparison, exactly.
template <std::integral T>
constexpr auto as_fixed(T value) {
  constexpr int width = std::same_as<T, bool> ? 1 : 8 * static_cast<int>(sizeof(T));
  if constexpr (std::is_signed_v<T>) {
    return s<width>(value);
  } else {
    return u<width>(value);
  }
}
template <fixed_integer T>
constexpr T as_fixed(T value) {
  return value;
}

template <class A, class B>
concept comparable = (fixed_integer<A> && fixed_integer<B>) || (fixed_integer<A> && std::integral<B>) ||
                     (std::integral<A> && fixed_integer<B>);

}  // namespace detail

template <fixed_integer A, fixed_integer B>
constexpr auto operator+(A a, B b) {
  return detail::add(a, b);
}
template <fixed_integer A, fixed_integer B>
constexpr auto operator-(A a, B b) {
  return detail::subtract(a, b);
}
template <fixed_integer A, fixed_integer B>
constexpr auto operator*(A a, B b) {
  return detail::multiply(a, b);
}
template <fixed_integer A>
constexpr auto operator-(A a) {
  return detail::subtract(u<1>(), a);
}

template <int A, int B>
constexpr u<std::max(A, B)> operator&(u<A> a, u<B> b) {
  return {detail::exact_t{}, static_cast<std::uint64_t>(a.value()) & b.value()};
}
template <int A, int B>
constexpr u<std::max(A, B)> operator|(u<A> a, u<B> b) {
  return {detail::exact_t{}, static_cast<std::uint64_t>(a.value()) | b.value()};
}
template <int A, int B>
constexpr u<std::max(A, B)> operator^(u<A> a, u<B> b) {
  return {detail::exact_t{}, static_cast<std::uint64_t>(a.value()) ^ b.value()};
}

template <class A, class B>
  requires detail::comparable<A, B>
constexpr bool operator==(A a, B b) {
  return detail::equal(detail::as_fixed(a), detail::as_fixed(b));
}
template <class A, class B>
  requires detail::comparable<A, B>
constexpr bool operator<(A a, B b) {
  return detail::less(detail::as_fixed(a), detail::as_fixed(b));
}
template <class A, class B>
  requires detail::comparable<A, B>
constexpr bool operator>(A a, B b) {
  return detail::less(detail::as_fixed(b), detail::as_fixed(a));
}
template <class A, class B>
  requires detail::comparable<A, B>
constexpr bool operator<=(A a, B b) {
  return !(a > b);
}
template <class A, class B>
  requires detail::comparable<A, B>
constexpr bool operator>=(A a, B b) {
  return !(a < b);
}

/// The constant V in the fewest bits: lit<9>() is u<4>, lit<-2>() is s<2>.
template <std::int64_t V>
constexpr auto lit() {
  if constexpr (V >= 0) {
    return u<std::max(1, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(V))))>(V);
  } else {
    return s<static_cast<int>(std::bit_width(~static_cast<std::uint64_t>(V))) + 1>(V);
  }
}

/// Bits needed for the values 0 … max.
constexpr int bits_for(std::uint64_t max) { return std::max(1, static_cast<int>(std::bit_width(max))); }

/// value · 2^K, widened.
template <int K, int N>
constexpr u<N + K> shl(u<N> value) {
  return {detail::exact_t{}, static_cast<std::uint64_t>(value.value()) << K};
}
template <int K, int N>
constexpr s<N + K> shl(s<N> value) {
  return {detail::exact_t{},
          static_cast<std::int64_t>(static_cast<std::uint64_t>(static_cast<std::int64_t>(value.value())) << K)};
}

/// ⌊value / 2^K⌋, narrowed.
template <int K, int N>
constexpr u<(N > K ? N - K : 1)> shr(u<N> value) {
  return {detail::exact_t{}, K < N ? static_cast<std::uint64_t>(value.value()) >> (K < N ? K : 0) : 0};
}
template <int K, int N>
constexpr s<(N > K ? N - K : 1)> shr(s<N> value) {
  return {detail::exact_t{}, static_cast<std::int64_t>(value.value()) >> (K < N ? K : N - 1)};
}

/// value · 2^amount and ⌊value / 2^amount⌋ by a variable amount.
template <int N, int K>
constexpr auto operator<<(u<N> value, u<K> amount) {
  static_assert(K <= 6);
  return u<N + (1 << K) - 1>(detail::exact_t{}, static_cast<std::uint64_t>(value.value()) << amount.value());
}
template <int N, int K>
constexpr u<N> operator>>(u<N> value, u<K> amount) {
  static_assert(K <= 5, "the shift amount must stay below the width of the working type");
  return {detail::exact_t{}, static_cast<detail::unsigned_work<N>>(value.value()) >> amount.value()};
}

/// The low N bits, sign kept: zero- or sign-extended if wider.
template <int N, int M>
constexpr u<N> resize(u<M> value) {
  return u<N>(value);
}
template <int N, int M>
constexpr s<N> resize(s<M> value) {
  return s<N>(value);
}

/// Clamped to 0 … 2^N − 1.
template <int N, fixed_integer T>
constexpr u<N> sat(T value) {
  if constexpr (is_signed_v<T>) {
    if (value.negative()) {
      return u<N>();
    }
  }
  if constexpr (width_of<T> - (is_signed_v<T> ? 1 : 0) > N) {
    if (value > u<N>::max()) {
      return u<N>::max();
    }
  }
  return u<N>(value);
}

/// In hardware the bits turned round, and one more: no choice behind the adder.
template <int N>
constexpr u<N> abs(s<N> value) {
#ifdef __HLSC__
  if constexpr (N < 64) {
    const bool negative = value.negative();
    const u<N> bits(value);
    return u<N>((negative ? ~bits : bits) + u<1>(negative));
  }
#endif
  using work = detail::signed_work<N + 1 <= 64 ? N + 1 : 64>;
  const work v = value.value();
  return u<N>(detail::exact_t{}, static_cast<std::uint64_t>(v < 0 ? -v : v));
}

template <int N>
constexpr u<N> min(u<N> a, u<N> b) {
  return a < b ? a : b;
}
template <int N>
constexpr u<N> max(u<N> a, u<N> b) {
  return a < b ? b : a;
}

/// Number of ones.
template <int N>
constexpr u<bits_for(N)> popcount(u<N> value) {
#ifndef __HLSC__
  return {detail::exact_t{}, static_cast<std::uint64_t>(std::popcount(std::uint64_t{value.value()}))};
#endif
  u<bits_for(N)> sum(0);
  for (int i = 0; i < N; ++i) sum = u<bits_for(N)>(sum + u<1>(value.bit(i)));
  return sum;
}

namespace detail {

/// Non-restoring division (Flores, The Logic of Computer Arithmetic, 1963): one adder a step. `over` is the divisor
/// less twice the rest, negative where the divisor fits; ">" keeps 0 / 0 at 0.
template <int Q, int N>
constexpr u<Q> ratio_by_subtraction(u<N> smaller, u<N> larger) {
  std::uint64_t quotient = 0;
  u<N + 1> over(larger - u<N + 1>(exact_t{}, static_cast<std::uint64_t>(smaller.value()) << 1));  // two's complement
  for (int i = 0; i < Q; ++i) {
    const bool fits = over.bit(N);
    quotient = quotient << 1 | (fits ? 1U : 0U);
    const u<N + 1> wide(larger);
    const u<N + 1> added = fits ? wide : u<N + 1>(~wide);  // with the carry below: larger, -larger
    over = u<N + 1>(cat(u<N>(over), u<1>(!fits)) + added);
  }
  return {exact_t{}, quotient};
}

/// Exact too: the operands have far fewer bits than the mantissa.
template <int Q, int N>
constexpr u<Q> ratio_by_division(u<N> smaller, u<N> larger) {
  static_assert(Q + 2 * N <= 26);
  const int scaled = (static_cast<int>(smaller.value()) << Q) - 1;
  const int divisor = static_cast<int>(larger.value());
  const float quotient = static_cast<float>(scaled < 0 ? 0 : scaled) / static_cast<float>(divisor < 1 ? 1 : divisor);
  return {exact_t{}, static_cast<std::uint64_t>(static_cast<int>(quotient))};
}

}  // namespace detail

/// The quotient in 1/2^Q, below 1: ⌈2^Q · smaller / larger⌉ − 1 for 0 < smaller ≤ larger, 0 for smaller = 0.
/// Subtractions in hardware, a division on the CPU.
template <int Q, int N>
constexpr u<Q> ratio(u<N> smaller, u<N> larger) {
#ifdef __HLSC__
  return detail::ratio_by_subtraction<Q>(smaller, larger);
#else
  return detail::ratio_by_division<Q>(smaller, larger);
#endif
}

namespace detail {
template <class T>
constexpr auto to_bits(T value) {
  if constexpr (std::same_as<T, bool>) {
    return u<1>(value);
  } else if constexpr (is_signed_v<T>) {
    return u<width_of<T>>(value);
  } else {
    return value;
  }
}
}  // namespace detail

/// Concatenation, the first argument in the highest bits. bool counts as one bit.
template <class T>
constexpr auto cat(T value) {
  return detail::to_bits(value);
}
template <class T, class U, class... Rest>
constexpr auto cat(T high, U low, Rest... rest) {
  const auto h = detail::to_bits(high);
  const auto l = detail::to_bits(low);
  constexpr int low_width = width_of<decltype(l)>;
  const u<width_of<decltype(h)> + low_width> joined(detail::exact_t{},
                                                    (static_cast<std::uint64_t>(h.value()) << low_width) | l.value());
  return cat(joined, rest...);
}

}  // namespace horopter::hls
