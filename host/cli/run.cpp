// SPDX-License-Identifier: Apache-2.0
// horopter run: supervises image pairs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "alarm_frames.hpp"
#include "commands.hpp"
#include "horopter/base/ending.hpp"
#include "horopter/base/error.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/draw/overlay.hpp"
#include "horopter/image/frames.hpp"
#include "horopter/image/output.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/machine/moving_supervisor.hpp"
#include "horopter/machine/object_follower.hpp"
#include "horopter/machine/report.hpp"
#include "horopter/map/map_json.hpp"
#include "horopter/map/row_check.hpp"
#include "horopter/monitor/pairing.hpp"
#include "horopter/plan/tolerance.hpp"
#include "inputs.hpp"
#include "numbers.hpp"
#include "object.hpp"
#include "progress.hpp"
#include "settings.hpp"
#include "thickness.hpp"
#include "warnings.hpp"
#include "words.hpp"

namespace horopter::cli {
namespace {

struct RunOptions {
  std::vector<std::string> left;
  std::vector<std::string> right;
  std::string skin;
  std::string rig;
  std::string profile;
  std::string engine = "native";
  std::string out;
  Settings settings;
  ThicknessOption thickness;
  ObjectOption object;
  std::size_t frames = 0;
  std::size_t teach = 0;  ///< pairs that show the zone empty, before the others
  std::optional<double> results_per_s;
  bool pair_by_order = false;
  bool overlay = true;
  bool json = false;
};

bool is_result(const std::string& name) {
  const bool picture = name.starts_with("frame-") && (name.ends_with("-state.png") || name.ends_with("-overlay.png"));
  return picture || name == "summary.json" || name == "earlier-summary.json";
}

/// The machine starts with the first pair: its size decides profile and tables.
struct Session {
  Session(const RunOptions& options, const std::optional<calib::Rig>& rig, const NamedImage& first) {
    const int width = first.image.width;
    const int height = first.image.height;
    profile = &choose_profile(options.profile, first.name, "", width, height);
    settings = options.settings;
    settings.interlock.by_itself = true;  // nobody stands beside a run
    settings.blind.watch = options.teach != 0;
    thickness = set_thickness(options.thickness, options.skin, rig, *profile, width, height, settings);
    object = set_object(options.object, options.skin, rig, *profile, width, height, settings);
    check_alarm_frames(options.skin, rig, *profile, width, height, options.results_per_s, settings,
                       first.time ? monitor::kLongestPeriods : 1);
    const bool moves = is_moving_skin(options.skin);
    if (moves || settings.alarm_frames.needed > 1) {
      check_consecutive(options.left);
      check_consecutive(options.right);
    }
    if (moves) {
      begin_moving(options, rig, first);
      return;
    }
    maps = load_or_compile_maps(options.skin, rig, *profile, width, height, settings.decision);
    const auto tables = maps.tables();
    check_alarm_limit(options.skin, tables, *profile, settings.decision, settings.alarm_percent);
    judgeable = check_object_limit(object, options.skin, tables, *profile, settings);
    has_rig = !maps.rig.empty();
    follower = std::make_unique<ObjectFollower>(*profile, tables, maps.rig);
    results_per_s = options.results_per_s;
    check_rate(first);
    warn_of_designed_rig(options.skin, maps.rig);
    warn_of_proof(options.skin, tables, *profile, maps.lookahead(), settings, maps.rig);
    supervisor = std::make_unique<Supervisor>(make_picture_device(options.engine, *profile), *profile, maps, settings);
  }
  std::vector<FrameResult> process(const NamedImage& left, const NamedImage& right) {
    check_time(left);
    return moving ? moving->process(left.image, right.image) : supervisor->process(left.image, right.image);
  }
  std::vector<TrackedObject> follow(int frame, const FrameResult& result) {
    return follower->follow(result, results_per_s ? std::optional(frame / *results_per_s) : std::nullopt);
  }
  Monitor& monitor() { return moving ? moving->monitor() : supervisor->monitor(); }
  const Device& device() { return monitor().device(); }

  /// A video says itself how often its images come.
  void check_rate(const NamedImage& first) const {
    constexpr double kLargestDeviation = 0.01;
    if (!first.time || !results_per_s) return;
    const double results = profile->fields_per_image() / first.time->period_s;
    if (std::abs(results / *results_per_s - 1) <= kLargestDeviation) return;
    throw FileError(first.name, "", fmt::format("the video has {:g} results a second", results),
                    fmt::format("{:g}, as --frame-rate or the skin's motion says", *results_per_s));
  }

