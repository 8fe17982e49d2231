// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "horopter/base/error.hpp"
#include "horopter/hls/area.hpp"
#include "horopter/machine/configuration.hpp"
#include "horopter/machine/inspection.hpp"
#include "horopter/machine/loader.hpp"
#include "horopter/machine/machine_build.hpp"
#include "horopter/machine/regions.hpp"
#include "horopter/machine/registers.hpp"

namespace horopter {
namespace {

namespace reg = registers;

constexpr int kSlots = hls::table::slots;
static_assert(static_cast<int>(reg::kNoSlot) == kSlots);
/// Reads of FRAME_SEQUENCE before a machine that has sent all its states counts as broken.
constexpr int kStatusPolls = 100'000;
constexpr int kTripPolls = 1000;
constexpr int kTablePolls = 1'000'000;  // a frame may stand between

/// What left the machine must agree with itself and with the registers: a machine that contradicts itself is broken.
void check_consistent(const FrameStreams& streams, const FrameResult& result, int width, int height) {
  if (streams.states.width != width || streams.states.height != height) {
    throw DeviceError(fmt::format("the machine gave states of {}x{} pixels instead of {}x{}", streams.states.width,
                                  streams.states.height, width, height));
  }
  std::array<std::int64_t, 4> counts{};
  for (const std::uint8_t state : streams.states.pixels) ++counts[state & 3U];
  if (counts[1] != result.skin_pixels || counts[2] != result.undecidable_pixels ||
      counts[3] != result.unsupervised_pixels) {
    throw DeviceError(fmt::format("the machine's counts {}, {}, {} are not those of its states, {}, {}, {}",
                                  result.skin_pixels, result.undecidable_pixels, result.unsupervised_pixels, counts[1],
                                  counts[2], counts[3]));
  }
  int row = 0;
  int column = 0;
  for (const Run& run : streams.runs) {
    if (run.row != row || run.start != column || run.end < run.start || run.end >= width || row >= height) {
      throw DeviceError(fmt::format("the machine's run {}:{}-{} does not continue at {}:{}", run.row, run.start,
                                    run.end, row, column));
    }
    const auto pixels = streams.states.row(row).subspan(run.start, run.end - run.start + 1);
    if (std::ranges::any_of(pixels, [&](std::uint8_t s) { return s != static_cast<std::uint8_t>(run.state); })) {
      throw DeviceError(fmt::format("the machine's run {}:{}-{} is not in its states", run.row, run.start, run.end));
    }
    column = run.end + 1;
    if (column == width) {
      column = 0;
      ++row;
    }
  }
  if (row != height) throw DeviceError(fmt::format("the machine's runs end in row {} of {}", row, height));
}

/// So must its objects. Where it could not tell all of them apart (fault `objects`) it may not have the largest.
void check_objects(const FrameResult& result) {
  if (result.faults.has(Fault::objects)) return;
  const std::vector<Region> objects = objects_of(result);
  const std::int64_t largest = objects.empty() ? 0 : objects.front().pixels;
  if (largest != result.largest_object_pixels) {
    throw DeviceError(fmt::format("the machine's largest object has {} pixels; in its states the largest has {}",
                                  result.largest_object_pixels, largest));
  }
  const auto alarming = std::ranges::find_if(objects, [&](const Region& o) { return is_alarm(o, result); });
  if (result.alarm && !result.seen) throw DeviceError("the machine says an alarm, and that the frame shows none");
  if (alarming != objects.end() && !result.seen) {
    throw DeviceError(fmt::format("the machine has an object of {} pixels, {:.0f} mm2, which is an alarm, and no alarm",
                                  alarming->pixels, alarming->area / double{hls::area_steps_per_mm2}));
  }
  // Of several with as many pixels it tells of one.
  const bool same_area = std::ranges::any_of(
      objects, [&](const Region& o) { return o.pixels == largest && o.area == result.largest_object_area; });
  if (result.object_area_limit != 0 && !objects.empty() && !same_area) {
    throw DeviceError(fmt::format("the machine's largest object covers {} of 1/1024 mm2; by the table's areas it is {}",
                                  result.largest_object_area, objects.front().area));
  }
}

}  // namespace

Monitor::Monitor(std::unique_ptr<Device> device, const MachineProfile& profile, const Settings& settings)
    : device_(std::move(device)), profile_(profile), settings_(settings), slots_(kSlots) {
  const Build build = check_build(*device_, profile);
  check_rule(build, settings.decision);
  if (settings.blind.watch || settings.blind.teach) check_blind(build);
  pool_bytes_ = build.pool_bytes;
}

Monitor::~Monitor() {
  try {
    stop();
  } catch (const Error&) {
    // The machine does not answer: there is nothing left to stop.
  }
}

void Monitor::stop() { device_->write(reg::control::kAddress, 0); }

void Monitor::start(int width, int height, int lookahead) {
  stop();
  width_ = width;
  height_ = height;
  sequence_ = 0;
  blind_watch_.emplace(width / profile_.subsample, height, profile_.cell());
  write_checked(*device_, {reg::table_select::kAddress, reg::kNoSlot});
  for (const RegisterWord& word : configuration(*device_, profile_, settings_, {width, height, lookahead})) {
    write_checked(*device_, word);
  }
  device_->write(reg::faults_cameras::kAddress, 0xFFFFFFFFU);
  device_->write(reg::faults_machine::kAddress, 0xFFFFFFFFU);
  device_->write(reg::control::kAddress, reg::control::kEnable.put(1));
  const auto status = device_->read(reg::status::kAddress);
  if (reg::status::kBadGeometry.get(status) != 0) {
    throw DeviceError(
        fmt::format("the machine refuses frames of {}x{} pixels with LOOKAHEAD {}", width, height, lookahead));
  }
}

Agreement Monitor::read_agreement() {
  const auto field = [](const reg::Field& of, std::uint32_t word) { return static_cast<int>(of.get(word)); };
  Agreement result;
  const auto counts = device_->read(reg::frame_agreement::kAddress);
  const auto cells = device_->read(reg::frame_cells::kAddress);
  const auto unproven = device_->read(reg::frame_unproven::kAddress);
  result.textured = field(reg::frame_agreement::kTextured, counts);
  result.explained = field(reg::frame_agreement::kExplained, counts);
  result.supervised = field(reg::frame_cells::kSupervised, cells);
  result.nearer = field(reg::frame_cells::kNearer, cells);
  result.unproven = field(reg::frame_unproven::kCells, unproven);
  result.bad_regions = field(reg::frame_unproven::kBadRegions, unproven);

  // Sums of the upper left, upper right, lower left, lower right quarter.
  std::array<double, 4> sums{};
  std::array<int, 4> measured{};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const auto word = device_->read(reg::frame_across_0::kAddress + 4 * i);
    constexpr int kSign = 1 << (reg::frame_across_0::kSum.bits - 1);
    sums[i] = (field(reg::frame_across_0::kSum, word) ^ kSign) - kSign;
    measured[i] = field(reg::frame_across_0::kCells, word);
  }
  const double px = profile_.cell() / 32.0;
  constexpr int kEnough = 40;
  const auto mean = [&](std::size_t a, std::size_t b) -> std::optional<double> {
    if (measured[a] + measured[b] < kEnough) return std::nullopt;
    return px * (sums[a] + sums[b]) / (measured[a] + measured[b]);
  };
  const auto upper = mean(0, 1);
  const auto lower = mean(2, 3);
  const auto left = mean(0, 2);
  const auto right = mean(1, 3);
  if (upper && lower) {
    result.across_px =
        px * (sums[0] + sums[1] + sums[2] + sums[3]) / (measured[0] + measured[1] + measured[2] + measured[3]);
    result.scale = 1 + (*lower - *upper) / (0.5 * height_);  // the halves' middles are half of the height apart
  }
  if (left && right) {
    constexpr double kDegrees = 57.29577951308232;
    result.roll_deg = kDegrees * (*right - *left) / (0.5 * width_ / profile_.subsample);
  }
  const auto round = device_->read(reg::frame_patches::kAddress);
  result.patches = field(reg::frame_patches::kPlaces, round);
  if (result.patches > 0) {
    constexpr int kSign = 1 << (reg::frame_patches::kAcross.bits - 1);
    result.patches_across_px = ((field(reg::frame_patches::kAcross, round) ^ kSign) - kSign) / (8.0 * result.patches);
  }
  for (std::uint32_t i = 0; i < 2; ++i) {
    const double detail = device_->read(reg::frame_detail_left::kAddress + 4 * i);
    const double contrast = device_->read(reg::frame_contrast_left::kAddress + 4 * i);
    result.sharpness[i] = contrast > 0 ? 4 * detail / contrast : 0;
  }
  for (std::uint32_t i = 0; i < result.regions.size(); ++i) {
    device_->write(reg::region_select::kAddress, i);
    const auto word = device_->read(reg::frame_region::kAddress);
    result.regions[i] = {field(reg::frame_region::kTextured, word), field(reg::frame_region::kExplained, word),
                         field(reg::frame_region::kNearer, word)};
  }
  return result;
}

