// SPDX-License-Identifier: Apache-2.0
// The decision while it runs: images are given to it one pair after the other, and whoever listens hears what came of it.
// Its limit is long, so that a slow computer is none of the faults; where a decision hangs it hangs for as long as it takes.
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <catch2/catch.hpp>
#include <condition_variable>
#include <csignal>
#include <fstream>
#include <mutex>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "../system/eventually.hpp"
#include "../system/monitor_machine.hpp"
#include "horopter/base/error.hpp"
#include "host_temporary.hpp"
#include "output/lines.hpp"

using namespace horopter::monitor;
using namespace std::chrono_literals;
using horopter::FrameStreams;
using horopter::Image;
using horopter::test::eventually;
using horopter::test::machine_of;

namespace {

constexpr int kWidth = 200, kHeight = 120;

/// The native engine, that can be held in the middle of a frame, or fail.
class HeldDevice : public horopter::NativeDevice {
 public:
  struct Hold {
    std::atomic<bool> held = false;
    std::atomic<bool> fails = false;
  };
  HeldDevice(const horopter::MachineProfile& profile, Hold& hold) : NativeDevice(profile), hold_(hold) {}
  FrameStreams receive() override {
    while (hold_.held) std::this_thread::sleep_for(1ms);
    if (hold_.fails) throw horopter::DeviceError("it burns");
    return NativeDevice::receive();
  }

 private:
  Hold& hold_;
};

struct Event {
  std::string name;
  Status status;
  std::string by;
  std::string what;
};

/// Keeps all events, and can wait for the next pair.
class Recorder : public Part {
 public:
  void judged(const MomentPtr& moment) override {
    const std::lock_guard lock(mutex_);
    statuses_.push_back(moment->status);
    changed_.notify_all();
  }
  void stopped(const Status& status, const MomentPtr&) override { add({"stopped", status, "", ""}); }
  void released(const Status& status, const Actor& by) override { add({"released", status, by.name, ""}); }
  void noted(const Status& status, const Actor& actor, const std::string& what) override {
    add({"noted", status, actor.name, what});
  }
  [[nodiscard]] std::string trouble() const override {
    const std::lock_guard lock(mutex_);
    return trouble_;
  }
  void set_trouble(const std::string& trouble) {
    const std::lock_guard lock(mutex_);
    trouble_ = trouble;
  }
  std::vector<Event> events() const {
    const std::lock_guard lock(mutex_);
    return events_;
  }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const Event& event : events()) names.push_back(event.name);
    return names;
  }
  template <class Condition>
  bool wait(const Condition& condition) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, 60s, condition);
  }
  bool wait_for_event(const std::string& name) {
    return wait([&] { return !changes_.empty() && changes_.back().name == name; });
  }
  /// Of safe to not safe, or back.
  Event last_change() const {
    const std::lock_guard lock(mutex_);
    return changes_.back();
  }
  /// Of the pair with this number.
  Status status_of(std::size_t pair) {
    REQUIRE(wait([&] { return statuses_.size() >= pair; }));
    const std::lock_guard lock(mutex_);
    return statuses_[pair - 1];
  }

 private:
  void add(Event event) {
    const std::lock_guard lock(mutex_);
    if (event.name != "noted") changes_.push_back(event);
    events_.push_back(std::move(event));
    changed_.notify_all();
  }
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Status> statuses_;
  std::vector<Event> events_;
  std::vector<Event> changes_;
  std::string trouble_;
};

Image textured(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Image coarse(kWidth / 4 + 2, kHeight / 4 + 2);
  for (auto& pixel : coarse.pixels) pixel = static_cast<std::uint8_t>(20 + random() % 200);
  Image image(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const int cx = x / 4, cy = y / 4, fx = x % 4, fy = y % 4;
      const int sum = coarse.at(cx, cy) * (4 - fx) * (4 - fy) + coarse.at(cx + 1, cy) * fx * (4 - fy) +
                      coarse.at(cx, cy + 1) * (4 - fx) * fy + coarse.at(cx + 1, cy + 1) * fx * fy;
      image.at(x, y) = static_cast<std::uint8_t>(sum / 16);
    }
  }
  return image;
}

