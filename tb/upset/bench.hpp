// SPDX-License-Identifier: Apache-2.0
// horopter_top between two cameras and a host, of which every state can be kept, compared and taken back: so that one of
// its bits can be changed at any clock, and what follows be seen without simulating what came before again.
#pragma once

#include <verilated.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "horopter/machine/registers.hpp"
#include "horopter/tb/image.hpp"
#include "horopter/verilated/stop.hpp"
#include "signal.hpp"

namespace horopter::upset {

namespace reg = registers;

/// Of the host, to a register.
struct Access {
  bool write;
  std::uint32_t address, word = 0;
};

/// What cameras and host do. Frame k begins at clock k · period().
struct Scenario {
  unsigned width = 96, height = 48;
  bool live = false;
  std::vector<tb::Image> left, right;                          ///< by frame
  std::vector<std::pair<std::uint32_t, std::uint32_t>> setup;  ///< address, word: before the first frame
  std::vector<Access> meanwhile;  ///< again and again, a frame a part, whenever a frame asks for nothing
  std::size_t part = 0;           ///< accesses of one

  static constexpr unsigned kRowPause = 16, kRowsBetween = 32;
  [[nodiscard]] unsigned line() const { return width + kRowPause; }
  [[nodiscard]] unsigned period() const { return (height + kRowsBetween) * line(); }
  [[nodiscard]] std::uint64_t end() const { return left.size() * std::uint64_t{period()}; }
};

/// What was seen of one published frame.
struct Seen {
  std::uint64_t clock = 0;
  bool safe = false;  ///< the pins, when all that belongs to the frame has reached them
  bool alarm = false;
  std::uint32_t faults_cameras = 0, faults_machine = 0, skin = 0;
  std::uint32_t tables = 0;  ///< slots that were read to be valid until the next frame
};
constexpr std::size_t kMostFrames = 16;
struct History {
  std::array<Seen, kMostFrames> frames;
  std::size_t count = 0;
};

/// A bit of a register or memory, changed once or held.
struct Fault {
  const Signal* signal = nullptr;
  std::uint64_t bit = 0;
  std::uint64_t clock = 0;  ///< after the edge of this clock, counted from the first frame on
  bool stuck = false;
};

class Bench {
 public:
  virtual ~Bench() = default;
  [[nodiscard]] virtual const std::vector<Signal>& signals() const = 0;
  /// The undisturbed run; what was seen of it. `from_clock`: no fault will come before.
  virtual const History& record(const Scenario& scenario, std::uint64_t from_clock) = 0;
  /// The same with a fault; ends early when nothing of it is left.
  virtual History inject(const Fault& fault) = 0;
};

/// Of a model VNAME with its root structure VNAME___024root. `settle`: computes all logic anew from the registers.
template <class Model, class Root>
class BenchOf final : public Bench {
 public:
  using List = std::vector<Signal> (*)(Root&);
  using Settle = void (*)(Root*);

  BenchOf(List list, Settle settle, std::uint64_t seed) : model_{prepare(context_, seed)}, settle_{settle} {
    signals_ = list(*model_.rootp);
    auto* begin = reinterpret_cast<const std::byte*>(model_.rootp);
    state_bytes_ = static_cast<std::size_t>(reinterpret_cast<const std::byte*>(&model_.rootp->vlSymsp) - begin);
  }
  ~BenchOf() override { model_.final(); }
  BenchOf(const BenchOf&) = delete;
  BenchOf& operator=(const BenchOf&) = delete;

  [[nodiscard]] const std::vector<Signal>& signals() const override { return signals_; }

  const History& record(const Scenario& scenario, std::uint64_t from_clock) override {
    scenario_ = &scenario;
    verilated::stop_at_errors(true);
    driver_ = {};
    history_ = {};
    checkpoints_.clear();
    first_checkpoint_ = from_clock / kCheckpointClocks;
    model_.rst_ni = 0;
    model_.clk_i = 0;
    model_.m_axis_state_tready = model_.m_axis_runs_tready = model_.m_axis_objects_tready = 1;
    model_.s_axis_test_tvalid = 0;
    model_.restart_i = 0;
    model_.s_axil_awprot = model_.s_axil_arprot = 0;
    for (int i = 0; i < 4; ++i) tick();
    model_.rst_ni = 1;
    for (const auto& [address, word] : scenario.setup) access({true, address, word});
    driver_ = {};
    driver_.running = true;
    while (driver_.clock < scenario.end()) {
      if (driver_.clock % kCheckpointClocks == 0 && driver_.clock / kCheckpointClocks >= first_checkpoint_) {
        checkpoints_.push_back(checkpoint());
      }
      tick();
    }
    recorded_ = history_;
    verilated::stop_at_errors(false);  // from here on what must not be may be
    return recorded_;
  }