  /// Where a skin's time, or how often a hand is seen, is reckoned by the images' numbers: whether they came then.
  void check_time(const NamedImage& image) {
    if (moving) check_time_is_known(image);
    if (!image.time || (!moving && settings.alarm_frames.needed <= 1)) return;
    const VideoTime& time = *image.time;
    if (time.left_out > 0) {  // by monitor::kLongestPeriods, too
      throw FileError(image.name, "",
                      fmt::format("images are missing before it: {}, by the video's times", time.left_out),
                      "one each period");
    }
    if (moving) check_schedule(image.name, time);
  }

  /// A skin's steps are planned for images that come when they are due. Nothing else is known of files of one image each.
  static void check_time_is_known(const NamedImage& image) {
    std::error_code error;
    if (image.time || std::filesystem::is_regular_file(image.name, error)) return;
    throw FileError(image.name, "", "nobody knows when it was taken, and the skin moves",
                    "a video with times, or a file of each image");
  }

  void check_schedule(const std::string& name, const VideoTime& time) {
    const int fields = profile->fields_per_image();
    if (time.index == 0 && time_before_s) {
      throw FileError(name, "", "this video begins after another one, nobody knows how much later, and the skin moves",
                      "one video");
    }
    const double step_s = time.time_s - time_before_s.value_or(time.time_s);
    time_before_s = time.time_s;
    if (const double longest_s = fields / *results_per_s + kRounding_s; step_s > longest_s) {
      throw FileError(name, "",
                      fmt::format("it comes {:.3f} s after the image before it, by the video's times", step_s),
                      fmt::format("{:.3f} s at most, for which the skin's steps are planned", longest_s));
    }
    const double reckoned_s = static_cast<double>(time.index) * fields / *results_per_s;
    if (std::abs(time.time_s - reckoned_s) <= time.period_s / 2) return;
    throw FileError(name, "", fmt::format("it is of {:.3f} s by the video's times", time.time_s),
                    fmt::format("{:.3f} s, by its number and {:g} results a second", reckoned_s, *results_per_s));
  }

  void begin_moving(const RunOptions& options, const std::optional<calib::Rig>& rig, const NamedImage& first) {
    const int width = first.image.width;
    const int height = first.image.height;
    SkinFile skin = load_skin_for(options.skin, rig, width, height);
    results_per_s = skin.motion_limits.images_per_s;
    if (options.results_per_s.value_or(*results_per_s) != *results_per_s) {
      throw FileError(options.skin, "motion", fmt::format("frame_rate_per_s is {:g}", *results_per_s),
                      fmt::format("{:g}, as --frame-rate says", *options.results_per_s));
    }
    check_rate(first);
    check_time_is_known(first);
    if (first.time) skin.motion_limits.late_s = kRounding_s;
    d95_px = std::min(skin.motion_limits.tolerance_px, horopter::d95_px(settings));
    skin.motion_limits.tolerance_px = d95_px;
    MovingMaps compiled = compile_motion(skin, *profile, width, height, view_limits(*profile, settings.decision));
    std::vector<const MapReport*> reports;
    for (const MovingStep& step : compiled.steps) reports.push_back(&step.map.report);
    supervised_share = check_supervised(options.skin, reports, !compiled.rig.empty());
    if (const std::size_t images = compiled.steps.size() / static_cast<std::size_t>(profile->fields_per_image()) + 1;
        options.teach != 0 && options.teach < images) {
      throw UsageError(fmt::format(
          "--teach {}: the skin moves in {} images, and what is taught of one place says nothing of another; expected all "
          "of them, at least",
          options.teach, images));
    }
    const auto tables = compiled.tables();
    check_alarm_limit(options.skin, tables, *profile, settings.decision, settings.alarm_percent);
    judgeable = check_object_limit(object, options.skin, tables, *profile, settings);
    warn_of_designed_rig(options.skin, compiled.rig);
    warn_of_proof(options.skin, tables, *profile, compiled.lookahead, settings, compiled.rig);
    moving = std::make_unique<MovingSupervisor>(make_picture_device(options.engine, *profile), *profile,
                                                std::move(compiled), settings);
    follower = std::make_unique<ObjectFollower>(*profile, moving->maps().tables(), moving->maps().rig);
  }

