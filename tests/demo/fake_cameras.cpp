// SPDX-License-Identifier: Apache-2.0
// Two GigE Vision cameras that are none, for trying `horopter monitor`: fake cameras of Aravis on the loopback, which show
// pairs of pictures, a pair for some seconds. Their clocks are one, as PTP sets them: an image is taken at a whole frame
// time of the computer's clock. They count from 65000 to 65535, and from 1 on.
//
// On standard input it takes words, and says `done` and them:
//   show clock | show N   the pair of the moment, or always the N-th, from 0
//   swap                  each shows what the other showed
//   late SIDE MS          it takes its images so much later
//   jump SIDE MS          its clock is so much ahead
//   hold SIDE N           it misses N triggers, and counts on as if it had not
//   count SIDE N          the number of its next image
//   lose SIDE SHARE       of its packets, 0 to 1
//   off SIDE              it is gone
//   on SIDE SERIAL        it is there again, with this serial number
#include <arv.h>
#include <fmt/format.h>
#include <glob.h>
#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <memory>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "horopter/base/error.hpp"
#include "horopter/image/image.hpp"

namespace {

constexpr gint64 kPicture_us = 3'000'000;
constexpr guint64 kFirst = 65'000, kLast = 65'535;  // of GigE Vision, which has no 0
constexpr double kMs_ns = 1e6;
constexpr const char* kLostShare = "gvsp-lost-ratio";  // a property of the fake camera

struct Unref {
  void operator()(ArvGvFakeCamera* camera) const { g_object_unref(camera); }
};

class Camera {
 public:
  Camera(std::string address, const char* pattern) : address_(std::move(address)) {
    glob_t found{};
    if (::glob(pattern, 0, nullptr, &found) == 0) {
      for (std::size_t i = 0; i < found.gl_pathc; ++i) own_.push_back(horopter::load_image(found.gl_pathv[i]));
    }
    ::globfree(&found);
    if (own_.empty()) throw horopter::FileError(pattern, "", "no picture", "a pattern of pictures");
    fmt::print("gev:{}: {} pictures of {}\n", address_, own_.size(), pattern);
  }

  void on(const std::string& serial) {
    off();
    // It sends nothing before `fill` allows it: not its own test picture.
    camera_.reset(
        static_cast<ArvGvFakeCamera*>(g_object_new(ARV_TYPE_GV_FAKE_CAMERA, "interface-name", address_.c_str(),
                                                   "serial-number", serial.c_str(), kLostShare, 1.0, nullptr)));
    if (arv_gv_fake_camera_is_running(camera_.get()) == FALSE) {
      throw horopter::UsageError(fmt::format(
          "no camera at {0}: add the address, `ip address add {0}/8 dev lo`; the ports of GigE Vision must be free",
          address_));
    }
    set([&] {
      running_ = camera_.get();
      slot_ = 0;
    });
    arv_fake_camera_set_fill_pattern(arv_gv_fake_camera_get_fake_camera(camera_.get()), &Camera::fill, this);
  }
  /// Its thread may still ask for an image while it goes. That one is not sent.
  void off() {
    set([&] {
      if (running_ != nullptr) g_object_set(running_, kLostShare, 1.0, nullptr);
      running_ = nullptr;
    });
    camera_.reset();
  }
  ~Camera() { off(); }
  Camera(const Camera&) = delete;
  Camera& operator=(const Camera&) = delete;
  [[nodiscard]] std::size_t pictures() const { return own_.size(); }