  History inject(const Fault& fault) override {
    std::size_t next = fault.clock / kCheckpointClocks - first_checkpoint_;
    restore(checkpoints_.at(next++));
    while (driver_.clock < fault.clock) tick();
    tick();
    const bool stuck_at = !fault.signal->get(fault.bit);
    fault.signal->flip(fault.bit);
    settle_(model_.rootp);
    while (driver_.clock < scenario_->end()) {
      if (driver_.clock % kCheckpointClocks == 0) {
        next = driver_.clock / kCheckpointClocks - first_checkpoint_;
        if (!fault.stuck && same(checkpoints_.at(next))) return completed();
      }
      tick();
      if (fault.stuck) hold(fault, stuck_at);
    }
    // A frame that does not come: the watchdog has seen it by the end of this.
    if (history_.count < recorded_.count) {
      for (unsigned i = 0; i < 3 * scenario_->period(); ++i) {
        tick();
        if (fault.stuck) hold(fault, stuck_at);
      }
      for (std::size_t k = history_.count; k < recorded_.count; ++k) history_.frames[k].safe = safe();
    }
    return history_;
  }

 private:
  static constexpr std::uint64_t kCheckpointClocks = 1024;
  static constexpr std::uint64_t kPinsFollow = 12;  // clocks from frame_done_o until the pins say all of the frame

  static constexpr auto kEachFrame = std::to_array<Access>({
      {false, reg::frame_status::kAddress},
      {false, reg::frame_faults_cameras::kAddress},
      {false, reg::frame_faults_machine::kAddress},
      {false, reg::frame_skin::kAddress},
      {true, reg::faults_cameras::kAddress, 0xFFFFFFFF},
      {true, reg::faults_machine::kAddress, 0xFFFFFFFF},
      {true, reg::table_select::kAddress, 0},
  });
  /// Everything outside the model.
  struct Driver {
    std::uint64_t clock = 0;
    std::uint64_t look_at_pins = 0;       // a clock
    std::array<std::uint64_t, 2> sent{};  // pixels
    std::uint64_t access = kEachFrame.size();
    std::uint64_t meanwhile = 0;  // of the scenario's
    bool part_done = true;        // the next one waits for a frame
    std::uint64_t waited = 0;
    bool running = false, address_taken = false, word_taken = false;
    bool frame_done = false;  // its accesses begin when the one under way has ended
    friend bool operator==(const Driver&, const Driver&) = default;
  };
  struct Checkpoint {
    std::vector<std::byte> state;
    Driver driver;
    History history;
  };

  static VerilatedContext* prepare(VerilatedContext& context, std::uint64_t seed) {
    context.randReset(2);
    context.randSeed(static_cast<int>(seed & 0x7fffffff));
    return &context;
  }
  [[nodiscard]] std::byte* state() { return reinterpret_cast<std::byte*>(model_.rootp); }
  Checkpoint checkpoint() { return {{state(), state() + state_bytes_}, driver_, history_}; }
  void restore(const Checkpoint& to) {
    std::memcpy(state(), to.state.data(), state_bytes_);
    driver_ = to.driver;
    history_ = to.history;
  }
  bool same(const Checkpoint& as) {
    return driver_ == as.driver && std::memcmp(state(), as.state.data(), state_bytes_) == 0;
  }
  /// From here on all is as recorded.
  History completed() {
    for (std::size_t k = history_.count; k < recorded_.count; ++k) history_.frames[k] = recorded_.frames[k];
    history_.count = std::max(history_.count, recorded_.count);
    return history_;
  }
  void hold(const Fault& fault, bool stuck_at) {
    if (fault.signal->get(fault.bit) == stuck_at) return;
    fault.signal->flip(fault.bit);
    settle_(model_.rootp);
  }
  [[nodiscard]] bool safe() const { return model_.safe_o != 0 && model_.unsafe_o == 0; }

  /// One access while nothing else happens; for the setup.
  void access(const Access& what) {
    single_ = &what;
    driver_.access = 0;
    for (int i = 0; i < 1000 && single_ != nullptr; ++i) tick();
    if (single_ != nullptr) throw std::runtime_error("no answer on AXI4-Lite");
  }
  /// For a frame. The last one selects the table, which `meanwhile` does itself.
  [[nodiscard]] bool asks() const {
    return driver_.access + (scenario_->meanwhile.empty() ? 0 : 1) < kEachFrame.size();
  }
  [[nodiscard]] const Access* now() const {
    if (single_ != nullptr) return single_;
    if (asks()) return &kEachFrame[driver_.access];
    return driver_.part_done ? nullptr : &scenario_->meanwhile[driver_.meanwhile];
  }

