// SPDX-License-Identifier: Apache-2.0
// Results for programs: state pictures, summary.json.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "horopter/image/image.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/machine/object_tracker.hpp"
#include "horopter/machine/regions.hpp"

namespace horopter {

/// Grey levels of the written state pictures: 0 clear, 255 skin, 128 undecidable, 64 unsupervised.
Image state_picture(const Image& states);

/// One element of `objects` of a frame in summary.json. What is not known is left out.
nlohmann::ordered_json object_json(const TrackedObject& object);
/// One element of `frames` in summary.json, with the objects that ObjectFollower says. `cycles` only if the engine counts
/// them.
nlohmann::ordered_json frame_json(int frame, const std::string& left, const std::string& right,
                                  const FrameResult& result, const std::vector<TrackedObject>& objects,
                                  bool with_cycles);
nlohmann::ordered_json summary_json(std::string_view engine, std::string_view profile);

}  // namespace horopter
