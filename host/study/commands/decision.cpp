// SPDX-License-Identifier: Apache-2.0
// The rules of decision, with parts of `compete` left out or made larger and smaller: what each gains and costs. The
// hardware's own stages, compiled for the CPU, one call of step a beat.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/progress.hpp"
#include "cli/stereo_matching.hpp"
#include "cli/stereo_pairs.hpp"
#include "conditions.hpp"
#include "horopter/base/file.hpp"
#include "horopter/image/evaluation.hpp"
#include "horopter/machine/engines.hpp"
#include "horopter/machine/monitor.hpp"
#include "horopter/map/map_compiler.hpp"
#include "horopter/study/parallel.hpp"
#include "horopter/study/scene.hpp"
#include "stages/pipeline.hpp"
#include "study.hpp"

namespace horopter::stages {

inline constexpr PlaneSet<13> kPlanes13{{-18, -10, -6, -3, -2, -1, 0, 1, 2, 3, 6, 10, 18}};
inline constexpr PlaneSet<15> kPlanes15{{-18, -10, -6, -4, -3, -2, -1, 0, 1, 2, 3, 4, 6, 10, 18}};
static_assert(kPlanes13.valid() && kPlanes15.valid());
template <>
inline constexpr const auto& planes_of<13> = kPlanes13;  // NOLINT(readability-identifier-naming)
template <>
inline constexpr const auto& planes_of<15> = kPlanes15;  // NOLINT(readability-identifier-naming)

}  // namespace horopter::stages

namespace horopter::cli {
namespace {

using hls::Profile;

constexpr int kWidest = 1280;  // px
constexpr int kHighest = 1024;
constexpr double kTolerance_px = 1;
constexpr const char* kAsBuilt = "compete, as in vga";
constexpr double kNoise_grey = 2;  ///< standard deviation of what cameras show of a plain surface
/// A variant that leaves less of such noise undecided calls plain surfaces clear, and is not to be built.
constexpr double kLeastUndecidedNoise = 0.9;

/// Parts of the rule that a variant has.
struct Parts {
  bool boundary = true;  ///< between pixels
  bool evidence = true;
  bool from_right = true;
  bool ballot = true;
};

constexpr Profile profile_of(int planes = 19, int rows = 7, int columns = 9, int reach = 9, bool paths = true) {
  Profile profile = hls::profiles::vga;
  profile.width = kWidest;
  profile.height = kHighest;
  profile.planes = planes;
  profile.sum_rows = rows;
  profile.sum_columns = columns;
  profile.ballot_reach = reach;
  profile.paths = paths;
  return profile;
}

/// The stages of one profile with a part left out, for images whose skin is the plane at a whole disparity.
template <Profile P>
class Variation {
 public:
  explicit Variation(const Parts& parts) : parts_(parts) {
    settings_.compete = 1;
    CompeteSettings& competition = settings_;
    if (!parts.boundary) competition.boundary = 14;  // where outer planes win by themselves
    quorum_ = competition.quorum;
    // Of one row instead of all that the ballot asks.
    clear_quorum_ = 8 * competition.clear_quorum / stages::Ballot<P>::quorum_rows;
  }

  Image states(const Image& left, const Image& right, int disparity_px) {
    Image result(left.width, left.height);
    std::size_t written = 0;
    width_ = static_cast<std::size_t>(left.width);
    chain_.configure(native::FrameSettings(settings_, left.width, left.height));
    const auto see = [&]<Stage STAGE>(stages::At<STAGE>, auto& out) {
      if constexpr (STAGE == Stage::plane_paths) {
        if (!parts_.evidence) out.evident = out.known;
        if (!parts_.from_right) out.known = false;  // of use only there
      } else if constexpr (STAGE == Stage::spread) {
        if (!parts_.ballot) wait(out);
      } else if constexpr (STAGE == Stage::ballot) {
        if (!parts_.ballot) out = without_ballot(out.marks);
      } else if constexpr (STAGE == Stage::align) {
        if (!out.idle) result.pixels[written++] = static_cast<std::uint8_t>(out.state.value());
      }
    };
    for (int y = 0; y < left.height + P.flush_rows(true); ++y) {
      for (int x = 0; x < left.width; ++x) chain_.step(pair_at(left, right, x, y, disparity_px), see);
    }
    return result;
  }

