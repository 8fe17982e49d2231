// SPDX-License-Identifier: Apache-2.0
// What a table knows of the cameras. Where epipolar lines leave the row, so that neighbours which compete cannot be
// served, and the range of shifts, both against brute force, which knows no epipolar line: it moves an object along the
// left line of sight and looks where on the skin the right camera sees it. The areas of pixels against the skin's.
#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

#include "horopter/base/error.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/map/row_check.hpp"
#include "horopter/plan/plan_rig.hpp"
#include "stages/planes.hpp"
#include "table_11_1.hpp"

namespace horopter {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = M_PI / 180;
constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr ScanGeometry kScan{kWidth, kHeight, Scan::progressive};
const MachineProfile& vga() { return find_profile("vga"); }
ViewLimits competing() { return view_limits(vga(), Decision::compete); }

struct Design {
  double toe_in_deg = 0;      ///< of each camera towards the other
  double roll_deg = 0;        ///< of both about their axes, so that the baseline is not in the rows
  double right_roll_deg = 0;  ///< of the right one besides
  double k1 = 0;
};

/// 100 mm apart, with images of kWidth × kHeight pixels.
CameraPair rig_of(const Design& design) {
  const auto camera = [&](const char* name, double side, double roll_deg) {
    calib::BrownConradyIntrinsics lens{600, 600, 0.5 * (kWidth - 1), 0.5 * (kHeight - 1), {}};
    lens.lens.k1 = design.k1;
    calib::Camera result{name, kWidth, kHeight, calib::CameraModel(lens), {}};
    result.world_to_camera.rotation = calib::rotation_from_vector({0, 0, roll_deg * kDegree}) *
                                      calib::rotation_from_vector({0, side * design.toe_in_deg * kDegree, 0});
    result.world_to_camera.translation_mm = -(result.world_to_camera.rotation * Vector3d(side * 50, 0, 0));
    return result;
  };
  return {camera("left", -1, design.roll_deg), camera("right", 1, design.roll_deg + design.right_roll_deg)};
}

SurfacePtr wall() { return make_plane({0, 0, 900}, {0.2, 0.1, -1}); }

/// Where in the left image the skin is that the right camera has behind, or in front of, a place on the left pixel's
/// line of sight: what the table brings there from that place.
std::optional<Eigen::Vector2d> brought_from(const CameraPair& cameras, const Surface& skin, Point left,
                                            double over_distance) {
  const calib::Camera& l = cameras.left();
  const calib::Camera& r = cameras.right();
  const auto sight = l.model.undistort({left.x, left.y});
  if (!sight) return {};
  const Vector3d in_world = l.world_to_camera.rotation.transpose() * sight->homogeneous();
  const Vector3d right_centre = r.world_to_camera.centre();
  // Homogeneous: beyond infinity, too.
  const Vector3d towards = in_world + over_distance * (l.world_to_camera.centre() - right_centre);
  Hit hit;
  skin.intersect(right_centre, std::span(&towards, 1), std::span(&hit, 1));
  if (!std::isfinite(hit.distance)) return {};
  return l.project(right_centre + hit.distance * towards);
}

/// How far that leaves the row while it goes by up to so many columns, either way.
std::optional<double> leaves_row(const CameraPair& cameras, const Surface& skin, Point left, double shift) {
  const auto sight = cameras.left().model.undistort({left.x, left.y});
  const Vector3d eye = cameras.left().world_to_camera.centre();
  const Vector3d in_world = cameras.left().world_to_camera.rotation.transpose() * sight->homogeneous();
  Hit hit;
  skin.intersect(eye, std::span(&in_world, 1), std::span(&hit, 1));
  double largest = 0;
  for (const double step : {-2e-6, 2e-6}) {
    Eigen::Vector2d before(left.x, left.y);
    for (double over_distance = 1 / hit.distance;; over_distance += step) {
      const auto now = brought_from(cameras, skin, left, over_distance);
      if (!now) return {};
      const double from = std::abs(before.x() - left.x);
      const double to = std::abs(now->x() - left.x);
      if (to < shift) {
        largest = std::max(largest, std::abs(now->y() - left.y));
        before = *now;
        continue;
      }
      const double share = (shift - from) / (to - from);
      largest = std::max(largest, std::abs(before.y() + share * (now->y() - before.y()) - left.y));
      break;
    }
  }
  return largest;
}

bool skin_at(const CameraPair& cameras, const Surface& skin, Point left) {
  const auto sight = cameras.left().model.undistort({left.x, left.y});
  const Vector3d in_world = cameras.left().world_to_camera.rotation.transpose() * sight->homogeneous();
  Hit hit;
  skin.intersect(cameras.left().world_to_camera.centre(), std::span(&in_world, 1), std::span(&hit, 1));
  return std::isfinite(hit.distance);
}

std::vector<Point> some_pixels() {
  std::vector<Point> points;
  for (int y = 5; y < kHeight; y += 47) {
    for (int x = 5; x < kWidth; x += 63) points.push_back({double(x), double(y)});
  }
  return points;
}

MapSet set_of(const CameraPair& cameras, CompiledMap map) {
  MapSet set{"vga", kWidth, kHeight, "", calib::to_yaml({"", {cameras.left(), cameras.right()}}), {}};
  set.maps.push_back(std::move(map));
  return set;
}

}  // namespace

