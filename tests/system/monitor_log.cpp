// SPDX-License-Identifier: Apache-2.0
// The event log of a monitor, and `horopter log`: complete, or it says what is missing; whatever kills it or fills the disk.
#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "eventually.hpp"
#include "horopter/base/error.hpp"
#include "horopter/image/image.hpp"
#include "horopter/monitor/event_log.hpp"
#include "horopter/monitor/log_reader.hpp"
#include "moments.hpp"
#include "sandbox.hpp"

using namespace horopter;
using namespace horopter::test;
using monitor::EventLog;
using monitor::LogReading;
using monitor::LogSettings;
using Json = nlohmann::ordered_json;

namespace {

constexpr auto kLong = std::chrono::seconds(60);  // as long as a machine may take that does much else
const monitor::Actor kAnna{"anna", "127.0.0.1"};

LogSettings settings_in(const fs::path& directory) {
  LogSettings settings;
  settings.directory = directory;
  settings.patience_s = 1e6;      // moments carry simulated time
  settings.pictures_per_s = 2.5;  // each tenth pair
  settings.configuration = "c0ffee";
  settings.versions = {{"horopter", "0.1.0"}};
  return settings;
}

/// A run of pairs with one stop at `alarm_at`.
void play(EventLog& log, std::uint64_t first, std::uint64_t last, std::uint64_t alarm_at, int width = 64) {
  for (std::uint64_t frame = first; frame <= last; ++frame) {
    const auto moment = moment_of(frame, frame == alarm_at, width, 3 * width / 4);
    log.judged(moment);
    if (frame == alarm_at) log.stopped(moment->status, moment);
  }
}

std::vector<LogReading::Event> events_of(const LogReading& reading, const std::string& kind) {
  std::vector<LogReading::Event> found;
  for (const auto& event : reading.events) {
    if (event.kind == kind) found.push_back(event);
  }
  return found;
}

std::uint64_t bytes_in(const fs::path& directory) {
  std::uint64_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.is_regular_file() && entry.path().filename() != "reserve") bytes += entry.file_size();
  }
  return bytes;
}

void flip(const fs::path& file, std::uint64_t at, int bit) {
  std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
  stream.seekg(static_cast<std::streamoff>(at));
  const int byte = stream.get();
  stream.seekp(static_cast<std::streamoff>(at));
  stream.put(static_cast<char>(byte ^ (1 << bit)));
  REQUIRE(stream.good());
}

std::vector<fs::path> files_in(const fs::path& directory, const std::string& ending) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.path().extension() == ending) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// Runs `work` in a process of its own, which prints; what it printed. Nothing of Catch2 in it.
std::string in_child(const std::function<void(int out)>& work) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    ::close(ends[0]);
    work(ends[1]);
    ::_exit(0);
  }
  ::close(ends[1]);
  std::string text;
  char buffer[4096];
  for (ssize_t got = 0; (got = ::read(ends[0], buffer, sizeof buffer)) > 0;) text.append(buffer, buffer + got);
  ::close(ends[0]);
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  CHECK(status == 0);
  return text;
}

void print(int out, const std::string& text) {
  [[maybe_unused]] const auto written = ::write(out, text.data(), text.size());
}

std::atomic<bool> disk_hangs = false;

}  // namespace

/// In place of the C library's, which the log calls behind each record.
extern "C" int fdatasync(int file) {
  while (disk_hangs) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return static_cast<int>(::syscall(SYS_fdatasync, file));
}

