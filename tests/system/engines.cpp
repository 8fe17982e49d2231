// SPDX-License-Identifier: Apache-2.0
// The native engine behind its registers and the co-simulated hardware are one machine to software: the same accesses
// give the same answers, refusals, states, runs and faults.
#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "horopter/base/error.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/machine/native_device.hpp"
#include "horopter/machine/registers.hpp"
#include "horopter/machine/rtl_device.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/map/table_facts.hpp"

namespace horopter {
namespace {

namespace reg = registers;

constexpr int kWidth = 96;
constexpr int kHeight = 48;

Image textured(unsigned seed) {
  std::mt19937 random(seed);
  Image image(kWidth, kHeight);
  int value = 128;
  for (auto& pixel : image.pixels) {
    value = std::clamp(value + static_cast<int>(random() % 81) - 40, 0, 255);
    pixel = static_cast<std::uint8_t>(value);
  }
  return image;
}

/// A right image that agrees with the left one in half of its area.
Image right_of(const Image& left, unsigned seed) {
  Image right = textured(seed + 1000);
  for (int y = 0; y < kHeight - 3; ++y) {
    for (int x = 10; x < kWidth / 2; ++x) right.at(x - 5, y + 3) = left.at(x, y);
  }
  return right;
}

/// With every fact that a table can have.
std::vector<std::uint32_t> table(const MachineProfile& profile, const Matrix3& skin, int width = kWidth,
                                 int height = kHeight, bool small = false) {
  MapTable table = compile_map(HomographySkin(skin), profile, {width, height, Scan::progressive}).table;
  for (int column = 0; small && column < table.columns() / 2; ++column) {  // the left part is around the skin
    for (int row = 0; row < table.rows(); ++row) {
      table.set_control(column, row, hls::table::around_skin_instead(table.control(column, row)));
    }
  }
  hls::table::Facts facts = facts_of(table, profile);
  facts.shifts = {-40, 6};
  const int blocks = ((width + 31) / 32) * ((height + 31) / 32);
  for (int block = 0; block < blocks; ++block) facts.areas.push_back(static_cast<std::uint8_t>(100 + block));
  table.seal(facts);
  return table.words();
}

/// Both machines, fed alike.
class Pair {
 public:
  explicit Pair(const MachineProfile& profile) {
    auto rtl = make_rtl_device(profile);
    rtl_ = dynamic_cast<RtlDevice*>(rtl.get());
    devices_[0] = std::move(rtl);
    devices_[1] = make_native_device(profile);
  }
  RtlDevice& rtl() { return *rtl_; }

  /// Compared, also in being refused.
  std::uint32_t read(std::uint32_t address) {
    std::uint32_t values[2] = {0, 0};
    bool refused[2] = {false, false};
    for (std::size_t i = 0; i < 2; ++i) {
      try {
        values[i] = devices_[i]->read(address);
      } catch (const DeviceError&) {
        refused[i] = true;
      }
    }
    CAPTURE(address);
    CHECK(refused[0] == refused[1]);
    CHECK(values[0] == values[1]);
    return values[0];
  }
  void write(std::uint32_t address, std::uint32_t value) {
    bool refused[2] = {false, false};
    for (std::size_t i = 0; i < 2; ++i) {
      try {
        devices_[i]->write(address, value);
      } catch (const DeviceError&) {
        refused[i] = true;
      }
    }
    CAPTURE(address, value);
    CHECK(refused[0] == refused[1]);
  }
  std::uint32_t upload(std::uint32_t slot, std::uint32_t base, const std::vector<std::uint32_t>& words) {
    write(reg::map_slot::kAddress, slot);
    write(reg::map_base::kAddress, base);
    write(reg::map_control::kAddress, 1);
    for (const auto word : words) write(reg::map_data::kAddress, word);
    rtl().run(100);
    read(reg::map_valid::kAddress);
    read(reg::map_crc::kAddress);
    read(reg::map_extent::kAddress);
    return reg::map_status::kError.get(read(reg::map_status::kAddress));
  }
  /// One frame; states, runs and everything that the registers tell of it.
  Faults frame(const Image& left, const Image& right) {
    FrameStreams streams[2];
    for (std::size_t i = 0; i < 2; ++i) {
      devices_[i]->send(left, right);
      streams[i] = devices_[i]->receive();
    }
    rtl().run(100);
    CHECK(streams[0].states == streams[1].states);
    CHECK(streams[0].runs == streams[1].runs);
    for (const auto address :
         {reg::frame_sequence::kAddress, reg::frame_status::kAddress, reg::frame_table_crc::kAddress,
          reg::frame_skin::kAddress, reg::frame_undecidable::kAddress, reg::frame_unsupervised::kAddress,
          reg::frame_misses::kAddress, reg::faults_cameras::kAddress, reg::faults_machine::kAddress}) {
      read(address);
    }
    for (auto address = reg::frame_agreement::kAddress; address <= reg::frame_contrast_right::kAddress; address += 4) {
      read(address);
    }
    read(reg::frame_hidden::kAddress);
    read(reg::frame_unproven_pixels::kAddress);
    CHECK(rtl().safe_pin() != rtl().unsafe_pin());
    const bool good = reg::frame_status::kSafe.get(read(reg::frame_status::kAddress)) != 0;
    if (!good) CHECK_FALSE(rtl().safe_pin());
    check_safe();
    return {read(reg::frame_faults_cameras::kAddress), read(reg::frame_faults_machine::kAddress)};
  }

