// SPDX-License-Identifier: Apache-2.0
// horopter_top between two cameras, two sinks and a host, beside the native engine, which says what must come out.
#pragma once

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "horopter/base/crc32.hpp"
#include "horopter/hls/table_format.hpp"
#include "horopter/machine/faults.hpp"
#include "horopter/machine/registers.hpp"
#include "horopter/machine/setting_registers.hpp"
#include "horopter/tb/axil.hpp"
#include "horopter/tb/axis.hpp"
#include "horopter/tb/image.hpp"
#include "stages/engine.hpp"

namespace horopter::tb {

namespace reg = registers;

/// Upload words of a table for width × height, control points every 2^nx × 2^ny px; `source` gives the right pixel of a
/// left one, in px.
inline std::vector<std::uint32_t> make_table(unsigned width, unsigned height, unsigned nx, unsigned ny,
                                             const std::function<std::pair<double, double>(double, double)>& source) {
  auto words =
      hls::table::write({static_cast<int>(width), static_cast<int>(height), static_cast<int>(nx), static_cast<int>(ny)},
                        {}, [&](int column, int row) {
                          const auto [x, y] = source(column << nx, row << ny);
                          return hls::table::encode_control(x, y);
                        });
  words.back() = crc32_words(std::span(words).first(words.size() - 1));
  return words;
}

/// A plane seen by cameras side by side: shifted by (dx, dy) px, a little slanted.
inline std::vector<std::uint32_t> plane_table(unsigned width, unsigned height, double dx, double dy = 0,
                                              unsigned spacing_log2 = 4) {
  return make_table(width, height, spacing_log2, spacing_log2, [=](double x, double y) {
    return std::pair{x + dx + 0.004 * (x - width / 2.0) + 0.002 * y, y + dy + 0.003 * x - 0.002 * y};
  });
}

/// The same, but the left and the lower part of the grid only show what is around the skin.
inline std::vector<std::uint32_t> with_surroundings(std::vector<std::uint32_t> words) {
  const hls::table::Header header = hls::table::read(words);
  for (int row = 0; row < 2 * header.geometry.row_pairs(); ++row) {
    for (int column = 0; column < header.geometry.columns(); ++column) {
      if (4 * column > header.geometry.columns() && 3 * row < 4 * header.geometry.row_pairs()) continue;
      std::uint32_t& word = words[header.first_control + header.geometry.control_index(column, row)];
      word = hls::table::around_skin_instead(word);
    }
  }
  words.back() = crc32_words(std::span(words).first(words.size() - 1));
  return words;
}

/// The same with spans: an ellipse that the image cuts, with a rough outline; some rows have no pixel, one, or all.
inline std::vector<std::uint32_t> with_spans(const std::vector<std::uint32_t>& words, Rng& rng) {
  hls::table::Header header = hls::table::read(words);
  const int width = header.geometry.width;
  const int height = header.geometry.height;
  std::vector<hls::table::Span> spans;
  for (int y = 0; y < height; ++y) {
    const double v = (y - 0.45 * height) / (0.5 * height);
    const auto rough = [&] { return static_cast<int>(rng.below(3)); };
    const auto reach = static_cast<int>(0.6 * width * std::sqrt(std::max(0.0, 1 - v * v)));
    hls::table::Span span{std::max(0, width / 2 - reach - rough()), std::min(width, width / 2 + reach + rough())};
    if (reach == 0 || y % 61 == 60) span = {};
    if (y % 61 == 59) span = {y % width, y % width + 1};
    if (y % 61 == 0) span = {0, width};
    spans.push_back(span);
  }
  hls::table::Geometry geometry = header.geometry;
  geometry.spans = true;
  auto with = hls::table::write(
      geometry, header.facts,
      [&](int column, int row) { return words[header.first_control + header.geometry.control_index(column, row)]; },
      spans);
  with.back() = crc32_words(std::span(with).first(with.size() - 1));
  return with;
}

/// The same with areas, codes of a part of the range: small ones, or all of it.
inline std::vector<std::uint32_t> with_areas(const std::vector<std::uint32_t>& words, const hls::Profile& profile,
                                             Rng& rng) {
  const hls::table::Header header = hls::table::read(words);
  hls::table::Facts facts = header.facts;
  facts.subsample = profile.subsample;
  facts.areas.resize(facts.area_count(header.geometry));
  const bool all = rng.chance(3);
  for (std::uint8_t& code : facts.areas) code = static_cast<std::uint8_t>(all ? rng.below(256) : 60 + rng.below(40));
  std::vector<hls::table::Span> spans;
  for (int y = 0; header.geometry.spans && y < header.geometry.height; ++y) {
    spans.push_back(hls::table::Span::of(words[header.first_span + static_cast<std::size_t>(y)]));
  }
  auto with = hls::table::write(
      header.geometry, facts,
      [&](int column, int row) { return words[header.first_control + header.geometry.control_index(column, row)]; },
      spans);
  with.back() = crc32_words(std::span(with).first(with.size() - 1));
  return with;
}

struct FramePair {
  Image left, right;
};

/// A scene of which some lies on the skin of plane_table(…, dx, …), some elsewhere, and some has no texture.
inline FramePair random_pair(unsigned width, unsigned height, int dx, Rng& rng) {
  FramePair pair{textured_image(width, height, rng), textured_image(width, height, rng)};
  const unsigned block = 32;
  for (unsigned by = 0; by < height; by += block) {
    for (unsigned bx = 0; bx < width; bx += block) {
      const auto kind = rng.below(4);
      const auto grey = static_cast<std::uint8_t>(40 + rng.below(160));
      for (unsigned y = by; y < by + block && y < height; ++y) {
        for (unsigned x = bx; x < bx + block && x < width; ++x) {
          const int source = static_cast<int>(x) + dx;
          if (kind == 0) {
            pair.left.at(x, y) = static_cast<std::uint8_t>(grey + rng.below(3));
          } else if (kind < 3 && source >= 0 && source < static_cast<int>(width)) {
            pair.left.at(x, y) = pair.right.at(static_cast<unsigned>(source), y);
          }
        }
      }
    }
  }
  return pair;
}

/// What left the machine for one frame.
struct Published {
  std::vector<std::uint8_t> states;
  std::vector<native::Run> runs;
  std::uint32_t sequence = 0, status = 0, table_crc = 0, skin = 0, undecidable = 0, unsupervised = 0;
  std::array<std::uint32_t, 4> object{};  ///< FRAME_OBJECT, the two registers after it, and FRAME_OBJECT_AREA
  std::uint32_t blind = 0;
  std::vector<native::Object> objects;  ///< of m_axis_objects
  std::uint32_t objects_found = 0, objects_lost = 0;
  std::uint32_t latency = 0, tail = 0;
  Faults faults;
  bool safe_pin = false;
  bool after_good = false;  ///< the frame before it was good, too

