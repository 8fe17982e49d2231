// SPDX-License-Identifier: Apache-2.0
// A machine behind registers in memory and four streams, for a program that knows it as `--engine uio:…`.
//
// The streams are FIFOs. The registers are a file that the program maps. As soon as it has, the file is cut to nothing, so
// that every access raises SIGBUS. The program is traced: the access is let through to a page with the register's value,
// and what it wrote goes to the machine. That is how a bus works, and the program is the one that users have.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <sys/ptrace.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "horopter/machine/device.hpp"
#include "horopter/machine/registers.hpp"
#include "sandbox.hpp"

namespace horopter::test {

class UioMachine {
 public:
  UioMachine(const Sandbox& box, std::unique_ptr<Device> device) : box_(box), device_(std::move(device)) {
    registers_path_ = box.write("registers", std::string(kBytes, '\0'));
    registers_ = ::open(registers_path_.c_str(), O_RDWR | O_CLOEXEC);
    REQUIRE(registers_ >= 0);
    for (std::size_t i = 0; i < kStreams; ++i) {
      const std::string path = (box / kNames.at(i)).string();
      REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
      // Open for both directions it waits for nobody, and stays when the program closes it.
      streams_.at(i) = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
      REQUIRE(streams_.at(i) >= 0);
    }
    thread_ = std::thread([this] { serve_streams(); });
  }
  ~UioMachine() {
    stop_ = true;
    thread_.join();
    for (const int stream : streams_) ::close(stream);
    ::close(registers_);
    for (const char* const name : kNames) fs::remove(box_ / name);
  }
  UioMachine(const UioMachine&) = delete;
  UioMachine& operator=(const UioMachine&) = delete;

  [[nodiscard]] std::string engine() const {
    std::string text = "uio:" + registers_path_;
    for (const char* const name : kNames) text += "," + (box_ / name).string();
    return text;
  }
  [[nodiscard]] int frames() const { return frames_; }
  [[nodiscard]] int accesses() const { return accesses_; }