  /// What the pins say, and whether a restart is waited for.
  bool check_safe() {
    const bool safe = rtl().safe_pin();
    std::uint32_t waiting[2];
    for (std::size_t i = 0; i < 2; ++i) {
      const std::uint32_t status = devices_[i]->read(reg::status::kAddress);
      CHECK(reg::status::kSafe.get(status) == (safe ? 1U : 0U));
      CHECK(reg::status::kUnsafe.get(status) == (safe ? 0U : 1U));
      waiting[i] = reg::status::kWaiting.get(status);
    }
    CHECK(waiting[0] == waiting[1]);
    return safe;
  }

  /// Clear need not be earned: pictures of noise are no world.
  void start() {
    write(reg::agreement::kAddress, 0);
    write(reg::blind_share::kAddress, 0);
    write(reg::one_camera::kAddress, 0);
    write(reg::still_limit::kAddress, 0);
    start(kWidth, kHeight);
  }
  void start(int width, int height) {
    if (!interlocked) write(reg::interlock::kAddress, reg::interlock::kByItself.put(1));
    write(reg::width::kAddress, static_cast<std::uint32_t>(width));
    write(reg::height::kAddress, static_cast<std::uint32_t>(height));
    write(reg::lookahead::kAddress, 8);
    write(reg::sum_limit::kAddress, 303);
    const auto pixels = static_cast<std::uint32_t>(width * height);
    write(reg::alarm_limit::kAddress, pixels / 20);
    write(reg::black_limit::kAddress, pixels * 95 / 100);
    write(reg::white_limit::kAddress, pixels * 95 / 100);
    write(reg::control::kAddress, 1);
  }

  bool interlocked = false;  ///< as it has been written