  bool safe() const { return reg::frame_status::kSafe.get(status) != 0; }
  bool alarm() const { return reg::frame_status::kAlarm.get(status) != 0; }
  unsigned slot() const { return reg::frame_status::kSlot.get(status); }
  std::set<std::string> fault_names() const {
    const auto names = faults.names();
    return {names.begin(), names.end()};
  }
};

/// A beat of m_axis_objects, from the lowest bit.
using ObjectBits = std::array<std::uint32_t, 7>;

inline std::uint32_t bits_of(const ObjectBits& bits, unsigned lowest, unsigned count) {
  const unsigned word = lowest / 32;
  const std::uint64_t two = bits[word] | std::uint64_t{word + 1 < bits.size() ? bits[word + 1] : 0} << 32;
  return static_cast<std::uint32_t>(two >> lowest % 32 & ((std::uint64_t{1} << count) - 1));
}
inline native::Object object_of(const ObjectBits& bits) {
  const auto number = [&](unsigned lowest, unsigned count) { return static_cast<int>(bits_of(bits, lowest, count)); };
  return {number(0, 24),  number(24, 24),  bits_of(bits, 48, 32),  number(80, 16),        number(112, 16),
          number(96, 16), number(128, 16), bits_of(bits, 144, 32), bits_of(bits, 176, 32)};
}

struct MachineOptions {
  unsigned width = 128, height = 48, lookahead = 16;
  bool live = false;
  std::uint32_t timeout_clocks = 0;  ///< 0: as by reset
  unsigned gaps_percent = 0;         ///< of the cameras' clocks
  unsigned stalls_percent = 0;       ///< of the sinks' clocks
  std::uint32_t interlock = reg::interlock::kByItself.put(1) | reg::interlock::kByPin.put(1);
};

template <class Model>
class Machine : public Endpoint {
 public:
  Machine(std::string_view profile, const MachineOptions& options)
      : options_{options},
        simulation_{session_seed()},
        left_{HOROPTER_TB_AXIS(simulation_.model(), s_axis_left), pace(options.gaps_percent, 1)},
        right_{HOROPTER_TB_AXIS(simulation_.model(), s_axis_right), pace(options.gaps_percent, 2)},
        states_{"m_axis_state", HOROPTER_TB_AXIS(simulation_.model(), m_axis_state), pace(options.stalls_percent, 3)},
        runs_{"m_axis_runs",
              {&model().m_axis_runs_tvalid, &model().m_axis_runs_tready, &model().m_axis_runs_tdata, nullptr,
               &model().m_axis_runs_tlast},
              pace(options.stalls_percent, 4)},
        objects_{"m_axis_objects",
                 {&model().m_axis_objects_tvalid, &model().m_axis_objects_tready,
                  reinterpret_cast<ObjectBits*>(model().m_axis_objects_tdata.m_storage), nullptr,
                  &model().m_axis_objects_tlast},
                 pace(options.stalls_percent, 5)},
        host_{HOROPTER_TB_AXIL(simulation_.model(), s_axil), session_seed(), 20},
        engine_{native::make_engine(profile)},
        settings_{native::Settings::defaults(engine_->profile(), static_cast<int>(options.width),
                                             static_cast<int>(options.height))
                      .without_proof()} {
    settings_.lookahead = static_cast<int>(options.lookahead);
    settings_.object_limit = static_cast<int>(options.width * options.height) + 1;  // none is an alarm
    for (Endpoint* endpoint :
         {static_cast<Endpoint*>(&left_), static_cast<Endpoint*>(&right_), static_cast<Endpoint*>(&states_),
          static_cast<Endpoint*>(&runs_), static_cast<Endpoint*>(&objects_), static_cast<Endpoint*>(&host_),
          static_cast<Endpoint*>(this)}) {
      simulation_.attach(*endpoint);
    }
    model().s_axis_test_tvalid = 0;
    model().restart_i = model().feedback_i = 0;
    model().s_axil_awprot = model().s_axil_arprot = 0;
    left_.set_live(options.live);
    right_.set_live(options.live);
    simulation_.reset();
    configure();
  }

