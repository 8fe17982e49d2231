// SPDX-License-Identifier: Apache-2.0
// Every emitted stage of one profile (HOROPTER_TB_PROFILE) against its native class, bit by bit.
#include <catch2/catch.hpp>
#include <memory>
#include <string>

#include "horopter/tb/raster_stimulus.hpp"
#include "stage_headers.hpp"

#define HOROPTER_TB_JOIN_(a, b) a##b
#define HOROPTER_TB_JOIN(a, b) HOROPTER_TB_JOIN_(a, b)
#define HOROPTER_TB_TEXT_(a) #a
#define HOROPTER_TB_TEXT(a) HOROPTER_TB_TEXT_(a)
#define HOROPTER_TB_MAKE_MODEL HOROPTER_TB_JOIN(make_tb_stages_, HOROPTER_TB_PROFILE)

std::unique_ptr<horopter::tb::DutModel> HOROPTER_TB_MAKE_MODEL(std::uint64_t seed);

namespace {

constexpr horopter::hls::Profile kProfile = horopter::hls::profiles::HOROPTER_TB_PROFILE;

template <class Stage>
void bench(const std::string& name) {
  using namespace horopter::tb;
  Rng rng{name};
  const auto model = HOROPTER_TB_MAKE_MODEL(rng.next());
  Dut& dut = model->dut("horopter_" + name);
  RasterStimulus stimulus{Rng{rng.next()}, dut, horopter::hls::min_row_beats,
                          static_cast<unsigned>(kProfile.result_width())};
  BenchOptions options;
  options.beats = 120'000;
  const BenchReport report = run_stage_bench<Stage>(*model, dut, stimulus, rng, options);
  CAPTURE(report.clocks, report.beats, report.outputs, report.gaps, report.stalls, report.resets,
          report.resets_in_flight);
  CHECK(report.failure == "");
  // What the bench claims to have tried, it has.
  CHECK(report.beats >= 100'000);
  CHECK(report.outputs >= 100);
  CHECK(report.gaps >= 1'000);
  CHECK(report.stalls >= 1'000);
  CHECK((dut.latency == 1 || report.resets_in_flight >= 1));
}

}  // namespace

#define HOROPTER_STAGE(name, Class)                                                 \
  TEST_CASE(HOROPTER_TB_TEXT(HOROPTER_TB_PROFILE) " " #name ": emitted = native") { \
    bench<horopter::stages::Class<kProfile>>(#name);                                \
  }
#include "stages/stage_list.def"
#undef HOROPTER_STAGE
