// SPDX-License-Identifier: Apache-2.0
// The native engine: the stages of the chain, a row at a time, with the image store and the table in plain memory. Its
// states, runs and counts are what the hardware puts out, bit by bit.
//
// With HOROPTER_HLS_UNCHECKED the memories do not check themselves: use horopter::native (engine.hpp), which is built
// so, for speed; a program must not mix both.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "horopter/hls/settings.hpp"
#include "stages/chain.hpp"
#include "stages/strips.hpp"
#include "stages/table_view.hpp"
#include "stages/workers.hpp"

namespace horopter::native {

/// An 8-bit grey image of somebody else's.
struct ImageView {
  const std::uint8_t* pixels = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;  // bytes from row to row
};

using hls::CompeteSettings;

/// The registers that decide what a frame's result is.
struct Settings : hls::StageSettings {
  int lookahead = 0;         // rows
  int forget = 0;            // the frame before taught what went blind, but had a fault or an alarm
  int same_table = 1;        // the frame before of this field had the same one
  int alarm_discounted = 0;  // the frame before showed an alarm that ALARM_FRAMES did not count

  /// ⌊p · 15·k² / 100⌋.
  static constexpr int sum_limit_for(int percent, int window) { return percent * 15 * window * window / 100; }
  static constexpr int texture_limit_for(int threshold) {
    return threshold * stages::texture_window * stages::texture_window;
  }

  /// The same, but a pixel is clear where the images do not agree.
  [[nodiscard]] Settings without_proof() const {
    Settings settings = *this;
    settings.prove = 0;
    settings.blind_share = 0;
    settings.still_limit = 0;
    settings.one_camera_segments = 0;
    return settings;
  }

  /// For incoming images of width × height.
  static constexpr Settings defaults(const hls::Profile& profile, int width, int height) {
    const int result = width / profile.subsample * height;
    Settings settings;
    settings.lookahead = profile.store_rows / 2;
    settings.sum_limit = sum_limit_for(hls::percent::sum_limit, profile.dsad_window);
    settings.self_limit = profile.dsad_window * profile.dsad_window;
    settings.alarm_limit = result * hls::percent::alarm_limit / 100;
    settings.undecidable_limit = result;
    settings.unsupervised_limit = result;
    settings.dark_limit = width * height / 100 * hls::percent::dark_limit;
    settings.bright_limit = width * height / 100 * hls::percent::bright_limit;
    return settings;
  }
};

/// The same with the size of the result in px: all that stages take (stages/chain.hpp).
struct FrameSettings : Settings {
  FrameSettings(const Settings& settings, int result_width, int result_height)
      : Settings(settings), width(result_width), height(result_height) {}
  int width;
  int height;
  int alarm_before = 0;  // the frame before showed an alarm, and that counted
};

struct Run {
  std::uint16_t row = 0;
  std::uint16_t start = 0;  // columns, inclusive
  std::uint16_t end = 0;
  std::uint8_t state = 0;
  friend bool operator==(const Run&, const Run&) = default;
};

/// What the frame showed of both cameras' world (stages/agreement.hpp).
struct Agreement {
  int supervised_cells = 0;
  int textured_cells = 0;
  int explained_cells = 0;
  int nearer_cells = 0;
  int unproven_cells = 0;
  int bad_region_cells = 0;
  bool unproven = false;
  bool untextured = false;
  bool disagree = false;
  bool moved = false;
  bool unsharp_left = false;
  bool unsharp_right = false;
  bool hidden = false;
  bool overlooked = false;  // a fault where there is no alarm
  bool out_of_step = false;
  std::array<int, 4> across{};
  std::array<int, 4> measured{};
  std::array<int, 2> detail{};
  std::array<int, 2> contrast{};
  int patch_places = 0;  // of the last complete round (stages/patches.hpp)
  int patch_across = 0;  // 1/8 px
  int patch_moved = 0;   // bits
  int patches_on_skin = 0;
  struct Region {
    int textured = 0;
    int explained = 0;
    int nearer = 0;
    friend bool operator==(const Region&, const Region&) = default;
  };
  std::array<Region, 48> regions{};
  friend bool operator==(const Agreement&, const Agreement&) = default;
};

/// Pixels that touch each other and are in the skin or blind (stages/objects.hpp).
struct Object {
  int pixels = 0;
  int blind = 0;           // of these
  std::uint32_t area = 0;  // that it covers of the skin, 1/1024 mm² (horopter/hls/area.hpp)
  int left = 0;            // box: columns and rows, inclusive
  int top = 0;
  int right = 0;
  int bottom = 0;
  std::int64_t columns = 0;  // sums over its pixels
  std::int64_t rows = 0;
  friend bool operator==(const Object&, const Object&) = default;
};

struct ImageHealth {
  bool black = false;
  bool white = false;
  bool constant = false;
  bool frozen = false;
  bool torn = false;
  bool blind = false;
  friend bool operator==(const ImageHealth&, const ImageHealth&) = default;

