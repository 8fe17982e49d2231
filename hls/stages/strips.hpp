// SPDX-License-Identifier: Apache-2.0
// The native engine's way through the chain: a row at a time. The stages that stand in `lanes` see the row as strips
// side by side in the lanes of a vector, the same classes on another kind of value. Those behind them, align, runs and
// alarm, shift, compare and count what has been decided: the engine does that itself, for speed (pipeline.hpp). The same
// bits as one call of step per beat (tests/unit/pipeline.cpp, compete.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <tuple>
#include <utility>

#include "horopter/hls/lanes.hpp"
#include "stages/chain.hpp"

namespace horopter::native {

/// A stage as a local variable while a row passes: bytes written elsewhere cannot alias it, so its registers stay in
/// registers.
template <class Stage>
class Borrowed {
 public:
  explicit Borrowed(Stage& owner) : owner_(owner), stage_(std::move(owner)) {}
  ~Borrowed() { owner_ = std::move(stage_); }
  Borrowed(const Borrowed&) = delete;
  Borrowed& operator=(const Borrowed&) = delete;
  Stage* operator->() { return &stage_; }
  Stage& operator*() { return stage_; }

 private:
  Stage& owner_;
  Stage stage_;
};

/// How a row lies in strips: each begins as far left as anything that its results depend on, and ends when the last of
/// them has left.
template <hls::Profile P>
struct StripShape {
  static constexpr std::size_t lanes = static_cast<std::size_t>(hls::lanes::count);
  static constexpr std::size_t largest = (static_cast<std::size_t>(P.result_width()) + lanes - 1) / lanes;

  /// Beats before a strip's own pixels.
  static constexpr std::size_t lead(hls::Rule rule) {
    if (!P.has(rule)) return 0;
    return static_cast<std::size_t>(rule == hls::Rule::compete
                                        ? P.sum_columns + 2 * stages::planes_of<P.planes>.reach() +
                                              2 * stages::gradient_delay
                                        : 2 * P.offset() + std::max(stages::self_shift, P.hypotheses - 1));
  }
  /// Beats between a pixel and its result.
  static constexpr std::size_t delay(hls::Rule rule) {
    if constexpr (P.has_compete()) {
      if (rule == hls::Rule::compete) return std::size_t{stages::PlaneSums<P>::delay + stages::Contest<P>::delay};
    }
    return 0;
  }

  /// The same of the stages of `compete` that take votes, which have strips of their own: theirs reach further.
  static constexpr std::size_t vote_delay() {
    if constexpr (P.has_compete()) return std::size_t{stages::Spread<P>::delay + stages::Consensus<P>::delay};
    return 0;
  }
  static constexpr std::size_t vote_lead() { return vote_delay(); }

  /// Beats of a strip before the first sum over planes that a result of it depends on; COLUMNS before that is the first
  /// cost.
  static constexpr std::size_t first_sum() {
    return lead(hls::Rule::compete) + delay(hls::Rule::compete) - 2 * stages::planes_of<P.planes>.reach();
  }
};

/// A row, lane by lane, between its own order and that of strips: 16 bits a pixel. By way of memory, a row at a time: the
/// processor waits for a vector whose lanes have just been written one by one.
template <hls::Profile P, std::size_t BEATS>
class Transposed {
  static constexpr std::size_t lanes = StripShape<P>::lanes;
  using Vector = hls::lanes::unsigned_vector;

 public:
  /// `row`: where the strip of the first lane begins. Beyond a strip's width comes what the next lane begins with.
  void cut(const std::uint16_t* row, std::size_t strip, std::size_t beats) {
    const std::size_t own = std::min(strip, beats);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      for (std::size_t beat = 0; beat < own; ++beat) words_[beat * lanes + lane] = row[lane * strip + beat];
    }
    for (std::size_t beat = own; beat < beats; ++beat) {
      std::uint16_t* const to = words_.data() + beat * lanes;
      Vector vector;
      std::memcpy(&vector, to - strip * lanes + 1, sizeof vector);
      std::memcpy(to, &vector, sizeof vector);
      to[lanes - 1] = row[(lanes - 1) * strip + beat];
    }
  }
  /// The strips' own pixels.
  template <class T>
  void join(T* row, std::size_t strip) const {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      for (std::size_t i = 0; i < strip; ++i) row[lane * strip + i] = static_cast<T>(words_[i * lanes + lane]);
    }
  }
  [[nodiscard]] Vector beat(std::size_t i) const {
    Vector vector;
    std::memcpy(&vector, words_.data() + i * lanes, sizeof vector);
    return vector;
  }
  void set(std::size_t i, Vector vector) { std::memcpy(words_.data() + i * lanes, &vector, sizeof vector); }

 private:
  alignas(Vector) std::array<std::uint16_t, BEATS * lanes> words_{};
};

