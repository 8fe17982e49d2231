// SPDX-License-Identifier: Apache-2.0
// From a wanted thickness to the rules' settings.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "horopter/base/error.hpp"
#include "horopter/plan/tolerance.hpp"
#include "table_11_1.hpp"

namespace horopter {

TEST_CASE("thesis: a threshold for a tolerance") {
  const auto [smallest, largest] = tolerance_range(Decision::thesis);
  double last = 0;
  for (double tolerance = smallest; tolerance <= largest; tolerance += 0.05) {
    const double percent = threshold_percent_for(tolerance);
    CHECK(percent > last);
    CHECK(percent < 60);
    last = percent;
  }
  CHECK(threshold_percent_for(0.85) == Approx((threshold_percent_for(0.8) + threshold_percent_for(0.9)) / 2));
  for (const double beyond : {smallest - 0.01, largest + 0.01, std::nan("")}) {
    CHECK_THROWS_WITH(threshold_percent_for(beyond), Catch::Contains("the rule thesis can be set to 0.2 to 2.5 px"));
  }
}

TEST_CASE("compete: the boundary of the nearest tolerance") {
  const auto [smallest, largest] = tolerance_range(Decision::compete);
  CHECK(smallest < 0.7);
  CHECK(largest > 1.3);
  int setting = -1;
  for (double tolerance = smallest; tolerance <= largest; tolerance += 0.01) {
    const Boundary boundary = boundary_for(tolerance);
    CHECK(boundary.setting >= setting);
    CHECK(std::abs(boundary.tolerance_px - tolerance) < 0.1);
    setting = boundary.setting;
  }
  CHECK(boundary_for(largest).setting == 14);
  for (const double beyond : {smallest - 0.1, largest + 0.1, std::nan("")}) {
    CHECK_THROWS_AS(boundary_for(beyond), UsageError);
    CHECK_THROWS_WITH(boundary_for(beyond), Catch::Contains("the rule compete can be set to"));
  }
}

TEST_CASE("a tolerance sets the rule that the settings have, and nothing else") {
  Settings settings;
  CHECK(set_tolerance(settings, 0.7) == 0.7);
  CHECK(settings.threshold_percent == threshold_percent_for(0.7));
  CHECK(settings.competition.boundary == CompeteSettings{}.boundary);
  settings = {};
  settings.decision = Decision::compete;
  const double has = set_tolerance(settings, 0.9);
  CHECK(has == boundary_for(0.9).tolerance_px);
  CHECK(settings.competition.boundary == boundary_for(0.9).setting);
  CHECK(settings.threshold_percent == Settings{}.threshold_percent);
}

TEST_CASE("D95 of the settings: Table 11.2, and nothing where it is not known") {
  Settings settings;
  const auto thesis = [&](double percent) {
    settings.threshold_percent = percent;
    return d95_px(settings);
  };
  CHECK(thesis(11.3) == 0.4);
  CHECK(thesis(18.4) == 0.7);
  CHECK(thesis(16.7) == Approx(0.65));
  CHECK(thesis(60) == 1.1);
  for (const double percent : {3.0, 11.2, std::nan("")}) CHECK_THROWS_AS(thesis(percent), UsageError);
  settings.decision = Decision::compete;
  CHECK(d95_px(settings) == kD95_px);
  settings.competition.boundary = 14;
  CHECK(d95_px(settings) == kD95_px);
  settings.competition.boundary = 7;
  CHECK_THROWS_AS(d95_px(settings), UsageError);
}

TEST_CASE("a thickness in mm is the median across the skin") {
  const CameraPair cameras = table_11_1(320, 240);
  const SurfacePtr skin = make_plane({0, 0, 800}, {0.4, -0.3, -1});
  const ScanGeometry frame{320, 240, Scan::progressive};
  const MachineProfile& profile = find_profile("vga");
  const double tolerance_px = tolerance_for_mm(12, cameras, *skin, profile, frame);
  const auto across_mm = plan_thickness(cameras, *skin, profile, frame, tolerance_px).across_mm;
  const auto thicker = std::ranges::count_if(across_mm, [](double mm) { return mm > 12; });
  const auto thinner = std::ranges::count_if(across_mm, [](double mm) { return mm < 12; });
  CHECK(thicker > 1000);
  CHECK(static_cast<double>(thicker) / static_cast<double>(thinner) == Approx(1).margin(0.01));
  // A pixel of the result of `field` is two of the image.
  CHECK(tolerance_for_mm(12, cameras, *skin, find_profile("field"), {320, 120, Scan::even_field}) ==
        Approx(tolerance_px / 2).epsilon(0.02));
  const SurfacePtr behind = make_plane({0, 0, -800}, {0, 0, 1});
  CHECK_THROWS_AS(tolerance_for_mm(12, cameras, *behind, profile, frame), std::invalid_argument);
}

}  // namespace horopter
