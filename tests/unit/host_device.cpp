// SPDX-License-Identifier: Apache-2.0
// Devices and the driver: the native engine behind registers, faults, uploads, the memory-mapped device.
#include <sys/stat.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>
#include <set>
#include <thread>
#include <tuple>

#include "horopter/base/crc32.hpp"
#include "horopter/base/error.hpp"
#include "horopter/machine/configuration.hpp"
#include "horopter/machine/inspection.hpp"
#include "horopter/machine/loader.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/machine/moving_supervisor.hpp"
#include "horopter/machine/native_device.hpp"
#include "horopter/machine/regions.hpp"
#include "horopter/machine/registers.hpp"
#include "horopter/machine/report.hpp"
#include "horopter/machine/serial_link.hpp"
#include "horopter/machine/uio_device.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/map/support.hpp"
#include "host_temporary.hpp"

namespace horopter {
namespace {

namespace reg = registers;

/// Noise smoothed a little, so that directions mean something; another seed is another image.
Image textured(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image noise(width, height);
  for (auto& pixel : noise.pixels) pixel = static_cast<std::uint8_t>(40 + random() % 170);
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      int sum = 0;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          sum += noise.at(std::clamp(x + dx, 0, width - 1), std::clamp(y + dy, 0, height - 1));
        }
      }
      image.at(x, y) = static_cast<std::uint8_t>(sum / 9);
    }
  }
  return image;
}

/// Each pixel a block of so many px.
Image enlarged(const Image& small, int block_px) {
  Image image(small.width * block_px, small.height * block_px);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) image.at(x, y) = small.at(x / block_px, y / block_px);
  }
  return image;
}

/// The right image whose pixel (x + dx, y + dy) is the left pixel (x, y).
Image moved(const Image& left, int dx, int dy) {
  Image right = textured(left.width, left.height, 999);
  for (int y = 0; y < left.height; ++y) {
    for (int x = 0; x < left.width; ++x) {
      if (x + dx >= 0 && x + dx < left.width && y + dy >= 0 && y + dy < left.height)
        right.at(x + dx, y + dy) = left.at(x, y);
    }
  }
  return right;
}

MapTable shift_table(const MachineProfile& profile, int width, int height, double dx, double dy) {
  return compile_map(HomographySkin({1, 0, dx, 0, 1, dy, 0, 0, 1}), profile, {width, height, Scan::progressive}).table;
}

constexpr int kWidth = 96;
constexpr int kHeight = 64;

/// Small images have too few cells to earn clear by.

/// A monitor of small frames with two tables: slot 0 on the object, slot 1 beside it.
struct Small {
  explicit Small(const Settings& settings = Settings{}.without_proof())
      : monitor(make_native_device(find_profile("vga")), find_profile("vga"), settings) {
    monitor.start(kWidth, kHeight, 8);
    monitor.upload(0, shift_table(profile, kWidth, kHeight, -6, 2));
    monitor.upload(1, shift_table(profile, kWidth, kHeight, 5, 2));
    monitor.select(0);
  }
  FrameResult frame(unsigned seed) {
    const Image left = textured(kWidth, kHeight, seed);
    return monitor.process(left, moved(left, -6, 2));
  }

  const MachineProfile& profile = find_profile("vga");
  Monitor monitor;
};

/// What MAP_STATUS says of it.
std::uint32_t upload_words(Device& device, std::uint32_t slot, std::uint32_t base_word64,
                           const std::vector<std::uint32_t>& words) {
  device.write(reg::map_slot::kAddress, slot);
  device.write(reg::map_base::kAddress, base_word64);
  device.write(reg::map_control::kAddress, 1);
  for (const auto word : words) device.write(reg::map_data::kAddress, word);
  return reg::map_status::kError.get(device.read(reg::map_status::kAddress));
}

}  // namespace

TEST_CASE("What lies on the skin is in the skin, and beside it is not") {
  Small small;
  const auto on = small.frame(1);
  CHECK(on.alarm);
  CHECK(!on.safe);
  CHECK(!on.faults.any());
  CHECK(on.table == 0);
  CHECK(on.sequence == 1);
  CHECK(on.skin_pixels > 8 * on.undecidable_pixels);
  CHECK(on.skin_pixels + on.undecidable_pixels + on.unsupervised_pixels > kWidth * kHeight * 95 / 100);
  small.monitor.select(1);
  const auto beside = small.frame(2);
  CHECK(!beside.alarm);
  CHECK(beside.safe);
  CHECK(beside.table == 1);
  CHECK(beside.table_crc != on.table_crc);
  CHECK(beside.skin_pixels < kWidth * kHeight / 50);
}

TEST_CASE("The supervisor makes two fields of an image for the profile field") {
  const MachineProfile& profile = find_profile("field");
  SkinFile skin;
  skin.path = "skin";
  skin.skin = std::make_unique<HomographySkin>(Matrix3{1, 0, -8, 0, 1, 4, 0, 0, 1});
  const auto maps = compile_maps(skin, profile, 160, 96);
  Supervisor supervisor(make_native_device(profile), profile, maps, Settings{}.without_proof());
  const Image left = textured(160, 96, 5);
  const auto results = supervisor.process(left, moved(left, -8, 4));
  REQUIRE(results.size() == 2);
  CHECK(results[0].scan == Scan::even_field);
  CHECK(results[1].scan == Scan::odd_field);
  for (const auto& result : results) {
    CHECK(result.states.width == 80);
    CHECK(result.states.height == 48);
    CHECK(result.alarm);
    CHECK(!result.faults.any());
  }
  CHECK(results[0].table_crc != 0);
}

TEST_CASE("What half of the light would leave undecidable is taught, too, and less light is then no alarm") {
  // Weak texture beside the skin.
  unsigned seed = 100;
  const auto frame_of = [&](Small& small, double contrast) {
    Image left = textured(kWidth, kHeight, ++seed);
    Image right = moved(left, -6, 2);
    for (Image* image : {&left, &right}) {
      for (auto& pixel : image->pixels) pixel = static_cast<std::uint8_t>(std::lround(120 + contrast * (pixel - 120)));
    }
    return small.monitor.process(left, right);
  };
  constexpr double kContrast = 0.75, kLess = 0.45;
  const bool dim = GENERATE(false, true);
  CAPTURE(dim);
  Settings settings = Settings{}.without_proof();
  settings.blind = {.watch = true, .teach = true, .margin = 8, .dim = dim};
  settings.object_px = 20;
  Small small(settings);
  small.monitor.select(1);
  constexpr int kPixels = 3212;  // that are supervised
  constexpr int kFrames = 6;
  for (int i = 0; i < kFrames; ++i) {
    CAPTURE(i);
    const auto taught = frame_of(small, kContrast);
    // Every second one, from the first on; it is never too undecidable, which would undo what is taught.
    const bool is_dim = dim && i % 2 == 0;
    CHECK(taught.faults.names() == std::vector<std::string>{"teaching"});
    CHECK((taught.undecidable_pixels > kPixels * 85 / 100) == is_dim);
    CHECK((taught.undecidable_pixels < kPixels * 20 / 100) == !is_dim);
  }
  CHECK(small.monitor.blind_watch().taught() == kFrames);
  CHECK(small.monitor.device().read(reg::taught::kAddress) + 1 == kFrames);
  small.monitor.teach(false);
  const auto as_before = frame_of(small, kContrast);
  CHECK(as_before.safe);
  CHECK(as_before.undecidable_pixels < kPixels * 20 / 100);
  const auto darker = frame_of(small, kLess);
  CHECK(darker.undecidable_pixels > kPixels / 3);
  CHECK(darker.alarm == !dim);
  // What can be decided is seen in the skin as ever.
  small.monitor.select(0);
  CHECK(frame_of(small, kContrast).alarm);
  // Taught again it begins with a dim one again.
  small.monitor.teach(true);
  CHECK((frame_of(small, kContrast).undecidable_pixels > kPixels * 85 / 100) == dim);
}

TEST_CASE("A teaching that is broken off leaves nothing taught, of neither field") {
  const std::string name = GENERATE("vga", "field");
  CAPTURE(name);
  const MachineProfile& profile = find_profile(name);
  SkinFile skin;
  skin.path = "skin";
  skin.skin = std::make_unique<HomographySkin>(Matrix3{1, 0, -8, 0, 1, 4, 0, 0, 1});
  Settings settings = Settings{}.without_proof();
  settings.blind = {.watch = true, .teach = true};
  Supervisor supervisor(make_native_device(profile), profile, compile_maps(skin, profile, 160, 96), settings);
  Monitor& monitor = supervisor.monitor();
  unsigned seed = 200;
  const auto judge = [&] {
    const Image left = textured(160, 96, ++seed);
    return supervisor.process(left, moved(left, 6, 4));  // beside the skin
  };
  for (int i = 0; i < 3; ++i) {
    for (const auto& result : judge()) CHECK(result.faults.names() == std::vector<std::string>{"teaching"});
  }
  CHECK(monitor.blind_watch().taught() == (name == "vga" ? 3 : 6));
  monitor.break_off_teaching();
  const auto last = judge();
  CHECK(last.front().faults.has(Fault::teaching));
  CHECK(last.front().faults.has(Fault::map_busy));
  CHECK(last.back().faults.has(Fault::teaching) == (name == "vga"));
  for (const auto& result : judge()) CHECK_FALSE(result.faults.any());
  CHECK(monitor.blind_watch().taught() == 0);
  CHECK(reg::status::kTaught.get(monitor.device().read(reg::status::kAddress)) == 0);
  // With nothing to forget it ends at once.
  monitor.teach(true);
  monitor.break_off_teaching();
  for (const auto& result : judge()) CHECK_FALSE(result.faults.any());
}

TEST_CASE("Images that cannot be images are faults, each its own, and the next good frame is good") {
  Small small;
  small.monitor.select(1);
  Image left = textured(kWidth, kHeight, 11);
  Image right = moved(left, -6, 2);
  std::vector<std::string> expected;
  SECTION("black left") {
    left = Image(kWidth, kHeight, 2);
    expected = {"left_black"};
  }
  SECTION("white right") {
    right = Image(kWidth, kHeight, 254);
    expected = {"right_white"};
  }
  SECTION("constant right") {
    right = Image(kWidth, kHeight, 100);
    expected = {"right_constant"};
  }
  SECTION("frozen left") {
    small.monitor.process(left, right);
    right = textured(kWidth, kHeight, 12);
    expected = {"left_frozen"};
  }
  const auto alternate = [](Image& image) {  // rows of two moments in turn
    for (int y = 1; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) image.at(x, y) = image.at(x, y - 1) ^ 0x80U;
  };
  SECTION("torn left") {
    alternate(left);
    expected = {"left_torn"};
  }
  SECTION("torn right") {
    alternate(right);
    expected = {"right_torn"};
  }
  SECTION("frozen both") {
    small.monitor.process(left, right);
    expected = {"left_frozen", "right_frozen"};
  }
  const auto bad = small.monitor.process(left, right);
  auto names = bad.faults.names();
  std::erase(names, "too_undecidable");  // a black image is that, too
  CHECK(names == expected);
  CHECK(!bad.safe);
  const auto good = small.frame(13);
  CHECK(!good.faults.any());
  CHECK(good.safe);
}

