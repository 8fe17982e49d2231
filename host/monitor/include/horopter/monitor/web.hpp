// SPDX-License-Identifier: Apache-2.0
// The page of a running monitor: looks, explains, and passes on what those who may ask for.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "horopter/monitor/event_log.hpp"
#include "horopter/monitor/state.hpp"

namespace horopter::monitor {

struct WebConfiguration {
  std::string title = "Horopter";     ///< of the cell
  std::string address = "127.0.0.1";  ///< to listen on
  int port = 8080;                    ///< 0 = any that is free
  std::filesystem::path users;        ///< without it nobody can log in, and whoever reaches the page may look
  std::filesystem::path certificate;  ///< PEM, with `key`: TLS
  std::filesystem::path key;
  bool without_tls = false;             ///< listen elsewhere than on this computer, passwords readable on the way
  bool look_without_login = false;      ///< whoever reaches the page may look, though there are users
  bool teach_allowed = false;           ///< an engineer may teach from the page
  int teach_frames = 500;               ///< pairs that a command to teach takes
  bool restart_allowed = false;         ///< an operator may restart from the page
  std::vector<std::string> host_names;  ///< by which it may be called, beside addresses and `localhost`
  double decision_limit_ms = 500;       ///< an older decision is not shown as safe
  double pictures_per_s = 8;            ///< made for all who look, together
  double requests_per_s = 60;           ///< of an address; 0 = any
  double login_failures_per_min = 6;    ///< of an address; 0 = any
  double session_h = 12;
};

class Web {
 public:
  struct Sources {
    Control* control = nullptr;            ///< outlives the page
    EventLog* log = nullptr;               ///< may be null; outlives the page
    std::function<std::string()> metrics;  ///< may be empty
  };

  /// Listens when it returns. Throws UsageError for what would not be safe, FileError for users, certificate and key.
  Web(WebConfiguration configuration, Sources sources);
  ~Web();
  Web(const Web&) = delete;
  Web& operator=(const Web&) = delete;

  [[nodiscard]] int port() const;

 private:
  class Site;
  std::unique_ptr<Site> site_;
};

}  // namespace horopter::monitor
