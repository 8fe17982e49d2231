// SPDX-License-Identifier: Apache-2.0
// How fast a live monitor with the native engine is: pairs come at a rate, a client asks for the decision by Modbus TCP. From
// the arrival of a pair's last pixel until the client has the decision (the client asks every millisecond), and CPU time.
//   benchmark-monitor [SECONDS]    of each run, 10 unless told
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "../system/monitor_machine.hpp"
#include "../system/plc.hpp"
#include "../unit/host_temporary.hpp"
#include "output/modbus.hpp"
#include "stages/engine.hpp"

namespace {

using namespace horopter;
using namespace horopter::monitor;
using monitor::Clock;
using test::since_ms;

constexpr int kWidth = 640, kHeight = 480;
constexpr int kPictures = 8;

struct Load {
  Decision rule = Decision::thesis;
  double pairs_per_s = 30;
};

double cpu_s() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// Texture of 4 px, another one each time: nothing is in the skin.
Image textured(std::uint32_t seed) {
  std::mt19937 random(seed);
  Image coarse(kWidth / 4 + 2, kHeight / 4 + 2);
  for (auto& pixel : coarse.pixels) pixel = static_cast<std::uint8_t>(20 + random() % 200);
  Image image(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) image.at(x, y) = coarse.at(x / 4, y / 4);
  }
  return image;
}

/// When each pair arrived, and was decided, in the order of the decisions.
class Recorder : public Part {
 public:
  struct Judged {
    Clock::time_point arrived;
    double decision_ms = 0;
  };
  void judged(const MomentPtr& moment) override {
    judged_.push_back({moment->arrived, moment->status.decision_ms});
    last_ = moment->status;
  }
  [[nodiscard]] const std::vector<Judged>& all() const { return judged_; }
  [[nodiscard]] const Status& last() const { return last_; }

 private:
  std::vector<Judged> judged_;
  Status last_;
};

/// The share that is not above the result.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::nan("");
  std::ranges::sort(values);
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[std::clamp<std::size_t>(rank, 1, values.size()) - 1];
}

void measure(const Load& run, double seconds) {
  const TemporaryDirectory folder;
  folder.write("skin.yaml", "surface:\n  type: homography\n  matrix: [[1, 0, -10], [0, 1, 0], [0, 0, 1]]\n");
  Cell cell;
  cell.path = folder / "cell.yaml";
  cell.frames_per_s = run.pairs_per_s;
  cell.decision_limit_ms = 1000;
  cell.settings.decision = run.rule;
  cell.settings.live = true;
  cell.settings.still_limit = 0;
  cell.settings.interlock.by_itself = true;
  cell.settings.interlock.by_pin = false;
  cell.outputs.modbus = ModbusCell{.address = "127.0.0.1", .port = test::free_port()};
  Service service(
      cell, [&](int width, int height) { return test::machine_of(cell, folder / "skin.yaml", width, height); }, kWidth,
      kHeight);
  const auto modbus = make_modbus(*cell.outputs.modbus, cell, service.safe_state());
  Recorder recorder;
  service.add(&recorder);
  service.add(modbus.get());
  std::atomic<bool> stop = false;
  std::thread decision([&] { service.run([&] { return stop.load(); }, 0); });
  const test::Plc plc(cell.outputs.modbus->port);

  std::vector<Image> pictures;
  for (std::uint32_t i = 0; i < 2 * kPictures; ++i) pictures.push_back(textured(i));
  const auto period = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1 / run.pairs_per_s));
  const auto pairs = static_cast<std::uint64_t>(seconds * run.pairs_per_s);
  for (const Side side : {Side::left, Side::right}) service.connected(side);
  const auto begin = Clock::now() + period;
  const double cpu_before_s = cpu_s() - plc.cpu_s();
  for (std::uint64_t i = 0; i < pairs; ++i) {
    const auto due = begin + static_cast<Duration::rep>(i) * period;
    std::array<CameraFrame, 2> frames;
    for (std::size_t side = 0; side < 2; ++side) {
      frames.at(side).image = pictures[2 * (i % kPictures) + side];
      frames.at(side).number = i;
      frames.at(side).taken = due.time_since_epoch();
    }
    std::this_thread::sleep_until(due);
    for (CameraFrame& frame : frames) frame.arrived = Clock::now();
    service.frame(Side::left, std::move(frames[0]));
    service.frame(Side::right, std::move(frames[1]));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const double used_s = cpu_s() - plc.cpu_s() - cpu_before_s;
  stop = true;
  decision.join();

  const auto answers = plc.answers_after({});
  std::vector<double> decision_ms, client_ms;
  std::size_t at = 0;
  for (std::size_t i = 0; i < recorder.all().size(); ++i) {
    const auto& judged = recorder.all()[i];
    decision_ms.push_back(judged.decision_ms);
    while (at < answers.size() && answers[at].heartbeat < i + 1) ++at;
    if (at < answers.size()) client_ms.push_back(since_ms(judged.arrived, answers[at].came));
  }
  const double judged = static_cast<double>(recorder.all().size());
  fmt::print("{:8} {:5g}  {:6} {:7}  {:8.1f} {:8.1f}  {:8.1f} {:8.1f} {:8.1f}  {:9.1f} {:6.2f}\n",
             run.rule == Decision::compete ? "compete" : "thesis", run.pairs_per_s, recorder.all().size(),
             recorder.last().cameras.at(0).dropped, quantile(decision_ms, 0.5), quantile(decision_ms, 0.999),
             quantile(client_ms, 0.5), quantile(client_ms, 0.999), quantile(client_ms, 1), 1000 * used_s / judged,
             used_s / judged * run.pairs_per_s);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 10;
  if (argc > 2 || !(seconds >= 1)) {
    std::cerr << "usage: benchmark-monitor [SECONDS]    of each load, at least 1; 10 by default\n";
    return 2;
  }
  fmt::print("{}x{} px, {} processors, {} threads a pair\n", kWidth, kHeight, std::thread::hardware_concurrency(),
             native::make_engine("vga", native::threads_live)->threads());
  fmt::print("                pairs          decision, ms       at the client, ms          CPU\n");
  fmt::print("rule     per s  judged dropped    median    99.9%    median    99.9%      max    ms a pair  cores\n");
  for (const Load& run : {Load{Decision::thesis, 30}, Load{Decision::compete, 30}, Load{Decision::thesis, 60}}) {
    measure(run, seconds);
  }
  return 0;
}