TEST_CASE("Without a table everything is unsupervised, and that is a fault") {
  Small small;
  small.monitor.select(15);
  const auto none = small.frame(1);
  CHECK(none.unsupervised_pixels == kWidth * kHeight);
  CHECK(none.table == 15);
  CHECK(none.table_crc == 0);
  CHECK(none.faults.names() == std::vector<std::string>{"no_table", "too_unsupervised"});
  CHECK(!none.safe);
  small.monitor.select(7);  // never uploaded
  const auto empty = small.frame(2);
  CHECK(empty.faults.names().front() == "no_table");
  CHECK(empty.table == 15);
  // As the hardware says it (tb/top/test_faults.cpp).
  CHECK(reg::map_status::kActiveSlot.get(small.monitor.device().read(reg::map_status::kAddress)) == 7);
}

TEST_CASE("Limits on what cannot be judged are faults") {
  Settings settings = Settings{}.without_proof();
  settings.undecidable_percent = 50;
  settings.texture = 255;
  settings.unsupervised_percent = 10;
  Small small(settings);
  const auto result = small.frame(1);
  CHECK(result.faults.names() == std::vector<std::string>{"too_undecidable", "too_unsupervised"});
}

TEST_CASE("The limit on undecidable pixels is a share of what the rule can judge in the table, to the pixel") {
  const auto [name, decision] = GENERATE(table<std::string, Decision>(
      {{"field", Decision::thesis}, {"vga", Decision::thesis}, {"vga", Decision::compete}, {"hd", Decision::compete}}));
  const MachineProfile& profile = find_profile(name);
  const int holes = GENERATE(0, 12, 4, 1);  // of 16 control points
  CAPTURE(name, name_of(decision), holes);
  constexpr int kWide = 166;
  MapTable table({kWide, kHeight, Scan::progressive}, 4, 4);
  std::mt19937 random(3);
  for (int row = 0; row < table.rows(); ++row) {
    for (int column = 0; column < table.columns(); ++column) {
      const bool hole = holes == 1 ? column > 1 : static_cast<int>(random() % 64) < holes;
      table.set_control(column, row,
                        hole ? MapTable::kUnmapped : MapTable::encode(Point{column * 16.0 - 5, row * 16.0}));
    }
  }
  table.seal(facts_of(table, profile));
  Settings settings = Settings{}.without_proof();
  settings.decision = decision;
  settings.unsupervised_percent = 100;
  const bool large_cells = profile.cell() == 16;  // in which this texture averages out
  if (!large_cells) settings.blind_share = Settings{}.blind_share;
  Monitor monitor(make_native_device(profile), profile, settings);
  monitor.start(kWide, kHeight, 8);
  monitor.upload(0, table);
  monitor.select(0);
  const std::int64_t supported = supported_pixels(table, decision);
  CHECK(monitor.device().read(reg::map_undecidable_limit::kAddress) ==
        limit_of(Settings{}.undecidable_percent, static_cast<double>(supported)));
  const Image left = textured(kWide, kHeight, 1);
  const auto usual = monitor.process(left, moved(left, -5, 0));
  CHECK(static_cast<std::int64_t>(usual.states.pixels.size()) - usual.unsupervised_pixels == supported);
  CHECK(!usual.faults.any());
  // Two cameras in the dark: noise of their own. Not safe with either rule, however small the skin.
  const auto dark = [&](unsigned seed) {
    std::mt19937 noise(seed);
    std::normal_distribution<double> grey(30, 3);
    Image image(kWide, kHeight);
    for (auto& pixel : image.pixels) pixel = static_cast<std::uint8_t>(std::clamp(grey(noise), 0.0, 255.0));
    return image;
  };
  const auto blind = monitor.process(dark(1), dark(2));
  CAPTURE(blind.undecidable_pixels, supported);
  std::vector<std::string> expected;
  if (!large_cells) expected = {"left_blind", "right_blind"};
  if (supported > 0) expected.emplace_back("too_undecidable");
  CHECK(blind.faults.names() == expected);
  CHECK(blind.safe == expected.empty());
}

TEST_CASE("Which side of the skin is nearer is known from the cameras, also of a skin close before them") {
  const auto camera = [](const char* name, double x_mm) {
    const calib::CameraModel model(calib::BrownConradyIntrinsics{530, 530, 99.5, 59.5, {}});
    calib::Camera made{name, 200, 120, model, {}};
    made.world_to_camera.translation_mm.x() = -x_mm;
    return made;
  };
  const auto nearer = [&](double right_mm, hls::table::ShiftRange shifts) {
    MapTable table(ScanGeometry{200, 120, Scan::progressive}, 3, 3);
    hls::table::Facts facts = facts_of(table, find_profile("vga"));
    facts.shifts = shifts;
    table.seal(facts);
    const calib::Rig rig{"", {camera("left", 0), camera("right", right_mm)}};
    const Proof proof = with_knowledge({}, find_profile("vga"), {&table}, calib::to_yaml(rig), "rig.yaml");
    CHECK(proof.nearer_below != proof.nearer_above);
    return proof.nearer_below ? -1 : 1;
  };
  CHECK(nearer(100, {-462, 126}) == -1);
  CHECK(nearer(100, {-208, 431}) == -1);  // a skin at 120 mm
  CHECK(nearer(-100, {-126, 462}) == 1);
  MapTable unknown(ScanGeometry{200, 120, Scan::progressive}, 3, 3);
  const Proof proof = with_knowledge({}, find_profile("vga"), {&unknown}, "", "");
  CHECK_FALSE(proof.nearer_below);
  CHECK_FALSE(proof.nearer_above);
}

TEST_CASE("At full resolution cameras are compared where epipolar lines are flat enough for what is behind the skin") {
  const auto compared = [](double roll_deg, hls::table::ShiftRange shifts) {
    const calib::CameraModel model(calib::BrownConradyIntrinsics{530, 530, 319.5, 239.5, {}});
    calib::Rig rig{"", {{"left", 640, 480, model, {}}, {"right", 640, 480, model, {}}}};
    const double roll = roll_deg * 3.14159265358979 / 180;
    rig.cameras[1].world_to_camera.translation_mm = Eigen::Vector3d(-100 * std::cos(roll), -100 * std::sin(roll), 0);
    MapTable table(ScanGeometry{640, 480, Scan::progressive}, 3, 3);
    hls::table::Facts facts = facts_of(table, find_profile("vga"));
    facts.shifts = shifts;
    table.seal(facts);
    return with_knowledge({}, find_profile("vga"), {&table}, calib::to_yaml(rig), "rig.yaml").at_full_resolution;
  };
  CHECK(compared(0, {-462, 126}));
  CHECK(compared(1, {-462, 126}));
  CHECK_FALSE(compared(4, {-462, 126}));
  CHECK(compared(4, {-462, 40}));
}

TEST_CASE("Images that are the same bit by bit are a fault: they are of one camera") {
  Small small;
  small.monitor.select(1);
  const Image left = textured(kWidth, kHeight, 1);
  const auto same = small.monitor.process(left, left);
  CHECK(same.faults.names() == std::vector<std::string>{"identical_images"});
  CHECK(!same.safe);
  const auto other = small.frame(2);
  CHECK(!other.faults.any());
  CHECK(other.safe);
}

TEST_CASE("Rows that the store does not hold are misses") {
  Small small;
  Monitor& m = small.monitor;
  MapTable far(ScanGeometry{kWidth, kHeight, Scan::progressive}, 5, 5);
  for (int row = 0; row < far.rows(); ++row) {
    for (int column = 0; column < far.columns(); ++column) {
      far.set_control(column, row, MapTable::encode(Point{column * 32.0, row * 32.0 + 30}));
    }
  }
  far.seal(facts_of(far, small.profile));
  m.upload(2, far);
  m.select(2);
  const auto result = small.frame(1);
  CHECK(result.faults.names().front() == "store_miss");
  CHECK(m.device().read(reg::frame_misses::kAddress) > 0);
}

TEST_CASE("Fifteen tables fit, are switched at every frame, and a full pool says so") {
  Small small;
  for (int slot = 2; slot < 15; ++slot)
    small.monitor.upload(slot, shift_table(small.profile, kWidth, kHeight, slot, 2));
  for (unsigned i = 0; i < 30; ++i) {
    small.monitor.select(static_cast<int>(i % 15));
    const auto result = small.frame(i + 1);
    CHECK(result.table == static_cast<int>(i % 15));
    CHECK(result.alarm == (i % 15 == 0));
    CHECK(!result.faults.any());
  }
  const MachineProfile& hd = find_profile("hd");
  Monitor large(make_native_device(hd), hd, Settings{}.without_proof());
  large.start(1920, 1080, 8);
  MapTable dense({1920, 1080, Scan::progressive}, 4, 4);  // 33 KiB of the pool's 64
  dense.seal(facts_of(dense, hd));
  large.upload(0, dense);
  CHECK_THROWS_WITH(large.upload(1, dense), Catch::Contains("does not fit the pool"));
  CHECK_NOTHROW(large.upload(0, dense));
}

TEST_CASE("The first pair is shown until it is proven, a live one once; what has too few places never is") {
  const MachineProfile& profile = find_profile(GENERATE("vga", "hd"));
  SkinFile skin;
  skin.path = "skin";
  skin.skin = std::make_unique<HomographySkin>(Matrix3{1, 0, -6, 0, 1, 2, 0, 0, 1});
  Settings settings;
  settings.live = GENERATE(false, true);
  settings.proof.registered = settings.proof.at_full_resolution = GENERATE(false, true);
  CAPTURE(profile.name, settings.live, settings.proof.registered);
  Supervisor supervisor(make_native_device(profile), profile, compile_maps(skin, profile, kWidth, kHeight), settings);
  for (unsigned pair = 1; pair <= 3; ++pair) {
    const auto results =
        supervisor.process(textured(kWidth, kHeight, 2 * pair), textured(kWidth, kHeight, 2 * pair + 1));
    REQUIRE(results.size() == 1);
    // Where places at full resolution are waited for: these images have none.
    const bool waits = settings.proof.at_full_resolution;
    CHECK(results[0].sequence == (settings.live ? pair : pair + 1));
    CHECK(results[0].faults.has(Fault::unproven) == (waits || (settings.live && pair == 1)));
  }
}

