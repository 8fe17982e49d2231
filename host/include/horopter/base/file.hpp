// SPDX-License-Identifier: Apache-2.0
// Reading files whole, with errors that name them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace horopter {

/// The file's bytes. Throws FileError as calib::read_text does, and when the file is empty.
std::vector<std::uint8_t> read_file(const std::filesystem::path& path, const std::string& expected);

}  // namespace horopter
