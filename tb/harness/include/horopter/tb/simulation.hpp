// SPDX-License-Identifier: Apache-2.0
// A Verilated model with one clock, the stream endpoints attached to it, and a watchdog.
#pragma once

#include <verilated.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace horopter::tb {

/// Something on the model's pins. In every clock all drive() come first (from what the last edge has left), then the
/// combinational paths settle, then all sample() see the handshakes of the coming edge.
class Endpoint {
 public:
  virtual ~Endpoint() = default;
  virtual void drive() = 0;
  virtual void sample() = 0;
  virtual void reset() {}
};

struct Timeout : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// `Model` is a Verilated class with the ports clk_i and rst_ni.
template <class Model>
class Simulation {
 public:
  /// `seed`: of the registers' values before reset. `limit`: clocks after which every wait fails.
  explicit Simulation(std::uint64_t seed, std::uint64_t limit = 100'000'000)
      : limit_{limit}, model_{prepare(context_, seed)} {
    model_.clk_i = 0;
    model_.rst_ni = 0;
  }
  ~Simulation() {
    Verilated::threadContextp(&context_);  // else that of the model made last, which may be gone
    model_.final();
  }
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  Model& model() { return model_; }
  std::uint64_t cycle() const { return cycle_; }
  void attach(Endpoint& endpoint) { endpoints_.push_back(&endpoint); }

  void tick() {
    if (++cycle_ > limit_) throw Timeout{"watchdog: " + std::to_string(limit_) + " clocks"};
    for (Endpoint* endpoint : endpoints_) endpoint->drive();
    model_.clk_i = 0;
    model_.eval();
    for (Endpoint* endpoint : endpoints_) endpoint->sample();
    model_.clk_i = 1;
    model_.eval();
  }
  void run(std::uint64_t clocks) {
    while (clocks-- > 0) tick();
  }
  /// Ticks until `done()`; fails with the name of what it waited for.
  template <class Done>
  void run_until(Done&& done, std::uint64_t clocks, const std::string& what) {
    for (std::uint64_t n = 0; !done(); ++n) {
      if (n == clocks) throw Timeout{"waited " + std::to_string(clocks) + " clocks for " + what};
      tick();
    }
  }
  /// Synchronous reset; endpoints forget what they were doing.
  void reset(unsigned clocks = 4) {
    for (Endpoint* endpoint : endpoints_) endpoint->reset();
    model_.rst_ni = 0;
    for (unsigned n = 0; n < clocks; ++n) {
      model_.clk_i = 0;
      model_.eval();
      model_.clk_i = 1;
      model_.eval();
      ++cycle_;
    }
    model_.rst_ni = 1;
  }

 private:
  static VerilatedContext* prepare(VerilatedContext& context, std::uint64_t seed) {
    context.randReset(2);
    context.randSeed(static_cast<int>(seed & 0x7fffffff));
    return &context;
  }
  std::uint64_t limit_, cycle_ = 0;
  VerilatedContext context_;
  Model model_;
  std::vector<Endpoint*> endpoints_;
};

}  // namespace horopter::tb
