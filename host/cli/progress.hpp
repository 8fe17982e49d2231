// SPDX-License-Identifier: Apache-2.0
// One line on a terminal for what takes more than two seconds; nothing at all elsewhere.
#pragma once

#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>

namespace horopter::cli {

class Progress {
 public:
  explicit Progress(std::string what) : what_(std::move(what)), terminal_(::isatty(STDERR_FILENO) != 0) {}
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(std::size_t done, std::optional<std::size_t> all) {
    using namespace std::chrono;
    const auto now = steady_clock::now();
    if (!terminal_ || now - start_ < seconds(2) || now - last_ < milliseconds(200)) return;
    last_ = now;
    shown_ = true;
    std::fprintf(stderr, "\r\033[K%s %zu", what_.c_str(), done);
    if (all) std::fprintf(stderr, " of %zu", *all);
    std::fflush(stderr);
  }
  void clear() {
    if (shown_) std::fprintf(stderr, "\r\033[K");
    shown_ = false;
  }

 private:
  std::string what_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_;
};

}  // namespace horopter::cli