/// `contrast` of a row in strips. What it sums goes over the whole row, so the sums of the strips are joined at its
/// end; the gain of the next row but one is known then, without the hardware's division by bits.
template <hls::Profile P>
class StripContrast {
  using Lanes = hls::Lanes;

 public:
  using In = stages::GradientsAndGrey<Lanes>;
  using Out = stages::Contrast<Lanes>;

  /// The beats begin … end − 1 of the row are its pixels, the others those of neighbouring strips.
  void begin_row(bool first_row, int begin, int end) {
    if (first_row) {
      sums_ = Sums{};
      gain_ = next_gain_ = stages::gain_1;
    }
    beat_ = -begin;
    pixels_ = end - begin;
    left_ = right_ = {};
  }

  Out step(const In& in) {
    Out out;
    out.set(in, gain_);
    if (beat_ >= 0 && beat_ < pixels_) {
      left_ += select(in.mask, Out::magnitude(in.gx[0]), Lanes::u<8>(0)).vector();
      right_ += select(in.mask, Out::magnitude(in.gx[1]), Lanes::u<8>(0)).vector();
    }
    ++beat_;
    return out;
  }

  void end_row() {
    gain_ = next_gain_;
    sums_.fade();
    sums_.add(sum_of(left_), sum_of(right_));
    next_gain_ = sums_.gain();
  }

 private:
  using Sums = stages::GradientSums<P.result_width()>;
  static_assert(255 * StripShape<P>::largest < 1 << 16, "a lane sums the gradients of its strip");

  static typename Sums::Row sum_of(hls::lanes::unsigned_vector strips) {
    std::uint32_t sum = 0;
    for (int lane = 0; lane < hls::lanes::count; ++lane) sum += strips[lane];
    return sum;
  }

  Sums sums_;
  hls::u<8> gain_, next_gain_;
  hls::lanes::unsigned_vector left_{}, right_{};
  int beat_ = 0;
  int pixels_ = 0;
};

/// The pixel pairs of a row before the low-pass: column x stands at `before` + x. Beside them there is no image.
template <hls::Profile P>
struct PairRow {
  using Shape = StripShape<P>;
  static constexpr std::size_t before = std::max(Shape::lead(hls::Rule::thesis), Shape::lead(hls::Rule::compete));
  static constexpr std::size_t behind = std::max(Shape::delay(hls::Rule::thesis), Shape::delay(hls::Rule::compete));
  template <class T>
  using Row = std::array<T, before + Shape::lanes * Shape::largest + behind>;

  Row<hls::u<8>> left, right;
  Row<bool> saturated, mask, present;
};

/// What `agreement` says in the marks of a row, column x at x.
template <hls::Profile P>
struct MarksRow {
  std::array<bool, static_cast<std::size_t>(P.result_width())> seen, nearer;
};

/// What the stages in lanes decide of a row, column x at x.
template <hls::Profile P>
using StatesRow = std::array<std::uint8_t, StripShape<P>::lanes * StripShape<P>::largest>;

/// The stages of one rule from the one behind `subsample` on.
template <hls::Profile P, hls::Rule RULE>
class Strips {
  using Stage = stages::Stage;
  using Lanes = hls::Lanes;
  static constexpr bool compete = RULE == hls::Rule::compete;

  using Shape = StripShape<P>;
  static constexpr std::size_t lanes = Shape::lanes;
  static constexpr std::size_t lead = Shape::lead(RULE);
  static constexpr std::size_t delay = Shape::delay(RULE);
  static constexpr std::size_t largest_beats = lead + Shape::largest + delay;
  static constexpr std::size_t vote_lead = Shape::vote_lead();
  static constexpr std::size_t vote_delay = Shape::vote_delay();
  static constexpr std::size_t largest_vote_beats = vote_lead + Shape::largest + vote_delay;

  static constexpr auto order = stages::chain::order<RULE>();
  static constexpr bool in_lanes(Stage stage) { return stages::chain::place_of(stage) == stages::Place::lanes; }
  static constexpr std::size_t first = 4;
  static constexpr std::size_t count = std::count_if(order.begin(), order.end(), in_lanes);
  /// The first of those that take votes.
  static constexpr std::size_t votes =
      compete ? std::find(order.begin(), order.end(), Stage::spread) - order.begin() - first : count;
  static constexpr std::size_t planes =
      compete ? std::find(order.begin(), order.end(), Stage::plane_sums) - order.begin() - first : count;
  static_assert(order[0] == Stage::interpolate && order[1] == Stage::subsample && order[2] == Stage::agreement &&
                    order[3] == Stage::dim,
                "the engine makes rows of these four by itself");
  static_assert(std::all_of(order.begin() + first, order.begin() + first + count, in_lanes),
                "the stages in lanes follow each other");
  using Indices = std::make_index_sequence<count>;

