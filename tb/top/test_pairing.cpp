// SPDX-License-Identifier: Apache-2.0
// Frames stay paired: random broken streams of two cameras, and a model that knows which images belong together.
//
// Both images number n show the same noise (but for a corner), of its own for every n, and the table maps every pixel onto itself. With
// a small SUM_LIMIT a frame has all its pixels in the skin, and their number is known, only if left and right belong
// together row by row. So whoever counts the skin of a published frame knows whether safe_o may be high.
//
// Not everything can be known to a machine that sees pixels and marks only: when rows are lost and others put in their
// place, or with back-pressure a whole image is gone, the marks are those of good frames. Model::knowable says so, from
// the marks alone; such streams are made again.
#include <Vhoropter_machine_hd.h>
#include <Vmachine_vga_thesis.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <memory>
#include <optional>

#include "machine_bench.hpp"

namespace horopter::tb {
namespace {

constexpr unsigned kWidth = 32, kHeight = 24, kLookahead = 8;
// A live camera's pauses, in clocks: after a row, and after an image in which the machine finishes it.
constexpr unsigned kRowPause = 8, kImagePause = 24 * (kWidth + kRowPause);
constexpr unsigned kPeriod = kHeight * (kWidth + kRowPause) + kImagePause;
constexpr unsigned kTimeout = 2 * kPeriod;
constexpr int kSumLimit = 60;          // noise that does not belong together has ten times as much
constexpr unsigned kLargestSkew = 24;  // clocks between the cameras, less than a row
// Live: safe again with this good image after the last broken one. With back-pressure: with the second one after
// CONTROL.enable has been 0.
constexpr unsigned kGoodImages = 4;
constexpr int kLongest = 12;                   // images that broken ones can keep back
constexpr unsigned kSequencesOfABench = 1000;  // then a new one: the simulation's watchdog counts all its clocks

struct Pixel {
  std::uint8_t grey = 0;
  bool first = false, last = false;
  int image = 0;        ///< its number
  unsigned place = 0;   ///< where it belongs in its image
  std::uint64_t due{};  ///< live: clock in which it is sent
  unsigned pause = 0;   ///< with back-pressure: clocks of silence before it
};
using Stream = std::vector<Pixel>;

std::uint8_t grey_of(int image, unsigned place) {
  return static_cast<std::uint8_t>(Rng{static_cast<std::uint64_t>(image) * 4096 + place}.next());
}

enum class Side { left, right };

/// Image `number` as it should be; `due` counts from its start. Both sides are the same but for a corner: one camera taken
/// for two is a fault.
Stream whole(int number, Side side) {
  Stream stream;
  for (unsigned place = 0; place < kWidth * kHeight; ++place) {
    const unsigned x = place % kWidth, y = place / kWidth;
    const unsigned corner = side == Side::right && place == 0 ? 1 : 0;
    stream.push_back({static_cast<std::uint8_t>(grey_of(number, place) ^ corner), place == 0, x == kWidth - 1, number,
                      place, y * (kWidth + kRowPause) + x});
  }
  return stream;
}

Stream::iterator at(Stream& s, std::size_t i) { return s.begin() + static_cast<std::ptrdiff_t>(i); }

/// Something breaks on the way.
void damage(Stream& s, Rng& rng, bool live) {
  const auto any = [&] { return rng.below(s.size()); };
  const auto row = [&] { return rng.below(kHeight) * kWidth; };
  // What follows a gap comes when it would have come, or at once.
  const auto erase = [&](std::size_t begin, std::size_t end) {
    begin = std::min(begin, s.size());
    end = std::min(end, s.size());
    if (begin == end) return;
    const std::uint64_t gap = end < s.size() && rng.chance(2) ? s[end].due - s[begin].due : 0;
    s.erase(at(s, begin), at(s, end));
    for (std::size_t i = begin; i < s.size(); ++i) s[i].due -= gap;
  };
  const auto repeat = [&](std::size_t begin, std::size_t end) {
    begin = std::min(begin, s.size());
    end = std::min(end, s.size());
    if (begin == end) return;
    Stream copy(at(s, begin), at(s, end));
    if (rng.chance(2)) copy.front().first = false;
    const std::uint64_t length = copy.back().due - copy.front().due + 1 + kRowPause;
    for (std::size_t i = begin; i < s.size(); ++i) s[i].due += length;
    s.insert(at(s, begin), copy.begin(), copy.end());
  };
  if (s.empty()) return;
  switch (rng.below(live ? 15 : 14)) {
    case 0:
    case 1:
      s[any()].first = true;
      break;
    case 2:
      s[std::min<std::size_t>(row(), s.size() - 1)].first = true;
      break;
    case 3:
      for (Pixel& p : s) p.first = true;
      break;
    case 4:
      for (Pixel& p : s) p.first = p.first || p.last || p.place % kWidth == 0;
      break;
    case 5: {
      const auto one_in = static_cast<unsigned>(2 + rng.below(300));
      for (Pixel& p : s) p.first ^= rng.chance(one_in);
      if (rng.chance(2)) break;
      for (Pixel& p : s) p.last ^= rng.chance(one_in);
      break;
    }
    case 6:
      s.front().first = false;
      break;
    case 7:
      s[any()].last ^= true;
      break;
    case 8: {  // rows too few
      const std::size_t from = row();
      erase(from, from + kWidth * (1 + rng.below(kHeight)));
      break;
    }
    case 9: {  // rows too many
      const std::size_t from = row();
      repeat(from, from + kWidth * (1 + rng.below(kHeight)));
      break;
    }
    case 10: {
      const std::size_t from = any();
      erase(from, from + 1 + rng.below(2 * kWidth));
      break;
    }
    case 11: {
      const std::size_t from = any();
      repeat(from, from + 1 + rng.below(2 * kWidth));
      break;
    }
    case 12:  // a stop, longer than the watchdog waits
      if (rng.chance(4)) {
        const std::size_t from = any();
        s[from].pause = kTimeout + 1000;
        for (std::size_t i = from; i < s.size(); ++i) s[i].due += kTimeout + 1000;
      }
      break;
    case 13:
      if (rng.chance(2))
        erase(0, any());
      else
        erase(any(), s.size());
      break;
    default:
      s.clear();
  }
}

/// Rows and marks as they should be, from pixel `i` on.
bool looks_whole(const Stream& s, std::size_t i) {
  if (s.size() - i < kWidth * kHeight) return false;
  for (unsigned place = 0; place < kWidth * kHeight; ++place, ++i) {
    if (s[i].first != (place == 0) || s[i].last != (place % kWidth == kWidth - 1)) return false;
  }
  return true;
}
bool is_whole(const Stream& s, std::size_t i) {
  for (unsigned place = 0; place < kWidth * kHeight; ++place) {
    if (s[i + place].image != s[i].image || s[i + place].place != place) return false;
  }
  return true;
}
bool in_one_image(const Stream& s, std::size_t i) {
  const auto other = [&](const Pixel& p) { return p.image != s[i].image; };
  return std::none_of(s.begin() + static_cast<std::ptrdiff_t>(i),
                      s.begin() + static_cast<std::ptrdiff_t>(i + kWidth * kHeight), other);
}

/// What can be said of a camera's stream that begins with image `first`.
struct Model {
  unsigned whole_images = 0;  ///< with back-pressure: frames before the first sign that something is broken
  bool knowable = true;       ///< no frame looks whole and is not