  /// A video's times may be whole ms, as Matroska's are.
  static constexpr double kRounding_s = 1e-3;

  const MachineProfile* profile = nullptr;
  ObjectOption object;  ///< that is an alarm
  Settings settings;
  std::optional<ChosenThickness> thickness;
  bool has_rig = true;
  Judgeable judgeable;
  double d95_px = 0;            ///< of a skin that moves: what its steps are planned for
  double supervised_share = 1;  ///< the same, of what the left camera sees of it: the least of all steps
  MapSet maps;                  ///< of a skin that does not move
  std::unique_ptr<Supervisor> supervisor;
  std::unique_ptr<MovingSupervisor> moving;  ///< instead, for a skin that moves
  std::unique_ptr<ObjectFollower> follower;
  std::optional<double> results_per_s;
  std::optional<double> time_before_s;  ///< of a skin that moves: of the image before, in its video
};

/// In the skin or clear.
std::int64_t decided_pixels(const FrameResult& result) {
  return static_cast<std::int64_t>(result.states.pixels.size()) - result.undecidable_pixels -
         result.unsupervised_pixels;
}

void print_frame(int frame, const FrameResult& result) {
  const auto pixels = static_cast<double>(result.states.pixels.size());
  std::string line = fmt::format(
      "frame {:4}  {:8}  skin {:5.1f} %  clear {:5.1f} %  undecidable {:5.1f} %  unsupervised {:5.1f} %", frame,
      result.alarm  ? "ALARM"
      : result.safe ? "safe"
                    : "not safe",
      100 * static_cast<double>(result.skin_pixels) / pixels,
      100 * static_cast<double>(decided_pixels(result) - result.skin_pixels) / pixels,
      100 * static_cast<double>(result.undecidable_pixels) / pixels,
      100 * static_cast<double>(result.unsupervised_pixels) / pixels);
  if (result.seen && !result.alarm) line += "  seen, in too few frames for an alarm";
  for (const std::string& fault : result.faults.names()) line += "  " + fault;
  std::puts(line.c_str());
  std::fflush(stdout);  // a frame that was seen is said, whatever comes
}

void write_frame(OutputDirectory& output, int frame, const Image& left, const FrameResult& result,
                 const std::vector<TrackedObject>& objects, bool overlay) {
  const std::string base = fmt::format("frame-{:04}", frame);
  output.write(base + "-state.png", encode_png(state_picture(result.states)));
  if (!overlay) return;
  const Picture picture = result.scan == Scan::progressive
                              ? draw_overlay(left, result, objects)
                              : draw_overlay(field_of(left, result.scan == Scan::odd_field ? 1 : 0), result, objects);
  output.write(base + "-overlay.png", encode_png_bgr(picture.width, picture.height, picture.bgr));
}

/// Whoever came while it learns may stay, and would be learned with the pairs that are left. `unproven` says nothing of the
/// zone, and such a frame teaches nothing. Throws FileError, and Error where the frame has a fault.
void check_teaches(const FrameResult& result, const std::string& name, std::size_t pair, std::size_t pairs) {
  const Faults faults = result.faults.without(Faults(Fault::teaching) | Fault::unproven);
  if (!result.seen && !faults.any()) return;
  std::vector<std::string> found = faults.names();
  if (result.seen) found.insert(found.begin(), "an alarm");
  const std::string what = fmt::format("pair {} of --teach {} has {}: nothing is taught, and nothing is supervised",
                                       pair, pairs, fmt::join(found, ", "));
  constexpr const char* kExpected = "pairs of the empty zone, without alarm and fault";
  if (!faults.any()) throw FileError(name, "", what, kExpected);
  throw Error(ExitStatus::fault, fmt::format("{}: {}; expected {}", name, what, kExpected));
}

/// What the pairs of --teach have taught.
void report_taught(const BlindWatch& watch, std::size_t pairs, const BlindSettings& settings,
                   nlohmann::ordered_json& summary, bool json) {
  summary["taught"] = {{"pairs", pairs}, {"frames", watch.taught()}};
  if (watch.taught() == 0) {
    if (!json) {
      fmt::print(
          "taught nothing: its last frame, or one before it, was unproven. Now everything that cannot be decided counts\n");
    }
    return;
  }
  auto never = nlohmann::ordered_json::array();
  double pixels = 0, undecidable = 0, unwatched = 0;
  for (const BlindWatch::Block& block : watch.blocks()) {
    const int all = block.width * block.height;
    pixels += all;
    undecidable += block.most_undecidable;
    if (all > block.most_undecidable + settings.margin_pixels(watch.side())) continue;
    unwatched += all;
    never.push_back({block.x, block.y, block.width, block.height});
  }
  const auto percent = [&](double part) { return std::round(1000 * part / pixels) / 10; };
  summary["taught"].update({{"blocks", watch.blocks().size()},
                            {"undecidable_percent", percent(undecidable)},
                            {"watched_for_texture_only_percent", percent(unwatched)},
                            {"watched_for_texture_only", std::move(never)}});
  if (json) return;
  fmt::print(
      "taught by {} frames without fault and alarm: at most {:.1f} % could not be decided. Was the zone empty? Whoever was "
      "in it is not told from now on. {:.1f} % of the image is watched for textured things only: nothing could be decided "
      "there\n",
      watch.taught(), percent(undecidable), percent(unwatched));
}

/// Pairs that teach are never safe, so others must follow. Throws FileError.
void check_pairs_follow(const RunOptions& options, std::size_t pairs) {
  if (options.teach == 0 || pairs > options.teach) return;
  throw FileError(options.left.back(), "",
                  fmt::format("the images end after {} pairs, and none that teaches is supervised", pairs),
                  fmt::format("more than the {} pairs of --teach", options.teach));
}

/// The summary of what holds for every frame, which is also printed.
nlohmann::ordered_json begin_summary(Session& session, const RunOptions& options) {
  const bool print = !options.json;
  auto summary = summary_json(session.device().engine(), session.profile->name);
  summary["restart"] = "by itself";
  summary["clear_is_earned"] = session.settings.proof.needed;
  if (print) fmt::print("restart: by itself; after an alarm or a fault nobody has to say that all is well\n");
  if (!session.settings.proof.needed && print) {
    fmt::print(
        "unproven: clear means only that the images do not agree; both cameras are not shown to see the place\n");
  }
  summary["object"] = object_json(session.settings, *session.profile, session.judgeable);
  summary["object"]["in_mm"] = session.follower->in_mm();
  if (session.results_per_s) summary["frame_rate_per_s"] = *session.results_per_s;
  if (print) {
    fmt::print("object: {}{}\n", object_text(session.object, session.settings, *session.profile, session.judgeable),
               session.follower->in_mm() ? "" : "; this skin knows no rig: nothing is known in mm");
  }
  if (session.thickness) {
    summary.update(session.thickness->json());
    if (print) fmt::print("{}\n", session.thickness->text(session.settings));
  }
  report_rows(session.settings.decision, session.has_rig, summary, options.json);
  if (session.moving) {
    const MovingMaps& maps = session.moving->maps();
    summary["motion"] = {{"tables", maps.steps.size()},
                         {"inserted", maps.inserted},
                         {"d95_px", session.d95_px},
                         {"supervised_percent", std::round(1000 * session.supervised_share) / 10}};
    if (print) {
      fmt::print(
          "the skin moves in {} tables, planned for a tolerance of {:.2f} px (D95); {} of them are intermediate skins, "
          "by which it comes later\n",
          maps.steps.size(), session.d95_px, maps.inserted);
    }
  }
  add_warnings(summary);
  return summary;
}

/// The pictures and the summary of a run: whole at its end. If that does not come, what there is of them is kept, marked
/// as incomplete; also where a signal ends the program.
class Recording {
 public:
  Recording(OutputDirectory& output, nlohmann::ordered_json summary) : output_(output), summary_(std::move(summary)) {}

