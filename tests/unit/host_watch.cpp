// SPDX-License-Identifier: Apache-2.0
// Planning a rig against brute force: places thrown at random, and projected by the camera model (E2).
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "horopter/plan/plan_rig.hpp"
#include "horopter/plan/watch.hpp"
#include "table_11_1.hpp"

namespace horopter {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = M_PI / 180;

bool in_image(const calib::Camera& camera, const Vector3d& place, double border_px = 0) {
  const auto pixel = camera.project(place);
  return pixel && pixel->x() >= border_px - 0.5 && pixel->x() <= camera.width_px - 0.5 - border_px &&
         pixel->y() >= border_px - 0.5 && pixel->y() <= camera.height_px - 0.5 - border_px;
}

double angle_deg(const Vector3d& sight, const Vector3d& normal) {
  return std::acos(std::abs(sight.normalized().dot(normal))) / kDegree;
}

bool on_face(const Vector3d& place, const Eigen::AlignedBox3d& box) {
  return ((place - box.min()).cwiseAbs().minCoeff() < 1e-6 || (place - box.max()).cwiseAbs().minCoeff() < 1e-6);
}

}  // namespace

TEST_CASE("A designed rig is that of Table 11.1") {
  const calib::Rig rig = make_rig({10, 8.5, 756, 572, 152, 4});
  const StereoAxis axis(CameraPair(rig.cameras[0], rig.cameras[1]));
  CHECK(axis.baseline_mm == Approx(152));
  CHECK(axis.tilt_deg == Approx(4));
  CHECK(axis.direction.z() == Approx(1));
  CHECK(axis.f_px == Approx(10 / 0.0085));
  // The axes meet where the tilt says, and the formula of 11.1 gives the baseline back.
  const double tilt = converging_tilt_deg(152, 800);
  const calib::Rig met = make_rig({10, 8.5, 756, 572, 152, tilt});
  for (const calib::Camera& camera : met.cameras) {
    CHECK(camera.project({0, 0, 800})->x() == Approx(camera.model.cx_px()));
  }
  CHECK(baseline_for_mm(coplanar_thickness_mm(0.7, 800, 152, 588), 0.7, 800, 588) == Approx(152));
  CHECK_THROWS_AS(make_rig({10, 8.5, 756, 572, 0, 4}), std::invalid_argument);
  CHECK_THROWS_AS(make_rig({10, 8.5, 756, 572, 152, 90}), std::invalid_argument);
}

TEST_CASE("The axis is seen where both images show it") {
  const auto range = [](double tilt_deg) {
    const calib::Rig rig = make_rig({10, 8.5, 756, 572, 152, tilt_deg});
    return depth_range(CameraPair(rig.cameras[0], rig.cameras[1]));
  };
  // Half the field of view, to the centres of the outermost pixels.
  const double half_deg = std::atan(377.5 * 0.0085 / 10) / kDegree;
  const auto place = [&](double angle_deg) { return 76 / std::tan(angle_deg * kDegree); };
  CHECK(range(4)->nearest_mm == Approx(place(half_deg + 4)));
  CHECK(std::isinf(range(4)->farthest_mm));
  CHECK(range(30)->nearest_mm == Approx(place(half_deg + 30)));
  CHECK(range(30)->farthest_mm == Approx(place(30 - half_deg)));
  CHECK_FALSE(range(-40).has_value());
}

