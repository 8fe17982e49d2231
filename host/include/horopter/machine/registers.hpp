// SPDX-License-Identifier: Apache-2.0
// Made by scripts/generate-registers from rtl/csr/registers.yaml: change that, not this.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace horopter::registers {

/// Part of a register word.
struct Field {
  unsigned lsb;
  unsigned bits;

  /// The field's bits in the word, set.
  [[nodiscard]] constexpr std::uint32_t mask() const {
    return (bits == 32 ? 0xFFFFFFFFU : (std::uint32_t{1} << bits) - 1U) << lsb;
  }
  /// The field's value in `word`.
  [[nodiscard]] constexpr std::uint32_t get(std::uint32_t word) const { return (word & mask()) >> lsb; }
  /// `value` (cut to the field's width) at the field's place, zero elsewhere.
  [[nodiscard]] constexpr std::uint32_t put(std::uint32_t value) const { return (value << lsb) & mask(); }
};

/// How software may use a register.
enum class Access { kReadWrite, kReadOnly, kWriteOneToClear, kWriteStream };

/// TABLE_SELECT, FRAME_STATUS and MAP_STATUS: no table.
inline constexpr std::uint32_t kNoSlot = 15;

/// RESTART: "RSTR".
inline constexpr std::uint32_t kRestartKey = 1381192786;

/// Always 0x484F524F, "HORO".
namespace id {
inline constexpr std::uint32_t kAddress = 0x000;
inline constexpr Access kAccess = Access::kReadOnly;
/// 0x484F524F
inline constexpr Field kValue{0, 32};
inline constexpr std::uint32_t kValueValue = 0x484F524F;
}  // namespace id

/// Version of this register map.
namespace version {
inline constexpr std::uint32_t kAddress = 0x004;
inline constexpr Access kAccess = Access::kReadOnly;
/// Counts compatible additions.
inline constexpr Field kMinor{0, 16};
inline constexpr std::uint32_t kMinorValue = 0x8;
/// Counts incompatible changes.
inline constexpr Field kMajor{16, 16};
inline constexpr std::uint32_t kMajorValue = 0x2;
}  // namespace version

/// Largest frame, fixed by the profile, in px of the incoming images.
namespace build_size {
inline constexpr std::uint32_t kAddress = 0x008;
inline constexpr Access kAccess = Access::kReadOnly;
/// Largest width in px.
inline constexpr Field kWidth{0, 16};
/// Largest height in rows.
inline constexpr Field kHeight{16, 16};
}  // namespace build_size

/// Stores, fixed by the build: the profile's, or a smaller pool.
namespace build_store {
inline constexpr std::uint32_t kAddress = 0x00C;
inline constexpr Access kAccess = Access::kReadOnly;
/// Rows of the ring that holds the right image.
inline constexpr Field kRows{0, 16};
/// Pool of the mapping tables in KiB.
inline constexpr Field kPoolKib{16, 16};
}  // namespace build_store

/// Windows and arithmetic, fixed by the profile, and the rules that are built.
namespace build_window {
inline constexpr std::uint32_t kAddress = 0x010;
inline constexpr Access kAccess = Access::kReadOnly;
/// Side of the DSAD window in px.
inline constexpr Field kDsad{0, 8};
/// Side of the majority window in px.
inline constexpr Field kMajority{8, 8};
/// Pixels of a row that are averaged to one: 1 or 2.
inline constexpr Field kSubsample{16, 4};
/// Bits of an interpolation weight.
inline constexpr Field kWeightBits{20, 4};
/// Hypotheses compared at once.
inline constexpr Field kHypotheses{24, 4};
/// Has the rule `thesis`: one threshold.
inline constexpr Field kThesis{28, 1};
/// Has the rule `compete`: parallel skins compete.
inline constexpr Field kCompete{29, 1};
/// Has the stage `blind`: watches for what goes blind (BLOCKS).
inline constexpr Field kBlind{30, 1};
}  // namespace build_window

/// Clock the profile is meant for.
namespace build_clock {
inline constexpr std::uint32_t kAddress = 0x014;
inline constexpr Access kAccess = Access::kReadOnly;
/// Clock in kHz.
inline constexpr Field kKhz{0, 32};
}  // namespace build_clock

/// The rule `compete`, fixed by the profile; 0 where it is not built.
namespace build_compete {
inline constexpr std::uint32_t kAddress = 0x018;
inline constexpr Access kAccess = Access::kReadOnly;
/// Parallel skins that compete.
inline constexpr Field kPlanes{0, 8};
/// Rows of the window in which costs are summed.
inline constexpr Field kSumRows{8, 4};
/// Its columns in px.
inline constexpr Field kSumColumns{12, 4};
/// Rows above and below that vote.
inline constexpr Field kBallotReach{16, 4};
/// 1: the pixel above helps.
inline constexpr Field kPaths{20, 1};
}  // namespace build_compete

/// Run control. While enable is 0 the streaming core is in reset.
namespace control {
inline constexpr std::uint32_t kAddress = 0x040;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x0;
/// 1 = run. Going to 0 drops the frame in progress and what the output streams hold, but for a beat that is offered.
/// Without MODE.live the first pixels after it are those of two images that belong together.
inline constexpr Field kEnable{0, 1};
}  // namespace control

/// What the streams are. Locked while CONTROL.enable is 1.
namespace mode {
inline constexpr std::uint32_t kAddress = 0x044;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x0;
/// 1 = cameras cannot wait: tready stays high and what cannot be stored is an overflow fault.
inline constexpr Field kLive{0, 1};
/// 1 = both images come from s_axis_test, not from the cameras; safe_o stays low.
inline constexpr Field kTestInput{1, 1};
}  // namespace mode

/// State of the machine now.
namespace status {
inline constexpr std::uint32_t kAddress = 0x048;
inline constexpr Access kAccess = Access::kReadOnly;
/// The streaming core is out of reset.
inline constexpr Field kRunning{0, 1};
/// WIDTH, HEIGHT or LOOKAHEAD is not possible in this build: enable has no effect.
inline constexpr Field kBadGeometry{1, 1};
/// A frame is in the store or in the pipeline.
inline constexpr Field kBusy{2, 1};
/// As safe_o.
inline constexpr Field kSafe{3, 1};
/// As unsafe_o. Equal to safe: the hardware is broken.
inline constexpr Field kUnsafe{4, 1};
/// No pixel from the left camera for TIMEOUT clocks.
inline constexpr Field kLeftSilent{5, 1};
/// No pixel from the right camera for TIMEOUT clocks.
inline constexpr Field kRightSilent{6, 1};
/// No frame finished for TIMEOUT clocks.
inline constexpr Field kLate{7, 1};
/// The last frames were good: a restart would let safe_o rise (INTERLOCK).
inline constexpr Field kWaiting{8, 1};
/// As INTERLOCK.by_itself: nobody has to restart.
inline constexpr Field kByItself{9, 1};
/// At least one frame was taught since enable (BLOCKS).
inline constexpr Field kTaught{10, 1};
}  // namespace status

/// Width of the incoming images. Locked while CONTROL.enable is 1.
namespace width {
inline constexpr std::uint32_t kAddress = 0x04C;
inline constexpr Access kAccess = Access::kReadWrite;
/// px; at least 32 times the sub-sampling, a multiple of it, at most BUILD_SIZE.
inline constexpr Field kPx{0, 12};
}  // namespace width

/// Height of the incoming images. Locked while CONTROL.enable is 1.
namespace height {
inline constexpr std::uint32_t kAddress = 0x050;
inline constexpr Access kAccess = Access::kReadWrite;
/// Rows, at least 16, at most BUILD_SIZE.
inline constexpr Field kRows{0, 12};
}  // namespace height

/// Rows the right image is ahead of the output. Locked while CONTROL.enable is 1.
namespace lookahead {
inline constexpr std::uint32_t kAddress = 0x054;
inline constexpr Access kAccess = Access::kReadWrite;
/// Output row y starts when right row y + LOOKAHEAD is there; at most half the ring.
inline constexpr Field kRows{0, 12};
}  // namespace lookahead

