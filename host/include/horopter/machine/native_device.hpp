// SPDX-License-Identifier: Apache-2.0
// The native engine behind the registers of the hardware: uploads, directory of tables, thresholds, faults. What it
// cannot do is lose pixels: faults of the streams and counts of clocks do not occur.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "horopter/base/profile.hpp"
#include "horopter/machine/device.hpp"
#include "horopter/machine/faults.hpp"
#include "horopter/machine/registers.hpp"

namespace horopter {

namespace native {
class Engine;
struct Settings;
}  // namespace native

class NativeDevice : public Device {
 public:
  /// `live`: two threads share a picture where there are two processors, and HOROPTER_THREADS does not say otherwise.
  /// Throws UsageError where no engine is built for the profile, or the environment asks for threads or instructions
  /// that cannot be.
  explicit NativeDevice(const MachineProfile& profile, bool live = false);
  ~NativeDevice() override;

  std::uint32_t read(std::uint32_t address) override;
  void write(std::uint32_t address, std::uint32_t value) override;
  void send(const Image& left, const Image& right) override;
  FrameStreams receive() override;
  std::string_view engine() const override { return "native"; }
  bool counts_cycles() const override { return false; }
  /// Since it was started. None where each table was uploaded before its first frame.
  int frames_that_expanded_their_table() const;

 private:
  struct Table {
    std::size_t base_word64 = 0;
    std::size_t end_word64 = 0;
    int undecidable_limit = 0;  ///< MAP_UNDECIDABLE_LIMIT at its start
    std::vector<std::uint32_t> words;
  };
  /// As numbered in MAP_STATUS.error.
  enum class UploadError { none, in_use, bad_header, too_large, wrong_crc, no_slot, not_started };

  std::uint32_t& stored(std::uint32_t address);
  bool running() const;
  bool geometry_is_possible() const;
  bool in_use(int slot) const;
  void begin_upload();
  void upload_word(std::uint32_t word);
  void end_upload(UploadError error);
  native::Settings settings() const;  ///< for a frame that begins now
  std::unique_ptr<native::Engine> new_engine() const;
  void reset_stream();
  void prepare(std::size_t slot);
  bool by_itself() const;
  bool released() const { return restarted_ || by_itself(); }
  bool restart_is_allowed() const;
  /// What the next frame shows is an alarm, by the frames before it (register ALARM_FRAMES).
  bool alarm_counts() const;
  void restart(std::uint32_t key);
  void hold();
  void start_frame();
  const Table* active_table() const;
  bool fits(const Table& table) const;  ///< is it for the frames' size?

  const MachineProfile& profile_;
  bool live_;
  std::unique_ptr<native::Engine> engine_;
  std::array<std::uint32_t, 1024> registers_{};  ///< of access rw, by word address
  Faults faults_;
  std::uint32_t irq_status_ = 0;

  std::array<std::optional<Table>, 15> tables_;
  /// Selected for the first of `pending_`, from its arrival on, or for the frame before.
  int active_slot_ = registers::kNoSlot;
  bool has_table_ = false;                                    ///< the active slot
  std::optional<std::uint32_t> crc_before_, crc_two_before_;  ///< of the tables with which the last frames began
  bool same_table_ = false;                                   ///< as the frame before of this field
  std::unique_ptr<native::Settings> frame_settings_;          ///< of the first of `pending_`, from its arrival on
  Faults frame_faults_pending_;                               ///< of the control side since the last frame
  bool uploading_ = false;
  int upload_slot_ = registers::kNoSlot;
  Table upload_;
  std::size_t upload_length_ = 0;  ///< words in all, known after the header
  UploadError upload_error_ = UploadError::none;

  struct Frame {
    std::uint32_t sequence = 0;
    std::uint32_t status = registers::frame_status::kSlot.put(registers::kNoSlot);
    Faults faults;
    std::uint32_t table_crc = 0;
    std::uint32_t skin = 0;
    std::uint32_t undecidable = 0;
    std::uint32_t unsupervised = 0;
    std::uint32_t misses = 0;
    std::uint32_t hidden = 0;
    std::uint32_t unproven_pixels = 0;
    std::array<std::uint32_t, 3> object{};  ///< FRAME_OBJECT and the two registers after it
    std::uint32_t object_area = 0;
    std::uint32_t blind = 0;
    std::array<std::uint32_t, 12> agreement{};  ///< FRAME_AGREEMENT to FRAME_PATCHES
    std::array<std::uint32_t, 64> regions{};    ///< FRAME_REGION
  };
  Frame frame_;
  bool safe_ = false;         // as the pins would say: the last two frames were good
  bool good_before_ = false;  // the last one was
  bool taught_ = false;       // register STATUS
  bool taught_before_ = false;
  unsigned taught_frames_ = 0;     // register TAUGHT
  bool forget_ = false;            // the last frame taught, but perhaps not what is true
  unsigned spoiled_before_ = 0;    // bit n: the frame n + 1 before this one had what spoils those after it
  bool compete_before_ = false;    // the last frame's rule
  bool alarm_discounted_ = false;  // it showed an alarm, and is safe
  bool dim_ = false;               // it was looked at as half of the light would show it
  // The interlock, as rtl/store/horopter_interlock.sv; without a pin.
  bool restarted_ = false;
  unsigned good_frames_ = 0;
  // As rtl/store/horopter_alarm_filter.sv: bit n, the frame n + 1 before this one shows an alarm, or may have.
  static constexpr std::uint32_t kAllSeen = 0xFFFFFFFF;
  std::uint32_t alarms_seen_ = kAllSeen;
  struct Pending {
    Image left;
    Image right;
  };
  std::deque<Pending> pending_;
};

std::unique_ptr<Device> make_native_device(const MachineProfile& profile);
/// For pictures that come by themselves.
std::unique_ptr<Device> make_live_native_device(const MachineProfile& profile);

}  // namespace horopter
