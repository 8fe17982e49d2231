// SPDX-License-Identifier: Apache-2.0
#include "horopter/base/file.hpp"

#include <fstream>
#include <iterator>
#include <system_error>

#include "horopter/base/error.hpp"

namespace horopter {

std::vector<std::uint8_t> read_file(const std::filesystem::path& path, const std::string& expected) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw FileError(path.string(), "", "there is no such file", expected);
  if (std::filesystem::is_directory(status)) throw FileError(path.string(), "", "this is a directory", expected);
  std::ifstream stream(path, std::ios::binary);
  std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(stream), {});
  if (!stream.is_open() || stream.bad()) throw FileError(path.string(), "", "the file cannot be read", expected);
  if (bytes.empty()) throw FileError(path.string(), "", "the file is empty", expected);
  return bytes;
}

}  // namespace horopter