/// Watchdog: longest time without a pixel of a camera, and without a finished frame. A new value counts from the next
/// pixel, the next frame on.
namespace timeout {
inline constexpr std::uint32_t kAddress = 0x058;
inline constexpr Access kAccess = Access::kReadWrite;
/// Clocks; must exceed the time of a frame.
inline constexpr Field kClocks{0, 32};
}  // namespace timeout

/// Mapping table of the next output frame.
namespace table_select {
inline constexpr std::uint32_t kAddress = 0x05C;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0xF;
/// 0 to 14; 15 = none: everything is unsupervised, and a fault.
inline constexpr Field kSlot{0, 4};
}  // namespace table_select

/// What raises irq_o; fields as in IRQ_STATUS.
namespace irq_enable {
inline constexpr std::uint32_t kAddress = 0x060;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x0;
/// IRQ_STATUS.frame.
inline constexpr Field kFrame{0, 1};
/// IRQ_STATUS.fault.
inline constexpr Field kFault{1, 1};
}  // namespace irq_enable

/// Events since they were last cleared.
namespace irq_status {
inline constexpr std::uint32_t kAddress = 0x064;
inline constexpr Access kAccess = Access::kWriteOneToClear;
/// A frame was finished; the FRAME registers are new.
inline constexpr Field kFrame{0, 1};
/// A bit of FAULTS_CAMERAS or FAULTS_MACHINE was set.
inline constexpr Field kFault{1, 1};
}  // namespace irq_status

/// What lets safe_o rise at start, and after an alarm or a fault (rtl/store/horopter_interlock.sv). Locked while
/// CONTROL.enable is 1.
namespace interlock {
inline constexpr std::uint32_t kAddress = 0x068;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x12;
/// 1 = safe_o rises by itself, and nobody has to restart. For machines that nobody can be inside of.
inline constexpr Field kByItself{0, 1};
/// 1 = restart_i, pressed while at least one frame is finished and let go, is a restart.
inline constexpr Field kByPin{1, 1};
/// 1 = the key written to RESTART is a restart.
inline constexpr Field kByRegister{2, 1};
/// So many finished frames without fault and alarm must lie before a restart; at least 1.
inline constexpr Field kFrames{3, 4};
}  // namespace interlock

/// Restart, where INTERLOCK.by_register allows it. One that comes too early is forgotten.
namespace restart {
inline constexpr std::uint32_t kAddress = 0x06C;
inline constexpr Access kAccess = Access::kWriteStream;
/// RESTART_KEY; another value does nothing.
inline constexpr Field kKey{0, 32};
}  // namespace restart

/// Contactors that safe_o switches (rtl/store/horopter_feedback.sv). Locked while CONTROL.enable is 1.
namespace feedback {
inline constexpr std::uint32_t kAddress = 0x070;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x0;
/// feedback_i must be the opposite of safe_o so many clocks after it has changed, and 1 before it may rise; 0 = nothing
/// is connected.
inline constexpr Field kClocks{0, 32};
}  // namespace feedback

/// A pixel is in the skin when its DSAD sum is at most this.
namespace sum_limit {
inline constexpr std::uint32_t kAddress = 0x080;
inline constexpr Access kAccess = Access::kReadWrite;
/// Sum, 0 to 15 k²; by default 25 % of 15 k².
inline constexpr Field kValue{0, 16};
}  // namespace sum_limit

/// A window whose left directions differ from those of their neighbours by no more than this in sum is no texture.
namespace self_limit {
inline constexpr std::uint32_t kAddress = 0x084;
inline constexpr Access kAccess = Access::kReadWrite;
/// Sum, 0 to 15 k².
inline constexpr Field kValue{0, 16};
}  // namespace self_limit

/// A pixel is decidable when the left magnitude, summed over 3×3, is at least this.
namespace texture_limit {
inline constexpr std::uint32_t kAddress = 0x088;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x120;
/// 9 times the threshold in units of the unscaled Sobel magnitude; 9 · 32 = 4 grey levels per px.
inline constexpr Field kSum{0, 16};
}  // namespace texture_limit

/// More skin pixels than this in a frame are an alarm.
namespace alarm_limit {
inline constexpr std::uint32_t kAddress = 0x08C;
inline constexpr Access kAccess = Access::kReadWrite;
/// Pixels of the result; by default 5 % of the largest frame.
inline constexpr Field kPixels{0, 24};
}  // namespace alarm_limit

/// In how many frames an alarm must be seen until it is one (rtl/store/horopter_alarm_filter.sv). Locked while
/// CONTROL.enable is 1.
namespace alarm_frames {
inline constexpr std::uint32_t kAddress = 0x090;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x9;
/// So many of the last ALARM_FRAMES.of frames, this one among them; 0 is as 1. Frames with a fault, all before one, and
/// frames that did not come count as frames that show an alarm.
inline constexpr Field kNeeded{0, 3};
/// Frames; fewer than `needed` are as `needed`.
inline constexpr Field kOf{3, 3};
}  // namespace alarm_frames

/// More unsupervised pixels than this in a frame are a fault.
namespace unsupervised_limit {
inline constexpr std::uint32_t kAddress = 0x094;
inline constexpr Access kAccess = Access::kReadWrite;
/// Pixels of the result; by default all of the largest frame. Never more than the table itself says that there are.
inline constexpr Field kPixels{0, 24};
}  // namespace unsupervised_limit

/// Black image: grey level at or below which a pixel is black.
namespace black_level {
inline constexpr std::uint32_t kAddress = 0x0A0;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x4;
/// Grey level.
inline constexpr Field kGrey{0, 8};
}  // namespace black_level

/// Black image: more black pixels than this are a fault.
namespace black_limit {
inline constexpr std::uint32_t kAddress = 0x0A4;
inline constexpr Access kAccess = Access::kReadWrite;
/// Incoming pixels; by default 95 % of the largest frame.
inline constexpr Field kPixels{0, 24};
}  // namespace black_limit

/// White image: grey level at or above which a pixel is white.
namespace white_level {
inline constexpr std::uint32_t kAddress = 0x0A8;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0xFB;
/// Grey level.
inline constexpr Field kGrey{0, 8};
}  // namespace white_level

/// White image: more white pixels than this are a fault.
namespace white_limit {
inline constexpr std::uint32_t kAddress = 0x0AC;
inline constexpr Access kAccess = Access::kReadWrite;
/// Incoming pixels; by default 95 % of the largest frame.
inline constexpr Field kPixels{0, 24};
}  // namespace white_limit

/// Constant image: brightest minus darkest pixel not above this is a fault.
namespace constant_limit {
inline constexpr std::uint32_t kAddress = 0x0B0;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x8;
/// Grey levels.
inline constexpr Field kGrey{0, 8};
}  // namespace constant_limit

/// Frozen image: one of the two frames before again, this many times in a row, is a fault. With two fields of an image
/// in turn, one of the four before.
namespace frozen_limit {
inline constexpr std::uint32_t kAddress = 0x0B4;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x1;
/// Repetitions; 1 = the first repetition; 0 = never.
inline constexpr Field kFrames{0, 8};
}  // namespace frozen_limit

/// The rule; fixed where only one is built: a write changes nothing, read it back.
namespace decision {
inline constexpr std::uint32_t kAddress = 0x0B8;
inline constexpr Access kAccess = Access::kReadWrite;
/// 0 = thesis: SUM_LIMIT, SELF_LIMIT and TEXTURE_LIMIT decide. 1 = compete: parallel skins do.
inline constexpr Field kCompete{0, 1};
}  // namespace decision

/// Settings of the rule `compete`; 0 where it is not built.
namespace compete {
inline constexpr std::uint32_t kAddress = 0x0BC;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x419051A2;
/// Added to every vote: above 0 a doubtful pixel is rather in the skin.
inline constexpr Field kBias{0, 4};
/// Pixels of a row that differ by more are not alike; 4 grey levels.
inline constexpr Field kSmooth{4, 3};
/// Pixels of a column that differ by more do not vote for each other; 4 grey levels.
inline constexpr Field kSimilar{7, 4};
/// Smallest sum of votes that says skin; at least 1.
inline constexpr Field kQuorum{11, 8};
/// Smallest sum of votes against that says clear; 8 votes where 19 rows vote, in proportion where fewer do, two thirds
/// of that without paths; at least 1.
inline constexpr Field kClearQuorum{19, 8};
/// Where the skin ends, 0 (nearest) to 14: before and behind it at 1/2 + boundary / 14 px by a parabola; measured:
/// host/src/plan/boundary_table.def.
inline constexpr Field kBoundary{27, 4};
}  // namespace compete

