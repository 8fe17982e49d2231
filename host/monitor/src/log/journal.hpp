// SPDX-License-Identifier: Apache-2.0
// The journal of the event log: records in segments, each record with the checksum of the one before.
//
// A line is `SHA256 JSON`: the checksum is that of the JSON's bytes. In the JSON `number` counts from 1, and `previous`
// is the checksum of the record before. A file that was written before a start is never written to again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durable.hpp"
#include "status_json.hpp"

namespace horopter::monitor {

struct Record {
  std::int64_t number = 0;
  std::string sha256;
  std::string previous;
  Json json;
};

/// A file of the journal. Every group of events is in one: it goes as a whole.
struct Segment {
  std::filesystem::path path;
  std::vector<Record> records;  ///< those that are as they were written
  std::size_t bytes = 0;
  std::size_t damaged = 0;  ///< whole lines that are not
  std::size_t torn = 0;     ///< bytes after the last whole line
};

Segment read_segment(const std::filesystem::path& path);
/// In the order of their numbers.
std::vector<std::filesystem::path> segments_in(const std::filesystem::path& directory);
bool is_segment(const std::filesystem::path& path);
std::filesystem::path pictures_of(const std::filesystem::path& directory, std::int64_t number);
/// The records from first to last were removed on purpose; the last one had this checksum.
struct Removal {
  std::int64_t first = 0;
  std::int64_t last = 0;
  std::string sha256;
};
/// What the record tells to be removed: now, and what a record told that goes with it.
std::vector<Removal> removals_in(const Record& record);

inline const std::string kNoPrevious(64, '0');
// Kinds of records that more than one part knows.
inline constexpr const char* kStop = "stop";
inline constexpr const char* kPicturesKind = "pictures";
inline constexpr const char* kEnd = "end";
inline constexpr const char* kLockName = "lock";
inline constexpr const char* kReserveName = "reserve";

/// Writes. One thread at a time.
class Journal {
 public:
  /// Makes or opens it, takes leftovers away, and reads what is there. Throws FileError: also where another process
  /// writes to it.
  Journal(const std::filesystem::path& directory, std::uint64_t limit_bytes);

  struct Opened {
    std::vector<Record> records;  ///< all that are there
    Json torn = Json::array();    ///< what the next record must tell
    int leftovers = 0;            ///< files that were taken away
  };
  Opened& opened() { return opened_; }

  /// Adds number and chain. `group`: begins a new one, which stays until the next of them. 0, or the number of the
  /// error: the record is not there then.
  int append(Json record, bool group, Record& written);
  /// A picture of an event. 0, or the number of the error.
  int write_picture(std::int64_t event, const std::string& name, std::span<const std::uint8_t> bytes);
  /// 0 where the disk takes an event; else the number of the error.
  int check_disk();
  /// Whether so much more would still be within the limit, after the oldest have gone.
  bool make_room(std::uint64_t bytes);

  /// Whether the event is still there.
  [[nodiscard]] bool holds(std::int64_t number) const;
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

 private:
  struct Part {
    std::filesystem::path path;
    std::int64_t first = 0;
    std::int64_t last = 0;
    std::string sha256;  ///< of the last
    std::uint64_t bytes = 0;
    bool group = false;
    std::int64_t pictures_of = 0;     ///< the last event of which it has pictures
    std::vector<Removal> removals{};  ///< that it tells of
    Json torn = Json::array();        ///< torn ends that it tells of
  };
  static void take_tellings(Part& part, const Record& record);
  [[nodiscard]] Json still_told(std::span<const Part> going);
  [[nodiscard]] Removal with_neighbours(Removal removal) const;

  void read();
  void remove_leftovers();
  void remove(const Part& part);
  [[nodiscard]] std::uint64_t picture_bytes(const Part& part) const;
  int begin_segment();
  int write_line(const std::string& line);
  void fill_reserve();

  std::filesystem::path directory_;
  std::uint64_t limit_bytes_;
  Descriptor lock_;
  Descriptor file_;  ///< the last of `parts_`, while it may be written to
  std::vector<Part> parts_;
  std::uint64_t bytes_ = 0;
  std::int64_t next_ = 1;
  std::string previous_ = kNoPrevious;
  bool reserve_ = false;
  bool removing_ = false;
  Opened opened_;
};

}  // namespace horopter::monitor
