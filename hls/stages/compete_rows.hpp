// SPDX-License-Identifier: Apache-2.0
// The stages of `compete` for the native engine, a row at a time: up to the contest on strips in the lanes of a vector,
// then beat by beat. The same classes, the same bits as one call of step per beat (tests/unit/compete.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "horopter/hls/lanes.hpp"
#include "stages/compete.hpp"
#include "stages/lowpass.hpp"

namespace horopter::native {

/// The registers of the rule `compete`.
struct CompeteSettings {
  int bias = 3;     // added to every vote: above 0 a doubtful pixel is rather in the skin
  int smooth = 2;   // in 4 grey levels: pixels of a row that differ by more are not alike
  int similar = 3;  // in 4 grey levels: pixels of a column that differ by more do not vote for each other
  int quorum = 1;   // smallest sum of votes that decides
};

struct CompetePixel {
  hls::u<8> left;
  hls::u<8> right;
  bool saturated = false;
  bool mask = false;
};

template <hls::Profile P>
class CompeteRows {
  using Chain = stages::Competition<P>;
  using Lanes = hls::Lanes;

 public:
  void begin(int width, const CompeteSettings& settings) {
    width_ = width;
    strip_ = (width + lanes - 1) / lanes;
    contest_config_.bias = settings.bias;
    spread_config_.smooth = settings.smooth;
    ballot_config_.similar = settings.similar;
    ballot_config_.quorum = settings.quorum;
  }

  /// `source(x)`: the pixel pair of a column; `sink`: every beat that leaves the consensus.
  template <class Source, class Sink>
  void row(const Source& source, bool first_row, const Sink& sink) {
    load(source, first_row);
    contest_row();
    for (int x = 0; x < width_; ++x) {
      const auto& from = decided_[static_cast<std::size_t>(lead + delay + x % strip_)];
      const int lane = x / strip_;
      stages::VoteSpread::In in;
      in.vote = from.vote.lane(lane);
      in.grey = from.grey.lane(lane);
      in.exists = from.exists.lane(lane);
      in.marks = {x == 0 && first_row, x + 1 == width_};
      const auto spread = spread_.step(in, spread_config_);
      const auto ballot = ballot_.step(spread, ballot_config_);
      sink(consensus_.step({ballot.skin, ballot.decidable, ballot.exists, ballot.marks}));
    }
  }

 private:
  static constexpr int lanes = hls::lanes::count;
  static constexpr int reach = Chain::planes.reach();
  static constexpr int delay = stages::PlaneSummer<1, Chain::planes, Chain::sum_rows, Chain::sum_columns>::delay +
                               stages::PlaneContest<1, Chain::planes, Chain::sum_rows, Chain::sum_columns>::delay;
  /// A strip begins as far left as anything that its results depend on, and ends when the last of them has left.
  static constexpr int lead = Chain::sum_columns + 2 * reach + 2 * stages::gradient_delay;
  static constexpr int largest_strip = (P.result_width() + lanes - 1) / lanes;
  static constexpr int strip_beats = lead + largest_strip + delay;

  using Lowpass = stages::LowpassFilter<strip_beats, 2, 1, Lanes>;
  using Sobel = stages::SobelFilter<strip_beats, 2, 1, Lanes>;
  using Direction = stages::DirectionFinder<2, Lanes>;
  using Sums = typename Chain::template SumsOf<Lanes, strip_beats>;
  using Paths = typename Chain::template PathsOf<Lanes, strip_beats>;
  using Contest = typename Chain::template ContestOf<Lanes, strip_beats>;

  template <class Source>
  void load(const Source& source, bool first_row) {
    beats_ = lead + strip_ + delay;
    for (int lane = 0; lane < lanes; ++lane) {
      for (int beat = 0; beat < beats_; ++beat) {
        const int x = lane * strip_ + beat - lead;
        const CompetePixel pixel = x >= 0 && x < width_ ? source(x) : CompetePixel{};
        auto& to = grey_[static_cast<std::size_t>(beat)];
        to.pixel[0].set_lane(lane, pixel.left);
        to.pixel[1].set_lane(lane, pixel.right);
        to.saturated.set_lane(lane, pixel.saturated);
        to.mask.set_lane(lane, pixel.mask);
        to.marks = {beat == 0 && first_row, beat + 1 == beats_};
      }
    }
  }

  [[gnu::flatten]] void contest_row() {
    for (int beat = 0; beat < beats_; ++beat) {
      const auto at = static_cast<std::size_t>(beat);
      const auto smooth = lowpass_.step(grey_[at]);
      const auto direction = direction_.step(sobel_.step(smooth));
      typename Sums::In in;
      in.direction = direction.direction;
      in.magnitude = direction.magnitude;
      in.saturated = direction.saturated;
      in.mask = direction.mask;
      in.grey = smooth.pixel[0];
      in.exists = smooth.mask;
      in.marks = direction.marks;
      decided_[at] = contest_.step(paths_.step(sums_.step(in)), contest_config_);
    }
  }

  template <class T>
  using StripRow = std::array<T, strip_beats>;

  Lowpass lowpass_;
  Sobel sobel_;
  Direction direction_;
  Sums sums_;
  Paths paths_;
  Contest contest_;
  typename Chain::Spread spread_;
  typename Chain::Ballot ballot_;
  typename Chain::Consensus consensus_;

  typename Contest::Config contest_config_;
  stages::VoteSpread::Config spread_config_;
  typename Chain::Ballot::Config ballot_config_;

  int width_ = 0;
  int strip_ = 0;  // columns of a strip
  int beats_ = 0;  // and beats: lead and delay more
  StripRow<stages::Grey<2, Lanes>> grey_{};
  StripRow<typename Contest::Out> decided_{};
};

}  // namespace horopter::native
