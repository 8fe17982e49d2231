// SPDX-License-Identifier: Apache-2.0
// Data that violate a memory's DISTANCE stop the native class, and the emitted module in simulation.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <memory>
#include <vector>

#include "histogram.hpp"
#include "horopter/tb/stage_bench.hpp"
#include "horopter/verilated/stop.hpp"

std::unique_ptr<horopter::tb::DutModel> make_tb_contents(std::uint64_t seed);

namespace horopter::tb {
namespace {

/// Values of which none comes again within 4 beats.
class Apart : public Stimulus {
 public:
  explicit Apart(Rng rng) : rng_{rng} {}
  void next(Beat& in) override {
    std::uint64_t value = 0;
    do {
      value = rng_.below(8);
    } while (std::find(recent_.begin(), recent_.end(), value) != recent_.end());
    recent_[next_++ % recent_.size()] = value;
    in.assign(1, value);
  }
  void config(Beat& config) override { config.clear(); }

 private:
  Rng rng_;
  std::array<std::uint64_t, 3> recent_{~std::uint64_t{0}, ~std::uint64_t{0}, ~std::uint64_t{0}};
  unsigned next_ = 0;
};

/// Beats one after another; the counts that come out.
std::vector<std::uint64_t> emitted(const std::vector<std::uint64_t>& values) {
  const auto model = make_tb_contents(1);
  Dut& dut = model->dut("horopter_histogram");
  std::vector<std::uint64_t> counts;
  const auto edge = [&] {
    *dut.clock = 0;
    model->eval();
    *dut.clock = 1;
    model->eval();
  };
  *dut.enable = *dut.valid_in = *dut.reset_n = 0;
  edge();
  *dut.reset_n = *dut.enable = 1;
  for (std::size_t n = 0; n < values.size() + dut.latency; ++n) {
    *dut.valid_in = n < values.size();
    dut.in[0] = static_cast<std::uint32_t>(n < values.size() ? values[n] : 0);
    edge();
    if (*dut.valid_out) counts.push_back(dut.out[0] & 0xffff);
  }
  return counts;
}

TEST_CASE("a memory whose DISTANCE the data keep is exact") {
  const auto model = make_tb_contents(1);
  Rng rng{"histogram"};
  Apart stimulus{Rng{rng.next()}};
  const BenchReport report =
      run_stage_bench<Histogram>(*model, model->dut("horopter_histogram"), stimulus, rng, BenchOptions{});
  CHECK(report.failure == "");
  CHECK(emitted({5, 1, 2, 3, 5, 1, 2, 3, 5}) == std::vector<std::uint64_t>{1, 1, 1, 1, 2, 2, 2, 2, 3});
}

TEST_CASE("data that violate a DISTANCE stop the native class") {
  for (const unsigned apart : {1U, 2U, 3U}) {
    CAPTURE(apart);
    Histogram histogram;
    CHECK(histogram.step({5}).count == 1);
    for (unsigned other = 1; other < apart; ++other) histogram.step({other});
    CHECK_THROWS_AS(histogram.step({5}), hls::hazard_error);
  }
}

TEST_CASE("data that violate a DISTANCE so that the pipeline would be wrong trip the emitted assertion") {
  CHECK_THROWS_WITH(emitted({1, 2, 5, 5, 3, 4}), Catch::Contains("horopter_histogram.sv"));
}

}  // namespace
}  // namespace horopter::tb
