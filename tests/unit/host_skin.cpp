// SPDX-License-Identifier: Apache-2.0
// Skins and mapping tables.
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "horopter/base/crc32.hpp"
#include "horopter/base/error.hpp"
#include "horopter/map/map.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/map/support.hpp"
#include "horopter/skin/skin.hpp"
#include "horopter/skin/skin_file.hpp"
#include "host_temporary.hpp"
#include "table_11_1.hpp"

namespace horopter {
namespace {

constexpr Matrix3 kTilted{1.02, 0.03, -24.0, -0.01, 0.98, 6.0, 2e-5, -1e-5, 1.0};

SkinFile skin_of(const Matrix3& matrix, Point visible = {320, 240}) {
  SkinFile file;
  file.path = "skin.yaml";
  file.skin = std::make_unique<HomographySkin>(matrix, visible);
  return file;
}

std::string error_of(const TemporaryDirectory& directory, const std::string& yaml) {
  try {
    load_skin(directory.write("skin.yaml", yaml), {320, 240});
  } catch (const FileError& error) {
    return std::string(error.what()).substr((directory / "").string().size());
  }
  FAIL("no error for " << yaml);
  return {};
}

}  // namespace

TEST_CASE("A homography is read from YAML") {
  const TemporaryDirectory directory;
  const auto file = load_skin(directory.write("skin.yaml",
                                              "surface:\n  type: homography\n  matrix:\n"
                                              "    - [1, 0, -20]\n    - [0, 1, 5]\n    - [0, 0, 1]\n"),
                              {320, 240});
  const auto source = file.skin->source({100, 50});
  REQUIRE(source);
  CHECK(source->x == Approx(80));
  CHECK(source->y == Approx(55));
  CHECK(file.skin->type() == "homography");
}

TEST_CASE("Correspondences give the least squares homography") {
  const TemporaryDirectory directory;
  const HomographySkin truth(kTilted);
  const std::uint32_t seed = Catch::rngSeed();
  CAPTURE(seed);
  std::mt19937 random(seed);
  const double noise_px = GENERATE(0.0, 0.3);
  std::normal_distribution<double> noise(0, 1);
  std::string yaml = "surface:\n  type: correspondences\n  points:\n";
  for (int i = 0; i < 54; ++i) {
    const int row = i / 9;
    const Point left{120.0 + 35 * (i % 9), 100.0 + 40 * row};
    const Point right = *truth.source(left);
    yaml += "  - {left: [" + std::to_string(left.x) + ", " + std::to_string(left.y) + "], right: [" +
            std::to_string(right.x + noise_px * noise(random)) + ", " +
            std::to_string(right.y + noise_px * noise(random)) + "]}\n";
  }
  const auto file = load_skin(directory.write("skin.yaml", yaml), {320, 240});
  REQUIRE(file.fit);
  CHECK(file.fit->rms_px < (noise_px > 0 ? 0.6 : 1e-5));
  for (const Point p : {Point{130, 110}, Point{300, 250}, Point{390, 290}}) {
    const Point fitted = *file.skin->source(p);
    const Point expected = *truth.source(p);
    CHECK(std::hypot(fitted.x - expected.x, fitted.y - expected.y) < (noise_px > 0 ? 0.5 : 1e-4));
  }
}

TEST_CASE("Four points are enough, and met exactly") {
  const HomographySkin truth(kTilted);
  std::vector<Correspondence> points;
  for (const Point p : {Point{10, 20}, Point{600, 30}, Point{590, 400}, Point{20, 470}}) {
    points.push_back({p, *truth.source(p)});
  }
  CHECK(fit_homography(points).largest_px < 1e-8);
}

TEST_CASE("Beyond its points a fit goes astray, by as much as it is said to") {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.5);
  const HomographySkin truth(kTilted);
  std::vector<Correspondence> points;
  for (const Point p : {Point{100, 90}, Point{500, 110}, Point{480, 390}, Point{90, 400}, Point{300, 240}}) {
    points.push_back({p, *truth.source(p)});
  }
  const std::vector<Point> left{{300, 240}, {0, 0}, {639, 479}};
  const std::vector<double> said_px = fit_deviations_px(points, left, 0.5);
  constexpr int kTrials = 400;
  for (std::size_t i = 0; i < left.size(); ++i) {
    double x = 0, y = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      std::vector<Correspondence> wrong = points;
      for (Correspondence& c : wrong) c.right = {c.right.x + noise(random), c.right.y + noise(random)};
      const Point source = *HomographySkin(fit_homography(wrong).matrix, left[0]).source(left[i]);
      const Point right = *truth.source(left[i]);
      x += std::pow(source.x - right.x, 2) / kTrials;
      y += std::pow(source.y - right.y, 2) / kTrials;
    }
    CHECK(std::sqrt(std::max(x, y)) == Approx(said_px[i]).epsilon(0.15));
  }
  CHECK(said_px[1] > 2 * said_px[0]);
}

