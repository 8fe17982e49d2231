// SPDX-License-Identifier: Apache-2.0
#include "inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <ranges>
#include <utility>

#include "horopter/base/error.hpp"
#include "horopter/base/file.hpp"
#include "horopter/image/output.hpp"
#include "horopter/machine/proof.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/map/map_json.hpp"
#include "horopter/map/row_check.hpp"
#include "horopter/map/support.hpp"
#include "horopter/plan/plan_rig.hpp"
#include "horopter/skin/skin_file.hpp"
#include "numbers.hpp"
#include "warnings.hpp"

namespace horopter::cli {
namespace {

/// Smallest frame of the machine: the filters' windows and the flushing of rows need room.
constexpr int kSmallestWidth = 32;
constexpr int kSmallestHeight = 16;

/// %, so that half a skin stays half a skin when it is rounded to two digits.
constexpr double kAboutHalf = 47;

/// How far the centre of a camera whose image size is not told may be from the middle of an image: of its size.
constexpr double kLargestOffCentre = 0.2;

const char* const kSkinExpected = "a skin (skin.yaml) or a mapping table (.hmap)";

/// Devices and pipes are no files here: they may be named twice.
bool is_same_file(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::exists(a, error) && !fs::is_regular_file(a, error)) return false;
  if (fs::equivalent(a, b, error)) return true;
  const auto place = [&](const std::string& path) {
    return fs::weakly_canonical(fs::absolute(behind_links(path), error), error);
  };
  const fs::path place_of_a = place(a);
  return !place_of_a.empty() && place_of_a == place(b);
}

/// The rig of a skin, before images of a size. Throws FileError.
void check_cameras(const std::string& skin, const calib::Rig& rig, int image_width, int image_height) {
  const std::string size = fmt::format("{}x{}", image_width, image_height);
  for (const calib::Camera& camera : rig.cameras) {
    if (camera.width_px == image_width && camera.height_px == image_height) continue;
    if (camera.width_px != 0) {
      throw FileError(skin, "",
                      fmt::format("camera {} of the rig takes images of {}x{} pixels", camera.name, camera.width_px,
                                  camera.height_px),
                      size + ", the size of the images");
    }
    const double cx_px = camera.model.cx_px(), cy_px = camera.model.cy_px();
    if (std::abs(cx_px / image_width - 0.5) > kLargestOffCentre ||
        std::abs(cy_px / image_height - 0.5) > kLargestOffCentre) {
      throw FileError(skin, "",
                      fmt::format("camera {} of the rig, whose image size is not told, has its centre at ({:.1f}, "
                                  "{:.1f}) px",
                                  camera.name, cx_px, cy_px),
                      fmt::format("near the middle of {}; or image_size in the rig", size));
    }
    warn(fmt::format("{}: the rig does not tell the image size of camera {}; taken for {}", skin, camera.name, size));
  }
}

/// A rig that was given beside a skin, or a table, that knows none: only its image size serves. Throws FileError.
void check_rig_beside(const std::string& skin, const std::optional<calib::Rig>& rig, int image_width,
                      int image_height) {
  if (!rig) return;
  calib::Rig pair{rig->world, {}};
  for (const calib::Camera& camera : rig->cameras | std::views::take(2)) pair.cameras.push_back(camera);
  check_cameras(skin, pair, image_width, image_height);
  warn(fmt::format(
      "{}: of the rig only the image size is used: this skin says in pixels what the cameras see of it. One in mm "
      "of the rig's world uses the rig",
      skin));
}

/// So many pixels along the row as down, spread over the image.
std::vector<Point> spread_pixels(int places, int image_width, int image_height) {
  std::vector<Point> pixels;
  for (int i = 0; i < places * places; ++i) {
    const int column = i % places;
    const int row = i / places;
    pixels.push_back({(column + 0.5) / places * image_width - 0.5, (row + 0.5) / places * image_height - 0.5});
  }
  return pixels;
}

/// Their lines of sight, of the left camera.
Rays spread_rays(const RigSkin& skin, int places, int image_width, int image_height) {
  return skin.cameras().rays(spread_pixels(places, image_width, image_height));
}

/// Says where points so close together do not tell what the rest of the image sees: a fit goes astray beyond its points.
void check_points(const SkinFile& file, int image_width, int image_height) {
  constexpr int kPlaces = 32;
  constexpr double kOfPoint_px = 0.5;  // as well as a person can show a corner
  constexpr double kLargest_px = 1;
  const ScanGeometry image{image_width, image_height, Scan::progressive};
  const std::vector<Point> pixels = spread_pixels(kPlaces, image_width, image_height);
  std::vector<Look> looks(pixels.size());
  file.skin->look(pixels, image.row_step(), {}, looks);
  const std::vector<double> deviations = fit_deviations_px(file.correspondences, pixels, kOfPoint_px);
  std::size_t worst = 0;
  double largest_px = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (looks[i].reason != Reason::none || !image.holds(looks[i].source) || !(deviations[i] > largest_px)) continue;
    largest_px = deviations[i];
    worst = i;
  }
  if (largest_px <= kLargest_px) return;
  warn(fmt::format(
      "{}: the points lie too close together: where each is right to {:g} px, the skin is right to {:.1f} px "
      "at pixel ({:.0f}, {:.0f}) of the left image; expected points spread over the skin",
      file.path, kOfPoint_px, largest_px, pixels[worst].x, pixels[worst].y));
}

