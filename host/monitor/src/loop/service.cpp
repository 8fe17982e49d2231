// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/service.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <random>
#include <utility>

#include "horopter/machine/inspection.hpp"
#include "horopter/machine/registers.hpp"
#include "horopter/map/map_json.hpp"
#include "horopter/monitor/causes.hpp"
#include "horopter/monitor/objects.hpp"

namespace horopter::monitor {
namespace {

namespace reg = registers;

constexpr auto kSides = std::to_array<Side>({Side::left, Side::right});
/// Of the thread that looks at the age of the decision, in its limit.
constexpr int kLooksInLimit = 8;
/// And how soon a service that ends has ended.
constexpr Duration kLongestLook = std::chrono::milliseconds(50);
constexpr const char* kLookAgain = "Something has stopped it since you looked. Look again.";

Duration milliseconds_of(double ms) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double, std::milli>(ms));
}

PairingRules rules_of(const Cell& cell, int width, int height) {
  PairingRules rules;
  rules.period = milliseconds_of(cell.period_ms());
  rules.largest_skew = rules.period / 2;  // until the machine is there
  rules.lost_after = milliseconds_of(cell.decision_limit_ms);
  rules.width = width;
  rules.height = height;
  rules.exposure_may_change = {cell.cameras[0].exposure_may_change, cell.cameras[1].exposure_may_change};
  rules.serials = {cell.cameras[0].serial, cell.cameras[1].serial};
  return rules;
}

FaultWords words_of(MonitorFaults own, const Faults& faults) {
  return {faults.cameras(), faults.machine(), own.word()};
}

bool same_names(const std::vector<Cause>& a, const std::vector<Cause>& b) {
  return std::ranges::equal(a, b, {}, &Cause::name, &Cause::name);
}

void add_others(const std::vector<Cause>& causes, std::vector<Cause>& to) {
  for (const Cause& cause : causes) {
    if (std::ranges::find(to, cause.name, &Cause::name) == to.end()) to.push_back(cause);
  }
}

bool is_good(const FrameResult& result) { return !result.alarm && !result.faults.any(); }

/// Why a pair that teaches may not show the empty zone; empty: it does, as far as the machine sees. In it an alarm is one
/// however few frames show it. `unproven` says nothing of the zone: what such a frame teaches the machine forgets itself.
std::string not_empty(const std::vector<FrameResult>& results) {
  Faults faults;
  bool seen = false;
  for (const FrameResult& result : results) {
    faults |= result.faults;
    seen |= result.seen;
  }
  faults.clear(Faults(Fault::teaching) | Fault::unproven);
  std::vector<std::string> names = faults.names();
  if (seen) names.insert(names.begin(), "alarm");
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The worse one of two fields: what an output says of the pair.
const FrameResult& worst(const std::vector<FrameResult>& results) {
  const auto found = std::ranges::find_if(results, [](const FrameResult& r) { return !is_good(r); });
  return found == results.end() ? results.back() : *found;
}

}  // namespace

Service::Service(const Cell& cell, MakeMachine make_machine, int width, int height)
    : cell_(cell),
      make_machine_(std::move(make_machine)),
      state_(milliseconds_of(cell.decision_limit_ms)),
      look_(std::min(kLongestLook, state_.limit() / kLooksInLimit)),
      pairing_(rules_of(cell, width, height)) {
  status_.time = std::chrono::system_clock::now();
  // What somebody was asked by the program before is no question of this one. JavaScript holds this number exactly.
  status_.stops = std::random_device{}() & 0x7FFFFFFFU;
  status_.causes = status_.latched = causes_of(false, MonitorFault::starting, {});
  status_.restart_by_itself = cell_.settings.interlock.by_itself;
  for (const CameraCell& camera : cell_.cameras) {
    CameraState& state = status_.cameras.emplace_back();
    state.name = camera.name;
    state.source = without_secrets(camera.source);
  }
  state_.not_safe(words_of(MonitorFault::starting, {}));
  if (width != 0) start_machine(width, height, 0);
  watch_ = std::thread([this] { watch(); });
}

Service::~Service() {
  state_.end();
  watching_ = false;
  watch_.join();
}

void Service::start_machine(int width, int height, std::uint64_t taken) {
  machine_ = make_machine_(width, height);
  const std::lock_guard lock(intake_mutex_);
  pairing_.set_size(width, height);
  pairing_.set_largest_skew(milliseconds_of(machine_->largest_skew_ms));
  pairing_.clear(taken);
}

