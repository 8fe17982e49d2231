// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/blind_watch.hpp"

#include <algorithm>

#include "horopter/machine/device.hpp"

namespace horopter {

BlindWatch::BlindWatch(int width, int height, int side) : side_(side) {
  const int across = std::max(1, width / side);
  for (int y = 0; y < height; y += side) {
    for (int i = 0; i < across; ++i) {
      const int x = i * side;
      blocks_.push_back({x, y, (i + 1 == across ? width : x + side) - x, std::min(side, height - y), 0});
    }
  }
}

std::vector<std::uint8_t> BlindWatch::frame(const Image& states, const BlindSettings& settings, bool spoiled,
                                            bool spoils) {
  const bool forgets = spoiled || spoiled_before_ != 0;
  spoiled_before_ = (spoiled_before_ << 1U | static_cast<unsigned>(spoils)) & 3U;
  if (settings.teach && !teaching_) taught_ = 0;
  teaching_ = settings.teach;
  if (!settings.teach && !settings.watch) return {};
  std::vector<std::uint8_t> blind(settings.teach ? 0 : states.pixels.size());
  const int margin = settings.margin_pixels(side_);
  const int step = side_ * side_ / 64;  // in which the machine keeps it
  for (Block& block : blocks_) {
    const auto each_undecidable = [&](const auto& act) {
      for (int y = block.y; y < block.y + block.height; ++y) {
        for (int x = block.x; x < block.x + block.width; ++x) {
          if (static_cast<State>(states.at(x, y)) == State::undecidable) act(x, y);
        }
      }
    };
    int count = 0;
    each_undecidable([&](int, int) { ++count; });
    const int known = taught_ > 0 ? block.most_undecidable : 0;
    if (settings.teach) {
      block.most_undecidable = (std::max(known, count) + step - 1) / step * step;
    } else if (count > known + margin) {
      each_undecidable([&](int x, int y) {
        blind[static_cast<std::size_t>(y) * static_cast<std::size_t>(states.width) + static_cast<std::size_t>(x)] = 1;
      });
    }
  }
  if (settings.teach) taught_ = forgets ? 0 : taught_ + 1;
  return blind;
}

}  // namespace horopter