  void add_taught(const Session& session, const BlindWatch& watch, std::size_t pairs, bool json) {
    const std::lock_guard lock(mutex_);
    report_taught(watch, pairs, session.settings.blind, summary_, json);
  }
  [[nodiscard]] bool has_taught() const { return summary_.contains("taught"); }

  void add_frame(int frame, const NamedImage& left, const NamedImage& right, const FrameResult& result,
                 const std::vector<TrackedObject>& objects, const RunOptions& options, bool counts_cycles) {
    const std::lock_guard lock(mutex_);
    write_frame(output_, frame, left.image, result, objects, options.overlay);
    summary_["frames"].push_back(frame_json(frame, left.name, right.name, result, objects, counts_cycles));
  }

  void complete() {
    const std::lock_guard lock(mutex_);
    output_.write("summary.json", json_text(summary_) + "\n");
    output_.commit();
    ended_ = true;
  }
  void keep_incomplete(const std::string& reason) noexcept {
    const std::lock_guard lock(mutex_);
    if (!ended_) keep(reason);
    ended_ = true;
  }

  /// Of a run that is complete.
  [[nodiscard]] const nlohmann::ordered_json& summary() const { return summary_; }

 private:
  void keep(const std::string& reason) noexcept {
    try {
      const std::size_t frames = summary_["frames"].size();
      if (frames == 0) return;
      summary_["incomplete"] = true;
      summary_["reason"] = reason;
      std::string unmarked;
      try {
        output_.write("summary.json", json_text(summary_) + "\n");
      } catch (const FileError& error) {
        unmarked = fmt::format(", without summary.json: {}", error.what());
      }
      const auto place = output_.keep_incomplete();
      fmt::print(stderr, "horopter: the run is incomplete; its first {} frames are in {}{}\n", frames, place.string(),
                 unmarked);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "horopter: %s\n", error.what());
    }
  }

