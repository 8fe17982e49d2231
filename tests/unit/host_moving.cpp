// SPDX-License-Identifier: Apache-2.0
// Skins that move: where they are, steps that no object slips through (E3), and their tables.
#include <catch2/catch.hpp>
#include <random>

#include "horopter/base/error.hpp"
#include "horopter/machine/moving_supervisor.hpp"
#include "horopter/machine/native_device.hpp"
#include "horopter/plan/plan.hpp"
#include "host_temporary.hpp"
#include "table_11_1.hpp"

namespace horopter {
namespace {

using Eigen::Vector3d;

const Vector3d kForward(0, 0, 1);

Hit first_hit(const Surface& surface, const Vector3d& from, const Vector3d& direction) {
  Hit hit;
  surface.intersect(from, std::span(&direction, 1), std::span(&hit, 1));
  return hit;
}

double depth_of(const MovingSurface& surface, double time_s) {
  return first_hit(*surface.at(time_s), Vector3d::Zero(), kForward).distance;
}

TimedPose shifted(double time_s, const Vector3d& shift_mm) { return {time_s, shift_mm, Eigen::Matrix3d::Identity()}; }

std::vector<double> plan(const MovingSurface& surface, const MotionLimits& limits, const char* profile = "vga") {
  return plan_motion(table_11_1(160, 120), surface, limits, find_profile(profile), 160, 120);
}

std::string refusal(const MovingSurface& surface, const MotionLimits& limits) {
  try {
    plan(surface, limits);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Poses and segments are interpolated, and stay at the end") {
  const auto plane = make_moving(make_plane({0, 0, 800}, {0, 0, 1}), {0, 0, 800},
                                 {shifted(1, {0, 0, 100}), {2, {0, 0, 100}, calib::rotation_from_vector({0.4, 0, 0})}});
  CHECK(plane->end_s() == 2);
  CHECK(depth_of(*plane, -1) == Approx(800));
  CHECK(depth_of(*plane, 0.25) == Approx(825));
  CHECK(depth_of(*plane, 1.5) == Approx(900));  // turned about what is shifted with it
  const Vector3d normal = first_hit(*plane->at(1.5), Vector3d::Zero(), kForward).normal;
  CHECK(std::acos(std::abs(normal.z())) == Approx(0.2));
  CHECK(std::acos(std::abs(first_hit(*plane->at(7), Vector3d::Zero(), kForward).normal.z())) == Approx(0.4));
  CHECK(plane->way_mm(0, 0.5, {40, -30, 850}) == Approx(50));
  CHECK(plane->way_mm(1, 2, {40, 0, 900}) == Approx(0).margin(1e-9));  // on the axis
  CHECK(plane->way_mm(1, 2, {0, 50, 900}) == Approx(2 * 50 * std::sin(0.2)));

  const Capsule link{{-100, 0, 600}, {100, 0, 600}, 50};
  Capsule swung = link;
  swung.to_mm.z() = 700;
  const auto arm = make_moving_capsules({link}, {{2, {swung}}});
  CHECK(depth_of(*arm, 0) == Approx(550));
  CHECK(depth_of(*arm, 1) == Approx(625 - 50 * std::hypot(1, 0.25)));
  CHECK(arm->way_mm(0, 1, {}) == Approx(50));

  const auto poses = [](std::vector<TimedPose> keys) {
    return make_moving(make_plane({0, 0, 800}, {0, 0, 1}), Vector3d::Zero(), std::move(keys));
  };
  CHECK_THROWS_WITH(poses({}), Catch::Contains("without"));
  CHECK_THROWS_WITH(poses({shifted(0, {})}), Catch::Contains("rise"));
  CHECK_THROWS_WITH(poses({shifted(1, {}), shifted(1, {})}), Catch::Contains("rise"));
  CHECK_THROWS_WITH(poses({shifted(1, {NAN, 0, 0})}), Catch::Contains("none"));
  swung.radius_mm = 60;
  CHECK_THROWS_WITH(make_moving_capsules({link}, {{2, {swung}}}), Catch::Contains("radii"));
}

TEST_CASE("Steps and an object's motion together stay below the thickness; intermediate skins are inserted") {
  const CameraPair cameras = table_11_1(160, 120);  // pixels of 40 um: about 35 mm thick
  const MachineProfile& profile = find_profile("vga");
  const double speed_m_s = GENERATE(0.05, 0.6, 0.9);
  const double shift_mm = GENERATE(-100.0, 150.0, 1000.0);
  CAPTURE(speed_m_s, shift_mm);
  const auto plane =
      make_moving(make_plane({0, 0, 800}, {0.3, 0, 1}), Vector3d::Zero(), {shifted(0.5, {0, 0, shift_mm})});
  const MotionLimits limits{60, speed_m_s, 0.7};
  const auto times = plan(*plane, limits);
  CHECK(times.front() == 0);
  CHECK(times.back() == 0.5);
  const double object_mm = speed_m_s * 1e3 / 60;
  // Independent of the planner: every pixel of every frame, by the thickness of `plan thickness`.
  const Vector3d normal = Vector3d(0.3, 0, 1).normalized();
  double closest = 0;
  double thinnest_before = 0;
  for (std::size_t i = 0; i < times.size(); i += 1) {
    const double thinnest =
        plan_thickness(cameras, *plane->at(times[i]), profile, {160, 120, Scan::progressive}, limits.tolerance_px)
            .across.smallest;
    if (i > 0) {
      CHECK(times[i] > times[i - 1]);
      CHECK(times[i] - times[i - 1] <= 1 / 60.0 + 1e-12);
      const double way = std::abs(normal.z() * shift_mm) * (times[i] - times[i - 1]) / 0.5;
      // The planner's lattice may miss the very thinnest pixel.
      CHECK(way + object_mm <= std::min(thinnest, thinnest_before) * 1.005);
      closest = std::max(closest, (way + object_mm) / thinnest);
    }
    thinnest_before = thinnest;
  }
  // Nothing is inserted where the motion is slow enough; where something is, not much more than is needed.
  if (std::abs(shift_mm) < 200 && speed_m_s < 0.1) CHECK(times.size() == 31);
  if (shift_mm > 500) {
    CHECK(times.size() > 31);
    CHECK(closest > 0.6);
  }
}

TEST_CASE("A motion within the skin needs no steps, one across the line of sight does") {
  const MotionLimits limits{60, 0.1, 0.7};  // an object moves by 1.7 mm
  const auto frames = [&](const MovingSurface& surface) { return plan(surface, limits).size(); };
  // A plane shifted by 10 m along itself stays where it is.
  CHECK(frames(*make_moving(make_plane({0, 0, 800}, {0, 0, 1}), Vector3d::Zero(), {shifted(0.1, {10'000, 0, 0})})) ==
        7);
  // A ball that jumps aside: newly covered pixels had seen nothing before.
  const auto ball = make_ellipsoid(at({0, 0, 800}), {60, 60, 60});
  CHECK(frames(*make_moving(ball, Vector3d::Zero(), {shifted(0.1, {10, 0, 0})})) == 7);
  const auto jump = frames(*make_moving(ball, Vector3d::Zero(), {shifted(1 / 60.0, {150, 0, 0})}));
  CHECK(jump > 150 / 20.0);  // the ball's thickness, 20 mm in front, is 7 mm at its rim
  CHECK(jump < 150 / 4.0);
}

TEST_CASE("An object too fast for the skin is refused, with the speed that is not") {
  const auto plane = make_moving(make_plane({0, 0, 800}, {0, 0, 1}), Vector3d::Zero(), {shifted(1, {0, 0, 10})});
  const std::string text = refusal(*plane, {60, 2 * kHandSpeed_m_s, 0.7});
  CHECK_THAT(text, Catch::Contains("mm thick") && Catch::Contains("must be below"));
  const double below = std::stod(text.substr(text.rfind("below ") + 6));
  CHECK(refusal(*plane, {60, below * 1.005, 0.7}) != "");
  CHECK(refusal(*plane, {60, below * 0.995, 0.7}) == "");
  // An image that may be late gives the object more time.
  CHECK(refusal(*plane, {60, below * 0.995 / 1.06, 0.7, 1e-3}) == "");
  CHECK(refusal(*plane, {60, below * 1.005 / 1.06, 0.7, 1e-3}) != "");
}

TEST_CASE("skin.yaml with motion; tables for fields in turn; the skin stays at the end") {
  const TemporaryDirectory directory;
  const CameraPair cameras = table_11_1(160, 120);
  const calib::Rig rig{"", {cameras.left(), cameras.right()}};
  const auto read = [&](const std::string& text) { return load_skin(directory.write("skin.yaml", text), {}, &rig); };
  const std::string plane = "surface: {type: plane, point_mm: [0, 0, 800], normal: [0, 0, 1]}\n";
  const std::string motion = plane + "motion:\n  frame_rate_per_s: 50\n  object_speed_m_s: 0.1\n";
  const SkinFile skin = read(motion + "  poses: [{time_s: 0.1, shift_mm: [0, 0, 20]}]\n");
  CHECK(skin.motion_limits.tolerance_px == 0.7);
  const MachineProfile& field = find_profile("field");
  MovingMaps maps = compile_motion(skin, field, 160, 120);
  REQUIRE(maps.steps.size() == 7);  // 0 … 0.1 s, and the end in the other field
  CHECK(maps.inserted == 0);
  for (std::size_t i = 0; i < 7; ++i) {
    const MapTable& table = maps.steps[i].map.table;
    CHECK(table.geometry().scan == (i % 2 == 0 ? Scan::even_field : Scan::odd_field));
    CHECK(maps.steps[i].time_s == Approx(std::min(0.02 * static_cast<double>(i), 0.1)));
    CHECK(table.pool_bytes() <= static_cast<std::size_t>(field.pool_bytes) / 2);
    // The table is that of the skin at its time.
    const RigSkin exact(cameras, skin.motion->at(maps.steps[i].time_s), "plane");
    const ScanGeometry& scan = table.geometry();
    const auto expanded = table.expand(80, 30);
    REQUIRE(expanded);
    const Point source = scan.from_frame(*exact.source(scan.to_frame({80, 30})));
    CHECK(std::ldexp(static_cast<double>(expanded->x), -MapTable::kFractionBits) == Approx(source.x).margin(0.07));
    CHECK(std::ldexp(static_cast<double>(expanded->y), -MapTable::kFractionBits) == Approx(source.y).margin(0.07));
  }
  for (const int threads : {1, 3}) {
    const MovingMaps again = compile_motion(skin, field, 160, 120, {}, threads);
    REQUIRE(again.steps.size() == maps.steps.size());
    for (std::size_t i = 0; i < 7; ++i) {
      CHECK(again.steps[i].time_s == maps.steps[i].time_s);
      CHECK(again.steps[i].map.table.words() == maps.steps[i].map.table.words());
      CHECK(again.steps[i].map.report.lookahead == maps.lookahead);
    }
  }
  Settings settings;
  settings.proof.needed = false;  // small images
  MovingSupervisor supervisor(make_native_device(field), field, maps, settings);
  std::mt19937 random(1);
  for (std::size_t image = 0; image < 6; ++image) {
    Image left(160, 120);
    for (auto& pixel : left.pixels) pixel = static_cast<std::uint8_t>(20 + random() % 200);
    const auto results = supervisor.process(left, left);
    REQUIRE(results.size() == 2);
    for (std::size_t parity = 0; parity < 2; ++parity) {
      const std::size_t step = std::min(2 * image + parity, 5 + (parity == 1 ? std::size_t{0} : std::size_t{1}));
      CHECK(results[parity].table_crc == maps.steps[step].map.table.crc());
      CHECK(results[parity].skin_time_s == maps.steps[step].time_s);
      CHECK(results[parity].scan == (parity == 0 ? Scan::even_field : Scan::odd_field));
    }
  }

  const auto error_with = [&](const std::string& text, int threads) -> std::string {
    try {
      compile_motion(read(text), field, 160, 120, {}, threads);
    } catch (const FileError& e) {
      return e.what();
    }
    FAIL("no error for " << text);
    return {};
  };
  // What is wrong first is said, however many look.
  const auto error = [&](const std::string& text) {
    const std::string alone = error_with(text, 1);
    CHECK(error_with(text, 4) == alone);
    return alone;
  };
  CHECK_THAT(error(plane), Catch::Contains("does not move"));
  CHECK_THAT(error(plane + "motion: {}\n"), Catch::Contains("frame_rate_per_s"));
  CHECK_THAT(error(motion), Catch::Contains("poses"));
  CHECK_THAT(error(motion + "  poses: [{time_s: 0}]\n"), Catch::Contains("rise"));
  CHECK_THAT(error(motion + "  poses: [{time_s: 1, shift: [0, 0, 1]}]\n"), Catch::Contains("unknown key 'shift'"));
  CHECK_THAT(error(motion + "  segments: [{time_s: 1, ends_mm: [[0, 0]]}]\n"), Catch::Contains("segments"));
  CHECK_THAT(error(motion + "  poses: [{time_s: 1, shift_mm: [0, 0, -790]}]\n"), Catch::Contains("at "));
  // Half a turn and more has no way of its own: the shortest would be taken, which is another.
  for (const char* const poses : {"{time_s: 1, rotation_deg: [0, 270, 0]}", "{time_s: 1, rotation_deg: [0, 0, 360]}",
                                  "{time_s: 1, rotation_deg: [0, -180, 0]}", "{time_s: 1, rotation_deg: [70, 60, 50]}",
                                  "{time_s: 1, rotation_deg: [0, 0, 170]}, {time_s: 2, rotation_deg: [0, 0, -170]}"}) {
    CHECK_THAT(error(motion + "  poses: [" + poses + "]\n"),
               Catch::Contains("rotation_deg") && Catch::Contains("less than 180: poses in between"));
  }
  CHECK_THAT(error("surface: {type: plane, point_mm: [0, 0, 800], normal: [0, 0, 1]}\nmotion:\n  frame_rate_per_s: 50\n"
                   "  object_speed_m_s: 3.2\n  poses: [{time_s: 1}]\n"),
             Catch::Contains("must be below"));
  const SkinFile arm = read(
      "surface: {type: capsules, segments: [{from_mm: [-50, 0, 800], to_mm: [50, 0, 800], radius_mm: 40}]}\n"
      "motion:\n  frame_rate_per_s: 50\n  object_speed_m_s: 0.1\n"
      "  segments: [{time_s: 1, ends_mm: [[[-50, 0, 820], [50, 0, 780]]]}]\n");
  CHECK(first_hit(*arm.motion->at(0.5), Vector3d::Zero(), kForward).distance == Approx(760).margin(1));
  CHECK(first_hit(*arm.motion->at(1), {40, 0, 0}, kForward).distance < 750);
  // Three quarters of a turn with poses in between: after a half of it the far side is in front.
  const SkinFile turned = read(motion +
                               "  about_mm: [0, 0, 1000]\n  poses: [{time_s: 1, rotation_deg: [0, 135, 0]}, "
                               "{time_s: 2, rotation_deg: [0, 270, 0]}]\n");
  CHECK(first_hit(*turned.motion->at(4.0 / 3), Vector3d::Zero(), kForward).distance == Approx(1200).margin(1));
}

}  // namespace horopter
