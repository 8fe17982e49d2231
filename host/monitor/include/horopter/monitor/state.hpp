// SPDX-License-Identifier: Apache-2.0
// What a running monitor shows: to its outputs, its log and its page. Values only; nothing here decides.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "horopter/image/image.hpp"
#include "horopter/machine/monitor.hpp"

namespace horopter::monitor {

/// Of this computer, for ages and waits; nobody can set it.
using Clock = std::chrono::steady_clock;
/// For people.
using Time = std::chrono::system_clock::time_point;

/// Why it is not safe, or was not.
struct Cause {
  std::string name;    ///< as in registers.yaml (`left_late`), or of the monitor: `alarm`, `skew`, `camera_lost`, …
  std::string text;    ///< what is wrong, one sentence
  std::string advice;  ///< what to do, one sentence; may be empty
  friend bool operator==(const Cause&, const Cause&) = default;
};

struct CameraState {
  std::string name;    ///< as in rig.yaml
  std::string source;  ///< as in cell.yaml, without passwords
  bool connected = false;
  std::uint64_t frames = 0;        ///< that came
  std::uint64_t dropped = 0;       ///< of these, never judged
  std::uint64_t lost_packets = 0;  ///< of the transport, where it tells
  std::uint64_t repeated = 0;
  double frames_per_s = 0;
  std::optional<double> exposure_us;  ///< where the camera tells
  double sharpness = 0;               ///< as in summary.json
};

/// Something in the skin, followed from frame to frame.
struct ObjectState {
  int id = 0;
  std::int64_t pixels = 0;
  std::int64_t blind_pixels = 0;
  int x = 0;  ///< box in the left image (after sub-sampling)
  int y = 0;
  int width = 0;
  int height = 0;
  int age_frames = 0;
  std::optional<double> size_mm;      ///< with a rig: its length
  std::optional<double> distance_mm;  ///< of its centre from the left camera
  std::optional<double> speed_mm_s;
};

enum class Restart { not_needed, needed, possible };  ///< possible: the last frames were good

/// The monitor at one moment.
struct Status {
  Time time{};
  std::uint64_t frame = 0;  ///< pairs judged since the start
  bool safe = false;        ///< as the outputs say it
  bool alarm = false;
  Restart restart = Restart::needed;
  std::uint64_t stops = 0;  ///< one more when it is no longer safe, or a restart no longer possible; begins anywhere
  bool restart_by_itself = false;
  std::vector<Cause> causes;   ///< of now; empty while safe
  std::vector<Cause> latched;  ///< of the last stop and since then, until the restart
  std::vector<ObjectState> objects;
  std::vector<CameraState> cameras;  ///< left, right
  std::optional<double> skew_ms;     ///< between the two images of the last pair
  std::optional<double> explained;   ///< share of the textured cells, 0 to 1
  bool teaching = false;
  bool taught = false;
  int table = 15;  ///< slot, 15 = none
  std::uint32_t table_crc = 0;
  double decision_ms = 0;  ///< from the later image's arrival to the decision
};

/// A pair that was judged, with all that belongs to it. Never changes.
struct Moment {
  Clock::time_point arrived{};  ///< the later image
  Image left;
  Image right;
  FrameResult result;
  Status status;
};
using MomentPtr = std::shared_ptr<const Moment>;

/// Who did something, for the log.
struct Actor {
  std::string name;  ///< user, or `button`, `configuration`
  std::string address;
};

/// What page and outputs may ask of a running monitor. All are safe to call from any thread and return at once.
class Control {
 public:
  virtual ~Control() = default;
  [[nodiscard]] virtual Status status() const = 0;
  /// The last pair; null before the first.
  [[nodiscard]] virtual MomentPtr latest() const = 0;
  /// `stops`: those of the status that somebody has looked after. False, with the reason in `why`, where it cannot be;
  /// true: it was given to the machine's interlock, which decides.
  virtual bool restart(const Actor& actor, std::uint64_t stops, std::string& why) = 0;
  /// The next `frames` pairs show the zone empty. `stops` as with restart().
  virtual bool teach(int frames, const Actor& actor, std::uint64_t stops, std::string& why) = 0;
};

/// Told of everything; called in the order of time, never by two threads at once. What takes long is for a thread of its
/// own: the decision waits.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual void judged(const MomentPtr& /*moment*/) {}
  /// No longer safe. `moment` is the pair that did it; null where none came.
  virtual void stopped(const Status& /*status*/, const MomentPtr& /*moment*/) {}
  /// Safe again, after a restart.
  virtual void released(const Status& /*status*/, const Actor& /*by*/) {}
  /// Something was done by somebody: teach, restart refused, configuration loaded.
  virtual void noted(const Status& /*status*/, const Actor& /*actor*/, const std::string& /*what*/) {}
};

}  // namespace horopter::monitor
