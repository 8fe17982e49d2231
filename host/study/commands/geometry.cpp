// SPDX-License-Identifier: Apache-2.0
// Thesis 11.1: thickness of the skin and exploitation of the images over the tilt of the cameras (Fig. 11.2), and over
// the place (Fig. 11.3), for the lenses and pixels of Table 11.1.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cli/progress.hpp"
#include "horopter/draw/map_draw.hpp"
#include "horopter/map/map.hpp"
#include "horopter/plan/plan_rig.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

struct Setup {
  double distance_mm, baseline_mm;
};
constexpr std::array kSetups{Setup{800, 150}, Setup{1600, 300}, Setup{2400, 450}};

RigDesign design(double baseline_mm, double tilt_deg) { return {10, 8.5, 756, 572, baseline_mm, tilt_deg}; }

CameraPair pair_of(const RigDesign& design) {
  const calib::Rig rig = make_rig(design);
  return {rig.cameras[0], rig.cameras[1]};
}

/// The thesis's machine.
const MachineProfile& machine() { return find_profile("field"); }
ScanGeometry field() { return scans_of(machine(), 756, 572).front(); }

/// Curves and figures of one setup over the tilt.
struct OverTilt {
  std::array<Curve, 3> thickness;  ///< smallest, mean, largest
  Curve exploitation;
  double best_tilt_deg = 0;
  double best = 0;
  double spread_at_best = 0;
  double without_tilt() const { return exploitation.points.front().second; }
};

OverTilt over_tilt(const Setup& setup, const std::string& name, double step_deg, Csv& table, Progress& progress) {
  constexpr double kLargestTilt_deg = 10;
  OverTilt result{{{{name + " smallest", {}}, {name + " mean", {}}, {name + " largest", {}}}}, {name, {}}};
  for (double tilt = 0; tilt <= kLargestTilt_deg + 1e-9; tilt += step_deg) {
    progress.show(static_cast<std::size_t>(tilt / step_deg), {});
    const CameraPair cameras = pair_of(design(setup.baseline_mm, tilt));
    const SurfacePtr plane = StereoAxis(cameras).plane_at(setup.distance_mm);
    const ThicknessPlan plan = plan_thickness(cameras, *plane, machine(), field(), kD95_px);
    const Summary& across = plan.across;
    const double used = common_field(cameras, *plane, field()).exploitation();
    table.row(setup.distance_mm, setup.baseline_mm, tilt, across.smallest, across.mean, across.largest, plan.on_axis,
              plan.on_axis_formula, used);
    result.thickness[0].points.emplace_back(tilt, across.smallest);
    result.thickness[1].points.emplace_back(tilt, across.mean);
    result.thickness[2].points.emplace_back(tilt, across.largest);
    result.exploitation.points.emplace_back(tilt, used);
    if (used <= result.best) continue;
    result.best = used;
    result.best_tilt_deg = tilt;
    result.spread_at_best = across.largest / across.smallest;
  }
  return result;
}

/// Fig. 11.2; by how much the best tilt raises the exploitation, of the setup that gains least.
double study_tilt(StudyReport& report, const StudyScope& scope) {
  Csv table({"distance_mm", "baseline_mm", "tilt_deg", "thickness_smallest_mm", "thickness_mean_mm",
             "thickness_largest_mm", "thickness_on_axis_mm", "thickness_11_1_mm", "exploitation"});
  Panel thickness{"Thickness, D = 0.7 px", "tilt, degrees", "thickness, mm", {}};
  Panel exploitation{"Exploitation", "tilt, degrees", "share of the image in use, A_c / A_L", {}};
  double least_gain = 1;
  Progress progress("tilt");
  for (const Setup& setup : kSetups) {
    const std::string name = fmt::format("{:g} m", setup.distance_mm / 1000);
    const OverTilt found = over_tilt(setup, name, scope.quick ? 1 : 0.25, table, progress);
    thickness.curves.insert(thickness.curves.end(), found.thickness.begin(), found.thickness.end());
    exploitation.curves.push_back(found.exploitation);
    least_gain = std::min(least_gain, found.best - found.without_tilt());
    const double meeting_deg = converging_tilt_deg(setup.baseline_mm, setup.distance_mm);
    report.result["tilt"][name] = {{"best_tilt_deg", found.best_tilt_deg},
                                   {"best_exploitation", found.best},
                                   {"exploitation_without_tilt", found.without_tilt()},
                                   {"converging_tilt_deg", meeting_deg},
                                   {"largest_over_smallest_thickness", found.spread_at_best}};
    report.finding(
        "{} with {:g} mm baseline: the images are exploited best, {:.1f} %, at {:.2f} degrees (axes meet: {:.2f}); "
        "{:.1f} % without tilt; the thickness then varies by a factor of {:.3f}",
        name, setup.baseline_mm, 100 * found.best, found.best_tilt_deg, meeting_deg, 100 * found.without_tilt(),
        found.spread_at_best);
  }
  progress.clear();
  report.table("fig-11-2.csv", table);
  report.plot("fig-11-2.svg", "Fig. 11.2: thickness and exploitation over tilt (10 mm, 17 µm sub-sampled)",
              {thickness, exploitation}, 2);
  return least_gain;
}

