// SPDX-License-Identifier: Apache-2.0
#include "thickness.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "horopter/base/error.hpp"
#include "horopter/plan/tolerance.hpp"
#include "inputs.hpp"
#include "numbers.hpp"
#include "warnings.hpp"

namespace horopter::cli {
namespace {

const char* const kNeedsSurface =
    "--thickness needs a surface and cameras: a skin.yaml of the rig's world, and --rig; --tolerance needs neither";

double chosen_px(const ThicknessOption& option, const RigSkin* skin, const MachineProfile& profile,
                 const ScanGeometry& geometry, Settings& settings) {
  if (!option.thickness_mm) return set_tolerance(settings, *option.tolerance_px);
  try {
    const double wanted_px =
        tolerance_for_mm(*option.thickness_mm, skin->cameras(), *skin->surface(), profile, geometry);
    const auto [smallest_px, largest_px] = tolerance_range(settings.decision);
    const double mm_per_px = *option.thickness_mm / wanted_px;
    if (wanted_px < smallest_px || wanted_px > largest_px) {
      throw UsageError(
          fmt::format("a thickness of {:g} mm is a tolerance of {:.2f} px here; the rule {} can be set to "
                      "{:.1f} to {:.1f} mm",
                      *option.thickness_mm, wanted_px, name_of(settings.decision), smallest_px * mm_per_px,
                      largest_px * mm_per_px));
    }
    return set_tolerance(settings, wanted_px);
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("--thickness: {}", error.what()));
  }
}

ChosenThickness choose(const ThicknessOption& option, const RigSkin* skin, const MachineProfile& profile,
                       const ScanGeometry& geometry, Settings& settings) {
  ChosenThickness chosen{chosen_px(option, skin, profile, geometry, settings),
                         {std::nan(""), std::nan(""), std::nan("")}};
  if (skin != nullptr) {
    chosen.across_mm = plan_thickness(skin->cameras(), *skin->surface(), profile, geometry, chosen.tolerance_px).across;
  }
  return chosen;
}

/// Of a threshold below all that were measured.
void warn_of_thinness(const Settings& settings) {
  const double least_px = tolerance_range(Decision::thesis).smallest_px;
  const double least_percent = threshold_percent_for(least_px);
  if (settings.decision != Decision::thesis || settings.threshold_percent >= least_percent) return;
  warn(fmt::format(
      "a threshold of {:g} % makes the skin thinner than any that was measured, and things on it may not be found; {:g} % "
      "is a tolerance of {:g} px",
      settings.threshold_percent, least_percent, least_px));
}

}  // namespace

void add_thickness(CLI::App& command, ThicknessOption& option) {
  auto* tolerance =
      command
          .add_option("--tolerance", option.tolerance_px,
                      "Half the thickness of the skin as disparity, px of the result, as D50: where half of the pixels "
                      "are found (instead of a rule's own setting; `plan` means D95)")
          ->check(is_tolerance_px())
          ->type_name("PX");
  command
      .add_option("--thickness", option.thickness_mm,
                  "The same in mm, both halves, across the skin, median over the image; for a surface and a rig")
      ->check(is_thickness_mm())
      ->excludes(tolerance)
      ->type_name("MM");
}

std::string ChosenThickness::text(const Settings& settings) const {
  std::string line =
      settings.decision == Decision::thesis
          ? fmt::format("tolerance {:.2f} px (D50): threshold {:.2f} %", tolerance_px, settings.threshold_percent)
          : fmt::format("tolerance {:.2f} px (D50): boundary {}", tolerance_px, settings.competition.boundary);
  if (std::isfinite(across_mm.mean)) {
    line += fmt::format("; the skin is {:.1f} to {:.1f} mm thick, {:.1f} mm in the mean", across_mm.smallest,
                        across_mm.largest, across_mm.mean);
  }
  return line;
}

nlohmann::ordered_json range_json(const Summary& summary) {
  return {{"smallest", summary.smallest}, {"mean", summary.mean}, {"largest", summary.largest}};
}

nlohmann::ordered_json ChosenThickness::json() const {
  nlohmann::ordered_json result{{"tolerance_px", tolerance_px}, {"tolerance_is", "D50"}};
  if (std::isfinite(across_mm.mean)) {
    result["thickness_mm"] = range_json(across_mm);
  }
  return result;
}

std::optional<ChosenThickness> set_thickness(const ThicknessOption& option, const std::string& skin,
                                             const std::optional<calib::Rig>& rig, const MachineProfile& profile,
                                             int image_width, int image_height, Settings& settings) {
  if (!option.tolerance_px && !option.thickness_mm) {
    warn_of_thinness(settings);
    return {};
  }
  const ScanGeometry geometry = scans_of(profile, image_width, image_height).front();
  SkinFile file;
  if (!is_table(skin)) file = load_skin_for(skin, rig, image_width, image_height);
  const auto* in_space = dynamic_cast<const RigSkin*>(file.skin.get());
  if (option.thickness_mm && in_space == nullptr) throw UsageError(kNeedsSurface);
  return choose(option, in_space, profile, geometry, settings);
}

std::optional<ChosenThickness> set_thickness(const ThicknessOption& option, const RigSkin& skin,
                                             const MachineProfile& profile, const ScanGeometry& geometry,
                                             Settings& settings) {
  if (!option.tolerance_px && !option.thickness_mm) return {};
  return choose(option, &skin, profile, geometry, settings);
}

}  // namespace horopter::cli
