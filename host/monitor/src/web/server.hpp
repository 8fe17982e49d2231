// SPDX-License-Identifier: Apache-2.0
// The HTTP server behind a guard: what a connection may cost is bounded before a request is looked at.
//
// The head of a request is read whole, within its time and size, and refused unless it is of the few forms that the page
// needs. Only then does cpp-httplib see it.
#pragma once

#include <httplib.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>

namespace horopter::monitor {

struct ServerLimits {
  std::size_t connections = 64;
  std::size_t per_address = 32;
  std::size_t head_bytes = 8192;
  std::size_t body_bytes = 4096;
  std::size_t target_bytes = 512;
  std::size_t header_lines = 64;
  std::chrono::milliseconds request{5000};  ///< from its first byte to its last
  std::chrono::milliseconds response{10000};
  std::chrono::milliseconds idle{10000};  ///< between two requests
};

class GuardedServer : public httplib::Server {
 public:
  /// With certificate and key it speaks TLS. Throws FileError where these are none.
  GuardedServer(const ServerLimits& limits, const std::filesystem::path& certificate, const std::filesystem::path& key);
  ~GuardedServer() override;
  GuardedServer(const GuardedServer&) = delete;
  GuardedServer& operator=(const GuardedServer&) = delete;

  /// Ends all connections; listen_after_bind() returns.
  void stop_all();
  /// Of a handler: no further request is taken from its connection.
  static void close_after_answer(httplib::Response& response);

 private:
  struct Tls;
  bool process_and_close_socket(socket_t socket) override;
  bool admit(socket_t socket, const std::string& address);
  void leave(socket_t socket, const std::string& address);

  ServerLimits limits_;
  std::unique_ptr<Tls> tls_;
  std::mutex mutex_;
  bool stopping_ = false;
  std::set<socket_t> sockets_;
  std::map<std::string, std::size_t> of_address_;
};

}  // namespace horopter::monitor