  [[nodiscard]] bool empty() const { return black || white || constant; }  ///< which says that it is blind
};

struct FrameResult {
  int width = 0;  // of the result, px
  int height = 0;
  std::vector<std::uint8_t> states;  // codes of horopter::stages::state, row by row
  std::vector<Run> runs;
  int skin_pixels = 0;
  int undecidable_pixels = 0;
  int unsupervised_pixels = 0;
  int hidden_pixels = 0;         // undecidable: something nearer than the skin is seen there
  int unproven_pixels = 0;       // undecidable: nothing shows that both cameras see their place
  int blind_pixels = 0;          // undecidable, where that could be decided when it was taught
  bool taught = false;           // at least one frame was
  std::vector<Object> objects;   // in the order in which they end
  bool object_overflow = false;  // more than can be told apart: some of them are wrong
  bool alarm = false;
  bool too_undecidable = false;
  bool too_unsupervised = false;
  std::int64_t store_misses = 0;  // pixels whose source row the ring does not hold
  ImageHealth left;
  ImageHealth right;
  bool identical_images = false;  // the same signature
  Agreement agreement;
  bool one_camera = false;  // the same but for noise, compression or gain
  friend bool operator==(const FrameResult&, const FrameResult&) = default;

  /// The first that ended of those with the most pixels; none without pixels.
  [[nodiscard]] Object largest_object() const {
    const auto smaller = [](const Object& a, const Object& b) { return a.pixels < b.pixels; };
    const auto largest = std::max_element(objects.begin(), objects.end(), smaller);
    return largest == objects.end() ? Object{} : *largest;
  }
};

/// P may lack its store (Profile::of_stages), which is then said.
template <hls::Profile P>
class Pipeline {
 public:
  /// `threads`: that share a frame. The results are the same for any number of them. `store_rows`: of the right image's ring.
  explicit Pipeline(int threads = 1, int store_rows = P.store_rows)
      : store_rows_(store_rows),
        workers_(threads),
        slots_(threads > 1 ? 4 * rows_at_once : 1),
        pairs_(slots_),
        marks_(slots_),
        states_(slots_),
        thesis_between_(slots_),
        compete_between_(slots_) {}

  /// One frame. `table`: for the size of the images. Throws std::invalid_argument for sizes the profile cannot take.
  FrameResult process(const ImageView& left, const ImageView& right, const TableView& table, const Settings& settings) {
    check(left, right, table, settings);
    begin(left, table, settings);
    FrameResult result;
    result.width = left.width / P.subsample;
    result.height = left.height;
    result.states.resize(static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height));
    if (!keep_expansion(table, settings.lookahead)) ++frames_that_expanded_;
    const Expansion& sources = expansions_.front();
    result.store_misses = sources.misses;
    store(right);
    pass_rows(left.height + P.flush_rows(compete_), {left, right, sources, result});
    alarm_before_ = result.alarm ? 1 : 0;
    return result;
  }

  /// See Engine (engine.hpp).
  void prepare(const TableView& table, int lookahead) {
    if (table.width() > P.width || table.height() > P.height) {
      throw std::invalid_argument("the table is for images larger than the profile");
    }
    keep_expansion(table, lookahead);
  }
  [[nodiscard]] int frames_that_expanded() const { return frames_that_expanded_; }
  [[nodiscard]] int threads() const { return workers_.count(); }

 private:
  static constexpr std::size_t padded_stride = P.width + 1;

  struct Nothing {
    using Between = char;
  };
  template <class Stage>
  using InOf = typename Stage::In;
  template <class Stage>
  using OutOf = typename Stage::Out;

  template <class T>
  using Row = std::array<T, P.width>;
  struct Taps {
    Row<hls::u<8>> p00, p01, p10, p11, left;
    Row<hls::u<P.weight_bits>> wx, wy;
    Row<bool> mask, present;
  };

  using Pairs = PairRow<P>;
  using Thesis = std::conditional_t<P.has_thesis(), Strips<P, hls::Rule::thesis>, Nothing>;
  using Compete = std::conditional_t<P.has_compete(), Strips<P, hls::Rule::compete>, Nothing>;
  struct FullPairs {
    Row<hls::u<8>> left, right;
    Row<bool> saturated, mask, present;
  };
  void check(const ImageView& left, const ImageView& right, const TableView& table, const Settings& settings) const {
    const auto fail = [](const std::string& what) { throw std::invalid_argument(what); };
    if (left.width != right.width || left.height != right.height) fail("left and right image differ in size");
    if (left.width > P.width || left.height > P.height) fail("the image is larger than the profile");
    constexpr int smallest_width = hls::table::smallest_result_width * P.subsample;
    static_assert(hls::table::smallest_result_width >= 2 * hls::min_row_beats);
    if (left.width % P.subsample != 0 || left.width < smallest_width) {
      fail("the width must be a multiple of the sub-sampling and at least " + std::to_string(smallest_width));
    }
    if (left.height < hls::table::smallest_height) {
      fail("the height must be at least " + std::to_string(hls::table::smallest_height));
    }
    if (table.width() != left.width || table.height() != left.height) fail("the table is for another image size");
    if (!P.has(settings.compete != 0 ? hls::Rule::compete : hls::Rule::thesis))
      fail("the profile does not have this rule");
    if (settings.lookahead < 0 || settings.lookahead > store_rows_ / 2) fail("LOOKAHEAD is more than half the ring");
  }