  Model(const Stream& s, int first, bool live) {
    if (live) {
      // Time separates the images: only within one image what is lost can be made up for unnoticed.
      for (std::size_t i = 0; i < s.size(); ++i) {
        if (s[i].first && looks_whole(s, i) && in_one_image(s, i) && !is_whole(s, i)) knowable = false;
      }
      return;
    }
    std::size_t i = 0;
    for (; looks_whole(s, i); i += kWidth * kHeight, ++whole_images) {
      if (!is_whole(s, i) || s[i].image != first + static_cast<int>(whole_images)) knowable = false;
    }
  }
};

class Camera final : public Endpoint {
 public:
  Camera(AxisPins<std::uint8_t> pins, bool live, Pace pace) : pins_{pins}, live_{live}, pace_{pace} {}

  void send(const Stream& stream) { pixels_.insert(pixels_.end(), stream.begin(), stream.end()); }
  void set_pace(Pace pace) { pace_ = pace; }
  bool done() const { return pixels_.empty(); }
  std::uint64_t clock() const { return clock_; }

  void drive() override {
    if (!offered_ && !pixels_.empty()) {
      Pixel& next = pixels_.front();
      offered_ = live_ ? next.due <= clock_ : next.pause == 0 && pace_.next();
      if (next.pause > 0) --next.pause;
    }
    *pins_.valid = offered_;
    if (!offered_) return;
    *pins_.data = pixels_.front().grey;
    *pins_.user = pixels_.front().first;
    *pins_.last = pixels_.front().last;
  }
  void sample() override {
    ++clock_;
    if (!offered_ || !(*pins_.ready || live_)) return;
    pixels_.pop_front();
    offered_ = false;
  }
  /// Switched off and on.
  void restart() {
    pixels_.clear();
    offered_ = false;
  }

 private:
  AxisPins<std::uint8_t> pins_;
  bool live_;
  Pace pace_;
  std::deque<Pixel> pixels_;
  std::uint64_t clock_ = 0;
  bool offered_ = false;
};

/// Counts the skin of every frame and notes the pins when it is published.
template <class Model_>
class Watcher final : public Endpoint {
 public:
  struct Frame {
    std::uint64_t clock = 0;
    unsigned skin = 0;
    bool safe = false;
  };
  std::vector<Frame> frames;

