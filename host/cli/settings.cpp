// SPDX-License-Identifier: Apache-2.0
#include "settings.hpp"

#include <fmt/format.h>

#include "horopter/base/error.hpp"
#include "horopter/machine/engines.hpp"
#include "numbers.hpp"

namespace horopter::cli {

CLI::Option* add_engine(CLI::App& command, std::string& engine) {
  const auto check = [](const std::string& name) {
    try {
      check_engine(name);
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  return command.add_option("--engine", engine, engine_help())->check(check, "")->type_name("ENGINE");
}

std::unique_ptr<Device> make_picture_device(const std::string& engine, const MachineProfile& profile) {
  auto device = make_device(engine, profile);
  if (device->takes_pictures()) return device;
  throw UsageError(
      fmt::format("--engine {}: this machine takes no pictures and gives none back: it has cameras of its own, or its "
                  "streams are not named; expected native, rtl, or uio:REGISTERS,LEFT,RIGHT,STATES,RUNS. `horopter "
                  "status` shows what a board sees",
                  engine));
}

CLI::Option* add_pair_by_order(CLI::App& command, bool& by_order) {
  return command.add_flag("--pair-by-order", by_order,
                          "Pair the images in their order, even where the numbers in their names differ");
}

CLI::Option* add_less_light(CLI::App& command, BlindSettings& blind) {
  return command.add_flag_callback(
      "--less-light", [&blind] { blind.dim = true; },
      "Learn for less light, too: every second image is looked at as half of the light would show it. Less light then "
      "raises fewer false alarms, but fewer plain bodies are found (`study walk --less-light`)");
}

void add_settings(CLI::App& command, Settings& settings) {
  command
      .add_option("--threshold", settings.threshold_percent,
                  "thesis: in the skin up to this share of the largest sum of direction differences, %; below 0.1 "
                  "nothing but a perfect copy is in the skin")
      ->check(within(0.1, 100, "%"))
      ->type_name("%")
      ->capture_default_str();
  command
      .add_option(
          "--texture", settings.texture,
          "thesis: smallest mean gradient that decides, in units of the Sobel magnitude (8 = 1 grey level per pixel)")
      ->check(within(0, 255, "units"))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--alarm-limit", settings.alarm_percent,
                  "Alarm above this share of pixels in the skin, % of the whole image")
      ->check(within(0, 100, "%"))
      ->type_name("%")
      ->capture_default_str();
  command
      .add_option(
          "--undecidable-limit", settings.undecidable_percent,
          "Fault above this share of pixels without enough texture, % of those that the rule can judge, see `horopter "
          "map`; or above 19/16 of it with those that something hides or that both cameras are not shown to see")
      ->check(within(0, 100, "%"))
      ->type_name("%")
      ->capture_default_str();
  command
      .add_option("--unsupervised-limit", settings.unsupervised_percent,
                  "Fault above this share of unsupervised pixels, % of the whole image")
      ->check(within(0, 100, "%"))
      ->type_name("%")
      ->capture_default_str();
  command
      .add_option("--frozen-limit", settings.frozen_limit, "Fault when an image is repeated this many times, 0 = never")
      ->check(within(0, 255, "images"))
      ->type_name("N")
      ->capture_default_str();
  command.add_flag_callback(
      "--unproven", [&settings] { settings.proof.needed = false; },
      "Do not ask that both cameras are shown to see the same world: a covered, wrong or moved camera then reads clear. "
      "For images that are no scene");
  command
      .add_option(
          "--hidden-frames", settings.proof.hidden_frames,
          "Fault when something has stood between cameras and skin for this many frames; with 0 only where most of "
          "another table's skin is hidden in its first frame")
      ->check(within(0, 128, "frames"))
      ->type_name("N")
      ->capture_default_str();
  command.add_flag_callback(
      "--still-scene", [&settings] { settings.still_limit = 0; },
      "The scene may stand still: frames that repeat but for noise are no fault (those that repeat exactly are)");
}

}  // namespace horopter::cli
