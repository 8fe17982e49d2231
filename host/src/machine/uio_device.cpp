// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/uio_device.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "horopter/base/error.hpp"
#include "horopter/machine/machine_build.hpp"
#include "horopter/machine/registers.hpp"

namespace horopter {
namespace {

namespace reg = registers;

int open_or_throw(const std::filesystem::path& path, int flags) {
  const int file = ::open(path.c_str(), flags | O_CLOEXEC);
  if (file < 0) {
    throw DeviceError(
        fmt::format("{} cannot be opened ({}); expected a device of this computer that this user may open",
                    path.string(), std::strerror(errno)));
  }
  return file;
}

}  // namespace

UioDevice::UioDevice(const Paths& paths, std::chrono::milliseconds timeout) : timeout_(timeout) {
  const int file = open_or_throw(paths.registers, O_RDWR | O_SYNC);
  const auto refuse = [&](const std::string& why) {
    ::close(file);
    throw DeviceError(fmt::format("{} {}", paths.registers.string(), why));
  };
  const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  struct stat facts{};
  if (::fstat(file, &facts) != 0) refuse(fmt::format("tells nothing of itself ({})", std::strerror(errno)));
  if (paths.register_offset % page != 0) {
    refuse(
        fmt::format("cannot be mapped at {}; expected a multiple of the page size, {}", paths.register_offset, page));
  }
  if (S_ISREG(facts.st_mode) && static_cast<std::uint64_t>(facts.st_size) < paths.register_offset + kRegisterBytes) {
    refuse(fmt::format("has {} bytes; expected {} bytes of registers at {}", facts.st_size, kRegisterBytes,
                       paths.register_offset));
  }
  if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
    refuse("is used by another program; expected a machine that is free: end that program");
  }
  void* mapped = ::mmap(nullptr, kRegisterBytes, PROT_READ | PROT_WRITE, MAP_SHARED, file,
                        static_cast<off_t>(paths.register_offset));
  if (mapped == MAP_FAILED) {
    refuse(fmt::format("cannot be mapped ({}); expected registers, as of /dev/uio0", std::strerror(errno)));
  }
  registers_file_ = file;
  registers_ = static_cast<volatile std::uint32_t*>(mapped);
  if (paths.left.empty()) return;
  try {
    // A FIFO opened for both directions does not wait for its other end.
    files_[kLeft] = open_or_throw(paths.left, O_RDWR | O_NONBLOCK);
    files_[kRight] = open_or_throw(paths.right, O_RDWR | O_NONBLOCK);
    files_[kStates] = open_or_throw(paths.states, O_RDONLY | O_NONBLOCK);
    files_[kRuns] = open_or_throw(paths.runs, O_RDONLY | O_NONBLOCK);
  } catch (...) {
    close_all();
    throw;
  }
}

UioDevice::~UioDevice() { close_all(); }

void UioDevice::close_all() {
  for (int& file : files_) {
    if (file >= 0) ::close(file);
    file = -1;
  }
  if (registers_ != nullptr) ::munmap(const_cast<std::uint32_t*>(registers_), kRegisterBytes);
  registers_ = nullptr;
  if (registers_file_ >= 0) ::close(registers_file_);
  registers_file_ = -1;
}

std::uint32_t UioDevice::read(std::uint32_t address) {
  if (address % 4 != 0 || address >= kRegisterBytes) throw DeviceError(fmt::format("no register at {:x}", address));
  return registers_[address / 4];
}

void UioDevice::write(std::uint32_t address, std::uint32_t value) {
  if (address % 4 != 0 || address >= kRegisterBytes) throw DeviceError(fmt::format("no register at {:x}", address));
  registers_[address / 4] = value;
  if (address == reg::control::kAddress && reg::control::kEnable.get(value) == 0) discard();
}

void UioDevice::discard() {
  for (auto& bytes : outgoing_) bytes.clear();
  for (auto& bytes : incoming_) bytes.clear();
  constexpr int kReads = 256;  // more than what drivers hold
  std::array<std::uint8_t, 65536> buffer{};
  for (const Stream i : {kStates, kRuns}) {
    for (int read = 0; read < kReads && files_[i] >= 0; ++read) {
      if (::read(files_[i], buffer.data(), buffer.size()) <= 0) break;
    }
  }
}