TEST_CASE("Something large on the skin is overlooked where the rule is blind, and an alarm where it is not") {
  const MachineProfile& profile = find_profile("vga");
  constexpr int kW = 320, kH = 240, kCoarse_px = 5, kFrames = 40;
  const Image left = enlarged(textured(kW / kCoarse_px, kH / kCoarse_px, 1), kCoarse_px);
  SkinFile skin;
  skin.path = "skin";
  skin.skin = std::make_unique<HomographySkin>(Matrix3{1, 0, -6, 0, 1, 0, 0, 0, 1});
  const bool blind = GENERATE(true, false);
  CAPTURE(blind);
  Settings settings;
  settings.texture = blind ? 255 : Settings().texture;
  settings.undecidable_percent = 100;
  settings.still_limit = settings.frozen_limit = 0;
  Supervisor supervisor(make_native_device(profile), profile, compile_maps(skin, profile, kW, kH), settings);
  Faults faults;
  bool alarm = false, at_once = false;
  for (int i = 0; i < kFrames; ++i) {
    const auto result = supervisor.process(left, moved(left, -6, 0)).front();
    faults |= result.faults;
    alarm = alarm || result.alarm;
    at_once = at_once || (i == 0 && result.faults.has(Fault::overlooked));
  }
  CAPTURE(faults.names());
  CHECK(at_once == blind);
  CHECK(alarm == !blind);
  CHECK(faults.has(Fault::overlooked) == blind);
}

/// What has texture lies on the skin.
Image textured_above(int row) {
  Image image = textured(320, 240, 1);
  std::fill(image.pixels.begin() + row * image.width, image.pixels.end(), std::uint8_t{128});
  return image;
}

TEST_CASE("An alarm that does not count hides nothing that is overlooked") {
  const MachineProfile& profile = find_profile("vga");
  constexpr int kW = 320, kH = 240, kFrames = 120, kDecide = 24;
  // Only where that is much of the image it is an alarm, in every third frame.
  const Image few = textured_above(96), many = textured_above(160);
  SkinFile skin;
  skin.path = "skin";
  skin.skin = std::make_unique<HomographySkin>(Matrix3{1, 0, -6, 0, 1, 0, 0, 0, 1});
  const int needed = GENERATE(1, 2);
  CAPTURE(needed);
  Settings settings;
  settings.object_px = 1e4;
  settings.alarm_percent = 40;
  settings.alarm_frames = {needed, 3};
  settings.undecidable_percent = 100;
  settings.blind_share = settings.still_limit = settings.frozen_limit = 0;
  Supervisor supervisor(make_native_device(profile), profile, compile_maps(skin, profile, kW, kH), settings);
  Faults faults;
  int seen = 0;
  for (int i = 0; i < kFrames; ++i) {
    const Image& left = i % 3 == 2 ? many : few;
    const auto result = supervisor.process(left, moved(left, -6, 0)).front();
    if (i > kDecide) faults |= result.faults;
    seen += result.seen ? 1 : 0;
  }
  CAPTURE(faults.names());
  CHECK(seen == kFrames / 3);
  CHECK(faults.has(Fault::overlooked) == (needed == 2));
}

TEST_CASE("So it does in its own frame") {
  const MachineProfile& profile = find_profile("vga");
  constexpr int kW = 320, kH = 240, kCoarse_px = 5;
  const Image left = enlarged(textured(kW / kCoarse_px, kH / kCoarse_px, 1), kCoarse_px);
  SkinFile skin;
  skin.path = "skin";
  skin.skin = std::make_unique<HomographySkin>(Matrix3{1, 0, -6, 0, 1, 0, 0, 0, 1});
  const int needed = GENERATE(1, 2);
  CAPTURE(needed);
  Settings settings;
  settings.alarm_frames = {needed, 3};
  settings.undecidable_percent = 100;
  settings.still_limit = settings.frozen_limit = 0;
  Supervisor supervisor(make_native_device(profile), profile, compile_maps(skin, profile, kW, kH), settings);
  FrameResult result;
  for (int i = 0; i < 40 && !result.safe; ++i) result = supervisor.process(left, moved(left, -22, 0)).front();
  REQUIRE(result.safe);
  const bool teaches = GENERATE(false, true);  // then each alarm counts
  CAPTURE(teaches);
  for (const int shift_px : {-22, -22, -6}) {
    supervisor.monitor().teach(teaches && shift_px == -6);
    result = supervisor.process(left, moved(left, shift_px, 0)).front();
  }
  CAPTURE(result.faults.names());
  CHECK(result.seen);
  CHECK(!result.safe);
  CHECK(result.faults.has(Fault::overlooked) == (needed == 2 && !teaches));
}

TEST_CASE("What follows a frame with a fault teaches nothing: what both cameras see is known of the frames before") {
  const MachineProfile& profile = find_profile("vga");
  constexpr int kW = 320, kH = 240, kCoarse_px = 5;
  const auto moved_behind = [](const Image& left) { return moved(left, -22, 0); };
  const Image empty = enlarged(textured(kW / kCoarse_px, kH / kCoarse_px, 1), kCoarse_px);
  const auto with_plain = [&](int from_x, int to_x) {
    Image image = empty;
    for (int y = 60; y < 180; ++y) {
      std::fill(image.pixels.begin() + y * kW + from_x, image.pixels.begin() + y * kW + to_x, std::uint8_t{120});
    }
    return image;
  };
  Image covered = moved_behind(empty);
  for (int y = 0; y < kH; ++y) {
    std::fill(covered.pixels.begin() + y * kW + kW / 3, covered.pixels.begin() + (y + 1) * kW, std::uint8_t{0});
  }
  SkinFile skin;
  skin.path = "skin";
  skin.skin = std::make_unique<HomographySkin>(Matrix3{1, 0, -6, 0, 1, 0, 0, 0, 1});
  Settings settings;
  settings.blind.watch = true;
  settings.undecidable_percent = 100;
  settings.still_limit = settings.frozen_limit = 0;
  Supervisor supervisor(make_native_device(profile), profile, compile_maps(skin, profile, kW, kH), settings);
  Monitor& monitor = supervisor.monitor();
  const auto process = [&](const Image& left, const Image& right) { return supervisor.process(left, right).front(); };
  FrameResult result;
  constexpr int kTaught = 40;  // until places say whether a camera was moved
  for (int i = 0; i < kTaught + 3; ++i) {
    monitor.teach(i < kTaught);
    result = process(empty, moved_behind(empty));
  }
  CAPTURE(result.faults.names());
  REQUIRE(result.safe);
  const bool before = GENERATE(false, true);  // the fault comes before the teaching
  CAPTURE(before);
  if (before) process(empty, covered);
  monitor.teach(true);
  if (!before) {
    CHECK(process(empty, moved_behind(empty)).faults.names() == std::vector<std::string>{"teaching"});
    CHECK(monitor.blind_watch().taught() == 1);
    CHECK(process(empty, covered).faults.without(Fault::teaching).any());
    CHECK(monitor.blind_watch().taught() == 0);
  }
  for (int after = 1; after <= 4; ++after) {
    CAPTURE(after);
    result = process(empty, moved_behind(empty));
    CHECK(monitor.blind_watch().taught() == std::max(0, after - 2));
  }
  monitor.teach(false);
  CHECK_FALSE(process(empty, moved_behind(empty)).alarm);
  CHECK(monitor.device().read(reg::taught::kAddress) == 2);
  const Image body = with_plain(200, 300);
  CHECK(process(body, moved_behind(body)).alarm);
}

TEST_CASE("What changes in one image alone is out of step; with another table the right image is another one") {
  const MachineProfile& profile = find_profile("vga");
  constexpr int kW = 320, kH = 240, kCell_px = 8;
  Image left = enlarged(textured(kW / kCell_px, kH / kCell_px, 1), kCell_px);
  for (auto& pixel : left.pixels) pixel = static_cast<std::uint8_t>(std::clamp(4 * pixel - 375, 0, 255));
  Settings settings;
  settings.still_limit = settings.frozen_limit = 0;
  Monitor monitor(make_native_device(profile), profile, settings);
  monitor.start(kW, kH, 8);
  monitor.upload(0, shift_table(profile, kW, kH, -6, 0));
  monitor.upload(1, shift_table(profile, kW, kH, -6 - 2 * kCell_px, 0));
  monitor.select(0);
  const auto is_out_of_step = [&](int shift_px) {
    return monitor.process(left, moved(left, shift_px, 0)).faults.has(Fault::out_of_step);
  };
  for (int frame = 0; frame < 3; ++frame) CHECK_FALSE(is_out_of_step(-6));
  SECTION("one camera alone") { CHECK(is_out_of_step(-6 + 2 * kCell_px)); }
  SECTION("another table") {
    monitor.select(1);
    for (int frame = 0; frame < 2; ++frame) CHECK_FALSE(is_out_of_step(-6));
    CHECK(is_out_of_step(-6 - 2 * kCell_px));
  }
}