void Monitor::upload(int slot, const MapTable& table, std::optional<std::size_t> base_word64) {
  if (slot < 0 || slot >= kSlots) throw UsageError(fmt::format("slot {}; expected 0 to {}", slot, kSlots - 1));
  const std::size_t words64 = table.pool_bytes() / 8;
  const std::size_t pool64 = pool_bytes_ / 8;
  // First fit between the other tables; a table of the same slot makes room for its successor.
  std::vector<std::pair<std::size_t, std::size_t>> taken;
  for (int other = 0; other < kSlots; ++other) {
    const Slot& s = slots_[static_cast<std::size_t>(other)];
    if (other != slot && s.words64 != 0) taken.emplace_back(s.base_word64, s.words64);
  }
  std::ranges::sort(taken);
  std::size_t base = 0;
  for (const auto& [begin, length] : taken) {
    if (base + words64 <= begin) break;
    base = begin + length;
  }
  if (base_word64) base = *base_word64;
  if (base + words64 > pool64) {
    throw DeviceError(fmt::format("table {} of {} bytes does not fit the pool of {} bytes beside the others", slot,
                                  words64 * 8, pool_bytes_));
  }
  slots_[static_cast<std::size_t>(slot)] = {};
  if (const auto error = upload_table(*device_, slot, base, table, undecidable_limit(table, settings_)); error != 0) {
    throw DeviceError(fmt::format("the machine refuses table {}: {}", slot, upload_error_text(error)));
  }
  slots_[static_cast<std::size_t>(slot)] = {base, words64, table.facts().areas};
}

