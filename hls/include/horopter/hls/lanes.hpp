// SPDX-License-Identifier: Apache-2.0
// The integers of int.hpp, several at once: the same operations with the same widths in one vector register of 16-bit
// lanes, as many as the instructions have that this is compiled for. For the native engine only. Not all of int.hpp, but
// what stages do to pixel values.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "horopter/hls/values.hpp"

namespace horopter::hls::lanes {

// All files of a program must agree on it, or hide what they make of it from each other (hls/CMakeLists.txt). Vectors of
// AVX-512 are not used: strips of half the width have as many columns around them, and 32 lanes are slower than 16.
#if defined(HOROPTER_LANES)
inline constexpr int count = HOROPTER_LANES;
#elif defined(__AVX2__)
inline constexpr int count = 16;
#else
inline constexpr int count = 8;
#endif

using unsigned_vector = std::uint16_t __attribute__((vector_size(2 * count)));
using signed_vector = std::int16_t __attribute__((vector_size(2 * count)));

template <int N>
class s;

/// A bit per lane, as a mask of all ones or zeros.
class bit {
 public:
  bit() = default;
  bit(bool value) : mask_(signed_vector{} - static_cast<std::int16_t>(value)) {}  // NOLINT: a bit for all lanes
  explicit bit(signed_vector mask) : mask_(mask) {}
  [[nodiscard]] signed_vector mask() const { return mask_; }
  [[nodiscard]] bool lane(int i) const { return mask_[i] != 0; }
  void set_lane(int i, bool value) { mask_[i] = static_cast<std::int16_t>(-static_cast<int>(value)); }

  friend bit operator&&(bit a, bit b) { return bit(a.mask_ & b.mask_); }
  friend bit operator||(bit a, bit b) { return bit(a.mask_ | b.mask_); }
  friend bit operator!=(bit a, bit b) { return bit(a.mask_ ^ b.mask_); }
  friend bit operator==(bit a, bit b) { return bit(~(a.mask_ ^ b.mask_)); }
  bit operator!() const { return bit(~mask_); }

 private:
  signed_vector mask_{};
};

template <int N>
class u {
  static_assert(N >= 1 && N <= 16, "a lane has 16 bits");

 public:
  static constexpr int width = N;
  u() = default;
  template <std::integral T>
  u(T value) : u(hls::u<N>(value)) {}                                                            // NOLINT: as hls::u
  u(hls::u<N> value) : value_(unsigned_vector{} + static_cast<std::uint16_t>(value.value())) {}  // NOLINT
  template <int M>
  explicit(M > N) u(u<M> other) : value_(M > N ? other.vector() & low_bits : other.vector()) {}
  template <int M>
  explicit u(s<M> other) : value_(reinterpret_cast<unsigned_vector>(other.vector()) & low_bits) {}
  explicit u(bit b) : value_(reinterpret_cast<unsigned_vector>(b.mask()) & 1) {}
  explicit u(unsigned_vector value) : value_(value) {}  // must fit

  [[nodiscard]] unsigned_vector vector() const { return value_; }
  [[nodiscard]] hls::u<N> lane(int i) const { return hls::u<N>(value_[i]); }
  void set_lane(int i, hls::u<N> value) { value_[i] = value.value(); }

  static u max() { return u(hls::u<N>::max()); }
  [[nodiscard]] lanes::bit bit(int index) const {
    return lanes::bit(reinterpret_cast<signed_vector>((value_ >> index & 1) != 0));
  }
  template <int Hi, int Lo>
  [[nodiscard]] u<Hi - Lo + 1> bits() const {
    return u<Hi - Lo + 1>(u<16>(value_ >> Lo));
  }

  template <class T>
  u& operator+=(T other) {
    return *this =
               u(static_cast<unsigned_vector>((value_ + reinterpret_cast<unsigned_vector>(other.vector())) & low_bits));
  }
  template <class T>
  u& operator-=(T other) {
    return *this =
               u(static_cast<unsigned_vector>((value_ - reinterpret_cast<unsigned_vector>(other.vector())) & low_bits));
  }

 private:
  static constexpr std::uint16_t low_bits = static_cast<std::uint16_t>(0xFFFFU >> (16 - N));
  unsigned_vector value_{};
};

template <int N>
class s {
  static_assert(N >= 1 && N <= 16, "a lane has 16 bits");

