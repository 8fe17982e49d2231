// SPDX-License-Identifier: Apache-2.0
// What objects cover of a skin, in mm, against brute force: every pixel of a patch in 16 parts, whose lines of sight are
// followed to the skin itself. Tables and rigs alone are given to what is tested.
#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "horopter/base/error.hpp"
#include "horopter/hls/area.hpp"
#include "horopter/machine/object_follower.hpp"
#include "horopter/machine/report.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/map/skin_places.hpp"
#include "host_temporary.hpp"
#include "table_11_1.hpp"

namespace horopter {
namespace {

using Eigen::Vector3d;

constexpr int kWidth = 640;
constexpr int kHeight = 480;

struct Patch {
  int x, y, width, height;  ///< pixels of the result
};

struct Measured {
  double area_mm2 = 0;
  Vector3d centroid_mm = Vector3d::Zero();
};

/// By the surface, which what is tested does not know.
std::optional<Measured> brute_force(const CameraPair& cameras, const Surface& surface, const ScanGeometry& scan,
                                    int subsample, const Patch& patch) {
  constexpr int kParts = 4;
  const int columns = kParts * patch.width + 1, rows = kParts * patch.height + 1;
  const calib::Camera& left = cameras.left();
  std::vector<Vector3d> directions;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      // Pixels of the frame: the first one of the result begins at −0.5.
      const double x = subsample * (patch.x + static_cast<double>(column) / kParts) - 0.5;
      const Point pixel = scan.to_frame({x, patch.y + static_cast<double>(row) / kParts - 0.5});
      const auto sight = left.model.undistort({pixel.x, pixel.y});
      if (!sight) return {};
      directions.emplace_back(left.world_to_camera.rotation.transpose() * sight->homogeneous());
    }
  }
  const Vector3d eye = left.world_to_camera.centre();
  std::vector<Hit> hits(directions.size());
  surface.intersect(eye, directions, hits);
  std::vector<Vector3d> places;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!std::isfinite(hits[i].distance)) return {};
    places.emplace_back(eye + hits[i].distance * directions[i]);
  }
  Measured sum;
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      const auto at = [&](int dx, int dy) {
        return places[static_cast<std::size_t>((row + dy) * columns + column + dx)];
      };
      for (const auto& [a, b, c] : {std::tuple{at(0, 0), at(1, 0), at(0, 1)}, {at(1, 1), at(1, 0), at(0, 1)}}) {
        const double area = 0.5 * (b - a).cross(c - a).norm();
        sum.area_mm2 += area;
        sum.centroid_mm += area * (a + b + c) / 3;
      }
    }
  }
  sum.centroid_mm /= sum.area_mm2;
  return sum;
}

/// A result of which these pixels are in the skin.
FrameResult with_patch(const MapTable& table, int subsample, const Patch& patch) {
  FrameResult result;
  result.states = Image(table.geometry().width / subsample, table.geometry().height);
  for (int y = patch.y; y < patch.y + patch.height; ++y) {
    for (int x = patch.x; x < patch.x + patch.width; ++x) {
      result.states.at(x, y) = static_cast<std::uint8_t>(State::skin);
    }
  }
  result.table_crc = table.crc();
  result.scan = table.geometry().scan;
  result.object_limit_pixels = 1;
  return result;
}

SurfacePtr ball_mesh(const Vector3d& centre_mm, double radius_mm) {
  TriangleMesh mesh;
  constexpr int kAround = 48, kUp = 24;
  const auto vertex = [&](int i, int j) {
    if (j == 0) return 0U;
    if (j == kUp) return 1U;
    return static_cast<std::uint32_t>(2 + (j - 1) * kAround + i % kAround);
  };
  mesh.vertices_mm = {centre_mm - Vector3d(0, 0, radius_mm), centre_mm + Vector3d(0, 0, radius_mm)};
  for (int j = 1; j < kUp; ++j) {
    for (int i = 0; i < kAround; ++i) {
      const double a = 2 * M_PI * i / kAround, b = M_PI * j / kUp - M_PI / 2;
      mesh.vertices_mm.push_back(
          centre_mm + radius_mm * Vector3d(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)));
    }
  }
  for (int j = 0; j < kUp; ++j) {
    for (int i = 0; i < kAround; ++i) {
      const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      if (j > 0) mesh.triangles.push_back({a, b, c});
      if (j + 1 < kUp) mesh.triangles.push_back({a, c, d});
    }
  }
  return make_mesh(mesh);
}

