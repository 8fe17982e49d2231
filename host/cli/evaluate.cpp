// SPDX-License-Identifier: Apache-2.0
// horopter evaluate: "which pixels lie within ±t of disparity d?" against ground truth, beside stereo matching.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <opencv2/core/version.hpp>
#include <string>
#include <vector>

#include "commands.hpp"
#include "horopter/base/json_text.hpp"
#include "horopter/image/evaluation.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/machine/setting_registers.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/plan/tolerance.hpp"
#include "inputs.hpp"
#include "numbers.hpp"
#include "progress.hpp"
#include "settings.hpp"
#include "stereo_matching.hpp"
#include "stereo_pairs.hpp"
#include "words.hpp"

namespace horopter::cli {
namespace {

using nlohmann::json;

/// What the settings of both rules are tuned for.
constexpr double kUsualTolerance_px = 1;

struct EvaluateOptions {
  StereoPairFiles pair;
  std::string list;
  double tolerance_px = kUsualTolerance_px;
  std::vector<double> disparities;
  std::vector<std::string> changes;
  Settings settings;
  std::string engine = "native";
  std::string profile;
  bool json = false;
};

constexpr std::array<const char*, 3> kMethodNames{"horopter", "stereobm", "stereosgbm"};
/// Each is timed so often; the fastest run counts, the least disturbed one.
constexpr int kTimedRuns = 3;

/// One method on one pair.
struct MethodResult {
  std::vector<Score> by_disparity;
  double seconds = 0;
  json parameters;
};

struct PairResult {
  std::string name;
  std::vector<double> disparities;
  std::array<MethodResult, kMethodNames.size()> methods;
};

const MachineProfile& profile_for_images(const EvaluateOptions& options, const StereoPair& pair) {
  const MachineProfile* profile =
      options.profile.empty() ? smallest_profile(pair.left.width, pair.left.height) : &find_profile(options.profile);
  if (profile == nullptr) {
    double factor = 0.5;
    while (smallest_profile(static_cast<int>(factor * pair.left.width), static_cast<int>(factor * pair.left.height)) ==
           nullptr) {
      factor /= 2;
    }
    throw FileError(
        pair.file, "", fmt::format("the image is {}x{} pixels", pair.left.width, pair.left.height),
        fmt::format("{}; --resize {}, or `resize` in the --list, makes it smaller", largest_image(), factor));
  }
  if (profile->takes_fields()) throw UsageError("fields are not evaluated: ground truth is for full frames");
  check_image_size(pair.name, pair.left.width, pair.left.height, *profile);
  return *profile;
}

/// The machine with one skin: states of the pixels of a pair, again and again.
using Machine = std::function<Image(const Image& left, const Image& right)>;

Machine make_machine(const EvaluateOptions& options, const MachineProfile& profile, const MapSet& maps) {
  Settings settings = options.settings;
  settings.undecidable_percent = settings.unsupervised_percent = 100;
  settings.frozen_limit = 0;  // the same images again and again
  const auto supervisor = std::make_shared<Supervisor>(make_picture_device(options.engine, profile), profile, maps,
                                                       settings.without_proof());
  return [supervisor](const Image& left, const Image& right) {
    FrameResult frame = std::move(supervisor->process(left, right).front());
    if (frame.faults.any()) throw DeviceError("fault " + frame.faults.names().front());
    return std::move(frame.states);
  };
}

json rule_parameters(const EvaluateOptions& options, const MachineProfile& profile) {
  json result{{"decision", name_of(options.settings.decision)},
              {"engine", options.engine},
              {"profile", profile.name},
              {"majority_window", profile.majority_window}};
  if (options.settings.decision == Decision::thesis) {
    result.update({{"dsad_window", profile.dsad_window},
                   {"threshold_percent", options.settings.threshold_percent},
                   {"texture", options.settings.texture},
                   {"self_percent", options.settings.self_percent}});
  } else {
    for (const auto& f : kCompeteFields) result[std::string(f.name)] = options.settings.competition.*f.setting;
  }
  return result;
}

MethodResult run_horopter(const EvaluateOptions& options, const StereoPair& pair, const GroundTruth& truth,
                          const std::vector<double>& disparities, const Image& right, int runs) {
  const MachineProfile& profile = profile_for_images(options, pair);
  MethodResult result;
  result.parameters = rule_parameters(options, profile);
  result.seconds = std::numeric_limits<double>::infinity();
  for (const double d : disparities) {
    const MapSet maps = compile_maps(skin_at(d, pair.left), profile, pair.left.width, pair.left.height);
    const Machine machine = make_machine(options, profile, maps);
    Image states;
    for (int run = 0; run < runs; ++run) {
      const auto start = std::chrono::steady_clock::now();
      states = machine(pair.left, right);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
      result.seconds = std::min(result.seconds, took.count());
    }
    result.by_disparity.push_back(score(truth, d, options.tolerance_px, answers_of(states)));
  }
  return result;
}

MethodResult score_matching(const Matching& matching, const GroundTruth& truth, const std::vector<double>& disparities,
                            double tolerance_px) {
  MethodResult result;
  result.seconds = matching.seconds;
  result.parameters = matching.parameters;
  for (const double d : disparities) {
    result.by_disparity.push_back(score(truth, d, tolerance_px, answers_of(matching, d, tolerance_px)));
  }
  return result;
}

PairResult evaluate_pair(const EvaluateOptions& options, const StereoPair& pair, const GroundTruth& truth,
                         const std::string& change) {
  PairResult result;
  result.name = pair.name;
  result.disparities = options.disparities.empty() ? truth.frequent() : options.disparities;
  if (result.disparities.empty()) {
    throw FileError(pair.name, "", "no pixel of the ground truth counts",
                    "known pixels visible in both images, and in the mask");
  }
  const Image right = changed(pair.right, change);
  const int runs = change == "none" ? kTimedRuns : 1;
  const double largest = std::max(truth.largest_px(), std::ranges::max(result.disparities) + options.tolerance_px);
  auto& [horopter, bm, sgbm] = result.methods;
  horopter = run_horopter(options, pair, truth, result.disparities, right, runs);
  bm = score_matching(match_bm(pair.left, right, largest, runs), truth, result.disparities, options.tolerance_px);
  sgbm = score_matching(match_sgbm(pair.left, right, largest, runs), truth, result.disparities, options.tolerance_px);
  return result;
}

json to_json(const Score& s) {
  return {{"precision", s.precision()},
          {"recall", s.recall()},
          {"iou", s.iou()},
          {"objects", s.objects},
          {"found", s.found},
          {"false_per_frame", s.false_objects},
          {"undecidable", s.undecidable_share()},
          {"called_clear", s.called_clear_share()}};
}

/// Mean of every figure, over frames or pairs; of objects the sum.
json mean_of(const std::vector<json>& rows) {
  json mean = json::object();
  for (const auto& [key, first] : rows.front().items()) {
    if (!first.is_number() || key == "disparity") continue;
    double sum = 0;
    for (const json& row : rows) sum += row.at(key).get<double>();
    if (key == "objects" || key == "found") {
      mean[key] = std::lround(sum);
    } else {
      mean[key] = sum / static_cast<double>(rows.size());
    }
  }
  return mean;
}

json to_json(const std::vector<PairResult>& pairs) {
  json result{{"pairs", json::array()}, {"mean", json::object()}};
  std::array<std::vector<json>, kMethodNames.size()> all;
  for (const PairResult& pair : pairs) {
    json methods = json::object();
    for (std::size_t m = 0; m < kMethodNames.size(); ++m) {
      const MethodResult& method = pair.methods[m];
      std::vector<json> rows;
      for (std::size_t i = 0; i < pair.disparities.size(); ++i) {
        rows.push_back(to_json(method.by_disparity[i]));
        rows.back()["disparity"] = pair.disparities[i];
      }
      json one = mean_of(rows);
      one["seconds"] = method.seconds;
      all[m].push_back(one);
      one["parameters"] = method.parameters;
      one["by_disparity"] = rows;
      methods[kMethodNames[m]] = one;
    }
    result["pairs"].push_back({{"name", pair.name}, {"disparities", pair.disparities}, {"methods", methods}});
  }
  for (std::size_t m = 0; m < kMethodNames.size(); ++m) result["mean"][kMethodNames[m]] = mean_of(all[m]);
  return result;
}

void print_row(const std::string& pair, const std::string& method, const json& row, bool timed) {
  fmt::print("{:<12} {:<11} {:9.3f} {:7.3f} {:6.3f}   {:4}/{:<4} {:9.2f} {:11.3f} {:12.3f}", pair, method,
             row["precision"].get<double>(), row["recall"].get<double>(), row["iou"].get<double>(),
             row["found"].get<int>(), row["objects"].get<int>(), row["false_per_frame"].get<double>(),
             row["undecidable"].get<double>(), row["called_clear"].get<double>());
  if (timed) fmt::print(" {:7.1f}", 1000 * row["seconds"].get<double>());
  fmt::print("\n");
}

void print_table(const json& result) {
  fmt::print("{:<12} {:<11} {:>9} {:>7} {:>6}   {:>9} {:>9} {:>11} {:>12} {:>7}\n", "pair", "method", "precision",
             "recall", "IoU", "found", "false", "undecidable", "called clear", "ms");
  for (const json& pair : result["pairs"]) {
    const auto name = pair["name"].get<std::string>();
    for (const char* method : kMethodNames) {
      const json& one = pair["methods"][method];
      for (const json& row : one["by_disparity"]) {
        print_row(fmt::format("{} {:g}", name.substr(0, 8), row["disparity"].get<double>()), method, row, false);
      }
      print_row(name, method, one, true);
    }
  }
}

void print(const json& result) {
  print_table(result);
  fmt::print("\nParameters\n");
  for (const char* method : kMethodNames) {
    fmt::print("  {}:", method);
    for (const auto& [key, value] : result["pairs"][0]["methods"][method]["parameters"].items()) {
      fmt::print(" {}={}", key, value.is_string() ? value.get<std::string>() : value.dump());
    }
    fmt::print("\n");
  }
  fmt::print("  numDisparities as each pair's ground truth needs; OpenCV {}\n", CV_VERSION);
  const auto print_mean = [](const json& one) {
    for (const char* method : kMethodNames) print_row("mean", method, one["mean"][method], true);
  };
  fmt::print("\nMean of all pairs: {}\n", describe_change("none"));
  print_mean(result);
  for (const auto& [change, one] : result["changed"].items()) {
    fmt::print("\nMean of all pairs: {}\n", describe_change(change));
    print_mean(one);
  }
}

ExitStatus evaluate(const EvaluateOptions& options) {
  std::vector<StereoPairFiles> files;
  const bool single = !options.pair.left.empty() || !options.pair.right.empty() || !options.pair.disparity.empty() ||
                      !options.pair.mask.empty();
  if (single == !options.list.empty()) throw UsageError("either --list, or --left, --right and --disparity");
  if (single) {
    if (options.pair.left.empty() || options.pair.right.empty() || options.pair.disparity.empty()) {
      throw UsageError("--left, --right and --disparity go together");
    }
    files.push_back(options.pair);
    files.back().name = std::filesystem::path(options.pair.left).parent_path().filename().string();
    if (files.back().name.empty()) files.back().name = std::filesystem::path(options.pair.left).stem().string();
  } else {
    files = read_pair_list(options.list);
  }
  std::vector<StereoPair> pairs;
  for (const StereoPairFiles& one : files) pairs.push_back(load_pair(one));
  std::vector<GroundTruth> truths;
  for (const StereoPair& pair : pairs) truths.push_back(pair.ground_truth());

  std::vector<std::string> changes{"none"};
  for (const std::string& name : options.changes) {
    if (name != "none") changes.push_back(name);
  }
  Progress progress("evaluating pair");
  const std::size_t steps = changes.size() * pairs.size();
  std::size_t step = 0;
  json result;
  json by_change = json::object();
  for (const std::string& change : changes) {
    std::vector<PairResult> results;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      progress.show(++step, steps);
      results.push_back(evaluate_pair(options, pairs[i], truths[i], change));
    }
    if (change == "none") {
      result = to_json(results);
    } else {
      by_change[change] = to_json(results);
    }
  }
  progress.clear();
  result["tolerance_px"] = options.tolerance_px;
  result["changed"] = by_change;
  if (options.json) {
    std::puts(json_text(result).c_str());
  } else {
    print(result);
  }
  return ExitStatus::done;
}

}  // namespace

