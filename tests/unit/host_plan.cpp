// SPDX-License-Identifier: Apache-2.0
// Thickness of skins by the thesis's formulas and by the camera model (E1, E10).
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "horopter/plan/capability.hpp"
#include "horopter/plan/plan.hpp"
#include "table_11_1.hpp"

namespace horopter {
namespace {

using Eigen::Vector3d;

/// Pixel of the right camera that sees a point at a distance along the left line of sight, from the left one.
Point right_pixel(const CameraPair& cameras, Point left, double distance_mm) {
  const Rays rays = cameras.rays(std::array{left});
  const Vector3d point = cameras.left().world_to_camera.centre() + distance_mm * rays.directions[0].normalized();
  const auto pixel = cameras.right().project(point);
  return {pixel->x(), pixel->y()};
}

}  // namespace

TEST_CASE("Formulas of 2.3, 11.1 to 11.3") {
  CHECK(coplanar_thickness_mm(0.7, 800, 152, 10 / 0.017) == Approx(2 * 0.7 * 800 * 800 * 0.017 / (152 * 10)));
  CHECK(sloped_thickness_mm(9, 60) == Approx(4.5));
  CHECK(sloped_thickness_mm(9, 70) == Approx(9 / 3.0).epsilon(0.03));  // "about 1/3"
  CHECK(face_width_mm(9, 45) == Approx(9));
  CHECK(face_width_mm(9, 30) == Approx(9 * std::sqrt(3)));
  CHECK(std::isinf(face_width_mm(9, 0)));
  CHECK(face_share(0) == 1);
  CHECK(face_share(60) == Approx(1 / std::sqrt(3)));
  CHECK(largest_speed_m_s(9.4, 50) == Approx(0.47));
  CHECK(safety_distance_mm(0.1, kHandSpeed_m_s) == Approx(160));
  CHECK(iso_13855_distance_mm(0.2) == Approx(400));
  CHECK(iso_13855_distance_mm(0.26) == Approx(500));
  CHECK(iso_13855_distance_mm(0.5) == Approx(800));
  // 60 ms are three fields; the rest are the lines that the machine waits.
  const Timing timing{find_profile("field"), Decision::thesis, 286, 50, {}, {}};
  CHECK(detection_time_s(timing) == Approx(0.060 + 52.0 / 286 / 50));
}

TEST_CASE("The response time is the sum of its items, each with its source") {
  Timing timing{find_profile("vga"), Decision::thesis, 480, 60, 0.004, {}};
  double sum_s = 0;
  for (const ResponseItem& item : detection_items(timing)) {
    CHECK_FALSE(item.name.empty());
    CHECK_FALSE(item.source.empty());
    CHECK(item.seconds >= 0);
    sum_s += item.seconds;
  }
  CHECK(detection_time_s(timing) == Approx(sum_s));
  CHECK(sum_s == Approx(2 / 60.0 + 0.004 + (64 + 10 + 1 + 9) / 480.0 / 60));
  timing.exposure_s.reset();  // as long as it can be
  CHECK(detection_time_s(timing) == Approx(sum_s - 0.004 + 1 / 60.0));
  timing.decision = Decision::compete;  // larger windows
  CHECK(detection_time_s(timing) > sum_s - 0.004 + 1 / 60.0);
  // Images that may be farther apart: what waits for the next one waits longer.
  Timing live{find_profile("vga"), Decision::thesis, 480, 25, 0.004, 0.060, 3};
  CHECK(detection_time_s(live) == Approx(0.04 + 0.004 + 0.04 + 2 * 0.04 + 0.06));
  live.longest_periods = 1.5;
  CHECK(detection_time_s(live) == Approx(0.06 + 0.004 + 0.04 + 2 * 0.06 + 0.06));
}

TEST_CASE("Of a live monitor in profile field an image may be late, and brings both fields") {
  Timing live{find_profile("field"), Decision::thesis, 286, 50, {}, 0.060};
  live.longest_periods = 1.5;
  // After the second field of an image: the next image 60 ms after the first one, each second field 20 ms later.
  const std::array<double, 7> longest_s{0.04, 0.06, 0.10, 0.12, 0.16, 0.18, 0.22};
  for (int frames = 1; frames <= 7; ++frames) {
    CAPTURE(frames);
    CHECK(live.longest_s(frames) == Approx(longest_s.at(static_cast<std::size_t>(frames - 1))));
  }
  const auto seconds_of = [&](const std::string& name) {
    double found_s = std::nan("");
    for (const ResponseItem& item : detection_items(live)) {
      if (item.name.starts_with(name)) found_s = item.seconds;
    }
    return found_s;
  };
  CHECK(seconds_of("wait for the next image") == Approx(0.04));
  CHECK(seconds_of("transfer") == Approx(0.04));
  CHECK(detection_time_s(live) == Approx(0.16));
  live.alarm_frames = 3;
  CHECK(detection_time_s(live) == Approx(0.16 + 0.06));
  // Without a monitor fields come one by one, and one period apart.
  const Timing hardware{find_profile("field"), Decision::thesis, 286, 50, {}, {}};
  for (int frames = 1; frames <= 7; ++frames) CHECK(hardware.longest_s(frames) == Approx(0.02 * frames));
}

TEST_CASE("ISO 13855 has a distance for fingers, hands and arms, and none beyond") {
  const auto distance = [](double response_s, double mm) { return iso_13855_distance(response_s, mm, mm); };
  const auto finger = distance(0.1, 14);
  REQUIRE(finger);
  CHECK(finger->c_mm == 0);
  CHECK(finger->distance_mm == Approx(200));
  CHECK(distance(0.01, 14)->distance_mm == 100);  // at least
  const auto hand = distance(0.14, 40);
  CHECK(hand->c_mm == Approx(208));
  CHECK(hand->distance_mm == Approx(488));
  CHECK(hand->k_m_s == 2.0);
  // Beyond 500 mm with 1.6 m/s, but 500 mm at least.
  CHECK(distance(0.15, 40)->distance_mm == Approx(500));
  CHECK(distance(0.15, 40)->k_m_s == 1.6);
  CHECK(distance(0.25, 40)->distance_mm == Approx(608));
  CHECK(distance(0.1, 40.1)->c_mm == 850);
  CHECK(distance(0.1, 40.1)->distance_mm == Approx(1010));
  CHECK(distance(0.1, 70)->distance_mm == Approx(1010));
  // What moves faster must be larger. Where the figure of 2.0 m/s gives no 500 mm, that of 1.6 m/s holds, and 500 mm.
  CHECK(iso_13855_distance(0.05, 30, 20)->capability_mm == 30);
  CHECK(iso_13855_distance(0.05, 30, 20)->distance_mm == Approx(100 + 128));
  CHECK(iso_13855_distance(0.2, 30, 20)->capability_mm == 20);
  CHECK(iso_13855_distance(0.2, 30, 20)->distance_mm == Approx(500));
  CHECK(iso_13855_distance(0.3, 30, 20)->distance_mm == Approx(480 + 48));
  CHECK(iso_13855_distance(0.05, std::numeric_limits<double>::infinity(), 20)->distance_mm == Approx(500));
  CHECK(iso_13855_distance(0.05, 60, 50)->c_mm == 850);
  CHECK_FALSE(iso_13855_distance(0.05, 60, 80));
  for (const double none_mm : {70.1, std::numeric_limits<double>::infinity(), std::nan(""), 0.0, -1.0}) {
    CAPTURE(none_mm);
    CHECK_FALSE(distance(0.1, none_mm));
  }
}

TEST_CASE("The smallest body: its cap in the skin is as many pixels as an object has") {
  CHECK(disc_share(Decision::thesis, 16) == 0);
  CHECK(disc_share(Decision::compete, std::nan("")) == 0);
  double before = 0;
  for (double px = 17; px < 200; px += 1) {
    CHECK(disc_share(Decision::thesis, px) >= 0);
    CHECK(disc_share(Decision::thesis, px) <= 1);
    before = std::max(before, disc_share(Decision::thesis, px));
  }
  CHECK(before > 0.5);
  // An alarm takes half a disc: of the smallest that may be asked for both rules show more.
  for (const MachineProfile& profile : profiles()) {
    CAPTURE(profile.name);
    const double px_of_result = smallest_object_px(profile) / profile.subsample;
    CHECK(disc_share(Decision::thesis, px_of_result) > 0.5);
    CHECK(disc_share(Decision::compete, px_of_result) > 0.5);
  }
  // Standing still, in a skin thicker than itself, a ball is a disc.
  Crossing crossing{Decision::thesis, Body::ball, 2000, 0, 1, 0};
  const double mm = smallest_body_mm(crossing, 500, 0.5);
  const double px = mm / 0.5;
  CHECK(M_PI / 4 * px * px * disc_share(Decision::thesis, px) >= 2000 * 0.999);
  CHECK(M_PI / 4 * px * px / 1.03 / 1.03 * disc_share(Decision::thesis, px / 1.03) < 2000);
  // A thin skin shows a cap only.
  CHECK(smallest_body_mm(crossing, 5, 0.5) > 1.5 * mm);
  // Farther away it is smaller.
  CHECK(smallest_body_mm(crossing, 500, 1) > 1.9 * mm);
  // A rod shows more, the larger the limit.
  crossing.body = Body::rod;
  CHECK(smallest_body_mm(crossing, 500, 0.5) < mm);
  crossing.body = Body::ball;
  // Faster than skin and front half are deep: none that is smaller.
  crossing.step_mm = 100;
  const double fast_mm = smallest_body_mm(crossing, 20, 0.5);
  CHECK(fast_mm / 2 + 20 > 100);
  CHECK(std::isinf(smallest_body_mm({Decision::thesis, Body::ball, 2000, kLargestBody_mm, 1, 0}, 20, 0.5)));
  CHECK(std::isinf(smallest_body_mm({Decision::thesis, Body::ball, 1e9, 0, 1, 0}, 20, 0.5)));
  // With a limit of area a body is as small at half the distance, but for what the windows leave of it.
  const Crossing by_area{Decision::thesis, Body::ball, 1, 0, 1, 2000};
  const double far_mm = smallest_body_mm(by_area, 500, 0.5);
  CHECK(far_mm > std::sqrt(4 * 2000 / M_PI));
  CHECK(smallest_body_mm(by_area, 500, 0.25) == Approx(far_mm).epsilon(0.1));
  CHECK(smallest_body_mm(by_area, 500, 0.25) <= far_mm);
  // More images need more time.
  crossing.step_mm = 10;
  const double one_mm = smallest_body_mm(crossing, 40, 0.5);
  crossing.images = 3;
  CHECK(smallest_body_mm(crossing, 40, 0.5) > one_mm);
}

TEST_CASE("The table of study walk is whole: every coat and light, both rules, taught and not, the same limits") {
  CHECK(walked_rods().size() == 2 * 2 * 2 * 4);
  CHECK(walked_lights().size() == 2 * 2 * 2 * 7);
  CHECK(walk_setup().rod_mm == 40);
  for (const auto rows : {walked_rods(), walked_lights()}) {
    for (const Walked& row : rows) {
      CHECK(row.hits <= row.of);
      CHECK(row.of > 0);
      CHECK(nearest_walked_px(row.object_limit_px) == row.object_limit_px);
    }
  }
  CHECK(nearest_walked_px(1) == nearest_walked_px(900));
  CHECK(nearest_walked_px(1'000'000) == 3927);
}

TEST_CASE("Pixels of the skin are as large as the camera model says, in their worst direction") {
  const CameraPair cameras = table_11_1(640, 480, 0);
  const MachineProfile& profile = find_profile("vga");
  const ScanGeometry frame{640, 480, Scan::progressive};
  const SurfacePtr skin = make_plane({0, 0, 800}, {0.5, -0.2, -1});
  const auto plan = plan_thickness(cameras, *skin, profile, frame, 1);
  const Vector3d centre = cameras.left().world_to_camera.centre();
  const auto place = [&](double x, double y) -> Vector3d {
    const Vector3d sight = cameras.rays(std::array{Point{x, y}}).directions[0];
    Hit hit;
    skin->intersect(centre, std::span(&sight, 1), std::span(&hit, 1));
    return centre + hit.distance * sight;
  };
  int checked = 0;
  for (int y = 30; y < 480; y += 70) {
    for (int x = 30; x < 640; x += 70) {
      const double found = plan.mm_per_px[static_cast<std::size_t>(y) * 640 + static_cast<std::size_t>(x)];
      if (std::isnan(found)) continue;
      double largest = 0;
      for (int degrees = 0; degrees < 180; degrees += 2) {
        const double c = 0.5 * std::cos(degrees * M_PI / 180), s = 0.5 * std::sin(degrees * M_PI / 180);
        largest = std::max(largest, (place(x + c, y + s) - place(x - c, y - s)).norm());
      }
      CHECK(found == Approx(largest).epsilon(2e-3));
      ++checked;
    }
  }
  CHECK(checked > 20);
  const CapabilityPlan capability = plan_capability(plan, profile, {Decision::thesis, Body::rod, 2000, 5});
  CHECK(capability.supervised == plan.supervised);
  CHECK(capability.smallest_mm <= capability.median_mm);
  CHECK(capability.median_mm <= capability.largest_mm);
  CHECK(capability.share_found(capability.largest_mm) == 1);
  CHECK(capability.share_found(capability.smallest_mm - 1) == 0);
}

TEST_CASE("Table 11.1 by formula and by camera model; the thesis's factor") {
  const CameraPair cameras = table_11_1(756, 581, 0);
  const StereoAxis axis(cameras);
  CHECK(axis.baseline_mm == Approx(152));
  CHECK(axis.tilt_deg == Approx(4));
  const MachineProfile& profile = find_profile("field");
  const ScanGeometry field{756, 286, Scan::even_field};
  const std::array printed_mm{7.2, 9.4, 11.2};
  for (int i = 0; i < 3; ++i) {
    const double z = 700 + 100 * i;
    const auto plan = plan_thickness(cameras, *axis.plane_at(z), profile, field, kD95_px);
    CAPTURE(z, plan.on_axis, plan.across.smallest, plan.across.largest);
    const double formula = 2 * 0.7 * z * z * 0.017 / (152 * 10);
    CHECK(plan.on_axis_formula == Approx(formula));
    CHECK(plan.formula.mean == Approx(formula));
    // On the axis α = atan(b/2z) is the angle of a line of sight: (z² + b²/4) cos² (α - 4°) stands for z².
    const double off_axis = std::cos(std::atan(76 / z) - 4 * M_PI / 180);
    CHECK(plan.on_axis == Approx(formula * (1 + 76.0 * 76 / (z * z)) * off_axis * off_axis).epsilon(1e-6));
    // The tilt makes it uneven; nowhere does it come down to what the thesis prints.
    CHECK(plan.across.largest / plan.across.smallest == Approx(1.085).margin(0.01));
    CHECK(plan.across.smallest > printed_mm[static_cast<std::size_t>(i)]);
    CHECK(plan.slope_deg.largest < 1e-5);
    CHECK(plan.exploitation() > 0.85);
    CHECK(plan.supervised == plan.shared);
  }
  // Every figure of Table 11.2, given to 0.1 px and 0.1 mm, is 11.1 times one factor, and so are two of Table 11.1.
  constexpr std::array kTolerances_px{0.4, 0.6, 0.7, 0.9, 1.0, 1.1};
  constexpr std::array kDistances_mm{550, 650, 750};
  constexpr double kThickness_mm[3][6] = {
      {2.5, 3.5, 4.4, 5.5, 6.4, 7.3}, {3.5, 4.9, 6.2, 7.7, 8.9, 10.2}, {4.7, 6.5, 8.2, 10.2, 11.8, 13.5}};
  double least = 0;
  double most = 2;
  const auto narrow = [&](double d, double z, double mm) {
    least = std::max(least, (mm - 0.05) / coplanar_thickness_mm(d + 0.05, z, 152, 10 / 0.017));
    most = std::min(most, (mm + 0.05) / coplanar_thickness_mm(d - 0.05, z, 152, 10 / 0.017));
  };
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t i = 0; i < 6; ++i) narrow(kTolerances_px[i], kDistances_mm[row], kThickness_mm[row][i]);
  }
  CHECK(least == Approx(0.934).margin(0.0005));
  CHECK(most == Approx(0.9465).margin(0.0005));
  CHECK(7.2 / coplanar_thickness_mm(0.7, 700, 152, 10 / 0.017) == Approx(0.938).margin(0.0005));
  CHECK(9.4 / coplanar_thickness_mm(0.7, 800, 152, 10 / 0.017) == Approx(0.938).margin(0.0005));
  CHECK(11.2 / coplanar_thickness_mm(0.7, 900, 152, 10 / 0.017) < 0.9);
}

