// SPDX-License-Identifier: Apache-2.0
// The framer alone, with a pairing that grants in a chosen clock: what a bench of the whole machine cannot aim at.
#include <Vtb_framer.h>

#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

#include "horopter/tb/image.hpp"
#include "horopter/tb/random.hpp"
#include "horopter/tb/simulation.hpp"

using namespace horopter::tb;

namespace {

constexpr unsigned kWidth = 12;
constexpr unsigned kHeight = 6;
constexpr unsigned kExtraLines = 8;  // EXTRA_LINES
constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

/// What pairing and store are told from the grant of a frame to the next grant.
struct Frame {
  std::uint64_t granted_at = 0;  ///< clock
  bool empty = false;            ///< asked for as a frame without rows
  unsigned ends = 0, rows = 0, bad_rows = 0, missing_starts = 0, other_faults = 0;
  unsigned silences = 0;             ///< of these: that the camera has fallen silent, whichever frame that concerns
  std::vector<std::uint8_t> pixels;  ///< in the order in which they were written
  unsigned misplaced = 0;            ///< writes with a wrong x, first or end mark
};

/// Camera, pairing and store of one framer; the store always has room.
class Surroundings final : public Endpoint {
 public:
  explicit Surroundings(Vtb_framer& model) : model_{model} {
    model_.almost_full_i = model_.deny_i = model_.cut_i = model_.patience_i = 0;
    model_.s_valid_i = model_.grant_i = model_.keep_i = 0;
  }

  bool junk = false;                  ///< a camera that must not send a start yet sends pixels rather than nothing
  std::uint64_t start_at = 0;         ///< clock from which a start of frame may arrive
  std::uint64_t grant_at = 0;         ///< clock from which whoever asks is granted a frame
  std::uint64_t arrived_at = kNever;  ///< clock in which the last start of frame arrived at the framer
  std::vector<Frame> frames;
  unsigned unasked = 0;  ///< what was told before the first grant

  void send(const Image& image, bool with_start) {
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      beats_.push_back({image.pixels[i], with_start && i == 0, i % image.width == image.width - 1});
  }
  /// The camera sends nothing for so many clocks when so many pixels are gone.
  void pause_after(std::size_t pixels, unsigned clocks) {
    pause_at_ = beats_.size() - pixels;
    pause_ = clocks;
  }
  bool sent() const { return beats_.empty(); }
  std::uint64_t clock() const { return clock_; }

  void drive() override {
    const bool pauses = pause_ > 0 && beats_.size() == pause_at_;
    if (pauses) --pause_;
    held_ = pauses || beats_.empty() || (beats_.front().first && clock_ < start_at);
    const Beat beat = held_ ? Beat{0xEE, false, false} : beats_.front();
    model_.s_valid_i = !held_ || junk;
    model_.s_pixel_i = beat.pixel;
    model_.s_first_i = beat.first;
    model_.s_last_i = beat.last;
    model_.grant_i = model_.start_o && clock_ >= grant_at;
    model_.keep_i = model_.stored_o;
  }

  void sample() override {
    if (model_.s_valid_i && model_.s_first_i && !starting_) arrived_at = clock_;
    starting_ = model_.s_valid_i && model_.s_first_i && !model_.s_ready_o;
    if (!held_ && model_.s_ready_o) beats_.pop_front();
    hear();  // before the grant of this clock: what belongs to a frame is told a clock after its grant or later
    if (model_.grant_i) {
      frames.emplace_back();
      frames.back().granted_at = clock_;
      frames.back().empty = model_.empty_o;
    }
    ++clock_;
  }

 private:
  struct Beat {
    std::uint8_t pixel;
    bool first, last;
  };

  void hear() {
    const unsigned others = 0U + model_.short_line_o + model_.long_line_o + model_.missing_line_o + model_.overflow_o +
                            model_.lost_silent_o + model_.silence_o;
    if (frames.empty()) {
      unasked += others + model_.missing_start_o + model_.frame_done_o + model_.row_done_o + model_.write_en_o;
      return;
    }
    Frame& frame = frames.back();
    frame.other_faults += others;
    frame.silences += model_.silence_o;
    frame.missing_starts += model_.missing_start_o;
    frame.ends += model_.frame_done_o;
    frame.rows += model_.row_done_o;
    frame.bad_rows += model_.row_done_o && model_.row_bad_o ? 1 : 0;
    if (!model_.write_en_o) return;
    const std::size_t at = frame.pixels.size();
    const bool right = model_.write_x_o == at % kWidth && (model_.write_first_o != 0) == (at == 0) &&
                       (model_.write_end_o != 0) == (at + 1 == kWidth * kHeight);
    if (!right) ++frame.misplaced;
    frame.pixels.push_back(model_.write_pixel_o);
  }

