// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/machine_build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "horopter/base/error.hpp"
#include "horopter/machine/registers.hpp"

namespace horopter {
namespace {

namespace reg = registers;

void check_identity(Device& device) {
  if (const auto id = device.read(reg::id::kAddress); id != reg::id::kValueValue) {
    throw DeviceError(fmt::format("no Horopter: its ID is {:08x} instead of {:08x}", id, reg::id::kValueValue));
  }
  const auto version = device.read(reg::version::kAddress);
  const auto major = reg::version::kMajor.get(version);
  const auto minor = reg::version::kMinor.get(version);
  if (major != reg::version::kMajorValue || minor < reg::version::kMinorValue) {
    throw DeviceError(fmt::format(
        "register map {}.{}; expected {}.{} or a later {}.x, of this program: make the machine and the program "
        "from the same sources",
        major, minor, reg::version::kMajorValue, reg::version::kMinorValue, reg::version::kMajorValue));
  }
}

struct BuildWords {
  std::uint32_t size = 0;
  std::uint32_t store = 0;
  std::uint32_t window = 0;
  std::uint32_t competition = 0;
};

BuildWords read_words(Device& device) {
  check_identity(device);
  return {device.read(reg::build_size::kAddress), device.read(reg::build_store::kAddress),
          device.read(reg::build_window::kAddress), device.read(reg::build_compete::kAddress)};
}

/// What is other than the profile; nothing where it fits.
std::optional<std::string> difference(const BuildWords& words, const MachineProfile& profile) {
  std::optional<std::string> found;
  const auto must_be = [&](const char* what, std::uint32_t value, int expected) {
    if (!found && value != static_cast<std::uint32_t>(expected)) {
      found = fmt::format("{} {} instead of {}", what, value, expected);
    }
  };
  const auto at_most = [&](const char* what, std::uint32_t value, int largest) {
    if (!found && value > static_cast<std::uint32_t>(largest)) {
      found = fmt::format("{} {} instead of at most {}", what, value, largest);
    }
  };
  must_be("width", reg::build_size::kWidth.get(words.size), profile.width);
  must_be("height", reg::build_size::kHeight.get(words.size), profile.height);
  must_be("store rows", reg::build_store::kRows.get(words.store), profile.store_rows);
  at_most("pool KiB", reg::build_store::kPoolKib.get(words.store), profile.pool_bytes / 1024);
  must_be("DSAD window", reg::build_window::kDsad.get(words.window), profile.dsad_window);
  must_be("majority window", reg::build_window::kMajority.get(words.window), profile.majority_window);
  must_be("sub-sampling", reg::build_window::kSubsample.get(words.window), profile.subsample);
  must_be("weight bits", reg::build_window::kWeightBits.get(words.window), profile.weight_bits);
  must_be("hypotheses", reg::build_window::kHypotheses.get(words.window), profile.hypotheses);
  const auto thesis = reg::build_window::kThesis.get(words.window);
  const auto compete = reg::build_window::kCompete.get(words.window);
  at_most("rule `thesis`", thesis, profile.has_thesis() ? 1 : 0);
  at_most("rule `compete`", compete, profile.has_compete() ? 1 : 0);
  const auto of_compete = [&](int value) { return compete != 0 ? value : 0; };
  must_be("competing planes", reg::build_compete::kPlanes.get(words.competition), of_compete(profile.planes));
  must_be("rows of the sum", reg::build_compete::kSumRows.get(words.competition), of_compete(profile.sum_rows));
  must_be("columns of the sum", reg::build_compete::kSumColumns.get(words.competition),
          of_compete(profile.sum_columns));
  must_be("reach of the ballot", reg::build_compete::kBallotReach.get(words.competition),
          of_compete(profile.ballot_reach));
  must_be("paths", reg::build_compete::kPaths.get(words.competition), of_compete(profile.paths ? 1 : 0));
  return found;
}

Build build_of(const BuildWords& words, const MachineProfile& profile) {
  return {&profile, std::size_t{1024} * reg::build_store::kPoolKib.get(words.store),
          reg::build_window::kThesis.get(words.window) != 0, reg::build_window::kCompete.get(words.window) != 0,
          reg::build_window::kBlind.get(words.window) != 0};
}

}  // namespace

Build check_build(Device& device, const MachineProfile& profile) {
  const BuildWords words = read_words(device);
  if (const auto found = difference(words, profile)) {
    throw DeviceError(fmt::format("the machine is not one of profile {}: {}", profile.name, *found));
  }
  return build_of(words, profile);
}

Build find_build(Device& device) {
  const BuildWords words = read_words(device);
  const auto fitting = std::ranges::find_if(profiles(), [&](const auto& p) { return !difference(words, p); });
  if (fitting == profiles().end()) {
    throw DeviceError(fmt::format(
        "the machine takes images of {}x{} px, but is none of the profiles {}; expected one "
        "that was made from this program's sources",
        reg::build_size::kWidth.get(words.size), reg::build_size::kHeight.get(words.size), profile_names()));
  }
  return build_of(words, *fitting);
}

void check_rule(const Build& build, Decision decision) {
  check_decision(*build.profile, decision);
  const bool wants_compete = decision == Decision::compete;
  if (wants_compete ? build.compete : build.thesis) return;
  const Decision other = wants_compete ? Decision::thesis : Decision::compete;
  throw UsageError(
      fmt::format("this machine of profile {} is built without the decision '{}'; choose '{}', or build "
                  "the machine with it",
                  build.profile->name, name_of(decision), name_of(other)));
}

void check_blind(const Build& build) {
  if (build.blind) return;
  throw UsageError(fmt::format(
      "this machine of profile {} is built without the stage `blind`: it cannot learn what goes blind; build it with BLIND = 1",
      build.profile->name));
}

Image result_image(Device& device) {
  const auto subsample = std::max(1U, reg::build_window::kSubsample.get(device.read(reg::build_window::kAddress)));
  const auto width = static_cast<int>(reg::width::kPx.get(device.read(reg::width::kAddress)) / subsample);
  return {width, static_cast<int>(reg::height::kRows.get(device.read(reg::height::kAddress)))};
}

}  // namespace horopter