TEST_CASE("Thickness is how far an object moves until the result shows it by the tolerance beside itself, either way") {
  const CameraPair cameras = table_11_1(640, 480, 2e-3);
  const SurfacePtr skin = make_plane({0, 0, 800}, {0.4, -0.3, -1});
  const Vector3d normal = Vector3d(0.4, -0.3, -1).normalized();
  const ScanGeometry frame{640, 480, Scan::progressive};
  constexpr double kTolerance_px = 0.01;  // small, so that the camera is linear
  const auto plan = plan_thickness(cameras, *skin, find_profile("vga"), frame, kTolerance_px);
  CHECK(plan.slope_deg.largest == Approx(std::acos(std::abs(normal.z())) * 180 / M_PI));
  CHECK(plan.face_width > 0);
  int checked = 0;
  for (int y = 20; y < 480; y += 40) {
    for (int x = 20; x < 640; x += 40) {
      const double across = plan.across_mm[static_cast<std::size_t>(y) * 640 + static_cast<std::size_t>(x)];
      if (std::isnan(across)) continue;
      const Point left{static_cast<double>(x), static_cast<double>(y)};
      const Vector3d sight = cameras.rays(std::array{left}).directions[0].normalized();
      const Vector3d centre = cameras.left().world_to_camera.centre();
      const double distance = (Vector3d(0, 0, 800) - centre).dot(normal) / sight.dot(normal);
      const double along = across / std::abs(sight.dot(normal));
      // The left pixel at which the transformed right image has it: that of the skin on the right line of sight.
      const auto shown = [&](double at_distance) {
        const Point right = right_pixel(cameras, left, at_distance);
        const calib::Camera& camera = cameras.right();
        const Vector3d to_skin = camera.world_to_camera.rotation.transpose() *
                                 camera.model.undistort({right.x, right.y}).value().homogeneous();
        const Vector3d from = camera.world_to_camera.centre();
        const double way = (Vector3d(0, 0, 800) - from).dot(normal) / to_skin.dot(normal);
        return cameras.left().project(from + way * to_skin).value();
      };
      CHECK((shown(distance - along / 2) - shown(distance + along / 2)).norm() ==
            Approx(2 * kTolerance_px).epsilon(1e-4));
      ++checked;
    }
  }
  CHECK(checked > 100);
}

TEST_CASE("Nothing supervised has no thickness, and a plane between the cameras is refused") {
  const CameraPair cameras = table_11_1(640, 480);
  const ScanGeometry frame{640, 480, Scan::progressive};
  const MachineProfile& profile = find_profile("vga");
  const auto behind = plan_thickness(cameras, *make_plane({0, 0, -500}, {0, 0, 1}), profile, frame, 1);
  CHECK(behind.supervised == 0);
  CHECK(std::isnan(behind.across.smallest));
  CHECK(std::isnan(behind.face_width));
  CHECK(std::isnan(behind.on_axis));
  CHECK_THROWS_AS(plan_thickness(cameras, *make_plane({0, 0, 0}, {1, 0, 0}), profile, frame, 1), std::invalid_argument);
}

}  // namespace horopter
