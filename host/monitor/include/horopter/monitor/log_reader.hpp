// SPDX-License-Identifier: Apache-2.0
// Reads, checks and exports an event log, also while a monitor writes to it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace horopter::monitor {

struct LogReading {
  struct Picture {
    std::string name;
    std::string sha256;
    std::uint64_t bytes = 0;
  };
  struct Event {
    std::int64_t number = 0;
    std::string time;
    std::string kind;
    std::string text;
    nlohmann::ordered_json json;
    std::vector<Picture> pictures;
    std::vector<std::string> lines;  ///< of the journal that speak of it, as they are there
  };
  std::vector<Event> events;          ///< the oldest first
  std::vector<std::string> problems;  ///< what was changed, removed or damaged; a sentence each
  std::vector<std::string> notes;     ///< what is no problem: ends that were cut off by a kill
  bool in_use = false;                ///< a monitor writes to it
};

/// The chain is always checked; `pictures`: also each picture. Throws FileError where there is no log.
LogReading read_log(const std::filesystem::path& directory, bool pictures);

/// One event with its pictures, its lines of the journal and a page of text, as a new or empty directory or, where the
/// name ends in `.zip`, one file. Throws FileError: also where a picture is not as it was written.
void export_event(const std::filesystem::path& directory, const LogReading::Event& event,
                  const std::filesystem::path& out);

}  // namespace horopter::monitor
