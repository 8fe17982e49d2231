// SPDX-License-Identifier: Apache-2.0
// Is clear earned? Real pairs of photographs, disturbed so that the cameras do not see the same world: which ever read
// safe? And undisturbed ones: which have a false fault, and how much of what was clear stays clear?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "boards.hpp"
#include "cli/progress.hpp"
#include "cli/stereo_pairs.hpp"
#include "disturbances.hpp"
#include "horopter/base/error.hpp"
#include "horopter/machine/engines.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/machine/registers.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/map/row_check.hpp"
#include "horopter/study/parallel.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

namespace reg = registers;
using Eigen::Vector3d;

constexpr std::array kDecisions{Decision::thesis, Decision::compete};
/// How far skins are from the scene's own plane, px of disparity; above 0 they are nearer to the cameras.
constexpr std::array kSkins_px{16, 0, -16};
/// So many of them, the first ones, are tried with disturbances that are not harmless.
int disturbed_skins(const StudyScope& scope) { return scope.quick ? 1 : 2; }
constexpr int kSheet_px = 24;      ///< a sheet is nearer than the skin by this
constexpr double kOffSkin_px = 2;  ///< further off, a place is truly not in the skin
const std::string kBoards = "boards", kAloe = "aloe";
constexpr double kMostSaturated = 0.1;  ///< of a harmless image; with more it is left out

/// A pair, its rig and the plane that its skins are parallel to.
struct Scene {
  std::string set, name;
  Image left, right;
  calib::Rig rig;
  SkinPlane plane;
  std::optional<GroundTruth> truth;
  double plane_px = 0;  ///< disparity of the plane, where the truth is known
};

std::vector<Scene> board_scenes(const StudyScope& scope) {
  const auto spec = calib::TargetSpec::parse("chessboard:9x6:30mm");
  std::vector<Board> boards = load_boards(scope.data, spec);
  if (scope.quick) boards.resize(5);
  const calib::Rig rig = calibrate_boards(boards, spec, "k1k2p1p2");
  std::vector<Scene> scenes;
  for (const Board& board : boards) {
    scenes.push_back({kBoards, board.name, board.left, board.right, rig, plane_of(rig, board, spec), {}, 0});
  }
  return scenes;
}

/// Of rectified images: two cameras in a row. What their focal length and distance are makes no difference.
calib::Rig rectified_rig(const Image& image) {
  const calib::CameraModel model(calib::BrownConradyIntrinsics{.fx_px = 1.0 * image.width,
                                                               .fy_px = 1.0 * image.width,
                                                               .cx_px = 0.5 * (image.width - 1),
                                                               .cy_px = 0.5 * (image.height - 1),
                                                               .lens = {}});
  calib::Rig rig{"left camera",
                 {{"left", image.width, image.height, model, {}}, {"right", image.width, image.height, model, {}}}};
  rig.cameras[kRight].world_to_camera.translation_mm.x() = -100;
  return rig;
}

double median_disparity_px(const GroundTruth& truth) {
  std::vector<float> px;
  for (std::size_t i = 0; i < truth.disparities().px.size(); ++i) {
    if (truth.counts(i)) px.push_back(truth.disparities().px[i]);
  }
  if (px.empty()) return 0;
  const auto middle = px.begin() + static_cast<std::ptrdiff_t>(px.size() / 2);
  std::ranges::nth_element(px, middle);
  return std::round(*middle);
}

Scene pair_scene(const std::string& set, const StereoPairFiles& files) {
  const StereoPair pair = load_pair(files);
  GroundTruth truth = pair.ground_truth();
  const double px = median_disparity_px(truth);
  if (px < 1) throw FileError(files.disparity, "", "no known disparity of 1 px or more", "half of the known ones");
  const calib::Rig rig = rectified_rig(pair.left);
  const double distance_mm = pair.left.width * rig.baseline_mm() / px;
  return {set,
          pair.name,
          pair.left,
          pair.right,
          rig,
          {CameraPair(rig.cameras[kLeft], rig.cameras[kRight]), {0, 0, distance_mm}, Vector3d::UnitZ()},
          std::move(truth),
          px};
}