TEST_CASE("Points that do not determine a homography are refused") {
  std::vector<Correspondence> points;
  SECTION("three") { points = {{{0, 0}, {0, 0}}, {{9, 0}, {9, 0}}, {{0, 9}, {0, 9}}}; }
  SECTION("collinear") {
    for (int i = 0; i < 6; ++i) points.push_back({{10.0 * i, 20.0 * i}, {10.0 * i - 5, 20.0 * i}});
  }
  SECTION("all but one collinear") {
    for (int i = 0; i < 6; ++i) points.push_back({{10.0 * i, 20.0 * i}, {10.0 * i - 5, 20.0 * i}});
    points.push_back({{100, 0}, {95, 0}});
  }
  SECTION("one point, again and again") { points.assign(5, {{3, 4}, {5, 6}}); }
  SECTION("a line in the right image") {
    for (int i = 0; i < 9; ++i) {
      const int row = i / 3;
      points.push_back({{i % 3 * 50.0, row * 50.0}, {i % 3 * 50.0, 7}});
    }
  }
  SECTION("not finite") { points = {{{0, 0}, {0, 0}}, {{9, 0}, {9, 0}}, {{0, 9}, {0, 9}}, {{9, 9}, {NAN, 9}}}; }
  CHECK_THROWS_AS(fit_homography(points), std::invalid_argument);
}

TEST_CASE("Bad skin files are refused by line") {
  const TemporaryDirectory directory;
  const std::string head = "surface:\n  type: homography\n  matrix:\n";
  CHECK_THAT(error_of(directory, "surface: [1, 2\n"), Catch::StartsWith("skin.yaml: line 2, column 1: not YAML"));
  CHECK_THAT(error_of(directory, ""), Catch::StartsWith("skin.yaml: the file is empty"));
  CHECK_THAT(error_of(directory, "just text\n"), Catch::Contains("line 1") && Catch::Contains("surface"));
  CHECK_THAT(error_of(directory, "surfaces: 1\n"), Catch::Contains("surface: missing"));
  CHECK_THAT(error_of(directory, "surface:\n  type: sphere\n"), Catch::Contains("unknown type 'sphere'"));
  CHECK_THAT(error_of(directory, "surface:\n  type: homography\n"), Catch::Contains("matrix: missing"));
  CHECK_THAT(error_of(directory, head + "  - [1, 0, 0]\n  - [0, 1]\n  - [0, 0, 1]\n"),
             Catch::Contains("line 5") && Catch::Contains("3 rows of 3 numbers"));
  CHECK_THAT(error_of(directory, head + "  - [1, 0, 0]\n  - [0, 1, .nan]\n  - [0, 0, 1]\n"),
             Catch::Contains("line 5") && Catch::Contains("finite number"));
  CHECK_THAT(error_of(directory, head + "  - [1, 0, 0]\n  - [0, 1, .inf]\n  - [0, 0, 1]\n"), Catch::Contains("finite"));
  CHECK_THAT(error_of(directory, head + "  - [1, 0, 0]\n  - [0, 1, zwei]\n  - [0, 0, 1]\n"), Catch::Contains("'zwei'"));
  CHECK_THAT(error_of(directory, head + "  - [1, 0, 0]\n  - [2, 0, 0]\n  - [0, 0, 1]\n"), Catch::Contains("singular"));
  CHECK_THAT(error_of(directory, head + "  - [0, 0, 0]\n  - [0, 0, 0]\n  - [0, 0, 0]\n"), Catch::Contains("singular"));
  CHECK_THAT(error_of(directory, "surface:\n  type: correspondences\n  points:\n  - {left: [1, 2], right: [3, 4]}\n"),
             Catch::Contains("at least 4"));
  const std::string points =
      "surface:\n  type: correspondences\n  points:\n"
      "  - [[0, 0], [0, 0]]\n  - [[9, 0], [9, 0]]\n  - [[0, 9], [0, 9]]\n  - ";
  CHECK_THAT(error_of(directory, points + "{left: [9, 9], right: [9, 9], weigth: 2}\n"),
             Catch::Contains("line 7") && Catch::Contains("surface.points: unknown key 'weigth'"));
  CHECK_THAT(error_of(directory, points + "{left: [9, 9], rigth: [9, 9]}\n"), Catch::Contains("right: missing"));
  CHECK_THAT(error_of(directory,
                      "surface:\n  type: correspondences\n  points:\n"
                      "  - {left: [0, 0], right: [0, 0]}\n  - {left: [1, 1], right: [1, 1]}\n"
                      "  - {left: [2, 2], right: [2, 2]}\n  - {left: [3, 3], right: [3, 3]}\n"),
             Catch::Contains("line 4") && Catch::Contains("one line"));
  CHECK_THROWS_AS(load_skin(directory / "none.yaml", {}), FileError);
}

