// SPDX-License-Identifier: Apache-2.0
// What stands behind the keys of cell.yaml.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "horopter/calib/yaml_keys.hpp"

namespace horopter::monitor {

class Keys : public calib::yaml::Keys {
 public:
  using calib::yaml::Keys::Keys;

  Keys map(const std::string& key) { return {file(), get(key, "a map"), path(key)}; }

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
    const double value = calib::yaml::number(file(), node, path(key));
    if (!(value >= smallest && value <= largest)) fail(key, "", expected);
    return value;
  }
  int whole(const std::string& key, int smallest, int largest, const std::string& unit) {
    const double value = number(key, smallest, largest, unit);
    if (value != std::floor(value)) fail(key, "", fmt::format("a whole number, {} to {}", smallest, largest));
    return static_cast<int>(value);
  }
  /// A list of texts, each of which is good.
  std::vector<std::string> texts(const std::string& key, bool (*is_good)(const std::string&),
                                 const std::string& expected) {
    const YAML::Node list = get(key, expected);
    if (!list.IsSequence()) fail(key, "", expected);
    std::vector<std::string> found;
    for (const YAML::Node& one : list) {
      if (!one.IsScalar() || !is_good(one.Scalar())) calib::yaml::fail(file(), one, path(key), "", expected);
      found.push_back(one.Scalar());
    }
    return found;
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
  /// Two keys that mean the same must not stand together.
  void exclude(const std::string& one, const std::string& another) {
    if (has(one) && has(another)) fail(another, fmt::format("also '{}'", one), "one of the two");
  }
};

}  // namespace horopter::monitor