  explicit Watcher(Model_& model) : model_{model} {}
  void drive() override {}
  void sample() override {
    ++clock_;
    if (model_.frame_done_o) frames.push_back({clock_, skin_, model_.safe_o && !model_.unsafe_o});
    if (!model_.m_axis_state_tvalid || !model_.m_axis_state_tready) return;
    if (model_.m_axis_state_tuser) skin_ = 0;
    if (model_.m_axis_state_tdata == 1) ++skin_;
  }

 private:
  Model_& model_;
  std::uint64_t clock_ = 0;
  unsigned skin_ = 0;
};

template <class Model_>
class Bench {
 public:
  Bench(bool live, std::uint64_t seed)
      : live_{live},
        rng_{seed},
        machine_{"vga", {kWidth, kHeight, kLookahead, live, kTimeout}},
        left_{HOROPTER_TB_AXIS(machine_.model(), s_axis_left), live, {}},
        right_{HOROPTER_TB_AXIS(machine_.model(), s_axis_right), live, {}},
        watcher_{machine_.model()} {
    machine_.simulation().attach(left_);
    machine_.simulation().attach(right_);
    machine_.simulation().attach(watcher_);
    machine_.upload(0, 0, make_table(kWidth, kHeight, 3, 3, [](double x, double y) { return std::pair{x, y}; }));
    machine_.select(0);
    machine_.settings().sum_limit = kSumLimit;
    machine_.settings().alarm_limit = kWidth * kHeight;
    machine_.write_limits();
    restart();
    const int number = next_;
    for (int i = 0; i < 3; ++i) send_good();
    settle();
    INFO("images from " << number << " on");
    REQUIRE(watcher_.frames.size() == 3);
    all_skin_ = watcher_.frames[0].skin;
    CHECK(all_skin_ > 50);
    for (std::size_t i = 0; i < watcher_.frames.size(); ++i) {
      CHECK(watcher_.frames[i].safe == (i > 0));
      CHECK(watcher_.frames[i].skin == all_skin_);
    }
    // Images that do not belong together are told apart.
    restart();
    left_.send(whole(next_, Side::left));
    right_.send(whole(next_ + 1, Side::right));
    settle();
    REQUIRE(watcher_.frames.size() == 1);
    CHECK(watcher_.frames[0].skin < all_skin_);
  }

  /// One sequence: good images, broken ones, good ones. False: it would have been unknowable, nothing was sent.
  bool sequence() {
    const int first = next_;
    const auto before = static_cast<int>(rng_.below(3));
    const auto broken = 1 + static_cast<int>(rng_.below(3));
    const int after = 2 + (live_ ? static_cast<int>(kGoodImages) : 0);
    const auto start = left_.clock() + 10;
    std::array<Stream, 2> streams;
    int good = before + broken;  // all images from this one on are good
    for (Stream& stream : streams) {
      const bool clean = rng_.chance(3);
      const auto skew = rng_.below(kLargestSkew);
      std::uint64_t free = 0;  // the clock from which on this camera can send
      for (int i = 0; i < before + broken + kLongest + after; ++i) {
        Stream image = whole(first + i, &stream == &streams[0] ? Side::left : Side::right);
        if (i >= before && i < before + broken && !clean) {
          for (auto n = rng_.below(3); n > 0; --n) damage(image, rng_, live_);
        }
        const auto begin = start + static_cast<unsigned>(i) * kPeriod + skew;
        if (live_ && begin < free) {  // a camera that is late leaves an image out
          good = std::max(good, i + 1);
          continue;
        }
        for (Pixel& p : image) p.due += begin;
        if (!image.empty()) free = image.back().due + 1;
        stream.insert(stream.end(), image.begin(), image.end());
      }
    }
    for (Stream& stream : streams) {
      while (!stream.empty() && stream.back().image >= first + good + after) stream.pop_back();
    }
    const Model left{streams[0], first, live_}, right{streams[1], first, live_};
    if (!left.knowable || !right.knowable) return false;
    next_ += good + after;

    if (!live_) {
      restart();
      left_.set_pace(pace());
      right_.set_pace(pace());
    }
    watcher_.frames.clear();
    left_.send(streams[0]);
    right_.send(streams[1]);
    settle();
    for (std::size_t i = 0; i < watcher_.frames.size(); ++i) {
      const auto& frame = watcher_.frames[i];
      CAPTURE(i, frame.clock - start, frame.safe, frame.skin, all_skin_);
      CHECK((!frame.safe || frame.skin == all_skin_));
      if (!live_) CHECK((!frame.safe || i < std::min(left.whole_images, right.whole_images)));
    }
    if (!live_) {
      restart();
      send_good();
      send_good();
      settle();
      REQUIRE(watcher_.frames.size() == 2);
      CHECK_FALSE(watcher_.frames[0].safe);
      CHECK(watcher_.frames[1].safe);
    } else {
      // From when on it stays safe.
      std::size_t safe = watcher_.frames.size();
      while (safe > 0 && watcher_.frames[safe - 1].safe) --safe;
      REQUIRE(safe < watcher_.frames.size());
      const std::uint64_t begin = start + static_cast<unsigned>(good) * kPeriod;
      const auto clock = watcher_.frames[safe].clock;
      const auto image = clock < begin ? 1 : (clock - begin) / kPeriod + 1;
      CAPTURE(image, good);
      CHECK(image <= kGoodImages);
      latest_ = std::max<std::uint64_t>(latest_, image);
    }
    machine_.states().take();
    machine_.runs().take();
    return true;
  }
  std::uint64_t latest() const { return latest_; }

