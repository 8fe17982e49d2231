// SPDX-License-Identifier: Apache-2.0
// What goes wrong while `horopter monitor` runs: two GigE Vision cameras on the loopback, Modbus, a broker, the page, the log
// on a small disk. Each fault is made while it is safe; said is how long afterwards Modbus was not safe, and by what name the
// page knows it. All of it lives in a network and a mount of its own, for which it must be root or may become so.
//   HOROPTER_RATE    images a second, 5 unless told; below 10 the limit of the decision is 1 s, for computers that are busy
#include <arpa/inet.h>
#include <fcntl.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/un.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>

#include "horopter/monitor/users.hpp"
#include "http.hpp"
#include "plc.hpp"
#include "running.hpp"

using namespace horopter::test;

namespace {

constexpr int kModbusPort = 1502, kPagePort = 8080, kBrokerPort = 1883;
const std::string kPassword = "correct horse";

/// A network and mounts of its own, with the addresses of two cameras. False: this user may not.
bool has_own_network() {
  static const bool has = [] {
    const uid_t user = ::getuid();
    if (::unshare(CLONE_NEWNET | CLONE_NEWNS) != 0) {
      if (::unshare(CLONE_NEWUSER | CLONE_NEWNET | CLONE_NEWNS) != 0) return false;
      std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
    }
    ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr);
    return std::system("ip link set lo up && ip address add 127.0.0.2/8 dev lo") == 0;
  }();
  if (!has) std::cout << "skipped: this user may have no network of its own\n";
  return has;
}

double rate() {
  const char* const given = std::getenv("HOROPTER_RATE");
  return given != nullptr ? std::atof(given) : 5;
}
double period_ms() { return 1000 / rate(); }
double limit_ms() { return rate() < 10 ? 1000 : std::max(60.0, 2.5 * period_ms()); }

/// What systemd hears: it may not listen for long, and must not hold anybody up.
class Watchdog {
 public:
  explicit Watchdog(const fs::path& path) : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un place{};
    place.sun_family = AF_UNIX;
    std::snprintf(place.sun_path, sizeof place.sun_path, "%s", path.c_str());
    REQUIRE(::bind(socket_, reinterpret_cast<sockaddr*>(&place), sizeof place) == 0);
  }
  ~Watchdog() { ::close(socket_); }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;
  /// All that came since it was asked last.
  std::string heard() const {
    std::string text;
    std::array<char, 256> bytes{};
    for (ssize_t got = 0; (got = ::recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT)) > 0;) {
      text.append(bytes.data(), static_cast<std::size_t>(got)).append("\n");
    }
    return text;
  }

 private:
  int socket_;
};

/// A cell that runs, and an operator at its page.
class Live : public CellBox {
 public:
  explicit Live(double images_per_s = rate(), double decision_ms = limit_ms(), const std::string& engine = "native")
      : watchdog_(*this / "notify") {
    fs::create_directory(*this / "disk");
    REQUIRE(::mount("tmpfs", (*this / "disk").c_str(), "tmpfs", 0, "size=64m") == 0);
    horopter::monitor::set_user(*this / "users", "anna", horopter::monitor::Role::plant_operator, kPassword);
    write("broker.conf", "listener " + std::to_string(kBrokerPort) + " 127.0.0.1\nallow_anonymous true\nuser root\n");
    const std::string features =
        "features: {Width: 640, Height: 480, AcquisitionFrameRate: " + number(images_per_s) + "}}\n";
    write("cell.yaml", "name: live\nengine: " + engine +
                           "\ncameras:\n  left: {source: 'gev:127.0.0.1', serial: LEFT, " + features +
                           "  right: {source: 'gev:127.0.0.2', serial: RIGHT, " + features +
                           "  frames_per_s: " + number(images_per_s) +
                           "\n  stamps: camera\n  largest_skew_ms: 0.6\nrig: rig.yaml\nskin: skin.yaml\n"
                           "limits: {object: 100px, decision_ms: " +
                           number(decision_ms) +
                           ", still_scene: true, frozen_frames: 0, hidden_frames: 0}\n"
                           "outputs: {modbus: {port: 1502}, mqtt: {host: 127.0.0.1}}\n"
                           "log: {directory: disk/log, size_mb: 40}\n"
                           "web: {listen: '127.0.0.1:8080', users_file: users, restart: true}\n");
    begin_broker();
    cameras_.emplace(
        *this, std::vector<std::string>{HOROPTER_FAKE_CAMERAS, kData + "left??.jpg", kData + "right??.jpg"}, "cameras");
    tell("show 1");  // nothing is in the skin
    begin();
  }
  ~Live() {
    monitor_.reset();
    ::umount2((*this / "disk").c_str(), MNT_DETACH);
  }

