// SPDX-License-Identifier: Apache-2.0
// What the machine found, drawn over the left image.
#pragma once

#include "horopter/draw/picture.hpp"
#include "horopter/image/image.hpp"
#include "horopter/machine/monitor.hpp"

namespace horopter {

/// The left image (field) with the skin coloured and its larger regions boxed, objects that are an alarm in red, with
/// number and size; undecidable pixels dimmed towards blue, unsupervised ones hatched; a bar says alarm, fault or safe.
/// At least 600 pixels wide.
Picture draw_overlay(const Image& left, const FrameResult& result);

}  // namespace horopter