  Vtb_framer& model_;
  std::deque<Beat> beats_;
  std::uint64_t clock_ = 0;
  std::size_t pause_at_ = 0;
  unsigned pause_ = 0;
  bool held_ = false, starting_ = false;
};

/// A framer behind its reset.
struct Bench {
  Bench(bool live, std::uint32_t timeout) {
    model.live_i = live;
    model.width_i = kWidth;
    model.height_i = kHeight;
    model.timeout_i = timeout;
    simulation.attach(around);
    simulation.reset();
  }
  Rng rng{"framer"};
  Simulation<Vtb_framer> simulation{rng.next(), 10'000};
  Vtb_framer& model = simulation.model();
  Surroundings around{model};
};

/// A frame of all its rows, none bad, and no fault but perhaps a missing start.
void check_whole(const Frame& frame, const Image& image, unsigned missing_starts) {
  CHECK_FALSE(frame.empty);
  CHECK(frame.ends == 1);
  CHECK(frame.rows == kHeight);
  CHECK(frame.bad_rows == 0);
  CHECK((frame.pixels == image.pixels));  // no use printing them
  CHECK(frame.misplaced == 0);
  CHECK(frame.missing_starts == missing_starts);
  CHECK(frame.other_faults == 0);
}

}  // namespace

// A start that comes no later than the clock before the grant turns the request into one for its own frame, which then
// carries the fault. Any later start finds the frame without rows granted: that one carries the fault and ends, and the
// start gets a frame of its own, without fault.
TEST_CASE("framer: a start of frame around the clock in which a frame is granted for a lost one") {
  const bool live = GENERATE(false, true);
  const bool junk = GENERATE(false, true);
  const int after = GENERATE(range(-6, 7));  // clocks from the grant to the arrival of the start
  CAPTURE(live, junk, after);

  Bench bench{live, 1'000};
  auto& [rng, simulation, model, around] = bench;

  // A good frame, then lines of which nobody knows the frame, until the framer asks for the lost one.
  const Image before = noise_image(kWidth, kHeight, rng), image = noise_image(kWidth, kHeight, rng);
  around.send(before, true);
  simulation.run_until([&] { return around.sent(); }, 1'000, "a frame");
  around.grant_at = kNever;
  around.send(noise_image(kWidth, kExtraLines, rng), false);
  simulation.run_until([&] { return model.start_o && model.empty_o; }, 1'000, "the wish for the lost frame");
  REQUIRE(around.frames.size() == 1);
  check_whole(around.frames[0], before, 1);  // told with the first line that follows it

  // The grant, and around it the start.
  around.junk = junk;
  around.grant_at = around.clock() + 8;
  around.start_at = around.grant_at + static_cast<std::uint64_t>(after);  // modulo 2^64: after may be negative
  around.send(image, true);
  simulation.run_until([&] { return around.sent(); }, 1'000, "the frame after the lost one");
  around.junk = false;
  simulation.run(20);

  // The clocks are those meant: -1, 0 and 1 are those in which the question, the grant and its effect are seen.
  REQUIRE(around.frames.size() >= 2);
  CHECK(around.frames[1].granted_at == around.grant_at);
  CHECK(around.arrived_at == around.start_at);

  if (after < -1) {
    REQUIRE(around.frames.size() == 2);
    check_whole(around.frames[1], image, 1);
  } else {
    REQUIRE(around.frames.size() == 3);
    const Frame& lost = around.frames[1];
    CHECK(lost.empty);
    CHECK(lost.ends == 1);
    CHECK(lost.rows == 0);
    CHECK(lost.pixels.empty());
    CHECK(lost.missing_starts == 1);
    CHECK(lost.other_faults == 0);
    check_whole(around.frames[2], image, 0);
  }
  CHECK(around.unasked == 0);
  CHECK(model.start_o == 0);
}

// Who is paired by counting (without live mode) must hear of every frame that did not come whole, whenever the camera goes
// on: in the very clock in which its silence is known it may send what belongs to another frame.
TEST_CASE("framer: a pause that ends a frame is a fault of that frame, whenever the camera goes on") {
  const bool live = GENERATE(false, true);
  const unsigned sent_before = GENERATE(1U, kWidth, kWidth + 5, kWidth * kHeight - 3, kWidth * kHeight - 1);  // pixels
  constexpr unsigned kTimeout = 90;
  const unsigned limit = live ? 4 * kWidth : kTimeout;
  const auto pause = limit + static_cast<unsigned>(GENERATE(range(0, 12))) - 6;
  CAPTURE(live, sent_before, pause);

  Bench bench{live, kTimeout};
  auto& [rng, simulation, model, around] = bench;

  const Image image = noise_image(kWidth, kHeight, rng);
  around.send(image, true);
  around.pause_after(sent_before, pause);
  simulation.run_until([&] { return around.sent(); }, 1'000, "a frame with a pause");
  simulation.run(20);

  REQUIRE(around.frames.size() == 1);
  const Frame& frame = around.frames[0];
  CHECK(frame.ends == 1);
  const bool told = frame.other_faults > frame.silences;
  if (pause <= limit) CHECK_FALSE(told);
  if (pause > limit + 3) CHECK(told);
  if (!told) check_whole(frame, image, 0);
}