 private:
  using Stage = stages::Stage;
  using Ballot = typename stages::Ballot<P>::Out;

  static stages::Grey<2> pair_at(const Image& left, const Image& right, int x, int y, int disparity_px) {
    stages::Grey<2> pair;
    pair.mask = y < left.height && x >= disparity_px;
    if (pair.mask) {
      const std::uint8_t l = left.at(x, y);
      const std::uint8_t r = right.at(x - disparity_px, y);
      pair.pixel = {hls::u<8>(l), hls::u<8>(r)};
      pair.saturated = l == 0 || l == 255 || r == 0 || r == 255;
    }
    pair.marks = {x == 0 && y == 0, x + 1 == left.width, true, false};  // clear need not be earned
    return pair;
  }

  /// What a pixel's own row says waits as long as for the ballot, for which `align` is made.
  void wait(const stages::VoteSpread<>::Out& spread) {
    const int sum = static_cast<int>(spread.vote.value());
    waiting_.push_back(
        {sum >= quorum_, sum <= -clear_quorum_ || (sum < 0 && spread.firm), spread.exists, stages::Marks{}});
  }
  Ballot without_ballot(const stages::Marks& marks) {
    Ballot said;
    if (waiting_.size() > P.ballot_reach * width_) {
      said = waiting_.front();
      waiting_.pop_front();
    }
    said.marks = marks;
    return said;
  }

