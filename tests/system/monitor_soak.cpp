// SPDX-License-Identifier: Apache-2.0
// A monitor for as many images as come in a day, with its outputs, its log and its page, and somebody who asks all of them:
// no memory, no descriptor and no image is lost. The next pair comes when the last one is decided, at simulated times; so it
// goes as fast as the computer does.
//   HOROPTER_LONG      2.6 million pairs, 30 a second for a day; else 4000
//   HOROPTER_PAIRS     another number of pairs
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <random>
#include <string>
#include <thread>

#include "horopter/monitor/camera.hpp"
#include "horopter/monitor/event_log.hpp"
#include "horopter/monitor/log_reader.hpp"
#include "horopter/monitor/service.hpp"
#include "http.hpp"
#include "monitor_machine.hpp"
#include "output/log_and_page.hpp"
#include "output/modbus.hpp"
#include "plc.hpp"
#include "running.hpp"

using namespace horopter::monitor;
using namespace horopter::test;
using horopter::Image;
using monitor_clock = horopter::monitor::Clock;

namespace {

constexpr int kWidth = 64, kHeight = 48, kShift = 8;
constexpr auto kPeriod = std::chrono::microseconds(33'333);

std::uint64_t pairs_asked() {
  if (const char* given = std::getenv("HOROPTER_PAIRS")) return std::strtoull(given, nullptr, 10);
  return std::getenv("HOROPTER_LONG") != nullptr ? 2'600'000 : 4'000;
}

/// What the program holds of the heap. The heap must be in one arena: the count is of the first.
double held_mib() {
  const auto heap = ::mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd) / (1 << 20);
}

double resident_mib() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t all = 0, resident = 0;
  file >> all >> resident;
  return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1 << 20);
}

std::size_t descriptors() {
  const fs::directory_iterator open("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(fs::begin(open), fs::end(open)));
}

Image textured(std::uint32_t seed) {
  std::mt19937 random(seed);
  Image image(kWidth, kHeight);
  for (auto& pixel : image.pixels) pixel = static_cast<std::uint8_t>(20 + random() % 200);
  return image;
}

/// What was judged, and what the last pair said.
class Counter : public Part {
 public:
  void judged(const MomentPtr& moment) override {
    const std::lock_guard lock(mutex_);
    ++judged_;
    last_ = moment->status;
    safe_ += last_.safe ? 1 : 0;
    changed_.notify_all();
  }
  void stopped(const Status& /*status*/, const MomentPtr& /*moment*/) override { ++stops_; }
  /// False: it was not judged within a minute.
  bool wait(std::uint64_t judged) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, 60s, [&] { return judged_ >= judged; });
  }
  Status last() const {
    const std::lock_guard lock(mutex_);
    return last_;
  }
  std::uint64_t judged() const {
    const std::lock_guard lock(mutex_);
    return judged_;
  }
  std::uint64_t safe() const {
    const std::lock_guard lock(mutex_);
    return safe_;
  }
  std::uint64_t stops() const { return stops_; }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t judged_ = 0, safe_ = 0;
  std::atomic<std::uint64_t> stops_ = 0;
  Status last_;
};

class Soak {
 public:
  explicit Soak(const Sandbox& box) {
    box.write("skin.yaml", "surface:\n  type: homography\n  matrix: [[1, 0, -" + std::to_string(kShift) +
                               "], [0, 1, 0], [0, 0, 1]]\n");
    cell_.path = box / "cell.yaml";
    cell_.frames_per_s = 30;
    cell_.decision_limit_ms = 5000;  // a computer that is busy with something else for a second is not the point
    cell_.settings.live = true;
    cell_.settings.proof.needed = false;
    cell_.settings.still_limit = 0;
    cell_.settings.blind_share = 0;
    cell_.settings.interlock.by_itself = true;
    cell_.settings.interlock.by_pin = false;
    cell_.outputs.modbus = ModbusCell{.address = "127.0.0.1", .port = free_port()};
    cell_.log = LogCell{.directory = box / "log", .size_mb = 10};
    cell_.web = WebCell{.listen = "127.0.0.1:" + std::to_string(page_port_),
                        .users_file = {},
                        .tls = {},
                        .names = {},
                        .restart = false};
    service_.emplace(
        cell_, [&](int width, int height) { return machine_of(cell_, box / "skin.yaml", width, height); }, kWidth,
        kHeight);
    parts_.push_back(make_modbus(*cell_.outputs.modbus, cell_, service_->safe_state()));
    parts_.push_back(make_log_and_page(cell_, *service_));
    service_->add(&counter_);
    for (const auto& part : parts_) service_->add(part.get());
    decision_ = std::thread([this] { service_->run([this] { return stop_.load(); }, 0); });
    for (const Side side : {Side::left, Side::right}) service_->connected(side);
    for (std::uint32_t i = 0; i < 16; ++i) pictures_.push_back(textured(i));
  }
  ~Soak() {
    stop_ = true;
    decision_.join();
  }
  Soak(const Soak&) = delete;
  Soak& operator=(const Soak&) = delete;

