// SPDX-License-Identifier: Apache-2.0
// Everything bad that can come in: reported as what it is, never safe, and over with the next good frame; but a broken
// frame with back-pressure is over only when CONTROL.enable has been 0 (test_pairing.cpp: what that is good for).
#include <Vhoropter_machine_vga.h>

#include <algorithm>
#include <array>

#include "machine_bench.hpp"

namespace horopter::tb {
namespace {

using Faults = std::set<std::string>;
using Vga = Machine<Vhoropter_machine_vga>;

constexpr unsigned kWidth = 128;
constexpr unsigned kHeight = 48;
constexpr unsigned kTimeout = 40'000;
constexpr int kShift = -5;

/// A machine that has shown two good frames and is safe.
struct Watch {
  explicit Watch(MachineOptions options = {kWidth, kHeight, 16, false, kTimeout}, std::string_view purpose = "faults")
      : rng{purpose}, machine{"vga", options} {
    machine.upload(0, 0, table);
    machine.select(0);
    machine.settings().alarm_limit =
        static_cast<int>(options.width * options.height);  // no alarm: only faults are looked at here
    machine.settings().frozen_limit = 1;
    machine.write_limits();
    CHECK(machine.safe_was_low());
    good();
    machine.safe_was_low();
    CHECK_FALSE(machine.safe_was_low());
  }

  FramePair scene() { return random_pair(machine.options().width, machine.options().height, kShift, rng); }

  /// Good frames come out as they should, and safe; so do the pins from the second one on.
  void good() {
    for (const bool second : {false, true}) {
      const FramePair pair = scene();
      machine.send(pair);
      const Published p = receive();
      machine.check_frame(p, pair, table);
      CHECK(p.safe());
      if (second) CHECK(p.safe_pin);
    }
  }

  /// With back-pressure a broken frame leaves in doubt which images belong together: frames are processed, but none is
  /// safe, until the cameras begin again and the machine is told so.
  void good_again() {
    const FramePair pair = scene();
    machine.send(pair);
    const Published p = receive();
    CHECK(p.fault_names() == Faults{"skew"});
    CHECK(p.states == machine.expected(pair, table).states);
    CHECK_FALSE(p.safe_pin);
    restart();
    good();
  }
  void restart() {
    machine.write(reg::control::kAddress, 0);
    machine.left().reset();
    machine.right().reset();
    machine.write(reg::control::kAddress, reg::control::kEnable.put(1));
  }

  /// Frames that are published within `clocks`: the faults of all of them; none reads as safe in the end.
  Faults collect(unsigned clocks = 4 * kTimeout) {
    Faults found;
    const auto end = machine.simulation().cycle() + clocks;
    while (machine.simulation().cycle() < end) {
      if (machine.frames_done() > received) {
        const Published p = receive();
        for (const std::string& name : p.fault_names()) found.insert(name);
        if (!p.fault_names().empty()) CHECK_FALSE(p.safe());
      }
      machine.simulation().tick();
    }
    return found;
  }
  Published receive() {
    Published p = machine.receive();
    received = machine.frames_done();
    return p;
  }