  Model& model() { return simulation_.model(); }
  auto& simulation() { return simulation_; }
  VideoSource& left() { return left_; }
  VideoSource& right() { return right_; }
  auto& states() { return states_; }
  auto& runs() { return runs_; }
  auto& objects() { return objects_; }
  native::Settings& settings() { return settings_; }
  std::uint32_t alarm_frames = reg::alarm_frames::kReset;  ///< for configure()
  const hls::Profile& profile() const { return engine_->profile(); }
  const MachineOptions& options() const { return options_; }

  /// Registers from settings() and the geometry; enables the machine.
  void configure() {
    write(reg::control::kAddress, 0);
    dim_before_ = false;
    spoiled_before_ = 0;
    compete_before_ = 0;
    write(reg::mode::kAddress, options_.live ? reg::mode::kLive.put(1) : 0);
    write(reg::interlock::kAddress, options_.interlock);
    write(reg::alarm_frames::kAddress, alarm_frames);
    write(reg::width::kAddress, options_.width);
    write(reg::height::kAddress, options_.height);
    write(reg::lookahead::kAddress, options_.lookahead);
    if (options_.timeout_clocks != 0) write(reg::timeout::kAddress, options_.timeout_clocks);
    write_settings(settings_, [&](std::uint32_t address, std::uint32_t word) { write(address, word); });
    write(reg::control::kAddress, reg::control::kEnable.put(1));
    REQUIRE(reg::status::kBadGeometry.get(read(reg::status::kAddress)) == 0);
  }
  void write_limits() {
    write_settings(settings_, [&](std::uint32_t address, std::uint32_t word) {
      if (address != reg::agreement::kAddress) write(address, word);  // that is locked
    });
  }