std::vector<Hit> meet(const Surface& surface, const RigSkin& skin, const Rays& rays) {
  std::vector<Hit> hits(rays.size());
  surface.intersect(skin.cameras().left().world_to_camera.centre(), rays.directions, hits);
  return hits;
}

/// Says which surfaces of a union are not watched: no line of sight of the left camera meets them first, or where one does,
/// the right camera does not see it so.
void check_parts(const std::string& file, const RigSkin& skin, int image_width, int image_height) {
  const std::vector<SurfacePtr> parts = skin.surface()->parts();
  if (parts.empty()) return;
  constexpr int kPlaces = 128;
  const ScanGeometry image{image_width, image_height, Scan::progressive};
  const Rays rays = spread_rays(skin, kPlaces, image_width, image_height);
  const std::vector<Hit> first = meet(*skin.surface(), skin, rays);
  std::vector<Look> looks(rays.size());
  skin.cameras().look(*skin.surface(), rays, image.row_step(), {}, looks);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const std::vector<Hit> hits = meet(*parts[part], skin, rays);
    bool met = false;
    std::array<int, kReasonCount> met_first{};
    for (std::size_t i = 0; i < hits.size(); ++i) {
      if (!std::isfinite(hits[i].distance)) continue;
      met = true;
      if (hits[i].distance > first[i].distance) continue;
      const bool outside = looks[i].reason == Reason::none && !image.holds(looks[i].source);
      ++met_first[static_cast<std::size_t>(outside ? Reason::outside : looks[i].reason)];
    }
    if (met_first[static_cast<std::size_t>(Reason::none)] > 0) continue;
    const auto most = std::ranges::max_element(met_first);
    const std::string why =
        *most > 0 ? fmt::format("where the left camera sees it, most of it is {}",
                                reason_text(static_cast<Reason>(most - met_first.begin())))
        : met ? "for the left camera it is hidden behind the others. Where it shall be watched too, it needs a skin of "
                "its own"
              : "the left camera does not see it, or sees it smaller than 1/128 of the image";
    warn(fmt::format("{}: nothing watches surface {} of the union ({}): {}", file, part + 1, parts[part]->description(),
                     why));
  }
}