/// Slot of the next upload.
namespace map_slot {
inline constexpr std::uint32_t kAddress = 0x0C0;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x0;
/// 0 to 14.
inline constexpr Field kSlot{0, 4};
}  // namespace map_slot

/// Where the next upload goes in the pool.
namespace map_base {
inline constexpr std::uint32_t kAddress = 0x0C4;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x0;
/// Index of a 64-bit word. An upload invalidates every table that it overlaps.
inline constexpr Field kWord64{0, 16};
}  // namespace map_base

/// Starts an upload: parser and CRC are reset, the slot becomes invalid.
namespace map_control {
inline constexpr std::uint32_t kAddress = 0x0C8;
inline constexpr Access kAccess = Access::kWriteStream;
/// 1 = start, with MAP_SLOT, MAP_BASE and MAP_UNDECIDABLE_LIMIT as they are.
inline constexpr Field kStart{0, 1};
}  // namespace map_control

/// The words of the upload, one by one: hls/include/horopter/hls/table_format.hpp.
namespace map_data {
inline constexpr std::uint32_t kAddress = 0x0CC;
inline constexpr Access kAccess = Access::kWriteStream;
/// Next word.
inline constexpr Field kWord{0, 32};
}  // namespace map_data

/// Upload.
namespace map_status {
inline constexpr std::uint32_t kAddress = 0x0D0;
inline constexpr Access kAccess = Access::kReadOnly;
/// An upload has been started and not ended.
inline constexpr Field kBusy{0, 1};
/// Of the last upload: 0 none, 1 slot or region in use, 2 bad header, 3 does not fit the pool, 4 wrong CRC, 5 slot 15,
/// 6 data without start.
inline constexpr Field kError{1, 3};
/// Slot that was selected for the current output frame, whether it holds a table or not. 15 = none.
inline constexpr Field kActiveSlot{4, 4};
}  // namespace map_status

/// Which slots hold a table with a correct CRC.
namespace map_valid {
inline constexpr std::uint32_t kAddress = 0x0D4;
inline constexpr Access kAccess = Access::kReadOnly;
/// Bit s = slot s.
inline constexpr Field kSlots{0, 15};
}  // namespace map_valid

/// CRC-32 of the table in MAP_SLOT (the last word of its upload).
namespace map_crc {
inline constexpr std::uint32_t kAddress = 0x0D8;
inline constexpr Access kAccess = Access::kReadOnly;
/// CRC-32.
inline constexpr Field kValue{0, 32};
}  // namespace map_crc

/// Of the tables whose upload starts from now on: more undecidable pixels than this in a frame made by the table are a
/// fault. Stays with the table.
namespace map_undecidable_limit {
inline constexpr std::uint32_t kAddress = 0x0DC;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x0;
/// Pixels of the result; a share of those that the rule can judge (words 4 and 5 of the table).
inline constexpr Field kPixels{0, 24};
}  // namespace map_undecidable_limit

/// Every fault of the cameras since it was last cleared; a written 1 clears. safe_o does not depend on this register.
namespace faults_cameras {
inline constexpr std::uint32_t kAddress = 0x0E0;
inline constexpr Access kAccess = Access::kWriteOneToClear;
/// A line of the left camera ended early; the whole row counts as missing.
inline constexpr Field kLeftShortLine{0, 1};
/// A line of the left camera had too many pixels; the whole row counts as missing.
inline constexpr Field kLeftLongLine{1, 1};
/// The left camera's start of frame, or in live mode a pause of four line lengths, came before the last line; the rows
/// that did not come count as missing.
inline constexpr Field kLeftMissingLine{2, 1};
/// Lines of the left camera after the last one of the frame, without a start of frame.
inline constexpr Field kLeftMissingStart{3, 1};
/// No pixel from the left camera for TIMEOUT clocks; in live mode also: it did not come when the other one was 12 rows
/// into the frame.
inline constexpr Field kLeftSilent{4, 1};
/// The left camera in live mode: pixels came that could not be stored.
inline constexpr Field kLeftOverflow{5, 1};
/// The left image is black.
inline constexpr Field kLeftBlack{6, 1};
/// The left image is white.
inline constexpr Field kLeftWhite{7, 1};
/// The left image is one grey level.
inline constexpr Field kLeftConstant{8, 1};
/// The left image is the same as one of the two before, noise and all; or frame after frame the same but for noise
/// (STILL_LIMIT).
inline constexpr Field kLeftFrozen{9, 1};
/// A bit of the left image's memory fell over.
inline constexpr Field kLeftParity{10, 1};
/// The left image has too little contrast for a scene (BLIND_SHARE), as a whole or in a quarter of its columns or rows:
/// a covered or fogged lens, tape, darkness, glare.
inline constexpr Field kLeftBlind{11, 1};
/// The left image is less sharp than the other one (its detail, in proportion to its contrast, is below 5/8), or has
/// less than a quarter of its contrast.
inline constexpr Field kLeftUnsharp{12, 1};
/// The rows of the left image do not belong together. They are of two moments in turn (an interlaced image of what
/// moves, a transfer that mixes frames, an image of a camera with colour filters that was not converted), or rows or
/// pairs of rows lie aside (lines without sync).
inline constexpr Field kLeftTorn{13, 1};
/// A line of the right camera ended early; the whole row counts as missing.
inline constexpr Field kRightShortLine{16, 1};
/// A line of the right camera had too many pixels; the whole row counts as missing.
inline constexpr Field kRightLongLine{17, 1};
/// The right camera's start of frame, or in live mode a pause of four line lengths, came before the last line; the rows
/// that did not come count as missing.
inline constexpr Field kRightMissingLine{18, 1};
/// Lines of the right camera after the last one of the frame, without a start of frame.
inline constexpr Field kRightMissingStart{19, 1};
/// No pixel from the right camera for TIMEOUT clocks; in live mode also: it did not come when the other one was 12 rows
/// into the frame.
inline constexpr Field kRightSilent{20, 1};
/// The right camera in live mode: pixels came that could not be stored.
inline constexpr Field kRightOverflow{21, 1};
/// The right image is black.
inline constexpr Field kRightBlack{22, 1};
/// The right image is white.
inline constexpr Field kRightWhite{23, 1};
/// The right image is one grey level.
inline constexpr Field kRightConstant{24, 1};
/// The right image is the same as one of the two before, noise and all; or frame after frame the same but for noise
/// (STILL_LIMIT).
inline constexpr Field kRightFrozen{25, 1};
/// A bit of the right image's memory fell over.
inline constexpr Field kRightParity{26, 1};
/// The right image has too little contrast for a scene (BLIND_SHARE), as a whole or in a quarter of its columns or
/// rows: a covered or fogged lens, tape, darkness, glare.
inline constexpr Field kRightBlind{27, 1};
/// The right image is less sharp than the other one (its detail, in proportion to its contrast, is below 5/8), or has
/// less than a quarter of its contrast.
inline constexpr Field kRightUnsharp{28, 1};
/// The rows of the right image do not belong together. They are of two moments in turn (an interlaced image of what
/// moves, a transfer that mixes frames, an image of a camera with colour filters that was not converted), or rows or
/// pairs of rows lie aside (lines without sync).
inline constexpr Field kRightTorn{29, 1};
}  // namespace faults_cameras