void Monitor::teach(bool on) {
  breaks_off_ = false;
  settings_.blind.teach = on;
  write_checked(*device_, blocks_word(settings_.blind));
}

void Monitor::break_off_teaching() {
  if (blind_watch_->taught() == 0) return teach(false);
  trip();
  breaks_off_ = true;
}

void Monitor::trip() { take_safe_away(*device_); }

void take_safe_away(Device& device) {
  const auto slot = reg::map_status::kActiveSlot.get(device.read(reg::map_status::kAddress));
  if (slot == reg::kNoSlot) return;
  device.write(reg::map_slot::kAddress, slot);
  device.write(reg::map_control::kAddress, reg::map_control::kStart.put(1));
  for (int poll = 0; says_safe(device.read(reg::status::kAddress)); ++poll) {
    if (poll == kTripPolls) throw DeviceError("the machine stays safe although it was told not to be");
  }
}

void Monitor::select(int slot) {
  write_checked(*device_, {reg::table_select::kAddress, static_cast<std::uint32_t>(slot)});
}

bool Monitor::shows_again(int shown, const FrameResult& result) const {
  constexpr int kMost = 60;
  if (shown >= kMost || !result.faults.has(Fault::unproven)) return false;
  // A pair that is bad otherwise is not safe, however often it is shown. That it teaches is no badness.
  const std::size_t expected = result.faults.has(Fault::teaching) ? 2 : 1;
  return shown == 1 || result.faults.names().size() == expected;
}