 public:
  static constexpr int width = N;
  s() = default;
  template <std::integral T>
  s(T value) : s(hls::s<N>(value)) {}                                                         // NOLINT: as hls::s
  s(hls::s<N> value) : value_(signed_vector{} + static_cast<std::int16_t>(value.value())) {}  // NOLINT
  template <int M>
  explicit(M > N) s(s<M> other) : value_(M > N ? other.vector() << (16 - N) >> (16 - N) : other.vector()) {}
  template <int M>
  explicit(M >= N) s(u<M> other)
      : value_(M >= N ? reinterpret_cast<signed_vector>(other.vector()) << (16 - N) >> (16 - N)
                      : reinterpret_cast<signed_vector>(other.vector())) {}
  explicit s(signed_vector value) : value_(value) {}  // must fit

  [[nodiscard]] signed_vector vector() const { return value_; }
  [[nodiscard]] hls::s<N> lane(int i) const { return hls::s<N>(value_[i]); }
  [[nodiscard]] lanes::bit negative() const { return lanes::bit(value_ >> 15); }

 private:
  signed_vector value_{};
};

template <class T>
struct traits {
  static constexpr bool known = false;
};
template <int N>
struct traits<u<N>> {
  static constexpr bool known = true;
  static constexpr bool is_signed = false;
};
template <int N>
struct traits<s<N>> {
  static constexpr bool known = true;
  static constexpr bool is_signed = true;
};
template <class T>
concept vector = traits<T>::known;

/// A scalar in all lanes.
template <int N>
u<N> spread(hls::u<N> value) {
  return u<N>(value);
}
template <int N>
s<N> spread(hls::s<N> value) {
  return s<N>(signed_vector{} + static_cast<std::int16_t>(value.value()));
}
template <vector T>
T spread(T value) {
  return value;
}

template <class A, class B>
concept operands =
    (vector<A> && vector<B>) || (vector<A> && hls::fixed_integer<B>) || (hls::fixed_integer<A> && vector<B>);

template <class T>
inline constexpr int signed_width = T::width + (traits<T>::is_signed ? 0 : 1);

template <class T>
signed_vector as_signed(T value) {
  if constexpr (traits<T>::is_signed) {
    return value.vector();
  } else {
    return reinterpret_cast<signed_vector>(value.vector());
  }
}

template <vector A, vector B>
auto add(A a, B b) {
  if constexpr (!traits<A>::is_signed && !traits<B>::is_signed) {
    return u<std::max(A::width, B::width) + 1>(a.vector() + b.vector());
  } else {
    return s<std::max(signed_width<A>, signed_width<B>) + 1>(as_signed(a) + as_signed(b));
  }
}

template <vector A, vector B>
auto subtract(A a, B b) {
  constexpr bool both_unsigned = !traits<A>::is_signed && !traits<B>::is_signed;
  constexpr int width =
      both_unsigned ? std::max(A::width, B::width) + 1 : std::max(signed_width<A>, signed_width<B>) + 1;
  return s<width>(as_signed(a) - as_signed(b));
}

/// Lanes of up to 15 bits, or both unsigned.
template <vector A, vector B>
bit less(A a, B b) {
  if constexpr (!traits<A>::is_signed && !traits<B>::is_signed && std::max(A::width, B::width) > 15) {
    return bit(reinterpret_cast<signed_vector>(a.vector() < b.vector()));
  } else {
    static_assert(signed_width<A> <= 16 && signed_width<B> <= 16);
    return bit(as_signed(a) < as_signed(b));
  }
}

template <class A, class B>
  requires operands<A, B>
auto operator+(A a, B b) {
  return add(spread(a), spread(b));
}
template <class A, class B>
  requires operands<A, B>
auto operator-(A a, B b) {
  return subtract(spread(a), spread(b));
}
template <vector A>
auto operator-(A a) {
  return subtract(u<1>(0), a);
}
template <class A, class B>
  requires operands<A, B>
bit operator<(A a, B b) {
  return less(spread(a), spread(b));
}
template <class A, class B>
  requires operands<A, B>
bit operator>(A a, B b) {
  return less(spread(b), spread(a));
}
template <class A, class B>
  requires operands<A, B>
bit operator<=(A a, B b) {
  return !(a > b);
}
template <class A, class B>
  requires operands<A, B>
bit operator>=(A a, B b) {
  return !(a < b);
}
template <class A, class B>
  requires operands<A, B>
bit operator==(A a, B b) {
  return bit(as_signed(spread(a)) == as_signed(spread(b)));
}
/// By a scalar; up to 16 bits in all.
template <int N, int M>
u<N + M> operator*(u<N> a, hls::u<M> b) {
  return u<N + M>(a.vector() * static_cast<std::uint16_t>(b.value()));
}
template <int N>
bit operator==(u<N> a, int b) {
  return a == hls::u<N>(b);
}
template <int N>
bit operator!=(u<N> a, int b) {
  return !(a == b);
}

template <int K, int N>
u<N + K> shl(u<N> value) {
  return u<N + K>(value.vector() << K);
}
template <int K, int N>
s<N + K> shl(s<N> value) {
  return s<N + K>(value.vector() << K);
}
template <int K, int N>
u<N - K> shr(u<N> value) {
  return u<N - K>(value.vector() >> K);
}

template <int K, int N>
s<N - K> shr(s<N> value) {
  return s<N - K>(value.vector() >> K);
}

template <int N>
u<N> abs(s<N> value) {
  const signed_vector sign = value.vector() >> 15;
  return u<N>(reinterpret_cast<unsigned_vector>((value.vector() ^ sign) - sign));
}

template <int N>
u<N> select(bit condition, u<N> a, u<N> b) {
  const auto mask = reinterpret_cast<unsigned_vector>(condition.mask());
  return u<N>((a.vector() & mask) | (b.vector() & ~mask));
}

template <int N>
s<N> select(bit condition, s<N> a, s<N> b) {
  return s<N>((a.vector() & condition.mask()) | (b.vector() & ~condition.mask()));
}

template <int N>
u<N> min(u<N> a, u<N> b) {
  return select(a < b, a, b);
}
template <int N>
u<N> max(u<N> a, u<N> b) {
  return select(a < b, b, a);
}

template <int N, int M>
u<N> sat(u<M> value) {
  return u<N>(select(value > hls::u<N>::max(), u<M>(hls::u<M>(hls::u<N>::max())), value));
}

template <int N>
u<N> to_bits(u<N> value) {
  return value;
}
inline u<1> to_bits(bit value) { return u<1>(value); }

template <class A, class B>
  requires(vector<A> || vector<B> || std::same_as<A, bit> || std::same_as<B, bit>)
auto cat(A high, B low) {
  const auto h = to_bits(high);
  const auto l = to_bits(low);
  constexpr int low_width = decltype(to_bits(low))::width;
  return u<decltype(to_bits(high))::width + low_width>(h.vector() << low_width | l.vector());
}

template <int N>
u<bits_for(N)> popcount(u<N> value) {
  unsigned_vector sum{};
  for (int i = 0; i < N; ++i) sum += value.vector() >> i & 1;
  return u<bits_for(N)>(sum);
}

template <int Q, int N>
u<Q> ratio(u<N> smaller, u<N> larger) {
  static_assert(Q + N <= 16 && Q + 2 * N <= 26);
  using floats = float __attribute__((vector_size(4 * count)));
  using ints = std::int32_t __attribute__((vector_size(4 * count)));
  const signed_vector scaled = as_signed(smaller);
  ints dividend = (__builtin_convertvector(scaled, ints) << Q) - 1;
  dividend &= ~(dividend >> 31);
  ints divisor = __builtin_convertvector(as_signed(larger), ints);
  divisor -= divisor == 0;
  const floats quotient = __builtin_convertvector(dividend, floats) / __builtin_convertvector(divisor, floats);
  return u<Q>(__builtin_convertvector(__builtin_convertvector(quotient, ints), unsigned_vector));
}

template <int W, std::size_t SIZE, int N>
u<W> lookup(const std::array<hls::u<W>, SIZE>& table, u<N> index) {
  unsigned_vector result{};
  for (int i = 0; i < count; ++i) result[i] = table[index.vector()[i]].value();
  return u<W>(result);
}

struct Lanes {
  template <int N>
  using u = lanes::u<N>;
  template <int N>
  using s = lanes::s<N>;
  using bit = lanes::bit;
};

}  // namespace horopter::hls::lanes

namespace horopter::hls {
using lanes::Lanes;
}
