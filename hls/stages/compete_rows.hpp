// SPDX-License-Identifier: Apache-2.0
// The stages of `compete` for the native engine, a row at a time: up to the contest on strips in the lanes of a vector,
// then beat by beat. The same classes, the same bits as one call of step per beat (tests/unit/compete.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "horopter/hls/compete_settings.hpp"
#include "horopter/hls/lanes.hpp"
#include "stages/compete.hpp"
#include "stages/lowpass.hpp"

namespace horopter::native {

using hls::CompeteSettings;

struct CompetePixel {
  hls::u<8> left;
  hls::u<8> right;
  bool saturated = false;
  bool mask = false;
};

template <hls::Profile P>
class CompeteRows {
  using Lanes = hls::Lanes;

 public:
  void begin(int width, const CompeteSettings& settings) {
    width_ = width;
    strip_ = (width + lanes - 1) / lanes;
    config_ = Config(settings);
  }

  /// `source(x)`: the pixel pair of a column; `sink`: every beat that leaves the consensus.
  template <class Source, class Sink>
  void row(const Source& source, bool first_row, const Sink& sink) {
    load(source, first_row);
    contest_row(first_row);
    for (int x = 0; x < width_; ++x) {
      const auto& from = decided_[static_cast<std::size_t>(lead + delay + x % strip_)];
      const int lane = x / strip_;
      stages::VoteSpread::In in;
      in.vote = from.vote.lane(lane);
      in.firm = from.firm.lane(lane);
      in.grey = from.grey.lane(lane);
      in.exists = from.exists.lane(lane);
      in.marks = {x == 0 && first_row, x + 1 == width_};
      const auto spread = spread_.step(in, config_.spread);
      const auto ballot = ballot_.step(spread, config_.ballot);
      sink(consensus_.step({ballot.skin, ballot.clear, ballot.exists, ballot.marks}));
    }
  }

 private:
  static constexpr int lanes = hls::lanes::count;
  static constexpr int reach = stages::planes_of<P.planes>.reach();
  static constexpr int delay = stages::PlaneSums<P>::delay + stages::Contest<P>::delay;
  /// A strip begins as far left as anything that its results depend on, and ends when the last of them has left.
  static constexpr int lead = P.sum_columns + 2 * reach + 2 * stages::gradient_delay;
  static constexpr int largest_strip = (P.result_width() + lanes - 1) / lanes;
  static constexpr int strip_beats = lead + largest_strip + delay;
  static_assert(255 * largest_strip < 1 << 16, "a lane sums the gradients of its strip");

  using Lowpass = stages::LowpassFilter<strip_beats, 2, 1, Lanes>;
  using Sobel = stages::SobelFilter<strip_beats, 2, 1, Lanes, true>;
  using Contrast = stages::Contrast<Lanes>;
  using GradientSums = stages::GradientSums<P.result_width()>;
  using Sums = stages::PlaneSums<P, Lanes, strip_beats>;
  using Paths = stages::Paths<P, Lanes, strip_beats>;
  using Contest = stages::Contest<P, Lanes, strip_beats>;
  using Config = stages::CompeteConfig<P, Contest>;

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

  [[gnu::flatten]] void contest_row(bool first_row) {
    if (first_row) {
      gradients_ = GradientSums{};
      gain_ = next_gain_ = stages::gain_1;
    }
    hls::lanes::unsigned_vector left{};
    hls::lanes::unsigned_vector right{};
    for (int beat = 0; beat < beats_; ++beat) {
      const auto at = static_cast<std::size_t>(beat);
      const auto gradients = sobel_.step(lowpass_.step(grey_[at]));
      Contrast in;
      in.set(gradients, gain_);
      if (beat >= lead && beat < lead + strip_) {
        left += select(gradients.mask, Contrast::magnitude(gradients.gx[0]), Lanes::u<8>(0)).vector();
        right += select(gradients.mask, Contrast::magnitude(gradients.gx[1]), Lanes::u<8>(0)).vector();
      }
      decided_[at] = contest_.step(paths_.step(sums_.step(in)), config_.contest);
    }
    gain_ = next_gain_;
    gradients_.fade();
    gradients_.add(sum_of(left), sum_of(right));
    next_gain_ = gradients_.gain();
  }

  static typename GradientSums::Row sum_of(hls::lanes::unsigned_vector strips) {
    std::uint32_t sum = 0;
    for (int lane = 0; lane < lanes; ++lane) sum += strips[lane];
    return sum;
  }

  template <class T>
  using StripRow = std::array<T, strip_beats>;

  Lowpass lowpass_;
  Sobel sobel_;
  GradientSums gradients_;
  hls::u<8> gain_, next_gain_;
  Sums sums_;
  Paths paths_;
  Contest contest_;
  stages::Spread<P> spread_;
  stages::Ballot<P> ballot_;
  stages::Consensus<P> consensus_;

  Config config_;

  int width_ = 0;
  int strip_ = 0;  // columns of a strip
  int beats_ = 0;  // and beats: lead and delay more
  StripRow<stages::Grey<2, Lanes>> grey_{};
  StripRow<typename Contest::Out> decided_{};
};

}  // namespace horopter::native