TEST_CASE("Neighbours are shifted by the reach of the planes; a profile without them is refused") {
  CHECK(competing().largest_shift_px == stages::planes_19.reach());
  CHECK(view_limits(find_profile("hd"), Decision::compete).largest_shift_px == stages::planes_19.reach());
  CHECK(view_limits(vga(), Decision::thesis).largest_shift_px == 0);
  CHECK(view_limits(find_profile("field"), Decision::thesis).largest_shift_px == 0);
  CHECK_THROWS_AS(view_limits(find_profile("field"), Decision::compete), UsageError);
}

TEST_CASE("Where epipolar lines leave the row is where brute force says, whatever the skin and the right camera") {
  const Design design =
      GENERATE(Design{}, Design{.right_roll_deg = 3}, Design{.roll_deg = 1}, Design{.roll_deg = -1.4, .k1 = 0.05},
               Design{.toe_in_deg = 4}, Design{.toe_in_deg = 12, .right_roll_deg = -2}, Design{.k1 = -0.25},
               Design{.toe_in_deg = 3, .roll_deg = 0.7, .k1 = -0.1});
  const bool round = GENERATE(false, true);
  CAPTURE(design.toe_in_deg, design.roll_deg, design.right_roll_deg, design.k1, round);
  const CameraPair cameras = rig_of(design);
  const SurfacePtr skin = round ? make_ellipsoid({Eigen::Matrix3d::Identity(), {0, 0, 1700}}, {900, 900, 800}) : wall();
  const std::vector<Point> points = some_pixels();
  const ViewLimits limits = competing();
  const Rays rays = cameras.rays(points, limits);
  std::vector<Look> looks(points.size());
  std::vector<Look> free(points.size());
  RigSkin(cameras, skin, "").look(points, 1, limits, looks);
  RigSkin(cameras, skin, "").look(points, 1, {}, free);
  int checked = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    CAPTURE(points[i].x, points[i].y);
    CHECK((free[i].reason == looks[i].reason || (looks[i].reason == Reason::row && free[i].reason == Reason::none)));
    if (free[i].reason != Reason::none) continue;
    const auto truth = leaves_row(cameras, *skin, points[i], limits.largest_shift_px);
    if (!truth) continue;
    ++checked;
    CHECK(rays.row_error[i] == Approx(*truth).margin(0.003));
    if (std::abs(*truth - 0.5) > 0.003) CHECK((looks[i].reason == Reason::row) == (*truth > 0.5));
    CHECK((looks[i].margin < 0) == (looks[i].reason != Reason::none));
    if (design.toe_in_deg == 0 && design.roll_deg == 0 && design.k1 == 0) CHECK(rays.row_error[i] < 1e-9);
  }
  CHECK(checked > 60);
}

