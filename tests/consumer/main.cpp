// SPDX-License-Identifier: Apache-2.0
// Supervises a synthetic pair with the installed library: a textured plane on the skin must alarm.
#include <cstdio>
#include <horopter/machine/monitor.hpp>
#include <horopter/machine/native_device.hpp>
#include <horopter/machine/report.hpp>
#include <horopter/map/map_compiler.hpp>

int main() {
  const auto& profile = horopter::find_profile("vga");
  horopter::SkinFile skin;
  skin.skin = std::make_unique<horopter::HomographySkin>(horopter::Matrix3{1, 0, 0, 0, 1, 0, 0, 0, 1});
  const auto maps = horopter::compile_maps(skin, profile, 160, 120);
  horopter::Supervisor supervisor(horopter::make_native_device(profile), profile, maps);
  horopter::Image image(160, 120);
  unsigned random = 1;
  for (auto& pixel : image.pixels) pixel = static_cast<std::uint8_t>((random = random * 1664525U + 1013904223U) >> 24);
  const auto results = supervisor.process(image, image);
  std::printf("skin %lld pixels, %zu regions\n", static_cast<long long>(results[0].skin_pixels),
              horopter::regions_of(results[0].states).size());
  return results[0].alarm ? 0 : 1;
}