  Parts parts_;
  native::Settings settings_;
  int quorum_ = 0;
  int clear_quorum_ = 0;
  std::size_t width_ = 0;
  std::deque<Ballot> waiting_;
  stages::Chain<P, hls::Rule::compete, stages::Stage::slopes> chain_;
};

using States = std::function<Image(const Image& left, const Image& right, int disparity_px)>;

struct Variant {
  std::string name;
  hls::Rule rule;
  int rows = 0;         ///< of latency, without LOOKAHEAD
  int memory_bits = 0;  ///< for each column of the image
  States states;
};

/// What the stages keep for each column, as their headers say; checked against what hlsc made of the built ones.
int memory_bits(const Profile& p, const Parts& parts) {
  const int half = (p.sum_rows - 1) / 2;
  const int column_sum = hls::bits_for(static_cast<std::uint64_t>(31 * p.sum_rows));
  const int edges = hls::bits_for(static_cast<std::uint64_t>(p.sum_rows));
  const int slopes = 36;
  const int sums = slopes + 24 * p.sum_rows + (p.planes + 1) * column_sum + edges + 7 * half;
  const int paths = p.paths ? 6 * p.planes : 0;
  const int ballot = parts.ballot ? 2 * p.ballot_reach * 14 + 2 * p.ballot_reach : 0;
  return sums + paths + ballot + 3 * (p.majority_window - 1);
}

template <Profile P>
Variant variant(const std::string& name, const Parts& parts = {}) {
  return {name, hls::Rule::compete, P.compete_offset() - (parts.ballot ? 0 : P.ballot_reach), memory_bits(P, parts),
          [parts](const Image& left, const Image& right, int disparity_px) {
            return std::make_unique<Variation<P>>(parts)->states(left, right, disparity_px);
          }};
}

/// A bit of each word of a stage's memories that is no part of the rule.
bool has_parity(const nlohmann::json& sidecar) {
  return std::ranges::any_of(sidecar.value("ports", nlohmann::json::array()),
                             [](const auto& port) { return port.value("name", "") == "parity_error_o"; });
}

/// What hlsc says of the stages that only one rule needs, for each column, without parity.
int built_bits(const std::string& generated, const std::string& profile, hls::Rule rule) {
  int bits = 0;
  const auto add = [&](const char* stage, hls::Rule needs) {
    if (needs != rule) return;
    const std::string file = fmt::format("{}/{}/horopter_{}.json", generated, profile, stage);
    const std::vector<std::uint8_t> text = read_file(file, "what hlsc writes beside a stage (--generated)");
    const auto sidecar = nlohmann::json::parse(text, nullptr, false);
    if (!sidecar.contains("memory_bits")) throw FileError(file, "memory_bits", "not there", "as hlsc writes it");
    bits += sidecar["memory_bits"].get<int>();
    if (!has_parity(sidecar)) return;
    for (const auto& memory : sidecar.value("memories", nlohmann::json::array())) bits -= memory.value("depth", 0);
  };
#define HOROPTER_STAGE(name, Class, rule, place) add(#name, hls::Rule::rule);
#include "stages/stage_list.def"
  return bits / find_profile(profile).result_width();
}

void check_built(const std::string& generated, const Profile& p, const std::string& profile) {
  const int built = built_bits(generated, profile, hls::Rule::compete);
  if (memory_bits(p, {}) == built) return;
  throw Error(ExitStatus::check_failed, fmt::format("the stages of {} keep {} bits per column, not the {} counted",
                                                    profile, built, memory_bits(p, {})));
}

/// On the native engine.
Variant thesis(const std::string& name, const Settings& settings, int memory_bits) {
  return {name, hls::Rule::thesis, hls::profiles::vga.offset(), memory_bits,
          [settings](const Image& left, const Image& right, int disparity_px) {
            const MachineProfile& profile = *smallest_profile(left.width, left.height);
            Supervisor machine(make_device("native", profile), profile,
                               compile_maps(skin_at(disparity_px, left), profile, left.width, left.height),
                               settings.without_proof());
            return std::move(machine.process(left, right).front().states);
          }};
}

std::vector<Variant> variants(const StudyScope& scope) {
  check_built(scope.generated, hls::profiles::vga, "vga");
  check_built(scope.generated, hls::profiles::hd, "hd");
  const int thesis_bits = built_bits(scope.generated, "vga", hls::Rule::thesis);
  Settings as_run;
  Settings all_decided;
  all_decided.threshold_percent = 21;
  all_decided.texture = 0;
  all_decided.self_percent = 0;
  std::vector<Variant> list{thesis("thesis, 25 %, texture 32", as_run, thesis_bits),
                            thesis("thesis, 21 %, every pixel decided", all_decided, thesis_bits),
                            variant<profile_of()>(kAsBuilt),
                            variant<profile_of(19, 7, 9, 9, false)>("without paths"),
                            variant<profile_of()>("without the boundary between pixels", {.boundary = false}),
                            variant<profile_of()>("without evidence", {.evidence = false})};
  if (scope.quick) return list;
  list.push_back(variant<profile_of()>("without the ballot", {.ballot = false}));
  list.push_back(variant<profile_of()>("without the view from the right", {.from_right = false}));
  list.push_back(variant<profile_of(15)>("15 planes"));
  list.push_back(variant<profile_of(13)>("13 planes"));
  list.push_back(variant<profile_of(19, 7, 9, 7)>("ballot of 7 rows each way"));
  list.push_back(variant<profile_of(19, 7, 9, 5)>("ballot of 5 rows each way"));
  list.push_back(variant<profile_of(19, 5, 7)>("sums of 5x7"));
  list.push_back(variant<profile_of(19, 9, 11)>("sums of 9x11"));
  list.push_back(variant<profile_of(19, 7, 9, 5, false)>("compete, as in hd: no paths, ballot of 5 rows"));
  return list;
}

/// A block 8 px before a background, both of them textures of the simulation.
StereoPair simulated_scene(const StudyScope& scope, study::TextureKind kind, const std::string& name) {
  constexpr int kFar_px = 8;
  constexpr int kNear_px = 16;
  study::Conditions conditions;
  conditions.texture.kind = kind;
  conditions.camera.blur_px = 1.2;
  conditions.lighting.slope_x = 0.4;
  conditions.seed = scope.seed;
  conditions.camera.width = 320;
  conditions.camera.height = 240;
  conditions.electronics.averaged = 1;
  const study::Simulation background(conditions, kNear_px + 1);
  conditions.seed += 1;
  const study::Simulation object(conditions, kNear_px + 1);
  StereoPair pair{name, background.photograph(0, 1), background.photograph(kFar_px, 2), {320, 240, {}}};
  pair.truth.px.assign(pair.left.pixels.size(), kFar_px);
  const Image left = object.photograph(0, 3);
  const Image right = object.photograph(kNear_px, 4);
  for (int y = 80; y < 180; ++y) {
    for (int x = 120; x < 230; ++x) {
      pair.left.at(x, y) = left.at(x, y);
      pair.right.at(x - kNear_px, y) = right.at(x - kNear_px, y);
      pair.truth.px[static_cast<std::size_t>(y * 320 + x)] = kNear_px;
    }
  }
  return pair;
}

/// Pairs of one list, from `first` up to before `end` of all pairs.
struct Set {
  std::string name;
  std::size_t first = 0, end = 0;
};

struct Pairs {
  std::vector<StereoPair> all;
  std::vector<Set> sets;  ///< one for each list
};

Pairs listed_pairs(const std::vector<std::string>& lists) {
  Pairs pairs;
  for (const std::string& list : lists) {
    const std::size_t first = pairs.all.size();
    for (const StereoPairFiles& files : read_pair_list(list)) {
      const StereoPair& pair = pairs.all.emplace_back(load_pair(files));
      if (pair.left.width <= kWidest && pair.left.height <= kHighest) continue;
      throw FileError(list, pair.name, fmt::format("images of {}x{} px", pair.left.width, pair.left.height),
                      fmt::format("at most {}x{} (`resize` makes them smaller)", kWidest, kHighest));
    }
    pairs.sets.push_back({std::filesystem::path(list).stem().string(), first, pairs.all.size()});
  }
  return pairs;
}

Pairs pairs_of(const StudyScope& scope) {
  if (!scope.lists.empty()) return listed_pairs(scope.lists);
  std::vector<StereoPair> pairs;
  const std::string data = scope.data + "/";
  if (std::filesystem::exists(data + "aloeL.jpg")) {
    pairs.push_back(load_pair({"aloe", data + "aloeL.jpg", data + "aloeR.jpg", data + "aloeGT.png", 1, 0.5}));
  }
  pairs.push_back(simulated_scene(scope, study::TextureKind::dead_leaves, "leaves"));
  pairs.push_back(simulated_scene(scope, study::TextureKind::band_noise, "noise"));
  return {std::move(pairs), {}};
}

/// Gates of the stages that only one rule needs, from what scripts/synth wrote of each.
std::string gates_text(const std::string& synthesised) {
  std::string text =
      "\n`scripts/synth` measures each stage that is built: `scripts/synth --target ecp5-85k --profile hd --decision "
      "compete --module contest --seeds 0 --json DIR/contest.json`, and so on. `horopter study decision --synth DIR` "
      "makes a table of the files in DIR here.\n";
  if (synthesised.empty()) return text;
  text +=
      "\n| stage | rule | profile | LUT4 | flip-flops | memory blocks | multipliers |\n| --- | --- | --- | --- | --- | "
      "--- | --- |\n";
  const auto add = [&](const char* stage, hls::Rule rule) {
    if (rule == hls::Rule::always) return;
    const std::string file = fmt::format("{}/{}.json", synthesised, stage);
    const auto json = nlohmann::json::parse(read_file(file, "what scripts/synth --json writes"), nullptr, false);
    if (!json.contains("resources")) throw FileError(file, "resources", "not there", "as scripts/synth writes it");
    const auto count = [&](const char* kind) { return json["resources"].value(kind, 0); };
    text +=
        fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", stage, rule == hls::Rule::thesis ? "thesis" : "compete",
                    json.value("profile", "?"), count("LUT4"), count("FF"), count("BRAM"), count("MULT"));
  };
#define HOROPTER_STAGE(name, Class, rule, place) add(#name, hls::Rule::rule);
#include "stages/stage_list.def"
  return text;
}

struct Mean {
  double iou = 0, false_objects = 0, undecidable = 0;