TEST_CASE("Each field is out of step by itself, as it is compared with the one before of its own rows") {
  const MachineProfile& profile = find_profile("field");
  constexpr int kW = 640, kH = 240, kCell_px = 16;  // of a field
  const Image small = enlarged(textured(kW / kCell_px, kH / 8, 1), 8);
  Image left(kW, kH);
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x)
      left.at(x, y) = static_cast<std::uint8_t>(std::clamp(4 * small.at(x / 2, y) - 375, 0, 255));
  }
  Settings settings;
  settings.still_limit = settings.frozen_limit = 0;
  Monitor monitor(make_native_device(profile), profile, settings);
  monitor.start(kW, kH, 8);
  for (int slot : {0, 1}) monitor.upload(slot, shift_table(profile, kW, kH, -12, 0));
  int field = 1;
  // The right image is displaced by `shift_px`, and both have moved by `way_px`.
  const auto is_out_of_step = [&](int shift_px, int way_px = 0) {
    field = 1 - field;
    monitor.select(field);
    const Image now = moved(left, way_px, 0);
    return monitor.process(now, moved(now, shift_px, 0)).faults.has(Fault::out_of_step);
  };
  for (int i = 0; i < 4; ++i) CHECK_FALSE(is_out_of_step(-12));
  SECTION("a motion in one image") {
    for (int i = 0; i < 6; ++i) CHECK(is_out_of_step(-12 + 2 * kCell_px));
    // It begins in both: the fault ends when both fields have seen it.
    CHECK(is_out_of_step(-12, 4 * kCell_px));
    for (int i = 0; i < 3; ++i) CHECK_FALSE(is_out_of_step(-12, 4 * kCell_px));
  }
  SECTION("one that one field alone has seen so far") {
    CHECK(is_out_of_step(-12 + 2 * kCell_px));
    // As from a camera that is a field late: in the next one both have moved, since two fields ago.
    CHECK(is_out_of_step(-12, 2 * kCell_px));
    for (int i = 0; i < 3; ++i) CHECK(is_out_of_step(-12, 2 * kCell_px));
  }
  SECTION("a motion in both images") {
    for (int i = 1; i < 6; ++i) CHECK_FALSE(is_out_of_step(-12, i / 2 * kCell_px));
  }
  SECTION("after a field that is lost, each is compared again from the second on") {
    field = 1 - field;
    for (int i = 0; i < 3; ++i) CHECK_FALSE(is_out_of_step(-12));
    CHECK(is_out_of_step(-12 + 2 * kCell_px));
  }
  SECTION("the tables go on: a skin that moves") {
    // As MovingSupervisor does: each slot is overwritten while the other one is in use.
    for (int i = 1; i < 5; ++i) {
      const int next_px = -12 + i / 2 * 2 * kCell_px;
      monitor.upload(1 - field, shift_table(profile, kW, kH, next_px, 0));
      CHECK_FALSE(is_out_of_step(-12));
    }
  }
}

TEST_CASE("What has texture along the rows alone cannot be proven, and is shown sixty times") {
  const MachineProfile& profile = find_profile("vga");
  constexpr int kW = 320, kH = 240;
  SkinFile skin;
  skin.path = "skin";
  skin.skin = std::make_unique<HomographySkin>(Matrix3{1, 0, -6, 0, 1, 0, 0, 0, 1});
  Settings settings;
  settings.proof.registered = settings.proof.at_full_resolution = true;
  Supervisor supervisor(make_native_device(profile), profile, compile_maps(skin, profile, kW, kH), settings);
  std::mt19937 random(5);
  std::vector<int> column(kW + 40);
  for (std::size_t x = 0; x < column.size(); ++x)
    column[x] = x % 5 == 0 ? static_cast<int>(10 + random() % 110) : column[x - 1];
  const auto seen = [&](int shift) {
    Image image(kW, kH);
    for (int y = 0; y < kH; ++y) {  // darker above, so that cells are told from those below
      for (int x = 0; x < kW; ++x)
        image.at(x, y) = static_cast<std::uint8_t>(column[static_cast<std::size_t>(x + shift)] + y / 2 +
                                                   static_cast<int>(random() % 3));
    }
    return image;
  };
  const auto results = supervisor.process(seen(0), seen(20));
  REQUIRE(results.size() == 1);
  CHECK(results[0].faults.names() == std::vector<std::string>{"unproven"});
  CHECK(results[0].sequence == 60);
}

// That it was shown again counts once.
TEST_CASE("A scene that stands still counts from the first pair on, however often that was shown") {
  const MachineProfile& profile = find_profile("vga");
  constexpr int kW = 320, kH = 240;  // enough cells for the check
  SkinFile skin;
  skin.path = "skin";
  skin.skin = std::make_unique<HomographySkin>(Matrix3{1, 0, -6, 0, 1, 0, 0, 0, 1});
  Settings settings;
  settings.still_limit = 4;
  Supervisor supervisor(make_native_device(profile), profile, compile_maps(skin, profile, kW, kH), settings);
  const Image left = textured(kW, kH, 5), right = textured(kW, kH, 6);
  for (int pair = 0; pair < 6; ++pair) {
    CAPTURE(pair);
    Image noisy_left = left, noisy_right = right;
    noisy_left.at(3, 3) ^= static_cast<std::uint8_t>(pair + 1);
    noisy_right.at(3, 3) ^= static_cast<std::uint8_t>(pair + 1);
    const auto results = supervisor.process(noisy_left, noisy_right);
    CHECK(results[0].faults.has(Fault::left_frozen) == (pair >= 3));
    CHECK(results[0].faults.has(Fault::right_frozen) == (pair >= 3));
  }
}

TEST_CASE("A table is expanded when it is uploaded, and no frame waits for it") {
  const MachineProfile& profile = find_profile("vga");
  auto made = std::make_unique<NativeDevice>(profile);
  const NativeDevice& device = *made;
  Monitor monitor(std::move(made), profile, Settings{}.without_proof());
  monitor.start(kWidth, kHeight, 8);
  unsigned seed = 0;
  const auto crc_of_frame = [&] {
    const Image left = textured(kWidth, kHeight, ++seed);
    monitor.device().send(left, moved(left, -6, 2));
    monitor.device().receive();
    return monitor.device().read(reg::frame_table_crc::kAddress);
  };
  const std::array tables{shift_table(profile, kWidth, kHeight, -6, 2), shift_table(profile, kWidth, kHeight, 5, 2)};
  for (int slot = 0; slot < 2; ++slot) monitor.upload(slot, tables[static_cast<std::size_t>(slot)]);
  for (const int slot : {0, 1, 0}) {
    monitor.select(slot);
    CHECK(crc_of_frame() == tables[static_cast<std::size_t>(slot)].crc());
  }
  CHECK(device.frames_that_expanded_their_table() == 0);

  // Tables stay where they are while it is stopped, but another LOOKAHEAD makes others of them.
  monitor.device().write(reg::control::kAddress, 0);
  monitor.device().write(reg::lookahead::kAddress, 9);
  monitor.device().write(reg::control::kAddress, 1);
  CHECK(crc_of_frame() == tables[0].crc());
  monitor.upload(1, tables[0]);
  monitor.select(1);
  CHECK(crc_of_frame() == tables[0].crc());
  CHECK(device.frames_that_expanded_their_table() == 0);
}

TEST_CASE("Uploads are refused as the hardware refuses them") {
  Small small;
  Device& device = small.monitor.device();
  const auto upload = [&](std::uint32_t slot, std::uint32_t base_word64, const std::vector<std::uint32_t>& words) {
    return upload_words(device, slot, base_word64, words);
  };
  const auto words = shift_table(small.profile, kWidth, kHeight, 3, 3).words();
  CHECK(upload(4, 1000, words) == 0);
  CHECK((device.read(reg::map_valid::kAddress) & 1U << 4) != 0);
  CHECK(device.read(reg::map_crc::kAddress) == words.back());
  CHECK(reg::map_extent::kBaseWord64.get(device.read(reg::map_extent::kAddress)) == 1000);

  auto wrong_crc = words;
  wrong_crc.back() ^= 1;
  CHECK(upload(5, 2000, wrong_crc) == 4);
  CHECK((device.read(reg::map_valid::kAddress) & 1U << 5) == 0);
  auto bad_header = words;
  bad_header[0] ^= 0x100;
  CHECK(upload(5, 2000, bad_header) == 2);
  CHECK(upload(5, 10239, words) == 3);
  CHECK(upload(15, 2000, words) == 5);
  // Spans lie in the pool, too.
  MapTable with_spans = shift_table(small.profile, kWidth, kHeight, 3, 3);
  const auto without64 = static_cast<std::uint32_t>(with_spans.pool_bytes() / 8);
  with_spans.set_spans(std::vector<hls::table::Span>(kHeight, {3, kWidth - 5}));
  with_spans.seal(facts_of(with_spans, small.profile));
  const auto words64 = static_cast<std::uint32_t>(with_spans.pool_bytes() / 8);
  CHECK(words64 == without64 + (kHeight + 1) / 2);
  CHECK(upload(7, 10240 - words64 + 1, with_spans.words()) == 3);
  CHECK(upload(7, 10240 - words64, with_spans.words()) == 0);
  CHECK(reg::map_extent::kEndWord64.get(device.read(reg::map_extent::kAddress)) == 10240);
  CHECK(Faults(0, device.read(reg::faults_machine::kAddress)).has(Fault::map_crc));
  CHECK(small.frame(1).faults.names() == std::vector<std::string>{"map_crc"});
  CHECK(!small.frame(2).faults.any());

  // Slot 0 is selected: neither it nor its region can be written.
  CHECK(upload(0, 3000, words) == 1);
  CHECK(upload(6, 0, words) == 1);
  CHECK(small.frame(3).faults.names() == std::vector<std::string>{"map_busy"});
  CHECK(small.frame(4).table == 0);
  // A table that is overlapped is gone.
  CHECK(upload(6, 1000, words) == 0);
  CHECK((device.read(reg::map_valid::kAddress) & 1U << 4) == 0);
  // Data without start.
  device.write(reg::map_data::kAddress, 1);
  CHECK(reg::map_status::kError.get(device.read(reg::map_status::kAddress)) == 6);
}

TEST_CASE("Registers behave as described") {
  const auto device = make_native_device(find_profile("vga"));
  CHECK(device->read(reg::id::kAddress) == 0x484F524F);
  CHECK_THROWS_AS(device->read(0x7F0), DeviceError);
  CHECK_THROWS_AS(device->write(reg::id::kAddress, 0), DeviceError);
  CHECK_THROWS_AS(device->read(reg::map_data::kAddress), DeviceError);
  CHECK_THROWS_AS(device->send(Image(8, 8), Image(8, 8)), DeviceError);
  device->write(reg::width::kAddress, 30);
  device->write(reg::control::kAddress, 1);
  CHECK(reg::status::kBadGeometry.get(device->read(reg::status::kAddress)) == 1);
  CHECK_THROWS_AS(device->write(reg::width::kAddress, 96), DeviceError);  // locked
  device->write(reg::control::kAddress, 0);
  device->write(reg::width::kAddress, 96);
  device->write(reg::control::kAddress, 1);
  CHECK(reg::status::kRunning.get(device->read(reg::status::kAddress)) == 1);
  CHECK(reg::status::kSafe.get(device->read(reg::status::kAddress)) == 0);
}