void UioDevice::check_streams() const {
  if (takes_pictures()) return;
  throw UsageError(
      "a machine without streams takes and gives no pictures; expected --engine uio:REGISTERS,LEFT,RIGHT,STATES,RUNS");
}

void UioDevice::send(const Image& left, const Image& right) {
  check_streams();
  outgoing_[0].insert(outgoing_[0].end(), left.pixels.begin(), left.pixels.end());
  outgoing_[1].insert(outgoing_[1].end(), right.pixels.begin(), right.pixels.end());
}

bool UioDevice::pump(std::size_t states_wanted, bool runs_wanted) {
  std::array<pollfd, kStreams> polls{};
  for (std::size_t i = 0; i < kStreams; ++i) polls[i].fd = -1;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!outgoing_[i].empty()) polls[i] = {files_[i], POLLOUT, 0};
  }
  if (incoming_[0].size() < states_wanted) polls[kStates] = {files_[kStates], POLLIN, 0};
  if (runs_wanted) polls[kRuns] = {files_[kRuns], POLLIN, 0};
  if (::poll(polls.data(), polls.size(), static_cast<int>(timeout_.count())) <= 0) return false;

  bool moved = false;
  std::array<std::uint8_t, 65536> buffer{};
  for (std::size_t i = 0; i < 2; ++i) {
    if ((polls[i].revents & POLLOUT) == 0) continue;
    const std::size_t length = std::min(buffer.size(), outgoing_[i].size());
    std::copy_n(outgoing_[i].begin(), length, buffer.begin());
    const ssize_t written = ::write(polls[i].fd, buffer.data(), length);
    if (written > 0) outgoing_[i].erase(outgoing_[i].begin(), outgoing_[i].begin() + written);
    moved = moved || written > 0;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const pollfd& poll = polls[kStates + i];
    if (poll.fd < 0 || (poll.revents & (POLLIN | POLLHUP)) == 0) continue;
    const std::size_t limit = i == 0 ? std::min(buffer.size(), states_wanted - incoming_[0].size()) : buffer.size();
    const ssize_t length = ::read(poll.fd, buffer.data(), limit);
    if (length > 0) incoming_[i].insert(incoming_[i].end(), buffer.begin(), buffer.begin() + length);
    moved = moved || length > 0;
  }
  return moved;
}

FrameStreams UioDevice::receive() {
  check_streams();
  FrameStreams streams{result_image(*this), {}};
  const int width = streams.states.width;
  const int height = streams.states.height;
  bool runs_complete = false;
  auto last_move = std::chrono::steady_clock::now();
  while (true) {
    while (!runs_complete && incoming_[1].size() >= 8) {
      std::uint64_t beat = 0;
      for (int i = 0; i < 8; ++i) beat |= std::uint64_t{incoming_[1][static_cast<std::size_t>(i)]} << (8 * i);
      incoming_[1].erase(incoming_[1].begin(), incoming_[1].begin() + 8);
      streams.runs.push_back(decode_run(beat));
      runs_complete = streams.runs.back().row == height - 1 && streams.runs.back().end == width - 1;
    }
    if (runs_complete && incoming_[0].size() >= streams.states.pixels.size()) break;
    const auto now = std::chrono::steady_clock::now();
    if (pump(streams.states.pixels.size(), !runs_complete)) {
      last_move = now;
    } else if (now - last_move > timeout_) {
      throw DeviceError(fmt::format("no frame comes: {} of {} states, {} runs, {} pixels not taken after {} ms",
                                    incoming_[0].size(), streams.states.pixels.size(), streams.runs.size(),
                                    outgoing_[0].size() + outgoing_[1].size(), timeout_.count()));
    }
  }
  const auto end = incoming_[0].begin() + static_cast<std::ptrdiff_t>(streams.states.pixels.size());
  std::copy(incoming_[0].begin(), end, streams.states.pixels.begin());
  incoming_[0].erase(incoming_[0].begin(), end);
  return streams;
}

}  // namespace horopter