  /// One of `count` of which this is the mean.
  void add(double part_iou, double part_false, double part_undecidable, std::size_t count) {
    iou += part_iou / static_cast<double>(count);
    false_objects += part_false / static_cast<double>(count);
    undecidable += part_undecidable / static_cast<double>(count);
  }
  void add(const Mean& part, std::size_t count) { add(part.iou, part.false_objects, part.undecidable, count); }
};

/// Who answers: a variant of a rule, or OpenCV's StereoSGBM.
using Answers = std::function<std::vector<Answer>(const StereoPair&, double disparity_px)>;

/// Over the most frequent disparities of one pair.
Mean measure(const Answers& answers, const StereoPair& pair, const GroundTruth& truth, int most) {
  Mean mean;
  const std::vector<double> disparities = truth.frequent(most);
  for (const double d : disparities) {
    const Score one = score(truth, d, kTolerance_px, answers(pair, d));
    mean.add(one.iou(), one.false_objects, one.undecidable_share(), disparities.size());
  }
  return mean;
}

/// The matcher is asked once for each pair: it knows all disparities.
Answers sgbm_on(const StereoPair& pair, const GroundTruth& truth) {
  const Matching matching = match_sgbm(pair.left, pair.right, truth.largest_px() + kTolerance_px, 1);
  return [matching](const StereoPair& /*same*/, double disparity_px) {
    return answers_of(matching, disparity_px, kTolerance_px);
  };
}

/// Of each variant, and of StereoSGBM behind them, for each pair.
std::vector<std::vector<Mean>> measure(const std::vector<Variant>& all, const std::vector<StereoPair>& pairs,
                                       int most) {
  std::vector<GroundTruth> truths;
  for (const StereoPair& pair : pairs) truths.push_back(pair.ground_truth());
  std::vector<std::vector<Mean>> found(all.size() + 1, std::vector<Mean>(pairs.size()));
  Progress progress("variant and pair");
  const std::size_t count = found.size() * pairs.size();
  study::parallel_for(
      count,
      [&](std::size_t i) {
        const std::size_t v = i / pairs.size(), p = i % pairs.size();
        const Answers answers =
            v == all.size()
                ? sgbm_on(pairs[p], truths[p])
                : [&variant = all[v]](const StereoPair& pair, double disparity_px) {
                    return answers_of(variant.states(pair.left, pair.right, static_cast<int>(disparity_px)));
                  };
        found[v][p] = measure(answers, pairs[p], truths[p], most);
      },
      [&](std::size_t done) { progress.show(done, count); });
  return found;
}

/// Over the pairs of a set, or over all but those.
Mean mean_of(const std::vector<Mean>& of_pairs, const Set& set, bool within) {
  const auto belongs = [&](std::size_t p) { return (p >= set.first && p < set.end) == within; };
  const std::size_t inside = set.end - set.first;
  Mean mean;
  for (std::size_t p = 0; p < of_pairs.size(); ++p) {
    if (belongs(p)) mean.add(of_pairs[p], within ? inside : of_pairs.size() - inside);
  }
  return mean;
}

/// Share that each variant leaves undecided where both cameras show noise alone, each its own.
std::vector<double> undecided_noise(const std::vector<Variant>& all, std::uint64_t seed) {
  constexpr int kDisparity_px = 10;
  const study::Raster<float> grey(320, 240, 128);
  const Image left = study::expose(grey, kNoise_grey, seed, 1);
  const Image right = study::expose(grey, kNoise_grey, seed, 2);
  const GroundTruth truth({left.width, left.height, std::vector<float>(left.pixels.size(), kDisparity_px)});
  std::vector<double> shares;
  for (const Variant& variant : all) {
    const Image states = variant.states(left, right, kDisparity_px);
    shares.push_back(score(truth, kDisparity_px, kTolerance_px, answers_of(states)).undecidable_share());
  }
  return shares;
}

std::size_t as_built(const std::vector<Variant>& all) {
  return static_cast<std::size_t>(std::ranges::find(all, kAsBuilt, &Variant::name) - all.begin());
}

/// What a variant that was chosen by the other sets reaches on each: no figure of a set by which it was chosen.
std::string left_one_set_out(StudyReport& report, const std::vector<Variant>& all, const std::vector<double>& noise,
                             const std::vector<std::vector<Mean>>& found, const std::vector<Set>& sets) {
  if (sets.size() < 2) return "";
  std::string text = fmt::format(R"(
## One set left out

Each list is a set. For each set the variant of `compete` is taken that has the best IoU on the *other* sets, of those that leave at least
{:.0f} % of noise undecided. The figures are those of this variant on the set itself, which had no part in the choice. StereoSGBM is
OpenCV's, on the same pairs.

| set | pairs | chosen by the other sets | IoU | as in vga | StereoSGBM | false objects per frame (StereoSGBM) | undecidable (StereoSGBM) |
| --- | --- | --- | --- | --- | --- | --- | --- |
)",
                                 100 * kLeastUndecidedNoise);
  for (const Set& set : sets) {
    const auto elsewhere = [&](std::size_t v) { return mean_of(found[v], set, false).iou; };
    std::size_t chosen = as_built(all);
    for (std::size_t v = 0; v < all.size(); ++v) {
      if (all[v].rule != hls::Rule::compete || noise[v] < kLeastUndecidedNoise) continue;
      if (elsewhere(v) > elsewhere(chosen)) chosen = v;
    }
    const Mean its = mean_of(found[chosen], set, true), peer = mean_of(found.back(), set, true);
    const double as_in_vga = mean_of(found[as_built(all)], set, true).iou;
    text += fmt::format("| {} | {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.2f} ({:.2f}) | {:.3f} ({:.3f}) |\n", set.name,
                        set.end - set.first, all[chosen].name, its.iou, as_in_vga, peer.iou, its.false_objects,
                        peer.false_objects, its.undecidable, peer.undecidable);
    report.result["left_one_set_out"].push_back({{"set", set.name},
                                                 {"chosen", all[chosen].name},
                                                 {"iou", its.iou},
                                                 {"iou_as_in_vga", as_in_vga},
                                                 {"iou_stereosgbm", peer.iou},
                                                 {"false_per_frame", its.false_objects},
                                                 {"false_per_frame_stereosgbm", peer.false_objects},
                                                 {"undecidable", its.undecidable},
                                                 {"undecidable_stereosgbm", peer.undecidable}});
    report.finding("set {}: by the other sets '{}', IoU {:.3f}; as in vga {:.3f}, StereoSGBM {:.3f}", set.name,
                   all[chosen].name, its.iou, as_in_vga, peer.iou);
  }
  return text;
}

