// SPDX-License-Identifier: Apache-2.0
// YAML with errors that name file and line.
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <string>

namespace horopter::yaml {

/// Throws FileError when missing, empty or not YAML.
YAML::Node load(const std::filesystem::path& path, const std::string& expected);
[[noreturn]] void fail(const std::string& file, const YAML::Node& node, const std::string& what,
                       const std::string& found, const std::string& expected);
/// The value of `key`, which must be there.
YAML::Node member(const std::string& file, const YAML::Node& map, const std::string& key, const std::string& expected);
/// A finite number.
double number(const std::string& file, const YAML::Node& node, const std::string& what);

}  // namespace horopter::yaml