  // What is shown changes with the first image of a later frame time than `from_us`: so both change with the same one.
  void show(int picture, gint64 from_us) {
    set([&] { change({shown_.of, picture}, from_us); });
  }
  void swap(Camera& other, gint64 from_us) {
    const std::scoped_lock lock(mutex_, other.mutex_);
    const std::vector<horopter::Image>* const mine = shown_.of;
    change({other.shown_.of, shown_.picture}, from_us);
    other.change({mine, other.shown_.picture}, from_us);
  }
  void late(double ms) {
    set([&] { late_ms_ = ms; });
  }
  void jump(double ms) {
    set([&] { ahead_ms_ = ms; });
  }
  void hold(int images) {
    set([&] { held_ = images; });
  }
  void count(guint64 number) {
    set([&] {
      next_ = number;
      slot_ = 0;
    });
  }
  void lose(double share) {
    set([&] { lost_share_ = share; });
  }

 private:
  struct Shown {
    const std::vector<horopter::Image>* of;
    int picture = -1;  ///< by the clock
  };

  template <class Change>
  void set(const Change& change) {
    const std::lock_guard lock(mutex_);
    change();
  }
  void change(const Shown& shown, gint64 from_us) {
    before_ = std::exchange(shown_, shown);
    from_us_ = from_us;
  }

  /// Called by the fake camera's thread for each image, at a whole frame time of the clock or later.
  static void fill(ArvBuffer* buffer, void* data, guint32 /*exposure_us*/, guint32 /*gain*/,
                   ArvPixelFormat /*format*/) {
    static_cast<Camera*>(data)->fill(buffer);
  }
  void fill(ArvBuffer* buffer) {
    std::unique_lock lock(mutex_);
    if (running_ == nullptr) return;
    guint32 period_us = 0;
    arv_fake_camera_read_register(arv_gv_fake_camera_get_fake_camera(running_),
                                  ARV_FAKE_CAMERA_REGISTER_ACQUISITION_FRAME_PERIOD_US, &period_us);
    const gint64 now_us = g_get_real_time();
    const gint64 taken_us = now_us - now_us % std::max<gint64>(period_us, 1);
    const Shown& shown = taken_us > from_us_ ? shown_ : before_;
    put(buffer, (*shown.of)[static_cast<std::size_t>(shown.picture >= 0 ? shown.picture : taken_us / kPicture_us) %
                            shown.of->size()]);
    const double off_ns = kMs_ns * (late_ms_ + ahead_ms_);
    arv_buffer_set_timestamp(buffer, static_cast<guint64>(1000 * taken_us + static_cast<gint64>(off_ns)));
    // A computer that is too slow for a frame time leaves an image out, and its number.
    const gint64 slot = taken_us / std::max<gint64>(period_us, 1);
    if (slot_ != 0 && slot > slot_) next_ = after(next_, static_cast<guint64>(slot - slot_ - 1));
    slot_ = slot;
    arv_buffer_set_frame_id(buffer, next_);
    const bool held = held_ > 0;
    if (held) --held_;
    if (!held) next_ = after(next_, 1);
    g_object_set(running_, kLostShare, held ? 1.0 : lost_share_, nullptr);
    const auto late = std::chrono::duration<double, std::milli>(late_ms_);
    lock.unlock();
    std::this_thread::sleep_for(late);
  }
  static guint64 after(guint64 number, guint64 steps) { return (number + steps - 1) % kLast + 1; }
  static void put(ArvBuffer* buffer, const horopter::Image& picture) {
    std::size_t size = 0;
    auto* bytes = static_cast<std::uint8_t*>(const_cast<void*>(arv_buffer_get_data(buffer, &size)));
    const auto width = static_cast<std::size_t>(arv_buffer_get_image_width(buffer));
    const auto height = static_cast<std::size_t>(arv_buffer_get_image_height(buffer));
    std::memset(bytes, 0, size);
    const std::size_t columns = std::min(width, static_cast<std::size_t>(picture.width));
    for (std::size_t y = 0; y < std::min(height, static_cast<std::size_t>(picture.height)); ++y) {
      std::memcpy(bytes + y * width, picture.row(static_cast<int>(y)).data(), columns);
    }
  }

