// SPDX-License-Identifier: Apache-2.0
// RtlDevice over any Verilated horopter_top. One clock is two evaluations: inputs settle, then the edge.
#pragma once

#include <fmt/format.h>
#include <verilated.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "horopter/base/error.hpp"
#include "horopter/machine/registers.hpp"
#include "horopter/machine/rtl_device.hpp"

namespace horopter {

template <class Model>
class RtlMachine final : public RtlDevice {
 public:
  explicit RtlMachine(const MachineProfile& profile) : profile_(profile), height_(profile.height) {
    // As an FPGA powers up: everything 0. (Random contents are for the test benches.)
    context_.randReset(0);
    model_ = std::make_unique<Model>(&context_);
    Model& m = *model_;
    m.clk_i = 0;
    m.s_axil_awvalid = m.s_axil_wvalid = m.s_axil_bready = m.s_axil_arvalid = m.s_axil_rready = 0;
    m.s_axil_awprot = m.s_axil_arprot = 0;
    m.restart_i = 0;
    m.feedback_i = 0;
    m.s_axis_left_tvalid = m.s_axis_right_tvalid = m.s_axis_test_tvalid = 0;
    m.m_axis_state_tready = m.m_axis_runs_tready = 1;
    m.m_axis_objects_tready = 1;  // nobody reads them
    m.rst_ni = 0;
    for (int i = 0; i < 8; ++i) edge();
    m.rst_ni = 1;
    run(8);
  }
  ~RtlMachine() override {
    Verilated::threadContextp(&context_);  // which may be that of a machine made later
    model_->final();
    model_.reset();
  }

  std::uint32_t read(std::uint32_t address) override {
    Model& m = *model_;
    m.s_axil_araddr = address & 0xFFFU;
    m.s_axil_arvalid = 1;
    m.s_axil_rready = 1;
    bool address_taken = false;
    for (int wait = 0; wait < kBusWait; ++wait) {
      settle();
      const bool address_now = m.s_axil_arvalid && m.s_axil_arready;
      const bool data_now = m.s_axil_rvalid;
      const std::uint32_t data = m.s_axil_rdata;
      const unsigned response = m.s_axil_rresp;
      finish_clock();
      if (address_now) {
        address_taken = true;
        m.s_axil_arvalid = 0;
      }
      if (address_taken && data_now) {
        m.s_axil_rready = 0;
        if (response != 0) refused("read", address);
        return data;
      }
    }
    throw DeviceError(fmt::format("the bus does not answer a read of {:03x}", address));
  }

  void write(std::uint32_t address, std::uint32_t value) override {
    Model& m = *model_;
    m.s_axil_awaddr = address & 0xFFFU;
    m.s_axil_wdata = value;
    m.s_axil_wstrb = 0xF;
    m.s_axil_awvalid = m.s_axil_wvalid = m.s_axil_bready = 1;
    for (int wait = 0; wait < kBusWait; ++wait) {
      settle();
      const bool address_now = m.s_axil_awvalid && m.s_axil_awready;
      const bool data_now = m.s_axil_wvalid && m.s_axil_wready;
      const bool answer_now = m.s_axil_bvalid;
      const unsigned response = m.s_axil_bresp;
      finish_clock();
      if (address_now) m.s_axil_awvalid = 0;
      if (data_now) m.s_axil_wvalid = 0;
      if (answer_now) {
        m.s_axil_bready = 0;
        if (response != 0) refused("write", address);
        if (address == registers::height::kAddress) height_ = static_cast<int>(registers::height::kRows.get(value));
        // What a disabled machine had taken or given is gone.
        if (address == registers::control::kAddress && registers::control::kEnable.get(value) == 0) forget();
        return;
      }
    }
    throw DeviceError(fmt::format("the bus does not answer a write of {:03x}", address));
  }

  void send(const Image& left, const Image& right) override {
    cameras_[0].frames.push_back(left);
    cameras_[1].frames.push_back(right);
  }

  FrameStreams receive() override {
    // Everything that a frame can wait for, several times over.
    const std::uint64_t limit = 4ULL * 4096 + 8ULL * static_cast<std::uint64_t>(profile_.width + 16) *
                                                  static_cast<std::uint64_t>(profile_.height + profile_.store_rows);
    const std::uint64_t last = clocks_ + limit;
    while (frames_.empty() || run_frames_.empty()) {
      if (clocks_ == last) {
        throw DeviceError(
            fmt::format("no frame comes within {} clocks: {} rows of states, {} frames of states, {} of runs", limit,
                        rows_.size(), frames_.size(), run_frames_.size()));
      }
      settle();
      finish_clock();
    }
    FrameStreams streams{std::move(frames_.front()), std::move(run_frames_.front())};
    frames_.pop_front();
    run_frames_.pop_front();
    return streams;
  }

  std::string_view engine() const override { return "rtl"; }
  bool counts_cycles() const override { return true; }
  std::uint64_t clocks() const override { return clocks_; }
  void run(std::uint64_t count) override {
    for (; count > 0; --count) {
      settle();
      finish_clock();
    }
  }
  void set_pauses(unsigned camera_percent, unsigned output_percent, std::uint64_t seed) override {
    camera_pause_percent_ = camera_percent;
    output_pause_percent_ = output_percent;
    random_ = seed * 2 + 1;
  }
  bool safe_pin() const override { return model_->safe_o; }
  bool unsafe_pin() const override { return model_->unsafe_o; }

