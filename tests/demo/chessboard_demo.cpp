// SPDX-License-Identifier: Apache-2.0
// The whole path on real photographs: 13 pairs of a chessboard from opencv-doc. The corners of the board in both images
// give the skin that lies on the board; it must be found there, and not on skins displaced by some disparity.
//
// A machine for each processor, while there are pairs enough, has its share of them. Tables are uploaded while they run and switched at every frame.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cli/progress.hpp"
#include "horopter/base/error.hpp"
#include "horopter/draw/overlay.hpp"
#include "horopter/image/image.hpp"
#include "horopter/image/mat.hpp"
#include "horopter/image/output.hpp"
#include "horopter/machine/engines.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/machine/report.hpp"
#include "horopter/map/map.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/study/parallel.hpp"
#include "study/commands/board_pixels.hpp"
#ifdef HOROPTER_HAS_RTL
#include "horopter/machine/rtl_device.hpp"
#endif

namespace horopter {
namespace {

// What the project promises for these pairs, as averages.
constexpr double kLeastDecidable = 0.33;
constexpr double kLeastInSkin = 0.90;
constexpr double kMostDisplaced = 0.12;
constexpr int kMostDisplacedAlarms = 2;

constexpr int kSkins = 3;  // on the board, displaced to either side
constexpr int kSlots = 15;

struct Options {
  std::string data = "/usr/share/doc/opencv-doc/examples/data";
  std::string out = "out/demo";
#ifdef HOROPTER_HAS_RTL
  std::string engine = "rtl";
#else
  std::string engine = "native";
#endif
  double displacement_px = 16;
  std::size_t pairs = 100;
  bool compare = true;
  bool json = false;
  Settings settings;
};

/// What one skin shows of the board.
struct Found : cli::BoardPixels {
  bool alarm = false;
};

struct Pair {
  std::string name;
  Image left;
  Image right;
  std::vector<cv::Point2d> board;  ///< inner corners in the left image
  std::array<std::optional<CompiledMap>, kSkins> maps;
  std::array<Found, kSkins> found;
};

std::vector<cv::Point2f> corners_of(const Image& image, const std::string& name) {
  const cv::Mat grey = mat_of(image);
  std::vector<cv::Point2f> corners;
  if (!cv::findChessboardCorners(grey, {9, 6}, corners)) {
    throw FileError(name, "", "no chessboard in the image", "a board with 9x6 inner corners");
  }
  cv::cornerSubPix(grey, corners, {5, 5}, {-1, -1}, {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 30, 0.01});
  return corners;
}

/// The skin on the board, moved by `shift_px` along the rows of the right image.
Matrix3 displaced(const Matrix3& skin, double shift_px) {
  Matrix3 moved = skin;
  for (std::size_t column = 0; column < 3; ++column) moved[column] += shift_px * skin[6 + column];
  return moved;
}

Pair load_pair(const Options& options, const std::string& number, const MachineProfile& profile) {
  Pair pair;
  const std::filesystem::path data(options.data);
  const auto left_path = data / ("left" + number + ".jpg");
  const auto right_path = data / ("right" + number + ".jpg");
  pair.name = number;
  pair.left = load_image(left_path);
  pair.right = load_image(right_path);
  if (pair.left.width != pair.right.width || pair.left.height != pair.right.height) {
    throw FileError(right_path.string(), "", "another size than the left image", "the same size");
  }
  const auto left = corners_of(pair.left, left_path.string());
  const auto right = corners_of(pair.right, right_path.string());
  std::vector<Correspondence> points;
  for (std::size_t i = 0; i < left.size(); ++i) {
    points.push_back({{left[i].x, left[i].y}, {right[i].x, right[i].y}});
    pair.board.emplace_back(left[i]);
  }
  const Matrix3 skin = fit_homography(points).matrix;
  const std::array<double, kSkins> shifts{0, options.displacement_px, -options.displacement_px};
  for (std::size_t i = 0; i < kSkins; ++i) {
    const HomographySkin moved(displaced(skin, shifts[i]), points.front().left);
    pair.maps[i] = compile_map(moved, profile, {pair.left.width, pair.left.height, Scan::progressive});
  }
  return pair;
}

struct Clocks {
  std::uint32_t cycles = 0;
  std::uint32_t latency = 0;
  std::uint32_t tail = 0;

