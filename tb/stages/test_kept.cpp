// SPDX-License-Identifier: Apache-2.0
// What a stage keeps over a reset counts here: neither the reset nor what stands on the inputs during it may change it.
#include <catch2/catch.hpp>
#include <memory>

#include "horopter/tb/stage_bench.hpp"
#include "kernels/adder.hpp"

std::unique_ptr<horopter::tb::DutModel> make_tb_contents(std::uint64_t seed);

namespace horopter::tb {
namespace {

TEST_CASE("registers that reset keeps are not written during it") {
  const auto model = make_tb_contents(1);
  Dut& dut = model->dut("horopter_kept");
  Rng rng{"kept"};
  RandomStimulus stimulus{Rng{rng.next()}, dut};
  BenchOptions options;
  options.beats = 20'000;
  options.reset_one_in = 100;
  const BenchReport report = run_stage_bench<kernels::Kept>(*model, dut, stimulus, rng, options);
  CHECK(report.failure == "");
  CHECK(report.resets > 100);
}

}  // namespace
}  // namespace horopter::tb
