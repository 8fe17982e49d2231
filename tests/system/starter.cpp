// SPDX-License-Identifier: Apache-2.0
// The program, loaded once and started as often as it is asked to on file descriptor 3 (starter.hpp): loading its shared
// libraries takes longer than most of what tests ask of it.
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "cli/program.hpp"

namespace {

constexpr int kRequests = 3;
constexpr int kCannotStart = 126;  // as shells say it

bool opened_as(int descriptor, const std::string& file, int flags) {
  const int opened = ::open(file.c_str(), flags, 0600);
  return opened >= 0 && ::dup2(opened, descriptor) == descriptor && (opened == descriptor || ::close(opened) == 0);
}

/// words: folder to be in, files for standard output and standard error, and the command line.
[[noreturn]] void become_program(std::vector<std::string> words) {
  ::close(kRequests);
  if (words.size() < 4 || !opened_as(STDIN_FILENO, "/dev/null", O_RDONLY) ||
      !opened_as(STDOUT_FILENO, words[1], O_WRONLY | O_CREAT | O_TRUNC) ||
      !opened_as(STDERR_FILENO, words[2], O_WRONLY | O_CREAT | O_TRUNC) || ::chdir(words[0].c_str()) != 0) {
    std::perror("starting the program");
    ::_exit(kCannotStart);
  }
  std::vector<char*> arguments;
  for (std::size_t i = 3; i < words.size(); ++i) arguments.push_back(words[i].data());
  const int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  std::exit(horopter::cli::program(count, arguments.data()));
}

}  // namespace

int main() {
  std::vector<char> request(1 << 18);
  for (;;) {
    const ssize_t size = ::recv(kRequests, request.data(), request.size(), 0);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return size == 0 ? 0 : 1;
    std::vector<std::string> words;  // each ends with a zero
    for (std::size_t at = 0; at < static_cast<std::size_t>(size); at += words.back().size() + 1)
      words.emplace_back(&request[at]);
    const pid_t child = ::fork();
    if (child == 0) become_program(std::move(words));
    int status = 0;
    while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    const std::array<int, 2> answer{child, status};
    if (::send(kRequests, answer.data(), sizeof answer, 0) != sizeof answer) return 1;
  }
}