  /// Runs the program in the sandbox to its end.
  Sandbox::Result run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), HOROPTER_PROGRAM);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const std::string folder = (box_ / "").string();
    const std::string out = (box_ / "stdout").string();
    const std::string err = (box_ / "stderr").string();
    REQUIRE(::ftruncate(registers_, kBytes) == 0);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      const bool ready = ::chdir(folder.c_str()) == 0 && redirect("/dev/null", O_RDONLY, 0) &&
                         redirect(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 1) &&
                         redirect(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 2) &&
                         ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0;
      if (ready) ::execv(HOROPTER_PROGRAM, argv.data());
      ::_exit(127);
    }
    const int status = follow(child);
    INFO("it was killed, by signal " << (WIFSIGNALED(status) ? WTERMSIG(status) : 0) << "; it said " << read_text(err));
    REQUIRE(WIFEXITED(status));
    return {WEXITSTATUS(status), read_text(out), read_text(err)};
  }

 private:
  static constexpr std::size_t kBytes = 4096;
  enum Stream : std::size_t { kLeft, kRight, kStates, kRuns, kStreams };
  static constexpr std::array<const char*, kStreams> kNames{"left", "right", "states", "runs"};

  static bool redirect(const char* path, int flags, int to) {
    const int file = ::open(path, flags, 0600);
    return file >= 0 && ::dup2(file, to) == to;
  }

  /// Until the program has ended. Gives its status.
  int follow(pid_t child) {
    bool mapped = false;
    bool mapping = false;  // in a call that maps the registers
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    ::ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_EXITKILL | PTRACE_O_TRACESYSGOOD);
    long signal = 0;
    while (!WIFEXITED(status) && !WIFSIGNALED(status)) {
      REQUIRE(::ptrace(mapped ? PTRACE_CONT : PTRACE_SYSCALL, child, nullptr, signal) == 0);
      REQUIRE(::waitpid(child, &status, 0) == child);
      signal = 0;
      if (!WIFSTOPPED(status)) continue;
      if (WSTOPSIG(status) == (SIGTRAP | 0x80)) {
        if (mapping) {
          mapped = true;
          REQUIRE(::ftruncate(registers_, 0) == 0);
        }
        mapping = maps_registers(child);
      } else if (WSTOPSIG(status) == SIGBUS) {
        access(child, status);
      } else if (WSTOPSIG(status) != SIGTRAP) {
        signal = WSTOPSIG(status);
      }
    }
    return status;
  }

  /// Whether the program is at the beginning of such a call.
  bool maps_registers(pid_t child) const {
    __ptrace_syscall_info info{};
    const auto length = ::ptrace(PTRACE_GET_SYSCALL_INFO, child, sizeof info, &info);
    if (length <= 0 || info.op != PTRACE_SYSCALL_INFO_ENTRY || info.entry.nr != SYS_mmap) return false;
    const fs::path link =
        "/proc/" + std::to_string(child) + "/fd/" + std::to_string(static_cast<int>(info.entry.args[4]));
    std::error_code error;
    return fs::read_symlink(link, error) == fs::path(registers_path_);
  }

  /// Lets the access through for which the program has stopped.
  void access(pid_t child, int& status) {
    siginfo_t info{};
    REQUIRE(::ptrace(PTRACE_GETSIGINFO, child, nullptr, &info) == 0);
    const auto address = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(info.si_addr) % kBytes);
    const auto* const known = std::ranges::find(registers::kRegisters, address, &registers::Register::address);
    CAPTURE(address);
    REQUIRE(known != std::end(registers::kRegisters));
    const bool only_written = known->access == registers::Access::kWriteStream;
    ++accesses_;
    std::unique_lock lock(mutex_);
    const std::uint32_t before = only_written ? 0 : device_->read(address);
    lock.unlock();
    REQUIRE(::ftruncate(registers_, kBytes) == 0);
    REQUIRE(::pwrite(registers_, &before, sizeof before, address) == sizeof before);
    REQUIRE(::ptrace(PTRACE_SINGLESTEP, child, nullptr, nullptr) == 0);
    REQUIRE(::waitpid(child, &status, 0) == child);
    REQUIRE((WIFSTOPPED(status) && WSTOPSIG(status) == SIGTRAP));
    std::uint32_t after = 0;
    REQUIRE(::pread(registers_, &after, sizeof after, address) == sizeof after);
    REQUIRE(::ftruncate(registers_, 0) == 0);
    // To write the same again changes nothing, but in a register that can only be written.
    if (!only_written && after == before) return;
    lock.lock();
    device_->write(address, after);
  }

  void serve_streams() {
    std::array<std::vector<std::uint8_t>, 2> images;
    std::array<std::deque<std::uint8_t>, 2> results;
    while (!stop_) {
      std::array<pollfd, kStreams> polls{};
      for (std::size_t i = 0; i < kStreams; ++i) {
        const bool idle = i >= kStates && results.at(i - kStates).empty();
        polls.at(i) = {idle ? -1 : streams_.at(i), static_cast<short>(i < kStates ? POLLIN : POLLOUT), 0};
      }
      if (::poll(polls.data(), polls.size(), 20) <= 0) continue;
      for (const Stream i : {kLeft, kRight}) {
        std::array<std::uint8_t, 65536> buffer{};
        const ssize_t length =
            (polls.at(i).revents & POLLIN) != 0 ? ::read(streams_.at(i), buffer.data(), buffer.size()) : 0;
        if (length > 0) images.at(i).insert(images.at(i).end(), buffer.begin(), buffer.begin() + length);
      }
      for (const Stream i : {kStates, kRuns}) {
        auto& bytes = results.at(i - kStates);
        if (bytes.empty() || (polls.at(i).revents & POLLOUT) == 0) continue;
        const std::vector<std::uint8_t> part(
            bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(4096, bytes.size())));
        const ssize_t length = ::write(streams_.at(i), part.data(), part.size());
        if (length > 0) bytes.erase(bytes.begin(), bytes.begin() + length);
      }
      take_frame(images, results);
    }
  }

  /// As soon as both images are there.
  void take_frame(std::array<std::vector<std::uint8_t>, 2>& images, std::array<std::deque<std::uint8_t>, 2>& results) {
    if (images[0].empty() || images[1].empty()) return;
    const std::lock_guard lock(mutex_);
    const auto width = static_cast<int>(device_->read(registers::width::kAddress));
    const auto height = static_cast<int>(device_->read(registers::height::kAddress));
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (images[0].size() < pixels || images[1].size() < pixels) return;
    std::array<Image, 2> frame{Image(width, height), Image(width, height)};
    for (std::size_t i = 0; i < 2; ++i) {
      const auto end = images.at(i).begin() + static_cast<std::ptrdiff_t>(pixels);
      std::copy(images.at(i).begin(), end, frame.at(i).pixels.begin());
      images.at(i).erase(images.at(i).begin(), end);
    }
    device_->send(frame[0], frame[1]);
    const FrameStreams made = device_->receive();
    results[0].insert(results[0].end(), made.states.pixels.begin(), made.states.pixels.end());
    for (const Run& run : made.runs) {
      const std::uint64_t beat = encode_run(run);
      for (int i = 0; i < 8; ++i) results[1].push_back(static_cast<std::uint8_t>(beat >> (8 * i)));
    }
    ++frames_;
  }

  const Sandbox& box_;
  std::unique_ptr<Device> device_;
  std::mutex mutex_;  ///< of the device
  std::string registers_path_;
  int registers_ = -1;
  std::array<int, kStreams> streams_{-1, -1, -1, -1};
  std::atomic<bool> stop_ = false;
  std::atomic<int> frames_ = 0;
  int accesses_ = 0;
  std::thread thread_;
};

}  // namespace horopter::test
