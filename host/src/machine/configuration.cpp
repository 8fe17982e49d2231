// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/configuration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "horopter/base/error.hpp"
#include "horopter/hls/area.hpp"
#include "horopter/machine/registers.hpp"
#include "horopter/machine/setting_registers.hpp"
#include "horopter/map/support.hpp"
#include "stages/pipeline.hpp"

namespace horopter {
namespace {

namespace reg = registers;

/// Of discs as wide as this, and all that are wider, both rules show more than the half that is an alarm; px of the result.
constexpr double kSmallestDisc_px = [] {
  double smallest_px = 0;
#define DISC(diameter_px, thesis, compete)    \
  if (!((thesis) > 0.5 && (compete) > 0.5)) { \
    smallest_px = 0;                          \
  } else if (smallest_px == 0) {              \
    smallest_px = (diameter_px);              \
  }
#include "horopter/machine/disc_table.def"
#undef DISC
  return smallest_px;
}();
static_assert(kSmallestDisc_px > 0);

/// Reads of MAP_STATUS before an upload that does not end is given up.
constexpr int kStatusPolls = 100'000;

constexpr std::array<std::string_view, 7> kUploadErrors = {
    "none",      "slot or region in use", "bad header",        "does not fit the pool",
    "wrong CRC", "no such slot",          "data without start"};

void check_settings(const CompeteSettings& settings) {
  for (const auto& f : kCompeteFields) {
    if (const int value = settings.*f.setting; value < 0 || value > f.largest()) {
      throw UsageError(fmt::format("{} {}; expected 0 to {}", f.name, value, f.largest()));
    }
  }
}

/// Of the result, of the largest frame.
std::int64_t pixels_of_frame(const MachineProfile& profile) {
  return std::int64_t{profile.width / profile.subsample} * profile.height;
}

void add_limits(std::vector<RegisterWord>& words, const MachineProfile& profile, const Settings& settings,
                FrameGeometry geometry) {
  const double largest_sum = 15.0 * profile.dsad_window * profile.dsad_window;
  const double incoming = static_cast<double>(geometry.width) * geometry.height;
  const double result = incoming / profile.subsample;
  const auto number = [](int value) { return static_cast<std::uint32_t>(value); };
  const std::uint32_t area = object_area_limit(settings);
  const std::array limits{
      RegisterWord{reg::sum_limit::kAddress, limit_of(settings.threshold_percent, largest_sum)},
      RegisterWord{reg::self_limit::kAddress, limit_of(settings.self_percent, largest_sum)},
      RegisterWord{reg::texture_limit::kAddress, number(native::Settings::texture_limit_for(settings.texture))},
      RegisterWord{reg::alarm_limit::kAddress, limit_of(settings.alarm_percent, result)},
      RegisterWord{
          reg::object_limit::kAddress,
          static_cast<std::uint32_t>(area != 0 ? pixels_of_frame(profile) + 1 : object_limit(settings, profile))},
      RegisterWord{reg::object_area_limit::kAddress, area != 0 ? area : reg::object_area_limit::kReset},
      blocks_word(settings.blind),
      RegisterWord{reg::unsupervised_limit::kAddress, limit_of(settings.unsupervised_percent, result)},
      RegisterWord{reg::black_limit::kAddress, limit_of(settings.dark_percent, incoming)},
      RegisterWord{reg::white_limit::kAddress, limit_of(settings.bright_percent, incoming)},
      RegisterWord{reg::frozen_limit::kAddress, number(settings.frozen_limit)},
      RegisterWord{reg::one_camera::kAddress, number(settings.one_camera_segments)},
      RegisterWord{reg::blind_step::kAddress, number(settings.blind_step)},
      RegisterWord{reg::blind_share::kAddress, number(settings.blind_share)},
      RegisterWord{reg::still_limit::kAddress, number(settings.still_limit)}};
  words.insert(words.end(), limits.begin(), limits.end());
}

/// REGISTRATION.on_skin and on_skin_cells: more on the skin than this is too much for no alarm. What is just too small for
/// an alarm has twice its share of the pixels at most, as places and cells are where there is texture; and some are wrong.
std::uint32_t on_skin_limits(const MachineProfile& profile, const Settings& settings, FrameGeometry geometry) {
  constexpr double kWrong = 1.0 / 8;
  const double result = 1.0 * geometry.width / profile.subsample * geometry.height;
  const double allowed =
      std::min(static_cast<double>(object_limit(settings, profile)) / result, settings.alarm_percent / 100);
  const auto limited = [](double value, std::uint32_t most) {
    return static_cast<std::uint32_t>(std::min(std::ceil(value), 1.0 * most));
  };
  const auto most_cells = reg::registration::kOnSkinCells.mask() >> reg::registration::kOnSkinCells.lsb;
  const int cell = profile.cell();
  return reg::registration::kOnSkin.put(limited(32 * (kWrong + 2 * allowed), stages::on_skin_limit_never)) |
         reg::registration::kOnSkinCells.put(limited(2 * allowed * result / (4 * cell * cell), most_cells));
}

void add_proof(std::vector<RegisterWord>& words, const Proof& proof, std::uint32_t on_skin_limits) {
  const auto rounded = [](double value, int bits) {
    return static_cast<std::uint32_t>(std::clamp(std::lround(std::ldexp(value, bits)), -32768L, 32767L));
  };
  const hls::StageSettings defaults;
  words.push_back({reg::agreement::kAddress,
                   reg::agreement::kProve.put(proof.needed) | reg::agreement::kNearerBelow.put(proof.nearer_below) |
                       reg::agreement::kNearerAbove.put(proof.nearer_above) |
                       reg::agreement::kShiftLowest.put(static_cast<std::uint32_t>(proof.shift_lowest)) |
                       reg::agreement::kShiftHighest.put(static_cast<std::uint32_t>(proof.shift_highest)) |
                       reg::agreement::kUnprovenSkin.put(defaults.unproven_skin_limit)});
  // Not what the machine holds: an upset there would be written anew, and no longer be a fault.
  words.push_back(
      {reg::agreement_limits::kAddress, (reg::agreement_limits::kReset & ~reg::agreement_limits::kHidden.mask()) |
                                            reg::agreement_limits::kHidden.put(limit_of(proof.hidden_percent, 255))});
  words.push_back({reg::hidden::kAddress, reg::hidden::kFrames.put(static_cast<std::uint32_t>(proof.hidden_frames))});
  // Without a rig nobody knows where the right image should be.
  const auto limit = [](bool known, const reg::Field& field, int value) {
    return field.put(known ? static_cast<std::uint32_t>(value) : field.mask() >> field.lsb);
  };
  words.push_back({reg::registration::kAddress,
                   limit(proof.registered, reg::registration::kMoved, defaults.moved_limit) |
                       limit(proof.registered, reg::registration::kMovedHalf, defaults.moved_half_limit) |
                       limit(proof.at_full_resolution, reg::registration::kPatches, defaults.patch_limit) |
                       on_skin_limits});
  words.push_back({reg::epipolar::kAddress, reg::epipolar::kSlope.put(rounded(proof.epipolar[0], 15)) |
                                                reg::epipolar::kColumn.put(rounded(proof.epipolar[1], 20))});
  words.push_back(
      {reg::epipolar_change::kAddress, reg::epipolar_change::kRow.put(rounded(proof.epipolar[2], 20)) |
                                           reg::epipolar_change::kBoth.put(rounded(proof.epipolar[3], 24))});
}

RegisterWord interlock_word(const Interlock& interlock) {
  if (interlock.frames < 1 || interlock.frames > 15) {
    throw UsageError(fmt::format("a restart after {} good frames is not possible; expected 1 to 15", interlock.frames));
  }
  return {reg::interlock::kAddress, reg::interlock::kByItself.put(interlock.by_itself) |
                                        reg::interlock::kByPin.put(interlock.by_pin) |
                                        reg::interlock::kByRegister.put(interlock.by_register) |
                                        reg::interlock::kFrames.put(static_cast<std::uint32_t>(interlock.frames))};
}

RegisterWord alarm_frames_word(const AlarmFrames& frames) {
  if (!frames.possible()) {
    throw UsageError(fmt::format("an alarm by {} of {} frames is not possible; expected at most {} of {}",
                                 frames.needed, frames.of, AlarmFrames::kMost, AlarmFrames::kMost));
  }
  return {reg::alarm_frames::kAddress, reg::alarm_frames::kNeeded.put(static_cast<std::uint32_t>(frames.needed)) |
                                           reg::alarm_frames::kOf.put(static_cast<std::uint32_t>(frames.of))};
}

RegisterWord timeout_word(Device& device, const MachineProfile& profile, const Settings& settings) {
  std::uint32_t clocks = usual_timeout_clocks(profile);
  if (settings.results_per_s) {
    const double per_s = 1e3 * reg::build_clock::kKhz.get(device.read(reg::build_clock::kAddress));
    clocks = static_cast<std::uint32_t>(std::clamp(std::ceil(2 / *settings.results_per_s * per_s), 1.0, 4294967295.0));
  }
  return {reg::timeout::kAddress, clocks};
}

RegisterWord feedback_word(Device& device, double feedback_ms) {
  const double clocks = feedback_ms * reg::build_clock::kKhz.get(device.read(reg::build_clock::kAddress));
  if (!(clocks >= 0 && clocks < 4294967295.0)) {
    throw UsageError(fmt::format("contactors that take {} ms cannot be supervised", feedback_ms));
  }
  return {reg::feedback::kAddress, static_cast<std::uint32_t>(std::ceil(clocks))};
}

}  // namespace

AlarmFrames AlarmFrames::parse(const std::string& text) {
  AlarmFrames frames;
  const char* const end = text.data() + text.size();
  const auto needed = std::from_chars(text.data(), end, frames.needed);
  const bool slash = needed.ec == std::errc() && needed.ptr != end && *needed.ptr == '/';
  const auto of = slash ? std::from_chars(needed.ptr + 1, end, frames.of) : needed;
  if (!slash || of.ec != std::errc() || of.ptr != end || !frames.possible()) {
    throw UsageError(
        fmt::format("'{}'; expected N/M, N of the last M frames, 1 <= N <= M <= {}, as in 2/3", text, kMost));
  }
  return frames;
}

std::int64_t object_limit(const Settings& settings, const MachineProfile& profile) {
  const std::int64_t frame = pixels_of_frame(profile);
  if (!(settings.object_px >= 0)) throw UsageError(fmt::format("an object of {} px across", settings.object_px));
  if (settings.object_px == 0) return frame + 1;
  const double disc = std::numbers::pi / 4 * settings.object_px * settings.object_px;
  const int px_of_image = profile.subsample * profile.fields_per_image();  // in a pixel of the result
  return std::clamp<std::int64_t>(std::llround(disc / 2 / px_of_image), 1, frame + 1);
}

double half_disc_mm2(const Settings& settings) {
  return std::numbers::pi / 8 * settings.object_mm * settings.object_mm;
}

std::uint32_t object_area_limit(const Settings& settings) {
  if (!(settings.object_mm >= 0)) throw UsageError(fmt::format("an object of {} mm across", settings.object_mm));
  if (settings.object_mm == 0) return 0;
  const double steps = std::floor(half_disc_mm2(settings) * hls::area_steps_per_mm2);  // a table's areas are no smaller
  if (!(steps >= 1 && steps < reg::object_area_limit::kReset)) {
    throw UsageError(
        fmt::format("an object of {:g} mm across has no area that the machine can compare with", settings.object_mm));
  }
  return static_cast<std::uint32_t>(steps);
}

double object_area_limit_mm2(const Settings& settings) {
  return object_area_limit(settings) / double{hls::area_steps_per_mm2};
}

double smallest_object_px(const MachineProfile& profile) { return kSmallestDisc_px * profile.subsample; }

double smallest_object_px() {
  return smallest_object_px(*std::ranges::min_element(profiles(), {}, &MachineProfile::subsample));
}

std::uint32_t usual_timeout_clocks(const MachineProfile& profile) {
  return 2 * static_cast<std::uint32_t>(profile.width * profile.height);
}

std::string register_name(std::uint32_t address) {
  const auto found = std::ranges::find(reg::kRegisters, address, &reg::Register::address);
  std::string name(found->name);
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

void write_checked(Device& device, const RegisterWord& word) {
  device.write(word.address, word.value);
  if (const auto found = device.read(word.address); found != word.value) {
    throw DeviceError(fmt::format("{} reads back as {:#x}; expected {:#x}, as written", register_name(word.address),
                                  found, word.value));
  }
}

RegisterWord blocks_word(const BlindSettings& blind) {
  return {reg::blocks::kAddress, reg::blocks::kWatch.put(blind.watch) | reg::blocks::kTeach.put(blind.teach) |
                                     reg::blocks::kMargin.put(static_cast<std::uint32_t>(blind.margin)) |
                                     reg::blocks::kDim.put(blind.dim)};
}

std::vector<RegisterWord> configuration(Device& device, const MachineProfile& profile, const Settings& settings,
                                        FrameGeometry geometry) {
  std::vector<RegisterWord> words{{reg::width::kAddress, static_cast<std::uint32_t>(geometry.width)},
                                  {reg::height::kAddress, static_cast<std::uint32_t>(geometry.height)},
                                  {reg::lookahead::kAddress, static_cast<std::uint32_t>(geometry.lookahead)}};
  words.push_back(interlock_word(settings.interlock));
  words.push_back(alarm_frames_word(settings.alarm_frames));
  words.push_back(feedback_word(device, settings.interlock.feedback_ms));
  words.push_back({reg::mode::kAddress, reg::mode::kLive.put(settings.live)});
  words.push_back(timeout_word(device, profile, settings));
  // What a driver left in these would stay for ever.
  words.push_back({reg::black_level::kAddress, reg::black_level::kReset});
  words.push_back({reg::white_level::kAddress, reg::white_level::kReset});
  words.push_back({reg::constant_limit::kAddress, reg::constant_limit::kReset});
  add_limits(words, profile, settings, geometry);
  add_proof(words, settings.proof, on_skin_limits(profile, settings, geometry));
  const bool compete = settings.decision == Decision::compete;
  words.push_back({reg::decision::kAddress, reg::decision::kCompete.put(compete ? 1 : 0)});
  if (compete) {
    check_settings(settings.competition);
    words.push_back({reg::compete::kAddress, compete_word(settings.competition)});
  }
  return words;
}

std::uint32_t undecidable_limit(const MapTable& table, const Settings& settings) {
  return limit_of(settings.undecidable_percent, static_cast<double>(supported_pixels(table, settings.decision)));
}

std::uint32_t upload_table(Device& device, int slot, std::size_t base_word64, const MapTable& table,
                           std::uint32_t undecidable_limit) {
  write_checked(device, {reg::map_slot::kAddress, static_cast<std::uint32_t>(slot)});
  write_checked(device, {reg::map_base::kAddress, static_cast<std::uint32_t>(base_word64)});
  write_checked(device, {reg::map_undecidable_limit::kAddress, undecidable_limit});
  device.write(reg::map_control::kAddress, reg::map_control::kStart.put(1));
  // A place that is in use is refused by the header.
  const std::span<const std::uint32_t> words(table.words());
  device.write_all(reg::map_data::kAddress, words.first(hls::table::header_words));
  if (reg::map_status::kError.get(device.read(reg::map_status::kAddress)) == kUploadInUse) return kUploadInUse;
  device.write_all(reg::map_data::kAddress, words.subspan(hls::table::header_words));

  std::uint32_t status = device.read(reg::map_status::kAddress);
  for (int poll = 0; reg::map_status::kBusy.get(status) != 0; ++poll) {
    if (poll == kStatusPolls) throw DeviceError(fmt::format("the upload of table {} does not end", slot));
    status = device.read(reg::map_status::kAddress);
  }
  if (const auto error = reg::map_status::kError.get(status); error != 0) return error;
  if ((device.read(reg::map_valid::kAddress) >> slot & 1U) == 0 || device.read(reg::map_crc::kAddress) != table.crc()) {
    throw DeviceError(fmt::format("table {} is not in the machine after its upload", slot));
  }
  return 0;
}

std::string_view upload_error_text(std::uint32_t error) {
  return error < kUploadErrors.size() ? kUploadErrors[error] : "unknown error";
}

}  // namespace horopter