TEST_CASE("A stop is logged with its cause, objects, table, versions and the pictures before and after") {
  Sandbox box;
  {
    auto settings = settings_in(box / "log");
    settings.pictures_per_s = 12.5;  // each second pair
    EventLog log(settings);
    play(log, 0, 299, 150);
    log.released(status_of(300, false), kAnna);
    log.note("login_refused", {"mallory", "10.0.0.9"}, "Log-in refused.");
    REQUIRE(log.flush(kLong));
    const auto entries = log.entries(1000, 10);
    REQUIRE(entries.size() == 4);
    CHECK(entries[0].json["kind"] == "login_refused");
    CHECK(entries[2].pictures.size() == 3 * 51);
    CHECK(entries[2].complete);
    CHECK(log.picture(entries[2].number, entries[2].pictures[0]));
    CHECK_FALSE(log.picture(entries[2].number, "../../../lock"));
    CHECK_FALSE(log.trouble());
  }
  const auto reading = monitor::read_log(box / "log", true);
  CAPTURE(reading.problems, reading.notes);
  CHECK(reading.problems.empty());
  CHECK(reading.notes.empty());
  REQUIRE(reading.events.size() == 5);
  CHECK(reading.events[0].kind == "start");
  CHECK(reading.events[2].kind == "restart");
  CHECK(reading.events[2].json["by"]["name"] == "anna");
  CHECK(reading.events[4].kind == "end");
  const auto& stop = reading.events[1];
  CHECK(stop.kind == "stop");
  CHECK(stop.text == "Something is in the skin.");
  CHECK(stop.json["causes"][0]["name"] == "alarm");
  CHECK(stop.json["objects"][0]["id"] == 7);
  CHECK(stop.json["objects"][0]["speed_mm_s"] == 1430);
  CHECK(stop.json["table_crc"] == "1234abcd");
  CHECK(stop.json["versions"]["horopter"] == "0.1.0");
  for (const auto& event : reading.events) CHECK(event.json["configuration"] == "c0ffee");
  // From 2 s before to 2 s after, the pair that did it among them, and each is the picture of its pair.
  std::vector<std::string> names;
  for (const auto& picture : stop.pictures) names.push_back(picture.name);
  CHECK(std::ranges::count(names, "frame-00000150-overlay.jpg") == 1);
  CHECK(std::ranges::min(names) == "frame-00000100-left.png");
  CHECK(std::ranges::max(names) == "frame-00000200-right.png");
  const fs::path folder = box / "log" / "pictures" / "000000000002";
  CHECK(load_image(folder / "frame-00000150-left.png") == moment_of(150)->left);
  CHECK(load_image(folder / "frame-00000150-right.png") == moment_of(150)->right);
  CHECK(load_image(folder / "frame-00000150-overlay.jpg").width >= 600);
}

TEST_CASE("A second stop soon after the first takes the pictures over, and both say so") {
  Sandbox box;
  {
    auto settings = settings_in(box / "log");
    settings.pictures_per_s = 12.5;
    EventLog log(settings);
    play(log, 0, 120, 100);
    play(log, 121, 240, 121);
    REQUIRE(log.flush(kLong));
  }
  const auto reading = monitor::read_log(box / "log", true);
  CHECK(reading.problems.empty());
  const auto stops = events_of(reading, "stop");
  REQUIRE(stops.size() == 2);
  using Names = std::vector<std::string>;
  const auto frames = [](const LogReading::Event& event) {
    Names names;
    for (const auto& picture : event.pictures) names.push_back(picture.name.substr(0, 14));
    return Names{std::ranges::min(names), std::ranges::max(names)};
  };
  CHECK(frames(stops[0]) == Names{"frame-00000050", "frame-00000120"});
  CHECK(frames(stops[1]) == Names{"frame-00000121", "frame-00000170"});
  CHECK_THAT(stops[0].lines.back(), Catch::Contains("\"continued_in\":" + std::to_string(stops[1].number)));
  CHECK_THAT(stops[1].lines.back(), Catch::Contains("\"earlier_in\":" + std::to_string(stops[0].number)));
}