  void begin() {
    ::setenv("NOTIFY_SOCKET", (*this / "notify").c_str(), 1);
    monitor_.reset(new Running(start()));  // it cannot be moved
    ::unsetenv("NOTIFY_SOCKET");
    REQUIRE(eventually([&] { return log_in(); }));
  }
  void begin_broker() {
    broker_.emplace(*this, std::vector<std::string>{"/usr/sbin/mosquitto", "-c", "broker.conf"}, "broker");
  }
  Running& monitor() { return *monitor_; }
  Running& cameras() { return *cameras_; }
  Running& broker() { return *broker_; }
  const Watchdog& watchdog() const { return watchdog_; }
  Plc& plc() { return plc_; }

  /// Words for the cameras, of which the last one is obeyed when this returns.
  void tell(const std::string& words) {
    const std::string done = "done " + words + "\n";
    const auto times = [&] {
      const std::string text = cameras_->out();
      std::size_t count = 0;
      for (auto at = text.find(done); at != std::string::npos; at = text.find(done, at + 1)) ++count;
      return count;
    };
    const auto before = times();
    cameras_->tell(words);
    INFO(words << cameras_->err());
    REQUIRE(eventually([&] { return times() > before; }));
  }

  /// Null where the page does not answer.
  json status() {
    const auto answer = page_.Get("/api/status", headers_);
    return answer && answer->status == 200 ? json::parse(answer->body) : json();
  }
  /// By the operator, where the interlock allows it.
  void try_to_release() {
    const json now = status();
    if (now.is_object() && now["restart"] == "possible") {
      page_.Post("/api/restart", headers_, json{{"stop", now["stop"]}}.dump(), "application/json");
    }
  }
  void release() {
    const bool released = eventually([&] {
      try_to_release();
      const json now = status();
      return now.is_object() && now["state"] == "safe" && plc_.safe();
    });
    INFO("the page says " << status().dump() << "\n" << monitor_->out() << monitor_->err() << cameras_->err());
    REQUIRE(released);
  }
  static bool names(const json& status, const std::string& cause) {
    if (!status.is_object()) return false;
    return has_cause(status, cause) || has_cause({{"causes", status["latched"]}}, cause);
  }

  static std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%g", value);
    return text.data();
  }

 private:
  bool log_in() {
    headers_ = {{"Origin", "http://127.0.0.1:" + std::to_string(kPagePort)}};
    const auto answer =
        page_.Post("/api/login", headers_, json{{"name", "anna"}, {"password", kPassword}}.dump(), "application/json");
    if (!answer || answer->status != 200) return false;
    const std::string cookie = answer->get_header_value("Set-Cookie");
    headers_.emplace("Cookie", cookie.substr(0, cookie.find(';')));
    const auto session = page_.Get("/api/session", headers_);
    if (!session) return false;
    headers_.emplace("X-Horopter-Token", json::parse(session->body)["token"].get<std::string>());
    return true;
  }

  Watchdog watchdog_;
  std::optional<Running> broker_, cameras_;
  std::unique_ptr<Running> monitor_;
  httplib::Client page_{"127.0.0.1", kPagePort};
  httplib::Headers headers_;
  Plc plc_{kModbusPort};
};

bool all_unsafe(const std::vector<Plc::Answer>& answers) { return std::ranges::none_of(answers, &Plc::Answer::safe); }

