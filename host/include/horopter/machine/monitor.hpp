// SPDX-License-Identifier: Apache-2.0
// The driver that all devices share: configures, uploads tables, supervises image pairs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "horopter/base/profile.hpp"
#include "horopter/hls/settings.hpp"
#include "horopter/machine/blind_watch.hpp"
#include "horopter/machine/device.hpp"
#include "horopter/machine/faults.hpp"
#include "horopter/machine/proof.hpp"
#include "horopter/map/map.hpp"

namespace horopter {

using hls::CompeteSettings;

/// What lets safe_o rise at start, and after an alarm or a fault (register INTERLOCK).
struct Interlock {
  bool by_itself = false;    ///< nobody has to restart
  bool by_pin = true;        ///< a press of restart_i
  bool by_register = false;  ///< restart()
  double feedback_ms = 0;    ///< contactors must follow safe_o in this time (register FEEDBACK); 0 = there are none
  int frames = 2;            ///< without fault and alarm that must lie before a restart, 1 to 15
};

/// An alarm is one that so many of the last frames show, the newest among them (register ALARM_FRAMES).
struct AlarmFrames {
  static constexpr int kMost = 7;
  int needed = 1;
  int of = 1;
  bool possible() const { return 1 <= needed && needed <= of && of <= kMost; }
  /// "2/3". Throws UsageError with what was expected.
  static AlarmFrames parse(const std::string& text);
};

struct Settings {
  Decision decision = Decision::thesis;  ///< the profile and the machine must have it
  CompeteSettings competition;
  // Of `thesis`:
  double threshold_percent = hls::percent::sum_limit;  ///< of the largest DSAD sum, 15·k²; at most this is in the skin
  int texture = hls::StageSettings{}.texture_limit /
                9;                   ///< mean of the left unscaled Sobel magnitude that makes a pixel decidable
  double self_percent = 100.0 / 15;  ///< of 15·k²; a window whose directions vary less is no texture. Default: k²
  // Of both:
  double alarm_percent = hls::percent::alarm_limit;  ///< of the result's pixels; more skin pixels are an alarm
  /// An object on the skin that is this many px across in the left image is an alarm; 0 = none is. object_limit() says how
  /// many pixels that is.
  double object_px = 100;
  /// Where it is not 0: a body this many mm across is, wherever it is. object_area_limit() says what area that is, and no
  /// number of pixels is an alarm. object_px must be what it has where the skin is farthest. For tables that know areas.
  double object_mm = 0;
  /// Above 1 of 1 only where a body is in the skin for as many frames.
  AlarmFrames alarm_frames;
  BlindSettings blind;  ///< what counts as an object where nothing can be decided
  /// Of supported_pixels (support.hpp); more are a fault. Noise alone leaves more undecidable with `thesis`; `compete`
  /// decides some of it, the more the stronger it is (its votes gather in patches).
  double undecidable_percent = 80;
  double unsupervised_percent = 99;                      ///< of the result's pixels; more are a fault
  int frozen_limit = hls::StageSettings{}.frozen_limit;  ///< repetitions of a frame that are a fault; 0 = never
  double dark_percent = hls::percent::dark_limit;        ///< of the incoming pixels; more dark ones are a black image
  double bright_percent = hls::percent::bright_limit;    ///< the same for white
  Proof proof;
  Interlock interlock;
  bool live = false;  ///< the cameras cannot wait (register MODE)
  /// Of 256 cells of the incoming image; a camera that sees a step to the next cell at fewer is blind.
  int blind_share = hls::StageSettings{}.blind_share;
  int blind_step = hls::StageSettings{}.blind_step;  ///< such a step, in grey levels
  /// Frames one after another that repeat an earlier one but for noise and are a fault; 0 = the scene may stand still.
  int still_limit = hls::StageSettings{}.still_limit;
  /// Segments that must have texture, that one camera twice is told; 0 = never.
  int one_camera_segments = hls::StageSettings{}.one_camera_segments;
  /// Results a second that the cameras give; a machine without one for the time of two has a fault (register TIMEOUT).
  std::optional<double> results_per_s;