TEST_CASE("A rolled rig is served up to the angle by which the largest shift leaves the row by half a pixel") {
  const ViewLimits limits = competing();
  const double limit_deg = std::atan(0.5 / limits.largest_shift_px) / kDegree;
  const MapLimits with_rows{.view = limits};
  for (const double sign : {-1.0, 1.0}) {
    const CameraPair served = rig_of({.roll_deg = sign * (limit_deg - 0.01)});
    const auto map = compile_map(RigSkin(served, wall(), ""), vga(), kScan, with_rows);
    CHECK(map.report.count(Reason::row) == 0);
    CHECK(map.report.supervised() > kWidth * kHeight / 2);

    const CameraPair refused = rig_of({.roll_deg = sign * (limit_deg + 0.01)});
    CHECK_THROWS_AS(compile_map(RigSkin(refused, wall(), ""), vga(), kScan, with_rows), RowError);
    CHECK_THROWS_AS(MapCompiler(refused, vga(), kScan, with_rows).compile(*wall()), RowError);
    CHECK(compile_map(RigSkin(refused, wall(), ""), vga(), kScan).report.count(Reason::row) == 0);
    // Two rows of a frame are one of a field.
    Look look;
    const Point middle{320, 240};
    RigSkin(refused, wall(), "").look({&middle, 1}, 2, limits, {&look, 1});
    CHECK(look.reason == Reason::none);
  }
}

TEST_CASE("The thesis's cameras of Table 11.1 are served; tilted three times as much, where lines converge little") {
  const ViewLimits limits = competing();
  const MapLimits with_rows{.view = limits};
  const SurfacePtr plane = make_plane({0, 0, 800}, {0, 0, -1});
  const CameraPair thesis = table_11_1(kWidth, kHeight, 0);
  CHECK(compile_map(RigSkin(thesis, plane, ""), vga(), kScan, with_rows).report.count(Reason::row) == 0);

  // All epipolar lines meet in one place: f/tan(tilt) beside the principal point.
  const CameraPair tilted = rig_of({.toe_in_deg = 12});
  const double meeting_px = 600 / std::tan(12 * kDegree);
  std::int64_t expected = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double slope = (y - 239.5) / (meeting_px - (x - 319.5));
      expected += std::abs(slope) * limits.largest_shift_px > 0.5 ? 1 : 0;
    }
  }
  std::int64_t found = 0;
  for (int y = 0; y < kHeight; ++y) {
    std::vector<Point> row;
    for (int x = 0; x < kWidth; ++x) row.push_back({double(x), double(y)});
    const Rays rays = tilted.rays(row, limits);
    found += std::ranges::count_if(rays.row_error, [](double error) { return error > kLargestRowError; });
  }
  CHECK(expected > kWidth * kHeight / 4);
  CHECK(found == expected);
}

TEST_CASE("Tables for neighbours supervise no pixel whose line leaves the row; those for one skin may") {
  const Design design = GENERATE(Design{.toe_in_deg = 12}, Design{.k1 = -0.25});
  CAPTURE(design.toe_in_deg, design.k1);
  const CameraPair cameras = rig_of(design);
  const MapLimits with_rows{.view = competing()};
  const RigSkin skin(cameras, make_plane({0, 0, 300}, {0, 0, -1}), "");
  const CompiledMap free = compile_map(skin, vga(), kScan);
  const CompiledMap limited = compile_map(skin, vga(), kScan, with_rows);
  CHECK(limited.report.count(Reason::row) > kWidth * kHeight / 5);
  CHECK(limited.report.lost_share() < 0.05);
  const double beyond = share_beyond_rows(set_of(cameras, free), vga(), competing());
  CHECK(beyond > 0.2);
  CHECK(share_beyond_rows(set_of(cameras, limited), vga(), competing()) == 0);
  // The fast compiler, which looks at samples.
  const CompiledMap fast = MapCompiler(cameras, vga(), kScan, with_rows).compile(*skin.surface());
  const Image supervised = fast.table.supervised(vga().weight_bits);
  CHECK(std::ranges::count(supervised.pixels, std::uint8_t{1}) > limited.report.supervised() * 9 / 10);
  CHECK(share_beyond_rows(set_of(cameras, fast), vga(), competing()) == 0);
}