/// A running service, and two cameras in step.
struct Bench {
  explicit Bench(std::chrono::milliseconds limit = 120s, bool by_itself = false, bool teach_needed = false) {
    directory.write("skin.yaml", "surface:\n  type: homography\n  matrix: [[1, 0, -10], [0, 1, 0], [0, 0, 1]]\n");
    cell.frames_per_s = 1;
    cell.decision_limit_ms = static_cast<double>(limit.count());
    cell.settings.live = true;
    cell.settings.proof.needed = false;
    cell.settings.still_limit = 0;
    // With this margin the images are good before it was taught, too.
    cell.settings.blind = {.watch = teach_needed, .margin = horopter::BlindSettings::kLargestMargin};
    cell.settings.interlock.by_itself = by_itself;
    cell.settings.interlock.by_register = !by_itself;
    cell.settings.interlock.by_pin = false;
    service.emplace(
        cell,
        [this](int width, int height) {
          return machine_of(cell, directory / "skin.yaml", width, height,
                            std::make_unique<HeldDevice>(horopter::find_profile("vga"), hold));
        },
        kWidth, kHeight);
    service->add(&recorder);
    thread = std::thread([this] {
      try {
        service->run([this] { return stop.load(); }, 0);
      } catch (const std::exception& error) {
        failure = error.what();
      }
      ended = true;
    });
    service->connected(Side::left);
    service->connected(Side::right);
  }
  ~Bench() {
    hold.held = false;
    stop = true;
    thread.join();
  }
  /// The next moment's images; the left one lies on the skin where there is an alarm.
  std::pair<CameraFrame, CameraFrame> images(bool alarm = false) {
    CameraFrame left, right;
    left.image = textured(2 * number);
    right.image = textured(2 * number + 1);
    if (alarm) {
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 10; x < kWidth; ++x) right.image.at(x - 10, y) = left.image.at(x, y);
      }
    }
    left.number = right.number = number;
    left.taken = right.taken = number * 1s;
    left.arrived = right.arrived = Clock::now();
    ++number;
    return {left, right};
  }
  void give(std::pair<CameraFrame, CameraFrame> pair) {
    service->frame(Side::left, std::move(pair.first));
    service->frame(Side::right, std::move(pair.second));
  }
  /// A pair, and what was decided.
  Status judge(bool alarm = false) {
    give(images(alarm));
    return recorder.status_of(++pairs);
  }
  /// Good pairs until a restart is possible; then the restart, and the pair with which it is safe.
  Status release() {
    Status status;
    for (int i = 0; i < 10 && status.restart != Restart::possible; ++i) status = judge();
    REQUIRE(status.restart == Restart::possible);
    std::string why;
    REQUIRE(service->restart({"anna", "here"}, status.stops, why));
    return judge();
  }

  /// By somebody who has looked just now.
  bool restart(const std::string& who, std::string& why) {
    return service->restart({who, "here"}, service->status().stops, why);
  }
  bool teach(int frames, std::string& why) {
    return service->teach(frames, {"egon", ""}, service->status().stops, why);
  }
  bool has_noted(const std::string& what) const {
    return std::ranges::any_of(recorder.events(),
                               [&](const Event& event) { return event.what.find(what) != std::string::npos; });
  }

  horopter::TemporaryDirectory directory;
  HeldDevice::Hold hold;
  Cell cell;
  Recorder recorder;
  std::optional<Service> service;
  std::atomic<bool> stop = false, ended = false;
  std::string failure;
  std::thread thread;
  std::uint64_t number = 0;
  std::size_t pairs = 0;
};

std::vector<std::string> names_of(const std::vector<Cause>& causes) {
  std::vector<std::string> names;
  for (const Cause& cause : causes) names.push_back(cause.name);
  return names;
}

}  // namespace