/// The public sets in a directory, as far as they are there.
std::vector<Scene> set_scenes(StudyReport& report, const StudyScope& scope) {
  namespace fs = std::filesystem;
  std::vector<Scene> scenes;
  const auto add = [&](const std::string& set, const fs::path& needed, const auto& pairs) {
    if (!fs::exists(needed)) {
      report.finding("{}: skipped, {} is not there", set, needed.string());
      return;
    }
    for (const StereoPairFiles& files : pairs()) {
      scenes.push_back(pair_scene(set, files));
      if (scope.quick) return;
    }
  };
  const fs::path root = scope.sets;
  const fs::path of_2003 = root / "middlebury";
  add("middlebury", of_2003, [&] {
    const auto pair = [&](const std::string& name, const char* left, const char* right, const char* truth, int scale) {
      const fs::path own = of_2003 / name;
      return StereoPairFiles{name, own / left, own / right, own / truth, 1.0 * scale, 1, {}};
    };
    return std::vector{
        pair("tsukuba", "im3.png", "im4.png", "disp3.pgm", 16), pair("venus", "im2.png", "im6.png", "disp2.pgm", 8),
        pair("teddy", "im2.png", "im6.png", "disp2.png", 4), pair("cones", "im2.png", "im6.png", "disp2.png", 4)};
  });
  for (const std::string set : {"2006", "2014", "views"}) {
    const fs::path list = root / "stereo" / (set + ".txt");
    add(set, list, [&] { return read_pair_list(list); });
  }
  return scenes;
}

std::vector<Scene> load_scenes(StudyReport& report, const StudyScope& scope) {
  std::vector<Scene> scenes;
  if (!scope.sets.empty()) return set_scenes(report, scope);
  for (const std::string& list : scope.lists) {
    for (const StereoPairFiles& files : read_pair_list(list)) scenes.push_back(pair_scene("list", files));
  }
  if (!scenes.empty()) return scenes;
  const bool boards =
      scope.window_px == 0;  // a small skin on one may have no table for `compete`: they are not rectified
  if (boards) scenes = board_scenes(scope);
  const std::string data = scope.data + "/";
  if ((!scope.quick || !boards) && std::filesystem::exists(data + "aloeL.jpg")) {
    scenes.push_back(pair_scene(kAloe, {kAloe, data + "aloeL.jpg", data + "aloeR.jpg", data + "aloeGT.png", 1, 0.5}));
  }
  return scenes;
}

/// How far the plane moves away from the cameras to be seen `px` away in the right image, nearer where that is above 0;
/// nothing where it is beyond what is infinitely far.
std::optional<double> shift_of(const Scene& scene, int px) {
  const SkinPlane& plane = scene.plane;
  if (px == 0) return 0;
  const auto pixel = plane.cameras.left().project(plane.point_mm);
  if (!pixel) return {};
  const auto depth_mm_of = [&](const calib::Camera& camera) {
    return (plane.point_mm - camera.world_to_camera.centre()).dot(plane.normal);
  };
  const double depth_mm = std::min(depth_mm_of(plane.cameras.left()), depth_mm_of(plane.cameras.right()));
  const auto source = [&](double share) { return plane.moved(share * depth_mm).source({pixel->x(), pixel->y()}); };
  const auto own = source(0);
  double near = 0;  // too little; `far` is enough
  double far = px > 0 ? -0.95 : 100;
  const auto moved_px = [&](double share) {
    const auto at = source(share);
    return at && own ? std::hypot(at->x - own->x, at->y - own->y) : 0;
  };
  if (moved_px(far) < std::abs(px)) return {};
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (near + far);
    (moved_px(middle) < std::abs(px) ? near : far) = middle;
  }
  return far * depth_mm;
}

/// A square of the moved plane, of which the left camera sees so many px around the scene's point; all of it for 0.
RigSkin skin_of(const Scene& scene, double shift_mm, int window_px) {
  const SkinPlane& plane = scene.plane;
  if (window_px == 0) return plane.moved(shift_mm);
  const calib::Camera& left = plane.cameras.left();
  const Vector3d point_mm = plane.point_mm + shift_mm * plane.normal, centre_mm = left.world_to_camera.centre();
  const auto middle = left.project(plane.point_mm);
  if (!middle) throw UsageError(fmt::format("--window: {} does not show the middle of its skin", scene.name));
  const double half = 0.5 * window_px;
  const std::vector<Point> corners{{middle->x() - half, middle->y() - half},
                                   {middle->x() + half, middle->y() - half},
                                   {middle->x() + half, middle->y() + half},
                                   {middle->x() - half, middle->y() + half}};
  Polygon polygon;
  for (const Vector3d& direction : plane.cameras.rays(corners).directions) {
    const Vector3d ray = left.world_to_camera.rotation.transpose() * direction;
    polygon.emplace_back(centre_mm + ray * ((point_mm - centre_mm).dot(plane.normal) / ray.dot(plane.normal)));
  }
  return {plane.cameras, make_polygons({polygon}), "square"};
}

