// SPDX-License-Identifier: Apache-2.0
// Thesis 11.1: thickness of the skin and exploitation of the images over the tilt of the cameras (Fig. 11.2), and over
// the place (Fig. 11.3), for the lenses and pixels of Table 11.1.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
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

}  // namespace

void study_geometry(StudyReport& report, const StudyScope& scope) {
  using namespace measured;
  const double least_gain = study_tilt(report, scope);
  const ThicknessPlan plan = study_place(report);
  report.state("11.1", {{"Tilted cameras' views overlap to a higher degree.",
                         {100 * least_gain},
                         "{:.0f} points of A_c/A_L more at the best tilt, which is where the axes meet",
                         "More than 5 points for all three setups; partly: more",
                         {first > 5, first > 0}},
                        {"For tilted cameras 11.1 no longer holds: the thickness is a function of the place.",
                         {100 * (plan.across.largest / plan.across.smallest - 1),
                          100 * std::abs(plan.on_axis / plan.on_axis_formula - 1)},
                         "2.4 m, 450 mm, 4°: it varies by {:.1f} %; on the axis 11.1 is still within {:.1f} %",
                         "It varies by more than 5 %; partly: 1 %",
                         {first > 5, first > 1}}});
}

}  // namespace horopter::cli
