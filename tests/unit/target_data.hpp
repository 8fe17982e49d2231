// SPDX-License-Identifier: Apache-2.0
// Shared data that is no part of the project: $HOROPTER_DATA, or data beside the repository. Tests say that they are
// skipped where it is absent.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace horopter::test {

/// The path of a file or folder of the shared data; nothing, and a line that says so, when it is not there.
inline std::optional<std::filesystem::path> shared_data(const std::string& name) {
  namespace fs = std::filesystem;
  if (const char* root = std::getenv("HOROPTER_DATA")) {
    if (fs::exists(fs::path(root) / name)) return fs::path(root) / name;
  } else {
    for (fs::path folder = fs::path(__FILE__).parent_path(); folder.has_relative_path(); folder = folder.parent_path())
      if (fs::exists(folder / "shared/data" / name)) return folder / "shared/data" / name;
  }
  std::printf("skipped: no %s in $HOROPTER_DATA or ../shared/data\n", name.c_str());
  return std::nullopt;
}

/// The chessboard pictures of Debian's package opencv-doc.
inline std::optional<std::filesystem::path> opencv_doc(const std::string& name) {
  const std::filesystem::path path = std::filesystem::path("/usr/share/doc/opencv-doc/examples/data") / name;
  if (std::filesystem::exists(path)) return path;
  std::printf("skipped: no %s of the package opencv-doc\n", name.c_str());
  return std::nullopt;
}

}  // namespace horopter::test
