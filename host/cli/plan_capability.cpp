// SPDX-License-Identifier: Apache-2.0
// horopter plan capability: how small a body is found at each place of a skin, how long that takes, and how far away the
// danger must be for it.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "alarm_frames.hpp"
#include "commands.hpp"
#include "horopter/base/interval.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/draw/map_draw.hpp"
#include "horopter/image/output.hpp"
#include "horopter/map/row_check.hpp"
#include "horopter/plan/capability.hpp"
#include "horopter/plan/tolerance.hpp"
#include "horopter/skin/skin_file.hpp"
#include "inputs.hpp"
#include "numbers.hpp"
#include "object.hpp"
#include "plan_inputs.hpp"
#include "thickness.hpp"
#include "warnings.hpp"
#include "words.hpp"

namespace horopter::cli {
namespace {

using Json = nlohmann::ordered_json;

/// What IEC 61496 and ISO 13855 speak of: fingers, hands, arms and legs.
constexpr std::array kAsked_mm{14.0, 20.0, 30.0, 40.0, 70.0};
constexpr double kHand_mm = 40;

struct CapabilityOptions {
  std::string rig;
  std::string skin;
  std::string profile;
  Settings settings;
  ObjectOption object;
  ThicknessOption thickness;
  TimingOptions timing;
  double speed_mm_s = kHandSpeed_m_s * 1e3;
  Body body = Body::ball;
  std::string draw;
  bool json = false;
};

/// The skin, and what is planned for it.
struct PlannedCapability {
  const MachineProfile& profile;
  ScanGeometry geometry;
  Settings settings;
  ObjectOption object;  ///< that is an alarm
  double d95_px;
  ThicknessPlan thickness;
  Crossing crossing;
  CapabilityPlan capability;
  Timing timing;
  double stopping_s;
  double fast_mm;  ///< at the worst place, of what moves at kIsoHandSpeed_m_s, and at --speed at least
  double slow_mm;  ///< at kHandSpeed_m_s