/// The same for faults of both cameras together, of tables and of the machine.
namespace faults_machine {
inline constexpr std::uint32_t kAddress = 0x0E4;
inline constexpr Access kAccess = Access::kWriteOneToClear;
/// Live mode: the cameras are more than 64 px apart, or one missed a frame. Without: a frame was broken or a camera
/// silent before, so that it is in doubt which images belong together; until CONTROL.enable has been 0.
inline constexpr Field kSkew{0, 1};
/// The map wants a source row that the ring does not hold.
inline constexpr Field kStoreMiss{1, 1};
/// No valid table of this geometry in the selected slot.
inline constexpr Field kNoTable{2, 1};
/// An upload with a wrong CRC or a bad header.
inline constexpr Field kMapCrc{3, 1};
/// An upload into a table in use was refused.
inline constexpr Field kMapBusy{4, 1};
/// More undecidable pixels than the MAP_UNDECIDABLE_LIMIT of the table without those that are hidden or not shown to be
/// seen, or than 19/16 of it with them; or too little texture to tell whether both cameras see the same world.
inline constexpr Field kTooUndecidable{5, 1};
/// More unsupervised pixels than UNSUPERVISED_LIMIT.
inline constexpr Field kTooUnsupervised{6, 1};
/// No frame was finished for TIMEOUT clocks.
inline constexpr Field kLate{7, 1};
/// The hardware contradicts itself (a full output FIFO, a missing image check, a parity error of the map or of the
/// memory of a stage, a word of the map from another upload).
inline constexpr Field kInternal{8, 1};
/// Left and right image are the same, bit by bit (by their signatures). Two cameras never agree so; this is one camera
/// twice, and says nothing about a skin.
inline constexpr Field kIdenticalImages{9, 1};
/// Left and right image show the same from the same place, whatever noise, compression or gain is between them: one
/// camera twice, which says nothing about a skin.
inline constexpr Field kOneCamera{10, 1};
/// Both cameras do not see the same world: too little of what is textured is explained by any depth, in all or by
/// region (AGREEMENT_LIMITS).
inline constexpr Field kDisagree{11, 1};
/// The first frame after enable: nothing has been shown before it that could earn clear. Also until rounds of places
/// say whether a camera was moved, and when they have not for 512 frames (REGISTRATION.patches).
inline constexpr Field kUnproven{12, 1};
/// The right image is displaced across the rows against the rig (REGISTRATION): a camera was knocked, turned or its
/// lens changed.
inline constexpr Field kMoved{13, 1};
/// For HIDDEN frames, too much of the skin has stood behind something nearer to the cameras.
inline constexpr Field kHidden{14, 1};
/// A bit of a register, or of what a frame has sampled of it, fell over; until that register is written again.
inline constexpr Field kSettings{15, 1};
/// restart_i has been held for 255 frames: a button that is stuck, or a broken wire.
inline constexpr Field kRestart{16, 1};
/// More objects, or more of them in one row, than the machine can tell apart (hls/stages/objects.hpp).
inline constexpr Field kObjects{17, 1};
/// feedback_i did not follow safe_o for FEEDBACK clocks: a contactor does not drop or does not pull in, or a broken
/// wire.
inline constexpr Field kContactors{18, 1};
/// BLOCKS.teach is set: the machine learns, and does not watch.
inline constexpr Field kTeaching{19, 1};
/// More of the cells, or of a round's places, lie on the skin than REGISTRATION.on_skin, and there is no alarm: what
/// blinds the rule, as haze, a drop on a lens or coarse pictures, does not blind this.
inline constexpr Field kOverlooked{20, 1};
/// The cameras do not show the same moment: a motion began or ended in one image alone. Until one begins in both at
/// once (hls/stages/moments.hpp).
inline constexpr Field kOutOfStep{21, 1};
}  // namespace faults_machine

/// Where the table in MAP_SLOT lies in the pool; 0 without a table. Means nothing in the 100 clocks after the third
/// word of an upload.
namespace map_extent {
inline constexpr std::uint32_t kAddress = 0x0E8;
inline constexpr Access kAccess = Access::kReadOnly;
/// Index of its first 64-bit word.
inline constexpr Field kBaseWord64{0, 16};
/// Index after the last one, modulo 65536: it takes (end - base) modulo 65536 words, and all 65536 where that is 0.
inline constexpr Field kEndWord64{16, 16};
}  // namespace map_extent

/// Counts finished frames since enable. Read before and after the other FRAME registers: the same value means they
/// belong together.
namespace frame_sequence {
inline constexpr std::uint32_t kAddress = 0x100;
inline constexpr Access kAccess = Access::kReadOnly;
/// 0 = none yet.
inline constexpr Field kValue{0, 32};
}  // namespace frame_sequence

/// The last finished frame.
namespace frame_status {
inline constexpr std::uint32_t kAddress = 0x104;
inline constexpr Access kAccess = Access::kReadOnly;
/// More skin pixels than ALARM_LIMIT, or an object of OBJECT_LIMIT or OBJECT_AREA_LIMIT, in as many frames as
/// ALARM_FRAMES says, or in one with a fault.
inline constexpr Field kAlarm{0, 1};
/// Complete, free of faults and of alarm.
inline constexpr Field kSafe{1, 1};
/// Slot of the table that made it, 15 = none.
inline constexpr Field kSlot{2, 4};
/// The same in this frame, whatever ALARM_FRAMES says.
inline constexpr Field kSeen{6, 1};
}  // namespace frame_status

/// Faults of the last finished frame; bits as in FAULTS_CAMERAS.
namespace frame_faults_cameras {
inline constexpr std::uint32_t kAddress = 0x108;
inline constexpr Access kAccess = Access::kReadOnly;
/// A line of the left camera ended early; the whole row counts as missing.
inline constexpr Field kLeftShortLine{0, 1};
/// A line of the left camera had too many pixels; the whole row counts as missing.
inline constexpr Field kLeftLongLine{1, 1};
/// The left camera's start of frame, or in live mode a pause of four line lengths, came before the last line; the rows
/// that did not come count as missing.
inline constexpr Field kLeftMissingLine{2, 1};
/// Lines of the left camera after the last one of the frame, without a start of frame.
inline constexpr Field kLeftMissingStart{3, 1};
/// No pixel from the left camera for TIMEOUT clocks; in live mode also: it did not come when the other one was 12 rows
/// into the frame.
inline constexpr Field kLeftSilent{4, 1};
/// The left camera in live mode: pixels came that could not be stored.
inline constexpr Field kLeftOverflow{5, 1};
/// The left image is black.
inline constexpr Field kLeftBlack{6, 1};
/// The left image is white.
inline constexpr Field kLeftWhite{7, 1};
/// The left image is one grey level.
inline constexpr Field kLeftConstant{8, 1};
/// The left image is the same as one of the two before, noise and all; or frame after frame the same but for noise
/// (STILL_LIMIT).
inline constexpr Field kLeftFrozen{9, 1};
/// A bit of the left image's memory fell over.
inline constexpr Field kLeftParity{10, 1};
/// The left image has too little contrast for a scene (BLIND_SHARE), as a whole or in a quarter of its columns or rows:
/// a covered or fogged lens, tape, darkness, glare.
inline constexpr Field kLeftBlind{11, 1};
/// The left image is less sharp than the other one (its detail, in proportion to its contrast, is below 5/8), or has
/// less than a quarter of its contrast.
inline constexpr Field kLeftUnsharp{12, 1};
/// The rows of the left image do not belong together. They are of two moments in turn (an interlaced image of what
/// moves, a transfer that mixes frames, an image of a camera with colour filters that was not converted), or rows or
/// pairs of rows lie aside (lines without sync).
inline constexpr Field kLeftTorn{13, 1};
/// A line of the right camera ended early; the whole row counts as missing.
inline constexpr Field kRightShortLine{16, 1};
/// A line of the right camera had too many pixels; the whole row counts as missing.
inline constexpr Field kRightLongLine{17, 1};
/// The right camera's start of frame, or in live mode a pause of four line lengths, came before the last line; the rows
/// that did not come count as missing.
inline constexpr Field kRightMissingLine{18, 1};
/// Lines of the right camera after the last one of the frame, without a start of frame.
inline constexpr Field kRightMissingStart{19, 1};
/// No pixel from the right camera for TIMEOUT clocks; in live mode also: it did not come when the other one was 12 rows
/// into the frame.
inline constexpr Field kRightSilent{20, 1};
/// The right camera in live mode: pixels came that could not be stored.
inline constexpr Field kRightOverflow{21, 1};
/// The right image is black.
inline constexpr Field kRightBlack{22, 1};
/// The right image is white.
inline constexpr Field kRightWhite{23, 1};
/// The right image is one grey level.
inline constexpr Field kRightConstant{24, 1};
/// The right image is the same as one of the two before, noise and all; or frame after frame the same but for noise
/// (STILL_LIMIT).
inline constexpr Field kRightFrozen{25, 1};
/// A bit of the right image's memory fell over.
inline constexpr Field kRightParity{26, 1};
/// The right image has too little contrast for a scene (BLIND_SHARE), as a whole or in a quarter of its columns or
/// rows: a covered or fogged lens, tape, darkness, glare.
inline constexpr Field kRightBlind{27, 1};
/// The right image is less sharp than the other one (its detail, in proportion to its contrast, is below 5/8), or has
/// less than a quarter of its contrast.
inline constexpr Field kRightUnsharp{28, 1};
/// The rows of the right image do not belong together. They are of two moments in turn (an interlaced image of what
/// moves, a transfer that mixes frames, an image of a camera with colour filters that was not converted), or rows or
/// pairs of rows lie aside (lines without sync).
inline constexpr Field kRightTorn{29, 1};
}  // namespace frame_faults_cameras

