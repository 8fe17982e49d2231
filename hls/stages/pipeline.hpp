// SPDX-License-Identifier: Apache-2.0
// The native engine: all stages in a row, one call of step per beat as in the hardware, with the image store and the
// table in plain memory. Its states, runs and counts are what the hardware puts out, bit by bit.
//
// With HOROPTER_HLS_UNCHECKED the memories do not check themselves: use horopter::native (engine.hpp), which is built
// so, for speed; a program must not mix both.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "horopter/hls/lanes.hpp"
#include "stages/alarm.hpp"
#include "stages/compete_rows.hpp"
#include "stages/health.hpp"
#include "stages/interpolate.hpp"
#include "stages/lowpass.hpp"
#include "stages/map_expand.hpp"
#include "stages/runs.hpp"
#include "stages/subsample.hpp"

namespace horopter::native {

/// An 8-bit grey image of somebody else's.
struct ImageView {
  const std::uint8_t* pixels = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;  // bytes from row to row
};

/// The registers that decide what a frame's result is; names, units and defaults as in the register map.
struct Settings {
  int lookahead = 0;  // rows
  int sum_limit = 0;
  int self_limit = 0;
  int texture_limit = 0;  // sum over texture_window²
  int alarm_limit = 0;    // pixels of the result
  int undecidable_limit = 0;
  int unsupervised_limit = 0;
  int dark_level = 4;
  int bright_level = 251;
  int dark_limit = 0;  // incoming pixels
  int bright_limit = 0;
  int contrast_limit = 8;  // grey levels
  int frozen_limit = 1;    // repetitions, 0: off
  bool compete = false;    // the rule: competing planes instead of one threshold
  CompeteSettings competition;

  static constexpr int threshold_percent = 25;
  static constexpr int texture_threshold = 32;  // unscaled Sobel magnitude: 4 grey levels per pixel
  static constexpr int alarm_percent = 5;
  static constexpr int health_percent = 95;

  /// ⌊p · 15·k² / 100⌋.
  static constexpr int sum_limit_for(int percent, int window) { return percent * 15 * window * window / 100; }
  static constexpr int texture_limit_for(int threshold) {
    return threshold * stages::texture_window * stages::texture_window;
  }

  /// For incoming images of width × height.
  static constexpr Settings defaults(const hls::Profile& profile, int width, int height) {
    const int result = width / profile.subsample * height;
    Settings settings;
    settings.lookahead = profile.store_rows / 2;
    settings.sum_limit = sum_limit_for(threshold_percent, profile.dsad_window);
    settings.self_limit = profile.dsad_window * profile.dsad_window;
    settings.texture_limit = texture_limit_for(texture_threshold);
    settings.alarm_limit = result * alarm_percent / 100;
    settings.undecidable_limit = result;
    settings.unsupervised_limit = result;
    settings.dark_limit = width * height / 100 * health_percent;
    settings.bright_limit = settings.dark_limit;
    return settings;
  }
};

/// A mapping table in upload format: three header words, control points, CRC.
class TableView {
 public:
  explicit TableView(std::span<const std::uint32_t> words) : words_(words) {
    if (words.size() < 4 || (words[0] & 0xFFFFFF00U) != 0x484D0100U || spacing_x_log2() > 6 || spacing_y_log2() > 6 ||
        words.size() != 4 + std::size_t{2} * columns() * row_pairs() ||
        columns() != ((width() + (1 << spacing_x_log2()) - 1) >> spacing_x_log2()) + 1 ||
        2 * row_pairs() < ((height() + (1 << spacing_y_log2()) - 1) >> spacing_y_log2()) + 1) {
      throw std::invalid_argument("not a mapping table");
    }
  }

