// SPDX-License-Identifier: Apache-2.0
// Test bodies cross the skin before photographs: how many of them are found, and how soon? And without a body, in noise,
// flicker, shadows and changing light: how many false alarms an hour?
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/object.hpp"
#include "cli/progress.hpp"
#include "horopter/base/error.hpp"
#include "horopter/base/interval.hpp"
#include "horopter/calib/random.hpp"
#include "horopter/machine/engines.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/study/parallel.hpp"
#include "horopter/study/scene.hpp"
#include "photographs.hpp"
#include "study.hpp"

namespace horopter::cli {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using study::Coat;

constexpr double kImages_per_s = 60;
constexpr int kTeaching = 12;      ///< pairs
constexpr int kSoon = 3;           ///< frames within which a body is to be found
constexpr double kEnough = 0.999;  ///< share of the bodies that is to be found so
constexpr double kFewAlarms = 1;   ///< an hour
constexpr double kRod_mm = 150;    ///< length of the rods
constexpr double kHand_mm = 40;    ///< the rod that kEnough is asked of
constexpr double kFastest_m_s = 1.6;

struct BodyKind {
  std::string name;
  std::vector<Capsule> segments;
  double depth_mm;  ///< of the surface that the cameras see
};

std::vector<BodyKind> body_kinds(const StudyScope& scope) {
  std::vector<BodyKind> kinds;
  for (const double mm : {20.0, 30.0, kHand_mm, 70.0}) {
    if ((scope.quick || scope.hands) && mm != kHand_mm) continue;
    kinds.push_back({fmt::format("rod of {:g} mm", mm), study::rod_segments(mm, kRod_mm), mm / 2});
  }
  if (!scope.hands) kinds.push_back({"hand", study::hand_segments(), 13});
  return kinds;
}

std::vector<double> speeds_m_s(const StudyScope& scope) {
  if (scope.quick) return {0.4, kFastest_m_s};
  std::vector<double> speeds{0.1, 0.4, 1.0, kFastest_m_s};
  if (!scope.hands) speeds.push_back(2.0);
  return speeds;
}

/// One machine of those that see the same images.
struct Variant {
  Decision decision;
  bool taught;

  std::string name() const { return fmt::format("{}, {}", name_of(decision), taught ? "taught" : "not taught"); }
};
constexpr std::array kVariants{Variant{Decision::thesis, false}, Variant{Decision::thesis, true},
                               Variant{Decision::compete, false}, Variant{Decision::compete, true}};

/// An object that is an alarm, in pixels of the result.
struct ObjectLimit {
  std::string name;
  std::int64_t pixels;
};

/// What all crossings have in common.
struct Walk {
  CameraPair cameras;
  const MachineProfile& profile;
  ScanGeometry geometry;
  std::array<MapSet, kVariants.size()> maps;
  std::array<Settings, kVariants.size()> settings;
  double thickness_mm;  ///< largest of both rules, D50
  std::vector<ObjectLimit> limits;
  std::vector<std::pair<std::string, Image>> photographs;
  bool hands = false;  ///< only what a hand's rods need

