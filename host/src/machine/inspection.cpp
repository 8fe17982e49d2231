// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/inspection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "horopter/machine/register_fields.hpp"
#include "horopter/map/map_json.hpp"

namespace horopter {
namespace {

namespace reg = registers;

constexpr int kFrameReads = 10;

/// Registers one after the other, that can be read at once.
struct Block {
  std::uint32_t address = 0;
  std::size_t registers = 0;
};

std::vector<Block> readable_blocks() {
  std::vector<Block> blocks;
  for (const reg::Register& r : reg::kRegisters) {
    if (r.access == reg::Access::kWriteStream) continue;
    if (blocks.empty() || blocks.back().address + 4 * blocks.back().registers != r.address)
      blocks.push_back({r.address, 0});
    ++blocks.back().registers;
  }
  return blocks;
}

void read_block(Device& device, const Block& block, MachineStatus& status) {
  const auto words = device.read_all(block.address, block.registers);
  for (std::size_t i = 0; i < words.size(); ++i)
    status.words[block.address + static_cast<std::uint32_t>(4 * i)] = words[i];
}

std::vector<StoredTable> read_tables(Device& device, const MachineStatus& status) {
  std::vector<StoredTable> tables;
  const std::uint32_t valid = status.word(reg::map_valid::kAddress);
  const std::uint32_t selected = status.word(reg::map_slot::kAddress);
  for (std::uint32_t slot = 0; slot < reg::kNoSlot; ++slot) {
    if ((valid >> slot & 1U) == 0) continue;
    device.write(reg::map_slot::kAddress, slot);
    tables.push_back({static_cast<int>(slot), device.read(reg::map_crc::kAddress),
                      extent_bytes(device.read(reg::map_extent::kAddress))});
  }
  if (!tables.empty()) device.write(reg::map_slot::kAddress, selected);
  return tables;
}

std::string upper(std::string_view name) {
  std::string text(name);
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// Fields of 32 bits that are no number.
bool is_hexadecimal(std::uint32_t address) {
  return address == reg::id::kAddress || address == reg::map_crc::kAddress || address == reg::frame_table_crc::kAddress;
}

nlohmann::ordered_json table_json(const StoredTable& table) {
  return {{"slot", table.slot}, {"crc", crc_text(table.crc)}, {"bytes", table.bytes}};
}

}  // namespace

bool MachineStatus::running() const { return reg::status::kRunning.get(word(reg::status::kAddress)) != 0; }

bool MachineStatus::live() const { return reg::mode::kLive.get(word(reg::mode::kAddress)) != 0; }

bool MachineStatus::test_input() const { return reg::mode::kTestInput.get(word(reg::mode::kAddress)) != 0; }

std::size_t extent_bytes(std::uint32_t extent) {
  const std::uint32_t words = reg::map_extent::kEndWord64.get(extent) - reg::map_extent::kBaseWord64.get(extent);
  return std::size_t{8} * ((words - 1) % 0x10000U + 1);  // all of the largest pool is 0
}

bool says_safe(std::uint32_t status) {
  return reg::status::kSafe.get(status) != 0 && reg::status::kUnsafe.get(status) == 0;
}

bool MachineStatus::safe() const { return says_safe(word(reg::status::kAddress)); }

std::optional<int> MachineStatus::active_slot() const {
  const auto slot = reg::map_status::kActiveSlot.get(word(reg::map_status::kAddress));
  if (!running() || slot == reg::kNoSlot) return std::nullopt;
  return static_cast<int>(slot);
}

std::optional<StoredTable> MachineStatus::active_table() const {
  const auto found = std::ranges::find(tables, active_slot().value_or(-1), &StoredTable::slot);
  if (found == tables.end()) return std::nullopt;
  return *found;
}

Faults MachineStatus::faults() const {
  return {word(reg::faults_cameras::kAddress), word(reg::faults_machine::kAddress)};
}

Faults MachineStatus::frame_faults() const {
  return {word(reg::frame_faults_cameras::kAddress), word(reg::frame_faults_machine::kAddress)};
}

MachineStatus read_status(Device& device) {
  MachineStatus status;
  status.build = find_build(device);
  for (const Block& block : readable_blocks()) {
    const bool has_frame = block.address <= reg::frame_sequence::kAddress &&
                           reg::frame_sequence::kAddress < block.address + 4 * block.registers;
    read_block(device, block, status);
    for (int i = 0;
         has_frame && device.read(reg::frame_sequence::kAddress) != status.word(reg::frame_sequence::kAddress); ++i) {
      status.one_frame = i < kFrameReads;
      if (!status.one_frame) break;
      read_block(device, block, status);
    }
  }
  status.tables = read_tables(device, status);
  // The other registers take a while on a slow line: no older word than theirs says safe.
  status.words[reg::status::kAddress] = device.read(reg::status::kAddress);
  return status;
}

nlohmann::ordered_json status_json(const MachineStatus& status) {
  const Build& build = status.build;
  nlohmann::ordered_json json;
  json["build"] = {{"profile", build.profile->name},
                   {"thesis", build.thesis},
                   {"compete", build.compete},
                   {"pool_bytes", build.pool_bytes},
                   {"clock_khz", status.word(reg::build_clock::kAddress)}};
  json["running"] = status.running();
  json["safe"] = status.safe();
  json["live"] = status.live();
  json["test_input"] = status.test_input();
  json["table"] = nullptr;
  if (const auto slot = status.active_slot()) {
    json["table"] = {{"slot", *slot}};
    if (const auto table = status.active_table()) json["table"] = table_json(*table);
    json["table"]["width_px"] = status.word(reg::width::kAddress);
    json["table"]["height_rows"] = status.word(reg::height::kAddress);
  }
  json["tables"] = nlohmann::ordered_json::array();
  for (const StoredTable& table : status.tables) json["tables"].push_back(table_json(table));
  const auto frame = status.word(reg::frame_status::kAddress);
  json["frame"] = {{"sequence", status.word(reg::frame_sequence::kAddress)},
                   {"alarm", reg::frame_status::kAlarm.get(frame) != 0},
                   {"alarm_seen", reg::frame_status::kSeen.get(frame) != 0},
                   {"safe", reg::frame_status::kSafe.get(frame) != 0},
                   {"table", reg::frame_status::kSlot.get(frame)},
                   {"table_crc", crc_text(status.word(reg::frame_table_crc::kAddress))},
                   {"skin_pixels", status.word(reg::frame_skin::kAddress)},
                   {"undecidable_pixels", status.word(reg::frame_undecidable::kAddress)},
                   {"unsupervised_pixels", status.word(reg::frame_unsupervised::kAddress)},
                   {"one_frame", status.one_frame}};
  json["faults"] = status.faults().names();
  json["frame_faults"] = status.frame_faults().names();
  for (const reg::Register& r : reg::kRegisters) {
    const auto found = status.words.find(r.address);
    if (found == status.words.end()) continue;
    auto& fields = json["registers"][std::string(r.name)];
    for (const auto& f : reg::kRegisterFields) {
      if (f.address == r.address) fields[std::string(f.name)] = f.field.get(found->second);
    }
  }
  return json;
}

std::vector<std::string> register_lines(const MachineStatus& status) {
  std::vector<std::string> lines;
  for (const reg::Register& r : reg::kRegisters) {
    const auto found = status.words.find(r.address);
    if (found == status.words.end()) continue;
    std::string line = fmt::format("{:22} {:03x} ", upper(r.name), r.address);
    const bool faults = r.name.find("faults") != std::string_view::npos;
    for (const auto& f : reg::kRegisterFields) {
      if (f.address != r.address) continue;
      const std::uint32_t value = f.field.get(found->second);
      if (faults && value == 0) continue;
      if (faults) {
        line += fmt::format(" {}", f.name);
      } else if (is_hexadecimal(r.address)) {
        line += fmt::format(" {} {:08x}", f.name, value);
      } else {
        line += fmt::format(" {} {}", f.name, value);
      }
    }
    if (faults && found->second == 0) line += " none";
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string fault_text(std::string_view name) {
  for (const auto& f : reg::kRegisterFields) {
    const bool of_faults = f.address == reg::faults_cameras::kAddress || f.address == reg::faults_machine::kAddress;
    if (of_faults && f.name == name) return std::string(f.doc);
  }
  return {};
}

}  // namespace horopter