cv::Mat sources_of(const RigSkin& skin, const Image& image) {
  cv::Mat result(image.height, image.width, CV_32FC2);
  std::vector<Point> row(static_cast<std::size_t>(image.width));
  std::vector<Look> looks(row.size());
  for (int y = 0; y < image.height; ++y) {
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = {static_cast<double>(x), static_cast<double>(y)};
    skin.look(row, 1, {}, looks);
    for (std::size_t x = 0; x < row.size(); ++x) {
      result.at<cv::Vec2f>(y, static_cast<int>(x)) = {static_cast<float>(looks[x].source.x),
                                                      static_cast<float>(looks[x].source.y)};
    }
  }
  return result;
}

/// A scene watched by one skin.
struct Watched {
  const Scene& scene;
  const MachineProfile& profile;
  int skin_px = 0;
  std::array<MapSet, kDecisions.size()> maps;
  cv::Mat sheet;
};

std::optional<Watched> watch(const Scene& scene, int skin_px, int window_px) {
  const auto shift_mm = shift_of(scene, skin_px);
  const auto sheet_mm = shift_of(scene, skin_px + kSheet_px);
  const MachineProfile* const profile = smallest_profile(scene.left.width, scene.left.height);
  if (!shift_mm || !sheet_mm || profile == nullptr) return {};
  Watched result{scene, *profile, skin_px, {}, sources_of(skin_of(scene, *sheet_mm, 0), scene.left)};
  for (std::size_t d = 0; d < kDecisions.size(); ++d) {
    SkinFile file;
    file.skin = std::make_unique<RigSkin>(skin_of(scene, *shift_mm, window_px));
    file.path = fmt::format("the skin of {}, {:+} px", scene.name, skin_px);
    file.rig = calib::to_yaml(scene.rig);
    result.maps[d] =
        compile_maps(file, *profile, scene.left.width, scene.left.height, view_limits(*profile, kDecisions[d]));
  }
  return result;
}

/// What became of one pair with one disturbance by one rule.
struct Run {
  const Watched* watched = nullptr;
  const Disturbance* disturbance = nullptr;
  Decision decision = Decision::thesis;
  int frames = 0;
  int safe = 0;  ///< of the frames, neither alarm nor fault
  int alarms = 0;
  int faulty = 0;
  Faults faults;
  FrameResult last;  ///< without its picture
  std::array<double, 4> across_px{};
  std::array<int, 4> across_cells{};
  std::array<std::uint32_t, 2> detail{}, contrast{};
  std::int64_t clear = 0;  ///< of an undisturbed run, without proof
  std::int64_t kept = 0;   ///< of these

  bool last_safe() const { return !last.alarm && !last.faults.any(); }
};

/// What FrameResult does not say of the last frame.
void read_sums(Run& run, Device& device, double cell) {
  constexpr int kSign = 1 << (reg::frame_across_0::kSum.bits - 1);
  for (std::uint32_t i = 0; i < 4; ++i) {
    const auto word = device.read(reg::frame_across_0::kAddress + 4 * i);
    const int sum = (static_cast<int>(reg::frame_across_0::kSum.get(word)) ^ kSign) - kSign;
    run.across_cells[i] = static_cast<int>(reg::frame_across_0::kCells.get(word));
    run.across_px[i] = cell / 32 * sum / std::max(1, run.across_cells[i]);
  }
  for (std::uint32_t i = 0; i < 2; ++i) {
    run.detail[i] = device.read(reg::frame_detail_left::kAddress + 4 * i);
    run.contrast[i] = device.read(reg::frame_contrast_left::kAddress + 4 * i);
  }
}

