// SPDX-License-Identifier: Apache-2.0
// A server of Modbus TCP: what is safe, why not, and how old that is. Nothing can be written.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "horopter/monitor/part.hpp"

namespace horopter::monitor {

/// Input registers from 0 on, 16 bits each; 32-bit values with the higher half first.
enum class InputRegister {
  version,              ///< of this list: 1
  heartbeat,            ///< one more with each decision
  safe,                 ///< 1 = safe
  not_safe,             ///< its complement; equal ones mean that nothing is known
  alarm,                ///< 1 = something is in the skin
  decision_age_ms,      ///< 65535 = that or older, or there was none
  camera_faults,        ///< two: FAULTS_CAMERAS of registers.yaml
  machine_faults = 8,   ///< two: FAULTS_MACHINE
  monitor_faults = 10,  ///< two: docs/monitor.md
  configuration = 12,   ///< two: the configuration's CRC
};
inline constexpr int kInputRegisters = 14;
/// Discrete inputs from 0 on: safe, not safe, alarm, and the heartbeat's lowest bit.
inline constexpr int kDiscreteInputs = 4;

std::array<std::uint16_t, kInputRegisters> input_registers(const Signal& signal, std::uint32_t configuration_crc);
std::array<std::uint8_t, kDiscreteInputs> discrete_inputs(const Signal& signal);

/// Throws FileError where it cannot listen; its port is then known (0 in cell.yaml: a free one, which it prints).
std::unique_ptr<Part> make_modbus(const ModbusCell& modbus, const Cell& cell, const SafeState& state);

}  // namespace horopter::monitor