  void drive_camera(int camera, std::uint8_t& data, std::uint8_t& user, std::uint8_t& last, std::uint8_t& valid) {
    const std::uint64_t pixels = std::uint64_t{scenario_->width} * scenario_->height;
    const std::uint64_t sent = driver_.sent[static_cast<std::size_t>(camera)];
    const auto& images = camera == 0 ? scenario_->left : scenario_->right;
    const std::uint64_t frame = sent / pixels, row = sent % pixels / scenario_->width, x = sent % scenario_->width;
    const std::uint64_t due = frame * scenario_->period() + row * scenario_->line() + x;
    valid = driver_.running && frame < images.size() && driver_.clock >= due ? 1 : 0;
    if (valid == 0) return;
    data = images[frame].pixels[sent % pixels];
    user = sent % pixels == 0 ? 1 : 0;
    last = x == scenario_->width - 1 ? 1 : 0;
  }
  void drive_host() {
    const Access* access = now();
    const bool write = access != nullptr && access->write, read = access != nullptr && !access->write;
    model_.s_axil_awvalid = write && !driver_.address_taken ? 1 : 0;
    model_.s_axil_wvalid = write && !driver_.word_taken ? 1 : 0;
    model_.s_axil_arvalid = read && !driver_.address_taken ? 1 : 0;
    model_.s_axil_bready = model_.s_axil_rready = 1;
    model_.s_axil_wstrb = 15;
    if (write) {
      model_.s_axil_awaddr = static_cast<std::uint16_t>(access->address);
      model_.s_axil_wdata = access->word;
    } else if (read) {
      model_.s_axil_araddr = static_cast<std::uint16_t>(access->address);
    }
  }
  void sample_host() {
    const Access* access = now();
    if (access == nullptr) return;
    if ((access->write && model_.s_axil_awvalid && model_.s_axil_awready) ||
        (!access->write && model_.s_axil_arvalid && model_.s_axil_arready)) {
      driver_.address_taken = true;
    }
    if (model_.s_axil_wvalid && model_.s_axil_wready) driver_.word_taken = true;
    const bool answered = access->write ? model_.s_axil_bvalid != 0 : model_.s_axil_rvalid != 0;
    if (!answered && ++driver_.waited < 200) return;
    if (answered && !access->write && history_.count > 0) take(access->address, model_.s_axil_rdata);
    driver_.address_taken = driver_.word_taken = false;
    driver_.waited = 0;
    if (single_ != nullptr || asks()) {
      ++driver_.access;
    } else {
      driver_.meanwhile = (driver_.meanwhile + 1) % scenario_->meanwhile.size();
      driver_.part_done = driver_.meanwhile % scenario_->part == 0;
    }
    if (driver_.frame_done) driver_.access = 0;
    driver_.frame_done = false;
    if (single_ != nullptr) {
      if (!answered || (access->write && model_.s_axil_bresp != 0)) throw std::runtime_error("refused on AXI4-Lite");
      single_ = nullptr;
      driver_.access = kEachFrame.size();
    }
  }
  void take(std::uint32_t address, std::uint32_t word) {
    Seen& seen = history_.frames[history_.count - 1];
    if (address == reg::frame_status::kAddress) seen.alarm = reg::frame_status::kAlarm.get(word) != 0;
    if (address == reg::frame_faults_cameras::kAddress) seen.faults_cameras = word;
    if (address == reg::frame_faults_machine::kAddress) seen.faults_machine = word;
    if (address == reg::frame_skin::kAddress) seen.skin = word;
    if (address == reg::map_valid::kAddress) seen.tables |= word;
  }
  void tick() {
    drive_camera(0, model_.s_axis_left_tdata, model_.s_axis_left_tuser, model_.s_axis_left_tlast,
                 model_.s_axis_left_tvalid);
    drive_camera(1, model_.s_axis_right_tdata, model_.s_axis_right_tuser, model_.s_axis_right_tlast,
                 model_.s_axis_right_tvalid);
    drive_host();
    model_.clk_i = 0;
    model_.eval();
    if (model_.s_axis_left_tvalid && (model_.s_axis_left_tready || scenario_->live)) ++driver_.sent[0];
    if (model_.s_axis_right_tvalid && (model_.s_axis_right_tready || scenario_->live)) ++driver_.sent[1];
    sample_host();
    if (driver_.running && driver_.clock == driver_.look_at_pins && history_.count > 0) {
      history_.frames[history_.count - 1].safe = safe();
    }
    if (driver_.running && model_.frame_done_o && history_.count < kMostFrames) {
      history_.frames[history_.count++].clock = driver_.clock;
      driver_.look_at_pins = driver_.clock + kPinsFollow;
      if (asks() || now() == nullptr) {
        driver_.access = 0;
        driver_.address_taken = driver_.word_taken = false;
        driver_.waited = 0;
      } else {
        driver_.frame_done = true;
      }
      driver_.part_done = scenario_->meanwhile.empty();
    }
    model_.clk_i = 1;
    model_.eval();
    ++driver_.clock;
  }

  VerilatedContext context_;
  Model model_;
  Settle settle_;
  std::vector<Signal> signals_;
  std::size_t state_bytes_ = 0;
  const Scenario* scenario_ = nullptr;
  const Access* single_ = nullptr;
  Driver driver_;
  History history_, recorded_;
  std::vector<Checkpoint> checkpoints_;
  std::uint64_t first_checkpoint_ = 0;
};

}  // namespace horopter::upset