void add_evaluate(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<EvaluateOptions>();
  // Every pixel that counts wants an answer, so none is left undecidable here; 21 % are 36 degrees.
  options->settings.threshold_percent = 21;
  options->settings.texture = 0;
  options->settings.self_percent = 0;
  options->changes = change_names();
  CLI::App* command = app.add_subcommand(
      "evaluate", "Which pixels lie within a tolerance of a disparity? Against ground truth, beside stereo matching");
  command->add_option("--left", options->pair.left, "Left image of a rectified pair")->type_name("FILE");
  command->add_option("--right", options->pair.right, "Right image")->type_name("FILE");
  command->add_option("--disparity", options->pair.disparity, "Ground truth for the left image: PNG, PGM or PFM")
      ->type_name("FILE");
  command->add_option("--mask", options->pair.mask, "Image that is 255 where both cameras see; only there pixels count")
      ->type_name("FILE");
  command->add_option("--scale", options->pair.scale, "Value of the ground truth for 1 px")
      ->check(above_zero())
      ->capture_default_str();
  command->add_option("--resize", options->pair.resize, "Factor by which images and ground truth are made smaller")
      ->check(above_zero())
      ->capture_default_str();
  command
      ->add_option(
          "--list", options->list,
          "Several pairs: a line `name left right disparity scale resize mask` each, the last three may be left "
          "out; paths relative to the list")
      ->type_name("FILE");
  command
      ->add_option("--tolerance", options->tolerance_px,
                   "Half the thickness of the skin, px. The rules are made for the default; to another one they are "
                   "set, too, unless --threshold or --boundary is given")
      ->check(above_zero())
      ->capture_default_str();
  command
      ->add_option("--disparities", options->disparities,
                   "Disparities of the skins, px (default: up to six of the most frequent, at least 3 px apart)")
      ->delimiter(',')
      ->check(zero_or_more())
      ->type_name("D,…");
  only(command
           ->add_option("--change", options->changes,
                        "Evaluate also with these changes of the right image (default: all)")
           ->delimiter(','),
       change_names());
  add_decision(*command, options->settings.decision);
  const CLI::Option* threshold =
      command
          ->add_option("--threshold", options->settings.threshold_percent,
                       "thesis: in the skin up to this share of the largest sum of direction differences, %")
          ->check(within(0.1, 100, "%"))
          ->capture_default_str();
  command
      ->add_option("--texture", options->settings.texture,
                   "thesis: smallest mean gradient that decides, in units of the Sobel magnitude")
      ->check(CLI::Range(0, 255))
      ->capture_default_str();
  command
      ->add_option("--self", options->settings.self_percent,
                   "thesis: a window whose directions vary less is no texture, % as --threshold")
      ->check(within(0, 100, "%"))
      ->capture_default_str();
  const auto compete_option = [&](const char* name, int& value, int largest, const char* what) {
    return command->add_option(name, value, what)->check(CLI::Range(0, largest))->capture_default_str();
  };
  compete_option("--bias", options->settings.competition.bias, 15, "compete: added to every vote");
  compete_option("--smooth", options->settings.competition.smooth, 7,
                 "compete: neighbours of a row are alike up to this difference, 4 grey levels");
  compete_option("--similar", options->settings.competition.similar, 15, "compete: pixels of a column likewise");
  compete_option("--quorum", options->settings.competition.quorum, 255,
                 "compete: smallest sum of votes that says skin");
  compete_option("--clear-quorum", options->settings.competition.clear_quorum, 255,
                 "compete: smallest sum of votes against that says clear, 8 votes");
  const CLI::Option* boundary =
      compete_option("--boundary", options->settings.competition.boundary, 14,
                     "compete: where the skin ends, from about 1/2 to 3/2 px before and behind it");
  add_engine(*command, options->engine)->capture_default_str();
  command
      ->add_option("--profile", options->profile,
                   "Build of the machine: " + profile_sizes() + " (default: the smallest that holds the image)")
      ->type_name("P");
  command->add_flag("--json", options->json, "Print the result as JSON on standard output, and nothing else");
  command->footer(
      "A pixel counts where ground truth is known, x >= largest disparity + 8, no pixel of the same row nearer by\n"
      "more than 1 px lands on the same right column, and the mask, if there is one, is 255. An object is a connected\n"
      "region in the skin of at least 0.2 % of the image, found where at least 30 % of it is answered; a false object is\n"
      "an answered region of that size with less than 10 % of it within the tolerance + 1 px. Undecidable pixels count as\n"
      "not in the skin. Times are of one thread: of one skin for Horopter, of all disparities for the matchers.\n\n"
      "Example: horopter evaluate --left im2.png --right im6.png --disparity disp2.png --scale 4");
  command->callback([=, &outcome] {
    const CLI::Option* own = options->settings.decision == Decision::thesis ? threshold : boundary;
    if (options->tolerance_px != kUsualTolerance_px && own->count() == 0) {
      set_tolerance(options->settings, options->tolerance_px);
    }
    outcome.status = evaluate(*options);
  });
}

}  // namespace horopter::cli
