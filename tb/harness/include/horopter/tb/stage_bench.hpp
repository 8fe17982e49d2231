// SPDX-License-Identifier: Apache-2.0
// A native stage class against its emitted module: the same beats into both, every output compared in every bit and in
// its clock, with gaps (valid_i low), stalls (en_i low), changes of the configuration and resets in mid-stream.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <exception>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "horopter/hls/ram.hpp"
#include "horopter/tb/dut.hpp"
#include "horopter/tb/leaves.hpp"
#include "horopter/tb/random.hpp"
#include "horopter/verilated/stop.hpp"

namespace horopter::tb {

namespace detail {

struct NoConfig {};

template <class Stage>
struct ConfigOf {
  using type = NoConfig;
};
template <class Stage>
  requires requires { typename Stage::Config; }
struct ConfigOf<Stage> {
  using type = typename Stage::Config;
};

}  // namespace detail

template <class Stage>
using InOf = typename Stage::In;
template <class Stage>
using OutOf = typename Stage::Out;
template <class Stage>
using ConfigOf = typename detail::ConfigOf<Stage>::type;

/// Random values for leaves, in episodes: uniform, near the ends of the range, small, slowly rising, or held; single
/// bits with a probability that changes from episode to episode.
class RandomLeaves {
 public:
  explicit RandomLeaves(Rng rng) : rng_{rng} {}

  template <class T>
  T value() {
    T result{};
    std::size_t index = 0;
    for_each_leaf(result, [&](auto& leaf) {
      using Leaf = std::remove_cvref_t<decltype(leaf)>;
      if (index >= episodes_.size()) episodes_.resize(index + 1);
      leaf = leaf_from_bits<Leaf>(next(episodes_[index++], leaf_width<Leaf>));
    });
    return result;
  }

