// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/text_file.hpp"

#include <fstream>
#include <sstream>

#include "horopter/calib/error.hpp"

namespace horopter::calib {

std::string read_text(const std::filesystem::path& file, const std::string& expected) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) throw FileError(file.string(), "", "this is a directory", expected);
  const auto status = std::filesystem::status(file, error);
  if (std::filesystem::is_character_file(status) || std::filesystem::is_block_file(status)) {
    throw FileError(file.string(), "", "this is a device", expected);
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileError(file.string(), "", "the file is missing or cannot be read", expected);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace horopter::calib