// Cameras -------------------------------------------------------------------------------------------------------------

void Service::frame(Side side, CameraFrame frame) {
  {
    const std::lock_guard lock(intake_mutex_);
    links_.at(static_cast<std::size_t>(side)).exposure_us = frame.exposure_us;
    pairing_.add(side, std::move(frame));
  }
  intake_.notify_one();
}

void Service::connected(Side side) {
  const std::lock_guard lock(intake_mutex_);
  Link& link = links_.at(static_cast<std::size_t>(side));
  if (link.was_connected) pairing_.reconnected(side);
  link = {.connected = true, .was_connected = true, .ended = false, .why = {}, .exposure_us = {}};
}

void Service::lost(Side side, const std::string& why) {
  const std::lock_guard lock(intake_mutex_);
  Link& link = links_.at(static_cast<std::size_t>(side));
  link.connected = false;
  link.why = why;
  pairing_.lost(side);
}

void Service::ended(Side side) {
  {
    const std::lock_guard lock(intake_mutex_);
    links_.at(static_cast<std::size_t>(side)).ended = true;
  }
  intake_.notify_one();
}

std::optional<ImagePair> Service::wait_for_pair() {
  std::unique_lock lock(intake_mutex_);
  intake_.wait_for(lock, look_, [this] { return pairing_.has_pair(); });
  return pairing_.take();
}

bool Service::images_ended() {
  const std::lock_guard lock(intake_mutex_);
  return std::ranges::all_of(links_, &Link::ended) && !pairing_.has_pair();
}

// The decision --------------------------------------------------------------------------------------------------------

void Service::run(const std::function<bool()>& asked_to_stop, std::uint64_t pairs) {
  try {
    loop(asked_to_stop, pairs);
    state_.end();
    if (is_told_safe()) stop_by(causes_of(false, MonitorFault::ending, {}), words_of(MonitorFault::ending, {}));
  } catch (const std::exception& error) {
    Cause cause = cause_of("engine");
    cause.text += fmt::format(" ({})", error.what());
    stop_by({cause}, words_of(MonitorFault::engine, {}));
    state_.end();
    throw;
  }
}

bool Service::is_told_safe() const {
  const std::lock_guard lock(status_mutex_);
  return status_.safe || untold_stop_;
}

void Service::loop(const std::function<bool()>& asked_to_stop, std::uint64_t pairs) {
  started_ = Clock::now();
  note({"configuration", ""},
       fmt::format("begins with {}, configuration {}", cell_.path.string(), crc_text(cell_.crc)));
  while (!asked_to_stop()) {
    if (turn_) turn_();
    auto pair = wait_for_pair();
    if (pair) {
      judge(std::move(*pair));
    } else if (images_ended()) {
      return;
    } else {
      idle();
    }
    if (pairs != 0 && status().frame >= pairs) return;
  }
}

MonitorFaults Service::faults_of_parts() {
  troubles_.clear();
  for (const Part* part : parts_) {
    if (std::string trouble = part->trouble(); !trouble.empty()) troubles_.push_back(std::move(trouble));
  }
  return troubles_.empty() ? MonitorFaults() : MonitorFault::output;
}

MonitorFaults Service::missed() const { return state_.missed() ? MonitorFault::decision_late : MonitorFaults(); }

/// The machine does not know of what the monitor finds: its interlock falls, the next pair is no good one, and nobody knows
/// whether what it is shown from now on is as empty as what it was shown before.
void Service::take_safe_away(MonitorFaults own) {
  state_.not_safe(words_of(own, {}));
  if (machine_) {
    machine_->supervisor->monitor().trip();
    tripped_ = true;
  }
  if (own.has(MonitorFault::decision_late)) state_.catch_up();
  if (to_teach_ != 0) break_off_teaching(fmt::format("{}", fmt::join(own.names(), ", ")));
}

/// Without a pair: what is wrong now.
void Service::idle() {
  MonitorFaults own = faults_of_parts();
  {
    const std::lock_guard lock(intake_mutex_);
    own |= pairing_.check(Clock::now(), started_);
  }
  own |= missed();
  if (!own.any()) return;
  pending_ |= own;
  take_safe_away(own);
  stop_by(own_causes(own, causes_of(false, own, {})), words_of(own, {}));
}

