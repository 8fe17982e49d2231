// SPDX-License-Identifier: Apache-2.0
// The program as a function: for main, and for tests that start it a thousand times.
#pragma once

namespace horopter::cli {

/// horopter: results go to standard output, everything else to standard error. Returns the exit status. Once in a process:
/// a thread that waits for SIGINT and SIGTERM goes on.
int program(int argc, char** argv);

}  // namespace horopter::cli