TEST_CASE("A stop without a pair, as of a camera that is gone, is logged with the pictures before") {
  Sandbox box;
  {
    EventLog log(settings_in(box / "log"));
    // No pair comes any more: the clock is this computer's.
    for (std::uint64_t frame = 0; frame < 10; ++frame) {
      auto moment = std::make_shared<monitor::Moment>(*moment_of(frame));
      moment->arrived = monitor::Clock::now() + std::chrono::seconds(frame);
      log.judged(moment);
    }
    auto status = status_of(10, false);
    status.safe = false;
    status.causes = {{"camera_lost", "The left camera does not answer.", "Look at its cable."}};
    log.stopped(status, nullptr);
    REQUIRE(log.flush(kLong));
  }
  const auto stops = events_of(monitor::read_log(box / "log", true), "stop");
  REQUIRE(stops.size() == 1);
  CHECK(stops[0].text == "The left camera does not answer.");
  CHECK(stops[0].json["pair"] == false);
  CHECK_FALSE(stops[0].pictures.empty());
}

TEST_CASE("Where the writer cannot follow, pictures are left out and that is said, never the event") {
  Sandbox box;
  auto settings = settings_in(box / "log");
  settings.memory_bytes = 60'000;  // of five pairs
  settings.pictures_per_s = 25;
  {
    EventLog log(settings);
    play(log, 0, 200, 100);
    REQUIRE(log.flush(kLong));
    CHECK(log.counts().left_out > 0);
  }
  const auto reading = monitor::read_log(box / "log", true);
  CHECK(reading.problems.empty());
  const auto stops = events_of(reading, "stop");
  REQUIRE(stops.size() == 1);
  CHECK_THAT(stops[0].lines.back(), Catch::Contains("they came faster than they could be written"));
  CHECK(std::ranges::any_of(stops[0].pictures, [](const auto& p) { return p.name == "frame-00000100-left.png"; }));
}

TEST_CASE("The log stays within its limit: the oldest events go first, and the last one never") {
  Sandbox box;
  auto settings = settings_in(box / "log");
  settings.limit_bytes = 1'000'000;
  std::int64_t last = 0;
  {
    EventLog log(settings);
    for (std::uint64_t event = 0; event < 30; ++event) {
      play(log, 1000 * event, 1000 * event + 150, 1000 * event + 75, 96);
      REQUIRE(log.flush(kLong));
      CHECK(bytes_in(box / "log") <= settings.limit_bytes);
    }
    last = events_of(monitor::read_log(box / "log", true), "stop").back().number;
    // Whoever tries passwords without end does not drive the last stop out.
    for (int i = 0; i < 1500; ++i) {
      log.note("login_refused", kAnna, "Log-in refused. " + std::string(1000, 'x'));
      if (i % 500 == 0) REQUIRE(log.flush(kLong));
    }
    REQUIRE(log.flush(kLong));
    CHECK(log.counts().lost == 0);
    CHECK(bytes_in(box / "log") <= settings.limit_bytes);
  }
  const auto reading = monitor::read_log(box / "log", true);
  CAPTURE(reading.problems, reading.notes);
  CHECK(reading.problems.empty());
  CHECK(reading.events.front().number > 1);
  const auto stops = events_of(reading, "stop");
  REQUIRE_FALSE(stops.empty());
  CHECK(stops.back().number == last);
  CHECK(stops.back().json["frame"] == 29075);
  CHECK_FALSE(stops.back().pictures.empty());
  CHECK_FALSE(events_of(reading, "removed").empty());
  // An event larger than the limit keeps its record; its pictures are left out.
  {
    EventLog log(settings);
    play(log, 50000, 50150, 50075, 480);
    REQUIRE(log.flush(kLong));
    CHECK(log.counts().left_out > 0);
    CHECK(bytes_in(box / "log") <= settings.limit_bytes);
  }
  CHECK(events_of(monitor::read_log(box / "log", true), "stop").back().json["frame"] == 50075);
}

