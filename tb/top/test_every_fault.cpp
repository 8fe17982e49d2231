// SPDX-License-Identifier: Apache-2.0
// Every fault of registers.yaml, in every profile with each rule that it has: raised once, it is named in a frame's result,
// and safe_o, which was high before, is low. A fault that this file forgets fails it. And the test input.
#include <Vhoropter_machine_field.h>
#include <Vhoropter_machine_field___024root.h>
#include <Vhoropter_machine_hd.h>
#include <Vhoropter_machine_hd___024root.h>
#include <Vhoropter_machine_vga.h>
#include <Vhoropter_machine_vga___024root.h>

#include <algorithm>
#include <tuple>

#include "machine_bench.hpp"
#include "signal.hpp"
#include "stages/patches.hpp"

// What tb/upset lists of each model, and its way to compute all logic anew from the registers.
#define HOROPTER_TB_MACHINE(Name, model)                                            \
  std::vector<horopter::upset::Signal> signals_##model(V##model##___024root& root); \
  void V##model##___024root___eval_settle(V##model##___024root* root);              \
  struct Name {                                                                     \
    using Model = V##model;                                                         \
    static auto signals(Model& m) { return signals_##model(*m.rootp); }             \
    static void settle(Model& m) { V##model##___024root___eval_settle(m.rootp); }   \
  }
HOROPTER_TB_MACHINE(FieldMachine, horopter_machine_field);
HOROPTER_TB_MACHINE(VgaMachine, horopter_machine_vga);
HOROPTER_TB_MACHINE(HdMachine, horopter_machine_hd);

namespace horopter::tb {
namespace {

struct FieldThesis : FieldMachine {
  static constexpr std::string_view kProfile = "field";
  static constexpr bool kCompete = false;
};
struct VgaThesis : VgaMachine {
  static constexpr std::string_view kProfile = "vga";
  static constexpr bool kCompete = false;
};
struct VgaCompete : VgaThesis {
  static constexpr bool kCompete = true;
};
struct HdThesis : HdMachine {
  static constexpr std::string_view kProfile = "hd";
  static constexpr bool kCompete = false;
};
struct HdCompete : HdThesis {
  static constexpr bool kCompete = true;
};

constexpr unsigned kWidth = 64, kHeight = 32, kLookahead = 16;
constexpr unsigned kTimeout = 15'000;
constexpr int kShift = -5;

/// The only register or memory of that name, whatever instances are before it.
template <class Build>
upset::Signal find(typename Build::Model& model, const std::string& name) {
  std::vector<upset::Signal> found;
  for (const upset::Signal& signal : Build::signals(model)) {
    if (("." + std::string(signal.name)).ends_with("." + name)) found.push_back(signal);
  }
  CAPTURE(name);
  REQUIRE(found.size() == 1);
  return found.front();
}

/// A bit of a word of the memory whose name begins so.
template <class Build>
void flip_in_memory(typename Build::Model& model, const std::string& begin, unsigned word, unsigned bit) {
  const auto signals = Build::signals(model);
  const auto memory = std::ranges::find_if(signals, [&](const upset::Signal& signal) {
    return signal.is_memory() && std::string_view(signal.name).starts_with(begin);
  });
  REQUIRE(memory != signals.end());
  memory->flip(std::uint64_t{word} * memory->bits + bit);
  Build::settle(model);
}

template <class Build>
class Bench {
 public:
  explicit Bench(const MachineOptions& options) : Bench{options, plane_table(options.width, options.height, kShift)} {}
  Bench(const MachineOptions& options, std::vector<std::uint32_t> words)
      : machine{Build::kProfile, options}, table{std::move(words)} {
    auto& settings = machine.settings();
    settings.compete = Build::kCompete ? 1 : 0;
    settings.alarm_limit = static_cast<int>(options.width * options.height);  // only faults are looked at here
    settings.frozen_limit = 1;
    machine.write_limits();
    CHECK(machine.read(reg::decision::kAddress) == (Build::kCompete ? 1 : 0));
    machine.upload(0, 0, table);
    CHECK(machine.upload_error() == 0);
    machine.select(0);
  }
  virtual ~Bench() = default;

  virtual FramePair scene() { return random_pair(machine.options().width, machine.options().height, kShift, rng); }
  void send_scene(Damage left = {}, Damage right = {}) { machine.send(scene(), left, right); }

  /// Begins anew: broken frames leave a doubt.
  void restart() {
    machine.write(reg::control::kAddress, 0);
    machine.left().reset();
    machine.right().reset();
    machine.settle(100);
    machine.forget();
    machine.write(reg::control::kAddress, reg::control::kEnable.put(1));
    machine.select(0);
  }
  void until_safe() {
    Published p;
    for (int frame = 0; frame < 4 && !p.safe_pin; ++frame) {
      send_scene();
      p = machine.receive();
    }
    CAPTURE(p.fault_names());
    REQUIRE(p.safe_pin);
    REQUIRE(machine.model().safe_o == 1);
  }

  /// `cause` sends some frames. One of their results has the fault and is not safe, and an interrupt tells of it.
  void raise(const std::string& fault, const std::function<void()>& cause) {
    CAPTURE(Build::kProfile, Build::kCompete, fault);
    if (begin_anew) restart();
    until_safe();
    machine.write(reg::irq_status::kAddress, reg::irq_status::kFault.put(1));
    cause();
    expect(fault);
    CHECK(reg::irq_status::kFault.get(machine.read(reg::irq_status::kAddress)) == 1);
  }
  void expect(const std::string& fault) {
    std::string others;
    try {
      for (int frame = 0; frame < 8; ++frame) {
        if (next_has(fault, others)) return;
      }
    } catch (const Timeout&) {  // no more frames come
    }
    FAIL_CHECK("no frame has it, but " << others);
  }
  /// The next result has the fault, and is not safe. What it has instead joins `others`.
  bool next_has(const std::string& fault, std::string& others) {
    const Published p = machine.receive();
    for (const std::string& name : p.fault_names()) others += name + " ";
    others += "| ";
    if (!p.fault_names().contains(fault)) return false;
    CHECK_FALSE(p.safe());
    CHECK_FALSE(p.safe_pin);
    raised.insert(fault);
    return true;
  }

  /// The first bit of every word of the memory `name`.
  void flip(const std::string& name) {
    for (const upset::Signal& signal : Build::signals(machine.model())) {
      if (!std::string_view(signal.name).starts_with(name + ".") && signal.name != name + "_mem") continue;
      for (unsigned word = 0; word < signal.words; ++word) signal.flip(std::uint64_t{word} * signal.bits);
    }
    Build::settle(machine.model());
  }
  /// The words of the memory `name` whose parity is wrong have it right again.
  void mend(const std::string& name) {
    for (const upset::Signal& signal : Build::signals(machine.model())) {
      if (signal.name != name + "_mem") continue;
      for (unsigned word = 0; word < signal.words; ++word) {
        const std::uint64_t begin = std::uint64_t{word} * signal.bits;
        bool odd = false;
        for (unsigned bit = 0; bit < signal.bits; ++bit) odd ^= signal.get(begin + bit);
        if (odd) signal.flip(begin);
      }
    }
    Build::settle(machine.model());
  }

  Rng rng{"every fault"};
  Machine<typename Build::Model> machine;
  std::vector<std::uint32_t> table;
  std::set<std::string> raised;
  bool begin_anew = true;  ///< before every fault
};

/// Of a scene whose depth both cameras see: places as wide as a cell of the check that clear is earned.
template <class Build>
class SceneBench final : public Bench<Build> {
 public:
  explicit SceneBench(const hls::Profile& profile)
      : SceneBench{profile, {28 * wide(profile), 13 * tall(profile), kLookahead, false, 8 * kTimeout}} {}

  FramePair scene() override { return {view(0, 0), view(on_skin ? 0 : 2, 0)}; }
  bool on_skin = false;
  [[nodiscard]] unsigned cell_px() const { return wide_; }
  /// The scene displaced by so many cells.
  Image view(int across, int down) {
    Image image{this->machine.options().width, this->machine.options().height};
    for (unsigned y = 0; y < image.height; ++y) {
      for (unsigned x = 0; x < image.width; ++x) {
        const auto column = static_cast<std::size_t>(static_cast<int>(x / wide_) + across + 8);
        const auto row = static_cast<std::size_t>(static_cast<int>(y / tall_) + down + 8);
        image.at(x, y) = static_cast<std::uint8_t>(places_[row * 40 + column] + this->rng.below(3));
      }
    }
    return image;
  }

 private:
  SceneBench(const hls::Profile& profile, const MachineOptions& options)
      : Bench<Build>{options, make_table(options.width, options.height, 4, 4,
                                         [](double x, double y) { return std::pair{x, y}; })},
        wide_{wide(profile)},
        tall_{tall(profile)} {
    for (std::uint8_t& value : places_) value = static_cast<std::uint8_t>(this->rng.below(250));
    auto& machine = this->machine;
    auto& settings = machine.settings();
    const native::Settings usual{};
    settings.prove = 1;
    settings.nearer_above = 1;
    settings.hidden_frames = 2;
    settings.patch_limit = horopter::stages::patch_limit_never;  // images so small have no places for it
    settings.blind_share = usual.blind_share;
    settings.one_camera_segments = usual.one_camera_segments;
    machine.configure();
    machine.write_limits();
  }
  static unsigned wide(const hls::Profile& profile) {
    return static_cast<unsigned>(profile.cell() * profile.subsample);
  }
  static unsigned tall(const hls::Profile& profile) { return static_cast<unsigned>(profile.cell()); }
  unsigned wide_, tall_;
  std::vector<std::uint8_t> places_ = std::vector<std::uint8_t>(40 * 40);
};

Image fog(Image image, int contrast_divided_by, unsigned noise, Rng& rng) {
  for (std::uint8_t& pixel : image.pixels) {
    pixel = static_cast<std::uint8_t>(112 + pixel / contrast_divided_by + static_cast<int>(rng.below(noise)));
  }
  return image;
}

/// What a frame with gaps and broken lines, other images, tables and memories raises.
template <class Build>
std::set<std::string> faults_of_small_frames() {
  Bench<Build> bench{{kWidth, kHeight, kLookahead, false, kTimeout}};
  auto& machine = bench.machine;
  using Kind = Damage::Kind;
  for (const std::string side : {"left", "right"}) {
    const bool left = side == "left";
    for (const auto& [name, damage] : {std::pair{"_short_line", Damage{Kind::short_line, 20, 3}},
                                       std::pair{"_long_line", Damage{Kind::long_line, 20, 2}},
                                       std::pair{"_missing_line", Damage{Kind::missing_line, 20, 1}},
                                       std::pair{"_missing_start", Damage{Kind::missing_start}}}) {
      bench.raise(side + name, [&] {
        bench.send_scene(left ? damage : Damage{}, left ? Damage{} : damage);
        if (damage.kind != Kind::missing_start) bench.send_scene();
      });
    }
    bench.raise(side + "_silent", [&] {
      const FramePair pair = bench.scene();
      left ? machine.right().send(pair.right) : machine.left().send(pair.left);
    });
    for (const auto& empty : {std::pair{"_black", 1}, std::pair{"_white", 254}, std::pair{"_constant", 120}}) {
      const int grey = empty.second;
      bench.raise(side + empty.first, [&, grey] {
        FramePair pair = bench.scene();
        for (std::uint8_t& pixel : (left ? pair.left : pair.right).pixels)
          pixel = static_cast<std::uint8_t>(grey + static_cast<int>(bench.rng.below(2)));
        machine.send(pair);
      });
    }
    bench.raise(side + "_frozen", [&] {
      const FramePair first = bench.scene();
      FramePair second = bench.scene();
      (left ? second.left : second.right) = left ? first.left : first.right;
      machine.send(first);
      machine.send(second);
    });
    bench.raise(side + "_torn", [&] {
      FramePair pair = bench.scene();
      std::vector<std::uint8_t>& pixels = (left ? pair.left : pair.right).pixels;
      for (std::size_t i = kWidth; i < pixels.size(); ++i) pixels[i] = pixels[i - kWidth] ^ 0x80U;
      machine.send(pair);
    });
  }
  bench.raise("skew", [&] {
    bench.send_scene({Kind::short_line, 20, 3});
    bench.send_scene();
  });
  bench.raise("store_miss", [&] {  // 24 rows below the output row, but only LOOKAHEAD = 16 rows have arrived
    machine.upload(1, 500, plane_table(kWidth, kHeight, 0, 24));
    machine.select(1);
    bench.send_scene();
  });
  bench.raise("no_table", [&] {
    machine.select(15);
    bench.send_scene();
  });
  bench.raise("map_crc", [&] {
    auto words = bench.table;
    words[7] ^= 1U << 9;
    machine.upload(4, 600, words);
    bench.send_scene();
  });
  bench.raise("map_busy", [&] {
    machine.upload(0, 0, bench.table);
    bench.send_scene();
  });
  const native::Settings usual = machine.settings();
  for (const bool undecidable : {true, false}) {
    bench.raise(undecidable ? "too_undecidable" : "too_unsupervised", [&] {
      (undecidable ? machine.settings().undecidable_limit : machine.settings().unsupervised_limit) = 5;
      machine.write_limits();
      machine.upload(1, 500, bench.table);  // with the limit of undecidable pixels
      machine.select(1);
      FramePair pair = bench.scene();
      for (unsigned pixel = 0; undecidable && pixel < kWidth * kHeight / 2; ++pixel) {
        pair.left.pixels[pixel] = pair.right.pixels[pixel] = static_cast<std::uint8_t>(120 + bench.rng.below(2));
      }
      machine.send(pair);
    });
    machine.settings() = usual;
    machine.write_limits();
  }
  bench.raise("identical_images", [&] {
    FramePair pair = bench.scene();
    pair.right = pair.left;
    machine.send(pair);
  });
  bench.raise("restart", [&] {  // held for as many frames as count; that they do: test_interlock.cpp
    machine.model().restart_i = 1;
    machine.settle(10);
    const upset::Signal held = find<Build>(machine.model(), "u_interlock.held_frames_q");
    for (unsigned bit = 0; bit < held.bits; ++bit) held.flip(bit);
    Build::settle(machine.model());
    bench.send_scene();
  });
  machine.model().restart_i = 0;
  bench.raise("settings", [&] {
    find<Build>(machine.model(), "u_csr.alarm_limit_pixels_q").flip(20);
    Build::settle(machine.model());
    bench.send_scene();
  });
  machine.write_limits();
  const auto supervise_contactors = [&](std::uint32_t clocks) {
    machine.write(reg::control::kAddress, 0);
    machine.write(reg::feedback::kAddress, clocks);
    machine.write(reg::control::kAddress, reg::control::kEnable.put(1));
  };
  supervise_contactors(300);
  bench.raise("contactors", [&] {
    machine.set_contactors(decltype(bench.machine)::Contactors::stay_dropped, 0);
    bench.send_scene();
  });
  machine.set_contactors(decltype(bench.machine)::Contactors::follow, 0);
  supervise_contactors(0);
  bench.raise("teaching", [&] {
    machine.settings().teach = 1;
    machine.write_limits();
    bench.send_scene();
  });
  machine.settings().teach = 0;
  machine.write_limits();
  bench.raise("objects",
              [&] {  // places of runs are taken that are not: what does not fit by itself: tests/unit/objects.cpp
                bench.send_scene();
                for (unsigned i = 0; i < 60; ++i) {
                  machine.simulation().run(101);
                  for (const upset::Signal& signal : Build::signals(machine.model())) {
                    const std::string_view name = signal.name;
                    if (name.starts_with("u_object_check.u_objects.entries_") && name.ends_with("_there_q"))
                      signal.flip(0);
                  }
                  Build::settle(machine.model());
                }
              });

  bench.restart();
  bench.until_safe();
  machine.settle(2 * kTimeout);
  CHECK(machine.model().safe_o == 0);
  // That no frame comes is not a frame's fault.
  if (horopter::Faults(0, machine.read(reg::faults_machine::kAddress)).has(Fault::late)) bench.raised.insert("late");
  return bench.raised;
}

template <class Build>
std::set<std::string> overflows() {
  Bench<Build> bench{{kWidth, kHeight, kLookahead, true, 8 * kTimeout}};
  for (const std::string side : {"left", "right"}) {
    bench.raise(side + "_overflow", [&] {
      bench.machine.states().set_pace(Pace::periodic(0, 1));
      for (int frame = 0; frame < 6; ++frame) bench.send_scene();
      bench.machine.settle(6 * kWidth * kHeight);
      bench.machine.states().set_pace({});
    });
  }
  return bench.raised;
}

/// With another table the right image is another one, and the left one is not: nothing has moved.
template <class Build>
void check_that_another_table_is_no_motion(SceneBench<Build>& bench) {
  auto& machine = bench.machine;
  const auto [width, height, cell] = std::tuple{machine.options().width, machine.options().height, bench.cell_px()};
  machine.upload(1, 500,
                 make_table(width, height, 4, 4, [=](double x, double y) { return std::pair{x + 2 * cell, y}; }));
  bench.restart();
  bench.until_safe();
  machine.select(1);
  for (int frame = 0; frame < 2; ++frame) {
    bench.send_scene();
    CHECK_FALSE(machine.receive().fault_names().contains("out_of_step"));
  }
}

/// Two tables take turns. A field is compared with the one before that has its table; a whole image is not.
template <class Build>
void check_tables_in_turn(SceneBench<Build>& bench) {
  auto& machine = bench.machine;
  const bool fields = machine.profile().takes_fields();
  bench.restart();
  machine.upload(1, 500, bench.table);
  CHECK(machine.upload_error() == 0);
  unsigned slot = 1;
  const auto* words = &bench.table;
  const auto is_out_of_step = [&](int right) {
    slot ^= 1U;
    machine.select(slot);
    machine.send({bench.view(0, 0), bench.view(right, 0)});
    const Published p = machine.receive();
    CHECK(p.table_crc == words->back());
    return p.fault_names().contains("out_of_step");
  };
  for (int frame = 0; frame < 4; ++frame) CHECK_FALSE(is_out_of_step(2));
  for (int frame = 0; frame < 3; ++frame) CHECK(is_out_of_step(4) == fields);

  // Each slot is written anew while the other one is in use: a skin that moves.
  bench.restart();
  for (int frame = 0; frame < 4; ++frame) CHECK_FALSE(is_out_of_step(2));
  const auto [width, height, cell] = std::tuple{machine.options().width, machine.options().height, bench.cell_px()};
  const auto moved = make_table(width, height, 4, 4, [=](double x, double y) { return std::pair{x + 2 * cell, y}; });
  words = &moved;
  for (int frame = 0; frame < 2; ++frame) {
    const unsigned other = slot ^ 1U;
    machine.upload(other, 500 * other, moved);
    CHECK(machine.upload_error() == 0);
    CHECK_FALSE(is_out_of_step(2));
  }
  machine.write(reg::control::kAddress, 0);
  machine.upload(0, 0, bench.table);
}

/// What only a scene tells: whether both cameras see it, and from where.
template <class Build>
std::set<std::string> faults_of_scenes() {
  SceneBench<Build> bench{native::make_engine(Build::kProfile)->profile()};
  auto& machine = bench.machine;
  bench.begin_anew = false;
  bench.send_scene();
  bench.expect("unproven");
  for (const std::string side : {"left", "right"}) {
    for (const auto& fault : {std::tuple{"_blind", 32, 20U}, {"_unsharp", 16, 1U}}) {
      const int thick = std::get<1>(fault);
      const unsigned noise = std::get<2>(fault);
      bench.raise(side + std::get<0>(fault), [&, thick, noise] {
        FramePair pair = bench.scene();
        Image& image = side == "left" ? pair.left : pair.right;
        image = fog(image, thick, noise, bench.rng);
        machine.send(pair);
      });
    }
  }
  // What moves in one image alone leaves a doubt, until a motion begins in both.
  bench.begin_anew = true;
  bench.raise("one_camera", [&] { machine.send({bench.view(0, 0), bench.view(0, 0)}); });
  bench.raise("disagree", [&] {
    FramePair pair = bench.scene();
    std::ranges::reverse(pair.right.pixels);
    machine.send(pair);
  });
  bench.raise("out_of_step", [&] { machine.send({bench.view(0, 0), bench.view(4, 0)}); });
  check_that_another_table_is_no_motion(bench);
  check_tables_in_turn(bench);
  bench.raise("moved", [&] { machine.send({bench.view(0, 0), bench.view(2, -1)}); });
  bench.raise("hidden", [&] {
    for (int frame = 0; frame < 3; ++frame) machine.send({bench.view(0, 0), bench.view(-2, 0)});
  });
  // That rounds say so: tests/unit/agreement.cpp. Images so small have few places for it, and no round is complete soon
  // after a start.
  const auto flip_overlooked = [&] {
    find<Build>(machine.model(), "u_agreement.patches_overlooked_q").flip(0);
    Build::settle(machine.model());
  };
  bench.raise("overlooked", [&] {
    flip_overlooked();
    bench.send_scene();
  });
  // A frame with an alarm has said it; one whose alarm does not count has not.
  bench.on_skin = true;
  machine.settings().on_skin_cells = 255;
  machine.settings().one_camera_segments = 0;  // both see the same but for noise
  machine.settings().sum_limit *= 4;           // which makes no holes
  machine.settings().texture_limit = 0;
  const int never = machine.settings().alarm_limit;
  for (const std::uint32_t needed : {1U, 2U}) {
    machine.alarm_frames = reg::alarm_frames::kNeeded.put(needed) | reg::alarm_frames::kOf.put(3);
    machine.write(reg::control::kAddress, 0);
    machine.configure();
    machine.write_limits();
    const auto after_alarm = [&] {
      machine.settings().alarm_limit = 5;
      machine.write_limits();
      bench.send_scene();
      const Published p = machine.receive();
      CHECK(reg::frame_status::kSeen.get(p.status) == 1);
      CHECK(p.alarm() == (needed == 1));
      machine.settings().alarm_limit = never;
      machine.write_limits();
      flip_overlooked();
      bench.send_scene();
    };
    if (needed == 2) {
      bench.raise("overlooked", after_alarm);
      bench.raise("overlooked", [&] {
        machine.settings().alarm_limit = 5;
        machine.write_limits();
        flip_overlooked();
        bench.send_scene();
      });
    } else {
      bench.restart();
      bench.until_safe();
      after_alarm();
      CHECK_FALSE(machine.receive().fault_names().contains("overlooked"));
    }
  }
  return bench.raised;
}

/// Changes the lowest bit of a register in the first clock in which another one, or it itself, is 1.
template <class Build>
class Upset final : public Endpoint {
 public:
  Upset(typename Build::Model& model, const std::string& name, const std::string& when)
      : model_{model}, signal_{find<Build>(model, name)}, when_{find<Build>(model, when)} {}
  void arm() { armed_ = true; }
  bool has_been() const { return !armed_; }
  void drive() override {
    if (!armed_ || !when_.get(0)) return;
    armed_ = false;
    signal_.flip(0);
    Build::settle(model_);
  }
  void sample() override {}

 private:
  typename Build::Model& model_;
  upset::Signal signal_, when_;
  bool armed_ = false;
};

/// A scene before the skin: what it hides counts as undecidable against 19/16 of the limit, to the pixel.
template <class Build>
void check_that_little_is_decided() {
  SceneBench<Build> bench{native::make_engine(Build::kProfile)->profile()};
  auto& machine = bench.machine;
  machine.settings().hidden_frames = 100;
  machine.configure();
  const FramePair nearer{bench.view(0, 0), bench.view(-2, 0)};
  const auto result = [&] {
    Published p;
    for (int frame = 0; frame < 3; ++frame) {
      machine.send(nearer);
      p = machine.receive();
    }
    return p;
  };
  const auto undecidable = static_cast<int>(result().undecidable);
  const auto unearned = machine.read(reg::frame_hidden::kAddress) + machine.read(reg::frame_unproven_pixels::kAddress);
  int enough = 1;  // the smallest limit
  while (enough + enough / 8 + enough / 16 < undecidable) ++enough;
  CAPTURE(Build::kProfile, Build::kCompete, undecidable, unearned, enough);
  // The limit of what is neither hidden nor unproven.
  REQUIRE(undecidable - static_cast<int>(unearned) < enough - 1);
  for (const int limit : {enough - 1, enough}) {
    CAPTURE(limit);
    machine.settings().undecidable_limit = limit;
    machine.write_limits();
    machine.upload(1, static_cast<unsigned>(bench.table.size() / 2 + 1), bench.table);
    CHECK(machine.upload_error() == 0);
    machine.select(1);
    const Published p = result();
    CAPTURE(p.fault_names());
    CHECK(static_cast<int>(p.undecidable) == undecidable);
    CHECK(p.fault_names().contains("too_undecidable") == (limit < enough));
    if (limit == enough) {  // an upset makes the count jump over it
      machine.send(nearer);
      const std::size_t some = std::size_t{machine.options().width} * machine.options().height / 4;
      machine.simulation().run_until([&] { return machine.states().beats().size() > some; }, 1'000'000, "some states");
      const upset::Signal count = find<Build>(machine.model(), "undecidable_pixels");
      count.flip(count.bits - 1);
      Build::settle(machine.model());
      CHECK(machine.receive().fault_names().contains("too_undecidable"));
    }
    machine.select(0);
    result();
  }
}

/// The memories with parity of the stages of the rule that runs: hlsc --ram-parity writes them with a word for the bit.
template <class Build>
std::set<std::string> memories_of_stages(typename Build::Model& model) {
  constexpr std::string_view kOfMemory = "_mem", kOfWord = "_word_q";
  constexpr hls::Rule kRule = Build::kCompete ? hls::Rule::compete : hls::Rule::thesis;
  std::set<std::string> memories, with_parity;
  for (const upset::Signal& signal : Build::signals(model)) {
    const std::string_view name = signal.name;
    if (!name.starts_with("u_stages.")) continue;
    bool used = true;
#define HOROPTER_STAGE(stage, Class, rule, place) \
  used = used && (name.find(".g_" #stage ".") == name.npos || hls::Rule::rule == kRule);
#include "stages/stage_list.def"
    if (!used) continue;
    if (name.ends_with(kOfMemory)) memories.emplace(name.substr(0, name.size() - kOfMemory.size()));
    if (name.ends_with(kOfWord)) with_parity.emplace(name.substr(0, name.size() - kOfWord.size()));
  }
  CHECK(memories.size() >= 10);
  CHECK((with_parity.empty() || with_parity == memories));
  return with_parity;
}

/// A bit of each of them falls over again and again: a word may be read only shortly after it was written.
template <class Build>
std::set<std::string> faults_of_stages() {
  SceneBench<Build> bench{native::make_engine(Build::kProfile)->profile()};
  auto& machine = bench.machine;
  bench.until_safe();
  for (const std::string& memory : memories_of_stages<Build>(machine.model())) {
    CAPTURE(Build::kProfile, Build::kCompete, memory);
    // Not every frame has a second place in each band to compare.
    const int frames = memory.find("patches_") != memory.npos ? 16 : 1;
    bool found = false;
    std::string others;
    for (int frame = 0; frame < frames && !found; ++frame) {
      bench.send_scene();
      for (unsigned i = 0; i < 200; ++i) {
        machine.simulation().run(101);
        bench.flip(memory);
      }
      found = bench.next_has("internal", others);
    }
    CAPTURE(others);
    CHECK(found);
    bench.mend(memory);
    bool still = true;
    for (int frame = 0; still && frame < 3; ++frame) {
      bench.send_scene();
      still = machine.receive().fault_names().contains("internal");
    }
    CHECK_FALSE(still);
  }
  return bench.raised;
}

/// A bit of every memory of the stores falls over while a frame leaves, or before it.
template <class Build>
std::set<std::string> faults_of_memories() {
  Rng rng{"areas"};
  const hls::Profile profile = native::make_engine(Build::kProfile)->profile();
  Bench<Build> bench{{kWidth, kHeight, kLookahead, false, kTimeout},
                     with_areas(plane_table(kWidth, kHeight, kShift), profile, rng)};
  auto& machine = bench.machine;
  // Every memory of the stores has parity.
  std::set<std::string> memories;
  for (const upset::Signal& signal : Build::signals(machine.model())) {
    const std::string name = signal.name;
    const bool of_stores = name.find("_store.") != std::string::npos || name.starts_with("u_areas.");
    if (std::string_view(signal.module) != "ram_bank" || !of_stores) continue;
    memories.insert(name.substr(0, std::min(name.find(".g_one."), name.find(".g_banks."))));
  }
  CHECK(memories.size() == 4 + 1 + 6 + 1);
  for (const std::string& memory : memories) {
    CAPTURE(memory);
    const bool left = memory.starts_with("u_left_store."), right = memory.starts_with("u_image_store.");
    const bool while_it_leaves = left || right || memory.starts_with("u_areas.");  // written anew for every frame
    const bool extent = memory == "u_map_store.u_extent";  // of what is uploaded: read when another table is
    bench.raise(left     ? "left_parity"
                : right  ? "right_parity"
                : extent ? "map_busy"
                         : "internal",
                [&] {
                  if (while_it_leaves) {
                    bench.send_scene();
                    machine.simulation().run_until(
                        [&] { return machine.states().beats().size() > kWidth * kHeight / 4; }, 100'000, "some states");
                  }
                  bench.flip(memory);
                  if (extent) machine.upload(3, 700, bench.table);
                  if (!while_it_leaves) bench.send_scene();
                });
    if (!while_it_leaves) bench.flip(memory);  // as it was
    machine.write(reg::control::kAddress, 0);
    machine.upload(0, 0, bench.table);
  }
  return bench.raised;
}

TEMPLATE_TEST_CASE("every fault is named, and not safe", "[faults][every]", FieldThesis, VgaThesis, VgaCompete,
                   HdThesis, HdCompete) {
  std::set<std::string> raised = faults_of_small_frames<TestType>();
  raised.merge(overflows<TestType>());
  raised.merge(faults_of_scenes<TestType>());
  check_that_little_is_decided<TestType>();
  raised.merge(faults_of_memories<TestType>());
  raised.merge(faults_of_stages<TestType>());
  for (const auto& [fault, name] : registers::kFaults) {
    CAPTURE(TestType::kProfile, TestType::kCompete, name);
    CHECK(raised.contains(std::string(name)));
  }
}

TEMPLATE_TEST_CASE(
    "a bit of a row's span, or of an area, falls over in the pool: named, not safe, and over when it is back",
    "[faults][every]", FieldThesis, VgaThesis, HdThesis) {
  Rng rng{"spans"};
  const hls::Profile profile = native::make_engine(TestType::kProfile)->profile();
  const auto table = with_areas(with_spans(plane_table(kWidth, kHeight, kShift), rng), profile, rng);
  Bench<TestType> bench{{kWidth, kHeight, kLookahead, false, kTimeout}, table};
  const auto areas = static_cast<unsigned>(hls::table::Facts::words_of(hls::table::read(table).facts.areas.size()));
  const unsigned spans = (areas + 1) / 2 * 2;  // words of the pool before them
  REQUIRE(areas > 0);
  for (const unsigned word : {0U, areas - 1, spans, spans + 7, spans + 30, spans + 31}) {
    const auto flip = [&] {
      const std::string bank = word % 2 == 0 ? "u_map_store.u_even." : "u_map_store.u_odd.";
      flip_in_memory<TestType>(bench.machine.model(), bank, word / 2, 18);  // of a span's end; the table begins at 0
    };
    CAPTURE(TestType::kProfile, word);
    bench.raise("internal", [&] {
      flip();
      bench.send_scene();
    });
    flip();
    bench.restart();
    bench.until_safe();
  }
}

TEMPLATE_TEST_CASE("the entry that is looked up is judged, not that of the next upload's slot", "[faults][every]",
                   FieldThesis, VgaThesis, HdThesis) {
  Bench<TestType> bench{{kWidth, kHeight, kLookahead, false, kTimeout}};
  auto& machine = bench.machine;
  constexpr unsigned kSelected = 0, kOther = 5;
  const auto flip_entry = [&](unsigned slot) {
    flip_in_memory<TestType>(machine.model(), "u_map_store.u_entry.", slot, 18);
  };
  machine.write(reg::map_slot::kAddress, kOther);
  bench.until_safe();
  flip_entry(kOther);
  bench.send_scene();
  CHECK_FALSE(machine.receive().fault_names().contains("internal"));
  flip_entry(kOther);
  bench.raise("internal", [&] {
    flip_entry(kSelected);
    bench.send_scene();
  });
}

TEMPLATE_TEST_CASE("a write is stored when it is answered as done, and only then, whatever an upset makes of it",
                   "[faults][every]", FieldThesis, VgaThesis, HdThesis) {
  Bench<TestType> bench{{kWidth, kHeight, kLookahead, false, kTimeout}};
  auto& machine = bench.machine;
  Upset<TestType> upset{machine.model(), "u_csr.write_q", "u_csr.taken_q"};
  machine.simulation().attach(upset);
  for (const auto& [address, locked] : {std::pair{reg::alarm_limit::kAddress, false}, {reg::width::kAddress, true}}) {
    for (const bool disturbed : {false, true}) {
      CAPTURE(TestType::kProfile, address, disturbed);
      const std::uint32_t value = machine.read(address) ^ 1U;
      if (disturbed) upset.arm();
      const bool done = machine.try_write(address, value);
      CHECK(upset.has_been());
      CHECK(done == (locked == disturbed));
      machine.settle(10);
      CHECK((machine.read(address) == value) == done);
    }
  }
}

TEMPLATE_TEST_CASE("an upset does not make a table valid again of which an upload has overwritten a part",
                   "[faults][every]", FieldThesis, VgaThesis, HdThesis) {
  Bench<TestType> bench{{kWidth, kHeight, kLookahead, false, kTimeout}};
  auto& machine = bench.machine;
  const auto base = static_cast<unsigned>(bench.table.size());
  machine.upload(2, base, bench.table);
  machine.select(2);
  bench.until_safe();
  Upset<TestType> upset{machine.model(), "u_map_store.replaces_q", "u_map_store.replaces_q"};
  machine.simulation().attach(upset);
  upset.arm();
  machine.upload_part(1, 0, bench.table, 0, bench.table.size() - 1);
  CHECK(upset.has_been());
  CHECK(machine.read(reg::map_valid::kAddress) == 1U << 2);
}

TEMPLATE_TEST_CASE("no table is none, whatever an upset makes of an upload to no slot", "[faults][every]", FieldThesis,
                   VgaThesis, HdThesis) {
  Bench<TestType> bench{{kWidth, kHeight, kLookahead, false, kTimeout}};
  auto& machine = bench.machine;
  constexpr unsigned kNoSlot = 15;
  Upset<TestType> upset{machine.model(), "u_map_store.no_slot_q", "u_map_store.start_q"};
  machine.simulation().attach(upset);
  upset.arm();
  machine.upload(kNoSlot, static_cast<unsigned>(bench.table.size()), bench.table);
  CHECK(upset.has_been());
  bench.raise("no_table", [&] {
    machine.select(kNoSlot);
    bench.send_scene();
  });
}

TEMPLATE_TEST_CASE("an upset of an upload's slot puts its table in the place of no other", "[faults][every]",
                   FieldThesis, VgaThesis, HdThesis) {
  Bench<TestType> bench{{kWidth, kHeight, kLookahead, false, kTimeout}};
  auto& machine = bench.machine;
  constexpr unsigned kInUse = 2, kUploaded = 3, kWrongCrc = 4;
  machine.upload(kInUse, static_cast<unsigned>(bench.table.size()), bench.table);
  machine.select(kInUse);
  bench.until_safe();
  const auto other = plane_table(kWidth, kHeight, kShift + 4);
  const std::size_t half = other.size() / 2;
  machine.upload_part(kUploaded, 0, other, 0, half);
  find<TestType>(machine.model(), "u_map_store.slot_q").flip(0);
  TestType::settle(machine.model());
  machine.upload_part(kUploaded, 0, other, half, other.size());
  CHECK(machine.upload_error() == kWrongCrc);
  CHECK(machine.read(reg::map_valid::kAddress) == 1U << kInUse);
  machine.write(reg::map_slot::kAddress, kInUse);
  machine.settle(10);
  CHECK(machine.read(reg::map_crc::kAddress) == bench.table.back());
}

TEMPLATE_TEST_CASE("an upset of a word behind its CRC is told by the frames that read it", "[faults][every]",
                   FieldThesis, VgaThesis, HdThesis) {
  Bench<TestType> bench{{kWidth, kHeight, kLookahead, false, kTimeout}};
  auto& machine = bench.machine;
  constexpr unsigned kSlot = 9;
  const auto base = static_cast<unsigned>(bench.table.size());
  Upset<TestType> upset{machine.model(), "u_map_store.data", "u_map_store.take"};
  machine.simulation().attach(upset);
  for (const bool disturbed : {false, true}) {
    CAPTURE(TestType::kProfile, disturbed);
    machine.select(0);
    bench.until_safe();
    const std::size_t half = bench.table.size() / 2;
    machine.upload_part(kSlot, base, bench.table, 0, half);
    if (disturbed) upset.arm();
    machine.upload_part(kSlot, base, bench.table, half, bench.table.size());
    CHECK(upset.has_been());
    CHECK(machine.upload_error() == 0);
    machine.select(kSlot);
    bench.send_scene();
    CHECK(machine.receive().fault_names().contains("internal") == disturbed);
  }
}

TEMPLATE_TEST_CASE("words that an upset sends into a table in use are told by its frames", "[faults][every]",
                   FieldThesis, VgaThesis, HdThesis) {
  Bench<TestType> bench{{kWidth, kHeight, kLookahead, false, kTimeout}};
  auto& machine = bench.machine;
  constexpr unsigned kInUse = 8;
  unsigned bit = 0;
  while (1U << bit < bench.table.size()) ++bit;
  machine.upload(kInUse, 1U << bit, bench.table);
  machine.select(kInUse);
  bench.until_safe();
  const auto other = plane_table(kWidth, kHeight, kShift + 4);
  const std::size_t half = other.size() / 2, end = other.size() - 2;
  bench.begin_anew = false;
  bench.raise("internal", [&] {
    machine.upload_part(GENERATE(0U, 7U, 9U), 0, other, 0, half);
    find<TestType>(machine.model(), "u_map_store.write_addr_q").flip(bit);
    TestType::settle(machine.model());
    machine.upload_part(0, 0, other, half, end);
    bench.send_scene();
  });
  CHECK((machine.read(reg::map_valid::kAddress) & 1U << kInUse) != 0);
}

TEMPLATE_TEST_CASE("an upset of a table's header before it counts is a wrong upload", "[faults][every]", FieldThesis,
                   VgaThesis, HdThesis) {
  Bench<TestType> bench{{kWidth, kHeight, kLookahead, false, kTimeout}};
  auto& machine = bench.machine;
  constexpr unsigned kSlot = 9, kWrongCrc = 4;
  for (const char* name :
       {"base_q", "nx_q", "ny_q", "spans_q", "columns_q", "width_q", "height_q", "areas_q", "slot_q"}) {
    CAPTURE(TestType::kProfile, name);
    const std::size_t last = bench.table.size() - 1;
    machine.upload_part(kSlot, static_cast<unsigned>(bench.table.size()), bench.table, 0, last);
    machine.settle(20);
    find<TestType>(machine.model(), std::string{"u_map_store."} + name).flip(0);
    TestType::settle(machine.model());
    machine.upload_part(kSlot, 0, bench.table, last, bench.table.size());
    CHECK(machine.upload_error() == kWrongCrc);
    CHECK(machine.read(reg::map_valid::kAddress) == 1);
  }
}

TEMPLATE_TEST_CASE("an upset of where an image begins in its ring, before it is read, is told by its frame",
                   "[faults][every]", FieldThesis, VgaThesis, HdThesis) {
  Bench<TestType> bench{{kWidth, kHeight, kLookahead, false, kTimeout}};
  auto& machine = bench.machine;
  for (const char* name : {"left_base_q", "left_base_slot_q", "base_q", "base_slot_q"}) {
    CAPTURE(name);
    bench.raise("internal", [&] {
      const FramePair pair = bench.scene();
      machine.left().send(pair.left);  // opens the frame, which cannot be read yet
      machine.settle(300);
      const auto record = find<TestType>(machine.model(), std::string{"u_pairing."} + name);
      record.flip(find<TestType>(machine.model(), "u_pairing.slot_q").get(0) ? record.bits : 0);
      TestType::settle(machine.model());
      machine.right().send(pair.right);
    });
  }
}

TEMPLATE_TEST_CASE("an upset does not make a table valid whose upload was broken off", "[faults][every]", FieldThesis,
                   VgaThesis, HdThesis) {
  Bench<TestType> bench{{kWidth, kHeight, kLookahead, false, kTimeout}};
  auto& machine = bench.machine;
  constexpr unsigned kSlot = 5;
  const auto base = static_cast<unsigned>(bench.table.size());
  machine.upload(kSlot, base, bench.table);
  CHECK(machine.upload_error() == 0);
  const auto other = plane_table(kWidth, kHeight, kShift + 4);
  machine.upload_part(kSlot, base, other, 0, other.size() - 2);
  find<TestType>(machine.model(), "u_map_store.valid_q").flip(kSlot);
  TestType::settle(machine.model());
  CHECK(machine.read(reg::map_valid::kAddress) == (1U << 0 | 1U << kSlot));
  bench.raise("no_table", [&] {
    machine.select(kSlot);
    bench.send_scene();
  });
}

/// Both images in one stream.
template <class Model>
class TestSource final : public Endpoint {
 public:
  explicit TestSource(Model& model) : model_{model} {}
  void send(const FramePair& pair) {
    pair_ = pair;
    next_ = 0;
  }
  bool done() const { return next_ == pair_.left.pixels.size(); }
  void drive() override {
    model_.s_axis_test_tvalid = done() ? 0 : 1;
    if (done()) return;
    model_.s_axis_test_tdata = static_cast<std::uint16_t>(pair_.right.pixels[next_] << 8 | pair_.left.pixels[next_]);
    model_.s_axis_test_tuser = next_ == 0 ? 1 : 0;
    model_.s_axis_test_tlast = next_ % pair_.left.width == pair_.left.width - 1 ? 1 : 0;
  }
  void sample() override {
    if (!done() && model_.s_axis_test_tready) ++next_;
  }

 private:
  Model& model_;
  FramePair pair_;
  std::size_t next_ = 0;
};

TEMPLATE_TEST_CASE("the test input: a frame as of the cameras, which are not looked at, and never safe",
                   "[faults][every]", FieldThesis, VgaThesis, VgaCompete, HdThesis, HdCompete) {
  Bench<TestType> bench{{kWidth, kHeight, kLookahead, false, kTimeout}};
  auto& machine = bench.machine;
  bench.until_safe();
  TestSource source{machine.model()};
  machine.simulation().attach(source);
  machine.write(reg::control::kAddress, 0);
  machine.write(reg::mode::kAddress, reg::mode::kTestInput.put(1));
  machine.write(reg::control::kAddress, reg::control::kEnable.put(1));
  bench.send_scene();  // nobody takes it
  const auto taken = machine.left().taken() + machine.right().taken();
  machine.safe_was_low();
  for (int frame = 0; frame < 3; ++frame) {
    CAPTURE(TestType::kProfile, TestType::kCompete, frame);
    const FramePair pair = bench.scene();
    source.send(pair);
    const Published p = machine.receive();
    machine.check_frame(p, pair, bench.table);  // of itself it would be safe
    CHECK_FALSE(p.safe_pin);
    CHECK(machine.model().safe_o == 0);
  }
  // A broken image comes to both.
  FramePair pair = bench.scene();
  pair.left.at(0, 0) = pair.right.at(0, 0);
  source.send({pair.left, pair.left});
  const Published p = machine.receive();
  CHECK(p.fault_names() == std::set<std::string>{"identical_images"});
  CHECK(machine.left().taken() + machine.right().taken() == taken);
  machine.write(reg::control::kAddress, 0);
  machine.write(reg::mode::kAddress, 0);
  bench.restart();
  bench.until_safe();
}

}  // namespace
}  // namespace horopter::tb