 private:
  std::unique_ptr<Device> devices_[2];
  RtlDevice* rtl_ = nullptr;
};

}  // namespace

TEST_CASE("Machines end in any order") {
  auto first = make_rtl_device(find_profile("vga"));
  auto second = make_rtl_device(find_profile("vga"));
  CHECK(first->read(reg::id::kAddress) == second->read(reg::id::kAddress));
  first.reset();
  CHECK(second->read(reg::id::kAddress) != 0);
  second.reset();
}

TEST_CASE("Registers answer alike after reset, and refuse alike") {
  Pair pair(find_profile(GENERATE("vga", "field")));
  for (const auto& r : reg::kRegisters) {
    CAPTURE(r.name);
    pair.read(r.address);
  }
  pair.read(0x7F0);
  pair.write(0x7F0, 1);
  pair.write(reg::id::kAddress, 1);
  pair.read(reg::map_data::kAddress);
  // A profile with one rule keeps it, and has no settings of the other.
  for (const std::uint32_t value : {1U, 0xFFFFFFFFU, 0U}) {
    for (const auto address : {reg::decision::kAddress, reg::compete::kAddress}) {
      pair.write(address, value);
      pair.read(address);
    }
  }
  pair.start();
  pair.write(reg::width::kAddress, 100);
  pair.read(reg::width::kAddress);
  pair.write(reg::control::kAddress, 0);
  pair.write(reg::width::kAddress, 20);
  pair.write(reg::control::kAddress, 1);
  CHECK(reg::status::kBadGeometry.get(pair.read(reg::status::kAddress)) == 1);
}

TEST_CASE("Frames, tables and faults are alike, with gaps and back-pressure on the hardware's side") {
  const MachineProfile& profile = find_profile("vga");
  Pair pair(profile);
  const unsigned pauses = GENERATE(0U, 30U);
  CAPTURE(pauses);
  pair.rtl().set_pauses(pauses, pauses, 7);
  const auto on = table(profile, {1, 0, -5, 0, 1, 3, 0, 0, 1});
  const auto tilted = table(profile, {1.1, 0.02, -8, -0.03, 0.95, 6, 1e-4, 5e-5, 1});
  pair.start();

  const Image left = textured(1);
  CHECK(pair.frame(left, right_of(left, 1)).has(Fault::no_table));
  CHECK(pair.upload(5, 4000, on) == 0);  // before a limit is said: no undecidable pixel is allowed
  pair.write(reg::map_undecidable_limit::kAddress, 0xFFFFFF);
  CHECK(pair.upload(0, 0, on) == 0);
  CHECK(pair.upload(1, 500, tilted) == 0);
  for (unsigned seed = 2; seed < 8; ++seed) {
    pair.write(reg::table_select::kAddress, seed % 2);
    pair.write(reg::decision::kAddress, seed / 2 % 2);
    pair.write(reg::compete::kAddress, reg::compete::kReset + seed % 3);
    const Image image = textured(seed);
    CHECK(pair.frame(image, right_of(image, seed)) == Faults());
  }
  pair.write(reg::decision::kAddress, 0);

  // Refused uploads, each with its fault in the next frame; the one after that is good again.
  auto wrong_crc = on;
  wrong_crc.back() ^= 0x100;
  auto bad_header = on;
  bad_header[1] += 1;
  unsigned seed = 20;
  const auto next = [&] {
    const Image image = textured(++seed);
    return pair.frame(image, right_of(image, seed));
  };
  CHECK(pair.upload(2, 1000, wrong_crc) == 4);
  CHECK(next() == Fault::map_crc);
  CHECK(pair.upload(2, 1000, bad_header) == 2);
  CHECK(next() == Fault::map_crc);
  auto changed = on;
  changed[0] = on[0] - 0x100;  // format 1
  CHECK(pair.upload(2, 1000, changed) == 2);
  next();
  changed = on;
  changed[3] = 4;  // fewer facts than the format has
  CHECK(pair.upload(2, 1000, changed) == 2);
  next();
  changed[3] = on[3] ^ hls::table::areas_known;  // areas that are not known
  CHECK(pair.upload(2, 1000, changed) == 2);
  next();
  changed[3] = (on[3] & ~0xFFFU) | hls::table::fact_words;  // none that are
  CHECK(pair.upload(2, 1000, changed) == 2);
  next();
  // Facts are not judged by the machine, but protected: the count of facts, each of them, the last area.
  for (std::size_t word = 3; word < 11; ++word) {
    CAPTURE(word);
    changed = on;
    changed[word] ^= word == 3 ? 0x20000 : 0x100;
    CHECK(pair.upload(2, 1000, changed) == 4);
    next();
  }
  // Its areas lie in the pool, too.
  const auto words64 = static_cast<std::uint32_t>(hls::table::read(on).pool_words() / 2);
  CHECK(pair.upload(2, 10240 - words64, on) == 0);
  CHECK(pair.upload(2, 10240 - words64 + 1, on) == 3);
  next();
  CHECK(pair.upload(2, 10238, on) == 3);
  CHECK(next() == Fault::map_crc);
  CHECK(pair.upload(15, 1000, on) == 5);
  next();
  CHECK(next() == Faults());
  CHECK(pair.upload(1, 2000, on) == 1);  // in use
  CHECK(next() == Fault::map_busy);
  CHECK(pair.upload(3, 500, on) == 1);  // its region
  CHECK(next() == Fault::map_busy);
  CHECK(next() == Faults());
  CHECK(pair.upload(3, 0, on) == 0);  // over slot 0, which is gone
  pair.write(reg::table_select::kAddress, 0);
  CHECK(next() == Fault::no_table);
  pair.write(reg::table_select::kAddress, 3);
  CHECK(next() == Faults());

  // Images that cannot be images.
  const Image good = textured(90);
  CHECK(pair.frame(Image(kWidth, kHeight, 1), good) == Fault::left_black);
  CHECK(pair.frame(textured(91), Image(kWidth, kHeight, 255)) == Fault::right_white);
  CHECK(pair.frame(Image(kWidth, kHeight, 90), textured(92)) == Fault::left_constant);
  CHECK(pair.frame(textured(93), textured(94)) == Faults());
  CHECK(pair.frame(textured(98), textured(98)) == Fault::identical_images);
  const Image black(kWidth, kHeight, 1);
  CHECK(pair.frame(black, black) == (Faults(Fault::left_black) | Fault::right_black | Fault::identical_images));
  CHECK(pair.frame(textured(93), textured(94)) == Faults());
  CHECK(pair.frame(textured(93), textured(95)) == Fault::left_frozen);
  Image torn = textured(105);
  for (int y = 1; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) torn.at(x, y) = torn.at(x, y - 1) ^ 0x80U;
  CHECK(pair.frame(torn, textured(106)) == Fault::left_torn);
  CHECK(pair.frame(textured(107), torn) == Fault::right_torn);
  // The limit of undecidable pixels is that of each table's upload.
  pair.write(reg::texture_limit::kAddress, 2000);
  CHECK(pair.frame(textured(96), textured(97)) == Faults());
  pair.write(reg::table_select::kAddress, 5);
  CHECK(pair.frame(textured(102), textured(103)) == Fault::too_undecidable);
  pair.write(reg::map_undecidable_limit::kAddress, 100);
  CHECK(pair.upload(6, 5000, on) == 0);
  pair.write(reg::map_undecidable_limit::kAddress, 0xFFFFFF);
  pair.write(reg::table_select::kAddress, 6);
  pair.write(reg::unsupervised_limit::kAddress, 100);
  CHECK(pair.frame(textured(100), textured(101)) == (Faults(Fault::too_undecidable) | Fault::too_unsupervised));
}

TEST_CASE("Both machines wait for a restart, and take it alike") {
  const MachineProfile& profile = find_profile("vga");
  Pair pair(profile);
  const std::uint32_t frames = GENERATE(0U, 1U, 3U);
  const bool allowed = GENERATE(true, false);
  CAPTURE(frames, allowed);
  pair.interlocked = true;
  pair.write(reg::interlock::kAddress, reg::interlock::kByRegister.put(allowed) | reg::interlock::kFrames.put(frames));
  pair.read(reg::interlock::kAddress);
  pair.start();
  pair.write(reg::alarm_limit::kAddress, kWidth * kHeight);
  pair.write(reg::object_limit::kAddress, kWidth * kHeight + 1);
  pair.write(reg::map_undecidable_limit::kAddress, 0xFFFFFF);
  const auto on = table(profile, {1, 0, -5, 0, 1, 3, 0, 0, 1});
  CHECK(pair.upload(0, 0, on) == 0);
  pair.write(reg::table_select::kAddress, 0);
  std::mt19937 random(7);
  unsigned safe = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Image image = textured(seed);
    if (random() % 10 == 0) {
      pair.frame(Image(kWidth, kHeight, 90), image);
    } else {
      pair.frame(image, right_of(image, seed));
    }
    if (random() % 10 == 0) {
      auto wrong_crc = on;
      wrong_crc.back() ^= 0x100;
      CHECK(pair.upload(2, 1000, wrong_crc) == 4);
      CHECK_FALSE(pair.check_safe());
    }
    if (random() % 3 == 0) pair.write(reg::restart::kAddress, reg::kRestartKey ^ (random() % 4 == 0 ? 1U : 0U));
    pair.rtl().run(20);
    safe += pair.check_safe();
  }
  CHECK((safe > 0) == allowed);
  CHECK(safe < 40);
}

