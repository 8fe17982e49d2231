// SPDX-License-Identifier: Apache-2.0
#include "horopter/image/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "horopter/base/error.hpp"
#include "horopter/image/mat.hpp"

namespace horopter {
namespace {

namespace fs = std::filesystem;

constexpr const char* kIncomplete = "incomplete";

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// False where there is no room, or no permission.
bool write_plain(const fs::path& path, std::span<const std::uint8_t> bytes) {
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  return stream.good();
}

/// Opens a directory and locks it for as long as this process lives; nothing where another process has it. Process
/// numbers would not do: containers that share a directory have their own.
std::optional<int> lock_directory(const fs::path& directory) {
  const int file = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  if (file >= 0) ::close(file);
  return std::nullopt;
}

fs::path parent_of(const fs::path& place) { return place.parent_path().empty() ? "." : place.parent_path(); }

/// Takes away what killed processes left: directories named `.NAME.PROCESS.partial`, and files `.NAME.PROCESS`.
void remove_leftovers(const fs::path& parent, const std::string& name) {
  const std::string prefix = "." + name + ".";
  const std::string suffix = ".partial";
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(parent, error)) {
    const std::string found = entry.path().filename().string();
    if (!found.starts_with(prefix)) continue;
    const bool directory = entry.is_directory(error);
    if (directory != found.ends_with(suffix)) continue;
    const char* const end = found.data() + found.size() - (directory ? suffix.size() : 0);
    pid_t process = 0;
    const auto [rest, problem] = std::from_chars(found.data() + prefix.size(), end, process);
    if (problem != std::errc{} || rest != end || process <= 0) continue;
    if (directory) {
      const auto lock = lock_directory(entry.path());
      if (!lock) continue;
      fs::remove_all(entry.path(), error);
      ::close(*lock);
    } else if (::kill(process, 0) != 0 && errno == ESRCH) {
      fs::remove(entry.path(), error);
    }
  }
}

std::vector<std::uint8_t> encode(const cv::Mat& image) {
  std::vector<std::uint8_t> bytes;
  if (!cv::imencode(".png", image, bytes, {cv::IMWRITE_PNG_COMPRESSION, 3})) {
    throw Error(ExitStatus::fault, "a picture cannot be encoded as PNG");
  }
  return bytes;
}

}  // namespace

void write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
  const std::string name = path.filename().string();
  remove_leftovers(parent_of(path), name);
  const fs::path temporary = path.parent_path() / fmt::format(".{}.{}", name, ::getpid());
  std::mutex mutex;
  const BeforeEnding before_ending([&] {
    mutex.lock();
    std::error_code error;
    fs::remove(temporary, error);
  });
  const std::lock_guard lock(mutex);
  std::error_code error;
  const bool written = write_plain(temporary, bytes);
  if (written) fs::rename(temporary, path, error);
  if (written && !error) return;
  std::error_code ignored;
  fs::remove(temporary, ignored);
  if (!written)
    throw FileError(path.string(), "", "the file cannot be written", "a directory that exists and has room");
  throw FileError(path.string(), "", "the file cannot be written (" + error.message() + ")", "a writable place");
}

void write_file(const fs::path& path, std::string_view text) { write_file(path, bytes_of(text)); }

std::vector<std::uint8_t> encode_png(const Image& image) { return encode(mat_of(image)); }

std::vector<std::uint8_t> encode_png_bgr(int width, int height, std::span<const std::uint8_t> bgr) {
  return encode(cv::Mat(height, width, CV_8UC3, const_cast<std::uint8_t*>(bgr.data())));
}

OutputDirectory::OutputDirectory(const fs::path& path, IsResult is_result)
    : path_(fs::absolute(path).lexically_normal()), is_result_(is_result) {
  if (!path_.has_filename()) path_ = path_.parent_path();
  std::error_code error;
  const bool exists = fs::exists(path_, error);
  if (exists && !fs::is_directory(path_, error)) {
    throw FileError(path_.string(), "", "this is a file", "a directory for the results, new or existing");
  }
  for (fs::path parent = path_.parent_path(); !parent.empty() && !fs::exists(parent, error);
       parent = parent.parent_path()) {
    made_.push_back(parent);
  }
  for (auto parent = made_.rbegin(); parent != made_.rend(); ++parent) fs::create_directory(*parent, error);
  const std::string name = path_.filename().string();
  remove_leftovers(parent_of(path_), name);
  remove_leftovers(path_, name);
  staging_ = (exists ? path_ : path_.parent_path()) / fmt::format(".{}.{}.partial", name, ::getpid());
  if (!fs::create_directory(staging_, error)) {
    for (const fs::path& parent : made_) fs::remove(parent, error);
    throw FileError(path_.string(), "", "the directory cannot be made, or written to (" + error.message() + ")",
                    "a writable place");
  }
  lock_ = lock_directory(staging_);
  before_ending_.emplace([this] {
    mutex_.lock();
    discard();
  });
}