/// A skin in another unit than the rig is at a place where no skin is. Throws FileError.
void check_distance(const std::string& file, const RigSkin& skin, int image_width, int image_height) {
  constexpr int kPlaces = 32;
  const Rays rays = spread_rays(skin, kPlaces, image_width, image_height);
  const std::vector<Hit> hits = meet(*skin.surface(), skin, rays);
  std::vector<double> distances_mm;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (std::isfinite(hits[i].distance)) distances_mm.push_back(hits[i].distance / rays.over_length[i]);
  }
  if (distances_mm.empty()) return;  // too small to be met, or not seen: others say so
  const auto middle = distances_mm.begin() + static_cast<std::ptrdiff_t>(distances_mm.size() / 2);
  std::ranges::nth_element(distances_mm, middle);
  if (*middle >= kNearest_mm && *middle <= kFarthest_mm) return;
  throw FileError(file, "surface",
                  fmt::format("the cameras do not see this skin so: it is {:.3g} mm from the left one", *middle),
                  fmt::format("{:g} to {:g} mm: a skin in mm of the rig's world", kNearest_mm, kFarthest_mm));
}

/// Of several that a skin or its motion has.
std::string table_place(std::size_t table, std::size_t tables) {
  return tables == 1 ? "" : fmt::format("table {} of {}", table + 1, tables);
}

std::vector<const MapReport*> reports_of(const MapSet& maps) {
  std::vector<const MapReport*> reports;
  for (const CompiledMap& map : maps.maps) reports.push_back(&map.report);
  return reports;
}

}  // namespace

std::string profile_sizes() {
  std::string sizes;
  for (const MachineProfile& profile : profiles()) {
    sizes += fmt::format("{}{} ({}x{})", sizes.empty() ? "" : ", ", profile.name, profile.largest_image_width(),
                         profile.largest_image_height());
  }
  return sizes;
}

void check_image_size(const std::string& name, int width, int height, const MachineProfile& profile) {
  const std::string found = fmt::format("the image is {}x{} pixels", width, height);
  const std::string_view what = profile.name;
  if (width > profile.largest_image_width() || height > profile.largest_image_height()) {
    throw FileError(name, "", found,
                    fmt::format("at most {}x{} for profile {}", profile.largest_image_width(),
                                profile.largest_image_height(), what));
  }
  const int fields = profile.fields_per_image();
  if (width < kSmallestWidth * profile.subsample || height < kSmallestHeight * fields) {
    throw FileError(name, "", found,
                    fmt::format("at least {}x{} for profile {}", kSmallestWidth * profile.subsample,
                                kSmallestHeight * fields, what));
  }
  if (width % profile.subsample != 0 || height % fields != 0) {
    throw FileError(name, "", found,
                    fmt::format("even width and height for profile {}, which takes fields and averages pairs", what));
  }
}

std::string largest_image() {
  const auto pixels = [](const MachineProfile& p) { return p.takes_fields() ? 0 : p.width * p.height; };
  const MachineProfile& largest = *std::ranges::max_element(profiles(), {}, pixels);
  return fmt::format("at most the {}x{} of profile {}", largest.width, largest.height, largest.name);
}

const MachineProfile& choose_profile(const std::string& profile, const std::string& file, const std::string& place,
                                     int width, int height) {
  const MachineProfile* chosen = profile.empty() ? smallest_profile(width, height) : &find_profile(profile);
  if (chosen == nullptr) {
    const char* what = place.empty() ? "the image is" : "images of";
    throw FileError(file, place, fmt::format("{} {}x{} pixels", what, width, height), largest_image());
  }
  check_image_size(file, width, height, *chosen);
  return *chosen;
}

calib::Rig read_rig(const std::string& path) {
  calib::RigFile file = calib::load_rig(path);
  for (const std::string& text : file.warnings) {
    // Of these, who uses the cameras says what comes of them, or refuses the cameras.
    if (text.starts_with("image_size_unknown") || text.starts_with("left_right_exchanged")) continue;
    warn(text);
  }
  return std::move(file.rig);
}

std::optional<calib::Rig> read_rig_option(const std::string& path) {
  if (path.empty()) return std::nullopt;
  return read_rig(path);
}

