// SPDX-License-Identifier: Apache-2.0
#include "access.hpp"

#include <sodium.h>

#include <algorithm>
#include <array>
#include <utility>

namespace horopter::monitor {
namespace {

constexpr std::size_t kTokenBytes = 32;
constexpr auto kLookAgain = std::chrono::seconds(1);

template <std::size_t N>
std::string hexadecimal(const std::array<unsigned char, N>& bytes) {
  std::array<char, 2 * N + 1> text{};
  sodium_bin2hex(text.data(), text.size(), bytes.data(), bytes.size());
  return text.data();
}

/// What is kept of a token: who reads this memory cannot log in by it.
std::string key_of(const std::string& token) {
  std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
  crypto_hash_sha256(hash.data(), reinterpret_cast<const unsigned char*>(token.data()), token.size());
  return hexadecimal(hash);
}

}  // namespace

std::string random_token() {
  std::array<unsigned char, kTokenBytes> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  return hexadecimal(bytes);
}

bool same_secret(const std::string& a, const std::string& b) {
  return a.size() == b.size() && sodium_memcmp(a.data(), b.data(), a.size()) == 0;
}

UserList::UserList(std::filesystem::path file) : file_(std::move(file)) {
  if (!file_.empty()) users_ = read_users(file_);  // at the start a bad file is an error
}

void UserList::read_again() {
  const auto now = Clock::now();
  if (file_.empty() || now - looked_ < kLookAgain) return;
  looked_ = now;
  try {
    users_ = read_users(file_);
    problem_.clear();
  } catch (const std::exception& failure) {
    users_.clear();
    problem_ = failure.what();
  }
}

std::optional<User> UserList::find(const std::string& name) {
  const std::lock_guard lock(mutex_);
  read_again();
  for (const User& user : users_) {
    if (user.name == name) return user;
  }
  return std::nullopt;
}

std::string UserList::problem() {
  const std::lock_guard lock(mutex_);
  read_again();
  return problem_;
}

std::string Sessions::begin(const User& user) {
  const std::string token = random_token();
  const auto now = Clock::now();
  const std::lock_guard lock(mutex_);
  if (sessions_.size() >= kMost) {
    sessions_.erase(std::ranges::min_element(sessions_, {}, [](const auto& entry) { return entry.second.seen; }));
  }
  sessions_[key_of(token)] = {
      .user = user.name, .hash = user.hash, .request = random_token(), .begin = now, .seen = now};
  return token;
}

std::optional<Session> Sessions::find(const std::string& token) {
  if (token.size() != 2 * kTokenBytes) return std::nullopt;
  const auto now = Clock::now();
  const std::lock_guard lock(mutex_);
  const auto found = sessions_.find(key_of(token));
  if (found == sessions_.end()) return std::nullopt;
  if (now - found->second.begin > longest_ || now - found->second.seen > idle_) {
    sessions_.erase(found);
    return std::nullopt;
  }
  found->second.seen = now;
  return found->second;
}

void Sessions::end(const std::string& token) {
  const std::lock_guard lock(mutex_);
  sessions_.erase(key_of(token));
}

bool RateLimit::allows(const std::string& name) {
  if (per_s_ <= 0) return true;
  const auto now = Clock::now();
  const std::lock_guard lock(mutex_);
  if (buckets_.size() >= kMost && !buckets_.contains(name)) {
    // Those that are full again have nothing to remember.
    std::erase_if(buckets_, [&](const auto& entry) {
      return entry.second.left + std::chrono::duration<double>(now - entry.second.at).count() * per_s_ >= burst_;
    });
    if (buckets_.size() >= kMost) return false;
  }
  const auto [place, fresh] = buckets_.try_emplace(name, Bucket{.left = burst_, .at = now});
  Bucket& bucket = place->second;
  bucket.left = std::min(burst_, bucket.left + std::chrono::duration<double>(now - bucket.at).count() * per_s_);
  bucket.at = now;
  if (bucket.left < 1) return false;
  bucket.left -= 1;
  return true;
}

void RateLimit::give_back(const std::string& name) {
  const std::lock_guard lock(mutex_);
  const auto found = buckets_.find(name);
  if (found != buckets_.end()) found->second.left = std::min(burst_, found->second.left + 1);
}

}  // namespace horopter::monitor