  /// The pair of a moment, and now and then something that is wrong with it.
  void give(std::uint64_t number) {
    CameraFrame left = image(number, 0), right = image(number, 1);
    if (number % 5000 == 400) {  // it lies on the skin
      for (int y = 0; y < kHeight; ++y) {
        for (int x = kShift; x < kWidth; ++x) right.image.at(x - kShift, y) = left.image.at(x, y);
      }
    }
    const bool lost = number % 7001 == 700, broken = number % 9001 == 900, repeated = number % 11'003 == 1100;
    if (number % 20'011 == 2000) {
      service_->lost(Side::right, "the cable was out");
      service_->connected(Side::right);
    }
    if (repeated) add(Side::left, left);
    add(Side::left, std::move(left));
    if (lost) return;
    if (broken) right.image = Image();
    add(Side::right, std::move(right));
    if (!broken) ++pairs_;
  }
  /// Until the last pair was judged.
  bool settle() { return counter_.wait(pairs_); }

  /// Of each camera, whether what came is what was judged and what was counted as not.
  void check_counts() const {
    const Status last = counter_.last();
    for (std::size_t side = 0; side < 2; ++side) {
      CAPTURE(side);
      CHECK(last.cameras[side].frames == given_[side]);
      CHECK(last.cameras[side].frames == counter_.judged() + last.cameras[side].dropped);
    }
  }
  const Counter& counter() const { return counter_; }
  int page_port() const { return page_port_; }
  int modbus_port() const { return cell_.outputs.modbus->port; }
  std::uint64_t given(std::size_t side) const { return given_.at(side); }

 private:
  CameraFrame image(std::uint64_t number, std::size_t side) const {
    CameraFrame frame;
    frame.image = pictures_[(2 * number + side) % pictures_.size()];
    frame.number = number;
    frame.taken = static_cast<std::int64_t>(number) * kPeriod;
    frame.arrived = monitor_clock::now();
    return frame;
  }
  void add(Side side, CameraFrame frame) {
    ++given_.at(static_cast<std::size_t>(side));
    service_->frame(side, std::move(frame));
  }

  Cell cell_;
  int page_port_ = free_port();
  std::vector<Image> pictures_;
  Counter counter_;
  std::optional<Service> service_;
  std::vector<std::unique_ptr<Part>> parts_;
  std::atomic<bool> stop_ = false;
  std::thread decision_;
  std::array<std::uint64_t, 2> given_{};
  std::uint64_t pairs_ = 0;
};

/// Looks at everything that the page has, each time by a new connection.
class Visitor {
 public:
  explicit Visitor(int port) : thread_([this, port] { run(port); }) {}
  ~Visitor() {
    ending_ = true;
    thread_.join();
  }
  Visitor(const Visitor&) = delete;
  Visitor& operator=(const Visitor&) = delete;
  std::uint64_t answers() const { return answers_; }

 private:
  void run(int port) {
    while (!ending_) {
      for (const char* path : {"/", "/api/status", "/api/picture", "/api/log", "/metrics"}) {
        httplib::Client client("127.0.0.1", port);
        const auto answer = client.Get(path);
        answers_ += answer && answer->status == 200 ? 1 : 0;
      }
      std::this_thread::sleep_for(50ms);
    }
  }
  std::atomic<bool> ending_ = false;
  std::atomic<std::uint64_t> answers_ = 0;
  std::thread thread_;
};

}  // namespace

