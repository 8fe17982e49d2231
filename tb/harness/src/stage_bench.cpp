// SPDX-License-Identifier: Apache-2.0
#include "horopter/tb/stage_bench.hpp"

#include <algorithm>
#include <deque>
#include <iterator>
#include <optional>

#include "horopter/verilated/stop.hpp"

namespace horopter::tb {

RandomLeaves::RandomLeaves(Rng rng, const std::vector<DutPort>& ports) : rng_{rng} {
  for (const DutPort& port : ports) {
    episodes_.emplace_back();
    episodes_.back().width = port.width;
  }
}

void RandomLeaves::next(Beat& values) {
  values.clear();
  for (Episode& episode : episodes_) values.push_back(next(episode));
}

std::uint64_t RandomLeaves::next(Episode& episode) {
  if (episode.remaining == 0) {
    static constexpr unsigned kOnes[] = {0, 1, 16, 128, 128, 240, 255, 256};
    episode.kind = static_cast<Kind>(rng_.chance(2) ? 0 : rng_.below(5));
    episode.ones_in_256 = kOnes[rng_.below(8)];
    episode.remaining = static_cast<unsigned>(1 + rng_.below(episode.width == 1 ? 2'000 : 200));
  }
  --episode.remaining;
  if (episode.width == 1) return rng_.below(256) < episode.ones_in_256;
  const std::uint64_t mask = ~std::uint64_t{0} >> (64 - episode.width);
  switch (episode.kind) {
    case Kind::uniform:
      episode.last = rng_.next();
      break;
    case Kind::ends: {
      // 0, all ones and the sign change, or one beside them.
      const std::uint64_t end[] = {0, mask, std::uint64_t{1} << (episode.width - 1)};
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

namespace {

struct Mismatch {
  std::string text;
};

/// Values, least significant first, into the words of a wide port.
void pack(const Beat& values, const std::vector<DutPort>& ports, std::uint32_t* words) {
  std::uint64_t pending = 0;  // of which `filled` < 32 bits are used
  unsigned filled = 0;
  const auto append = [&](std::uint64_t bits, unsigned width) {
    pending |= bits << filled;
    for (filled += width; filled >= 32; filled -= 32) {
      *words++ = static_cast<std::uint32_t>(pending);
      pending >>= 32;
    }
  };
  for (std::size_t n = 0; n < ports.size(); ++n) {
    append(values[n] & 0xffffffffU, std::min(ports[n].width, 32U));
    if (ports[n].width > 32) append(values[n] >> 32, ports[n].width - 32);
  }
  if (filled) *words = static_cast<std::uint32_t>(pending);
}

void unpack(const std::uint32_t* words, const std::vector<DutPort>& ports, Beat& values) {
  values.clear();
  unsigned low = 0;
  for (const DutPort& port : ports) {
    std::uint64_t value = 0;
    for (unsigned have = 0; have < port.width;) {
      const unsigned word = (low + have) / 32, shift = (low + have) % 32;
      value |= static_cast<std::uint64_t>(words[word] >> shift) << have;
      have += 32 - shift;
    }
    values.push_back(port.width == 64 ? value : value & ((std::uint64_t{1} << port.width) - 1));
    low += port.width;
  }
}

class StageBench {
 public:
  StageBench(DutModel& model, Dut& dut, NativeStage& native, NativeStage& settled, Stimulus& stimulus, Rng rng,
             const BenchOptions& options)
      : model_{model},
        dut_{dut},
        native_{native},
        settled_{settled},
        stimulus_{stimulus},
        rng_{rng},
        options_{options},
        noise_{Rng{rng_.next()}, dut.in_ports} {}

  BenchReport run() {
    try {
      check_ports();
      run_checked();
    } catch (const Mismatch& mismatch) {
      report_.failure = dut_.name + ": " + mismatch.text + where();
    } catch (const verilated::Stopped& stopped) {
      report_.failure = dut_.name + ": " + stopped.what() + where();
    } catch (const hls::hazard_error& hazard) {
      report_.failure = dut_.name + ": the native class refuses the stimulus: " + hazard.what() + where();
    }
    return report_;
  }

 private:
  struct Expected {
    std::uint64_t due;  ///< count of enabled clocks after which it is on the output
    std::uint64_t beat;
    Beat out;
  };
  struct Flying {
    std::uint64_t taken;  ///< count of enabled clocks before the one that took it
    Beat in;
  };

  void run_checked() {
    set_config();
    reset();
    unsigned gap_percent = 0, stall_percent = 0;
    while (report_.beats < options_.beats) {
      if (rng_.chance(1'000)) {
        static constexpr unsigned kPercent[] = {0, 0, 5, 30, 90};
        gap_percent = kPercent[rng_.below(5)];
        stall_percent = kPercent[rng_.below(5)];
      }
      if (rng_.chance(options_.reset_one_in)) {
        if (rng_.chance(2)) {
          drain();
        } else {
          separate();
        }
        reset();
      }
      if (rng_.chance(options_.config_one_in)) {
        drain();
        set_config();
      }
      const bool enable = !rng_.percent(stall_percent);
      // A beat that is not taken waits, as in a real source.
      if (!pending_ && !rng_.percent(gap_percent)) offer();
      report_.gaps += !pending_;
      report_.stalls += !enable;
      clock(enable, pending_.has_value());
    }
    drain();
    if (!expected_.empty()) throw Mismatch{"outputs are missing"};
  }

  void offer() {
    pending_.emplace();
    stimulus_.next(*pending_);
  }

  /// Nothing in the pipeline. A beat that waits to be taken goes on waiting.
  void drain() {
    for (unsigned n = 0; n <= dut_.latency; ++n) clock(true, false);
  }

  /// Before a reset: no beat between the first and the last writing stage, so that each has written all or nothing, and
  /// one in the first stage where none needs to be kept out.
  void separate() {
    if (!first_write_ || *first_write_ == last_write_) {
      if (!pending_) offer();
      clock(true, true);
      return;
    }
    const std::uint64_t young = *first_write_ == 0 ? 0 : rng_.below(*first_write_);
    for (std::uint64_t n = young; n < last_write_; ++n) clock(true, false);
    for (std::uint64_t n = 0; n < young; ++n) {
      if (!pending_) offer();
      clock(true, true);
    }
  }

  void reset() {
    ++report_.resets;
    report_.resets_in_flight += last_taken_ && enabled_ - *last_taken_ < dut_.latency;
    *dut_.reset_n = 0;
    const std::uint64_t clocks = 1 + rng_.below(3);
    for (std::uint64_t n = 0; n < clocks; ++n) {
      put_noise();
      // At power-up the valid bits are unknown: with en_i low they cannot write to memories before they are reset.
      *dut_.enable = report_.resets > 1 && rng_.chance(2);
      *dut_.valid_in = rng_.chance(2);
      edge();
      if (n == 0 && *dut_.enable) {
        // The registers fall to their initial values; a write to memory that stood before this edge still happens.
        ++enabled_;
        settle();
      }
      if (*dut_.valid_out) throw Mismatch{"valid_o is high in reset"};
    }
    *dut_.reset_n = 1;
    pending_.reset();
    expected_.clear();
    flying_.clear();
    last_taken_.reset();
    settled_.reset();
    native_.assign(settled_);
    stimulus_.restart();
    read_outputs(held_, held_valid_);
  }

  void set_config() {
    stimulus_.config(config_);
    pack(config_, dut_.config_ports, dut_.config);
  }

  /// What stands on the inputs while there is no beat is arbitrary.
  void put_noise() {
    noise_.next(noise_beat_);
    pack(noise_beat_, dut_.in_ports, dut_.in);
  }

  void edge() {
    ++report_.clocks;
    *dut_.clock = 0;
    model_.eval();
    *dut_.clock = 1;
    model_.eval();
    if (report_.resets > 0 && dut_.parity_error != nullptr && *dut_.parity_error != 0) {
      throw Mismatch{"a word of a memory is not as it was written"};
    }
  }

  void clock(bool enable, bool valid) {
    *dut_.enable = enable;
    *dut_.valid_in = valid;
    if (valid) {
      pack(*pending_, dut_.in_ports, dut_.in);
    } else {
      put_noise();
    }
    if (enable && valid) {
      if (native_.step(*pending_, config_, now_)) expected_.push_back({enabled_ + dut_.latency, report_.beats, now_});
      flying_.push_back({enabled_, std::move(*pending_)});
      last_taken_ = enabled_;
      pending_.reset();
      ++report_.beats;
    }
    edge();
    if (!enable) {
      bool valid_now = false;
      read_outputs(now_, valid_now);
      if (now_ != held_ || valid_now != held_valid_) throw Mismatch{"an output changed in a stall"};
      return;
    }
    ++enabled_;
    settle();
    read_outputs(held_, held_valid_);
    const bool due = !expected_.empty() && expected_.front().due == enabled_;
    if (due != held_valid_) throw Mismatch{due ? "an output is missing" : "an output came that none expected"};
    if (!due) return;
    compare(expected_.front());
    expected_.pop_front();
    ++report_.outputs;
  }

  /// A reset drops the beats in the pipeline, but not what they have written to memories by then: `settled_` has taken
  /// the beats that have passed the last writing stage.
  void settle() {
    while (!flying_.empty() && enabled_ - flying_.front().taken > last_write_) {
      if (!dut_.memories.empty()) settled_.step(flying_.front().in, config_, scratch_);
      flying_.pop_front();
    }
  }

  void read_outputs(Beat& values, bool& valid) const {
    unpack(dut_.out, dut_.out_ports, values);
    valid = *dut_.valid_out;
  }

  void compare(const Expected& expected) const {
    if (expected.out == held_) return;
    std::string text = "beat " + std::to_string(expected.beat) + ":";
    for (std::size_t n = 0; n < held_.size(); ++n) {
      if (expected.out[n] == held_[n]) continue;
      text += " " + dut_.out_ports[n].name + " native " + std::to_string(expected.out[n]) + " emitted " +
              std::to_string(held_[n]) + ";";
    }
    throw Mismatch{text};
  }

  std::string where() const {
    return " (clock " + std::to_string(report_.clocks) + ", beats " + std::to_string(report_.beats) + ", resets " +
           std::to_string(report_.resets) + ")";
  }

  /// The sidecar's ports have the widths and signs of the C++ leaves, in the same order.
  void check_ports() {
    const auto check = [](const char* what, const std::vector<Leaf>& all_leaves, const std::vector<DutPort>& ports) {
      std::vector<Leaf> leaves;
      std::copy_if(all_leaves.begin(), all_leaves.end(), std::back_inserter(leaves),
                   [](const Leaf& leaf) { return leaf.has_port; });
      std::string text;
      if (leaves.size() != ports.size()) {
        text = std::to_string(leaves.size()) + " leaves, " + std::to_string(ports.size()) + " ports";
      }
      const auto shape = [](const auto& x) {
        return std::to_string(x.width) + (x.is_signed ? " signed" : "") + " bits";
      };
      for (std::size_t n = 0; n < std::min(leaves.size(), ports.size()); ++n) {
        if (shape(leaves[n]) != shape(ports[n])) {
          text += "; " + ports[n].name + " has " + shape(ports[n]) + ", the leaf " + shape(leaves[n]);
        }
      }
      if (!text.empty()) throw Mismatch{std::string{what} + ": " + text};
    };
    check("In", native_.in_leaves, dut_.in_ports);
    check("Config", native_.config_leaves, dut_.config_ports);
    check("Out", native_.out_leaves, dut_.out_ports);
    for (const DutMemory& memory : dut_.memories) {
      first_write_ = first_write_ ? std::min(*first_write_, memory.write_stage) : memory.write_stage;
      last_write_ = std::max(last_write_, memory.write_stage);
    }
  }

  DutModel& model_;
  Dut& dut_;
  NativeStage& native_;   ///< has taken every beat that the module has
  NativeStage& settled_;  ///< has taken those whose writes have all happened
  Stimulus& stimulus_;
  Rng rng_;
  const BenchOptions& options_;
  RandomLeaves noise_;
  std::optional<Beat> pending_;
  std::deque<Expected> expected_;
  std::deque<Flying> flying_;
  std::uint64_t enabled_ = 0;
  std::optional<std::uint64_t> last_taken_;
  std::optional<unsigned> first_write_;  ///< pipeline stages in which memories or kept registers are written
  unsigned last_write_ = 0;
  Beat config_, held_, now_, scratch_, noise_beat_;
  bool held_valid_ = false;
  BenchReport report_;
};

}  // namespace

BenchReport run_stage_bench(DutModel& model, Dut& dut, NativeStage& native, NativeStage& settled, Stimulus& stimulus,
                            Rng rng, const BenchOptions& options) {
  return StageBench{model, dut, native, settled, stimulus, rng, options}.run();
}

}  // namespace horopter::tb