TEST_CASE("A homography ends at its horizon") {
  const HomographySkin skin({1, 0, 0, 0, 1, 0, 0, 0.01, -1}, {320, 240});  // horizon at y = 100
  CHECK(!skin.source({320, 99}));
  CHECK(skin.source({320, 101}));
}

TEST_CASE("Derivatives are those of the mapping") {
  const HomographySkin skin(kTilted);
  const Point p{213, 87};
  const double h = 1e-4;
  const auto d = skin.derivatives(p);
  CHECK(d[0] == Approx((skin.source({p.x + h, p.y})->x - skin.source({p.x - h, p.y})->x) / (2 * h)));
  CHECK(d[1] == Approx((skin.source({p.x, p.y + h})->x - skin.source({p.x, p.y - h})->x) / (2 * h)));
  CHECK(d[2] == Approx((skin.source({p.x + h, p.y})->y - skin.source({p.x - h, p.y})->y) / (2 * h)));
  CHECK(d[3] == Approx((skin.source({p.x, p.y + h})->y - skin.source({p.x, p.y - h})->y) / (2 * h)));
}

TEST_CASE("A shift becomes a table of the coarsest spacing, without error") {
  const auto map = compile_map(*skin_of({1, 0, -20, 0, 1, 5, 0, 0, 1}).skin, find_profile("vga"), {640, 480});
  CHECK(map.report.spacing_x == 64);
  CHECK(map.report.spacing_y == 64);
  CHECK(map.report.error_largest_px == 0);
  CHECK(map.report.reach.behind == -5);
  CHECK(map.report.reach.ahead == 5);
  CHECK(map.report.supervised() == 620 * 475);
  CHECK(map.report.count(Reason::outside) == map.report.pixels - map.report.supervised());
  const auto source = map.table.source(100, 50, 3);
  REQUIRE(source);
  CHECK(source->x == 80 * 8);
  CHECK(source->y == 55 * 8);
  CHECK(!map.table.source(19, 50, 3));
  CHECK(map.table.source(20, 50, 3));
  CHECK(!map.table.source(100, 475, 3));
}

TEST_CASE("The layout of the upload words is that of the hardware") {
  const auto map = compile_map(*skin_of({1, 0, -20, 0, 1, 5, 0, 0, 1}).skin, find_profile("vga"), {640, 480});
  const auto& words = map.table.words();
  CHECK(words[0] == 0x484D0366);
  CHECK(words[1] == (5U << 16 | 11U));  // 9 control rows make 5 pairs
  CHECK(words[2] == (480U << 16 | 640U));
  CHECK(words[3] == (1U << 12 | 5));  // no sub-sampling, five facts, without a rig no areas and no shifts
  // Sources of the left 20 columns and of the last 5 rows are outside; 9 px of support either way are lost for
  // `thesis`, 1 px for `compete`.
  CHECK(words[4] == (620U - 18) * (475 - 18));
  CHECK(words[5] == (620U - 2) * (475 - 2));
  CHECK(words[6] == 640U * 480 - words[4]);
  CHECK(words[7] == 640U * 480 - words[5]);
  CHECK(words[8] == 0);
  CHECK(words.size() == 4 + 5 + 5 * 11 * 2 + 1);
  // Control row 1, column 2: parity 1 of pair 0.
  CHECK(words[9 + 2 * 2 + 1] == ((64U + 64 + 5) * 32 << 16 | (64U + 128 - 20) * 32));
  CHECK(words.back() == crc32_words(std::span(words).first(words.size() - 1)));
  CHECK(crc32(std::vector<std::uint8_t>{'1', '2', '3', '4', '5', '6', '7', '8', '9'}) == 0xCBF43926);
}

