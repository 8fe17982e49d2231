// SPDX-License-Identifier: Apache-2.0
// Registers over a serial line, the host's side of the protocol in docs/boards.md: requests in frames with sequence number
// and CRC, several under way at once, repeated until they are answered.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace horopter {

/// A line that carries bytes in both directions, and may lose, change or double them.
class BytePort {
 public:
  using Time = std::chrono::microseconds;
  virtual ~BytePort() = default;

  /// Throws DeviceError when the line takes no bytes.
  virtual void write(std::span<const std::uint8_t> bytes) = 0;
  /// Waits for at least one byte until now() is `end`. Gives how many came. Throws DeviceError when the line is gone.
  virtual std::size_t read(std::span<std::uint8_t> bytes, Time end) = 0;
  /// Since any beginning.
  virtual Time now() = 0;
  /// That the line takes for so many bytes.
  [[nodiscard]] virtual Time time_of(std::size_t bytes) const = 0;
  /// The longest that an answer may take beside the line's time: adapters, and whoever is at both ends.
  [[nodiscard]] virtual Time latency() const = 0;
};

/// The words of a frame, with its CRC and marks, as bytes; and back.
std::vector<std::uint8_t> encode_frame(std::span<const std::uint32_t> words);

class FrameDecoder {
 public:
  /// The words of the frame that this byte ends, without the CRC. Nothing while there is none, or where the CRC is wrong.
  std::optional<std::vector<std::uint32_t>> take(std::uint8_t byte);

 private:
  std::vector<std::uint8_t> bytes_;
  bool escape_ = false;
  bool in_frame_ = false;
};

class SerialLink {
 public:
  static constexpr std::size_t kWordsPerFrame = 64;

  /// `name`: of the port, for messages. Begins a session. Throws DeviceError when nobody answers, or somebody else.
  SerialLink(std::unique_ptr<BytePort> port, std::string name);

  /// Throw DeviceError when an access is refused, when no answer comes, and when the board was reset since the session
  /// began. When a write is refused, those after it have not been made. After an error the next call begins a session.
  void write(std::uint16_t address, std::span<const std::uint32_t> words);
  std::vector<std::uint32_t> read(std::uint16_t address, std::size_t words);

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Frames that were sent once more.
  [[nodiscard]] std::size_t repeated() const { return repeated_; }

 private:
  struct Answer {
    std::vector<std::uint32_t> data;
    std::uint8_t number = 0;    ///< of the request
    std::uint8_t expected = 0;  ///< number of the request that is carried out next
    std::uint8_t status = 0;
    std::uint8_t word = 0;  ///< that was refused
  };

  void open_session();
  /// The next answer, or nothing when none came in time.
  std::optional<Answer> next_answer(BytePort::Time end);
  /// How long to wait for an answer to so many bytes.
  [[nodiscard]] BytePort::Time patience(std::size_t bytes) const;
  void check(const Answer& answer, const char* what, std::uint16_t address) const;
  [[noreturn]] void fail_unanswered() const;

  std::unique_ptr<BytePort> port_;
  std::string name_;
  FrameDecoder decoder_;
  std::vector<std::uint8_t> received_;  ///< of which the first `taken_` are decoded
  std::size_t taken_ = 0;
  std::size_t bytes_seen_ = 0;
  bool open_ = false;      ///< the session, in which nothing has failed
  std::uint8_t next_ = 0;  ///< number of the next request
  std::size_t repeated_ = 0;
};

}  // namespace horopter
