// SPDX-License-Identifier: Apache-2.0
// horopter study: the thesis's measurements, repeated.
#include "study.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "cli/words.hpp"
#include "command.hpp"
#include "horopter/machine/engines.hpp"

namespace horopter::cli {
namespace {

struct StudyOptions {
  std::string out;
  StudyScope scope;
  bool json = false;
};

ExitStatus print_result(const StudyOptions& options, const nlohmann::json& result) {
  const auto status = result.value("frames_different", 0) == 0 ? ExitStatus::done : ExitStatus::check_failed;
  if (options.json) {
    std::puts(result.dump(2).c_str());
    return status;
  }
  for (const auto& line : result.at("findings")) fmt::print("{}\n", line.get<std::string>());
  fmt::print("Tables and plots are in {}\n", options.out);
  return status;
}

void add_texture_options(CLI::App& command, StudyScope& scope) {
  auto* texture = only(command.add_option("--texture", scope.texture, "Simulated texture"),
                       {"dead-leaves", "band-noise", "printed-dots"});
  command
      .add_option("--picture", scope.picture, "Your own image as texture, a pixel of it as large as one of the camera")
      ->excludes(texture)
      ->type_name("FILE");
}

void add_series_option(CLI::App& command, StudyScope& scope) {
  command
      .add_option("--series", scope.series,
                  "Your own images instead: a CSV file with the columns file,disparity_px, the reference first")
      ->type_name("FILE");
}

void add_data_option(CLI::App& command, StudyScope& scope, const std::string& what) {
  command.add_option("--data", scope.data, what)->capture_default_str()->type_name("DIR");
}

void add_board_options(CLI::App& command, StudyScope& scope) {
  scope.engines = engine_names();
  add_data_option(command, scope, "Directory with left01.jpg … right14.jpg");
  add_decision(command, scope.decision);
  add_thickness(command, scope.thickness);
  only(command.add_option("--engines", scope.engines, "Engines, which must see the same")->delimiter(','),
       engine_names())
      ->default_str(fmt::format("{}", fmt::join(engine_names(), ",")));
}

void add_decision_options(CLI::App& command, StudyScope& scope) {
  command
      .add_option(
          "--list", scope.lists,
          "Stereo pairs, as of `horopter evaluate` (default: opencv-doc's aloe and two simulated scenes). Given "
          "for several sets: on each also the variant that the other sets choose")
      ->type_name("FILE");
  add_data_option(command, scope, "Directory with aloeL.jpg, aloeR.jpg, aloeGT.png");
  command.add_option("--generated", scope.generated, "What hlsc made of the stages")
      ->capture_default_str()
      ->type_name("DIR");
  command
      .add_option("--synth", scope.synthesised,
                  "Directory with what scripts/synth --json wrote of each stage, <stage>.json, for its gates")
      ->type_name("DIR");
}

void add_earned_options(CLI::App& command, StudyScope& scope) {
  add_data_option(command, scope, "Directory with left01.jpg … right14.jpg and aloeL.jpg, aloeR.jpg, aloeGT.png");
  command
      .add_option("--list", scope.lists, "Rectified stereo pairs instead of opencv-doc's, as of `horopter evaluate`")
      ->type_name("FILE");
  command
      .add_option("--sets", scope.sets,
                  "Public sets of pairs instead, undisturbed: what share of what is clear stays clear. Directory with "
                  "middlebury/ and stereo/2006.txt, 2014.txt, views.txt; a set that is not there is skipped")
      ->type_name("DIR");
  command
      .add_option("--window", scope.window_px,
                  "Small skins: a square of so many px in the middle of the left image. Only of rectified pairs")
      ->check(CLI::Range(16, 1000))
      ->type_name("PX");
  command.add_flag("--harder", scope.harder,
                   "Other disturbances: of a part of an image, coarse or bent images. Not all of them are found");
  command.add_option("--frames", scope.frames, "Of each pair, with fresh noise")
      ->capture_default_str()
      ->check(CLI::Range(1, 10'000))
      ->type_name("N");
  only(command.add_option("--engine", scope.engine, "Engine")->capture_default_str(), engine_names());
}

void add_walk_options(CLI::App& command, StudyScope& scope) {
  constexpr int kFrames = 36;
  scope.frames = kFrames;
  add_data_option(command, scope, "Directory with the photographs of opencv-doc");
  command.add_option("--crossings", scope.crossings, "Of each body, surface and speed: 5, 4 and 5 of them")
      ->capture_default_str()
      ->check(CLI::Range(1, 100'000))
      ->type_name("N");
  command.add_flag("--less-light", scope.less_light, "Machines are taught for less light, too (run --less-light)");
  command.add_flag(
      "--hands", scope.hands,
      "Only rods of 40 mm at up to 1.6 m/s, before machines that were taught, with a limit of 40 mm, and no "
      "disturbances: for many crossings");
  command.add_option("--frames", scope.frames, "Without a body, of each disturbance and photograph")
      ->capture_default_str()
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N");
  add_thickness(command, scope.thickness);
  only(command.add_option("--engine", scope.engine, "Engine")->capture_default_str(), engine_names());
}

void add_late_options(CLI::App& command, StudyScope& scope) {
  add_data_option(command, scope, "Directory with the photographs of opencv-doc");
  command
      .add_option("--crossings", scope.crossings,
                  "Runs of each way (along the row, aslant, across) before each photograph")
      ->capture_default_str()
      ->check(CLI::Range(1, 100'000))
      ->type_name("N");
  only(command.add_option("--engine", scope.engine, "Engine")->capture_default_str(), engine_names());
}

}  // namespace

const std::vector<NamedStudy>& studies() {
  static const std::vector<NamedStudy> list{
      {"edges", "Sub-pixel edge estimators on simulated edges: position, blur, noise, points per edge (6.7)",
       study_edges},
      {"calibration", "Calibration with a rendered rig: NCE, image error, Cramer-Rao bound (6.8, 6.9)",
       study_calibration},
      {"sampling", "Point sampling, bilinear interpolation, supersampling over scale (7.3, 7.4, 7.5)", study_sampling},
      {"interpolation", "Bilinear interpolation with weights of few bits: scaling, translation (7.5)",
       study_interpolation},
      {"segmentation", "Every correlation criterion over disparity: detection rates, segmentation errors (8.4, 11.2.1)",
       study_segmentation},
      {"invariance", "Changes of brightness: what they do to each criterion (Table 8.3)", study_invariance},
      {"influences", "Noise, differing scale, differing blur: what is still detected (Table 8.4)", study_influences},
      {"objects", "Small objects: what of them is detected (8.5)", study_objects},
      {"cost", "Operations of each criterion (Table 8.5)", study_cost},
      {"detection", "What the hardware's stage detects at which displacement; thresholds for tolerances (11.2)",
       study_detection},
      {"slopes", "A skin that slopes: what is detected of an object (11.2.2)", study_slopes},
      {"problems", "Textures that repeat, even changes of brightness, clipped grey values (11.2.3)", study_problems},
      {"operators", "Morphological operators side by side (5.2)", study_operators},
      {"texture", "Measures of texture, and how much of it is needed against the noise (9)", study_texture},
      {"resolution", "Bits of the direction and of its difference (10.4.5)", study_resolution},
      {"computation", "Operations and memory accesses of each step (10.1)", study_computation},
      {"geometry", "Thickness of the skin and exploitation of the images over tilt and place (11.1)", study_geometry},
  };
  return list;
}

nlohmann::json run_study(Study study, const std::filesystem::path& out, const StudyScope& scope) {
  OutputDirectory directory(out);
  directory.set_aside("summary.json");
  StudyReport report(directory);
  study(report, scope);
  report.result["seed"] = scope.seed;
  report.result["quick"] = scope.quick;
  directory.write("summary.json", report.result.dump(2) + "\n");
  directory.commit();
  return report.result;
}

void add_study(CLI::App& app, Outcome& outcome) {
  CLI::App* command = app.add_subcommand("study", "Repeat the thesis's measurements, with tables and plots");
  command->require_subcommand(1);
  using Run = std::function<nlohmann::json(const StudyOptions&)>;
  const auto add = [&](const char* name, const char* what, const Run& run) {
    auto options = std::make_shared<StudyOptions>();
    CLI::App* one = command->add_subcommand(name, what);
    one->add_option("--out", options->out, "Directory for the tables (CSV) and plots (SVG)")
        ->required()
        ->type_name("DIR");
    one->add_option("--seed", options->scope.seed, "Of the noise")->capture_default_str()->type_name("N");
    one->add_flag("--quick", options->scope.quick, "Fewer images, methods and runs: to see that all is well");
    one->add_flag("--json", options->json, "Print summary.json on standard output, and nothing else");
    one->callback([options, run, &outcome] { outcome.status = print_result(*options, run(*options)); });
    return std::pair(one, &options->scope);
  };
  const auto add_one = [&](const char* name, const char* what, Study study) {
    return add(name, what,
               [study](const StudyOptions& options) { return run_study(study, options.out, options.scope); });
  };
  for (const NamedStudy& named : studies()) {
    const auto [one, scope] = add_one(named.name, named.what, named.run);
    if (named.run == study_segmentation || named.run == study_objects || named.run == study_detection ||
        named.run == study_influences)
      add_texture_options(*one, *scope);
    if (named.run == study_segmentation) add_series_option(*one, *scope);
    if (named.run == study_cost)
      one->add_flag("--times", scope->times, "Also the milliseconds of each criterion on this machine");
  }
  add("all", "All of these (not board, decision, earned, walk and late), with a page of every figure and STUDY.md",
      [](const StudyOptions& options) { return study_all(options.out, options.scope); });
  const auto [board, of_board] =
      add_one("board", "A skin in mm on photographs of a chessboard, calibrated on the others, moved through the board",
              study_board);
  add_board_options(*board, *of_board);
  const auto [decision, of_decision] = add_one(
      "decision", "The rules with parts left out, larger and smaller: what each gains and costs (12)", study_decision);
  add_decision_options(*decision, *of_decision);
  const auto [earned, of_earned] = add_one(
      "earned", "Clear must be earned: disturbed cameras, which of them ever read safe; false faults", study_earned);
  add_earned_options(*earned, *of_earned);
  const auto [walk, of_walk] = add_one(
      "walk", "Test bodies cross the skin before photographs: which are found, how soon; and false alarms without them",
      study_walk);
  add_walk_options(*walk, *of_walk);
  const auto [late, of_late] =
      add_one("late", "One camera a frame late, while a large thing moves: how many frames are safe", study_late);
  add_late_options(*late, *of_late);
}

}  // namespace horopter::cli