// Delegated, so that the destructor puts back what was written where a later write fails.
Monitor::Repeated::Repeated(Monitor& monitor) : Repeated(monitor, nullptr) { limit(0, 0); }

Monitor::Repeated::~Repeated() {
  try {
    limit(monitor_.settings_.frozen_limit, monitor_.settings_.still_limit);
  } catch (const Error&) {  // it must not go on without them
    try {
      monitor_.stop();
    } catch (const Error&) {
      // The machine does not answer: the next frame says so.
    }
  }
}

void Monitor::Repeated::limit(int frozen, int still) {
  write_checked(*monitor_.device_, {reg::frozen_limit::kAddress, static_cast<std::uint32_t>(frozen)});
  write_checked(*monitor_.device_, {reg::still_limit::kAddress, static_cast<std::uint32_t>(still)});
}

FrameResult Monitor::process(const Image& left, const Image& right) {
  begin(left, right);
  return finish();
}

void Monitor::wait_for_table(int slot) {
  for (int poll = 0; poll < kTablePolls; ++poll) {
    if (static_cast<int>(reg::map_status::kActiveSlot.get(device_->read(reg::map_status::kAddress))) == slot) return;
  }
  throw DeviceError(fmt::format("no frame begins with table {}", slot));
}

void Monitor::begin(const Image& left, const Image& right) {
  if (left.width != width_ || left.height != height_ || right.width != width_ || right.height != height_) {
    throw DeviceError(fmt::format("images of {}x{} and {}x{} pixels for a machine set to {}x{}", left.width,
                                  left.height, right.width, right.height, width_, height_));
  }
  device_->send(left, right);
}

