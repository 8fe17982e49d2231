// SPDX-License-Identifier: Apache-2.0
// The event log: every stop with its causes and pictures, and what was done by whom; bounded, on disk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "horopter/monitor/state.hpp"

namespace horopter::monitor {

struct LogSettings {
  static constexpr std::uint64_t kSmallestLimit_bytes = 1'000'000;

  std::filesystem::path directory;
  std::uint64_t limit_bytes = 2'000'000'000;  ///< on disk; the oldest events go
  double before_s = 2;                        ///< pictures before a stop
  double after_s = 2;                         ///< and after it
  double pictures_per_s = 10;                 ///< at most; the pair that did it is always there
  std::size_t memory_bytes = 256'000'000;     ///< of pairs that wait; more are left out, and that is told
  double patience_s = 10;                     ///< an event is closed after so long without pairs
  double hang_s = 5;          ///< a disk that takes longer hangs; memory cards take a second or two now and then
  std::string configuration;  ///< checksum; every event carries it
  std::map<std::string, std::string> versions;
};

struct LogCounts {
  std::uint64_t written = 0;   ///< records, since the start
  std::uint64_t waiting = 0;   ///< records that are not yet on disk
  std::uint64_t lost = 0;      ///< records that never will be
  std::uint64_t pictures = 0;  ///< files
  std::uint64_t left_out = 0;  ///< pairs without pictures: the writer could not follow, or there was no room
  std::uint64_t failures = 0;  ///< of writing
  std::uint64_t bytes = 0;     ///< on disk
};

/// An event as it is listed.
struct LogEntry {
  std::int64_t number = 0;
  nlohmann::ordered_json json;        ///< as it was written
  std::vector<std::string> pictures;  ///< names, in the order of time
  bool complete = true;               ///< no more pictures will come
};

/// All calls are safe from any thread, and none waits for the disk but the constructor and the destructor.
class EventLog : public Listener {
 public:
  /// Opens the log, or makes it. Throws FileError.
  explicit EventLog(LogSettings settings);
  /// Writes what waits, and the end; without them where the disk hangs, which it says on standard error.
  ~EventLog() override;
  EventLog(const EventLog&) = delete;
  EventLog& operator=(const EventLog&) = delete;

  void judged(const MomentPtr& moment) override;
  void stopped(const Status& status, const MomentPtr& moment) override;
  void released(const Status& status, const Actor& by) override;
  void noted(const Status& status, const Actor& actor, const std::string& what) override;
  /// Anything else; `kind` is one word, as `login_refused`.
  void note(const std::string& kind, const Actor& actor, const std::string& what);

  /// What keeps it from writing; shown beside the causes.
  [[nodiscard]] std::optional<Cause> trouble() const;
  [[nodiscard]] LogCounts counts() const;
  /// The newest first: up to `count` with numbers below `before`. Of the last `kListed` events.
  [[nodiscard]] std::vector<LogEntry> entries(std::int64_t before, std::size_t count) const;
  [[nodiscard]] std::optional<LogEntry> entry(std::int64_t number) const;
  /// The file of a picture that the event has; nothing for any other name.
  [[nodiscard]] std::optional<std::filesystem::path> picture(std::int64_t number, const std::string& name) const;
  /// Until all that was given is on disk or lost. False after `wait`.
  bool flush(std::chrono::milliseconds wait);

  static constexpr std::size_t kListed = 500;

 private:
  class Writer;
  std::shared_ptr<Writer> writer_;
};

}  // namespace horopter::monitor
