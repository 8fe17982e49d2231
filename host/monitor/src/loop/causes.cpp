// SPDX-License-Identifier: Apache-2.0
#include "horopter/monitor/causes.hpp"

#include <algorithm>
#include <array>

#include "horopter/machine/inspection.hpp"

namespace horopter::monitor {
namespace {

/// `{camera}` stands for left or right, and the name is then that of both, without left_ and right_.
struct Row {
  std::string_view name;
  bool of_camera;
  std::string_view text;  ///< empty: as registers.yaml says it
  std::string_view advice;
};

constexpr std::string_view kLink =
    "Look at the {camera} camera's cable, its power and its network port, and whether something else loads the line.";
constexpr std::string_view kLens = "Look at the {camera} camera's lens, its cover and the light in the cell.";
constexpr std::string_view kTable = "Load the table again; if it comes back, make a new one from the skin.";
constexpr std::string_view kService = "Switch the machine off and on; if it comes back, call the service.";
constexpr std::string_view kOneCamera =
    "Look whether each input is connected to its own camera, and none of them shows the picture of the other.";
constexpr std::string_view kClocks =
    "Look at what sets the {camera} camera's clock, and whether the camera has started anew.";
constexpr std::string_view kLoad =
    "Give the computer less to do, or ask for fewer images a second; it must keep up with the cameras.";

constexpr auto kRows = std::to_array<Row>({
    // Of the machine's cameras.
    {"short_line", true, "", kLink},
    {"long_line", true, "", kLink},
    {"missing_line", true, "", kLink},
    {"missing_start", true, "", kLink},
    {"silent", true, "", kLink},
    {"overflow", true, "", kLoad},
    {"black", true, "", kLens},
    {"white", true, "", kLens},
    {"constant", true, "", kLens},
    {"frozen", true, "",
     "Start the {camera} camera anew; where the scene may stand still, say so in cell.yaml (limits: still_scene)."},
    {"parity", true, "", kService},
    {"blind", true, "", kLens},
    {"unsharp", true, "", "Clean and focus the {camera} camera's lens, and look for fog, drops or tape before it."},
    {"torn", true, "The rows of the {camera} image do not belong together.",
     "Let the {camera} camera take whole images (progressive, not interlaced), and look at what may mix two images: link, "
     "buffers, converter."},
    // Of the machine.
    {"skew", false, "The two cameras did not take their images at the same time.",
     "Look at the trigger of both cameras; `largest_skew_ms` in cell.yaml is how far they may be apart."},
    {"store_miss", false, "",
     "Make the table anew with `horopter map` for this machine; the skin may be too far off the rows."},
    {"no_table", false, "", kTable},
    {"map_crc", false, "", kTable},
    {"map_busy", false, "", "Load tables only where the machine does not use them."},
    {"too_undecidable", false, "",
     "Look at light and lenses, and whether everything stands before the skin; give plain things texture, or teach what "
     "cannot be decided."},
    {"too_unsupervised", false, "", "Look whether skin, rig and images belong together; make the table anew."},
    {"late", false, "", "Look whether both cameras run."},
    {"internal", false, "", kService},
    {"identical_images", false, "", kOneCamera},
    {"one_camera", false, "", kOneCamera},
    {"disagree", false, "",
     "Look for covers before a lens, exchanged cables and cameras that were turned; then calibrate anew."},
    {"unproven", false, "Too little has been compared in both images to know that no camera was moved.",
     "Wait for some images. If it stays, give what stands in view more texture."},
    {"moved", false, "", "Look whether a camera was knocked or its lens turned; fix it, and calibrate anew."},
    {"out_of_step", false,
     "The cameras do not show the same moment: something began or stopped to move in one of them alone.",
     "Look whether both cameras are triggered together, and whether one of them was turned. It ends when something begins to move that both "
     "cameras see."},
    {"overlooked", false, "Something large seems to be on the skin, and the pictures are too poor to show what.",
     "Look whether something is on the skin. Clean both lenses, and look at focus and compression of both cameras."},
    {"hidden", false, "For long, something nearer to the cameras has stood before too much of the skin.",
     "Take away what stands between the cameras and the skin."},
    {"settings", false, "", kService},
    {"restart", false, "", "Look whether the restart button is stuck, or its wire broken."},
    {"objects", false, "", "Clear the zone; it is too full to tell one thing from another."},
    {"contactors", false, "", "Look at the contactors and the wire of their mirror contacts."},
    {"teaching", false, "It is being taught: it learns what cannot be decided, and does not watch.",
     "Keep the zone empty until the teaching has ended."},
    // Of the monitor.
    {"alarm", false, "Something is in the skin.", "Clear the zone, look that nobody is inside, then restart."},
    {"camera_lost", true, "No image comes from the {camera} camera.", kLink},
    {"gap", true, "Images of the {camera} camera are missing.", kLink},
    {"repeated", true, "The {camera} camera gave the same image twice.", "Start the {camera} camera anew."},
    {"time_back", true, "The {camera} camera's time or its count of images went backwards.", kClocks},
    {"time_jump", true, "The {camera} camera's time jumped.", kClocks},
    {"size", true, "The {camera} camera's images have another size.",
     "Set the {camera} camera to the size for which the rig was calibrated."},
    {"exposure", true, "The {camera} camera's exposure has changed, or cannot be read any more.",
     "Switch off the {camera} camera's automatic exposure, or allow it in cell.yaml (exposure_may_change)."},
    {"lost_packets", true, "Parts of the {camera} camera's images were lost on the way.", kLink},
    {"unpaired", true, "The {camera} camera gave an image to which the other camera gave none.",
     "Look at the trigger of both cameras, and whether both run at the rate that cell.yaml says."},
    {"dropped", true, "An image of the {camera} camera came and was not judged.", kLoad},
    {"wrong_camera", true, "The {camera} camera is another one than cell.yaml names, or than it was at first.",
     "Connect the camera with that serial number; or calibrate the new one, write its number, and start the monitor again."},
    {"numbers", false, "The cameras' counts of images no longer run side by side: one is late by whole images.",
     "Start the cameras and the monitor anew."},
    {"swapped", false, "The left and the right camera are exchanged.",
     "Exchange their cables, or their names in cell.yaml."},
    {"decision_late", false,
     "The last decision, or an image of it, is older than its time limit, or this computer has slept.",
     "Give the computer less to do, or ask for fewer images a second; look whether images are held back on their way."},
    {"engine", false, "The machine that judges the images has failed.", kService},
    {"output", false, "An output or a part of the monitor has failed.",
     "Look at the line, the broker or the disk that the message names."},
    {"starting", false, "The monitor has just started, and has not judged an image yet.", "Wait for the cameras."},
    {"ending", false, "The monitor ends: nobody watches any more.", "Start the monitor again."},
});

std::string filled(std::string_view text, std::string_view camera) {
  constexpr std::string_view kMark = "{camera}";
  std::string result(text);
  for (std::size_t at = 0; (at = result.find(kMark, at)) != std::string::npos;)
    result.replace(at, kMark.size(), camera);
  return result;
}

}  // namespace

Cause cause_of(std::string_view name) {
  std::string_view camera;
  std::string_view rest = name;
  for (const std::string_view side : {"left", "right"}) {
    if (name.starts_with(side) && name.substr(side.size()).starts_with('_')) {
      camera = side;
      rest = name.substr(side.size() + 1);
    }
  }
  const auto row = std::ranges::find_if(
      kRows, [&](const Row& r) { return r.of_camera == !camera.empty() && r.name == (r.of_camera ? rest : name); });
  if (row == kRows.end()) return {std::string(name), std::string(name), ""};
  const std::string text = row->text.empty() ? fault_text(name) : filled(row->text, camera);
  return {std::string(name), text, filled(row->advice, camera)};
}

std::vector<Cause> causes_of(bool alarm, MonitorFaults own, const Faults& faults) {
  std::vector<Cause> causes;
  if (alarm) causes.push_back(cause_of("alarm"));
  for (const std::string_view name : own.names()) causes.push_back(cause_of(name));
  for (const std::string& name : faults.names()) {
    const bool known = std::ranges::any_of(causes, [&](const Cause& cause) { return cause.name == name; });
    if (!known) causes.push_back(cause_of(name));  // `skew` is a fault of both
  }
  return causes;
}

}  // namespace horopter::monitor