TEST_CASE("What was not followed is not taken for served") {
  const CameraPair cameras = rig_of({});
  const std::vector<Point> points{{320, 240}};
  std::vector<Look> looks(1);
  CHECK_THROWS_AS(cameras.look(*wall(), cameras.rays(points), 1, competing(), looks), std::invalid_argument);

  // Cameras one behind the other: no line stays in a row, and beside the epipole none goes anywhere.
  calib::Camera right = cameras.right();
  right.world_to_camera.translation_mm = {0, 0, -100};
  calib::Camera left = cameras.left();
  left.world_to_camera.translation_mm = {0, 0, 0};
  const CameraPair behind(left, right);
  const std::vector<Point> around{{319.5, 239.5}, {319.5, 300}, {310, 239}};
  for (const double error : behind.rays(around, competing()).row_error) CHECK(!(error <= kLargestRowError));
}

TEST_CASE("A plan counts the pixels that a table loses to their rows, and refuses the same cameras") {
  // At 300 mm, part of what the left camera sees is beside the right image: no table has it, whatever its row.
  const double toe_in_deg = GENERATE(0, 12);
  const CameraPair cameras = rig_of({.toe_in_deg = toe_in_deg});
  const SurfacePtr plane = make_plane({0, 0, 300}, {0, 0, -1});
  CAPTURE(toe_in_deg);
  const auto plan = plan_thickness(cameras, *plane, vga(), kScan, 1, competing());
  const auto free = plan_thickness(cameras, *plane, vga(), kScan, 1);
  const auto field = common_field(cameras, *plane, kScan, competing());
  CHECK(plan.shared == free.shared);
  CHECK(plan.supervised + plan.rows.leaving == free.supervised);
  CHECK(plan.rows.staying == plan.supervised);
  CHECK(free.rows.leaving == 0);
  CHECK((plan.rows.leaving > 0) == (toe_in_deg > 0));
  // The common field is the same, of which as much less is supervised.
  const auto whole = common_field(cameras, *plane, kScan);
  CHECK(field.common_m2 == Approx(whole.common_m2));
  CHECK(field.supervised_m2 / whole.supervised_m2 == Approx(1 - plan.rows.share()).margin(0.05));
  // What the compiler checks: a pixel at the border of the image, or of the limit, may be lost to the grid besides.
  const auto map = compile_map(RigSkin(cameras, plane, ""), vga(), kScan, {.view = competing()});
  CHECK(static_cast<double>(map.report.supervised()) == Approx(static_cast<double>(plan.supervised)).epsilon(0.03));
}

TEST_CASE("Cameras are refused above the share of the pixels that could be supervised") {
  CHECK_NOTHROW(check_rows({0, 0}, competing()));
  CHECK_NOTHROW(check_rows({90, 10}, competing()));
  CHECK_THROWS_AS(check_rows({91, 9}, competing()), RowError);
  // Not counted: pixels whose source is beyond the right image anyway, which would make it 91 %.
  const CameraPair cameras = rig_of({.toe_in_deg = 10});
  const SurfacePtr near = make_plane({0, 0, 80}, {0, 0, -1});
  CHECK(plan_thickness(cameras, *near, vga(), kScan, 1, competing()).rows.share() < 0.75);
  const MapLimits limits{.view = competing()};
  CHECK_NOTHROW(compile_map(RigSkin(cameras, near, ""), vga(), kScan, limits));
  CHECK_NOTHROW(MapCompiler(cameras, vga(), kScan, limits).compile(*near));
}