/// The thickness along a row of the image, over x in the rig's coordinates.
Curve along_row(const CameraPair& cameras, const ThicknessPlan& plan, int y, double distance_mm, Csv& table) {
  constexpr int kColumns = 48;
  const ScanGeometry scan = field();
  std::vector<Point> pixels;
  std::vector<double> mm;
  for (int i = 0; i < kColumns; ++i) {
    const int x = i * (scan.width - 1) / (kColumns - 1);
    pixels.push_back(scan.to_frame({static_cast<double>(x), static_cast<double>(y)}));
    mm.push_back(plan.across_mm[static_cast<std::size_t>(y) * static_cast<std::size_t>(scan.width) +
                                static_cast<std::size_t>(x)]);
  }
  const Rays rays = cameras.rays(pixels);
  const Eigen::Vector3d left = cameras.left().world_to_camera.centre();
  Curve row;
  double middle_mm = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (!std::isfinite(mm[i])) continue;
    const Eigen::Vector3d& way = rays.directions[i];
    const Eigen::Vector3d place = left + (distance_mm - left.z()) / way.z() * way;
    table.row(place.x(), place.y(), mm[i]);
    row.points.emplace_back(place.x(), mm[i]);
    middle_mm += place.y() / static_cast<double>(pixels.size());
  }
  row.name = fmt::format("row {} (y about {:.0f} mm)", y, middle_mm);
  return row;
}

/// Fig. 11.3: over the place.
ThicknessPlan study_place(StudyReport& report) {
  constexpr double kDistance_mm = 2400;
  constexpr int kRows = 5;
  const CameraPair cameras = pair_of(design(450, 4));
  const ThicknessPlan plan =
      plan_thickness(cameras, *StereoAxis(cameras).plane_at(kDistance_mm), machine(), field(), kD95_px);
  Csv table({"x_mm", "y_mm", "thickness_mm"});
  Panel panel{"Plane across the axis, D = 0.7 px", "x, mm", "thickness, mm", {}};
  for (int j = 0; j < kRows; ++j)
    panel.curves.push_back(along_row(cameras, plan, j * (field().height - 1) / (kRows - 1), kDistance_mm, table));
  report.table("fig-11-3.csv", table);
  report.plot("fig-11-3.svg", "Fig. 11.3: thickness over the place; 2.4 m, 450 mm, tilt 4 degrees", {panel}, 1);
  const Picture page =
      draw_thickness(field().width, field().height, plan.across_mm, "Thickness, 2.4 m, 450 mm, 4 degrees, 0.7 px")
          .picture;
  report.picture("fig-11-3.png", "Fig. 11.3: thickness over the place in the image, red thin, blue thick",
                 encode_png_bgr(page.width, page.height, page.bgr));
  report.result["place"] = {{"smallest_mm", plan.across.smallest},
                            {"mean_mm", plan.across.mean},
                            {"largest_mm", plan.across.largest},
                            {"on_axis_mm", plan.on_axis},
                            {"formula_mm", plan.on_axis_formula}};
  report.finding(
      "2.4 m, 450 mm, 4 degrees: {:.2f} to {:.2f} mm thick over the field, {:.2f} mm on the axis; 11.1 says {:.2f} mm "
      "everywhere",
      plan.across.smallest, plan.across.largest, plan.on_axis, plan.on_axis_formula);
  return plan;
}

/// 11.1 with the lens and pixels of Table 11.1, D = 0.7 px.
double thickness_mm(double distance_mm) { return coplanar_thickness_mm(kD95_px, distance_mm, 152, 10 / 0.017); }

