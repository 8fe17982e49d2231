// SPDX-License-Identifier: Apache-2.0
// YAML whose errors name the file, the line, the key, what stands there and what was expected. All functions throw
// FileError; `file` is the name that it carries. Needs yaml-cpp.
#pragma once

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace horopter::calib::yaml {

/// The root of a text. A key that stands twice in a map is an error, and so are a second document, aliases that contain
/// themselves or stand for very much, and nesting beyond all use.
YAML::Node parse(const std::string& file, const std::string& text, const std::string& expected);

/// "line 3, column 5: what", as errors name the place of a node.
std::string place(const YAML::Node& node, const std::string& what);

/// An error at the node. `found` empty: the node itself is described.
[[noreturn]] void fail(const std::string& file, const YAML::Node& node, const std::string& what,
                       const std::string& found, const std::string& expected);

/// The value of `key`, which must be there.
YAML::Node member(const std::string& file, const YAML::Node& map, const std::string& key, const std::string& expected);

/// A finite number.
double number(const std::string& file, const YAML::Node& node, const std::string& what);

/// The finite numbers of nested lists, in order. `count` 0: any number of them.
std::vector<double> numbers(const std::string& file, const YAML::Node& node, const std::string& what,
                            std::size_t count);

/// `map` must be a map whose keys are all in `known`. One that is not known is an error, because leaving it out would
/// change what the file says.
void check_keys(const std::string& file, const YAML::Node& map, const std::set<std::string>& known,
                const std::string& what);

}  // namespace horopter::calib::yaml
