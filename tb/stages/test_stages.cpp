// SPDX-License-Identifier: Apache-2.0
// Every emitted stage of one profile (HOROPTER_TB_PROFILE) against its native class, bit by bit.
#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <type_traits>

#include "stage_case.hpp"

#define HOROPTER_TB_JOIN_(a, b) a##b
#define HOROPTER_TB_JOIN(a, b) HOROPTER_TB_JOIN_(a, b)
#define HOROPTER_TB_TEXT_(a) #a
#define HOROPTER_TB_TEXT(a) HOROPTER_TB_TEXT_(a)
#define HOROPTER_TB_MAKE_MODEL HOROPTER_TB_JOIN(make_tb_stages_, HOROPTER_TB_PROFILE)

std::unique_ptr<horopter::tb::DutModel> HOROPTER_TB_MAKE_MODEL(std::uint64_t seed);

namespace {

constexpr horopter::hls::Profile kProfile = horopter::hls::profiles::HOROPTER_TB_PROFILE;

struct NotBuilt {};

template <class Stage>
void bench(const std::string& name) {
  if constexpr (std::is_same_v<Stage, NotBuilt>) {
    SUCCEED(name << " is not in this profile");
  } else {
    const bool takes_many_rows = name == "objects" || name == "blind";
    horopter::tb::check_stage<Stage>(HOROPTER_TB_MAKE_MODEL, "horopter_" + name,
                                     static_cast<unsigned>(kProfile.result_width()),
                                     takes_many_rows ? 1'000'000 : 120'000);
  }
}

}  // namespace

#define HOROPTER_STAGE(name, Class, rule, place)                                                                     \
  TEST_CASE(HOROPTER_TB_TEXT(HOROPTER_TB_PROFILE) " " #name ": emitted = native") {                                  \
    bench<std::conditional_t<kProfile.has(horopter::hls::Rule::rule), horopter::stages::Class<kProfile>, NotBuilt>>( \
        #name);                                                                                                      \
  }
#include "stages/stage_list.def"
