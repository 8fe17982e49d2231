// SPDX-License-Identifier: Apache-2.0
// The rule `compete`: parallel skins compete for each pixel, their votes are shared with pixels that look alike.
//
//   lowpass → sobel → contrast → plane_sums → plane_paths → contest → spread → ballot → consensus → align
//
// contrast also takes the low-passed left grey level, which sobel carries along. Everything from plane_sums on delays
// its marks with the pixel, so `align` has no offset in columns. All pixels whose low-pass exists are decided: at the
// image's border by those that vote.
//
// Where there is little but noise, the best of many planes outside beats the best of the three inside. So a pixel votes
// only where a plane explains what the left image shows (`evident`), and `clear` takes a larger majority than `skin`;
// what is left is undecidable.
#pragma once

#include "horopter/hls/compete_settings.hpp"
#include "stages/align.hpp"
#include "stages/consensus.hpp"

namespace horopter::stages {

/// The settings, as the stages take them.
template <hls::Profile P, class ContestStage = Contest<P>>
struct CompeteConfig {
  CompeteConfig() = default;
  explicit CompeteConfig(const hls::CompeteSettings& settings) {
    contest.bias = settings.bias;
    contest.boundary = settings.boundary;
    spread.smooth = settings.smooth;
    ballot.similar = settings.similar;
    ballot.quorum = settings.quorum;
    ballot.clear_quorum = settings.clear_quorum;
  }

  typename ContestStage::Config contest;
  VoteSpread::Config spread;
  typename Ballot<P>::Config ballot;
};

}  // namespace horopter::stages