  std::mutex mutex_;  // what a signal must find in order: the directory, the summary and whether they have ended
  OutputDirectory& output_;
  nlohmann::ordered_json summary_;
  bool ended_ = false;
  const BeforeEnding before_ending_{[this] {
    mutex_.lock();
    if (!ended_) keep("stopped by a signal");
  }};
};

struct Supervised {
  int frames = 0;
  bool fault = false;  ///< in any of them
};

/// From `pair` to the last one that `options` ask for.
Supervised supervise(const RunOptions& options, Session& session, PairSource& pairs, std::optional<FramePair> pair,
                     Recording& recording) {
  Progress progress("supervising pair");
  Supervised done;
  std::size_t shown = 0;
  for (; pair; pair = pairs.next()) {
    if (options.teach != 0 && shown == options.teach) {
      progress.clear();
      recording.add_taught(session, session.monitor().blind_watch(), shown, options.json);
      session.monitor().teach(false);
    }
    for (const FrameResult& result : session.process(pair->left, pair->right)) {
      const std::vector<TrackedObject> objects = session.follow(done.frames, result);
      recording.add_frame(done.frames, pair->left, pair->right, result, objects, options,
                          session.device().counts_cycles());
      done.fault = done.fault || result.faults.without(Fault::teaching).any();
      if (!options.json) {
        progress.clear();
        print_frame(done.frames, result);
      }
      if (shown < options.teach) check_teaches(result, pair->left.name, shown + 1, options.teach);
      ++done.frames;
    }
    progress.show(++shown, pairs.count());
    if (options.frames != 0 && shown == options.frames) break;
    if (pairs.is_live() && asked_to_stop()) break;  // that is how it ends
  }
  progress.clear();
  if (options.teach != 0 && !recording.has_taught()) {
    recording.add_taught(session, session.monitor().blind_watch(), shown, options.json);
    check_pairs_follow(options, shown);
  }
  return done;
}

ExitStatus run_into(OutputDirectory& output, const RunOptions& options) {
  const auto rig = read_rig_option(options.rig);
  check_skin_file(options.skin);
  const SkinFiles skin_files(options.skin);
  PairSource pairs(options.left, options.right, options.pair_by_order ? PairNumbers::ignored : PairNumbers::must_agree);
  for (const std::string& text : pairs.warnings()) warn(text);
  if (const auto count = pairs.count()) check_pairs_follow(options, *count);
  auto pair = pairs.next();
  if (!pair) throw FileError(options.left.front(), "", "there is no image", "at least one");

  Session session(options, rig, pair->left);
  skin_files.check_unchanged();
  auto summary = begin_summary(session, options);
  if (options.teach != 0) {
    session.monitor().teach(true);
    if (!options.json) {
      fmt::print("teaching: the zone must be empty for {} pairs; none of them is safe\n", options.teach);
    }
  }
  Recording recording(output, std::move(summary));
  Supervised done;
  try {
    done = supervise(options, session, pairs, std::move(pair), recording);
    recording.complete();
  } catch (const std::exception& error) {
    recording.keep_incomplete(error.what());
    throw;
  }
  if (options.json) {
    std::puts(json_text(recording.summary()).c_str());
  } else {
    const auto& frames = recording.summary()["frames"];
    const auto alarms = std::ranges::count_if(frames, [](const auto& f) { return f["alarm"].template get<bool>(); });
    std::printf("%d frames, %td with alarm; pictures and summary.json are in %s\n", done.frames, alarms,
                options.out.c_str());
  }
  if (!done.fault) return ExitStatus::done;
  std::fprintf(stderr, "horopter: at least one frame has a fault; see `faults` in %s/summary.json\n",
               options.out.c_str());
  return ExitStatus::fault;
}

ExitStatus run(const RunOptions& options) {
  if (options.frames != 0 && options.frames <= options.teach) {
    throw UsageError(
        fmt::format("--frames {} with --teach {}: no pair that teaches is supervised; expected more frames",
                    options.frames, options.teach));
  }
  if (!options.profile.empty()) find_profile(options.profile);
  OutputDirectory output(options.out, is_result);
  output.set_aside("summary.json");
  try {
    return run_into(output, options);
  } catch (const UsageError&) {  // as if nothing had been asked for
    output.put_back();
    throw;
  }
}

}  // namespace

