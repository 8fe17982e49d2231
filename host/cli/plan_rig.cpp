// SPDX-License-Identifier: Apache-2.0
// horopter plan rig: which cameras, how far apart, turned by how much, and what they leave unseen.
#include "horopter/plan/plan_rig.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "commands.hpp"
#include "horopter/base/csv.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/draw/plan_drawing.hpp"
#include "horopter/draw/plot.hpp"
#include "horopter/image/output.hpp"
#include "horopter/map/row_check.hpp"
#include "horopter/plan/watch.hpp"
#include "horopter/skin/skin_file.hpp"
#include "inputs.hpp"
#include "numbers.hpp"
#include "plan_inputs.hpp"
#include "progress.hpp"
#include "thickness.hpp"
#include "warnings.hpp"
#include "words.hpp"

namespace horopter::cli {
namespace {

struct RigOptions {
  std::string rig;
  RigDesign design;
  std::vector<std::string> image_size;
  double thickness_mm = 0;
  std::optional<double> tilt_deg;
  std::vector<double> distances_mm;
  std::string skin;
  std::string profile;
  double tolerance_px = kD95_px;
  Decision decision = Decision::thesis;
  std::string zone;
  std::vector<std::string> obstacles;
  std::vector<double> from_mm;
  EntrySearch search;
  std::string out;
  bool json = false;
};

using Json = nlohmann::ordered_json;

constexpr double kLargestTilt_deg = 80;
constexpr const char* kRigFile = "rig.yaml";

Json to_json(const Eigen::Vector3d& place) { return {place.x(), place.y(), place.z()}; }

/// Both cameras see some of the axis of symmetry.
bool has_common_axis(const RigDesign& design) {
  const calib::Rig rig = make_rig(design);
  return depth_range(CameraPair(rig.cameras[0], rig.cameras[1])).has_value();
}

/// The cameras of --rig, or those designed.
calib::Rig rig_of(RigOptions& options) {
  RigDesign& design = options.design;
  const bool designed = design.f_mm > 0 || design.pitch_um > 0 || !options.image_size.empty() ||
                        design.baseline_mm > 0 || options.thickness_mm > 0 || options.tilt_deg;
  if (!options.rig.empty()) {
    if (designed) {
      throw UsageError(
          "--rig has cameras: leave out --focal, --pixel, --image-size, --baseline, --thickness and --tilt");
    }
    calib::Rig rig = read_rig(options.rig);
    if (options.skin.empty()) first_pair(rig, options.rig);
    return rig;
  }
  if (!(design.f_mm > 0) || !(design.pitch_um > 0) || options.image_size.empty()) {
    throw UsageError("cameras are required: --rig FILE, or --focal, --pixel and --image-size of those you think of");
  }
  const auto size = size_of(fmt::format("{}", fmt::join(options.image_size, "x")));
  if (!size) {
    throw UsageError(
        fmt::format("--image-size '{}'; expected WIDTHxHEIGHT, as 756x572", fmt::join(options.image_size, " ")));
  }
  std::tie(design.width_px, design.height_px) = *size;
  const auto distance = [&](const char* what) {
    if (options.distances_mm.empty()) throw UsageError(fmt::format("--{} requires --distance", what));
    return options.distances_mm.front();
  };
  if ((design.baseline_mm > 0) == (options.thickness_mm > 0)) {
    throw UsageError("one of --baseline and --thickness is required: how far apart the cameras are, or what for");
  }
  if (options.thickness_mm > 0) {
    const auto subsample = options.profile.empty() ? 1 : find_profile(options.profile).subsample;
    design.baseline_mm =
        baseline_for_mm(options.thickness_mm, options.tolerance_px * subsample, distance("thickness"), design.f_px());
  }
  design.tilt_deg = options.tilt_deg ? *options.tilt_deg
                                     : converging_tilt_deg(design.baseline_mm, distance("baseline without --tilt"));
  if (!(std::abs(design.tilt_deg) <= kLargestTilt_deg) || !has_common_axis(design)) {
    throw Error(
        ExitStatus::check_failed,
        fmt::format("no such rig: a baseline of {:.4g} mm, each camera turned by {:.3g} degrees, f {:.4g} px, and "
                    "no place on the axis between the cameras that both see; --focal, --baseline, --thickness "
                    "and --distance are in mm, --pixel in um, --tilt in degrees",
                    design.baseline_mm, design.tilt_deg, design.f_px()));
  }
  return make_rig(design);
}

/// A skin to look at: the user's, or a plane across the axis of symmetry.
struct RigSkin {
  std::string name;
  SurfacePtr surface;
};

struct Views {
  ThicknessPlan thickness;
  CommonField field;
};

Json to_json(const RigSkin& skin, const Views& views) {
  const CommonField& f = views.field;
  return {{"skin", skin.name},
          {"distance_mm", range_json(views.thickness.distance)},
          {"beyond_rows", views.thickness.rows.share()},
          {"common_field",
           {{"left_m2", f.left_m2},
            {"common_m2", f.common_m2},
            {"supervised_m2", f.supervised_m2},
            {"width_mm", f.width_mm},
            {"height_mm", f.height_mm},
            {"exploitation", f.exploitation()}}},
          {"viewing_angle_deg", {{"left", range_json(f.left_angle_deg)}, {"right", range_json(f.right_angle_deg)}}},
          {"thickness_mm",
           {{"across", range_json(views.thickness.across)},
            {"on_axis", views.thickness.on_axis},
            {"on_axis_formula", views.thickness.on_axis_formula}}}};
}

Json to_json(const EntryPlan& plan) {
  Json openings = Json::array();
  for (const Opening& opening : plan.openings) {
    openings.push_back({{"from_mm", to_json(opening.box_mm.min())},
                        {"to_mm", to_json(opening.box_mm.max())},
                        {"places", opening.places},
                        {"reason", sight_name(opening.reason)}});
  }
  Json path = Json::array();
  for (const auto& place : plan.path_mm) path.push_back(to_json(place));
  return {{"step_mm", plan.step_mm},
          {"surely_found_mm", plan.surely_found_mm()},
          {"space_mm", {to_json(plan.space_mm.min()), to_json(plan.space_mm.max())}},
          {"places", plan.zone_mm.size()},
          {"unseen", plan.unseen_mm.size()},
          {"openings", std::move(openings)},
          {"path_mm", std::move(path)}};
}

void print(const RigSkin& skin, const Views& views) {
  const CommonField& f = views.field;
  fmt::print("{}\n", skin.name);
  if (!(f.common_m2 > 0)) {
    fmt::print("  the cameras see nothing of it in common\n");
    return;
  }
  fmt::print("  common field       {:.0f} x {:.0f} mm, {:.4g} m2: {:.1f} % of what the left camera sees of it\n",
             f.width_mm, f.height_mm, f.common_m2, 100 * f.exploitation());
  fmt::print("  supervised         {:.1f} % of the common field\n", 100 * f.supervised_m2 / f.common_m2);
  const auto summary = [](const char* name, const Summary& s, const char* unit) {
    fmt::print("  {:18} {:.2f} to {:.2f}, mean {:.2f} {}\n", name, s.smallest, s.largest, s.mean, unit);
  };
  summary("viewing angle left", f.left_angle_deg, "degrees from the normal");
  summary("              right", f.right_angle_deg, "degrees from the normal");
  if (views.thickness.supervised == 0) return;
  summary("thickness", views.thickness.across, "mm");
  fmt::print("    on the axis      {:.2f} mm, by 11.1 and 11.2 {:.2f} mm\n", views.thickness.on_axis,
             views.thickness.on_axis_formula);
}

void print(const EntryPlan& plan) {
  if (plan.unseen_mm.empty()) {
    fmt::print("zone     nowhere entered unseen, by openings of {:.3g} mm and more\n", plan.surely_found_mm());
    return;
  }
  fmt::print("zone     can be entered unseen through {:.1f} % of its surface ({} of {} places, {:.3g} mm apart):\n",
             100 * static_cast<double>(plan.unseen_mm.size()) / static_cast<double>(plan.zone_mm.size()),
             plan.unseen_mm.size(), plan.zone_mm.size(), plan.step_mm);
  constexpr std::size_t kShown = 8;
  for (std::size_t i = 0; i < std::min(plan.openings.size(), kShown); ++i) {
    const Opening& o = plan.openings[i];
    const auto& a = o.box_mm.min();
    const auto& b = o.box_mm.max();
    fmt::print("  x {:.0f} to {:.0f}, y {:.0f} to {:.0f}, z {:.0f} to {:.0f} mm: {}\n", a.x(), b.x(), a.y(), b.y(),
               a.z(), b.z(), sight_text(o.reason));
  }
  if (plan.openings.size() > kShown) fmt::print("  and {} smaller ones\n", plan.openings.size() - kShown);
}

/// Thickness and common field over distance, as CSV and SVG.
void write_over_distance(OutputDirectory& output, const CameraPair& cameras, const MachineProfile& profile,
                         const ScanGeometry& geometry, double tolerance_px, const ViewLimits& view, double middle_mm) {
  const StereoAxis axis(cameras);
  Csv csv({"distance_mm", "thickness_smallest_mm", "thickness_mean_mm", "thickness_largest_mm", "thickness_11_1_mm",
           "common_width_mm", "common_height_mm", "exploitation"});
  std::array<Curve, 4> thickness{{{"smallest", {}}, {"mean", {}}, {"largest", {}}, {"by 11.1", {}}}};
  std::array<Curve, 2> extent{{{"width", {}}, {"height", {}}}};
  Curve exploitation{"A_c / A_L", {}};
  constexpr int kPlaces = 9;
  Progress progress("distance");
  for (int i = 0; i < kPlaces; ++i) {
    progress.show(static_cast<std::size_t>(i), kPlaces);
    const double z = middle_mm * std::pow(2.0, 2.0 * i / (kPlaces - 1) - 1);  // half to twice
    const SurfacePtr plane = axis.plane_at(z);
    ThicknessPlan plan;
    CommonField field;
    try {
      plan = plan_thickness(cameras, *plane, profile, geometry, tolerance_px, view);
      field = common_field(cameras, *plane, geometry);
    } catch (const std::invalid_argument&) {
      continue;  // too near to be before both cameras
    }
    const std::array figures{plan.across.smallest, plan.across.mean, plan.across.largest, plan.on_axis_formula,
                             field.width_mm,       field.height_mm,  field.exploitation()};
    csv.row(z, figures[0], figures[1], figures[2], figures[3], figures[4], figures[5], figures[6]);
    for (std::size_t k = 0; k < 4; ++k) thickness[k].points.emplace_back(z, figures[k]);
    for (std::size_t k = 0; k < 2; ++k) extent[k].points.emplace_back(z, figures[4 + k]);
    exploitation.points.emplace_back(z, figures[6]);
  }
  output.write("distance.csv", csv.text());
  output.write(
      "distance.svg",
      plot_svg("Planes across the axis of symmetry, over their distance from the cameras",
               {{"Thickness of the skin", "distance, mm", "thickness, mm", {thickness.begin(), thickness.end()}},
                {"Common field", "distance, mm", "extent, mm", {extent.begin(), extent.end()}},
                {"Exploitation of the left image", "distance, mm", "share in use, A_c / A_L", {exploitation}}}));
}

void check_usage(const RigOptions& options) {
  if (options.skin.empty() && options.distances_mm.empty()) throw UsageError("either --skin or --distance is required");
  if (!options.zone.empty() && options.skin.empty() && options.distances_mm.size() > 1) {
    throw UsageError("--zone is watched by one skin: give --skin, or one --distance");
  }
  if (options.zone.empty() && (!options.obstacles.empty() || !options.from_mm.empty() || options.search.step_mm > 0)) {
    throw UsageError("--obstacle, --from and --step say how --zone is entered: give --zone");
  }
}

/// Cameras, skins and machine as planned.
struct RigInstallation {
  calib::Rig rig;
  std::string rig_name;
  CameraPair cameras;
  std::vector<RigSkin> skins;
  const MachineProfile* profile = nullptr;
  ScanGeometry geometry{};
  ViewLimits view;
};

void choose_machine(const RigOptions& options, RigInstallation& installation) {
  const CameraPair& cameras = installation.cameras;
  const std::string& rig_name = installation.rig_name;
  for (const calib::Camera* camera : {&cameras.left(), &cameras.right()}) {
    if (camera->width_px > 0 && camera->height_px > 0) continue;
    throw FileError(rig_name, "cameras", "camera " + camera->name + " has no image size",
                    "image_size: [width, height]");
  }
  const int width = cameras.left().width_px;
  const int height = cameras.left().height_px;
  installation.profile = &choose_profile(options.profile, rig_name, "image size", width, height);
  installation.geometry = scans_of(*installation.profile, width, height).front();
  installation.view = view_limits(*installation.profile, options.decision);
}

RigInstallation install(RigOptions& options) {
  const calib::Rig rig = rig_of(options);
  RigInstallation result{
      rig, options.rig.empty() ? "the rig" : options.rig, {rig.cameras[0], rig.cameras[1]}, {}, nullptr, {}, {}};
  if (!options.skin.empty()) {
    refuse_what_has_no_place(options.skin);
    const auto skin = load_rig_skin(options.skin, rig);
    result.cameras = skin->cameras();
    result.skins.push_back({skin->description(), skin->surface()});
  } else {
    const StereoAxis axis(result.cameras);
    for (const double distance : options.distances_mm) {
      result.skins.push_back({fmt::format("plane at {:g} mm", distance), axis.plane_at(distance)});
    }
  }
  choose_machine(options, result);
  return result;
}

/// What an installation sees.
struct Plan {
  std::vector<Views> views;  ///< of each skin
  std::vector<Watch> watches;
  std::optional<EntryPlan> entries;
  double distance_mm = 0;  ///< at which the rig is looked at
};

/// A lattice that passes beside a part of the zone enters it nowhere.
void check_step(const EntryPlan& entries, const Surface& zone) {
  Eigen::AlignedBox3d box;
  zone.extend(box);
  if (box.isEmpty()) return;  // of a union, what has no ends
  const Eigen::Vector3d sizes = box.sizes();
  double smallest = sizes.maxCoeff();
  for (const double size : sizes) {
    if (size > 1e-6 * sizes.maxCoeff()) smallest = std::min(smallest, size);  // a sheet is flat
  }
  if (entries.step_mm <= smallest && !entries.zone_mm.empty()) return;
  throw UsageError(fmt::format(
      "the zone, or a part of it, is {:.4g} x {:.4g} x {:.4g} mm, and is entered in steps of {:.4g} mm, which pass beside "
      "it; expected --step {:.3g} or less; without it a step is 1/64 of the space, which ends at --from",
      sizes.x(), sizes.y(), sizes.z(), entries.step_mm, std::min(smallest, entries.step_mm) / 4));
}

SurfacePtr load_still(const std::string& file) {
  SurfacePtr surface = load_surface(file);  // first, for its errors
  refuse_what_has_no_place(file);
  return surface;
}

Plan plan_of(RigOptions& options, const RigInstallation& installation) {
  const SurfacePtr zone = options.zone.empty() ? nullptr : load_still(options.zone);
  SurfacePtr obstacles;
  if (!options.obstacles.empty()) {
    std::vector<SurfacePtr> parts;
    for (const std::string& file : options.obstacles) parts.push_back(load_still(file));
    obstacles = make_union(std::move(parts));
  }
  if (!options.from_mm.empty()) options.search.from_mm.emplace(options.from_mm.data());
  const auto& [rig, rig_name, cameras, skins, profile, geometry, view] = installation;
  Plan plan;
  for (const RigSkin& skin : skins) {
    try {
      plan.views.push_back({plan_thickness(cameras, *skin.surface, *profile, geometry, options.tolerance_px, view),
                            common_field(cameras, *skin.surface, geometry, view)});
      plan.watches.emplace_back(cameras, skin.surface, obstacles, *profile, geometry, view);
    } catch (const std::invalid_argument& error) {
      throw FileError(options.skin.empty() ? rig_name : options.skin, "", skin.name + ": " + error.what(),
                      "a skin in front of both cameras");
    }
  }
  plan.distance_mm =
      options.distances_mm.empty() ? plan.views.front().thickness.distance.mean : options.distances_mm.front();
  if (zone) {
    try {
      plan.entries = plan_entries(plan.watches.front(), *zone, options.search);
    } catch (const std::invalid_argument& error) {
      throw FileError(options.zone, "surface", error.what(), "a zone with ends, or a larger --step");
    }
    check_step(*plan.entries, *zone);
    for (const SurfacePtr& part : zone->parts()) check_step(*plan.entries, *part);
  }
  return plan;
}

Json to_json(const RigOptions& options, const RigInstallation& installation, const Plan& plan) {
  const StereoAxis axis(installation.cameras);
  const auto depth = depth_range(installation.cameras);
  Json json{{"rig",
             {{"baseline_mm", axis.baseline_mm},
              {"tilt_deg", axis.tilt_deg},
              {"f_px", axis.f_px},
              {"converging_tilt_deg", converging_tilt_deg(axis.baseline_mm, plan.distance_mm)},
              {"axis_seen_from_mm", depth ? Json(depth->nearest_mm) : Json()},
              {"axis_seen_to_mm", depth ? Json(depth->farthest_mm) : Json()}}},
            {"profile", installation.profile->name},
            {"decision", name_of(options.decision)},
            {"tolerance_px", options.tolerance_px},
            {"tolerance_is", "D95"},
            {"skins", Json::array()}};
  for (std::size_t i = 0; i < plan.views.size(); ++i) {
    json["skins"].push_back(to_json(installation.skins[i], plan.views[i]));
  }
  if (plan.entries) json["entry"] = to_json(*plan.entries);
  return json;
}

void write(OutputDirectory& output, const RigOptions& options, const RigInstallation& installation, const Plan& plan,
           const Json& json) {
  const auto& [rig, rig_name, cameras, skins, profile, geometry, view] = installation;
  std::vector<PlannedView> drawn;
  for (std::size_t i = 0; i < skins.size(); ++i) drawn.push_back({skins[i].name, &plan.watches[i]});
  const StereoAxis axis(cameras);
  output.write("rig.svg", draw_plan(fmt::format("Baseline {:.4g} mm, tilt {:.3g} degrees, f {:.5g} px",
                                                axis.baseline_mm, axis.tilt_deg, axis.f_px),
                                    cameras, drawn, plan.entries ? &*plan.entries : nullptr));
  if (std::isfinite(plan.distance_mm)) {
    write_over_distance(output, cameras, *profile, geometry, options.tolerance_px, view, plan.distance_mm);
  }
  if (options.rig.empty()) output.write(kRigFile, calib::to_yaml(rig));
  output.write("rig.json", json_text(json) + "\n");
  output.commit();
}

void print_head(const RigOptions& options, const RigInstallation& installation, double distance_mm) {
  const StereoAxis axis(installation.cameras);
  fmt::print("rig      baseline {:.2f} mm, tilt {:.3f} degrees; at {:.3f} degrees the axes would meet {:.0f} mm away\n",
             axis.baseline_mm, axis.tilt_deg, converging_tilt_deg(axis.baseline_mm, distance_mm), distance_mm);
  if (const auto depth = depth_range(installation.cameras)) {
    fmt::print("axis     seen by both cameras from {:.0f} mm {}\n", depth->nearest_mm,
               std::isfinite(depth->farthest_mm) ? fmt::format("to {:.0f} mm", depth->farthest_mm) : "on");
  } else {
    fmt::print("axis     nowhere seen by both cameras: change the tilt\n");
  }
  const MachineProfile& profile = *installation.profile;
  fmt::print("profile  {}, rule {}, disparity tolerance (D95) {} px of the result ({} px of the image)\n", profile.name,
             name_of(options.decision), options.tolerance_px, options.tolerance_px * profile.subsample);
}

/// The designed rig replaces an earlier one, but none that was measured.
void check_place_of_rig(const RigOptions& options) {
  const std::filesystem::path file = std::filesystem::path(options.out) / kRigFile;
  std::error_code error;
  if (options.out.empty() || !options.rig.empty() || !std::filesystem::exists(file, error)) return;
  try {
    if (calib::load_rig(file).rig.world == kDesignedWorld) return;
  } catch (const FileError&) {  // no rig at all
  }
  throw FileError(file.string(), "", "this file is not of `plan rig`, which would replace it by the designed rig",
                  "another --out, or --rig");
}

ExitStatus plan_rig(RigOptions options) {
  check_usage(options);
  const RigInstallation installation = install(options);
  check_place_of_rig(options);
  std::optional<OutputDirectory> output;
  if (!options.out.empty()) output.emplace(options.out).set_aside("rig.json");
  const Plan plan = plan_of(options, installation);
  Json json = to_json(options, installation, plan);
  add_warnings(json);
  if (output) write(*output, options, installation, plan, json);
  if (options.json) {
    std::puts(json_text(json).c_str());
  } else {
    print_head(options, installation, plan.distance_mm);
  }
  bool nothing = false;
  bool refused = false;
  for (std::size_t i = 0; i < plan.views.size(); ++i) {
    const ThicknessPlan& thickness = plan.views[i].thickness;
    if (!options.json) print(installation.skins[i], plan.views[i]);
    refused = !report_row_count(thickness.rows, installation.view, options.json) || refused;
    nothing = nothing || thickness.supervised == 0;
  }
  if (!options.json) {
    if (plan.entries) print(*plan.entries);
    if (output) fmt::print("rig.svg and the rest are in {}\n", options.out);
  }
  if (nothing) std::fprintf(stderr, "horopter: nothing of a skin is supervised\n");
  const bool entered = plan.entries && !plan.entries->unseen_mm.empty();
  return nothing || refused || entered ? ExitStatus::check_failed : ExitStatus::done;
}

}  // namespace

void add_plan_rig(CLI::App& plan, Outcome& outcome) {
  auto options = std::make_shared<RigOptions>();
  CLI::App* rig = plan.add_subcommand(
      "rig",
      "Which cameras, how far apart, turned by how much: common field, viewing angle, thickness, unseen entries "
      "(11.1)");
  rig->add_option("--rig", options->rig, "The cameras there are (rig.yaml), with their image size")->type_name("FILE");
  rig->add_option("--focal", options->design.f_mm, "Instead of --rig: focal length of two like cameras, mm")
      ->check(above_zero())
      ->type_name("MM");
  rig->add_option("--pixel", options->design.pitch_um, "Their pixels, um, square")
      ->check(above_zero())
      ->type_name("UM");
  rig->add_option("--image-size", options->image_size, "Their images, pixels: WIDTHxHEIGHT, or WIDTH HEIGHT")
      ->expected(1, 2)
      ->type_name("WxH");
  rig->add_option("--baseline", options->design.baseline_mm, "How far apart they are, mm")
      ->check(within(calib::kSmallestBaseline_mm, calib::kLargestBaseline_mm, "mm"))
      ->type_name("MM");
  rig->add_option("--thickness", options->thickness_mm,
                  "Instead of --baseline: the baseline that gives this thickness at the first --distance (11.1)")
      ->check(is_thickness_mm())
      ->type_name("MM");
  rig->add_option("--tilt", options->tilt_deg,
                  "Each camera is turned towards the other by this (default: their axes meet at the first --distance)")
      ->check(within(-kLargestTilt_deg, kLargestTilt_deg, "degrees"))
      ->type_name("DEG");
  rig->add_option("--distance", options->distances_mm, "Planes across the axis of symmetry, at these distances")
      ->check(is_distance_mm())
      ->type_name("MM...");
  rig->add_option("--skin", options->skin, "Instead of planes: the skin (skin.yaml; see `horopter map --help`)")
      ->type_name("FILE");
  rig->add_option("--profile", options->profile,
                  "Build of the machine: " + profile_sizes() + " (default: the smallest that holds the image)")
      ->type_name("P");
  rig->add_option("--tolerance", options->tolerance_px,
                  "Disparity tolerance D, as D95, pixels of the result (`run --tolerance` means D50)")
      ->check(is_tolerance_px())
      ->capture_default_str()
      ->type_name("PX");
  add_decision(*rig, options->decision);
  rig->add_option(
         "--zone", options->zone,
         "What must not be entered unseen: a file with `surface:` as in skin.yaml, or the skin's own file; nothing moves")
      ->type_name("FILE");
  rig->add_option("--obstacle", options->obstacles,
                  "Files with `surface:`: floor, walls, tables. Nobody passes them, and they hide what is behind")
      ->type_name("FILE...");
  rig->add_option("--from", options->from_mm, "Where people are (default: everywhere around zone, skin and obstacles)")
      ->expected(3)
      ->check(any_number())
      ->type_name("X Y Z");
  rig->add_option(
         "--step", options->search.step_mm,
         "Of the search, mm: openings of 1.75 steps are found, narrower ones may be missed (default: 1/64 of the space)")
      ->check(above_zero())
      ->type_name("MM");
  rig->add_option("--out", options->out,
                  "Directory for rig.svg (drawing), distance.svg and .csv, rig.json, and the designed rig.yaml, which\n"
                  "replaces no other one")
      ->type_name("DIR");
  rig->add_flag("--json", options->json, "Print the report as JSON on standard output, and nothing else");
  rig->footer(
      "World of a designed rig: mm, origin between the cameras, x from left to right, y down, z along the axis of\n"
      "symmetry. `run`, `upload` and `monitor` warn of it: calibrate the cameras once there are some.\n"
      "Common field: the part of a skin that both cameras see; exploitation is its share of what the left one\n"
      "sees (Fig. 11.2). Viewing angle: between line of sight and the skin's normal; beyond 70 degrees it is not\n"
      "supervised. A place counts as seen when the machine decides about it: in both images, within the limits, not\n"
      "hidden, and with all of its windows (Fig. 11.4 shows an entry that is not). The way into the zone is searched on a\n"
      "lattice, around obstacles, and through whatever of the skin is not seen.\n"
      "At its rim a skin is not decided, for half a window: where it ends at a table, let it go on along the table.\n"
      "For --decision compete, pixels whose epipolar line leaves the row are not supervised: cameras turned towards each\n"
      "other, as without --tilt, lose the more the more they are turned (`horopter map --help`).\n"
      "Exit status 1: nothing of a skin is supervised, or so little that `map` refuses the cameras, or the zone can be\n"
      "entered unseen.\n\n"
      "Examples: horopter plan rig --focal 10 --pixel 8.5 --image-size 756 572 --thickness 10 --distance 800 --profile field --out plan\n"
      "          horopter plan rig --rig plan/rig.yaml --skin box.yaml --zone box.yaml --obstacle table.yaml --out plan");
  rig->callback([options, &outcome] { outcome.status = plan_rig(*options); });
}

}  // namespace horopter::cli
