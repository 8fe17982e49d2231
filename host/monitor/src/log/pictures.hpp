// SPDX-License-Identifier: Apache-2.0
// The pictures of a moment as files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "horopter/monitor/state.hpp"

namespace horopter::monitor {

struct PictureFile {
  std::string name;
  std::vector<std::uint8_t> bytes;
};

/// Both images without loss, that the decision can be made again; the overlay as JPEG.
std::vector<PictureFile> encode_moment(const Moment& moment);
/// What a moment takes of memory.
std::size_t bytes_of(const Moment& moment);

}  // namespace horopter::monitor
