// SPDX-License-Identifier: Apache-2.0
// A running monitor: pairs of live images to the machine, its decision to whoever must know. The machine's interlock alone
// decides when it is safe again; what the monitor finds wrong takes safe away from it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "horopter/base/error.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/machine/object_follower.hpp"
#include "horopter/map/map.hpp"
#include "horopter/monitor/camera.hpp"
#include "horopter/monitor/cell.hpp"
#include "horopter/monitor/pairing.hpp"
#include "horopter/monitor/part.hpp"
#include "horopter/monitor/safe_state.hpp"
#include "horopter/monitor/state.hpp"

namespace horopter::monitor {

/// The machine for images of a size, with the skin's table.
struct Machine {
  std::shared_ptr<const MapSet> maps;  ///< what `objects` looks at
  std::unique_ptr<Supervisor> supervisor;
  std::unique_ptr<ObjectFollower> objects;
  std::optional<Eigen::Vector3d> camera_mm;  ///< centre of the left camera, with a rig
  double largest_skew_ms = 0;
};
using MakeMachine = std::function<Machine(int width, int height)>;

class Service final : public Control, public CameraSink {
 public:
  /// The machine is made when the size of the images is known: now, where `width` is not 0, or with the first image.
  Service(const Cell& cell, MakeMachine make_machine, int width, int height);
  ~Service() override;
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;

  [[nodiscard]] const SafeState& safe_state() const { return state_; }
  /// Not safe any more. For a program that must end at once, from any thread.
  void end_unsafe() { state_.end(); }
  /// Before run().
  void add(Part* part) { parts_.push_back(part); }
  /// Called with every turn of the decision, whatever the cameras do: who hears nothing knows that it hangs.
  void on_turn(std::function<void()> turn) { turn_ = std::move(turn); }
  /// Until so many pairs were judged (0: for ever), it is asked to stop, or the images have ended. Then it is not safe.
  /// Throws what makes the machine useless, after all were told.
  void run(const std::function<bool()>& asked_to_stop, std::uint64_t pairs);

  // Control
  [[nodiscard]] Status status() const override;
  [[nodiscard]] MomentPtr latest() const override;
  bool restart(const Actor& actor, std::uint64_t stops, std::string& why) override;
  bool teach(int frames, const Actor& actor, std::uint64_t stops, std::string& why) override;

  // CameraSink
  void frame(Side side, CameraFrame frame) override;
  void connected(Side side) override;
  void lost(Side side, const std::string& why) override;
  void ended(Side side) override;

 private:
  struct Request {
    Actor actor;
    Clock::time_point at{};
    int frames = 0;
  };
  struct Link {
    bool connected = false;
    bool was_connected = false;
    bool ended = false;
    std::string why;
    std::optional<double> exposure_us;
  };

  void loop(const std::function<bool()>& asked_to_stop, std::uint64_t pairs);
  std::optional<ImagePair> wait_for_pair();
  bool images_ended();
  [[nodiscard]] bool is_told_safe() const;
  /// `taken`: pairs that were taken before, and are not judged.
  void start_machine(int width, int height, std::uint64_t taken);
  void idle();
  void judge(ImagePair pair);
  std::vector<Cause> own_causes(MonitorFaults own, std::vector<Cause> causes);
  MonitorFaults faults_of_parts();
  [[nodiscard]] MonitorFaults missed() const;
  void take_safe_away(MonitorFaults own);
  std::vector<ObjectState> follow(const std::vector<FrameResult>& results, Clock::time_point arrived);
  void begin_request(MonitorFaults own);
  void break_off_teaching(const std::string& why);
  void count_taught();
  void publish(Status status, const MomentPtr& moment);
  void tell(const Status& before, const Status& status, const MomentPtr& moment);
  void note(const Actor& actor, const std::string& what);
  void describe_cameras(Status& status);
  void stop_by(const std::vector<Cause>& causes, FaultWords words);
  void watch();

  Cell cell_;
  MakeMachine make_machine_;
  std::optional<Machine> machine_;
  SafeState state_;
  Duration look_;  ///< the threads wait no longer before they look again
  std::vector<Part*> parts_;
  std::function<void()> turn_;
  Clock::time_point started_ = Clock::now();

  mutable std::mutex intake_mutex_;
  std::condition_variable intake_;
  Pairing pairing_;
  std::array<Link, 2> links_;

  mutable std::mutex status_mutex_;
  Status status_;
  MomentPtr latest_;
  std::optional<Request> restart_request_;
  std::optional<Request> teach_request_;

  std::mutex listeners_mutex_;  ///< before status_mutex_
  bool untold_stop_ = false;

  // Of the decision alone.
  MonitorFaults pending_;  ///< found without a pair
  bool tripped_ = false;   ///< the machine says so with its next frame
  std::vector<std::string> troubles_;
  std::vector<Cause> told_causes_;
  Clock::time_point causes_told_{};
  Clock::time_point alarm_told_{};
  bool untold_alarm_ = false;        ///< one that is there, while it is not safe anyway
  std::optional<Actor> restarting_;  ///< the key was given; the next pair shows what came of it
  Actor released_by_{"configuration", ""};
  Actor teacher_;
  int to_teach_ = 0;

  std::atomic<bool> watching_ = true;
  std::thread watch_;  // the last: it uses the others
};

}  // namespace horopter::monitor
