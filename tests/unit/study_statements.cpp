// SPDX-License-Identifier: Apache-2.0
// Statements of the study: the evaluator's verdicts, at their limits.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "study/commands/statements.hpp"

using namespace horopter::cli;
using namespace horopter::cli::measured;

namespace {

std::string verdict(const AllMeasured& numbers, const Limits& limits) {
  return evaluate("1", {"", numbers, "", "", limits})["verdict"];
}

}  // namespace

TEST_CASE("A statement is confirmed, partly or not confirmed by its limits") {
  const Limits below{first <= 0.1, first < 0.2};
  CHECK(verdict({0.1}, below) == "confirmed");
  CHECK(verdict({0.1001}, below) == "partly");
  CHECK(verdict({0.2}, below) == "not confirmed");
  CHECK(verdict({std::nan("")}, below) == "not confirmed");
  // Nothing is partly so unless it is said when.
  CHECK(verdict({2}, {first < 1}) == "not confirmed");
  CHECK(verdict({2}, {first < 1, always}) == "partly");
}

TEST_CASE("Limits compare numbers with constants and with each other") {
  const AllMeasured numbers{1, 2, 4, "words", 3};
  CHECK(verdict(numbers, {first < second && second < third}) == "confirmed");
  CHECK(verdict(numbers, {first < second && third < second}) == "not confirmed");
  CHECK(verdict(numbers, {third < first || second >= first}) == "confirmed");
  CHECK(verdict(numbers, {2 * first >= second && third <= second + 2}) == "confirmed");
  CHECK(verdict(numbers, {2 * first > second}) == "not confirmed");
  CHECK(verdict(numbers, {third > 2 * (first + 1)}) == "not confirmed");
  CHECK(verdict(numbers, {fifth >= 3 && fifth <= 3}) == "confirmed");
  CHECK(verdict(numbers, {near(second, 2.5, 0.5)}) == "confirmed");
  CHECK(verdict(numbers, {near(second, 2.5, 0.4)}) == "not confirmed");
  // Words are no number, and what is not there is no number either.
  CHECK(verdict(numbers, {fourth <= 0 || fourth >= 0}) == "not confirmed");
  CHECK_THROWS(verdict({1}, {second < 1}));
}

TEST_CASE("A statement's figure prints what was measured") {
  const auto row = evaluate(
      "8.4.2", {"The error is small.", {0.125, 7, "NCC"}, "{2} {1}×{1}: {0:.2f} px", "At most 0.2", {first <= 0.2}});
  CHECK(row["section"] == "8.4.2");
  CHECK(row["statement"] == "The error is small.");
  CHECK(row["figure"] == "NCC 7×7: 0.12 px");
  CHECK(row["rule"] == "At most 0.2");
  CHECK(row["verdict"] == "confirmed");
}
