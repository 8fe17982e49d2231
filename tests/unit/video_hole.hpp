// SPDX-License-Identifier: Apache-2.0
// A Matroska video of JPEG images, as a recorder leaves it that lost some.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>

namespace horopter {

/// Where the JPEG image of this number begins in the bytes of a file. Throws std::out_of_range.
template <typename Bytes>
auto jpeg_at(Bytes& bytes, int number) {
  constexpr std::array<std::uint8_t, 3> kBegin{0xFF, 0xD8, 0xFF};
  const auto same = [](auto a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; };
  auto at = std::search(bytes.begin(), bytes.end(), kBegin.begin(), kBegin.end(), same);
  for (int i = 0; i < number && at != bytes.end(); ++i) {
    at = std::search(at + 1, bytes.end(), kBegin.begin(), kBegin.end(), same);
  }
  if (at == bytes.end()) throw std::out_of_range("no such JPEG image");
  return at;
}

/// Images from `first` up to, and without, `end` come later. A block's time, in 16 bits, stands before a byte of flags and
/// its image.
template <typename Bytes>
void delay_images(Bytes& bytes, int first, int end, int by_ms) {
  for (int i = first; i < end; ++i) {
    const auto flags = jpeg_at(bytes, i) - 1;
    const int time_ms = (static_cast<std::uint8_t>(flags[-2]) << 8 | static_cast<std::uint8_t>(flags[-1])) + by_ms;
    flags[-2] = static_cast<typename Bytes::value_type>(time_ms >> 8);
    flags[-1] = static_cast<typename Bytes::value_type>(time_ms & 0xFF);
  }
}

}  // namespace horopter