/// What a fault is, and how it is made and unmade.
struct Fault {
  std::string what;
  std::string cause;
  std::function<void()> make;
  std::function<void()> unmake;
  double known_after_ms = 0;  ///< beside a time between images and the limit of the decision
  std::string says = {};      ///< in the causes
};

void check_fault(Live& live, const Fault& fault) {
  live.release();
  const auto begin = Clock::now();
  fault.make();
  const auto made = Clock::now();
  json seen;
  const bool named = eventually([&] {
    seen = live.status();
    return Live::names(seen, fault.cause) && seen.dump().find(fault.says) != std::string::npos;
  });
  const auto named_at = Clock::now();
  INFO(fault.what << ": the page says " << seen.dump());
  CHECK(named);
  // The page may know it before Modbus is asked the next time.
  std::optional<Plc::Answer> first;
  REQUIRE(eventually([&] { return (first = live.plc().first_unsafe_after(begin)).has_value(); }));
  const double unsafe_ms = since_ms(made, first->came);
  std::printf("%-28s not safe after %6.0f ms; the page names %s after %6.0f ms\n", fault.what.c_str(),
              std::max(0.0, unsafe_ms), fault.cause.c_str(), since_ms(made, named_at));
  std::fflush(stdout);
  CHECK(unsafe_ms <= period_ms() + limit_ms() + fault.known_after_ms);
  // Nobody has restarted it: it stays so, also when all is well again.
  fault.unmake();
  std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(2 * period_ms()));
  CHECK(all_unsafe(live.plc().answers_after(first->asked)));
}

std::function<void()> telling(Live& live, std::vector<std::string> lines) {
  return [&live, lines = std::move(lines)] {
    for (const std::string& line : lines) live.tell(line);
  };
}

/// Takes the cameras away. What came of each was judged or has been counted as dropped.
json check_counts(Live& live) {
  live.tell("off left");
  live.tell("off right");
  REQUIRE(eventually([&] { return Live::names(live.status(), "left_camera_lost"); }));
  REQUIRE(eventually([&] { return Live::names(live.status(), "right_camera_lost"); }));
  json last = live.status();
  INFO(last.dump());
  // Up to eight images of a camera may wait for partners that never came.
  std::array<int, 2> waiting{};
  for (std::size_t side = 0; side < 2; ++side) {
    const json& camera = last["cameras"][side];
    waiting.at(side) = camera["frames"].get<int>() - camera["dropped"].get<int>() - last["frame"].get<int>();
  }
  CHECK(std::min(waiting[0], waiting[1]) == 0);
  CHECK(std::max(waiting[0], waiting[1]) <= 8);
  return last;
}

void say_counts(const char* what, const json& last) {
  std::printf("%-28s %d pairs judged, %d and %d images dropped\n", what, last["frame"].get<int>(),
              last["cameras"][0]["dropped"].get<int>(), last["cameras"][1]["dropped"].get<int>());
  std::fflush(stdout);
}

}  // namespace

TEST_CASE("cameras that go wrong while it runs: not safe in time, and named on the page") {
  if (!has_own_network()) return;
  Live live;
  std::printf("%g images a second, a decision is too old after %g ms\n", rate(), limit_ms());
  const auto tell = [&](std::vector<std::string> lines) { return telling(live, std::move(lines)); };
  const auto again = tell({"off right", "on right RIGHT"});
  check_fault(live, {"2 ms late", "skew", tell({"late right 2"}), tell({"late right 0"})});
  check_fault(live, {"1 image late", "numbers", tell({"hold right 1"}), again});
  check_fault(live, {"10 images late", "right_camera_lost", tell({"hold right 10"}), again});
  check_fault(live, {"clock 1 h ahead", "right_time_jump", tell({"jump right 3600000"}), tell({"jump right 0"})});
  check_fault(live, {"clock 1 h back", "right_time_back", tell({"jump right -3600000"}), tell({"jump right 0"})});
  check_fault(live, {"packets lost", "right_lost_packets", tell({"lose right 0.02"}), tell({"lose right 0"})});
  check_fault(live, {"killed", "right_camera_lost", tell({"off right"}), tell({"on right RIGHT"})});
  check_fault(live, {"cables exchanged", "swapped", tell({"off left", "off right", "on left RIGHT", "on right LEFT"}),
                     tell({"off left", "off right", "on left LEFT", "on right RIGHT"})});
  check_fault(live, {"images exchanged", "disagree", tell({"swap"}), tell({"swap"})});
  check_fault(live, {"both stand still (SIGSTOP)", "left_camera_lost", [&] { live.cameras().send(SIGSTOP); },
                     [&] { live.cameras().send(SIGCONT); }});
  live.release();
}