  /// The rule alone, for pictures that are no sequence of two cameras: a pixel is clear where they do not agree.
  Settings without_proof() const {
    Settings settings = *this;
    settings.proof.needed = false;
    settings.blind_share = 0;
    settings.still_limit = 0;
    settings.one_camera_segments = 0;
    return settings;
  }
};

/// What a frame showed of both cameras' world, in cells (hls/stages/agreement.hpp).
struct Agreement {
  int supervised = 0;
  int textured = 0;
  int explained = 0;
  int nearer = 0;
  int unproven = 0;
  int bad_regions = 0;
  struct Region {
    int textured = 0;
    int explained = 0;
    int nearer = 0;
  };
  std::array<Region, 48> regions;  ///< 8 in a row
  // Of the right image against the rig, px of the result; nothing where too little was found.
  std::optional<double>
      across_px;  ///< down the column; along the row nothing can be told from a scene of unknown depth
  std::optional<double> roll_deg;
  std::optional<double> scale;
  /// At full resolution (hls/stages/patches.hpp): places of the last complete round, and their mean displacement down.
  int patches = 0;
  std::optional<double> patches_across_px;
  /// Fine detail in proportion to the contrast of edges, left and right; 0 without edges.
  std::array<double, 2> sharpness{};
};

/// One result of the machine. Pictures and runs are in pixels of the left image (field) after sub-sampling.
struct FrameResult {
  Image states;  ///< codes of State
  std::vector<Run> runs;
  std::uint32_t sequence = 0;
  std::int64_t skin_pixels = 0;
  std::int64_t undecidable_pixels = 0;
  std::int64_t unsupervised_pixels = 0;
  std::int64_t largest_object_pixels = 0;  ///< pixels that touch each other and are in the skin or blind
  std::int64_t object_limit_pixels = 0;    ///< an object of so many is an alarm; of an area: the fewest it can have
  std::uint32_t largest_object_area = 0;   ///< of the same object, 1/1024 mm² (horopter/hls/area.hpp)
  std::uint32_t object_area_limit = 0;     ///< an object of so much is an alarm, and no number of pixels; 0: pixels are
  std::vector<std::uint8_t> areas;         ///< of the table that made it, as in its facts; empty: not known
  std::int64_t blind_pixels = 0;           ///< undecidable, where that could be decided when it was taught
  std::vector<std::uint8_t> blind;         ///< of each pixel: 1 = it is one of these; empty where none can be
  std::int64_t hidden_pixels = 0;          ///< undecidable: something nearer than the skin is seen there
  std::int64_t unproven_pixels = 0;        ///< undecidable: nothing shows that both cameras see their place
  Agreement agreement;
  bool alarm = false;
  bool seen = false;  ///< would be one if this frame alone counted (Settings::alarm_frames)
  bool safe = false;
  int table = 15;  ///< slot, 15 = none
  std::uint32_t table_crc = 0;
  Faults faults;
  std::uint32_t cycles = 0;   ///< first pixel in to last state out, clocks
  std::uint32_t latency = 0;  ///< first pixel in to first state out, clocks
  std::uint32_t tail = 0;     ///< last pixel in to last state out, clocks
  Scan scan = Scan::progressive;
  std::optional<double> skin_time_s;  ///< of a moving skin's motion
};

/// Pixels of the result of which an object is an alarm: half the disc that is settings.object_px across, for what the
/// windows, places without texture and the majority leave of it. More than a frame has where none is.
std::int64_t object_limit(const Settings& settings, const MachineProfile& profile);
/// Half the disc that is settings.object_mm across.
double half_disc_mm2(const Settings& settings);
/// Area of the skin of which an object is an alarm, 1/1024 mm²: that, less what a table's code can be too small. 0 where
/// pixels are. Throws UsageError for a size that no area stands for.
std::uint32_t object_area_limit(const Settings& settings);
/// The same in mm².
double object_area_limit_mm2(const Settings& settings);
/// px of the left image across: half of what is smaller is not certain to be one object, as windows and majority leave too
/// little of it (disc_table.def).
double smallest_object_px(const MachineProfile& profile);
double smallest_object_px();  ///< the least of all profiles

/// Takes safe away as a fault does, for who knows more than the machine: by an upload into the table in use, which it
/// refuses. The next frame has the fault `map_busy`, and what is being taught is forgotten. Nothing before the first frame,
/// when it is not safe. Throws DeviceError where it is safe all the same.
void take_safe_away(Device& device);

class Monitor {
 public:
  /// Checks that the device is a Horopter of this profile and version; its build may have one of the profile's two
  /// rules and a smaller pool. Throws DeviceError; UsageError where the profile or the build does not have the
  /// settings' rule.
  Monitor(std::unique_ptr<Device> device, const MachineProfile& profile, const Settings& settings = {});
  ~Monitor();