/// CRC-32 of the table that made it.
namespace frame_table_crc {
inline constexpr std::uint32_t kAddress = 0x10C;
inline constexpr Access kAccess = Access::kReadOnly;
/// CRC-32; 0 without a table.
inline constexpr Field kValue{0, 32};
}  // namespace frame_table_crc

/// Pixels in the skin.
namespace frame_skin {
inline constexpr std::uint32_t kAddress = 0x110;
inline constexpr Access kAccess = Access::kReadOnly;
/// Pixels of the result.
inline constexpr Field kPixels{0, 24};
}  // namespace frame_skin

/// Undecidable pixels.
namespace frame_undecidable {
inline constexpr std::uint32_t kAddress = 0x114;
inline constexpr Access kAccess = Access::kReadOnly;
/// Pixels of the result.
inline constexpr Field kPixels{0, 24};
}  // namespace frame_undecidable

/// Unsupervised pixels.
namespace frame_unsupervised {
inline constexpr std::uint32_t kAddress = 0x118;
inline constexpr Access kAccess = Access::kReadOnly;
/// Pixels of the result.
inline constexpr Field kPixels{0, 24};
}  // namespace frame_unsupervised

/// Reads of source rows that the ring did not hold.
namespace frame_misses {
inline constexpr std::uint32_t kAddress = 0x11C;
inline constexpr Access kAccess = Access::kReadOnly;
/// Output pixels before sub-sampling.
inline constexpr Field kPixels{0, 24};
}  // namespace frame_misses

/// From its first pixel in to its last state out.
namespace frame_cycles {
inline constexpr std::uint32_t kAddress = 0x120;
inline constexpr Access kAccess = Access::kReadOnly;
/// Clocks.
inline constexpr Field kClocks{0, 32};
}  // namespace frame_cycles

/// From its first pixel in to its first state out.
namespace frame_latency {
inline constexpr std::uint32_t kAddress = 0x124;
inline constexpr Access kAccess = Access::kReadOnly;
/// Clocks.
inline constexpr Field kClocks{0, 32};
}  // namespace frame_latency

/// From its last pixel in to its last state out.
namespace frame_tail {
inline constexpr std::uint32_t kAddress = 0x128;
inline constexpr Access kAccess = Access::kReadOnly;
/// Clocks.
inline constexpr Field kClocks{0, 32};
}  // namespace frame_tail

/// Faults of the last finished frame; bits as in FAULTS_MACHINE.
namespace frame_faults_machine {
inline constexpr std::uint32_t kAddress = 0x12C;
inline constexpr Access kAccess = Access::kReadOnly;
/// Live mode: the cameras are more than 64 px apart, or one missed a frame. Without: a frame was broken or a camera
/// silent before, so that it is in doubt which images belong together; until CONTROL.enable has been 0.
inline constexpr Field kSkew{0, 1};
/// The map wants a source row that the ring does not hold.
inline constexpr Field kStoreMiss{1, 1};
/// No valid table of this geometry in the selected slot.
inline constexpr Field kNoTable{2, 1};
/// An upload with a wrong CRC or a bad header.
inline constexpr Field kMapCrc{3, 1};
/// An upload into a table in use was refused.
inline constexpr Field kMapBusy{4, 1};
/// More undecidable pixels than the MAP_UNDECIDABLE_LIMIT of the table without those that are hidden or not shown to be
/// seen, or than 19/16 of it with them; or too little texture to tell whether both cameras see the same world.
inline constexpr Field kTooUndecidable{5, 1};
/// More unsupervised pixels than UNSUPERVISED_LIMIT.
inline constexpr Field kTooUnsupervised{6, 1};
/// No frame was finished for TIMEOUT clocks.
inline constexpr Field kLate{7, 1};
/// The hardware contradicts itself (a full output FIFO, a missing image check, a parity error of the map or of the
/// memory of a stage, a word of the map from another upload).
inline constexpr Field kInternal{8, 1};
/// Left and right image are the same, bit by bit (by their signatures). Two cameras never agree so; this is one camera
/// twice, and says nothing about a skin.
inline constexpr Field kIdenticalImages{9, 1};
/// Left and right image show the same from the same place, whatever noise, compression or gain is between them: one
/// camera twice, which says nothing about a skin.
inline constexpr Field kOneCamera{10, 1};
/// Both cameras do not see the same world: too little of what is textured is explained by any depth, in all or by
/// region (AGREEMENT_LIMITS).
inline constexpr Field kDisagree{11, 1};
/// The first frame after enable: nothing has been shown before it that could earn clear. Also until rounds of places
/// say whether a camera was moved, and when they have not for 512 frames (REGISTRATION.patches).
inline constexpr Field kUnproven{12, 1};
/// The right image is displaced across the rows against the rig (REGISTRATION): a camera was knocked, turned or its
/// lens changed.
inline constexpr Field kMoved{13, 1};
/// For HIDDEN frames, too much of the skin has stood behind something nearer to the cameras.
inline constexpr Field kHidden{14, 1};
/// A bit of a register, or of what a frame has sampled of it, fell over; until that register is written again.
inline constexpr Field kSettings{15, 1};
/// restart_i has been held for 255 frames: a button that is stuck, or a broken wire.
inline constexpr Field kRestart{16, 1};
/// More objects, or more of them in one row, than the machine can tell apart (hls/stages/objects.hpp).
inline constexpr Field kObjects{17, 1};
/// feedback_i did not follow safe_o for FEEDBACK clocks: a contactor does not drop or does not pull in, or a broken
/// wire.
inline constexpr Field kContactors{18, 1};
/// BLOCKS.teach is set: the machine learns, and does not watch.
inline constexpr Field kTeaching{19, 1};
/// More of the cells, or of a round's places, lie on the skin than REGISTRATION.on_skin, and there is no alarm: what
/// blinds the rule, as haze, a drop on a lens or coarse pictures, does not blind this.
inline constexpr Field kOverlooked{20, 1};
/// The cameras do not show the same moment: a motion began or ended in one image alone. Until one begins in both at
/// once (hls/stages/moments.hpp).
inline constexpr Field kOutOfStep{21, 1};
}  // namespace frame_faults_machine

/// Whether both cameras see the same world, compared coarsely over all depths. Locked while CONTROL.enable is 1.
namespace agreement {
inline constexpr std::uint32_t kAddress = 0x130;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x4D3D11;
/// 1 = clear is earned. 0 = a pixel is clear where images do not agree; nothing else is checked.
inline constexpr Field kProve{0, 1};
/// 1 = shifts below 0 are nearer to the cameras than the skin.
inline constexpr Field kNearerBelow{1, 1};
/// 1 = shifts above 0 are.
inline constexpr Field kNearerAbove{2, 1};
/// Cells, two's complement, -30 to 30: lowest shift that means a place in front of both cameras.
inline constexpr Field kShiftLowest{3, 6};
/// Cells: the highest one.
inline constexpr Field kShiftHighest{9, 6};
/// AGREEMENT_LIMITS.unproven for the cells of the skin alone, in 1/256: so that a small skin is judged for itself.
inline constexpr Field kUnprovenSkin{15, 8};
}  // namespace agreement

