// SPDX-License-Identifier: Apache-2.0
// A stage class behind an interface of plain numbers, so that benches are compiled once and not for every stage.
#pragma once

#include <cstdint>
#include <vector>

#include "horopter/hls/ram.hpp"
#include "horopter/tb/leaves.hpp"

namespace horopter::tb {

/// The leaves of an In, Out or Config that have ports, in port order, as the bits on their ports.
using Beat = std::vector<std::uint64_t>;

class NativeStage {
 public:
  virtual ~NativeStage() = default;
  /// False: this beat gives no output (a leaf `valid` of Out is false).
  virtual bool step(const Beat& in, const Beat& config, Beat& out) = 0;
  /// As rst_ni: registers to their initial values, memories kept.
  virtual void reset() = 0;
  /// Becomes a copy of a stage of the same class.
  virtual void assign(const NativeStage& other) = 0;

  std::vector<Leaf> in_leaves, config_leaves, out_leaves;
};

template <class Stage>
class NativeStageOf final : public NativeStage {
  static constexpr bool kHasConfig = requires { typename Stage::Config; };

 public:
  NativeStageOf() {
    in_leaves = leaves_of<typename Stage::In>();
    out_leaves = leaves_of<typename Stage::Out>();
    if constexpr (kHasConfig) config_leaves = leaves_of<typename Stage::Config>();
  }
  bool step(const Beat& in, [[maybe_unused]] const Beat& config, Beat& out) override {
    typename Stage::In typed_in{};
    set_leaves(&typed_in, in_leaves, in);
    typename Stage::Out typed_out{};
    if constexpr (kHasConfig) {
      typename Stage::Config typed_config{};
      set_leaves(&typed_config, config_leaves, config);
      typed_out = stage_.step(typed_in, typed_config);
    } else {
      typed_out = stage_.step(typed_in);
    }
    get_leaves(&typed_out, out_leaves, out);
    if constexpr (requires { typed_out.valid; }) return typed_out.valid;
    return true;
  }
  void reset() override { hls::reset(stage_); }
  void assign(const NativeStage& other) override { stage_ = static_cast<const NativeStageOf&>(other).stage_; }

 private:
  Stage stage_{};
};

}  // namespace horopter::tb
