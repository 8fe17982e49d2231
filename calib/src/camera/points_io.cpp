// SPDX-License-Identifier: Apache-2.0
// Points and sensors from files.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>

#include "horopter/calib/error.hpp"
#include "horopter/calib/points.hpp"
#include "horopter/calib/text_file.hpp"
#include "horopter/calib/yaml.hpp"

namespace horopter::calib {
namespace {

constexpr const char* kPointsExpected = "lines of five numbers: x_mm y_mm z_mm u_px v_px";
constexpr const char* kSensorExpected = "a map width_px, height_px, dx_mm, dy_mm, cx_px, cy_px and, if known, sx";

constexpr double kLargest = 1e7;  // mm and px: what is beyond is no measurement

/// The numbers of a line up to a #; `place` stands for the line in errors.
std::vector<double> numbers_of(std::string line, const std::string& file, const std::string& place) {
  if (const auto comment = line.find('#'); comment != std::string::npos) line.erase(comment);
  std::ranges::replace_if(line, [](char c) { return c == ',' || c == ';' || c == '\r' || c == '\t'; }, ' ');
  std::istringstream words(line);
  std::vector<double> values;
  for (std::string word; words >> word;) {
    char* end = nullptr;
    values.push_back(std::strtod(word.c_str(), &end));
    if (end == word.c_str() || *end != 0)
      throw FileError(file, place, "'" + word + "' is not a number", kPointsExpected);
    if (!(std::abs(values.back()) <= kLargest)) {
      throw FileError(file, place, fmt::format("'{}' is not finite, or beyond {:g}", word, kLargest), kPointsExpected);
    }
  }
  return values;
}

/// What a sensor has; beyond, a number is in another unit.
enum class Range { pixel_count, pitch_mm, ratio, place_px };

struct SensorNumber {
  const char* name;
  Range range;
};
constexpr std::array<SensorNumber, 7> kSensorNumbers{{{"width_px", Range::pixel_count},
                                                      {"height_px", Range::pixel_count},
                                                      {"dx_mm", Range::pitch_mm},
                                                      {"dy_mm", Range::pitch_mm},
                                                      {"cx_px", Range::place_px},
                                                      {"cy_px", Range::place_px},
                                                      {"sx", Range::ratio}}};
/// All but sx.
constexpr std::size_t kRequiredNumbers = 6;

double sensor_number(const std::string& file, const YAML::Node& node, const SensorNumber& number) {
  double value = NAN;
  const bool is_number = node.IsScalar() && YAML::convert<double>::decode(node, value) && std::isfinite(value);
  if (number.range == Range::pixel_count && !(is_number && value > 0 && value == std::floor(value) && value <= 1e6)) {
    yaml::fail(file, node, number.name, "", "a whole number of pixels");
  }
  const auto require = [&](double smallest, double largest) {
    if (is_number && value >= smallest && value <= largest) return;
    yaml::fail(file, node, number.name, "", fmt::format("a number, {:g} to {:g}", smallest, largest));
  };
  if (number.range == Range::pitch_mm) require(1e-5, 1);
  if (number.range == Range::ratio) require(0.01, 100);
  if (number.range == Range::place_px) require(-1e6, 1e6);
  return value;
}

/// By name. A misspelt sx must not be taken for 1.
std::vector<double> sensor_of_map(const std::string& file, const YAML::Node& map) {
  std::set<std::string> names;
  for (const SensorNumber& number : kSensorNumbers) names.insert(number.name);
  yaml::check_keys(file, map, names, "");
  std::vector<double> values;
  for (const SensorNumber& number : kSensorNumbers) {
    const YAML::Node value = map[number.name];
    if (value.IsDefined()) {
      values.push_back(sensor_number(file, value, number));
    } else if (values.size() < kRequiredNumbers) {
      throw FileError(file, number.name, "missing", kSensorExpected);
    }
  }
  return values;
}

/// The same numbers in that order, as a list or on one line.
std::vector<double> sensor_of_list(const std::string& file, YAML::Node node) {
  if (node.IsScalar()) {
    YAML::Node list;
    std::istringstream words(node.Scalar());
    for (std::string word; words >> word;) list.push_back(word);
    node.reset(list);
  }
  if (!node.IsSequence() || node.size() < kRequiredNumbers || node.size() > kSensorNumbers.size()) {
    throw FileError(file, "", "neither a map nor six or seven numbers", kSensorExpected);
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < node.size(); ++i) values.push_back(sensor_number(file, node[i], kSensorNumbers[i]));
  return values;
}

}  // namespace

std::vector<PointPair> read_points(const std::filesystem::path& file) {
  std::istringstream stream(read_text(file, kPointsExpected));
  std::vector<PointPair> points;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    const std::string place = fmt::format("line {}", number);
    const std::vector<double> v = numbers_of(line, file.string(), place);
    if (v.empty()) continue;
    if (v.size() != 5) throw FileError(file.string(), place, fmt::format("{} numbers", v.size()), kPointsExpected);
    points.push_back({{v[0], v[1], v[2]}, {v[3], v[4]}});
  }
  if (points.empty()) throw FileError(file.string(), "", "no points", kPointsExpected);
  return points;
}

Sensor read_sensor(const std::filesystem::path& file) {
  YAML::Node node = yaml::parse(file.string(), read_text(file, kSensorExpected), kSensorExpected);
  if (node.IsMap() && node["sensor"]) node.reset(node["sensor"]);
  const std::vector<double> v = node.IsMap() ? sensor_of_map(file.string(), node) : sensor_of_list(file.string(), node);
  Sensor sensor{static_cast<int>(v[0]), static_cast<int>(v[1]), v[2], v[3], v[4], v[5], std::nullopt};
  if (v.size() > kRequiredNumbers) sensor.sx = v[kRequiredNumbers];
  return sensor;
}

}  // namespace horopter::calib
