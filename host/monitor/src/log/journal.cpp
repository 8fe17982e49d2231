// SPDX-License-Identifier: Apache-2.0
#include "journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

#include "horopter/base/error.hpp"
#include "horopter/base/json_text.hpp"

namespace horopter::monitor {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kChecksum = 64;
constexpr std::uint64_t kSegmentBytes = 64 * 1024;
constexpr off_t kReserveBytes = 256 * 1024;  // of records when the disk is full
constexpr const char* kPrefix = "events-";
constexpr const char* kPictures = "pictures";

std::optional<std::int64_t> whole_number(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc{} || end != text.data() + text.size() || number < 0) return std::nullopt;
  return number;
}

/// `events-NUMBER.jsonl`, or with `.N` before the ending where that was taken.
std::optional<std::pair<std::int64_t, std::int64_t>> order_of(const fs::path& path) {
  const std::string name = path.filename().string();
  if (!name.starts_with(kPrefix) || path.extension() != ".jsonl") return std::nullopt;
  const std::string stem = path.stem().string().substr(std::strlen(kPrefix));
  const auto dot = stem.find('.');
  const auto first = whole_number(stem.substr(0, dot));
  const auto again = dot == std::string::npos ? 0 : whole_number(stem.substr(dot + 1));
  if (!first || !again) return std::nullopt;
  return std::pair{*first, *again};
}

std::optional<Record> parse_line(std::string_view line) {
  if (line.size() < kChecksum + 2 || line[kChecksum] != ' ') return std::nullopt;
  const std::string_view text = line.substr(kChecksum + 1);
  Record record;
  record.sha256 = line.substr(0, kChecksum);
  if (sha256(text) != record.sha256) return std::nullopt;
  record.json = Json::parse(text, nullptr, false);
  if (!record.json.is_object()) return std::nullopt;
  record.number = number_in(record.json, "number");
  record.previous = text_in(record.json, "previous");
  if (record.number < 1) return std::nullopt;
  return record;
}

/// The event of which the record has pictures, or 0.
std::int64_t pictures_in(const Record& record) {
  return text_in(record.json, "kind") == kPicturesKind ? number_in(record.json, "event") : 0;
}

std::uint64_t size_of(const fs::path& path) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  return error ? 0 : size;
}

}  // namespace

bool is_segment(const fs::path& path) { return order_of(path).has_value(); }

std::vector<fs::path> segments_in(const fs::path& directory) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    if (is_segment(entry.path())) found.push_back(entry.path());
  }
  std::ranges::sort(found, {}, [](const fs::path& path) { return *order_of(path); });
  return found;
}

fs::path pictures_of(const fs::path& directory, std::int64_t number) {
  return directory / kPictures / fmt::format("{:012}", number);
}

Segment read_segment(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw FileError(path.string(), "", "the file cannot be read", "a part of an event log");
  Segment segment{.path = path, .records = {}, .bytes = text.size(), .damaged = 0, .torn = 0};
  std::size_t begin = 0;
  while (begin < text.size()) {
    const auto end = text.find('\n', begin);
    if (end == std::string::npos) break;
    if (auto record = parse_line(std::string_view(text).substr(begin, end - begin))) {
      segment.records.push_back(std::move(*record));
    } else {
      ++segment.damaged;
    }
    begin = end + 1;
  }
  segment.torn = text.size() - begin;
  return segment;
}

std::vector<Removal> removals_in(const Record& record) {
  if (text_in(record.json, "kind") != "removed") return {};
  const auto one = [](const Json& json) {
    return Removal{number_in(json, "first"), number_in(json, "last"), text_in(json, "sha256")};
  };
  std::vector<Removal> removals{one(record.json)};
  if (const auto earlier = record.json.find("earlier"); earlier != record.json.end() && earlier->is_array()) {
    for (const Json& entry : *earlier) {
      if (entry.is_object()) removals.push_back(one(entry));
    }
  }
  return removals;
}

Journal::Journal(const fs::path& directory, std::uint64_t limit_bytes)
    : directory_(directory), limit_bytes_(limit_bytes) {
  std::error_code error;
  fs::create_directories(directory_ / kPictures, error);
  if (error) {
    throw FileError(directory_.string(), "", "the directory of the event log cannot be made (" + error.message() + ")",
                    "a writable place");
  }
  const fs::path lock = directory_ / kLockName;
  lock_.reset(::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0640));
  if (!lock_.valid()) {
    throw FileError(lock.string(), "", fmt::format("the file cannot be written ({})", std::strerror(errno)),
                    "a directory that this user may write to");
  }
  if (::flock(lock_.get(), LOCK_EX | LOCK_NB) != 0) {
    throw FileError(directory_.string(), "", "another process writes to this event log", "one monitor for each log");
  }
  remove_leftovers();
  read();
  fill_reserve();
}

