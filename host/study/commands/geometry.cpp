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
#include "horopter/base/csv.hpp"
#include "horopter/draw/map_draw.hpp"
#include "horopter/draw/plot.hpp"
#include "horopter/map/map.hpp"
#include "horopter/plan/plan_rig.hpp"
#include "statements.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

struct Setup {
  double distance_mm, baseline_mm;
};
constexpr std::array setups{Setup{800, 150}, Setup{1600, 300}, Setup{2400, 450}};

RigDesign design(double baseline_mm, double tilt_deg) { return {10, 8.5, 756, 572, baseline_mm, tilt_deg}; }

CameraPair pair_of(const RigDesign& design) {
  const calib::Rig rig = make_rig(design);
  return {rig.cameras[0], rig.cameras[1]};
}

}  // namespace

nlohmann::json study_geometry(OutputDirectory& directory, const StudyScope& scope) {
  const MachineProfile& profile = find_profile("field");
  const ScanGeometry field = scans_of(profile, 756, 572).front();
  const double step_deg = scope.quick ? 1 : 0.25;
  constexpr double kLargestTilt_deg = 10;
  nlohmann::json result;
  std::vector<std::string> findings;
  Csv table({"distance_mm", "baseline_mm", "tilt_deg", "thickness_smallest_mm", "thickness_mean_mm",
             "thickness_largest_mm", "thickness_on_axis_mm", "thickness_11_1_mm", "exploitation"});
  Panel thickness{"Thickness, D = 0.7 px", "tilt, degrees", "mm", {}};
  Panel exploitation{"Exploitation", "tilt, degrees", "A_c / A_L", {}};
  Progress progress("tilt");
  for (const Setup& setup : setups) {
    const std::string name = fmt::format("{:g} m", setup.distance_mm / 1000);
    std::array<Curve, 3> curves{{{name + " smallest", {}}, {name + " mean", {}}, {name + " largest", {}}}};
    Curve share{name, {}};
    double best_tilt = 0;
    double best = 0;
    double spread_at_best = 0;
    for (double tilt = 0; tilt <= kLargestTilt_deg + 1e-9; tilt += step_deg) {
      progress.show(static_cast<std::size_t>(tilt / step_deg), {});
      const CameraPair cameras = pair_of(design(setup.baseline_mm, tilt));
      const SurfacePtr plane = StereoAxis(cameras).plane_at(setup.distance_mm);
      const ThicknessPlan plan = plan_thickness(cameras, *plane, profile, field, kD95_px);
      const double used = common_field(cameras, *plane, field).exploitation();
      table << setup.distance_mm << setup.baseline_mm << tilt << plan.across.smallest << plan.across.mean
            << plan.across.largest << plan.on_axis << plan.on_axis_formula << used;
      table.end_row();
      curves[0].points.emplace_back(tilt, plan.across.smallest);
      curves[1].points.emplace_back(tilt, plan.across.mean);
      curves[2].points.emplace_back(tilt, plan.across.largest);
      share.points.emplace_back(tilt, used);
      if (used > best) {
        best = used;
        best_tilt = tilt;
        spread_at_best = plan.across.largest / plan.across.smallest;
      }
    }
    for (Curve& curve : curves) thickness.curves.push_back(std::move(curve));
    const double without = share.points.front().second;
    exploitation.curves.push_back(std::move(share));
    const double meeting = converging_tilt_deg(setup.baseline_mm, setup.distance_mm);
    result["tilt"][name] = {{"best_tilt_deg", best_tilt},
                            {"best_exploitation", best},
                            {"exploitation_without_tilt", without},
                            {"converging_tilt_deg", meeting},
                            {"largest_over_smallest_thickness", spread_at_best}};
    findings.push_back(
        fmt::format("{} with {:g} mm baseline: the images are exploited best, {:.1f} %, at {:.2f} degrees (axes meet: "
                    "{:.2f}); {:.1f} "
                    "% without tilt; the thickness then varies by a factor of {:.3f}",
                    name, setup.baseline_mm, 100 * best, best_tilt, meeting, 100 * without, spread_at_best));
  }
  progress.clear();
  directory.write("fig-11-2.csv", table.text());
  directory.write("fig-11-2.svg", plot_svg("Fig. 11.2: thickness and exploitation over tilt (10 mm, 17 um sub-sampled)",
                                           {thickness, exploitation}, 2));

  // Fig. 11.3: over the place, in the coordinates of the rig.
  const CameraPair cameras = pair_of(design(450, 4));
  const ThicknessPlan plan = plan_thickness(cameras, *StereoAxis(cameras).plane_at(2400), profile, field, kD95_px);
  Csv places({"x_mm", "y_mm", "thickness_mm"});
  std::vector<Curve> rows;
  constexpr int kRows = 5;
  constexpr int kColumns = 48;
  for (int j = 0; j < kRows; ++j) {
    const int y = j * (field.height - 1) / (kRows - 1);
    std::vector<Point> pixels;
    std::vector<double> mm;
    for (int i = 0; i < kColumns; ++i) {
      const int x = i * (field.width - 1) / (kColumns - 1);
      pixels.push_back(field.to_frame({static_cast<double>(x), static_cast<double>(y)}));
      mm.push_back(plan.across_mm[static_cast<std::size_t>(y) * static_cast<std::size_t>(field.width) +
                                  static_cast<std::size_t>(x)]);
    }
    const Rays rays = cameras.rays(pixels);
    const Eigen::Vector3d left = cameras.left().world_to_camera.centre();
    Curve& row = rows.emplace_back();
    double middle_mm = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (!std::isfinite(mm[i])) continue;
      const Eigen::Vector3d& way = rays.directions[i];
      const Eigen::Vector3d place = left + (2400 - left.z()) / way.z() * way;
      places << place.x() << place.y() << mm[i];
      places.end_row();
      row.points.emplace_back(place.x(), mm[i]);
      middle_mm += place.y() / static_cast<double>(pixels.size());
    }
    row.name = fmt::format("row {} (y about {:.0f} mm)", y, middle_mm);
  }
  directory.write("fig-11-3.csv", places.text());
  directory.write("fig-11-3.svg",
                  plot_svg("Fig. 11.3: thickness over the place; 2.4 m, baseline 450 mm, tilt 4 degrees",
                           {{"Plane across the axis, D = 0.7 px", "x, mm", "mm", rows}}, 1));
  directory.write("fig-11-3.png", encode_png_bgr(field.width, field.height,
                                                 draw_thickness(field.width, field.height, plan.across_mm).bgr));
  result["place"] = {{"smallest_mm", plan.across.smallest},
                     {"mean_mm", plan.across.mean},
                     {"largest_mm", plan.across.largest},
                     {"on_axis_mm", plan.on_axis},
                     {"formula_mm", plan.on_axis_formula}};
  findings.push_back(
      fmt::format("2.4 m, 450 mm, 4 degrees: {:.2f} to {:.2f} mm thick over the field, {:.2f} mm on the "
                  "axis; 11.1 says {:.2f} mm everywhere",
                  plan.across.smallest, plan.across.largest, plan.on_axis, plan.on_axis_formula));
  result["figures"] = {
      {{"file", "fig-11-2.svg"}, {"title", "Fig. 11.2: thickness and exploitation over tilt"}},
      {{"file", "fig-11-3.svg"}, {"title", "Fig. 11.3: thickness over the place, by rows"}},
      {{"file", "fig-11-3.png"}, {"title", "Fig. 11.3: thickness over the place, red thin, blue thick"}}};
  double least_gain = 1;
  for (const auto& [name, setup] : result["tilt"].items()) {
    least_gain = std::min(least_gain,
                          setup["best_exploitation"].get<double>() - setup["exploitation_without_tilt"].get<double>());
  }
  Statements statements;
  statements.add(
      "11.1", "Tilted cameras' views overlap to a higher degree.",
      fmt::format("{:.0f} points of A_c/A_L more at the best tilt, which is where the axes meet", 100 * least_gain),
      verdict(least_gain > 0.05, least_gain > 0), "More than 5 points for all three setups; partly: more");
  const double uneven = plan.across.largest / plan.across.smallest - 1;
  const double off_formula = std::abs(plan.on_axis / plan.on_axis_formula - 1);
  statements.add("11.1", "For tilted cameras 11.1 no longer holds: the thickness is a function of the place.",
                 fmt::format("2.4 m, 450 mm, 4°: it varies by {:.1f} %; on the axis 11.1 is still within {:.1f} %",
                             100 * uneven, 100 * off_formula),
                 verdict(uneven > 0.05, uneven > 0.01), "It varies by more than 5 %; partly: 1 %");
  result["statements"] = statements.json();
  result["findings"] = findings;
  return result;
}

}  // namespace horopter::cli
