// SPDX-License-Identifier: Apache-2.0
// Indices and pointers in all the ways that once were, or could be, compiled wrongly.
#pragma once

#include <array>
#include <cstdint>
#include <horopter/hls/int.hpp>
#include <horopter/hls/ram.hpp>

namespace kernels {

using horopter::hls::RAM;
using horopter::hls::u;

/// One index into arrays of different sizes, in one object and in several, each used only where it is inside.
class OneIndex {
 public:
  struct In {
    u<4> i;
    u<16> x;
    bool write;
  };
  struct Out {
    u<16> value;
    u<16> sum;
  };
  Out step(const In& in) {
    std::array<std::uint16_t, 4> tiny{7, 8, 9, 10};
    std::array<std::uint16_t, 16> large{};
    large[in.x.value() & 15] = 5;
    std::uint16_t value = 0;
    if (in.i < 4) {
      value = tiny[in.i.value()];
      small_[in.i.value()] = static_cast<std::uint16_t>(in.x.value());
    } else {
      value = large_[in.i.value()];
    }
    if (in.write) large_[in.i.value()] = static_cast<std::uint16_t>(in.x.value());
    return {value, u<16>(large[in.i.value()] + small_[2])};
  }

 private:
  std::array<std::uint16_t, 4> small_{};
  std::array<std::uint16_t, 16> large_{1, 2, 3};
};

/// Pointers into different members at variable places, chosen by a condition; rows walked through by one pointer.
class ChosenPointer {
 public:
  struct In {
    u<3> i, k;
    u<8> x;
    bool which, other;
  };
  struct Out {
    u<8> a, b, c;
  };
  Out step(const In& in) {
    std::uint8_t* p = in.which ? &first_[in.i.value()] : &second_[in.k.value()];
    const std::uint8_t old = *p;
    *p = static_cast<std::uint8_t>(in.x.value());
    std::uint8_t* flat = &grid_[0][0];
    flat[in.i.value() + in.k.value()] ^= static_cast<std::uint8_t>(in.x.value() >> 3);
    const std::uint8_t* q = in.other ? flat + in.k.value() : p;
    const std::array<std::uint8_t, 5>& row = in.other ? grid_[2] : grid_[in.k.value() & 1];
    return {u<8>(old), u<8>(*q), u<8>(row[in.i.value() & 3])};
  }

 private:
  std::array<std::uint8_t, 8> first_{1, 2, 3, 4, 5, 6, 7, 8};
  std::array<std::uint8_t, 8> second_{11, 12, 13};
  std::array<std::array<std::uint8_t, 5>, 3> grid_{};
};

/// An address from the input or from a register. total_ lies in the stage where in.x[2] lies in the input, and no
/// address depends on it.
class ChosenObject {
 public:
  struct In {
    std::array<std::uint8_t, 4> x;
    bool which;
  };
  struct Out {
    u<16> total;
  };
  Out step(const In& in) {
    const std::uint8_t& address = in.which ? in.x[2] : last_;
    const std::uint8_t data = memory_.read(address);
    memory_.write(address, in.x[1]);
    total_ = static_cast<std::uint16_t>(total_ + data);
    last_ = in.x[0];
    return {u<16>(total_)};
  }

 private:
  std::uint8_t last_ = 0;
  std::uint16_t total_ = 0;
  RAM<std::uint8_t, 256, 8> memory_;
};

using Table = std::array<std::array<std::int16_t, 4>, 8>;

constexpr Table made(int factor) {
  Table table{};
  for (int i = 0; i < 32; ++i) {
    table[static_cast<std::size_t>(i / 4)][static_cast<std::size_t>(i % 4)] =
        static_cast<std::int16_t>(i * factor - 100);
  }
  return table;
}

/// A two-dimensional table, rows and columns offset and mirrored.
class Tables {
 public:
  struct In {
    u<3> i;
    u<2> k;
    bool which;
  };
  struct Out {
    std::int16_t a, b, c, d;
  };
  Out step(const In& in) {
    const int i = in.i.value(), k = in.k.value();
    const std::int16_t mirrored =
        i > 0 ? kTable[static_cast<std::size_t>(8 - i)][static_cast<std::size_t>(3 - k)] : std::int16_t{0};
    const std::int16_t before =
        i > 0 ? kTable[static_cast<std::size_t>(i - 1)][static_cast<std::size_t>(k)] : std::int16_t{-1};
    const auto& table = in.which ? kTable : kOther;
    return {kTable[in.i.value()][in.k.value()], mirrored, before, table[in.i.value()][1]};
  }