TEST_CASE("The rule of the settings decides, and settings that it cannot take are refused") {
  Settings settings = Settings{}.without_proof();
  settings.decision = Decision::compete;
  settings.competition.quorum = 255;
  settings.texture = 255;  // of the other rule
  Small small(settings);
  const auto strict = small.frame(1);
  small.monitor.device().write(reg::compete::kAddress, reg::compete::kReset);
  const auto usual = small.frame(2);
  CHECK(usual.skin_pixels > kWidth * kHeight / 2);
  CHECK(strict.skin_pixels < usual.skin_pixels);
  settings.competition.quorum = 256;
  CHECK_THROWS_WITH(Small(settings), Catch::Contains("quorum 256; expected 0 to 255"));
  settings.competition.quorum = 1;
  CHECK_THROWS_WITH(Monitor(make_native_device(find_profile("field")), find_profile("field"), settings),
                    Catch::Contains("profile field does not have the decision 'compete'"));
}

TEST_CASE("The driver refuses machines of another kind") {
  CHECK_THROWS_WITH(Monitor(make_native_device(find_profile("hd")), find_profile("vga")),
                    Catch::Contains("not one of profile vga"));
  Monitor monitor(make_native_device(find_profile("vga")), find_profile("vga"), Settings{}.without_proof());
  CHECK_THROWS_AS(monitor.start(641, 480, 8), DeviceError);
  CHECK_THROWS_AS(monitor.start(640, 480, 65), DeviceError);
}

namespace {

/// Passes everything on.
class Passing : public Device {
 public:
  explicit Passing(std::string_view profile) : device_(make_native_device(find_profile(profile))) {}
  std::uint32_t read(std::uint32_t address) override { return device_->read(address); }
  void write(std::uint32_t address, std::uint32_t value) override { device_->write(address, value); }
  void send(const Image& left, const Image& right) override { device_->send(left, right); }
  FrameStreams receive() override { return device_->receive(); }
  std::string_view engine() const override { return "passing"; }
  bool counts_cycles() const override { return false; }

 private:
  std::unique_ptr<Device> device_;
};

/// With one thing broken.
class Broken : public Passing {
 public:
  enum class How { count, state, run, sequence, silent, object, no_alarm, seen_alone, area };
  explicit Broken(How how) : Passing("vga"), how_(how) {}
  void repair() { broken_ = false; }
  void break_now() { broken_ = true; }
  std::uint32_t read(std::uint32_t address) override {
    const auto value = Passing::read(address);
    if (!broken_) return value;
    if (how_ == How::area && address == reg::frame_object_area::kAddress) return value + 1;
    if (how_ == How::count && address == reg::frame_skin::kAddress) return value + 1;
    if (how_ == How::object && address == reg::frame_object::kAddress) return value - 1;
    if (how_ == How::no_alarm && address == reg::frame_status::kAddress)
      return value & ~(reg::frame_status::kAlarm.mask() | reg::frame_status::kSeen.mask());
    if (how_ == How::seen_alone && address == reg::frame_status::kAddress)
      return value & ~reg::frame_status::kAlarm.mask();
    if (how_ == How::sequence && address == reg::frame_sequence::kAddress && value != 0) return value + 1;
    if (how_ == How::silent && address == reg::frame_sequence::kAddress) return 0;
    return value;
  }
  FrameStreams receive() override {
    auto streams = Passing::receive();
    if (how_ == How::state) streams.states.at(40, 30) ^= 1U;
    if (how_ == How::run) streams.runs.pop_back();
    return streams;
  }

 private:
  How how_;
  bool broken_ = true;
};

/// Says to be built otherwise.
class Built : public Passing {
 public:
  struct Change {
    std::uint32_t address;
    reg::Field field;
    std::uint32_t value;
  };
  explicit Built(std::vector<Change> changes, std::string_view profile = "vga")
      : Passing(profile), changes_(std::move(changes)) {}
  std::uint32_t read(std::uint32_t address) override {
    auto word = Passing::read(address);
    for (const Change& c : changes_) {
      if (c.address == address) word = (word & ~c.field.mask()) | c.field.put(c.value);
    }
    return word;
  }

 private:
  std::vector<Change> changes_;
};

/// After `good` writes into one register, the next one arrives there with a wrong bit.
class Garbled : public Passing {
 public:
  struct Fault {
    std::uint32_t address = UINT32_MAX;
    int good = 0;
  };
  Garbled(Fault fault, std::set<std::uint32_t>* written) : Passing("vga"), fault_(fault), written_(written) {}
  void write(std::uint32_t address, std::uint32_t value) override {
    if (written_ != nullptr) written_->insert(address);
    if (address == fault_.address && fault_.good-- == 0) value ^= 1U;
    Passing::write(address, value);
  }

 private:
  Fault fault_;
  std::set<std::uint32_t>* written_;
};

const Built::Change kNoThesis{reg::build_window::kAddress, reg::build_window::kThesis, 0};
const std::vector<Built::Change> kNoCompete{{reg::build_window::kAddress, reg::build_window::kCompete, 0},
                                            {reg::build_compete::kAddress, {0, 32}, 0}};
Built::Change pool_kib(std::uint32_t kib) { return {reg::build_store::kAddress, reg::build_store::kPoolKib, kib}; }

Monitor monitor_of(std::vector<Built::Change> changes, Decision decision = Decision::thesis) {
  Settings settings = Settings{}.without_proof();
  settings.decision = decision;
  return {std::make_unique<Built>(std::move(changes)), find_profile("vga"), settings};
}

constexpr std::chrono::milliseconds kNoFrames{50};  ///< none come to these machines

/// One table of 520 bytes.
MapSet small_maps(int shift) {
  MapTable table(ScanGeometry{kWidth, kHeight, Scan::progressive}, 3, 3);
  table.set_control(0, 0, MapTable::encode(Point{static_cast<double>(shift), 0}));
  table.seal(facts_of(table, find_profile("vga")));
  MapSet set{"vga", kWidth, kHeight, "", "", {{table, {}}}};
  set.maps[0].report.lookahead = 8;
  return set;
}

/// Nothing of good_frame is in it.
MapSet maps_beside() {
  MapSet set{"vga", kWidth, kHeight, "", "", {{shift_table(find_profile("vga"), kWidth, kHeight, 5, 2), {}}}};
  set.maps[0].report.lookahead = 8;
  return set;
}

void good_frame(Device& device, unsigned seed) {
  const Image left = textured(kWidth, kHeight, seed);
  device.send(left, moved(left, -6, 2));
  device.receive();
}

}  // namespace

TEST_CASE("A body of so many mm is an alarm by the area that it covers, and without areas always") {
  const MachineProfile& profile = find_profile("vga");
  Settings settings = Settings{}.without_proof();
  settings.alarm_percent = 100;
  settings.object_mm = 40;
  settings.object_px = 60;
  const double half_disc_mm2 = M_PI / 8 * 40 * 40;
  CHECK(object_area_limit(settings) == std::floor(1024 * half_disc_mm2));
  auto device = std::make_unique<Broken>(Broken::How::area);
  Broken& broken = *device;
  broken.repair();
  Monitor monitor(std::move(device), profile, settings);
  monitor.start(kWidth, kHeight, 8);
  CHECK(broken.read(reg::object_area_limit::kAddress) == object_area_limit(settings));
  CHECK(broken.read(reg::object_limit::kAddress) == 640 * 480 + 1);
  // A pixel sees 1 mm² of the one skin, 1/4 mm² of the next, as a wall at half the distance; nothing is known of the last.
  for (const auto& [slot, code] : {std::pair{0, 96}, {1, 80}, {2, 0}}) {
    MapTable table = shift_table(profile, kWidth, kHeight, -6, 2);
    hls::table::Facts facts = table.facts();
    if (code != 0) facts.areas.assign(6, static_cast<std::uint8_t>(code));
    table.seal(facts);
    monitor.upload(slot, table);
  }
  const Image left = textured(kWidth, kHeight, 3);
  Image right = moved(left, -6, 2);
  const Image other = textured(kWidth, kHeight, 77);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (x < 20 || x >= 68 || y < 8 || y >= 56) right.at(x, y) = other.at(x, y);
    }
  }
  for (const auto& [slot, pixel_mm2, alarm] :
       {std::tuple{0, 1.0, true}, {1, 0.25, false}, {2, 1048575.0 / 1024, true}}) {
    CAPTURE(slot);
    monitor.select(slot);
    const FrameResult result = monitor.process(left, right);
    const auto objects = objects_of(result);
    REQUIRE_FALSE(objects.empty());
    CHECK(objects[0].pixels > half_disc_mm2);  // by pixels each would be one
    CHECK(objects[0].area == objects[0].pixels * pixel_mm2 * 1024);
    CHECK(result.largest_object_area == objects[0].area);
    CHECK(result.alarm == alarm);
    CHECK(is_alarm(objects[0], result) == alarm);
    CHECK(result.object_limit_pixels == std::ceil(object_area_limit(settings) / (1024 * pixel_mm2)));
  }
  broken.break_now();
  CHECK_THROWS_WITH(monitor.process(left, right), Catch::Contains("by the table's areas it is"));
}

TEST_CASE("A build with one of the profile's rules is taken, and asked for the other it is refused") {
  CHECK_NOTHROW(monitor_of({kNoThesis}, Decision::compete));
  CHECK_THROWS_WITH(monitor_of({kNoThesis}), Catch::Contains("without the decision 'thesis'; choose 'compete'"));
  CHECK_NOTHROW(monitor_of(kNoCompete));
  CHECK_THROWS_WITH(monitor_of(kNoCompete, Decision::compete),
                    Catch::Contains("without the decision 'compete'; choose 'thesis'"));
  // Neither rule.
  auto none = kNoCompete;
  none.push_back(kNoThesis);
  CHECK_THROWS_AS(monitor_of(none), UsageError);
  CHECK_THROWS_AS(monitor_of(none, Decision::compete), UsageError);
}

TEST_CASE("A build with a smaller pool takes the tables that fit it") {
  Monitor monitor = monitor_of({pool_kib(1)});
  const MachineProfile& profile = find_profile("vga");
  monitor.start(kWidth, kHeight, 8);
  MapTable table(ScanGeometry{kWidth, kHeight, Scan::progressive}, 3, 3);  // 13 columns, 10 rows
  table.seal(facts_of(table, profile));
  REQUIRE(table.pool_bytes() == 520);
  monitor.upload(0, table);
  CHECK_THROWS_WITH(monitor.upload(1, table), Catch::Contains("does not fit the pool of 1024 bytes"));
  CHECK_NOTHROW(monitor.upload(1, shift_table(profile, kWidth, kHeight, -6, 2)));

  // A skin that moves needs room for two.
  MovingMaps maps;
  maps.steps = {{0.5, {table, {}}}};
  maps.lookahead = 8;
  const auto moving = [&](std::uint32_t kib) {
    MovingSupervisor(std::make_unique<Built>(std::vector{pool_kib(kib)}), profile, maps);
  };
  CHECK_THROWS_WITH(moving(1), Catch::Contains("at 0.500 s, of 520 bytes, is more than half"));
  CHECK_NOTHROW(moving(2));
}

