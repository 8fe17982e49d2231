// SPDX-License-Identifier: Apache-2.0
// Mapping tables and their reports as JSON, for `--json` and for the .hmap file.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "horopter/map/map.hpp"

namespace horopter {

/// Eight hexadecimal digits, as everywhere a table is named by its CRC.
std::string crc_text(std::uint32_t crc);
std::string_view scan_name(Scan scan);
nlohmann::ordered_json to_json(const MapReport& report);
MapReport map_report_from_json(const nlohmann::json& json);
nlohmann::ordered_json to_json(const MapSet& maps);

}  // namespace horopter
