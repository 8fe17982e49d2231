// SPDX-License-Identifier: Apache-2.0
#include "horopter/image/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <utility>

#include "horopter/base/error.hpp"
#include "horopter/image/mat.hpp"

namespace horopter {
namespace {

namespace fs = std::filesystem;

constexpr const char* kIncomplete = "incomplete";
constexpr std::string_view kPartial = ".partial";

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

fs::path parent_of(const fs::path& place) { return place.parent_path().empty() ? "." : place.parent_path(); }

/// Names that only this program gives, to what is not complete yet: `.NAME.horopter-PROCESS-NUMBER.partial`.
std::string partial_prefix(const std::string& name) {
  constexpr std::size_t kLongest = 200;  // so that the rest has room in a name of 255 bytes
  return "." + name.substr(0, kLongest) + ".horopter-";
}

bool is_partial_of(const std::string& name, std::string_view found) {
  const std::string prefix = partial_prefix(name);
  if (!found.starts_with(prefix) || !found.ends_with(kPartial)) return false;
  found.remove_prefix(prefix.size());
  found.remove_suffix(std::min(kPartial.size(), found.size()));
  return !found.empty() && found.find_first_not_of("0123456789-") == std::string_view::npos;
}

/// The lock lasts as long as this process has `file` open. Process numbers would not do: containers that share a
/// directory have their own.
bool lock(int file) { return ::flock(file, LOCK_EX | LOCK_NB) == 0; }

/// What is open still has this name.
bool is_at(int file, const fs::path& path) {
  struct stat opened{}, named{};
  return ::fstat(file, &opened) == 0 && ::lstat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

struct Partial {
  fs::path path;
  int file = -1;  ///< open, and locked unless the file system has no locks; -1 = it cannot be made, see errno
};

/// `mode`: of a new file or directory, before the umask, with its kind.
Partial make_partial(const fs::path& parent, const std::string& name, mode_t mode) {
  const bool directory = S_ISDIR(mode);
  for (int number = 0;; ++number) {
    Partial made{parent / fmt::format("{}{}-{}{}", partial_prefix(name), ::getpid(), number, kPartial)};
    if (directory && ::mkdir(made.path.c_str(), mode & 0777U) != 0) {
      if (errno == EEXIST) continue;
      return made;
    }
    const int how = directory ? O_RDONLY | O_DIRECTORY : O_WRONLY | O_CREAT | O_EXCL;
    made.file = ::open(made.path.c_str(), how | O_CLOEXEC, mode & 0777U);
    if (made.file < 0) {
      if (errno == (directory ? ENOENT : EEXIST)) continue;
      return made;
    }
    // Before it was locked, another process may have taken it for what a killed one left.
    if ((lock(made.file) || errno != EWOULDBLOCK) && is_at(made.file, made.path)) return made;
    ::close(made.file);
  }
}

/// Takes away what killed processes left.
void remove_leftovers(const fs::path& parent, const std::string& name) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(parent, error)) {
    if (!is_partial_of(name, entry.path().filename().string())) continue;
    const auto type = entry.symlink_status(error).type();
    if (type != fs::file_type::directory && type != fs::file_type::regular) continue;
    const int how = type == fs::file_type::directory ? O_RDONLY | O_DIRECTORY : O_RDWR | O_NONBLOCK;
    const int file = ::open(entry.path().c_str(), how | O_NOFOLLOW | O_CLOEXEC);
    if (file < 0) continue;
    if (lock(file) && is_at(file, entry.path())) fs::remove_all(entry.path(), error);
    ::close(file);
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

fs::path behind_links(fs::path path) {
  constexpr int kMostLinks = 40;  // as Linux
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(path, error); ++i) {
    path = path.parent_path() / fs::read_symlink(path, error);
  }
  return path;
}

bool take_after(int file, const struct stat& other) {
  // One by one: who may not give a file away may still give it to one of his groups.
  const bool group = ::fchown(file, static_cast<uid_t>(-1), other.st_gid) == 0;
  const bool owner = ::fchown(file, other.st_uid, static_cast<gid_t>(-1)) == 0;
  return ::fchmod(file, other.st_mode & 0777U) == 0 && group && owner;
}

void write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
  struct stat earlier{};
  const bool exists = ::stat(path.c_str(), &earlier) == 0;
  if (exists && !S_ISREG(earlier.st_mode) && !S_ISDIR(earlier.st_mode)) {
    if (write_plain(path, bytes)) return;
    throw FileError(path.string(), "", "it cannot be written to", "a device or a pipe that takes the file");
  }
  const fs::path place = behind_links(path);
  const std::string name = place.filename().string();
  remove_leftovers(parent_of(place), name);
  Partial temporary;
  std::mutex mutex;
  const BeforeEnding before_ending([&] {
    mutex.lock();
    std::error_code error;
    if (temporary.file >= 0) fs::remove(temporary.path, error);
  });
  const std::lock_guard guard(mutex);
  temporary = make_partial(parent_of(place), name, exists ? S_IFREG | 0600 : S_IFREG | 0666);
  std::error_code error;
  const bool written = temporary.file >= 0 && write_plain(temporary.path, bytes);
  if (written && exists) take_after(temporary.file, earlier);
  if (written) fs::rename(temporary.path, place, error);
  if (temporary.file >= 0) {
    std::error_code ignored;
    if (!written || error) fs::remove(temporary.path, ignored);
    ::close(std::exchange(temporary.file, -1));
  }
  if (written && !error) return;
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
  Partial staging = make_partial(exists ? path_ : path_.parent_path(), name, S_IFDIR | 0777);
  if (staging.file < 0) {
    const std::string why = std::strerror(errno);
    for (const fs::path& parent : made_) fs::remove(parent, error);
    throw FileError(path_.string(), "", "the directory cannot be made, or written to (" + why + ")",
                    "a writable place");
  }
  staging_ = std::move(staging.path);
  file_ = staging.file;
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
  if (file_ >= 0) ::close(std::exchange(file_, -1));
  if (staging_.empty()) return;
  std::error_code error;
  fs::remove_all(staging_, error);
  staging_.clear();
  for (const fs::path& parent : made_) fs::remove(parent, error);  // only if empty
}

void OutputDirectory::set_aside(const std::string& file_name) {
  set_aside_.push_back(file_name);
  std::error_code error;
  if (fs::exists(path_ / file_name, error)) {
    fs::rename(path_ / file_name, path_ / ("earlier-" + file_name), error);
    if (!error) moved_.push_back(file_name);
  }
  if (error) {
    throw FileError((path_ / file_name).string(), "",
                    "this file of an earlier run cannot be renamed (" + error.message() + ")", "a writable place");
  }
}

void OutputDirectory::put_back() noexcept {
  std::error_code error;
  for (const std::string& name : moved_) fs::rename(path_ / ("earlier-" + name), path_ / name, error);
  moved_.clear();
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
