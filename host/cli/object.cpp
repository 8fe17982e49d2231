// SPDX-License-Identifier: Apache-2.0
#include "object.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <variant>

#include "horopter/base/error.hpp"
#include "horopter/map/map.hpp"
#include "horopter/map/skin_places.hpp"
#include "horopter/map/support.hpp"
#include "horopter/plan/plan.hpp"
#include "horopter/skin/rig_skin.hpp"
#include "inputs.hpp"
#include "warnings.hpp"

namespace horopter::cli {
namespace {

constexpr double kLargest_px = 1000, kSmallest_mm = 5, kLargest_mm = 2000;
constexpr double kMostBeyondLimit = 0.5;  ///< of the skin: its border has always some
constexpr double kUsual_mm = 40;          ///< a hand or an arm: what the usual limit is to find

void parse(const std::string& text, ObjectOption& option) {
  const bool in_mm = text.ends_with("mm");
  const std::string number = text.substr(0, text.size() - (in_mm || text.ends_with("px") ? 2 : 0));
  double value = 0;
  const bool is_number = CLI::detail::lexical_cast(number, value) && std::isfinite(value);
  const bool never = is_number && value == 0 && !in_mm;
  const double smallest_px = smallest_object_px();
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

/// Of a body on the skin, where that is farthest away, and where it is nearest.
struct PxPerMm {
  double farthest = 0, nearest = 0;
};
using InMm = std::variant<PxPerMm, FileError>;  ///< or why its mm are not known

PxPerMm px_per_mm(const CameraPair& cameras, double farthest_mm, double nearest_mm) {
  const double f_px = std::min(cameras.left().model.fx_px(), cameras.left().model.fy_px());
  return {f_px / farthest_mm, f_px / nearest_mm};
}

/// Distances along the axis of symmetry, as plan_thickness says them, by a table alone: its rig is in it.
InMm of_table(const std::string& skin) {
  constexpr int kStep_px = 8;
  const MapSet maps = load_maps(skin);
  if (maps.rig.empty()) {
    return FileError(skin, "", "--object in mm: a table without a rig knows no mm",
                     "one of a surface in the rig's world, or --object in px");
  }
  const CameraPair cameras = first_pair(calib::rig_from_yaml(maps.rig, skin), skin);
  const StereoAxis axis(cameras);
  double farthest_mm = 0, nearest_mm = std::numeric_limits<double>::infinity();
  for (const CompiledMap& map : maps.maps) {
    const SkinPlaces places(map.table, cameras);
    const ScanGeometry& geometry = map.table.geometry();
    for (int y = 0; y < geometry.height; y += kStep_px) {
      for (int x = 0; x < geometry.width / map.table.facts().subsample; x += kStep_px) {
        const auto place = places.exactly_at(x, y);
        if (!place) continue;
        const double mm = (place->at_mm - axis.middle_mm).dot(axis.direction);
        farthest_mm = std::max(farthest_mm, mm);
        nearest_mm = std::min(nearest_mm, mm);
      }
    }
  }
  if (!(farthest_mm > 0)) {
    return FileError(skin, "", "--object in mm: nothing of the skin is supervised", "a larger skin");
  }
  return px_per_mm(cameras, farthest_mm, nearest_mm);
}

InMm in_mm(const std::string& skin, const std::optional<calib::Rig>& rig, const MachineProfile& profile,
           int image_width, int image_height) {
  if (is_table(skin)) return of_table(skin);
  SkinFile file;
  if (!is_moving_skin(skin)) file = load_skin_for(skin, rig, image_width, image_height);
  const auto* in_space = dynamic_cast<const RigSkin*>(file.skin.get());
  if (in_space == nullptr) {
    return FileError(skin, "",
                     file.skin ? fmt::format("--object in mm: a {} knows no mm", file.skin->type())
                               : std::string("--object in mm: this skin moves, and its distance changes"),
                     "a surface in the rig's world that does not move, or --object in px");
  }
  const ScanGeometry geometry = scans_of(profile, image_width, image_height).front();
  try {
    constexpr double kAny_px = 1;  // only the distance is asked for
    const ThicknessPlan plan = plan_thickness(in_space->cameras(), *in_space->surface(), profile, geometry, kAny_px);
    if (plan.supervised > 0) {
      return px_per_mm(in_space->cameras(), plan.distance.largest, plan.distance.smallest);
    }
    return FileError(skin, "", "--object in mm: nothing of the skin is supervised", "a larger skin");
  } catch (const std::invalid_argument& error) {
    return FileError(skin, "", fmt::format("--object in mm: {}", error.what()), "a skin in front of both cameras");
  }
}

/// Of the tables of a motion those that are looked at pixel by pixel, which takes longer than to make them.
std::vector<std::size_t> spread_tables(std::size_t tables) {
  constexpr std::size_t kMost = 32;
  std::vector<std::size_t> chosen;
  const std::size_t count = std::min(tables, kMost);
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(count == 1 ? 0 : i * (tables - 1) / (count - 1));
  return chosen;
}

/// What the machine compares an object with.
ShownLimit shown_limit(const Settings& settings, const MachineProfile& profile) {
  const double area_mm2 = object_area_limit_mm2(settings);
  if (area_mm2 > 0) return {area_mm2, true};
  return {static_cast<double>(object_limit(settings, profile)), false};
}

double judged(const Judgeable& judgeable, const ShownLimit& limit) {
  return limit.in_mm2 ? judgeable.mm2 : static_cast<double>(judgeable.pixels);
}

/// What is certain to be found, in whole mm.
double smallest_mm(const PxPerMm& px, const MachineProfile& profile) {
  const double smallest_px = smallest_object_px(profile);
  const double mm = std::ceil(smallest_px / px.farthest);
  return mm * px.farthest >= smallest_px ? mm : mm + 1;  // as it is rounded
}

/// A body of option.mm. Throws UsageError where an object cannot be as small.
void set_body(const ObjectOption& option, const PxPerMm& px, const MachineProfile& profile, Settings& settings) {
  settings.object_mm = *option.mm;
  settings.object_px = *option.mm * px.farthest;
  if (const double smallest_px = smallest_object_px(profile); !(settings.object_px >= smallest_px)) {
    throw UsageError(fmt::format(
        "{:g} mm are {:.1f} px where the skin is farthest away; the smallest that is found for certain is {:g} "
        "px, {:.0f} mm here",
        *option.mm, settings.object_px, smallest_px, smallest_mm(px, profile)));
  }
}

/// Where nothing was asked for and the skin knows mm: kUsual_mm, or the smallest body that can be found wherever it is. It
/// stays px where these are less of a body, or where such a body does not fit into the image.
void set_usual_body(ObjectOption& option, const PxPerMm& px, const MachineProfile& profile, int side_px) {
  const double mm = std::max(kUsual_mm, smallest_mm(px, profile));
  if ((mm > kUsual_mm && mm * px.nearest > option.px) || mm * px.farthest > side_px) return;
  option.mm = mm;
}

}  // namespace

void add_object(CLI::App& command, ObjectOption& option) {
  command
      .add_option_function<std::string>(
          "--object", [&option](const std::string& text) { parse(text, option); },
          "Alarm for an object on the skin this large across, at once: px of the left image, or mm with a rig; 0: only "
          "--alarm-limit counts")
      ->type_name("SIZE")
      ->default_str(fmt::format("{:g}mm with a rig, or the smallest it can find; else {:g}px", kUsual_mm, option.px));
}

ObjectOption set_object(const ObjectOption& asked, const std::string& skin, const std::optional<calib::Rig>& rig,
                        const MachineProfile& profile, int image_width, int image_height, Settings& settings) {
  ObjectOption option = asked;
  const int side_px = std::min(image_width, image_height);
  settings.object_px = option.px;
  settings.object_mm = 0;
  if (option.mm || !option.given) {
    const InMm found = in_mm(skin, rig, profile, image_width, image_height);
    const auto* px = std::get_if<PxPerMm>(&found);
    if (option.mm && px == nullptr) throw std::get<FileError>(found);
    if (px != nullptr && !option.given) set_usual_body(option, *px, profile, side_px);
    if (option.mm) set_body(option, *px, profile, settings);
  }
  if (const double smallest_px = smallest_object_px(profile);
      settings.object_px != 0 && settings.object_px < smallest_px) {
    throw UsageError(
        fmt::format("an object of {:g} px: profile {} may see less than half of it, by its windows and majority; the "
                    "smallest is {:g} px",
                    settings.object_px, profile.name, smallest_px));
  }
  if (option.given && settings.object_px > side_px) {
    throw UsageError(
        fmt::format("an object of {:.0f} px across does not fit into an image of {}x{}: none would be an alarm",
                    settings.object_px, image_width, image_height));
  }
  return option;
}

Judgeable check_object_limit(const ObjectOption& option, const std::string& skin,
                             const std::vector<const MapTable*>& tables, const MachineProfile& profile,
                             Settings& settings) {
  const auto knows_areas = [](const MapTable* table) { return !table->facts().areas.empty(); };
  if (!std::ranges::all_of(tables, knows_areas)) settings.object_mm = 0;
  const ShownLimit limit = shown_limit(settings, profile);
  Judgeable judgeable;
  for (const MapTable* table : tables) {
    judgeable.pixels = std::min(judgeable.pixels, supported_pixels(*table, settings.decision));
    if (limit.in_mm2) judgeable.mm2 = std::min(judgeable.mm2, supported_mm2(*table, profile, settings.decision));
  }
  const std::string size =
      limit.in_mm2 ? fmt::format("{:g} mm", settings.object_mm) : fmt::format("{:.0f} px", settings.object_px);
  const bool fits = limit.least <= judged(judgeable, limit);
  if (option.given && settings.object_px > 0 && !fits) {
    throw FileError(
        skin, "",
        fmt::format("no object can be an alarm: one of {} across takes {:.0f} {}, and {} can judge {:.0f} of this skin",
                    size, limit.least, limit.in_mm2 ? "mm2" : "pixels of the result", name_of(settings.decision),
                    judged(judgeable, limit)),
        "a larger skin, or a smaller --object; 0 for none");
  }
  if (settings.object_px > 0 && fits) {
    double beyond = 0;
    std::size_t worst = 0;
    for (const std::size_t i : spread_tables(tables.size())) {
      const double here = share_beyond_limit(*tables[i], profile, settings.decision, limit);
      if (here <= beyond) continue;
      beyond = here;
      worst = i;
    }
    if (beyond > kMostBeyondLimit) {
      warn(fmt::format(
          "{}: {}over {:.0f} % of this skin an object of {} shows less than it takes for an alarm, "
          "because the skin is narrow there, or parted by gaps; join its pieces, or take a smaller --object",
          skin, table_prefix(worst, tables.size()), 100 * beyond, size));
    }
  }
  return judgeable;
}

std::string object_text(const ObjectOption& option, const Settings& settings, const MachineProfile& profile,
                        const Judgeable& judgeable) {
  if (settings.object_px <= 0) return "none is an alarm by itself";
  std::string mm = option.mm ? fmt::format("{:g} mm, ", *option.mm) : "";
  if (option.mm && !option.given && *option.mm > kUsual_mm) {
    mm = fmt::format("{:g} mm, for {:g} mm are too few px, ", *option.mm, kUsual_mm);
  }
  const std::int64_t pixels = object_limit(settings, profile);
  const ShownLimit limit = shown_limit(settings, profile);
  std::string text = fmt::format("{}{:.0f} px across, {} pixels of the result", mm, settings.object_px, pixels);
  if (limit.in_mm2) {
    text = fmt::format(
        "{}an area of {:.0f} mm2; where the skin is farthest {:.0f} px across, about {} pixels of the result", mm,
        limit.least, settings.object_px, pixels);
  }
  if (const double most = judged(judgeable, limit); limit.least > most) {
    text += fmt::format("; {} can judge {:.0f}{} of this skin, so only --alarm-limit counts",
                        name_of(settings.decision), most, limit.in_mm2 ? " mm2" : "");
  }
  return text;
}

nlohmann::ordered_json object_json(const Settings& settings, const MachineProfile& profile,
                                   const Judgeable& judgeable) {
  nlohmann::ordered_json object{{"px", std::round(10 * settings.object_px) / 10},
                                {"pixels", object_limit(settings, profile)},
                                {"judgeable_pixels", judgeable.pixels}};
  const ShownLimit limit = shown_limit(settings, profile);
  object["limit"] = limit.in_mm2 ? "area" : "pixels";
  if (limit.in_mm2) {
    object["mm"] = settings.object_mm;
    object["area_mm2"] = limit.least;
    object["judgeable_mm2"] = std::round(judgeable.mm2);
  }
  return object;
}

}  // namespace horopter::cli