TEST_CASE("safe only after a restart by somebody, and after an alarm only after another") {
  Bench bench;
  std::string why;
  CHECK(names_of(bench.service->status().causes) == std::vector<std::string>{"starting"});
  CHECK_FALSE(bench.restart("anna", why));
  CHECK_FALSE(why.empty());
  Status status = bench.judge();
  CHECK_FALSE(status.safe);
  for (int i = 0; i < 5; ++i) {
    status = bench.judge();
    CHECK_FALSE(status.safe);
  }
  CHECK(status.restart == Restart::possible);
  CHECK(status.causes.empty());
  REQUIRE(bench.restart("anna", why));
  status = bench.judge();
  CHECK(status.safe);
  CHECK(status.restart == Restart::not_needed);
  CHECK(bench.service->safe_state().at(Clock::now()).safe);
  REQUIRE(bench.recorder.wait_for_event("released"));
  CHECK(bench.recorder.last_change().by == "anna");
  CHECK_FALSE(bench.restart("anna", why));

  status = bench.judge(true);
  CHECK(status.alarm);
  CHECK_FALSE(status.safe);
  CHECK(names_of(status.causes) == std::vector<std::string>{"alarm"});
  CHECK_FALSE(status.objects.empty());
  CHECK_FALSE(bench.service->safe_state().at(Clock::now()).safe);
  REQUIRE(bench.recorder.wait_for_event("stopped"));
  CHECK_FALSE(bench.restart("anna", why));
  for (int i = 0; i < 5; ++i) status = bench.judge();
  CHECK_FALSE(status.safe);
  CHECK(names_of(status.latched) == std::vector<std::string>{"alarm"});
  CHECK(bench.release().safe);
  CHECK(bench.recorder.names() == std::vector<std::string>{"noted", "released", "stopped", "released"});
}

TEST_CASE("a monitor that begins anew takes no restart from somebody who has looked at the one before") {
  std::uint64_t seen = 0;
  const auto wait_for_restart = [](Bench& bench) {
    Status status;
    for (int i = 0; i < 10 && status.restart != Restart::possible; ++i) status = bench.judge();
    REQUIRE(status.restart == Restart::possible);
    return status.stops;
  };
  {
    Bench before;
    seen = wait_for_restart(before);
  }
  Bench bench;
  wait_for_restart(bench);
  std::string why;
  CHECK_FALSE(bench.service->restart({"anna", ""}, seen, why));
  CHECK_THAT(why, Catch::Contains("since you looked"));
  CHECK_FALSE(bench.judge().safe);
  CHECK(bench.release().safe);
}

TEST_CASE("an alarm while it is not safe: told once, kept, and nobody restarts it who looked before") {
  Bench bench;
  Status seen;
  SECTION("at the start") {}
  SECTION("after a stop") {
    REQUIRE(bench.release().safe);
    seen = bench.judge(true);
  }
  for (int i = 0; i < 10 && seen.restart != Restart::possible; ++i) seen = bench.judge();
  REQUIRE(seen.restart == Restart::possible);
  seen = bench.service->status();
  std::this_thread::sleep_for(kBetweenCauses);
  const auto told = bench.recorder.events().size();
  for (int i = 0; i < 3; ++i) CHECK_FALSE(bench.judge(true).safe);
  REQUIRE(bench.recorder.events().size() == told + 1);
  CHECK(bench.recorder.events().back().what == "an alarm while it was not safe");
  Status status;
  for (int i = 0; i < 10 && status.restart != Restart::possible; ++i) status = bench.judge();
  REQUIRE(status.restart == Restart::possible);
  const auto latched = names_of(bench.service->status().latched);
  CHECK(std::ranges::count(latched, "alarm") == 1);
  std::string why;
  CHECK_FALSE(bench.service->restart({"anna", ""}, seen.stops, why));
  CHECK_THAT(why, Catch::Contains("since you looked"));
  CHECK_FALSE(bench.judge().safe);
  CHECK(bench.release().safe);
}

TEST_CASE("an alarm that begins soon after another, while it is not safe, is told as soon as a second is over") {
  Bench bench;
  bench.judge();
  const auto told = [&] {
    return std::ranges::count(bench.recorder.events(), "an alarm while it was not safe", &Event::what);
  };
  bench.judge(true);
  CHECK(told() == 1);
  bench.judge();
  const auto begun = Clock::now();
  while (Clock::now() - begun < kBetweenCauses + 500ms) {
    bench.judge(true);
    std::this_thread::sleep_for(50ms);
  }
  CHECK(told() == 2);
}

TEST_CASE("a fault that only the monitor sees takes safe from the machine: nothing but a restart gives it back") {
  Bench bench;
  REQUIRE(bench.release().safe);
  auto pair = bench.images();
  std::string expected;
  SECTION("skew") {
    pair.second.taken += 2ms;
    expected = "skew";
  }
  SECTION("gap") {
    ++bench.number;
    pair = bench.images();
    expected = "left_gap";
  }
  SECTION("lost packets") {
    pair.first.lost_packets = 1;
    expected = "left_lost_packets";
  }
  SECTION("a part in trouble") {
    bench.recorder.set_trouble("disk full");
    expected = "output";
  }
  bench.give(std::move(pair));
  Status status = bench.recorder.status_of(++bench.pairs);
  CHECK_FALSE(status.safe);
  REQUIRE_FALSE(status.causes.empty());
  CHECK(status.causes.front().name == expected);
  if (expected == "output") CHECK_THAT(status.causes.front().text, Catch::Contains("disk full"));
  bench.recorder.set_trouble("");
  for (int i = 0; i < 10; ++i) {
    status = bench.judge();
    CHECK_FALSE(status.safe);
  }
  CHECK(status.restart == Restart::possible);
  CHECK(status.causes.empty());
  CHECK(bench.release().safe);
}

