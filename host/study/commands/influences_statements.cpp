// SPDX-License-Identifier: Apache-2.0
// What 8.3.2, 8.3.3 and Table 8.4 say about noise, scaling and blurring.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "influences.hpp"

namespace horopter::cli {
namespace {

using namespace measured;

int place_in(const std::map<std::string, double>& groups, const std::string& group) {
  const double own = groups.at(group);
  return 1 + static_cast<int>(std::ranges::count_if(groups, [&](const auto& other) { return other.second > own; }));
}

/// Statements of one row of the table, whose figures all begin with the order of the groups.
class InfluenceRow {
 public:
  InfluenceRow(const Scores& scores, std::string influence) : scores_(scores), influence_(std::move(influence)) {}

  void add(const std::string& quote, AllMeasured numbers, const std::string& figure, const std::string& rule,
           const Limits& limits, const std::string& headline = {}) {
    table.push_back({"Table 8.4: " + quote, std::move(numbers),
                     (figure.empty() ? std::string() : figure + ". ") + "Detected: " + scores_.figure(influence_), rule,
                     limits, headline});
  }
  double mean(const char* group) const { return scores_.mean(influence_, group); }
  double at(const char* group, int kernel) const { return scores_.at(influence_, group, kernel); }
  int place(const char* group) const { return scores_.place(influence_, group); }
  int place(const char* group, int kernel) const { return scores_.place(influence_, group, kernel); }
  bool last(const char* group, int kernel) const { return place(group, kernel) == scores_.groups(); }
  /// Of the grey values, the best.
  double intensity() const { return std::max({mean(kGreyRaw), mean(kGreyLow), mean(kZeroLow)}); }

  std::vector<Statement> table;