/// Pixels that are clear without proof, truly behind the skin and seen by both cameras, and how many of them are clear in
/// `states`. All count where no truth is known. Of what is nearer than the skin, clear is not earned.
void compare_clear(Run& run, const Image& without, const Image& states) {
  const auto& truth = run.watched->scene.truth;
  const double skin_px = run.watched->scene.plane_px + run.watched->skin_px;
  for (std::size_t i = 0; i < states.pixels.size(); ++i) {
    if (static_cast<State>(without.pixels[i]) != State::clear) continue;
    if (truth && (!truth->counts(i) || truth->disparities().px[i] >= skin_px - kOffSkin_px)) continue;
    ++run.clear;
    run.kept += static_cast<State>(states.pixels[i]) == State::clear ? 1 : 0;
  }
}

/// Gives the frames to a machine and returns the last ones.
std::array<Image, 2> supervise(Run& run, Supervisor supervisor, int count, const Disturbed& disturbed, cv::RNG random) {
  std::array<Image, 2> frames;
  for (run.frames = 0; run.frames < count; ++run.frames) {
    frames = disturbed.frames(random);
    run.last = std::move(supervisor.process(frames[kLeft], frames[kRight]).front());
    run.safe += run.last_safe() ? 1 : 0;
    run.alarms += run.last.alarm ? 1 : 0;
    run.faulty += run.last.faults.any() ? 1 : 0;
    run.faults |= run.last.faults;
  }
  read_sums(run, supervisor.monitor().device(), run.watched->profile.cell());
  return frames;
}

void supervise(Run& run, const StudyScope& scope, const Disturbed& disturbed, std::uint64_t seed) {
  const MachineProfile& profile = run.watched->profile;
  const MapSet& maps = run.watched->maps[run.decision == Decision::compete ? 1 : 0];
  Settings settings;
  settings.decision = run.decision;
  settings.still_limit = 0;  // the scene stands still
  if (scope.window_px > 0) settings.object_px = std::min(settings.object_px, 0.5 * scope.window_px);
  const auto machine = [&](const Settings& of) {
    return Supervisor(make_device(scope.engine, profile), profile, maps, of);
  };
  const auto [left, right] = supervise(run, machine(settings), scope.frames, disturbed, cv::RNG(seed));
  if (run.disturbance->harmless) {
    compare_clear(run, machine(settings.without_proof()).process(left, right).front().states, run.last.states);
  }
  run.last.states = {};
  run.last.runs = {};
}

double saturated_share(const cv::Mat& image) {
  return 1.0 * (cv::countNonZero(image == 0) + cv::countNonZero(image == 255)) / static_cast<double>(image.total());
}

/// One place in `runs` for each decision; left without frames where a harmless disturbance saturates too much.
void run_both(std::span<Run> runs, const StudyScope& scope, const Scene& other, std::uint64_t seed) {
  const auto grey = [](const Image& image) { return cv::Mat(image.pixels).reshape(1, image.height); };
  const Scene& scene = runs[0].watched->scene;
  Sight sight{{grey(scene.left), grey(scene.right)}, {grey(other.left), grey(other.right)}, runs[0].watched->sheet};
  for (const std::size_t camera : {kLeft, kRight}) {
    cv::resize(sight.other[camera], sight.other[camera], sight.scene[camera].size(), 0, 0, cv::INTER_AREA);
  }
  const Disturbed disturbed = runs[0].disturbance->disturb(sight);
  if (runs[0].disturbance->harmless && saturated_share(disturbed.light[kRight]) > kMostSaturated) return;
  for (Run& run : runs) supervise(run, scope, disturbed, seed);
}

std::vector<Watched> watch_all(StudyReport& report, std::span<const Scene> scenes, int window_px) {
  std::vector<std::optional<Watched>> found(scenes.size() * kSkins_px.size());
  Progress progress("tables for skin");
  study::parallel_for(
      found.size(),
      [&](std::size_t i) {
        if (auto one = watch(scenes[i / kSkins_px.size()], kSkins_px[i % kSkins_px.size()], window_px))
          found[i].emplace(std::move(*one));
      },
      [&](std::size_t done) { progress.show(done, found.size()); });
  std::vector<Watched> result;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::string& name = scenes[i / kSkins_px.size()].name;
    if (found[i]) {
      result.push_back(std::move(*found[i]));
    } else {
      report.finding("{}: no skin {:+} px from its plane", name, kSkins_px[i % kSkins_px.size()]);
    }
  }
  return result;
}