  void write(std::uint32_t address, std::uint32_t value) {
    if (address == reg::control::kAddress) last_good_ = false;
    INFO("write to " << std::hex << address);
    REQUIRE(try_write(address, value));
  }
  /// Whether the bus says that it is done.
  bool try_write(std::uint32_t address, std::uint32_t value) {
    host_.post({true, address, value});
    finish_access();
    return host_.answer().response == 0;
  }
  std::uint32_t read(std::uint32_t address) {
    host_.post({false, address});
    finish_access();
    INFO("read of " << std::hex << address);
    REQUIRE(host_.answer().response == 0);
    return host_.answer().data;
  }

  /// Words [begin, end) of an upload, the first of which starts it.
  void upload_part(unsigned slot, unsigned base_word64, const std::vector<std::uint32_t>& words, std::size_t begin,
                   std::size_t end) {
    if (begin == 0) {
      write(reg::map_slot::kAddress, slot);
      write(reg::map_base::kAddress, base_word64);
      write(reg::map_control::kAddress, reg::map_control::kStart.put(1));
    }
    for (std::size_t i = begin; i < end; ++i) write(reg::map_data::kAddress, words[i]);
  }
  void upload(unsigned slot, unsigned base_word64, const std::vector<std::uint32_t>& words) {
    upload_part(slot, base_word64, words, 0, words.size());
  }
  /// Of the upload that has been sent: a word is judged some clocks after it was taken.
  std::uint32_t upload_error() {
    std::uint32_t status = read(reg::map_status::kAddress);
    for (int poll = 0; poll < 4 && reg::map_status::kBusy.get(status) != 0; ++poll) {
      status = read(reg::map_status::kAddress);
    }
    return reg::map_status::kError.get(status);
  }
  void select(unsigned slot) { write(reg::table_select::kAddress, slot); }

  void send(const FramePair& pair, Damage left_damage = {}, Damage right_damage = {}) {
    left_.send(pair.left, left_damage);
    right_.send(pair.right, right_damage);
  }

  unsigned frames_done() const { return frames_done_; }

  /// The next frame that the machine finishes. A frame that is never finished fails.
  Published receive(std::uint64_t patience_frames = 8) {
    const std::uint64_t clocks =
        patience_frames * (std::uint64_t{options_.width + 64} * (options_.height + 64) + options_.timeout_clocks) * 4;
    simulation_.run_until([&] { return frames_done_ > frames_taken_; }, clocks, "a finished frame");
    ++frames_taken_;
    Published p;
    p.safe_pin = model().safe_o != 0;
    CHECK(model().safe_o != model().unsafe_o);
    p.sequence = read(reg::frame_sequence::kAddress);
    p.status = read(reg::frame_status::kAddress);
    p.faults = {read(reg::frame_faults_cameras::kAddress), read(reg::frame_faults_machine::kAddress)};
    p.table_crc = read(reg::frame_table_crc::kAddress);
    p.skin = read(reg::frame_skin::kAddress);
    p.undecidable = read(reg::frame_undecidable::kAddress);
    p.unsupervised = read(reg::frame_unsupervised::kAddress);
    p.object = {read(reg::frame_object::kAddress), read(reg::frame_object_columns::kAddress),
                read(reg::frame_object_rows::kAddress), read(reg::frame_object_area::kAddress)};
    p.blind = read(reg::frame_blind::kAddress);
    p.latency = read(reg::frame_latency::kAddress);
    p.tail = read(reg::frame_tail::kAddress);
    take_frame(p);
    p.after_good = std::exchange(last_good_, p.safe());
    return p;
  }

  /// What has come out is not looked at.
  void forget() {
    frames_taken_ = frames_done_;
    states_.take();
    runs_.take();
    objects_.take();
  }

