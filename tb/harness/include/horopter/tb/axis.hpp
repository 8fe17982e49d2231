// SPDX-License-Identifier: Apache-2.0
// AXI4-Stream endpoints: a camera (AXI4-Stream Video: tuser = first pixel of a frame, tlast = last of a line), good or
// broken on purpose, and a sink with back-pressure that also watches the protocol.
#pragma once

#include <cstdint>
#include <deque>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "horopter/tb/image.hpp"
#include "horopter/tb/random.hpp"
#include "horopter/tb/simulation.hpp"

namespace horopter::tb {

/// The pins of one stream; user may be null. `Data` is the C++ type of tdata in the Verilated model.
template <class Data>
struct AxisPins {
  std::uint8_t* valid = nullptr;
  std::uint8_t* ready = nullptr;
  Data* data = nullptr;
  std::uint8_t* user = nullptr;
  std::uint8_t* last = nullptr;
};

/// The pins of the stream `prefix` (s_axis_left …) of a model.
#define HOROPTER_TB_AXIS(model, prefix)                                                                  \
  {&(model).prefix##_tvalid, &(model).prefix##_tready, &(model).prefix##_tdata, &(model).prefix##_tuser, \
   &(model).prefix##_tlast}

struct ProtocolError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What is wrong with a frame on its way from the camera.
struct Damage {
  enum class Kind {
    none,
    short_line,     ///< line `row` ends `amount` pixels early
    long_line,      ///< line `row` has `amount` more pixels
    missing_line,   ///< line `row` does not come
    missing_start,  ///< the first pixel is not marked
    extra_start,    ///< the first pixel of line `row` is marked, too
  };
  Kind kind = Kind::none;
  unsigned row = 0, amount = 1;
};

class VideoSource final : public Endpoint {
 public:
  VideoSource(AxisPins<std::uint8_t> pins, Pace pace = {}) : pins_{pins}, pace_{pace} { reset(); }

  void set_pace(Pace pace) { pace_ = pace; }
  /// A camera that does not wait: a pixel that is not taken in its clock is lost (and counted).
  void set_live(bool live) { live_ = live; }

  void send(const Image& image, Damage damage = {});
  /// Silence of so many clocks before what is sent next.
  void idle(unsigned clocks) {
    Beat pause{};
    pause.blank_after = clocks;
    beats_.push_back(pause);
  }

  bool done() const { return beats_.empty() && blank_ == 0; }
  std::uint64_t lost() const { return lost_; }
  std::uint64_t taken() const { return taken_; }

  void drive() override;
  void sample() override;
  void reset() override;

 private:
  struct Beat {
    bool is_pixel = false;  ///< false: only a pause
    std::uint8_t data = 0;
    bool first = false, last = false;
    unsigned blank_after = 0;  ///< clocks of silence
  };
  void finish_front();
  AxisPins<std::uint8_t> pins_;
  Pace pace_;
  bool live_ = false;
  bool offering_ = false;  ///< tvalid is high: the front beat stays until it is taken
  unsigned blank_ = 0;
  std::deque<Beat> beats_;
  std::uint64_t lost_ = 0, taken_ = 0;
};

template <class Data>
class StreamSink final : public Endpoint {
 public:
  struct Beat {
    Data data{};
    bool user = false, last = false;
    std::uint64_t cycle = 0;  ///< clocks of this sink's life
    friend bool operator==(const Beat& a, const Beat& b) {
      return a.data == b.data && a.user == b.user && a.last == b.last;
    }
  };

  StreamSink(std::string name, AxisPins<Data> pins, Pace pace = {}) : name_{std::move(name)}, pins_{pins}, pace_{pace} {
    reset();
  }
  void set_pace(Pace pace) { pace_ = pace; }
  std::vector<Beat>& beats() { return beats_; }
  std::vector<Beat> take() { return std::exchange(beats_, {}); }

  void drive() override { *pins_.ready = pace_.next(); }
  void sample() override {
    ++cycle_;
    const Beat beat{*pins_.data, pins_.user && *pins_.user, pins_.last && *pins_.last, cycle_};
    if (offered_ && !(*pins_.valid && beat == held_)) {
      throw ProtocolError{name_ + ": a beat that was not taken has changed or gone (clock " + std::to_string(cycle_) +
                          ")"};
    }
    offered_ = *pins_.valid && !*pins_.ready;
    held_ = beat;
    if (*pins_.valid && *pins_.ready) beats_.push_back(beat);
  }
  void reset() override {
    *pins_.ready = 0;
    offered_ = false;
  }

 private:
  std::string name_;
  AxisPins<Data> pins_;
  Pace pace_;
  std::vector<Beat> beats_;
  Beat held_;
  bool offered_ = false;
  std::uint64_t cycle_ = 0;
};

}  // namespace horopter::tb
