// SPDX-License-Identifier: Apache-2.0
// `horopter monitor` and what runs beside it, for tests from outside. Limits of time are long: a slow computer fails no test.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "eventually.hpp"
#include "plc.hpp"
#include "sandbox.hpp"

namespace horopter::test {

using nlohmann::json;
using namespace std::chrono_literals;

inline const std::string kData = "/usr/share/doc/opencv-doc/examples/data/";

/// A program that runs beside the test, until its end or that of the test. It can be told words on its standard input.
class Running {
 public:
  Running(const Sandbox& box, std::vector<std::string> command, const std::string& name)
      : out_(box / (name + ".out")), err_(box / (name + ".err")) {
    std::array<int, 2> in{};
    REQUIRE(::pipe2(in.data(), O_CLOEXEC) == 0);
    in_ = in[1];
    std::vector<char*> argv;
    for (std::string& word : command) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in[0], 0);
    posix_spawn_file_actions_addopen(&actions, 1, out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addchdir_np(&actions, box.operator/("").c_str());
    const int spawned = ::posix_spawnp(&child_, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(in[0]);
    CAPTURE(command);
    REQUIRE(spawned == 0);
  }
  ~Running() {
    if (child_ != 0) end(SIGKILL);
    ::close(in_);
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  void send(int signal) const { ::kill(child_, signal); }
  void tell(const std::string& line) const {
    const std::string text = line + "\n";
    REQUIRE(::write(in_, text.data(), text.size()) == static_cast<ssize_t>(text.size()));
  }
  pid_t id() const { return child_; }
  /// Its status, or 128 + the signal that it died of.
  int wait() {
    int status = 0;
    ::waitpid(child_, &status, 0);
    child_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  int end(int signal) {
    send(signal);
    return wait();
  }
  std::string out() const { return read_text(out_); }
  std::string err() const { return read_text(err_); }
  std::vector<json> events() const {
    std::vector<json> events;
    std::istringstream lines(out());
    for (std::string line; std::getline(lines, line);) {
      if (!lines.eof()) events.push_back(json::parse(line));  // the last may not be whole yet
    }
    return events;
  }
  /// The first of this name for which the condition holds; null where none comes.
  json event(const std::string& name, const std::function<bool(const json&)>& condition = {}) const {
    json found;
    eventually([&] {
      for (const json& event : events()) {
        if (event["event"] != name || (condition && !condition(event))) continue;
        found = event;
        return true;
      }
      return false;
    });
    return found;
  }

 private:
  fs::path out_, err_;
  int in_ = -1;
  pid_t child_ = 0;
};

inline bool has_cause(const json& event, const std::string& name) {
  for (const json& cause : event["causes"]) {
    if (cause["name"] == name) return true;
  }
  return false;
}

/// The rig of the photographs, a skin in front of which most of them are safe, and a cell.
class CellBox : public Sandbox {
 public:
  CellBox() {
    static const std::string rig = [this] {
      const auto made = run({"calibrate", "--left", kData + "left??.jpg", "--right", kData + "right??.jpg", "--target",
                             "chessboard:9x6:30mm", "-o", "rig.yaml"});
      INFO(made.err);
      REQUIRE(made.status == 0);
      return read("rig.yaml");
    }();
    write("rig.yaml", rig);
    write("skin.yaml", "surface: {type: plane, point_mm: [0, 0, 300], normal: [0, 0, -1]}\n");
  }
  std::string cell(const std::string& cameras, const std::string& more) const {
    return write("cell.yaml",
                 "name: test\ncameras:\n" + cameras + "  frames_per_s: 2\nrig: rig.yaml\nskin: skin.yaml\n" + more);
  }
  Running start(const std::vector<std::string>& more = {}) const {
    return Running(*this, std::vector<std::string>{HOROPTER_PROGRAM, "monitor", "cell.yaml", "--json"} + more,
                   "monitor");
  }
};

}  // namespace horopter::test
