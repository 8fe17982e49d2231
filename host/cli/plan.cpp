// SPDX-License-Identifier: Apache-2.0
// horopter plan: what an installation will see, before it is built.
#include "horopter/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/draw/map_draw.hpp"
#include "horopter/image/output.hpp"
#include "horopter/map/row_check.hpp"
#include "horopter/skin/skin_file.hpp"
#include "inputs.hpp"
#include "numbers.hpp"
#include "plan_inputs.hpp"
#include "thickness.hpp"
#include "warnings.hpp"
#include "words.hpp"

namespace horopter::cli {
namespace {

struct ThicknessOptions {
  std::string rig;
  std::string skin;
  std::vector<double> distances_mm;
  std::string profile;
  double tolerance_px = kD95_px;
  Decision decision = Decision::thesis;
  TimingOptions timing;
  std::string out;
  bool json = false;
};

/// A skin to plan: the user's, or a plane across the axis of symmetry.
struct PlannedSkin {
  std::string name;
  std::string title;  ///< short enough for a picture
  std::string picture;
  SurfacePtr surface;
};

nlohmann::ordered_json to_json(const PlannedSkin& skin, const ThicknessPlan& plan, double images_per_s) {
  return {{"skin", skin.name},
          {"pixels", plan.pixels},
          {"exploitation", plan.exploitation()},
          {"supervised_pixels", plan.supervised},
          {"beyond_rows", plan.rows.share()},
          {"distance_mm", range_json(plan.distance)},
          {"slope_deg", range_json(plan.slope_deg)},
          {"thickness_mm",
           {{"sight", range_json(plan.sight)},
            {"across", range_json(plan.across)},
            {"formula", range_json(plan.formula)},
            {"on_axis", plan.on_axis},
            {"on_axis_formula", plan.on_axis_formula}}},
          {"face_width_mm", plan.face_width},
          {"largest_speed_m_s", largest_speed_m_s(plan.across.smallest, images_per_s)}};
}

void print_summary(const char* name, const Summary& summary, const char* unit, const std::string& note = "") {
  fmt::print("  {:30} {:8.2f} {:8.2f} {:8.2f} {}{}\n", name, summary.smallest, summary.mean, summary.largest, unit,
             note);
}

void print(const PlannedSkin& skin, const ThicknessPlan& plan, double images_per_s) {
  fmt::print("{}\n", skin.name);
  fmt::print("  {:30} {:8.1f} % of the left image has its part of the skin in the right one; {:.1f} % is supervised\n",
             "exploitation", 100 * plan.exploitation(),
             100 * static_cast<double>(plan.supervised) / static_cast<double>(plan.pixels));
  if (plan.supervised == 0) return;
  fmt::print("  {:30} {:>8} {:>8} {:>8}\n", "", "smallest", "mean", "largest");
  print_summary("distance along the axis", plan.distance, "mm");
  print_summary("slope against the axis", plan.slope_deg, "degrees");
  const auto on_axis = [](double mm) {
    return std::isfinite(mm) ? fmt::format("; on the axis {:.2f}", mm) : std::string("; the axis does not meet it");
  };
  print_summary("thickness, camera model", plan.across, "mm", on_axis(plan.on_axis));
  print_summary("  along the line of sight", plan.sight, "mm");
  print_summary("thickness, 11.1 and 11.2", plan.formula, "mm", on_axis(plan.on_axis_formula));
  if (std::isfinite(plan.face_width)) {
    fmt::print("  {:30} {:8.2f} mm of a face across the axis are in the skin where it slopes most (11.3)\n",
               "detectable width", plan.face_width);
  }
  fmt::print("  {:30} {:8.3f} m/s through the thinnest place, {:.3f} m/s through the mean\n", "largest speed",
             largest_speed_m_s(plan.across.smallest, images_per_s), largest_speed_m_s(plan.across.mean, images_per_s));
}

struct CamerasAndSkins {
  CameraPair cameras;
  std::vector<PlannedSkin> skins;
};

CamerasAndSkins read_skins(const ThicknessOptions& options) {
  const calib::Rig rig = read_rig(options.rig);
  if (!options.skin.empty()) {
    refuse_what_has_no_place(options.skin);
    const auto skin = load_rig_skin(options.skin, rig);
    return {skin->cameras(), {{skin->description(), "the skin", "thickness.png", skin->surface()}}};
  }
  CamerasAndSkins read{first_pair(rig, options.rig), {}};
  for (const double distance : options.distances_mm) {
    read.skins.push_back({fmt::format("plane across the axis of symmetry, {} mm from the cameras", distance),
                          fmt::format("a plane at {} mm", distance), fmt::format("thickness-{}-mm.png", distance),
                          StereoAxis(read.cameras).plane_at(distance)});
  }
  return read;
}

/// What holds for all skins of an installation.
struct Installation {
  const MachineProfile& profile;
  StereoAxis axis;
  double images_per_s;
  double detection_s;
  double response_s;
};

nlohmann::ordered_json to_json(const Installation& at, const ThicknessOptions& options) {
  return {{"rig", {{"baseline_mm", at.axis.baseline_mm}, {"tilt_deg", at.axis.tilt_deg}, {"f_px", at.axis.f_px}}},
          {"profile", at.profile.name},
          {"decision", name_of(options.decision)},
          {"tolerance_px", options.tolerance_px},
          {"tolerance_is", "D95"},
          {"images_per_s", at.images_per_s},
          {"detection_ms", at.detection_s * 1e3},
          {"stopping_ms", options.timing.stopping_ms},
          {"safety_distance_mm",
           {{"hand_1.6_m_s", safety_distance_mm(at.response_s, kHandSpeed_m_s)},
            {"hand_2.0_m_s", safety_distance_mm(at.response_s, kIsoHandSpeed_m_s)},
            {"iso_13855_without_c", iso_13855_distance_mm(at.response_s)}}},
          {"skins", nlohmann::ordered_json::array()}};
}

void print_before_skins(const Installation& at, const ThicknessOptions& options) {
  fmt::print("rig      baseline {:.2f} mm, each optical axis {:.2f} degrees off the axis of symmetry, f {:.1f} px\n",
             at.axis.baseline_mm, at.axis.tilt_deg, at.axis.f_px);
  fmt::print(
      "profile  {}, rule {}, {} images a second, disparity tolerance (D95) {} px of the result ({} px of the "
      "image)\n",
      at.profile.name, name_of(options.decision), at.images_per_s, options.tolerance_px,
      options.tolerance_px * at.profile.subsample);
}

void print_after_skins(const Installation& at, const ThicknessOptions& options) {
  fmt::print("response {:.1f} ms to the alarm and {:.1f} ms to stop{}\n", at.detection_s * 1e3,
             options.timing.stopping_ms,
             options.timing.stopping_ms == 0 ? " (--stopping-ms: the robot's stopping time is not in it)" : "");
  fmt::print(
      "safety   {:.0f} mm at a hand's 1.6 m/s (thesis 2.3); {:.0f} mm at 2.0 m/s; {:.0f} mm by ISO 13855:2010 "
      "(K T alone: its supplement C comes on top)\n",
      safety_distance_mm(at.response_s, kHandSpeed_m_s), safety_distance_mm(at.response_s, kIsoHandSpeed_m_s),
      iso_13855_distance_mm(at.response_s));
}

void write_picture(OutputDirectory& output, const PlannedSkin& skin, const ThicknessPlan& plan,
                   const ScanGeometry& geometry, double tolerance_px) {
  const auto [page, thinnest_mm, thickest_mm] =
      draw_thickness(geometry.width, geometry.height, plan.across_mm,
                     fmt::format("Thickness across {} for +-{:g} px (D95)", skin.title, tolerance_px));
  output.write(skin.picture, encode_png_bgr(page.width, page.height, page.bgr));
}

ExitStatus plan_thickness(const ThicknessOptions& options) {
  if (options.skin.empty() == options.distances_mm.empty()) {
    throw UsageError("either --skin or --distance is required");
  }
  if (!options.profile.empty()) find_profile(options.profile);
  const auto [cameras, skins] = read_skins(options);
  const MachineProfile& profile = profile_for(options.rig, options.profile, cameras.left());
  const ScanGeometry geometry = scans_of(profile, cameras.left().width_px, cameras.left().height_px).front();
  const ViewLimits view = view_limits(profile, options.decision);
  const Timing timing = options.timing.timing(profile, options.decision, geometry.height);
  const double images_per_s = 1 / timing.longest_s();  // at least
  const double detection_s = detection_time_s(timing);

  std::optional<OutputDirectory> output;
  if (!options.out.empty()) output.emplace(options.out).set_aside("thickness.json");
  const Installation installation{profile, StereoAxis(cameras), images_per_s, detection_s,
                                  detection_s + options.timing.stopping_ms * 1e-3};
  nlohmann::ordered_json json = to_json(installation, options);
  if (!options.json) print_before_skins(installation, options);
  double slowest_m_s = std::numeric_limits<double>::infinity();  // that may pass between two images
  bool nothing = false;
  bool refused = false;
  for (const PlannedSkin& skin : skins) {
    ThicknessPlan plan;
    try {
      plan = plan_thickness(cameras, *skin.surface, profile, geometry, options.tolerance_px, view);
    } catch (const std::invalid_argument& error) {
      throw FileError(options.rig, "", skin.name + ": " + error.what(), "a skin in front of both cameras");
    }
    if (plan.supervised > 0) {
      slowest_m_s = std::min(slowest_m_s, largest_speed_m_s(plan.across.smallest, images_per_s));
    }
    json["skins"].push_back(to_json(skin, plan, images_per_s));
    if (!options.json) print(skin, plan, images_per_s);
    refused = !report_row_count(plan.rows, view, options.json) || refused;
    nothing = nothing || plan.supervised == 0;
    if (output) write_picture(*output, skin, plan, geometry, options.tolerance_px);
  }
  if (slowest_m_s < kIsoHandSpeed_m_s) {
    warn(fmt::format(
        "a hand may cross this skin between two images unseen: the safety distances hold for what moves at up to {:.3f} "
        "m/s only",
        slowest_m_s));
  }
  add_warnings(json);
  if (output) {
    output->write("thickness.json", json_text(json) + "\n");
    output->commit();
  }
  if (options.json) {
    std::puts(json_text(json).c_str());
  } else {
    print_after_skins(installation, options);
    if (output) fmt::print("thickness.json and pictures are in {}\n", options.out);
  }
  if (nothing) std::fprintf(stderr, "horopter: nothing of a skin is supervised\n");
  return nothing || refused ? ExitStatus::check_failed : ExitStatus::done;
}

}  // namespace

void add_plan(CLI::App& app, Outcome& outcome) {
  CLI::App* command = app.add_subcommand("plan", "Plan an installation");
  command->require_subcommand(1);
  auto options = std::make_shared<ThicknessOptions>();
  CLI::App* thickness = command->add_subcommand(
      "thickness", "How thick a skin is, how fast an object may be, how far away the danger must be (2.3, 11.1, 11.2)");
  thickness->add_option("--rig", options->rig, "The cameras (rig.yaml), with their image size")
      ->required()
      ->type_name("FILE");
  thickness->add_option("--skin", options->skin, "The skin (skin.yaml; see `horopter map --help`)")->type_name("FILE");
  thickness
      ->add_option("--distance", options->distances_mm,
                   "Instead of a skin: planes across the axis of symmetry, at these distances from the cameras")
      ->check(is_distance_mm())
      ->type_name("MM...");
  thickness
      ->add_option("--profile", options->profile,
                   "Build of the machine: " + profile_sizes() + " (default: the smallest that holds the image)")
      ->type_name("P");
  thickness
      ->add_option("--tolerance", options->tolerance_px,
                   "Disparity tolerance D, as D95, pixels of the result (after sub-sampling); D95: that of Table 11.1 "
                   "(`run --tolerance` means D50)")
      ->transform(CLI::Validator(
          [](std::string& value) {
            if (value == "D95") value = fmt::format("{}", kD95_px);
            const std::string wrong = is_tolerance_px()(value);
            return wrong.empty() ? wrong : wrong + ", or D95";
          },
          ""))
      ->capture_default_str()
      ->type_name("PX|D95");
  add_decision(*thickness, options->decision);
  add_timing(*thickness, options->timing);
  thickness
      ->add_option("--out", options->out,
                   "Directory for thickness.json and pictures of the thickness (red thin to blue thick, dark where "
                   "nothing is supervised)")
      ->type_name("DIR");
  thickness->add_flag("--json", options->json, "Print the report as JSON on standard output, and nothing else");
  thickness->footer(
      "Thickness is measured across the skin, along its normal, between disparities of -D and +D: at every supervised\n"
      "pixel by the camera model, and as 2 D z^2 d_x / (b f) cos(slope) by equations 11.1 and 11.2, which hold for\n"
      "parallel cameras. D95 is the disparity up to which 95 % of an object's pixels are found; it depends on the\n"
      "threshold (Table 11.2: 0.4, 0.6, 0.7, 0.9, 1.0, 1.1 px at 11.3, 15.0, 18.4, 21.9, 25.1, 28.4 %).\n"
      "Largest speed is thickness times results a second: a faster object can pass between two images. The safety\n"
      "distance is response time times speed: to the alarm two image periods, the exposure and the machine's lines, and the\n"
      "robot's stopping time (`horopter plan capability` has it item by item). For --decision compete, pixels whose\n"
      "epipolar line leaves the row are not supervised (`horopter map --help`). Exit status 1: nothing of a skin is\n"
      "supervised, or so little that `map` refuses the cameras.\n\n"
      "Examples: horopter plan thickness --rig rig.yaml --skin skin.yaml --stopping-ms 120 --out plan\n"
      "          horopter plan thickness --rig host/examples/table_11_1.yaml --profile field --distance 700 800 900");
  thickness->callback([options, &outcome] { outcome.status = plan_thickness(*options); });
  add_plan_capability(*command, outcome);
  add_plan_rig(*command, outcome);
}

}  // namespace horopter::cli
