// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "hlsc/diagnostics.hpp"
#include "hlsc/dump.hpp"
#include "hlsc/frontend.hpp"
int main(int argc, char** argv) {
  hlsc::Options o;
  o.stage_header = argv[1];
  o.stage_class = argv[2];
  for (int i = 3; i < argc; ++i) o.include_paths.push_back(argv[i]);
  try {
    std::cout << hlsc::dump(hlsc::compile_stage(o).graph);
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
