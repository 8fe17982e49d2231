// SPDX-License-Identifier: Apache-2.0
// Reading files whole, with errors that name them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace horopter {

inline constexpr std::size_t kLargestFile = std::size_t{512} << 20;  ///< bytes

/// The file's bytes. Throws FileError when missing, a directory, a device, unreadable, empty or larger than kLargestFile.
std::vector<std::uint8_t> read_file(const std::filesystem::path& path, const std::string& expected);

}  // namespace horopter
