// SPDX-License-Identifier: Apache-2.0
// horopter map: makes and explains mapping tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/draw/map_draw.hpp"
#include "horopter/image/output.hpp"
#include "horopter/map/map_json.hpp"
#include "horopter/map/support.hpp"
#include "horopter/plan/plan.hpp"
#include "horopter/skin/skin_file.hpp"
#include "inputs.hpp"
#include "numbers.hpp"
#include "warnings.hpp"
#include "words.hpp"

namespace horopter::cli {
namespace {

struct MapOptions {
  std::string skin;
  std::string rig;
  std::string profile;
  std::string size;
  std::string output;
  std::string inspect;
  std::string draw;
  Decision decision = Decision::thesis;
  double alarm_percent = Settings().alarm_percent;
  bool json = false;
};

std::pair<int, int> parse_size(const std::string& text) {
  if (const auto size = size_of(text)) return *size;
  throw UsageError(fmt::format("--size '{}'; expected WIDTHxHEIGHT, as 640x480", text));
}

std::vector<Decision> rules_of(const MachineProfile& profile) {
  std::vector<Decision> rules;
  if (profile.has_thesis()) rules.push_back(Decision::thesis);
  if (profile.has_compete()) rules.push_back(Decision::compete);
  return rules;
}

/// Smallest and largest area of the skin that a pixel of the result sees, mm²; nothing without a rig.
std::optional<std::pair<double, double>> area_range_mm2(const hls::table::Facts& facts) {
  if (facts.areas.empty()) return std::nullopt;
  const auto [smallest, largest] = std::ranges::minmax_element(facts.areas);
  return std::pair{hls::table::decode_area(*smallest), hls::table::decode_area(*largest)};
}

/// What the table's header says to the machine beside its size.
void explain_facts(const MapTable& table, const MachineProfile& profile) {
  const hls::table::Facts& facts = table.facts();
  const std::int64_t pixels = table.result_pixels();
  for (const Decision decision : rules_of(profile)) {
    const std::int64_t supported = supported_pixels(table, decision);
    fmt::print(
        "  {:12}  {} pixels of the result ({:.1f} %), of which --undecidable-limit is a share: all of their "
        "support is supervised\n                the other {} are unsupervised in every frame\n",
        fmt::format("by {}", name_of(decision)), supported,
        100.0 * static_cast<double>(supported) / static_cast<double>(pixels), pixels - supported);
  }
  const char* unknown = "not known: the skin knows no rig";
  const auto areas = area_range_mm2(facts);
  fmt::print(
      "  areas         {}\n",
      areas ? fmt::format("a pixel of the result sees {:.3g} to {:.3g} mm2 of the skin, one value for {} px square",
                          areas->first, areas->second, 1 << hls::table::area_block_log2)
            : unknown);
  fmt::print("  shifts        {}\n",
             facts.shifts ? fmt::format("{} to {} px along the row are places in front of both cameras, 0 is the skin",
                                        facts.shifts->lowest_px, facts.shifts->highest_px)
                          : unknown);
}

void explain(const MapSet& maps) {
  const MachineProfile& profile = find_profile(maps.profile);
  if (!maps.rig.empty()) fmt::print("rig      CRC {}\n", crc_text(maps.rig_crc()));
  fmt::print("skin     {}\nprofile  {}, images of {}x{} pixels\n", maps.skin, maps.profile, maps.image_width,
             maps.image_height);
  for (const CompiledMap& map : maps.maps) {
    const MapReport& r = map.report;
    const auto& geometry = map.table.geometry();
    const auto percent = [&](std::int64_t pixels) {
      return 100.0 * static_cast<double>(pixels) / static_cast<double>(r.pixels);
    };
    if (geometry.scan != Scan::progressive) fmt::print("{} field\n", scan_name(geometry.scan));
    fmt::print("  size          {}x{} pixels\n", geometry.width, geometry.height);
    fmt::print("  grid          {}x{} control points, one every {}x{} pixels\n", map.table.columns(), map.table.rows(),
               r.spacing_x, r.spacing_y);
    fmt::print("  bytes         {} of the pool's {} ({:.1f} %)\n", r.pool_bytes, profile.pool_bytes,
               100.0 * static_cast<double>(r.pool_bytes) / profile.pool_bytes);
    fmt::print("  CRC-32        {}\n", crc_text(r.crc));
    fmt::print("  error         99 % of the pixels within {:.4f} px of the skin, all within {:.4f} px\n", r.error_99_px,
               r.error_largest_px);
    fmt::print("                with weights of {} bits all within {:.4f} px\n", profile.weight_bits,
               r.rounded_largest_px);
    fmt::print(
        "  right rows    from y{:+d} to y{:+d}; LOOKAHEAD {}, store of {} rows: y{:+d} to y{:+d}, cameras rolled "
        "against each other by up to {:.0f} deg\n",
        -r.reach.behind, r.reach.ahead, r.lookahead, profile.store_rows, -profile.rows_behind(),
        profile.largest_lookahead(), std::floor(largest_roll_deg(profile)));
    fmt::print("  supervised    {} pixels ({:.1f} %), {:.1f} % of those that see the skin\n", r.supervised(),
               percent(r.supervised()),
               100.0 * static_cast<double>(r.supervised()) /
                   static_cast<double>(std::max<std::int64_t>(1, r.pixels - r.count(Reason::no_source))));
    fmt::print("  compared      {:.1f} % of the image, on the skin and around it, for what both cameras must see\n",
               100 * compared_share(map.table, profile, r.lookahead));
    explain_facts(map.table, profile);
    const char* head = "unsupervised";
    for (int i = 1; i < kReasonCount; ++i) {
      if (r.by_reason[i] == 0) continue;
      fmt::print("  {:12}  {:.1f} % {}\n", head, percent(r.by_reason[i]), reason_text(static_cast<Reason>(i)));
      head = "";
    }
  }
}

/// Fields stand one above the other.
void draw(const MapSet& maps, const std::string& path, bool json) {
  const MachineProfile& profile = find_profile(maps.profile);
  std::optional<CameraPair> cameras;
  if (!maps.rig.empty()) {
    const calib::Rig rig = calib::rig_from_yaml(maps.rig, path);
    cameras.emplace(rig.cameras.at(0), rig.cameras.at(1));
  }
  std::vector<Picture> pictures;
  for (const CompiledMap& map : maps.maps) {
    const std::string scan(scan_name(map.table.geometry().scan));
    if (!cameras) {
      pictures.push_back(
          draw_map(map.table, profile.weight_bits, fmt::format("Displacement from left to right image, {}", scan)));
      continue;
    }
    auto drawn =
        draw_thickness(map.table, thickness_mm(map.table, profile.weight_bits, *cameras, kD95_px * profile.subsample),
                       fmt::format("Thickness along the left line of sight for +-{} px, {}", kD95_px, scan));
    if (!json) {
      fmt::print("thickness {:.2f} to {:.2f} mm along the left line of sight for a disparity of +-{} px ({})\n",
                 drawn.thinnest_mm, drawn.thickest_mm, kD95_px, scan);
    }
    pictures.push_back(std::move(drawn.picture));
  }
  const Picture page = one_below_other(pictures);
  write_file(path, encode_png_bgr(page.width, page.height, page.bgr));
}

ExitStatus map(const MapOptions& options) {
  check_outputs({{"--output", options.output}, {"--draw", options.draw}},
                {{"--skin", options.skin}, {"--rig", options.rig}, {"--inspect", options.inspect}});
  MapSet maps;
  if (!options.inspect.empty()) {
    for (const auto& [name, value] : {std::pair{"--skin", &options.skin},
                                      {"--rig", &options.rig},
                                      {"--output", &options.output},
                                      {"--profile", &options.profile},
                                      {"--size", &options.size}}) {
      if (!value->empty()) throw UsageError(fmt::format("--inspect does not go with {}", name));
    }
    maps = load_maps(options.inspect);
    find_profile(maps.profile);
  } else {
    for (const auto& [name, value] : {std::pair{"--skin", &options.skin}, {"--profile", &options.profile}}) {
      if (value->empty()) throw UsageError(fmt::format("{} is required (or --inspect FILE)", name));
    }
    if (options.output.empty() && options.draw.empty() && !options.json) {
      throw UsageError("--output is required (or --draw, or --json to see the report only)");
    }
    const MachineProfile& profile = find_profile(options.profile);
    const auto rig = read_rig_option(options.rig);
    int width = profile.largest_image_width();
    int height = profile.largest_image_height();
    if (!options.size.empty()) {
      std::tie(width, height) = parse_size(options.size);
      try {
        check_image_size("--size", width, height, profile);
      } catch (const FileError& error) {
        throw UsageError(error.what());
      }
    } else if (rig && rig->cameras.front().width_px != 0) {
      width = rig->cameras.front().width_px;
      height = rig->cameras.front().height_px;
      check_image_size(options.rig, width, height, profile);
    }
    maps = load_or_compile_maps(options.skin, rig, profile, width, height, options.decision);
    check_alarm_limit(options.skin, maps.tables(), profile, options.decision, options.alarm_percent);
    if (!options.output.empty()) save_maps(maps, options.output);
  }
  if (!options.draw.empty()) draw(maps, options.draw, options.json);
  auto report = to_json(maps);
  const MachineProfile& profile = find_profile(maps.profile);
  for (std::size_t i = 0; i < maps.maps.size(); ++i) {
    const MapTable& table = maps.maps[i].table;
    auto& entry = report["tables"][i];
    for (const Decision decision : rules_of(profile)) {
      const std::int64_t supported = supported_pixels(table, decision);
      entry["supported"][std::string(name_of(decision))] = supported;
      entry["always_unsupervised"][std::string(name_of(decision))] = table.result_pixels() - supported;
    }
    if (const auto areas = area_range_mm2(table.facts())) entry["area_mm2"] = {areas->first, areas->second};
    if (const auto& shifts = table.facts().shifts) entry["shifts_px"] = {shifts->lowest_px, shifts->highest_px};
  }
  report_rows(options.decision, !maps.rig.empty(), report, options.json);
  add_warnings(report);
  if (options.json) {
    std::puts(json_text(report).c_str());
  } else {
    explain(maps);
  }
  return ExitStatus::done;
}

}  // namespace

void add_map(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<MapOptions>();
  CLI::App* command = app.add_subcommand("map", "Make a mapping table from a skin, or explain one");
  command->add_option("--skin", options->skin, "The skin (skin.yaml)")->type_name("FILE");
  command
      ->add_option("--rig", options->rig,
                   "The cameras (rig.yaml); homographies and correspondences use only the image size")
      ->type_name("FILE");
  command->add_option("--profile", options->profile, "Build of the machine: " + profile_sizes())->type_name("P");
  command
      ->add_option("--size", options->size,
                   "Size of the images, WIDTHxHEIGHT (default: that of the rig's cameras, or the profile's largest)")
      ->type_name("WxH");
  command->add_option("-o,--output", options->output, "The table to write (.hmap)")->type_name("FILE");
  command->add_option("--inspect", options->inspect, "Explain this table instead of making one")->type_name("FILE");
  add_decision(*command, options->decision)->excludes("--inspect");
  command
      ->add_option("--alarm-limit", options->alarm_percent,
                   "That of `horopter run`, % of the whole image: a skin too small for it is refused")
      ->check(within(0, 100, "%"))
      ->excludes("--inspect")
      ->capture_default_str();
  command
      ->add_option(
          "--draw", options->draw,
          "A picture (PNG) with axes and a scale, dots at control points, dark where nothing is supervised: with a rig "
          "the skin's thickness, red thin to blue thick; else the displacements, hue by direction, a line every 8 "
          "pixels")
      ->type_name("FILE");
  command->add_flag("--json", options->json, "Print the report as JSON on standard output, and nothing else");
  command->footer(
      "The grid is the coarsest whose expansion, in the hardware's own arithmetic, stays within 1/16 px of the skin for\n"
      "99 % of the pixels and within 1/4 px for all. A skin that needs more rows than the image store holds is refused.\n"
      "For --decision compete, pixels whose epipolar line leaves the row by more than 1/2 px within the largest shift of its\n"
      "planes are not supervised, as with cameras that are not parallel, or images that are not rectified; where that is\n"
      "more than 90 % of those that see the skin, the cameras are refused. Without a rig it is not known.\n\n" +
      skin_file_help() +
      "\n"
      "Example: horopter map --skin skin.yaml --profile vga -o skin.hmap --draw skin.png");
  command->callback([options, &outcome] { outcome.status = map(*options); });
}

}  // namespace horopter::cli