TEST_CASE("as many images as in a day: memory, descriptors and images stay") {
  const std::uint64_t pairs = pairs_asked();
  ::mallopt(M_ARENA_MAX, 1);  // threads with arenas of their own fill them by chance: up to 10 MiB that nobody lost
  const Sandbox box;
  std::uint64_t stops = 0;
  {
    Soak soak(box);
    const std::uint64_t warm = std::max<std::uint64_t>(pairs / 10, 1000);
    double begin_mib = 0;
    std::size_t begin_open = 0;
    std::uint64_t visits = 0;
    const auto begin = monitor_clock::now();
    std::uint64_t number = 0;
    for (const bool warming : {true, false}) {
      {
        const Plc plc(soak.modbus_port());
        const Visitor visitor(soak.page_port());
        for (const std::uint64_t end = warming ? warm : pairs; number < end; ++number) {
          soak.give(number);
          REQUIRE(soak.settle());
        }
        visits += visitor.answers();
      }
      soak.give(number++);
      REQUIRE(soak.settle());
      // The server closes what its clients have closed, sooner or later: the fewest count, and those that stay open.
      std::size_t now_open = descriptors();
      for (int i = 0; i < (warming ? 20 : 600) && (warming || now_open > begin_open); ++i) {
        std::this_thread::sleep_for(50ms);
        now_open = std::min(now_open, descriptors());
      }
      ::malloc_trim(0);
      const double now_mib = held_mib();
      const double s = std::chrono::duration<double>(monitor_clock::now() - begin).count();
      std::printf("%8llu pairs after %7.1f s: %6.2f MiB held, %6.1f MiB resident, %zu descriptors\n",
                  static_cast<unsigned long long>(number), s, now_mib, resident_mib(), now_open);
      std::fflush(stdout);
      if (warming) {
        begin_mib = now_mib;
        begin_open = now_open;
        continue;
      }
      CHECK(now_open <= begin_open);
      // The log lists its last 500 events, about 10 KB each; a short run has few of them.
      CHECK(now_mib < begin_mib + (pairs < 100'000 ? 3 : 8));
    }
    const Status last = soak.counter().last();
    std::printf(
        "left %llu and right %llu images came; %llu pairs were judged; %llu and %llu images were dropped; safe in %llu\n",
        static_cast<unsigned long long>(soak.given(0)), static_cast<unsigned long long>(soak.given(1)),
        static_cast<unsigned long long>(soak.counter().judged()),
        static_cast<unsigned long long>(last.cameras[0].dropped),
        static_cast<unsigned long long>(last.cameras[1].dropped),
        static_cast<unsigned long long>(soak.counter().safe()));
    std::printf("%llu stops, %llu answers of the page\n", static_cast<unsigned long long>(soak.counter().stops()),
                static_cast<unsigned long long>(visits));
    soak.check_counts();
    CHECK(soak.counter().safe() > pairs / 2);
    CHECK(visits > 0);
    stops = soak.counter().stops();
    CHECK(stops > 0);
  }
  const LogReading log = read_log(box / "log", true);
  CHECK(log.problems.empty());
  CHECK_FALSE(log.events.empty());
}

TEST_CASE("a camera that is opened again and again leaves nothing open") {
  class Nothing : public CameraSink {
   public:
    void frame(Side, CameraFrame) override { ++frames; }
    void connected(Side) override {}
    void lost(Side, const std::string&) override {}
    void ended(Side) override {}
    std::atomic<int> frames = 0;
  };
  const int times = std::getenv("HOROPTER_LONG") != nullptr ? 1000 : 20;
  double begin_mib = 0;
  std::size_t begin_open = 0;
  for (int i = 0; i < times + 5; ++i) {
    if (i == 5) {
      begin_mib = resident_mib();
      begin_open = descriptors();
    }
    Nothing sink;
    CameraSettings settings;
    settings.camera.source = "gst:videotestsrc is-live=true ! video/x-raw,width=64,height=48,framerate=50/1";
    settings.frames_per_s = 50;
    const auto camera = start_camera(Side::left, Layout::single, settings, sink);
    REQUIRE(eventually([&] { return sink.frames > 0; }));
  }
  std::printf("%d times opened: %.1f to %.1f MiB resident, %zu to %zu descriptors\n", times, begin_mib, resident_mib(),
              begin_open, descriptors());
  CHECK(descriptors() == begin_open);
  CHECK(resident_mib() < begin_mib + 8);
}
