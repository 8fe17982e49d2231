// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/loader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <optional>
#include <thread>

#include "horopter/base/error.hpp"
#include "horopter/machine/configuration.hpp"
#include "horopter/machine/inspection.hpp"
#include "horopter/machine/registers.hpp"

namespace horopter {
namespace {

namespace reg = registers;

bool is_running(Device& device) { return reg::status::kRunning.get(device.read(reg::status::kAddress)) != 0; }

/// The slot that frames are made with, and the selected one.
std::array<std::uint32_t, 2> slots_in_use(Device& device) {
  return {reg::map_status::kActiveSlot.get(device.read(reg::map_status::kAddress)),
          reg::table_select::kSlot.get(device.read(reg::table_select::kAddress))};
}

std::vector<int> free_slots(Device& device) {
  const auto [active, selected] = slots_in_use(device);
  std::vector<int> slots;
  for (std::uint32_t slot = 0; slot < reg::kNoSlot; ++slot) {
    if (slot != active && slot != selected) slots.push_back(static_cast<int>(slot));
  }
  return slots;
}

/// A place in the pool.
struct Place {
  std::size_t base_word64 = 0;
  std::size_t end_word64 = 0;
};

/// Where a machine that runs refuses tables. It must not be asked by trying: what it refuses is a fault.
std::vector<Place> places_in_use(Device& device) {
  std::vector<Place> places;
  if (!is_running(device)) return places;
  const auto valid = device.read(reg::map_valid::kAddress);
  for (const std::uint32_t slot : slots_in_use(device)) {
    if (slot == reg::kNoSlot || (valid >> slot & 1U) == 0) continue;
    write_checked(device, {reg::map_slot::kAddress, slot});
    const auto extent = device.read(reg::map_extent::kAddress);
    const std::size_t base = reg::map_extent::kBaseWord64.get(extent);
    places.push_back({base, base + extent_bytes(extent) / 8});
  }
  return places;
}

/// All tables from `base_word64` on. False: one of them would be in the place of one in use.
bool upload_from(Device& device, std::size_t base_word64, const MapSet& maps, const std::vector<int>& slots,
                 const Settings& settings) {
  for (std::size_t i = 0; i < maps.maps.size(); ++i) {
    const MapTable& table = maps.maps[i].table;
    const auto error = upload_table(device, slots[i], base_word64, table, undecidable_limit(table, settings));
    if (error == kUploadInUse) return false;
    if (error != 0) {
      throw DeviceError(
          fmt::format("the machine refuses the table in slot {}: {}", slots[i], upload_error_text(error)));
    }
    base_word64 += table.pool_bytes() / 8;
  }
  return true;
}

void upload_all(Device& device, const Build& build, const MapSet& maps, const std::vector<int>& slots,
                const Settings& settings) {
  std::size_t bytes = 0;
  for (const CompiledMap& map : maps.maps) bytes += map.table.pool_bytes();
  if (bytes > build.pool_bytes) {
    throw DeviceError(fmt::format("the tables take {} bytes, the machine's pool has {}; expected tables that fit",
                                  bytes, build.pool_bytes));
  }
  const auto in_use = places_in_use(device);
  // Where one table is in use there is room below it, or above it, or nowhere.
  for (const std::size_t base : {std::size_t{0}, (build.pool_bytes - bytes) / 8}) {
    const auto overlaps = [&](const Place& place) {
      return place.base_word64 < base + bytes / 8 && base < place.end_word64;
    };
    if (std::ranges::none_of(in_use, overlaps) && upload_from(device, base, maps, slots, settings)) return;
  }
  throw DeviceError(
      fmt::format("the tables of {} bytes have no room in the pool of {} beside the one in use; expected smaller ones, "
                  "or --stop-first, which stops the machine and takes the place of the one in use",
                  bytes, build.pool_bytes));
}

/// Who gives fields selects two slots in turn, and nobody else knows which: while one is in use, so is the other.
bool may_switch_tables(Device& device, const Build& build) {
  return build.profile->takes_fields() && std::popcount(device.read(reg::map_valid::kAddress)) > 1;
}

/// Of a machine that is stopped. A field that still selects one of the slots has no table then, which is a fault.
void clear_slots(Device& device) {
  const auto valid = device.read(reg::map_valid::kAddress);
  for (std::uint32_t slot = 0; slot < reg::kNoSlot; ++slot) {
    if ((valid >> slot & 1U) == 0) continue;
    write_checked(device, {reg::map_slot::kAddress, slot});
    device.write(reg::map_control::kAddress, reg::map_control::kStart.put(1));  // the begin of an upload clears it
  }
}

/// Where nothing could be decided on one skin says nothing of another; and who stood before one may stand behind another,
/// where nobody looks. A machine that stops forgets what it was taught, and waits for a restart.
bool must_stop_for(Device& device, const std::vector<LoadReport::Table>& tables) {
  const auto blocks = device.read(reg::blocks::kAddress);
  const bool taught = reg::blocks::kWatch.get(blocks) != 0 || reg::blocks::kTeach.get(blocks) != 0;
  if (!taught && reg::interlock::kByItself.get(device.read(reg::interlock::kAddress)) != 0) return false;
  const auto in_use = device.read(reg::frame_table_crc::kAddress);
  return std::ranges::find(tables, in_use, &LoadReport::Table::crc) == tables.end();
}

/// A bit of a register, or its parity alone, fell over: a fault until it is written.
bool has_spoiled_register(Device& device) {
  return reg::faults_machine::kSettings.get(device.read(reg::faults_machine::kAddress)) != 0 &&
         !says_safe(device.read(reg::status::kAddress));
}

/// MAP_UNDECIDABLE_LIMIT is that of the table uploaded last. Each table has a limit of its own: where frames are made with
/// another one than those that come, it says nothing of what is set.
bool is_other_limit(Device& device, const std::vector<LoadReport::Table>& tables, std::uint32_t before,
                    std::uint32_t limit) {
  if (before == limit) return false;
  const auto in_use = device.read(reg::frame_table_crc::kAddress);
  return in_use == 0 || std::ranges::find(tables, in_use, &LoadReport::Table::crc) != tables.end();
}

/// Best effort, after an upload that failed: the next one compares with it.
void put_limit_back(Device& device, std::uint32_t limit) {
  try {
    device.write(reg::map_undecidable_limit::kAddress, limit);
  } catch (const DeviceError&) {
    // The error before it is told.
  }
}

/// Whether a frame begins with the table while we wait for it.
bool wait_for_table(Device& device, int slot, std::chrono::milliseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  do {
    const auto active = reg::map_status::kActiveSlot.get(device.read(reg::map_status::kAddress));
    if (static_cast<int>(active) == slot) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  } while (std::chrono::steady_clock::now() < end);
  return false;
}

}  // namespace

Settings settings_for(Settings settings, const MachineProfile& profile, const MapSet& maps) {
  settings.proof = with_knowledge(settings.proof, profile, maps.tables(), maps.rig, maps.skin);
  return settings;
}

LoadReport load(Device& device, const Build& build, const MapSet& maps, const Settings& settings, bool stop_first,
                std::chrono::milliseconds frame_timeout) {
  check_rule(build, settings.decision);
  LoadReport report;
  bool running = is_running(device);
  // What an error says of the machine. A write whose answer is lost may have been carried out.
  constexpr const char* kNotKnown = "what the machine does now is not known: `horopter status` says it";
  const char* state =
      running ? "the table that was in use stays in use" : "the machine was not running, and is not started";
  const auto stop = [&] {
    report.stopped = report.stopped || running;
    if (running) state = kNotKnown;
    device.write(reg::control::kAddress, 0);
    if (running) state = "the machine is stopped, and says not safe, until an upload is complete";
    running = false;
  };
  std::optional<std::uint32_t> limit_before;
  try {
    if (stop_first) stop();
    const auto slots = free_slots(device);
    const ScanGeometry& geometry = maps.maps.at(0).table.geometry();
    // Before the tables: where a setting has no such value, none is touched.
    auto words = configuration(device, *build.profile, settings_for(settings, *build.profile, maps),
                               {geometry.width, geometry.height, maps.lookahead()});
    if (may_switch_tables(device, build)) {
      stop();
      clear_slots(device);
    }
    limit_before = device.read(reg::map_undecidable_limit::kAddress);
    for (std::size_t i = 0; i < maps.maps.size(); ++i) {
      const MapTable& table = maps.maps[i].table;
      report.tables.push_back({slots[i], table.crc(), table.pool_bytes()});
    }
    const bool other_limit =
        is_other_limit(device, report.tables, *limit_before, undecidable_limit(maps.maps.back().table, settings));
    // Before the tables: if we are killed among them, the limit is in its register, and the next upload sees no change.
    if (other_limit) stop();
    upload_all(device, build, maps, slots, settings);

    // Whether the machine watches for what goes blind is decided by who teaches it.
    std::erase_if(words, [](const RegisterWord& word) { return word.address == reg::blocks::kAddress; });
    if (other_limit) report.changed.push_back(register_name(reg::map_undecidable_limit::kAddress));
    bool differs = false;
    for (const RegisterWord& word : words) {
      if (device.read(word.address) == word.value) continue;
      differs = true;
      report.changed.push_back(register_name(word.address));
    }
    if (differs || must_stop_for(device, report.tables) || has_spoiled_register(device)) stop();
    // All of them: of one whose parity alone fell over the value is right.
    if (!running) {
      for (const RegisterWord& word : words) write_checked(device, word);
    }
    if (running) state = kNotKnown;
    write_checked(device, {reg::table_select::kAddress, static_cast<std::uint32_t>(report.tables.front().slot)});
    if (!running) {
      device.write(reg::faults_cameras::kAddress, 0xFFFFFFFFU);
      device.write(reg::faults_machine::kAddress, 0xFFFFFFFFU);
      state = kNotKnown;
      device.write(reg::control::kAddress, reg::control::kEnable.put(1));
      running = true;
    }
    if (reg::status::kBadGeometry.get(device.read(reg::status::kAddress)) != 0) {
      throw DeviceError(
          fmt::format("the machine refuses frames of {}x{} px with LOOKAHEAD {}; expected it to take them",
                      geometry.width, geometry.height, maps.lookahead()));
    }
    report.active = wait_for_table(device, report.tables.front().slot, frame_timeout);
    return report;
  } catch (const ResetError& error) {
    throw DeviceError(fmt::format("{}; {}", error.what(), kNotKnown));
  } catch (const DeviceError& error) {
    if (limit_before) put_limit_back(device, *limit_before);
    throw DeviceError(fmt::format("{}; {}", error.what(), state));
  }
}

}  // namespace horopter
