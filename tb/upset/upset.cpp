// SPDX-License-Identifier: Apache-2.0
// Changes single bits of the machine's state, and counts what becomes of the alarm. scripts/upset runs this, and says how
// surely the figures hold.
//
//   upset --profile P --rule thesis|compete --scenario S --kind flip|stuck|memory --count N [--seed N] [--signals REGEX]
//
// Prints one JSON object in the end: what was seen, and how many bits were changed, for every register. Before it come the
// messages of the model's assertions.
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <regex>
#include <span>
#include <string>

#include "bench.hpp"
#include "horopter/base/crc32.hpp"
#include "horopter/hls/table_format.hpp"
#include "horopter/machine/setting_registers.hpp"
#include "profiles.hpp"
#include "stages/engine.hpp"

namespace horopter::upset {
namespace {

constexpr int kSkinShift_px = -5,
              kBehindShift_px = 7;  // source in the right image, of the object and of what is behind it
constexpr std::size_t kFrames = 7;
constexpr std::size_t kObjectComes = 3;
// Bits are changed while these frames arrive; the later ones show how long it lasts.
constexpr std::size_t kFirstUpset = 2, kAfterUpset = 4;

struct Options {
  std::string profile = "vga", rule = "thesis", scenario = "always", kind = "flip", signals;
  unsigned long count = 1000;
  std::uint64_t seed = 1;
};

enum class Object { always, comes };

struct ScenarioKind {
  const char* name;
  Object object;
  bool live;
  int noise_grey;  ///< largest, of each camera
  bool barely;     ///< the limit is just below what there is of it
  bool by_object;  ///< the alarm is that of the object alone, else that of the share of the image
  bool uploads;    ///< each frame has a table of its own, uploaded one frame earlier, beside the one in use
};
constexpr auto kScenarios = std::to_array<ScenarioKind>({
    {"always", Object::always, true, 0, false, false, false},
    {"comes", Object::comes, false, 0, false, false, false},
    {"barely", Object::comes, true, 0, true, false, false},
    {"noise", Object::comes, true, 4, false, true, false},
    {"uploads", Object::comes, true, 0, true, false, true},
});

void add_noise(tb::Image& image, int largest, tb::Rng& rng) {
  for (std::uint8_t& pixel : image.pixels) {
    pixel = static_cast<std::uint8_t>(std::clamp(pixel + static_cast<int>(rng.between(-largest, largest)), 1, 254));
  }
}

hls::table::Geometry geometry(const Scenario& scenario) {
  return {static_cast<int>(scenario.width), static_cast<int>(scenario.height), 4, 4};
}

std::vector<std::uint32_t> table(const Scenario& scenario) {
  auto words = hls::table::write(geometry(scenario), {}, [&](int column, int row) {
    return hls::table::encode_control((column << 4) + kSkinShift_px, row << 4);
  });
  words.back() = crc32_words(std::span(words).first(words.size() - 1));
  return words;
}

Scenario make_scenario(const ScenarioKind& kind, const Options& options, std::optional<std::uint32_t> alarm_limit) {
  Scenario scenario;
  scenario.live = kind.live;
  tb::Rng rng{options.seed};
  for (std::size_t frame = 0; frame < kFrames; ++frame) {
    tb::Image right = tb::textured_image(scenario.width, scenario.height, rng), left = right;
    for (unsigned y = 0; y < scenario.height; ++y) {
      for (unsigned x = 0; x < scenario.width; ++x) {
        const bool object =
            (kind.object == Object::always || frame >= kObjectComes) && x >= 30 && x < 74 && y >= 8 && y < 40;
        const int source = static_cast<int>(x) + (object ? kSkinShift_px : kBehindShift_px);
        left.at(x, y) = right.at(static_cast<unsigned>(std::clamp(source, 0, static_cast<int>(scenario.width) - 1)), y);
      }
    }
    if (kind.noise_grey != 0) {
      add_noise(left, kind.noise_grey, rng);
      add_noise(right, kind.noise_grey, rng);
    }
    scenario.left.push_back(left);
    scenario.right.push_back(right);
  }

  auto settings = native::Settings::defaults(native::make_engine(options.profile)->profile(),
                                             static_cast<int>(scenario.width), static_cast<int>(scenario.height))
                      .without_proof();  // too few cells for one
  settings.compete = options.rule == "compete" ? 1 : 0;
  const int never = static_cast<int>(scenario.width * scenario.height) + 1;
  settings.object_limit = kind.by_object ? 300 : never;
  if (kind.by_object) settings.alarm_limit = never;
  if (alarm_limit) settings.alarm_limit = static_cast<int>(*alarm_limit);
  auto& setup = scenario.setup;
  setup = {{reg::mode::kAddress, reg::mode::kLive.put(scenario.live ? 1 : 0)},
           {reg::interlock::kAddress, reg::interlock::kByItself.put(1)},
           {reg::width::kAddress, scenario.width},
           {reg::height::kAddress, scenario.height},
           {reg::lookahead::kAddress, 16},
           {reg::timeout::kAddress, 2 * scenario.period()}};
  write_settings(settings, [&](std::uint32_t address, std::uint32_t word) { setup.emplace_back(address, word); });
  const std::uint32_t words64 = static_cast<std::uint32_t>(geometry(scenario).control_words()) / 2;
  const auto upload = [&](std::uint32_t slot, auto put) {
    put(reg::map_slot::kAddress, slot);
    put(reg::map_base::kAddress, slot * words64);
    put(reg::map_control::kAddress, reg::map_control::kStart.put(1));
    for (const std::uint32_t word : table(scenario)) put(reg::map_data::kAddress, word);
  };
  upload(0, [&](std::uint32_t address, std::uint32_t word) { setup.emplace_back(address, word); });
  if (kind.uploads) {
    constexpr std::uint32_t kSlots = 3;
    constexpr int kReads = 20;  // after each write: so it takes most of a frame
    auto& meanwhile = scenario.meanwhile;
    const auto put = [&](std::uint32_t address, std::uint32_t word) {
      meanwhile.push_back({true, address, word});
      for (int i = 0; i < kReads; ++i) meanwhile.push_back({false, reg::map_valid::kAddress});
    };
    for (std::uint32_t slot = 0; slot < kSlots; ++slot) {
      put(reg::table_select::kAddress, slot);
      upload((slot + 1) % kSlots, put);
    }
    scenario.part = meanwhile.size() / kSlots;
  }
  setup.emplace_back(reg::table_select::kAddress, 0);
  setup.emplace_back(reg::control::kAddress, reg::control::kEnable.put(1));
  return scenario;
}

struct Counts {
  unsigned long injected = 0;
  unsigned long hides = 0;      ///< the alarm is missing in a frame, or the frame is
  unsigned long dangerous = 0;  ///< and the pins say safe
  unsigned long lasting = 0;    ///< in two frames or more
  unsigned long told = 0;       ///< a fault that the undisturbed run does not have, in a register
  unsigned long stays = 0;      ///< the last frame still has one
  unsigned long unsafe = 0;     ///< the pins say not safe where they need not
  unsigned long stopped = 0;    ///< frames are missing
};

void judge(const History& is, const History& should_be, Counts& counts) {
  unsigned hidden = 0, dangerous = 0;
  bool told = false, stays = false, unsafe = false;
  for (std::size_t k = kFirstUpset; k < should_be.count; ++k) {
    const Seen &a = is.frames[k], &b = should_be.frames[k];
    const bool came = k < is.count;
    if (b.alarm && (!came || !a.alarm)) {
      hidden += came ? 1 : 0;
      dangerous += a.safe ? 1 : 0;
    }
    stays = came && ((a.faults_cameras & ~b.faults_cameras) | (a.faults_machine & ~b.faults_machine)) != 0;
    told = told || stays;
    unsafe = unsafe || (b.safe && !a.safe);
  }
  ++counts.injected;
  counts.hides += hidden + dangerous > 0 ? 1 : 0;
  counts.dangerous += dangerous > 0 ? 1 : 0;
  counts.lasting += dangerous > 1 ? 1 : 0;
  counts.told += told ? 1 : 0;
  counts.stays += stays ? 1 : 0;
  counts.unsafe += unsafe ? 1 : 0;
  counts.stopped += is.count < should_be.count ? 1 : 0;
}

[[noreturn]] void fail(const std::string& why) {
  std::cerr << "upset: " << why << "\n";
  std::exit(2);
}

/// The scenario shows what it should, else the figures would mean nothing.
void check(const History& history, const ScenarioKind& kind) {
  for (std::size_t k = 0; k < history.count; ++k) {
    const Seen& seen = history.frames[k];
    const bool object = kind.object == Object::always || k >= kObjectComes;
    if (seen.alarm != object || (seen.faults_cameras | seen.faults_machine) != 0 || (object && seen.safe)) {
      fail("the undisturbed run is not as it should be: frame " + std::to_string(k) + ", alarm " +
           std::to_string(seen.alarm) + ", safe " + std::to_string(seen.safe) + ", skin " + std::to_string(seen.skin) +
           ", faults " + std::to_string(seen.faults_cameras) + " " + std::to_string(seen.faults_machine));
    }
  }
  if (history.count + 1 < kFrames) fail("only " + std::to_string(history.count) + " frames");
  if (kind.uploads && history.frames[kObjectComes].tables != 7) fail("the uploads do not succeed");
  if (kind.object == Object::comes && !history.frames[kObjectComes - 1].safe)
    fail("never safe before the object comes");
}

int run(const Options& options) {
  const auto kind = std::find_if(kScenarios.begin(), kScenarios.end(),
                                 [&](const ScenarioKind& k) { return options.scenario == k.name; });
  if (kind == kScenarios.end()) fail("no scenario " + options.scenario);
  const std::unique_ptr<Bench> bench = make_bench(options.profile, options.seed);
  if (!bench) fail("no profile " + options.profile);

  const auto first = [](const Scenario& s) { return kFirstUpset * std::uint64_t{s.period()}; };
  Scenario scenario = make_scenario(*kind, options, {});
  History should_be = bench->record(scenario, first(scenario));
  if (kind->barely) {
    std::uint32_t least = ~0U;
    for (std::size_t k = kObjectComes; k < should_be.count; ++k) least = std::min(least, should_be.frames[k].skin);
    if (least < 16) fail("nothing of the object is seen");
    scenario = make_scenario(*kind, options, least - least / 64 - 1);
    should_be = bench->record(scenario, first(scenario));
  }
  check(should_be, *kind);

  std::vector<const Signal*> signals;
  std::uint64_t bits = 0;
  const std::regex wanted{options.signals};
  for (const Signal& signal : bench->signals()) {
    if (signal.is_memory() != (options.kind == "memory")) continue;
    if (!options.signals.empty() && !std::regex_search(signal.name, wanted)) continue;
    signals.push_back(&signal);
    bits += signal.all_bits();
  }
  if (bits == 0) fail("no register or memory fits --signals " + options.signals);

  // As many as there are bits or more: each bit equally often, so that none is left out.
  tb::Rng rng{options.seed ^ 0x75707365};
  std::map<const Signal*, Counts> by_signal;
  for (unsigned long n = 0; n < options.count; ++n) {
    std::uint64_t at = options.count >= bits && n < options.count / bits * bits ? n % bits : rng.below(bits);
    auto signal = signals.begin();
    while (at >= (*signal)->all_bits()) at -= (*signal++)->all_bits();
    const std::uint64_t clock = first(scenario) + rng.below((kAfterUpset - kFirstUpset) * scenario.period());
    judge(bench->inject({*signal, at, clock, options.kind == "stuck"}), should_be, by_signal[*signal]);
  }

  std::printf(
      "{\"profile\": \"%s\", \"rule\": \"%s\", \"scenario\": \"%s\", \"kind\": \"%s\", \"seed\": %llu, \"bits\": %llu, \"signals\": [",
      options.profile.c_str(), options.rule.c_str(), options.scenario.c_str(), options.kind.c_str(),
      static_cast<unsigned long long>(options.seed), static_cast<unsigned long long>(bits));
  const char* comma = "";
  for (const Signal* signal : signals) {
    const Counts& c = by_signal[signal];
    std::printf(
        "%s\n{\"name\": \"%s\", \"module\": \"%s\", \"bits\": %llu, \"injected\": %lu, \"hides\": %lu, \"dangerous\": %lu, "
        "\"lasting\": %lu, \"told\": %lu, \"stays\": %lu, \"unsafe\": %lu, \"stopped\": %lu}",
        comma, signal->name, signal->module, static_cast<unsigned long long>(signal->all_bits()), c.injected, c.hides,
        c.dangerous, c.lasting, c.told, c.stays, c.unsafe, c.stopped);
    comma = ",";
  }
  std::printf("]}\n");
  return 0;
}

Options parse(int argc, char** argv) {
  Options options;
  const std::map<std::string, std::string*> texts{{"--profile", &options.profile},
                                                  {"--rule", &options.rule},
                                                  {"--scenario", &options.scenario},
                                                  {"--kind", &options.kind},
                                                  {"--signals", &options.signals}};
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i], value = argv[i + 1];
    if (const auto text = texts.find(name); text != texts.end())
      *text->second = value;
    else if (name == "--count")
      options.count = std::stoul(value);
    else if (name == "--seed")
      options.seed = std::stoull(value);
    else
      fail("unknown option " + name);
  }
  if (argc % 2 == 0) fail("every option has a value");
  return options;
}

}  // namespace
}  // namespace horopter::upset

int main(int argc, char** argv) {
  try {
    return horopter::upset::run(horopter::upset::parse(argc, argv));
  } catch (const std::exception& error) {
    std::cerr << "upset: " << error.what() << "\n";
    return 2;
  }
}
