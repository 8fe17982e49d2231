// SPDX-License-Identifier: Apache-2.0
// The native engine's way through the chain: a row at a time. The stages that stand in `lanes` see the row as strips
// side by side in the lanes of a vector, the same classes on another kind of value; those behind them take it beat by
// beat. The same bits as one call of step per beat (tests/unit/pipeline.cpp, compete.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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
};

/// `contrast` of a row in strips. What it sums goes over the whole row, so the sums of the strips are joined at its
/// end; the gain of the next row but one is known then, without the hardware's division by bits.
template <hls::Profile P>
class StripContrast {
  using Lanes = hls::Lanes;

 public:
  using In = stages::Gradients<2, Lanes, true>;
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
  /// What `agreement` says in the marks, column x at x.
  std::array<bool, Shape::lanes * Shape::largest> seen, nearer;
};

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

 public:
  /// `settings`: of the stages, with the size of the result.
  template <class Settings>
  void begin(const Settings& settings) {
    width_ = static_cast<std::size_t>(settings.width);
    strip_ = (width_ + lanes - 1) / lanes;
    beats_ = lead + strip_ + delay;
    row_.fill({});
    row_[width_ - 1].marks.last = true;
    stages::chain::configure(configs_, settings);
    behind_.configure(settings);
  }

  /// `see(At<stage>, out)`: every beat that a stage behind those in lanes puts out, as in Chain::step.
  template <class See>
  void row(const PairRow<P>& pairs, bool first_row, const See& see) {
    load(pairs, first_row);
    if constexpr (compete) {
      pass_beats(first_row);
    } else {
      [&]<std::size_t... I>(std::index_sequence<I...>) { (pass_row<I>(), ...); }(Indices{});
    }
    unload(pairs, first_row, see);
  }

 private:
  static constexpr auto order = stages::chain::order<RULE>();
  static constexpr bool in_lanes(Stage stage) { return stages::chain::place_of(stage) == stages::Place::lanes; }
  static constexpr std::size_t first = 3;
  static constexpr std::size_t count = std::count_if(order.begin(), order.end(), in_lanes);
  static_assert(order[0] == Stage::interpolate && order[1] == Stage::subsample && order[2] == Stage::agreement,
                "the engine makes rows of these three by itself");
  static_assert(std::all_of(order.begin() + first, order.begin() + first + count, in_lanes),
                "the stages in lanes follow each other");
  using Indices = std::make_index_sequence<count>;

  static constexpr hls::Profile strip_profile = [] {
    hls::Profile profile = P;
    profile.width = static_cast<int>(largest_beats);
    profile.subsample = 1;
    profile.decisions = compete ? hls::Decisions::compete : hls::Decisions::thesis;
    return profile;
  }();
  template <Stage STAGE>
  struct InStrips {
    using type = typename stages::Line<STAGE>::template Of<strip_profile, Lanes>;
  };
  template <Stage STAGE>
    requires(STAGE == Stage::contrast)
  struct InStrips<STAGE> {
    using type = StripContrast<P>;
  };
  template <std::size_t I>
  using Of = typename InStrips<order[first + I]>::type;
  using Last = typename Of<count - 1>::Out;
  using Behind = stages::Chain<P, RULE, order[first + count]>;

  template <class T>
  using StripRow = std::array<T, largest_beats>;
  struct Nothing {};

  template <std::size_t... I>
  static std::tuple<Of<I>...> stages_of(std::index_sequence<I...>);
  template <std::size_t... I>
  static std::tuple<typename stages::chain::ConfigOf<Of<I>>::type...> configs_of(std::index_sequence<I...>);
  template <std::size_t... I>
  static std::tuple<StripRow<typename Of<I>::Out>...> rows_of(std::index_sequence<I...>);

  void load(const PairRow<P>& pairs, bool first_row) {
    for (std::size_t beat = 0; beat < beats_; ++beat) {
      auto& to = grey_[beat];
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const std::size_t from = PairRow<P>::before - lead + lane * strip_ + beat;
        const int l = static_cast<int>(lane);
        to.pixel[0].set_lane(l, pairs.left[from]);
        to.pixel[1].set_lane(l, pairs.right[from]);
        to.saturated.set_lane(l, pairs.saturated[from]);
        to.mask.set_lane(l, pairs.mask[from]);
      }
      to.marks = {beat == 0 && first_row, beat + 1 == beats_};
    }
  }

  /// One stage takes the whole row before the next begins: the same as beat by beat, as none feeds back.
  template <std::size_t I>
  [[gnu::flatten]] void pass_row() {
    Borrowed stage(std::get<I>(stages_));
    const auto& config = std::get<I>(configs_);
    const std::size_t n = beats_;
    auto& to = std::get<I>(rows_);
    for (std::size_t i = 0; i < n; ++i) {
      if constexpr (I == 0) {
        to[i] = stages::chain::step(*stage, grey_[i], config);
      } else {
        to[i] = stages::chain::step(*stage, std::get<I - 1>(rows_)[i], config);
      }
    }
  }

  /// All stages take a beat before the next one comes: rows of the sums of all planes would not fit a cache.
  [[gnu::flatten]] void pass_beats(bool first_row) {
    const auto begin_row = [&](auto& stage) {
      if constexpr (requires { stage.end_row(); })
        stage.begin_row(first_row, static_cast<int>(lead), static_cast<int>(lead + strip_));
    };
    const auto end_row = [](auto& stage) {
      if constexpr (requires { stage.end_row(); }) stage.end_row();
    };
    std::apply([&](auto&... stage) { (begin_row(stage), ...); }, stages_);
    for (std::size_t i = 0; i < beats_; ++i) rows_[i] = through<0>(grey_[i]);
    std::apply([&](auto&... stage) { (end_row(stage), ...); }, stages_);
  }

  template <std::size_t I, class Given>
  [[gnu::always_inline]] auto through(const Given& given) {
    const auto out = stages::chain::step(std::get<I>(stages_), given, std::get<I>(configs_));
    if constexpr (I + 1 < count) {
      return through<I + 1>(out);
    } else {
      return out;
    }
  }

  template <class See>
  [[gnu::flatten]] void unload(const PairRow<P>& pairs, bool first_row, See see) {
    const auto& decided = [&]() -> const StripRow<Last>& {
      if constexpr (compete) {
        return rows_;
      } else {
        return std::get<count - 1>(rows_);
      }
    }();
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      for (std::size_t i = 0; i < strip_; ++i) {
        stages::chain::take_lane(row_[lane * strip_ + i], decided[lead + delay + i], static_cast<int>(lane));
      }
    }
    for (std::size_t x = 0; x < width_; ++x) {
      row_[x].marks.seen = pairs.seen[x];
      row_[x].marks.nearer = pairs.nearer[x];
    }
    row_[0].marks.first = first_row;
    const std::size_t n = width_;
    if constexpr (sizeof(Behind) < 1024) {
      Borrowed behind(behind_);
      for (std::size_t x = 0; x < n; ++x) behind->step(row_[x], see);
    } else {
      for (std::size_t x = 0; x < n; ++x) behind_.step(row_[x], see);
    }
  }

  std::size_t width_ = 0;
  std::size_t strip_ = 0;  // columns of a strip
  std::size_t beats_ = 0;  // and beats: lead and delay more
  StripRow<stages::Grey<2, Lanes>> grey_{};
  decltype(stages_of(Indices{})) stages_;
  decltype(configs_of(Indices{})) configs_;
  /// What each stage puts out; with `compete` the last one.
  std::conditional_t<compete, StripRow<Last>, decltype(rows_of(Indices{}))> rows_{};
  std::array<typename Behind::In, lanes * Shape::largest> row_{};
  Behind behind_;
};

}  // namespace horopter::native
