// SPDX-License-Identifier: Apache-2.0
// What the machine found, drawn over the left image.
#pragma once

#include <cstdint>
#include <vector>

#include "horopter/image/image.hpp"
#include "horopter/machine/monitor.hpp"

namespace horopter {

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bgr;
};

/// The left image (field) with the skin coloured and its larger regions boxed; undecidable pixels dimmed towards blue,
/// unsupervised ones hatched; a bar says alarm, fault or safe. At least 600 pixels wide.
Picture draw_overlay(const Image& left, const FrameResult& result);

}  // namespace horopter