  void begin(const ImageView& image, const TableView& table, const Settings& settings) {
    compete_ = settings.compete != 0;
    FrameSettings of_stages(settings, image.width / P.subsample, image.height);
    of_stages.alarm_before = settings.alarm_discounted != 0 ? 0 : alarm_before_;
    if constexpr (P.has_thesis()) thesis_rows_.begin(of_stages);
    if constexpr (P.has_compete()) compete_rows_.begin(of_stages);
    blind_config_ = stages::chain::by_name<typename stages::Blind<P>::Config>(of_stages);
    objects_config_ = stages::chain::by_name<typename stages::Objects<P>::Config>(of_stages);
    health_config_ = stages::chain::by_name<typename Health::Config>(of_stages);
    if (settings.prove != prove_ || image.width != width_ || image.height != height_) hls::reset(agreement_);
    agreement_config_ = stages::chain::by_name<typename stages::Agreement<P>::Config>(of_stages);
    prove_ = settings.prove;
    height_ = image.height;
    still_config_ = stages::chain::by_name<typename Still::Config>(of_stages);
    coarse_config_ = stages::chain::by_name<typename Coarse::Config>(of_stages);
    width_ = image.width;
    for (Pairs& pairs : pairs_) {
      pairs.mask.fill(false);
      pairs.present.fill(false);
    }
    alarm_config_ = stages::chain::by_name<typename stages::Alarm<P>::Config>(of_stages);
    skin_ = undecidable_ = unsupervised_ = 0;
    rows_finished_ = 0;
    area_columns_ = blocks_of(of_stages.width);
    area_codes_.assign(table.areas().begin(), table.areas().end());
    area_codes_.resize(area_columns_ * blocks_of(of_stages.height), std::uint8_t{hls::table::unknown_area});
    areas_of_ = -1;
    row_of_blind_ = column_of_blind_ = 0;
  }

