// SPDX-License-Identifier: Apache-2.0
// Which images belong together, and what is wrong with them: against a clock that is simulated.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "horopter/monitor/pairing.hpp"

using namespace horopter::monitor;
using namespace std::chrono_literals;

namespace {

constexpr auto kPeriod = 40ms;
constexpr auto kSkew = 600us;

PairingRules rules() {
  PairingRules rules;
  rules.period = kPeriod;
  rules.largest_skew = kSkew;
  rules.lost_after = 100ms;
  rules.width = 4;
  rules.height = 2;
  return rules;
}

/// Two cameras on one trigger. What a test changes is changed before an image is given away.
struct Cameras {
  explicit Cameras(const PairingRules& with = rules()) : pairing(with) {}

  CameraFrame frame(std::int64_t number) const {
    CameraFrame frame;
    frame.image = horopter::Image(4, 2);
    frame.number = static_cast<std::uint64_t>(number);
    frame.taken = number * kPeriod;
    frame.arrived = Clock::time_point(1h) + number * kPeriod + 5ms;
    return frame;
  }
  void add(Side side, std::int64_t number) { pairing.add(side, frame(number)); }
  /// Both images of a moment; the faults of the pair, if there is one.
  std::set<std::string> both(std::int64_t number) { return give(frame(number), frame(number)); }
  std::set<std::string> give(CameraFrame left, CameraFrame right) {
    pairing.add(Side::left, std::move(left));
    pairing.add(Side::right, std::move(right));
    return taken();
  }
  std::set<std::string> of_serials(std::int64_t number, const std::string& left_serial,
                                   const std::string& right_serial) {
    CameraFrame left = frame(number), right = frame(number);
    left.serial = left_serial;
    right.serial = right_serial;
    return give(left, right);
  }
  std::set<std::string> taken() {
    const auto pair = pairing.take();
    if (!pair) return {"no pair"};
    const auto names = pair->faults.names();
    return {names.begin(), names.end()};
  }

  Pairing pairing;
};

using Names = std::set<std::string>;

}  // namespace