TEST_CASE("What was removed, and whose end is torn, is told as long as it shows") {
  Sandbox box;
  auto settings = settings_in(box / "log");
  settings.limit_bytes = 1'000'000;
  {
    EventLog log(settings);
    for (std::uint64_t event = 0; event < 6; ++event) play(log, 1000 * event, 1000 * event + 150, 1000 * event + 75);
    REQUIRE(log.flush(kLong));
  }
  // The last event, which is kept, has a torn end.
  std::ofstream(files_in(box / "log", ".jsonl").back(), std::ios::app) << "0123456789abcdef torn";
  // Records after it push out what was before it; then those that told of that and of the torn end are pushed out themselves.
  for (int round = 0; round < 3; ++round) {
    CAPTURE(round);
    {
      EventLog log(settings);
      for (int i = 0; i < 1500; ++i) {
        log.note("login_refused", kAnna, "Log-in refused. " + std::string(1000, 'x'));
        if (i % 500 == 499) REQUIRE(log.flush(kLong));
      }
    }
    const auto reading = monitor::read_log(box / "log", true);
    CAPTURE(reading.problems, reading.notes);
    CHECK(reading.problems.empty());
    CHECK(reading.events.front().number > 1);
    CHECK(events_of(reading, "stop").size() == 1);
  }
  // What stayed in between is not among what was removed before it and behind it.
  const auto kept = files_in(box / "log", ".jsonl").front();
  REQUIRE_THAT(read_text(kept), Catch::Contains("\"kind\":\"stop\""));
  fs::rename(kept, box / "aside");
  fs::rename(box / "log" / "pictures", box / "pictures");
  const auto without = monitor::read_log(box / "log", true).problems;
  REQUIRE(without.size() == 1);
  CHECK_THAT(without[0],
             Catch::StartsWith("Events 1 to ") && Catch::EndsWith("no record tells that they were removed."));
  fs::rename(box / "aside", kept);
  fs::rename(box / "pictures", box / "log" / "pictures");
  // After another stop it goes itself; then those that told of it.
  EventLog log(settings);
  play(log, 7000, 7150, 7075);
  for (int i = 0; i < 3000; ++i) {
    log.note("login_refused", kAnna, "Log-in refused. " + std::string(1000, 'x'));
    if (i % 100 != 99) continue;
    REQUIRE(log.flush(kLong));
    const auto reading = monitor::read_log(box / "log", true);
    CAPTURE(i, reading.problems);
    REQUIRE(reading.problems.empty());
  }
  CHECK_FALSE(fs::exists(kept));
}

TEST_CASE("A removal that a kill has interrupted is no damage, and is ended at the next start") {
  Sandbox box;
  auto settings = settings_in(box / "log");
  settings.limit_bytes = 30'000'000;
  {
    EventLog log(settings);
    for (std::uint64_t event = 0; event < 6; ++event) {
      play(log, 1000 * event, 1000 * event + 150, 1000 * event + 75);
      REQUIRE(log.flush(kLong));
    }
  }
  settings.limit_bytes = 1'000'000;
  const auto before = files_in(box / "log", ".jsonl");
  fs::create_directories(box / "copy");
  for (const fs::path& path : before) fs::copy_file(path, box / "copy" / path.filename());
  {
    EventLog log(settings);
    for (int i = 0; i < 1500; ++i) {
      log.note("login_refused", kAnna, "Log-in refused. " + std::string(1000, 'x'));
      if (i % 500 == 499) REQUIRE(log.flush(kLong));
    }
  }
  std::vector<fs::path> gone;
  std::ranges::copy_if(before, std::back_inserter(gone), [](const fs::path& path) { return !fs::exists(path); });
  REQUIRE(gone.size() > 2);
  const fs::path middle = gone[gone.size() / 2];
  fs::copy_file(box / "copy" / middle.filename(), middle);
  CHECK(monitor::read_log(box / "log", true).problems.empty());
  {
    EventLog log(settings);
  }
  CHECK_FALSE(fs::exists(middle));
  CHECK(monitor::read_log(box / "log", true).problems.empty());
}