TEST_CASE("An alarm by some of the last frames is alike, and a frame with a fault counts as one that shows it") {
  struct Asked {
    std::uint32_t needed, of;
    bool by_object;
  };
  const MachineProfile& profile = find_profile("vga");
  Pair pair(profile);
  const auto [needed, of, by_object] =
      GENERATE(Asked{2, 3, true}, Asked{2, 2, false}, Asked{3, 5, true}, Asked{7, 7, false}, Asked{0, 0, true},
               Asked{3, 1, false}, Asked{1, 7, true});
  CAPTURE(needed, of, by_object);
  pair.write(reg::alarm_frames::kAddress, reg::alarm_frames::kNeeded.put(needed) | reg::alarm_frames::kOf.put(of));
  pair.read(reg::alarm_frames::kAddress);
  pair.start();
  pair.write(reg::alarm_frames::kAddress, 0);  // locked
  CHECK(pair.read(reg::alarm_frames::kAddress) ==
        (reg::alarm_frames::kNeeded.put(needed) | reg::alarm_frames::kOf.put(of)));
  pair.write(reg::alarm_limit::kAddress, by_object ? kWidth * kHeight : kWidth * kHeight / 20);
  pair.write(reg::object_limit::kAddress, by_object ? 100 : kWidth * kHeight + 1);
  pair.write(reg::map_undecidable_limit::kAddress, 0xFFFFFF);
  CHECK(pair.upload(0, 0, table(profile, {1, 0, -5, 0, 1, 3, 0, 0, 1})) == 0);
  pair.write(reg::table_select::kAddress, 0);

  std::mt19937 random(needed * 8 + of);
  std::vector<bool> shown(6, true);  // the newest last
  int alarms = 0, passed = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const bool bad = random() % 12 == 0;
    const bool seen = !bad && random() % 4 < (needed > 3 ? 3 : 1);
    const Image image = textured(seed);
    const Faults faults = bad    ? pair.frame(Image(kWidth, kHeight, 90), textured(100 + seed))
                          : seen ? pair.frame(image, right_of(image, seed))
                                 : pair.frame(image, textured(100 + seed));
    CHECK(faults.any() == bad);
    const auto status = pair.read(reg::frame_status::kAddress);
    if (bad) {
      shown.assign(6, true);
      continue;
    }
    CAPTURE(seed, seen, shown);
    const auto others = static_cast<std::ptrdiff_t>(std::max({needed, of, 1U}) - 1);
    const auto count = std::count(shown.end() - others, shown.end(), true) + (seen ? 1 : 0);
    const bool alarm = seen && count >= needed;
    CHECK((reg::frame_status::kSeen.get(status) != 0) == seen);
    CHECK((reg::frame_status::kAlarm.get(status) != 0) == alarm);
    CHECK((reg::frame_status::kSafe.get(status) != 0) == !alarm);
    alarms += alarm;
    passed += seen && !alarm;
    shown.push_back(seen);
  }
  CHECK(alarms > 0);
  CHECK((passed > 0) == (needed > 1));
}