  [[nodiscard]] int spacing_x_log2() const { return static_cast<int>(words_[0] >> 4 & 15U); }
  [[nodiscard]] int spacing_y_log2() const { return static_cast<int>(words_[0] & 15U); }
  [[nodiscard]] int columns() const { return static_cast<int>(words_[1] & 0xFFFFU); }
  [[nodiscard]] int row_pairs() const { return static_cast<int>(words_[1] >> 16); }
  [[nodiscard]] int width() const { return static_cast<int>(words_[2] & 0xFFFFU); }
  [[nodiscard]] int height() const { return static_cast<int>(words_[2] >> 16); }
  [[nodiscard]] std::uint32_t crc() const { return words_.back(); }
  [[nodiscard]] std::span<const std::uint32_t> words() const { return words_; }

  [[nodiscard]] stages::ControlPoint control(int column, int row) const {
    const std::uint32_t word = words_[3 +
                                      (static_cast<std::size_t>(row / 2) * static_cast<std::size_t>(columns()) +
                                       static_cast<std::size_t>(column)) *
                                          2 +
                                      static_cast<std::size_t>(row % 2)];
    return {hls::u<16>(word), hls::u<16>(word >> 16)};
  }

 private:
  std::span<const std::uint32_t> words_;
};

struct Run {
  std::uint16_t row = 0;
  std::uint16_t start = 0;  // columns, inclusive
  std::uint16_t end = 0;
  std::uint8_t state = 0;
  friend bool operator==(const Run&, const Run&) = default;
};

struct ImageHealth {
  bool black = false;
  bool white = false;
  bool constant = false;
  bool frozen = false;
};

struct FrameResult {
  int width = 0;  // of the result, px
  int height = 0;
  std::vector<std::uint8_t> states;  // codes of horopter::stages::state, row by row
  std::vector<Run> runs;
  int skin_pixels = 0;
  int undecidable_pixels = 0;
  int unsupervised_pixels = 0;
  bool alarm = false;
  bool too_undecidable = false;
  bool too_unsupervised = false;
  std::int64_t store_misses = 0;  // pixels whose source row the ring does not hold
  ImageHealth left;
  ImageHealth right;
  bool identical_images = false;  // the same signature
};

template <hls::Profile P>
class Pipeline {
 public:
  static constexpr hls::Profile profile = P;

  /// One frame. `table`: for the size of the images. Throws std::invalid_argument for sizes the profile cannot take.
  FrameResult process(const ImageView& left, const ImageView& right, const TableView& table, const Settings& settings) {
    check(left, right, table, settings);
    begin(left, settings);
    FrameResult result;
    result.width = static_cast<int>(align_config_.width.value());
    result.height = left.height;
    result.states.resize(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height));
    written_ = 0;

    examine(left, right, result);
    const Expansion& sources = expansion(table, settings.lookahead);
    result.store_misses = sources.misses;
    store(right);
    for (int y = 0; y < left.height; ++y) {
      first_row_ = y == 0;
      fetch_row(y, left, sources);
      finish_row(result);
    }
    taps_.mask.fill(false);
    for (int y = 0; y < P.flush_rows(compete_); ++y) finish_row(result);
    return result;
  }

 private:
  static constexpr std::size_t table_slots = 15;
  static constexpr std::size_t padded_stride = P.width + 1;

  struct Nothing {};
  template <class Stage>
  using InOf = typename Stage::In;
  template <class Stage>
  using OutOf = typename Stage::Out;

  // The window stages see the row as eight strips side by side in the lanes of a vector: the same classes on another
  // kind of value. Each strip begins `lead` columns early, as far left as anything that its results depend on.
  using Lanes = hls::Lanes;
  static constexpr std::size_t lanes = static_cast<std::size_t>(hls::lanes::count);
  static constexpr std::size_t lead =
      static_cast<std::size_t>(2 * P.offset() + std::max(stages::self_shift, P.hypotheses - 1));
  static constexpr std::size_t largest_strip = (static_cast<std::size_t>(P.result_width()) + lanes - 1) / lanes;
  static constexpr int strip_beats = static_cast<int>(lead + largest_strip);

