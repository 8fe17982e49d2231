// SPDX-License-Identifier: Apache-2.0
// Text files, whole.
#pragma once

#include <filesystem>
#include <string>

namespace horopter::calib {

/// All bytes of a file. Throws FileError, which says that `expected` was expected, when there is no such file, or when
/// it is a directory or cannot be read.
std::string read_text(const std::filesystem::path& file, const std::string& expected);

}  // namespace horopter::calib