TEST_CASE("images of another size are not judged, and named") {
  Bench bench;
  REQUIRE(bench.release().safe);
  auto pair = bench.images();
  pair.first.image = Image(100, 120);
  bench.give(std::move(pair));
  REQUIRE(bench.recorder.wait_for_event("stopped"));
  const auto event = bench.recorder.last_change();
  CHECK(names_of(event.status.causes) == std::vector<std::string>{"left_size"});
  const Status next = bench.judge();
  CHECK_FALSE(next.safe);
  CHECK(names_of(next.causes).empty());  // what takes safe away from the machine is no fault of a table
}

TEST_CASE("a decision that hangs: not safe, whoever looks, and not by itself again") {
  Bench bench(3s);
  REQUIRE(bench.release().safe);
  const auto stops = bench.service->status().stops;
  bench.hold.held = true;
  bench.give(bench.images());
  CHECK(eventually([&] { return !bench.service->safe_state().at(Clock::now()).safe; }));
  REQUIRE(bench.recorder.wait_for_event("stopped"));
  const Status status = bench.service->status();
  CHECK_FALSE(status.safe);
  CHECK(names_of(status.causes) == std::vector<std::string>{"decision_late"});
  CHECK(status.stops == stops + 1);
  std::string why;
  CHECK_FALSE(bench.restart("anna", why));
  bench.hold.held = false;
  bench.recorder.status_of(++bench.pairs);
  for (int i = 0; i < 5; ++i) CHECK_FALSE(bench.judge().safe);
  CHECK(bench.release().safe);
}

TEST_CASE("a decision that hangs behind a fault of the monitor's own: nobody is shown safe, and it is told") {
  Bench bench(3s);
  REQUIRE(bench.release().safe);
  const auto stops = bench.service->status().stops;
  bench.hold.held = true;
  auto pair = bench.images();
  pair.second.taken += 2ms;  // a skew
  bench.give(std::move(pair));
  CHECK(eventually([&] { return !bench.service->safe_state().at(Clock::now()).safe; }));
  CHECK_FALSE(bench.service->status().safe);
  REQUIRE(bench.recorder.wait_for_event("stopped"));
  const Status status = bench.service->status();
  CHECK_FALSE(status.safe);
  CHECK(status.restart == Restart::needed);
  CHECK(status.stops == stops + 1);
  bench.hold.held = false;
  CHECK_FALSE(bench.recorder.status_of(++bench.pairs).safe);
  for (int i = 0; i < 5; ++i) CHECK_FALSE(bench.judge().safe);
  CHECK(bench.release().safe);
  CHECK(std::ranges::count(bench.recorder.names(), "stopped") == 1);
}

TEST_CASE("a decision that came too late, of images that are young: nobody is told that it was released") {
  Bench bench(3s);
  REQUIRE(bench.release().safe);
  std::this_thread::sleep_for(2s);
  bench.hold.held = true;
  bench.give(bench.images());
  REQUIRE(bench.recorder.wait_for_event("stopped"));
  bench.hold.held = false;
  CHECK_FALSE(bench.recorder.status_of(++bench.pairs).safe);
  CHECK_FALSE(bench.judge().safe);
  CHECK(bench.recorder.last_change().name == "stopped");
  CHECK(std::ranges::count(bench.recorder.names(), "released") == 1);
  CHECK(bench.release().safe);
}

TEST_CASE("images that were long on their way are not safe, however soon they are judged") {
  Bench bench(3s);
  REQUIRE(bench.release().safe);
  auto pair = bench.images();
  SECTION("both alike") {
    for (CameraFrame* frame : {&pair.first, &pair.second}) frame->taken_here = frame->arrived - 4s;
  }
  SECTION("one, and the other one has waited for it") { pair.first.arrived -= 3500ms; }
  bench.give(std::move(pair));
  Status status = bench.recorder.status_of(++bench.pairs);
  CHECK_FALSE(status.safe);
  const auto names = names_of(status.causes);
  CHECK(std::ranges::find(names, "decision_late") != names.end());
  for (int i = 0; i < 5; ++i) CHECK_FALSE(bench.judge().safe);
  CHECK(bench.release().safe);
}

