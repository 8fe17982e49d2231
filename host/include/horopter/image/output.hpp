// SPDX-License-Identifier: Apache-2.0
// Output that is complete or not there: written beside its place, renamed when done.
#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "horopter/base/ending.hpp"
#include "horopter/image/image.hpp"

namespace horopter {

/// Where symbolic links lead, also to what is not there yet.
std::filesystem::path behind_links(std::filesystem::path path);
/// Gives an open file the owner, the group and the mode of another one; false where not all of them can be given.
bool take_after(int file, const struct stat& other);

/// Writes a file under a temporary name in the same directory and renames it: one that was there keeps its owner and
/// group, where that may be, and its mode, links to it stay. Devices and pipes are written to as they are. Throws
/// FileError; nothing is left then.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

std::vector<std::uint8_t> encode_png(const Image& image);
/// Interleaved blue, green, red.
std::vector<std::uint8_t> encode_png_bgr(int width, int height, std::span<const std::uint8_t> bgr);

/// A directory of results. Files are collected in a hidden directory, within `path` where that exists (it may be a mount
/// point, or stand where nothing else may be written), else beside it. commit() moves them into place when all are
/// there, and then removes the results of an earlier run (files of the names given by `is_result`). Without commit(),
/// and when a signal ends the program, nothing changes but what was set aside. What killed processes left is taken away.
class OutputDirectory {
 public:
  using IsResult = bool (*)(const std::string& file_name);

  /// Throws FileError when `path` is a file or cannot be written to.
  explicit OutputDirectory(const std::filesystem::path& path, IsResult is_result = nullptr);
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  /// A file of an earlier run that nobody must take for one of this run, should it fail or be killed: from now on, and
  /// until commit(), it is called earlier-…
  void set_aside(const std::string& file_name);
  /// Takes back set_aside(): there is no run.
  void put_back() noexcept;
  /// Throws FileError where the file cannot be written, or `file_name` is not that of a file in the directory itself.
  void write(const std::string& file_name, std::span<const std::uint8_t> bytes);
  void write(const std::string& file_name, std::string_view text);
  /// The file that was written last appears last.
  void commit();
  /// Instead of commit(): what was written goes into the directory `incomplete` within `path`, in place of what an
  /// earlier failure left there; commit() takes that away. Returns the place.
  std::filesystem::path keep_incomplete();

 private:
  void discard();
  void remove_earlier() const;
  void remove_incomplete() const;

  std::filesystem::path path_;
  std::filesystem::path staging_;  ///< empty once it is gone
  int file_ = -1;                  ///< `staging_`, open and locked while there is one
  IsResult is_result_;
  std::vector<std::string> file_names_;
  std::vector<std::string> set_aside_;
  std::vector<std::string> moved_;           ///< of these, those that there were
  std::vector<std::filesystem::path> made_;  ///< parent directories that this object made
  std::recursive_mutex mutex_;
  std::optional<BeforeEnding> before_ending_;
};

}  // namespace horopter
