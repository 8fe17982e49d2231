// SPDX-License-Identifier: Apache-2.0
// The page and the log of a monitor that plays the same two pairs: for browser.py, and for trying the page by hand.
//   fake-monitor LOG USERS [PICTURES]
// Prints the port. Standard input: `alarm` and `good` say which pair comes, `blind` a fault, `quiet` that none does.
// PICTURES has good-left.png, good-right.png, good-state.png and the same of alarm-….
#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <thread>

#include "fake_control.hpp"
#include "horopter/machine/report.hpp"
#include "horopter/monitor/event_log.hpp"
#include "horopter/monitor/web.hpp"
#include "moments.hpp"

using namespace horopter;
using namespace horopter::test;

namespace {

constexpr double kFocal_px = 535;     // of the cameras that took the pictures
constexpr double kDistance_mm = 458;  // of the skin that they were compared with
constexpr auto kPeriod = std::chrono::milliseconds(60);

State state_of(std::uint8_t grey) {
  switch (grey) {
    case 0:
      return State::clear;
    case 255:
      return State::skin;
    case 64:
      return State::unsupervised;
    default:
      return State::undecidable;
  }
}

monitor::Moment from_files(const std::filesystem::path& folder, const std::string& name) {
  monitor::Moment moment;
  moment.left = load_image(folder / (name + "-left.png"));
  moment.right = load_image(folder / (name + "-right.png"));
  moment.result.states = load_image(folder / (name + "-state.png"));
  for (std::uint8_t& pixel : moment.result.states.pixels) pixel = static_cast<std::uint8_t>(state_of(pixel));
  moment.result.alarm = name == "alarm";
  moment.result.safe = !moment.result.alarm;
  moment.result.object_limit_pixels = 2000;
  moment.status = status_of(0, moment.result.alarm);
  moment.status.objects.clear();
  for (const Region& region : objects_of(moment.result)) {
    if (region.pixels < moment.result.object_limit_pixels) continue;
    monitor::ObjectState object;
    object.id = static_cast<int>(moment.status.objects.size()) + 1;
    object.pixels = region.pixels;
    object.x = region.x;
    object.y = region.y;
    object.width = region.width;
    object.height = region.height;
    object.size_mm = std::hypot(region.width, region.height) * kDistance_mm / kFocal_px;
    object.distance_mm = kDistance_mm;
    moment.status.objects.push_back(object);
  }
  return moment;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "fake-monitor LOG USERS [PICTURES]\n";
    return 2;
  }
  const bool pictures = argc > 3;
  const monitor::Moment good = pictures ? from_files(argv[3], "good") : *moment_of(0, false, 320, 240);
  const monitor::Moment alarm = pictures ? from_files(argv[3], "alarm") : *moment_of(1, true, 320, 240);
  monitor::Moment blind = good;
  blind.status.causes = {{"left_late", "The left image comes too late.", "Look at the left camera and its cable."}};

  monitor::LogSettings settings;
  settings.directory = argv[1];
  settings.configuration = "4f1c9a20";
  settings.versions = {{"horopter", "0.1.0"}};
  monitor::EventLog log(settings);
  FakeControl control;
  monitor::WebConfiguration configuration;
  configuration.title = "Cell 3, palletizer";
  configuration.port = 0;
  configuration.users = argv[2];
  configuration.look_without_login = true;
  configuration.restart_allowed = true;
  configuration.teach_allowed = true;
  const monitor::Web web(configuration,
                         {.control = &control, .log = &log, .metrics = [] { return "horopter_up 1\n"; }});
  control.add(log);

  std::atomic<const monitor::Moment*> playing = &good;
  std::atomic<bool> ending = false;
  std::thread player([&] {
    for (std::uint64_t frame = 1; !ending; ++frame) {
      if (const monitor::Moment* const now = playing; now != nullptr) {
        monitor::Moment moment = *now;
        moment.status.frame = frame;
        for (auto& camera : moment.status.cameras) camera.frames = frame;
        control.judge(std::move(moment));
      }
      std::this_thread::sleep_for(kPeriod);
    }
  });
  std::cout << web.port() << "\n" << std::flush;
  for (std::string word; std::getline(std::cin, word);) {
    if (word == "good") playing = &good;
    if (word == "alarm") playing = &alarm;
    if (word == "blind") playing = &blind;
    if (word == "quiet") playing = nullptr;
  }
  ending = true;
  player.join();
}
