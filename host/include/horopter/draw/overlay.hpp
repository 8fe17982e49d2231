// SPDX-License-Identifier: Apache-2.0
// What the machine found, drawn over the left image.
#pragma once

#include "horopter/draw/picture.hpp"
#include "horopter/image/image.hpp"
#include "horopter/machine/monitor.hpp"

namespace horopter {

/// The left image (field) at the result's size with the states of its pixels: skin red, blind orange, undecidable dimmed
/// towards blue, unsupervised hatched.
Picture draw_states(const Image& left, const FrameResult& result);

/// The left image (field) with the skin coloured and its larger regions boxed, objects that are an alarm in red, with
/// number and size; undecidable pixels dimmed towards blue, unsupervised ones hatched; a bar says alarm, fault or safe.
/// At least 600 pixels wide.
Picture draw_overlay(const Image& left, const FrameResult& result);

}  // namespace horopter
