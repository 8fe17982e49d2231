// SPDX-License-Identifier: Apache-2.0
#include "horopter/hls/int.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <random>

using namespace horopter::hls;

namespace {

// Reference values in 128 bits, where nothing overflows.
__extension__ typedef __int128 wide;

template <class T>
wide exact(T value) {
  return static_cast<wide>(value.value());
}

template <class T>
wide wrapped(wide value) {
  const wide modulus = static_cast<wide>(1) << width_of<T>;
  wide low = value % modulus;
  if (low < 0) low += modulus;
  if (is_signed_v<T> && low >= modulus / 2) low -= modulus;
  return low;
}

template <class A, class B>
void check_pair(std::uint64_t a_bits, std::uint64_t b_bits) {
  const A a(a_bits);
  const B b(b_bits);
  REQUIRE(exact(a) == wrapped<A>(static_cast<wide>(a_bits)));
  REQUIRE(exact(A(b)) == wrapped<A>(exact(b)));
  if constexpr (std::max(width_of<A>, width_of<B>) <= 61) {
    REQUIRE(exact(a + b) == exact(a) + exact(b));
    REQUIRE(exact(a - b) == exact(a) - exact(b));
    REQUIRE(exact(-a) == -exact(a));
  }
  if constexpr (width_of<A> + width_of<B> <= 64) {
    REQUIRE(exact(a * b) == exact(a) * exact(b));
    REQUIRE(exact(cat(a, b)) == (wrapped<u<width_of<A>>>(exact(a)) << width_of<B>)+wrapped<u<width_of<B>>>(exact(b)));
  }
  REQUIRE((a == b) == (exact(a) == exact(b)));
  REQUIRE((a < b) == (exact(a) < exact(b)));
  REQUIRE((a <= b) == (exact(a) <= exact(b)));
  REQUIRE((a > b.value()) == (exact(a) > exact(b)));
  A sum = a;
  sum += b;
  REQUIRE(exact(sum) == wrapped<A>(exact(a) + exact(b)));
  A difference = a;
  difference -= b;
  REQUIRE(exact(difference) == wrapped<A>(exact(a) - exact(b)));
  const wide top = (static_cast<wide>(1) << 5) - 1;
  REQUIRE(exact(sat<5>(a)) == std::clamp<wide>(exact(a), 0, top));
  REQUIRE(exact(~a) == wrapped<A>(-exact(a) - 1));
}

template <class A, class B>
void check(std::mt19937_64& random) {
  for (int i = 0; i < 200; ++i) check_pair<A, B>(random(), random());
  for (const std::uint64_t a :
       {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}, std::uint64_t{1} << (width_of<A> - 1)})
    for (const std::uint64_t b :
         {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}, std::uint64_t{1} << (width_of<B> - 1)})
      check_pair<A, B>(a, b);
}

template <class A>
void check_all(std::mt19937_64& random) {
  check<A, u<1>>(random);
  check<A, u<8>>(random);
  check<A, s<8>>(random);
  check<A, s<1>>(random);
  check<A, u<31>>(random);
  check<A, s<32>>(random);
  check<A, u<32>>(random);
  check<A, s<33>>(random);
  check<A, u<64>>(random);
  check<A, s<64>>(random);
}

}  // namespace

TEST_CASE("integers of any width agree with 128-bit arithmetic", "[int]") {
  std::mt19937_64 random(2026);
  check_all<u<1>>(random);
  check_all<s<1>>(random);
  check_all<u<5>>(random);
  check_all<s<11>>(random);
  check_all<u<16>>(random);
  check_all<s<16>>(random);
  check_all<u<31>>(random);
  check_all<s<32>>(random);
  check_all<u<33>>(random);
  check_all<s<61>>(random);
  check_all<u<64>>(random);
  check_all<s<64>>(random);
}

TEST_CASE("results have the width that holds every value", "[int]") {
  STATIC_REQUIRE(std::same_as<decltype(u<8>() + u<3>()), u<9>>);
  STATIC_REQUIRE(std::same_as<decltype(u<8>() - u<3>()), s<9>>);
  STATIC_REQUIRE(std::same_as<decltype(s<8>() + u<8>()), s<10>>);
  STATIC_REQUIRE(std::same_as<decltype(s<8>() * u<8>()), s<16>>);
  STATIC_REQUIRE(std::same_as<decltype(u<8>() * u<3>()), u<11>>);
  STATIC_REQUIRE(std::same_as<decltype(lit<9>()), u<4>>);
  STATIC_REQUIRE(std::same_as<decltype(lit<-8>()), s<4>>);
  STATIC_REQUIRE(std::is_convertible_v<u<8>, s<9>>);
  STATIC_REQUIRE(!std::is_convertible_v<u<8>, s<8>>);
  STATIC_REQUIRE(!std::is_convertible_v<u<9>, u<8>>);
  STATIC_REQUIRE(!std::is_convertible_v<s<8>, u<8>>);
}

TEST_CASE("slices, shifts and absolute values", "[int]") {
  const u<12> value(0xABC);
  REQUIRE(value.bits<11, 8>() == 0xA);
  REQUIRE(value.bits<7, 0>() == 0xBC);
  REQUIRE(value.bit(2));
  REQUIRE(!value.bit(0));
  REQUIRE(shl<4>(value) == 0xABC0);
  REQUIRE(shr<4>(value) == 0xAB);
  REQUIRE((value << u<2>(3)) == 0xABC * 8);
  REQUIRE((value >> u<4>(8)) == 0xA);
  REQUIRE(shr<1>(s<8>(-3)) == -2);
  REQUIRE(shl<1>(s<8>(-128)) == -256);
  REQUIRE(abs(s<8>(-128)) == 128);
  REQUIRE(abs(s<64>(std::int64_t{-5})) == 5);
  REQUIRE(cat(true, u<3>(2), s<2>(-1)) == 0b101011);
  REQUIRE((u<4>(12) & u<2>(3)) == 0);
  REQUIRE((u<4>(12) | u<2>(3)) == 15);
  REQUIRE((u<4>(12) ^ u<4>(5)) == 9);
}