SurfacePtr waves() {
  std::vector<std::vector<double>> heights;
  for (int row = 0; row < 61; ++row) {
    heights.emplace_back();
    for (int column = 0; column < 81; ++column) {
      heights.back().push_back(20 * std::sin(column / 9.0) * std::cos(row / 12.0));
    }
  }
  return make_mesh(height_field({-400, -300, 850}, {10, 10}, heights));
}

struct Named {
  const char* name;
  SurfacePtr surface;
};

std::vector<Named> surfaces() {
  const auto turned = [](double about_x_deg, double about_y_deg) {
    calib::Pose pose;
    pose.rotation = (Eigen::AngleAxisd(about_y_deg * M_PI / 180, Vector3d::UnitY()) *
                     Eigen::AngleAxisd(about_x_deg * M_PI / 180, Vector3d::UnitX()))
                        .toRotationMatrix();
    pose.translation_mm = {0, 0, 900};
    return pose;
  };
  return {{"plane", make_plane({0, 0, 800}, {0, 0, -1})},
          {"steep plane", make_plane({0, 0, 900}, {0.8, 0.4, -1})},
          {"ellipsoid", make_ellipsoid(turned(30, 20), {260, 180, 120})},
          {"ball of triangles", ball_mesh({0, 0, 950}, 220)},
          {"height field", waves()},
          {"box, edge on", make_box(turned(25, 40), {300, 260, 220})}};
}

/// Of the areas that the host measures, and of those that the machine adds up: too small, too large.
struct Errors {
  double host = 0, machine_below = 0, machine_above = 0;
};

Errors largest_errors(const MapTable& table, const MachineProfile& profile, const CameraPair& cameras,
                      const Surface& surface, int smallest_px, int largest_px, int count, double* largest_way_mm,
                      const std::optional<Patch>& within = {}) {
  const Image supervised = table.supervised(profile.weight_bits);
  std::mt19937 random(7);
  const auto uniform = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
  SkinPlaces places(table, cameras);
  Errors largest;
  int done = 0;
  for (int tries = 0; tries < 20'000 && done < count; ++tries) {
    Patch patch{0, 0, uniform(smallest_px, largest_px), uniform(smallest_px, largest_px)};
    const Patch place = within.value_or(Patch{0, 0, supervised.width / profile.subsample, supervised.height});
    patch.x = place.x + uniform(0, place.width - patch.width);
    patch.y = place.y + uniform(0, place.height - patch.height);
    bool whole = true;  // all of it, and the pixels around it, as of every pixel in the skin
    for (int y = patch.y - 1; whole && y <= patch.y + patch.height; ++y) {
      for (int x = profile.subsample * (patch.x - 1); whole && x < profile.subsample * (patch.x + patch.width + 1);
           ++x) {
        whole = x >= 0 && y >= 0 && x < supervised.width && y < supervised.height && supervised.at(x, y) != 0;
      }
    }
    if (!whole) continue;
    const auto right = brute_force(cameras, surface, table.geometry(), profile.subsample, patch);
    if (!right) continue;
    FrameResult result = with_patch(table, profile.subsample, patch);
    result.object_area_limit = 1;
    result.areas = table.facts().areas;
    const auto objects = measured_objects(result, &places, 1, 10);
    REQUIRE(objects.size() == 1);
    REQUIRE(objects[0].in_space);
    largest.host = std::max(largest.host, std::abs(objects[0].in_space->area_mm2 / right->area_mm2 - 1));
    const double machine = objects[0].region.area / double{hls::area_steps_per_mm2} / right->area_mm2 - 1;
    largest.machine_below = std::max(largest.machine_below, -machine);
    largest.machine_above = std::max(largest.machine_above, machine);
    *largest_way_mm = std::max(*largest_way_mm, (objects[0].in_space->centroid_mm - right->centroid_mm).norm());
    ++done;
  }
  REQUIRE(done == count);
  return largest;
}

}  // namespace

