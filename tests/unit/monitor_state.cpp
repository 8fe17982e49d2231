// SPDX-License-Identifier: Apache-2.0
// What outputs may say, causes in words, objects that are followed, and what Modbus shows: without cameras and time.
#include <algorithm>
#include <array>
#include <atomic>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <thread>

#include "../system/eventually.hpp"
#include "../system/plc.hpp"
#include "horopter/machine/registers.hpp"
#include "horopter/monitor/causes.hpp"
#include "horopter/monitor/metrics.hpp"
#include "horopter/monitor/objects.hpp"
#include "horopter/monitor/safe_state.hpp"
#include "output/gpio.hpp"
#include "output/modbus.hpp"
#include "output/ticker.hpp"

using namespace horopter::monitor;
using horopter::monitor::Clock;
using horopter::test::connect_to;
using horopter::test::eventually;
using horopter::test::free_port;
using horopter::test::Plc;
using namespace std::chrono_literals;

namespace {

constexpr auto kLimit = 100ms;
const Clock::time_point kNow(1h);

}  // namespace

TEST_CASE("a decision is safe as long as it is young, and not by itself again") {
  SafeState state(kLimit);
  CHECK_FALSE(state.at(kNow).safe);
  state.decided(kNow, true, false, {});
  CHECK(state.at(kNow).safe);
  CHECK(state.at(kNow + kLimit).safe);
  CHECK_FALSE(state.missed());
  const Signal late = state.at(kNow + kLimit + 1ns);
  CHECK_FALSE(late.safe);
  CHECK(late.faults.monitor == MonitorFaults(MonitorFault::decision_late).word());
  CHECK(state.missed());
  // The decision comes back, and the machine knows nothing of it: still not safe.
  state.decided(kNow + 2 * kLimit, true, false, {});
  CHECK_FALSE(state.at(kNow + 2 * kLimit).safe);
  state.not_safe({});
  state.catch_up();
  state.decided(kNow + 3 * kLimit, true, false, {});
  CHECK(state.at(kNow + 3 * kLimit).safe);
}

