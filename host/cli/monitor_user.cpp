// SPDX-License-Identifier: Apache-2.0
// horopter monitor-user: who may use the page of a running monitor.
#include <fmt/format.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "commands.hpp"
#include "horopter/base/ending.hpp"
#include "horopter/monitor/users.hpp"
#include "words.hpp"

namespace horopter::cli {
namespace {

struct UserOptions {
  std::string file;
  std::string name;
  std::string role;
  bool remove = false;
};

/// While it lives, a terminal does not show what is typed; when a signal ends the program, it does again.
class Unseen {
 public:
  Unseen() : terminal_(::tcgetattr(STDIN_FILENO, &before_) == 0) {
    if (!terminal_) return;
    before_ending_.emplace([this] {
      mutex_.lock();
      show();
    });
    termios unseen = before_;
    unseen.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    const std::lock_guard lock(mutex_);
    ::tcsetattr(STDIN_FILENO, TCSANOW, &unseen);
    std::fputs("password: ", stderr);
  }
  ~Unseen() {
    if (!terminal_) return;
    before_ending_.reset();
    show();
    std::fputs("\n", stderr);
  }
  Unseen(const Unseen&) = delete;
  Unseen& operator=(const Unseen&) = delete;

 private:
  void show() const { ::tcsetattr(STDIN_FILENO, TCSANOW, &before_); }

  termios before_{};
  bool terminal_;
  std::mutex mutex_;
  std::optional<BeforeEnding> before_ending_;
};

std::string password_from_input() {
  const Unseen unseen;
  std::string password;
  std::getline(std::cin, password);
  if (password.ends_with('\r')) password.pop_back();
  return password;
}

ExitStatus set_user(const UserOptions& options) {
  if (options.remove) {
    if (!monitor::remove_user(options.file, options.name)) {
      throw UsageError(fmt::format("there is no user '{}' in {}", options.name, options.file));
    }
    fmt::print("{}: {} is removed\n", options.file, options.name);
    return ExitStatus::done;
  }
  const auto role = monitor::role_named(options.role);
  if (!role) throw UsageError("a role is missing; expected viewer, operator or engineer, or --remove");
  monitor::set_user(options.file, options.name, *role, password_from_input());
  fmt::print("{}: {} is {}\n", options.file, options.name, options.role);
  return ExitStatus::done;
}

}  // namespace

void add_monitor_user(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<UserOptions>();
  CLI::App* command = app.add_subcommand("monitor-user", "Who may use the page of `monitor`: adds and removes users");
  command->add_option("FILE", options->file, "The users, with hashes of their passwords; made where it is missing")
      ->required();
  command->add_option("NAME", options->name, "Of the user; one that is there gets this role and a new password")
      ->required();
  CLI::Option* role =
      only(command->add_option("ROLE", options->role,
                               "viewer looks; operator also restarts, where the configuration allows it;\n"
                               "engineer also teaches"),
           {"viewer", "operator", "engineer"});
  command->add_flag("--remove", options->remove, "Remove the user")->excludes(role);
  command->footer(
      "The password is the first line of standard input, 8 to 256 bytes; a terminal does not show it.\n\n"
      "Example: horopter monitor-user users anna operator");
  command->callback([options, &outcome] { outcome.status = set_user(*options); });
}

}  // namespace horopter::cli