TEST_CASE("a million images of good cameras: each is in a pair, and nothing is wrong") {
  Cameras cameras;
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::int64_t> jitter_us(-290, 290);
  std::uint64_t wrong = 0;
  for (std::int64_t number = 0; number < 500'000; ++number) {
    CameraFrame left = cameras.frame(number);
    CameraFrame right = cameras.frame(number);
    left.taken += jitter_us(random) * 1us;
    right.taken += jitter_us(random) * 1us;
    const bool right_first = random() % 2 == 0;
    cameras.pairing.add(right_first ? Side::right : Side::left, right_first ? right : left);
    cameras.pairing.add(right_first ? Side::left : Side::right, right_first ? left : right);
    const auto pair = cameras.pairing.take();
    if (!pair || pair->faults.any() || pair->left.number != pair->right.number) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(cameras.pairing.counts(Side::left).frames == 500'000);
  CHECK(cameras.pairing.counts(Side::left).dropped == 0);
  CHECK(cameras.pairing.counts(Side::right).dropped == 0);
  CHECK(cameras.pairing.rate(Side::left) == Approx(25).epsilon(0.01));
}

TEST_CASE("a million images of cameras that lose some: every one is accounted for, and no pair is of two moments") {
  Cameras cameras;
  std::mt19937_64 random(2);
  std::uint64_t pairs = 0, mixed = 0, lost = 0, unnamed = 0;
  for (std::int64_t number = 0; number < 500'000; ++number) {
    const bool left = random() % 100 != 0, right = random() % 100 != 0;
    lost += (left ? 0 : 1) + (right ? 0 : 1);
    if (left) cameras.add(Side::left, number);
    if (right) cameras.add(Side::right, number);
    while (const auto pair = cameras.pairing.take()) {
      ++pairs;
      if (pair->left.taken != pair->right.taken) ++mixed;
      const bool after_loss = pair->left.number != pair->right.number;
      if (after_loss && !pair->faults.any()) ++unnamed;
    }
  }
  const auto &left = cameras.pairing.counts(Side::left), &right = cameras.pairing.counts(Side::right);
  CHECK(mixed == 0);
  CHECK(unnamed == 0);
  CHECK(left.frames == pairs + left.dropped);
  CHECK(right.frames == pairs + right.dropped);
  CHECK(left.lost + right.lost == lost);
}

TEST_CASE("skew: within the limit it is none, beyond it is named, and half a period is another image") {
  Cameras cameras;
  CHECK(cameras.both(0).empty());
  CameraFrame late = cameras.frame(1);
  late.taken += kSkew;
  CHECK(cameras.give(cameras.frame(1), late).empty());
  late = cameras.frame(2);
  late.taken += kSkew + 1us;
  CHECK(cameras.give(cameras.frame(2), late) == Names{"skew"});
  late = cameras.frame(3);
  late.taken += 2ms;
  CHECK(cameras.give(cameras.frame(3), late) == Names{"skew"});
  late = cameras.frame(4);
  late.taken += 21ms;
  CHECK(cameras.give(cameras.frame(4), late) == Names{"no pair"});
  CHECK(cameras.both(5) == Names{"left_unpaired", "numbers", "skew"});
}

TEST_CASE("a camera that is late by whole images is told by its numbers, and stays so") {
  const int late = GENERATE(1, 10);
  Cameras cameras;
  for (int i = 0; i < 5; ++i) CHECK(cameras.both(i).empty());
  // It stands still, and then goes on where it was: its next number comes so many periods later.
  std::set<std::string> named;
  for (int i = 5; i < 40; ++i) {
    cameras.add(Side::left, i);
    if (i >= 5 + late) {
      CameraFrame frame = cameras.frame(i);
      frame.number = static_cast<std::uint64_t>(i - late);
      cameras.pairing.add(Side::right, frame);
    }
    const auto faults = cameras.taken();
    named.insert(faults.begin(), faults.end());
    if (i > 30) CHECK(faults == Names{"numbers"});
  }
  CHECK(named.count("right_gap") == 1);
  // Both clocks are set back.
  for (int i = 40; i < 45; ++i) {
    CameraFrame left = cameras.frame(i), right = cameras.frame(i);
    right.number = static_cast<std::uint64_t>(i - late);
    left.taken -= 1h;
    right.taken -= 1h;
    const auto faults = cameras.give(left, right);
    CHECK(faults.count("numbers") == 1);
    CHECK(faults.count("left_time_back") == (i == 40 ? 1 : 0));
  }
}

TEST_CASE("gaps, repeats and times that go back or jump are faults of their camera") {
  Cameras cameras;
  REQUIRE(cameras.both(0).empty());
  SECTION("gap by number") {
    CHECK(cameras.both(2) == Names{"left_gap", "right_gap"});
    CHECK(cameras.pairing.counts(Side::left).lost == 1);
    CHECK(cameras.both(3).empty());
  }
  SECTION("gap by time, of a camera that does not count") {
    CameraFrame left = cameras.frame(2), right = cameras.frame(2);
    left.number.reset();
    right.number = 1;
    CHECK(cameras.give(left, right) == Names{"left_gap", "right_gap"});
  }
  SECTION("the same again") {
    cameras.add(Side::left, 0);
    CHECK(cameras.both(1) == Names{"left_repeated"});
    CHECK(cameras.pairing.counts(Side::left).repeated == 1);
  }
  SECTION("another number at the same time") {
    CameraFrame again = cameras.frame(0);
    again.number = 1;
    cameras.pairing.add(Side::right, again);
    CHECK(cameras.both(2).count("right_repeated") == 1);
  }
  SECTION("back") {
    REQUIRE(cameras.both(1).empty());
    CameraFrame back = cameras.frame(2);
    back.taken = -1h;
    cameras.pairing.add(Side::right, back);
    CHECK(cameras.pairing.check(Clock::time_point(1h), {}).has(MonitorFault::right_time_back));
  }
  SECTION("a count that begins anew") {
    REQUIRE(cameras.both(1).empty());
    CameraFrame left = cameras.frame(2);
    left.number = 0;
    CHECK(cameras.give(left, cameras.frame(2)) == Names{"left_time_back"});
  }
  SECTION("jump") {
    CameraFrame left = cameras.frame(1), right = cameras.frame(1);
    left.taken += 1h;
    right.taken += 1h;
    CHECK(cameras.give(left, right) == Names{"left_gap", "left_time_jump", "right_gap", "right_time_jump"});
  }
}

TEST_CASE("another size, exposure, lost packets, and cameras that are exchanged") {
  PairingRules with = rules();
  with.serials = {"A", "B"};
  Cameras cameras(with);
  const auto of_camera = [&](std::int64_t number, const char* serial) {
    CameraFrame frame = cameras.frame(number);
    frame.serial = serial;
    frame.exposure_us = 1000;
    return frame;
  };
  CHECK(cameras.give(of_camera(0, "A"), of_camera(0, "B")).empty());
  CHECK(cameras.give(of_camera(1, "B"), of_camera(1, "A")) == Names{"swapped"});
  CHECK(cameras.give(of_camera(2, "A"), of_camera(2, "C")) == Names{"right_wrong_camera"});
  CHECK(cameras.give(of_camera(3, ""), of_camera(3, "B")) == Names{"left_wrong_camera"});
  CameraFrame left = of_camera(4, "A");
  left.image = horopter::Image(2, 4);
  cameras.pairing.add(Side::left, left);
  cameras.pairing.add(Side::right, of_camera(4, "B"));
  const auto pair = cameras.pairing.take();
  REQUIRE(pair);
  CHECK(pair->faults == MonitorFaults(MonitorFault::left_size));
  CHECK_FALSE(pair->judgeable);
  left = of_camera(5, "A");
  left.exposure_us = 1020;
  CHECK(cameras.give(left, of_camera(5, "B")) == Names{"left_exposure"});
  CHECK(cameras.give(of_camera(6, "A"), of_camera(6, "B")).empty());
  CameraFrame right = of_camera(7, "B");
  right.lost_packets = 3;
  CHECK(cameras.give(of_camera(7, "A"), right) == Names{"right_lost_packets"});
  CHECK(cameras.pairing.counts(Side::right).lost_packets == 3);
}

TEST_CASE("a camera whose serial number nobody wrote down stays the one that it was at first") {
  PairingRules with = rules();
  const bool left_is_written = GENERATE(false, true);
  if (left_is_written) with.serials[0] = "A";
  Cameras cameras(with);
  if (!left_is_written) CHECK(cameras.of_serials(0, "", "").empty());
  CHECK(cameras.of_serials(1, "A", "B").empty());
  cameras.pairing.reconnected(Side::right);
  CHECK(cameras.of_serials(2, "A", "C") == Names{"right_camera_lost", "right_wrong_camera"});
  CHECK(cameras.of_serials(3, "A", "C") == Names{"right_wrong_camera"});
  CHECK(cameras.of_serials(4, "A", "") == Names{"right_wrong_camera"});
  CHECK(cameras.of_serials(5, "B", "A") == Names{"swapped"});
  CHECK(cameras.of_serials(6, "A", "B").empty());
}

TEST_CASE(
    "cameras that are exchanged from the beginning, where one number is written, are not taken for the right ones") {
  PairingRules with = rules();
  with.serials[0] = "A";
  Cameras cameras(with);
  CHECK(cameras.of_serials(0, "B", "A") == Names{"left_wrong_camera"});
  CHECK(cameras.of_serials(1, "A", "B").empty());
  CHECK(cameras.of_serials(2, "A", "C") == Names{"right_wrong_camera"});
}

TEST_CASE("one camera that gives both images has one serial number") {
  Cameras cameras;
  CHECK(cameras.of_serials(0, "A", "A").empty());
  CHECK(cameras.of_serials(1, "A", "A").empty());
  CHECK(cameras.of_serials(2, "B", "B") == Names{"left_wrong_camera", "right_wrong_camera"});
  CHECK(cameras.of_serials(3, "A", "A").empty());
}

TEST_CASE("an image with holes is none: a fault at once, counted, and its partner has none") {
  Cameras cameras;
  CHECK(cameras.both(0).empty());
  CameraFrame broken = cameras.frame(1);
  broken.image = horopter::Image();
  broken.taken = -5s;  // nothing in it is certain
  cameras.pairing.add(Side::right, broken);
  CHECK(cameras.pairing.check(Clock::time_point(1h), Clock::time_point(1h)).has(MonitorFault::right_lost_packets));
  cameras.add(Side::left, 1);
  CameraFrame next = cameras.frame(2);
  CHECK(cameras.give(cameras.frame(2), next) == Names{"left_unpaired", "right_gap"});
  const auto& counts = cameras.pairing.counts(Side::right);
  CHECK(counts.frames == 3);
  CHECK(counts.dropped == 1);
  CHECK(counts.lost == 0);
  next = cameras.frame(3);
  CHECK(cameras.give(cameras.frame(3), next).empty());
}

TEST_CASE("a pair is as old as its older image, however long that was on its way") {
  Cameras cameras;
  CameraFrame left = cameras.frame(0), right = cameras.frame(0);
  right.arrived += 90ms;
  cameras.pairing.add(Side::left, left);
  cameras.pairing.add(Side::right, right);
  auto pair = cameras.pairing.take();
  REQUIRE(pair);
  CHECK(pair->arrived() == right.arrived);
  CHECK(pair->seen() == left.arrived);
  left = cameras.frame(1), right = cameras.frame(1);
  left.taken_here = left.arrived + 1s;  // of a clock that was set meanwhile
  right.taken_here = right.arrived - 2s;
  cameras.pairing.add(Side::left, left);
  cameras.pairing.add(Side::right, right);
  pair = cameras.pairing.take();
  REQUIRE(pair);
  CHECK(pair->seen() == right.arrived - 2s);
  right = cameras.frame(2);
  left.number = 2;
  left.taken = right.taken;
  left.taken_here = left.arrived + 1s;
  cameras.pairing.add(Side::left, left);
  cameras.pairing.add(Side::right, right);
  CHECK(cameras.pairing.take()->seen() == std::min(left.arrived, right.arrived));
}

TEST_CASE("exposure may change where that is allowed, of the camera of which it is") {
  PairingRules with = rules();
  with.exposure_may_change = {true, false};
  Cameras cameras(with);
  CameraFrame left = cameras.frame(0), right = cameras.frame(0);
  left.exposure_us = right.exposure_us = 1000;
  CHECK(cameras.give(left, right).empty());
  left = right = cameras.frame(1);
  left.exposure_us = right.exposure_us = 2000;
  CHECK(cameras.give(left, right) == Names{"right_exposure"});
  // So may one that the camera does not tell any more, also where it was opened again.
  CHECK(cameras.give(cameras.frame(2), cameras.frame(2)) == Names{"right_exposure"});
  cameras.pairing.reconnected(Side::right);
  CHECK(cameras.give(cameras.frame(3), cameras.frame(3)) == Names{"right_camera_lost", "right_exposure"});
  left = right = cameras.frame(4);
  right.exposure_us = 1000;
  CHECK(cameras.give(left, right).empty());
}

TEST_CASE("pairs that nobody takes: two wait, older ones are dropped, counted, and a fault of the next one") {
  Cameras cameras;
  for (int i = 0; i < 10; ++i) {
    CameraFrame right = cameras.frame(i);
    if (i == 3) right.taken += 2ms;
    cameras.add(Side::left, i);
    cameras.pairing.add(Side::right, std::move(right));
  }
  const auto pair = cameras.pairing.take();
  REQUIRE(pair);
  CHECK(pair->left.number == 8U);
  CHECK(pair->faults == (MonitorFault::left_dropped | MonitorFaults(MonitorFault::right_dropped) | MonitorFault::skew));
  CHECK(cameras.pairing.counts(Side::left).dropped == 8);
  CHECK(cameras.taken().empty());
  CHECK(cameras.both(10).empty());
}

TEST_CASE("a decision that takes as long as two pairs once: none is dropped, and the oldest is judged first") {
  Cameras cameras;
  std::vector<std::uint64_t> judged;
  for (int i = 0; i < 100; ++i) {
    cameras.add(Side::left, i);
    cameras.add(Side::right, i);
    const bool late = i % 10 == 3;  // the decision is not ready for this pair
    for (auto pair = late ? std::nullopt : cameras.pairing.take(); pair; pair = cameras.pairing.take()) {
      CHECK_FALSE(pair->faults.any());
      judged.push_back(*pair->left.number);
    }
  }
  REQUIRE(judged.size() == 100);
  CHECK(std::ranges::is_sorted(judged));
  CHECK(cameras.pairing.counts(Side::right).dropped == 0);
}

TEST_CASE("what came before the machine runs counts as dropped, which is no fault") {
  Cameras cameras;
  for (int i = 0; i < 4; ++i) cameras.add(Side::left, i);
  for (int i = 0; i < 3; ++i) cameras.add(Side::right, i);
  REQUIRE(cameras.pairing.take());
  cameras.pairing.clear(1);
  for (const Side side : {Side::left, Side::right}) {
    CHECK(cameras.pairing.counts(side).frames == cameras.pairing.counts(side).dropped);
  }
  cameras.add(Side::right, 3);  // without its partner, which was forgotten
  CHECK(cameras.taken() == Names{"no pair"});
  CHECK(cameras.both(4) == Names{"right_unpaired"});
}

TEST_CASE("a camera that gives nothing is lost, also one that never gave anything") {
  Cameras cameras;
  const Clock::time_point begin(1h);
  CHECK_FALSE(cameras.pairing.check(begin + 100ms, begin).any());
  CHECK(cameras.pairing.check(begin + 101ms, begin) ==
        (MonitorFault::left_camera_lost | MonitorFaults(MonitorFault::right_camera_lost)));
  for (int i = 0; i < 5; ++i) cameras.add(Side::left, i);
  CHECK(cameras.pairing.check(begin + 200ms, begin) == MonitorFaults(MonitorFault::right_camera_lost));
}

TEST_CASE("images of one camera alone do not pile up") {
  Cameras cameras;
  for (int i = 0; i < 1000; ++i) cameras.add(Side::left, i);
  CHECK_FALSE(cameras.pairing.has_pair());
  CHECK(cameras.pairing.counts(Side::left).dropped >= 990);
  CHECK(cameras.pairing.check(Clock::time_point(1h), {}).has(MonitorFault::left_unpaired));
}

TEST_CASE("a camera that was connected anew begins to count anew, and that is a fault once") {
  Cameras cameras;
  for (int i = 0; i < 5; ++i) REQUIRE(cameras.both(i).empty());
  cameras.pairing.reconnected(Side::right);
  CameraFrame right = cameras.frame(5);
  right.number = 0;
  CHECK(cameras.give(cameras.frame(5), right) == Names{"right_camera_lost"});
  right = cameras.frame(6);
  right.number = 1;
  CHECK(cameras.give(cameras.frame(6), right).empty());
}

TEST_CASE("the names are in the order of the bits, which other programs know") {
  CHECK(MonitorFaults(MonitorFault::left_camera_lost).word() == 1);
  CHECK(MonitorFaults(MonitorFault::right_camera_lost).word() == 1U << 11);
  CHECK(MonitorFaults(MonitorFault::skew).word() == 1U << 22);
  CHECK(MonitorFaults(MonitorFault::starting).names().front() == "starting");
  CHECK(MonitorFaults(MonitorFault::ending).word() == 1U << 29);
  CHECK(of(Side::right, MonitorFault::left_wrong_camera) == MonitorFault::right_wrong_camera);
  const std::set<std::string_view> names(kMonitorFaultNames.begin(), kMonitorFaultNames.end());
  CHECK(names.size() == kMonitorFaultNames.size());
}
