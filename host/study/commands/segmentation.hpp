// SPDX-License-Identifier: Apache-2.0
// Figures of the experiment of 8.4: every criterion, prefilter, kernel and filter of the result, over disparities. What
// the thesis says of them is in segmentation_measures.hpp.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "horopter/study/series.hpp"
#include "report.hpp"

namespace horopter::cli {

/// How grey values are filtered before a criterion.
enum class Prefilter { none, lowpass, highpass, lowpass_highpass };

/// All settings of one experiment with their detections.
class Segmentation {
 public:
  void add(const study::Setting& setting, study::Detection detection);
  /// In the order in which they were added.
  const std::vector<std::pair<study::Setting, study::Detection>>& all() const { return all_; }

  /// For NISH `log_w_px` instead of a prefilter; a direction is taken with or without low-pass. Throws
  /// std::out_of_range when it was not measured.
  const study::Detection& of(const std::string& criterion, Prefilter prefilter, int kernel = 9,
                             study::ResultFilter filter = study::ResultFilter::none) const;
  const study::Detection& nish(double log_w_px, int kernel = 9) const;
  const study::Detection& nisd(double log_w_px, int kernel = 9) const;
  const study::Detection& nack(int kernel = 9) const;

 private:
  const study::Detection& of(const study::Setting& setting) const;

  std::vector<std::pair<study::Setting, study::Detection>> all_;
  std::map<std::string, std::size_t> index_;  ///< by name
};

inline const std::vector<std::string> kCrossGroup{"NCC", "ZNCC", "MOR"};
inline const std::vector<std::string> kNormalisedGroup{"NCC", "ZNCC", "MOR", "ZNSSD", "NSAD"};  ///< of 8.4.4
inline const std::vector<std::string> kDifferenceGroup{"SAD", "ZSAD", "LSAD", "SSD", "ZSSD", "LSSD"};
inline const std::vector<std::string> kZeroMeanGroup{"SAD", "SSD", "ZSAD", "ZSSD"};
inline const std::vector<std::string> kLocalGroup{"LSAD", "LSSD", "NSAD"};
/// All but kLocalGroup, of which 8.4.3 says that a high-pass makes them worse.
inline const std::vector<std::string> kLikedByHighpass{"NCC", "ZNCC", "MOR", "ZNSSD", "SAD", "SSD", "ZSAD", "ZSSD"};
inline const std::vector<std::string> kGreyCriteria{"NCC",   "ZNCC", "MOR",  "SSD",  "ZSSD", "LSSD",
                                                    "ZNSSD", "SAD",  "ZSAD", "LSAD", "NSAD"};

}  // namespace horopter::cli