FrameResult Monitor::finish() {
  FrameStreams streams = device_->receive();

  FrameResult result;
  for (int poll = 0;; ++poll) {
    result.sequence = device_->read(reg::frame_sequence::kAddress);
    if (result.sequence != sequence_) break;
    if (poll == kStatusPolls) throw DeviceError("the frame's status is not published although its states came");
  }
  const auto status = device_->read(reg::frame_status::kAddress);
  result.alarm = reg::frame_status::kAlarm.get(status) != 0;
  result.seen = reg::frame_status::kSeen.get(status) != 0;
  result.safe = reg::frame_status::kSafe.get(status) != 0;
  result.table = static_cast<int>(reg::frame_status::kSlot.get(status));
  result.faults = {device_->read(reg::frame_faults_cameras::kAddress),
                   device_->read(reg::frame_faults_machine::kAddress)};
  result.table_crc = device_->read(reg::frame_table_crc::kAddress);
  result.skin_pixels = device_->read(reg::frame_skin::kAddress);
  result.undecidable_pixels = device_->read(reg::frame_undecidable::kAddress);
  result.unsupervised_pixels = device_->read(reg::frame_unsupervised::kAddress);
  result.blind_pixels = device_->read(reg::frame_blind::kAddress);
  result.hidden_pixels = device_->read(reg::frame_hidden::kAddress);
  result.unproven_pixels = device_->read(reg::frame_unproven_pixels::kAddress);
  result.largest_object_pixels = device_->read(reg::frame_object::kAddress);
  result.largest_object_area = device_->read(reg::frame_object_area::kAddress);
  result.object_area_limit = object_area_limit(settings_);
  if (result.table < kSlots) result.areas = slots_[static_cast<std::size_t>(result.table)].areas;
  result.object_limit_pixels = object_limit(settings_, profile_);
  if (result.object_area_limit != 0) {
    std::uint32_t largest = hls::table::unknown_area;
    if (!result.areas.empty()) largest = *std::ranges::max_element(result.areas);
    const std::int64_t of_pixel = hls::area_of(largest).value();
    result.object_limit_pixels = std::max<std::int64_t>(1, (result.object_area_limit + of_pixel - 1) / of_pixel);
  }
  if (settings_.proof.needed) result.agreement = read_agreement();
  result.cycles = device_->read(reg::frame_cycles::kAddress);
  result.latency = device_->read(reg::frame_latency::kAddress);
  result.tail = device_->read(reg::frame_tail::kAddress);
  if (device_->read(reg::frame_sequence::kAddress) != result.sequence) {
    throw DeviceError("the frame's status changed while it was read");
  }
  if (result.sequence != sequence_ + 1) {
    throw DeviceError(fmt::format("frame {} came after frame {}: one is lost", result.sequence, sequence_));
  }
  sequence_ = result.sequence;
  check_consistent(streams, result, width_ / profile_.subsample, height_);
  result.states = std::move(streams.states);
  BlindSettings blind = settings_.blind;
  blind.teach = result.faults.has(Fault::teaching);
  const Faults beside = result.faults.without(Fault::teaching);
  const bool spoiled = beside.any() || result.seen;
  // Before the first frame nothing is known of what both cameras see; later `unproven` says nothing of the images.
  const bool spoils = (sequence_ == 1 ? beside : beside.without(Fault::unproven)).any() || result.seen;
  result.blind = blind_watch_->frame(result.states, blind, spoiled, spoils);
  if (breaks_off_ && blind.teach && spoiled) teach(false);
  if (const auto pixels = std::ranges::count(result.blind, 1); pixels != result.blind_pixels) {
    throw DeviceError(
        fmt::format("the machine has {} blind pixels; by its states, and those that it was taught, there are {}",
                    result.blind_pixels, pixels));
  }
  check_objects(result);
  if (result.seen && !result.alarm && settings_.alarm_frames.needed <= 1) {
    throw DeviceError("the machine says that the frame shows an alarm, and that it is none");
  }
  result.runs = std::move(streams.runs);
  return result;
}

Supervisor::Supervisor(std::unique_ptr<Device> device, const MachineProfile& profile, const MapSet& maps,
                       const Settings& settings)
    : monitor_(std::move(device), profile, settings_for(settings, profile, maps)),
      settled_(!settings.proof.needed || settings.live) {
  for (const CompiledMap& map : maps.maps) scans_.push_back(map.table.geometry());
  monitor_.start(scans_.at(0).width, scans_.at(0).height, maps.lookahead());
  for (std::size_t slot = 0; slot < maps.maps.size(); ++slot) {
    monitor_.upload(static_cast<int>(slot), maps.maps[slot].table);
  }
}

std::vector<FrameResult> Supervisor::process(const Image& left, const Image& right) {
  if (settled_) return pass(left, right);
  settled_ = true;
  pass(left, right);
  const Monitor::Repeated repeated(monitor_);
  auto results = pass(left, right);
  for (int shown = 2; monitor_.shows_again(shown, results.back()); ++shown) results = pass(left, right);
  return results;
}

std::vector<FrameResult> Supervisor::pass(const Image& left, const Image& right) {
  std::vector<FrameResult> results;
  for (std::size_t slot = 0; slot < scans_.size(); ++slot) {
    monitor_.select(static_cast<int>(slot));
    if (scans_[slot].scan == Scan::progressive) {
      results.push_back(monitor_.process(left, right));
    } else {
      const int parity = scans_[slot].first_row();
      results.push_back(monitor_.process(field_of(left, parity), field_of(right, parity)));
    }
    results.back().scan = scans_[slot].scan;
  }
  return results;
}

}  // namespace horopter
