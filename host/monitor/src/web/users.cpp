// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/users.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sodium.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <sstream>

#include "horopter/base/error.hpp"
#include "horopter/image/output.hpp"
#include "log/durable.hpp"

namespace horopter::monitor {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 32;
constexpr std::size_t kLargestFile = 1'000'000;
constexpr const char* kExpected = "NAME ROLE HASH, as `horopter monitor-user` writes them";
constexpr std::array<std::pair<Role, std::string_view>, 3> kRoles{
    {{Role::viewer, "viewer"}, {Role::plant_operator, "operator"}, {Role::engineer, "engineer"}}};

bool is_name(std::string_view name) {
  return !name.empty() && name.size() <= kLongestName && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  });
}

std::string hash_of(const std::string& password) {
  begin_sodium();
  std::array<char, crypto_pwhash_STRBYTES> hash{};
  if (::crypto_pwhash_str(hash.data(), password.data(), password.size(), crypto_pwhash_OPSLIMIT_INTERACTIVE,
                          crypto_pwhash_MEMLIMIT_INTERACTIVE) != 0) {
    throw Error(ExitStatus::fault, "the password cannot be hashed: there is not enough memory");
  }
  return hash.data();
}

[[noreturn]] void fail(const fs::path& file, const std::string& place, const std::string& problem,
                       const std::string& expected) {
  throw FileError(file.string(), place, problem, expected);
}

/// The text, of a file that only the right ones may read.
std::string read_private(const fs::path& file) {
  const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
  if (opened < 0) fail(file, "", fmt::format("the file cannot be read ({})", std::strerror(errno)), "a file of users");
  struct stat facts{};
  std::string text;
  std::string problem;
  if (::fstat(opened, &facts) != 0 || !S_ISREG(facts.st_mode)) {
    problem = "this is no file";
  } else if ((facts.st_mode & (S_IRWXO | S_IWGRP)) != 0) {
    problem = "others may read it or write to it";
  } else {
    std::array<char, 4096> buffer{};
    ssize_t got = 0;
    while ((got = ::read(opened, buffer.data(), buffer.size())) > 0 && text.size() <= kLargestFile) {
      text.append(buffer.data(), static_cast<std::size_t>(got));
    }
    if (got != 0) problem = "the file cannot be read";
  }
  ::close(opened);
  if (!problem.empty()) fail(file, "", problem, "a file of users that only its owner may change (chmod 600)");
  return text;
}

void write_users(const fs::path& file, const std::vector<User>& users) {
  std::string text = "# Who may use the page of `horopter monitor`: name, role, hash of the password.\n";
  for (const User& user : users) text += fmt::format("{} {} {}\n", user.name, name_of(user.role), user.hash);
  const int problem = write_durably(file, text, 0600);
  if (problem == 0) return;
  fail(file, "", fmt::format("the file cannot be written ({})", std::strerror(problem)),
       "a writable place, and the file's owner or root");
}

std::vector<User> users_or_none(const fs::path& file) {
  std::error_code error;
  return fs::exists(file, error) ? read_users(file) : std::vector<User>();
}

/// From reading users to writing them, nobody else changes those of this directory; where it cannot be locked, he may.
Descriptor lock_users(const fs::path& file) {
  Descriptor directory(::open(directory_of(behind_links(file)).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.valid()) {
    while (::flock(directory.get(), LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  return directory;
}

}  // namespace

std::string_view name_of(Role role) {
  return std::ranges::find(kRoles, role, &std::pair<Role, std::string_view>::first)->second;
}

std::optional<Role> role_named(std::string_view name) {
  const auto* const found = std::ranges::find(kRoles, name, &std::pair<Role, std::string_view>::second);
  return found == kRoles.end() ? std::nullopt : std::optional(found->first);
}

std::vector<User> read_users(const fs::path& file) {
  std::istringstream stream(read_private(file));
  std::vector<User> users;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    const std::string place = fmt::format("line {}", number);
    if (line.empty() || line.starts_with('#')) continue;
    std::istringstream words(line);
    User user;
    std::string role;
    std::string more;
    words >> user.name >> role >> user.hash;
    if (user.hash.empty() || words >> more) fail(file, place, "this is not three words", kExpected);
    if (!is_name(user.name)) fail(file, place, "this is no name of a user", kExpected);
    const auto known = role_named(role);
    if (!known) fail(file, place, fmt::format("'{}' is no role", role), "viewer, operator or engineer");
    if (!user.hash.starts_with(crypto_pwhash_argon2id_STRPREFIX) || user.hash.size() >= crypto_pwhash_STRBYTES) {
      fail(file, place, "this is no hash of a password", kExpected);
    }
    user.role = *known;
    if (std::ranges::find(users, user.name, &User::name) != users.end()) {
      fail(file, place, fmt::format("'{}' is there twice", user.name), "one line for each user");
    }
    users.push_back(std::move(user));
  }
  return users;
}

void set_user(const fs::path& file, const std::string& name, Role role, const std::string& password) {
  if (!is_name(name)) {
    throw UsageError(
        fmt::format("'{}' is no name; expected up to {} letters, digits, '-', '_' and '.'", name, kLongestName));
  }
  if (password.size() < kShortestPassword || password.size() > kLongestPassword) {
    throw UsageError(fmt::format("the password has {} bytes; expected {} to {}", password.size(), kShortestPassword,
                                 kLongestPassword));
  }
  const User user{.name = name, .role = role, .hash = hash_of(password)};  // takes its time: before the lock
  const Descriptor lock = lock_users(file);
  std::vector<User> users = users_or_none(file);
  const auto known = std::ranges::find(users, name, &User::name);
  if (known != users.end()) {
    *known = user;
  } else {
    users.push_back(user);
  }
  write_users(file, users);
}

bool remove_user(const fs::path& file, const std::string& name) {
  const Descriptor lock = lock_users(file);
  std::vector<User> users = read_users(file);
  if (std::erase_if(users, [&](const User& user) { return user.name == name; }) == 0) return false;
  write_users(file, users);
  return true;
}

bool is_password(const User* user, const std::string& password) {
  static const std::string nobody = hash_of("a password that nobody has");
  const std::string& hash = user != nullptr ? user->hash : nobody;
  const bool fits = ::crypto_pwhash_str_verify(hash.c_str(), password.data(), password.size()) == 0;
  return fits && user != nullptr;
}

}  // namespace horopter::monitor
