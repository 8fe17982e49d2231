// SPDX-License-Identifier: Apache-2.0
// What the thesis says, beside what a study found: rows of STUDY.md. A statement is data, and one evaluator makes the
// verdict from its numbers and its limits. The page itself is made in page.hpp.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace horopter::cli {

/// A number that was measured, or words that only stand beside numbers.
struct Measured {
  template <class T>
    requires std::integral<T> || std::floating_point<T>
  Measured(T value) : number(static_cast<double>(value)) {}
  Measured(std::string text) : words(std::move(text)), is_number(false) {}
  Measured(const char* text) : Measured(std::string(text)) {}

  double number = std::numeric_limits<double>::quiet_NaN();
  std::string words;
  bool is_number = true;
};
using AllMeasured = std::vector<Measured>;

/// One side of a comparison: a constant, or factor · (the measured number at a place) + offset.
struct Term {
  constexpr Term(double constant) : offset(constant) {}
  constexpr Term(std::size_t index, double by, double plus) : place(index), factor(by), offset(plus) {}
  double of(const AllMeasured& measured) const {
    return factor == 0 ? offset : factor * measured.at(place).number + offset;
  }

  std::size_t place = 0;
  double factor = 0;
  double offset = 0;
};
constexpr Term operator*(double factor, const Term& term) {
  return {term.place, factor * term.factor, factor * term.offset};
}
constexpr Term operator+(const Term& term, double offset) { return {term.place, term.factor, term.offset + offset}; }

/// The measured numbers of a statement, in their order: `first < 0.2`, `first < second && second < third`.
namespace measured {
// NOLINTNEXTLINE(readability-identifier-naming): words of the limits' little language, as `always` and `never` below
inline constexpr Term first{0, 1, 0}, second{1, 1, 0}, third{2, 1, 0}, fourth{3, 1, 0}, fifth{4, 1, 0};
}  // namespace measured

/// Limits on measured numbers.
struct Rule {
  std::function<bool(const AllMeasured&)> holds;
};
inline Rule operator<(const Term& a, const Term& b) {
  return {[=](const AllMeasured& measured) { return a.of(measured) < b.of(measured); }};
}
inline Rule operator<=(const Term& a, const Term& b) {
  return {[=](const AllMeasured& measured) { return a.of(measured) <= b.of(measured); }};
}
inline Rule operator>(const Term& a, const Term& b) { return b < a; }
inline Rule operator>=(const Term& a, const Term& b) { return b <= a; }
inline Rule operator&&(const Rule& a, const Rule& b) {
  return {[=](const AllMeasured& measured) { return a.holds(measured) && b.holds(measured); }};
}
inline Rule operator||(const Rule& a, const Rule& b) {
  return {[=](const AllMeasured& measured) { return a.holds(measured) || b.holds(measured); }};
}
/// At most `by` away from `expected`.
inline Rule near(const Term& a, double expected, double by) {
  return {[=](const AllMeasured& measured) { return std::abs(a.of(measured) - expected) <= by; }};
}
// NOLINTBEGIN(readability-identifier-naming)
inline const Rule always{[](const AllMeasured&) { return true; }};
inline const Rule never{[](const AllMeasured&) { return false; }};
// NOLINTEND(readability-identifier-naming)

/// When a statement is confirmed, and when it is partly, which is asked only where it is not.
struct Limits {
  Rule confirmed;
  Rule partly = never;
};

/// One thing that the thesis says, and what decides whether we found it.
struct Statement {
  std::string quote;     ///< what it says
  AllMeasured measured;  ///< numbers for `figure` and `limits`
  std::string figure;    ///< what we found, in fmt's format; a word why, where that may not be what the thesis says
  std::string rule;      ///< `limits` in words
  Limits limits;
  std::string headline = {};  ///< the statement in a few words, if it belongs in the summary
};

/// {"section", "statement", "figure", "verdict", "rule", "headline"}: a statement of a section of the thesis, evaluated.
nlohmann::json evaluate(const std::string& section, const Statement& statement);

}  // namespace horopter::cli