// Asked for are 3 % and 10 %: the host's areas; the machine's own are at most too large.
TEST_CASE("The area of what is in the skin is within 1 % where it is large, and within 6 % anywhere") {
  const MachineProfile& profile = find_profile(GENERATE("vga", "field"));
  const CameraPair cameras = table_11_1(kWidth, kHeight);
  for (const auto& [name, surface] : surfaces()) {
    for (const ScanGeometry& scan : scans_of(profile, kWidth, kHeight)) {
      CAPTURE(profile.name, name, static_cast<int>(scan.scan));
      const CompiledMap map = compile_map(RigSkin(cameras, surface, ""), profile, scan);
      double way_mm = 0;
      // 3×3 blocks of the table's areas, in the image that is the larger one.
      const int blocks = profile.subsample == 1 ? 96 : 48;
      const Errors large = largest_errors(map.table, profile, cameras, *surface, blocks, blocks, 8, &way_mm);
      const Errors small = largest_errors(map.table, profile, cameras, *surface, blocks / 6, blocks / 2, 100, &way_mm);
      CAPTURE(large.host, small.host, large.machine_below, large.machine_above, small.machine_below,
              small.machine_above, way_mm, map.report.spacing_x, map.report.spacing_y);
      CHECK(large.host < 0.01);
      CHECK(small.host < 0.06);
      // The machine has the largest area of each block, rounded up: no object counts as a smaller one. Where a surface
      // turns away from the camera most of a block's pixels have less.
      const bool smooth = std::string_view(name) == "plane" || std::string_view(name) == "height field";
      CHECK(large.machine_below == 0);
      CHECK(small.machine_below == 0);
      CHECK((!smooth || (large.machine_above < 0.1 && small.machine_above < 0.13)));
      CHECK(way_mm < 1);
    }
  }
}

TEST_CASE("Where a skin turns away within a few pixels, no object counts as smaller than it is") {
  const CameraPair cameras = table_11_1(kWidth, kHeight);
  const auto check = [&](const MachineProfile& profile, const Surface& surface, const CompiledMap& map, int smallest_px,
                         int largest_px, const std::optional<Patch>& within) {
    double way_mm = 0;
    const Errors errors =
        largest_errors(map.table, profile, cameras, surface, smallest_px, largest_px, 100, &way_mm, within);
    CAPTURE(profile.name, surface.description(), errors.machine_below, errors.machine_above);
    CHECK(errors.machine_below == 0);
  };
  const bool moves = GENERATE(false, true);
  const auto compile = [&](const MachineProfile& profile, const SurfacePtr& surface, const ScanGeometry& scan,
                           const MapLimits& limits) {
    return moves ? MapCompiler(cameras, profile, scan, limits).compile(*surface)
                 : compile_map(RigSkin(cameras, surface, ""), profile, scan, limits);
  };
  const SurfacePtr arm = make_capsules({{{0, -150, 800}, {20, 150, 800}, 30}});
  const SurfacePtr ball = make_ellipsoid(at({-30, 20, 800}), {60, 60, 60});
  for (const char* name : {"vga", "field"}) {
    const MachineProfile& profile = find_profile(name);
    const int whole_px = profile.subsample == 1 ? 12 : 6;
    for (const ScanGeometry& scan : scans_of(profile, kWidth, kHeight)) {
      for (const SurfacePtr& surface : {arm, ball}) {
        check(profile, *surface, compile(profile, surface, scan, {}), whole_px / 2, whole_px, {});
      }
    }
  }
  // Its side is seen in columns 193 to 206, between columns that are multiples of 16.
  calib::Pose pose = at({-40, 0, 1950});
  pose.rotation = calib::rotation_from_vector({0, -29 * M_PI / 180, 0});
  const SurfacePtr box = make_box(pose, {300, 500, 60});
  MapLimits fine;
  fine.largest_spacing_log2 = 3;  // else the table loses the side
  const MachineProfile& vga = find_profile("vga");
  check(vga, *box, compile(vga, box, {kWidth, kHeight, Scan::progressive}, fine), 8, 10, Patch{194, 100, 12, 280});
}

