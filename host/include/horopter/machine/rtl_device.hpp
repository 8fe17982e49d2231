// SPDX-License-Identifier: Apache-2.0
// The co-simulated hardware: horopter_top in Verilator behind the Device interface. Library horopter::rtl_device; not
// part of the installed package.
#pragma once

#include <memory>

#include "horopter/base/profile.hpp"
#include "horopter/machine/device.hpp"

namespace horopter {

/// Throws UsageError for a profile of which this build has no model.
std::unique_ptr<Device> make_rtl_device(const MachineProfile& profile);

/// A device of the co-simulation, with what only a simulation can tell and do.
class RtlDevice : public Device {
 public:
  /// Clocks since construction.
  virtual std::uint64_t clocks() const = 0;
  /// Lets clocks pass without access.
  virtual void run(std::uint64_t clocks) = 0;
  /// Share of the clocks in which the cameras offer no pixel although they could, and in which the outputs are not
  /// taken, %: reproducible noise on the handshakes.
  virtual void set_pauses(unsigned camera_percent, unsigned output_percent, std::uint64_t seed) = 0;
  virtual bool safe_pin() const = 0;
  virtual bool unsafe_pin() const = 0;
};

}  // namespace horopter