TEST_CASE("The common field of view is what both cameras see of places thrown on the skin") {
  const Vector3d normal = Vector3d(0.5, -0.3, -1).normalized();
  const SurfacePtr skin = make_plane({0, 0, 800}, normal);
  for (const double kappa1 : {0.0, 2e-3}) {
    const CameraPair cameras = table_11_1(378, 286, kappa1);
    const ScanGeometry frame{378, 286, Scan::progressive};
    const ViewLimits limits{.smallest_scale = 0.5, .largest_angle_deg = 35};
    const CommonField field = common_field(cameras, *skin, frame, limits);
    const Vector3d u = normal.unitOrthogonal();
    const Vector3d v = normal.cross(u);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> side(-900, 900);
    constexpr int kPlaces = 400'000;
    int left = 0;
    int common = 0;
    int supervised = 0;
    double widest = 0;
    double steepest = 0;
    for (int i = 0; i < kPlaces; ++i) {
      const double du = side(random);
      const Vector3d place = Vector3d(0, 0, 800) + du * u + side(random) * v;
      if (!in_image(cameras.left(), place)) continue;
      ++left;
      if (!in_image(cameras.right(), place)) continue;
      ++common;
      widest = std::max(widest, std::abs(place.x()));
      const double from_left = angle_deg(place - cameras.left().world_to_camera.centre(), normal);
      const double from_right = angle_deg(place - cameras.right().world_to_camera.centre(), normal);
      steepest = std::max(steepest, from_right);
      supervised += from_left <= 35 && from_right <= 35 ? 1 : 0;
    }
    const double m2 = 1.8 * 1.8 / kPlaces;
    CAPTURE(kappa1, left, common, supervised);
    CHECK(field.left_m2 == Approx(left * m2).epsilon(0.015));
    CHECK(field.common_m2 == Approx(common * m2).epsilon(0.015));
    CHECK(field.supervised_m2 == Approx(supervised * m2).epsilon(0.02));
    CHECK(field.exploitation() == Approx(static_cast<double>(common) / left).epsilon(0.01));
    CHECK(supervised < 0.9 * common);  // the limit does something here
    CHECK(field.width_mm > widest);
    CHECK(field.width_mm < 2 * widest * 1.02);
    CHECK(field.right_angle_deg.largest == Approx(steepest).margin(0.5));
  }
}

TEST_CASE("A place of the skin is seen where all pixels of its windows are, in both images") {
  const CameraPair cameras = table_11_1(378, 286, 1e-3);
  const MachineProfile& profile = find_profile("vga");
  const ScanGeometry frame{378, 286, Scan::progressive};
  const SurfacePtr skin = make_plane({0, 0, 800}, {0.3, 0, -1});
  // A ball before a part of it.
  const Vector3d ball(80, 20, 500);
  const Watch watch(cameras, skin, make_ellipsoid(at(ball), {30, 30, 30}), profile, frame);
  const auto free = [&](const Vector3d& place, const Vector3d& camera) {
    const Vector3d way = (place - camera).normalized();
    const double along = (ball - camera).dot(way);
    return (camera + along * way - ball).norm() > 30;
  };
  std::mt19937 random(3);
  std::uniform_real_distribution<double> side(-400, 400);
  int seen = 0;
  int outside = 0;
  int behind_ball = 0;
  int doubtful = 0;
  for (int i = 0; i < 3000; ++i) {
    const double x = side(random);
    const Vector3d place(x, side(random) / 2, 800 + 0.3 * x);
    const Sight sight = watch.at(place);
    const auto pixel = cameras.left().project(place);
    if (!in_image(cameras.left(), place)) {
      CHECK(sight == Sight::outside_left);
      ++outside;
      continue;
    }
    // Every second pixel of the window; the window's border may round either way.
    const auto whole = [&](int reach) {
      for (int dy = -reach; dy <= reach; dy += 3) {
        for (int dx = -reach; dx <= reach; dx += 3) {
          const Point at{pixel->x() + dx, pixel->y() + dy};
          if (!frame.holds(at)) return false;
          const Rays rays = cameras.rays(std::vector<Point>{at});
          Hit hit;
          skin->intersect(cameras.left().world_to_camera.centre(), rays.directions, {&hit, 1});
          const Vector3d there = cameras.left().world_to_camera.centre() + hit.distance * rays.directions[0];
          const auto source = cameras.right().project(there);
          if (!source || !frame.holds({source->x(), source->y()})) return false;
          if (!free(there, cameras.left().world_to_camera.centre())) return false;
          if (!free(there, cameras.right().world_to_camera.centre())) return false;
        }
      }
      return true;
    };
    const int reach = profile.offset();  // 9: a multiple of the step of 3
    const bool surely = whole(reach + 3);
    const bool surely_not = !whole(reach - 3);
    doubtful += !surely && !surely_not ? 1 : 0;
    CAPTURE(place.transpose(), pixel->transpose(), sight_name(sight));
    if (surely) CHECK(sight == Sight::seen);
    if (surely_not) CHECK(sight != Sight::seen);
    seen += sight == Sight::seen ? 1 : 0;
    behind_ball += sight == Sight::obstacle ? 1 : 0;
  }
  CHECK(seen > 500);
  CHECK(outside > 500);
  CHECK(behind_ball > 20);
  CHECK(doubtful < 400);
}

