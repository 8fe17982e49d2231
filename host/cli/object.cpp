// SPDX-License-Identifier: Apache-2.0
#include "object.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "horopter/base/error.hpp"
#include "horopter/map/map.hpp"
#include "horopter/map/skin_places.hpp"
#include "horopter/map/support.hpp"
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

/// Along the axis of symmetry, as plan_thickness says it, by a table alone: its rig is in it.
double farthest_mm_of_table(const std::string& skin, const MapSet& maps, const CameraPair& cameras) {
  constexpr int kStep_px = 8;
  const StereoAxis axis(cameras);
  double farthest_mm = 0;
  for (const CompiledMap& map : maps.maps) {
    const SkinPlaces places(map.table, cameras);
    const ScanGeometry& geometry = map.table.geometry();
    for (int y = 0; y < geometry.height; y += kStep_px) {
      for (int x = 0; x < geometry.width / map.table.facts().subsample; x += kStep_px) {
        if (const auto place = places.exactly_at(x, y)) {
          farthest_mm = std::max(farthest_mm, (place->at_mm - axis.middle_mm).dot(axis.direction));
        }
      }
    }
  }
  if (!(farthest_mm > 0))
    throw FileError(skin, "", "--object in mm: nothing of the skin is supervised", "a larger skin");
  return farthest_mm;
}

/// px across of a body of so many mm, where the skin is farthest away.
double px_where_farthest(double mm, const std::string& skin, const std::optional<calib::Rig>& rig,
                         const MachineProfile& profile, int image_width, int image_height) {
  const auto px = [&](const CameraPair& cameras, double distance_mm) {
    return std::min(cameras.left().model.fx_px(), cameras.left().model.fy_px()) * mm / distance_mm;
  };
  if (is_table(skin)) {
    const MapSet maps = load_maps(skin);
    if (maps.rig.empty()) {
      throw FileError(skin, "", "--object in mm: a table that was made without a rig knows no mm",
                      "one that was made with --rig, or --object in px");
    }
    const CameraPair cameras = first_pair(calib::rig_from_yaml(maps.rig, skin), skin);
    return px(cameras, farthest_mm_of_table(skin, maps, cameras));
  }
  SkinFile file;
  if (!is_moving_skin(skin)) file = load_skin_for(skin, rig, image_width, image_height);
  const auto* in_space = dynamic_cast<const RigSkin*>(file.skin.get());
  if (in_space == nullptr) {
    throw FileError(skin, "",
                    file.skin ? fmt::format("--object in mm: a {} knows no mm", file.skin->type())
                              : std::string("--object in mm: this skin moves, and its distance changes"),
                    "a surface in the rig's world that does not move, or --object in px");
  }
  const ScanGeometry geometry = scans_of(profile, image_width, image_height).front();
  try {
    constexpr double kAny_px = 1;  // only the distance is asked for
    const ThicknessPlan plan = plan_thickness(in_space->cameras(), *in_space->surface(), profile, geometry, kAny_px);
    if (plan.supervised == 0) throw UsageError("--object in mm: nothing of the skin is supervised");
    return px(in_space->cameras(), plan.distance.largest);
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("--object: {}", error.what()));
  }
}

/// The same, as large as an object can be. Throws UsageError.
double object_px_of(double mm, const std::string& skin, const std::optional<calib::Rig>& rig,
                    const MachineProfile& profile, int image_width, int image_height) {
  const double object_px = px_where_farthest(mm, skin, rig, profile, image_width, image_height);
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
  settings.object_mm = option.mm.value_or(0);
  if (option.mm) settings.object_px = object_px_of(*option.mm, skin, rig, profile, image_width, image_height);
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

std::int64_t check_object_limit(const ObjectOption& option, const std::string& skin,
                                const std::vector<const MapTable*>& tables, const MachineProfile& profile,
                                Settings& settings) {
  const auto knows_areas = [](const MapTable* table) { return !table->facts().areas.empty(); };
  if (!std::ranges::all_of(tables, knows_areas)) settings.object_mm = 0;
  std::int64_t judgeable = std::numeric_limits<std::int64_t>::max();
  for (const MapTable* table : tables) judgeable = std::min(judgeable, supported_pixels(*table, settings.decision));
  const std::int64_t limit = object_limit(settings, profile);
  if (option.given && settings.object_px > 0 && limit > judgeable) {
    throw FileError(skin, "",
                    fmt::format("no object can be an alarm: one of {:.0f} px across takes {} pixels of the result, and "
                                "{} can judge {} of this skin",
                                settings.object_px, limit, name_of(settings.decision), judgeable),
                    "a larger skin, or a smaller --object; 0 for none");
  }
  return judgeable;
}

std::string object_text(const ObjectOption& option, const Settings& settings, const MachineProfile& profile,
                        std::int64_t judgeable_pixels) {
  if (settings.object_px <= 0) return "none is an alarm by itself";
  const std::string mm = option.mm ? fmt::format("{:g} mm, ", *option.mm) : "";
  const std::int64_t limit = object_limit(settings, profile);
  std::string text = fmt::format("{}{:.0f} px across, {} pixels of the result", mm, settings.object_px, limit);
  if (const double area_mm2 = object_area_limit_mm2(settings); area_mm2 > 0) {
    text = fmt::format(
        "{}an area of {:.0f} mm2; where the skin is farthest {:.0f} px across, about {} pixels of the result", mm,
        area_mm2, settings.object_px, limit);
  }
  if (limit > judgeable_pixels) {
    text += fmt::format("; {} can judge {} of this skin, so only --alarm-limit counts", name_of(settings.decision),
                        judgeable_pixels);
  }
  return text;
}

}  // namespace horopter::cli