/// With what is known beside their names.
std::vector<Cause> Service::own_causes(MonitorFaults own, std::vector<Cause> causes) {
  const std::lock_guard lock(intake_mutex_);
  for (Cause& cause : causes) {
    for (const Side side : kSides) {
      const Link& link = links_.at(static_cast<std::size_t>(side));
      const auto lost = of(side, MonitorFault::left_camera_lost);
      const bool about = own.has(lost) && cause.name == kMonitorFaultNames.at(static_cast<std::size_t>(lost));
      if (about && !link.why.empty()) cause.text += fmt::format(" ({})", link.why);
    }
    if (cause.name == "output") cause.text += fmt::format(" ({})", fmt::join(troubles_, "; "));
  }
  return causes;
}

void Service::judge(ImagePair pair) {
  if (!machine_) {
    start_machine(pair.left.image.width, pair.left.image.height, 1);
    return;  // it has waited for longer than a decision may
  }
  horopter::Monitor& monitor = machine_->supervisor->monitor();
  MonitorFaults own = std::exchange(pending_, {}) | pair.faults | faults_of_parts();
  own |= missed();
  if (own.any()) take_safe_away(own);
  begin_request(own);

  std::vector<FrameResult> results;
  if (pair.judgeable) results = machine_->supervisor->process(pair.left.image, pair.right.image);
  Faults faults;
  bool alarm = false;
  const bool after_trip = !results.empty() && std::exchange(tripped_, false);
  for (FrameResult& result : results) {
    if (after_trip) result.faults.clear(Fault::map_busy);  // nobody loads a table
    faults |= result.faults;
    alarm |= result.alarm;
  }
  if (to_teach_ != 0) {
    // Somebody came, or nobody knows: what is taught after it would be safe with that in the zone.
    if (const std::string why = not_empty(results); !why.empty()) break_off_teaching(why);
  }
  const std::uint32_t word = monitor.device().read(reg::status::kAddress);
  if (state_.missed() || Clock::now() - pair.seen() > state_.limit()) {
    own |= MonitorFault::decision_late;
    pending_ |= MonitorFault::decision_late;  // the machine shall know of it, too
  }
  const bool good = pair.judgeable && !own.any() && !faults.any() && !alarm;

  Status status = this->status();
  status.time = std::chrono::system_clock::now();
  status.frame += 1;
  status.safe = good && says_safe(word);
  status.alarm = alarm;
  status.restart = status.safe                                    ? Restart::not_needed
                   : good && reg::status::kWaiting.get(word) != 0 ? Restart::possible
                                                                  : Restart::needed;
  status.causes = own_causes(own, causes_of(alarm, own, faults));
  status.taught = reg::status::kTaught.get(word) != 0;
  status.skew_ms = std::chrono::duration<double, std::milli>(pair.skew).count();
  if (!results.empty()) {
    const FrameResult& shown = worst(results);
    status.table = shown.table;
    status.table_crc = shown.table_crc;
    const Agreement& agreement = shown.agreement;
    status.explained.reset();
    if (agreement.textured > 0) status.explained = static_cast<double>(agreement.explained) / agreement.textured;
    for (std::size_t i = 0; i < 2; ++i) status.cameras.at(i).sharpness = agreement.sharpness.at(i);
  }
  status.decision_ms = std::chrono::duration<double, std::milli>(Clock::now() - pair.arrived()).count();
  status.teaching = to_teach_ != 0;
  describe_cameras(status);
  state_.decided(pair.seen(), status.safe, alarm, words_of(own, faults));
  if (!results.empty()) status.objects = follow(results, pair.arrived());  // after the outputs: it may take its time

  MomentPtr moment;
  if (!results.empty()) {
    auto made = std::make_shared<Moment>();
    made->arrived = pair.arrived();
    made->result = worst(results);
    const int parity = made->result.scan == Scan::odd_field ? 1 : 0;
    const bool whole = made->result.scan == Scan::progressive;
    made->left = whole ? std::move(pair.left.image) : field_of(pair.left.image, parity);
    made->right = whole ? std::move(pair.right.image) : field_of(pair.right.image, parity);
    made->status = status;
    moment = std::move(made);
  }
  publish(std::move(status), moment);
  if (to_teach_ != 0 && !pending_.any()) count_taught();
}

/// Of the result that is shown; those of the other field are followed, too.
std::vector<ObjectState> Service::follow(const std::vector<FrameResult>& results, Clock::time_point arrived) {
  const double time_s = std::chrono::duration<double>(arrived.time_since_epoch()).count();
  std::vector<ObjectState> shown;
  for (const FrameResult& result : results) {
    const auto objects = machine_->objects->follow(result, time_s);
    if (&result != &worst(results)) continue;
    for (const TrackedObject& object : objects) shown.push_back(state_of(object, machine_->camera_mm));
  }
  return shown;
}