TEST_CASE("Tables stay within their limits of the skin, in the hardware's arithmetic") {
  const MachineProfile& profile = find_profile(GENERATE("vga", "hd", "field"));
  const auto skin =
      profile.name == "hd" ? skin_of({1.01, 0.01, -24.0, 0.005, 1.01, 6.0, 1e-6, 5e-6, 1.0}) : skin_of(kTilted);
  CAPTURE(profile.name);
  for (const ScanGeometry& scan : scans_of(profile, profile.width, profile.largest_image_height())) {
    const auto map = compile_map(*skin.skin, profile, scan);
    CHECK(map.report.error_99_px <= 1.0 / 16);
    CHECK(map.report.error_largest_px <= 0.25);
    CHECK(map.report.pool_bytes <= static_cast<std::size_t>(profile.pool_bytes));
    std::int64_t far = 0;
    std::int64_t supervised = 0;
    for (int y = 0; y < scan.height; y += 3) {
      for (int x = 0; x < scan.width; ++x) {
        const auto source = map.table.source(x, y, 3);
        if (!source) continue;
        ++supervised;
        const Point exact = scan.from_frame(*skin.skin->source(scan.to_frame({double(x), double(y)})));
        // Rounding to 1/8 px adds up to 1/16 in each direction.
        const double error = std::hypot(source->x / 8.0 - exact.x, source->y / 8.0 - exact.y);
        REQUIRE(error <= 0.25 + 0.09);
        far += error > 1.0 / 16 + 0.09 ? 1 : 0;
      }
    }
    CHECK(supervised > 0);
    CHECK(far * 100 <= supervised);
  }
}

TEST_CASE("Fields map in full frame coordinates, each to the field of its parity") {
  const MachineProfile& profile = find_profile("field");
  const auto skin = skin_of({1, 0, -10, 0, 1, 8, 0, 0, 1});
  const auto maps = compile_maps(skin, profile, 756, 572);
  REQUIRE(maps.maps.size() == 2);
  for (const auto& map : maps.maps) {
    const auto source = map.table.source(100, 50, 3);
    REQUIRE(source);
    CHECK(source->y == 54 * 8);  // 8 rows of the frame are 4 of the field
  }
  // A rotation tells the parities apart: y differs by one row of the frame.
  const auto turned = compile_maps(skin_of({1, 0.3, 0, -0.3, 1, 120, 0, 0, 1}), profile, 640, 60);
  const auto even = turned.maps[0].table.expand(200, 10);
  const auto odd = turned.maps[1].table.expand(200, 10);
  REQUIRE(even);
  REQUIRE(odd);
  CHECK((odd->x - even->x) / 131072.0 == Approx(0.3).margin(0.04));
}

TEST_CASE("A skin that needs more rows than the store holds is refused, with the number") {
  try {
    compile_maps(skin_of({1, 0.1, 0, 0.3, 1, 0, 0, 0, 1}), find_profile("hd"), 1920, 1080);
    FAIL("accepted");
  } catch (const FileError& error) {
    CHECK_THAT(error.what(),
               Catch::Contains("skin.yaml") && Catch::Contains("rows") && Catch::Contains("holds 64 rows"));
  }
  // By the name of a profile that holds them, if there is one.
  const SkinFile turned = skin_of({0.9397, -0.342, 120.4, 0.342, 0.9397, -111.9, 0, 0, 1}, {377, 285});
  CHECK_THROWS_WITH(compile_maps(turned, find_profile("field"), 756, 572),
                    Catch::Contains("profile field_roll holds them"));
  CHECK(compile_maps(turned, find_profile("field_roll"), 756, 572).maps.size() == 2);
  CHECK(store_that_holds(find_profile("field"), {127, 5}).empty());
  CHECK(largest_roll_deg(find_profile("field")) == Approx(9).margin(0.15));
  CHECK(largest_roll_deg(find_profile("field_roll")) == Approx(36.8).margin(0.15));
  CHECK(largest_roll_deg(find_profile("hd")) == Approx(1.7).margin(0.15));
  const MachineProfile& hd = find_profile("hd");
  CHECK(lookahead_for(hd, {30, 32}) == 32);
  CHECK(lookahead_for(hd, {30, -5}) == 8);
  CHECK(lookahead_for(hd, {0, 33}) == std::nullopt);
  CHECK(lookahead_for(hd, {31, 6}) == std::nullopt);
}

TEST_CASE("Unsupervised pixels are told by reason") {
  SECTION("scales below 1/2") {
    CHECK_THROWS_WITH(compile_map(*skin_of({2.2, 0, 0, 0, 1, 0, 0, 0, 1}).skin, find_profile("vga"), {640, 480}),
                      Catch::Contains("no pixel is supervised") && Catch::Contains("100.0 % reduced to less than 1/2"));
  }
  SECTION("a scale that falls below 1/2 within the image") {
    const HomographySkin skin({1, 0, 0, 0, 1, 0, -8e-4, 0, 1}, {0, 0});
    const auto map = compile_map(skin, find_profile("vga"), {640, 60});
    CHECK(map.report.count(Reason::scale) > 0);
    CHECK(map.report.supervised() > 0);
    for (int y = 0; y < 60; y += 7) {
      for (int x = 0; x < 640; ++x) {
        const auto d = skin.derivatives({double(x), double(y)});
        if (d[0] > 2.0001) REQUIRE(!map.table.source(x, y, 3));
      }
    }
  }
  SECTION("beyond the horizon") {
    const HomographySkin skin({1, 0, 0, 0, 1, 0, 0, 0.005, -0.5}, {320, 400});
    CHECK_THROWS_WITH(compile_map(skin, find_profile("vga"), {640, 60}), Catch::Contains("100.0 % without a skin"));
  }
  const auto map = compile_map(*skin_of(kTilted).skin, find_profile("vga"), {640, 480});
  const auto& r = map.report;
  CHECK(std::accumulate(r.by_reason.begin(), r.by_reason.end(), std::int64_t{0}) == r.pixels);
}

