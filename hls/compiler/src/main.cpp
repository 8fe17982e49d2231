// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "hlsc/clang.hpp"
#include "hlsc/diagnostics.hpp"
#include "hlsc/driver.hpp"
#include "hlsc/dump.hpp"

namespace {

constexpr char kDescription[] =
    R"(hlsc compiles one C++ class with a `step` function into one pipelined SystemVerilog module, one step a clock.

  class Stage { public: struct In {…}; struct Out {…}; Out step(const In&); private: state };

Members become registers, horopter::hls::RAM members become memories, constexpr tables become ROMs. What has no
hardware is refused by file and line. hls/README.md says how to write a stage.)";

constexpr char kExamples[] = R"(Example:
  hlsc hls/stages/lowpass.hpp --class 'horopter::stages::Lowpass<horopter::hls::profiles::field>' \
       -I hls/include -I hls --top-name horopter_lowpass --clock-ns 8 --target ecp5 -o out

Exit status: 0 done; 1 the stage was refused; 2 wrong usage; 3 a file is missing or cannot be written.)";

}  // namespace

int main(int argc, char** argv) {
  hlsc::DriverOptions options;
  std::string directory = ".", target = "ecp5";
  bool dump_graph = false;

  CLI::App app{kDescription, "hlsc"};
  app.footer(kExamples);
  app.add_option("stage", options.stage.stage_header, "Header that defines the stage")
      ->required()
      ->type_name("STAGE.hpp");
  app.add_option("--class", options.stage.stage_class, "The class, with template arguments")
      ->required()
      ->type_name("CLASS");
  app.add_option("--include", options.stage.extra_includes, "Header included before the stage's")->type_name("HEADER");
  app.add_option("-I", options.stage.include_paths, "Include path")->type_name("DIR")->allow_extra_args(false);
  app.add_option("-D", options.stage.defines, "Macro")->type_name("NAME[=VALUE]")->allow_extra_args(false);
  app.add_option("--top-name", options.stage.top_name, "Module name [horopter_<header>]")->type_name("NAME");
  app.add_option("--clock-ns", options.schedule.clock_ns, "Clock period that logic may fill")
      ->type_name("NS")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--input-ns", options.schedule.input_ns, "When inputs come, after the clock: logic in front of them")
      ->type_name("NS")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--output-ns", options.schedule.output_ns,
                 "Outputs may be logic, if it ends by then [0: outputs are registers]")
      ->type_name("NS")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--target", target, "Delay model")->type_name("ecp5|ice40")->capture_default_str();
  app.add_option("-o,--output", directory, "Directory for NAME.sv and NAME.json")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_option("--source-root", options.emit.source_root, "Prefix taken off file names in the output")
      ->type_name("DIR");
  app.add_flag("--ram-parity", options.emit.ram_parity,
               "Keep a parity bit with each word of a RAM; output parity_error_o");
  app.add_option("--max-loop", options.stage.largest_loop, "Largest number of iterations that is unrolled")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--max-array-bits", options.stage.largest_indexed_array_bits,
                 "Largest plain array indexed by a variable")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--clang", options.stage.clang, "The compiler")->type_name("PROGRAM")->capture_default_str();
  app.add_flag("--allow-slow", options.schedule.allow_slow, "Warn where the clock is missed instead of refusing");
  app.add_flag("--dump-graph", dump_graph, "Print the dataflow graph and stop");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const auto model = hlsc::target_from_name(target == "ice40" ? "ice40hx" : target);
  if (!model) {
    std::cerr << "hlsc: unknown target '" << target << "': ecp5 or ice40\n";
    return 2;
  }
  options.schedule.delays = hlsc::make_delay_model(*model);
  const std::filesystem::path header(options.stage.stage_header);
  if (!std::filesystem::exists(header)) {
    std::cerr << "hlsc: " << header.string() << ": no such file\n";
    return 3;
  }
  if (options.stage.top_name.empty()) options.stage.top_name = "horopter_" + header.stem().string();
  options.emit.source_class = options.stage.stage_class;

  try {
    if (dump_graph) {
      std::cout << hlsc::dump(hlsc::compile_stage(options.stage).graph);
      return 0;
    }
    const hlsc::Compiled compiled = hlsc::compile(options);
    for (const std::string& warning : compiled.schedule.warnings) std::cerr << "hlsc: warning: " << warning << '\n';
    hlsc::write(compiled, directory);
    return 0;
  } catch (const hlsc::ClangError& error) {
    std::cerr << error.what();
    return 1;
  } catch (const hlsc::CompileError& error) {
    std::cerr << error.what() << '\n';
    return 1;
  } catch (const std::exception& error) {
    std::cerr << "hlsc: " << error.what() << '\n';
    return 3;
  }
}
