// SPDX-License-Identifier: Apache-2.0
// What the machine found, drawn over the left image.
#pragma once

#include <vector>

#include "horopter/draw/picture.hpp"
#include "horopter/image/image.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/machine/object_tracker.hpp"

namespace horopter {

/// The left image (field) at the result's size with the states of its pixels: skin red, blind orange, undecidable dimmed
/// towards blue, unsupervised hatched.
Picture draw_states(const Image& left, const FrameResult& result);

/// The left image (field) with the skin coloured and its larger regions boxed; undecidable pixels dimmed towards blue,
/// unsupervised ones hatched; a bar says alarm, fault or safe. At least 600 pixels wide. Objects that are an alarm are
/// boxed in red, with number and size, and an arrow to where they will be in 5 frames: `objects`, of this frame, by id and
/// in mm where that is known; those that are not among them by their order and in px.
Picture draw_overlay(const Image& left, const FrameResult& result, const std::vector<TrackedObject>& objects = {});

}  // namespace horopter
