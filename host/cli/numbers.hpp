// SPDX-License-Identifier: Apache-2.0
// Options whose values are numbers or sizes: what is expected, in words.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace horopter::cli {

inline CLI::Validator above_zero() {
  const auto check = [](std::string& text) {
    double value = 0;
    const bool good = CLI::detail::lexical_cast(text, value) && value > 0 && std::isfinite(value);
    return good ? std::string() : fmt::format("'{}'; expected a number above 0", text);
  };
  return {check, "POSITIVE"};
}

inline CLI::Validator zero_or_more() {
  const auto check = [](std::string& text) {
    double value = 0;
    const bool good = CLI::detail::lexical_cast(text, value) && value >= 0 && std::isfinite(value);
    return good ? std::string() : fmt::format("'{}'; expected a number of 0 or more", text);
  };
  return {check, "NONNEGATIVE"};
}

inline CLI::Validator any_number() {
  const auto check = [](std::string& text) {
    double value = 0;
    const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
    return good ? std::string() : fmt::format("'{}'; expected a number", text);
  };
  return {check, ""};
}

/// A range that everything which exists is in: what is beyond is in another unit.
inline CLI::Validator within(double smallest, double largest, const std::string& unit) {
  const auto check = [=](std::string& text) {
    const std::string wrong = (smallest > 0 ? above_zero() : smallest < 0 ? any_number() : zero_or_more())(text);
    if (!wrong.empty()) return wrong;
    double value = 0;
    CLI::detail::lexical_cast(text, value);
    const bool good = value >= smallest && value <= largest;
    return good ? std::string() : fmt::format("'{}'; expected {:g} to {:g} {}", text, smallest, largest, unit);
  };
  return {check, ""};
}
/// What cameras can watch.
inline constexpr double kNearest_mm = 20, kFarthest_mm = 1e5;
inline CLI::Validator is_distance_mm() { return within(kNearest_mm, kFarthest_mm, "mm"); }
inline CLI::Validator is_thickness_mm() { return within(0.01, 1e4, "mm"); }
inline CLI::Validator is_tolerance_px() { return within(0.01, 100, "px"); }

inline CLI::Validator at_least_one() {
  const auto check = [](std::string& text) {
    long long value = 0;
    const bool good = CLI::detail::lexical_cast(text, value) && value >= 1;
    return good ? std::string() : fmt::format("'{}'; expected a whole number, 1 or more", text);
  };
  return {check, ""};
}

/// `640x480`; nothing where a text is no such size.
inline std::optional<std::pair<int, int>> size_of(const std::string& text) {
  int width = 0;
  int height = 0;
  const char* const end = text.data() + text.size();
  const auto [middle, wrong_width] = std::from_chars(text.data(), end, width);
  if (wrong_width != std::errc() || middle == end || *middle != 'x') return {};
  const auto [rest, wrong_height] = std::from_chars(middle + 1, end, height);
  if (wrong_height != std::errc() || rest != end || width <= 0 || height <= 0) return {};
  return std::pair{width, height};
}

}  // namespace horopter::cli
