// SPDX-License-Identifier: Apache-2.0
// Text files, whole.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace horopter::calib {

inline constexpr std::size_t kLargestFile = std::size_t{512} << 20;  ///< bytes

/// All bytes of a file. Throws FileError, which says that `expected` was expected, when there is no such file, or when
/// it is a directory or a device, cannot be read or is larger than kLargestFile.
std::string read_text(const std::filesystem::path& file, const std::string& expected);

}  // namespace horopter::calib
