// SPDX-License-Identifier: Apache-2.0
// Replaces the runtime's own handlers, which end the process.
#include "horopter/verilated/stop.hpp"

#include <verilated.h>

namespace {

bool stops_at_errors = true;

[[noreturn]] void stop(const char* what, const char* file, int line, const char* hierarchy, const char* message) {
  std::string text = std::string{what} + " in " + (file ? file : "?") + ":" + std::to_string(line);
  if (hierarchy && *hierarchy) text += std::string{" ("} + hierarchy + ")";
  if (message && *message) text += std::string{": "} + message;
  throw horopter::verilated::Stopped{text};
}

}  // namespace

void horopter::verilated::stop_at_errors(bool stops) { stops_at_errors = stops; }

void vl_stop(const char* file, int line, const char* hierarchy) {
  if (stops_at_errors) stop("stop", file, line, hierarchy, nullptr);
}
void vl_finish(const char* file, int line, const char* hierarchy) { stop("finish", file, line, hierarchy, nullptr); }
void vl_fatal(const char* file, int line, const char* hierarchy, const char* message) {
  stop("fatal error", file, line, hierarchy, message);
}
