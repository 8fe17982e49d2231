// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <zip.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>

#include "durable.hpp"
#include "horopter/base/error.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/monitor/log_reader.hpp"
#include "journal.hpp"

namespace horopter::monitor {
namespace {

namespace fs = std::filesystem;

struct Item {
  std::string name;
  std::string bytes;
};

std::string page_of(const LogReading::Event& event) {
  std::string text = fmt::format("Event {} of a Horopter event log\n\ntime   {}\nkind   {}\n\n{}\n", event.number,
                                 event.time, event.kind, event.text);
  const auto causes = event.json.find("causes");
  if (causes != event.json.end() && causes->is_array()) {
    for (const Json& cause : *causes) {
      if (cause.is_object()) {
        text += fmt::format("\n{}: {} {}", text_in(cause, "name"), text_in(cause, "text"), text_in(cause, "advice"));
      }
    }
  }
  text +=
      "\n\nevent.json   all that the log says of it\n"
      "journal.txt  its lines of the journal: a SHA-256, and the JSON that it is of\n"
      "SHA256SUMS   of the other files; `sha256sum -c SHA256SUMS` checks them\n";
  return text;
}

std::vector<Item> items_of(const fs::path& directory, const LogReading::Event& event) {
  std::vector<Item> items{{"README.txt", page_of(event)}, {"event.json", json_text(event.json) + "\n"}};
  std::string lines;
  for (const std::string& line : event.lines) lines += line + "\n";
  items.push_back({"journal.txt", lines});
  for (const LogReading::Picture& picture : event.pictures) {
    const fs::path path = pictures_of(directory, event.number) / picture.name;
    std::ifstream stream(path, std::ios::binary);
    Item item{picture.name, {std::istreambuf_iterator<char>(stream), {}}};
    if (!stream || sha256(item.bytes) != picture.sha256) {
      throw FileError(path.string(), "", "the picture is missing, or not as it was written",
                      "a log that `horopter log --check` finds in order");
    }
    items.push_back(std::move(item));
  }
  std::string sums;
  for (const Item& item : items) sums += fmt::format("{}  {}\n", sha256(item.bytes), item.name);
  items.push_back({"SHA256SUMS", sums});
  return items;
}

[[noreturn]] void fail(const fs::path& out, const std::string& why) {
  throw FileError(out.string(), "", "the event cannot be written here (" + why + ")", "a writable place with room");
}

void write_directory(const fs::path& out, const std::vector<Item>& items) {
  std::error_code error;
  fs::create_directories(out, error);
  if (!error && !fs::is_empty(out, error) && !error) {
    throw FileError(out.string(), "", "there are files in this directory, which would seem to belong to the event",
                    "a new or empty directory");
  }
  if (error) fail(out, error.message());
  for (const Item& item : items) {
    const int problem = write_durably(out / item.name, item.bytes);
    if (problem == 0) continue;
    for (const Item& written : items) fs::remove(out / written.name, error);
    fail(out, std::strerror(problem));
  }
}

void write_zip(const fs::path& out, const std::vector<Item>& items) {
  int code = 0;
  fs::path temporary = out;
  temporary += ".partial";
  zip_t* const zip = zip_open(temporary.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
  if (zip == nullptr) fail(out, "it cannot be made");
  std::string problem;
  for (const Item& item : items) {
    zip_source_t* const source = zip_source_buffer(zip, item.bytes.data(), item.bytes.size(), 0);
    if (source != nullptr && zip_file_add(zip, item.name.c_str(), source, ZIP_FL_ENC_UTF_8) >= 0) continue;
    problem = zip_strerror(zip);
    zip_source_free(source);
    break;
  }
  if (problem.empty() && zip_close(zip) != 0) problem = zip_strerror(zip);
  std::error_code error;
  if (problem.empty()) fs::rename(temporary, out, error);
  if (problem.empty() && !error) return;
  if (!error) zip_discard(zip);
  std::error_code ignored;
  fs::remove(temporary, ignored);
  fail(out, problem.empty() ? error.message() : problem);
}

}  // namespace

void export_event(const fs::path& directory, const LogReading::Event& event, const fs::path& out) {
  const auto items = items_of(directory, event);
  if (out.extension() == ".zip") {
    write_zip(out, items);
  } else {
    write_directory(out, items);
  }
}

}  // namespace horopter::monitor
