// SPDX-License-Identifier: Apache-2.0
// SlicedMemory<W, N, DISTANCE>: as RAM<u<W>, N, DISTANCE>, in memories of 2 bits side by side.
//
// For deep memories. Of wide words a block memory of an FPGA does not hold all: several stand one behind the other, and
// a multiplexer chooses behind their slow outputs. Of words of 2 bits an ECP5's holds 8,192.
#pragma once

#include "horopter/hls/int.hpp"
#include "horopter/hls/ram.hpp"

namespace horopter::hls {

template <int W, std::size_t N, std::size_t DISTANCE>
class SlicedMemory {
 public:
  void begin_step() {
    low_.begin_step();
    high_.begin_step();
  }
  /// RAM::read.
  template <class Address>
  u<W> read(const Address& address) {
    return cat(high_.read(address), low_.read(address));
  }
  /// RAM::write.
  template <class Address>
  void write(const Address& address, u<W> word) {
    low_.write(address, word.template bits<1, 0>());
    high_.write(address, word.template bits<W - 1, 2>());
  }

 private:
  RAM<u<2>, N, DISTANCE> low_;
  SlicedMemory<W - 2, N, DISTANCE> high_;
};

template <int W, std::size_t N, std::size_t DISTANCE>
  requires(W <= 2)
class SlicedMemory<W, N, DISTANCE> : public RAM<u<W>, N, DISTANCE> {};

}  // namespace horopter::hls