  void of(const auto& other) {
    cycles = std::max(cycles, other.cycles);
    latency = std::max(latency, other.latency);
    tail = std::max(tail, other.tail);
  }
};

/// What sees a share of the pairs: the engine, and where it is compared, the native one, which must see the same.
class Machine {
 public:
  Machine(const Options& options, const MachineProfile& profile, const Settings& settings)
      : monitor_(make_device(options.engine, profile), profile, settings) {
    if (options.compare && options.engine != "native") {
      twin_.emplace(make_device("native", profile), profile, settings);
    }
  }

  void start(int width, int height, int lookahead) {
    monitor_.start(width, height, lookahead);
    if (twin_) twin_->start(width, height, lookahead);
  }
  FrameResult process(const Pair& pair, std::size_t skin) {
    const int slot = frames_++ % kSlots;
    FrameResult result = process(monitor_, slot, pair, skin);
    if (twin_) different_ += process(*twin_, slot, pair, skin).states == result.states ? 0 : 1;
    faults_ |= result.faults;
    worst_.of(result);
    return result;
  }

  [[nodiscard]] Device& device() { return monitor_.device(); }
  [[nodiscard]] const Clocks& worst() const { return worst_; }
  [[nodiscard]] const Faults& faults() const { return faults_; }
  [[nodiscard]] int different() const { return different_; }
  [[nodiscard]] bool compares() const { return twin_.has_value(); }

 private:
  static FrameResult process(Monitor& monitor, int slot, const Pair& pair, std::size_t skin) {
    monitor.upload(slot, pair.maps[skin]->table);
    monitor.select(slot);
    return monitor.process(pair.left, pair.right);
  }

