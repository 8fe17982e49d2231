// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>

#include "horopter/calib/error.hpp"
#include "horopter/calib/points.hpp"

namespace horopter::calib {
namespace {

std::string read_text(const std::filesystem::path& file, const std::string& expected) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) throw FileError(file.string(), "", "this is a directory", expected);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileError(file.string(), "", "the file is missing or cannot be read", expected);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace

std::vector<PointPair> read_points(const std::filesystem::path& file) {
  const std::string expected = "lines of five numbers: x_mm y_mm z_mm u_px v_px";
  std::istringstream stream(read_text(file, expected));
  std::vector<PointPair> points;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (const auto comment = line.find('#'); comment != std::string::npos) line.erase(comment);
    for (char& c : line) {
      if (c == ',' || c == ';' || c == '\r' || c == '\t') c = ' ';
    }
    std::istringstream words(line);
    std::string word;
    double values[5];
    int count = 0;
    while (words >> word) {
      char* end = nullptr;
      const double value = std::strtod(word.c_str(), &end);
      if (end == word.c_str() || *end != 0) {
        throw FileError(file.string(), fmt::format("line {}", number), "'" + word + "' is not a number", expected);
      }
      if (!std::isfinite(value)) {
        throw FileError(file.string(), fmt::format("line {}", number), "'" + word + "' is not finite", expected);
      }
      if (count < 5) values[count] = value;
      ++count;
    }
    if (count == 0) continue;
    if (count != 5) {
      throw FileError(file.string(), fmt::format("line {}", number), fmt::format("{} numbers", count), expected);
    }
    points.push_back({{values[0], values[1], values[2]}, {values[3], values[4]}});
  }
  if (points.empty()) throw FileError(file.string(), "", "no points", expected);
  return points;
}

Sensor read_sensor(const std::filesystem::path& file) {
  const std::string expected = "a map width_px, height_px, dx_mm, dy_mm, cx_px, cy_px and, if known, sx";
  const std::string text = read_text(file, expected);
  YAML::Node node;
  try {
    node = YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw FileError(file.string(), fmt::format("line {}", error.mark.line + 1), "not YAML (" + error.msg + ")",
                    expected);
  }
  if (node.IsMap() && node["sensor"]) node.reset(node["sensor"]);
  static constexpr std::string_view kNames[] = {"width_px", "height_px", "dx_mm", "dy_mm", "cx_px", "cy_px", "sx"};
  double values[7] = {0, 0, 0, 0, 0, 0, 1};
  bool has_sx = false;
  const auto store = [&](int index, const YAML::Node& value) {
    const bool positive = index != 4 && index != 5;
    double number = NAN;
    if (!value.IsScalar() || !YAML::convert<double>::decode(value, number) || !std::isfinite(number) ||
        (positive && !(number > 0)) || (index < 2 && (number != std::floor(number) || number > 1e6))) {
      throw FileError(file.string(), std::string(kNames[index]),
                      value.IsScalar() ? "'" + value.Scalar() + "'" : "not a number",
                      index < 2  ? "a whole number of pixels"
                      : positive ? "a number above 0"
                                 : "a number");
    }
    values[index] = number;
    has_sx = has_sx || index == 6;
  };
  if (node.IsMap()) {
    // A misspelt sx would be taken for 1.
    for (const auto& entry : node) {
      if (std::ranges::find(kNames, entry.first.Scalar()) == std::end(kNames)) {
        throw FileError(file.string(), fmt::format("line {}", entry.first.Mark().line + 1),
                        "'" + entry.first.Scalar() + "' is not known", expected);
      }
    }
    for (int i = 0; i < 7; ++i) {
      const YAML::Node value = node[std::string(kNames[i])];
      if (value.IsDefined() && !value.IsNull()) {
        store(i, value);
      } else if (i < 6) {
        throw FileError(file.string(), std::string(kNames[i]), "missing", expected);
      }
    }
  } else {
    // The same numbers in that order, as a list or on one line.
    if (node.IsScalar()) {
      YAML::Node list;
      std::istringstream words(node.Scalar());
      std::string word;
      while (words >> word) list.push_back(word);
      node.reset(list);
    }
    if (!node.IsSequence() || node.size() < 6 || node.size() > 7) {
      throw FileError(file.string(), "", "neither a map nor six or seven numbers", expected);
    }
    for (std::size_t i = 0; i < node.size(); ++i) store(static_cast<int>(i), node[i]);
  }
  Sensor sensor{static_cast<int>(values[0]),
                static_cast<int>(values[1]),
                values[2],
                values[3],
                values[4],
                values[5],
                std::nullopt};
  if (has_sx) sensor.sx = values[6];
  return sensor;
}

}  // namespace horopter::calib
