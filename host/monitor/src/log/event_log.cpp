// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/event_log.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <cstdio>
#include <cstring>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

#include "horopter/base/error.hpp"
#include "journal.hpp"
#include "pictures.hpp"
#include "record.hpp"

namespace horopter::monitor {
namespace {

using std::chrono::milliseconds;

constexpr std::size_t kWaitingRecords = 1000;
constexpr std::size_t kMostEvicted = 16;
constexpr std::size_t kMomentsTogether = 10;  // whose pictures one record tells of
constexpr std::uint64_t kRecordRoom_bytes = 16'384;
constexpr auto kRetry = milliseconds(500);
constexpr auto kTick = milliseconds(50);
constexpr auto kLookAtDisk = milliseconds(50);
constexpr int kNice = 10;  // the decision goes first

Clock::duration seconds(double value) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(value));
}

/// A stop while its pictures are gathered.
struct Event {
  std::int64_t number = 0;  ///< 0 until it is on disk
  Clock::time_point at;
  Clock::time_point last_news;
  bool closed = false;
  std::size_t waiting = 0;  ///< pairs that are not yet written
  std::uint64_t left_out = 0;
  std::string why;
  Json files = Json::array();  ///< of which no record tells yet
  std::size_t moments = 0;     ///< of these
  bool first_told = false;
  std::shared_ptr<Event> earlier;  ///< has the pictures before
  std::shared_ptr<Event> later;    ///< has the pictures after
};
using EventPtr = std::shared_ptr<Event>;

struct RecordJob {
  Json json;
  std::optional<Status> status;  ///< of a stop: put in words by the writer
  bool has_moment = false;
  EventPtr event;  ///< that becomes this record
};

struct PictureJob {
  MomentPtr moment;
  EventPtr event;
  std::size_t bytes = 0;
};

struct Kept {
  MomentPtr moment;
  std::size_t bytes = 0;
  EventPtr given;
};

}  // namespace