namespace {

/// A disc of so many mm on the skin, by the pixels whose lines of sight meet it.
void add_disc(FrameResult& result, const MapTable& table, int subsample, const CameraPair& cameras,
              const Surface& surface, const Vector3d& centre_mm, double diameter_mm) {
  const calib::Camera& left = cameras.left();
  const Vector3d eye = left.world_to_camera.centre();
  for (int y = 0; y < result.states.height; ++y) {
    std::vector<Vector3d> directions;
    for (int x = 0; x < result.states.width; ++x) {
      const Point pixel = table.geometry().to_frame({subsample * x + 0.5 * (subsample - 1), static_cast<double>(y)});
      directions.emplace_back(left.world_to_camera.rotation.transpose() *
                              left.model.undistort({pixel.x, pixel.y})->homogeneous());
    }
    std::vector<Hit> hits(directions.size());
    surface.intersect(eye, directions, hits);
    for (std::size_t x = 0; x < hits.size(); ++x) {
      if ((eye + hits[x].distance * directions[x] - centre_mm).norm() > diameter_mm / 2) continue;
      result.states.at(static_cast<int>(x), y) = static_cast<std::uint8_t>(State::skin);
    }
  }
}

FrameResult nothing_in(const MapTable& table, int subsample) { return with_patch(table, subsample, {0, 0, 0, 0}); }

struct Wall {
  explicit Wall(const char* profile_name) : profile(find_profile(profile_name)) {
    SkinFile file;
    file.path = "wall";
    file.rig = calib::to_yaml({"", {cameras.left(), cameras.right()}});
    file.skin = std::make_unique<RigSkin>(cameras, surface, "plane");
    maps = compile_maps(file, profile, kWidth, kHeight);
    tables = maps.tables();
  }
  Vector3d place(double x_mm, double y_mm) const { return {x_mm, y_mm, 900 + 0.6 * x_mm + 0.2 * y_mm}; }
  FrameResult frame(std::size_t scan, const Vector3d& centre_mm, double diameter_mm, int limit = 100) const {
    FrameResult result = nothing_in(*tables.at(scan), profile.subsample);
    add_disc(result, *tables[scan], profile.subsample, cameras, *surface, centre_mm, diameter_mm);
    result.object_limit_pixels = limit;
    return result;
  }

  const MachineProfile& profile;
  CameraPair cameras = table_11_1(kWidth, kHeight);
  SurfacePtr surface = make_plane({0, 0, 900}, {0.6, 0.2, -1});
  MapSet maps;
  std::vector<const MapTable*> tables;
};

}  // namespace

TEST_CASE("A disc on a tilted wall has its size, place and area") {
  const Wall wall(GENERATE("vga", "field"));
  ObjectFollower follower(wall.profile, wall.tables, wall.maps.rig);
  REQUIRE(follower.in_mm());
  const Vector3d centre_mm = wall.place(-30, 45);
  for (std::size_t scan = 0; scan < wall.tables.size(); ++scan) {
    CAPTURE(wall.profile.name, scan);
    const auto found = follower.follow(wall.frame(scan, centre_mm, 80));
    REQUIRE(found.size() == 1);
    REQUIRE(found[0].in_space);
    const ObjectInSpace& disc = *found[0].in_space;
    CHECK(disc.area_mm2 == Approx(M_PI * 1600).epsilon(0.02));
    CHECK(disc.length_mm == Approx(80).margin(2));
    CHECK(disc.width_mm == Approx(80).margin(3));
    CHECK(disc.length_mm >= disc.width_mm);
    CHECK((disc.centroid_mm - centre_mm).norm() < 1);
  }
}

TEST_CASE("A bar lying askew has its own length and width, not those of a box about it") {
  const Wall wall("vga");
  const MapTable& table = *wall.tables[0];
  FrameResult result = nothing_in(table, 1);
  const Vector3d along = (wall.place(1, 1) - wall.place(0, 0)).normalized();
  for (int i = -50; i <= 50; ++i)
    add_disc(result, table, 1, wall.cameras, *wall.surface, wall.place(0, 0) + i * along, 20);
  SkinPlaces places(table, wall.cameras);
  const auto objects = measured_objects(result, &places, 1, 1);
  REQUIRE(objects.at(0).in_space);
  CHECK(objects[0].in_space->length_mm == Approx(120).margin(2));
  CHECK(objects[0].in_space->width_mm == Approx(20).margin(2));
}

