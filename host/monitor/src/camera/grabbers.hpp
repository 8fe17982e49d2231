// SPDX-License-Identifier: Apache-2.0
// Sources of images, one function each. `place` is what stands behind the scheme.
#pragma once

#include <memory>
#include <string>

#include "horopter/monitor/camera.hpp"

namespace horopter::monitor {

std::unique_ptr<Grabber> open_files(const std::string& place, const CameraSettings& settings);
std::unique_ptr<Grabber> open_gst(const std::string& place, const CameraSettings& settings);
std::unique_ptr<Grabber> open_v4l2(const std::string& place, const CameraSettings& settings);
std::unique_ptr<Grabber> open_gev(const std::string& place, const CameraSettings& settings);

/// What v4l2: asks GStreamer for.
std::string v4l2_pipeline(const std::string& device, double frames_per_s);

}  // namespace horopter::monitor