TEST_CASE("A writer that is killed at any moment leaves a log in order, with all that it had promised") {
  Sandbox box;
  const auto seed = std::random_device{}();
  std::mt19937 random(seed);
  const int kills = std::getenv("HOROPTER_LONG") != nullptr ? 500 : 60;
  std::int64_t promised = 0;  // stops on disk
  for (int i = 0; i < kills; ++i) {
    CAPTURE(seed, i);
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      try {
        auto settings = settings_in(box / "log");
        settings.limit_bytes = 3'000'000;
        EventLog log(settings);
        for (std::uint64_t event = 0;; ++event) {
          play(log, 1000 * event, 1000 * event + 110, 1000 * event + 50);
          if (!log.flush(kLong)) ::_exit(2);
          const std::int64_t number = log.entries(1'000'000'000, 1).at(0).number;
          if (::write(ends[1], &number, sizeof number) != sizeof number) ::_exit(3);
        }
      } catch (...) {
        ::_exit(4);
      }
    }
    ::close(ends[1]);
    std::int64_t number = 0;
    if (i % 2 == 0) {  // after its first promise, or at once
      REQUIRE(::read(ends[0], &number, sizeof number) == sizeof number);
      promised = number;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 60'000));
    REQUIRE(::kill(child, SIGKILL) == 0);
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    REQUIRE(WIFSIGNALED(status));
    while (::read(ends[0], &number, sizeof number) == sizeof number) promised = number;
    ::close(ends[0]);
    if (!fs::exists(box / "log" / "lock")) continue;  // killed before it had begun

    const auto reading = monitor::read_log(box / "log", true);
    CAPTURE(reading.problems, reading.notes);
    REQUIRE(reading.problems.empty());
    REQUIRE_FALSE(reading.in_use);
    if (promised == 0) continue;
    const auto stops = events_of(reading, "stop");
    // Or the log says that it was removed: it is bounded, the oldest go first, and this writer may have needed the room.
    const bool made_room = std::ranges::any_of(events_of(reading, "removed"), [&](const auto& event) {
      return promised <= event.json["last"].template get<std::int64_t>();
    });
    REQUIRE((made_room || std::ranges::any_of(stops, [&](const auto& event) { return event.number == promised; })));
    REQUIRE(bytes_in(box / "log") <= 3'400'000);  // and what was on its way
  }
  REQUIRE(promised > 0);
  {
    EventLog log(settings_in(box / "log"));
    REQUIRE(log.flush(kLong));
    const auto start = log.entries(1'000'000'000, 1).at(0);
    CHECK_THAT(start.json["text"].get<std::string>(), Catch::Contains("it was killed"));
  }
  const auto reading = monitor::read_log(box / "log", true);
  CHECK(reading.problems.empty());
  CHECK(files_in(box / "log", ".partial").empty());
}

TEST_CASE("A torn end and files of nobody are cleaned and told at the next start") {
  Sandbox box;
  {
    EventLog log(settings_in(box / "log"));
  }
  const auto journal = files_in(box / "log", ".jsonl");
  REQUIRE(journal.size() == 1);
  std::ofstream(journal[0], std::ios::app) << "0123456789abcdef torn";
  box.write("log/pictures/000000000001.partial", "x");
  fs::create_directories(box / "log" / "pictures" / "000000000002");
  box.write("log/pictures/000000000002/frame-00000001-left.png", "of nobody");
  auto reading = monitor::read_log(box / "log", true);
  CHECK(reading.problems.empty());
  CHECK(reading.notes.size() == 2);
  {
    EventLog log(settings_in(box / "log"));
    REQUIRE(log.flush(kLong));
    const auto start = log.entries(1000, 1).at(0);
    CHECK(start.json["kind"] == "start");
    CHECK(start.json["torn"][0]["bytes"] == 21);
    CHECK(start.json["leftovers"] == 2);
    CHECK_THAT(start.json["text"].get<std::string>(), Catch::Contains("The end of the log was not complete."));
  }
  {
    EventLog log(settings_in(box / "log"));
  }  // told once
  reading = monitor::read_log(box / "log", true);
  CHECK(reading.problems.empty());
  CHECK(reading.notes.size() == 1);
  CHECK_FALSE(fs::exists(box / "log" / "pictures" / "000000000002"));
  CHECK_FALSE(events_of(reading, "start").back().json.contains("torn"));
}

TEST_CASE("Every flipped bit, every removed file and every changed line is found") {
  Sandbox box;
  {
    EventLog log(settings_in(box / "log"));
    play(log, 0, 150, 75, 48);
    play(log, 1000, 1150, 1075, 48);
    for (int i = 0; i < 5; ++i) log.note("teach", kAnna, "The zone was taught.");
  }
  const auto is_found = [&](bool pictures = true) {
    return !monitor::read_log(box / "log", pictures).problems.empty();
  };
  REQUIRE_FALSE(is_found());
  const auto seed = std::random_device{}();
  std::mt19937 random(seed);
  const auto journal = files_in(box / "log", ".jsonl");
  REQUIRE(journal.size() == 3);
  std::vector<fs::path> files = files_in(box / "log", ".png");
  const auto overlays = files_in(box / "log", ".jpg");
  files.insert(files.end(), overlays.begin(), overlays.end());
  for (int i = 0; i < 150; ++i) {
    const fs::path file = i % 3 == 0 ? files[random() % files.size()] : journal[random() % journal.size()];
    // The last line's end alone may look as if it were being written.
    const auto at = random() % (fs::file_size(file) - (file == journal.back() ? 1 : 0));
    const int bit = static_cast<int>(random() % 8);
    CAPTURE(seed, file, at, bit);
    flip(file, at, bit);
    CHECK(is_found(i % 3 == 0));
    flip(file, at, bit);
  }
  for (const fs::path& file : {journal[0], journal[1], files[0]}) {
    CAPTURE(file);
    fs::rename(file, box / "aside");
    CHECK(is_found());
    fs::rename(box / "aside", file);
  }
  // A line taken out, and a line put in again whose own checksum is right.
  const std::string text = read_text(journal[2]);
  const auto begin = text.find('\n', text.find("zone was taught")) + 1;
  const auto end = text.find('\n', begin) + 1;
  box.write("log/" + journal[2].filename().string(), text.substr(0, begin) + text.substr(end));
  CHECK(is_found());
  box.write("log/" + journal[2].filename().string(),
            text.substr(0, end) + text.substr(begin, end - begin) + text.substr(end));
  CHECK(is_found());
  box.write("log/" + journal[2].filename().string(), text);
  CHECK_FALSE(is_found());
}

TEST_CASE("A log of one monitor is not written by another, and no file is taken for one") {
  Sandbox box;
  EventLog log(settings_in(box / "log"));
  CHECK_THROWS_WITH(EventLog(settings_in(box / "log")), Catch::Contains("another process writes to this event log"));
  box.write("file", "x");
  CHECK_THROWS_AS(EventLog(settings_in(box / "file")), FileError);
  CHECK_THROWS_AS(monitor::read_log(box / "no", false), FileError);
  fs::create_directory(box / "empty");
  CHECK_THROWS_WITH(monitor::read_log(box / "empty", false), Catch::Contains("this is no event log"));
  auto settings = settings_in(box / "small");
  settings.limit_bytes = 1000;
  CHECK_THROWS_AS(EventLog(settings), UsageError);
}

TEST_CASE("A full disk stops neither the monitor nor what it says, and what was written stays in order") {
  Sandbox box;
  fs::create_directory(box / "disk");
  const std::string disk = (box / "disk").string();
  const std::string said = in_child([&](int out) {
    const uid_t user = ::getuid();
    if (::unshare(CLONE_NEWNS) != 0) {
      if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return print(out, "skipped");
      std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
    }
    ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr);
    if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=16m") != 0) return print(out, "skipped");
    Json told;
    try {
      auto settings = settings_in(disk + "/log");
      EventLog log(settings);
      play(log, 0, 120, 50);
      told["before"] = log.flush(kLong) && !log.trouble();
      {  // somebody else fills the disk
        std::ofstream filler(disk + "/filler", std::ios::binary);
        const std::string block(4096, 'x');
        while (filler.write(block.data(), static_cast<std::streamsize>(block.size())).flush()) {
        }
      }
      play(log, 1000, 1120, 1050);
      told["stop_written"] = log.flush(kLong);
      told["left_out"] = log.counts().left_out;
      told["picture_trouble"] = log.trouble() ? log.trouble()->text : "";
      // Until what was kept for this is used up, too.
      int notes = 0;
      while (log.counts().waiting < 20 && notes < 100'000) {
        log.note("note", kAnna, std::string(2000, 'x'));
        if (++notes % 20 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
      const auto deadline = monitor::Clock::now() + kLong;
      const auto wait_for = [&](const auto& condition) {
        while (!condition() && monitor::Clock::now() < deadline) {
          std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return condition();
      };
      told["trouble_shown"] =
          wait_for([&] { return log.trouble() && Catch::contains(log.trouble()->text, "event log"); });
      told["trouble"] = log.trouble() ? log.trouble()->text : "";
      const auto begin = monitor::Clock::now();
      play(log, 2000, 2120, 2050);  // goes on
      told["monitor_waits_ms"] =
          std::chrono::duration_cast<std::chrono::milliseconds>(monitor::Clock::now() - begin).count();
      fs::remove(disk + "/filler");
      told["recovered"] = wait_for([&] { return log.counts().waiting == 0 && !log.trouble(); }) && log.flush(kLong);
      told["trouble_after"] = log.trouble() ? log.trouble()->text : "";
      told["lost"] = log.counts().lost;
      told["notes"] = notes;
    } catch (const std::exception& error) {
      told["error"] = error.what();
    }
    try {
      const auto reading = monitor::read_log(disk + "/log", true);
      told["problems"] = reading.problems;
      told["stops"] = events_of(reading, "stop").size();
      told["notes_read"] = events_of(reading, "note").size();
    } catch (const std::exception& error) {
      told["error"] = error.what();
    }
    print(out, told.dump());
  });
  if (said == "skipped") {
    std::cout << "skipped: this user may not mount a small disk\n";
    return;
  }
  CAPTURE(said);
  const Json told = Json::parse(said);
  CHECK_FALSE(told.contains("error"));
  CHECK(told["before"] == true);
  CHECK(told["stop_written"] == true);
  CHECK(told["left_out"] > 0);
  CHECK_THAT(told["picture_trouble"].get<std::string>(), Catch::Contains("No space left on device"));
  CHECK(told["trouble_shown"] == true);
  CHECK(told["recovered"] == true);
  CHECK(told["lost"] == 0);
  CHECK(told["problems"].empty());
  CHECK(told["stops"] == 3);
  CHECK(told["notes_read"] == told["notes"]);
}

TEST_CASE("A disk that hangs, or is so slow that events are lost, is told until it goes on") {
  Sandbox box;
  auto settings = settings_in(box / "log");
  const bool is_slow = GENERATE(false, true);
  settings.hang_s = is_slow ? 1e6 : 0.5;
  {
    EventLog log(settings);
    REQUIRE(log.flush(kLong));
    CHECK(eventually([&] { return !log.trouble(); }));
    disk_hangs = true;
    for (int i = 0; i < (is_slow ? 1100 : 10); ++i) log.note("note", kAnna, "x");
    eventually([&] { return log.trouble().has_value(); });
    const auto trouble = log.trouble();
    const auto lost = log.counts().lost;
    std::vector<std::weak_ptr<const monitor::Moment>> moments;
    for (std::uint64_t frame = 0; frame < 1000; ++frame) {
      const auto moment = moment_of(frame);
      moments.emplace_back(moment);
      log.judged(moment);
    }
    const auto in_memory = std::ranges::count_if(moments, [](const auto& moment) { return !moment.expired(); });
    disk_hangs = false;
    CHECK(in_memory < 50);  // of 100 that were kept for a stop that might have come
    REQUIRE(trouble);
    CHECK_THAT(trouble->text, Catch::Contains(is_slow ? "too slow" : "does not answer"));
    CHECK((lost > 0) == is_slow);
    CHECK(eventually([&] { return !log.trouble(); }));
    CHECK(log.flush(kLong));
  }
  const auto reading = monitor::read_log(box / "log", true);
  CHECK(reading.problems.empty());
  CHECK(events_of(reading, "end").size() == 1);
}

TEST_CASE("A disk that hangs does not hold the end") {
  Sandbox box;
  const std::string said = in_child([&](int out) {
    auto settings = settings_in(box / "log");
    settings.hang_s = 0.2;
    {
      EventLog log(settings);
      disk_hangs = true;
      log.note("note", kAnna, "x");
    }
    print(out, "ended");
  });
  CHECK(said == "ended");
}

TEST_CASE("`horopter log` lists, checks and exports") {
  Sandbox box;
  {
    EventLog log(settings_in(box / "log"));
    play(log, 0, 120, 50);
    log.note("note", {"eve\n  99  never  stop  forged", ""}, "Teaching began.");
  }
  const auto listed = box.run({"log", "log"});
  CAPTURE(listed.out, listed.err);
  CHECK(listed.status == 0);
  CHECK_THAT(listed.out, Catch::Contains("stop           Something is in the skin. 33 pictures.") &&
                             Catch::Contains("Teaching began. By eve   99"));
  CHECK(std::ranges::count(listed.out, '\n') == 4);
  const auto json = Json::parse(box.run({"log", "log", "--json"}).out);
  CHECK(json["events"][1]["kind"] == "stop");
  CHECK(json["events"][1]["pictures"].size() == 33);
  CHECK(json["problems"].empty());

  CHECK(box.run({"log", "log", "--export", "2", "event.zip"}).status == 0);
  CHECK(box.run({"log", "log", "--export", "2", "event"}).status == 0);
  const auto unpacked = box.run_shell(
      "cd event && sha256sum --quiet -c SHA256SUMS && cd .. && mkdir unzipped && cd unzipped && "
      "python3 -m zipfile -e ../event.zip . && diff -r . ../event");
  CAPTURE(unpacked.out, unpacked.err);
  CHECK(unpacked.status == 0);
  fs::create_directory(box / "empty");
  CHECK(box.run({"log", "log", "--export", "2", "empty"}).status == 0);
  // Pictures of one event beside the sums of another, or all of it in the log itself.
  for (const std::string place : {"event", "log"}) {
    check_bad_file(box, {"log", "log", "--export", "1", place}, place, "there are files in this directory");
  }
  CHECK(box.run({"log", "log", "--export", "77", "event.zip"}).status == 2);
  CHECK(box.run({"log", "log", "--export", "2", "no/such/place.zip"}).status == 3);

  const auto checked = box.run({"log", "log", "--check"});
  CHECK(checked.status == 0);
  CHECK_THAT(checked.out, Catch::Contains("4 events and 33 pictures are as they were written"));
  const fs::path picture = box / "log" / "pictures" / "000000000002" / "frame-00000050-left.png";
  flip(picture, 100, 3);
  const auto found = box.run({"log", "log", "--check"});
  CHECK(found.status == 1);
  CHECK_THAT(found.out, Catch::Contains("problem: Event 2: frame-00000050-left.png is not as it was written."));
  const auto refused = box.run({"log", "log", "--export", "2", "changed.zip"});
  CHECK(refused.status == 3);
  CHECK_FALSE(fs::exists(box / "changed.zip"));
  CHECK(box.run({"log", "nowhere"}).status == 3);
}