TEST_CASE("Where no place is known there is nothing in mm") {
  const Wall wall("vga");
  FrameResult result = wall.frame(0, wall.place(0, 0), 80);
  CHECK(measured_objects(result, nullptr, 1, 9).at(0).in_space == std::nullopt);
  ObjectFollower without(wall.profile, wall.tables, "");
  CHECK_FALSE(without.in_mm());
  CHECK_FALSE(without.follow(result).at(0).in_space);
  // Of another table than those known: a board that somebody else has given one.
  ObjectFollower follower(wall.profile, wall.tables, wall.maps.rig);
  result.table_crc ^= 1;
  CHECK_FALSE(follower.follow(result).at(0).in_space);
  result.table_crc ^= 1;
  CHECK(follower.follow(result).at(0).in_space);
  // Half of it beside the skin: it must not read as a small one.
  const auto board = make_polygons({{{-100, -100, 900}, {100, -100, 900}, {100, 100, 900}, {-100, 100, 900}}});
  const MapTable table =
      compile_map(RigSkin(wall.cameras, board, ""), wall.profile, {kWidth, kHeight, Scan::progressive}).table;
  SkinPlaces places(table, wall.cameras);
  CHECK(measured_objects(with_patch(table, 1, {300, 220, 40, 40}), &places, 1, 1).at(0).in_space);
  CHECK_FALSE(measured_objects(with_patch(table, 1, {20, 220, 320, 40}), &places, 1, 1).at(0).in_space);
  CHECK_FALSE(places.at(-1, 10));
  CHECK_FALSE(places.at(10, kHeight));
  CHECK_FALSE(places.exactly_at(kWidth, 10));
  CHECK_THROWS_AS(ObjectFollower(wall.profile, wall.tables, "no rig"), FileError);
}

TEST_CASE("A table that was saved knows places by its rig, without the skin's file") {
  const Wall wall("vga");
  const TemporaryDirectory directory;
  save_maps(wall.maps, directory / "wall.hmap");
  const MapSet loaded = load_maps(directory / "wall.hmap");
  ObjectFollower follower(wall.profile, {&loaded.maps[0].table}, loaded.rig);
  const auto found = follower.follow(wall.frame(0, wall.place(50, 0), 60));
  REQUIRE(found.at(0).in_space);
  CHECK((found[0].in_space->centroid_mm - wall.place(50, 0)).norm() < 1);
}

TEST_CASE("A table with areas that are too small is refused: bodies would count as smaller than they are") {
  const Wall wall(GENERATE("vga", "field"));
  CAPTURE(wall.profile.name);
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "wall.hmap";
  save_maps(wall.maps, file);
  CHECK_NOTHROW(load_maps(file));
  // Of the version before, areas of steep places may be too small, which no check finds.
  std::fstream bytes(file, std::ios::binary | std::ios::in | std::ios::out);
  bytes.seekp(4).put(2);
  bytes.close();
  CHECK_THROWS_WITH(load_maps(file), Catch::Contains("version 2; make the map again with `horopter map`"));
  MapSet lower = wall.maps;
  auto& [table, report] = lower.maps.back();
  auto facts = table.facts();
  for (std::uint8_t& area : facts.areas) area = static_cast<std::uint8_t>(area - 10);  // 0.42 of it
  table.seal(facts);
  report.crc = table.crc();
  save_maps(lower, file);
  CHECK_THROWS_WITH(load_maps(file), Catch::Contains("areas that are smaller than its rig and control points say"));
}

TEST_CASE("A hand's velocity in mm a second, from whole images and from fields") {
  const Wall wall(GENERATE("vga", "field"));
  CAPTURE(wall.profile.name);
  ObjectFollower follower(wall.profile, wall.tables, wall.maps.rig);
  const double pairs_per_s = 25;
  const Vector3d way_mm = wall.place(44, -10) - wall.place(0, 0);  // 1.3 m/s
  TrackedObject last;
  for (int pair = 0; pair < 5; ++pair) {
    for (std::size_t scan = 0; scan < wall.tables.size(); ++scan) {
      const auto found = follower.follow(wall.frame(scan, wall.place(-90, 20) + pair * way_mm, 80), pair / pairs_per_s);
      REQUIRE(found.size() == 1);
      CHECK(found[0].id == 1);
      last = found[0];
    }
  }
  CHECK(last.age_frames == 5 * static_cast<int>(wall.tables.size()));
  REQUIRE(last.motion);
  REQUIRE(last.motion->mm_s());
  CHECK((*last.motion->mm_s() - pairs_per_s * way_mm).norm() < 20);
}

