// SPDX-License-Identifier: Apache-2.0
// A client of the monitor's Modbus server, as a PLC is one.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <pthread.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace horopter::test {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

inline double since_ms(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - begin).count();
}

/// Of this computer, which nobody uses just now.
inline int free_port() {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  if (socket < 0) return 0;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  if (::bind(socket, reinterpret_cast<sockaddr*>(&address), size) != 0) address.sin_port = 0;
  ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
  ::close(socket);
  return ntohs(address.sin_port);
}

/// -1: nobody listens.
inline int connect_to(int port, std::chrono::seconds patience = 10s) {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket < 0) return -1;
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int on = 1;
  ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  const timeval longest{.tv_sec = patience.count(), .tv_usec = 0};
  ::setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &longest, sizeof longest);
  if (::connect(socket, reinterpret_cast<sockaddr*>(&place), sizeof place) == 0) return socket;
  ::close(socket);
  return -1;
}

/// A client of Modbus TCP by the letter of its specification, which asks again and again.
class Plc {
 public:
  explicit Plc(int port) : port_(port), thread_([this] { run(); }) {}
  ~Plc() {
    ending_ = true;
    thread_.join();
  }
  Plc(const Plc&) = delete;
  Plc& operator=(const Plc&) = delete;

  struct Answer {
    Clock::time_point asked, came;
    bool safe = false;
    unsigned heartbeat = 0;
    unsigned age_ms = 0;
  };
  /// Those to questions that were asked after a moment.
  std::vector<Answer> answers_after(Clock::time_point moment) const {
    const std::lock_guard lock(mutex_);
    std::vector<Answer> found;
    for (const Answer& answer : answers_) {
      if (answer.asked >= moment) found.push_back(answer);
    }
    return found;
  }
  std::optional<Answer> first_unsafe_after(Clock::time_point moment) const {
    for (const Answer& answer : answers_after(moment)) {
      if (!answer.safe) return answer;
    }
    return std::nullopt;
  }
  bool safe() const {
    const std::lock_guard lock(mutex_);
    return !answers_.empty() && Clock::now() - answers_.back().came < 500ms && answers_.back().safe;
  }

  /// CPU time of its thread so far.
  double cpu_s() const {
    clockid_t clock{};
    timespec time{};
    if (::pthread_getcpuclockid(const_cast<std::thread&>(thread_).native_handle(), &clock) != 0) return 0;
    ::clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

 private:
  static constexpr std::size_t kMostKept = 100'000;

  static std::optional<Answer> ask(int socket) {
    constexpr std::array<std::uint8_t, 12> kQuestion{0, 1, 0, 0, 0, 6, 1, 4, 0, 0, 0, 14};
    std::array<std::uint8_t, 9 + 28> bytes{};
    Answer answer;
    answer.asked = Clock::now();
    if (::send(socket, kQuestion.data(), kQuestion.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(kQuestion.size()) ||
        ::recv(socket, bytes.data(), bytes.size(), MSG_WAITALL) != static_cast<ssize_t>(bytes.size())) {
      return std::nullopt;
    }
    answer.came = Clock::now();
    const auto value = [&](std::size_t i) { return static_cast<unsigned>(bytes[9 + 2 * i] << 8 | bytes[10 + 2 * i]); };
    answer.safe = value(2) == 1 && value(3) == 0;
    answer.heartbeat = value(1);
    answer.age_ms = value(5);
    return answer;
  }
  void run() {
    int socket = -1;
    for (; !ending_; std::this_thread::sleep_for(1ms)) {
      if (socket < 0) socket = connect_to(port_);
      const auto answer = socket >= 0 ? ask(socket) : std::nullopt;
      if (answer) {
        const std::lock_guard lock(mutex_);
        answers_.push_back(*answer);
        if (answers_.size() > kMostKept) answers_.pop_front();
      } else if (socket >= 0) {
        ::close(socket);
        socket = -1;
      }
    }
    if (socket >= 0) ::close(socket);
  }

  int port_;
  mutable std::mutex mutex_;
  std::deque<Answer> answers_;
  std::atomic<bool> ending_ = false;
  std::thread thread_;
};

}  // namespace horopter::test
