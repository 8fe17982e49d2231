// SPDX-License-Identifier: Apache-2.0
// Objects in the skin, followed from frame to frame: the same one has the same number.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "horopter/image/image.hpp"
#include "horopter/machine/report.hpp"
#include "horopter/monitor/state.hpp"

namespace horopter::monitor {

/// What a rig tells of a place in the result.
struct ObjectScale {
  /// Distance along the left camera's axis at a pixel of the result, mm; empty without a rig.
  std::function<std::optional<double>(double x, double y)> distance_mm;
  double f_px = 0;  ///< of the left camera, in pixels of the result
};

class ObjectTracker {
 public:
  /// Those of a result that are at least as large as an object, `at` a time.
  std::vector<ObjectState> next(const FrameResult& result, const ObjectScale& scale, Clock::time_point at);

 private:
  struct Known {
    ObjectState object;
    double x = 0, y = 0;  ///< centroid
    std::optional<double> distance_mm;
  };
  std::vector<Known> known_;
  Clock::time_point at_{};
  int next_id_ = 1;
};

}  // namespace horopter::monitor