TEST_CASE("An object is followed before it is large enough for an alarm, and said from then on") {
  const Wall wall("vga");
  ObjectFollower follower(wall.profile, wall.tables, wall.maps.rig);
  const int limit = 5000;
  int frames = 0, said = 0;
  for (const double diameter_mm : {8.0, 20.0, 50.0, 70.0, 90.0, 100.0, 30.0}) {
    const FrameResult result = wall.frame(0, wall.place(0, 0), diameter_mm, limit);
    const auto objects = objects_of(result);
    REQUIRE(objects.size() == 1);
    frames += objects[0].pixels >= limit / 4 ? 1 : 0;
    const auto found = follower.follow(result);
    REQUIRE(found.empty() == (objects[0].pixels < limit));
    if (found.empty()) continue;
    ++said;
    CHECK(found[0].id == 1);
    CHECK(found[0].age_frames == frames);
    CHECK(found[0].age_frames > 1);
  }
  CHECK(said >= 2);
  // Where no object is an alarm there is none.
  FrameResult result = wall.frame(0, wall.place(0, 0), 90, 0);
  CHECK(follower.follow(result).empty());
}

TEST_CASE("A summary says of an object what is known, and leaves out what is not") {
  TrackedObject object;
  object.region = {10, 20, 30, 40, 900, 24.96, 39.04, 100};
  object.id = 7;
  object.age_frames = 3;
  nlohmann::ordered_json json = object_json(object);
  CHECK(json.dump() ==
        R"({"id":7,"area_px":900,"skin_pixels":800,"blind_pixels":100,"box":[10,20,30,40],"centroid_px":[25.0,39.0],)"
        R"("age_frames":3})");
  object.motion = ObjectMotion{{2, -1.5}, {}, {}};
  CHECK(object_json(object)["velocity_px_frame"].dump() == "[2.0,-1.5]");
  object.motion->frame_s = 0.04;
  json = object_json(object);
  CHECK(json["velocity_px_s"].dump() == "[50.0,-37.5]");
  CHECK_FALSE(json.contains("velocity_px_frame"));
  object.in_space = ObjectInSpace{1234.56, 60.04, 20.06, {-1.26, 2, 800}};
  object.motion->mm_frame = Vector3d(1, -0.001, -0.5);
  json = object_json(object);
  CHECK(json["area_mm2"].dump() == "1234.6");
  CHECK(json["size_mm"].dump() == "[60.0,20.1]");
  CHECK(json["centroid_mm"].dump() == "[-1.3,2.0,800.0]");
  CHECK(json["velocity_mm_s"].dump() == "[25.0,0.0,-12.5]");
  CHECK_FALSE(json.contains("velocity_px_s"));
  object.motion->frame_s.reset();
  json = object_json(object);
  CHECK(json["velocity_mm_frame"].dump() == "[1.0,0.0,-0.5]");
  CHECK_FALSE(json.contains("velocity_mm_s"));
}

TEST_CASE("The pixels of an object are those of its region, and no other's") {
  const Wall wall("vga");
  FrameResult result = nothing_in(*wall.tables[0], 1);
  // A ring, and a disc within it.
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double r = std::hypot(x - 320, y - 240);
      if (r < 40 || (r > 60 && r < 100)) result.states.at(x, y) = static_cast<std::uint8_t>(State::skin);
    }
  }
  const auto objects = object_pixels(result, 1, 9);
  REQUIRE(objects.size() == 2);
  const auto regions = objects_of(result);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(objects[i].region == regions[i]);
    std::int64_t pixels = 0;
    for (const PixelRun& run : objects[i].runs) pixels += run.last - run.first + 1;
    CHECK(pixels == regions[i].pixels);
  }
  CHECK(object_pixels(result, 1, 1).size() == 1);
  CHECK(object_pixels(result, regions[0].pixels, 9).size() == 1);
  CHECK(object_pixels(result, regions[0].pixels + 1, 9).empty());
}

}  // namespace horopter
