// SPDX-License-Identifier: Apache-2.0
#include "output/log_and_page.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "horopter/map/map_json.hpp"
#include "horopter/monitor/event_log.hpp"
#include "horopter/monitor/metrics.hpp"
#include "horopter/monitor/web.hpp"

namespace horopter::monitor {
namespace {

LogSettings log_settings(const Cell& cell) {
  constexpr double kBytes = 1e6;
  LogSettings settings;
  settings.directory = cell.log->directory;
  settings.limit_bytes = static_cast<std::uint64_t>(kBytes * cell.log->size_mb);
  settings.configuration = crc_text(cell.crc);
  settings.versions = {{"horopter", HOROPTER_VERSION}, {"engine", cell.engine}};
  return settings;
}

WebConfiguration web_configuration(const Cell& cell) {
  const auto colon = cell.web->listen.rfind(':');
  WebConfiguration web;
  web.title = cell.name;
  web.address = cell.web->listen.substr(0, colon);
  web.port = std::stoi(cell.web->listen.substr(colon + 1));
  web.users = cell.web->users_file;
  if (cell.web->tls) {
    web.certificate = cell.web->tls->certificate_file;
    web.key = cell.web->tls->key_file;
  }
  web.host_names = cell.web->names;
  web.teach_allowed = cell.teach.needed;
  web.teach_frames = cell.teach.frames;
  web.restart_allowed = cell.web->restart;
  web.decision_limit_ms = cell.decision_limit_ms;
  return web;
}

class LogAndPage final : public Part {
 public:
  LogAndPage(const Cell& cell, Control& control) {
    if (cell.log) log_.emplace(log_settings(cell));
    if (!cell.web) return;
    EventLog* log = log_ ? &*log_ : nullptr;
    page_.emplace(web_configuration(cell),
                  Web::Sources{&control, log, [&control] { return metrics(control.status()); }});
  }

  void judged(const MomentPtr& moment) override {
    if (log_) log_->judged(moment);
  }
  void stopped(const Status& status, const MomentPtr& moment) override {
    if (log_) log_->stopped(status, moment);
  }
  void released(const Status& status, const Actor& by) override {
    if (log_) log_->released(status, by);
  }
  void noted(const Status& status, const Actor& actor, const std::string& what) override {
    if (log_) log_->noted(status, actor, what);
  }
  /// A stop that nobody could explain later is not wanted: a full disk is a fault.
  [[nodiscard]] std::string trouble() const override {
    if (!log_) return {};
    const auto trouble = log_->trouble();
    return trouble ? trouble->text : std::string();
  }

 private:
  std::optional<EventLog> log_;
  std::optional<Web> page_;  // after the log, which it shows
};

}  // namespace

std::unique_ptr<Part> make_log_and_page(const Cell& cell, Control& control) {
  return std::make_unique<LogAndPage>(cell, control);
}

}  // namespace horopter::monitor
