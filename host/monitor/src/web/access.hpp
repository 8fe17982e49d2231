// SPDX-License-Identifier: Apache-2.0
// Sessions, and how often somebody may try.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "horopter/monitor/state.hpp"
#include "horopter/monitor/users.hpp"

namespace horopter::monitor {

/// 32 random bytes, in hexadecimal.
std::string random_token();
/// Takes as long whatever is different.
bool same_secret(const std::string& a, const std::string& b);

/// The users of a file, read again each second in which somebody asks. Without the file, or with a bad one, there are none.
class UserList {
 public:
  explicit UserList(std::filesystem::path file);
  [[nodiscard]] bool possible() const { return !file_.empty(); }
  std::optional<User> find(const std::string& name);
  /// Why nobody can log in; empty: it is not so.
  std::string problem();

 private:
  void read_again();

  std::filesystem::path file_;
  std::mutex mutex_;
  Clock::time_point looked_{};
  std::vector<User> users_;
  std::string problem_;
};

struct Session {
  std::string user;
  std::string hash;     ///< of the password: a session ends with it
  std::string request;  ///< the token that each change of state must carry
  Clock::time_point begin{};
  Clock::time_point seen{};
};

class Sessions {
 public:
  Sessions(Clock::duration longest, Clock::duration idle) : longest_(longest), idle_(idle) {}
  /// The token of a new one; the oldest goes where there are too many.
  std::string begin(const User& user);
  std::optional<Session> find(const std::string& token);
  void end(const std::string& token);

 private:
  static constexpr std::size_t kMost = 100;
  Clock::duration longest_;
  Clock::duration idle_;
  std::mutex mutex_;
  std::map<std::string, Session> sessions_;  ///< by the token's SHA-256
};

/// Lets through so many in a time, for each name; the names are bounded, too.
class RateLimit {
 public:
  RateLimit(double per_s, double burst) : per_s_(per_s), burst_(burst) {}
  bool allows(const std::string& name);
  /// As if one had not been.
  void give_back(const std::string& name);

 private:
  struct Bucket {
    double left = 0;
    Clock::time_point at;
  };
  static constexpr std::size_t kMost = 4096;
  double per_s_;
  double burst_;
  std::mutex mutex_;
  std::map<std::string, Bucket> buckets_;
};

}  // namespace horopter::monitor