  using WideLowpass = stages::LowpassFilter<strip_beats, 2, 1, Lanes>;
  using WideSobel = stages::SobelFilter<strip_beats, 2, 1, Lanes>;
  using WideDirection = stages::DirectionFinder<2, Lanes>;
  using WideDifference = stages::DirectionDifference<P.hypotheses, Lanes>;
  using WideTexture =
      stages::TextureDetector<strip_beats, P.hypotheses, (P.dsad_window - 1) / 2, stages::texture_window, Lanes>;
  using WideDsad = stages::DsadSum<strip_beats, P.hypotheses, P.dsad_window, Lanes>;
  using WideThreshold = stages::SumThreshold<P.hypotheses, P.dsad_window, Lanes>;
  using WideMajority = stages::MajorityVote<strip_beats, P.majority_window, Lanes>;

  template <class T>
  using Row = std::array<T, P.width>;
  template <class T>
  using PaddedRow = std::array<T, lead + lanes * largest_strip>;
  template <class T>
  using StripRow = std::array<T, lead + largest_strip>;

  struct Taps {
    Row<hls::u<8>> p00, p01, p10, p11, left;
    Row<hls::u<P.weight_bits>> wx, wy;
    Row<bool> mask;
  };

  struct Pairs {
    Row<hls::u<8>> left, right;
    Row<bool> saturated, mask;
  };

  /// Column x of the result stands at lead + x; before and behind there is no image.
  struct PaddedPairs {
    PaddedRow<hls::u<8>> left, right;
    PaddedRow<bool> saturated, mask;
  };

  struct Strips {
    StripRow<stages::Grey<2, Lanes>> grey, smooth;
    StripRow<OutOf<WideSobel>> gradients;
    StripRow<OutOf<WideDirection>> directions;
    StripRow<OutOf<WideDifference>> differences;
    StripRow<OutOf<WideTexture>> textures;
    StripRow<OutOf<WideDsad>> sums;
    StripRow<OutOf<WideThreshold>> binaries;
    StripRow<OutOf<WideMajority>> votes;
  };

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