class EventLog::Writer {
 public:
  explicit Writer(LogSettings settings) : settings_(check(std::move(settings))), journal_(open_journal()) {
    list_opened();
    push_start();
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Its thread holds it, too: it may have to be left to a disk that hangs.
  static std::shared_ptr<Writer> start(LogSettings settings) {
    auto writer = std::make_shared<Writer>(std::move(settings));
    writer->thread_ = std::thread([writer] { writer->run(); });
    return writer;
  }

  /// The last call. False: the disk hangs, and what waits is not written.
  bool end() {
    std::unique_lock lock(mutex_);
    close_event();
    ending_ = true;
    wake_.notify_all();
    while (!done_ && !hangs()) idle_.wait_for(lock, kTick);
    const bool done = done_;
    lock.unlock();
    if (done) {
      thread_.join();
    } else {
      thread_.detach();
    }
    return done;
  }

  void judged(const MomentPtr& moment) {
    if (!moment) return;
    const std::size_t bytes = bytes_of(*moment);
    const std::lock_guard lock(mutex_);
    if (!ring_.empty() && ring_.back().moment == moment) return;
    const auto at = moment->arrived;
    if (collecting_) collecting_->last_news = Clock::now();
    if (collecting_ && at > collecting_->at + seconds(settings_.after_s)) close_event();
    if (at < next_picture_ && at > next_picture_ - seconds(2 / settings_.pictures_per_s)) return;
    next_picture_ += seconds(1 / settings_.pictures_per_s);
    if (next_picture_ <= at || next_picture_ > at + seconds(1 / settings_.pictures_per_s)) {
      next_picture_ = at + seconds(1 / settings_.pictures_per_s);
    }
    keep(moment, bytes);
    if (collecting_) give(ring_.back(), collecting_);
    wake_.notify_one();
  }

  void stopped(const Status& status, const MomentPtr& moment) {
    const std::size_t bytes = moment ? bytes_of(*moment) : 0;
    const std::lock_guard lock(mutex_);
    auto event = std::make_shared<Event>();
    event->last_news = Clock::now();
    event->at = moment ? moment->arrived : event->last_news;
    if (collecting_) {
      event->earlier = collecting_;
      collecting_->later = event;
      close_event();
    }
    if (!push({.json = {{"kind", kStop}}, .status = status, .has_moment = moment != nullptr, .event = event})) return;
    collecting_ = event;
    events_.push_back(event);
    // The pair that did it first: a kill may come. Then the others, the nearest first.
    if (moment && (ring_.empty() || ring_.back().moment != moment)) keep(moment, bytes);
    for (auto kept = ring_.rbegin(); kept != ring_.rend(); ++kept) {
      if (event->at - kept->moment->arrived > seconds(settings_.before_s)) break;
      if (kept->given) {
        event->earlier = kept->given;
      } else {
        give(*kept, event);
      }
    }
    wake_.notify_one();
  }

  void note(const std::string& kind, Time time, const Actor& actor, const std::string& what) {
    const std::lock_guard lock(mutex_);
    push(job({{"kind", kind}, {"time", time_text(time)}, {"text", what}, {"by", actor_json(actor)}}));
    wake_.notify_one();
  }

  std::optional<Cause> trouble() const {
    const std::lock_guard lock(mutex_);
    const std::string of_records = problem_of_records();
    const std::string& problem = of_records.empty() ? picture_problem_ : of_records;
    if (problem.empty()) return std::nullopt;
    std::string text =
        of_records.empty() ? "Pictures of the event log cannot be written: " : "The event log cannot be written: ";
    text += problem + ".";
    if (!of_records.empty()) text += fmt::format(" {} events wait, {} were lost.", records_.size(), counts_.lost);
    return Cause{.name = "log",
                 .text = text,
                 .advice = fmt::format("Make room on the disk that has {}, or look whether it works.",
                                       settings_.directory.string())};
  }

  LogCounts counts() const {
    const std::lock_guard lock(mutex_);
    LogCounts counts = counts_;
    counts.waiting = records_.size();
    return counts;
  }

  std::vector<LogEntry> entries(std::int64_t before, std::size_t count) const {
    const std::lock_guard lock(mutex_);
    std::vector<LogEntry> found;
    for (auto entry = listed_.rbegin(); entry != listed_.rend() && found.size() < count; ++entry) {
      if (entry->number < before) found.push_back(*entry);
    }
    return found;
  }

  std::optional<LogEntry> entry(std::int64_t number) const {
    const std::lock_guard lock(mutex_);
    for (const LogEntry& listed : listed_) {
      if (listed.number == number) return listed;
    }
    return std::nullopt;
  }

  std::optional<std::filesystem::path> picture(std::int64_t number, const std::string& name) const {
    const auto found = entry(number);
    if (!found || std::ranges::find(found->pictures, name) == found->pictures.end()) return std::nullopt;
    return pictures_of(settings_.directory, number) / name;
  }

  bool flush(milliseconds wait) {
    std::unique_lock lock(mutex_);
    flushing_ = true;
    wake_.notify_all();
    const bool done = idle_.wait_for(lock, wait, [&] { return is_idle(); });
    flushing_ = false;
    return done;
  }

 private:
  static LogSettings check(LogSettings settings) {
    if (settings.limit_bytes < LogSettings::kSmallestLimit_bytes) {
      throw UsageError(fmt::format("the event log's limit is {} bytes; expected at least {}", settings.limit_bytes,
                                   LogSettings::kSmallestLimit_bytes));
    }
    if (!(settings.before_s >= 0 && settings.before_s <= 60 && settings.after_s >= 0 && settings.after_s <= 60 &&
          settings.pictures_per_s > 0 && settings.pictures_per_s <= 1000)) {
      throw UsageError("the event log's pictures: expected 0 to 60 s before and after, and up to 1000 pairs a second");
    }
    begin_sodium();
    return settings;
  }
  Journal open_journal() const { return {settings_.directory, settings_.limit_bytes}; }
  static std::string now() { return time_text(std::chrono::system_clock::now()); }
  static RecordJob job(Json json) {
    return {.json = std::move(json), .status = {}, .has_moment = false, .event = nullptr};
  }

  void list_opened() {
    const auto& records = journal_.opened().records;
    for (const Record& record : records) list(record);
    for (LogEntry& entry : listed_) entry.complete = true;  // nobody gathers these any more
    counts_.bytes = journal_.bytes();
  }

  void push_start() {
    const auto& opened = journal_.opened();
    const bool first = opened.records.empty();
    const bool ended = !first && text_in(opened.records.back().json, "kind") == kEnd;
    std::string text = "The monitor started.";
    if (!first && !ended) text += " It had not ended before: it was killed, or the power failed.";
    if (!opened.torn.empty()) text += " The end of the log was not complete.";
    Json versions = Json::object();
    for (const auto& [name, version] : settings_.versions) versions[name] = version;
    records_.push_back(job({{"kind", "start"},
                            {"time", now()},
                            {"text", text},
                            {"versions", versions},
                            {"ended_before", first || ended},
                            {"leftovers", opened.leftovers}}));
    journal_.opened().records.clear();
  }

  // Below: with the mutex.

  void keep(const MomentPtr& moment, std::size_t bytes) {
    ring_.push_back({.moment = moment, .bytes = bytes, .given = nullptr});
    ring_bytes_ += bytes;
    const auto oldest = moment->arrived - seconds(settings_.before_s);
    while (ring_.size() > 1 && (ring_.front().moment->arrived < oldest || ring_bytes_ > settings_.memory_bytes / 2)) {
      ring_bytes_ -= ring_.front().bytes;
      // The writer gives their memory back, unless it is held up.
      if (evicted_.size() < kMostEvicted) evicted_.push_back(std::move(ring_.front().moment));
      ring_.pop_front();
    }
  }

  void give(Kept& kept, const EventPtr& event) {
    kept.given = event;
    if (waiting_bytes_ + kept.bytes > settings_.memory_bytes / 2) {
      ++event->left_out;
      ++counts_.left_out;
      event->why = "they came faster than they could be written";
      return;
    }
    waiting_bytes_ += kept.bytes;
    ++event->waiting;
    pictures_.push_back({.moment = kept.moment, .event = event, .bytes = kept.bytes});
  }

  void close_event() {
    if (!collecting_) return;
    collecting_->closed = true;
    collecting_.reset();
  }

  bool push(RecordJob record) {
    if (records_.size() >= kWaitingRecords) {
      ++counts_.lost;
      return false;
    }
    records_.push_back(std::move(record));
    return true;
  }

  void list(const Record& record) {
    if (text_in(record.json, "kind") != kPicturesKind) {
      const bool complete = text_in(record.json, "kind") != kStop;
      listed_.push_back({.number = record.number, .json = record.json, .pictures = {}, .complete = complete});
      if (listed_.size() > kListed) listed_.pop_front();
      return;
    }
    const auto event = number_in(record.json, "event");
    const auto entry = std::ranges::find(listed_, event, &LogEntry::number);
    if (entry == listed_.end()) return;
    entry->complete = record.json.value("complete", false);
    const auto files = record.json.find("files");
    if (files == record.json.end() || !files->is_array()) return;
    for (const Json& file : *files) {
      if (file.is_object()) entry->pictures.push_back(text_in(file, "name"));
    }
    std::ranges::sort(entry->pictures);  // frame by frame
  }

  bool hangs() const { return disk_asked_ && Clock::now() - *disk_asked_ > seconds(settings_.hang_s); }

  std::string problem_of_records() const {
    if (!record_problem_.empty()) return record_problem_;
    if (hangs()) return "its disk does not answer";
    return counts_.lost > lost_told_ ? "its disk is too slow" : "";
  }

  bool is_idle() const {
    return records_.empty() && pictures_.empty() && !busy_ &&
           std::ranges::none_of(events_, [](const EventPtr& event) { return !event->files.empty() || event->closed; });
  }

  /// Says what pictures an event has got.
  void tell_pictures(Event& event) {
    Json json{{"kind", kPicturesKind},
              {"time", now()},
              {"text", fmt::format("Pictures of event {}.", event.number)},
              {"event", event.number},
              {"files", std::exchange(event.files, Json::array())},
              {"complete", event.closed && event.waiting == 0},
              {"left_out", event.left_out}};
    if (event.left_out > 0) json["why"] = event.why;
    if (event.earlier && event.earlier->number != 0) json["earlier_in"] = event.earlier->number;
    if (event.later && event.later->number != 0) json["continued_in"] = event.later->number;
    records_.push_back(job(std::move(json)));  // bounded by the events
    event.moments = 0;
    event.first_told = true;
  }

  void tell_events() {
    if (collecting_ && Clock::now() > collecting_->last_news + seconds(settings_.patience_s)) close_event();
    for (const EventPtr& event : events_) {
      if (event->number == 0) continue;
      const bool done = event->closed && event->waiting == 0;
      if (done || event->moments >= kMomentsTogether || (event->moments > 0 && (!event->first_told || flushing_))) {
        tell_pictures(*event);
      }
      if (done) event->earlier.reset();
    }
    std::erase_if(events_,
                  [](const EventPtr& event) { return event->number != 0 && event->closed && event->waiting == 0; });
  }

  // The thread.

  void run() {
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
    std::unique_lock lock(mutex_);
    bool ended = false;  // the last record is on its way
    for (;;) {
      if (!evicted_.empty()) {
        const auto evicted = std::exchange(evicted_, {});
        lock.unlock();
        // Here the memory goes.
        lock.lock();
      }
      tell_events();
      const bool may_write = ending_ || Clock::now() >= retry_;
      if (!records_.empty() && may_write) {
        const bool written = write_record(lock);
        if (!written && ending_) break;
        continue;
      }
      if (records_.empty() && !pictures_.empty()) {
        write_pictures(lock);
        continue;
      }
      if (Clock::now() >= next_look_) look_at_disk(lock);
      if (is_idle()) {
        idle_.notify_all();
        if (ending_ && ended) break;
        if (ending_) {
          records_.push_back(job(Json{{"kind", kEnd}, {"time", now()}, {"text", "The monitor ended."}}));
          ended = true;
          continue;
        }
      }
      wake_.wait_for(lock, kTick);
    }
    counts_.lost += records_.size();
    done_ = true;
    idle_.notify_all();
  }

  /// As Cause-like words; empty: it was done.
  template <class Work>
  std::string unlocked(std::unique_lock<std::mutex>& lock, Work&& work) {
    busy_ = true;
    lock.unlock();
    std::string problem;
    try {
      const int number = work();
      if (number != 0) problem = std::strerror(number);
    } catch (const std::exception& error) {
      problem = error.what();
    }
    lock.lock();
    busy_ = false;
    return problem;
  }

  /// The same of work that waits for the disk. Encoding is none: it may take long where the computer is busy.
  template <class Work>
  std::string on_disk(std::unique_lock<std::mutex>& lock, Work&& work) {
    disk_asked_ = Clock::now();
    std::string problem = unlocked(lock, std::forward<Work>(work));
    disk_asked_.reset();
    return problem;
  }

  /// A disk that is full is known before there is something to write.
  void look_at_disk(std::unique_lock<std::mutex>& lock) {
    next_look_ = Clock::now() + kLookAtDisk;
    picture_problem_ = on_disk(lock, [&] { return journal_.check_disk(); });
  }

  bool write_record(std::unique_lock<std::mutex>& lock) {
    RecordJob next = std::move(records_.front());
    records_.pop_front();
    const std::uint64_t lost = counts_.lost - lost_told_;
    Record written;
    const std::string problem = on_disk(lock, [&] {
      Json json = next.json;
      if (next.status) {
        json["time"] = time_text(next.status->time);
        json["text"] = sentence_of(*next.status);
        json.update(stop_json(*next.status, next.has_moment));
        for (const auto& [name, version] : settings_.versions) json["versions"][name] = version;
      }
      json["configuration"] = settings_.configuration;
      if (lost > 0) json["lost_before"] = lost;
      journal_.make_room(kRecordRoom_bytes);
      return journal_.append(json, next.event != nullptr, written);
    });
    if (!problem.empty()) {
      ++counts_.failures;
      record_problem_ = problem;
      retry_ = Clock::now() + kRetry;
      records_.push_front(std::move(next));
      return false;
    }
    lost_told_ += lost;
    record_problem_.clear();
    ++counts_.written;
    counts_.bytes = journal_.bytes();
    if (next.event) next.event->number = written.number;
    list(written);
    return true;
  }

  void write_pictures(std::unique_lock<std::mutex>& lock) {
    const PictureJob next = std::move(pictures_.front());
    pictures_.pop_front();
    Event& event = *next.event;
    const std::int64_t number = event.number;
    std::vector<PictureFile> files;
    std::string why;
    std::string problem = unlocked(lock, [&] {
      if (number == 0 || !journal_.holds(number)) {
        why = "the event is not in the log any more";
      } else {
        files = encode_moment(*next.moment);
      }
      return 0;
    });
    const auto write = [&] {
      std::uint64_t bytes = kRecordRoom_bytes;
      for (const PictureFile& file : files) bytes += file.bytes.size();
      if (!journal_.make_room(bytes) || !journal_.holds(number)) {
        why = "the log has no room for more";
        return 0;
      }
      for (const PictureFile& file : files) {
        if (const int error = journal_.write_picture(number, file.name, file.bytes); error != 0) return error;
      }
      return 0;
    };
    if (problem.empty() && why.empty()) problem = on_disk(lock, write);
    waiting_bytes_ -= next.bytes;
    --event.waiting;
    counts_.bytes = journal_.bytes();
    if (!problem.empty()) {
      ++counts_.failures;
      why = problem;
    }
    picture_problem_ = problem;
    if (!why.empty()) {
      ++event.left_out;
      ++counts_.left_out;
      event.why = why;
      return;
    }
    const double offset_ms = std::chrono::duration<double, std::milli>(next.moment->arrived - event.at).count();
    for (const PictureFile& file : files) {
      event.files.push_back({{"name", file.name},
                             {"bytes", file.bytes.size()},
                             {"sha256", sha256(file.bytes)},
                             {"frame", next.moment->status.frame},
                             {"offset_ms", offset_ms}});
    }
    counts_.pictures += files.size();
    ++event.moments;
  }

  const LogSettings settings_;
  Journal journal_;  ///< of the thread alone, once it runs

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::condition_variable idle_;
  std::deque<Kept> ring_;
  std::size_t ring_bytes_ = 0;
  Clock::time_point next_picture_{};
  std::vector<MomentPtr> evicted_;
  EventPtr collecting_;  ///< gets the pictures that come
  std::vector<EventPtr> events_;
  std::deque<RecordJob> records_;
  std::deque<PictureJob> pictures_;
  std::size_t waiting_bytes_ = 0;
  std::deque<LogEntry> listed_;
  LogCounts counts_;
  std::uint64_t lost_told_ = 0;
  std::string record_problem_;
  std::string picture_problem_;
  Clock::time_point retry_{};
  Clock::time_point next_look_{};
  bool busy_ = false;
  std::optional<Clock::time_point> disk_asked_;  ///< since then the thread waits for the disk
  bool flushing_ = false;
  bool ending_ = false;
  bool done_ = false;  ///< the thread has written all that it could
  std::thread thread_;
};

EventLog::EventLog(LogSettings settings) : writer_(Writer::start(std::move(settings))) {}
EventLog::~EventLog() {
  if (writer_->end()) return;
  std::fputs("horopter: the disk of the event log hangs: its last events are not written\n", stderr);
}

void EventLog::judged(const MomentPtr& moment) { writer_->judged(moment); }
void EventLog::stopped(const Status& status, const MomentPtr& moment) { writer_->stopped(status, moment); }
void EventLog::released(const Status& status, const Actor& by) {
  writer_->note("restart", status.time, by, "It is safe again, after a restart.");
}
void EventLog::noted(const Status& status, const Actor& actor, const std::string& what) {
  writer_->note("note", status.time, actor, what);
}
void EventLog::note(const std::string& kind, const Actor& actor, const std::string& what) {
  writer_->note(kind, std::chrono::system_clock::now(), actor, what);
}
std::optional<Cause> EventLog::trouble() const { return writer_->trouble(); }
LogCounts EventLog::counts() const { return writer_->counts(); }
std::vector<LogEntry> EventLog::entries(std::int64_t before, std::size_t count) const {
  return writer_->entries(before, count);
}
std::optional<LogEntry> EventLog::entry(std::int64_t number) const { return writer_->entry(number); }
std::optional<std::filesystem::path> EventLog::picture(std::int64_t number, const std::string& name) const {
  return writer_->picture(number, name);
}
bool EventLog::flush(milliseconds wait) { return writer_->flush(wait); }

}  // namespace horopter::monitor