void check_outputs(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs) {
  const auto check = [](const NamedFile& output, const NamedFile& other) {
    if (output.path.empty() || other.path.empty() || !is_same_file(output.path, other.path)) return;
    throw UsageError(
        fmt::format("{} and {} are one file, {}, which would be lost", other.option, output.option, output.path));
  };
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const NamedFile& input : inputs) check(outputs[i], input);
    for (std::size_t j = 0; j < i; ++j) check(outputs[i], outputs[j]);
  }
}

CameraPair first_pair(const calib::Rig& rig, const std::string& file) {
  if (rig.cameras.size() < 2) throw FileError(file, "cameras", "one camera", "two");
  const calib::Camera &left = rig.cameras[0], &right = rig.cameras[1];
  if (calib::are_exchanged(left, right)) {
    throw FileError(file, "cameras",
                    fmt::format("the second camera, {}, stands to the left of the first, {}", right.name, left.name),
                    "the left camera first; or the translation with the other sign");
  }
  return {left, right};
}

void check_skin_file(const std::string& path) { read_file(path, kSkinExpected); }

SkinFiles::SkinFiles(std::string skin) : skin_(std::move(skin)), checksum_(checksum()) {}

std::uint32_t SkinFiles::checksum() const {
  Crc32 crc;
  try {
    add_skin_files(skin_, kSkinExpected, crc);
  } catch (const FileError&) {  // who reads it for what it is says more
  }
  return crc.value();
}

void SkinFiles::check_unchanged() const {
  if (checksum() == checksum_) return;
  throw FileError(skin_, "", "it, or a mesh that it names, was changed after it was first read",
                  "files that stay as they are until the program has begun; begin it again");
}

bool is_table(const std::string& skin) { return horopter::is_table(read_file(skin, kSkinExpected)); }

SkinFile load_skin_for(const std::string& skin, const std::optional<calib::Rig>& rig, int image_width,
                       int image_height) {
  const Point centre{0.5 * (image_width - 1), 0.5 * (image_height - 1)};
  SkinFile file = load_skin(skin, centre, rig ? &*rig : nullptr);
  if (!file.correspondences.empty()) check_points(file, image_width, image_height);
  if (file.rig.empty()) {
    check_rig_beside(skin, rig, image_width, image_height);
    return file;
  }
  check_cameras(skin, calib::rig_from_yaml(file.rig, skin), image_width, image_height);
  if (const auto* in_space = dynamic_cast<const RigSkin*>(file.skin.get())) {
    check_distance(skin, *in_space, image_width, image_height);
    check_parts(skin, *in_space, image_width, image_height);
  }
  return file;
}

bool is_moving_skin(const std::string& skin) {
  if (is_table(skin)) return false;
  return has_motion(skin);
}

std::unique_ptr<RigSkin> load_rig_skin(const std::string& skin, const calib::Rig& rig) {
  SkinFile file = load_skin(skin, {}, &rig);
  if (dynamic_cast<RigSkin*>(file.skin.get()) == nullptr) {
    throw FileError(skin, "surface", fmt::format("a {} has no place in space", file.skin->type()),
                    "a surface in the rig's world");
  }
  std::unique_ptr<RigSkin> in_space(static_cast<RigSkin*>(file.skin.release()));
  const calib::Camera& left = in_space->cameras().left();
  if (left.width_px != 0) {
    check_distance(skin, *in_space, left.width_px, left.height_px);
    check_parts(skin, *in_space, left.width_px, left.height_px);
  }
  return in_space;
}

