// SPDX-License-Identifier: Apache-2.0
#include "horopter/machine/serial_link.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <random>
#include <utility>

#include "horopter/base/crc32.hpp"
#include "horopter/base/error.hpp"

namespace horopter {
namespace {

using Time = BytePort::Time;

constexpr std::uint8_t kFlag = 0x7E;
constexpr std::uint8_t kEscape = 0x7D;
constexpr std::uint8_t kEscaped = 0x20;  // inverted in a byte after kEscape
constexpr std::size_t kLargestFrame = 4 * (SerialLink::kWordsPerFrame + 2);

enum class Kind : std::uint8_t { open = 0, read = 1, write = 2 };
enum Status : std::uint8_t { kDone = 0, kRefused = 2, kNoAddress = 3, kNoSession = 4, kNotItsTurn = 5 };

/// Frames under way: more than an adapter's delay of 16 ms holds at 3 Mbaud.
constexpr std::size_t kWindow = 20;
constexpr int kTries = 10;
constexpr int kOpenTries = 4;
/// Answers in a row that tell of nothing new: more than there are frames in all tries.
constexpr std::size_t kIdleAnswers = 2 * kTries * kWindow;

std::uint32_t header(Kind kind, std::uint16_t address, std::size_t words, std::uint8_t number) {
  return static_cast<std::uint32_t>(address) << 16 | static_cast<std::uint32_t>(kind) << 14 |
         static_cast<std::uint32_t>(words - 1) << 8 | number;
}

}  // namespace

std::vector<std::uint8_t> encode_frame(std::span<const std::uint32_t> words) {
  std::vector<std::uint8_t> bytes{kFlag};
  const auto put = [&](std::uint32_t word) {
    for (int i = 0; i < 4; ++i) {
      const auto byte = static_cast<std::uint8_t>(word >> (8 * i));
      const bool special = byte == kFlag || byte == kEscape;
      if (special) bytes.push_back(kEscape);
      bytes.push_back(special ? byte ^ kEscaped : byte);
    }
  };
  for (const std::uint32_t word : words) put(word);
  put(crc32_words(words));
  bytes.push_back(kFlag);
  return bytes;
}

std::optional<std::vector<std::uint32_t>> FrameDecoder::take(std::uint8_t byte) {
  if (byte != kFlag) {
    const std::uint8_t value = escape_ ? byte ^ kEscaped : byte;
    escape_ = !escape_ && byte == kEscape;
    if (in_frame_ && !escape_) bytes_.push_back(value);
    if (bytes_.size() > kLargestFrame) in_frame_ = false;
    return std::nullopt;
  }
  std::vector<std::uint32_t> words;
  if (in_frame_ && !escape_ && bytes_.size() >= 8 && bytes_.size() % 4 == 0) {
    words.resize(bytes_.size() / 4);
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
      words[i / 4] |= static_cast<std::uint32_t>(bytes_[i]) << (8 * (i % 4));
    }
    const std::uint32_t crc = words.back();
    words.pop_back();
    if (crc32_words(words) != crc) words.clear();
  }
  in_frame_ = true;
  escape_ = false;
  bytes_.clear();
  if (words.empty()) return std::nullopt;
  return words;
}

SerialLink::SerialLink(std::unique_ptr<BytePort> port, std::string name)
    : port_(std::move(port)), name_(std::move(name)) {
  open_session();
  open_ = true;
}

Time SerialLink::patience(std::size_t bytes) const { return port_->latency() + 2 * port_->time_of(bytes); }

std::optional<SerialLink::Answer> SerialLink::next_answer(Time end) {
  while (true) {
    while (taken_ < received_.size()) {
      auto words = decoder_.take(received_[taken_++]);
      if (!words) continue;
      const std::uint32_t last = words->back();
      words->pop_back();
      return Answer{std::move(*words), static_cast<std::uint8_t>(last), static_cast<std::uint8_t>(last >> 8),
                    static_cast<std::uint8_t>(last >> 16), static_cast<std::uint8_t>(last >> 24)};
    }
    if (port_->now() >= end) return std::nullopt;
    received_.resize(4096);
    received_.resize(port_->read(received_, end));
    taken_ = 0;
    bytes_seen_ += received_.size();
  }
}