TEST_CASE("Sub-sampled fields: a pixel of the result stands for two of the image") {
  // Parallel, so that rows stay rows.
  const calib::Rig rig = make_rig({10, 8.5, 756, 572, 152, 0});
  const CameraPair cameras(rig.cameras[0], rig.cameras[1]);
  const Watch watch(cameras, make_plane({0, 0, 800}, {0, 0, 1}), nullptr, find_profile("field"),
                    scans_of(find_profile("field"), 756, 572).front());
  CHECK(watch.width() == 378);
  CHECK(watch.height() == 286);
  CHECK(watch.at({0, 0, 800}) == Sight::seen);
  const int reach = find_profile("field").offset();
  CHECK(watch.pixel(200, reach - 1) != Sight::seen);
  CHECK(watch.pixel(200, reach) == Sight::seen);
}

TEST_CASE("A box on a table is entered where straight ways through its faces are not seen") {
  // Cameras above; z points down to the table.
  const CameraPair cameras = table_11_1(378, 286, 1e-3);
  const MachineProfile& profile = find_profile("vga");
  const ScanGeometry frame{378, 286, Scan::progressive};
  const Eigen::AlignedBox3d extent(Vector3d(-60, -50, 760), Vector3d(60, 50, 900));
  const SurfacePtr box = make_box(at(extent.center()), extent.sizes());
  const SurfacePtr table = make_plane({0, 0, 900}, {0, 0, -1});
  const Watch watch(cameras, box, table, profile, frame);
  const EntryPlan plan = plan_entries(watch, *box, {.step_mm = 7, .margin_mm = 60, .from_mm = Vector3d(0, 0, 600)});
  REQUIRE(!plan.openings.empty());
  CHECK(plan.path_mm.size() > 2);
  CHECK(plan.path_mm.front().z() == Approx(600).margin(7));

  // Brute force: ways from everywhere above the table to the middle of the box.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> side(-1, 1);
  int unseen = 0;
  int seen = 0;
  for (int i = 0; i < 4000; ++i) {
    Vector3d way(side(random), side(random), side(random));
    const Vector3d far = extent.center() + 400 * way.normalized();
    if (far.z() > 899) continue;
    const Vector3d back = extent.center() - far;
    Hit hit;
    box->intersect(far, {&back, 1}, {&hit, 1});
    const Vector3d place = far + hit.distance * back;
    REQUIRE(on_face(place, extent));
    double nearest = 1e9;
    for (const Vector3d& entry : plan.unseen_mm) nearest = std::min(nearest, (entry - place).norm());
    if (watch.at(place) == Sight::seen) {
      ++seen;
    } else {
      CHECK(nearest < 2 * 7.0);
      ++unseen;
    }
  }
  CHECK(unseen > 300);
  CHECK(seen > 100);
  // Every entry is a place of the box that is not seen: on its upright sides.
  for (const Vector3d& entry : plan.unseen_mm) {
    CHECK(on_face(entry, extent));
    CHECK(watch.at(entry) != Sight::seen);
  }
  CHECK(std::ranges::none_of(plan.unseen_mm, [](const Vector3d& p) {
    return std::abs(p.z() - 760) < 1e-6 && std::abs(p.x()) < 20 && std::abs(p.y()) < 20;
  }));
}

