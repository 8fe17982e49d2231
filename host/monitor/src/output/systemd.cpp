// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/systemd.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace horopter::monitor {
namespace {

constexpr auto kBetween = std::chrono::milliseconds(100);

/// sd_notify(3), but it never waits: a systemd that hangs must not hold the decision up. False: it was not taken.
bool notify(std::string_view text) {
  const char* const path = std::getenv("NOTIFY_SOCKET");
  if (path == nullptr) return true;
  sockaddr_un place{};
  place.sun_family = AF_UNIX;
  const std::size_t length = std::strlen(path);
  if (length == 0 || length >= sizeof place.sun_path) return true;
  std::memcpy(place.sun_path, path, length);
  if (path[0] == '@') place.sun_path[0] = '\0';  // of the abstract names
  const int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (socket < 0) return false;
  const ssize_t sent =
      ::sendto(socket, text.data(), text.size(), MSG_DONTWAIT | MSG_NOSIGNAL, reinterpret_cast<const sockaddr*>(&place),
               static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + length));
  ::close(socket);
  return sent == static_cast<ssize_t>(text.size());
}

}  // namespace

void SystemdNotice::turn(Clock::time_point now) {
  if (now - told_ < kBetween) return;
  ready_ = notify(ready_ ? "WATCHDOG=1" : "READY=1\nWATCHDOG=1") || ready_;
  told_ = now;
}

void SystemdNotice::stopping() { notify("STOPPING=1"); }

}  // namespace horopter::monitor