/// Shares in 1/256.
namespace agreement_limits {
inline constexpr std::uint32_t kAddress = 0x134;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x1A73406B;
/// Fewer of the textured cells explained by some depth are a fault, `disagree`.
inline constexpr Field kExplained{0, 8};
/// More of the textured cells in regions of which less than a fifth is explained are, too.
inline constexpr Field kRegions{8, 8};
/// More of the textured cells around which less than a third is explained are, too.
inline constexpr Field kUnproven{16, 8};
/// More of the cells nearer than the skin, for HIDDEN.frames, are a fault.
inline constexpr Field kHidden{24, 8};
}  // namespace agreement_limits

/// How long something may stand between cameras and skin.
namespace hidden {
inline constexpr std::uint32_t kAddress = 0x138;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x32;
/// Frames in a row, 1 to 255; 0 = for ever, but for a frame with another table, of whose skin three quarters are
/// hidden. Where tables take turns, a frame in which it is not counts half.
inline constexpr Field kFrames{0, 8};
}  // namespace hidden

/// How far the right image may be displaced across the rows. In 1/32 cell: 1/4 px in `vga`, 1/2 px in `hd`.
namespace registration {
inline constexpr std::uint32_t kAddress = 0x13C;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0xF988143;
/// A median of this or more is a fault, of the image or, in opposite directions, of two halves of it.
inline constexpr Field kMoved{0, 6};
/// In one half of the image a median of this or more is.
inline constexpr Field kMovedHalf{6, 6};
/// 1/8 px: the same at full resolution, of most places of two rounds (hls/stages/patches.hpp); nothing is safe before
/// rounds have few such places; 63 = never, and not waited for.
inline constexpr Field kPatches{12, 6};
/// 1/32: more of a round's places at full resolution on the skin, or of the skin's textured cells, without an alarm,
/// are the fault `overlooked`; 31 = never.
inline constexpr Field kOnSkin{18, 5};
/// 4 cells: so many on the skin are no fault, whatever share they are.
inline constexpr Field kOnSkinCells{23, 8};
}  // namespace registration

/// Slope of the epipolar lines in the transformed images, two's complement.
namespace epipolar {
inline constexpr std::uint32_t kAddress = 0x140;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x0;
/// Of the first cell: cells down for a shift of one cell to the right, 2^-15.
inline constexpr Field kSlope{0, 16};
/// Its change from column to column of cells, 2^-20.
inline constexpr Field kColumn{16, 16};
}  // namespace epipolar

/// More of it.
namespace epipolar_change {
inline constexpr std::uint32_t kAddress = 0x144;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x0;
/// Its change from row to row, 2^-20.
inline constexpr Field kRow{0, 16};
/// Change of the one with the other, 2^-24.
inline constexpr Field kBoth{16, 16};
}  // namespace epipolar_change

/// What the frame showed, in cells (AGREEMENT); this and the following change up to some rows before the others.
namespace frame_agreement {
inline constexpr std::uint32_t kAddress = 0x150;
inline constexpr Access kAccess = Access::kReadOnly;
/// Cells with texture.
inline constexpr Field kTextured{0, 16};
/// Of these: explained by some depth.
inline constexpr Field kExplained{16, 16};
}  // namespace frame_agreement

/// More of it.
namespace frame_cells {
inline constexpr std::uint32_t kAddress = 0x154;
inline constexpr Access kAccess = Access::kReadOnly;
/// Cells that exist in both images.
inline constexpr Field kSupervised{0, 16};
/// Explained cells nearer than the skin.
inline constexpr Field kNearer{16, 16};
}  // namespace frame_cells

/// More of it.
namespace frame_unproven {
inline constexpr std::uint32_t kAddress = 0x158;
inline constexpr Access kAccess = Access::kReadOnly;
/// Textured cells around which less than a third is explained.
inline constexpr Field kCells{0, 16};
/// Textured cells in regions of which less than a fifth is.
inline constexpr Field kBadRegions{16, 16};
}  // namespace frame_unproven

/// Displacement of the right image across the rows, upper left quarter.
namespace frame_across_0 {
inline constexpr std::uint32_t kAddress = 0x15C;
inline constexpr Access kAccess = Access::kReadOnly;
/// Two's complement, of all cells, in 1/32 cell.
inline constexpr Field kSum{0, 20};
/// Cells.
inline constexpr Field kCells{20, 12};
}  // namespace frame_across_0

/// Displacement of the right image across the rows, upper right quarter.
namespace frame_across_1 {
inline constexpr std::uint32_t kAddress = 0x160;
inline constexpr Access kAccess = Access::kReadOnly;
/// Two's complement, of all cells, in 1/32 cell.
inline constexpr Field kSum{0, 20};
/// Cells.
inline constexpr Field kCells{20, 12};
}  // namespace frame_across_1

/// Displacement of the right image across the rows, lower left quarter.
namespace frame_across_2 {
inline constexpr std::uint32_t kAddress = 0x164;
inline constexpr Access kAccess = Access::kReadOnly;
/// Two's complement, of all cells, in 1/32 cell.
inline constexpr Field kSum{0, 20};
/// Cells.
inline constexpr Field kCells{20, 12};
}  // namespace frame_across_2

/// Displacement of the right image across the rows, lower right quarter.
namespace frame_across_3 {
inline constexpr std::uint32_t kAddress = 0x168;
inline constexpr Access kAccess = Access::kReadOnly;
/// Two's complement, of all cells, in 1/32 cell.
inline constexpr Field kSum{0, 20};
/// Cells.
inline constexpr Field kCells{20, 12};
}  // namespace frame_across_3

/// Of the left image, beside strong edges: its fine detail.
namespace frame_detail_left {
inline constexpr std::uint32_t kAddress = 0x16C;
inline constexpr Access kAccess = Access::kReadOnly;
/// Second differences in 2 grey levels.
inline constexpr Field kSum{0, 24};
}  // namespace frame_detail_left

/// Of the right image, beside strong edges: its fine detail.
namespace frame_detail_right {
inline constexpr std::uint32_t kAddress = 0x170;
inline constexpr Access kAccess = Access::kReadOnly;
/// Second differences in 2 grey levels.
inline constexpr Field kSum{0, 24};
}  // namespace frame_detail_right

/// Of the left image, beside strong edges: its contrast from cell to cell.
namespace frame_contrast_left {
inline constexpr std::uint32_t kAddress = 0x174;
inline constexpr Access kAccess = Access::kReadOnly;
/// Half grey levels.
inline constexpr Field kSum{0, 24};
}  // namespace frame_contrast_left

/// Of the right image, beside strong edges: its contrast from cell to cell.
namespace frame_contrast_right {
inline constexpr std::uint32_t kAddress = 0x178;
inline constexpr Access kAccess = Access::kReadOnly;
/// Half grey levels.
inline constexpr Field kSum{0, 24};
}  // namespace frame_contrast_right

/// Displacement of the right image across the rows at full resolution, of the last complete round of places
/// (hls/stages/patches.hpp).
namespace frame_patches {
inline constexpr std::uint32_t kAddress = 0x17C;
inline constexpr Access kAccess = Access::kReadOnly;
/// Of them; 0 = no round is complete yet.
inline constexpr Field kPlaces{0, 8};
/// Two's complement, sum over the places in 1/8 px, each at most 2 px.
inline constexpr Field kAcross{8, 12};
/// Beyond REGISTRATION.patches: bit 0 one way; left and right opposite ways; upper and lower. In two rounds one after
/// the other: fault moved.
inline constexpr Field kMoved{20, 3};
/// Places displaced by no more than a pixel along the row.
inline constexpr Field kOnSkin{23, 8};
}  // namespace frame_patches

/// One camera twice: the check of both images against each other (hls/stages/coarse.hpp).
namespace one_camera {
inline constexpr std::uint32_t kAddress = 0x180;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0xC;
/// So many segments of 8 cells must have texture, that the check says anything; 0 = never.
inline constexpr Field kSegments{0, 8};
}  // namespace one_camera

/// Blind camera: a step from a cell of its image to the next one in the row is one that it sees. Cells: 8×8 px, in a
/// build wider than 1024 px 16×16 px.
namespace blind_step {
inline constexpr std::uint32_t kAddress = 0x184;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0xE;
/// Grey levels between the means of both.
inline constexpr Field kGrey{0, 8};
}  // namespace blind_step