  static constexpr hls::Profile profile_of(std::size_t beats) {
    hls::Profile profile = P;
    profile.width = static_cast<int>(beats);
    profile.subsample = 1;
    profile.decisions = compete ? hls::Decisions::compete : hls::Decisions::thesis;
    return profile;
  }
  static constexpr hls::Profile strip_profile = profile_of(largest_beats);
  static constexpr hls::Profile vote_profile = profile_of(largest_vote_beats);
  template <Stage STAGE>
  struct InStrips {
    using type =
        typename stages::Line<STAGE>::template Of<(STAGE < Stage::spread ? strip_profile : vote_profile), Lanes>;
  };
  template <Stage STAGE>
    requires(STAGE == Stage::contrast)
  struct InStrips<STAGE> {
    using type = StripContrast<P>;
  };
  template <std::size_t I>
  using Of = typename InStrips<order[first + I]>::type;

  template <class T>
  using StripRow = std::array<T, largest_beats>;
  struct Nothing {};

  template <std::size_t... I>
  static std::tuple<Of<I>...> stages_of(std::index_sequence<I...>);
  template <std::size_t... I>
  static std::tuple<typename stages::chain::ConfigOf<Of<I>>::type...> configs_of(std::index_sequence<I...>);
  template <std::size_t... I>
  static std::tuple<StripRow<typename Of<I>::Out>...> rows_of(std::index_sequence<I...>);

  static constexpr std::size_t first_sum = compete ? Shape::first_sum() : 0;
  /// The stages of the first half.
  static constexpr std::size_t half = compete ? planes + 1 : 3;

 public:
  using Between = std::array<typename Of<half - 1>::Out, largest_beats - first_sum>;

  /// `settings`: of the stages, with the size of the result.
  template <class Settings>
  void begin(const Settings& settings) {
    width_ = static_cast<std::size_t>(settings.width);
    strip_ = (width_ + lanes - 1) / lanes;
    beats_ = lead + strip_ + delay;
    vote_beats_ = vote_lead + strip_ + vote_delay;
    votes_.fill(0);
    dim_ = settings.dim != 0;
    stages::chain::configure(configs_, settings);
  }

  /// A row passes in two halves, so that two threads can share it: up to the sums over planes, or the directions, which
  /// `between` holds, and the rest.
  void pass_first(const PairRow<P>& pairs, bool first_row, Between& between) {
    load(pairs);
    if constexpr (compete) {
      sum_planes(first_row, between);
    } else {
      pass_row<0>(first_row, between);
      pass_row<1>(first_row, between);
      pass_row<2>(first_row, between);
    }
  }
  void pass_second(const Between& between, bool first_row, StatesRow<P>& states) {
    if constexpr (compete) {
      vote(between);
      exchange();
      pass_votes(first_row);
    } else {
      [&]<std::size_t... I>(std::index_sequence<I...>) {
        (pass_row<half + I>(first_row, between), ...);
      }(std::make_index_sequence<count - half>{});
      const auto& decided = std::get<count - 1>(rows_);
      for (std::size_t i = 0; i < strip_; ++i) words_.set(i, decided[lead + delay + i].state.vector());
    }
    words_.join(states.data(), strip_);
  }

 private:
  void load(const PairRow<P>& pairs) {
    const std::size_t begin = PairRow<P>::before - lead;
    const std::size_t end = begin + (lanes - 1) * strip_ + beats_;
    for (std::size_t x = begin; x < end; ++x) {
      const auto [left, right] =
          dim_ ? std::pair{stages::Dim<P>::dimmed(pairs.left[x]), stages::Dim<P>::dimmed(pairs.right[x])}
               : std::pair{pairs.left[x], pairs.right[x]};
      pixels_[x] = static_cast<std::uint16_t>(left.value() | right.value() << 8);
      bits_[x] = static_cast<std::uint16_t>((pairs.saturated[x] ? 1 : 0) | (pairs.mask[x] ? 2 : 0));
    }
    grey_pixels_.cut(pixels_.data() + begin, strip_, beats_);
    grey_bits_.cut(bits_.data() + begin, strip_, beats_);
  }

  [[nodiscard]] stages::Grey<2, Lanes> grey(std::size_t beat, bool first_row) const {
    const Lanes::u<16> pixels(grey_pixels_.beat(beat));
    const Lanes::u<2> bits(grey_bits_.beat(beat));
    return {{Lanes::u<8>(pixels), pixels.template bits<15, 8>()},
            bits.bit(0),
            bits.bit(1),
            {beat == 0 && first_row, beat + 1 == beats_}};
  }

