// SPDX-License-Identifier: Apache-2.0
#include "yaml.hpp"

#include <fmt/format.h>

#include <cmath>

#include "horopter/base/error.hpp"
#include "horopter/base/file.hpp"
#include "horopter/calib/error.hpp"
#include "horopter/calib/yaml.hpp"

namespace horopter::yaml {
namespace {

std::string place(const YAML::Mark& mark) {
  return mark.is_null() ? "" : fmt::format("line {}, column {}", mark.line + 1, mark.column + 1);
}

std::string kind(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Null:
      return "nothing";
    case YAML::NodeType::Scalar:
      return "'" + node.Scalar() + "'";
    case YAML::NodeType::Sequence:
      return fmt::format("a list of {}", node.size());
    case YAML::NodeType::Map:
      return "a map";
    default:
      return "nothing";
  }
}

}  // namespace

YAML::Node load(const std::filesystem::path& path, const std::string& expected) {
  const auto bytes = read_file(path, expected);
  try {
    const YAML::Node node = calib::yaml::parse(path.string(), {bytes.begin(), bytes.end()}, expected);
    if (!node.IsMap()) throw FileError(path.string(), place(node.Mark()), kind(node), expected);
    return node;
  } catch (const calib::FileError& error) {
    throw Error(ExitStatus::bad_file, error.what());
  }
}

void fail(const std::string& file, const YAML::Node& node, const std::string& what, const std::string& found,
          const std::string& expected) {
  const std::string where = place(node.Mark());
  throw FileError(file, where.empty() ? what : where + ": " + what, found.empty() ? kind(node) : found, expected);
}

YAML::Node member(const std::string& file, const YAML::Node& map, const std::string& key, const std::string& expected) {
  if (!map.IsMap()) fail(file, map, "", "", "a map with '" + key + "'");
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

}  // namespace horopter::yaml