  /// Sets the geometry and enables the machine. Resets what it has seen of earlier frames.
  void start(int width, int height, int lookahead);
  void stop();

  /// Uploads a table into slot 0 … 14 while the machine runs. The pool is filled slot by slot; throws DeviceError when
  /// it is full or the machine refuses the table. `base_word64`: place in the pool instead, in 8 bytes.
  void upload(int slot, const MapTable& table, std::optional<std::size_t> base_word64 = {});
  /// Table of the next frame: to be called before its begin(), after the output of the frame before has begun.
  void select(int slot);

  /// One frame (or field) of both cameras, of the size given to start().
  FrameResult process(const Image& left, const Image& right);
  /// The two halves of process(). Between them tables that are not in use can be uploaded.
  void begin(const Image& left, const Image& right);
  FrameResult finish();
  /// From the next frame on: learn what cannot be decided, or watch for it (BlindSettings). The zone is empty.
  void teach(bool on);
  /// No more of it, and nothing counts as taught: the next frame still teaches, with the fault of trip(), and so the machine
  /// forgets all. Where it knows nothing it ends at once.
  void break_off_teaching();
  /// take_safe_away() of the device.
  void trip();
  /// What was taught since start().
  const BlindWatch& blind_watch() const { return *blind_watch_; }
  /// Waits until the output of a frame that was begun is made by this table. Throws DeviceError when it never is.
  void wait_for_table(int slot);

  /// The first pair, shown so often, is worth being shown again: it is unproven, and nothing else is wrong with it. At most 60
  /// times.
  [[nodiscard]] bool shows_again(int shown, const FrameResult& result) const;

  /// While it lives, a frame may be that of before: FROZEN_LIMIT and STILL_LIMIT are 0.
  class Repeated {
   public:
    explicit Repeated(Monitor& monitor);
    ~Repeated();
    Repeated(const Repeated&) = delete;
    Repeated& operator=(const Repeated&) = delete;

   private:
    Repeated(Monitor& monitor, std::nullptr_t) : monitor_(monitor) {}  ///< nothing is written yet
    void limit(int frozen, int still);

    Monitor& monitor_;
  };

  Device& device() { return *device_; }
  const MachineProfile& profile() const { return profile_; }
  /// Of the device's mapping tables.
  std::size_t pool_bytes() const { return pool_bytes_; }

 private:
  Agreement read_agreement();

  struct Slot {
    std::size_t base_word64 = 0;
    std::size_t words64 = 0;
    std::vector<std::uint8_t> areas;  ///< of its table's facts
  };

  std::unique_ptr<Device> device_;
  const MachineProfile& profile_;
  Settings settings_;
  std::size_t pool_bytes_ = 0;
  int width_ = 0;
  int height_ = 0;
  std::vector<Slot> slots_;
  std::uint32_t sequence_ = 0;
  std::optional<BlindWatch> blind_watch_;
  bool breaks_off_ = false;  ///< a teaching, with the next frame that has a fault
};

/// A monitor for image pairs of one skin: every image makes one result, or two for profiles that take fields.
class Supervisor {
 public:
  /// Starts the machine and uploads the tables, even fields in slot 0, odd ones in slot 1.
  Supervisor(std::unique_ptr<Device> device, const MachineProfile& profile, const MapSet& maps,
             const Settings& settings = {});

  /// Clear is earned by frames before: the first pair is given to the machine until it is proven (Monitor::shows_again).
  /// Not with Settings::live: it is `unproven` there, as in a machine with cameras of its own.
  std::vector<FrameResult> process(const Image& left, const Image& right);
  Monitor& monitor() { return monitor_; }

 private:
  std::vector<FrameResult> pass(const Image& left, const Image& right);

  Monitor monitor_;
  bool settled_;
  std::vector<ScanGeometry> scans_;
};

}  // namespace horopter
