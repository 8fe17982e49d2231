// SPDX-License-Identifier: Apache-2.0
#include "horopter/base/file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "horopter/base/error.hpp"

namespace horopter {

std::vector<std::uint8_t> read_file(const std::filesystem::path& path, const std::string& expected) {
  constexpr std::size_t kPart = std::size_t{1} << 20;
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  const auto fail = [&](const std::string& found) { throw FileError(path.string(), "", found, expected); };
  if (!std::filesystem::exists(status)) fail("there is no such file");
  if (std::filesystem::is_directory(status)) fail("this is a directory");
  if (std::filesystem::is_character_file(status) || std::filesystem::is_block_file(status)) fail("this is a device");
  std::ifstream stream(path, std::ios::binary);
  std::vector<std::uint8_t> bytes;
  while (stream) {
    if (bytes.size() >= kLargestFile) fail(fmt::format("more than {} MiB", kLargestFile >> 20));
    const std::size_t old = bytes.size();
    bytes.resize(old + kPart);
    stream.read(reinterpret_cast<char*>(bytes.data() + old), kPart);
    bytes.resize(old + static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.is_open() || stream.bad()) fail("the file cannot be read");
  if (bytes.empty()) fail("the file is empty");
  return bytes;
}

}  // namespace horopter
