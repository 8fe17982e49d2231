// SPDX-License-Identifier: Apache-2.0
// The bench of one batch of random programs. The including file defines HOROPTER_BATCH(bench) as one bench(P<seed>) a
// program, and the name of the model's factory as HOROPTER_MODEL.
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "horopter/tb/stage_bench.hpp"

std::unique_ptr<horopter::tb::DutModel> HOROPTER_MODEL(std::uint64_t seed);

namespace {

template <class Program>
bool bench(horopter::tb::DutModel& model, const char* name, std::uint64_t beats) {
  const std::uint64_t seed = std::strtoull(name + 1, nullptr, 10);  // P<seed>
  horopter::tb::Rng rng{seed};
  horopter::tb::Dut& dut = model.dut(std::string{"horopter_"} + name);
  horopter::tb::RandomStimulus stimulus{horopter::tb::Rng{rng.next()}, dut};
  horopter::tb::BenchOptions options;
  options.beats = beats;
  options.reset_one_in = 2'000;
  options.config_one_in = 1'000;
  const horopter::tb::BenchReport report = horopter::tb::run_stage_bench<Program>(model, dut, stimulus, rng, options);
  std::printf("%s %s beats=%llu outputs=%llu clocks=%llu resets=%llu in_flight=%llu %s\n", name,
              report.failure.empty() ? "ok" : "FAILED", static_cast<unsigned long long>(report.beats),
              static_cast<unsigned long long>(report.outputs), static_cast<unsigned long long>(report.clocks),
              static_cast<unsigned long long>(report.resets), static_cast<unsigned long long>(report.resets_in_flight),
              report.failure.c_str());
  std::fflush(stdout);
  return report.failure.empty();
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t beats = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 20'000;
  const auto model = HOROPTER_MODEL(1);
  bool good = true;
#define HOROPTER_BENCH(program) good = bench<horopter::random_programs::program>(*model, #program, beats) && good;
  HOROPTER_BATCH(HOROPTER_BENCH)
  return good ? 0 : 1;
}