  static constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }

  static constexpr std::size_t blocks_of(int size) { return index(hls::table::Facts::blocks(size)); }
  [[nodiscard]] std::uint8_t area_code(int x, int y) const {
    return area_codes_[index(y >> hls::table::area_block_log2) * area_columns_ +
                       index(x >> hls::table::area_block_log2)];
  }

  using Health = stages::Health<P>;
  using Coarse = stages::Coarse<P>;
  using Still = stages::Still<P>;

  void examine(const ImageView& left, const ImageView& right, FrameResult& result) {
    const OutOf<Health> of_left = examine(left_health_, left);
    const OutOf<Health> of_right = examine(right_health_, right);
    result.left = {of_left.black, of_left.white, of_left.constant, of_left.frozen, of_left.torn, false};
    result.right = {of_right.black, of_right.white, of_right.constant, of_right.frozen, of_right.torn, false};
    result.identical_images = of_left.signature == of_right.signature;
  }
  [[gnu::flatten]] OutOf<Health> examine(Health& of_camera, const ImageView& image) {
    Borrowed health(of_camera);
    OutOf<Health> out;
    const int last = width_ - 1;
    for (int y = 0; y < image.height; ++y) {
      const std::uint8_t* row = image.pixels + y * image.stride;
      for (int x = 0; x < Health::pixels_before; ++x)
        health->step({row[x], y == 0 && x == 0, false, false}, health_config_);
      health->pass({row + Health::pixels_before, row + last}, health_config_);
      out = health->step({row[last], false, y == image.height - 1, true}, health_config_);
    }
    return out;
  }

  /// The checks of both images on their cells. Their sums are formed here, for speed: those of the stage `cells`.
  [[gnu::flatten]] void compare(const ImageView& left, const ImageView& right, FrameResult& result) {
    constexpr int cell = P.cell();
    using Sums = std::array<std::uint32_t, P.width / cell>;
    const int columns = left.width / cell;
    Borrowed coarse(coarse_);
    Borrowed still(still_);
    OutOf<Coarse> verdict;
    OutOf<Still> repeats;
    for (int row = 0; row < left.height / cell; ++row) {
      const auto sum = [&](const ImageView& image) {
        Sums sums{};
        for (int y = row * cell; y < (row + 1) * cell; ++y) {
          const std::uint8_t* pixels = image.pixels + y * image.stride;
          for (int c = 0; c < columns; ++c) {
            for (int x = 0; x < cell; ++x) sums[index(c)] += pixels[c * cell + x];
          }
        }
        return sums;
      };
      const Sums of_left = sum(left);
      const Sums of_right = sum(right);
      for (int c = 0; c < columns; ++c) {
        constexpr std::uint32_t pixels = cell * cell;
        const auto l = static_cast<int>(of_left[index(c)] / pixels);
        const auto r = static_cast<int>(of_right[index(c)] / pixels);
        const bool first = row == 0 && c == 0;
        verdict = coarse->step({l, r, first, c == 0}, coarse_config_);
        repeats = still->step({l, r, first}, still_config_);
      }
    }
    result.one_camera = verdict.one_camera && !result.identical_images;  // that says it already
    result.left.blind = verdict.left_blind && !result.left.empty();
    result.right.blind = verdict.right_blind && !result.right.empty();
    result.left.frozen |= repeats.left_still;
    result.right.frozen |= repeats.right_still;
  }

  /// What map_expand and the image store's addressing make of a table: the same for every frame.
  struct Expansion {
    std::vector<std::uint32_t> words;
    int lookahead = 0;
    std::int64_t misses = 0;
    // Per pixel, row by row:
    std::vector<std::uint32_t> offset;  // of the top left source pixel in padded_
    std::vector<hls::u<P.weight_bits>> wx, wy;
    std::vector<char> mask, present;
  };

  /// As many tables as the hardware has slots are kept, the most recent first. Whether this one was.
  bool keep_expansion(const TableView& table, int lookahead) {
    const auto known = std::find_if(expansions_.begin(), expansions_.end(), [&](const Expansion& e) {
      return e.lookahead == lookahead && e.words.size() == table.words().size() &&
             e.words.back() == table.words().back() &&
             std::equal(e.words.begin(), e.words.end(), table.words().begin());
    });
    if (known != expansions_.end()) {
      std::rotate(expansions_.begin(), known, known + 1);
      return true;
    }
    if (expansions_.size() == hls::table::slots) expansions_.pop_back();
    expansions_.insert(expansions_.begin(), expand(table, lookahead));
    return false;
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
    result.present.reserve(pixels);
    const int cell_mask = (1 << table.spacing_x_log2()) - 1;
    map_config_.spacing_x_log2 = table.spacing_x_log2();
    for (int y = 0; y < table.height(); ++y) {
      const int cell_row = y >> table.spacing_y_log2();
      InOf<stages::MapExpand<P>> in;
      in.row_fraction = (y - (cell_row << table.spacing_y_log2())) << (6 - table.spacing_y_log2());
      const auto fetch = [&](int column) {
        return stages::ControlPair{table.control(column, cell_row), table.control(column, cell_row + 1)};
      };
      const hls::table::Span span = table.span(y);
      in.prime = true;
      in.column = fetch(0);
      map_expand_.step(in, map_config_);
      in.prime = false;
      for (int x = 0; x < table.width(); ++x) {
        in.load = (x & cell_mask) == 0;
        if (in.load) in.column = fetch((x >> table.spacing_x_log2()) + 1);
        in.outside = !span.holds(x);
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
    const bool exists = source.present && last_x < table.width() && last_row < table.height();
    const bool in_ring = row >= y - (store_rows_ / 2 - 2) && last_row <= y + result.lookahead;
    if (exists && source.mapped && !in_ring) ++result.misses;
    const bool present = exists && in_ring;
    result.offset.push_back(present ? static_cast<std::uint32_t>(index(row) * padded_stride + index(x)) : 0);
    result.wx.push_back(source.wx);
    result.wy.push_back(source.wy);
    result.mask.push_back(present && source.mapped);
    result.present.push_back(present);
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
    std::copy_n(sources.present.data() + begin, n, taps.present.begin());
    const std::uint8_t* waiting = left.pixels + y * left.stride;
    if constexpr (P.subsample == 1) {
      std::copy_n(waiting, n, taps.left.begin());
    } else {  // the left store keeps the mean of a pair only
      for (std::size_t i = 0; i + 1 < n; i += 2) {
        taps.left[i] = taps.left[i + 1] = static_cast<std::uint8_t>((waiting[i] + waiting[i + 1] + 1) / 2);
      }
    }
  }

  // What can be done beside each other: each part takes the rows in order, one thread at a time.
  enum Part : std::size_t { first_half, second_half, agree, finish, look_at_images, parts };
  /// Rows of which a part does not tell each one: those who sleep are woken for something.
  static constexpr std::size_t rows_at_once = 8;

  /// Rows that a part has done, and whether somebody is at it.
  struct alignas(64) Progress {
    std::atomic<int> done = 0;
    std::atomic<bool> taken = false;
  };

  struct Frame {
    const ImageView& left;
    const ImageView& right;
    const Expansion& sources;
    FrameResult& result;
  };

  void do_row(Part part, int y, const Frame& frame) {
    const std::size_t slot = index(y) % slots_;
    switch (part) {
      case first_half:
        if (y < frame.left.height) {
          fetch_row(y, frame.left, frame.sources);
        } else if (y == frame.left.height) {
          taps_.mask.fill(false);
          taps_.present.fill(false);
        }
        make_pairs(y == 0, pairs_[slot]);
        with_rule([&](auto& strips, auto& between) { strips.pass_first(pairs_[slot], y == 0, between[slot]); });
        break;
      case second_half:
        with_rule([&](auto& strips, auto& between) { strips.pass_second(between[slot], y == 0, states_[slot]); });
        break;
      case agree:
        agree_row(y == 0, pairs_[slot], marks_[slot], frame.result);
        break;
      case finish:
        finish_row(y, states_[slot], marks_[slot], frame.result);
        break;
      default:
        examine(frame.left, frame.right, frame.result);
        compare(frame.left, frame.right, frame.result);
    }
  }

  /// What a row needs is there, and where its result goes is free.
  [[nodiscard]] bool can_do(Part part, int y) const {
    const auto done = [&](Part other) { return progress_[other].done.load(std::memory_order_acquire); };
    const int slots = static_cast<int>(slots_);
    switch (part) {
      case first_half:
        return y < slots + done(second_half) && y < slots + done(agree);
      case second_half:
      case agree:
        return y < done(first_half) && y < slots + done(finish);
      case finish:
        return y < done(second_half) && y < done(agree);
      default:
        return true;
    }
  }

  void pass_rows(int rows, const Frame& frame) {
    if (workers_.count() == 1) {
      do_row(look_at_images, 0, frame);
      for (int y = 0; y < rows; ++y) {
        for (const Part part : {first_half, second_half, agree, finish}) do_row(part, y, frame);
      }
      return;
    }
    for (Progress& progress : progress_) progress.done = 0;
    std::exception_ptr failure;
    std::atomic<bool> failed = false;
    /// Changes when there may be something to do again.
    std::atomic<int> news = 0;
    const auto tell = [&] {
      news.fetch_add(1, std::memory_order_release);
      news.notify_all();
    };
    const auto rows_of = [&](Part part) { return part == look_at_images ? 1 : rows; };
    /// As many rows as can be done now: what a part keeps stays in one processor's cache.
    const auto take = [&](Part part) {
      Progress& progress = progress_[part];
      int y = progress.done.load(std::memory_order_relaxed);
      if (y == rows_of(part) || !can_do(part, y) || progress.taken.exchange(true, std::memory_order_acquire))
        return false;
      y = progress.done.load(std::memory_order_relaxed);
      for (; y < rows_of(part) && !failed && can_do(part, y); ++y) {
        do_row(part, y, frame);
        progress.done.store(y + 1, std::memory_order_release);
        if (index(y + 1) % rows_at_once == 0) tell();
      }
      progress.taken.store(false, std::memory_order_release);
      tell();
      return true;
    };
    const auto finished = [&] {
      for (const Part part : {finish, look_at_images}) {
        if (progress_[part].done.load(std::memory_order_acquire) != rows_of(part)) return false;
      }
      return true;
    };
    workers_.run([&](int worker) {
      // Where each begins to look for work.
      static constexpr std::array<std::array<Part, parts>, 3> order{{
          {first_half, finish, second_half, look_at_images, agree},
          {agree, second_half, finish, look_at_images, first_half},
          {second_half, finish, look_at_images, agree, first_half},
      }};
      const auto& mine = order[index(worker) % order.size()];
      try {
        for (;;) {
          const int known = news.load(std::memory_order_acquire);
          if (failed || finished()) return;
          if (std::none_of(mine.begin(), mine.end(), take)) news.wait(known, std::memory_order_acquire);
        }
      } catch (...) {
        if (!failed.exchange(true)) failure = std::current_exception();
        tell();
      }
    });
    for (Progress& progress : progress_) progress.taken = false;
    if (failure) std::rethrow_exception(failure);
  }

  template <class Do>
  void with_rule(const Do& act) {
    if constexpr (P.has_compete()) {
      if (compete_) return act(compete_rows_, compete_between_);
    }
    if constexpr (P.has_thesis()) act(thesis_rows_, thesis_between_);
  }

  void make_pairs(bool first_row, Pairs& pairs) {
    if constexpr (P.subsample == 1) {
      interpolate_row(pairs, Pairs::before);
    } else {
      interpolate_row(full_pairs_, 0);
      subsample_row(first_row, pairs);
    }
  }

  /// What align, alarm and runs make of a row of beats. The raster of the result is that of the beats, shifted as a whole.
  void finish_row(int row, const StatesRow<P>& states, const MarksRow<P>& marks, FrameResult& result) {
    const stages::ResultOffset offset = compete_ ? stages::compete_offset<P> : stages::thesis_offset<P>;
    const std::ptrdiff_t width = result.width;
    const std::ptrdiff_t from = (row - offset.rows) * width - offset.columns;  // pixel of the row's first beat
    const std::ptrdiff_t begin = std::clamp<std::ptrdiff_t>(-from, 0, width);
    const std::ptrdiff_t end = std::clamp<std::ptrdiff_t>(width * result.height - from, 0, width);
    if (begin >= end) return;
    place(begin, end, states, marks, result.states.data() + from, result);
    const auto rows = static_cast<int>((from + end) / width);  // that are complete
    for (int y = rows_finished_; y < rows; ++y) find_runs(y, result);
    find_objects(result, rows_finished_, rows);
    rows_finished_ = rows;
    if (rows == result.height) set_counts(result);
  }

  void place(std::ptrdiff_t begin, std::ptrdiff_t end, const StatesRow<P>& states, const MarksRow<P>& marks,
             std::uint8_t* to, FrameResult& result) {
    std::uint32_t skin = 0, undecidable = 0, unsupervised = 0, hidden = 0, unproven = 0;
    for (std::ptrdiff_t x = begin; x < end; ++x) {
      const std::uint8_t state = states[static_cast<std::size_t>(x)];
      const bool clear = state == stages::state::clear;
      const bool is_hidden = clear & marks.nearer[static_cast<std::size_t>(x)];
      const bool is_unproven = clear & !marks.seen[static_cast<std::size_t>(x)];
      to[x] = (is_hidden | is_unproven) ? std::uint8_t{stages::state::undecidable} : state;
      skin += state == stages::state::skin;
      undecidable += state == stages::state::undecidable;
      unsupervised += state == stages::state::unsupervised;
      hidden += is_hidden;
      unproven += is_unproven;
    }
    skin_ += skin;
    undecidable_ += undecidable;
    unsupervised_ += unsupervised;
    result.hidden_pixels += static_cast<int>(hidden);
    result.unproven_pixels += static_cast<int>(unproven);
  }

  static void find_runs(int y, FrameResult& result) {
    const std::uint8_t* states = result.states.data() + index(y) * index(result.width);
    for (int start = 0; start < result.width;) {
      int end = start + 1;
      while (end < result.width && states[end] == states[start]) ++end;
      result.runs.push_back({static_cast<std::uint16_t>(y), static_cast<std::uint16_t>(start),
                             static_cast<std::uint16_t>(end - 1), states[start]});
      start = end;
    }
  }

  void set_counts(FrameResult& result) const {
    result.skin_pixels = static_cast<int>(skin_);
    result.undecidable_pixels = static_cast<int>(undecidable_) + result.hidden_pixels + result.unproven_pixels;
    result.unsupervised_pixels = static_cast<int>(unsupervised_);
    result.alarm |= skin_ > alarm_config_.alarm_limit.value();
    // The second limit is rtl/top/horopter_agreement_result.sv's.
    const auto limit = static_cast<int>(alarm_config_.undecidable_limit.value());
    const bool too_little_decided = result.undecidable_pixels > limit + limit / 8 + limit / 16;
    result.too_undecidable = static_cast<int>(undecidable_) > limit || too_little_decided;
    result.too_unsupervised = unsupervised_ > alarm_config_.unsupervised_limit.value();
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
    bool* __restrict present = to.present.data() + begin;
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
      in.present = from.present[i];
      const stages::GreyPair out = stage.step(in);
      left[i] = out.pixel[0];
      right[i] = out.pixel[1];
      saturated[i] = out.saturated;
      mask[i] = out.mask;
      present[i] = out.present;
    }
  }

  [[gnu::flatten]] void subsample_row(bool first_row, Pairs& to) {
    Borrowed stage(subsample_);
    std::size_t written = Pairs::before;
    for (std::size_t i = 0; i < index(width_); ++i) {
      stages::GreyPair in;
      in.pixel = {full_pairs_.left[i], full_pairs_.right[i]};
      in.saturated = full_pairs_.saturated[i];
      in.mask = full_pairs_.mask[i];
      in.present = full_pairs_.present[i];
      in.marks = {i == 0 && first_row, i + 1 == index(width_)};
      const auto out = stage->step(in);
      if (out.valid) {
        to.left[written] = out.pixel[0];
        to.right[written] = out.pixel[1];
        to.saturated[written] = out.saturated;
        to.mask[written] = out.mask;
        to.present[written] = out.present;
        ++written;
      }
    }
  }

  /// Where nothing has to be proved, the stage says so of every pixel; the hardware's does no more.
  void agree_row(bool first_row, const Pairs& pairs, MarksRow<P>& marks, FrameResult& result) {
    if (prove_ == 0) {
      marks.seen.fill(true);
      marks.nearer.fill(false);
      return;
    }
    if (first_row) result.agreement.unproven = true;  // until the verdict comes
    const std::size_t n = index(width_) / P.subsample;
    for (std::size_t x = 0; x < n;) {
      const std::size_t at = Pairs::before + x;
      const int passed = agreement_.pass_beats(
          {&pairs.left[at], &pairs.right[at], &pairs.mask[at], &pairs.present[at], &marks.seen[x], &marks.nearer[x]},
          static_cast<int>(n - x) - 1, agreement_config_);
      if (passed > 0) {
        x += index(passed);
        continue;
      }
      InOf<stages::Agreement<P>> in;
      in.saturated = pairs.saturated[Pairs::before + x];
      in.mask = pairs.mask[Pairs::before + x];
      in.present = pairs.present[Pairs::before + x];
      const bool first = x == 0 && first_row;
      const bool last = x + 1 == n;
      const hls::u<8> left = pairs.left[Pairs::before + x];
      const hls::u<8> right = pairs.right[Pairs::before + x];
      if constexpr (P.packed()) {
        in.pixel = {left};
        in.marks = {first, false};
        take_verdict(agreement_.step(in, agreement_config_), result);
        in.pixel = {right};
        in.marks = {false, last};
      } else {
        in.pixel = {left, right};
        in.marks = {first, last};
      }
      const auto out = agreement_.step(in, agreement_config_);
      marks.seen[x] = out.marks.seen;
      marks.nearer[x] = out.marks.nearer;
      take_verdict(out, result);
      ++x;
    }
  }

  /// In the rows begin … end − 1 of the result.
  void find_objects(FrameResult& result, int begin, int end) {
    Borrowed stage(objects_);
    OutOf<stages::Objects<P>> out;
    const auto step = [&](const InOf<stages::Objects<P>>& in) {
      out = stage->step(in, objects_config_);
      if (out.ended) [[unlikely]] {
        add_object(out.object, result);
      }
    };
    if (blind_config_.watch || blind_config_.teach) {
      look_for_blind(result, begin, end, step);
    } else {
      if (begin == 0) result.taught = blind_.leave_out(blind_config_);
      for (int y = begin; y < end; ++y) {
        if (areas_of_ != y >> hls::table::area_block_log2) add_up_areas(result.width, y);
        find_objects_of_row(result, y, *stage, step);
      }
    }
    if (end < result.height) return;
    do {
      step({false, false, false, true, 0, false});
    } while (!out.done);
    result.object_overflow = out.overflow;
    result.alarm |= out.alarm;
  }
  /// Of the pixels of a row before each.
  void add_up_areas(int width, int y) {
    constexpr int block = 1 << hls::table::area_block_log2;
    areas_of_ = y >> hls::table::area_block_log2;
    std::uint32_t sum = 0;
    areas_before_[0] = 0;
    for (int x = 0; x < width;) {
      const std::uint32_t area = hls::area_of(area_code(x, y)).value();
      for (const int end = std::min(x + block, width); x < end;) areas_before_[index(++x)] = sum += area;
    }
  }
  /// Most beats change nothing: those with a pixel that is as the one before it, both in their row and above.
  template <class Step>
  void find_objects_of_row(const FrameResult& result, int y, stages::Objects<P>& stage, const Step& step) {
    const std::size_t width = index(result.width);
    const std::uint8_t* state = result.states.data() + index(y) * width;
    const std::uint8_t* above = y == 0 ? state : state - width;
    std::array<std::uint8_t, P.result_width()> alike{};  // equal where both are
    const auto occupied = [](std::uint8_t code) { return code == stages::state::skin; };
    for (std::size_t x = 0; x < width; ++x) {
      alike[x] = static_cast<std::uint8_t>((occupied(state[x]) ? 1 : 0) | (occupied(above[x]) ? 2 : 0));
    }
    step({occupied(state[0]), y == 0, width == 1, false, area_code(0, y), false});
    for (std::size_t x = 1; x < width;) {
      std::size_t other = x;
      if (alike[x] == alike[x - 1] && stage.rests()) {
        while (other + 1 < width && alike[other] == alike[x]) ++other;
      }
      if (other > x) {
        stage.skip(static_cast<int>(other - x), areas_before_[other] - areas_before_[x]);
        x = other;
      } else {
        step({occupied(state[x]), false, x + 1 == width, false, area_code(static_cast<int>(x), y), false});
        ++x;
      }
    }
  }

  /// Pixels leave `blind` some rows after they came; after the last row they are fetched.
  template <class Step>
  void look_for_blind(FrameResult& result, int begin, int end, const Step& step) {
    const auto pass = [&](const InOf<stages::Blind<P>>& in) {
      const auto out = blind_.step(in, blind_config_);
      result.taught = out.taught;
      if (out.there) {
        result.blind_pixels += out.blind ? 1 : 0;
        const std::uint8_t area = area_code(column_of_blind_, row_of_blind_);
        step({out.blind || out.state == stages::state::skin, out.first, out.last, false, area, out.blind});
        column_of_blind_ = out.last ? 0 : column_of_blind_ + 1;
        row_of_blind_ += out.last ? 1 : 0;
      }
      return out.done;
    };
    const std::uint8_t* state = result.states.data() + index(begin) * index(result.width);
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < result.width; ++x) pass({*state++, x == 0 && y == 0, x + 1 == result.width, false});
    }
    if (end < result.height) return;
    while (!pass({0, false, false, true})) {
    }
  }

  template <class From>
  [[gnu::noinline]] static void add_object(const From& from, FrameResult& result) {
    result.objects.push_back({static_cast<int>(from.pixels.value()), static_cast<int>(from.blind.value()),
                              from.area.value(), from.left.value(), from.top.value(), from.right.value(),
                              from.bottom.value(), static_cast<std::int64_t>(from.columns.value()),
                              static_cast<std::int64_t>(from.rows.value())});
  }

  static void take_verdict(const OutOf<stages::Agreement<P>>& out, FrameResult& result) {
    Agreement& to = result.agreement;
    if (out.frame.valid) [[unlikely]] {
      take_word(out.frame.index.value(), out.frame.word.value(), to);
    }
    if (!out.verdict.valid) [[likely]] {
      return;
    }
    const stages::Verdict& from = out.verdict;
    to.unproven = from.unproven_yet;
    to.untextured = from.untextured;
    to.disagree = from.disagree;
    to.moved = from.moved;
    to.unsharp_left = from.unsharp_left;
    to.unsharp_right = from.unsharp_right;
    to.hidden = from.hidden;
    to.overlooked = from.overlooked;
    to.out_of_step = from.out_of_step;
  }

  /// See stages::FrameWord.
  static void take_word(std::size_t place, std::uint32_t word, Agreement& to) {
    const auto bits = [&](int lowest, int count) { return static_cast<int>(word >> lowest & ((1U << count) - 1)); };
    if (place < to.regions.size()) {
      to.regions[place] = {bits(0, 10), bits(10, 10), bits(20, 10)};
      return;
    }
    switch (place - stages::FrameWord::first_of_frame) {
      case 0:
        to.textured_cells = bits(0, 16);
        to.explained_cells = bits(16, 16);
        break;
      case 1:
        to.supervised_cells = bits(0, 16);
        to.nearer_cells = bits(16, 16);
        break;
      case 2:
        to.unproven_cells = bits(0, 16);
        to.bad_region_cells = bits(16, 16);
        break;
      case 3:
      case 4:
      case 5:
      case 6:
        to.across[place - stages::FrameWord::first_of_frame - 3] = hls::s<20>(word).value();
        to.measured[place - stages::FrameWord::first_of_frame - 3] = bits(20, 12);
        break;
      case 7:
      case 8:
        to.detail[place - stages::FrameWord::first_of_frame - 7] = bits(0, 24);
        break;
      case 9:
      case 10:
        to.contrast[place - stages::FrameWord::first_of_frame - 9] = bits(0, 24);
        break;
      default:
        to.patch_places = bits(0, 8);
        to.patch_across = hls::s<12>(word >> 8).value();
        to.patch_moved = bits(20, 3);
        to.patches_on_skin = bits(23, 8);
        break;
    }
  }

  stages::MapExpand<P> map_expand_;
  stages::Subsampler<P.subsample> subsample_;
  stages::Agreement<P> agreement_;
  Health left_health_;
  Health right_health_;
  Coarse coarse_;
  Still still_;
  stages::Blind<P> blind_;
  stages::Objects<P> objects_;

  typename stages::MapExpand<P>::Config map_config_;
  typename Health::Config health_config_;
  typename stages::Agreement<P>::Config agreement_config_;
  int alarm_before_ = 0;
  int prove_ = 0;
  typename Coarse::Config coarse_config_;
  typename Still::Config still_config_;
  typename stages::Blind<P>::Config blind_config_;
  typename stages::Objects<P>::Config objects_config_;

  Thesis thesis_rows_;
  Compete compete_rows_;
  bool compete_ = false;

  int width_ = 0;  // of the images
  int height_ = 0;
  std::vector<Expansion> expansions_;
  int frames_that_expanded_ = 0;
  std::vector<std::uint8_t> padded_;
  Taps taps_{};
  FullPairs full_pairs_{};  // before `subsample`

  typename stages::Alarm<P>::Config alarm_config_;
  std::uint32_t skin_ = 0, undecidable_ = 0, unsupervised_ = 0;
  int rows_finished_ = 0;

  std::vector<std::uint8_t> area_codes_;  // of the frame's table, row by row of blocks
  std::size_t area_columns_ = 0;
  std::array<std::uint32_t, P.result_width() + 1> areas_before_{};  // 1/1024 mm², of a row of blocks:
  int areas_of_ = -1;                                               // this one of the frame
  int row_of_blind_ = 0, column_of_blind_ = 0;                      // of the pixel that leaves the stage `blind`

  int store_rows_;
  Workers workers_;
  std::array<Progress, parts> progress_;
  /// Rows on their way from part to part.
  std::size_t slots_ = 1;
  std::vector<Pairs> pairs_;
  std::vector<MarksRow<P>> marks_;
  std::vector<StatesRow<P>> states_;
  std::vector<typename Thesis::Between> thesis_between_;
  std::vector<typename Compete::Between> compete_between_;
};

}  // namespace horopter::native
