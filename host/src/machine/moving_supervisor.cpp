// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/moving_supervisor.hpp"

#include <fmt/format.h>

#include <utility>

#include "horopter/base/error.hpp"
#include "horopter/map/map_json.hpp"

namespace horopter {

namespace {

Settings settings_for(Settings settings, const MachineProfile& profile, const MovingMaps& maps) {
  settings.proof = with_knowledge(settings.proof, profile, maps.tables(), maps.rig, "the moving skin's rig");
  return settings;
}

}  // namespace

MovingSupervisor::MovingSupervisor(std::unique_ptr<Device> device, const MachineProfile& profile, MovingMaps maps,
                                   const Settings& settings)
    : maps_(std::move(maps)),
      monitor_(std::move(device), profile, settings_for(settings, profile, maps_)),
      settled_(!settings.proof.needed) {
  for (const MovingStep& step : maps_.steps) {
    if (const std::size_t bytes = step.map.table.pool_bytes(); bytes > monitor_.pool_bytes() / 2) {
      throw DeviceError(
          fmt::format("the table at {:.3f} s, of {} bytes, is more than half of the machine's pool of {}: "
                      "two tables must fit it",
                      step.time_s, bytes, monitor_.pool_bytes()));
    }
  }
  const ScanGeometry& geometry = maps_.geometry();
  monitor_.start(geometry.width, geometry.height, maps_.lookahead);
  monitor_.upload(0, maps_.steps[0].map.table, 0);
  monitor_.select(0);
}

void MovingSupervisor::begin(const Image& left, const Image& right) {
  const std::size_t step = maps_.step_of(frame_);
  const int slot = loaded_[0] == step ? 0 : 1;
  monitor_.begin(left, right);
  started_.push_back({step, slot});
  ++frame_;
  const std::size_t next = maps_.step_of(frame_);
  const int other = 1 - slot;
  if (loaded_[slot] == next) return;
  // Until this frame's output begins, the table before is in use.
  monitor_.wait_for_table(slot);
  if (loaded_[other] != next) {
    loaded_[other] = SIZE_MAX;
    const std::size_t half_word64 = monitor_.pool_bytes() / 16;
    monitor_.upload(other, maps_.steps[next].map.table, static_cast<std::size_t>(other) * half_word64);
    loaded_[other] = next;
  }
  monitor_.select(other);
}

FrameResult MovingSupervisor::finish() {
  FrameResult result = monitor_.finish();
  const auto [step, slot] = started_.front();
  started_.pop_front();
  const MapTable& table = maps_.steps[step].map.table;
  if (result.table != slot || result.table_crc != table.crc()) {
    throw DeviceError(fmt::format("frame {} was made by table {} of CRC {}, not by its own, {} of CRC {}",
                                  result.sequence, result.table, crc_text(result.table_crc), slot,
                                  crc_text(table.crc())));
  }
  result.scan = table.geometry().scan;
  result.skin_time_s = maps_.steps[step].time_s;
  return result;
}

std::vector<FrameResult> MovingSupervisor::process(const Image& left, const Image& right) {
  if (!settled_) {
    settled_ = true;
    const bool whole = maps_.geometry().scan == Scan::progressive;
    const auto show = [&] {
      return whole ? monitor_.process(left, right) : monitor_.process(field_of(left, 0), field_of(right, 0));
    };
    FrameResult shown_last = show();
    const Monitor::Repeated repeated(monitor_);
    for (int shown = 1; monitor_.shows_again(shown, shown_last); ++shown) shown_last = show();
    return pass(left, right);
  }
  return pass(left, right);
}

std::vector<FrameResult> MovingSupervisor::pass(const Image& left, const Image& right) {
  std::vector<FrameResult> results;
  if (maps_.geometry().scan == Scan::progressive) {
    begin(left, right);
    results.push_back(finish());
    return results;
  }
  for (const int parity : {0, 1}) {
    begin(field_of(left, parity), field_of(right, parity));
    results.push_back(finish());
  }
  return results;
}

}  // namespace horopter