void SerialLink::open_session() {
  std::random_device random;
  for (int attempt = 0; attempt < kOpenTries; ++attempt) {
    const auto token = static_cast<std::uint32_t>(random());
    const auto number = static_cast<std::uint8_t>(token >> 24);
    const auto frame = encode_frame(std::array{header(Kind::open, 0, 1, number), token});
    port_->write(frame);
    const Time end = port_->now() + patience(frame.size());
    while (const auto answer = next_answer(end)) {
      if (answer->data != std::vector{token} || answer->number != number) continue;  // of an earlier session
      next_ = answer->expected;
      return;
    }
  }
  if (bytes_seen_ == 0) {
    throw DeviceError(
        fmt::format("{}: nothing answers; expected a Horopter board: is it powered, does it have its bitstream, is "
                    "this its port, and its baud rate?",
                    name_));
  }
  throw DeviceError(
      fmt::format("{}: {} bytes came, but no answer of a Horopter board: another device is on this port, or the "
                  "baud rate is not the board's",
                  name_, bytes_seen_));
}

void SerialLink::fail_unanswered() const {
  throw DeviceError(fmt::format(
      "{}: the board has stopped answering; expected it to: look at cable and power, then try again", name_));
}

void SerialLink::check(const Answer& answer, const char* what, std::uint16_t address) const {
  if (answer.status == kNoSession) {
    throw ResetError(fmt::format(
        "{}: the board was reset, or another program talks to it; what was sent is lost: try again", name_));
  }
  if (answer.status == kRefused || answer.status == kNoAddress) {
    throw DeviceError(fmt::format("{}: the machine refuses to {} register {:04x} ({})", name_, what, address,
                                  answer.status == kRefused ? "locked, or no such register" : "no such address"));
  }
}

void SerialLink::write(std::uint16_t address, std::span<const std::uint32_t> words) {
  if (!std::exchange(open_, false)) open_session();
  std::vector<std::vector<std::uint8_t>> frames;
  const std::uint8_t first = next_;
  for (std::size_t i = 0; i < words.size(); i += kWordsPerFrame) {
    const auto part = words.subspan(i, std::min(kWordsPerFrame, words.size() - i));
    std::vector<std::uint32_t> frame{header(Kind::write, address, part.size(), next_++)};
    frame.insert(frame.end(), part.begin(), part.end());
    frames.push_back(encode_frame(frame));
  }
  std::size_t done = 0;
  std::size_t sent = 0;
  std::size_t most_sent = 0;
  std::size_t gone_back_to = frames.size();  // because of a gap; once only, as all that follow it are answered, too
  int tries = 0;
  std::size_t idle_answers = 0;
  while (done < frames.size()) {
    for (; sent < std::min(frames.size(), done + kWindow); ++sent) {
      port_->write(frames[sent]);
      if (sent < most_sent) ++repeated_;
      most_sent = std::max(most_sent, sent + 1);
    }
    const auto answer = next_answer(port_->now() + patience((sent - done) * kLargestFrame));
    if (!answer) {
      if (++tries == kTries) fail_unanswered();
      sent = done;
      continue;
    }
    check(*answer, "write", address);
    if (++idle_answers > kIdleAnswers) fail_unanswered();
    const std::size_t progress = static_cast<std::uint8_t>(answer->expected - (first + done));
    if (progress > most_sent - done) continue;  // of an earlier session, or request
    if (progress > 0) {
      tries = 0;
      idle_answers = 0;
    }
    done += progress;
    sent = std::max(sent, done);
    const auto ahead = static_cast<std::uint8_t>(answer->number - answer->expected);
    if (answer->status == kNotItsTurn && ahead < kWindow && gone_back_to != done) {
      gone_back_to = done;
      sent = done;
    }
  }
  open_ = true;
}

std::vector<std::uint32_t> SerialLink::read(std::uint16_t address, std::size_t words) {
  if (!std::exchange(open_, false)) open_session();
  std::vector<std::uint32_t> result;
  while (result.size() < words) {
    const std::size_t wanted = std::min(kWordsPerFrame, words - result.size());
    const auto from = static_cast<std::uint16_t>(address + 4 * result.size());
    const std::uint8_t number = next_++;
    const auto frame = encode_frame(std::array{header(Kind::read, from, wanted, number)});
    bool answered = false;
    for (int attempt = 0; attempt < kTries && !answered; ++attempt) {
      if (attempt > 0) ++repeated_;
      port_->write(frame);
      const Time end = port_->now() + patience(frame.size() + kLargestFrame);
      while (const auto answer = next_answer(end)) {
        if (answer->status != kNoSession && (answer->number != number || answer->expected != next_)) continue;
        check(*answer, "read", static_cast<std::uint16_t>(from + 4 * answer->word));
        if (answer->data.size() != wanted) continue;
        result.insert(result.end(), answer->data.begin(), answer->data.end());
        answered = true;
        break;
      }
    }
    if (!answered) fail_unanswered();
  }
  open_ = true;
  return result;
}

}  // namespace horopter