 private:
  const Scores& scores_;
  std::string influence_;
};

int small_kernels_last(const InfluenceRow& row) {
  int last = 0;
  for (const int kernel : {5, 9, 13, 17}) last += row.last(kHigh, kernel) ? 1 : 0;
  return last;
}

}  // namespace

int Scores::place(const std::string& influence, const std::string& group, int kernel) const {
  return place_in(of_.at(influence).at(kernel), group);
}
int Scores::place(const std::string& influence, const std::string& group) const {
  return place_in(over_kernels_.at(influence), group);
}

std::string Scores::figure(const std::string& influence) const {
  std::vector<std::pair<double, std::string>> ranked;
  for (const auto& [group, score] : over_kernels_.at(influence)) ranked.emplace_back(-score, group);
  std::ranges::sort(ranked);
  std::string text;
  for (const auto& [score, group] : ranked)
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", group, -100 * score);
  return text;
}

std::vector<Statement> noise_statements(const Scores& scores) {
  InfluenceRow noise(scores, "noise");
  int first_of_all = 0;
  int growing = 0;
  for (const int kernel : kInfluencedKernels)
    first_of_all +=
        std::min({noise.place(kGreyRaw, kernel), noise.place(kGreyLow, kernel), noise.place(kZeroLow, kernel)}) == 1
            ? 1
            : 0;
  const std::vector<const char*> all{kGreyRaw, kGreyLow, kZeroLow, kHigh, kDirections, "NISH w=5"};
  for (const char* group : all) growing += noise.at(group, 21) > noise.at(group, 5) ? 1 : 0;
  noise.table.push_back(
      {"In general, large kernels and lowpass-filters reduce noise whereas highpass-filters emphasize it.",
       {growing, all.size(), 100 * noise.mean(kGreyLow), 100 * noise.mean(kGreyRaw), 100 * noise.mean(kHigh)},
       "More is detected with 21×21 than with 5×5 for {} of {} groups; NCC, SAD, SSD: {:.0f} % with the low-pass, {:.0f} % "
       "without; high-pass {:.0f} %",
       "Larger kernels are better for all, and low-pass, none, high-pass are in this order; partly: one of both",
       {first >= second && third > fourth && fourth > fifth, first >= second || (third > fourth && fourth > fifth)},
       "large windows and a low-pass reduce noise"});
  noise.add("noise: intensity based criteria show the best performance.", {first_of_all, kInfluencedKernels.size()},
            "Best with {} of {} kernels", "With all kernels; partly: with half of them",
            {first >= second, 2 * first >= second}, "noise changes criteria on grey values least");
  noise.add("noise: highpass based criteria show the worst results up to a kernel size of 17×17.",
            {small_kernels_last(noise)}, "Last with {} of the 4 kernels from 5×5 to 17×17",
            "With all; partly: with two", {first >= 4, first >= 2},
            "noise changes criteria on high-pass filtered images most");
  noise.add("noise: highpass based criteria are slightly better for kernels larger than 17×17.",
            {noise.place(kHigh, 21), scores.groups(), 100 * noise.at(kHigh, 17), 100 * noise.at(kHigh, 21)},
            "21×21: place {} of {}; detected {:.0f} % with 17×17, {:.0f} % with 21×21",
            "No longer last with 21×21; partly: better than with 17×17", {first<second, fourth> third});
  const int better_than = static_cast<int>((noise.mean("NISH w=5") > noise.mean("NISH w=2.5")) +
                                           (noise.mean("NISH w=5") > noise.mean("NISH w=7")) +
                                           (noise.mean("NISH w=5") > noise.mean("NISH w=9")));
  noise.add("noise: NISH depends on w, medium performance for w = 5, else worse.",
            {better_than, noise.place("NISH w=5"), scores.groups()},
            "w = 5 is better than {} of 3 other w, place {} of {}",
            "Better than all of them, neither first nor last; partly: better than two",
            {first >= 3 && second > 1 && second < third, first >= 2});
  noise.add("noise: DSAD is slightly worse than LP-based criteria.",
            {100 * (noise.mean(kGreyLow) - noise.mean(kDirections))},
            "{:.1f} points less than NCC, SAD, SSD with low-pass", "Up to 15 points less; partly: by more",
            {first > 0 && first <= 15, first > 15});
  return noise.table;
}

std::vector<Statement> scaling_and_blurring_statements(const Scores& scores) {
  InfluenceRow scaling(scores, "scaling");
  const double worst_grey = std::min({scaling.mean(kGreyRaw), scaling.mean(kGreyLow), scaling.mean(kZeroLow)});
  const double best_nish = std::max(
      {scaling.mean("NISH w=2.5"), scaling.mean("NISH w=5"), scaling.mean("NISH w=7"), scaling.mean("NISH w=9")});
  scaling.add("scaling: intensity based criteria show good performance.",
              {worst_grey, scaling.intensity(), best_nish, scaling.mean(kHigh)}, "",
              "All of them above NISH and the high-pass; partly: the best of them",
              {first > third && first > fourth, second > third && second > fourth});
  scaling.add("scaling: highpass based criteria show the absolute worst results.",
              {scaling.place(kHigh), scores.groups()}, "Place {} of {}", "Last; partly: last but one",
              {first >= second, first >= second + -1},
              "a differing scale changes criteria on high-pass filtered images most");
  scaling.add("scaling: NISH shows bad performance, especially for low and high w.",
              {scaling.place("NISH w=5"), scaling.mean("NISH w=5"), scaling.mean("NISH w=2.5"),
               scaling.mean("NISH w=9"), scores.groups()},
              "w = 5 at place {0} of {4}", "w = 5 in the worse half, above 2.5 and 9; partly: one of them",
              {2 * first > fifth && second > third && second > fourth,
               2 * first > fifth || (second > third && second > fourth)});
  scaling.add("scaling: DSAD shows good performance for medium sized kernels, slightly worse for small kernels.",
              {scaling.place(kDirections, 9), 100 * scaling.at(kDirections, 5), 100 * scaling.at(kDirections, 9)},
              "Place {} with 9×9; detected {:.0f} % with 5×5, {:.0f} % with 9×9",
              "First or second with 9×9, less with 5×5; partly: first or second",
              {first <= 2 && second < third, first <= 2}, "a differing scale changes DSAD little");
  InfluenceRow blurring(scores, "blurring");
  blurring.add("blurring: intensity based criteria perform well, slightly worse for zero-mean and mean scaled methods.",
               {blurring.mean(kGreyLow), blurring.mean(kZeroLow), blurring.place(kGreyLow)}, "",
               "Grey values in one of the first three places, zero-mean and scaled below them; partly: the latter",
               {first > second && third <= 3, first > second});
  blurring.add("blurring: highpass based criteria show the worst results.", {blurring.place(kHigh), scores.groups()},
               "Place {} of {}", "Last; partly: last but one", {first >= second, first >= second + -1},
               "blur in one image changes criteria on high-pass filtered images most");
  blurring.add("blurring: NISH shows the worst results for w > 6, medium performance for w < 6.",
               {std::max(blurring.mean("NISH w=7"), blurring.mean("NISH w=9")),
                std::min(blurring.mean("NISH w=2.5"), blurring.mean("NISH w=5")),
                std::min(blurring.mean("NISH w=7"), blurring.mean("NISH w=9"))},
               "", "w = 7 and 9 below w = 2.5 and 5; partly: one of them", {first < second, third < second});
  blurring.add("blurring: DSAD shows medium results.", {blurring.place(kDirections), scores.groups()}, "Place {} of {}",
               "Neither among the first two nor the last two; partly: neither first nor last",
               {first > 2 && first < second + -1, first > 1 && first < second});
  std::vector<Statement> both = std::move(scaling.table);
  both.insert(both.end(), blurring.table.begin(), blurring.table.end());
  return both;
}

}  // namespace horopter::cli