TEST_CASE("a camera that falls silent is named, with what is known of it") {
  Bench bench(3s);
  REQUIRE(bench.release().safe);
  bench.service->lost(Side::right, "the cable is out");
  bench.service->frame(Side::left, bench.images().first);
  REQUIRE(bench.recorder.wait_for_event("stopped"));
  CHECK_FALSE(bench.service->safe_state().at(Clock::now()).safe);
  CHECK(eventually([&] {
    const Status status = bench.service->status();
    return std::ranges::any_of(status.causes, [](const Cause& cause) {
      return cause.name == "right_camera_lost" && cause.text.find("the cable is out") != std::string::npos;
    });
  }));
}

TEST_CASE("a camera that says itself that it is gone is not waited for") {
  Bench bench;
  REQUIRE(bench.release().safe);
  bench.service->lost(Side::left, "the stream has ended");
  REQUIRE(bench.recorder.wait_for_event("stopped"));
  CHECK_FALSE(bench.service->safe_state().at(Clock::now()).safe);
  const auto causes = bench.recorder.last_change().status.causes;
  CHECK(names_of(causes) == std::vector<std::string>{"left_camera_lost"});
  CHECK_THAT(causes.front().text, Catch::Contains("the stream has ended"));
}

TEST_CASE("causes that come and go without a pair do not fill the log") {
  Bench bench(3s);
  REQUIRE(bench.release().safe);
  const auto begin = Clock::now();
  std::uint64_t sent = 0;
  for (; Clock::now() - begin < 5s; ++sent) {  // of one camera alone: it has no partner
    bench.service->frame(Side::left, bench.images().first);
    std::this_thread::sleep_for(20ms);
  }
  CHECK(sent > 20);
  CHECK(bench.recorder.events().size() < 12);
  CHECK_FALSE(bench.service->safe_state().at(Clock::now()).safe);
  const auto last = bench.recorder.events().back().status.causes;
  CHECK(std::ranges::count(names_of(last), "right_camera_lost") == 1);
}

TEST_CASE("a machine that fails: not safe, told, and the end") {
  Bench bench;
  REQUIRE(bench.release().safe);
  bench.hold.fails = true;
  bench.give(bench.images());
  REQUIRE(bench.recorder.wait_for_event("stopped"));
  const Status status = bench.service->status();
  REQUIRE(names_of(status.causes) == std::vector<std::string>{"engine"});
  CHECK_THAT(status.causes.front().text, Catch::Contains("it burns"));
  while (!bench.ended) std::this_thread::sleep_for(1ms);
  CHECK_THAT(bench.failure, Catch::Contains("it burns"));
  CHECK_FALSE(bench.service->safe_state().at(Clock::now()).safe);
}

TEST_CASE("standard output that nobody reads holds nobody up: lines are lost, and that is its trouble") {
  std::signal(SIGPIPE, SIG_IGN);
  std::array<int, 2> ends{};
  REQUIRE(::pipe(ends.data()) == 0);
  const Cell cell;
  auto lines = make_lines(cell, Lines::json, ends[1]);
  const int count = 2500;
  for (int i = 0; i < count; ++i) lines->noted({}, {"anna", ""}, std::to_string(i));
  CHECK_THAT(lines->trouble(), Catch::Contains("is not read") && Catch::Contains("lines were lost"));

  SECTION("it is read again: whole lines in order, and all is well") {
    std::string text;
    std::thread reader([&text, end = ends[0]] {
      std::array<char, 4096> bytes{};
      for (ssize_t got = 0; (got = ::read(end, bytes.data(), bytes.size())) > 0;) {
        text.append(bytes.data(), static_cast<std::size_t>(got));
      }
    });
    CHECK(eventually([&] { return lines->trouble().empty(); }));
    lines.reset();
    ::close(ends[1]);
    reader.join();
    std::istringstream read(text);
    int next = 0;
    for (std::string line; std::getline(read, line); ++next) {
      const auto event = nlohmann::json::parse(line);
      if (next < 1000) REQUIRE(event["what"] == std::to_string(next));
    }
    CHECK(next >= 1000);
    CHECK(next < count);
    ::close(ends[0]);
  }
  SECTION("the reader is gone") {
    ::close(ends[0]);
    CHECK(eventually([&] { return lines->trouble().find("Broken pipe") != std::string::npos; }));
    lines.reset();
    ::close(ends[1]);
  }
  SECTION("it is never read: the end comes all the same") {
    lines.reset();
    ::close(ends[0]);
    ::close(ends[1]);
  }
}

