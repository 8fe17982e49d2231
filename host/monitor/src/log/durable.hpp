// SPDX-License-Identifier: Apache-2.0
// Files that are on the disk when the call returns; libsodium, and its SHA-256.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace horopter::monitor {

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int file = -1) : file_(file) {}
  ~Descriptor() { reset(); }
  Descriptor(Descriptor&& other) noexcept : file_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    if (this != &other) reset(other.release());
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int get() const { return file_; }
  [[nodiscard]] bool valid() const { return file_ >= 0; }
  int release() {
    const int file = file_;
    file_ = -1;
    return file;
  }
  void reset(int file = -1);

 private:
  int file_;
};

/// All bytes, or why not: the number of the error. 0 = written.
int write_all(int file, std::string_view bytes);
std::filesystem::path directory_of(const std::filesystem::path& path);
/// What a directory lists is on the disk.
void sync_directory(const std::filesystem::path& directory);
/// Writes a new file beside its place, never open to more than `mode` says, and renames it. One that was there keeps its
/// owner, its group, its mode and the links to it. 0, or the number of the error; nothing is left then.
int write_durably(const std::filesystem::path& path, std::span<const std::uint8_t> bytes, unsigned mode = 0640);
int write_durably(const std::filesystem::path& path, std::string_view text, unsigned mode = 0640);
/// Names that write_durably gives to what is not complete.
bool is_partial(const std::filesystem::path& path);

/// Before what of libsodium is not SHA-256. Throws Error.
void begin_sodium();
/// 64 hexadecimal digits.
std::string sha256(std::span<const std::uint8_t> bytes);
std::string sha256(std::string_view text);

}  // namespace horopter::monitor