/// Table 11.1, and Table 11.2's thicknesses in mm.
std::vector<Statement> tables() {
  using namespace measured;
  constexpr std::array kDistances_mm{700.0, 800.0, 900.0};
  constexpr std::array kThicknesses_mm{7.2, 9.4, 11.2};
  double furthest = 0;
  std::string found;
  for (std::size_t i = 0; i < kDistances_mm.size(); ++i) {
    const double mm = thickness_mm(kDistances_mm[i]);
    furthest = std::max(furthest, 100 * std::abs(mm / kThicknesses_mm[i] - 1));
    found += fmt::format(" {:.1f}", mm);
  }
  struct Row {
    double d95_px;
    std::array<double, 3> thickness_mm;  ///< at 550, 650, 750 mm
  };
  constexpr std::array kRows{Row{0.4, {2.5, 3.5, 4.7}},  Row{0.6, {3.5, 4.9, 6.5}},  Row{0.7, {4.4, 6.2, 8.2}},
                             Row{0.9, {5.5, 7.7, 10.2}}, Row{1.0, {6.4, 8.9, 11.8}}, Row{1.1, {7.3, 10.2, 13.5}}};
  double off = 0;
  double apart = 0;
  for (const Row& row : kRows) {
    for (std::size_t i = 0; i < row.thickness_mm.size(); ++i) {
      const double distance_mm = 550 + 100 * static_cast<double>(i);
      const double mm = thickness_mm(distance_mm) * row.d95_px / kD95_px;
      off = std::max(off, 100 * std::abs(mm / row.thickness_mm[i] - 1));
      // Rows of the table are printed to 0.1: each goes with the square of the distance.
      const double by_square = row.thickness_mm[1] * distance_mm * distance_mm / (650.0 * 650.0);
      apart = std::max(apart, std::abs(by_square - row.thickness_mm[i]));
    }
  }
  constexpr double kFields = 50;
  return {
      {"Table 11.1: the thickness is ≈ 7.2, 9.4, 11.2 mm at 700, 800, 900 mm (D = 0.7 pxl).",
       {furthest, found},
       "By 11.1 with 17 µm:{1} mm, up to {0:.0f} % off",
       "Within 5 %; partly: 15 %",
       {first <= 5, first <= 15},
       "the formula of section 11.1 gives the thicknesses printed in Table 11.1"},
      {"Table 11.1: the maximal velocity of objects at 800 mm (frame rate × thickness) is 0.45 m/s.",
       {kFields * 9.4 / 1000, kFields * thickness_mm(800) / 1000},
       "50 images a second times its own 9.4 mm are {:.2f} m/s, times 11.1's thickness {:.2f} m/s; 0.45 m/s would be "
       "9.0 mm",
       "Both within 0.005 m/s, as it is printed; partly: one of them",
       {near(first, 0.45, 0.005) && near(second, 0.45, 0.005), near(first, 0.45, 0.005) || near(second, 0.45, 0.005)}},
      {"Table 11.2: the thicknesses at 550, 650, 750 mm are those of its D95 by 11.1.",
       {off, apart},
       "Up to {:.0f} % off (D95 is printed to 0.1 px); as squares of the distance within {:.2f} mm of each other",
       "Within 5 %; partly: 20 %, and squares within 0.2 mm",
       {first <= 5, first <= 20 && second <= 0.2}}};
}

/// 11.2: across a skin that slopes, against one that does not, at 800 mm on the axis; by the model of the cameras.
double thickness_share(double slope_deg) {
  const CameraPair cameras = pair_of(design(152, 4));
  const StereoAxis axis(cameras);
  const double slope = slope_deg * std::numbers::pi / 180;
  const Eigen::Vector3d normal = std::cos(slope) * axis.direction + std::sin(slope) * Eigen::Vector3d::UnitY();
  ViewLimits limits;
  limits.largest_angle_deg = 89;
  const auto on_axis = [&](const SurfacePtr& plane) {
    return plan_thickness(cameras, *plane, machine(), field(), kD95_px, limits).on_axis;
  };
  return on_axis(make_plane(axis.middle_mm + 800 * axis.direction, normal)) / on_axis(axis.plane_at(800));
}

}  // namespace

void study_geometry(StudyReport& report, const StudyScope& scope) {
  using namespace measured;
  const double least_gain = study_tilt(report, scope);
  const ThicknessPlan plan = study_place(report);
  report.state("11.1", {{"Tilted cameras' views overlap to a higher degree.",
                         {100 * least_gain},
                         "{:.0f} points of A_c/A_L more at the best tilt, which is where the axes meet",
                         "More than 5 points for all three setups; partly: more",
                         {first > 5, first > 0},
                         "cameras that are tilted towards each other share more of their view"},
                        {"For tilted cameras 11.1 no longer holds: the thickness is a function of the place.",
                         {100 * (plan.across.largest / plan.across.smallest - 1),
                          100 * std::abs(plan.on_axis / plan.on_axis_formula - 1)},
                         "2.4 m, 450 mm, 4°: it varies by {:.1f} %; on the axis 11.1 is still within {:.1f} %",
                         "It varies by more than 5 %; partly: 1 %",
                         {first > 5, first > 1},
                         "the thickness of tilted cameras depends on the place"}});
  report.state("11.2", tables());
  report.state("11.2.2",
               {{"The envelope can be tilted up to 70° against the base with the consequence of reduced thickness "
                 "(≈ 1/3).",
                 {thickness_share(70)},
                 "By the model of the cameras {:.3f} of the thickness across the axis",
                 "Within 10 % of 1/3; partly: 25 %",
                 {near(first, 1.0 / 3, 0.1 / 3), near(first, 1.0 / 3, 0.25 / 3)}}});
}

}  // namespace horopter::cli