  Monitor monitor_;
  std::optional<Monitor> twin_;
  int frames_ = 0;
  int different_ = 0;
  Clocks worst_;
  Faults faults_;
};

/// Each has a few pairs: an image that comes again and again, or in turn with one other, is a frozen camera.
constexpr std::size_t machines_for(std::size_t pairs, std::size_t processors) {
  constexpr std::size_t kFewestPairs = 4;
  return std::max<std::size_t>(1, std::min(processors, pairs / kFewestPairs));
}
static_assert(machines_for(13, 64) == 3 && machines_for(13, 2) == 2 && machines_for(3, 8) == 1);
static_assert(machines_for(13, 0) == 1);  // not known

std::string yes(bool value) { return value ? "yes" : "no"; }

ExitStatus demonstrate(const Options& options) {
  const MachineProfile& profile = find_profile("vga");
  std::vector<Pair> pairs;
  {
    cli::Progress progress("finding the board in pair");
    for (int number = 1; number <= 14 && pairs.size() < options.pairs; ++number) {
      const std::string text = fmt::format("{:02}", number);
      if (!std::filesystem::exists(std::filesystem::path(options.data) / ("left" + text + ".jpg"))) continue;
      progress.show(static_cast<std::size_t>(number), 14);
      pairs.push_back(load_pair(options, text, profile));
    }
  }
  if (pairs.empty()) {
    throw FileError(options.data, "", "no left01.jpg to left14.jpg", "the example data of Debian's package opencv-doc");
  }
  int lookahead = 0;
  for (const Pair& pair : pairs) {
    for (const auto& map : pair.maps) lookahead = std::max(lookahead, map->report.lookahead);
  }

  OutputDirectory output(options.out, [](const std::string& name) { return name.starts_with("pair-"); });
  const int width = pairs.front().left.width;
  const int height = pairs.front().left.height;
  const Settings settings = options.settings.without_proof();  // the pairs are no sequence: each shows another scene
  std::vector<std::unique_ptr<Machine>> machines(machines_for(pairs.size(), std::thread::hardware_concurrency()));
  for (auto& machine : machines) {
    machine = std::make_unique<Machine>(options, profile, settings);
    machine->start(width, height, lookahead);
  }
  Device& device = machines.front()->device();

  constexpr std::array<const char*, kSkins> kNames{"skin", "plus", "minus"};
  std::size_t frames = 0;
  const auto begin = std::chrono::steady_clock::now();
  if (!options.json) {
    fmt::print("{} pairs, engine {}, profile {}, {} at a time, tables uploaded and switched while the machine runs\n",
               pairs.size(), device.engine(), profile.name, machines.size());
    std::fflush(stdout);
  }
  cli::Progress progress("frame");
  std::mutex mutex;  // of the progress and the output
  study::parallel_for(machines.size(), [&](std::size_t share) {
    // Skin by skin, so that no image comes twice in a row: that would be a frozen camera.
    for (std::size_t skin = 0; skin < kSkins; ++skin) {
      for (std::size_t i = share; i < pairs.size(); i += machines.size()) {
        Pair& pair = pairs[i];
        const FrameResult result = machines[share]->process(pair, skin);
        pair.found[skin] = {cli::count_board(pair.board, result.states), result.alarm};
        const std::string base = fmt::format("pair-{}-{}", pair.name, kNames[skin]);
        const std::vector<std::uint8_t> states = encode_png(state_picture(result.states));
        const Picture overlay = draw_overlay(pair.left, result);
        const std::vector<std::uint8_t> drawn = encode_png_bgr(overlay.width, overlay.height, overlay.bgr);
        const std::lock_guard lock(mutex);
        output.write(base + "-state.png", states);
        output.write(base + "-overlay.png", drawn);
        progress.show(++frames, pairs.size() * kSkins);
      }
    }
  });
  progress.clear();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  output.commit();
  Clocks worst;
  Faults faults;
  int different = 0;
  for (const auto& machine : machines) {
    worst.of(machine->worst());
    faults |= machine->faults();
    different += machine->different();
  }

  // Averages over the pairs.
  const auto count = static_cast<double>(pairs.size());
  double decidable = 0;
  double in_skin = 0;
  std::array<double, 2> moved{};
  int alarms = 0;
  int false_alarms = 0;
  for (const Pair& pair : pairs) {
    decidable += pair.found[0].decidable_share() / count;
    in_skin += pair.found[0].skin_share() / count;
    alarms += pair.found[0].alarm ? 1 : 0;
    for (std::size_t side = 0; side < 2; ++side) {
      moved[side] += pair.found[side + 1].skin_share() / count;
      false_alarms += pair.found[side + 1].alarm ? 1 : 0;
    }
  }
  const double displaced_share = (moved[0] + moved[1]) / 2;
  const bool passed = decidable >= kLeastDecidable && in_skin >= kLeastInSkin && displaced_share <= kMostDisplaced &&
                      alarms == static_cast<int>(pairs.size()) && false_alarms <= kMostDisplacedAlarms &&
                      different == 0 && !faults.any();

  nlohmann::ordered_json json{{"engine", device.engine()},
                              {"profile", profile.name},
                              {"displacement_px", options.displacement_px},
                              {"pairs", nlohmann::ordered_json::array()},
                              {"decidable", decidable},
                              {"in_skin", in_skin},
                              {"displaced", displaced_share},
                              {"alarms", alarms},
                              {"displaced_alarms", false_alarms},
                              {"faults", faults.names()},
                              {"passed", passed}};
  if (machines.front()->compares()) json["frames_different_from_native"] = different;
  const bool clocks = device.counts_cycles();
  const double clock_hz = 1000.0 * profile.clock_khz;
  // Frames follow each other at the rate of their rows and those that empty the windows; a row takes 4 clocks more than
  // it has pixels.
  const double frame_clocks = (width + 4.0) * (height + profile.flush_rows());
  if (clocks) {
    json["cycles"] = worst.cycles;
    json["latency_lines"] = static_cast<double>(worst.latency) / width;
    json["tail_lines"] = static_cast<double>(worst.tail) / width;
  }
  for (const Pair& pair : pairs) {
    json["pairs"].push_back({{"pair", pair.name},
                             {"decidable", pair.found[0].decidable_share()},
                             {"in_skin", pair.found[0].skin_share()},
                             {"plus", pair.found[1].skin_share()},
                             {"minus", pair.found[2].skin_share()},
                             {"alarms", {pair.found[0].alarm, pair.found[1].alarm, pair.found[2].alarm}}});
  }
  if (options.json) {
    std::puts(json.dump(2).c_str());
  } else {
    const std::string px = fmt::format("{:g} px", options.displacement_px);
    fmt::print("\n        of the board    of the decidable, in the skin        alarm\n");
    fmt::print("pair      decidable   on board    +{0}    -{0}    on board  +{0}  -{0}\n", px);
    for (const Pair& pair : pairs) {
      fmt::print("{:4}   {:12.3f}   {:8.3f}   {:7.3f}   {:7.3f}    {:>8}  {:>6}  {:>6}\n", pair.name,
                 pair.found[0].decidable_share(), pair.found[0].skin_share(), pair.found[1].skin_share(),
                 pair.found[2].skin_share(), yes(pair.found[0].alarm), yes(pair.found[1].alarm),
                 yes(pair.found[2].alarm));
    }
    fmt::print("mean   {:12.3f}   {:8.3f}   {:7.3f}   {:7.3f}    {:>8}  {:>14}\n", decidable, in_skin, moved[0],
               moved[1], fmt::format("{}/{}", alarms, pairs.size()),
               fmt::format("{}/{}", false_alarms, 2 * pairs.size()));
    fmt::print("asked  {:>12}   {:>8}   {:>17}    {:>8}  {:>14}\n\n", fmt::format(">= {:.2f}", kLeastDecidable),
               fmt::format(">= {:.2f}", kLeastInSkin), fmt::format("<= {:.2f}", kMostDisplaced), "all",
               fmt::format("<= {}", kMostDisplacedAlarms));
    if (clocks) {
      fmt::print("clocks per frame       {} from first pixel in to last state out\n", worst.cycles);
      fmt::print("frames per second      {:.1f} at the {:.3f} MHz of profile {}\n", clock_hz / frame_clocks,
                 clock_hz / 1e6, profile.name);
      fmt::print(
          "latency                {:.1f} lines from first pixel in to first state out, {:.1f} from last to last\n",
          static_cast<double>(worst.latency) / width, static_cast<double>(worst.tail) / width);
    }
    fmt::print("speed here             {:.1f} frames per second, {:.1f} s in all\n",
               static_cast<double>(frames) / seconds.count(), seconds.count());
    if (machines.front()->compares()) {
      fmt::print("against engine native  {}\n",
                 different == 0 ? "all state pictures identical" : fmt::format("{} state pictures DIFFER", different));
    }
    if (faults.any()) {
      std::string names;
      for (const std::string& name : faults.names()) names += " " + name;
      fmt::print("faults                {}\n", names);
    }
    fmt::print("pictures               {}\n{}\n", std::filesystem::absolute(options.out).lexically_normal().string(),
               passed ? "passed" : "FAILED");
  }
  return passed ? ExitStatus::done : ExitStatus::check_failed;
}

int run(int argc, char** argv) {
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
#ifdef HOROPTER_HAS_RTL
  register_engine("rtl", make_rtl_device);
#endif
  Options options;
  CLI::App app{"Supervises a chessboard in real image pairs: with the skin on the board, and displaced.",
               "chessboard-demo"};
  app.add_option("--data", options.data, "Directory with left01.jpg … right14.jpg")->capture_default_str();
  app.add_option("--out", options.out, "Directory for the pictures")->capture_default_str();
  app.add_option("--engine", options.engine, "rtl: the co-simulated hardware; native: C++ on this CPU")
      ->check(CLI::IsMember({"native", "rtl"}))
      ->capture_default_str();
  app.add_option("--displacement", options.displacement_px, "Disparity of the displaced skins, px")
      ->capture_default_str();
  app.add_option("--threshold", options.settings.threshold_percent, "As for `horopter run`")->capture_default_str();
  app.add_option("--texture", options.settings.texture, "As for `horopter run`")->capture_default_str();
  app.add_option("--alarm-limit", options.settings.alarm_percent, "As for `horopter run`")->capture_default_str();
  app.add_option("--pairs", options.pairs, "Only this many pairs, 2 or more")->check(CLI::Range(2, 14));
  app.add_flag("!--no-compare", options.compare, "Do not compare with the native engine");
  app.add_flag("--json", options.json, "The result as JSON on standard output, and nothing else");
  app.footer("Exit status: 0 all as promised, 1 not, 2 wrong usage, 3 bad file, 4 fault of the engine.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitStatus::usage);
  }
  return static_cast<int>(demonstrate(options));
}

}  // namespace
}  // namespace horopter

int main(int argc, char** argv) {
  try {
    return horopter::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "chessboard-demo: {}\n", error.what());
    return static_cast<int>(horopter::status_of(error));
  }
}