MapSet load_or_compile_maps(const std::string& skin, const std::optional<calib::Rig>& rig,
                            const MachineProfile& profile, int image_width, int image_height, Decision decision) {
  const ViewLimits view = view_limits(profile, decision);
  if (!is_table(skin)) {
    const SkinFile file = load_skin_for(skin, rig, image_width, image_height);
    if (file.motion) {
      throw FileError(skin, "motion", "a skin that moves has a table for each frame",
                      "a skin without motion (horopter run takes both)");
    }
    MapSet maps = compile_maps(file, profile, image_width, image_height, view);
    check_supervised(skin, reports_of(maps), !maps.rig.empty());
    return maps;
  }
  MapSet maps = load_maps(skin);
  if (maps.profile != profile.name) {
    throw FileError(skin, "", fmt::format("a table for profile {}", maps.profile),
                    fmt::format("profile {}", profile.name));
  }
  if (maps.image_width != image_width || maps.image_height != image_height) {
    throw FileError(skin, "", fmt::format("a table for images of {}x{} pixels", maps.image_width, maps.image_height),
                    fmt::format("{}x{}", image_width, image_height));
  }
  if (maps.rig.empty()) {
    check_rig_beside(skin, rig, image_width, image_height);
  } else {
    check_cameras(skin, calib::rig_from_yaml(maps.rig, skin), image_width, image_height);
  }
  if (!rig && !maps.rig.empty()) {
    warn(fmt::format("{}: a table for the rig of CRC {}: whether the cameras still stand so is not known without --rig",
                     skin, crc_text(maps.rig_crc())));
  }
  if (rig && !maps.rig.empty()) {
    // The two cameras of the table, by name and every digit, wherever they stand in the rig.
    calib::Rig same{rig->world, {}};
    for (const calib::Camera& camera : calib::rig_from_yaml(maps.rig, skin).cameras) {
      const auto found = std::ranges::find(rig->cameras, camera.name, &calib::Camera::name);
      if (found != rig->cameras.end()) same.cameras.push_back(*found);
    }
    if (calib::to_yaml(same) != maps.rig) {
      throw FileError(skin, "", fmt::format("a table for another rig, of CRC {}", crc_text(maps.rig_crc())),
                      "that of --rig");
    }
  }
  if (view.largest_shift_px != 0 && !maps.rig.empty()) {
    if (const double share = share_beyond_rows(maps, profile, view); share > 0) {
      throw FileError(skin, "",
                      fmt::format("at {:.1f} % of the supervised pixels the epipolar line leaves the row, so that the "
                                  "neighbours of the rule {} are no parallel skins",
                                  100 * share, name_of(decision)),
                      fmt::format("a table made with `horopter map --decision {}`", name_of(decision)));
    }
  }
  check_supervised(skin, reports_of(maps), !maps.rig.empty());
  return maps;
}

double check_supervised(const std::string& skin, const std::vector<const MapReport*>& reports, bool has_rig) {
  double least = 1;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const std::int64_t sees = reports[i]->pixels - reports[i]->count(Reason::no_source);
    if (sees == 0) continue;
    const double share = static_cast<double>(reports[i]->supervised()) / static_cast<double>(sees);
    if (share >= least) continue;
    least = share;
    worst = i;
  }
  if (least >= kLittleSupervised) return least;
  const auto& by_reason = reports[worst]->by_reason;
  const auto reason = std::max_element(by_reason.begin() + 1, by_reason.end(), [&](auto& a, auto& b) {
    const auto count = [&](auto& n) { return &n == &by_reason[static_cast<int>(Reason::no_source)] ? 0 : n; };
    return count(a) < count(b);
  });
  const auto why = static_cast<Reason>(reason - by_reason.begin());
  const char* question = why == Reason::row ? ": `compete` needs rectified images"
                         : has_rig          ? ". Is its unit millimetres, and are these the cameras of the images?"
                                            : "";
  warn(fmt::format("{}: {}of what the left camera sees of this skin {:.0f} % is supervised; most of the rest is {}{}",
                   skin, table_prefix(worst, reports.size()), 100 * least, reason_text(why), question));
  return least;
}

std::string table_prefix(std::size_t table, std::size_t tables) {
  const std::string place = table_place(table, tables);
  return place.empty() ? "" : place + ": ";
}

