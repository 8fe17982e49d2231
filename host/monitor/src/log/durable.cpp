// SPDX-License-Identifier: Apache-2.0
#include "durable.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sodium.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "horopter/base/error.hpp"
#include "horopter/image/output.hpp"

namespace horopter::monitor {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPartial = ".partial";

std::string_view text_of(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

fs::path directory_of(const fs::path& path) { return path.parent_path().empty() ? "." : path.parent_path(); }

void Descriptor::reset(int file) {
  if (file_ >= 0) ::close(file_);
  file_ = file;
}

int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    if (written == 0) return ENOSPC;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

void sync_directory(const fs::path& directory) {
  const Descriptor file(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (file.valid()) ::fsync(file.get());
}

int write_durably(const fs::path& path, std::string_view text, unsigned mode) {
  const fs::path place = behind_links(path);
  struct stat earlier{};
  const bool exists = ::stat(place.c_str(), &earlier) == 0 && S_ISREG(earlier.st_mode);
  fs::path temporary = place;
  temporary += fmt::format(".{}{}", ::getpid(), kPartial);
  ::unlink(temporary.c_str());  // of a process that was killed
  Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
  if (!file.valid()) return errno;
  int problem = ::fchmod(file.get(), mode) == 0 ? write_all(file.get(), text) : errno;
  if (problem == 0 && exists && !take_after(file.get(), earlier)) problem = EPERM;
  if (problem == 0 && ::fsync(file.get()) != 0) problem = errno;
  if (problem == 0 && ::rename(temporary.c_str(), place.c_str()) != 0) problem = errno;
  if (problem != 0) ::unlink(temporary.c_str());
  if (problem == 0) sync_directory(directory_of(place));
  return problem;
}

int write_durably(const fs::path& path, std::span<const std::uint8_t> bytes, unsigned mode) {
  return write_durably(path, text_of(bytes), mode);
}

bool is_partial(const fs::path& path) { return path.extension() == kPartial; }

void begin_sodium() {
  if (::sodium_init() < 0) throw Error(ExitStatus::fault, "libsodium cannot be initialised");
}

std::string sha256(std::span<const std::uint8_t> bytes) {
  std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
  crypto_hash_sha256(hash.data(), bytes.data(), bytes.size());
  std::array<char, 2 * crypto_hash_sha256_BYTES + 1> text{};
  sodium_bin2hex(text.data(), text.size(), hash.data(), hash.size());
  return text.data();
}

std::string sha256(std::string_view text) {
  return sha256(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

}  // namespace horopter::monitor