/// Blind camera: such steps at a smaller share of the frame's cells than this are a fault. So is a quarter of the
/// strips of four columns of cells, or of the rows of cells, without a step of 3/8 of BLIND_STEP.
namespace blind_share {
inline constexpr std::uint32_t kAddress = 0x188;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x2;
/// 1/256; by default 0.8 %; 0 = never, nor for strips and rows.
inline constexpr Field kOf256{0, 8};
}  // namespace blind_share

/// Frozen camera: so many frames one after another that repeat one of the two before them, but for noise, are a fault
/// (hls/stages/still.hpp).
namespace still_limit {
inline constexpr std::uint32_t kAddress = 0x18C;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x4;
/// Frames; 0 = never: the scene may stand still.
inline constexpr Field kFrames{0, 8};
}  // namespace still_limit

/// Undecidable pixels where something nearer than the skin is seen.
namespace frame_hidden {
inline constexpr std::uint32_t kAddress = 0x190;
inline constexpr Access kAccess = Access::kReadOnly;
/// Pixels of the result.
inline constexpr Field kPixels{0, 24};
}  // namespace frame_hidden

/// Undecidable pixels that nothing has shown both cameras to see.
namespace frame_unproven_pixels {
inline constexpr std::uint32_t kAddress = 0x194;
inline constexpr Access kAccess = Access::kReadOnly;
/// Pixels of the result.
inline constexpr Field kPixels{0, 24};
}  // namespace frame_unproven_pixels

/// Which region FRAME_REGION tells of.
namespace region_select {
inline constexpr std::uint32_t kAddress = 0x198;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x0;
/// 0 to 47: 8 in a row, from the upper left.
inline constexpr Field kRegion{0, 6};
}  // namespace region_select

/// Cells of the region.
namespace frame_region {
inline constexpr std::uint32_t kAddress = 0x19C;
inline constexpr Access kAccess = Access::kReadOnly;
/// With texture.
inline constexpr Field kTextured{0, 10};
/// Of these: explained.
inline constexpr Field kExplained{10, 10};
/// Of these: nearer than the skin.
inline constexpr Field kNearer{20, 10};
}  // namespace frame_region

/// An object, pixels that touch each other and are in the skin or blind (BLOCKS), of this many pixels is an alarm, at
/// once (hls/stages/objects.hpp).
namespace object_limit {
inline constexpr std::uint32_t kAddress = 0x1A0;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x3E8;
/// Pixels of the result; more than the result has = never.
inline constexpr Field kPixels{0, 24};
}  // namespace object_limit

/// The largest object; this, the following two and FRAME_OBJECT_AREA change some clocks before the others.
namespace frame_object {
inline constexpr std::uint32_t kAddress = 0x1A4;
inline constexpr Access kAccess = Access::kReadOnly;
/// Pixels of the result; 0 = none.
inline constexpr Field kPixels{0, 24};
}  // namespace frame_object

/// Its box.
namespace frame_object_columns {
inline constexpr std::uint32_t kAddress = 0x1A8;
inline constexpr Access kAccess = Access::kReadOnly;
/// First column, px of the result.
inline constexpr Field kLeft{0, 12};
/// Last column.
inline constexpr Field kRight{16, 12};
}  // namespace frame_object_columns

/// Its box.
namespace frame_object_rows {
inline constexpr std::uint32_t kAddress = 0x1AC;
inline constexpr Access kAccess = Access::kReadOnly;
/// First row.
inline constexpr Field kTop{0, 12};
/// Last row.
inline constexpr Field kBottom{16, 12};
}  // namespace frame_object_rows

/// Blocks of the result, 8×8 px, in a build wider than 1024 px 16×16 px, and how many of their pixels cannot be
/// decided.
namespace blocks {
inline constexpr std::uint32_t kAddress = 0x1B0;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0x20;
/// 1 = a block is blind that has more undecidable pixels than were taught, and a margin; they count as pixels of an
/// object. Before anything was taught since enable: than the margin.
inline constexpr Field kWatch{0, 1};
/// 1 = the largest number is kept of each block, and every frame has the fault `teaching`. The first frame forgets what
/// was taught before, and so does a frame with another fault or an alarm, each of the two frames after one, and a frame
/// of another rule.
inline constexpr Field kTeach{1, 1};
/// 1/64 of a block's pixels.
inline constexpr Field kMargin{2, 8};
/// 1 = every second frame that teaches, from the first on, is looked at as half of the light would show it
/// (hls/stages/dim.hpp): what could not be decided then is taught, too. Such a frame is never `too_undecidable`.
inline constexpr Field kDim{10, 1};
}  // namespace blocks

/// Undecidable pixels of blind blocks; changes some clocks before the others.
namespace frame_blind {
inline constexpr std::uint32_t kAddress = 0x1B4;
inline constexpr Access kAccess = Access::kReadOnly;
/// Pixels of the result.
inline constexpr Field kPixels{0, 24};
}  // namespace frame_blind

/// What is taught.
namespace taught {
inline constexpr std::uint32_t kAddress = 0x1B8;
inline constexpr Access kAccess = Access::kReadOnly;
/// Frames that have taught, before the one that is output, since it was begun or forgotten; at most 65535.
inline constexpr Field kFrames{0, 16};
}  // namespace taught

/// What it covers of the skin, by the table's areas (OBJECT_AREA_LIMIT).
namespace frame_object_area {
inline constexpr std::uint32_t kAddress = 0x1BC;
inline constexpr Access kAccess = Access::kReadOnly;
/// 1/1024 mm², at most 4,194,303.999 mm².
inline constexpr Field kOf1024{0, 32};
}  // namespace frame_object_area

/// And so is an object that covers this much of the skin, by the table's areas. A pixel of a table without areas covers
/// 1023.999 mm².
namespace object_area_limit {
inline constexpr std::uint32_t kAddress = 0x1C0;
inline constexpr Access kAccess = Access::kReadWrite;
inline constexpr std::uint32_t kReset = 0xFFFFFFFF;
/// 1/1024 mm²; all ones = never.
inline constexpr Field kOf1024{0, 32};
}  // namespace object_area_limit

/// Every fault, as its bit of 64: FAULTS_CAMERAS is the lower word, FAULTS_MACHINE the upper.
enum class Fault : std::uint8_t {
  left_short_line = 0,
  left_long_line = 1,
  left_missing_line = 2,
  left_missing_start = 3,
  left_silent = 4,
  left_overflow = 5,
  left_black = 6,
  left_white = 7,
  left_constant = 8,
  left_frozen = 9,
  left_parity = 10,
  left_blind = 11,
  left_unsharp = 12,
  left_torn = 13,
  right_short_line = 16,
  right_long_line = 17,
  right_missing_line = 18,
  right_missing_start = 19,
  right_silent = 20,
  right_overflow = 21,
  right_black = 22,
  right_white = 23,
  right_constant = 24,
  right_frozen = 25,
  right_parity = 26,
  right_blind = 27,
  right_unsharp = 28,
  right_torn = 29,
  skew = 32,
  store_miss = 33,
  no_table = 34,
  map_crc = 35,
  map_busy = 36,
  too_undecidable = 37,
  too_unsupervised = 38,
  late = 39,
  internal = 40,
  identical_images = 41,
  one_camera = 42,
  disagree = 43,
  unproven = 44,
  moved = 45,
  hidden = 46,
  settings = 47,
  restart = 48,
  objects = 49,
  contactors = 50,
  teaching = 51,
  overlooked = 52,
  out_of_step = 53,
};

struct NamedFault {
  Fault fault;
  std::string_view name;
};

