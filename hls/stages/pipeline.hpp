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

#include "stages/alarm.hpp"
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
      mark(y == 0);
      fetch_row(y, left, sources);
      finish_row(result);
    }
    taps_.mask.fill(false);
    for (int y = 0; y < P.flush_rows(); ++y) finish_row(result);
    return result;
  }

 private:
  static constexpr std::size_t table_slots = 15;
  static constexpr std::size_t padded_stride = P.width + 1;

  template <class Stage>
  using InOf = typename Stage::In;
  template <class Stage>
  using OutOf = typename Stage::Out;

  // One row of beats after each stage; marks are the same after all of them.
  template <class T>
  using Row = std::array<T, P.width>;
  template <class T>
  using ResultRow = std::array<T, P.result_width()>;

  struct Taps {
    Row<hls::u<8>> p00, p01, p10, p11, left;
    Row<hls::u<P.weight_bits>> wx, wy;
    Row<bool> mask;
  };

  struct Pairs {
    Row<hls::u<8>> left, right;
    Row<bool> saturated, mask;

    [[nodiscard]] stages::GreyPair get(std::size_t i, stages::Marks marks) const {
      return {{left[i], right[i]}, saturated[i], mask[i], marks};
    }
    template <class Beat>
    void set(std::size_t i, const Beat& beat) {
      left[i] = beat.pixel[0];
      right[i] = beat.pixel[1];
      saturated[i] = beat.saturated;
      mask[i] = beat.mask;
    }
  };

  struct GradientRow {
    std::array<ResultRow<hls::s<11>>, 2> gx, gy;
    ResultRow<bool> saturated, mask;
  };

  struct DirectionRow {
    std::array<ResultRow<hls::u<8>>, 2> direction, magnitude;
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
    if (settings.lookahead < 0 || settings.lookahead > P.store_rows / 2) fail("LOOKAHEAD is more than half the ring");
  }

  void begin(const ImageView& image, const Settings& settings) {
    texture_config_.texture_limit = settings.texture_limit;
    threshold_config_.sum_limit = settings.sum_limit;
    threshold_config_.self_limit = settings.self_limit;
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
    last_.fill(false);
    last_[index(width_ - 1)] = true;
    result_last_.fill(false);
    result_last_[index(result_width_ - 1)] = true;
  }

  static constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }

  /// Marks of the next row of beats; the stages pass them on unchanged.
  void mark(bool first_row) {
    first_[0] = first_row;
    result_first_[0] = first_row;
  }

  using Health = stages::Health<P>;

  /// Both cameras at once: two independent chains of CRC keep the CPU busy.
  [[gnu::flatten]] void examine(const ImageView& left, const ImageView& right, FrameResult& result) {
    Borrowed left_health(left_health_);
    Borrowed right_health(right_health_);
    InOf<Health> in;
    for (int y = 0; y < left.height; ++y) {
      const std::uint8_t* left_row = left.pixels + y * left.stride;
      const std::uint8_t* right_row = right.pixels + y * right.stride;
      const int end = y + 1 == left.height ? width_ - 1 : -1;
      in.first = y == 0;
      for (int x = 0; x < width_; ++x) {
        in.end = x == end;
        in.pixel = left_row[x];
        const OutOf<Health> l = left_health->step(in, health_config_);
        in.pixel = right_row[x];
        const OutOf<Health> r = right_health->step(in, health_config_);
        if (in.end) [[unlikely]] {
          result.left = {l.black, l.white, l.constant, l.frozen};
          result.right = {r.black, r.white, r.constant, r.frozen};
        }
        in.first = false;
      }
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
    std::copy_n(left.pixels + y * left.stride, n, taps.left.begin());
  }

  /// Passes a row of beats through all stages from the interpolation on. A stage takes the whole row before the next
  /// stage begins: the same as beat by beat, as none feeds back. Rows lie field by field, so that the compiler can
  /// vectorise stages without state.
  void finish_row(FrameResult& result) {
    interpolate_row();
    const Pairs* grey = &pairs_;
    if constexpr (P.subsample > 1) {
      subsample_row();
      grey = &halved_;
    }
    filter_row(lowpass_, *grey, smooth_);
    sobel_row();
    direction_row();
    sum_row();
    vote_row(result);
  }

  [[gnu::flatten]] void interpolate_row() {
    stages::Interpolate<P> stage;  // has no state
    const Taps& from = taps_;
    Pairs& to = pairs_;
    const int n = width_;
    for (int i = 0; i < n; ++i) {
      InOf<stages::Interpolate<P>> in;
      in.p00 = from.p00[index(i)];
      in.p01 = from.p01[index(i)];
      in.p10 = from.p10[index(i)];
      in.p11 = from.p11[index(i)];
      in.wx = from.wx[index(i)];
      in.wy = from.wy[index(i)];
      in.left = from.left[index(i)];
      in.mask = from.mask[index(i)];
      const stages::GreyPair out = stage.step(in);
      to.left[index(i)] = out.pixel[0];
      to.right[index(i)] = out.pixel[1];
      to.saturated[index(i)] = out.saturated;
      to.mask[index(i)] = out.mask;
    }
  }

  [[gnu::flatten]] void subsample_row() {
    Borrowed stage(subsample_);
    std::size_t written = 0;
    for (int i = 0; i < width_; ++i) {
      const auto out = stage->step(pairs_.get(index(i), {first_[index(i)], last_[index(i)]}));
      if (out.valid) {
        halved_.set(written, out);
        ++written;
      }
    }
  }

  template <class Stage>
  [[gnu::flatten]] void filter_row(Stage& filter, const Pairs& from, Pairs& to) {
    Borrowed stage(filter);
    for (int i = 0; i < result_width_; ++i) to.set(index(i), stage->step(from.get(index(i), marks(i))));
  }

  [[gnu::flatten]] void sobel_row() {
    Borrowed stage(sobel_);
    for (int i = 0; i < result_width_; ++i) {
      const auto out = stage->step(smooth_.get(index(i), marks(i)));
      for (std::size_t lane = 0; lane < 2; ++lane) {
        gradients_.gx[lane][index(i)] = out.gx[lane];
        gradients_.gy[lane][index(i)] = out.gy[lane];
      }
      gradients_.saturated[index(i)] = out.saturated;
      gradients_.mask[index(i)] = out.mask;
    }
  }

  [[gnu::flatten]] void direction_row() {
    stages::DirectionFinder<1> stage;  // has no state, and does with both images the same
    const int n = result_width_;
    for (std::size_t lane = 0; lane < 2; ++lane) {
      const hls::s<11>* gx = gradients_.gx[lane].data();
      const hls::s<11>* gy = gradients_.gy[lane].data();
      hls::u<8>* __restrict direction = directions_.direction[lane].data();
      hls::u<8>* __restrict magnitude = directions_.magnitude[lane].data();
#pragma clang loop vectorize(enable)
      for (int i = 0; i < n; ++i) {
        stages::Gradients<1> in;
        in.gx[0] = gx[i];
        in.gy[0] = gy[i];
        const stages::Directions<1> out = stage.step(in);
        direction[i] = out.direction[0];
        magnitude[i] = out.magnitude[0];
      }
    }
  }

  [[gnu::flatten]] void sum_row() {
    Borrowed difference(difference_);
    for (int i = 0; i < result_width_; ++i) {
      stages::Directions<2> in;
      for (std::size_t lane = 0; lane < 2; ++lane) {
        in.direction[lane] = directions_.direction[lane][index(i)];
        in.magnitude[lane] = directions_.magnitude[lane][index(i)];
      }
      in.saturated = gradients_.saturated[index(i)];
      in.mask = gradients_.mask[index(i)];
      in.marks = marks(i);
      differences_[index(i)] = difference->step(in);
    }
    Borrowed texture(texture_);
    for (int i = 0; i < result_width_; ++i) {
      const auto out = texture->step(differences_[index(i)], texture_config_);
      textures_[index(i)] = {out.difference, out.textured, out.mask, out.marks};
    }
    Borrowed dsad(dsad_);
    for (int i = 0; i < result_width_; ++i) {
      const auto out = dsad->step(textures_[index(i)]);
      sums_[index(i)] = {out.sum, out.textured, out.mask, out.marks};
    }
  }

  [[gnu::flatten]] void vote_row(FrameResult& result) {
    Borrowed majority(majority_);
    for (int i = 0; i < result_width_; ++i) {
      const auto in = threshold_.step(sums_[index(i)], threshold_config_);
      votes_[index(i)] = majority->step({in.skin, in.decidable, in.mask, in.marks});
    }
    for (int i = 0; i < result_width_; ++i) {
      emit(align_.step({votes_[index(i)].state, votes_[index(i)].marks}, align_config_), result);
    }
  }

  void emit(const OutOf<stages::Align<P>>& pixel, FrameResult& result) {
    if (!pixel.valid) return;
    if (!pixel.idle) [[likely]] {
      result.states[written_++] = pixel.state.value();
    }
    const auto run = runs_.step({pixel.state, pixel.first, pixel.last, pixel.idle});
    if (run.valid) {
      result.runs.push_back({static_cast<std::uint16_t>(run.row.value()), static_cast<std::uint16_t>(run.start.value()),
                             static_cast<std::uint16_t>(run.end.value()), run.state.value()});
    }
    const auto alarm = alarm_.step({pixel.state, pixel.first, pixel.end, pixel.idle}, alarm_config_);
    if (alarm.valid) {
      result.skin_pixels = static_cast<int>(alarm.skin_pixels.value());
      result.undecidable_pixels = static_cast<int>(alarm.undecidable_pixels.value());
      result.unsupervised_pixels = static_cast<int>(alarm.unsupervised_pixels.value());
      result.alarm = alarm.alarm;
      result.too_undecidable = alarm.too_undecidable;
      result.too_unsupervised = alarm.too_unsupervised;
    }
  }

#define HOROPTER_STAGE(name, Class) static_assert(std::is_default_constructible_v<stages::Class<P>>);
#include "stages/stage_list.def"
#undef HOROPTER_STAGE

  stages::MapExpand<P> map_expand_;
  stages::Interpolate<P> interpolate_;
  stages::Subsample<P> subsample_;
  stages::Lowpass<P> lowpass_;
  stages::Sobel<P> sobel_;
  stages::Direction<P> direction_;
  stages::Difference<P> difference_;
  stages::Texture<P> texture_;
  stages::Dsad<P> dsad_;
  stages::Threshold<P> threshold_;
  stages::Majority<P> majority_;
  stages::Align<P> align_;
  stages::Runs<P> runs_;
  stages::Alarm<P> alarm_;
  Health left_health_;
  Health right_health_;

  typename stages::MapExpand<P>::Config map_config_;
  typename stages::Texture<P>::Config texture_config_;
  typename stages::Threshold<P>::Config threshold_config_;
  typename stages::Align<P>::Config align_config_;
  typename stages::Alarm<P>::Config alarm_config_;
  typename Health::Config health_config_;

  [[nodiscard]] stages::Marks marks(int i) const { return {result_first_[index(i)], result_last_[index(i)]}; }

  std::size_t written_ = 0;  // pixels of the result
  int width_ = 0;
  int result_width_ = 0;
  Row<bool> first_{};
  Row<bool> last_{};
  ResultRow<bool> result_first_{};
  ResultRow<bool> result_last_{};
  std::vector<Expansion> expansions_;
  std::vector<std::uint8_t> padded_;
  Taps taps_{};
  Pairs pairs_{};
  Pairs halved_{};
  Pairs smooth_{};
  GradientRow gradients_{};
  DirectionRow directions_{};
  ResultRow<OutOf<stages::Difference<P>>> differences_{};
  ResultRow<InOf<stages::Dsad<P>>> textures_{};
  ResultRow<InOf<stages::Threshold<P>>> sums_{};
  ResultRow<OutOf<stages::Majority<P>>> votes_{};
};

}  // namespace horopter::native
