// SPDX-License-Identifier: Apache-2.0
// How the stages follow each other: the lines of stage_list.def, and who takes what from whom. This is the only place
// that knows. The SystemVerilog chain is made of the same list by the same rule (scripts/generate-profiles).
//
// The rule: a stage takes its input from the nearest stage before it whose output has all fields of the input, by name.
// An output with a field `valid` is handed on only where that is set. Settings are taken by name, too.
//
// There are two drivers: Chain below, which passes beat by beat and is what the hardware does, and Strips (strips.hpp)
// of the native engine, which passes a row at a time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#define HOROPTER_STAGE_HEADERS
#include "stages/stage_list.def"
#undef HOROPTER_STAGE_HEADERS

namespace horopter::stages {

enum class Stage {
#define HOROPTER_STAGE(name, ...) name,
#include "stages/stage_list.def"
};

/// Where a stage stands: see stage_list.def.
enum class Place { beats, lanes, beside };

/// A line of stage_list.def. Of<P, V>: the class; V only where it stands in `lanes`.
template <Stage STAGE>
struct Line;
#define HOROPTER_CLASS_beats(Class) stages::Class<P>
#define HOROPTER_CLASS_lanes(Class) stages::Class<P, V>
#define HOROPTER_CLASS_beside(Class) stages::Class<P>
#define HOROPTER_STAGE(name, Class, needed_by, place_of) \
  template <>                                            \
  struct Line<Stage::name> {                             \
    static constexpr Rule rule = Rule::needed_by;        \
    static constexpr Place place = Place::place_of;      \
    template <Profile P, class V = Scalar>               \
    using Of = HOROPTER_CLASS_##place_of(Class);         \
  };
#include "stages/stage_list.def"
#undef HOROPTER_CLASS_beats
#undef HOROPTER_CLASS_lanes
#undef HOROPTER_CLASS_beside

template <Stage STAGE>
using At = std::integral_constant<Stage, STAGE>;

namespace chain {

struct Listed {
  Stage stage{};
  Rule rule{};
  Place place{};
};
inline constexpr auto list = std::to_array<Listed>({
#define HOROPTER_STAGE(name, Class, needed_by, place_of) {Stage::name, Rule::needed_by, Place::place_of},
#include "stages/stage_list.def"
});

constexpr Place place_of(Stage stage) { return list[static_cast<std::size_t>(stage)].place; }

/// The stages that a rule passes, FIRST and those after it.
template <Rule RULE, Stage FIRST = Stage::interpolate>
constexpr auto order() {
  constexpr auto stands = [](const Listed& line) {
    return line.stage >= FIRST && line.place != Place::beside && (line.rule == Rule::always || line.rule == RULE);
  };
  std::array<Stage, std::count_if(list.begin(), list.end(), stands)> stages{};
  std::size_t n = 0;
  for (const Listed& line : list) {
    if (stands(line)) stages[n++] = line.stage;
  }
  return stages;
}

// By name ------------------------------------------------------------------------------------------------------------

struct AnyValue {
  template <class T>
  operator T() const;  // NOLINT: never called
};

template <class T, class... Values>
constexpr std::size_t field_count() {
  if constexpr (requires { T{Values{}..., AnyValue{}}; }) {
    return field_count<T, Values..., AnyValue>();
  } else {
    return sizeof...(Values);
  }
}

/// How many fields of To there are in From, by name; an empty one needs no source.
template <class To, class From>
constexpr std::size_t common_fields() {
  std::size_t n = 0;
#define HOROPTER_FIELD(name)                                                               \
  if constexpr (requires(To to, From from) { to.name = from.name; }) {                     \
    ++n;                                                                                   \
  } else if constexpr (requires(To to) { requires std::is_empty_v<decltype(to.name)>; }) { \
    ++n;                                                                                   \
  }
#include "stages/stage_list.def"
  return n;
}

/// From has every field of To.
template <class To, class From>
inline constexpr bool feeds = std::is_same_v<To, From> || common_fields<To, From>() == field_count<To>();

/// A count or sum that is too large for a stage is the largest that it has, as in rtl/top/horopter_settings.sv. Fields with
/// a sign come as the bits of their registers.
template <class To, class From>
[[gnu::always_inline]] inline void take(To& to, const From& from) {
  if constexpr (std::is_same_v<From, int> && requires { To::max(); } && !requires { To::min(); }) {
    to = from > static_cast<std::int64_t>(To::max().value()) ? To::max() : To(from);
  } else {
    to = from;
  }
}

template <class To, class From>
[[gnu::always_inline]] inline To by_name(const From& from) {
  static_assert(feeds<To, From>, "a field is missing: in the source, or as HOROPTER_FIELD in stage_list.def");
  To to;
#define HOROPTER_FIELD(name) \
  if constexpr (requires { to.name = from.name; }) take(to.name, from.name);
#include "stages/stage_list.def"
  return to;
}

/// One lane of values in lanes. What is the same in all of them, the marks, stays as it is.
template <class To, class From>
[[gnu::always_inline]] inline void take_lane(To& to, const From& from, int lane) {
#define HOROPTER_FIELD(name) \
  if constexpr (requires { to.name = from.name.lane(lane); }) to.name = from.name.lane(lane);
#include "stages/stage_list.def"
}

// A step -------------------------------------------------------------------------------------------------------------

struct NoConfig {};
template <class StageClass>
struct ConfigOf {
  using type = NoConfig;
};
template <class StageClass>
  requires requires { typename StageClass::Config; }
struct ConfigOf<StageClass> {
  using type = typename StageClass::Config;
};

/// Settings of all stages of a tuple, by name.
template <class Configs, class Settings>
void configure(Configs& configs, const Settings& settings) {
  std::apply([&]<class... Config>(Config&... config) { ((config = by_name<Config>(settings)), ...); }, configs);
}

/// One step of a stage on what another put out. All of it is inlined (`flatten` reaches one call deep): what a stage
/// keeps stays in registers while a row passes.
template <class StageClass, class Given, class Config>
[[gnu::always_inline, gnu::flatten]] inline auto step(StageClass& stage, const Given& given, const Config& config) {
  using In = typename StageClass::In;
  if constexpr (!std::is_same_v<In, Given>) {
    return step(stage, by_name<In>(given), config);
  } else if constexpr (std::is_same_v<Config, NoConfig>) {
    return stage.step(given);
  } else {
    return stage.step(given, config);
  }
}

}  // namespace chain

/// The stages of one rule, FIRST and those after it: one call of step a beat, as in the hardware.
template <Profile P, Rule RULE, Stage FIRST = Stage::interpolate>
class Chain {
  static_assert(P.has(RULE), "the profile does not have this rule");
  static constexpr auto order = chain::order<RULE, FIRST>();
  using Indices = std::make_index_sequence<order.size()>;

