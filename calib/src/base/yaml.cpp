// SPDX-License-Identifier: Apache-2.0
#include "horopter/calib/yaml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "horopter/calib/error.hpp"

namespace horopter::calib::yaml {
namespace {

std::string line_and_column(const YAML::Mark& mark) {
  return mark.is_null() ? "" : fmt::format("line {}, column {}", mark.line + 1, mark.column + 1);
}

std::string describe(const YAML::Node& node) {
  if (!node.IsDefined() || node.IsNull()) return "nothing";
  if (node.IsScalar()) return "'" + node.Scalar() + "'";
  return node.IsMap() ? "a map" : fmt::format("a list of {}", node.size());
}

void append_numbers(std::vector<double>& values, const std::string& file, const YAML::Node& node,
                    const std::string& what) {
  if (!node.IsSequence()) {
    values.push_back(number(file, node, what));
    return;
  }
  for (const YAML::Node& inner : node) append_numbers(values, file, inner, what);
}

}  // namespace

YAML::Node parse(const std::string& file, const std::string& text, const std::string& expected) {
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw FileError(file, line_and_column(error.mark), "not YAML (" + error.msg + ")", expected);
  }
}

std::string place(const YAML::Node& node, const std::string& what) {
  const std::string where = line_and_column(node.Mark());
  return where.empty() || what.empty() ? where + what : where + ": " + what;
}

void fail(const std::string& file, const YAML::Node& node, const std::string& what, const std::string& found,
          const std::string& expected) {
  throw FileError(file, place(node, what), found.empty() ? describe(node) : found, expected);
}

YAML::Node member(const std::string& file, const YAML::Node& map, const std::string& key, const std::string& expected) {
  if (!map.IsMap()) fail(file, map, key, "its parent is not a map", expected);
  const YAML::Node node = map[key];
  if (!node.IsDefined() || node.IsNull()) fail(file, map, key, "missing", expected);
  return node;
}

double number(const std::string& file, const YAML::Node& node, const std::string& what) {
  double value = NAN;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
    fail(file, node, what, "", "a finite number");
  }
  return value;
}

std::vector<double> numbers(const std::string& file, const YAML::Node& node, const std::string& what,
                            std::size_t count) {
  const std::string expected = count > 0 ? fmt::format("{} numbers", count) : "numbers";
  if (!node.IsSequence()) fail(file, node, what, "", "a list of " + expected);
  std::vector<double> values;
  append_numbers(values, file, node, what);
  if (count > 0 && values.size() != count) {
    fail(file, node, what, fmt::format("{} numbers", values.size()), expected);
  }
  return values;
}

void check_keys(const std::string& file, const YAML::Node& map, const std::set<std::string>& known,
                const std::string& what) {
  if (!map.IsMap()) fail(file, map, what, "", "a map");
  std::set<std::string> seen;
  for (const auto& item : map) {
    const std::string key = item.first.IsScalar() ? item.first.Scalar() : "?";
    if (!seen.insert(key).second) fail(file, item.first, what, "'" + key + "' stands there twice", "each key once");
    if (known.contains(key)) continue;
    fail(file, item.first, what, "'" + key + "' is not known", fmt::format("{}", fmt::join(known, ", ")));
  }
}

}  // namespace horopter::calib::yaml