  bool judges(std::size_t variant) const { return !hands || kVariants.at(variant).taught; }
};

Walk prepare(const StudyScope& scope) {
  const calib::Rig rig = make_rig(kRig);
  const CameraPair cameras(rig.cameras[0], rig.cameras[1]);
  const MachineProfile& profile = find_profile("vga");
  const ScanGeometry geometry = scans_of(profile, kRig.width_px, kRig.height_px).front();
  const SurfacePtr surface = make_plane({0, 0, kSkin_mm}, {0, 0, -1});
  Walk walk{cameras, profile, geometry, {}, {}, 0, {}, {}, scope.hands};
  for (std::size_t v = 0; v < kVariants.size(); ++v) {
    Settings& settings = walk.settings[v];
    settings.decision = kVariants[v].decision;
    settings.interlock.by_itself = true;
    settings.still_limit = 0;  // the wall stands still
    settings.blind.watch = kVariants[v].taught;
    settings.blind.dim = scope.less_light;
    const RigSkin skin(cameras, surface, "plane");
    constexpr double kOwn_px = 1.5;  // at most, as D50, by the rules' own settings (tolerance.hpp)
    const auto chosen = set_thickness(scope.thickness, skin, profile, geometry, settings);
    const double mm =
        plan_thickness(cameras, *surface, profile, geometry, chosen ? chosen->tolerance_px : kOwn_px).across.mean;
    walk.thickness_mm = std::max(walk.thickness_mm, mm);
    walk.maps[v] = plane_maps(rig, profile, settings.decision);
  }
  Settings sized = walk.settings[0];
  if (!scope.hands) {
    walk.limits.push_back({fmt::format("{:g} px", sized.object_px), object_limit(sized, profile)});
  }
  const double axis_mm = (Vector3d(0, 0, kSkin_mm) - cameras.left().world_to_camera.centre()).norm();
  sized.object_px = kRig.f_px() * kHand_mm / axis_mm;
  walk.limits.push_back({fmt::format("{:g} mm", kHand_mm), object_limit(sized, profile)});
  walk.photographs = load_photographs(scope);
  return walk;
}

/// What became of a body, or of a disturbance, in one machine.
struct Outcomes {
  /// Of each limit: the frame in which it was found, 1 is the first with a part of the body in the skin; 0 before it.
  std::array<std::optional<int>, 2> found;
  int faulty = 0;  ///< frames with a fault
  std::int64_t largest_px = 0;
};

struct Crossing {
  std::size_t photograph = 0;
  const BodyKind* body = nullptr;
  Coat coat = Coat::textured;
  double speed_m_s = 0;
  std::uint64_t number = 0;
  int frames_inside = 0;  ///< in which a part of the body's front half is in the skin
  std::array<Outcomes, kVariants.size()> outcomes;
};

struct Alarms {
  int frames = 0;
  std::array<int, 2> alarms{};  ///< of each limit: frames with one, whose frame before had none
  int stops = 0;                ///< frames with a fault, whose frame before had none
  std::map<std::string, int> faults;
};

/// The machines before one photograph, side by side.
class Bench {
 public:
  Bench(const Walk& walk, const StudyScope& scope, std::size_t photograph, std::uint64_t number)
      : walk_(walk), seed_(scope.seed), number_(number << 24U) {
    calib::Random random(scope.seed, 0xBA5E + photograph);
    const double distance_mm = 1000 + 300 * random.uniform();
    const Vector3d normal(0.3 * (random.uniform() - 0.5), 0.3 * (random.uniform() - 0.5), -1);
    scene_ = std::make_unique<study::WallScene>(walk.cameras, walk.photographs[photograph].second,
                                                Vector3d(0, 0, distance_mm), normal.normalized());
    for (std::size_t v = 0; v < kVariants.size(); ++v) {
      machines_.push_back(std::make_unique<Supervisor>(make_device(scope.engine, walk.profile), walk.profile,
                                                       walk.maps[v], walk.settings[v]));
      if (kVariants[v].taught) machines_[v]->monitor().teach(true);
    }
    for (int i = 0; i < kTeaching; ++i) show(scene_->empty(), kNoise_grey, [](std::size_t, const FrameResult&) {});
    for (std::size_t v = 0; v < kVariants.size(); ++v) {
      if (!kVariants[v].taught) continue;
      taught_[v] = machines_[v]->monitor().blind_watch().taught();
      machines_[v]->monitor().teach(false);
    }
  }

  /// Gives the next pair to all machines for which it is not over.
  template <class Seen>
  void show(const study::WallScene::Views& views, double noise_grey, Seen seen,
            const std::array<bool, kVariants.size()>& over = {}) {
    const Image left = study::expose(views[0], noise_grey, seed_, 2 * number_);
    const Image right = study::expose(views[1], noise_grey, seed_, 2 * number_ + 1);
    ++number_;
    for (std::size_t v = 0; v < kVariants.size(); ++v) {
      if (!over[v] && walk_.judges(v)) seen(v, machines_[v]->process(left, right).front());
    }
  }

  const study::WallScene& scene() const { return *scene_; }
  int taught(std::size_t variant) const { return taught_[variant]; }

