// SPDX-License-Identifier: Apache-2.0
// horopter study: the thesis's measurements, repeated.
#include "study.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

#include "commands.hpp"
#include "horopter/engines.hpp"

namespace horopter::cli {
namespace {

struct StudyOptions {
  std::string out;
  StudyScope scope;
  bool json = false;
};

using Study = nlohmann::json (*)(OutputDirectory&, const StudyScope&);

ExitStatus study(const StudyOptions& options, Study run) {
  OutputDirectory directory(options.out);
  nlohmann::json result = run(directory, options.scope);
  result["seed"] = options.scope.seed;
  result["quick"] = options.scope.quick;
  directory.write("summary.json", result.dump(2) + "\n");
  directory.commit();
  const auto status = result.value("frames_different", 0) == 0 ? ExitStatus::done : ExitStatus::check_failed;
  if (options.json) {
    std::puts(result.dump(2).c_str());
    return status;
  }
  for (const auto& line : result.at("findings")) fmt::print("{}\n", line.get<std::string>());
  fmt::print("Tables and plots are in {}\n", options.out);
  return status;
}

}  // namespace

void add_study(CLI::App& app, Outcome& outcome) {
  CLI::App* command = app.add_subcommand("study", "Repeat the thesis's measurements, with tables and plots");
  command->require_subcommand(1);
  const auto add = [&](const char* name, const char* what, Study run) {
    auto options = std::make_shared<StudyOptions>();
    CLI::App* one = command->add_subcommand(name, what);
    one->add_option("--out", options->out, "Directory for the tables (CSV) and plots (SVG)")
        ->required()
        ->type_name("DIR");
    one->add_option("--seed", options->scope.seed, "Of the noise")->capture_default_str()->type_name("N");
    one->add_flag("--quick", options->scope.quick, "Fewer images, methods and runs: to see that all is well");
    one->add_flag("--json", options->json, "Print summary.json on standard output, and nothing else");
    one->callback([options, run, &outcome] { outcome.status = study(*options, run); });
    return std::pair(one, options);
  };
  add("edges", "Sub-pixel edge estimators on simulated edges: position, blur, noise, points per edge (6.7)",
      study_edges);
  add("calibration", "Calibration with a rendered rig: NCE, image error, Cramer-Rao bound (6.8, 6.9)",
      study_calibration);
  add("interpolation", "Bilinear interpolation with weights of few bits: scaling, translation (7.5)",
      study_interpolation);
  const auto [board, options] =
      add("board", "A skin in mm on photographs of a chessboard, calibrated on the others, moved through the board",
          study_board);
  options->scope.engines = engine_names();
  board->add_option("--data", options->scope.data, "Directory with left01.jpg … right14.jpg")
      ->capture_default_str()
      ->type_name("DIR");
  board->add_option("--engines", options->scope.engines, "Engines, which must see the same")
      ->capture_default_str()
      ->check(CLI::IsMember(engine_names()))
      ->delimiter(',')
      ->type_name("LIST");
}

}  // namespace horopter::cli
