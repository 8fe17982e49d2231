// SPDX-License-Identifier: Apache-2.0
// Supervision with a moving skin: every frame by its own table.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "horopter/machine/monitor.hpp"
#include "horopter/map/moving_maps.hpp"

namespace horopter {

/// A monitor for a skin that moves with every frame. While a frame is in the machine, the next one's table is uploaded
/// beside its own, and selected.
class MovingSupervisor {
 public:
  MovingSupervisor(std::unique_ptr<Device> device, const MachineProfile& profile, MovingMaps maps,
                   const Settings& settings = {});

  /// The result of an image pair, or two for profiles that take fields. Clear is earned by the frame before: the first
  /// one is given to the machine twice.
  std::vector<FrameResult> process(const Image& left, const Image& right);

  /// The two halves of it, for one frame or field: hardware takes a frame while the one before is not finished. Returns
  /// when the frame's table is in use and the next one's is there.
  void begin(const Image& left, const Image& right);
  /// Throws DeviceError when the frame was made by another table than its own.
  FrameResult finish();

  Monitor& monitor() { return monitor_; }
  const MovingMaps& maps() const { return maps_; }

 private:
  std::vector<FrameResult> pass(const Image& left, const Image& right);

  struct Started {
    std::size_t step;
    int slot;
  };

  MovingMaps maps_;
  Monitor monitor_;
  bool settled_;
  std::size_t frame_ = 0;
  std::size_t loaded_[2] = {0, SIZE_MAX};  ///< step in the two slots
  std::deque<Started> started_;
};

}  // namespace horopter