void add_run(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command =
      app.add_subcommand("run", "Supervise image pairs: which pixels are in the skin, and is it an alarm?");
  command
      ->add_option("--left", options->left, "Left images: files, 'patterns', directories, videos, or a camera's number")
      ->required()
      ->expected(1, -1)
      ->type_name("F...");
  command->add_option("--right", options->right, "Right images, as many as left ones")
      ->required()
      ->expected(1, -1)
      ->type_name("F...");
  add_pair_by_order(*command, options->pair_by_order);
  command->add_option("--skin", options->skin, "The skin: skin.yaml, or a table made by `horopter map`")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--rig", options->rig,
                   "The cameras (rig.yaml); homographies and correspondences use only the image size")
      ->type_name("FILE");
  command
      ->add_option("--profile", options->profile,
                   "Build of the machine: " + profile_sizes() +
                       " (default: the smallest that holds the image; field, "
                       "which splits an image into two fields, on request only)")
      ->type_name("P");
  add_engine(*command, options->engine)->capture_default_str();
  add_decision(*command, options->settings.decision);
  add_object(*command, options->object);
  add_alarm_frames(*command, options->settings.alarm_frames);
  add_thickness(*command, options->thickness);
  add_settings(*command, options->settings);
  command->get_option("--threshold")->excludes("--tolerance")->excludes("--thickness");
  command->add_option("--frames", options->frames, "Stop after this many pairs (default: all)")
      ->check(at_least_one())
      ->type_name("N");
  command
      ->add_option(
          "--teach", options->teach,
          "The first N pairs show the zone empty: learn where nothing can be decided. After them a place that could "
          "be decided and cannot be any more is blind and counts as an object. An alarm or a fault in them is an error. "
          "More pairs must follow, as none that teaches is supervised. Without it, whatever has no texture reads undecidable, and a plain glove is no alarm")
      ->check(at_least_one())
      ->type_name("N");
  add_less_light(*command, options->settings.blind)->needs("--teach");
  command
      ->add_option("--frame-rate", options->results_per_s,
                   "Results a second, frames or fields of profile field: objects then have a velocity by the second, "
                   "else by the frame")
      ->check(within(0.1, 10'000, "a second"))
      ->type_name("HZ");
  command->add_option("--out", options->out, "Directory for the results")->required()->type_name("DIR");
  command->add_flag_callback("--no-overlay", [options] { options->overlay = false; }, "Write no overlay pictures");
  command->add_flag("--json", options->json, "Print summary.json on standard output, and nothing else");
  command->footer(
      "Writes per frame frame-NNNN-state.png (0 clear, 255 skin, 128 undecidable, 64 unsupervised) and\n"
      "frame-NNNN-overlay.png, and summary.json. All of it appears at the end. After an error, or stopped by a\n"
      "signal, the results of an earlier run stay, with their summary as earlier-summary.json, and what was made is in\n"
      "the directory `incomplete` beside them: its summary.json says `incomplete`, and the reason.\n"
      "The frames of a moving skin (`motion` in skin.yaml, see `horopter map --help`) name its time, skin_time_s.\n"
      "A fault of a frame is an exit status of 4; the results are written all the same.\n\n"
      "Example: horopter run --left 'left*.jpg' --right 'right*.jpg' --skin skin.yaml --out results");
  command->callback([options, &outcome] { outcome.status = run(*options); });
}

}  // namespace horopter::cli