/// Files that were not complete, and segments without anything.
void Journal::remove_leftovers() {
  std::vector<fs::path> leftovers;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(directory_, error)) {
    if (entry.is_regular_file(error) && is_partial(entry.path())) leftovers.push_back(entry.path());
  }
  for (const fs::path& path : segments_in(directory_)) {
    if (size_of(path) == 0) leftovers.push_back(path);
  }
  for (const fs::path& path : leftovers) opened_.leftovers += fs::remove(path, error) ? 1 : 0;
}

void Journal::take_tellings(Part& part, const Record& record) {
  for (Removal& removal : removals_in(record)) part.removals.push_back(std::move(removal));
  if (const auto torn = record.json.find("torn"); torn != record.json.end() && torn->is_array()) {
    part.torn.insert(part.torn.end(), torn->begin(), torn->end());
  }
}

void Journal::read() {
  std::vector<Removal> removals;
  Json known = Json::array();  // torn ends that were told
  for (const fs::path& path : segments_in(directory_)) {
    Segment segment = read_segment(path);
    if (segment.torn > 0 || segment.damaged > 0) {
      opened_.torn.push_back({{"file", path.filename().string()}, {"bytes", segment.torn}, {"lines", segment.damaged}});
    }
    Part part{.path = path, .first = order_of(path)->first, .last = 0, .sha256 = previous_, .bytes = segment.bytes};
    part.last = part.first - 1;
    for (Record& record : segment.records) {
      take_tellings(part, record);
      part.group = part.group || text_in(record.json, "kind") == kStop;
      part.pictures_of = std::max(part.pictures_of, pictures_in(record));
      part.last = record.number;
      part.sha256 = record.sha256;
      next_ = record.number + 1;
      previous_ = record.sha256;
      opened_.records.push_back(std::move(record));
    }
    removals.insert(removals.end(), part.removals.begin(), part.removals.end());
    known.insert(known.end(), part.torn.begin(), part.torn.end());
    parts_.push_back(std::move(part));
  }
  Json news = Json::array();
  for (const Json& entry : opened_.torn) {
    if (std::ranges::find(known, entry) == known.end()) news.push_back(entry);
  }
  opened_.torn = news;

  // A kill came between the record that tells a removal and the removal.
  for (const Removal& removal : removals) {
    const auto gone = [&](const Part& part) {
      return part.first >= removal.first && part.last <= removal.last && part.last >= part.first;
    };
    for (const Part& part : parts_) {
      if (!gone(part)) continue;
      remove(part);
      ++opened_.leftovers;
    }
    std::erase_if(parts_, gone);
    std::erase_if(opened_.records, [&](const Record& record) {
      return record.number >= removal.first && record.number <= removal.last;
    });
  }

  for (const Part& part : parts_) bytes_ += part.bytes;

  // Pictures of which no record tells: a kill came between them and the record.
  std::vector<std::pair<std::int64_t, std::string>> told;
  for (const Record& record : opened_.records) {
    if (pictures_in(record) == 0) continue;
    const auto files = record.json.find("files");
    if (files == record.json.end() || !files->is_array()) continue;
    for (const Json& file : *files) {
      if (file.is_object()) told.emplace_back(number_in(record.json, "event"), text_in(file, "name"));
    }
  }
  std::ranges::sort(told);
  std::error_code error;
  std::vector<fs::path> folders;
  for (const auto& folder : fs::directory_iterator(directory_ / kPictures, error)) folders.push_back(folder.path());
  for (const fs::path& folder : folders) {
    const auto number = whole_number(folder.filename().string());
    if (!number) continue;
    std::vector<fs::path> files;
    for (const auto& file : fs::directory_iterator(folder, error)) files.push_back(file.path());
    for (const fs::path& file : files) {
      if (std::ranges::binary_search(told, std::pair{*number, file.filename().string()})) {
        bytes_ += size_of(file);
      } else {
        opened_.leftovers += fs::remove(file, error) ? 1 : 0;
      }
    }
    fs::remove(folder, error);  // where it is empty
  }
}

