// SPDX-License-Identifier: Apache-2.0
// Mapping tables in files (.hmap), and their reports as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "horopter/base/error.hpp"
#include "horopter/base/file.hpp"
#include "horopter/calib/rig.hpp"
#include "horopter/image/output.hpp"
#include "horopter/map/map.hpp"
#include "horopter/map/map_json.hpp"
#include "horopter/map/table_facts.hpp"
#include "horopter/skin/skin_file.hpp"

namespace horopter {

namespace {

constexpr std::uint32_t kMagic = 0x50414D48;  // "HMAP", least significant byte first
constexpr std::uint32_t kVersion = 3;         // of 2 areas of steep places were too small
constexpr std::size_t kNameWords = 4;
constexpr std::size_t kHeaderWords = 3 + kNameWords + 3;  // magic, version, words in all, name, width, height, tables

void append_text(std::vector<std::uint32_t>& words, const std::string& text) {
  words.push_back(static_cast<std::uint32_t>(text.size()));
  for (std::size_t i = 0; i < text.size(); i += 4) {
    std::uint32_t word = 0;
    for (std::size_t j = 0; j < 4 && i + j < text.size(); ++j) {
      word |= std::uint32_t{static_cast<std::uint8_t>(text[i + j])} << (8 * j);
    }
    words.push_back(word);
  }
}

/// The rows that a table reads, as `horopter map` reports them.
RowReach reach_of(const MapTable& table, int weight_bits) {
  const ScanGeometry& geometry = table.geometry();
  RowReach reach{-geometry.height, -geometry.height};
  for (int y = 0; y < geometry.height; ++y) {
    for (int x = 0; x < geometry.width; ++x) {
      const auto source = table.source(x, y, weight_bits);
      if (!source) continue;
      const int first = source->y >> weight_bits;
      const int last = first + ((source->y & ((1 << weight_bits) - 1)) != 0 ? 1 : 0);
      reach = {std::max(reach.behind, y - first), std::max(reach.ahead, last - y)};
    }
  }
  return reach;
}

/// What a table and its report say about each other, and about the profile. Throws std::invalid_argument.
void check_table(const CompiledMap& map, const MachineProfile& profile, const ScanGeometry& scan,
                 std::optional<int> lookahead) {
  const auto require = [](bool holds, const std::string& otherwise) {
    if (!holds) throw std::invalid_argument(otherwise);
  };
  const auto& [table, report] = map;
  const ScanGeometry& found = table.geometry();
  require(found.width == scan.width && found.height == scan.height && found.scan == scan.scan,
          fmt::format("{} rows of {} px, {}, where the image has {} rows of {} px, {}", found.height, found.width,
                      scan_name(found.scan), scan.height, scan.width, scan_name(scan.scan)));
  require(table.pool_bytes() <= static_cast<std::size_t>(profile.pool_bytes),
          fmt::format("{} bytes of areas, spans and control points; the pool holds {}", table.pool_bytes(),
                      profile.pool_bytes));
  const hls::table::Facts true_facts = facts_of(table, profile);
  const hls::table::Facts& facts = table.facts();
  require(facts.subsample == true_facts.subsample && facts.judgeable_by_thesis == true_facts.judgeable_by_thesis &&
              facts.judgeable_by_compete == true_facts.judgeable_by_compete,
          "facts that are not true of its control points");
  const auto mapped = table.supervised(profile.weight_bits).pixels;
  const auto supervised = std::ranges::count(mapped, std::uint8_t{1});
  const RowReach reach = reach_of(table, profile.weight_bits);
  require(report.spacing_x == 1 << table.spacing_x_log2() && report.spacing_y == 1 << table.spacing_y_log2() &&
              report.pool_bytes == table.pool_bytes() && report.crc == table.crc() &&
              report.pixels == std::ssize(mapped) && report.supervised() == supervised &&
              report.reach.behind >= reach.behind && report.reach.ahead >= reach.ahead &&
              lookahead == report.lookahead && report.error_largest_px >= 0 && report.error_99_px >= 0 &&
              std::ranges::all_of(report.by_reason, [&](auto n) { return n >= 0 && n <= report.pixels; }),
          "a report that is not true of it");
}

/// What only a file that was made wrongly does: an altered one has a wrong CRC. Throws FileError.
void check_maps(const MapSet& set, const std::string& file, const std::string& expected) {
  const auto fail = [&](const std::string& place, const std::string& found) {
    throw FileError(file, place, found, expected);
  };
  const auto profile = std::ranges::find(profiles(), set.profile, &MachineProfile::name);
  if (profile == profiles().end()) fail("byte 12", fmt::format("a profile that is none of {}", profile_names()));
  if (set.image_width < 1 || set.image_width > profile->largest_image_width() || set.image_height < 1 ||
      set.image_height > profile->largest_image_height()) {
    fail("byte 28", fmt::format("images of {}x{} pixels", set.image_width, set.image_height));
  }
  const auto scans = scans_of(*profile, set.image_width, set.image_height);
  if (set.maps.size() != scans.size()) fail("byte 36", fmt::format("{} tables", set.maps.size()));
  RowReach reach;  // of both fields: they have one LOOKAHEAD
  for (const CompiledMap& map : set.maps) {
    reach = {std::max(reach.behind, map.report.reach.behind), std::max(reach.ahead, map.report.reach.ahead)};
  }
  for (std::size_t i = 0; i < scans.size(); ++i) {
    try {
      check_table(set.maps[i], *profile, scans[i], lookahead_for(*profile, reach));
    } catch (const std::invalid_argument& error) {
      fail(fmt::format("table {}", i), error.what());
    }
  }
  if (set.rig.empty()) return;
  const auto cameras = calib::rig_from_yaml(set.rig, file + ": its rig").cameras;
  if (cameras.size() != 2) fail("its rig", fmt::format("{} cameras", cameras.size()));
  const CameraPair pair(cameras[0], cameras[1]);
  for (std::size_t i = 0; i < set.maps.size(); ++i) {
    constexpr double kRounding_px = 1.0 / 32;  // of a control point
    const auto& [table, report] = set.maps[i];
    if (table.facts().areas.empty() || areas_may_be_true(table, pair, report.error_largest_px + kRounding_px)) continue;
    fail(fmt::format("table {}", i), "areas that are smaller than its rig and control points say");
  }
}

}  // namespace

void save_maps(const MapSet& maps, const std::filesystem::path& path) {
  std::vector<std::uint32_t> words{kMagic, kVersion, 0};
  std::array<char, kNameWords * 4> name{};
  std::copy_n(maps.profile.begin(), std::min(maps.profile.size(), name.size()), name.begin());
  for (std::size_t i = 0; i < name.size(); i += 4) {
    std::uint32_t word = 0;
    for (std::size_t j = 0; j < 4; ++j) word |= std::uint32_t{static_cast<std::uint8_t>(name[i + j])} << (8 * j);
    words.push_back(word);
  }
  words.push_back(static_cast<std::uint32_t>(maps.image_width));
  words.push_back(static_cast<std::uint32_t>(maps.image_height));
  words.push_back(static_cast<std::uint32_t>(maps.maps.size()));
  append_text(words, maps.skin);
  append_text(words, maps.rig);
  for (const CompiledMap& map : maps.maps) {
    words.push_back(static_cast<std::uint32_t>(map.table.geometry().scan));
    append_text(words, to_json(map.report).dump());
    words.push_back(static_cast<std::uint32_t>(map.table.words().size()));
    words.insert(words.end(), map.table.words().begin(), map.table.words().end());
  }
  words[2] = static_cast<std::uint32_t>(words.size() + 1);
  words.push_back(crc32_words(words));
  std::vector<std::uint8_t> bytes;
  bytes.reserve(words.size() * 4);
  for (const std::uint32_t word : words) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(word >> shift));
  }
  write_file(path, bytes);
}