  /// One stage takes the whole row before the next begins: the same as beat by beat, as none feeds back.
  template <std::size_t I, class Middle>
  [[gnu::flatten]] void pass_row(bool first_row, Middle& between) {
    Borrowed stage(std::get<I>(stages_));
    const auto& config = std::get<I>(configs_);
    const std::size_t n = beats_;
    const auto row_of = [&]<std::size_t J>(std::integral_constant<std::size_t, J>) -> auto& {
      if constexpr (J + 1 == half) {
        return between;
      } else {
        return std::get<J>(rows_);
      }
    };
    auto& to = row_of(std::integral_constant<std::size_t, I>{});
    for (std::size_t i = 0; i < n; ++i) {
      if constexpr (I == 0) {
        to[i] = stages::chain::step(*stage, grey(i, first_row), config);
      } else {
        to[i] = stages::chain::step(*stage, row_of(std::integral_constant<std::size_t, I - 1>{})[i], config);
      }
    }
  }

  /// All stages of a half take a beat before the next one comes.
  [[gnu::flatten]] void sum_planes(bool first_row, Between& between) {
    constexpr auto first_cost = first_sum - static_cast<std::size_t>(P.sum_columns);
    auto& contrast = std::get<planes - 1>(stages_);
    auto& sums = std::get<planes>(stages_);
    contrast.begin_row(first_row, static_cast<int>(lead), static_cast<int>(lead + strip_));
    const auto features = [&](std::size_t beat) { return through<0, planes>(grey(beat, first_row)); };
    for (std::size_t i = 0; i < first_cost; ++i) sums.skip(features(i));
    sums.begin();
    for (std::size_t i = first_cost; i < first_sum; ++i) sums.step(features(i));
    for (std::size_t i = first_sum; i < beats_; ++i) {
      using Sums = typename Of<planes>::Out;
      auto* const to = ::new (&between[i - first_sum]) Sums(sums.step(features(i)));  // in place: they are large
      to->marks = {first_row && i == first_sum, i + 1 == beats_};
    }
    contrast.end_row();
  }

  [[gnu::flatten]] void vote(const Between& between) {
    const auto vote_of = [&](std::size_t beat) { return through<half, votes>(between[beat - first_sum]); };
    for (std::size_t i = first_sum; i < lead + delay; ++i) vote_of(i);
    for (std::size_t i = 0; i < strip_; ++i) {
      const auto vote = vote_of(lead + delay + i);
      words_.set(i, cat(cat(cat(Lanes::u<7>(vote.vote), vote.firm), vote.grey), vote.exists).vector());
    }
  }

  /// The strips of the votes from those of the planes.
  void exchange() {
    words_.join(votes_.data() + vote_lead, strip_);
    vote_words_.cut(votes_.data(), strip_, vote_beats_);
  }

  [[gnu::flatten]] void pass_votes(bool first_row) {
    const auto vote = [&](std::size_t beat) {
      const Lanes::u<15> word(vote_words_.beat(beat));
      typename Of<votes>::In in;
      in.vote = Lanes::s<7>(word.template bits<14, 8>());
      in.firm = word.bit(7);
      in.grey = word.template bits<6, 1>();
      in.exists = word.bit(0);
      in.marks = {beat == 0 && first_row, beat + 1 == vote_beats_};
      return in;
    };
    for (std::size_t i = 0; i < vote_lead + vote_delay; ++i) through<votes, count>(vote(i));
    for (std::size_t i = 0; i < strip_; ++i) {
      words_.set(i, through<votes, count>(vote(vote_lead + vote_delay + i)).state.vector());
    }
  }

  template <std::size_t I, std::size_t END, class Given>
  [[gnu::always_inline]] auto through(const Given& given) {
    const auto out = stages::chain::step(std::get<I>(stages_), given, std::get<I>(configs_));
    if constexpr (I + 1 < END) {
      return through<I + 1, END>(out);
    } else {
      return out;
    }
  }

  bool dim_ = false;
  std::size_t width_ = 0;
  std::size_t strip_ = 0;  // columns of a strip
  std::size_t beats_ = 0;  // and beats: lead and delay more
  std::size_t vote_beats_ = 0;
  decltype(stages_of(Indices{})) stages_;
  decltype(configs_of(Indices{})) configs_;
  /// What each stage puts out; not with `compete`.
  std::conditional_t<compete, Nothing, decltype(rows_of(Indices{}))> rows_{};
  typename PairRow<P>::template Row<std::uint16_t> pixels_{}, bits_{};
  Transposed<P, largest_beats> grey_pixels_, grey_bits_;
  Transposed<P, Shape::largest> words_;  // of votes, of states
  std::array<std::uint16_t, vote_lead + lanes * Shape::largest + vote_delay> votes_{};
  Transposed<P, largest_vote_beats> vote_words_;
};

}  // namespace horopter::native