 private:
  static constexpr Table kTable = made(37), kOther = made(-11);
};

/// Places counted from one before an array, and back from its end, between arrays of the same kind: loads.
class LoadsAroundBegin {
 public:
  struct In {
    std::array<u<3>, 3> i;
    u<8> x;
  };
  struct Out {
    std::uint8_t a, b, c, d;
    std::uint16_t e, f;
  };
  Out step(const In& in) {
    // Each difference is used once: only then LLVM moves its constant behind the variable.
    const std::size_t at = at_[0].value(), other = at_[1].value(), third = at_[2].value();
    const std::uint8_t* const bytes = middle_.data();
    const std::uint16_t* const words = wide_middle_.data();
    const Out out{bytes[at - 1],     (middle_.begin() + at)[-1], *(middle_.end() - at),
                  plain_[third - 1], words[other - 1],           *(wide_middle_.end() - at)};
    for (std::size_t i = 3; i > 0; --i) {
      before_[i] = before_[i - 1];
      middle_[i] = middle_[i - 1];
      plain_[i] = plain_[i - 1];
      wide_before_[i] = wide_before_[i - 1];
      wide_middle_[i] = wide_middle_[i - 1];
      wide_behind_[i] = wide_behind_[i - 1];
    }
    before_[0] = static_cast<std::uint8_t>(~in.x.value());
    middle_[0] = static_cast<std::uint8_t>(in.x.value());
    plain_[0] = static_cast<std::uint8_t>(in.x.value() ^ 0x55);
    wide_before_[0] = static_cast<std::uint16_t>(in.x.value() + 1000);
    wide_middle_[0] = static_cast<std::uint16_t>(in.x.value() * 3);
    wide_behind_[0] = static_cast<std::uint16_t>(in.x.value() * 5);
    for (std::size_t i = 0; i < 3; ++i) at_[i] = in.i[i] < 1 ? u<3>(1) : in.i[i] > 4 ? u<3>(4) : in.i[i];
    return out;
  }

 private:
  std::array<u<3>, 3> at_{1, 2, 3};  // 1 to 4, which hlsc does not see
  std::array<std::uint8_t, 4> before_{}, middle_{};
  std::uint8_t plain_[4] = {};
  std::array<std::uint16_t, 4> wide_before_{}, wide_middle_{}, wide_behind_{};
};

/// The same with stores.
class StoresAroundBegin {
 public:
  struct In {
    u<3> i, k;
    u<8> x;
  };
  struct Out {
    std::array<std::uint8_t, 4> before, middle;
    std::array<std::uint16_t, 4> wide_before, wide_middle, wide_behind;
  };
  Out step(const In& in) {
    const std::size_t at = at_.value(), other = other_.value();
    const auto x = static_cast<std::uint8_t>(in.x.value());
    std::uint8_t* const bytes = middle_.data();
    std::uint16_t* const words = wide_middle_.data();
    bytes[at - 1] = x;
    *(before_.end() - other) = static_cast<std::uint8_t>(x + 1);
    words[other - 1] = static_cast<std::uint16_t>(x * 3);
    *(wide_before_.end() - at) = static_cast<std::uint16_t>(x * 5);
    (wide_behind_.begin() + at)[-1] = static_cast<std::uint16_t>(x * 7);
    at_ = in.i < 1 ? u<3>(1) : in.i > 4 ? u<3>(4) : in.i;
    other_ = in.k < 1 ? u<3>(1) : in.k > 4 ? u<3>(4) : in.k;
    return {before_, middle_, wide_before_, wide_middle_, wide_behind_};
  }

 private:
  u<3> at_ = 1, other_ = 2;  // 1 to 4
  std::array<std::uint8_t, 4> before_{}, middle_{};
  std::array<std::uint16_t, 4> wide_before_{}, wide_middle_{}, wide_behind_{};
};

struct alignas(8) PaddedEntry {
  std::uint8_t value;
  std::uint16_t wide;
};

/// A table with padding, whose entries are copied whole, twice, beside another table.
class PaddedTable {
 public:
  struct In {
    u<4> i, k;
  };
  struct Out {
    u<8> a, b;
    u<16> wide, other;
  };
  Out step(const In& in) {
    const Out out{u<8>(first_.value), u<8>(second_.value), u<16>(second_.wide), u<16>(kOthers[in.i.value()])};
    first_ = kEntries[in.i.value()];
    second_ = kEntries[in.k.value()];
    return out;
  }

 private:
  static constexpr std::array<PaddedEntry, 16> kEntries = [] {
    std::array<PaddedEntry, 16> entries{};
    for (std::size_t i = 0; i < 16; ++i) {
      entries[i].value = static_cast<std::uint8_t>(i * 7 + 1);
      entries[i].wide = static_cast<std::uint16_t>(i * 999);
    }
    return entries;
  }();
  static constexpr std::array<std::uint64_t, 16> kOthers{100, 7,    300, 5,    500,  600, 9,    800,
                                                         900, 1000, 1,   1200, 1300, 77,  1500, 1600};
  PaddedEntry first_{}, second_{};
};

}  // namespace kernels