 private:
  const Walk& walk_;
  std::uint64_t seed_, number_;
  std::unique_ptr<study::WallScene> scene_;
  std::vector<std::unique_ptr<Supervisor>> machines_;
  std::array<int, kVariants.size()> taught_{};
};

/// Whether a frame is an alarm with this limit: by an object, or by the share of the image.
bool is_alarm(const Walk& walk, const FrameResult& frame, const ObjectLimit& limit, const Settings& settings) {
  const double image = static_cast<double>(walk.geometry.width) * walk.geometry.height;
  return frame.largest_object_pixels >= limit.pixels ||
         static_cast<double>(frame.skin_pixels) > settings.alarm_percent / 100 * image;
}

/// A body goes away from the cameras, through the skin, to the wall.
void cross(const Walk& walk, Bench& bench, Crossing& crossing, std::uint64_t seed) {
  calib::Random random(seed, 0xC0 + crossing.number);
  const auto between = [&](double low, double high) { return low + (high - low) * random.uniform(); };
  const Vector3d target(between(-110, 110), between(-70, 70), kSkin_mm);
  const double turned = between(0, 2 * std::numbers::pi);
  // Up to 20 degrees off the normal, both the way and the body.
  const auto tilted = [&] { return Vector3d(between(-0.25, 0.25), between(-0.25, 0.25), 1).normalized(); };
  const Vector3d way = tilted();
  Matrix3d axes;
  axes.col(2) = -tilted();
  axes.col(0) = (Vector3d(std::cos(turned), std::sin(turned), 0)).cross(axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  const double step_mm = crossing.speed_m_s * 1e3 / kImages_per_s;
  const double depth_mm = crossing.body->depth_mm, half_mm = walk.thickness_mm / 2;
  // Of the front along the way; the first of the front half is in the skin at 0.
  const double phase = random.uniform();
  std::array<bool, kVariants.size()> over{};
  for (std::size_t v = 0; v < over.size(); ++v) over[v] = !walk.judges(v);
  for (int i = -1;; ++i) {
    const double in_mm = (i + phase) * step_mm * way.z();
    const double front_mm = -half_mm - depth_mm + in_mm;
    if (front_mm > half_mm && i >= kSoon) break;
    if (i >= 0 && front_mm <= half_mm) ++crossing.frames_inside;
    const auto body = study::place(crossing.body->segments, target + front_mm / way.z() * way, axes);
    bench.show(
        bench.scene().with_body(body, crossing.coat, seed + crossing.number), kNoise_grey,
        [&](std::size_t v, const FrameResult& frame) {
          Outcomes& outcome = crossing.outcomes[v];
          outcome.faulty += frame.faults.any() ? 1 : 0;
          outcome.largest_px = std::max(outcome.largest_px, frame.largest_object_pixels);
          for (std::size_t k = 0; k < walk.limits.size(); ++k) {
            if (!outcome.found[k] && is_alarm(walk, frame, walk.limits[k], walk.settings[v])) outcome.found[k] = i + 1;
          }
          over[v] = std::all_of(outcome.found.begin(),
                                outcome.found.begin() + static_cast<std::ptrdiff_t>(walk.limits.size()),
                                [](const auto& found) { return found.has_value(); });
        },
        over);
    if (std::ranges::all_of(over, [](bool one) { return one; })) break;
  }
  // The next body comes to an empty place.
  for (int i = 0; i < 2; ++i) bench.show(bench.scene().empty(), kNoise_grey, [](std::size_t, const FrameResult&) {});
}

/// What happens to the light, without a body.
struct Disturbance {
  std::string name;
  bool counts;  ///< as a false alarm; a flash may stop the machine
  double noise_grey = kNoise_grey;
  std::function<study::Light(int frame, int frames)> light;
};

std::vector<Disturbance> light_disturbances() {
  const auto even = [](double value) -> study::Light { return [value](double, double) { return value; }; };
  return {
      {"none", true, kNoise_grey, [=](int, int) { return even(1); }},
      {"noise of 4 grey levels", true, 4, [=](int, int) { return even(1); }},
      {"flicker of 100 Hz by 15 %", true, kNoise_grey,
       [=](int i, int) { return even(1 + 0.15 * std::cos(2 * std::numbers::pi * 100 * i / kImages_per_s + 0.5)); }},
      {"shadow that moves", true, kNoise_grey,
       [](int i, int frames) -> study::Light {
         const double u0 = -300 + 600.0 * i / frames;
         return [=](double u, double v) { return 1 - 0.5 / (1 + std::exp((std::hypot(u - u0, v) - 110) / 8)); };
       }},
      {"lamp switched", true, kNoise_grey,
       [=](int i, int frames) -> study::Light {
         if (i < frames / 3 || i >= 2 * frames / 3) return even(1);
         return [](double u, double) { return 0.6 + 0.0004 * u; };
       }},
      {"light 1.5 times as strong", true, kNoise_grey, [=](int i, int) { return even(i % 12 >= 6 ? 1.5 : 1); }},
      {"light halved over all frames", true, kNoise_grey,
       [=](int i, int frames) { return even(1 - 0.5 * i / frames); }},
      {"flash of 1 to 3 frames", false, kNoise_grey,
       [=](int i, int) { return even(i % 12 >= 8 && i % 12 < 9 + i / 12 % 3 ? 4 : 1); }},
  };
}

void disturb(const Walk& walk, Bench& bench, const Disturbance& disturbance, int frames,
             std::array<Alarms, kVariants.size()>& all) {
  std::array<std::array<bool, 3>, kVariants.size()> before{};
  for (int i = 0; i < frames; ++i) {
    const auto views = bench.scene().lit(disturbance.light(i, frames));
    bench.show(views, disturbance.noise_grey, [&](std::size_t v, const FrameResult& frame) {
      Alarms& alarms = all[v];
      ++alarms.frames;
      const auto begins = [&](std::size_t place, bool now) {
        const bool first = now && !before[v][place];
        before[v][place] = now;
        return first ? 1 : 0;
      };
      for (std::size_t k = 0; k < walk.limits.size(); ++k) {
        alarms.alarms[k] += begins(k, is_alarm(walk, frame, walk.limits[k], walk.settings[v]));
      }
      const bool stops = begins(2, frame.faults.any()) != 0;
      alarms.stops += stops ? 1 : 0;
      if (!stops) return;
      for (const std::string& name : frame.faults.names()) ++alarms.faults[name];
    });
  }
}

/// Bodies found, of all that count.
struct Found {
  std::int64_t of = 0, soon = 0, ever = 0, before = 0, faulty = 0, frames = 0;

  void add(const Outcomes& outcome, std::size_t limit) {
    ++of;
    const auto& found = outcome.found[limit];
    soon += found && *found <= kSoon ? 1 : 0;
    ever += found ? 1 : 0;
    before += found && *found == 0 ? 1 : 0;  // it hides the skin
    frames += found ? *found : 0;
    faulty += outcome.faulty > 0 ? 1 : 0;
  }
  double share() const { return of == 0 ? 0 : static_cast<double>(soon) / static_cast<double>(of); }
  std::string text() const {
    const auto [low, high] = wilson(soon, of);
    return fmt::format("{} of {}, {:.1f} % [{:.1f}, {:.1f}]", soon, of, 100 * share(), 100 * low, 100 * high);
  }
  nlohmann::json json() const {
    const auto [low, high] = wilson(soon, of);
    return {{"crossings", of},
            {"found_within_3_frames", soon},
            {"found", ever},
            {"found_before_the_skin", before},
            {"share", share()},
            {"interval", {low, high}},
            {"with_a_fault", faulty},
            {"mean_frame",
             ever == 0 ? nlohmann::json() : nlohmann::json(static_cast<double>(frames) / static_cast<double>(ever))}};
  }
};

std::vector<Crossing> plan_crossings(const Walk& walk, const std::vector<BodyKind>& bodies, const StudyScope& scope) {
  std::vector<Crossing> all;
  for (int n = 0; n < scope.crossings; ++n) {
    for (const double speed : speeds_m_s(scope)) {
      for (const BodyKind& body : bodies) {
        for (const Coat coat : study::kCoats) {
          Crossing& crossing = all.emplace_back();
          crossing.number = all.size() - 1;
          // Each body, coat and speed before each photograph in turn.
          crossing.photograph = (crossing.number + crossing.number / study::kCoats.size()) % walk.photographs.size();
          crossing.body = &body;
          crossing.coat = coat;
          crossing.speed_m_s = speed;
        }
      }
    }
  }
  return all;
}

/// Crossings before one photograph, or its disturbances.
struct Job {
  std::size_t photograph = 0;
  std::vector<Crossing*> crossings;
  bool disturbances = false;
};

std::vector<Job> jobs_of(const Walk& walk, std::vector<Crossing>& crossings) {
  constexpr std::size_t kTogether = 40;
  std::vector<Job> jobs;
  for (std::size_t p = 0; p < walk.photographs.size(); ++p) {
    jobs.push_back({p, {}, true});
    jobs.push_back({p, {}, false});
    for (Crossing& crossing : crossings) {
      if (crossing.photograph != p) continue;
      if (jobs.back().crossings.size() == kTogether) jobs.push_back({p, {}, false});
      jobs.back().crossings.push_back(&crossing);
    }
  }
  return jobs;
}

double per_hour(double share) { return share * kImages_per_s * 3600; }

/// All that was found, for the tables.
struct Results {
  const Walk& walk;
  const std::vector<BodyKind>& bodies;
  const std::vector<Crossing>& crossings;
  const std::vector<Disturbance>& lights;
  std::vector<std::array<Alarms, kVariants.size()>> alarms;  ///< of each disturbance, all photographs

  template <class Counts>
  Found found(std::size_t variant, std::size_t limit, Counts counts) const {
    Found sum;
    for (const Crossing& crossing : crossings) {
      if (counts(crossing)) sum.add(crossing.outcomes[variant], limit);
    }
    return sum;
  }
  /// What is to be found: hands' rods that are not too fast.
  Found of_hands(std::size_t variant, std::size_t limit, Coat coat) const {
    const std::string rod = fmt::format("rod of {:g} mm", kHand_mm);
    return found(variant, limit, [&](const Crossing& crossing) {
      return crossing.coat == coat && crossing.body->name == rod && crossing.speed_m_s <= kFastest_m_s;
    });
  }
};

std::string alarms_text(const Alarms& alarms, std::size_t limit) {
  const auto [low, high] = wilson(alarms.alarms[limit], alarms.frames);
  const double share = static_cast<double>(alarms.alarms[limit]) / std::max(1, alarms.frames);
  return fmt::format("{} false alarms in {} frames, {:.0f} an hour [{:.0f}, {:.0f}]", alarms.alarms[limit],
                     alarms.frames, per_hour(share), per_hour(low), per_hour(high));
}

std::string faults_text(const Alarms& alarms) {
  if (alarms.stops == 0) return "";
  std::string text = fmt::format("; stopped {} times by a fault:", alarms.stops);
  for (const auto& [name, count] : alarms.faults) text += fmt::format(" {} {}", name, count);
  return text;
}

/// The first lines: what is not as it should be, and what too little was walked for to say so.
void report_failures(StudyReport& report, const Results& results) {
  auto failures = nlohmann::json::array();
  auto too_few = nlohmann::json::array();
  std::vector<std::string> few_lines;
  const auto judge = [&](Goal goal, std::size_t v, std::size_t k, const std::string& what, const std::string& figure) {
    if (goal == Goal::reached) return;
    const std::string& limit = results.walk.limits[k].name;
    const std::string line = fmt::format("{}, object {}: {}: {}", kVariants[v].name(), limit, what, figure);
    if (goal == Goal::missed) {
      report.finding("FAILS: {}", line);
    } else {
      few_lines.push_back(line);
    }
    (goal == Goal::missed ? failures : too_few)
        .push_back({{"decision", name_of(kVariants[v].decision)},
                    {"taught", kVariants[v].taught},
                    {"object", limit},
                    {"what", what},
                    {"figure", figure}});
  };
  for (std::size_t k = 0; k < results.walk.limits.size(); ++k) {
    for (std::size_t v = 0; v < kVariants.size(); ++v) {
      if (!results.walk.judges(v)) continue;
      for (const Coat coat : study::kCoats) {
        const Found found = results.of_hands(v, k, coat);
        judge(goal_of(found.soon, found.of, kEnough), v, k,
              fmt::format("{} rods of {:g} mm at up to {:g} m/s", name_of(coat), kHand_mm, kFastest_m_s),
              fmt::format("found within {} frames {}", kSoon, found.text()));
      }
      for (std::size_t d = 0; d < results.lights.size(); ++d) {
        const Alarms& alarms = results.alarms[d][v];
        if (!results.lights[d].counts || alarms.frames == 0) continue;
        judge(goal_of(alarms.frames - alarms.alarms[k], alarms.frames, 1 - kFewAlarms / per_hour(1)), v, k,
              results.lights[d].name, alarms_text(alarms, k));
      }
    }
  }
  for (const std::string& line : few_lines) report.finding("TOO FEW to say: {}", line);
  report.result["failures"] = std::move(failures);
  report.result["too_few"] = std::move(too_few);
}

void report_found(StudyReport& report, const Results& results) {
  Csv csv({"decision,taught,object,body,coat,speed_m_s,crossings,found_within_3_frames,found,with_a_fault"});
  auto lines = nlohmann::json::array();
  for (std::size_t k = 0; k < results.walk.limits.size(); ++k) {
    for (std::size_t v = 0; v < kVariants.size(); ++v) {
      if (!results.walk.judges(v)) continue;
      report.finding("{}, object {}: bodies found within {} frames, at up to {:g} m/s; and at all", kVariants[v].name(),
                     results.walk.limits[k].name, kSoon, kFastest_m_s);
      for (const BodyKind& body : results.bodies) {
        for (const Coat coat : study::kCoats) {
          const auto is = [&](const Crossing& one) { return one.body == &body && one.coat == coat; };
          const Found slow =
              results.found(v, k, [&](const Crossing& one) { return is(one) && one.speed_m_s <= kFastest_m_s; });
          report.finding("  {:13} {:14} {}; {} at all; {} before the skin; {} with a fault", body.name, name_of(coat),
                         slow.text(), slow.ever, slow.before, slow.faulty);
          nlohmann::json line = slow.json();
          line.update({{"decision", name_of(kVariants[v].decision)},
                       {"taught", kVariants[v].taught},
                       {"object", results.walk.limits[k].name},
                       {"body", body.name},
                       {"coat", name_of(coat)}});
          lines.push_back(line);
          std::map<double, Found> by_speed;
          for (const Crossing& one : results.crossings) {
            if (is(one)) by_speed[one.speed_m_s].add(one.outcomes[v], k);
          }
          for (const auto& [speed, found] : by_speed) {
            csv.row(std::string(name_of(kVariants[v].decision)), kVariants[v].taught ? 1 : 0,
                    results.walk.limits[k].name, body.name, name_of(coat), speed, found.of, found.soon, found.ever,
                    found.faulty);
          }
        }
      }
    }
  }
  report.result["found"] = lines;
  report.table("found.csv", csv);
}

void report_alarms(StudyReport& report, const Results& results) {
  Csv csv({"decision,taught,disturbance,frames,false_alarms_first_object,false_alarms_second_object,stops_by_a_fault"});
  auto lines = nlohmann::json::array();
  for (std::size_t v = 0; v < kVariants.size(); ++v) {
    if (!results.walk.judges(v)) continue;
    report.finding("{}: without a body", kVariants[v].name());
    for (std::size_t d = 0; d < results.lights.size(); ++d) {
      const Alarms& alarms = results.alarms[d][v];
      nlohmann::json objects = nlohmann::json::object();
      for (std::size_t k = 0; k < results.walk.limits.size(); ++k) {
        report.finding("  {:26} object {:6} {}{}", results.lights[d].name, results.walk.limits[k].name,
                       alarms_text(alarms, k), k == 0 ? faults_text(alarms) : "");
        const auto [low, high] = wilson(alarms.alarms[k], alarms.frames);
        objects[results.walk.limits[k].name] = {
            {"false_alarms", alarms.alarms[k]},
            {"per_hour", per_hour(1.0 * alarms.alarms[k] / std::max(1, alarms.frames))},
            {"interval", {per_hour(low), per_hour(high)}}};
      }
      lines.push_back({{"decision", name_of(kVariants[v].decision)},
                       {"taught", kVariants[v].taught},
                       {"disturbance", results.lights[d].name},
                       {"counts", results.lights[d].counts},
                       {"frames", alarms.frames},
                       {"objects", objects},
                       {"stops_by_a_fault", alarms.stops},
                       {"faults", alarms.faults}});
      csv.row(std::string(name_of(kVariants[v].decision)), kVariants[v].taught ? 1 : 0, results.lights[d].name,
              alarms.frames, alarms.alarms[0], alarms.alarms[1], alarms.stops);
    }
  }
  report.result["disturbances"] = lines;
  report.table("disturbances.csv", csv);
}

/// Every crossing, and what each machine made of it.
void table_crossings(StudyReport& report, const Results& results) {
  Csv csv(
      {"number,photograph,body,coat,speed_m_s,frames_inside,decision,taught,largest_object_px,first_found,second_found,fault_frames"});
  for (const Crossing& one : results.crossings) {
    for (std::size_t v = 0; v < kVariants.size(); ++v) {
      if (!results.walk.judges(v)) continue;
      const Outcomes& outcome = one.outcomes[v];
      const auto frame = [&](std::size_t k) { return outcome.found[k] ? fmt::format("{}", *outcome.found[k]) : ""; };
      csv.row(static_cast<double>(one.number), results.walk.photographs[one.photograph].first, one.body->name,
              name_of(one.coat), one.speed_m_s, one.frames_inside, std::string(name_of(kVariants[v].decision)),
              kVariants[v].taught ? 1 : 0, static_cast<double>(outcome.largest_px), frame(0), frame(1), outcome.faulty);
    }
  }
  report.table("crossings.csv", csv);
}

void plot_speeds(StudyReport& report, const Results& results) {
  std::vector<Panel> panels;
  const std::string rod = fmt::format("rod of {:g} mm", kHand_mm);
  for (std::size_t k = 0; k < results.walk.limits.size(); ++k) {
    for (std::size_t v = 0; v < kVariants.size(); ++v) {
      if (!results.walk.judges(v)) continue;
      Panel& panel =
          panels.emplace_back(Panel{fmt::format("{}, object {}", kVariants[v].name(), results.walk.limits[k].name),
                                    "speed, m/s",
                                    fmt::format("found within {} frames, %", kSoon),
                                    {}});
      for (const Coat coat : study::kCoats) {
        std::map<double, Found> by_speed;
        for (const Crossing& one : results.crossings) {
          if (one.coat == coat && one.body->name == rod) by_speed[one.speed_m_s].add(one.outcomes[v], k);
        }
        Curve& curve = panel.curves.emplace_back(Curve{study::name_of(coat), {}});
        for (const auto& [speed, found] : by_speed) curve.points.emplace_back(speed, 100 * found.share());
      }
    }
  }
  report.plot("walk.svg", fmt::format("Rods of {:g} mm that cross the skin: found over their speed", kHand_mm), panels,
              4);
}

/// For `plan capability`: with `--hands` what it has more crossings of than the other table has.
void write_table(StudyReport& report, const Results& results, const StudyScope& scope) {
  const double rod_px = 2 * std::sqrt(2 * static_cast<double>(results.walk.limits.back().pixels) / std::numbers::pi);
  std::string text =
      fmt::format("// Written by `horopter study walk{} --crossings {}{} --seed {}`.\n", scope.hands ? " --hands" : "",
                  scope.crossings, scope.hands ? "" : fmt::format(" --frames {}", scope.frames), scope.seed);
  constexpr std::string_view kWalk =
      "WALK: rule, whether taught, coat, pixels of an object that is an alarm,\n"
      "// crossings, and those in which the rod was found so.";
  if (scope.hands) {
    text += fmt::format("// {}\n", kWalk);
  } else {
    text += fmt::format(
        "// SETUP: the rods, mm and px of the result; their largest speed, m/s; images a second; thickness of the skin, mm,\n"
        "// D50; frames in which they were to be found. {} LIGHT: the same without a body: frames, false alarms.\n"
        "SETUP({:g}, {:.0f}, {:g}, {:g}, {:.1f}, {})\n",
        kWalk, kHand_mm, rod_px, kFastest_m_s, kImages_per_s, results.walk.thickness_mm, kSoon);
  }
  for (std::size_t v = 0; v < kVariants.size(); ++v) {
    if (!results.walk.judges(v)) continue;
    const std::string machine = fmt::format("{}, {}", name_of(kVariants[v].decision), kVariants[v].taught);
    for (std::size_t k = 0; k < results.walk.limits.size(); ++k) {
      for (const Coat coat : study::kCoats) {
        const Found found = results.of_hands(v, k, coat);
        text += fmt::format("WALK({}, \"{}\", {}, {}, {})\n", machine, study::name_of(coat),
                            results.walk.limits[k].pixels, found.of, found.soon);
      }
      if (scope.hands) continue;
      for (std::size_t d = 0; d < results.lights.size(); ++d) {
        if (!results.lights[d].counts) continue;
        const Alarms& alarms = results.alarms[d][v];
        text += fmt::format("LIGHT({}, \"{}\", {}, {}, {})\n", machine, results.lights[d].name,
                            results.walk.limits[k].pixels, alarms.frames, alarms.alarms[k]);
      }
    }
  }
  report.file(scope.hands ? "hands_table.def" : "walk_table.def", text);
}

/// Left images, to see what was walked.
void draw_examples(StudyReport& report, const Walk& walk, const StudyScope& scope) {
  const study::WallScene scene(walk.cameras, walk.photographs[0].second, {0, 0, 1100}, {0.1, 0, -1});
  Matrix3d axes;
  axes << 0.8, 0.6, 0, 0.6, -0.8, 0, 0, 0, -1;
  Image page(2 * walk.geometry.width, 2 * walk.geometry.height);
  for (std::size_t i = 0; i < study::kCoats.size(); ++i) {
    const auto segments = i % 2 == 0 ? study::rod_segments(kHand_mm, kRod_mm) : study::hand_segments();
    const auto views = scene.with_body(study::place(segments, {20, 0, kSkin_mm}, axes), study::kCoats[i], scope.seed);
    const Image image = study::expose(views[0], kNoise_grey, scope.seed, i);
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        page.at(static_cast<int>(i % 2) * image.width + x, static_cast<int>(i / 2) * image.height + y) = image.at(x, y);
      }
    }
  }
  report.picture("bodies.png", "Left images: a textured rod, a plain hand, a skin-coloured rod, a black glove",
                 encode_png(page));
}