TEST_CASE("standard output on a disk that was full for a moment: the broken line is ended, and all is well by itself") {
  std::signal(SIGXFSZ, SIG_IGN);
  const horopter::TemporaryDirectory directory;
  const int file = ::open((directory / "lines").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  REQUIRE(file >= 0);
  rlimit usual{};
  REQUIRE(::getrlimit(RLIMIT_FSIZE, &usual) == 0);
  rlimit full = usual;
  full.rlim_cur = 500;  // bytes of a file: the first line does not go in
  const Cell cell;
  auto lines = make_lines(cell, Lines::json, file);
  const std::string what(1000, 'x');
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &full) == 0);
  for (int i = 0; i < 3; ++i) lines->noted({}, {"anna", ""}, what + std::to_string(i));
  const bool told = eventually([&] { return lines->trouble().find("File too large") != std::string::npos; });
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &usual) == 0);
  CHECK(told);
  CHECK(eventually([&] { return lines->trouble().empty(); }));
  lines.reset();
  ::close(file);
  std::ifstream read(directory / "lines");
  int count = 0;
  for (std::string line; std::getline(read, line); ++count) {
    CHECK(nlohmann::json::parse(line)["what"] == what + std::to_string(count));
  }
  CHECK(count == 3);
}

TEST_CASE("a cell that need not be taught is not: begun anew it would not watch") {
  Bench bench;
  bench.judge();
  std::string why;
  CHECK_FALSE(bench.teach(3, why));
  CHECK_THAT(why, Catch::Contains("teach: {needed: true}"));
  const Status status = bench.judge();
  CHECK_FALSE(status.teaching);
  CHECK_FALSE(status.taught);
}

TEST_CASE("teaching: not safe meanwhile, and said when it has ended") {
  Bench bench(120s, false, true);
  std::string why;
  CHECK_FALSE(bench.teach(3, why));
  REQUIRE(bench.release().safe);
  CHECK_FALSE(bench.teach(0, why));
  REQUIRE(bench.teach(3, why));
  for (int i = 0; i < 3; ++i) {
    const Status status = bench.judge();
    CHECK_FALSE(status.safe);
    CHECK(status.teaching);
    CHECK(names_of(status.causes) == std::vector<std::string>{"teaching"});
    CHECK_FALSE(bench.teach(3, why));
  }
  Status status = bench.judge();
  CHECK_FALSE(status.teaching);
  CHECK(status.taught);
  std::vector<std::string> noted;
  for (const Event& event : bench.recorder.events()) {
    if (event.name == "noted") noted.push_back(event.what);
  }
  REQUIRE(noted.size() == 3);
  CHECK_THAT(noted[0], Catch::Contains("begins with"));
  CHECK_THAT(noted[1], Catch::Contains("for 3 pairs"));
  CHECK(noted[2] == "taught by 3 frames");
}

TEST_CASE("a teaching is refused where it stopped since somebody looked, or a fault comes with the first pair") {
  Bench bench(120s, false, true);
  std::string why;
  REQUIRE(bench.release().safe);
  SECTION("an alarm behind the question") {
    const auto seen = bench.service->status().stops;
    bench.judge(true);
    for (int i = 0; i < 5; ++i) bench.judge();
    CHECK_FALSE(bench.service->teach(3, {"egon", ""}, seen, why));
    CHECK_THAT(why, Catch::Contains("since you looked"));
    CHECK_FALSE(bench.judge().teaching);
    CHECK(bench.teach(3, why));
  }
  SECTION("a gap with the first pair") {
    REQUIRE(bench.teach(3, why));
    ++bench.number;
    CHECK_FALSE(bench.judge().teaching);
    CHECK(bench.has_noted("teaching refused: a fault came in between"));
  }
  SECTION("the first pair cannot be judged") {
    REQUIRE(bench.teach(1, why));
    auto pair = bench.images();
    pair.first.image = Image(100, 120);
    bench.give(std::move(pair));
    CHECK_FALSE(bench.judge().teaching);
    CHECK(bench.has_noted("teaching refused: a fault came in between"));
    CHECK_FALSE(bench.has_noted("taught"));
  }
}

