// SPDX-License-Identifier: Apache-2.0
// horopter map: makes and explains mapping tables.
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "commands.hpp"
#include "horopter/map_json.hpp"
#include "horopter/output.hpp"
#include "inputs.hpp"

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
  bool json = false;
};

/// `640x480`
std::pair<int, int> parse_size(const std::string& text) {
  int width = 0;
  int height = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width <= 0 || height <= 0) {
    throw UsageError(fmt::format("--size '{}'; expected WIDTHxHEIGHT, as 640x480", text));
  }
  return {width, height};
}

void explain(const MapSet& maps) {
  const MachineProfile& profile = find_profile(maps.profile);
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
    fmt::print("  right rows    from y{:+d} to y{:+d}; LOOKAHEAD {}, store of {} rows\n", -r.reach.behind,
               r.reach.ahead, r.lookahead, profile.store_rows);
    fmt::print("  supervised    {} pixels ({:.1f} %)\n", r.supervised, percent(r.supervised));
    fmt::print("  unsupervised  {:.1f} % outside the right image, {:.1f} % reduced to less than 1/2,\n",
               percent(r.outside), percent(r.scale));
    fmt::print("                {:.1f} % without a source, {:.1f} % in cells with such a corner\n",
               percent(r.no_source), percent(r.grid));
  }
}

void draw(const MapSet& maps, const std::string& path) {
  // Fields stand one above the other.
  int height = 0;
  std::vector<std::uint8_t> picture;
  for (const CompiledMap& map : maps.maps) {
    const auto part = draw_map(map.table, find_profile(maps.profile).weight_bits);
    picture.insert(picture.end(), part.begin(), part.end());
    height += map.table.geometry().height;
  }
  write_file(path, encode_png_bgr(maps.maps.front().table.geometry().width, height, picture));
}

ExitStatus map(const MapOptions& options) {
  MapSet maps;
  if (!options.inspect.empty()) {
    for (const auto& [name, value] : {std::pair{"--skin", &options.skin},
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
    int width = profile.largest_image_width();
    int height = profile.largest_image_height();
    if (!options.size.empty()) {
      std::tie(width, height) = parse_size(options.size);
      try {
        check_image_size("--size", width, height, profile);
      } catch (const FileError& error) {
        throw UsageError(error.what());
      }
    }
    check_rig(options.rig);
    maps = load_or_compile_maps(options.skin, profile, width, height);
    if (!options.output.empty()) save_maps(maps, options.output);
  }
  if (!options.draw.empty()) draw(maps, options.draw);
  if (options.json) {
    std::puts(to_json(maps).dump(2).c_str());
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
  command->add_option("--rig", options->rig, "The cameras (rig.yaml); homographies and correspondences need none")
      ->type_name("FILE");
  command->add_option("--profile", options->profile, "Build of the machine: " + profile_names())->type_name("P");
  command->add_option("--size", options->size, "Size of the images, WIDTHxHEIGHT (default: the profile's largest)")
      ->type_name("WxH");
  command->add_option("-o,--output", options->output, "The table to write (.hmap)")->type_name("FILE");
  command->add_option("--inspect", options->inspect, "Explain this table instead of making one")->type_name("FILE");
  command
      ->add_option("--draw", options->draw,
                   "A picture (PNG) of the displacements: hue by direction, a line every 8 pixels, dots at control "
                   "points, dark where nothing is supervised")
      ->type_name("FILE");
  command->add_flag("--json", options->json, "Print the report as JSON on standard output, and nothing else");
  command->footer(
      "The grid is the coarsest whose expansion, in the hardware's own arithmetic, stays within 1/16 px of the skin "
      "for\n"
      "99 % of the pixels and within 1/4 px for all. A skin that needs more rows than the image store holds is "
      "refused.\n\n"
      "Example: horopter map --skin skin.yaml --profile vga -o skin.hmap --draw skin.png");
  command->callback([options, &outcome] { outcome.status = map(*options); });
}

}  // namespace horopter::cli
