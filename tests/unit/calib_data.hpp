// SPDX-License-Identifier: Apache-2.0
// Where tests of calibration find public data that is not part of the project.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

namespace horopter::calib::test {

/// $HOROPTER_DATA or ../shared/data beside the source tree; says so when the test is skipped.
inline std::optional<std::filesystem::path> data(const std::string& name) {
  namespace fs = std::filesystem;
  const char* const given = std::getenv("HOROPTER_DATA");
  const fs::path root = given != nullptr ? fs::path(given) : fs::path(HOROPTER_SOURCE_DIR) / ".." / "shared" / "data";
  if (fs::exists(root / name)) return root / name;
  std::cout << "skipped: " << name << " is not in " << (given != nullptr ? "$HOROPTER_DATA" : "../shared/data") << '\n';
  return std::nullopt;
}

/// Images of Debian's package opencv-doc.
inline std::optional<std::filesystem::path> opencv_images() {
  const std::filesystem::path folder = "/usr/share/doc/opencv-doc/examples/data";
  if (std::filesystem::exists(folder / "left01.jpg")) return folder;
  std::cout << "skipped: the images of the package opencv-doc are not installed\n";
  return std::nullopt;
}

}  // namespace horopter::calib::test
