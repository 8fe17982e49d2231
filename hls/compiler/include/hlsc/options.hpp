// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace hlsc {

/// What to compile. Sizes are checked by the front end, the clock by the scheduler.
struct Options {
  std::string stage_header;                 ///< path of the header that defines the stage
  std::string stage_class;                  ///< a C++ type, e.g. `horopter::stages::Lowpass<384>`
  std::vector<std::string> extra_includes;  ///< headers included before the stage's
  std::vector<std::string> include_paths;   ///< -I
  std::vector<std::string> defines;         ///< -D
  std::string top_name;                     ///< module name
  std::string clang = "clang++-19";
  /// A plain array becomes registers and multiplexers; above so many bits it must be a RAM.
  std::size_t largest_indexed_array_bits = 8192;
  std::size_t largest_state_bits = 65536;
  unsigned largest_loop = 4096;  ///< iterations of a loop that are unrolled
};

}  // namespace hlsc