  Rng rng;
  Vga machine;
  std::vector<std::uint32_t> table = plane_table(machine.options().width, machine.options().height, kShift);
  unsigned received = 0;
};

/// One damaged frame, then good ones. The damaged one or the one after it carries the fault; neither is safe.
void damaged(Damage damage, bool left, const std::string& fault) {
  CAPTURE(fault);
  Watch watch;
  const FramePair bad = watch.scene();
  watch.machine.send(bad, left ? damage : Damage{}, left ? Damage{} : damage);
  const FramePair after = watch.scene();
  watch.machine.send(after);
  const Published first = watch.receive(), second = watch.receive();
  CHECK(first.fault_names() == Faults{fault});
  CHECK_FALSE(first.safe_pin);
  CHECK(second.fault_names() == Faults{"skew"});
  CHECK(second.states == watch.machine.expected(after, watch.table).states);
  CHECK_FALSE(second.safe_pin);
  watch.good_again();
}

TEST_CASE("short, long and missing lines, missing start of frame: named, not safe, and over", "[faults]") {
  const auto side = GENERATE(std::string("left"), std::string("right"));
  const bool left = side == "left";
  const unsigned row = GENERATE(0U, 20U, kHeight - 1);
  CAPTURE(row);
  damaged({Damage::Kind::short_line, row, 3}, left, side + "_short_line");
  damaged({Damage::Kind::long_line, row, 2}, left, side + "_long_line");
  damaged({Damage::Kind::missing_line, row == 0 ? 1 : row, 1}, left, side + "_missing_line");
}

TEST_CASE("a frame without its start", "[faults]") {
  const auto side = GENERATE(std::string("left"), std::string("right"));
  Watch watch;
  const FramePair bad = watch.scene();
  watch.machine.send(bad, side == "left" ? Damage{Damage::Kind::missing_start} : Damage{},
                     side == "right" ? Damage{Damage::Kind::missing_start} : Damage{});
  const Faults found = watch.collect();
  CHECK(found.contains(side + "_missing_start"));
  CHECK(watch.machine.model().safe_o == 0);
  watch.good_again();
}

// The images after it are compared with those of another moment: there are two frames for one image.
TEST_CASE("an extra start of frame", "[faults]") {
  const auto side = GENERATE(std::string("left"), std::string("right"));
  const Damage damage{Damage::Kind::extra_start, GENERATE(1U, 20U, kHeight - 1)};
  Watch watch;
  watch.machine.send(watch.scene(), side == "left" ? damage : Damage{}, side == "right" ? damage : Damage{});
  for (int i = 0; i < 3; ++i) watch.machine.send(watch.scene());
  for (int i = 0; i < 5; ++i) {
    const Published p = watch.receive();
    CAPTURE(i);
    CHECK(p.fault_names().contains(i < 2 ? side + "_missing_line" : "skew"));
    CHECK_FALSE(p.safe_pin);
  }
  watch.restart();
  watch.good();
}

TEST_CASE("with back-pressure: a camera that begins in the middle of an image", "[faults]") {
  const auto side = GENERATE(std::string("left"), std::string("right"));
  Watch watch;
  watch.restart();
  (side == "left" ? watch.machine.left() : watch.machine.right())
      .send(Image(kWidth, 4, 77), {Damage::Kind::missing_start});
  for (int i = 0; i < 2; ++i) {
    watch.machine.send(watch.scene());
    CAPTURE(i);
    const Published p = watch.receive();
    CHECK(p.fault_names().contains(i == 0 ? side + "_missing_start" : "skew"));
    CHECK_FALSE(p.safe_pin);
  }
  watch.restart();
  watch.good();
}

// Eight lines without a start, a few pixels, then the start of the next frame: around the clock in which the frame that
// stands for the lost one is granted (tb/store aims at that clock).
TEST_CASE("a frame lost but for eight lines, and the next one at once", "[faults]") {
  const auto side = GENERATE(std::string("left"), std::string("right"));
  const unsigned pixels = GENERATE(range(0U, 8U));
  const bool other_first = GENERATE(true, false);  // the other camera has opened the frame, or finds it opened
  CAPTURE(pixels, other_first);
  Watch watch;
  const FramePair lost = watch.scene();
  const FramePair next = watch.scene();
  const bool left = side == "left";
  VideoSource& broken = left ? watch.machine.left() : watch.machine.right();
  VideoSource& whole = left ? watch.machine.right() : watch.machine.left();
  if (!other_first) whole.idle(kWidth * 12);
  broken.send(Image(kWidth, 8, 77), {Damage::Kind::missing_start});
  broken.send(Image(pixels, 1, 77), {Damage::Kind::missing_start});
  broken.send(left ? next.left : next.right);
  whole.send(left ? lost.right : lost.left);
  whole.send(left ? next.right : next.left);
  const Published first = watch.receive();
  CHECK(first.fault_names() == Faults{side + "_missing_start", "skew"});
  CHECK(first.unsupervised == kWidth * kHeight);
  CHECK_FALSE(first.safe_pin);
  const Published second = watch.receive();
  CHECK(second.fault_names() == Faults{"skew"});
  CHECK(second.states == watch.machine.expected(next, watch.table).states);
  CHECK_FALSE(second.safe_pin);
  watch.good_again();
}

TEST_CASE("a camera that falls silent", "[faults]") {
  const auto side = GENERATE(std::string("left"), std::string("right"));
  Watch watch;
  const FramePair pair = watch.scene();
  (side == "left" ? watch.machine.right() : watch.machine.left()).send(side == "left" ? pair.right : pair.left);
  const Faults found = watch.collect();
  CHECK(found.contains(side + "_silent"));
  CHECK_FALSE(found.contains(side == "left" ? "right_silent" : "left_silent"));
  CHECK(watch.machine.model().safe_o == 0);
  // The cause is gone: both cameras run again.
  watch.good_again();
}

TEST_CASE("both cameras silent: late, and no longer safe although nothing happens", "[faults]") {
  Watch watch;
  CHECK(watch.machine.model().safe_o == 1);
  watch.machine.settle(2 * kTimeout);
  CHECK(watch.machine.model().safe_o == 0);
  CHECK(watch.machine.model().unsafe_o == 1);
  CHECK(horopter::Faults(0, watch.machine.read(reg::faults_machine::kAddress)).has(Fault::late));
  watch.collect(100);
  watch.machine.send(watch.scene());
  watch.collect();
  watch.good();
}

TEST_CASE("live: one camera late by a line is skew", "[faults]") {
  MachineOptions options{kWidth, kHeight, 16, true, kTimeout};
  Watch watch{options};
  // A line of blanking each, so that live cameras are slower than the machine.
  const FramePair pair = watch.scene();
  watch.machine.right().idle(kWidth + 40);
  watch.machine.send(pair);
  const Faults found = watch.collect();
  CHECK(found.contains("skew"));
  CHECK(watch.machine.model().safe_o == 0);
  watch.good();
}

TEST_CASE("live: a camera some pixels late is in time, from 64 px to a line late it is skew, again and again",
          "[faults]") {
  const unsigned late_px = GENERATE(0U, 48U, 88U, kWidth - 8);
  const auto side = GENERATE(std::string("left"), std::string("right"));
  CAPTURE(late_px, side);
  Watch watch{{kWidth, kHeight, 16, true, kTimeout}};
  for (int frame = 0; frame < 3; ++frame) {
    (side == "left" ? watch.machine.left() : watch.machine.right()).idle(late_px);
    watch.machine.send(watch.scene());
    const Published p = watch.receive();
    CHECK(p.fault_names() == (late_px < 64 ? Faults{} : Faults{"skew"}));
    CHECK(p.safe_pin == (late_px < 64));
  }
  watch.good();
}

TEST_CASE("live: what cannot be stored is an overflow", "[faults]") {
  MachineOptions options{kWidth, kHeight, 16, true, 8 * kTimeout};
  Watch watch{options};
  watch.machine.states().set_pace(Pace::periodic(1, 40));
  for (int i = 0; i < 6; ++i) watch.machine.send(watch.scene());
  const Faults found = watch.collect(40 * kTimeout);
  CHECK((found.contains("left_overflow") || found.contains("right_overflow")));
  CHECK(watch.machine.model().safe_o == 0);
  watch.machine.states().set_pace({});
  watch.machine.settle(2 * kTimeout);
  watch.collect(100);
  watch.good();
}

TEST_CASE("a map that wants rows the store does not hold", "[faults]") {
  Watch watch;
  // 30 rows below the output row, but only LOOKAHEAD = 16 rows have arrived.
  watch.machine.upload(1, 500, plane_table(kWidth, kHeight, 0, 30));
  watch.machine.select(1);
  watch.machine.send(watch.scene());
  const Published p = watch.receive();
  CHECK(p.fault_names() == Faults{"store_miss"});
  CHECK_FALSE(p.safe_pin);
  watch.machine.select(0);
  watch.good();
}

TEST_CASE("tables: none, of a wrong CRC, of another size, into one in use", "[faults]") {
  Watch watch;
  SECTION("none selected") {
    watch.machine.select(15);
    watch.machine.send(watch.scene());
    const Published p = watch.receive();
    CHECK(p.fault_names() == Faults{"no_table"});
    CHECK(p.unsupervised == kWidth * kHeight);
    CHECK_FALSE(p.safe_pin);
  }
  SECTION("a wrong CRC") {
    auto words = plane_table(kWidth, kHeight, -2);
    words[7] ^= 1U << 9;
    watch.machine.upload(4, 600, words);
    CHECK(watch.machine.upload_error() == 4);
    CHECK((watch.machine.read(reg::map_valid::kAddress) >> 4 & 1U) == 0);
    watch.machine.send(watch.scene());
    const Published p = watch.receive();
    CHECK(p.fault_names() == Faults{"map_crc"});
    CHECK_FALSE(p.safe_pin);
    watch.machine.select(4);
    watch.machine.send(watch.scene());
    const Published without = watch.receive();
    CHECK(without.fault_names() == Faults{"no_table"});
    CHECK(reg::frame_status::kSlot.get(without.status) == reg::kNoSlot);
    CHECK(reg::map_status::kActiveSlot.get(watch.machine.read(reg::map_status::kAddress)) == 4);
  }
  SECTION("of another size") {
    watch.machine.upload(4, 600, plane_table(kWidth, kHeight + 16, -2));
    watch.machine.select(4);
    watch.machine.send(watch.scene());
    CHECK(watch.receive().fault_names() == Faults{"no_table"});
  }
  SECTION("into the slot in use") {
    const FramePair pair = watch.scene();
    watch.machine.send(pair);
    watch.machine.settle(kWidth * 20);
    watch.machine.upload(0, 0, plane_table(kWidth, kHeight, -2));
    CHECK(watch.machine.upload_error() == 1);
    const Published p = watch.receive();
    CHECK(p.fault_names() == Faults{"map_busy"});
    CHECK_FALSE(p.safe_pin);
    // The table in use is as it was.
    CHECK(p.states == watch.machine.expected(pair, watch.table).states);
  }
  watch.machine.select(0);
  watch.good();
}

TEST_CASE("images that show nothing", "[faults]") {
  const auto side = GENERATE(std::string("left"), std::string("right"));
  const auto [kind, grey] = GENERATE(std::pair{std::string("black"), 1}, std::pair{std::string("white"), 254},
                                     std::pair{std::string("constant"), 120});
  Watch watch;
  FramePair pair = watch.scene();
  Image& image = side == "left" ? pair.left : pair.right;
  for (std::uint8_t& pixel : image.pixels)
    pixel = static_cast<std::uint8_t>(grey + static_cast<int>(watch.rng.below(2)));
  watch.machine.send(pair);
  const Published p = watch.receive();
  CHECK(p.fault_names() == Faults{side + "_" + kind});
  CHECK_FALSE(p.safe_pin);
  watch.good();
}

TEST_CASE("a frozen camera: the same frame again, noise and all", "[faults]") {
  const auto side = GENERATE(std::string("left"), std::string("right"));
  Watch watch;
  const FramePair first = watch.scene();
  watch.machine.send(first);
  watch.machine.check(watch.receive(), first, watch.table);
  for (int again = 0; again < 3; ++again) {
    FramePair second = watch.scene();
    (side == "left" ? second.left : second.right) = side == "left" ? first.left : first.right;
    watch.machine.send(second);
    const Published p = watch.receive();
    CHECK(p.fault_names() == Faults{side + "_frozen"});
    CHECK_FALSE(p.safe_pin);
  }
  watch.good();
}

TEST_CASE("a frozen camera: old frames with fresh noise, one again and again or two in turn", "[faults]") {
  const auto side = GENERATE(std::string("left"), std::string("right"));
  const unsigned old_frames = GENERATE(1U, 2U);
  const unsigned width = 160, height = 112;  // so many cells that the check says something
  Watch watch({width, height, 16, false, 4 * kTimeout});
  watch.machine.settings().still_limit = 3;
  watch.machine.write_limits();
  const std::array<Image, 2> old{textured_image(width, height, watch.rng), textured_image(width, height, watch.rng)};
  for (unsigned frame = 0; frame < old_frames + 4; ++frame) {
    CAPTURE(side, old_frames, frame);
    FramePair pair = watch.scene();
    Image& image = side == "left" ? pair.left : pair.right;
    image = old[frame % old_frames];
    for (std::uint8_t& pixel : image.pixels) {
      pixel = static_cast<std::uint8_t>(std::clamp(pixel + static_cast<int>(watch.rng.between(-8, 8)), 0, 255));
    }
    watch.machine.send(pair);
    const Published p = watch.receive();
    const bool found = frame >= old_frames + 2;
    CHECK(p.fault_names() == (found ? Faults{side + "_frozen"} : Faults{}));
    CHECK(p.safe_pin == !found);
    const native::FrameResult e = watch.machine.expected(pair, watch.table);
    CHECK((side == "left" ? e.left : e.right).frozen == found);
  }
  watch.good();
}

TEST_CASE("one camera twice: identical images, also when one of them comes later", "[faults]") {
  const unsigned later = GENERATE(0U, 40U, 2 * kWidth * kHeight);
  const bool left_first = GENERATE(true, false);
  CAPTURE(later, left_first);
  Watch watch;
  FramePair pair = watch.scene();
  pair.right = pair.left;
  (left_first ? watch.machine.right() : watch.machine.left()).idle(later);
  watch.machine.send(pair);
  const FramePair after = watch.scene();
  watch.machine.send(after);
  const Published p = watch.receive();
  CHECK(p.fault_names() == Faults{"identical_images"});
  CHECK_FALSE(p.safe());
  CHECK_FALSE(p.safe_pin);
  watch.machine.check(watch.receive(), after, watch.table);
  // The left image is the right one of the frame before: that is not the same frame.
  watch.machine.send({after.right, watch.scene().right});
  CHECK(watch.receive().fault_names() == Faults{});
}

TEST_CASE("one camera twice, with noise, gain and offset between, also when one of them comes later", "[faults]") {
  const unsigned later = GENERATE(0U, 40U, 2 * kWidth * kHeight);
  const bool left_first = GENERATE(true, false);
  CAPTURE(later, left_first);
  Watch watch;
  watch.machine.settings().one_camera_segments = 6;
  watch.machine.write_limits();
  const auto again = [&](const Image& image, int shift) {
    Image other = image;
    for (unsigned y = 0; y < kHeight; ++y) {
      for (unsigned x = 0; x < kWidth; ++x) {
        const int from = image.at(std::min(x + static_cast<unsigned>(shift), kWidth - 1), y);
        other.at(x, y) = static_cast<std::uint8_t>(20 + from * 3 / 4 + static_cast<int>(watch.rng.below(7)));
      }
    }
    return other;
  };
  const Image seen = textured_image(kWidth, kHeight, watch.rng);
  (left_first ? watch.machine.right() : watch.machine.left()).idle(later);
  watch.machine.send({seen, again(seen, 0)});
  const FramePair after = watch.scene();
  watch.machine.send(after);
  const Published p = watch.receive();
  CHECK(p.fault_names() == Faults{"one_camera"});
  CHECK_FALSE(p.safe());
  CHECK_FALSE(p.safe_pin);
  watch.machine.check(watch.receive(), after, watch.table);
  // A shift of 2 px is another camera's view.
  const Image other = textured_image(kWidth, kHeight, watch.rng);
  watch.machine.send({other, again(other, 2)});
  CHECK(watch.receive().fault_names() == Faults{});
  watch.machine.settings().one_camera_segments = 0;
  watch.machine.write_limits();
  const Image unchecked = textured_image(kWidth, kHeight, watch.rng);
  watch.machine.send({unchecked, again(unchecked, 0)});
  CHECK(watch.receive().fault_names() == Faults{});
}

TEST_CASE("a camera that sees nothing but fog: blind", "[faults]") {
  const auto side = GENERATE(std::string("left"), std::string("right"));
  Watch watch;
  watch.machine.settings().blind_share = native::Settings{}.blind_share;
  watch.machine.write_limits();
  FramePair pair = watch.scene();
  Image& image = side == "left" ? pair.left : pair.right;
  image = textured_image(kWidth, kHeight, watch.rng);
  for (std::uint8_t& pixel : image.pixels)
    pixel = static_cast<std::uint8_t>(pixel / 8 + 96 + static_cast<int>(watch.rng.below(20)));
  watch.machine.send(pair);
  const Published p = watch.receive();
  CHECK(p.fault_names() == Faults{side + "_blind"});
  CHECK_FALSE(p.safe_pin);
  watch.good();
  // As many cells as the native engine counts, whatever the limits.
  const auto names = [](const native::FrameResult& e) {
    Faults faults;
    if (e.left.blind) faults.insert("left_blind");
    if (e.right.blind) faults.insert("right_blind");
    if (e.one_camera) faults.insert("one_camera");
    return faults;
  };
  std::set<Faults> found;
  for (int frame = 0; frame < 24; ++frame) {
    watch.machine.settings().blind_step = static_cast<int>(watch.rng.between(10, 30));
    watch.machine.settings().blind_share = static_cast<int>(watch.rng.between(50, 150));
    watch.machine.settings().one_camera_segments = static_cast<int>(watch.rng.between(1, 10));
    watch.machine.write_limits();
    FramePair next = watch.scene();
    if (frame % 2 == 0) {
      next.right = next.left;
      next.right.pixels[frame] ^= 1U;
    }
    watch.machine.send(next);
    const Faults expected = names(watch.machine.expected(next, watch.table));
    found.insert(expected);
    CHECK(watch.receive().fault_names() == expected);
  }
  CHECK(found.size() > 4);
}

TEST_CASE("too much that cannot be decided or is not supervised", "[faults]") {
  Watch watch;
  auto& settings = watch.machine.settings();
  const native::Settings usual = settings;
  const bool undecidable = GENERATE(true, false);
  (undecidable ? settings.undecidable_limit : settings.unsupervised_limit) = 5;
  watch.machine.write_limits();
  watch.machine.upload(1, 500, watch.table);  // with the limit of undecidable pixels
  watch.machine.select(1);
  watch.machine.send(watch.scene());
  const Published p = watch.receive();
  CHECK(p.fault_names() == Faults{undecidable ? "too_undecidable" : "too_unsupervised"});
  CHECK_FALSE(p.safe_pin);
  settings = usual;
  watch.machine.write_limits();
  watch.machine.select(0);
  watch.good();
}

TEST_CASE("more unsupervised pixels than the table says that there are is a fault", "[faults]") {
  Watch watch;
  watch.machine.send(watch.scene());
  const unsigned there_are = watch.receive().unsupervised;
  CHECK(there_are > 0);
  const unsigned hidden = GENERATE(0U, 1U);
  watch.table.at(hls::table::header_words + 2) = there_are - hidden;
  watch.table.at(hls::table::header_words) = kWidth * kHeight - (there_are - hidden);
  watch.table.back() = crc32_words(std::span(watch.table).first(watch.table.size() - 1));
  watch.machine.upload(1, 500, watch.table);
  watch.machine.select(1);
  watch.machine.send(watch.scene());
  CHECK(watch.receive().fault_names() == (hidden == 0 ? Faults{} : Faults{"too_unsupervised"}));
}

TEST_CASE("an alarm is not safe, nor is the first frame after it", "[faults]") {
  Watch watch;
  watch.machine.settings().alarm_limit = 3;
  watch.machine.write_limits();
  const FramePair pair = watch.scene();
  watch.machine.send(pair);
  const Published p = watch.receive();
  watch.machine.check(p, pair, watch.table);
  CHECK(p.alarm());
  CHECK_FALSE(p.safe_pin);
  watch.machine.settings().alarm_limit = static_cast<int>(kWidth * kHeight);
  watch.machine.write_limits();
  for (const bool second : {false, true}) {
    const FramePair empty = watch.scene();
    watch.machine.send(empty);
    const Published after = watch.receive();
    watch.machine.check(after, empty, watch.table);
    CHECK(after.safe());
    CHECK(after.safe_pin == second);
  }
}

TEST_CASE("safe_o is low from reset until the second good frame, and after a reset again", "[faults]") {
  Watch watch;
  auto& model = watch.machine.model();
  CHECK(model.safe_o == 1);
  model.rst_ni = 0;
  for (const int clock : {0, 1}) {
    model.clk_i = clock;
    model.eval();
  }
  CHECK(model.safe_o == 0);  // with the first clock of the reset
  CHECK(model.unsafe_o == 1);
  watch.machine.simulation().reset();
  CHECK(watch.machine.model().safe_o == 0);
  CHECK(watch.machine.model().unsafe_o == 1);
  CHECK_FALSE(watch.machine.pins_ever_equal());
}

TEST_CASE("a reset of one clock leaves no beat behind", "[faults]") {
  Watch watch;
  auto& machine = watch.machine;
  auto& model = machine.model();
  machine.states().set_pace(Pace::periodic(0, 1));
  machine.runs().set_pace(Pace::periodic(0, 1));
  machine.send(watch.scene());
  machine.simulation().run_until([&] { return model.m_axis_state_tvalid && model.m_axis_runs_tvalid; }, 100'000,
                                 "a state and a run");
  machine.simulation().reset(1);
  for (int clock = 0; clock < 100; ++clock) {
    CAPTURE(clock);
    REQUIRE(model.m_axis_state_tvalid == 0);
    REQUIRE(model.m_axis_runs_tvalid == 0);
    machine.simulation().run(1);
  }
}

TEST_CASE("a reset of one clock leaves no fault and no event behind", "[faults]") {
  // At every clock around that in which a fault of the first line is found.
  for (unsigned clock = kWidth - 20; clock < kWidth + 40; ++clock) {
    CAPTURE(clock);
    Watch watch;
    auto& machine = watch.machine;
    machine.send(watch.scene(), {Damage::Kind::short_line, 0, 3});
    machine.simulation().run(clock);
    machine.simulation().reset(1);
    machine.settle(10);
    CHECK(machine.read(reg::faults_cameras::kAddress) == 0);
    CHECK(machine.read(reg::faults_machine::kAddress) == 0);
    CHECK(machine.read(reg::irq_status::kAddress) == 0);
  }
}

/// A clock in which `host` alone does something.
void clock_of(Vga& machine, AxilMaster<std::uint16_t>& host) {
  host.drive();
  machine.model().clk_i = 0;
  machine.model().eval();
  host.sample();
  machine.model().clk_i = 1;
  machine.model().eval();
}

/// One access to the registers, with the strobes of a master that writes bytes.
AxilMaster<std::uint16_t>::Answer access(Vga& machine, const AxilMaster<std::uint16_t>::Access& access) {
  AxilMaster<std::uint16_t> host{HOROPTER_TB_AXIL(machine.model(), s_axil), 1};
  host.post(access);
  while (!host.idle()) clock_of(machine, host);
  host.reset();
  return host.answer();
}

TEST_CASE("a reset of one clock leaves no write behind", "[faults]") {
  Watch watch;
  auto& machine = watch.machine;
  auto& model = machine.model();
  machine.simulation().reset(1);
  const std::uint32_t after_reset = machine.read(reg::timeout::kAddress);
  for (unsigned clocks = 0; clocks < 10; ++clocks) {
    CAPTURE(clocks);
    AxilMaster<std::uint16_t> host{HOROPTER_TB_AXIL(model, s_axil), 1};
    host.post({true, reg::timeout::kAddress, ~after_reset});
    for (unsigned i = 0; i < clocks; ++i) clock_of(machine, host);
    host.reset();
    host.drive();
    machine.simulation().reset(1);
    CHECK(machine.read(reg::timeout::kAddress) == after_reset);
  }
}

TEST_CASE("the registers refuse what they must", "[faults]") {
  Watch watch;
  // Locked while running, and addresses that do not exist: an error answer, nothing changes.
  for (const std::uint32_t address :
       {reg::width::kAddress, reg::interlock::kAddress, std::uint32_t{0x7FC}, reg::id::kAddress}) {
    CAPTURE(address);
    CHECK(access(watch.machine, {true, address, 64}).response == 2);
  }
  CHECK(watch.machine.read(reg::width::kAddress) == kWidth);
}

TEST_CASE("bytes of a register, at their own addresses", "[faults]") {
  Watch watch;
  auto& machine = watch.machine;
  machine.write(reg::timeout::kAddress, 0x00654321);
  for (const std::uint32_t byte : {0U, 1U, 2U}) {
    CAPTURE(byte);
    const std::uint32_t address = reg::timeout::kAddress + byte;
    CHECK(access(machine, {true, address, 0xA5A5A5A5, static_cast<std::uint8_t>(1U << byte)}).response == 0);
    const auto answer = access(machine, {false, address});
    CHECK(answer.response == 0);
    CHECK(answer.data == (0x654321U & 0xFFFFFF00U << 8 * byte | (0xA5A5A5A5U & ~(0xFFFFFF00U << 8 * byte))));
  }
}

TEST_CASE("CONTROL.enable = 0 lets the beats end that are offered", "[faults]") {
  Watch watch;
  auto& machine = watch.machine;
  machine.states().set_pace(Pace::periodic(0, 1));
  machine.runs().set_pace(Pace::periodic(0, 1));
  machine.send(watch.scene());
  machine.settle();
  REQUIRE(machine.model().m_axis_state_tvalid == 1);
  REQUIRE(machine.model().m_axis_runs_tvalid == 1);
  machine.write(reg::control::kAddress, 0);
  machine.settle(100);  // the sinks watch what is offered to them
  CHECK(machine.model().m_axis_state_tvalid == 1);
  CHECK(machine.model().m_axis_runs_tvalid == 1);
  if (GENERATE(false, true)) watch.restart();  // a new frame waits for the old beat
  machine.states().set_pace({});
  machine.runs().set_pace({});
  machine.settle(100);
  CHECK(machine.states().take().size() == 1);
  CHECK(machine.runs().take().size() == 1);
  watch.restart();
  watch.good();
}

}  // namespace
}  // namespace horopter::tb
