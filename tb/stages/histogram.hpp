// SPDX-License-Identifier: Apache-2.0
// A stage whose memory addresses come with the data, so that only the data can keep the memory's DISTANCE.
#pragma once

#include "horopter/hls/int.hpp"
#include "horopter/hls/ram.hpp"

namespace horopter::tb {

/// Counts values. Two beats of one value must be at least 4 apart.
class Histogram {
 public:
  struct In {
    hls::u<6> value;
  };
  struct Out {
    hls::u<16> count;  ///< of this value, this beat included
  };

  Out step(const In& in) {
    counts_.begin_step();
    const hls::u<16> count(counts_.read(in.value) + hls::lit<1>());
    counts_.write(in.value, count);
    return {count};
  }

 private:
  hls::RAM<hls::u<16>, 64, 4> counts_;
};

}  // namespace horopter::tb
