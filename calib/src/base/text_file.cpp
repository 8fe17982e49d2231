// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/text_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "horopter/calib/error.hpp"

namespace horopter::calib {

std::string read_text(const std::filesystem::path& file, const std::string& expected) {
  constexpr std::size_t kPart = std::size_t{1} << 20;
  const auto fail = [&](const std::string& found) { throw FileError(file.string(), "", found, expected); };
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) fail("there is no such file");
  if (std::filesystem::is_directory(status)) fail("this is a directory");
  if (std::filesystem::is_character_file(status) || std::filesystem::is_block_file(status)) fail("this is a device");
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  while (stream) {
    if (text.size() >= kLargestFile) fail(fmt::format("more than {} MiB", kLargestFile >> 20));
    const std::size_t old = text.size();
    text.resize(old + kPart);
    stream.read(text.data() + old, kPart);
    text.resize(old + static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.is_open() || stream.bad()) fail("the file cannot be read");
  return text;
}

}  // namespace horopter::calib
