// SPDX-License-Identifier: Apache-2.0
// What a cell has beside cameras and machine: outputs, log, page. parts.cpp makes them.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "horopter/monitor/cell.hpp"
#include "horopter/monitor/safe_state.hpp"
#include "horopter/monitor/state.hpp"

namespace horopter::monitor {

/// While it is not safe causes may come and go with every image: at most so often they are told.
inline constexpr auto kBetweenCauses = std::chrono::seconds(1);

class Part : public Listener {
 public:
  /// What is wrong with it, for the fault `output`; empty while all is well. Asked with every decision: must not wait.
  [[nodiscard]] virtual std::string trouble() const { return {}; }
};

/// Where events are printed.
enum class Lines { text, json };

/// What others may have left safe. Before the machine is made, which may take long. Throws FileError.
void set_outputs_not_safe(const Cell& cell);

/// All that cell.yaml names, and the lines on standard output. They must go before the service that they were made for.
std::vector<std::unique_ptr<Part>> make_parts(const Cell& cell, const SafeState& state, Control& control, Lines lines);

}  // namespace horopter::monitor