void Journal::fill_reserve() {
  const fs::path path = directory_ / kReserveName;
  if (std::error_code error; fs::file_size(path, error) == static_cast<std::uintmax_t>(kReserveBytes) && !error) {
    reserve_ = true;
    return;
  }
  struct statvfs space{};
  if (::statvfs(directory_.c_str(), &space) != 0) return;
  if (space.f_bavail * space.f_frsize < 4 * static_cast<std::uint64_t>(kReserveBytes)) return;
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0640));
  reserve_ = file.valid() && ::posix_fallocate(file.get(), 0, kReserveBytes) == 0;
  if (!reserve_) ::unlink(path.c_str());
}

int Journal::check_disk() {
  if (!reserve_) fill_reserve();
  struct statvfs space{};
  if (::statvfs(directory_.c_str(), &space) != 0) return errno;
  const bool room = space.f_bavail * space.f_frsize >= static_cast<std::uint64_t>(kReserveBytes);
  return reserve_ && room ? 0 : ENOSPC;
}

int Journal::begin_segment() {
  file_.reset();
  constexpr int kTries = 1000;
  for (int again = 0; again < kTries; ++again) {
    const fs::path path = directory_ / (again == 0 ? fmt::format("{}{:012}.jsonl", kPrefix, next_)
                                                   : fmt::format("{}{:012}.{}.jsonl", kPrefix, next_, again));
    file_.reset(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0640));
    if (!file_.valid() && errno == EEXIST) continue;
    if (!file_.valid()) return errno;
    sync_directory(directory_);
    parts_.push_back({.path = path, .first = next_, .last = next_ - 1, .sha256 = previous_});
    return 0;
  }
  return EEXIST;
}

/// The whole line, or nothing of it.
int Journal::write_line(const std::string& line) {
  Part& part = parts_.back();
  int problem = write_all(file_.get(), line);
  if (problem == 0 && ::fdatasync(file_.get()) != 0) problem = errno;
  if (problem == 0) {
    part.bytes += line.size();
    bytes_ += line.size();
    return 0;
  }
  // What a failed write left is cut off; where even that fails, the next record tells of it.
  const bool cut = ::ftruncate(file_.get(), static_cast<off_t>(part.bytes)) == 0;
  if (!cut) {
    const auto left = size_of(part.path);
    if (left > part.bytes) {
      opened_.torn.push_back({{"file", part.path.filename().string()}, {"bytes", left - part.bytes}, {"lines", 0}});
    }
  }
  file_.reset();
  if (part.bytes == 0 && ::unlink(part.path.c_str()) == 0) parts_.pop_back();
  return problem;
}

int Journal::append(Json record, bool group, Record& written) {
  Json full{{"number", next_}, {"previous", previous_}};
  full.update(record);
  if (!opened_.torn.empty()) full["torn"] = opened_.torn;
  const std::string text = json_line(full);
  const std::string checksum = sha256(text);
  const std::string line = checksum + " " + text + "\n";
  int problem = 0;
  for (const bool last_try : {false, true}) {
    const bool fresh = !file_.valid() || (group && parts_.back().bytes > 0) || parts_.back().bytes > kSegmentBytes;
    problem = fresh ? begin_segment() : 0;
    if (problem == 0) problem = write_line(line);
    if (problem != ENOSPC && problem != EDQUOT) break;
    if (last_try || !reserve_) break;
    ::unlink((directory_ / kReserveName).c_str());
    reserve_ = false;
  }
  if (problem != 0) return problem;
  if (!reserve_) fill_reserve();
  opened_.torn = Json::array();
  Part& part = parts_.back();
  written = {.number = next_, .sha256 = checksum, .previous = previous_, .json = std::move(full)};
  part.group = part.group || group;
  part.pictures_of = std::max(part.pictures_of, pictures_in(written));
  take_tellings(part, written);
  part.last = next_;
  part.sha256 = checksum;
  ++next_;
  previous_ = checksum;
  return 0;
}

int Journal::write_picture(std::int64_t event, const std::string& name, std::span<const std::uint8_t> bytes) {
  // What was kept for records is for records.
  if (!reserve_) fill_reserve();
  if (!reserve_) return ENOSPC;
  const fs::path folder = pictures_of(directory_, event);
  std::error_code error;
  if (fs::create_directories(folder, error)) sync_directory(folder.parent_path());
  if (error) return error.value();
  const int problem = write_durably(folder / name, bytes);
  if (problem == 0) bytes_ += bytes.size();
  return problem;
}

bool Journal::holds(std::int64_t number) const {
  return std::ranges::any_of(parts_, [&](const Part& part) { return number >= part.first && number <= part.last; });
}