void Service::begin_request(MonitorFaults own) {
  std::optional<Request> restart;
  std::optional<Request> teach;
  {
    const std::lock_guard lock(status_mutex_);
    restart = std::exchange(restart_request_, {});
    teach = std::exchange(teach_request_, {});
  }
  horopter::Monitor& monitor = machine_->supervisor->monitor();
  if (restart) {
    // An old one was meant for what somebody saw then.
    if (own.any() || Clock::now() - restart->at > state_.limit()) {
      note(restart->actor, "restart refused: a fault came in between");
    } else {
      monitor.device().write(reg::restart::kAddress, reg::kRestartKey);
      restarting_ = restart->actor;
    }
  }
  if (teach && own.any()) {
    note(teach->actor, "teaching refused: a fault came in between");
  } else if (teach && Clock::now() - teach->at > state_.limit()) {
    note(teach->actor, "teaching refused: no image came in time");
  } else if (teach) {
    teacher_ = teach->actor;
    to_teach_ = teach->frames;
    monitor.teach(true);
    note(teacher_, fmt::format("teaching: the zone must be empty for {} pairs", to_teach_));
  }
}

void Service::break_off_teaching(const std::string& why) {
  to_teach_ = 0;
  machine_->supervisor->monitor().break_off_teaching();
  {
    const std::lock_guard lock(status_mutex_);
    status_.teaching = false;
  }
  note(teacher_, fmt::format("teaching was broken off: {}; teach again", why));
}

void Service::count_taught() {
  if (--to_teach_ != 0) return;
  horopter::Monitor& monitor = machine_->supervisor->monitor();
  monitor.teach(false);
  const int taught = monitor.blind_watch().taught();
  note(teacher_, taught != 0 ? fmt::format("taught by {} frames", taught)
                             : "taught nothing: the last frame was unproven, or one before it had a fault or an alarm; "
                               "everything that cannot be decided counts as an object now");
}

// What others see -----------------------------------------------------------------------------------------------------

void Service::describe_cameras(Status& status) {
  const std::lock_guard lock(intake_mutex_);
  for (const Side side : kSides) {
    const auto i = static_cast<std::size_t>(side);
    CameraState& camera = status.cameras.at(i);
    const SideCounts& counts = pairing_.counts(side);
    camera.connected = links_.at(i).connected;
    camera.frames = counts.frames;
    camera.dropped = counts.dropped;
    camera.lost_packets = counts.lost_packets;
    camera.repeated = counts.repeated;
    camera.frames_per_s = pairing_.rate(side);
    camera.exposure_us = links_.at(i).exposure_us;
  }
}

void Service::publish(Status status, const MomentPtr& moment) {
  const std::lock_guard telling(listeners_mutex_);
  Status before;
  {
    const std::lock_guard lock(status_mutex_);
    before = std::exchange(status_, status);
    if (std::exchange(untold_stop_, false)) before.safe = true;
    if (moment) latest_ = moment;
    if (status.safe) {
      status_.latched.clear();
    } else if (before.safe) {
      status_.latched = status.causes;
    } else {
      status_.latched = before.latched;
      add_others(status.causes, status_.latched);
    }
    const bool stops = status.restart == Restart::needed && (before.safe || before.restart == Restart::possible);
    status_.stops = before.stops + (stops ? 1 : 0);
    status = status_;
  }
  tell(before, status, moment);
}

void Service::tell(const Status& before, const Status& status, const MomentPtr& moment) {
  if (restarting_ && !before.safe) {
    const Actor actor = *std::exchange(restarting_, {});
    if (status.safe) {
      released_by_ = actor;
    } else {
      for (Part* part : parts_) part->noted(status, actor, "restart refused: a fault or an alarm came in between");
    }
  }
  const bool others = !before.safe && !status.safe && !moment && !same_names(told_causes_, status.causes);
  const bool tell_others = others && Clock::now() - causes_told_ >= kBetweenCauses;
  if (tell_others || moment || before.safe != status.safe) told_causes_ = status.causes;
  if (tell_others) causes_told_ = Clock::now();
  // One that begins too soon after another is told later, if it lasts.
  if (!status.alarm || before.safe) {
    untold_alarm_ = false;
  } else if (!before.alarm) {
    untold_alarm_ = true;
  }
  const bool tell_alarm = untold_alarm_ && Clock::now() - alarm_told_ >= kBetweenCauses;
  if (tell_alarm) untold_alarm_ = false;
  if (tell_alarm || (before.safe && status.alarm)) alarm_told_ = Clock::now();
  for (Part* part : parts_) {
    if (before.safe && !status.safe) part->stopped(status, moment);
    if (tell_alarm) part->noted(status, {"monitor", ""}, "an alarm while it was not safe");
    if (!before.safe && status.safe) part->released(status, released_by_);
    if (tell_others) part->noted(status, {"monitor", ""}, "not safe for other reasons now");
    if (moment) part->judged(moment);
  }
}