TEST_CASE("A table without room beside the one in use is refused, or takes its place in a machine that is stopped") {
  Built device({pool_kib(1)});
  const Build build = find_build(device);
  const Settings settings = Settings{}.without_proof();
  const auto crc = [&] {
    device.write(reg::map_slot::kAddress, device.read(reg::table_select::kAddress));
    return device.read(reg::map_crc::kAddress);
  };
  CHECK_FALSE(load(device, build, small_maps(1), settings, false, kNoFrames).stopped);  // it was not running
  CHECK(crc() == small_maps(1).maps[0].table.crc());
  CHECK_THROWS_WITH(load(device, build, small_maps(2), settings, false, kNoFrames),
                    Catch::Contains("--stop-first") && Catch::Contains("the table that was in use stays in use"));
  CHECK(crc() == small_maps(1).maps[0].table.crc());
  CHECK(reg::status::kRunning.get(device.read(reg::status::kAddress)) == 1);
  CHECK(load(device, build, small_maps(2), settings, true, kNoFrames).stopped);
  CHECK(crc() == small_maps(2).maps[0].table.crc());
  CHECK(reg::status::kRunning.get(device.read(reg::status::kAddress)) == 1);
}

TEST_CASE("A machine for fields is stopped for an upload, and keeps no table that somebody may select in turn") {
  const MachineProfile& profile = find_profile("field");
  const auto device = make_native_device(profile);
  const Build build = find_build(*device);
  Settings settings = Settings{}.without_proof();
  settings.interlock.by_itself = true;
  const auto load_shifted = [&](double dx) {
    SkinFile skin;
    skin.path = "skin";
    skin.skin = std::make_unique<HomographySkin>(Matrix3{1, 0, dx, 0, 1, 4, 0, 0, 1});
    const MapSet maps = compile_maps(skin, profile, 160, 96);
    LoadReport report = load(*device, build, maps, settings, false, std::chrono::milliseconds(1));
    std::uint32_t slots = 0;
    for (const auto& table : report.tables) slots |= 1U << static_cast<unsigned>(table.slot);
    CHECK(device->read(reg::map_valid::kAddress) == slots);
    return report;
  };
  const LoadReport first = load_shifted(-8);
  CHECK_FALSE(first.stopped);  // it was not running
  // The even field in progress, its table selected: nothing says that the other table is in use, too.
  device->send(textured(160, 48, 1), textured(160, 48, 2));
  device->receive();
  const auto active = reg::map_status::kActiveSlot.get(device->read(reg::map_status::kAddress));
  REQUIRE(active == device->read(reg::table_select::kAddress));
  REQUIRE(static_cast<int>(active) == first.tables[0].slot);
  CHECK(load_shifted(-6).stopped);
  CHECK(load_shifted(-6).stopped);
  CHECK(reg::status::kRunning.get(device->read(reg::status::kAddress)) == 1);
  CHECK_FALSE(read_status(*device).faults().has(Fault::map_busy));
}

TEST_CASE("An upload says whether the cameras can wait; without a word they can, whatever was set before") {
  const auto device = make_native_device(find_profile("vga"));
  const Build build = find_build(*device);
  Settings settings = Settings{}.without_proof();
  const auto mode = [&] { return device->read(reg::mode::kAddress); };
  const auto changes_mode = [&] {
    const LoadReport report = load(*device, build, small_maps(1), settings, false, kNoFrames);
    return std::ranges::find(report.changed, "MODE") != report.changed.end() && report.stopped;
  };
  load(*device, build, small_maps(1), settings, false, kNoFrames);
  CHECK_FALSE(read_status(*device).live());
  settings.live = true;
  CHECK(changes_mode());
  CHECK(mode() == reg::mode::kLive.put(1));
  const MachineStatus status = read_status(*device);
  CHECK(status.running());
  CHECK(status_json(status)["live"] == true);
  CHECK(status_json(status)["test_input"] == false);
  CHECK_FALSE(changes_mode());
  settings.live = false;
  CHECK(changes_mode());
  CHECK(mode() == 0);
  // The test input, too: an upload is for cameras.
  device->write(reg::control::kAddress, 0);
  device->write(reg::mode::kAddress, reg::mode::kTestInput.put(1));
  CHECK(status_json(read_status(*device))["test_input"] == true);
  load(*device, build, small_maps(1), settings, false, kNoFrames);
  CHECK(mode() == 0);
}

TEST_CASE("What one rule has taught is nothing that the other one knows") {
  const auto device = make_native_device(find_profile("vga"));
  const Build build = find_build(*device);
  Settings settings = Settings{}.without_proof();
  settings.object_px = 0;
  settings.alarm_percent = settings.undecidable_percent = 100;
  SkinFile skin;
  skin.path = "skin";
  skin.skin = std::make_unique<HomographySkin>(Matrix3{1, 0, -6, 0, 1, 0, 0, 0, 1});
  const MapSet maps = compile_maps(skin, find_profile("vga"), kWidth, kHeight);
  load(*device, build, maps, settings, false, std::chrono::milliseconds(1));
  write_checked(*device, blocks_word({.watch = true, .teach = true}));
  // Frames before the one that has ended: each is one more, but for the first.
  unsigned seed = 0;
  const auto taught = [&] {
    ++seed;
    device->send(textured(kWidth, kHeight, 2 * seed), textured(kWidth, kHeight, 2 * seed + 1));
    device->receive();
    const Faults faults{device->read(reg::frame_faults_cameras::kAddress),
                        device->read(reg::frame_faults_machine::kAddress)};
    CHECK(faults.names() == std::vector<std::string>{"teaching"});
    return device->read(reg::taught::kAddress);
  };
  CHECK(taught() == 0);
  CHECK(taught() == 1);
  CHECK(taught() == 2);
  for (const int compete : {1, 0}) {
    CAPTURE(compete);
    device->write(reg::decision::kAddress, reg::decision::kCompete.put(compete));
    CHECK(taught() == 0);
    CHECK(taught() == 1);
  }
}

TEST_CASE("A frame is judged by the settings that it began with, as the hardware samples them") {
  const auto device = make_native_device(find_profile("vga"));
  load(*device, find_build(*device), maps_beside(), Settings{}.without_proof(), false, kNoFrames);
  const auto send = [&](unsigned seed) {
    device->send(textured(kWidth, kHeight, seed), textured(kWidth, kHeight, seed + 1));
  };
  const auto teaches = [&] {
    device->receive();
    return Faults{device->read(reg::frame_faults_cameras::kAddress), device->read(reg::frame_faults_machine::kAddress)}
        .has(Fault::teaching);
  };
  // The first begins when it is sent, the next when the one before has ended.
  write_checked(*device, blocks_word({.watch = true, .teach = true}));
  send(1);
  write_checked(*device, blocks_word({.watch = true}));
  send(3);
  CHECK(teaches());
  write_checked(*device, blocks_word({.watch = true, .teach = true}));
  send(5);
  CHECK_FALSE(teaches());
  CHECK(teaches());
}

TEST_CASE("Another table stops a machine that was taught, or that waits for a restart") {
  const auto device = make_native_device(find_profile("vga"));
  const Build build = find_build(*device);
  Settings settings = Settings{}.without_proof();
  const auto stops = [&](int shift) {
    const LoadReport report = load(*device, build, small_maps(shift), settings, false, std::chrono::milliseconds(1));
    device->send(textured(kWidth, kHeight, 1), textured(kWidth, kHeight, 2));
    device->receive();
    CHECK(device->read(reg::frame_table_crc::kAddress) == report.tables.front().crc);
    return report.stopped;
  };
  const auto blocks = [&](bool watch, bool teach) {
    write_checked(*device, blocks_word({.watch = watch, .teach = teach}));
  };
  stops(0);
  CHECK(stops(1));  // somebody must look
  CHECK_FALSE(stops(1));
  settings.interlock.by_itself = true;
  CHECK(stops(1));  // a setting
  CHECK_FALSE(stops(0));
  blocks(true, false);
  CHECK_FALSE(stops(0));
  CHECK(stops(2));
  CHECK_FALSE(stops(2));
  blocks(true, true);
  CHECK(stops(1));
  CHECK_FALSE(stops(1));
}

/// What it answers to the next write into one register is lost, or the board was reset before it.
class Deaf : public Passing {
 public:
  Deaf() : Passing("vga") {}
  void fail_at(std::uint32_t address, bool reset) {
    address_ = address;
    reset_ = reset;
  }
  void write(std::uint32_t address, std::uint32_t value) override {
    Passing::write(address, value);
    if (address != address_) return;
    address_ = UINT32_MAX;
    if (reset_) throw ResetError("reset");
    throw DeviceError("no answer");
  }

 private:
  std::uint32_t address_ = UINT32_MAX;
  bool reset_ = false;
};

TEST_CASE("After an error an upload says of the machine what is certain, and that the rest is not known") {
  Deaf device;
  const Build build = find_build(device);
  Settings settings = Settings{}.without_proof();
  settings.interlock.by_itself = true;
  const auto fails = [&](std::uint32_t address, bool reset = false) -> std::string {
    device.fail_at(address, reset);
    try {
      load(device, build, small_maps(1), settings, false, std::chrono::milliseconds(1));
    } catch (const DeviceError& error) {
      return error.what();
    }
    return "no error";
  };
  CHECK_THAT(fails(reg::map_slot::kAddress),
             Catch::Contains("no answer; the machine was not running, and is not started"));
  CHECK_THAT(fails(reg::table_select::kAddress), Catch::Contains("is not started"));
  CHECK_THAT(fails(reg::control::kAddress), Catch::Contains("not known: `horopter status` says it"));
  CHECK(read_status(device).running());
  CHECK_THAT(fails(reg::map_slot::kAddress), Catch::Contains("the table that was in use stays in use"));
  CHECK_THAT(fails(reg::map_slot::kAddress, true), Catch::Contains("reset; what the machine does now is not known"));
  CHECK_THAT(fails(reg::table_select::kAddress), Catch::Contains("not known"));
  settings.live = true;
  CHECK_THAT(fails(reg::control::kAddress), Catch::Contains("not known"));
  CHECK_FALSE(read_status(device).running());
  CHECK(fails(UINT32_MAX - 1) == "no error");
  settings.live = false;
  CHECK_THAT(fails(reg::mode::kAddress), Catch::Contains("the machine is stopped, and says not safe"));
  CHECK_FALSE(read_status(device).running());
}