std::uint64_t Journal::picture_bytes(const Part& part) const {
  std::uint64_t bytes = 0;
  std::error_code error;
  for (std::int64_t number = part.first; number <= part.last; ++number) {
    for (const auto& file : fs::directory_iterator(pictures_of(directory_, number), error)) {
      bytes += size_of(file.path());
    }
  }
  return bytes;
}

/// Pictures first: a kill in between leaves the record that they belong to.
void Journal::remove(const Part& part) {
  std::error_code error;
  for (std::int64_t number = part.first; number <= part.last; ++number) {
    fs::remove_all(pictures_of(directory_, number), error);
  }
  fs::remove(part.path, error);
}

/// What the parts that are going tell of those that stay must be told again: which records before one of them were removed,
/// as an array, and, with the next record, whose end is torn.
Json Journal::still_told(std::span<const Part> going) {
  Json earlier = Json::array();
  const auto stays = [&](const auto& is_it) {
    return std::ranges::any_of(parts_, [&](const Part& part) {
      return is_it(part) && std::ranges::find(going, part.path, &Part::path) == going.end();
    });
  };
  for (const Part& part : going) {
    for (const Removal& removal : part.removals) {
      if (!stays([&](const Part& other) { return other.first == removal.last + 1; })) continue;
      earlier.push_back({{"first", removal.first}, {"last", removal.last}, {"sha256", removal.sha256}});
    }
    for (const Json& entry : part.torn) {
      if (!entry.is_object()) continue;
      const std::string file = text_in(entry, "file");
      if (stays([&](const Part& other) { return other.path.filename() == file; })) opened_.torn.push_back(entry);
    }
  }
  return earlier;
}

/// With what was removed right behind it: who told of that may go before the next record that stays.
Removal Journal::with_neighbours(Removal removal) const {
  for (const Part& part : parts_) {
    for (const Removal& told : part.removals) {
      if (told.first > removal.last + 1 || told.last <= removal.last) continue;
      removal.last = told.last;
      removal.sha256 = told.sha256;
    }
  }
  return removal;
}

bool Journal::make_room(std::uint64_t bytes) {
  if (bytes_ + bytes <= limit_bytes_) return true;
  if (removing_) return false;
  removing_ = true;
  // The last group, what tells of its pictures, and what is being written stay.
  const auto last_group = std::find_if(parts_.rbegin(), parts_.rend(), [](const Part& part) { return part.group; });
  const auto kept = last_group == parts_.rend() ? std::numeric_limits<std::int64_t>::max() : last_group->first;
  const std::uint64_t aim = limit_bytes_ - limit_bytes_ / 16;
  std::size_t begin = 0;
  while (bytes_ + bytes > limit_bytes_) {
    const auto may_go = [&](std::size_t i) {
      return i + 1 < parts_.size() && parts_[i].first != kept && parts_[i].pictures_of < kept;
    };
    while (begin < parts_.size() && !may_go(begin)) ++begin;
    if (begin >= parts_.size()) break;
    // A row of them, as far as is needed.
    std::size_t end = begin;
    std::uint64_t freed = 0;
    while (end < parts_.size() && may_go(end) && bytes_ + bytes > aim + freed) {
      freed += parts_[end].bytes + picture_bytes(parts_[end]);
      ++end;
    }
    const std::vector<Part> row(parts_.begin() + static_cast<std::ptrdiff_t>(begin),
                                parts_.begin() + static_cast<std::ptrdiff_t>(end));
    Record told;
    const Removal all =
        with_neighbours({begin == 0 ? 1 : parts_[begin - 1].last + 1, row.back().last, row.back().sha256});
    Json removed{
        {"kind", "removed"},
        {"text", fmt::format("The oldest events, {} to {}, were removed: the log is full.", all.first, all.last)},
        {"first", all.first},
        {"last", all.last},
        {"sha256", all.sha256}};
    if (Json earlier = still_told(row); !earlier.empty()) removed["earlier"] = std::move(earlier);
    if (append(std::move(removed), false, told) != 0) break;
    for (const Part& part : row) {
      bytes_ -= std::min(bytes_, part.bytes + picture_bytes(part));
      remove(part);
    }
    std::erase_if(parts_, [&](const Part& part) {
      return std::ranges::any_of(row, [&](const Part& gone) { return gone.path == part.path; });
    });
  }
  removing_ = false;
  return bytes_ + bytes <= limit_bytes_;
}

}  // namespace horopter::monitor
