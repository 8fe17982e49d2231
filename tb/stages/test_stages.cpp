// SPDX-License-Identifier: Apache-2.0
// Every emitted stage of one profile (HOROPTER_TB_PROFILE) against its native class, bit by bit.
#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <type_traits>

#include "horopter/tb/raster_stimulus.hpp"
#include "stages/chain.hpp"

#define HOROPTER_TB_JOIN_(a, b) a##b
#define HOROPTER_TB_JOIN(a, b) HOROPTER_TB_JOIN_(a, b)
#define HOROPTER_TB_TEXT_(a) #a
#define HOROPTER_TB_TEXT(a) HOROPTER_TB_TEXT_(a)
#define HOROPTER_TB_MAKE_MODEL HOROPTER_TB_JOIN(make_tb_stages_, HOROPTER_TB_PROFILE)

std::unique_ptr<horopter::tb::DutModel> HOROPTER_TB_MAKE_MODEL(std::uint64_t seed);

namespace {

constexpr horopter::hls::Profile kProfile = horopter::hls::profiles::HOROPTER_TB_PROFILE;

struct NotBuilt {};

/// A reset must not part a beat's writes to memories: none is in flight where they take the stages from 1 to the last.
bool can_reset_in_flight(const horopter::tb::Dut& dut) {
  const auto by_stage = [](const auto& a, const auto& b) { return a.write_stage < b.write_stage; };
  if (dut.latency == 1) return false;
  if (dut.memories.empty()) return true;
  const auto [first, last] = std::minmax_element(dut.memories.begin(), dut.memories.end(), by_stage);
  return first->write_stage == last->write_stage || first->write_stage > 1 || last->write_stage + 1 < dut.latency;
}

template <class Stage>
void bench(const std::string& name) {
  using namespace horopter::tb;
  if constexpr (std::is_same_v<Stage, NotBuilt>) {
    SUCCEED(name << " is not in this profile");
    return;
  } else {
    Rng rng{name};
    const auto model = HOROPTER_TB_MAKE_MODEL(rng.next());
    Dut& dut = model->dut("horopter_" + name);
    RasterStimulus stimulus{Rng{rng.next()}, dut, horopter::hls::min_row_beats,
                            static_cast<unsigned>(kProfile.result_width())};
    BenchOptions options;
    options.beats = name == "objects" || name == "blind" ? 1'000'000 : 120'000;  // what it does takes many rows
    const BenchReport report = run_stage_bench<Stage>(*model, dut, stimulus, rng, options);
    CAPTURE(report.clocks, report.beats, report.outputs, report.gaps, report.stalls, report.resets,
            report.resets_in_flight);
    CHECK(report.failure == "");
    // What the bench claims to have tried, it has.
    CHECK(report.beats >= 100'000);
    CHECK(report.outputs >= 100);
    CHECK(report.gaps >= 1'000);
    CHECK(report.stalls >= 1'000);
    CHECK((report.resets_in_flight >= 1 || !can_reset_in_flight(dut)));
  }
}

}  // namespace

#define HOROPTER_STAGE(name, Class, rule, place)                                                                     \
  TEST_CASE(HOROPTER_TB_TEXT(HOROPTER_TB_PROFILE) " " #name ": emitted = native") {                                  \
    bench<std::conditional_t<kProfile.has(horopter::hls::Rule::rule), horopter::stages::Class<kProfile>, NotBuilt>>( \
        #name);                                                                                                      \
  }
#include "stages/stage_list.def"
