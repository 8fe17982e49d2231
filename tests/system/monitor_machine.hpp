// SPDX-License-Identifier: Apache-2.0
// The machine of a monitor that gets its images from a test.
#pragma once

#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "horopter/machine/native_device.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/monitor/service.hpp"
#include "horopter/skin/skin.hpp"

namespace horopter::test {

/// With the skin of a file, and no rig.
inline monitor::Machine machine_of(const monitor::Cell& cell, const std::filesystem::path& skin_file, int width,
                                   int height, std::unique_ptr<Device> device) {
  const auto& profile = find_profile("vga");
  const auto skin = load_skin(skin_file, {(width - 1) / 2.0, (height - 1) / 2.0}, nullptr);
  const auto maps = std::make_shared<const MapSet>(compile_maps(skin, profile, width, height));
  monitor::Machine made;
  made.maps = maps;
  made.objects =
      std::make_unique<ObjectFollower>(profile, std::vector<const MapTable*>{&maps->maps.at(0).table}, maps->rig);
  made.largest_skew_ms = 1;
  made.supervisor = std::make_unique<Supervisor>(std::move(device), profile, *maps, cell.settings);
  return made;
}
inline monitor::Machine machine_of(const monitor::Cell& cell, const std::filesystem::path& skin_file, int width,
                                   int height) {
  return machine_of(cell, skin_file, width, height, make_live_native_device(find_profile("vga")));
}

}  // namespace horopter::test
