// SPDX-License-Identifier: Apache-2.0
#include "horopter/image/output.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "horopter/base/error.hpp"

namespace horopter {
namespace {

namespace fs = std::filesystem;

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

void write_plain(const fs::path& path, std::span<const std::uint8_t> bytes) {
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) throw FileError(path.string(), "", "the file cannot be written", "a directory with room for it");
}

/// A hidden name beside a place, of this process. Those of processes that were killed are taken away.
fs::path temporary_beside(const fs::path& place, const std::string& suffix = "") {
  const std::string prefix = fmt::format(".{}.", place.filename().string());
  const fs::path parent = place.parent_path().empty() ? "." : place.parent_path();
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(parent, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix) || !name.ends_with(suffix)) continue;
    const char* const end = name.data() + name.size() - suffix.size();
    pid_t process = 0;
    const auto [rest, problem] = std::from_chars(name.data() + prefix.size(), end, process);
    if (problem != std::errc{} || rest != end || process <= 0) continue;
    if (::kill(process, 0) != 0 && errno == ESRCH) fs::remove_all(entry.path(), error);
  }
  return place.parent_path() / fmt::format("{}{}{}", prefix, ::getpid(), suffix);
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
  const fs::path temporary = temporary_beside(path);
  std::error_code error;
  try {
    write_plain(temporary, bytes);
    fs::rename(temporary, path, error);
  } catch (...) {
    fs::remove(temporary, error);
    throw FileError(path.string(), "", "the file cannot be written", "a directory that exists and has room");
  }
  if (error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw FileError(path.string(), "", "the file cannot be written (" + error.message() + ")", "a writable place");
  }
}

void write_file(const fs::path& path, std::string_view text) { write_file(path, bytes_of(text)); }

std::vector<std::uint8_t> encode_png(const Image& image) {
  return encode(cv::Mat(image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.pixels.data())));
}

std::vector<std::uint8_t> encode_png_bgr(int width, int height, std::span<const std::uint8_t> bgr) {
  return encode(cv::Mat(height, width, CV_8UC3, const_cast<std::uint8_t*>(bgr.data())));
}

OutputDirectory::OutputDirectory(const fs::path& path, IsResult is_result)
    : path_(fs::absolute(path).lexically_normal()), is_result_(is_result) {
  if (!path_.has_filename()) path_ = path_.parent_path();
  std::error_code error;
  if (fs::exists(path_, error) && !fs::is_directory(path_, error)) {
    throw FileError(path_.string(), "", "this is a file", "a directory for the results, new or existing");
  }
  for (fs::path parent = path_.parent_path(); !parent.empty() && !fs::exists(parent, error);
       parent = parent.parent_path()) {
    made_.push_back(parent);
  }
  for (auto parent = made_.rbegin(); parent != made_.rend(); ++parent) fs::create_directory(*parent, error);
  staging_ = temporary_beside(path_, ".partial");
  fs::remove_all(staging_, error);
  if (!fs::create_directory(staging_, error) || error) {
    const std::error_code reason = error;
    for (const fs::path& parent : made_) fs::remove(parent, error);
    throw FileError(path_.string(), "", "the directory cannot be made (" + reason.message() + ")", "a writable place");
  }
}

OutputDirectory::~OutputDirectory() {
  std::error_code error;
  if (staging_.empty()) return;
  fs::remove_all(staging_, error);
  for (const fs::path& parent : made_) fs::remove(parent, error);  // only if empty
}

void OutputDirectory::set_aside(const std::string& file_name) {
  std::error_code error;
  if (fs::exists(path_ / file_name, error)) fs::rename(path_ / file_name, path_ / ("earlier-" + file_name), error);
  if (error) {
    throw FileError((path_ / file_name).string(), "",
                    "this file of an earlier run cannot be renamed (" + error.message() + ")", "a writable place");
  }
}

void OutputDirectory::write(const std::string& file_name, std::span<const std::uint8_t> bytes) {
  write_plain(staging_ / file_name, bytes);
  if (std::ranges::find(file_names_, file_name) == file_names_.end()) file_names_.push_back(file_name);
}

void OutputDirectory::write(const std::string& file_name, std::string_view text) { write(file_name, bytes_of(text)); }

void OutputDirectory::commit() {
  std::error_code error;
  if (!fs::exists(path_, error)) {
    fs::rename(staging_, path_, error);
  } else {
    if (is_result_ != nullptr) {
      std::vector<fs::path> stale;
      for (const auto& entry : fs::directory_iterator(path_, error)) {
        if (entry.is_regular_file() && is_result_(entry.path().filename().string())) stale.push_back(entry.path());
      }
      for (const fs::path& file : stale) fs::remove(file, error);
    }
    for (const std::string& name : file_names_) {
      fs::rename(staging_ / name, path_ / name, error);
      if (error) break;
    }
    std::error_code ignored;
    fs::remove_all(staging_, ignored);
  }
  if (error)
    throw FileError(path_.string(), "", "the results cannot be moved here (" + error.message() + ")",
                    "a writable place");
  staging_.clear();
}

}  // namespace horopter
