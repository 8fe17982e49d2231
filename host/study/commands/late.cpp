// SPDX-License-Identifier: Apache-2.0
// One camera a frame late, while a large thing moves behind the skin: how many frames are safe? And with cameras in step?
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "cli/progress.hpp"
#include "horopter/base/interval.hpp"
#include "horopter/calib/random.hpp"
#include "horopter/machine/engines.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/study/parallel.hpp"
#include "horopter/study/scene.hpp"
#include "photographs.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using Eigen::Vector3d;

constexpr int kRest = 3;         ///< frames before it moves
constexpr int kMoving = 8;       ///< frames
constexpr double kLeast_px = 4;  ///< that it moves from frame to frame
constexpr double kMost_px = 16;
constexpr double kShare = 0.1;  ///< of the left image, at least, that it covers
constexpr double kGoal = 0.95;  ///< of the frames in which it moves must not be safe
constexpr std::array kRules{Decision::thesis, Decision::compete};
constexpr std::array kWays{"along the row", "aslant", "across the rows"};

/// A plate of rods side by side, textured.
std::vector<Capsule> plate() {
  constexpr double kThick_mm = 40, kLength_mm = 300;
  std::vector<Capsule> segments;
  for (int i = -3; i <= 3; ++i) {
    for (Capsule rod : study::rod_segments(kThick_mm, kLength_mm)) {
      rod.from_mm.y() += 0.8 * kThick_mm * i;
      rod.to_mm.y() += 0.8 * kThick_mm * i;
      segments.push_back(rod);
    }
  }
  return segments;
}

struct Counts {
  std::int64_t frames = 0, safe = 0;
  std::map<std::string, std::int64_t> faults;

  void add(const FrameResult& frame) {
    ++frames;
    if (frame.alarm) ++faults["alarm"];
    for (const std::string& name : frame.faults.names()) ++faults[name];
    safe += !frame.alarm && !frame.faults.any() ? 1 : 0;
  }
  void add(const Counts& other) {
    frames += other.frames;
    safe += other.safe;
    for (const auto& [name, count] : other.faults) faults[name] += count;
  }
  double not_safe() const { return frames == 0 ? 0 : 1 - static_cast<double>(safe) / static_cast<double>(frames); }
};

/// Of each way, rule, and whether the right camera is late.
using All = std::array<std::array<std::array<Counts, 2>, kRules.size()>, kWays.size()>;

struct Scene {
  const MachineProfile& profile;
  CameraPair cameras;
  std::array<MapSet, kRules.size()> maps;
  std::vector<std::pair<std::string, Image>> photographs;
};

Scene prepare_scene(const StudyScope& scope) {
  const calib::Rig rig = make_rig(kRig);
  Scene scene{find_profile("vga"), CameraPair(rig.cameras[0], rig.cameras[1]), {}, load_photographs(scope)};
  for (std::size_t r = 0; r < kRules.size(); ++r) {
    scene.maps[r] = plane_maps(rig, scene.profile, kRules[r]);
  }
  return scene;
}

double covered(const study::WallScene::Views& with, const study::WallScene::Views& without) {
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < with[0].values.size(); ++i) pixels += with[0].values[i] != without[0].values[i] ? 1 : 0;
  return static_cast<double>(pixels) / static_cast<double>(with[0].values.size());
}

