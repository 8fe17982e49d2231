// SPDX-License-Identifier: Apache-2.0
// horopter pattern: calibration targets to print.
#include "horopter/calib/pattern.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "commands.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/image/output.hpp"

namespace horopter::cli {
namespace {

struct PatternCommand {
  std::string target;
  std::string out;
  std::string paper = "a4";
  bool inverse = false;
  bool hole = true;
  bool json = false;
};

ExitStatus pattern(const PatternCommand& command) {
  std::string extension = std::filesystem::path(command.out).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension != ".pdf" && extension != ".svg")
    throw UsageError(fmt::format("--out '{}'; expected a name that ends in .pdf or .svg", command.out));
  calib::PatternOptions options;
  calib::Pattern sheet;
  try {
    options.spec = calib::TargetSpec::parse(command.target);
    options.paper = calib::paper_size(command.paper);
    options.inverse = command.inverse;
    options.hole = command.hole;
    sheet = calib::make_pattern(options);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  write_file(command.out, extension == ".pdf" ? calib::pattern_pdf(sheet) : calib::pattern_svg(sheet));
  if (command.json) {
    const nlohmann::json result{
        {"file", command.out},
        {"target", options.spec.text()},
        {"inverse", options.inverse},
        {"paper", options.paper.name},
        {"sheet_mm", {sheet.width_mm, sheet.height_mm}},
        {"origin_mm", {sheet.origin_mm.x(), sheet.origin_mm.y()}},
        {"bars_mm", {sheet.bar_x_mm, sheet.bar_y_mm}},
    };
    std::puts(json_text(result).c_str());
  } else {
    fmt::print(
        "{}: {} on {} ({} x {} mm). Print it at actual size and check with a ruler that the bars are\n"
        "{} mm (along x) and {} mm (along y) long.\n",
        command.out, sheet.title, options.paper.name, sheet.width_mm, sheet.height_mm, sheet.bar_x_mm, sheet.bar_y_mm);
  }
  return ExitStatus::done;
}

}  // namespace

void add_pattern(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<PatternCommand>();
  CLI::App* command = app.add_subcommand("pattern", "Make a calibration target to print, in exact millimetres");
  command
      ->add_option("--target", options->target,
                   "squares:COLUMNSxROWS:SIDEmm:PITCHmm, diamonds:COLUMNSxROWS:SIDEmm:PITCHmm or\n"
                   "chessboard:COLUMNSxROWS:SQUAREmm (inner corners)")
      ->required()
      ->type_name("TARGET");
  command->add_option("-o,--out", options->out, "The file to write, .pdf or .svg")->required()->type_name("FILE");
  command->add_option("--paper", options->paper, "a0 ... a5, letter, legal, tabloid, or WIDTHxHEIGHT in mm")
      ->capture_default_str()
      ->type_name("PAPER");
  command->add_flag("--inverse", options->inverse, "Bright fiducials on black ground");
  command->add_flag_callback(
      "--no-hole", [options] { options->hole = false; },
      "No hole in the first fiducial; images then do not tell how the target is turned");
  command->add_flag("--json", options->json, "Print what was made as JSON on standard output, and nothing else");
  command->footer(
      "The sheet is turned so that the target fits. Lengths of the bars count from outside to outside.\n\n"
      "Example: horopter pattern --target squares:8x6:15mm:25mm --out target.pdf");
  command->callback([options, &outcome] { outcome.status = pattern(*options); });
}

}  // namespace horopter::cli
