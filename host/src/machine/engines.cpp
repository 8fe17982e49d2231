// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/engines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "horopter/base/error.hpp"
#include "horopter/machine/native_device.hpp"
#include "horopter/machine/serial_device.hpp"
#include "horopter/machine/serial_port.hpp"
#include "horopter/machine/uio_device.hpp"

namespace horopter {
namespace {

constexpr int kUsualBaud = 1'000'000;

struct Engine {
  std::string_view name;
  DeviceFactory make;
};

std::vector<Engine>& engines() {
  static std::vector<Engine> list{{"native", make_native_device}};
  return list;
}

/// All of a text as a number.
template <class Number>
std::optional<Number> number_of(std::string_view text, int base = 10) {
  Number number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// A text in two at its last `mark`; the second part is empty where there is none.
std::pair<std::string_view, std::string_view> split(std::string_view text, char mark) {
  const auto at = text.rfind(mark);
  return at == std::string_view::npos ? std::pair{text, std::string_view()}
                                      : std::pair{text.substr(0, at), text.substr(at + 1)};
}

/// PORT[@BAUD]
struct SerialPlace {
  std::string port;
  int baud = kUsualBaud;
};

SerialPlace serial_place(std::string_view place) {
  const auto [port, rate] = split(place, '@');
  const auto baud = rate.data() == nullptr ? kUsualBaud : number_of<int>(rate);
  const auto rates = SerialPort::rates();
  if (port.empty() || !baud || std::ranges::find(rates, *baud) == rates.end()) {
    throw UsageError(
        fmt::format("engine 'serial:{}'; expected serial:PORT or serial:PORT@BAUD, as "
                    "serial:/dev/ttyUSB0@{}; BAUD one of: {}",
                    place, kUsualBaud, fmt::join(rates, ", ")));
  }
  return {std::string(port), *baud};
}

/// REGISTERS[@OFFSET][,LEFT,RIGHT,STATES,RUNS]
UioDevice::Paths uio_place(std::string_view place) {
  std::vector<std::string> parts(1);
  for (const char c : place) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  const auto [registers, offset_text] = split(parts.front(), '@');
  const auto offset = offset_text.data() == nullptr   ? std::optional<std::uint64_t>(0)
                      : offset_text.starts_with("0x") ? number_of<std::uint64_t>(offset_text.substr(2), 16)
                                                      : number_of<std::uint64_t>(offset_text);
  const bool empty = registers.empty() || std::ranges::any_of(parts, &std::string::empty);
  if (empty || !offset || (parts.size() != 1 && parts.size() != 5)) {
    throw UsageError(
        fmt::format("engine 'uio:{}'; expected uio:REGISTERS or uio:REGISTERS,LEFT,RIGHT,STATES,RUNS, as "
                    "uio:/dev/uio0,/dev/left,/dev/right,/dev/states,/dev/runs; REGISTERS@OFFSET where they "
                    "do not begin the mapping",
                    place));
  }
  UioDevice::Paths paths;
  paths.registers = registers;
  paths.register_offset = *offset;
  if (parts.size() == 5) {
    paths.left = parts[1];
    paths.right = parts[2];
    paths.states = parts[3];
    paths.runs = parts[4];
  }
  return paths;
}

std::string all_names() {
  return fmt::format("{}, uio:REGISTERS[,LEFT,RIGHT,STATES,RUNS], serial:PORT[@BAUD]", fmt::join(engine_names(), ", "));
}

constexpr std::string_view kSerial = "serial:";
constexpr std::string_view kUio = "uio:";

}  // namespace

void register_engine(std::string_view name, DeviceFactory factory) { engines().push_back({name, factory}); }

std::vector<std::string> engine_names() {
  std::vector<std::string> names;
  for (const Engine& engine : engines()) names.emplace_back(engine.name);
  return names;
}

std::string engine_help() {
  return fmt::format(
      "{}; native: C++ on this CPU; rtl: the co-simulated hardware; uio: registers and DMA devices of "
      "this computer; serial: a board, {} baud unless said otherwise",
      all_names(), kUsualBaud);
}

bool is_somewhere(std::string_view engine) { return engine.starts_with(kSerial) || engine.starts_with(kUio); }

void check_engine(std::string_view engine) {
  if (engine.starts_with(kSerial)) {
    serial_place(engine.substr(kSerial.size()));
    return;
  }
  if (engine.starts_with(kUio)) {
    uio_place(engine.substr(kUio.size()));
    return;
  }
  if (std::ranges::find(engines(), engine, &Engine::name) != engines().end()) return;
  const std::string names = all_names();
  if (engine == "rtl") {
    throw UsageError("this build has no engine 'rtl': it was configured with HOROPTER_COSIM=OFF; there is: " + names);
  }
  throw UsageError(fmt::format("unknown engine '{}'; expected one of: {}", engine, names));
}

std::unique_ptr<Device> make_device(std::string_view engine, const MachineProfile& profile) {
  check_engine(engine);
  if (engine.starts_with(kSerial)) {
    const SerialPlace place = serial_place(engine.substr(kSerial.size()));
    return std::make_unique<SerialDevice>(std::make_unique<SerialPort>(place.port, place.baud), place.port);
  }
  if (engine.starts_with(kUio)) return std::make_unique<UioDevice>(uio_place(engine.substr(kUio.size())));
  return std::ranges::find(engines(), engine, &Engine::name)->make(profile);
}

}  // namespace horopter