OutputDirectory::~OutputDirectory() {
  before_ending_.reset();
  discard();
}

void OutputDirectory::discard() {
  if (lock_) ::close(*lock_);
  lock_.reset();
  if (staging_.empty()) return;
  std::error_code error;
  fs::remove_all(staging_, error);
  staging_.clear();
  for (const fs::path& parent : made_) fs::remove(parent, error);  // only if empty
}

void OutputDirectory::set_aside(const std::string& file_name) {
  set_aside_.push_back(file_name);
  std::error_code error;
  if (fs::exists(path_ / file_name, error)) fs::rename(path_ / file_name, path_ / ("earlier-" + file_name), error);
  if (error) {
    throw FileError((path_ / file_name).string(), "",
                    "this file of an earlier run cannot be renamed (" + error.message() + ")", "a writable place");
  }
}

void OutputDirectory::write(const std::string& file_name, std::span<const std::uint8_t> bytes) {
  const std::lock_guard lock(mutex_);
  if (staging_.empty()) throw std::logic_error("OutputDirectory: written to after its end");
  if (file_name.empty() || file_name == "." || file_name == ".." || fs::path(file_name).filename() != file_name) {
    throw FileError(path_.string(), "", "the file '" + file_name + "' would lie elsewhere",
                    "a name without directories");
  }
  if (!write_plain(staging_ / file_name, bytes)) {
    throw FileError((path_ / file_name).string(), "", "the file cannot be written", "a directory with room for it");
  }
  std::erase(file_names_, file_name);
  file_names_.push_back(file_name);
}

void OutputDirectory::write(const std::string& file_name, std::string_view text) { write(file_name, bytes_of(text)); }

void OutputDirectory::commit() {
  const std::lock_guard lock(mutex_);
  std::error_code error;
  if (!fs::exists(path_, error)) {
    fs::rename(staging_, path_, error);
    if (!error) staging_.clear();
  } else {
    for (const std::string& name : file_names_) {
      if (name == file_names_.back()) remove_earlier();
      fs::rename(staging_ / name, path_ / name, error);
      if (error) break;
    }
  }
  if (error)
    throw FileError(path_.string(), "", "the results cannot be moved here (" + error.message() + ")",
                    "a writable place");
  made_.clear();
  discard();
}

/// What neither this run wrote nor anything but a run may have written.
void OutputDirectory::remove_earlier() const {
  std::error_code error;
  remove_incomplete();
  std::vector<fs::path> stale;
  for (const std::string& name : set_aside_) stale.push_back(path_ / ("earlier-" + name));
  for (const auto& entry : fs::directory_iterator(path_, error)) {
    const std::string name = entry.path().filename().string();
    if (is_result_ == nullptr || !is_result_(name) || !entry.is_regular_file(error)) continue;
    if (std::ranges::find(file_names_, name) == file_names_.end()) stale.push_back(entry.path());
  }
  for (const fs::path& file : stale) fs::remove(file, error);
}

/// Files of somebody else stay, and their directory.
void OutputDirectory::remove_incomplete() const {
  if (is_result_ == nullptr) return;
  std::error_code error;
  std::vector<fs::path> results;
  for (const auto& entry : fs::directory_iterator(path_ / kIncomplete, error)) {
    if (is_result_(entry.path().filename().string())) results.push_back(entry.path());
  }
  for (const fs::path& file : results) fs::remove(file, error);
  fs::remove(path_ / kIncomplete, error);
}

fs::path OutputDirectory::keep_incomplete() {
  const std::lock_guard lock(mutex_);
  const fs::path place = path_ / kIncomplete;
  std::error_code error;
  fs::create_directory(path_, error);
  remove_incomplete();
  fs::rename(staging_, place, error);
  if (error) {
    throw FileError(place.string(), "", "what was made cannot be kept here (" + error.message() + ")",
                    "a writable place, and no directory of this name");
  }
  staging_.clear();
  made_.clear();
  discard();
  return place;
}

}  // namespace horopter
