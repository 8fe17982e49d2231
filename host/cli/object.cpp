// SPDX-License-Identifier: Apache-2.0
#include "object.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "horopter/base/error.hpp"
#include "horopter/plan/plan.hpp"
#include "horopter/skin/rig_skin.hpp"
#include "inputs.hpp"

namespace horopter::cli {
namespace {

constexpr double kLargest_px = 1000, kSmallest_mm = 5, kLargest_mm = 2000;

/// With the smallest windows that there are.
double smallest_of_all_px() {
  double smallest = kLargest_px;
  for (const MachineProfile& profile : profiles()) smallest = std::min(smallest, smallest_object_px(profile));
  return smallest;
}

void parse(const std::string& text, ObjectOption& option) {
  const bool in_mm = text.ends_with("mm");
  const std::string number = text.substr(0, text.size() - (in_mm || text.ends_with("px") ? 2 : 0));
  double value = 0;
  const bool is_number = CLI::detail::lexical_cast(number, value) && std::isfinite(value);
  const bool never = is_number && value == 0 && !in_mm;
  const double smallest_px = smallest_of_all_px();
  const double smallest = in_mm ? kSmallest_mm : smallest_px, largest = in_mm ? kLargest_mm : kLargest_px;
  if (!is_number || (!never && (value < smallest || value > largest))) {
    throw CLI::ValidationError(
        "--object", fmt::format("'{}'; expected {:g} to {:g} px, as in 100px, or {:g} to {:g} mm, as in 40mm, or 0",
                                text, smallest_px, kLargest_px, kSmallest_mm, kLargest_mm));
  }
  option.given = true;
  option.mm.reset();
  (in_mm ? option.mm.emplace() : option.px) = value;
}

/// Of a body of so many mm, where the skin is farthest away.
double farthest_px(double mm, const std::string& skin, const std::optional<calib::Rig>& rig,
                   const MachineProfile& profile, int image_width, int image_height) {
  SkinFile file;
  if (!is_table(skin) && !is_moving_skin(skin)) file = load_skin_for(skin, rig, image_width, image_height);
  const auto* in_space = dynamic_cast<const RigSkin*>(file.skin.get());
  if (in_space == nullptr) {
    throw UsageError(
        "--object in mm needs a surface that does not move, and cameras: a skin.yaml of the rig's world, and --rig; in px it "
        "needs neither");
  }
  const ScanGeometry geometry = scans_of(profile, image_width, image_height).front();
  double object_px = 0;
  try {
    constexpr double kAny_px = 1;  // only the distance is asked for
    const ThicknessPlan plan = plan_thickness(in_space->cameras(), *in_space->surface(), profile, geometry, kAny_px);
    if (plan.supervised == 0) throw UsageError("--object in mm: nothing of the skin is supervised");
    const calib::CameraModel& left = in_space->cameras().left().model;
    object_px = std::min(left.fx_px(), left.fy_px()) * mm / plan.distance.largest;
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("--object: {}", error.what()));
  }
  const double smallest_px = smallest_object_px(profile);
  if (!(object_px >= smallest_px)) {
    throw UsageError(
        fmt::format("{:g} mm are {:.1f} px where the skin is farthest away; the smallest that windows and "
                    "majority leave anything certain of is {:g} px, {:.0f} mm here",
                    mm, object_px, smallest_px, std::ceil(mm * smallest_px / object_px)));
  }
  return object_px;
}

}  // namespace

void add_object(CLI::App& command, ObjectOption& option) {
  command
      .add_option_function<std::string>(
          "--object", [&option](const std::string& text) { parse(text, option); },
          "Alarm for an object on the skin this large across, at once: px of the left image, or mm with a rig; 0: only "
          "--alarm-limit counts")
      ->type_name("SIZE")
      ->default_str(fmt::format("{:g}px", option.px));
}

void set_object(const ObjectOption& option, const std::string& skin, const std::optional<calib::Rig>& rig,
                const MachineProfile& profile, int image_width, int image_height, Settings& settings) {
  settings.object_px = option.px;
  if (option.mm) settings.object_px = farthest_px(*option.mm, skin, rig, profile, image_width, image_height);
  if (const double smallest_px = smallest_object_px(profile);
      settings.object_px != 0 && settings.object_px < smallest_px) {
    throw UsageError(
        fmt::format("an object of {:g} px: profile {} sees nothing certain of it, by its windows and majority; "
                    "the smallest is {:g} px",
                    settings.object_px, profile.name, smallest_px));
  }
  const int side_px = std::min(image_width, image_height);
  if (option.given && settings.object_px > side_px) {
    throw UsageError(
        fmt::format("an object of {:.0f} px across does not fit into an image of {}x{}: none would be an alarm",
                    settings.object_px, image_width, image_height));
  }
}

std::string object_text(const ObjectOption& option, const Settings& settings, const MachineProfile& profile) {
  if (settings.object_px <= 0) return "none is an alarm by itself";
  const std::string mm = option.mm ? fmt::format("{:g} mm, ", *option.mm) : "";
  return fmt::format("{}{:.0f} px across, {} pixels of the result", mm, settings.object_px,
                     object_limit(settings, profile));
}

}  // namespace horopter::cli