 private:
  Pace pace() {
    switch (rng_.below(3)) {
      case 0:
        return {};
      case 1:
        return Pace::random(static_cast<unsigned>(60 + rng_.below(40)), rng_.next());
      default:
        return Pace::periodic(static_cast<unsigned>(40 + rng_.below(100)), static_cast<unsigned>(1 + rng_.below(60)));
    }
  }
  void send_good() {
    Stream left = whole(next_, Side::left), right = whole(next_, Side::right);
    ++next_;
    if (live_) {
      const auto begin = std::max(good_until_, left_.clock() + 10);
      for (Pixel& p : left) p.due += begin;
      for (Pixel& p : right) p.due += begin;
      good_until_ = begin + kPeriod;
    }
    left_.send(left);
    right_.send(right);
  }
  /// Until all has been sent and nothing more comes; with back-pressure no longer than some frames take.
  void settle() {
    std::uint64_t quiet = 0;
    std::size_t frames = 0;
    for (unsigned clocks = 0; quiet < kPeriod && (live_ || clocks < 20 * kPeriod); ++clocks) {
      machine_.simulation().tick();
      const bool moved = !left_.done() || !right_.done() || watcher_.frames.size() != frames;
      frames = watcher_.frames.size();
      quiet = moved ? 0 : quiet + 1;
    }
  }
  void restart() {
    machine_.write(reg::control::kAddress, 0);
    left_.restart();
    right_.restart();
    machine_.write(reg::control::kAddress, reg::control::kEnable.put(1));
    watcher_.frames.clear();
  }

  bool live_;
  Rng rng_;
  Machine<Model_> machine_;
  Camera left_, right_;
  Watcher<Model_> watcher_;
  int next_ = 1;
  unsigned all_skin_ = 0;
  std::uint64_t good_until_ = 0, latest_ = 0;
};

template <class Model_>
void random_sequences(std::string_view purpose, unsigned count) {
  const bool live = GENERATE(false, true);
  Rng rng{purpose};
  std::unique_ptr<Bench<Model_>> bench;
  unsigned unknowable = 0;
  std::uint64_t latest = 0;
  for (unsigned done = 0; done < count;) {
    if (done % kSequencesOfABench == 0) bench = std::make_unique<Bench<Model_>>(live, rng.next());
    CAPTURE(live, done);
    const bool sent = bench->sequence();
    (sent ? done : unknowable) += 1;
    latest = std::max(latest, bench->latest());
    if (sent && done % (5 * kSequencesOfABench) == 0 && done < count) {
      std::fprintf(stderr, "%.*s, %s: %u of %u\n", static_cast<int>(purpose.size()), purpose.data(),
                   live ? "live" : "back-pressure", done, count);
    }
  }
  std::printf("%.*s, %s: %u random broken sequences, %u not knowable and made again", static_cast<int>(purpose.size()),
              purpose.data(), live ? "live" : "back-pressure", count, unknowable);
  if (live) std::printf("; safe again with good image %u", static_cast<unsigned>(latest));
  std::printf("\n");
}

/// 10⁵ of both modes together with HOROPTER_LONG. HOROPTER_SEQUENCES: that many of each, for several runs beside each
/// other with HOROPTER_SEED of their own.
unsigned sequences(unsigned short_run, unsigned long_run) {
  if (const char* asked = std::getenv("HOROPTER_SEQUENCES"))
    return static_cast<unsigned>(std::strtoul(asked, nullptr, 10));
  return std::getenv("HOROPTER_LONG") != nullptr ? long_run : short_run;
}

TEST_CASE("random broken streams: never safe with images that do not belong together", "[pairing]") {
  random_sequences<Vmachine_vga_thesis>("vga", sequences(200, 50'000));
}
TEST_CASE("random broken streams: the registers of the fast build change nothing", "[pairing]") {
  random_sequences<Vhoropter_machine_hd>("hd", sequences(30, 1'000));
}

}  // namespace
}  // namespace horopter::tb