std::vector<Run> run_all(const StudyScope& scope, const std::vector<Scene>& scenes, const std::vector<Watched>& watched,
                         const std::vector<Disturbance>& what) {
  std::vector<Run> runs;
  for (const Watched& one : watched) {
    const bool disturbed = std::ranges::find(kSkins_px, one.skin_px) < kSkins_px.begin() + disturbed_skins(scope);
    for (const Disturbance& disturbance : what) {
      if (!disturbed && !disturbance.harmless) continue;
      for (const Decision decision : kDecisions) {
        Run& run = runs.emplace_back();
        run.watched = &one;
        run.disturbance = &disturbance;
        run.decision = decision;
      }
    }
  }
  Progress progress("run");
  const std::size_t together = kDecisions.size();
  study::parallel_for(
      runs.size() / together,
      [&](std::size_t i) {
        const std::span<Run> both(runs.data() + i * together, together);
        const auto place = static_cast<std::size_t>(&both[0].watched->scene - scenes.data());
        run_both(both, scope, scenes[(place + 1) % scenes.size()], scope.seed * 1'000'003 + i);
      },
      [&](std::size_t done) { progress.show(done * together, runs.size()); });
  return runs;
}

std::string text(const std::optional<double>& value) { return value ? fmt::format("{:.6g}", *value) : ""; }

/// A row for each run. Figures of agreement are its last frame's; quarters of the image: upper left, upper right, lower
/// left, lower right.
Csv table_of(const std::vector<Run>& runs) {
  Csv csv({"set,scene,skin_px,decision,disturbance,camera,harmless",
           "frames,safe_frames,alarm_frames,fault_frames,last_safe,faults",
           "supervised,textured,explained,nearer,unproven,bad_regions,across_px,roll_deg,scale",
           "across_0_px,across_1_px,across_2_px,across_3_px,cells_0,cells_1,cells_2,cells_3",
           "detail_left,detail_right,contrast_left,contrast_right,sharpness_left,sharpness_right",
           "skin_pixels,hidden_pixels,unproven_pixels,undecidable_pixels,clear_without_proof,clear_kept"});
  for (const Run& run : runs) {
    const Agreement& seen = run.last.agreement;
    csv << run.watched->scene.set << run.watched->scene.name << run.watched->skin_px
        << std::string(name_of(run.decision)) << run.disturbance->name << run.disturbance->camera
        << run.disturbance->harmless << run.frames << run.safe << run.alarms << run.faulty
        << (run.frames > 0 && run.last_safe()) << fmt::format("{}", fmt::join(run.faults.names(), " "))
        << seen.supervised << seen.textured << seen.explained << seen.nearer << seen.unproven << seen.bad_regions
        << text(seen.across_px) << text(seen.roll_deg) << text(seen.scale);
    for (const double px : run.across_px) csv << px;
    for (const int cells : run.across_cells) csv << cells;
    for (const auto& both : {run.detail, run.contrast}) csv << both[kLeft] << both[kRight];
    csv.row(seen.sharpness[kLeft], seen.sharpness[kRight], run.last.skin_pixels, run.last.hidden_pixels,
            run.last.unproven_pixels, run.last.undecidable_pixels, run.clear, run.kept);
  }
  return csv;
}

/// Runs of one line of a table: as many as there are scenes.
struct Line {
  int runs = 0, safe = 0, last_safe = 0, faulty = 0, alarms = 0;
  std::map<std::string, std::vector<std::string>> faults;  ///< which scenes have it
  std::vector<std::string> saturated;

  void add(const Run& run) {
    const std::string& scene = run.watched->scene.name;
    if (run.frames == 0) {
      saturated.push_back(scene);
      return;
    }
    ++runs;
    safe += run.safe > 0 ? 1 : 0;
    last_safe += run.last_safe() ? 1 : 0;
    faulty += run.faulty > 0 ? 1 : 0;
    alarms += run.alarms > 0 ? 1 : 0;
    for (const std::string& fault : run.faults.names()) faults[fault].push_back(scene);
  }
  std::string text(bool harmless) const {
    std::string result = harmless ? fmt::format("{:4} runs  {:3} false fault  {:3} alarm", runs, faulty, alarms)
                                  : fmt::format("{:4} runs  {:3} safe ({} at the end)  {:3} fault  {:3} alarm ", runs,
                                                safe, last_safe, faulty, alarms);
    for (const auto& [fault, scenes] : faults) {
      result += fmt::format("  {} {}", fault, scenes.size());
      if (harmless) result += fmt::format(" ({})", fmt::join(scenes, " "));
    }
    if (!saturated.empty()) result += fmt::format("  left out, saturated: {}", fmt::join(saturated, " "));
    return result;
  }
};

