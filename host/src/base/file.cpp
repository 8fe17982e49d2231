// SPDX-License-Identifier: Apache-2.0
#include "horopter/base/file.hpp"

#include "horopter/base/error.hpp"
#include "horopter/calib/text_file.hpp"

namespace horopter {

std::vector<std::uint8_t> read_file(const std::filesystem::path& path, const std::string& expected) {
  const std::string text = calib::read_text(path, expected);
  if (text.empty()) throw FileError(path.string(), "", "the file is empty", expected);
  return {text.begin(), text.end()};
}

}  // namespace horopter