/// A run of one way and pace.
void run(const Scene& scene, const StudyScope& scope, std::size_t number, All& all) {
  calib::Random random(scope.seed, 0x1A7E + number);
  const auto between = [&](double low, double high) { return low + (high - low) * random.uniform(); };
  const std::size_t way = number % kWays.size();
  const auto& photograph = scene.photographs[number / kWays.size() % scene.photographs.size()].second;
  const Vector3d normal = Vector3d(between(-0.15, 0.15), between(-0.15, 0.15), -1).normalized();
  const study::WallScene wall(scene.cameras, photograph, {0, 0, between(1000, 1300)}, normal);

  const double depth_mm = between(kSkin_mm + 60, 960), pace_px = between(kLeast_px, kMost_px);
  constexpr double kTurn = std::numbers::pi / 4;
  const double angle =
      kTurn * static_cast<double>(way) + between(-0.5, 0.5) * kTurn + (random.uniform() < 0.5 ? 0 : std::numbers::pi);
  const Vector3d step_mm = pace_px * depth_mm / kRig.f_px() * Vector3d(std::cos(angle), std::sin(angle), 0);
  const Vector3d middle(between(-20, 20), between(-20, 20), depth_mm);
  Eigen::Matrix3d axes = Eigen::AngleAxisd(between(0, 2 * std::numbers::pi), Vector3d::UnitZ()).toRotationMatrix();
  axes.col(1) = -axes.col(1);
  axes.col(2) = -Vector3d::UnitZ();
  const auto at = [&](int frame) {
    const double steps = std::max(frame - kRest, -1) - 0.5 * kMoving;
    return wall.with_body(study::place(plate(), middle + steps * step_mm, axes), study::Coat::textured, number);
  };

  std::vector<std::unique_ptr<Supervisor>> machines;
  for (std::size_t i = 0; i < 2 * kRules.size(); ++i) {
    Settings settings;
    settings.decision = kRules[i / 2];
    settings.interlock.by_itself = true;
    machines.push_back(std::make_unique<Supervisor>(make_device(scope.engine, scene.profile), scene.profile,
                                                    scene.maps[i / 2], settings));
  }
  study::WallScene::Views before = at(0);
  for (int frame = 0; frame < kRest + kMoving; ++frame) {
    const study::WallScene::Views now = at(frame);
    const auto image = [&](const study::Raster<float>& view, std::uint64_t camera) {
      return study::expose(view, kNoise_grey, scope.seed,
                           (number << 16U) + 4 * static_cast<std::uint64_t>(frame) + camera);
    };
    const Image left = image(now[0], 0);
    const std::array right{image(now[1], 1), image(before[1], 2)};
    const bool counts = frame >= kRest && covered(now, wall.empty()) >= kShare;
    for (std::size_t i = 0; i < machines.size(); ++i) {
      const FrameResult result = machines[i]->process(left, right[i % 2]).front();
      if (counts) all[way][i / 2][i % 2].add(result);
    }
    before = now;
  }
}

}  // namespace

void study_late(StudyReport& report, const StudyScope& scope) {
  const Scene scene = prepare_scene(scope);
  const auto runs = static_cast<std::size_t>(scope.crossings) * kWays.size() * scene.photographs.size();
  std::vector<All> of_runs(runs);
  Progress progress("run");
  study::parallel_for(
      runs, [&](std::size_t i) { run(scene, scope, i, of_runs[i]); },
      [&](std::size_t done) { progress.show(done, runs); });
  progress.clear();

  All all;
  for (const All& one : of_runs) {
    for (std::size_t w = 0; w < kWays.size(); ++w) {
      for (std::size_t r = 0; r < kRules.size(); ++r) {
        for (std::size_t late = 0; late < 2; ++late) all[w][r][late].add(one[w][r][late]);
      }
    }
  }
  Csv csv({"way", "decision", "right_camera", "frames", "safe", "not_safe_share", "found"});
  for (std::size_t r = 0; r < kRules.size(); ++r) {
    for (std::size_t late = 0; late < 2; ++late) {
      Counts sum;
      for (std::size_t w = 0; w < kWays.size(); ++w) {
        const Counts& counts = all[w][r][late];
        std::vector<std::string> found;
        for (const auto& [name, count] : counts.faults) found.push_back(fmt::format("{}:{}", name, count));
        csv.row(kWays[w], std::string(name_of(kRules[r])), late == 0 ? "in step" : "a frame late", counts.frames,
                counts.safe, counts.not_safe(), fmt::format("{}", fmt::join(found, " ")));
        sum.add(counts);
      }
      const auto [low, high] = wilson(sum.frames - sum.safe, sum.frames);
      report.finding("{}, right camera {}: {} of {} frames not safe, {:.3f} [{:.3f}, {:.3f}]", name_of(kRules[r]),
                     late == 0 ? "in step" : "a frame late", sum.frames - sum.safe, sum.frames, sum.not_safe(), low,
                     high);
      report.result[late == 0 ? "in_step" : "late"][name_of(kRules[r])] = {
          {"frames", sum.frames}, {"safe", sum.safe}, {"goal", kGoal}};
    }
  }
  report.table("late.csv", csv);
}

}  // namespace horopter::cli