/// Of pixels that are clear without proof, how many stay clear.
struct Kept {
  std::int64_t clear = 0, kept = 0;
  double worst = 1;
  std::string worst_scene;

  double share() const { return clear > 0 ? static_cast<double>(kept) / static_cast<double>(clear) : 1; }
  void add(const Run& run) {
    clear += run.clear;
    kept += run.kept;
    const double own = run.clear > 0 ? static_cast<double>(run.kept) / static_cast<double>(run.clear) : 1;
    if (own >= worst) return;
    worst = own;
    worst_scene = run.watched->scene.name + ", " + run.disturbance->name;
  }
};

std::string title_of(const Run& run) {
  const int px = run.watched->skin_px;
  return fmt::format("{}, {}, skin {}", run.watched->scene.set, name_of(run.decision),
                     px == 0  ? "in the scene"
                     : px > 0 ? fmt::format("{} px nearer", px)
                              : fmt::format("{} px further", -px));
}

/// Of one set of scenes, one skin and one rule: a line for each disturbance.
void report_table(StudyReport& report, const std::string& title, const std::vector<const Run*>& runs,
                  const std::vector<Disturbance>& what) {
  report.finding("{}", title);
  Kept kept;
  int harmless = 0, faulty = 0;
  std::size_t saturated = 0;
  for (const Disturbance& disturbance : what) {
    Line line;
    for (const Run* run : runs) {
      if (run->disturbance != &disturbance) continue;
      line.add(*run);
      if (disturbance.harmless && run->frames > 0) kept.add(*run);
    }
    if (line.runs == 0 && line.saturated.empty()) continue;
    harmless += disturbance.harmless ? line.runs : 0;
    faulty += disturbance.harmless ? line.faulty : 0;
    saturated += line.saturated.size();
    report.finding("  {:32} {:5} {}", disturbance.name, disturbance.camera, line.text(disturbance.harmless));
    nlohmann::json faults = nlohmann::json::object();
    for (const auto& [fault, scenes] : line.faults) faults[fault] = scenes.size();
    const Run& first = **std::ranges::find(runs, &disturbance, &Run::disturbance);
    report.result["lines"].push_back({{"set", first.watched->scene.set},
                                      {"skin_px", first.watched->skin_px},
                                      {"decision", name_of(first.decision)},
                                      {"disturbance", disturbance.name},
                                      {"camera", disturbance.camera},
                                      {"harmless", disturbance.harmless},
                                      {"runs", line.runs},
                                      {"safe", line.safe},
                                      {"last_safe", line.last_safe},
                                      {"faulty", line.faulty},
                                      {"alarms", line.alarms},
                                      {"faults", faults},
                                      {"saturated", line.saturated}});
  }
  report.finding("  of {} undisturbed runs {} had a false fault; {} more are left out, saturated", harmless, faulty,
                 saturated);
  report.finding("  of what is clear without proof, {:.3f} stays clear; least {:.3f}{}", kept.share(), kept.worst,
                 kept.worst_scene.empty() ? "" : " (" + kept.worst_scene + ")");
  report.result["kept"].push_back({{"table", title}, {"share", kept.share()}, {"least", kept.worst}});
}

/// Of the public sets: a line for each set and rule, and one for each skin of it.
void report_sets(StudyReport& report, const std::vector<Run>& runs) {
  struct Of {
    Kept kept;
    int runs = 0, faulty = 0, saturated = 0;
    void add(const Run& run) {
      if (run.frames == 0) {
        ++saturated;
        return;
      }
      if (run.disturbance->name == kAsItIs) kept.add(run);
      ++runs;
      faulty += run.faulty > 0 ? 1 : 0;
    }
  };
  std::map<std::array<std::string, 3>, Of> lines;
  for (const Run& run : runs) {
    const std::string& set = run.watched->scene.set;
    for (const std::string& skin : {fmt::format("{:+} px", run.watched->skin_px), std::string("all")})
      lines[{set, std::string(name_of(run.decision)), skin}].add(run);
  }
  report.finding(
      "of the pixels that are truly behind the skin, seen by both cameras and clear without proof, so many stay clear:");
  for (const auto& [name, line] : lines) {
    const auto& [set, decision, skin] = name;
    report.finding(
        "  {:12} {:8} skin {:7} {:.3f}  least {:.3f} ({})  {} of {} runs with a false fault; {} more left out, saturated",
        set, decision, skin, line.kept.share(), line.kept.worst, line.kept.worst_scene, line.faulty, line.runs,
        line.saturated);
    report.result["sets"].push_back({{"set", set},
                                     {"decision", decision},
                                     {"skin", skin},
                                     {"kept", line.kept.share()},
                                     {"least", line.kept.worst},
                                     {"runs", line.runs},
                                     {"false_faults", line.faulty},
                                     {"saturated", line.saturated}});
  }
}

