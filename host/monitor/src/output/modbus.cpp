// SPDX-License-Identifier: Apache-2.0
#include "output/modbus.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <modbus/modbus.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <limits>
#include <list>
#include <thread>

#include "horopter/base/error.hpp"

namespace horopter::monitor {
namespace {

constexpr std::size_t kMostClients = 8;
constexpr int kLook_ms = 20;  ///< how soon a server that ends has ended
constexpr std::uint32_t kByteTimeout_us = 200'000;
constexpr std::uint32_t kAfterNoise_us = 20'000;  ///< libmodbus waits so long after what it does not know
/// A client that asks nothing for so long has gone.
constexpr auto kLongestSilence = std::chrono::seconds(60);

struct FreeModbus {
  void operator()(modbus_t* context) const { modbus_free(context); }
};
struct FreeMapping {
  void operator()(modbus_mapping_t* mapping) const { modbus_mapping_free(mapping); }
};

int open_listener(const ModbusCell& cell, const std::string& file) {
  const auto fail = [&](const std::string& why) {
    throw FileError(file, "outputs.modbus", fmt::format("cannot listen at {}:{} ({})", cell.address, cell.port, why),
                    "an address of this computer and a port that nobody uses");
  };
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(cell.port));
  if (::inet_pton(AF_INET, cell.address.c_str(), &address.sin_addr) != 1) fail("no IPv4 address");
  const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int on = 1;
  ::setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  const auto* place = reinterpret_cast<const sockaddr*>(&address);
  if (listener < 0 || ::bind(listener, place, sizeof address) != 0 ||
      ::listen(listener, static_cast<int>(kMostClients)) != 0) {
    const std::string why = std::strerror(errno);
    if (listener >= 0) ::close(listener);
    fail(why);
  }
  return listener;
}

int port_of(int socket) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.sin_port);
}

bool readable(int socket) {
  pollfd wait{.fd = socket, .events = POLLIN, .revents = 0};
  return ::poll(&wait, 1, kLook_ms) > 0;
}

class ModbusPart : public Part {
 public:
  ModbusPart(const ModbusCell& modbus, const Cell& cell, const SafeState& state)
      : state_(state), crc_(cell.crc), listener_(open_listener(modbus, cell.path.string())) {
    std::fprintf(stderr, "horopter: modbus at %s:%d\n", modbus.address.c_str(), port_of(listener_));
    server_ = std::thread([this] { serve(); });
  }
  ~ModbusPart() override {
    stopping_ = true;
    server_.join();
    ::close(listener_);
  }
  ModbusPart(const ModbusPart&) = delete;
  ModbusPart& operator=(const ModbusPart&) = delete;

 private:
  struct Client {
    std::atomic<bool> done = false;
    std::thread thread{};
  };

  void serve() {
    std::list<Client> clients;
    while (!stopping_) {
      const bool somebody = readable(listener_);
      clients.remove_if([](Client& client) {
        if (!client.done) return false;
        client.thread.join();
        return true;
      });
      if (!somebody) continue;
      const int socket = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
      if (socket < 0) continue;
      if (clients.size() >= kMostClients) {
        ::close(socket);
        continue;
      }
      Client& client = clients.emplace_back();
      client.thread = std::thread([this, &client, socket] {
        answer(socket);
        client.done = true;
      });
    }
    for (Client& client : clients) client.thread.join();
  }

  /// One client, until it goes.
  void answer(int socket) const {
    const int on = 1;
    ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    const timeval patience{.tv_sec = 1, .tv_usec = 0};  // for one that takes no answers
    ::setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    const std::unique_ptr<modbus_t, FreeModbus> context(modbus_new_tcp(nullptr, 0));
    const std::unique_ptr<modbus_mapping_t, FreeMapping> mapping(
        modbus_mapping_new(0, kDiscreteInputs, 0, kInputRegisters));
    if (context != nullptr && mapping != nullptr) {
      modbus_set_socket(context.get(), socket);
      modbus_set_byte_timeout(context.get(), 0, kByteTimeout_us);
      modbus_set_response_timeout(context.get(), 0, kAfterNoise_us);
      auto heard = Clock::now();
      std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> query{};
      while (!stopping_ && Clock::now() - heard < kLongestSilence) {
        if (!readable(socket)) continue;
        const int length = modbus_receive(context.get(), query.data());
        if (length < 0) break;
        heard = Clock::now();
        const Signal signal = state_.at(heard);  // as it is now, whoever hangs
        std::ranges::copy(input_registers(signal, crc_), mapping->tab_input_registers);
        std::ranges::copy(discrete_inputs(signal), mapping->tab_input_bits);
        if (modbus_reply(context.get(), query.data(), length, mapping.get()) < 0) break;
      }
    }
    ::close(socket);
  }

  const SafeState& state_;
  std::uint32_t crc_;
  int listener_;
  std::atomic<bool> stopping_ = false;
  std::thread server_;
};

}  // namespace

std::array<std::uint16_t, kInputRegisters> input_registers(const Signal& signal, std::uint32_t configuration_crc) {
  std::array<std::uint16_t, kInputRegisters> registers{};
  const auto put = [&](InputRegister at, std::uint32_t value) {
    registers.at(static_cast<std::size_t>(at)) = static_cast<std::uint16_t>(value);
  };
  const auto put_two = [&](InputRegister at, std::uint32_t value) {
    put(at, value >> 16);
    registers.at(static_cast<std::size_t>(at) + 1) = static_cast<std::uint16_t>(value);
  };
  constexpr std::int64_t kOldest = std::numeric_limits<std::uint16_t>::max();
  const auto age_ms = std::chrono::duration_cast<std::chrono::milliseconds>(signal.age).count();
  put(InputRegister::version, 1);
  put(InputRegister::heartbeat, signal.decisions);
  put(InputRegister::safe, signal.safe ? 1 : 0);
  put(InputRegister::not_safe, signal.safe ? 0 : 1);
  put(InputRegister::alarm, signal.alarm ? 1 : 0);
  put(InputRegister::decision_age_ms, static_cast<std::uint32_t>(std::clamp<std::int64_t>(age_ms, 0, kOldest)));
  put_two(InputRegister::camera_faults, signal.faults.cameras);
  put_two(InputRegister::machine_faults, signal.faults.machine);
  put_two(InputRegister::monitor_faults, signal.faults.monitor);
  put_two(InputRegister::configuration, configuration_crc);
  return registers;
}

std::array<std::uint8_t, kDiscreteInputs> discrete_inputs(const Signal& signal) {
  return {static_cast<std::uint8_t>(signal.safe), static_cast<std::uint8_t>(!signal.safe),
          static_cast<std::uint8_t>(signal.alarm), static_cast<std::uint8_t>(signal.decisions & 1U)};
}

std::unique_ptr<Part> make_modbus(const ModbusCell& modbus, const Cell& cell, const SafeState& state) {
  return std::make_unique<ModbusPart>(modbus, cell, state);
}

}  // namespace horopter::monitor