TEST_CASE("An upload finds a place beside the table in use without a fault, and a machine that is safe stays safe") {
  const auto device = make_native_device(find_profile("vga"));
  const Build build = find_build(*device);
  Settings settings = Settings{}.without_proof();
  settings.interlock.by_itself = true;
  unsigned seed = 0;
  for (int upload = 0; upload < 3; ++upload) {
    CAPTURE(upload);
    CHECK_FALSE(load(*device, build, maps_beside(), settings, false, kNoFrames).stopped);
    CHECK(read_status(*device).safe() == (upload > 0));
    for (int frame = 0; frame < 3; ++frame) good_frame(*device, ++seed);
    CHECK(read_status(*device).safe());
    CHECK_FALSE(read_status(*device).faults().has(Fault::map_busy));
  }
}

TEST_CASE("An upload sets what no setting decides, too, but for what raises an interrupt") {
  const MachineProfile& profile = find_profile("vga");
  const auto device = make_native_device(profile);
  Settings settings = Settings{}.without_proof();
  for (const std::uint32_t address : {reg::timeout::kAddress, reg::black_level::kAddress, reg::white_level::kAddress,
                                      reg::constant_limit::kAddress}) {
    device->write(address, 1);
  }
  device->write(reg::irq_enable::kAddress, 3);
  const auto upload = [&] { load(*device, find_build(*device), maps_beside(), settings, false, kNoFrames); };
  upload();
  CHECK(device->read(reg::timeout::kAddress) == 2 * 640 * 480);
  CHECK(device->read(reg::black_level::kAddress) == reg::black_level::kReset);
  CHECK(device->read(reg::white_level::kAddress) == reg::white_level::kReset);
  CHECK(device->read(reg::constant_limit::kAddress) == reg::constant_limit::kReset);
  CHECK(device->read(reg::irq_enable::kAddress) == 3);
  settings.results_per_s = 50;
  upload();
  CHECK(device->read(reg::timeout::kAddress) == 1'007'000);  // 40 ms of 25.175 MHz
  // So does a run.
  auto passing = std::make_unique<Passing>("vga");
  passing->write(reg::timeout::kAddress, 1);
  Monitor monitor(std::move(passing), profile, Settings{}.without_proof());
  monitor.start(kWidth, kHeight, 8);
  CHECK(monitor.device().read(reg::timeout::kAddress) == 2 * 640 * 480);
}

/// Of one register the parity alone may fall over: it reads as before, and is a fault until it is written.
class Spoiled : public Passing {
 public:
  Spoiled() : Passing("vga") {}
  void spoil(std::uint32_t address) { address_ = address; }
  [[nodiscard]] bool is_spoiled() const { return address_ != kNone; }
  std::uint32_t read(std::uint32_t address) override {
    const auto value = Passing::read(address);
    if (!is_spoiled()) return value;
    if (address == reg::faults_machine::kAddress) return value | reg::faults_machine::kSettings.mask();
    if (address == reg::status::kAddress) return (value & ~reg::status::kSafe.mask()) | reg::status::kUnsafe.mask();
    return value;
  }
  void write(std::uint32_t address, std::uint32_t value) override {
    Passing::write(address, value);
    if (address == address_) address_ = kNone;
  }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;
  std::uint32_t address_ = kNone;
};

TEST_CASE("An upload mends a register of which the parity alone fell over, and names none that has changed") {
  Spoiled device;
  const Build build = find_build(device);
  Settings settings = Settings{}.without_proof();
  settings.interlock.by_itself = true;
  const auto upload = [&] { return load(device, build, maps_beside(), settings, false, std::chrono::milliseconds(1)); };
  upload();
  unsigned seed = 0;
  for (int frame = 0; frame < 3; ++frame) good_frame(device, ++seed);
  REQUIRE(read_status(device).safe());
  CHECK_FALSE(upload().stopped);
  good_frame(device, ++seed);  // the place of the table before is free
  const std::uint32_t address = GENERATE(reg::sum_limit::kAddress, reg::interlock::kAddress);
  const bool runs = GENERATE(true, false);
  CAPTURE(address, runs);
  device.spoil(address);
  if (!runs) device.write(reg::control::kAddress, 0);
  const LoadReport report = upload();
  CHECK_FALSE(device.is_spoiled());
  CHECK(report.stopped == runs);
  CHECK(report.changed.empty());
  CHECK(read_status(device).running());
}

TEST_CASE("Another limit on undecidable pixels stops the machine before the upload, which may fail or be killed") {
  Deaf device;
  const Build build = find_build(device);
  Settings settings = Settings{}.without_proof();
  settings.interlock.by_itself = GENERATE(false, true);
  unsigned seed = 0;
  const auto load_at = [&](double percent) {
    settings.undecidable_percent = percent;
    LoadReport report = load(device, build, maps_beside(), settings, false, std::chrono::milliseconds(1));
    good_frame(device, ++seed);
    return report;
  };
  const auto names_limit = [](const LoadReport& report) {
    return std::ranges::find(report.changed, "MAP_UNDECIDABLE_LIMIT") != report.changed.end();
  };
  const auto is_changed = [&](double percent) {
    const LoadReport report = load_at(percent);
    CHECK(report.stopped == names_limit(report));
    return report.stopped;
  };
  CHECK(names_limit(load_at(80)));
  CHECK(is_changed(100));
  CHECK_FALSE(is_changed(100));
  const auto limit = device.read(reg::map_undecidable_limit::kAddress);
  const bool killed = GENERATE(false, true);  // as after a reset nothing is put back
  device.fail_at(reg::map_control::kAddress, killed);
  CHECK_THROWS_AS(load_at(80), DeviceError);
  CHECK((device.read(reg::map_undecidable_limit::kAddress) == limit) != killed);
  CHECK_FALSE(read_status(device).running());
  CHECK_FALSE(load_at(80).stopped);  // it was not running
  CHECK_FALSE(is_changed(80));
}

TEST_CASE("A failed upload to a machine that is stopped is no fault of its first frame") {
  const auto device = make_native_device(find_profile("vga"));
  load(*device, find_build(*device), maps_beside(), Settings{}.without_proof(), false, kNoFrames);
  device->write(reg::control::kAddress, 0);
  auto words = maps_beside().maps[0].table.words();
  words.back() ^= 1U;
  CHECK(upload_words(*device, 5, 2000, words) == 4);
  words.back() ^= 1U;
  CHECK(upload_words(*device, 5, 2000, words) == 0);
  CHECK(read_status(*device).faults().has(Fault::map_crc));
  device->write(reg::control::kAddress, 1);
  good_frame(*device, 1);
  CHECK_FALSE(read_status(*device).frame_faults().has(Fault::map_crc));
}

TEST_CASE("With the test input good frames are not safe") {
  const auto device = make_native_device(find_profile("vga"));
  Settings settings = Settings{}.without_proof();
  settings.interlock.by_itself = true;
  load(*device, find_build(*device), maps_beside(), settings, false, kNoFrames);
  unsigned seed = 0;
  for (const std::uint32_t test_input : {1U, 0U}) {
    CAPTURE(test_input);
    device->write(reg::control::kAddress, 0);
    device->write(reg::mode::kAddress, reg::mode::kTestInput.put(test_input));
    device->write(reg::control::kAddress, 1);
    for (int frame = 0; frame < 3; ++frame) good_frame(*device, ++seed);
    CHECK(reg::frame_status::kSafe.get(device->read(reg::frame_status::kAddress)) == 1);
    CHECK(read_status(*device).safe() == (test_input == 0));
  }
}

TEST_CASE("What is left of an upset in AGREEMENT_LIMITS is not written anew") {
  auto device = make_native_device(find_profile("vga"));
  device->write(reg::agreement_limits::kAddress, reg::agreement_limits::kReset ^ 0x40U);
  Monitor monitor(std::move(device), find_profile("vga"), Settings{});
  monitor.start(kWidth, kHeight, 8);
  const auto changed = monitor.device().read(reg::agreement_limits::kAddress) ^ reg::agreement_limits::kReset;
  CHECK((changed & ~reg::agreement_limits::kHidden.mask()) == 0);
}

TEST_CASE("Threads or instructions that the environment asks for, and that cannot be, are wrong usage") {
  for (const char* const name : {"HOROPTER_THREADS", "HOROPTER_INSTRUCTIONS"}) {
    const char* const before = std::getenv(name);
    const std::string restored = before == nullptr ? "" : before;
    ::setenv(name, "17", 1);
    CHECK_THROWS_AS(NativeDevice(find_profile("vga")), UsageError);
    ::setenv(name, restored.c_str(), 1);
  }
}

TEST_CASE("A build with anything more or other than the profile is refused") {
  const auto change =
      GENERATE(values<Built::Change>({pool_kib(81),
                                      {reg::build_size::kAddress, reg::build_size::kWidth, 639},
                                      {reg::build_size::kAddress, reg::build_size::kHeight, 479},
                                      {reg::build_store::kAddress, reg::build_store::kRows, 64},
                                      {reg::build_window::kAddress, reg::build_window::kDsad, 7},
                                      {reg::build_window::kAddress, reg::build_window::kMajority, 5},
                                      {reg::build_window::kAddress, reg::build_window::kSubsample, 2},
                                      {reg::build_window::kAddress, reg::build_window::kWeightBits, 4},
                                      {reg::build_window::kAddress, reg::build_window::kHypotheses, 0},
                                      {reg::build_window::kAddress, reg::build_window::kCompete, 0},  // but its planes
                                      {reg::build_compete::kAddress, reg::build_compete::kPlanes, 15},
                                      {reg::build_compete::kAddress, reg::build_compete::kSumRows, 5},
                                      {reg::build_compete::kAddress, reg::build_compete::kSumColumns, 7},
                                      {reg::build_compete::kAddress, reg::build_compete::kBallotReach, 5},
                                      {reg::build_compete::kAddress, reg::build_compete::kPaths, 0},
                                      {reg::id::kAddress, {0, 32}, 0},
                                      {reg::version::kAddress, reg::version::kMajor, reg::version::kMajorValue + 1},
                                      {reg::version::kAddress, reg::version::kMinor, reg::version::kMinorValue - 1}}));
  CAPTURE(change.address, change.field.lsb);
  const auto decision = GENERATE(Decision::thesis, Decision::compete);
  CHECK_THROWS_AS(monitor_of({change}, decision), DeviceError);
  // A rule that the profile does not have.
  const Built::Change more{reg::build_window::kAddress, reg::build_window::kCompete, 1};
  CHECK_THROWS_AS(Monitor(std::make_unique<Built>(std::vector{more}, "field"), find_profile("field")), DeviceError);
}

