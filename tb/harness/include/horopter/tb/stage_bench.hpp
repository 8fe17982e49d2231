// SPDX-License-Identifier: Apache-2.0
// A native stage class against its emitted module: the same beats into both, every output compared in every bit and in
// its clock, with gaps (valid_i low), stalls (en_i low), changes of the configuration and resets in mid-stream.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "horopter/tb/dut.hpp"
#include "horopter/tb/native_stage.hpp"
#include "horopter/tb/random.hpp"

namespace horopter::tb {

/// What a stage is fed with.
class Stimulus {
 public:
  virtual ~Stimulus() = default;
  /// After a reset.
  virtual void restart() {}
  virtual void next(Beat& in) = 0;
  virtual void config(Beat& config) = 0;
};

/// Random values of given widths, in episodes: uniform, near the ends of the range, small, slowly rising, or held;
/// single bits with a probability that changes from episode to episode.
class RandomLeaves {
 public:
  RandomLeaves(Rng rng, const std::vector<DutPort>& ports);
  void next(Beat& values);

 private:
  enum class Kind { uniform, ends, small, ramp, held };
  struct Episode {
    unsigned width = 0;
    Kind kind = Kind::uniform;
    unsigned remaining = 0;
    unsigned ones_in_256 = 128;
    std::uint64_t last = 0;
  };
  std::uint64_t next(Episode& episode);
  Rng rng_;
  std::vector<Episode> episodes_;
};

/// Random values for every input: for stages that keep no rules.
class RandomStimulus : public Stimulus {
 public:
  RandomStimulus(Rng rng, const Dut& dut) : in_{Rng{rng.next()}, dut.in_ports}, config_{rng, dut.config_ports} {}
  void next(Beat& in) override { in_.next(in); }
  void config(Beat& config) override { config_.next(config); }

 private:
  RandomLeaves in_, config_;
};

struct BenchOptions {
  std::uint64_t beats = 100'000;
  unsigned reset_one_in = 20'000;  ///< clocks
  unsigned config_one_in = 5'000;  ///< clocks
};

struct BenchReport {
  std::uint64_t beats = 0, outputs = 0, clocks = 0, stalls = 0, gaps = 0, resets = 0, resets_in_flight = 0;
  std::string failure;  ///< empty: bit-exact
};

/// `native` and `settled`: two stages of the class of `dut`, as constructed.
BenchReport run_stage_bench(DutModel& model, Dut& dut, NativeStage& native, NativeStage& settled, Stimulus& stimulus,
                            Rng rng, const BenchOptions& options);

template <class Stage>
BenchReport run_stage_bench(DutModel& model, Dut& dut, Stimulus& stimulus, Rng rng, const BenchOptions& options) {
  NativeStageOf<Stage> native, settled;
  return run_stage_bench(model, dut, native, settled, stimulus, rng, options);
}

}  // namespace horopter::tb
