// SPDX-License-Identifier: Apache-2.0
// Seeded randomness: one seed a run (environment HOROPTER_SEED, printed with every failure), one generator a purpose.
#pragma once

#include <cstdint>
#include <string_view>

namespace horopter::tb {

/// The run's seed: HOROPTER_SEED, or 1.
std::uint64_t session_seed();

/// SplitMix64: small, fast, and the same on every platform (the standard distributions are not).
class Rng {
 public:
  explicit Rng(std::uint64_t seed) : state_{seed} {}
  /// A generator of its own for each named purpose, so that adding one does not change the others.
  explicit Rng(std::string_view purpose) : state_{session_seed()} {
    for (const char c : purpose) state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    next();
  }

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// 0 … n-1, n > 0.
  std::uint64_t below(std::uint64_t n) { return static_cast<std::uint64_t>((static_cast<Wide>(next()) * n) >> 64); }
  /// low … high, both included.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low) + 1));
  }
  bool chance(unsigned one_in) { return below(one_in) == 0; }
  bool percent(unsigned p) { return below(100) < p; }

 private:
  __extension__ using Wide = unsigned __int128;
  std::uint64_t state_;
};

/// When a handshake signal is high: the three shapes in which streams stutter.
class Pace {
 public:
  enum class Kind { always, periodic, random };
  Pace() = default;
  /// `on` clocks high, then `off` clocks low.
  static Pace periodic(unsigned on, unsigned off) { return Pace{Kind::periodic, on, off, 0}; }
  /// High in `percent` of the clocks.
  static Pace random(unsigned percent, std::uint64_t seed) { return Pace{Kind::random, percent, 0, seed}; }

  bool next() {
    switch (kind_) {
      case Kind::always:
        return true;
      case Kind::periodic: {
        const bool high = phase_ < on_;
        if (++phase_ == on_ + off_) phase_ = 0;
        return high;
      }
      case Kind::random:
        return rng_.percent(on_);
    }
    return true;
  }

 private:
  Pace(Kind kind, unsigned on, unsigned off, std::uint64_t seed) : kind_{kind}, on_{on}, off_{off}, rng_{seed} {}
  Kind kind_ = Kind::always;
  unsigned on_ = 1, off_ = 0, phase_ = 0;
  Rng rng_{std::uint64_t{0}};
};

}  // namespace horopter::tb
