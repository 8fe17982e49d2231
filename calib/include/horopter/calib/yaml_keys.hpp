// SPDX-License-Identifier: Apache-2.0
// A map of YAML, read strictly: keys that nothing asked for are errors. All functions throw FileError (yaml.hpp).
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <utility>

#include "horopter/calib/yaml.hpp"

namespace horopter::calib::yaml {

class Keys {
 public:
  /// `path`: of the map in its file, empty for the file's root.
  Keys(const std::string& file, const YAML::Node& node, std::string path)
      : file_(file), node_(node), path_(std::move(path)) {
    if (!node_.IsMap()) yaml::fail(file_, node_, path_, "", "a map");
  }

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const YAML::Node& node() const { return node_; }
  [[nodiscard]] std::string path(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
  /// A file that is named as it stands beside this one.
  [[nodiscard]] std::filesystem::path beside(const std::string& name) const {
    return std::filesystem::path(file_).parent_path() / name;
  }

  bool has(const std::string& key) {
    known_.insert(key);
    return node_[key].IsDefined();
  }
  YAML::Node get(const std::string& key, const std::string& expected) {
    known_.insert(key);
    YAML::Node value = node_[key];
    if (!value.IsDefined() || value.IsNull()) yaml::fail(file_, node_, path(key), "missing", expected);
    return value;
  }
  bool flag(const std::string& key) {
    if (!has(key)) return false;
    bool value = false;
    if (!YAML::convert<bool>::decode(node_[key], value)) fail(key, "", "true or false");
    return value;
  }
  [[noreturn]] void fail(const std::string& key, const std::string& found, const std::string& expected) const {
    yaml::fail(file_, node_[key].IsDefined() ? node_[key] : node_, path(key), found, expected);
  }
  /// All has been asked for.
  void finish() const {
    for (const auto& item : node_) {
      const std::string key = item.first.IsScalar() ? item.first.Scalar() : "";
      if (known_.contains(key)) continue;
      std::string expected;
      for (const std::string& name : known_) expected += (expected.empty() ? "" : ", ") + name;
      yaml::fail(file_, item.first, path_, "unknown key '" + key + "'", expected);
    }
  }

 private:
  const std::string& file_;
  YAML::Node node_;
  std::string path_;
  std::set<std::string> known_;
};

}  // namespace horopter::calib::yaml