TEST_CASE("What both cameras show of one world is alike: cells, regions, verdicts, and what is hidden or unproven") {
  const int width = 240;
  const int height = 160;
  const MachineProfile& profile = find_profile("vga");
  Pair pair(profile);
  pair.write(reg::map_undecidable_limit::kAddress, 0xFFFFFF);
  pair.write(reg::agreement::kAddress, reg::agreement::kReset | reg::agreement::kNearerAbove.put(1));
  pair.start(width, height);
  pair.write(reg::hidden::kAddress, reg::hidden::kFrames.put(2));
  // The whole image, a part of it, and one of which the right camera does not see the first columns.
  const auto [small, shift_px] = GENERATE(Catch::Generators::table<bool, int>({{false, 0}, {true, 0}, {false, -37}}));
  CHECK(pair.upload(0, 0, table(profile, Matrix3{1, 0, double(shift_px), 0, 1, 0, 0, 0, 1}, width, height, small)) ==
        0);
  pair.write(reg::table_select::kAddress, 0);
  // Places as wide as a cell; the right camera sees them shifted, further to one side, or nothing of them.
  std::mt19937 random(3);
  const Image world = [&] {
    Image image(width + 64, height + 64);
    std::vector<std::uint8_t> grey(40 * 32);
    for (auto& value : grey) value = static_cast<std::uint8_t>(random());
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) image.at(x, y) = grey[static_cast<std::size_t>(y / 8 * 40 + x / 8)];
    }
    return image;
  }();
  const auto view = [&](int dx, int dy, unsigned noise) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const int grey = world.at(x + 32 + dx, y + 32 + dy) + static_cast<int>(random() % noise);
        image.at(x, y) = static_cast<std::uint8_t>(std::min(grey, 250));
      }
    }
    return image;
  };
  std::set<Fault> found;
  struct Shown {
    int dx, dy;
    unsigned noise;
    bool upside_down = false;
  };
  for (const Shown& shown : {Shown{16, 0, 3},
                             {16, 0, 3},
                             {17, 0, 20},
                             {-16, 0, 3},
                             {-16, 0, 3},
                             {-16, 0, 3},
                             {16, 8, 3},
                             {16, -5, 3},
                             {0, 0, 3, true},
                             {16, 0, 5}}) {
    CAPTURE(shown.dx, shown.dy, shown.noise);
    Image right = view(shown.dx, shown.dy, shown.noise);
    if (shown.upside_down) std::ranges::reverse(right.pixels);
    const Faults faults = pair.frame(view(0, 0, 3), right);
    for (const Fault fault : {Fault::unproven, Fault::disagree, Fault::moved, Fault::hidden}) {
      if (faults.has(fault)) found.insert(fault);
    }
    for (std::uint32_t region = 0; region < 48; ++region) {
      pair.write(reg::region_select::kAddress, region);
      pair.rtl().run(4);
      pair.read(reg::frame_region::kAddress);
    }
  }
  CHECK(found == std::set{Fault::unproven, Fault::disagree, Fault::moved, Fault::hidden});
}

}  // namespace horopter
