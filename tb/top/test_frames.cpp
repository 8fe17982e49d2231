// SPDX-License-Identifier: Apache-2.0
// Whole frames through horopter_top: bit-exact with the native engine, whatever the handshakes do, and whichever table
// is in use.
#include <Vhoropter_machine_field.h>
#include <Vhoropter_machine_field_roll.h>
#include <Vhoropter_machine_hd.h>
#include <Vhoropter_machine_vga.h>
#include <Vmachine_vga_compete.h>
#include <Vmachine_vga_thesis.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <numbers>
#include <opencv2/imgcodecs.hpp>
#include <regex>
#include <string>

#include "machine_bench.hpp"

namespace horopter::tb {
namespace {

/// From a pixel's arrival to its state, printed and bounded.
template <class Model>
void report_latency(std::string_view profile, Machine<Model>& machine, const Published& published,
                    const MachineOptions& options) {
  const double lines = published.latency / static_cast<double>(options.width);
  const double mhz = reg::build_clock::kKhz.get(machine.read(reg::build_clock::kAddress)) / 1e3;
  std::printf("%.*s, %u px a line: latency %.2f lines from a pixel to its state, LOOKAHEAD %u; %.0f us at %.3f MHz\n",
              static_cast<int>(profile.size()), profile.data(), options.width, lines, options.lookahead,
              published.latency / mhz, mhz);
  CHECK(lines <= options.lookahead + (machine.settings().compete ? 28 : 12));
}

/// Rows of frames that are as wide as the profile's: all of them in a long run.
unsigned rows_of(unsigned all, unsigned some) { return std::getenv("HOROPTER_LONG") != nullptr ? all : some; }

/// `frames` random scenes, every one with gaps and stalls of its own kind.
template <class Model>
void random_frames(std::string_view profile, unsigned width, unsigned height, unsigned frames) {
  Rng rng{profile};
  for (const auto& [gaps, stalls] : {std::pair{0U, 0U}, {30U, 0U}, {0U, 30U}, {20U, 20U}}) {
    CAPTURE(profile, gaps, stalls);
    MachineOptions options{width, height, 32};
    options.gaps_percent = gaps;
    options.stalls_percent = stalls;
    Machine<Model> machine{profile, options};
    CHECK(machine.model().safe_o == 0);
    const int dx = -static_cast<int>(rng.below(20));
    const auto table = with_areas(with_surroundings(plane_table(width, height, dx)), machine.profile(), rng);
    machine.upload(3, 0, table);
    machine.select(3);
    for (unsigned frame = 0; frame < frames / 4; ++frame) {
      CAPTURE(frame);
      const FramePair pair = random_pair(width, height, dx, rng);
      machine.send(pair);
      const Published published = machine.receive();
      machine.check(published, pair, table);
      CHECK(published.slot() == 3);
      // All four states occur in a large frame, or the comparison would say little.
      if (width * height > 100'000) {
        CHECK(published.skin > 0);
        CHECK(published.undecidable > 0);
        CHECK(published.unsupervised > 0);
        CHECK(published.skin + published.undecidable + published.unsupervised < published.states.size());
      }
      if (gaps == 0 && stalls == 0 && frame == 0) {
        report_latency(profile, machine, published, options);
      }
    }
    CHECK_FALSE(machine.pins_ever_equal());
  }
}

TEST_CASE("field: random frames are bit-exact", "[top]") {
  random_frames<Vhoropter_machine_field>("field", 756, rows_of(286, 140), 12);
}
TEST_CASE("vga: random frames are bit-exact", "[top]") {
  random_frames<Vhoropter_machine_vga>("vga", 640, rows_of(480, 160), 12);
}
TEST_CASE("small frames are bit-exact", "[top]") {
  random_frames<Vhoropter_machine_field>("field", 128, 48, 8);
  random_frames<Vhoropter_machine_vga>("vga", 96, 40, 8);
}

/// The rule `compete` and `thesis` in turn, other settings for every frame.
template <class Model>
void changing_rules(std::string_view profile, unsigned width, unsigned height, unsigned frames) {
  Rng rng{profile};
  for (const unsigned pauses : {0U, 20U}) {
    CAPTURE(profile, pauses);
    const MachineOptions options{width, height, 24, false, 0, pauses, pauses};
    Machine<Model> machine{profile, options};
    const auto table = plane_table(width, height, -6, 0.3);
    machine.upload(0, 0, table);
    machine.select(0);
    for (unsigned frame = 0; frame < frames; ++frame) {
      CAPTURE(frame);
      auto& settings = machine.settings();
      settings.compete = frame % 4 != 2;
      for (const auto& f : kCompeteFields)
        settings.*f.setting = 1 + static_cast<int>(rng.below(std::min(f.largest(), 64)));
      machine.write_limits();
      const FramePair pair = random_pair(width, height, -6, rng);
      machine.send(pair);
      const Published published = machine.receive();
      machine.check(published, pair, table);
      if (settings.compete && width * height > 5'000) {
        CHECK(published.skin > 0);
        CHECK(published.skin + published.undecidable + published.unsupervised < published.states.size());
      }
      if (pauses == 0 && frame == 0) report_latency(profile, machine, published, options);
    }
  }
}

TEST_CASE("both rules are bit-exact, their settings changed from frame to frame", "[top][compete]") {
  changing_rules<Vhoropter_machine_vga>("vga", 160, 96, 6);
  changing_rules<Vhoropter_machine_vga>("vga", 33, 16, 6);  // rows shorter than what their pixels wait for
  changing_rules<Vhoropter_machine_hd>("hd", 192, 72, 3);
}

TEST_CASE("compete: a whole frame is bit-exact", "[top][compete]") {
  Rng rng{"compete"};
  const MachineOptions options{640, 480, 32};
  Machine<Vhoropter_machine_vga> machine{"vga", options};
  machine.settings().compete = true;
  machine.write_limits();
  const auto table = plane_table(640, 480, -9, 1);
  machine.upload(0, 0, table);
  machine.select(0);
  const FramePair pair = random_pair(640, 480, -9, rng);
  machine.send(pair);
  const Published published = machine.receive();
  machine.check(published, pair, table);
  report_latency("vga, compete", machine, published, options);
}

TEST_CASE("a profile with one rule keeps it", "[top][compete]") {
  Machine<Vhoropter_machine_field> machine{"field", {128, 32, 8}};
  machine.write(reg::decision::kAddress, 1);
  machine.write(reg::compete::kAddress, 0xFFFFFFFFU);
  CHECK(machine.read(reg::decision::kAddress) == 0);
  CHECK(machine.read(reg::compete::kAddress) == 0);
  CHECK(reg::build_window::kCompete.get(machine.read(reg::build_window::kAddress)) == 0);
}

/// A build of vga with one of its rules decides by that one, whichever is asked for.
template <class Model>
void built_with(bool compete, unsigned width, unsigned height) {
  CAPTURE(compete, width);
  Rng rng{"one rule"};
  Machine<Model> machine{"vga", {width, height, 24, false, 0, 20, 20}};
  const auto window = machine.read(reg::build_window::kAddress);
  CHECK(reg::build_window::kCompete.get(window) == (compete ? 1 : 0));
  CHECK(reg::build_window::kThesis.get(window) == (compete ? 0 : 1));
  CHECK((machine.read(reg::build_compete::kAddress) != 0) == compete);
  const auto table = plane_table(width, height, -6, 0.3);
  machine.upload(0, 0, table);
  machine.select(0);
  for (unsigned frame = 0; frame < 4; ++frame) {
    CAPTURE(frame);
    auto& settings = machine.settings();
    settings.compete = frame % 2 == 0;
    settings.bias = static_cast<int>(rng.below(4));
    settings.boundary = static_cast<int>(rng.below(16));
    settings.sum_limit = static_cast<int>(200 + rng.below(200));
    if (frame == 3) settings.sum_limit = settings.texture_limit = 0x8000;  // too large for their stages
    settings.alarm_limit = static_cast<int>(frame < 2 ? width * height / 20 : width * height);
    machine.write_limits();
    CHECK(machine.read(reg::decision::kAddress) == (compete ? 1 : 0));
    CHECK((machine.read(reg::compete::kAddress) != 0) == compete);
    settings.compete = compete;
    const FramePair pair = random_pair(width, height, -6, rng);
    machine.send(pair);
    const Published published = machine.receive();
    machine.check(published, pair, table);
    if (width * height > 5'000) CHECK(published.alarm() == (frame < 2));
  }
  CHECK_FALSE(machine.pins_ever_equal());
}

TEST_CASE("a build with one rule of two is bit-exact, and keeps it", "[top][compete]") {
  built_with<Vmachine_vga_thesis>(false, 160, 96);
  built_with<Vmachine_vga_compete>(true, 160, 96);
  built_with<Vmachine_vga_thesis>(false, 33, 16);
  built_with<Vmachine_vga_compete>(true, 33, 16);
}

TEST_CASE("a build with a smaller pool refuses what does not fit it", "[top]") {
  Machine<Vmachine_vga_compete> machine{"vga", {128, 64, 16}};
  CHECK(reg::build_store::kPoolKib.get(machine.read(reg::build_store::kAddress)) == 4);
  const auto table = plane_table(128, 64, -4, 0, 3);
  const auto control_words = hls::table::Geometry{128, 64, 3, 3}.control_words();
  const unsigned last = 4096 / 8 - static_cast<unsigned>(control_words) / 2;
  machine.upload(0, last, table);
  CHECK(machine.upload_error() == 0);
  machine.upload(1, last + 1, table);
  CHECK(machine.upload_error() == 3);
  CHECK(machine.read(reg::map_valid::kAddress) == 1);
}

TEST_CASE("hd: whole frames are bit-exact, with gaps and back-pressure, another table for each", "[top]") {
  Rng rng{"hd"};
  Machine<Vhoropter_machine_hd> machine{"hd", {1920, 1080, 32, false, 0, 5, 5}};
  const std::array tables{plane_table(1920, 1080, -12, 0, 5), with_surroundings(plane_table(1920, 1080, -3, 2, 5))};
  machine.upload(0, 0, tables[0]);
  machine.upload(9, 4000, tables[1]);
  for (const std::size_t frame : {0U, 1U}) {
    CAPTURE(frame);
    const unsigned slot = frame == 0 ? 0 : 9;
    machine.select(slot);
    const FramePair pair = random_pair(1920, 1080, frame == 0 ? -12 : -3, rng);
    machine.send(pair);
    const Published published = machine.receive();
    machine.check(published, pair, tables[frame]);
    CHECK(published.slot() == slot);
  }
}

TEST_CASE("hd: latency of rows as long as they can be", "[top]") {
  Rng rng{"hd"};
  const MachineOptions options{1920, 64, 32};
  Machine<Vhoropter_machine_hd> machine{"hd", options};
  const auto table = plane_table(1920, 64, -12, 0, 5);
  machine.upload(0, 0, table);
  machine.select(0);
  const FramePair pair = random_pair(1920, 64, -12, rng);
  machine.send(pair);
  const Published published = machine.receive();
  machine.check(published, pair, table);
  report_latency("hd", machine, published, options);
}

constexpr const char* kSamples = "/usr/share/doc/opencv-doc/examples/data/";

/// The first `width` by `height` pixels of an image of OpenCV's examples; empty if they are not installed.
Image sample(const std::string& name, unsigned width, unsigned height) {
  const cv::Mat image = cv::imread(kSamples + name, cv::IMREAD_GRAYSCALE);
  if (image.empty()) {
    std::cout << "skipped: no " << kSamples << name << " (package opencv-doc)\n";
    return {};
  }
  REQUIRE(image.cols >= static_cast<int>(width));
  REQUIRE(image.rows >= static_cast<int>(height));
  Image result{width, height};
  for (unsigned y = 0; y < height; ++y) {
    for (unsigned x = 0; x < width; ++x) {
      result.at(x, y) = image.at<std::uint8_t>(static_cast<int>(y), static_cast<int>(x));
    }
  }
  return result;
}

template <class Model>
void real_pairs(std::string_view profile, unsigned width, unsigned height) {
  Machine<Model> machine{profile, {width, height, 32, false, 0, 10, 10}};
  const auto table = plane_table(width, height, -30, 8);
  machine.upload(1, 0, table);
  machine.select(1);
  for (const int number : {1, 2, 5}) {
    CAPTURE(profile, number);
    const std::string name = "0" + std::to_string(number) + ".jpg";
    const FramePair pair{sample("left" + name, width, height), sample("right" + name, width, height)};
    if (pair.left.pixels.empty()) return;
    machine.send(pair);
    machine.check(machine.receive(), pair, table);
  }
}
TEST_CASE("real pairs are bit-exact", "[top]") {
  real_pairs<Vhoropter_machine_vga>("vga", 640, 480);
  real_pairs<Vhoropter_machine_field>("field", 640, 286);
}
TEST_CASE("hd: a real pair is bit-exact, with both rules", "[top]") {
  const unsigned rows = rows_of(1080, 640);
  const FramePair pair{sample("aloeL.jpg", 1280, rows), sample("aloeR.jpg", 1280, rows)};
  if (pair.left.pixels.empty()) return;
  const auto table = with_surroundings(plane_table(1280, rows, -60, 2, 5));
  for (const bool compete : {false, true}) {
    CAPTURE(compete);
    Machine<Vhoropter_machine_hd> machine{"hd", {1280, rows, 32}};
    machine.settings().compete = compete ? 1 : 0;
    machine.write_limits();
    machine.upload(1, 0, table);
    machine.select(1);
    machine.send(pair);
    const Published published = machine.receive();
    machine.check(published, pair, table);
    CHECK(published.skin > 0);
    CHECK(published.undecidable > 0);
  }
}

/// Turned about the middle of a frame of 756×572 px.
struct Turn {
  double cosine, sine;
  explicit Turn(double angle_deg)
      : cosine(std::cos(angle_deg * std::numbers::pi / 180)), sine(std::sin(angle_deg * std::numbers::pi / 180)) {}
  std::pair<double, double> operator()(double x, double y) const {
    const double dx = x - 377.5, dy = y - 285.5;
    return {377.5 + cosine * dx - sine * dy, 285.5 + sine * dx + cosine * dy};
  }
};

/// What a camera sees that is turned by it; black beyond the image.
Image seen_turned(const Image& image, double angle_deg) {
  Image result{image.width, image.height};
  const Turn back(-angle_deg);
  for (unsigned y = 0; y < image.height; ++y) {
    for (unsigned x = 0; x < image.width; ++x) {
      const auto [sx, sy] = back(x, y);
      if (sx < 0 || sy < 0 || sx > image.width - 2 || sy > image.height - 2) continue;
      const auto ix = static_cast<unsigned>(sx), iy = static_cast<unsigned>(sy);
      const double u = sx - ix, v = sy - iy;
      result.at(x, y) =
          static_cast<std::uint8_t>(std::lround((1 - v) * ((1 - u) * image.at(ix, iy) + u * image.at(ix + 1, iy)) +
                                                v * ((1 - u) * image.at(ix, iy + 1) + u * image.at(ix + 1, iy + 1))));
    }
  }
  return result;
}

/// Every second row.
Image field_of(const Image& frame, unsigned parity) {
  Image field{frame.width, frame.height / 2};
  for (unsigned y = 0; y < field.height; ++y) {
    for (unsigned x = 0; x < field.width; ++x) field.at(x, y) = frame.at(x, 2 * y + parity);
  }
  return field;
}

TEST_CASE("field_roll: cameras rolled by 20 degrees, and by as much as its ring holds, are bit-exact", "[top]") {
  const Image left = sample("aloeL.jpg", 756, 572);
  if (left.pixels.empty()) return;
  for (const double angle_deg : {20.0, -36.0}) {
    CAPTURE(angle_deg);
    const Image right = seen_turned(left, angle_deg);
    const MachineOptions options{756, 286, angle_deg == 20 ? 75U : 128U};
    Machine<Vhoropter_machine_field_roll> machine{"field_roll", options};
    const Turn turn(angle_deg);
    for (const unsigned parity : {0U, 1U}) {
      const auto table = make_table(756, 286, 5, 5, [&](double x, double y) {
        const auto [sx, sy] = turn(x, 2 * y + parity);
        return std::pair{sx, (sy - parity) / 2};
      });
      machine.upload(parity, parity * 1000, table);
      machine.select(parity);
      const FramePair pair{field_of(left, parity), field_of(right, parity)};
      machine.send(pair);
      const Published published = machine.receive();
      machine.check(published, pair, table);
      CHECK(machine.read(reg::frame_misses::kAddress) == 0);
      const auto decided =
          static_cast<double>(published.states.size() - published.undecidable - published.unsupervised);
      CHECK(published.skin >= 0.9 * decided);
      CHECK(decided >= 0.2 * static_cast<double>(published.states.size()));
      if (parity == 0) {
        std::printf("rolled by %.0f deg: %.1f %% of the image is decided, %.1f %% of that in the skin\n", angle_deg,
                    100 * decided / static_cast<double>(published.states.size()), 100 * published.skin / decided);
        report_latency("field_roll", machine, published, options);
      }
    }
  }
}

// In the shape of a field; one more row or column pair does not fit.
TEST_CASE("the thesis's dense table, at the largest size whose table the pool of field_roll holds", "[top]") {
  Rng rng{"dense"};
  constexpr unsigned kWidth = 230, kHeight = 87;
  const auto bytes = [](unsigned width, unsigned height) {
    return 4 * hls::table::Geometry{static_cast<int>(width), static_cast<int>(height), 0, 0}.control_words();
  };
  const auto pool_bytes = static_cast<std::size_t>(hls::profiles::field_roll.pool_bytes);
  REQUIRE(bytes(kWidth, kHeight) <= pool_bytes);
  REQUIRE(bytes(kWidth + 2, kHeight) > pool_bytes);
  REQUIRE(bytes(kWidth, kHeight + 1) > pool_bytes);
  Machine<Vhoropter_machine_field_roll> machine{"field_roll", {kWidth, kHeight, 60, false, 0, 10, 10}};
  // No grid can hold it: every pixel has a source of its own, some have none.
  const auto table = make_table(kWidth, kHeight, 0, 0, [&](double x, double y) {
    const double jitter = 6 * static_cast<double>(rng.below(1000)) / 1000;
    if (rng.below(300) == 0) return std::pair{-500.0, -500.0};
    return std::pair{0.94 * x - 0.34 * y + 20 + jitter, 0.34 * x + 0.94 * y - 40 + jitter};
  });
  machine.upload(0, 0, table);
  REQUIRE(machine.upload_error() == 0);
  machine.select(0);
  for (int frame = 0; frame < 3; ++frame) {
    CAPTURE(frame);
    const FramePair pair = random_pair(kWidth, kHeight, 0, rng);
    machine.send(pair);
    const Published published = machine.receive();
    machine.check(published, pair, table);
    CHECK(published.unsupervised < published.states.size());
  }
}

/// The lowest routed clocks of profiles field…, on FPGAs that hold the whole machine, as docs/hardware.md has them; by line.
std::map<std::string, double> routed_field_mhz() {
  std::ifstream page(HOROPTER_SOURCE_DIR "/docs/hardware.md");
  std::map<std::string, double> found;
  const std::regex row(R"(\| (`field\w*`, `thesis` \| ECP5[^|]*)\|.*\| ([\d.]+), ([\d.]+) of \d+ \|)");
  for (std::string line; std::getline(page, line);) {
    std::smatch match;
    if (std::regex_match(line, match, row)) found[match[1]] = std::min(std::stod(match[2]), std::stod(match[3]));
  }
  return found;
}

TEST_CASE("field: 50 fields a second of 756x286, at the clock of the profile and at the routed ones", "[top]") {
  Rng rng{"rate"};
  Machine<Vhoropter_machine_field> machine{"field", {756, 286, 32}};
  const auto table = plane_table(756, 286, -8);
  machine.upload(0, 0, table);
  machine.select(0);
  const FramePair pair = random_pair(756, 286, -8, rng);
  for (int field = 0; field < 3; ++field) machine.send(pair);
  machine.receive();
  const std::uint64_t first = machine.simulation().cycle();
  machine.receive();
  const auto clocks = static_cast<double>(machine.simulation().cycle() - first);
  const double fields_per_s = 1e3 * hls::profiles::field.clock_khz / clocks;
  std::printf("field: %.0f clocks a field of 756x286; %.1f fields a second at %.3f MHz\n", clocks, fields_per_s,
              hls::profiles::field.clock_khz / 1e3);
  CHECK(fields_per_s >= 50);
  const auto routed = routed_field_mhz();
  CHECK_FALSE(routed.empty());
  for (const auto& [what, mhz] : routed) {
    CAPTURE(what, mhz);
    CHECK(1e6 * mhz / clocks >= 50);
    CHECK(1e3 * mhz >= hls::profiles::field.clock_khz);
  }
}

TEST_CASE("a table uploaded while another is in use changes the frames from its switch on, and no other", "[top]") {
  Rng rng{"switch"};
  Machine<Vhoropter_machine_vga> machine{"vga", {128, 64, 16}};
  const auto first = plane_table(128, 64, -4);
  const auto second = plane_table(128, 64, -9, 2);
  machine.upload(0, 0, first);
  machine.select(0);
  std::vector<FramePair> pairs;
  for (int i = 0; i < 6; ++i) pairs.push_back(random_pair(128, 64, i < 3 ? -4 : -9, rng));
  // Frame 1 and 2 run while the upload goes on, in parts.
  machine.send(pairs[0]);
  machine.check(machine.receive(), pairs[0], first);
  machine.send(pairs[1]);
  machine.upload_part(7, 200, second, 0, second.size() / 2);
  machine.check(machine.receive(), pairs[1], first);
  machine.send(pairs[2]);
  machine.upload_part(7, 200, second, second.size() / 2, second.size());
  CHECK(machine.upload_error() == 0);
  // Selected when frame 2 has begun to come out: it takes effect with frame 3.
  machine.simulation().run_until([&] { return !machine.states().beats().empty(); }, 100'000, "a state of frame 2");
  machine.select(7);
  machine.check(machine.receive(), pairs[2], first);
  for (int i = 3; i < 6; ++i) {
    machine.send(pairs[static_cast<std::size_t>(i)]);
    const Published p = machine.receive();
    machine.check(p, pairs[static_cast<std::size_t>(i)], second);
    CHECK(p.slot() == 7);
  }
}

/// 15 tables in the pool, another one for every frame.
void fifteen_tables(unsigned width, unsigned height, unsigned frames) {
  Rng rng{"tables"};
  Machine<Vhoropter_machine_field> machine{"field", {width, height, 8}};
  std::vector<std::vector<std::uint32_t>> tables;
  unsigned base = 0;
  for (unsigned slot = 0; slot < 15; ++slot) {
    tables.push_back(with_areas(plane_table(width, height, -static_cast<int>(slot)), machine.profile(), rng));
    machine.upload(slot, base, tables.back());
    REQUIRE(machine.upload_error() == 0);
    base += static_cast<unsigned>(tables.back().size() - 4) / 2;
  }
  for (unsigned n = 0; n < frames; ++n) {
    const unsigned slot = n * 4 % 15;
    const FramePair pair = random_pair(width, height, -static_cast<int>(slot), rng);
    machine.select(slot);
    machine.send(pair);
    const Published p = machine.receive();
    CAPTURE(n, slot);
    CHECK(p.slot() == slot);
    machine.check(p, pair, tables[slot]);
  }
}
TEST_CASE("15 tables, another one for every frame", "[top]") {
  fifteen_tables(128, 32, 30);
  fifteen_tables(756, rows_of(286, 80), 15);
}

/// Tables with spans and without in turn, at whatever place of the pool.
template <class Model>
void tables_with_spans(std::string_view profile, unsigned width, unsigned height, unsigned frames, unsigned pauses) {
  Rng rng{"spans"};
  CAPTURE(profile, width, height, pauses);
  Machine<Model> machine{profile, {width, height, 24, false, 0, pauses, pauses}};
  const unsigned spacing_log2 = width > 1000 ? 5 : 4;
  const auto plain = with_surroundings(plane_table(width, height, -6, 0.3, spacing_log2));
  const std::array tables{with_spans(plain, rng), plain,
                          with_spans(plane_table(width, height, -6, 0, spacing_log2), rng),
                          with_areas(with_spans(plain, rng), machine.profile(), rng)};
  unsigned base = 3;
  for (unsigned slot = 0; slot < tables.size(); ++slot) {
    machine.upload(slot, base, tables[slot]);
    REQUIRE(machine.upload_error() == 0);
    const auto words64 = static_cast<unsigned>(hls::table::read(tables[slot]).pool_words() / 2);
    machine.write(reg::map_slot::kAddress, slot);
    CHECK(machine.read(reg::map_extent::kAddress) == ((base + words64) << 16 | base));
    base += words64;
  }
  unsigned with_spans_unsupervised = 0;
  for (unsigned n = 0; n < frames; ++n) {
    const unsigned slot = n % tables.size();
    CAPTURE(n, slot);
    const FramePair pair = random_pair(width, height, -6, rng);
    machine.select(slot);
    machine.send(pair);
    const Published p = machine.receive();
    machine.check(p, pair, tables[slot]);
    if (slot == 1) CHECK(p.unsupervised < with_spans_unsupervised);
    with_spans_unsupervised = p.unsupervised;
  }
}

TEST_CASE("tables with spans are bit-exact", "[top]") {
  tables_with_spans<Vhoropter_machine_field>("field", 128, 49, 6, 20);
  tables_with_spans<Vhoropter_machine_field>("field", 756, 286, 2, 0);
  tables_with_spans<Vhoropter_machine_vga>("vga", 131, 64, 6, 0);
  tables_with_spans<Vhoropter_machine_hd>("hd", 192, 73, 6, 20);
  tables_with_spans<Vhoropter_machine_hd>("hd", 1920, 128, 3, 0);
}

TEST_CASE("a camera that stops right after its last pixel hides nothing of that frame", "[top]") {
  Rng rng{"stops"};
  Machine<Vhoropter_machine_vga> machine{"vga", {96, 64, 16, false, 50'000}};
  const auto table = plane_table(96, 64, -3);
  machine.upload(0, 0, table);
  machine.select(0);
  machine.settings().alarm_limit = 10;
  machine.write_limits();
  const FramePair pair = random_pair(96, 64, -3, rng);
  machine.send(pair);
  const Published p = machine.receive();  // no further pixel ever comes
  machine.check(p, pair, table);
  CHECK(p.alarm());
  CHECK_FALSE(p.safe_pin);
}

/// Nothing is on the skin but an object of 70×70 px.
template <class Model>
void early_alarm(const std::string& profile, bool compete, unsigned width, unsigned height) {
  CAPTURE(profile, compete);
  constexpr int kShift_px = -6;
  Rng rng{"early"};
  Machine<Model> machine{profile, {width, height, 16, false}};
  const auto table = plane_table(width, height, kShift_px);
  machine.upload(0, 0, table);
  machine.select(0);
  machine.settings().object_limit = 500;
  machine.settings().compete = compete ? 1 : 0;
  machine.write_limits();
  const auto scene = [&](bool object) {
    FramePair pair{textured_image(width, height, rng), textured_image(width, height, rng)};
    for (unsigned y = 20; object && y < 90; ++y) {
      for (unsigned x = 60; x < 130; ++x) {
        pair.left.at(x, y) = pair.right.at(static_cast<unsigned>(static_cast<int>(x) + kShift_px), y);
      }
    }
    return pair;
  };
  for (int frame = 0; frame < 3; ++frame) {
    const FramePair pair = scene(false);
    machine.send(pair);
    machine.check(machine.receive(), pair, table);
  }
  REQUIRE(machine.model().safe_o == 1);
  const FramePair pair = scene(true);
  const native::FrameResult whole = machine.expected(pair, table);
  CHECK(whole.alarm);
  const native::Object largest = whole.largest_object();
  unsigned row = 0;  // in which it reaches the limit
  for (int pixels = 0; row < height && pixels < 500; ++row) {
    const auto begin = whole.states.begin() + row * static_cast<std::ptrdiff_t>(whole.width);
    pixels += static_cast<int>(std::count(begin + largest.left, begin + largest.right + 1, 1));
  }
  machine.send(pair);
  machine.simulation().run_until([&] { return machine.model().safe_o == 0; }, 40 * width * height, "safe_o low");
  const std::size_t rows = machine.states().beats().size() / static_cast<unsigned>(whole.width);
  CHECK(rows <= row + 2);
  CHECK(rows + 10 < height);  // long before the frame's end
  const Published p = machine.receive();
  machine.check(p, pair, table);
  CHECK(p.alarm());
  CHECK(p.object[0] == static_cast<std::uint32_t>(largest.pixels));
  for (int frame = 0; frame < 3; ++frame) {
    const FramePair clear = scene(false);
    machine.send(clear);
    machine.check(machine.receive(), clear, table);
  }
  CHECK(machine.model().safe_o == 1);
}

TEST_CASE("an object is an alarm before its frame has ended", "[top]") {
  early_alarm<Vmachine_vga_thesis>("vga", false, 192, 120);
  early_alarm<Vmachine_vga_compete>("vga", true, 192, 120);
  early_alarm<Vhoropter_machine_field>("field", false, 384, 120);
}

/// Tables with other areas, and without, in turn: the alarm by the area of the largest object, or just not.
template <class Model>
void alarm_by_area(const std::string& profile, bool compete, unsigned width, unsigned height, unsigned pauses = 0) {
  CAPTURE(profile, compete, width, height);
  Rng rng{"area"};
  Machine<Model> machine{profile, {width, height, 16, false, 0, pauses, pauses}};
  machine.settings().compete = compete ? 1 : 0;
  machine.settings().alarm_limit = static_cast<int>(width * height);
  const auto plain = plane_table(width, height, -6, 0, width > 1000 ? 5 : 4);
  const std::array tables{with_areas(plain, machine.profile(), rng), plain, with_areas(plain, machine.profile(), rng),
                          with_areas(plain, machine.profile(), rng)};
  unsigned base = 1;
  for (unsigned slot = 0; slot < tables.size(); ++slot) {
    machine.upload(slot, base, tables[slot]);
    REQUIRE(machine.upload_error() == 0);
    base += static_cast<unsigned>(hls::table::read(tables[slot]).pool_words() / 2);
  }
  unsigned alarms = 0, close = 0;
  for (unsigned n = 0; n < 8; ++n) {
    const unsigned slot = n * 3 % 4;
    CAPTURE(n, slot);
    const FramePair pair = random_pair(width, height, -6, rng);
    machine.settings().object_area_limit = -1;
    std::uint32_t largest = 0;
    for (const auto& object : machine.expected(pair, tables[slot]).objects) largest = std::max(largest, object.area);
    const bool reached = rng.chance(2);
    const bool saturated = largest == 0xFFFFFFFFU;  // as a limit it means never
    machine.settings().object_area_limit = static_cast<int>(largest + (reached || saturated ? 0 : 1));
    machine.write_limits();
    machine.select(slot);
    machine.send(pair);
    const Published p = machine.receive();
    machine.check(p, pair, tables[slot]);
    if (largest == 0) continue;
    CHECK(p.alarm() == (reached && !saturated));
    alarms += p.alarm() ? 1 : 0;
    close += p.alarm() ? 0 : 1;
    CHECK(p.object[3] > 0);
  }
  CHECK(alarms >= 2);
  CHECK(close >= 2);
}

TEST_CASE("an alarm by an object's area alone, with another table for every frame", "[top]") {
  alarm_by_area<Vhoropter_machine_field>("field", false, 756, rows_of(286, 100));
  alarm_by_area<Vhoropter_machine_field>("field", false, 132, 40, 20);
  alarm_by_area<Vmachine_vga_thesis>("vga", false, 640, rows_of(240, 100));
  alarm_by_area<Vhoropter_machine_vga>("vga", true, 161, 97, 20);
  alarm_by_area<Vhoropter_machine_hd>("hd", false, 200, 120, 20);
  alarm_by_area<Vhoropter_machine_hd>("hd", true, 1920, 100);
}

/// Many small objects, more than a slow reader takes: some are lost, and counted; the others are as they were.
template <class Model>
void slow_reader_of_objects(const std::string& profile, bool compete, unsigned width, unsigned height) {
  CAPTURE(profile, compete);
  Rng rng{"reader"};
  Machine<Model> machine{profile, {width, height, 16, false}};
  machine.settings().compete = compete ? 1 : 0;
  machine.settings().alarm_limit = 0;  // the whole skin is one
  machine.write_limits();
  const auto table = with_areas(plane_table(width, height, -6), machine.profile(), rng);
  machine.upload(0, 0, table);
  machine.select(0);
  const auto scene = [&] {
    FramePair pair = random_pair(width, height, -6, rng);
    for (unsigned y = 0; y < height; ++y) {
      for (unsigned x = 0; x < width; ++x) {
        const bool on_skin = x / 24 % 2 == 0 && y / 22 % 2 == 0;
        pair.right.at(x, y) = static_cast<std::uint8_t>(rng.below(256));
        pair.left.at(x, y) = static_cast<std::uint8_t>(rng.below(256));
        if (on_skin && x >= 6) pair.left.at(x, y) = pair.right.at(x - 6, y);
      }
    }
    return pair;
  };
  unsigned lost = 0;
  for (unsigned frame = 0; frame < 4; ++frame) {
    CAPTURE(frame);
    // It takes nothing until the frame is over, then all that waits.
    const bool waits = frame % 2 == 0;
    if (waits) machine.objects().set_pace(Pace::random(0, 1));
    const FramePair pair = scene();
    const native::FrameResult whole = machine.expected(pair, table);
    REQUIRE_FALSE(whole.object_overflow);
    REQUIRE(whole.objects.size() > 20);
    const unsigned before = machine.frames_done();
    machine.send(pair);
    const std::uint64_t clocks = 40ULL * width * height;
    machine.simulation().run_until([&] { return machine.frames_done() > before; }, clocks, "the frame");
    if (waits) CHECK(machine.objects().beats().empty());
    machine.objects().set_pace({});
    const Published p = machine.receive();
    machine.check(p, pair, table);
    CHECK(p.alarm());
    CHECK((p.objects_lost > 0) == waits);
    lost += p.objects_lost;
    // What was sent is what came first.
    REQUIRE(p.objects.size() <= whole.objects.size());
    CHECK(std::equal(p.objects.begin(), p.objects.end(), whole.objects.begin()));
  }
  CHECK(lost > 0);
  // A frame whose last beat is not taken before the next one ends: nothing is sent of that, and the numbers tell.
  machine.objects().set_pace(Pace::random(0, 1));
  const unsigned before = machine.frames_done();
  for (int frame = 0; frame < 2; ++frame) machine.send(scene());
  machine.simulation().run_until([&] { return machine.frames_done() == before + 2; }, 80ULL * width * height,
                                 "2 frames");
  machine.settle();
  machine.objects().set_pace({});
  machine.settle();
  const auto beats = machine.objects().take();
  REQUIRE_FALSE(beats.empty());
  CHECK(std::ranges::count_if(beats, [](const auto& beat) { return beat.last; }) == 1);
  CHECK(beats.back().last);
  CHECK(bits_of(beats.back().data, 48, 32) == before + 1);
  machine.forget();
  const FramePair pair = scene();
  machine.send(pair);
  const Published p = machine.receive();
  machine.check(p, pair, table);
  CHECK(p.objects_lost == 0);
}

TEST_CASE("objects leave as a stream; a reader that is too slow loses some, and neither frames nor alarms", "[top]") {
  slow_reader_of_objects<Vhoropter_machine_field>("field", false, 480, 200);
  slow_reader_of_objects<Vmachine_vga_compete>("vga", true, 320, 200);
  slow_reader_of_objects<Vhoropter_machine_hd>("hd", false, 320, 200);
}

/// Taught, not watched and watched in turn, by one rule or by both, every frame as the native engine has it.
template <class Model>
void went_blind(const std::string& profile, bool compete, unsigned width, unsigned height, bool both = false) {
  CAPTURE(profile, compete, both);
  Rng rng{"blind"};
  MachineOptions options{width, height, 16, false};
  options.gaps_percent = options.stalls_percent = 20;
  Machine<Model> machine{profile, options};
  const auto table = with_areas(plane_table(width, height, -6), machine.profile(), rng);
  machine.upload(0, 0, table);
  machine.select(0);
  auto& settings = machine.settings();
  settings.compete = compete ? 1 : 0;
  settings.object_limit = 400;
  unsigned blind = 0, seeing = 0, teaching = 0, dim = 0, forgotten = 0, kept = 0, frames_taught = 0;
  bool taught_before = false;
  for (unsigned frame = 0; frame < 24; ++frame) {
    CAPTURE(frame);
    settings.teach = frame < 3 || rng.chance(3) ? 1 : 0;
    const bool may_alarm = rng.chance(6);
    settings.object_limit = may_alarm ? 400 : 100'000;
    settings.alarm_limit = may_alarm ? 0 : 100'000;
    settings.watch = frame < 6 || !rng.chance(3) ? 1 : 0;
    settings.blind_margin = static_cast<int>(rng.below(24));
    settings.dim = rng.chance(3) ? 0 : 1;
    if (both && rng.chance(6)) settings.compete = 1 - settings.compete;
    const bool forgets = machine.frame_settings().forget != 0;
    dim += machine.frame_settings().dim != 0 ? 1 : 0;
    machine.write_limits();
    const FramePair pair = random_pair(width, height, -6, rng);
    machine.send(pair);
    const Published p = machine.receive();
    machine.check(p, pair, table);
    blind += p.blind != 0 ? 1 : 0;
    seeing += p.blind == 0 && settings.watch != 0 && settings.teach == 0 ? 1 : 0;
    teaching += settings.teach != 0 ? 1 : 0;
    if (settings.teach != 0) CHECK_FALSE(p.safe_pin);
    // Frames before this one, which is over.
    const unsigned taught = machine.read(reg::taught::kAddress);
    CHECK(taught == (forgets || (settings.teach != 0 && !taught_before) ? 0 : frames_taught + (taught_before ? 1 : 0)));
    kept += taught > frames_taught ? 1 : 0;
    frames_taught = taught;
    taught_before = settings.teach != 0;
    forgotten += forgets ? 1 : 0;
  }
  CHECK(blind >= 3);
  CHECK(teaching >= 3);
  CHECK(dim >= 2);
  CHECK(forgotten >= 1);
  CHECK(kept >= 1);
  // Before anything was taught, everything could be decided.
  machine.configure();
  settings.teach = 0;
  settings.watch = 1;
  settings.blind_margin = 0;
  settings.object_limit = 400;
  settings.alarm_limit = 0;
  machine.write_limits();
  FramePair pair = random_pair(width, height, -6, rng);
  for (unsigned y = 16; y < height; ++y) {
    for (unsigned x = 0; x < width / 2; ++x) pair.left.at(x, y) = pair.right.at(x, y) = 90;
  }
  machine.select(0);
  machine.send(pair);
  const Published p = machine.receive();
  CHECK(p.blind == p.undecidable);
  CHECK(p.alarm());
}

TEST_CASE("what went blind counts as an object, as natively", "[top]") {
  went_blind<Vmachine_vga_thesis>("vga", false, 150, 90);
  went_blind<Vmachine_vga_compete>("vga", true, 150, 90);
  went_blind<Vhoropter_machine_field>("field", false, 300, 83);
  went_blind<Vhoropter_machine_vga>("vga", false, 150, 90, true);
}

}  // namespace
}  // namespace horopter::tb
