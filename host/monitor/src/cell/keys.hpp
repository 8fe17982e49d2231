// SPDX-License-Identifier: Apache-2.0
// A map of cell.yaml, read strictly: keys that nothing asked for are errors.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "horopter/base/error.hpp"
#include "horopter/calib/yaml.hpp"

namespace horopter::monitor {

class Keys {
 public:
  Keys(const std::string& file, const YAML::Node& node, std::string path)
      : file_(file), node_(node), path_(std::move(path)) {
    if (!node_.IsMap()) calib::yaml::fail(file_, node_, path_, "", "a map");
  }

  [[nodiscard]] std::string path(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
  bool has(const std::string& key) {
    known_.insert(key);
    return node_[key].IsDefined();
  }
  YAML::Node get(const std::string& key, const std::string& expected) {
    known_.insert(key);
    YAML::Node node = node_[key];
    if (!node.IsDefined() || node.IsNull()) calib::yaml::fail(file_, node_, path(key), "missing", expected);
    return node;
  }
  [[nodiscard]] const YAML::Node& node() const { return node_; }
  [[noreturn]] void fail(const std::string& key, const std::string& found, const std::string& expected) const {
    calib::yaml::fail(file_, node_[key].IsDefined() ? node_[key] : node_, path(key), found, expected);
  }
  Keys map(const std::string& key) { return {file_, get(key, "a map"), path(key)}; }

  std::string text(const std::string& key, const std::string& expected) {
    const YAML::Node node = get(key, expected);
    if (!node.IsScalar() || node.Scalar().empty()) fail(key, "", expected);
    return node.Scalar();
  }
  std::string text_or(const std::string& key, const std::string& otherwise, const std::string& expected) {
    return has(key) ? text(key, expected) : otherwise;
  }
  std::string word(const std::string& key, const std::string& otherwise, const std::vector<std::string>& words) {
    if (!has(key)) return otherwise;
    std::string expected;
    for (const std::string& one : words) expected += (expected.empty() ? "" : " or ") + one;
    std::string found = text(key, expected);
    if (std::ranges::find(words, found) == words.end()) fail(key, "", expected);
    return found;
  }
  double number(const std::string& key, double smallest, double largest, const std::string& unit) {
    const std::string expected = fmt::format("{:g} to {:g}{}{}", smallest, largest, unit.empty() ? "" : " ", unit);
    const YAML::Node node = get(key, expected);
    if (!node.IsScalar()) fail(key, "", expected);
    const double value = calib::yaml::number(file_, node, path(key));
    if (!(value >= smallest && value <= largest)) fail(key, "", expected);
    return value;
  }
  int whole(const std::string& key, int smallest, int largest, const std::string& unit) {
    const double value = number(key, smallest, largest, unit);
    if (value != std::floor(value)) fail(key, "", fmt::format("a whole number, {} to {}", smallest, largest));
    return static_cast<int>(value);
  }
  bool flag(const std::string& key, bool otherwise) {
    if (!has(key)) return otherwise;
    bool value = false;
    if (!YAML::convert<bool>::decode(node_[key], value)) fail(key, "", "true or false");
    return value;
  }
  /// A file that is there, named beside cell.yaml.
  std::filesystem::path existing(const std::string& key, const std::string& expected) {
    const std::string name = text(key, expected);
    std::filesystem::path place = beside(name);
    std::error_code error;
    if (!std::filesystem::is_regular_file(place, error)) {
      fail(key, fmt::format("there is no file '{}'", place.string()), expected);
    }
    return place;
  }
  [[nodiscard]] std::filesystem::path beside(const std::string& name) const {
    return std::filesystem::path(file_).parent_path() / name;
  }
  /// Two keys that mean the same must not stand together.
  void exclude(const std::string& one, const std::string& another) {
    if (has(one) && has(another)) fail(another, fmt::format("also '{}'", one), "one of the two");
  }
  void finish() const {
    for (const auto& item : node_) {
      const std::string key = item.first.IsScalar() ? item.first.Scalar() : "";
      if (known_.contains(key)) continue;
      std::string expected;
      for (const std::string& name : known_) expected += (expected.empty() ? "" : ", ") + name;
      calib::yaml::fail(file_, item.first, path_, "unknown key '" + key + "'", expected);
    }
  }

 private:
  const std::string& file_;
  YAML::Node node_;
  std::string path_;
  std::set<std::string> known_;
};

}  // namespace horopter::monitor