 private:
  /// Clocks; an upload waits for the walk through the directory.
  static constexpr int kBusWait = 100'000;

  struct Camera {
    std::deque<Image> frames;
    std::size_t at = 0;  ///< pixel of the first frame
    int x = 0;
    bool offered = false;  ///< AXI4-Stream: what was offered stays
  };

  [[noreturn]] void refused(const char* what, std::uint32_t address) const {
    throw DeviceError(fmt::format("the machine refuses to {} register {:03x}", what, address));
  }

  bool chance(unsigned percent) {
    if (percent == 0) return false;
    random_ = random_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return (random_ >> 33) % 100 < percent;
  }

  void edge() {
    model_->clk_i = 0;
    model_->eval();
    model_->clk_i = 1;
    model_->eval();
    ++clocks_;
  }

  /// First half of a clock: inputs are driven and everything combinational settles.
  void settle() {
    Model& m = *model_;
    offer(cameras_[0], m.s_axis_left_tvalid, m.s_axis_left_tdata, m.s_axis_left_tuser, m.s_axis_left_tlast);
    offer(cameras_[1], m.s_axis_right_tvalid, m.s_axis_right_tdata, m.s_axis_right_tuser, m.s_axis_right_tlast);
    m.m_axis_state_tready = !chance(output_pause_percent_);
    m.m_axis_runs_tready = !chance(output_pause_percent_);
    m.clk_i = 0;
    m.eval();
  }

  /// Second half: handshakes are noted, then the edge.
  void finish_clock() {
    Model& m = *model_;
    taken(cameras_[0], m.s_axis_left_tvalid && m.s_axis_left_tready);
    taken(cameras_[1], m.s_axis_right_tvalid && m.s_axis_right_tready);
    if (m.m_axis_state_tvalid && m.m_axis_state_tready)
      take_state(m.m_axis_state_tdata & 3U, m.m_axis_state_tuser, m.m_axis_state_tlast);
    if (m.m_axis_runs_tvalid && m.m_axis_runs_tready) {
      runs_.push_back(decode_run(m.m_axis_runs_tdata));
      if (m.m_axis_runs_tlast) run_frames_.push_back(std::exchange(runs_, {}));
    }
    m.clk_i = 1;
    m.eval();
    ++clocks_;
  }

  template <class Bit, class Byte>
  void offer(Camera& camera, Bit& valid, Byte& data, Bit& user, Bit& last) {
    if (camera.frames.empty() || (!camera.offered && chance(camera_pause_percent_))) {
      valid = 0;
      return;
    }
    const Image& image = camera.frames.front();
    valid = 1;
    camera.offered = true;
    data = image.pixels[camera.at];
    user = camera.at == 0;
    last = camera.x + 1 == image.width;
  }

  static void taken(Camera& camera, bool now) {
    if (!now) return;
    camera.offered = false;
    const Image& image = camera.frames.front();
    camera.x = camera.x + 1 == image.width ? 0 : camera.x + 1;
    if (++camera.at == image.pixels.size()) {
      camera.frames.pop_front();
      camera.at = 0;
    }
  }

  void take_state(unsigned state, bool first, bool last) {
    if (first) {
      if (!rows_.empty() || !row_.empty()) throw DeviceError("the machine starts a frame of states within another one");
      width_ = 0;
    }
    row_.push_back(static_cast<std::uint8_t>(state));
    if (!last) return;
    if (width_ == 0) width_ = row_.size();
    if (row_.size() != width_) throw DeviceError("the machine gives rows of states of different lengths");
    rows_.push_back(std::exchange(row_, {}));
    if (static_cast<int>(rows_.size()) < height_) return;
    Image frame(static_cast<int>(width_), height_);
    for (int y = 0; y < height_; ++y) {
      std::copy(rows_[static_cast<std::size_t>(y)].begin(), rows_[static_cast<std::size_t>(y)].end(), &frame.at(0, y));
    }
    rows_.clear();
    frames_.push_back(std::move(frame));
  }

  void forget() {
    for (Camera& camera : cameras_) camera = {};
    rows_.clear();
    row_.clear();
    runs_.clear();
    frames_.clear();
    run_frames_.clear();
  }

  const MachineProfile& profile_;
  VerilatedContext context_;
  std::unique_ptr<Model> model_;
  std::uint64_t clocks_ = 0;
  std::array<Camera, 2> cameras_;
  unsigned camera_pause_percent_ = 0;
  unsigned output_pause_percent_ = 0;
  std::uint64_t random_ = 1;

  std::vector<std::uint8_t> row_;
  std::vector<std::vector<std::uint8_t>> rows_;
  std::size_t width_ = 0;  ///< of the current frame's first row
  int height_ = 0;         ///< as last written to HEIGHT
  std::deque<Image> frames_;
  std::vector<Run> runs_;
  std::deque<std::vector<Run>> run_frames_;
};

}  // namespace horopter
