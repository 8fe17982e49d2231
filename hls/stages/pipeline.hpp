// SPDX-License-Identifier: Apache-2.0
// The native engine: all stages in a row, one call of step per beat as in the hardware, with the image store and the
// table in plain memory. Its states, runs and counts are what the hardware puts out, bit by bit.
//
// With HOROPTER_HLS_UNCHECKED the memories do not check themselves: use horopter::native (engine.hpp), which is built
// so, for speed; a program must not mix both.
#pragma once

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
    result.states.reserve(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height));

    examine(left, left_health_, result.left);
    examine(right, right_health_, result.right);
    for (int y = 0; y < left.height; ++y) {
      expand_row(y, table);
      fetch_row(y, left, right, settings.lookahead, result.store_misses);
      finish_row(result);
    }
    for (int y = 0; y < P.flush_rows(); ++y) {
      for (int x = 0; x < left.width; ++x) {
        taps_[static_cast<std::size_t>(x)] = {};
        taps_[static_cast<std::size_t>(x)].marks.last = x + 1 == left.width;
      }
      finish_row(result);
    }
    return result;
  }

 private:
  template <class Stage>
  using InOf = typename Stage::In;
  template <class Stage>
  using OutOf = typename Stage::Out;

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
    map_config_ = {};
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
    sources_.resize(static_cast<std::size_t>(image.width));
    taps_.resize(static_cast<std::size_t>(image.width));
  }

  using Health = stages::Health<P>;

  void examine(const ImageView& image, Health& health, ImageHealth& result) {
    InOf<Health> in;
    for (int y = 0; y < image.height; ++y) {
      const std::uint8_t* row = image.pixels + y * image.stride;
      for (int x = 0; x < image.width; ++x) {
        in.pixel = row[x];
        in.first = x == 0 && y == 0;
        in.end = x + 1 == image.width && y + 1 == image.height;
        const OutOf<Health> out = health.step(in, health_config_);
        if (out.valid) result = {out.black, out.white, out.constant, out.frozen};
      }
    }
  }

  /// Sources of one row of pixels.
  void expand_row(int y, const TableView& table) {
    const int cell_row = y >> table.spacing_y_log2();
    const int fraction = (y - (cell_row << table.spacing_y_log2())) << (6 - table.spacing_y_log2());
    const int cell_mask = (1 << table.spacing_x_log2()) - 1;
    map_config_.spacing_x_log2 = table.spacing_x_log2();
    InOf<stages::MapExpand<P>> in;
    in.row_fraction = fraction;
    const auto fetch = [&](int column) {
      return stages::ControlPair{table.control(column, cell_row), table.control(column, cell_row + 1)};
    };
    stages::MapExpand<P> expand = map_expand_;
    in.prime = true;
    in.column = fetch(0);
    expand.step(in, map_config_);
    in.prime = false;
    const int width = table.width();
    for (int x = 0; x < width; ++x) {
      in.load = (x & cell_mask) == 0;
      if (in.load) in.column = fetch((x >> table.spacing_x_log2()) + 1);
      in.marks.first = x == 0 && y == 0;
      in.marks.last = x + 1 == width;
      in.marks.live = true;
      sources_[static_cast<std::size_t>(x)] = expand.step(in, map_config_);
    }
    map_expand_ = expand;
  }

  /// The image store: 2×2 pixels of each source, as far as it holds them.
  void fetch_row(int y, const ImageView& left, const ImageView& right, int lookahead, std::int64_t& misses) {
    const int oldest = y - (P.store_rows / 2 - 2);
    const int newest = y + lookahead;
    const std::uint8_t* left_row = left.pixels + y * left.stride;
    for (int i = 0; i < left.width; ++i) {
      const auto& source = sources_[static_cast<std::size_t>(i)];
      InOf<stages::Interpolate<P>> in;
      const int x = source.x.value();
      const int row = source.y.value();
      const int right_of = source.wx != 0 ? 1 : 0;  // a pixel of weight 0 is not needed
      const int below = source.wy != 0 ? 1 : 0;
      if (source.mapped && x + right_of < right.width && row + below < right.height) {
        if (row >= oldest && row + below <= newest) {
          const std::uint8_t* top = right.pixels + row * right.stride + x;
          const std::uint8_t* bottom = top + below * right.stride;
          in.p00 = top[0];
          in.p01 = top[right_of];
          in.p10 = bottom[0];
          in.p11 = bottom[right_of];
          in.mask = true;
        } else {
          ++misses;
        }
      }
      in.wx = source.wx;
      in.wy = source.wy;
      in.left = left_row[i];
      in.marks.first = source.marks.first;
      in.marks.last = source.marks.last;
      taps_[static_cast<std::size_t>(i)] = in;
    }
  }

  /// Passes a row of beats through all stages from the interpolation on. A stage takes the whole row before the next
  /// stage begins: the same as beat by beat, as none feeds back, and several times faster.
  void finish_row(FrameResult& result) {
    pass(interpolate_, taps_, pairs_, [](const auto& in) { return in; });
    subsample();
    pass(lowpass_, grey_, smooth_, [](const auto& in) { return in; });
    pass(sobel_, smooth_, gradients_, [](const auto& in) { return in; });
    pass(direction_, gradients_, directions_, [](const auto& in) { return in; });
    pass(difference_, directions_, differences_, [](const auto& in) { return in; });
    pass(texture_, differences_, textures_, [](const auto& in) { return in; }, texture_config_);
    pass(dsad_, textures_, sums_,
         [](const auto& in) { return InOf<stages::Dsad<P>>{in.difference, in.textured, in.mask, in.marks}; });
    pass(
        threshold_, sums_, binaries_,
        [](const auto& in) { return InOf<stages::Threshold<P>>{in.sum, in.textured, in.mask, in.marks}; },
        threshold_config_);
    pass(majority_, binaries_, votes_,
         [](const auto& in) { return InOf<stages::Majority<P>>{in.skin, in.decidable, in.mask, in.marks}; });
    for (const auto& vote : votes_) emit(align_.step({vote.state, vote.marks}, align_config_), result);
  }

  template <class Stage, class From, class To, class Convert, class... Config>
  static void pass(Stage& stage, const std::vector<From>& from, std::vector<To>& to, const Convert& convert,
                   const Config&... config) {
    to.resize(from.size());
    // A local copy lets the compiler keep the registers in registers: bytes written to `to` cannot alias it.
    Stage local = std::move(stage);
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = local.step(convert(from[i]), config...);
    stage = std::move(local);
  }

  void subsample() {
    grey_.clear();
    for (const stages::GreyPair& pair : pairs_) {
      const OutOf<stages::Subsample<P>> out = subsample_.step(pair);
      if (out.valid) grey_.push_back({out.pixel, out.saturated, out.mask, out.marks});
    }
  }

  void emit(const OutOf<stages::Align<P>>& pixel, FrameResult& result) {
    if (!pixel.valid) return;
    if (!pixel.idle) result.states.push_back(pixel.state.value());
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

  // One row of beats after each stage.
  std::vector<OutOf<stages::MapExpand<P>>> sources_;
  std::vector<InOf<stages::Interpolate<P>>> taps_;
  std::vector<stages::GreyPair> pairs_;
  std::vector<stages::GreyPair> grey_;
  std::vector<stages::GreyPair> smooth_;
  std::vector<OutOf<stages::Sobel<P>>> gradients_;
  std::vector<OutOf<stages::Direction<P>>> directions_;
  std::vector<OutOf<stages::Difference<P>>> differences_;
  std::vector<OutOf<stages::Texture<P>>> textures_;
  std::vector<OutOf<stages::Dsad<P>>> sums_;
  std::vector<OutOf<stages::Threshold<P>>> binaries_;
  std::vector<OutOf<stages::Majority<P>>> votes_;
};

}  // namespace horopter::native