bool is_table(std::span<const std::uint8_t> file) {
  std::uint32_t magic = 0;
  for (std::size_t i = 0; i < std::min(sizeof magic, file.size()); ++i) magic |= std::uint32_t{file[i]} << (8 * i);
  return magic == kMagic;
}

void add_skin_files(const std::filesystem::path& skin, const std::string& expected, Crc32& crc) {
  const auto add = [&](std::span<const std::uint8_t> bytes) {
    crc.add_word(static_cast<std::uint32_t>(bytes.size()));
    crc.add(bytes);
  };
  const auto bytes = read_file(skin, expected);
  add(bytes);
  if (is_table(bytes)) return;
  for (const std::filesystem::path& mesh : files_named_in(skin)) add(read_file(mesh, expected));
}

MapSet load_maps(const std::filesystem::path& path) {
  const std::string file = path.string();
  const std::string expected = fmt::format("a mapping table made by `horopter map` (.hmap, version {})", kVersion);
  const auto bytes = read_file(path, expected);
  std::vector<std::uint32_t> words(bytes.size() / 4);
  for (std::size_t i = 0; i < words.size() * 4; ++i) words[i / 4] |= std::uint32_t{bytes[i]} << (i % 4 * 8);
  if (words.empty() || words[0] != kMagic) throw FileError(file, "byte 0", "not a mapping table", expected);
  if (words.size() > 1 && words[1] != kVersion) {
    throw FileError(file, "byte 4", fmt::format("version {}; make the map again with `horopter map`", words[1]),
                    expected);
  }
  if (words.size() < kHeaderWords + 1 || bytes.size() < std::size_t{words[2]} * 4) {
    throw FileError(file, fmt::format("byte {}", bytes.size()), "the file is truncated",
                    words.size() > 2 ? fmt::format("{} bytes", std::size_t{words[2]} * 4) : expected);
  }
  if (bytes.size() != std::size_t{words[2]} * 4) {
    throw FileError(file, fmt::format("byte {}", std::size_t{words[2]} * 4), "more data than the header tells",
                    expected);
  }
  if (crc32_words(std::span(words).first(words.size() - 1)) != words.back()) {
    throw FileError(file, fmt::format("byte {}", bytes.size() - 4), "wrong CRC: the file was altered", expected);
  }
  // The CRC holds: what follows can only fail for a file that was made wrongly.
  std::size_t at = 3;
  const auto take = [&](std::size_t count) {
    if (count > words.size() - 1 - at) throw FileError(file, fmt::format("byte {}", at * 4), "bad lengths", expected);
    at += count;
    return std::span(words).subspan(at - count, count);
  };
  const auto text = [&](std::size_t length) {
    std::string result;
    for (const std::uint32_t word : take((length + 3) / 4)) {
      for (int shift = 0; shift < 32; shift += 8) result += static_cast<char>(word >> shift);
    }
    result.resize(length);
    return result;
  };
  MapSet set;
  set.profile = text(kNameWords * 4);
  set.profile.resize(std::strlen(set.profile.c_str()));
  set.image_width = static_cast<int>(take(1)[0]);
  set.image_height = static_cast<int>(take(1)[0]);
  const std::uint32_t tables = take(1)[0];
  if (tables > 2) throw FileError(file, "byte 36", fmt::format("{} tables", tables), expected);
  set.skin = text(take(1)[0]);
  set.rig = text(take(1)[0]);
  for (std::uint32_t i = 0; i < tables; ++i) {
    const std::size_t place = at * 4;
    try {
      const std::uint32_t scan = take(1)[0];
      if (scan > 2) throw std::invalid_argument(fmt::format("scan {}", scan));
      const std::string report = text(take(1)[0]);
      const auto table_words = take(take(1)[0]);
      MapTable table({table_words.begin(), table_words.end()}, static_cast<Scan>(scan));
      set.maps.push_back({std::move(table), map_report_from_json(nlohmann::json::parse(report))});
    } catch (const std::invalid_argument& error) {
      throw FileError(file, fmt::format("byte {}, table {}", place, i), error.what(), expected);
    } catch (const std::out_of_range& error) {
      throw FileError(file, fmt::format("byte {}, table {}", place, i), error.what(), expected);
    } catch (const nlohmann::json::exception& error) {
      throw FileError(file, fmt::format("byte {}, table {}", place, i), error.what(), expected);
    }
  }
  check_maps(set, file, expected);
  return set;
}