  std::string address_;
  std::mutex mutex_;  ///< what follows, but the last one
  std::vector<horopter::Image> own_;
  Shown shown_{&own_}, before_ = shown_;
  gint64 from_us_ = 0;  ///< what is taken later is shown_
  double late_ms_ = 0, ahead_ms_ = 0, lost_share_ = 0;
  int held_ = 0;
  guint64 next_ = kFirst;
  gint64 slot_ = 0;  ///< frame time of the last image; 0: there was none
  ArvGvFakeCamera* running_ = nullptr;
  std::unique_ptr<ArvGvFakeCamera, Unref> camera_;
};

using Cameras = std::array<Camera, 2>;

void obey(Cameras& cameras, const std::string& line) {
  std::istringstream words(line);
  std::string what, of;
  double value = 0;
  words >> what >> of;
  const gint64 now_us = g_get_real_time();
  if (what == "swap") return cameras[0].swap(cameras[1], now_us);
  if (what == "show") {
    for (Camera& camera : cameras) camera.show(of == "clock" ? -1 : std::stoi(of), now_us);
    return;
  }
  if (of != "left" && of != "right") throw horopter::UsageError(line + ": expected left or right");
  Camera& camera = cameras[of == "left" ? 0 : 1];
  if (what == "off") return camera.off();
  if (what == "on") {
    std::string serial;
    words >> serial;
    return camera.on(serial);
  }
  if (!(words >> value)) throw horopter::UsageError(line + ": expected a number");
  if (what == "late") return camera.late(value);
  if (what == "jump") return camera.jump(value);
  if (what == "hold") return camera.hold(static_cast<int>(value));
  if (what == "count") return camera.count(static_cast<guint64>(value));
  if (what == "lose") return camera.lose(value);
  throw horopter::UsageError(line + ": an unknown word");
}

/// Until a signal comes.
void listen(Cameras& cameras, const sigset_t& ends) {
  const int signals = ::signalfd(-1, &ends, SFD_CLOEXEC);
  std::array<pollfd, 2> places{pollfd{.fd = signals, .events = POLLIN, .revents = 0},
                               pollfd{.fd = 0, .events = POLLIN, .revents = 0}};
  std::string text;
  for (;;) {
    if (::poll(places.data(), places.size(), -1) < 0) continue;
    if (places[0].revents != 0) break;
    std::array<char, 256> bytes{};
    const ssize_t got = ::read(0, bytes.data(), bytes.size());
    if (got <= 0) places[1].fd = -1;  // nobody tells anything any more
    text.append(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    for (std::size_t end = 0; (end = text.find('\n')) != std::string::npos; text.erase(0, end + 1)) {
      obey(cameras, text.substr(0, end));
      fmt::print("done {}\n", text.substr(0, end));
      std::fflush(stdout);
    }
  }
  ::close(signals);
}

}  // namespace

int main(int argc, char** argv) {
  sigset_t ends;  // before the cameras' threads begin, so that they do not take them
  sigemptyset(&ends);
  sigaddset(&ends, SIGINT);
  sigaddset(&ends, SIGTERM);
  ::pthread_sigmask(SIG_BLOCK, &ends, nullptr);
  if (argc != 3) {
    fmt::print(stderr,
               "usage: fake-cameras 'LEFT*.jpg' 'RIGHT*.jpg': two GigE Vision cameras at 127.0.0.1 and 127.0.0.2\n");
    return 2;
  }
  try {
    Cameras cameras{Camera("127.0.0.1", argv[1]), Camera("127.0.0.2", argv[2])};
    if (cameras[0].pictures() != cameras[1].pictures()) throw horopter::UsageError("not as many left as right");
    cameras[0].on("LEFT");
    cameras[1].on("RIGHT");
    std::fflush(stdout);
    listen(cameras, ends);
  } catch (const std::exception& error) {
    fmt::print(stderr, "fake-cameras: {}\n", error.what());
    return 3;
  }
  return 0;
}
