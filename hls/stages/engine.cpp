// SPDX-License-Identifier: Apache-2.0
#include "stages/engine.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>

namespace horopter::native {

using Make = std::unique_ptr<Engine>(std::string_view profile_name, int threads);
Make make_engine_baseline, make_engine_avx2, make_engine_avx512;  // engine_instructions.cpp

namespace {

struct Build {
  Instructions instructions;
  std::string_view name;
  Make* make;
  bool (*runs)();
};

constexpr auto kBuilds = std::to_array<Build>({
    {Instructions::baseline, "baseline", make_engine_baseline, [] { return true; }},
#ifdef HOROPTER_WIDE_VECTORS
    {Instructions::avx2, "avx2", make_engine_avx2,
     [] {
       return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") &&
              __builtin_cpu_supports("popcnt");
     }},
    {Instructions::avx512, "avx512", make_engine_avx512,
     [] {
       return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") &&
              __builtin_cpu_supports("popcnt") && __builtin_cpu_supports("avx512f") &&
              __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
              __builtin_cpu_supports("avx512vl");
     }},
#endif
});

const Build& choose(std::optional<Instructions> instructions) {
  const char* const forced = std::getenv("HOROPTER_INSTRUCTIONS");
  const bool by_name = !instructions && forced != nullptr && *forced != '\0';
  for (auto build = kBuilds.rbegin(); build != kBuilds.rend(); ++build) {
    if (instructions && build->instructions != *instructions) continue;
    if (by_name && build->name != forced) continue;
    if (build->runs()) return *build;
  }
  throw std::invalid_argument("the native engine or this processor does not have the instructions " +
                              std::string(by_name ? forced : name_of(*instructions)));
}

constexpr int kMostThreads = 16;  // that find something to do

int threads_of(Threads otherwise) {
  const char* const said = std::getenv("HOROPTER_THREADS");
  if (said == nullptr || *said == '\0') {
    return otherwise == threads_live ? static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 2U)) : 1;
  }
  char* end = nullptr;
  const long threads = std::strtol(said, &end, 10);
  if (*end != '\0' || threads < 1 || threads > kMostThreads) {
    throw std::invalid_argument("HOROPTER_THREADS is " + std::string(said) + ", not 1 to " +
                                std::to_string(kMostThreads));
  }
  return static_cast<int>(threads);
}

}  // namespace

std::string_view name_of(Instructions instructions) {
  switch (instructions) {
    case Instructions::baseline:
      return "baseline";
    case Instructions::avx2:
      return "avx2";
    case Instructions::avx512:
      return "avx512";
  }
  return "";
}

std::vector<Instructions> available_instructions() {
  std::vector<Instructions> available;
  for (const Build& build : kBuilds) {
    if (build.runs()) available.push_back(build.instructions);
  }
  return available;
}

std::unique_ptr<Engine> make_engine(std::string_view profile_name, int threads,
                                    std::optional<Instructions> instructions) {
  return choose(instructions).make(profile_name, threads > 0 ? threads : threads_of(static_cast<Threads>(threads)));
}

}  // namespace horopter::native