/// The page up to the rows of its table.
constexpr const char* kIntroduction = R"(# The decision

Made by `horopter study decision`: do not edit. A *rule* decides for each pixel whether something is in the skin. There are two:
`thesis` (one threshold) and `compete` (parallel skins compete). This page measures what each part of `compete` is worth: in the
variants a part is left out, or larger, or smaller. All variants of `compete` have the default settings. The two variants of `thesis`
name theirs, as `run --threshold` and `--texture`. The stages of the rules are compiled for the CPU.

The question is always which pixels lie within ±1 px of a disparity, for up to six disparities of each of the pairs {}. Answers
are scored as by `horopter evaluate`.

| word | meaning |
| --- | --- |
| IoU | intersection over union: pixels that are both answered and true, over those that are one or the other; 1 is perfect |
| against vga's | the IoU less that of *compete, as in vga* |
| false object | a connected group of answered pixels, at least 0.2 % of the image, where nearly nothing is true |
| undecidable | share of the pixels that the rule leaves open |
| undecidable, noise | the same where both cameras show noise of {} grey levels and nothing else; what decides there calls plain surfaces clear |
| memory | bits that the rule's own stages keep for each column of the image, without parity |
| latency | rows from the newest row of the right image to the result, beyond LOOKAHEAD (how many rows the right image must be ahead of the result) |
| planes | the parallel skins that compete |
| sums | the window over which the differences of both images on a plane are summed, rows x columns |
| paths | the sums of the pixel above are used, too |
| boundary | the skin ends between two pixels: the place is estimated |
| view from the right | the right pixel is asked, too, which plane it prefers |
| ballot | pixels of like brightness in the rows above and below vote |
| evidence | a pixel with too little texture does not vote |