TEST_CASE("25 images a second: each is judged or counts as dropped, and what is dropped is a fault") {
  if (!has_own_network()) return;
  const int pairs = 200;
  Live live(25, 20'000);  // however late: it is not about time
  const auto judged = [&] {
    const json now = live.status();
    return now.is_object() ? now["frame"].get<int>() : 0;
  };
  REQUIRE(eventually([&] {
    live.try_to_release();
    return judged() >= pairs;
  }));
  // It stands still: many images come at once when it goes on.
  live.monitor().send(SIGSTOP);
  std::this_thread::sleep_for(500ms);
  live.monitor().send(SIGCONT);
  REQUIRE(eventually([&] {
    live.try_to_release();
    return judged() >= 2 * pairs;
  }));
  const json last = check_counts(live);
  // As long as it is safe none is dropped: the next event says that it was, and why.
  std::array<int, 2> at_release{-1, -1};
  for (const json& event : live.monitor().events()) {
    for (std::size_t side = 0; side < 2; ++side) {
      const int now = event["cameras"][side]["dropped"];
      if (at_release.at(side) >= 0 && now != at_release.at(side)) {
        CAPTURE(event.dump());
        CHECK(event["event"] == "stopped");
        CHECK_FALSE(event["causes"].empty());
      }
      at_release.at(side) = event["safe"] == true ? now : -1;
    }
  }
  say_counts("25 images a second", last);
}

TEST_CASE("more images than it can judge: each is judged or counts as dropped, and it is never safe") {
  if (!has_own_network()) return;
  if (CellBox().run({"run", "--help"}).out.find("native, rtl") == std::string::npos) {
    std::cout << "skipped: this build has no engine rtl\n";
    return;
  }
  Live live(25, 60'000, "rtl");
  REQUIRE(eventually([&] {
    const json now = live.status();
    return now.is_object() && now["frame"] >= 8 && Live::names(now, "left_dropped") &&
           Live::names(now, "right_dropped");
  }));
  const json last = check_counts(live);
  for (const json& camera : last["cameras"]) CHECK(camera["dropped"] > 0);
  for (const json& event : live.monitor().events()) CHECK(event["safe"] == false);
  say_counts("in simulation", last);
}

TEST_CASE("GigE Vision begins to count anew after 65535: that is no fault") {
  if (!has_own_network()) return;
  Live live;
  const int tries = 3;  // a busy computer may lose an image
  bool safe = false;
  for (int i = 0; i < tries && !safe; ++i) {
    for (const char* words :
         {"off left", "off right", "count left 65510", "count right 65510", "on left LEFT", "on right RIGHT"}) {
      live.tell(words);
    }
    live.release();
    const auto begin = Clock::now();
    const unsigned first = live.plc().answers_after(begin - 1s).back().heartbeat;
    REQUIRE(eventually([&] {
      const auto answers = live.plc().answers_after(begin);
      return !answers.empty() && answers.back().heartbeat - first > 30;
    }));
    safe = !live.plc().first_unsafe_after(begin);
  }
  CHECK(safe);
}

TEST_CASE(
    "a broker that is gone or hangs, and a full disk: not safe, and named on the page; slow clients change nothing") {
  if (!has_own_network()) return;
  Live live;
  check_fault(live, {"broker gone", "output", [&] { live.broker().end(SIGKILL); }, [&] { live.begin_broker(); }});
  check_fault(live, {"broker hangs (SIGSTOP)", "output", [&] { live.broker().send(SIGSTOP); },
                     [&] { live.broker().send(SIGCONT); }, 12'000, "does not answer"});
  const fs::path filler = live / "disk" / "filler";
  check_fault(live, {"disk full", "output",
                     [&] {
                       std::ofstream file(filler, std::ios::binary);
                       const std::string block(4096, 'x');
                       while (file.write(block.data(), static_cast<std::streamsize>(block.size())).flush()) {
                       }
                     },
                     [&] { fs::remove(filler); }, 1000});
  live.release();
  const auto begin = Clock::now();
  std::vector<int> sockets;
  for (int i = 0; i < 50; ++i) {
    sockets.push_back(connect_to(kPagePort));
    const std::string head = "GET /api/picture HTTP/1.1\r\nHo";
    REQUIRE(::send(sockets.back(), head.data(), head.size(), MSG_NOSIGNAL) > 0);
  }
  while (Clock::now() - begin < 4s) {
    for (const int socket : sockets) ::send(socket, "x", 1, MSG_NOSIGNAL);
    std::this_thread::sleep_for(50ms);
  }
  for (const int socket : sockets) ::close(socket);
  const auto answers = live.plc().answers_after(begin);
  REQUIRE_FALSE(answers.empty());
  unsigned oldest_ms = 0;
  for (const auto& answer : answers) oldest_ms = std::max(oldest_ms, answer.age_ms);
  const unsigned decisions = answers.back().heartbeat - answers.front().heartbeat;
  std::printf("50 slow clients for 4 s: %u decisions, the oldest %u ms, safe in %zu of %zu answers\n", decisions,
              oldest_ms, static_cast<std::size_t>(std::ranges::count_if(answers, &Plc::Answer::safe)), answers.size());
  CHECK(decisions > 2 * rate());
  CHECK(oldest_ms < limit_ms());
  live.broker().send(SIGSTOP);  // it ends all the same
  CHECK(live.monitor().end(SIGTERM) == 0);
}

TEST_CASE("the whole program stopped: nobody is answered, systemd hears nothing, and it comes back not safe") {
  if (!has_own_network()) return;
  Live live;
  live.release();
  CHECK_THAT(live.watchdog().heard(), Catch::Contains("READY=1") && Catch::Contains("WATCHDOG=1"));
  live.monitor().send(SIGSTOP);
  std::this_thread::sleep_for(100ms);
  const auto stopped = Clock::now();
  live.watchdog().heard();
  std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(2 * limit_ms()));
  CHECK(live.watchdog().heard().empty());
  CHECK(live.plc().answers_after(stopped).empty());
  const auto went_on = Clock::now();
  live.monitor().send(SIGCONT);
  REQUIRE(eventually([&] { return live.plc().answers_after(went_on).size() > 100; }));
  // Whoever looks first says why: the age of the decision, or cameras that were silent.
  CHECK(eventually([&] {
    const json now = live.status();
    return Live::names(now, "decision_late") || Live::names(now, "left_camera_lost") || Live::names(now, "left_gap") ||
           Live::names(now, "left_lost_packets") || Live::names(now, "left_unpaired");
  }));
  CHECK(eventually([&] { return live.status()["restart"] == "possible"; }));
  CHECK(all_unsafe(live.plc().answers_after(stopped)));
  CHECK_THAT(live.watchdog().heard(), Catch::Contains("WATCHDOG=1"));
  live.release();
}

TEST_CASE("killed and begun anew: not safe until somebody restarts it") {
  if (!has_own_network()) return;
  Live live;
  live.release();
  live.monitor().end(SIGKILL);
  const auto killed = Clock::now();
  live.begin();
  REQUIRE(eventually([&] { return live.status()["restart"] == "possible"; }));
  std::this_thread::sleep_for(1s);
  CHECK_FALSE(live.plc().answers_after(killed).empty());
  CHECK(all_unsafe(live.plc().answers_after(killed)));
  live.release();
  CHECK(live.monitor().end(SIGTERM) == 0);
  const auto log = live.run({"log", "disk/log", "--check"});
  INFO(log.out << log.err);
  CHECK(log.status == 0);
}
