// SPDX-License-Identifier: Apache-2.0
// The parts of a cell: what cell.yaml names beside cameras and machine. Whoever writes another part adds it here.
#include "horopter/monitor/part.hpp"
#include "output/gpio.hpp"
#include "output/lines.hpp"
#include "output/log_and_page.hpp"
#include "output/modbus.hpp"
#include "output/mqtt.hpp"

namespace horopter::monitor {

void set_outputs_not_safe(const Cell& cell) {
  if (cell.outputs.gpio) set_gpio_not_safe(*cell.outputs.gpio, cell);
}

std::vector<std::unique_ptr<Part>> make_parts(const Cell& cell, const SafeState& state, Control& control, Lines lines) {
  std::vector<std::unique_ptr<Part>> parts;
  parts.push_back(make_lines(cell, lines));
  if (cell.outputs.modbus) parts.push_back(make_modbus(*cell.outputs.modbus, cell, state));
  if (cell.outputs.mqtt) parts.push_back(make_mqtt(*cell.outputs.mqtt, cell, state, control));
  if (cell.outputs.gpio) parts.push_back(make_gpio(*cell.outputs.gpio, cell, state));
  if (cell.log || cell.web) parts.push_back(make_log_and_page(cell, control));
  return parts;
}

}  // namespace horopter::monitor
