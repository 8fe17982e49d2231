// SPDX-License-Identifier: Apache-2.0
// Places every node of a graph in a pipeline stage; initiation interval 1.
//
// Stage 0 works combinationally on the input ports (assumed to come from registers unless input_ns says when they
// come); outputs leave the registers behind stage latency-1. With output_ns they may be logic of a further stage,
// `latency`, with no registers behind it. A beat is in stage k exactly k enabled clocks after it entered; state
// behind a stage loads only when a valid beat is in it. So a state that is read and written in stage k holds its `next`
// of beat n while beat n is in stage k+1, and doubles as the pipeline register of that value.
//
// Memories. Beat n enters at clock t(n), t(n+1) >= t(n)+1, gaps allowed. With read stage k and write stage w, step n
// reads at the end of clock t(n)+k and writes at the end of t(n)+w. Steps of one address are n = m, or at least
// DISTANCE apart. A read must come strictly after the writes of earlier steps: for n >= m+DISTANCE,
// t(n)+k >= t(m)+DISTANCE+k > t(m)+w  if  w < k+DISTANCE; and strictly before the writes of its own and later steps:
// t(n)+k < t(m)+w for m >= n  if  k < w. Gaps only enlarge t(n)-t(m). Hence the proof obligation k < w < k+DISTANCE.
#pragma once

#include <string>
#include <vector>

#include "hlsc/delay.hpp"
#include "hlsc/diagnostics.hpp"
#include "hlsc/graph.hpp"

namespace hlsc {

/// A stage that does not fit the clock, the memories or the emitted language.
class ScheduleError : public CompileError {
 public:
  using CompileError::CompileError;
};

struct ScheduleOptions {
  DelayModel delays = make_delay_model(Target::kIce40Hx);
  double clock_ns = 8.0;
  double input_ns = 0;   ///< when inputs come, after the clock; below the launch of a register: from registers
  double output_ns = 0;  ///< outputs may be logic that ends by then, in stage `latency`; 0: outputs are registers
  /// A recurrence cannot be cut, and place and route favours it: it may use part of the margin that clock_ns leaves.
  double recurrence_overrun = 1.12;
  bool allow_slow = false;  ///< warn instead of refusing when a recurrence or a single operation misses the clock
  bool minimise_registers = true;  ///< false: as soon as possible
};

inline constexpr int kEveryStage = -1;  ///< depends on configuration and constants only: no pipeline registers
inline constexpr int kDead = -2;        ///< no output depends on it

struct Schedule {
  ScheduleOptions options;
  int latency = 0;                 ///< enabled clocks from input to output, >= 1 if outputs are registers
  std::vector<int> stage;          ///< of each node; of a state read: the state's stage; of a memory read: the data's
  std::vector<double> arrival_ns;  ///< of each node's result, in its stage
  std::vector<bool> synchronous_rom;   ///< of each kRom node: address in stage-1, data from a block RAM in stage
  std::vector<int> ram_read_stage;     ///< of each RAM: stage of the address (data one later), kDead: not emitted
  std::vector<int> ram_write_stage;    ///< of each RAM; kDead: never written
  std::vector<double> stage_delay_ns;  ///< longest path in each stage, launch and set-up included
  std::vector<std::string> warnings;
};

inline bool registered_outputs(const ScheduleOptions& options) { return options.output_ns <= 0; }

/// Throws ScheduleError. The result has been checked by verify_schedule.
Schedule schedule(const Graph& graph, const ScheduleOptions& options);

/// What is wrong with a schedule, empty if nothing; shares no code with the scheduler.
std::vector<std::string> verify_schedule(const Graph& graph, const Schedule& schedule);

/// Replaces what the target has no fast operation for: multiplications become adder trees. Same behaviour.
Graph lower_for_target(const Graph& graph, const ScheduleOptions& options);

namespace detail {

/// s[to] - s[from] >= difference.
struct DifferenceConstraint {
  std::uint32_t from = 0, to = 0;
  int difference = 0;
};

/// Minimises sum of weight[i]*s[i] over integer s subject to the constraints, exactly. `s` must be the least feasible
/// solution; pinned variables keep their value. The objective must be bounded from below.
void minimise_linear(const std::vector<DifferenceConstraint>& constraints, const std::vector<long>& weight,
                     const std::vector<bool>& pinned, std::vector<int>& s);

}  // namespace detail
}  // namespace hlsc