  /// Nothing more comes by itself.
  void settle(std::uint64_t clocks = 20'000) { simulation_.run(clocks); }

  native::FrameResult expected(const FramePair& pair, const std::vector<std::uint32_t>& table) {
    const auto view = [](const Image& image) {
      return native::ImageView{image.pixels.data(), static_cast<int>(image.width), static_cast<int>(image.height),
                               static_cast<std::ptrdiff_t>(image.width)};
    };
    return engine_->process(view(pair.left), view(pair.right), native::TableView(table), frame_settings());
  }
  /// Every second frame that teaches is dim, if `dim` is set.
  native::Settings frame_settings() const {
    native::Settings settings = settings_;
    settings.dim = settings_.dim != 0 && settings_.teach != 0 && !dim_before_ ? 1 : 0;
    settings.forget = settings_.forget != 0 || settings_.compete != compete_before_ ? 1 : 0;
    if (settings.dim != 0)
      settings.undecidable_limit = static_cast<int>(options_.width * options_.height) / profile().subsample;
    return settings;
  }

  static std::array<std::uint32_t, 4> object_words(const native::Object& object) {
    const auto pair = [](int low, int high) {
      return static_cast<std::uint32_t>(low) | static_cast<std::uint32_t>(high) << 16;
    };
    return {static_cast<std::uint32_t>(object.pixels), pair(object.left, object.right), pair(object.top, object.bottom),
            object.area};
  }

  /// States, runs, counts, table, the largest object and alarm of a frame without faults are those of the native engine. It is safe, and the
  /// pins say so if the frame before it was good and nothing was wrong in between.
  void check(const Published& p, const FramePair& pair, const std::vector<std::uint32_t>& table) {
    check_frame(p, pair, table);
    CHECK(p.safe_pin == (p.safe() && p.after_good));
  }
  void check_frame(const Published& p, const FramePair& pair, const std::vector<std::uint32_t>& table) {
    const native::FrameResult e = expected(pair, table);
    dim_before_ = frame_settings().dim != 0;
    compete_before_ = settings_.compete;
    const bool spoiled = e.alarm || e.object_overflow;
    settings_.forget = settings_.teach != 0 && (spoiled || spoiled_before_ != 0) ? 1 : 0;
    spoiled_before_ = (spoiled_before_ << 1U | static_cast<unsigned>(spoiled)) & 3U;
    std::set<std::string> faults;
    if (e.object_overflow) faults.insert("objects");
    if (settings_.teach != 0) faults.insert("teaching");
    CHECK(p.fault_names() == faults);
    CHECK(p.blind == static_cast<std::uint32_t>(e.blind_pixels));
    CHECK(p.objects.size() + p.objects_lost == p.objects_found);
    if (!e.object_overflow) {
      CHECK(p.objects_found == e.objects.size());
      if (p.objects_lost == 0) CHECK(p.objects == e.objects);
    }
    if (!e.object_overflow) CHECK(p.object == object_words(e.largest_object()));
    REQUIRE(p.states.size() == e.states.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < e.states.size(); ++i) different += p.states[i] != e.states[i] ? 1 : 0;
    CHECK(different == 0);
    CHECK(p.runs == e.runs);
    CHECK(p.skin == static_cast<std::uint32_t>(e.skin_pixels));
    CHECK(p.undecidable == static_cast<std::uint32_t>(e.undecidable_pixels));
    CHECK(p.unsupervised == static_cast<std::uint32_t>(e.unsupervised_pixels));
    CHECK(p.alarm() == e.alarm);
    CHECK(p.table_crc == table.back());
    CHECK(p.safe() == (!e.alarm && faults.empty()));
    CHECK((reg::status::kTaught.get(read(reg::status::kAddress)) != 0) == e.taught);
  }

  /// What safe_o switches: they drop and pull in within so many clocks, or stay as they are.
  enum class Contactors { follow, stay_dropped, stay_pulled };
  void set_contactors(Contactors contactors, unsigned clocks) {
    contactors_ = contactors;
    contactor_clocks_ = clocks;
  }

  void drive() override {
    const bool wanted = contactors_ == Contactors::follow ? !model().safe_o : contactors_ == Contactors::stay_dropped;
    if (wanted == (model().feedback_i != 0)) {
      contactor_wait_ = contactor_clocks_;
    } else if (contactor_wait_ == 0) {
      model().feedback_i = wanted ? 1 : 0;
    } else {
      --contactor_wait_;
    }
  }
  void sample() override {
    if (model().frame_done_o) ++frames_done_;
    if (!model().safe_o) safe_was_low_ = true;
    both_equal_ |= model().safe_o == model().unsafe_o;
  }
  /// Whether safe_o was low since the last call.
  bool safe_was_low() { return std::exchange(safe_was_low_, false); }
  bool pins_ever_equal() const { return both_equal_; }

 private:
  Contactors contactors_ = Contactors::follow;
  unsigned contactor_clocks_ = 0, contactor_wait_ = 0;

  static Pace pace(unsigned pauses_percent, std::uint64_t purpose) {
    return pauses_percent == 0 ? Pace{} : Pace::random(100 - pauses_percent, session_seed() * 8 + purpose);
  }
  void finish_access() {
    simulation_.run_until([&] { return host_.idle(); }, 1000, "an answer on AXI4-Lite");
  }
  /// Cuts the first frame off what the sinks hold.
  void take_frame(Published& p) {
    auto& states = states_.beats();
    const unsigned width = options_.width / static_cast<unsigned>(engine_->profile().subsample);
    const std::size_t pixels = std::size_t{width} * options_.height;
    REQUIRE(states.size() >= pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
      if (states[i].user != (i == 0) || states[i].last != (i % width == width - 1)) {
        FAIL("marks of m_axis_state at pixel " << i);
      }
      p.states.push_back(states[i].data);
    }
    states.erase(states.begin(), states.begin() + static_cast<std::ptrdiff_t>(pixels));
    auto& runs = runs_.beats();
    std::size_t used = 0;
    for (bool last = false; !last; ++used) {
      REQUIRE(used < runs.size());
      const std::uint64_t data = runs[used].data;
      p.runs.push_back({static_cast<std::uint16_t>(data >> 32), static_cast<std::uint16_t>(data >> 16),
                        static_cast<std::uint16_t>(data), static_cast<std::uint8_t>(data >> 62)});
      last = runs[used].last;
    }
    runs.erase(runs.begin(), runs.begin() + static_cast<std::ptrdiff_t>(used));
    take_objects(p);
  }
  /// Up to the last beat of the frame: it may come some clocks after the registers have changed.
  void take_objects(Published& p) {
    auto& objects = objects_.beats();
    const auto is_last = [](const auto& beat) { return beat.last; };
    simulation_.run_until([&] { return std::ranges::any_of(objects, is_last); }, 10'000,
                          "the last beat of m_axis_objects");
    const auto last = std::ranges::find_if(objects, is_last);
    for (auto beat = objects.begin(); beat != last; ++beat) p.objects.push_back(object_of(beat->data));
    p.objects_found = bits_of(last->data, 0, 24);
    p.objects_lost = bits_of(last->data, 24, 24);
    CHECK(bits_of(last->data, 48, 32) == p.sequence);
    for (unsigned bit = 80; bit < 208; bit += 32) CHECK(bits_of(last->data, bit, 32) == 0);
    objects.erase(objects.begin(), last + 1);
  }

  MachineOptions options_;
  Simulation<Model> simulation_;
  VideoSource left_, right_;
  StreamSink<std::uint8_t> states_;
  StreamSink<std::uint64_t> runs_;
  StreamSink<ObjectBits> objects_;
  AxilMaster<std::uint16_t> host_;
  std::unique_ptr<native::Engine> engine_;
  native::Settings settings_;
  bool dim_before_ = false;
  unsigned spoiled_before_ = 0;
  int compete_before_ = 0;
  unsigned frames_done_ = 0, frames_taken_ = 0;
  bool last_good_ = false, safe_was_low_ = false, both_equal_ = false;
};

}  // namespace horopter::tb
