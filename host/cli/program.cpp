// SPDX-License-Identifier: Apache-2.0
#include "program.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <opencv2/core/utils/logger.hpp>
#include <string>
#include <thread>

#include "commands.hpp"
#include "horopter/base/ending.hpp"
#include "words.hpp"
#ifdef HOROPTER_HAS_RTL
#include "horopter/machine/engines.hpp"
#include "horopter/machine/rtl_device.hpp"
#endif
#include "study/commands/command.hpp"

namespace horopter::cli {
namespace {

constexpr int kStatusOfSignals = 128;  // plus the number, as shells say it

/// Set while a command ends by itself when it is asked to.
std::atomic<bool> ends_by_itself = false;
std::atomic<bool> stop_requested = false;

sigset_t requests_to_stop() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

/// Waits for a request to stop, in a thread of its own, and ends the program: whatever the others do.
void wait_for_end() {
  const sigset_t signals = requests_to_stop();
  int signal = 0;
  do {
    while (sigwait(&signals, &signal) != 0) {
    }
  } while (ends_by_itself && !stop_requested.exchange(true));
  prepare_ending();
  std::fprintf(stderr, "%shoropter: stopped by %s\n", ::isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "",
               signal == SIGINT ? "SIGINT" : "SIGTERM");
  ::_exit(kStatusOfSignals + signal);
}

/// The status, or another one where what was printed did not arrive.
int finish(int status) {
  ending_by_itself();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  std::fputs("horopter: standard output: cannot be written; expected a place with room\n", stderr);
  return static_cast<int>(ExitStatus::bad_file);
}

int fail(ExitStatus status, const char* message) {
  std::fprintf(stderr, "horopter: %s\n", message);
  return static_cast<int>(status);
}

int run(int argc, char** argv) {
  const sigset_t signals = requests_to_stop();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // in all threads that will be
  std::thread(wait_for_end).detach();
  std::signal(SIGPIPE, SIG_IGN);  // a reader that has gone is no reason to lose results
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
      "4 fault of a frame or of the machine, 130 stopped by SIGINT, 143 by SIGTERM.\n"
      "`horopter COMMAND --help` tells all about a command. A first run: README.md, \"Your own cameras\".");
  Outcome outcome;
  add_run(app, outcome);
  add_monitor(app, outcome);
  add_map(app, outcome);
  add_evaluate(app, outcome);
  add_calibrate(app, outcome);
  add_pattern(app, outcome);
  add_plan(app, outcome);
  add_upload(app, outcome);
  add_status(app, outcome);
  add_restart(app, outcome);
  add_teach(app, outcome);
  add_log(app, outcome);
  add_monitor_user(app, outcome);
  add_study(app, outcome);
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

bool asked_to_stop() {
  ends_by_itself = true;
  return stop_requested;
}

int program(int argc, char** argv) {
  int status = 0;
  try {
    status = run(argc, argv);
  } catch (const std::exception& error) {
    status = fail(status_of(error), error.what());
  }
  return finish(status);
}

}  // namespace horopter::cli
