// SPDX-License-Identifier: Apache-2.0
// Two GigE Vision cameras that are none, for trying `horopter monitor`: fake cameras of Aravis on the loopback, which show
// pairs of pictures, a pair for some seconds. Both count by the computer's clock, so that they always show the same pair.
#include <arv.h>
#include <fmt/format.h>
#include <glob.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "horopter/base/error.hpp"
#include "horopter/image/image.hpp"

namespace {

constexpr guint64 kPicture_us = 3'000'000;
constexpr guint64 kEarly_us = 20'000;  // images begin at whole frame times of the clock, or hardly later

struct Show {
  std::vector<horopter::Image> pictures;
};

/// Called by a fake camera's thread for each image.
void fill(ArvBuffer* buffer, void* data, guint32 /*exposure_us*/, guint32 /*gain*/, ArvPixelFormat /*format*/) {
  const auto& pictures = static_cast<const Show*>(data)->pictures;
  const auto turn = (static_cast<guint64>(g_get_real_time()) + kEarly_us) / kPicture_us;
  const horopter::Image& picture = pictures[turn % pictures.size()];
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

Show load(const char* pattern) {
  glob_t found{};
  Show show;
  if (::glob(pattern, 0, nullptr, &found) == 0) {
    for (std::size_t i = 0; i < found.gl_pathc; ++i) show.pictures.push_back(horopter::load_image(found.gl_pathv[i]));
  }
  ::globfree(&found);
  if (show.pictures.empty()) throw horopter::FileError(pattern, "", "no picture", "a pattern of pictures");
  return show;
}

int play(const char* left_pattern, const char* right_pattern) {
  std::vector<Show> shows{load(left_pattern), load(right_pattern)};
  if (shows[0].pictures.size() != shows[1].pictures.size()) throw horopter::UsageError("not as many left as right");
  struct Unref {
    void operator()(ArvGvFakeCamera* camera) const { g_object_unref(camera); }
  };
  std::vector<std::unique_ptr<ArvGvFakeCamera, Unref>> cameras;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string address = fmt::format("127.0.0.{}", i + 1);
    auto& camera = cameras.emplace_back(arv_gv_fake_camera_new(address.c_str(), i == 0 ? "LEFT" : "RIGHT"));
    if (arv_gv_fake_camera_is_running(camera.get()) == FALSE) {
      throw horopter::UsageError(fmt::format(
          "no camera at {0}: add the address, `ip address add {0}/8 dev lo`; the ports of GigE Vision must be free",
          address));
    }
    arv_fake_camera_set_fill_pattern(arv_gv_fake_camera_get_fake_camera(camera.get()), fill, &shows[i]);
    fmt::print("gev:{}: {} pictures of {}\n", address, shows[i].pictures.size(), i == 0 ? left_pattern : right_pattern);
  }
  std::fflush(stdout);
  sigset_t ends;
  sigemptyset(&ends);
  sigaddset(&ends, SIGINT);
  sigaddset(&ends, SIGTERM);
  int ended = 0;
  ::sigwait(&ends, &ended);
  return 0;
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
    return play(argv[1], argv[2]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "fake-cameras: {}\n", error.what());
    return 3;
  }
}
