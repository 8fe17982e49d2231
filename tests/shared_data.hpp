// SPDX-License-Identifier: Apache-2.0
// Where tests find public data that is no part of the project. They say that they are skipped where it is absent.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

namespace horopter::test {

/// A file or folder of $HOROPTER_DATA or, without it, of ../shared/data beside the project.
inline std::optional<std::filesystem::path> shared_data(const std::string& name) {
  namespace fs = std::filesystem;
  const char* const given = std::getenv("HOROPTER_DATA");
  const fs::path root = given != nullptr ? fs::path(given) : fs::path(HOROPTER_SOURCE_DIR) / ".." / "shared" / "data";
  if (fs::exists(root / name)) return root / name;
  std::cout << "skipped: " << name << " is not in " << (given != nullptr ? "$HOROPTER_DATA" : "../shared/data") << '\n';
  return std::nullopt;
}

/// The folder with the chessboard pictures of Debian's package opencv-doc.
inline std::optional<std::filesystem::path> opencv_images() {
  std::filesystem::path folder = "/usr/share/doc/opencv-doc/examples/data";
  if (std::filesystem::exists(folder / "left01.jpg")) return folder;
  std::cout << "skipped: the images of the package opencv-doc are not installed\n";
  return std::nullopt;
}

}  // namespace horopter::test
