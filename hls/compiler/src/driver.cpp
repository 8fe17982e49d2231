// SPDX-License-Identifier: Apache-2.0
#include "hlsc/driver.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "hlsc/sidecar.hpp"

namespace hlsc {

namespace {

void write_if_changed(const std::filesystem::path& path, const std::string& text) {
  {
    std::ifstream old(path, std::ios::binary);
    std::ostringstream had;
    had << old.rdbuf();
    if (old && had.str() == text) {
      std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now());
      return;
    }
  }
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace

Compiled compile(const DriverOptions& options) {
  Compiled compiled;
  compiled.stage = compile_stage(options.stage);
  Graph& graph = compiled.stage.graph;
  graph = lower_for_target(graph, options.schedule);
  compiled.schedule = schedule(graph, options.schedule);
  compiled.module = emit(graph, compiled.schedule, options.emit);
  compiled.sidecar = sidecar(graph, compiled.schedule, options.emit, compiled.module);
  return compiled;
}

void write(const Compiled& compiled, const std::string& directory) {
  const std::filesystem::path folder(directory);
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) throw std::runtime_error("cannot make directory " + directory + ": " + problem.message());
  const std::string& name = compiled.stage.graph.top_name;
  write_if_changed(folder / (name + ".sv"), compiled.module.text);
  write_if_changed(folder / (name + ".json"), compiled.sidecar);
}

}  // namespace hlsc