/// Where the pair is an alarm as it is, something is in the skin: disturbed it must not be safe.
void report_missed(StudyReport& report, std::span<const Run> runs) {
  for (const Decision decision : kDecisions) {
    const auto is_alarm = [&](const Watched* watched) {
      return std::ranges::any_of(runs, [&](const Run& run) {
        return run.watched == watched && run.decision == decision && run.disturbance->name == kAsItIs && run.last.alarm;
      });
    };
    int disturbed = 0, safe = 0, last_safe = 0;
    for (const Run& run : runs) {
      if (run.decision != decision || run.disturbance->harmless || run.frames == 0 || !is_alarm(run.watched)) continue;
      ++disturbed;
      safe += run.safe > 0 ? 1 : 0;
      last_safe += run.last_safe() ? 1 : 0;
    }
    report.finding("{}: of {} disturbed runs of pairs that are an alarm as they are {} were ever safe, {} at the end",
                   name_of(decision), disturbed, safe, last_safe);
    report.result["missed"].push_back(
        {{"decision", name_of(decision)}, {"runs", disturbed}, {"safe", safe}, {"last_safe", last_safe}});
  }
}

}  // namespace

void study_earned(StudyReport& report, const StudyScope& scope) {
  const std::vector<Scene> scenes = load_scenes(report, scope);
  std::vector<Disturbance> what = disturbances(scope.harder);
  const bool of_sets = !scope.sets.empty();
  if (of_sets)
    std::erase_if(what, [&](const Disturbance& one) { return !one.harmless || (scope.quick && one.name != kAsItIs); });
  const std::vector<Watched> watched =
      watch_all(report, std::span(scenes).first(scope.quick && !of_sets ? 1 : scenes.size()), scope.window_px);
  const std::vector<Run> runs = run_all(scope, scenes, watched, what);
  std::vector<std::pair<std::string, std::vector<const Run*>>> tables;  // in the order of their first runs
  int disturbed = 0;
  int safe = 0;
  int harmless = 0;
  int faulty = 0;
  auto saturated = nlohmann::json::array();
  for (const Run& run : runs) {
    const std::string title = title_of(run);
    auto table = std::ranges::find(tables, title, &decltype(tables)::value_type::first);
    if (table == tables.end()) table = tables.insert(table, {title, {}});
    table->second.push_back(&run);
    (run.disturbance->harmless ? harmless : disturbed) += run.frames > 0 ? 1 : 0;
    safe += !run.disturbance->harmless && run.safe > 0 ? 1 : 0;
    faulty += run.disturbance->harmless && run.faulty > 0 ? 1 : 0;
    if (run.frames > 0) continue;
    saturated.push_back({{"set", run.watched->scene.set},
                         {"scene", run.watched->scene.name},
                         {"skin_px", run.watched->skin_px},
                         {"decision", name_of(run.decision)},
                         {"disturbance", run.disturbance->name}});
  }
  for (const auto& [title, of_table] : tables) report_table(report, title, of_table, what);
  if (of_sets) report_sets(report, runs);
  if (!of_sets) report_missed(report, runs);
  report.finding(
      "of {} disturbed runs {} were ever safe; of {} undisturbed ones {} had a false fault; {} more are left out: more than "
      "{:g} % of the right image saturates",
      disturbed, safe, harmless, faulty, saturated.size(), 100 * kMostSaturated);
  report.result["disturbed"] = disturbed;
  report.result["safe"] = safe;
  report.result["harmless"] = harmless;
  report.result["false_faults"] = faulty;
  report.result["saturated"] = std::move(saturated);
  report.result["frames"] = scope.frames;
  report.result["engine"] = scope.engine;
  report.table("runs.csv", table_of(runs));
}

}  // namespace horopter::cli