TEST_CASE("A hood that the cameras see all around closes a zone; a hole in it opens it") {
  const CameraPair cameras = table_11_1(378, 286, 0);
  const MachineProfile& profile = find_profile("vga");
  const ScanGeometry frame{378, 286, Scan::progressive};
  const SurfacePtr table = make_plane({0, 0, 900}, {0, 0, -1});
  const SurfacePtr zone = make_box(at({0, 0, 880}), {40, 40, 39});
  // A pyramid without its point, seen at less than 70 degrees: four faces, or three, and a top. With a brim along the
  // table: at its rim a skin is not decided, for half a window.
  const auto hood = [](bool closed) {
    const auto ring = [](double x, double y, double z) {
      return std::array{Vector3d(-x, -y, z), Vector3d(x, -y, z), Vector3d(x, y, z), Vector3d(-x, y, z)};
    };
    const auto rim = ring(160, 140, 900);
    const auto foot = ring(90, 80, 900);
    const auto top = ring(40, 35, 820);
    std::vector<Polygon> faces{{top[0], top[1], top[2], top[3]}};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = (i + 1) % 4;
      faces.push_back({rim[i], rim[j], foot[j], foot[i]});
      if (closed || i < 3) faces.push_back({foot[i], foot[j], top[j], top[i]});
    }
    return make_polygons(faces);
  };
  const EntrySearch search{.step_mm = 8, .margin_mm = 80, .from_mm = Vector3d(0, 0, 700)};
  const EntryPlan closed = plan_entries(Watch(cameras, hood(true), table, profile, frame), *zone, search);
  CHECK(closed.unseen_mm.empty());
  CHECK(closed.path_mm.empty());
  CHECK(closed.zone_mm.size() > 50);
  const EntryPlan open = plan_entries(Watch(cameras, hood(false), table, profile, frame), *zone, search);
  REQUIRE(open.openings.size() == 1);
  // In through the face on the left.
  const auto crossing = std::ranges::find_if(open.path_mm, [](const Vector3d& p) { return p.z() > 830; });
  REQUIRE(crossing != open.path_mm.end());
  CHECK(crossing->x() < 0);
  // Everywhere around includes below the table, from where the table keeps everyone away.
  const EntryPlan around = plan_entries(Watch(cameras, hood(true), table, profile, frame), *zone, {.step_mm = 8});
  CHECK(around.unseen_mm.empty());
  // Without the table, from below.
  const EntryPlan below = plan_entries(Watch(cameras, hood(true), nullptr, profile, frame), *zone, {.step_mm = 8});
  REQUIRE(!below.openings.empty());
  CHECK(below.openings.front().reason == Sight::no_skin);
  CHECK_THROWS_AS(plan_entries(Watch(cameras, hood(true), nullptr, profile, frame), *table, {}), std::invalid_argument);
  CHECK_THROWS_AS(plan_entries(Watch(cameras, hood(true), table, profile, frame), *zone, {.step_mm = 0.1}),
                  std::invalid_argument);
}

TEST_CASE("Surfaces say where they end") {
  const auto ends = [](const SurfacePtr& surface) {
    Eigen::AlignedBox3d box;
    surface->extend(box);
    return box;
  };
  const auto check = [&](const SurfacePtr& surface, const Vector3d& low, const Vector3d& high) {
    CHECK((ends(surface).min() - low).norm() < 1e-6);
    CHECK((ends(surface).max() - high).norm() < 1e-6);
  };
  calib::Pose turned = at({10, 20, 30});
  turned.rotation = calib::rotation_from_vector({0, 0, M_PI / 2});
  check(make_box(turned, {2, 4, 6}), {8, 19, 27}, {12, 21, 33});
  check(make_ellipsoid(turned, {1, 2, 3}), {8, 19, 27}, {12, 21, 33});
  check(make_capsules({{{0, 0, 0}, {10, 0, 0}, 2}}), {-2, -2, -2}, {12, 2, 2});
  check(make_polygons({{{0, 0, 5}, {3, 0, 5}, {0, 4, 5}}}), {0, 0, 5}, {3, 4, 5});
  check(make_union({make_box(at({0, 0, 0}), {2, 2, 2}), make_plane({0, 0, 7}, {0, 0, 2})}), {-1, -1, -1}, {1, 1, 7});
  check(make_moved(make_box(at({0, 0, 0}), {2, 4, 6}), turned), {8, 19, 27}, {12, 21, 33});
  check(make_mesh(height_field({1, 2, 0}, {5, 6}, {{3, 4}, {5, 6}})), {1, 2, 3}, {6, 8, 6});
  CHECK(ends(make_plane({0, 0, 7}, {0, 1, 1})).isEmpty());
}

}  // namespace horopter