TEST_CASE("Whatever is set in a machine is read back, each time that it is set") {
  const MapSet maps = small_maps(0);
  const auto use = [&](Garbled::Fault fault, std::set<std::uint32_t>* written) {
    Settings settings = Settings{}.without_proof();
    settings.decision = Decision::compete;
    Monitor monitor(std::make_unique<Garbled>(fault, written), find_profile("vga"), settings);
    monitor.start(kWidth, kHeight, 8);
    monitor.upload(1, maps.maps[0].table);
    monitor.select(1);
    monitor.teach(true);
  };
  std::set<std::uint32_t> written;
  use({}, &written);
  for (const auto address :
       {reg::control::kAddress, reg::faults_cameras::kAddress, reg::faults_machine::kAddress,
        reg::map_control::kAddress, reg::map_data::kAddress}) {  // they store nothing, or MAP_STATUS tells
    CHECK(written.erase(address) == 1);
  }
  CHECK(written.size() > 30);
  for (const auto address : written) {
    CAPTURE(register_name(address));
    CHECK_THROWS_WITH(use({address, 0}, nullptr), Catch::Contains(register_name(address) + " reads back as"));
  }
  for (const auto address : {reg::table_select::kAddress, reg::blocks::kAddress}) {
    CHECK_THROWS_WITH(use({address, 1}, nullptr), Catch::Contains(register_name(address) + " reads back as"));
  }
  // The first write is at the start; the second switches the limit off while a pair is shown again; the third, on.
  for (const auto address : {reg::frozen_limit::kAddress, reg::still_limit::kAddress}) {
    Monitor monitor(std::make_unique<Garbled>(Garbled::Fault{address, 2}, nullptr), find_profile("vga"), Settings{});
    monitor.start(kWidth, kHeight, 8);
    monitor.upload(1, maps.maps[0].table);
    monitor.select(1);
    {
      const Monitor::Repeated repeated(monitor);
    }
    CHECK_THROWS_AS(monitor.process(Image(kWidth, kHeight), Image(kWidth, kHeight)), DeviceError);
  }
  // Where one of them cannot be switched off, both are on.
  for (const auto address : {reg::frozen_limit::kAddress, reg::still_limit::kAddress}) {
    Monitor monitor(std::make_unique<Garbled>(Garbled::Fault{address, 1}, nullptr), find_profile("vga"), Settings{});
    monitor.start(kWidth, kHeight, 8);
    CHECK_THROWS_WITH(Monitor::Repeated(monitor), Catch::Contains(register_name(address) + " reads back as"));
    CHECK(monitor.device().read(reg::frozen_limit::kAddress) == static_cast<std::uint32_t>(Settings{}.frozen_limit));
    CHECK(monitor.device().read(reg::still_limit::kAddress) == static_cast<std::uint32_t>(Settings{}.still_limit));
  }
}

TEST_CASE("A machine that contradicts itself is found out") {
  const auto how = GENERATE(Broken::How::count, Broken::How::state, Broken::How::run, Broken::How::sequence,
                            Broken::How::silent, Broken::How::object, Broken::How::no_alarm, Broken::How::seen_alone);
  Settings settings;
  settings.object_px = 40;
  Monitor monitor(std::make_unique<Broken>(how), find_profile("vga"), settings);
  monitor.start(kWidth, kHeight, 8);
  monitor.upload(0, shift_table(find_profile("vga"), kWidth, kHeight, -6, 2));
  monitor.select(0);
  const Image left = textured(kWidth, kHeight, 3);
  CHECK_THROWS_AS(monitor.process(left, moved(left, -6, 2)), DeviceError);
}

TEST_CASE("Runs survive their beat") {
  for (const Run run :
       {Run{0, 0, 0, State::clear}, Run{1079, 5, 1919, State::skin}, Run{3, 65535, 65535, State::unsupervised}}) {
    CHECK(decode_run(encode_run(run)) == run);
  }
}

TEST_CASE("Regions are the connected groups of the skin") {
  Image states(10, 6);
  const auto set = [&](int x, int y) { states.at(x, y) = static_cast<std::uint8_t>(State::skin); };
  set(1, 1);
  set(2, 2);  // touches by its corner
  set(2, 3);
  set(8, 5);
  states.at(5, 5) = static_cast<std::uint8_t>(State::undecidable);
  CHECK(regions_of(states) == std::vector<Region>{{1, 1, 2, 3, 3, 5.0 / 3, 2}, {8, 5, 1, 1, 1, 8, 5}});
  CHECK(regions_of(Image(10, 6)).empty());
  CHECK(state_picture(states).at(2, 2) == 255);
  CHECK(state_picture(states).at(5, 5) == 128);
  CHECK(state_picture(states).at(0, 0) == 0);
}

namespace {

/// A board that opens a session, and then says for ever that it has done nothing yet.
class Babbling : public BytePort {
 public:
  void write(std::span<const std::uint8_t> bytes) override {
    for (const std::uint8_t byte : bytes) {
      const auto words = decoder_.take(byte);
      if (!words) continue;
      number_ = (*words)[0] & 0xFFU;
      if (words->size() == 2 && ((*words)[0] >> 14 & 3U) == 0) {
        answer({(*words)[1], (number_ + 1) % 256 << 8 | number_});
        opened_ = number_;
        return;
      }
      babbles_ = true;
    }
  }
  std::size_t read(std::span<std::uint8_t> bytes, Time end) override {
    if (++reads_ > 1'000'000) throw std::runtime_error("it never gives up");
    now_ += Time(100);
    if (outgoing_.empty() && babbles_) answer({(opened_ + 1) % 256 << 8 | opened_});
    if (outgoing_.empty()) now_ = end;
    const std::size_t count = std::min(bytes.size(), outgoing_.size());
    std::copy_n(outgoing_.begin(), count, bytes.begin());
    outgoing_.erase(outgoing_.begin(), outgoing_.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  Time now() override { return now_; }
  [[nodiscard]] Time time_of(std::size_t bytes) const override { return Time(10 * bytes); }
  [[nodiscard]] Time latency() const override { return std::chrono::milliseconds(10); }

 private:
  void answer(const std::vector<std::uint32_t>& words) { outgoing_ = encode_frame(words); }

  FrameDecoder decoder_;
  std::vector<std::uint8_t> outgoing_;
  std::uint32_t number_ = 0;
  std::uint32_t opened_ = 0;
  bool babbles_ = false;
  int reads_ = 0;
  Time now_{};
};

}  // namespace

TEST_CASE("A board that answers for ever, but does nothing, is given up") {
  SerialLink link(std::make_unique<Babbling>(), "port");
  SECTION("a write") {
    CHECK_THROWS_WITH(link.write(0xCC, std::vector<std::uint32_t>(100, 1)), Catch::Contains("stopped answering"));
  }
  SECTION("a read") { CHECK_THROWS_WITH(link.read(0, 4), Catch::Contains("stopped answering")); }
}

TEST_CASE("The memory-mapped device moves registers and streams") {
  const TemporaryDirectory directory;
  const auto memory = directory.write("registers", std::string(4096, '\0'));
  UioDevice::Paths paths{memory, directory / "left", directory / "right", directory / "states", directory / "runs", 0};
  for (const auto& fifo : {paths.left, paths.right, paths.states, paths.runs})
    REQUIRE(::mkfifo(fifo.c_str(), 0600) == 0);
  UioDevice device(paths, std::chrono::milliseconds(300));
  device.write(reg::width::kAddress, kWidth);
  device.write(reg::height::kAddress, kHeight);
  device.write(reg::build_window::kAddress, reg::build_window::kSubsample.put(1));
  CHECK(device.read(reg::width::kAddress) == kWidth);
  {
    std::ifstream file(memory, std::ios::binary);
    file.seekg(reg::width::kAddress);
    CHECK(file.get() == kWidth);
  }
  CHECK_THROWS_AS(device.read(0x1000), DeviceError);
  CHECK_THROWS_AS(device.read(2), DeviceError);

  // What another program has left.
  std::ofstream(paths.states, std::ios::binary) << std::string(100, '\1');
  std::ofstream(paths.runs, std::ios::binary) << std::string(16, '\1');
  device.write(reg::control::kAddress, 0);

  // The machine: takes both images row by row, gives the difference as states and one run a row.
  const Image left = textured(kWidth, kHeight, 1);
  const Image right = textured(kWidth, kHeight, 2);
  std::thread machine([&] {
    std::ifstream left_in(paths.left, std::ios::binary);
    std::ifstream right_in(paths.right, std::ios::binary);
    std::ofstream states(paths.states, std::ios::binary);
    std::ofstream runs(paths.runs, std::ios::binary);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) states.put(left_in.get() == right_in.get() ? 1 : 0);
      const auto beat = encode_run({y, 0, kWidth - 1, State::clear});
      for (int i = 0; i < 8; ++i) runs.put(static_cast<char>(beat >> (8 * i)));
    }
  });
  device.send(left, right);
  const auto streams = device.receive();
  machine.join();
  REQUIRE(streams.runs.size() == kHeight);
  CHECK(streams.runs.back() == Run{kHeight - 1, 0, kWidth - 1, State::clear});
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) REQUIRE(streams.states.at(x, y) == (left.at(x, y) == right.at(x, y) ? 1 : 0));
  }
  CHECK_THROWS_WITH(device.receive(), Catch::Contains("no frame comes"));

  CHECK_THROWS_WITH(UioDevice(paths), Catch::Contains("is used by another program"));
  paths.registers = directory.write("others", std::string(4096, '\0'));
  paths.states = directory / "none";
  CHECK_THROWS_WITH(UioDevice(paths), Catch::Contains("cannot be opened"));
  paths.registers = directory / "none";
  CHECK_THROWS_WITH(UioDevice(paths), Catch::Contains("cannot be opened"));
}

}  // namespace horopter
