// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/native_device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>

#include "horopter/base/crc32.hpp"
#include "horopter/base/error.hpp"
#include "horopter/machine/configuration.hpp"
#include "horopter/machine/registers.hpp"
#include "horopter/machine/setting_registers.hpp"
#include "stages/engine.hpp"

namespace horopter {
namespace {

namespace reg = registers;

constexpr int kNoTable = reg::kNoSlot;

const reg::Register* find_register(std::uint32_t address) {
  const auto found = std::ranges::find(reg::kRegisters, address, &reg::Register::address);
  return found == reg::kRegisters.end() ? nullptr : &*found;
}

[[noreturn]] void refuse(const char* what, std::uint32_t address) {
  const reg::Register* known = find_register(address);
  throw DeviceError(fmt::format("the machine refuses to {} register {:03x} ({})", what, address,
                                known != nullptr ? known->name : "unknown"));
}

/// A table that maps nothing, for frames without a table.
std::vector<std::uint32_t> empty_table(int width, int height) {
  constexpr int kSpacing = hls::table::largest_spacing_log2;
  return hls::table::write({width, height, kSpacing, kSpacing}, {}, [](int, int) { return hls::table::unmapped; });
}

std::uint32_t pair_of(int low, int high) {
  return static_cast<std::uint32_t>(low) | static_cast<std::uint32_t>(high) << 16;
}

/// FRAME_AGREEMENT to FRAME_PATCHES.
std::array<std::uint32_t, 12> agreement_words(const native::Agreement& a) {
  std::array<std::uint32_t, 12> words{pair_of(a.textured_cells, a.explained_cells),
                                      pair_of(a.supervised_cells, a.nearer_cells),
                                      pair_of(a.unproven_cells, a.bad_region_cells)};
  for (std::size_t i = 0; i < 4; ++i) {
    words[3 + i] = reg::frame_across_0::kSum.put(static_cast<std::uint32_t>(a.across[i])) |
                   reg::frame_across_0::kCells.put(static_cast<std::uint32_t>(a.measured[i]));
  }
  for (std::size_t i = 0; i < 2; ++i) {
    words[7 + i] = static_cast<std::uint32_t>(a.detail[i]);
    words[9 + i] = static_cast<std::uint32_t>(a.contrast[i]);
  }
  words[11] = reg::frame_patches::kPlaces.put(static_cast<std::uint32_t>(a.patch_places)) |
              reg::frame_patches::kAcross.put(static_cast<std::uint32_t>(a.patch_across)) |
              reg::frame_patches::kMoved.put(static_cast<std::uint32_t>(a.patch_moved)) |
              reg::frame_patches::kOnSkin.put(static_cast<std::uint32_t>(a.patches_on_skin));
  return words;
}

/// FRAME_REGION for each REGION_SELECT.
std::array<std::uint32_t, 64> region_words(const native::Agreement& a) {
  std::array<std::uint32_t, 64> words{};
  for (std::size_t i = 0; i < a.regions.size(); ++i) {
    const auto& region = a.regions[i];
    words[i] = reg::frame_region::kTextured.put(static_cast<std::uint32_t>(region.textured)) |
               reg::frame_region::kExplained.put(static_cast<std::uint32_t>(region.explained)) |
               reg::frame_region::kNearer.put(static_cast<std::uint32_t>(region.nearer));
  }
  return words;
}

std::array<std::uint32_t, 3> object_words(const native::Object& object) {
  const auto number = [](int value) { return static_cast<std::uint32_t>(value); };
  return {number(object.pixels),
          reg::frame_object_columns::kLeft.put(number(object.left)) |
              reg::frame_object_columns::kRight.put(number(object.right)),
          reg::frame_object_rows::kTop.put(number(object.top)) |
              reg::frame_object_rows::kBottom.put(number(object.bottom))};
}

native::ImageView view(const Image& image) { return {image.pixels.data(), image.width, image.height, image.width}; }

}  // namespace

NativeDevice::NativeDevice(const MachineProfile& profile, bool live)
    : profile_(profile), live_(live), engine_(new_engine()) {
  if (engine_ == nullptr) throw UsageError(fmt::format("no native engine for profile {}", profile.name));
  const auto defaults = native::Settings::defaults(profile, profile.width, profile.height);
  write_settings(defaults, [this](std::uint32_t address, std::uint32_t word) { stored(address) = word; });
  stored(reg::width::kAddress) = static_cast<std::uint32_t>(profile.width);
  stored(reg::height::kAddress) = static_cast<std::uint32_t>(profile.height);
  stored(reg::lookahead::kAddress) = static_cast<std::uint32_t>(defaults.lookahead);
  stored(reg::timeout::kAddress) = usual_timeout_clocks(profile);
  stored(reg::table_select::kAddress) = kNoTable;
  stored(reg::interlock::kAddress) = reg::interlock::kReset;
  stored(reg::alarm_frames::kAddress) = reg::alarm_frames::kReset;
  stored(reg::map_undecidable_limit::kAddress) = reg::map_undecidable_limit::kReset;
  stored(reg::decision::kAddress) = reg::decision::kCompete.put(profile.has_thesis() ? 0 : 1);
  stored(reg::compete::kAddress) = profile.has_compete() ? reg::compete::kReset : 0;
}

NativeDevice::~NativeDevice() = default;

std::uint32_t& NativeDevice::stored(std::uint32_t address) { return registers_.at(address / 4); }

bool NativeDevice::geometry_is_possible() const {
  const auto width = static_cast<int>(registers_[reg::width::kAddress / 4]);
  const auto height = static_cast<int>(registers_[reg::height::kAddress / 4]);
  const auto lookahead = static_cast<int>(registers_[reg::lookahead::kAddress / 4]);
  return width <= profile_.width && width >= hls::table::smallest_result_width * profile_.subsample &&
         width % profile_.subsample == 0 && height <= profile_.height && height >= hls::table::smallest_height &&
         lookahead <= profile_.largest_lookahead();
}

bool NativeDevice::running() const {
  return reg::control::kEnable.get(registers_[reg::control::kAddress / 4]) != 0 && geometry_is_possible();
}

bool NativeDevice::in_use(int slot) const {
  const auto selected = static_cast<int>(registers_[reg::table_select::kAddress / 4]);
  return running() && slot != kNoTable && (slot == selected || slot == active_slot_) &&
         tables_.at(static_cast<std::size_t>(slot)).has_value();
}

std::uint32_t NativeDevice::read(std::uint32_t address) {
  const reg::Register* known = find_register(address);
  if (known == nullptr || known->access == reg::Access::kWriteStream) refuse("read", address);
  switch (address) {
    case reg::id::kAddress:
      return reg::id::kValueValue;
    case reg::version::kAddress:
      return reg::version::kMajor.put(reg::version::kMajorValue) | reg::version::kMinor.put(reg::version::kMinorValue);
    case reg::build_size::kAddress:
      return reg::build_size::kWidth.put(static_cast<std::uint32_t>(profile_.width)) |
             reg::build_size::kHeight.put(static_cast<std::uint32_t>(profile_.height));
    case reg::build_store::kAddress:
      return reg::build_store::kRows.put(static_cast<std::uint32_t>(profile_.store_rows)) |
             reg::build_store::kPoolKib.put(static_cast<std::uint32_t>(profile_.pool_bytes / 1024));
    case reg::build_window::kAddress:
      return reg::build_window::kDsad.put(static_cast<std::uint32_t>(profile_.dsad_window)) |
             reg::build_window::kMajority.put(static_cast<std::uint32_t>(profile_.majority_window)) |
             reg::build_window::kSubsample.put(static_cast<std::uint32_t>(profile_.subsample)) |
             reg::build_window::kWeightBits.put(static_cast<std::uint32_t>(profile_.weight_bits)) |
             reg::build_window::kHypotheses.put(static_cast<std::uint32_t>(profile_.hypotheses)) |
             reg::build_window::kThesis.put(profile_.has_thesis()) |
             reg::build_window::kCompete.put(profile_.has_compete()) | reg::build_window::kBlind.put(1);
    case reg::build_compete::kAddress:
      return reg::build_compete::kPlanes.put(static_cast<std::uint32_t>(profile_.planes)) |
             reg::build_compete::kSumRows.put(static_cast<std::uint32_t>(profile_.sum_rows)) |
             reg::build_compete::kSumColumns.put(static_cast<std::uint32_t>(profile_.sum_columns)) |
             reg::build_compete::kBallotReach.put(static_cast<std::uint32_t>(profile_.ballot_reach)) |
             reg::build_compete::kPaths.put(profile_.paths ? 1 : 0);
    case reg::build_clock::kAddress:
      return static_cast<std::uint32_t>(profile_.clock_khz);
    case reg::status::kAddress: {
      const bool enabled = reg::control::kEnable.get(stored(reg::control::kAddress)) != 0;
      return reg::status::kRunning.put(running()) | reg::status::kBadGeometry.put(enabled && !geometry_is_possible()) |
             reg::status::kBusy.put(!pending_.empty()) | reg::status::kSafe.put(safe_) |
             reg::status::kUnsafe.put(!safe_) | reg::status::kWaiting.put(!released() && restart_is_allowed()) |
             reg::status::kByItself.put(by_itself()) | reg::status::kTaught.put(taught_);
    }
    case reg::irq_status::kAddress:
      return irq_status_;
    case reg::map_status::kAddress:
      return reg::map_status::kBusy.put(uploading_) |
             reg::map_status::kError.put(static_cast<std::uint32_t>(upload_error_)) |
             reg::map_status::kActiveSlot.put(static_cast<std::uint32_t>(active_slot_));
    case reg::map_valid::kAddress: {
      std::uint32_t valid = 0;
      for (std::size_t slot = 0; slot < tables_.size(); ++slot) valid |= (tables_[slot] ? 1U : 0U) << slot;
      return valid;
    }
    case reg::map_crc::kAddress: {
      const auto slot = stored(reg::map_slot::kAddress);
      return slot < tables_.size() && tables_[slot] ? tables_[slot]->words.back() : 0;
    }
    case reg::map_extent::kAddress: {
      const auto slot = stored(reg::map_slot::kAddress);
      if (slot >= tables_.size() || !tables_[slot]) return 0;
      return reg::map_extent::kBaseWord64.put(static_cast<std::uint32_t>(tables_[slot]->base_word64)) |
             reg::map_extent::kEndWord64.put(static_cast<std::uint32_t>(tables_[slot]->end_word64));
    }
    case reg::faults_cameras::kAddress:
      return faults_.cameras();
    case reg::faults_machine::kAddress:
      return faults_.machine();
    case reg::frame_sequence::kAddress:
      return frame_.sequence;
    case reg::frame_status::kAddress:
      return frame_.status;
    case reg::frame_faults_cameras::kAddress:
      return frame_.faults.cameras();
    case reg::frame_faults_machine::kAddress:
      return frame_.faults.machine();
    case reg::frame_table_crc::kAddress:
      return frame_.table_crc;
    case reg::frame_skin::kAddress:
      return frame_.skin;
    case reg::frame_undecidable::kAddress:
      return frame_.undecidable;
    case reg::frame_unsupervised::kAddress:
      return frame_.unsupervised;
    case reg::frame_misses::kAddress:
      return frame_.misses;
    case reg::frame_hidden::kAddress:
      return frame_.hidden;
    case reg::frame_unproven_pixels::kAddress:
      return frame_.unproven_pixels;
    case reg::frame_object::kAddress:
    case reg::frame_object_columns::kAddress:
    case reg::frame_object_rows::kAddress:
      return frame_.object.at((address - reg::frame_object::kAddress) / 4);
    case reg::frame_object_area::kAddress:
      return frame_.object_area;
    case reg::taught::kAddress:
      return taught_frames_;
    case reg::frame_blind::kAddress:
      return frame_.blind;
    case reg::frame_region::kAddress:
      return frame_.regions.at(stored(reg::region_select::kAddress) & 63U);
    default:
      if (address >= reg::frame_agreement::kAddress && address <= reg::frame_patches::kAddress) {
        return frame_.agreement.at((address - reg::frame_agreement::kAddress) / 4);
      }
      return known->access == reg::Access::kReadWrite ? stored(address) : 0;
  }
}

void NativeDevice::write(std::uint32_t address, std::uint32_t value) {
  const reg::Register* known = find_register(address);
  const bool enabled = reg::control::kEnable.get(stored(reg::control::kAddress)) != 0;
  if (known == nullptr || known->access == reg::Access::kReadOnly || (known->locked && enabled)) {
    refuse("write", address);
  }
  switch (address) {
    case reg::control::kAddress:
      stored(address) = value & reg::control::kEnable.mask();
      if (!running()) reset_stream();
      for (std::size_t slot = 0; slot < tables_.size(); ++slot) prepare(slot);
      return;
    case reg::faults_cameras::kAddress:
      faults_.clear({value, 0});
      return;
    case reg::faults_machine::kAddress:
      faults_.clear({0, value});
      return;
    case reg::irq_status::kAddress:
      irq_status_ &= ~value;
      return;
    case reg::restart::kAddress:
      restart(value);
      return;
    case reg::interlock::kAddress:
      stored(address) = value & (reg::interlock::kByItself.mask() | reg::interlock::kByPin.mask() |
                                 reg::interlock::kByRegister.mask() | reg::interlock::kFrames.mask());
      return;
    case reg::alarm_frames::kAddress:
      stored(address) = value & (reg::alarm_frames::kNeeded.mask() | reg::alarm_frames::kOf.mask());
      return;
    case reg::map_control::kAddress:
      if (reg::map_control::kStart.get(value) != 0) begin_upload();
      return;
    case reg::map_data::kAddress:
      upload_word(value);
      return;
    case reg::width::kAddress:
      stored(address) = reg::width::kPx.get(value);
      return;
    case reg::height::kAddress:
      stored(address) = reg::height::kRows.get(value);
      return;
    case reg::lookahead::kAddress:
      stored(address) = reg::lookahead::kRows.get(value);
      return;
    case reg::table_select::kAddress:
      stored(address) = reg::table_select::kSlot.get(value);
      return;
    case reg::map_slot::kAddress:
      stored(address) = reg::map_slot::kSlot.get(value);
      return;
    case reg::map_base::kAddress:
      stored(address) = reg::map_base::kWord64.get(value);
      return;
    case reg::map_undecidable_limit::kAddress:
      stored(address) = reg::map_undecidable_limit::kPixels.get(value);
      return;
    case reg::decision::kAddress:
      if (profile_.has_thesis() && profile_.has_compete()) stored(address) = value & reg::decision::kCompete.mask();
      return;
    case reg::compete::kAddress:
      if (!profile_.has_compete()) return;
      stored(address) = compete_word(compete_settings(value));
      return;
    default:
      stored(address) = value;
      return;
  }
}

bool NativeDevice::by_itself() const {
  return reg::interlock::kByItself.get(registers_[reg::interlock::kAddress / 4]) != 0;
}

bool NativeDevice::restart_is_allowed() const {
  const std::uint32_t wanted = reg::interlock::kFrames.get(registers_[reg::interlock::kAddress / 4]);
  return good_frames_ != 0 && good_frames_ >= wanted;
}

bool NativeDevice::alarm_counts() const {
  const std::uint32_t word = registers_[reg::alarm_frames::kAddress / 4];
  const std::uint32_t needed = reg::alarm_frames::kNeeded.get(word);
  const std::uint32_t of = std::max(needed, reg::alarm_frames::kOf.get(word));
  const std::uint32_t before = of > 1 ? alarms_seen_ & ((1U << (of - 1)) - 1) : 0;
  return static_cast<std::uint32_t>(std::popcount(before)) + 1 >= needed;
}

void NativeDevice::hold() {
  safe_ = good_before_ = restarted_ = false;
  good_frames_ = 0;
}

void NativeDevice::restart(std::uint32_t key) {
  const bool by_register = reg::interlock::kByRegister.get(stored(reg::interlock::kAddress)) != 0;
  if (key == reg::kRestartKey && by_register && restart_is_allowed()) restarted_ = true;
}

std::unique_ptr<native::Engine> NativeDevice::new_engine() const {
  try {
    return native::make_engine(profile_.name, live_ ? native::threads_live : native::threads_usual);
  } catch (const std::invalid_argument& error) {  // what the environment asks for
    throw UsageError(error.what());
  }
}

void NativeDevice::reset_stream() {
  engine_ = new_engine();
  pending_.clear();
  frame_ = {};
  hold();
  alarms_seen_ = kAllSeen;
  taught_ = taught_before_ = forget_ = alarm_discounted_ = dim_ = compete_before_ = false;
  spoiled_before_ = 0;
  taught_frames_ = 0;
  active_slot_ = kNoTable;
  crc_before_ = crc_two_before_ = std::nullopt;
  has_table_ = same_table_ = false;
  frame_faults_pending_ = {};
}

// Upload --------------------------------------------------------------------------------------------------------------

void NativeDevice::begin_upload() {
  upload_slot_ = static_cast<int>(stored(reg::map_slot::kAddress));
  upload_ = {stored(reg::map_base::kAddress), 0, static_cast<int>(stored(reg::map_undecidable_limit::kAddress)), {}};
  upload_length_ = 0;
  upload_error_ = UploadError::none;
  uploading_ = false;
  if (upload_slot_ == kNoTable) return end_upload(UploadError::no_slot);
  if (in_use(upload_slot_)) return end_upload(UploadError::in_use);
  tables_.at(static_cast<std::size_t>(upload_slot_)).reset();
  uploading_ = true;
}

void NativeDevice::end_upload(UploadError error) {
  uploading_ = false;
  upload_error_ = error;
  if (error == UploadError::none) return;
  const Fault fault = error == UploadError::in_use ? Fault::map_busy : Fault::map_crc;
  faults_ |= fault;
  if (running()) frame_faults_pending_ |= fault;
  hold();
}

void NativeDevice::upload_word(std::uint32_t word) {
  if (!uploading_) {
    if (upload_error_ == UploadError::none) upload_error_ = UploadError::not_started;
    return;
  }
  auto& words = upload_.words;
  words.push_back(word);
  if (words.size() == 1 && !hls::table::is_first_word(word)) return end_upload(UploadError::bad_header);
  if (words.size() == hls::table::header_words) {
    const auto geometry = hls::table::read_geometry(words);
    const auto facts = hls::table::read_fact_words(word);
    if (!geometry || !facts) return end_upload(UploadError::bad_header);
    const std::size_t end = upload_.base_word64 + geometry->pool_words(*facts - hls::table::fact_words) / 2;
    upload_.end_word64 = end;
    if (end * 8 > static_cast<std::size_t>(profile_.pool_bytes)) return end_upload(UploadError::too_large);
    const auto overlaps = [&](const std::optional<Table>& table) {
      return table && table->base_word64 < end && table->end_word64 > upload_.base_word64;
    };
    for (std::size_t slot = 0; slot < tables_.size(); ++slot) {
      if (overlaps(tables_[slot]) && in_use(static_cast<int>(slot))) return end_upload(UploadError::in_use);
    }
    for (auto& table : tables_) {
      if (overlaps(table)) table.reset();
    }
    upload_length_ = hls::table::header_words + *facts + geometry->span_words() + geometry->control_words() + 1;
  }
  if (upload_length_ == 0 || words.size() < upload_length_) return;
  if (crc32_words(std::span(words).first(words.size() - 1)) != words.back()) return end_upload(UploadError::wrong_crc);
  tables_.at(static_cast<std::size_t>(upload_slot_)) = std::move(upload_);
  end_upload(UploadError::none);
  prepare(static_cast<std::size_t>(upload_slot_));
}

/// What a frame makes of its table is the same for each, and takes longer than a frame: it is made when both are known.
void NativeDevice::prepare(std::size_t slot) {
  const auto& table = tables_.at(slot);
  if (!running() || !table || !fits(*table)) return;
  try {
    engine_->prepare(native::TableView(table->words), static_cast<int>(stored(reg::lookahead::kAddress)));
  } catch (const std::invalid_argument&) {
    // The hardware checks less of a table. The frame that needs it says what is wrong.
  }
}

int NativeDevice::frames_that_expanded_their_table() const { return engine_->frames_that_expanded(); }

// Streams -------------------------------------------------------------------------------------------------------------

native::Settings NativeDevice::settings() const {
  const auto word = [&](std::uint32_t address) { return registers_[address / 4]; };
  native::Settings s;
  static_cast<hls::StageSettings&>(s) = stage_settings(word);
  s.lookahead = static_cast<int>(word(reg::lookahead::kAddress));
  s.forget = forget_ || (s.compete != 0) != compete_before_ ? 1 : 0;
  s.alarm_discounted = alarm_discounted_ ? 1 : 0;
  s.same_table = same_table_ ? 1 : 0;
  s.dim = s.dim != 0 && s.teach != 0 && !dim_ ? 1 : 0;
  // Without a table nothing is undecidable.
  s.undecidable_limit = 0;
  if (const Table* table = active_table()) {
    s.undecidable_limit = table->undecidable_limit;
    s.unsupervised_limit =
        std::min(s.unsupervised_limit, static_cast<int>(hls::table::unsupervised_pixels(table->words, s.compete != 0)));
  }
  if (s.dim != 0) {
    s.undecidable_limit =
        static_cast<int>(word(reg::width::kAddress) / profile_.subsample * word(reg::height::kAddress));
  }
  return s;
}

void NativeDevice::send(const Image& left, const Image& right) {
  if (!running()) throw DeviceError("the machine is not enabled, or its geometry is impossible");
  const auto width = static_cast<int>(stored(reg::width::kAddress));
  const auto height = static_cast<int>(stored(reg::height::kAddress));
  for (const Image* image : {&left, &right}) {
    if (image->width != width || image->height != height) {
      throw DeviceError(fmt::format("an image of {}x{} pixels for a machine set to {}x{}", image->width, image->height,
                                    width, height));
    }
  }
  pending_.push_back({left, right});
  if (pending_.size() == 1) start_frame();
}

/// The table is looked up at the start of the output frame, and the settings are taken then.
void NativeDevice::start_frame() {
  const auto selected = stored(reg::table_select::kAddress);
  const auto slot = static_cast<int>(selected);
  const bool same_slot = slot == std::exchange(active_slot_, slot);
  has_table_ = selected < tables_.size() && tables_[selected].has_value() && fits(*tables_[selected]);
  const Table* table = active_table();
  const auto crc = table != nullptr ? std::optional(table->words.back()) : std::nullopt;
  const auto two_before = std::exchange(crc_two_before_, std::exchange(crc_before_, crc));
  same_table_ = profile_.takes_fields() ? crc && crc == two_before : same_slot;
  frame_settings_ = std::make_unique<native::Settings>(settings());
}

const NativeDevice::Table* NativeDevice::active_table() const {
  return has_table_ ? &*tables_.at(static_cast<std::size_t>(active_slot_)) : nullptr;
}

bool NativeDevice::fits(const Table& table) const {
  const auto height = registers_[reg::height::kAddress / 4];
  return table.words[2] == (height << 16 | registers_[reg::width::kAddress / 4]);
}

FrameStreams NativeDevice::receive() {
  if (pending_.empty()) throw DeviceError("no frame comes: none was sent");
  const auto [left, right] = std::move(pending_.front());
  pending_.pop_front();

  // What is in use cannot be overwritten.
  const Table* table = active_table();
  const std::vector<std::uint32_t> none =
      table == nullptr ? empty_table(left.width, left.height) : std::vector<std::uint32_t>();
  const native::Settings settings = *frame_settings_;
  dim_ = settings.dim != 0;
  compete_before_ = settings.compete != 0;
  const auto result =
      engine_->process(view(left), view(right), native::TableView(table != nullptr ? table->words : none), settings);

  Faults faults = std::exchange(frame_faults_pending_, {});
  const auto add = [&](bool condition, Fault fault) {
    if (condition) faults |= fault;
  };
  add(result.left.black, Fault::left_black);
  add(result.left.white, Fault::left_white);
  add(result.left.constant, Fault::left_constant);
  add(result.left.frozen, Fault::left_frozen);
  add(result.left.blind, Fault::left_blind);
  add(result.left.torn, Fault::left_torn);
  add(result.right.black, Fault::right_black);
  add(result.right.white, Fault::right_white);
  add(result.right.constant, Fault::right_constant);
  add(result.right.frozen, Fault::right_frozen);
  add(result.right.blind, Fault::right_blind);
  add(result.right.torn, Fault::right_torn);
  add(result.store_misses > 0, Fault::store_miss);
  add(table == nullptr, Fault::no_table);
  add(result.too_undecidable, Fault::too_undecidable);
  add(result.too_unsupervised, Fault::too_unsupervised);
  add(result.identical_images, Fault::identical_images);
  add(result.one_camera, Fault::one_camera);
  add(result.object_overflow, Fault::objects);
  add(stored(reg::feedback::kAddress) != 0, Fault::contactors);  // there are none
  add(settings.teach != 0, Fault::teaching);
  add(result.agreement.untextured, Fault::too_undecidable);
  add(result.agreement.disagree, Fault::disagree);
  add(result.agreement.unproven, Fault::unproven);
  add(result.agreement.moved, Fault::moved);
  const bool teaches = faults.has(Fault::teaching);
  const bool alarm = result.alarm && (teaches || alarm_counts());
  add(result.agreement.overlooked && !alarm, Fault::overlooked);
  add(result.agreement.out_of_step, Fault::out_of_step);
  add(result.agreement.hidden, Fault::hidden);
  add(result.agreement.unsharp_left, Fault::left_unsharp);
  add(result.agreement.unsharp_right, Fault::right_unsharp);

  taught_ = result.taught;
  if (settings.forget != 0 || (teaches && !taught_before_)) {
    taught_frames_ = 0;
  } else if (taught_before_) {
    taught_frames_ = std::min(taught_frames_ + 1, 0xFFFFU);
  }
  taught_before_ = teaches;
  const Faults beside = faults.without(Fault::teaching);
  forget_ = teaches && (result.alarm || beside.any() || spoiled_before_ != 0);
  const bool spoils = result.alarm || (frame_.sequence == 0 ? beside : beside.without(Fault::unproven)).any();
  spoiled_before_ = (spoiled_before_ << 1U | static_cast<unsigned>(spoils)) & 3U;
  const bool good = !faults.any() && !alarm;
  alarm_discounted_ = result.alarm && good;
  alarms_seen_ = faults.any() ? kAllSeen : alarms_seen_ << 1U | static_cast<std::uint32_t>(result.alarm);
  const bool test_input = reg::mode::kTestInput.get(stored(reg::mode::kAddress)) != 0;
  if (good && !test_input) {
    safe_ = good_before_ && released();
    good_before_ = true;
    good_frames_ = std::min(good_frames_ + 1, 15U);
  } else {
    hold();
  }
  faults_ |= faults;
  irq_status_ |= reg::irq_status::kFrame.mask() | (faults.any() ? reg::irq_status::kFault.mask() : 0);
  const auto count = [](auto pixels) { return static_cast<std::uint32_t>(pixels); };
  const int slot = table != nullptr ? active_slot_ : kNoTable;
  frame_ = {.sequence = frame_.sequence + 1,
            .status = reg::frame_status::kAlarm.put(result.alarm && !good) | reg::frame_status::kSafe.put(good) |
                      reg::frame_status::kSlot.put(static_cast<std::uint32_t>(slot)) |
                      reg::frame_status::kSeen.put(result.alarm),
            .faults = faults,
            .table_crc = table != nullptr ? table->words.back() : 0,
            .skin = count(result.skin_pixels),
            .undecidable = count(result.undecidable_pixels),
            .unsupervised = count(result.unsupervised_pixels),
            .misses = count(result.store_misses),
            .hidden = count(result.hidden_pixels),
            .unproven_pixels = count(result.unproven_pixels),
            .object = object_words(result.largest_object()),
            .object_area = result.largest_object().area,
            .blind = count(result.blind_pixels),
            .agreement = agreement_words(result.agreement),
            .regions = region_words(result.agreement)};

  if (!pending_.empty()) start_frame();

  FrameStreams streams;
  streams.states = Image(result.width, result.height);
  streams.states.pixels = result.states;
  streams.runs.reserve(result.runs.size());
  for (const native::Run& run : result.runs)
    streams.runs.push_back({run.row, run.start, run.end, static_cast<State>(run.state)});
  return streams;
}

std::unique_ptr<Device> make_native_device(const MachineProfile& profile) {
  return std::make_unique<NativeDevice>(profile);
}

std::unique_ptr<Device> make_live_native_device(const MachineProfile& profile) {
  return std::make_unique<NativeDevice>(profile, true);
}

}  // namespace horopter