std::string crc_text(std::uint32_t crc) { return fmt::format("{:08x}", crc); }

std::string_view scan_name(Scan scan) {
  switch (scan) {
    case Scan::progressive:
      return "progressive";
    case Scan::even_field:
      return "even";
    case Scan::odd_field:
      return "odd";
  }
  return "?";
}

nlohmann::ordered_json to_json(const MapReport& report) {
  nlohmann::ordered_json unsupervised;
  for (int i = 1; i < kReasonCount; ++i) unsupervised[reason_name(static_cast<Reason>(i))] = report.by_reason[i];
  return {{"spacing_x", report.spacing_x},
          {"spacing_y", report.spacing_y},
          {"bytes", report.pool_bytes},
          {"crc", crc_text(report.crc)},
          {"rows_behind", report.reach.behind},
          {"rows_ahead", report.reach.ahead},
          {"lookahead", report.lookahead},
          {"pixels", report.pixels},
          {"checked", report.checked},
          {"supervised", report.supervised()},
          {"unsupervised", std::move(unsupervised)},
          {"error_99_px", report.error_99_px},
          {"error_largest_px", report.error_largest_px},
          {"rounded_largest_px", report.rounded_largest_px}};
}

MapReport map_report_from_json(const nlohmann::json& json) {
  MapReport report;
  report.spacing_x = json.at("spacing_x");
  report.spacing_y = json.at("spacing_y");
  report.pool_bytes = json.at("bytes");
  report.crc = static_cast<std::uint32_t>(std::stoul(json.at("crc").get<std::string>(), nullptr, 16));
  report.reach = {json.at("rows_behind"), json.at("rows_ahead")};
  report.lookahead = json.at("lookahead");
  report.pixels = json.at("pixels");
  report.checked = json.at("checked");
  report.by_reason[0] = json.at("supervised");
  for (int i = 1; i < kReasonCount; ++i) {
    report.by_reason[i] = json.at("unsupervised").at(std::string(reason_name(static_cast<Reason>(i))));
  }
  report.error_99_px = json.at("error_99_px");
  report.error_largest_px = json.at("error_largest_px");
  report.rounded_largest_px = json.at("rounded_largest_px");
  return report;
}

nlohmann::ordered_json to_json(const MapSet& maps) {
  nlohmann::ordered_json json{
      {"profile", maps.profile}, {"width", maps.image_width}, {"height", maps.image_height}, {"skin", maps.skin}};
  if (!maps.rig.empty()) json["rig_crc"] = crc_text(maps.rig_crc());
  for (const CompiledMap& map : maps.maps) {
    nlohmann::ordered_json table{{"scan", scan_name(map.table.geometry().scan)},
                                 {"width", map.table.geometry().width},
                                 {"height", map.table.geometry().height},
                                 {"columns", map.table.columns()},
                                 {"rows", map.table.rows()}};
    table.update(to_json(map.report));
    json["tables"].push_back(std::move(table));
  }
  return json;
}

}  // namespace horopter