inline constexpr std::array<NamedFault, 50> kFaults = {{
    {Fault::left_short_line, "left_short_line"},
    {Fault::left_long_line, "left_long_line"},
    {Fault::left_missing_line, "left_missing_line"},
    {Fault::left_missing_start, "left_missing_start"},
    {Fault::left_silent, "left_silent"},
    {Fault::left_overflow, "left_overflow"},
    {Fault::left_black, "left_black"},
    {Fault::left_white, "left_white"},
    {Fault::left_constant, "left_constant"},
    {Fault::left_frozen, "left_frozen"},
    {Fault::left_parity, "left_parity"},
    {Fault::left_blind, "left_blind"},
    {Fault::left_unsharp, "left_unsharp"},
    {Fault::left_torn, "left_torn"},
    {Fault::right_short_line, "right_short_line"},
    {Fault::right_long_line, "right_long_line"},
    {Fault::right_missing_line, "right_missing_line"},
    {Fault::right_missing_start, "right_missing_start"},
    {Fault::right_silent, "right_silent"},
    {Fault::right_overflow, "right_overflow"},
    {Fault::right_black, "right_black"},
    {Fault::right_white, "right_white"},
    {Fault::right_constant, "right_constant"},
    {Fault::right_frozen, "right_frozen"},
    {Fault::right_parity, "right_parity"},
    {Fault::right_blind, "right_blind"},
    {Fault::right_unsharp, "right_unsharp"},
    {Fault::right_torn, "right_torn"},
    {Fault::skew, "skew"},
    {Fault::store_miss, "store_miss"},
    {Fault::no_table, "no_table"},
    {Fault::map_crc, "map_crc"},
    {Fault::map_busy, "map_busy"},
    {Fault::too_undecidable, "too_undecidable"},
    {Fault::too_unsupervised, "too_unsupervised"},
    {Fault::late, "late"},
    {Fault::internal, "internal"},
    {Fault::identical_images, "identical_images"},
    {Fault::one_camera, "one_camera"},
    {Fault::disagree, "disagree"},
    {Fault::unproven, "unproven"},
    {Fault::moved, "moved"},
    {Fault::hidden, "hidden"},
    {Fault::settings, "settings"},
    {Fault::restart, "restart"},
    {Fault::objects, "objects"},
    {Fault::contactors, "contactors"},
    {Fault::teaching, "teaching"},
    {Fault::overlooked, "overlooked"},
    {Fault::out_of_step, "out_of_step"},
}};

/// One line of the register map.
struct Register {
  std::string_view name;
  std::uint32_t address;
  Access access;
  bool locked;  ///< writes are refused while CONTROL.enable is 1
};

inline constexpr std::array<Register, 92> kRegisters = {{
    {"id", 0x000, Access::kReadOnly, false},
    {"version", 0x004, Access::kReadOnly, false},
    {"build_size", 0x008, Access::kReadOnly, false},
    {"build_store", 0x00C, Access::kReadOnly, false},
    {"build_window", 0x010, Access::kReadOnly, false},
    {"build_clock", 0x014, Access::kReadOnly, false},
    {"build_compete", 0x018, Access::kReadOnly, false},
    {"control", 0x040, Access::kReadWrite, false},
    {"mode", 0x044, Access::kReadWrite, true},
    {"status", 0x048, Access::kReadOnly, false},
    {"width", 0x04C, Access::kReadWrite, true},
    {"height", 0x050, Access::kReadWrite, true},
    {"lookahead", 0x054, Access::kReadWrite, true},
    {"timeout", 0x058, Access::kReadWrite, false},
    {"table_select", 0x05C, Access::kReadWrite, false},
    {"irq_enable", 0x060, Access::kReadWrite, false},
    {"irq_status", 0x064, Access::kWriteOneToClear, false},
    {"interlock", 0x068, Access::kReadWrite, true},
    {"restart", 0x06C, Access::kWriteStream, false},
    {"feedback", 0x070, Access::kReadWrite, true},
    {"sum_limit", 0x080, Access::kReadWrite, false},
    {"self_limit", 0x084, Access::kReadWrite, false},
    {"texture_limit", 0x088, Access::kReadWrite, false},
    {"alarm_limit", 0x08C, Access::kReadWrite, false},
    {"alarm_frames", 0x090, Access::kReadWrite, true},
    {"unsupervised_limit", 0x094, Access::kReadWrite, false},
    {"black_level", 0x0A0, Access::kReadWrite, false},
    {"black_limit", 0x0A4, Access::kReadWrite, false},
    {"white_level", 0x0A8, Access::kReadWrite, false},
    {"white_limit", 0x0AC, Access::kReadWrite, false},
    {"constant_limit", 0x0B0, Access::kReadWrite, false},
    {"frozen_limit", 0x0B4, Access::kReadWrite, false},
    {"decision", 0x0B8, Access::kReadWrite, false},
    {"compete", 0x0BC, Access::kReadWrite, false},
    {"map_slot", 0x0C0, Access::kReadWrite, false},
    {"map_base", 0x0C4, Access::kReadWrite, false},
    {"map_control", 0x0C8, Access::kWriteStream, false},
    {"map_data", 0x0CC, Access::kWriteStream, false},
    {"map_status", 0x0D0, Access::kReadOnly, false},
    {"map_valid", 0x0D4, Access::kReadOnly, false},
    {"map_crc", 0x0D8, Access::kReadOnly, false},
    {"map_undecidable_limit", 0x0DC, Access::kReadWrite, false},
    {"faults_cameras", 0x0E0, Access::kWriteOneToClear, false},
    {"faults_machine", 0x0E4, Access::kWriteOneToClear, false},
    {"map_extent", 0x0E8, Access::kReadOnly, false},
    {"frame_sequence", 0x100, Access::kReadOnly, false},
    {"frame_status", 0x104, Access::kReadOnly, false},
    {"frame_faults_cameras", 0x108, Access::kReadOnly, false},
    {"frame_table_crc", 0x10C, Access::kReadOnly, false},
    {"frame_skin", 0x110, Access::kReadOnly, false},
    {"frame_undecidable", 0x114, Access::kReadOnly, false},
    {"frame_unsupervised", 0x118, Access::kReadOnly, false},
    {"frame_misses", 0x11C, Access::kReadOnly, false},
    {"frame_cycles", 0x120, Access::kReadOnly, false},
    {"frame_latency", 0x124, Access::kReadOnly, false},
    {"frame_tail", 0x128, Access::kReadOnly, false},
    {"frame_faults_machine", 0x12C, Access::kReadOnly, false},
    {"agreement", 0x130, Access::kReadWrite, true},
    {"agreement_limits", 0x134, Access::kReadWrite, false},
    {"hidden", 0x138, Access::kReadWrite, false},
    {"registration", 0x13C, Access::kReadWrite, false},
    {"epipolar", 0x140, Access::kReadWrite, false},
    {"epipolar_change", 0x144, Access::kReadWrite, false},
    {"frame_agreement", 0x150, Access::kReadOnly, false},
    {"frame_cells", 0x154, Access::kReadOnly, false},
    {"frame_unproven", 0x158, Access::kReadOnly, false},
    {"frame_across_0", 0x15C, Access::kReadOnly, false},
    {"frame_across_1", 0x160, Access::kReadOnly, false},
    {"frame_across_2", 0x164, Access::kReadOnly, false},
    {"frame_across_3", 0x168, Access::kReadOnly, false},
    {"frame_detail_left", 0x16C, Access::kReadOnly, false},
    {"frame_detail_right", 0x170, Access::kReadOnly, false},
    {"frame_contrast_left", 0x174, Access::kReadOnly, false},
    {"frame_contrast_right", 0x178, Access::kReadOnly, false},
    {"frame_patches", 0x17C, Access::kReadOnly, false},
    {"one_camera", 0x180, Access::kReadWrite, false},
    {"blind_step", 0x184, Access::kReadWrite, false},
    {"blind_share", 0x188, Access::kReadWrite, false},
    {"still_limit", 0x18C, Access::kReadWrite, false},
    {"frame_hidden", 0x190, Access::kReadOnly, false},
    {"frame_unproven_pixels", 0x194, Access::kReadOnly, false},
    {"region_select", 0x198, Access::kReadWrite, false},
    {"frame_region", 0x19C, Access::kReadOnly, false},
    {"object_limit", 0x1A0, Access::kReadWrite, false},
    {"frame_object", 0x1A4, Access::kReadOnly, false},
    {"frame_object_columns", 0x1A8, Access::kReadOnly, false},
    {"frame_object_rows", 0x1AC, Access::kReadOnly, false},
    {"blocks", 0x1B0, Access::kReadWrite, false},
    {"frame_blind", 0x1B4, Access::kReadOnly, false},
    {"taught", 0x1B8, Access::kReadOnly, false},
    {"frame_object_area", 0x1BC, Access::kReadOnly, false},
    {"object_area_limit", 0x1C0, Access::kReadWrite, false},
}};

}  // namespace horopter::registers