 private:
  enum class Kind { uniform, ends, small, ramp, held };
  struct Episode {
    Kind kind = Kind::uniform;
    unsigned remaining = 0;
    unsigned ones_in_256 = 128;
    std::uint64_t last = 0;
  };
  std::uint64_t next(Episode& episode, unsigned width) {
    if (episode.remaining == 0) {
      static constexpr unsigned kOnes[] = {0, 1, 16, 128, 128, 240, 255, 256};
      episode.kind = static_cast<Kind>(rng_.chance(2) ? 0 : rng_.below(5));
      episode.ones_in_256 = kOnes[rng_.below(8)];
      episode.remaining = static_cast<unsigned>(1 + rng_.below(width == 1 ? 2'000 : 200));
    }
    --episode.remaining;
    if (width == 1) return rng_.below(256) < episode.ones_in_256;
    const std::uint64_t mask = ~std::uint64_t{0} >> (64 - width);
    switch (episode.kind) {
      case Kind::uniform:
        episode.last = rng_.next();
        break;
      case Kind::ends: {
        // 0, all ones and the sign change, or one beside them.
        const std::uint64_t end[] = {0, mask, std::uint64_t{1} << (width - 1)};
        episode.last = end[rng_.below(3)] + static_cast<std::uint64_t>(rng_.between(-1, 1));
        break;
      }
      case Kind::small:
        episode.last = rng_.below(4);
        break;
      case Kind::ramp:
        episode.last += 1;
        break;
      case Kind::held:
        break;
    }
    return episode.last &= mask;
  }
  Rng rng_;
  std::vector<Episode> episodes_;
};

/// What a stage is fed with. Specialised for stages whose inputs must keep rules (frames, rows).
template <class Stage>
class Stimulus {
 public:
  explicit Stimulus(Rng rng) : in_{Rng{rng.next()}}, config_{Rng{rng.next()}} {}
  /// After a reset.
  void restart() {}
  InOf<Stage> next() { return in_.template value<InOf<Stage>>(); }
  ConfigOf<Stage> config() { return config_.template value<ConfigOf<Stage>>(); }

 private:
  RandomLeaves in_, config_;
};

struct BenchOptions {
  std::uint64_t beats = 100'000;
  unsigned reset_one_in = 20'000;  ///< clocks; 0: none but the first
  unsigned config_one_in = 5'000;  ///< clocks
  bool reset_in_flight = true;     ///< also while beats are in the pipeline
};

struct BenchReport {
  std::uint64_t beats = 0, outputs = 0, clocks = 0, stalls = 0, gaps = 0, resets = 0, resets_in_flight = 0;
  std::string failure;  ///< empty: bit-exact
};

template <class Stage, class Feed = Stimulus<Stage>>
class StageBench {
  using In = InOf<Stage>;
  using Out = OutOf<Stage>;
  using Config = ConfigOf<Stage>;

 public:
  StageBench(DutModel& model, Dut& dut, std::uint64_t seed, Feed feed)
      : model_{model}, dut_{dut}, rng_{seed}, feed_{std::move(feed)} {}
  StageBench(DutModel& model, Dut& dut, std::uint64_t seed) : StageBench{model, dut, seed, Feed{Rng{~seed}}} {}

  BenchReport run(const BenchOptions& options) {
    try {
      check_ports();
      run_checked(options);
    } catch (const Mismatch& mismatch) {
      report_.failure = dut_.name + ": " + mismatch.text;
    } catch (const verilated::Stopped& stopped) {
      report_.failure = dut_.name + ": " + stopped.what() + where();
    } catch (const hls::hazard_error& hazard) {
      report_.failure = dut_.name + ": native class refused the stimulus: " + hazard.what() + where();
    }
    return report_;
  }

 private:
  struct Mismatch {
    std::string text;
  };
  struct Expected {
    std::uint64_t due;  ///< count of enabled clocks after which it is on the output
    std::uint64_t beat;
    std::vector<std::uint32_t> words;
  };
  struct Flying {
    std::uint64_t taken;  ///< count of enabled clocks before the one that took it
    In in;
  };

  void run_checked(const BenchOptions& options) {
    set_config();
    reset();
    unsigned gap_percent = 0, stall_percent = 0;
    while (report_.beats < options.beats) {
      if (rng_.chance(1'000)) {
        static constexpr unsigned kPercent[] = {0, 0, 5, 30, 90};
        gap_percent = kPercent[rng_.below(5)];
        stall_percent = kPercent[rng_.below(5)];
      }
      if (options.reset_one_in && rng_.chance(options.reset_one_in)) {
        if (!options.reset_in_flight || rng_.chance(2)) {
          drain();
        } else {
          separate();
        }
        reset();
      }
      if (rng_.chance(options.config_one_in)) {
        drain();
        set_config();
      }
      const bool enable = !rng_.percent(stall_percent);
      // A beat that is not taken stays, as from a real source; what stands there in a gap is arbitrary.
      if (!pending_ && !rng_.percent(gap_percent)) pending_ = feed_.next();
      report_.gaps += !pending_;
      report_.stalls += !enable;
      put(pending_ ? *pending_ : noise_.template value<In>());
      clock(enable, pending_.has_value());
    }
    drain();
    if (!expected_.empty()) throw Mismatch{"outputs are missing" + where()};
  }

  /// Nothing in the pipeline. A beat that waits to be taken goes on waiting.
  void drain() {
    for (unsigned n = 0; n <= dut_.latency; ++n) {
      put(noise_.template value<In>());
      clock(true, false);
    }
  }

  void reset() {
    ++report_.resets;
    report_.resets_in_flight += last_taken_ && enabled_ - *last_taken_ < dut_.latency;
    *dut_.reset_n = 0;
    const std::uint64_t clocks = 1 + rng_.below(3);
    for (std::uint64_t n = 0; n < clocks; ++n) {
      put(noise_.template value<In>());
      *dut_.enable = rng_.chance(2);
      *dut_.valid_in = rng_.chance(2);
      edge();
      if (n == 0 && *dut_.enable) {
        // The registers fall to their initial values; a write to memory that stood before this edge still happens.
        ++enabled_;
        settle();
      }
      if (*dut_.valid_out) throw Mismatch{"valid_o is high in reset" + where()};
    }
    *dut_.reset_n = 1;
    pending_.reset();
    expected_.clear();
    flying_.clear();
    last_taken_.reset();
    hls::reset(settled_);
    stage_ = settled_;
    feed_.restart();
    read_outputs(held_);
  }

  void set_config() {
    config_ = feed_.config();
    if constexpr (!std::is_same_v<Config, detail::NoConfig>) {
      pack(config_, false, words_);
      std::copy(words_.begin(), words_.end(), dut_.config);
    }
  }

  void put(const In& in) {
    pack(in, false, words_);
    std::copy(words_.begin(), words_.end(), dut_.in);
  }

  void edge() {
    ++report_.clocks;
    *dut_.clock = 0;
    model_.eval();
    *dut_.clock = 1;
    model_.eval();
  }

  Out step(Stage& stage, const In& in) {
    if constexpr (std::is_same_v<Config, detail::NoConfig>) {
      return stage.step(in);
    } else {
      return stage.step(in, config_);
    }
  }

  void clock(bool enable, bool valid) {
    *dut_.enable = enable;
    *dut_.valid_in = valid;
    if (enable && valid) {
      const Out out = step(stage_, *pending_);
      bool given = true;
      if constexpr (requires { out.valid; }) given = static_cast<bool>(out.valid);
      if (given) {
        expected_.push_back({enabled_ + dut_.latency, report_.beats, {}});
        pack(out, true, expected_.back().words);
      }
      flying_.push_back({enabled_, *pending_});
      last_taken_ = enabled_;
      pending_.reset();
      ++report_.beats;
    }
    edge();
    if (!enable) {
      read_outputs(now_);
      if (now_ != held_) throw Mismatch{"an output changed in a stall" + where()};
      return;
    }
    ++enabled_;
    settle();
    read_outputs(held_);
    const bool due = !expected_.empty() && expected_.front().due == enabled_;
    if (due != static_cast<bool>(*dut_.valid_out)) {
      throw Mismatch{(due ? "an output is missing" : "an output came that none expected") + where()};
    }
    if (due) {
      compare(expected_.front());
      expected_.pop_front();
      ++report_.outputs;
    }
  }

  /// A reset drops the beats in the pipeline, but not what they have written to memories by then. `settled_` has
  /// taken the beats that have passed the last writing stage.
  void settle() {
    while (!flying_.empty() && enabled_ - flying_.front().taken > last_write_) {
      if (!dut_.memories.empty()) step(settled_, flying_.front().in);
      flying_.pop_front();
    }
  }

  /// Before a reset: no beat between the first and the last writing stage, so that each has written all or nothing.
  void separate() {
    if (first_write_ == last_write_) return;
    const std::uint64_t young = rng_.below(first_write_);
    for (std::uint64_t n = young; n < last_write_; ++n) {
      put(noise_.template value<In>());
      clock(true, false);
    }
    for (std::uint64_t n = 0; n < young; ++n) {
      if (!pending_) pending_ = feed_.next();
      put(*pending_);
      clock(true, true);
    }
  }

  void read_outputs(std::vector<std::uint32_t>& words) const {
    words.assign(dut_.out, dut_.out + out_words_);
    words.push_back(*dut_.valid_out);
  }

  void compare(const Expected& expected) const {
    if (std::equal(expected.words.begin(), expected.words.end(), held_.begin())) return;
    std::string text = "beat " + std::to_string(expected.beat) + ":";
    unsigned low = 0;
    for (const DutPort& port : dut_.out_ports) {
      const std::uint64_t native = field(expected.words, low, port.width);
      const std::uint64_t emitted = field(held_, low, port.width);
      if (native != emitted) {
        text += " " + port.name + " native " + std::to_string(native) + " emitted " + std::to_string(emitted) + ";";
      }
      low += port.width;
    }
    throw Mismatch{text + where()};
  }

  static std::uint64_t field(const std::vector<std::uint32_t>& words, unsigned low, unsigned width) {
    std::uint64_t value = 0;
    for (unsigned n = 0; n < width; ++n) {
      value |= static_cast<std::uint64_t>(words[(low + n) / 32] >> ((low + n) % 32) & 1) << n;
    }
    return value;
  }

  std::string where() const {
    return " (clock " + std::to_string(report_.clocks) + ", beats " + std::to_string(report_.beats) + ", resets " +
           std::to_string(report_.resets) + ")";
  }

  /// The sidecar's ports have the widths and signs of the C++ leaves, in the same order.
  void check_ports() {
    const auto check = [](const char* what, const std::vector<LeafShape>& leaves, const std::vector<DutPort>& ports) {
      std::string text;
      if (leaves.size() != ports.size()) {
        text = std::to_string(leaves.size()) + " leaves, " + std::to_string(ports.size()) + " ports";
      }
      for (std::size_t n = 0; n < std::min(leaves.size(), ports.size()); ++n) {
        if (leaves[n] == LeafShape{ports[n].width, ports[n].is_signed}) continue;
        text += "; " + ports[n].name + " has " + std::to_string(ports[n].width) +
                (ports[n].is_signed ? " signed" : "") + " bits, the leaf " + std::to_string(leaves[n].width) +
                (leaves[n].is_signed ? " signed" : "");
      }
      if (!text.empty()) throw Mismatch{std::string{what} + ": " + text};
    };
    check("In", leaf_shapes<In>(false), dut_.in_ports);
    check("Out", leaf_shapes<Out>(true), dut_.out_ports);
    if constexpr (!std::is_same_v<Config, detail::NoConfig>) {
      check("Config", leaf_shapes<Config>(false), dut_.config_ports);
    }
    unsigned bits = 0;
    for (const DutPort& port : dut_.out_ports) bits += port.width;
    out_words_ = (bits + 31) / 32;
    for (const DutMemory& memory : dut_.memories) {
      first_write_ = std::min(first_write_ ? first_write_ : memory.write_stage, memory.write_stage);
      last_write_ = std::max(last_write_, memory.write_stage);
    }
  }

  DutModel& model_;
  Dut& dut_;
  Rng rng_;
  Feed feed_;
  RandomLeaves noise_{Rng{std::uint64_t{0x5eed}}};
  Stage stage_{};    ///< has taken every beat that the module has
  Stage settled_{};  ///< has taken those whose writes have happened
  Config config_{};
  std::optional<In> pending_;
  std::deque<Expected> expected_;
  std::deque<Flying> flying_;
  std::uint64_t enabled_ = 0;
  std::optional<std::uint64_t> last_taken_;
  std::size_t out_words_ = 0;
  unsigned first_write_ = 0, last_write_ = 0;  ///< pipeline stages; memories are never written in stage 0
  std::vector<std::uint32_t> words_, held_, now_;
  BenchReport report_;
};

}  // namespace horopter::tb
