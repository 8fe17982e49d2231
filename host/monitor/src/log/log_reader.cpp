// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/log_reader.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "horopter/base/error.hpp"
#include "horopter/base/json_text.hpp"
#include "journal.hpp"

namespace horopter::monitor {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExpected = "the directory of an event log";

bool is_locked(const fs::path& directory) {
  const Descriptor file(::open((directory / kLockName).c_str(), O_RDONLY | O_CLOEXEC));
  return file.valid() && ::flock(file.get(), LOCK_SH | LOCK_NB) != 0;
}

/// A segment that goes while it is read was removed by the monitor: then once more from the beginning.
std::vector<Segment> read_segments(const fs::path& directory) {
  constexpr int kTries = 5;
  for (int again = 1;; ++again) {
    std::vector<Segment> segments;
    try {
      for (const fs::path& path : segments_in(directory)) segments.push_back(read_segment(path));
      return segments;
    } catch (const FileError&) {
      if (again == kTries) throw;
    }
  }
}

class Check {
 public:
  Check(const fs::path& directory, LogReading& reading, std::vector<Segment>& segments)
      : directory_(directory), reading_(reading), segments_(segments) {
    for (const Segment& segment : segments_) {
      for (const Record& record : segment.records) {
        for (Removal& removal : removals_in(record)) removals_.push_back(std::move(removal));
        const auto torn = record.json.find("torn");
        if (torn != record.json.end() && torn->is_array()) torn_.insert(torn_.end(), torn->begin(), torn->end());
      }
    }
  }

  void segments() {
    for (const Segment& segment : segments_) {
      const std::string name = segment.path.filename().string();
      if (segment.damaged > 0) {
        reading_.problems.push_back(fmt::format("{}: {} lines are not as they were written.", name, segment.damaged));
      }
      if (segment.torn == 0) continue;
      const bool told = std::ranges::any_of(torn_, [&](const Json& entry) {
        return entry.is_object() && text_in(entry, "file") == name &&
               number_in(entry, "bytes") == static_cast<std::int64_t>(segment.torn);
      });
      const bool last = &segment == &segments_.back();
      (told || last ? reading_.notes : reading_.problems)
          .push_back(fmt::format("{}: the last {} bytes are no whole record{}.", name, segment.torn,
                                 told   ? "; the next start tells of it"
                                 : last ? ": writing was interrupted, or is going on"
                                        : ", and no later record tells of it"));
    }
  }

  void chain() {
    std::int64_t number = 0;
    std::string previous = kNoPrevious;
    for (const Segment& segment : segments_) {
      for (const Record& record : segment.records) {
        if (is_going(record.number)) continue;
        const bool follows = record.number == number + 1 && record.previous == previous;
        if (!follows && !was_removed(number + 1, record)) {
          reading_.problems.push_back(
              record.number > number + 1
                  ? fmt::format("Events {} to {} are missing, and no record tells that they were removed.", number + 1,
                                record.number - 1)
                  : fmt::format("Event {} does not follow the one before it: something was changed or removed.",
                                record.number));
        }
        number = record.number;
        previous = record.sha256;
      }
    }
  }

  void forget_going() {
    std::erase_if(reading_.events, [&](const LogReading::Event& event) { return is_going(event.number); });
  }

  void pictures() {
    std::set<fs::path> known;
    for (const LogReading::Event& event : reading_.events) {
      for (const LogReading::Picture& picture : event.pictures) {
        const fs::path path = pictures_of(directory_, event.number) / picture.name;
        known.insert(path);
        std::ifstream stream(path, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
        if (!stream) {
          reading_.problems.push_back(fmt::format("Event {}: {} is missing.", event.number, picture.name));
        } else if (sha256(bytes) != picture.sha256) {
          reading_.problems.push_back(
              fmt::format("Event {}: {} is not as it was written.", event.number, picture.name));
        }
      }
    }
    if (reading_.in_use) return;  // more may be on their way
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(directory_ / "pictures", error)) {
      if (entry.is_regular_file(error) && !is_partial(entry.path()) && !known.contains(entry.path())) {
        reading_.notes.push_back(fmt::format("{}: no record tells of this file; the next start takes it away.",
                                             fs::relative(entry.path(), directory_, error).string()));
      }
    }
  }

 private:
  /// A kill came between the record that tells a removal and its end; some of the files are still there.
  [[nodiscard]] bool is_going(std::int64_t number) const {
    return std::ranges::any_of(
        removals_, [&](const Removal& removal) { return number >= removal.first && number <= removal.last; });
  }
  /// All of them, from `first` up to the next one: told at once or piece by piece.
  [[nodiscard]] bool was_removed(std::int64_t first, const Record& next) const {
    std::int64_t begin = next.number;  // from here on it is told
    const auto goes_on = [&](const Removal& removal) {
      return removal.first < begin && removal.last >= begin - 1 &&
             (begin < next.number || removal.sha256 == next.previous);
    };
    while (begin > first) {
      const auto found = std::ranges::find_if(removals_, goes_on);
      if (found == removals_.end()) return false;
      begin = found->first;
    }
    return begin < next.number;
  }

  const fs::path& directory_;
  LogReading& reading_;
  std::vector<Segment>& segments_;
  std::vector<Removal> removals_;
  std::vector<Json> torn_;
};

/// A name that leads nowhere else.
bool is_plain(const std::string& name) {
  return !name.empty() && name.front() != '.' && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.';
  });
}

void add_pictures(LogReading::Event& event, const Json& record) {
  const auto files = record.find("files");
  if (files == record.end() || !files->is_array()) return;
  for (const Json& file : *files) {
    if (!file.is_object() || !is_plain(text_in(file, "name"))) continue;
    event.pictures.push_back({text_in(file, "name"), text_in(file, "sha256"),
                              static_cast<std::uint64_t>(std::max<std::int64_t>(0, number_in(file, "bytes")))});
  }
}

}  // namespace

LogReading read_log(const fs::path& directory, bool pictures) {
  std::error_code error;
  if (!fs::is_directory(directory, error)) {
    throw FileError(directory.string(), "", "there is no such directory", kExpected);
  }
  if (!fs::exists(directory / kLockName, error)) {
    throw FileError(directory.string(), "", "this is no event log", kExpected);
  }
  LogReading reading;
  reading.in_use = is_locked(directory);
  std::vector<Segment> segments = read_segments(directory);
  std::map<std::int64_t, std::size_t> places;
  for (const Segment& segment : segments) {
    for (const Record& record : segment.records) {
      const std::string kind = text_in(record.json, "kind");
      const std::string line = record.sha256 + " " + json_line(record.json);
      if (kind == kPicturesKind) {
        const auto place = places.find(number_in(record.json, "event"));
        if (place == places.end()) continue;  // it was removed
        add_pictures(reading.events[place->second], record.json);
        reading.events[place->second].lines.push_back(line);
        continue;
      }
      places[record.number] = reading.events.size();
      reading.events.push_back({.number = record.number,
                                .time = text_in(record.json, "time"),
                                .kind = kind,
                                .text = text_in(record.json, "text"),
                                .json = record.json,
                                .pictures = {},
                                .lines = {line}});
    }
  }
  Check check(directory, reading, segments);
  check.segments();
  check.chain();
  check.forget_going();
  if (pictures) check.pictures();
  return reading;
}

}  // namespace horopter::monitor