void check_alarm_limit(const std::string& skin, const std::vector<const MapTable*>& tables,
                       const MachineProfile& profile, Decision decision, double alarm_percent) {
  std::size_t least = 0;
  double supported = std::numeric_limits<double>::infinity();  // in the table `least`; all are of one size
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const auto here = static_cast<double>(supported_pixels(*tables[i], decision));
    if (here >= supported) continue;
    least = i;
    supported = here;
  }
  const ScanGeometry& geometry = tables.at(least)->geometry();
  const int columns = geometry.width / profile.subsample;
  const double pixels = static_cast<double>(columns) * geometry.height;
  const double share = supported / pixels;
  const double needed = limit_of(alarm_percent, pixels) + 1;
  const std::string place = table_place(least, tables.size());
  if (needed > supported) {
    throw FileError(
        skin, place,
        fmt::format("this skin is too small for an alarm, which takes more than {:g} % of the whole image "
                    "in the skin: {} can judge {:.2g} % of the image's pixels on it",
                    alarm_percent, name_of(decision), 100 * share),
        share == 0 ? "a larger skin"
                   : fmt::format("a larger skin, or --alarm-limit {:.2g}, about half of this one", kAboutHalf * share));
  }
  if (2 * needed > supported) {
    warn(fmt::format(
        "{}: {}an alarm takes {:.0f} % of this skin, that is {:g} % of the whole image; about half of the skin would be "
        "--alarm-limit {:.2g}",
        skin, table_prefix(least, tables.size()), 100 * needed / supported, alarm_percent, kAboutHalf * share));
  }
}

void warn_of_proof(const std::string& skin, const std::vector<const MapTable*>& tables, const MachineProfile& profile,
                   int lookahead, const Settings& settings, const std::string& rig) {
  if (!settings.proof.needed) return;
  double share = 1;
  for (const MapTable* table : tables) share = std::min(share, compared_share(*table, profile, lookahead));
  if (share < 0.5) {
    warn(fmt::format(
        "{}: of {:.0f} % of the left image the right camera shows the place, on the skin or around it. Of so little the "
        "cameras may not be shown to see the same world: then no frame is safe, with the fault disagree or moved. "
        "--unproven does without being shown",
        skin, 100 * share));
  }
  // 19/16 of it is what may be undecidable for whatever reason (rtl/top/horopter_agreement_result.sv).
  if (settings.undecidable_percent * 19 / 16 >= 100) {
    warn(fmt::format(
        "an undecidable limit of {:g} %: a skin that lies wholly behind something may read safe; below 84.2 % it "
        "never does",
        settings.undecidable_percent));
  }
  if (rig.empty()) {
    warn(fmt::format("{}: this skin knows no rig: cameras that are exchanged or moved are not told", skin));
  } else if (!with_knowledge(settings.proof, profile, tables, rig, skin).at_full_resolution) {
    warn(fmt::format(
        "{}: a camera that moves by less than about 3 px is not told. The cameras are turned so far about their axes that "
        "what is behind the skin lies too much higher or lower in the right image for a fine comparison",
        skin));
  }
}

void warn_of_designed_rig(const std::string& skin, const std::string& rig) {
  if (rig.empty() || calib::rig_from_yaml(rig, skin).world != kDesignedWorld) return;
  warn(fmt::format(
      "{}: the rig of this skin was designed by `plan rig`, not measured: real cameras stand otherwise, and have other "
      "lenses. So the skin lies elsewhere than it is meant to, and no fault may tell; expected a rig that `calibrate` wrote",
      skin));
}

void report_rows(Decision decision, bool has_rig, nlohmann::ordered_json& summary, bool json) {
  if (decision != Decision::compete) return;
  summary["rows_checked"] = has_rig;
  if (has_rig || json) return;
  fmt::print(
      "this skin knows no rig: compete supposes rectified images, and whether epipolar lines stay in their rows is not "
      "known\n");
}

bool report_row_count(const RowCount& rows, const ViewLimits& view, bool json) {
  if (view.largest_shift_px == 0) return true;
  if (!json) {
    fmt::print("  epipolar lines leave the row at {:.1f} % of the pixels within the other limits: not supervised\n",
               100 * rows.share());
  }
  try {
    check_rows(rows, view);
  } catch (const RowError& error) {
    fmt::print(stderr, "horopter: {}; expected {}\n", error.what(), RowError::expected());
    return false;
  }
  return true;
}

}  // namespace horopter::cli