  double response_s() const { return detection_time_s(timing) + stopping_s; }
  double supervised_share() const {
    return static_cast<double>(thickness.supervised) / static_cast<double>(thickness.left_sees);
  }
  std::optional<IsoDistance> iso() const { return iso_13855_distance(response_s(), fast_mm, slow_mm); }
};

PlannedCapability plan(const CapabilityOptions& options) {
  const calib::Rig rig = read_rig(options.rig);
  refuse_what_has_no_place(options.skin);
  const auto skin = load_rig_skin(options.skin, rig);
  const calib::Camera& left = skin->cameras().left();
  const MachineProfile& profile = profile_for(options.rig, options.profile, left);
  const ScanGeometry geometry = scans_of(profile, left.width_px, left.height_px).front();
  const ViewLimits view = view_limits(profile, options.settings.decision);
  Settings settings = options.settings;
  set_thickness(options.thickness, *skin, profile, geometry, settings);
  const ObjectOption object =
      set_object(options.object, options.skin, rig, profile, left.width_px, left.height_px, settings);
  if (settings.object_px <= 0) throw UsageError("--object 0: no body is an alarm by itself; expected a size");
  const double tolerance_px = d95_px(settings);
  Timing timing = options.timing.timing(profile, settings.decision, geometry.height);
  timing.alarm_frames = settings.alarm_frames.of;
  check_alarm_frames(options.skin, rig, profile, left.width_px, left.height_px, timing.images_per_s, settings,
                     timing.longest_periods);
  ThicknessPlan thickness;
  try {
    thickness = plan_thickness(skin->cameras(), *skin->surface(), profile, geometry, tolerance_px, view);
  } catch (const std::invalid_argument& error) {
    throw FileError(options.skin, "", error.what(), "a skin in front of both cameras");
  }
  // Within the way of so many steps there are so many frames: two fields of an image are closer together than two images.
  const int frames = settings.alarm_frames.needed;
  const double step_s = timing.longest_s(frames) / frames;
  const Crossing crossing{.decision = settings.decision,
                          .body = options.body,
                          .object_limit_px = static_cast<double>(object_limit(settings, profile)),
                          .step_mm = options.speed_mm_s * step_s,
                          .images = frames,
                          .object_limit_mm2 = half_disc_mm2(settings)};
  CapabilityPlan capability = plan_capability(thickness, profile, crossing);
  const auto worst_mm = [&](double speed_m_s) {
    Crossing faster = crossing;
    faster.step_mm = speed_m_s * 1e3 * step_s;
    if (faster.step_mm <= crossing.step_mm) return capability.largest_mm;
    return plan_capability(thickness, profile, faster).largest_mm;
  };
  const double fast_mm = worst_mm(kIsoHandSpeed_m_s), slow_mm = worst_mm(kHandSpeed_m_s);
  return {profile,      geometry,
          settings,     object,
          tolerance_px, std::move(thickness),
          crossing,     std::move(capability),
          timing,       options.timing.stopping_ms * 1e-3,
          fast_mm,      slow_mm};
}

/// A size; null where none is.
Json size_json(double mm) { return std::isfinite(mm) ? Json(std::round(10 * mm) / 10) : Json(); }
std::string size_text(double mm) { return std::isfinite(mm) ? fmt::format("{:.1f} mm", mm) : "none"; }

void print_found(const CapabilityOptions& options, const PlannedCapability& plan) {
  const CapabilityPlan& found = plan.capability;
  fmt::print("profile    {}, rule {}, {:g} images a second, disparity tolerance (D95) {:.2f} px of the result\n",
             plan.profile.name, name_of(plan.settings.decision), plan.timing.images_per_s, plan.d95_px);
  fmt::print("object     {}\n", object_text(plan.object, plan.settings, plan.profile));
  if (found.supervised == 0) return;
  fmt::print(
      "skin       {:.1f} to {:.1f} mm thick, {:.1f} mm in the mean; {:.1f} % of what the left camera sees of it is "
      "supervised\n",
      plan.thickness.across.smallest, plan.thickness.across.largest, plan.thickness.across.mean,
      100 * plan.supervised_share());
  const std::string shape =
      options.body == Body::ball ? "a ball" : fmt::format("a rod of which {:g} mm lie in the skin", kRodLength_mm);
  fmt::print("body       {}, textured, at {:g} mm/s: it moves {:.1f} mm from image to image\n", shape,
             options.speed_mm_s, options.speed_mm_s * plan.timing.longest_s());
  fmt::print("smallest   {} at the best place, {} at the median, {} at the worst\n", size_text(found.smallest_mm),
             size_text(found.median_mm), size_text(found.largest_mm));
  for (const double mm : kAsked_mm) {
    fmt::print("  {:3g} mm   found at {:5.1f} % of what is supervised\n", mm, 100 * found.share_found(mm));
  }
  if (const double none = 1 - found.share_found(kLargestBody_mm); none > 0) {
    fmt::print("  none up to {:g} mm at {:.1f} % of it: it is too thin for the speed, or the object too large\n",
               kLargestBody_mm, 100 * none);
  }
}

/// The rows of the rule and of the limit that is nearest.
std::vector<Walked> of_rule(std::span<const Walked> rows, const PlannedCapability& plan) {
  const std::int64_t limit_px = nearest_walked_px(object_limit(plan.settings, plan.profile));
  std::vector<Walked> result;
  for (const Walked& row : rows) {
    if (row.decision == plan.settings.decision && row.object_limit_px == limit_px) result.push_back(row);
  }
  return result;
}

double per_hour(double share) { return share * walk_setup().images_per_s * 3600; }

Json walked_json(const PlannedCapability& plan) {
  Json json{{"object_pixels", nearest_walked_px(object_limit(plan.settings, plan.profile))},
            {"rod_mm", walk_setup().rod_mm},
            {"rod_px", walk_setup().rod_px},
            {"fastest_m_s", walk_setup().fastest_m_s},
            {"within_frames", walk_setup().frames},
            {"found", Json::array()},
            {"false_alarms", Json::array()}};
  for (const Walked& row : of_rule(walked_rods(), plan)) {
    const Interval interval = wilson(row.hits, row.of);
    json["found"].push_back({{"coat", row.what},
                             {"taught", row.taught},
                             {"crossings", row.of},
                             {"found", row.hits},
                             {"interval", {interval.low, interval.high}}});
  }
  for (const Walked& row : of_rule(walked_lights(), plan)) {
    const Interval interval = wilson(row.hits, row.of);
    json["false_alarms"].push_back({{"disturbance", row.what},
                                    {"taught", row.taught},
                                    {"frames", row.of},
                                    {"alarms", row.hits},
                                    {"per_hour", {per_hour(interval.low), per_hour(interval.high)}}});
  }
  return json;
}

Json to_json(const CapabilityOptions& options, const PlannedCapability& plan) {
  const CapabilityPlan& found = plan.capability;
  Json json{
      {"profile", plan.profile.name},
      {"decision", name_of(plan.settings.decision)},
      {"body", name_of(options.body)},
      {"object", {{"px", std::round(10 * plan.settings.object_px) / 10}, {"pixels", plan.crossing.object_limit_px}}},
      {"tolerance_px", plan.d95_px},
      {"tolerance_is", "D95"},
      {"thickness_mm", range_json(plan.thickness.across)},
      {"speed_mm_s", options.speed_mm_s},
      {"images_per_s", plan.timing.images_per_s},
      {"supervised_pixels", found.supervised},
      {"pixels_of_the_skin", plan.thickness.left_sees},
      {"detection_capability_mm",
       {{"smallest", size_json(found.smallest_mm)},
        {"median", size_json(found.median_mm)},
        {"largest", size_json(found.largest_mm)}}},
      {"share_of_skin", Json::array()},
      {"none_found_share", 1 - found.share_found(kLargestBody_mm)},
      {"response", {{"items", Json::array()}, {"detection_ms", detection_time_s(plan.timing) * 1e3}}}};
  for (const double mm : kAsked_mm) json["share_of_skin"].push_back({{"mm", mm}, {"found", found.share_found(mm)}});
  for (const ResponseItem& item : detection_items(plan.timing)) {
    json["response"]["items"].push_back({{"item", item.name}, {"ms", item.seconds * 1e3}, {"source", item.source}});
  }
  json["walked"] = walked_json(plan);
  json["response"]["stopping_ms"] = plan.stopping_s * 1e3;
  json["response"]["total_ms"] = plan.response_s() * 1e3;
  json["safety_distance_mm"] = nullptr;
  if (const auto iso = plan.iso()) {
    json["safety_distance_mm"] = {
        {"k_m_s", iso->k_m_s}, {"d", iso->capability_mm}, {"c", iso->c_mm}, {"s", iso->distance_mm}};
  }
  return json;
}

/// What surfaces, and light, do to it.
void print_walked(const PlannedCapability& plan) {
  const WalkSetup& setup = walk_setup();
  fmt::print(
      "measured   `horopter study walk`: rods of {:g} mm, {:g} px wide, at up to {:g} m/s, through {:g} mm of skin, an object of {} "
      "pixels: found within {} frames [95 % limits]\n",
      setup.rod_mm, setup.rod_px, setup.fastest_m_s, setup.thickness_mm,
      nearest_walked_px(object_limit(plan.settings, plan.profile)), setup.frames);
  for (const Walked& row : of_rule(walked_rods(), plan)) {
    const Interval interval = wilson(row.hits, row.of);
    fmt::print("  {:10} {:14} {} of {} [{:.1f} %, {:.1f} %]\n", row.taught ? "taught" : "not taught", row.what,
               row.hits, row.of, 100 * interval.low, 100 * interval.high);
  }
  fmt::print("  without a body, false alarms an hour [95 % limits]\n");
  for (const Walked& row : of_rule(walked_lights(), plan)) {
    const Interval interval = wilson(row.hits, row.of);
    fmt::print("  {:10} {:28} {:.0f} [{:.0f}, {:.0f}], {} in {} frames\n", row.taught ? "taught" : "not taught",
               row.what, per_hour(static_cast<double>(row.hits) / static_cast<double>(row.of)), per_hour(interval.low),
               per_hour(interval.high), row.hits, row.of);
  }
}

/// Where walking found less than it should, or too little was walked to say that it found as much.
void warn_of_coats(const PlannedCapability& plan) {
  constexpr double kEnough = 0.999;
  std::vector<std::string> missed;
  std::vector<std::string> too_few;
  for (const Walked& row : of_rule(walked_rods(), plan)) {
    const Goal goal = goal_of(row.hits, row.of, kEnough);
    if (goal == Goal::reached) continue;
    (goal == Goal::missed ? missed : too_few)
        .push_back(fmt::format("{} ({}: {} of {})", row.what, row.taught ? "taught" : "not taught", row.hits, row.of));
  }
  const double rod_mm = walk_setup().rod_mm;
  if (!missed.empty()) {
    warn(
        fmt::format("the figures hold for bodies with texture; `horopter study walk` missed rods of {:g} mm; found: {}",
                    rod_mm, fmt::join(missed, ", ")));
  }
  if (!too_few.empty()) {
    warn(fmt::format("`horopter study walk` has too few crossings to say that {:g} % of rods of {:g} mm are found: {}",
                     100 * kEnough, rod_mm, fmt::join(too_few, ", ")));
  }
}

void print_response(const PlannedCapability& plan) {
  fmt::print("response   {:.1f} ms, from the object to the machine's stop\n", plan.response_s() * 1e3);
  for (const ResponseItem& item : detection_items(plan.timing)) {
    fmt::print("  {:6.2f} ms  {} ({})\n", item.seconds * 1e3, item.name, item.source);
  }
  fmt::print("  {:6.2f} ms  stopping{}\n", plan.stopping_s * 1e3,
             plan.stopping_s == 0 ? " (--stopping-ms: the robot's stopping time is not in it)" : " (--stopping-ms)");
}

void print_distance(const PlannedCapability& plan) {
  const auto iso = plan.iso();
  if (!iso) {
    fmt::print(
        "distance   none by ISO 13855:2010: it has C for a detection capability of up to {:g} mm, and here it is {}, of what "
        "moves at {} m/s and more\n",
        kIsoArm_mm, size_text(plan.slow_mm), kHandSpeed_m_s);
    return;
  }
  const double mm = iso->capability_mm;
  const std::string formula =
      mm <= kIsoHand_mm ? "C = 8 (d - 14) mm, 0 at least, for d up to 40 mm" : "C = 850 mm for d above 40, up to 70 mm";
  fmt::print(
      "distance   {:.0f} mm by ISO 13855:2010, S = K T + C: K {:.1f} m/s, T {:.1f} ms, C {:.0f} mm\n"
      "           {}; d {:.1f} mm, at K (--speed where that is more), at the worst place; approach at right angles to the skin\n",
      iso->distance_mm, iso->k_m_s, plan.response_s() * 1e3, iso->c_mm, formula, mm);
}

void draw(const CapabilityOptions& options, const PlannedCapability& plan) {
  const std::string title =
      fmt::format("Smallest {} found, {:g} mm/s, {} {}, object {:.0f} px", name_of(options.body), options.speed_mm_s,
                  plan.profile.name, name_of(plan.settings.decision), plan.settings.object_px);
  const auto drawn = draw_bodies(plan.geometry.width, plan.geometry.height, plan.capability.body_mm, title);
  const Picture& page = drawn.picture;
  write_file(options.draw, encode_png_bgr(page.width, page.height, page.bgr));
}

ExitStatus plan_capability(const CapabilityOptions& options) {
  check_outputs({{"--draw", options.draw}}, {{"--rig", options.rig}, {"--skin", options.skin}});
  if (!options.profile.empty()) find_profile(options.profile);
  const PlannedCapability planned = plan(options);
  if (!options.draw.empty()) draw(options, planned);
  Json json = to_json(options, planned);
  if (planned.capability.supervised > 0 && planned.capability.share_found(kHand_mm) < 1) {
    warn(fmt::format("a {} of {:g} mm is not found at {:.1f} % of this skin", name_of(options.body), kHand_mm,
                     100 * (1 - planned.capability.share_found(kHand_mm))));
  }
  if (planned.capability.supervised > 0 && planned.supervised_share() < kLittleSupervised) {
    warn(fmt::format(
        "{}: of what the left camera sees of this skin {:.0f} % is supervised; the figures are of that alone",
        options.skin, 100 * planned.supervised_share()));
  }
  warn_of_coats(planned);
  add_warnings(json);
  if (!options.json) {
    print_found(options, planned);
    if (planned.capability.supervised > 0) {
      print_walked(planned);
      print_response(planned);
      print_distance(planned);
    }
  }
  const ViewLimits view = view_limits(planned.profile, planned.settings.decision);
  const bool refused = !report_row_count(planned.thickness.rows, view, options.json);
  if (options.json) std::puts(json_text(json).c_str());
  if (planned.capability.supervised == 0) std::fprintf(stderr, "horopter: nothing of the skin is supervised\n");
  return planned.capability.supervised == 0 || refused ? ExitStatus::check_failed : ExitStatus::done;
}

}  // namespace

void add_plan_capability(CLI::App& plan, Outcome& outcome) {
  auto options = std::make_shared<CapabilityOptions>();
  CLI::App* command = plan.add_subcommand(
      "capability",
      "How small a body is found at each place of a skin, how long that takes, how far away the danger must be for it");
  command->add_option("--rig", options->rig, "The cameras (rig.yaml), with their image size")
      ->required()
      ->type_name("FILE");
  command->add_option("--skin", options->skin, "The skin (skin.yaml), with a surface in the rig's world")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--profile", options->profile,
                   "Build of the machine: " + profile_sizes() + " (default: the smallest that holds the image)")
      ->type_name("P");
  add_decision(*command, options->settings.decision);
  add_object(*command, options->object);
  add_alarm_frames(*command, options->settings.alarm_frames);
  add_thickness(*command, options->thickness);
  only(command->add_option_function<std::string>(
           "--body", [options](const std::string& name) { options->body = name == "rod" ? Body::rod : Body::ball; },
           fmt::format("ball: what shows least of all bodies so wide; rod: of which {:g} mm lie in the skin",
                       kRodLength_mm)),
       {"ball", "rod"})
      ->default_str("ball");
  command->add_option("--speed", options->speed_mm_s, "Of the fastest body, mm/s, across the skin; 0: it stands still")
      ->check(within(0, 100'000, "mm/s"))
      ->capture_default_str()
      ->type_name("MM/S");
  add_timing(*command, options->timing);
  command
      ->add_option(
          "--draw", options->draw,
          "A picture (PNG) of the smallest body at each place: red small to blue large, grey where none is found, "
          "dark where nothing is supervised")
      ->type_name("FILE");
  command->add_flag("--json", options->json, "Print the report as JSON on standard output, and nothing else");
  command->footer(
      "A body is found when one image of its crossing (N with --alarm-frames) is certain to show enough of it: the part of its surface that is in\n"
      "the skin, in pixels, times the share of a disc of that width which windows and majority leave (measured, least of\n"
      "many: host/include/horopter/machine/disc_table.def, made by test-discs), must reach the limit of --object. Cameras\n"
      "see the front of a body only; its back does not count. Thickness is that for D95 of the rule's setting. A px is as\n"
      "many mm as in its worst direction. The figures are for a body with texture, all of it before supervised skin, and a\n"
      "good frame.\n"
      "Other surfaces, and light that changes, are measured: host/src/plan/walk_table.def and\n"
      "hands_table.def, made by `horopter study walk`.\n"
      "S = K T + C is ISO 13855:2010, for detection zones across the way of approach: d is the largest figure of the skin, for\n"
      "what moves at K.\n"
      "Exit status 1: nothing of the skin is supervised, or so little that `map` refuses the cameras.\n\n"
      "Example: horopter plan capability --rig rig.yaml --skin skin.yaml --object 40mm --stopping-ms 120 --draw body.png");
  command->callback([options, &outcome] { outcome.status = plan_capability(*options); });
}

}  // namespace horopter::cli