   private:
    Stage& owner_;
    Stage stage_;
  };

  static void check(const ImageView& left, const ImageView& right, const TableView& table, const Settings& settings) {
    const auto fail = [](const std::string& what) { throw std::invalid_argument(what); };
    if (left.width != right.width || left.height != right.height) fail("left and right image differ in size");
    if (left.width > P.width || left.height > P.height) fail("the image is larger than the profile");
    if (left.width % P.subsample != 0 || left.width < hls::min_row_beats * 2 * P.subsample) {
      fail("the width must be a multiple of the sub-sampling and at least " +
           std::to_string(hls::min_row_beats * 2 * P.subsample));
    }
    if (left.height < 16) fail("the height must be at least 16");
    if (table.width() != left.width || table.height() != left.height) fail("the table is for another image size");
    if (!P.has(settings.compete ? hls::Rule::compete : hls::Rule::thesis)) fail("the profile does not have this rule");
    if (settings.lookahead < 0 || settings.lookahead > P.store_rows / 2) fail("LOOKAHEAD is more than half the ring");
  }

  void begin(const ImageView& image, const Settings& settings) {
    texture_config_.texture_limit = settings.texture_limit;
    threshold_config_.sum_limit = settings.sum_limit;
    threshold_config_.self_limit = settings.self_limit;
    compete_ = settings.compete;
    if constexpr (P.has_compete()) competition_.begin(image.width / P.subsample, settings.competition);
    if constexpr (requires { align_config_.compete; }) align_config_.compete = compete_;
    align_config_.width = image.width / P.subsample;
    align_config_.height = image.height;
    alarm_config_.alarm_limit = settings.alarm_limit;
    alarm_config_.undecidable_limit = settings.undecidable_limit;
    alarm_config_.unsupervised_limit = settings.unsupervised_limit;
    health_config_.dark_level = settings.dark_level;
    health_config_.bright_level = settings.bright_level;
    health_config_.dark_limit = settings.dark_limit;
    health_config_.bright_limit = settings.bright_limit;
    health_config_.contrast_limit = settings.contrast_limit;
    health_config_.frozen_limit = settings.frozen_limit;
    width_ = image.width;
    result_width_ = image.width / P.subsample;
    strip_ = (index(result_width_) + lanes - 1) / lanes;
    beats_ = lead + strip_;
    grey_.mask.fill(false);
  }

  static constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }

  using Health = stages::Health<P>;

  /// Both cameras at once: two independent chains of CRC keep the CPU busy.
  [[gnu::flatten]] void examine(const ImageView& left, const ImageView& right, FrameResult& result) {
    Borrowed left_health(left_health_);
    Borrowed right_health(right_health_);
    const auto feed = [&](std::uint8_t l, std::uint8_t r, bool first, bool end) {
      const OutOf<Health> of_left = left_health->step({l, first, end}, health_config_);
      const OutOf<Health> of_right = right_health->step({r, first, end}, health_config_);
      if (end) {
        result.left = {of_left.black, of_left.white, of_left.constant, of_left.frozen};
        result.right = {of_right.black, of_right.white, of_right.constant, of_right.frozen};
        result.identical_images = of_left.signature == of_right.signature;
      }
    };
    const int last_row = left.height - 1;
    for (int y = 0; y <= last_row; ++y) {
      const std::uint8_t* l = left.pixels + y * left.stride;
      const std::uint8_t* r = right.pixels + y * right.stride;
      const int begin = y == 0 ? 1 : 0;
      const int end = width_ - (y == last_row ? 1 : 0);
      if (y == 0) feed(l[0], r[0], true, false);
      for (int x = begin; x < end; ++x) feed(l[x], r[x], false, false);
      if (y == last_row) feed(l[width_ - 1], r[width_ - 1], false, true);
    }
  }

  /// What map_expand and the image store's addressing make of a table: the same for every frame.
  struct Expansion {
    std::vector<std::uint32_t> words;
    int lookahead = 0;
    std::int64_t misses = 0;
    // Per pixel, row by row:
    std::vector<std::uint32_t> offset;  // of the top left source pixel in padded_
    std::vector<hls::u<P.weight_bits>> wx, wy;
    std::vector<char> mask;
  };

  /// As many tables as the hardware has slots are kept, the most recent first.
  const Expansion& expansion(const TableView& table, int lookahead) {
    const auto known = std::find_if(expansions_.begin(), expansions_.end(), [&](const Expansion& e) {
      return e.lookahead == lookahead && e.words.size() == table.words().size() &&
             e.words.back() == table.words().back() &&
             std::equal(e.words.begin(), e.words.end(), table.words().begin());
    });
    if (known != expansions_.end()) {
      std::rotate(expansions_.begin(), known, known + 1);
    } else {
      if (expansions_.size() == table_slots) expansions_.pop_back();
      expansions_.insert(expansions_.begin(), expand(table, lookahead));
    }
    return expansions_.front();
  }

  Expansion expand(const TableView& table, int lookahead) {
    Expansion result;
    result.words.assign(table.words().begin(), table.words().end());
    result.lookahead = lookahead;
    const std::size_t pixels = index(table.width()) * index(table.height());
    result.offset.reserve(pixels);
    result.wx.reserve(pixels);
    result.wy.reserve(pixels);
    result.mask.reserve(pixels);
    const int cell_mask = (1 << table.spacing_x_log2()) - 1;
    map_config_.spacing_x_log2 = table.spacing_x_log2();
    for (int y = 0; y < table.height(); ++y) {
      const int cell_row = y >> table.spacing_y_log2();
      InOf<stages::MapExpand<P>> in;
      in.row_fraction = (y - (cell_row << table.spacing_y_log2())) << (6 - table.spacing_y_log2());
      const auto fetch = [&](int column) {
        return stages::ControlPair{table.control(column, cell_row), table.control(column, cell_row + 1)};
      };
      in.prime = true;
      in.column = fetch(0);
      map_expand_.step(in, map_config_);
      in.prime = false;
      for (int x = 0; x < table.width(); ++x) {
        in.load = (x & cell_mask) == 0;
        if (in.load) in.column = fetch((x >> table.spacing_x_log2()) + 1);
        locate(y, map_expand_.step(in, map_config_), table, result);
      }
    }
    return result;
  }

  /// The image store: is the source in the image, and in the ring when output row y is made? A pixel of weight 0 is not
  /// needed.
  void locate(int y, const OutOf<stages::MapExpand<P>>& source, const TableView& table, Expansion& result) const {
    const int x = source.x.value();
    const int row = source.y.value();
    const int last_x = x + (source.wx != 0 ? 1 : 0);
    const int last_row = row + (source.wy != 0 ? 1 : 0);
    bool mask = source.mapped && last_x < table.width() && last_row < table.height();
    if (mask && (row < y - (P.store_rows / 2 - 2) || last_row > y + result.lookahead)) {
      ++result.misses;
      mask = false;
    }
    result.offset.push_back(mask ? static_cast<std::uint32_t>(index(row) * padded_stride + index(x)) : 0);
    result.wx.push_back(source.wx);
    result.wy.push_back(source.wy);
    result.mask.push_back(mask);
  }

  /// The right image with a column and a row more, so that pixels of weight 0 can be read.
  void store(const ImageView& right) {
    padded_.resize(padded_stride * (P.height + 1));
    for (int y = 0; y < right.height; ++y) {
      std::copy_n(right.pixels + y * right.stride, right.width, padded_.begin() + y * std::ptrdiff_t{padded_stride});
    }
  }

  void fetch_row(int y, const ImageView& left, const Expansion& sources) {
    const std::size_t begin = index(y) * index(width_);
    const std::uint32_t* offset = sources.offset.data() + begin;
    const std::uint8_t* pixels = padded_.data();
    Taps& taps = taps_;
    const std::size_t n = index(width_);
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint8_t* top = pixels + offset[i];
      taps.p00[i] = top[0];
      taps.p01[i] = top[1];
      taps.p10[i] = top[padded_stride];
      taps.p11[i] = top[padded_stride + 1];
    }
    std::copy_n(sources.wx.data() + begin, n, taps.wx.begin());
    std::copy_n(sources.wy.data() + begin, n, taps.wy.begin());
    std::copy_n(sources.mask.data() + begin, n, taps.mask.begin());
    const std::uint8_t* waiting = left.pixels + y * left.stride;
    if constexpr (P.subsample == 1) {
      std::copy_n(waiting, n, taps.left.begin());
    } else {  // the left store keeps the mean of a pair only
      for (std::size_t i = 0; i + 1 < n; i += 2) {
        taps.left[i] = taps.left[i + 1] = static_cast<std::uint8_t>((waiting[i] + waiting[i + 1] + 1) / 2);
      }
    }
  }

  /// Passes a row of beats through all stages from the interpolation on. A stage takes the whole row before the next
  /// stage begins: the same as beat by beat, as none feeds back.
  void finish_row(FrameResult& result) {
    if constexpr (P.subsample == 1) {
      interpolate_row(grey_, lead);
    } else {
      interpolate_row(pairs_, 0);
      subsample_row();
    }
    if constexpr (P.has_compete()) {
      if (compete_) return compete_row(result);
    }
    load_strips();
    pass(lowpass_, strips_.grey, strips_.smooth);
    pass(sobel_, strips_.smooth, strips_.gradients);
    pass(direction_, strips_.gradients, strips_.directions);
    pass(difference_, strips_.directions, strips_.differences);
    pass(texture_, strips_.differences, strips_.textures, texture_config_);
    pass(dsad_, strips_.textures, strips_.sums);
    pass(threshold_, strips_.sums, strips_.binaries, threshold_config_);
    pass(majority_, strips_.binaries, strips_.votes);
    emit_row(result);
  }

  /// Fields in arrays of their own: the compiler vectorises this stage without state.
  template <class To>
  [[gnu::flatten]] void interpolate_row(To& to, std::size_t begin) {
    stages::Interpolate<P> stage;
    const Taps& from = taps_;
    hls::u<8>* __restrict left = to.left.data() + begin;
    hls::u<8>* __restrict right = to.right.data() + begin;
    bool* __restrict saturated = to.saturated.data() + begin;
    bool* __restrict mask = to.mask.data() + begin;
    const std::size_t n = index(width_);
    for (std::size_t i = 0; i < n; ++i) {
      InOf<stages::Interpolate<P>> in;
      in.p00 = from.p00[i];
      in.p01 = from.p01[i];
      in.p10 = from.p10[i];
      in.p11 = from.p11[i];
      in.wx = from.wx[i];
      in.wy = from.wy[i];
      in.left = from.left[i];
      in.mask = from.mask[i];
      const stages::GreyPair out = stage.step(in);
      left[i] = out.pixel[0];
      right[i] = out.pixel[1];
      saturated[i] = out.saturated;
      mask[i] = out.mask;
    }
  }

  [[gnu::flatten]] void subsample_row() {
    Borrowed stage(subsample_);
    std::size_t written = lead;
    for (std::size_t i = 0; i < index(width_); ++i) {
      stages::GreyPair in;
      in.pixel = {pairs_.left[i], pairs_.right[i]};
      in.saturated = pairs_.saturated[i];
      in.mask = pairs_.mask[i];
      in.marks = {i == 0 && first_row_, i + 1 == index(width_)};
      const auto out = stage->step(in);
      if (out.valid) {
        grey_.left[written] = out.pixel[0];
        grey_.right[written] = out.pixel[1];
        grey_.saturated[written] = out.saturated;
        grey_.mask[written] = out.mask;
        ++written;
      }
    }
  }

  void load_strips() {
    for (std::size_t beat = 0; beat < beats_; ++beat) {
      auto& to = strips_.grey[beat];
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const std::size_t from = lane * strip_ + beat;
        const int l = static_cast<int>(lane);
        to.pixel[0].set_lane(l, grey_.left[from]);
        to.pixel[1].set_lane(l, grey_.right[from]);
        to.saturated.set_lane(l, grey_.saturated[from]);
        to.mask.set_lane(l, grey_.mask[from]);
      }
      to.marks = {beat == 0 && first_row_, beat + 1 == beats_};
    }
  }

  template <class Stage, class From, class To, class... Config>
  [[gnu::flatten]] void pass(Stage& owner, const From& from, To& to, const Config&... config) {
    Borrowed stage(owner);
    const std::size_t n = beats_;
    for (std::size_t i = 0; i < n; ++i) {
      if constexpr (std::is_same_v<typename From::value_type, typename Stage::In>) {
        to[i] = stage->step(from[i], config...);
      } else {
        to[i] = stage->step(input_of(from[i]), config...);
      }
    }
  }

  // Out of a stage → In of the next, where the types differ by name only.
  static InOf<WideDsad> input_of(const OutOf<WideTexture>& o) { return {o.difference, o.textured, o.mask, o.marks}; }
  static InOf<WideThreshold> input_of(const OutOf<WideDsad>& o) { return {o.sum, o.textured, o.mask, o.marks}; }
  static InOf<WideMajority> input_of(const OutOf<WideThreshold>& o) { return {o.skin, o.decidable, o.mask, o.marks}; }

  [[gnu::flatten]] void emit_row(FrameResult& result) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      for (std::size_t i = 0; i < strip_; ++i) {
        votes_[lane * strip_ + i] = strips_.votes[lead + i].state.lane(static_cast<int>(lane));
      }
    }
    Borrowed align(align_);
    Borrowed runs(runs_);
    Borrowed alarm(alarm_);
    const int n = result_width_;
    for (int x = 0; x < n; ++x) {
      const auto pixel = align->step({votes_[index(x)], {x == 0 && first_row_, x + 1 == n}}, align_config_);
      if (pixel.valid) emit(pixel, *runs.operator->(), *alarm.operator->(), result);
    }
  }

  void emit(const OutOf<stages::Align<P>>& pixel, stages::Runs<P>& runs, stages::Alarm<P>& alarm, FrameResult& result) {
    if (!pixel.idle) [[likely]] {
      result.states[written_++] = pixel.state.value();
    }
    const auto run = runs.step({pixel.state, pixel.first, pixel.last, pixel.idle});
    if (run.valid) add_run(run, result);
    const auto counts = alarm.step({pixel.state, pixel.first, pixel.end, pixel.idle}, alarm_config_);
    if (counts.valid) [[unlikely]] {
      set_counts(counts, result);
    }
  }

  /// The same with the rule `compete`.
  void compete_row(FrameResult& result) {
    const auto source = [&](int x) {
      const std::size_t at = lead + index(x);
      return CompetePixel{grey_.left[at], grey_.right[at], grey_.saturated[at], grey_.mask[at]};
    };
    competition_.row(source, first_row_, [&](const OutOf<stages::Consensus<P>>& out) {
      const auto pixel = align_.step({out.state, out.marks}, align_config_);
      if (pixel.valid) emit(pixel, runs_, alarm_, result);
    });
  }

  [[gnu::noinline]] static void add_run(const OutOf<stages::Runs<P>>& run, FrameResult& result) {
    result.runs.push_back({static_cast<std::uint16_t>(run.row.value()), static_cast<std::uint16_t>(run.start.value()),
                           static_cast<std::uint16_t>(run.end.value()), run.state.value()});
  }

  [[gnu::noinline]] static void set_counts(const OutOf<stages::Alarm<P>>& counts, FrameResult& result) {
    result.skin_pixels = static_cast<int>(counts.skin_pixels.value());
    result.undecidable_pixels = static_cast<int>(counts.undecidable_pixels.value());
    result.unsupervised_pixels = static_cast<int>(counts.unsupervised_pixels.value());
    result.alarm = counts.alarm;
    result.too_undecidable = counts.too_undecidable;
    result.too_unsupervised = counts.too_unsupervised;
  }