TEST_CASE("Tables survive the file, and altered files are refused") {
  const TemporaryDirectory directory;
  const auto path = directory / "skin.hmap";
  const auto maps = compile_maps(skin_of(kTilted), find_profile("field"), 756, 572);
  save_maps(maps, path);
  const auto loaded = load_maps(path);
  CHECK(loaded.profile == "field");
  CHECK(loaded.image_width == 756);
  CHECK(loaded.image_height == 572);
  CHECK(loaded.skin == maps.skin);
  CHECK(loaded.lookahead() == maps.lookahead());
  REQUIRE(loaded.maps.size() == 2);
  for (int i = 0; i < 2; ++i) {
    CHECK(loaded.maps[i].table.words() == maps.maps[i].table.words());
    CHECK(loaded.maps[i].table.geometry() == maps.maps[i].table.geometry());
    CHECK(loaded.maps[i].report.by_reason == maps.maps[i].report.by_reason);
  }
  const auto bytes = bytes_of(path);
  for (std::size_t at = 0; at < bytes.size(); at += 1 + bytes.size() / 97) {
    CAPTURE(at);
    auto altered = bytes;
    altered[at] ^= 0x04;
    CHECK_THROWS_AS(load_maps(directory.write("altered.hmap", altered)), FileError);
    CHECK_THROWS_AS(load_maps(directory.write("cut.hmap", std::vector(bytes.begin(), bytes.begin() + at))), FileError);
  }
  auto longer = bytes;
  longer.push_back(0);
  CHECK_THROWS_WITH(load_maps(directory.write("longer.hmap", longer)), Catch::Contains("more data"));
}

TEST_CASE("Tables whose CRCs hold and that are not true are refused") {
  const TemporaryDirectory directory;
  const auto good = compile_maps(skin_of(kTilted), find_profile("field"), 756, 572);
  const auto refused = [&](const std::string& message, auto alter) {
    MapSet maps = good;
    alter(maps);
    save_maps(maps, directory / "wrong.hmap");
    try {
      load_maps(directory / "wrong.hmap");
      FAIL("it is taken");
    } catch (const FileError& error) {
      CHECK_THAT(error.what(), Catch::Contains("wrong.hmap: ") && Catch::Contains(message));
    }
  };
  refused("a profile that is none of", [](MapSet& maps) { maps.profile = "pal"; });
  refused("images of 757x572 pixels", [](MapSet& maps) { maps.image_width = 757; });
  refused("where the image has", [](MapSet& maps) { maps.image_height = 500; });
  refused("1 tables", [](MapSet& maps) { maps.maps.pop_back(); });
  refused("where the image has", [](MapSet& maps) { std::swap(maps.maps[0], maps.maps[1]); });
  refused("no rig.yaml", [](MapSet& maps) { maps.rig = "cameras: 2"; });
  refused("table 1: facts that are not true", [](MapSet& maps) {
    auto facts = maps.maps[1].table.facts();
    facts.judgeable_by_thesis -= 5;
    maps.maps[1].table.seal(facts);
    maps.maps[1].report.crc = maps.maps[1].table.crc();
  });
  refused("table 0: facts that are not true", [](MapSet& maps) {  // of a table that supervises less
    auto& [table, report] = maps.maps[0];
    const auto facts = table.facts();
    table.set_spans(std::vector<hls::table::Span>(static_cast<std::size_t>(table.geometry().height), {40, 400}));
    table.seal(facts);
    report.crc = table.crc();
    report.pool_bytes = table.pool_bytes();
  });
  refused("a report that is not true", [](MapSet& maps) { maps.maps[0].report.lookahead -= 1; });
  refused("a report that is not true", [](MapSet& maps) { maps.maps[0].report.reach.behind -= 1; });
  refused("a report that is not true", [](MapSet& maps) { maps.maps[0].report.by_reason[0] += 1; });
  refused("a report that is not true", [](MapSet& maps) { maps.maps[0].report.by_reason[2] = -1; });
}