nlohmann::json conditions(const Walk& walk, const StudyScope& scope) {
  nlohmann::json limits = nlohmann::json::object();
  for (const ObjectLimit& limit : walk.limits) limits[limit.name] = limit.pixels;
  return {{"rig", "Table 11.1, 640x480"},
          {"profile", walk.profile.name},
          {"skin_mm", kSkin_mm},
          {"thickness_mm", std::round(10 * walk.thickness_mm) / 10},
          {"images_per_s", kImages_per_s},
          {"noise_grey", kNoise_grey},
          {"teaching_pairs", kTeaching},
          {"taught_for_less_light", scope.less_light},
          {"rod_length_mm", kRod_mm},
          {"objects_px_of_the_result", limits},
          {"photographs", walk.photographs.size()},
          {"crossings_of_each", scope.crossings},
          {"frames_of_each_disturbance_and_photograph", scope.frames},
          {"engine", scope.engine}};
}

}  // namespace

void study_walk(StudyReport& report, const StudyScope& scope) {
  const Walk walk = prepare(scope);
  const std::vector<BodyKind> bodies = body_kinds(scope);
  std::vector<Crossing> crossings = plan_crossings(walk, bodies, scope);
  std::vector<Job> jobs = jobs_of(walk, crossings);
  const std::vector<Disturbance> lights = light_disturbances();
  using OfVariants = std::array<Alarms, kVariants.size()>;
  std::vector<std::vector<OfVariants>> alarms(jobs.size(), std::vector<OfVariants>(lights.size()));
  std::atomic<int> forgotten{0};
  Progress progress("part");
  study::parallel_for(
      jobs.size(),
      [&](std::size_t i) {
        Bench bench(walk, scope, jobs[i].photograph, i);
        for (std::size_t v = 0; v < kVariants.size(); ++v) {
          if (kVariants[v].taught && bench.taught(v) < kTeaching) ++forgotten;
        }
        for (Crossing* crossing : jobs[i].crossings) cross(walk, bench, *crossing, scope.seed);
        if (!jobs[i].disturbances || scope.hands) return;
        for (std::size_t d = 0; d < lights.size(); ++d) disturb(walk, bench, lights[d], scope.frames, alarms[i][d]);
      },
      [&](std::size_t done) { progress.show(done, jobs.size()); });
  progress.clear();

  Results results{walk, bodies, crossings, lights, std::vector<OfVariants>(lights.size())};
  for (const auto& of_job : alarms) {
    for (std::size_t d = 0; d < lights.size(); ++d) {
      for (std::size_t v = 0; v < kVariants.size(); ++v) {
        Alarms& sum = results.alarms[d][v];
        const Alarms& one = of_job[d][v];
        sum.frames += one.frames;
        sum.stops += one.stops;
        for (std::size_t k = 0; k < sum.alarms.size(); ++k) sum.alarms[k] += one.alarms[k];
        for (const auto& [name, count] : one.faults) sum.faults[name] += count;
      }
    }
  }
  report.result["conditions"] = conditions(walk, scope);
  report.result["crossings"] = crossings.size();
  report.result["teachings_forgotten"] = forgotten.load();
  report_failures(report, results);
  if (forgotten > 0) {
    report.finding("FAILS: in {} of {} teachings the empty place had an alarm or a fault, and some was forgotten",
                   forgotten.load(), jobs.size() * 2);
  }
  report.finding(
      "{} crossings of {} each; [95 % limits]; the skin is {:.1f} mm thick (D50), at {:g} mm, {:g} images a second",
      crossings.size(), scope.crossings, walk.thickness_mm, kSkin_mm, kImages_per_s);
  report_found(report, results);
  if (!scope.hands) report_alarms(report, results);
  table_crossings(report, results);
  plot_speeds(report, results);
  if (!scope.less_light) write_table(report, results, scope);
  draw_examples(report, walk, scope);
}

}  // namespace horopter::cli
