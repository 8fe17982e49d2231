// SPDX-License-Identifier: Apache-2.0
// horopter: the program. Results go to standard output, everything else to standard error.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <opencv2/core/utils/logger.hpp>
#include <string>

#include "commands.hpp"
#include "words.hpp"
#ifdef HOROPTER_HAS_RTL
#include "horopter/machine/engines.hpp"
#include "horopter/machine/rtl_device.hpp"
#endif
#ifdef HOROPTER_HAS_STUDY
#include "study/commands/command.hpp"
#endif

namespace horopter::cli {
namespace {

volatile std::sig_atomic_t stop_requested = 0;

void request_stop(int) {
  // A second request ends the program at once.
  if (stop_requested != 0) ::_exit(static_cast<int>(ExitStatus::fault));
  stop_requested = 1;
}

int fail(ExitStatus status, const char* message) {
  std::fprintf(stderr, "horopter: %s\n", message);
  return static_cast<int>(status);
}

int run(int argc, char** argv) {
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  // Decoders' complaints come as exceptions with a file name instead.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
#ifdef HOROPTER_HAS_RTL
  register_engine("rtl", make_rtl_device);
#endif

  CLI::App app{
      "Watches an invisible skin around a robot with two cameras: what is in the skin looks the same in the left\n"
      "image and in the right image transformed by the skin's mapping table.",
      "horopter"};
  app.require_subcommand(1);
  app.set_version_flag("--version", HOROPTER_VERSION);
  app.footer(
      "Exit status: 0 done (alarm or not), 1 a check failed, 2 wrong usage, 3 an input file is missing or bad,\n"
      "4 fault of a frame, the device or the engine. `horopter COMMAND --help` tells all about a command.");
  Outcome outcome;
  add_run(app, outcome);
  add_map(app, outcome);
  add_evaluate(app, outcome);
  add_calibrate(app, outcome);
  add_pattern(app, outcome);
  add_plan(app, outcome);
#ifdef HOROPTER_HAS_STUDY
  add_study(app, outcome);
#endif
  try {
    app.parse(argc, argv);
  } catch (const CLI::RequiredError& error) {
    // What is missing may be there, but mistyped.
    if (const auto unknown = app.remaining(true); !unknown.empty()) {
      std::fprintf(stderr, "horopter: unknown '%s'\n", unknown.front().c_str());
    }
    app.exit(error);
    return static_cast<int>(ExitStatus::usage);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitStatus::usage);
  }
  return static_cast<int>(outcome.status);
}

}  // namespace

bool interrupted() { return stop_requested != 0; }

}  // namespace horopter::cli

int main(int argc, char** argv) {
  try {
    return horopter::cli::run(argc, argv);
  } catch (const std::exception& error) {
    return horopter::cli::fail(horopter::status_of(error), error.what());
  }
}