TEST_CASE("after the computer slept it is not safe, though its clock stood still and the decision looks young") {
  Clock::duration slept = 5h;
  SafeState state(kLimit, [&] { return slept; });
  state.decided(kNow, true, false, {});
  slept = 5h + 10ms;  // readings differ
  CHECK(state.at(kNow).safe);
  SECTION("while it was safe") {}
  SECTION("while it was not: nobody restarts it for what was seen before") { state.not_safe({}); }
  slept = 6h;
  const Signal signal = state.at(kNow);
  CHECK_FALSE(signal.safe);
  CHECK(signal.faults.monitor == MonitorFaults(MonitorFault::decision_late).word());
  CHECK(state.missed());
  state.decided(kNow, true, false, {});
  CHECK_FALSE(state.at(kNow).safe);
  state.not_safe({});
  state.catch_up();
  state.decided(kNow, true, false, {});
  CHECK(state.at(kNow).safe);
  // The computer's own clocks, while it is awake and busy.
  const auto before = time_slept();
  for (int i = 0; i < 10'000; ++i) REQUIRE(std::chrono::abs(time_slept() - before) < 10ms);
}

TEST_CASE("an alarm, a fault and the end are not safe at once") {
  SafeState state(kLimit);
  state.decided(kNow, true, false, {});
  SECTION("alarm") {
    state.decided(kNow, false, true, {1, 2, 4});
    const Signal signal = state.at(kNow);
    CHECK(signal.alarm);
    CHECK(signal.faults.cameras == 1);
    CHECK(signal.faults.machine == 2);
    CHECK(signal.faults.monitor == 4);
    CHECK(signal.decisions == 2);
    CHECK_FALSE(signal.safe);
  }
  SECTION("fault") {
    state.not_safe({});
    CHECK_FALSE(state.at(kNow).safe);
  }
  SECTION("end: whatever is decided afterwards") {
    state.end();
    state.decided(kNow, true, false, {});
    CHECK_FALSE(state.at(kNow).safe);
  }
}

TEST_CASE("every fault of the machine and the monitor has a text and says what to do") {
  const auto is_said = [](std::string_view name) {
    CAPTURE(std::string(name));
    const Cause cause = cause_of(name);
    CHECK(cause.name == name);
    CHECK(cause.text.size() > 10);
    CHECK(cause.text != cause.name);
    CHECK(cause.advice.size() > 10);
    CHECK(cause.text.find('{') == std::string::npos);
    CHECK(cause.advice.find('{') == std::string::npos);
    if (name.starts_with("right_")) CHECK(cause.text.find("left") == std::string::npos);
  };
  for (const auto& [fault, name] : horopter::registers::kFaults) is_said(name);
  for (const std::string_view name : kMonitorFaultNames) is_said(name);
  is_said("alarm");
  CHECK(cause_of("no_such_fault").text == "no_such_fault");
}

TEST_CASE("causes: the alarm first, and what both name only once") {
  const auto causes =
      causes_of(true, MonitorFault::skew, horopter::Faults(horopter::Fault::skew) | horopter::Fault::moved);
  REQUIRE(causes.size() == 3);
  CHECK(causes[0].name == "alarm");
  CHECK(causes[1].name == "skew");
  CHECK(causes[2].name == "moved");
}

TEST_CASE("an object is shown with what is known of it, in mm where a rig says it") {
  horopter::TrackedObject object;
  object.id = 7;
  object.age_frames = 3;
  object.region = {.x = 10, .y = 20, .width = 30, .height = 40, .pixels = 500, .blind_pixels = 60};
  ObjectState state = state_of(object, Eigen::Vector3d(0, 0, 0));
  CHECK(state.id == 7);
  CHECK(state.age_frames == 3);
  CHECK(state.pixels == 500);
  CHECK(state.blind_pixels == 60);
  CHECK((state.x == 10 && state.y == 20 && state.width == 30 && state.height == 40));
  CHECK_FALSE((state.size_mm || state.distance_mm || state.speed_mm_s));
  object.in_space =
      horopter::ObjectInSpace{.area_mm2 = 900, .length_mm = 45, .width_mm = 25, .centroid_mm = {300, 0, 400}};
  object.motion = horopter::ObjectMotion{.px_frame = {1, 0}, .mm_frame = Eigen::Vector3d(3, 4, 0), .frame_s = 0.1};
  state = state_of(object, Eigen::Vector3d(0, 0, 0));
  CHECK(state.size_mm == Approx(45));
  CHECK(state.distance_mm == Approx(500));
  CHECK(state.speed_mm_s == Approx(50));
  CHECK_FALSE(state_of(object, {}).distance_mm);
}

TEST_CASE("Modbus shows safe and its complement, faults, age and configuration") {
  SafeState state(kLimit);
  auto registers = input_registers(state.at(kNow), 0x12345678);
  CHECK(registers[2] == 0);
  CHECK(registers[3] == 1);
  CHECK(registers[5] == 65535);
  CHECK(registers[12] == 0x1234);
  CHECK(registers[13] == 0x5678);
  state.decided(kNow, true, false, {0xAABBCCDD, 1, 2});
  registers = input_registers(state.at(kNow + 30ms), 0);
  CHECK(registers[0] == 1);
  CHECK(registers[1] == 1);
  CHECK(registers[2] == 1);
  CHECK(registers[3] == 0);
  CHECK(registers[5] == 30);
  CHECK(registers[6] == 0xAABB);
  CHECK(registers[7] == 0xCCDD);
  CHECK(registers[9] == 1);
  CHECK(registers[11] == 2);
  CHECK(discrete_inputs(state.at(kNow)) == std::array<std::uint8_t, 4>{1, 0, 0, 1});
  CHECK(discrete_inputs(state.at(kNow + 1s)) == std::array<std::uint8_t, 4>{0, 1, 0, 1});
}

TEST_CASE("requests of noise to the Modbus server change nothing and stop nothing") {
  SafeState state(1h);
  state.decided(Clock::now(), false, true, {1, 2, 4});
  Cell cell;
  cell.outputs.modbus = ModbusCell{.address = "127.0.0.1", .port = free_port()};
  const auto server = make_modbus(*cell.outputs.modbus, cell, state);
  const auto seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937 random(seed);
  const char* const given = std::getenv("HOROPTER_REQUESTS");
  for (int i = given != nullptr ? std::atoi(given) : 400; i > 0; --i) {
    // Half of them have a head that is in order, of any function.
    std::vector<std::uint8_t> bytes(random() % 300);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    if (i % 2 == 0 && bytes.size() > 8) {
      const std::size_t length = bytes.size() - 6;
      const std::array<std::uint8_t, 6> head{
          0, 1, 0, 0, static_cast<std::uint8_t>(length >> 8), static_cast<std::uint8_t>(length)};
      std::ranges::copy(head, bytes.begin());
      bytes[7] = static_cast<std::uint8_t>(random() % 0x2C);
    }
    const int socket = connect_to(cell.outputs.modbus->port);
    REQUIRE(socket >= 0);
    ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    ::shutdown(socket, SHUT_WR);
    std::array<std::uint8_t, 512> answer{};
    while (::recv(socket, answer.data(), answer.size(), 0) > 0) {
    }
    ::close(socket);
  }
  CHECK(state.at(Clock::now()).decisions == 1);
  const Plc plc(cell.outputs.modbus->port);
  const auto give_up = Clock::now() + 60s;
  while (plc.answers_after({}).empty() && Clock::now() < give_up) std::this_thread::sleep_for(1ms);
  REQUIRE_FALSE(plc.answers_after({}).empty());
  CHECK(plc.answers_after({}).back().heartbeat == 1);
  CHECK_FALSE(plc.safe());
}

TEST_CASE("lines follow what may be said, by a thread of their own: a decision that hangs, and the end, are not safe") {
  SafeState state(50ms);
  std::atomic<int> said = -1;  // safe line, and twice the other
  std::atomic<bool> works = true;
  auto lines = std::make_unique<LinesFollower>(
      [&](bool safe, bool not_safe) {
        said = (safe ? 1 : 0) + (not_safe ? 2 : 0);
        return works.load();
      },
      state);
  REQUIRE(eventually([&] { return said == 2; }));
  // The decision goes on until the line says so; then it hangs.
  REQUIRE(eventually(
      [&] {
        state.not_safe({});
        state.catch_up();
        state.decided(Clock::now(), true, false, {});
        std::this_thread::sleep_for(5ms);
        return said == 1;
      },
      1ms));
  CHECK(eventually([&] { return said == 2; }));
  CHECK(lines->trouble().empty());
  said = -1;
  lines.reset();
  CHECK(said == 2);
  works = false;
  lines = std::make_unique<LinesFollower>([&](bool, bool) { return works.load(); }, state);
  CHECK(eventually([&] { return !lines->trouble().empty(); }));
  works = true;
  CHECK(eventually([&] { return lines->trouble().empty(); }));
}

TEST_CASE("outputs look soon, however long a decision may be old, and just when it is too old") {
  SECTION("an alarm is not waited for") {
    SafeState state(4min);
    std::atomic<bool> said = false;
    const LinesFollower lines(
        [&](bool safe, bool) {
          said = safe;
          return true;
        },
        state);
    state.decided(Clock::now(), true, false, {});
    REQUIRE(eventually([&] { return said.load(); }));
    const auto alarm_at = Clock::now();
    state.decided(alarm_at, false, true, {});
    REQUIRE(eventually([&] { return !said; }));
    CHECK(Clock::now() - alarm_at < 10s);
  }
  SECTION("its limit comes between two looks") {
    constexpr auto limit = 160ms;
    SafeState state(limit);
    std::mutex mutex;
    std::optional<Clock::time_point> too_old;  // of a decision at which it has looked while it was young
    Clock::time_point next;
    auto least = Clock::duration::max();  // of many: the computer may be busy
    int looks = 0;
    {
      const Ticker ticker(state, [&](const Signal& signal) {
        const std::lock_guard lock(mutex);
        const auto now = Clock::now();
        if (signal.safe) {
          too_old = next;
          return;
        }
        if (too_old) {
          least = std::min(least, now - *too_old);
          ++looks;
        }
        too_old.reset();
        next = now + 25ms;
        state.not_safe({});
        state.catch_up();
        state.decided(next - limit, true, false, {});
      });
      CHECK(eventually([&] {
        const std::lock_guard lock(mutex);
        return looks >= 20;
      }));
    }
    CHECK(least < 10ms);
  }
}

TEST_CASE("a line with pulses changes while it is safe, and stands still whatever else is so") {
  SafeState state(80ms);
  std::atomic<int> changes = 0;
  std::atomic<bool> level = false, works = true;
  const LinesFollower lines([](bool, bool) { return true; }, state,
                            [&](bool to) {
                              changes += to != level.exchange(to) ? 1 : 0;
                              return works.load();
                            });
  std::this_thread::sleep_for(100ms);
  CHECK(changes == 0);
  const auto safe_until = [&](const auto& condition) {
    for (const auto give_up = Clock::now() + 60s; Clock::now() < give_up && !condition();) {
      state.not_safe({});
      state.catch_up();
      state.decided(Clock::now(), true, false, {});
      std::this_thread::sleep_for(20ms);
    }
    return condition();
  };
  CHECK(safe_until([&] { return changes > 10; }));
  works = false;
  CHECK(safe_until([&] { return !lines.trouble().empty(); }));
  works = true;
  // The decision hangs.
  std::this_thread::sleep_for(200ms);
  const int before = changes;
  std::this_thread::sleep_for(100ms);
  CHECK(changes == before);
}

TEST_CASE("metrics: each value once, with its type, and names that cannot break out of their quotes") {
  Status status;
  status.frame = 7;
  status.skew_ms = -0.5;
  status.causes = {cause_of("left_gap"), {"a\"b\\c\nd", "", ""}};
  status.cameras.resize(2);
  status.cameras[1].name = "r";
  status.cameras[1].dropped = 3;
  const std::string text = metrics(status);
  for (const char* line :
       {"# TYPE horopter_safe gauge\nhoropter_safe 0\n", "horopter_pairs_total 7\n", "horopter_skew_seconds -0.0005\n",
        "horopter_cause{name=\"left_gap\"} 1\n", "horopter_cause{name=\"a\\\"b\\\\c\\nd\"} 1\n",
        "horopter_camera_dropped_total{side=\"right\",camera=\"r\"} 3\n"}) {
    CHECK_THAT(text, Catch::Contains(line));
  }
  CHECK(text.find("explained") == std::string::npos);
}
