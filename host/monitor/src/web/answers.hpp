// SPDX-License-Identifier: Apache-2.0
// What the page is told, as JSON and as a picture.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "horopter/monitor/event_log.hpp"
#include "horopter/monitor/state.hpp"
#include "log/status_json.hpp"

namespace horopter::monitor {

/// "safe" only where everything says so, and the decision is not older than the limit; else "alarm", "old", "not_safe".
std::string shown_state(const Status& status, std::optional<double> age_ms, double limit_ms);

Json status_json(const Status& status, std::optional<double> age_ms, double limit_ms);
/// As a line of the list.
Json entry_json(const LogEntry& entry);

/// The left image of the last pair, what was found coloured and numbered; made once for all who ask, and not too often.
class LivePicture {
 public:
  explicit LivePicture(double pictures_per_s) : period_(1 / pictures_per_s) {}

  struct Made {
    std::uint64_t frame = 0;
    Clock::time_point arrived{};
    std::string jpeg;
  };
  /// Null before the first pair.
  std::shared_ptr<const Made> get(const MomentPtr& latest);

 private:
  std::chrono::duration<double> period_;
  std::mutex mutex_;
  Clock::time_point made_at_{};
  std::shared_ptr<const Made> made_;
};

}  // namespace horopter::monitor
