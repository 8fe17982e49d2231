// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <horopter/hls/int.hpp>
#include <horopter/hls/kept.hpp>

namespace kernels {

using horopter::hls::s;
using horopter::hls::u;

class Adder {
 public:
  struct In {
    u<8> a, b;
  };
  struct Out {
    u<9> sum;
  };
  Out step(const In& in) { return {in.a + in.b}; }
};

class Accumulator {
 public:
  struct In {
    s<6> x;
    bool clear;
  };
  struct Config {
    u<3> shift;
  };
  struct Out {
    bool valid;
    s<12> sum;
    u<4> count;
  };
  Out step(const In& in, const Config& config) {
    if (in.clear) {
      sum_ = s<12>(0);
      count_ = u<4>(3);
    }
    sum_ += in.x;
    count_ += u<1>(1);
    return {count_.bit(0), s<12>(sum_.value() >> config.shift.value()), count_};
  }

 private:
  s<12> sum_ = s<12>(-5);
  u<4> count_ = u<4>(3);
};

/// The last value and what reset does not forget: a total.
class Kept {
 public:
  struct In {
    u<8> x;
  };
  struct Out {
    u<8> last;
    u<12> total;
  };
  Out step(const In& in) {
    const Out out{last_, *total_};
    last_ = in.x;
    *total_ += in.x;
    return out;
  }

 private:
  u<8> last_{7};
  horopter::hls::Kept<u<12>> total_;
};

}  // namespace kernels
