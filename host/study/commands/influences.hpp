// SPDX-License-Identifier: Apache-2.0
// Table 8.4: what is still detected under an influence, by groups of criteria and by kernels.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "statements.hpp"

namespace horopter::cli {

inline constexpr std::array kInfluencedKernels{5, 9, 13, 17, 21};

/// Mean share that is detected over the levels of an influence.
class Scores {
 public:
  void add(const std::string& influence, int kernel, const std::string& group, double share) {
    of_[influence][kernel][group] += share;
    over_kernels_[influence][group] += share / kInfluencedKernels.size();
  }
  double at(const std::string& influence, const std::string& group, int kernel) const {
    return of_.at(influence).at(kernel).at(group);
  }
  /// Over all kernels.
  double mean(const std::string& influence, const std::string& group) const {
    return over_kernels_.at(influence).at(group);
  }
  /// From 1, the best; with one kernel, or over all.
  int place(const std::string& influence, const std::string& group, int kernel) const;
  int place(const std::string& influence, const std::string& group) const;
  int groups() const { return static_cast<int>(over_kernels_.begin()->second.size()); }
  /// All groups from best to worst, over all kernels.
  std::string figure(const std::string& influence) const;

 private:
  using Groups = std::map<std::string, double>;
  std::map<std::string, std::map<int, Groups>> of_;
  std::map<std::string, Groups> over_kernels_;
};

/// Names of groups; those of NISH are "NISH w=5".
inline constexpr const char* kGreyRaw = "grey";
inline constexpr const char* kGreyLow = "grey LP";
inline constexpr const char* kZeroLow = "zero-mean, scaled LP";
inline constexpr const char* kHigh = "high-pass";
inline constexpr const char* kDirections = "DSAD LP";

std::vector<Statement> noise_statements(const Scores& scores);                 ///< 8.3.2
std::vector<Statement> scaling_and_blurring_statements(const Scores& scores);  ///< 8.3.3

}  // namespace horopter::cli