 public:
  template <Stage STAGE>
  using Of = typename Line<STAGE>::template Of<P>;
  using In = typename Of<FIRST>::In;

  /// What the stages need of the settings; they must have width and height of the result in px, too.
  template <class Settings>
  void configure(const Settings& settings) {
    chain::configure(configs_, settings);
  }

  /// `see(At<stage>, out)` is called for every beat that a stage puts out, in order, and may change it.
  template <class See>
  [[gnu::always_inline]] void step(const In& in, See&& see) {
    walk<0>(Given{in}, see);
  }

 private:
  template <std::size_t... I>
  static std::tuple<Of<order[I]>...> tuple_of(std::index_sequence<I...>);
  template <std::size_t... I>
  static std::tuple<typename chain::ConfigOf<Of<order[I]>>::type...> configs_of(std::index_sequence<I...>);

  /// What the chain is given.
  struct Given {
    using Out = In;
    const In& out;
  };
  /// What a stage has put out, and what those before it have.
  template <class OUT, class Before>
  struct Beat {
    using Out = OUT;
    const OUT& out;
    const Before& before;
  };

  /// Of the nearest beat that has all of Needed.
  template <class Needed, class Last>
  [[gnu::always_inline]] static const auto& source(const Last& last) {
    if constexpr (chain::feeds<Needed, typename Last::Out>) {
      return last.out;
    } else {
      static_assert(requires { last.before; }, "no stage before this one puts out all that it takes");
      return source<Needed>(last.before);
    }
  }

  /// The same as a place in the order: n + 1 for stage n, 0 for what the chain is given.
  template <std::size_t I, std::size_t FROM = I>
  static constexpr std::size_t source_of() {
    if constexpr (FROM == 0) {
      return 0;
    } else if constexpr (chain::feeds<typename Of<order[I]>::In, typename Of<order[FROM - 1]>::Out>) {
      return FROM;
    } else {
      return source_of<I, FROM - 1>();
    }
  }
  /// Stages behind I that take from it, and those that take from one before it.
  template <std::size_t I, std::size_t... LATER>
  static constexpr std::size_t fed_by(std::index_sequence<LATER...>) {
    return (0 + ... + (LATER > I && source_of<LATER>() == I + 1 ? 1 : 0));
  }
  template <std::size_t I, std::size_t... LATER>
  static constexpr std::size_t passing(std::index_sequence<LATER...>) {
    return (0 + ... + (LATER > I && source_of<LATER>() <= I ? 1 : 0));
  }

  template <std::size_t I, class Before, class See>
  [[gnu::always_inline, gnu::flatten]] void walk(const Before& before, See& see) {
    if constexpr (I < order.size()) {
      using StageClass = Of<order[I]>;
      auto out = chain::step(std::get<I>(stages_), source<typename StageClass::In>(before), std::get<I>(configs_));
      bool there = true;
      if constexpr (requires { out.valid; }) there = out.valid;
      if constexpr (fed_by<I>(Indices{}) == 0) {
        if (there) see(At<order[I]>{}, out);
        walk<I + 1>(before, see);
      } else {
        static_assert(
            !requires { out.valid; } || passing<I>(Indices{}) == 0,
            "where a stage's output has `valid`, either all behind it take from it or none");
        if (!there) return;
        see(At<order[I]>{}, out);
        walk<I + 1>(Beat<typename StageClass::Out, Before>{out, before}, see);
      }
    }
  }

  decltype(tuple_of(Indices{})) stages_;
  decltype(configs_of(Indices{})) configs_;
};

}  // namespace horopter::stages
