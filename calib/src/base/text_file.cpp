// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/text_file.hpp"

#include <fstream>
#include <iterator>
#include <system_error>

#include "horopter/calib/error.hpp"

namespace horopter::calib {

std::string read_text(const std::filesystem::path& file, const std::string& expected) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw FileError(file.string(), "", "there is no such file", expected);
  if (std::filesystem::is_directory(status)) throw FileError(file.string(), "", "this is a directory", expected);
  std::ifstream stream(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream.is_open() || stream.bad()) throw FileError(file.string(), "", "the file cannot be read", expected);
  return text;
}

}  // namespace horopter::calib
