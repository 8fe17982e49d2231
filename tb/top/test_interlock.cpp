// SPDX-License-Identifier: Apache-2.0
// The restart interlock of the machine: after an alarm or a fault good frames alone do not make safe, and only a restart
// that is whole, allowed and late enough does. What always holds is proved: rtl/formal/formal_safe.sv.
#include <Vhoropter_machine_vga.h>

#include "machine_bench.hpp"

namespace horopter::tb {
namespace {

constexpr unsigned kWidth = 64;
constexpr unsigned kHeight = 24;
constexpr unsigned kFrames = 3;  // that must be good before a restart
constexpr int kShift = -5;

const std::uint32_t kByPin = reg::interlock::kByPin.put(1) | reg::interlock::kFrames.put(kFrames);
const std::uint32_t kByRegister = reg::interlock::kByRegister.put(1) | reg::interlock::kFrames.put(kFrames);

/// A machine that has a table and has seen nothing yet.
struct Guarded {
  explicit Guarded(std::uint32_t interlock) : machine{"vga", {kWidth, kHeight, 8, false, 40'000, 0, 0, interlock}} {
    machine.upload(0, 0, plane_table(kWidth, kHeight, kShift));
    machine.select(0);
    good_from_now();
  }

  void good_from_now() { set_alarm_limit(static_cast<int>(kWidth * kHeight)); }
  void set_alarm_limit(int pixels) {
    machine.settings().alarm_limit = pixels;
    machine.write_limits();
  }
  /// Frames of the scene; whether the pins say safe after the last.
  bool frames(unsigned count) {
    bool safe = false;
    for (unsigned i = 0; i < count; ++i) {
      machine.send(random_pair(kWidth, kHeight, kShift, rng));
      last = machine.receive();
      safe = last.safe_pin;
    }
    return safe;
  }
  /// A press that begins and ends while no frame is finished, or while `count` are.
  bool press(unsigned count) {
    machine.model().restart_i = 1;
    machine.settle(10);
    const bool safe = frames(count);
    machine.model().restart_i = 0;
    machine.settle(10);
    return safe;
  }
  bool waiting() { return reg::status::kWaiting.get(machine.read(reg::status::kAddress)) != 0; }

  Rng rng{"interlock"};
  Machine<Vhoropter_machine_vga> machine;
  Published last;
};

TEST_CASE("good frames alone do not make safe, neither at start nor after an alarm", "[interlock]") {
  Guarded guarded(kByPin);
  CHECK_FALSE(guarded.frames(kFrames - 1));
  CHECK_FALSE(guarded.waiting());
  CHECK_FALSE(guarded.frames(4));
  CHECK(guarded.last.safe());  // the frame itself
  CHECK(guarded.waiting());
  CHECK_FALSE(guarded.press(1));
  CHECK(guarded.frames(1));
  CHECK_FALSE(guarded.waiting());
  CHECK(guarded.frames(3));

  guarded.set_alarm_limit(0);
  CHECK_FALSE(guarded.frames(1));
  CHECK(guarded.last.alarm());
  guarded.good_from_now();
  CHECK_FALSE(guarded.frames(kFrames + 4));
  CHECK(guarded.last.safe());
  CHECK_FALSE(guarded.press(1));
  CHECK(guarded.frames(1));
  CHECK_FALSE(guarded.machine.pins_ever_equal());
}

TEST_CASE("an object that two of three frames must show stops the machine within the second, and not before",
          "[interlock]") {
  Guarded guarded(reg::interlock::kByItself.put(1));
  auto& machine = guarded.machine;
  machine.alarm_frames = reg::alarm_frames::kNeeded.put(2) | reg::alarm_frames::kOf.put(3);
  machine.configure();
  machine.select(0);
  CHECK(guarded.frames(4));
  const int never = machine.settings().object_limit;
  const auto show = [&](bool object) {
    machine.settings().object_limit = object ? 50 : never;
    machine.write_limits();
  };
  show(true);
  CHECK(guarded.frames(1));
  CHECK_FALSE(guarded.last.alarm());
  CHECK(reg::frame_status::kSeen.get(guarded.last.status) == 1);
  machine.settle(2000);  // what the last frame showed does not count twice
  CHECK(machine.model().safe_o == 1);
  show(false);
  CHECK(guarded.frames(1));
  show(true);
  const unsigned done = machine.frames_done();
  machine.send(random_pair(kWidth, kHeight, kShift, guarded.rng));
  machine.simulation().run_until([&] { return machine.model().safe_o == 0; }, 40'000, "not safe");
  CHECK(machine.frames_done() == done);
  CHECK(machine.receive().alarm());
  show(false);
  CHECK(guarded.frames(5));
  CHECK_FALSE(machine.pins_ever_equal());
}

TEST_CASE("a restart that comes too early is forgotten", "[interlock]") {
  Guarded guarded(kByPin);
  SECTION("before as many good frames") {
    guarded.frames(1);
    guarded.press(1);
  }
  SECTION("during an alarm") {
    guarded.frames(kFrames);
    guarded.set_alarm_limit(0);
    guarded.press(2);
    guarded.good_from_now();
  }
  SECTION("before an alarm, let go soon after it, or when all is good again") {
    const unsigned after = GENERATE(1U, kFrames + 2);
    guarded.frames(kFrames);
    guarded.machine.model().restart_i = 1;
    guarded.frames(1);
    guarded.set_alarm_limit(0);
    guarded.frames(1);
    guarded.good_from_now();
    guarded.frames(after);
    guarded.machine.model().restart_i = 0;
  }
  SECTION("before a reset, let go when all is good again") {
    guarded.machine.model().restart_i = 1;
    guarded.machine.settle(10);
    guarded.machine.write(reg::control::kAddress, 0);
    guarded.machine.settle(100);
    guarded.machine.forget();
    guarded.machine.write(reg::control::kAddress, reg::control::kEnable.put(1));
    guarded.machine.select(0);
    guarded.frames(kFrames + 2);
    guarded.machine.model().restart_i = 0;
  }
  CHECK_FALSE(guarded.frames(kFrames + 2));
  CHECK(guarded.waiting());
  guarded.press(1);
  CHECK(guarded.frames(1));
}

TEST_CASE("a button that is held, touched or bounces", "[interlock]") {
  Guarded guarded(kByPin);
  guarded.frames(kFrames);
  // Touched: no frame is finished meanwhile.
  guarded.press(0);
  CHECK_FALSE(guarded.frames(2));
  // Held: nothing until it is let go.
  CHECK_FALSE(guarded.press(4));
  CHECK(guarded.frames(1));
  // Bounces after an alarm, and again when it is let go: what was safe stays, and nothing else becomes it.
  guarded.set_alarm_limit(0);
  guarded.frames(1);
  guarded.good_from_now();
  for (int i = 0; i < 20; ++i) guarded.press(0);
  CHECK_FALSE(guarded.frames(kFrames + 1));
  guarded.press(1);
  for (int i = 0; i < 20; ++i) guarded.press(0);
  CHECK(guarded.frames(2));
}

TEST_CASE("a button that is stuck is a fault until it is let go", "[interlock]") {
  Guarded guarded(kByPin);
  guarded.machine.model().restart_i = 1;
  guarded.frames(254);
  CHECK(guarded.last.fault_names().empty());
  guarded.frames(2);
  CHECK(guarded.last.fault_names() == std::set<std::string>{"restart"});
  CHECK_FALSE(guarded.last.safe());
  guarded.machine.model().restart_i = 0;
  CHECK_FALSE(guarded.frames(kFrames + 1));
  CHECK(guarded.last.fault_names().empty());
}

TEST_CASE("the frame that ends lateness is good, and does not make safe", "[interlock]") {
  const bool by_itself = GENERATE(true, false);
  Guarded guarded(by_itself ? reg::interlock::kByItself.put(1) : kByPin);
  guarded.frames(kFrames);
  if (!by_itself) guarded.press(1);
  CHECK(guarded.frames(1));
  guarded.machine.settle(2 * 40'000);
  CHECK(guarded.machine.model().safe_o == 0);
  CHECK_FALSE(guarded.frames(1));
  CHECK(guarded.last.safe());  // the frame itself
  CHECK(guarded.frames(1) == by_itself);
  CHECK(guarded.frames(kFrames) == by_itself);
  if (by_itself) return;
  guarded.press(1);
  CHECK(guarded.frames(1));
}

TEST_CASE("the key restarts where it is allowed, and nothing else does", "[interlock]") {
  const bool allowed = GENERATE(false, true);
  Guarded guarded(allowed ? kByRegister : kByPin);
  guarded.frames(kFrames);
  for (const std::uint32_t key : {0U, 1U, ~0U, reg::kRestartKey ^ 1U})
    guarded.machine.write(reg::restart::kAddress, key);
  CHECK_FALSE(guarded.frames(1));
  if (allowed) guarded.press(1);  // the pin is not asked
  CHECK_FALSE(guarded.frames(1));
  guarded.machine.write(reg::restart::kAddress, reg::kRestartKey);
  CHECK(guarded.frames(1) == allowed);
}

/// Contactors hang at safe_o.
struct WithContactors : Guarded {
  static constexpr unsigned kPatience = 600;  // clocks: less than a frame takes
  using Contactors = Machine<Vhoropter_machine_vga>::Contactors;
  explicit WithContactors(std::uint32_t interlock) : Guarded(interlock) {
    machine.write(reg::control::kAddress, 0);
    machine.write(reg::feedback::kAddress, kPatience);
    machine.settle(10);
    machine.write(reg::control::kAddress, reg::control::kEnable.put(1));
    machine.select(0);
  }
  bool told() {
    const auto faults = Faults(0, machine.read(reg::faults_machine::kAddress));
    return faults.has(Fault::contactors);
  }
};

TEST_CASE("contactors that follow are no fault", "[interlock]") {
  WithContactors cell(kByPin);
  cell.machine.set_contactors(WithContactors::Contactors::follow, 500);
  cell.machine.settle(2'000);
  cell.frames(kFrames);
  CHECK_FALSE(cell.press(1));
  CHECK(cell.frames(3));
  cell.set_alarm_limit(0);
  CHECK_FALSE(cell.frames(2));
  cell.good_from_now();
  cell.frames(kFrames);
  cell.press(1);
  CHECK(cell.frames(2));
  CHECK_FALSE(cell.told());
}

TEST_CASE("contactors that weld, stick or are slow are a fault, and safe_o does not rise again", "[interlock]") {
  using Contactors = WithContactors::Contactors;
  WithContactors cell(kByPin);
  cell.machine.settle(2'000);
  cell.frames(kFrames);
  cell.press(1);
  REQUIRE(cell.frames(2));
  SECTION("welded: they do not drop after an alarm") {
    cell.machine.set_contactors(Contactors::stay_pulled, 0);
    CHECK(cell.frames(2));  // nobody can know yet
    cell.set_alarm_limit(0);
    cell.frames(1);
    cell.good_from_now();
    cell.frames(kFrames);
    CHECK(cell.told());
    CHECK(cell.last.fault_names().contains("contactors"));
    CHECK_FALSE(cell.waiting());
    cell.press(1);
    CHECK_FALSE(cell.frames(kFrames));
    cell.machine.set_contactors(Contactors::follow, 20);
    cell.frames(kFrames + 1);
    cell.press(1);
    CHECK(cell.frames(2));
  }
  SECTION("they drop by themselves, or their wire is short") {
    cell.machine.set_contactors(Contactors::stay_dropped, 0);
    cell.frames(2);
    CHECK(cell.told());
    CHECK_FALSE(cell.frames(1));
  }
  SECTION("too slow") {
    cell.machine.set_contactors(Contactors::follow, 700);
    cell.set_alarm_limit(0);
    cell.frames(2);
    CHECK(cell.told());
  }
}

TEST_CASE("a contactor that welded is seen where safe_o would rise before its time is over", "[interlock]") {
  WithContactors cell(reg::interlock::kByItself.put(1));
  cell.machine.write(reg::control::kAddress, 0);
  cell.machine.write(reg::feedback::kAddress, 0xFFFFFFFFU);  // never told as a fault
  cell.machine.settle(10);
  cell.machine.write(reg::control::kAddress, reg::control::kEnable.put(1));
  cell.machine.select(0);
  REQUIRE(cell.frames(3));
  cell.machine.set_contactors(WithContactors::Contactors::stay_pulled, 0);
  cell.set_alarm_limit(0);
  CHECK_FALSE(cell.frames(1));
  cell.good_from_now();
  CHECK_FALSE(cell.frames(6));
  cell.machine.set_contactors(WithContactors::Contactors::follow, 0);
  CHECK(cell.frames(2));
}

}  // namespace
}  // namespace horopter::tb
