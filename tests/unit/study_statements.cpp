// SPDX-License-Identifier: Apache-2.0
// Statements of the study: the evaluator's verdicts, at their limits; curves and orders; and the page of all of them.
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

#include "study/commands/curves.hpp"
#include "study/commands/page.hpp"
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

TEST_CASE("Curves are as far from a line as they bend, orders as alike as their ranks") {
  Points line;
  Points parabola;
  for (int i = 0; i <= 10; ++i) {
    line.emplace_back(0.1 * i, 3 - 0.2 * i);
    parabola.emplace_back(0.1 * i, 0.01 * i * i);
  }
  CHECK(departure_from_line(line) < 1e-12);
  CHECK(departure_from_line(parabola) == Approx(0.15));  // its ends, of a line through its middle; rise 1
  CHECK(std::isinf(departure_from_line({{0, 1}, {1, 1}, {2, 1}})));
  CHECK(rank_correlation({1, 2, 3, 4}, {10, 20, 40, 50}) == 1);
  CHECK(rank_correlation({1, 2, 3, 4}, {4, 3, 2, 1}) == -1);
  CHECK(rank_correlation({1, 2, 3}, {1, 3, 2}) == Approx(0.5));
}

TEST_CASE("The page counts statements by group, and says what holds in the words of its headlines") {
  const auto row = [](const std::string& section, double measured, const std::string& headline) {
    return evaluate(section,
                    {"Says " + section + ".", {measured}, "{:g} | px", "", {first <= 1, first <= 2}, headline});
  };
  nlohmann::ordered_json results;
  results["bits"]["statements"] = {row("10.4.5", 1, "bits are enough"), row("8.4.2", 3, "it is linear")};
  results["operators"]["statements"] = {row("8.4.4", 2, "DSAD is best"), row("8.1", 1, ""), row("8.4.4", 1, "")};
  results["operators"]["fitted"] = {"the blur."};
  results["operators"]["conditions"] = {{"blur", 2}};
  const auto groups = statement_groups(results);
  int found = 0;
  for (const StatementGroup& group : groups) {
    if (group.all() == 0) continue;
    ++found;
    if (group.name != "Criteria") continue;
    CHECK(group.confirmed == 2);
    CHECK(group.partly == 1);
    CHECK(group.not_confirmed == 1);
    REQUIRE(group.rows.size() == 4);
    CHECK(group.rows[0]["section"] == "8.1");  // in the order of the sections
    CHECK(group.rows[1]["study"] == "bits");
  }
  CHECK(found == 2);
  const std::string page = study_markdown(results);
  CHECK_THAT(page, Catch::Contains("5 statements: 3 confirmed, 1 partly, 1 not confirmed.\nThe last column"));
  CHECK_THAT(page, Catch::Contains("| 2 | 1 | 1 | Partly: DSAD is best. **Not confirmed**: it is linear. |\n"));
  CHECK_THAT(page, Catch::Contains("| 1 | 0 | 0 | Confirmed: bits are enough. |\n"));
  CHECK_THAT(page,
             Catch::Contains("- **operators**: the blur.\n") && Catch::Contains("- **operators**: `{\"blur\":2}`"));
  CHECK_THAT(page, Catch::Contains("| 1 | 8.1 | Says 8.1. | 1 \\| px | **confirmed** |"));
  // Numbers go on from group to group.
  CHECK_THAT(page, Catch::Contains("| 5 | 10.4.5 |"));
  // Those that the thesis does not say are named by their numbers.
  nlohmann::json ours = row("8.4.2", 1, "");
  ours["statement"] = "Ours, for a reason: it is.";
  results["operators"]["statements"].emplace_back(ours);
  CHECK_THAT(study_markdown(results), Catch::Contains("1 of them (3) begin with *Ours*"));
  // Nothing may be left out for want of a group.
  results["bits"]["statements"] = {row("10.41", 1, "")};
  CHECK_THROWS_AS(study_markdown(results), std::logic_error);
}