#define HOROPTER_STAGE(name, Class, rule) \
  static_assert(std::is_default_constructible_v<std::conditional_t<P.has(hls::Rule::rule), stages::Class<P>, Nothing>>);
#include "stages/stage_list.def"
#undef HOROPTER_STAGE

  stages::MapExpand<P> map_expand_;
  stages::Subsampler<P.subsample> subsample_;
  WideLowpass lowpass_;
  WideSobel sobel_;
  WideDirection direction_;
  WideDifference difference_;
  WideTexture texture_;
  WideDsad dsad_;
  WideThreshold threshold_;
  WideMajority majority_;
  stages::Align<P> align_;
  stages::Runs<P> runs_;
  stages::Alarm<P> alarm_;
  Health left_health_;
  Health right_health_;

  typename stages::MapExpand<P>::Config map_config_;
  typename WideTexture::Config texture_config_;
  typename WideThreshold::Config threshold_config_;
  typename stages::Align<P>::Config align_config_;
  typename stages::Alarm<P>::Config alarm_config_;
  typename Health::Config health_config_;

  std::conditional_t<P.has_compete(), CompeteRows<P>, Nothing> competition_;
  bool compete_ = false;

  std::size_t written_ = 0;  // pixels of the result
  int width_ = 0;
  int result_width_ = 0;
  std::size_t strip_ = 0;  // columns of a strip
  std::size_t beats_ = 0;  // and beats: lead columns more
  bool first_row_ = false;
  std::vector<Expansion> expansions_;
  std::vector<std::uint8_t> padded_;
  Taps taps_{};
  Pairs pairs_{};
  PaddedPairs grey_{};
  Strips strips_{};
  std::array<hls::u<2>, lanes * largest_strip> votes_{};
};

}  // namespace horopter::native
