// SPDX-License-Identifier: Apache-2.0
// One emitted module against its native class, bit by bit, on random input with gaps, stalls and resets.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "horopter/tb/raster_stimulus.hpp"
#include "stages/chain.hpp"

namespace horopter::tb {

/// A reset must not part a beat's writes to memories: none is in flight where they take the stages from 1 to the last.
inline bool can_reset_in_flight(const Dut& dut) {
  const auto by_stage = [](const auto& a, const auto& b) { return a.write_stage < b.write_stage; };
  if (dut.latency == 1) return false;
  if (dut.memories.empty()) return true;
  const auto [first, last] = std::minmax_element(dut.memories.begin(), dut.memories.end(), by_stage);
  return first->write_stage == last->write_stage || first->write_stage > 1 || last->write_stage + 1 < dut.latency;
}

/// `make(seed)`: the model that holds the module. `longest_row`: beats.
template <class Stage, class Make>
void check_stage(const Make& make, const std::string& module, unsigned longest_row, unsigned beats) {
  Rng rng{module.substr(module.find('_') + 1)};  // by the stage's name
  const auto model = make(rng.next());
  Dut& dut = model->dut(module);
  RasterStimulus stimulus{Rng{rng.next()}, dut, hls::min_row_beats, longest_row};
  BenchOptions options;
  options.beats = beats;
  const BenchReport report = run_stage_bench<Stage>(*model, dut, stimulus, rng, options);
  CAPTURE(report.clocks, report.beats, report.outputs, report.gaps, report.stalls, report.resets,
          report.resets_in_flight);
  CHECK(report.failure == "");
  // What the bench claims to have tried, it has.
  CHECK(report.beats >= beats / 6 * 5);
  CHECK(report.outputs >= 100);
  CHECK(report.gaps >= 1'000);
  CHECK(report.stalls >= 1'000);
  CHECK((report.resets_in_flight >= 1 || !can_reset_in_flight(dut)));
}

}  // namespace horopter::tb
