// SPDX-License-Identifier: Apache-2.0
// RAM<T, N, DISTANCE>: a member of a stage that becomes one synchronous memory of N words, one read and one write port.
//
// Contract, per step: at most one read address and one write address (exclusive branches may differ: hlsc multiplexes
// them). A read sees the contents before the step, or what an earlier write of the same step put there. A read of an
// address is in the same step as a write of it, or at least DISTANCE steps after: the pipeline has that much time between
// read and write. Reads may follow each other as they like. All words are zero at power-up; T{} must be all zeros. Reset keeps the contents.
// A step cannot assign, copy or swap a RAM.
//
// The native class checks addresses, ports and distance, unless HOROPTER_HLS_UNCHECKED is defined. It takes a new step
// to begin when an access cannot belong to the current one (a second read or write address, or any access after both a
// read and a write of which it repeats one). A stage whose step may leave out accesses calls begin_step() first, which
// makes this exact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "horopter/hls/kept.hpp"

#ifdef __HLSC__
// Hooks that hlsc replaces by ports of a memory. `bytes` is sizeof(T).
extern "C" {
void __hlsc_ram_init(void* ram, const void* initial, unsigned long bytes) noexcept;
void __hlsc_ram_read(void* ram, unsigned long address, void* data, unsigned long bytes) noexcept;
void __hlsc_ram_write(void* ram, unsigned long address, const void* data, unsigned long bytes) noexcept;
}
#endif

namespace horopter::hls {

/// A use of a RAM that the hardware could not follow: distance, address or number of ports.
struct hazard_error : std::logic_error {
  using std::logic_error::logic_error;
};

namespace detail {

template <typename A>
constexpr std::size_t ram_address(const A& address) {
  if constexpr (std::is_integral_v<A>) {
    return static_cast<std::size_t>(address);
  } else {
    return static_cast<std::size_t>(address.value());
  }
}

}  // namespace detail

template <typename T, std::size_t N, std::size_t DISTANCE>
class RAM {
  static_assert(std::is_trivially_copyable_v<T>, "a RAM word is copied bit by bit");
  static_assert(N >= 1, "a RAM has at least one word");
  static_assert(DISTANCE >= 1, "two accesses of one address cannot be closer than one step");

 public:
  using value_type = T;
  static constexpr std::size_t depth = N;
  static constexpr std::size_t distance = DISTANCE;

#ifdef __HLSC__
  RAM() {
    T initial{};
    __hlsc_ram_init(this, &initial, sizeof(T));
  }
  RAM(const RAM&) = delete("a RAM cannot be copied: hardware has no clock in which all its words move");
  RAM& operator=(const RAM&) = delete("a RAM cannot be assigned: hardware has no clock in which all its words move");
  void begin_step() {}
  template <typename A>
  T read(const A& address) {
    T data;
    __hlsc_ram_read(this, detail::ram_address(address), &data, sizeof(T));
    return data;
  }
  template <typename A>
  void write(const A& address, const T& data) {
    __hlsc_ram_write(this, detail::ram_address(address), &data, sizeof(T));
  }

 private:
  unsigned char identity_;  // never read or written: its address names the memory
#else
  RAM() : words_(N) {}
  RAM(const RAM&) = default;
  RAM(RAM&&) noexcept = default;
  ~RAM() = default;
  RAM& operator=(const RAM& other) {
    if (this != &other && !detail::keep_contents()) words_ = other.words_;
    forget_accesses();
    return *this;
  }
  RAM& operator=(RAM&& other) noexcept {
    if (this != &other && !detail::keep_contents()) words_ = std::move(other.words_);
    forget_accesses();
    return *this;
  }

  /// Tells the checks that a new step begins. No hardware.
  void begin_step() {
#ifndef HOROPTER_HLS_UNCHECKED
    explicit_steps_ = true;
    next_step();
#endif
  }

  /// The word before this step, or what this step has written there. `address` < N. Valid until a write: copy it, as the
  /// hardware does.
  template <typename A>
  const T& read(const A& address) {
    const std::size_t a = detail::ram_address(address);
    check(a, read_address_, write_address_);
    check_distance(a);
    return words_[a];
  }

  template <typename A>
  void write(const A& address, const T& data) {
    const std::size_t a = detail::ram_address(address);
    check(a, write_address_, kNone);
#ifndef HOROPTER_HLS_UNCHECKED
    if (last_write_.empty()) last_write_.assign(N, kNever);
    last_write_[a] = step_;
#endif
    words_[a] = data;
  }

  /// A read and a write of a word where it stands: on the CPU large words need not be copied.
  template <typename A>
  T& change(const A& address) {
    const std::size_t a = detail::ram_address(address);
#ifndef HOROPTER_HLS_UNCHECKED
    write(a, T(read(a)));
#endif
    return words_[a];
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  void forget_accesses() noexcept {
    last_write_.clear();
    read_address_ = write_address_ = kNone;
    step_ = 0;
  }

  void next_step() {
    ++step_;
    read_address_ = write_address_ = kNone;
  }

  /// `port`: the address this step has used on the port of this access. `forwarded`: for a read, the address written.
  void check([[maybe_unused]] std::size_t a, [[maybe_unused]] std::size_t& port,
             [[maybe_unused]] std::size_t forwarded) {
#ifndef HOROPTER_HLS_UNCHECKED
    if (a >= N) {
      throw hazard_error("RAM address " + std::to_string(a) + " of " + std::to_string(N) + " words");
    }
    if (port != kNone && (port != a || !explicit_steps_)) {
      if (explicit_steps_)
        throw hazard_error("two addresses on one port of a RAM in one step: " + std::to_string(port) + ", " +
                           std::to_string(a));
      next_step();
    } else if (!explicit_steps_ && forwarded != kNone && forwarded != a) {
      next_step();
    }
    port = a;
#endif
  }

  void check_distance([[maybe_unused]] std::size_t a) {
#ifndef HOROPTER_HLS_UNCHECKED
    if (last_write_.empty()) return;
    const std::uint64_t last = last_write_[a];
    if (last != kNever && last != step_ && step_ - last < DISTANCE) {
      throw hazard_error("RAM address " + std::to_string(a) + " read " + std::to_string(step_ - last) +
                         " steps after its write, DISTANCE is " + std::to_string(DISTANCE));
    }
#endif
  }

  static constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

  std::vector<T> words_;
  std::vector<std::uint64_t> last_write_;
  std::uint64_t step_ = 0;
  std::size_t read_address_ = kNone, write_address_ = kNone;
  bool explicit_steps_ = false;
#endif
};

}  // namespace horopter::hls
