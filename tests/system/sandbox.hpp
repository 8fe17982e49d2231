// SPDX-License-Identifier: Apache-2.0
// The program in a directory of its own, for tests from outside.
#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "starter.hpp"

namespace horopter::test {

namespace fs = std::filesystem;

inline std::string read_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Sandbox {
 public:
  Sandbox() {
    std::string name = (fs::temp_directory_path() / "horopter-cli-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    own_ = name;
    path_ = own_ / "box";
    REQUIRE(fs::create_directory(path_));
  }
  ~Sandbox() {
    std::error_code error;
    fs::remove_all(own_, error);
  }
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  fs::path operator/(const std::string& name) const { return path_ / name; }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream stream(path_ / name, std::ios::binary);
    stream << text;
    stream.close();
    INFO("writing " << name);
    REQUIRE(stream);  // a full disk is not what is tested
    return (path_ / name).string();
  }
  std::string read(const std::string& name) const { return read_text(path_ / name); }
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(path_))
      names.insert(fs::relative(entry.path(), path_).string());
    return names;
  }

  struct Result {
    int status = -1;
    std::string out;
    std::string err;
  };
  /// Runs the program in the sandbox, with its standard input closed: it must not ask questions.
  /// Most images of these tests are no scenes by which clear could be earned: `run` is told so (earned.cpp tests it).
  Result run(std::vector<std::string> arguments) const {
    if (!arguments.empty() && arguments[0] == "run") arguments.emplace_back("--unproven");
    return run_proven(std::move(arguments));
  }
  Result run_proven(std::vector<std::string> arguments) const {
    static thread_local const Starter starter;
    arguments.insert(arguments.begin(), HOROPTER_PROGRAM);
    return result_of(starter.run(path_.string(), out(), err(), arguments), arguments);
  }
  /// Runs a script of the shell there, which finds the program as `horopter`.
  Result run_shell(const std::string& script) const {
    const std::string folder = fs::path(HOROPTER_PROGRAM).parent_path().string();
    std::vector<std::string> arguments{"/bin/sh", "-c", "PATH='" + folder + "':$PATH\n" + script};
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, out().c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, err().c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addchdir_np(&actions, path_.c_str());
    pid_t child = 0;
    const int spawned = ::posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    CAPTURE(arguments);
    INFO("starting it: " << std::strerror(spawned));
    REQUIRE(spawned == 0);
    int status = 0;
    pid_t ended = -1;
    while ((ended = ::waitpid(child, &status, 0)) < 0 && errno == EINTR) {
    }
    REQUIRE(ended == child);
    return result_of(status, arguments);
  }

 private:
  // Beside the sandbox, of which the files are compared.
  std::string out() const { return (own_ / "out").string(); }
  std::string err() const { return (own_ / "err").string(); }

  /// status: as waitpid gives it.
  Result result_of(int status, const std::vector<std::string>& arguments) const {
    Result result{-1, read_text(out()), read_text(err())};
    CAPTURE(arguments);
    INFO("it was killed, by signal " << (WIFSIGNALED(status) ? WTERMSIG(status) : 0) << "; it said " << result.err);
    REQUIRE(WIFEXITED(status));
    result.status = WEXITSTATUS(status);
    return result;
  }

  fs::path own_;   ///< of this sandbox alone: the sandbox, and what the program said
  fs::path path_;  ///< the sandbox
};

inline std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// An input error: status 3, one line that names file and expectation; nothing is written, but the summary of an earlier
/// run in `out` may be set aside.
inline void check_bad_file(const Sandbox& box, const std::vector<std::string>& arguments, const std::string& file,
                           const std::string& message) {
  const auto before = box.files();
  const auto result = box.run(arguments);
  CAPTURE(result.err);
  CHECK(result.status == 3);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, Catch::StartsWith("horopter: ") && Catch::Contains(file) && Catch::Contains(message) &&
                             Catch::Contains("expected"));
  auto after = box.files();
  if (before.count("out/summary.json") != 0 && after.erase("out/earlier-summary.json") != 0) {
    after.insert("out/summary.json");
  }
  CHECK(after == before);
}

}  // namespace horopter::test
