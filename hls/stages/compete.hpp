// SPDX-License-Identifier: Apache-2.0
// The rule `compete`: parallel skins compete for each pixel, their votes are shared with pixels that look alike.
//
//   lowpass → sobel → contrast → plane_sums → plane_paths → contest → spread → ballot → consensus → align
//
// contrast also takes the low-passed left grey level. Everything from plane_sums on delays its marks with the pixel,
// so `align` has no offset in columns.
//
// Where there is little but noise, the best of many planes outside beats the best of the three inside. So a pixel votes
// only where a plane explains what the left image shows (`evident`), and `clear` takes a larger majority than `skin`;
// what is left is undecidable.
#pragma once

#include "stages/align.hpp"
#include "stages/consensus.hpp"

namespace horopter::stages {

/// The stages of a profile. All pixels whose low-pass exists are decided: at the image's border by those that vote.
template <Profile P>
struct Competition {
  static constexpr const auto& planes = planes_19;
  static constexpr int sum_rows = 7;
  static constexpr int sum_columns = 9;
  static constexpr int ballot_reach = 9;  // rows

  using Contrast = ContrastFinder<P.result_width()>;

  template <class V, int BEATS>
  using SumsOf = PlaneSummer<BEATS, planes, sum_rows, sum_columns, V>;
  template <class V, int BEATS>
  using PathsOf = PlanePaths<BEATS, planes, sum_rows, sum_columns, V>;
  template <class V, int BEATS>
  using ContestOf = PlaneContest<BEATS, planes, sum_rows, sum_columns, V>;

  using PlaneSums = SumsOf<Scalar, P.result_width()>;
  using Paths = PathsOf<Scalar, P.result_width()>;
  using Contest = ContestOf<Scalar, P.result_width()>;
  using Spread = VoteSpread;
  using Ballot = ColumnBallot<P.result_width(), ballot_reach>;
  using Consensus = stages::ConsensusVote<P.result_width(), P.majority_window>;

  /// Rows by which the result of a pixel leaves late: low-pass and Sobel, sum, ballot, consensus.
  static constexpr int offset = 2 + (sum_rows - 1) / 2 + ballot_reach + (P.majority_window - 1) / 2;
  /// Rows without pixels after each frame: the offset, and what is late within the row.
  static constexpr int flush_rows = offset + 3;
  using Align = Aligner<P.result_width(), P.height, offset, 0>;
};

}  // namespace horopter::stages