TEST_CASE("A table's range of shifts is that of places in front of both cameras") {
  const Design design = GENERATE(Design{}, Design{.toe_in_deg = 2}, Design{.roll_deg = 1}, Design{.k1 = -0.05});
  CAPTURE(design.toe_in_deg, design.roll_deg, design.k1);
  const CameraPair cameras = rig_of(design);
  const SurfacePtr skin = wall();
  const auto shifts = compile_map(RigSkin(cameras, skin, ""), vga(), kScan).table.facts().shifts;
  REQUIRE(shifts);
  double lowest = 0;
  double highest = 0;
  double beyond = 0;  // behind the cameras
  for (const Point& left : some_pixels()) {
    const auto sight = cameras.left().model.undistort({left.x, left.y});
    const double baseline_mm = 100;
    for (const double over_mm : {0.0, 1 / 5000.0, 1 / 300.0, sight->homogeneous().norm() / baseline_mm}) {
      const auto brought = brought_from(cameras, *skin, left, over_mm);
      if (!brought || brought->x() < 0 || brought->x() > kWidth - 1) continue;
      lowest = std::min(lowest, brought->x() - left.x);
      highest = std::max(highest, brought->x() - left.x);
    }
    const auto behind = brought_from(cameras, *skin, left, -1 / 400.0);
    if (behind) beyond = std::max(beyond, behind->x() - left.x);
  }
  CAPTURE(lowest, highest, beyond, shifts->lowest_px, shifts->highest_px);
  // Small shifts exactly; large ones to first order.
  CHECK(shifts->lowest_px <= 0.95 * lowest);
  CHECK(shifts->highest_px >= highest);
  CHECK(shifts->lowest_px >= lowest - 40);
  CHECK(shifts->highest_px <= highest + 12);
  CHECK(beyond > shifts->highest_px + 50);
}

TEST_CASE("The areas of a table's pixels are together that of the skin, or a little more") {
  const MachineProfile& profile = find_profile(GENERATE("vga", "field"));
  const double tilt_deg = GENERATE(0, 40);
  CAPTURE(profile.name, tilt_deg);
  const CameraPair cameras = rig_of({.k1 = -0.05});
  // 500 × 400 mm, wholly seen.
  const Vector3d across = Eigen::AngleAxisd(tilt_deg * kDegree, Vector3d::UnitY()) * Vector3d(250, 0, 0);
  const Vector3d down(0, 200, 0);
  const Vector3d middle(0, 0, 900);
  const SurfacePtr skin =
      make_polygons({{middle - across - down, middle + across - down, middle + across + down, middle - across + down}});
  for (const ScanGeometry& scan : scans_of(profile, kWidth, kHeight)) {
    const MapTable table = compile_map(RigSkin(cameras, skin, ""), profile, scan).table;
    const auto& facts = table.facts();
    REQUIRE(facts.areas.size() == facts.area_count({scan.width, scan.height, 0, 0}));
    double sum_mm2 = 0;
    for (int y = 0; y < scan.height; ++y) {
      for (int x = 0; x < kWidth / profile.subsample; ++x) {
        if (!skin_at(cameras, *skin, scan.to_frame({x * profile.subsample + 0.5 * (profile.subsample - 1), 1.0 * y})))
          continue;
        const auto columns = static_cast<std::size_t>(kWidth / profile.subsample + 31) / 32;
        const auto block = static_cast<std::size_t>(y / 32) * columns + static_cast<std::size_t>(x / 32);
        sum_mm2 += hls::table::decode_area(facts.areas[block]);
      }
    }
    // The largest of each block, kept to an eighth, upwards. At the outline pixels are in or out.
    CHECK(sum_mm2 > 0.99 * 500 * 400);
    CHECK(sum_mm2 < 1.17 * 500 * 400);
  }
}

}  // namespace horopter
