// SPDX-License-Identifier: Apache-2.0
// Starts the program by a process that has loaded it already (starter.cpp): a copy of that process, as new as one that was
// loaded anew. Its environment is that of the first start.
#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace horopter::test {

class Starter {
 public:
  Starter() {
    std::array<int, 2> ends{};
    REQUIRE(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) == 0);
    requests_ = ends[0];
    // Room for a long command line in one message.
    const int room = 1 << 17;
    ::setsockopt(requests_, SOL_SOCKET, SO_SNDBUF, &room, sizeof room);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], 3);
    std::string program = HOROPTER_STARTER;
    std::array<char*, 2> argv{program.data(), nullptr};
    const int spawned = ::posix_spawn(&process_, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    REQUIRE(spawned == 0);
  }
  ~Starter() {
    ::close(requests_);
    ::waitpid(process_, nullptr, 0);
  }
  Starter(const Starter&) = delete;
  Starter& operator=(const Starter&) = delete;

  /// Its status, as waitpid gives it, once it has ended.
  int run(const std::string& folder, const std::string& out, const std::string& err,
          const std::vector<std::string>& arguments) const {
    std::string request;
    const auto add = [&request](const std::string& word) { request.append(word.c_str(), word.size() + 1); };
    add(folder);
    add(out);
    add(err);
    for (const std::string& argument : arguments) add(argument);
    REQUIRE(::send(requests_, request.data(), request.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(request.size()));
    std::array<int, 2> answer{};
    REQUIRE(::recv(requests_, answer.data(), sizeof answer, 0) == sizeof answer);
    REQUIRE(answer[0] > 0);
    return answer[1];
  }

 private:
  int requests_ = -1;
  pid_t process_ = 0;
};

}  // namespace horopter::test