| variant | IoU | against vga's | false objects per frame | undecidable | undecidable, noise | memory, bits per column | latency, rows |
| --- | --- | --- | --- | --- | --- | --- | --- |
)";

}  // namespace

void study_decision(StudyReport& report, const StudyScope& scope) {
  const Pairs read = pairs_of(scope);
  const std::vector<StereoPair>& pairs = read.all;
  const std::vector<Variant> all = variants(scope);
  const std::vector<std::vector<Mean>> found = measure(all, pairs, scope.quick ? 2 : 6);
  std::vector<Mean> means;
  for (const std::vector<Mean>& of_pairs : found) means.push_back(mean_of(of_pairs, {"all", 0, pairs.size()}, true));
  const double reference = means[as_built(all)].iou;
  const std::vector<double> noise = undecided_noise(all, scope.seed);
  std::string names;
  for (const StereoPair& pair : pairs) names += (names.empty() ? "" : ", ") + pair.name;
  std::string page = fmt::format(kIntroduction, names, kNoise_grey);
  Csv csv({"variant", "iou", "false_per_frame", "undecidable", "undecidable_noise", "memory_bits_per_column",
           "latency_rows"});
  for (std::size_t v = 0; v < all.size(); ++v) {
    const auto& [name, rule, rows, bits, states] = all[v];
    const auto& [iou, false_objects, undecidable] = means[v];
    page += fmt::format("| {} | {:.3f} | {:+.3f} | {:.2f} | {:.3f} | {:.3f} | {} | {} |\n", name, iou, iou - reference,
                        false_objects, undecidable, noise[v], bits, rows);
    csv.row(name, iou, false_objects, undecidable, noise[v], bits, rows);
    report.result["variants"].push_back({{"name", name},
                                         {"iou", iou},
                                         {"false_per_frame", false_objects},
                                         {"undecidable", undecidable},
                                         {"undecidable_noise", noise[v]},
                                         {"memory_bits_per_column", bits},
                                         {"latency_rows", rows}});
    report.finding("{:48} IoU {:.3f}, false {:.2f}, undecidable {:.3f}; {:4} bits per column, {} rows", name, iou,
                   false_objects, undecidable, bits, rows);
  }
  report.result["tolerance_px"] = kTolerance_px;
  report.file("DECISION.md",
              page + left_one_set_out(report, all, noise, found, read.sets) + gates_text(scope.synthesised));
  report.table("decision.csv", csv);
}

}  // namespace horopter::cli