TEST_CASE("Upload words are checked before they are used") {
  auto map = compile_map(*skin_of(kTilted).skin, find_profile("vga"), {640, 480});
  auto facts = map.table.facts();
  facts.shifts = {-300, 40};
  facts.areas.assign(facts.area_count({640, 480, 0, 0}), hls::table::encode_area(4));
  map.table.seal(facts);
  const auto words = map.table.words();
  REQUIRE(MapTable(words, Scan::progressive).facts() == facts);
  const auto error_of = [&](std::size_t at, std::uint32_t value, bool seal) -> std::string {
    auto copy = words;
    copy[at] = value;
    if (seal) copy.back() = crc32_words(std::span(copy).first(copy.size() - 1));
    try {
      MapTable(copy, Scan::progressive);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(error_of(0, 0x484D0166, true), Catch::Contains("table format 1; this program reads 3") &&
                                                Catch::Contains("make the map again with `horopter map`"));
  CHECK_THAT(error_of(0, 0x484E0266, true), Catch::Contains("no mapping table"));
  CHECK_THAT(error_of(0, 0x484D0377, true), Catch::Contains("more than 64 pixels apart"));
  CHECK_THAT(error_of(1, 0x00010001, true), Catch::Contains("control points"));
  CHECK_THAT(error_of(2, 0, true), Catch::Contains("0x0 pixels"));
  CHECK_THAT(error_of(3, words[3] - 1, true), Catch::Contains("words for 79 words of facts"));
  CHECK_THAT(error_of(3, words[3] & ~0xFFFU, true), Catch::Contains("0 words of facts"));
  CHECK_THAT(error_of(3, words[3] ^ 1U << 12, true), Catch::Contains("sub-sampling"));
  CHECK_THAT(error_of(3, words[3] ^ 1U << 16, true), Catch::Contains("80 words of facts, with areas not known"));
  CHECK_THAT(error_of(3, words[3] ^ 1U << 17, true), Catch::Contains("shifts"));
  for (std::size_t at = 4; at < 8; ++at) CHECK_THAT(error_of(at, words[at] + 1, true), Catch::Contains("judgeable"));
  CHECK_THAT(error_of(8, 0xFFFF0000, true), Catch::Contains("shifts"));
  // What only the CRC can tell.
  for (std::size_t at = 0; at < words.size(); at += at < 20 ? 1 : 37) {
    CAPTURE(at);
    for (const unsigned bit : {0U, 7U, 31U}) CHECK(error_of(at, words[at] ^ 1U << bit, false) != "");
  }
}

TEST_CASE("Outside of its row's span nothing is supervised, and what a span says is checked") {
  const ScanGeometry scan{64, 33, Scan::progressive};
  MapTable table(scan, 3, 3);
  for (int row = 0; row < table.rows(); ++row) {
    for (int column = 0; column < table.columns(); ++column) {
      table.set_control(column, row, MapTable::encode({8.0 * column, 8.0 * row}));
    }
  }
  const MapTable without = table;
  std::vector<hls::table::Span> spans;
  for (int y = 0; y < 33; ++y) spans.push_back(y < 32 ? hls::table::Span{y, 64 - y} : hls::table::Span{});
  spans[5] = {};
  spans[6] = {0, 64};
  table.set_spans(spans);
  table.seal(facts_of(table, find_profile("vga")));
  CHECK(table.pool_bytes() == without.pool_bytes() + 4 * 34);
  CHECK(table.pool_bytes() == MapTable::pool_bytes(scan, 3, 3, true));
  CHECK((table.words()[0] ^ without.words()[0]) == hls::table::has_spans);
  CHECK(table.words().size() == without.words().size() + 34);
  const Image supervised = table.supervised(3);
  int wrong = 0;
  for (int y = 0; y < 33; ++y) {
    CHECK(table.span(y) == spans[static_cast<std::size_t>(y)]);
    for (int x = 0; x < 64; ++x) {
      const bool inside = y != 5 && (y == 6 || (x >= y && x < 64 - y));
      wrong += (supervised.at(x, y) != 0) != inside || table.source(x, y, 3).has_value() != inside ? 1 : 0;
      wrong += table.expand_around(x, y).has_value() ? 0 : 1;  // what both cameras see there is shown as before
    }
  }
  CHECK(wrong == 0);
  for (int row = 0; row < table.rows(); ++row) {
    for (int column = 0; column < table.columns(); ++column)
      wrong += table.control(column, row) != without.control(column, row) ? 1 : 0;
  }
  CHECK(wrong == 0);
  const MapTable again(table.words(), Scan::progressive);
  CHECK(again.words() == table.words());

  const std::size_t first = hls::table::read(table.words()).first_span;
  const auto refused = [&](int row, std::uint32_t word, const std::string& message) {
    CAPTURE(row, word);
    auto words = table.words();
    words[first + static_cast<std::size_t>(row)] = word;
    words.back() = crc32_words(std::span(words).first(words.size() - 1));
    CHECK_THROWS_WITH(MapTable(words, Scan::progressive), Catch::Contains(message));
  };
  refused(3, 9U << 16 | 10, "a span of row 3 from column 10 to before 9 of 64x33 pixels");  // ends before it begins
  refused(3, 9U << 16 | 9, "a span of row 3");
  refused(3, 65U << 16 | 9, "to before 65");
  refused(0, 64U << 16 | 1U << 12, "a span of row 0");
  refused(32, 1U << 31 | 64U << 16, "a span of row 32");
  refused(33, 64U << 16, "a span of row 33");  // there are 33 rows
  auto words = table.words();
  words[0] ^= hls::table::has_spans;
  CHECK_THROWS_WITH(MapTable(words, Scan::progressive), Catch::Contains("0 of spans"));
  CHECK_THROWS_AS(table.set_spans(std::vector<hls::table::Span>(32)), std::invalid_argument);
  CHECK_THROWS_AS(table.set_spans(std::vector<hls::table::Span>(33, {0, 65})), std::invalid_argument);
  CHECK(table.words() == again.words());
}

TEST_CASE("Areas are kept to an eighth, and never as smaller ones") {
  for (double mm2 = 3e-4; mm2 < 9e5; mm2 *= 1.01) {
    const double kept = hls::table::decode_area(hls::table::encode_area(mm2));
    if (kept < mm2 || kept > mm2 * 1.125) FAIL(mm2 << " mm2 became " << kept);
  }
  for (int code = 0; code < 256; ++code) {
    CHECK(hls::table::encode_area(hls::table::decode_area(static_cast<std::uint8_t>(code))) == code);
  }
  CHECK(hls::table::encode_area(0) == 0);
  CHECK(hls::table::encode_area(1e9) == 255);
  CHECK(hls::table::decode_area(0) == 1.0 / 4096);
  CHECK(hls::table::decode_area(255) == 983'040);
}

TEST_CASE("Around a small skin a table goes on along the plane that continues it, and supervises none of it") {
  const CameraPair cameras = table_11_1(640, 480);
  const MachineProfile& vga = find_profile("vga");
  const ScanGeometry scan{640, 480, Scan::progressive};
  TriangleMesh mesh;
  mesh.vertices_mm = {{-100, -80, 1000}, {100, -80, 1040}, {100, 80, 1040}, {-100, 80, 1000}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const SurfacePtr small = make_mesh(mesh);
  const SurfacePtr plane = make_plane({0, 0, 1020}, {0.2, 0, -1});
  const CompiledMap whole = compile_map(RigSkin(cameras, plane, "plane"), vga, scan);
  const bool every_pixel = GENERATE(true, false);
  const CompiledMap part = every_pixel ? compile_map(RigSkin(cameras, small, "mesh"), vga, scan)
                                       : MapCompiler(cameras, vga, scan).compile(*small);
  if (every_pixel) CHECK(std::ranges::count(part.table.supervised(3).pixels, 1) == part.report.supervised());
  CHECK(part.report.supervised() < part.report.pixels / 4);
  CHECK(part.table.facts().judgeable_by_thesis < part.report.supervised());
  CHECK(compared_share(part.table, vga, 32) > 0.9 * compared_share(whole.table, vga, 32));
  CHECK(compared_share(whole.table, vga, 32) > 0.7);
  int compared = 0;
  double largest_px = 0;
  for (int y = 100; y < 380; y += 4) {
    for (int x = 260; x < 380; x += 4) {  // further to the sides the plane is nearer, or further, than all of the skin
      const auto around = part.table.expand_around(x, y);
      const auto exact = whole.table.expand_around(x, y);
      if (!around || !exact || part.table.expand(x, y)) continue;
      ++compared;
      largest_px = std::max({largest_px, std::abs(std::ldexp(around->x - exact->x, -MapTable::kFractionBits)),
                             std::abs(std::ldexp(around->y - exact->y, -MapTable::kFractionBits))});
    }
  }
  CHECK(compared > 500);
  CHECK(largest_px < 0.3);
}

TEST_CASE("The default profile is the smallest that takes the image as it is") {
  CHECK(smallest_profile(640, 480)->name == "vga");
  CHECK(smallest_profile(320, 200)->name == "vga");  // field would split it
  CHECK(smallest_profile(641, 480)->name == "hd");
  CHECK(smallest_profile(1921, 1080) == nullptr);
  CHECK_THROWS_WITH(find_profile("pal"),
                    Catch::Contains("unknown profile 'pal'") && Catch::Contains("field, field_roll, vga, hd"));
}

TEST_CASE("Supervised pixels of a table are those that have a source") {
  std::mt19937 random(7);
  for (const auto& [nx, ny] : {std::pair{0, 0}, {1, 0}, {0, 2}, {2, 1}, {3, 3}, {5, 4}, {6, 6}}) {
    CAPTURE(nx, ny);
    MapTable table({97, 61, Scan::progressive}, nx, ny);
    for (int row = 0; row < table.rows(); ++row) {
      for (int column = 0; column < table.columns(); ++column) {
        const double shift = static_cast<double>(random() % 3) * 3;
        const Point source{std::ldexp(column, nx) + shift, std::ldexp(row, ny) - shift};
        table.set_control(column, row, random() % 8 == 0 ? MapTable::kUnmapped : MapTable::encode(source));
      }
    }
    Image expected(97, 61);
    for (int y = 0; y < 61; ++y) {
      for (int x = 0; x < 97; ++x) expected.at(x, y) = table.source(x, y, 3) ? 1 : 0;
    }
    CHECK(table.supervised(3).pixels == expected.pixels);
    CHECK(std::ranges::count(expected.pixels, 1) > 0);
  }
}

TEST_CASE("Fields that read different rows have one LOOKAHEAD") {
  const TemporaryDirectory directory;
  auto maps = compile_maps(skin_of(kTilted), find_profile("field"), 756, 572);
  maps.maps[1].report.reach.ahead = 20;
  for (CompiledMap& map : maps.maps) map.report.lookahead = 20;
  save_maps(maps, directory / "fields.hmap");
  CHECK(load_maps(directory / "fields.hmap").lookahead() == 20);
  maps.maps[0].report.lookahead = 19;
  save_maps(maps, directory / "fields.hmap");
  CHECK_THROWS_WITH(load_maps(directory / "fields.hmap"), Catch::Contains("a report that is not true"));
}

TEST_CASE("Points that contradict each other are refused, by the worst of them") {
  const TemporaryDirectory directory;
  const HomographySkin truth(kTilted);
  const auto skin = [&](int points, double typo_px) {
    const std::vector<Point> places{{60, 50}, {580, 60}, {570, 430}, {70, 420}, {320, 240}, {200, 130}, {430, 330}};
    std::string text = "surface:\n  type: correspondences\n  points:\n";
    for (int i = 0; i < points; ++i) {
      const Point right = *truth.source(places[static_cast<std::size_t>(i)]);
      text += "  - {left: [" + std::to_string(places[static_cast<std::size_t>(i)].x) + ", " +
              std::to_string(places[static_cast<std::size_t>(i)].y) + "], right: [" +
              std::to_string(right.x + (i == 4 ? typo_px : 0)) + ", " + std::to_string(right.y) + "]}\n";
    }
    return text;
  };
  CHECK_THAT(error_of(directory, skin(7, 30)),
             Catch::StartsWith("skin.yaml: line 8, column 5: surface.points: point 5 of 7 is ") &&
                 Catch::Contains(" px from where") &&
                 Catch::Contains("expected points that lie on one plane; of so many each is within 3.3 px"));
  // The fit of few points hides most of an error.
  CHECK_THAT(error_of(directory, skin(5, 20)), Catch::Contains("point 5 of 5 is "));
  CHECK_NOTHROW(load_skin(directory.write("skin.yaml", skin(7, 3)), {320, 240}));
  CHECK_NOTHROW(load_skin(directory.write("skin.yaml", skin(4, 0)), {320, 240}));
}

TEST_CASE("A second document of a file is refused") {
  const TemporaryDirectory directory;
  const std::string one = "surface:\n  type: homography\n  matrix: [[1, 0, -20], [0, 1, 5], [0, 0, 1]]\n";
  for (const std::string& whole : {"---\n" + one, one + "...\n", "%YAML 1.2\n---\n" + one, one + "# end\n"}) {
    CAPTURE(whole);
    CHECK_NOTHROW(load_skin(directory.write("skin.yaml", whole), {320, 240}));
  }
  std::string bomb = "a: &a [x, x]\n";
  for (char c = 'b'; c < 'z'; ++c) {
    const std::string last(1, static_cast<char>(c - 1));
    bomb += std::string(1, c) + ": &" + c + " [*" + last + ", *" + last + ", *" + last + ", *" + last + "]\n";
  }
  for (const std::string& more : {"---\n" + one, std::string("---\n"), "---\n" + bomb, "...\n---\n" + one}) {
    CAPTURE(more);
    CHECK_THAT(error_of(directory, one + more),
               Catch::StartsWith("skin.yaml: line ") && Catch::Contains("a second document; expected one"));
  }
  CHECK_THAT(error_of(directory, one + "---\n" + one), Catch::Contains("line 4, column 1"));
}

}  // namespace horopter