void Service::note(const Actor& actor, const std::string& what) {
  const std::lock_guard telling(listeners_mutex_);
  Status now = status();
  now.time = std::chrono::system_clock::now();
  for (Part* part : parts_) part->noted(now, actor, what);
}

/// Not safe, without a pair.
void Service::stop_by(const std::vector<Cause>& causes, FaultWords words) {
  state_.not_safe(words);
  Status status = this->status();
  {
    const std::lock_guard lock(status_mutex_);
    if (!status_.safe && same_names(status_.causes, causes) && same_names(told_causes_, causes)) return;
    status.safe = status_.safe;
  }
  status.time = std::chrono::system_clock::now();
  status.safe = false;
  status.restart = Restart::needed;
  status.causes = causes;
  describe_cameras(status);
  publish(std::move(status), nullptr);
}

/// The decision may hang: then this thread says that it is not safe. Where safe was taken away before, for a fault, the
/// decision has its usual time to tell of it.
void Service::watch() {
  std::optional<Clock::time_point> untold_since;
  while (watching_) {
    std::this_thread::sleep_for(look_);
    if (state_.at(Clock::now()).safe) {
      untold_since.reset();
      continue;
    }
    std::unique_lock telling(listeners_mutex_, std::try_to_lock);
    Status status;
    {
      const std::lock_guard lock(status_mutex_);
      const auto now = Clock::now();
      if (!status_.safe || state_.at(now).safe) {  // what both say at once: it may just have become safe
        untold_since.reset();
        continue;
      }
      if (!untold_since) untold_since = now;
      if (!state_.missed() && now - *untold_since <= state_.limit()) continue;
      status_.time = std::chrono::system_clock::now();
      status_.safe = false;
      status_.restart = Restart::needed;
      ++status_.stops;
      status_.causes = status_.latched = causes_of(false, MonitorFault::decision_late, {});
      status = status_;
      untold_stop_ = !telling.owns_lock();
    }
    if (telling.owns_lock()) {
      for (Part* part : parts_) part->stopped(status, nullptr);
    }
  }
}

// Control -------------------------------------------------------------------------------------------------------------

Status Service::status() const {
  const std::lock_guard lock(status_mutex_);
  Status status = status_;
  if (status.safe && !state_.at(Clock::now()).safe) {  // the outputs know first
    status.safe = false;
    status.restart = Restart::needed;
  }
  return status;
}

MomentPtr Service::latest() const {
  const std::lock_guard lock(status_mutex_);
  return latest_;
}

bool Service::restart(const Actor& actor, std::uint64_t stops, std::string& why) {
  const std::lock_guard lock(status_mutex_);
  if (status_.safe) {
    why = "it is safe already";
  } else if (!cell_.settings.interlock.by_register) {
    why = "its configuration lets it restart by itself";
  } else if (status_.stops != stops) {
    why = kLookAgain;
  } else if (status_.restart != Restart::possible) {
    why = "the last frames were not all without fault and alarm";
  } else {
    restart_request_ = Request{actor, Clock::now(), 0};
    return true;
  }
  return false;
}

bool Service::teach(int frames, const Actor& actor, std::uint64_t stops, std::string& why) {
  constexpr int kMost = reg::taught::kFrames.mask();
  const std::lock_guard lock(status_mutex_);
  if (frames < 1 || frames > kMost) {
    why = fmt::format("{} frames; expected 1 to {}", frames, kMost);
  } else if (!cell_.settings.blind.watch) {
    why = "it would not watch any more once it is begun anew; set `teach: {needed: true}` in cell.yaml";
  } else if (status_.teaching || teach_request_) {
    why = "it is teaching already";
  } else if (status_.frame == 0) {
    why = "no image has been judged yet";
  } else if (status_.stops != stops) {
    why = kLookAgain;
  } else {
    teach_request_ = Request{actor, Clock::now(), frames};
    return true;
  }
  return false;
}

}  // namespace horopter::monitor