namespace {
/// Of a teaching that was broken off; taught anew it counts from the beginning.
void check_nothing_is_taught(Bench& bench) {
  Status status;
  for (int i = 0; i < 20; ++i) {
    status = bench.judge();
    CHECK_FALSE(status.teaching);
  }
  CHECK_FALSE(status.taught);
  CHECK(status.causes.empty());
  CHECK_FALSE(bench.has_noted("taught by"));
  std::string why;
  REQUIRE(bench.teach(3, why));
  for (int i = 0; i < 3; ++i) CHECK(bench.judge().teaching);
  CHECK(bench.judge().taught);
  CHECK(bench.has_noted("taught by 3 frames"));
}
}  // namespace

TEST_CASE("a teaching is broken off by a fault of the monitor's own: nothing counts as taught") {
  Bench bench(120s, false, true);
  std::string why;
  REQUIRE(bench.release().safe);
  REQUIRE(bench.teach(20, why));
  for (int i = 0; i < 5; ++i) CHECK(bench.judge().teaching);
  SECTION("a camera that is gone for a while") {
    bench.service->lost(Side::left, "the cable is out");
    CHECK(eventually([&] { return bench.has_noted("teaching was broken off: left_camera_lost; teach again"); }));
    CHECK_FALSE(bench.service->status().teaching);
    bench.service->connected(Side::left);
  }
  SECTION("a time without images") {
    ++bench.number;
    CHECK_FALSE(bench.judge().teaching);
    CHECK(bench.has_noted("teaching was broken off: left_gap"));
  }
  check_nothing_is_taught(bench);
}

TEST_CASE("a teaching is broken off by an alarm or a fault of the machine: nothing counts as taught") {
  Bench bench(120s, false, true);
  std::string why;
  REQUIRE(bench.release().safe);
  REQUIRE(bench.teach(6, why));
  for (int i = 0; i < 3; ++i) CHECK(bench.judge().teaching);
  auto pair = bench.images(true);
  std::string cause = "alarm";
  SECTION("somebody comes") {}
  SECTION("a camera is covered") {
    pair.first.image = Image(kWidth, kHeight);
    cause = "left_black";
  }
  bench.give(std::move(pair));
  Status status = bench.recorder.status_of(++bench.pairs);
  const auto names = names_of(status.causes);
  CHECK(std::ranges::count(names, cause) == 1);
  CHECK_FALSE(status.teaching);
  const auto events = bench.recorder.events();
  CHECK(std::ranges::any_of(events, [&](const Event& event) {
    return event.what.starts_with("teaching was broken off: ") && event.what.find(cause) != std::string::npos;
  }));
  check_nothing_is_taught(bench);
}

TEST_CASE("by itself only where the cell says so; then a restart by hand is refused") {
  Bench bench(120s, true);
  Status status;
  for (int i = 0; i < 4; ++i) status = bench.judge();
  CHECK(status.safe);
  CHECK(status.restart_by_itself);
  CHECK_FALSE(bench.judge(true).safe);
  std::string why;
  CHECK_FALSE(bench.restart("anna", why));
  CHECK_THAT(why, Catch::Contains("by itself"));
  for (int i = 0; i < 4; ++i) status = bench.judge();
  CHECK(status.safe);
}

TEST_CASE("at its end it is not safe, and says that it has stopped") {
  Bench bench;
  REQUIRE(bench.release().safe);
  bench.stop = true;
  while (!bench.ended) std::this_thread::sleep_for(1ms);
  CHECK(bench.failure.empty());
  CHECK_FALSE(bench.service->safe_state().at(Clock::now()).safe);
  const Status status = bench.service->status();
  CHECK_FALSE(status.safe);
  CHECK(names_of(status.causes) == std::vector<std::string>{"ending"});
  CHECK(bench.recorder.names() == std::vector<std::string>{"noted", "released", "stopped"});
}

TEST_CASE("at an end while it is not safe nothing is told") {
  Bench bench;
  bench.judge();
  bench.stop = true;
  while (!bench.ended) std::this_thread::sleep_for(1ms);
  CHECK(bench.recorder.names() == std::vector<std::string>{"noted"});
}
